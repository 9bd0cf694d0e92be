/* Figure of the impact law of one interface: two free bodies of the floors' masses meet at three speeds. */
#pragma once

#include "plot/figure/figure.h"
#include "study/scene/scene.h"

/* Returns the mass of the lowest floor of structure `s`, kg; infinite for a wall that moves with the ground. */
double thud_law_mass(const struct thud_scene *scene, int s);

/* Result of two free bodies of the lowest floors' masses that meet at `speed_mps`. */
struct thud_meeting {
    double speed_mps, force_n, indentation_m, restitution;
};
enum { THUD_MEETINGS = 3 };
/* Scene whose loops are drawn dashed behind. */
struct thud_law_behind {
    const struct thud_scene *scene; /* NULL: nothing */
    const char *name;               /* "before", or the design's */
    struct thud_meeting *meeting;   /* (THUD_MEETINGS) of it; untouched where nothing is drawn */
};
/* Draws force against indentation at three speeds; behind them those of another scene, where its law or bodies differ.
 * NULL on failure, with the reason. */
struct thud_figure *thud_figure_of_law(const struct thud_scene *scene, const struct thud_law_behind *behind, int pair,
                                       struct thud_meeting meeting[THUD_MEETINGS], struct thud_error *err);
