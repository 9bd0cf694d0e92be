/* Studies from inside: for the files of study only. */
#ifndef THUD_STUDY_SWEEP_PRIVATE_H
#define THUD_STUDY_SWEEP_PRIVATE_H

#include "core/baseline.h"
#include "study/answer.h"
#include "study/sweep.h"

/* The motion without pounding of one variant. */
struct thud_sweep_baseline {
    struct thud_model *model;         /* case `none`, or as written where there is no bumper */
    const struct thud_record *record; /* NULL: no ground motion */
    struct thud_record *scaled;       /* owned, where the record itself is varied */
    struct thud_baseline_motion *baseline;
};

/* Gaps change no motion without pounding: as it is, then ground motion and stiffness less and more. */
enum { THUD_SWEEP_BASELINES = THUD_SWEEP_VARIANTS - 2 };

struct thud_sweep_group {
    const struct thud_sweep_plan *plan;
    long index;
    int nbaselines, ndone; /* nbaselines: 1, or THUD_SWEEP_BASELINES */
    struct thud_sweep_baseline baseline[THUD_SWEEP_BASELINES];
    struct thud_gap_level *level; /* (model->ncontacts); once done */
};

/* What a variant changes and by which factor; false for variant 0, the scene as it is. */
static inline bool thud_sweep_variant(const struct thud_sweep_plan *plan, int variant, enum thud_change *change,
                                      double *factor)
{
    *change = (enum thud_change)(variant > 0 ? (variant - 1) / 2 : 0);
    *factor = variant % 2 ? 1 - plan->sensitivity : 1 + plan->sensitivity;
    return variant > 0;
}

static inline const struct thud_sweep_baseline *thud_sweep_baseline(const struct thud_sweep_group *group, int variant)
{
    return &group->baseline[variant > 2 ? variant - 2 : 0]; /* variants 1 and 2 change the gap */
}

/* Everything 0; NULL when out of memory. */
struct thud_sweep_point *thud_sweep_point_create(int ncases, int nfloors, int ncontacts, int nvariants);
bool thud_sweep_has_bumper(const struct thud_scene *scene);

/* Of case k (k = ncases: no pounding) of a variant: (nfloors), (ncontacts). */
static inline struct thud_sweep_floor *thud_sweep_floors(const struct thud_sweep_point *point, int variant, int k)
{
    return point->floor + ((ptrdiff_t)variant * (point->ncases + 1) + k) * point->nfloors;
}

static inline struct thud_sweep_contact *thud_sweep_contacts(const struct thud_sweep_point *point, int variant, int k)
{
    return point->contact + ((ptrdiff_t)variant * point->ncases + k) * point->ncontacts;
}

/* Whether case k of a point is one that the plan has another point make for it. */
bool thud_sweep_reuses_reference(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point, int k);
/* What is left of an effort that another point made. */
void thud_sweep_effort_reused(struct thud_sweep_effort *effort);
/* Puts case `none` in place; false where the point has none. */
bool thud_sweep_reference_put(const struct thud_sweep_reference *reference, const struct thud_sweep_plan *plan,
                              struct thud_sweep_point *point);

#endif
