/* Figures of a study show the table's own numbers in the right panel, on the right curve. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plot/figures/figures_case.h"
#include "plot/figures/figures_sweep.h"

enum { RECORDS = 2, GAPS = 5, DEPTHS = 3, CASES = 3 };
static const int floors[] = {4, 0, 9}; /* a wall between two buildings */

static const struct thud_param length = {
    .name = "gap", .title = "gap", .kind = THUD_PARAM_QUANTITY, .dimension = THUD_LENGTH, .unit = "cm"};
static const struct thud_param choice = {.name = "law", .title = "impact law", .kind = THUD_PARAM_CHOICE};

/* A number that says where it comes from. */
static double mark(int record, int which, int a, int b, int structure, int floor)
{
    return 0.5 + 1e-1 * record + 1e-2 * which + 1e-3 * a + 2e-5 * b + 1e-6 * structure + 1e-7 * floor;
}

struct sample {
    struct thud_sweep_table table;
    struct thud_sweep_axis axis[2];
    double gap[GAPS], depth[DEPTHS];
    char text[GAPS][THUD_NAME_MAX];
    struct thud_sweep_summary *point[RECORDS * GAPS * DEPTHS];
};

static struct thud_sweep_summary *make_point(int record, int a, int b)
{
    struct thud_sweep_summary *d = thud_sweep_summary_create(CASES, 3, floors, true);
    ck_assert_ptr_nonnull(d);
    d->record = record;
    d->at[0] = a;
    d->at[1] = b;
    d->gap_m = 0.05 * (a + 1);
    d->has_contact = true;
    for (int c = 0; c < CASES; c++) {
        d->which[c] = (enum thud_case)c;
        *thud_sweep_summary_measure(d, c, THUD_MEASURE_IMPACTS, 0, THUD_SWEEP_VALUE) = 2 * a + 1;
        *thud_sweep_summary_measure(d, c, THUD_MEASURE_FORCE, 0, THUD_SWEEP_VALUE) = 1e6 * (a + 10);
        for (int st = 0; st < 3; st++)
            for (int f = 0; f <= floors[st] && floors[st]; f++) {
                double x = mark(record, c, a, b, st, f);
                *thud_sweep_summary_ratio(d, c, st, f, THUD_SWEEP_VALUE) =
                    (struct thud_sweep_ratio){x, -x, 2 * x, -2 * x};
                *thud_sweep_summary_ratio(d, c, st, f, THUD_SWEEP_LOW) =
                    (struct thud_sweep_ratio){x - 0.01, -x - 0.02, 0, 0};
                *thud_sweep_summary_ratio(d, c, st, f, THUD_SWEEP_HIGH) =
                    (struct thud_sweep_ratio){x + 0.03, -x + 0.04, 0, 0};
            }
    }
    return d;
}

static void fill(struct sample *s, int naxes)
{
    static const char *const records[] = {"Kobe", "Northridge"}, *const structures[] = {"A", "wall", "B"};
    memset(s, 0, sizeof *s);
    for (int i = 0; i < GAPS; i++) {
        s->gap[i] = 0.05 * (i + 1);
        strcpy(s->text[i], "text of it");
    }
    for (int i = 0; i < DEPTHS; i++)
        s->depth[i] = 0.01 * i;
    s->axis[0] = (struct thud_sweep_axis){.key = "gap", .param = &length, .n = GAPS, .value = s->gap, .text = s->text};
    s->axis[1] = (struct thud_sweep_axis){
        .key = "bumper.cavity", .param = &length, .n = DEPTHS, .value = s->depth, .text = s->text};
    s->table = (struct thud_sweep_table){.nrecords = RECORDS,
                                         .nstructures = 3,
                                         .naxes = naxes,
                                         .record = records,
                                         .structure = structures,
                                         .axis = s->axis,
                                         .point = s->point};
    for (int r = 0; r < RECORDS; r++)
        for (int a = 0; a < GAPS; a++)
            for (int b = 0; b < (naxes > 1 ? DEPTHS : 1); b++) {
                struct thud_sweep_summary *d = make_point(r, a, b);
                s->point[s->table.npoints++] = d;
                s->table.nrows += (size_t)(d->nruns * d->nrows);
            }
}

