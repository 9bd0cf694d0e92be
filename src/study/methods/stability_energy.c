/* Test cases in which a method makes or loses energy: collisions of two free bodies, and a mass between its spring and a
 * wall. */
#include <math.h>

#include "core/laws/law_closed_form.h"
#include "study/methods/stability_private.h"

static const double tight = 1e-9;

static void spring_pair(struct thud_two_body *pair, double left_kg, double right_kg, double stiffness_npm)
{
    thud_two_body_concrete(pair);
    pair->law = thud_law_find("linear");
    thud_law_defaults(pair->law, &pair->setup);
    thud_two_body_set(pair, "stiffness", stiffness_npm);
    pair->mass_kg[0] = left_kg;
    pair->mass_kg[1] = right_kg;
}

static enum thud_status compare(struct thud_two_body *pair, struct thud_stepping naive, struct thud_test_case *out,
                                struct thud_error *err)
{
    enum thud_status status = thud_two_body_restitution(pair, naive, &out->naive, err);
    return status == THUD_OK
               ? thud_two_body_restitution(pair, thud_stepping_of("exact", tight, true), &out->computed, err)
               : status;
}

static enum thud_status lagged(struct thud_test_case *out, struct thud_error *err)
{
    struct thud_two_body pair;
    double k = 2.5e9, omega = sqrt(k / 160e3);
    spring_pair(&pair, 320e3, 320e3, k);
    *out = (struct thud_test_case){.name = "lagged-force",
                                   .scene = "two free bodies, elastic contact, omega dt 0.125",
                                   .quantity = "separation over approach velocity",
                                   .method = "contact force of the step before",
                                   .exact = 1};
    return compare(&pair, thud_stepping_of("lagged", 0.125 / omega, false), out, err);
}

static enum thud_status trapezoidal(struct thud_test_case *out, struct thud_error *err)
{
    struct thud_bouncer bouncer;
    double omega = 62.83185307179586;
    struct thud_stepping how[2] = {thud_stepping_of("newmark", 5 / omega, false),
                                   thud_stepping_of("exact", tight, true)};
    *out = (struct thud_test_case){.name = "trapezoidal-growth",
                                   .scene = "undamped mass bouncing on a wall spring for 50 s, omega_c dt 5",
                                   .quantity = "energy at the end over the start",
                                   .method = "Newmark, average acceleration, not located",
                                   .exact = 1};
    thud_bouncer_init(&bouncer);
    thud_bouncer_spring(&bouncer, omega);
    for (int i = 0; i < 2; i++) {
        struct thud_solution solution;
        enum thud_status status = thud_bouncer_run(&bouncer, NULL, how[i], 50, &solution, NULL, err);
        if (thud_trial_failed(status))
            return status;
        *(i ? &out->computed : &out->naive) = status == THUD_OK ? thud_energy_ratio(&solution) : INFINITY;
        thud_solution_clear(&solution);
    }
    return THUD_OK;
}

static enum thud_status dead(struct thud_test_case *out, struct thud_error *err)
{
    struct thud_two_body pair;
    thud_two_body_concrete(&pair);
    thud_two_body_set(&pair, "restitution", 1e-3);
    thud_two_body_set(&pair, "damping", 1); /* exact */
    *out = (struct thud_test_case){.name = "restitution-near-0",
                                   .scene = "two free bodies, Kelvin-Voigt without tension, e 0.001",
                                   .quantity = "separation over approach velocity",
                                   .method = "Newmark, 1 ms, not located",
                                   .exact = 1e-3};
    return compare(&pair, thud_stepping_of("newmark", 1e-3, false), out, err);
}

static enum thud_status stiff(struct thud_test_case *out, struct thud_error *err)
{
    struct thud_two_body pair;
    spring_pair(&pair, 320e3, 320e3, 1e13);
    *out = (struct thud_test_case){.name = "stiffness-1e13",
                                   .scene = "two free bodies, elastic contact of 1e13 N/m",
                                   .quantity = "separation over approach velocity",
                                   .method = "Newmark, 1 ms, not located",
                                   .exact = 1};
    return compare(&pair, thud_stepping_of("newmark", 1e-3, false), out, err);
}

static enum thud_status mass_ratio(struct thud_test_case *out, struct thud_error *err)
{
    struct thud_two_body pair;
    spring_pair(&pair, 320e6, 320, 2.5e9);
    *out = (struct thud_test_case){.name = "mass-ratio-1e6",
                                   .scene = "a body hits another of a millionth of its mass, elastic contact",
                                   .quantity = "separation over approach velocity",
                                   .method = "Newmark, 1 ms, not located",
                                   .exact = 1};
    return compare(&pair, thud_stepping_of("newmark", 1e-3, false), out, err);
}

/* At contact onset the dashpot alone pushes, and where xi >= 1/2 never again as hard. */
static enum thud_status onset(struct thud_test_case *out, struct thud_error *err)
{
    struct thud_two_body pair;
    struct thud_stepping how[2] = {thud_stepping_of("newmark", 1e-3, false), thud_stepping_of("exact", tight, true)};
    thud_two_body_concrete(&pair);
    thud_two_body_set(&pair, "restitution", 0.1);
    thud_two_body_set(&pair, "damping", 1); /* exact */
    *out = (struct thud_test_case){.name = "event-at-the-start",
                                   .scene = "two bodies that touch at t = 0, Kelvin-Voigt without tension, e 0.1",
                                   .quantity = "largest force over the dashpot's at contact onset",
                                   .method = "Newmark, 1 ms, not located",
                                   .exact = 1};
    double k = 2.5e9, mass = 160e3, dashpot = 2 * thud_kelvin_voigt_cut_xi(0.1) * sqrt(k * mass) * pair.approach_mps;
    for (int i = 0; i < 2; i++) {
        struct thud_solution solution;
        pair.method = how[i].method;
        pair.method_step_s = how[i].setting;
        enum thud_status status = thud_two_body_run(&pair, pair.duration_s, &solution, err);
        if (status != THUD_OK)
            return status;
        *(i ? &out->computed : &out->naive) = thud_run_result(solution.run)->contact[0].force.value / dashpot;
        thud_solution_clear(&solution);
    }
    return THUD_OK;
}

enum thud_status thud_test_case_energy(int index, struct thud_test_case *out, struct thud_error *err)
{
    static thud_test_case_fn *const show[THUD_TEST_CASES_ENERGY] = {lagged, trapezoidal, dead,
                                                                    stiff,  mass_ratio,  onset};
    return show[index](out, err);
}
