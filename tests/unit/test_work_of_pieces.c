/* A piece of motion under given forces: its series against one of all terms, and the quadrature of its works against
 * many points. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "core/numerics/poly.h"
#include "core/run/run_private.h"
#include "march.h"

enum { ORDERS = 7, SCENES = 200, LOOKS = 2000 };

static const int towers[] = {4, 5}; /* an odd number of modes in one of them, and in all */

struct fixture {
    struct thud_model *model;
    struct thud_record *record;
    struct march m;
};

static double random_part(void)
{
    return 2.0 * rand() / RAND_MAX - 1;
}

static void set_up(struct fixture *f, bool isolated)
{
    struct march_law law = march_law("rubber", "stiffness", 0.36e3 * pow(1000, 2.65), "thickness", 0.05, NULL);
    *f = (struct fixture){.model = march_row(2, towers, isolated, 0.1, &law), .record = march_motion(1)};
    f->m = march_run(f->model, f->record, "exact", 0, 0, true, 0.01);
    srand(5);
}

static void tear_down(struct fixture *f)
{
    march_free(&f->m);
    thud_model_free(f->model);
    thud_record_free(f->record);
}

/* A piece of a random length, up to `longest` rad of the fastest mode, with forces on two of the contacts whose orders are
 * each `decay` times the one before. */
static double begin_random(struct fixture *f, struct thud_segment *seg, double longest, double decay)
{
    struct thud_state *state = &f->m.run->state;
    const struct thud_model *m = f->model;
    double angle = 0.05 + (longest - 0.05) * rand() / RAND_MAX, force = 1e6 * rand() / RAND_MAX;
    for (int j = 0; j < m->nmodes; j++) {
        state->qd[j] = 100 * random_part();
        state->q[j] = m->omega[j] > 0 ? 100 * random_part() / m->omega[j] : 0;
    }
    for (int c = 0; c < m->ncontacts; c++)
        state->contact[c].mode = c < 2 ? THUD_CLOSED : THUD_OPEN;
    thud_segment_begin(state, seg, angle / m->fastest_radps, thud_segment_all_terms(state, angle / m->fastest_radps));
    seg->a0 = 10 * random_part();
    seg->a1 = 3 * random_part();
    seg->loaded = ORDERS;
    for (int c = 0; c < 2; c++)
        for (int k = 0; k < ORDERS; k++)
            seg->force[k * m->nrows + c] = force * pow(decay, k) * random_part();
    return angle;
}

START_TEST(few_terms_leave_out_what_they_may)
{
    static const double least = 1e-7;
    struct fixture f;
    double q[2][MARCH_FLOORS_MAX], qd[2][MARCH_FLOORS_MAX];
    set_up(&f, _i);
    struct thud_segment *seg = &f.m.run->seg;
    const int n = f.model->nmodes;
    int fewest = THUD_SEGMENT_TERMS;
    for (int i = 0; i < SCENES; i++) {
        double angle = begin_random(&f, seg, 1.5, 0.3), size = 0, apart = 0, speed = 0; /* that the forces could give */
        for (int c = 0; c < 2; c++)
            for (int k = 0; k < ORDERS; k++)
                speed += seg->h_s * fabs(seg->force[k * f.model->nrows + c]) *
                         sqrt(f.model->delassus[c * f.model->nrows + c]);
        for (int all = 0; all < 2; all++) {
            seg->terms = all ? THUD_SEGMENT_TERMS : thud_segment_terms(angle, least, ORDERS + 3);
            fewest = seg->terms < fewest ? seg->terms : fewest;
            thud_taylor_given(f.model, seg, f.m.run->state.q, f.m.run->state.qd);
            thud_segment_state(seg, n, 1, q[all], qd[all]);
        }
        for (int j = 0; j < n; j++) {
            size += qd[1][j] * qd[1][j] + f.model->spring[j] * q[1][j] * q[1][j];
            apart += pow(qd[0][j] - qd[1][j], 2) + f.model->spring[j] * pow(q[0][j] - q[1][j], 2);
        }
        /* the first term left out is below `least`, and its rate times the number of terms as large */
        ck_assert_double_lt(sqrt(apart), THUD_SEGMENT_TERMS * least * (sqrt(size) + speed));
    }
    ck_assert_int_lt(fewest, THUD_SEGMENT_TERMS / 2);
    tear_down(&f);
}
END_TEST

/* What the orders that are left out would add to the motion, of the system that moves least too; where the fast modes hardly
 * move, the most of them are. */
