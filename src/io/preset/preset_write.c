#include <stdlib.h>

#include "io/building/building_file.h"
#include "io/file/file.h"
#include "io/preset/preset_private.h"

enum thud_status thud_preset_save(const struct thud_preset *preset, const struct thud_scene *scene, const char *path,
                                  struct thud_error *err)
{
    char *text;
    unsigned long size;
    struct thud_scene *moved = malloc(sizeof *moved);
    if (!moved)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    *moved = *scene;
    thud_building_files_move(moved, preset->name, path);
    enum thud_status status = thud_preset_text(preset, moved, &text, &size, err);
    free(moved);
    if (status != THUD_OK)
        return status;
    status = thud_file_write(path, text, size, err);
    free(text);
    return status;
}
