/* Pictures from the screens: written beside the work, stopped without a trace of the one in hand, failures said. */
#include <check.h>
#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "app/run/figure_files.h"
#include "tui/screens/plots.h"
#include "tui_fixture.h"

static struct fixture f;
static char fake[128];

static void setup(void)
{
    fixture_open(&f, "towers", 80, 24, true);
}

static void teardown(void)
{
    fixture_close(&f);
}

/* A gnuplot that is this shell script; %s in it is the folder. */
static void use_gnuplot(const char *script)
{
    snprintf(fake, sizeof fake, "%s/gnuplot", f.folder);
    FILE *file = fopen(fake, "w");
    ck_assert_ptr_nonnull(file);
    fprintf(file, "#!/bin/sh\nfolder=%s\n%s\n", f.folder, script);
    ck_assert_int_eq(fclose(file), 0);
    ck_assert_int_eq(chmod(fake, 0755), 0);
    f.tui->options.gnuplot = fake;
}

static int count_files_in(const char *name, const char *ending)
{
    char path[200];
    snprintf(path, sizeof path, "%s/%s", f.folder, name);
    DIR *folder = opendir(path);
    int n = 0;
    for (struct dirent *entry; folder && (entry = readdir(folder)) != NULL;) {
        size_t length = strlen(entry->d_name), end = strlen(ending);
        n += length > end && strcmp(entry->d_name + length - end, ending) == 0;
    }
    if (folder)
        closedir(folder);
    return n;
}

static int count_files(const char *ending)
{
    return count_files_in("", ending);
}

START_TEST(the_figure_shown)
{
    fixture_keys(&f, "<A-2>p");
    fixture_expect(&f, "Written");
    ck_assert_int_eq(count_files(".png"), 1);
    ck_assert_int_eq(count_files(".gp"), 1);
    ck_assert_int_eq(count_files(".csv"), 2); /* and the ground motion */
}
END_TEST

/* A picture that something else changed since stays; as it was written it is written again. */
START_TEST(a_changed_picture_stays)
{
    char path[200];
    fixture_keys(&f, "<A-2>p");
    fixture_keys(&f, "p");
    ck_assert_int_eq(count_files(".png"), 1);
    DIR *folder = opendir(f.folder);
    for (struct dirent *entry; (entry = readdir(folder)) != NULL;)
        if (strstr(entry->d_name, ".png"))
            snprintf(path, sizeof path, "%s/%.100s", f.folder, entry->d_name);
    closedir(folder);
    struct timespec later[2] = {{.tv_sec = time(NULL) + 3600}, {.tv_sec = time(NULL) + 3600}};
    FILE *file = fopen(path, "w");
    fputs("mine", file);
    fclose(file);
    ck_assert_int_eq(utimensat(AT_FDCWD, path, later, 0), 0);
    fixture_keys(&f, "p");
    ck_assert_int_eq(count_files(".png"), 2);
    char text[8] = "";
    file = fopen(path, "r");
    ck_assert_ptr_nonnull(fgets(text, sizeof text, file));
    fclose(file);
    ck_assert_str_eq(text, "mine");
}
END_TEST

/* Also at once after it was written: by what it holds, not by its age. */
START_TEST(a_picture_changed_at_once_stays)
{
    char name[120];
    fixture_keys(&f, "<A-2>p");
    snprintf(name, sizeof name, "%s", strrchr(f.tui->files.wrote[0].stem, '/') + 1);
    strcat(name, ".png");
    fixture_write(&f, name, "mine");
    fixture_keys(&f, "p");
    ck_assert_int_eq(count_files(".png"), 2);
    char *text = fixture_file(&f, name);
    ck_assert_str_eq(text, "mine");
    free(text);
}
END_TEST

/* What is seen is what is drawn: a chart that shows a part of the time is written so. */
START_TEST(the_part_shown_is_written)
{
    char line[400];
    int found = 0;
    fixture_keys(&f, "5");
    f.tui->window[THUD_SCREEN_PLOTS] = (struct thud_chart_window){0.5, 1.25};
    thud_tui_draw(f.tui);
    fixture_keys(&f, "p");
    snprintf(line, sizeof line, "%.380s.gp", f.tui->files.wrote[0].stem);
    FILE *script = fopen(line, "r");
    ck_assert_ptr_nonnull(script);
    while (fgets(line, sizeof line, script))
        found += strncmp(line, "set xrange [0.5:1.25]", 21) == 0;
    fclose(script);
    ck_assert_int_eq(found, 1);
}
END_TEST

