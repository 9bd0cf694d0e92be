/* What the screens show: whole ones, and that their numbers are the result's own. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tui/document/field.h"
#include "tui/screens/plots.h"
#include "tui/screens/sweep_screen.h"
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

START_TEST(every_screen_in_ascii)
{
    fixture_close(&f);
    fixture_open(&f, "towers", 80, 24, false);
    fixture_keys(&f, ":live off<Enter>");
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
    fixture_keys(&f, "<A-4>"); /* numbers also in the least room */
    char number[24];
    fixture_expect(
        &f, thud_tui_number(thud_live_floor(&f.tui->run.live, THUD_LIVE_BUMPER, 0, 1, THUD_PEAK_ACCELERATION), number));
    fixture_keys(&f, "<A-1><Size 39x10>");
    fixture_expect(&f, "40x10");
    fixture_keys(&f, "<Size 80x24>");
    fixture_expect(&f, "Right: B");
}
END_TEST

START_TEST(finding_a_field)
{
    fixture_keys(&f, "/pga<Enter>");
    ck_assert_str_eq(thud_form_focus(&f.tui->form)->path, "record.peak");
    fixture_keys(&f, "/structures.2 COR<Esc>/bumper cor<Enter>");
    ck_assert_str_eq(thud_form_focus(&f.tui->form)->path, "interfaces.1.bumper.restitution");
    fixture_keys(&f, "/structures.2.mass.3<Enter>");
    ck_assert_str_eq(thud_form_focus(&f.tui->form)->path, "structures.2.mass.3");
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

/* One list for all there is: also by letters in their order; what cannot be done now says why. */
START_TEST(everything_is_found)
{
    fixture_keys(&f, "<C-p>results<Enter>");
    ck_assert_int_eq(f.tui->screen, THUD_SCREEN_RESULTS);
    fixture_keys(&f, "<C-p>figure hysteresis<Enter>"); /* no storey yields: there is no such figure */
    fixture_expect(&f, "nothing fits");
    fixture_keys(&f, "<C-u>figure floor acc<Enter>");
    ck_assert_int_eq(f.tui->screen, THUD_SCREEN_PLOTS);
    ck_assert_int_eq(thud_plots(f.tui)->plot, THUD_PLOT_ACCELERATION);
    fixture_keys(&f, "<C-p>intfcs1gap<Enter>"); /* letters of interfaces.1.gap */
    ck_assert_str_eq(thud_form_focus(&f.tui->form)->path, "interfaces.1.gap");
    fixture_keys(&f, "<C-p>key undo the");
    fixture_expect(&f, "(Nothing to undo)");
    fixture_keys(&f, "<Esc><C-p>study.cases<Enter><Enter>none<Enter>");
    ck_assert_int_eq(f.tui->screen, THUD_SCREEN_SWEEP);
    ck_assert_int_eq(f.tui->doc.scene.study.ncases, 1);
    fixture_keys(&f, "<C-p>undo the last<Enter>");
    ck_assert_int_eq(f.tui->doc.scene.study.ncases, 0);
    fixture_keys(&f, "<C-p>command :case<Enter>none<Enter>"); /* what has to follow is typed */
    ck_assert(!f.tui->doc.scene.interface[0].has_bumper);
    fixture_keys(&f, "u<C-p>take pulse<Enter>");
    fixture_expect(&f, "as recorded");
    fixture_keys(&f, "u<C-p>help law hertz-damp<Enter>");
    ck_assert_int_eq(f.tui->screen, THUD_SCREEN_HELP);
    fixture_expect(&f, "Law hertz-damp");
    fixture_keys(&f, "q<C-p>preset bodies<Enter>");
    ck_assert_str_eq(f.tui->doc.scene.name, "bodies");
}
END_TEST

START_TEST(a_digit_goes_to_its_screen)
{
    fixture_keys(&f, ":live off<Enter>");
    for (int from = 0; from < THUD_SCREENS; from++)
        for (int to = 0; to < THUD_SCREENS; to++) {
            char keys[32];
            snprintf(keys, sizeof keys, "<A-%d>%s%d", from + 1, to % 2 ? "" : "g", to + 1);
            fixture_keys(&f, keys);
            ck_assert_int_eq((int)f.tui->screen, to);
        }
    fixture_keys(&f, "2<Enter>5"); /* while a value is typed it is text */
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_CONTACT);
    ck_assert_str_eq(f.tui->dialog.line.text, "5");
    char next[8], said[40]; /* the digit behind the last screen's, where there is one */
    snprintf(next, sizeof next, "<Esc>%d", THUD_SCREENS + 1);
    snprintf(said, sizeof said, "There is no screen %d: 1 to %d", THUD_SCREENS + 1, THUD_SCREENS);
    if (THUD_SCREENS < 9) {
        fixture_keys(&f, next);
        fixture_expect(&f, said);
    }
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

/* The list's cursor goes with the record in use; numbers of a figure are no motion. */
START_TEST(the_list_of_records_follows)
{
    fixture_write(&f, "quake.csv", "time_s,acceleration_g\n0,0.1\n0.01,-0.1\n0.02,0\n");
    fixture_write(&f, "towers-impact-force.csv", "Time (s),Force (MN)\n0,0\n1,1\n");
    fixture_write(&f, "towers-impact-force.gp", "# thud\n");
    fixture_write(&f, "towers.frame.csv", "Story,1,2\n,kN/m,kN/m\n1,2e5,-1e5\n2,-1e5,1e5\n"); /* of the preset */
    fixture_keys(&f, "3");
    ck_assert_str_eq(f.tui->form.focus[THUD_SCREEN_RECORD], "record pulse.csv");
    fixture_expect(&f, "quake.csv");
    fixture_expect_not(&f, "towers-impact-force");
    fixture_expect_not(&f, "towers.frame");
    fixture_keys(&f, ":record quake.csv<Enter>");
    ck_assert_str_eq(f.tui->form.focus[THUD_SCREEN_RECORD], "record quake.csv");
    fixture_keys(&f, "u");
    ck_assert_str_eq(f.tui->form.focus[THUD_SCREEN_RECORD], "record pulse.csv");
}
END_TEST

/* Lines of Sweep say what is typed there, and the form of a new scene nothing of the field behind it. */
START_TEST(fields_say_what_they_are)
{
    fixture_keys(&f, "6<Home>");
    fixture_expect(&f, "KEY=FROM:TO:STEP");
    fixture_keys(&f, "1");
    fixture_expect(&f, "estimated: by area.");
    fixture_keys(&f, "<Enter>"); /* the list of its values */
    fixture_expect(&f, "estimated: by area.");
    fixture_keys(&f, "<Esc><C-p>gap");
    fixture_expect_not(&f, "estimated: by area.");
    fixture_keys(&f, "<Esc>n");
    fixture_expect_not(&f, "estimated: by area.");
    fixture_keys(&f, "<Esc>");
}
END_TEST

/* In the first line a long name gives way, and not the peak; a long message is shown whole, over the panes. */
START_TEST(what_is_said_is_not_cut)
{
    fixture_write_pulse(&f);
    char from[200], to[200], text[400];
    snprintf(from, sizeof from, "%s/pulse.csv", f.folder);
    snprintf(to, sizeof to, "%s/a-ground-motion-with-a-name-that-is-longer-than-the-line.csv", f.folder);
    ck_assert_int_eq(rename(from, to), 0);
    fixture_keys(&f, ":record a-ground-motion-with-a-name-that-is-longer-than-the-line.csv<Enter>:peak 1.22 g<Enter>");
    fixture_expect(&f, " 1.22 g scaled x1.22 + ");
    for (size_t i = 0; i < sizeof text - 20; i++)
        text[i] = i % 8 == 7 ? ' ' : (char)('a' + i / 8 % 26);
    snprintf(text + sizeof text - 20, 20, "and this at the end");
    thud_tui_say(f.tui, THUD_ROLE_ERROR, "%s", text);
    thud_tui_draw(f.tui);
    fixture_expect(&f, "at the end");
    fixture_expect(&f, "aaaaaaa");
    fixture_keys(&f, "<Esc>");
    fixture_expect_not(&f, "aaaaaaa");
}
END_TEST

START_TEST(an_impact_is_opened)
{
    fixture_keys(&f, "<A-4><Tab><Down><Enter>");
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_PLOTS);
    fixture_expect(&f, "impact force (MN)");
    fixture_expect(&f, "zoom");
    fixture_keys(&f, "N");
    fixture_keys(&f, "L");
    fixture_expect(&f, "Impact at");
}
END_TEST

