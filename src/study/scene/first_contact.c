/* The factor f of first contact. A contact is closed where the share of a clearance that the motion without pounding
 * uses up reaches 1:
 *
 *     U(f) = max over levels of (relative displacement at f)/(clearance)
 *
 * U is continuous, and proportional to f where nothing yields, slips or acts on one side. Else it may fall with f:
 * steps of the scan grow with |ln U|, and a maximum between two steps is examined where it may reach 1.
 * Where storeys that yield are all that is not linear, U is proportional to f up to the factor f_y = f/mu of the first
 * yielding, with the largest ductility mu <= 1 of any run below it: the scan begins there. */
#include "study/scene/first_contact.h"

#include <math.h>
#include <stdlib.h>

#include "study/scene/level.h"
#include "study/scene/scene_elements.h"

/* Of factors: their relative tolerance, the range searched, and the share below which no contact is expected. */
static const double close = 1e-6, least = 1e-3, most = 1e3, far = 0.2;
/* Steps of ln f: parts of |ln U|, between these. A turn of ln U is looked into while it is no further from 0 than so
 * many times what its neighbours fall behind it. */
static const double part = 0.25, short_step = 0.03, long_step = 0.3, promising = 4;

struct search {
    const struct thud_scene *scene;
    const struct thud_record *record;
};

struct trial {
    double factor, used, ductility; /* the largest */
};

/* INFINITY: a motion uses up a clearance of nothing. */
static double used_up(const struct thud_scene *scene, const struct thud_needed_gap *gap)
{
    double largest = 0;
    for (int i = 0; i < gap->nlevels; i++) {
        const struct thud_level_values at =
            thud_interface_level(&scene->interface[gap->level[i].interface - 1], thud_needed_gap_level(gap->level, i));
        const double clearance = thud_level_clearance(&at), moved = gap->level[i].relative_displacement_m;
        if (moved > 0)
            largest = fmax(largest, clearance > 0 ? moved / clearance : INFINITY);
    }
    return largest;
}

static enum thud_status run_at(const struct search *search, double factor, struct trial *out, struct thud_error *err)
{
    struct thud_record *scaled;
    struct thud_needed_gap *gap = NULL;
    enum thud_status status = thud_record_scaled(search->record, factor, &scaled, err);
    if (status == THUD_OK)
        status = thud_needed_gap_run(search->scene, scaled, &gap, err);
    if (status == THUD_OK)
        *out = (struct trial){factor, used_up(search->scene, gap), gap->ductility};
    free(gap);
    thud_record_free(scaled);
    return status;
}

static bool touches(struct trial at)
{
    return at.used >= 1;
}

/* Brings two trials with and without contact together. The secant, which of a share in proportion is the root, is kept
 * off the ends; every third time it is the middle. */
static enum thud_status close_in(const struct search *search, struct trial *from, struct trial *to,
                                 struct thud_error *err)
{
    enum { RUNS = 60 };
    enum thud_status status = THUD_OK;
    for (int i = 0; i < RUNS && status == THUD_OK && fabs(to->factor - from->factor) > close * to->factor; i++) {
        const double secant = fmin(0.999999, fmax(1e-6, (1 - from->used) / (to->used - from->used)));
        struct trial at;
        status = run_at(search, from->factor + (to->factor - from->factor) * (i % 3 == 2 ? 0.5 : secant), &at, err);
        if (status == THUD_OK)
            *(touches(at) == touches(*to) ? to : from) = at;
    }
    return status;
}

/* How far a trial is from the change that is looked for, in ln U: 0 at it, below 0 before it. */
static double towards(struct trial at, bool contact)
{
    const double logarithm = log(fmax(at.used, 1e-9));
    return contact ? -logarithm : logarithm;
}

/* Whether a change may lie between three trials, by how far the middle one is off the line of the others. */
static bool may_change(const struct trial at[3], bool contact)
{
    const double top = towards(at[1], contact), left = towards(at[0], contact), right = towards(at[2], contact);
    return top > left && top >= right && -top < promising * (top - fmin(left, right));
}

/* Between three trials of which the middle one comes nearest to a change: whether there is one. Then [1] and [2] are
 * before and behind it. */
static enum thud_status look_between(const struct search *search, struct trial at[3], bool *found,
                                     struct thud_error *err)
{
    enum { RUNS = 10 };
    const bool contact = touches(at[1]);
    enum thud_status status = THUD_OK;
    for (int i = 0; i < RUNS && status == THUD_OK && !*found && may_change(at, contact); i++) {
        const bool right = at[2].factor - at[1].factor > at[1].factor - at[0].factor;
        struct trial middle;
        status = run_at(search, sqrt(at[1].factor * at[right ? 2 : 0].factor), &middle, err);
        if (status != THUD_OK)
            break;
        *found = touches(middle) != contact;
        const bool nearer = towards(middle, contact) > towards(at[1], contact);
        if (*found)
            at[1] = right ? at[1] : at[0], at[2] = middle;
        else if (nearer)
            at[right ? 0 : 2] = at[1], at[1] = middle;
        else
            at[right ? 2 : 0] = middle;
    }
    return status;
}

