/* Neighbours that linear links tie: their common modes. */
#pragma once

#include "base/arena.h"
#include "core/model/foundation.h"

/* Which structures move together: fills system[s] (nstructures), from 0, and tied[s], whether links act on them;
 * returns the number of systems. A system's structures stand one after the other. */
int thud_tie_systems(const struct thud_model_input *input, int *system, bool *tied);

/* Room in the model's arena for the tied structures and the rows of the links. */
size_t thud_tie_bytes(const struct thud_model_input *input, const int *system, const bool *tied);

/* The structures stand with modes of their own; puts the common modes of a system (its structures' own slices, one after
 * the other, taken together) in their place, with the damping that couples them. Errors: THUD_MEMORY, THUD_INPUT. */
enum thud_status thud_tie_system(struct thud_model *model, struct thud_arena *arena,
                                 const struct thud_model_input *input, int system, struct thud_error *err);
