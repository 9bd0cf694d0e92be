/* Limits of methods: every method over its steps in free vibration, on a wall spring from several initial conditions,
 * and in the scene. Also the restitution actually obtained, and scenes in which a naive method fails.
 *
 * A contact that opens and closes has no spectral radius. At one step, the energy grows a hundredfold from some initial
 * conditions and is kept from others. The verdict is therefore based on the energy in the worst of several runs. */
#pragma once

#include "study/methods/time_stepping.h"
#include "study/scene/solution.h"

enum thud_stability_verdict { THUD_VERDICT_NONE, THUD_BOUNDED, THUD_GROWING, THUD_BLOWN_UP };
const char *thud_stability_verdict_word(enum thud_stability_verdict verdict);

enum { THUD_STABILITY_FREE, THUD_STABILITY_WALL, THUD_STABILITY_SCENE, THUD_STABILITY_KINDS };

/* Initial distances of the mass from the wall, and steps tried for one cell of the scene. */
enum { THUD_STABILITY_STARTS = 8, THUD_STABILITY_SCENE_STEPS = 3 };

/* A method at a step; INFINITY: diverged. `growth` is a ratio. Free vibration: largest energy in the second half of 50
 * s over that in the first, so oscillations of a stable method have no effect; one initial condition is enough, since
 * the system is linear. Wall: largest energy within 50 s over the initial energy, for the worst initial condition.
 * Scene: largest displacement over the exact one, for the worst floor and step (up to 6 % shorter). */
struct thud_stability_cell {
    struct thud_stepping how;
    double omega_dt; /* omega of the oscillator, the wall spring or the scene's fastest mode; NaN: adaptive steps */
    enum thud_stability_verdict verdict[THUD_STABILITY_KINDS];
    double growth[THUD_STABILITY_KINDS];
    double end_least, end_most; /* energy after 50 s at the wall over that at the start, of all starts */
};

/* Collision of two free bodies. */
struct thud_stability_restitution {
    const struct thud_law *law;
    struct thud_stepping how;
    double nominal;                          /* coefficient of restitution; NaN: the law has none */
    double approach_mps, expected, obtained; /* by the law, by the method; NaN: diverged */
};

/* Summary of a method in one row. Steps in s (tolerances of a method with adaptive steps); NaN: not known, or none. */
struct thud_stability_summary {
    struct thud_stepping how;
    double order; /* of the time of the fourth impact on the wall spring, 4 ms to 1 ms; NaN: adaptive steps, or exact */
    double keeps[2];              /* largest step that keeps the scene's peaks and impacts to 10 % and to 1 % */
    double diverges_s;            /* smallest step of the scene's verdicts that diverges */
    double wall_least, wall_most; /* energy after 50 s on the wall spring over that at the start, omega dt 0.5 */
    double expected, obtained;    /* restitution of concrete of 0.5 at 0.5 m/s in steps of 1 ms */
};

/* Test case: a small scene in which a naive method fails. */
struct thud_test_case {
    const char *name, *scene, *quantity;
    const char *method;            /* the naive one */
    double exact, naive, computed; /* the quantity: exact, by the naive method (INFINITY: diverged), by thud */
};

struct thud_bench_solution;
struct thud_stability {
    struct thud_stability_cell *cell;
    struct thud_stability_restitution *restitution;
    struct thud_test_case *test_case;
    struct thud_stability_summary *summary; /* without what thud_stability_summary_of reads from the other lists */
    int ncells, nrestitutions, ntest_cases, nsummaries;
    struct thud_model *model;
    const struct thud_record *record;
    struct thud_run_options options;
    struct thud_bench_solution *exact; /* peaks and impacts of the scene */
    double *peak_m;                    /* (ndof) of the scene by the exact method; NULL: no scene, or none with modes */
    double fastest_radps;
};

/* Creates the study. `scene` (of a case; NULL: none) is not kept, the record must outlive it. Errors: THUD_MEMORY,
 * those of thud_scene_solve. */
enum thud_status thud_stability_create(const struct thud_scene *scene, const struct thud_record *record,
                                       struct thud_stability **out, struct thud_error *err);
void thud_stability_free(struct thud_stability *stability);
int thud_stability_jobs(const struct thud_stability *stability);
/* Runs a job (from 0), which writes its own row. Several may run at the same time, each once. Errors: THUD_MEMORY, and
 * THUD_DIVERGED of an exact method. */
enum thud_status thud_stability_job(struct thud_stability *stability, int job, struct thud_error *err);
/* Returns a summary (from 0) after all jobs. */
struct thud_stability_summary thud_stability_summary_of(const struct thud_stability *stability, int i);

/* Count the test cases, and run one (from 0). Errors: THUD_MEMORY, and THUD_DIVERGED of an exact method. */
int thud_test_case_count(void);
enum thud_status thud_test_case_run(int index, struct thud_test_case *out, struct thud_error *err);
