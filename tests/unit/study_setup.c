#include <check.h>
#include <stdlib.h>

#include "study_setup.h"

struct thud_scene *scene;
struct thud_sweep_plan *plan;
const struct thud_record *records[2];
struct thud_error error;
struct thud_record *motion;

void study_set_up(double factor)
{
    scene = malloc(2 * sizeof *scene);
    plan = malloc(sizeof *plan);
    thud_test_towers(scene);
    records[0] = motion = thud_test_motion(factor);
    records[1] = NULL;
    thud_sweep_plan_init(plan, scene);
    plan->record = records;
    plan->nrecords = 1;
}

void study_tear_down(void)
{
    thud_sweep_plan_clear(plan);
    thud_record_free(motion);
    free(plan);
    free(scene);
}

void vary(const char *text)
{
    ck_assert_msg(thud_sweep_vary(plan, text, &error) == THUD_OK, "%s: %s", error.key, error.what);
}
