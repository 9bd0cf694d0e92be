/* Figure of floor spectra. */
#pragma once

#include "plot/figure/figure.h"
#include "study/sweep/floor_response.h"

/* Makes a panel for each of up to four floors, with a curve for each case. For more floors, it makes a panel for each
 * structure and case, with a curve for each floor. Ask thud_figure_check. */
struct thud_figure *thud_figure_of_floors(const struct thud_scene *scene, const struct thud_floor_spectra *spectra);
