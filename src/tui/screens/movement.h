/* The buildings moving, drawn from the history that a run kept. */
#ifndef THUD_TUI_MOVEMENT_H
#define THUD_TUI_MOVEMENT_H

#include "core/model/model.h"
#include "core/run/run.h"
#include "study/scene/scene.h"
#include "tui/terminal/canvas.h"

/* Stick buildings at time `t`, displacements and gaps to one scale, heights to another; contacts flash with force and
 * indentation. `bumper`: the bumpers are there. Draws nothing where there is no room. */
void thud_movement_draw(const struct thud_pane *pane, const struct thud_scene *scene, const struct thud_model *model,
                        const struct thud_run *run, bool bumper, double t);

#endif
