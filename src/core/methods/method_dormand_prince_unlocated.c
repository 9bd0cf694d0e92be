/* The same pair as a general program uses it: the tolerance alone decides about the steps, and contacts catch up at their
 * ends. Beside the located one it shows what an adaptive step makes of a kink that it steps over. */
#include <math.h>

#include "core/methods/dormand_prince.h"
#include "core/methods/method.h"

const struct thud_method thud_method_dormand_prince_unlocated = {
    .name = "dormand-prince-unlocated",
    .title = "Dormand and Prince 5(4), events not located",
    .reference = "Dormand and Prince, Journal of Computational and Applied Mathematics 6 (1980) 19-26",
    .summary = "the same without location: every impact is found by steps that fail",
    .flags = 0,
    .order = 5,
    .stability = INFINITY,
    .limits = "chatters where the law jumps; steps of 1e-9 s and less at every impact",
    .stepper = &thud_dormand_prince_stepper,
    .scheme = &thud_dormand_prince_tableau,
};