static void empty(struct sample *s)
{
    for (size_t i = 0; i < RECORDS * GAPS * DEPTHS; i++)
        free(s->point[i]);
    free(s);
}

static bool near(double a, double b)
{
    return fabs(a - b) < 1e-12;
}

START_TEST(every_floor_has_its_curve)
{
    struct sample *s = malloc(sizeof *s);
    fill(s, 1);
    struct thud_figure *figure = thud_figure_by_floor(&s->table, 1, THUD_CASE_BUMPER, "x", NULL);
    ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
    ck_assert_int_eq(figure->columns, 2); /* the wall has none */
    ck_assert_str_eq(figure->panel[1].title, "9-storey building B");
    for (int q = 0; q < 2; q++) {
        const struct thud_panel *a = &figure->panel[2 * q];
        ck_assert_int_eq(a->nseries, 4);
        for (int f = 1; f <= 4; f++) {
            const struct thud_series *series = a->series[f - 1];
            char name[32];
            snprintf(name, sizeof name, "floor %d", f);
            ck_assert_str_eq(series->name, name);
            for (int i = 0; i < GAPS; i++) {
                ck_assert(near(series->x[i], 5.0 * (i + 1))); /* cm */
                ck_assert(near(series->y[i], (q ? -1.0 : 1.0) * mark(1, 1, i, 0, 0, f)));
            }
        }
    }
    /* nine floors on at most seven curves, the top one among them */
    const struct thud_panel *b = &figure->panel[1];
    ck_assert_int_le(b->nseries, THUD_COLORS);
    ck_assert_str_eq(b->series[b->nseries - 1]->name, "floor 9");
    ck_assert_str_ne(b->note, "");
    thud_figure_free(figure);
    empty(s);
}
END_TEST

/* All shades come before all curves, each with its curve's name, colour and ends. */
static void check_shades(const struct thud_figure *figure)
{
    for (int p = 0; p < 4; p++) {
        const struct thud_panel *panel = &figure->panel[p];
        ck_assert_int_eq(panel->nseries % 2, 0);
        for (int i = 0, n = panel->nseries / 2; i < n; i++) {
            const struct thud_series *shade = panel->series[i], *curve = panel->series[n + i];
            ck_assert(thud_series_is_shade(shade) && !thud_series_is_shade(curve));
            ck_assert_str_eq(shade->name, curve->name);
            ck_assert_int_eq(shade->style.color, curve->style.color);
            for (int a = 0; a < GAPS; a++) {
                ck_assert(near(shade->x[a], curve->x[a]));
                ck_assert(near(curve->y[a] - shade->y[a], p < 2 ? 0.01 : 0.02));
                ck_assert(near(shade->y_high[a] - curve->y[a], p < 2 ? 0.03 : 0.04));
            }
        }
    }
}

START_TEST(a_spread_is_a_shade_behind_its_curve)
{
    struct sample *s = malloc(sizeof *s);
    fill(s, 1);
    s->table.sensitivity = 1e-3;
    struct thud_figure *floors_shown = thud_figure_by_floor(&s->table, 0, THUD_CASE_CAVITY, "x", NULL);
    struct thud_figure *means = thud_figure_of_means(&s->table, THUD_CASE_BUMPER, "y", NULL);
    ck_assert_int_eq(thud_figure_check(floors_shown, NULL), THUD_OK);
    ck_assert_int_eq(thud_figure_check(means, NULL), THUD_OK);
    ck_assert_int_eq(floors_shown->panel[0].nseries, 8);
    check_shades(floors_shown);
    check_shades(means);
    ck_assert_ptr_nonnull(strstr(means->note, "0.1 %"));
    thud_figure_free(floors_shown);
    thud_figure_free(means);
    empty(s);
}
END_TEST

