#include "core/contact/contact.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/laws/law_check.h"
#include "core/numerics/lcp.h"
#include "core/numerics/tolerance.h"

/* Impulses of all stereomechanical contacts that touch now. Errors: as thud_contact_switch. */
static enum thud_status thud_contact_impulse(struct thud_state *state, struct thud_contact_log *log, int contact,
                                             struct thud_error *err);

/* The states of a contact, the events that end them, and what follows. Only the run changes them. */

static const struct thud_law *law_of(const struct thud_state *state, int c)
{
    return state->model->contact[c].law;
}

static const struct thud_law_setup *setup_of(const struct thud_state *state, int c)
{
    return &state->model->contact[c].setup;
}

static void renew_branch(const struct thud_state *state, int c, struct thud_contact_state *s)
{
    s->branch = thud_law_branch(law_of(state, c), setup_of(state, c), &s->memory, s->phase, s->past_ultimate);
    assert(!thud_branch_fault(law_of(state, c), &s->branch, s->phase));
}

/* Changes the mode and keeps the counts of contacts. */
static void thud_contact_set_mode(struct thud_state *state, int c, enum thud_contact_mode mode)
{
    struct thud_contact_state *s = &state->contact[c];
    state->nactive -= thud_contact_acts(s);
    state->nindented -= s->mode != THUD_OPEN;
    s->mode = mode;
    state->nactive += thud_contact_acts(s);
    state->nindented += s->mode != THUD_OPEN;
}

void thud_contact_start(struct thud_state *state)
{
    for (int c = 0; c < state->model->ncontacts; c++) {
        struct thud_contact_state *s = &state->contact[c];
        const struct thud_law *law = law_of(state, c);
        memset(s, 0, sizeof *s);
        s->ultimate_m = thud_law_ultimate(law, setup_of(state, c), &s->memory, THUD_APPROACH);
        s->suppressed.indentation = fabs(thud_contact_indentation(state, c)) <= THUD_TOL_INDENTATION_M;
    }
}

void thud_contact_moved(struct thud_state *state)
{
    for (int c = 0; c < state->model->ncontacts; c++) {
        struct thud_contact_state *s = &state->contact[c];
        bool at_zero = s->mode == THUD_OPEN && s->suppressed.indentation > 0 && thud_contact_rate(state, c) == 0 &&
                       thud_contact_indentation(state, c) == 0;
        s->suppressed = (struct thud_suppressed){.indentation = at_zero};
    }
}

/* Force that the elastic curve would reach at the approach velocity v: the scale on which errors of this contact's force
 * count. */
static double expected_force(const struct thud_state *state, int c, double v)
{
    const struct thud_law *law = law_of(state, c);
    const struct thud_law_setup *setup = setup_of(state, c);
    const struct thud_law_memory *memory = &state->contact[c].memory;
    double energy = 0.5 * setup->mass_kg * v * v, d = 1e-6, stored, force;
    if (!law->elastic_energy || energy == 0)
        return 0;
    for (int i = 0;; i++) { /* Newton's method for ln U over ln d, of slope F d/U: a power law takes one step */
        struct thud_branch b = thud_law_branch_at(law, setup, memory, THUD_APPROACH, d);
        stored = thud_law_energy(law, setup, memory, THUD_APPROACH, d);
        force = thud_branch_force(&b, d, 0, NULL, NULL);
        if (i == 6 || !(stored > 0 && force > 0))
            return force;
        d *= pow(energy / stored, stored / (force * d));
    }
}

/* Rate at which contact c closes; 0 where rounding alone has left one. */
static double closing_rate(const struct thud_state *state, int c)
{
    double left, right;
    thud_model_sides(state->model, c, state->qd, &left, &right);
    double rate = left - right;
    return rate > THUD_TOL_RATE * (fabs(left) + fabs(right)) ? rate : 0;
}

bool thud_impact_counts(const struct thud_state *state, int c, double impulse_ns)
{
    return impulse_ns > THUD_TOL_IMPACT * state->model->contact[c].setup.mass_kg * state->speed_mps;
}

void thud_impact_count(const struct thud_state *state, struct thud_contact_log *log, int c)
{
    const struct thud_impact *now = &log->now[c];
    struct thud_contact_result *r = &log->contact[c];
    if (log->counted[c] || law_of(state, c)->flags & THUD_LAW_IMPULSIVE ||
        !thud_impact_counts(state, c, now->impulse_ns))
        return;
    log->counted[c] = true;
    r->impacts++;
    r->approach_mps = now->approach_mps;
    r->separation_mps = 0;
    r->restitution = NAN;
}

