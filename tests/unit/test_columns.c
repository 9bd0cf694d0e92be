/* Slabs against columns: the struck point, its give in series with the law, what the columns bear, and the limits in
 * which a slab meets a floor or the ground. Held against a frame of beam elements solved here, an integration written
 * here, and closed forms. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/run/baseline.h"
#include "core/run/run_private.h"
#include "march.h"
#include "suite.h"

/* ---- two buildings and one slab ---- */

enum { FLOORS = 2 };

/* On the left one mass, free or on a storey; on the right two floors, whose upper storey is struck. */
struct setting {
    double left_kg, left_npm, left_damping, left_mps;
    double kg[FLOORS], npm[FLOORS], damping;
    double a_m, b_m, ei_nm2, capacity_n, gap_m;
    bool hinged, lower; /* lower: the first storey is struck */
    struct march_law law;
};

static struct setting usual(struct march_law law)
{
    return (struct setting){.left_kg = 200e3,
                            .left_mps = 0.6,
                            .kg = {320e3, 250e3},
                            .npm = {600e6, 400e6},
                            .a_m = 1.2,
                            .b_m = 1.8,
                            .ei_nm2 = 120e6,
                            .capacity_n = 2e6,
                            .law = law};
}

/* contact: 1 floor to floor with the floor above, -1 with a wall in place of the columns, 0 the columns. */
static struct thud_model *model_of(const struct setting *x, int contact, bool mirrored)
{
    struct thud_structure_input one = {.n = 1,
                                       .mass_kg = &x->left_kg,
                                       .damping = x->left_damping,
                                       .velocity_mps = mirrored ? -x->left_mps : x->left_mps},
                                other = {.n = FLOORS, .mass_kg = x->kg, .stiffness_npm = x->npm, .damping = x->damping},
                                wall = {.n = 0};
    one.stiffness_npm = x->left_npm > 0 ? &x->left_npm : NULL;
    struct thud_structure_input s[2] = {mirrored ? other : one, mirrored ? one : other};
    if (contact < 0)
        s[mirrored ? 0 : 1] = wall;
    int floor = contact < 0 ? 0 : x->lower ? 1 : 2;
    struct thud_contact_input c = {.interface = 1,
                                   .left_floor = mirrored ? floor : 1,
                                   .right_floor = mirrored ? 1 : floor,
                                   .right_structure = 1,
                                   .clearance_m = x->gap_m,
                                   .law = x->law.law,
                                   .setup = x->law.setup};
    if (contact == 0)
        c.struck = (struct thud_struck_input){mirrored ? -1 : 1, x->a_m, x->b_m, x->hinged, x->ei_nm2, x->capacity_n};
    struct thud_model *model = NULL;
    struct thud_error err = {0};
    enum thud_status status = thud_model_create(
        &(struct thud_model_input){.nstructures = 2, .structure = s, .ncontacts = 1, .contact = &c}, &model, &err);
    ck_assert_msg(status == THUD_OK, "%s", err.what);
    return model;
}

static double law_value(const struct march_law *law, const char *name)
{
    return law->setup.value[thud_law_param(law->law, name)];
}

/* ---- the laws with a spring in series ---- */

/* F = K (d - F/k)^p by bisection. */
static double series(double K, double p, double k, double d)
{
    double low = 0, high = fmin(k * d, K * pow(d, p));
    for (int i = 0; i < 200; i++) {
        double mid = 0.5 * (low + high);
        if (mid < K * pow(fmax(d - mid / k, 0), p))
            low = mid;
        else
            high = mid;
    }
    return 0.5 * (low + high);
}

static struct march_law nonlinear(int i)
{
    switch (i) {
    case 0:
        return march_law("hertz", NULL);
    case 1:
        return march_law("hertz-damp", "formula", 3.0, "restitution", 0.6, NULL);
    case 2:
        return march_law("jankowski", "damping", 1.0, "restitution", 0.65, NULL);
    case 3:
        return march_law("jankowski", "exponent", 1.0, "stiffness", 2.5e9, "damping", 1.0, "restitution", 0.65, NULL);
    case 4:
        return march_law("hertz-damp", "exponent", 1.0, "stiffness", 2.5e9, "formula", 3.0, NULL);
    default:
        return march_law("rubber", "thickness", 0.05, "stiffness", 0.36e3 * pow(1000.0, 2.65), "damping", 1.0,
                         "unloading", 1.0, NULL);
    }
}
enum { NONLINEAR = 6 };

