/* Case `none` leaves the bumpers out, so points that differ in a bumper alone have the same one. The first of them
 * makes it; the others take it over where it is at hand, and make it again where not: the numbers are the same. */
#include <stdlib.h>
#include <string.h>

#include "study/sweep_private.h"

struct thud_sweep_reference {
    int nvariants, nfloors, ncontacts;
    struct thud_sweep_effort effort;
    struct thud_sweep_floor *floor;     /* (nvariants x nfloors) */
    struct thud_sweep_contact *contact; /* (nvariants x ncontacts) */
};

static bool is_bumper(const char *key)
{
    const char *dot = strchr(key, '.');
    if (strncmp(key, "interfaces.", 11) == 0)
        dot = strchr(key + 11, '.');
    else if (dot)
        return strncmp(key, "bumper.", 7) == 0;
    return dot && strncmp(dot, ".bumper.", 8) == 0;
}

long thud_sweep_reference_point(const struct thud_sweep_plan *plan, long point)
{
    long stride = 1, rest = point;
    for (int i = plan->naxes - 1; i >= 0; i--) {
        long at = rest % plan->axis[i].n;
        if (is_bumper(plan->axis[i].key))
            point -= at * stride;
        rest /= plan->axis[i].n;
        stride *= plan->axis[i].n;
    }
    return point;
}

/* Without a varied bumper every point has a case `none` of its own. */
static bool shares(const struct thud_sweep_plan *plan)
{
    for (int i = 0; i < plan->naxes; i++)
        if (is_bumper(plan->axis[i].key))
            return (plan->shortcuts & THUD_SWEEP_REFERENCE) != 0;
    return false;
}

bool thud_sweep_reuses_reference(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point, int k)
{
    return shares(plan) && point->which[k] == THUD_CASE_NONE &&
           thud_sweep_reference_point(plan, point->index) != point->index;
}

void thud_sweep_effort_reused(struct thud_sweep_effort *effort)
{
    if (!effort->made)
        return;
    effort->made = false;
    effort->reused = true;
    effort->left_out = 0;
    effort->steps = effort->events = 0;
    effort->shared_s = 0;
}

static int find_reference(const struct thud_sweep_point *point)
{
    for (int k = 0; k < point->ncases; k++)
        if (point->which[k] == THUD_CASE_NONE)
            return k;
    return -1;
}

enum { HEAD = (sizeof(struct thud_sweep_reference) + 15) / 16 * 16 };

static size_t size_of(const struct thud_sweep_point *point)
{
    size_t nfloors = (size_t)point->nfloors, ncontacts = (size_t)point->ncontacts;
    return HEAD + (size_t)point->nvariants *
                      (nfloors * sizeof(struct thud_sweep_floor) + ncontacts * sizeof(struct thud_sweep_contact));
}

long thud_sweep_reference_slots(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point)
{
    enum { IN_THE_MAKING = 512 }; /* more than threads have in hand */
    long most = (long)((size_t)THUD_SWEEP_REFERENCE_BYTES / size_of(point)), slots = 1;
    int i = 0;
    while (i < plan->naxes && !is_bumper(plan->axis[i].key))
        i++;
    for (i++; i < plan->naxes; i++) /* what is run through before the outermost bumper's key goes on */
        slots *= plan->axis[i].n;
    if (slots < IN_THE_MAKING)
        slots = IN_THE_MAKING;
    return slots < most ? slots : most > 1 ? most : 1;
}

struct thud_sweep_reference *thud_sweep_reference_keep(const struct thud_sweep_plan *plan,
                                                       const struct thud_sweep_point *point)
{
    int k = shares(plan) ? find_reference(point) : -1;
    if (k < 0)
        return NULL;
    size_t nfloors = (size_t)point->nfloors, ncontacts = (size_t)point->ncontacts;
    char *block = malloc(size_of(point));
    if (!block)
        return NULL;
    struct thud_sweep_reference *reference = (void *)block;
    reference->nvariants = point->nvariants;
    reference->nfloors = point->nfloors;
    reference->ncontacts = point->ncontacts;
    reference->effort = point->effort[k];
    reference->floor = (void *)(block + HEAD);
    reference->contact = (void *)(reference->floor + (size_t)point->nvariants * nfloors);
    for (int v = 0; v < point->nvariants; v++) {
        memcpy(reference->floor + (size_t)v * nfloors, thud_sweep_floors(point, v, k),
               nfloors * sizeof *reference->floor);
        memcpy(reference->contact + (size_t)v * ncontacts, thud_sweep_contacts(point, v, k),
               ncontacts * sizeof *reference->contact);
    }
    return reference;
}

bool thud_sweep_reference_put(const struct thud_sweep_reference *reference, const struct thud_sweep_plan *plan,
                              struct thud_sweep_point *point)
{
    int k = shares(plan) ? find_reference(point) : -1;
    if (k < 0 || point->nvariants != reference->nvariants || point->nfloors != reference->nfloors ||
        point->ncontacts != reference->ncontacts)
        return false;
    bool extra = point->effort[k].reference;
    point->effort[k] = reference->effort;
    point->effort[k].reference = extra;
    if (thud_sweep_reuses_reference(plan, point, k))
        thud_sweep_effort_reused(&point->effort[k]);
    size_t nfloors = (size_t)reference->nfloors, ncontacts = (size_t)reference->ncontacts;
    for (int v = 0; v < reference->nvariants; v++) {
        memcpy(thud_sweep_floors(point, v, k), reference->floor + (size_t)v * nfloors,
               nfloors * sizeof *reference->floor);
        memcpy(thud_sweep_contacts(point, v, k), reference->contact + (size_t)v * ncontacts,
               ncontacts * sizeof *reference->contact);
    }
    return true;
}
