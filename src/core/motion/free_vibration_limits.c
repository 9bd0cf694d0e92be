/* How far a value inside an interval may lie above those at its ends, and with that the first interval in which a contact
 * closes or a storey yields (thud-methods(7), eqs. 4 and 5).
 *
 * Glossary, for a block of intervals of length dt; j is a mode, x a quantity of a floor.
 *
 *     S_j        f->speed: largest sqrt(q'^2 + omega^2 (q - s)^2) at the ends; inside an interval it grows by no more than
 *                dt |gamma| times the largest ground acceleration, as damping takes energy and the springs keep it
 *     bound[k]   B_k, bound of the k-th derivative of q_j inside the intervals: from q'' = -omega^2 (q - s) - z q' -
 *                gamma a_g (z = 2 zeta omega) with |omega (q - s)| and |q'| both below S, and its derivatives. Where
 *                damping couples the modes of a system, f->bound: of sqrt(sum over its modes of (d^k q_j/dt^k)^2)
 *     slope      largest |da_g/dt|; a_g is a straight line in each interval, so that no higher one has a part
 *     margin     dt^2/8 B_2 of a value: error of the chord between its ends, whose largest is at an end
 *     cubic      dt^4/384 B_4 of a value: error of the cubic through values and rates at the ends (Hermite's)
 *     limit      clearance of a contact less the margins of its sides: below it at both ends, the contact stays open
 *
 * Three sieves, each for what the one before lets through: by S alone for the whole block (swing_of), by the values at
 * the ends of an interval and the margin (find_near), and by the power series of the interval (closes). */
#include "core/motion/free_vibration_parts.h"

#include <math.h>
#include <string.h>

#include "base/largest.h"
#include "core/contact/event.h"
#include "core/numerics/poly.h"
#include "core/numerics/tolerance.h"
#include "core/numerics/vec.h"

enum { BOUNDS = THUD_FREE_VIBRATION_BOUNDS };

/* Bounds of the derivatives of order 2 or more of two modes, or one, in the block. */
static thud_vec2 mode_bounds(const struct thud_free_vibration *f, const struct thud_model *m, int j, bool single,
                             int order)
{
    const thud_vec2 w2 = thud_vec2_some(m->spring + j, single), z = thud_vec2_some(m->dashpot + j, single),
                    gamma = thud_vec2_abs(thud_vec2_some(m->gamma + j, single)), ground = gamma * f->ground_most,
                    speed = thud_vec2_some(f->speed + j, single) + f->dt_s * ground; /* S_j inside the intervals */
    thud_vec2 bound = (thud_vec2_some(m->omega + j, single) + z) * speed + ground,
              next = w2 * speed + z * bound + gamma * f->slope;
    for (int k = 2; k < order; k++) {
        const thud_vec2 after = w2 * bound + z * next;
        bound = next;
        next = after;
    }
    return bound;
}

/* Size of a ground acceleration of 1 in modal coordinates. */
static double ground_size(const struct thud_model *m, const struct thud_model_structure *p)
{
    return sqrt(thud_dot(p->modes, m->gamma + p->first_mode, m->gamma + p->first_mode));
}

/* The same of a system whose damping couples its modes, by the energy norm of each derivative: with a_g a straight line
 *
 *     y_k = (Omega d^k q, d^(k+1) q),   d|y_k|/dt <= |gamma da_g/dt| for k = 1, and 0 from there on,
 *
 * whatever the damping, as that only takes energy. So the norms at the starts of the intervals are all that is needed.
 * While a storey yields, kappa < 0, this holds of the norms with Omega^2 + kappa g g^T, and those with Omega lie above.
 * Of order k, out of those of the two orders below. */
