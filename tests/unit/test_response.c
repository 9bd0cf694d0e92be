/* Motion at the points of a step, read from tables: against the power series, piece by piece from kink to kink. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "core/motion/response.h"
#include "core/numerics/poly.h"
#include "core/numerics/radau.h"
#include "core/run/run_private.h"
#include "march.h"

enum { NODES = THUD_NODES, LEVELS = 6, CONTACTS_MAX = 8 };

static const int towers[] = {4, 6};

/* A step over several kinks of the ground motion, and the same points by series. */
struct fixture {
    struct thud_model *model;
    struct thud_record *record;
    struct march m;
    struct thud_responses *responses;
    double point[THUD_POINTS], h_top;
    int contact[CONTACTS_MAX], n;
    const struct thud_response *response[CONTACTS_MAX * CONTACTS_MAX];
};

static void set_up(struct fixture *f, bool isolated)
{
    struct march_law law = march_law("rubber", "stiffness", 0.36e3 * pow(1000, 2.65), "thickness", 0.05, NULL);
    double lagrange[NODES * NODES];
    *f = (struct fixture){.model = march_row(2, towers, isolated, 0.1, &law), .record = march_motion(1.5)};
    srand(3);
    for (size_t i = 0; i < f->record->samples; i++) /* every sample a kink */
        f->record->a_mps2[i] = 20.0 * rand() / RAND_MAX - 10;
    f->m = march_run(f->model, f->record, "exact", 0, 0, true, 0.01);
    struct thud_state *state = &f->m.run->state;
    for (int j = 0; j < f->model->nmodes; j++) {
        state->q[j] = 20.0 * rand() / RAND_MAX - 10;
        state->qd[j] = 200.0 * rand() / RAND_MAX - 100;
    }
    state->grid = 100;
    state->offset_s = 0.3 * state->grid_dt_s;
    f->h_top = 1.8 / f->model->fastest_radps;
    thud_radau_nodes(NODES, f->point);
    for (int i = NODES; i < THUD_POINTS; i++)
        f->point[i] = 0.17 * (i - NODES);
    thud_lagrange_coefficients(NODES, f->point, lagrange);
    ck_assert_int_eq(thud_responses_create(f->model, f->point, lagrange, f->h_top, 1e-10, &f->responses, NULL),
                     THUD_OK);
    f->n = f->model->ncontacts;
    for (int c = 0; c < f->n; c++)
        f->contact[c] = c;
}

static void tear_down(struct fixture *f)
{
    thud_responses_free(f->responses);
    march_free(&f->m);
    thud_model_free(f->model);
    thud_record_free(f->record);
}

/* The state `after_s` later, by one series for each interval of the ground motion. */
static void march_to(const struct thud_state *state, struct thud_segment *seg, double after_s, double *q, double *qd)
{
    int n = state->model->nmodes;
    long grid = state->grid;
    double offset = state->offset_s, left = after_s;
    for (int j = 0; j < n; j++) {
        q[j] = state->q[j];
        qd[j] = state->qd[j];
    }
    while (left > 0) {
        double h = fmin(left, state->grid_dt_s - offset);
        struct thud_state at = *state;
        at.grid = grid;
        at.offset_s = offset;
        thud_segment_begin(&at, seg, h);
        thud_taylor_given(state->model, seg, q, qd);
        thud_segment_state(seg, n, 1, q, qd);
        left -= h;
        offset = 0;
        grid++;
    }
}

START_TEST(a_step_across_kinks_is_the_steps_between_them)
{
    struct fixture f;
    double d[CONTACTS_MAX * THUD_POINTS], v[CONTACTS_MAX * THUD_POINTS], q[MARCH_FLOORS_MAX], qd[MARCH_FLOORS_MAX];
    double moved = 0;
    set_up(&f, _i);
    struct thud_state *state = &f.m.run->state;
    state->grid_dt_s = f.h_top / 3; /* so many kinks */
    state->offset_s = 0.3 * state->grid_dt_s;
    for (int level = 0; level < LEVELS; level++) {
        double h = ldexp(f.h_top, -level);
        ck_assert_int_eq(thud_responses_make(f.responses, level, f.contact, f.n, f.response, NULL), THUD_OK);
        thud_responses_unforced(f.responses, state, level, INFINITY, f.contact, f.n, d, v);
        for (int i = 0; i < THUD_POINTS; i++) {
            march_to(state, &f.m.run->seg, f.point[i] * h, q, qd);
            for (int c = 0; c < f.n; c++) {
                double indentation = thud_model_gap_sum(f.model, c, q) - thud_state_clearance(state, c);
                ck_assert_double_eq_tol(d[c * THUD_POINTS + i], indentation, 1e-13);
                ck_assert_double_eq_tol(v[c * THUD_POINTS + i], thud_model_gap_sum(f.model, c, qd), 1e-11);
            }
        }
        /* no kink behind the end of the step counts, and those before it do */
        thud_responses_unforced(f.responses, state, level, 0, f.contact, f.n, q, qd);
        for (int c = 0; c < f.n; c++)
            moved = fmax(moved, fabs(q[c * THUD_POINTS + NODES - 1] - d[c * THUD_POINTS + NODES - 1]));
    }
    ck_assert_double_gt(moved, 1e-9);
    tear_down(&f);
}
END_TEST

START_TEST(a_constant_force_moves_contacts_as_the_series_does)
{
    struct fixture f;
    double d[THUD_SEGMENT_TERMS];
    set_up(&f, _i);
    struct thud_state *state = &f.m.run->state;
    struct thud_segment *seg = &f.m.run->seg;
    for (int j = 0; j < f.model->nmodes; j++)
        state->q[j] = state->qd[j] = 0;
    state->grid = (long)f.record->samples; /* the ground is at rest again */
    state->offset_s = 0;
    for (int level = 0; level < LEVELS; level++) {
        ck_assert_int_eq(thud_responses_make(f.responses, level, f.contact, f.n, f.response, NULL), THUD_OK);
        for (int b = 0; b < f.n; b++) {
            thud_segment_begin(state, seg, ldexp(f.h_top, -level));
            seg->terms = THUD_SEGMENT_TERMS;
            seg->row[seg->rows++] = b;
            seg->force[b] = 1e6;
            seg->loaded = 1;
            thud_taylor_given(f.model, seg, state->q, state->qd);
            for (int a = 0; a < f.n; a++) {
                const struct thud_response *r = f.response[a * f.n + b];
                thud_segment_indentation(state, seg, a, d);
                d[0] = 0;
                for (int i = 0; i < THUD_POINTS; i++) {
                    double moved = 0, rate = 0, want[3], largest = 1e6 / 250e3 * seg->h_s * seg->h_s;
                    for (int k = 0; k < NODES; k++) {
                        moved += 1e6 * r->indentation[k * THUD_POINTS + i];
                        rate += 1e6 * r->rate[k * THUD_POINTS + i];
                    }
                    thud_poly_value3(d, seg->terms, f.point[i], want);
                    ck_assert_double_eq_tol(moved, want[0], 1e-12 * largest);
                    ck_assert_double_eq_tol(rate * seg->h_s, want[1], 1e-11 * largest);
                }
            }
        }
    }
    tear_down(&f);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *s = suite_create("response");
    TCase *t = tcase_create("tables");
    tcase_add_loop_test(t, a_step_across_kinks_is_the_steps_between_them, 0, 2);
    tcase_add_loop_test(t, a_constant_force_moves_contacts_as_the_series_does, 0, 2);
    suite_add_tcase(s, t);
    return s;
}
