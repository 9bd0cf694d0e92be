/* Buildings by their matrix or modes: what has been read of them, and the lateral stiffness that follows. */
#pragma once

#include "study/scene/scene.h"

/* Shapes overlap by no more than this: largest off-diagonal element of Phi^T M Phi. */
#define THUD_OVERLAP_MOST 0.02

/* Values in a row of a structure's part of the scene's shape. */
int thud_shape_columns(const struct thud_structure *structure);
/* That part, row after row; NULL: it has not been read. */
const double *thud_structure_shape(const struct thud_scene *scene, int structure);
/* Keeps what has been read in place of what was; parts of no structure are dropped. Errors: THUD_INPUT (no room). */
enum thud_status thud_structure_keep_shape(struct thud_scene *scene, int structure, int rows, const double *value,
                                           struct thud_error *err);
/* K (storeys x storeys), N/m. Errors: THUD_INPUT (not read, or shapes that overlap) with key, THUD_MEMORY. */
enum thud_status thud_structure_lateral(const struct thud_scene *scene, int structure, double *matrix_npm,
                                        struct thud_error *err);
/* The same without the matrix. */
enum thud_status thud_structure_check_shape(const struct thud_scene *scene, int structure, struct thud_error *err);

/* Whether it stands under its own weight: K - K_G of P-Delta is positive definite. Errors: THUD_INPUT with key,
 * THUD_MEMORY. */
enum thud_status thud_structure_check_weight(const struct thud_scene *scene, int structure, struct thud_error *err);
/* Whether a building by its matrix or modes bends as a wall does, its top storey drifting more than its lowest one in
 * its first mode, rather than as a frame: for pictures. */
struct thud_model_structure;
bool thud_structure_bends(const struct thud_structure *structure, const struct thud_model_structure *part);
