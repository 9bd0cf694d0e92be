/* Storeys that yield: loops in closed form, energy, symmetries, limits, an integrator of its own, other methods, and
 * numbers of textbooks. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "core/contact/storey.h"
#include "core/run/baseline.h"
#include "core/run/run_private.h"
#include "io/record/record_file.h"
#include "march.h"
#include "suite.h"

enum { FLOORS = 6 };
static const double mass_kg = 320e3, stiffness_npm = 600e6;

/* One storey on the ground. */
static struct thud_model *one_storey(double omega, double zeta, double yield_m, double hardening, double velocity)
{
    double m = 1000, k = m * omega * omega;
    struct thud_structure_input s = {.n = 1,
                                     .mass_kg = &m,
                                     .stiffness_npm = &k,
                                     .damping = zeta,
                                     .velocity_mps = velocity,
                                     .yield_m = &yield_m,
                                     .hardening = &hardening};
    struct thud_model *model = NULL;
    ck_assert_int_eq(thud_model_create(&(struct thud_model_input){.nstructures = 1, .structure = &s}, &model, NULL),
                     THUD_OK);
    return model;
}

struct yard {
    double yield_m, hardening, gap_m, scale;
    bool mirrored, elastic, same;
    const struct march_law *law;
};

/* Buildings of 4 and 6 storeys, side by side; `scale`: of lengths. */
static struct thud_model *two_towers(const struct yard *y)
{
    double m[FLOORS], k[FLOORS], yield[FLOORS], hardening[FLOORS];
    for (int i = 0; i < FLOORS; i++) {
        m[i] = mass_kg;
        k[i] = stiffness_npm;
        yield[i] = y->yield_m * y->scale * (i == 2 ? 0.8 : 1);
        hardening[i] = y->hardening;
    }
    struct thud_structure_input s[2];
    for (int i = 0; i < 2; i++) {
        s[i] = (struct thud_structure_input){.n = y->same || (i == 1) != y->mirrored ? 6 : 4,
                                             .mass_kg = m,
                                             .stiffness_npm = k,
                                             .damping = 0.05,
                                             .yield_m = y->elastic ? NULL : yield,
                                             .hardening = y->elastic ? NULL : hardening};
    }
    struct thud_contact_input c[FLOORS];
    int n = y->same ? 6 : 4;
    for (int i = 0; i < n; i++)
        c[i] = (struct thud_contact_input){.interface = 1,
                                           .left_floor = i + 1,
                                           .right_floor = i + 1,
                                           .left_structure = 0,
                                           .right_structure = 1,
                                           .clearance_m = y->gap_m * y->scale,
                                           .law = y->law->law,
                                           .setup = y->law->setup};
    struct thud_model *model = NULL;
    ck_assert_int_eq(
        thud_model_create(&(struct thud_model_input){.nstructures = 2, .structure = s, .ncontacts = n, .contact = c},
                          &model, NULL),
        THUD_OK);
    return model;
}

static struct march_law concrete(void)
{
    return march_law("kelvin-voigt-no-tension", "stiffness", 2.5e9, "restitution", 0.6, NULL);
}

static struct march_law rubber(void)
{
    return march_law("rubber", "stiffness", 0.36e3 * pow(1000, 2.65), "exponent", 2.65, "restitution", 0.5,
                     "max-strain", 0.8, "post-yield", 2.5e9, "thickness", 0.05, NULL);
}

static struct march run(const struct thud_model *model, const struct thud_record *record, double tolerance, double tail)
{
    struct march m = march_run(model, record, "exact", 0, tolerance, true, tail);
    ck_assert_msg(m.status == THUD_OK, "%s", m.err.what);
    return m;
}

/* ---- closed forms ---- */

