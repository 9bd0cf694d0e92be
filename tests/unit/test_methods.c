/* The methods beside each other: where each is stable, what impacts do to its energy, and how close they come to the
 * exact propagation of whole towers. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "core/model/step_watch.h"
#include "law_examples.h"
#include "march.h"

/* A free oscillation of 3000 steps of `angle` each: whether it stays bounded. If not, the run must say so. */
static bool bounded(const char *method, double angle)
{
    const double omega = 20;
    struct thud_model *model = march_mass_and_wall(1, omega, 0, 1, 0, NULL);
    struct march m = march_run(model, NULL, method, angle / omega, 0, true, 3000 * angle / omega);
    enum thud_status status = m.status;
    if (status != THUD_OK) {
        ck_assert_int_eq(status, THUD_DIVERGED);
        ck_assert_ptr_nonnull(strstr(m.err.what, "t = "));
        ck_assert_ptr_nonnull(strstr(m.err.what, "floor 1"));
        ck_assert_ptr_nonnull(strstr(m.err.allowed, "step used"));
        ck_assert_str_eq(m.err.key, method);
        /* and no absurd peaks: an end beyond a hundred times the first speed is not observed, and between two ends a
         * cubic's rate is at most that of its ends and 3/2 of what the displacements differ by */
        ck_assert_double_lt(m.result->structure[0].floor[0].velocity.value, 100.2 * (1 + 3 / angle));
    }
    march_free(&m);
    thud_model_free(model);
    return status == THUD_OK;
}

/* The same with a mass pressed against a softer wall, u = u0 (1 - cos): the contact's stiffness counts. Where that
 * grows it soon leaves the wall, and may go on bounded. */
static bool bounded_in_contact(const char *method, double angle)
{
    const double total = sqrt(1600 + 400), u0 = 400.0 / 2000;
    struct march_law law = march_law("linear", "stiffness", 400.0, NULL);
    struct thud_model *model = march_mass_and_wall(1, 40, 0, 0, -1, &law);
    struct march m = march_run(model, NULL, method, angle / total, 0, true, 3000 * angle / total);
    bool small = m.status == THUD_OK && m.result->structure[0].floor[0].displacement.value < 1.05 * 2 * u0;
    march_free(&m);
    thud_model_free(model);
    return small;
}

START_TEST(stability_limits_from_both_sides)
{
    int limited = 0;
    for (int i = 0; i < thud_method_count(); i++) {
        const struct thud_method *method = thud_method_at(i);
        if (!(method->flags & THUD_METHOD_FIXED_STEP))
            continue;
        if (isinf(method->stability)) {
            for (double angle = 0.1; angle < 200; angle *= 3)
                ck_assert_msg(bounded(method->name, angle), "%s at %g", method->name, angle);
            continue;
        }
        limited++;
        double below = 0.99 * method->stability, above = 1.01 * method->stability;
        ck_assert_msg(bounded(method->name, below), "%s", method->name);
        ck_assert_msg(!bounded(method->name, above), "%s", method->name);
        ck_assert_msg(bounded_in_contact(method->name, below), "%s", method->name);
        ck_assert_msg(!bounded_in_contact(method->name, above), "%s", method->name);
    }
    ck_assert_int_ge(limited, 3); /* and those that are added */
}
END_TEST

/* Energy at the end over that at the start: one mass between its spring and a wall spring, 50 s, nothing lost, nothing
 * located. INFINITY: blown up. */
static double energy_kept(const char *method, double angle)
{
    const double contact = 88.4, omega = 15.79, gap = 0.02;
    struct march_law law = march_law("linear", "stiffness", contact * contact, NULL);
    struct thud_model *model = march_mass_and_wall(1, omega, 0, 1, gap, &law);
    struct march m = march_run(model, NULL, method, angle / contact, 0, false, 50);
    double kept = INFINITY;
    if (m.status == THUD_OK) {
        double u = march_displacement(&m, 0), v = march_velocity(&m, 0), d = fmax(u - gap, 0);
        kept = v * v + omega * omega * u * u + contact * contact * d * d;
    }
    march_free(&m);
    thud_model_free(model);
    return kept;
}