/* The elastic curve solves its equation; the derivatives are those of the force; the energy is what lies under it. */
START_TEST(series_of_a_nonlinear_law)
{
    struct march_law law = nonlinear(_i);
    struct thud_law_memory memory;
    law.setup.mass_kg = 160e3;
    law.setup.column_npm = 3e8;
    ck_assert_int_eq(thud_law_prepare(law.law, &law.setup, NULL), THUD_OK);
    thud_law_onset(law.law, &law.setup, 0.7, &memory);
    int exponent = thud_law_param(law.law, "exponent");
    double K = law_value(&law, "stiffness"), p = exponent < 0 ? 1.5 : law.setup.value[exponent], energy = 0, last = 0;
    double ultimate = thud_law_ultimate(law.law, &law.setup, &memory, THUD_APPROACH);
    for (int i = 1; i <= 400; i++) {
        double d = i * 1e-4, v = 0.3, fd, fv;
        struct thud_branch b = thud_law_branch_at(law.law, &law.setup, &memory, THUD_APPROACH, d);
        double elastic = thud_branch_force(&b, d, 0, NULL, NULL);
        if (d < ultimate)
            ck_assert_msg(fabs(elastic / series(K, p, 3e8, d) - 1) < 1e-12, "at %g m: %g", d,
                          elastic / series(K, p, 3e8, d) - 1);
        double force = thud_branch_force(&b, d, v, &fd, &fv), h = 1e-6 * d;
        ck_assert_double_eq_tol(
            (thud_branch_force(&b, d + h, v, NULL, NULL) - thud_branch_force(&b, d - h, v, NULL, NULL)) / (2 * h) / fd,
            1, 1e-7);
        ck_assert_double_eq_tol((force - elastic) / fmax(fv * v, 1), force > elastic ? 1 : 0, 1e-7);
        /* Simpson's rule over the last piece */
        double middle = d - 5e-5;
        b = thud_law_branch_at(law.law, &law.setup, &memory, THUD_APPROACH, middle);
        energy += 1e-4 / 6 * (last + 4 * thud_branch_force(&b, middle, 0, NULL, NULL) + elastic);
        last = elastic;
        if (i > 40)
            ck_assert_double_eq_tol(thud_law_energy(law.law, &law.setup, &memory, THUD_APPROACH, d) / energy, 1, 2e-5);
    }
    /* very stiff columns are none */
    struct thud_branch bare = law.law->branch(&law.setup, &memory, THUD_APPROACH, false);
    law.setup.column_npm = 1e18;
    struct thud_branch stiff = thud_law_branch(law.law, &law.setup, &memory, THUD_APPROACH, false);
    ck_assert_double_eq_tol(
        thud_branch_force(&stiff, 0.01, 0.2, NULL, NULL) / thud_branch_force(&bare, 0.01, 0.2, NULL, NULL), 1, 1e-7);
}
END_TEST

/* Bodies part with the restitution asked for, whatever gives in series. */
START_TEST(restitution_with_columns)
{
    static const double asked[NONLINEAR + 1] = {1, 0.6, 0.65, 0.65, 0.6, 0.5, 0.6};
    struct march_law law =
        _i < NONLINEAR ? nonlinear(_i) : march_law("kelvin-voigt-no-tension", "damping", 1.0, "restitution", 0.6, NULL);
    struct setting x = usual(law);
    x.npm[0] = x.npm[1] = 1e-3; /* free */
    x.a_m = x.b_m = 1.5;
    struct thud_model *model = model_of(&x, 0, false);
    ck_assert_double_eq_tol(model->contact[0].setup.column_npm / (192 * x.ei_nm2 / 27), 1, 1e-12);
    ck_assert_double_eq_tol(model->contact[0].setup.mass_kg * (1 / x.left_kg + 0.25 / x.kg[0] + 0.25 / x.kg[1]), 1,
                            1e-12);
    struct march m = march_run(model, NULL, "exact", 0, 1e-9, true, 1.5);
    ck_assert_int_eq(m.status, THUD_OK);
    ck_assert_int_eq(m.result->contact[0].impacts, 1);
    ck_assert_double_eq_tol(m.result->contact[0].restitution, asked[_i], 2e-6);
    ck_assert_double_lt(m.result->energy.error_ratio, 1e-7);
    march_free(&m);
    thud_model_free(model);
}
END_TEST

