/* Finds presets and records: in the checkout beside the program when run from it, else in the install prefix. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

/* Finds the folders; `argv0_dir` is the folder of the running program (found by the caller). */
struct thud_paths {
    char presets[512];
    char records[512];
};
void thud_paths_find(struct thud_paths *paths);

/* Names of the files in a folder, sorted. */
enum { THUD_FILES_MAX = 256, THUD_FILE_NAME_MAX = 64 };
struct thud_file_names {
    char text[THUD_FILES_MAX][THUD_FILE_NAME_MAX];
    const char *list[THUD_FILES_MAX];
    int n;
};
/* Lists every preset of the presets folder by its name, without `.yaml`. */
void thud_paths_presets(const struct thud_paths *paths, struct thud_file_names *names);

/* Finds a preset by name (`towers`; `mine` for mine.yaml of the working folder) or path. Errors: THUD_INPUT naming the
 * nearest preset. */
enum thud_status thud_paths_preset(const struct thud_paths *paths, const char *name, char *path, unsigned long size,
                                   struct thud_error *err);
/* Finds a record: as given (from the working folder), beside the preset, or in the records folder, in this order.
 * Errors: THUD_INPUT naming the nearest record. */
enum thud_status thud_paths_record(const struct thud_paths *paths, const char *preset_path, const char *name,
                                   char *path, unsigned long size, struct thud_error *err);

/* Finds a file named by a preset: as given (from the working folder), beside the preset (NULL: none), or in the presets
 * folder. Errors: THUD_INPUT. */
enum thud_status thud_paths_beside(const char *preset_path, const char *name, char *path, unsigned long size,
                                   struct thud_error *err);

/* Lists the files in a folder that may be ground motions, sorted: not hidden, neither prose (.md) nor a list (.list).
 * `others` (NULL: not asked): how many entries that are not hidden are left out. Errors: THUD_INPUT (no such folder),
 * THUD_MEMORY. */
enum thud_status thud_folder_names(const char *folder, char ***names, size_t *count, size_t *others,
                                   struct thud_error *err);
void thud_folder_names_free(char **names, size_t count);
bool thud_path_is_folder(const char *path);
