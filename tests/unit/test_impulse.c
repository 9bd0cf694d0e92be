/* Stereomechanical contact against closed forms: bounces down to rest, holding, blows passed on. */
#include <check.h>
#include <math.h>
#include <string.h>

#include "base/quantity.h"
#include "core/run/run_private.h"

static const struct thud_law *newton(double e, struct thud_law_setup *setup)
{
    const struct thud_law *law = thud_law_find("stereomechanical");
    memset(setup, 0, sizeof *setup);
    thud_law_defaults(law, setup);
    setup->value[thud_law_param(law, "restitution")] = e;
    return law;
}

static const struct thud_law *no_tension(double stiffness, double restitution, struct thud_law_setup *setup)
{
    const struct thud_law *law = thud_law_find("kelvin-voigt-no-tension");
    memset(setup, 0, sizeof *setup);
    thud_law_defaults(law, setup);
    setup->value[thud_law_param(law, "stiffness")] = stiffness;
    setup->value[thud_law_param(law, "restitution")] = restitution;
    setup->value[thud_law_param(law, "residual")] = 1; /* it springs back */
    return law;
}

/* A row of `n` rigid bodies (a wall at the right end where wall is set), all contacts with clearance `gap`. */
static struct thud_model *row(int n, const double *mass, const double *speed, bool wall, double gap, double e)
{
    struct thud_structure_input body[8];
    struct thud_contact_input contact[8];
    for (int i = 0; i < n; i++)
        body[i] = (struct thud_structure_input){.n = 1, .mass_kg = &mass[i], .velocity_mps = speed[i]};
    body[n] = (struct thud_structure_input){.n = 0};
    int contacts = wall ? n : n - 1;
    for (int i = 0; i < contacts; i++) {
        contact[i] = (struct thud_contact_input){.interface = i + 1,
                                                 .left_floor = 1,
                                                 .right_floor = i + 1 < n,
                                                 .left_structure = i,
                                                 .right_structure = i + 1,
                                                 .clearance_m = gap};
        contact[i].law = newton(e, &contact[i].setup);
    }
    struct thud_model_input input = {
        .nstructures = n + wall, .structure = body, .ncontacts = contacts, .contact = contact};
    struct thud_model *model = NULL;
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    return model;
}

static struct thud_run *finish(const struct thud_model *model, const struct thud_record *record, double tail)
{
    struct thud_run_options options;
    struct thud_run *run;
    struct thud_error err = {0};
    bool done = false;
    thud_run_options_init(&options);
    options.keep_impacts = options.keep_history = true;
    options.tail_s = tail;
    ck_assert_int_eq(thud_run_create(model, record, &options, &run, &err), THUD_OK);
    ck_assert_msg(thud_run_advance(run, 1000000, &done, &err) == THUD_OK, "%s", err.what);
    ck_assert(done);
    return run;
}

/* A ball thrown at a wall by a ground that accelerates by 10 m/s2 for 4 s and then back: contact onset after sqrt(2
 * h/a), bounces shorter by e each, at rest after (1 + e)/(1 - e) times the first time, held with m a until the ground
 * turns.
 */
