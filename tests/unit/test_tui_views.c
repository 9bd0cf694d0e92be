/* What single screens do with single keys: orders of the impacts, the ground motion's curves, the study's figures and
 * panels, clicks, walls and rows of several structures. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ground/spectrum.h"
#include "remarks.h"
#include "study/sweep/remark.h"
#include "tui/screens/sweep_screen.h"
#include "tui_fixture.h"

static struct fixture f;

static void setup(void)
{
    fixture_open(&f, "towers", 80, 24, false);
}

static void teardown(void)
{
    fixture_close(&f);
}

/* The impacts in the order in which they stand on the screen. */
static int impacts_shown(const struct thud_impact *shown[], int most)
{
    int count, n = 0;
    const struct thud_impact *impact = thud_run_impacts(f.tui->run.live.which[THUD_LIVE_BUMPER].run, &count);
    for (int i = 0; i < f.tui->form.n && n < most; i++) {
        double start;
        int contact;
        if (sscanf(f.tui->form.field[i].path, "impact %lf %d", &start, &contact) != 2)
            continue;
        for (int k = 0; k < count; k++)
            if (impact[k].contact == contact && fabs(impact[k].start_s - start) < 1e-6)
                shown[n] = &impact[k];
        ck_assert_ptr_nonnull(shown[n]);
        n++;
    }
    ck_assert_int_eq(n, count);
    return n;
}

/* Ductility and permanent drift stand beside the other quantities only where a storey yields. */
START_TEST(storeys_that_yield_have_two_quantities_more)
{
    fixture_keys(&f, "<A-4>cc");
    fixture_expect_not(&f, "ductility");
    fixture_keys(&f, "cc:set structures.1.yield 15 mm<Enter><A-4>cc");
    fixture_expect(&f, "ductility");
    fixture_expect(&f, "permanent drift mm");
    const struct thud_result *r = thud_run_result(f.tui->run.live.which[THUD_LIVE_NONE].run);
    char ductility[24];
    thud_tui_number(r->structure[0].storey[0].ductility, ductility);
    ck_assert_int_gt(r->structure[0].storey[0].excursions, 0);
    fixture_expect(&f, ductility);
}
END_TEST

START_TEST(impacts_stand_in_three_orders)
{
    fixture_keys(&f, "<Size 100x60><A-4><Tab>");
    for (int sort = 0; sort < 3; sort++) {
        static const char *const titles[] = {"by time", "by force", "by floor"};
        const struct thud_impact *shown[200] = {NULL};
        fixture_expect(&f, titles[sort]);
        int n = impacts_shown(shown, 200);
        ck_assert_int_gt(n, 4);
        for (int i = 1; i < n; i++) {
            const struct thud_impact *a = shown[i - 1], *b = shown[i];
            if (sort == 0)
                ck_assert(a->start_s <= b->start_s);
            else if (sort == 1)
                ck_assert(a->force_n >= b->force_n);
            else
                ck_assert(a->contact < b->contact || (a->contact == b->contact && a->start_s <= b->start_s));
        }
        fixture_keys(&f, "s");
    }
    fixture_expect(&f, "by time");
}
END_TEST

START_TEST(a_run_that_fails_says_which_case_and_when)
{
    fixture_keys(&f, ":set contact.stiffness 1e15 kN/mm<Enter>:method central-difference<Enter>:step 1e-3 s<Enter>");
    fixture_expect(&f, "! FAILED (no bumper) at t = ");
    ck_assert_int_eq((int)f.tui->run.live.which[THUD_LIVE_FREE].state, THUD_LIVE_DONE);
    fixture_keys(&f, "<A-4>");
    fixture_expect(&f, "FAIL");
}
END_TEST

START_TEST(a_wall_moves_with_the_ground)
{
    fixture_keys(&f, ":set structures.2.kind wall<Enter>");
    fixture_expect(&f, "B moves with the ground");
    fixture_expect(&f, "A accel");
    fixture_expect_not(&f, "B accel");
    fixture_keys(&f,
                 ":set structures.2.mass 27 t<Enter>:set structures.2.stiffness 40 MN/m<Enter>"); /* one that gives */
    fixture_expect(&f, "B accel");
    fixture_expect_not(&f, "B moves with the ground");
    fixture_keys(&f, "uu<Size 120x40><A-5><Home>"); /* and is drawn in the movement, as an open end */
    char *without = fixture_text(&f);
    fixture_keys(&f, ":set structures.2.height 4 m<Enter><Home>");
    char *with = fixture_text(&f);
    ck_assert_str_ne(without, with);
    free(without);
    free(with);
}
END_TEST

/* With a third structure an impact says between which two it was, and a field is found wherever it stands. */
START_TEST(several_structures)
{
    fixture_keys(&f, "<Right>A");
    ck_assert_int_eq(f.tui->doc.scene.nstructures, 3);
    fixture_keys(&f, "<Size 100x40><A-4>");
    fixture_expect(&f, " 1:1 ");
    fixture_keys(&f, "<A-1>");
    f.tui->interface = 0;
    fixture_keys(&f, "/structures.3.damping<Enter>");
    ck_assert_int_eq(f.tui->interface, 1);
    fixture_expect(&f, "\n 2 of 2: "); /* the answer is that of one gap */
    ck_assert_str_eq(thud_form_focus(&f.tui->form)->path, "structures.3.damping");
    fixture_keys(&f, "/interfaces.1.gap<Enter>");
    ck_assert_int_eq(f.tui->interface, 0);
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_CONTACT);
    fixture_keys(&f, "]<A-1>D"); /* the pair to the right goes with its structure */
    ck_assert_int_eq(f.tui->doc.scene.nstructures, 2);
    ck_assert_int_eq(f.tui->interface, 0);
    fixture_expect_not(&f, " of 1: ");
}
END_TEST

