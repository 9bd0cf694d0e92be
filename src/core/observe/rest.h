/* The rest of a run, what comes after a moment, as bounds: the contact-free baseline, whose largest values to come are
 * known, and a free vibration beside it, whose amplitudes are (run/early_end.h). */
#pragma once

#include "core/model/model.h"
#include "core/model/result.h"

struct thud_rest {
    const struct thud_model *model;
    const double *later;      /* (quantities x ndof) of the floors in the baseline */
    const double *amplitudes; /* (nmodes) of the difference from it */
};

/* Largest size that a floor's values come to, by quantity. */
void thud_rest_floor(const struct thud_rest *rest, int structure, int floor, double most[THUD_FLOOR_QUANTITIES]);
/* Largest size that the shear of a storey of a building by its matrix comes to. */
double thud_rest_shear(const struct thud_rest *rest, int structure, int storey);
/* Largest drift on which the weight acts, on soil. */
double thud_rest_lean(const struct thud_rest *rest, int structure, int floor);
/* Largest overturning moment of a building that has no links. */
double thud_rest_moment(const struct thud_rest *rest, int structure);
/* Largest drift of a column's storey. */
double thud_rest_drift(const struct thud_rest *rest, const struct thud_model_column *column);