/* Separation over approach velocity; NaN where the approach velocity is no more than rounding, or the bodies did not
 * part. */
static double thud_impact_restitution(const struct thud_state *state, const struct thud_impact *impact)
{
    double least = THUD_TOL_CLOSING * state->speed_mps;
    if (!(impact->approach_mps > least) || impact->separation_mps < -least)
        return NAN;
    return fmax(impact->separation_mps, 0) / impact->approach_mps;
}

static void onset(struct thud_state *state, struct thud_contact_log *log, int c)
{
    struct thud_contact_state *s = &state->contact[c];
    const struct thud_law *law = law_of(state, c);
    double v = s->onset_mps = closing_rate(state, c);
    thud_law_onset(law, setup_of(state, c), v, &s->memory);
    s->ultimate_m = thud_law_ultimate(law, setup_of(state, c), &s->memory, THUD_APPROACH);
    s->phase = THUD_APPROACH;
    s->past_ultimate = false;
    thud_contact_set_mode(state, c, THUD_CLOSED);
    bool pressed =
        thud_contact_indentation(state, c) > THUD_TOL_PRESSED_M; /* from the start: the clearance is negative */
    renew_branch(state, c, s);
    /* k d + c d' begins at 0 with d'; what is asked of d^p (K + D d') is K + D d', which does not */
    bool from_zero = v == 0 && !pressed && s->branch.f0_n == 0 && s->branch.K == 0 && s->branch.D == 0;
    s->suppressed = (struct thud_suppressed){.indentation = !pressed, .rate = v == 0, .force = from_zero};
    s->expected_force_n = expected_force(state, c, v);
    log->now[c] =
        (struct thud_impact){.contact = c, .start_s = thud_state_now(state), .approach_mps = v, .restitution = NAN};
    log->counted[c] = false;
    log->waiting_s[c] = 0;
}

/* The force has come to its end. */
static void note_release(struct thud_state *state, struct thud_contact_log *log, int c)
{
    struct thud_impact *now = &log->now[c];
    now->separation_mps = -thud_contact_rate(state, c);
    now->duration_s = thud_state_now(state) - now->start_s;
    now->restitution = thud_impact_restitution(state, now);
    if (!log->counted[c])
        return;
    log->contact[c].separation_mps = now->separation_mps;
    log->contact[c].restitution = now->restitution;
}

/* Leaves `suppressed` coefficients of the indentation out of what the next contact is looked for in: 1 where it is 0, 2
 * where its rate is too, 3 where the bodies had come to rest together. */
static enum thud_status open_contact(struct thud_state *state, struct thud_contact_log *log, int c, int suppressed,
                                     struct thud_error *err)
{
    struct thud_contact_state *s = &state->contact[c];
    thud_contact_set_mode(state, c, THUD_OPEN);
    s->suppressed = (struct thud_suppressed){.indentation = suppressed};
    const bool listed = c < state->model->npairs && thud_impact_counts(state, c, log->now[c].impulse_ns);
    return listed ? thud_contact_log_add(log, &log->now[c], err) : THUD_OK;
}

/* Suppressed coefficients of a force that has just left 0 to this side: none where a blow has put it beyond. */
static int force_zeros(const struct thud_state *state, int c, double sign)
{
    const struct thud_branch *b = &state->contact[c].branch;
    double d = thud_contact_indentation(state, c), v = thud_contact_rate(state, c);
    double force = thud_branch_force(b, d, v, NULL, NULL), elastic = thud_branch_force(b, d, 0, NULL, NULL);
    return sign * force > THUD_TOL_FORCE * (elastic - 2 * fmin(b->f0_n, 0)) ? 0 : 1; /* of |f0| + k d + K d^p */
}

/* The force has reached 0 and would pull. What is left of the indentation is plastic and widens the clearance for good,
 * where the law keeps it; else the bodies are still indented and the force may come back. */
static enum thud_status release(struct thud_state *state, struct thud_contact_log *log, int c, struct thud_error *err)
{
    struct thud_contact_state *s = &state->contact[c];
    const struct thud_law *law = law_of(state, c);
    note_release(state, log, c);
    if (law->keeps_residual && law->keeps_residual(setup_of(state, c))) {
        s->residual_m += fmax(thud_contact_indentation(state, c), 0);
        log->contact[c].residual_m = s->residual_m;
        return open_contact(state, log, c, 1, err);
    }
    thud_contact_set_mode(state, c, THUD_CLOSED_NO_FORCE);
    s->suppressed = (struct thud_suppressed){.force = force_zeros(state, c, -1)};
    return THUD_OK;
}

