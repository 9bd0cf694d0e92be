#include "study/methods/published.h"
#include "base/quantity.h"

#include <math.h>

#include "core/laws/law_closed_form.h"
#include "ground/spectrum.h"
#include "study/scene/solution.h"
#include "study/scene/two_body.h"

static const double print = 5e-3;    /* relative: rounding of what is printed, and reading from it */
static const double identity = 1e-9; /* of two ways to compute one thing: rounding */
static const double put_in = 1e-6;   /* of a strength that was put in and comes back */

static const struct thud_published_info infos[THUD_PUBLISHED_COUNT] = {
    [THUD_PUBLISHED_CHOPRA] = {"Five-storey shear frame under El Centro, and its modes",
                               "Chopra, Dynamics of Structures, Example 13.2.6", "chopra-13.2.6",
                               "El Centro 1940, component S00E, as in the appendix of Chopra's book"},
    [THUD_PUBLISHED_NPTEL] = {"Two-storey frame under El Centro", "NPTEL, Structural Dynamics, Example 3.6",
                              "nptel-3.6", "El Centro 1940, component S00E, as in the appendix of Chopra's book"},
    [THUD_PUBLISHED_CHOPRA_YIELDING] = {"Elastoplastic oscillator under El Centro",
                                        "Chopra, Dynamics of Structures, Fig. 7.4.2", "chopra-7.4.2",
                                        "El Centro 1940, component S00E, as in the appendix of Chopra's book"},
    [THUD_PUBLISHED_NPTEL_YIELDING] = {"Two-storey elastoplastic frame under El Centro",
                                       "NPTEL, Structural Dynamics, Example 7.3", "nptel-7.3",
                                       "El Centro 1940, component S00E, as in the appendix of Chopra's book"},
    [THUD_PUBLISHED_VM65] = {"Mass that falls on a spring", "ANSYS Verification Manual VM65, after Thomson 4.6-1",
                             "ansys-vm65", NULL},
    [THUD_PUBLISHED_TWO_OSCILLATORS] = {"Two equal oscillators facing each other, and one before a wall at half the "
                                        "gap",
                                        "Code_Aster, validation manual v5.01.102", NULL, NULL},
    [THUD_PUBLISHED_LANKARANI] = {"Restitution that the damping of Lankarani and Nikravesh really gives at 0.3",
                                  "Lankarani and Nikravesh 1990; Ye, Li and Zhu 2009", NULL, NULL},
    [THUD_PUBLISHED_CART] = {"Cart of 0.575 kg against foam at 0.85 m/s; duration and restitution fitted, force not",
                             "cytronicoder, public data of an experiment; measured 5.38, 5.44 and 5.39 N", NULL, NULL},
    [THUD_PUBLISHED_PENDULUM] = {"Rigid mass on a friction pendulum under a sine of 1 m/s2 and 1 Hz: stick, slip and "
                                 "restoring force",
                                 "OpenSees, result of a user's script", NULL, NULL},
};

const struct thud_published_info *thud_published_info(enum thud_published which)
{
    return &infos[which];
}

struct rows {
    struct thud_published_row *row;
    int n;
};

/* `factor`: from the unit to SI. */
static void add_within(struct rows *rows, const char *quantity, const char *unit, double factor, double published,
                       double computed_si, double tolerance)
{
    double computed = computed_si / factor;
    double difference = published != 0 ? computed / published - 1 : computed;
    rows->row[rows->n++] = (struct thud_published_row){.quantity = quantity,
                                                       .unit = unit,
                                                       .published = published,
                                                       .computed = computed,
                                                       .difference = difference,
                                                       .tolerance = tolerance,
                                                       .holds = fabs(difference) <= tolerance};
}

/* What no one published: an identity, an input, another program's result. */
static void add_check(struct rows *rows, const char *quantity, const char *unit, double factor, double expected,
                      double computed_si, double tolerance)
{
    add_within(rows, quantity, unit, factor, expected, computed_si, tolerance);
    rows->row[rows->n - 1].check = true;
}

