/* The table over several ground motions: medians and fractiles by hand, counts, and places without a result. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/sweep/sweep_table.h"

enum { RECORDS = 5, GAPS = 3 };
static const int floors[] = {2, 0};
static struct thud_error error;

/* Ground motion r is r + 1 times as strong; the last has no result at the second gap. */
static struct thud_sweep_summary *point(int record, int gap)
{
    struct thud_sweep_summary *d = thud_sweep_summary_create(2, 2, floors, false);
    ck_assert_ptr_nonnull(d);
    d->record = record;
    d->at[0] = gap;
    d->has_contact = true;
    for (int k = 0; k < 2; k++) {
        double strength = (record + 1) * pow(2, gap);
        d->which[k] = k ? THUD_CASE_BUMPER : THUD_CASE_NONE;
        *thud_sweep_summary_measure(d, k, THUD_MEASURE_IMPACTS, 0, THUD_SWEEP_VALUE) = record > 1 ? record : 0;
        *thud_sweep_summary_measure(d, k, THUD_MEASURE_FORCE, 0, THUD_SWEEP_VALUE) = 1e6 * strength;
        *thud_sweep_summary_measure(d, k, THUD_MEASURE_SHEAR, 0, THUD_SWEEP_VALUE) = 1e5 * strength;
        *thud_sweep_summary_measure(d, k, THUD_MEASURE_COLUMNS, 0, THUD_SWEEP_VALUE) =
            record ? 0.1 * strength : (double)NAN;
        *thud_sweep_summary_measure(d, k, THUD_MEASURE_DUCTILITY, 0, THUD_SWEEP_VALUE) = 7 * strength;
        *thud_sweep_summary_measure(d, k, THUD_MEASURE_PERMANENT, 0, THUD_SWEEP_VALUE) = strength;
        *thud_sweep_summary_measure(d, k, THUD_MEASURE_ACCELERATION_RATIO, 0, THUD_SWEEP_VALUE) = k ? strength / 3 : 1;
        for (int f = 0; f <= floors[0]; f++)
            *thud_sweep_summary_ratio(d, k, 0, f, THUD_SWEEP_VALUE) =
                (struct thud_sweep_ratio){k ? strength / 3 : 1, 10 * strength, 1 + f, 0};
    }
    return d;
}

