/* --records: the ground motions of a study. */
#ifndef THUD_CLI_RECORDS_OPTION_H
#define THUD_CLI_RECORDS_OPTION_H

#include "app/run/record_list.h"
#include "cli/args.h"

/* Those of --records, or of the preset's study, with what --peak, --dt, ... say of all of them; else the session's own
 * one (--record), or none. What is wrong with them is told by thud_records_warn. Errors: THUD_USAGE,
 * THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_records_option_read(const struct thud_args *args, struct thud_session *session,
                                          struct thud_record_list *out, struct thud_error *err);

/* Ground motions named in a text, as --records names them, with what the other options say of all. Errors: as
 * thud_record_list_read. */
enum thud_status thud_records_named(const struct thud_args *args, const struct thud_session *session, const char *text,
                                    bool both, struct thud_record_list *out, struct thud_error *err);

/* What is wrong with motions (a factor, a direction, too few), on standard error; not with --quiet. */
void thud_records_warn(const struct thud_args *args, const struct thud_record *const *record, int n);

#endif
