/* Reads and writes whole files; no file is ever half written. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"
#include "base/text.h"

/* Reads a whole file and appends NUL (free with free()); "-" is standard input. Refuses folders, endless devices, pipes
 * without a writer and files over `limit` bytes. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_file_read(const char *path, size_t limit, char **text, size_t *size, struct thud_error *err);

/* Reads a text file for thud_text_line, without a leading byte-order mark (free with free()). Also refuses what
 * thud_text_check refuses. */
enum thud_status thud_text_read(const char *path, size_t limit, char **text, struct thud_error *err);
/* Refuses a byte 0, with its line and column: the rest would be lost without a message. */
enum thud_status thud_text_check(const char *text, size_t size, const char *name, struct thud_error *err);
/* Cuts the next line off *text, without its end (LF or CR LF); NULL behind the last one. */
char *thud_text_line(char **text);

/* Returns whether both exist and are the same file. */
bool thud_file_is_same(const char *a, const char *b);

/* Writes a temporary beside `path`, syncs and renames; on failure `path` is as it was and the temporary is gone.
 * Errors: THUD_OUTPUT. */
enum thud_status thud_file_write(const char *path, const char *text, size_t size, struct thud_error *err);

/* Draft of a file: written, but invisible under its name before thud_file_keep. So a group of files appears whole or
 * not at all, except for failures of rename(2). {0}: nothing is in the making. */
struct thud_file_draft {
    bool is_open, is_synced;
    int fd;
    char path[4096], part[4200];
};

/* Begins an empty draft, and adds what `text` holds so far when it is at least `least` bytes, emptying it. Errors:
 * THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_file_begin(const char *path, struct thud_file_draft *out, struct thud_error *err);
enum thud_status thud_file_add(struct thud_file_draft *draft, struct thud_text *text, size_t least,
                               struct thud_error *err);

/* Owner of a file. The kind of a file named by the user is kept: a link still points to the file that is written, and a
 * pipe or device is written at once. A file of the program's own in a results folder replaces whatever has its name, so
 * nothing outside the folder is written. */
enum thud_file_owner { THUD_FILE_NAMED, THUD_FILE_RESULT };

/* Does as thud_file_write without renaming. Errors: THUD_OUTPUT; nothing is in the making then. */
enum thud_status thud_file_draft(const char *path, const char *text, size_t size, enum thud_file_owner owner,
                                 struct thud_file_draft *out, struct thud_error *err);
/* Syncs, renames and ends the draft, also on failure. Errors: THUD_OUTPUT. */
enum thud_status thud_file_keep(struct thud_file_draft *draft, struct thud_error *err);
void thud_file_drop(struct thud_file_draft *draft);

/* Writes the whole text by thud_file_write and clears it; THUD_MEMORY if it had failed. */
enum thud_status thud_text_write(struct thud_text *text, const char *path, struct thud_error *err);
/* Writes it to standard output and clears it: byte for byte, but on a terminal as thud_text_shown. Errors: THUD_OUTPUT,
 * THUD_MEMORY. */
enum thud_status thud_text_print(struct thud_text *text, struct thud_error *err);

/* Writes the whole text as a result, FOLDER/NAME ("": the working folder), and clears it; after a failure in `before`
 * it writes nothing and returns that. Errors: also THUD_OUTPUT for a name that is too long. */
enum thud_status thud_text_save(struct thud_text *text, const char *folder, const char *name, enum thud_status before,
                                struct thud_error *err);

/* Creates a folder with its parents for writing, and removes files left half written by killed programs. Errors:
 * THUD_OUTPUT. */
enum thud_status thud_folder_make(const char *path, struct thud_error *err);
/* Checks this without creating anything: whether a file of its name is in the way. */
enum thud_status thud_folder_check(const char *path, struct thud_error *err);

/* Locks a folder for one study at a time. The lock ends with the process. It works wherever the locks of the file
 * system work, also between containers and hosts. Errors: THUD_OUTPUT (held by another study, or no lock possible). */
struct thud_folder_lock {
    int fd; /* -1: not held */
    char path[4200];
};
enum thud_status thud_folder_lock(const char *folder, struct thud_folder_lock *lock, struct thud_error *err);
void thud_folder_unlock(struct thud_folder_lock *lock);

/* Removes all drafts: for a signal handler after which the program ends. */
void thud_file_drop_all(void);
