/* What is computed after every edit: the numbers shown are those of the scene that is, and of no other. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "app/run/summary_line.h"
#include "study/scene/solution.h"
#include "tui_fixture.h"

static struct fixture f;

static void setup(void)
{
    fixture_open(&f, "towers", 80, 24, true);
}

static void teardown(void)
{
    fixture_close(&f);
}

/* The largest peak of a structure in a case, found without the screens. */
static double answer_peak(enum thud_case which, int structure, bool drift)
{
    struct thud_scene scene;
    struct thud_solution solution = {0};
    struct thud_error err;
    const struct thud_record *record;
    double most = 0.0;
    ck_assert_int_eq(thud_scene_case(&f.tui->doc.scene, which, &scene, &err), THUD_OK);
    ck_assert_int_eq(thud_doc_record(&f.tui->doc, &record, &err), THUD_OK);
    ck_assert_int_eq(thud_scene_solve(&scene, record, NULL, &solution, &err), THUD_OK);
    const struct thud_structure_result *result = &thud_run_result(solution.run)->structure[structure];
    for (int i = 0; i < result->floors; i++)
        most = fmax(most, drift ? 1e3 * result->floor[i].drift.value : result->floor[i].acceleration.value);
    thud_solution_clear(&solution);
    return most;
}

START_TEST(the_numbers_are_the_answers)
{
    static const char *const edit[] = {"", "<A-2><Enter>1.5<Enter><A-1>", ":set structures.1.damping 10 %<Enter>",
                                       ":peak 0.4 g<Enter>", ":set p-delta yes<Enter>"};
    for (size_t e = 0; e < sizeof edit / sizeof *edit; e++) {
        fixture_keys(&f, edit[e]);
        for (int s = 0; s < 2; s++)
            for (int drift = 0; drift < 2; drift++) {
                char none[24], bumper[24], row[64], number[24];
                thud_tui_number(answer_peak(THUD_CASE_NONE, s, drift), none);
                thud_tui_number(answer_peak(THUD_CASE_BUMPER, s, drift), bumper);
                snprintf(row, sizeof row, "%s %s", s ? "B" : "A", drift ? "drift" : "accel");
                char *text = fixture_text(&f), *line = strstr(text, row);
                ck_assert_ptr_nonnull(line);
                *strchr(line, '\n') = '\0';
                ck_assert_msg(strstr(line, none) && strstr(line, bumper), "%s and %s are not in: %s", none, bumper,
                              line);
                free(text);
                (void)number;
            }
    }
}
END_TEST

/* The record goes: nothing of the old result stays on any screen. */
START_TEST(no_old_number_after_a_failure)
{
    char old[24];
    thud_tui_number(answer_peak(THUD_CASE_NONE, 0, false), old);
    fixture_expect(&f, old);
    fixture_take_record(&f);
    fixture_expect(&f, "FAILED");
    fixture_expect_not(&f, old);
    fixture_keys(&f, "<A-4>");
    fixture_expect(&f, "FAIL");
    fixture_expect_not(&f, old);
    fixture_write_pulse(&f);
    fixture_keys(&f, "<A-1>u");
    fixture_expect(&f, old);
    fixture_expect_not(&f, "FAILED");
}
END_TEST

START_TEST(a_change_shows_as_an_arrow)
{
    fixture_keys(&f, "<A-2><Enter>1.5<Enter><A-1>");
    fixture_expect(&f, "→");
}
END_TEST

/* Time passes with every look at the clock: the run is seen running, and can be stopped. */
/* The screen without what is dimmed: the numbers of before, while the new ones are computed. */
static char *sure_text(const struct thud_canvas *canvas)
{
    struct thud_canvas copy = *canvas;
    size_t cells = (size_t)canvas->width * (size_t)canvas->height;
    copy.cell = malloc(cells * sizeof *copy.cell);
    ck_assert_ptr_nonnull(copy.cell);
    for (size_t i = 0; i < cells; i++) {
        copy.cell[i] = canvas->cell[i];
        if (copy.cell[i].style.role == THUD_ROLE_MUTED)
            copy.cell[i].glyph = ' ';
    }
    char *text = thud_canvas_text(&copy);
    free(copy.cell);
    ck_assert_ptr_nonnull(text);
    return text;
}

