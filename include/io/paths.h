/* Where presets and records are found: the checkout beside the program when run from it, else the install prefix. */
#ifndef THUD_IO_PATHS_H
#define THUD_IO_PATHS_H

#include "base/status.h"

/* `argv0_dir` is the folder of the running program (found by the caller). */
struct thud_paths {
    char presets[512];
    char records[512];
};
void thud_paths_find(struct thud_paths *paths);

/* A name (`towers`) or a path to an existing file. Errors: THUD_INPUT naming the nearest preset. */
enum thud_status thud_paths_preset(const struct thud_paths *paths, const char *name, char *path, unsigned long size,
                                   struct thud_error *err);
/* A record's path: as given (from the working folder), beside the preset, or in the records folder, in this order. */
enum thud_status thud_paths_record(const struct thud_paths *paths, const char *preset_path, const char *name, char *path,
                                   unsigned long size, struct thud_error *err);

#endif
