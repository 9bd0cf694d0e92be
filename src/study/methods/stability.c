#include "study/methods/stability.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "study/methods/bench_private.h"
#include "study/methods/stability_private.h"

static const double duration_s = 50;
/* On both sides of 2, 2 sqrt(2) and 2 sqrt(3), the limits of the linear system. */
static const double omega_dts[] = {0.12, 0.5, 1, 1.9, 2.1, 2.7, 2.9, 3.4, 3.6, 5, 10};
static const double approaches_mps[] = {0.05, 0.5, 2};
static const double nominals[] = {0.2, 0.5, 0.8}; /* of the laws that have a coefficient of restitution */
static const double pair_steps_s[] = {5e-3, 1e-3, 1e-4};
static const double free_tolerance = 1e-6;
static const double scene_steps[THUD_STABILITY_SCENE_STEPS] = {1, 0.97, 0.94};
enum {
    OMEGA_DTS = sizeof omega_dts / sizeof *omega_dts,
    APPROACHES = sizeof approaches_mps / sizeof *approaches_mps,
    NOMINALS = sizeof nominals / sizeof *nominals,
    PAIR_STEPS = sizeof pair_steps_s / sizeof *pair_steps_s
};

const char *thud_stability_verdict_word(enum thud_stability_verdict verdict)
{
    static const char *const words[] = {"-", "bounded", "growing", "blown up"};
    return words[verdict];
}

/* Calls back for every method, located and not, at each setting (one of its own where it takes no step). */
struct planner {
    struct thud_stability *stability;
    const struct thud_law *law;
    double nominal, approach_mps;
};
typedef void add_fn(const struct planner *p, struct thud_stepping how, double setting);

static void each(const struct planner *p, const double *setting, int n, add_fn *add)
{
    for (int i = 0; i < thud_method_count(); i++) {
        const struct thud_method *m = thud_method_at(i);
        bool fixed = m->flags & THUD_METHOD_FIXED_STEP;
        bool locates = m->flags & THUD_METHOD_LOCATES;
        int ways = fixed && m->flags & (THUD_METHOD_LOCATES | THUD_METHOD_CAN_LOCATE) ? 2 : 1;
        for (int locate = 0; locate < ways; locate++)
            for (int k = 0; k < (fixed ? n : 1); k++)
                add(p, (struct thud_stepping){m, fixed ? locate == 1 : locates, free_tolerance},
                    fixed ? setting[k] : NAN);
    }
}

static void add_cell(const struct planner *p, struct thud_stepping how, double setting)
{
    p->stability->cell[p->stability->ncells++] = (struct thud_stability_cell){.how = how, .omega_dt = setting};
}

static void add_restitution(const struct planner *p, struct thud_stepping how, double setting)
{
    if (!isnan(setting))
        how.setting = setting;
    p->stability->restitution[p->stability->nrestitutions++] = (struct thud_stability_restitution){
        .how = how, .law = p->law, .nominal = p->nominal, .approach_mps = p->approach_mps};
}

static void plan_law(struct planner *p)
{
    bool has_nominal = thud_law_param(p->law, "restitution") >= 0;
    for (int e = 0; e < (has_nominal ? NOMINALS : 1); e++) {
        p->nominal = has_nominal ? nominals[e] : NAN;
        for (int k = 0; k < APPROACHES; k++) {
            p->approach_mps = approaches_mps[k];
            if (thud_law_is_linear(p->law) && p->approach_mps != thud_stability_usual_mps)
                continue; /* one restitution at any speed */
            each(p, pair_steps_s, PAIR_STEPS, add_restitution);
        }
    }
}

static void add_summary(const struct planner *p, struct thud_stepping how, double setting)
{
    (void)setting;
    p->stability->summary[p->stability->nsummaries++] =
        (struct thud_stability_summary){.how = how, .order = NAN, .keeps = {NAN, NAN}};
}

static void plan(struct thud_stability *s)
{
    struct planner planner = {.stability = s};
    each(&planner, omega_dts, OMEGA_DTS, add_cell);
    each(&planner, omega_dts, 1, add_summary);
    for (int i = 0; i < thud_law_count(); i++) {
        planner.law = thud_law_at(i);
        if (!(planner.law->flags & THUD_LAW_NO_FORCE))
            plan_law(&planner);
    }
    s->ntest_cases = thud_test_case_count();
}

