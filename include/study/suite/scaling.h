/* Ground motions selected and scaled to a design spectrum. */
#pragma once

#include <stdbool.h>

#include "base/text.h"
#include "ground/target.h"

struct thud_scaling {
    bool as_given;       /* compared with the target unscaled; all are selected */
    bool common;         /* all by one factor; else each to its least misfit, then all by one factor up to the rule */
    int count;           /* motions wanted; 0: all */
    double factor_most;  /* largest factor of a motion, and 1/factor_most the smallest; 4 by default */
    int per_event;       /* largest number of one event; 2 by default. One component of a station */
    bool vertical;       /* vertical components may be selected */
    double from_s, to_s; /* the periods that count */
};

struct thud_scaled_motion {
    double misfit; /* root mean square of the logarithms, once scaled alone */
    double factor; /* of the motion as it was read */
    bool chosen;
    char why[96];                                   /* not chosen: why */
    double peak_mps2, sa_mps2[THUD_TARGET_PERIODS]; /* before scaling */
};

struct thud_scaled_suite {
    int n, chosen;
    struct thud_scaled_motion *motion; /* (n) */
    bool narrowed;  /* fewer periods are used than requested, because of the time steps or the range of the target */
    double common;  /* the last factor, a part of all of them */
    double damping; /* of the spectra */
    double period_s[THUD_TARGET_PERIODS], target_mps2[THUD_TARGET_PERIODS], mean_mps2[THUD_TARGET_PERIODS];
    double ratio, ratio_s;            /* least mean over target, and its period */
    double mean_peak_mps2, zero_mps2; /* mean peak of the scaled motions, and the target's at T = 0 */
};

void thud_scaling_init(struct thud_scaling *scaling);

/* Scales by EN 1998-1 3.2.3.1.2(4). The mean of the scaled spectra is at no period below 90 % of the target, and the
 * mean at T = 0 is not below a_g S (except for a target of points without T = 0). `target` NULL: no scaling, all chosen
 * with factor 1, spectra of 5 % only. Chooses the `count` best fits, or fewer, with the reason in `out->motion[].why`.
 * Only periods that the motions resolve (four samples) and the target has count; out->narrowed: fewer than requested.
 * Errors: THUD_INPUT (no such period, nothing to choose from), THUD_MEMORY. */
enum thud_status thud_suite_scale(const struct thud_record *const *record, int n, const struct thud_target *target,
                                  const struct thud_scaling *scaling, struct thud_scaled_suite *out,
                                  struct thud_error *err);
void thud_scaled_suite_clear(struct thud_scaled_suite *suite);
