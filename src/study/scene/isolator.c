/* Isolators as a person gives them, and the bilinear loop that follows. */
#include <math.h>

#include "base/quantity.h"
#include "study/scene/scene.h"
#include "study/scene/scene_slot.h"

static const double pendulum_yield_m = 1e-3, linear_damping = 0.1;

double thud_isolated_weight(const struct thud_structure *s)
{
    return THUD_GRAVITY * s->base_mass_kg + thud_structure_weight(s, 0);
}

void thud_isolator_keep_own(struct thud_structure *s)
{
    const unsigned law = 1u << (int)s->isolator_law;
    if (s->isolator_law != THUD_ISOLATOR_LINEAR)
        s->isolation_stiffness_npm = NAN;
    const struct thud_place *place;
    for (int i = 1; (place = thud_group_place(THUD_GROUP_ISOLATOR, i)); i++)
        if (place->store == THUD_STORE_NUMBER && !(place->laws & law))
            *(double *)(void *)((char *)s + place->offset) = NAN;
}

struct thud_isolator thud_structure_isolator(const struct thud_structure *s)
{
    const enum thud_isolator_law law = (enum thud_isolator_law)s->isolator_law;
    struct thud_isolator out = {law, s->isolation_stiffness_npm, INFINITY, 1,
                                isnan(s->isolation_damping) ? linear_damping : s->isolation_damping};
    if (law == THUD_ISOLATOR_LINEAR)
        return out;
    double strength = s->isolator_strength_n, beyond = s->isolator_post_yield_npm;
    out.yield_m = s->isolator_yield_m;
    if (law == THUD_ISOLATOR_PENDULUM) {
        const double weight = thud_isolated_weight(s);
        strength = s->isolator_friction * weight;
        beyond = weight / s->isolator_radius_m;
        out.yield_m = isnan(out.yield_m) ? pendulum_yield_m : out.yield_m;
    }
    out.stiffness_npm = strength / out.yield_m + beyond;
    out.hardening = beyond / out.stiffness_npm;
    out.damping = isnan(s->isolation_damping) ? 0 : s->isolation_damping; /* the loop has its own */
    return out;
}
