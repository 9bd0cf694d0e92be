/* Time stepping of one run. */
#pragma once

#include "core/run/run.h"

struct thud_stepping {
    const struct thud_method *method;
    bool locate;    /* events located */
    double setting; /* step in s of a fixed-step method, else the tolerance */
};

/* Returns whether both are of one curve, whatever their settings. */
static inline bool thud_stepping_same(const struct thud_stepping *a, const struct thud_stepping *b)
{
    return a->method == b->method && a->locate == b->locate;
}

/* Writes the name of a curve, for all tables: "rk4, located"; methods that always locate have only their name. */
void thud_stepping_name(const struct thud_stepping *how, char *text, unsigned long size);
/* Makes a run use it. */
void thud_stepping_apply(const struct thud_stepping *how, struct thud_run_options *options);
