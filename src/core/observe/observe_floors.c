#include "core/observe/observe_floors.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/quantity.h"
#include "core/numerics/poly.h"
#include "core/numerics/vec.h"

enum { BATCH = THUD_FLOOR_LANES, TERMS = THUD_FLOOR_TERMS, PAIRS = BATCH / 2 };

static const double accuracy = 1e-6; /* of a floor's largest acceleration, in every pseudo-acceleration */
/* Angle that an oscillator turns by in a piece at most: so that series converge at once and a bound says where it turns
 * back. */
static const double piece_most_rad = 1.6;

/* ---- the floor's acceleration ---- */

/* Leaves out the highest terms while the acceleration changes by less than `allowed`: of degree m, a polynomial is
 * nearest to one of degree m - 1 by a Chebyshev polynomial, whose size is 2^(1 - 2 m) of its highest factor. */
static void shorten(const struct thud_floor_oscillators *p, struct thud_floor_load *load, double allowed)
{
    double *b = load->b;
    while (load->terms > 1) {
        int m = load->terms - 1;
        double change = p->size[m] * fabs(b[m]);
        if (change > allowed)
            break;
        allowed -= change;
        for (int k = 0; k < m; k++)
            b[k] -= b[m] * p->monic[m][k];
        load->terms = m;
    }
    load->most = fabs(b[0]);
    load->slope = 0;
    for (int k = 1; k < load->terms; k++) {
        load->most += fabs(b[k]);
        load->slope += k * fabs(b[k]);
    }
}

/* Of floor f over the first s of the segment. */
static void read_floor(struct thud_floor_oscillators *p, const struct thud_observation *o, int f)
{
    const struct thud_model *m = o->state->model;
    const struct thud_segment *seg = o->seg;
    struct thud_floor_load *load = &p->load[f];
    double power = 1;
    load->terms = seg->terms > 4 ? seg->terms - 2 : 2;
    for (int k = 0; k < load->terms; k++) {
        double a = 0;
        if (k + 2 < seg->terms)
            a = (k + 1) * (k + 2) * thud_model_floor(m, p->dof[f], seg->q + (k + 2) * m->nmodes) /
                (seg->h_s * seg->h_s);
        if (k < 2)
            a += p->influence[f] * (k == 0 ? seg->a0 : seg->a1);
        load->b[k] = a * power;
        power *= o->s;
    }
    p->largest[f] = fmax(p->largest[f], fabs(load->b[0]));
    shorten(p, load, 0.5 * p->left_out * p->largest[f]);
}

/* The part of it between j/parts and (j + 1)/parts. */
static void make_part(struct thud_floor_oscillators *p, int f, int j, int parts)
{
    struct thud_floor_load *part = &p->part[f];
    double power = 1, at = (double)j / parts;
    *part = p->load[f];
    for (int i = 0; i + 1 < part->terms; i++) /* Taylor coefficients at j/parts, by repeated division */
        for (int k = part->terms - 2; k >= i; k--)
            part->b[k] += at * part->b[k + 1];
    for (int k = 0; k < part->terms; k++) {
        part->b[k] *= power;
        power /= parts;
    }
    shorten(p, part, 0.5 * p->left_out * p->largest[f]);
}

/* ---- the oscillators ---- */

/* Fills what a piece of this length needs for loads of so many terms. */
static void make_table(const struct thud_floor_oscillators *p, struct thud_floor_block *t, double piece_s, int terms)
{
    enum { BEYOND = 16 }; /* terms of the series behind the last M_k: 1/16! is rounding */
    if (t->piece_s == piece_s && t->terms >= terms)
        return;
    t->piece_s = piece_s;
    t->terms = terms;
    for (int i = 0; i < BATCH; i++) {
        double angle = t->omega[i] * piece_s, re = -p->damping * angle, im = p->root * angle;
        double x = 1.0 / (terms + BEYOND), y = 0; /* M_k */
        for (int k = terms + BEYOND - 1; k > 0; k--) {
            double next = (1 + re * x - im * y) / k;
            y = (re * y + im * x) / k;
            x = next;
            if (k <= terms) {
                t->load[k - 1][0][i] = -piece_s * x;
                t->load[k - 1][1][i] = -piece_s * y;
            }
        }
        t->turn[0][i] = 1 + re * x - im * y;
        t->turn[1][i] = re * y + im * x;
        t->bend[i] = angle * angle / 8;
        t->push[i] = piece_s * angle * (1 + angle) / 8;
    }
}

