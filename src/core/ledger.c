/* The energy ledger: work done by the ground, lost in the structures' damping and in the contacts, each by quadrature
 * of its own power, against the energy that the state holds. What is left over is the error. */
#include <math.h>

#include "core/nodes.h"
#include "core/quadrature.h"
#include "core/run_private.h"
#include "core/tolerance.h"

/* Work done on a contact over the segment, per second of it, and its impulse. */
static double contact_work(const struct thud_run *run, const struct thud_nodes *places, int c, double *impulse)
{
    const struct thud_contact_state *s = &run->state.contact[c];
    double d[THUD_BATCH], rate[THUD_BATCH], force[THUD_BATCH], work = 0;
    int terms = run->seg.terms;
    bool applied = s->mode == THUD_STICKING || !run->state.locates; /* what the step really applied */
    thud_nodes_rates(places, run->seg.indentation + c * THUD_SEGMENT_TERMS, 1, terms, run->seg.h_s, rate);
    if (applied)
        thud_nodes_values(places, run->seg.force + c, run->state.model->ncontacts, terms, force);
    else
        thud_nodes_values(places, run->seg.indentation + c * THUD_SEGMENT_TERMS, 1, terms, d);
    for (int i = 0; i < THUD_QUADRATURE_POINTS; i++) {
        double f = applied ? force[i] : thud_contact_force(&run->state, c, d[i], rate[i]);
        work += thud_quadrature_weight[i] * f * rate[i];
        *impulse += thud_quadrature_weight[i] * f;
    }
    return work;
}

static void book_contact(struct thud_run *run, const struct thud_nodes *places, int c, double dt)
{
    struct thud_contact_state *s = &run->state.contact[c];
    double impulse = 0, work = contact_work(run, places, c, &impulse);
    run->log.now[c].impulse_ns += impulse * dt;
    run->log.now[c].dissipated_j += work * dt;
    run->result.contact[c].impulse_ns += impulse * dt;
    thud_impact_count(&run->state, &run->log, c);
    if (thud_contact_acts(s))
        run->result.contact[c].contact_time_s += dt;
    run->result.contact[c].dissipated_j += work * dt;
    run->ledger.contact_work_j += work * dt;
}

void thud_ledger_start(struct thud_run *run)
{
    run->ledger.initial_j = thud_state_kinetic(&run->state) + thud_state_strain(&run->state);
    run->ledger.largest_j = run->ledger.initial_j;
}

/* Work of the damping that couples modes (isolated buildings) over the segment, per second of it, at modal rates
 * (nmodes x THUD_BATCH). */
static double coupled_loss(const struct thud_model *m, const double *rate)
{
    double sum = 0;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        for (int i = 0; p->damping && i < p->modes; i++)
            for (int j = 0; j < p->modes; j++) {
                const double *a = rate + (p->first_mode + i) * THUD_BATCH, *b = rate + (p->first_mode + j) * THUD_BATCH;
                for (int x = 0; x < THUD_QUADRATURE_POINTS; x++)
                    sum += thud_quadrature_weight[x] * a[x] * p->damping[i * p->modes + j] * b[x];
            }
    }
    return sum;
}

/* Work of the ground and of the structures' damping. */
static void structure_work(struct thud_run *run, const struct thud_nodes *places, double s, double dt)
{
    const struct thud_model *m = run->state.model;
    struct thud_batch viscous = {0}, drive = {0};
    double power[THUD_BATCH], force[THUD_BATCH], input = 0, loss = 0;
    for (int j = 0; j < m->nmodes; j++) {
        double *rate = run->scratch + j * THUD_BATCH;
        thud_nodes_rates(places, run->seg.q + j, m->nmodes, run->seg.terms, run->seg.h_s, rate);
        struct thud_batch v = thud_batch_at(rate);
        for (int i = 0; i < THUD_BATCH / 2; i++)
            viscous.pair[i] += 2 * m->zeta[j] * m->omega[j] * v.pair[i] * v.pair[i];
        thud_batch_add(&drive, -m->gamma[j], rate);
    }
    thud_batch_put(&viscous, power);
    thud_batch_put(&drive, force);
    for (int i = 0; i < THUD_QUADRATURE_POINTS; i++) {
        double ground = run->seg.a0 + run->seg.a1 * s * thud_quadrature_node[i];
        loss += thud_quadrature_weight[i] * power[i];
        input += thud_quadrature_weight[i] * ground * force[i];
    }
    run->ledger.input_j += input * dt;
    run->ledger.viscous_j += (loss + coupled_loss(m, run->scratch)) * dt;
}

void thud_ledger_mark(struct thud_run *run)
{
    struct thud_ledger *l = &run->ledger;
    l->largest_j = fmax(l->largest_j, l->initial_j + l->input_j - l->viscous_j - l->contact_work_j);
}

