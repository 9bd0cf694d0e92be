/* Studies from inside: for the files of study only. */
#ifndef THUD_STUDY_SWEEP_PRIVATE_H
#define THUD_STUDY_SWEEP_PRIVATE_H

#include "core/trunk.h"
#include "study/answer.h"
#include "study/sweep.h"

struct thud_sweep_base {
    const struct thud_sweep_plan *plan;
    long index;
    struct thud_model *model;         /* case `none`, or as written where there is no bumper */
    const struct thud_record *record; /* NULL: no ground motion */
    struct thud_record *scaled;       /* owned, where the record itself is varied */
    struct thud_trunk *trunk;
    struct thud_sweep_level *level; /* (model->ncontacts); once done */
};

/* Everything 0; NULL when out of memory. */
struct thud_sweep_point *thud_sweep_point_create(int ncases, int nfloors, int ncontacts);
bool thud_sweep_has_bumper(const struct thud_scene *scene);

#endif
