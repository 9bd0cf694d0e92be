/* A building of which only the outside is known. H: its height above the ground that it stands on, in m.
 *
 *     EN 1998-1:2004, 4.3.3.2.2(3)   T = C_t H^0.75   C_t 0.085 steel frames, 0.075 concrete frames, 0.050 others
 *     ASCE/SEI 7-16, 12.8.2.1        T = C_t H^x      C_t, x 0.0724, 0.8 steel frames, 0.0466, 0.9 concrete frames,
 *                                                     0.0488, 0.75 others
 *
 * Storeys are equally stiff, and have the first of both periods. */
#include <math.h>
#include <stdlib.h>

#include "base/quantity.h"
#include "core/model/modes.h"
#include "study/scene/building.h"

/* By enum thud_system; a wall and masonry are "other structures" in both codes. */
static const struct {
    double en1998_ct, asce7_ct, asce7_x;
} systems[] = {{0.075, 0.0466, 0.9}, {0.085, 0.0724, 0.8}, {0.050, 0.0488, 0.75}, {0.050, 0.0488, 0.75}};

struct thud_estimate thud_structure_estimate(const struct thud_structure *s)
{
    double height = 0;
    for (int i = 0; i < s->storeys; i++)
        height += s->height_m[i];
    const int system = (int)s->system;
    return (struct thud_estimate){.height_m = height,
                                  .en1998_s = systems[system].en1998_ct * pow(height, 0.75),
                                  .asce7_s = systems[system].asce7_ct * pow(height, systems[system].asce7_x)};
}

/* omega^2 goes with the stiffnesses: all of them times (2 pi/T)^2/omega^2. Equal ones where they are not given. Those
 * that have this period already keep their bits, so that filling in twice is no change of the scene. */
static void fill_period(struct thud_structure *s, double period_s)
{
    const int n = s->storeys;
    bool known = period_s > 0, given = true;
    for (int i = 0; i < n; i++) {
        known &= s->mass_kg[i] > 0;
        given &= s->stiffness_npm[i] > 0;
    }
    double *omega = known ? malloc((size_t)(2 * n * n + 4 * n) * sizeof *omega) : NULL;
    if (!omega)
        return;
    for (int i = 0; i < n && !given; i++)
        s->stiffness_npm[i] = THUD_GRAVITY * s->mass_kg[0];
    if (thud_modes_shear(n, s->mass_kg, s->stiffness_npm, omega, omega + n, omega + n + n * n, NULL) == THUD_OK) {
        const double factor = 2 * THUD_PI / period_s / omega[0];
        for (int i = 0; i < n && fabs(factor - 1) > 1e-12; i++)
            s->stiffness_npm[i] *= factor * factor;
    }
    free(omega);
}

/* The period of an estimated building: given, or by the code. */
static double estimated_period(const struct thud_structure *s)
{
    return s->period_factor * (s->period_s > 0 ? s->period_s : thud_structure_estimate(s).en1998_s);
}

void thud_structure_fill_estimate(struct thud_structure *s)
{
    for (int i = 0; i < s->storeys && thud_kind_is_building(s->kind); i++) {
        if (s->area_m2 > 0 && s->load_pa[i] > 0)
            s->mass_kg[i] = s->area_m2 * s->load_pa[i] / THUD_GRAVITY;
        else if (s->kind == THUD_ESTIMATED)
            s->mass_kg[i] = THUD_ESTIMATE_KGPM2 * s->area_m2;
    }
    if (s->kind == THUD_SHEAR)
        fill_period(s, s->period_s);
    if (s->kind != THUD_ESTIMATED)
        return;
    for (int i = 1; i < s->storeys; i++)
        s->stiffness_npm[i] = s->stiffness_npm[0];
    fill_period(s, estimated_period(s));
}