static void click_on(const char *text)
{
    char *screen = fixture_text(&f), keys[40];
    const char *at = strstr(screen, text), *line = screen;
    int y = 0;
    ck_assert_msg(at != NULL, "%s", text);
    for (const char *p = screen; p < at; p++)
        if (*p == '\n') {
            y++;
            line = p + 1;
        }
    snprintf(keys, sizeof keys, "<Click %d,%d>", (int)(at - line), y); /* the screen is ASCII */
    free(screen);
    fixture_keys(&f, keys);
}

START_TEST(clicks_go_to_fields)
{
    fixture_keys(&f, "<A-2>");
    click_on("restitution");
    ck_assert_str_eq(thud_form_focus(&f.tui->form)->path, "interfaces.1.contact.restitution");
    click_on("cavity");
    ck_assert_str_eq(thud_form_focus(&f.tui->form)->path, "interfaces.1.bumper.cavity");
    fixture_keys(&f, "<A-1>");
    int pane = f.tui->form.pane[THUD_SCREEN_MODEL];
    click_on("Right: B");
    ck_assert_int_ne(f.tui->form.pane[THUD_SCREEN_MODEL], pane);
    fixture_keys(&f, "<Click 0,0><Click 79,23>"); /* outside of every pane nothing happens */
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_MODEL);
    fixture_keys(&f, "<Click 0,5>");
    ck_assert_int_eq(f.tui->form.pane[THUD_SCREEN_MODEL], pane);
}
END_TEST

static void click_at(int x, int y)
{
    char keys[32];
    snprintf(keys, sizeof keys, "<Click %d,%d>", x, y);
    fixture_keys(&f, keys);
}

/* A floor that is drawn leads to its row: on Model, and where the buildings move. */
START_TEST(clicks_on_floors_go_to_their_rows)
{
    const struct thud_field *field;
    int floor = 0, before = 0, y, seen = 0;
    fixture_keys(&f, "<Size 100x60>");
    for (y = 16; y < 45; y++) { /* downwards the floors go down, and none is left out */
        click_at(54, y);
        field = thud_form_focus(&f.tui->form);
        if (!field || sscanf(field->path, "structures.2.mass.%d", &floor) != 1)
            continue;
        ck_assert(before == 0 || floor == before || floor == before - 1);
        seen += floor != before;
        before = floor;
    }
    ck_assert_int_eq(seen, 3);
    fixture_keys(&f, "5<Size 80x24>");
    seen = before = 0;
    for (y = 3; y < 20; y++) {
        fixture_keys(&f, "5");
        click_at(71, y);
        if (f.tui->screen != THUD_SCREEN_MODEL)
            continue;
        field = thud_form_focus(&f.tui->form);
        ck_assert_int_eq(sscanf(field->path, "structures.2.mass.%d", &floor), 1);
        ck_assert(before == 0 || floor == before || floor == before - 1);
        seen += floor != before;
        before = floor;
    }
    ck_assert_int_eq(seen, 3);
}
END_TEST

/* Of figures of a study the motion's name stands before what tells them apart, and begins with a capital. */
START_TEST(figures_are_called_by_what_tells_them_apart)
{
    static const char *const title[][2] = {{"Surrogate for X, 000: amplification", "amplification"},
                                           {"Two towers: energy", "energy"},
                                           {"Surrogate for X, 000", "Surrogate for X, 000"},
                                           {"Surrogate", "Surrogate"}};
    snprintf(f.tui->doc.record->event, sizeof f.tui->doc.record->event, "surrogate for X");
    snprintf(f.tui->doc.record->station, sizeof f.tui->doc.record->station, "000");
    f.tui->doc.record->component[0] = '\0';
    snprintf(f.tui->doc.scene.title, sizeof f.tui->doc.scene.title, "Two towers");
    for (int i = 0; i < 4; i++) {
        struct thud_figure *figure = thud_figure_create("x", title[i][0], 1, 1);
        ck_assert_str_eq(thud_tui_figure_title(f.tui, figure), title[i][1]);
        thud_figure_free(figure);
    }
}
END_TEST

/* With the button down on a number each column is a step, whether the cursor was there before or not: one
 * change, also by way of where it began. A text stays. */
START_TEST(numbers_are_dragged)
{
    static const char *const path[] = {"interfaces.1.bumper.thickness", "interfaces.1.contact.stiffness",
                                       "interfaces.1.gap-by-level"};
    char keys[200], text[64], old[64];
    fixture_keys(&f, "<Size 130x40>2");
    for (int i = 0; i < 3; i++)
        for (int again = 0; again < 2; again++) {
            const struct thud_field *field = f.tui->form.field;
            while (strcmp(field->path, path[i]) != 0)
                field++;
            const int x = field->x + 1, y = field->y + 4; /* two lines above the pane, and its frame */
            const unsigned long revision = f.tui->doc.revision;
            ck_assert_int_eq(thud_scene_get(&f.tui->doc.scene, path[i], old, sizeof old, NULL), THUD_OK);
            snprintf(keys, sizeof keys, "<Click %d,%d><Drag %d,%d><Drag %d,%d><Drag %d,%d>", x, y, x + 1, y, x, y,
                     x + 3, y);
            fixture_keys(&f, keys);
            ck_assert_int_eq(thud_scene_get(&f.tui->doc.scene, path[i], text, sizeof text, NULL), THUD_OK);
            if (i == 2) {
                ck_assert_uint_eq(f.tui->doc.revision, revision);
                fixture_keys(&f, "<Esc>");
                continue;
            }
            const double from = strtod(old, NULL), step = pow(10, floor(log10(from) + 1e-9) - 1);
            ck_assert_double_eq_tol(strtod(text, NULL), from + 3 * step, 1e-9 * from);
            fixture_keys(&f, "u");
            ck_assert_int_eq(thud_scene_get(&f.tui->doc.scene, path[i], text, sizeof text, NULL), THUD_OK);
            ck_assert_str_eq(text, old);
        }
}
END_TEST

