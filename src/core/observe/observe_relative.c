/* The largest relative displacement of each contact's sides without contact, u_a - u_b: contacts with a clearance above it
 * never close. Behind them, of sides that are no floor (a struck column), the largest size of the struck side's own. */
#include "core/observe/observe_relative.h"

#include <math.h>
#include <string.h>

#include "base/arena.h"
#include "core/motion/free_vibration.h"
#include "core/numerics/poly.h"
#include "core/numerics/vec.h"

enum { ENDS = THUD_FREE_VIBRATION_ENDS, BLOCK = THUD_FREE_VIBRATION_BLOCK };

/* Raises the largest value by a polynomial up to s: of p itself, or of its size. */
static void raise(double *largest, double *p, int terms, double s, bool size)
{
    double where, shift = 0;
    for (int k = 0; k < terms && !size; k++)
        shift += fabs(p[k]);
    p[0] += shift; /* so that the largest value is the largest absolute one */
    *largest = fmax(*largest, thud_poly_peak(p, terms, s, *largest + shift, &where) - shift);
}

static void raise_relative(double *largest, const struct thud_state *state, const struct thud_segment *seg, int c,
                           double s)
{
    double d[THUD_SEGMENT_TERMS];
    thud_segment_indentation(state, seg, c, d);
    d[0] += thud_state_clearance(state, c);
    raise(largest, d, seg->terms, s, false);
}

/* The side of contact c that is no floor; NULL where both are. */
static const struct thud_model_side *struck_side(const struct thud_model *m, int c)
{
    return m->contact[c].struck == 0 ? NULL : m->contact[c].struck < 0 ? &m->contact[c].left : &m->contact[c].right;
}

static void raise_struck(double *largest, const struct thud_model *m, const struct thud_segment *seg,
                         const struct thud_model_side *side, double s)
{
    double u[THUD_SEGMENT_TERMS];
    thud_dots(side->modes, side->row, seg->q + side->first_mode, m->nmodes, seg->terms, u);
    raise(largest, u, seg->terms, s, true);
}

static enum thud_status segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    double *largest = ((struct thud_relative *)own)->largest_m;
    (void)err;
    for (int c = 0; c < o->state->model->ncontacts; c++)
        if (o->seg->end)
            largest[c] = fmax(largest[c], thud_model_gap_sum(o->state->model, c, o->q));
        else
            raise_relative(&largest[c], o->state, o->seg, c, o->s);
    for (int c = 0; c < o->state->model->ncontacts; c++)
        if (struck_side(o->state->model, c))
            raise_struck(&largest[o->state->model->ncontacts + c], o->state->model, o->seg,
                         struck_side(o->state->model, c), o->s);
    return THUD_OK;
}

/* The two structures asked for last, and whether they move alike in the block. */
struct alike {
    int left, right;
    bool alike;
};

static bool same(const double *a, const double *b, int n)
{
    return memcmp(a, b, (size_t)n * sizeof *a) == 0;
}

static bool structures_alike(const struct thud_model *m, const struct thud_free_vibration *f, int left, int right)
{
    const struct thud_model_structure *l = &m->structure[left], *r = &m->structure[right];
    const int n = l->modes, i = l->first_mode, j = r->first_mode;
    if (n != r->modes || l->damping || r->damping || !same(m->spring + i, m->spring + j, n) ||
        !same(m->dashpot + i, m->dashpot + j, n) || !same(m->gamma + i, m->gamma + j, n))
        return false;
    for (int k = 0; k < n; k++)
        if (f->shift[i + k] != f->shift[j + k] || f->q[(i + k) * ENDS] != f->q[(j + k) * ENDS] ||
            f->qd[(i + k) * ENDS] != f->qd[(j + k) * ENDS])
            return false;
    return true;
}

/* Whether the sides of contact c have no relative motion at all: the same places of two structures that move alike. */
static bool moves_alike(const struct thud_model *m, const struct thud_free_vibration *f, int c, struct alike *pair)
{
    const struct thud_model_side *l = &m->contact[c].left, *r = &m->contact[c].right;
    if (l->dof < 0 || r->dof < 0)
        return false;
    if (pair->left != l->structure || pair->right != r->structure)
        *pair = (struct alike){l->structure, r->structure, structures_alike(m, f, l->structure, r->structure)};
    return pair->alike && same(l->row, r->row, l->modes);
}

/* Marks the intervals, f->gap at their ends, inside which a value may pass both the largest so far and the largest at
 * the ends. */
static bool mark(const struct thud_free_vibration *f, double largest, double most, double margin, int intervals,
                 unsigned char *due)
{
    memset(due, 0, (size_t)intervals);
    if (most + margin <= largest)
        return false;
    double limit = fmax(largest, most) - margin;
    for (int t = 0; t < intervals; t++)
        due[t] = fmax(f->gap[t], f->gap[t + 1]) >= limit;
    return true;
}

/* Interval by interval, so that one series of a structure serves all that is due there. */
static void read_due(struct thud_relative *r, const struct thud_state *state, struct thud_free_vibration *f,
                     int intervals)
{
    const int nc = state->model->ncontacts;
    for (int t = 0; t < intervals; t++)
        for (int piece = 0; piece < f->pieces; piece++)
            for (int c = 0; c < nc; c++) {
                if (r->due[c * BLOCK + t])
                    raise_relative(&r->largest_m[c], state, thud_free_vibration_row_series(f, state, c, t, piece), c,
                                   1);
                if (r->due[(nc + c) * BLOCK + t])
                    raise_struck(&r->largest_m[nc + c], state->model,
                                 thud_free_vibration_row_series(f, state, c, t, piece), struck_side(state->model, c),
                                 1);
            }
}

static enum thud_status block(void *own, const struct thud_state *state, struct thud_free_vibration *f, int intervals,
                              struct thud_error *err)
{
    struct thud_relative *r = own;
    const struct thud_model *m = state->model;
    const int nc = m->ncontacts;
    struct alike pair = {-1, -1, false};
    bool any = false;
    (void)err;
    for (int c = 0; c < nc; c++) {
        double margin, most = thud_free_vibration_gap(f, m, c, intervals + 1, &margin);
        if (moves_alike(m, f, c, &pair))
            margin = 0;
        any |= mark(f, r->largest_m[c], most, margin, intervals, r->due + c * BLOCK);
        const struct thud_model_side *side = struck_side(m, c);
        margin = 0;
        most = side ? thud_free_vibration_side(f, m, side, intervals + 1, &margin) : 0;
        any |= mark(f, r->largest_m[nc + c], most, margin, intervals, r->due + (nc + c) * BLOCK);
    }
    if (any)
        read_due(r, state, f, intervals);
    return THUD_OK;
}

const struct thud_observer thud_observe_relative = {.segment = segment, .block = block};

enum thud_status thud_relative_init(struct thud_relative *relative, const struct thud_state *state,
                                    struct thud_error *err)
{
    const int n = 2 * state->model->ncontacts;
    return THUD_LAY_IN(state->memory, err, THUD_PIECE(relative->largest_m, n), THUD_PIECE(relative->due, n * BLOCK));
}