START_TEST(means_have_a_curve_per_record)
{
    struct sample *s = malloc(sizeof *s);
    fill(s, 1);
    struct thud_figure *figure = thud_figure_of_means(&s->table, THUD_CASE_CAVITY, "fig10", "T");
    const struct thud_panel *b = &figure->panel[1];
    ck_assert_int_eq(b->nseries, 2);
    ck_assert_str_eq(b->series[1]->name, "Northridge");
    for (int i = 0; i < GAPS; i++)
        ck_assert(near(b->series[1]->y[i], mark(1, 2, i, 0, 2, 0)));
    thud_figure_free(figure);
    empty(s);
}
END_TEST

static int lines_at(const struct thud_panel *panel, enum thud_side side, double at)
{
    int n = 0;
    for (int i = 0; i < panel->nmarks; i++)
        n += panel->mark[i].side == side && near(panel->mark[i].from, at) && near(panel->mark[i].to, at);
    return n;
}

/* Of a suite the median stands alone; here nine motions of which two have a result. Ratios are taken in logarithms; the
 * drifts of this sample are below 0 and are not. */
START_TEST(a_suite_has_its_median_and_band)
{
    struct sample *s = malloc(sizeof *s);
    static const char *const names[] = {"1", "2", "3", "4", "5", "6", "7", "8", "9"};
    struct thud_sweep_need_row need[18] = {{.level = {.interface = 1, .relative_displacement_m = 0.11}},
                                           {.level = {.interface = 1, .relative_displacement_m = 0.17}}};
    fill(s, 1);
    const char *const *own = s->table.record;
    s->table.nrecords = 9;
    s->table.record = names;
    s->table.need = need;
    struct thud_figure *figure = thud_figure_of_means(&s->table, THUD_CASE_BUMPER, "x", NULL);
    ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
    for (int q = 0; q < 2; q++) {
        const struct thud_panel *b = &figure->panel[2 * q + 1];
        ck_assert_int_eq(b->nseries, 2);
        ck_assert_int_eq(lines_at(b, THUD_X, 17.0), 1);
        const struct thud_series *band = b->series[0], *median = b->series[1];
        ck_assert(thud_series_is_shade(band));
        ck_assert_str_eq(median->name, "9 ground motions");
        ck_assert_int_eq(median->style.color, thud_case_color(THUD_CASE_BUMPER));
        for (int a = 0; a < GAPS; a++) {
            double low = mark(0, THUD_CASE_BUMPER, a, 0, 2, 0), high = mark(1, THUD_CASE_BUMPER, a, 0, 2, 0);
            ck_assert_double_eq_tol(median->y[a], q == 0 ? sqrt(low * high) : -0.5 * (low + high), 1e-12);
            ck_assert_double_eq_tol(band->y[a], q == 0 ? low * pow(high / low, 0.16) : -high + 0.16 * (high - low),
                                    1e-12);
            ck_assert_double_lt(band->y[a], band->y_high[a]);
        }
    }
    ck_assert_ptr_nonnull(strstr(figure->note, "under any of the motions"));
    thud_figure_free(figure);
    s->table.nrecords = RECORDS;
    s->table.record = own;
    empty(s);
}
END_TEST

