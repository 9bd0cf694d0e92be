/* A study in the command line's words, and those words as the preset's own study. */
#pragma once

#include <stdbool.h>

#include "study/sweep/sweep.h"

struct thud_study_words {
    char vary[THUD_VARY_MAX][THUD_VARY_TEXT]; /* "gap=5 cm:25 cm:0.5 cm"; empty: no more */
    char cases[96];                           /* "none,bumper"; empty: as written */
    char records[THUD_VARY_TEXT];             /* files, folders, lists, with commas; empty: the scene's own */
    char signs[16];                           /* "both": each motion also reversed; empty: as given */
    char events[THUD_VARY_TEXT];              /* of the fragility, with commas; empty: pounding,worse */
    char sensitivity[32];                     /* "0.1 %"; empty: no spread */
};

/* What the preset's study says, else the paper's. */
void thud_study_words_of(const struct thud_scene *scene, struct thud_study_words *words);
/* Keys varied and cases as a plan that the caller clears, also after an error. Errors: THUD_USAGE, THUD_INPUT. */
enum thud_status thud_study_words_plan(const struct thud_study_words *words, const struct thud_scene *scene,
                                       struct thud_sweep_plan *plan, struct thud_error *err);
/* Makes keys varied and cases those of the scene's study, after trying every value they name; a range beside a list
 * becomes a list. Errors: THUD_USAGE (also where a preset has no room for so long a list), THUD_INPUT, THUD_MEMORY; the
 * scene is then as it was. */
enum thud_status thud_study_words_keep(const struct thud_study_words *words, struct thud_scene *scene,
                                       struct thud_error *err);
