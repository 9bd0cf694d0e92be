#include "core/methods/stepping.h"

#include <math.h>
#include <string.h>

#include "core/contact/storey.h"
#include "core/numerics/tolerance.h"
#include "core/numerics/vec.h"

/* Two orders more than the quintic has: the acceleration, read from it by the equations of motion, is a quintic too. */
enum { TERMS = 8, POINTS = 5 };

size_t thud_motion_size(const struct thud_model *model)
{
    return 3 * (size_t)model->nmodes + (size_t)model->nrows;
}

double *thud_motion_place(struct thud_motion *motion, const struct thud_model *model, double *block)
{
    motion->q = block;
    motion->qd = block + model->nmodes;
    motion->qdd = block + 2 * model->nmodes;
    motion->force = block + 3 * model->nmodes;
    return motion->force + model->nrows;
}

double thud_step_room(const struct thud_state *state)
{
    return thud_smaller(thud_state_remaining(state), state->step_cap_s);
}

double thud_step_length(const struct thud_state *state)
{
    double remaining = thud_step_room(state);
    return remaining / thud_larger(1, ceil(remaining / state->step_s * (1 - THUD_TOL_STEP_COUNT)));
}

/* The law where nothing is located: what the contact remembers counts if it is closed, else it touches just now. */
static double unlocated_force(const struct thud_state *state, int c, double d, double v, double *df_dd, double *df_dv)
{
    const struct thud_model_contact *p = &state->model->contact[c];
    const struct thud_contact_state *s = &state->contact[c];
    struct thud_law_memory memory = s->memory;
    *df_dd = *df_dv = 0;
    if (d <= 0 || p->law->flags & (THUD_LAW_NO_FORCE | THUD_LAW_IMPULSIVE))
        return 0;
    if (s->mode == THUD_OPEN)
        thud_law_onset(p->law, &p->setup, fmax(v, 0), &memory);
    enum thud_phase phase = p->law->flags & THUD_LAW_REVERSES && v < 0 ? THUD_RESTITUTION : THUD_APPROACH;
    if (phase != (s->mode == THUD_OPEN ? THUD_APPROACH : s->phase))
        thud_law_reversal(p->law, &p->setup, phase, d, &memory);
    struct thud_branch branch = thud_law_branch_at(p->law, &p->setup, &memory, phase, d);
    double force = thud_branch_force(&branch, d, v, df_dd, df_dv);
    if (force >= 0 || p->law->flags & THUD_LAW_PULLS)
        return force;
    *df_dd = *df_dv = 0;
    return 0;
}

/* A storey that yields: located, by its branch; else by the return to the bound. */
static double storey_force(const struct thud_state *state, int c, double d, double *df_dd, double *df_dv)
{
    const struct thud_branch *b = thud_row_branch(state, c);
    *df_dv = 0;
    if (!state->locates)
        return thud_storey_force(state, c - state->model->ncontacts, d, df_dd);
    *df_dd = b->k_npm;
    return b->f0_n + b->k_npm * d;
}

double thud_step_force(const struct thud_state *state, int c, double d, double v, double *df_dd, double *df_dv)
{
    double dummy[2];
    df_dd = df_dd ? df_dd : &dummy[0];
    df_dv = df_dv ? df_dv : &dummy[1];
    if (c >= state->model->ncontacts)
        return storey_force(state, c, d, df_dd, df_dv);
    if (!state->locates) {
        state->work->force_evaluations += d > 0;
        return unlocated_force(state, c, d, v, df_dd, df_dv);
    }
    *df_dd = *df_dv = 0;
    if (state->contact[c].mode != THUD_CLOSED)
        return 0;
    state->work->force_evaluations++;
    return thud_branch_force(&state->contact[c].branch, d, v, df_dd, df_dv);
}

