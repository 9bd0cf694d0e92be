/* Runs beside the paper's study, for what its text says of other numbers of storeys, of the stiffness of impact, and of
 * the two bodies. */
#ifndef THUD_APP_PAPER_RUNS_H
#define THUD_APP_PAPER_RUNS_H

#include "app/sweep/sweep_jobs.h"
#include "app/sweep/sweep_table.h"

/* The towers without bumper at their own gap, with another stiffness of the concrete. */
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

/* Two bodies of 320 t with the bumper. */
struct thud_paper_collision {
    double approach_mps, nominal, force_n, indentation_m, restitution;
};
enum { THUD_PAPER_FIG3 = 3, THUD_PAPER_SLOW = THUD_PAPER_FIG3, THUD_PAPER_COLLISIONS };
/* Those of Fig. 3, and one at 0.25 m/s. Errors: those of runs. */
enum thud_status thud_paper_collisions(struct thud_paper_collision *out, struct thud_error *err);

#endif
