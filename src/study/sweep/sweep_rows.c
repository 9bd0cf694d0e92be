/* Rows of a point: ratios per floor and of the means, contacts, needed gaps. */
#include <math.h>

#include "study/sweep/sweep_private.h"

static double over(double a, double b)
{
    return b > 0 ? a / b : NAN;
}

/* What yielding storeys tell, over those that do: permanent drifts to either side would cancel, so their sizes. */
static struct thud_sweep_floor mean(const struct thud_sweep_floor *floor, int n)
{
    struct thud_sweep_floor sum = {0};
    int yielding = 0;
    for (int i = 0; i < n; i++) {
        sum.acceleration_mps2 += floor[i].acceleration_mps2;
        sum.drift_m += floor[i].drift_m;
        sum.displacement_m += floor[i].displacement_m;
        if (isnan(floor[i].ductility))
            continue;
        yielding++;
        sum.ductility += floor[i].ductility;
        sum.permanent_m += fabs(floor[i].permanent_m);
        sum.excursions += floor[i].excursions;
        sum.hysteretic_j += floor[i].hysteretic_j;
    }
    double each = yielding > 0 ? (double)yielding : (double)NAN;
    return (struct thud_sweep_floor){
        sum.acceleration_mps2 / n, sum.drift_m / n,       sum.displacement_m / n,  sum.ductility / each,
        sum.permanent_m / each,    sum.excursions / each, sum.hysteretic_j / each, NAN};
}

int thud_sweep_reference(const struct thud_sweep_point *point)
{
    int written = 0;
    for (int k = 0; k < point->ncases; k++) {
        if (point->which[k] == THUD_CASE_NONE)
            return k;
        if (point->which[k] == THUD_CASE_AS_WRITTEN)
            written = k;
    }
    return written;
}

static int fill_values(const struct thud_sweep_plan *plan, long point, double *value)
{
    int at[THUD_VARY_MAX], record = thud_sweep_place(plan, point, at);
    for (int i = 0; i < THUD_VARY_MAX; i++)
        value[i] = i < plan->naxes ? plan->axis[i].value[at[i]] : 0;
    return record;
}

static bool is_answered(const struct thud_sweep_point *point, int k)
{
    return !point->effort[k].reference && point->effort[k].status == THUD_OK;
}

/* Where a row's numbers stand in a point: the floors of a structure, or one of them. */
struct where {
    const struct thud_sweep_plan *plan;
    const struct thud_sweep_point *point;
    int k, first, n, floor;
};

static struct thud_sweep_floor floor_of(const struct where *w, int variant, int k)
{
    const struct thud_sweep_point *p = w->point;
    const struct thud_sweep_floor *x = thud_sweep_floors(p, variant, k) + w->first;
    return w->floor > 0 ? x[w->floor - 1] : mean(x, w->n);
}

static void measure(const struct where *w, int variant, double m[THUD_SWEEP_MEASURES])
{
    struct thud_sweep_floor x = floor_of(w, variant, w->k), none = floor_of(w, variant, thud_sweep_reference(w->point)),
                            free = floor_of(w, variant, w->point->ncases);
    const struct thud_sweep_point *p = w->point;
    const enum thud_case alone = thud_sweep_free_case(w->plan);
    const bool cut = p->effort[w->k].collapsed || p->effort[thud_sweep_reference(p)].collapsed,
               cut_free = p->effort[w->k].collapsed || p->fall[thud_sweep_linkage(p->nlinkages, alone)].happened;
    m[THUD_SWEEP_ACCELERATION] = x.acceleration_mps2;
    m[THUD_SWEEP_DRIFT] = x.drift_m;
    m[THUD_SWEEP_DISPLACEMENT] = x.displacement_m;
    m[THUD_SWEEP_ACCELERATION_RATIO] = over(x.acceleration_mps2, none.acceleration_mps2);
    m[THUD_SWEEP_DRIFT_RATIO] = over(x.drift_m, none.drift_m);
    m[THUD_SWEEP_DISPLACEMENT_RATIO] = over(x.displacement_m, none.displacement_m);
    m[THUD_SWEEP_ACCELERATION_FREE_RATIO] = over(x.acceleration_mps2, free.acceleration_mps2);
    m[THUD_SWEEP_DRIFT_FREE_RATIO] = over(x.drift_m, free.drift_m);
    m[THUD_SWEEP_DISPLACEMENT_FREE_RATIO] = over(x.displacement_m, free.displacement_m);
    for (int q = THUD_SWEEP_ACCELERATION_RATIO; q <= THUD_SWEEP_DISPLACEMENT_FREE_RATIO; q++)
        m[q] = (q < THUD_SWEEP_ACCELERATION_FREE_RATIO ? cut : cut_free) ? NAN : m[q];
    m[THUD_SWEEP_DUCTILITY] = x.ductility;
    m[THUD_SWEEP_PERMANENT] = x.permanent_m;
    m[THUD_SWEEP_EXCURSIONS] = x.excursions;
    m[THUD_SWEEP_HYSTERETIC] = x.hysteretic_j;
}

