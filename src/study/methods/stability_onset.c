/* Test cases of contacts that are hard to see: a mass that reaches a wall for a moment. */
#include <math.h>

#include "study/methods/stability_private.h"

static const double tight = 1e-9;

/* Impacts and the first one's approach velocity of a mass thrown `amplitude` times as far as the wall is. */
static enum thud_status throw_at_wall(double amplitude, struct thud_stepping how, double *impacts, double *approach_mps,
                                      struct thud_error *err)
{
    struct thud_bouncer bouncer;
    struct thud_solution solution;
    int count = 0;
    thud_bouncer_init(&bouncer);
    thud_bouncer_spring(&bouncer, 20 * thud_bouncer_omega_radps);
    bouncer.velocity_mps = amplitude * bouncer.clearance_m * thud_bouncer_omega_radps;
    enum thud_status status = thud_bouncer_run(&bouncer, NULL, how, 0.4, &solution, NULL, err);
    if (thud_trial_failed(status))
        return status;
    const struct thud_impact *impact = thud_run_impacts(solution.run, &count);
    *impacts = count;
    *approach_mps = count > 0 ? impact[0].approach_mps : 0;
    thud_solution_clear(&solution);
    return THUD_OK;
}

static enum thud_status grazing(struct thud_test_case *out, struct thud_error *err)
{
    double speed;
    *out = (struct thud_test_case){.name = "grazing-contact",
                                   .scene = "a swing that reaches a ten-thousandth past the wall, steps of 20 ms",
                                   .quantity = "impacts",
                                   .method = "Runge-Kutta of order 4, not located",
                                   .exact = 1};
    enum thud_status status = throw_at_wall(1.0001, thud_stepping_of("rk4", 0.02, false), &out->naive, &speed, err);
    return status == THUD_OK
               ? throw_at_wall(1.0001, thud_stepping_of("exact", tight, true), &out->computed, &speed, err)
               : status;
}

static enum thud_status double_root(struct thud_test_case *out, struct thud_error *err)
{
    double impacts, amplitude = 1.05, gap = 0.02, omega = thud_bouncer_omega_radps;
    *out = (struct thud_test_case){.name = "double-root",
                                   .scene = "past the wall and back within one step of 0.1 s",
                                   .quantity = "approach velocity, m/s",
                                   .method = "Runge-Kutta of order 4, signs at step ends",
                                   .exact = omega * gap * sqrt(amplitude * amplitude - 1)};
    enum thud_status status = throw_at_wall(amplitude, thud_stepping_of("rk4", 0.1, false), &impacts, &out->naive, err);
    return status == THUD_OK
               ? throw_at_wall(amplitude, thud_stepping_of("exact", tight, true), &impacts, &out->computed, err)
               : status;
}

enum thud_status thud_test_case_onset(int index, struct thud_test_case *out, struct thud_error *err)
{
    static thud_test_case_fn *const show[THUD_TEST_CASES_ONSET] = {grazing, double_root};
    return show[index](out, err);
}
