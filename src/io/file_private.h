#ifndef THUD_IO_FILE_PRIVATE_H
#define THUD_IO_FILE_PRIVATE_H

#include <stddef.h>

/* A new file beside `path` that is to take its place, its name in `name`; -1 with errno when there can be none. */
int thud_file_open_beside(const char *path, char *name, size_t size);
/* Removes what ended programs left in a folder under such names. */
void thud_folder_tidy(const char *folder);

#endif
