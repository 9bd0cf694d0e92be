/* Test case of a storey that yields: where it unloads lies within a step. */

#include "study/methods/stability_private.h"

/* Thrown at v, a storey with a yield drift d_y and no hardening is elastic to d_y and then slowed by a constant force:
 *     permanent drift = (v^2 - omega^2 d_y^2)/(2 omega^2 d_y)
 */
static const double omega_radps = 12, yield_m = 0.02, velocity_mps = 0.6;

static enum thud_status permanent_drift(struct thud_stepping how, double *out_mm, struct thud_error *err)
{
    const double mass_kg = 320e3, stiffness_npm = mass_kg * omega_radps * omega_radps, hardening = 0;
    const struct thud_structure_input storey = {.n = 1,
                                                .mass_kg = &mass_kg,
                                                .stiffness_npm = &stiffness_npm,
                                                .velocity_mps = velocity_mps,
                                                .yield_m = &yield_m,
                                                .hardening = &hardening};
    const struct thud_model_input input = {.nstructures = 1, .structure = &storey};
    struct thud_run_options options;
    struct thud_solution solution = {0};
    bool done = false;
    thud_run_options_init(&options);
    options.method = how.method;
    options.locate = how.locate;
    options.tail_s = 1;
    options.unjudged = true;
    if (options.method->flags & THUD_METHOD_FIXED_STEP)
        options.step_s = how.setting;
    enum thud_status status = thud_model_create(&input, &solution.model, err);
    if (status == THUD_OK)
        status = thud_run_create(solution.model, NULL, &options, &solution.run, err);
    while (status == THUD_OK && !done)
        status = thud_run_advance(solution.run, 1000, &done, err);
    if (status == THUD_OK)
        *out_mm = 1e3 * thud_run_result(solution.run)->structure[0].storey[0].permanent_m;
    thud_solution_clear(&solution);
    return status;
}

enum thud_status thud_test_case_yield(struct thud_test_case *out, struct thud_error *err)
{
    double w = omega_radps * yield_m;
    *out = (struct thud_test_case){.name = "unloading-missed",
                                   .scene = "a storey thrown beyond its yield drift of 20 mm, steps of 50 ms",
                                   .quantity = "permanent drift, mm",
                                   .method = "Runge-Kutta of order 4, unloading at step ends",
                                   .exact = 1e3 * (velocity_mps * velocity_mps - w * w) / (2 * omega_radps * w)};
    enum thud_status status = permanent_drift(thud_stepping_of("rk4", 0.05, false), &out->naive, err);
    return status == THUD_OK ? permanent_drift(thud_stepping_of("exact", 1e-9, true), &out->computed, err) : status;
}
