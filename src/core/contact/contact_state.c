/* Energies of the structures, and indentations, rates, forces and accelerations of the contacts, at a state. */
#include "core/contact/contact_state.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/arena.h"
#include "core/contact/storey.h"
#include "core/numerics/lcp.h"
#include "core/numerics/vec.h"

/* The workspace of impulses is made where a law has impulses: it is as large as the square of the contacts. */
enum thud_status thud_state_init(struct thud_state *state, const struct thud_model *model,
                                 const struct thud_record *record, struct thud_work *work, struct thud_blocks *memory,
                                 struct thud_error *err)
{
    size_t n = (size_t)model->nmodes, nc = (size_t)model->nrows;
    *state = (struct thud_state){.model = model,
                                 .record = record,
                                 .work = work,
                                 .memory = memory,
                                 .fastest_radps = model->fastest_radps,
                                 .step_cap_s = INFINITY};
    bool impulsive = false;
    for (int c = 0; c < model->ncontacts; c++)
        impulsive |= (model->contact[c].law->flags & THUD_LAW_IMPULSIVE) != 0;
    const size_t work_size = nc * nc + thud_lcp_work((int)nc);
    const enum thud_status status = THUD_LAY_IN(
        memory, err, THUD_PIECE(state->q, n), THUD_PIECE(state->qd, n), THUD_PIECE(state->free_mps2, n + nc),
        THUD_PIECE(state->force_now, nc), THUD_PIECE(state->delassus, work_size),
        THUD_PIECE(state->collide, impulsive ? 4 * nc + work_size : 0), THUD_PIECE(state->contact, model->ncontacts),
        THUD_PIECE(state->storey, model->nstoreys), THUD_PIECE(state->set_now, 2 * nc), THUD_PIECE(state->powers, 1));
    if (status != THUD_OK)
        return status;
    memcpy(state->q, model->q0, n * sizeof *state->q);
    memcpy(state->qd, model->qd0, n * sizeof *state->qd);
    return THUD_OK;
}

double thud_state_kinetic(const struct thud_state *state)
{
    return 0.5 * thud_dot(state->model->nmodes, state->qd, state->qd);
}

double thud_state_strain(const struct thud_state *state)
{
    double sum = 0;
    for (int j = 0; j < state->model->nmodes; j++)
        sum += state->model->omega[j] * state->model->omega[j] * state->q[j] * state->q[j];
    return 0.5 * sum + thud_storeys_strain(state, state->q);
}

/* A storey of height h under weight W leans by d and lets its weight sink by d^2/(2 h): geometric_npm is W/h. */
double thud_model_gravity_work(const struct thud_model *model, const double *q)
{
    double sum = 0;
    for (int s = 0; s < model->nstructures && model->collapses; s++) {
        const struct thud_model_structure *p = &model->structure[s];
        double below = p->geometric_npm && p->dofs > p->n ? thud_model_floor(model, p->first + p->n, q) : 0;
        for (int i = 0; p->geometric_npm && i < p->n; i++) {
            double here = thud_model_floor(model, p->first + i, q), drift = here - below;
            sum += 0.5 * p->geometric_npm[i] * drift * drift;
            below = here;
        }
    }
    return sum;
}

double thud_state_default_step(const struct thud_state *state)
{
    double shortest = state->fastest_radps > 0 ? 2 * acos(-1) / state->fastest_radps : INFINITY;
    for (int c = 0; c < state->model->ncontacts; c++)
        shortest = fmin(shortest, thud_model_contact_period(&state->model->contact[c]));
    return fmin(shortest / 20, state->record ? state->record->dt_s : state->end_s / 20);
}

enum thud_status thud_state_too_few_modes(const struct thud_state *state, struct thud_error *err)
{
    return thud_error_refuse(err, THUD_DIVERGED, "modes", "more of them, or all",
                             "more contacts are closed at once than the modes can distinguish, at t = %.6g s",
                             thud_state_now(state));
}

double thud_contact_indentation(const struct thud_state *state, int c)
{
    return thud_model_gap_sum(state->model, c, state->q) - thud_state_clearance(state, c);
}

double thud_contact_stored(const struct thud_state *state, int c)
{
    const struct thud_model_contact *p = &state->model->contact[c];
    const struct thud_contact_state *s = &state->contact[c];
    if (s->mode == THUD_OPEN)
        return 0;
    return thud_law_energy(p->law, &p->setup, &s->memory, s->phase, thud_contact_indentation(state, c));
}

double thud_contact_rate(const struct thud_state *state, int c)
{
    return thud_model_gap_sum(state->model, c, state->qd);
}

void thud_contact_motion(const struct thud_state *state, int c, double *out)
{
    thud_model_gap_pair(state->model, c, state->q, (int)(state->qd - state->q), out);
    out[0] -= thud_state_clearance(state, c);
}

