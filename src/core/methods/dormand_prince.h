/* The pair of orders 5 and 4 of Dormand and Prince (1980) with a step that follows the run's tolerance. */
#pragma once

#include "core/methods/runge_kutta.h"

extern const struct thud_tableau thud_dormand_prince_tableau;
extern const struct thud_stepper thud_dormand_prince_stepper;
