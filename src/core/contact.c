/* The states of a contact, the events that end them, and what follows. Only the run changes them. */
#include <assert.h>
#include <math.h>
#include <string.h>

#include "core/contact.h"
#include "core/poly.h"
#include "core/tolerance.h"

static const struct thud_law *law_of(const struct thud_run *run, int c)
{
    return run->model->contact[c].law;
}

static void renew_branch(struct thud_run *run, int c)
{
    struct thud_contact_state *s = &run->contact[c];
    s->branch = law_of(run, c)->branch(&run->model->contact[c].setup, &s->memory, s->phase, s->past_knee);
}

void thud_contact_set_mode(struct thud_run *run, int c, enum thud_contact_mode mode)
{
    struct thud_contact_state *s = &run->contact[c];
    run->nactive -= thud_contact_acts(s);
    s->mode = mode;
    run->nactive += thud_contact_acts(s);
}

void thud_contact_start(struct thud_run *run)
{
    for (int c = 0; c < run->model->ncontacts; c++) {
        struct thud_contact_state *s = &run->contact[c];
        const struct thud_law *law = law_of(run, c);
        memset(s, 0, sizeof *s);
        s->knee_m = law->knee ? law->knee(&run->model->contact[c].setup) : INFINITY;
        s->zeros.indentation = fabs(thud_contact_indentation(run, c)) <= THUD_TOL_INDENTATION_M;
    }
}

void thud_contact_moved(struct thud_run *run)
{
    for (int c = 0; c < run->model->ncontacts; c++) {
        struct thud_contact_state *s = &run->contact[c];
        bool still = s->mode == THUD_OPEN && s->zeros.indentation > 0 && thud_contact_rate(run, c) == 0 &&
                     thud_contact_indentation(run, c) == 0;
        s->zeros = (struct thud_zeros){.indentation = still};
    }
}

struct found {
    double s;
    int contact, event;
};

static void consider(struct found *found, double s, int contact, enum thud_event event)
{
    if (s < found->s)
        *found = (struct found){s, contact, (int)event};
}

/* Function whose sign is that of a non-pulling law's force: out (terms); false where the force cannot reach 0 before
 * the indentation does. */
static bool push_polynomial(const struct thud_contact_state *s, const double *d, int terms, double h, double *out)
{
    const struct thud_branch *b = &s->branch;
    bool power = b->K != 0;
    assert(terms > 0);
    double factor, slope;
    if (!power && b->D == 0) {
        if (b->c_nspm == 0)
            return false;
        for (int k = 0; k < terms; k++)
            out[k] = b->k_npm * d[k] + (k + 1 < terms ? b->c_nspm * (k + 1) / h * d[k + 1] : 0);
        out[0] += b->f0_n;
        return true;
    }
    if (power && (b->D == 0 || b->p != b->r))
        return false;
    factor = power ? b->K : b->k_npm; /* F = (elastic force) (1 + slope/factor v) */
    slope = b->D;
    for (int k = 0; k < terms; k++)
        out[k] = k + 1 < terms ? slope * (k + 1) / h * d[k + 1] : 0;
    out[0] += factor;
    return true;
}

/* Touched without speed and only then pushed together: how many of the lowest orders the accuracy of the contact force
 * does not resolve. What it leaves there would open the contact again, and without end. */
static int unresolved(const struct thud_run *run, const double *d, int terms, int still)
{
    double largest = 0, resolved = fmax(run->options.tolerance, THUD_TOL_UNRESOLVED);
    for (int k = 0; k < terms; k++)
        largest = fmax(largest, fabs(d[k]));
    while (still < terms && fabs(d[still]) <= resolved * largest)
        still++;
    return still < terms ? still : terms - 1;
}

/* How fast the state of contact c changes what an event watches: its rate, or what push_polynomial has. */
static double slope_now(struct thud_run *run, int c, bool is_rate)
{
    const struct thud_branch *b = &run->contact[c].branch;
    thud_contact_forces(run, run->force_now);
    double a = thud_contact_acceleration(run, c, run->force_now);
    if (is_rate)
        return a;
    bool linear = b->K == 0 && b->D == 0;
    return linear ? b->k_npm * thud_contact_rate(run, c) + b->c_nspm * a : b->D * a;
}

