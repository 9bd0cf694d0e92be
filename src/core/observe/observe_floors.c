#include "core/observe/observe_floors.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/arena.h"
#include "base/largest.h"
#include "base/quantity.h"
#include "core/numerics/poly.h"

enum { PAIRS = THUD_FLOOR_PAIRS, BATCH = 2 * PAIRS, TERMS = THUD_FLOOR_TERMS };

static const double accuracy = 2e-7; /* of a floor's largest acceleration, in every pseudo-acceleration */
/* Angle that an oscillator turns by in a piece at most: so that series converge at once. */
static const double piece_most_rad = 3.2;

static inline struct thud_complex2 times(struct thud_complex2 x, struct thud_complex2 y)
{
    return (struct thud_complex2){x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
}

static inline struct thud_complex2 over(struct thud_complex2 x, struct thud_complex2 y)
{
    const thud_vec2 square = y.re * y.re + y.im * y.im;
    return (struct thud_complex2){(x.re * y.re + x.im * y.im) / square, (x.im * y.re - x.re * y.im) / square};
}

static inline thud_vec2 size_of(struct thud_complex2 x)
{
    const thud_vec2 square = x.re * x.re + x.im * x.im;
    return thud_vec2_set(sqrt(square[0]), sqrt(square[1]));
}

/* ---- the floors' acceleration ---- */

/* Leaves out the highest terms in use while together they stay within what may still be left out: each changes the result
 * by at most its coefficient times its size. */
static inline void shorten(struct thud_floor_load *load, const double *size)
{
    for (; load->used > 1; load->used--) {
        const double change = size[load->used - 1] * fabs(load->c[load->used - 1]);
        if (change > load->left_out)
            return;
        load->left_out -= change;
    }
}

/* Fills the basis for a part of a segment: powers of s by Legendre's polynomials of the part, by their recurrence. */
static void make_basis(struct thud_floor_oscillators *p, double h_s, double from, double to)
{
    const double part[] = {h_s, from, to}, half = 0.5 * (to - from), middle = from + half;
    if (memcmp(p->part, part, sizeof part) == 0)
        return;
    double row[TERMS][TERMS + 1] = {{1}}; /* of s^k; large */
    memcpy(p->part, part, sizeof part);
    for (int k = 0; k < TERMS; k++)
        for (int j = 0; j <= k; j++) {
            if (k > 0)
                row[k][j] = middle * row[k - 1][j] + half * ((j > 0 ? j * row[k - 1][j - 1] / (2 * j - 1) : 0) +
                                                             (j + 1) * row[k - 1][j + 1] / (2 * j + 3));
            p->basis[j][k - j] = (k + 1) * (k + 2) / (h_s * h_s) * row[k][j];
        }
}

/* Reads a floor's acceleration from its modes'. */
static void read_floor(struct thud_floor_oscillators *p, const struct thud_model *m, int floor, int terms)
{
    const int dof = p->dof[floor];
    const struct thud_model_structure *s = &m->structure[m->dof_structure[dof]];
    struct thud_floor_load *load = &p->load[floor];
    *load = (struct thud_floor_load){.used = terms};
    thud_dots(s->modes, s->phi + (dof - s->first) * s->modes, p->modal + s->first_mode, m->nmodes, terms, load->c);
    p->largest[floor] = thud_larger(p->largest[floor], fabs(load->c[0]));
    load->left_out = p->left_out * p->largest[floor];
    shorten(load, p->ones);
    load->terms = load->used;
    for (int k = 0, sign = 1; k < load->terms; k++, sign = -sign) {
        const double slope = k * (k + 1), size = fabs(load->c[k]); /* slope: of P_k at the end */
        load->start += sign * load->c[k];
        load->slope -= sign * slope * load->c[k];
        load->most += size;
        load->curve += 0.5 * slope * (slope - 2) * size;
    }
}

/* Reads the accelerations over a part of the segment; returns the number of terms. */
static int read_floors(struct thud_floor_oscillators *p, const struct thud_observation *o, double from, double to)
{
    const struct thud_model *m = o->state->model;
    const struct thud_segment *seg = o->seg;
    const int n = m->nmodes, terms = seg->terms - 2;
    assert(terms >= 2 && terms <= TERMS);
    make_basis(p, seg->h_s, from, to);
    memset(p->modal, 0, (size_t)(terms * n) * sizeof *p->modal);
    for (int j = 0; j < terms; j++)
        thud_add_rows(n, terms - j, 1, p->basis[j], seg->q + (j + 2) * n, p->modal + j * n);
    for (int i = 0; i < n; i++) {
        p->modal[i] += m->gamma[i] * (seg->a0 + 0.5 * (from + to) * seg->a1);
        p->modal[n + i] += m->gamma[i] * 0.5 * (to - from) * seg->a1;
    }
    for (int f = 0; f < p->nfloors; f++)
        read_floor(p, m, f, terms);
    return terms;
}

/* ---- the oscillators ---- */

/* Fills what a piece of this length needs for loads of so many terms. By parts, with 2 (2 k + 1) P_k the slope of
 * P_(k+1) - P_(k-1), which is 0 at both ends,
 *
 *     r_k = L_k/L_(k-1) = mu/(mu r_(k+1) - 2 (2 k + 1)),   L_0 = 2/(2 - mu (1 + r_1)),   e^mu = 1 + mu L_0. */
static void make_table(const struct thud_floor_oscillators *p, struct thud_floor_block *t, double piece_s, int terms)
{
    enum { BEYOND = 10 }; /* behind the last term, where to take r as 0 is rounding */
    if (t->piece_s == piece_s && t->terms >= terms)
        return;
    const double most_rad = t->omega[0][0] * piece_s;
    t->piece_s = piece_s;
    t->terms = terms;
    t->size[0] = 1;
    for (int k = 1; k < terms; k++)
        t->size[k] = t->size[k - 1] * 0.5 * most_rad / (2 * k + 1);
    for (int i = 0; i < PAIRS; i++) {
        const thud_vec2 angle = piece_s * t->omega[i];
        const struct thud_complex2 mu = {-p->damping * angle, p->root * angle};
        struct thud_complex2 x = {{0, 0}, {0, 0}}; /* r_k, then L_0, then -h L_k */
        for (int k = terms + BEYOND; k > 0; k--) {
            x = times(mu, x);
            x = over(mu, (struct thud_complex2){x.re - 2 * (2 * k + 1), x.im});
            if (k < terms)
                t->load[k][i] = x;
        }
        x = times(mu, (struct thud_complex2){1 + x.re, x.im});
        x = over((struct thud_complex2){{2, 2}, {0, 0}}, (struct thud_complex2){2 - x.re, -x.im});
        t->mu[i] = mu;
        t->turn[i] = times(mu, x);
        t->turn[i].re += 1;
        t->load[0][i] = x = (struct thud_complex2){-piece_s * x.re, -piece_s * x.im};
        for (int k = 1; k < terms; k++)
            t->load[k][i] = x = times(x, t->load[k][i]);
    }
}

/* Largest |Im z| of an oscillator in a piece, by power series, if it is above the peak so far. The coefficients of P_k have
 * the ratios -(k - j) (k + j + 1)/(j + 1)^2. */
static double look_inside(const struct thud_floor_block *t, const struct thud_floor_load *load, int pair, int i,
                          struct thud_complex2 from, double peak)
{
    const double re = t->mu[pair].re[i], im = t->mu[pair].im[i];
    double b[THUD_SEGMENT_TERMS] = {0}, c[THUD_SEGMENT_TERMS], x = from.re[i], y = from.im[i], where;
    int n = 0;
    for (int k = 0; k < load->terms; k++) {
        double part = (k % 2 ? -t->piece_s : t->piece_s) * load->c[k];
        for (int j = 0; j <= k; j++) {
            b[j] += part;
            part *= -(double)((k - j) * (k + j + 1)) / ((j + 1) * (j + 1));
        }
    }
    for (; n < THUD_SEGMENT_TERMS && (n <= load->terms || fabs(x) + fabs(y) > accuracy * accuracy * peak); n++) {
        const double next = (re * x - im * y - b[n]) / (n + 1);
        c[n] = y;
        y = (re * y + im * x) / (n + 1);
        x = next;
    }
    return thud_poly_peak(c, n, 1, peak, &where);
}

/* Peaks of the piece that the oscillators have gone through. A cubic has the values and slopes of Im z at both ends, and
 * differs from it by at most (s (1 - s))^2/24 of the fourth derivative. So |Im z| stays below the peak so far where the
 * cubic's two inner control points do by 1/288 of that derivative: their part in it is 3 s (1 - s). The bound is
 *
 *     Im z'''' = Im(mu^2 z'' - mu h a''),   |z''(s)| <= |z''(0)| + h max |a''|   (derivatives by s) */
static void look(const struct thud_floor_block *t, const struct thud_floor_load *load, const struct thud_complex2 *from,
                 struct thud_floor_batch *batch)
{
    const double h = t->piece_s, curve = h * load->curve;
    thud_vec2 excess = {-INFINITY, -INFINITY};
    for (int i = 0; i < PAIRS; i++) {
        const struct thud_complex2 mu = t->mu[i], to = batch->z[i];
        const thud_vec2 angle = h * t->omega[i], last = to.im - times(mu, to).im / 3;
        struct thud_complex2 z = times(mu, from[i]); /* z', then z'' at the start */
        const thud_vec2 first = from[i].im + z.im / 3;
        z.re -= h * load->start;
        z = times(mu, z);
        z.re -= h * load->slope;
        const thud_vec2 fourth = angle * (angle * (size_of(z) + curve) + curve),
                        most = thud_vec2_larger(thud_vec2_abs(first), thud_vec2_abs(last)) + fourth / 288;
        batch->peak[i] = thud_vec2_larger(batch->peak[i], thud_vec2_abs(to.im));
        const thud_vec2_bits passes = (thud_vec2_bits)(most > batch->peak[i]);
        for (int j = 0; j < 2 && thud_vec2_any(passes); j++)
            if (passes[j])
                batch->peak[i][j] = look_inside(t, load, i, j, from[i], batch->peak[i][j]);
        excess = thud_vec2_larger(size_of(to) - batch->peak[i], excess);
    }
    batch->margin = -thud_larger(excess[0], excess[1]);
}

/* Moves the oscillators on a floor through a piece. No |z| grows by more than the integral of |a|. */
static void advance(const struct thud_floor_block *t, struct thud_floor_load *load, struct thud_floor_batch *batch)
{
    struct thud_complex2 from[PAIRS], to[PAIRS];
    shorten(load, t->size);
    for (int i = 0; i < PAIRS; i++)
        to[i] = times(t->turn[i], batch->z[i]);
    for (int k = 0; k < load->used; k++)
        for (int i = 0; i < PAIRS; i++) {
            to[i].re += load->c[k] * t->load[k][i].re;
            to[i].im += load->c[k] * t->load[k][i].im;
        }
    batch->margin -= t->piece_s * load->most;
    const bool near = !(batch->margin > 0);
    if (near)
        memcpy(from, batch->z, sizeof from);
    for (int i = 0; i < PAIRS; i++)
        batch->z[i] = to[i];
    if (near)
        look(t, load, from, batch);
}

static int parts_of(const struct thud_floor_block *t, double length_s)
{
    int parts = 1;
    while (t->omega[0][0] * length_s > piece_most_rad * parts)
        parts *= 2;
    return parts;
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    struct thud_floor_oscillators *p = own;
    const double length = o->s * o->seg->h_s;
    (void)err;
    assert(!o->seg->interpolates && !o->seg->end);
    for (int b = 0, next; b < p->nblocks; b = next) {
        const int parts = parts_of(&p->table[b], length);
        for (next = b + 1; next < p->nblocks && parts_of(&p->table[next], length) == parts;)
            next++;
        for (int j = 0; j < parts; j++) {
            const int terms = read_floors(p, o, o->s * j / parts, o->s * (j + 1) / parts);
            for (int k = b; k < next; k++) {
                struct thud_floor_batch *batch = p->batch + k * p->nfloors;
                make_table(p, &p->table[k], length / parts, terms);
                for (struct thud_floor_load *load = p->load, *end = load + p->nfloors; load < end; load++)
                    advance(&p->table[k], load, batch++);
            }
        }
    }
    memcpy(p->rates, o->qd, (size_t)o->state->model->nmodes * sizeof *p->rates);
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
        for (int b = 0; jump != 0 && b < p->nblocks; b++) {
            struct thud_floor_batch *batch = &p->batch[b * p->nfloors + f];
            batch->margin = 0;
            for (int i = 0; i < PAIRS; i++)
                batch->z[i].re -= jump;
        }
    }
    memcpy(p->rates, state->qd, (size_t)state->model->nmodes * sizeof *p->rates);
}