START_TEST(orders_left_out_are_below_what_they_may)
{
    static const double least = 1e-9;
    struct fixture f;
    double q[2][MARCH_FLOORS_MAX], qd[2][MARCH_FLOORS_MAX];
    set_up(&f, _i);
    struct thud_segment *seg = &f.m.run->seg;
    const struct thud_model *m = f.model;
    struct thud_state *state = &f.m.run->state;
    int left_out = 0;
    for (int i = 0; i < SCENES; i++) {
        begin_random(&f, seg, 3, 0.1);
        seg->loaded = 0;
        for (int j = 0; j < m->nmodes; j++) {
            const struct thud_model_structure *p = &m->structure[j < m->structure[0].modes ? 0 : 1];
            const double part = (j > p->first_mode ? 1e-9 : 1) * (p->first_mode > 0 ? 1e-6 : 1);
            state->q[j] *= part;
            state->qd[j] *= part;
        }
        thud_taylor_given(m, seg, state->q, state->qd);
        const int all = seg->terms;
        thud_segment_state(seg, m->nmodes, 1, q[0], qd[0]);
        thud_segment_trim(seg, m, least);
        thud_segment_state(seg, m->nmodes, 1, q[1], qd[1]);
        left_out += all - seg->terms;
        for (int s = 0; s < m->nstructures; s++) {
            const struct thud_model_structure *p = &m->structure[s];
            double start = 0;
            for (int j = p->first_mode; j < p->first_mode + p->modes; j++)
                start = fmax(start, fabs(seg->q[2 * m->nmodes + j]));
            for (int j = p->first_mode; j < p->first_mode + p->modes; j++) {
                ck_assert_double_le(fabs(q[0][j] - q[1][j]), least * start);
                ck_assert_double_le(seg->h_s * fabs(qd[0][j] - qd[1][j]), least * THUD_SEGMENT_TERMS * start);
            }
        }
    }
    ck_assert_int_gt(left_out, SCENES);
    tear_down(&f);
}
END_TEST

/* Rates and forces at many points in place of the polynomials' coefficients: the equations of motion hold there. */
START_TEST(every_order_keeps_to_the_equations_of_motion)
{
    struct fixture f;
    double q[MARCH_FLOORS_MAX], qd[MARCH_FLOORS_MAX], a[MARCH_FLOORS_MAX], near[2][MARCH_FLOORS_MAX];
    double skip[MARCH_FLOORS_MAX];
    static const double step = 1e-4;
    set_up(&f, _i);
    struct thud_segment *seg = &f.m.run->seg;
    const struct thud_model *m = f.model;
    for (int i = 0; i < 20; i++) {
        begin_random(&f, seg, 1.5, 1);
        seg->terms = THUD_SEGMENT_TERMS;
        thud_taylor_given(m, seg, f.m.run->state.q, f.m.run->state.qd);
        for (double s = 0.1; s < 1; s += 0.2) {
            double force[MARCH_FLOORS_MAX] = {0}, size = 0;
            thud_segment_state(seg, m->nmodes, s, q, qd);
            thud_segment_state(seg, m->nmodes, s - step, skip, near[0]);
            thud_segment_state(seg, m->nmodes, s + step, skip, near[1]);
            for (int c = 0; c < 2; c++)
                for (int k = ORDERS - 1; k >= 0; k--)
                    force[c] = force[c] * s + seg->force[k * m->nrows + c];
            thud_model_acceleration(m, q, qd, seg->a0 + seg->a1 * s, a);
            thud_model_apply_contact_forces(m, force, a);
            for (int j = 0; j < m->nmodes; j++)
                size = fmax(size, fabs(a[j]));
            for (int j = 0; j < m->nmodes; j++)
                ck_assert_double_eq_tol((near[1][j] - near[0][j]) / (2 * step * seg->h_s), a[j], 1e-6 * size);
        }
    }
    tear_down(&f);
}
END_TEST

/* The works up to s by sixteen times eight points. */
static void many_points(const struct thud_model *m, const struct thud_segment *seg, double s, double *input_j,
                        double *viscous_j)
{
    enum { PARTS = 16 };
    double q[MARCH_FLOORS_MAX], qd[MARCH_FLOORS_MAX], input = 0, viscous = 0;
    for (int part = 0; part < PARTS; part++)
        for (int i = 0; i < THUD_QUADRATURE_POINTS; i++) {
            double at = s * (part + thud_quadrature_node[i]) / PARTS, weight = thud_quadrature_weight[i] / PARTS;
            thud_segment_state(seg, m->nmodes, at, q, qd);
            for (int j = 0; j < m->nmodes; j++) {
                input -= weight * (seg->a0 + seg->a1 * at) * m->gamma[j] * qd[j];
                viscous += weight * m->dashpot[j] * qd[j] * qd[j];
            }
            for (int k = 0; k < m->nstructures; k++) {
                const struct thud_model_structure *p = &m->structure[k];
                for (int a = 0; p->damping && a < p->modes; a++)
                    for (int b = 0; b < p->modes; b++)
                        viscous +=
                            weight * qd[p->first_mode + a] * p->damping[a * p->modes + b] * qd[p->first_mode + b];
            }
        }
    *input_j = input * s * seg->h_s;
    *viscous_j = viscous * s * seg->h_s;
}

