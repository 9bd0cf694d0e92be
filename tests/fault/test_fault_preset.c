/* A preset read, assembled and run while one allocation after the other fails: out of memory is said, and nothing is
 * left behind. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "fault.h"
#include "io/preset.h"
#include "study/answer.h"

/* Reads the preset and runs its scene without a ground motion, with the n-th allocation failing. */
static enum thud_status run_once(const char *path, long n, bool *fired, long *lost, char *said)
{
    struct thud_preset *preset = NULL;
    struct thud_answer answer = {0};
    struct thud_error err = {0};
    *lost = thud_fault_live();
    thud_fault_arm(THUD_FAULT_MEMORY, n);
    enum thud_status status = thud_preset_read(path, &preset, &err);
    if (status == THUD_OK)
        status = thud_scene_answer(thud_preset_scene(preset), NULL, NULL, &answer, &err);
    *fired = thud_fault_end();
    thud_answer_clear(&answer);
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

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("fault_preset");
    TCase *tcase = tcase_create("fault_preset");
    tcase_add_loop_test(tcase, a_preset_and_its_answer, 0, sizeof paths / sizeof *paths);
    suite_add_tcase(suite, tcase);
    return suite;
}
