#include "core/contact/contact_private.h"

#include <math.h>

#include "core/numerics/lcp.h"
#include "core/numerics/tolerance.h"

/* Stereomechanical contact (Newton's law of restitution). Impulses of all contacts that touch and do not open, as one
 * linear complementarity problem: with u the rate at which a contact opens, W the Delassus matrix,
 *
 *     u+ + e u- = (1 + e) u- + W p >= 0,   p >= 0,   complementary
 *
 * so that they lose the energy sum p (1 - e) (-u-)/2, never less than 0, whatever their restitutions. A contact that
 * opens takes no part: should the impulses close it, that is the next collision, at the same moment. Where the bodies
 * have no room to bounce (between two walls that both touch), no p solves that, or such collisions have no end:
 * infinitely many bounces pass in no time, and what they end in has e = 0. Then the contacts at rest are held where a
 * force is needed that they go on together:
 *
 *     u++ = a + W f >= 0,   f >= 0,   complementary */

/* Contacts that take part: the one at onset, those that are held, and those closed to rounding that do not open. */
static int gather(const struct thud_state *state, int onset, int *set)
{
    int n = 0;
    for (int c = 0; c < state->model->ncontacts; c++) {
        const struct thud_contact_state *s = &state->contact[c];
        if (!(state->model->contact[c].law->flags & THUD_LAW_IMPULSIVE))
            continue;
        bool in_contact = s->mode == THUD_OPEN &&
                          fabs(thud_contact_indentation(state, c)) <= THUD_TOL_CONTACT * state->length_m &&
                          thud_contact_rate(state, c) >= -thud_rest_speed(state);
        if (c == onset || s->mode == THUD_STICKING || in_contact)
            set[n++] = c;
    }
    return n;
}

enum role { BESIDE, STRUCK, HELD, HELD_AND_STRUCK }; /* of a contact of the set, by its state before */
struct collision {
    int n;
    const int *set;
    int *role;
    double *speed, *impulse, *force; /* (n) approach velocities before; impulses; forces that hold the contacts then */
    double *m, *q, *work;            /* M (n x n) */
};

/* The complementarity problem of x->m and x->q. */
static enum thud_status solve(const struct thud_state *state, const struct collision *x, double *z,
                              struct thud_error *err)
{
    bool unique;
    enum thud_status status = thud_lcp_solve(x->n, x->m, x->q, z, x->work, &unique, err);
    return !unique && state->model->left_out > 0 ? thud_state_too_few_modes(state, err) : status;
}

static enum thud_status impulses(const struct thud_state *state, struct collision *x, int onset, struct thud_error *err)
{
    const struct thud_model *m = state->model;
    const bool endless = thud_contact_rate(state, onset) < -thud_rest_speed(state); /* passed over, and opens by now */
    thud_contact_forces(state, state->force_now);
    for (int i = 0; i < x->n; i++) {
        int c = x->set[i];
        double v = x->speed[i] = thud_contact_rate(state, c);
        double e = thud_law_nominal(m->contact[c].law, &m->contact[c].setup);
        bool held =
            state->contact[c].mode == THUD_STICKING; /* what rate it has is the error of the force that holds it */
        /* the forces would have to end a slower parting within a moment, or at once */
        const double slow_mps = THUD_TOL_MOMENT_S * thud_contact_acceleration(state, c, state->force_now);
        if (endless || held || !(e * v > thud_larger(thud_rest_speed(state), slow_mps)))
            e = 0;
        x->q[i] = -(1 + e) * v;
        for (int j = 0; j < x->n; j++)
            x->m[i * x->n + j] = m->delassus[c * m->nrows + x->set[j]];
    }
    enum thud_status status = solve(state, x, x->impulse, NULL);
    if (status == THUD_OK || m->left_out > 0)
        return status == THUD_OK ? status : thud_state_too_few_modes(state, err);
    for (int i = 0; i < x->n; i++)
        x->q[i] = -x->speed[i];
    return solve(state, x, x->impulse, err);
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
    r->work_j += lost;
    log->lost_j += lost;
    if (!thud_impact_counts(state, c, impulse) || state->contact[c].mode == THUD_STICKING)
        return THUD_OK; /* a held contact passes the blow on */
    impact.restitution = thud_impact_restitution(state, &impact);
    r->impacts++;
    r->approach_mps = before;
    r->separation_mps = after;
    r->restitution = impact.restitution;
    return thud_contact_log_add(log, &impact, err);
}

/* Impulses store nothing: together they give no energy but for rounding, and what floors have at speeds that are taken as
 * rest. */
static enum thud_status check_energy(const struct thud_state *state, const struct collision *x, struct thud_error *err)
{
    double lost = 0, size = 0, rest = 0;
    for (int i = 0; i < x->n; i++) {
        const double after = thud_contact_rate(state, x->set[i]), p = 0.5 * x->impulse[i],
                     before = state->contact[x->set[i]].mode == THUD_STICKING ? 0 : x->speed[i];
        lost += p * (before + after);
        size += p * (fabs(before) + fabs(after));
        rest += state->model->contact[x->set[i]].setup.mass_kg * pow(thud_rest_speed(state), 2);
    }
    if (lost >= -THUD_TOL_IMPULSE_ENERGY * size - rest)
        return THUD_OK;
    return thud_error_set(err, THUD_DIVERGED, "the impulses at t = %.6g s release %.3g J that was not stored",
                          thud_state_now(state), -lost);
}

/* What the impulses change in the approach velocity of contact c. */
static double change_of_rate(const struct thud_state *state, const struct collision *x, int c)
{
    const struct thud_model *m = state->model;
    double change = 0;
    for (int i = 0; i < x->n; i++)
        change -= m->delassus[c * m->nrows + x->set[i]] * x->impulse[i];
    return change;
}