static double make_bound(struct thud_free_vibration *f, const struct thud_model *m, int system, int k)
{
    const struct thud_model_structure *p = &m->structure[m->system[system]];
    const int intervals = f->ends - 1;
    const double level = k == 2, slopes = k == 3 ? 1 / f->dt_s : 0; /* how the ground enters */
    const double *x = k == 2 ? f->moved : k == 3 ? f->qd : f->work[(k - 2) % 3];
    const double *v = k == 2 ? f->qd : f->work[(k - 1) % 3];
    double *out = f->work[k % 3], norm[ENDS] = {0}, ground[ENDS], *force = k == 2 ? f->acceleration : out;
    thud_free_vibration_spring(f, m, p, x, v, force);
    for (int t = 0; t < f->ends; t++)
        ground[t] = level * f->ground[t] + slopes * (f->after[t] - f->ground[t]);
    for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
        const double gamma = m->gamma[j], spring = m->spring[j];
        for (int t = 0, at = j * ENDS; t < intervals; t += 2, at += 2) {
            const thud_vec2 rate = thud_vec2_at(v + at),
                            second = thud_vec2_at(force + at) - gamma * thud_vec2_at(ground + t);
            thud_vec2_put(second, out + at);
            thud_vec2_put(thud_vec2_at(norm + t) + second * second + spring * rate * rate, norm + t);
        }
    }
    return sqrt(thud_largest(norm, intervals)) + level * ground_size(m, p) * f->dt_s * f->slope;
}

/* Made where it is asked for. */
static double bound_of(struct thud_free_vibration *f, const struct thud_model *m, int system, int order)
{
    double *bound = f->bound + system * BOUNDS;
    for (int k = 2; k <= order; k++)
        if (isnan(bound[k]))
            bound[k] = make_bound(f, m, system, k);
    return bound[order];
}

double thud_free_vibration_bend(struct thud_free_vibration *f, const struct thud_model *m, int structure,
                                const double *row, int order)
{
    const struct thud_model_structure *p = &m->structure[structure];
    thud_vec2 sum = {0, 0};
    if (p->damping)
        return sqrt(thud_dot(p->modes, row, row)) * bound_of(f, m, p->system, order);
    for (int j = 0; j < p->modes; j += 2) {
        const bool single = j + 1 == p->modes;
        sum += thud_vec2_abs(thud_vec2_some(row + j, single)) * mode_bounds(f, m, p->first_mode + j, single, order);
    }
    return thud_vec2_sum(sum);
}

double thud_free_vibration_floor_bend(struct thud_free_vibration *f, const struct thud_model *m, int structure,
                                      int quantity, int more)
{
    const bool drift = quantity == THUD_FLOOR_DRIFT;
    const double *most = m->mode_max + (drift ? m->nmodes : 0) + m->structure[structure].first_mode;
    return thud_free_vibration_bend(f, m, structure, most, more + (drift ? 0 : quantity));
}

double thud_free_vibration_margin(struct thud_free_vibration *f, const struct thud_model *m, int structure,
                                  int quantity)
{
    double *margin = &f->margin[quantity * m->nstructures + structure];
    if (isnan(*margin))
        *margin = thud_free_vibration_floor_bend(f, m, structure, quantity, 2) * f->dt_s * f->dt_s / 8;
    return *margin;
}

double thud_free_vibration_size(struct thud_free_vibration *f, const struct thud_model *m, int structure, int quantity)
{
    const struct thud_model_structure *p = &m->structure[structure];
    const double second = bound_of(f, m, p->system, 2);
    return quantity == THUD_FLOOR_VELOCITY ? 0.5 * f->dt_s * second : second + ground_size(m, p) * f->ground_most;
}

/* Whether contact c closes in the piece of the segment. At the very start of the block a contact may have just opened: so
 * many of its lowest orders say nothing of a new onset. */
