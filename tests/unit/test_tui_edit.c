/* Editing and undo: scripted keys, and what the screen and the scene then say. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tui/document/scene_edit.h"
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

START_TEST(the_first_key_replaces)
{
    fixture_keys(&f, "<A-2><Enter>3<Enter>");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.03, 1e-15);
    fixture_expect(&f, "towers [+]");
    fixture_expect(&f, "3 cm");
    fixture_keys(&f, "<Enter><Home>1<Enter>"); /* moving keeps the text: "13 cm" */
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.13, 1e-15);
    fixture_keys(&f, "<Enter><BS><Esc>");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.13, 1e-15);
}
END_TEST

/* Every cell of B, row by row with Tab, and A's masses with Down: no key but the values' own and one between them. */
START_TEST(a_building_is_typed_cell_by_cell)
{
    static const double mass_t[] = {301, 302, 303}, stiffness_mnpm[] = {401, 402, 403}, height_m[] = {3.1, 3.2, 3.3},
                        yield_mm[] = {15, 16, 17};
    char keys[256] = "/structures.2.mass<Enter><Up><Up><Enter>"; /* the highest floor stands first */
    for (int i = 2; i >= 0; i--)
        snprintf(keys + strlen(keys), sizeof keys - strlen(keys), "%g<Tab>%g<Tab>%g<Tab>%g%s", mass_t[i],
                 stiffness_mnpm[i], height_m[i], yield_mm[i], i ? "<Tab>" : "<Enter>");
    fixture_keys(&f, keys);
    ck_assert_int_eq((int)f.tui->dialog.mode, THUD_MODE_NORMAL);
    const struct thud_structure *b = &scene()->structure[1];
    for (int i = 0; i < 3; i++) {
        ck_assert_double_eq_tol(b->mass_kg[i], 1e3 * mass_t[i], 1e-6);
        ck_assert_double_eq_tol(b->stiffness_npm[i], 1e6 * stiffness_mnpm[i], 1e-3);
        ck_assert_double_eq_tol(b->height_m[i], height_m[i], 1e-12);
        ck_assert_double_eq_tol(b->yield_m[i], 1e-3 * yield_mm[i], 1e-12);
    }
    fixture_keys(&f, "/structures.1.mass<Enter><Up><Enter>261<Down>262<Down>");
    ck_assert_double_eq_tol(scene()->structure[0].mass_kg[1], 261e3, 1e-6);
    ck_assert_double_eq_tol(scene()->structure[0].mass_kg[0], 262e3, 1e-6);
    ck_assert_str_eq(f.tui->dialog.target, "structures.1.base"); /* below the floors */
    fixture_keys(&f, "<Esc><Up><Enter>3 kN<Tab>");               /* refused: it stays there */
    ck_assert_int_eq((int)f.tui->dialog.mode, THUD_MODE_TYPING);
    ck_assert_str_eq(f.tui->dialog.target, "structures.1.height.1");
}
END_TEST

static void paste(const char *keys, const char *text)
{
    fixture_keys(&f, keys);
    f.script.paste = text;
    fixture_keys(&f, "<Paste>");
}

START_TEST(a_pasted_column_fills_cells)
{
    struct thud_scene first = *scene();
    const struct thud_structure *b = &scene()->structure[1];
    paste("/structures.2.mass<Enter><Up><Up>", "311\r312 t\r313000 kg\r");
    for (int i = 0; i < 3; i++)
        ck_assert_double_eq_tol(b->mass_kg[i], 1e3 * (313 - i), 1e-6);
    ck_assert_int_eq(f.tui->doc.undo.count, 1);
    fixture_keys(&f, "u");
    ck_assert_mem_eq(scene(), &first, sizeof first);
    paste("", "321\t421\t3.5\n322\t422\t3.6\n323 423 3.7"); /* a table, the last row with blanks */
    for (int i = 0; i < 3; i++) {
        ck_assert_double_eq_tol(b->mass_kg[i], 1e3 * (323 - i), 1e-6);
        ck_assert_double_eq_tol(b->stiffness_npm[i], 1e6 * (423 - i), 1e-3);
        ck_assert_double_eq_tol(b->height_m[i], 3.7 - 0.1 * i, 1e-12);
    }
    ck_assert_int_eq(f.tui->doc.undo.count, 1);
    first = *scene();
    paste("", "1\r2\r3\r4\r"); /* one too many, a wrong one, prose: nothing changes */
    fixture_expect(&f, "nothing was changed");
    paste("", "1\r2 kN\r");
    fixture_expect(&f, "nothing was changed");
    paste("<A-4>", "quit now\rwqd1\r");
    fixture_expect(&f, "the cursor is on none");
    paste("<A-2>", "dear reader,\rq");
    ck_assert_mem_eq(scene(), &first, sizeof first);
    ck_assert(!f.tui->end.quit);
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_CONTACT);
    paste("<Enter>", "4.5 cm"); /* into the line that is typed, in place of what is selected */
    fixture_keys(&f, "<Enter>");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.045, 1e-15);
    paste(":", "set gap 5 cm\rq");
    fixture_keys(&f, "<Enter>");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.05, 1e-15);
}
END_TEST