START_TEST(a_long_run_is_seen_and_stopped)
{
    char old[24];
    thud_tui_number(answer_peak(THUD_CASE_NONE, 0, false), old);
    f.tui->run.live.threads = -1; /* no faster than the script's clock */
    f.script.tick = 0.3;
    thud_tui_key(f.tui, 'r');
    thud_tui_draw(f.tui);
    fixture_expect(&f, "Esc stops");
    char *sure = sure_text(&f.tui->canvas); /* it is shown as what was before, no more */
    ck_assert_ptr_null(strstr(sure, old));
    free(sure);
    thud_tui_key(f.tui, THUD_KEY_ESC);
    fixture_keys(&f, "");
    fixture_expect(&f, "not run");
    fixture_expect_not(&f, old);
    fixture_keys(&f, "r");
    fixture_expect(&f, old);
}
END_TEST

/* The largest peak at another gap, as the screens write it. */
static void peak_at(const char *gap, char number[24])
{
    struct thud_scene kept = f.tui->doc.scene;
    struct thud_error err;
    ck_assert_int_eq(thud_scene_set(&f.tui->doc.scene, "gap", gap, &err), THUD_OK);
    thud_tui_number(answer_peak(THUD_CASE_BUMPER, 0, false), number);
    f.tui->doc.scene = kept;
}

/* While one case is new and the other old, their ratio is that of no scene: it is not shown. */
START_TEST(no_ratio_of_old_and_new)
{
    char ratio[24];
    f.tui->run.live.threads = -1;
    thud_tui_key(f.tui, 'r');
    while (f.tui->run.live.which[THUD_LIVE_BUMPER].state == THUD_LIVE_RUNNING)
        thud_live_advance(&f.tui->run.live);
    ck_assert(thud_live_is_old(&f.tui->run.live, THUD_LIVE_NONE));
    snprintf(ratio, sizeof ratio, "%.3f",
             thud_live_peak(&f.tui->run.live, THUD_LIVE_BUMPER, 0, THUD_PEAK_DRIFT) /
                 thud_live_peak(&f.tui->run.live, THUD_LIVE_NONE, 0, THUD_PEAK_DRIFT));
    thud_tui_draw(f.tui);
    fixture_expect_not(&f, ratio);
    fixture_keys(&f, "");
    fixture_expect(&f, ratio);
}
END_TEST

static char forbidden[2][24];
static int drawn_running;

/* Everything that is ever shown: a number stands only for its own scene, or before the arrow of a change. */
static void watch(struct thud_backend *backend, const struct thud_canvas *canvas)
{
    char *text = sure_text(canvas);
    (void)backend;
    drawn_running += f.tui->run.live.running;
    for (int i = 0; i < 2; i++)
        for (const char *at = text; *forbidden[i] && (at = strstr(at, forbidden[i])) != NULL; at++)
            ck_assert_msg(strncmp(at + strlen(forbidden[i]), "→", strlen("→")) == 0, "%s is shown:\n%s", forbidden[i],
                          text);
    free(text);
}

/* Edits overtake runs: each is taken at once, what was being computed is given up, and no number of a scene that is no
 * more is shown as one of the scene that is. */
START_TEST(the_newest_edit_wins)
{
    char first[24], second[24], third[24];
    peak_at("2 cm", first);
    peak_at("1.7 cm", second);
    peak_at("1.3 cm", third);
    ck_assert(strcmp(first, second) != 0 && strcmp(second, third) != 0 && strcmp(first, third) != 0);
    fixture_expect(&f, first);
    f.tui->run.live.threads = -1; /* a slice of work is one look at the clock */
    void (*show)(struct thud_backend * backend, const struct thud_canvas *canvas) = f.backend.show;
    f.backend.show = watch;
    f.script.tick = 0.013;
    f.script.at = ":set gap 1.7 cm\r";
    while (*f.script.at)
        thud_tui_turn(f.tui, false);
    ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.017, 1e-15);
    snprintf(forbidden[0], sizeof forbidden[0], "%s", first);
    for (int i = 0; i < 2; i++)
        thud_tui_turn(f.tui, false);
    ck_assert_int_eq((int)f.tui->run.live.which[THUD_LIVE_FREE].state, THUD_LIVE_RUNNING);
    const struct thud_run *given_up = f.tui->run.live.which[THUD_LIVE_BUMPER].run; /* which is begun first */
    double came = thud_run_time(given_up);
    ck_assert(came > 0.0);
    f.script.at = ":set gap 1.3 cm\r";
    while (*f.script.at)
        thud_tui_turn(f.tui, false);
    snprintf(forbidden[1], sizeof forbidden[1], "%s", second);
    ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.013, 1e-15);
    ck_assert(thud_run_time(f.tui->run.live.which[THUD_LIVE_BUMPER].run) < came); /* begun anew */
    f.script.tick = 0.004;
    fixture_keys(&f, "");
    ck_assert_int_ge(drawn_running, 2);
    fixture_expect(&f, third);
    memset(forbidden, 0, sizeof forbidden);
    f.backend.show = show;
}
END_TEST

