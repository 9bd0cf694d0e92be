#include "core/response.h"

#include <stdlib.h>
#include <string.h>

#include "core/segment.h"
#include "core/tolerance.h"

enum { LEVELS = 48, MOTION = 2 * THUD_POINTS }; /* MOTION: values and rates at the points */
enum { BY_PLACE, BY_RATE, BY_LOAD, BY_RISE, CAUSES };

struct level {
    double
        *free; /* (CAUSES x nmodes x MOTION): every mode by its place and rate at the start, by a load of 1 and by one
                     that rises to 1; NULL where modes are coupled */
    double *load;               /* (loads x THUD_NODES x nmodes x MOTION): under the load that is 1 at one node */
    struct thud_response *pair; /* (nrows x nrows) */
};

struct thud_responses {
    const struct thud_model *model;
    int loads; /* loads: 1 where modes are uncoupled, else one per contact */
    double h_top;
    double lagrange[THUD_NODES * THUD_NODES], point[THUD_POINTS];
    struct thud_nodes first, last; /* the points: a batch, and those behind it */
    struct level level[LEVELS];
    struct thud_segment seg; /* of unit loads */
    double *motion;          /* (nmodes x MOTION) from where they are, without contact forces */
    double *ramp_modes;      /* (THUD_SEGMENT_TERMS x nmodes): under a ground acceleration that rises by 1 in h_top, */
    double *ramp;            /* (nrows x THUD_SEGMENT_TERMS): and so each contact's indentation, made when needed */
    int *ramp_terms;         /* (nrows) 0 before that */
};

/* calloc of at least one element. */
static void *allocate(size_t count, size_t size)
{
    return calloc(count ? count : 1, size);
}

static struct thud_segment *unit_segment(struct thud_responses *x, double h)
{
    struct thud_segment *seg = &x->seg;
    /* a load's own power comes on top */
    seg->terms = thud_segment_terms(x->model->fastest_radps * h, THUD_TOL_SERIES) + THUD_NODES;
    seg->terms = seg->terms < THUD_SEGMENT_TERMS ? seg->terms : THUD_SEGMENT_TERMS;
    seg->h_s = h;
    seg->a0 = seg->a1 = 0;
    seg->loaded = 0;
    return seg;
}

