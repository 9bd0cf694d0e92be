/* report.html, report.md: the paper's study in words, tables and figures. */
#pragma once

#include <stdatomic.h>

#include "app/report/document.h"
#include "app/sweep/sweep_collector.h"
#include "app/sweep/sweep_jobs.h"
#include "base/text.h"
#include "plot/figures/figures_paper.h"
#include "plot/gnuplot/gnuplot.h"
#include "study/scene/scene.h"
#include "study/sweep/sweep_table.h"

/* Runs beside the paper's study, for what its text says of other numbers of storeys, of the stiffness of impact, and of
 * the two bodies. */

/* The towers without a bumper at their own gap, with another stiffness of the concrete. */
struct thud_paper_spike {
    double stiffness_npm;
    double acceleration_mps2, free_mps2;  /* largest of the floors that pound, and of the same ones without pounding */
    double force_n, duration_s, period_s; /* of the strongest impact; first one of the left building */
    int struck, widened;                  /* contacts that were, and those with a plastic indentation at the end */
    double residual_m;                    /* the largest */
};
enum { THUD_PAPER_STIFFNESSES = 3 };

/* Of the first motion with one of its signs. */
struct thud_paper_runs {
    struct thud_sweep_plan plan; /* storeys of the second building and gap, cases none and bumper */
    struct thud_sweep_collector storeys;
    const char *name;
    bool planned;
    struct thud_paper_spike spike[THUD_PAPER_STIFFNESSES]; /* a quarter, once, four times */
};

/* Errors: those of runs, THUD_CANCELLED, THUD_MEMORY. thud_paper_runs_clear frees what was made, also on failure. */
enum thud_status thud_paper_runs_make(const struct thud_scene *scene, const struct thud_record *const *record,
                                      const char *name, const struct thud_sweep_jobs *jobs, struct thud_paper_runs *out,
                                      struct thud_error *err);
void thud_paper_runs_clear(struct thud_paper_runs *runs);

struct thud_paper_record {
    const char *name, *file;
    double peak_mps2, dt_s;
    size_t samples;
    double scale;   /* what the file's samples were multiplied by, with the sign */
    bool surrogate; /* computed, not recorded */
};

enum { THUD_PAPER_FIGURES = 9 };
/* One as it was drawn: its file's name, caption, what is to be seen in it, and its bytes where a page can show them. */
struct thud_paper_picture {
    char file[32], caption[400];
    struct thud_text alt, bytes;
};

struct thud_paper_study {
    const struct thud_scene *scene;         /* the preset the study was made from */
    const struct thud_sweep_table *table;   /* cases none, bumper, cavity over the gap */
    const struct thud_sweep_table *turned;  /* the same with every motion reversed */
    const struct thud_paper_record *record; /* (table->nrecords) */
    const struct thud_paper_runs *runs;     /* (2) beside it, as given and reversed; NULL: no report is made */
    const struct thud_paper_pair *pair;     /* (THUD_PAPER_COLLISIONS) */
    struct thud_paper_picture *picture;     /* (THUD_PAPER_FIGURES); the report takes their bytes */
    int unanswered;                         /* runs whose integration failed */
};

/* Motions of it that are synthetic. */
int thud_paper_synthetic(const struct thud_paper_study *study);
/* study.json: the motions, the scene, what was varied. */
void thud_paper_study_json(const struct thud_paper_study *study, struct thud_text *out);
/* Look at d->failed. */
void thud_paper_report(const struct thud_paper_study *study, struct thud_document *d);

/* ---- What the paper says in words, each with what was found ---- */

/* What a ratio must differ from 1 by to count as changed. */
#define THUD_PAPER_CHANGE 1e-3

/* A table of the report, with study->pair. */
void thud_paper_statements(const struct thud_paper_study *study, struct thud_document *d);

/* ---- The paper's parametric study: the preset `towers`, three ground motions, its gaps and cases ---- */

struct thud_paper_request {
    const char *records; /* as thud_record_list_read takes them; NULL: the motions that come with the program. The first
                            three are scaled to the peaks of the paper's Table 2 unless they or `peak` say otherwise */
    const char *peak, *dt, *unit; /* for all of them; may be NULL */
    bool both_signs;              /* every motion reversed too, for the report */
    int threads;                  /* 0: the processors that are online */
    const atomic_int *cancel;
    void *context;
    void (*progress)(void *context, long done, long count, double elapsed_s); /* may be NULL */
};

struct thud_paper_work; /* what the study is made of */

/* Reads the ground motions and runs the study. *study is valid until thud_paper_work_free. Errors: THUD_USAGE,
 * THUD_INPUT, THUD_DIVERGED, THUD_CANCELLED, THUD_MEMORY. */
enum thud_status thud_paper_work_make(const struct thud_paper_request *request, struct thud_paper_work **out,
                                      struct thud_paper_study *study, struct thud_error *err);
void thud_paper_work_free(struct thud_paper_work *work);

/* ---- The paper's figures by name, and the report that holds them all ---- */

enum { THUD_PAPER_ALL = (1 << THUD_PAPER_FIGURES) - 1, THUD_PAPER_REPORT = 1 << THUD_PAPER_FIGURES };

/* "fig2" to "fig10". */
const char *thud_paper_figure_name(int index);
/* A set of figures from their names, `all` for all of them with the report, which is also what no name means. Errors:
 * THUD_USAGE. */
enum thud_status thud_paper_figures_parse(int n, const char *const *name, unsigned *which, struct thud_error *err);
/* Whether a set needs the parametric study. */
bool thud_paper_needs_study(unsigned which);

/* Writes a set of figures into a folder; the report too where it is in the set (study->pair is filled here and may be
 * NULL). `study` may be NULL where none is needed. Errors: as thud_figure_deliver, and those of runs. */
enum thud_status thud_paper_figures_save(unsigned which, const struct thud_paper_study *study, const char *folder,
                                         const struct thud_picture_options *options, struct thud_error *err);
