/* How far the force polynomials of a step are from the laws. */
#include <math.h>

#include "core/collocation_private.h"
#include "core/largest.h"
#include "core/poly.h"
#include "core/tolerance.h"

/* Scale on which an error of contact a's force counts: the largest force it has had, has now, or will have by its
 * closing velocity. */
double thud_collocation_scale(const struct thud_state *state, const struct thud_collocation *x, int a)
{
    int c = x->active[a];
    double scale = state->contact[c].largest_force_n;
    for (int i = 0; i < THUD_POINTS; i++)
        scale = thud_larger(scale, fabs(x->force[a * THUD_BATCH + i]));
    if (state->contact[c].phase == THUD_APPROACH)
        scale = thud_larger(scale, state->contact[c].expected_force_n);
    return thud_larger(scale,
                       state->model->contact[c].setup.mass_kg *
                           thud_larger(THUD_TOL_GROUND_FORCE * state->ground_mps2, THUD_TOL_LEAST_ACCELERATION_MPS2));
}

/* Whether a contact is so young that its force has no smooth past: most of the indentation at the end of the step is
 * made in it, with the speed hardly lost. */
static bool has_just_begun(const double *indentation, int terms)
{
    double end[3];
    thud_poly_value3(indentation, terms, 1, end);
    return indentation[0] < 0.5 * end[0] && end[1] > 0.5 * indentation[1];
}

/* Sizes of what an indentation and a rate are differences of. */
struct sizes {
    double d, v;
};

static struct sizes sizes_of(const struct thud_state *state, int c)
{
    double left, right, left_rate, right_rate;
    thud_model_sides(state->model, c, state->q, &left, &right);
    thud_model_sides(state->model, c, state->qd, &left_rate, &right_rate);
    return (struct sizes){thud_state_clearance(state, c) + fabs(left) + fabs(right),
                          fabs(left_rate) + fabs(right_rate)};
}

/* How far rounding alone may put a force off. */
static double force_noise(const struct sizes *of, double fd, double fv)
{
    return THUD_TOL_STATE * (fabs(fd) * of->d + fabs(fv) * of->v);
}

/* Largest difference between the polynomial of contact a's force and the law, between the points. */
static double force_difference(const struct thud_state *state, struct thud_segment *seg,
                               const struct thud_collocation *x, int c, const double *p, double h)
{
    const struct thud_contact_state *s = &state->contact[c];
    double d[THUD_BATCH], v[THUD_BATCH], f[THUD_BATCH], worst = 0, mass = state->model->contact[c].setup.mass_kg;
    thud_nodes_values(&x->checks, p, 1, seg->terms, d);
    thud_nodes_rates(&x->checks, p, 1, seg->terms, h, v);
    thud_nodes_values(&x->checks, seg->force + c, state->model->ncontacts, THUD_POINTS, f);
    const struct sizes sizes = sizes_of(state, c);
    for (int i = 0; i < THUD_POINTS;
         i += s->mode == THUD_STICKING ? 1 : 2) { /* a law is dear; the largest is at the start */
        double fd, fv;
        if (s->mode == THUD_STICKING) { /* the force that would undo the rate in one step, but for rounding */
            worst = thud_larger(worst, mass * thud_larger(fabs(v[i]) - THUD_TOL_STICKING_M / h, 0) / h);
            continue;
        }
        double difference = fabs(thud_branch_force(&s->branch, d[i], v[i], &fd, &fv) - f[i]);
        if (difference > worst && isfinite(fd))
            difference -= force_noise(&sizes, fd, fv);
        worst = thud_larger(worst, difference);
    }
    return worst;
}

/* Error of contact a's force: the largest difference between its polynomial and the law between the points, over the
 * force scale. Where a force begins without a smooth start (d^(1/4), d^(3/2)) no step is short enough for that; there
 * what counts is the impulse that the difference makes up. */
static double contact_error(const struct thud_state *state, struct thud_segment *seg, const struct thud_collocation *x,
                            int a, double h)
{
    int c = x->active[a];
    const struct thud_contact_state *s = &state->contact[c];
    double *p = seg->indentation + c * THUD_SEGMENT_TERMS, mass = state->model->contact[c].setup.mass_kg;
    thud_segment_contact(state, seg, c);
    if (s->suppressed.indentation > 0)
        p[0] = 0; /* just touched, as the forces at the points take it */
    double difference = force_difference(state, seg, x, c, p, h);
    double error = thud_larger(difference / thud_collocation_scale(state, x, a) - THUD_TOL_POLYNOMIAL, 0);
    if (s->mode == THUD_CLOSED && s->phase == THUD_APPROACH && has_just_begun(p, seg->terms)) {
        double ground = state->fastest_radps > 0 ? state->ground_mps2 / state->fastest_radps : 0;
        double speed = s->memory.v_imp_mps < 1e-7 * ground ? ground : s->memory.v_imp_mps; /* pushed, or thrown */
        if (speed > 0)
            error = fmin(error, 10 * difference * h / (mass * speed));
    }
    return error;
}

double thud_collocation_error(const struct thud_state *state, struct thud_segment *seg,
                              const struct thud_collocation *x, double h)
{
    double worst = 0;
    for (int a = 0; a < x->nactive; a++)
        worst = thud_larger(worst, contact_error(state, seg, x, a, h));
    state->work->force_evaluations += x->nactive * (THUD_POINTS + 1) / 2;
    return worst;
}
