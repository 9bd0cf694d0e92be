/* Peaks against a dense sampling of all that a run shows to its observers: no sample may lie above its peak, and a peak
 * no further above the samples than a value moves between two of them. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "core/motion/free_vibration.h"
#include "core/numerics/poly.h"
#include "core/run/run_private.h"
#include "march.h"
#include "scenes.h"

enum { SAMPLES = 24 };

/* An observer: the largest samples. */
struct sampled {
    const struct thud_model *model;
    double *floor;       /* (quantities x ndof) */
    double *force;       /* (ncontacts) */
    double *indentation; /* (ncontacts) */
    double *q, *qd, *qdd;
};

static void raise(double *most, double value)
{
    *most = fmax(*most, fabs(value));
}

static void sample_floors(const struct sampled *x, const double *q, const double *qd, const double *qdd)
{
    const struct thud_model *m = x->model;
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        double below = 0;
        for (int i = 0; i < p->n; i++) {
            double value[THUD_FLOOR_QUANTITIES] = {0}, *most = x->floor + p->first + i;
            for (int j = 0; j < p->modes; j++) {
                const double shape = p->phi[i * p->modes + j];
                value[THUD_FLOOR_DISPLACEMENT] += shape * q[p->first_mode + j];
                value[THUD_FLOOR_VELOCITY] += shape * qd[p->first_mode + j];
                value[THUD_FLOOR_ACCELERATION] += shape * qdd[p->first_mode + j];
            }
            value[THUD_FLOOR_DRIFT] = p->stiffness_npm ? value[THUD_FLOOR_DISPLACEMENT] - below : 0;
            below = value[THUD_FLOOR_DISPLACEMENT];
            for (int quantity = 0; quantity < THUD_FLOOR_QUANTITIES; quantity++)
                raise(&most[quantity * m->ndof], value[quantity]);
        }
    }
}

/* Total accelerations by the equations of motion. */
static void sample_at(const struct sampled *x, const struct thud_segment *seg, double s)
{
    const struct thud_model *m = x->model;
    double *force = calloc((size_t)m->nrows + 1, sizeof *force);
    thud_segment_state(seg, m->nmodes, s, x->q, x->qd);
    for (int k = seg->terms - 1; k >= 0; k--)
        for (int c = 0; c < m->nrows; c++)
            force[c] = force[c] * s + seg->force[k * m->nrows + c];
    thud_model_acceleration(m, x->q, x->qd, 0, x->qdd);
    thud_model_apply_contact_forces(m, force, x->qdd);
    sample_floors(x, x->q, x->qd, x->qdd);
    free(force);
}

static void sample_contacts(const struct sampled *x, const struct thud_state *state, const struct thud_segment *seg,
                            double s)
{
    for (int c = 0; c < x->model->ncontacts; c++) {
        if (!thud_contact_acts(&state->contact[c]))
            continue;
        double force = 0;
        for (int k = seg->terms - 1; k >= 0; k--)
            force = force * s + seg->force[k * x->model->nrows + c];
        raise(&x->force[c], force);
        raise(&x->indentation[c], fmax(0, thud_model_gap_sum(x->model, c, x->q) - thud_state_clearance(state, c)));
    }
}

static enum thud_status sample_segment(void *own, const struct thud_observation *o, struct thud_error *err)
{
    (void)err;
    for (int i = 0; i <= SAMPLES; i++) {
        sample_at(own, o->seg, o->s * i / SAMPLES);
        sample_contacts(own, o->state, o->seg, o->s * i / SAMPLES);
    }
    return THUD_OK;
}

static enum thud_status sample_block(void *own, const struct thud_state *state, struct thud_free_vibration *block,
                                     int intervals, struct thud_error *err)
{
    (void)err;
    for (int t = 0; t < intervals; t++)
        for (int piece = 0; piece < block->pieces; piece++)
            for (int i = 0; i <= SAMPLES; i++)
                sample_at(own, thud_free_vibration_all_series(block, state, t, piece), (double)i / SAMPLES);
    return THUD_OK;
}

static const struct thud_observer sampling = {.segment = sample_segment, .block = sample_block};

/* Whether peak and samples are the same but for what lies between two samples, and for the terms that a series leaves out:
 * they are read as derivatives of it, and by the equations of motion. */