/* Half of the pulse of the fixture: what was said of the pulse does not hold for it, by whatever way it comes. */
START_TEST(another_record_comes_as_recorded)
{
    static const char *const way[] = {":record other.csv<Enter>", "<A-3>/record.file<Enter><Enter>other.csv<Enter>",
                                      ":set record.file other.csv<Enter>", "<A-3><Tab><Down><Enter>"};
    fixture_write(&f, "other.csv", "time_s,acceleration_g\n0,0\n0.1,0.3\n0.2,-0.25\n0.3,0\n");
    for (size_t i = 0; i < sizeof way / sizeof *way; i++) {
        fixture_expect(&f, "scaled x0.600");
        fixture_keys(&f, way[i]);
        ck_assert_msg(strcmp(scene()->record.file, "other.csv") == 0, "%s: %s", way[i], scene()->record.file);
        ck_assert(isnan(scene()->record.peak_mps2));
        ck_assert_double_eq_tol(thud_record_peak(f.tui->doc.record), 0.3 * THUD_GRAVITY, 1e-9);
        fixture_expect(&f, "as recorded, 0.300 g");
        fixture_expect_not(&f, "scaled x");
        fixture_keys(&f, "u");
        ck_assert_double_eq_tol(scene()->record.peak_mps2, 0.6 * THUD_GRAVITY, 1e-12);
    }
    fixture_keys(&f, ":record nosuch.csv<Enter>"); /* a mistyped one leaves the good one */
    fixture_expect(&f, " ! ");
    ck_assert_str_eq(scene()->record.file, "pulse.csv");
    fixture_keys(&f, ":record towers.yaml<Enter>");
    fixture_expect(&f, " ! ");
    ck_assert_str_eq(scene()->record.file, "pulse.csv");
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
        fixture_keys(&f, "<Enter>");
        fixture_keys(&f, row[i].keys);
        ck_assert_double_eq_tol(scene()->interface[0].gap_m, row[i].gap_m, 1e-12);
    }
}
END_TEST

START_TEST(no_digit_is_lost)
{
    fixture_keys(&f, "<A-2><Enter>1.23456789<Enter>");
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
        fixture_keys(&f, "<Enter>");
        fixture_keys(&f, keys[i]);
        fixture_keys(&f, "<Enter>");
        ck_assert_msg(f.tui->dialog.mode == THUD_MODE_TYPING, "%s was taken", keys[i]);
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
    fixture_keys(&f, "<A-2><Enter>320 kN<Enter>");
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
    fixture_keys(&f, "<A-2><Enter>10<Enter>+");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.11, 1e-12);
    fixture_keys(&f, "--");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.09, 1e-12);
    fixture_keys(&f, "}");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.10, 1e-12);
    fixture_keys(&f, "{-");
    ck_assert(scene()->interface[0].gap_m >= 0.0);
}
END_TEST

/* The first value of a foundation brings usual ones for the rest; without its mass there is none. */
START_TEST(a_foundation_is_typed)
{
    fixture_keys(&f, ":structures.1.foundation.vs=150m/s<Enter>");
    ck_assert(thud_structure_on_soil(&scene()->structure[0]) && !thud_structure_on_soil(&scene()->structure[1]));
    ck_assert_double_eq(scene()->structure[0].soil_vs_mps, 150);
    ck_assert_double_eq_tol(scene()->structure[0].foundation_mass_kg, scene()->structure[0].mass_kg[0], 1e-6);
    fixture_expect(&f, "radius  9 m");
    fixture_keys(&f, ":structures.1.foundation.mass=<Enter>");
    ck_assert(!thud_structure_on_soil(&scene()->structure[0]));
    ck_assert(!thud_doc_unsaved(&f.tui->doc));
}
END_TEST

/* The effective mass that a law is shown with is that of the lowest floors, the slab and the wall that a run has. */
START_TEST(laws_are_shown_with_the_masses_of_a_run)
{
    fixture_keys(&f, ":structures.1.kind=wall<Enter>:structures.1.mass=27 t<Enter>:structures.2.kind=isolated<Enter>"
                     ":structures.2.base-mass=100 t<Enter><A-2>");
    fixture_expect(&f, "eff. mass 21.3 t");         /* 1/(1/27 + 1/100) = 21.26 */
    fixture_keys(&f, ":structures.1.mass=<Enter>"); /* moves with the ground */
    fixture_expect(&f, "eff. mass 100 t");
}
END_TEST

/* A new link is between the highest floors that can touch, whatever their numbers. */
START_TEST(a_link_is_added_between_floors_that_meet)
{
    const struct thud_link *link = &scene()->link[0];
    fixture_keys(&f, ":structures.1.kind=isolated<Enter>:link add 1<Enter>");
    ck_assert_str_eq(link->from, "A.3");
    ck_assert_str_eq(link->to, "B.2");
    fixture_keys(&f, "u:structures.1.kind=wall<Enter>:structures.1.height=0 m<Enter>:structures.2.kind=isolated<Enter>"
                     ":link add 1<Enter>");
    ck_assert_str_eq(link->from, "A");
    ck_assert_str_eq(link->to, "B.1");
}
END_TEST

