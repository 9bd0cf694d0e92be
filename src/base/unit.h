/* A unit taken apart: one unit is factor * 10^shift in SI. */
#pragma once

#include <stdbool.h>

#include "base/quantity.h"

struct thud_unit {
    enum thud_dimension dimension;
    int shift;
    double factor;
    double exponent; /* of N/m^n */
};

/* false when there is no such unit. The empty unit is a plain number. */
bool thud_unit_find(const char *text, struct thud_unit *unit);