/* The cursor stands at the peak itself, of every case: the movement shows the force and the figure's cursor its
 * time. */
START_TEST(the_largest_impact_is_at_the_largest_force)
{
    fixture_keys(&f, "<A-5>");
    for (int i = 0; i < 2; i++) {
        fixture_keys(&f, "L");
        const struct thud_plots_state *p = thud_plots(f.tui);
        const struct thud_result *result = thud_live_result(&f.tui->run.live, p->sight.which);
        const struct thud_peak *most = &result->contact[0].force;
        for (int c = 1; c < result->ncontacts; c++)
            if (result->contact[c].force.value > most->value)
                most = &result->contact[c].force;
        char text[32];
        ck_assert_double_eq_tol(p->time_s, most->time_s, 1e-9);
        snprintf(text, sizeof text, " %.3g MN", 1e-6 * most->value);
        fixture_expect(&f, text);
        fixture_keys(&f, "bb"); /* the other case with contacts */
    }
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
    for (int i = 0; i < 8; i++) {
        char number[16];
        snprintf(number, sizeof number, "%d/8 ", i + 1);
        fixture_expect(&f, number);
        fixture_expect_not(&f, "more room");
        fixture_keys(&f, "e");
        fixture_expect(&f, "Written");
        fixture_keys(&f, "<Down>");
    }
}
END_TEST

