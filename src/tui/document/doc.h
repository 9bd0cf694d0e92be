/* The preset that is open: the scene, what can be undone, the file it came from, the ground motion it names. */
#pragma once

#include "ground/record.h"
#include "io/file/paths.h"
#include "io/preset/preset.h"
#include "study/scene/scene.h"
#include "tui/document/undo.h"

struct thud_stamp {
    long long seconds, nanoseconds, size, number; /* of a file when it was read or written; all 0: there was none */
};

struct thud_doc {
    const struct thud_paths *paths;
    char path[512];
    struct thud_preset *preset;
    struct thud_scene scene, saved;
    struct thud_undo undo;
    struct thud_stamp stamp;
    unsigned long revision;                  /* grows with every change that changes a run */
    unsigned long edits;                     /* grows with every change */
    char kept[512];                          /* the file that has the unsaved changes; empty: none */
    struct thud_record *record;              /* NULL: none */
    struct thud_record *whole;               /* scaled alike, where only a part is used; NULL: all of it is */
    struct thud_record_choice record_choice; /* what `record` was read with */
    bool record_tried;
    struct thud_error record_error; /* status THUD_OK: it was read */
};

/* Reads a preset by name or path in place of what is open, which stays on failure. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_doc_open(struct thud_doc *doc, const char *name, struct thud_error *err);
/* A preset that is nowhere yet in place of what is open, which stays on failure; saving writes it to `path`. Errors:
 * THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_doc_new(struct thud_doc *doc, const char *text, size_t size, const char *path,
                              struct thud_error *err);
void thud_doc_free(struct thud_doc *doc);

bool thud_doc_unsaved(const struct thud_doc *doc);
/* Whether a path lies in the folder of the presets that come with thud, which are not written to. */
bool thud_doc_is_shipped(const struct thud_doc *doc, const char *path);
/* Whether the file is another one than was read, or is not there any more. */
bool thud_doc_disk_changed(const struct thud_doc *doc);
bool thud_doc_disk_gone(const struct thud_doc *doc);
/* Writes to `path` (NULL: where it came from), comments kept, and reads the result as the new base. Errors:
 * THUD_OUTPUT, THUD_INPUT. */
enum thud_status thud_doc_save(struct thud_doc *doc, const char *path, struct thud_error *err);
/* Where unsaved changes are kept: `NAME.recovered` beside the preset, of one that comes with thud in the working
 * folder. */
void thud_doc_recovery_path(const struct thud_doc *doc, char *path, size_t size);
/* Keeps them there, or in TMPDIR where that cannot be written or is another session's; `kept` says where. Errors:
 * THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_doc_recover(struct thud_doc *doc, struct thud_error *err);
void thud_doc_forget_kept(struct thud_doc *doc); /* removes that file: they are saved, or given up */

/* Checks `next`, notes the step back and puts it in place. Errors: THUD_INPUT (the scene is as it was), THUD_MEMORY. */
enum thud_status thud_doc_change(struct thud_doc *doc, const struct thud_scene *next, const char *what,
                                 struct thud_error *err);
/* Name, title and study change no run: what is known of the one scene holds for the other. */
bool thud_doc_runs_alike(const struct thud_scene *a, const struct thud_scene *b);
/* thud_scene_set as a change, with "key old -> new" as what. */
enum thud_status thud_doc_set(struct thud_doc *doc, const char *key, const char *text, struct thud_error *err);
/* One step; what it was, NULL when there is none. */
const char *thud_doc_undo(struct thud_doc *doc);
const char *thud_doc_redo(struct thud_doc *doc);

/* The ground motion as the scene names it now, read again only where the choice changed. NULL with THUD_OK: none is
 * named. */
enum thud_status thud_doc_record(struct thud_doc *doc, const struct thud_record **out, struct thud_error *err);
/* That of another scene, a copy of its own. */
enum thud_status thud_doc_read_record(const struct thud_doc *doc, const struct thud_scene *scene,
                                      struct thud_record **out, struct thud_error *err);