/* Upwards from *from, until contact is what it is not there: *from and *to are before and behind the change. *found:
 * false where there is none up to `till`, or the share is `enough` away. */
static enum thud_status next_change(const struct search *search, double till, double enough, struct trial *from,
                                    struct trial *to, bool *found, struct thud_error *err)
{
    const bool contact = touches(*from);
    struct trial at[3] = {*from, *from, *from};
    enum thud_status status = THUD_OK;
    *found = false;
    while (status == THUD_OK && !*found && at[2].factor < till && fabs(towards(at[2], contact)) < enough) {
        const double step = fmin(long_step, fmax(short_step, part * fabs(towards(at[2], contact))));
        struct trial next;
        status = run_at(search, at[2].factor * exp(step), &next, err);
        if (status != THUD_OK)
            break;
        at[0] = at[1];
        at[1] = at[2];
        at[2] = next;
        *found = touches(next) != contact;
        if (!*found && may_change(at, contact)) {
            struct trial between[3] = {at[0], at[1], at[2]};
            status = look_between(search, between, found, err);
            if (*found)
                at[1] = between[1], at[2] = between[2];
        }
    }
    *from = at[1];
    *to = at[2];
    return status == THUD_OK && *found ? close_in(search, from, to, err) : status;
}

/* Downwards to where so little of the clearances is used up, twice, that no contact is expected below. */
static enum thud_status begin(const struct search *search, struct trial *at, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int apart = at->used < far; status == THUD_OK && apart < 2 && at->factor > least;) {
        status = run_at(search, at->factor / exp(2 * long_step), at, err);
        apart = at->used < far ? apart + 1 : 0;
    }
    return status;
}

/* Whether storeys that yield are all that is not linear. Errors: THUD_MEMORY. */
static enum thud_status is_elastic_first(const struct thud_scene *scene, bool *elastic, struct thud_error *err)
{
    struct thud_scene *hardened = malloc(sizeof *hardened);
    if (!hardened)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    thud_scene_copy(hardened, scene);
    for (int s = 0; s < scene->nstructures; s++)
        for (int i = 0; i < scene->structure[s].storeys; i++)
            hardened->structure[s].hardening[i] = 1;
    *elastic = thud_scene_scales(hardened);
    free(hardened);
    return THUD_OK;
}

/* To the factor at which the first storey yields, from a run below it. */
static enum thud_status until_yield(const struct search *search, struct trial *at, struct thud_error *err)
{
    static const double below = 1.05; /* the ductility is about in proportion to the factor */
    enum thud_status status = THUD_OK;
    while (status == THUD_OK && at->ductility > 1)
        status = run_at(search, at->factor / (below * at->ductility), at, err);
    at->factor /= at->ductility;
    at->used /= at->ductility;
    at->ductility = 1;
    return status;
}

enum thud_status thud_first_contact_find(const struct thud_scene *scene, const struct thud_record *record,
                                         const struct thud_needed_gap *gap, struct thud_first_contact *out,
                                         struct thud_error *err)
{
    const struct search search = {scene, record};
    struct trial from = {1, used_up(scene, gap), gap->ductility}, to;
    bool found, elastic;
    *out = (struct thud_first_contact){from.used > 0 ? 1 / from.used : INFINITY, NAN};
    if (thud_scene_scales(scene) || !record || isinf(from.used))
        return THUD_OK;
    enum thud_status status = is_elastic_first(scene, &elastic, err);
    elastic = elastic && from.ductility > 0;
    if (status == THUD_OK)
        status = elastic ? until_yield(&search, &from, err) : begin(&search, &from, err);
    if (status == THUD_OK && touches(from) && !elastic) { /* what moves without the ground motion closes it */
        out->first = 0;
        return THUD_OK;
    }
    if (status == THUD_OK && touches(from)) {
        out->first = from.factor / from.used;
    } else {
        if (status == THUD_OK)
            status = next_change(&search, most, INFINITY, &from, &to, &found, err);
        if (status != THUD_OK || !found) {
            out->first = INFINITY;
            return status;
        }
        out->first = to.factor;
        from = to;
    }
    status = next_change(&search, fmax(1, 2 * out->first), log(2), &from, &to, &found, err);
    out->clear_again = status == THUD_OK && found ? to.factor : NAN;
    return status;
}
