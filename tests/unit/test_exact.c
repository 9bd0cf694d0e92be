/* The exact method against itself at another tolerance, symmetries, closed forms and an independent solver. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/run/run_private.h"
#include "march.h"
#include "suite.h"

static const int towers[] = {4, 6}, mirrored[] = {6, 4}, twins[] = {5, 5};

static struct march_law rubber(void)
{
    return march_law("rubber", "stiffness", 0.36e3 * pow(1000, 2.65), "exponent", 2.65, "restitution", 0.5,
                     "max-strain", 0.8, "post-yield", 2.5e9, "thickness", 0.05, NULL);
}
static struct march_law concrete(void)
{
    return march_law("kelvin-voigt-no-tension", "stiffness", 2.5e9, "restitution", 0.6, NULL);
}

static struct march exact(const struct thud_model *model, const struct thud_record *record, double tolerance,
                          double tail)
{
    struct march m = march_run(model, record, "exact", 0, tolerance, true, tail);
    ck_assert_msg(m.status == THUD_OK, "%s", m.err.what);
    return m;
}

/* What the result may ask of itself, for gaps from 0 on. */
START_TEST(tolerance_keeps_its_promise)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law laws[] = {rubber(), concrete(), march_law("hertz", "stiffness", 2.5e10, NULL),
                               march_law("jankowski", "stiffness", 2.5e10, "restitution", 0.6, NULL),
                               march_law("hertz-damp", "stiffness", 2.5e10, "restitution", 0.6, NULL)};
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++)
        for (double gap = 0; gap < 0.05; gap += 0.02) {
            struct thud_model *model = march_row(2, towers, false, gap, &laws[i]);
            struct march a = exact(model, record, 1e-6, 2), b = exact(model, record, 5e-7, 2);
            struct march fine = exact(model, record, 1e-8, 2);
            double halved = march_peaks_apart(a.result, b.result, 0.01);
            double converged = march_peaks_apart(a.result, fine.result, 0.01);
            ck_assert_int_gt(a.result->contact[3].impacts, 0);
            ck_assert_msg(halved < 1e-5 && converged < 1e-5, "%s, gap %g: %.1e, %.1e", laws[i].law->name, gap, halved,
                          converged);
            ck_assert_msg(fine.result->energy.error_ratio < 1e-7, "%s, gap %g: energy %.1e", laws[i].law->name, gap,
                          fine.result->energy.error_ratio);
            march_free(&a);
            march_free(&b);
            march_free(&fine);
            thud_model_free(model);
        }
    thud_record_free(record);
}
END_TEST

/* Each number of nodes that a tolerance asks for, against a method that knows none of them. */
START_TEST(loose_tolerances_keep_theirs)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law laws[] = {rubber(), march_law("hertz", "stiffness", 2.5e10, NULL),
                               march_law("jankowski", "stiffness", 2.5e10, "restitution", 0.6, NULL),
                               march_law("hertz-damp", "stiffness", 2.5e10, "restitution", 0.6, NULL)};
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++)
        for (double gap = 0; gap < 0.05; gap += 0.012) {
            struct thud_model *model = march_row(2, towers, false, gap, &laws[i]);
            struct march other = march_run(model, record, "dormand-prince", 0, 1e-9, true, 2);
            ck_assert_msg(other.status == THUD_OK, "%s", other.err.what);
            for (double tolerance = 1e-2; tolerance > 1e-5; tolerance /= 10) {
                struct march m = exact(model, record, tolerance, 2);
                double apart = march_peaks_apart(m.result, other.result, 0.01);
                ck_assert_msg(apart < tolerance, "%s, gap %g, tolerance %g: %.1e", laws[i].law->name, gap, tolerance,
                              apart);
                ck_assert_double_lt(m.result->energy.error_ratio, tolerance);
                march_free(&m);
            }
            march_free(&other);
            thud_model_free(model);
        }
    thud_record_free(record);
}
END_TEST

/* Forces that end with a kink, and forces that rise with the sixth power: the energy adds up to the tolerance wherever in
 * a step the contacts open, and whatever the force that an impact is expected to reach. */
START_TEST(energy_adds_up_to_the_tolerance)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law laws[] = {march_law("hertz-damp", "stiffness", 1.7e9, "exponent", 1.0, "restitution", 0.3, NULL),
                               march_law("rubber", "stiffness", 0.36e3 * pow(1000, 6), "exponent", 6.0, "restitution",
                                         0.5, "max-strain", 0.8, "post-yield", 2.5e9, "thickness", 0.04, NULL)};
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++)
        for (double gap = 0; gap < 0.06; gap += 0.0015) {
            struct thud_model *model = march_row(2, towers, false, gap, &laws[i]);
            struct march m = exact(model, record, 1e-8, 2);
            ck_assert_msg(m.result->energy.error_ratio < 1e-8, "%s, gap %g: energy %.1e", laws[i].law->name, gap,
                          m.result->energy.error_ratio);
            march_free(&m);
            thud_model_free(model);
        }
    thud_record_free(record);
}
END_TEST