static void add(struct rows *rows, const char *quantity, const char *unit, double factor, double published,
                double computed_si)
{
    add_within(rows, quantity, unit, factor, published, computed_si, print);
}

/* A frame's peaks: of the top and the first floor's displacement, the base shear, the top storey's shear. */
struct frame {
    double top_m, first_m, base_n, top_n;
};

static struct frame frame_of(const struct thud_scene *scene, const struct thud_result *result)
{
    int top = result->structure[0].floors - 1;
    const struct thud_floor_result *f = &result->structure[0].floor[top];
    const struct thud_storey_result *storey = result->structure[0].storey;
    return (struct frame){f->displacement.value, result->structure[0].floor[0].displacement.value,
                          result->structure[0].base_shear.value,
                          storey ? storey[top].shear.value : f->drift.value * scene->structure[0].stiffness_npm[top]};
}

static enum thud_status run_frame(const struct thud_scene *scene, const struct thud_record *record, struct frame *out,
                                  struct thud_error *err)
{
    struct thud_solution solution;
    enum thud_status status = thud_scene_solve(scene, record, NULL, &solution, err);
    if (status == THUD_OK)
        *out = frame_of(scene, thud_run_result(solution.run));
    thud_solution_clear(&solution);
    return status;
}

/* One mode alone: an oscillator's largest displacement D from the response spectrum. With Phi^T M Phi = I,
 *     u_i = gamma phi_i D,   f_i = m_i omega^2 u_i,   V_i = sum of f_j from floor i up. */
static struct frame mode_alone(const struct thud_model *model, const struct thud_record *record, int mode)
{
    const struct thud_model_structure *s = &model->structure[0];
    double omega = model->omega[mode], gamma = model->gamma[mode];
    double d = thud_spectrum_at(record, 2 * THUD_PI / omega, model->zeta[mode]).displacement_m;
    struct frame frame = {.top_m = fabs(gamma * s->phi[(s->n - 1) * s->modes + mode]) * d};
    double shear = 0;
    for (int i = s->n - 1; i >= 0; i--) {
        shear += model->mass_kg[i] * omega * omega * gamma * s->phi[i * s->modes + mode] * d;
        if (i == s->n - 1)
            frame.top_n = fabs(shear);
    }
    frame.base_n = fabs(shear);
    return frame;
}

static enum thud_status need(const struct thud_scene *scene, const struct thud_record *record, int storeys,
                             struct thud_error *err)
{
    if (scene && record && scene->nstructures > 0 && scene->structure[0].kind == THUD_SHEAR &&
        scene->structure[0].storeys == storeys)
        return THUD_OK;
    return thud_error_set(err, THUD_INPUT, "the published numbers are of a shear building of %d storeys first",
                          storeys);
}

static enum thud_status chopra(const struct thud_scene *scene, const struct thud_record *record, struct rows *rows,
                               struct thud_error *err)
{
    static const char *const base_of[] = {"base shear, mode 1", "base shear, mode 2", "base shear, mode 3",
                                          "base shear, mode 4", "base shear, mode 5"};
    static const double base_kn[] = {266.571, 108.154, 43.524, 12.975, 2.622};
    struct thud_model *model = NULL;
    struct frame frame;
    enum thud_status status = need(scene, record, 5, err);
    if (status == THUD_OK)
        status = run_frame(scene, record, &frame, err);
    if (status == THUD_OK)
        status = thud_scene_assemble(scene, &model, err);
    if (status != THUD_OK)
        return status;
    add(rows, "displacement of floor 5", "cm", 1e-2, 17.383, frame.top_m);
    add(rows, "base shear", "kN", 1e3, 323.062, frame.base_n);
    add(rows, "shear of storey 5", "kN", 1e3, 155.308, frame.top_n);
    for (int mode = 0; mode < 5; mode++) {
        frame = mode_alone(model, record, mode);
        if (mode == 0) {
            add(rows, "displacement of floor 5, mode 1", "cm", 1e-2, 17.084, frame.top_m);
            add(rows, "shear of storey 5, mode 1", "kN", 1e3, 75.874, frame.top_n);
        }
        add(rows, base_of[mode], "kN", 1e3, base_kn[mode], frame.base_n);
    }
    thud_model_free(model);
    return THUD_OK;
}