/* So do those of a wall that gives, with the soil behind it: none of them alone is a scene. */
START_TEST(a_wall_that_gives_is_typed)
{
    const struct thud_structure *wall = &scene()->structure[1];
    static const char *const first[] = {"mass=30t", "stiffness=30MN/m", "damping=3%", "backfill.strength=3MN"};
    char keys[120];
    fixture_keys(&f, ":structures.2.kind=wall<Enter>");
    for (int i = 0; i < 4; i++) {
        ck_assert(!thud_wall_gives(wall));
        snprintf(keys, sizeof keys, ":structures.2.%s<Enter>", first[i]);
        fixture_keys(&f, keys);
        ck_assert_msg(thud_wall_gives(wall) && wall->wall_stiffness_npm > 0, "%s", first[i]);
        ck_assert(thud_wall_has_backfill(wall) == (i == 3));
        if (i == 0)
            ck_assert_double_eq(wall->wall_mass_kg, 30e3);
        if (i == 3)
            ck_assert(wall->backfill_strength_n == 3e6 && wall->backfill_stiffness_npm > 0);
        if (i == 3) { /* the soil alone goes */
            fixture_keys(&f, ":structures.2.backfill.stiffness=<Enter>");
            ck_assert(thud_wall_gives(wall) && !thud_wall_has_backfill(wall));
            fixture_keys(&f, "u");
        }
        fixture_keys(&f, ":structures.2.mass=<Enter>");
        ck_assert(isnan(wall->wall_stiffness_npm) && isnan(wall->wall_damping) && isnan(wall->backfill_strength_n));
    }
}
END_TEST

START_TEST(a_floor_for_all_floors)
{
    fixture_keys(&f, "/structures.2.mass<Enter><Enter>500<Enter>");
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
    fixture_keys(&f, "<A-2><Enter>3<Enter><Enter>4<Enter>B<A-1>xADa<A-3>s");
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
    fixture_keys(&f, "<Down><Down><Down><Down>d");
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
    double before = thud_scene_force_at_knee(scene(), 0);
    fixture_keys(&f, "/bumper.exponent<Enter><Enter>2.7<Enter>");
    fixture_expect(&f, "keeps the number");
    fixture_expect(&f, "0.36 kN/mm^2.7");
    ck_assert_double_eq_tol(thud_scene_force_at_knee(scene(), 0) / before, pow(8.0, 0.05), 1e-9); /* delta_u is 8 mm */
    fixture_keys(&f, "f");
    ck_assert_double_eq_tol(thud_scene_force_at_knee(scene(), 0) / before, 1.0, 1e-12);
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
    ck_assert(!f.tui->end.quit);
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_CONTACT);
    fixture_keys(&f, "4<Esc>"); /* chosen by mistake */
    ck_assert_int_eq(f.tui->screen, THUD_SCREEN_CONTACT);
    fixture_keys(&f, "4c<Esc>");
    ck_assert_int_eq(f.tui->screen, THUD_SCREEN_RESULTS);
    ck_assert(!f.tui->end.quit);
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
    fixture_expect(&f, "is not a command");
    fixture_keys(&f, ":gap 12 cm<Enter>");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.12, 1e-15);
    fixture_keys(&f, ":structures.1.mass.2=310 t<Enter>");
    ck_assert_double_eq_tol(scene()->structure[0].mass_kg[1], 310e3, 1e-6);
    fixture_keys(&f, ":set nokey 3<Enter>");
    fixture_expect(&f, " ! ");
    fixture_keys(&f, ":q!<Enter>");
    ck_assert(f.tui->end.quit);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui edit");
    TCase *edit = tcase_create("edit");
    tcase_set_timeout(edit, 60.0);
    tcase_add_checked_fixture(edit, setup, teardown);
    tcase_add_test(edit, the_first_key_replaces);
    tcase_add_test(edit, a_building_is_typed_cell_by_cell);
    tcase_add_test(edit, a_pasted_column_fills_cells);
    tcase_add_test(edit, another_record_comes_as_recorded);
    tcase_add_test(edit, the_old_text_is_edited);
    tcase_add_test(edit, units_convert);
    tcase_add_test(edit, no_digit_is_lost);
    tcase_add_test(edit, wrong_input_is_refused);
    tcase_add_test(edit, a_dimension_is_named);
    tcase_add_test(edit, soft_bounds_warn);
    tcase_add_test(edit, plus_and_minus_step);
    tcase_add_test(edit, a_foundation_is_typed);
    tcase_add_test(edit, laws_are_shown_with_the_masses_of_a_run);
    tcase_add_test(edit, a_link_is_added_between_floors_that_meet);
    tcase_add_test(edit, a_wall_that_gives_is_typed);
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
