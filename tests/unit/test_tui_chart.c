/* Charts in cells: whole pictures, and that no spike is lost. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tui/widgets/chart.h"

static const struct thud_chart bare = {.cursor = NAN};

static char *draw(const struct thud_panel *panel, int w, int h, bool ascii)
{
    struct thud_canvas canvas = {.ascii = ascii};
    ck_assert_int_eq(thud_canvas_resize(&canvas, w, h, NULL), THUD_OK);
    struct thud_pane page = thud_canvas_pane(&canvas);
    thud_chart_draw(&page, panel, &bare);
    char *text = thud_canvas_text(&canvas);
    thud_canvas_free(&canvas);
    ck_assert_ptr_nonnull(text);
    return text;
}

static struct thud_panel *one_panel(struct thud_figure **figure, const char *x, const char *y)
{
    *figure = thud_figure_create("test", "test", 1, 1);
    struct thud_panel *panel = thud_figure_panel(*figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, x, "s");
    thud_panel_axis(panel, THUD_Y, y, "mm");
    return panel;
}

START_TEST(a_straight_line_in_ascii)
{
    struct thud_figure *figure;
    struct thud_panel *panel = one_panel(&figure, "Time", "Drift");
    const double x[] = {0.0, 10.0}, y[] = {0.0, 10.0};
    thud_panel_limits(panel, THUD_X, 0.0, 10.0);
    thud_panel_limits(panel, THUD_Y, 0.0, 10.0);
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES}, "", 2, x, y);
    char *text = draw(panel, 24, 8, true);
    /* a row is 2.5 mm, four columns 2.5 s */
    ck_assert_str_eq(text, "Drift (mm)\n"
                           " 10 +               ..\n"
                           "7.5 +           ..''\n"
                           "  5 +       ..''\n"
                           "2.5 +   ..''\n"
                           "  0 +.''\n"
                           "    ++---+---+---+---+--\n"
                           "     0  2.5  5  7.5    s\n");
    free(text);
    thud_figure_free(figure);
}
END_TEST

/* Without room for the axis below: the title's row says from where to where it goes, or stays unchanged when full. */
START_TEST(four_rows_are_enough)
{
    struct thud_figure *figure;
    struct thud_panel *panel = one_panel(&figure, "Time", "Drift");
    const double x[] = {0.0, 10.0}, y[] = {0.0, 10.0};
    thud_panel_limits(panel, THUD_X, 0.0, 10.0);
    thud_panel_limits(panel, THUD_Y, 0.0, 10.0);
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES}, "", 2, x, y);
    char *text = draw(panel, 24, 4, true);
    ck_assert_str_eq(text, "Drift (mm)     0 to 10 s\n"
                           "10 +               .....\n"
                           "   |     .....'''''\n"
                           " 0 +.''''\n");
    free(text);
    text = draw(panel, 19, 3, true);
    ck_assert_ptr_nonnull(strstr(text, "Drift (mm)\n"));
    ck_assert_ptr_nonnull(strstr(text, "\n 0 +"));
    free(text);
    text = draw(panel, 24, 2, true);
    ck_assert_str_eq(text, "more room is needed for\n\n");
    free(text);
    thud_figure_free(figure);
}
END_TEST

/* Ticks of an axis, from the chart's text in ASCII: equally far apart, 0 among them where it is in the range, and the
 * numbers at their distances. */
static void uniform_rows(const char *text)
{
    int last = -1, apart = 0, n = 0, row = 0;
    double before = NAN, step = NAN;
    bool found = false;
    for (const char *line = text; *line; line = strchr(line, '\n') + 1, row++) {
        double value;
        char mark;
        if (sscanf(line, "%lf %c", &value, &mark) != 2 || mark != '+')
            continue;
        found = found || value == 0.0;
        if (last >= 0 && apart)
            ck_assert_msg(row - last == apart && fabs(before - value - step) < 1e-6 * step, "%s", text);
        else if (last >= 0) {
            apart = row - last;
            step = before - value;
        }
        last = row;
        before = value;
        n++;
    }
    ck_assert_msg(n >= 2 && found, "%s", text);
}

START_TEST(ticks_are_uniform_and_have_zero)
{
    for (int i = 0; i < 400; i++) {
        struct thud_figure *figure;
        struct thud_panel *panel = one_panel(&figure, "Time", "Drift");
        double low = i % 3 ? -0.013 * i * i : 0.0, high = 0.7 + 0.37 * i;
        const double x[] = {0.0, 1.0 + 0.31 * i}, y[] = {low, high};
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES}, "", 2, x, y);
        char *text = draw(panel, 40 + i % 50, 8 + i % 23, true);
        uniform_rows(text);
        const char *axis = strstr(text, " ++");
        ck_assert_ptr_nonnull(axis);
        int last = -1, apart = 0;
        for (int at = 2; axis[at] && axis[at] != '\n'; at++) {
            if (axis[at] != '+')
                continue;
            ck_assert_msg(apart == 0 || at - last == apart, "%s", text);
            apart = last >= 0 ? at - last : 0;
            last = at;
        }
        free(text);
        thud_figure_free(figure);
    }
}
END_TEST