START_TEST(linear_laws_in_series)
{
    static const char *const names[] = {"linear", "kelvin-voigt", "kelvin-voigt-no-tension"};
    struct setting x = usual(march_law(names[_i], "stiffness", 2.5e9, NULL));
    struct thud_model *model = model_of(&x, 0, false);
    double a = x.a_m, b = x.b_m, length = a + b, column = 3 * x.ei_nm2 * pow(length / (a * b), 3),
           k = 2.5e9 * column / (2.5e9 + column);
    const struct thud_model_contact *c = &model->contact[0];
    struct thud_law_memory memory = {0};
    struct thud_branch branch = thud_law_branch(c->law, &c->setup, &memory, THUD_APPROACH, false);
    ck_assert_double_eq_tol(branch.k_npm / k, 1, 1e-14);
    /* until the force of a collision with damping ratio xi is 0: 2 acos(xi)/omega_d */
    x.npm[0] = x.npm[1] = 1e-3;
    thud_model_free(model);
    model = model_of(&x, 0, false);
    if (_i < 2) {
        double xi = _i == 0 ? 0 : -log(0.6) / sqrt(THUD_PI * THUD_PI + log(0.6) * log(0.6));
        struct march m = march_run(model, NULL, "exact", 0, 1e-9, true, 1.5);
        double omega = sqrt(k / model->contact[0].setup.mass_kg);
        ck_assert_double_eq_tol(m.result->contact[0].contact_time_s * omega * sqrt(1 - xi * xi) / (2 * acos(xi)), 1,
                                1e-9);
        march_free(&m);
    }
    thud_model_free(model);
}
END_TEST

