/* Each mode of a contact has guards: a function of time that is watched, the sign that it must not take, and the event
 * when it does (as the root functions of CVODE, with rootdir and gactive). The functions are polynomials of the
 * segment, so that the first crossing is found with bounds and no grazing is missed. A guard that has just fired starts
 * at 0: that many of its lowest coefficients are taken as 0 (struct thud_suppressed), else rounding would decide. */
#include "core/contact/event.h"

#include <math.h>
#include <string.h>

#include "base/largest.h"
#include "core/numerics/poly.h"
#include "core/numerics/tolerance.h"
#include "core/numerics/vec.h"

/* Glossary, for contact c and a segment of length h with s = (t - t0)/h.
 *
 *     d(s), d'(s)    indentation and its rate, polynomials in s; d[k]: coefficient of s^k
 *     p(s)           what a guard watches: it has the sign of the guard's function, and fires where sign * p rises above 0
 *     sign           +1: p comes from below; -1: from above; 0 in the table: by the phase or the side of the branch
 *     suppressed     number of lowest coefficients of p that are taken as 0, as the last event has put p
 *                    there and rounding may not decide which way it goes; `order` of the event that follows
 *     middle, reach  d and d' are as far as this from there at most, in the segment
 *     s_end, limit   how far the segment counts; no later than the first event found so far
 *
 * Deactivation: a guard with suppressed > 0 whose lowest coefficient that is left points away does not fire before p
 * has come back. */

enum watched { INDENTATION, FORCE, RATE, BRANCH, CONSTRAINT_LOW, CONSTRAINT_HIGH };

static const struct guards {
    int count;
    struct guard {
        enum watched watched;
        int sign; /* that the function takes at the event; 0: by the phase, or the side of the branch, of the contact */
        enum thud_event event;
    } guard[4];
} guards_of[] = {
    [THUD_OPEN] = {1, {{INDENTATION, 1, THUD_EVENT_ONSET}}},
    [THUD_CLOSED] = {4,
                     {{INDENTATION, -1, THUD_EVENT_SEPARATION},
                      {FORCE, -1, THUD_EVENT_RELEASE},
                      {RATE, 0, THUD_EVENT_REVERSAL},
                      {BRANCH, 0, THUD_EVENT_BRANCH}}},
    [THUD_CLOSED_NO_FORCE] = {2, {{INDENTATION, -1, THUD_EVENT_SEPARATION}, {FORCE, 1, THUD_EVENT_REENGAGE}}},
    [THUD_STICKING] = {2, {{CONSTRAINT_LOW, -1, THUD_EVENT_UNSTICK_OUT}, {CONSTRAINT_HIGH, 1, THUD_EVENT_UNSTICK_IN}}},
};

const struct thud_event_words thud_event_words[] = {
    [THUD_EVENT_ONSET] = {"onset", "d rises"},
    [THUD_EVENT_SEPARATION] = {"separation", "d falls"},
    [THUD_EVENT_RELEASE] = {"release", "F falls"},
    [THUD_EVENT_REENGAGE] = {"re-engagement", "F rises"},
    [THUD_EVENT_REVERSAL] = {"reversal", "d' turns"},
    [THUD_EVENT_BRANCH] = {"branch", "d - delta_u"},
    [THUD_EVENT_UNSTICK_IN] = {"unsticks inward", "F - F_high rises"},
    [THUD_EVENT_UNSTICK_OUT] = {"unsticks outward", "F - F_low falls"},
    [THUD_EVENT_YIELD_UP] = {"yield", "d - d_p - d_y rises"},
    [THUD_EVENT_YIELD_DOWN] = {"yield", "d - d_p + d_y falls"},
    [THUD_EVENT_UNLOAD] = {"unload", "d' turns"},
    [THUD_EVENT_COLLAPSE] = {"collapse", "|d| - h/10 rises"},
};

/* A contact in the segment at hand. */
struct view {
    const struct thud_state *state;
    const struct thud_segment *seg;
    int c;
    const double *d; /* indentation; its lowest orders are 0 where rounding alone has left them; NULL: not read yet */
    thud_vec2 middle, reach; /* of indentation and rate: how far they may be from a value */
    struct thud_suppressed suppressed;
};

