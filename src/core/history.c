/* Histories: rows of a run at chosen moments. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/poly.h"
#include "core/run_private.h"
#include "core/tolerance.h"

int thud_history_ground(void)
{
    return 0;
}
int thud_history_displacement(const struct thud_history *h, int dof)
{
    (void)h;
    return 1 + dof;
}
int thud_history_velocity(const struct thud_history *h, int dof)
{
    return 1 + h->ndof + dof;
}
int thud_history_acceleration(const struct thud_history *h, int dof)
{
    return 1 + 2 * h->ndof + dof;
}
int thud_history_force(const struct thud_history *h, int contact)
{
    return 1 + 3 * h->ndof + contact;
}
int thud_history_indentation(const struct thud_history *h, int contact)
{
    return 1 + 3 * h->ndof + h->ncontacts + contact;
}
int thud_history_energy(const struct thud_history *h, int which)
{
    return 1 + 3 * h->ndof + 2 * h->ncontacts + which;
}

enum thud_status thud_history_start(struct thud_run *run, struct thud_error *err)
{
    struct thud_history *h = &run->history;
    h->ndof = run->state.model->ndof;
    h->ncontacts = run->state.model->ncontacts;
    h->columns = 1 + 3 * h->ndof + 2 * h->ncontacts + THUD_HISTORY_ENERGIES;
    run->next_row_s = 0;
    (void)err;
    return THUD_OK;
}

static double *new_row(struct thud_run *run, double time, struct thud_error *err)
{
    struct thud_history *h = &run->history;
    if (h->rows == h->capacity) {
        size_t more = h->capacity ? 2 * h->capacity : 1024;
        double *t = realloc(h->time_s, more * sizeof *t);
        if (t)
            h->time_s = t;
        double *v = t ? realloc(h->value, more * (size_t)h->columns * sizeof *v) : NULL;
        if (!v) {
            thud_error_set(err, THUD_MEMORY, "out of memory for the histories");
            return NULL;
        }
        h->value = v;
        h->capacity = more;
    }
    /* never before the row above, and the two sides of a jump at one time, not but for the last bits either: readers of
     * histories rely on it */
    double above = h->rows ? h->time_s[h->rows - 1] : -INFINITY;
    h->time_s[h->rows] = time - above <= 4 * DBL_EPSILON * fabs(time) ? above : time;
    return h->value + h->rows++ * (size_t)h->columns;
}

/* Row from modal values; accelerations and forces are filled by the caller. */
static void fill_motion(const struct thud_run *run, double *row, const double *q, const double *qd)
{
    const struct thud_history *h = &run->history;
    for (int i = 0; i < h->ndof; i++) {
        row[thud_history_displacement(h, i)] = thud_model_floor(run->state.model, i, q);
        row[thud_history_velocity(h, i)] = thud_model_floor(run->state.model, i, qd);
    }
    for (int c = 0; c < h->ncontacts; c++)
        row[thud_history_indentation(h, c)] =
            thud_model_gap_sum(run->state.model, c, q) - thud_state_clearance(&run->state, c);
}

static void fill_energy(const struct thud_run *run, const struct thud_ledger *ledger, double *row, const double *q,
                        const double *qd)
{
    const struct thud_history *h = &run->history;
    double kinetic = 0, strain = 0;
    for (int j = 0; j < run->state.model->nmodes; j++) {
        kinetic += 0.5 * qd[j] * qd[j];
        strain += 0.5 * run->state.model->omega[j] * run->state.model->omega[j] * q[j] * q[j];
    }
    double e[THUD_HISTORY_ENERGIES] = {ledger->input_j, kinetic, strain, ledger->viscous_j, ledger->contact_work_j};
    memcpy(row + thud_history_energy(h, 0), e, sizeof e);
}