START_TEST(bounces_down_to_rest)
{
    enum { N = 501 };
    static double a[N];
    for (int i = 0; i < N; i++)
        a[i] = i < 400 ? -10 : 10;
    struct thud_record record = {.dt_s = 0.01, .samples = N, .a_mps2 = a};
    double mass = 1000, speed = 0, e = 0.5, t0 = sqrt(0.2);
    struct thud_model *model = row(1, &mass, &speed, true, 1.0, e);
    struct thud_run *run = finish(model, &record, 0);
    int n;
    const struct thud_impact *impact = thud_run_impacts(run, &n);
    double at = t0, v = 10 * t0;
    for (int i = 0; i < 12; i++) {
        ck_assert_double_eq_tol(impact[i].start_s, at, 1e-12);
        ck_assert_double_eq_tol(impact[i].approach_mps, v, 1e-10);
        ck_assert_double_eq_tol(impact[i].separation_mps, e * v, 1e-10);
        ck_assert_double_eq_tol(impact[i].impulse_ns, mass * (1 + e) * v, 1e-6);
        v *= e;
        at += 2 * v / 10;
    }
    const struct thud_impact *held = &impact[n - 1];
    ck_assert_double_eq_tol(held->start_s, t0 * (1 + e) / (1 - e), 1e-8);
    ck_assert_double_eq_tol(held->start_s + held->duration_s, 3.995, 1e-9); /* where the ground passes through 0 */
    const struct thud_contact_result *c = &thud_run_result(run)->contact[0];
    ck_assert_double_eq_tol(c->force.value, mass * 10, 1e-2);
    ck_assert_double_eq_tol(
        c->impulse_ns, mass * (1 + e) * 10 * t0 / (1 - e) + mass * 10 * (3.99 - held->start_s) + mass * 0.025, 1e-3);
    ck_assert_double_lt(thud_run_result(run)->energy.error_ratio, 1e-12);
    thud_run_free(run);
    thud_model_free(model);
}
END_TEST

/* The same throw a million times smaller, by a power of two: comes to rest at the same bounce and the same moment. */
START_TEST(rest_has_no_size_of_its_own)
{
    enum { N = 201 };
    double mass = 1000, speed = 0, end[2] = {0};
    int impacts[2] = {0};
    for (int small = 0; small < 2; small++) {
        double a[N], size = small ? 0x1p-20 : 1;
        for (int i = 0; i < N; i++)
            a[i] = -10 * size;
        struct thud_record record = {.dt_s = 0.01, .samples = N, .a_mps2 = a};
        struct thud_model *model = row(1, &mass, &speed, true, size, 0.5);
        struct thud_run *run = finish(model, &record, 0);
        const struct thud_impact *impact = thud_run_impacts(run, &impacts[small]);
        end[small] = impact[impacts[small] - 1].start_s;
        ck_assert_double_eq_tol(end[small], sqrt(0.2) * 3, 1e-9);
        thud_run_free(run);
        thud_model_free(model);
    }
    ck_assert_int_gt(impacts[0], 20);
    ck_assert_int_eq(impacts[0], impacts[1]);
    ck_assert_double_eq(end[0], end[1]);
}
END_TEST

/* Three equal bodies that touch, the first one moving: with all contacts at once and e = 1 the impulses are 4/3 and 2/3
 * of m v. */
START_TEST(blow_passed_on_at_once)
{
    double mass[] = {1000, 1000, 1000}, speed[] = {3, 0, 0};
    struct thud_model *model = row(3, mass, speed, false, 0, 1);
    struct thud_run *run = finish(model, NULL, 1);
    const struct thud_history *h = thud_run_history(run);
    const double *last = h->value + (h->rows - 1) * (size_t)h->columns;
    static const double want[] = {-1, 2, 2};
    for (int i = 0; i < 3; i++)
        ck_assert_double_eq_tol(last[thud_history_velocity(h, i)], want[i], 1e-12);
    ck_assert_double_lt(thud_run_result(run)->energy.error_ratio, 1e-13);
    thud_run_free(run);
    thud_model_free(model);
}
END_TEST

/* One body caught between two equal ones: by symmetry it stays, and each outer one leaves with e times its speed. */
START_TEST(caught_between_two)
{
    double mass[] = {5000, 1000, 5000}, speed[] = {2, 0, -2};
    struct thud_model *model = row(3, mass, speed, false, 0.25, 0.3);
    struct thud_run *run = finish(model, NULL, 1);
    const struct thud_history *h = thud_run_history(run);
    const double *last = h->value + (h->rows - 1) * (size_t)h->columns;
    ck_assert_double_eq_tol(last[thud_history_velocity(h, 0)], -0.6, 1e-12);
    ck_assert_double_eq_tol(last[thud_history_velocity(h, 1)], 0, 1e-12);
    ck_assert_double_eq_tol(last[thud_history_velocity(h, 2)], 0.6, 1e-12);
    ck_assert_int_eq(thud_run_result(run)->contact[0].impacts, 1);
    ck_assert_int_eq(thud_run_result(run)->contact[1].impacts, 1);
    thud_run_free(run);
    thud_model_free(model);
}
END_TEST

