/* Free vibration from inside: what its tables, its block, its series and its limits give each other. */
#pragma once

#include "core/motion/free_vibration.h"

enum {
    ENDS = THUD_FREE_VIBRATION_ENDS,
    THUD_FREE_VIBRATION_BOUNDS = 7 /* of derivatives up to the sixth */
};

/* What moves the modes of a system in the block. */
static inline struct thud_coupled_motion *thud_free_vibration_motion(const struct thud_free_vibration *f, int system)
{
    struct thud_coupled_motion *own = &f->coupled[system], *yielding = &f->coupled[f->nsystems + f->yields];
    return f->yields >= 0 && own->size > 0 && own->first_mode == yielding->first_mode ? yielding : own;
}

/* free_vibration_tables.c. Errors: THUD_MEMORY. */
enum thud_status thud_free_vibration_make_tables(const struct thud_state *state, struct thud_free_vibration *f,
                                                 struct thud_error *err);
/* Takes those of `like` where they are the same to the last bit, and no modes are coupled; whether they are. */
bool thud_free_vibration_copy_tables(struct thud_free_vibration *f, const struct thud_free_vibration *like);

/* free_vibration_block.c: the modal states at the ends of the intervals from the state on, and the modes' largest
 * speeds. Returns how many intervals: fewer where the storey that yields unloads in the last. */
int thud_free_vibration_fill(struct thud_free_vibration *f, const struct thud_state *state, int intervals);
/* -(Omega^2 x + D v), with Omega^2 + kappa g g^T while a storey yields, of the modes of a structure at the ends of the
 * block, all rows; where damping does not couple its modes, x is their places, and out of q - s. */
void thud_free_vibration_spring(const struct thud_free_vibration *f, const struct thud_model *m,
                                const struct thud_model_structure *p, const double *x, const double *v, double *out);

/* free_vibration_limits.c: intervals until a contact closes, or a storey yields or may collapse, at most `intervals`. */
int thud_free_vibration_until_contact(struct thud_free_vibration *f, const struct thud_state *state, int intervals);
int thud_free_vibration_until_yield(struct thud_free_vibration *f, const struct thud_state *state, int intervals);
int thud_free_vibration_until_collapse(struct thud_free_vibration *f, const struct thud_state *state, int intervals);
