/* Editing and undo: scripted keys, and what the screen and the scene then say. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

static const struct thud_scene *scene(void)
{
    return &f.tui->doc.scene;
}

START_TEST(a_first_digit_replaces)
{
    fixture_keys(&f, "<A-2>3<Enter>");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.03, 1e-15);
    fixture_expect(&f, "towers [+]");
    fixture_expect(&f, "3 cm");
}
END_TEST

START_TEST(the_old_text_is_edited)
{
    fixture_keys(&f, "<A-2><F2><Home>1<Enter>");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.12, 1e-15);
    fixture_keys(&f, "<Enter><BS><BS>mm<Esc>");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.12, 1e-15);
}
END_TEST

START_TEST(units_convert)
{
    static const struct {
        const char *keys;
        double gap_m;
    } row[] = {{"50 mm<Enter>", 0.05},
               {"5cm<Enter>", 0.05},
               {"0.04 m<Enter>", 0.04},
               {"4<Enter>", 0.04},
               {"1 in<Enter>", 0.0254}};
    fixture_keys(&f, "<A-2>");
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        fixture_keys(&f, row[i].keys);
        ck_assert_double_eq_tol(scene()->interface[0].gap_m, row[i].gap_m, 1e-12);
    }
}
END_TEST

START_TEST(no_digit_is_lost)
{
    fixture_keys(&f, "<A-2>1.23456789<Enter>");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.0123456789, 1e-17);
    fixture_expect(&f, "1.23456789 cm");
}
END_TEST

/* Refused: the reason shows, what was typed stays in the editor, the scene is as it was. */
START_TEST(wrong_input_is_refused)
{
    static const char *const keys[] = {"3 kN", "3 parsec", "1e99", "600", "3,5", "1.2.3"};
    fixture_keys(&f, "<A-2>");
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        fixture_keys(&f, keys[i]);
        fixture_keys(&f, "<Enter>");
        ck_assert_msg(f.tui->mode == THUD_MODE_TYPING, "%s was taken", keys[i]);
        ck_assert_double_eq(scene()->interface[0].gap_m, 0.02);
        fixture_expect(&f, keys[i]);
        fixture_expect(&f, " ! ");
        fixture_keys(&f, "<Esc>");
    }
    ck_assert_int_eq(f.tui->doc.undo.count, 0);
}
END_TEST

START_TEST(a_dimension_is_named)
{
    fixture_keys(&f, "<A-2>320 kN<Enter>");
    fixture_expect(&f, "force");
    fixture_expect(&f, "length");
}
END_TEST

START_TEST(soft_bounds_warn)
{
    fixture_keys(&f, ":set structures.1.height 8 m<Enter>");
    ck_assert_double_eq(scene()->structure[0].height_m[0], 8.0);
    fixture_expect(&f, "unusual");
}
END_TEST

START_TEST(plus_and_minus_step)
{
    fixture_keys(&f, "<A-2>10<Enter>+");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.11, 1e-12);
    fixture_keys(&f, "--");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.09, 1e-12);
    fixture_keys(&f, "}");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.10, 1e-12);
    fixture_keys(&f, "{-");
    ck_assert(scene()->interface[0].gap_m >= 0.0);
}
END_TEST

START_TEST(a_floor_for_all_floors)
{
    fixture_keys(&f, "/structures.2.mass<Enter>500<Enter>");
    ck_assert_double_eq(scene()->structure[1].mass_kg[0], 500e3);
    ck_assert_double_eq(scene()->structure[1].mass_kg[1], 320e3);
    fixture_keys(&f, "=");
    for (int i = 0; i < 3; i++)
        ck_assert_double_eq(scene()->structure[1].mass_kg[i], 500e3);
}
END_TEST

START_TEST(undo_goes_all_the_way_and_says_what)
{
    struct thud_scene first = *scene();
    fixture_keys(&f, "<A-2>3<Enter>4<Enter>B<A-1>xADa<A-3>s");
    struct thud_scene last = *scene();
    int steps = f.tui->doc.undo.count;
    ck_assert_int_ge(steps, 6);
    fixture_keys(&f, "u");
    fixture_expect(&f, "Undone: record.sign + -> -");
    for (int i = 1; i < steps; i++)
        fixture_keys(&f, "u");
    ck_assert_mem_eq(scene(), &first, sizeof first);
    fixture_expect_not(&f, "[+]");
    fixture_keys(&f, "u");
    fixture_expect(&f, "Nothing to undo");
    for (int i = 0; i < steps; i++)
        fixture_keys(&f, "<C-r>");
    ck_assert_mem_eq(scene(), &last, sizeof last);
}
END_TEST

START_TEST(structures_and_storeys)
{
    fixture_keys(&f, "a");
    ck_assert_int_eq(scene()->structure[0].storeys, 3);
    fixture_keys(&f, "<Down><Down><Down>d");
    ck_assert_int_eq(scene()->structure[0].storeys, 2);
    fixture_keys(&f, "A");
    ck_assert_int_eq(scene()->nstructures, 3);
    ck_assert_str_eq(scene()->structure[1].name, "C");
    fixture_expect(&f, "(1 of 3)");
    fixture_keys(&f, "]");
    fixture_expect(&f, "Right: B (3 of 3)");
    fixture_keys(&f, "x");
    ck_assert_str_eq(scene()->structure[1].name, "B");
    fixture_keys(&f, "D");
    ck_assert_int_eq(scene()->nstructures, 2);
    fixture_keys(&f, "D");
    fixture_expect(&f, "Two structures have to stay");
}
END_TEST