/* A light body between two heavy ones that close on it, all of them touching: thousands of bounces in no time, each of
 * which is computed here by itself. Those that lose energy end in one speed; the others part. */
START_TEST(light_body_between_two)
{
    static const struct {
        double mass[3], speed[3], e;
    } of[] = {{{6e6, 1e3, 3e5}, {0.3, 1, 0.1}, 1},    {{6e6, 1e3, 3e5}, {0.3, -1, -0.1}, 0.6},
              {{3e5, 1e3, 6e6}, {0.3, 0, 0.1}, 0.6},  {{1e9, 1e3, 1e9}, {0.3, 1, 0.1}, 1},
              {{1e9, 1e3, 1e9}, {0.3, -1, -0.1}, 1},  {{1e7, 1e3, 1e7}, {0.3, -1, -0.1}, 0.9},
              {{1e9, 1e5, 1e8}, {0.3, -1, -0.1}, 0.9}};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        double speed[3] = {of[k].speed[0], of[k].speed[1], of[k].speed[2]};
        const double *mass = of[k].mass;
        for (long n = 0; n < 1000000 && fmax(speed[0] - speed[1], speed[1] - speed[2]) > 1e-15; n++) {
            const int i = speed[0] - speed[1] > speed[1] - speed[2] ? 0 : 1;
            const double p = (1 + of[k].e) * (speed[i] - speed[i + 1]) / (1 / mass[i] + 1 / mass[i + 1]);
            speed[i] -= p / mass[i];
            speed[i + 1] += p / mass[i + 1];
        }
        struct thud_model *model = row(3, mass, of[k].speed, false, 0, of[k].e);
        struct thud_run *run = finish(model, NULL, 1);
        const struct thud_history *h = thud_run_history(run);
        const double *last = h->value + (h->rows - 1) * (size_t)h->columns;
        for (int i = 0; i < 3; i++)
            ck_assert_double_eq_tol(last[thud_history_velocity(h, i)], speed[i], 1e-9);
        thud_run_free(run);
        thud_model_free(model);
    }
}
END_TEST

/* Momentum is kept, and what the contacts say they lost is what the bodies have lost, whatever masses and restitution.
 */
START_TEST(momentum_and_energy_in_a_row)
{
    static const double restitutions[] = {0.01, 0.4, 0.9, 1};
    for (size_t k = 0; k < 4; k++) {
        double mass[] = {1e3, 2e6, 5e2, 7e4, 1e3}, speed[] = {4, 0.5, 0, -1, -2}, momentum = 0, energy = 0;
        struct thud_model *model = row(5, mass, speed, false, 0.1, restitutions[k]);
        struct thud_run *run = finish(model, NULL, 3);
        const struct thud_result *r = thud_run_result(run);
        const struct thud_history *h = thud_run_history(run);
        const double *last = h->value + (h->rows - 1) * (size_t)h->columns;
        for (int i = 0; i < 5; i++) {
            momentum += mass[i] * (last[thud_history_velocity(h, i)] - speed[i]);
            energy += 0.5 * mass[i] * (speed[i] * speed[i] - pow(last[thud_history_velocity(h, i)], 2));
        }
        ck_assert_double_eq_tol(momentum / 1e6, 0, 1e-12);
        ck_assert_double_eq_tol(r->energy.contact_j, energy, 1e-9 * r->energy.initial_j);
        ck_assert_double_lt(r->energy.error_ratio, 1e-12);
        if (restitutions[k] == 1)
            ck_assert_double_eq_tol(energy, 0, 1e-9 * r->energy.initial_j);
        else
            ck_assert_double_gt(energy, 0);
        thud_run_free(run);
        thud_model_free(model);
    }
}
END_TEST