/* The wheel keeps what is under the pointer there, dragging moves all by as many columns, keys go on beyond the edge;
 * of a logarithmic axis as well. */
START_TEST(charts_are_zoomed_and_moved)
{
    fixture_keys(&f, "3ccc<Tab>z"); /* the spectrum */
    const struct thud_chart_frame *frame = &f.tui->chart;
    struct thud_chart_window *window = &f.tui->window[THUD_SCREEN_RECORD];
    ck_assert(frame->x_log);
    ck_assert_double_eq_tol(log(window->to / window->from), log(10 / 0.02) / 3.0, 1e-9);
    fixture_keys(&f, "Z");
    ck_assert_double_eq(window->to, 0.0);
    char keys[64];
    int x = frame->plot.x + frame->plot.w / 2, y = frame->plot.y + 1;
    double along = (double)(frame->plot.w / 2) / (frame->plot.w - 1), at = thud_chart_at(&frame->x, true, along);
    snprintf(keys, sizeof keys, "<WheelUp %d,%d>", x, y);
    fixture_keys(&f, keys);
    ck_assert_double_eq_tol(thud_chart_at(&frame->x, true, along), at, 1e-9 * at);
    snprintf(keys, sizeof keys, "<Click %d,%d><Drag %d,%d>", x, y, x + 5, y);
    fixture_keys(&f, keys);
    along += 5.0 / (frame->plot.w - 1);
    ck_assert_double_eq_tol(thud_chart_at(&frame->x, true, along), at, 1e-9 * at);
    ck_assert(isnan(f.tui->reading[THUD_SCREEN_RECORD]));
    snprintf(keys, sizeof keys, "<Click %d,%d>", frame->plot.x + frame->plot.w - 1, y);
    fixture_keys(&f, keys);
    double most = window->to;
    fixture_keys(&f, "<Right><Right>");
    ck_assert_double_gt(window->to, most);
    ck_assert_double_ge(f.tui->reading[THUD_SCREEN_RECORD], most);
    fixture_keys(&f, "1z");
    fixture_expect(&f, "There is no chart to be read here");
}
END_TEST

/* 40 s of a motion that is strong from 20 to 22 s: the first look is at those. */
START_TEST(plots_open_on_the_strong_motion)
{
    static char text[80000];
    size_t n = (size_t)snprintf(text, sizeof text, "time_s,acceleration_g\n");
    for (int i = 0; i <= 4000; i++)
        n += (size_t)snprintf(text + n, sizeof text - n, "%.2f,%.6f\n", 0.01 * i,
                              (i >= 2000 && i <= 2200 ? 1.0 : 0.001) * sin(2.0 * 3.14159265358979 * 0.01 * i / 0.4));
    fixture_write(&f, "long.csv", text);
    fixture_keys(&f, ":record long.csv<Enter>5");
    const struct thud_chart_window *window = &f.tui->window[THUD_SCREEN_PLOTS];
    ck_assert_double_gt(window->from, 19.0);
    ck_assert_double_lt(window->from, 20.2);
    ck_assert_double_gt(window->to, 21.8);
    ck_assert_double_lt(window->to, 24.0);
    fixture_expect(&f, "zoom");
    fixture_keys(&f, "ZZZ");
    fixture_expect_not(&f, "zoom");
}
END_TEST

/* The floors by height, or the largest first; both tables only where a text stands. */
START_TEST(tables_are_sorted_and_filtered)
{
    fixture_keys(&f, "4s");
    double last = INFINITY;
    int rows = 0, s, floor;
    for (int i = 0; i < f.tui->form.n; i++)
        if (sscanf(f.tui->form.field[i].path, "floor %d %d", &s, &floor) == 2) {
            double value = thud_live_floor(&f.tui->run.live, THUD_LIVE_BUMPER, s, floor, THUD_PEAK_ACCELERATION);
            ck_assert_double_le(value, last);
            last = value;
            rows++;
        }
    ck_assert_int_eq(rows, 5);
    fixture_keys(&f, "sfB<Enter>");
    rows = 0;
    for (int i = 0; i < f.tui->form.n; i++)
        rows += strncmp(f.tui->form.field[i].path, "floor 1", 7) == 0 ||
                strncmp(f.tui->form.field[i].path, "impact", 6) == 0;
    ck_assert_int_eq(rows, 3);
    fixture_keys(&f, "f<C-u>nothing<Enter>");
    fixture_expect(&f, "no floor's name has");
    fixture_keys(&f, "f<C-u><Enter>");
    fixture_expect(&f, "A 2");
}
END_TEST

