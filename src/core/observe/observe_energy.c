/* The ledger: what goes in, what is lost, and by how much they fail to add up,
 *     E_0 + W_ground = E_kinetic + E_strain + W_viscous + W_contacts + W_hysteretic     (W_weight on the left)
 * The energies on the right follow from the state; the works are integrals over the motion,
 *     W_ground = -int sum_j gamma_j a_g q_j' dt,   W_viscous = int q' . D q' dt ,
 * by Lobatto's rule along a segment, in closed form over a block of free vibration (coupled_motion, the tables of free
 * vibration), and from the ends of steps that locate nothing. */
#include "core/observe/observe_energy.h"

#include <math.h>

#include "base/arena.h"
#include "core/contact/storey.h"
#include "core/motion/free_vibration.h"
#include "core/numerics/vec.h"
#include "core/observe/contact_work.h"

enum { LOOKS_APART = 64 };          /* segments and blocks between two looks at the balance */
static const double fine = 1e-7;    /* tolerance below which works are summed to rounding */
static const double far_rad = 2.1;  /* what a piece may turn by with those points; above, it takes more, and */
static const double near_rad = 0.8; /* below, without contact, seven: right to 7e-14 of its work there */

/* Structures. The power of damping and of the ground is integrated by the few points of a stepping method's cubic, else
 * by those that leave rounding alone; the rates at both ends of the piece are known. */

/* Adds up over the modes, two at a time, and the points of a quadrature: *loss the sum of D rate^2 but what couples modes,
 * *drive that of gamma a_g rate; rates, (nmodes x apart) those at the points and then the two ends, in units of the
 * segment's length. */
static inline void add_modes(const struct thud_observation *o, const struct thud_lobatto *by,
                             const struct thud_rate_powers *power, const int points, double *rates, double *loss,
                             double *drive)
{
    const struct thud_model *m = o->state->model;
    const struct thud_segment *seg = o->seg;
    const int n = m->nmodes, apart = points + 2 + points % 2;
    thud_vec2 all_loss = {0, 0}, all_drive = {0, 0}, part[THUD_SEGMENT_TERMS]; /* s^(k - 1) */
    part[1] = thud_vec2_set(1, 1);
    for (int k = 2; k < seg->terms; k++)
        part[k] = o->s * part[k - 1];
    for (int j = 0; j < n; j += 2) {
        const bool single = j + 1 == n;
        const double *q = seg->q + n + j;
        const thud_vec2 start = thud_vec2_some(q, single), end = seg->h_s * thud_vec2_some(o->qd + j, single);
        thud_vec2 rate[THUD_LOBATTO_INNER] = {0}, square = by->end_weight * (start * start + end * end),
                  driven = by->end_weight * (seg->a0 * start + (seg->a0 + o->s * seg->a1) * end);
        for (int k = 1; k < seg->terms; k++, q += n) {
            const thud_vec2 x = part[k] * thud_vec2_some(q, single);
            for (int i = 0; i < points; i++)
                rate[i] += x * power->order[k][i];
        }
        for (int i = 0; i < points; i++) {
            const thud_vec2 weighed = by->weight[i] * rate[i];
            square += weighed * rate[i];
            driven += (seg->a0 + seg->a1 * o->s * by->node[i]) * weighed;
        }
        for (int k = 0; k < 2 && m->couples; k++) {
            double *row = rates + (j + k) * apart;
            for (int i = 0; i < points; i++)
                row[i] = rate[i][k];
            row[points] = start[k];
            row[points + 1] = end[k];
        }
        all_loss += thud_vec2_some(m->dashpot + j, single) * square;
        all_drive += thud_vec2_some(m->gamma + j, single) * driven;
    }
    *loss = thud_vec2_sum(all_loss);
    *drive = thud_vec2_sum(all_drive);
}

/* The same of the part of damping that couples modes, at those rates: the sum of rate^T D rate, D symmetric. */
static double coupled_loss(const struct thud_model *m, const struct thud_lobatto *by, const double *rates)
{
    const int points = by->inner + 2, apart = points + points % 2;
    double loss = 0, weight[THUD_LOBATTO_INNER + 2], sum[THUD_LOBATTO_INNER + 2];
    for (int i = 0; i < points; i++)
        weight[i] = i < by->inner ? by->weight[i] : by->end_weight;
    for (int s = 0; s < m->nsystems; s++) {
        const struct thud_model_structure *p = &m->structure[m->system[s]];
        const double *first = rates + p->first_mode * apart, *rate = first, *row = p->damping;
        for (int i = 0; p->damping && i < p->modes; i++, rate += apart, row += p->modes) {
            for (int k = 0; k < apart; k++)
                sum[k] = row[i] * rate[k];
            thud_add_rows(apart, i, 2, row, first, sum);
            for (int k = 0; k < points; k++)
                sum[k] *= weight[k];
            loss += thud_dot(points, rate, sum);
        }
    }
    return loss;
}

