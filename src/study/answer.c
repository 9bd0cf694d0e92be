#include "study/answer.h"

#include <string.h>

enum thud_status thud_scene_options(const struct thud_scene *scene, struct thud_run_options *out,
                                    struct thud_error *err)
{
    const struct thud_analysis *a = &scene->analysis;
    thud_run_options_init(out);
    out->tolerance = a->tolerance;
    out->step_s = a->step_s;
    out->tail_s = a->tail_s;
    out->locate = a->locate;
    if (strcmp(a->method, "auto") == 0)
        return THUD_OK;
    out->method = thud_method_find(a->method);
    if (out->method)
        return THUD_OK;
    thud_error_set(err, THUD_INPUT, "no method is called \"%s\"", a->method);
    thud_error_key(err, "method");
    thud_error_allow(err, "auto, or one of `thud methods`");
    return THUD_INPUT;
}

enum thud_status thud_scene_answer(const struct thud_scene *scene, const struct thud_record *record,
                                   const struct thud_run_options *options, struct thud_answer *out,
                                   struct thud_error *err)
{
    struct thud_run_options own;
    *out = (struct thud_answer){0};
    enum thud_status status = THUD_OK;
    if (!options) {
        status = thud_scene_options(scene, &own, err);
        options = &own;
    }
    if (status == THUD_OK)
        status = thud_scene_assemble(scene, &out->model, err);
    if (status == THUD_OK)
        status = thud_run_create(out->model, record, options, &out->run, err);
    for (bool done = false; status == THUD_OK && !done;)
        status = thud_run_advance(out->run, 1000, &done, err);
    if (status != THUD_OK && status != THUD_DIVERGED)
        thud_answer_clear(out);
    return status;
}

void thud_answer_clear(struct thud_answer *answer)
{
    thud_run_free(answer->run);
    thud_model_free(answer->model);
    *answer = (struct thud_answer){0};
}
