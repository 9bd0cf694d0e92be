/* Histories and the list of impacts: the only arrays of a run that grow. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/poly.h"
#include "core/run_private.h"

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
    h->ndof = run->model->ndof;
    h->ncontacts = run->model->ncontacts;
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
    /* never before the row above, not by the last bit either: readers of histories rely on it */
    h->time_s[h->rows] = h->rows ? fmax(time, h->time_s[h->rows - 1]) : time;
    return h->value + h->rows++ * (size_t)h->columns;
}

/* Row from modal values; accelerations and forces are filled by the caller. */
static void fill_motion(const struct thud_run *run, double *row, const double *q, const double *qd)
{
    const struct thud_history *h = &run->history;
    for (int i = 0; i < h->ndof; i++) {
        row[thud_history_displacement(h, i)] = thud_model_floor(run->model, i, q);
        row[thud_history_velocity(h, i)] = thud_model_floor(run->model, i, qd);
    }
    for (int c = 0; c < h->ncontacts; c++)
        row[thud_history_indentation(h, c)] = thud_model_gap_sum(run->model, c, q) - thud_run_shift(run, c);
}

static void fill_energy(const struct thud_run *run, const struct thud_ledger *ledger, double *row, const double *q,
                        const double *qd)
{
    const struct thud_history *h = &run->history;
    double kinetic = 0, strain = 0;
    for (int j = 0; j < run->model->nmodes; j++) {
        kinetic += 0.5 * qd[j] * qd[j];
        strain += 0.5 * run->model->omega[j] * run->model->omega[j] * q[j] * q[j];
    }
    double e[THUD_HISTORY_ENERGIES] = {ledger->input_j, kinetic, strain, ledger->viscous_j, ledger->contact_work_j};
    memcpy(row + thud_history_energy(h, 0), e, sizeof e);
}

/* Modal total accelerations at s, as in thud_peaks_prepare; the row has its forces and the ground. */
static void accelerations(const struct thud_run *run, double s, const double *row, const double *q, const double *qd,
                          double *out)
{
    const struct thud_model *m = run->model;
    const struct thud_segment *seg = &run->seg;
    if (run->method->order > 0) {
        thud_model_acceleration(m, q, qd, 0, out);
        thud_model_push(m, row + thud_history_force(&run->history, 0), out);
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
    const struct thud_model *m = run->model;
    const struct thud_segment *seg = &run->seg;
    const struct thud_history *h = &run->history;
    double *row = new_row(run, thud_run_now(run) + s * seg->h_s, err);
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

/* Parts that a segment in contact is shown in: close enough for a smooth curve of an impact of 25 ms, and some also of
 * the shortest. */
static int contact_rows(double duration_s, double step_s)
{
    enum { LEAST = 6, MOST = 200 };
    const double close_s = 2.5e-4;
    double parts = ceil(duration_s / fmin(step_s, close_s));
    return parts > LEAST ? parts < MOST ? (int)parts : MOST : LEAST;
}

/* The time of the row after one at t: after a contact closer for a while, since impacts wake the higher modes; else on
 * the grid of the step. */
static double next_row(const struct thud_run *run, double t)
{
    const double close_s = 2.5e-3;
    double step = run->options.history_step_s;
    if (t < run->close_rows_until_s && step > close_s)
        return t + close_s;
    return step * floor(t / step + 1.0 + 1e-9);
}

enum thud_status thud_history_segment(struct thud_run *run, double s, struct thud_error *err)
{
    double t0 = thud_run_now(run), h = run->seg.h_s, step = run->options.history_step_s;
    enum thud_status status = THUD_OK;
    if (run->nactive > 0) {
        int rows = contact_rows(s * h, step);
        for (int i = 0; i <= rows && status == THUD_OK; i++)
            status = row_at(run, s * i / rows, err);
        const double while_s = 0.4;
        run->close_rows_until_s = t0 + s * h + while_s;
        while (run->next_row_s <= t0 + s * h)
            run->next_row_s = next_row(run, run->next_row_s);
        return status;
    }
    double fuzz = 1e-9 * step;
    while (run->next_row_s <= t0 + s * h + fuzz && status == THUD_OK) {
        double at = (run->next_row_s - t0) / h;
        status = row_at(run, at < 0 ? 0 : at > s ? s : at, err);
        run->next_row_s = next_row(run, run->next_row_s);
    }
    return status;
}

enum thud_status thud_impacts_add(struct thud_run *run, const struct thud_impact *impact, struct thud_error *err)
{
    if (!run->options.keep_impacts)
        return THUD_OK;
    if (run->nimpacts == run->impacts_capacity) {
        int more = run->impacts_capacity ? 2 * run->impacts_capacity : 256;
        struct thud_impact *p = realloc(run->impacts, (size_t)more * sizeof *p);
        if (!p)
            return thud_error_set(err, THUD_MEMORY, "out of memory for the list of impacts");
        run->impacts = p;
        run->impacts_capacity = more;
    }
    run->impacts[run->nimpacts++] = *impact;
    return THUD_OK;
}