/* Goes over the lowest orders of p that would give it this sign at once, when the state's own slope does not. */
static double unless_unresolved(struct thud_run *run, int c, const double *p, int n, double s_end, double sign,
                                int zeros, bool is_rate)
{
    double s = 0;
    if (run->contact[c].zeros.indentation > 0 || sign * slope_now(run, c, is_rate) > 0)
        return 0;
    while (s == 0 && ++zeros < n)
        s = thud_poly_first_above(p, n, s_end, sign, zeros, 0);
    return s > 0 ? s : INFINITY;
}

/* When p takes this sign, which it may have just left (`zeros`). Its slope there may then be too small for the method
 * to resolve, and wrong: that of the state itself holds, or one state of the contact would call for the other without
 * end.
 */
static inline double next_crossing(struct thud_run *run, int c, const double *p, int n, double s_end, double sign,
                                   int zeros, bool is_rate)
{
    double s = thud_poly_first_above(p, n, s_end, sign, zeros, 0);
    return s == 0 && zeros > 0 ? unless_unresolved(run, c, p, n, s_end, sign, zeros, is_rate) : s;
}

/* The polynomial without its lowest orders: a stiff contact would make a force of what rounding has left there. */
static const double *without(const double *d, int n, int orders, double *copy)
{
    if (orders == 0)
        return d;
    for (int k = 0; k < n; k++)
        copy[k] = k < orders ? 0 : d[k];
    return copy;
}

/* `still`: lowest orders of the indentation that are no motion, see thud_segment_indentation. */
static void closed_events(struct thud_run *run, int c, const double *d, int still, double s_end, struct found *found)
{
    const struct thud_contact_state *s = &run->contact[c];
    const struct thud_law *law = law_of(run, c);
    const struct thud_segment *seg = &run->seg;
    double p[THUD_SEGMENT_TERMS], clean[THUD_SEGMENT_TERMS];
    int n = seg->terms;
    bool pulls = law->flags & THUD_LAW_PULLS;
    if (s->zeros.indentation == 0)
        still = 0; /* only where it has just touched */
    d = without(d, n, still, clean);
    if (s->zeros.indentation > 0 && s->zeros.rate > 0)
        still = unresolved(run, d, n, still);
    int indentation = s->zeros.indentation > still ? s->zeros.indentation : still;
    int rate = s->zeros.rate > still - 1 ? s->zeros.rate : still - 1;
    if (!pulls && push_polynomial(s, d, n, seg->h_s, p))
        consider(found, next_crossing(run, c, p, n, s_end, -1, s->zeros.force, false), c, THUD_EVENT_RELEASE);
    consider(found, thud_poly_first_above(d, n, s_end, -1, indentation, 0), c, THUD_EVENT_GONE);
    if (law->flags & THUD_LAW_TURNS) {
        for (int k = 0; k + 1 < n; k++)
            p[k] = (k + 1) * d[k + 1];
        double sign = s->phase == THUD_APPROACH ? -1 : 1;
        consider(found, next_crossing(run, c, p, n - 1, s_end, sign, rate, true), c, THUD_EVENT_TURN);
    }
    if (s->knee_m < INFINITY) {
        memcpy(p, d, (size_t)n * sizeof *p);
        p[0] -= s->knee_m;
        double sign = s->past_knee ? -1 : 1;
        consider(found, thud_poly_first_above(p, n, s_end, sign, s->zeros.knee, 0), c, THUD_EVENT_KNEE);
    }
}

static void slack_events(struct thud_run *run, int c, const double *d, double s_end, struct found *found)
{
    const struct thud_contact_state *s = &run->contact[c];
    double p[THUD_SEGMENT_TERMS];
    int n = run->seg.terms;
    if (push_polynomial(s, d, n, run->seg.h_s, p))
        consider(found, next_crossing(run, c, p, n, s_end, 1, s->zeros.force, false), c, THUD_EVENT_REENGAGE);
    consider(found, thud_poly_first_above(d, n, s_end, -1, s->zeros.indentation, 0), c, THUD_EVENT_GONE);
}

/* How far a STUCK contact's force is from one end of its interval. Just stuck, a force that is there but for the
 * accuracy of its polynomial is taken to start there. */
static double from_bound(const struct thud_run *run, int c, double distance)
{
    double scale = run->model->contact[c].setup.mass_kg * run->ground_mps2;
    bool there = run->contact[c].zeros.force > 0 && fabs(distance) <= 10 * run->options.tolerance * scale;
    return there ? 0 : distance;
}

/* The force is outside its interval when it is so by more than rounding: neighbours that move alike are held together
 * by what rounding leaves of equal forces. */
