#include "study/methods/bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "study/methods/bench_private.h"
#include "study/methods/stability.h"

static const double tolerances[] = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};
static const double steps[] = {1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5};
enum { TOLERANCES = sizeof tolerances / sizeof *tolerances, STEPS = sizeof steps / sizeof *steps, CHEAP_STEPS = 7 };

/* Tightest of the program's own, and of the independent method. */
static const char *const reference_names[] = {"exact", "dormand-prince"};
static const double reference_tolerances[] = {1e-13, 1e-12};

struct thud_bench {
    const struct thud_record *record;
    struct thud_model *model;
    struct thud_run_options options; /* common to all */
    struct thud_bench_point *point;
    int npoints;
    struct thud_bench_solution reference[2];
    double reference_error;
};

static void add_curve(struct thud_bench *bench, const struct thud_method *method, bool locate, const double *setting,
                      int n)
{
    int curve = bench->npoints > 0 ? bench->point[bench->npoints - 1].curve + 1 : 0;
    for (int i = 0; i < n; i++)
        bench->point[bench->npoints++] =
            (struct thud_bench_point){.method = method, .locate = locate, .setting = setting[i], .curve = curve};
}

static void plan(struct thud_bench *bench, int nsteps)
{
    for (int i = 0; i < thud_method_count(); i++) {
        const struct thud_method *m = thud_method_at(i);
        bool locates = m->flags & THUD_METHOD_LOCATES, can = m->flags & THUD_METHOD_CAN_LOCATE;
        if (!(m->flags & THUD_METHOD_FIXED_STEP)) {
            add_curve(bench, m, locates, tolerances, TOLERANCES);
            continue;
        }
        add_curve(bench, m, false, steps, nsteps);
        if (can || locates)
            add_curve(bench, m, true, steps, nsteps);
    }
}

enum thud_status thud_bench_create(const struct thud_scene *scene, const struct thud_record *record,
                                   bool expensive_steps, struct thud_bench **out, struct thud_error *err)
{
    *out = NULL;
    struct thud_bench *bench = calloc(1, sizeof *bench);
    size_t most = (size_t)thud_method_count() * 2 * (STEPS + TOLERANCES);
    if (bench)
        bench->point = calloc(most, sizeof *bench->point);
    if (!bench || !bench->point) {
        thud_bench_free(bench);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    bench->record = record;
    bench->reference_error = NAN;
    plan(bench, expensive_steps ? STEPS : CHEAP_STEPS);
    enum thud_status status = thud_scene_options(scene, &bench->options, err);
    if (status == THUD_OK)
        status = thud_scene_assemble(scene, &bench->model, err);
    if (status != THUD_OK) {
        thud_bench_free(bench);
        return status;
    }
    bench->options.keep_impacts = true;
    *out = bench;
    return THUD_OK;
}

void thud_bench_free(struct thud_bench *bench)
{
    if (!bench)
        return;
    for (int i = 0; i < 2; i++)
        thud_bench_solution_clear(&bench->reference[i]);
    thud_model_free(bench->model);
    free(bench->point);
    free(bench);
}

bool thud_bench_yields(const struct thud_bench *bench)
{
    return bench->model->nstoreys > 0;
}

int thud_bench_count(const struct thud_bench *bench)
{
    return bench->npoints;
}

struct thud_bench_point *thud_bench_point(struct thud_bench *bench, int i)
{
    return &bench->point[i];
}

void thud_bench_only(struct thud_bench *bench, const struct thud_method *const *method, int methods)
{
    int kept = 0;
    for (int i = 0; i < bench->npoints; i++) {
        bool wanted = false;
        for (int k = 0; k < methods; k++)
            wanted = wanted || bench->point[i].method == method[k];
        if (wanted)
            bench->point[kept++] = bench->point[i];
    }
    bench->npoints = kept;
}

void thud_bench_curve_name(const struct thud_bench_point *point, char *text, unsigned long size)
{
    thud_stepping_name(&(struct thud_stepping){.method = point->method, .locate = point->locate}, text, size);
}

const char *thud_bench_reference_name(const struct thud_bench *bench, int which)
{
    (void)bench;
    return thud_method_find(reference_names[which]) ? reference_names[which] : "none";
}

enum thud_status thud_bench_reference_start(struct thud_bench *bench, int which, struct thud_run **out,
                                            struct thud_error *err)
{
    struct thud_run_options options = bench->options;
    *out = NULL;
    options.method = thud_method_find(reference_names[which]);
    if (!options.method)
        return THUD_OK;
    options.tolerance = reference_tolerances[which];
    options.locate = true;
    return thud_run_create(bench->model, bench->record, &options, out, err);
}

enum thud_status thud_bench_reference_finish(struct thud_bench *bench, int which, struct thud_run *run,
                                             struct thud_error *err)
{
    enum thud_status status = run ? thud_bench_solution_take(run, &bench->reference[which], err) : THUD_OK;
    thud_run_free(run);
    if (status == THUD_OK && bench->reference[0].there && bench->reference[1].there)
        bench->reference_error = thud_bench_compare(&bench->reference[1], &bench->reference[0]).all;
    return status;
}

double thud_bench_reference_error(const struct thud_bench *bench)
{
    return bench->reference_error;
}

enum thud_status thud_bench_start(struct thud_bench *bench, int i, struct thud_run **out, struct thud_error *err)
{
    const struct thud_bench_point *p = &bench->point[i];
    struct thud_run_options options = bench->options;
    options.method = p->method;
    options.locate = p->locate;
    if (p->method->flags & THUD_METHOD_FIXED_STEP)
        options.step_s = p->setting;
    else
        options.tolerance = p->setting;
    return thud_run_create(bench->model, bench->record, &options, out, err);
}

enum thud_status thud_bench_judge(struct thud_bench *bench, int i, const struct thud_run *run, enum thud_status status,
                                  const struct thud_error *failure, struct thud_error *err)
{
    struct thud_bench_point *p = &bench->point[i];
    struct thud_bench_solution solution;
    p->work = thud_run_result(run)->work;
    if (status != THUD_OK) {
        p->state = THUD_BENCH_FAILED;
        snprintf(p->message, sizeof p->message, "%.180s", failure->what);
        return THUD_OK;
    }
    status = thud_bench_solution_take(run, &solution, err);
    if (status != THUD_OK)
        return status;
    /* no method is its own judge */
    bool own = bench->reference[1].there && p->method == thud_method_find(reference_names[0]);
    p->error = thud_bench_compare(&solution, &bench->reference[own]);
    p->state = THUD_BENCH_DONE;
    thud_bench_solution_clear(&solution);
    return THUD_OK;
}