static void check(const char *what, int place, double peak, double most, double scale, double tolerance)
{
    ck_assert_msg(peak >= most - (1e-11 + 1e-4 * tolerance) * scale, "%s %d: a sample %.3e of the scale above the peak",
                  what, place, (most - peak) / scale);
    ck_assert_msg(peak <= most + 2e-3 * scale, "%s %d: the peak %.3e of the scale above the samples", what, place,
                  (peak - most) / scale);
}

static double largest(const double *x, int n)
{
    double most = 1e-300;
    for (int i = 0; i < n; i++)
        most = fmax(most, x[i]);
    return most;
}

static void compare(const struct sampled *x, struct thud_run *run, double tolerance)
{
    static const char *const name[] = {"displacement", "velocity", "acceleration", "drift"};
    const struct thud_model *m = x->model;
    for (int quantity = 0; quantity < THUD_FLOOR_QUANTITIES; quantity++) {
        const double *most = x->floor + quantity * m->ndof;
        for (int i = 0; i < m->ndof; i++) {
            const int s = m->dof_structure[i];
            check(name[quantity], i, thud_floor_peak(&run->result, s, i - m->structure[s].first, quantity)->value,
                  most[i], largest(most, m->ndof), tolerance);
        }
    }
    for (int c = 0; c < m->ncontacts; c++) {
        check("force", c, run->result.contact[c].force.value, x->force[c], largest(x->force, m->ncontacts), tolerance);
        check("indentation", c, run->result.contact[c].indentation.value, x->indentation[c], largest(x->floor, m->ndof),
              tolerance); /* that of displacements: it is read from their difference */
    }
}

/* Runs the model, and compares. Returns how many blows there were. */
static int run_and_compare(const struct thud_model *model, const struct thud_record *record, const char *method,
                           double tolerance)
{
    struct thud_run_options options;
    struct thud_run *run = NULL;
    bool done = false;
    int impacts = 0;
    thud_run_options_init(&options);
    options.method = thud_method_find(method);
    options.tolerance = tolerance;
    options.tail_s = 2;
    ck_assert_int_eq(thud_run_create(model, record, &options, &run, NULL), THUD_OK);
    const size_t n = (size_t)model->nmodes, floors = (size_t)model->ndof, contacts = (size_t)model->ncontacts;
    double *block = calloc(THUD_FLOOR_QUANTITIES * floors + 2 * contacts + 3 * n, sizeof *block);
    struct sampled x = {.model = model, .floor = block};
    x.force = block + THUD_FLOOR_QUANTITIES * floors;
    x.indentation = x.force + contacts;
    x.q = x.indentation + contacts;
    x.qd = x.q + n;
    x.qdd = x.qd + n;
    thud_run_observe(run, &sampling, &x);
    while (!done)
        ck_assert_int_eq(thud_run_advance(run, 1000, &done, NULL), THUD_OK);
    compare(&x, run, tolerance);
    for (int c = 0; c < model->ncontacts; c++)
        impacts += run->result.contact[c].impacts;
    free(block);
    thud_run_free(run);
    return impacts;
}

static struct march_law rubber(void)
{
    return march_law("rubber", "stiffness", 0.36e3 * pow(1000, 2.65), "thickness", 0.05, NULL);
}

/* Buildings of one storey to many; the gap closes often, seldom, never. */
START_TEST(buildings_with_rubber)
{
    static const int rows[][2] = {{4, 6}, {1, 2}, {5, 3}, {20, 12}};
    const struct march_law law = rubber();
    struct thud_record *record = march_motion(1);
    int impacts = 0;
    for (int i = 0; i < 4; i++)
        for (double gap = 0; gap < 1; gap = gap == 0 ? 0.05 : 4 * gap) {
            struct thud_model *model = march_row(2, rows[i], false, gap, &law);
            impacts += run_and_compare(model, record, "exact", i % 2 ? 1e-6 : 1e-3);
            thud_model_free(model);
        }
    ck_assert_int_gt(impacts, 20);
    thud_record_free(record);
}
END_TEST

