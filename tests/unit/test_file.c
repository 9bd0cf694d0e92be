/* Files in the making belong to the program that makes them, whatever its process number, and go with it. */
#include <check.h>
#include <dirent.h>
#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/commands.h"
#include "io/file/file.h"

static char folder[64];

static void make_folder(void)
{
    strcpy(folder, "/tmp/thud-file-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
}

static int files(const char *ending)
{
    DIR *dir = opendir(folder);
    struct dirent *entry;
    int n = 0;
    while ((entry = readdir(dir)) != NULL) {
        size_t length = strlen(entry->d_name), most = strlen(ending);
        n += entry->d_name[0] != '.' && length >= most && strcmp(entry->d_name + length - most, ending) == 0;
    }
    closedir(dir);
    return n;
}

static void remove_folder(void)
{
    char command[100];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    ck_assert_int_eq(system(command), 0);
}

static const char *in_folder(const char *name)
{
    static char path[4][200];
    static int turn;
    turn = (turn + 1) % 4;
    snprintf(path[turn], sizeof path[turn], "%s/%s", folder, name);
    return path[turn];
}

/* A number that no process has. */
static long nobody(void)
{
    pid_t child = fork();
    if (child == 0)
        _exit(0);
    waitpid(child, NULL, 0);
    return (long)child;
}

/* In a child: a draft whose name is that of a process which does not run here, as a container's is; then waits. */
static _Noreturn void make_elsewhere(long pid, int ready)
{
    struct thud_file_draft draft;
    char name[64];
    if (thud_file_draft(in_folder("a.csv"), "x", 1, THUD_FILE_RESULT, &draft, NULL) != THUD_OK)
        _exit(1);
    snprintf(name, sizeof name, "a.csv.thud-%ld-0.part", pid);
    if (rename(draft.part, in_folder(name)) != 0 || write(ready, "", 1) != 1)
        _exit(2);
    for (;;)
        pause();
}

START_TEST(a_living_part_of_another_host_stays)
{
    long pid = nobody();
    int ends[2];
    char byte;
    ck_assert_int_eq(pipe(ends), 0);
    pid_t child = fork();
    if (child == 0)
        make_elsewhere(pid, ends[1]);
    ck_assert_int_eq(read(ends[0], &byte, 1), 1);
    ck_assert_int_eq(thud_folder_make(folder, NULL), THUD_OK);
    ck_assert_int_eq(files(".part"), 1);
    kill(child, SIGKILL);
    waitpid(child, NULL, 0);
    ck_assert_int_eq(thud_folder_make(folder, NULL), THUD_OK);
    ck_assert_int_eq(files(".part"), 0);
}
END_TEST

/* 0: the folder could be had. */
static int lock_in_child(void)
{
    pid_t child = fork();
    int status = -1;
    if (child == 0) {
        struct thud_folder_lock lock;
        struct thud_error err = {0};
        enum thud_status got = thud_folder_lock(folder, &lock, &err);
        _exit(got == THUD_OK ? 0 : got == THUD_OUTPUT && strstr(err.what, "another study") ? 1 : 2);
    }
    waitpid(child, &status, 0);
    return WEXITSTATUS(status);
}

START_TEST(a_folder_is_had_by_one)
{
    struct thud_folder_lock lock;
    ck_assert_int_eq(thud_folder_lock(folder, &lock, NULL), THUD_OK);
    ck_assert_int_eq(lock_in_child(), 1);
    thud_folder_unlock(&lock);
    ck_assert_int_eq(files(""), 0);
    ck_assert_int_eq(lock_in_child(), 0); /* and ends without giving it back */
    ck_assert_int_eq(thud_folder_lock(folder, &lock, NULL), THUD_OK);
    thud_folder_unlock(&lock);
}
END_TEST

/* A file of results takes the place of a link; one that the user named is written where the link shows. */
START_TEST(results_are_not_written_through_links)
{
    struct thud_text text = {0};
    char *kept;
    size_t size;
    ck_assert_int_eq(thud_file_write(in_folder("precious"), "old", 3, NULL), THUD_OK);
    ck_assert_int_eq(symlink("precious", in_folder("histories.csv")), 0);
    thud_text_append(&text, "new");
    ck_assert_int_eq(thud_text_save(&text, folder, "histories.csv", THUD_OK, NULL), THUD_OK);
    ck_assert_int_eq(thud_file_read(in_folder("precious"), 100, &kept, &size, NULL), THUD_OK);
    ck_assert_str_eq(kept, "old");
    free(kept);
    ck_assert_int_eq(thud_file_read(in_folder("histories.csv"), 100, &kept, &size, NULL), THUD_OK);
    ck_assert_str_eq(kept, "new");
    free(kept);
    ck_assert_int_eq(mkfifo(in_folder("impacts.csv"), 0600), 0); /* nobody reads it: writing into it would wait */
    thud_text_append(&text, "new");
    ck_assert_int_eq(thud_text_save(&text, folder, "impacts.csv", THUD_OK, NULL), THUD_OK);
    ck_assert_int_eq(symlink("precious", in_folder("preset.yaml")), 0);
    ck_assert_int_eq(thud_file_write(in_folder("preset.yaml"), "newer", 5, NULL), THUD_OK);
    ck_assert_int_eq(thud_file_read(in_folder("precious"), 100, &kept, &size, NULL), THUD_OK);
    ck_assert_str_eq(kept, "newer");
    free(kept);
}
END_TEST

/* In a child, with files in the making: `signals` interrupts. */
static _Noreturn void interrupted(bool watched, int signals)
{
    struct thud_file_draft draft;
    struct thud_file_draft output;
    struct thud_folder_lock lock;
    signal(SIGINT, SIG_DFL);
    thud_interrupt_start();
    if (watched)
        thud_interrupt_watch();
    if (thud_folder_lock(folder, &lock, NULL) != THUD_OK ||
        thud_file_draft(in_folder("a.csv"), "x", 1, THUD_FILE_RESULT, &draft, NULL) != THUD_OK ||
        thud_file_begin(in_folder("b.csv"), &output, NULL) != THUD_OK)
        _exit(1);
    for (int i = 0; i < signals; i++)
        raise(SIGINT);
    _exit(thud_interrupt_signal() == SIGINT ? 9 : 2);
}

static void *wait_for(void *flag)
{
    const atomic_int *caught = flag;
    while (!*caught)
        sched_yield();
    return NULL;
}

/* Workers read what the handler sets: an atomic object without a lock. */
START_TEST(a_thread_sees_the_interrupt)
{
    _Static_assert(_Generic(thud_interrupt_watch(), const atomic_int * : 1, default : 0), "an atomic object");
    pid_t child = fork();
    if (child == 0) {
        pthread_t worker;
        const atomic_int *caught = thud_interrupt_watch();
        if (!atomic_is_lock_free(caught) || pthread_create(&worker, NULL, wait_for, (void *)caught) != 0)
            _exit(1);
        raise(SIGINT);
        pthread_join(worker, NULL);
        _exit(*caught == SIGINT ? 0 : 2);
    }
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert(WIFEXITED(status));
    ck_assert_int_eq(WEXITSTATUS(status), 0);
}
END_TEST

START_TEST(an_interrupt_leaves_nothing_half_written)
{
    static const struct {
        bool watched;
        int signals, left, status; /* the exit status; -1: ended by the signal */
    } tries[] = {{false, 1, 0, -1}, {true, 2, 0, -1}, {true, 1, 3, 9}};
    pid_t child = fork();
    int status = 0;
    if (child == 0)
        interrupted(tries[_i].watched, tries[_i].signals);
    waitpid(child, &status, 0);
    ck_assert_int_eq(files(""), tries[_i].left);
    if (tries[_i].status < 0)
        ck_assert_int_eq(WIFSIGNALED(status) ? WTERMSIG(status) : 0, SIGINT);
    else
        ck_assert_int_eq(WEXITSTATUS(status), tries[_i].status);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("file");
    TCase *tcase = tcase_create("file");
    tcase_add_checked_fixture(tcase, make_folder, remove_folder);
    tcase_add_test(tcase, a_living_part_of_another_host_stays);
    tcase_add_test(tcase, a_folder_is_had_by_one);
    tcase_add_test(tcase, results_are_not_written_through_links);
    tcase_add_test(tcase, a_thread_sees_the_interrupt);
    tcase_add_loop_test(tcase, an_interrupt_leaves_nothing_half_written, 0, 3);
    suite_add_tcase(suite, tcase);
    return suite;
}
