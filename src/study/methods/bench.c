#include "study/methods/bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "study/methods/bench_private.h"
#include "study/sweep/sensitivity.h"

static const double tolerances[] = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};
static const double steps[] = {1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5};
enum { TOLERANCES = sizeof tolerances / sizeof *tolerances, STEPS = sizeof steps / sizeof *steps };

const char *const thud_bench_reference_name[THUD_BENCH_REFERENCES] = {"exact", "dormand-prince"};
static const double reference_tolerances[] = {1e-13, 1e-12};

const double thud_bench_level[THUD_BENCH_LEVELS] = {1e-2, 1e-3};

static void add_curve(struct thud_bench *bench, const struct thud_method *method, bool locate, const double *setting,
                      int n)
{
    int curve = bench->npoints > 0 ? bench->point[bench->npoints - 1].curve + 1 : 0;
    for (int i = 0; i < n; i++)
        bench->point[bench->npoints++] = (struct thud_bench_point){.how = {method, locate, setting[i]}, .curve = curve};
}

/* Whether a tolerance has nothing to act on: all motion between events is in closed form. */
static bool is_closed_form(const struct thud_bench *bench, const struct thud_method *method)
{
    bool closed = method == thud_method_find(thud_bench_reference_name[0]);
    for (int c = 0; c < bench->model->ncontacts; c++)
        closed = closed && thud_law_is_linear(bench->model->contact[c].law);
    return closed;
}

static void plan(struct thud_bench *bench)
{
    static const double usual = 1e-6;
    for (int i = 0; i < thud_method_count(); i++) {
        const struct thud_method *m = thud_method_at(i);
        bool locates = m->flags & THUD_METHOD_LOCATES, can = m->flags & THUD_METHOD_CAN_LOCATE;
        if (!(m->flags & THUD_METHOD_FIXED_STEP)) {
            const bool one = is_closed_form(bench, m);
            add_curve(bench, m, locates, one ? &usual : tolerances, one ? 1 : TOLERANCES);
            continue;
        }
        add_curve(bench, m, false, steps, STEPS);
        if (can || locates)
            add_curve(bench, m, true, steps, STEPS);
    }
}

enum thud_status thud_bench_create(const struct thud_scene *scene, const struct thud_record *record,
                                   struct thud_bench **out, struct thud_error *err)
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
    bench->reference_error = bench->moved = NAN;
    enum thud_status status = thud_scene_options(scene, &bench->options, err);
    if (status == THUD_OK)
        status = thud_scene_assemble(scene, &bench->model, err);
    if (status != THUD_OK) {
        thud_bench_free(bench);
        return status;
    }
    plan(bench);
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

void thud_bench_only(struct thud_bench *bench, const struct thud_method *const *method, int methods)
{
    int kept = 0;
    for (int i = 0; i < bench->npoints; i++) {
        bool wanted = false;
        for (int k = 0; k < methods; k++)
            wanted = wanted || bench->point[i].how.method == method[k];
        if (wanted)
            bench->point[kept++] = bench->point[i];
    }
    bench->npoints = kept;
}

int thud_bench_next(const struct thud_bench *bench)
{
    int next = -1, least = 0;
    for (int i = 0, rank = 0; i < bench->npoints; i++) {
        rank = i > 0 && bench->point[i - 1].curve == bench->point[i].curve ? rank + 1 : 0;
        if (bench->point[i].state == THUD_BENCH_WAITING && (next < 0 || rank < least)) {
            next = i;
            least = rank;
        }
    }
    return next;
}

int thud_bench_ended(const struct thud_bench *bench)
{
    int ended = 0;
    for (int i = 0; i < bench->npoints; i++)
        ended += bench->point[i].state != THUD_BENCH_WAITING;
    return ended;
}

static bool keeps(const struct thud_bench_point *p, double level)
{
    return p->state == THUD_BENCH_DONE && p->error.all <= level && p->error.missed + p->error.extra == 0;
}

static int by_time(const void *a, const void *b)
{
    const double x = ((const struct thud_bench_cost *)a)->ratio, y = ((const struct thud_bench_cost *)b)->ratio;
    return (x > y) - (x < y);
}

int thud_bench_costs(const struct thud_bench *bench, double level, struct thud_bench_cost cost[THUD_BENCH_CURVES_MAX])
{
    int n = 0;
    for (int i = 0, curve = -1; i < bench->npoints; i++) {
        const struct thud_bench_point *p = &bench->point[i];
        if (!keeps(p, level))
            continue;
        if (p->curve != curve && n == THUD_BENCH_CURVES_MAX)
            break;
        if (p->curve != curve)
            cost[n++] = (struct thud_bench_cost){level, i, p->seconds};
        else if (p->seconds < cost[n - 1].ratio)
            cost[n - 1] = (struct thud_bench_cost){level, i, p->seconds};
        curve = p->curve;
    }
    qsort(cost, (size_t)n, sizeof *cost, by_time);
    for (int i = n - 1; i >= 0; i--) /* times so far */
        cost[i].ratio = cost[0].ratio > 0 ? cost[i].ratio / cost[0].ratio : NAN;
    return n;
}

enum thud_status thud_bench_move(struct thud_bench *bench, const struct thud_scene *scene, struct thud_error *err)
{
    static const double small = 1e-3;
    enum thud_status status = THUD_OK;
    double moved = 0;
    for (int i = 0; status == THUD_OK && i < 2 * THUD_CHANGES; i++) {
        struct thud_solution solution;
        struct thud_bench_solution taken;
        status = thud_change_solve(scene, bench->record, (enum thud_change)(i / 2), i % 2 ? 1 + small : 1 - small,
                                   &solution, err);
        if (status == THUD_OK) {
            status = thud_bench_solution_take(solution.run, &taken, err);
            thud_solution_clear(&solution);
        }
        if (status == THUD_OK) {
            moved = fmax(moved, thud_bench_compare(&taken, &bench->reference[0]).all);
            thud_bench_solution_clear(&taken);
        }
    }
    if (status == THUD_OK)
        bench->moved = moved;
    return status;
}

enum thud_status thud_bench_reference_start(struct thud_bench *bench, int which, struct thud_run **out,
                                            struct thud_error *err)
{
    struct thud_run_options options = bench->options;
    *out = NULL;
    const struct thud_stepping how = {thud_method_find(thud_bench_reference_name[which]), true,
                                      reference_tolerances[which]};
    if (!how.method)
        return THUD_OK;
    thud_stepping_apply(&how, &options);
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

enum thud_status thud_bench_start(struct thud_bench *bench, int i, struct thud_run **out, struct thud_error *err)
{
    struct thud_run_options options = bench->options;
    thud_stepping_apply(&bench->point[i].how, &options);
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
    bool own = bench->reference[1].there && p->how.method == thud_method_find(thud_bench_reference_name[0]);
    p->error = thud_bench_compare(&solution, &bench->reference[own]);
    p->state = THUD_BENCH_DONE;
    thud_bench_solution_clear(&solution);
    return THUD_OK;
}