/* Curves are named by event and station; where two motions say the same, or a name was given, by that name. */
START_TEST(curves_have_the_names_of_events)
{
    static struct thud_record motion[RECORDS];
    static const struct thud_record *const motions[RECORDS] = {&motion[0], &motion[1]};
    static const char *const files[RECORDS] = {"kobe.csv", "northridge.AT2"}, *const given[RECORDS] = {"one", "two"};
    static const struct {
        const char *event[RECORDS], *station[RECORDS];
        bool given;
        const char *want[RECORDS];
    } cases[] = {{{"Kobe 1995", "Northridge 1994"}, {"KJMA", ""}, false, {"Kobe 1995, KJMA", "Northridge 1994"}},
                 {{"Kobe 1995", "Kobe 1995"}, {"KJMA", "Takatori"}, false, {"Kobe 1995, KJMA", "Kobe 1995, Takatori"}},
                 {{"Kobe 1995", "Kobe 1995"}, {"KJMA", "KJMA"}, false, {"kobe", "northridge"}},
                 {{"", "Northridge 1994"}, {"KJMA", ""}, false, {"kobe", "Northridge 1994"}},
                 {{"Kobe 1995", "Northridge 1994"}, {"", ""}, true, {"one", "two"}}};
    struct sample *s = malloc(sizeof *s);
    fill(s, 1);
    s->table.motion = motions;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        for (int r = 0; r < RECORDS; r++) {
            snprintf(motion[r].file, sizeof motion[r].file, "some/where/%s", files[r]);
            snprintf(motion[r].event, sizeof motion[r].event, "%s", cases[i].event[r]);
            snprintf(motion[r].station, sizeof motion[r].station, "%s", cases[i].station[r]);
        }
        s->table.record = cases[i].given ? given : files;
        struct thud_figure *figure = thud_figure_of_means(&s->table, THUD_CASE_BUMPER, "means", NULL);
        for (int r = 0; r < RECORDS; r++)
            ck_assert_str_eq(figure->panel[0].series[r]->name, cases[i].want[r]);
        thud_figure_free(figure);
    }
    empty(s);
}
END_TEST

/* The gap from which there is no contact is a line in every figure against the gap, along whichever axis, and the note
 * says so; beyond the gaps that are shown there is none. */
START_TEST(every_figure_against_the_gap_has_its_line)
{
    struct thud_sweep_need_row need[2 * RECORDS] = {{.level = {.interface = 1, .relative_displacement_m = 0.11}},
                                                    {.level = {.interface = 1, .relative_displacement_m = 0.17}}};
    for (int round = 0; round < 4; round++) {
        const bool map = round >= 2, turned = round == 3, beyond = round == 1;
        struct sample *s = malloc(sizeof *s);
        fill(s, map ? 2 : 1);
        s->table.need = need;
        s->table.measures = THUD_HAS_BUMPER;
        need[1].level.relative_displacement_m = beyond ? 0.4 : 0.17;
        if (turned) {
            strcpy(s->axis[0].key, "bumper.cavity");
            strcpy(s->axis[1].key, "gap");
            for (int i = 0; i < DEPTHS; i++)
                s->depth[i] = 0.1 * (i + 1);
        }
        for (int i = 0; i < thud_sweep_figure_count(&s->table); i++) {
            struct thud_figure *figure = thud_sweep_figure(&s->table, i);
            for (int p = 0; p < figure->rows * figure->columns; p++)
                ck_assert_int_eq(lines_at(&figure->panel[p], turned ? THUD_Y : THUD_X, 17.0), !beyond);
            ck_assert_msg(!strstr(figure->note, "no contact without the bumper at this gap or wider") == beyond, "%s",
                          figure->note);
            thud_figure_free(figure);
        }
        empty(s);
    }
}
END_TEST

START_TEST(maps_are_the_right_way_round)
{
    struct sample *s = malloc(sizeof *s);
    fill(s, 2);
    struct thud_figure *figure = thud_figure_of_map(&s->table, 0, THUD_CASE_BUMPER, NULL, "map");
    const struct thud_map *map = figure->panel[1].map;
    ck_assert(map->nx == GAPS && map->ny == DEPTHS);
    for (int b = 0; b < DEPTHS; b++)
        for (int a = 0; a < GAPS; a++)
            ck_assert(near(map->z[b * GAPS + a], mark(0, 1, a, b, 2, 0)));
    ck_assert(near(map->y[2], 2.0) && near(map->x[4], 25.0));
    thud_figure_free(figure);
    empty(s);
}
END_TEST

START_TEST(contacts_have_a_curve_for_each_case)
{
    struct sample *s = malloc(sizeof *s);
    fill(s, 1);
    struct thud_figure *figure = thud_figure_of_contacts(&s->table, 0, "contacts");
    const struct thud_series *force = figure->panel[0].series[2], *impacts = figure->panel[1].series[2];
    ck_assert_int_eq(figure->panel[0].nseries, 3);
    ck_assert(near(force->y[3], 13.0) && near(impacts->y[3], 7.0));
    thud_figure_free(figure);
    empty(s);
}
END_TEST

