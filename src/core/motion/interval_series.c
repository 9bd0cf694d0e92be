#include "core/motion/interval_series.h"

#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "core/numerics/tolerance.h"
#include "core/numerics/vec.h"

/* With branches F_c = f0_c + k_c (g_c . q - clearance_c) + c_c g_c . q' the coefficients of the series are a linear
 * function of the inputs
 *
 *     x = (q, q', a_0, a_1, f0_c - k_c clearance_c of each row)
 *
 * and a table has the coefficients for each input of 1: of the modes, as they stand in the segment, and of g_c . q of each
 * row. Rows whose force is constant have k = c = 0.
 *
 * Glossary
 *
 *     set       the rows that have a force, with k and c of each: what a table is for
 *     uses      intervals of the set so far; after two for each input its table is made, which takes a series for each
 *     size      doubles of one input's coefficients, an even number
 *
 * Not for rounding: sums of unit motions agree with the recurrence to some 1e-16 of the largest. */
enum { SETS = 4, ROWS = 4, MODES_MOST = 40, AT_ONCE = 4 };

struct set {
    int rows, row[ROWS], terms;
    double k[ROWS], c[ROWS];
    int uses;
    bool made, fits; /* the series of an interval ends within its terms */
    double *table;   /* (inputs x size) */
};

struct thud_interval_series {
    const struct thud_model *model;
    struct set set[SETS];
    double *input, *sum;      /* (inputs) and (size) workspace */
    struct thud_segment unit; /* that of a unit motion, and the state that it is made of */
    double *q;                /* (2 x nmodes) */
    struct thud_contact_state *contact;
    struct thud_storey_state *storey;
    void *memory;
};

static int inputs_of(const struct thud_model *m, int rows)
{
    return 2 * m->nmodes + 2 + rows;
}

static int size_of(const struct thud_model *m, int terms, int rows)
{
    const int size = terms * (m->nmodes + rows);
    return size + size % 2;
}

