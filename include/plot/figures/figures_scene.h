/* Draws the scene: the buildings in elevation, heights to scale, and the analysis model beside them. */
#pragma once

#include "plot/figure/figure.h"
#include "study/scene/scene.h"

/* Ask thud_figure_check. */
struct thud_figure *thud_figure_of_scene(const struct thud_scene *scene, const char *name, const char *title);