START_TEST(live_turns_itself_off_when_slow)
{
    f.tui->run.live.threads = -1;
    f.script.tick = 0.6;
    fixture_keys(&f, "r");
    fixture_expect(&f, "r runs");
    ck_assert(!f.tui->run.on);
    f.script.tick = 0.0;
    fixture_keys(&f, "<A-2><Enter>3<Enter>");
    fixture_expect(&f, "not run");
    fixture_keys(&f, "r<A-1>");
    fixture_expect(&f, "ok");
}
END_TEST

/* Beginning and end by keys: the result is that of the part, what is cut off stays in sight, and undo brings it back.
 */
START_TEST(a_motion_is_trimmed)
{
    char whole[24], part[24];
    fixture_keys(&f, "<A-3>");
    fixture_expect_not(&f, "cut off");
    thud_tui_number(answer_peak(THUD_CASE_NONE, 1, false), whole);
    fixture_keys(&f, "/record.to<Enter>-"); /* 3 s, one step back */
    ck_assert_double_eq_tol(f.tui->doc.scene.record.to_s, 2.9, 1e-12);
    fixture_keys(&f, "<Up>+{{{{{{{{{<Enter>1.25<Enter>");
    ck_assert_double_eq_tol(f.tui->doc.scene.record.from_s, 1.25, 1e-12);
    fixture_expect(&f, "cut off");
    fixture_expect(&f, "166 samples");
    ck_assert_uint_eq(f.tui->doc.record->samples, 166);
    ck_assert_uint_eq(f.tui->doc.whole->samples, 301);
    ck_assert_double_eq_tol(f.tui->doc.whole->a_mps2[135], f.tui->doc.record->a_mps2[10], 1e-9);
    thud_tui_number(answer_peak(THUD_CASE_NONE, 1, false), part);
    ck_assert_str_ne(whole, part);
    fixture_keys(&f, "<A-1>");
    fixture_expect(&f, part);
    fixture_keys(&f, "<A-3><Enter>9<Enter>"); /* nothing is left of it */
    fixture_expect(&f, " ! ");
    ck_assert_double_eq_tol(f.tui->doc.scene.record.from_s, 1.25, 1e-12);
    fixture_keys(&f, "<Esc>uu");
    ck_assert(!f.tui->doc.whole || !isnan(f.tui->doc.scene.record.from_s));
    fixture_keys(&f, "uuuuuuuuuuuuuuuuu");
    ck_assert(isnan(f.tui->doc.scene.record.from_s) && isnan(f.tui->doc.scene.record.to_s));
    ck_assert_ptr_null(f.tui->doc.whole);
    fixture_expect_not(&f, "cut off");
    fixture_keys(&f, "<A-1>");
    fixture_expect(&f, whole);
}
END_TEST

