/* Where the rows of a history stand, and why.
 *
 *     on a grid          outside contacts: every step of the record, as a curve is drawn through them
 *     closer             in a contact, and for a while behind it: an impact is over in some milliseconds, and wakes modes
 *                        that the grid would not resolve
 *     at peaks           where the result has one, so that the largest value of a column is the reported peak
 *     twice at a moment  where something jumps: the row before an event and the one behind it, or both sides of the end of
 *                        a record whose last sample is not 0
 *
 * Energies are those of the run's ledger at the segment's start, and what the segment adds up to the row. Columns stand
 * in the order of THUD_HISTORY_LIST. */
#include "core/observe/observe_history.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "core/contact/storey.h"
#include "core/motion/free_vibration.h"
#include "core/numerics/tolerance.h"

enum { SHEARS = 2 }; /* of struck columns */

void thud_history_lay_out(struct thud_history *h)
{
    const int count[] = {
#define THUD_HISTORY(name, count) count,
        THUD_HISTORY_LIST(THUD_HISTORY)
#undef THUD_HISTORY
    };
    for (int i = 0; i < THUD_HISTORY_QUANTITIES; i++)
        h->first[i + 1] = h->first[i] + count[i];
    h->columns = h->first[THUD_HISTORY_QUANTITIES];
}

enum thud_status thud_history_rows_init(struct thud_history_rows *rows, const struct thud_state *state,
                                        const struct thud_result *result, const struct thud_ledger *ledger,
                                        double step_s, double look_s, struct thud_error *err)
{
    const struct thud_model *model = state->model;
    *rows = (struct thud_history_rows){
        .result = result, .ledger = ledger, .step_s = step_s, .look_s = look_s, .rest_from_s = INFINITY};
    rows->history.ndof = model->ndof;
    rows->history.ncontacts = model->npairs;
    rows->history.nstoreys = model->nstoreys - model->nslips;
    rows->history.loses = model->nstoreys > 0;
    rows->history.nstruck = model->ncolumns;
    rows->history.nlinks = model->nlinks;
    rows->history.weighs = model->collapses;
    thud_history_lay_out(&rows->history);
    return THUD_LAY_IN(state->memory, err, THUD_PIECE(rows->work, 3 * model->nmodes + model->nrows));
}

void thud_history_rows_clear(struct thud_history_rows *rows)
{
    free(rows->history.time_s);
    free(rows->history.value);
}

static double *new_row(struct thud_history *h, double time, struct thud_error *err)
{
    double *times = thud_grow(h->time_s, h->rows, sizeof *times),
           *values = thud_grow(h->value, h->rows, (size_t)h->columns * sizeof *values);
    h->time_s = times ? times : h->time_s;
    h->value = values ? values : h->value;
    if (!times || !values) {
        thud_error_set(err, THUD_MEMORY, "out of memory for the histories");
        return NULL;
    }
    /* never before the row above, and the two sides of a jump at one time, not but for the last bits either: readers of
     * histories rely on it */
    double above = h->rows ? h->time_s[h->rows - 1] : -INFINITY;
    h->time_s[h->rows] = time - above <= 4 * DBL_EPSILON * fabs(time) ? above : time;
    return h->value + h->rows++ * (size_t)h->columns;
}

/* Floors' displacements and velocities, indentations and energies, from modal values. */
static void fill_motion(const struct thud_history *h, const struct thud_state *state, double *row, const double *q,
                        const double *qd)
{
    const struct thud_model *m = state->model;
    double kinetic = 0, strain = 0;
    for (int i = 0; i < h->ndof; i++) {
        row[thud_history_displacement(h, i)] = thud_model_floor(m, i, q);
        row[thud_history_velocity(h, i)] = thud_model_floor(m, i, qd);
    }
    for (int c = 0; c < h->ncontacts; c++)
        row[thud_history_indentation(h, c)] = thud_model_gap_sum(m, c, q) - thud_state_clearance(state, c);
    for (int j = 0; j < m->nmodes; j++) {
        kinetic += 0.5 * qd[j] * qd[j];
        strain += 0.5 * m->spring[j] * q[j] * q[j];
    }
    row[thud_history_energy(h, 1)] = kinetic;
    const double gravity = thud_model_gravity_work(m, q);
    row[thud_history_energy(h, 2)] = strain + thud_storeys_strain(state, q) + gravity;
    if (h->weighs)
        row[thud_history_gravity(h, 0)] = gravity;
}

