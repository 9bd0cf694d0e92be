/* Stereomechanical contact (Newton's law of restitution): impulses at touch, of all touching contacts together as one
 * linear complementarity problem, and holding where the structures go on pushing. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/contact.h"
#include "core/lcp.h"
#include "core/tolerance.h"

/* A parting slower than this is taken as the end of a row of ever smaller bounces: the contact comes to rest. No units
 * of its own: the same scene in other ones, or a larger one, comes to rest at the same moment. */
static double rest_speed(const struct thud_state *state)
{
    return fmax(1e-4 * state->tolerance, THUD_TOL_REST) * state->speed_mps;
}

/* Contacts that take part: the one that touches now, those that are held, and those that are at zero distance. */
static int gather(const struct thud_state *state, int touching, int *set)
{
    int n = 0;
    for (int c = 0; c < state->model->ncontacts; c++) {
        const struct thud_contact_state *s = &state->contact[c];
        if (!(state->model->contact[c].law->flags & THUD_LAW_IMPULSIVE))
            continue;
        bool at_zero = s->mode == THUD_OPEN && fabs(thud_contact_indentation(state, c)) <= THUD_TOL_INDENTATION_M;
        if (c == touching || s->mode == THUD_STUCK || at_zero)
            set[n++] = c;
    }
    return n;
}

struct collision {
    int n;
    const int *set;
    double *speed, *impulse, *m, *q, *work; /* closing speeds before, (n); M (n x n) */
};

static enum thud_status impulses(const struct thud_state *state, struct collision *x, struct thud_error *err)
{
    const struct thud_model *m = state->model;
    for (int i = 0; i < x->n; i++) {
        int c = x->set[i];
        double v = x->speed[i] = thud_contact_rate(state, c);
        double e = m->contact[c].law->nominal(&m->contact[c].setup);
        bool held = state->contact[c].mode == THUD_STUCK; /* what rate it has is the error of the force that holds it */
        if (held || !(e * v > rest_speed(state)))         /* or the force would have to bring it to rest at once */
            e = 0;
        x->q[i] = -(1 + e) * v;
        for (int j = 0; j < x->n; j++)
            x->m[i * x->n + j] = m->w[c * m->ncontacts + x->set[j]];
    }
    enum thud_status status = thud_lcp_solve(x->n, x->m, x->q, x->impulse, x->work, err);
    return status == THUD_DIVERGED && m->left_out > 0 ? thud_state_too_few_modes(state, err) : status;
}

static void apply(struct thud_state *state, const struct collision *x)
{
    const struct thud_model *m = state->model;
    for (int i = 0; i < x->n; i++) {
        const double *g = m->g + x->set[i] * m->nmodes;
        for (int j = 0; j < m->nmodes; j++)
            state->qd[j] -= g[j] * x->impulse[i];
    }
}

/* Puts one impact into the results. */
static enum thud_status note(struct thud_state *state, struct thud_contact_log *log, int c, double before,
                             double impulse, struct thud_error *err)
{
    struct thud_contact_result *r = &log->contact[c];
    double after = -thud_contact_rate(state, c), lost = impulse * (before - after) / 2;
    struct thud_impact impact = {.contact = c,
                                 .start_s = thud_state_now(state),
                                 .approach_mps = before,
                                 .separation_mps = after,
                                 .impulse_ns = impulse,
                                 .dissipated_j = lost};
    r->impulse_ns += impulse;
    r->dissipated_j += lost;
    log->lost_j += lost;
    if (!thud_impact_counts(state, c, impulse) || state->contact[c].mode == THUD_STUCK)
        return THUD_OK; /* a held contact passes the blow on */
    impact.restitution = thud_impact_restitution(state, &impact);
    r->impacts++;
    r->approach_mps = before;
    r->separation_mps = after;
    r->restitution = impact.restitution;
    return thud_contact_log_add(log, &impact, err);
}

/* After the impulses: held where the structures push on and nothing bounces, else open. */
static void settle(struct thud_state *state, int c)
{
    struct thud_contact_state *s = &state->contact[c];
    double rate = thud_contact_rate(state, c);
    if (fabs(rate) > rest_speed(state)) {
        thud_contact_set_mode(state, c, THUD_OPEN);
        s->zeros = (struct thud_zeros){.indentation = 1};
        return;
    }
    thud_contact_set_mode(state, c, THUD_OPEN);
    thud_contact_forces(state, state->force_now);
    if (thud_contact_acceleration(state, c, state->force_now) <= -thud_contact_rounding(state)) {
        s->zeros = (struct thud_zeros){.indentation = 2};
        return;
    }
    thud_contact_set_mode(state, c, THUD_STUCK);
    s->hold_low = 0;
    s->hold_high = INFINITY;
    s->zeros = (struct thud_zeros){.force = 1};
    s->impact = (struct thud_impact){.contact = c, .start_s = thud_state_now(state), .restitution = NAN};
    s->counted = false;
}

/* What the impulses do to the rates of the contacts that have forces. */
static void strike_others(struct thud_state *state, const struct collision *x)
{
    const struct thud_model *m = state->model;
    for (int c = 0; c < m->ncontacts; c++) {
        double change = 0;
        for (int i = 0; i < x->n; i++)
            change -= m->w[c * m->ncontacts + x->set[i]] * x->impulse[i];
        if (change != 0 && !(m->contact[c].law->flags & THUD_LAW_IMPULSIVE))
            thud_contact_impulse_received(state, c, change);
    }
}

enum thud_status thud_contact_impulse(struct thud_state *state, struct thud_contact_log *log, int contact,
                                      struct thud_error *err)
{
    int *set = state->set_now, n = gather(state, contact, set);
    double *block = state->collide;
    struct collision x = {n, set, block, block + n, block + 2 * n, block + 2 * n + n * n, block + 3 * n + n * n};
    enum thud_status status = impulses(state, &x, err);
    if (status != THUD_OK)
        return status;
    apply(state, &x);
    for (int i = 0; i < n && status == THUD_OK; i++)
        if (x.impulse[i] > 0)
            status = note(state, log, set[i], x.speed[i], x.impulse[i], err);
    for (int i = 0; i < n; i++)
        if (x.impulse[i] > 0 || set[i] == contact)
            settle(state, set[i]);
    strike_others(state, &x);
    return status;
}
