/* Files: saving with comments kept, other names, changes by others, recovery, opening, quitting. */
#include <check.h>
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

START_TEST(saving_keeps_comments)
{
    fixture_keys(&f, "<A-2><Enter>3.5<Enter>w");
    fixture_expect(&f, "Saved");
    fixture_expect_not(&f, "[+]");
    char *text = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "- gap: 3.5 cm   # concrete to concrete"));
    ck_assert_ptr_nonnull(strstr(text, "file: pulse.csv    # a sine"));
    ck_assert_ptr_nonnull(strstr(text, "# two towers, for tests"));
    free(text);
    fixture_keys(&f, "w");
    fixture_expect(&f, "Nothing to save");
}
END_TEST

START_TEST(saving_under_another_name)
{
    char keys[256];
    snprintf(keys, sizeof keys, "<A-2><Enter>4<Enter>W<C-u>%s/other<Enter>", f.folder);
    fixture_keys(&f, keys);
    fixture_expect(&f, "thud  other");
    char *text = fixture_file(&f, "other.yaml"), *old = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "- gap: 4 cm"));
    ck_assert_str_eq(old, fixture_towers);
    free(text);
    free(old);
    snprintf(keys, sizeof keys, "W<C-u>%s/towers<Enter>", f.folder);
    fixture_keys(&f, keys);
    fixture_expect(&f, "exists. Write over it?");
    fixture_keys(&f, "n");
    old = fixture_file(&f, "towers.yaml");
    ck_assert_str_eq(old, fixture_towers);
    free(old);
}
END_TEST

START_TEST(a_file_changed_by_others_is_asked_about)
{
    fixture_keys(&f, "<A-2><Enter>4<Enter>");
    fixture_write(&f, "towers.yaml", "# someone else's\n");
    fixture_keys(&f, "w");
    fixture_expect(&f, "changed by someone else");
    fixture_keys(&f, "<Esc>");
    char *text = fixture_file(&f, "towers.yaml");
    ck_assert_str_eq(text, "# someone else's\n");
    free(text);
    fixture_keys(&f, "wy");
    fixture_expect(&f, "Saved");
    text = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "- gap: 4 cm"));
    free(text);
}
END_TEST

START_TEST(a_full_disk_loses_nothing)
{
    fixture_keys(&f, "<A-2><Enter>4<Enter>W<C-u>/dev/full/x.yaml<Enter>");
    fixture_expect(&f, " ! ");
    fixture_expect(&f, "towers [+]");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.04, 1e-15);
}
END_TEST

/* The tables of `thud run --csv` and `-o`, of the case that is shown. */
START_TEST(results_as_csv)
{
    fixture_keys(&f, "<A-4>e");
    fixture_expect(&f, "Written peaks.csv and impacts.csv (bumper)");
    const struct thud_result *result = thud_live_result(&f.tui->live, THUD_LIVE_BUMPER);
    char *peaks = fixture_file(&f, "peaks.csv"), *impacts = fixture_file(&f, "impacts.csv");
    double acceleration = 0.0;
    int lines = 0, count;
    ck_assert_ptr_nonnull(peaks);
    ck_assert_ptr_nonnull(impacts);
    ck_assert_int_eq(sscanf(strchr(peaks, '\n'), "\nA,1,%lf", &acceleration), 1);
    ck_assert_double_eq(acceleration, result->structure[0].floor[0].acceleration.value);
    for (const char *at = impacts; (at = strchr(at, '\n')) != NULL; at++)
        lines++;
    thud_run_impacts(f.tui->live.which[THUD_LIVE_BUMPER].run, &count);
    ck_assert_int_eq(lines, count + 1);
    free(peaks);
    free(impacts);
    fixture_take_record(&f);
    fixture_keys(&f, "e");
    fixture_expect(&f, "There are no results");
}
END_TEST

START_TEST(quitting_asks_only_when_unsaved)
{
    fixture_keys(&f, "<A-2><Enter>4<Enter>q");
    ck_assert(!f.tui->quit);
    fixture_expect(&f, "unsaved changes");
    fixture_keys(&f, "nuq");
    ck_assert(f.tui->quit);
}
END_TEST

START_TEST(unsaved_edits_can_be_recovered)
{
    struct thud_error err;
    char path[512];
    fixture_keys(&f, "<A-2><Enter>7<Enter>");
    ck_assert_int_eq(thud_doc_recover(&f.tui->doc, path, &err), THUD_OK);
    char *text = fixture_file(&f, "towers.yaml.recovered"), *old = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "- gap: 7 cm   # concrete to concrete"));
    ck_assert_str_eq(old, fixture_towers);
    free(text);
    free(old);
    /* where the preset's folder cannot be written, in that for temporary files */
    ck_assert_int_eq(setenv("TMPDIR", f.folder, 1), 0);
    snprintf(f.tui->doc.path, sizeof f.tui->doc.path, "%s/towers.yaml/towers.yaml", f.folder);
    ck_assert_int_eq(thud_doc_recover(&f.tui->doc, path, &err), THUD_OK);
    ck_assert_ptr_eq(strstr(path, f.folder), path);
    text = fixture_file(&f, strrchr(path, '/') + 1);
    ck_assert_ptr_nonnull(strstr(text, "- gap: 7 cm   # concrete to concrete"));
    free(text);
    unsetenv("TMPDIR");
}
END_TEST

START_TEST(opening_another_preset)
{
    fixture_keys(&f, "obodies<Enter>");
    fixture_expect(&f, "thud  bodies");
    fixture_keys(&f, "<A-2><Enter>1<Enter>o<C-u>towers<Enter>");
    fixture_expect(&f, "unsaved changes");
    fixture_keys(&f, "y");
    fixture_expect(&f, "thud  towers");
    ck_assert_int_eq(f.tui->doc.undo.count, 0);
    fixture_keys(&f, ":open nosuch<Enter>");
    fixture_expect(&f, " ! ");
    fixture_expect(&f, "thud  towers");
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui files");
    TCase *files = tcase_create("files");
    tcase_set_timeout(files, 60.0);
    tcase_add_checked_fixture(files, setup, teardown);
    tcase_add_test(files, saving_keeps_comments);
    tcase_add_test(files, saving_under_another_name);
    tcase_add_test(files, a_file_changed_by_others_is_asked_about);
    tcase_add_test(files, a_full_disk_loses_nothing);
    tcase_add_test(files, results_as_csv);
    tcase_add_test(files, quitting_asks_only_when_unsaved);
    tcase_add_test(files, unsaved_edits_can_be_recovered);
    tcase_add_test(files, opening_another_preset);
    suite_add_tcase(suite, files);
    return suite;
}