/* The works of pieces of any number of terms are right to rounding, of coupled modes too: a rule of too few points would
 * be off by 1e-6 from the first term on that it does not take. */
START_TEST(works_are_right_to_rounding)
{
    struct fixture f;
    double q[MARCH_FLOORS_MAX], qd[MARCH_FLOORS_MAX], input, viscous, want_input, want_viscous;
    set_up(&f, _i);
    struct thud_run *run = f.m.run;
    const struct thud_model *m = f.model;
    for (int i = 0; i < SCENES; i++) {
        begin_random(&f, &run->seg, 1.5, 1);
        run->seg.terms = THUD_SEGMENT_TERMS;
        thud_taylor_given(m, &run->seg, run->state.q, run->state.qd);
        const double s = i % 2 ? 1 : 0.3 + 0.7 * rand() / RAND_MAX;
        for (int terms = 3; terms <= THUD_SEGMENT_TERMS; terms++) {
            run->seg.terms = terms;
            thud_segment_state(&run->seg, m->nmodes, s, q, qd);
            const struct thud_observation o = {.state = &run->state, .seg = &run->seg, .s = s, .q = q, .qd = qd};
            many_points(m, &run->seg, s, &want_input, &want_viscous);
            thud_ledger_structure_work(&run->ledger, &o, &input, &viscous);
            ck_assert_double_le(fabs(input - want_input) + fabs(viscous - want_viscous),
                                1e-13 * (fabs(want_input) + want_viscous));
        }
    }
    tear_down(&f);
}
END_TEST

/* So are those of pieces that turn as far as a series goes, of the terms that they need; and in a step of few nodes, far
 * within its tolerance. */
START_TEST(works_are_right_where_a_piece_turns_far)
{
    struct fixture f;
    double q[MARCH_FLOORS_MAX], qd[MARCH_FLOORS_MAX], input, viscous, want_input, want_viscous;
    set_up(&f, _i);
    struct thud_run *run = f.m.run;
    const struct thud_model *m = f.model;
    for (int i = 0; i < SCENES; i++) {
        const bool coarse = i % 2;
        const struct thud_segment_nodes nodes = {.count = 4 + i / 2 % 3};
        const double angle = begin_random(&f, &run->seg, THUD_SEGMENT_ANGLE, 1), tolerance = coarse ? 1e-6 : 1e-12;
        if (angle < 2.2)
            continue;
        thud_taylor_given(m, &run->seg, run->state.q, run->state.qd);
        thud_segment_state(&run->seg, m->nmodes, 1, q, qd);
        run->seg.nodes = coarse ? &nodes : NULL;
        run->state.tolerance = tolerance;
        const struct thud_observation o = {.state = &run->state, .seg = &run->seg, .s = 1, .q = q, .qd = qd};
        many_points(m, &run->seg, 1, &want_input, &want_viscous);
        thud_ledger_structure_work(&run->ledger, &o, &input, &viscous);
        run->seg.nodes = NULL;
        ck_assert_double_le(fabs(input - want_input) + fabs(viscous - want_viscous),
                            tolerance * (fabs(want_input) + want_viscous));
    }
    tear_down(&f);
}
END_TEST

/* First point of many at which an open contact is indented, or a closed one is no more, turns or passes its ultimate
 * compression. */
static double first_by_looking(const struct thud_state *state, const struct thud_segment *seg, int *contact)
{
    const struct thud_model *m = state->model;
    double q[MARCH_FLOORS_MAX], qd[MARCH_FLOORS_MAX];
    for (int i = 0; i <= LOOKS; i++) {
        thud_segment_state(seg, m->nmodes, (double)i / LOOKS, q, qd);
        for (*contact = 0; *contact < m->ncontacts; ++*contact) {
            const struct thud_contact_state *s = &state->contact[*contact];
            double d = thud_model_gap_sum(m, *contact, q) - thud_state_clearance(state, *contact),
                   v = thud_model_gap_sum(m, *contact, qd);
            bool turns = s->phase == THUD_APPROACH ? v < 0 : v > 0;
            if (s->mode == THUD_OPEN ? d > 0 : d < 0 || turns || d > s->ultimate_m)
                return (double)i / LOOKS;
        }
    }
    return INFINITY;
}