START_TEST(energy_after_fifty_seconds_of_impacts)
{
    const struct {
        const char *method;
        double angle, least, most;
    } table[] = {
        {"newmark", 0.12, 0.97, 1.03},
        {"central-difference", 0.12, 0.97, 1.03},
        {"rk4", 0.12, 0.98, 1.01},
        {"hht", 0.12, 0.95, 0.995},
        {"generalized-alpha", 0.12, 0.97, 1.03},
        {"kr-alpha", 0.12, 1.05, 1.25},
        {"newmark", 0.5, 0.8, 1.2},
        {"central-difference", 0.5, 0.85, 1.2},
        {"rk4", 0.5, 0.5, 0.85},
        {"hht", 0.5, 0.2, 0.6},
        {"generalized-alpha", 0.5, 0.8, 1.2},
        {"kr-alpha", 0.5, 100, 9000},
        {"rk4", 2, 0, 0.3},
        {"hht", 2, 0, 0.3},
        {"newmark", 2, 0.5, 3},
        {"central-difference", 2, INFINITY, INFINITY},
        {"kr-alpha", 2, INFINITY, INFINITY},
        {"newmark", 5, 10, INFINITY},
        {"rk4", 5, INFINITY, INFINITY},
        {"central-difference", 5, INFINITY, INFINITY},
        {"kr-alpha", 5, INFINITY, INFINITY},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        double kept = energy_kept(table[i].method, table[i].angle);
        ck_assert_msg(kept >= table[i].least && kept <= table[i].most, "%s at %g: %g, not %g to %g", table[i].method,
                      table[i].angle, kept, table[i].least, table[i].most);
    }
}
END_TEST

/* Two free bodies: the force lagged by one step is a negative damping omega^2 dt / 2, so that elastic bodies part
 * exp(pi omega dt / 2) times as fast as they met. The same step without the lag keeps the energy. */
START_TEST(a_lagged_force_throws_back_faster)
{
    const double omega = 100;
    struct march_law law = march_law("linear", "stiffness", omega * omega * 0.5, NULL);
    struct thud_model *model = march_two_bodies(1, 1, 1, 1e-3, &law);
    for (double angle = 0.125; angle > 0.01; angle /= 10) {
        double step = angle / omega, want = exp(THUD_PI * angle / 2);
        struct march lagged = march_run(model, NULL, "lagged", step, 0, true, 0.1);
        struct march newmark = march_run(model, NULL, "newmark", step, 0, false, 0.1);
        double rebound = march_velocity(&lagged, 1) - march_velocity(&lagged, 0);
        double fair = march_velocity(&newmark, 1) - march_velocity(&newmark, 0);
        ck_assert_double_eq_tol(rebound, want, 0.15 * (want - 1));
        ck_assert_double_eq_tol(fair, 1, 0.15 * (want - 1));
        march_free(&lagged);
        march_free(&newmark);
    }
    thud_model_free(model);
}
END_TEST

static struct march_law rubber(void)
{
    return march_law("rubber", "stiffness", 0.36e3 * pow(1000, 2.65), "exponent", 2.65, "restitution", 0.5,
                     "max-strain", 0.8, "post-yield", 2.5e9, "thickness", 0.05, NULL);
}
static struct march_law concrete(void)
{
    return march_law("kelvin-voigt-no-tension", "stiffness", 2.5e9, "restitution", 0.6, NULL);
}

static void towers_agree(const struct thud_record *record, double gap, const struct march_law *law, const char *method,
                         double step, double tolerance, double apart)
{
    const int storeys[] = {4, 6};
    struct thud_model *model = march_row(2, storeys, false, gap, law);
    struct march want = march_run(model, record, "exact", 0, 1e-8, true, 2);
    struct march got = march_run(model, record, method, step, tolerance, true, 2);
    ck_assert_int_eq(want.status, THUD_OK);
    ck_assert_msg(got.status == THUD_OK, "%s: %s", method, got.err.what);
    double found = march_peaks_apart(got.result, want.result, 0.05);
    ck_assert_int_gt(want.result->contact[3].impacts, 0);
    ck_assert_msg(found < apart, "%s, gap %g: %.2e", method, gap, found);
    march_free(&want);
    march_free(&got);
    thud_model_free(model);
}

/* Deep enough for the bumpers to bottom out and stick. */
START_TEST(dormand_prince_on_towers)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law laws[] = {rubber(), concrete()};
    for (double gap = 0.01; gap < 0.06; gap += 0.02)
        for (int i = 0; i < 2; i++)
            towers_agree(record, gap, &laws[i], "dormand-prince", 0, 1e-6, 1e-5);
    thud_record_free(record);
}
END_TEST