/* Solves the scene by the exact method, the reference of the others. */
static enum thud_status measure_scene(struct thud_stability *s, const struct thud_scene *scene, struct thud_error *err)
{
    struct thud_solution solution;
    enum thud_status status = thud_scene_options(scene, &s->options, err);
    if (status != THUD_OK)
        return status;
    s->options.method = thud_method_find("exact");
    s->options.keep_impacts = true;
    status = thud_scene_solve(scene, s->record, &s->options, &solution, err);
    if (status == THUD_OK) {
        s->model = solution.model;
        solution.model = NULL;
        s->peak_m = calloc((size_t)s->model->ndof, sizeof *s->peak_m);
        if (!s->peak_m)
            status = thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    if (status == THUD_OK)
        status = thud_bench_solution_take(solution.run, s->exact, err);
    if (status == THUD_OK)
        for (int i = 0; i < s->model->ndof; i++) {
            const struct thud_model_structure *p = &s->model->structure[s->model->dof_structure[i]];
            s->peak_m[i] = thud_run_result(solution.run)
                               ->structure[s->model->dof_structure[i]]
                               .floor[i - p->first]
                               .displacement.value;
        }
    for (int j = 0; status == THUD_OK && j < s->model->nmodes; j++)
        s->fastest_radps = fmax(s->fastest_radps, s->model->omega[j]);
    if (!(s->fastest_radps > 0)) { /* bodies without a spring have no omega dt */
        free(s->peak_m);
        s->peak_m = NULL;
    }
    thud_solution_clear(&solution);
    return status;
}

enum thud_status thud_stability_create(const struct thud_scene *scene, const struct thud_record *record,
                                       struct thud_stability **out, struct thud_error *err)
{
    struct thud_stability *s = calloc(1, sizeof *s);
    size_t rows = 2 * (size_t)thud_method_count();
    enum thud_status status = THUD_OK;
    *out = NULL;
    if (s) {
        s->record = record;
        s->cell = calloc(rows * OMEGA_DTS, sizeof *s->cell);
        s->restitution =
            calloc(rows * PAIR_STEPS * APPROACHES * NOMINALS * (size_t)thud_law_count(), sizeof *s->restitution);
        s->test_case = calloc((size_t)thud_test_case_count(), sizeof *s->test_case);
        s->summary = calloc(rows, sizeof *s->summary);
        s->exact = calloc(1, sizeof *s->exact);
    }
    if (!s || !s->summary || !s->exact || !s->cell || !s->restitution || !s->test_case)
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status == THUD_OK) {
        plan(s);
        if (scene)
            status = measure_scene(s, scene, err);
    }
    if (status != THUD_OK) {
        thud_stability_free(s);
        return status;
    }
    *out = s;
    return THUD_OK;
}

void thud_stability_free(struct thud_stability *s)
{
    if (!s)
        return;
    thud_model_free(s->model);
    free(s->peak_m);
    free(s->cell);
    free(s->restitution);
    free(s->test_case);
    free(s->summary);
    if (s->exact)
        thud_bench_solution_clear(s->exact);
    free(s->exact);
    free(s);
}

int thud_stability_jobs(const struct thud_stability *s)
{
    return s->ncells + s->nrestitutions + s->ntest_cases + s->nsummaries;
}

/* Energies are as the squares of displacements: what is blown up has a hundred times the displacement. */
static void judge(struct thud_stability_cell *cell, int kind, double growth)
{
    static const double bounded[THUD_STABILITY_KINDS] = {1.21, 1.21, 2},
                        blown_up[THUD_STABILITY_KINDS] = {1e4, 1e4, 100};
    cell->growth[kind] = growth;
    cell->verdict[kind] = growth < bounded[kind]    ? THUD_BOUNDED
                          : growth < blown_up[kind] ? THUD_GROWING
                                                    : THUD_BLOWN_UP;
}

static struct thud_stepping at_step(struct thud_stepping how, double omega_dt, double omega_radps)
{
    if (!isnan(omega_dt))
        how.setting = omega_dt / omega_radps;
    return how;
}

static enum thud_status run_free(struct thud_stability_cell *cell, struct thud_error *err)
{
    struct thud_two_body bouncer = thud_bouncer();
    struct thud_solution solution;
    struct thud_bouncer_energy energy;
    enum thud_status status =
        thud_bouncer_run(&bouncer, NULL, at_step(cell->how, cell->omega_dt, thud_bouncer_omega_radps), duration_s,
                         &solution, &energy, err);
    if (thud_trial_failed(status))
        return status;
    judge(cell, THUD_STABILITY_FREE, isinf(energy.end) ? INFINITY : energy.half[1] / energy.half[0]);
    thud_solution_clear(&solution);
    return THUD_OK;
}

