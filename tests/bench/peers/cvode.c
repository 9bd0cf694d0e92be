/* The towers by SUNDIALS CVODE with root finding, beside thud's exact method: for measuring only. The right-hand side
 * is written here from the model's modes and the law's branches, with the force cut at 0; every switch of a contact is
 * a root and the integrator starts again there. Prints method, tolerance, seconds of processor time and error.
 * usage: cvode PRESET CASE KEY=VALUE... */
#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "../scene.h"

enum { MOST = 64, ROOTS = 4, INSIDE = 6 };

struct contact {
    enum thud_phase phase;
    bool past, closed;
    struct thud_law_memory memory;
};

struct problem {
    const struct thud_model *model;
    const struct thud_record *record;
    struct contact contact[MOST];
    double peak[MOST];
};

static double ground(const struct problem *p, double t)
{
    double at = t / p->record->dt_s;
    size_t i = at > 0 ? (size_t)at : 0;
    if (i + 1 >= p->record->samples)
        return 0;
    return p->record->a_mps2[i] + (at - (double)i) * (p->record->a_mps2[i + 1] - p->record->a_mps2[i]);
}

static double force(const struct problem *p, int c, const double *y, double *d, double *v)
{
    const struct thud_model *m = p->model;
    const struct thud_model_contact *k = &m->contact[c];
    const struct contact *s = &p->contact[c];
    *d = -k->clearance_m;
    *v = 0;
    for (int j = 0; j < m->nmodes; j++) {
        *d += m->jacobian[c * m->nmodes + j] * y[j];
        *v += m->jacobian[c * m->nmodes + j] * y[m->nmodes + j];
    }
    struct thud_branch b = k->law->branch(&k->setup, &s->memory, s->phase, s->past);
    return thud_branch_force(&b, *d, *v, NULL, NULL);
}

static int slope(double t, N_Vector state, N_Vector out, void *data)
{
    struct problem *p = data;
    const struct thud_model *m = p->model;
    const double *y = N_VGetArrayPointer(state);
    double *dy = N_VGetArrayPointer(out), a = ground(p, t), d, v;
    int n = m->nmodes;
    for (int j = 0; j < n; j++) {
        dy[j] = y[n + j];
        dy[n + j] = -2 * m->zeta[j] * m->omega[j] * y[n + j] - m->omega[j] * m->omega[j] * y[j] - m->gamma[j] * a;
    }
    for (int c = 0; c < m->ncontacts; c++) {
        double f = p->contact[c].closed ? fmax(0, force(p, c, y, &d, &v)) : 0;
        for (int j = 0; f > 0 && j < n; j++)
            dy[n + j] -= m->jacobian[c * n + j] * f;
    }
    return 0;
}

/* Indentation, its rate, the force and the knee of every contact. */
static int roots(double t, N_Vector state, double *out, void *data)
{
    struct problem *p = data;
    const double *y = N_VGetArrayPointer(state);
    (void)t;
    for (int c = 0; c < p->model->ncontacts; c++) {
        const struct thud_model_contact *k = &p->model->contact[c];
        double d, v, f = force(p, c, y, &d, &v), *r = out + ROOTS * c;
        bool closed = p->contact[c].closed;
        r[0] = d;
        r[1] = closed ? v : 1;
        r[2] = closed ? f : 1;
        r[3] = closed && k->law->ultimate ? d - thud_law_ultimate(k->law, &k->setup, &s->memory, s->phase) : 1;
    }
    return 0;
}

static void switch_contacts(struct problem *p, const double *y, const int *found)
{
    for (int c = 0; c < p->model->ncontacts; c++) {
        const struct thud_model_contact *k = &p->model->contact[c];
        struct contact *s = &p->contact[c];
        double d, v;
        force(p, c, y, &d, &v);
        if (found[ROOTS * c] > 0 && !s->closed) {
            *s = (struct contact){.phase = THUD_APPROACH, .closed = true, .memory = s->memory};
            thud_law_onset(k->law, &k->setup, v, &s->memory);
        } else if (found[ROOTS * c] < 0) {
            s->closed = false;
        }
        if (s->closed && found[ROOTS * c + 1] != 0) {
            s->phase = found[ROOTS * c + 1] < 0 ? THUD_RESTITUTION : THUD_APPROACH;
            thud_law_reversal(k->law, &k->setup, s->phase, d, &s->memory);
        }
        if (s->closed && found[ROOTS * c + 3] != 0)
            s->past = found[ROOTS * c + 3] > 0;
    }
}

/* Total accelerations of the floors. */
static void accelerations(struct problem *p, double t, N_Vector y, N_Vector scratch, double *a)
{
    const struct thud_model *m = p->model;
    slope(t, y, scratch, p);
    const double *dy = N_VGetArrayPointer(scratch);
    for (int i = 0; i < m->ndof; i++) {
        const struct thud_model_structure *s = &m->structure[m->dof_structure[i]];
        a[i] = ground(p, t);
        for (int j = 0; j < s->modes; j++)
            a[i] += s->phi[(i - s->first) * s->modes + j] * dy[m->nmodes + s->first_mode + j];
    }
}

/* The largest of three values at equal steps, or of the parabola through them. */
static double vertex(double a, double b, double c)
{
    double bend = a - 2 * b + c, rise = 0.5 * (c - a);
    double most = fmax(fabs(a), fmax(fabs(b), fabs(c)));
    return fabs(rise) < fabs(bend) ? fmax(most, fabs(b - 0.5 * rise * rise / bend)) : most;
}

