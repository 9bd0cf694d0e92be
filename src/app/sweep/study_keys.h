/* The varied keys of a preset's study as text, and its plan. */
#pragma once

#include <stdbool.h>

#include "study/sweep/sweep.h"

/* "gap=5 cm:25 cm:0.5 cm" of each varied key, empty behind the last; where the study has neither keys nor cases over
 * ground motions, the range of gaps that is proposed. */
void thud_study_vary_texts(const struct thud_scene *scene, char text[THUD_VARY_MAX][THUD_VARY_TEXT]);
/* Makes the keys of those texts that are not empty the varied keys of the scene's study. Every value they name is tried
 * first. A range beside a list becomes a list. The cases that were proposed are kept with them. Errors: THUD_USAGE
 * (also where a preset has no room for so long a list), THUD_INPUT, THUD_MEMORY; the scene is then as it was. */
enum thud_status thud_study_vary_keep(char text[THUD_VARY_MAX][THUD_VARY_TEXT], struct thud_scene *scene,
                                      struct thud_error *err);
/* "none,bumper" where the study has no cases of its own and varies nothing; else NULL. */
const char *thud_study_proposed_cases(const struct thud_scene *scene);
/* What `thud sweep` plans, with what is proposed, to be cleared also after an error. Errors: THUD_USAGE, THUD_INPUT. */
enum thud_status thud_study_plan(const struct thud_scene *scene, struct thud_sweep_plan *plan, struct thud_error *err);