/* The contact in a phase that begins at indentation d: its memory, and what follows from that. */
static struct thud_contact_state in_phase(const struct thud_state *state, int c, enum thud_phase phase, double d)
{
    struct thud_contact_state s = state->contact[c];
    const double before = s.ultimate_m;
    thud_law_reversal(law_of(state, c), setup_of(state, c), phase, d, &s.memory);
    s.phase = phase;
    s.ultimate_m = thud_law_ultimate(law_of(state, c), setup_of(state, c), &s.memory, phase);
    if (s.ultimate_m != before)
        s.past_ultimate = d > s.ultimate_m;
    renew_branch(state, c, &s);
    return s;
}

/* Contact c goes on in a phase, from here; `rate_zeros` coefficients of its rate are 0. Where it turns just at the
 * ultimate compression, that guard's function starts at 0 as well, and one order higher where the rate does. */
static void go_on(struct thud_state *state, int c, enum thud_phase phase, int rate_zeros)
{
    const double d = thud_contact_indentation(state, c);
    thud_contact_set_mode(state, c, THUD_CLOSED);
    struct thud_contact_state *s = &state->contact[c];
    *s = in_phase(state, c, phase, d);
    bool there = fabs(d - s->ultimate_m) <= THUD_TOL_INDENTATION_M; /* the law remembers this indentation */
    s->suppressed = (struct thud_suppressed){.rate = rate_zeros, .branch = there ? 1 + rate_zeros : 0};
}

/* At d' = 0. Where the branch of the phase that begins meets the present one, that phase begins. Where it does not
 * (rubber past delta_u, unloading as printed) and each would turn the motion back to the other, the contact sticks
 * (Filippov's sliding mode). */
static void reversal(struct thud_state *state, int c)
{
    struct thud_contact_state *s = &state->contact[c];
    enum thud_phase next = s->phase == THUD_APPROACH ? THUD_RESTITUTION : THUD_APPROACH;
    double d = thud_contact_indentation(state, c);
    const struct thud_contact_state begins = in_phase(state, c, next, d);
    double rest = thud_branch_force(&s->branch, d, 0, NULL, NULL),
           other = thud_branch_force(&begins.branch, d, 0, NULL, NULL);
    double approach = next == THUD_RESTITUTION ? rest : other, restitution = next == THUD_RESTITUTION ? other : rest;
    if (state->locates && approach - restitution > THUD_TOL_BRANCH_GAP * approach) {
        double *force = state->force_now;
        thud_contact_forces_given(state, c, next == THUD_RESTITUTION ? restitution : approach, force);
        double a = thud_contact_acceleration(state, c, force);
        if (next == THUD_RESTITUTION ? a > 0 : a < 0) {
            thud_contact_set_mode(state, c, THUD_STICKING);
            s->constraint_low_n = restitution;
            s->constraint_high_n = approach;
            s->suppressed = (struct thud_suppressed){.force = 1};
            return;
        }
    }
    double v = thud_contact_rate(state, c); /* not 0 where its polynomial has not been resolved */
    bool gone =
        next == THUD_RESTITUTION ? v < -THUD_TOL_REVERSAL * state->speed_mps : v > THUD_TOL_REVERSAL * state->speed_mps;
    go_on(state, c, next, !gone);
}

/* Other contacts' impulses have changed the rate of contact c by so much, to what it is now: it goes on in the phase of
 * that rate, with no guard suppressed. */
static void thud_contact_impulse_received(struct thud_state *state, int c, double change)
{
    struct thud_contact_state *s = &state->contact[c];
    double v = thud_contact_rate(state, c);
    enum thud_phase phase = v > 0 ? THUD_APPROACH : THUD_RESTITUTION;
    bool turns = s->mode != THUD_OPEN && law_of(state, c)->flags & THUD_LAW_REVERSES;
    if ((!turns && s->mode != THUD_STICKING) || fabs(v) <= THUD_TOL_IMPULSE_RATE * fabs(change))
        return;
    if (s->mode == THUD_STICKING || phase != s->phase)
        go_on(state, c, phase, 0);
    else
        s->suppressed.rate = 0;
}

