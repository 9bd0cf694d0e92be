/* Which models a block of free vibration is for, its memory, and how long the next block is to be.
 *
 * A model has none where power series alone are as fast (very fast rates with coupled damping): its run takes series for
 * each interval. A block that a contact or a storey has cut short is followed by a short one, as another event is
 * likely soon; each that is not cut doubles the next, so that little is made in vain and long rests cost little. */
#include "core/motion/free_vibration_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/numerics/tolerance.h"

/* PIECES_MOST: of a block of more than one interval, so that a slice of work ends soon where modes are very fast. */
enum { SHORT_BLOCK = 16, PIECES_MOST = 16384, BOUNDS = THUD_FREE_VIBRATION_BOUNDS };

/* Interval times the fastest rate of damping that couples modes: above, power series alone are as fast. */
static const double coupled_most_rad = 1e3;

static bool allocate(struct thud_free_vibration *f, const struct thud_model *m)
{
    size_t n = (size_t)m->nmodes, floors = (size_t)m->ndof, ns = (size_t)m->nstructures,
           rows = (n + THUD_FREE_VIBRATION_BATCH - 1) / THUD_FREE_VIBRATION_BATCH * THUD_FREE_VIBRATION_BATCH,
           count = 0;
    double **by_mode[4 + 4 + 4 + THUD_FREE_VIBRATION_PRODUCTS + 4];
    double **by_end[] = {&f->q, &f->qd, &f->acceleration, &f->work[0], &f->work[1], &f->work[2], &f->moved},
           **single[] = {&f->gap, &f->ground, &f->after};
    size_t ends = m->couples ? 7 : 3, singles = sizeof single / sizeof *single;
    for (int i = 0; i < 4; i++) {
        by_mode[count++] = &f->tables.e[i];
        by_mode[count++] = &f->tables.p[i];
        by_mode[count++] = &f->tables.work[i];
    }
    for (int i = 0; i < THUD_FREE_VIBRATION_PRODUCTS; i++)
        by_mode[count++] = &f->tables.viscous[i];
    by_mode[count++] = &f->series.now; /* behind the tables */
    by_mode[count++] = &f->series.now_rate;
    by_mode[count++] = &f->speed;
    by_mode[count++] = &f->shift;
    double *next = f->block =
        calloc(count * rows + (ends * rows + THUD_FLOOR_QUANTITIES * floors + singles) * (size_t)ENDS +
                   THUD_FLOOR_QUANTITIES * ns + (size_t)m->ncontacts + BOUNDS * ns,
               sizeof *next);
    f->valued = calloc(THUD_FLOOR_QUANTITIES * ns + (size_t)m->ncontacts + 1, sizeof *f->valued);
    f->series.has = calloc(ns + 1, sizeof *f->series.has);
    f->coupled = calloc(ns + (size_t)m->nstoreys + 1, sizeof *f->coupled);
    if (!next || !f->valued || !f->series.has || !f->coupled)
        return false;
    for (size_t i = 0; i < count; i++, next += rows)
        *by_mode[i] = next;
    for (size_t i = 0; i < ends; i++, next += rows * (size_t)ENDS)
        *by_end[i] = next;
    for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++, next += floors * (size_t)ENDS)
        f->value[x] = next;
    for (size_t i = 0; i < singles; i++, next += ENDS)
        *single[i] = next;
    f->margin = next;
    f->limit = f->margin + THUD_FLOOR_QUANTITIES * ns;
    f->bound = f->limit + m->ncontacts;
    f->near = f->valued + THUD_FLOOR_QUANTITIES * ns;
    return true;
}

static bool suits(const struct thud_state *state)
{
    const struct thud_model *m = state->model;
    return m->nmodes > 0 && !(m->couples && state->fastest_radps * state->grid_dt_s > coupled_most_rad);
}

