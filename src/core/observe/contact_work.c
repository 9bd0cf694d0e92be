#include "core/observe/contact_work.h"

#include "core/numerics/quadrature.h"
#include "core/numerics/vec.h"

/* The integral of f g over [0, 1]; coefficients f (orders) and g (terms). */
static double product_integral(const double *f, int orders, const double *g, int terms)
{
    enum { MOST = 2 * THUD_SEGMENT_TERMS };
    static const double inverse[MOST] = {
        1.0,      1.0 / 2,  1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,  1.0 / 7,  1.0 / 8,  1.0 / 9,  1.0 / 10,
        1.0 / 11, 1.0 / 12, 1.0 / 13, 1.0 / 14, 1.0 / 15, 1.0 / 16, 1.0 / 17, 1.0 / 18, 1.0 / 19, 1.0 / 20,
        1.0 / 21, 1.0 / 22, 1.0 / 23, 1.0 / 24, 1.0 / 25, 1.0 / 26, 1.0 / 27, 1.0 / 28, 1.0 / 29, 1.0 / 30,
        1.0 / 31, 1.0 / 32, 1.0 / 33, 1.0 / 34, 1.0 / 35, 1.0 / 36, 1.0 / 37, 1.0 / 38, 1.0 / 39, 1.0 / 40,
        1.0 / 41, 1.0 / 42, 1.0 / 43, 1.0 / 44, 1.0 / 45, 1.0 / 46, 1.0 / 47, 1.0 / 48};
    double sum = 0;
    for (int i = 0; i < orders; i++)
        sum += f[i] * thud_dot(terms, g, inverse + i);
    return sum;
}

/* What the law's force at points of the piece says beside the polynomial `force` (orders), whose work has been counted:
 * work, per second of the segment, and impulse of the difference. */
static double law_work(const struct thud_observation *o, int c, const double *force, int orders, double *impulse)
{
    /* laws are dear, and of a force polynomial the difference is of the size of the tolerance: two points for it */
    static const double two[] = {0.21132486540518713, 0.78867513459481287}, half[] = {0.5, 0.5};
    const int count = orders > 0 ? 2 : THUD_QUADRATURE_POINTS;
    const double *node = orders > 0 ? two : thud_quadrature_node, *weight = orders > 0 ? half : thud_quadrature_weight;
    const double *d = thud_segment_read(o->state, o->seg, c), rate = 1 / o->seg->h_s;
    double work = 0;
    for (int i = 0; i < count; i += 2) {
        const thud_vec2 s = o->s * thud_vec2_at(node + i);
        thud_vec2 x = {0, 0}, v = {0, 0}, f = {0, 0};
        for (int k = o->seg->terms - 1; k >= 0; k--) {
            v = v * s + x;
            x = x * s + d[k];
        }
        for (int k = orders - 1; k >= 0; k--)
            f = f * s + force[k];
        for (int side = 0; side < 2; side++) {
            const double more = thud_row_force(o->state, c, x[side], rate * v[side]) - f[side];
            work += weight[i + side] * more * rate * v[side];
            *impulse += weight[i + side] * more;
        }
    }
    return work;
}

/* Work of a whole collocated step, by its nodes, where its force is the law's. */
static double work_at_nodes(const struct thud_segment_nodes *nodes, int c, double *impulse)
{
    const thud_vec2 *motion = nodes->motion + nodes->at[c] * nodes->points;
    const double *force = nodes->force + nodes->at[c] * nodes->row;
    double work = 0;
    for (int i = 0; i < nodes->count; i++) {
        const double part =
            force[i] * (i > 0 && i + 1 < nodes->count ? nodes->rule->weight[i - 1] : nodes->rule->end_weight);
        work += part * motion[i][1];
        *impulse += part;
    }
    return work;
}

/* Work done on a contact over the segment, per second of it, and its mean force. Of a power series: the work of the force
 * that was applied, and of what the law's differs from it by. */
static double contact_work(const struct thud_observation *o, int c, double *impulse)
{
    const struct thud_segment *seg = o->seg;
    const bool asks = o->state->contact[c].mode != THUD_STICKING && o->state->locates,
               applies = !asks || !seg->interpolates;
    if (seg->nodes && seg->nodes->rule && o->s == 1)
        return work_at_nodes(seg->nodes, c, impulse);
    const double *d = thud_segment_read(o->state, seg, c), s = o->s;
    const int orders = !applies ? 0 : asks && seg->loaded < seg->terms ? seg->loaded : seg->terms;
    double force[THUD_SEGMENT_TERMS], part[THUD_SEGMENT_TERMS], rate[THUD_SEGMENT_TERMS], work = 0, power = 1;
    static const double one = 1;
    for (int k = 0; k < orders; k++, power *= s) { /* over [0, s] as over [0, 1] */
        force[k] = seg->force[k * o->state->model->nrows + c];
        part[k] = power * force[k];
    }
    power = 1;
    for (int k = 1; k < seg->terms; k++, power *= s)
        rate[k - 1] = k * power * d[k];
    if (applies) {
        work = product_integral(part, orders, rate, seg->terms - 1) / seg->h_s;
        *impulse = product_integral(&one, 1, part, orders);
    }
    return asks ? work + law_work(o, c, force, orders, impulse) : work;
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
    if (o->seg->end)
        return end_works(o, out);
    for (int c = 0; c < o->state->model->ncontacts; c++) {
        if (!thud_segment_has_force(o->state, o->seg, c))
            continue;
        double impulse = 0, work = contact_work(o, c, &impulse);
        out[n++] = (struct thud_contact_work){c, work * dt, impulse * dt};
    }
    return n;
}
