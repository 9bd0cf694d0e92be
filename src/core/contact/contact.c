#include "core/contact/contact_private.h"

#include <math.h>

#include "core/numerics/poly.h"
#include "core/numerics/tolerance.h"

/* The events that end a state of a contact, and what follows. Only the run changes them. */

/* Force that the elastic curve would reach at the approach velocity v: the scale on which errors of this contact's force
 * count. */
static double expected_force(const struct thud_state *state, int c, double v)
{
    static const double near = 1e-6; /* more than a scale needs */
    const struct thud_law *law = thud_contact_law(state, c);
    const struct thud_law_setup *setup = thud_contact_setup(state, c);
    const struct thud_law_memory *memory = &state->contact[c].memory;
    double energy = 0.5 * setup->mass_kg * v * v, d = 1e-6 * v, stored, force;
    if (!law->elastic_energy || energy == 0)
        return 0;
    for (int i = 0;; i++) { /* Newton's method for ln U over ln d, of slope F d/U: a power law takes one step */
        struct thud_branch b = thud_law_branch_at(law, setup, memory, THUD_APPROACH, d);
        stored = thud_law_energy(law, setup, memory, THUD_APPROACH, d);
        force = thud_branch_force(&b, d, 0, NULL, NULL);
        if (i == 6 || !(stored > 0 && force > 0) || fabs(stored - energy) <= near * energy)
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

/* Contact c begins at this time with this approach velocity. */
static void begin(struct thud_state *state, struct thud_contact_log *log, int c, double time_s, double v)
{
    struct thud_contact_state *s = &state->contact[c];
    s->onset_mps = v;
    thud_law_onset(thud_contact_law(state, c), thud_contact_setup(state, c), v, &s->memory);
    thud_contact_set_mode(state, c, THUD_CLOSED);
    thud_contact_ready(state, c, s);
    s->expected_force_n = expected_force(state, c, v);
    thud_contact_log_begin(log, c, time_s, v);
}

static void onset(struct thud_state *state, struct thud_contact_log *log, int c)
{
    struct thud_contact_state *s = &state->contact[c];
    const double v = closing_rate(state, c);
    bool pressed = thud_contact_indentation(state, c) >
                   THUD_TOL_CONTACT * state->length_m; /* from the start: the clearance is negative */
    begin(state, log, c, thud_state_now(state), v);
    /* k d + c d' begins at 0 with d'; what is asked of d^p (K + D d') is K + D d', which does not */
    bool from_zero = v == 0 && !pressed && s->branch.f0_n == 0 && s->branch.K == 0 && s->branch.D == 0;
    s->suppressed = (struct thud_suppressed){.indentation = !pressed, .rate = v == 0, .force = from_zero};
}

/* Suppressed coefficients of a force that has just left 0 to this side: none where a blow has put it beyond what rounding
 * leaves. */
static int force_zeros(const struct thud_state *state, int c, double sign)
{
    const struct thud_branch *b = &state->contact[c].branch;
    double d = thud_contact_indentation(state, c), v = thud_contact_rate(state, c);
    double by_d, by_v, force = thud_branch_force(b, d, v, &by_d, &by_v),
                       elastic = thud_branch_force(b, d, 0, NULL, NULL);
    double noise = THUD_TOL_FORCE * (elastic - 2 * fmin(b->f0_n, 0)); /* of |f0| + k d + K d^p */
    return sign * force > noise + thud_row_force_noise(state, c, by_d, by_v) ? 0 : 1;
}

/* The force has reached 0 and would pull. What is left of the indentation is plastic and widens the clearance permanently,
 * where the law keeps it; else the bodies are still indented and the force may come back. */
static enum thud_status release(struct thud_state *state, struct thud_contact_log *log, int c, double time_s,
                                double rate_mps, struct thud_error *err)
{
    struct thud_contact_state *s = &state->contact[c];
    const struct thud_law *law = thud_contact_law(state, c);
    thud_contact_released(state, log, c, time_s, rate_mps);
    if (law->keeps_residual && law->keeps_residual(thud_contact_setup(state, c))) {
        s->residual_m += fmax(thud_contact_indentation(state, c), 0);
        log->contact[c].residual_m = s->residual_m;
        return thud_contact_open(state, log, c, 1, err);
    }
    thud_contact_set_mode(state, c, THUD_CLOSED_NO_FORCE);
    s->suppressed = (struct thud_suppressed){.force = force_zeros(state, c, -1)};
    return THUD_OK;
}

/* The state may be beyond d = 0: behind the event inside a step, or a little where an error of its force had it held. */
static enum thud_status separate(struct thud_state *state, struct thud_contact_log *log, int c, double time_s,
                                 double rate_mps, struct thud_error *err)
{
    if (state->contact[c].mode == THUD_CLOSED)
        thud_contact_released(state, log, c, time_s, rate_mps);
    return thud_contact_open(state, log, c, thud_contact_indentation(state, c) >= -state->touch_m, err);
}

/* At d' = 0. Where the branch of the phase that begins meets the present one, that phase begins. Where it does not
 * (rubber past delta_u, unloading as printed) and each would turn the motion back to the other, the contact sticks
 * (Filippov's sliding mode). */
static void reversal(struct thud_state *state, int c)
{
    struct thud_contact_state *s = &state->contact[c];
    enum thud_phase next = s->phase == THUD_APPROACH ? THUD_RESTITUTION : THUD_APPROACH;
    double d = thud_contact_indentation(state, c);
    const struct thud_contact_state begins = thud_contact_in_phase(state, c, next, d);
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
    thud_contact_go_on(state, c, next, !gone);
}

/* At the ultimate compression, either way. */
static void change_branch(struct thud_state *state, int c)
{
    struct thud_contact_state *s = &state->contact[c];
    s->past_ultimate = !s->past_ultimate;
    s->suppressed.branch = 1;
    thud_contact_renew_branch(state, c, s);
}

/* The constraint force has left its interval: towards approach (IN) above it, towards restitution (OUT) below. */
static enum thud_status unstick(struct thud_state *state, struct thud_contact_log *log, int c, enum thud_event event,
                                struct thud_error *err)
{
    struct thud_contact_state *s = &state->contact[c];
    if (thud_contact_law(state, c)->flags & THUD_LAW_IMPULSIVE) { /* sustained pushing has ended: d, d' and d'' are 0 */
        thud_contact_released(state, log, c, thud_state_now(state), thud_contact_rate(state, c));
        return thud_contact_open(state, log, c, 3, err);
    }
    thud_contact_go_on(state, c, event == THUD_EVENT_UNSTICK_IN ? THUD_APPROACH : THUD_RESTITUTION, 2);
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
        if (thud_contact_law(state, contact)->flags & THUD_LAW_IMPULSIVE)
            return thud_contact_impulse(state, log, contact, err);
        onset(state, log, contact);
        return THUD_OK;
    case THUD_EVENT_SEPARATION:
        return separate(state, log, contact, thud_state_now(state), thud_contact_rate(state, contact), err);
    case THUD_EVENT_RELEASE:
        return release(state, log, contact, thud_state_now(state), thud_contact_rate(state, contact), err);
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

/* The rate of contact c at s of a segment. */
static double rate_at(const struct thud_state *state, const struct thud_segment *seg, int c, double s)
{
    double at[3];
    thud_poly_value3(thud_segment_read(state, seg, c), seg->terms, s, at);
    return at[1] / seg->h_s;
}

enum thud_status thud_contacts_begin(struct thud_state *state, struct thud_contact_log *log,
                                     const struct thud_segment *seg, double s, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int c = 0; c < state->model->ncontacts && status == THUD_OK && seg->notes->quiet; c++) {
        const double at = seg->notes->begun[c], time_s = seg->start_s + at * seg->h_s;
        if (!(at >= 0 && at <= s))
            continue;
        begin(state, log, c, time_s, rate_at(state, seg, c, at));
        state->work->events++;
        status = thud_contact_log_event(log, state, time_s, c, THUD_EVENT_ONSET, 0, err);
    }
    return status;
}

/* Contact c has parted or been released at s of a segment that has gone on behind it. */
static enum thud_status end(struct thud_state *state, struct thud_contact_log *log, const struct thud_segment *seg,
                            int c, enum thud_event event, double s, struct thud_error *err)
{
    const double time_s = seg->start_s + s * seg->h_s, rate_mps = rate_at(state, seg, c, s);
    state->work->events++;
    const enum thud_status status = event == THUD_EVENT_SEPARATION ? separate(state, log, c, time_s, rate_mps, err)
                                                                   : release(state, log, c, time_s, rate_mps, err);
    return status == THUD_OK ? thud_contact_log_event(log, state, time_s, c, event, 0, err) : status;
}

enum thud_status thud_contacts_end(struct thud_state *state, struct thud_contact_log *log,
                                   const struct thud_segment *seg, double s, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    while (status == THUD_OK && seg->notes->quiet) {
        int first = -1;
        for (int c = 0; c < state->model->ncontacts; c++)
            if (thud_segment_ended(seg, c) <= s &&
                (first < 0 || thud_segment_ended(seg, c) < thud_segment_ended(seg, first)))
                first = c;
        if (first < 0)
            break;
        double *released = &seg->notes->released[first], *parted = &seg->notes->parted[first];
        const bool parts = *parted <= *released;
        status = end(state, log, seg, first, parts ? THUD_EVENT_SEPARATION : THUD_EVENT_RELEASE,
                     parts ? *parted : *released, err);
        *released = INFINITY;
        *parted = parts ? INFINITY : *parted;
    }
    return status;
}