START_TEST(no_event_is_passed_over)
{
    struct fixture f;
    int found[2] = {0}; /* pieces without and with an event inside */
    set_up(&f, _i);
    struct thud_run *run = f.m.run;
    const struct thud_model *m = f.model;
    for (int i = 0; i < SCENES; i++) {
        begin_random(&f, &run->seg, 1.5, 0.3);
        double place = 5 * pow(10, -2.0 * rand() / RAND_MAX); /* the slower, the fewer events */
        for (int j = 0; j < m->nmodes; j++) {
            run->state.q[j] *= place;
            run->state.qd[j] *= place;
        }
        for (int c = 0; c < m->ncontacts; c++) {
            struct thud_contact_state *s = &run->state.contact[c];
            double d = 0.01 * random_part();
            s->residual_m += thud_contact_indentation(&run->state, c) - d; /* to be so far indented */
            s->mode = d > 0 ? THUD_CLOSED : THUD_OPEN;
            s->phase = thud_contact_rate(&run->state, c) > 0 ? THUD_APPROACH : THUD_RESTITUTION;
            s->branch = (struct thud_branch){.K = 1, .p = 1};
            s->suppressed = (struct thud_suppressed){0};
            s->ultimate_m = fabs(d) + 0.04 * rand() / RAND_MAX;
        }
        run->seg.terms = THUD_SEGMENT_TERMS;
        thud_taylor_given(m, &run->seg, run->state.q, run->state.qd);
        int contact, want, order;
        enum thud_event event;
        double at = thud_event_first(&run->state, &run->seg, 1, &contact, &event, &order),
               look = first_by_looking(&run->state, &run->seg, &want);
        if (isfinite(look))
            ck_assert_double_eq_tol(at, look, 1.01 / LOOKS);
        else
            ck_assert_double_gt(at, 1 - 1.0 / LOOKS);
        found[isfinite(look) && look > 0]++;
    }
    ck_assert_int_gt(found[0], SCENES / 10);
    ck_assert_int_gt(found[1], SCENES / 10);
    tear_down(&f);
}
END_TEST

/* The law has a constant force, and the segment another one: what counts is the law's. */
START_TEST(work_in_a_contact_is_that_of_its_law)
{
    static const double force = 2e6;
    struct fixture f;
    set_up(&f, _i);
    struct thud_run *run = f.m.run;
    const struct thud_model *m = f.model;
    double q[MARCH_FLOORS_MAX], qd[MARCH_FLOORS_MAX];
    for (int i = 0; i < SCENES; i++) {
        begin_random(&f, &run->seg, 1.5, 0);
        run->seg.terms = THUD_SEGMENT_TERMS;
        thud_taylor_given(m, &run->seg, run->state.q, run->state.qd);
        double s = i % 2 ? 1 : 0.3 + 0.7 * rand() / RAND_MAX, want = 0, scale = 0, slope;
        double before = thud_ledger_contact_work(&run->ledger);
        for (int c = 0; c < 2; c++) {
            run->state.contact[c].branch = (struct thud_branch){.f0_n = force};
            const double *d = thud_segment_read(&run->state, &run->seg, c);
            want += force * (thud_poly_value(d, run->seg.terms, s) - d[0]);
            scale += force * thud_poly_move(d, run->seg.terms, &slope);
        }
        thud_segment_state(&run->seg, m->nmodes, s, q, qd);
        struct thud_observation o = {.state = &run->state, .seg = &run->seg, .s = s, .q = q, .qd = qd};
        thud_ledger_add(&run->ledger, &o);
        ck_assert_double_eq_tol(thud_ledger_contact_work(&run->ledger) - before, want, 2e-3 * scale);
        ck_assert_double_gt(scale, 0);
    }
    tear_down(&f);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *s = suite_create("work_of_pieces");
    TCase *t = tcase_create("piece");
    tcase_add_loop_test(t, few_terms_leave_out_what_they_may, 0, 2);
    tcase_add_loop_test(t, orders_left_out_are_below_what_they_may, 0, 2);
    tcase_add_loop_test(t, every_order_keeps_to_the_equations_of_motion, 0, 2);
    tcase_add_loop_test(t, works_are_right_to_rounding, 0, 2);
    tcase_add_loop_test(t, works_are_right_where_a_piece_turns_far, 0, 2);
    tcase_add_loop_test(t, no_event_is_passed_over, 0, 2);
    tcase_add_loop_test(t, work_in_a_contact_is_that_of_its_law, 0, 2);
    suite_add_tcase(s, t);
    return s;
}