static enum thud_status run_wall(struct thud_stability_cell *cell, struct thud_error *err)
{
    struct thud_two_body bouncer = thud_bouncer();
    double largest = 0;
    thud_bouncer_spring(&bouncer, thud_stability_wall_radps);
    cell->end_least = INFINITY;
    cell->end_most = 0;
    for (int i = 0; i < THUD_STABILITY_STARTS; i++) {
        struct thud_solution solution;
        struct thud_bouncer_energy energy;
        bouncer.clearance_m = thud_stability_start_m[i];
        enum thud_status status =
            thud_bouncer_run(&bouncer, NULL, at_step(cell->how, cell->omega_dt, thud_stability_wall_radps), duration_s,
                             &solution, &energy, err);
        if (thud_trial_failed(status))
            return status;
        largest = fmax(largest, fmax(energy.half[0], energy.half[1]));
        cell->end_least = fmin(cell->end_least, energy.end);
        cell->end_most = fmax(cell->end_most, energy.end);
        thud_solution_clear(&solution);
    }
    judge(cell, THUD_STABILITY_WALL, largest);
    return THUD_OK;
}

/* The largest displacement over the exact one, of the floor where it is most; INFINITY: it diverged. */
static enum thud_status scene_growth(const struct thud_stability *s, struct thud_stepping how, double *growth,
                                     struct thud_error *err)
{
    struct thud_record *coarse;
    struct thud_run *run;
    enum thud_status status = thud_stability_scene(s, how, &run, &coarse, err);
    if (thud_trial_failed(status))
        return status;
    const struct thud_result *r = thud_run_result(run);
    *growth = status == THUD_DIVERGED ? INFINITY : 0;
    for (int i = 0; i < s->model->ndof; i++) {
        int k = s->model->dof_structure[i];
        double peak = r->structure[k].floor[i - s->model->structure[k].first].displacement.value;
        *growth = fmax(*growth, peak / s->peak_m[i]);
    }
    thud_run_free(run);
    thud_record_free(coarse);
    return THUD_OK;
}

/* Steps a little shorter than that of the cell meet the impacts at other phases. */
static enum thud_status run_scene(struct thud_stability *s, struct thud_stability_cell *cell, struct thud_error *err)
{
    struct thud_stepping how = at_step(cell->how, cell->omega_dt, s->fastest_radps);
    bool fixed = how.method->flags & THUD_METHOD_FIXED_STEP;
    double largest = 0, step_s = how.setting;
    for (int i = 0; i < (fixed ? THUD_STABILITY_SCENE_STEPS : 1); i++) {
        double growth = 0;
        if (fixed)
            how.setting = scene_steps[i] * step_s;
        enum thud_status status = scene_growth(s, how, &growth, err);
        if (status != THUD_OK)
            return status;
        largest = fmax(largest, growth);
    }
    judge(cell, THUD_STABILITY_SCENE, largest);
    return THUD_OK;
}

static enum thud_status run_cell(struct thud_stability *s, struct thud_stability_cell *cell, struct thud_error *err)
{
    enum thud_status status = run_free(cell, err);
    if (status == THUD_OK)
        status = run_wall(cell, err);
    if (status == THUD_OK && s->peak_m)
        status = run_scene(s, cell, err);
    return status;
}

static enum thud_status run_restitution(struct thud_stability_restitution *r, struct thud_error *err)
{
    struct thud_two_body pair;
    thud_two_body_rubber(&pair);
    if (r->law != pair.law)
        thud_two_body_law(&pair, r->law);
    if (!isnan(r->nominal))
        thud_two_body_set(&pair, "restitution", r->nominal);
    pair.approach_mps = r->approach_mps;
    pair.duration_s = 2; /* slow bumpers take long */
    pair.setup.mass_kg = pair.mass_kg[0] / 2;
    struct thud_law_setup setup = pair.setup;
    enum thud_status status = thud_law_prepare(r->law, &setup, err);
    if (status != THUD_OK)
        return status;
    r->expected = thud_law_restitution(r->law, &setup, r->approach_mps);
    return thud_two_body_restitution(&pair, r->how, &r->obtained, err);
}

enum thud_status thud_stability_job(struct thud_stability *s, int job, struct thud_error *err)
{
    int i = job;
    if (i < s->ncells)
        return run_cell(s, &s->cell[i], err);
    if ((i -= s->ncells) < s->nrestitutions)
        return run_restitution(&s->restitution[i], err);
    if ((i -= s->nrestitutions) < s->ntest_cases)
        return thud_test_case_run(i, &s->test_case[i], err);
    return thud_stability_summarise(s, &s->summary[i - s->ntest_cases], err);
}