/* Thrown at v: elastic to d_y, then a constant force brings it to rest. */
START_TEST(thrown_beyond_yield)
{
    double omega = 10, v = 1.5, d_y = 0.05;
    struct thud_model *model = one_storey(omega, 0, d_y, 0, v);
    struct march m = run(model, NULL, 1e-6, 0.8);
    const struct thud_storey_result *r = &m.result->structure[0].storey[0];
    double t1 = asin(omega * d_y / v) / omega, v1 = sqrt(v * v - omega * omega * d_y * d_y);
    double plastic = v1 * v1 / (2 * omega * omega * d_y), k = 1000 * omega * omega;
    const struct thud_floor_result *f = &m.result->structure[0].floor[0];
    ck_assert_double_eq_tol(f->drift.value, d_y + plastic, 1e-13);
    ck_assert_double_eq_tol(f->drift.time_s, t1 + v1 / (omega * omega * d_y), 1e-9);
    ck_assert_double_eq_tol(r->plastic_m, plastic, 1e-13);
    ck_assert_double_eq_tol(r->permanent_m, plastic, 1e-13);
    ck_assert_double_eq_tol(r->ductility, 1 + plastic / d_y, 1e-12);
    ck_assert_double_eq_tol(r->hysteretic_j, k * d_y * plastic, 1e-9 * k * d_y * plastic);
    ck_assert_double_eq_tol(m.result->structure[0].base_shear.value, k * d_y, 1e-9 * k * d_y);
    ck_assert_double_eq_tol(m.result->structure[0].base_shear.time_s, t1, 1e-9);
    ck_assert_int_eq(r->excursions, 1); /* back, it swings by d_y about the permanent drift and just does not yield */
    /* after that a swing of amplitude d_y about the plastic drift, from its crest */
    double u = plastic + d_y * cos(omega * (0.8 - f->drift.time_s));
    ck_assert_double_eq_tol(march_displacement(&m, 0), u, 1e-12);
    ck_assert_double_lt(m.result->energy.error_ratio, 1e-13);
    march_free(&m);
    thud_model_free(model);
}
END_TEST

/* Thrown, with hardening: turn after turn from the energy at each. On the way from a turn at drift a and shear V the
 * storey is elastic for 2 d_y, then its tangent is r k; it turns where the work done on it is its kinetic energy. */
START_TEST(loops_by_their_turns)
{
    double omega = 8, v = 5, d_y = 0.02, r = 0.6, m = 1000, k = m * omega * omega, drift = 0, shear = 0, lost = 0;
    double plastic = 0, kinetic = 0.5 * m * v * v, room = d_y, largest = 0;
    int sign = 1, excursions = 0;
    for (;;) {
        /* on the elastic branch: work V s + k s^2/2 with V against the motion */
        double before = sign * shear, work = before * room + 0.5 * k * room * room;
        if (kinetic <= work)
            break;
        kinetic -= work;
        drift += sign * room;
        shear += sign * k * room;
        /* then V s + r k s^2/2 = kinetic */
        double s = (-sign * shear + sqrt(shear * shear + 2 * r * k * kinetic)) / (r * k);
        drift += sign * s;
        shear += sign * r * k * s;
        plastic += sign * s;
        lost += (1 - r) * k * d_y * s;
        largest = fmax(largest, fabs(drift));
        excursions += s > 1e-9 * d_y; /* smaller ones are none */
        kinetic = 0;
        sign = -sign;
        room = 2 * d_y;
    }
    struct thud_model *model = one_storey(omega, 0, d_y, r, v);
    struct march x = run(model, NULL, 1e-6, 60);
    const struct thud_storey_result *got = &x.result->structure[0].storey[0];
    ck_assert_int_gt(excursions, 4);
    ck_assert_int_eq(got->excursions, excursions);
    ck_assert_double_eq_tol(got->plastic_m, plastic, 1e-12);
    ck_assert_double_eq_tol(got->permanent_m, (1 - r) * plastic, 1e-12);
    ck_assert_double_eq_tol(got->hysteretic_j / lost, 1, 1e-11);
    ck_assert_double_eq_tol(x.result->structure[0].floor[0].drift.value, largest, 1e-12);
    ck_assert_double_eq_tol(x.result->energy.hysteretic_j / lost, 1, 1e-11);
    ck_assert_double_lt(x.result->energy.error_ratio, 1e-12);
    march_free(&x);
    thud_model_free(model);
}
END_TEST

/* Stopped on its first excursion, far out: on the way back it yields the other way before it carries no force, where
 * r k d = (1 - r) k d_y. */
START_TEST(no_force_behind_the_other_bound)
{
    const double d_y = 0.02, r = 0.6;
    struct thud_model *model = one_storey(8, 0, d_y, r, 5);
    struct march x = run(model, NULL, 1e-6, 0.1);
    const struct thud_storey_result *got = &x.result->structure[0].storey[0];
    ck_assert_double_gt(r * got->plastic_m, d_y);
    ck_assert_double_eq_tol(got->permanent_m, (1 - r) * d_y / r, 1e-15);
    march_free(&x);
    thud_model_free(model);
}
END_TEST

