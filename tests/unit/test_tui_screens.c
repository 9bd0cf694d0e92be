/* What the screens show: whole ones, and that their numbers are the answer's own. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/answer.h"
#include "tui/plots.h"
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
    struct thud_answer answer = {0};
    struct thud_error err;
    const struct thud_record *record;
    double most = 0.0;
    ck_assert_int_eq(thud_scene_case(&f.tui->doc.scene, which, &scene, &err), THUD_OK);
    ck_assert_int_eq(thud_doc_record(&f.tui->doc, &record, &err), THUD_OK);
    ck_assert_int_eq(thud_scene_answer(&scene, record, NULL, &answer, &err), THUD_OK);
    const struct thud_structure_result *result = &thud_run_result(answer.run)->structure[structure];
    for (int i = 0; i < result->floors; i++)
        most = fmax(most, drift ? 1e3 * result->floor[i].drift.value : result->floor[i].acceleration.value);
    thud_answer_clear(&answer);
    return most;
}

START_TEST(the_numbers_are_the_answers)
{
    static const char *const edit[] = {"", "<A-2>1.5<Enter><A-1>", ":set structures.1.damping 10 %<Enter>",
                                       ":peak 0.4 g<Enter>"};
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

/* The record goes: nothing of the old answer stays on any screen. */
START_TEST(no_old_number_after_a_failure)
{
    char old[24];
    thud_tui_number(answer_peak(THUD_CASE_NONE, 0, false), old);
    fixture_expect(&f, old);
    fixture_keys(&f, ":record nosuch.csv<Enter>");
    fixture_expect(&f, "FAILED");
    fixture_expect_not(&f, old);
    fixture_keys(&f, "<A-4>");
    fixture_expect(&f, "FAIL");
    fixture_expect_not(&f, old);
    fixture_keys(&f, "<A-1>u");
    fixture_expect(&f, old);
    fixture_expect_not(&f, "FAILED");
}
END_TEST

START_TEST(a_change_shows_as_an_arrow)
{
    fixture_keys(&f, "<A-2>1.5<Enter><A-1>");
    fixture_expect(&f, "→");
}
END_TEST

/* Time passes with every look at the clock: the run is seen running, and can be stopped. */
START_TEST(a_long_run_is_seen_and_stopped)
{
    char old[24];
    thud_tui_number(answer_peak(THUD_CASE_NONE, 0, false), old);
    f.script.tick = 0.3;
    thud_tui_key(f.tui, 'r');
    thud_tui_draw(f.tui);
    fixture_expect(&f, "Esc stops");
    fixture_expect_not(&f, old);
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

static char forbidden[2][24];
static int drawn_running;

/* Everything that is ever shown: a number stands only for its own scene, or before the arrow of a change. */
static void watch(struct thud_backend *backend, const struct thud_canvas *canvas)
{
    char *text = thud_canvas_text(canvas);
    (void)backend;
    ck_assert_ptr_nonnull(text);
    drawn_running += f.tui->live.running;
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
    void (*show)(struct thud_backend * backend, const struct thud_canvas *canvas) = f.backend.show;
    f.backend.show = watch;
    f.script.tick = 0.013; /* time passes: a slice of work is one look at the clock */
    f.script.at = ":set gap 1.7 cm\r";
    while (*f.script.at)
        thud_tui_turn(f.tui, false);
    ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.017, 1e-15);
    snprintf(forbidden[0], sizeof forbidden[0], "%s", first);
    for (int i = 0; i < 2; i++)
        thud_tui_turn(f.tui, false);
    ck_assert_int_eq((int)f.tui->live.which[THUD_LIVE_BUMPER].state, THUD_LIVE_RUNNING);
    const struct thud_run *given_up = f.tui->live.which[THUD_LIVE_FREE].run;
    double came = thud_run_time(given_up);
    ck_assert(came > 0.0);
    f.script.at = ":set gap 1.3 cm\r";
    while (*f.script.at)
        thud_tui_turn(f.tui, false);
    snprintf(forbidden[1], sizeof forbidden[1], "%s", second);
    ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.013, 1e-15);
    ck_assert(thud_run_time(f.tui->live.which[THUD_LIVE_FREE].run) < came); /* begun anew */
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
    f.script.tick = 0.6;
    fixture_keys(&f, "r");
    fixture_expect(&f, "r runs");
    ck_assert(!f.tui->live_on);
    f.script.tick = 0.0;
    fixture_keys(&f, "<A-2>3<Enter>");
    fixture_expect(&f, "not run");
    fixture_keys(&f, "r<A-1>");
    fixture_expect(&f, "ok");
}
END_TEST

