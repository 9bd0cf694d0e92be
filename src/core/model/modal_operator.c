/* Modal damping makes the operator a number for each mode. Where links or foundations couple the modes of
 * a system, D has a dense block, whose inverse is made once for a length of step and then only multiplied. */
#include "core/model/modal_operator.h"

#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

#include "core/numerics/vec.h"

struct thud_modal_operator {
    double *diagonal; /* (nmodes) the inverse */
    double *dense;    /* the inverse blocks of the coupled systems, one after the other, column-major */
    double *work;
    lapack_int *pivot;
};

enum thud_status thud_modal_operator_create(const struct thud_model *model, struct thud_modal_operator **out,
                                            struct thud_error *err)
{
    size_t n = (size_t)model->nmodes, dense = 0;
    for (int i = 0; i < model->nsystems; i++) {
        const struct thud_model_structure *p = &model->structure[model->system[i]];
        if (p->damping)
            dense += (size_t)p->modes * (size_t)p->modes;
    }
    struct thud_modal_operator *op = *out = calloc(1, sizeof *op);
    if (op) {
        op->diagonal = calloc(2 * n + dense + 1, sizeof(double));
        op->pivot = calloc(n + 1, sizeof *op->pivot);
    }
    if (!op || !op->diagonal || !op->pivot) {
        thud_modal_operator_free(op);
        *out = NULL;
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    op->work = op->diagonal + n;
    op->dense = op->work + n;
    return THUD_OK;
}

void thud_modal_operator_free(struct thud_modal_operator *op)
{
    if (!op)
        return;
    free(op->diagonal);
    free(op->pivot);
    free(op);
}

void thud_modal_operator_set(struct thud_modal_operator *op, const struct thud_model *model, double x, double y,
                             double z)
{
    for (int j = 0; j < model->nmodes; j++) {
        double w = model->omega[j];
        op->diagonal[j] = 1 / (x + w * (2 * y * model->zeta[j] + z * w));
    }
    double *block = op->dense;
    for (int s = 0; s < model->nsystems; s++) {
        const struct thud_model_structure *p = &model->structure[model->system[s]];
        if (!p->damping)
            continue;
        for (int j = 0; j < p->modes; j++) {
            double w = model->omega[p->first_mode + j];
            for (int i = 0; i < p->modes; i++)
                block[j * p->modes + i] = y * p->damping[i * p->modes + j] + (i == j ? x + z * w * w : 0);
        }
        /* x > 0 and y, z >= 0 with D symmetric and not negative: regular */
        LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, p->modes, p->modes, block, p->modes, op->pivot);
        LAPACKE_dgetri_work(LAPACK_COL_MAJOR, p->modes, block, p->modes, op->pivot, op->work, p->modes);
        block += p->modes * p->modes;
    }
}

void thud_modal_operator_apply(const struct thud_modal_operator *op, const struct thud_model *model,
                               const double *restrict in, double *restrict out)
{
    const double *diagonal = op->diagonal;
    for (int j = 0; j < model->nmodes; j++)
        out[j] = diagonal[j] * in[j];
    const double *block = op->dense;
    for (int s = 0; s < model->nsystems; s++) {
        const struct thud_model_structure *p = &model->structure[model->system[s]];
        if (!p->damping)
            continue;
        memset(out + p->first_mode, 0, (size_t)p->modes * sizeof *out);
        thud_add_rows(p->modes, p->modes, 1, in + p->first_mode, block, out + p->first_mode);
        block += p->modes * p->modes;
    }
}

void thud_modal_forward(const struct thud_model *model, double x, double y, double z, const double *in, double *out)
{
    for (int j = 0; j < model->nmodes; j++) {
        double w = model->omega[j];
        out[j] = (x + w * (2 * y * model->zeta[j] + z * w)) * in[j];
    }
    for (int s = 0; s < model->nsystems; s++) {
        const struct thud_model_structure *p = &model->structure[model->system[s]];
        for (int i = 0; p->damping && i < p->modes; i++)
            for (int j = 0; j < p->modes; j++)
                out[p->first_mode + i] += y * p->damping[i * p->modes + j] * in[p->first_mode + j];
    }
}
