#include <assert.h>
#include <math.h>

#include "study/scene/two_body.h"

static const double tolerance = 1e-9;

void thud_two_body_set(struct thud_two_body *pair, const char *param, double value)
{
    int index = thud_law_param(pair->law, param);
    assert(index >= 0);
    pair->setup.value[index] = value;
}

void thud_two_body_law(struct thud_two_body *pair, const struct thud_law *law)
{
    assert(law);
    pair->law = law;
    thud_law_defaults(law, &pair->setup);
}

static void start(struct thud_two_body *pair, const char *law)
{
    *pair = (struct thud_two_body){.mass_kg = {320e3, 320e3}, .approach_mps = 0.5, .duration_s = 0.3};
    thud_two_body_law(pair, thud_law_find(law));
}

void thud_two_body_concrete(struct thud_two_body *pair)
{
    start(pair, "kelvin-voigt-no-tension");
    thud_two_body_set(pair, "stiffness", 2500e6);
    thud_two_body_set(pair, "restitution", 0.6);
}

void thud_two_body_rubber(struct thud_two_body *pair)
{
    start(pair, "rubber");
    pair->setup.thickness_m = 0.05;
    thud_two_body_set(pair, "stiffness", 0.36e3 * pow(1000.0, 2.65));
    thud_two_body_set(pair, "exponent", 2.65);
    thud_two_body_set(pair, "max-strain", 0.8);
    thud_two_body_set(pair, "post-yield", 2500e6);
    thud_two_body_set(pair, "restitution", 0.5);
}

double thud_two_body_separation(const struct thud_solution *solution)
{
    const struct thud_history *h = thud_run_history(solution->run);
    const double *last = h->value + (h->rows - 1) * (size_t)h->columns;
    return last[thud_history_velocity(h, 1)] - last[thud_history_velocity(h, 0)];
}

/* Some methods let go of a force over several steps. */
static bool have_parted(const struct thud_two_body *pair, const struct thud_solution *solution)
{
    const struct thud_history *h = thud_run_history(solution->run);
    if (h->rows == 0)
        return false;
    const double *last = h->value + (h->rows - 1) * (size_t)h->columns;
    const double apart = last[thud_history_displacement(h, 1)] - last[thud_history_displacement(h, 0)];
    return apart > 40 * pair->method_step_s * thud_two_body_separation(solution) && apart > 0;
}

enum thud_status thud_two_body_assemble(const struct thud_two_body *pair, struct thud_model **model,
                                        struct thud_error *err)
{
    const double stiffness_npm = pair->mass_kg[0] * pair->spring_radps * pair->spring_radps;
    struct thud_structure_input bodies[2] = {{.n = 1,
                                              .mass_kg = &pair->mass_kg[0],
                                              .stiffness_npm = stiffness_npm > 0 ? &stiffness_npm : NULL,
                                              .velocity_mps = pair->approach_mps}};
    if (!pair->wall)
        bodies[1] = (struct thud_structure_input){.n = 1, .mass_kg = &pair->mass_kg[1]};
    struct thud_contact_input contact = {.interface = 1,
                                         .left_floor = 1,
                                         .right_floor = !pair->wall,
                                         .left_structure = 0,
                                         .right_structure = 1,
                                         .clearance_m = pair->clearance_m,
                                         .law = pair->law,
                                         .setup = pair->setup};
    struct thud_model_input input = {
        .nstructures = pair->law ? 2 : 1, .structure = bodies, .ncontacts = pair->law != NULL, .contact = &contact};
    return thud_model_create(&input, model, err);
}

enum thud_status thud_two_body_run(const struct thud_two_body *pair, double step_s, struct thud_solution *out,
                                   struct thud_error *err)
{
    struct thud_run_options options;
    bool done = false;
    *out = (struct thud_solution){0};
    thud_run_options_init(&options);
    options.tolerance = tolerance;
    options.tail_s = pair->duration_s;
    options.method = pair->method;
    if (pair->method && pair->method->flags & THUD_METHOD_FIXED_STEP) {
        options.step_s = pair->method_step_s;
        options.locate = pair->locate;
    }
    options.keep_impacts = options.keep_history = options.unjudged = true;
    options.history_step_s = step_s;
    enum thud_status status = thud_two_body_assemble(pair, &out->model, err);
    if (status == THUD_OK)
        status = thud_run_create(out->model, NULL, &options, &out->run, err);
    while (status == THUD_OK && !done && !(pair->until_parted && have_parted(pair, out)))
        status = thud_run_advance(out->run, pair->until_parted ? 50 : 1000, &done, err);
    if (status != THUD_OK)
        thud_solution_clear(out);
    return status;
}