START_TEST(a_history_changes_no_bit_of_the_peaks)
{
    static const int row[] = {4, 6};
    const struct march_law law = rubber();
    struct thud_record *record = march_motion(1);
    for (double gap = 0.1; gap < 10; gap *= 50) {
        struct thud_model *model = march_row(2, row, false, gap, &law);
        struct thud_run *run[2];
        for (int i = 0; i < 2; i++) {
            struct thud_run_options options;
            bool done = false;
            thud_run_options_init(&options);
            options.keep_history = i == 0;
            ck_assert_int_eq(thud_run_create(model, record, &options, &run[i], NULL), THUD_OK);
            while (!done)
                ck_assert_int_eq(thud_run_advance(run[i], 10, &done, NULL), THUD_OK);
        }
        for (int s = 0; s < 2; s++)
            for (int i = 0; i < row[s]; i++)
                for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++) {
                    const struct thud_peak *a = thud_floor_peak(&run[0]->result, s, i, x),
                                           *b = thud_floor_peak(&run[1]->result, s, i, x);
                    ck_assert_double_eq(a->value, b->value);
                    ck_assert_double_eq(a->time_s, b->time_s);
                }
        thud_run_free(run[0]);
        thud_run_free(run[1]);
        thud_model_free(model);
    }
    thud_record_free(record);
}
END_TEST

/* Dampers that couple the modes. */
START_TEST(isolated_buildings)
{
    static const int row[] = {3, 5};
    const struct march_law law = rubber();
    struct thud_record *record = march_motion(1);
    int impacts = 0;
    for (double gap = 1e-3; gap < 1; gap *= 10) {
        struct thud_model *model = march_row(2, row, true, gap, &law);
        impacts += run_and_compare(model, record, "exact", 1e-6);
        thud_model_free(model);
    }
    ck_assert_int_gt(impacts, 0);
    thud_record_free(record);
}
END_TEST

/* Methods whose steps do not keep to the equations of motion, but are read inside. */
START_TEST(stepping_methods)
{
    static const int row[] = {3, 4};
    static const char *const method[] = {"rk4", "dormand-prince"};
    const struct march_law law = march_law("kelvin-voigt-no-tension", "stiffness", 2e9, "restitution", 0.6, NULL);
    struct thud_record *record = march_motion(1);
    for (int i = 0; i < 2; i++) {
        struct thud_model *model = march_row(2, row, false, 0.05, &law);
        ck_assert_int_gt(run_and_compare(model, record, method[i], 1e-6), 0);
        thud_model_free(model);
    }
    thud_record_free(record);
}
END_TEST

/* A motion that ends with a jump: the largest velocity comes after it, and falls up to it. */
START_TEST(a_motion_that_ends_with_a_jump)
{
    static const double samples[] = {0.4053597618231075, -0.5974876657229524, 2.598552175178571};
    static const int row[] = {2, 1};
    const struct march_law law = rubber();
    struct thud_record *record = NULL;
    ck_assert_int_eq(thud_record_create(samples, 3, sqrt(50.0 / 600.0) / 10, &record, NULL), THUD_OK);
    struct thud_model *model = march_row(2, row, false, 5, &law);
    ck_assert_int_eq(run_and_compare(model, record, "exact", 1e-6), 0);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* Any law, walls, rigid bodies, floors struck between two others, storeys that yield. */
START_TEST(random_scenes)
{
    static const unsigned long long from[] = {0, SCENES_YIELDING, SCENES_COLUMNS};
    int impacts = 0;
    for (int i = 0; i < 36; i++) {
        struct scenes_one one;
        struct thud_model *model = NULL;
        scenes_draw(&one, from[i % 3] + 100 + (unsigned long long)i);
        ck_assert_int_eq(thud_scene_assemble(&one.scene, &model, NULL), THUD_OK);
        impacts += run_and_compare(model, one.record, "exact", 1e-6);
        thud_model_free(model);
        scenes_clear(&one);
    }
    ck_assert_int_gt(impacts, 20);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("peaks");
    TCase *tc = tcase_create("peaks");
    tcase_set_timeout(tc, 60);
    tcase_add_test(tc, buildings_with_rubber);
    tcase_add_test(tc, a_history_changes_no_bit_of_the_peaks);
    tcase_add_test(tc, isolated_buildings);
    tcase_add_test(tc, stepping_methods);
    tcase_add_test(tc, a_motion_that_ends_with_a_jump);
    tcase_add_test(tc, random_scenes);
    suite_add_tcase(suite, tc);
    return suite;
}
