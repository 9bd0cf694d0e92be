#include "app/sweep/study_keys.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void thud_study_vary_texts(const struct thud_scene *scene, char text[THUD_VARY_MAX][THUD_VARY_TEXT])
{
    const struct thud_study_choice *study = &scene->study;
    memset(text, 0, THUD_VARY_MAX * sizeof *text);
    for (int i = 0; i < study->nvary; i++)
        thud_study_vary_text(scene, i, text[i], sizeof text[i]);
    if (study->nvary == 0 && (study->ncases == 0 || !*study->records))
        snprintf(text[0], sizeof text[0], "%s=5 cm:25 cm:1 cm", scene->nstructures > 2 ? "interfaces.1.gap" : "gap");
}

const char *thud_study_proposed_cases(const struct thud_scene *scene)
{
    if (scene->study.nvary > 0 || scene->study.ncases > 0)
        return NULL;
    return thud_scene_has_bumper(scene) ? "none,bumper" : "none";
}

static enum thud_status plan_of(const struct thud_scene *scene, char text[THUD_VARY_MAX][THUD_VARY_TEXT],
                                struct thud_sweep_plan *plan, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    thud_sweep_plan_init(plan, scene);
    for (int i = 0; i < THUD_VARY_MAX && status == THUD_OK; i++)
        if (*text[i])
            status = thud_sweep_vary(plan, text[i], err);
    return status;
}

enum thud_status thud_study_plan(const struct thud_scene *scene, struct thud_sweep_plan *plan, struct thud_error *err)
{
    char text[THUD_VARY_MAX][THUD_VARY_TEXT];
    const char *cases = thud_study_proposed_cases(scene);
    thud_study_vary_texts(scene, text);
    enum thud_status status = plan_of(scene, text, plan, err);
    if (status == THUD_OK)
        status = thud_sweep_study(plan, false, true, err);
    return status == THUD_OK && cases ? thud_sweep_cases(plan, cases, err) : status;
}

/* False where a preset has no room for so many values. */
static bool keep_axis(const struct thud_sweep_axis *axis, bool ranges, struct thud_vary *vary)
{
    size_t n = 0;
    memset(vary, 0, sizeof *vary);
    snprintf(vary->key, sizeof vary->key, "%s", axis->key);
    vary->from = ranges ? axis->range[0] : NAN;
    vary->to = ranges ? axis->range[1] : NAN;
    vary->step = ranges ? axis->range[2] : NAN;
    for (int i = 0; i < axis->n && !ranges && n < sizeof vary->values; i++)
        n += (size_t)snprintf(vary->values + n, sizeof vary->values - n, "%s%s", i ? ", " : "", axis->text[i]);
    return n < sizeof vary->values;
}

enum thud_status thud_study_vary_keep(char text[THUD_VARY_MAX][THUD_VARY_TEXT], struct thud_scene *scene,
                                      struct thud_error *err)
{
    const char *cases = thud_study_proposed_cases(scene);
    struct thud_study_choice study = scene->study;
    struct thud_sweep_plan *plan = malloc(sizeof *plan);
    bool ranges = true, room = true;
    if (!plan)
        return thud_error_set(err, THUD_MEMORY, "no memory for the study");
    enum thud_status status = plan_of(scene, text, plan, err);
    if (status == THUD_OK && cases && (status = thud_sweep_cases(plan, cases, err)) == THUD_OK) {
        study.ncases = plan->ncases;
        memcpy(study.cases, plan->cases, sizeof study.cases);
    }
    for (int i = 0; i < plan->naxes; i++)
        ranges = ranges && !isnan(plan->axis[i].range[0]);
    memset(study.vary, 0, sizeof study.vary);
    study.nvary = 0;
    for (int i = 0; i < THUD_VARY_MAX && status == THUD_OK; i++) /* in the order of the texts */
        for (int a = 0; a < plan->naxes; a++)
            if (strncmp(text[i], plan->axis[a].key, strcspn(text[i], "=")) == 0 &&
                !plan->axis[a].key[strcspn(text[i], "=")])
                room = keep_axis(&plan->axis[a], ranges, &study.vary[study.nvary++]) && room;
    if (status == THUD_OK && !room)
        status = thud_error_set(err, THUD_USAGE, "a preset has no room for so many values: KEY=FROM:TO:STEP has");
    if (status == THUD_OK)
        scene->study = study;
    thud_sweep_plan_clear(plan);
    free(plan);
    return status;
}
