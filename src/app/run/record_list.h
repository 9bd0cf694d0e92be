/* Several ground motions named in one text. */
#pragma once

#include <stdbool.h>

#include "app/run/record_verbs.h"
#include "app/run/session.h"
#include "base/text.h"

enum { THUD_RECORD_SETTINGS_MAX = 20 };
/* What can be said of a ground motion beside its file, as words of the command line and as keys of a preset's record:
 * the i-th, NULL past the last. */
const char *thud_record_setting(int i);

struct thud_record_source {
    char *path;    /* where the file was found */
    char *reading; /* how it was read, as a list says it, without what scales it: ":dt=0.005 s:unit=g", or "" */
};

struct thud_record_list {
    int n;
    int skipped;                 /* files that could not be read, and were to be left out */
    int own_size;                /* files with a peak, sa or factor of their own, in place of what holds for all */
    char unused[400];            /* what the scene says of its own record alone: "record.peak 0.3 g, record.sign -" */
    struct thud_record **record; /* (n) each named in `file` as it was typed */
    struct thud_record_source *source; /* (n) */
};

/* A suite: `NAME,NAME,...`, each a file, a folder or a list NAME.list. A folder stands for all its files in the order
 * of their names, except hidden ones, .md and .list. A list has a file on each line, from the list's own folder, and
 * `#` before a comment. A name or value may be in quotation marks. The settings of a file follow it after colons,
 * `a.AT2:peak=0.9 g:dt=0.005 s:unit=g`; they are keys of the preset's record. Settings of a folder or list apply to all
 * its files that do not set the same key, and `common` (n pairs key, value) to everything. A peak, sa or factor
 * replaces all three of those that apply to more files. What the session's scene says of its own record holds for none
 * of them, and is refused where these are all that the scene has. `:unreadable=skip` leaves out files that cannot be
 * read. `both`: each motion also reversed, named FILE:sign=-. Motions of one file are told apart by their settings.
 * Files are looked for as the session's own record is, folders and lists from the working folder. `out` NULL: it is only
 * looked whether all that is named is there. Errors: THUD_USAGE, THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_record_list_read(const struct thud_session *session, const char *text, const char *(*common)[2],
                                       int ncommon, bool both, struct thud_record_list *out, struct thud_error *err);
/* The session's own record, or none. Errors: as thud_session_read_record. */
enum thud_status thud_record_list_own(struct thud_session *session, bool both, struct thud_record_list *out,
                                      struct thud_error *err);
/* What a study names, or the session's own record where it names nothing; empty after an error. Errors: of both. */
enum thud_status thud_record_list_named(struct thud_session *session, const char *text, bool both,
                                        struct thud_record_list *out, struct thud_error *err);
/* By its name, NAME.list. */
bool thud_record_is_list(const char *file);
/* The motions of a list, or the one file of that name, each opened as thud_record_open does; the settings of a line go
 * before those of the treatment. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_record_list_open(const char *name, const struct thud_record_treatment *treatment,
                                       struct thud_record_list *out, struct thud_error *err);
void thud_record_list_clear(struct thud_record_list *list);
/* The i-th motion as a line of a list: its file by a name, how it was read, and a factor on what the file has. */
void thud_record_list_line(const struct thud_record_list *list, int i, const char *name, double factor,
                           struct thud_text *out);