static enum thud_status nptel(const struct thud_scene *scene, const struct thud_record *record, struct rows *rows,
                              struct thud_error *err)
{
    struct frame frame;
    enum thud_status status = need(scene, record, 2, err);
    if (status == THUD_OK)
        status = run_frame(scene, record, &frame, err);
    if (status != THUD_OK)
        return status;
    add(rows, "displacement of the top floor", "m", 1, 0.202, frame.top_m);
    add(rows, "base shear", "kN", 1e3, 40.72, frame.base_n);
    return THUD_OK;
}

/* Storeys that yield in the scene as written. */
static enum thud_status yielding(const struct thud_scene *scene, const struct thud_record *record, int storeys,
                                 struct frame *out, struct thud_error *err)
{
    enum thud_status status = need(scene, record, storeys, err);
    if (status == THUD_OK && !thud_scene_yields(scene))
        status = thud_error_set(err, THUD_INPUT, "the published numbers are of storeys that yield");
    return status == THUD_OK ? run_frame(scene, record, out, err) : status;
}

static enum thud_status chopra_yielding(const struct thud_scene *scene, const struct thud_record *record,
                                        struct rows *rows, struct thud_error *err)
{
    struct frame frame;
    enum thud_status status = yielding(scene, record, 1, &frame, err);
    if (status != THUD_OK)
        return status;
    add(rows, "largest displacement", "cm", 1e-2, 4.34, frame.top_m);
    return THUD_OK;
}

static enum thud_status nptel_yielding(const struct thud_scene *scene, const struct thud_record *record,
                                       struct rows *rows, struct thud_error *err)
{
    struct frame frame;
    enum thud_status status = yielding(scene, record, 2, &frame, err);
    if (status != THUD_OK)
        return status;
    add(rows, "displacement of the top floor", "m", 1, 0.1483, frame.top_m);
    add(rows, "displacement of the first floor", "m", 1, 0.068, frame.first_m);
    for (int s = 0; s < 2; s++) /* at their strengths, which are inputs */
        add_check(rows, s == 0 ? "shear of the first storey" : "shear of the second storey", "kN", 1e3,
                  1e-3 * scene->structure[0].stiffness_npm[s] * scene->structure[0].yield_m[s],
                  s == 0 ? frame.base_n : frame.top_n, put_in);
    return THUD_OK;
}

static enum thud_status vm65(const struct thud_scene *scene, const struct thud_record *record, struct rows *rows,
                             struct thud_error *err)
{
    struct thud_run_options options;
    struct thud_solution solution = {0};
    int impacts = 0;
    if (!scene || !record || scene->nstructures != 2 || scene->structure[1].kind != THUD_RIGID)
        return thud_error_set(err, THUD_INPUT, "the published numbers are of a body that falls on a wall's spring");
    enum thud_status status = thud_scene_options(scene, &options, err);
    options.keep_impacts = true;
    if (status == THUD_OK)
        status = thud_scene_solve(scene, record, &options, &solution, err);
    if (status == THUD_OK) {
        const struct thud_impact *impact = thud_run_impacts(solution.run, &impacts);
        double inch = 0.0254;
        add(rows, "time of touch", "s", 1, 0.071982, impacts > 0 ? impact[0].start_s : NAN);
        add(rows, "speed of touch", "in/s", inch, 27.785, impacts > 0 ? impact[0].approach_mps : NAN);
        add(rows, "largest drop", "in", inch, 1.5507,
            thud_run_result(solution.run)->structure[1].floor[0].displacement.value);
    }
    thud_solution_clear(&solution);
    return status;
}

/* The largest force and indentation of oscillators (320 t, 5 %, period 0.7 s) that start at 0.5 m/s towards each other,
 * 4 cm apart; or of the left one before a wall at half the gap, on the left half of the contact, which is twice as
 * stiff. The concrete of Polycarpou and Komodromos: its dashpot c = 2 xi sqrt(k m) doubles too, since m does. */