static void stuck_events(const struct thud_run *run, int c, double s_end, struct found *found)
{
    const struct thud_contact_state *s = &run->contact[c];
    double p[THUD_SEGMENT_TERMS], rounding = run->model->contact[c].setup.mass_kg * thud_contact_rounding(run);
    int n = run->seg.terms;
    assert(n > 0);
    for (int k = 0; k < n; k++)
        p[k] = run->seg.force[k * run->model->ncontacts + c];
    double f0 = p[0];
    p[0] = from_bound(run, c, f0 - s->hold_low) + rounding;
    consider(found, thud_poly_first_above(p, n, s_end, -1, 0, 0), c, THUD_EVENT_HOLD_DOWN);
    if (s->hold_high < INFINITY) {
        p[0] = from_bound(run, c, f0 - s->hold_high) - rounding;
        consider(found, thud_poly_first_above(p, n, s_end, 1, 0, 0), c, THUD_EVENT_HOLD_UP);
    }
}

/* How far each mode may move from its value at the start of the segment. */
static void modal_reach(struct thud_run *run)
{
    int n = run->model->nmodes;
    memset(run->reach, 0, (size_t)n * sizeof *run->reach);
    for (int k = 1; k < run->seg.terms; k++)
        for (int j = 0; j < n; j++)
            run->reach[j] += fabs(run->seg.q[k * n + j]);
}

/* Whether an open contact may close in the segment, by what its modes can do at most. */
static bool may_close(const struct thud_run *run, int c)
{
    const struct thud_model *m = run->model;
    if (law_of(run, c)->flags & THUD_LAW_SILENT)
        return false;
    if (run->contact[c].zeros.indentation > 0)
        return true;
    double most = thud_contact_indentation(run, c);
    const double *g = m->g + c * m->nmodes;
    for (int j = 0; j < m->nmodes; j++)
        most += fabs(g[j]) * run->reach[j];
    return most > 0;
}

int thud_contact_polynomial(struct thud_run *run, int c)
{
    if (run->known[c] < 0)
        run->known[c] = thud_segment_indentation(run, &run->seg, c, run->indentation + c * THUD_SEGMENT_TERMS);
    return run->known[c];
}

static void open_events(struct thud_run *run, int c, const double *d, double s_end, struct found *found)
{
    if (!may_close(run, c))
        return;
    int zeros = thud_contact_polynomial(run, c);
    if (run->contact[c].zeros.indentation == 0)
        zeros = 0;
    else if (zeros < run->contact[c].zeros.indentation)
        zeros = run->contact[c].zeros.indentation;
    if (zeros < run->seg.terms)
        consider(found, thud_poly_first_above(d, run->seg.terms, s_end, 1, zeros, THUD_TOL_INDENTATION_M), c,
                 THUD_EVENT_TOUCH);
}

double thud_contact_next_event(struct thud_run *run, double s_end, int *contact, int *event)
{
    struct found found = {INFINITY, -1, -1};
    modal_reach(run);
    for (int c = 0; c < run->model->ncontacts; c++) {
        const struct thud_contact_state *s = &run->contact[c];
        const double *d = run->indentation + c * THUD_SEGMENT_TERMS, limit = fmin(s_end, found.s);
        if (s->mode == THUD_OPEN) {
            open_events(run, c, d, limit, &found);
            continue;
        }
        int still = thud_contact_polynomial(run, c);
        if (s->mode == THUD_CLOSED)
            closed_events(run, c, d, still, limit, &found);
        else if (s->mode == THUD_SLACK)
            slack_events(run, c, d, limit, &found);
        else
            stuck_events(run, c, limit, &found);
    }
    *contact = found.contact;
    *event = found.event;
    return found.s;
}

/* Force that the elastic curve would reach at the closing velocity v: the scale on which errors of this contact's force
 * count. */
static double expected_force(const struct thud_run *run, int c, double v)
{
    const struct thud_model_contact *p = &run->model->contact[c];
    double energy = 0.5 * p->setup.mass_kg * v * v, d = 1e-6;
    if (!p->law->elastic_energy || energy == 0)
        return 0;
    bool linear = p->law->flags & THUD_LAW_LINEAR;
    if (linear)
        d *= sqrt(energy / p->law->elastic_energy(&p->setup, d));
    for (int i = 0; i < 8 && !linear; i++) /* energies rise with a power of d from 2 to 4: near enough for a scale */
        d *= pow(energy / p->law->elastic_energy(&p->setup, d), 0.3);
    struct thud_branch b = thud_law_branch_at(p->law, &p->setup, &run->contact[c].memory, THUD_APPROACH, d);
    return thud_branch_force(&b, d, 0, NULL, NULL);
}

