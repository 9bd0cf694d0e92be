/* KR-alpha: the step's end is explicit in displacement and velocity, through integration parameters that are matrices
 * made from the structure without its contacts; that is why it stays stable for the structure and not in contact.
 *     v1 = v0 + h A1 a0,   q1 = q0 + h v0 + h^2 (1/2 + gamma) A1 a0,   A1 = (I + gamma h D + beta h^2 Omega^2)^-1
 *     (I - A3) a1 + A3 a0 = (1 - af) r(q1, v1) + af r(q0, v0),   A3 = A1 (am + af gamma h D + af beta h^2 Omega^2)
 * Its roots are those of a scheme of order 2, but the velocity is a backward difference: the state is of order 1.
 * The acceleration a is the scheme's own and goes on from step to step. Nothing is located: a contact that is held
 * would need a force that acts through A1, which the scheme does not have. */
#include <math.h>
#include <string.h>

#include "core/methods/method.h"
#include "core/methods/stepping.h"
#include "core/model/modal_operator.h"

static const double rho = 0.5;

struct kr {
    struct thud_modal_operator a1_operator, end_operator; /* A1, and ((1 - am) I + (1 - af)(...))^-1 */
    struct thud_motion start, end, work;
    double *a, *smooth, *rhs, *spare; /* (nmodes); a: the scheme's acceleration */
    double h_made;
    bool started;
};

static enum thud_status create(const struct thud_method *method, const struct thud_state *state, void **own,
                               struct thud_error *err)
{
    (void)method;
    const struct thud_model *m = state->model;
    struct kr *x, to = {0};
    const enum thud_status status =
        THUD_LAY_IN(state->memory, err, THUD_PIECE(x, 1), THUD_MOTION_PIECES(to.start, m),
                    THUD_MOTION_PIECES(to.end, m), THUD_MOTION_PIECES(to.work, m), THUD_PIECE(to.a, m->nmodes),
                    THUD_PIECE(to.smooth, m->nmodes), THUD_PIECE(to.rhs, m->nmodes), THUD_PIECE(to.spare, m->nmodes),
                    THUD_MODAL_OPERATOR_PIECES(to.a1_operator, m), THUD_MODAL_OPERATOR_PIECES(to.end_operator, m));
    if (status == THUD_OK)
        *x = to;
    *own = x;
    return status;
}

/* In the order of the equations above: q1 and v1 by A1 a0; r1 there, with the contact forces of that state; and a1, for
 * which the last equation is multiplied by A1^-1, so that no product of operators has to be made. */
static enum thud_status step(const struct thud_state *state, void *own, struct thud_segment *seg,
                             struct thud_error *err)
{
    (void)err;
    const double am = (2 * rho - 1) / (rho + 1), af = rho / (rho + 1), gamma = 0.5 - am + af;
    const double beta = 0.25 * (0.5 + gamma) * (0.5 + gamma);
    struct kr *x = own;
    const struct thud_model *m = state->model;
    double h = thud_step_length(state), y = gamma * h, z = beta * h * h;
    if (fabs(h - x->h_made) > 1e-11 * h) {
        thud_modal_operator_set(&x->a1_operator, m, 1, y, z);
        thud_modal_operator_set(&x->end_operator, m, 1 - am, (1 - af) * y, (1 - af) * z);
        x->h_made = h;
    }
    memcpy(x->start.q, state->q, (size_t)m->nmodes * sizeof(double));
    memcpy(x->start.qd, state->qd, (size_t)m->nmodes * sizeof(double));
    thud_step_motion(state, &x->start, 0);
    if (!x->started)
        memcpy(x->a, x->start.qdd, (size_t)m->nmodes * sizeof(double));
    x->started = true;
    thud_modal_operator_apply(&x->a1_operator, m, x->a, x->smooth);
    for (int j = 0; j < m->nmodes; j++) {
        x->end.q[j] = state->q[j] + h * state->qd[j] + h * h * (0.5 + gamma) * x->smooth[j];
        x->end.qd[j] = state->qd[j] + h * x->smooth[j];
    }
    thud_step_motion(state, &x->end, h);
    for (int j = 0; j < m->nmodes; j++)
        x->spare[j] = (1 - af) * x->end.qdd[j] + af * x->start.qdd[j];
    thud_modal_forward(m, 1, y, z, x->spare, x->rhs);
    thud_modal_forward(m, am, af * y, af * z, x->a, x->spare);
    for (int j = 0; j < m->nmodes; j++)
        x->rhs[j] -= x->spare[j];
    thud_modal_operator_apply(&x->end_operator, m, x->rhs, x->a);
    thud_step_write(state, seg, h, &x->start, &x->end, &x->work);
    return THUD_OK;
}

const struct thud_method thud_method_kr_alpha = {
    .name = "kr-alpha",
    .title = "KR-alpha, spectral radius 0.5",
    .reference = "Kolay and Ricles, Earthquake Engineering and Structural Dynamics 43 (2014) 1361-1380",
    .summary =
        "explicit, with matrices of the structure in place of numbers; period right to order 2, but velocities lag",
    .flags = THUD_METHOD_FIXED_STEP,
    .order = 1,
    .stability = INFINITY,
    .limits = "none in linear structures; stiff contacts, which its matrices do not know, make it unstable",
    .stepper = &(const struct thud_stepper){create, step, NULL},
};
