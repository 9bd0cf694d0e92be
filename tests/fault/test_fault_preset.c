/* A preset read, assembled and run while one allocation after the other fails: out of memory is said, and nothing is
 * left behind. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "fault.h"
#include "io/file/file.h"
#include "io/preset/preset.h"
#include "study/scene/solution.h"

/* Reads the preset and runs its scene without a ground motion, with the n-th allocation failing. */
static enum thud_status run_once(const char *path, long n, bool *fired, long *lost, char *said)
{
    struct thud_preset *preset = NULL;
    struct thud_solution solution = {0};
    struct thud_error err = {0};
    *lost = thud_fault_live();
    thud_fault_arm(THUD_FAULT_MEMORY, n);
    enum thud_status status = thud_preset_read(path, &preset, &err);
    if (status == THUD_OK)
        status = thud_scene_solve(thud_preset_scene(preset), NULL, NULL, &solution, &err);
    *fired = thud_fault_end();
    thud_solution_clear(&solution);
    thud_preset_free(preset);
    *lost -= thud_fault_live();
    thud_error_text(&err, said, 1024);
    return status;
}

static const char *const paths[] = {"presets/rigid-bumper.yaml", "presets/rigid-concrete.yaml"};

START_TEST(a_preset_and_its_answer)
{
    bool fired;
    long n = 0, lost;
    char said[1024];
    do {
        enum thud_status status = run_once(paths[_i], ++n, &fired, &lost, said);
        ck_assert_msg(lost == 0, "%s: allocation %ld leaves %ld blocks", paths[_i], n, -lost);
        ck_assert_msg(status == (fired ? THUD_MEMORY : THUD_OK), "%s: allocation %ld gives status %d: %s", paths[_i], n,
                      (int)status, said);
    } while (fired);
    ck_assert_int_gt(n, 5);
}
END_TEST

/* A changed preset as text: right to the last byte, or out of memory; never written in a poorer way for want of it. */
START_TEST(a_preset_saved)
{
    static struct thud_scene scene;
    struct thud_preset *preset;
    struct thud_error err = {0};
    char *text, *right = NULL;
    unsigned long size, right_size = 0;
    bool fired;
    long n = 0, lost;
    ck_assert_int_eq(thud_preset_read("presets/towers.yaml", &preset, &err), THUD_OK);
    scene = *thud_preset_scene(preset);
    ck_assert_int_eq(thud_scene_set(&scene, "gap", "12 cm", &err), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "structures.1.storeys", "5", &err), THUD_OK);
    ck_assert_int_eq(thud_scene_set(&scene, "analysis.step", "1 ms", &err), THUD_OK);
    scene.interface[0].has_bumper = false;
    ck_assert_int_eq(thud_preset_text(preset, &scene, &right, &right_size, &err), THUD_OK);
    do {
        lost = thud_fault_live();
        thud_fault_arm(THUD_FAULT_MEMORY, ++n);
        enum thud_status status = thud_preset_text(preset, &scene, &text, &size, &err);
        fired = thud_fault_end();
        if (status == THUD_OK) {
            ck_assert_msg(size == right_size && memcmp(text, right, size) == 0, "allocation %ld: other bytes", n);
            free(text);
        } else
            ck_assert_int_eq(status, THUD_MEMORY);
        ck_assert_msg(thud_fault_live() == lost, "allocation %ld leaves something", n);
    } while (fired);
    ck_assert_int_gt(n, 20);
    free(right);
    thud_preset_free(preset);
}
END_TEST

static bool reads(const char *path, const char *wanted, size_t wanted_size)
{
    char *text;
    size_t size;
    ck_assert_int_eq(thud_file_read(path, 1 << 20, &text, &size, NULL), THUD_OK);
    bool same = size == wanted_size && memcmp(text, wanted, size) == 0;
    free(text);
    return same;
}

/* On the disk: whatever fails, the old file byte for byte or the new one, alone in its folder. */
START_TEST(a_preset_saved_on_a_disk)
{
    static struct thud_scene scene;
    char folder[] = "/tmp/thud-fault-XXXXXX", path[64], *old, *new;
    struct thud_preset *preset;
    size_t old_size;
    unsigned long new_size;
    ck_assert_int_eq(thud_file_read("presets/towers.yaml", 1 << 20, &old, &old_size, NULL), THUD_OK);
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/p.yaml", folder);
    ck_assert_int_eq(thud_file_write(path, old, old_size, NULL), THUD_OK);
    ck_assert_int_eq(thud_preset_read(path, &preset, NULL), THUD_OK);
    scene = *thud_preset_scene(preset);
    ck_assert_int_eq(thud_scene_set(&scene, "gap", "12 cm", NULL), THUD_OK);
    ck_assert_int_eq(thud_preset_text(preset, &scene, &new, &new_size, NULL), THUD_OK);
    for (enum thud_fault kind = THUD_FAULT_MEMORY; kind < THUD_FAULTS; kind++) {
        bool fired = true;
        for (long n = 1; fired; n++) {
            struct thud_error err = {0};
            ck_assert_int_eq(thud_file_write(path, old, old_size, NULL), THUD_OK);
            long live = thud_fault_live();
            thud_fault_arm(kind, n);
            enum thud_status status = thud_preset_save(preset, &scene, path, &err);
            fired = thud_fault_end();
            live -= thud_fault_live();
            ck_assert_msg(live == 0, "call %ld of kind %d leaves %ld blocks", n, (int)kind, -live);
            ck_assert_msg(reads(path, status == THUD_OK ? new : old, status == THUD_OK ? new_size : old_size),
                          "call %ld of kind %d: status %d and another file", n, (int)kind, (int)status);
            ck_assert(status == THUD_OK || err.what[0]);
            ck_assert(fired || status == THUD_OK);
        }
    }
    thud_preset_free(preset);
    free(old);
    free(new);
    ck_assert_int_eq(unlink(path), 0);
    ck_assert_int_eq(rmdir(folder), 0); /* nothing else is there */
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("fault_preset");
    TCase *tcase = tcase_create("fault_preset");
    tcase_add_loop_test(tcase, a_preset_and_its_answer, 0, sizeof paths / sizeof *paths);
    tcase_add_test(tcase, a_preset_saved);
    tcase_add_test(tcase, a_preset_saved_on_a_disk);
    suite_add_tcase(suite, tcase);
    return suite;
}
