/* A unit taken apart: one unit is factor * 10^shift in SI. */
#ifndef THUD_BASE_UNIT_H
#define THUD_BASE_UNIT_H

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

#endif