static enum thud_status oscillators(bool wall, double *force_n, double *indentation_m, struct thud_error *err)
{
    const double mass_kg = 320e3, stiffness_npm = mass_kg * pow(2 * THUD_PI / 0.7, 2), duration_s = 2;
    struct thud_structure_input side[2] = {
        {.n = 1, .mass_kg = &mass_kg, .stiffness_npm = &stiffness_npm, .damping = 0.05, .velocity_mps = 0.5},
        {.n = 1, .mass_kg = &mass_kg, .stiffness_npm = &stiffness_npm, .damping = 0.05, .velocity_mps = -0.5},
    };
    struct thud_two_body pair;
    thud_two_body_concrete(&pair);
    if (wall) {
        side[1] = (struct thud_structure_input){.n = 0};
        thud_two_body_set(&pair, "stiffness", 2 * pair.setup.value[thud_law_param(pair.law, "stiffness")]);
    }
    struct thud_contact_input contact = {.interface = 1,
                                         .left_floor = 1,
                                         .right_floor = wall ? 0 : 1,
                                         .left_structure = 0,
                                         .right_structure = 1,
                                         .clearance_m = wall ? 0.02 : 0.04,
                                         .law = pair.law,
                                         .setup = pair.setup};
    struct thud_model_input input = {.nstructures = 2, .structure = side, .ncontacts = 1, .contact = &contact};
    struct thud_run_options options;
    struct thud_solution solution;
    thud_run_options_init(&options);
    options.tail_s = duration_s;
    enum thud_status status = thud_model_solve(&input, NULL, &options, &solution, err);
    if (status == THUD_OK) {
        const struct thud_contact_result *r = &thud_run_result(solution.run)->contact[0];
        *force_n = r->force.value;
        *indentation_m = r->indentation.value;
    }
    thud_solution_clear(&solution);
    return status;
}

static enum thud_status two_oscillators(struct rows *rows, struct thud_error *err)
{
    double force[2], indentation[2];
    enum thud_status status = oscillators(false, &force[0], &indentation[0], err);
    if (status == THUD_OK)
        status = oscillators(true, &force[1], &indentation[1], err);
    if (status != THUD_OK)
        return status;
    add_check(rows, "relative difference of the forces", "", 1, 0, force[0] / force[1] - 1, identity);
    add_check(rows, "relative difference of the indentations", "", 1, 0, indentation[0] / (2 * indentation[1]) - 1,
              identity);
    return THUD_OK;
}

static enum thud_status lankarani(struct rows *rows, struct thud_error *err)
{
    struct thud_solution solution = {0};
    struct thud_two_body pair;
    thud_two_body_concrete(&pair);
    thud_two_body_law(&pair, thud_law_find("hertz-damp")); /* formula muthukumar: 3 (1 - e^2)/4, as both have it */
    thud_two_body_set(&pair, "restitution", 0.3);
    enum thud_status status = thud_two_body_run(&pair, 0, &solution, err);
    if (status == THUD_OK)
        add(rows, "restitution of two bodies of 320 t", "", 1, 0.684,
            thud_two_body_separation(&solution) / pair.approach_mps);
    thud_solution_clear(&solution);
    return status;
}

/* The linear law that is cut at zero force parts with e after the time t when
 *     e = exp(-2 xi acos(xi)/sqrt(1 - xi^2)),   omega sqrt(1 - xi^2) t = 2 acos(xi). */