START_TEST(every_screen_in_ascii)
{
    fixture_close(&f);
    fixture_open(&f, "towers", 80, 24, false);
    for (int i = 0; i < THUD_SCREENS; i++) {
        char keys[24];
        snprintf(keys, sizeof keys, "<A-%d>", i + 1);
        fixture_keys(&f, keys);
        char *text = fixture_text(&f);
        for (char *c = text; *c; c++)
            ck_assert_msg(*c == '\n' || (*c >= ' ' && *c < 0x7f), "a byte %d on screen %d:\n%s", (unsigned char)*c,
                          i + 1, text);
        free(text);
    }
}
END_TEST

START_TEST(small_terminals)
{
    fixture_keys(&f, "<Size 40x10>");
    fixture_expect(&f, "Left: A");
    fixture_expect_not(&f, "Right: B");
    fixture_keys(&f, "<Tab>");
    fixture_expect(&f, "Right: B");
    fixture_keys(&f, "<Tab>");
    fixture_expect(&f, "A accel");
    fixture_keys(&f, "<Size 39x10>");
    fixture_expect(&f, "40x10");
    fixture_keys(&f, "<Size 80x24>");
    fixture_expect(&f, "Right: B");
}
END_TEST

START_TEST(finding_a_field)
{
    fixture_keys(&f, "/restit<Enter>");
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_CONTACT);
    ck_assert_str_eq(thud_form_focus(&f.tui->form)->path, "interfaces.1.contact.restitution");
    fixture_keys(&f, "/tolerance<Enter>");
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_RESULTS);
    ck_assert_str_eq(thud_form_focus(&f.tui->form)->path, "analysis.tolerance");
    fixture_keys(&f, "/2.stiffness<Enter>");
    ck_assert_str_eq(thud_form_focus(&f.tui->form)->path, "structures.2.stiffness.1");
}
END_TEST

START_TEST(records_are_listed_filtered_and_chosen)
{
    fixture_keys(&f, "<A-3>");
    fixture_expect(&f, "pulse.csv");
    fixture_expect(&f, "PGA 0.600 g");
    fixture_keys(&f, "fnothing<Enter>");
    fixture_expect(&f, "no other file");
    fixture_keys(&f, "f<C-u><Enter>s");
    ck_assert_int_eq(f.tui->doc.scene.record.sign, -1);
    fixture_keys(&f, "<Home><Enter>");
    ck_assert_str_eq(f.tui->doc.scene.record.file, "");
    fixture_expect(&f, "no ground motion");
}
END_TEST

/* Beginning and end by keys: the answer is that of the part, what is cut off stays in sight, and undo brings it back.
 */
START_TEST(a_motion_is_trimmed)
{
    char whole[24], part[24];
    fixture_keys(&f, "<A-3>");
    fixture_expect_not(&f, "cut off");
    thud_tui_number(answer_peak(THUD_CASE_NONE, 1, false), whole);
    fixture_keys(&f, "/record.to<Enter>-"); /* 3 s, one step back */
    ck_assert_double_eq_tol(f.tui->doc.scene.record.to_s, 2.9, 1e-12);
    fixture_keys(&f, "<Up>+{{{{{{{{{1.25<Enter>");
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
    fixture_keys(&f, "<A-3>9<Enter>"); /* nothing is left of it */
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

START_TEST(an_impact_is_opened)
{
    fixture_keys(&f, "<A-4><Tab><Down><Enter>");
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_PLOTS);
    fixture_expect(&f, "Impact force");
    fixture_expect(&f, "zoom");
    fixture_keys(&f, "N");
    fixture_keys(&f, "L");
    fixture_expect(&f, "Impact at");
}
END_TEST