/* The first line says what the runs found; a gap of what it needs is enough, a little less is not. */
START_TEST(the_answer_in_one_line)
{
    int impacts;
    char words[200], number[24], keys[100];
    double force = thud_live_force(&f.tui->run.live, THUD_LIVE_NONE, 1, &impacts);
    snprintf(words, sizeof words, "POUNDS at 2 cm: %d impacts, %s MN", impacts, thud_tui_number(1e-6 * force, number));
    fixture_expect(&f, words);
    double bumper = thud_live_force(&f.tui->run.live, THUD_LIVE_BUMPER, 1, &impacts);
    snprintf(words, sizeof words, "bumper: %s MN", thud_tui_number(1e-6 * bumper, number));
    fixture_expect(&f, words);
    fixture_keys(&f, "4<Size 130x40>");
    fixture_expect(&f, "no bumper: POUNDS at 2 cm: "); /* where there is room: which of the cases this is */
    snprintf(words, sizeof words, "   bumper: %d impacts, %s MN (%+.0f %%)", impacts,
             thud_tui_number(1e-6 * bumper, number), 100.0 * (bumper / force - 1.0));
    fixture_expect(&f, words);
    fixture_expect(&f, "SRSS");
    fixture_keys(&f, ":link add 1<Enter>:name linked<Enter>");
    fixture_expect(&f, " -> "); /* the change; as opened it is told by its measures */
    snprintf(keys, sizeof keys, ":open %s/linked.yaml<Enter>y", f.folder);
    fixture_keys(&f, keys);
    fixture_expect(&f, "neither: ");
    fixture_expect(&f, "   both: ");
    ck_assert_int_eq(f.tui->doc.scene.nlinks,
                     1); /* they change what is needed: it stands behind their case, as bare and bumper */
    const struct thud_live_need *linked = &f.tui->run.live.need[0];
    snprintf(words, sizeof words, "   needs %.1f cm (%.1f bare)", thud_summary_gap_cm(linked->with_bumper_m),
             thud_summary_gap_cm(linked->relative_displacement_m));
    fixture_expect(&f, words);
    for (int wide = 1; wide >= 0; wide--) {
        const char *both = strstr(f.tui->verdict.text, "both: ");
        ck_assert_ptr_nonnull(both);
        ck_assert_ptr_nonnull(strstr(both, "   needs "));
        fixture_keys(&f, "<Size 80x24>");
    }
    fixture_keys(&f, "<Size 130x40>");
    snprintf(keys, sizeof keys, ":open %s/towers.yaml<Enter>", f.folder);
    fixture_keys(&f, keys);
    double need = f.tui->run.live.need[0].relative_displacement_m;
    ck_assert_double_gt(need, 0.02);
    ck_assert_double_ge(f.tui->run.live.need[0].abs_m, f.tui->run.live.need[0].srss_m);
    ck_assert_double_ge(f.tui->run.live.need[0].abs_m, need);
    for (int enough = 0; enough < 2; enough++) {
        snprintf(keys, sizeof keys, "B<Esc>:case none<Enter>:set gap %.9g m<Enter>", need * (enough ? 1.001 : 0.999));
        fixture_keys(&f, keys);
        fixture_expect(&f, enough ? "NO CONTACT at " : "POUNDS at ");
        ck_assert_double_eq_tol(f.tui->run.live.need[0].relative_displacement_m, need,
                                1e-12); /* it is that of no contact */
    }
}
END_TEST

/* While a run goes on, numbers of before the edit are said to be that, not by their colour alone. */
START_TEST(old_numbers_are_named)
{
    f.tui->run.live.threads = -1; /* a turn computes for a moment */
    for (int screen = 1; screen <= 4; screen += 3) {
        fixture_keys(&f, screen == 1 ? "1" : "4");
        fixture_expect_not(&f, "efore the edit");
        f.script.at = screen == 1 ? ":set gap 3 cm<Enter>" : ":set gap 4 cm<Enter>";
        while (*f.script.at)
            thud_tui_turn(f.tui, false);
        ck_assert(f.tui->run.live.running);
        thud_tui_draw(f.tui);
        fixture_expect(&f, "efore the edit");
        fixture_keys(&f, "");
        fixture_expect_not(&f, "efore the edit");
    }
}
END_TEST

/* Nothing is no number of rounding. */
START_TEST(rounding_is_shown_as_nothing)
{
    char text[24];
    ck_assert_str_eq(thud_tui_number(-1.11e-16, text), "0");
    ck_assert_str_eq(thud_tui_number(-1.11e-9, text), "-1.11e-09");
    struct thud_figure *figure = thud_figure_create("velocity", "Velocity", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, "Time", "s");
    thud_panel_axis(panel, THUD_Y, "Velocity", "m/s");
    const double x[] = {0, 1}, y[] = {-1.11e-16, 2};
    char words[200];
    ck_assert_ptr_nonnull(thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES}, "floor 1", 2, x, y));
    thud_chart_words(panel, 0, words, sizeof words);
    ck_assert_str_eq(words, "Time 0 s:  floor 1 0 m/s");
    thud_figure_free(figure);
}
END_TEST

static double bumper_force(const struct thud_live *live)
{
    int impacts;
    ck_assert_ptr_nonnull(live);
    return thud_live_force(live, THUD_LIVE_BUMPER, 0, &impacts);
}

/* Changes are told against the state before them, steps of one value against the state before the first, and against a
 * design once it is chosen. */
