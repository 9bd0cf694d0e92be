/* Figures of a ground motion: what is drawn is the record, its integrals and its spectrum; marks outside of the periods
 * shown are left out. */
#include <check.h>
#include <math.h>
#include <string.h>

#include "base/quantity.h"
#include "ground/intensity.h"
#include "plot/figures/figures_record.h"

static struct thud_record *make(void)
{
    const double a[] = {0, 1, -2, 3, -1, 0};
    struct thud_record *record;
    ck_assert_int_eq(thud_record_create(a, 6, 0.1, &record, NULL), THUD_OK);
    return record;
}

START_TEST(motion)
{
    struct thud_record *record = make();
    double v[6], u[6];
    thud_record_integrate(record, v, u);
    struct thud_figure *figure = thud_figure_of_motion(record, "name", "title");
    ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
    ck_assert_int_eq(figure->rows * figure->columns, 3);
    for (int i = 0; i < 6; i++) {
        ck_assert_double_eq_tol(figure->panel[0].series[0]->x[i], 0.1 * i, 1e-15);
        ck_assert_double_eq_tol(figure->panel[0].series[0]->y[i] * THUD_GRAVITY, record->a_mps2[i], 1e-14);
        ck_assert_double_eq(figure->panel[1].series[0]->y[i], v[i]);
        ck_assert_double_eq(figure->panel[2].series[0]->y[i], u[i]);
    }
    thud_figure_free(figure);
    thud_record_free(record);
}
END_TEST

START_TEST(spectrum)
{
    struct thud_record *record = make();
    struct thud_spectrum_point point[9];
    thud_spectrum_fill(record, 0.05, 0.1, 2, 9, point);
    ck_assert_double_eq(point[0].period_s, 0.1);
    ck_assert_double_eq(point[8].period_s, 2);
    for (int i = 1; i < 8; i++)
        ck_assert_double_eq_tol(point[i].period_s * point[i].period_s, point[i - 1].period_s * point[i + 1].period_s,
                                1e-12);
    const struct thud_period_mark mark[] = {{0.05, "short"}, {0.4, "A"}, {3, "long"}};
    struct thud_figure *figure = thud_figure_of_spectrum(point, 9, 0.05, mark, 3, "name", "title");
    ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
    for (int k = 0; k < 3; k++) {
        const struct thud_panel *panel = &figure->panel[k];
        ck_assert_int_eq(panel->nmarks, 1);
        ck_assert_double_eq(panel->mark[0].from, 0.4);
        for (int i = 0; i < 9; i++)
            ck_assert_double_eq(panel->series[0]->x[i], point[i].period_s);
    }
    ck_assert_str_eq(figure->panel[0].mark[0].text, "A");
    ck_assert_str_eq(figure->panel[0].axis[THUD_Y].label, "Sa, 5 % damped");
    ck_assert_str_eq(figure->panel[0].axis[THUD_X].label, "Period");
    ck_assert_double_eq_tol(figure->panel[0].series[0]->y[3] * THUD_GRAVITY, point[3].acceleration_mps2, 1e-13);
    ck_assert_double_eq(figure->panel[1].series[0]->y[3], point[3].velocity_mps);
    ck_assert_double_eq(figure->panel[2].series[0]->y[3], point[3].displacement_m);
    thud_figure_free(figure);
    thud_record_free(record);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("record figures");
    TCase *all = tcase_create("all");
    tcase_add_test(all, motion);
    tcase_add_test(all, spectrum);
    suite_add_tcase(suite, all);
    return suite;
}