/* ---- limits: what is elastic all the same ---- */

static void assert_same_bits(const struct thud_result *a, const struct thud_result *b, double tolerance)
{
    for (int s = 0; s < a->nstructures; s++)
        for (int i = 0; i < a->structure[s].floors; i++) {
            const struct thud_floor_result *x = &a->structure[s].floor[i], *y = &b->structure[s].floor[i];
            ck_assert_double_eq_tol(x->acceleration.value / y->acceleration.value, 1, tolerance);
            ck_assert_double_eq_tol(x->displacement.value / y->displacement.value, 1, tolerance);
            ck_assert_double_eq_tol(x->drift.value / y->drift.value, 1, tolerance);
        }
    for (int c = 0; c < a->ncontacts; c++)
        ck_assert_double_eq_tol(a->contact[c].force.value / b->contact[c].force.value, 1, tolerance);
}

START_TEST(elastic_all_the_same)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law laws[] = {rubber(), concrete()};
    for (int i = 0; i < 2; i++) {
        struct yard y = {.yield_m = 0.02, .hardening = 1, .gap_m = 0.02, .scale = 1, .law = &laws[i]};
        struct thud_model *no_drop = two_towers(&y);
        y = (struct yard){.yield_m = 10, .hardening = 0, .gap_m = 0.02, .scale = 1, .law = &laws[i]};
        struct thud_model *strong = two_towers(&y);
        y.elastic = true;
        struct thud_model *elastic = two_towers(&y);
        struct march a = run(no_drop, record, 1e-6, 2), b = run(strong, record, 1e-6, 2),
                     c = run(elastic, record, 1e-6, 2);
        ck_assert_int_eq(no_drop->nstoreys, 0);
        ck_assert_int_eq(strong->nstoreys, 10);
        ck_assert_int_gt(c.result->contact[3].impacts, 0);
        assert_same_bits(a.result, c.result, 1e-300);
        assert_same_bits(b.result, c.result, 1e-9); /* segments end elsewhere: collocation to its tolerance */
        ck_assert_double_eq(b.result->energy.hysteretic_j, 0);
        march_free(&a);
        march_free(&b);
        march_free(&c);
        thud_model_free(no_drop);
        thud_model_free(strong);
        thud_model_free(elastic);
    }
    thud_record_free(record);
}
END_TEST

/* ---- energy and symmetries ---- */

START_TEST(energy_balances)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law laws[] = {concrete(), rubber()};
    for (int i = 0; i < 2; i++)
        for (int h = 0; h < 3; h++) {
            struct yard y = {.yield_m = 0.01, .hardening = 0.05 * h, .gap_m = 0.02, .scale = 1, .law = &laws[i]};
            struct thud_model *model = two_towers(&y);
            struct march m = run(model, record, 1e-9, 2);
            double sum = 0;
            int excursions = 0;
            for (int s = 0; s < 2; s++)
                for (int f = 0; f < m.result->structure[s].floors; f++) {
                    const struct thud_storey_result *r = &m.result->structure[s].storey[f];
                    sum += r->hysteretic_j;
                    excursions += r->excursions;
                    double drift = m.result->structure[s].floor[f].drift.value;
                    ck_assert_double_eq_tol(r->ductility, drift / r->yield_m, 1e-12);
                }
            ck_assert_int_gt(excursions, 20);
            ck_assert_int_gt(m.result->contact[3].impacts, 0);
            ck_assert_double_eq_tol(sum / m.result->energy.hysteretic_j, 1, 1e-12);
            ck_assert_double_gt(sum, 0.1 * m.result->energy.input_j);
            ck_assert_msg(m.result->energy.error_ratio < 1e-9, "%.1e", m.result->energy.error_ratio);
            march_free(&m);
            thud_model_free(model);
        }
    thud_record_free(record);
}
END_TEST

static void assert_mirrored(const struct thud_result *a, const struct thud_result *b)
{
    for (int s = 0; s < 2; s++)
        for (int f = 0; f < a->structure[s].floors; f++) {
            const struct thud_storey_result *x = &a->structure[s].storey[f], *y = &b->structure[1 - s].storey[f];
            ck_assert_double_eq_tol(x->ductility / y->ductility, 1, 1e-8);
            ck_assert_double_eq_tol(x->plastic_m, -y->plastic_m, 1e-9);
            ck_assert_int_eq(x->excursions, y->excursions);
        }
}