static bool closes_in_piece(const struct thud_state *state, const struct thud_segment *seg, int c, bool first)
{
    double d[THUD_SEGMENT_TERMS];
    int suppressed = thud_segment_indentation(state, seg, c, d), least = state->contact[c].suppressed.indentation;
    if (!first || least == 0)
        suppressed = 0;
    else if (suppressed < least)
        suppressed = least;
    return suppressed < seg->terms && thud_poly_first_above(d, seg->terms, 1, 1, suppressed, state->touch_m) <= 1;
}

/* Whether one of the contacts that are near it closes in interval t. */
static bool closes(struct thud_free_vibration *f, const struct thud_state *state, int t)
{
    for (int piece = 0; piece < f->pieces; piece++)
        for (int c = 0; c < state->model->ncontacts; c++)
            if (f->near[c] &&
                closes_in_piece(state, thud_free_vibration_row_series(f, state, c, t, piece), c, t == 0 && piece == 0))
                return true;
    return false;
}

/* Of one side of a contact, from the floors' displacements at one end, rows ENDS apart. */
static double side_value(const struct thud_model_side *side, const double *u)
{
    double value = side->dof < 0 ? 0 : side->share * u[(size_t)side->dof * ENDS];
    value += side->below < 0 ? 0 : (1 - side->share) * u[(size_t)side->below * ENDS];
    return side->tilt < 0 ? value : value + side->by_tilt * u[(size_t)side->tilt * ENDS];
}

double thud_free_vibration_side(struct thud_free_vibration *f, const struct thud_model *model,
                                const struct thud_model_side *side, int ends, double *margin)
{
    thud_free_vibration_values(f, model, side->structure, THUD_FLOOR_DISPLACEMENT);
    const double *u = f->value[THUD_FLOOR_DISPLACEMENT];
    *margin = thud_free_vibration_margin(f, model, side->structure, THUD_FLOOR_DISPLACEMENT);
    for (int t = 0; t < ends; t++)
        f->gap[t] = fabs(side_value(side, u + t));
    return thud_largest(f->gap, ends);
}

/* How far the displacement of one side less that of the other, also of what lies between two floors, may lie above its
 * values at the ends. */
static double gap_margin(struct thud_free_vibration *f, const struct thud_model *m, const struct thud_model_contact *p)
{
    return (p->left_dof < 0 ? 0 : thud_free_vibration_margin(f, m, p->left.structure, THUD_FLOOR_DISPLACEMENT)) +
           (p->right_dof < 0 ? 0 : thud_free_vibration_margin(f, m, p->right.structure, THUD_FLOOR_DISPLACEMENT));
}

double thud_free_vibration_gap(struct thud_free_vibration *f, const struct thud_model *model, int c, int ends,
                               double *margin)
{
    const struct thud_model_contact *p = &model->contact[c];
    const double *u = f->value[THUD_FLOOR_DISPLACEMENT];
    *margin = gap_margin(f, model, p);
    if (p->left_dof >= 0)
        thud_free_vibration_values(f, model, p->left.structure, THUD_FLOOR_DISPLACEMENT);
    if (p->right_dof >= 0)
        thud_free_vibration_values(f, model, p->right.structure, THUD_FLOOR_DISPLACEMENT);
    for (int t = 0; t < ends; t++)
        f->gap[t] = side_value(&p->left, u + t) - side_value(&p->right, u + t);
    return thud_largest(f->gap, ends);
}

/* What the modes of the block can bring the sides of row c together by from their rest, each at its largest speed; no
 * number where one of them is a free body's. */
static double swing_of(const struct thud_free_vibration *f, const struct thud_model *m, int c, double *rest)
{
    const double *g = m->jacobian + c * f->n;
    double sum = 0;
    *rest = thud_dot(f->n, g, f->shift);
    for (int j = 0; j < f->n; j++)
        sum += fabs(g[j]) * f->speed[j] / m->omega[j];
    return sum;
}

