/* No stepping error without contact and in linear contact (power series to rounding); collocation of the forces in
 * nonlinear contact. */
#include <math.h>

#include "core/methods/method.h"
#include "core/motion/collocation.h"
#include "core/numerics/tolerance.h"

/* Collocation is needed by laws that are not linear; without it the method has nothing of its own. */
static enum thud_status create(const struct thud_method *method, const struct thud_state *state, void **own,
                               struct thud_error *err)
{
    (void)method;
    struct thud_collocation *collocation = NULL;
    bool needed = false;
    for (int c = 0; c < state->model->ncontacts; c++)
        needed = needed || !thud_law_is_linear(state->model->contact[c].law);
    enum thud_status status = needed ? thud_collocation_create(state, &collocation, err) : THUD_OK;
    *own = collocation;
    return status;
}

/* Whether every closed contact follows a line and a dashpot now. That is asked of the branch and not of the law: rubber
 * past its ultimate compression is a line too, and so is soil that unloads. */
static bool is_linear(const struct thud_state *state)
{
    for (int c = 0; c < state->model->ncontacts; c++) {
        const struct thud_contact_state *s = &state->contact[c];
        if (s->mode == THUD_CLOSED && (s->branch.K != 0 || s->branch.D != 0))
            return false;
    }
    return true;
}

/* Where all that acts is linear, one power series for modes and forces together (segment.c), as long as its last terms
 * are below rounding: the first try is long, and what the terms say of its tail shortens it at no further cost. Else the
 * forces are found by collocation. */
static enum thud_status step(const struct thud_state *state, void *own, struct thud_segment *seg,
                             struct thud_error *err)
{
    if (state->nactive > 0 ? !is_linear(state) : own && thud_collocation_awaits(state, own))
        return thud_collocation_step(state, seg, own, err);
    const struct thud_model *m = state->model;
    static const double longest_angle = 30; /* of the first try: the terms stay numbers, and the tail shortens it */
    const double rate = thud_segment_rate(state), h = fmin(thud_state_remaining(state), longest_angle / rate);
    const int terms = thud_segment_terms(rate * h, THUD_TOL_SERIES, THUD_SEGMENT_TERMS_LEAST);
    thud_segment_begin(state, seg, h, terms < THUD_SEGMENT_TERMS_TRIED ? terms : THUD_SEGMENT_TERMS_TRIED);
    double tail = thud_taylor_linear(state, seg);
    while (tail > THUD_TOL_SERIES_TAIL) {
        double factor = 0.9 * pow(0.5 * THUD_TOL_SERIES_TAIL / tail, 1.0 / (THUD_SEGMENT_TERMS_TRIED - 4));
        thud_segment_shorten(seg, m->nmodes, m->nrows, factor);
        tail = thud_segment_tail(seg, m);
    }
    state->work->force_evaluations += state->nactive;
    return THUD_OK;
}

/* A contact that has just begun tells the collocation to start afresh: the forces before it say nothing of those after. */
static void committed(const struct thud_state *state, void *own, const struct thud_segment *seg, double tau_s,
                      bool switched)
{
    bool onset = false;
    if (!own)
        return;
    for (int c = 0; c < state->model->ncontacts && switched; c++)
        onset |= state->contact[c].mode == THUD_CLOSED && state->contact[c].suppressed.indentation > 0;
    thud_collocation_committed(state, own, tau_s, switched, onset, seg->notes->quiet);
}

const struct thud_method thud_method_exact = {
    .name = "exact",
    .title = "Exact propagation with located events",
    .reference = "contact-free response: Nigam and Jennings, Bulletin of the Seismological Society of America 59 "
                 "(1969) 909-922; "
                 "nonlinear contact, Lobatto collocation: Hairer and Wanner, Solving Ordinary Differential Equations "
                 "II, Springer (1996)",
    .summary =
        "modes advanced in closed form, contacts located, nonlinear contact forces by collocation to the tolerance",
    .flags = THUD_METHOD_LOCATES | THUD_METHOD_CAN_LOCATE,
    .order = 0,
    .stability = INFINITY,
    .limits = "none known; the step follows the contact forces alone",
    .stepper = &(const struct thud_stepper){create, step, committed},
};