/* The text of a screen but for the names of the screens, of which there may be more: what ends its second line. */
static char *but_for_tabs(char *text)
{
    char *tabs = strchr(text, '\n') + 1, *end = strchr(tabs, '\n');
    memmove(tabs, end, strlen(end) + 1);
    return text;
}

/* Two bodies of 320 t at 0.5 m/s: 8.3796 MN, so 26.186 m/s2 each (model.md's reference figures); the whole screen. */
START_TEST(the_whole_screen_of_two_bodies)
{
    static const char expected[] = " thud  bodies   no ground motion                                   run 0 ms  ok\n"
                                   "\n"
                                   " POUNDS at 0 cm: 1 impact, 8.38 MN\n"
                                   "┌ Left: L (1 of 2) ────────────────────┐┌ Right: R (2 of 2) ───────────────────┐\n"
                                   "│ kind   ▸rigid      name    L         ││ kind    rigid      name    R         │\n"
                                   "│ mass             320 t               ││ mass             320 t               │\n"
                                   "│ height           -                   ││ height           -                   │\n"
                                   "│ velocity at 0    0.5 m/s             ││ velocity at 0    0 m/s               │\n"
                                   "│ source             -                 ││ source             -                 │\n"
                                   "│                                      ││                                      │\n"
                                   "│                                      ││                                      │\n"
                                   "│                                      ││                                      │\n"
                                   "└──────────────────────────────────────┘└──────────────────────────────────────┘\n"
                                   "┌ Peaks              no pounding    no bumper       bumper   ratio ────────────┐\n"
                                   "│ L accel      m/s²            0         26.2            –           force     │\n"
                                   "│ R accel      m/s²            0         26.2            –           ⡇         │\n"
                                   "│ force        MN              0         8.38            –           ⡇         │\n"
                                   "│ clearance 0 mm                     1 impact                        ⡇         │\n"
                                   "│                                                                    ⡇         │\n"
                                   "│                                                                    ⡇⡀⡀⡀⡀⡀⡀⡀⡀ │\n"
                                   "└──────────────────────────────────────────────────────────────────────────────┘\n"
                                   " shear: storeys; rigid: a free body; isolated: storeys on an isolated slab;\n"
                                   " wall: moves with the ground; matrix, modes: by a file; estimated: by area.\n"
                                   " x swap  Enter edit  +/- step  n new  r run  o open  / find      ? help  q quit\n";
    fixture_close(&f);
    fixture_open(&f, "bodies", 80, 24, true);
    char *text = but_for_tabs(fixture_text(&f));
    ck_assert_str_eq(text, expected);
    free(text);
}
END_TEST