/* What Plots keeps for a look is too little for a file: its run is made again. */
START_TEST(whole_histories_for_files)
{
    fixture_keys(&f, "5");
    ck_assert_int_eq((int)f.tui->run.live.history, (int)THUD_LIVE_CONTACTS);
    fixture_keys(&f, "p");
    fixture_expect(&f, "Written");
    ck_assert_int_eq((int)f.tui->run.live.history, (int)THUD_LIVE_WHOLE);
    ck_assert_int_eq(count_files(".png"), 1);
    fixture_keys(&f, ":set gap 1.5 cm<Enter>");
    ck_assert_int_eq((int)f.tui->run.live.history, (int)THUD_LIVE_CONTACTS);
    fixture_keys(&f, "e");
    fixture_expect(&f, "Written");
    ck_assert_int_eq((int)f.tui->run.live.history, (int)THUD_LIVE_WHOLE);
    fixture_keys(&f, ":set gap 1.4 cm<Enter>");
    for (int i = 0; i < 7; i++)
        fixture_keys(&f, "<Down>");
    fixture_expect(&f, "8/8 energy");
    ck_assert_int_eq((int)f.tui->run.live.history, (int)THUD_LIVE_WHOLE);
    fixture_expect(&f, "damping");
}
END_TEST

/* The motion without pounding is kept where it is seen: in figures with its curve, and as the case that moves. */
START_TEST(motions_that_are_seen)
{
    fixture_keys(&f, "5");
    ck_assert_ptr_null(thud_live_motions(&f.tui->run.live, THUD_LIVE_FREE));
    ck_assert_ptr_nonnull(thud_live_motions(&f.tui->run.live, THUD_LIVE_NONE));
    fixture_keys(&f, "<Down><Down>");
    fixture_expect(&f, "total floor acceleration (g)");
    ck_assert_ptr_nonnull(thud_live_motions(&f.tui->run.live, THUD_LIVE_FREE));
    fixture_keys(&f, "<Up><Up>:set gap 1.3 cm<Enter>");
    ck_assert_ptr_null(thud_live_motions(&f.tui->run.live, THUD_LIVE_FREE));
    fixture_keys(&f, "b");
    fixture_expect(&f, "no pounding");
    ck_assert_ptr_nonnull(thud_live_motions(&f.tui->run.live, THUD_LIVE_FREE));
}
END_TEST

/* The words of a title behind the scene's, up to what they are of; and those of a panel's axes. */
static void words_of(const struct thud_figure *figure, const struct thud_panel *panel, char *text, size_t size)
{
    char x[80], y[80];
    const char *title = thud_tui_figure_title(f.tui, figure);
    snprintf(text, size, "%.*s | %s | %s", (int)strcspn(title, ";,"), title,
             thud_axis_text(&panel->axis[THUD_X], x, sizeof x), thud_axis_text(&panel->axis[THUD_Y], y, sizeof y));
}

/* What the screen shows has title, axes and units of what `thud run -o` writes. */
START_TEST(screens_say_what_files_say)
{
    static const enum thud_run_figure of[] = {
#define THUD_PLOT(name, words, file, which) [THUD_PLOT_##name] = THUD_FIGURE_##which,
#include "tui/screens/plot_list.h"
#undef THUD_PLOT
    };
    fixture_keys(&f, "<Size 130x40>:set structures.1.yield.1 4 mm<Enter>5");
    for (int plot = 0; plot < THUD_PLOTS; plot++) {
        struct thud_figure_source source[THUD_LIVE_CASES];
        char screen[300], file[300];
        while ((int)thud_plots(f.tui)->plot != plot)
            fixture_keys(&f, "<Down>");
        f.tui->files.whole_wanted = THUD_DO_REPAINT; /* both of the same histories */
        thud_tui_run(f.tui);
        f.tui->files.whole_wanted = THUD_DO_NOTHING;
        fixture_keys(&f, "<C-l>");
        const struct thud_figure *shown = thud_views[THUD_SCREEN_PLOTS]->figure(f.tui);
        ck_assert_ptr_nonnull(shown);
        int n = 0;
        for (int i = plot == THUD_PLOT_FORCE ? THUD_LIVE_NONE : 0; i < THUD_LIVE_CASES; i++)
            source[n++] = thud_run_source(thud_live_name(0, (enum thud_live_which)i), thud_case_compared(i),
                                          &f.tui->doc.scene, f.tui->run.live.which[i].run);
        if (plot == THUD_PLOT_APPROACH) /* files have the velocities of the floors */
            continue;
        struct thud_figure *written = thud_run_figure(of[plot], source, n);
        const bool ground = strcmp(written->panel[0].axis[THUD_Y].label, "Ground") == 0;
        words_of(shown, &shown->panel[0], screen, sizeof screen);
        words_of(written, &written->panel[ground ? written->columns : 0], file, sizeof file);
        ck_assert_str_eq(screen, file);
        thud_figure_free(written);
    }
}
END_TEST

