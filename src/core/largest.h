/* The larger of two numbers; NaN where one of them is, so that it is not lost on the way. */
#ifndef THUD_CORE_LARGEST_H
#define THUD_CORE_LARGEST_H

static inline double thud_larger(double a, double b)
{
    return b > a || b != b ? b : a;
}

#endif