START_TEST(fixed_steps_on_towers)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law laws[] = {rubber(), concrete()};
    for (int i = 0; i < 2; i++) {
        towers_agree(record, 0.02, &laws[i], "rk4", 5e-4, 0, 1e-5);
        towers_agree(record, 0.02, &laws[i], "newmark", 1e-4, 0, 5e-4);
        towers_agree(record, 0.02, &laws[i], "central-difference", 1e-4, 0, 5e-4);
        towers_agree(record, 0.02, &laws[i], "hht", 1e-4, 0, 1e-3);
        towers_agree(record, 0.02, &laws[i], "generalized-alpha", 1e-4, 0, 5e-4);
    }
    thud_record_free(record);
}
END_TEST

/* Steps half as coarse as the record's: contacts may not chatter, and what is found is no more than coarse. */
START_TEST(coarse_located_steps_on_towers)
{
    static const char *const name[] = {"central-difference", "newmark", "hht", "generalized-alpha"};
    struct thud_record *record = march_motion(1.5);
    struct march_law laws[] = {rubber(), concrete()};
    for (int i = 0; i < 2; i++)
        for (size_t k = 0; k < sizeof name / sizeof *name; k++)
            for (double step = 0.01; step > 0.002; step /= 2)
                towers_agree(record, 0.03, &laws[i], name[k], step, 0, 1);
    thud_record_free(record);
}
END_TEST

/* Everything that does not locate still comes near: 10 %. */
START_TEST(what_does_not_locate_comes_near)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law law = rubber();
    towers_agree(record, 0.03, &law, "dormand-prince-unlocated", 0, 1e-5, 0.1);
    towers_agree(record, 0.03, &law, "kr-alpha", 1e-4, 0, 0.1);
    towers_agree(record, 0.03, &law, "lagged", 2e-5, 0, 0.1);
    thud_record_free(record);
}
END_TEST

/* Every law in every method, also from clearance 0 and at rest, where rounding decides who touches first; the located
 * ones with coarse steps still near the exact peaks. */
static void every_method(const struct march_law *law, double gap, bool isolated)
{
    const int storeys[] = {3, 4};
    struct thud_record *record = march_motion(1.5);
    struct thud_model *model = march_row(2, storeys, isolated, gap, law);
    struct march want = march_run(model, record, "exact", 0, 0, true, 2);
    for (int i = 0; i < thud_method_count(); i++) {
        const struct thud_method *method = thud_method_at(i);
        struct march m = march_run(model, record, method->name, 0, 0, true, 2);
        ck_assert_msg(m.status == THUD_OK, "%s, %s, gap %g: %s", method->name, law->law->name, gap, m.err.what);
        double peak = m.result->structure[0].floor[2].displacement.value;
        double ratio = peak / want.result->structure[0].floor[2].displacement.value;
        ck_assert_msg(!(method->flags & THUD_METHOD_LOCATES) || fabs(ratio - 1) < 0.1, "%s, %s, gap %g: %g",
                      method->name, law->law->name, gap, ratio);
        march_free(&m);
    }
    march_free(&want);
    thud_model_free(model);
    thud_record_free(record);
}

static struct march_law any_law(int i, double stiffness_npm)
{
    const char *name = thud_law_at(i)->name;
    return thud_law_param(thud_law_at(i), "stiffness") < 0 ? march_law(name, NULL)
           : strcmp(name, "rubber") == 0                   ? rubber()
                                                           : march_law(name, "stiffness", stiffness_npm, NULL);
}

START_TEST(every_law_in_every_method)
{
    for (int i = 0; i < thud_law_count(); i++) {
        struct march_law law = any_law(i, 2.5e9);
        for (int isolated = 0; isolated < 2; isolated++)
            every_method(&law, (i + isolated) % 2 ? 0 : 0.02, isolated);
    }
}
END_TEST