/* The spectrum on the screen is that of the record: its largest value, and where it is drawn. */
START_TEST(the_ground_motion_has_four_curves)
{
    fixture_keys(&f, "<A-3>");
    static const char *const words[] = {"Acceleration (g)", "Velocity (m/s)", "Displacement (m)", "Sa, 5 % damped (g)"};
    for (int i = 0; i < 4; i++) {
        fixture_expect(&f, words[i]);
        if (i < 3)
            fixture_keys(&f, "c");
    }
    fixture_expect(&f, "Period (s)");
    fixture_keys(&f, "e");
    fixture_expect(&f, "towers-spectrum-gap-20mm.csv");
    char *csv = fixture_file(&f, "towers-spectrum-gap-20mm.csv");
    ck_assert_ptr_nonnull(csv);
    int n = 0;
    for (const char *line = strchr(csv, '\n'); line && line[1]; line = strchr(line + 1, '\n')) {
        double period, sa;
        if (sscanf(line + 1, ",,%*[a-z],%lf,%lf", &period, &sa) != 2)
            continue;
        struct thud_spectrum_point point[2]; /* from this period on */
        thud_spectrum_fill(f.tui->doc.record, 0.05, period, 2 * period, 2, point);
        if (n % 10 == 0)
            ck_assert_double_eq_tol(sa, point[0].acceleration_mps2 / 9.80665, 1e-6 * sa);
        n++;
    }
    ck_assert_int_eq(n, 200);
    free(csv);
    fixture_keys(&f, "c");
    fixture_expect(&f, words[0]);
}
END_TEST

START_TEST(a_study_has_figures_and_panels)
{
    fixture_keys(&f, ":live off<Enter><A-6>P");
    fixture_expect(&f, "There is no figure yet: r runs");
    fixture_keys(&f, "]");
    fixture_expect(&f, "There is no figure yet: r runs the study");
    fixture_keys(&f, "<Enter><C-u>gap=1 cm:2 cm:1 cm<Enter>");
    fixture_keys(&f, "r");
    const struct thud_sweep_state *s = thud_sweep_state(f.tui);
    fixture_expect(&f, "1/4 ");
    fixture_keys(&f, "c");
    fixture_expect(&f, "2/4 ");
    ck_assert_int_eq(s->panel, -1);
    int panels = s->shown->rows * s->shown->columns;
    for (int i = 0; i < panels; i++) {
        fixture_keys(&f, "]");
        ck_assert_int_eq(s->panel, i);
    }
    fixture_keys(&f, "]");
    ck_assert_int_eq(s->panel, -1); /* all of them again */
    fixture_keys(&f, "[");
    ck_assert_int_eq(s->panel, panels - 1);
    fixture_keys(&f, "ccc");
    fixture_expect(&f, "1/4 ");
    f.tui->options.gnuplot = "/nowhere/gnuplot";
    fixture_keys(&f, "P");
    fixture_expect(&f, "was not found");
    char *script = fixture_file(&f, "towers-means-bumper.gp"); /* to be drawn by hand */
    ck_assert_ptr_nonnull(script);
    free(script);
}
END_TEST

START_TEST(what_there_is_not_is_said)
{
    fixture_keys(&f, ":set gap 200 cm<Enter><A-4><Size 100x40>");
    fixture_expect(&f, "none: the structures do not meet");
    fixture_keys(
        &f, ":set gap 2 cm<Enter><A-6><Enter><C-u>gap=0.5 cm:1.5 cm:1 cm<Enter>:records pulse.csv,pulse.csv<Enter>");
    fixture_keys(&f, "r");
    fixture_expect(&f, "4 of 4 points");
    fixture_expect(&f, "2 not possible (bumper > gap)");
    fixture_keys(&f, ":set gap 4 cm<Enter>");
    fixture_lose_motion(&f);
    fixture_keys(&f, "r");
    fixture_expect(&f, "gone.csv");
    fixture_expect_not(&f, "4 of 4 points");
}
END_TEST

/* Rows of the movement below what it calls the case, right of the parameters. */
static void stage_rows(const char *called, char *rows, size_t size)
{
    enum { RIGHT_OF = 40 };
    char *text = fixture_text(&f), *at = strstr(text, called);
    ck_assert_ptr_nonnull(at);
    for (strtok(at, "\n"), rows[0] = '\0'; (at = strtok(NULL, "\n")) && strlen(at) > RIGHT_OF && *at == '|';)
        thud_append(rows, size, "%s\n", at + RIGHT_OF);
    free(text);
}

/* The case without the links draws the soil behind a wall as the scene without links does: it stands behind the links
 * of the one, and first of the other. */
START_TEST(soil_is_drawn_without_the_links)
{
    char with[4000], without[4000];
    fixture_keys(&f, "<Size 120x40>:structures.1.kind=wall<Enter>:structures.1.backfill.strength=3MN<Enter>");
    fixture_keys(&f, ":link add 1<Enter><A-5><Home>bb");
    stage_rows("|neither bumper nor links  ", with, sizeof with);
    fixture_keys(&f, ":link remove 1<Enter>");
    stage_rows("|no bumper  ", without, sizeof without);
    ck_assert_ptr_nonnull(strstr(without, "mm across"));
    ck_assert_str_eq(with, without);
}
END_TEST

