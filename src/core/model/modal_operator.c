/* Modal damping makes the operator a number for each mode. Where links or foundations couple the modes of
 * a system, D has a dense block, whose inverse is made once for a length of step and then only multiplied. */
#include "core/model/modal_operator.h"

#include <string.h>

#include "core/numerics/vec.h"

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
