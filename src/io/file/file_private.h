#pragma once

#include <stddef.h>

/* A new file beside `path` that is to take its place, its name in `name`; -1 with errno when there can be none. It is
 * held against tidying until its descriptor is closed: that comes after one of the two below. */
int thud_file_open_beside(const char *path, char *name, size_t size);
/* It takes the place of `path`; 0, or the errno of what went wrong, and it is gone. */
int thud_file_replace(const char *name, const char *path);
void thud_file_remove(const char *name);
/* Removes what ended programs left in a folder under such names. */
void thud_folder_tidy(const char *folder);
/* A file has come under its name: for the list of thud_made_by_begin. */
void thud_made_by_note(const char *path);

/* What is wrong with the file `path`; gives `status`. */
enum thud_status thud_file_refuse(struct thud_error *err, enum thud_status status, const char *path, const char *what);
