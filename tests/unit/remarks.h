/* The n-th remark (from 0) of what a test has. */
#pragma once

#include "study/sweep/remark.h"

static inline bool nth_remark(const struct thud_remark_scope *scope, unsigned about, int n, struct thud_error *out)
{
    struct thud_remarks found = thud_remarks_find(scope, about);
    const bool is = n < found.n;
    if (is)
        *out = found.item[n].said;
    thud_remarks_clear(&found);
    return is;
}

static inline bool nth_unusual(const struct thud_scene *scene, int n, struct thud_error *out)
{
    return nth_remark(&(struct thud_remark_scope){.scene = scene}, THUD_REMARK_SCENE, n, out);
}
