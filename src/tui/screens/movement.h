/* The buildings moving, drawn from the history that a run kept. */
#pragma once

#include "core/model/model.h"
#include "core/run/run.h"
#include "study/scene/scene.h"
#include "tui/terminal/canvas.h"

/* The floor (from 1) of a building nearest to an elevation, one that has a storey below it. */
int thud_storey_at(const struct thud_structure *structure, double level_m);
/* The floor (from 1) of a building drawn at a place of that pane, and its structure (from 0); 0: there is none. */
int thud_movement_floor(const struct thud_pane *pane, const struct thud_scene *scene, const struct thud_model *model,
                        const struct thud_run *run, int x, int y, int *structure);
/* Stick buildings at time `t`, displacements and gaps to one scale, heights to another; contacts flash with force and
 * indentation. `bumper`: the bumpers are there. Draws nothing where there is no room. */
void thud_movement_draw(const struct thud_pane *pane, const struct thud_scene *scene, const struct thud_model *model,
                        const struct thud_run *run, bool bumper, double t);
