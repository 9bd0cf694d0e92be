/* Indentations, rates, forces and accelerations of the contacts at the run's present state. */
#include <lapacke.h>
#include <math.h>

#include "core/run_private.h"

double thud_contact_indentation(const struct thud_run *run, int c)
{
    return thud_model_gap_sum(run->model, c, run->q) - thud_run_shift(run, c);
}

double thud_contact_rate(const struct thud_run *run, int c)
{
    return thud_model_gap_sum(run->model, c, run->qd);
}

double thud_contact_force(const struct thud_run *run, int c, double d, double v)
{
    const struct thud_contact_state *s = &run->contact[c];
    if (s->mode != THUD_CLOSED)
        return 0;
    double f = thud_branch_force(&s->branch, d, v, NULL, NULL);
    return f < 0 && !(run->model->contact[c].law->flags & THUD_LAW_PULLS) ? 0 : f;
}

void thud_model_acceleration(const struct thud_model *m, const double *q, const double *qd, double ground, double *out)
{
    for (int j = 0; j < m->nmodes; j++)
        out[j] = -m->omega[j] * (m->omega[j] * q[j] + 2 * m->zeta[j] * qd[j]) - m->gamma[j] * ground;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        for (int i = 0; p->damping && i < p->modes; i++)
            for (int j = 0; j < p->modes; j++)
                out[p->first_mode + i] -= p->damping[i * p->modes + j] * qd[p->first_mode + j];
    }
}

void thud_model_push(const struct thud_model *m, const double *force, double *qdd)
{
    for (int c = 0; c < m->ncontacts; c++) {
        if (force[c] == 0.0)
            continue;
        const double *g = m->g + c * m->nmodes;
        for (int j = 0; j < m->nmodes; j++)
            qdd[j] -= g[j] * force[c];
    }
}

static void free_acceleration(const struct thud_run *run, double *out)
{
    double a0, a1;
    thud_run_ground(run, run->grid, &a0, &a1);
    thud_model_acceleration(run->model, run->q, run->qd, a0 + (a1 - a0) * (run->offset_s / run->grid_dt_s), out);
}

static double acceleration(const struct thud_run *run, int c, const double *free, const double *force)
{
    const struct thud_model *m = run->model;
    double a = thud_model_gap_sum(m, c, free);
    for (int b = 0; b < m->ncontacts; b++)
        a -= m->w[c * m->ncontacts + b] * force[b];
    return a;
}

double thud_contact_acceleration(const struct thud_run *run, int c, const double *force)
{
    free_acceleration(run, run->scratch);
    return acceleration(run, c, run->scratch, force);
}

/* W_ss f = a_s: the stuck contacts' forces so that none of them accelerates. */
void thud_contact_hold(const struct thud_run *run, const double *free, double *force)
{
    const struct thud_model *m = run->model;
    int n = 0, nc = m->ncontacts;
    double *rhs = run->scratch + m->nmodes, *w = run->hold;
    for (int c = 0; c < nc; c++)
        if (run->contact[c].mode == THUD_STUCK)
            rhs[n++] = acceleration(run, c, free, force);
    if (n == 0)
        return;
    for (int a = 0, i = 0; a < nc; a++) {
        if (run->contact[a].mode != THUD_STUCK)
            continue;
        for (int b = 0, j = 0; b < nc; b++)
            if (run->contact[b].mode == THUD_STUCK)
                w[i * n + j++] = m->w[a * nc + b];
        i++;
    }
    if (LAPACKE_dposv_work(LAPACK_COL_MAJOR, 'L', n, 1, w, n, rhs, n) != 0)
        return;
    for (int c = 0, i = 0; c < nc; c++)
        if (run->contact[c].mode == THUD_STUCK)
            force[c] = rhs[i++];
}

void thud_contact_forces(const struct thud_run *run, double *force)
{
    bool stuck = false;
    for (int c = 0; c < run->model->ncontacts; c++) {
        force[c] = 0;
        stuck |= run->contact[c].mode == THUD_STUCK;
        if (run->contact[c].mode == THUD_CLOSED)
            force[c] = thud_contact_force(run, c, thud_contact_indentation(run, c), thud_contact_rate(run, c));
    }
    if (!stuck)
        return;
    free_acceleration(run, run->scratch);
    thud_contact_hold(run, run->scratch, force);
}
