/* The best value of a key from a table made by hand: a parabola whose minimum and flat part are known. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "study/sweep/sweep_best.h"

enum { THICKNESSES = 9, GAPS = 2, RECORDS = 2, STRUCTURES = 2, POINTS = THICKNESSES * GAPS * RECORDS };

/* ratio = 0.8 + 100 (d - best)^2 for structure 0 and 0.01 less for structure 1; best = 3 cm at the first gap, 6 cm at
 * the second; in the second record 0.1 more and 1 cm to the right. A floor's own ratio counts for nothing. */
static struct thud_sweep_summary *point[POINTS];
static double gap[GAPS] = {0.1, 0.2}, thickness[THICKNESSES];
static struct thud_sweep_table table;
static struct thud_sweep_axis axis[2];

static struct thud_sweep_summary *make_point(int record, int g, int i)
{
    struct thud_sweep_summary *d = thud_sweep_summary_create(1, STRUCTURES, (const int[STRUCTURES]){1, 1}, false);
    double off = thickness[i] - (g == 0 ? 0.03 : 0.06) - 0.01 * record;
    ck_assert_ptr_nonnull(d);
    d->record = record;
    d->at[0] = g;
    d->at[1] = i;
    d->gap_m = gap[g];
    d->which[0] = THUD_CASE_BUMPER;
    for (int s = 0; s < STRUCTURES; s++) {
        *thud_sweep_summary_measure(d, 0, THUD_MEASURE_ACCELERATION_RATIO, s, THUD_SWEEP_VALUE) =
            0.8 + 0.1 * record + 100 * off * off - 0.01 * s;
        *thud_sweep_summary_measure(d, 0, THUD_MEASURE_DRIFT_RATIO, s, THUD_SWEEP_VALUE) = 0.9 + 0.01 * s;
        *thud_sweep_summary_ratio(d, 0, s, 1, THUD_SWEEP_VALUE) = (struct thud_sweep_ratio){0.1 * i, 7, 1, 1};
    }
    return d;
}

static void set_up(void)
{
    int n = 0;
    for (int i = 0; i < THICKNESSES; i++)
        thickness[i] = 0.01 * i;
    axis[0] = (struct thud_sweep_axis){.key = "gap", .n = GAPS, .value = gap};
    axis[1] = (struct thud_sweep_axis){.key = "bumper.thickness", .n = THICKNESSES, .value = thickness};
    for (int r = 0; r < RECORDS; r++)
        for (int g = 0; g < GAPS; g++)
            for (int i = 0; i < THICKNESSES; i++)
                point[n++] = make_point(r, g, i);
    table = (struct thud_sweep_table){
        .nrecords = RECORDS, .nstructures = STRUCTURES, .naxes = 2, .axis = axis, .npoints = POINTS, .point = point};
}

static void tear_down(void)
{
    for (int i = 0; i < POINTS; i++)
        free(point[i]);
}

START_TEST(minimum_and_flat_part)
{
    struct thud_sweep_best *best;
    ck_assert_int_eq(thud_sweep_best(&table, 1, &best), GAPS * (RECORDS + 1));
    for (int g = 0; g < GAPS; g++)
        for (int r = 0; r <= RECORDS; r++) {
            const struct thud_sweep_best *b = &best[g * (RECORDS + 1) + r];
            bool all = r == RECORDS;
            ck_assert_int_eq(b->record, all ? -1 : r);
            ck_assert_int_eq(b->which, THUD_CASE_BUMPER);
            ck_assert_int_eq(b->at[0], g);
            /* the second record is the worse one near its own best */
            double centre = (g == 0 ? 0.03 : 0.06) + (r > 0 ? 0.01 : 0);
            ck_assert_double_eq_tol(table.axis[1].value[b->at[1]], centre, 1e-12);
            ck_assert_double_eq_tol(b->ratio, r > 0 ? 0.9 : 0.8, 1e-12);
            ck_assert_double_eq_tol(b->drift_ratio, 0.91, 1e-12);
            /* 5 % of 0.8 and of 0.9: 2 cm to either side */
            ck_assert_double_eq_tol(table.axis[1].value[b->flat_least], centre - 0.02, 1e-12);
            ck_assert_double_eq_tol(table.axis[1].value[b->flat_most], fmin(centre + 0.02, 0.08), 1e-12);
            ck_assert_int_eq(b->values, THICKNESSES);
        }
    free(best);
}
END_TEST

START_TEST(what_has_no_answer_is_passed_over)
{
    struct thud_sweep_best *best;
    /* the first record's best value at the first gap had no result */
    for (int i = 0; i < POINTS; i++)
        if (point[i]->record == 0 && point[i]->at[0] == 0 && point[i]->at[1] == 3)
            for (int k = 0; k < STRUCTURES; k++)
                *thud_sweep_summary_measure(point[i], 0, THUD_MEASURE_ACCELERATION_RATIO, k, THUD_SWEEP_VALUE) = NAN;
    ck_assert_int_eq(thud_sweep_best(&table, 1, &best), GAPS * (RECORDS + 1));
    ck_assert_double_eq_tol(best[0].ratio, 0.81, 1e-12);
    ck_assert_int_eq(best[0].values, THICKNESSES - 1);
    ck_assert_int_eq(best[2].values, THICKNESSES - 1);
    free(best);
    table.npoints = 0;
    ck_assert_int_eq(thud_sweep_best(&table, 1, &best), 0);
    free(best);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("sweep best");
    TCase *tcase = tcase_create("best");
    tcase_add_checked_fixture(tcase, set_up, tear_down);
    tcase_add_test(tcase, minimum_and_flat_part);
    tcase_add_test(tcase, what_has_no_answer_is_passed_over);
    suite_add_tcase(suite, tcase);
    return suite;
}