START_TEST(the_movement_plays_and_ends)
{
    fixture_keys(&f, "<A-5>");
    fixture_keys(&f, "<Home> ");
    fixture_expect_not(&f, "paused");
    f.script.tick = 0.2;
    for (int i = 0; i < 2000 && !fixture_shows(&f, "paused"); i++)
        thud_tui_turn(f.tui, true);
    f.script.tick = 0.0;
    fixture_keys(&f, "");
    fixture_expect(&f, "t=4.000 s"); /* three seconds of motion and one of tail */
    fixture_expect(&f, "paused");
}
END_TEST

START_TEST(every_figure_is_drawn)
{
    fixture_keys(&f, "<A-5>");
    for (int i = 0; i < 9; i++) {
        char number[16];
        snprintf(number, sizeof number, "%d/9 ", i + 1);
        fixture_expect(&f, number);
        fixture_expect_not(&f, "more room");
        fixture_keys(&f, "e");
        fixture_expect(&f, "Written");
        fixture_keys(&f, "<Down>");
    }
}
END_TEST

START_TEST(help_names_every_key)
{
    fixture_keys(&f, "<Size 100x500>?");
    for (int i = 0; i < thud_key_count(); i++)
        if (thud_key_at(i)->where & THUD_AT_MODEL &&
            thud_key_action(THUD_AT_MODEL, thud_key_at(i)->key) == thud_key_at(i)->action) {
            char help[70];
            snprintf(help, sizeof help, "%.66s", thud_key_at(i)->help);
            fixture_expect(&f, help);
        }
    fixture_keys(&f, "q");
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_MODEL);
    ck_assert(!f.tui->quit);
}
END_TEST

/* Each field of the screen with its unit, bounds and default, from the tables. */
START_TEST(help_explains_every_field)
{
    static const struct {
        enum thud_group group;
        int screen;
    } part[] = {{THUD_GROUP_STRUCTURE, 1}, {THUD_GROUP_INTERFACE, 2}, {THUD_GROUP_BUMPER, 2},
                {THUD_GROUP_RECORD, 3},    {THUD_GROUP_ANALYSIS, 4},  {THUD_GROUP_STUDY, 6}};
    fixture_keys(&f, "<Size 200x600>");
    for (size_t i = 0; i < sizeof part / sizeof *part; i++) {
        int count;
        char keys[32];
        const struct thud_param *param = thud_group_params(part[i].group, &count);
        snprintf(keys, sizeof keys, "<A-%d>?", part[i].screen);
        fixture_keys(&f, keys);
        for (int k = 0; k < count; k++) {
            char help[64];
            snprintf(help, sizeof help, "%.60s", param[k].help);
            fixture_expect(&f, help);
            fixture_expect(&f, param[k].name);
        }
        fixture_keys(&f, "q");
    }
    fixture_keys(&f, "<A-2>?");
    fixture_expect(&f, "Law rubber (in use)");
    fixture_expect(&f, "Allowed: 0 cm to 500 cm.");
    fixture_expect(&f, "Default 2500 kN/mm.");
    fixture_expect(&f, "Usual: 0.3 to 0.95.");
}
END_TEST

START_TEST(help_is_searched)
{
    fixture_keys(&f, "<A-2>?");
    fixture_expect_not(&f, "post-yield");
    fixture_keys(&f, "n");
    fixture_expect(&f, "Nothing is searched for");
    fixture_keys(&f, "/POST-yield<Enter>");
    fixture_expect(&f, "▸      Share of the thickness");
    int marked = 0;
    for (int i = 0; i < f.tui->canvas.width * f.tui->canvas.height; i++)
        marked += f.tui->canvas.cell[i].style.role == THUD_ROLE_WARN;
    ck_assert_int_ge(marked, 2 * (int)strlen("post-yield")); /* all of them on the screen */
    fixture_keys(&f, "n");
    fixture_expect(&f, "▸  post-yield: stiffness");
    fixture_keys(&f, "N");
    fixture_expect(&f, "▸      Share of the thickness");
    fixture_keys(&f, "/xyzzy<Enter>");
    fixture_expect(&f, "nowhere in the help");
    fixture_keys(&f, "/kr-alpha<Enter><Size 60x16>"); /* another width: other lines, still found */
    fixture_expect(&f, "kr-alpha");
    fixture_keys(&f, "q/gap<Enter>"); /* elsewhere / finds fields */
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_CONTACT);
}
END_TEST