/* Im z between two ends, where it may pass the peak: an extremum inside, if its slope may change sign. */
static void look_inside(const struct thud_floor_oscillators *p, const struct thud_floor_block *t,
                        const struct thud_floor_load *load, int i, const double from[2], struct thud_floor_batch *batch)
{
    double angle = t->omega[i] * t->piece_s, re = -p->damping * angle, im = p->root * angle;
    double start = re * from[1] + im * from[0], end = re * batch->z[1][i] + im * batch->z[0][i], where;
    double push = t->piece_s * load->most, size = fabs(from[0]) + fabs(from[1]) + push;
    double third = angle * (angle * (angle * size + push) + t->piece_s * load->slope); /* of the slope's curvature */
    double c[THUD_SEGMENT_TERMS], x = from[0], y = from[1];
    batch->peak[i] = fmax(batch->peak[i], fabs(batch->z[1][i]));
    if ((start > 0) == (end > 0) && fmin(fabs(start), fabs(end)) > third / 8)
        return;
    for (int k = 0; k < THUD_SEGMENT_TERMS; k++) {
        double next = re * x - im * y - (k < load->terms ? t->piece_s * load->b[k] : 0);
        c[k] = y;
        y = (re * y + im * x) / (k + 1);
        x = next / (k + 1);
    }
    batch->peak[i] = thud_poly_peak(c, THUD_SEGMENT_TERMS, 1, batch->peak[i], &where);
}

static void advance(const struct thud_floor_oscillators *p, const struct thud_floor_block *t,
                    const struct thud_floor_load *load, struct thud_floor_batch *batch)
{
    thud_vec2 re[PAIRS], im[PAIRS];
    double from[2][BATCH];
    memcpy(from, batch->z, sizeof from);
    for (int i = 0; i < PAIRS; i++) {
        thud_vec2 x = thud_vec2_at(from[0] + 2 * i), y = thud_vec2_at(from[1] + 2 * i),
                  c = thud_vec2_at(t->turn[0] + 2 * i), s = thud_vec2_at(t->turn[1] + 2 * i);
        re[i] = c * x - s * y;
        im[i] = c * y + s * x;
    }
    for (int k = 0; k < load->terms; k++) {
        const double b = load->b[k], *r = t->load[k][0], *j = t->load[k][1];
        for (int i = 0; i < PAIRS; i++) {
            re[i] += b * thud_vec2_at(r + 2 * i);
            im[i] += b * thud_vec2_at(j + 2 * i);
        }
    }
    for (int i = 0; i < PAIRS; i++) {
        thud_vec2 x = thud_vec2_abs(thud_vec2_at(from[0] + 2 * i)), y = thud_vec2_abs(thud_vec2_at(from[1] + 2 * i)),
                  end = thud_vec2_abs(im[i]), peak = thud_vec2_at(batch->peak + 2 * i);
        thud_vec2 most = thud_vec2_choose((thud_vec2_bits)(end > y), end, y) + thud_vec2_at(t->bend + 2 * i) * (x + y) +
                         thud_vec2_at(t->push + 2 * i) * load->most;
        thud_vec2_put(re[i], batch->z[0] + 2 * i);
        thud_vec2_put(im[i], batch->z[1] + 2 * i);
        thud_vec2_bits passes = (thud_vec2_bits)(most > peak);
        if (!thud_vec2_any(passes))
            continue;
        for (int i_period = 2 * i; i_period < 2 * i + 2; i_period++)
            if (passes[i_period - 2 * i])
                look_inside(p, t, load, i_period, (const double[2]){from[0][i_period], from[1][i_period]}, batch);
    }
}

static int parts_of(const struct thud_floor_block *t, double length_s)
{
    int parts = 1;
    while (t->omega[0] * length_s > piece_most_rad * parts)
        parts *= 2;
    return parts;
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    struct thud_floor_oscillators *p = own;
    const double length = o->s * o->seg->h_s;
    int terms = 0;
    (void)err;
    assert(!o->seg->interpolates && !o->seg->end);
    for (int f = 0; f < p->nfloors; f++) {
        read_floor(p, o, f);
        terms = p->load[f].terms > terms ? p->load[f].terms : terms;
    }
    for (int b = 0, next; b < p->nblocks; b = next) {
        const int parts = parts_of(&p->table[b], length);
        for (next = b; next < p->nblocks && parts_of(&p->table[next], length) == parts; next++)
            make_table(p, &p->table[next], length / parts, terms);
        for (int j = 0; j < parts; j++)
            for (int f = 0; f < p->nfloors; f++) {
                const struct thud_floor_load *load = &p->load[f];
                if (parts > 1) {
                    make_part(p, f, j, parts);
                    load = &p->part[f];
                }
                for (int k = b; k < next; k++)
                    advance(p, &p->table[k], load, &p->batch[k * p->nfloors + f]);
            }
    }
    memcpy(p->rates, o->qd, (size_t)p->nmodes * sizeof *p->rates);
    return THUD_OK;
}