/* By Runge-Kutta: a body of 1000 kg thrown at 1 m/s against a wall of k, c that does not pull and springs back, struck
 * from behind by one of 500 kg at 2 m/s that starts `gap` away, with e = 0.5. The wall's impulse; *speed: the last. */
static double struck_by_hand(double k, double c, double gap, double *speed)
{
    const double h = 1e-6;
    double x = 0, v = 1, impulse = 0;
    bool struck = false, in_contact = true;
    for (int i = 0; i < 300000 && in_contact; i++) {
        double dx[5] = {0}, dv[5] = {0}, force[4];
        for (int stage = 0; stage < 4; stage++) {
            double part = stage == 0 ? 0 : stage == 3 ? h : h / 2;
            double xs = x + part * dx[stage], vs = v + part * dv[stage];
            force[stage] = fmax(0, k * xs + c * vs);
            dx[stage + 1] = vs;
            dv[stage + 1] = -force[stage] / 1000;
        }
        x += h / 6 * (dx[1] + 2 * dx[2] + 2 * dx[3] + dx[4]);
        v += h / 6 * (dv[1] + 2 * dv[2] + 2 * dv[3] + dv[4]);
        impulse += h / 6 * (force[0] + 2 * force[1] + 2 * force[2] + force[3]);
        if (!struck && 2 * (i + 1) * h - x >= gap) {
            struck = true;
            v += 1.5 * (500 / 1500.0) * (2 - v);
        }
        in_contact = x > 0;
    }
    *speed = v;
    return impulse;
}

/* A contact whose force is cut at 0, as it parts, and one that pushes are struck by a blow at the body's other side:
 * each goes on with the force that the new speed makes, at once. */
START_TEST(blow_on_a_contact_with_a_force)
{
    static const double gap[] = {0.175, 0.09}; /* struck as it parts; as it pushes */
    double mass[] = {500, 1000}, last;
    struct thud_structure_input body[] = {
        {.n = 1, .mass_kg = &mass[0], .velocity_mps = 2}, {.n = 1, .mass_kg = &mass[1], .velocity_mps = 1}, {.n = 0}};
    struct thud_contact_input contact[] = {
        {.interface = 1, .left_floor = 1, .right_floor = 1, .right_structure = 1, .clearance_m = gap[_i]},
        {.interface = 2, .left_floor = 1, .left_structure = 1, .right_structure = 2}};
    struct thud_model_input input = {.nstructures = 3, .structure = body, .ncontacts = 2, .contact = contact};
    struct thud_model *model = NULL;
    contact[0].law = newton(0.5, &contact[0].setup);
    contact[1].law = no_tension(1e6, 0.05, &contact[1].setup);
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    double xi = -log(0.05) / hypot(THUD_PI, log(0.05)), c = 2 * xi * sqrt(1e6 * 1000);
    double impulse = struck_by_hand(1e6, c, gap[_i], &last);
    struct thud_run *run = finish(model, NULL, 0.3);
    const struct thud_result *result = thud_run_result(run);
    ck_assert_double_eq_tol(result->contact[1].impulse_ns / impulse, 1, 1e-4);
    ck_assert_double_eq_tol(result->contact[1].separation_mps / -last, 1, 1e-3);
    ck_assert_int_eq(result->contact[1].impacts, 1);
    ck_assert_int_lt(result->work.events, 10);
    thud_run_free(run);
    thud_model_free(model);
}
END_TEST

/* A heavy body runs into a wall with a light one at its back, which rounding has made slower by the last bits: the
 * contact between them pulls by rounding when they touch, and is not let go for that. The light one is slowed down as
 * the heavy one is. */
