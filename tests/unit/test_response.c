/* Motion at the points of a step, read from tables: against the power series. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "core/motion/response.h"
#include "core/numerics/poly.h"
#include "core/numerics/quadrature.h"
#include "core/run/run_private.h"
#include "march.h"

enum { NODES = THUD_NODES_MAX, POINTS = THUD_POINTS_MAX, LEVELS = 6, CONTACTS_MAX = 8 };

static const int towers[] = {4, 6};

/* A step from between two samples of the ground motion, whose line it follows, and the same points by series. */
struct fixture {
    struct thud_model *model;
    struct thud_record *record;
    struct march m;
    struct thud_responses *responses;
    double point[POINTS], h_top;
    int contact[CONTACTS_MAX], n;
    const thud_vec2 *response[CONTACTS_MAX * CONTACTS_MAX];
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
    f->point[0] = 0;
    for (int i = 0; i < NODES - 2; i++)
        f->point[i + 1] = thud_lobatto_of(NODES)->node[i];
    f->point[NODES - 1] = 1;
    for (int i = NODES; i < POINTS; i++)
        f->point[i] = 0.17 * (i - NODES + 1);
    thud_lagrange_coefficients(NODES, f->point, lagrange);
    ck_assert_int_eq(thud_responses_create(state, NODES, POINTS, f->point, lagrange, f->h_top, &f->responses, NULL),
                     THUD_OK);
    f->n = f->model->ncontacts;
    for (int c = 0; c < f->n; c++)
        f->contact[c] = c;
}

static void tear_down(struct fixture *f)
{
    march_free(&f->m);
    thud_model_free(f->model);
    thud_record_free(f->record);
}

START_TEST(a_step_without_forces_is_the_series)
{
    struct fixture f;
    thud_vec2 start[CONTACTS_MAX * POINTS], out[CONTACTS_MAX * POINTS];
    double q[MARCH_FLOORS_MAX], qd[MARCH_FLOORS_MAX];
    set_up(&f, _i);
    const struct thud_state *state = &f.m.run->state;
    struct thud_segment *seg = &f.m.run->seg;
    for (int c = 0; c < f.n; c++)
        start[c * POINTS] = thud_vec2_set(thud_contact_indentation(state, c), thud_contact_rate(state, c));
    for (int level = 0; level < LEVELS; level++) {
        ck_assert_int_eq(thud_responses_make(f.responses, level, f.contact, f.n, f.response, NULL), THUD_OK);
        thud_responses_unforced(f.responses, state, level, f.contact, f.n, start, out);
        thud_segment_begin(state, seg, ldexp(f.h_top, -level), thud_segment_all_terms(state, ldexp(f.h_top, -level)));
        seg->terms = THUD_SEGMENT_TERMS;
        thud_taylor_given(state->model, seg, state->q, state->qd);
        for (int i = 0; i < POINTS; i++) {
            thud_segment_state(seg, state->model->nmodes, f.point[i], q, qd);
            for (int c = 0; c < f.n; c++) {
                double indentation = thud_model_gap_sum(f.model, c, q) - thud_state_clearance(state, c);
                ck_assert_double_eq_tol(out[c * POINTS + i][0], indentation, 1e-13);
                ck_assert_double_eq_tol(out[c * POINTS + i][1], thud_model_gap_sum(f.model, c, qd), 1e-11);
            }
        }
    }
    tear_down(&f);
}
END_TEST

START_TEST(a_force_s_to_the_p_moves_contacts_as_the_series_does)
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
        for (int at = 0; at < f.n * NODES; at++) {
            const int b = at / NODES, p = at % NODES;
            const double rounding = 1e-12;
            thud_segment_begin(state, seg, ldexp(f.h_top, -level),
                               thud_segment_all_terms(state, ldexp(f.h_top, -level)));
            seg->terms = THUD_SEGMENT_TERMS;
            seg->row[seg->rows++] = b;
            seg->force[p * f.model->nrows + b] = 1e6;
            seg->loaded = p + 1;
            thud_taylor_given(f.model, seg, state->q, state->qd);
            for (int a = 0; a < f.n; a++) {
                const thud_vec2 *r = f.response[a * f.n + b];
                thud_segment_indentation(state, seg, a, d);
                d[0] = 0;
                for (int i = 0; i < POINTS; i++) {
                    double want[3], largest = 1e6 / 250e3 * seg->h_s * seg->h_s;
                    thud_vec2 moved = {0, 0};
                    for (int k = 0; k < NODES; k++)
                        moved += 1e6 * pow(f.point[k], p) * r[i * NODES + k];
                    thud_poly_value3(d, seg->terms, f.point[i], want);
                    ck_assert_double_eq_tol(moved[0], want[0], rounding * largest);
                    ck_assert_double_eq_tol(moved[1] * seg->h_s, want[1], 10 * rounding * largest);
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
    tcase_add_loop_test(t, a_step_without_forces_is_the_series, 0, 2);
    tcase_add_loop_test(t, a_force_s_to_the_p_moves_contacts_as_the_series_does, 0, 2);
    suite_add_tcase(s, t);
    return s;
}
