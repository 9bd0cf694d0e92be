#include "core/observe/observe_energy.h"

#include <math.h>
#include <stdlib.h>

#include "core/contact/contact.h"
#include "core/contact/storey.h"
#include "core/motion/free_vibration.h"
#include "core/numerics/double_pair.h"

enum { LOOKS_APART = 64 }; /* segments and blocks between two looks at the balance */

/* Contacts. */

/* The integral of f g over [0, 1]; coefficients f (orders) and g (terms). */
static double product_integral(const double *f, int orders, const double *g, int terms)
{
    enum { MOST = 2 * THUD_SEGMENT_TERMS };
    static const double inverse[MOST] = {
        1.0,      1.0 / 2,  1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,  1.0 / 7,  1.0 / 8,  1.0 / 9,  1.0 / 10,
        1.0 / 11, 1.0 / 12, 1.0 / 13, 1.0 / 14, 1.0 / 15, 1.0 / 16, 1.0 / 17, 1.0 / 18, 1.0 / 19, 1.0 / 20,
        1.0 / 21, 1.0 / 22, 1.0 / 23, 1.0 / 24, 1.0 / 25, 1.0 / 26, 1.0 / 27, 1.0 / 28, 1.0 / 29, 1.0 / 30,
        1.0 / 31, 1.0 / 32, 1.0 / 33, 1.0 / 34, 1.0 / 35, 1.0 / 36, 1.0 / 37, 1.0 / 38, 1.0 / 39, 1.0 / 40,
        1.0 / 41, 1.0 / 42, 1.0 / 43, 1.0 / 44, 1.0 / 45, 1.0 / 46, 1.0 / 47, 1.0 / 48};
    double sum = 0;
    for (int i = 0; i < orders; i++)
        sum += f[i] * thud_dot(terms, g, inverse + i);
    return sum;
}

/* What the law's force at points of the piece says beside the polynomial `force` (orders), whose work has been counted:
 * work, per second of the segment, and impulse of the difference. */
static double law_work(const struct thud_observation *o, int c, const double *force, int orders, double *impulse)
{
    /* laws are dear, and of a force polynomial the difference is of the size of the tolerance: two points for it */
    static const double two[] = {0.21132486540518713, 0.78867513459481287}, half[] = {0.5, 0.5};
    const int count = orders > 0 ? 2 : THUD_QUADRATURE_POINTS;
    const double *node = orders > 0 ? two : thud_quadrature_node, *weight = orders > 0 ? half : thud_quadrature_weight;
    const double *d = o->seg->indentation + c * THUD_SEGMENT_TERMS, rate = 1 / o->seg->h_s;
    double work = 0;
    for (int i = 0; i < count; i += 2) {
        const thud_double_pair s = o->s * thud_double_pair_at(node + i);
        thud_double_pair x = {0, 0}, v = {0, 0}, f = {0, 0};
        for (int k = o->seg->terms - 1; k >= 0; k--) {
            v = v * s + x;
            x = x * s + d[k];
        }
        for (int k = orders - 1; k >= 0; k--)
            f = f * s + force[k];
        for (int side = 0; side < 2; side++) {
            const double more = thud_contact_force(o->state, c, x[side], rate * v[side]) - f[side];
            work += weight[i + side] * more * rate * v[side];
            *impulse += weight[i + side] * more;
        }
    }
    return work;
}

/* Work done on a contact over the segment, per second of it, and its mean force. Of a power series: the work of the force
 * that was applied, and of what the law's differs from it by. */
static double contact_work(const struct thud_observation *o, int c, double *impulse)
{
    const struct thud_segment *seg = o->seg;
    const bool asks = o->state->contact[c].mode != THUD_STICKING && o->state->locates,
               applies = !asks || !seg->interpolates;
    const double *d = seg->indentation + c * THUD_SEGMENT_TERMS, s = o->s;
    const int orders = !applies ? 0 : asks && seg->loaded < seg->terms ? seg->loaded : seg->terms;
    double force[THUD_SEGMENT_TERMS], part[THUD_SEGMENT_TERMS], rate[THUD_SEGMENT_TERMS], work = 0, power = 1;
    static const double one = 1;
    for (int k = 0; k < orders; k++, power *= s) { /* over [0, s] as over [0, 1] */
        force[k] = seg->force[k * o->state->model->nrows + c];
        part[k] = power * force[k];
    }
    power = 1;
    for (int k = 1; k < seg->terms; k++, power *= s)
        rate[k - 1] = k * power * d[k];
    if (applies) {
        work = product_integral(part, orders, rate, seg->terms - 1) / seg->h_s;
        *impulse = product_integral(&one, 1, part, orders);
    }
    return asks ? work + law_work(o, c, force, orders, impulse) : work;
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

/* Structures. The power of damping and of the ground is integrated by the rule of fewest points whose error is bounded
 * by a small part of the tolerance; the rates at both ends of the piece are known. */

/* Power of the damping that couples modes (isolated buildings) at these modal rates. */
static double coupled_power(const struct thud_model *m, const double *rate)
{
    double sum = 0;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        for (int i = 0; p->damping && i < p->modes; i++)
            sum += rate[p->first_mode + i] * thud_dot(p->modes, p->damping + i * p->modes, rate + p->first_mode);
    }
    return sum;
}