/* The long forms of what keys do. */
START_TEST(commands_of_the_command_line)
{
    char keys[200];
    snprintf(keys, sizeof keys, ":set gap 3 cm<Enter>:write %s/other.yaml<Enter>", f.folder);
    fixture_keys(&f, keys);
    char *text = fixture_file(&f, "other.yaml");
    ck_assert_ptr_nonnull(text);
    ck_assert_ptr_nonnull(strstr(text, "gap: 3 cm"));
    ck_assert_ptr_nonnull(strstr(text, "# concrete to concrete"));
    free(text);
    f.tui->options.gnuplot = "/nowhere/gnuplot";
    fixture_keys(&f, ":figures<Enter>");
    fixture_expect(&f, "was not found");
    fixture_keys(&f, ":wrte<Enter>");
    fixture_expect(&f, "did you mean :write?");
    snprintf(f.paths.presets, sizeof f.paths.presets, "/nowhere");
    fixture_keys(&f, "o");
    fixture_expect(&f, "! the presets' folder /nowhere cannot be read");
    fixture_keys(&f, "<Esc>:set gap 4 cm<Enter>:q<Enter>n");
    ck_assert(!f.tui->end.quit);
    fixture_keys(&f, ":q<Enter>y");
    ck_assert(f.tui->end.quit);
}
END_TEST

/* Of the table of floors 80 columns show four: the cursor leads to the others, Tab does not. */
START_TEST(the_cursor_leads_to_every_column_of_floors)
{
    fixture_keys(&f, "<Size 80x24>1/structures.1.mass.2<Enter>");
    fixture_expect(&f, "mass t");
    fixture_expect_not(&f, "cap. kN");
    fixture_keys(&f, "<Right><Right><Right>");
    fixture_expect(&f, "mass t");
    fixture_keys(&f, "<Right><Right><Right><Right>");
    ck_assert_str_eq(f.tui->form.focus[THUD_SCREEN_MODEL], "structures.1.column.capacity.2");
    fixture_expect(&f, "cap. kN");
    fixture_keys(&f, "<Enter>900<Enter>");
    ck_assert_double_eq_tol(f.tui->doc.scene.structure[0].column_capacity_n[1], 9e5, 1e-6);
    fixture_keys(&f, "<Left><Left><Left><Left><Left><Left><Left>");
    ck_assert_str_eq(f.tui->form.focus[THUD_SCREEN_MODEL], "structures.1.mass.2");
    char *screen = fixture_text(&f);
    ck_assert_ptr_null(strstr(screen, "cap. kN"));
    free(screen);
    fixture_keys(&f, "<Right><Right><Right><Enter><Tab>"); /* yield, the last one shown */
    ck_assert_str_eq(f.tui->form.focus[THUD_SCREEN_MODEL], "structures.1.mass.1");
    fixture_keys(&f, "<Esc>/structures.2.column.EI.3<Enter>");
    fixture_expect(&f, "col. EI");
    ck_assert_str_eq(f.tui->form.focus[THUD_SCREEN_MODEL], "structures.2.column.EI.3");
    fixture_keys(&f, "<Size 230x40>");
    fixture_expect(&f, "mass t");
    fixture_expect(&f, "cap. kN");
}
END_TEST

/* The highest column of dots of a case beside the topmost floor of A, in rows of dots; and where the three stand. */
static int spark_height(int which)
{
    char *screen = fixture_text(&f), *at = strstr(screen, "no contact"), *line = screen;
    ck_assert_ptr_nonnull(at);
    int y = 0, high = 0;
    for (char *p = screen; p < at; p++)
        if (*p == '\n') {
            line = p + 1;
            y++;
        }
    *at = '\0';
    const int x = thud_utf8_columns(line) + 11 * which;
    free(screen);
    for (int i = 0; i < 10; i++) {
        const uint32_t dots = f.tui->canvas.cell[(y + 1) * f.tui->canvas.width + x + i].glyph - 0x2800;
        const int rows = dots > 0xff ? 0 : dots & 0x09 ? 4 : dots & 0x12 ? 3 : dots & 0x24 ? 2 : dots & 0xc0 ? 1 : 0;
        high = rows > high ? rows : high;
    }
    return high;
}

/* Each floor has its acceleration beside it, higher where it is larger; the buildings stand beside records and
 * results. */
START_TEST(wide_screens_show_what_moves)
{
    fixture_close(&f);
    fixture_open(&f, "towers", 130, 40, true);
    fixture_keys(&f, "1");
    const double most = fmax(thud_live_peak(&f.tui->run.live, THUD_LIVE_NONE, 0, THUD_PEAK_ACCELERATION),
                             fmax(thud_live_peak(&f.tui->run.live, THUD_LIVE_NONE, 1, THUD_PEAK_ACCELERATION),
                                  fmax(thud_live_peak(&f.tui->run.live, THUD_LIVE_BUMPER, 0, THUD_PEAK_ACCELERATION),
                                       thud_live_peak(&f.tui->run.live, THUD_LIVE_BUMPER, 1, THUD_PEAK_ACCELERATION))));
    for (int which = 0; which < THUD_LIVE_CASES; which++) {
        const double peak =
            thud_live_floor(&f.tui->run.live, (enum thud_live_which)which, 0, 1, THUD_PEAK_ACCELERATION);
        ck_assert_int_le(abs(spark_height(which) - (int)lround(1 + 3 * peak / most)), 1);
    }
    ck_assert_int_gt(spark_height(THUD_LIVE_NONE), spark_height(THUD_LIVE_FREE));
    fixture_keys(&f, "3");
    fixture_expect(&f, "At the largest impact");
    fixture_keys(&f, "4");
    fixture_expect(&f, "At the largest impact");
    fixture_keys(&f, "<Size 80x24>");
    fixture_expect_not(&f, "At the largest impact");
    fixture_keys(&f, "1");
    fixture_expect_not(&f, "no contact");
}
END_TEST

