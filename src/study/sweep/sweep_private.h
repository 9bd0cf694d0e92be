/* Studies from inside: for the files of study only. */
#pragma once

#include "core/run/baseline.h"
#include "study/scene/solution.h"
#include "study/sweep/sweep.h"

/* The motion without pounding of one variant. */
struct thud_sweep_baseline {
    struct thud_model *model;
    const struct thud_record *record; /* NULL: no ground motion */
    struct thud_record *scaled;       /* owned, where the record itself is varied */
    struct thud_baseline_motion *baseline;
};

/* With the links of the scene, and without them for the cases that leave them out. */
enum { THUD_SWEEP_LINKED, THUD_SWEEP_UNLINKED, THUD_SWEEP_LINKAGES };

/* Gaps change no motion without pounding: nominal, then ground motion and stiffness less and more. */
enum { THUD_SWEEP_BASELINES = THUD_SWEEP_VARIANTS - 2 };

struct thud_sweep_group {
    const struct thud_sweep_plan *plan;
    long index;
    int nlinkages;         /* 1 where the scene has no links, else THUD_SWEEP_LINKAGES */
    int nbaselines, ndone; /* nbaselines: of each linkage, 1 or THUD_SWEEP_BASELINES */
    struct thud_sweep_baseline baseline[THUD_SWEEP_LINKAGES][THUD_SWEEP_BASELINES];
    struct thud_gap_level *level;      /* (nlinkages x model->npairs); once done */
    bool aligned[THUD_STRUCTURES_MAX]; /* by interface: thud_gap_aligned */
    struct thud_sweep_same *same;
};

/* What a variant changes and by which factor; false for variant 0, the nominal scene. */
static inline bool thud_sweep_variant(const struct thud_sweep_plan *plan, int variant, enum thud_change *change,
                                      double *factor)
{
    *change = (enum thud_change)(variant > 0 ? (variant - 1) / 2 : 0);
    *factor = variant % 2 ? 1 - plan->sensitivity : 1 + plan->sensitivity;
    return variant > 0;
}

/* Of so many that there are, that of a case. */
static inline int thud_sweep_linkage(int nlinkages, enum thud_case which)
{
    return nlinkages > 1 && !thud_case_has_links(which) ? THUD_SWEEP_UNLINKED : THUD_SWEEP_LINKED;
}

static inline const struct thud_sweep_baseline *thud_sweep_baseline(const struct thud_sweep_group *group, int variant,
                                                                    enum thud_case which)
{
    return &group->baseline[thud_sweep_linkage(group->nlinkages, which)]
                           [variant > 2 ? variant - 2 : 0]; /* variants 1 and 2 change the gap */
}

/* Floors of all structures, which have peaks; the dofs of foundations have none. */
static inline int thud_sweep_floor_count(const struct thud_model *model)
{
    int floors = 0;
    for (int s = 0; s < model->nstructures; s++)
        floors += model->structure[s].n;
    return floors;
}

/* A case of a point's scene, as a variant changes it. `check`: refuses what is not possible. Errors: THUD_INPUT. */
enum thud_status thud_sweep_case(const struct thud_sweep_plan *plan, const struct thud_scene *scene,
                                 enum thud_case which, int variant, bool check, struct thud_scene *cased,
                                 struct thud_error *err);
/* What a run of it needs. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_sweep_model(const struct thud_scene *cased, struct thud_model **model,
                                  struct thud_run_options *options, struct thud_error *err);

/* Everything 0; NULL when out of memory. */
struct thud_sweep_point *thud_sweep_point_create(int ncases, int nfloors, int ncontacts, int nlinkages, int nvariants);

/* Of case k (k = ncases: no pounding) of a variant: (nfloors), (ncontacts). */
static inline struct thud_sweep_floor *thud_sweep_floors(const struct thud_sweep_point *point, int variant, int k)
{
    return point->floor + ((ptrdiff_t)variant * (point->ncases + 1) + k) * point->nfloors;
}

static inline struct thud_sweep_contact *thud_sweep_contacts(const struct thud_sweep_point *point, int variant, int k)
{
    return point->contact + ((ptrdiff_t)variant * point->ncases + k) * point->ncontacts;
}

/* Which runs of a group are the same; NULL: none is shared. Made in slices once the group's model is there. */
enum thud_status thud_sweep_same_create(const struct thud_sweep_plan *plan, struct thud_sweep_same **out,
                                        struct thud_error *err);
enum thud_status thud_sweep_same_advance(struct thud_sweep_group *group, long budget, bool *done,
                                         struct thud_error *err);
void thud_sweep_same_free(struct thud_sweep_same *same);
/* Whether case k of a point has the result of an earlier run. */
bool thud_sweep_is_made_before(const struct thud_sweep_group *group, long point, int k);
/* What is left of an effort that another run made. */
void thud_sweep_effort_taken(struct thud_sweep_effort *effort);
/* The cases of a point (THUD_SWEEP_CASES_MAX + 1): the plan's, and `none` after them where the ratios need it. Returns
 * how many. */
int thud_sweep_point_cases(const struct thud_sweep_plan *plan, const struct thud_scene *scene, enum thud_case *which);

/* Gap and bumper of a contact in the case k of a point of that scene. */
struct thud_level_values thud_sweep_level_values(const struct thud_scene *scene, const struct thud_sweep_point *point,
                                                 int k, int contact);