START_TEST(mirror_image)
{
    struct thud_record *record = march_motion(1.5), *back = march_motion(-1.5);
    struct march_law laws[] = {rubber(), concrete()};
    for (int i = 0; i < 2; i++) {
        struct thud_model *model = march_row(2, towers, false, 0.02, &laws[i]);
        struct thud_model *other = march_row(2, mirrored, false, 0.02, &laws[i]);
        struct march a = exact(model, record, 1e-8, 2), b = exact(other, back, 1e-8, 2);
        for (int s = 0; s < 2; s++)
            for (int f = 0; f < towers[s]; f++) {
                const struct thud_floor_result *x = &a.result->structure[s].floor[f];
                const struct thud_floor_result *y = &b.result->structure[1 - s].floor[f];
                ck_assert_double_eq_tol(x->acceleration.value / y->acceleration.value, 1, 1e-7);
                ck_assert_double_eq_tol(x->drift.value / y->drift.value, 1, 1e-7);
            }
        for (int c = 0; c < 4; c++) {
            ck_assert_int_eq(a.result->contact[c].impacts, b.result->contact[c].impacts);
            ck_assert_double_eq_tol(a.result->contact[c].force.value / b.result->contact[c].force.value, 1, 1e-7);
        }
        march_free(&a);
        march_free(&b);
        thud_model_free(model);
        thud_model_free(other);
    }
    thud_record_free(record);
    thud_record_free(back);
}
END_TEST

/* The response to lambda a_g at gap g is lambda times that to a_g at gap g / lambda, for laws of degree one. */
START_TEST(scaling_of_laws_of_degree_one)
{
    const double lambda = 3;
    struct thud_record *record = march_motion(0.5), *strong = march_motion(0.5 * lambda);
    struct march_law laws[] = {concrete(), march_law("linear", "stiffness", 2.5e9, NULL),
                               march_law("kelvin-voigt", "stiffness", 2.5e9, "restitution", 0.6, NULL),
                               march_law("stereomechanical", "restitution", 0.6, NULL)};
    for (int i = 0; i < 4; i++) {
        ck_assert_int_ne(laws[i].law->flags & THUD_LAW_DEGREE_ONE, 0);
        struct thud_model *wide = march_row(2, towers, false, 0.03, &laws[i]);
        struct thud_model *narrow = march_row(2, towers, false, 0.03 / lambda, &laws[i]);
        struct march a = exact(wide, strong, 1e-8, 2), b = exact(narrow, record, 1e-8, 2);
        ck_assert_int_gt(a.result->contact[3].impacts, 0);
        for (int s = 0; s < 2; s++)
            for (int f = 0; f < towers[s]; f++) {
                const struct thud_floor_result *x = &a.result->structure[s].floor[f];
                const struct thud_floor_result *y = &b.result->structure[s].floor[f];
                ck_assert_double_eq_tol(x->displacement.value / y->displacement.value, lambda, 1e-8);
                ck_assert_double_eq_tol(x->acceleration.value / y->acceleration.value, lambda, 1e-8);
            }
        for (int c = 0; c < 4; c++) {
            if (!(laws[i].law->flags &
                  THUD_LAW_IMPULSIVE)) /* whose row of bounces ends at a speed that does not scale */
                ck_assert_int_eq(a.result->contact[c].impacts, b.result->contact[c].impacts);
            ck_assert_double_eq_tol(a.result->contact[c].residual_m, lambda * b.result->contact[c].residual_m, 1e-10);
        }
        march_free(&a);
        march_free(&b);
        thud_model_free(wide);
        thud_model_free(narrow);
    }
    thud_record_free(record);
    thud_record_free(strong);
}
END_TEST