START_TEST(medians_by_hand)
{
    double value[] = {0.05, 0.1, 0.15};
    struct thud_sweep_axis axis = {.key = "gap", .n = GAPS, .value = value};
    static const char *const names[] = {"a", "b", "c", "d", "e"}, *const structures[] = {"A", "wall"};
    struct thud_sweep_summary *points[RECORDS * GAPS];
    struct thud_sweep_table table = {.nrecords = RECORDS,
                                     .nstructures = 2,
                                     .naxes = 1,
                                     .axis = &axis,
                                     .record = names,
                                     .structure = structures,
                                     .point = points},
                            *suite;
    for (int r = 0; r < RECORDS; r++)
        for (int g = 0; g < GAPS; g++)
            if (r < RECORDS - 1 || g != 1)
                points[table.npoints++] = point(r, g);
    ck_assert_int_eq(thud_sweep_suite_make(&table, &suite, &error), THUD_OK);
    ck_assert_int_eq(suite->motions, RECORDS);
    ck_assert_int_eq(suite->nrecords, 1);
    ck_assert_uint_eq(suite->npoints, GAPS);
    for (int g = 0; g < GAPS; g++) {
        const struct thud_sweep_summary *d = suite->point[g];
        double scale = pow(2, g);
        int n = g == 1 ? 4 : 5, k = thud_sweep_summary_find(d, THUD_CASE_BUMPER);
        const struct thud_sweep_shares *shares = suite->shares + g * THUD_SWEEP_CASES_MAX;
        ck_assert_int_eq(d->at[0], g);
        ck_assert_int_eq(k, 1);
        /* of 1 ... 5 the third; of 1 ... 4 half-way in logarithms between 2 and 3; 16 %: 0.64 or 0.48 past the first */
        double median = n == 5 ? 3 : sqrt(6), low = pow(2, n == 5 ? 0.64 : 0.48);
        ck_assert_double_eq_tol(*thud_sweep_summary_measure(d, k, THUD_MEASURE_FORCE, 0, THUD_SWEEP_VALUE),
                                1e6 * scale * median, 1e-6);
        ck_assert_double_eq_tol(*thud_sweep_summary_measure(d, k, THUD_MEASURE_FORCE, 0, THUD_SWEEP_LOW),
                                1e6 * scale * low, 1e-6);
        ck_assert_double_eq_tol(shares[k].pounding, n == 5 ? 0.6 : 0.5, 1e-15); /* the third and those after it */
        ck_assert_double_eq_tol(*thud_sweep_summary_measure(d, k, THUD_MEASURE_SHEAR, 0, THUD_SWEEP_VALUE),
                                1e5 * scale * median, 1e-6);
        ck_assert_double_eq_tol(*thud_sweep_summary_measure(d, k, THUD_MEASURE_SHEAR, 0, THUD_SWEEP_LOW),
                                1e5 * scale * low, 1e-6);
        /* without the first: of 2 ... 5 between 3 and 4, of 2 ... 4 the second of them */
        ck_assert_double_eq_tol(*thud_sweep_summary_measure(d, k, THUD_MEASURE_COLUMNS, 0, THUD_SWEEP_VALUE),
                                0.1 * scale * (n == 5 ? sqrt(12) : 3), 1e-12);
        ck_assert_double_eq_tol(*thud_sweep_summary_measure(d, k, THUD_MEASURE_DUCTILITY, 0, THUD_SWEEP_VALUE),
                                7 * scale * median, 1e-12);
        ck_assert_double_eq_tol(*thud_sweep_summary_measure(d, k, THUD_MEASURE_PERMANENT, 0, THUD_SWEEP_LOW),
                                scale * low, 1e-12);
        ck_assert(isnan(*thud_sweep_summary_measure(d, k, THUD_MEASURE_DUCTILITY, 1, THUD_SWEEP_VALUE)));
        for (int f = 0; f <= floors[0]; f++) {
            const struct thud_sweep_ratio *x = thud_sweep_summary_ratio(d, k, 0, f, THUD_SWEEP_VALUE);
            ck_assert_double_eq_tol(x->acceleration, scale * median / 3, 1e-14);
            ck_assert_double_eq_tol(x->drift, 10 * scale * median, 1e-12);
            ck_assert(x->acceleration_free == 1 + f);
            ck_assert(x->drift_free == 0);
            ck_assert_double_eq_tol(thud_sweep_summary_ratio(d, k, 0, f, THUD_SWEEP_LOW)->acceleration, scale * low / 3,
                                    1e-14);
            ck_assert(thud_sweep_summary_ratio(d, 0, 0, f, THUD_SWEEP_HIGH)->acceleration == 1);
        }
        int worse = 0; /* strength above 3 */
        for (int r = 0; r < n; r++)
            worse += (r + 1) * scale > 3;
        ck_assert_double_eq_tol(shares[k].worse, (double)worse / n, 1e-15);
        ck_assert(shares[0].worse == 0);
        for (int end = 0; end < 2; end++) { /* Wilson's: (share - p)^2 = z^2 p (1 - p)/n, z of 90 % */
            const double z = 1.6448536269514722, p = shares[k].pounding_band[end], off = shares[k].pounding - p;
            ck_assert_double_eq_tol(off * off, z * z * p * (1 - p) / n, 1e-12);
            ck_assert(end ? off < 0 : off > 0);
        }
        ck_assert_double_lt(shares[k].worse_band[0], shares[k].worse + 1e-12);
        ck_assert_double_gt(shares[k].worse_band[1], shares[k].worse - 1e-12);
    }
    thud_sweep_suite_free(suite);
    for (size_t i = 0; i < table.npoints; i++)
        free(points[i]);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("sweep_suite");
    TCase *tcase = tcase_create("sweep_suite");
    tcase_add_test(tcase, medians_by_hand);
    suite_add_tcase(suite, tcase);
    return suite;
}