/* The work is counted: a step a step, an implicit step no more Newton steps than it needs. */
START_TEST(work_is_counted)
{
    struct march_law law = march_law("linear", "stiffness", 1e4, NULL);
    struct thud_model *model = march_mass_and_wall(1, 10, 0, 0, -0.5, &law); /* out of contact only after a while */
    struct march rk = march_run(model, NULL, "rk4", 1e-4, 0, false, 1e-3);
    ck_assert_int_eq(rk.result->work.steps, 10);
    ck_assert_int_eq(rk.result->work.force_evaluations,
                     4 * 10 + 2); /* a step ends where the next starts, but for the touch */
    ck_assert_int_eq(rk.result->work.rejected, 0);
    struct march cd = march_run(model, NULL, "newmark", 1e-4, 0, false, 1e-3);
    ck_assert_int_eq(cd.result->work.steps, 10);
    ck_assert_int_le(cd.result->work.force_evaluations, 4 * 10);
    march_free(&rk);
    march_free(&cd);
    thud_model_free(model);
}
END_TEST

static int count_step(void *context, const struct thud_moment *moment)
{
    (void)moment;
    ++*(long *)context;
    return 0;
}

/* A run in which nothing is located, by advances of one segment each: counted. shown: by each of its steps, counted too. */
static struct march unlocated(const struct thud_model *model, const struct thud_record *record, const char *method,
                              double step_s, long *shown, long *advances)
{
    struct march m = {.status = THUD_OK};
    const struct thud_step_watch watch = {.step = count_step, .context = shown};
    struct thud_run_options options;
    bool done = false;
    thud_run_options_init(&options);
    options.method = thud_method_find(method);
    options.locate = false;
    options.step_s = step_s;
    options.unjudged = true;
    options.watch = shown ? &watch : NULL;
    m.status = thud_run_create(model, record, &options, &m.run, &m.err);
    for (*advances = 0; m.status == THUD_OK && !done; ++*advances)
        m.status = thud_run_advance(m.run, 1, &done, &m.err);
    m.result = thud_run_result(m.run);
    return m;
}

/* Steps are proposed together while no contact closes. Where each of them is shown, each is taken alone, and the results are
 * the same, whatever the rows, the damping and the law. together: most of these steps are. */
static void same_by_single_steps(const struct thud_model *model, const struct thud_record *record, const char *method,
                                 double step_s, bool together)
{
    long shown = 0, advances, singles;
    struct march a = unlocated(model, record, method, step_s, NULL, &advances),
                 b = unlocated(model, record, method, step_s, &shown, &singles);
    const struct thud_result *x = a.result, *y = b.result;
    ck_assert_int_eq(a.status, b.status);
    ck_assert_str_eq(a.err.what, b.err.what);
    ck_assert_int_eq(x->work.steps, y->work.steps);
    ck_assert_int_eq(shown, y->work.steps - (b.status != THUD_OK));
    ck_assert_int_eq(singles, y->work.steps);
    ck_assert_msg((3 * advances < singles) == together, "%s: %ld of %ld", method, advances, singles);
    ck_assert_double_lt(march_peaks_apart(x, y, 1e-6), 1e-9);
    for (int s = 0; s < x->nstructures; s++)
        for (int i = 0; i < x->structure[s].floors; i++)
            ck_assert_double_eq_tol(x->structure[s].floor[i].acceleration.time_s,
                                    y->structure[s].floor[i].acceleration.time_s, 1e-9);
    for (int c = 0; c < x->ncontacts; c++) {
        ck_assert_int_eq(x->contact[c].impacts, y->contact[c].impacts);
        ck_assert_double_eq_tol(x->contact[c].impulse_ns, y->contact[c].impulse_ns,
                                1e-9 * (1 + y->contact[c].impulse_ns));
    }
    ck_assert_double_eq_tol(x->energy.input_j, y->energy.input_j, 1e-9 * fabs(y->energy.input_j) + 1e-12);
    ck_assert_double_eq_tol(x->energy.viscous_j, y->energy.viscous_j, 1e-9 * fabs(y->energy.viscous_j) + 1e-12);
    ck_assert_double_eq_tol(x->energy.error_ratio, y->energy.error_ratio, 1e-9);
    march_free(&a);
    march_free(&b);
}

