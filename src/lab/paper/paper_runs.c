#include "lab/paper/paper_report.h"

#include <math.h>
#include <stdlib.h>

#include "study/scene/solution.h"

/* ---- storeys ---- */

struct taker {
    const struct thud_sweep_plan *plan;
    struct thud_sweep_collector *to;
};

static enum thud_status collect_point(void *context, struct thud_sweep_point *point, struct thud_error *err)
{
    struct taker *taker = context;
    enum thud_status status = thud_sweep_collector_add(taker->to, taker->plan, point, err);
    free(point);
    return status;
}

static enum thud_status vary_storeys(struct thud_paper_runs *runs, const struct thud_sweep_jobs *how,
                                     struct thud_error *err)
{
    enum thud_status status = thud_sweep_vary(&runs->plan, "structures.2.storeys=5:8:1", err);
    if (status == THUD_OK)
        status = thud_sweep_vary(&runs->plan, "gap=5 cm:25 cm:2.5 cm", err);
    if (status == THUD_OK)
        status = thud_sweep_cases(&runs->plan, "none,bumper", err);
    if (status != THUD_OK)
        return status;
    struct taker taker = {&runs->plan, &runs->storeys};
    struct thud_sweep_jobs jobs = {.plan = &runs->plan,
                                   .step = 1,
                                   .count = thud_sweep_points(&runs->plan),
                                   .threads = how->threads,
                                   .cancel = how->cancel,
                                   .context = &taker,
                                   .take = collect_point};
    thud_sweep_collector_init(&runs->storeys, &runs->plan, &runs->name);
    return thud_sweep_jobs_run(&jobs, err);
}

/* ---- the stiffness of impact ---- */

/* Largest acceleration of the floors that `pound` names touch. */
static double largest(const struct thud_result *r, const struct thud_result *pound)
{
    double most = 0;
    for (int c = 0; c < pound->ncontacts; c++) {
        const struct thud_contact_result *x = &pound->contact[c];
        if (x->impacts == 0)
            continue;
        most = fmax(most, r->structure[x->interface - 1].floor[x->left_floor - 1].acceleration.value);
        most = fmax(most, r->structure[x->interface].floor[x->right_floor - 1].acceleration.value);
    }
    return most;
}

static void read_spike(const struct thud_solution *pounding, const struct thud_solution *alone,
                       struct thud_paper_spike *out)
{
    const struct thud_result *r = thud_run_result(pounding->run);
    int n;
    const struct thud_impact *impact = thud_run_impacts(pounding->run, &n);
    out->acceleration_mps2 = largest(r, r);
    out->period_s = r->structure[0].period_s[0];
    out->free_mps2 = largest(thud_run_result(alone->run), r);
    for (int i = 0; i < n; i++)
        if (impact[i].force_n > out->force_n) {
            out->force_n = impact[i].force_n;
            out->duration_s = impact[i].duration_s;
        }
    for (int c = 0; c < r->ncontacts; c++) {
        out->struck += r->contact[c].impacts > 0;
        out->widened += r->contact[c].residual_m > 0;
        out->residual_m = fmax(out->residual_m, r->contact[c].residual_m);
    }
}

static enum thud_status vary_stiffness(struct thud_paper_runs *runs, const struct thud_record *record,
                                       struct thud_error *err)
{
    static const char *const stiffness[THUD_PAPER_STIFFNESSES] = {"625 kN/mm", "2500 kN/mm", "10000 kN/mm"};
    static const double value[THUD_PAPER_STIFFNESSES] = {625e6, 2500e6, 10000e6};
    struct thud_scene *scene = malloc(2 * sizeof *scene);
    struct thud_solution alone = {0}, pounding = {0};
    struct thud_run_options options;
    enum thud_status status = scene ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status == THUD_OK)
        status = thud_scene_case(&runs->plan.scene, THUD_CASE_NONE, scene, err);
    if (status == THUD_OK)
        status = thud_scene_options(scene, &options, err);
    if (status == THUD_OK) {
        scene[1] = scene[0];
        scene[1].interface[0].gap_m = 10; /* there is no contact */
        status = thud_scene_solve(&scene[1], record, &options, &alone, err);
        options.keep_impacts = true;
    }
    for (int i = 0; i < THUD_PAPER_STIFFNESSES && status == THUD_OK; i++) {
        runs->spike[i] = (struct thud_paper_spike){.stiffness_npm = value[i]};
        status = thud_scene_set(scene, "interfaces.1.contact.stiffness", stiffness[i], err);
        if (status == THUD_OK)
            status = thud_scene_solve(scene, record, &options, &pounding, err);
        if (status == THUD_OK)
            read_spike(&pounding, &alone, &runs->spike[i]);
        thud_solution_clear(&pounding);
    }
    thud_solution_clear(&alone);
    free(scene);
    return status;
}

enum thud_status thud_paper_runs_make(const struct thud_scene *scene, const struct thud_record *const *record,
                                      const char *name, const struct thud_sweep_jobs *jobs, struct thud_paper_runs *out,
                                      struct thud_error *err)
{
    thud_sweep_plan_init(&out->plan, scene);
    out->planned = true;
    out->plan.record = record;
    out->plan.nrecords = 1;
    out->name = name;
    enum thud_status status = vary_storeys(out, jobs, err);
    return status == THUD_OK ? vary_stiffness(out, record[0], err) : status;
}

void thud_paper_runs_clear(struct thud_paper_runs *runs)
{
    thud_sweep_collector_clear(&runs->storeys);
    if (runs->planned)
        thud_sweep_plan_clear(&runs->plan);
    runs->planned = false;
}
