/* The Bench screen: every method run there, stopped, failed, and written; the clock is the script's, so what takes too
 * long is the same on every machine. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/methods/method.h"
#include "tui_fixture.h"

static struct fixture f;

static void setup(void)
{
    fixture_open(&f, "bodies", 90, 24, false);
    f.script.tick = 1; /* a slice of work takes a second, a run that would take more than ten is passed over */
}

static void teardown(void)
{
    fixture_close(&f);
}

/* Rows of the CSV in which column `state` is this word, of the methods whose name begins with `method`. */
static int rows(const char *csv, const char *method, const char *state)
{
    char word[32];
    int n = 0;
    snprintf(word, sizeof word, ",%s,", state);
    for (const char *line = csv; line && *line; line = strchr(line, '\n'), line += line != NULL) {
        const char *end = strchr(line, '\n'), *at = strstr(line, word);
        n += strncmp(line, method, strlen(method)) == 0 && at && (!end || at < end);
    }
    return n;
}

START_TEST(before_it_runs_it_says_how)
{
    fixture_keys(&f, ":live off<Enter><A-7>");
    fixture_expect(&f, "r runs every method");
    fixture_keys(&f, "c");
    fixture_expect(&f, "There is no figure yet");
    fixture_keys(&f, "P");
    fixture_expect(&f, "There is no figure yet");
}
END_TEST

START_TEST(every_method_is_run)
{
    char text[64];
    fixture_keys(&f, "<A-7>r");
    fixture_expect(&f, " done ");
    fixture_expect(&f, "reference good to");
    fixture_keys(&f, "e");
    fixture_expect(&f, "/bodies-bench-gap-0mm.csv");
    char *csv = fixture_file(&f, "bodies-bench-gap-0mm.csv");
    ck_assert_ptr_nonnull(csv);
    int done = rows(csv, "", "done"), skipped = rows(csv, "", "skipped"), lines = 0;
    for (const char *at = csv; (at = strchr(at, '\n')) != NULL; at++)
        lines++;
    ck_assert_int_eq(done + skipped + rows(csv, "", "failed"), lines - 1); /* the energy of coarse steps may be lost */
    ck_assert_int_gt(skipped, 5);
    snprintf(text, sizeof text, "%d of %d points", lines - 1, lines - 1);
    fixture_expect(&f, text);
    for (int i = 0; i < thud_method_count(); i++) /* the coarse steps of each are always run */
        ck_assert_msg(rows(csv, thud_method_at(i)->name, "done") > 0, "%s", thud_method_at(i)->name);
    free(csv);
}
END_TEST

/* The exact method is exact for this contact; what a row says in short its words say in full. */
START_TEST(rows_tell_their_errors)
{
    fixture_keys(&f, "<A-7>r");
    fixture_keys(&f, "<Home><Enter>");
    fixture_expect(&f, "exact: errors ");
    char *screen = fixture_text(&f);
    double error = NAN;
    ck_assert_int_eq(sscanf(strstr(screen, "exact: errors "), "exact: errors %lf", &error), 1);
    ck_assert(error < 1e-9);
    free(screen);
    for (int i = 0; i < 400 && !fixture_shows(&f, "would take about"); i++)
        fixture_keys(&f, "<Down><Enter>");
    screen = fixture_text(&f);
    const char *words = strstr(screen, "would take about ");
    ck_assert_ptr_nonnull(words);
    ck_assert(strtod(words + strlen("would take about "), NULL) > 12);
    free(screen);
}
END_TEST

START_TEST(the_figure_has_its_panels)
{
    fixture_keys(&f, "<A-7>r");
    char *first = fixture_text(&f);
    fixture_keys(&f, "c");
    char *second = fixture_text(&f);
    ck_assert_str_ne(first, second);
    free(first);
    free(second);
}
END_TEST

/* Each key is a turn, and each turn does a slice of the work at most. */
START_TEST(it_is_stopped_and_told_from_edits)
{
    f.script.at = ":live off<Enter><A-7>r";
    while (*f.script.at)
        thud_tui_turn(f.tui, false);
    for (int i = 0; i < 3; i++)
        thud_tui_turn(f.tui, false);
    thud_tui_draw(f.tui);
    fixture_expect(&f, "running, Esc stops");
    fixture_keys(&f, "<Esc>");
    fixture_expect(&f, "Stopped; what is done stays");
    fixture_expect(&f, "stopped: what is done stays");
    fixture_expect_not(&f, "before edits");
    fixture_keys(&f, "<A-2><Enter>3<Enter><A-7>");
    fixture_expect(&f, "(before edits)");
    fixture_keys(&f, "<Home><Enter>");
    ck_assert(fixture_shows(&f, "not run yet") || fixture_shows(&f, "errors "));
}
END_TEST

/* Shown at once: the first of every curve and what is expected to be quick, once each; an edit begins it anew. A whole
 * one stays until it is asked for again. */
START_TEST(the_quick_part_runs_by_itself)
{
    f.script.tick = 0; /* a run that takes over a second turns live off */
    fixture_keys(&f, "<A-7>");
    fixture_expect(&f, "the quick part; r: all");
    fixture_keys(&f, "e");
    char *csv = fixture_file(&f, "bodies-bench-gap-0mm.csv");
    ck_assert_ptr_nonnull(csv);
    for (int i = 0; i < thud_method_count(); i++)
        ck_assert_msg(rows(csv, thud_method_at(i)->name, "done") + rows(csv, thud_method_at(i)->name, "failed") > 0,
                      "%s", thud_method_at(i)->name);
    free(csv);
    fixture_keys(&f, ":set gap 1 cm<Enter>");
    fixture_expect(&f, "the quick part; r: all");
    fixture_expect_not(&f, "before edits");
    f.script.tick = 1;
    fixture_keys(&f, "r");
    fixture_expect(&f, " done ");
    fixture_keys(&f, "u");
    fixture_expect(&f, " done (before edits)");
}
END_TEST

/* A contact so stiff that no fixed step of the list resolves it. */
START_TEST(a_method_that_fails_says_where)
{
    fixture_keys(&f, ":set contact.stiffness 1e15 kN/mm<Enter><A-7>r");
    fixture_expect(&f, " done ");
    fixture_expect(&f, "FAILED");
    for (int i = 0; i < 400 && !fixture_shows(&f, "blew up"); i++)
        fixture_keys(&f, "<Down><Enter>");
    fixture_expect(&f, "blew up at t = ");
    fixture_keys(&f, "e");
    char *csv = fixture_file(&f, "bodies-bench-gap-0mm.csv");
    ck_assert_ptr_nonnull(csv);
    ck_assert_int_gt(rows(csv, "central-difference", "FAILED") + rows(csv, "central-difference", "failed"), 0);
    ck_assert_int_gt(rows(csv, "exact", "done"), 0);
    free(csv);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui bench");
    TCase *bench = tcase_create("bench");
    tcase_set_timeout(bench, 120.0);
    tcase_add_checked_fixture(bench, setup, teardown);
    tcase_add_test(bench, before_it_runs_it_says_how);
    tcase_add_test(bench, every_method_is_run);
    tcase_add_test(bench, rows_tell_their_errors);
    tcase_add_test(bench, the_figure_has_its_panels);
    tcase_add_test(bench, it_is_stopped_and_told_from_edits);
    tcase_add_test(bench, the_quick_part_runs_by_itself);
    tcase_add_test(bench, a_method_that_fails_says_where);
    suite_add_tcase(suite, bench);
    return suite;
}
