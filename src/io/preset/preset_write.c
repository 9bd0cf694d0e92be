#include <stdlib.h>

#include "io/file/file.h"
#include "io/preset/preset.h"

enum thud_status thud_preset_save(const struct thud_preset *preset, const struct thud_scene *scene, const char *path,
                                  struct thud_error *err)
{
    char *text;
    unsigned long size;
    enum thud_status status = thud_preset_text(preset, scene, &text, &size, err);
    if (status != THUD_OK)
        return status;
    status = thud_file_write(path, text, size, err);
    free(text);
    return status;
}