START_TEST(impulses_need_columns_that_do_not_give)
{
    struct setting x = usual(march_law("stereomechanical", "restitution", 0.7, NULL));
    struct thud_error err = {0};
    struct thud_law_setup setup = x.law.setup;
    setup.column_npm = 1e8;
    ck_assert_int_eq(thud_law_prepare(x.law.law, &setup, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, "law");
    /* stiff ones take their parts of the impulse: momentum of each mass, and Newton's law at the struck place */
    x.ei_nm2 = NAN;
    x.npm[0] = x.npm[1] = 1e-3;
    struct thud_model *model = model_of(&x, 0, false);
    struct march m = march_run(model, NULL, "exact", 0, 0, true, 0.5);
    ck_assert_int_eq(m.status, THUD_OK);
    double eta = 1.2 / 3, h = 3 * eta * eta - 2 * eta * eta * eta, impulse = m.result->contact[0].impulse_ns;
    double striker = march_velocity(&m, 0), lower = march_velocity(&m, 1), upper = march_velocity(&m, 2);
    ck_assert_double_eq_tol(x.left_kg * (x.left_mps - striker) / impulse, 1, 1e-12);
    ck_assert_double_eq_tol(x.kg[0] * lower / ((1 - h) * impulse), 1, 1e-8); /* the storeys hardly pull */
    ck_assert_double_eq_tol(x.kg[1] * upper / (h * impulse), 1, 1e-8);
    ck_assert_double_eq_tol(((1 - h) * lower + h * upper - striker) / x.left_mps, 0.7, 1e-8);
    march_free(&m);
    thud_model_free(model);
}
END_TEST

/* ---- statics: a frame with the struck columns as beam elements ---- */

/* A x = b in place by elimination with pivots. */
static void solve(int n, double a[][8], double *b)
{
    for (int i = 0; i < n; i++) {
        int p = i;
        for (int r = i; r < n; r++)
            p = fabs(a[r][i]) > fabs(a[p][i]) ? r : p;
        for (int k = 0; k < n; k++) {
            double t = a[i][k];
            a[i][k] = a[p][k];
            a[p][k] = t;
        }
        double t = b[i];
        b[i] = b[p];
        b[p] = t;
        for (int r = i + 1; r < n; r++) {
            double f = a[r][i] / a[i][i];
            for (int k = i; k < n; k++)
                a[r][k] -= f * a[i][k];
            b[r] -= f * b[i];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++)
            b[i] -= a[i][k] * b[k];
        b[i] /= a[i][i];
    }
}

/* End forces of an Euler-Bernoulli element from its four displacements: deflection and rotation at its lower and upper
 * end. */
static void beam(double ei, double l, double e[4][4])
{
    double k[4][4] = {{12, 6 * l, -12, 6 * l},
                      {6 * l, 4 * l * l, -6 * l, 2 * l * l},
                      {-12, -6 * l, 12, -6 * l},
                      {6 * l, 2 * l * l, -6 * l, 4 * l * l}};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            e[i][j] = k[i][j] * ei / (l * l * l);
}

/* A push that stays: the program's forces and displacements are those of the frame, and so are shears and moments at
 * the ends of the struck columns. */
START_TEST(a_push_that_stays)
{
    enum { U0, U1, U2, W, TURN, UNKNOWNS };
    const double k = 2.5e9, ground = -2;
    struct setting x = usual(march_law("linear", "stiffness", k, NULL));
    x.left_mps = 0;
    x.left_npm = 20e6;
    x.left_damping = x.damping = 0.95;
    x.gap_m = 0.004;
    x.lower = _i == 1;
    bool mirrored = _i == 2;
    struct thud_model *model = model_of(&x, 0, mirrored);
    double a[8][8] = {{0}}, b[8] = {0}, low[4][4], high[4][4], length = x.a_m + x.b_m;
    int storey = x.lower ? 0 : 1, at[2][4] = {{x.lower ? -1 : U1, -1, W, TURN}, {W, TURN, x.lower ? U1 : U2, -1}};
    beam(x.ei_nm2, x.a_m, low);
    beam(x.ei_nm2, x.b_m, high);
    for (int part = 0; part < 2; part++)
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++)
                if (at[part][i] >= 0 && at[part][j] >= 0)
                    a[at[part][i]][at[part][j]] += part == 0 ? low[i][j] : high[i][j];
    for (int i = 0; i < FLOORS; i++) { /* the rest of the storeys */
        double rest = x.npm[i] - (i == storey ? 12 * x.ei_nm2 / (length * length * length) : 0);
        a[U1 + i][U1 + i] += rest;
        if (i > 0) {
            a[U1 + i - 1][U1 + i - 1] += rest;
            a[U1 + i][U1 + i - 1] -= rest;
            a[U1 + i - 1][U1 + i] -= rest;
        }
        b[U1 + i] = -x.kg[i] * ground;
    }
    a[U0][U0] = x.left_npm + k;
    a[W][W] += k;
    a[U0][W] -= k;
    a[W][U0] -= k;
    b[U0] = -x.left_kg * ground + k * x.gap_m;
    b[W] = -k * x.gap_m;
    solve(UNKNOWNS, a, b);
    double force = k * (b[U0] - x.gap_m - b[W]);
    ck_assert_double_gt(force, 1e5);

    double push[4001];
    for (int i = 0; i <= 4000; i++)
        push[i] = mirrored ? -ground : ground;
    struct thud_record *record;
    ck_assert_int_eq(thud_record_create(push, 4001, 0.01, &record, NULL), THUD_OK);
    struct march m = march_run(model, record, "exact", 0, 1e-9, true, 0);
    ck_assert_int_eq(m.status, THUD_OK);
    double sign = mirrored ? -1 : 1;
    int left = mirrored ? 2 : 0, first = mirrored ? 0 : 1;
    ck_assert_double_eq_tol(sign * march_displacement(&m, left) / b[U0], 1, 1e-9);
    ck_assert_double_eq_tol(sign * march_displacement(&m, first) / b[U1], 1, 1e-9);
    ck_assert_double_eq_tol(sign * march_displacement(&m, first + 1) / b[U2], 1, 1e-9);
    /* forces on the columns by the floors they stand on and under: the internal ones at their ends */
    double u[2][4];
    for (int part = 0; part < 2; part++)
        for (int i = 0; i < 4; i++)
            u[part][i] = at[part][i] < 0 ? 0 : b[at[part][i]];
    double end[4] = {0};
    for (int j = 0; j < 4; j++) {
        end[THUD_COLUMN_SHEAR_LOWER] -= low[0][j] * u[0][j];
        end[THUD_COLUMN_SHEAR_UPPER] += high[2][j] * u[1][j];
        end[THUD_COLUMN_MOMENT_LOWER] -= low[1][j] * u[0][j];
        end[THUD_COLUMN_MOMENT_UPPER] += high[3][j] * u[1][j];
    }
    const struct thud_model_column *column = &model->column[0];
    double drift = march_displacement(&m, first + storey) - (storey > 0 ? march_displacement(&m, first) : 0);
    for (int q = 0; q < THUD_COLUMN_QUANTITIES; q++) {
        double value = column->per_drift[q] * drift + model->contact[0].per_force[q] * force;
        ck_assert_double_eq_tol(sign * value / end[q], 1, 1e-8);
        ck_assert_double_ge(m.result->column[0].peak[q].value, fabs(value) * (1 - 1e-8));
    }
    ck_assert_double_eq_tol((end[THUD_COLUMN_SHEAR_LOWER] - end[THUD_COLUMN_SHEAR_UPPER]) / force, 1, 1e-9);
    march_free(&m);
    thud_record_free(record);
    thud_model_free(model);
}
END_TEST

