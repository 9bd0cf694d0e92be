/* Test cases: small scenes in which a naive method fails. */
#include <math.h>

#include "core/laws/law_closed_form.h"
#include "study/methods/stability_private.h"

static const double tight = 1e-9;

/* ---- collisions of two free bodies ---- */

static enum thud_status collide_springs(double left_kg, double right_kg, double stiffness_npm, struct thud_stepping how,
                                        double *out, struct thud_error *err)
{
    struct thud_two_body pair;
    thud_two_body_concrete(&pair);
    thud_two_body_law(&pair, thud_law_find("linear"));
    thud_two_body_set(&pair, "stiffness", stiffness_npm);
    pair.mass_kg[0] = left_kg;
    pair.mass_kg[1] = right_kg;
    return thud_two_body_restitution(&pair, how, out, err);
}

/* Kelvin-Voigt without tension, whose damping gives the restitution exactly. */
static struct thud_two_body damped_pair(double restitution)
{
    struct thud_two_body pair;
    thud_two_body_concrete(&pair);
    thud_two_body_set(&pair, "restitution", restitution);
    thud_two_body_set(&pair, "damping", 1); /* exact */
    return pair;
}

static enum thud_status lagged(struct thud_stepping how, double *out, struct thud_error *err)
{
    return collide_springs(320e3, 320e3, 2.5e9, how, out, err);
}

static enum thud_status stiff(struct thud_stepping how, double *out, struct thud_error *err)
{
    return collide_springs(320e3, 320e3, 1e13, how, out, err);
}

static enum thud_status mass_ratio(struct thud_stepping how, double *out, struct thud_error *err)
{
    return collide_springs(320e6, 320, 2.5e9, how, out, err);
}

static enum thud_status dead(struct thud_stepping how, double *out, struct thud_error *err)
{
    const struct thud_two_body pair = damped_pair(1e-3);
    return thud_two_body_restitution(&pair, how, out, err);
}

/* At contact onset the dashpot alone pushes, and where xi >= 1/2 never again as hard. */
static enum thud_status onset(struct thud_stepping how, double *out, struct thud_error *err)
{
    const double k = 2.5e9, mass = 160e3;
    struct thud_two_body pair = damped_pair(0.1);
    struct thud_solution solution;
    pair.method = how.method;
    pair.method_step_s = how.setting;
    const double dashpot = 2 * thud_kelvin_voigt_cut_xi(0.1) * sqrt(k * mass) * pair.approach_mps;
    enum thud_status status = thud_two_body_run(&pair, pair.duration_s, &solution, err);
    if (status == THUD_OK)
        *out = thud_run_result(solution.run)->contact[0].force.value / dashpot;
    thud_solution_clear(&solution);
    return status;
}

/* ---- a mass between its spring and a wall ---- */

static enum thud_status trapezoidal(struct thud_stepping how, double *out, struct thud_error *err)
{
    struct thud_two_body bouncer = thud_bouncer();
    struct thud_solution solution;
    thud_bouncer_spring(&bouncer, thud_stability_wall_radps);
    enum thud_status status = thud_bouncer_run(&bouncer, NULL, how, 50, &solution, NULL, err);
    if (status == THUD_OK)
        *out = thud_energy_ratio(&solution);
    thud_solution_clear(&solution);
    return status;
}

/* Impacts (with `speed` the first one's approach velocity) of a mass thrown `amplitude` times as far as the wall is. */
static enum thud_status throw_at_wall(double amplitude, bool speed, struct thud_stepping how, double *out,
                                      struct thud_error *err)
{
    struct thud_two_body bouncer = thud_bouncer();
    struct thud_solution solution;
    int count = 0;
    thud_bouncer_spring(&bouncer, 20 * thud_bouncer_omega_radps);
    bouncer.approach_mps = amplitude * bouncer.clearance_m * thud_bouncer_omega_radps;
    enum thud_status status = thud_bouncer_run(&bouncer, NULL, how, 0.4, &solution, NULL, err);
    if (status == THUD_OK) {
        const struct thud_impact *impact = thud_run_impacts(solution.run, &count);
        *out = speed && count > 0 ? impact[0].approach_mps : speed ? 0 : count;
    }
    thud_solution_clear(&solution);
    return status;
}