/* Whether a slab is drawn in this row, from column x on. */
static bool slab_at(int x, int y)
{
    const struct thud_canvas *canvas = &f.tui->canvas;
    for (int i = 0; i < 8; i++)
        if (canvas->cell[y * canvas->width + x + i].glyph == ' ')
            return false;
    return true;
}

/* Floors at one elevation are drawn in one row, whatever the storeys and bases of the two buildings: A stands from 6 to
 * 12 m, B from 0 to 9 m. */
START_TEST(buildings_stand_at_their_elevations)
{
    int slab[2][16], n[2] = {0, 0};
    fixture_keys(&f, "<Size 130x40>1:set structures.1.base 6 m<Enter>");
    fixture_expect(&f, "6 to 12 m");
    fixture_expect(&f, "9 m ");
    for (int y = 13; y < 27; y++)
        for (int s = 0; s < 2; s++)
            if (slab_at(65 * s + 3, y))
                slab[s][n[s]++] = y;
    ck_assert_int_eq(n[0], 3); /* roof, floor, ground */
    ck_assert_int_eq(n[1], 4);
    ck_assert_int_eq(slab[0][1], slab[1][0]); /* 9 m */
    ck_assert_int_eq(slab[0][2], slab[1][1]); /* 6 m */
    ck_assert_int_lt(slab[0][0], slab[1][0]);
    ck_assert_int_gt(slab[1][3], slab[0][2]);
}
END_TEST

/* Linked buildings have the shapes, periods and effective masses of their system: five modes of two and three
 * floors. */
START_TEST(linked_buildings_have_modes_of_both)
{
    char text[40], number[24];
    fixture_keys(&f, "<Size 250x60>1r");
    fixture_expect_not(&f, "linked T");
    fixture_keys(&f, ":link add 1<Enter>:set links.1.stiffness 50 MN/m<Enter>1r");
    for (int before = 0; before < 2; before++) { /* behind the runs, one of which has no links, and before them */
        const struct thud_model *model = thud_tui_model(f.tui);
        double total = 0.0;
        ck_assert_int_eq(model->structure[0].modes, 5);
        for (int i = 0; i < 5; i++)
            total += model->mass_kg[i];
        snprintf(text, sizeof text, " linked M*%8.1f ", 100.0 * model->gamma[0] * model->gamma[0] / total);
        fixture_expect(&f, text); /* of the mass of both */
        for (int j = 0; j < 5; j++) {
            snprintf(text, sizeof text, "%d: %s s", j + 1,
                     thud_tui_number(2.0 * THUD_PI / model->omega[model->structure[0].first_mode + j], number));
            fixture_expect(&f, text);
        }
        snprintf(text, sizeof text, " linked T %8s ",
                 thud_tui_number(2.0 * THUD_PI / model->omega[model->structure[0].first_mode], number));
        fixture_expect(&f, text);
        snprintf(text, sizeof text, ": A (1 of 2) T1 %s s",
                 thud_tui_number(2.0 * THUD_PI / model->structure[0].omega[0], number));
        fixture_expect(&f, text); /* its own */
        thud_tui_forget_run(f.tui);
        thud_tui_draw(f.tui);
    }
}
END_TEST

/* A floor that another screen asked for may be of a structure that was taken away since. */
START_TEST(a_floor_that_is_gone_is_not_shown)
{
    fixture_keys(&f, "5");
    f.tui->look_at = (struct thud_look_at){.wanted = true, .structure = 7};
    fixture_keys(&f, "r");
    ck_assert(!f.tui->look_at.wanted);
    fixture_expect(&f, "impact force (MN)");
}
END_TEST

/* Work of the shear along the drift as the figure has them: what was lost in yielding, but for the little that the
 * springs keep. */
START_TEST(the_loop_of_a_storey_holds_what_it_lost)
{
    fixture_keys(&f, "5");
    fixture_expect(&f, "1/8 ");
    fixture_keys(&f, ":set structures.1.yield.1 4 mm<Enter>:set structures.1.hardening.1 5 %<Enter><Up>");
    fixture_expect(&f, "9/9 storey shear against drift");
    const struct thud_figure *figure = thud_views[THUD_SCREEN_PLOTS]->figure(f.tui);
    ck_assert_ptr_nonnull(figure);
    ck_assert_int_eq(figure->panel[0].nseries, THUD_LIVE_CASES);
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        const struct thud_series *s = figure->panel[0].series[i];
        const struct thud_result *result = thud_live_result(&f.tui->run.live, (enum thud_live_which)i);
        double work_j = 0.0, lost_j = result->structure[0].storey[0].hysteretic_j;
        for (size_t k = 1; k < s->n; k++) /* MN and mm */
            work_j += 1e3 * 0.5 * (s->y[k] + s->y[k - 1]) * (s->x[k] - s->x[k - 1]);
        ck_assert_double_gt(lost_j, 1e4);
        ck_assert_double_eq_tol(work_j, lost_j, 0.02 * lost_j);
    }
    fixture_expect(&f, "A, storey 1");
    fixture_keys(&f, "]"); /* its panel alone; no other storey yields */
    fixture_expect(&f, "A, storey 1");
    fixture_keys(&f, ":set structures.1.yield.1 none<Enter>");
    fixture_expect(&f, "1/8 ");
}
END_TEST

