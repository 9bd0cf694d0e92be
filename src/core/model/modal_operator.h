/* (x I + y D + z Omega^2)^-1 in modal coordinates: what every implicit linear scheme divides by. Diagonal, but for
 * structures whose damping D couples their modes, which have a dense block. */
#pragma once

#include <lapacke.h>

#include "base/arena.h"
#include "core/model/model.h"

struct thud_modal_operator {
    double *diagonal; /* (nmodes) the inverse */
    double *dense;    /* the inverse blocks of the coupled systems, one after the other, column-major */
    double *work;
    lapack_int *pivot;
};
/* Its arrays as pieces of a block (base/arena.h). */
#define THUD_MODAL_OPERATOR_PIECES(op, model)                                                                          \
    THUD_PIECE((op).diagonal, (model)->nmodes),                                                                        \
        THUD_PIECE((op).dense, ((model)->couples ? (model)->nmodes : 0) * (model)->nmodes),                            \
        THUD_PIECE((op).work, (model)->nmodes), THUD_PIECE((op).pivot, (model)->nmodes)

void thud_modal_operator_set(struct thud_modal_operator *op, const struct thud_model *model, double x, double y,
                             double z);
/* out (nmodes), which must not be in. */
void thud_modal_operator_apply(const struct thud_modal_operator *op, const struct thud_model *model,
                               const double *restrict in, double *restrict out);
/* The operator itself, not its inverse: out = x in + y D in + z Omega^2 in. */
void thud_modal_forward(const struct thud_model *model, double x, double y, double z, const double *in, double *out);