/* ---- motion: an integration of its own ---- */

struct masses {
    double u[3], v[3], damp;
};

struct facts {
    const struct setting *x;
    double h, column, K, s;
};

static double contact_force(const struct facts *f, const double *u, const double *v, double damp)
{
    double d = u[0] - (1 - f->h) * u[1] - f->h * u[2] - f->x->gap_m, rate = v[0] - (1 - f->h) * v[1] - f->h * v[2];
    return d > 0 ? fmax(series(f->K, 1.5, f->column, d) * (1 + damp * rate), 0) : 0;
}

static void slopes(const struct facts *f, const double *y, double damp, double *dy)
{
    const struct setting *x = f->x;
    double force = contact_force(f, y, y + 3, damp), lower = x->npm[0] * y[1], upper = x->npm[1] * (y[2] - y[1]);
    memcpy(dy, y + 3, 3 * sizeof *dy);
    dy[3] = -force / x->left_kg;
    dy[4] = (-lower + upper + (1 - f->h) * force) / x->kg[0];
    dy[5] = (-upper + f->h * force) / x->kg[1];
}

/* Runge-Kutta of order 4 with a small step, the damping set anew at each touch. */
START_TEST(against_an_integration_of_its_own)
{
    struct setting x = usual(march_law("hertz-damp", "formula", 1.0, "restitution", 0.6, NULL));
    x.hinged = _i == 1;
    double eta = x.a_m / (x.a_m + x.b_m), a = x.a_m, b = x.b_m, length = a + b, end = 0.25, step = 5e-6;
    struct facts f = {&x, x.hinged ? eta : 3 * eta * eta - 2 * eta * eta * eta,
                      x.hinged ? 3 * x.ei_nm2 * length / (a * a * b * b) : 3 * x.ei_nm2 * pow(length / (a * b), 3),
                      law_value(&x.law, "stiffness"), 1.5 * (1 - 0.6)};
    double y[6] = {0, 0, 0, x.left_mps, 0, 0}, damp = f.s / x.left_mps, most = 0, shear = 0,
           stiffness = 12 * x.ei_nm2 / (length * length * length);
    for (long i = 0; i < lround(end / step); i++) {
        double k[4][6], z[6], before = y[0] - (1 - f.h) * y[1] - f.h * y[2];
        slopes(&f, y, damp, k[0]);
        for (int s = 1; s < 4; s++) {
            for (int j = 0; j < 6; j++)
                z[j] = y[j] + step * (s == 3 ? 1 : 0.5) * k[s - 1][j];
            slopes(&f, z, damp, k[s]);
        }
        for (int j = 0; j < 6; j++)
            y[j] += step / 6 * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]);
        if (before < 0 && y[0] - (1 - f.h) * y[1] - f.h * y[2] >= 0)
            damp = f.s / (y[3] - (1 - f.h) * y[4] - f.h * y[5]);
        double force = contact_force(&f, y, y + 3, damp);
        most = fmax(most, force);
        shear = fmax(shear, fabs(stiffness * (y[2] - y[1]) + (1 - f.h) * force));
    }
    struct thud_model *model = model_of(&x, 0, false);
    struct march m = march_run(model, NULL, "exact", 0, 1e-10, true, end);
    ck_assert_int_eq(m.status, THUD_OK);
    ck_assert_int_ge(m.result->contact[0].impacts, 1);
    ck_assert_double_eq_tol(m.result->contact[0].force.value / most, 1, 1e-7);
    ck_assert_double_eq_tol(m.result->column[0].peak[THUD_COLUMN_SHEAR_LOWER].value / shear, 1, 1e-7);
    for (int i = 0; i < 3; i++)
        ck_assert_double_eq_tol(march_displacement(&m, i), y[i], 1e-7 * fabs(y[0]));
    march_free(&m);
    thud_model_free(model);
}
END_TEST