static enum thud_status grazing(struct thud_stepping how, double *out, struct thud_error *err)
{
    return throw_at_wall(1.0001, false, how, out, err);
}

static enum thud_status double_root(struct thud_stepping how, double *out, struct thud_error *err)
{
    return throw_at_wall(1.05, true, how, out, err);
}

static double exact_speed(void)
{
    const double amplitude = 1.05, gap = 0.02, omega = thud_bouncer_omega_radps;
    return omega * gap * sqrt(amplitude * amplitude - 1);
}

/* ---- a body that is pushed against a wall: slow contact onset, sticking, and endless bounces ---- */

/* The paper's bumper on the wall, and a free body at it. */
static struct thud_two_body at_bumper(double velocity_mps)
{
    struct thud_two_body b = thud_bouncer();
    b.spring_radps = b.clearance_m = 0;
    b.approach_mps = velocity_mps;
    thud_two_body_law(&b, thud_law_find("rubber"));
    b.setup.thickness_m = 0.05;
    thud_two_body_set(&b, "stiffness", 0.36e3 * pow(1000.0, 2.65));
    return b;
}

/* Runs the body while the ground moves away below it: a push of `a` reached after `rise` s and held until `end`. */
static enum thud_status push(const struct thud_two_body *b, double a_mps2, double rise_s, double end_s,
                             double duration_s, struct thud_stepping how, struct thud_solution *out,
                             struct thud_error *err)
{
    enum { SAMPLES = 4001 };
    double a[SAMPLES], dt = 1e-3;
    size_t n = 0;
    struct thud_record *record;
    for (; n < SAMPLES && (double)n * dt <= end_s + 0.5 * dt; n++)
        a[n] = -a_mps2 * (rise_s > 0 ? fmin(1, (double)n * dt / rise_s) : 1);
    *out = (struct thud_solution){0};
    enum thud_status status = thud_record_create(a, n, dt, &record, err);
    if (status != THUD_OK)
        return status;
    status = thud_bouncer_run(b, record, how, duration_s, out, NULL, err);
    thud_record_free(record);
    return status;
}

enum quantity { DISPLACEMENT, VELOCITY, FORCE };

static double at_the_end(const struct thud_solution *solution, enum quantity quantity)
{
    const struct thud_history *h = thud_run_history(solution->run);
    const int column = quantity == DISPLACEMENT ? thud_history_displacement(h, 0)
                       : quantity == VELOCITY   ? thud_history_velocity(h, 0)
                                                : thud_history_force(h, 0);
    return h->value[(h->rows - 1) * (size_t)h->columns + (size_t)column];
}

/* Speed at the end over the one that the energy stored at the largest indentation would give. */
static enum thud_status rebound(double impact_speed, struct thud_stepping how, double *out, struct thud_error *err)
{
    struct thud_two_body b = at_bumper(1e-9);
    struct thud_solution solution;
    thud_two_body_set(&b, "damping", 1); /* exact */
    thud_two_body_set(&b, "speed-floor", 1e-9);
    thud_two_body_set(&b, "impact-speed", impact_speed);
    enum thud_status status = push(&b, 25, 0, 0.02, 2, how, &solution, err);
    if (status == THUD_OK) {
        const struct thud_model_contact *p = &solution.model->contact[0];
        const double d = thud_run_result(solution.run)->contact[0].indentation.value,
                     stored = thud_law_energy(p->law, &p->setup, &(struct thud_law_memory){0}, THUD_APPROACH, d);
        *out = -at_the_end(&solution, VELOCITY) / sqrt(2 * stored / p->setup.mass_kg);
    }
    thud_solution_clear(&solution);
    return status;
}

static enum thud_status onset_by_touch(struct thud_stepping how, double *out, struct thud_error *err)
{
    return rebound(0, how, out, err);
}

static enum thud_status onset_by_energy(struct thud_stepping how, double *out, struct thud_error *err)
{
    return rebound(1, how, out, err);
}