/* At the ultimate compression, either way. */
static void change_branch(struct thud_state *state, int c)
{
    struct thud_contact_state *s = &state->contact[c];
    s->past_ultimate = !s->past_ultimate;
    s->suppressed.branch = 1;
    renew_branch(state, c, s);
}

/* The constraint force has left its interval: towards approach (IN) above it, towards restitution (OUT) below. */
static enum thud_status unstick(struct thud_state *state, struct thud_contact_log *log, int c, enum thud_event event,
                                struct thud_error *err)
{
    struct thud_contact_state *s = &state->contact[c];
    if (law_of(state, c)->flags & THUD_LAW_IMPULSIVE) { /* sustained pushing has ended: d, d' and d'' are 0 */
        note_release(state, log, c);
        return open_contact(state, log, c, 3, err);
    }
    go_on(state, c, event == THUD_EVENT_UNSTICK_IN ? THUD_APPROACH : THUD_RESTITUTION, 2);
    /* as a rule the constraint force has gone to the end of its interval, and d'' is 0; where another contact of the same
     * floors has switched it may have jumped beyond */
    thud_contact_forces(state, state->force_now);
    double a = thud_contact_acceleration(state, c, state->force_now);
    double jump = fmax(10 * state->tolerance, THUD_TOL_UNSTICK) * (s->constraint_high_n - s->constraint_low_n) /
                  state->model->contact[c].setup.mass_kg;
    if (event == THUD_EVENT_UNSTICK_IN ? a > jump : a < -jump)
        s->suppressed.rate = 1;
    return THUD_OK;
}

/* Events and what follows, by the mode that they find (closed: approach or restitution):
 *
 *     OPEN                ONSET -> CLOSED, or an impulse
 *     CLOSED              REVERSAL -> CLOSED in the other phase, or STICKING; BRANCH -> CLOSED past the ultimate
 *                         compression or before it; RELEASE -> OPEN or CLOSED_NO_FORCE; SEPARATION -> OPEN
 *     CLOSED_NO_FORCE     REENGAGE -> CLOSED; SEPARATION -> OPEN
 *     STICKING            UNSTICK_IN -> CLOSED, approach; UNSTICK_OUT -> CLOSED, restitution, or OPEN after impulses */
enum thud_status thud_contact_switch(struct thud_state *state, struct thud_contact_log *log, int contact,
                                     enum thud_event event, struct thud_error *err)
{
    struct thud_contact_state *s = &state->contact[contact];
    state->work->events++;
    switch (event) {
    case THUD_EVENT_ONSET:
        if (law_of(state, contact)->flags & THUD_LAW_IMPULSIVE)
            return thud_contact_impulse(state, log, contact, err);
        onset(state, log, contact);
        return THUD_OK;
    case THUD_EVENT_SEPARATION:
        if (s->mode == THUD_CLOSED)
            note_release(state, log, contact);
        return open_contact(state, log, contact, 1, err);
    case THUD_EVENT_RELEASE:
        return release(state, log, contact, err);
    case THUD_EVENT_REENGAGE:
        thud_contact_set_mode(state, contact, THUD_CLOSED);
        s->suppressed = (struct thud_suppressed){.force = force_zeros(state, contact, 1)};
        return THUD_OK;
    case THUD_EVENT_REVERSAL:
        reversal(state, contact);
        return THUD_OK;
    case THUD_EVENT_BRANCH:
        change_branch(state, contact);
        return THUD_OK;
    case THUD_EVENT_NONE:
    case THUD_EVENT_YIELD_UP: /* of storeys: thud_storey_switch */
    case THUD_EVENT_YIELD_DOWN:
    case THUD_EVENT_UNLOAD:
    case THUD_EVENT_COLLAPSE:
        return THUD_OK;
    case THUD_EVENT_UNSTICK_IN:
    case THUD_EVENT_UNSTICK_OUT:
        break;
    }
    return unstick(state, log, contact, event, err);
}

/* Stereomechanical contact (Newton's law of restitution). Impulses of all contacts that touch and do not open, as one
 * linear complementarity problem: with u the rate at which a contact opens, W the Delassus matrix,
 *
 *     u+ + e u- = (1 + e) u- + W p >= 0,   p >= 0,   complementary
 *
 * so that they lose the energy sum p (1 - e) (-u-)/2, never less than 0, whatever their restitutions. A contact that
 * opens takes no part: should the impulses close it, that is the next collision, at the same moment. Where the bodies
 * have no room to bounce (between two walls that both touch), no p solves that: infinitely many bounces pass in no time,
 * and what they end in has e = 0. Then the contacts at rest are held where a force is needed that they go on together:
 *
 *     u++ = a + W f >= 0,   f >= 0,   complementary */

