#include "core/early_end.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STRIDE = 128, ENDS = THUD_FREE_VIBRATION_ENDS };
_Static_assert((int)STRIDE <= (int)THUD_FREE_VIBRATION_BLOCK, "a flight fills whole blocks");

struct thud_early_end {
    int n, floors, nc, row; /* modes, floors, contacts, doubles of one block: 2 n + 4 floors + nc */
    double *block; /* (capacity x row): q, q' at its start; what its floors' values do not pass; largest closings */
    long count, capacity;
    double *end;         /* (2 n) q, q' at the end of the last block */
    bool closed, failed; /* blocks are STRIDE intervals each, but for the last */
    long end_grid;
};

struct thud_early_end *thud_early_end_create(const struct thud_model *model)
{
    struct thud_early_end *h = calloc(1, sizeof *h);
    if (!h)
        return NULL;
    h->n = model->nmodes;
    h->floors = model->ndof;
    h->nc = model->ncontacts;
    h->row = 2 * h->n + THUD_FLOOR_QUANTITIES * h->floors + h->nc;
    h->end = calloc(2 * (size_t)h->n + 1, sizeof *h->end);
    for (int j = 0; j < h->n; j++)
        h->failed = h->failed || !(model->omega[j] > 0); /* a free body's difference does not decay */
    if (!h->end) {
        free(h);
        return NULL;
    }
    return h;
}

void thud_early_end_free(struct thud_early_end *early_end)
{
    if (!early_end)
        return;
    free(early_end->block);
    free(early_end->end);
    free(early_end);
}

static double *new_block(struct thud_early_end *h)
{
    if (h->count == h->capacity) {
        long more = h->capacity ? 2 * h->capacity : 64;
        double *p = realloc(h->block, (size_t)more * (size_t)h->row * sizeof *p);
        if (!p)
            return NULL;
        h->block = p;
        h->capacity = more;
    }
    return h->block + h->count++ * h->row;
}

static double largest(const double *x, int n)
{
    double most = 0;
    for (int t = 0; t < n; t++) {
        double a = fabs(x[t]);
        most = a > most ? a : most;
    }
    return most;
}

void thud_early_end_record(struct thud_early_end *h, const struct thud_run *run, struct thud_free_vibration *f,
                           int intervals)
{
    const struct thud_model *m = run->state.model;
    if (h->failed || run->state.grid != h->count * STRIDE)
        h->failed = true;
    double *block = h->failed ? NULL : new_block(h);
    if (!block) {
        h->failed = true;
        return;
    }
    for (int j = 0; j < h->n; j++) {
        block[j] = f->q[j * ENDS];
        block[h->n + j] = f->qd[j * ENDS];
        h->end[j] = f->q[j * ENDS + intervals];
        h->end[h->n + j] = f->qd[j * ENDS + intervals];
    }
    double *value = block + 2 * h->n, *closing = value + THUD_FLOOR_QUANTITIES * h->floors;
    for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++)
        for (int i = 0; i < h->floors; i++)
            value[x * h->floors + i] =
                largest(f->value[x] + i * ENDS, intervals + 1) + f->margin[x * m->nstructures + m->dof_structure[i]];
    for (int c = 0; c < h->nc; c++) {
        double margin, most = thud_free_vibration_gap(f, m, c, intervals + 1, &margin);
        closing[c] = most + margin;
    }
    h->end_grid = run->state.grid + intervals;
}

/* From each block on: the largest of it and all that follow. */
void thud_early_end_close(struct thud_early_end *h)
{
    for (long b = h->count - 2; b >= 0; b--) {
        double *block = h->block + b * h->row + 2 * h->n, *next = block + h->row;
        for (int i = 0; i < THUD_FLOOR_QUANTITIES * h->floors + h->nc; i++)
            block[i] = fmax(block[i], next[i]);
    }
    h->closed = !h->failed && h->count > 0;
}

int thud_early_end_stride(long grid)
{
    return (int)(STRIDE - grid % STRIDE);
}