/* What stands below the last field of a pane is reached by lines too: the energies and the remarks. */
START_TEST(a_pane_scrolls_behind_its_last_field)
{
    fixture_keys(&f, "4<Tab><Tab>");
    fixture_expect_not(&f, "energy error");
    fixture_keys(&f, "<End>");
    fixture_expect(&f, "is compressed");
    fixture_expect_not(&f, "title   ");
    int lines = f.tui->form.scroll[THUD_SCREEN_RESULTS][2];
    fixture_keys(&f, "<Home>");
    fixture_expect(&f, "title   ");
    for (int i = 0; i < 100; i++)
        fixture_keys(&f, "<Down>");
    ck_assert_int_eq(f.tui->form.scroll[THUD_SCREEN_RESULTS][2], lines);
    fixture_keys(&f, "<Up>");
    ck_assert_int_eq(f.tui->form.scroll[THUD_SCREEN_RESULTS][2], lines - 1);
    fixture_keys(&f, "<F2>"); /* what is edited is seen */
    ck_assert_int_lt(f.tui->form.scroll[THUD_SCREEN_RESULTS][2], lines - 1);
    fixture_keys(&f, "<Esc>");
}
END_TEST

/* Lines from the head of the peaks to that of the impacts: frame, heads and floors, with nothing empty below them. */
static int lines_of_peaks(void)
{
    char *text = fixture_text(&f);
    const char *at = strstr(text, "Peaks"), *end = strstr(text, "Impacts, ");
    ck_assert(at && end && at < end);
    int lines = 0;
    for (; at < end; at++)
        lines += *at == '\n';
    free(text);
    return lines;
}

START_TEST(a_high_screen_is_left_to_impacts)
{
    int floors = 0;
    for (int s = 0; s < f.tui->doc.scene.nstructures; s++)
        floors += f.tui->doc.scene.structure[s].storeys;
    fixture_close(&f);
    fixture_open(&f, "towers", 200, 60, false);
    fixture_keys(&f, "4");
    ck_assert_int_eq(lines_of_peaks(), 3 + floors);
    fixture_expect(&f, "energy error");
    fixture_keys(&f, ":set gap 3 cm<Enter>"); /* the state before takes a line of each floor */
    ck_assert_int_eq(lines_of_peaks(), 3 + 2 * floors);
}
END_TEST

START_TEST(remarks_are_counted_and_lead_to_their_fields)
{
    struct thud_error remark;
    struct thud_remark_scope scope = {.scene = &f.tui->doc.scene,
                                      .result = thud_live_result(&f.tui->run.live, THUD_LIVE_BUMPER)};
    const struct thud_record *record = f.tui->doc.record;
    int n = 0;
    scope.impact = thud_run_impacts(f.tui->run.live.which[THUD_LIVE_BUMPER].run, &scope.nimpacts);
    scope.record = &record;
    scope.nrecords = 1;
    while (nth_remark(&scope, THUD_REMARK_SCENE | THUD_REMARK_MOTIONS | THUD_REMARK_COMPUTED | THUD_REMARK_RESULT, n,
                      &remark))
        n++;
    char text[32];
    ck_assert_int_ge(n, 2);
    snprintf(text, sizeof text, " ! %d\n", n);
    fixture_expect(&f, text);
    fixture_keys(&f, "!");
    fixture_expect(&f, "! the bumper of 10 mm is compressed by");
    fixture_expect(&f, "elastic (buildings yield");
    fixture_expect(&f, "unaccounted for");
    fixture_expect(&f, "tolerance: ");
    fixture_expect(&f, "sign: +");
    fixture_keys(&f, "<Enter>");
    ck_assert_int_eq(f.tui->screen, THUD_SCREEN_CONTACT);
    ck_assert_ptr_eq(strstr(f.tui->form.focus[THUD_SCREEN_CONTACT], "interfaces.1.bumper."),
                     f.tui->form.focus[THUD_SCREEN_CONTACT]);
    fixture_keys(&f, "!elastic<Enter>");
    ck_assert_int_eq(f.tui->screen, THUD_SCREEN_MODEL);
    ck_assert_int_eq(strncmp(f.tui->form.focus[THUD_SCREEN_MODEL], "structures.2", strlen("structures.2")), 0);
    fixture_keys(&f, "!sign<Enter>");
    ck_assert_str_eq(f.tui->form.focus[THUD_SCREEN_RECORD], "record.sign");
    fixture_keys(&f, "!tolerance<Enter>");
    ck_assert_str_eq(f.tui->form.focus[THUD_SCREEN_RESULTS], "analysis.tolerance");
    fixture_keys(&f, ":live off<Enter>:set gap 3 cm<Enter>!");
    fixture_expect(&f, "There are no results yet");
}
END_TEST

static int cells_of(int role)
{
    int n = 0;
    for (int i = 0; i < f.tui->canvas.width * f.tui->canvas.height; i++)
        n += f.tui->canvas.cell[i].style.role == role && f.tui->canvas.cell[i].glyph != ' ';
    return n;
}

/* Hinges are drawn once a storey has yielded, and none before; at the end they stay. */
START_TEST(yielded_storeys_are_drawn_with_hinges)
{
    fixture_keys(&f, "<Size 130x40>5:set structures.1.yield.1 4 mm<Enter>");
    fixture_keys(&f, "<Home>");
    int before = cells_of(THUD_ROLE_WARN);
    fixture_keys(&f, "<End>");
    ck_assert_int_ge(cells_of(THUD_ROLE_WARN), before + 4);
    fixture_keys(&f, ":set structures.1.yield.1 none<Enter>");
    fixture_keys(&f, "<End>");
    ck_assert_int_eq(cells_of(THUD_ROLE_WARN), before);
}
END_TEST

