/* Buildings by their matrix or modes: the data read, and the resulting lateral stiffness. */
#pragma once

#include "study/scene/scene.h"

/* Largest permitted overlap of shapes: off-diagonal elements of Phi^T M Phi. */
#define THUD_OVERLAP_MOST 0.02

/* Returns the number of values in a row of a structure's part of the scene's shape. */
int thud_shape_columns(const struct thud_structure *structure);
/* Returns that part, row after row; NULL: not read yet. */
const double *thud_structure_shape(const struct thud_scene *scene, int structure);
/* Replaces the data of a building; parts of no structure are dropped. Errors: THUD_INPUT (no room). */
enum thud_status thud_structure_keep_shape(struct thud_scene *scene, int structure, int rows, const double *value,
                                           struct thud_error *err);
/* Computes K (storeys x storeys), N/m. Errors: THUD_INPUT (not read, or shapes that overlap) with key, THUD_MEMORY. */
enum thud_status thud_structure_lateral(const struct thud_scene *scene, int structure, double *matrix_npm,
                                        struct thud_error *err);
/* Checks the same without the matrix. */
enum thud_status thud_structure_check_shape(const struct thud_scene *scene, int structure, struct thud_error *err);

/* Checks that a building is stable under its weight: K - K_G of P-Delta is positive definite. Errors: THUD_INPUT with
 * key, THUD_MEMORY. */
enum thud_status thud_structure_check_weight(const struct thud_scene *scene, int structure, struct thud_error *err);
/* Foundation, springs and dashpots of a building on soil. Values that are not given follow for a disk of radius a on an
 * elastic half-space, with static stiffnesses and dashpots of the waves that travel down (Gazetas 1991, Formulas and
 * charts for impedances of surface and embedded foundations, J. Geotech. Eng. 117(9)):
 *
 *     K_x = 8 G a/(2 - nu),   C_x = rho V_s A,          G = rho V_s^2,  A = pi a^2
 *     K_t = 8 G a^3/(3 (1 - nu)),   C_t = rho V_p I,    V_p = V_s sqrt(2 (1 - nu)/(1 - 2 nu)),  I = pi a^4/4
 *
 * NaN where neither is given. */
struct thud_foundation_input;
struct thud_foundation_input thud_structure_foundation(const struct thud_structure *structure);
/* Checks a foundation. Errors: THUD_INPUT with key. */
enum thud_status thud_structure_check_foundation(const struct thud_structure *structure, int index,
                                                 struct thud_error *err);

/* Returns whether a building given by its matrix or modes deforms like a wall: its top storey drifts more than its
 * lowest in the first mode. For pictures. */
struct thud_model_structure;
bool thud_structure_bends(const struct thud_structure *structure, const struct thud_model_structure *part);

/* Estimated building: floors of 1 t/m2 (weight of the structure, finishes and part of the live load), and the first
 * period by height and system (estimate.c). Measured periods lie between 0.7 and 1.4 times such estimates. */
#define THUD_ESTIMATE_KGPM2 1000.0
#define THUD_ESTIMATE_LEAST 0.7
#define THUD_ESTIMATE_MOST  1.4
struct thud_estimate {
    double height_m, en1998_s, asce7_s; /* the first period is used */
};
struct thud_estimate thud_structure_estimate(const struct thud_structure *structure);
/* Returns whether its period is known by an estimate only. */
static inline bool thud_period_is_estimated(const struct thud_structure *structure)
{
    return structure->kind == THUD_ESTIMATED && !(structure->period_s > 0);
}
/* Computes masses from area and load, if they are given. For an estimated building, computes masses from the area, and
 * stiffnesses from its period (given, or by EN 1998-1) times period_factor. Scales the stiffnesses of a shear building
 * to its given first period. */
void thud_structure_fill_estimate(struct thud_structure *structure);
/* Properties of a storey (from 0): V_y, u_y and V_y/W are NaN if it is elastic, and so is k of a building by matrix or
 * modes. */
struct thud_storey {
    double stiffness_npm, weight_n, yield_shear_n, yield_m, yield_ratio; /* W: of this floor and those above */
};
struct thud_storey thud_storey_of(const struct thud_structure *structure, int i);
