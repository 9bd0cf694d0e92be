/* Test cases of a body that is pushed against a wall: slow contact onset, sticking, and endless bounces. */
#include <math.h>

#include "core/laws/law_closed_form.h"
#include "study/methods/stability_private.h"

static const double tight = 1e-9;

/* The paper's bumper on the wall, and a free body at it. */
static void bumper(struct thud_bouncer *b)
{
    thud_bouncer_init(b);
    b->free = true;
    b->clearance_m = 0;
    thud_bouncer_law(b, thud_law_find("rubber"));
    b->setup.thickness_m = 0.05;
    thud_bouncer_set(b, "stiffness", 0.36e3 * pow(1000.0, 2.65));
}

/* The ground moves away below the body: a push of `a` reached after `rise` s and held for `hold` s. */
static enum thud_status push(double a_mps2, double rise_s, double hold_s, struct thud_record **out,
                             struct thud_error *err)
{
    enum { SAMPLES = 4001 };
    double a[SAMPLES], dt = 1e-3;
    size_t n = 0;
    for (; n < SAMPLES && (double)n * dt <= rise_s + hold_s + 0.5 * dt; n++)
        a[n] = -a_mps2 * (rise_s > 0 ? fmin(1, (double)n * dt / rise_s) : 1);
    return thud_record_create(a, n, dt, out, err);
}

static double last_value(const struct thud_solution *solution, int column)
{
    const struct thud_history *h = thud_run_history(solution->run);
    return h->value[(h->rows - 1) * (size_t)h->columns + (size_t)column];
}

/* Speed at the end over the one that the energy stored at the largest indentation would give. */
static double rebound(const struct thud_solution *solution)
{
    const struct thud_model_contact *p = &solution->model->contact[0];
    const struct thud_history *h = thud_run_history(solution->run);
    double d = thud_run_result(solution->run)->contact[0].indentation.value;
    double v =
        sqrt(2 * thud_law_energy(p->law, &p->setup, &(struct thud_law_memory){0}, THUD_APPROACH, d) / p->setup.mass_kg);
    return -last_value(solution, thud_history_velocity(h, 0)) / v;
}

static enum thud_status slow_onset(struct thud_test_case *out, struct thud_error *err)
{
    struct thud_bouncer b;
    struct thud_record *record;
    *out = (struct thud_test_case){.name = "slow-onset",
                                   .scene = "contact onset at a billionth of 1 m/s, then pushed into the bumper, e 0.5",
                                   .quantity = "separation speed over that of the energy stored",
                                   .method = "damping by the speed of contact onset, no floor under it",
                                   .exact = 0.5};
    bumper(&b);
    b.velocity_mps = 1e-9;
    thud_bouncer_set(&b, "damping", 1); /* exact */
    enum thud_status status = push(25, 0, 0.02, &record, err);
    for (int i = 0; status == THUD_OK && i < 2; i++) {
        struct thud_solution solution;
        thud_bouncer_set(&b, "speed-floor", 1e-9);
        thud_bouncer_set(&b, "impact-speed", i); /* touch, energy */
        status = thud_bouncer_run(&b, record, thud_stepping_of("exact", tight, true), 2, &solution, NULL, err);
        if (status != THUD_OK)
            break;
        *(i ? &out->computed : &out->naive) = rebound(&solution);
        thud_solution_clear(&solution);
    }
    thud_record_free(record);
    return status;
}

/* Damping of the floor of 1 mm/s makes restitution stiff, of rate F C/m: all motions soon go on at -1/C. */
static enum thud_status stiff_restitution(struct thud_test_case *out, struct thud_error *err)
{
    struct thud_stepping how[2] = {thud_stepping_of("rk4", 1e-3, false), thud_stepping_of("exact", tight, true)};
    struct thud_bouncer b;
    struct thud_record *record;
    *out = (struct thud_test_case){.name = "stiff-restitution",
                                   .scene = "a bumper struck at 0.1 mm/s, pushed in and let go: stiff restitution",
                                   .quantity = "speed of the way back times C",
                                   .method = "Runge-Kutta of order 4, 1 ms, not located",
                                   .exact = 1};
    bumper(&b);
    b.velocity_mps = 1e-4;
    thud_bouncer_set(&b, "damping", 1); /* exact */
    enum thud_status status = push(25, 0, 0.02, &record, err);
    for (int i = 0; status == THUD_OK && i < 2; i++) {
        struct thud_solution solution;
        double *value = i ? &out->computed : &out->naive;
        status = thud_bouncer_run(&b, record, how[i], 1, &solution, NULL, err);
        if (thud_trial_failed(status))
            break;
        *value = INFINITY;
        if (status == THUD_OK)
            *value = -last_value(&solution, thud_history_velocity(thud_run_history(solution.run), 0)) *
                     thud_rubber_cv(0.5) / 1e-3;
        thud_solution_clear(&solution);
        status = THUD_OK;
    }
    thud_record_free(record);
    return status;
}

