#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"

static int is_digit(char c)
{
    return c >= '0' && c <= '9';
}

int thud_number_parse(const char *text, const char **end, double *out)
{
    const char *s = text;
    if (*s == '+' || *s == '-')
        s++;
    /* strtod also takes hexadecimal, inf and nan, which are no numbers in a preset or a record */
    if (!is_digit(*s) && !(*s == '.' && is_digit(s[1])))
        return -1;
    if (*s == '0' && (s[1] == 'x' || s[1] == 'X'))
        return -1;
    char *stop;
    double value = strtod(text, &stop);
    if (end)
        *end = stop;
    *out = value;
    return isfinite(value) ? 0 : -2;
}

void thud_number_format(double value, char *text, size_t size)
{
    if (value == rint(value) && fabs(value) < 1e15) { /* 40, not 4e+01; and no -0 */
        snprintf(text, size, "%.0f", value + 0.0);
        return;
    }
    /* %g leaves trailing zeros out, so 15 digits, which any normal double has, also print the shorter ones */
    for (int digits = fabs(value) < DBL_MIN ? 1 : 15; digits <= 17; digits++) {
        snprintf(text, size, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            return;
    }
}
