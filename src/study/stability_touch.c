/* Exhibits of contacts that are hard to see: a mass that reaches a wall for a moment, and twin buildings. */
#include <math.h>

#include "study/stability_private.h"

static const double tight = 1e-9;

/* Impacts and the first one's closing speed of a mass thrown `reach` times as far as the wall is. */
static enum thud_status throw_at_wall(double reach, struct thud_stepping how, double *impacts, double *closing_mps,
                                      struct thud_error *err)
{
    struct thud_bouncer bouncer;
    struct thud_answer answer;
    int count = 0;
    thud_bouncer_init(&bouncer);
    thud_bouncer_spring(&bouncer, 20 * thud_bouncer_omega_radps);
    bouncer.velocity_mps = reach * bouncer.clearance_m * thud_bouncer_omega_radps;
    enum thud_status status = thud_bouncer_run(&bouncer, NULL, how, 0.4, &answer, NULL, err);
    if (thud_trial_failed(status))
        return status;
    const struct thud_impact *impact = thud_run_impacts(answer.run, &count);
    *impacts = count;
    *closing_mps = count > 0 ? impact[0].approach_mps : 0;
    thud_answer_clear(&answer);
    return THUD_OK;
}

static enum thud_status grazing(struct thud_exhibit *out, struct thud_error *err)
{
    double speed;
    *out = (struct thud_exhibit){.name = "grazing-contact",
                                 .scene = "a swing that reaches a ten-thousandth past the wall, steps of 20 ms",
                                 .quantity = "impacts",
                                 .naive = "Runge-Kutta of order 4, not located",
                                 .right = 1};
    enum thud_status status = throw_at_wall(1.0001, thud_stepping_of("rk4", 0.02, false), &out->wrong, &speed, err);
    return status == THUD_OK ? throw_at_wall(1.0001, thud_stepping_of("exact", tight, true), &out->thud, &speed, err)
                             : status;
}

static enum thud_status double_root(struct thud_exhibit *out, struct thud_error *err)
{
    double impacts, reach = 1.05, gap = 0.02, omega = thud_bouncer_omega_radps;
    *out = (struct thud_exhibit){.name = "double-root",
                                 .scene = "past the wall and back within one step of 0.1 s",
                                 .quantity = "closing speed, m/s",
                                 .naive = "Runge-Kutta of order 4, signs at step ends",
                                 .right = omega * gap * sqrt(reach * reach - 1)};
    enum thud_status status = throw_at_wall(reach, thud_stepping_of("rk4", 0.1, false), &impacts, &out->wrong, err);
    return status == THUD_OK ? throw_at_wall(reach, thud_stepping_of("exact", tight, true), &impacts, &out->thud, err)
                             : status;
}

/* Largest displacement of two buildings side by side, nearly twins, over that of one alone. */
static enum thud_status sway(double difference, bool contact, struct thud_stepping how, double *peak_m,
                             struct thud_error *err)
{
    enum { SAMPLES = 1001 };
    double a[SAMPLES], mass = 320e3, omega = thud_bouncer_omega_radps;
    double stiffness[2] = {mass * omega * omega, (1 + difference) * mass * omega * omega};
    struct thud_structure_input twin[2] = {{.n = 1, .mass_kg = &mass, .stiffness_npm = &stiffness[0], .damping = 0.02},
                                           {.n = 1, .mass_kg = &mass, .stiffness_npm = &stiffness[1], .damping = 0.02}};
    struct thud_contact_input touch = {
        .interface = 1, .left_floor = 1, .right_floor = 1, .right_structure = 1, .law = thud_law_find("linear")};
    struct thud_model_input input = {
        .nstructures = 2, .structure = twin, .ncontacts = contact ? 1 : 0, .contact = &touch};
    struct thud_record *record = NULL;
    struct thud_answer answer = {0};
    struct thud_run_options options;
    for (int i = 0; i < SAMPLES; i++)
        a[i] = 3 * sin(0.05 * i) * exp(-0.005 * i);
    thud_law_defaults(touch.law, &touch.setup);
    thud_run_options_init(&options);
    options.method = how.method;
    options.step_s = how.method->flags & THUD_METHOD_FIXED_STEP ? how.setting : NAN;
    options.tail_s = 10;
    options.unjudged = true;
    enum thud_status status = thud_record_create(a, SAMPLES, 0.01, &record, err);
    if (status == THUD_OK)
        status = thud_model_create(&input, &answer.model, err);
    if (status == THUD_OK)
        status = thud_run_create(answer.model, record, &options, &answer.run, err);
    for (bool done = false; status == THUD_OK && !done;)
        status = thud_run_advance(answer.run, 1000, &done, err);
    if (!thud_trial_failed(status))
        *peak_m = status == THUD_OK ? thud_run_result(answer.run)->structure[0].floor[0].displacement.value : INFINITY;
    thud_answer_clear(&answer);
    thud_record_free(record);
    return thud_trial_failed(status) ? status : THUD_OK;
}

static enum thud_status twins(struct thud_exhibit *out, struct thud_error *err)
{
    double difference = 1e-6, alone = NAN, peak = NAN;
    struct thud_stepping exact = thud_stepping_of("exact", tight, true);
    *out = (struct thud_exhibit){.name = "nearly-identical",
                                 .scene = "two buildings that differ by a millionth of stiffness, clearance 0",
                                 .quantity = "largest displacement over one alone",
                                 .naive = "KR-alpha, 5 ms",
                                 .right = 1};
    enum thud_status status = sway(difference, false, exact, &alone, err);
    if (status == THUD_OK)
        status = sway(difference, true, thud_stepping_of("kr-alpha", 5e-3, false), &peak, err);
    out->wrong = peak / alone;
    if (status == THUD_OK)
        status = sway(difference, true, exact, &peak, err);
    out->thud = peak / alone;
    return status;
}

enum thud_status thud_exhibit_touch(int index, struct thud_exhibit *out, struct thud_error *err)
{
    static thud_exhibit_fn *const show[THUD_EXHIBITS_TOUCH] = {grazing, double_root, twins};
    return show[index](out, err);
}