double thud_row_force(const struct thud_state *state, int row, double d, double v)
{
    if (!thud_row_by_branch(state, row))
        return 0;
    const bool pulls = !thud_row_contact(state, row) || (state->model->contact[row].law->flags & THUD_LAW_PULLS) != 0;
    double f = thud_branch_force(thud_row_branch(state, row), d, v, NULL, NULL);
    return f < 0 && !pulls ? 0 : f;
}

double thud_row_force_noise(const struct thud_state *state, int row, double fd, double fv)
{
    double left, right, left_rate, right_rate;
    thud_model_sides(state->model, row, state->q, &left, &right);
    thud_model_sides(state->model, row, state->qd, &left_rate, &right_rate);
    double d = thud_state_clearance(state, row) + fabs(left) + fabs(right), v = fabs(left_rate) + fabs(right_rate);
    return THUD_TOL_STATE * (fabs(fd) * d + fabs(fv) * v);
}

void thud_model_acceleration(const struct thud_model *m, const double *q, const double *qd, double ground,
                             double *restrict out)
{
    const double *spring = m->spring, *dashpot = m->dashpot, *gamma = m->gamma;
    for (int j = 0; j < m->nmodes; j++)
        out[j] = -spring[j] * q[j] - dashpot[j] * qd[j] - gamma[j] * ground;
    for (int s = 0; s < m->nsystems && m->couples; s++) {
        const struct thud_model_structure *p = &m->structure[m->system[s]];
        if (p->damping)
            thud_add_rows(p->modes, p->modes, -1, qd + p->first_mode, p->damping, out + p->first_mode);
    }
}

void thud_model_apply_contact_forces(const struct thud_model *m, const double *force, double *qdd)
{
    for (int c = 0; c < m->nrows; c++)
        if (force[c] != 0.0)
            thud_model_apply_contact_force(m, c, force[c], qdd);
}

/* q'' now if no contact had a force, out (nmodes). */
static void free_acceleration(const struct thud_state *state, double *out)
{
    double a0, a1;
    thud_state_ground(state, state->grid, &a0, &a1);
    thud_model_acceleration(state->model, state->q, state->qd, a0 + (a1 - a0) * (state->offset_s / state->grid_dt_s),
                            out);
}

/* d'' of contact c: g_c q''_free - sum_b W_cb F_b, W the Delassus matrix g_c . g_b, 1/kg. */
static double acceleration(const struct thud_state *state, int c, const double *free, const double *force)
{
    const struct thud_model *m = state->model;
    double a = thud_model_gap_sum(m, c, free);
    for (int b = 0; b < m->nrows; b++)
        a -= m->delassus[c * m->nrows + b] * force[b];
    return a;
}

double thud_contact_acceleration(const struct thud_state *state, int c, const double *force)
{
    free_acceleration(state, state->free_mps2);
    return acceleration(state, c, state->free_mps2, force);
}

/* W_ss f = a_s: the sticking contacts' forces so that none of them accelerates. */
void thud_contact_constraint_forces(const struct thud_state *state, const double *free, double *force)
{
    const struct thud_model *m = state->model;
    int n = 0, nc = m->ncontacts;
    double *rhs = state->free_mps2 + m->nmodes, *w = state->delassus;
    for (int c = 0; c < nc; c++)
        if (state->contact[c].mode == THUD_STICKING)
            rhs[n++] = acceleration(state, c, free, force);
    if (n == 0)
        return;
    for (int a = 0, i = 0; a < nc; a++) {
        if (state->contact[a].mode != THUD_STICKING)
            continue;
        for (int b = 0, j = 0; b < nc; b++)
            if (state->contact[b].mode == THUD_STICKING)
                w[i * n + j++] = m->delassus[a * m->nrows + b];
        i++;
    }
    if (!thud_semidefinite_solve(n, w, rhs, w + n * n))
        return;
    for (int c = 0, i = 0; c < nc; c++)
        if (state->contact[c].mode == THUD_STICKING)
            force[c] = rhs[i++];
}

void thud_contact_forces(const struct thud_state *state, double *force)
{
    thud_contact_forces_given(state, -1, 0, force);
}

/* A sticking contact's force depends on all others', and is found last. */
void thud_contact_forces_given(const struct thud_state *state, int given, double given_n, double *force)
{
    bool sticking = false;
    assert(given < state->model->ncontacts && (given < 0 || state->contact[given].mode != THUD_STICKING));
    for (int c = 0; c < state->model->ncontacts; c++) {
        force[c] = c == given ? given_n : 0;
        sticking |= state->contact[c].mode == THUD_STICKING;
        if (state->contact[c].mode == THUD_CLOSED && c != given)
            force[c] = thud_row_force(state, c, thud_contact_indentation(state, c), thud_contact_rate(state, c));
    }
    for (int k = 0; k < state->model->nstoreys; k++) {
        int row = state->model->ncontacts + k;
        double slope;
        force[row] = thud_storey_force(state, k, thud_contact_indentation(state, row), &slope);
    }
    if (!sticking)
        return;
    free_acceleration(state, state->free_mps2);
    thud_contact_constraint_forces(state, state->free_mps2, force);
}
