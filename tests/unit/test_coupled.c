/* Damping that couples modes (isolated buildings), up to dashpots whose own rates are far above every natural
 * frequency: against the exponential of the first-order system, written down floor by floor, and against other methods.
 */
#include <check.h>
#include <math.h>
#include <string.h>

#include "core/run/run_private.h"
#include "march.h"

enum { N = 6 }; /* base and floor: displacements, velocities; ground acceleration and its slope */

static void multiply(double a[N][N], double b[N][N], double out[N][N])
{
    double c[N][N] = {{0}};
    for (int i = 0; i < N; i++)
        for (int k = 0; k < N; k++)
            for (int j = 0; j < N; j++)
                c[i][j] += a[i][k] * b[k][j];
    memcpy(out, c, sizeof c);
}

/* exp(a) by Taylor's series of a part of it that is small enough, squared. */
static void exponential(double a[N][N], double out[N][N])
{
    double size = 0, term[N][N] = {{0}}, part[N][N];
    int halved = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            size = fmax(size, fabs(a[i][j]) * N);
    while (ldexp(size, -halved) > 0.5)
        halved++;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            part[i][j] = ldexp(a[i][j], -halved);
            out[i][j] = term[i][j] = i == j;
        }
    for (int k = 1; k <= 20; k++) {
        multiply(term, part, term);
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++)
                out[i][j] += term[i][j] /= k;
    }
    for (int k = 0; k < halved; k++)
        multiply(out, out, out);
}

/* A slab under one floor. */
struct slab {
    double base_kg, floor_kg, isolator_npm, storey_npm, zeta, isolator_zeta;
};
static const struct slab slabs[] = {{320e3, 320e3, 6e6, 6e8, 0.05, 0.15},
                                    {10e3, 5000e3, 12.5e6, 1e10, 0.2, 0.4},
                                    {1e3, 5000e3, 12.5e6, 1e9, 0.9, 0.9},
                                    {5000e3, 1e3, 12.5e6, 1e6, 0.7, 0.05}};
enum { SLABS = sizeof slabs / sizeof *slabs };

static struct thud_model *model_of(const struct slab *s)
{
    const double mass[] = {s->base_kg, s->floor_kg}, stiffness[] = {s->isolator_npm, s->storey_npm};
    struct thud_structure_input building = {.n = 2,
                                            .mass_kg = mass,
                                            .stiffness_npm = stiffness,
                                            .damping = s->zeta,
                                            .isolated = true,
                                            .isolation_damping = s->isolator_zeta};
    struct thud_model *model;
    ck_assert_int_eq(
        thud_model_create(&(struct thud_model_input){.nstructures = 1, .structure = &building}, &model, NULL), THUD_OK);
    return model;
}

/* Its motion over h: (u_b, u_f, v_b, v_f, a_g, slope of a_g). */
static void flow_of(const struct slab *s, double h, double out[N][N])
{
    double cb = 2 * s->isolator_zeta * sqrt(s->isolator_npm * (s->base_kg + s->floor_kg));
    double cf = 2 * s->zeta * sqrt(s->storey_npm * s->floor_kg), kb = s->isolator_npm, kf = s->storey_npm;
    double a[N][N] = {{0, 0, 1, 0, 0, 0},
                      {0, 0, 0, 1, 0, 0},
                      {-(kb + kf) / s->base_kg, kf / s->base_kg, -(cb + cf) / s->base_kg, cf / s->base_kg, -1, 0},
                      {kf / s->floor_kg, -kf / s->floor_kg, cf / s->floor_kg, -cf / s->floor_kg, -1, 0},
                      {0, 0, 0, 0, 0, 1},
                      {0, 0, 0, 0, 0, 0}};
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            a[i][j] *= h;
    exponential(a, out);
}