START_TEST(a_pull_of_rounding_lets_nothing_go)
{
    double mass[] = {255, 5.8e6};
    struct thud_structure_input body[] = {
        {.n = 1, .mass_kg = &mass[0], .velocity_mps = 4}, {.n = 1, .mass_kg = &mass[1], .velocity_mps = 4}, {.n = 0}};
    struct thud_contact_input contact[] = {
        {.interface = 1, .left_floor = 1, .right_floor = 1, .right_structure = 1},
        {.interface = 2, .left_floor = 1, .left_structure = 1, .right_structure = 2}};
    struct thud_model_input input = {.nstructures = 3, .structure = body, .ncontacts = 2, .contact = contact};
    struct thud_model *model = NULL;
    struct thud_run_options options;
    contact[0].law = no_tension(3e10, 0.55, &contact[0].setup);
    contact[1].law = no_tension(3e10, 1, &contact[1].setup);
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    thud_run_options_init(&options);
    options.tail_s = 0.02;
    for (int bits = 0; bits <= 3; bits++) {
        struct thud_run *run;
        bool done = false;
        ck_assert_int_eq(thud_run_create(model, NULL, &options, &run, NULL), THUD_OK);
        for (int i = 0; i < bits; i++)
            run->state.qd[0] = nextafter(run->state.qd[0], 0);
        ck_assert_int_eq(thud_run_advance(run, 10000, &done, NULL), THUD_OK);
        const struct thud_result *r = thud_run_result(run);
        ck_assert(done);
        ck_assert_int_eq(r->contact[0].impacts, 1);
        ck_assert_int_le(r->work.events, 4);
        ck_assert_double_eq_tol(r->contact[0].force.value / (mass[0] / mass[1] * r->contact[1].force.value), 1, 0.05);
        thud_run_free(run);
    }
    thud_model_free(model);
}
END_TEST

/* A body that flies away takes no part in the blow behind it: of three equal bodies that touch, with 1, 0 and 0.1 m/s and
 * no loss, the second one takes the first one's speed, and then gives it to the third one. Asked to take part, it made
 * energy. */
START_TEST(what_flies_away_takes_no_part)
{
    double mass[] = {1000, 1000, 1000}, speed[] = {1, 0, 0.1};
    static const double want[] = {0, 0.1, 1};
    struct thud_model *model = row(3, mass, speed, false, 0, 1);
    struct thud_run *run = finish(model, NULL, 1);
    const struct thud_history *h = thud_run_history(run);
    const double *last = h->value + (h->rows - 1) * (size_t)h->columns;
    for (int i = 0; i < 3; i++)
        ck_assert_double_eq_tol(last[thud_history_velocity(h, i)], want[i], 1e-12);
    ck_assert_double_lt(thud_run_result(run)->energy.error_ratio, 1e-13);
    thud_run_free(run);
    thud_model_free(model);
}
END_TEST

/* A light body between two heavy ones that come together, as blows without end at one moment leave it when they are passed
 * over: indented by rounding on the side that it leaves, with no loss there, and about to strike on the other. All three
 * go on together and lose what that takes; with the restitutions the blow gave energy from nothing. */
START_TEST(blows_without_end_are_plastic)
{
    static const double e[] = {1, 0.6}, mass[] = {6e6, 1150, 3.4e5}, speed[] = {0, 0.184, -0.042};
    struct thud_structure_input body[3];
    struct thud_contact_input contact[2];
    double all = 0, together = 0, lost = 0;
    for (int i = 0; i < 3; i++) {
        body[i] = (struct thud_structure_input){.n = 1, .mass_kg = &mass[i], .velocity_mps = speed[i]};
        all += mass[i];
        together += mass[i] * speed[i];
    }
    together /= all;
    for (int c = 0; c < 2; c++) {
        contact[c] = (struct thud_contact_input){
            .interface = c + 1, .left_floor = 1, .right_floor = 1, .left_structure = c, .right_structure = c + 1};
        contact[c].law = newton(e[c], &contact[c].setup);
    }
    contact[0].clearance_m = -2e-14;
    struct thud_model_input input = {.nstructures = 3, .structure = body, .ncontacts = 2, .contact = contact};
    struct thud_model *model = NULL;
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    struct thud_run *run = finish(model, NULL, 0.1);
    const struct thud_history *h = thud_run_history(run);
    const double *last = h->value + (h->rows - 1) * (size_t)h->columns;
    for (int i = 0; i < 3; i++) {
        ck_assert_double_eq_tol(last[thud_history_velocity(h, i)], together, 1e-12);
        lost += 0.5 * mass[i] * (speed[i] * speed[i] - together * together);
    }
    ck_assert_double_eq_tol(thud_run_result(run)->energy.contact_j / lost, 1, 1e-12);
    ck_assert_double_lt(thud_run_result(run)->energy.error_ratio, 1e-12);
    thud_run_free(run);
    thud_model_free(model);
}
END_TEST