/* A quantity at the end of a push; NaN: the run failed. */
static enum thud_status push_to_end(const struct thud_two_body *b, double a_mps2, double rise_s, double end_s,
                                    double duration_s, enum quantity quantity, struct thud_stepping how, double *out,
                                    struct thud_error *err)
{
    struct thud_solution solution;
    enum thud_status status = push(b, a_mps2, rise_s, end_s, duration_s, how, &solution, err);
    *out = status == THUD_OK ? at_the_end(&solution, quantity) : NAN;
    thud_solution_clear(&solution);
    return status;
}

/* Damping of the floor of 1 mm/s makes restitution stiff, of rate F C/m: all motions soon go on at -1/C. */
static enum thud_status stiff_restitution(struct thud_stepping how, double *out, struct thud_error *err)
{
    struct thud_two_body b = at_bumper(1e-4);
    thud_two_body_set(&b, "damping", 1); /* exact */
    enum thud_status status = push_to_end(&b, 25, 0, 0.02, 1, VELOCITY, how, out, err);
    *out = -*out * thud_rubber_cv(0.5) / 1e-3;
    return status;
}

/* Past delta_u the force falls as soon as the approach ends, and the push brings the approach back. */
static enum thud_status sticking(struct thud_stepping how, double *out, struct thud_error *err)
{
    const double push_mps2 = 62.5;
    const struct thud_two_body b = at_bumper(0.5);
    enum thud_status status = push_to_end(&b, push_mps2, 2, 3, 3, FORCE, how, out, err);
    *out /= b.mass_kg[0] * push_mps2;
    return status;
}

static enum thud_status zeno(struct thud_stepping how, double *out, struct thud_error *err)
{
    struct thud_two_body b = at_bumper(0.5);
    thud_two_body_law(&b, thud_law_find("stereomechanical"));
    thud_two_body_set(&b, "restitution", 0.5);
    enum thud_status status = push_to_end(&b, 9.80665, 0, 3, 3, DISPLACEMENT, how, out, err);
    *out *= 1e3;
    return status;
}

/* ---- a storey that yields: where it unloads lies within a step ---- */

/* Thrown at v, a storey with a yield drift d_y and no hardening is elastic to d_y and then slowed by a constant force:
 *     permanent drift = (v^2 - omega^2 d_y^2)/(2 omega^2 d_y)
 */
static const double storey_radps = 12, yield_m = 0.02, thrown_mps = 0.6;

static double exact_permanent_mm(void)
{
    const double w = storey_radps * yield_m;
    return 1e3 * (thrown_mps * thrown_mps - w * w) / (2 * storey_radps * w);
}

static enum thud_status unloading(struct thud_stepping how, double *out, struct thud_error *err)
{
    const double mass_kg = 320e3, stiffness_npm = mass_kg * storey_radps * storey_radps, hardening = 0;
    const struct thud_structure_input storey = {.n = 1,
                                                .mass_kg = &mass_kg,
                                                .stiffness_npm = &stiffness_npm,
                                                .velocity_mps = thrown_mps,
                                                .yield_m = &yield_m,
                                                .hardening = &hardening};
    const struct thud_model_input input = {.nstructures = 1, .structure = &storey};
    struct thud_solution solution;
    struct thud_run_options options;
    thud_run_options_init(&options);
    thud_stepping_apply(&how, &options);
    options.tail_s = 1;
    options.unjudged = true;
    enum thud_status status = thud_model_solve(&input, NULL, &options, &solution, err);
    if (status == THUD_OK)
        *out = 1e3 * thud_run_result(solution.run)->structure[0].storey[0].permanent_m;
    thud_solution_clear(&solution);
    return status;
}

/* ---- the table ---- */

typedef enum thud_status measure_fn(struct thud_stepping how, double *out, struct thud_error *err);

/* What a test case says, and its naive method: by name, with its step or tolerance. */
#define CASE(name_, scene_, quantity_, naive_, method_, setting_, measure_)                                            \
    .says = {.name = (name_), .scene = (scene_), .quantity = (quantity_), .method = (naive_)}, .method = (method_),    \
    .setting = (setting_), .measure = (measure_)
