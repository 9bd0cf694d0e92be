/* The study of the Sweep screen is the preset's own: typed, refused, undone, saved, and run again from the file. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/sweep.h"
#include "tui/sweep_work.h"
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

static const struct thud_study_choice *study(void)
{
    return &f.tui->doc.scene.study;
}

START_TEST(a_range_becomes_the_presets_study)
{
    unsigned long revision = f.tui->doc.revision;
    fixture_keys(&f, "<A-6><Enter><C-u>gap=2:4:0.5 cm<Enter>");
    ck_assert_int_eq(study()->nvary, 1);
    ck_assert_str_eq(study()->vary[0].key, "gap");
    ck_assert_double_eq_tol(study()->vary[0].from, 0.02, 1e-15);
    ck_assert_double_eq_tol(study()->vary[0].to, 0.04, 1e-15);
    ck_assert_double_eq_tol(study()->vary[0].step, 0.005, 1e-15);
    ck_assert_uint_eq(f.tui->doc.revision, revision); /* no run depends on it: none is made again */
    fixture_expect(&f, "towers [+]");
    fixture_keys(&f, "<Down><Enter>contact.restitution=0.5:0.7:0.1<Enter>");
    ck_assert_int_eq(study()->nvary, 2);
    fixture_keys(&f, "u");
    ck_assert_int_eq(study()->nvary, 1);
    fixture_keys(&f, "<C-r>");
    fixture_expect(&f, "contact.restitution=0.5:0");
    fixture_keys(&f, "<Home><Enter><C-u><Enter>"); /* the first one goes, the second moves up */
    ck_assert_int_eq(study()->nvary, 1);
    ck_assert_str_eq(study()->vary[0].key, "contact.restitution");
}
END_TEST

START_TEST(what_is_saved_is_the_same_study)
{
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm:3 cm:1 cm<Enter>");
    fixture_keys(&f, "<Down><Enter>bumper.stiffness=0.3:0.4:0.1 kN/mm^2.65<Enter>");
    fixture_keys(&f, "<Down><Down><Enter><C-u>none,bumper<Enter>w");
    fixture_expect(&f, "Saved");
    char *text = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "# concrete to concrete"));
    free(text);
    struct thud_preset *preset;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_preset_read(f.tui->doc.path, &preset, &err), THUD_OK);
    ck_assert_mem_eq(&thud_preset_scene(preset)->study, study(), sizeof *study());
    struct thud_sweep_plan plan; /* as the command line plans it */
    thud_sweep_plan_init(&plan, thud_preset_scene(preset));
    ck_assert_int_eq(thud_sweep_study(&plan, true, true, &err), THUD_OK);
    fixture_keys(&f, "r");
    fixture_expect(&f, "6 of 6 points");
    ck_assert_int_eq((int)thud_sweep_points(&plan), 6);
    ck_assert_int_eq(plan.ncases, 2);
    thud_sweep_plan_clear(&plan);
    thud_preset_free(preset);
}
END_TEST

START_TEST(a_spread_is_kept_and_run)
{
    fixture_keys(&f, "<A-6><Enter><C-u>gap=8 cm:9 cm:1 cm<Enter><Down><Down><Down><Down><Enter>90 %<Enter>");
    ck_assert(study()->sensitivity == 0);
    fixture_expect(&f, "too large");
    fixture_keys(&f, "<C-u>0.2 %<Enter>w");
    ck_assert_double_eq_tol(study()->sensitivity, 2e-3, 1e-15);
    struct thud_preset *preset;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_preset_read(f.tui->doc.path, &preset, &err), THUD_OK);
    ck_assert_mem_eq(&thud_preset_scene(preset)->study, study(), sizeof *study());
    thud_preset_free(preset);
    fixture_keys(&f, "r");
    fixture_expect(&f, "2 of 2 points");
    fixture_keys(&f, "e");
    fixture_expect(&f, "Written sweep.csv");
    char *csv = fixture_file(&f, "sweep.csv");
    ck_assert_ptr_nonnull(csv);
    ck_assert_ptr_nonnull(strstr(csv, ",drift_ratio_low,drift_ratio_high,"));
    free(csv);
    fixture_keys(&f, "<Enter><C-u><Enter>");
    ck_assert(study()->sensitivity == 0);
}
END_TEST

/* A study of the screen to its end, and the lines of its files. */
static void make_study(struct thud_sweep_work *work, unsigned shortcuts, char *text[THUD_SWEEP_CSVS])
{
    static const struct thud_study_words words = {.vary = {"bumper.thickness=1 cm,2 cm,3 cm", "gap=3 cm,6 cm,400 cm"},
                                                  .cases = "none,bumper"};
    struct thud_error err = {0};
    ck_assert_int_eq(thud_sweep_work_start(work, &f.tui->doc.scene, &words, f.tui->doc.paths, f.tui->doc.path, &err),
                     THUD_OK);
    work->plan.shortcuts = shortcuts;
    while (work->running)
        ck_assert_int_eq(thud_sweep_work_advance(work, &err), THUD_OK);
    ck_assert(work->complete);
    ck_assert_int_eq(thud_sweep_work_export(work, f.folder, &err), THUD_OK);
    for (int i = 0; i < THUD_SWEEP_CSVS; i++)
        text[i] = fixture_file(&f, thud_sweep_csv_name((enum thud_sweep_csv)i));
}