/* A body without room between two walls bounces to and fro in no time: walls take the impulses m v (1 + e) (1 + e^2 +
 * ...) and e times as much, and all energy is lost. */
START_TEST(no_room_between_two_walls)
{
    const double mass = 1e5, v = 0.5, e = 0.5;
    struct thud_structure_input body[] = {{.n = 0}, {.n = 1, .mass_kg = &mass, .velocity_mps = v}, {.n = 0}};
    struct thud_contact_input contact[] = {
        {.interface = 1, .right_floor = 1, .right_structure = 1},
        {.interface = 2, .left_floor = 1, .left_structure = 1, .right_structure = 2}};
    struct thud_model_input input = {.nstructures = 3, .structure = body, .ncontacts = 2, .contact = contact};
    struct thud_model *model = NULL;
    for (int c = 0; c < 2; c++)
        contact[c].law = newton(e, &contact[c].setup);
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    struct thud_run *run = finish(model, NULL, 1);
    const struct thud_result *r = thud_run_result(run);
    ck_assert_double_eq_tol(r->contact[1].impulse_ns, mass * v / (1 - e), 1e-5 * mass * v);
    ck_assert_double_eq_tol(r->contact[0].impulse_ns, e * mass * v / (1 - e), 1e-5 * mass * v);
    ck_assert_double_eq_tol(r->energy.contact_j, 0.5 * mass * v * v, 1e-9 * mass);
    thud_run_free(run);
    thud_model_free(model);
}
END_TEST

/* Two buildings of two storeys between walls that touch them on both sides, and each other, under a motion that pushes
 * now one way and now the other: nothing moves, and the floors have the ground's acceleration. */
START_TEST(squeezed_between_two_walls)
{
    static const char *const methods[] = {"exact", "dormand-prince", "rk4", "newmark"};
    double mass[] = {1e5, 8e4}, stiffness[] = {5e7, 4e7}, a[40];
    for (int i = 0; i < 40; i++)
        a[i] = i / 8 % 2 ? -0.6 : 1;
    struct thud_record record = {.dt_s = 0.1, .samples = 40, .a_mps2 = a};
    struct thud_structure_input side = {.n = 0},
                                building = {.n = 2, .mass_kg = mass, .stiffness_npm = stiffness, .damping = 0.05},
                                body[] = {side, building, building, side};
    struct thud_contact_input contact[6];
    for (int i = 0; i < 6; i++) {
        contact[i] = (struct thud_contact_input){.interface = i / 2 + 1,
                                                 .left_structure = i / 2,
                                                 .right_structure = i / 2 + 1,
                                                 .left_floor = i / 2 > 0 ? i % 2 + 1 : 0,
                                                 .right_floor = i / 2 < 2 ? i % 2 + 1 : 0};
        contact[i].law = newton(0.5, &contact[i].setup);
    }
    struct thud_model_input input = {.nstructures = 4, .structure = body, .ncontacts = 6, .contact = contact};
    struct thud_model *model = NULL;
    struct thud_run_options options;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_model_create(&input, &model, &err), THUD_OK);
    thud_run_options_init(&options);
    options.method = thud_method_find(methods[_i]);
    options.tail_s = 0.5;
    struct thud_run *run;
    bool done = false;
    ck_assert_int_eq(thud_run_create(model, &record, &options, &run, &err), THUD_OK);
    ck_assert_msg(thud_run_advance(run, 1000000, &done, &err) == THUD_OK, "%s", err.what);
    ck_assert(done);
    for (int s = 1; s <= 2; s++)
        for (int i = 0; i < 2; i++)
            ck_assert_double_lt(thud_run_result(run)->structure[s].floor[i].displacement.value, 1e-10);
    thud_run_free(run);
    thud_model_free(model);
}
END_TEST

