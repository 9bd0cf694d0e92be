/* What the shell is told. */
#ifndef THUD_APP_EXIT_STATUS_H
#define THUD_APP_EXIT_STATUS_H

#include "base/status.h"

/* 0 done, 1 a check did not hold, 2 wrong usage, 3 bad input, 4 the integration failed, 5 gnuplot, 6 output or memory,
 * 130 cancelled. */
int thud_exit_status(enum thud_status status);

#endif
