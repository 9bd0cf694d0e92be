/* A whole study as people ask for it: made in parallel, kept in a folder, gone on with, joined from parts. */
#pragma once

#include "app/sweep/sweep_collector.h"
#include "app/sweep/sweep_jobs.h"
#include "io/file/made_by.h"
#include "io/result/sweep_journal.h"
#include "plot/gnuplot/gnuplot.h"
#include "study/suite/suite.h"
#include "study/sweep/remark.h"

/* More rows than this are not kept in memory: there are no figures and no table then. */
enum { THUD_SWEEP_ROWS_MAX = 200000 };
/* What the study was made of, beside its other files. */
#define THUD_SWEEP_STUDY_FILE "study.json"

struct thud_sweep_study {
    const struct thud_sweep_plan *plan;
    const char *preset;            /* YAML of plan->scene, for the journal; only with a folder */
    struct thud_text *description; /* study.json, cleared once it is written; NULL or empty: none */
    const char *folder;            /* NULL: nothing is written */
    const struct thud_made_by *by; /* whose results the folder's are; NULL: nothing is said of that */
    struct thud_sweep_shard shard; /* 1 of 1: everything; a part leaves its journal only */
    int threads;
    bool table;               /* keep what figures, tables and the best value are made of */
    bool figures;             /* only with a table */
    bool no_rows;             /* leave sweep.csv, contacts.csv and needed-gaps.csv out */
    struct thud_suite *suite; /* not NULL: every point is added to it */
    const struct thud_picture_options *pictures;
    const atomic_int *cancel;
    void *context;
    void (*progress)(void *context, long done, long count, double elapsed_s); /* may be NULL */
    /* With a folder: its files are there, the journal not yet gone, so the same command resumes here. NULL: nothing. */
    enum thud_status (*conclude)(void *owner, struct thud_error *err);
    void *owner;
    /* Each point in its order, once the study is whole (without a folder: as soon as it is done); may be NULL. */
    enum thud_status (*emit)(void *context, const struct thud_sweep_point *point, struct thud_error *err);
};

struct thud_sweep_outcome {
    struct thud_sweep_total total;
    struct thud_sweep_watch watch;
    struct thud_sweep_collector rows; /* the table; empty where there were too many rows */
    const char **names;               /* of the records */
    bool too_many;
    enum thud_status pictures; /* THUD_OK, or what failed with them */
    struct thud_error picture_error;
};

/* With a folder: study.json, sweep.csv, contacts.csv, needed-gaps.csv and the figures, each whole or not at all. After
 * THUD_CANCELLED (with the folder's or the output's state told in `err`) the same call goes on. Errors: THUD_CANCELLED,
 * THUD_OUTPUT, THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_sweep_study_run(const struct thud_sweep_study *study, struct thud_sweep_outcome *out,
                                      struct thud_error *err);
/* Joins the parts in `part` (nparts folders) and delivers as thud_sweep_study_run does; `plan` is taken from their
 * journals by thud_sweep_parts_plan. Errors: THUD_INPUT (parts of different studies, missing or unfinished parts, by
 * name). */
enum thud_status thud_sweep_study_merge(const struct thud_sweep_study *study, const char *const *part, int nparts,
                                        struct thud_sweep_outcome *out, struct thud_error *err);
void thud_sweep_outcome_clear(struct thud_sweep_outcome *outcome);

/* The plan that a part's journal describes: scene, axes, cases, records by name and samples. Errors: THUD_INPUT (no
 * journal, one that is no part of a study), THUD_MEMORY. */
struct thud_sweep_parts {
    struct thud_sweep_plan plan;
    int nrecords;
    struct thud_record *records; /* (nrecords) names and samples, no more */
    const struct thud_record **record;
};
enum thud_status thud_sweep_parts_plan(const char *folder, struct thud_sweep_parts **out, struct thud_error *err);
void thud_sweep_parts_free(struct thud_sweep_parts *parts);