/* Two bodies that stand together, but for the rounding of a long way, and a third one that strikes them with a
 * restitution near 0: they part as if they touched, and not as by two blows, which ended 1.2 % apart. */
START_TEST(what_rounding_has_parted_touches)
{
    static const double gap[] = {0, 1e-14, 6e-13};
    double mass[] = {2000, 1000, 1000}, want[3];
    for (int k = 0; k < 3; k++) {
        struct thud_structure_input body[] = {{.n = 1, .mass_kg = &mass[0], .velocity_mps = 2},
                                              {.n = 1, .mass_kg = &mass[1]},
                                              {.n = 1, .mass_kg = &mass[2]}};
        struct thud_contact_input contact[] = {
            {.interface = 1, .left_floor = 1, .right_floor = 1, .right_structure = 1, .clearance_m = 0.3},
            {.interface = 2, .left_floor = 1, .right_floor = 1, .left_structure = 1, .right_structure = 2}};
        struct thud_model_input input = {.nstructures = 3, .structure = body, .ncontacts = 2, .contact = contact};
        struct thud_model *model = NULL;
        contact[1].clearance_m = gap[k];
        for (int c = 0; c < 2; c++)
            contact[c].law = newton(0.05, &contact[c].setup);
        ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
        struct thud_run *run = finish(model, NULL, 1);
        const struct thud_history *h = thud_run_history(run);
        const double *last = h->value + (h->rows - 1) * (size_t)h->columns;
        for (int i = 0; i < 3; i++) {
            want[i] = k == 0 ? last[thud_history_velocity(h, i)] : want[i];
            ck_assert_double_eq_tol(last[thud_history_velocity(h, i)], want[i], 1e-9);
        }
        thud_run_free(run);
        thud_model_free(model);
    }
}
END_TEST

/* A building held to a wall by a ground that goes on accelerating: its floors have the acceleration of the ground at
 * every moment, so no peak is above that. Steps made short by the motion's corners made forces of rounding. */
START_TEST(what_is_held_moves_with_the_ground)
{
    enum { N = 98 };
    double mass[] = {5e4, 5e4}, stiffness[] = {2e7, 2e7}, a[N], most = 0;
    for (int i = 0; i < N; i++) {
        a[i] = -(0.4 + 0.3 * sin(0.7 * i));
        most = fmax(most, fabs(a[i]));
    }
    struct thud_record record = {.dt_s = 0.0137, .samples = N, .a_mps2 = a};
    struct thud_structure_input body[] = {{.n = 2, .mass_kg = mass, .stiffness_npm = stiffness, .damping = 0.05},
                                          {.n = 0}};
    struct thud_contact_input contact[2];
    for (int i = 0; i < 2; i++) {
        contact[i] = (struct thud_contact_input){.interface = 1, .left_floor = i + 1, .right_structure = 1};
        contact[i].law = newton(0, &contact[i].setup);
    }
    struct thud_model_input input = {.nstructures = 2, .structure = body, .ncontacts = 2, .contact = contact};
    struct thud_model *model = NULL;
    struct thud_run_options options;
    struct thud_run *run;
    bool done = false;
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    thud_run_options_init(&options);
    options.tail_s = 0;
    options.tolerance = 1e-10;
    ck_assert_int_eq(thud_run_create(model, &record, &options, &run, NULL), THUD_OK);
    ck_assert_int_eq(thud_run_advance(run, 100000, &done, NULL), THUD_OK);
    for (int i = 0; i < 2; i++)
        ck_assert_double_eq_tol(thud_run_result(run)->structure[0].floor[i].acceleration.value, most, 1e-9);
    ck_assert_int_le(thud_run_result(run)->work.steps, 3 * N);
    thud_run_free(run);
    thud_model_free(model);
}
END_TEST

