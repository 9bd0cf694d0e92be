/* What a scene needs: every simplification that applies to it, what it changes and what it saves, and those of them put
 * together that keep an accuracy. Pure: whoever owns a clock times the evaluations. */
#pragma once

#include "study/scene/solution.h"

enum thud_simplify_group { THUD_SIMPLIFY_MODEL, THUD_SIMPLIFY_CONTACT, THUD_SIMPLIFY_MOTION, THUD_SIMPLIFY_METHOD };
const char *thud_simplify_group_name(enum thud_simplify_group group);

/* Against the full run: the largest difference of a peak over the largest peak of its group there (accelerations and
 * drifts: of the same building), and of the required gap over itself. Peaks below 1 % of the largest of their kind in both
 * runs are not compared. INFINITY: contacts or a collapse in one run alone, or a peak that is lost. NaN: no such peaks. */
struct thud_simplify_change {
    double acceleration, drift, force, gap;
    double all;  /* the largest */
    int impacts; /* of all cases */
};

struct thud_simplification {
    char words[120];
    enum thud_simplify_group group;
    bool information; /* no key says it, or it saves nothing: never a step of the cheapest */
    bool failed;      /* it has no result */
    struct thud_simplify_change change;
    int inputs;        /* numbers that have to be known with it */
    double work;       /* steps and evaluations times modes, over those of the full run */
    double seconds;    /* of its evaluation, by who times; 0: not taken */
    int row, at, size; /* its row in the table, and what of the scene: private */
};

enum { THUD_SIMPLIFY_MAX = 128, THUD_SIMPLIFY_CASES = THUD_CASES + 1 };
struct thud_simplify_ask {
    double within; /* 0.05 */
    int ncases;    /* 0: as written */
    enum thud_case cases[THUD_SIMPLIFY_CASES];
    bool suite; /* the record is one of several: what is said of its file alone is left out */
};

struct thud_simplify;
/* `scene` is copied; `record` (NULL: none) stays the caller's and is as the scene's record says. Errors: THUD_MEMORY. */
enum thud_status thud_simplify_create(const struct thud_scene *scene, const struct thud_record *record,
                                      const struct thud_simplify_ask *ask, struct thud_simplify **out,
                                      struct thud_error *err);
void thud_simplify_free(struct thud_simplify *simplify);

/* One evaluation: the full run, what 0.1 % of input moves, a simplification, or a step of the cheapest. *timed: the
 * simplification whose `seconds` it took, or NULL. Errors: of the full run, those of thud_scene_solve; THUD_MEMORY. */
enum thud_status thud_simplify_advance(struct thud_simplify *simplify, struct thud_simplification **timed, bool *done,
                                       struct thud_error *err);
int thud_simplify_runs(const struct thud_simplify *simplify); /* made so far, on one motion */

int thud_simplify_count(const struct thud_simplify *simplify);
const struct thud_simplification *thud_simplify_at(const struct thud_simplify *simplify, int i);
/* The full run itself (change 0), and the cheapest of all. */
const struct thud_simplification *thud_simplify_full(const struct thud_simplify *simplify);
const struct thud_simplification *thud_simplify_cheapest(const struct thud_simplify *simplify);
bool thud_simplification_within(const struct thud_simplify *simplify, const struct thud_simplification *of);
double thud_simplify_within(const struct thud_simplify *simplify);
/* The largest change of 0.1 % more or less of an input; NaN: not known. */
double thud_simplify_moved(const struct thud_simplify *simplify);
/* The steps of the cheapest, in the order in which they were found; the i-th, by its index. */
int thud_simplify_steps(const struct thud_simplify *simplify);
int thud_simplify_step(const struct thud_simplify *simplify, int i);
/* The scene with these steps: its keys say all of them. */
const struct thud_scene *thud_simplify_scene(const struct thud_simplify *simplify);

/* The cheapest on another ground motion, against the full scene there. Errors: as thud_simplify_advance. */
enum thud_status thud_simplify_try(struct thud_simplify *simplify, const struct thud_record *record,
                                   struct thud_simplify_change *out, struct thud_error *err);
/* Takes its last step back. */
void thud_simplify_step_back(struct thud_simplify *simplify);