static enum thud_status pushed(const struct thud_bouncer *b, double a_mps2, double rise_s, struct thud_test_case *out,
                               bool force, struct thud_stepping naive, struct thud_error *err)
{
    struct thud_stepping how[2] = {naive, thud_stepping_of("exact", tight, true)};
    struct thud_record *record;
    enum thud_status status = push(a_mps2, rise_s, 3 - rise_s, &record, err);
    for (int i = 0; status == THUD_OK && i < 2; i++) {
        struct thud_solution solution;
        double *value = i ? &out->computed : &out->naive;
        status = thud_bouncer_run(b, record, how[i], 3, &solution, NULL, err);
        if (thud_trial_failed(status))
            break;
        const struct thud_history *h = thud_run_history(solution.run);
        if (status == THUD_DIVERGED)
            *value = INFINITY;
        else if (force)
            *value = last_value(&solution, thud_history_force(h, 0)) / (b->mass_kg * a_mps2);
        else
            *value = 1e3 * last_value(&solution, thud_history_displacement(h, 0));
        thud_solution_clear(&solution);
        status = THUD_OK;
    }
    thud_record_free(record);
    return status;
}

/* Past delta_u the force falls as soon as the approach ends, and the push brings the approach back. */
static enum thud_status sticking(struct thud_test_case *out, struct thud_error *err)
{
    struct thud_bouncer b;
    *out = (struct thud_test_case){.name = "force-jump",
                                   .scene = "a body pushed past delta_u by 20 MN and held there",
                                   .quantity = "contact force over the push",
                                   .method = "Newmark, 1 ms, no sticking rule",
                                   .exact = 1};
    bumper(&b);
    return pushed(&b, 62.5, 2, out, true, thud_stepping_of("newmark", 1e-3, false), err);
}

static enum thud_status zeno(struct thud_test_case *out, struct thud_error *err)
{
    struct thud_bouncer b;
    *out = (struct thud_test_case){
        .name = "bounces-without-end",
        .scene = "a body thrown up from a floor it falls back to, e 0.5: endless bounces in 0.1 s",
        .quantity = "depth in the floor at the end, mm",
        .method = "Runge-Kutta of order 4, 10 ms, not located",
        .exact = 0};
    bumper(&b);
    thud_bouncer_law(&b, thud_law_find("stereomechanical"));
    thud_bouncer_set(&b, "restitution", 0.5);
    return pushed(&b, 9.80665, 0, out, false, thud_stepping_of("rk4", 1e-2, false), err);
}

static enum thud_status make_at_rest(int index, struct thud_test_case *out, struct thud_error *err)
{
    static thud_test_case_fn *const show[THUD_TEST_CASES_REST] = {slow_onset, stiff_restitution, sticking, zeno};
    return show[index](out, err);
}

int thud_test_case_count(void)
{
    return THUD_TEST_CASES_ENERGY + THUD_TEST_CASES_ONSET + THUD_TEST_CASES_REST + 1;
}

enum thud_status thud_test_case_run(int index, struct thud_test_case *out, struct thud_error *err)
{
    if (index < THUD_TEST_CASES_ENERGY)
        return thud_test_case_energy(index, out, err);
    if (index == thud_test_case_count() - 1)
        return thud_test_case_yield(out, err);
    index -= THUD_TEST_CASES_ENERGY;
    return index < THUD_TEST_CASES_ONSET ? thud_test_case_onset(index, out, err)
                                         : make_at_rest(index - THUD_TEST_CASES_ONSET, out, err);
}
