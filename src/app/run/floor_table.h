/* Floor spectra as a table of their largest values. */
#pragma once

#include "base/text.h"
#include "study/sweep/floor_response.h"

void thud_floor_table(const struct thud_scene *scene, const struct thud_floor_spectra *spectra, struct thud_text *out);