/* An impulse has changed the floors' velocities. */
static void switched(void *own, const struct thud_state *state, int row, enum thud_event event)
{
    struct thud_floor_oscillators *p = own;
    (void)row, (void)event;
    for (int f = 0; f < p->nfloors; f++) {
        double jump =
            thud_model_floor(state->model, p->dof[f], state->qd) - thud_model_floor(state->model, p->dof[f], p->rates);
        for (int b = 0; jump != 0 && b < p->nblocks; b++)
            for (int i = 0; i < BATCH; i++)
                p->batch[b * p->nfloors + f].z[0][i] -= jump;
    }
    memcpy(p->rates, state->qd, (size_t)p->nmodes * sizeof *p->rates);
}

const struct thud_observer thud_observe_floors = {.segment = segment, .switched = switched};

/* ---- making them ---- */

static void make_monic(struct thud_floor_oscillators *p)
{
    double last[TERMS] = {1}, now[TERMS] = {-1, 2}, next[TERMS];
    for (int m = 1; m < TERMS; m++) {
        for (int k = 0; k <= m; k++)
            p->monic[m][k] = now[k] / now[m];
        p->size[m] = 1 / now[m];
        for (int k = 0; k < TERMS; k++) /* T_(m+1) = 2 (2 s - 1) T_m - T_(m-1) */
            next[k] = (k > 0 ? 4 * now[k - 1] : 0) - 2 * now[k] - last[k];
        memcpy(last, now, sizeof last);
        memcpy(now, next, sizeof now);
    }
}

enum thud_status thud_floor_oscillators_init(struct thud_floor_oscillators *p, const struct thud_model *model,
                                             const struct thud_floor_spectra_choice *choice, struct thud_error *err)
{
    assert(choice->nfloors > 0 && choice->nperiods > 0);
    assert(choice->damping > 0 && choice->damping < 1);
    struct thud_arena arena;
    const size_t nf = (size_t)choice->nfloors, nm = (size_t)model->nmodes,
                 nb = ((size_t)choice->nperiods + BATCH - 1) / BATCH;
    *p = (struct thud_floor_oscillators){.nfloors = choice->nfloors,
                                         .nperiods = choice->nperiods,
                                         .nblocks = (int)nb,
                                         .nmodes = model->nmodes,
                                         .damping = choice->damping,
                                         .root = sqrt(1 - choice->damping * choice->damping)};
    p->left_out = accuracy * tanh(0.5 * THUD_PI * p->damping / p->root);
    if (!thud_arena_open(&arena, thud_arena_room(nf, sizeof *p->dof) + 2 * thud_arena_room(nf, sizeof(double)) +
                                     thud_arena_room(nm, sizeof(double)) + 2 * thud_arena_room(nf, sizeof *p->load) +
                                     thud_arena_room(nb, sizeof *p->table) +
                                     thud_arena_room(nb * nf, sizeof *p->batch)))
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    p->memory = arena.next;
    p->dof = thud_arena_take(&arena, nf, sizeof *p->dof);
    p->influence = thud_arena_take(&arena, nf, sizeof(double));
    p->largest = thud_arena_take(&arena, nf, sizeof(double));
    p->rates = thud_arena_take(&arena, nm, sizeof(double));
    p->load = thud_arena_take(&arena, nf, sizeof *p->load);
    p->part = thud_arena_take(&arena, nf, sizeof *p->part);
    p->table = thud_arena_take(&arena, nb, sizeof *p->table);
    p->batch = thud_arena_take(&arena, nb * nf, sizeof *p->batch);
    for (int f = 0; f < p->nfloors; f++) {
        assert(choice->dof[f] >= 0 && choice->dof[f] < model->ndof);
        p->dof[f] = choice->dof[f];
        p->influence[f] = thud_model_floor(model, p->dof[f], model->gamma);
    }
    for (int i = 0; i < p->nblocks * BATCH; i++) {
        double period = choice->period_s[i < p->nperiods ? i : p->nperiods - 1];
        assert(period > 0 && (i == 0 || i >= p->nperiods || period >= choice->period_s[i - 1]));
        p->table[i / BATCH].omega[i % BATCH] = 2 * THUD_PI / period;
    }
    memcpy(p->rates, model->qd0, nm * sizeof *p->rates);
    make_monic(p);
    return THUD_OK;
}

void thud_floor_oscillators_clear(struct thud_floor_oscillators *p)
{
    free(p->memory);
    *p = (struct thud_floor_oscillators){0};
}

double thud_floor_oscillators_peak(const struct thud_floor_oscillators *p, int floor, int period)
{
    assert(floor >= 0 && floor < p->nfloors && period >= 0 && period < p->nperiods);
    const int block = period / BATCH, i_period = period % BATCH;
    return p->table[block].omega[i_period] * p->batch[block * p->nfloors + floor].peak[i_period] / p->root;
}
