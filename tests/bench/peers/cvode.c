/* The towers by SUNDIALS CVODE with root finding, beside thud's exact method: for measuring only. The right-hand side
 * is written here from the model's modes and the law's branches, with the force cut at 0; every switch of a contact is
 * a root and the integrator starts again there.
 * usage: cvode CASE KEY=VALUE... */
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
#include <time.h>

#include "app/session.h"

enum { MOST = 64, ROOTS = 4 };

struct contact {
    enum thud_phase phase;
    bool past, closed;
    struct thud_law_memory memory;
};

struct problem {
    const struct thud_model *model;
    const struct thud_record *record;
    struct contact contact[MOST];
    double peak[MOST], reference[MOST];
    long calls;
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
    for (int j = 0; j < m->ndof; j++) {
        *d += m->g[c * m->ndof + j] * y[j];
        *v += m->g[c * m->ndof + j] * y[m->ndof + j];
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
    int n = m->ndof;
    p->calls++;
    for (int j = 0; j < n; j++) {
        dy[j] = y[n + j];
        dy[n + j] = -2 * m->zeta[j] * m->omega[j] * y[n + j] - m->omega[j] * m->omega[j] * y[j] - m->gamma[j] * a;
    }
    for (int c = 0; c < m->ncontacts; c++) {
        double f = p->contact[c].closed ? fmax(0, force(p, c, y, &d, &v)) : 0;
        for (int j = 0; f > 0 && j < n; j++)
            dy[n + j] -= m->g[c * n + j] * f;
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
        r[3] = closed && k->law->knee ? d - k->law->knee(&k->setup) : 1;
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
            *s = (struct contact){.phase = THUD_APPROACH, .closed = true};
            k->law->touch(&k->setup, v, &s->memory);
        } else if (found[ROOTS * c] < 0) {
            s->closed = false;
        }
        if (s->closed && found[ROOTS * c + 1] != 0) {
            s->phase = found[ROOTS * c + 1] < 0 ? THUD_RESTITUTION : THUD_APPROACH;
            if (k->law->turn && s->phase == THUD_RESTITUTION)
                k->law->turn(&k->setup, d, &s->memory);
        }
        if (s->closed && found[ROOTS * c + 3] != 0)
            s->past = found[ROOTS * c + 3] > 0;
    }
}

static void look(struct problem *p, double t, N_Vector y, N_Vector scratch)
{
    const struct thud_model *m = p->model;
    slope(t, y, scratch, p);
    const double *dy = N_VGetArrayPointer(scratch);
    for (int i = 0; i < m->ndof; i++) {
        const struct thud_model_structure *s = &m->structure[m->dof_structure[i]];
        double a = ground(p, t);
        for (int j = 0; j < s->n; j++)
            a += s->phi[(i - s->first) * s->n + j] * dy[m->ndof + s->first + j];
        p->peak[i] = fmax(p->peak[i], fabs(a));
    }
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int integrate(struct problem *p, int lmm, double tolerance, double end_s, SUNContext context)
{
    int n = 2 * p->model->ndof, status = CV_SUCCESS, found[ROOTS * MOST];
    N_Vector y = N_VNew_Serial(n, context), scratch = N_VNew_Serial(n, context);
    void *cvode = CVodeCreate(lmm, context);
    SUNMatrix matrix = SUNDenseMatrix(n, n, context);
    SUNLinearSolver linear = SUNLinSol_Dense(y, matrix, context);
    SUNNonlinearSolver fixed = SUNNonlinSol_FixedPoint(y, 0, context);
    double t = 0, scale = 0;
    N_VConst(0, y);
    memset(p->contact, 0, sizeof p->contact);
    memset(p->peak, 0, sizeof p->peak);
    p->calls = 0;
    CVodeInit(cvode, slope, 0, y);
    /* a centimetre in modal coordinates, gamma being the root of a modal mass */
    for (int j = 0; j < p->model->ndof; j++)
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
        look(p, t, y, scratch);
        if (status == CV_ROOT_RETURN) {
            CVodeGetRootInfo(cvode, found);
            switch_contacts(p, N_VGetArrayPointer(y), found);
            look(p, t, y, scratch);
            CVodeReInit(cvode, t, y);
        }
    }
    SUNNonlinSolFree(fixed);
    SUNLinSolFree(linear);
    SUNMatDestroy(matrix);
    CVodeFree(&cvode);
    N_VDestroy(scratch);
    N_VDestroy(y);
    return status;
}

