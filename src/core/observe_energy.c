#include "core/observe_energy.h"

#include <math.h>
#include <stdlib.h>

#include "core/contact.h"
#include "core/double_pair.h"
#include "core/free_vibration.h"
#include "core/nodes.h"
#include "core/quadrature.h"
#include "core/storey.h"

enum { LOOKS_APART = 64 }; /* segments and blocks between two looks at the balance */

/* Work, per second, and impulse of these forces at the points of a quadrature. */
static double work_of(const double *weight, const double *force, const double *rate, double *impulse)
{
    double work = 0;
    for (int i = 0; i < THUD_QUADRATURE_POINTS; i++) {
        work += weight[i] * force[i] * rate[i];
        *impulse += weight[i] * force[i];
    }
    return work;
}

/* Work done on a contact over the segment, per second of it, and its impulse. Of a power series: the work of the force
 * that was applied, and of what the law's differs from it by, which is of the size of the tolerance; laws are dear, and
 * four points are enough for that. */
static double contact_work(const struct thud_observation *o, const struct thud_nodes *nodes, int c, double *impulse)
{
    static const double four[THUD_QUADRATURE_POINTS] = {0, 0.25, 0, 0.25, 0.25, 0, 0.25, 0}; /* a parabola to 1/400 */
    const struct thud_segment *seg = o->seg;
    const bool asks = o->state->contact[c].mode != THUD_STICKING && o->state->locates,
               applies = !asks || !seg->interpolates;
    const double *weight = applies ? four : thud_quadrature_weight;
    double d[THUD_BATCH], rate[THUD_BATCH], force[THUD_BATCH] = {0}, work = 0;
    thud_nodes_rates(nodes, seg->indentation + c * THUD_SEGMENT_TERMS, 1, seg->terms, seg->h_s, rate);
    if (applies) {
        thud_nodes_values(nodes, seg->force + c, o->state->model->nrows, asks ? seg->loaded : seg->terms, force);
        work = work_of(thud_quadrature_weight, force, rate, impulse);
    }
    if (!asks)
        return work;
    thud_nodes_values(nodes, seg->indentation + c * THUD_SEGMENT_TERMS, 1, seg->terms, d);
    for (int i = 0; i < THUD_QUADRATURE_POINTS; i++)
        force[i] = weight[i] > 0 ? thud_contact_force(o->state, c, d[i], rate[i]) - force[i] : 0;
    return work + work_of(weight, force, rate, impulse);
}