/* ---- limits, mirror, methods ---- */

static double peaks_of(const struct setting *x, int contact, bool mirrored, double *out)
{
    struct thud_model *model = model_of(x, contact, mirrored);
    struct thud_record *record = march_motion(0.5);
    if (mirrored) {
        double *a = malloc(record->samples * sizeof *a);
        for (size_t i = 0; i < record->samples; i++)
            a[i] = -record->a_mps2[i];
        struct thud_record *other;
        ck_assert_int_eq(thud_record_create(a, record->samples, record->dt_s, &other, NULL), THUD_OK);
        thud_record_free(record);
        record = other;
        free(a);
    }
    struct march m = march_run(model, record, "exact", 0, 1e-10, true, 1);
    ck_assert_int_eq(m.status, THUD_OK);
    const struct thud_structure_result *left = &m.result->structure[mirrored];
    out[0] = left->floor[0].displacement.value;
    out[1] = left->floor[0].acceleration.value;
    out[2] = m.result->contact[0].force.value;
    out[3] = m.result->contact[0].indentation.value;
    double error = m.result->energy.error_ratio;
    march_free(&m);
    thud_record_free(record);
    thud_model_free(model);
    return error;
}

static struct setting shaken(void)
{
    struct setting x = usual(march_law("hertz-damp", "formula", 3.0, NULL));
    x.left_npm = 20e6;
    x.left_mps = 0;
    x.left_damping = x.damping = 0.05;
    x.gap_m = 0.01;
    return x;
}

/* The nearer the slab to a floor, the nearer the result to floor to floor: by the square of the distance. The same
 * for the ground, which is a wall. */
START_TEST(slab_at_the_floor_or_the_ground)
{
    struct setting x = shaken();
    double limit[4], near[4], apart[2];
    bool ground = _i == 1;
    x.lower = ground;
    peaks_of(&x, ground ? -1 : 1, false, limit);
    for (int i = 0; i < 2; i++) {
        double small = i == 0 ? 1e-3 : 1e-4;
        x.a_m = ground ? small : 3 - small;
        x.b_m = 3 - x.a_m;
        peaks_of(&x, 0, false, near);
        apart[i] = 0;
        for (int k = 0; k < 4; k++)
            apart[i] = fmax(apart[i], fabs(near[k] / limit[k] - 1));
    }
    ck_assert_double_lt(apart[0], 1e-4);
    ck_assert_double_lt(apart[1], 3e-6);
    ck_assert_double_lt(apart[1], 0.05 * apart[0] + 1e-8);
}
END_TEST