START_TEST(values_are_read_off)
{
    struct thud_figure *figure;
    struct thud_panel *panel = one_panel(&figure, "Indentation", "Force");
    const double x[] = {0.0, 10.0, 0.0, NAN}, y[] = {0.0, 8.0, 2.0, 1.0}; /* a loop: there and back */
    struct thud_series *s = thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES}, "bare", 4, x, y);
    ck_assert_double_eq_tol(thud_chart_value(s, 2.5), 3.5, 1e-12); /* 2 on the way there */
    ck_assert_double_eq_tol(thud_chart_value(s, 10.0), 8.0, 1e-12);
    ck_assert(isnan(thud_chart_value(s, 11.0)));
    char text[200];
    thud_chart_words(panel, 5.0, text, sizeof text);
    ck_assert_str_eq(text, "Indentation 5 s:  bare 5 mm");
    thud_figure_free(figure);
}
END_TEST

START_TEST(curves_in_ascii_have_their_own_sign)
{
    struct thud_figure *figure;
    struct thud_panel *panel = one_panel(&figure, "Time", "Force");
    const double x[] = {0.0, 2.0}, a[] = {0.0, 3.0}, b[] = {2.0, 1.0};
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = 0}, "bare", 2, x, a);
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = 1}, "bumper", 2, x, b);
    char *text = draw(panel, 60, 14, true);
    int second = 0;
    for (const char *c = strchr(text, '\n'); *c; c++)
        second += *c == '2';
    ck_assert_int_gt(second, 40);
    free(text);
    thud_figure_free(figure);
}
END_TEST

/* One sample of 6000 stands out, for 25 ms of 30 s in the mean: its column reaches the top. */
START_TEST(a_spike_is_seen)
{
    enum { N = 6000 };
    static double x[N], y[N];
    for (int at = 7; at < N; at += 997) {
        struct thud_figure *figure;
        struct thud_panel *panel = one_panel(&figure, "Time", "Force");
        for (int i = 0; i < N; i++) {
            x[i] = 30.0 * i / (N - 1);
            y[i] = i == at ? 10.0 : 0.1 * sin(0.01 * i);
        }
        thud_panel_limits(panel, THUD_Y, 0.0, 10.0);
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES}, "", N, x, y);
        char *text = draw(panel, 60, 12, true);
        char *top = strchr(text, '\n') + 1, *end = strchr(top, '\n');
        *end = '\0';
        ck_assert_msg(strpbrk(top + 5, "'.:") != NULL, "sample %d is lost: %s", at, top);
        free(text);
        thud_figure_free(figure);
    }
}
END_TEST

START_TEST(curves_are_told_apart_without_colour)
{
    struct thud_figure *figure;
    struct thud_panel *panel = one_panel(&figure, "Time", "Force");
    const double x[] = {0.0, 1.0, 2.0}, a[] = {0.0, 3.0, 0.0}, b[] = {1.0, 1.0, 1.0};
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = 0}, "bare", 3, x, a);
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = 1}, "bumper", 3, x, b);
    char *text = draw(panel, 60, 14, false);
    ck_assert_ptr_nonnull(strstr(text, "1 bare  2 bumper"));
    char *plot = strchr(text, '\n');
    ck_assert_ptr_nonnull(strchr(plot, '1'));
    ck_assert_ptr_nonnull(strchr(plot, '2'));
    free(text);
    thud_figure_free(figure);
}
END_TEST

/* A shade is seen, behind its curve, and takes no number and no place in the key. */
START_TEST(a_shade_has_no_number)
{
    struct thud_figure *figure;
    struct thud_panel *panel = one_panel(&figure, "Time", "Force");
    const double x[] = {0.0, 1.0, 2.0}, a[] = {0.0, 3.0, 0.0}, high[] = {2.0, 9.0, 2.0};
    thud_panel_fill(panel, (struct thud_style){.thin = true}, "bare", 3, x, a, high);
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = 0}, "bare", 3, x, a);
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = 1}, "bumper", 3, x, a);
    const struct thud_series *key[4];
    ck_assert_int_eq(thud_figure_key(figure, key, 4), 2);
    ck_assert_int_eq(key[0]->style.kind, THUD_LINES);
    ck_assert_int_eq(thud_chart_number(panel, 1), 0);
    ck_assert_int_eq(thud_chart_number(panel, 2), 1);
    char *text = draw(panel, 60, 14, true);
    ck_assert_ptr_nonnull(strstr(text, "1 bare  2 bumper"));
    char *top = strchr(text, '\n') + 1, *end = strstr(top, "6 +"); /* only the shade goes as high */
    ck_assert_ptr_nonnull(end);
    *end = '\0';
    ck_assert_ptr_nonnull(strpbrk(top, "'.:"));
    free(text);
    thud_figure_free(figure);
}
END_TEST