/* Two bodies of 320 t at 0.5 m/s: 8.3796 MN, so 26.186 m/s2 each (model.md's reference figures); the whole screen. */
START_TEST(the_whole_screen_of_two_bodies)
{
    static const char expected[] = " thud  bodies   no ground motion                                   run 0 ms  ok\n"
                                   "[1 Model] 2 Contact  3 Record  4 Results  5 Plots  6 Sweep  7 Bench  8 Help\n"
                                   "┌ Left: L (1 of 2) ────────────────────┐┌ Right: R (2 of 2) ───────────────────┐\n"
                                   "│ kind   ▸rigid      name    L         ││ kind    rigid      name    R         │\n"
                                   "│ mass             320 t               ││ mass             320 t               │\n"
                                   "│ height           -                   ││ height           -                   │\n"
                                   "│ velocity at 0    0.5 m/s             ││ velocity at 0    0 m/s               │\n"
                                   "│                                      ││                                      │\n"
                                   "│                                      ││                                      │\n"
                                   "│                                      ││                                      │\n"
                                   "│                                      ││                                      │\n"
                                   "│                                      ││                                      │\n"
                                   "└──────────────────────────────────────┘└──────────────────────────────────────┘\n"
                                   "┌ Peaks              no pounding  no bumper    bumper       ratio ─────────────┐\n"
                                   "│ L accel      m/s²  0            26.2         –                     force, no │\n"
                                   "│ R accel      m/s²  0            26.2         –                     ⡇         │\n"
                                   "│ L drift      mm    0            0            –                     ⡇         │\n"
                                   "│ R drift      mm    0            0            –                     ⡇         │\n"
                                   "│ force        MN    0            8.38         –                     ⡇         │\n"
                                   "│ clearance 0 mm                  1 impact                           ⡇⡀⡀⡀⡀⡀⡀⡀⡀ │\n"
                                   "└──────────────────────────────────────────────────────────────────────────────┘\n"
                                   " shear: storeys on the ground; rigid: a free body; isolated: storeys on an\n"
                                   " isolated slab; wall: moves with the ground. Allowed: shear, rigid, isolated,\n"
                                   " x swap  Enter edit  +/- step  r run  o open  / find  Tab pane   ? help  q quit\n";
    fixture_close(&f);
    fixture_open(&f, "bodies", 80, 24, true);
    char *text = fixture_text(&f);
    ck_assert_str_eq(text, expected);
    free(text);
}
END_TEST

/* The same in ASCII, the force over time and the bodies at the moment of the largest force. */
START_TEST(the_whole_plots_of_two_bodies)
{
    static const char expected[] = " thud  bodies   no ground motion                                   run 0 ms  ok\n"
                                   " 1 Model  2 Contact  3 Record  4 Results [5 Plots] 6 Sweep  7 Bench  8 Help\n"
                                   "+ 1/9 Impact force, L 1 and R 1 -----------------++ t=0.009 s x0.25 paused ----+\n"
                                   "|Force (MN)   1 no bumper                        ||no bumper *1 8.38 MN 3.01 mm|\n"
                                   "|10 +:                                           ||        ............        |\n"
                                   "|   |:                                           ||        :    ::    :        |\n"
                                   "|   |:                                           ||        :    ::    :        |\n"
                                   "| 8 +::                                          ||        :    ::    :        |\n"
                                   "|   |::                                          ||        :    ::    :        |\n"
                                   "| 6 +::                                          ||        :    ::    :        |\n"
                                   "|   |::                                          ||        :    ::    :        |\n"
                                   "|   |::                                          ||        :    :*    :        |\n"
                                   "| 4 +::                                          ||        :    ::    :        |\n"
                                   "|   |':                                          ||        :    ::    :        |\n"
                                   "| 2 +::                                          ||        :    ::    :        |\n"
                                   "|   |::                                          ||        :    ::    :        |\n"
                                   "|   |::                                          ||        :    ::    :        |\n"
                                   "| 0 +::..........................................||        :    ::    :        |\n"
                                   "|   ++--------+-------+--------+-------+--------+||        :....::....:        |\n"
                                   "|    0       0.2     0.4      0.6     0.8       s||............................|\n"
                                   "+------------------------------------------------++----------------------------+\n"
                                   "\n"
                                   "\n"
                                   " Space play  +/- speed  Left/Right time  n/N impact  L largest   ? help  q quit\n";
    fixture_close(&f);
    fixture_open(&f, "bodies", 80, 24, false);
    fixture_keys(&f, "<A-5>");
    char *text = fixture_text(&f);
    ck_assert_str_eq(text, expected);
    free(text);
}
END_TEST

