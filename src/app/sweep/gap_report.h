/* The required gap, over a list of ground motions: as a table, CSV, JSON. */
#pragma once

#include <stdatomic.h>

#include "app/run/record_list.h"
#include "base/text.h"
#include "io/result/study_rows.h"
#include "study/suite/gap_suite.h"

struct thud_gap_study {
    const struct thud_record_list *records; /* the caller's */
    struct thud_gap_suite suite;
    const char **name;            /* (suite.nrecords) last parts of the files' names */
    struct thud_needed_gap **gap; /* (suite.nrecords) */
    struct thud_gap_range *range; /* (nranges) of interfaces beside an estimated building; NULL: there is none */
    int interfaces, nranges;
    struct thud_gap_row_fields *row; /* (nrow) of three or more structures, interfaces that can touch; else NULL */
    int nrow, row_runs;
    struct thud_gap_ruled *ruled; /* (THUD_GAP_RULES + 1 x interfaces), what is needed first; NULL: not asked for */
};

/* One run without contact for each ground motion (one without, where the scene has none). `code`: NULL for its
 * defaults. Where nothing can touch it has no levels. Errors: those of thud_needed_gap_run; THUD_CANCELLED. */
enum thud_status thud_gap_study_run(const struct thud_scene *scene, const struct thud_record_list *records,
                                    const struct thud_gap_code *code, const atomic_int *cancel,
                                    struct thud_gap_study *out, struct thud_error *err);
/* The gap that every rule requires over the suite, and what happens at that gap. Each ground motion that touches there
 * has one run with contact, which rules with the same gap share. Errors: those of thud_gap_pound; THUD_CANCELLED. */
enum thud_status thud_gap_study_rules(const struct thud_scene *scene, const struct thud_record_list *records,
                                      const atomic_int *cancel, struct thud_gap_study *study, struct thud_error *err);
void thud_gap_study_clear(struct thud_gap_study *study);

/* Of a building that collapses without contact: no gap helps it. `before`: "Storey", or "storey" within a sentence. */
void thud_gap_collapse(const struct thud_scene *scene, const struct thud_collapse *fall, const char *before,
                       struct thud_text *out);
/* 80 columns, after thud_gap_study_rules. Errors: THUD_MEMORY. */
enum thud_status thud_gap_report(const struct thud_gap_study *study, const struct thud_scene *scene,
                                 struct thud_text *out, struct thud_error *err);
/* A row per ground motion and level (needed-gaps.csv); per interface and rule with a value there (gap-rules.csv). */
struct thud_rows thud_gap_level_rows(const struct thud_gap_study *study);
struct thud_rows thud_gap_rule_rows(const struct thud_gap_study *study);
/* Errors: THUD_MEMORY. */
enum thud_status thud_gap_json(const struct thud_gap_study *study, const struct thud_scene *scene,
                               struct thud_text *out, struct thud_error *err);
