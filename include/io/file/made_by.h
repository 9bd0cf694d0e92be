/* Maintains made-by.txt: the program and scene that wrote the results in a folder, and the list of their files. Results
 * of two scenes can therefore neither replace each other nor be mixed unnoticed. */
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

/* Creates the folder. The same program and scene may resume or rewrite its results. Results of another scene, or of the
 * same group with other options, are refused or, with `replace`, removed (listed files only). Every later result in the
 * folder or below is recorded. One folder at a time. Errors: THUD_INPUT (refused, both named), THUD_OUTPUT,
 * THUD_MEMORY. */
enum thud_status thud_made_by_begin(const struct thud_made_by *by, struct thud_error *err);
/* Does the same in an existing folder, locked if others may write too. */
enum thud_status thud_made_by_enter(const struct thud_made_by *by, struct thud_error *err);
/* Checks as thud_made_by_begin without creating, removing or recording anything: before long work. */
enum thud_status thud_made_by_check(const struct thud_made_by *by, struct thud_error *err);
/* Writes the list and the description of its tables (datapackage.json) if there is more. Errors: THUD_OUTPUT,
 * THUD_MEMORY. */
enum thud_status thud_made_by_keep(const struct thud_made_by *by, struct thud_error *err);

/* Calls thud_made_by_keep if the results are complete: `before` is THUD_OK, or THUD_GNUPLOT, whose message stays.
 * Returns any other `before`. */
enum thud_status thud_made_by_end(const struct thud_made_by *by, enum thud_status before, struct thud_error *err);
