#include "study/methods/time_stepping.h"

#include <stdio.h>

void thud_stepping_name(const struct thud_stepping *how, char *text, unsigned long size)
{
    bool said = how->locate && how->method->flags & THUD_METHOD_FIXED_STEP;
    snprintf(text, size, "%s%s", how->method->name, said ? ", located" : "");
}

void thud_stepping_apply(const struct thud_stepping *how, struct thud_run_options *options)
{
    options->method = how->method;
    options->locate = how->locate;
    if (how->method->flags & THUD_METHOD_FIXED_STEP)
        options->step_s = how->setting;
    else
        options->tolerance = how->setting;
}