/* Whichever contact of several is the one that closes, contact-free response ends there. */
START_TEST(each_contact_alone_ends_contact_free)
{
    struct thud_record *record = march_motion(1);
    struct march_law law = concrete();
    struct thud_model *model = march_row(2, towers, false, 10, &law);
    for (int c = 0; c < model->ncontacts; c++) {
        model->contact[c].clearance_m = 0.002 * (c + 1);
        struct march a = exact(model, record, 1e-6, 2),
                     b = march_run(model, record, "dormand-prince", 0, 1e-9, true, 2);
        ck_assert_int_gt(b.result->contact[c].impacts, 0);
        ck_assert_int_eq(a.result->contact[c].impacts, b.result->contact[c].impacts);
        ck_assert_double_le(march_peaks_apart(a.result, b.result, 1e-3), 1e-6);
        march_free(&a);
        march_free(&b);
        model->contact[c].clearance_m = 10;
    }
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

START_TEST(identical_neighbours_never_touch)
{
    struct thud_record *record = march_motion(1);
    struct march_law laws[] = {rubber(), concrete()};
    for (int i = 0; i < 2; i++)
        for (int isolated = 0; isolated < 2; isolated++) {
            struct thud_model *model = march_row(2, twins, isolated, 0, &laws[i]);
            for (int k = 0; k < thud_method_count(); k++) {
                struct march m = march_run(model, record, thud_method_at(k)->name, 0, 0, true, 1);
                ck_assert_int_eq(m.status, THUD_OK);
                for (int c = 0; c < model->ncontacts; c++)
                    ck_assert_msg(m.result->contact[c].impacts == 0, "%s", thud_method_at(k)->name);
                march_free(&m);
            }
            thud_model_free(model);
        }
    thud_record_free(record);
}
END_TEST

START_TEST(a_gap_too_wide_to_close_changes_no_bit)
{
    struct thud_record *record = march_motion(1);
    struct march_law none = march_law("none", NULL), law = rubber();
    struct thud_model *free = march_row(2, towers, false, 2, &none), *wide = march_row(2, towers, false, 2, &law);
    struct march a = exact(free, record, 1e-6, 2), b = exact(wide, record, 1e-6, 2);
    for (int s = 0; s < 2; s++)
        ck_assert_mem_eq(a.result->structure[s].floor, b.result->structure[s].floor,
                         (size_t)towers[s] * sizeof *a.result->structure[s].floor);
    ck_assert_mem_eq(a.run->state.q, b.run->state.q, (size_t)free->nmodes * sizeof(double));
    march_free(&a);
    march_free(&b);
    thud_model_free(free);
    thud_model_free(wide);
    thud_record_free(record);
}
END_TEST

/* An undamped swing of 5 cm against a wall 1e-9 m nearer or farther than that: depth from the energy. */
START_TEST(grazing)
{
    const double omega = 10, amplitude = 0.05, by = 1e-9;
    struct march_law law = march_law("linear", "stiffness", 1e4, NULL);
    for (int near = 0; near < 2; near++) {
        double gap = amplitude + (near ? -by : by);
        struct thud_model *model = march_mass_and_wall(1, omega, 0, amplitude * omega, gap, &law);
        struct march m = exact(model, NULL, 1e-6, 0.5);
        ck_assert_int_eq(m.result->contact[0].impacts, near);
        if (near) /* (omega amplitude)^2 = omega^2 (gap + d)^2 + 1e4 d^2 */
            ck_assert_double_eq_tol(m.result->contact[0].indentation.value,
                                    by * (1 - 1e4 * by / (2 * omega * omega * amplitude)), 1e-15);
        march_free(&m);
        thud_model_free(model);
    }
}
END_TEST

/* The same again and again, so shortly that all of a contact lies before the first point at which a step looks for its
 * force. A mass on a spring loses nothing at a Hertz contact: it comes back each time, and the depth follows from its
 * energy. */
START_TEST(grazing_shorter_than_a_step)
{
    static const double w = 25, v = 10, m = 160e3, k = 2.5e10, n = 1.5;
    const double amplitude = v / w;
    struct march_law law = march_law("hertz", "stiffness", k, NULL);
    struct thud_record *still = march_motion(0);
    for (double half_s = 5e-5; half_s < 2e-3; half_s *= 2)
        for (double tolerance = 1e-6; tolerance > 5e-11; tolerance *= 1e-4) {
            const double free_m = v * w * half_s * half_s / 2, gap = amplitude - free_m;
            struct thud_model *model = march_mass_and_wall(m, w, 0, v, gap, &law);
            struct march got = exact(model, still, tolerance, 0);
            double depth = free_m;
            for (int i = 0; i < 50; i++)
                depth = amplitude * sqrt(1 - 2 * k * pow(depth, n + 1) / (n + 1) / (m * v * v)) - gap;
            const struct thud_contact_result *c = &got.result->contact[0];
            ck_assert_int_eq(c->impacts, 32); /* 8 s over 0.251 s */
            ck_assert_double_eq_tol(c->indentation.value / depth, 1, 1e-5);
            ck_assert_double_eq_tol(c->force.value / (k * pow(depth, n)), 1, fmax(1e3 * tolerance, 1e-6));
            march_free(&got);
            thud_model_free(model);
        }
    thud_record_free(still);
}
END_TEST

/* At the end of a collocated step the contacts are as fast as at its last node. */
static void check_end_rates(const struct thud_run *run)
{
    const struct thud_segment *seg = &run->seg;
    for (int c = 0; c < run->state.model->ncontacts && seg->nodes; c++) {
        const int at = seg->nodes->at[c];
        if (at < 0 || fabs(thud_run_time(run) - seg->start_s - seg->h_s) > 1e-9 * seg->h_s)
            continue;
        const double rate = seg->nodes->motion[at * seg->nodes->points + seg->nodes->count - 1][1];
        ck_assert_double_eq_tol(thud_contact_rate(&run->state, c), rate,
                                1e-4 * run->state.tolerance * run->state.speed_mps);
    }
}

/* Steps that end with an event of this word; *all: such events, which stand in the order of time. */
static int steps_to(const char *word, const struct thud_model *model, const struct thud_record *record,
                    double tolerance, int *all)
{
    struct thud_run_options options;
    struct thud_run *run = NULL;
    bool done = false;
    int ends = 0, events = 0;
    *all = 0;
    thud_run_options_init(&options);
    options.tolerance = tolerance;
    options.keep_events = true;
    ck_assert_int_eq(thud_run_create(model, record, &options, &run, NULL), THUD_OK);
    while (!done) {
        ck_assert_int_eq(thud_run_advance(run, 1, &done, NULL), THUD_OK);
        check_end_rates(run);
        int before = events;
        const struct thud_event_entry *event = thud_run_events(run, &events);
        for (int i = before; i < events; i++) {
            ck_assert(i == 0 || event[i].time_s >= event[i - 1].time_s);
            *all += strcmp(event[i].event, word) == 0;
            ends += strcmp(event[i].event, word) == 0 && event[i].time_s == thud_run_time(run);
        }
    }
    thud_run_free(run);
    return ends;
}

/* Two masses fly against both sides of a wall and part from it inside a step, which goes on behind the separation: of
 * rubber, or of Hertz's law, which has no damping. A contact without losses lasts as long as the integral over the
 * energy says, and returns the speed. */
START_TEST(parting_inside_a_step)
{
    static const double v[] = {0.5, 0.3};
    const double n = _i ? 1.5 : 2.65, tolerance = _i ? 1e-2 : 1e-4;
    double mass[] = {160e3, 320e3}, soft = 1e-3, wait_s[] = {1e-3, 1.2e-3};
    const double k = 0.36e3 * pow(1000, n);
    struct march_law law =
        _i ? march_law("hertz", "stiffness", k, NULL)
           : march_law("rubber", "stiffness", k, "exponent", n, "restitution", 1.0, "thickness", 0.05, NULL);
    struct thud_record *still = march_motion(0);
    for (int late = 0; late < 2; late++) { /* which of the two parts first */
        struct thud_structure_input s[3] = {{0}};
        struct thud_contact_input c[2];
        for (int i = 0; i < 2; i++) {
            s[2 * i] = (struct thud_structure_input){
                .n = 1, .mass_kg = &mass[i], .stiffness_npm = &soft, .velocity_mps = i ? -v[i] : v[i]};
            c[i] = (struct thud_contact_input){.interface = i + 1,
                                               .left_floor = 1 - i,
                                               .right_floor = i,
                                               .left_structure = i,
                                               .right_structure = i + 1,
                                               .clearance_m = v[i] * (wait_s[i] + (i == late ? 4e-3 : 0)),
                                               .law = law.law,
                                               .setup = law.setup};
        }
        struct thud_model_input input = {.nstructures = 3, .structure = s, .ncontacts = 2, .contact = c};
        struct thud_model *model = NULL;
        ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
        struct march m = exact(model, still, tolerance, 0);
        for (int i = 0; i < 2; i++) {
            const double m_i = model->contact[i].setup.mass_kg, q = n + 1,
                         depth = pow(q * m_i * v[i] * v[i] / (2 * k), 1 / q),
                         lasts_s = 2 * depth / v[i] * sqrt(THUD_PI) * tgamma(1 + 1 / q) / tgamma(0.5 + 1 / q);
            ck_assert_int_eq(m.result->contact[i].impacts, 1);
            ck_assert_double_eq_tol(m.result->contact[i].contact_time_s / lasts_s, 1, tolerance);
            ck_assert_double_eq_tol(m.result->contact[i].indentation.value / depth, 1, tolerance);
            ck_assert_double_eq_tol(m.result->contact[i].separation_mps / v[i], 1, tolerance);
            ck_assert_double_eq_tol(fabs(march_velocity(&m, i)) / v[i], 1, tolerance);
        }
        ck_assert_int_eq(m.run->work.events, _i ? 4 : 6); /* rubber turns */
        int all;
        ck_assert_int_eq(steps_to("separation", model, still, tolerance, &all), 0);
        ck_assert_int_eq(all, 2);
        march_free(&m);
        thud_model_free(model);
    }
    thud_record_free(still);
}
END_TEST

/* A wall between two masses on springs of periods that have nothing to do with each other; `sides` 1, 2: only that mass can
 * strike it, 3: both can. */
static struct thud_model *wall_between(const struct march_law *law, int sides)
{
    static const double mass_kg[] = {160e3, 320e3}, omega[] = {25, 19};
    double stiffness_npm[2];
    struct thud_structure_input s[3] = {{0}};
    struct thud_contact_input c[2];
    int n = 0;
    for (int i = 0; i < 2; i++) {
        stiffness_npm[i] = mass_kg[i] * omega[i] * omega[i];
        s[2 * i] = (struct thud_structure_input){
            .n = 1, .mass_kg = &mass_kg[i], .stiffness_npm = &stiffness_npm[i], .damping = 0.02};
        if (sides & 1 << i)
            c[n++] = (struct thud_contact_input){.interface = i + 1,
                                                 .left_floor = 1 - i,
                                                 .right_floor = i,
                                                 .left_structure = i,
                                                 .right_structure = i + 1,
                                                 .law = law->law,
                                                 .setup = law->setup};
    }
    struct thud_model_input input = {.nstructures = 3, .structure = s, .ncontacts = n, .contact = c};
    struct thud_model *model = NULL;
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    return model;
}

/* Contacts that begin and are released while another one lasts, inside a step that goes on: each mass strikes the wall as
 * if the other were not there, where such a step ends with the event. */
START_TEST(beginning_inside_a_step)
{
    static const double tolerance[] = {1e-2, 1e-3, 1e-5};
    const struct march_law law =
        _i ? march_law("hertz", "stiffness", 1e9, NULL) : march_law("rubber", "stiffness", 1e9, "thickness", 0.5, NULL);
    struct thud_record *record = march_motion(1);
    for (size_t i = 0; i < sizeof tolerance / sizeof *tolerance; i++) {
        struct thud_model *both = wall_between(&law, 3);
        struct march together = exact(both, record, tolerance[i], 0);
        ck_assert_double_lt(together.result->energy.error_ratio, tolerance[i]);
        for (int side = 0; side < 2; side++) {
            struct thud_model *one = wall_between(&law, 1 << side);
            struct march alone = exact(one, record, 1e-2 * tolerance[i], 0);
            const struct thud_contact_result *a = &together.result->contact[side], *b = alone.result->contact;
            ck_assert_int_gt(b->impacts, 10);
            ck_assert_int_eq(a->impacts, b->impacts);
            ck_assert_double_eq_tol(a->force.value / b->force.value, 1, tolerance[i]);
            ck_assert_double_eq_tol(a->indentation.value / b->indentation.value, 1, tolerance[i]);
            ck_assert_double_eq_tol(a->contact_time_s / b->contact_time_s, 1, tolerance[i]);
            ck_assert_double_eq_tol(a->impulse_ns / b->impulse_ns, 1, tolerance[i]);
            march_free(&alone);
            thud_model_free(one);
        }
        int onsets, releases;
        ck_assert_int_lt(steps_to("onset", both, record, tolerance[i], &onsets), onsets * 9 / 10);
        ck_assert_int_lt(steps_to("release", both, record, tolerance[i], &releases), releases * 9 / 10);
        march_free(&together);
        thud_model_free(both);
    }
    thud_record_free(record);
}
END_TEST

/* Two bodies fly to a wall together, touching or 1e-10 of the unit of length apart, from this far off: the speeds after it,
 * and the largest force between them. Lengths, speeds and stiffnesses are in that unit. */
static void fly_to_a_wall(int law_index, double unit, double apart, double way, double out[3])
{
    static const char *const name[] = {"linear",    "kelvin-voigt", "kelvin-voigt-no-tension", "hertz", "hertz-damp",
                                       "jankowski", "rubber",       "stereomechanical"};
    static const double exponent[] = {1, 1, 1, 1.5, 1.5, 1.5, 2.65, 1},
                        stiffness[] = {2.5e9, 2.5e9, 2.5e9, 8e10, 8e10, 8e10, 3.2e10, 0}, speed = 4;
    const double k = stiffness[law_index] * pow(unit, 1 - exponent[law_index]);
    double mass[] = {3e5, 2e5}, none = 0;
    struct march_law law = k == 0 ? march_law(name[law_index], NULL)
                           : law_index == 6
                               ? march_law("rubber", "stiffness", k, "restitution", 0.5, "thickness", 0.05 * unit,
                                           "damping", 1.0, "post-yield", 2.5e9, "speed-floor", 1e-3 * unit, NULL)
                           : law_index == 4 ? march_law("hertz-damp", "stiffness", k, "speed-floor", 1e-3 * unit, NULL)
                                            : march_law(name[law_index], "stiffness", k, NULL);
    struct thud_structure_input s[3] = {{0}};
    struct thud_contact_input c[2];
    for (int i = 0; i < 2; i++) {
        s[i] = (struct thud_structure_input){
            .n = 1, .mass_kg = &mass[i], .stiffness_npm = &none, .velocity_mps = speed * unit};
        c[i] = (struct thud_contact_input){.interface = i + 1,
                                           .left_floor = 1,
                                           .right_floor = 1 - i,
                                           .left_structure = i,
                                           .right_structure = i + 1,
                                           .clearance_m = (i ? way : apart) * unit,
                                           .law = law.law,
                                           .setup = law.setup};
    }
    struct thud_model_input input = {.nstructures = 3, .structure = s, .ncontacts = 2, .contact = c};
    struct thud_model *model = NULL;
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    struct march m = exact(model, NULL, 1e-9, way / speed + 1);
    out[0] = march_velocity(&m, 0) / unit;
    out[1] = march_velocity(&m, 1) / unit;
    out[2] = m.result->contact[0].force.value / unit;
    march_free(&m);
    thud_model_free(model);
}

/* The same in other units of length, and 1 km away from where it began. */
START_TEST(no_length_is_of_its_own)
{
    static const double unit[] = {1e-3, 1e-6, 1e3, 1}, way[] = {0.5, 0.5, 0.5, 1000}, apart[] = {0, 1e-10};
    for (int k = 0; k < 2; k++) {
        double want[3], got[3];
        fly_to_a_wall(_i, 1, apart[k], 0.5, want);
        for (int i = 0; i < 4; i++) {
            fly_to_a_wall(_i, unit[i], apart[k], way[i], got);
            for (int j = 0; j < 3; j++)
                ck_assert_msg(fabs(got[j] - want[j]) <= 1e-9 * fmax(fabs(want[j]), 1),
                              "unit %g, %g apart, number %d: %.12g, not %.12g", unit[i], apart[k], j, got[j], want[j]);
        }
    }
}
END_TEST

/* An undamped swing of 5 cm between two walls, 4 and 4.5 cm away: it strikes them in turn, wherever it began, and as
 * springs lose nothing each is as deep as the energy says. Both come near in one block of free vibration, at other times. */
START_TEST(from_wall_to_wall)
{
    const double omega = 10, amplitude = 0.05, k = 100, clearance[] = {0.04, 0.045};
    double mass = 1, stiffness = omega * omega;
    struct march_law law = march_law("linear", "stiffness", k, NULL);
    for (int to = -1; to <= 1; to += 2) {
        struct thud_structure_input s[] = {
            {0}, {.n = 1, .mass_kg = &mass, .stiffness_npm = &stiffness, .velocity_mps = to * amplitude * omega}, {0}};
        struct thud_contact_input c[2];
        for (int i = 0; i < 2; i++)
            c[i] = (struct thud_contact_input){.interface = i + 1,
                                               .left_floor = i,
                                               .right_floor = 1 - i,
                                               .left_structure = i,
                                               .right_structure = i + 1,
                                               .clearance_m = clearance[i],
                                               .law = law.law,
                                               .setup = law.setup};
        struct thud_model_input input = {.nstructures = 3, .structure = s, .ncontacts = 2, .contact = c};
        struct thud_model *model = NULL;
        ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
        struct march m = exact(model, NULL, 1e-6, 2);
        for (int i = 0; i < 2; i++) { /* omega^2 (g + d)^2 + k d^2 = omega^2 amplitude^2 */
            double b = stiffness * clearance[i],
                   rest = stiffness * (amplitude * amplitude - clearance[i] * clearance[i]),
                   d = rest / (b + sqrt(b * b + (stiffness + k) * rest));
            ck_assert_double_eq_tol(m.result->contact[i].indentation.value, d, 1e-12);
            ck_assert_int_ge(m.result->contact[i].impacts, 3);
        }
        ck_assert_int_le(abs(m.result->contact[0].impacts - m.result->contact[1].impacts), 1);
        march_free(&m);
        thud_model_free(model);
    }
}
END_TEST

/* A contact of 1e13 N/m (N/m^1.5): the whole impact lasts 0.4 ms (3 ms), inside one interval of the ground motion. */
START_TEST(touch_and_release_in_one_step)
{
    double zero[100] = {0};
    struct thud_record *record = NULL;
    ck_assert_int_eq(thud_record_create(zero, 100, 0.02, &record, NULL), THUD_OK);
    for (int law_index = 0; law_index < 3; law_index++) {
        const char *name = (const char *[]){"linear", "kelvin-voigt-no-tension", "hertz"}[law_index];
        struct march_law law = march_law(name, "stiffness", 1e13, NULL);
        struct thud_model *model = march_two_bodies(320e3, 320e3, 0.5, 0.001, &law);
        struct march m = exact(model, record, 1e-9, 0);
        double e = thud_law_restitution(law.law, &model->contact[0].setup, 0.5);
        ck_assert_int_eq(m.result->contact[0].impacts, 1);
        ck_assert_double_eq_tol(march_velocity(&m, 1) - march_velocity(&m, 0), 0.5 * e, 1e-8);
        ck_assert_double_eq_tol(march_velocity(&m, 1) + march_velocity(&m, 0), 0.5, 1e-12);
        ck_assert_double_lt(m.result->contact[0].contact_time_s, 5e-3);
        ck_assert_double_lt(m.result->energy.error_ratio, 1e-8);
        march_free(&m);
        thud_model_free(model);
    }
    thud_record_free(record);
}
END_TEST

/* Bumpers pressed past their ultimate strain, unloading as printed: contacts stick on the way, the result converges. */
START_TEST(sticking_beyond_the_largest_strain)
{
    struct thud_record *record = march_motion(3.5);
    struct march_law law = rubber();
    struct thud_model *model = march_row(2, towers, false, 0, &law);
    struct thud_run_options options;
    struct thud_run *run = NULL;
    bool done = false;
    int stuck = 0;
    thud_run_options_init(&options);
    ck_assert_int_eq(thud_run_create(model, record, &options, &run, NULL), THUD_OK);
    while (!done) {
        ck_assert_int_eq(thud_run_advance(run, 1, &done, NULL), THUD_OK);
        for (int c = 0; c < 4; c++)
            if (run->state.contact[c].mode == THUD_STICKING) {
                stuck++;
                ck_assert_double_gt(thud_contact_indentation(&run->state, c),
                                    thud_law_ultimate(model->contact[c].law, &model->contact[c].setup,
                                                      &run->state.contact[c].memory, THUD_APPROACH));
                ck_assert_double_lt(fabs(thud_contact_rate(&run->state, c)), 1e-9);
            }
    }
    ck_assert_int_gt(stuck, 0);
    ck_assert_double_lt(thud_run_result(run)->energy.error_ratio, 1e-6);
    thud_run_free(run);
    struct march a = exact(model, record, 1e-6, 2), rk4 = march_run(model, record, "rk4", 2.5e-4, 0, true, 2);
    double apart = march_peaks_apart(a.result, rk4.result, 0.05);
    ck_assert_msg(apart < 2e-5, "%.1e", apart);
    march_free(&a);
    march_free(&rk4);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Neighbours that never part: concrete at a clearance of 0, and rubber under a ground motion so strong that it sticks beyond
 * its largest strain. Both end, and in the peaks of another method. */
START_TEST(neighbours_that_never_part)
{
    const struct march_law laws[] = {concrete(), rubber()};
    struct thud_record *record = march_motion(_i == 0 ? 1 : 3);
    struct thud_model *model = march_row(2, towers, false, 0, &laws[_i]);
    struct march a = exact(model, record, 1e-6, 1), b = march_run(model, record, "dormand-prince", 0, 1e-9, true, 1);
    double apart = march_peaks_apart(a.result, b.result, 0.05);
    ck_assert_msg(apart < 1e-6, "%.1e", apart);
    ck_assert_int_lt((int)a.result->work.steps, 4000);
    march_free(&a);
    march_free(&b);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Elastic collision of 1 kg with 1000 t, either way round: velocities by momentum and energy. */
START_TEST(mass_ratio_of_a_million)
{
    struct march_law law = march_law("linear", "stiffness", 1e4, NULL);
    for (int heavy_left = 0; heavy_left < 2; heavy_left++) {
        double a = heavy_left ? 1e6 : 1, b = heavy_left ? 1 : 1e6;
        struct thud_model *model = march_two_bodies(a, b, 1, 0.01, &law);
        struct march m = exact(model, NULL, 1e-6, 0.2);
        ck_assert_int_eq(m.result->contact[0].impacts, 1);
        ck_assert_double_eq_tol(march_velocity(&m, 0), (a - b) / (a + b), 1e-12);
        ck_assert_double_eq_tol(march_velocity(&m, 1), 2 * a / (a + b), 1e-12);
        march_free(&m);
        thud_model_free(model);
    }
}
END_TEST

/* Without damping nothing is lost but in the contacts; with elastic contacts nothing at all. */
START_TEST(nothing_lost_without_damping)
{
    struct march_law law = march_law("hertz", "stiffness", 1e6, NULL);
    struct thud_model *model = march_mass_and_wall(1, 10, 0, 1, 0.02, &law);
    struct march m = exact(model, NULL, 1e-9, 30);
    double u = march_displacement(&m, 0), v = march_velocity(&m, 0), d = fmax(u - 0.02, 0);
    ck_assert_int_gt(m.result->contact[0].impacts, 50);
    ck_assert_double_eq_tol(v * v + 100 * u * u + 0.8 * 1e6 * pow(d, 2.5), 1, 1e-7);
    ck_assert_double_eq_tol(m.result->energy.viscous_j, 0, 1e-300);
    march_free(&m);
    thud_model_free(model);
}
END_TEST

START_TEST(from_one_storey_to_a_hundred_and_ten_in_a_row)
{
    const int low[] = {1, 2}, high[] = {100, 80}, row[] = {1, 2, 3, 4, 5, 6, 5, 4, 3, 2};
    const struct {
        int n;
        const int *storeys;
        double gap;
    } scene[] = {{2, low, 0.002}, {2, high, 0.005}, {10, row, 0.004}};
    struct thud_record *record = march_motion(1);
    struct march_law laws[] = {rubber(), concrete()};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++) {
            struct thud_model *model = march_row(scene[i].n, scene[i].storeys, false, scene[i].gap, &laws[k]);
            struct march a = exact(model, record, 1e-6, 1), b = exact(model, record, 1e-7, 1);
            int impacts = 0;
            for (int c = 0; c < model->ncontacts; c++)
                impacts += a.result->contact[c].impacts;
            ck_assert_int_gt(impacts, 2);
            double apart = march_peaks_apart(a.result, b.result, 0.05);
            ck_assert_msg(apart < 1e-5, "scene %d, law %d: %.1e", i, k, apart);
            ck_assert_double_lt(b.result->energy.error_ratio, 1e-6);
            march_free(&a);
            march_free(&b);
            thud_model_free(model);
        }
    thud_record_free(record);
}
END_TEST

static const char reference[] = "reference-towers.csv";

/* The towers under the real Kobe record, by an independent solver of order 4 at 1e-5 s with bisected events: good to
 * 1e-5, printed with 7 digits. */
START_TEST(towers_under_the_real_kobe)
{
    struct thud_record *record = march_kobe();
    char path[600];
    ck_assert(record && thud_suite_shared(reference, path, sizeof path));
    FILE *file = fopen(path, "r");
    ck_assert_ptr_nonnull(file);
    struct march_law laws[] = {concrete(), rubber(), rubber()};
    const char *const names[] = {"none", "bumper", "cavity"};
    const double out[] = {0, 0.05, 0.04};
    char line[256], name[16], structure;
    double gap, acceleration, drift, force;
    int floor, rows = 0, of = -1;
    struct march m = {0};
    struct thud_model *model = NULL;
    double gap_of = -1;
    while (fgets(line, sizeof line, file)) {
        if (sscanf(line, "%lf,%15[a-z],%c,%d,%lf,%lf,%lf", &gap, name, &structure, &floor, &acceleration, &drift,
                   &force) < 6)
            continue;
        int which = strcmp(name, names[0]) == 0 ? 0 : strcmp(name, names[1]) == 0 ? 1 : 2;
        if (which != of || gap != gap_of) {
            march_free(&m);
            thud_model_free(model);
            double clearance = gap - out[which];
            model = march_row(2, towers, false, clearance < 1e-12 ? 0 : clearance, &laws[which]);
            m = exact(model, record, 1e-6, 5);
            of = which;
            gap_of = gap;
        }
        const struct thud_floor_result *f = &m.result->structure[structure - 'A'].floor[floor - 1];
        ck_assert_msg(fabs(f->acceleration.value / acceleration - 1) < 1e-5 && fabs(f->drift.value / drift - 1) < 1e-5,
                      "%s", line);
        if (structure == 'A' && force > 0)
            ck_assert_msg(fabs(m.result->contact[floor - 1].force.value / force - 1) < 1e-5, "%s", line);
        rows++;
    }
    ck_assert_int_ge(rows, 90);
    march_free(&m);
    thud_model_free(model);
    thud_record_free(record);
    fclose(file);
}
END_TEST

/* Dormand and Prince's method against the exact one, there too. */
START_TEST(dormand_prince_under_the_real_kobe)
{
    struct thud_record *record = march_kobe();
    ck_assert_ptr_nonnull(record);
    struct march_law laws[] = {concrete(), rubber()};
    for (int i = 0; i < 2; i++)
        for (double gap = 0.02; gap < 0.09; gap += 0.03) {
            struct thud_model *model = march_row(2, towers, false, gap, &laws[i]);
            struct march a = exact(model, record, 1e-8, 5);
            struct march b = march_run(model, record, "dormand-prince", 0, 1e-6, true, 5);
            ck_assert_int_eq(b.status, THUD_OK);
            double apart = march_peaks_apart(b.result, a.result, 0.01);
            ck_assert_msg(apart < 1e-5, "law %d, gap %g: %.1e", i, gap, apart);
            march_free(&a);
            march_free(&b);
            thud_model_free(model);
        }
    thud_record_free(record);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("exact");
    TCase *tcase = tcase_create("exact");
    tcase_set_timeout(tcase, 120);
    tcase_add_test(tcase, tolerance_keeps_its_promise);
    tcase_add_test(tcase, loose_tolerances_keep_theirs);
    tcase_add_test(tcase, energy_adds_up_to_the_tolerance);
    tcase_add_test(tcase, mirror_image);
    tcase_add_test(tcase, scaling_of_laws_of_degree_one);
    tcase_add_test(tcase, each_contact_alone_ends_contact_free);
    tcase_add_test(tcase, identical_neighbours_never_touch);
    tcase_add_test(tcase, a_gap_too_wide_to_close_changes_no_bit);
    tcase_add_test(tcase, grazing);
    tcase_add_test(tcase, grazing_shorter_than_a_step);
    tcase_add_loop_test(tcase, parting_inside_a_step, 0, 2);
    tcase_add_test(tcase, beginning_inside_a_step);
    tcase_add_loop_test(tcase, no_length_is_of_its_own, 0, 8);
    tcase_add_test(tcase, from_wall_to_wall);
    tcase_add_test(tcase, touch_and_release_in_one_step);
    tcase_add_test(tcase, sticking_beyond_the_largest_strain);
    tcase_add_loop_test(tcase, neighbours_that_never_part, 0, 2);
    tcase_add_test(tcase, mass_ratio_of_a_million);
    tcase_add_test(tcase, nothing_lost_without_damping);
    tcase_add_test(tcase, from_one_storey_to_a_hundred_and_ten_in_a_row);
    char path[600];
    if (!thud_suite_shared(march_kobe_file, path, sizeof path)) {
        thud_suite_skips("the towers under the real Kobe record", "no folder ../shared (THUD_SHARED names another)");
    } else {
        tcase_add_test(tcase, dormand_prince_under_the_real_kobe);
        if (thud_suite_shared(reference, path, sizeof path))
            tcase_add_test(tcase, towers_under_the_real_kobe);
        else
            thud_suite_skips("the towers against an independent solver under the real Kobe record",
                             "no reference-towers.csv in that folder");
    }
    suite_add_tcase(suite, tcase);
    return suite;
}
