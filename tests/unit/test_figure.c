/* Figures as data: limits that hold all data, a key with every name once, contours that lie on the level, traces that
 * keep their spikes. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "plot/figure/figure.h"
#include "plot/gnuplot/reduce.h"

static const struct thud_style line = {.kind = THUD_LINES};

START_TEST(limits_are_round_and_hold_the_data)
{
    struct thud_figure *figure = thud_figure_create("f", "", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    const double x[] = {5.0, 10.0, 25.0}, y[] = {0.613, NAN, 1.27};
    thud_panel_add(panel, line, "a", 3, x, y);
    thud_panel_mark(panel, THUD_Y, 1.5, 1.5, "");
    struct thud_range on_x = thud_panel_range(panel, THUD_X), on_y = thud_panel_range(panel, THUD_Y);
    ck_assert(fabs(on_x.least - 5.0) < 1e-9 && fabs(on_x.most - 25.0) < 1e-9);
    ck_assert(on_y.least < 0.613 && on_y.least > 0.0 && on_y.most > 1.5 && on_y.most < 2.1);
    double parts = (on_y.most - on_y.least) / on_y.step;
    ck_assert(fabs(parts - round(parts)) < 1e-9 && parts >= 3.0 && parts <= 12.0);
    thud_panel_limits(panel, THUD_X, 20.0, 30.0); /* only the last point is left to see */
    on_y = thud_panel_range(panel, THUD_Y);
    ck_assert(on_y.least > 0.9);
    thud_figure_free(figure);
}
END_TEST