/* The same in ASCII, the force over time and the bodies at the moment of the largest force. */
START_TEST(the_whole_plots_of_two_bodies)
{
    static const char expected[] = " thud  bodies   no ground motion                                   run 0 ms  ok\n"
                                   "\n"
                                   " POUNDS at 0 cm: 1 impact, 8.38 MN\n"
                                   "+ 1/8 impact force (MN), floor 1, pounding, gap~ ++ t=0.009 s x0.25 paused ----+\n"
                                   "|Impact force (MN)   1 pounding                  ||pounding  *1 8.38 MN 3.01 mm|\n"
                                   "| 10 +:                                          ||         ..........         |\n"
                                   "|    |:                                          ||         :   ::   :         |\n"
                                   "|    |.                                          ||         :   ::   :         |\n"
                                   "|7.5 +:.                                         ||         :   ::   :         |\n"
                                   "|    |::                                         ||         :   ::   :         |\n"
                                   "|    |::                                         ||         :   ::   :         |\n"
                                   "|  5 +::                                         ||         :   :*   :         |\n"
                                   "|    |::                                         ||         :   ::   :         |\n"
                                   "|    |::                                         ||         :   ::   :         |\n"
                                   "|2.5 +::                                         ||         :   ::   :         |\n"
                                   "|    |::                                         ||         :   ::   :         |\n"
                                   "|    |::                                         ||         :   ::   :         |\n"
                                   "|  0 +::.......................................  ||         :...::...:         |\n"
                                   "|    ++-------+-------+-------+-------+-------+--||............................|\n"
                                   "|     0      0.2     0.4     0.6     0.8 Time (s)|| +---------+ 500 mm across  |\n"
                                   "+------------------------------------------------++----------------------------+\n"
                                   " next: 6 finds the gap, U keeps this design, R reports\n"
                                   " Time 0.008812 s:  pounding 8.38 MN\n"
                                   " Space play  +/- speed  Left/Right time  n/N impact  L largest   ? help  q quit\n";
    fixture_close(&f);
    fixture_open(&f, "bodies", 80, 24, false);
    fixture_keys(&f, "<A-5>");
    char *text = but_for_tabs(fixture_text(&f));
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
    fixture_keys(&f, "+<Down><Down><Enter>0.7<Enter>");
    fixture_expect(&f, "x0.5 paused");
    ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.021, 1e-15);
    const struct thud_law_choice *contact = &f.tui->doc.scene.interface[0].contact;
    ck_assert_double_eq(contact->value[thud_law_param(contact->law, "restitution")], 0.7);
    fixture_keys(&f, "B");
    ck_assert(!f.tui->doc.scene.interface[0].has_bumper);
    fixture_expect(&f, "[ ] off");
    fixture_expect(&f, "bumper on -> off");
    fixture_expect(&f, "1/8 impact force (MN)");
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
    const struct thud_result *result = thud_live_result(&f.tui->run.live, THUD_LIVE_BUMPER);
    ck_assert_ptr_nonnull(result);
    int worst = 0;
    for (int i = 1; i < result->ncontacts; i++)
        if (result->contact[i].force.value > result->contact[worst].force.value)
            worst = i;
    snprintf(force, sizeof force, "%.3g", 1e-6 * thud_live_force(&f.tui->run.live, THUD_LIVE_BUMPER, 0, &impacts));
    snprintf(expected, sizeof expected, "*%d %s MN", result->contact[worst].left_floor, force);
    fixture_keys(&f, "<A-1><A-5>");
    fixture_expect(&f, "t=");
    thud_plots(f.tui)->time_s = result->contact[worst].force.time_s;
    fixture_keys(&f, "");
    fixture_expect(&f, expected);
    char number[24]; /* and below, with the other case at that time */
    int all;
    double most = thud_live_force(&f.tui->run.live, THUD_LIVE_BUMPER, 0, &all);
    snprintf(expected, sizeof expected, "bumper %s MN", thud_tui_number(1e-6 * most, number));
    fixture_expect(&f, expected);
}
END_TEST