/* What a guard watches as f + k d + c d', and how many of its lowest orders are 0. */
struct line {
    double f, k, c;
    int suppressed;
};

/* The one of a guard but of constraints; false where it cannot take the sign, as a force that cannot reach 0 before the
 * indentation does. Of a force what has its sign: itself, or of (elastic force) (1 + D/K v) the second factor times K. */
static bool line_of(const struct view *v, enum watched watched, struct line *out)
{
    const struct thud_contact_state *s = &v->state->contact[v->c];
    const unsigned flags = v->state->model->contact[v->c].law->flags;
    const struct thud_branch *b = &s->branch;
    const bool power = b->K != 0;
    if (watched == INDENTATION) {
        *out = (struct line){.k = 1, .suppressed = v->suppressed.indentation};
        return true;
    }
    if (watched == RATE) {
        *out = (struct line){.c = 1, .suppressed = v->suppressed.rate};
        return flags & THUD_LAW_REVERSES;
    }
    if (watched == BRANCH) {
        *out = (struct line){.f = -s->ultimate_m, .k = 1, .suppressed = v->suppressed.branch};
        return s->ultimate_m < INFINITY;
    }
    if (s->mode != THUD_CLOSED_NO_FORCE && flags & THUD_LAW_PULLS)
        return false;
    if (power || b->D != 0)
        *out = (struct line){.f = power ? b->K : b->k_npm, .c = b->D, .suppressed = v->suppressed.force};
    else
        *out = (struct line){b->f0_n, b->k_npm, b->c_nspm, v->suppressed.force};
    return power ? b->D != 0 && b->p == b->r : !(b->D == 0 && b->c_nspm == 0 && b->f0_n == 0);
}

/* A force so small that a collocated step says nothing of it; 0 in others. */
static double unresolved_force(const struct view *v)
{
    return v->seg->nodes ? v->state->tolerance * thud_contact_least_force(v->state, v->c) : 0;
}

/* How far the constraint force of a STICKING contact is from one end of its interval, less what rounding leaves of equal
 * forces, by which neighbours that move alike are held together, and what a step does not resolve. Just after it began
 * to stick, a force that is outside by no more than the accuracy of its polynomial is taken to start at the end. */
static void constraint_function(const struct view *v, bool high, double *out)
{
    const struct thud_state *state = v->state;
    const struct thud_contact_state *s = &state->contact[v->c];
    const double mass_kg = state->model->contact[v->c].setup.mass_kg, side = high ? 1 : -1,
                 accuracy = v->suppressed.force > 0 ? 10 * state->tolerance * mass_kg * state->ground_mps2 : 0;
    thud_segment_force(v->seg, state->model->nrows, v->c, v->seg->terms, out);
    out[0] -= high ? s->constraint_high_n : s->constraint_low_n;
    if (side * out[0] > 0 && side * out[0] <= accuracy)
        out[0] = 0;
    out[0] -= side * thud_larger(mass_kg * thud_contact_rounding(state), unresolved_force(v));
}

/* How fast the state itself changes what a guard watches. */
static double slope_now(const struct view *v, const struct line *line)
{
    double *force = v->state->force_now;
    thud_contact_forces(v->state, force);
    return line->k * thud_contact_rate(v->state, v->c) + line->c * thud_contact_acceleration(v->state, v->c, force);
}

/* When p takes this sign, which it may have just left (`suppressed`). At once only if the state's own slope says so:
 * that of the polynomial may be too small for the method to resolve, and wrong, and would start chattering. Then its
 * lowest orders are passed over. */
static double crossing(const struct view *v, const struct line *line, const double *p, int n, double s_end, double sign)
{
    int suppressed = line->suppressed;
    double s = thud_poly_first_above(p, n, s_end, sign, suppressed, 0);
    if (s > 0 || suppressed == 0 || v->state->contact[v->c].suppressed.indentation > 0 || sign * slope_now(v, line) > 0)
        return s;
    while (s == 0 && ++suppressed < n)
        s = thud_poly_first_above(p, n, s_end, sign, suppressed, 0);
    return s > 0 ? s : INFINITY;
}