START_TEST(mirrored)
{
    struct setting x = shaken();
    double one[4], other[4];
    x.hinged = _i == 1;
    double error = peaks_of(&x, 0, false, one);
    ck_assert_double_lt(error, 1e-9);
    peaks_of(&x, 0, true, other);
    for (int k = 0; k < 4; k++)
        ck_assert_double_eq_tol(other[k] / one[k], 1, 1e-12);
}
END_TEST

/* What the columns bear is the same by the exact method, whose peaks come from blocks of free vibration too, by
 * Dormand and Prince's steps with located events, and in a run that goes on from the motion without contact. */
START_TEST(columns_by_every_way)
{
    static const char *const laws[] = {"linear", "kelvin-voigt-no-tension", "hertz-damp", "jankowski", "rubber"};
    struct setting x = shaken();
    x.law = _i == 4 ? nonlinear(5) : march_law(laws[_i], NULL);
    x.gap_m = 0.015;
    struct thud_model *model = model_of(&x, 0, false);
    struct thud_record *record = march_motion(0.6);
    struct march exact = march_run(model, record, "exact", 0, 1e-10, true, 1),
                 steps = march_run(model, record, "dormand-prince", 0, 1e-12, true, 1);
    ck_assert_int_eq(exact.status, THUD_OK);
    ck_assert_int_eq(steps.status, THUD_OK);
    ck_assert_int_gt(exact.result->contact[0].impacts, 0);
    ck_assert_double_lt(exact.result->energy.error_ratio, 1e-9);
    struct thud_run_options options;
    thud_run_options_init(&options);
    options.tolerance = 1e-10;
    options.tail_s = 1;
    options.method = thud_method_find("exact");
    struct thud_baseline_motion *baseline;
    ck_assert_int_eq(thud_baseline_create(model, 0, record, &options, &baseline, NULL), THUD_OK);
    bool done = false;
    while (!done)
        ck_assert_int_eq(thud_baseline_advance(baseline, 10000, &done, NULL), THUD_OK);
    struct thud_run *run;
    double shared;
    ck_assert_int_eq(thud_baseline_run(baseline, model, record, &options, &run, &shared, NULL), THUD_OK);
    for (done = false; !done;)
        ck_assert_int_eq(thud_run_advance(run, 10000, &done, NULL), THUD_OK);
    const struct thud_column_result *c = &exact.result->column[0], *by_steps = &steps.result->column[0],
                                    *onward = &thud_run_result(run)->column[0];
    for (int q = 0; q < THUD_COLUMN_QUANTITIES; q++) {
        ck_assert_double_gt(c->peak[q].value, 0);
        ck_assert_double_eq_tol(by_steps->peak[q].value / c->peak[q].value, 1, 1e-8);
        ck_assert_double_eq_tol(onward->peak[q].value / c->peak[q].value, 1, 1e-10);
        ck_assert_double_eq_tol(onward->peak[q].time_s, c->peak[q].time_s, 1e-9);
    }
    ck_assert_double_eq_tol(c->ratio * x.capacity_n / fmax(c->peak[0].value, c->peak[1].value), 1, 1e-14);
    thud_run_free(run);
    thud_baseline_free(baseline);
    march_free(&exact);
    march_free(&steps);
    thud_record_free(record);
    thud_model_free(model);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("columns");
    TCase *laws = tcase_create("laws"), *runs = tcase_create("runs");
    tcase_add_loop_test(laws, series_of_a_nonlinear_law, 0, NONLINEAR);
    tcase_add_loop_test(laws, restitution_with_columns, 0, NONLINEAR + 1);
    tcase_add_loop_test(laws, linear_laws_in_series, 0, 3);
    tcase_add_test(laws, impulses_need_columns_that_do_not_give);
    tcase_add_loop_test(runs, a_push_that_stays, 0, 3);
    tcase_add_loop_test(runs, against_an_integration_of_its_own, 0, 2);
    tcase_add_loop_test(runs, slab_at_the_floor_or_the_ground, 0, 2);
    tcase_add_loop_test(runs, mirrored, 0, 2);
    tcase_add_loop_test(runs, columns_by_every_way, 0, 5);
    suite_add_tcase(suite, laws);
    suite_add_tcase(suite, runs);
    return suite;
}
