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
static double rest_speed(const struct thud_run *run)
{
    return fmax(1e-4 * run->options.tolerance, THUD_TOL_REST) * run->speed_mps;
}

/* Contacts that take part: the one that touches now, those that are held, and those that are at zero distance. */
static int gather(const struct thud_run *run, int touching, int *set)
{
    int n = 0;
    for (int c = 0; c < run->model->ncontacts; c++) {
        const struct thud_contact_state *s = &run->contact[c];
        if (!(run->model->contact[c].law->flags & THUD_LAW_IMPULSIVE))
            continue;
        bool at_zero = s->mode == THUD_OPEN && fabs(thud_contact_indentation(run, c)) <= THUD_TOL_INDENTATION_M;
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

static enum thud_status impulses(const struct thud_run *run, struct collision *x, struct thud_error *err)
{
    const struct thud_model *m = run->model;
    for (int i = 0; i < x->n; i++) {
        int c = x->set[i];
        double v = x->speed[i] = thud_contact_rate(run, c);
        double e = m->contact[c].law->nominal(&m->contact[c].setup);
        bool held = run->contact[c].mode == THUD_STUCK; /* what rate it has is the error of the force that holds it */
        if (held || !(e * v > rest_speed(run)))         /* or the force would have to bring it to rest at once */
            e = 0;
        x->q[i] = -(1 + e) * v;
        for (int j = 0; j < x->n; j++)
            x->m[i * x->n + j] = m->w[c * m->ncontacts + x->set[j]];
    }
    enum thud_status status = thud_lcp_solve(x->n, x->m, x->q, x->impulse, x->work, err);
    return status == THUD_DIVERGED && m->left_out > 0 ? thud_run_too_few_modes(run, err) : status;
}

static void apply(struct thud_run *run, const struct collision *x)
{
    const struct thud_model *m = run->model;
    for (int i = 0; i < x->n; i++) {
        const double *g = m->g + x->set[i] * m->nmodes;
        for (int j = 0; j < m->nmodes; j++)
            run->qd[j] -= g[j] * x->impulse[i];
    }
}

/* Puts one impact into the results. */
static enum thud_status note(struct thud_run *run, int c, double before, double impulse, struct thud_error *err)
{
    struct thud_contact_result *r = &run->result.contact[c];
    double after = -thud_contact_rate(run, c), lost = impulse * (before - after) / 2;
    struct thud_impact impact = {.contact = c,
                                 .start_s = thud_run_now(run),
                                 .approach_mps = before,
                                 .separation_mps = after,
                                 .impulse_ns = impulse,
                                 .dissipated_j = lost};
    r->impulse_ns += impulse;
    r->dissipated_j += lost;
    run->ledger.contact_work_j += lost;
    if (!(before > 0) || run->contact[c].mode == THUD_STUCK)
        return THUD_OK; /* a held contact passes the blow on */
    r->impacts++;
    r->approach_mps = before;
    r->separation_mps = after;
    return thud_impacts_add(run, &impact, err);
}

/* After the impulses: held where the structures push on and nothing bounces, else open. */
static void settle(struct thud_run *run, int c)
{
    struct thud_contact_state *s = &run->contact[c];
    double rate = thud_contact_rate(run, c);
    if (fabs(rate) > rest_speed(run)) {
        thud_contact_set_mode(run, c, THUD_OPEN);
        s->zeros = (struct thud_zeros){.indentation = 1};
        return;
    }
    thud_contact_set_mode(run, c, THUD_OPEN);
    thud_contact_forces(run, run->force_now);
    if (thud_contact_acceleration(run, c, run->force_now) <= -thud_contact_rounding(run)) {
        s->zeros = (struct thud_zeros){.indentation = 2};
        return;
    }
    thud_contact_set_mode(run, c, THUD_STUCK);
    s->hold_low = 0;
    s->hold_high = INFINITY;
    s->zeros = (struct thud_zeros){.force = 1};
    s->impact = (struct thud_impact){.contact = c, .start_s = thud_run_now(run)};
}

/* What the impulses do to the rates of the contacts that have forces. */
static void strike_others(struct thud_run *run, const struct collision *x)
{
    const struct thud_model *m = run->model;
    for (int c = 0; c < m->ncontacts; c++) {
        double change = 0;
        for (int i = 0; i < x->n; i++)
            change -= m->w[c * m->ncontacts + x->set[i]] * x->impulse[i];
        if (change != 0 && !(m->contact[c].law->flags & THUD_LAW_IMPULSIVE))
            thud_contact_struck(run, c, change);
    }
}

enum thud_status thud_contact_impulse(struct thud_run *run, int contact, struct thud_error *err)
{
    int *set = run->set_now, n = gather(run, contact, set);
    double *block = run->collide;
    struct collision x = {n, set, block, block + n, block + 2 * n, block + 2 * n + n * n, block + 3 * n + n * n};
    enum thud_status status = impulses(run, &x, err);
    if (status != THUD_OK)
        return status;
    apply(run, &x);
    for (int i = 0; i < n && status == THUD_OK; i++)
        if (x.impulse[i] > 0)
            status = note(run, set[i], x.speed[i], x.impulse[i], err);
    for (int i = 0; i < n; i++)
        if (x.impulse[i] > 0 || set[i] == contact)
            settle(run, set[i]);
    strike_others(run, &x);
    return status;
}