START_TEST(decades_are_labelled)
{
    struct thud_figure *figure;
    struct thud_panel *panel = one_panel(&figure, "Error", "Time");
    const double x[] = {1e-8, 1e-2}, y[] = {1.0, 1000.0};
    thud_panel_log(panel, THUD_X);
    thud_panel_log(panel, THUD_Y);
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES_POINTS}, "", 2, x, y);
    char *text = draw(panel, 70, 16, true);
    ck_assert_ptr_nonnull(strstr(text, "1e-08"));
    ck_assert_ptr_nonnull(strstr(text, "1000 +"));
    ck_assert_ptr_nonnull(strchr(text, 'o'));
    free(text);
    panel->axis[THUD_X].least = 0.0; /* no decade begins there */
    free(draw(panel, 70, 16, true));
    thud_figure_free(figure);
}
END_TEST

/* No more than w columns in each of no more than h rows; frees the text. */
static void within(char *text, int w, int h)
{
    int rows = 0;
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n"), rows++)
        ck_assert_int_le(thud_utf8_columns(line), w);
    ck_assert_int_le(rows, h);
    free(text);
}

/* Nothing, one point, a constant, NaN and infinities, every size: no trap, no cell outside. */
START_TEST(hard_data_and_every_size)
{
    const double x[] = {0.0, 1.0, NAN, 2.0, 3.0, 1e300}, y[] = {NAN, 1.0, 5.0, INFINITY, -INFINITY, 1e300};
    for (int n = 0; n <= 6; n++) {
        struct thud_figure *figure;
        struct thud_panel *panel = one_panel(&figure, "Time", "Force");
        thud_panel_add(panel, (struct thud_style){.kind = (enum thud_series_kind)n}, "s", (size_t)n, x, y);
        thud_panel_mark(panel, THUD_Y, 1.0, 1.0, "one");
        for (int w = 1; w < 40; w += 3)
            for (int h = 1; h < 14; h++)
                within(draw(panel, w, h, w % 2 == 0), w, h);
        thud_figure_free(figure);
    }
}
END_TEST

/* Beside an upright mark wherever it stands, and in a band where no curve goes. */
START_TEST(words_of_marks_stay_whole)
{
    const double x[] = {0.0, 10.0}, low[] = {0.05, 0.05}, high[] = {0.9, 1.8};
    for (int i = 0; i <= 60; i++) {
        struct thud_figure *figure;
        struct thud_panel *panel = one_panel(&figure, "x", "y");
        thud_panel_limits(panel, THUD_X, 0.0, 10.0);
        thud_panel_limits(panel, THUD_Y, 0.0, 2.0);
        thud_panel_mark(panel, THUD_X, 0.1 * i, 0.1 * i, "there");
        thud_panel_mark(panel, THUD_Y, 0.0, 1.0, "within");
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES}, "", 2, x, low);
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES}, "", 2, x, high);
        char *text = draw(panel, 60, 14, i % 2 == 0);
        ck_assert_msg(strstr(text, "there") != NULL, "at %g:\n%s", 0.1 * i, text);
        ck_assert_msg(strstr(text, "within") != NULL, "at %g:\n%s", 0.1 * i, text);
        free(text);
        thud_figure_free(figure);
    }
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui chart");
    TCase *chart = tcase_create("chart");
    tcase_add_test(chart, a_straight_line_in_ascii);
    tcase_add_test(chart, four_rows_are_enough);
    tcase_add_test(chart, ticks_are_uniform_and_have_zero);
    tcase_add_test(chart, values_are_read_off);
    tcase_add_test(chart, curves_in_ascii_have_their_own_sign);
    tcase_add_test(chart, a_spike_is_seen);
    tcase_add_test(chart, words_of_marks_stay_whole);
    tcase_add_test(chart, curves_are_told_apart_without_colour);
    tcase_add_test(chart, a_shade_has_no_number);
    tcase_add_test(chart, decades_are_labelled);
    tcase_add_test(chart, hard_data_and_every_size);
    suite_add_tcase(suite, chart);
    return suite;
}
