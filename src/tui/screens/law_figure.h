/* What the impact laws of one interface do. */
#pragma once

#include "plot/figure/figure.h"
#include "study/scene/scene.h"

/* Mass of the lowest floor of structure `s`, kg; infinite for a wall. */
double thud_tui_pair_mass(const struct thud_scene *scene, int s);

/* What came of two free bodies of the lowest floors' masses meeting at `speed`. */
struct thud_meeting {
    double speed_mps, force_n, indentation_m, restitution;
};
enum { THUD_MEETINGS = 3 };
/* What is drawn dashed behind the loops. */
struct thud_law_behind {
    const struct thud_scene *scene; /* NULL: nothing */
    const char *name;               /* "before", or the design's */
    struct thud_meeting *meeting;   /* (THUD_MEETINGS) of it; untouched where nothing is drawn */
};
/* Force against indentation at three speeds; behind them those of another scene, where its law or bodies are others.
 * NULL on failure, with the reason. */
struct thud_figure *thud_tui_law_figure(const struct thud_scene *scene, const struct thud_law_behind *behind, int pair,
                                        struct thud_meeting meeting[THUD_MEETINGS], struct thud_error *err);