static void book_contact(struct thud_ledger *l, const struct thud_observation *o, int c, double work_j,
                         double impulse_ns)
{
    struct thud_contact_result *r = &l->log->contact[c];
    l->log->now[c].impulse_ns += impulse_ns;
    l->log->now[c].dissipated_j += work_j;
    r->impulse_ns += impulse_ns;
    r->dissipated_j += work_j;
    if (thud_contact_acts(&o->state->contact[c]))
        r->contact_time_s += o->s * o->seg->h_s;
    thud_impact_count(o->state, l->log, c);
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
static void structure_work(struct thud_ledger *l, const struct thud_observation *o, const struct thud_nodes *nodes)
{
    const struct thud_model *m = o->state->model;
    const struct thud_segment *seg = o->seg;
    struct thud_batch viscous = {0}, drive = {0};
    double power[THUD_BATCH], force[THUD_BATCH], input = 0, loss = 0, dt = o->s * seg->h_s;
    for (int j = 0; j < m->nmodes; j++) {
        double *rate = l->rates + j * THUD_BATCH;
        thud_nodes_rates(nodes, seg->q + j, m->nmodes, seg->terms, seg->h_s, rate);
        struct thud_batch v = thud_batch_at(rate);
        for (int i = 0; i < THUD_BATCH / 2; i++)
            viscous.pair[i] += m->dashpot[j] * v.pair[i] * v.pair[i];
        thud_batch_add(&drive, -m->gamma[j], rate);
    }
    thud_batch_put(&viscous, power);
    thud_batch_put(&drive, force);
    for (int i = 0; i < THUD_QUADRATURE_POINTS; i++) {
        double ground = seg->a0 + seg->a1 * o->s * thud_quadrature_node[i];
        loss += thud_quadrature_weight[i] * power[i];
        input += thud_quadrature_weight[i] * ground * force[i];
    }
    l->input_j += input * dt;
    l->viscous_j += (loss + coupled_loss(m, l->rates)) * dt;
}

/* A step whose events are not located: mean forces of its two ends times the displacements between them, which is all
 * that it knows. */
static void add_ends(struct thud_ledger *l, const struct thud_observation *o, bool books)
{
    const struct thud_model *m = o->state->model;
    const struct thud_motion *a = o->seg->start, *b = o->seg->end;
    double s = o->s, drive = 0, viscous = 0;
    for (int j = 0; j < m->nmodes; j++) {
        double way = b->q[j] - a->q[j];
        drive -= m->gamma[j] * way;
        viscous += m->dashpot[j] * 0.5 * (a->qd[j] + b->qd[j]) * way;
    }
    for (int k = 0; k < m->nstructures && m->couples; k++) {
        const struct thud_model_structure *p = &m->structure[k];
        for (int i = p->first_mode; p->damping && i < p->first_mode + p->modes; i++) {
            const double *row = p->damping + (i - p->first_mode) * p->modes;
            double mean =
                0.5 * (thud_dot(p->modes, row, a->qd + p->first_mode) + thud_dot(p->modes, row, b->qd + p->first_mode));
            viscous += mean * (b->q[i] - a->q[i]);
        }
    }
    l->input_j += s * (o->seg->a0 + 0.5 * o->seg->a1) * drive;
    l->viscous_j += s * viscous;
    for (int c = 0; c < m->ncontacts; c++) {
        double force = 0.5 * (a->force[c] + b->force[c]);
        if (force == 0 && !thud_contact_acts(&o->state->contact[c]))
            continue;
        double work = s * force * (thud_model_gap_sum(m, c, b->q) - thud_model_gap_sum(m, c, a->q));
        l->contact_work_j += work;
        if (books)
            book_contact(l, o, c, work, s * force * o->seg->h_s);
    }
}

static void add_segment(struct thud_ledger *l, const struct thud_observation *o, bool books)
{
    struct thud_nodes nodes;
    double dt = o->s * o->seg->h_s;
    if (o->seg->end) {
        add_ends(l, o, books);
        return;
    }
    thud_nodes_set(&nodes, THUD_QUADRATURE_POINTS, thud_quadrature_node, o->s, o->seg->terms);
    for (int c = 0; c < o->state->model->ncontacts; c++) {
        if (!thud_segment_has_force(o->state, o->seg, c))
            continue;
        double impulse = 0, work = contact_work(o, &nodes, c, &impulse);
        l->contact_work_j += work * dt;
        if (books)
            book_contact(l, o, c, work * dt, impulse * dt);
    }
    structure_work(l, o, &nodes);
}

void thud_ledger_add(struct thud_ledger *ledger, const struct thud_observation *o)
{
    add_segment(ledger, o, false);
}

double thud_ledger_contact_work(const struct thud_ledger *ledger)
{
    return ledger->contact_work_j + ledger->log->lost_j;
}

/* What the structures hold now, as the ledger has it, may be the most so far: the energy that its error is a part of.
 */
static void mark(struct thud_ledger *l, const struct thud_state *state)
{
    double lost = l->viscous_j + thud_ledger_contact_work(l);
    if (state->model->nstoreys > 0)
        lost += thud_storeys_hysteretic(state, state->q);
    l->largest_j = fmax(l->largest_j, l->initial_j + l->input_j - lost);
}

/* Elastic energy in the contacts that are closed. */
static double stored_energy(const struct thud_state *state)
{
    double stored = 0;
    for (int c = 0; c < state->model->ncontacts; c++) {
        const struct thud_model_contact *p = &state->model->contact[c];
        if (thud_contact_acts(&state->contact[c]) && p->law->elastic_energy)
            stored += thud_law_energy(p->law, &p->setup, fmax(thud_contact_indentation(state, c), 0));
    }
    return stored;
}

static struct thud_energy balance(const struct thud_ledger *l, const struct thud_state *state)
{
    double stored = stored_energy(state), work = thud_ledger_contact_work(l);
    struct thud_energy e = {.input_j = l->input_j,
                            .kinetic_j = thud_state_kinetic(state),
                            .strain_j = thud_state_strain(state),
                            .viscous_j = l->viscous_j,
                            .contact_j = work - stored,
                            .initial_j = l->initial_j,
                            .stored_j = stored,
                            .hysteretic_j = thud_storeys_hysteretic(state, state->q)};
    double left = e.initial_j + e.input_j - e.kinetic_j - e.strain_j - e.viscous_j - work - e.hysteretic_j;
    double largest = fmax(l->largest_j, fmax(e.kinetic_j + e.strain_j, fabs(e.input_j)));
    e.error_ratio = largest > 0 ? fabs(left) / largest : 0;
    return e;
}

void thud_ledger_finish(struct thud_ledger *ledger, const struct thud_state *state)
{
    if (!ledger->closed)
        ledger->balance = balance(ledger, state);
}

void thud_ledger_close(struct thud_ledger *ledger, const struct thud_state *state)
{
    thud_ledger_finish(ledger, state);
    ledger->closed = true;
}

/* Looks at the balance now and then, so that an error can say when it was lost. */
static void watch(struct thud_ledger *l, const struct thud_state *state)
{
    if (l->looks++ % LOOKS_APART == 0 && balance(l, state).error_ratio <= l->limit)
        l->balanced_s = thud_state_now(state);
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    (void)err;
    watch(own, o->state);
    add_segment(own, o, true);
    mark(own, o->state);
    return THUD_OK;
}

static enum thud_status block(void *own, const struct thud_state *state, struct thud_free_vibration *block,
                              int intervals, struct thud_error *err)
{
    struct thud_ledger *l = own;
    double input, viscous;
    (void)err;
    watch(l, state);
    thud_free_vibration_work(block, state->model, intervals, &input, &viscous);
    l->input_j += input;
    l->viscous_j += viscous;
    mark(l, state);
    return THUD_OK;
}

const struct thud_observer thud_observe_energy = {segment, block};

enum thud_status thud_ledger_init(struct thud_ledger *ledger, const struct thud_model *model,
                                  struct thud_contact_log *log, double limit, struct thud_error *err)
{
    *ledger = (struct thud_ledger){.log = log, .limit = limit};
    ledger->rates = calloc(THUD_BATCH * (size_t)model->nmodes + 1, sizeof *ledger->rates);
    return ledger->rates ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
}

void thud_ledger_clear(struct thud_ledger *ledger)
{
    free(ledger->rates);
    ledger->rates = NULL;
}

void thud_ledger_start(struct thud_ledger *ledger, const struct thud_state *state)
{
    /* what storeys have lost before stands in their states */
    ledger->initial_j = thud_state_kinetic(state) + thud_state_strain(state) + thud_storeys_hysteretic(state, state->q);
    ledger->largest_j = ledger->initial_j;
}
