#include <assert.h>
#include <math.h>

#include "ground/record_edit.h"
#include "study/methods/stability_private.h"

const double thud_bouncer_omega_radps = 6.283185307179586;
const double thud_stability_wall_radps = 62.83185307179586; /* ten times the mass's own */
/* Distances from the wall; the spring alone would let the mass reach 80 mm. */
const double thud_stability_start_m[THUD_STABILITY_STARTS] = {0.003, 0.012, 0.02, 0.031, 0.04, 0.05, 0.059, 0.068};
const double thud_stability_usual_mps = 0.5;

struct thud_two_body thud_bouncer(void)
{
    return (struct thud_two_body){.mass_kg = {320e3},
                                  .approach_mps = 0.5,
                                  .clearance_m = 0.02,
                                  .wall = true,
                                  .spring_radps = thud_bouncer_omega_radps};
}

void thud_bouncer_spring(struct thud_two_body *bouncer, double omega_radps)
{
    thud_two_body_law(bouncer, thud_law_find("linear"));
    thud_two_body_set(bouncer, "stiffness", bouncer->mass_kg[0] * omega_radps * omega_radps);
}

static struct thud_run_options options_of(struct thud_stepping how, double tail_s)
{
    struct thud_run_options options;
    thud_run_options_init(&options);
    thud_stepping_apply(&how, &options);
    options.tail_s = tail_s;
    options.keep_impacts = true;
    options.unjudged = true; /* what it does to the energy is the finding */
    return options;
}

enum thud_status thud_bouncer_run(const struct thud_two_body *bouncer, const struct thud_record *record,
                                  struct thud_stepping how, double duration_s, struct thud_solution *out,
                                  struct thud_bouncer_energy *energy, struct thud_error *err)
{
    double record_s = record ? (double)(record->samples - 1) * record->dt_s : 0;
    struct thud_run_options options = options_of(how, fmax(duration_s - record_s, 0));
    options.keep_history = record != NULL;
    *out = (struct thud_solution){0};
    enum thud_status status = thud_two_body_assemble(bouncer, &out->model, err);
    if (status == THUD_OK)
        status = thud_run_create(out->model, record, &options, &out->run, err);
    if (energy)
        *energy = (struct thud_bouncer_energy){.half = {1}, .end = 1}; /* the start itself */
    for (bool done = false; status == THUD_OK && !done;) {
        status = thud_run_advance(out->run, energy ? 1 : 1000, &done, err);
        if (energy && status == THUD_OK) {
            double *largest = &energy->half[thud_run_time(out->run) > 0.5 * duration_s];
            energy->end = thud_energy_ratio(out);
            *largest = fmax(*largest, energy->end);
        }
    }
    if (energy && status == THUD_DIVERGED)
        *energy = (struct thud_bouncer_energy){{INFINITY, INFINITY}, INFINITY};
    if (thud_trial_failed(status))
        thud_solution_clear(out);
    return status;
}

bool thud_trial_failed(enum thud_status status)
{
    return status != THUD_OK && status != THUD_DIVERGED;
}

struct thud_stepping thud_stepping_of(const char *method, double setting, bool locate)
{
    struct thud_stepping how = {thud_method_find(method), locate, setting};
    assert(how.method);
    return how;
}

double thud_energy_ratio(const struct thud_solution *solution)
{
    const struct thud_energy *e = &thud_run_result(solution->run)->energy;
    return (e->kinetic_j + e->strain_j + e->stored_j) / e->initial_j;
}

enum thud_status thud_two_body_restitution(const struct thud_two_body *pair, struct thud_stepping how, double *out,
                                           struct thud_error *err)
{
    struct thud_two_body trial = *pair;
    struct thud_solution solution;
    trial.method = how.method;
    trial.method_step_s = how.method->flags & THUD_METHOD_FIXED_STEP ? how.setting : 0;
    trial.locate = how.locate;
    trial.until_parted = true;
    enum thud_status status = thud_two_body_run(&trial, trial.duration_s / 64, &solution, err);
    *out = status == THUD_OK ? thud_two_body_separation(&solution) / trial.approach_mps : INFINITY;
    thud_solution_clear(&solution);
    return thud_trial_failed(status) ? status : THUD_OK;
}

enum thud_status thud_stability_scene(const struct thud_stability *s, struct thud_stepping how, struct thud_run **out,
                                      struct thud_record **coarse, struct thud_error *err)
{
    struct thud_run_options options = s->options;
    enum thud_status status = THUD_OK;
    *out = NULL;
    *coarse = NULL;
    thud_stepping_apply(&how, &options);
    options.unjudged = true;
    /* no step passes over a sample: a longer one takes the ground motion at its own ends */
    if (how.method->flags & THUD_METHOD_FIXED_STEP && s->record && how.setting > s->record->dt_s)
        status = thud_record_resample(s->record, how.setting, coarse, err);
    if (status == THUD_OK)
        status = thud_run_create(s->model, *coarse ? *coarse : s->record, &options, out, err);
    for (bool done = false; status == THUD_OK && !done;)
        status = thud_run_advance(*out, 1000, &done, err);
    if (thud_trial_failed(status)) {
        thud_run_free(*out);
        thud_record_free(*coarse);
    }
    return status;
}
