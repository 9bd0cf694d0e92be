/* How far the force polynomials of a step are from the laws. */
#include <math.h>

#include "core/collocation_private.h"
#include "core/largest.h"
#include "core/poly.h"
#include "core/tolerance.h"

/* Scale on which an error of contact a's force counts: the largest force it has had, has now, or will have by its
 * closing velocity. */
double thud_collocation_scale(const struct thud_run *run, const struct thud_collocation *x, int a)
{
    int c = x->active[a];
    double scale = run->result.contact[c].force.value;
    for (int i = 0; i < THUD_POINTS; i++)
        scale = thud_larger(scale, fabs(x->force[a * THUD_PLACES + i]));
    if (run->contact[c].phase == THUD_APPROACH)
        scale = thud_larger(scale, run->contact[c].expected_force_n);
    return thud_larger(scale,
                       run->model->contact[c].setup.mass_kg *
                           thud_larger(THUD_TOL_GROUND_FORCE * run->ground_mps2, THUD_TOL_LEAST_ACCELERATION_MPS2));
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

static struct sizes sizes_of(const struct thud_run *run, int c)
{
    double left, right, left_rate, right_rate;
    thud_model_sides(run->model, c, run->q, &left, &right);
    thud_model_sides(run->model, c, run->qd, &left_rate, &right_rate);
    return (struct sizes){thud_run_shift(run, c) + fabs(left) + fabs(right), fabs(left_rate) + fabs(right_rate)};
}

/* How far rounding alone may put a force off. */
static double force_noise(const struct sizes *of, double fd, double fv)
{
    return THUD_TOL_STATE * (fabs(fd) * of->d + fabs(fv) * of->v);
}

/* Largest difference between the polynomial of contact a's force and the law, between the points. */
static double force_difference(struct thud_run *run, const struct thud_collocation *x, int c, const double *p, double h)
{
    const struct thud_contact_state *s = &run->contact[c];
    double d[THUD_PLACES], v[THUD_PLACES], f[THUD_PLACES], worst = 0, mass = run->model->contact[c].setup.mass_kg;
    thud_places_read(&x->checks, p, 1, run->seg.terms, d);
    thud_places_slope(&x->checks, p, 1, run->seg.terms, h, v);
    thud_places_read(&x->checks, run->seg.force + c, run->model->ncontacts, THUD_POINTS, f);
    const struct sizes sizes = sizes_of(run, c);
    for (int i = 0; i < THUD_POINTS;
         i += s->mode == THUD_STUCK ? 1 : 2) { /* a law is dear; the largest is at the start */
        double fd, fv;
        if (s->mode == THUD_STUCK) { /* the force that would undo the rate in one step, but for rounding */
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
static double contact_error(struct thud_run *run, const struct thud_collocation *x, int a, double h)
{
    int c = x->active[a];
    const struct thud_contact_state *s = &run->contact[c];
    double *p = run->indentation + c * THUD_SEGMENT_TERMS, mass = run->model->contact[c].setup.mass_kg;
    thud_contact_polynomial(run, c);
    if (s->zeros.indentation > 0)
        p[0] = 0; /* just touched, as the forces at the points take it */
    double difference = force_difference(run, x, c, p, h);
    double error = thud_larger(difference / thud_collocation_scale(run, x, a) - THUD_TOL_POLYNOMIAL, 0);
    if (s->mode == THUD_CLOSED && s->phase == THUD_APPROACH && has_just_begun(p, run->seg.terms)) {
        double ground = run->fastest_radps > 0 ? run->ground_mps2 / run->fastest_radps : 0;
        double speed = s->memory.v_imp_mps < 1e-7 * ground ? ground : s->memory.v_imp_mps; /* pushed, or thrown */
        if (speed > 0)
            error = fmin(error, 10 * difference * h / (mass * speed));
    }
    return error;
}

double thud_collocation_error(struct thud_run *run, const struct thud_collocation *x, double h)
{
    double worst = 0;
    for (int a = 0; a < x->nactive; a++)
        worst = thud_larger(worst, contact_error(run, x, a, h));
    run->result.work.force_evaluations += x->nactive * (THUD_POINTS + 1) / 2;
    return worst;
}