enum thud_status thud_responses_create(const struct thud_model *m, const double *point, const double *lagrange,
                                       double h_top, struct thud_responses **out, struct thud_error *err)
{
    size_t n = (size_t)m->nmodes, nc = (size_t)m->nrows, terms = THUD_SEGMENT_TERMS;
    struct thud_responses *x = *out = allocate(1, sizeof *x);
    if (x) {
        *x = (struct thud_responses){.model = m, .loads = m->couples ? m->nrows : 1, .h_top = h_top};
        memcpy(x->lagrange, lagrange, sizeof x->lagrange);
        memcpy(x->point, point, sizeof x->point);
        x->motion = allocate(n * MOTION + terms * (n + nc), sizeof *x->motion);
        x->ramp_terms = allocate(nc, sizeof *x->ramp_terms);
    }
    if (!x || !x->motion || !x->ramp_terms || thud_segment_init(&x->seg, m, err) != THUD_OK) {
        thud_responses_free(x);
        *out = NULL;
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    thud_nodes_set(&x->first, THUD_BATCH, point, 1, THUD_SEGMENT_TERMS);
    thud_nodes_set(&x->last, THUD_POINTS - THUD_BATCH, point + THUD_BATCH, 1, THUD_SEGMENT_TERMS);
    x->ramp_modes = x->motion + n * MOTION;
    x->ramp = x->ramp_modes + terms * n;
    struct thud_segment *seg = unit_segment(x, h_top);
    for (size_t j = 0; j < n; j++)
        x->motion[j] = -m->gamma[j];
    thud_taylor_load(m, seg, x->motion, 1);
    memcpy(x->ramp_modes, seg->q, (size_t)seg->terms * n * sizeof *seg->q);
    return THUD_OK;
}

void thud_responses_free(struct thud_responses *x)
{
    if (!x)
        return;
    for (int l = 0; l < LEVELS; l++) {
        struct level *level = &x->level[l];
        for (int p = 0; level->pair && p < x->model->nrows * x->model->nrows; p++)
            if (!level->pair[p].shared)
                free(level->pair[p].indentation);
        free(level->pair);
        free(level->free);
        free(level->load);
    }
    free(x->motion);
    free(x->ramp_terms);
    thud_segment_clear(&x->seg);
    free(x);
}

/* Values and rates at all points. */
struct motion {
    thud_double_pair pair[MOTION / 2];
};

static inline void add_to(struct motion *sum, double factor, const double *x)
{
    for (int i = 0; i < MOTION / 2; i++)
        sum->pair[i] += factor * thud_double_pair_at(x + 2 * i);
}

static inline void put(const struct motion *sum, double *d, double *v)
{
    memcpy(d, sum->pair, THUD_POINTS * sizeof *d);
    memcpy(v, sum->pair + THUD_POINTS / 2, THUD_POINTS * sizeof *v);
}

/* ---- responses ---- */

/* How far the segment's modes have moved at the points, and their rates, out (nmodes x MOTION). */
static void read_modes(const struct thud_responses *x, double *out)
{
    const struct thud_segment *seg = &x->seg;
    int n = x->model->nmodes;
    memset(seg->q, 0, (size_t)n * sizeof *seg->q); /* a short step would be lost in the rounding of where it began */
    for (int j = 0; j < n; j++, out += MOTION) {
        double last[THUD_BATCH];
        thud_nodes_values(&x->first, seg->q + j, n, seg->terms, out);
        thud_nodes_values(&x->last, seg->q + j, n, seg->terms, last);
        memcpy(out + THUD_BATCH, last, (THUD_POINTS - THUD_BATCH) * sizeof *last);
        thud_nodes_rates(&x->first, seg->q + j, n, seg->terms, seg->h_s, out + THUD_POINTS);
        thud_nodes_rates(&x->last, seg->q + j, n, seg->terms, seg->h_s, last);
        memcpy(out + THUD_POINTS + THUD_BATCH, last, (THUD_POINTS - THUD_BATCH) * sizeof *last);
    }
}

static void add_motion(double factor, const double *restrict motion, size_t count, double *restrict sum)
{
    for (size_t i = 0; i < count; i++)
        sum[i] += factor * motion[i];
}

/* Modes under the loads that are 1 at one node, out of those under powers of the time; and those two at first. */
static bool fill_loads(struct thud_responses *x, struct level *level, double h)
{
    const struct thud_model *m = x->model;
    size_t n = (size_t)m->nmodes, count = n * MOTION;
    double *power = allocate(count + n, sizeof *power), *ones = power ? power + count : NULL;
    level->load = allocate((size_t)(x->loads * THUD_NODES) * count, sizeof *level->load);
    if (!power || !level->load) {
        free(power);
        return false;
    }
    for (size_t j = 0; j < n; j++)
        ones[j] = 1;
    struct thud_segment *seg = unit_segment(x, h);
    for (int load = 0; load < x->loads; load++)
        for (int p = 0; p < THUD_NODES; p++) {
            thud_taylor_load(m, seg, m->couples ? m->jacobian + (size_t)load * n : ones, p);
            read_modes(x, power);
            for (int k = 0; k < THUD_NODES; k++)
                add_motion(x->lagrange[p * THUD_NODES + k], power, count,
                           level->load + (size_t)(load * THUD_NODES + k) * count);
            if (p < 2 && level->free)
                memcpy(level->free + (size_t)(BY_LOAD + p) * count, power, count * sizeof *power);
        }
    free(power);
    return true;
}

static bool fill_level(struct thud_responses *x, struct level *level, double h)
{
    const struct thud_model *m = x->model;
    size_t n = (size_t)m->nmodes, nc = (size_t)m->nrows;
    level->pair = allocate(nc * nc, sizeof *level->pair);
    if (!m->couples)
        level->free = allocate(CAUSES * n * MOTION, sizeof *level->free);
    if (!level->pair || (!m->couples && !level->free) || !fill_loads(x, level, h))
        return false;
    double *unit = x->motion; /* one of its halves is 1, the other 0 */
    for (int cause = BY_PLACE; cause <= BY_RATE && level->free; cause++) {
        for (size_t j = 0; j < 2 * n; j++)
            unit[j] = (j < n) == (cause == BY_PLACE);
        thud_taylor_given(m, unit_segment(x, h), unit, unit + n);
        read_modes(x, level->free + (size_t)cause * n * MOTION);
    }
    return true;
}

/* Response of contact a to forces of contact b. A force pushes the two apart: indentation falls. */
static bool fill_pair(const struct thud_responses *x, const struct level *level, int a, int b)
{
    const struct thud_model *m = x->model;
    size_t n = (size_t)m->nmodes;
    struct thud_response *r = &level->pair[a * m->nrows + b];
    double *block = allocate(THUD_NODES * MOTION, sizeof *block);
    if (!block)
        return false;
    r->indentation = block;
    r->rate = block + THUD_NODES * THUD_POINTS;
    const double *ga = m->jacobian + (size_t)a * n, *gb = m->jacobian + (size_t)b * n;
    const double *table = level->load + (m->couples ? (size_t)(b * THUD_NODES) * n * MOTION : 0);
    int structure[2], structures = thud_model_row_structures(m, a, structure);
    for (int k = 0; k < THUD_NODES; k++, table += n * MOTION) {
        struct motion sum = {0};
        for (int i = 0; i < structures; i++) {
            const struct thud_model_structure *s = &m->structure[structure[i]];
            for (int j = s->first_mode; j < s->first_mode + s->modes; j++)
                add_to(&sum, m->couples ? -ga[j] : -ga[j] * gb[j], table + j * MOTION);
        }
        put(&sum, r->indentation + k * THUD_POINTS, r->rate + k * THUD_POINTS);
    }
    return true;
}

/* Where modes do not couple, each of two contacts responds to the other in the same way. */
static bool mirror_pair(const struct thud_responses *x, const struct level *level, int a, int b)
{
    const struct thud_response *other = &level->pair[b * x->model->nrows + a];
    if (x->model->couples || !other->indentation)
        return false;
    level->pair[a * x->model->nrows + b] = (struct thud_response){other->indentation, other->rate, true};
    return true;
}

const struct thud_response *thud_responses_row(const struct thud_responses *x, int level, int a)
{
    return x->level[level].pair + a * x->model->nrows;
}

enum thud_status thud_responses_make(struct thud_responses *x, int at, const int *contact, int n,
                                     struct thud_error *err)
{
    struct level *level = &x->level[at];
    bool made = level->pair || fill_level(x, level, ldexp(x->h_top, -at));
    for (int a = 0; a < n && made; a++)
        for (int b = 0; b < n && made; b++)
            made = thud_responses_row(x, at, contact[a])[contact[b]].indentation ||
                   mirror_pair(x, level, contact[a], contact[b]) || fill_pair(x, level, contact[a], contact[b]);
    return made ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
}

/* ---- without contact forces ---- */

/* Modes of a structure from the state on, by the tables. */
static void move_structure(struct thud_responses *x, const struct thud_state *state, const struct level *level,
                           const struct thud_model_structure *s, double a0, double a1)
{
    const struct thud_model *m = x->model;
    for (int j = s->first_mode; j < s->first_mode + s->modes; j++) {
        const double cause[CAUSES] = {state->q[j], state->qd[j], -m->gamma[j] * a0, -m->gamma[j] * a1};
        const double *table = level->free + j * MOTION;
        struct motion sum = {0};
        for (int i = 0; i < CAUSES; i++, table += m->nmodes * MOTION)
            add_to(&sum, cause[i], table);
        memcpy(x->motion + j * MOTION, sum.pair, sizeof sum.pair);
    }
}

/* Fills x->motion of the structures that these contacts move, with the ground acceleration going on in a straight line. */
static void move_modes(struct thud_responses *x, const struct thud_state *state, const struct level *level, double h,
                       const int *contact, int n)
{
    const struct thud_model *m = x->model;
    if (!level->free || state->nshifted > 0) { /* storeys with a plastic drift push too */
        thud_segment_begin(state, &x->seg, h);
        x->seg.terms = THUD_SEGMENT_TERMS;
        thud_taylor_given(m, &x->seg, state->q, state->qd);
        read_modes(x, x->motion);
        return;
    }
    double start, end;
    thud_state_ground(state, state->grid, &start, &end);
    double slope = (end - start) / state->grid_dt_s;
    for (int s = 0; s < m->nstructures; s++)
        for (int a = 0, moves = 0; a < n && !moves; a++) {
            int structure[2], structures = thud_model_row_structures(m, contact[a], structure);
            moves = (structures > 0 && structure[0] == s) || (structures > 1 && structure[1] == s);
            if (moves)
                move_structure(x, state, level, &m->structure[s], start + slope * state->offset_s, slope * h);
        }
}

/* Number of terms of contact c's answer to a rise of the ground acceleration. */
static int ramp_of(struct thud_responses *x, int c)
{
    static const double least = 1e-14; /* what is left out of what a bend adds is far below that of the rest */
    double *ramp = x->ramp + c * THUD_SEGMENT_TERMS, largest = 0;
    if (x->ramp_terms[c] > 0)
        return x->ramp_terms[c];
    for (int k = 0; k < THUD_SEGMENT_TERMS; k++) {
        ramp[k] = thud_model_gap_sum(x->model, c, x->ramp_modes + k * x->model->nmodes);
        largest = fmax(largest, fabs(ramp[k]));
    }
    int terms = THUD_SEGMENT_TERMS;
    while (terms > 2 && fabs(ramp[terms - 1]) <= least * largest)
        terms--;
    return x->ramp_terms[c] = terms;
}

/* Adds what a bend of the ground acceleration (by so much in h_top) does, `after_s` into the step. */
static void add_kink(struct thud_responses *x, int c, double bend, double h, double after_s, double *d, double *v)
{
    const double *ramp = x->ramp + c * THUD_SEGMENT_TERMS;
    int terms = ramp_of(x, c);
    for (int i = 0; i < THUD_POINTS; i += 2) {
        thud_double_pair at = thud_double_pair_at(x->point + i) * h - after_s, value = {0, 0}, rate = {0, 0};
        if (at[0] <= 0 && at[1] <= 0)
            continue;
        at = (thud_double_pair){at[0] > 0 ? at[0] : 0, at[1] > 0 ? at[1] : 0} / x->h_top;
        for (int k = terms - 1; k >= 0; k--) {
            rate = rate * at + value;
            value = value * at + ramp[k];
        }
        *(thud_double_pair *)(d + i) += bend * value;
        *(thud_double_pair *)(v + i) += bend / x->h_top * rate;
    }
}

/* Bends of the ground acceleration inside the step. */
static void add_kinks(struct thud_responses *x, const struct thud_state *state, double h, double end_s,
                      const int *contact, int n, double *d, double *v)
{
    const double dt = state->grid_dt_s;
    double before, at, same, after;
    for (long g = state->grid + 1;; g++) {
        double after_s = (double)(g - state->grid) * dt - state->offset_s;
        if (after_s >= fmin(h, end_s) * (1 - THUD_TOL_TIME))
            return;
        thud_state_ground(state, g - 1, &before, &at);
        thud_state_ground(state, g, &same, &after);
        double bend = (after - at - (at - before)) / dt * x->h_top;
        for (int a = 0; a < n && bend != 0; a++)
            add_kink(x, contact[a], bend, h, after_s, d + a * THUD_POINTS, v + a * THUD_POINTS);
    }
}

void thud_responses_unforced(struct thud_responses *x, const struct thud_state *state, int at, double end_s,
                             const int *contact, int n, double *d, double *v)
{
    const struct thud_model *m = x->model;
    double h = ldexp(x->h_top, -at);
    move_modes(x, state, &x->level[at], h, contact, n);
    for (int a = 0; a < n; a++) {
        int c = contact[a], structure[2], structures = thud_model_row_structures(m, c, structure);
        const double *g = m->jacobian + (size_t)c * (size_t)m->nmodes;
        /* what has just touched has not moved yet, whatever rounding says */
        double start = state->contact[c].suppressed.indentation > 0 ? 0 : thud_contact_indentation(state, c);
        struct motion sum = {0};
        for (int i = 0; i < THUD_POINTS / 2; i++)
            sum.pair[i] = (thud_double_pair){start, start};
        for (int i = 0; i < structures; i++) {
            const struct thud_model_structure *s = &m->structure[structure[i]];
            for (int j = s->first_mode; j < s->first_mode + s->modes; j++)
                add_to(&sum, g[j], x->motion + j * MOTION);
        }
        put(&sum, d + a * THUD_POINTS, v + a * THUD_POINTS);
    }
    add_kinks(x, state, h, end_s, contact, n, d, v);
}