/* Gaps above which the contacts may close in an interval; whether any comes so far in the block. */
static bool set_limits(struct thud_free_vibration *f, const struct thud_state *state, int intervals)
{
    bool any = false;
    for (int c = 0; c < state->model->ncontacts; c++) {
        const struct thud_model_contact *p = &state->model->contact[c];
        const double limit = thud_state_clearance(state, c) - gap_margin(f, state->model, p);
        double margin, rest, swing = swing_of(f, state->model, c, &rest);
        f->limit[c] = INFINITY;
        if (p->law->flags & THUD_LAW_NO_FORCE || swing + rest <= limit)
            continue;
        if (thud_free_vibration_gap(f, state->model, c, intervals + 1, &margin) <= limit)
            continue;
        f->limit[c] = limit;
        any = true;
    }
    return any;
}

/* Marks the contacts that may close in interval t; whether there are any. One that is closed at its end is certain to. */
static bool find_near(struct thud_free_vibration *f, const struct thud_state *state, int t)
{
    const struct thud_model *m = state->model;
    const double *u = f->value[THUD_FLOOR_DISPLACEMENT] + t;
    bool any = false;
    for (int c = 0; c < m->ncontacts; c++) {
        f->near[c] = false;
        if (f->limit[c] == INFINITY) /* where its displacements may not have been made */
            continue;
        const struct thud_model_side *left = &m->contact[c].left, *right = &m->contact[c].right;
        double start = side_value(left, u) - side_value(right, u),
               end = side_value(left, u + 1) - side_value(right, u + 1);
        f->near[c] = start > f->limit[c] || end > f->limit[c];
        any |= f->near[c];
        if (end > thud_state_clearance(state, c) + 2 * state->touch_m)
            f->certain = t;
    }
    return any;
}

/* Intervals until a contact closes, at most `intervals`. */
int thud_free_vibration_until_contact(struct thud_free_vibration *f, const struct thud_state *state, int intervals)
{
    if (!set_limits(f, state, intervals))
        return intervals;
    for (int t = 0; t < intervals; t++)
        if (find_near(f, state, t) && (f->certain == t || closes(f, state, t)))
            return t;
    return intervals;
}

/* Whether storey k comes to its bound in interval t, or unloads where it yields. */
static bool yields(struct thud_free_vibration *f, const struct thud_state *state, int k, int t)
{
    double d[THUD_SEGMENT_TERMS];
    enum thud_event event;
    bool any = false;
    for (int piece = 0, order; piece < f->pieces && !any; piece++) {
        const int row = state->model->ncontacts + k;
        const struct thud_segment *seg = thud_free_vibration_row_series(f, state, row, t, piece);
        thud_segment_indentation(state, seg, row, d);
        any = thud_event_storey(state, k, d, seg->terms, t == 0 && piece == 0, 1, &event, &order) <= 1;
    }
    return any;
}

/* The size of the drift of storey k (a link's is of two floors far apart) less what is plastic at the ends into f->gap;
 * returns how large it may be there, INFINITY where by the modes' largest speeds it does not come so far. */
static double fill_drift(struct thud_free_vibration *f, const struct thud_state *state, int k)
{
    const struct thud_model *m = state->model;
    const struct thud_model_storey *storey = &m->storey[k];
    const int row = m->ncontacts + k;
    const double limit =
        storey->yield_m - (storey->link < 0 ? thud_free_vibration_margin(f, m, storey->structure, THUD_FLOOR_DRIFT)
                                            : gap_margin(f, m, &m->contact[row]));
    double margin, rest, swing = swing_of(f, m, row, &rest);
    if (swing + fabs(rest - state->storey[k].plastic_m) <= limit && state->storey[k].suppressed == 0)
        return INFINITY;
    thud_free_vibration_gap(f, m, row, f->ends, &margin);
    for (int t = 0; t < f->ends; t++)
        f->gap[t] = fabs(f->gap[t] - state->storey[k].plastic_m);
    return limit;
}