/* A parting slower than this is taken as the end of a row of ever smaller bounces: the contact comes to rest. No units
 * of its own: the same scene in other ones, or a larger one, comes to rest at the same moment. */
static double rest_speed(const struct thud_state *state)
{
    return fmax(1e-4 * state->tolerance, THUD_TOL_REST) * state->speed_mps;
}

/* Contacts that take part: the one at onset, those that are held, and those closed to rounding that do not open. */
static int gather(const struct thud_state *state, int onset, int *set)
{
    int n = 0;
    for (int c = 0; c < state->model->ncontacts; c++) {
        const struct thud_contact_state *s = &state->contact[c];
        if (!(state->model->contact[c].law->flags & THUD_LAW_IMPULSIVE))
            continue;
        bool in_contact = s->mode == THUD_OPEN && fabs(thud_contact_indentation(state, c)) <= THUD_TOL_CONTACT_M &&
                          thud_contact_rate(state, c) >= -rest_speed(state);
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

static enum thud_status impulses(const struct thud_state *state, struct collision *x, struct thud_error *err)
{
    const struct thud_model *m = state->model;
    for (int i = 0; i < x->n; i++) {
        int c = x->set[i];
        double v = x->speed[i] = thud_contact_rate(state, c);
        double e = thud_law_nominal(m->contact[c].law, &m->contact[c].setup);
        bool held =
            state->contact[c].mode == THUD_STICKING; /* what rate it has is the error of the force that holds it */
        if (held || !(e * v > rest_speed(state)))    /* or the force would have to bring it to rest at once */
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

static void apply(struct thud_state *state, const struct collision *x)
{
    const struct thud_model *m = state->model;
    for (int i = 0; i < x->n; i++) {
        const double *g = m->jacobian + x->set[i] * m->nmodes;
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
        const double after = thud_contact_rate(state, x->set[i]), p = 0.5 * x->impulse[i];
        lost += p * (x->speed[i] + after);
        size += p * (fabs(x->speed[i]) + fabs(after));
        rest += state->model->contact[x->set[i]].setup.mass_kg * pow(rest_speed(state), 2);
    }
    if (lost >= -THUD_TOL_IMPULSE_ENERGY * size - rest)
        return THUD_OK;
    return thud_error_set(err, THUD_DIVERGED, "the impulses at t = %.6g s give %.3g J, which nothing stored",
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
        return change_of_rate(state, x, c) >= -rest_speed(state);
    return x->role[i] != BESIDE && fabs(thud_contact_rate(state, c)) <= rest_speed(state);
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
    log->now[c] = (struct thud_impact){.contact = c, .start_s = thud_state_now(state), .restitution = NAN};
    log->counted[c] = false;
    log->waiting_s[c] = 0;
}

/* After the impulses: contacts at rest are held where the structures push on; the others are open. */
static enum thud_status hold_or_part(struct thud_state *state, struct thud_contact_log *log, struct collision *x,
                                     struct thud_error *err)
{
    enum thud_status status = find_forces(state, x, err);
    for (int i = 0; i < x->n && status == THUD_OK; i++) {
        const int c = x->set[i];
        const bool held = x->role[i] == HELD || x->role[i] == HELD_AND_STRUCK;
        const int suppressed = fabs(thud_contact_rate(state, c)) > rest_speed(state) ? 1 : 2;
        if (x->force[i] >= 0) {
            hold(state, log, c, (enum role)x->role[i], x->force[i]);
        } else if (held) {
            note_release(state, log, c);
            status = open_contact(state, log, c, suppressed, err);
        } else if (x->role[i] == STRUCK) {
            state->contact[c].suppressed = (struct thud_suppressed){.indentation = suppressed};
        }
    }
    return status;
}

static enum thud_status thud_contact_impulse(struct thud_state *state, struct thud_contact_log *log, int contact,
                                             struct thud_error *err)
{
    int *set = state->set_now, n = gather(state, contact, set);
    double *block = state->collide;
    struct collision x = {
        n, set, set + n, block, block + n, block + 2 * n, block + 4 * n, block + 3 * n, block + 4 * n + n * n};
    enum thud_status status = impulses(state, &x, err);
    if (status != THUD_OK)
        return status;
    apply(state, &x);
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
