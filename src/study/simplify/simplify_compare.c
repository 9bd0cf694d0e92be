/* How far the peaks of a simple model lie from those of the full one. */
#include <math.h>
#include <stdlib.h>

#include "study/simplify/simplify_private.h"

/* Of the largest of its kind: what is smaller in both runs is not compared. */
static const double least_part = 0.01;

/* Room for `out->floors` and `out->contacts`, zeros. */
static enum thud_status make_room(struct thud_simplify_peaks *out, struct thud_error *err)
{
    const size_t floors = (size_t)out->floors + 1, contacts = (size_t)out->contacts + 1;
    out->structure = calloc(floors, sizeof *out->structure);
    out->contact = calloc(contacts, sizeof *out->contact);
    out->acceleration = calloc(2 * floors + contacts, sizeof(double));
    if (!out->structure || !out->contact || !out->acceleration) {
        thud_simplify_peaks_clear(out);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    out->drift = out->acceleration + floors;
    out->force = out->drift + floors;
    return THUD_OK;
}

enum thud_status thud_simplify_peaks_take(const struct thud_result *r, struct thud_simplify_peaks *out,
                                          struct thud_error *err)
{
    *out = (struct thud_simplify_peaks){.contacts = r->ncontacts, .collapsed = r->collapse.happened};
    for (int s = 0; s < r->nstructures; s++)
        out->floors += r->structure[s].floors;
    const enum thud_status status = make_room(out, err);
    if (status != THUD_OK)
        return status;
    for (int s = 0, k = 0; s < r->nstructures; s++)
        for (int i = 0; i < r->structure[s].floors; i++, k++) {
            out->structure[k] = s;
            out->acceleration[k] = thud_floor_acceleration(r, s, i);
            out->drift[k] = r->structure[s].floor[i].drift.value;
        }
    for (int c = 0; c < r->ncontacts; c++) {
        out->contact[c] = r->contact[c];
        out->force[c] = thud_peak_force(&r->contact[c]);
        out->impacts += r->contact[c].impacts;
    }
    return THUD_OK;
}

enum thud_status thud_simplify_peaks_add(const struct thud_simplify_peaks *of, double share,
                                         struct thud_simplify_peaks *to, struct thud_error *err)
{
    const bool first = !to->structure;
    to->floors = of->floors;
    to->contacts = of->contacts;
    to->impacts += of->impacts;
    to->collapsed = to->collapsed || of->collapsed;
    const enum thud_status status = first ? make_room(to, err) : THUD_OK;
    for (int i = 0; status == THUD_OK && i < of->floors; i++) {
        to->structure[i] = of->structure[i];
        to->acceleration[i] += share * of->acceleration[i];
        to->drift[i] += share * of->drift[i];
    }
    for (int c = 0; status == THUD_OK && c < of->contacts; c++) {
        to->contact[c] = of->contact[c];
        to->force[c] += share * of->force[c];
    }
    return status;
}

void thud_simplify_peaks_clear(struct thud_simplify_peaks *peaks)
{
    free(peaks->structure);
    free(peaks->contact);
    free(peaks->acceleration);
    *peaks = (struct thud_simplify_peaks){0};
}

struct thud_simplify_change thud_simplify_unchanged(void)
{
    return (struct thud_simplify_change){NAN, NAN, NAN, NAN, 0, 0};
}

void thud_simplify_compare_gap(double full_m, double simple_m, struct thud_simplify_change *change)
{
    if (full_m > 0)
        change->gap = isnan(simple_m) ? 1 : fabs(simple_m - full_m) / full_m;
}

static void widen(double *change, double full, double simple, double most, double kind)
{
    if (isnan(full) || !(fmax(full, isnan(simple) ? full : simple) >= least_part * kind) || !(kind > 0))
        return;
    const double now = isnan(simple) ? INFINITY : fabs(simple - full) / most;
    *change = isnan(*change) ? now : fmax(*change, now);
}

/* Of floors, over the largest of the same building. */
static void compare_floors(const struct thud_simplify_peaks *full, const double *a, const double *b, double *change)
{
    double kind = 0;
    for (int i = 0; i < full->floors; i++)
        kind = fmax(kind, a[i]);
    for (int i = 0; i < full->floors; i++) {
        double most = 0;
        for (int k = 0; k < full->floors; k++)
            if (full->structure[k] == full->structure[i])
                most = fmax(most, a[k]);
        widen(change, a[i], b[i], most, kind);
    }
}

static bool same_contact(const struct thud_contact_result *a, const struct thud_contact_result *b)
{
    return a->interface == b->interface && a->left_floor == b->left_floor && a->right_floor == b->right_floor;
}

/* The force of a contact in another run; 0: it is not there. */
static double force_of(const struct thud_simplify_peaks *in, const struct thud_contact_result *contact)
{
    for (int c = 0; c < in->contacts; c++)
        if (same_contact(&in->contact[c], contact))
            return in->force[c];
    return 0;
}

void thud_simplify_compare(const struct thud_simplify_peaks *full, const struct thud_simplify_peaks *simple,
                           struct thud_simplify_change *change)
{
    double most = 0;
    if (full->floors == simple->floors) {
        compare_floors(full, full->acceleration, simple->acceleration, &change->acceleration);
        compare_floors(full, full->drift, simple->drift, &change->drift);
    } else
        change->acceleration = INFINITY;
    for (int c = 0; c < full->contacts; c++)
        most = fmax(most, full->force[c]);
    for (int c = 0; c < full->contacts; c++)
        widen(&change->force, full->force[c], force_of(simple, &full->contact[c]), most, most);
    for (int c = 0; c < simple->contacts; c++) /* those that the full run does not have */
        if (force_of(full, &simple->contact[c]) == 0)
            widen(&change->force, 0, simple->force[c], most, most);
    change->impacts += simple->impacts;
    if ((full->impacts > 0) != (simple->impacts > 0) || full->collapsed != simple->collapsed)
        change->all = INFINITY;
}