/* Largest |x| that a mode's free vibration from (q, q') comes to: its envelope at the start. */
static double amplitude(const struct thud_model *m, int j, double q, double qd)
{
    double damped = m->omega[j] * sqrt(1 - m->zeta[j] * m->zeta[j]);
    double v = (qd + m->zeta[j] * m->omega[j] * q) / damped;
    return sqrt(q * q + v * v);
}

/* Whether one floor keeps below its peaks: `later` of the motion without contact, plus what the difference may add. */
static bool floor_is_done(struct thud_run *run, const double *later, const double *amplitudes, int s, int floor)
{
    const struct thud_model *m = run->state.model;
    const struct thud_model_structure *p = &m->structure[s];
    const double *row = p->phi + floor * p->modes, *below = floor > 0 ? row - p->modes : NULL;
    double add[THUD_FLOOR_QUANTITIES] = {0};
    for (int j = 0; j < p->modes; j++) {
        double w = m->omega[p->first_mode + j], a = amplitudes[p->first_mode + j], part = fabs(row[j]) * a;
        add[THUD_FLOOR_DISPLACEMENT] += part;
        add[THUD_FLOOR_VELOCITY] += part * w;
        add[THUD_FLOOR_ACCELERATION] += part * w * w * (1 + 2 * m->zeta[p->first_mode + j]);
        add[THUD_FLOOR_DRIFT] += fabs(row[j] - (below ? below[j] : 0)) * a;
    }
    for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++)
        if (later[x * m->ndof + p->first + floor] + add[x] > thud_floor_peak(&run->result, s, floor, x)->value)
            return false;
    return true;
}

static bool nothing_comes(struct thud_run *run, const double *later, const double *closing, const double *amplitudes)
{
    const struct thud_model *m = run->state.model;
    for (int c = 0; c < m->ncontacts; c++) {
        const double *g = m->jacobian + c * m->nmodes;
        double add = 0;
        if (m->contact[c].law->flags & THUD_LAW_NO_FORCE)
            continue;
        for (int j = 0; j < m->nmodes; j++)
            add += fabs(g[j]) * amplitudes[j];
        if (closing[c] + add >= thud_state_clearance(&run->state, c))
            return false;
    }
    for (int s = 0; s < m->nstructures; s++)
        for (int i = 0; i < m->structure[s].n; i++)
            if (!floor_is_done(run, later, amplitudes, s, i))
                return false;
    return true;
}

/* Free vibration of the difference over `time`, added to the motion without contact. */
static void put_at_end(const struct thud_early_end *h, struct thud_run *run, const double *start, double time)
{
    const struct thud_model *m = run->state.model;
    for (int j = 0; j < h->n; j++) {
        double dq = run->state.q[j] - start[j], dv = run->state.qd[j] - start[h->n + j];
        double zw = m->zeta[j] * m->omega[j], w = m->omega[j] * sqrt(1 - m->zeta[j] * m->zeta[j]);
        double fade = exp(-zw * time), c = cos(w * time), s = sin(w * time);
        run->state.q[j] = h->end[j] + fade * (dq * c + (dv + zw * dq) / w * s);
        run->state.qd[j] = h->end[h->n + j] + fade * (dv * c - (zw * dv + m->omega[j] * m->omega[j] * dq) / w * s);
    }
}

long thud_early_end_jump(const struct thud_early_end *h, struct thud_run *run)
{
    long grid = run->state.grid, b = grid / STRIDE;
    if (!h->closed || grid % STRIDE != 0 || b >= h->count || grid >= h->end_grid)
        return 0;
    const double *start = h->block + b * h->row, *later = start + 2 * h->n;
    double *amplitudes = run->seg.reach;
    for (int j = 0; j < h->n; j++)
        amplitudes[j] = amplitude(run->state.model, j, run->state.q[j] - start[j], run->state.qd[j] - start[h->n + j]);
    if (!nothing_comes(run, later, later + THUD_FLOOR_QUANTITIES * h->floors, amplitudes))
        return 0;
    thud_ledger_close(run);
    put_at_end(h, run, start, (double)(h->end_grid - grid) * run->state.grid_dt_s);
    run->state.grid = h->end_grid;
    return h->end_grid - grid;
}