/* The highest number on the chart's upright axis. */
static double scale(void)
{
    char *text = fixture_text(&f);
    double most = -1.0, value;
    for (char *line = text; line; line = strchr(line, '\n'), line += line != NULL)
        if (sscanf(line, "│%lf ┤", &value) == 1 && value > most)
            most = value;
    free(text);
    return most;
}

/* While the movement plays the scale of a closer look stands still; paused it fits what is shown. */
START_TEST(the_scale_stands_still_while_it_plays)
{
    fixture_keys(&f, "<A-5>");
    fixture_keys(&f, "<Home>zzz");
    double fits = scale();
    fixture_keys(&f, " ");
    double first = scale();
    ck_assert_double_gt(first, fits);
    thud_plots(f.tui)->time_s = 2.0;
    fixture_keys(&f, "");
    ck_assert_double_eq(scale(), first);
    fixture_keys(&f, " <Home>");
    ck_assert_double_eq(scale(), fits);
}
END_TEST

static bool on_screen(const char *prefix, const char *name)
{
    char path[2][THUD_PATH_MAX];
    snprintf(path[0], sizeof path[0], "%s.%s", prefix, name);
    snprintf(path[1], sizeof path[1], "%s.%s.1", prefix, name);
    for (int i = 0; i < f.tui->form.n; i++)
        if (strcmp(f.tui->form.field[i].path, path[0]) == 0 || strcmp(f.tui->form.field[i].path, path[1]) == 0)
            return true;
    return false;
}

/* What a preset can say can be edited: each key of the tables is a field of its screen. */
START_TEST(every_key_has_a_field)
{
    static const struct {
        enum thud_group group;
        int screen;
        const char *prefix;
    } part[] = {{THUD_GROUP_STRUCTURE, 1, "structures.1"},
                {THUD_GROUP_INTERFACE, 2, "interfaces.1"},
                {THUD_GROUP_CONTACT, 2, "interfaces.1.contact"},
                {THUD_GROUP_BUMPER, 2, "interfaces.1.bumper"},
                {THUD_GROUP_RECORD, 3, "record"},
                {THUD_GROUP_ANALYSIS, 4, "analysis"}};
    for (size_t i = 0; i < sizeof part / sizeof *part; i++) {
        char keys[40];
        const struct thud_param *param;
        snprintf(keys, sizeof keys, "<Size 130x60><A-%d>", part[i].screen);
        fixture_keys(&f, keys);
        for (int k = 0; (param = thud_group_param(part[i].group, k)); k++)
            if (part[i].group != THUD_GROUP_STRUCTURE || thud_structure_has(THUD_SHEAR, k))
                ck_assert_msg(on_screen(part[i].prefix, param->name), "%s.%s", part[i].prefix, param->name);
    }
    fixture_keys(&f, "<A-2>");
    const struct thud_law *law = f.tui->doc.scene.interface[0].bumper.law;
    for (int k = 0; k < law->nparams; k++)
        ck_assert_msg(on_screen("interfaces.1.bumper", law->params[k].name), "%s", law->params[k].name);
}
END_TEST

/* At 80 columns all four quantities are reached, and names of any script and length are told apart. */
START_TEST(every_quantity_and_long_names_at_80_columns)
{
    fixture_keys(
        &f,
        ":set structures.1.name Library North<Enter>:set structures.2.name \xe4\xb8\xad\xe5\xa4\xae Library<Enter>");
    fixture_expect(&f, "Library North acc");
    fixture_expect(&f, "\xe4\xb8\xad\xe5\xa4\xae Library drift");
    fixture_keys(&f, "4");
    fixture_expect(&f, "Library North 2");
    fixture_expect(&f, "acceleration m/s");
    fixture_expect(&f, "drift mm");
    fixture_keys(&f, "c");
    fixture_expect(&f, "displacement mm");
    fixture_expect(&f, "velocity m/s");
    fixture_keys(&f, "c");
    fixture_expect(&f, "drift mm");
}
END_TEST

START_TEST(no_contact_is_said)
{
    fixture_keys(&f, ":set gap 90 cm<Enter>");
    fixture_expect(&f, "contact");
    fixture_keys(&f, "5");
    fixture_expect(&f, "no contact at this gap");
}
END_TEST

