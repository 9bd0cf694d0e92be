/* Which models a block of free vibration is for, its memory, and how long the next block is to be.
 *
 * A model has none where power series alone are as fast (very fast rates with coupled damping): its run takes series for
 * each interval. A block that a contact or a storey has cut short is followed by a short one, as another event is
 * likely soon; each that is not cut doubles the next, so that little is made in vain and long rests cost little. */
#include "core/motion/free_vibration_parts.h"

#include <math.h>
#include <string.h>

#include "base/arena.h"
#include "core/numerics/tolerance.h"

/* PIECES_MOST: of a block of more than one interval, so that a slice of work ends soon where modes are very fast. */
enum { SHORT_BLOCK = 16, PIECES_MOST = 16384, BATCH = THUD_FREE_VIBRATION_BATCH };

/* Interval times the fastest rate of damping that couples modes: above, power series alone are as fast. */
static const double coupled_most_rad = 1e3;

/* The tables stand one after the other behind the first. */
static void place_tables(struct thud_free_vibration_tables *to, size_t rows)
{
    double *next = to->e[0];
    for (int i = 0; i < 4; i++, next += 3 * rows) {
        to->e[i] = next;
        to->p[i] = next + rows;
        to->work[i] = next + 2 * rows;
    }
    for (int i = 0; i < THUD_FREE_VIBRATION_PRODUCTS; i++, next += rows)
        to->viscous[i] = next;
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
    const size_t ns = (size_t)m->nstructures, floors = (size_t)(m->ndof * ENDS),
                 rows = (size_t)((m->nmodes + BATCH - 1) / BATCH * BATCH), ends = rows * ENDS,
                 coupled = m->couples ? ends : 0;
    struct thud_free_vibration *f,
        to = {.model = m,
              .n = m->nmodes,
              .nsystems = m->nsystems,
              .dt_s = state->grid_dt_s,
              .size = THUD_FREE_VIBRATION_BLOCK,
              .pieces = 1 + (int)(state->fastest_radps * state->grid_dt_s / THUD_SEGMENT_ANGLE)};
    enum thud_status status = THUD_LAY_IN(
        state->memory, err, THUD_PIECE(f, 1), THUD_PIECE(to.tables.e[0], (3 * 4 + THUD_FREE_VIBRATION_PRODUCTS) * rows),
        THUD_PIECE(to.series.now, rows), THUD_PIECE(to.series.now_rate, rows), THUD_PIECE(to.speed, rows),
        THUD_PIECE(to.shift, rows), THUD_PIECE(to.q, ends), THUD_PIECE(to.qd, ends), THUD_PIECE(to.acceleration, ends),
        THUD_PIECE(to.work[0], coupled), THUD_PIECE(to.work[1], coupled), THUD_PIECE(to.work[2], coupled),
        THUD_PIECE(to.moved, coupled), THUD_PIECE(to.value[0], floors), THUD_PIECE(to.value[1], floors),
        THUD_PIECE(to.value[2], floors), THUD_PIECE(to.value[3], floors), THUD_PIECE(to.gap, ENDS),
        THUD_PIECE(to.ground, ENDS), THUD_PIECE(to.after, ENDS), THUD_PIECE(to.margin, THUD_FLOOR_QUANTITIES * ns),
        THUD_PIECE(to.limit, m->ncontacts), THUD_PIECE(to.bound, THUD_FREE_VIBRATION_BOUNDS * ns),
        THUD_PIECE(to.valued, THUD_FLOOR_QUANTITIES * ns), THUD_PIECE(to.near, m->ncontacts),
        THUD_PIECE(to.series.has, ns), THUD_PIECE(to.coupled, m->nsystems + m->nstoreys));
    if (status != THUD_OK)
        return status;
    *out = f;
    place_tables(&to.tables, rows);
    *f = to;
    status = thud_segment_init(&f->series.seg, state, err);
    if (status == THUD_OK && (!like || !thud_free_vibration_copy_tables(f, like)))
        status = thud_free_vibration_make_tables(state, f, err);
    return status;
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
