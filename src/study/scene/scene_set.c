/* Values of a scene by their paths: those of its own tables (scene_value.c) and of its study (scene_study.c). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "base/text.h"

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

/* Whether a number, or one of a list, is long. */
static bool is_long(const char *text)
{
    for (const char *c = text + (*text == '['); c; c = strchr(c, ',') ? strchr(c, ',') + 2 : NULL)
        if (thud_quantity_is_long(c))
            return true;
    return false;
}

/* A list of floors, each of its items in a unit of its own; false: not of floors. */
static bool get_items(const struct thud_scene *scene, const char *path, const char *unit, char *text,
                      unsigned long size)
{
    char item[160], value[96];
    int n = 0;
    for (;; n++) {
        snprintf(item, sizeof item, "%s.%d", path, n + 1);
        if (thud_scene_get_short(scene, item, unit, value, sizeof value, NULL) != THUD_OK)
            break;
        *text = n > 0 ? *text : '\0';
        thud_append(text, size, "%s%s", n > 0 ? ", " : "[", value);
    }
    if (n > 0)
        thud_append(text, size, "]");
    return n > 0;
}

enum thud_status thud_scene_get_short(const struct thud_scene *scene, const char *path, const char *unit, char *text,
                                      unsigned long size, struct thud_error *err)
{
    struct thud_slot slot;
    char other[32];
    enum thud_status status = thud_scene_get_in(scene, path, unit, text, size, err);
    if (status != THUD_OK || !is_long(text) || thud_slot_find(scene, path, &slot, err) != THUD_OK ||
        slot.place.store == THUD_STORE_STUDY || !slot.param->unit || !strcmp(slot.param->unit, "%"))
        return status;
    if (*text == '[' && get_items(scene, path, unit, text, size))
        return THUD_OK;
    const enum thud_dimension own = slot.param->dimension;
    const char *list = thud_dimension_units(own == THUD_POWER_STIFFNESS ? THUD_STIFFNESS : own);
    for (size_t n; *list; list += n + strspn(list + n, ", ")) {
        n = strcspn(list, ",");
        snprintf(other, sizeof other, "%.*s", (int)n, list);
        thud_value_get(scene, &slot, other, text, size);
        if (!is_long(text))
            return THUD_OK;
    }
    return thud_scene_get_in(scene, path, unit, text, size, err);
}