START_TEST(changes_are_told_against_the_base)
{
    const double at_2cm = bumper_force(&f.tui->run.live);
    ck_assert_ptr_null(thud_tui_compared(f.tui));
    fixture_keys(&f, ":set gap 3 cm<Enter>");
    ck_assert(bumper_force(thud_tui_compared(f.tui)) == at_2cm);
    const double at_3cm = bumper_force(&f.tui->run.live);
    fixture_keys(&f, ":set gap 4 cm<Enter>");
    ck_assert(bumper_force(thud_tui_compared(f.tui)) == at_3cm);
    const double at_4cm = bumper_force(&f.tui->run.live);
    fixture_keys(&f, "4");
    fixture_expect(&f, "before");
    fixture_keys(&f, "5");
    fixture_expect(&f, "bumper, before");
    fixture_keys(&f, "2<Home>+++4"); /* a series of steps is one change */
    ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.043, 1e-12);
    ck_assert(bumper_force(thud_tui_compared(f.tui)) == at_4cm);
    fixture_keys(&f, ":compare #1<Enter>:set record.factor 0.5<Enter>"); /* a design keeps its own motion */
    ck_assert(bumper_force(thud_tui_compared(f.tui)) == at_2cm);
    fixture_keys(&f, "<A-5>");
    fixture_expect(&f, "bumper, #1");
    fixture_keys(&f, ":compare<Enter>");
    ck_assert_ptr_null(thud_tui_compared(f.tui));
}
END_TEST

/* The verdict stands on every screen, and says what the last change did; with less room force and gap, then the gap. */
START_TEST(the_verdict_says_what_changed)
{
    char expected[120], a[24], b[24];
    int before, now;
    const double old = thud_live_force(&f.tui->run.live, THUD_LIVE_BUMPER, 1, &before);
    fixture_keys(&f, ":set gap 3 cm<Enter>");
    const double new = thud_live_force(&f.tui->run.live, THUD_LIVE_BUMPER, 1, &now);
    ck_assert(old != new);
    snprintf(expected, sizeof expected, " at 3 cm: %s -> %s MN  %d -> %d impacts  needs",
             thud_tui_number(1e-6 * old, a), thud_tui_number(1e-6 * new, b), before, now);
    for (int screen = 1; screen <= 6; screen++) {
        char key[12];
        snprintf(key, sizeof key, "%d", screen);
        fixture_keys(&f, key);
        fixture_expect(&f, expected);
    }
    const struct thud_live_need *need = &f.tui->run.live.need[0]; /* as `thud run` says of the scene with its bumper */
    ck_assert_double_eq_tol(need->with_bumper_m - need->relative_displacement_m,
                            thud_interface_projection(&f.tui->doc.scene.interface[0], NULL), 1e-12);
    snprintf(expected, sizeof expected, "  needs %.1f cm (%.1f bare)", thud_summary_gap_cm(need->with_bumper_m),
             thud_summary_gap_cm(need->relative_displacement_m));
    fixture_expect_not(&f, "bare"); /* no room */
    fixture_keys(&f, "<Size 130x40>");
    fixture_expect(&f, expected);
    snprintf(expected, sizeof expected, " %s -> %s MN  needs", a, b);
    fixture_keys(&f, "2<Size 56x24>");
    fixture_expect(&f, expected);
    fixture_keys(&f, "<Size 44x24>");
    fixture_expect(&f, "\n needs ");
    fixture_expect_not(&f, "MN  needs");
    fixture_keys(&f, "<Size 80x24>:name three<Enter>:set gap 4 cm<Enter>:compare three<Enter>");
    fixture_expect(&f, "three: ");
}
END_TEST

/* ( and ) drag the gap from any field of Contact, a millimetre each, and the mouse where the buildings stand; movement
 * and verdict follow, told against the state before the first step. */
START_TEST(the_gap_is_dragged)
{
    const struct thud_interface *at = &f.tui->doc.scene.interface[0];
    const double first = thud_live_force(&f.tui->run.live, THUD_LIVE_BUMPER, 1, &(int){0});
    char number[24];
    fixture_keys(&f, "2<Down><Down>))");
    ck_assert_double_eq(at->gap_m, 0.022);
    fixture_expect(&f, "At the largest impact");
    fixture_expect(&f, "( gap 2.2 cm  clearance 1.2 cm )");
    fixture_expect(&f, " at 2.2 cm: ");
    fixture_expect(&f, thud_tui_number(1e-6 * first, number));
    fixture_keys(&f, "(");
    ck_assert_double_eq(at->gap_m, 0.021); /* its decimals, no digits of a product */
    fixture_keys(&f, "c");
    fixture_expect(&f, "Force against indentation");
    fixture_keys(&f, "<Size 130x40>"); /* both where there is room */
    fixture_expect(&f, "Force against indentation");
    fixture_expect(&f, "At the largest impact");
    f.backend.click_x = 110;
    f.backend.click_y = 12;
    thud_tui_key(f.tui, THUD_KEY_CLICK);
    f.backend.click_x = 114;
    thud_tui_key(f.tui, THUD_KEY_DRAG);
    fixture_keys(&f, "");
    ck_assert_double_eq(at->gap_m, 0.025);
    fixture_keys(&f, "u");
    ck_assert_double_eq(at->gap_m, 0.021); /* its decimals, no digits of a product */
}
END_TEST