/* Neighbours that touch, one of which is the other times a number: whatever the ground does they move alike, so no floor
 * takes leave of the other and no force is more than rounding. What rounding leaves of their equal forces has to be told
 * from a pull, or each sign of it lets a contact go. */
START_TEST(neighbours_that_move_alike_stay_together)
{
    enum { FLOORS = 3, N = 200 };
    static const double ratio[] = {3.3, 0.9 / 1.7, 0.3, 7.0};
    double mass[2][FLOORS], stiffness[2][FLOORS], a[N];
    for (int i = 0; i < N; i++)
        a[i] = 3 * sin(0.31 * i) + 2 * cos(0.113 * i);
    for (int i = 0; i < FLOORS; i++) {
        mass[0][i] = 3e5 + 1e4 * i;
        stiffness[0][i] = 6e8;
        mass[1][i] = ratio[_i] * mass[0][i];
        stiffness[1][i] = ratio[_i] * stiffness[0][i];
    }
    struct thud_record record = {.dt_s = 0.02, .samples = N, .a_mps2 = a};
    struct thud_structure_input body[2];
    for (int k = 0; k < 2; k++)
        body[k] = (struct thud_structure_input){
            .n = FLOORS, .mass_kg = mass[k], .stiffness_npm = stiffness[k], .damping = 0.05};
    struct thud_contact_input contact[FLOORS];
    for (int i = 0; i < FLOORS; i++) {
        contact[i] = (struct thud_contact_input){
            .interface = 1, .left_floor = i + 1, .right_floor = i + 1, .right_structure = 1};
        contact[i].law = newton(0.6, &contact[i].setup);
    }
    struct thud_model_input input = {.nstructures = 2, .structure = body, .ncontacts = FLOORS, .contact = contact};
    struct thud_model *model = NULL;
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    struct thud_run *run = finish(model, &record, 0);
    const struct thud_result *result = thud_run_result(run);
    ck_assert_int_le(result->work.events, FLOORS); /* each may touch once */
    for (int i = 0; i < FLOORS; i++)
        ck_assert_double_le(result->contact[i].force.value, 1e-11 * mass[0][i] * a[0]);
    thud_run_free(run);
    thud_model_free(model);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("impulse");
    TCase *tc = tcase_create("impulse");
    tcase_add_test(tc, bounces_down_to_rest);
    tcase_add_test(tc, rest_has_no_size_of_its_own);
    tcase_add_test(tc, blow_passed_on_at_once);
    tcase_add_test(tc, caught_between_two);
    tcase_add_test(tc, light_body_between_two);
    tcase_add_test(tc, momentum_and_energy_in_a_row);
    tcase_add_loop_test(tc, blow_on_a_contact_with_a_force, 0, 2);
    tcase_add_test(tc, a_pull_of_rounding_lets_nothing_go);
    tcase_add_test(tc, what_flies_away_takes_no_part);
    tcase_add_test(tc, blows_without_end_are_plastic);
    tcase_add_test(tc, no_room_between_two_walls);
    tcase_add_loop_test(tc, squeezed_between_two_walls, 0, 4);
    tcase_add_test(tc, what_rounding_has_parted_touches);
    tcase_add_test(tc, what_is_held_moves_with_the_ground);
    tcase_add_loop_test(tc, neighbours_that_move_alike_stay_together, 0, 4);
    suite_add_tcase(suite, tc);
    return suite;
}
