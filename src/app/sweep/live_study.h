/* A study that is made while something else goes on, as live_cases.h has the cases of a scene: its motions, its plan,
 * and what of it is done. */
#pragma once

#include "app/run/record_list.h"
#include "app/sweep/fragility_report.h"
#include "app/sweep/sweep_study.h"
#include "io/result/sweep_csv.h"

struct thud_live_study {
    bool running, complete, read; /* the last: the motions are */
    struct thud_sweep_plan plan;
    struct thud_record_list records;
    struct thud_record_choice records_of; /* the scene's choice and the study's words that the motions were read by */
    char records_words[sizeof((struct thud_study_choice *)0)->records];
    bool both_signs;
    struct thud_sweep_work *work;   /* NULL: nothing is running */
    struct thud_sweep_outcome out;  /* names, rows and sums of what is done */
    struct thud_sweep_point **done; /* (next) */
    long next, points;
    struct thud_suite *suite; /* of several motions; NULL: of one */
    /* Of a suite, once a figure of it was asked for: */
    int told;                              /* of so many motions, the first ones; 0: not yet */
    struct thud_fragility_study fragility; /* n = 0: there is none */
    struct thud_needed_gap **gap;          /* (told) at the first values of the varied keys; NULL: none */
};

/* Starts again: reads the motions (again only where they are others) and makes the plan. Errors: THUD_USAGE,
 * THUD_INPUT, THUD_MEMORY; there is no study then. */
enum thud_status thud_live_study_prepare(struct thud_live_study *study, struct thud_session *session,
                                         struct thud_error *err);
/* Starts the threads. Errors: THUD_MEMORY. */
enum thud_status thud_live_study_start(struct thud_live_study *study, struct thud_error *err);
/* Takes the points that are finished, waiting a few milliseconds for one; `running` goes false at the end. Errors end
 * the study, what is done stays. */
enum thud_status thud_live_study_advance(struct thud_live_study *study, struct thud_error *err);
/* Figures of what is done, counted from 0: the study's own; over several motions, once three are done, the gap that is
 * enough, fragility and incremental dynamic analysis. thud_live_study_figure: NULL, or ask thud_figure_check. */
int thud_live_study_figures(struct thud_live_study *study);
struct thud_figure *thud_live_study_figure(struct thud_live_study *study, int index);
/* STEM.csv, -contacts.csv and -needed-gaps.csv of what is done into a folder that is there; of a suite also its
 * statistics and fragility. Errors: THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_live_study_export(const struct thud_live_study *study, const char *folder, const char *stem,
                                        struct thud_error *err);
void thud_live_study_stop(struct thud_live_study *study); /* keeps what is done */
void thud_live_study_clear(struct thud_live_study *study);