enum thud_status thud_free_vibration_create(const struct thud_state *state, const struct thud_free_vibration *like,
                                            struct thud_free_vibration **out, struct thud_error *err)
{
    const struct thud_model *m = state->model;
    *out = NULL;
    if (!suits(state))
        return THUD_OK;
    struct thud_free_vibration *f = calloc(1, sizeof *f);
    enum thud_status status = f && allocate(f, m) ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status == THUD_OK)
        status = thud_segment_init(&f->series.seg, m, err);
    if (status == THUD_OK) {
        f->model = m;
        f->n = m->nmodes;
        f->dt_s = state->grid_dt_s;
        f->pieces = 1 + (int)(state->fastest_radps * f->dt_s / THUD_SEGMENT_ANGLE);
        f->size = THUD_FREE_VIBRATION_BLOCK;
        f->nsystems = m->nsystems;
        if (!like || !thud_free_vibration_copy_tables(f, like))
            status = thud_free_vibration_make_tables(state, f, err);
    }
    if (status != THUD_OK) {
        thud_free_vibration_free(f);
        return status;
    }
    *out = f;
    return THUD_OK;
}

void thud_free_vibration_free(struct thud_free_vibration *f)
{
    if (!f)
        return;
    thud_segment_clear(&f->series.seg);
    for (int i = 0; f->coupled && f->model && i < f->nsystems + f->model->nstoreys; i++)
        thud_coupled_motion_clear(&f->coupled[i]);
    free(f->coupled);
    free(f->valued);
    free(f->series.has);
    free(f->block);
    free(f);
}

void thud_free_vibration_end(const struct thud_free_vibration *f, int intervals, double *q, double *qd)
{
    for (int j = 0; j < f->n; j++) {
        q[j] = f->q[j * ENDS + intervals];
        qd[j] = f->qd[j * ENDS + intervals];
    }
}

/* Intervals to try: to the end of the run and of the aligned block at most. */
static int intervals_left(struct thud_free_vibration *f, const struct thud_state *state)
{
    long left = (long)floor(state->end_s / f->dt_s * (1 + THUD_TOL_TIME)) - state->grid,
         aligned = THUD_FREE_VIBRATION_BLOCK - state->grid % THUD_FREE_VIBRATION_BLOCK;
    if (state->offset_s != 0 || left <= 0 || state->nyielding > 1)
        return 0;
    for (int c = 0; c < state->model->ncontacts; c++)
        if (state->contact[c].mode != THUD_OPEN)
            return 0;
    f->yields = -1;
    for (int k = 0; k < state->model->nstoreys; k++)
        f->yields = state->storey[k].direction != 0 ? k : f->yields;
    if (f->yields >= 0 && (f->coupled[f->nsystems + f->yields].size == 0 || state->storey[f->yields].suppressed > 0))
        return 0;
    left = left < aligned ? left : aligned;
    if (left * f->pieces > PIECES_MOST)
        left = f->pieces < PIECES_MOST ? PIECES_MOST / f->pieces : 1;
    return (f->yields >= 0 && f->size > 0) || left < f->size ? (int)left : f->size;
}

int thud_free_vibration_advance(struct thud_free_vibration *f, const struct thud_state *state)
{
    int tried = intervals_left(f, state);
    f->size = f->size > 0 ? f->size : SHORT_BLOCK;
    if (tried == 0)
        return 0;
    tried = thud_free_vibration_fill(f, state, tried);
    f->certain = -1;
    int intervals = thud_free_vibration_until_yield(f, state, thud_free_vibration_until_contact(f, state, tried));
    intervals = thud_free_vibration_until_collapse(f, state, intervals);
    f->size = intervals < tried                         ? (intervals > 0 && f->certain == intervals ? 0 : SHORT_BLOCK)
              : 2 * f->size < THUD_FREE_VIBRATION_BLOCK ? 2 * f->size
                                                        : THUD_FREE_VIBRATION_BLOCK;
    f->ends = intervals + 1; /* nothing behind an event is read */
    for (int s = 0; s < f->nsystems; s++)
        if (f->coupled[s].size > 0)
            thud_coupled_motion_sum(thud_free_vibration_motion(f, s), f->moved, f->qd, f->ground, f->after, intervals);
    return intervals;
}
