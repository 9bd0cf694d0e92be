/* Simplification of a scene: every one that applies, its change and saving, and the combination that keeps an accuracy.
 * Pure: the owner of a clock times the evaluations. */
#pragma once

#include "study/scene/solution.h"

enum thud_simplify_group { THUD_SIMPLIFY_MODEL, THUD_SIMPLIFY_CONTACT, THUD_SIMPLIFY_MOTION, THUD_SIMPLIFY_METHOD };
const char *thud_simplify_group_name(enum thud_simplify_group group);

/* Difference from the full run. Each peak is relative to the largest peak of its group in the full run (accelerations
 * and drifts: of the same building), and the required gap to itself. Peaks below 1 % of the largest of their kind in
 * both runs are not compared. INFINITY: contacts or a collapse in one run only, or a lost peak. NaN: no such peaks. */
struct thud_simplify_change {
    double acceleration, drift, force, gap;
    double all;  /* the largest */
    int impacts; /* of all cases */
};

struct thud_simplification {
    char words[120];
    char input[100]; /* what need not be known with it; empty: nothing */
    enum thud_simplify_group group;
    bool information; /* no key says it, or it is only compared: never a step of the cheapest */
    bool failed;      /* it has no result */
    struct thud_simplify_change change;
    double median, worst; /* change over several ground motions, where it was run on all of them; NaN: it was not */
    int inputs;           /* numbers that have to be known with it */
    double work;          /* steps and evaluations times modes, over those of the full run; NaN: of another method */
    double seconds;       /* of its evaluation, by who times; 0: not taken */
    int row, at, size;    /* its row in the table, and what of the scene: the same row and place, a curve of sizes */
};

enum { THUD_SIMPLIFY_MAX = 160, THUD_SIMPLIFY_CASES = THUD_CASES + 1 };
struct thud_simplify_ask {
    double within; /* 0.05 */
    int ncases;    /* 0: as written */
    enum thud_case cases[THUD_SIMPLIFY_CASES];
    bool no_methods;  /* nothing is compared with other methods */
    double work_most; /* steps and evaluations times modes after which nothing more is tried; 0: no limit */
};

/* Results so far. */
struct thud_simplify_found {
    double within;
    double moved;                    /* the largest change by 0.1 % more or less of an input; NaN: not known */
    int runs;                        /* on the one ground motion, or the governing one */
    int nmotions, governing;         /* from 0: largest contact force, without contact largest required gap */
    struct thud_simplification full; /* the full run itself: change 0 */
    struct thud_simplification cheapest, one[THUD_SIMPLIFY_MAX];
    int untried;                           /* rows that were not run, since the runs or the work were at their limit */
    int n, steps, step[THUD_SIMPLIFY_MAX]; /* of the cheapest in the order in which they were found, by their indices */
    struct thud_scene scene;               /* with these steps: its keys say all of them */
};
bool thud_simplification_within(const struct thud_simplify_found *found, const struct thud_simplification *of);

struct thud_simplify;
/* Creates the study. `scene` is copied; the records (n 0: none) stay the caller's and are as the scene's record states.
 * With several motions, the search uses the governing one. Its cheapest model is then run on all, and its last steps
 * are removed until the accuracy holds for all. Errors: THUD_MEMORY. */
enum thud_status thud_simplify_create(const struct thud_scene *scene, struct thud_record *const *record, int n,
                                      const struct thud_simplify_ask *ask, struct thud_simplify **out,
                                      struct thud_error *err);
void thud_simplify_free(struct thud_simplify *simplify);
const struct thud_simplify_found *thud_simplify_found(const struct thud_simplify *simplify);

/* Makes one evaluation: the full run, the effect of 0.1 % of input, a simplification, a step of the cheapest, or one on
 * another ground motion. *seconds: where its time belongs, or NULL. Errors: of the full run, those of thud_scene_solve;
 * THUD_MEMORY. */
enum thud_status thud_simplify_advance(struct thud_simplify *simplify, double **seconds, bool *done,
                                       struct thud_error *err);