/* A cursor on the curves of Contact and Record, by keys and by the mouse. */
START_TEST(charts_are_read)
{
    fixture_keys(&f, "2<Tab>");
    fixture_expect(&f, "Left and Right read values");
    fixture_keys(&f, "<Right><Right>");
    fixture_expect(&f, "Indentation ");
    fixture_keys(&f, "3<Tab><Left>");
    fixture_expect(&f, "Time 1.");
    double before = f.tui->reading[THUD_SCREEN_RECORD];
    char keys[64];
    snprintf(keys, sizeof keys, "<Click %d,%d>", f.tui->chart.plot.x, f.tui->chart.plot.y);
    fixture_keys(&f, keys);
    ck_assert_double_lt(f.tui->reading[THUD_SCREEN_RECORD], before);
    ck_assert_double_eq_tol(f.tui->reading[THUD_SCREEN_RECORD], 0.0, 1e-12);
    fixture_keys(&f, "5");
    snprintf(keys, sizeof keys, "<Click %d,%d>", f.tui->chart.plot.x, f.tui->chart.plot.y + 2);
    fixture_keys(&f, keys);
    fixture_expect(&f, "t=0.000 s");
}
END_TEST

/* While a run goes on, the numbers before it stay. */
START_TEST(old_numbers_stay_until_the_new_are_there)
{
    double old = thud_live_peak(&f.tui->run.live, THUD_LIVE_NONE, 0, THUD_PEAK_ACCELERATION);
    fixture_keys(&f, "2<Enter>1.5");
    thud_tui_key(f.tui, THUD_KEY_ENTER);
    ck_assert(f.tui->run.live.running && thud_live_is_old(&f.tui->run.live, THUD_LIVE_NONE));
    ck_assert_double_eq(thud_live_peak(&f.tui->run.live, THUD_LIVE_NONE, 0, THUD_PEAK_ACCELERATION), old);
    fixture_keys(&f, "");
    ck_assert(!thud_live_is_old(&f.tui->run.live, THUD_LIVE_NONE));
    ck_assert_double_ne(thud_live_peak(&f.tui->run.live, THUD_LIVE_NONE, 0, THUD_PEAK_ACCELERATION), old);
}
END_TEST

START_TEST(periods_stay_with_live_off)
{
    fixture_keys(&f, ":live off<Enter>:set structures.1.stiffness 150 MN/m<Enter>1");
    fixture_expect(&f, "T1 0.431 s"); /* half the frequency of 600 MN/m */
    fixture_expect(&f, "not run");
}
END_TEST

/* A screen of this test's own: a field, and how often it was asked for the next figure. */
struct counter {
    int next, begun;
};

static struct counter *counter(const struct thud_tui *tui)
{
    return tui->own[THUD_SCREENS];
}

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    (void)tui;
    pane[0] = area;
    return 1;
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    thud_field_row(tui, index, pane, 0, "the gap", "interfaces.1.gap");
    thud_field_note(pane, 1, "asked %d times", counter(tui)->next);
    return 2;
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    (void)tui;
    snprintf(text, size, "Pane %d of a test", index);
}

static void begin(struct thud_tui *tui)
{
    counter(tui)->begun = 7;
}

static enum thud_reaction act(struct thud_tui *tui, enum thud_action action)
{
    counter(tui)->next += action == THUD_DO_RUN;
    return action == THUD_DO_RUN ? THUD_DONE : action == THUD_DO_COPY ? THUD_LEAVE : THUD_NOT_MINE;
}

THUD_VIEW(test, "Test", OTHER, .keys = "interfaces.1.gap", .size = sizeof(struct counter), .begin = begin, .act = act);