/* Power of the damping, and the ground's per unit of its acceleration, at the points of a quadrature. */
struct powers {
    thud_double_pair loss[THUD_LOBATTO_INNER], drive[THUD_LOBATTO_INNER]; /* two parts of each */
};

/* Adds those of two modes, or one, in units of the segment's length. */
static inline void add_modes(const struct thud_model *m, const struct thud_segment *seg, int j, bool single,
                             const struct thud_rate_powers *power, const int points, double *rates, struct powers *sum)
{
    const thud_double_pair dashpot = thud_double_pair_some(m->dashpot + j, single),
                           gamma = thud_double_pair_some(m->gamma + j, single);
    const int n = m->nmodes, terms = seg->terms;
    const double *q = seg->q + n + j;
    thud_double_pair rate[THUD_LOBATTO_INNER] = {0};
    for (int k = 1; k < terms; k++, q += n) {
        const thud_double_pair x = thud_double_pair_some(q, single);
        for (int i = 0; i < points; i++)
            rate[i] += x * power->order[k][i];
    }
    for (int i = 0; i < points; i++) {
        sum->loss[i] += dashpot * rate[i] * rate[i];
        sum->drive[i] += gamma * rate[i];
        if (m->couples)
            thud_double_pair_put(rate[i], rates + i * n + j, single);
    }
}

static inline void add_all_modes(const struct thud_model *m, const struct thud_segment *seg,
                                 const struct thud_rate_powers *power, const int points, double *rates,
                                 struct powers *sum)
{
    int j = 0;
    for (; j + 2 <= m->nmodes; j += 2)
        add_modes(m, seg, j, false, power, points, rates, sum);
    if (j < m->nmodes)
        add_modes(m, seg, j, true, power, points, rates, sum);
}

/* Powers of the points s times as far from the start: k (s x)^(k - 1). */
static void scale_powers(const struct thud_rate_powers *unit, int points, double s, int terms,
                         struct thud_rate_powers *out)
{
    double factor = 1;
    for (int k = 1; k < terms; k++, factor *= s)
        for (int i = 0; i < points; i++)
            out->order[k][i] = factor * unit->order[k][i];
}

/* Power of the damping at an end of the piece, where the modal rates are factor times these, and the ground's. */
static double end_loss(const struct thud_model *m, const double *rate, double factor, double ground, double *drive)
{
    double loss = m->couples ? coupled_power(m, rate) : 0;
    for (int j = 0; j < m->nmodes; j++)
        loss += m->dashpot[j] * rate[j] * rate[j];
    *drive = -ground * factor * thud_dot(m->nmodes, m->gamma, rate);
    return factor * factor * loss;
}

void thud_ledger_structure_work(struct thud_ledger *l, const struct thud_observation *o, int rule, double *input_j,
                                double *viscous_j)
{
    const struct thud_model *m = o->state->model;
    const struct thud_segment *seg = o->seg;
    const struct thud_lobatto *by = &thud_lobatto[rule];
    struct thud_rate_powers scaled;
    const struct thud_rate_powers *power = &l->power[rule];
    struct powers sum = {0};
    double start, end, rate = 1 / seg->h_s;
    if (o->s != 1) {
        scale_powers(power, by->inner, o->s, seg->terms, &scaled);
        power = &scaled;
    }
    if (by->inner == 2)
        add_all_modes(m, seg, power, 2, l->rates, &sum);
    else if (by->inner == 4)
        add_all_modes(m, seg, power, 4, l->rates, &sum);
    else if (by->inner == 6)
        add_all_modes(m, seg, power, 6, l->rates, &sum);
    else
        add_all_modes(m, seg, power, THUD_LOBATTO_INNER, l->rates, &sum);
    double loss = by->end_weight * (end_loss(m, seg->q + m->nmodes, rate, seg->a0, &start) +
                                    end_loss(m, o->qd, 1, seg->a0 + o->s * seg->a1, &end)),
           input = by->end_weight * (start + end);
    for (int i = 0; i < by->inner; i++) {
        double ground = seg->a0 + seg->a1 * o->s * by->node[i],
               coupled = m->couples ? coupled_power(m, l->rates + i * m->nmodes) : 0;
        loss += by->weight[i] * rate * rate * (sum.loss[i][0] + sum.loss[i][1] + coupled);
        input -= by->weight[i] * rate * ground * (sum.drive[i][0] + sum.drive[i][1]);
    }
    *input_j = input * o->s * seg->h_s;
    *viscous_j = loss * o->s * seg->h_s;
}

