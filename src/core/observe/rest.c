#include "core/observe/rest.h"

#include <assert.h>
#include <math.h>

void thud_rest_floor(const struct thud_rest *rest, int structure, int floor, double most[THUD_FLOOR_QUANTITIES])
{
    const struct thud_model *m = rest->model;
    const struct thud_model_structure *p = &m->structure[structure];
    assert(structure >= 0 && structure < m->nstructures && floor >= 0 && floor < p->dofs);
    const double *row = p->phi + floor * p->modes;
    double add[THUD_FLOOR_QUANTITIES] = {0};
    for (int j = 0; j < p->modes; j++) {
        double w = m->omega[p->first_mode + j], a = rest->amplitudes[p->first_mode + j], part = fabs(row[j]) * a;
        add[THUD_FLOOR_DISPLACEMENT] += part;
        add[THUD_FLOOR_VELOCITY] += part * w;
        add[THUD_FLOOR_ACCELERATION] += part * w * w * (1 + 2 * m->zeta[p->first_mode + j]);
        add[THUD_FLOOR_DRIFT] += fabs(thud_model_drift(p, p->phi + j, p->modes, floor)) * a;
    }
    for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++)
        most[x] = rest->later[x * m->ndof + p->first + floor] + add[x];
}

double thud_rest_shear(const struct thud_rest *rest, int structure, int storey)
{
    const struct thud_model *m = rest->model;
    const struct thud_model_structure *p = &m->structure[structure];
    const double *row = p->shear + storey * p->modes, *by_drift = p->shear + p->n * (p->modes + storey),
                 *later = rest->later + THUD_FLOOR_DRIFT * m->ndof + p->first;
    double sum = 0;
    for (int j = 0; j < p->modes; j++)
        sum += fabs(row[j]) * rest->amplitudes[p->first_mode + j];
    for (int l = 0; l < p->n; l++)
        sum += fabs(by_drift[l]) * later[l];
    return sum;
}

double thud_rest_lean(const struct thud_rest *rest, int structure, int floor)
{
    const struct thud_model_structure *p = &rest->model->structure[structure];
    double own[THUD_FLOOR_QUANTITIES], turn[THUD_FLOOR_QUANTITIES];
    thud_rest_floor(rest, structure, floor, own);
    thud_rest_floor(rest, structure, p->n + 1, turn);
    return own[THUD_FLOOR_DRIFT] + p->rise[floor] * turn[THUD_FLOOR_DISPLACEMENT];
}

double thud_rest_moment(const struct thud_rest *rest, int structure)
{
    const struct thud_model_structure *p = &rest->model->structure[structure];
    double most[THUD_FLOOR_QUANTITIES], sum = 0;
    for (int i = 0; i < p->n; i++) {
        thud_rest_floor(rest, structure, i, most);
        sum += p->level_m[i] * rest->model->mass_kg[p->first + i] * most[THUD_FLOOR_ACCELERATION];
    }
    return sum;
}

double thud_rest_drift(const struct thud_rest *rest, const struct thud_model_column *column)
{
    double drift = rest->later[THUD_FLOOR_DRIFT * rest->model->ndof + column->dof];
    for (int j = 0; j < column->modes; j++)
        drift += fabs(column->row[j]) * rest->amplitudes[column->first_mode + j];
    return drift;
}