/* Case `none` is run once for each gap that is used up, whatever the bumper's thickness; the files are the same. */
START_TEST(no_bumper_is_run_once_for_all_thicknesses)
{
    static struct thud_sweep_work work;
    char *all[THUD_SWEEP_CSVS], *none[THUD_SWEEP_CSVS];
    make_study(&work, THUD_SWEEP_ALL, all);
    ck_assert_int_eq(work.total.asked, 18);
    ck_assert_int_eq(work.total.reused, 2 * 2);
    long made = work.total.made;
    make_study(&work, THUD_SWEEP_ALL & ~(unsigned)THUD_SWEEP_REFERENCE, none);
    ck_assert_int_eq(work.total.reused, 0);
    ck_assert_int_eq(work.total.made, made + 2 * 2);
    for (int i = 0; i < THUD_SWEEP_CSVS; i++) {
        ck_assert_str_eq(all[i], none[i]);
        ck_assert_int_eq(all[i][strlen(all[i]) - 1], '\n');
        ck_assert_ptr_nonnull(strstr(all[i], "\npulse.csv,")); /* as it was named, not where it was found */
        free(all[i]);
        free(none[i]);
    }
    thud_sweep_work_clear(&work);
}
END_TEST

START_TEST(wrong_words_are_refused)
{
    static const char *const words[] = {"gap",
                                        "gap=",
                                        "gap=1 cm:2 cm",
                                        "gap=1 t:2 t:1 t",
                                        "nokey=1:2:1",
                                        "gap=3 cm:1 cm:1 cm",
                                        "record.file=a:b:c",
                                        "gap=600 cm:700 cm:50 cm"};
    fixture_keys(&f, "<A-6>");
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        fixture_keys(&f, "<Enter><C-u>");
        fixture_keys(&f, words[i]);
        fixture_keys(&f, "<Enter>");
        ck_assert_msg(f.tui->mode == THUD_MODE_TYPING, "%s was taken", words[i]);
        fixture_expect(&f, " ! ");
        fixture_expect(&f, words[i]); /* stays in the prompt */
        fixture_keys(&f, "<Esc>");
        ck_assert_int_eq(study()->nvary, 0);
    }
    ck_assert_int_eq(f.tui->doc.undo.count, 0);
}
END_TEST

/* With the unit of the last one, as they run; a range beside them becomes a list. */
START_TEST(a_list_is_kept)
{
    fixture_keys(&f, "<A-6><Enter><C-u>gap=3,4 cm<Enter>");
    ck_assert_str_eq(study()->vary[0].values, "3 cm, 4 cm");
    fixture_keys(&f, "<Down><Enter>contact.restitution=0.5:0.7:0.1<Enter>");
    fixture_keys(&f, "<Down><Enter>contact.damping=exact,paper<Enter>w");
    ck_assert_int_eq(study()->nvary, 3);
    ck_assert_str_eq(study()->vary[1].values, "0.5, 0.6, 0.7");
    struct thud_preset *preset;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_preset_read(f.tui->doc.path, &preset, &err), THUD_OK);
    ck_assert_mem_eq(&thud_preset_scene(preset)->study, study(), sizeof *study());
    struct thud_sweep_plan plan;
    thud_sweep_plan_init(&plan, thud_preset_scene(preset));
    ck_assert_int_eq(thud_sweep_study(&plan, true, true, &err), THUD_OK);
    ck_assert_int_eq((int)thud_sweep_points(&plan), 12);
    thud_sweep_plan_clear(&plan);
    thud_preset_free(preset);
    fixture_keys(&f, "u");
    fixture_expect(&f, "contact.restitution=0.5");
    ck_assert_int_eq(study()->nvary, 2);
}
END_TEST

/* More values than a preset has room for run, and are not kept. */
START_TEST(a_list_too_long_is_run_but_not_kept)
{
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm:2 cm:1 cm<Enter>");
    fixture_keys(&f, "<Down><Enter>contact.restitution=0.5<Enter>");
    ck_assert_str_eq(study()->vary[0].values, "1 cm, 2 cm");
    fixture_keys(&f, "<Home><Enter><C-u>gap=1 cm:2 cm:0.01 cm<Enter>");
    fixture_expect(&f, "no room for so many values");
    ck_assert_str_eq(study()->vary[0].values, "1 cm, 2 cm");
}
END_TEST

START_TEST(edits_make_a_study_old)
{
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm,3 cm<Enter>r");
    fixture_expect(&f, "2 of 2 points");
    fixture_expect_not(&f, "before edits");
    fixture_keys(&f, "<Enter><C-u>gap=1 cm:2 cm:1 cm<Enter>");
    fixture_expect(&f, "of the study before edits");
    fixture_keys(&f, "<A-2><Enter>3<Enter><A-6>");
    fixture_expect(&f, "of the scene before edits");
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui study");
    TCase *words = tcase_create("study");
    tcase_set_timeout(words, 60.0);
    tcase_add_checked_fixture(words, setup, teardown);
    tcase_add_test(words, a_range_becomes_the_presets_study);
    tcase_add_test(words, what_is_saved_is_the_same_study);
    tcase_add_test(words, a_spread_is_kept_and_run);
    tcase_add_test(words, no_bumper_is_run_once_for_all_thicknesses);
    tcase_add_test(words, wrong_words_are_refused);
    tcase_add_test(words, a_list_is_kept);
    tcase_add_test(words, a_list_too_long_is_run_but_not_kept);
    tcase_add_test(words, edits_make_a_study_old);
    suite_add_tcase(suite, words);
    return suite;
}
