/* Root of a function of one variable in a bracket. */
#pragma once

/* `f(x, context)` has opposite signs (or a zero) at lo < hi. Returns x to the last bits a double holds. */
double thud_root(double (*f)(double x, const void *context), const void *context, double lo, double hi);
