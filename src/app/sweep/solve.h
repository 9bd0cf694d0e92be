/* Finds the value of a key at which a criterion is met: a scan over its range, then bisection wherever the answer
 * changes. One change is taken as monotonic; several are listed. */
#pragma once

#include <stdatomic.h>

#include "app/run/record_list.h"
#include "base/text.h"
#include "io/result/study_rows.h"
#include "study/suite/fragility.h"

enum { THUD_SOLVE_TRIES_MAX = 256, THUD_SOLVE_CHANGES_MAX = 4 };

/* What has to hold: that an event does not happen ("force < 10 MN", "no pounding"), or that it does ("drift > 1 %"). */
struct thud_criterion {
    struct thud_event event;
    bool happens;
    char text[64]; /* as asked for */
};
/* Errors: THUD_USAGE. */
enum thud_status thud_criterion_parse(const char *text, struct thud_criterion *out, struct thud_error *err);

struct thud_solve {
    char key[THUD_VARY_KEY];
    struct thud_criterion criterion;
    double share;                                      /* of the ground motions, at least */
    struct thud_tried_row tried[THUD_SOLVE_TRIES_MAX]; /* (n) by x */
    int n, nrecords;
    int change[THUD_SOLVE_CHANGES_MAX], changes; /* i: the answer changes between tried i and i + 1 */
};
/* `by`: "bumper.thickness=3cm:15cm". `records`: NULL: no ground motion. Errors: THUD_USAGE, THUD_INPUT, THUD_CANCELLED,
 * THUD_MEMORY. */
enum thud_status thud_solve_run(const struct thud_scene *scene, const struct thud_record_list *records, const char *by,
                                const struct thud_criterion *criterion, double share, const atomic_int *cancel,
                                struct thud_solve *out, struct thud_error *err);
/* The result: the value on the side of the only change where the criterion is met; NULL: it holds, or does not, all
 * over, or there are several changes. */
const struct thud_tried_row *thud_solve_answer(const struct thud_solve *solve);
/* The answer in a sentence or two. */
void thud_solve_words(const struct thud_solve *solve, struct thud_text *out);
/* The words, and a line per value that was tried. */
void thud_solve_report(const struct thud_solve *solve, struct thud_text *out);
void thud_solve_csv(const struct thud_solve *solve, struct thud_text *out); /* a row per value that was tried */
void thud_solve_json(const struct thud_solve *solve, struct thud_text *out);