/* A slab half a storey up strikes columns: it is said which, and drawn at its own elevation. */
START_TEST(struck_columns_are_named_and_drawn_at_the_slab)
{
    fixture_keys(&f, "<Size 130x40>5:set structures.1.base 1.5 m<Enter>:case none<Enter>bbL");
    fixture_expect(&f, "B, columns ");
    fixture_expect(&f, "-c");
    int flash = 0, roof = 0, ground = 0; /* rows of A: its roof stands at 7.5 m, and strikes half way up a storey */
    for (int y = 26; y < 37; y++)
        for (int x = 42; x < 128; x++) {
            const struct thud_cell *cell = &f.tui->canvas.cell[y * f.tui->canvas.width + x];
            flash = cell->glyph == '*' && flash == 0 ? y : flash;
            if (cell->style.role == THUD_ROLE_SERIES) {
                roof = roof == 0 ? y : roof;
                ground = y;
            }
        }
    ck_assert_int_gt(roof, 0);
    ck_assert_int_gt(ground, roof + 3);
    ck_assert(abs(flash - roof) <= 1 || abs(flash - (roof + ground) / 2) <= 1); /* at one of its two floors */
}
END_TEST

/* Another law is laid over the one before it. Hertz without damping by hand: m v^2/2 = 2/5 k d^2.5, F = k d^1.5 with
 * the floors' 160 t and 87 kN/mm^1.5 (its default, as the stiffness of the other has another dimension). */
START_TEST(a_law_is_laid_over_another)
{
    double k = 87e3 * pow(1e3, 1.5), energy = 0.5 * 160e3 * 0.25, force = k * pow(pow(2.5 * energy / k, 0.4), 1.5);
    char number[24];
    fixture_keys(&f, "<Size 130x40>:set bumper.fitted off<Enter>:name linear<Enter>:compare linear<Enter>");
    fixture_keys(&f, "2:set contact.law hertz<Enter>");
    fixture_expect(&f, "0.5 m/s, linear");
    fixture_expect(&f, "What both give");
    const struct thud_panel *panel = &thud_views[THUD_SCREEN_CONTACT]->figure(f.tui)->panel[0];
    ck_assert_int_eq(panel->nseries, 6);
    for (int i = 0; i < 6; i++)
        ck_assert_int_eq(panel->series[i]->style.dashed, i < 3);
    double most = 0;
    for (size_t i = 0; i < panel->series[4]->n; i++) /* 0.5 m/s: the second of the new law */
        most = fmax(most, panel->series[4]->y[i]);
    ck_assert_double_eq_tol(1e6 * most, force, 2e-3 * force);
    fixture_expect(&f, thud_tui_number(1e-6 * force, number));
    fixture_keys(&f, ":compare<Enter>:set contact.stiffness 174 kN/mm^1.5<Enter>"); /* and against the one before */
    fixture_expect(&f, "0.5 m/s, before");
    fixture_expect(&f, thud_tui_number(1e-6 * force * pow(2.0, 0.4), number));
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui views");
    TCase *views = tcase_create("views");
    tcase_set_timeout(views, 60.0);
    tcase_add_checked_fixture(views, setup, teardown);
    tcase_add_test(views, impacts_stand_in_three_orders);
    tcase_add_test(views, storeys_that_yield_have_two_quantities_more);
    tcase_add_test(views, a_run_that_fails_says_which_case_and_when);
    tcase_add_test(views, a_wall_moves_with_the_ground);
    tcase_add_test(views, soil_is_drawn_without_the_links);
    tcase_add_test(views, several_structures);
    tcase_add_test(views, clicks_go_to_fields);
    tcase_add_test(views, clicks_on_floors_go_to_their_rows);
    tcase_add_test(views, figures_are_called_by_what_tells_them_apart);
    tcase_add_test(views, numbers_are_dragged);
    tcase_add_test(views, charts_are_zoomed_and_moved);
    tcase_add_test(views, plots_open_on_the_strong_motion);
    tcase_add_test(views, tables_are_sorted_and_filtered);
    tcase_add_test(views, the_ground_motion_has_four_curves);
    tcase_add_test(views, a_study_has_figures_and_panels);
    tcase_add_test(views, what_there_is_not_is_said);
    tcase_add_test(views, commands_of_the_command_line);
    tcase_add_test(views, the_cursor_leads_to_every_column_of_floors);
    tcase_add_test(views, buildings_stand_at_their_elevations);
    tcase_add_test(views, linked_buildings_have_modes_of_both);
    tcase_add_test(views, a_floor_that_is_gone_is_not_shown);
    tcase_add_test(views, wide_screens_show_what_moves);
    tcase_add_test(views, the_loop_of_a_storey_holds_what_it_lost);
    tcase_add_test(views, a_pane_scrolls_behind_its_last_field);
    tcase_add_test(views, a_high_screen_is_left_to_impacts);
    tcase_add_test(views, remarks_are_counted_and_lead_to_their_fields);
    tcase_add_test(views, yielded_storeys_are_drawn_with_hinges);
    tcase_add_test(views, struck_columns_are_named_and_drawn_at_the_slab);
    tcase_add_test(views, a_law_is_laid_over_another);
    suite_add_tcase(suite, views);
    return suite;
}