enum thud_status thud_interval_series_create(const struct thud_model *m, struct thud_interval_series **out,
                                             struct thud_error *err)
{
    *out = NULL;
    if (!m->couples || m->nmodes > MODES_MOST || m->nrows == 0)
        return THUD_OK;
    struct thud_interval_series *x = *out = calloc(1, sizeof *x);
    const size_t inputs = (size_t)inputs_of(m, ROWS), size = (size_t)size_of(m, THUD_SEGMENT_TERMS, ROWS),
                 n = (size_t)m->nmodes, nc = (size_t)m->ncontacts, ns = (size_t)m->nstoreys;
    struct thud_arena arena;
    if (!x || thud_segment_init(&x->unit, m, err) != THUD_OK ||
        !thud_arena_open(&arena, thud_arena_room((SETS * inputs + 1) * size, sizeof(double)) +
                                     thud_arena_room(inputs + 2 * n, sizeof(double)) +
                                     thud_arena_room(nc, sizeof *x->contact) +
                                     thud_arena_room(ns, sizeof *x->storey))) {
        thud_interval_series_free(x);
        *out = NULL;
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    x->model = m;
    x->memory = arena.next;
    x->sum = thud_arena_take(&arena, (SETS * inputs + 1) * size, sizeof *x->sum);
    for (size_t i = 0; i < SETS; i++)
        x->set[i].table = x->sum + (i * inputs + 1) * size;
    x->input = thud_arena_take(&arena, inputs + 2 * n, sizeof *x->input);
    x->q = x->input + inputs;
    x->contact = thud_arena_take(&arena, nc, sizeof *x->contact);
    x->storey = thud_arena_take(&arena, ns, sizeof *x->storey);
    return THUD_OK;
}

void thud_interval_series_free(struct thud_interval_series *x)
{
    if (!x)
        return;
    thud_segment_clear(&x->unit);
    free(x->memory);
    free(x);
}

static bool is_set(const struct set *set, const struct thud_state *state, const struct thud_segment *seg)
{
    bool same = set->rows == seg->rows && set->terms == seg->terms;
    for (int i = 0; i < seg->rows && same; i++) {
        const struct thud_branch *branch = thud_row_branch(state, seg->row[i]);
        same = set->row[i] == seg->row[i] && set->k[i] == branch->k_npm && set->c[i] == branch->c_nspm;
    }
    return same;
}

/* The set of the segment, one more use of it. */
static struct set *find(struct thud_interval_series *x, const struct thud_state *state, const struct thud_segment *seg)
{
    for (int i = 0; i < SETS; i++)
        if (is_set(&x->set[i], state, seg)) {
            x->set[i].uses++;
            return &x->set[i];
        }
    struct set *set = &x->set[0]; /* the least used one gives way */
    for (int i = 1; i < SETS; i++)
        if (x->set[i].uses < set->uses)
            set = &x->set[i];
    *set = (struct set){.rows = seg->rows, .terms = seg->terms, .uses = 1, .table = set->table};
    for (int i = 0; i < seg->rows; i++) {
        set->row[i] = seg->row[i];
        set->k[i] = thud_row_branch(state, seg->row[i])->k_npm;
        set->c[i] = thud_row_branch(state, seg->row[i])->c_nspm;
    }
    return set;
}

static struct thud_branch *branch_of(struct thud_interval_series *x, int row)
{
    const int contacts = x->model->ncontacts;
    return row < contacts ? &x->contact[row].branch : &x->storey[row - contacts].branch;
}

/* The coefficients for an input of 1; whether its series ends. */
static bool unit_motion(struct thud_interval_series *x, const struct thud_state *state, const struct set *set,
                        double h_s, int input, double *out)
{
    const struct thud_model *m = x->model;
    const int n = m->nmodes;
    struct thud_state unit = *state;
    unit.q = x->q;
    unit.qd = x->q + n;
    unit.contact = x->contact;
    unit.storey = x->storey;
    memset(x->q, 0, 2 * (size_t)n * sizeof *x->q);
    if (input < 2 * n)
        x->q[input] = 1;
    for (int i = 0; i < set->rows; i++)
        branch_of(x, set->row[i])->f0_n =
            set->k[i] * thud_state_clearance(state, set->row[i]) + (input == 2 * n + 2 + i);
    thud_segment_begin(&unit, &x->unit, h_s);
    x->unit.a0 = input == 2 * n;
    x->unit.a1 = input == 2 * n + 1;
    const double tail = thud_taylor_linear(&unit, &x->unit);
    memcpy(out, x->unit.q, (size_t)set->terms * (size_t)n * sizeof *out);
    for (int i = 0; i < set->rows; i++)
        for (int k = 0; k < set->terms; k++)
            out[set->terms * (n + i) + k] = thud_model_gap_sum(m, set->row[i], x->unit.q + k * n);
    return tail <= THUD_TOL_SERIES_TAIL;
}

static void make_table(struct thud_interval_series *x, const struct thud_state *state, struct set *set, double h_s)
{
    const struct thud_model *m = x->model;
    memcpy(x->contact, state->contact, (size_t)m->ncontacts * sizeof *x->contact);
    memcpy(x->storey, state->storey, (size_t)m->nstoreys * sizeof *x->storey);
    set->made = set->fits = true;
    for (int i = 0; i < inputs_of(m, set->rows) && set->fits; i++)
        set->fits = unit_motion(x, state, set, h_s, i, set->table + i * size_of(m, set->terms, set->rows));
}

/* sum (+)= by[0] column + ... of so many inputs. */
static inline void add_inputs(const int count, const double *by, const double *restrict column, int size, bool first,
                              double *restrict sum)
{
    thud_vec2 x[AT_ONCE];
    for (int i = 0; i < count; i++)
        x[i] = thud_vec2_set(by[i], by[i]);
    for (int at = 0; at < size; at += 2) {
        thud_vec2 all = first ? thud_vec2_set(0, 0) : thud_vec2_at(sum + at);
        for (int i = 0; i < count; i++)
            all += x[i] * thud_vec2_at(column + i * size + at);
        thud_vec2_put(all, sum + at);
    }
}

/* x->sum of the inputs. */
static void superpose(struct thud_interval_series *x, const struct set *set)
{
    const int inputs = inputs_of(x->model, set->rows), size = size_of(x->model, set->terms, set->rows);
    int i = 0;
    for (; i + AT_ONCE <= inputs; i += AT_ONCE)
        add_inputs(AT_ONCE, x->input + i, set->table + i * size, size, i == 0, x->sum);
    for (; i < inputs; i++)
        add_inputs(1, x->input + i, set->table + i * size, size, i == 0, x->sum);
}

/* Indentation and force of the set's row i. */
static void read_row(const struct thud_interval_series *x, const struct thud_state *state, const struct set *set, int i,
                     struct thud_segment *seg)
{
    const int nrows = x->model->nrows, c = set->row[i], terms = set->terms;
    double *d = seg->notes->indentation + c * THUD_SEGMENT_TERMS, *force = seg->force + c;
    memcpy(d, x->sum + terms * (x->model->nmodes + i), (size_t)terms * sizeof *d);
    d[0] -= thud_state_clearance(state, c);
    for (int k = 0; k < terms; k++)
        force[k * nrows] = set->k[i] * d[k] + (k + 1 < terms ? set->c[i] * (k + 1) / seg->h_s * d[k + 1] : 0);
    force[0] += thud_row_branch(state, c)->f0_n;
    seg->notes->cached[c] = 0;
}

/* A whole interval, whose rows all follow a branch or are constant. A row of a contact that is open has none: what its
 * branch was is no part of the motion. */
static bool suits(const struct thud_state *state, const struct thud_segment *seg)
{
    if (thud_state_is_free(state) || state->offset_s != 0 || seg->h_s != state->grid_dt_s || seg->rows > ROWS)
        return false;
    for (int i = 0; i < seg->rows; i++)
        if ((thud_row_contact(state, seg->row[i]) && !thud_row_by_branch(state, seg->row[i])) ||
            thud_row_sticks(state, seg->row[i]) || thud_row_starts_at_zero(state, seg->row[i]))
            return false;
    return true;
}

bool thud_interval_series_make(struct thud_interval_series *x, const struct thud_state *state, struct thud_segment *seg)
{
    const int n = x->model->nmodes;
    if (!suits(state, seg))
        return false;
    struct set *set = find(x, state, seg);
    if (!set->made && set->uses > 2 * inputs_of(x->model, set->rows))
        make_table(x, state, set, seg->h_s);
    if (!set->fits)
        return false;
    memcpy(x->input, state->q, (size_t)n * sizeof *x->input);
    memcpy(x->input + n, state->qd, (size_t)n * sizeof *x->input);
    x->input[2 * n] = seg->a0;
    x->input[2 * n + 1] = seg->a1;
    for (int i = 0; i < set->rows; i++)
        x->input[2 * n + 2 + i] =
            thud_row_branch(state, set->row[i])->f0_n - set->k[i] * thud_state_clearance(state, set->row[i]);
    superpose(x, set);
    memcpy(seg->q, x->sum, (size_t)set->terms * (size_t)n * sizeof *seg->q);
    if (seg->terms == THUD_SEGMENT_TERMS && thud_segment_tail(seg, x->model) > THUD_TOL_SERIES_TAIL)
        return false;
    seg->loaded = seg->terms;
    for (int i = 0; i < set->rows; i++)
        read_row(x, state, set, i, seg);
    return true;
}