START_TEST(mirror_image)
{
    struct thud_record *record = march_motion(1.5), *back = march_motion(-1.5);
    struct march_law law = rubber();
    struct yard y = {.yield_m = 0.012, .hardening = 0.02, .gap_m = 0.02, .scale = 1, .law = &law};
    struct thud_model *model = two_towers(&y);
    y.mirrored = true;
    struct thud_model *other = two_towers(&y);
    struct march a = run(model, record, 1e-9, 2), b = run(other, back, 1e-9, 2);
    assert_mirrored(a.result, b.result);
    march_free(&a);
    march_free(&b);
    thud_model_free(model);
    thud_model_free(other);
    thud_record_free(record);
    thud_record_free(back);
}
END_TEST

/* Record, yield drift and gap times s: drifts times s, ductility the same, under a law of degree one. */
START_TEST(lengths_scaled)
{
    double s = 1.7;
    struct thud_record *record = march_motion(1.5), *larger = march_motion(1.5 * s);
    struct march_law law = concrete();
    struct yard y = {.yield_m = 0.012, .hardening = 0, .gap_m = 0.02, .scale = 1, .law = &law};
    struct thud_model *model = two_towers(&y);
    y.scale = s;
    struct thud_model *scaled = two_towers(&y);
    struct march a = run(model, record, 1e-6, 2), b = run(scaled, larger, 1e-6, 2);
    for (int i = 0; i < 2; i++)
        for (int f = 0; f < a.result->structure[i].floors; f++) {
            const struct thud_storey_result *x = &a.result->structure[i].storey[f],
                                            *z = &b.result->structure[i].storey[f];
            ck_assert_double_eq_tol(x->ductility / z->ductility, 1, 1e-10);
            ck_assert_double_eq_tol(s * x->plastic_m, z->plastic_m, 1e-11);
            ck_assert_double_eq_tol(s * s * x->hysteretic_j, z->hysteretic_j, 1e-9 * (1 + z->hysteretic_j));
        }
    march_free(&a);
    march_free(&b);
    thud_model_free(model);
    thud_model_free(scaled);
    thud_record_free(record);
    thud_record_free(larger);
}
END_TEST

/* Two equal buildings: their storeys yield and unload at the same instants, and they never touch. */
START_TEST(twins_yield_together)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law law = concrete();
    struct yard y = {.yield_m = 0.012, .gap_m = 0, .scale = 1, .law = &law, .same = true};
    struct thud_model *model = two_towers(&y);
    struct march m = run(model, record, 1e-6, 2);
    for (int f = 0; f < 6; f++) {
        const struct thud_storey_result *a = &m.result->structure[0].storey[f], *b = &m.result->structure[1].storey[f];
        ck_assert_int_eq(a->excursions, b->excursions);
        ck_assert_double_eq_tol(a->plastic_m, b->plastic_m, 1e-12);
        ck_assert_double_lt(m.result->contact[f].force.value, 1);
    }
    ck_assert_int_gt(m.result->structure[0].storey[0].excursions, 2);
    march_free(&m);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Rows know whose they are: behind those of the contacts each is a storey's, whose force by its branch is the one by the
 * return to its bound. */
START_TEST(rows_know_whose_they_are)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law law = concrete();
    struct yard y = {.yield_m = 0.012, .hardening = 0.1, .gap_m = 0.02, .scale = 1, .law = &law};
    struct thud_model *model = two_towers(&y);
    int yielding = 0, shifted = 0;
    for (size_t i = 1; i <= 20; i++) {
        struct thud_record begins = *record;
        begins.samples = 50 + 5 * i;
        struct march m = run(model, &begins, 1e-6, 0);
        const struct thud_state *state = &m.run->state;
        for (int c = 0; c < model->ncontacts; c++)
            ck_assert_ptr_eq(thud_row_contact(state, c), &state->contact[c]);
        for (int k = 0; k < model->nstoreys; k++) {
            const int row = model->ncontacts + k;
            const double drift = thud_contact_indentation(state, row);
            double slope;
            ck_assert_ptr_null(thud_row_contact(state, row));
            ck_assert_double_eq_tol(thud_branch_force(thud_row_branch(state, row), drift, 0, NULL, NULL),
                                    thud_storey_force(state, k, drift, &slope), 1e-9 * stiffness_npm * y.yield_m);
            ck_assert(thud_row_acts(state, row) == (state->storey[k].direction != 0));
            yielding += thud_row_acts(state, row);
            shifted += !thud_row_acts(state, row) && state->storey[k].plastic_m != 0;
        }
        march_free(&m);
    }
    ck_assert_int_gt(yielding, 0);
    ck_assert_int_gt(shifted, 0);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* ---- other ways to the same result ---- */

