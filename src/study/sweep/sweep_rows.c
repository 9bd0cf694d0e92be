/* Rows of a point: the measures of floors and of the means over them, and contacts. */
#include <math.h>

#include "study/sweep/measure.h"
#include "study/sweep/sweep_private.h"

int thud_sweep_answered(const struct thud_sweep_point *point, int i)
{
    int k = 0;
    for (; k < point->ncases; k++)
        if (!point->effort[k].reference && point->effort[k].status == THUD_OK && i-- == 0)
            break;
    return k;
}

static int count_runs(const struct thud_sweep_point *point)
{
    int n = 0;
    while (thud_sweep_answered(point, n) < point->ncases)
        n++;
    return n;
}

/* Of one that has floors, the mean over them too. */
static int rows_of_structure(const struct thud_sweep_point *point, int s)
{
    return point->floors[s] > 0 ? point->floors[s] + 1 : 0;
}

static int rows_of_run(const struct thud_sweep_point *point)
{
    int n = 0;
    for (int s = 0; s < point->nstructures; s++)
        n += rows_of_structure(point, s);
    return n;
}

int thud_sweep_row_count(const struct thud_sweep_point *point)
{
    return count_runs(point) * rows_of_run(point);
}

int thud_sweep_contact_row_count(const struct thud_sweep_point *point)
{
    return count_runs(point) * point->ncontacts;
}

/* NaN stays NaN. */
static void widen(double *low, double *high, double value)
{
    *low = isnan(value) || value < *low ? value : *low;
    *high = isnan(value) || value > *high ? value : *high;
}

void thud_sweep_row_at(const struct thud_sweep_point *point, int i, struct thud_sweep_row *row)
{
    const int k = thud_sweep_answered(point, i / rows_of_run(point));
    int s = 0;
    for (i %= rows_of_run(point); i >= rows_of_structure(point, s); s++)
        i -= rows_of_structure(point, s);
    *row = (struct thud_sweep_row){.which = point->which[k],
                                   .gap_m = point->gap_m,
                                   .structure = s,
                                   .floor = i,
                                   .collapsed = point->effort[k].fall.happened};
    for (enum thud_measure m = 0; m < THUD_MEASURES; m++) {
        const struct thud_measure_info *info = thud_measure_info(m);
        if (info->place[THUD_TOLD_BY_FLOORS] == 0)
            continue;
        row->of[m] = thud_measure_of_floor(point, 0, k, info, s, i);
        row->low[m] = row->high[m] = point->nvariants > 1 ? row->of[m] : NAN;
        for (int v = 1; v < point->nvariants; v++)
            widen(&row->low[m], &row->high[m], thud_measure_of_floor(point, v, k, info, s, i));
    }
}

void thud_sweep_contact_row_at(const struct thud_sweep_point *point, int i, struct thud_sweep_contact_row *row)
{
    const int k = thud_sweep_answered(point, i / point->ncontacts), c = i % point->ncontacts;
    const bool spread = point->nvariants > 1;
    *row = (struct thud_sweep_contact_row){.which = point->which[k],
                                           .gap_m = point->gap_m,
                                           .level = point->level[c],
                                           .of = thud_sweep_contacts(point, 0, k)[c]};
    row->force_low_n = row->force_high_n = spread ? row->of.force_n : NAN;
    row->indentation_low_m = row->indentation_high_m = spread ? row->of.indentation_m : NAN;
    for (int v = 1; v < point->nvariants; v++) {
        const struct thud_sweep_contact *x = &thud_sweep_contacts(point, v, k)[c];
        widen(&row->force_low_n, &row->force_high_n, x->force_n);
        widen(&row->indentation_low_m, &row->indentation_high_m, x->indentation_m);
    }
}

void thud_sweep_total_init(struct thud_sweep_total *total)
{
    *total = (struct thud_sweep_total){.impossible_point = -1, .diverged_point = -1};
}

static void note(long *point, int *which, const struct thud_sweep_point *p, int k)
{
    if (*point >= 0)
        return;
    *point = p->index;
    *which = k;
}

void thud_sweep_total_add(struct thud_sweep_total *total, const struct thud_sweep_point *point)
{
    total->points++;
    total->changed.made += point->changed.made;
    total->changed.free += point->changed.free;
    total->changed.failed += point->changed.failed;
    total->steps += point->changed.steps;
    total->events += point->changed.events;
    for (int k = 0; k < point->ncases; k++) {
        const struct thud_sweep_effort *e = &point->effort[k];
        total->asked += !e->reference;
        total->references += e->reference;
        total->impossible += e->status == THUD_INPUT && !e->reference;
        total->diverged += e->status == THUD_DIVERGED;
        if (e->status == THUD_INPUT && !e->reference)
            note(&total->impossible_point, &total->impossible_case, point, k);
        if (e->status == THUD_DIVERGED)
            note(&total->diverged_point, &total->diverged_case, point, k);
        total->made += e->made;
        total->reused += e->reused;
        total->free += e->status == THUD_OK && !e->made && !e->reused;
        total->shared_runs += e->shared_s > 0;
        total->left_out += e->left_out;
        total->steps += e->steps;
        total->events += e->events;
        total->shared_s += e->shared_s;
        total->end_s += e->made ? e->end_s : 0;
    }
}
