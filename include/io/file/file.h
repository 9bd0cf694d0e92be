/* Whole files, read and written so that nothing is ever half there. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"
#include "base/text.h"

/* The whole file with a terminating NUL after it (free with free()); "-" is standard input. Refuses folders, devices that never end, pipes
 * that nobody writes into and files over `limit` bytes. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_file_read(const char *path, size_t limit, char **text, size_t *size, struct thud_error *err);

/* A file of text for thud_text_line, without the byte-order mark that some editors put first (free with free()).
 * Refuses also what thud_text_check refuses. */
enum thud_status thud_text_read(const char *path, size_t limit, char **text, struct thud_error *err);
/* Refuses, with its line and column, a byte 0: whatever follows it would be lost in silence. */
enum thud_status thud_text_check(const char *text, size_t size, const char *name, struct thud_error *err);
/* Cuts the next line off *text, without its end (LF or CR LF); NULL behind the last one. */
char *thud_text_line(char **text);

/* Whether both exist and are the same file. */
bool thud_file_is_same(const char *a, const char *b);

/* Writes a temporary beside `path`, syncs and renames; on failure `path` is as it was and the temporary is gone.
 * Errors: THUD_OUTPUT. */
enum thud_status thud_file_write(const char *path, const char *text, size_t size, struct thud_error *err);

/* A file in the making: all of it is written, but nothing is to be seen under its name before thud_file_keep. So a
 * group of files is there whole or not at all, but for what rename(2) may refuse. */
struct thud_file_draft {
    char *path, *part; /* NULL: nothing is in the making */
    int fd;            /* of the part, where there is one */
};

/* Whose file a name is. A file that the user named keeps being what it is: a link stays a link to the file that is
 * written, and a pipe or a device is written at once. A file of the program's own in a folder for results takes the
 * place of whatever has its name, so that nothing outside of the folder is written. */
enum thud_file_owner { THUD_FILE_NAMED, THUD_FILE_RESULT };

/* Does as thud_file_write without renaming. Errors: THUD_OUTPUT, THUD_MEMORY; *out is then as {0}. */
enum thud_status thud_file_draft(const char *path, const char *text, size_t size, enum thud_file_owner owner,
                                 struct thud_file_draft *out, struct thud_error *err);
/* Renames and ends the draft, also on failure. Errors: THUD_OUTPUT. */
enum thud_status thud_file_keep(struct thud_file_draft *draft, struct thud_error *err);
void thud_file_drop(struct thud_file_draft *draft);

/* thud_file_write of the whole text; THUD_MEMORY when it had failed. Clears it. */
enum thud_status thud_text_write(struct thud_text *text, const char *path, struct thud_error *err);

/* The whole text as a result, FOLDER/NAME; "" is the working folder. Clears it. Errors: also THUD_OUTPUT for a name
 * that is too long. */
enum thud_status thud_text_write_in(struct thud_text *text, const char *folder, const char *name,
                                    struct thud_error *err);

/* Makes a folder with its parents, to write into; what killed programs left half written there goes. Errors:
 * THUD_OUTPUT.
 */
enum thud_status thud_folder_make(const char *path, struct thud_error *err);
/* Checks this without making anything: whether a file of its name is in the way. */
enum thud_status thud_folder_check(const char *path, struct thud_error *err);

/* One study at a time writes into a folder; the lock goes with the process, and holds wherever the file system's locks
 * do, also between containers and hosts. Errors: THUD_OUTPUT (another study does, or no lock can be taken). */
struct thud_folder_lock {
    int fd; /* -1: not held */
    char path[4200];
};
enum thud_status thud_folder_lock(const char *folder, struct thud_folder_lock *lock, struct thud_error *err);
void thud_folder_unlock(struct thud_folder_lock *lock);

/* Removes everything that is in the making: for the handler of a signal after which the program does not go on. */
void thud_file_drop_all(void);