/* Shares over a suite have bars beside their points, which stand off the frame. */
START_TEST(shares_have_bars)
{
    struct sample *s = malloc(sizeof *s);
    fill(s, 1);
    struct thud_sweep_shares *shares = calloc(s->table.npoints * THUD_SWEEP_CASES_MAX, sizeof *shares);
    for (size_t i = 0; i < s->table.npoints * THUD_SWEEP_CASES_MAX; i++)
        shares[i] = (struct thud_sweep_shares){.pounding = 1, .pounding_band = {0.6, 1}, .worse_band = {NAN, NAN}};
    s->table.shares = shares;
    s->table.motions = 4;
    struct thud_figure *figure = thud_figure_of_contacts(&s->table, 0, "contacts");
    const struct thud_panel *panel = &figure->panel[1];
    int bars = 0;
    for (int i = 0; i < panel->nseries; i++)
        if (!*panel->series[i]->name) {
            ck_assert(near(panel->series[i]->y[0], 60) && near(panel->series[i]->y[1], 100));
            bars++;
        }
    ck_assert_int_ge(bars, 2 * GAPS);
    ck_assert(panel->axis[THUD_Y].least < 0 && panel->axis[THUD_Y].most > 100);
    thud_figure_free(figure);
    s->table.shares = NULL;
    free(shares);
    empty(s);
}
END_TEST

/* Ratios to no pounding have a figure of every case, and are what a study without bumper shows. */
START_TEST(pounding_is_shown_without_a_bumper)
{
    struct sample *s = malloc(sizeof *s);
    fill(s, 1);
    struct thud_figure *figure = thud_figure_of_pounding(&s->table, 1, "pounding");
    const struct thud_panel *b = &figure->panel[1];
    ck_assert_int_eq(b->nseries, 3);
    ck_assert_str_eq(b->series[0]->name, "pounding");
    for (int i = 0; i < GAPS; i++)
        ck_assert(near(b->series[2]->y[i], 2 * mark(1, 2, i, 0, 2, 0)));
    thud_figure_free(figure);
    for (size_t i = 0; i < s->table.npoints; i++)
        s->point[i]->nruns = 1; /* case none alone */
    ck_assert_int_eq(thud_sweep_figure_count(&s->table), RECORDS + 2 * RECORDS);
    const int settings = s->axis[0].n;
    s->axis[0].n = 1; /* one setting is no curve: its numbers stand in the tables */
    ck_assert_int_eq(thud_sweep_figure_count(&s->table), 0);
    s->axis[0].n = settings;
    figure = thud_sweep_figure(&s->table, 0);
    ck_assert_str_eq(figure->name, "floors-none-1");
    for (int i = 0; i < GAPS; i++)
        ck_assert(near(figure->panel[0].series[1]->y[i], 2 * mark(0, 0, i, 0, 0, 2)));
    thud_figure_free(figure);
    empty(s);
}
END_TEST

/* Figures 8 and 10 are there to be compared: accelerations on the scale of both, deflections on theirs. */
START_TEST(means_of_two_cases_share_their_axes)
{
    struct sample *s = malloc(sizeof *s);
    fill(s, 1);
    struct thud_figure *one = thud_figure_of_means(&s->table, THUD_CASE_BUMPER, "fig8", "T"),
                       *two = thud_figure_of_means(&s->table, THUD_CASE_CAVITY, "fig10", "T");
    for (int p = 0; p < 4; p++) {
        const struct thud_axis *a = &one->panel[p].axis[THUD_Y], *b = &two->panel[p].axis[THUD_Y];
        ck_assert(a->least == b->least && a->most == b->most && a->least < a->most);
    }
    ck_assert(one->panel[0].axis[THUD_Y].least != one->panel[2].axis[THUD_Y].least); /* these are negative here */
    thud_figure_free(one);
    thud_figure_free(two);
    empty(s);
}
END_TEST