START_TEST(steps_at_once_are_single_steps)
{
    static const char *const name[] = {"central-difference", "newmark", "newmark-linear", "hht", "generalized-alpha"};
    static const char *const others[] = {"kr-alpha", "rk4", "lagged"};
    const int storeys[] = {3, 4};
    struct thud_record *record = march_motion(1.5);
    for (int i = 0; i < thud_law_count(); i++)
        for (int isolated = 0; isolated < 2; isolated++) {
            struct march_law law = any_law(i, 4e8);
            struct thud_model *model = march_row(2, storeys, isolated, i % 3 ? 0.05 : 0.2, &law);
            same_by_single_steps(model, record, name[i % 5], 5e-4, true);
            for (int k = 0; k < 3 && i == 0; k++)
                same_by_single_steps(model, record, others[k], 1e-3, false);
            thud_model_free(model);
        }
    thud_record_free(record);
    struct march_law law = march_law("linear", "stiffness", 1e4, NULL);
    struct thud_model *drifting = march_mass_and_wall(1, 0, 0, 1, 0.5, &law), /* without a spring */
        *unstable = march_mass_and_wall(1, 20, 0, 1, 0, NULL);
    same_by_single_steps(drifting, NULL, "newmark", 1e-3, true);
    for (double angle = 2.02; angle < 2.07; angle += 0.01) /* at the same step, however it came */
        same_by_single_steps(unstable, NULL, "central-difference", angle / 20, true);
    thud_model_free(drifting);
    thud_model_free(unstable);
}
END_TEST

START_TEST(steps_are_checked_and_chosen)
{
    struct thud_model *model = march_mass_and_wall(1, 10, 0, 1, 0, NULL);
    struct march m = march_run(model, NULL, "newmark", 1e-12, 0, true, 1);
    ck_assert_int_eq(m.status, THUD_INPUT);
    ck_assert_str_eq(m.err.key, "step");
    m = march_run(model, NULL, "newmark", 0, 0, true, 10); /* a twentieth of the period of 0.628 s */
    ck_assert_int_eq(m.result->work.steps, (long)ceil(10 / (2 * THUD_PI / 10 / 20)));
    march_free(&m);
    thud_model_free(model);
}
END_TEST

/* What is promised of a tolerance: light floors on stiff storeys, undamped, whose fast modes hold hardly any energy. */
START_TEST(dormand_prince_keeps_its_tolerance)
{
    double mass[] = {2.3e3, 1.6e3, 358e3}, k[] = {932e6, 932e6, 932e6};
    struct thud_structure_input s = {.n = 3, .mass_kg = mass, .stiffness_npm = k};
    struct thud_model *model = NULL;
    struct thud_record *record = march_motion(1);
    ck_assert_int_eq(thud_model_create(&(struct thud_model_input){.nstructures = 1, .structure = &s}, &model, NULL),
                     THUD_OK);
    struct march exact = march_run(model, record, "exact", 0, 1e-6, true, 2);
    for (double tolerance = 1e-2; tolerance > 1e-8; tolerance /= 100) {
        struct march m = march_run(model, record, "dormand-prince", 0, tolerance, true, 2);
        ck_assert_int_eq(m.status, THUD_OK);
        ck_assert_double_le(march_peaks_apart(m.result, exact.result, 0), 10 * tolerance);
        ck_assert_double_le(thud_run_balance(m.run), 11 * tolerance); /* and the ledger follows it */
        ck_assert_double_le(m.result->energy.error_ratio, tolerance);
        march_free(&m);
    }
    march_free(&exact);
    thud_record_free(record);
    thud_model_free(model);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("methods");
    TCase *tcase = tcase_create("methods");
    tcase_set_timeout(tcase, 120);
    tcase_add_test(tcase, stability_limits_from_both_sides);
    tcase_add_test(tcase, energy_after_fifty_seconds_of_impacts);
    tcase_add_test(tcase, a_lagged_force_throws_back_faster);
    tcase_add_test(tcase, dormand_prince_on_towers);
    tcase_add_test(tcase, dormand_prince_keeps_its_tolerance);
    tcase_add_test(tcase, fixed_steps_on_towers);
    tcase_add_test(tcase, coarse_located_steps_on_towers);
    tcase_add_test(tcase, what_does_not_locate_comes_near);
    tcase_add_test(tcase, every_law_in_every_method);
    tcase_add_test(tcase, work_is_counted);
    tcase_add_test(tcase, steps_at_once_are_single_steps);
    tcase_add_test(tcase, steps_are_checked_and_chosen);
    suite_add_tcase(suite, tcase);
    return suite;
}