void thud_step_motion(const struct thud_state *state, struct thud_motion *x, double after)
{
    const struct thud_model *m = state->model;
    bool sticking = false;
    thud_model_acceleration(m, x->q, x->qd, thud_step_ground(state, after), x->qdd);
    memset(x->force, 0, (size_t)m->nrows * sizeof *x->force);
    x->apart = !state->locates;
    if (state->locates && thud_state_is_free(state) && state->nshifted == 0)
        return;
    for (int c = 0; c < m->ncontacts; c++) {
        sticking |= state->contact[c].mode == THUD_STICKING;
        if (state->locates && state->contact[c].mode != THUD_CLOSED)
            continue;
        double d = thud_model_gap_sum(m, c, x->q) - thud_state_clearance(state, c);
        x->apart = x->apart && d <= 0;
        if (d > 0 || state->locates)
            x->force[c] = thud_step_force(state, c, d, thud_model_gap_sum(m, c, x->qd), NULL, NULL);
    }
    for (int c = m->ncontacts; c < m->nrows; c++)
        x->force[c] = thud_step_force(state, c, thud_model_gap_sum(m, c, x->q), 0, NULL, NULL);
    if (sticking)
        thud_contact_constraint_forces(state, x->qdd, x->force);
    thud_model_apply_contact_forces(m, x->force, x->qdd);
}

void thud_step_motion_change(const struct thud_state *state, const struct thud_motion *x, struct thud_motion *change)
{
    const struct thud_model *m = state->model;
    bool sticking = false;
    thud_model_acceleration(m, change->q, change->qd, 0, change->qdd);
    memset(change->force, 0, (size_t)m->nrows * sizeof *change->force);
    for (int c = 0; c < m->nrows; c++) {
        const struct thud_contact_state *contact = thud_row_contact(state, c);
        double d = thud_model_gap_sum(m, c, x->q) - thud_state_clearance(state, c), left, right, by_d, by_v,
               more_d = thud_model_gap_sum(m, c, change->q), more_v = thud_model_gap_sum(m, c, change->qd);
        sticking |= thud_row_sticks(state, c);
        if (contact && (state->locates ? contact->mode != THUD_CLOSED : d <= 0))
            continue;
        thud_model_sides(m, c, x->qd, &left, &right);
        thud_step_force(state, c, d, left - right, &by_d, &by_v);
        if (fabs(more_d) > state->touch_m)
            change->force[c] += by_d * more_d;
        if (fabs(more_v) > THUD_TOL_RATE * (fabs(left) + fabs(right)))
            change->force[c] += by_v * more_v;
    }
    if (sticking)
        thud_contact_constraint_forces(state, change->qdd, change->force);
    thud_model_apply_contact_forces(m, change->force, change->qdd);
}

/* Hermite's quintic through q, q', q'' at s = 0 and s = 1, in powers of s. The run goes on from the state at s = 1, so
 * that has to be the method's own to the last bit; between, the quintic is of order 6 and adds no error that counts. */
static void write_motion(const struct thud_state *state, struct thud_segment *seg, const struct thud_motion *start,
                         const struct thud_motion *end)
{
    int n = state->model->nmodes;
    double *c = seg->q, h = seg->h_s;
    memset(c + 6 * n, 0, (TERMS - 6) * (size_t)n * sizeof *c);
    for (int j = 0; j < n; j++) {
        double d = end->q[j] - start->q[j], v0 = h * start->qd[j], v1 = h * end->qd[j];
        double a0 = h * h * start->qdd[j], a1 = h * h * end->qdd[j], by_rates = 0.5 * (v0 + v1) + (a0 - a1) / 12;
        /* in a short step the difference of positions is rounding, and would be one of rates, larger by 1/h */
        if (fabs(d - by_rates) <= THUD_TOL_POSITION * (fabs(start->q[j]) + fabs(end->q[j])))
            d = by_rates;
        c[j] = start->q[j];
        c[n + j] = v0;
        c[2 * n + j] = 0.5 * a0;
        c[3 * n + j] = 10 * d - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1;
        c[4 * n + j] = -15 * d + 8 * v0 + 7 * v1 + 1.5 * a0 - a1;
        c[5 * n + j] = 6 * d - 3 * (v0 + v1) - 0.5 * (a0 - a1);
    }
}

/* Coefficients of the quartic through values at s = 0, 1/4, 1/2, 3/4, 1. */
static void quartic(const double *f, double *c, int stride)
{
    c[0] = f[0];
    c[stride] = (-25 * f[0] + 48 * f[1] - 36 * f[2] + 16 * f[3] - 3 * f[4]) / 3;
    c[2 * stride] = (70 * f[0] - 208 * f[1] + 228 * f[2] - 112 * f[3] + 22 * f[4]) / 3;
    c[3 * stride] = (-80 * f[0] + 288 * f[1] - 384 * f[2] + 224 * f[3] - 48 * f[4]) / 3;
    c[4 * stride] = (32 * f[0] - 128 * f[1] + 192 * f[2] - 128 * f[3] + 32 * f[4]) / 3;
}