static enum thud_status cart(struct rows *rows, struct thud_error *err)
{
    const double mass_kg = 0.575, approach_mps = 0.85, e = 0.875, duration_s = 0.26;
    const double measured_n = (5.38 + 5.44 + 5.39) / 3;
    double xi = thud_kelvin_voigt_cut_xi(e), damped = sqrt(1 - xi * xi), omega = 2 * acos(xi) / (damped * duration_s);
    struct thud_solution solution = {0};
    struct thud_two_body pair;
    thud_two_body_concrete(&pair);
    pair.mass_kg[0] = pair.mass_kg[1] = 2 * mass_kg; /* two bodies of twice the mass are one before a wall */
    pair.approach_mps = approach_mps;
    pair.duration_s = 2 * duration_s;
    thud_two_body_set(&pair, "stiffness", mass_kg * omega * omega);
    thud_two_body_set(&pair, "restitution", e);
    thud_two_body_set(&pair, "damping", 1); /* exact */
    enum thud_status status = thud_two_body_run(&pair, 0, &solution, err);
    if (status == THUD_OK)
        add(rows, "largest force, mean of three", "N", 1, measured_n,
            thud_run_result(solution.run)->contact[0].force.value);
    thud_solution_clear(&solution);
    return status;
}

/* R 2 m, mu 0.05, initial stiffness 1e5 kN/m, 20 s. */
static enum thud_status pendulum(struct rows *rows, struct thud_error *err)
{
    enum { EACH_S = 200, SAMPLES = 20 * EACH_S + 1 };
    const double mass_kg = 100e3, weight_n = mass_kg * THUD_GRAVITY, beyond_npm = weight_n / 2, stiffness_npm = 1e8,
                 yield_m = 0.05 * weight_n / (stiffness_npm - beyond_npm), hardening = beyond_npm / stiffness_npm;
    const struct thud_structure_input structure = {
        .n = 1, .mass_kg = &mass_kg, .stiffness_npm = &stiffness_npm, .yield_m = &yield_m, .hardening = &hardening};
    const struct thud_model_input input = {.nstructures = 1, .structure = &structure};
    struct thud_run_options options;
    struct thud_solution answer = {0};
    struct thud_record *record = NULL;
    double a[SAMPLES];
    for (int i = 0; i < SAMPLES; i++)
        a[i] = sin(2 * THUD_PI * i / EACH_S);
    thud_run_options_init(&options);
    options.tail_s = 0;
    enum thud_status status = thud_record_create(a, SAMPLES, 1.0 / EACH_S, &record, err);
    if (status == THUD_OK)
        status = thud_model_solve(&input, record, &options, &answer, err);
    if (status == THUD_OK)
        add_check(rows, "largest displacement, OpenSees", "m", 1, 0.034029,
                  thud_run_result(answer.run)->structure[0].floor[0].displacement.value, print);
    thud_solution_clear(&answer);
    thud_record_free(record);
    return status;
}

/* Those of a scene and its ground motion, and those that need neither. */
typedef enum thud_status of_scene(const struct thud_scene *scene, const struct thud_record *record, struct rows *rows,
                                  struct thud_error *err);
typedef enum thud_status alone(struct rows *rows, struct thud_error *err);

enum thud_status thud_published_compute(enum thud_published which, const struct thud_scene *scene,
                                        const struct thud_record *record, struct thud_published_row *row, int *n,
                                        struct thud_error *err)
{
    static of_scene *const scenes[THUD_PUBLISHED_COUNT] = {[THUD_PUBLISHED_CHOPRA] = chopra,
                                                           [THUD_PUBLISHED_NPTEL] = nptel,
                                                           [THUD_PUBLISHED_CHOPRA_YIELDING] = chopra_yielding,
                                                           [THUD_PUBLISHED_NPTEL_YIELDING] = nptel_yielding,
                                                           [THUD_PUBLISHED_VM65] = vm65};
    static alone *const others[THUD_PUBLISHED_COUNT] = {[THUD_PUBLISHED_TWO_OSCILLATORS] = two_oscillators,
                                                        [THUD_PUBLISHED_LANKARANI] = lankarani,
                                                        [THUD_PUBLISHED_CART] = cart,
                                                        [THUD_PUBLISHED_PENDULUM] = pendulum};
    struct rows rows = {.row = row};
    enum thud_status status = scenes[which] ? scenes[which](scene, record, &rows, err) : others[which](&rows, err);
    *n = rows.n;
    return status;
}