void thud_ledger_segment(struct thud_run *run, double s)
{
    struct thud_nodes places;
    double dt = s * run->seg.h_s;
    thud_nodes_set(&places, THUD_QUADRATURE_POINTS, thud_quadrature_node, s, run->seg.terms);
    for (int c = 0; c < run->state.model->ncontacts; c++)
        if (thud_segment_has_force(&run->state, &run->seg, c))
            book_contact(run, &places, c, dt);
    structure_work(run, &places, s, dt);
    thud_ledger_mark(run);
}

struct thud_ledger thud_ledger_at(struct thud_run *run, double s)
{
    struct thud_nodes places;
    const struct thud_ledger before = run->ledger;
    double dt = s * run->seg.h_s, impulse = 0;
    thud_nodes_set(&places, THUD_QUADRATURE_POINTS, thud_quadrature_node, s, run->seg.terms);
    for (int c = 0; c < run->state.model->ncontacts; c++)
        if (thud_segment_has_force(&run->state, &run->seg, c))
            run->ledger.contact_work_j += contact_work(run, &places, c, &impulse) * dt;
    structure_work(run, &places, s, dt);
    const struct thud_ledger at = run->ledger;
    run->ledger = before;
    return at;
}

void thud_ledger_impulses(struct thud_run *run)
{
    run->ledger.contact_work_j += run->log.lost_j;
    run->log.lost_j = 0;
}

/* Elastic energy in the contacts that are closed. */
static double stored_energy(const struct thud_run *run)
{
    double stored = 0;
    for (int c = 0; c < run->state.model->ncontacts; c++) {
        const struct thud_contact_state *s = &run->state.contact[c];
        const struct thud_model_contact *p = &run->state.model->contact[c];
        if (thud_contact_acts(s) && p->law->elastic_energy)
            stored += p->law->elastic_energy(&p->setup, fmax(thud_contact_indentation(&run->state, c), 0));
    }
    return stored;
}

/* The balance of the run's state. */
static struct thud_energy balance(const struct thud_run *run)
{
    const struct thud_ledger *l = &run->ledger;
    double stored = stored_energy(run);
    struct thud_energy e = {.input_j = l->input_j,
                            .kinetic_j = thud_state_kinetic(&run->state),
                            .strain_j = thud_state_strain(&run->state),
                            .viscous_j = l->viscous_j,
                            .contact_j = l->contact_work_j - stored,
                            .initial_j = l->initial_j,
                            .stored_j = stored};
    double left = e.initial_j + e.input_j - e.kinetic_j - e.strain_j - e.viscous_j - l->contact_work_j;
    double largest = fmax(l->largest_j, fmax(e.kinetic_j + e.strain_j, fabs(e.input_j)));
    e.error_ratio = largest > 0 ? fabs(left) / largest : 0;
    return e;
}

void thud_ledger_finish(struct thud_run *run)
{
    if (!run->ledger.closed)
        run->result.energy = balance(run);
}

void thud_ledger_close(struct thud_run *run)
{
    thud_ledger_finish(run);
    run->ledger.closed = true;
}

double thud_run_balance(const struct thud_run *run)
{
    /* What rounding explains: motion and linear contact are propagated to rounding, and over hundreds of random scenes,
     * the presets and their studies the ledger then stands at 1e-15 to 3e-13. What the tolerance explains: with forces
     * found to it, the ledger stood at no more than 0.06 of it. And what a coarse but stable step may lose. */
    static const double coarse = 0.05;
    const struct thud_model *m = run->state.model;
    bool linear = true;
    for (int c = 0; c < m->ncontacts; c++)
        linear = linear && m->contact[c].law->flags & (THUD_LAW_LINEAR | THUD_LAW_NO_FORCE);
    if (run->method->order > 0)
        return coarse;
    return linear ? THUD_TOL_BALANCE : fmin(THUD_TOL_BALANCE + run->options.tolerance, coarse);
}

void thud_ledger_watch(struct thud_run *run)
{
    if (!run->ledger.closed && balance(run).error_ratio <= thud_run_balance(run))
        run->ledger.balanced_s = thud_state_now(&run->state);
}

enum thud_status thud_ledger_judge(const struct thud_run *run, struct thud_error *err)
{
    double ratio = run->result.energy.error_ratio, most = thud_run_balance(run);
    if (run->options.unjudged || ratio <= most) /* false for NaN */
        return THUD_OK;
    thud_error_set(err, THUD_DIVERGED, "%.2g %% of the energy is unaccounted for: it has not balanced since t = %.6g s",
                   100 * ratio, run->ledger.balanced_s);
    thud_error_key(err, run->method->name);
    if (run->method->flags & THUD_METHOD_FIXED_STEP)
        thud_error_allow(err, "at most %.2g %%; step used %.6g s, fastest mode %.6g rad/s", 100 * most,
                         run->result.step_s, run->state.fastest_radps);
    else
        thud_error_allow(err, "at most %.2g %%", 100 * most);
    return THUD_DIVERGED;
}