/* The sign at which a guard fires whose sign is that of the contact. */
static int sign_of(const struct thud_contact_state *s, enum watched watched)
{
    if (watched == RATE)
        return s->phase == THUD_APPROACH ? -1 : 1;
    return s->past_ultimate ? -1 : 1;
}

/* A contact turns back to approach where it is faster than half of the speed of rest, and one whose force is not resolved
 * either way: what is pressed, or moves like its neighbour, would turn with each step. One that has just turned does so
 * again where errors of the forces, as they grow from 0, cannot have made it. */
static void pass_over_errors(const struct view *v, struct line *line, double *rate, int sign)
{
    const struct thud_model *m = v->state->model;
    if (sign > 0 ||
        thud_row_force(v->state, v->c, thud_contact_indentation(v->state, v->c), 0) <= unresolved_force(v)) {
        memset(rate, 0, (size_t)line->suppressed * sizeof *rate);
        rate[0] -= 0.5 * sign * thud_rest_speed(v->state); /* should it stick, it is at rest */
        line->suppressed = 0;
    }
    for (int b = 0; b < m->nrows && (line->suppressed == 1 || line->suppressed == 2); b++)
        rate[2] -=
            sign * 0.5 * v->seg->h_s * v->state->tolerance * fabs(m->delassus[v->c * m->nrows + b] * v->seg->force[b]);
}

/* Whether what a guard watches keeps its sign by the bounds of indentation and rate alone: most do. */
static bool stays(const struct view *v, const struct line *line, int sign)
{
    const thud_vec2 by = {line->k, line->c}, most = sign * by * v->middle + thud_vec2_abs(by) * v->reach;
    return line->suppressed == 0 && sign * line->f + thud_vec2_sum(most) < 0;
}

/* s in [0, s_end] at which a guard fires. */
static double guard_fires(struct view *v, const struct guard *guard, double s_end, int *order)
{
    const struct thud_contact_state *s = &v->state->contact[v->c];
    const int n = v->seg->terms, sign = guard->sign != 0 ? guard->sign : sign_of(s, guard->watched);
    const bool high = guard->watched == CONSTRAINT_HIGH;
    double p[THUD_SEGMENT_TERMS + 1];
    struct line line = {0};
    *order = 0;
    if (s->mode == THUD_STICKING) {
        if (high && s->constraint_high_n == INFINITY)
            return INFINITY;
        constraint_function(v, high, p);
        return thud_poly_first_above(p, n, s_end, sign, 0, 0);
    }
    if (!line_of(v, guard->watched, &line) || stays(v, &line, sign))
        return INFINITY;
    if (!v->d)
        v->d = thud_segment_read(v->state, v->seg, v->c);
    *order = line.suppressed;
    const double c = line.c / v->seg->h_s;
    for (int k = 0; k + 1 < n; k++)
        p[k] = line.k * v->d[k] + c * (k + 1) * v->d[k + 1];
    p[n - 1] = line.k * v->d[n - 1];
    p[0] += line.f;
    if (guard->watched == RATE && v->seg->nodes)
        pass_over_errors(v, &line, p, sign);
    if (guard->watched == FORCE || guard->watched == RATE)
        return crossing(v, &line, p, n, s_end, sign);
    if (s->mode == THUD_OPEN && line.suppressed >= n)
        return INFINITY;
    return thud_poly_first_above(p, n, s_end, sign, line.suppressed, s->mode == THUD_OPEN ? v->state->touch_m : 0);
}

/* Contact onset without speed, and only then pushed together: how many of the lowest orders of d (terms) the accuracy of
 * the contact force does not resolve. What it leaves there would open the contact again, endlessly. In a collocated step d
 * gets besides what an error of the force may take off: its polynomial should start at 0, and says nothing of less than
 * unresolved_force. */
static int unresolved(const struct view *v, double *d, int suppressed)
{
    const int terms = v->seg->terms;
    const double h = v->seg->h_s, error_n = thud_larger(2 * fabs(v->seg->force[v->c]), unresolved_force(v));
    double largest = 0, resolved = fmax(v->state->tolerance, THUD_TOL_UNRESOLVED);
    for (int k = 0; k < terms; k++)
        largest = fmax(largest, fabs(d[k]));
    while (suppressed < terms && fabs(d[suppressed]) <= resolved * largest)
        suppressed++;
    if (!v->seg->nodes)
        return suppressed < terms ? suppressed : terms - 1;
    memset(d, 0, (size_t)suppressed * sizeof *d);
    d[2] += 0.5 * h * h * error_n / v->state->model->contact[v->c].setup.mass_kg;
    return 2;
}

