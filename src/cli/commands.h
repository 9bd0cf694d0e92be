/* The commands. Each is one file command_NAME.c and one line in command_words.h; its error is printed by cli.c, which
 * makes the exit status of it. */
#pragma once

#include <stdatomic.h>
#include <stdbool.h>

#include "base/status.h"
#include "base/text.h"
#include "cli/args.h"
#include "cli/options.h"
#include "io/file/schema.h"
#include "plot/figure/figure.h"
#include "study/sweep/remark.h"

#define THUD_COMMAND(ID, name)                                                                                         \
    enum thud_status thud_command_##name(const struct thud_args *args, struct thud_error *err);
#define THUD_COMMAND_WITH(ID, name) thud_scene_work thud_command_##name;
#include "cli/command_words.h"
#undef THUD_COMMAND
#undef THUD_COMMAND_WITH

/* Writes the text to standard output and clears it: without what a terminal would obey in place of showing it. See thud_text_print. Errors:
 * THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_cli_print(struct thud_text *text, struct thud_error *err);

/* By --json and --csv. */
enum thud_written thud_cli_form(const struct thud_args *args);
/* A list of what there is, which takes no name: as people read it, CSV or JSON. Errors: THUD_USAGE, THUD_OUTPUT,
 * THUD_MEMORY. */
enum thud_status thud_cli_list(const struct thud_args *args, void (*table)(struct thud_text *out),
                               void (*put)(bool json, struct thud_text *out), struct thud_error *err);
/* As data with --json or --csv, else for people. `before`: what files came to, which is given back; nothing is printed
 * after a failure but that of gnuplot, whose message stands. */
enum thud_status thud_cli_print_as(const struct thud_args *args, struct thud_text *text, enum thud_status before,
                                   struct thud_error *err);

/* Prints the names of the files written, one per line; with --json an object with a list. Clears the text. */
enum thud_status thud_cli_print_files(const struct thud_args *args, struct thud_text *lines, struct thud_error *err);

/* Write the message to standard error; the second as a warning. */
void thud_cli_complain(const struct thud_error *err);
void thud_cli_warn(const struct thud_error *what);
/* The remarks of a set of enum thud_remark_about, a warning each; with --quiet only of the ledger. */
void thud_cli_remarks(const struct thud_args *args, const struct thud_remark_scope *scope, unsigned about);

/* Words indented by 2, in lines of the width of tables. */
void thud_cli_words(const char *words, struct thud_text *out);
/* The works that a law or method is from, parted by "; ": a line each. */
void thud_cli_references(const char *reference, struct thud_text *out);

/* ---- Ctrl-C while something long runs ---- */

/* For the beginning of the program: INT, TERM and HUP end it without leaving a file in the making. A file that grows
 * beyond `ulimit -f` is an error of writing. A signal that is ignored stays so. */
void thud_interrupt_start(void);
/* From now on INT, TERM and HUP set the flag to their number instead of ending the program; a second one ends it. A HUP
 * that is ignored (nohup) stays so. */
const atomic_int *thud_interrupt_watch(void);
/* The signal that came; 0: none. */
int thud_interrupt_signal(void);

/* How far a long work is, on standard error: a line that renews itself on a terminal, one every few seconds elsewhere,
 * none with --quiet. One work at a time. */

/* Whether anything will be shown. */
bool thud_progress_start(const struct thud_args *args);
void thud_progress_show(const char *fmt, ...) THUD_PRINTF(1, 2);
/* Wipes out the line of a terminal, before something else is written there; `end`: nothing more will be shown. */
void thud_progress_wipe(void);
void thud_progress_end(void);
/* What is being done; for struct thud_site_report_options and its like. */
void thud_progress_what(void *context, const char *what);
/* Of the points of a study, with the time that is left; for struct thud_sweep_study and its like. */
void thud_progress_points(void *context, long done, long count, double elapsed_s);
/* Of the figures that are drawn one after another. */
void thud_progress_drawing(void *context, const struct thud_figure *figure);
/* To the file from which the screens that began the command read figures; without them nothing. True: there is one. */
bool thud_progress_is_watched(void);
void thud_progress_figure(const struct thud_figure *figure);
