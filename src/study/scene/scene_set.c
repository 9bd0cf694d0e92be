/* Values of a scene by their paths: those of its own tables (scene_value.c) and of its study (scene_study.c). */
#include <stdlib.h>

#include "study/scene/scene_slot.h"

static enum thud_status set_study(struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                                  struct thud_error *err)
{
    char *clean = NULL;
    enum thud_status status = thud_value_trimmed(text, &clean, err);
    if (status == THUD_OK)
        status = thud_study_set(scene, slot, clean, err);
    free(clean);
    return status;
}

enum thud_status thud_scene_set(struct thud_scene *scene, const char *path, const char *text, struct thud_error *err)
{
    struct thud_slot slot;
    enum thud_status status = thud_slot_find(scene, path, &slot, err);
    if (status != THUD_OK)
        return status;
    status = slot.place.store == THUD_STORE_STUDY ? set_study(scene, &slot, text, err)
                                                  : thud_value_set(scene, &slot, text, err);
    if (status != THUD_OK)
        thud_error_key(err, "%s", path);
    return status;
}

enum thud_status thud_scene_get_in(const struct thud_scene *scene, const char *path, const char *unit, char *text,
                                   unsigned long size, struct thud_error *err)
{
    struct thud_slot slot;
    if (size > 0)
        text[0] = '\0';
    enum thud_status status = thud_slot_find(scene, path, &slot, err);
    if (status != THUD_OK)
        return status;
    if (slot.place.store == THUD_STORE_STUDY)
        thud_study_get(scene, &slot, text, size);
    else
        thud_value_get(scene, &slot, unit, text, size);
    return THUD_OK;
}

enum thud_status thud_scene_get(const struct thud_scene *scene, const char *path, char *text, unsigned long size,
                                struct thud_error *err)
{
    return thud_scene_get_in(scene, path, NULL, text, size, err);
}