/* NaN stays NaN. */
static void widen(double *low, double *high, double value)
{
    *low = isnan(value) || value < *low ? value : *low;
    *high = isnan(value) || value > *high ? value : *high;
}

static void fill_row(struct thud_sweep_row *row, const struct where *w)
{
    double m[THUD_SWEEP_MEASURES];
    measure(w, 0, row->of);
    for (int q = 0; q < THUD_SWEEP_MEASURES; q++)
        row->low[q] = row->high[q] = w->point->nvariants > 1 ? row->of[q] : NAN;
    for (int v = 1; v < w->point->nvariants; v++) {
        measure(w, v, m);
        for (int q = 0; q < THUD_SWEEP_MEASURES; q++)
            widen(&row->low[q], &row->high[q], m[q]);
    }
}

int thud_sweep_rows(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point,
                    struct thud_sweep_row *row)
{
    int count = 0;
    struct thud_sweep_row head = {.gap_m = point->gap_m};
    head.record = fill_values(plan, point->index, head.value);
    for (int k = 0; k < point->ncases; k++) {
        if (!is_answered(point, k))
            continue;
        head.which = point->which[k];
        for (int s = 0, first = 0; s < point->nstructures; first += point->floors[s], s++) {
            int n = point->floors[s];
            head.structure = s;
            for (int i = 0; n > 0 && i <= n; i++, count++) {
                if (!row)
                    continue;
                row[count] = head;
                row[count].floor = i;
                row[count].collapsed = point->effort[k].collapsed;
                fill_row(&row[count], &(struct where){plan, point, k, first, n, i});
            }
        }
    }
    return count;
}

static void spread_contact(struct thud_sweep_contact_row *row, const struct thud_sweep_point *point, int k, int c)
{
    bool spread = point->nvariants > 1;
    row->force_low_n = row->force_high_n = spread ? row->of.force_n : NAN;
    row->indentation_low_m = row->indentation_high_m = spread ? row->of.indentation_m : NAN;
    for (int v = 1; v < point->nvariants; v++) {
        const struct thud_sweep_contact *x = &point->contact[((ptrdiff_t)v * point->ncases + k) * point->ncontacts + c];
        widen(&row->force_low_n, &row->force_high_n, x->force_n);
        widen(&row->indentation_low_m, &row->indentation_high_m, x->indentation_m);
    }
}

int thud_sweep_contact_rows(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point,
                            struct thud_sweep_contact_row *row)
{
    int count = 0;
    struct thud_sweep_contact_row head = {.gap_m = point->gap_m};
    head.record = fill_values(plan, point->index, head.value);
    for (int k = 0; k < point->ncases; k++) {
        if (!is_answered(point, k))
            continue;
        head.which = point->which[k];
        for (int c = 0; c < point->ncontacts; c++, count++) {
            const struct thud_gap_level *level = &point->level[c];
            if (!row)
                continue;
            row[count] = head;
            row[count].interface = level->interface;
            row[count].left_floor = level->left_floor;
            row[count].right_floor = level->right_floor;
            row[count].struck = level->struck;
            row[count].of = point->contact[k * point->ncontacts + c];
            spread_contact(&row[count], point, k, c);
        }
    }
    return count;
}

int thud_sweep_need_rows(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point,
                         struct thud_sweep_need_row *row)
{
    if (point->index % thud_sweep_points_per_group(plan) != 0)
        return 0;
    for (int c = 0; row && c < point->ncontacts; c++) {
        row[c].level = point->level[c];
        row[c].fall = point->fall[0];
        row[c].record = fill_values(plan, point->index, row[c].value);
    }
    return point->ncontacts;
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