START_TEST(against_the_exponential)
{
    const struct slab *slab = &slabs[_i];
    struct thud_record *record = march_motion(1);
    struct thud_model *model = model_of(slab);
    struct march m = march_run(model, record, "exact", 0, 0, true, 0);
    double flow[N][N], x[N] = {0}, most[2] = {0};
    ck_assert_int_eq(m.status, THUD_OK);
    flow_of(slab, record->dt_s, flow);
    for (size_t i = 0; i + 1 < record->samples; i++) {
        double next[N] = {0};
        x[4] = record->a_mps2[i];
        x[5] = (record->a_mps2[i + 1] - record->a_mps2[i]) / record->dt_s;
        for (int r = 0; r < N; r++)
            for (int c = 0; c < N; c++)
                next[r] += flow[r][c] * x[c];
        memcpy(x, next, sizeof x);
        for (int f = 0; f < 2; f++)
            most[f] = fmax(most[f], fabs(x[f]));
    }
    for (int f = 0; f < 2; f++) {
        double peak = m.result->structure[0].floor[f].displacement.value;
        ck_assert_double_eq_tol(march_displacement(&m, f), x[f], 1e-9 * most[f]);
        ck_assert_double_eq_tol(march_velocity(&m, f), x[2 + f], 1e-9 * m.result->structure[0].floor[f].velocity.value);
        ck_assert_double_ge(peak, most[f] * (1 - 1e-9)); /* of the samples */
        ck_assert_double_le(peak, most[f] * 1.05);
    }
    ck_assert_double_lt(m.result->energy.error_ratio, 1e-11);
    march_free(&m);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

START_TEST(against_dormand_prince)
{
    struct thud_record *record = march_motion(1);
    struct thud_model *model = model_of(&slabs[_i]);
    const double tolerance = _i == 2 ? 1e-8 : 1e-12; /* strong dashpots bind its steps, not the tolerance */
    struct march a = march_run(model, record, "exact", 0, 0, true, 1);
    struct march b = march_run(model, record, "dormand-prince", 0, tolerance, true, 1);
    ck_assert_int_eq(a.status, THUD_OK);
    ck_assert_int_eq(b.status, THUD_OK);
    ck_assert_double_lt(march_peaks_apart(a.result, b.result, 0.01), 1e-7);
    march_free(&a);
    march_free(&b);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Four floors of 5000 t on a slab of 10 t that strikes a wall: the wall's contact is linear, so that the series runs
 * through it too. The slab's acceleration once came out 800 times too large. */
START_TEST(a_light_slab_that_strikes)
{
    const double mass[] = {10e3, 5e6, 5e6, 5e6, 5e6}, stiffness[] = {12.5e6, 1e10, 1e10, 1e10, 1e10};
    struct march_law law = march_law("kelvin-voigt-no-tension", "stiffness", 2.5e9, "restitution", 0.6, NULL);
    struct thud_structure_input s[2] = {{.n = 5,
                                         .mass_kg = mass,
                                         .stiffness_npm = stiffness,
                                         .damping = 0.2,
                                         .isolated = true,
                                         .isolation_damping = 0.4},
                                        {.n = 0}};
    struct thud_contact_input contact = {.interface = 1,
                                         .left_floor = 1,
                                         .left_structure = 0,
                                         .right_structure = 1,
                                         .clearance_m = 0.02,
                                         .law = law.law,
                                         .setup = law.setup};
    struct thud_model_input input = {.nstructures = 2, .structure = s, .ncontacts = 1, .contact = &contact};
    struct thud_model *model;
    struct thud_record *record = march_motion(1);
    ck_assert_int_eq(thud_model_create(&input, &model, NULL), THUD_OK);
    struct march a = march_run(model, record, "exact", 0, 0, true, 1);
    struct march b = march_run(model, record, "dormand-prince", 0, 1e-10, true, 1);
    ck_assert_int_eq(a.status, THUD_OK);
    ck_assert_int_eq(b.status, THUD_OK);
    ck_assert_int_gt(a.result->contact[0].impacts, 0);
    ck_assert_double_lt(march_peaks_apart(a.result, b.result, 0.01), 1e-6);
    ck_assert_double_lt(a.result->energy.error_ratio, 1e-11);
    march_free(&a);
    march_free(&b);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* The series of a building whose slab is pressed against a wall, beside a building that damping does not couple: each
 * order against the equation of motion and the law of the contact, of few modes and of many. */
START_TEST(series_hold_the_equation_order_by_order)
{
    enum { MOST = 12 };
    double mass[MOST], stiffness[MOST];
    struct march_law law = march_law("kelvin-voigt-no-tension", "stiffness", 2.5e9, "restitution", 0.6, NULL);
    for (int i = 0; i < MOST; i++) {
        mass[i] = 300e3 + 20e3 * i;
        stiffness[i] = i == 0 ? 12e6 : 6e8 - 3e7 * i;
    }
    struct thud_structure_input s[3] = {{.n = 3, .mass_kg = mass, .stiffness_npm = stiffness + 1, .damping = 0.03},
                                        {.n = _i + 1,
                                         .mass_kg = mass,
                                         .stiffness_npm = stiffness,
                                         .damping = 0.05,
                                         .isolated = true,
                                         .isolation_damping = 0.15},
                                        {.n = 0}};
    struct thud_contact_input contact = {.interface = 2,
                                         .left_floor = 1,
                                         .left_structure = 1,
                                         .right_structure = 2,
                                         .clearance_m = 0.02,
                                         .law = law.law,
                                         .setup = law.setup};
    struct thud_model *m;
    struct thud_segment seg;
    ck_assert_int_eq(
        thud_model_create(
            &(struct thud_model_input){.nstructures = 3, .structure = s, .ncontacts = 1, .contact = &contact}, &m,
            NULL),
        THUD_OK);
    struct march run = march_run(m, NULL, "exact", 0, 0, true, 0.01);
    struct thud_state *state = &run.run->state;
    state->contact[0].mode = THUD_CLOSED;
    state->contact[0].branch = (struct thud_branch){.k_npm = 2.5e9, .c_nspm = 6e6};
    state->nactive = 1;
    state->grid = 0;
    state->offset_s = 0;
    for (int j = 0; j < m->nmodes; j++) {
        state->q[j] = 30 * sin(1 + j);
        state->qd[j] = 300 * cos(2 + 3 * j);
    }
    const double h = 0.5 / thud_segment_rate(state);
    ck_assert_int_eq(thud_segment_init(&seg, state, NULL), THUD_OK);
    thud_segment_begin(state, &seg, h, thud_segment_all_terms(state, h));
    thud_taylor_linear(state, &seg);
    const struct thud_model_structure *p = &m->structure[1];
    for (int k = 0; k + 2 < seg.terms; k++) {
        const double *q = seg.q + k * m->nmodes, *q1 = q + m->nmodes, *q2 = q1 + m->nmodes, force = seg.force[k],
                     d = thud_model_gap_sum(m, 0, q) - (k == 0 ? 0.02 : 0), d1 = thud_model_gap_sum(m, 0, q1);
        ck_assert_double_eq_tol(force, 2.5e9 * d + 6e6 * (k + 1) / h * d1,
                                1e-12 * (2.5e9 * fabs(d) + 6e6 * (k + 1) / h * fabs(d1)) + 1e-9);
        for (int j = 0; j < m->nmodes; j++) {
            double sum = m->spring[j] * q[j] + m->jacobian[j] * force + m->dashpot[j] * (k + 1) / h * q1[j],
                   size = fabs(m->spring[j] * q[j]) + fabs(m->jacobian[j] * force);
            for (int i = 0; i < p->modes && p->damping && j >= p->first_mode; i++) {
                sum += p->damping[(j - p->first_mode) * p->modes + i] * (k + 1) / h * q1[p->first_mode + i];
                size += fabs(p->damping[(j - p->first_mode) * p->modes + i] * (k + 1) / h * q1[p->first_mode + i]);
            }
            ck_assert_double_eq_tol(q2[j] * (k + 1) * (k + 2) / (h * h), -sum, 1e-11 * size + 1e-9);
        }
    }
    march_free(&run);
    thud_model_free(m);
}
END_TEST

/* Derivative of a floor's displacement of this order at s of a series. */
static double derivative(const struct thud_model *m, const struct thud_segment *seg, int floor, int order, double s)
{
    double sum = 0;
    for (int k = seg->terms - 1; k >= order; k--) {
        double factor = 1;
        for (int i = 0; i < order; i++)
            factor *= (k - i) / seg->h_s;
        sum = sum * s + factor * thud_model_floor(m, floor, seg->q + k * m->nmodes);
    }
    return sum;
}

/* The bounds of a block's margins against the series of its intervals. */
static enum thud_status check_bounds(void *own, const struct thud_state *state, struct thud_free_vibration *f,
                                     int intervals, struct thud_error *err)
{
    enum { POINTS = 16 };
    double *nearest = own, h2 = f->dt_s * f->dt_s;
    (void)err;
    for (int t = 0; t < intervals; t++)
        for (int piece = 0; piece < f->pieces; piece++) {
            const struct thud_segment *seg = thud_free_vibration_all_series(f, state, t, piece);
            for (int i = 0; i <= POINTS; i++)
                for (int floor = 0; floor < state->model->ndof; floor++) {
                    const double second = fabs(derivative(state->model, seg, floor, 2, (double)i / POINTS)) * h2 / 8,
                                 fourth = fabs(derivative(state->model, seg, floor, 4, (double)i / POINTS)) * h2 * h2;
                    ck_assert_double_le(second, f->margin[0] * (1 + 1e-9));
                    ck_assert_double_le(fourth, h2 * h2 * thud_free_vibration_floor_bend(f, state->model, 0, 0, 4) *
                                                    (1 + 1e-9));
                    *nearest = fmax(*nearest, second / f->margin[0]);
                }
        }
    return THUD_OK;
}

START_TEST(no_derivative_passes_its_bound)
{
    static const struct thud_observer bounds = {.block = check_bounds};
    struct thud_record *record = march_motion(1);
    struct thud_model *model = model_of(&slabs[_i]);
    struct thud_run_options options;
    struct thud_run *run;
    double nearest = 0;
    bool done = false;
    thud_run_options_init(&options);
    ck_assert_int_eq(thud_run_create(model, record, &options, &run, NULL), THUD_OK);
    thud_run_observe(run, &bounds, &nearest);
    while (!done)
        ck_assert_int_eq(thud_run_advance(run, 1000, &done, NULL), THUD_OK);
    ck_assert(nearest > 0.01 || !run->free_vibration); /* too fast for blocks */
    thud_run_free(run);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* The run of a model with the propagator of one interval, or without it: by power series alone. */
static struct march way(const struct thud_model *model, const struct thud_record *record, bool blocks)
{
    struct march m = {0};
    struct thud_run_options options;
    bool done = false;
    thud_run_options_init(&options);
    options.method = thud_method_find("exact");
    options.tail_s = 2;
    m.status = thud_run_create(model, record, &options, &m.run, &m.err);
    ck_assert_int_eq(m.status, THUD_OK);
    ck_assert_ptr_nonnull(m.run->free_vibration);
    if (!blocks)
        m.run->free_vibration = NULL;
    while (m.status == THUD_OK && !done)
        m.status = thud_run_advance(m.run, 1000, &done, &m.err);
    ck_assert_int_eq(m.status, THUD_OK);
    m.result = thud_run_result(m.run);
    return m;
}

static void compare_ways(const struct thud_model *model, const struct thud_record *record, bool in_contact)
{
    struct march a = way(model, record, true), b = way(model, record, false);
    ck_assert_int_gt(a.result->work.samples_fast, in_contact ? 100 : 400);
    ck_assert_int_eq(b.result->work.samples_fast, 0);
    ck_assert_double_lt(march_peaks_apart(a.result, b.result, 0.01), 1e-10);
    ck_assert_double_lt(march_distance(&a, &b), 1e-10);
    const struct thud_energy *x = &a.result->energy, *y = &b.result->energy;
    ck_assert_double_eq_tol(x->input_j / y->input_j, 1, 1e-11);
    ck_assert_double_eq_tol(x->viscous_j / y->viscous_j, 1, 1e-11);
    ck_assert_double_lt(x->error_ratio, 1e-12);
    for (int c = 0; c < a.result->ncontacts; c++) {
        const struct thud_contact_result *i = &a.result->contact[c], *j = &b.result->contact[c];
        ck_assert_int_eq(i->impacts, j->impacts);
        ck_assert_double_eq_tol(i->impulse_ns, j->impulse_ns, 1e-10 * j->impulse_ns + 1e-9);
    }
    ck_assert_int_eq(in_contact, a.result->work.force_evaluations > 0);
    for (int s = 0; s < a.result->nstructures; s++)
        for (int i = 0; i < a.result->structure[s].floors; i++) {
            const struct thud_floor_result *p = &a.result->structure[s].floor[i], *q = &b.result->structure[s].floor[i];
            ck_assert_double_eq_tol(p->velocity.value / q->velocity.value, 1, 1e-10);
            ck_assert_double_eq_tol(p->acceleration.time_s, q->acceleration.time_s, 1e-5);
        }
    march_free(&a);
    march_free(&b);
}

/* Isolated buildings in a row, apart and pounding, with ground motions of long intervals too: 2 rad and 4 rad of the
 * fastest mode. */
START_TEST(propagator_against_series)
{
    const int storeys[] = {4, 2, 7};
    const bool in_contact = _i % 2;
    struct march_law law = march_law("kelvin-voigt-no-tension", "stiffness", 2.5e9, "restitution", 0.6, NULL);
    struct thud_record *record = march_motion(1), *coarse;
    struct thud_model *model = march_row(3, storeys, true, in_contact ? 0.005 : 2, &law);
    ck_assert_int_eq(thud_record_create(record->a_mps2, record->samples, _i < 2 ? 0.02 : 0.04, &coarse, NULL), THUD_OK);
    compare_ways(model, coarse, in_contact);
    thud_model_free(model);
    thud_record_free(coarse);
    thud_record_free(record);
}
END_TEST

/* The same with storeys that yield: a plastic drift is a constant force, about which the coupled modes swing. */
START_TEST(propagator_with_plastic_drifts)
{
    const double mass[] = {320e3, 320e3, 320e3, 250e3}, stiffness[] = {12e6, 6e8, 4e8, 3e8},
                 yield[] = {INFINITY, 1e-3, 1.5e-3, 2e-3}, hardening[] = {1, 0.1, 0.05, 0.1};
    struct thud_structure_input building = {.n = 4,
                                            .mass_kg = mass,
                                            .stiffness_npm = stiffness,
                                            .damping = 0.05,
                                            .isolated = true,
                                            .isolation_damping = 0.1,
                                            .yield_m = yield,
                                            .hardening = hardening};
    struct thud_model *model;
    struct thud_record *record = march_motion(2);
    ck_assert_int_eq(
        thud_model_create(&(struct thud_model_input){.nstructures = 1, .structure = &building}, &model, NULL), THUD_OK);
    struct march a = way(model, record, true), b = way(model, record, false);
    ck_assert_int_gt(a.result->work.samples_fast, 100);
    ck_assert_int_gt(a.result->structure[0].storey[1].excursions, 2);
    ck_assert_int_eq(a.result->structure[0].storey[1].excursions, b.result->structure[0].storey[1].excursions);
    ck_assert_double_gt(fabs(a.result->structure[0].storey[1].plastic_m), 1e-5);
    ck_assert_double_lt(march_peaks_apart(a.result, b.result, 0.01), 1e-9);
    ck_assert_double_eq_tol(a.result->energy.viscous_j / b.result->energy.viscous_j, 1, 1e-10);
    ck_assert_double_lt(a.result->energy.error_ratio, 1e-12);
    march_free(&a);
    march_free(&b);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("coupled");
    TCase *tcase = tcase_create("coupled damping");
    tcase_set_timeout(tcase, 60);
    tcase_add_loop_test(tcase, no_derivative_passes_its_bound, 0, SLABS);
    tcase_add_loop_test(tcase, against_the_exponential, 0, SLABS);
    tcase_add_loop_test(tcase, against_dormand_prince, 0, SLABS);
    tcase_add_test(tcase, a_light_slab_that_strikes);
    tcase_add_loop_test(tcase, series_hold_the_equation_order_by_order, 0, 12);
    tcase_add_loop_test(tcase, propagator_against_series, 0, 4);
    tcase_add_test(tcase, propagator_with_plastic_drifts);
    suite_add_tcase(suite, tcase);
    return suite;
}