/* Peaks inside a step from t0 to t1, looked for where its ends come near the largest yet. a0, a1: accelerations there.
 */
static void look(struct problem *p, void *cvode, double t0, double t1, N_Vector y, N_Vector scratch, const double *a0,
                 const double *a1)
{
    double a[INSIDE + 1][MOST];
    bool near = false;
    for (int i = 0; i < p->model->ndof; i++) {
        double end = fmax(fabs(a0[i]), fabs(a1[i]));
        near = near || end > 0.7 * p->peak[i];
        p->peak[i] = fmax(p->peak[i], end);
    }
    if (!near)
        return;
    memcpy(a[0], a0, sizeof a[0]);
    memcpy(a[INSIDE], a1, sizeof a[0]);
    for (int k = 1; k < INSIDE; k++) {
        double t = t0 + (t1 - t0) * k / INSIDE;
        CVodeGetDky(cvode, t, 0, y);
        accelerations(p, t, y, scratch, a[k]);
    }
    for (int k = 1; k < INSIDE; k++)
        for (int i = 0; i < p->model->ndof; i++)
            p->peak[i] = fmax(p->peak[i], vertex(a[k - 1][i], a[k][i], a[k + 1][i]));
}

static int integrate(struct problem *p, int lmm, double tolerance, double end_s, SUNContext context)
{
    int n = 2 * p->model->nmodes, status = CV_SUCCESS, found[ROOTS * MOST];
    N_Vector y = N_VNew_Serial(n, context), inside = N_VNew_Serial(n, context), scratch = N_VNew_Serial(n, context);
    void *cvode = CVodeCreate(lmm, context);
    SUNMatrix matrix = SUNDenseMatrix(n, n, context);
    SUNLinearSolver linear = SUNLinSol_Dense(y, matrix, context);
    SUNNonlinearSolver fixed = SUNNonlinSol_FixedPoint(y, 0, context);
    double t = 0, before = 0, scale = 0, a0[MOST] = {0}, a1[MOST];
    N_VConst(0, y);
    memset(p->contact, 0, sizeof p->contact);
    memset(p->peak, 0, sizeof p->peak);
    CVodeInit(cvode, slope, 0, y);
    /* a centimetre in modal coordinates, gamma being the root of a modal mass */
    for (int j = 0; j < p->model->nmodes; j++)
        scale = fmax(scale, 0.01 * fabs(p->model->gamma[j]));
    CVodeSStolerances(cvode, tolerance, scale * tolerance);
    CVodeSetUserData(cvode, p);
    if (lmm == CV_BDF)
        CVodeSetLinearSolver(cvode, linear, matrix);
    else
        CVodeSetNonlinearSolver(cvode, fixed);
    CVodeRootInit(cvode, ROOTS * p->model->ncontacts, roots);
    CVodeSetNoInactiveRootWarn(cvode);
    CVodeSetMaxStep(cvode, p->record->dt_s);
    CVodeSetStopTime(cvode, end_s);
    while (status >= 0 && t < end_s) {
        status = CVode(cvode, end_s, y, &t, CV_ONE_STEP);
        accelerations(p, t, y, scratch, a1);
        look(p, cvode, before, t, inside, scratch, a0, a1);
        if (status == CV_ROOT_RETURN) {
            CVodeGetRootInfo(cvode, found);
            switch_contacts(p, N_VGetArrayPointer(y), found);
            accelerations(p, t, y, scratch, a1); /* the other side of the jump */
            for (int i = 0; i < p->model->ndof; i++)
                p->peak[i] = fmax(p->peak[i], fabs(a1[i]));
            CVodeReInit(cvode, t, y);
        }
        before = t;
        memcpy(a0, a1, sizeof a0);
    }
    SUNNonlinSolFree(fixed);
    SUNLinSolFree(linear);
    SUNMatDestroy(matrix);
    CVodeFree(&cvode);
    N_VDestroy(scratch);
    N_VDestroy(inside);
    N_VDestroy(y);
    return status;
}

int main(int argc, char **argv)
{
    static struct bench_scene scene;
    static struct bench_solution reference, other;
    static struct problem p;
    SUNContext context;
    bench_scene_open(&scene, argc, argv);
    p.model = scene.model;
    p.record = scene.record;
    if (!p.record || p.model->ndof > MOST || SUNContext_Create(NULL, &context) != 0) {
        fprintf(stderr, "cvode: at most %d floors, and a ground motion\n", MOST);
        return 1;
    }
    bench_scene_reference(&scene, &reference, &other);
    for (int lmm = CV_ADAMS; lmm <= CV_BDF; lmm++)
        for (double tolerance = 1e-4; tolerance > 5e-11; tolerance /= 10) {
            double from = bench_processor_s();
            int status = integrate(&p, lmm, tolerance, reference.end_s, context);
            if (status >= 0)
                printf("cvode-%s,%.0e,%.6g,%.3e\n", lmm == CV_BDF ? "bdf" : "adams", tolerance,
                       bench_processor_s() - from, bench_scene_error(&scene, p.peak, &reference));
            fflush(stdout);
        }
    SUNContext_Free(&context);
    bench_scene_close(&scene);
    return 0;
}
