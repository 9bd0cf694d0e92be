/* Dormand and Prince's pair with located events: dormand_prince.c, told by the run to end its steps at them. */
#include <math.h>

#include "core/methods/dormand_prince.h"
#include "core/methods/method.h"

const struct thud_method thud_method_dormand_prince = {
    .name = "dormand-prince",
    .title = "Dormand and Prince 5(4), located events",
    .reference = "Dormand and Prince, Journal of Computational and Applied Mathematics 6 (1980) 19-26",
    .summary = "explicit, step by the tolerance, impacts located in the quintic through both ends of a step",
    .flags = THUD_METHOD_LOCATES | THUD_METHOD_CAN_LOCATE,
    .order = 5,
    .stability = INFINITY,
    .limits = "none of its own: the step follows the tolerance, and gets short where a contact is stiff",
    .stepper = &thud_dormand_prince_stepper,
    .scheme = &thud_dormand_prince_tableau,
};
