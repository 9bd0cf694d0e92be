/* Several ground motions named in one text. */
#ifndef THUD_APP_RECORD_LIST_H
#define THUD_APP_RECORD_LIST_H

#include "app/session.h"

enum { THUD_RECORD_SETTINGS_MAX = 16 };
/* What can be said of a ground motion beside its file, as words of the command line and as keys of a preset's record:
 * the i-th, NULL past the last. */
const char *thud_record_setting(int i);

struct thud_record_list {
    int n;
    struct thud_record **record; /* (n) each named in `file` as it was typed */
};

/* `FILE,FILE,...`; a file's own settings follow it after colons, `a.AT2:peak=0.9 g:dt=0.005 s:unit=g`: keys of the
 * preset's record. `common` (n pairs key, value) are settings for all of them. Files are looked for as the session's
 * own record is. Errors: THUD_USAGE, THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_record_list_read(const struct thud_session *session, const char *text, const char *(*common)[2],
                                       int ncommon, struct thud_record_list *out, struct thud_error *err);
/* The session's own record, or none. Errors: as thud_session_read_record. */
enum thud_status thud_record_list_own(struct thud_session *session, struct thud_record_list *out,
                                      struct thud_error *err);
void thud_record_list_clear(struct thud_record_list *list);

#endif