static void fill_storeys(const struct thud_history *h, const struct thud_state *state, double *row, const double *q)
{
    if (h->loses)
        row[thud_history_hysteretic(h, 0)] = thud_storeys_hysteretic(state, q);
    for (int k = 0; k < h->nstoreys; k++) {
        double drift = thud_model_gap_sum(state->model, state->model->ncontacts + k, q);
        row[thud_history_storey_drift(h, k)] = drift;
        row[thud_history_storey_shear(h, k)] = thud_storey_shear(state, k, drift);
        row[thud_history_storey_plastic(h, k)] = thud_storey_plastic(state, k, drift);
    }
}

/* From those at the segment's beginning to its s, where the modal state is q, qd. */
static void fill_works(const struct thud_history *h, const struct thud_ledger *of_segment,
                       const struct thud_observation *o, double s, const double *q, const double *qd, double *row)
{
    struct thud_observation here = *o;
    struct thud_ledger ledger = *of_segment;
    here.s = s;
    here.q = q;
    here.qd = qd;
    thud_ledger_add(&ledger, &here);
    row[thud_history_energy(h, 0)] = ledger.input_j;
    row[thud_history_energy(h, 3)] = ledger.viscous_j;
    row[thud_history_energy(h, 4)] = thud_ledger_contact_work(&ledger);
}

/* Shears of struck columns, with the forces of all rows; the row has the displacements. */
static void fill_columns(const struct thud_history *h, const struct thud_model *m, const double *force, double *row)
{
    for (int i = 0; i < m->ncolumns; i++) {
        const struct thud_model_column *p = &m->column[i];
        const struct thud_model_structure *of = &m->structure[p->structure];
        const double drift = thud_model_drift(of, row + thud_history_displacement(h, of->first), 1, p->storey - 1);
        for (int q = 0; q < SHEARS; q++) {
            double value = p->per_drift[q] * drift + (p->yielding >= 0 ? p->per_yield[q] * force[p->yielding] : 0);
            for (int c = 0; c < m->ncontacts; c++)
                if (m->contact[c].column == i)
                    value += m->contact[c].per_force[q] * force[c];
            row[thud_history_column_shear(h, SHEARS * i + q)] = value;
        }
    }
}

static void fill_links(const struct thud_history *h, const struct thud_model *m, const double *force, const double *q,
                       const double *qd, double *row)
{
    for (int i = 0; i < m->nlinks; i++) {
        const struct thud_model_link *p = &m->link[i];
        const double d = thud_model_link(m, i, q);
        double *to = &row[thud_history_link_force(h, i)];
        row[thud_history_link_stroke(h, i)] = d;
        *to = p->contact >= 0 ? p->sign * force[p->contact]
                              : p->stiffness_npm * d + p->damping_nspm * thud_model_link(m, i, qd);
        if (p->storey >= 0)
            *to += force[m->ncontacts + p->storey];
    }
}

/* A row at s of the present segment. */
static enum thud_status row_at(struct thud_history_rows *rows, const struct thud_observation *o, double s,
                               struct thud_error *err)
{
    const struct thud_model *m = o->state->model;
    const struct thud_segment *seg = o->seg;
    struct thud_history *h = &rows->history;
    double *row = new_row(h, seg->start_s + s * seg->h_s, err);
    if (!row)
        return THUD_MEMORY;
    double *q = rows->work, *qd = q + m->nmodes, *a = qd + m->nmodes, *force = a + m->nmodes;
    thud_observation_state(o, s, q, qd);
    fill_motion(h, o->state, row, q, qd);
    fill_storeys(h, o->state, row, q);
    if (rows->look_s > 0)
        for (int e = 0; e < THUD_HISTORY_ENERGIES; e++)
            row[thud_history_energy(h, e)] = NAN;
    else
        fill_works(h, rows->ledger, o, s, q, qd, row);
    row[thud_history_ground(h, 0)] = thud_observation_ground(o, s);
    thud_observation_forces(o, s, force);
    for (int c = 0; c < m->npairs; c++)
        row[thud_history_force(h, c)] = force[c];
    fill_columns(h, m, force, row);
    fill_links(h, m, force, q, qd, row);
    thud_observation_acceleration(o, s, q, qd, force, a);
    for (int i = 0; i < m->ndof; i++)
        row[thud_history_acceleration(h, i)] = thud_model_floor(m, i, a);
    return THUD_OK;
}

/* Parts of a segment in contact for which the trapezoids of its rows give the force's impulse to 3e-4: their error is
 * at most h^2/12 times the bound of the second derivative. */