/* Of the storey that yields, the rate g . q' of its drift inward. Inside an interval it lies off the chord by dt^2/8 times
 * its second derivative at most; B_2 bounds q'' and, with B = Omega^2 + kappa g g^T, B^1/2 q', and so
 *
 *     |g . q'''| <= (sqrt(g . B g) + |D g|) B_2 + |g . gamma da_g/dt| */
static double fill_rate(struct thud_free_vibration *f, const struct thud_state *state, int k)
{
    const struct thud_model *m = state->model;
    const struct thud_coupled_motion *c = &f->coupled[f->nsystems + k];
    const struct thud_model_structure *p = &m->structure[m->storey[k].structure];
    const double *g = c->soft, square = thud_dot(c->n, g, g);
    double spring = c->soft_npm * square * square, dashpot = 0;
    memset(f->gap, 0, (size_t)f->ends * sizeof *f->gap);
    for (int j = 0; j < c->n; j++) {
        const double damped = thud_dot(c->n, p->damping + j * c->n, g), outward = -state->storey[k].direction * g[j],
                     *rate = f->qd + (c->first_mode + j) * ENDS;
        spring += m->spring[c->first_mode + j] * g[j] * g[j];
        dashpot += damped * damped;
        for (int t = 0; t < f->ends; t++)
            f->gap[t] += outward * rate[t];
    }
    return -f->dt_s * f->dt_s / 8 *
           ((sqrt(thud_larger(spring, 0)) + sqrt(dashpot)) * bound_of(f, m, p->system, 2) +
            fabs(thud_dot(c->n, g, m->gamma + c->first_mode)) * f->slope);
}

/* Intervals until a storey yields, or unloads, at most `intervals`: where an end is past that, no series has to show it. */
int thud_free_vibration_until_yield(struct thud_free_vibration *f, const struct thud_state *state, int intervals)
{
    for (int k = 0; k < state->model->nstoreys; k++) {
        const double limit = k == f->yields ? fill_rate(f, state, k) : fill_drift(f, state, k),
                     past = k == f->yields ? 0 : state->model->storey[k].yield_m + 2 * state->touch_m;
        if (thud_largest(f->gap, intervals + 1) <= limit && state->storey[k].suppressed == 0)
            continue;
        for (int t = 0; t < intervals; t++) {
            f->certain = f->gap[t + 1] > past ? t : f->certain;
            if ((f->gap[t] > limit || f->gap[t + 1] > limit) && (f->certain == t || yields(f, state, k, t)))
                intervals = t;
        }
    }
    return intervals;
}

/* Intervals until a storey may collapse, at most `intervals`: as a rule the modes' largest speeds show that none does. */
int thud_free_vibration_until_collapse(struct thud_free_vibration *f, const struct thud_state *state, int intervals)
{
    const struct thud_model *m = state->model;
    for (int s = 0; s < m->nstructures && m->collapses; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        const double margin = thud_free_vibration_margin(f, m, s, THUD_FLOOR_DRIFT) +
                              (p->rise ? thud_free_vibration_margin(f, m, s, THUD_FLOOR_DISPLACEMENT) : 0);
        double sum = margin;
        for (int j = p->first_mode; p->collapse_m && j < p->first_mode + p->modes; j++)
            sum += thud_model_most_lean(m, p, j) * (f->speed[j] / m->omega[j] + fabs(f->shift[j]));
        if (!p->collapse_m || sum <= p->collapse_least_m)
            continue;
        thud_free_vibration_values(f, m, s, THUD_FLOOR_DISPLACEMENT);
        const double *u = f->value[THUD_FLOOR_DISPLACEMENT] + (size_t)p->first * ENDS;
        for (int i = 0; i < p->n; i++)
            for (int t = 0; t < intervals; t++)
                if (thud_larger(fabs(thud_model_lean(p, u + t, ENDS, i)),
                                fabs(thud_model_lean(p, u + t + 1, ENDS, i))) > p->collapse_m[i] - margin)
                    intervals = t;
    }
    return intervals;
}