const struct thud_observer thud_observe_floors = {.segment = segment, .switched = switched};

/* ---- making them ---- */

enum thud_status thud_floor_oscillators_init(struct thud_floor_oscillators *p, const struct thud_state *state,
                                             const struct thud_floor_spectra_choice *choice, struct thud_error *err)
{
    const struct thud_model *model = state->model;
    assert(choice->nfloors > 0 && choice->nperiods > 0);
    assert(choice->damping > 0 && choice->damping < 1);
    const size_t nf = (size_t)choice->nfloors, nm = (size_t)model->nmodes,
                 nb = ((size_t)choice->nperiods + BATCH - 1) / BATCH;
    *p = (struct thud_floor_oscillators){.nfloors = choice->nfloors,
                                         .nperiods = choice->nperiods,
                                         .nblocks = (int)nb,
                                         .damping = choice->damping,
                                         .root = sqrt(1 - choice->damping * choice->damping)};
    p->left_out = accuracy * p->root * (1 - exp(-p->damping * piece_most_rad)) / piece_most_rad;
    const enum thud_status status =
        THUD_LAY_IN(state->memory, err, THUD_PIECE(p->dof, nf), THUD_PIECE(p->largest, nf), THUD_PIECE(p->rates, nm),
                    THUD_PIECE(p->modal, nm * TERMS), THUD_PIECE(p->load, nf), THUD_PIECE(p->table, nb),
                    THUD_PIECE(p->batch, nb * nf));
    if (status != THUD_OK)
        return status;
    for (int f = 0; f < p->nfloors; f++) {
        assert(choice->dof[f] >= 0 && choice->dof[f] < model->ndof);
        p->dof[f] = choice->dof[f];
    }
    for (int i = 0; i < p->nblocks * BATCH; i++) {
        double period = choice->period_s[i < p->nperiods ? i : p->nperiods - 1];
        assert(period > 0 && (i == 0 || i >= p->nperiods || period >= choice->period_s[i - 1]));
        p->table[i / BATCH].omega[i % BATCH / 2][i % 2] = 2 * THUD_PI / period;
    }
    for (int k = 0; k < TERMS; k++)
        p->ones[k] = 1;
    memcpy(p->rates, model->qd0, nm * sizeof *p->rates);
    return THUD_OK;
}

double thud_floor_oscillators_peak(const struct thud_floor_oscillators *p, int floor, int period)
{
    assert(floor >= 0 && floor < p->nfloors && period >= 0 && period < p->nperiods);
    const int block = period / BATCH, pair = period % BATCH / 2;
    return p->table[block].omega[pair][period % 2] * p->batch[block * p->nfloors + floor].peak[pair][period % 2] /
           p->root;
}
