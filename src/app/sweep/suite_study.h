/* A suite of ground motions looked at, selected and scaled to a design spectrum. */
#pragma once

#include "app/run/record_list.h"
#include "base/text.h"
#include "ground/intensity.h"
#include "plot/figures/figures_suite.h"
#include "study/suite/scaling.h"

struct thud_suite_study {
    const struct thud_record_list *records; /* the caller's */
    bool has_target;
    struct thud_target target;
    struct thud_scaling scaling;
    struct thud_period_mark mark[THUD_STRUCTURES_MAX]; /* first periods of buildings; nmarks may be 0 */
    int nmarks;
    struct thud_intensity *intensity; /* (records->n) as read */
    double *factor;                   /* (records->n) of the motion as its file has it */
    struct thud_scaled_suite scaled;
};

/* Scales what `records` holds; target, scaling and marks are set. Errors: as thud_suite_scale. */
enum thud_status thud_suite_study_run(struct thud_suite_study *study, struct thud_error *err);
void thud_suite_study_clear(struct thud_suite_study *study);

/* For people: the motions, what was scaled to what, and remarks. */
void thud_suite_motions_table(const struct thud_suite_study *study, struct thud_text *out);
void thud_suite_motions_csv(const struct thud_suite_study *study, struct thud_text *out);
void thud_suite_motions_json(const struct thud_suite_study *study, struct thud_text *out);
/* What --records takes: a line for each chosen motion with its factor. Files stand from the folder of the list: `from`
 * is put before names that are no whole path ("" where the list stands in the working folder). Errors: THUD_INPUT (a
 * name that no line can hold). */
enum thud_status thud_suite_list_text(const struct thud_suite_study *study, const char *from, struct thud_text *out,
                                      struct thud_error *err);
