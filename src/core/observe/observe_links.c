/* A link that always acts: with d = g . q of its ends,
 *
 *     F = k d + c d',   stroke = d,   loss = int c d'^2 dt;
 *
 * one of friction has F = k (d - d_p), no larger than its slip force, and loses what its storey does
 * (core/contact/storey.h). */
#include "core/observe/observe_links.h"

#include <math.h>

#include "core/contact/storey.h"
#include "core/motion/free_vibration.h"
#include "core/numerics/quadrature.h"
#include "core/numerics/tolerance.h"
#include "core/numerics/vec.h"
#include "core/observe/rest.h"

enum { ENDS = THUD_FREE_VIBRATION_ENDS };

static void raise_to(struct thud_peak *peak, double value, double time_s)
{
    if (fabs(value) > peak->value)
        *peak = (struct thud_peak){fabs(value), time_s};
}

/* What friction takes off k d while it holds. */
static double offset(const struct thud_state *state, const struct thud_model_link *p)
{
    return p->storey < 0 ? 0 : p->stiffness_npm * state->storey[p->storey].plastic_m;
}

/* The largest force that friction lets the link have. */
static double most_force(const struct thud_model *m, const struct thud_model_link *p)
{
    return p->storey < 0 ? (double)INFINITY : m->storey[p->storey].stiffness_npm * m->storey[p->storey].yield_m;
}

/* Coefficients of d, and of F while friction holds. */
static void series(const struct thud_state *state, const struct thud_model_link *p, const struct thud_segment *seg,
                   double *d, double *force)
{
    const double rate = 1 / seg->h_s;
    const int nmodes = state->model->nmodes;
    thud_dots(p->modes, p->row, seg->q + p->first_mode, nmodes, seg->terms, d);
    for (int k = 0; k < seg->terms; k++)
        force[k] = p->stiffness_npm * d[k] + (k + 1 < seg->terms ? p->damping_nspm * (k + 1) * rate * d[k + 1] : 0);
}

static void look(const struct thud_state *state, const struct thud_segment *seg, int link, struct thud_link_result *r,
                 double s)
{
    const struct thud_model_link *p = &state->model->link[link];
    const double most = most_force(state->model, p);
    double d[THUD_SEGMENT_TERMS], force[THUD_SEGMENT_TERMS];
    series(state, p, seg, d, force);
    force[0] -= offset(state, p);
    thud_peak_raise(&r->stroke, seg, d, seg->terms, s);
    if (r->force.value < most && p->storey >= 0 && state->storey[p->storey].direction != 0)
        r->force = (struct thud_peak){most, seg->start_s};
    if (r->force.value < most)
        thud_peak_raise(&r->force, seg, force, seg->terms, s);
    r->force.value = fmin(r->force.value, most);
}

/* Loss up to s. */
static double loss(const struct thud_state *state, const struct thud_segment *seg, int link, double s)
{
    const struct thud_model_link *p = &state->model->link[link];
    double d[THUD_SEGMENT_TERMS], force[THUD_SEGMENT_TERMS], sum = 0;
    if (p->damping_nspm == 0)
        return 0;
    series(state, p, seg, d, force);
    for (int i = 0; i < THUD_QUADRATURE_POINTS; i++) {
        double rate = 0, at = s * thud_quadrature_node[i];
        for (int k = seg->terms - 1; k > 0; k--)
            rate = rate * at + k * d[k];
        sum += thud_quadrature_weight[i] * rate * rate;
    }
    return p->damping_nspm * s / seg->h_s * sum;
}

/* Of a step whose events are not located: its two ends are all that it knows. */
static void ends(const struct thud_observation *o, int link, struct thud_link_result *r)
{
    const struct thud_model *m = o->state->model;
    const struct thud_model_link *p = &m->link[link];
    const struct thud_motion *a = o->seg->start, *b = o->seg->end;
    const double time_s = o->seg->start_s + o->seg->h_s, d = thud_model_link(m, link, b->q),
                 v = thud_model_link(m, link, b->qd), v0 = thud_model_link(m, link, a->qd);
    raise_to(&r->stroke, d, time_s);
    raise_to(&r->force, p->stiffness_npm * d + p->damping_nspm * v, time_s);
    r->lost_j += 0.5 * p->damping_nspm * (v0 + v) * (d - thud_model_link(m, link, a->q));
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    struct thud_result *result = own;
    const struct thud_model *m = o->state->model;
    (void)err;
    for (int i = 0; i < m->nlinks; i++) {
        if (m->link[i].contact >= 0)
            continue;
        if (o->seg->end) {
            ends(o, i, &result->link[i]);
            continue;
        }
        look(o->state, o->seg, i, &result->link[i], o->s);
        result->link[i].lost_j += loss(o->state, o->seg, i, o->s);
    }
    return THUD_OK;
}

/* d and F at the ends into d and f->gap; sizes of the largest, how far one inside an interval may lie above them. */
struct largest {
    double stroke, force, stroke_margin, force_margin;
};