/* A ratio of exactly 1 where there is no contact is a plain without a line around it. */
START_TEST(no_line_runs_along_a_plain)
{
    const double at[] = {0, 1, 2, 3}, z[] = {0.9, 1, 1, 1, 0.9, 1, 1, 1, 1.1, 1, 1, 1, 1.1, 1.2, 1, 1};
    struct thud_figure *figure = thud_figure_create("m", "", 1, 1);
    struct thud_map *map = thud_panel_map(thud_figure_panel(figure, 0, 0, ""), 4, at, 4, at, z, "ratio", "");
    map->level = 1;
    ck_assert_uint_eq(thud_map_contour(map, NULL, 0), 0);
    map->z[5] = 1.01;
    map->z[1] = 1.01;
    ck_assert_uint_gt(thud_map_contour(map, NULL, 0), 0); /* between 0.9 and 1.01 */
    thud_figure_free(figure);
}
END_TEST

/* A building that yields and one that does not; columns with a capacity and without. */
START_TEST(ductility_and_columns_have_figures)
{
    struct sample *s = malloc(sizeof *s);
    fill(s, 1);
    int plain = thud_sweep_figure_count(&s->table);
    for (size_t i = 0; i < s->table.npoints; i++)
        for (int c = 0; c < CASES; c++) {
            struct thud_sweep_summary *d = s->point[i];
            double x = mark(d->record, c, d->at[0], 0, 2, 0);
            *thud_sweep_summary_measure(d, c, THUD_MEASURE_DUCTILITY, 2, THUD_SWEEP_VALUE) = x;
            *thud_sweep_summary_measure(d, c, THUD_MEASURE_PERMANENT, 2, THUD_SWEEP_VALUE) = 2 * x;
            *thud_sweep_summary_measure(d, c, THUD_MEASURE_SHEAR, 0, THUD_SWEEP_VALUE) = 1e6 * x;
        }
    ck_assert_int_eq(thud_sweep_figure_count(&s->table), plain + 2 * RECORDS);
    struct thud_figure *figure = thud_sweep_figure(&s->table, plain + 2 * RECORDS - 2);
    ck_assert_str_eq(figure->name, "yielding-2");
    ck_assert(figure->rows == 2 && figure->columns == 1);
    ck_assert_str_eq(figure->panel[0].title, "9-storey building B");
    ck_assert_int_eq(figure->panel[0].nseries, CASES);
    for (int i = 0; i < GAPS; i++) {
        ck_assert(near(figure->panel[0].series[1]->y[i], mark(1, 1, i, 0, 2, 0)));
        ck_assert(near(figure->panel[1].series[2]->y[i], 2e3 * mark(1, 2, i, 0, 2, 0))); /* mm */
    }
    thud_figure_free(figure);
    figure = thud_sweep_figure(&s->table, plain + 2 * RECORDS - 1);
    ck_assert_str_eq(figure->name, "struck-columns-2");
    ck_assert_int_eq(figure->columns, 1);
    for (int i = 0; i < GAPS; i++)
        ck_assert(near(figure->panel[0].series[0]->y[i], mark(1, 0, i, 0, 2, 0))); /* MN */
    thud_figure_free(figure);
    *thud_sweep_summary_measure(s->point[0], 1, THUD_MEASURE_COLUMNS, 0, THUD_SWEEP_VALUE) = 3;
    figure = thud_sweep_figure(&s->table, plain - 1); /* of the first ground motion */
    ck_assert_str_eq(figure->name, "struck-columns-1");
    ck_assert_int_eq(figure->columns, 2);
    ck_assert(figure->panel[1].series[1]->y[0] == 3 && isnan(figure->panel[1].series[1]->y[1]));
    ck_assert(figure->panel[1].nmarks == 1 && figure->panel[1].mark[0].from == 1);
    thud_figure_free(figure);
    empty(s);
}
END_TEST

