#include <math.h>
#include <stdbool.h>

#include "plot/gnuplot/reduce.h"

static bool rises(size_t n, const double *x)
{
    double last = -INFINITY;
    for (size_t i = 0; i < n; i++) {
        if (isnan(x[i]))
            continue;
        if (x[i] < last)
            return false;
        last = x[i];
    }
    return true;
}

static double cell(double value, double least, double most, size_t count)
{
    return most > least ? floor((value - least) / (most - least) * (double)count) : 0.0;
}

/* The points of one column, as far as they were seen. */
struct column {
    double number;
    size_t low, high, first, last;
    bool open;
};

/* Its extremes in the order they came; where the trace begins or ends (or breaks) also that point. */
static size_t close_column(struct column *column, bool begins, bool ends, size_t *index, size_t picked)
{
    if (!column->open)
        return picked;
    size_t one = column->low < column->high ? column->low : column->high;
    size_t two = column->low < column->high ? column->high : column->low;
    if (begins && column->first < one)
        index[picked++] = column->first;
    index[picked++] = one;
    if (two != one)
        index[picked++] = two;
    if (ends && column->last > two)
        index[picked++] = column->last;
    column->open = false;
    return picked;
}

static size_t reduce_rising(const struct thud_reduce *to, size_t n, const double *x, const double *y,
                            const double *y_high, size_t *index)
{
    const double *top = y_high ? y_high : y;
    size_t picked = 0, begin = 0, end = n;
    struct column column = {0};
    bool begins = true;
    for (size_t i = 0; i < n; i++) { /* one neighbour beyond each limit */
        if (x[i] < to->least)
            begin = i;
        if (x[i] > to->most) {
            end = i + 1;
            break;
        }
    }
    for (size_t i = begin; i < end; i++) {
        bool broken = isnan(x[i]) || isnan(y[i]) || isnan(top[i]);
        double number = broken ? 0.0 : cell(x[i], to->least, to->most, to->columns);
        if (broken || !column.open || number != column.number) {
            bool was_open = column.open;
            picked = close_column(&column, begins, broken, index, picked);
            begins = broken || (begins && !was_open);
            if (broken)
                index[picked++] = i;
            else
                column = (struct column){number, i, i, i, i, true};
            continue;
        }
        if (y[i] < y[column.low])
            column.low = i;
        if (top[i] > top[column.high])
            column.high = i;
        column.last = i;
    }
    return close_column(&column, begins, true, index, picked);
}

static size_t reduce_loop(const struct thud_reduce *to, size_t n, const double *x, const double *y, size_t *index)
{
    size_t picked = 0;
    double column = NAN, row = NAN;
    for (size_t i = 0; i < n; i++) {
        double c = cell(x[i], to->least, to->most, to->columns), r = cell(y[i], to->low, to->high, to->rows);
        if (i + 1 < n && c == column && r == row)
            continue; /* NaN equals nothing, so breaks stay */
        column = c;
        row = r;
        index[picked++] = i;
    }
    return picked;
}

size_t thud_reduce(const struct thud_reduce *to, size_t n, const double *x, const double *y, const double *y_high,
                   size_t *index)
{
    return rises(n, x) ? reduce_rising(to, n, x, y, y_high, index) : reduce_loop(to, n, x, y, index);
}