void thud_ledger_structure_work(struct thud_ledger *l, const struct thud_observation *o, double *input_j,
                                double *viscous_j)
{
    const struct thud_model *m = o->state->model;
    const struct thud_segment *seg = o->seg;
    const double turned_rad = o->state->fastest_radps * o->s * seg->h_s;
    const bool given =
        o->state->nactive > 0 || (seg->loaded > 2 && seg->loaded < seg->terms); /* forces that turn faster */
    const int far = turned_rad > far_rad, near = turned_rad < near_rad && !given;
    const bool coarse = 2 * (seg->terms - 2) < thud_lobatto[1].order;
    const struct thud_lobatto *by = &thud_lobatto[coarse ? 1 : THUD_LOBATTO_RULES - 2 + far - near];
    if (seg->nodes && o->state->tolerance >= fine) /* as good as the step */
        by = far ? by - 1 : thud_lobatto_of(seg->nodes->count);
    const struct thud_rate_powers *power = &l->power[by - thud_lobatto];
    double loss, drive;
    if (by->inner == 1)
        add_modes(o, by, power, 1, l->rates, &loss, &drive);
    else if (by->inner == 2)
        add_modes(o, by, power, 2, l->rates, &loss, &drive);
    else if (by->inner == 3)
        add_modes(o, by, power, 3, l->rates, &loss, &drive);
    else if (by->inner == 5)
        add_modes(o, by, power, 5, l->rates, &loss, &drive);
    else if (by->inner == 8)
        add_modes(o, by, power, 8, l->rates, &loss, &drive);
    else
        add_modes(o, by, power, THUD_LOBATTO_INNER, l->rates, &loss, &drive);
    if (m->couples)
        loss += coupled_loss(m, by, l->rates);
    *input_j = -o->s * drive;
    *viscous_j = o->s / seg->h_s * loss;
}