/* Modal total accelerations at s, as in thud_peaks_prepare; the row has its forces and the ground. */
static void accelerations(const struct thud_run *run, double s, const double *row, const double *q, const double *qd,
                          double *out)
{
    const struct thud_model *m = run->state.model;
    const struct thud_segment *seg = &run->seg;
    if (run->method->order > 0) {
        thud_model_acceleration(m, q, qd, 0, out);
        thud_model_apply_contact_forces(m, row + thud_history_force(&run->history, 0), out);
        return;
    }
    for (int j = 0; j < m->nmodes; j++) {
        double sum = 0;
        for (int k = seg->terms - 3; k >= 0; k--)
            sum = sum * s + (k + 1) * (k + 2) * seg->q[(k + 2) * m->nmodes + j];
        out[j] = sum / (seg->h_s * seg->h_s) + m->gamma[j] * row[thud_history_ground()];
    }
}

/* A row at s of the present segment. */
static enum thud_status row_at(struct thud_run *run, double s, struct thud_error *err)
{
    const struct thud_model *m = run->state.model;
    const struct thud_segment *seg = &run->seg;
    const struct thud_history *h = &run->history;
    double *row = new_row(run, thud_state_now(&run->state) + s * seg->h_s, err);
    if (!row)
        return THUD_MEMORY;
    const struct thud_ledger ledger = thud_ledger_at(run, s); /* it uses the scratch too */
    double *q = run->scratch, *qd = q + m->nmodes, *a = qd + m->nmodes;
    thud_segment_state(seg, m->nmodes, s, q, qd);
    fill_motion(run, row, q, qd);
    fill_energy(run, &ledger, row, q, qd);
    row[0] = seg->a0 + seg->a1 * s;
    for (int c = 0; c < m->ncontacts; c++) {
        double f = 0;
        for (int k = seg->terms - 1; k >= 0; k--)
            f = f * s + seg->force[k * m->ncontacts + c];
        row[thud_history_force(h, c)] = f;
    }
    accelerations(run, s, row, q, qd, a);
    for (int i = 0; i < m->ndof; i++)
        row[thud_history_acceleration(h, i)] = thud_model_floor(m, i, a);
    return THUD_OK;
}

/* Parts of a segment in contact for which the trapezoids of its rows give the force's impulse to 3e-4: their error is
 * at most h^2/12 times the bound of the second derivative. */
static double impulse_parts(const struct thud_run *run, int c, double s)
{
    const struct thud_segment *seg = &run->seg;
    double bend = 0, impulse = 0, power = s;
    for (int k = 0; k < seg->terms; k++) {
        double f = seg->force[k * run->state.model->ncontacts + c];
        bend += k * (k - 1) * fabs(f) * power;
        impulse += f * power / (k + 1);
        power *= s;
    }
    return impulse > 0 ? sqrt(bend / (12 * 3e-4 * impulse)) : 0;
}

/* Parts that a segment in contact is shown in: close enough for a smooth curve of an impact of 25 ms, and for the
 * impulse of the shortest. */
static int contact_rows(const struct thud_run *run, double s)
{
    enum { LEAST = 2, MOST = 200 };
    const double close_s = 2.5e-4;
    double parts = s * run->seg.h_s / fmin(run->options.history_step_s, close_s);
    for (int c = 0; c < run->state.model->ncontacts; c++)
        if (thud_contact_acts(&run->state.contact[c]))
            parts = fmax(parts, impulse_parts(run, c, s));
    return parts > LEAST ? parts < MOST ? (int)ceil(parts) : MOST : LEAST;
}

/* The time of the row after one at t: after a contact closer for a while, since impacts wake the higher modes; else on
 * the grid of the step. */
static double next_row(const struct thud_run *run, double t)
{
    const double close_s = 2.5e-3;
    double step = run->options.history_step_s;
    if (t < run->close_rows_until_s && step > close_s)
        return t + close_s;
    return step * floor(t / step + 1.0 + THUD_TOL_ROW);
}

static double sooner(double best, struct thud_peak peak, double after)
{
    return peak.value > 0 && peak.time_s > after && peak.time_s < best ? peak.time_s : best;
}

/* The first time after `after` at which the result has a peak so far, INFINITY where there is none: a row stands there,
 * so that the largest value of a column is the peak. */
