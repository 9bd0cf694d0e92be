/* The paper's towers and a short motion for them, made without files. */
#pragma once

#include "ground/record.h"
#include "study/scene/scene.h"

/* Sets the named law with its defaults and then the values given: name, value, ..., NULL. */
void thud_test_law(struct thud_law_choice *choice, const char *law, ...);
/* Two shear buildings of 4 and 6 storeys, concrete contact, gap 10 cm, bumper of 5 cm. */
void thud_test_towers(struct thud_scene *scene);
/* Two bursts in 16 s; `factor` 1: both buildings sway by about 10 cm. */
struct thud_record *thud_test_motion(double factor);