/* From a screen whose run kept no histories, too. */
START_TEST(all_figures)
{
    ck_assert(!f.tui->run.live.history);
    fixture_keys(&f, "P");
    fixture_expect(&f, "Written 8 figures");
    ck_assert_int_eq(count_files(".png"), 8);
    ck_assert_int_eq(count_files(".gp"), 8);
}
END_TEST

/* Every figure there is can be looked at and marked; the marked ones are written, also from the screen. */
START_TEST(figures_are_marked_on_the_shelf)
{
    fixture_keys(&f, "F");
    ck_assert_int_eq((int)f.tui->run.live.history, (int)THUD_LIVE_WHOLE);
    fixture_expect(&f, "Record: spectrum, ");
    fixture_keys(&f, "<Down> <Down> <Size 50x16><Size 80x24>");
    fixture_expect(&f, "2 of 12 marked");
    fixture_expect(&f, "A, storey"); /* of its panels the one with the curves */
    fixture_keys(&f, "]");
    fixture_expect(&f, "ground acceleration (g)");
    fixture_keys(&f, "[");
    fixture_keys(&f, " <Up> "); /* the fourth is marked and the third no longer is */
    fixture_expect(&f, "2 of 12 marked");
    fixture_keys(&f, "P");
    fixture_expect(&f, "Written 2 figures");
    ck_assert_int_eq(count_files(".png"), 2);
    fixture_keys(&f, ":set gap 1.4 cm<Enter>");
    fixture_keys(&f, "P");
    fixture_expect(&f, "Written 2 figures");
    ck_assert_int_eq(count_files(".png"), 4);
    fixture_keys(&f, "F<WheelDown><Esc>");
    ck_assert_int_eq((int)f.tui->dialog.mode, (int)THUD_MODE_NORMAL);
}
END_TEST

/* R on the shelf draws what is marked into a folder of its own, and the report gets it. */
START_TEST(marked_figures_go_into_the_report)
{
    char program[200], first[200];
    ck_assert_int_eq(chdir(f.folder), 0);
    fixture_program(&f, program, sizeof program, "printf '[%s]' \"$@\" >said");
    fixture_keys(&f, "F");
    fixture_keys(&f, "<Down> <Down> R");
    fixture_expect(&f, "thud report");
    ck_assert_int_eq(count_files_in("towers-figures", ".svg"), 2);
    ck_assert_int_eq(count_files_in("towers-figures", ".csv"), 2);
    fixture_keys(&f, "<Enter>");
    char *said = fixture_file(&f, "said");
    ck_assert_ptr_nonnull(said);
    snprintf(first, sizeof first, "[--figures][%s/towers-figures]", f.folder);
    ck_assert_msg(strstr(said, first) != NULL, "%s", said);
    free(said);
    fixture_keys(&f, "R<Enter>"); /* those were for that report alone */
    said = fixture_file(&f, "said");
    ck_assert_ptr_null(strstr(said, "--figures"));
    free(said);
    fixture_keys(&f, "F");
    fixture_keys(&f, "R");
    fixture_keys(&f, "<Esc>");
    ck_assert_int_eq(count_files_in("towers-figures-2", ".svg"), 2); /* the scene may be another since */
    fixture_keys(&f, ":set gap 3 cm<Enter>F");
    fixture_keys(&f, "R");
    fixture_expect(&f, "w saves them first");
}
END_TEST