/* Sum over the structures on both sides of a contact of what any of their floors comes to. */
static double any_floors(const struct thud_model *m, int c, const double *of_structure)
{
    const struct thud_model_side *l = &m->contact[c].left, *r = &m->contact[c].right;
    return (l->modes > 0 ? of_structure[l->structure] : 0) + (r->modes > 0 ? of_structure[r->structure] : 0);
}

/* Bounds by the nodes of a collocated step: between two of them d' lies off the straight line through them by widest^2/8
 * times the largest d''' at most, of which the modes have a bound; and d off the nearest by half that distance times the
 * largest d'. */
static void see_nodes(struct view *v)
{
    const struct thud_segment_nodes *nodes = v->seg->nodes;
    const thud_vec2 *motion = nodes->motion + nodes->at[v->c] * nodes->points;
    const double h = v->seg->h_s, third = any_floors(v->state->model, v->c, v->seg->notes->thirds);
    thud_vec2 high = motion[0], under = -high; /* the lowest times -1 */
    for (int i = 1; i < nodes->count; i++) {
        high = thud_vec2_larger(motion[i], high);
        under = thud_vec2_larger(-motion[i], under);
    }
    const double rate = nodes->widest * nodes->widest / 8 * third / h,
                 way = 0.5 * nodes->widest * h * (thud_larger(under[1], high[1]) + rate);
    v->middle = 0.5 * (high - under);
    v->reach = 0.5 * (high + under) + thud_vec2_set(way, rate);
}

/* The contact as its guards see it. `copy` (terms) may take its indentation. */
static struct view view_of(const struct thud_state *state, const struct thud_segment *seg, int c, double *copy)
{
    const struct thud_contact_state *s = &state->contact[c];
    const bool moved = s->suppressed.indentation == 0 || (s->mode != THUD_OPEN && s->mode != THUD_CLOSED);
    struct view v = {.state = state, .seg = seg, .c = c, .suppressed = s->suppressed};
    if (moved && seg->nodes && seg->nodes->at[c] >= 0) {
        see_nodes(&v);
        return v;
    }
    int suppressed = thud_segment_contact(state, seg, c);
    v.d = thud_segment_read(state, seg, c);
    if (!moved) { /* the contact has just begun or ended */
        if (s->mode == THUD_CLOSED) {
            memcpy(copy, v.d, (size_t)seg->terms * sizeof *copy);
            memset(copy, 0, (size_t)suppressed * sizeof *copy); /* a stiff contact would make a force of rounding */
            v.d = copy;
            if (s->suppressed.rate > 0)
                suppressed = unresolved(&v, copy, suppressed);
            v.suppressed.rate = (int)thud_larger(s->suppressed.rate, suppressed - 1);
        }
        v.suppressed.indentation = (int)thud_larger(s->suppressed.indentation, suppressed);
    }
    double rate, way = thud_poly_move(v.d, seg->terms, &rate);
    v.middle = thud_vec2_set(v.d[0], v.d[1] / seg->h_s);
    v.reach = thud_vec2_set(way, rate / seg->h_s);
    return v;
}

/* Whether an open contact may close in the segment, by what its modes can do at most. */
static bool may_close(const struct thud_state *state, const struct thud_segment *seg, int c)
{
    const struct thud_model *m = state->model;
    if (m->contact[c].law->flags & THUD_LAW_NO_FORCE)
        return false;
    if (state->contact[c].suppressed.indentation > 0)
        return true;
    double motion[2];
    thud_contact_motion(state, c, motion);
    return motion[0] + thud_larger(motion[1], 0) * seg->h_s + any_floors(m, c, seg->notes->floors) > 0;
}