/* Size of the load on the modes, times h^2, by order: of the ground and the forces. A row's share is sqrt(g . g). */
static void load_sizes(const struct thud_ledger *l, const struct thud_observation *o, double *load)
{
    const struct thud_model *m = o->state->model;
    const struct thud_segment *seg = o->seg;
    const double square = seg->h_s * seg->h_s;
    for (int k = 0; k < THUD_SEGMENT_TERMS; k++)
        load[k] = 0;
    for (int i = 0; i < seg->rows; i++) {
        const int c = seg->row[i];
        const double share = square * sqrt(m->delassus[c * m->nrows + c]);
        for (int k = 0; k < seg->loaded; k++)
            load[k] += share * fabs(seg->force[k * m->nrows + c]);
    }
    load[0] += square * l->influence * fabs(seg->a0);
    load[1] += square * l->influence * fabs(seg->a1);
}

/* Bounds of the modal rates' derivatives in the segment, as norms over the modes and in units of its length: with u =
 * (q', omega q) and a load p,
 *     |u'| <= (omega + 2 zeta omega) |u| + |p| ,
 * and sqrt(2 E) of the largest energy so far, with what the load adds, bounds |u| itself. */
static void rate_bounds(const struct thud_ledger *l, const struct thud_observation *o, double *bound)
{
    const struct thud_segment *seg = o->seg;
    const int last = (seg->loaded > 2 ? seg->loaded : 2) - 1;
    const double angle = seg->h_s * (o->state->fastest_radps + l->dashpot);
    double load[THUD_SEGMENT_TERMS], most = 0, factor = 1;
    load_sizes(l, o, load);
    for (int k = last; k >= 0; k--)
        load[k] = most += load[k]; /* of the orders from k on */
    bound[0] = seg->h_s * sqrt(2 * l->largest_j) + most;
    for (int i = 0; i < thud_lobatto[THUD_LOBATTO_RULES - 2].order;
         i++) { /* s^k by i times: at most last!/(last - i)! */
        bound[i + 1] = angle * bound[i] + (i <= last ? factor * load[i] : 0);
        factor *= last - i;
    }
}

static double error_bound(const struct thud_ledger *l, const struct thud_segment *seg, const double *bound,
                          const struct thud_lobatto *rule)
{
    const int order = rule->order;
    double sum = 0, binomial = 1;
    for (int i = 0; i < order / 2; i++) {
        sum += 2 * binomial * bound[i] * bound[order - i];
        binomial = binomial * (order - i) / (i + 1);
    }
    sum = l->dashpot / seg->h_s * (sum + binomial * bound[order / 2] * bound[order / 2]);
    sum += l->influence * ((fabs(seg->a0) + fabs(seg->a1)) * bound[order] + order * fabs(seg->a1) * bound[order - 1]);
    return rule->error * sum;
}

void thud_ledger_error_bounds(const struct thud_ledger *l, const struct thud_observation *o, double *bound)
{
    double rate[THUD_LOBATTO_ORDER + 1];
    rate_bounds(l, o, rate);
    for (int rule = 0; rule + 1 < THUD_LOBATTO_RULES; rule++)
        bound[rule] = error_bound(l, o->seg, rate, &thud_lobatto[rule]);
}

/* The rule of fewest points that is exact, or right to a small part of what may be unaccounted for; where no bound is
 * known only an exact one or the last: of coupled damping, and of storeys that yield, whose modes hold more than the
 * structure's energy. */
