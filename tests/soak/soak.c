/* One process that works for a long time: runs, studies, presets, records and edits of the interface over and over.
 * What it holds in memory early it holds late.  usage: soak [FACTOR]    a line of TAP for each kind of work */
#define _GNU_SOURCE
#include <check.h>
#include <malloc.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../unit/tui_fixture.h"
#include "app/run/session.h"
#include "app/sweep/sweep_jobs.h"

static double factor = 1;

struct memory {
    size_t heap, resident; /* bytes */
};

static struct memory look(void)
{
    long pages = 0, total = 0;
    malloc_trim(0);
    FILE *file = fopen("/proc/self/statm", "r");
    if (file) {
        if (fscanf(file, "%ld %ld", &total, &pages) != 2)
            pages = 0;
        fclose(file);
    }
    struct mallinfo2 info = mallinfo2();
    return (struct memory){info.uordblks + info.hblkhd, (size_t)pages * (size_t)sysconf(_SC_PAGESIZE)};
}

static int failed(const char *what)
{
    printf("# %s\n", what);
    return 1;
}

static int one_run(long i)
{
    static const char *const presets[] = {"towers", "rigid-bumper", "rigid-concrete", "isolated-moat"};
    static struct thud_session session; /* large */
    static struct thud_scene scene;
    struct thud_solution solution = {0};
    struct thud_run_options options;
    int wrong = thud_session_open(&session, presets[i % 4], NULL) != THUD_OK;
    char gap[48];
    snprintf(gap, sizeof gap, "interfaces.1.gap=%ld mm", 100 + i % 200);
    wrong = wrong || thud_session_assign(&session, gap, NULL) != THUD_OK;
    wrong = wrong || thud_scene_options(&session.scene, &options, NULL) != THUD_OK;
    options.keep_history = options.keep_impacts = i % 16 == 0;
    options.tail_s = fmin(options.tail_s, 1);
    wrong = wrong || thud_session_run(&session, THUD_CASE_AS_WRITTEN, &options, &scene, &solution, NULL) != THUD_OK;
    thud_solution_clear(&solution);
    thud_session_close(&session);
    if (wrong)
        printf("# %s, %s\n", presets[i % 4], gap);
    return wrong;
}

static enum thud_status take(void *context, struct thud_sweep_point *point, struct thud_error *err)
{
    (void)context, (void)err;
    free(point);
    return THUD_OK;
}

static int one_study(long i)
{
    static struct thud_session session;
    static struct thud_sweep_plan plan;
    (void)i;
    int wrong = thud_session_open(&session, "rigid-bumper", NULL) != THUD_OK;
    thud_sweep_plan_init(&plan, &session.scene);
    wrong = wrong || thud_sweep_vary(&plan, "gap=5 cm:9 cm:1 cm", NULL) != THUD_OK;
    wrong = wrong || thud_sweep_cases(&plan, "none,bumper", NULL) != THUD_OK;
    struct thud_sweep_jobs jobs = {
        .plan = &plan, .step = 1, .count = thud_sweep_points(&plan), .threads = 2, .take = take};
    wrong = wrong || thud_sweep_jobs_run(&jobs, NULL) != THUD_OK;
    thud_sweep_plan_clear(&plan);
    thud_session_close(&session);
    return wrong ? failed("a study") : 0;
}

static int one_save(long i)
{
    static struct thud_session session;
    char change[64], *text = NULL;
    unsigned long size;
    int wrong = thud_session_open(&session, i % 2 ? "towers" : "three-in-a-row", NULL) != THUD_OK;
    snprintf(change, sizeof change, "structures.1.mass=%ld t", 100 + i % 400);
    wrong = wrong || thud_session_assign(&session, change, NULL) != THUD_OK;
    wrong = wrong || thud_preset_text(session.preset, &session.scene, &text, &size, NULL) != THUD_OK;
    free(text);
    thud_session_close(&session);
    return wrong ? failed("a preset saved") : 0;
}

static struct fixture fixture;

/* A value edited, computed, undone; every screen looked at in turn. What can be redone is forgotten by the next edit.
 */
static int one_edit(long i)
{
    char keys[64];
    snprintf(keys, sizeof keys, ":set gap %ld mm<Enter>", 20 + i % 50);
    fixture_keys(&fixture, keys);
    int wrong = fabs(fixture.tui->doc.scene.interface[0].gap_m - 1e-3 * (double)(20 + i % 50)) > 1e-12;
    snprintf(keys, sizeof keys, "u<A-%ld>", i % 8 + 1);
    fixture_keys(&fixture, keys);
    thud_tui_draw(fixture.tui);
    return wrong ? failed("an edit") : 0;
}

/* The first tenth of the work is for what is kept for good. */
static int work(const char *what, int (*one)(long i), long count)
{
    struct memory early = {0}, late;
    int wrong = 0;
    count = (long)((double)count * factor);
    for (long i = 0; i < count && !wrong; i++) {
        if (i == count / 10)
            early = look();
        wrong = one(i);
    }
    late = look();
    double heap = (double)late.heap - (double)early.heap, resident = (double)late.resident - (double)early.resident;
    bool flat = !wrong && heap < 64e3 && resident < 2e6;
    printf("%s - %ld %s: heap %.0f kB early and %.0f late, resident %.1f MB and %.1f\n", flat ? "ok" : "not ok", count,
           what, 1e-3 * (double)early.heap, 1e-3 * (double)late.heap, 1e-6 * (double)early.resident,
           1e-6 * (double)late.resident);
    fflush(stdout);
    return !flat;
}

static int wrong;

/* The fixture stands on Check's assertions, which want to be in a test. */
START_TEST(everything)
{
    wrong |= work("runs", one_run, 10000);
    wrong |= work("studies", one_study, 2000);
    wrong |= work("presets read, changed and saved", one_save, 10000);
    fixture_open(&fixture, "towers", 100, 30, true);
    wrong |= work("edits in one session of the interface", one_edit, 4000);
    fixture_close(&fixture);
}
END_TEST

int main(int argc, char **argv)
{
    if (argc > 1)
        factor = strtod(argv[1], NULL);
    TCase *tcase = tcase_create("soak");
    Suite *suite = suite_create("soak");
    tcase_set_timeout(tcase, 0);
    tcase_add_test(tcase, everything);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_set_fork_status(runner, CK_NOFORK);
    srunner_run_all(runner, CK_SILENT);
    wrong |= srunner_ntests_failed(runner) > 0;
    if (srunner_ntests_failed(runner) > 0)
        puts("not ok - the work came to its end");
    srunner_free(runner);
    return wrong;
}
