/* (x I + y D + z Omega^2)^-1 in modal coordinates: what every implicit linear scheme divides by. Diagonal, but for
 * structures whose damping D couples their modes, which have a dense block. */
#pragma once

#include "base/status.h"
#include "core/model/model.h"

struct thud_modal_operator;

/* Errors: THUD_MEMORY. */
enum thud_status thud_modal_operator_create(const struct thud_model *model, struct thud_modal_operator **out,
                                            struct thud_error *err);
void thud_modal_operator_free(struct thud_modal_operator *op);

void thud_modal_operator_set(struct thud_modal_operator *op, const struct thud_model *model, double x, double y,
                             double z);
/* out (nmodes), which must not be in. */
void thud_modal_operator_apply(const struct thud_modal_operator *op, const struct thud_model *model,
                               const double *restrict in, double *restrict out);
/* The operator itself, not its inverse: out = x in + y D in + z Omega^2 in. */
void thud_modal_forward(const struct thud_model *model, double x, double y, double z, const double *in, double *out);