static double impulse_parts(const struct thud_segment *seg, int nrows, int c, double s)
{
    double bend = 0, impulse = 0, power = s;
    for (int k = 0; k < seg->terms; k++) {
        double f = seg->force[k * nrows + c];
        bend += k * (k - 1) * fabs(f) * power;
        impulse += f * power / (k + 1);
        power *= s;
    }
    return impulse > 0 ? sqrt(bend / (12 * 3e-4 * impulse)) : 0;
}

/* Parts that a segment in contact is shown in: close enough for a smooth curve of an impact of 25 ms, and for the
 * impulse of the shortest. */
static int contact_rows(const struct thud_history_rows *rows, const struct thud_observation *o)
{
    enum { LEAST = 2, MOST = 200 };
    if (o->seg->end) /* not located: the ends are all that the step knows */
        return 1;
    const double close_s = 2.5e-4;
    if (rows->look_s > 0)
        return (int)fmax(1, fmin(MOST, ceil(o->s * o->seg->h_s / rows->look_s)));
    double parts = o->s * o->seg->h_s / fmin(rows->step_s, close_s);
    for (int c = 0; c < o->state->model->ncontacts; c++)
        if (thud_contact_acts(&o->state->contact[c]))
            parts = fmax(parts, impulse_parts(o->seg, o->state->model->nrows, c, o->s));
    return parts > LEAST ? parts < MOST ? (int)ceil(parts) : MOST : LEAST;
}

/* The time of the row after one at t: after a contact closer for a while, since impacts wake the higher modes; else on
 * the grid of the step. */
static double next_row(const struct thud_history_rows *rows, double t)
{
    const double close_s = 2.5e-3;
    double step = t < rows->rest_from_s ? rows->step_s : rows->rest_step_s;
    if (t < rows->close_rows_until_s && step > close_s)
        return t + close_s;
    return step * floor(t / step + 1.0 + THUD_TOL_ROW);
}

static double sooner(double best, struct thud_peak peak, double after)
{
    return peak.value > 0 && peak.time_s > after && peak.time_s < best ? peak.time_s : best;
}

/* The first time after `after` at which the result has a peak so far, or a contact parts in the segment, INFINITY where
 * there is none: a row stands there, so that the largest value of a column is the peak, and forces end where they do. */
static double next_peak(const struct thud_history_rows *rows, const struct thud_observation *o, double after)
{
    const struct thud_result *r = rows->result;
    double best = INFINITY;
    for (int s = 0; s < r->nstructures; s++)
        for (int i = 0; i < r->structure[s].floors + (r->structure[s].foundation ? 2 : 0); i++) {
            const struct thud_floor_result *f = &r->structure[s].floor[i];
            best = sooner(best, f->acceleration, after);
            best = sooner(best, f->displacement, after);
            best = sooner(best, f->velocity, after);
            best = sooner(best, f->drift, after);
        }
    for (int c = 0; c < r->ncontacts; c++) {
        best = sooner(best, r->contact[c].force, after);
        best = sooner(best, r->contact[c].indentation, after);
        best = sooner(best, (struct thud_peak){1, o->seg->start_s + o->seg->notes->begun[c] * o->seg->h_s}, after);
        best =
            sooner(best, (struct thud_peak){1, o->seg->start_s + thud_segment_ended(o->seg, c) * o->seg->h_s}, after);
    }
    for (int i = 0; i < r->nlinks; i++) {
        best = sooner(best, r->link[i].force, after);
        best = sooner(best, r->link[i].stroke, after);
    }
    for (int i = 0; i < r->ncolumns; i++)
        for (int q = 0; q < SHEARS; q++)
            best = sooner(best, r->column[i].peak[q], after);
    return best;
}

static double last_time(const struct thud_history_rows *rows)
{
    const struct thud_history *h = &rows->history;
    return h->rows ? h->time_s[h->rows - 1] : -INFINITY;
}

/* Rows of the peaks before t, from where the last row stands. */
static enum thud_status peak_rows(struct thud_history_rows *rows, const struct thud_observation *o, double t0, double t,
                                  struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    double fuzz = THUD_TOL_ROW * rows->step_s, at = next_peak(rows, o, fmax(t0, last_time(rows)));
    while (at < t - fuzz && status == THUD_OK) {
        status = row_at(rows, o, (at - t0) / o->seg->h_s, err);
        at = next_peak(rows, o, at);
    }
    return status;
}

