/* Writes results as JSON and CSV in base SI units; numbers read back the same. */
#pragma once

#include "base/text.h"
#include "core/model/result.h"
#include "ground/record.h"
#include "study/methods/truncation.h"
#include "study/scene/needed_gap.h"
#include "study/scene/scene.h"
#include "study/sweep/sensitivity.h"

/* Finished run and all that its output needs. */
struct thud_report {
    const struct thud_scene *scene;   /* of the case that was run */
    const char *which;                /* "none", "bumper", "cavity", "as-written" */
    const struct thud_record *record; /* NULL: no ground motion */
    const struct thud_result *result;
    const struct thud_history *history; /* may be NULL */
    const struct thud_impact *impact;   /* (nimpacts) */
    int nimpacts;
    const struct thud_event_entry *event; /* (nevents) */
    int nevents;
    const struct thud_sensitivity *sensitivity; /* NULL: not asked for */
    const struct thud_truncation *truncation;   /* NULL: no mode is left out */
    const struct thud_needed_gap *gap;          /* NULL: not known */
    const struct thud_error *failure;           /* why there is no result (THUD_DIVERGED); NULL: there is one */
};

/* Writes the result of `thud run --json`. Its "scene" is a preset that reproduces the run. A failed run has its status,
 * time and reason, and neither peaks nor impacts. */
enum {
    THUD_RESULT_FORMAT = 2
}; /* of that file and of a list of such: dissipated_j and lost_j are without what
                                      is stored at the end */
void thud_result_json(const struct thud_report *report, struct thud_text *out);
/* Writes the identity of a ground motion as an object on one line. */
void thud_record_json(const struct thud_record *record, struct thud_text *out);
/* Writes one row per structure and floor; of several reports, after the name of its case. */
void thud_result_csv(const struct thud_report *report, int n, struct thud_text *out);
/* Writes histories.csv: time, ground acceleration, every floor, every contact; at jumps the time appears twice. */
void thud_history_csv(const struct thud_report *report, struct thud_text *out);
/* Writes impacts.csv: one row per impact. */
void thud_impacts_csv(const struct thud_report *report, struct thud_text *out);
