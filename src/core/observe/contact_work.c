#include "core/observe/contact_work.h"

#include "core/numerics/poly.h"
#include "core/numerics/quadrature.h"
#include "core/numerics/vec.h"

/* Of a collocated step up to s: how force and rate at places s times as far as its nodes follow from those at the nodes,
 * (count x count); of a whole step not asked. */
enum { NODES = THUD_LOBATTO_INNER + 2 };

static void place_nodes(const struct thud_segment_nodes *nodes, double s, double (*out)[NODES])
{
    for (int i = 0; i < nodes->count; i++) {
        double power[NODES] = {1};
        for (int k = 1; k < nodes->count; k++)
            power[k] = power[k - 1] * s * nodes->point[i];
        thud_dots(nodes->count, power, nodes->lagrange, nodes->apart, nodes->count, out[i]);
    }
}

/* Work of a collocated step by its nodes, where its force is the law's. */
static double work_at_nodes(const struct thud_segment_nodes *nodes, int c, double (*places)[NODES], double *impulse)
{
    const thud_vec2 *motion = nodes->motion + nodes->at[c] * nodes->points;
    const double *force = nodes->force + nodes->at[c] * nodes->count;
    double work = 0;
    for (int i = 0; i < nodes->count; i++) {
        thud_vec2 at = {force[i], motion[i][1]};
        if (places) {
            at = thud_vec2_set(0, 0);
            for (int k = 0; k < nodes->count; k++)
                at += places[i][k] * thud_vec2_set(force[k], motion[k][1]);
        }
        work += nodes->weight[i] * at[0] * at[1];
        *impulse += nodes->weight[i] * at[0];
    }
    return work;
}

/* Points of a quadrature, an even number. */
struct points {
    int count;
    const double *node, *weight;
};

/* Work, per second of the segment, and impulse of a contact's force at these points: `applied` times the polynomial that
 * was applied (orders), and where asked for the law's. */
static double force_work(const struct thud_observation *o, int c, const struct points *at, double applied, int orders,
                         bool by_law, double *impulse)
{
    const struct thud_segment *seg = o->seg;
    const double *d = thud_segment_read(o->state, seg, c), rate = 1 / seg->h_s;
    const int nrows = o->state->model->nrows;
    double work = 0;
    for (int i = 0; i < at->count; i += 2) {
        const thud_vec2 s = o->s * thud_vec2_at(at->node + i);
        thud_vec2 x = {0, 0}, v = {0, 0}, f = {0, 0};
        for (int k = seg->terms - 1; k >= 0; k--) {
            v = v * s + x;
            x = x * s + d[k];
        }
        for (int k = orders - 1; k >= 0; k--)
            f = f * s + applied * seg->force[k * nrows + c];
        for (int side = 0; side < 2 && by_law; side++)
            f[side] += thud_row_force(o->state, c, x[side], rate * v[side]);
        f *= thud_vec2_at(at->weight + i);
        work += rate * thud_vec2_sum(f * v);
        *impulse += thud_vec2_sum(f);
    }
    return work;
}

/* Work done on a contact over the segment, per second of it, and its mean force. Of a power series: the work of the force
 * that was applied, and of what the law's differs from it by; that is of the size of the tolerance, and laws are dear: two
 * points are enough. */
static double contact_work(const struct thud_observation *o, int c, double (*places)[NODES], double *impulse)
{
    static const double node[] = {0.21132486540518713, 0.78867513459481287}, half[] = {0.5, 0.5};
    static const struct points all = {THUD_QUADRATURE_POINTS, thud_quadrature_node, thud_quadrature_weight},
                               two = {2, node, half};
    const struct thud_segment *seg = o->seg;
    const bool asks = o->state->contact[c].mode != THUD_STICKING && o->state->locates;
    const int orders = asks && seg->loaded < seg->terms ? seg->loaded : seg->terms;
    if (seg->nodes && seg->nodes->weight)
        return work_at_nodes(seg->nodes, c, o->s == 1 ? NULL : places, impulse);
    if (asks && seg->interpolates)
        return force_work(o, c, &all, 0, 0, true, impulse);
    const double work = force_work(o, c, &all, 1, orders, false, impulse);
    return asks ? work + force_work(o, c, &two, -1, orders, true, impulse) : work;
}

/* A step whose events are not located. */
static int end_works(const struct thud_observation *o, struct thud_contact_work *out)
{
    const struct thud_model *m = o->state->model;
    const struct thud_motion *a = o->seg->start, *b = o->seg->end;
    int n = 0;
    for (int c = 0; c < m->ncontacts && !(a->apart && b->apart && o->state->nactive == 0); c++) {
        double force = 0.5 * (a->force[c] + b->force[c]);
        if (force == 0 && !thud_contact_acts(&o->state->contact[c]))
            continue;
        double work = o->s * force * (thud_model_gap_sum(m, c, b->q) - thud_model_gap_sum(m, c, a->q));
        out[n++] = (struct thud_contact_work){c, work, o->s * force * o->seg->h_s};
    }
    return n;
}

int thud_contact_works(const struct thud_observation *o, struct thud_contact_work *out)
{
    int n = 0;
    double dt = o->s * o->seg->h_s;
    double places[NODES][NODES];
    if (o->seg->end)
        return end_works(o, out);
    if (o->seg->nodes && o->s != 1)
        place_nodes(o->seg->nodes, o->s, places);
    for (int c = 0; c < o->state->model->ncontacts; c++) {
        if (!thud_segment_has_force(o->state, o->seg, c))
            continue;
        double impulse = 0, work = contact_work(o, c, places, &impulse);
        out[n++] = (struct thud_contact_work){c, work * dt, impulse * dt};
    }
    return n;
}