/* Rows of a segment in contact, also at both its ends. */
static enum thud_status rows_in_contact(struct thud_history_rows *rows, const struct thud_observation *o, bool switched,
                                        struct thud_error *err)
{
    const double while_s = 0.4;
    double t0 = o->seg->start_s, h = o->seg->h_s, s = o->s;
    int count = contact_rows(rows, o);
    /* the force of a located contact goes on from the last segment's end unless something has switched there */
    bool look = rows->look_s > 0 && !o->seg->end;
    bool goes_on = !o->seg->interpolates && !switched && (look || last_time(rows) >= t0);
    enum thud_status status = THUD_OK;
    for (int i = goes_on; i <= count && status == THUD_OK; i++) {
        double at = t0 + s * h * i / count;
        bool soon = look && !switched && !o->switches && at - last_time(rows) < rows->look_s;
        status = peak_rows(rows, o, t0, at, err);
        if (status == THUD_OK && !soon)
            status = row_at(rows, o, s * i / count, err);
    }
    rows->close_rows_until_s = t0 + s * h + while_s;
    while (rows->next_row_s <= t0 + s * h)
        rows->next_row_s = next_row(rows, rows->next_row_s);
    return status;
}

/* Whether the ground jumps to rest at t: behind a last sample that is not 0. */
static bool is_stop(const struct thud_record *r, double t)
{
    return r && r->a_mps2[r->samples - 1] != 0 && fabs(t - (double)(r->samples - 1) * r->dt_s) < 1e-9 * r->dt_s;
}

/* Rows of a segment without contact: on the grid, and at its end where something may switch there. */
static enum thud_status rows_between_contacts(struct thud_history_rows *rows, const struct thud_observation *o,
                                              struct thud_error *err)
{
    double t0 = o->seg->start_s, h = o->seg->h_s, s = o->s, fuzz = THUD_TOL_ROW * rows->step_s;
    enum thud_status status = THUD_OK;
    while (rows->next_row_s <= t0 + s * h + fuzz && status == THUD_OK) {
        double at = (rows->next_row_s - t0) / h;
        status = peak_rows(rows, o, t0, rows->next_row_s, err);
        if (status == THUD_OK)
            status = row_at(rows, o, at < 0 ? 0 : at > s ? s : at, err);
        rows->next_row_s = next_row(rows, rows->next_row_s);
    }
    if (status == THUD_OK)
        status = peak_rows(rows, o, t0, t0 + s * h, err);
    bool stops = is_stop(o->state->record, t0 + s * h);
    if (status == THUD_OK && (o->switches || stops) && last_time(rows) < t0 + s * h - 1e-3 * fuzz) {
        status = row_at(rows, o, s, err);
        bool peak = o->seg->end && next_peak(rows, o, t0) < INFINITY; /* not located: peaks stand at ends */
        rows->row_waits = !stops && !peak;
    }
    return status;
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    struct thud_history_rows *rows = own;
    const bool switched_here = rows->switched;
    rows->switched = false;
    if (rows->row_waits && !switched_here) /* nothing has switched there: a row like any other of a step */
        rows->history.rows--;
    rows->row_waits = false;
    if (switched_here || is_stop(o->state->record, o->seg->start_s)) /* the other side of the jump */
        rows->next_row_s = o->seg->start_s;
    return o->state->nactive > 0 ? rows_in_contact(rows, o, switched_here, err) : rows_between_contacts(rows, o, err);
}

static enum thud_status block(void *own, const struct thud_state *state, struct thud_free_vibration *f, int intervals,
                              struct thud_error *err)
{
    struct thud_history_rows *rows = own;
    const struct thud_ledger *of_run = rows->ledger;
    struct thud_ledger ledger = *of_run; /* goes on with the rows; that of the run by the whole block */
    enum thud_status status = THUD_OK;
    rows->ledger = &ledger;
    for (int t = 0; t < intervals; t++)
        for (int piece = 0; piece < f->pieces && status == THUD_OK; piece++) {
            struct thud_observation o = {.state = state, .s = 1};
            o.seg = thud_free_vibration_all_series(f, state, t, piece);
            status = segment(rows, &o, err);
            if (rows->look_s > 0)
                continue;
            o.q = rows->work;
            o.qd = rows->work + state->model->nmodes;
            thud_segment_state(o.seg, state->model->nmodes, 1, rows->work, rows->work + state->model->nmodes);
            thud_ledger_add(&ledger, &o);
        }
    rows->ledger = of_run;
    return status;
}

static void switched(void *own, const struct thud_state *state, int row, enum thud_event event)
{
    struct thud_history_rows *rows = own;
    (void)state, (void)row, (void)event;
    rows->switched = true;
}

const struct thud_observer thud_observe_history = {.segment = segment, .block = block, .switched = switched};
