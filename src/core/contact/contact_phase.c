#include "core/contact/contact_private.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "core/laws/law_check.h"
#include "core/numerics/tolerance.h"

/* Mode, phase and branch of a contact, and what of its impacts counts: what events (contact.c) and impulses (impulse.c)
 * both change. */

void thud_contact_renew_branch(const struct thud_state *state, int c, struct thud_contact_state *s)
{
    s->branch = thud_law_branch(thud_contact_law(state, c), thud_contact_setup(state, c), &s->memory, s->phase,
                                s->past_ultimate);
    const double p = s->branch.p;
    if (s->branch.K != 0 && p != 1 && p != 1.5 && state->powers->p == 0)
        thud_powers_fill(state->powers, p);
    s->branch.powers = state->powers->p != 0 ? state->powers : NULL;
    assert(!thud_branch_fault(thud_contact_law(state, c), &s->branch, s->phase));
}

void thud_contact_ready(const struct thud_state *state, int c, struct thud_contact_state *s)
{
    s->ultimate_m =
        thud_law_ultimate(thud_contact_law(state, c), thud_contact_setup(state, c), &s->memory, THUD_APPROACH);
    s->phase = THUD_APPROACH;
    s->past_ultimate = false;
    thud_contact_renew_branch(state, c, s);
}

void thud_contact_set_mode(struct thud_state *state, int c, enum thud_contact_mode mode)
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
        const struct thud_law *law = thud_contact_law(state, c);
        memset(s, 0, sizeof *s);
        s->ultimate_m = thud_law_ultimate(law, thud_contact_setup(state, c), &s->memory, THUD_APPROACH);
        s->suppressed.indentation = fabs(thud_contact_indentation(state, c)) <= state->touch_m;
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

bool thud_impact_counts(const struct thud_state *state, int c, double impulse_ns)
{
    return impulse_ns > THUD_TOL_IMPACT * state->model->contact[c].setup.mass_kg * state->speed_mps;
}

void thud_impact_count(const struct thud_state *state, struct thud_contact_log *log, int c)
{
    const struct thud_impact *now = &log->now[c];
    struct thud_contact_result *r = &log->contact[c];
    if (log->counted[c] || thud_contact_law(state, c)->flags & THUD_LAW_IMPULSIVE ||
        !thud_impact_counts(state, c, now->impulse_ns))
        return;
    log->counted[c] = true;
    r->impacts++;
    r->approach_mps = now->approach_mps;
    r->separation_mps = 0;
    r->restitution = NAN;
}

/* Whether the storeys hardly change the floors' speeds while a contact lasts: up to a quarter of the shortest period of
 * the two structures, pi/(2 omega). Beyond it the speeds at which floors part say nothing of the law. */
static bool is_short(const struct thud_state *state, const struct thud_impact *impact)
{
    static const double quarter = 1.5707963267948966; /* of a period, rad */
    const struct thud_model_contact *contact = &state->model->contact[impact->contact];
    const int side[] = {contact->left.structure, contact->right.structure};
    double fastest_radps = 0;
    for (int i = 0; i < 2; i++) {
        const struct thud_model_structure *structure = side[i] < 0 ? NULL : &state->model->structure[side[i]];
        for (int j = 0; structure && j < structure->dofs; j++)
            fastest_radps = fmax(fastest_radps, structure->omega[j]);
    }
    return impact->duration_s * fastest_radps <= quarter;
}

double thud_impact_restitution(const struct thud_state *state, const struct thud_impact *impact)
{
    double least = THUD_TOL_CLOSING * state->speed_mps;
    if (!(impact->approach_mps > least) || impact->separation_mps < -least || !is_short(state, impact))
        return NAN;
    return fmax(impact->separation_mps, 0) / impact->approach_mps;
}

void thud_contact_released(struct thud_state *state, struct thud_contact_log *log, int c, double time_s,
                           double rate_mps)
{
    struct thud_impact *now = &log->now[c];
    now->separation_mps = -rate_mps;
    now->duration_s = time_s - now->start_s;
    now->restitution = thud_impact_restitution(state, now);
    if (!log->counted[c])
        return;
    log->contact[c].separation_mps = now->separation_mps;
    log->contact[c].restitution = now->restitution;
}

enum thud_status thud_contact_open(struct thud_state *state, struct thud_contact_log *log, int c, int suppressed,
                                   struct thud_error *err)
{
    struct thud_contact_state *s = &state->contact[c];
    thud_contact_set_mode(state, c, THUD_OPEN);
    s->suppressed = (struct thud_suppressed){.indentation = suppressed};
    if (!thud_law_is_linear(thud_contact_law(state, c)))
        thud_contact_ready(state, c, s);
    const bool listed = c < state->model->npairs && thud_impact_counts(state, c, log->now[c].impulse_ns);
    return listed ? thud_contact_log_add(log, &log->now[c], err) : THUD_OK;
}

struct thud_contact_state thud_contact_in_phase(const struct thud_state *state, int c, enum thud_phase phase, double d)
{
    struct thud_contact_state s = state->contact[c];
    const double before = s.ultimate_m;
    thud_law_reversal(thud_contact_law(state, c), thud_contact_setup(state, c), phase, d, &s.memory);
    s.phase = phase;
    s.ultimate_m = thud_law_ultimate(thud_contact_law(state, c), thud_contact_setup(state, c), &s.memory, phase);
    if (s.ultimate_m != before)
        s.past_ultimate = d > s.ultimate_m;
    thud_contact_renew_branch(state, c, &s);
    return s;
}

void thud_contact_go_on(struct thud_state *state, int c, enum thud_phase phase, int rate_zeros)
{
    const double d = thud_contact_indentation(state, c);
    thud_contact_set_mode(state, c, THUD_CLOSED);
    struct thud_contact_state *s = &state->contact[c];
    *s = thud_contact_in_phase(state, c, phase, d);
    bool there = fabs(d - s->ultimate_m) <= state->touch_m; /* the law remembers this indentation */
    s->suppressed = (struct thud_suppressed){.rate = rate_zeros, .branch = there ? 1 + rate_zeros : 0};
}

void thud_contact_impulse_received(struct thud_state *state, int c, double change)
{
    struct thud_contact_state *s = &state->contact[c];
    double v = thud_contact_rate(state, c);
    enum thud_phase phase = v > 0 ? THUD_APPROACH : THUD_RESTITUTION;
    bool turns = s->mode != THUD_OPEN && thud_contact_law(state, c)->flags & THUD_LAW_REVERSES;
    if ((!turns && s->mode != THUD_STICKING) || fabs(v) <= THUD_TOL_IMPULSE_RATE * fabs(change))
        return;
    if (s->mode == THUD_STICKING || phase != s->phase)
        thud_contact_go_on(state, c, phase, 0);
    else
        s->suppressed.rate = 0;
}
