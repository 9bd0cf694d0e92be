/* A study of the towers on a short motion, for the tests of its parts. */
#pragma once

#include "study/sweep/sweep.h"
#include "towers.h"

extern struct thud_scene *scene; /* two of them: the study's and room for another */
extern struct thud_sweep_plan *plan;
extern struct thud_record *motion;
extern const struct thud_record *records[2]; /* the motion, and room for another */
extern struct thud_error error;

/* `factor`: that of thud_test_motion. */
void study_set_up(double factor);
void study_tear_down(void);
/* A key that must be one that can be varied. */
void vary(const char *text);