/* What was said can be read again, and what is next goes once it was done. */
START_TEST(messages_and_next_steps)
{
    fixture_expect_not(&f, "$ does nothing");
    fixture_keys(&f, "$:set gap 3 cm<Enter><C-o>");
    fixture_expect(&f, "$ does nothing here");
    fixture_expect(&f, ":set gap 3 cm");
    fixture_keys(&f, "<Esc>2");
    fixture_expect(&f, "next: 6 finds the gap, U keeps this design, R reports");
    fixture_keys(&f, "U<Esc>U<Esc>");
    fixture_expect(&f, "next: 6 finds the gap, R reports");
    fixture_keys(&f, "1");
    fixture_expect_not(&f, ":simplify tells");
    fixture_keys(&f, ":set p-delta yes<Enter>"); /* more than a scene may need */
    fixture_expect(&f, ":simplify shows what is needed");
}
END_TEST

static double processor_s(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* With the towers of a preset that comes with thud, whose bumper fills the gap, every screen shows the result of an
 * edit after 50 ms of processor time of all threads; a machine may be three times as slow. */
START_TEST(edits_are_answered_in_time)
{
    enum { TRIES = 5 };
    static const double limit_s = 0.15;
    snprintf(f.paths.records, sizeof f.paths.records, "records");
    snprintf(f.paths.presets, sizeof f.paths.presets, "presets");
    fixture_keys(&f, "<Size 130x40>:open towers<Enter>:set gap 5 cm<Enter>");
    for (int screen = 0; screen < THUD_SCREEN_HELP; screen++) {
        char key[2] = {(char)('1' + screen), '\0'}, text[32];
        double least_s = INFINITY;
        fixture_keys(&f, key);
        for (int i = 0; i < TRIES; i++) {
            const double from_s = processor_s();
            snprintf(text, sizeof text, "5.%d%d %%", screen + 1, i + 1);
            ck_assert(thud_tui_set(f.tui, "structures.1.damping", text));
            do
                thud_tui_turn(f.tui, false);
            while (f.tui->run.live.running || f.tui->run.was_running);
            thud_tui_draw(f.tui);
            least_s = fmin(least_s, processor_s() - from_s);
            fixture_keys(&f, ""); /* and all the rest */
        }
        ck_assert_int_eq(f.tui->screen, screen);
        printf("# %s answers after %.0f ms\n", thud_views[screen]->title, 1e3 * least_s);
#if !defined __SANITIZE_ADDRESS__
        ck_assert_double_lt(least_s, limit_s);
#endif
        (void)limit_s;
    }
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui live");
    TCase *live = tcase_create("live");
    tcase_set_timeout(live, 60.0);
    tcase_add_checked_fixture(live, setup, teardown);
    tcase_add_test(live, the_numbers_are_the_answers);
    tcase_add_test(live, old_numbers_are_named);
    tcase_add_test(live, rounding_is_shown_as_nothing);
    tcase_add_test(live, changes_are_told_against_the_base);
    tcase_add_test(live, the_verdict_says_what_changed);
    tcase_add_test(live, the_gap_is_dragged);
    tcase_add_test(live, messages_and_next_steps);
    tcase_add_test(live, the_answer_in_one_line);
    tcase_add_test(live, no_old_number_after_a_failure);
    tcase_add_test(live, a_change_shows_as_an_arrow);
    tcase_add_test(live, a_long_run_is_seen_and_stopped);
    tcase_add_test(live, no_ratio_of_old_and_new);
    tcase_add_test(live, the_newest_edit_wins);
    tcase_add_test(live, live_turns_itself_off_when_slow);
    tcase_add_test(live, a_motion_is_trimmed);
    tcase_add_test(live, edits_are_answered_in_time);
    suite_add_tcase(suite, live);
    return suite;
}
