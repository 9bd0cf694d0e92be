/* Saving what was not changed. */
#include <stddef.h>

#include "io/preset.h"

enum thud_status thud_preset_text(const struct thud_preset *preset, const struct thud_scene *scene, char **text,
                                  unsigned long *size, struct thud_error *err)
{
    (void)preset, (void)scene;
    *text = NULL;
    *size = 0;
    return thud_error_set(err, THUD_OUTPUT, "saving is not there yet");
}

enum thud_status thud_preset_save(const struct thud_preset *preset, const struct thud_scene *scene, const char *path,
                                  struct thud_error *err)
{
    (void)preset, (void)scene, (void)path;
    return thud_error_set(err, THUD_OUTPUT, "saving is not there yet");
}