/* Value at s = 0 of the cubic through the points after it. */
static double start_of_cubic(const double f[POINTS])
{
    return 4 * f[1] - 6 * f[2] + 4 * f[3] - f[4];
}

/* Whether a force that begins with the step jumps there rather than rises, as c v does under damping that goes with a low
 * power of the indentation: the cubic through the other points then lies nearer to `eighth`, its value at s = 1/8. The
 * quartic overshoots between the first two points however short the step is. */
static bool jumps(const double f[POINTS], double eighth)
{
    const double weight = 35.0 / 128, /* of f[0] in the quartic's value at 1/8 */
        by_others = (35 * 4 * f[1] - 70 * f[2] + 28 * f[3] - 5 * f[4]) / 128,
                 by_cubic = by_others + weight * start_of_cubic(f);
    return fabs(by_others + weight * f[0] - eighth) > fabs(by_cubic - eighth);
}

/* Forces of the rows at s into out. */
static void forces_at(const struct thud_state *state, const struct thud_segment *seg, double s,
                      struct thud_motion *work, double *out)
{
    thud_segment_state(seg, state->model->nmodes, s, work->q, work->qd);
    thud_step_motion(state, work, s * seg->h_s);
    memcpy(out, work->force, (size_t)state->model->nrows * sizeof *out);
}

/* Forces along the quintic: the laws at five points in the step and the quartic through them, of each row. */
static void write_forces(const struct thud_state *state, struct thud_segment *seg, const struct thud_motion *start,
                         const struct thud_motion *end, struct thud_motion *work)
{
    const int nc = state->model->nrows;
    bool begins = false;
    memcpy(seg->force, start->force, (size_t)nc * sizeof *seg->force); /* values at the points, and then coefficients */
    memcpy(seg->force + (POINTS - 1) * nc, end->force, (size_t)nc * sizeof *seg->force);
    for (int i = 1; i < POINTS - 1; i++)
        forces_at(state, seg, (double)i / (POINTS - 1), work, seg->force + i * nc);
    for (int c = 0; c < nc; c++)
        begins = begins || (start->force[c] == 0 && seg->force[nc + c] != 0);
    if (begins)
        forces_at(state, seg, 1.0 / 8, work, seg->force + POINTS * nc);
    for (int c = 0; c < nc; c++) {
        double value[POINTS];
        for (int i = 0; i < POINTS; i++)
            value[i] = seg->force[i * nc + c];
        if (value[0] == 0 && value[1] != 0 && jumps(value, seg->force[POINTS * nc + c]))
            value[0] = start_of_cubic(value);
        seg->force[POINTS * nc + c] = 0;
        quartic(value, seg->force + c, nc);
    }
}

void thud_step_write(const struct thud_state *state, struct thud_segment *seg, double h,
                     const struct thud_motion *start, const struct thud_motion *end, struct thud_motion *work)
{
    const struct thud_model *m = state->model;
    int nc = m->nrows;
    seg->end_energy = thud_energy_sum(m->nmodes, m->spring, end->q, end->qd);
    if (!state->inside) { /* its ends alone: no series is made */
        thud_segment_ground(state, seg, state->grid, state->offset_s, h);
        seg->interpolates = true;
        seg->start = start;
        seg->end = end;
        seg->terms = 0;
        seg->steps = 1;
        return;
    }
    thud_segment_begin(state, seg, h, TERMS);
    seg->interpolates = true;
    if (!state->locates && state->model->nstoreys == 0) {
        seg->start = start;
        seg->end = end;
    }
    write_motion(state, seg, start, end);
    if (state->locates && !thud_state_is_free(state))
        write_forces(state, seg, start, end, work);
    for (int c = 0; c < nc && !state->locates; c++) {
        seg->force[c] = start->force[c];
        seg->force[nc + c] = end->force[c] - start->force[c];
    }
}