/* Work of the ground by its acceleration, and of the dashpots of single modes, between the two ends of a step. */
static void end_works(const struct thud_model *m, const struct thud_motion *a, const struct thud_motion *b,
                      double *drive, double *viscous)
{
    thud_vec2 by_ground = {0, 0}, by_rate = {0, 0};
    for (int j = 0; j < m->nmodes; j += 2) {
        const bool single = j + 1 == m->nmodes;
        const thud_vec2 way = thud_vec2_some(b->q + j, single) - thud_vec2_some(a->q + j, single),
                        rates = thud_vec2_some(a->qd + j, single) + thud_vec2_some(b->qd + j, single);
        by_ground += thud_vec2_some(m->gamma + j, single) * way;
        by_rate += thud_vec2_some(m->dashpot + j, single) * rates * way;
    }
    *drive = -(thud_vec2_sum(by_ground));
    *viscous = 0.5 * (thud_vec2_sum(by_rate));
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

/* Steps whose events are not located: mean forces of the two ends of each times the displacements between them, which is
 * all that it knows. */
static void add_ends(struct thud_ledger *l, const struct thud_observation *o)
{
    const struct thud_model *m = o->state->model;
    const struct thud_segment *seg = o->seg;
    for (int i = 0; i < seg->steps; i++) {
        const struct thud_motion *b = seg->end - (seg->steps - 1 - i), *a = i == 0 ? seg->start : b - 1;
        double drive, viscous;
        end_works(m, a, b, &drive, &viscous);
        for (int k = 0; k < m->nsystems && m->couples; k++) {
            const struct thud_model_structure *p = &m->structure[m->system[k]];
            for (int j = p->first_mode; p->damping && j < p->first_mode + p->modes; j++) {
                const double *row = p->damping + (j - p->first_mode) * p->modes;
                double mean = 0.5 * (thud_dot(p->modes, row, a->qd + p->first_mode) +
                                     thud_dot(p->modes, row, b->qd + p->first_mode));
                viscous += mean * (b->q[j] - a->q[j]);
            }
        }
        l->input_j += o->s * (seg->a0 + (i + 0.5) / seg->steps * seg->a1) * drive;
        l->viscous_j += o->s * viscous;
        if (i + 1 < seg->steps)
            mark(l, o->state);
    }
}

static void add_segment(struct thud_ledger *l, const struct thud_observation *o)
{
    double ground_j, damping_j;
    for (int i = 0; i < o->works; i++)
        l->contact_work_j += o->work[i].work_j;
    if (o->seg->end) {
        add_ends(l, o);
        return;
    }
    thud_ledger_structure_work(l, o, &ground_j, &damping_j);
    l->input_j += ground_j;
    l->viscous_j += damping_j;
}

void thud_ledger_add(struct thud_ledger *ledger, const struct thud_observation *o)
{
    struct thud_observation here = *o;
    here.works = thud_contact_works(o, ledger->work);
    here.work = ledger->work;
    add_segment(ledger, &here);
}

/* All of it at the state. error_ratio: what is unaccounted for, of the largest energy that the structures have held. */
static struct thud_energy balance(const struct thud_ledger *l, const struct thud_state *state)
{
    double stored = 0, work = thud_ledger_contact_work(l), gravity = thud_model_gravity_work(state->model, state->q);
    for (int c = 0; c < state->model->ncontacts; c++)
        stored += thud_contact_stored(state, c);
    struct thud_energy e = {.input_j = l->input_j,
                            .kinetic_j = thud_state_kinetic(state),
                            .strain_j = thud_state_strain(state) + gravity,
                            .viscous_j = l->viscous_j,
                            .contact_j = work - stored,
                            .initial_j = l->initial_j,
                            .stored_j = stored,
                            .hysteretic_j = thud_storeys_hysteretic(state, state->q),
                            .gravity_j = gravity};
    double left = e.initial_j + e.input_j + gravity - e.kinetic_j - e.strain_j - e.viscous_j - work - e.hysteretic_j;
    double largest = fmax(l->largest_j, fmax(e.kinetic_j + e.strain_j - gravity, fmax(fabs(e.input_j), gravity)));
    e.error_ratio = largest > 0 || isnan(left) ? fabs(left) / largest : 0;
    return e;
}

void thud_ledger_finish(struct thud_ledger *ledger, const struct thud_state *state)
{
    if (!ledger->closed)
        ledger->balance = balance(ledger, state);
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
    add_segment(own, o);
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
    thud_free_vibration_work(block, intervals, &input, &viscous);
    l->input_j += input;
    l->viscous_j += viscous;
    mark(l, state);
    return THUD_OK;
}

/* The balance of this moment stands for the end: in what is left out nothing new happens. */
static void jumped(void *own, const struct thud_state *state)
{
    struct thud_ledger *l = own;
    thud_ledger_finish(l, state);
    l->closed = true;
}

const struct thud_observer thud_observe_energy = {
    .segment = segment, .block = block, .may_jump = thud_observer_jumps, .jumped = jumped};

enum thud_status thud_ledger_init(struct thud_ledger *ledger, const struct thud_state *state,
                                  const struct thud_contact_log *log, double limit, struct thud_error *err)
{
    *ledger = (struct thud_ledger){.log = log, .limit = limit};
    const enum thud_status status =
        THUD_LAY_IN(state->memory, err, THUD_PIECE(ledger->power, THUD_LOBATTO_RULES),
                    THUD_PIECE(ledger->rates, (THUD_LOBATTO_INNER + 2) * (state->model->nmodes + 1)),
                    THUD_PIECE(ledger->work, state->model->ncontacts));
    for (int rule = 0; rule < THUD_LOBATTO_RULES && status == THUD_OK; rule++)
        for (int i = 0; i < thud_lobatto[rule].inner; i++) {
            double x = 1;
            for (int k = 1; k < THUD_SEGMENT_TERMS; k++, x *= thud_lobatto[rule].node[i])
                ledger->power[rule].order[k][i] = (thud_vec2_aligned){k * x, k * x};
        }
    return status;
}

void thud_ledger_start(struct thud_ledger *ledger, const struct thud_state *state)
{
    /* what storeys have lost before stands in their states */
    ledger->initial_j = thud_state_kinetic(state) + thud_state_strain(state) + thud_storeys_hysteretic(state, state->q);
    ledger->largest_j = ledger->initial_j;
}