/* The screens go on while gnuplot works: here it draws one figure and then hangs. */
START_TEST(stopping)
{
    use_gnuplot("if [ ! -e $folder/one ]; then : >$folder/one; exec gnuplot \"$@\"; fi\nexec sleep 1000");
    thud_tui_key(f.tui, 'P');
    while (f.tui->files.done < 1)
        thud_tui_turn(f.tui, true);
    thud_tui_draw(f.tui);
    fixture_expect(&f, "figures 1/8");
    thud_tui_key(f.tui, 'p');
    fixture_expect_not(&f, "Written");
    thud_tui_key(f.tui, 'g'); /* an edit is taken meanwhile */
    thud_tui_key(f.tui, '2');
    thud_tui_key(f.tui, THUD_KEY_ENTER);
    thud_tui_key(f.tui, '3');
    thud_tui_key(f.tui, THUD_KEY_ENTER);
    ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.03, 1e-15);
    ck_assert_ptr_nonnull(f.tui->files.work);
    fixture_keys(&f, "<Esc>");
    fixture_expect(&f, "Stopped: 1 of 8");
    ck_assert_ptr_null(f.tui->files.work);
    ck_assert_int_eq(count_files(".png"), 1);
    ck_assert_int_eq(count_files(".part"), 0);
}
END_TEST

/* What wakes the screens is for their turn: a drawing in between must leave it there, or the end would go unseen until
 * the next key. */
START_TEST(a_drawing_leaves_the_end_to_be_seen)
{
    use_gnuplot("exit 3");
    thud_tui_key(f.tui, 'P');
    while (!f.tui->files.work)
        thud_tui_turn(f.tui, false);
    struct pollfd ended = {thud_picture_work_fd(f.tui->files.work), POLLIN, 0};
    ck_assert_int_eq(poll(&ended, 1, -1), 1);
    thud_tui_draw(f.tui);
    fixture_expect(&f, "figures 0/8");
    ck_assert_int_eq(poll(&ended, 1, 0), 1);
    thud_picture_work_stop(f.tui->files.work);
    while (f.tui->files.work)
        thud_tui_turn(f.tui, true);
}
END_TEST

START_TEST(quitting_stops_it)
{
    use_gnuplot("exec sleep 1000");
    thud_tui_key(f.tui, 'P');
    while (!f.tui->files.work)
        thud_tui_turn(f.tui, false);
    thud_tui_free(f.tui); /* waits for the child to be gone */
    f.tui = NULL;
    ck_assert_int_eq(count_files(".png"), 0);
    ck_assert_int_eq(count_files(".part"), 0);
}
END_TEST

START_TEST(a_failed_gnuplot_is_said)
{
    use_gnuplot("echo broken >&2; exit 3");
    fixture_keys(&f, "P");
    fixture_expect(&f, "broken");
    ck_assert_int_eq(count_files(".png"), 0);
    ck_assert_int_eq(count_files(".gp"), 8); /* to be drawn by hand */
    f.tui->options.gnuplot = "/nowhere/gnuplot";
    fixture_keys(&f, "<A-2>p");
    fixture_expect(&f, "was not found");
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui pictures");
    TCase *pictures = tcase_create("pictures");
    tcase_set_timeout(pictures, 120.0);
    tcase_add_checked_fixture(pictures, setup, teardown);
    tcase_add_test(pictures, the_figure_shown);
    tcase_add_test(pictures, a_changed_picture_stays);
    tcase_add_test(pictures, a_picture_changed_at_once_stays);
    tcase_add_test(pictures, the_part_shown_is_written);
    tcase_add_test(pictures, whole_histories_for_files);
    tcase_add_test(pictures, motions_that_are_seen);
    tcase_add_test(pictures, screens_say_what_files_say);
    tcase_add_test(pictures, all_figures);
    tcase_add_test(pictures, figures_are_marked_on_the_shelf);
    tcase_add_test(pictures, marked_figures_go_into_the_report);
    tcase_add_test(pictures, stopping);
    tcase_add_test(pictures, a_drawing_leaves_the_end_to_be_seen);
    tcase_add_test(pictures, quitting_stops_it);
    tcase_add_test(pictures, a_failed_gnuplot_is_said);
    suite_add_tcase(suite, pictures);
    return suite;
}
