/* made-by.txt: what wrote the results in a folder, and which files they are, so that results of another scene do not
 * take their place, or stay beside its own, without a word. */
#pragma once

#include <stdbool.h>

#include "base/status.h"

struct thud_schema;

#define THUD_MADE_BY_FILE "made-by.txt"

struct thud_made_by {
    const char *folder;
    char group[16];           /* of commands that write files of the same names: "run", "study" */
    char what[240];           /* in words, for messages: "sweep of towers (gap 5 cm to 25 cm, 41 values)" */
    unsigned long long scene; /* thud_hash of the scene; 0: of none, which lies beside those of any */
    unsigned long long asked; /* of everything that is asked of it */
    bool replace;             /* remove what another scene's results are made of */
    const struct thud_schema *(*schema)(int); /* kinds of rows, for datapackage.json; NULL: none is written */
};

/* Makes the folder. Results that lie there may be continued or written again by what made them; those of another
 * scene, or of the same group asked for something else, are refused or, with `replace`, removed: the files that are
 * listed, no others. From then on every result that comes into the folder or one below it is remembered. One folder at a
 * time. Errors: THUD_INPUT (refused, both named), THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_made_by_begin(const struct thud_made_by *by, struct thud_error *err);
/* Likewise in a folder that is there, and locked where others may write too. */
enum thud_status thud_made_by_enter(const struct thud_made_by *by, struct thud_error *err);
/* As thud_made_by_begin, but nothing is made, removed or remembered: before long work. */
enum thud_status thud_made_by_check(const struct thud_made_by *by, struct thud_error *err);
/* Writes the list, and what the tables among the files are made of (datapackage.json), as often as there is more. Errors: THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_made_by_keep(const struct thud_made_by *by, struct thud_error *err);

/* thud_made_by_keep where the results are there: `before` is THUD_OK, or THUD_GNUPLOT, whose message stands. What else it
 * is comes back. */
enum thud_status thud_made_by_end(const struct thud_made_by *by, enum thud_status before, struct thud_error *err);