START_TEST(exponent_trap)
{
    double k = scene()->interface[0].bumper.value[thud_law_param(scene()->interface[0].bumper.law, "stiffness")];
    double before = thud_tui_force_at_knee(scene(), 0);
    fixture_keys(&f, "/bumper.exponent<Enter>2.7<Enter>");
    fixture_expect(&f, "keeps the number");
    fixture_expect(&f, "0.36 kN/mm^2.7");
    ck_assert_double_eq_tol(thud_tui_force_at_knee(scene(), 0) / before, pow(8.0, 0.05), 1e-9); /* delta_u is 8 mm */
    fixture_keys(&f, "f");
    ck_assert_double_eq_tol(thud_tui_force_at_knee(scene(), 0) / before, 1.0, 1e-12);
    fixture_keys(&f, "uu");
    ck_assert_double_eq(
        scene()->interface[0].bumper.value[thud_law_param(scene()->interface[0].bumper.law, "stiffness")], k);
}
END_TEST

START_TEST(laws_and_methods_are_chosen_from_lists)
{
    fixture_keys(&f, "/contact.law<Enter><Enter>");
    fixture_expect(&f, "jankowski");
    fixture_keys(&f, "hertz-d<Enter>");
    ck_assert_str_eq(scene()->interface[0].contact.law->name, "hertz-damp");
    fixture_keys(&f, "/analysis.method<Enter><Enter>exact<Enter>");
    ck_assert_str_eq(scene()->analysis.method, "exact");
}
END_TEST

START_TEST(esc_never_quits)
{
    fixture_keys(&f, "<Esc><Esc><A-6><Esc><Esc><A-2><Enter><Esc><Esc>:<Esc>/<Esc>");
    ck_assert(!f.tui->quit);
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_CONTACT);
}
END_TEST

START_TEST(the_command_line)
{
    fixture_keys(&f, ":set gap 5 cm<Enter>");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.05, 1e-15);
    fixture_keys(&f, ":set bumper.thickness=2cm<Enter>");
    ck_assert_double_eq_tol(scene()->interface[0].bumper_thickness_m, 0.02, 1e-15);
    fixture_keys(&f, ":peak 0.3 g<Enter>");
    ck_assert_double_eq_tol(scene()->record.peak_mps2, 0.3 * THUD_GRAVITY, 1e-12);
    fixture_keys(&f, ":case none<Enter>");
    ck_assert(!scene()->interface[0].has_bumper);
    fixture_keys(&f, ":peak \"0.5 g\"<Enter>:sign -<Enter>:from 0.5 s<Enter>:to 2.5 s<Enter>:tolerance 1e-7<Enter>");
    ck_assert_double_eq_tol(scene()->record.peak_mps2, 0.5 * THUD_GRAVITY, 1e-12);
    ck_assert_int_eq(scene()->record.sign, -1);
    ck_assert_double_eq_tol(scene()->record.from_s, 0.5, 1e-15);
    ck_assert_double_eq_tol(scene()->record.to_s, 2.5, 1e-15);
    ck_assert_double_eq(scene()->analysis.tolerance, 1e-7);
    fixture_keys(&f, ":vary gap=1 cm:3 cm:1 cm<Enter>:cases none<Enter>:sweep<Enter>");
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_SWEEP);
    ck_assert_int_eq(scene()->study.nvary, 1);
    fixture_expect(&f, "3 of 3 points");
    fixture_keys(&f, ":bech<Enter>");
    fixture_expect(&f, "did you mean :bench?");
    fixture_keys(&f, ":bogus 3<Enter>");
    fixture_expect(&f, "is no command");
    fixture_keys(&f, ":set nokey 3<Enter>");
    fixture_expect(&f, " ! ");
    fixture_keys(&f, ":q!<Enter>");
    ck_assert(f.tui->quit);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui edit");
    TCase *edit = tcase_create("edit");
    tcase_set_timeout(edit, 60.0);
    tcase_add_checked_fixture(edit, setup, teardown);
    tcase_add_test(edit, a_first_digit_replaces);
    tcase_add_test(edit, the_old_text_is_edited);
    tcase_add_test(edit, units_convert);
    tcase_add_test(edit, no_digit_is_lost);
    tcase_add_test(edit, wrong_input_is_refused);
    tcase_add_test(edit, a_dimension_is_named);
    tcase_add_test(edit, soft_bounds_warn);
    tcase_add_test(edit, plus_and_minus_step);
    tcase_add_test(edit, a_floor_for_all_floors);
    tcase_add_test(edit, undo_goes_all_the_way_and_says_what);
    tcase_add_test(edit, structures_and_storeys);
    tcase_add_test(edit, exponent_trap);
    tcase_add_test(edit, laws_and_methods_are_chosen_from_lists);
    tcase_add_test(edit, esc_never_quits);
    tcase_add_test(edit, the_command_line);
    suite_add_tcase(suite, edit);
    return suite;
}
