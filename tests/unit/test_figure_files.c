/* A figure's three files: all whole, or none half there, whatever the disk and gnuplot do. */
#include <check.h>
#include <dirent.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/run/figure_files.h"
#include "io/file/file.h"

static char folder[128];

static void make_folder(void)
{
    strcpy(folder, "/tmp/thud-figures a'b\"`touch X`-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
}

static char *in_folder(const char *name)
{
    static char path[512];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static void remove_folder(void)
{
    unlink(in_folder("f.png"));
    unlink(in_folder("f.gp"));
    unlink(in_folder("f.csv"));
    ck_assert_int_eq(rmdir(folder), 0); /* also: nothing else is left there */
}

static struct thud_figure *sample(size_t n)
{
    struct thud_figure *figure = thud_figure_create("f", "", 1, 1);
    struct thud_series *series =
        thud_panel_add(thud_figure_panel(figure, 0, 0, ""), (struct thud_style){0}, "a", n, NULL, NULL);
    for (size_t i = 0; i < n; i++) {
        series->x[i] = (double)i;
        series->y[i] = (double)(i * i % 17);
    }
    return figure;
}

static bool there(const char *name)
{
    return access(in_folder(name), F_OK) == 0;
}

static int files(void)
{
    int n = 0;
    DIR *dir = opendir(folder);
    while (readdir(dir))
        n++;
    closedir(dir);
    return n - 2;
}

START_TEST(three_files_in_a_folder_of_any_name)
{
    struct thud_picture_options options = {0};
    ck_assert_int_eq(thud_figure_deliver(sample(10), folder, NULL, THUD_OK, NULL), THUD_OK);
    ck_assert_int_eq(thud_figure_deliver(sample(10), folder, &options, THUD_OK, NULL), THUD_OK);
    ck_assert(there("f.png") && there("f.gp") && there("f.csv"));
    ck_assert_int_eq(files(), 3);
}
END_TEST

START_TEST(without_gnuplot_script_and_data_are_there)
{
    struct thud_picture_options options = {.program = "/nowhere/gnuplot"};
    struct thud_error err = {0};
    ck_assert_int_eq(thud_figure_deliver(sample(10), folder, &options, THUD_OK, &err), THUD_GNUPLOT);
    ck_assert(there("f.gp") && there("f.csv") && !there("f.png"));
    ck_assert_int_eq(files(), 2);
    unlink(in_folder("f.csv"));
    ck_assert_int_eq(thud_figure_deliver(sample(10), folder, &options, THUD_GNUPLOT, &err), THUD_GNUPLOT);
    ck_assert(there("f.csv"));
}
END_TEST

START_TEST(a_failed_picture_leaves_the_old_one)
{
    struct thud_picture_options options = {0};
    ck_assert_int_eq(thud_figure_deliver(sample(10), folder, &options, THUD_OK, NULL), THUD_OK);
    struct stat before, after;
    ck_assert_int_eq(stat(in_folder("f.png"), &before), 0);
    options.program = "/bin/false";
    ck_assert_int_eq(thud_figure_deliver(sample(10), folder, &options, THUD_OK, NULL), THUD_GNUPLOT);
    ck_assert_int_eq(stat(in_folder("f.png"), &after), 0);
    ck_assert(before.st_ino == after.st_ino && before.st_size == after.st_size);
}
END_TEST

/* A limit on file sizes fails in write(2) as a full disk does. */
START_TEST(a_full_disk_leaves_nothing_half_written)
{
    struct thud_picture_options options = {0};
    struct rlimit old, small;
    struct thud_error err = {0};
    signal(SIGXFSZ, SIG_IGN);
    ck_assert_int_eq(getrlimit(RLIMIT_FSIZE, &old), 0);
    small = old;
    ck_assert_int_eq(thud_figure_deliver(sample(10), folder, &options, THUD_OK, NULL), THUD_OK);
    ck_assert_int_eq(unlink(in_folder("f.csv")), 0);
    struct stat before, after;
    ck_assert_int_eq(stat(in_folder("f.gp"), &before), 0);
    for (rlim_t room = 0; room <= 18000; room += 18000) { /* no file at all; the script but not the data */
        small.rlim_cur = room;
        ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &small), 0);
        enum thud_status status = thud_figure_deliver(sample(2000), folder, &options, THUD_OK, &err);
        ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &old), 0);
        ck_assert_int_eq(status, THUD_OUTPUT);
        ck_assert_ptr_nonnull(strstr(err.file, room ? "f.csv" : "f.gp"));
        ck_assert_int_eq(files(), 2); /* what was there before, as it was */
        ck_assert_int_eq(stat(in_folder("f.gp"), &after), 0);
        ck_assert(before.st_ino == after.st_ino && before.st_size == after.st_size);
    }
}
END_TEST

START_TEST(a_stopped_figure_leaves_no_file)
{
    atomic_int stop = 1;
    struct thud_picture_options options = {.cancel = &stop};
    ck_assert_int_eq(thud_figure_deliver(sample(10), folder, &options, THUD_OK, NULL), THUD_CANCELLED);
    ck_assert_int_eq(files(), 0);
}
END_TEST

START_TEST(a_folder_that_cannot_be_is_named)
{
    struct thud_picture_options options = {0};
    struct thud_error err = {0};
    ck_assert_int_eq(thud_figure_deliver(sample(3), "/dev/null/f", &options, THUD_OK, &err), THUD_OUTPUT);
    ck_assert_ptr_nonnull(strstr(err.file, "/dev/null"));
    ck_assert_int_eq(thud_figure_deliver(NULL, folder, &options, THUD_OK, &err), THUD_MEMORY);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("figure_files");
    TCase *tcase = tcase_create("figure_files");
    tcase_set_timeout(tcase, 60);
    tcase_add_checked_fixture(tcase, make_folder, remove_folder);
    tcase_add_test(tcase, three_files_in_a_folder_of_any_name);
    tcase_add_test(tcase, without_gnuplot_script_and_data_are_there);
    tcase_add_test(tcase, a_failed_picture_leaves_the_old_one);
    tcase_add_test(tcase, a_full_disk_leaves_nothing_half_written);
    tcase_add_test(tcase, a_stopped_figure_leaves_no_file);
    tcase_add_test(tcase, a_folder_that_cannot_be_is_named);
    suite_add_tcase(suite, tcase);
    return suite;
}
