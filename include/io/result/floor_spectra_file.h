/* Writes floor spectra as CSV and JSON in base SI units. */
#pragma once

#include "base/text.h"
#include "study/sweep/floor_response.h"

/* Writes one row per structure, floor and period. */
void thud_floor_spectra_csv(const struct thud_scene *scene, const struct thud_floor_spectra *spectra,
                            struct thud_text *out);
void thud_floor_spectra_json(const struct thud_scene *scene, const struct thud_floor_spectra *spectra,
                             struct thud_text *out);