START_TEST(the_list_holds_each_figure_once)
{
    for (int naxes = 1; naxes <= 2; naxes++) {
        struct sample *s = malloc(sizeof *s);
        fill(s, naxes);
        int n = thud_sweep_figure_count(&s->table);
        ck_assert_int_eq(n, naxes == 1 ? 2 * (RECORDS + 1) + 2 * RECORDS : 2 * RECORDS);
        char names[16][64];
        for (int i = 0; i < n; i++) {
            struct thud_figure *figure = thud_sweep_figure(&s->table, i);
            ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
            snprintf(names[i], sizeof names[i], "%s", figure->name);
            for (int j = 0; j < i; j++)
                ck_assert_str_ne(names[i], names[j]);
            thud_figure_free(figure);
        }
        s->table.nrows = 0;
        ck_assert_int_eq(thud_sweep_figure_count(&s->table), 0);
        empty(s);
    }
}
END_TEST

START_TEST(words_stand_where_there_are_no_numbers)
{
    struct sample *s = malloc(sizeof *s);
    fill(s, 1);
    s->axis[0].param = &choice;
    s->axis[0].words = true;
    for (int i = 0; i < GAPS; i++)
        s->gap[i] = i;
    struct thud_figure *figure = thud_figure_of_means(&s->table, THUD_CASE_BUMPER, "x", NULL);
    const struct thud_axis *axis = &figure->panel[0].axis[THUD_X];
    ck_assert_int_eq(axis->nticks, GAPS);
    ck_assert_str_eq(axis->tick[0].text, "text of it");
    ck_assert_str_eq(axis->label, "Impact law");
    ck_assert(near(figure->panel[0].series[0]->x[2], 3.0));
    ck_assert(near(figure->panel[0].series[0]->y[2], mark(0, 1, 2, 0, 0, 0)));
    ck_assert(axis->least == 0.5 && axis->most == GAPS + 0.5);
    thud_figure_free(figure);
    empty(s);
}
END_TEST

/* The same map with words on one side: the same numbers, but no line of equal ratio, for nothing lies between words. */
START_TEST(no_line_runs_between_words)
{
    struct sample *s = malloc(sizeof *s);
    fill(s, 2);
    for (int words = 0; words <= 1; words++) {
        if (words) {
            s->axis[1].param = &choice;
            s->axis[1].words = true;
            for (int i = 0; i < DEPTHS; i++)
                s->depth[i] = i;
        }
        struct thud_figure *figure = thud_figure_of_map(&s->table, 0, THUD_CASE_BUMPER, NULL, "x");
        const struct thud_map *map = figure->panel[0].map;
        for (int a = 0; a < GAPS; a++)
            for (int b = 0; b < DEPTHS; b++)
                ck_assert(near(map->z[b * GAPS + a], mark(0, 1, a, b, 0, 0)));
        ck_assert(near(map->y[1], words ? 2.0 : 1.0));
        ck_assert_int_eq(isnan(map->level), words);
        ck_assert_int_eq(strstr(figure->note, "line") != NULL, !words);
        thud_figure_free(figure);
    }
    empty(s);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("figures_sweep");
    TCase *tcase = tcase_create("figures_sweep");
    tcase_add_test(tcase, every_floor_has_its_curve);
    tcase_add_test(tcase, a_spread_is_a_shade_behind_its_curve);
    tcase_add_test(tcase, means_have_a_curve_per_record);
    tcase_add_test(tcase, a_suite_has_its_median_and_band);
    tcase_add_test(tcase, curves_have_the_names_of_events);
    tcase_add_test(tcase, every_figure_against_the_gap_has_its_line);
    tcase_add_test(tcase, maps_are_the_right_way_round);
    tcase_add_test(tcase, contacts_have_a_curve_for_each_case);
    tcase_add_test(tcase, shares_have_bars);
    tcase_add_test(tcase, pounding_is_shown_without_a_bumper);
    tcase_add_test(tcase, means_of_two_cases_share_their_axes);
    tcase_add_test(tcase, no_line_runs_along_a_plain);
    tcase_add_test(tcase, ductility_and_columns_have_figures);
    tcase_add_test(tcase, the_list_holds_each_figure_once);
    tcase_add_test(tcase, words_stand_where_there_are_no_numbers);
    tcase_add_test(tcase, no_line_runs_between_words);
    suite_add_tcase(suite, tcase);
    return suite;
}
