/* Writing and reading files while memory, reads, writes and renames fail one after the other: what was on disk stays
 * whole, nothing is left beside it, and the status says what happened. */
#include <check.h>
#include <dirent.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "fault.h"
#include "io/file/file.h"

static char folder[64];
static char path[128];
static const char before[] = "what was there before\n";
static const char after[] = "what is to stand there, a little longer than that\n";

static void enter(void)
{
    strcpy(folder, "/tmp/thud-fault-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
    strcat(strcpy(path, folder), "/file");
    ck_assert_int_eq(thud_file_write(path, before, sizeof before - 1, NULL), THUD_OK);
}

static void leave(void)
{
    unlink(path);
    ck_assert_int_eq(rmdir(folder), 0);
}

static int files_in_folder(void)
{
    int n = 0;
    DIR *dir = opendir(folder);
    ck_assert_ptr_nonnull(dir);
    for (const struct dirent *entry; (entry = readdir(dir)) != NULL;)
        n += entry->d_name[0] != '.';
    closedir(dir);
    return n;
}

static void holds(const char *text)
{
    char *read = NULL;
    size_t size = 0;
    ck_assert_int_eq(thud_file_read(path, 1000, &read, &size, NULL), THUD_OK);
    ck_assert_str_eq(read, text);
    ck_assert_uint_eq(size, strlen(text));
    free(read);
    ck_assert_int_eq(files_in_folder(), 1);
}

START_TEST(a_write_that_fails_leaves_the_old_file_alone)
{
    long n = 0;
    for (;;) {
        struct thud_error err = {0};
        long live = thud_fault_live();
        thud_fault_arm(THUD_FAULT_WRITE, ++n);
        enum thud_status status = thud_file_write(path, after, sizeof after - 1, &err);
        bool fired = thud_fault_end();
        live -= thud_fault_live();
        ck_assert_int_eq(live, 0);
        if (!fired) {
            ck_assert_int_eq(status, THUD_OK);
            break;
        }
        if (status == THUD_OK) { /* closing comes last, after what was written is synced and has its name */
            holds(after);
            ck_assert_int_eq(n, 5);
            continue;
        }
        ck_assert_int_eq(status, THUD_OUTPUT);
        ck_assert_str_eq(err.file, path);
        ck_assert_str_ne(err.what, "");
        holds(before);
    }
    ck_assert_int_gt(n, 5); /* open, write, fsync, close, rename were all reached */
    holds(after);
}
END_TEST

START_TEST(a_read_that_fails_says_so_and_leaks_nothing)
{
    for (enum thud_fault kind = THUD_FAULT_MEMORY; kind <= THUD_FAULT_READ; kind++) {
        long n = 0;
        for (bool fired = true; fired;) {
            struct thud_error err = {0};
            char *text = NULL;
            size_t size = 0;
            long live = thud_fault_live();
            thud_fault_arm(kind, ++n);
            enum thud_status status = thud_file_read(path, 1000, &text, &size, &err);
            fired = thud_fault_end();
            bool given = text != NULL;
            free(text);
            live -= thud_fault_live();
            ck_assert_int_eq(status, !fired ? THUD_OK : kind == THUD_FAULT_MEMORY ? THUD_MEMORY : THUD_INPUT);
            ck_assert_int_eq(given, !fired);
            ck_assert_int_eq(live, 0);
        }
        ck_assert_int_gt(n, 1);
    }
}
END_TEST

START_TEST(a_text_that_ran_out_of_memory_is_not_written)
{
    bool fired = true;
    long n = 0;
    while (fired) {
        struct thud_text text = {0};
        long live = thud_fault_live();
        thud_fault_arm(THUD_FAULT_MEMORY, ++n);
        for (int i = 0; i < 2000; i++)
            thud_text_append(&text, "%d ", i);
        fired = thud_fault_end();
        bool failed = text.failed != 0;
        enum thud_status status = thud_text_write(&text, path, NULL);
        live -= thud_fault_live();
        ck_assert_int_eq(failed, fired);
        ck_assert_int_eq(status, fired ? THUD_MEMORY : THUD_OK);
        ck_assert_int_eq(live, 0);
        if (fired)
            holds(before);
    }
    ck_assert_int_gt(n, 3); /* it grew more than twice */
}
END_TEST

START_TEST(a_folder_that_cannot_be_made_is_named)
{
    char deep[256];
    strcat(strcpy(deep, folder), "/a/b");
    struct thud_error err = {0};
    thud_fault_arm(THUD_FAULT_WRITE, 2);
    enum thud_status status = thud_folder_make(deep, &err);
    bool fired = thud_fault_end();
    ck_assert(fired);
    ck_assert_int_eq(status, THUD_OUTPUT);
    ck_assert_str_ne(err.file, "");
    ck_assert_int_eq(thud_folder_make(deep, &err), THUD_OK);
    ck_assert_int_eq(rmdir(deep), 0);
    *strrchr(deep, '/') = '\0';
    ck_assert_int_eq(rmdir(deep), 0);
}
END_TEST

static void leave_part(pid_t pid, char *name, size_t size)
{
    snprintf(name, size, "%s/sweep.csv.thud-%ld-0.part", folder, (long)pid);
    FILE *file = fopen(name, "w");
    ck_assert_ptr_nonnull(file);
    ck_assert_int_eq(fclose(file), 0);
}

/* What a killed program left goes, what a living one is writing stays; and so does everything of another name. */
START_TEST(what_the_dead_left_is_tidied)
{
    char living[160], dead[160], other[160];
    pid_t child = fork();
    if (child == 0)
        _exit(0);
    ck_assert_int_gt(child, 0);
    ck_assert_int_eq(waitpid(child, NULL, 0), child);
    leave_part(getpid(), living, sizeof living);
    leave_part(child, dead, sizeof dead);
    snprintf(other, sizeof other, "%s/film.%ld.part", folder, (long)child);
    ck_assert_int_eq(rename(dead, other), 0);
    leave_part(child, dead, sizeof dead);
    ck_assert_int_eq(thud_folder_make(folder, NULL), THUD_OK);
    ck_assert_int_eq(access(living, F_OK), 0);
    ck_assert_int_eq(access(other, F_OK), 0);
    ck_assert_int_ne(access(dead, F_OK), 0);
    unlink(living);
    unlink(other);
}
END_TEST

static atomic_bool opening;

static void end(void)
{
    thud_file_drop_all();
    _exit(0);
}

static void end_elsewhere(void) /* the first thread ends meanwhile */
{
    const struct timespec half = {.tv_nsec = 1000000};
    opening = true;
    nanosleep(&half, NULL);
}

static void *write_file(void *unused)
{
    (void)unused;
    thud_file_write(path, after, sizeof after - 1, NULL);
    pause();
    return NULL;
}

/* A signal ends the program while a file is made: just behind that in the same thread, just before it in another
 * one. */
START_TEST(a_file_just_made_is_dropped_too)
{
    const bool other_thread = _i;
    pid_t child = fork();
    if (child == 0) {
        pthread_t thread;
        thud_fault_around_open(other_thread ? end_elsewhere : NULL, other_thread ? NULL : end);
        if (other_thread && pthread_create(&thread, NULL, write_file, NULL) == 0)
            while (!opening)
                ;
        if (other_thread)
            end();
        write_file(NULL);
    }
    ck_assert_int_gt(child, 0);
    ck_assert_int_eq(waitpid(child, NULL, 0), child);
    ck_assert_int_eq(files_in_folder(), 1);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("fault_file");
    TCase *tcase = tcase_create("fault_file");
    tcase_add_checked_fixture(tcase, enter, leave);
    tcase_add_test(tcase, a_write_that_fails_leaves_the_old_file_alone);
    tcase_add_test(tcase, a_read_that_fails_says_so_and_leaks_nothing);
    tcase_add_test(tcase, a_text_that_ran_out_of_memory_is_not_written);
    tcase_add_test(tcase, a_folder_that_cannot_be_made_is_named);
    tcase_add_loop_test(tcase, a_file_just_made_is_dropped_too, 0, 2);
    tcase_add_test(tcase, what_the_dead_left_is_tidied);
    suite_add_tcase(suite, tcase);
    return suite;
}