static const struct {
    struct thud_test_case says;
    const char *method;
    double setting;
    measure_fn *measure, *naive; /* naive: NULL where the naive method differs by its time stepping alone */
    double exact;
    double (*exact_of)(void); /* NULL: `exact` */
} rows[] = {
    {CASE("lagged-force", "two free bodies, elastic contact, omega dt 0.125", "separation over approach velocity",
          "contact force of the step before", "lagged", 1e-3, lagged),
     .exact = 1},
    {CASE("trapezoidal-growth", "undamped mass bouncing on a wall spring for 50 s, omega_c dt 5",
          "energy at the end over the start", "Newmark, average acceleration, not located", "newmark",
          5 / 62.83185307179586, trapezoidal),
     .exact = 1},
    {CASE("restitution-near-0", "two free bodies, Kelvin-Voigt without tension, e 0.001",
          "separation over approach velocity", "Newmark, 1 ms, not located", "newmark", 1e-3, dead),
     .exact = 1e-3},
    {CASE("stiffness-1e13", "two free bodies, elastic contact of 1e13 N/m", "separation over approach velocity",
          "Newmark, 1 ms, not located", "newmark", 1e-3, stiff),
     .exact = 1},
    {CASE("mass-ratio-1e6", "a body hits another of a millionth of its mass, elastic contact",
          "separation over approach velocity", "Newmark, 1 ms, not located", "newmark", 1e-3, mass_ratio),
     .exact = 1},
    {CASE("event-at-the-start", "two bodies that touch at t = 0, Kelvin-Voigt without tension, e 0.1",
          "largest force over the dashpot's at contact onset", "Newmark, 1 ms, not located", "newmark", 1e-3, onset),
     .exact = 1},
    {CASE("grazing-contact", "a swing that reaches a ten-thousandth past the wall, steps of 20 ms", "impacts",
          "Runge-Kutta of order 4, not located", "rk4", 0.02, grazing),
     .exact = 1},
    {CASE("double-root", "past the wall and back within one step of 0.1 s", "approach velocity, m/s",
          "Runge-Kutta of order 4, signs at step ends", "rk4", 0.1, double_root),
     .exact_of = exact_speed},
    {CASE("slow-onset", "contact onset at a billionth of 1 m/s, then pushed into the bumper, e 0.5",
          "separation speed over that of the energy stored", "damping by the speed of contact onset, no floor under it",
          "exact", 1e-9, onset_by_energy),
     .naive = onset_by_touch, .exact = 0.5},
    {CASE("stiff-restitution", "a bumper struck at 0.1 mm/s, pushed in and let go: stiff restitution",
          "speed of the way back times C", "Runge-Kutta of order 4, 1 ms, not located", "rk4", 1e-3, stiff_restitution),
     .exact = 1},
    {CASE("force-jump", "a body pushed past delta_u by 20 MN and held there", "contact force over the push",
          "Newmark, 1 ms, no sticking rule", "newmark", 1e-3, sticking),
     .exact = 1},
    {CASE("bounces-without-end", "a body thrown up from a floor it falls back to, e 0.5: endless bounces in 0.1 s",
          "depth in the floor at the end, mm", "Runge-Kutta of order 4, 10 ms, not located", "rk4", 1e-2, zeno),
     .exact = 0},
    {CASE("unloading-missed", "a storey thrown beyond its yield drift of 20 mm, steps of 50 ms", "permanent drift, mm",
          "Runge-Kutta of order 4, unloading at step ends", "rk4", 0.05, unloading),
     .exact_of = exact_permanent_mm},
};

int thud_test_case_count(void)
{
    return (int)(sizeof rows / sizeof *rows);
}

enum thud_status thud_test_case_run(int index, struct thud_test_case *out, struct thud_error *err)
{
    measure_fn *measure = rows[index].measure, *naive = rows[index].naive ? rows[index].naive : measure;
    *out = rows[index].says;
    out->exact = rows[index].exact_of ? rows[index].exact_of() : rows[index].exact;
    enum thud_status status =
        naive(thud_stepping_of(rows[index].method, rows[index].setting, rows[index].naive), &out->naive, err);
    if (status == THUD_DIVERGED) { /* a finding */
        out->naive = INFINITY;
        status = THUD_OK;
    }
    return status == THUD_OK ? measure(thud_stepping_of("exact", tight, true), &out->computed, err) : status;
}