/* Two storeys by the trapezoids of their own equations of motion in tiny steps. */
START_TEST(an_integrator_of_its_own)
{
    enum { N = 2 };
    const double m[N] = {5000, 2500}, k[N] = {400e3, 200e3}, d_y[N] = {0.02, 0.015}, r[N] = {0.05, 0.1};
    struct thud_record *record = march_motion(0.5);
    struct thud_structure_input s = {
        .n = N, .mass_kg = m, .stiffness_npm = k, .yield_m = d_y, .hardening = r, .damping = 0};
    struct thud_model *model = NULL;
    ck_assert_int_eq(thud_model_create(&(struct thud_model_input){.nstructures = 1, .structure = &s}, &model, NULL),
                     THUD_OK);
    struct march x = run(model, record, 1e-6, 2);
    double u[N] = {0}, v[N] = {0}, p[N] = {0}, drift[N] = {0}, h = 1e-5;
    long steps = lround((record->dt_s * (double)(record->samples - 1) + 2) / h);
    for (long i = 0; i < steps; i++) { /* leapfrog: second order, and the loop's own corners below that */
        double t = (double)i * h, at = t / record->dt_s, ground = 0;
        size_t j = (size_t)at;
        if (j + 1 < record->samples)
            ground = record->a_mps2[j] + (at - (double)j) * (record->a_mps2[j + 1] - record->a_mps2[j]);
        double shear[N];
        for (int f = 0; f < N; f++) {
            double d = u[f] - (f > 0 ? u[f - 1] : 0);
            p[f] = d - p[f] > d_y[f] ? d - d_y[f] : d - p[f] < -d_y[f] ? d + d_y[f] : p[f];
            drift[f] = fmax(drift[f], fabs(d));
            shear[f] = r[f] * k[f] * d + (1 - r[f]) * k[f] * (d - p[f]);
        }
        for (int f = 0; f < N; f++) {
            double a = -ground - (shear[f] - (f + 1 < N ? shear[f + 1] : 0)) / m[f];
            v[f] += (i == 0 ? 0.5 : 1) * h * a;
        }
        for (int f = 0; f < N; f++)
            u[f] += h * v[f];
    }
    for (int f = 0; f < N; f++) {
        const struct thud_storey_result *got = &x.result->structure[0].storey[f];
        ck_assert_int_gt(got->excursions, 2);
        ck_assert_double_eq_tol(x.result->structure[0].floor[f].drift.value / drift[f], 1, 1e-5);
        ck_assert_double_eq_tol(got->plastic_m, p[f], 1e-6);
    }
    march_free(&x);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

static double storeys_apart(const struct thud_result *a, const struct thud_result *b)
{
    double worst = 0;
    for (int s = 0; s < a->nstructures; s++)
        for (int f = 0; f < a->structure[s].floors; f++) {
            const struct thud_storey_result *x = &a->structure[s].storey[f], *y = &b->structure[s].storey[f];
            worst = fmax(worst, fabs(x->ductility / y->ductility - 1));
            worst = fmax(worst, fabs(x->plastic_m - y->plastic_m) / y->yield_m);
        }
    return worst;
}

START_TEST(dormand_prince_agrees)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law laws[] = {concrete(), rubber()};
    for (int i = 0; i < 2; i++) {
        struct yard y = {.yield_m = 0.012, .hardening = 0.02, .gap_m = 0.02, .scale = 1, .law = &laws[i]};
        struct thud_model *model = two_towers(&y);
        struct march a = run(model, record, 1e-11, 1);
        struct march b = march_run(model, record, "dormand-prince", 0, 1e-12, true, 1);
        ck_assert_msg(b.status == THUD_OK, "%s", b.err.what);
        double apart = storeys_apart(a.result, b.result), peaks = march_peaks_apart(a.result, b.result, 0.01);
        ck_assert_msg(apart < 1e-8 && peaks < 1e-8, "%s: %.1e, %.1e", laws[i].law->name, apart, peaks);
        march_free(&a);
        march_free(&b);
        thud_model_free(model);
    }
    thud_record_free(record);
}
END_TEST