static double exact(struct problem *p, struct thud_session *session, double tolerance, double *peak, double *end_s)
{
    struct thud_run_options options;
    struct thud_run *run = NULL;
    struct thud_error err;
    bool done = false;
    thud_run_options_init(&options);
    options.method = thud_method_find("exact");
    options.tolerance = tolerance;
    options.tail_s = session->scene.analysis.tail_s;
    double from = now();
    if (thud_run_create(p->model, p->record, &options, &run, &err) != THUD_OK)
        exit(1);
    while (!done && thud_run_advance(run, 1000, &done, &err) == THUD_OK)
        ;
    double seconds = now() - from;
    *end_s = thud_run_end(run);
    for (int i = 0; i < p->model->ndof; i++) {
        int s = p->model->dof_structure[i];
        peak[i] = thud_run_result(run)->structure[s].floor[i - p->model->structure[s].first].acceleration.value;
    }
    thud_run_free(run);
    return seconds;
}

static void row(const struct problem *p, const char *name, double tolerance, const double *peak, double seconds,
                long calls)
{
    double error = 0;
    for (int i = 0; i < p->model->ndof; i++)
        error = fmax(error, fabs(peak[i] / p->reference[i] - 1));
    printf("%-14s %9.0e %9.3f ms  %9.1e", name, tolerance, 1e3 * seconds, error);
    if (calls)
        printf("  %9ld", calls);
    printf("\n");
}

int main(int argc, char **argv)
{
    static struct thud_session session;
    static struct problem p;
    static struct thud_scene scene;
    enum thud_case which;
    struct thud_model *model = NULL;
    struct thud_error err = {0};
    SUNContext context;
    double end_s, peak[MOST];
    enum thud_status status = thud_session_open(&session, "towers", &err);
    for (int i = 2; status == THUD_OK && i < argc; i++)
        status = thud_session_assign(&session, argv[i], &err);
    if (status == THUD_OK)
        status = thud_session_read_record(&session, &err);
    if (status == THUD_OK)
        status = thud_case_find(argc > 1 ? argv[1] : "none", &which, &err);
    if (status == THUD_OK)
        status = thud_scene_case(&session.scene, which, &scene, &err);
    if (status == THUD_OK)
        status = thud_scene_assemble(&scene, &model, &err);
    if (status != THUD_OK || model->ndof > MOST || !session.record || SUNContext_Create(NULL, &context) != 0) {
        fprintf(stderr, "cvode: %s\n", err.what);
        return 1;
    }
    p.model = model;
    p.record = session.record;
    exact(&p, &session, 1e-13, p.reference, &end_s);
    printf("%-14s %9s %12s  %9s  %9s\n", "", "tolerance", "time", "error", "slopes");
    for (double tolerance = 1e-4; tolerance > 5e-11; tolerance /= 100) {
        double seconds = INFINITY;
        for (int i = 0; i < 5; i++)
            seconds = fmin(seconds, exact(&p, &session, tolerance, peak, &end_s));
        row(&p, "thud exact", tolerance, peak, seconds, 0);
    }
    for (int lmm = CV_ADAMS; lmm <= CV_BDF; lmm++)
        for (double tolerance = 1e-4; tolerance > 5e-11; tolerance /= 100) {
            double from = now();
            if (integrate(&p, lmm, tolerance, end_s, context) < 0)
                printf("%-14s %9.0e  failed\n", lmm == CV_BDF ? "cvode bdf" : "cvode adams", tolerance);
            else
                row(&p, lmm == CV_BDF ? "cvode bdf" : "cvode adams", tolerance, p.peak, now() - from, p.calls);
        }
    SUNContext_Free(&context);
    thud_model_free(model);
    thud_session_close(&session);
    return 0;
}