/* What the impulses do to the rates of the contacts that have forces. */
static void send_impulses(struct thud_state *state, const struct collision *x)
{
    const struct thud_model *m = state->model;
    for (int c = 0; c < m->ncontacts; c++) {
        const double change = change_of_rate(state, x, c);
        if (change != 0 && !(m->contact[c].law->flags & THUD_LAW_IMPULSIVE))
            thud_contact_impulse_received(state, c, change);
    }
}

/* Whether contact i of the set may be held. What the rate of a held one is besides is the error of what holds it; one
 * that has taken no impulse opens, however slowly. */
static bool is_at_rest(const struct thud_state *state, const struct collision *x, int i)
{
    const int c = x->set[i];
    if (x->role[i] == HELD)
        return change_of_rate(state, x, c) >= -thud_rest_speed(state);
    return x->role[i] != BESIDE && fabs(thud_contact_rate(state, c)) <= thud_rest_speed(state);
}

/* Takes contact i out of the matrix, where it is not held. */
static void leave_out(struct collision *x, int i)
{
    for (int j = 0; j < x->n && x->force[i] < 0; j++)
        if (j != i)
            x->m[i * x->n + j] = x->m[j * x->n + i] = 0;
}

/* The forces that hold the contacts at rest, found with all of the set open; -1: it is not at rest, or would pull. */
static enum thud_status find_forces(struct thud_state *state, struct collision *x, struct thud_error *err)
{
    const int n = x->n;
    double *a = x->speed, *f = x->impulse; /* neither is needed any more */
    for (int i = 0; i < n; i++)
        x->force[i] = is_at_rest(state, x, i) ? 0 : -1;
    for (int i = 0; i < n; i++)
        thud_contact_set_mode(state, x->set[i], THUD_OPEN);
    thud_contact_forces(state, state->force_now);
    for (int i = 0; i < n; i++) {
        a[i] = x->force[i] == 0 ? thud_contact_acceleration(state, x->set[i], state->force_now) : -1;
        x->q[i] = -a[i];
        leave_out(x, i);
    }
    enum thud_status status = solve(state, x, f, err);
    for (int i = 0; i < n && status == THUD_OK; i++) {
        for (int j = 0; j < n; j++)
            a[i] -= x->m[i * n + j] * f[j];
        if (x->force[i] == 0)
            x->force[i] = f[i] > 0 || a[i] > -thud_contact_rounding(state) ? f[i] : -1;
        leave_out(x, i);
    }
    if (status == THUD_OK && state->model->left_out > 0 && !thud_is_definite(n, x->m, x->work))
        return thud_state_too_few_modes(state, err);
    return status;
}

/* Contact c is held by this force at first. */
static void hold(struct thud_state *state, struct thud_contact_log *log, int c, enum role role, double force_n)
{
    struct thud_contact_state *s = &state->contact[c];
    thud_contact_set_mode(state, c, THUD_STICKING);
    if (role == HELD)
        return;
    s->constraint_low_n = 0;
    s->constraint_high_n = INFINITY;
    /* a force that is more than rounding is known, however small it is beside the tolerance */
    const double rounding = state->model->contact[c].setup.mass_kg * thud_contact_rounding(state);
    s->suppressed = (struct thud_suppressed){.force = force_n <= rounding};
    if (role == HELD_AND_STRUCK)
        return;
    thud_contact_log_begin(log, c, thud_state_now(state), 0);
}

/* After the impulses: contacts at rest are held where the structures push on; the others are open. */
static enum thud_status hold_or_part(struct thud_state *state, struct thud_contact_log *log, struct collision *x,
                                     struct thud_error *err)
{
    enum thud_status status = find_forces(state, x, err);
    for (int i = 0; i < x->n && status == THUD_OK; i++) {
        const int c = x->set[i];
        const bool held = x->role[i] == HELD || x->role[i] == HELD_AND_STRUCK;
        const int suppressed = fabs(thud_contact_rate(state, c)) > thud_rest_speed(state) ? 1 : 2;
        if (x->force[i] >= 0) {
            hold(state, log, c, (enum role)x->role[i], x->force[i]);
        } else if (held) {
            thud_contact_released(state, log, c, thud_state_now(state), thud_contact_rate(state, c));
            status = thud_contact_open(state, log, c, suppressed, err);
        } else if (x->role[i] == STRUCK) {
            state->contact[c].suppressed = (struct thud_suppressed){.indentation = suppressed};
        }
    }
    return status;
}

enum thud_status thud_contact_impulse(struct thud_state *state, struct thud_contact_log *log, int contact,
                                      struct thud_error *err)
{
    int *set = state->set_now, n = gather(state, contact, set);
    double *block = state->collide;
    struct collision x = {
        n, set, set + n, block, block + n, block + 2 * n, block + 4 * n, block + 3 * n, block + 4 * n + n * n};
    enum thud_status status = impulses(state, &x, contact, err);
    if (status != THUD_OK)
        return status;
    for (int i = 0; i < n; i++)
        thud_model_apply_contact_force(state->model, set[i], x.impulse[i], state->qd);
    status = check_energy(state, &x, err);
    for (int i = 0; i < n && status == THUD_OK; i++) {
        const bool held = state->contact[set[i]].mode == THUD_STICKING, struck = x.impulse[i] > 0;
        x.role[i] = held && struck ? HELD_AND_STRUCK : held ? HELD : struck || set[i] == contact ? STRUCK : BESIDE;
        if (struck)
            status = note(state, log, set[i], x.speed[i], x.impulse[i], err);
    }
    send_impulses(state, &x);
    return status == THUD_OK ? hold_or_part(state, log, &x, err) : status;
}