/* Rate at which contact c closes; 0 where rounding alone has left one. */
static double closing_rate(const struct thud_run *run, int c)
{
    double left, right;
    thud_model_sides(run->model, c, run->qd, &left, &right);
    double rate = left - right;
    return rate > THUD_TOL_RATE * (fabs(left) + fabs(right)) ? rate : 0;
}

static void touch(struct thud_run *run, int c)
{
    struct thud_contact_state *s = &run->contact[c];
    const struct thud_law *law = law_of(run, c);
    double v = closing_rate(run, c);
    memset(&s->memory, 0, sizeof s->memory);
    law->touch(&run->model->contact[c].setup, v, &s->memory);
    s->phase = THUD_APPROACH;
    s->past_knee = false;
    thud_contact_set_mode(run, c, THUD_CLOSED);
    bool pressed =
        thud_contact_indentation(run, c) > THUD_TOL_PRESSED_M; /* from the start: the clearance is negative */
    renew_branch(run, c);
    /* k d + c d' begins at 0 with d'; what is asked of d^p (K + D d') is K + D d', which does not */
    bool from_zero = v == 0 && !pressed && s->branch.K == 0 && s->branch.D == 0;
    s->zeros = (struct thud_zeros){.indentation = !pressed, .rate = v == 0, .force = from_zero};
    s->expected_force_n = expected_force(run, c, v);
    s->impact = (struct thud_impact){.contact = c, .start_s = thud_run_now(run), .approach_mps = v};
    run->result.contact[c].impacts++;
    run->result.contact[c].approach_mps = v;
    run->result.contact[c].separation_mps = 0;
}

/* The force has come to its end. */
static void note_release(struct thud_run *run, int c)
{
    struct thud_contact_state *s = &run->contact[c];
    s->impact.separation_mps = -thud_contact_rate(run, c);
    s->impact.duration_s = thud_run_now(run) - s->impact.start_s;
    run->result.contact[c].separation_mps = s->impact.separation_mps;
}

static enum thud_status open_contact(struct thud_run *run, int c, int zeros, struct thud_error *err)
{
    struct thud_contact_state *s = &run->contact[c];
    thud_contact_set_mode(run, c, THUD_OPEN);
    s->zeros = (struct thud_zeros){.indentation = zeros};
    return thud_impacts_add(run, &s->impact, err);
}

/* Zeros of a force that has just left 0 to this side: none where a blow has put it beyond. */
static int force_zeros(const struct thud_run *run, int c, double sign)
{
    const struct thud_branch *b = &run->contact[c].branch;
    double d = thud_contact_indentation(run, c), v = thud_contact_rate(run, c);
    double force = thud_branch_force(b, d, v, NULL, NULL), elastic = thud_branch_force(b, d, 0, NULL, NULL);
    return sign * force > THUD_TOL_FORCE * elastic ? 0 : 1;
}

static enum thud_status release(struct thud_run *run, int c, struct thud_error *err)
{
    struct thud_contact_state *s = &run->contact[c];
    const struct thud_law *law = law_of(run, c);
    note_release(run, c);
    if (law->keeps_residual && law->keeps_residual(&run->model->contact[c].setup)) {
        s->residual_m += fmax(thud_contact_indentation(run, c), 0);
        run->result.contact[c].residual_m = s->residual_m;
        return open_contact(run, c, 1, err);
    }
    thud_contact_set_mode(run, c, THUD_SLACK);
    s->zeros = (struct thud_zeros){.force = force_zeros(run, c, -1)};
    return THUD_OK;
}

/* Force of the contact at rest (d' = 0) on one of its branches. */
static double rest_force(const struct thud_run *run, int c, enum thud_phase phase, double d)
{
    const struct thud_contact_state *s = &run->contact[c];
    struct thud_branch b = law_of(run, c)->branch(&run->model->contact[c].setup, &s->memory, phase, s->past_knee);
    return thud_branch_force(&b, d, 0, NULL, NULL);
}

static void go_on(struct thud_run *run, int c, enum thud_phase phase, int rate_zeros)
{
    struct thud_contact_state *s = &run->contact[c];
    thud_contact_set_mode(run, c, THUD_CLOSED);
    if (phase == THUD_RESTITUTION && law_of(run, c)->turn)
        law_of(run, c)->turn(&run->model->contact[c].setup, thud_contact_indentation(run, c), &s->memory);
    s->phase = phase;
    s->zeros = (struct thud_zeros){.rate = rate_zeros};
    renew_branch(run, c);
}