/* Every method runs them, and comes to the same result with short steps, with and without location. */
START_TEST(every_method_converges)
{
    struct thud_record *record = march_motion(0.6);
    struct march_law law = march_law("linear", "stiffness", 50e6, NULL);
    struct yard y = {.yield_m = 0.012, .hardening = 0.05, .gap_m = 0.02, .scale = 1, .law = &law};
    struct thud_model *model = two_towers(&y);
    struct march exact = run(model, record, 1e-9, 1);
    ck_assert_int_gt(exact.result->structure[1].storey[0].excursions, 2);
    for (int i = 0; i < thud_method_count(); i++)
        for (int locate = 0; locate < 2; locate++) {
            const struct thud_method *method = thud_method_at(i);
            if (method->order == 0)
                continue;
            bool fixed = method->flags & THUD_METHOD_FIXED_STEP;
            struct march m = march_run(model, record, method->name, fixed ? 2e-4 : 0, 1e-8, locate, 1);
            ck_assert_msg(m.status == THUD_OK, "%s: %s", method->name, m.err.what);
            double apart = storeys_apart(m.result, exact.result);
            ck_assert_msg(apart < (method->order > 1 && strcmp(method->name, "lagged") != 0 ? 3e-3 : 0.1),
                          "%s, locate %d: %.1e", method->name, locate, apart);
            march_free(&m);
        }
    march_free(&exact);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* ---- extremes ---- */

/* Hardly any elastic range: many excursions, but no end of them. */
START_TEST(nearly_rigid_plastic)
{
    struct thud_record *record = march_motion(1);
    double yields[] = {1e-4, 1e-5, 2e-6};
    for (int i = 0; i < 3; i++) {
        struct thud_model *model = one_storey(40, 0.05, yields[i], 0, 0);
        struct march m = run(model, record, 1e-6, 1);
        ck_assert_int_gt(m.result->structure[0].storey[0].excursions, 5);
        ck_assert_int_lt(m.result->work.events, 20000);
        ck_assert_double_lt(m.result->energy.error_ratio, 1e-9);
        march_free(&m);
        thud_model_free(model);
    }
    thud_record_free(record);
}
END_TEST

/* The loops of a history have the area that was lost, and every point of them lies within the yield surface. */
START_TEST(histories_show_the_loops)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law law = concrete();
    struct yard y = {.yield_m = 0.012, .hardening = 0.03, .gap_m = 0.02, .scale = 1, .law = &law};
    struct thud_model *model = two_towers(&y);
    struct thud_run_options options;
    thud_run_options_init(&options);
    options.keep_history = true;
    options.history_step_s = 1e-3;
    options.tail_s = 3;
    struct thud_run *run = NULL;
    bool done = false;
    ck_assert_int_eq(thud_run_create(model, record, &options, &run, NULL), THUD_OK);
    while (!done)
        ck_assert_int_eq(thud_run_advance(run, 1000, &done, NULL), THUD_OK);
    const struct thud_history *h = thud_run_history(run);
    const struct thud_result *r = thud_run_result(run);
    ck_assert_int_eq(h->nstoreys, 10);
    for (int k = 0; k < h->nstoreys; k++) {
        const struct thud_model_storey *p = &model->storey[k];
        const struct thud_storey_result *storey = &r->structure[p->structure].storey[p->floor];
        double area = 0, largest = 0;
        for (size_t i = 0; i < h->rows; i++) {
            const double *row = h->value + i * (size_t)h->columns, *before = row - h->columns;
            double d = row[thud_history_storey_drift(h, k)], v = row[thud_history_storey_shear(h, k)];
            double plastic = row[thud_history_storey_plastic(h, k)];
            ck_assert_double_lt(fabs(d - plastic), p->yield_m * (1 + 1e-9));
            ck_assert_double_eq_tol(v, p->stiffness_npm * (d - (1 - p->hardening) * plastic),
                                    1e-9 * p->stiffness_npm * p->yield_m);
            largest = fmax(largest, fabs(v));
            if (i > 0)
                area +=
                    0.5 * (v + before[thud_history_storey_shear(h, k)]) * (d - before[thud_history_storey_drift(h, k)]);
        }
        ck_assert_double_eq_tol(largest / storey->shear.value, 1, 1e-9);
        ck_assert_double_eq_tol(area, storey->hysteretic_j, 2e-3 * r->energy.hysteretic_j);
    }
    const double *last = h->value + (h->rows - 1) * (size_t)h->columns;
    ck_assert_double_eq_tol(last[thud_history_hysteretic(h, 0)] / r->energy.hysteretic_j, 1, 1e-9);
    thud_run_free(run);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* ---- studies ---- */

/* A run that begins at a kept moment of the baseline is the run from the start; and its largest relative displacement is
 * the clearance at which there is no contact. */
START_TEST(the_baseline_is_shared)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law law = rubber();
    struct yard y = {.yield_m = 0.012, .hardening = 0.03, .gap_m = 0.05, .scale = 1, .law = &law};
    struct thud_model *model = two_towers(&y);
    struct thud_run_options options;
    struct thud_baseline_motion *baseline;
    bool done = false;
    thud_run_options_init(&options);
    options.tail_s = 2;
    ck_assert_int_eq(thud_baseline_create(model, 0, record, &options, &baseline, NULL), THUD_OK);
    while (!done)
        ck_assert_int_eq(thud_baseline_advance(baseline, 1000, &done, NULL), THUD_OK);
    double closing = 0;
    for (int c = 0; c < model->ncontacts; c++)
        closing = fmax(closing, thud_baseline_relative_displacement(baseline, c));
    for (int k = 0; k < 3; k++) {
        y.gap_m = closing * (k == 0 ? 0.8 : k == 1 ? 1 - 1e-6 : 1 + 1e-9);
        struct thud_model *one = two_towers(&y);
        struct march whole = run(one, record, 1e-6, 2);
        struct thud_run *part = NULL;
        double shared_s = 0;
        ck_assert_int_eq(thud_baseline_run(baseline, one, record, &options, &part, &shared_s, NULL), THUD_OK);
        for (done = false; !done;)
            ck_assert_int_eq(thud_run_advance(part, 1000, &done, NULL), THUD_OK);
        const struct thud_result *a = thud_run_result(part), *b = whole.result;
        ck_assert_double_gt(shared_s, 0.5);
        ck_assert_double_eq(storeys_apart(a, b), 0);
        ck_assert_double_eq(march_peaks_apart(a, b, 0.01), 0);
        ck_assert_double_lt(a->energy.error_ratio, 1e-9);
        ck_assert_double_eq_tol(a->energy.hysteretic_j / b->energy.hysteretic_j, 1, 1e-12);
        ck_assert_int_eq(b->contact[3].impulse_ns > 0, k < 2);
        thud_run_free(part);
        march_free(&whole);
        thud_model_free(one);
    }
    thud_baseline_free(baseline);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* A blow turns a storey that yields back at once, and one that is elastic past its bound. */
START_TEST(blows_on_storeys_that_yield)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law law = march_law("stereomechanical", "restitution", 0.6, NULL);
    struct yard y = {.yield_m = 0.006, .hardening = 0.02, .gap_m = 0.004, .scale = 1, .law = &law};
    struct thud_model *model = two_towers(&y);
    struct march m = run(model, record, 1e-8, 2);
    ck_assert_int_gt(m.result->contact[3].impacts, 20);
    ck_assert_int_gt(m.result->structure[0].storey[0].excursions, 10);
    ck_assert_msg(m.result->energy.error_ratio < 1e-9, "%.1e", m.result->energy.error_ratio);
    march_free(&m);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Without hardening, shaken by a ground motion that turns at every sample: it yields both ways without end. The run ends
 * with whose events they are. */
START_TEST(yielding_without_end_is_said)
{
    enum { SAMPLES = 52000 };
    static double a_mps2[SAMPLES];
    for (int i = 0; i < SAMPLES; i++)
        a_mps2[i] = i % 2 ? -5 : 5;
    double mass[] = {1e7, 1e7}, k[] = {6e8, 6e8}, d_y[] = {INFINITY, 1e-5}, r[] = {0, 0};
    struct thud_structure_input s[2] = {{.n = 1, .mass_kg = mass, .stiffness_npm = k},
                                        {.n = 2, .mass_kg = mass, .stiffness_npm = k, .yield_m = d_y, .hardening = r}};
    struct thud_model *model = NULL;
    struct thud_record *record = NULL;
    ck_assert_int_eq(thud_record_create(a_mps2, SAMPLES, 0.1, &record, NULL), THUD_OK);
    ck_assert_int_eq(thud_model_create(&(struct thud_model_input){.nstructures = 2, .structure = s}, &model, NULL),
                     THUD_OK);
    struct march m = march_run(model, record, "exact", 0, 1e-6, true, 8e5);
    ck_assert_int_eq(m.status, THUD_DIVERGED);
    ck_assert_ptr_nonnull(strstr(m.err.what, "storeys yield and unload 100000 times from t = 0 s"));
    ck_assert_ptr_nonnull(strstr(m.err.what, "last storey 2 of structure 2"));
    ck_assert_str_eq(m.err.key, "structures.2.yield.2");
    march_free(&m);
    thud_record_free(record);
    thud_model_free(model);
}
END_TEST

/* ---- books ---- */

static struct thud_record *el_centro;

/* Chopra, Fig. 7.4.2: T 0.5 s, undamped, elastoplastic, f_y = 0.171 m g: 4.34 cm. NPTEL 7.3: 0.1483 m at the top, 0.068 m
 * below, storey forces 9.87 and 19.74 kN. */
START_TEST(textbooks)
{
    double omega = 4 * THUD_PI;
    struct thud_model *model = one_storey(omega, 0, 0.171 * THUD_GRAVITY / (omega * omega), 0, 0);
    struct march m = run(model, el_centro, 1e-6, 0);
    ck_assert_double_eq_tol(m.result->structure[0].floor[0].drift.value / 0.0434, 1, 5e-3);
    march_free(&m);
    thud_model_free(model);
    double mass[] = {5000, 2500}, k[] = {394784, 197392}, d_y[] = {0.05, 0.05}, r[] = {0, 0};
    struct thud_structure_input s = {
        .n = 2, .mass_kg = mass, .stiffness_npm = k, .damping = 0.02, .yield_m = d_y, .hardening = r};
    ck_assert_int_eq(thud_model_create(&(struct thud_model_input){.nstructures = 1, .structure = &s}, &model, NULL),
                     THUD_OK);
    m = run(model, el_centro, 1e-6, 5);
    const struct thud_structure_result *p = &m.result->structure[0];
    ck_assert_double_eq_tol(p->floor[1].displacement.value / 0.1483, 1, 2e-3);
    ck_assert_double_eq_tol(p->floor[0].displacement.value / 0.068, 1, 2e-3);
    ck_assert_double_eq_tol(p->storey[1].shear.value / 9870, 1, 1e-3);
    ck_assert_double_eq_tol(p->base_shear.value / 19740, 1, 1e-3);
    march_free(&m);
    thud_model_free(model);
}
END_TEST

static void free_el_centro(void)
{
    thud_record_free(el_centro);
}

Suite *thud_suite(void)
{
    static struct thud_record_choice choice;
    Suite *suite = suite_create("yield");
    TCase *tcase = tcase_create("yield");
    tcase_add_test(tcase, thrown_beyond_yield);
    tcase_add_test(tcase, loops_by_their_turns);
    tcase_add_test(tcase, no_force_behind_the_other_bound);
    tcase_add_test(tcase, elastic_all_the_same);
    tcase_add_test(tcase, energy_balances);
    tcase_add_test(tcase, mirror_image);
    tcase_add_test(tcase, lengths_scaled);
    tcase_add_test(tcase, twins_yield_together);
    tcase_add_test(tcase, rows_know_whose_they_are);
    tcase_add_test(tcase, an_integrator_of_its_own);
    tcase_add_test(tcase, dormand_prince_agrees);
    tcase_add_test(tcase, every_method_converges);
    tcase_add_test(tcase, nearly_rigid_plastic);
    tcase_add_test(tcase, histories_show_the_loops);
    tcase_add_test(tcase, the_baseline_is_shared);
    tcase_add_test(tcase, blows_on_storeys_that_yield);
    tcase_add_test(tcase, yielding_without_end_is_said);
    thud_record_choice_init(&choice);
    bool there =
        thud_suite_shared("records/imperial-valley-1940-el-centro-ns-chopra.csv", choice.file, sizeof choice.file);
    strcpy(choice.unit, "g");
    if (there && thud_record_file_read(choice.file, &choice, &el_centro, NULL) == THUD_OK) {
        tcase_add_test(tcase, textbooks);
        atexit(free_el_centro);
    } else {
        thud_suite_skips("textbooks", "El Centro as in Chopra's book is not there");
    }
    suite_add_tcase(suite, tcase);
    return suite;
}
