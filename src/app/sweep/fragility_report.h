/* Fragility of a study over its ground motions: every event and case along every varied number, at every setting of the
 * others; as a table, CSV and JSON. */
#pragma once

#include "io/file/schema.h"
#include "plot/figure/figure.h"
#include "study/suite/fragility.h"
#include "study/sweep/remark.h"

struct thud_fragility_line {
    int event, k, axis;
    int at[THUD_VARY_MAX]; /* on the other axes; 0 on its own */
    struct thud_fragility fragility;
    struct thud_rate rate; /* annual; NaN: no hazard curve, or not along an intensity */
};

struct thud_fragility_study {
    const struct thud_suite *suite;
    const struct thud_remark_scope *scope; /* whose remarks JSON ends with */
    int nevents;
    struct thud_event event[THUD_EVENTS_MAX];
    struct thud_hazard hazard; /* n = 0: none */
    int samples;               /* of the bootstrap */
    unsigned long long seed;
    size_t n;
    struct thud_fragility_line *line; /* (n) by event, case, axis, setting */
};

/* A hazard curve from CSV: two columns, intensity and annual rate of being exceeded; `#` before a comment. A first line
 * of words may name them; of an acceleration it must, with the unit: `sa_g`, `sa (cm/s2)`. Errors: THUD_INPUT with
 * line. */
enum thud_status thud_hazard_read(const char *path, const struct thud_sweep_axis *axis, struct thud_hazard *out,
                                  struct thud_error *err);

/* Checks before any run that the scenes of a plan have what the events need. Errors: THUD_USAGE. */
enum thud_status thud_fragility_check(const struct thud_fragility_study *study, const struct thud_sweep_plan *plan,
                                      struct thud_error *err);
/* Fills `line`; `suite`, events, hazard, samples and seed are given. Errors: THUD_USAGE (no number is varied),
 * THUD_MEMORY. */
enum thud_status thud_fragility_study_make(struct thud_fragility_study *study, struct thud_error *err);
void thud_fragility_study_clear(struct thud_fragility_study *study);

void thud_fragility_table(const struct thud_fragility_study *study, struct thud_text *out);
/* A row for each stripe; and for each curve. */
void thud_fragility_csv(const struct thud_fragility_study *study, struct thud_text *out);
void thud_fragility_curves_csv(const struct thud_fragility_study *study, struct thud_text *out);
void thud_fragility_json(const struct thud_fragility_study *study, struct thud_text *out);
/* Fractiles of every measure over the motions, a row for each setting, case and structure; as JSON an array of them.
 * The table is 80 columns wide and has at most five values of every varied key. Errors: THUD_MEMORY. */
enum thud_status thud_suite_report(const struct thud_suite *suite, enum thud_written as, struct thud_text *out,
                                   struct thud_error *err);
/* By response, what each case is over case none, and under how many ground motions it is lower: at up to three
 * settings. Nothing without case none. Errors: THUD_MEMORY. */
enum thud_status thud_suite_lowered(const struct thud_suite *suite, struct thud_text *out, struct thud_error *err);
/* The same as a figure. NULL: out of memory, or there is no case none to compare with. */
struct thud_figure *thud_suite_lowered_figure(const struct thud_suite *suite);

/* Its figures, counted from 0: each event's curves, then the incremental dynamic analysis of each case along each
 * intensity. Ask thud_figure_check. */
int thud_fragility_figure_count(const struct thud_fragility_study *study);
struct thud_figure *thud_fragility_figure(const struct thud_fragility_study *study, int index);
