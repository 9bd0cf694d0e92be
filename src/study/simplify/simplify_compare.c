/* How far the peaks of a simple model lie from those of the full one. */
#include <math.h>
#include <stdlib.h>

#include "study/simplify/simplify_private.h"

enum { ACCELERATION, DRIFT, FORCE, KINDS };

/* Of the largest of its kind: what is smaller in both runs is not compared. */
static const double least_part = 0.01;

static enum thud_status make_room(int n, struct thud_simplify_peaks *out, struct thud_error *err)
{
    out->n = n;
    out->item = calloc((size_t)n + 1, sizeof *out->item);
    return out->item ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
}

enum thud_status thud_simplify_peaks_take(const struct thud_result *r, struct thud_simplify_peaks *out,
                                          struct thud_error *err)
{
    int n = r->ncontacts;
    *out = (struct thud_simplify_peaks){.collapsed = r->collapse.happened};
    for (int s = 0; s < r->nstructures; s++)
        n += 2 * r->structure[s].floors;
    enum thud_status status = make_room(n, out, err);
    struct thud_simplify_peak *to = out->item;
    for (int s = 0; status == THUD_OK && s < r->nstructures; s++)
        for (int i = 0; i < r->structure[s].floors; i++) {
            *to++ = (struct thud_simplify_peak){ACCELERATION, s, {i}, thud_floor_acceleration(r, s, i)};
            *to++ = (struct thud_simplify_peak){DRIFT, s, {i}, r->structure[s].floor[i].drift.value};
        }
    for (int c = 0; status == THUD_OK && c < r->ncontacts; c++) {
        const struct thud_contact_result *at = &r->contact[c];
        const double force = thud_peak_force(at);
        *to++ = (struct thud_simplify_peak){FORCE, 0, {at->interface, at->left_floor, at->right_floor}, force};
        out->force_n = fmax(out->force_n, force);
        out->impacts += at->impacts;
    }
    return status;
}

enum thud_status thud_simplify_peaks_add(const struct thud_simplify_peaks *of, double share,
                                         struct thud_simplify_peaks *to, struct thud_error *err)
{
    enum thud_status status = to->item ? THUD_OK : make_room(of->n, to, err);
    to->impacts += of->impacts;
    to->collapsed = to->collapsed || of->collapsed;
    for (int i = 0; status == THUD_OK && i < of->n; i++) {
        const double sum = to->item[i].value;
        to->item[i] = of->item[i];
        to->item[i].value = sum + share * of->item[i].value;
    }
    return status;
}

void thud_simplify_peaks_clear(struct thud_simplify_peaks *peaks)
{
    free(peaks->item);
    *peaks = (struct thud_simplify_peaks){0};
}

/* The same peak of another run, where the list has it (NULL: nowhere); most stand at the same place. */
static const struct thud_simplify_peak *find(const struct thud_simplify_peaks *in, const struct thud_simplify_peak *as,
                                             int place)
{
    for (int k = 0; k < in->n; k++) {
        const struct thud_simplify_peak *p = &in->item[(place + k) % in->n];
        if (p->kind == as->kind && p->structure == as->structure && p->at[0] == as->at[0] && p->at[1] == as->at[1] &&
            p->at[2] == as->at[2])
            return p;
    }
    return NULL;
}

static void widen(double *change, double full, double simple, double most, double kind)
{
    if (isnan(full) || !(fmax(full, isnan(simple) ? full : simple) >= least_part * kind) || !(kind > 0))
        return;
    const double now = isnan(simple) ? INFINITY : fabs(simple - full) / most;
    *change = isnan(*change) ? now : fmax(*change, now);
}

void thud_simplify_compare(const struct thud_simplify_peaks *full, const struct thud_simplify_peaks *simple,
                           struct thud_simplify_change *change)
{
    double most[KINDS][THUD_STRUCTURES_MAX] = {{0}}, kind[KINDS] = {0};
    double *const part[KINDS] = {&change->acceleration, &change->drift, &change->force};
    for (int i = 0; i < full->n; i++) {
        const struct thud_simplify_peak *p = &full->item[i];
        most[p->kind][p->structure] = fmax(most[p->kind][p->structure], p->value);
        kind[p->kind] = fmax(kind[p->kind], p->value);
    }
    for (int i = 0; i < full->n; i++) { /* a contact that is not there has no force */
        const struct thud_simplify_peak *p = &full->item[i], *other = find(simple, p, i);
        widen(part[p->kind], p->value,
              other              ? other->value
              : p->kind == FORCE ? 0
                                 : NAN,
              most[p->kind][p->structure], kind[p->kind]);
    }
    for (int i = 0; i < simple->n; i++)
        if (simple->item[i].kind == FORCE && !find(full, &simple->item[i], i))
            widen(part[FORCE], 0, simple->item[i].value, kind[FORCE], kind[FORCE]);
    change->impacts += simple->impacts;
    for (int k = 0; k < KINDS; k++)
        change->all = fmax(change->all, *part[k]); /* of numbers alone */
    if ((full->impacts > 0) != (simple->impacts > 0) || full->collapsed != simple->collapsed)
        change->all = INFINITY;
}

void thud_simplify_compare_gap(double full_m, double simple_m, struct thud_simplify_change *change)
{
    if (full_m > 0)
        change->gap = isnan(simple_m) ? 1 : fabs(simple_m - full_m) / full_m;
    change->all = fmax(change->all, change->gap);
}