static struct largest values(struct thud_free_vibration *f, const struct thud_state *state,
                             const struct thud_model_link *p, int ends, double *d)
{
    const struct thud_model *m = state->model;
    const double held = offset(state, p);
    const int dof[] = {p->left_dof, p->right_dof};
    struct largest most = {0};
    for (int t = 0; t < ends; t++)
        d[t] = f->gap[t] = 0;
    for (int side = 0; side < 2; side++) {
        if (dof[side] < 0)
            continue;
        const int s = m->dof_structure[dof[side]];
        thud_free_vibration_values(f, m, s, THUD_FLOOR_DISPLACEMENT);
        thud_free_vibration_values(f, m, s, THUD_FLOOR_VELOCITY);
        const double *u = f->value[THUD_FLOOR_DISPLACEMENT] + (size_t)dof[side] * ENDS,
                     *v = f->value[THUD_FLOOR_VELOCITY] + (size_t)dof[side] * ENDS, sign = side == 0 ? 1 : -1;
        for (int t = 0; t < ends; t++) {
            d[t] += sign * u[t];
            f->gap[t] += sign * (p->stiffness_npm * u[t] + p->damping_nspm * v[t]);
        }
        most.stroke_margin += f->margin[THUD_FLOOR_DISPLACEMENT * m->nstructures + s];
        most.force_margin += p->stiffness_npm * f->margin[THUD_FLOOR_DISPLACEMENT * m->nstructures + s] +
                             p->damping_nspm * f->margin[THUD_FLOOR_VELOCITY * m->nstructures + s];
    }
    for (int t = 0; t < ends; t++) {
        most.stroke = fmax(most.stroke, fabs(d[t]));
        most.force = fmax(most.force, fabs(f->gap[t] -= held));
    }
    return most;
}

static enum thud_status block(void *own, const struct thud_state *state, struct thud_free_vibration *f, int intervals,
                              struct thud_error *err)
{
    struct thud_result *result = own;
    const struct thud_model *m = state->model;
    double d[ENDS];
    (void)err;
    for (int i = 0; i < m->nlinks; i++) {
        const struct thud_model_link *p = &m->link[i];
        struct thud_link_result *r = &result->link[i];
        if (p->contact >= 0)
            continue;
        const struct largest most = values(f, state, p, intervals + 1, d);
        const double force = fmax(r->force.value, most.force) - most.force_margin,
                     stroke = fmax(r->stroke.value, most.stroke) - most.stroke_margin;
        for (int t = 0; t < intervals; t++)
            if (fmax(fabs(f->gap[t]), fabs(f->gap[t + 1])) >= force || fmax(fabs(d[t]), fabs(d[t + 1])) >= stroke)
                for (int piece = 0; piece < f->pieces; piece++)
                    look(state, thud_free_vibration_series(f, state, p->structure, t, piece), i, r, 1);
        r->lost_j += thud_free_vibration_link_loss(f, m, i, intervals);
    }
    return THUD_OK;
}

/* Nothing bounds the rest of a motion in links that always act; those that are contacts stay open in it. */
static bool may_jump(const void *own, const struct thud_rest *rest)
{
    (void)own;
    for (int i = 0; i < rest->model->nlinks; i++)
        if (rest->model->link[i].contact < 0)
            return false;
    return true;
}

const struct thud_observer thud_observe_links = {.segment = segment, .block = block, .may_jump = may_jump};

void thud_links_finish(const struct thud_state *state, struct thud_result *result)
{
    const struct thud_model *m = state->model;
    for (int i = 0; i < m->nlinks; i++) {
        const int storey = m->link[i].storey;
        if (storey >= 0) {
            const double d = thud_model_link(m, i, state->q), held = d - thud_storey_plastic(state, storey, d);
            result->link[i].lost_j = state->storey[storey].hysteretic_j;
            result->link[i].stored_j = 0.5 * m->link[i].stiffness_npm * held * held;
            result->link[i].engaged = state->storey[storey].excursions;
            result->link[i].residual_m = state->storey[storey].plastic_m;
            result->link[i].contact = m->ncontacts + storey;
            continue;
        }
        const int contact = result->link[i].contact = m->link[i].contact;
        result->link[i].residual_m = NAN;
        if (contact < 0) {
            const double d = thud_model_link(m, i, state->q);
            result->link[i].stored_j = 0.5 * m->link[i].stiffness_npm * d * d;
            continue;
        }
        const struct thud_contact_result *from = &result->contact[contact];
        const double least_j = THUD_TOL_LINK_LOSS * from->force.value * from->indentation.value;
        result->link[i] =
            (struct thud_link_result){.force = from->force,
                                      .stroke = from->indentation,
                                      .lost_j = fabs(from->dissipated_j) > least_j ? from->dissipated_j : 0,
                                      .stored_j = from->stored_j,
                                      .residual_m = from->residual_m,
                                      .engaged = from->impacts,
                                      .contact = contact};
    }
}