static double next_peak(const struct thud_run *run, double after)
{
    const struct thud_result *r = &run->result;
    double best = INFINITY;
    for (int s = 0; s < r->nstructures; s++)
        for (int i = 0; i < r->structure[s].floors; i++) {
            const struct thud_floor_result *f = &r->structure[s].floor[i];
            best = sooner(best, f->acceleration, after);
            best = sooner(best, f->displacement, after);
            best = sooner(best, f->velocity, after);
            best = sooner(best, f->drift, after);
        }
    for (int c = 0; c < r->ncontacts; c++) {
        best = sooner(best, r->contact[c].force, after);
        best = sooner(best, r->contact[c].indentation, after);
    }
    return best;
}

static double last_time(const struct thud_run *run)
{
    const struct thud_history *h = &run->history;
    return h->rows ? h->time_s[h->rows - 1] : -INFINITY;
}

/* Rows of the peaks before t, from where the last row stands. */
static enum thud_status peak_rows(struct thud_run *run, double t0, double t, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    double fuzz = THUD_TOL_ROW * run->options.history_step_s, at = next_peak(run, fmax(t0, last_time(run)));
    while (at < t - fuzz && status == THUD_OK) {
        status = row_at(run, (at - t0) / run->seg.h_s, err);
        at = next_peak(run, at);
    }
    return status;
}

/* Rows of a segment in contact, also at both its ends. */
static enum thud_status rows_in_contact(struct thud_run *run, double s, struct thud_error *err)
{
    const double while_s = 0.4;
    double t0 = thud_state_now(&run->state), h = run->seg.h_s;
    int rows = contact_rows(run, s);
    /* the force of a located contact goes on from the last segment's end unless something has switched there */
    bool goes_on = run->method->order == 0 && !run->switched && last_time(run) >= t0;
    enum thud_status status = THUD_OK;
    for (int i = goes_on; i <= rows && status == THUD_OK; i++) {
        status = peak_rows(run, t0, t0 + s * h * i / rows, err);
        if (status == THUD_OK)
            status = row_at(run, s * i / rows, err);
    }
    run->close_rows_until_s = t0 + s * h + while_s;
    while (run->next_row_s <= t0 + s * h)
        run->next_row_s = next_row(run, run->next_row_s);
    return status;
}

/* Whether the ground jumps to rest at t: behind a last sample that is not 0. */
static bool is_stop(const struct thud_run *run, double t)
{
    const struct thud_record *r = run->state.record;
    return r && r->a_mps2[r->samples - 1] != 0 && fabs(t - (double)(r->samples - 1) * r->dt_s) < 1e-9 * r->dt_s;
}

/* Rows of a segment without contact: on the grid, and at its end where something may switch there. */
static enum thud_status rows_in_flight(struct thud_run *run, double s, bool switches, struct thud_error *err)
{
    double t0 = thud_state_now(&run->state), h = run->seg.h_s, fuzz = THUD_TOL_ROW * run->options.history_step_s;
    enum thud_status status = THUD_OK;
    while (run->next_row_s <= t0 + s * h + fuzz && status == THUD_OK) {
        double at = (run->next_row_s - t0) / h;
        status = peak_rows(run, t0, run->next_row_s, err);
        if (status == THUD_OK)
            status = row_at(run, at < 0 ? 0 : at > s ? s : at, err);
        run->next_row_s = next_row(run, run->next_row_s);
    }
    if (status == THUD_OK)
        status = peak_rows(run, t0, t0 + s * h, err);
    bool stops = is_stop(run, t0 + s * h);
    if (status == THUD_OK && (switches || stops) && last_time(run) < t0 + s * h - 1e-3 * fuzz) {
        status = row_at(run, s, err);
        run->row_waits = !stops;
    }
    return status;
}

enum thud_status thud_history_segment(struct thud_run *run, double s, bool switches, struct thud_error *err)
{
    if (run->row_waits && !run->switched) /* nothing has switched there: a row like any other of a step */
        run->history.rows--;
    run->row_waits = false;
    if (run->switched || is_stop(run, thud_state_now(&run->state))) /* the other side of the jump */
        run->next_row_s = thud_state_now(&run->state);
    enum thud_status status =
        run->state.nactive > 0 ? rows_in_contact(run, s, err) : rows_in_flight(run, s, switches, err);
    run->switched = false;
    return status;
}
