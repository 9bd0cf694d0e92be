/* One scene in several cases beside no pounding: the runs, a table of their peaks, and what they say in words. */
#pragma once

#include "app/run/session.h"
#include "plot/figures/figures_run.h"
#include "study/scene/needed_gap.h"

enum { THUD_RUN_CASES_MAX = 1 + THUD_CASES };

struct thud_run_case {
    enum thud_case which; /* THUD_CASE_FREE: no pounding */
    struct thud_scene scene;
    struct thud_solution solution;
};

/* Freed by thud_run_cases_free. */
struct thud_run_cases {
    const struct thud_record *record; /* the session's; NULL: there is none */
    int measures;                     /* of the session's scene, for the names of cases */
    int n;                            /* no pounding, then the cases asked for */
    struct thud_run_case item[THUD_RUN_CASES_MAX];
    /* The required gap of the scene as written, and of that without its links where a case leaves them out; NULL: none
     * of the cases is like it. */
    struct thud_needed_gap *need, *need_without_links;
};

/* `text`: cases by name, `none,bumper`. Errors: THUD_USAGE, and those of thud_session_run. */
enum thud_status thud_run_cases_make(struct thud_session *session, const char *text,
                                     const struct thud_run_options *options, struct thud_run_cases **out,
                                     struct thud_error *err);
void thud_run_cases_free(struct thud_run_cases *cases);
/* Peaks of accelerations and deflections side by side, largest forces, sentences. */
void thud_run_cases_table(const struct thud_run_cases *cases, struct thud_text *out);
/* For figures; source (THUD_RUN_CASES_MAX). Returns how many. */
int thud_run_cases_sources(const struct thud_run_cases *cases, struct thud_figure_source *source);