/* When the drift of the storey below a floor comes to where it has collapsed, on either side. */
static double storey_collapses(const struct thud_model *m, const struct thud_segment *seg, int structure, int floor,
                               double s_end)
{
    const struct thud_model_structure *of = &m->structure[structure];
    double p[THUD_SEGMENT_TERMS], first = INFINITY;
    thud_dots(of->modes, of->lean + floor * of->modes, seg->q + of->first_mode, m->nmodes, seg->terms, p);
    const double start = p[0];
    for (int side = -1; side <= 1; side += 2) {
        p[0] = start - side * of->collapse_m[floor];
        first = fmin(first, thud_poly_first_above(p, seg->terms, fmin(s_end, first), side, 0, 0));
    }
    return first;
}

/* The first collapse of any storey, and the floor above it; bounds of the modes show that as a rule there is none. */
static double collapses(const struct thud_model *m, const struct thud_segment *seg, double s_end, int *dof)
{
    double first = INFINITY;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *of = &m->structure[s];
        double most = 0;
        for (int j = of->first_mode; of->collapse_m && j < of->first_mode + of->modes; j++)
            most +=
                thud_model_most_lean(m, of, j) * (fabs(seg->q[j]) + fabs(seg->q[m->nmodes + j]) + seg->notes->bound[j]);
        for (int i = 0; most > of->collapse_least_m && i < of->n; i++) {
            const double at = storey_collapses(m, seg, s, i, fmin(s_end, first));
            if (at < first) {
                first = at;
                *dof = of->first + i;
            }
        }
    }
    return first;
}

double thud_event_storey(const struct thud_state *state, int k, const double *d, int n, bool fresh, double s_end,
                         enum thud_event *event, int *order)
{
    const struct thud_storey_state *s = &state->storey[k];
    double p[THUD_SEGMENT_TERMS], first = INFINITY;
    if (s->direction != 0) {
        for (int i = 0; i + 1 < n; i++)
            p[i] = (i + 1) * d[i + 1];
        *event = THUD_EVENT_UNLOAD;
        *order = fresh ? s->suppressed : 0;
        return thud_poly_first_above(p, n - 1, s_end, -s->direction, *order, 0);
    }
    memcpy(p, d, (size_t)n * sizeof *p);
    for (int side = -1; side <= 1; side += 2) {
        const int suppressed = fresh && s->suppressed_side == side ? s->suppressed : 0;
        p[0] = d[0] - s->plastic_m - side * state->model->storey[k].yield_m;
        const double at = thud_poly_first_above(p, n, fmin(s_end, first), side, suppressed, state->touch_m);
        if (at < first) {
            first = at;
            *order = suppressed;
            *event = side > 0 ? THUD_EVENT_YIELD_UP : THUD_EVENT_YIELD_DOWN;
        }
    }
    return first;
}

/* The same in the segment; what its modes can do at most shows that as a rule there is none. */
static double storey_fires(const struct thud_state *state, const struct thud_segment *seg, int k, double s_end,
                           enum thud_event *event, int *order)
{
    const struct thud_model *m = state->model;
    const struct thud_storey_state *s = &state->storey[k];
    const int row = m->ncontacts + k;
    if (s->direction == 0 && s->suppressed == 0) {
        const double bound = m->storey[k].yield_m;
        double most =
            fabs(thud_contact_indentation(state, row) - s->plastic_m) + fabs(thud_contact_rate(state, row)) * seg->h_s;
        if (m->storey[k].link < 0 && most + seg->notes->drifts[m->storey[k].structure] <= bound)
            return INFINITY;
        const struct thud_model_structure *of = &m->structure[m->storey[k].structure];
        const double *g = m->jacobian + row * m->nmodes;
        for (int j = of->first_mode; j < of->first_mode + of->modes; j++)
            most += fabs(g[j]) * seg->notes->bound[j];
        if (most <= bound)
            return INFINITY;
    }
    return thud_event_storey(state, k, thud_segment_read(state, seg, row), seg->terms, true, s_end, event, order);
}

/* Whether the segment goes on as it is where the contact is released or parts at s: it does not come back, and has no
 * force any more, or one that its polynomial ends as well as the tolerance asks; at d = 0 with its slope. */