/* At d' = 0. Where the branches meet, the other phase begins. Where they do not (rubber past delta_u, unloading as
 * printed) and each would turn the motion back to the other, the contact sticks (Filippov's sliding mode). */
static void turn(struct thud_run *run, int c)
{
    struct thud_contact_state *s = &run->contact[c];
    enum thud_phase next = s->phase == THUD_APPROACH ? THUD_RESTITUTION : THUD_APPROACH;
    double d = thud_contact_indentation(run, c);
    double approach = rest_force(run, c, THUD_APPROACH, d), restitution = rest_force(run, c, THUD_RESTITUTION, d);
    if (run->locates && approach - restitution > THUD_TOL_BRANCH_GAP * approach) {
        double *force = run->force_now;
        thud_contact_forces(run, force);
        force[c] = next == THUD_RESTITUTION ? restitution : approach;
        double a = thud_contact_acceleration(run, c, force);
        if (next == THUD_RESTITUTION ? a > 0 : a < 0) {
            thud_contact_set_mode(run, c, THUD_STUCK);
            s->hold_low = restitution;
            s->hold_high = approach;
            s->zeros = (struct thud_zeros){.force = 1};
            return;
        }
    }
    double v = thud_contact_rate(run, c); /* not 0 where its polynomial has not been resolved */
    bool gone =
        next == THUD_RESTITUTION ? v < -THUD_TOL_REVERSAL * run->speed_mps : v > THUD_TOL_REVERSAL * run->speed_mps;
    go_on(run, c, next, !gone);
}

void thud_contact_struck(struct thud_run *run, int c, double change)
{
    struct thud_contact_state *s = &run->contact[c];
    double v = thud_contact_rate(run, c);
    enum thud_phase phase = v > 0 ? THUD_APPROACH : THUD_RESTITUTION;
    bool turns = s->mode != THUD_OPEN && law_of(run, c)->flags & THUD_LAW_TURNS;
    if ((!turns && s->mode != THUD_STUCK) || fabs(v) <= THUD_TOL_IMPULSE_RATE * fabs(change))
        return;
    if (s->mode == THUD_STUCK || phase != s->phase)
        go_on(run, c, phase, 0);
    else
        s->zeros.rate = 0;
}

static void knee(struct thud_run *run, int c)
{
    struct thud_contact_state *s = &run->contact[c];
    s->past_knee = !s->past_knee;
    s->zeros.knee = 1;
    renew_branch(run, c);
}

static enum thud_status hold_ends(struct thud_run *run, int c, enum thud_event event, struct thud_error *err)
{
    if (law_of(run, c)->flags & THUD_LAW_IMPULSIVE) { /* sustained pushing has ended: d, d' and d'' are 0 */
        note_release(run, c);
        return open_contact(run, c, 3, err);
    }
    go_on(run, c, event == THUD_EVENT_HOLD_UP ? THUD_APPROACH : THUD_RESTITUTION, 2);
    return THUD_OK;
}

enum thud_status thud_contact_switch(struct thud_run *run, int contact, int event, struct thud_error *err)
{
    struct thud_contact_state *s = &run->contact[contact];
    run->result.work.events++;
    switch ((enum thud_event)event) {
    case THUD_EVENT_TOUCH:
        if (law_of(run, contact)->flags & THUD_LAW_IMPULSIVE)
            return thud_contact_impulse(run, contact, err);
        touch(run, contact);
        return THUD_OK;
    case THUD_EVENT_GONE:
        if (s->mode == THUD_CLOSED)
            note_release(run, contact);
        return open_contact(run, contact, 1, err);
    case THUD_EVENT_RELEASE:
        return release(run, contact, err);
    case THUD_EVENT_REENGAGE:
        thud_contact_set_mode(run, contact, THUD_CLOSED);
        s->zeros = (struct thud_zeros){.force = force_zeros(run, contact, 1)};
        return THUD_OK;
    case THUD_EVENT_TURN:
        turn(run, contact);
        return THUD_OK;
    case THUD_EVENT_KNEE:
        knee(run, contact);
        return THUD_OK;
    case THUD_EVENT_HOLD_UP:
    case THUD_EVENT_HOLD_DOWN:
        break;
    }
    return hold_ends(run, contact, (enum thud_event)event, err);
}