START_TEST(a_screen_of_its_own)
{
    struct thud_error err;
    char path[128];
    snprintf(path, sizeof path, "%s/towers.yaml", f.folder);
    struct thud_tui_options options = {.preset = path, .paths = &f.paths, .output = f.folder, .view = &thud_view_test};
    thud_tui_free(f.tui);
    ck_assert_int_eq(thud_tui_create(&options, &f.backend, &f.tui, &err), THUD_OK);
    if (THUD_SCREENS > 8)
        return; /* no digit is left for this one */
    const char own = '1' + THUD_SCREENS;
    fixture_keys(&f, (char[]){own, '\0'});
    fixture_expect(&f, "Pane 0 of a test");
    ck_assert_int_eq(counter(f.tui)->begun, 7);
    fixture_keys(&f, "rr<Down><Enter>3 cm<Enter>"); /* its own action; the loop's on its field */
    fixture_expect(&f, "asked 2 times");
    fixture_expect(&f, "3 cm");
    ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.03, 1e-15);
    ck_assert_uint_eq(f.tui->run.revision, f.tui->doc.revision); /* and it was run again */
    fixture_keys(&f, "4/interfaces.1.gap<Enter>");               /* the field is found on it */
    ck_assert_int_eq(f.tui->screen, THUD_SCREENS);
    fixture_keys(&f, (char[]){'5', own, 'y', '\0'}); /* it is left for the screen before */
    ck_assert_int_eq(f.tui->screen, THUD_SCREEN_PLOTS);
    fixture_keys(&f, "<lt>:open bodies<Enter>y"); /* and begins anew with every preset */
    fixture_keys(&f, (char[]){own, '\0'});
    fixture_expect(&f, "asked 0 times");
    ck_assert_int_eq(counter(f.tui)->begun, 7);
}
END_TEST

START_TEST(keys_and_numbers_are_where_they_are_looked_for)
{
    fixture_keys(&f, "$"); /* no key is silent */
    fixture_expect(&f, "$ does nothing here");
    fixture_expect_not(&f, "U designs");
    fixture_keys(&f, "<Size 200x40>"); /* there is room for more keys */
    fixture_expect(&f, "U designs");
    fixture_expect(&f, "A structure");
    fixture_keys(&f, "<Size 80x24>4"); /* decimals of a column end at one place */
    int ends = 0;
    for (int y = 5; y < 10; y++) {
        const struct thud_cell *row = &f.tui->canvas.cell[y * 80];
        if (row[18].glyph != ' ' && row[19].glyph == ' ')
            ends++;
    }
    ck_assert_int_eq(ends, 5); /* A has two floors, B three */
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui screens");
    TCase *screens = tcase_create("screens");
    tcase_set_timeout(screens, 60.0);
    tcase_add_checked_fixture(screens, setup, teardown);
    tcase_add_test(screens, every_screen_in_ascii);
    tcase_add_test(screens, small_terminals);
    tcase_add_test(screens, finding_a_field);
    tcase_add_test(screens, everything_is_found);
    tcase_add_test(screens, a_digit_goes_to_its_screen);
    tcase_add_test(screens, records_are_listed_filtered_and_chosen);
    tcase_add_test(screens, the_list_of_records_follows);
    tcase_add_test(screens, fields_say_what_they_are);
    tcase_add_test(screens, what_is_said_is_not_cut);
    tcase_add_test(screens, an_impact_is_opened);
    tcase_add_test(screens, the_largest_impact_is_at_the_largest_force);
    tcase_add_test(screens, the_movement_plays_and_ends);
    tcase_add_test(screens, every_figure_is_drawn);
    tcase_add_test(screens, values_are_edited_beside_the_figure);
    tcase_add_test(screens, the_largest_force_is_said_at_its_moment);
    tcase_add_test(screens, the_scale_stands_still_while_it_plays);
    tcase_add_test(screens, every_key_has_a_field);
    tcase_add_test(screens, every_quantity_and_long_names_at_80_columns);
    tcase_add_test(screens, no_contact_is_said);
    tcase_add_test(screens, charts_are_read);
    tcase_add_test(screens, old_numbers_stay_until_the_new_are_there);
    tcase_add_test(screens, periods_stay_with_live_off);
    tcase_add_test(screens, keys_and_numbers_are_where_they_are_looked_for);
    tcase_add_test(screens, a_screen_of_its_own);
    tcase_add_test(screens, the_whole_screen_of_two_bodies);
    tcase_add_test(screens, the_whole_plots_of_two_bodies);
    suite_add_tcase(suite, screens);
    return suite;
}