START_TEST(no_answer_lies_on_the_frame)
{
    struct thud_figure *figure = thud_figure_create("f", "", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    const double x[] = {-60.0, 2.0, 60.0}, y[] = {3.0, 6.0, 9.0};
    thud_panel_add(panel, line, "a", 3, x, y);
    struct thud_range range = thud_panel_range(panel, THUD_X); /* as asked for, such as gaps: from end to end */
    ck_assert(range.least == -60.0 && range.most == 60.0);
    thud_panel_results_on_x(panel);
    range = thud_panel_range(panel, THUD_X);
    ck_assert(range.least < -61.0 && range.most > 61.0 && range.most < 80.0);
    thud_panel_limits(panel, THUD_X, 0.0, NAN); /* what begins at nothing begins at the frame */
    range = thud_panel_range(panel, THUD_X);
    ck_assert(range.least == 0.0 && range.most > 61.0);
    thud_figure_free(figure);
}
END_TEST

START_TEST(limits_of_nothing_and_of_one_value)
{
    struct thud_figure *figure = thud_figure_create("f", "", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    struct thud_range range = thud_panel_range(panel, THUD_Y);
    ck_assert(range.least < range.most && range.step > 0.0);
    const double x[] = {1.0, 2.0}, y[] = {-3.0, -3.0};
    thud_panel_add(panel, line, "a", 2, x, y);
    range = thud_panel_range(panel, THUD_Y);
    ck_assert(range.least < -3.0 && range.most > -3.0);
    thud_panel_log(panel, THUD_Y); /* nothing positive */
    range = thud_panel_range(panel, THUD_Y);
    ck_assert(range.least > 0.0 && range.most > range.least);
    thud_figure_free(figure);
}
END_TEST

START_TEST(logarithmic_limits_are_whole_decades)
{
    struct thud_figure *figure = thud_figure_create("f", "", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    const double x[] = {3e-9, 2e-3, 0.0}, y[] = {1.0, 1.0, 1.0};
    thud_panel_add(panel, line, "a", 3, x, y);
    thud_panel_log(panel, THUD_X);
    struct thud_range range = thud_panel_range(panel, THUD_X);
    ck_assert(fabs(log10(range.least) + 9.0) < 1e-9 && fabs(log10(range.most) + 2.0) < 1e-9);
    const double high[] = {98.0, 1.0, 3.0}; /* results stand off the frame */
    thud_panel_add(panel, line, "b", 3, x, high);
    thud_panel_log(panel, THUD_Y);
    range = thud_panel_range(panel, THUD_Y);
    ck_assert(range.least < 0.97 && range.least > 0.5 && range.most > 103.0 && range.most < 200.0);
    thud_figure_free(figure);
}
END_TEST

START_TEST(colours_differ)
{
    for (int i = 0; i < THUD_COLORS_ALL; i++)
        for (int j = 0; j < i; j++) {
            int apart = 0;
            for (int shift = 0; shift < 24; shift += 8)
                apart += abs((int)(thud_color_rgb(i) >> shift & 255) - (int)(thud_color_rgb(j) >> shift & 255));
            ck_assert_msg(apart > 75, "colours %d and %d: %d apart", i, j, apart);
        }
    ck_assert_uint_eq(thud_color_rgb(THUD_COLORS_ALL), thud_color_rgb(0));
}
END_TEST

/* The methods of a speed chart stand in two panels: one list in the key all the same. */
START_TEST(key_follows_the_colours)
{
    const struct thud_series *entry[8];
    const double x[] = {1.0, 2.0};
    static const char *const name[] = {"a", "c", "b"};
    static const int color[] = {0, 9, 4};
    struct thud_figure *figure = thud_figure_create("key", "", 1, 2);
    for (int i = 0; i < 3; i++)
        thud_panel_add(thud_figure_panel(figure, 0, i == 2, ""),
                       (struct thud_style){.kind = THUD_LINES, .color = color[i]}, name[i], 2, x, x);
    ck_assert_int_eq(thud_figure_key(figure, entry, 8), 3);
    ck_assert_str_eq(entry[0]->name, "a");
    ck_assert_str_eq(entry[1]->name, "b");
    ck_assert_str_eq(entry[2]->name, "c");
    thud_figure_free(figure);
}
END_TEST

START_TEST(key_names_everything_once_in_order)
{
    struct thud_figure *figure = thud_figure_create("f", "", 1, 2);
    const char *const names[] = {"floor 1", "floor 2", "", "floor 1", "floor 3"};
    const double x = 0.0;
    for (int i = 0; i < 5; i++)
        thud_panel_add(thud_figure_panel(figure, 0, i % 2, ""), line, names[i], 1, &x, &x);
    const struct thud_series *key[8];
    ck_assert_int_eq(thud_figure_key(figure, key, 8), 3);
    ck_assert_str_eq(key[0]->name, "floor 1");
    ck_assert_str_eq(key[1]->name, "floor 3");
    ck_assert_str_eq(key[2]->name, "floor 2");
    thud_figure_free(figure);
}
END_TEST

/* A curve of which nothing is seen, of no number or beyond the limits, has no entry. */
START_TEST(the_key_has_no_entry_without_a_curve)
{
    struct thud_figure *figure = thud_figure_create("x", "", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    const struct thud_series *key[4];
    thud_panel_limits(panel, THUD_X, 0, 2);
    thud_panel_add(panel, (struct thud_style){0}, "seen", 2, (double[]){1, 3}, (double[]){1, 2});
    thud_panel_add(panel, (struct thud_style){0}, "nowhere", 2, (double[]){1, 2}, (double[]){NAN, NAN});
    thud_panel_add(panel, (struct thud_style){0}, "beyond", 2, (double[]){3, 4}, (double[]){1, 2});
    ck_assert_int_eq(thud_figure_key(figure, key, 4), 1);
    ck_assert_str_eq(key[0]->name, "seen");
    thud_figure_free(figure);
}
END_TEST

/* In words: curves of one name are told together, and one of no name does not stand for those that have one. */
START_TEST(words_tell_all_curves_of_a_name)
{
    struct thud_figure *figure = thud_figure_create("f", "", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    const double x[] = {0.0, 1.0}, low[] = {1.0, 2.0}, middle[] = {2.0, 5.0}, high[] = {3.0, 9.0},
                 other[] = {0.0, 50.0};
    struct thud_text words = {0};
    thud_panel_add(panel, line, "", 2, x, other);
    thud_panel_add(panel, line, "16 and 84 %", 2, x, low);
    thud_panel_add(panel, line, "median", 2, x, middle);
    thud_panel_add(panel, line, "16 and 84 %", 2, x, high);
    thud_figure_words(figure, &words);
    ck_assert_str_eq(words.data, "values against index: 16 and 84 % 1 to 9, median 2 to 5.");
    thud_text_clear(&words);
    thud_figure_free(figure);
}
END_TEST

START_TEST(a_figure_that_could_not_be_made_is_harmless)
{
    struct thud_error err;
    struct thud_panel *panel = thud_figure_panel(NULL, 3, 3, "x");
    ck_assert_ptr_null(panel);
    thud_panel_axis(panel, THUD_X, "a", "b");
    thud_panel_mark(panel, THUD_X, 0.0, 1.0, "");
    ck_assert_ptr_null(thud_panel_add(panel, line, "a", 0, NULL, NULL));
    ck_assert_int_eq(thud_figure_check(NULL, &err), THUD_MEMORY);
    struct thud_figure *figure = thud_figure_create("f", "", 1, 1);
    panel = thud_figure_panel(figure, 0, 0, "");
    ck_assert_ptr_null(thud_panel_add(panel, line, "a", (size_t)-1 / 4, NULL, NULL)); /* more than there is */
    ck_assert_int_eq(thud_figure_check(figure, &err), THUD_MEMORY);
    thud_panel_add(panel, line, "a", 0, NULL, NULL);
    ck_assert_int_eq(panel->nseries, 0);
    thud_figure_free(figure);
}
END_TEST

START_TEST(a_closer_look_shares_the_series)
{
    struct thud_figure *figure = thud_figure_create("f", "", 2, 1);
    struct thud_panel *whole = thud_figure_panel(figure, 0, 0, "whole"),
                      *near = thud_figure_panel(figure, 1, 0, "near");
    const double x[] = {0.0, 1.0, 2.0, 3.0}, y[] = {0.0, 5.0, 1.0, 9.0};
    thud_panel_add(whole, line, "a", 4, x, y);
    thud_panel_zoom(near, whole, 0.5, 2.5);
    ck_assert_int_eq(near->nseries, 1);
    ck_assert_ptr_eq(near->series[0], whole->series[0]);
    struct thud_range range = thud_panel_range(near, THUD_X);
    ck_assert(range.least == 0.5 && range.most == 2.5);
    range = thud_panel_range(near, THUD_Y); /* the 9 is not in sight */
    ck_assert(range.most >= 5.0 && range.most < 9.0);
    ck_assert_int_eq(whole->nmarks, 1);
    thud_figure_free(figure);
}
END_TEST

START_TEST(contour_of_a_cone_is_a_circle)
{
    enum { N = 41 };
    double at[N], z[N * N];
    for (int i = 0; i < N; i++)
        at[i] = -2.0 + 0.1 * i;
    for (int j = 0; j < N; j++) {
        for (int i = 0; i < N; i++)
            z[j * N + i] = hypot(at[i], at[j]);
    }
    struct thud_figure *figure = thud_figure_create("f", "", 1, 1);
    struct thud_map *map = thud_panel_map(thud_figure_panel(figure, 0, 0, ""), N, at, N, at, z, "r", "m");
    map->level = 1.25;
    double piece[2000][4], length = 0.0, least, most;
    size_t n = thud_map_contour(map, piece, 2000);
    ck_assert_uint_gt(n, 100);
    ck_assert_uint_lt(n, 2000);
    for (size_t i = 0; i < n; i++) {
        ck_assert(fabs(hypot(piece[i][0], piece[i][1]) - 1.25) < 0.005);
        length += hypot(piece[i][2] - piece[i][0], piece[i][3] - piece[i][1]);
    }
    ck_assert(fabs(length / (2.0 * THUD_PI * 1.25) - 1.0) < 0.02);
    ck_assert(thud_map_range(map, &least, &most));
    ck_assert(fabs(most - hypot(2.0, 2.0)) < 1e-12 && least < 1e-9);
    struct thud_range range = thud_panel_range(&figure->panel[0], THUD_X); /* half a cell beyond the middles */
    ck_assert(fabs(range.least + 2.05) < 1e-9 && fabs(range.most - 2.05) < 1e-9);
    thud_figure_free(figure);
}
END_TEST

START_TEST(reduced_traces_keep_every_spike)
{
    enum { N = 100000, COLUMNS = 400 };
    double *x = malloc(N * sizeof *x), *y = malloc(N * sizeof *y);
    size_t *index = malloc(N * sizeof *index);
    for (int i = 0; i < N; i++) {
        x[i] = i * 1e-3;
        y[i] = sin(0.1 * x[i]) + (i % 7919 == 0 ? 5.0 : i % 6007 == 0 ? -4.0 : 0.0);
    }
    struct thud_reduce to = {0.0, 100.0, -5.0, 6.0, COLUMNS, 300};
    size_t n = thud_reduce(&to, N, x, y, NULL, index);
    ck_assert_uint_le(n, 2 * (COLUMNS + 1) + 2);
    ck_assert_uint_eq(index[0], 0);
    ck_assert_uint_eq(index[n - 1], N - 1);
    size_t at = 0;
    for (size_t k = 1; k < n; k++)
        ck_assert_uint_gt(index[k], index[k - 1]);
    for (size_t column = 0; column < COLUMNS; column++) { /* same envelope as all points */
        double low[2] = {9, 9}, high[2] = {-9, -9};
        for (; at < N && floor(x[at] / 100.0 * COLUMNS) == (double)column; at++) {
            low[0] = fmin(low[0], y[at]);
            high[0] = fmax(high[0], y[at]);
        }
        for (size_t k = 0; k < n; k++) {
            if (floor(x[index[k]] / 100.0 * COLUMNS) != (double)column)
                continue;
            low[1] = fmin(low[1], y[index[k]]);
            high[1] = fmax(high[1], y[index[k]]);
        }
        ck_assert(low[0] == low[1] && high[0] == high[1]);
    }
    free(x);
    free(y);
    free(index);
}
END_TEST

START_TEST(reduced_traces_keep_breaks_loops_and_what_crosses_the_limits)
{
    const double x[] = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, y[] = {0.0, 1.0, NAN, 1.0, 2.0, 1.0, 0.0};
    size_t index[1000];
    struct thud_reduce to = {0.0, 6.0, 0.0, 2.0, 1, 1};
    size_t n = thud_reduce(&to, 7, x, y, NULL, index), breaks = 0;
    for (size_t i = 0; i < n; i++)
        breaks += isnan(y[index[i]]) ? 1 : 0;
    ck_assert_uint_eq(breaks, 1);
    to = (struct thud_reduce){3.2, 4.8, 0.0, 2.0, 100, 100}; /* the lines that enter and leave */
    n = thud_reduce(&to, 7, x, y, NULL, index);
    ck_assert_uint_eq(n, 3);
    ck_assert(x[index[0]] == 3.0 && x[index[2]] == 5.0);
    double cx[1000], cy[1000];
    for (int i = 0; i < 1000; i++) {
        cx[i] = cos(0.02 * i);
        cy[i] = sin(0.02 * i);
    }
    to = (struct thud_reduce){-1.0, 1.0, -1.0, 1.0, 50, 50};
    n = thud_reduce(&to, 1000, cx, cy, NULL, index);
    ck_assert_uint_lt(n, 800);
    for (int i = 0; i < 1000; i++) { /* nothing is further than a cell's diagonal from what is drawn */
        double nearest = 9.0;
        for (size_t k = 0; k < n; k++)
            nearest = fmin(nearest, hypot(cx[i] - cx[index[k]], cy[i] - cy[index[k]]));
        ck_assert(nearest < 0.057);
    }
}
END_TEST

START_TEST(csv_says_what_its_numbers_are)
{
    struct thud_figure *figure = thud_figure_create("f", "", 1, 3);
    struct thud_panel *a = thud_figure_panel(figure, 0, 0, "A"), *b = thud_figure_panel(figure, 0, 1, "");
    const double one = 1.0, none = NAN;
    thud_panel_axis(a, THUD_X, "Time", "s");
    thud_panel_axis(a, THUD_Y, "Force", "MN");
    thud_panel_axis(b, THUD_X, "Time", "s");
    thud_panel_axis(b, THUD_Y, "Speed", "m/s");
    thud_panel_add(a, line, "", 1, &one, &none);
    thud_panel_add(b, line, "v", 1, &one, &one);
    thud_panel_zoom(thud_figure_panel(figure, 0, 2, "closer"), a, 0.0, 2.0); /* the same data again */
    struct thud_text text = {0};
    thud_figure_csv(figure, &text);
    ck_assert_str_eq(text.data, "panel,series,kind,Time (s),Force (MN),Speed (m/s)\n"
                                "A,,line,1,,\n"
                                ",v,line,1,,1\n");
    thud_text_clear(&text);
    thud_figure_free(figure);
}
END_TEST

START_TEST(csv_has_no_digits_of_a_conversion)
{
    struct thud_figure *figure = thud_figure_create("f", "", 1, 1);
    const double gap_cm = 0.145 / 0.01; /* 14.499999999999998 */
    struct thud_text text = {0};
    ck_assert_double_ne(gap_cm, 14.5);
    thud_panel_add(thud_figure_panel(figure, 0, 0, "A"), line, "a", 1, &gap_cm, &gap_cm);
    thud_figure_csv(figure, &text);
    ck_assert_str_eq(text.data, "panel,series,kind,x,y\nA,a,line,14.5,14.5\n");
    thud_text_clear(&text);
    thud_figure_free(figure);
}
END_TEST

/* Axes without a label, or called alike, have a column each. */
START_TEST(csv_keeps_variables_apart)
{
    struct thud_figure *figure = thud_figure_create("f", "", 1, 2);
    struct thud_panel *bare = thud_figure_panel(figure, 0, 0, "A"), *alike = thud_figure_panel(figure, 0, 1, "B");
    const double one = 1.0, two = 2.0;
    thud_panel_axis(alike, THUD_X, "Force", "MN");
    thud_panel_axis(alike, THUD_Y, "Force", "MN");
    thud_panel_add(bare, line, "a", 1, &one, &two);
    thud_panel_add(alike, line, "b", 1, &one, &two);
    struct thud_text text = {0};
    thud_figure_csv(figure, &text);
    ck_assert_str_eq(text.data,
                     "panel,series,kind,x,y,Force (MN),\"Force (MN), upward\"\nA,a,line,1,2,,\nB,b,line,,,1,2\n");
    thud_text_clear(&text);
    thud_figure_free(figure);
}
END_TEST

START_TEST(csv_holds_all_data_and_quotes_names)
{
    struct thud_figure *figure = thud_figure_create("f", "", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "A \"top\"");
    const double x[] = {0.1, 0.2}, low[] = {1.0 / 3.0, 2.0}, high[] = {4.0, 5.0};
    thud_panel_axis(panel, THUD_X, "Time", "s");
    thud_panel_axis(panel, THUD_Y, "Force", "MN");
    thud_panel_add(panel, line, "a,b", 2, x, low);
    thud_panel_fill(panel, line, "band", 1, x, low, high);
    struct thud_text text = {0};
    thud_figure_csv(figure, &text);
    ck_assert_str_eq(text.data, "panel,series,kind,Time (s),Force (MN),\"Force (MN), upper end\"\n"
                                "\"A \"\"top\"\"\",\"a,b\",line,0.1,0.333333333333333,\n"
                                "\"A \"\"top\"\"\",\"a,b\",line,0.2,2,\n"
                                "\"A \"\"top\"\"\",band,band,0.1,0.333333333333333,4\n");
    thud_text_clear(&text);
    thud_figure_free(figure);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("figure");
    TCase *tcase = tcase_create("figure");
    tcase_add_test(tcase, limits_are_round_and_hold_the_data);
    tcase_add_test(tcase, no_answer_lies_on_the_frame);
    tcase_add_test(tcase, limits_of_nothing_and_of_one_value);
    tcase_add_test(tcase, logarithmic_limits_are_whole_decades);
    tcase_add_test(tcase, colours_differ);
    tcase_add_test(tcase, key_follows_the_colours);
    tcase_add_test(tcase, key_names_everything_once_in_order);
    tcase_add_test(tcase, the_key_has_no_entry_without_a_curve);
    tcase_add_test(tcase, words_tell_all_curves_of_a_name);
    tcase_add_test(tcase, a_figure_that_could_not_be_made_is_harmless);
    tcase_add_test(tcase, a_closer_look_shares_the_series);
    tcase_add_test(tcase, contour_of_a_cone_is_a_circle);
    tcase_add_test(tcase, reduced_traces_keep_every_spike);
    tcase_add_test(tcase, reduced_traces_keep_breaks_loops_and_what_crosses_the_limits);
    tcase_add_test(tcase, csv_says_what_its_numbers_are);
    tcase_add_test(tcase, csv_has_no_digits_of_a_conversion);
    tcase_add_test(tcase, csv_keeps_variables_apart);
    tcase_add_test(tcase, csv_holds_all_data_and_quotes_names);
    suite_add_tcase(suite, tcase);
    return suite;
}