static int rule_for(const struct thud_ledger *l, const struct thud_observation *o)
{
    static const double part = 1e-4; /* in each of some hundred pieces */
    const struct thud_model *m = o->state->model;
    const bool bounded = !o->seg->interpolates && !m->couples && m->nstoreys == 0;
    double bound[THUD_LOBATTO_RULES - 1];
    int rule = 0;
    if (bounded)
        thud_ledger_error_bounds(l, o, bound);
    while (rule + 1 < THUD_LOBATTO_RULES && 2 * (o->seg->terms - 2) >= thud_lobatto[rule].order &&
           !(bounded && bound[rule] <= part * l->limit * l->largest_j))
        rule++;
    return rule;
}

/* Work of the ground by its acceleration, and of the dashpots of single modes, between the two ends of a step. */
static void end_works(const struct thud_model *m, const struct thud_motion *a, const struct thud_motion *b,
                      double *drive, double *viscous)
{
    thud_double_pair by_ground = {0, 0}, by_rate = {0, 0};
    int j = 0;
    for (; j + 2 <= m->nmodes; j += 2) {
        thud_double_pair way = thud_double_pair_at(b->q + j) - thud_double_pair_at(a->q + j);
        thud_double_pair rates = thud_double_pair_at(a->qd + j) + thud_double_pair_at(b->qd + j);
        by_ground += thud_double_pair_at(m->gamma + j) * way;
        by_rate += thud_double_pair_at(m->dashpot + j) * rates * way;
    }
    *drive = -(by_ground[0] + by_ground[1]);
    *viscous = 0.5 * (by_rate[0] + by_rate[1]);
    if (j == m->nmodes)
        return;
    *drive -= m->gamma[j] * (b->q[j] - a->q[j]);
    *viscous += 0.5 * m->dashpot[j] * (a->qd[j] + b->qd[j]) * (b->q[j] - a->q[j]);
}

/* A step whose events are not located: mean forces of its two ends times the displacements between them, which is all
 * that it knows. */
static void add_ends(struct thud_ledger *l, const struct thud_observation *o, bool books)
{
    const struct thud_model *m = o->state->model;
    const struct thud_motion *a = o->seg->start, *b = o->seg->end;
    double s = o->s, drive, viscous;
    end_works(m, a, b, &drive, &viscous);
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
    for (int c = 0; c < m->ncontacts && !(a->apart && b->apart && o->state->nactive == 0); c++) {
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
    double dt = o->s * o->seg->h_s, ground_j, damping_j;
    if (o->seg->end) {
        add_ends(l, o, books);
        return;
    }
    for (int c = 0; c < o->state->model->ncontacts; c++) {
        if (!thud_segment_has_force(o->state, o->seg, c))
            continue;
        double impulse = 0, work = contact_work(o, c, &impulse);
        l->contact_work_j += work * dt;
        if (books)
            book_contact(l, o, c, work * dt, impulse * dt);
    }
    thud_ledger_structure_work(l, o, rule_for(l, o), &ground_j, &damping_j);
    l->input_j += ground_j;
    l->viscous_j += damping_j;
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
    struct thud_rate_powers *power = calloc(THUD_LOBATTO_RULES, sizeof *power);
    ledger->power = power;
    ledger->rates = calloc(THUD_LOBATTO_INNER * (size_t)model->nmodes + 1, sizeof *ledger->rates);
    if (!power || !ledger->rates) {
        thud_ledger_clear(ledger);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    for (int j = 0; j < model->nmodes; j++)
        ledger->dashpot = fmax(ledger->dashpot, model->dashpot[j]);
    ledger->influence = sqrt(thud_dot(model->nmodes, model->gamma, model->gamma));
    for (int rule = 0; rule < THUD_LOBATTO_RULES; rule++)
        for (int i = 0; i < thud_lobatto[rule].inner; i++) {
            double x = 1;
            for (int k = 1; k < THUD_SEGMENT_TERMS; k++, x *= thud_lobatto[rule].node[i])
                power[rule].order[k][i] = (thud_aligned_pair){k * x, k * x};
        }
    return THUD_OK;
}

void thud_ledger_clear(struct thud_ledger *ledger)
{
    free(ledger->power);
    free(ledger->rates);
    ledger->power = NULL;
    ledger->rates = NULL;
}

void thud_ledger_start(struct thud_ledger *ledger, const struct thud_state *state)
{
    /* what storeys have lost before stands in their states */
    ledger->initial_j = thud_state_kinetic(state) + thud_state_strain(state) + thud_storeys_hysteretic(state, state->q);
    ledger->largest_j = ledger->initial_j;
}