/* On a wide terminal the values stand beside the figure, and an edit there changes both at once. */
START_TEST(values_are_edited_beside_the_figure)
{
    fixture_keys(&f, "<Size 130x40><A-5>");
    fixture_expect(&f, "x0.25 paused");
    fixture_keys(&f, "+"); /* with the cursor on the figure: faster */
    fixture_expect(&f, "x0.5 paused");
    fixture_keys(&f, "<S-Tab>");
    ck_assert_str_eq(thud_form_focus(&f.tui->form)->path, "interfaces.1.gap");
    fixture_keys(&f, "+<Down><Down>0.7<Enter>");
    fixture_expect(&f, "x0.5 paused");
    ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.021, 1e-15);
    const struct thud_law_choice *contact = &f.tui->doc.scene.interface[0].contact;
    ck_assert_double_eq(contact->value[thud_law_param(contact->law, "restitution")], 0.7);
    fixture_keys(&f, "B");
    ck_assert(!f.tui->doc.scene.interface[0].has_bumper);
    fixture_expect(&f, "[ ] off");
    fixture_expect(&f, "bumper on -> off");
    fixture_expect(&f, "1/9 Impact force");
    fixture_keys(&f, "<Size 80x24>"); /* the pane is gone, and its keys with it */
    fixture_expect_not(&f, "[ ] off");
    fixture_keys(&f, "+");
    fixture_expect(&f, "x1 paused");
}
END_TEST

/* Where the law lets go of much of its force at once, the larger side of the jump is said. */
START_TEST(the_largest_force_is_said_at_its_moment)
{
    char force[24], expected[48];
    int impacts;
    fixture_keys(&f, "<A-5>L");
    const struct thud_result *result = thud_live_result(&f.tui->live, THUD_LIVE_BUMPER);
    ck_assert_ptr_nonnull(result);
    int worst = 0;
    for (int i = 1; i < result->ncontacts; i++)
        if (result->contact[i].force.value > result->contact[worst].force.value)
            worst = i;
    snprintf(force, sizeof force, "%.3g", 1e-6 * thud_live_force(&f.tui->live, THUD_LIVE_BUMPER, 0, &impacts));
    snprintf(expected, sizeof expected, "*%d %s MN", result->contact[worst].left_floor, force);
    fixture_keys(&f, "<A-1><A-5>");
    fixture_expect(&f, "t=");
    f.tui->plots->time_s = result->contact[worst].force.time_s;
    fixture_keys(&f, "");
    fixture_expect(&f, expected);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui screens");
    TCase *screens = tcase_create("screens");
    tcase_set_timeout(screens, 60.0);
    tcase_add_checked_fixture(screens, setup, teardown);
    tcase_add_test(screens, the_numbers_are_the_answers);
    tcase_add_test(screens, no_old_number_after_a_failure);
    tcase_add_test(screens, a_change_shows_as_an_arrow);
    tcase_add_test(screens, a_long_run_is_seen_and_stopped);
    tcase_add_test(screens, the_newest_edit_wins);
    tcase_add_test(screens, live_turns_itself_off_when_slow);
    tcase_add_test(screens, every_screen_in_ascii);
    tcase_add_test(screens, small_terminals);
    tcase_add_test(screens, finding_a_field);
    tcase_add_test(screens, records_are_listed_filtered_and_chosen);
    tcase_add_test(screens, a_motion_is_trimmed);
    tcase_add_test(screens, an_impact_is_opened);
    tcase_add_test(screens, the_movement_plays_and_ends);
    tcase_add_test(screens, every_figure_is_drawn);
    tcase_add_test(screens, values_are_edited_beside_the_figure);
    tcase_add_test(screens, the_largest_force_is_said_at_its_moment);
    tcase_add_test(screens, help_names_every_key);
    tcase_add_test(screens, help_explains_every_field);
    tcase_add_test(screens, help_is_searched);
    tcase_add_test(screens, the_whole_screen_of_two_bodies);
    tcase_add_test(screens, the_whole_plots_of_two_bodies);
    suite_add_tcase(suite, screens);
    return suite;
}