static bool ends_quietly(const struct view *v, enum thud_event event, double s)
{
    enum { PLACES = 4 };
    static const double part = 0.3; /* of the tolerance, as a step's error at most */
    const struct thud_contact_state *contact = &v->state->contact[v->c];
    const bool ends = event == THUD_EVENT_SEPARATION ? thud_branch_is_smooth(&contact->branch)
                                                     : v->seg->nodes && !contact->past_ultimate &&
                                                           !v->state->model->contact[v->c].law->keeps_residual;
    double force[THUD_SEGMENT_TERMS], most = 0;
    if (v->seg->interpolates || !(v->middle[1] + v->reach[1] < 0))
        return false;
    if (contact->mode == THUD_CLOSED_NO_FORCE)
        return true;
    thud_segment_force(v->seg, v->state->model->nrows, v->c, v->seg->loaded, force);
    for (int i = 1; i <= PLACES && ends; i++)
        most = thud_larger(most, fabs(thud_poly_value(force, v->seg->loaded, s + (1 - s) * i / PLACES)));
    return ends && most <= part * v->state->tolerance * contact->expected_force_n;
}

/* Whether the contact only goes deeper in the segment, on the branch that it begins with. */
static bool goes_deeper(const struct view *v)
{
    return v->middle[1] > v->reach[1] && v->middle[0] + v->reach[0] < v->state->contact[v->c].ultimate_m;
}

/* Whether nothing can happen to a closed contact: it goes deeper, and its force does not fall to 0 by that. */
static bool goes_on(const struct view *v)
{
    const struct thud_contact_state *s = &v->state->contact[v->c];
    return s->mode == THUD_CLOSED && s->phase == THUD_APPROACH && s->branch.f0_n >= 0 && s->branch.k_npm >= 0 &&
           v->middle[0] > 0 && goes_deeper(v);
}

double thud_event_first(const struct thud_state *state, const struct thud_segment *seg, double s_end, int *contact,
                        enum thud_event *event, int *order)
{
    double first = INFINITY, copy[THUD_SEGMENT_TERMS];
    int suppressed = 0;
    *contact = -1;
    *order = 0;
    *event = THUD_EVENT_NONE;
    thud_segment_bounds(seg, state->model, s_end);
    for (int c = 0; c < state->model->ncontacts; c++) {
        enum thud_contact_mode mode = state->contact[c].mode;
        if (mode == THUD_OPEN && !may_close(state, seg, c))
            continue;
        struct view v = view_of(state, seg, c, copy);
        if (goes_on(&v))
            continue;
        double limit = thud_smaller(s_end, first);
        const struct guards *guards = &guards_of[mode];
        for (const struct guard *guard = guards->guard; guard < guards->guard + guards->count; guard++) {
            const double s = guard_fires(&v, guard, limit, &suppressed);
            if (s <= limit && (guard->event == THUD_EVENT_SEPARATION || guard->event == THUD_EVENT_RELEASE) &&
                ends_quietly(&v, guard->event, s)) {
                *(guard->event == THUD_EVENT_RELEASE ? &seg->notes->released[c] : &seg->notes->parted[c]) = limit = s;
                seg->notes->quiet = true;
            } else if (s <= limit && guard->event == THUD_EVENT_ONSET && seg->nodes && seg->nodes->at[c] >= 0 &&
                       goes_deeper(&v)) { /* it was solved for too */
                seg->notes->begun[c] = s;
                seg->notes->quiet = true;
            } else if (s < first) {
                first = s;
                *contact = c;
                *event = guard->event;
                *order = suppressed;
            }
        }
    }
    for (int k = 0; k < state->model->nstoreys; k++) {
        enum thud_event of_storey = THUD_EVENT_NONE;
        double s = storey_fires(state, seg, k, fmin(s_end, first), &of_storey, &suppressed);
        if (s < first) {
            first = s;
            *contact = state->model->ncontacts + k;
            *event = of_storey;
            *order = suppressed;
        }
    }
    int dof = -1;
    const double fall = state->model->collapses ? collapses(state->model, seg, fmin(s_end, first), &dof) : INFINITY;
    if (fall < first) {
        first = fall;
        *contact = state->model->nrows + dof;
        *event = THUD_EVENT_COLLAPSE;
        *order = 0;
    }
    return first;
}
