#include "app/verify/verify_preset.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/run/session.h"
#include "io/file/file.h"
#include "io/result/expectation_file.h"

static const double tight_tolerance = 1e-12;

/* What the verification needs while it runs. */
struct work {
    struct thud_session session;
    struct thud_scene scene; /* of a case */
    struct thud_checked_values own, independent;
    const char *method; /* that was picked by default */
    void (*progress)(void *context, const char *what);
};

static enum thud_status run_case(struct work *work, enum thud_case which, const struct thud_run_options *options,
                                 struct thud_checked_values *measures, const char **method, struct thud_error *err)
{
    struct thud_solution solution;
    enum thud_status status = thud_session_run(&work->session, which, options, &work->scene, &solution, err);
    if (status == THUD_OK) {
        const struct thud_result *result = thud_run_result(solution.run);
        const struct thud_method *used = thud_method_find(result->method);
        *method = used ? used->name : "?";
        status = thud_checked_values_add(measures, &work->scene, which, result, err);
    }
    thud_solution_clear(&solution);
    return status;
}

/* Every case, by `method` (NULL: the preset's own). */
static enum thud_status run_cases(struct work *work, const char *method, struct thud_checked_values *measures,
                                  const char **used, struct thud_error *err)
{
    const struct thud_study_choice *study = &work->session.scene.study;
    struct thud_run_options options;
    enum thud_status status = thud_scene_options(&work->session.scene, &options, err);
    if (method) {
        options.method = thud_method_find(method);
        options.tolerance = tight_tolerance;
        options.locate = true;
    }
    int cases = study->ncases > 0 ? study->ncases : 1;
    for (int i = 0; i < cases && status == THUD_OK; i++) {
        enum thud_case which = study->ncases > 0 ? study->cases[i] : THUD_CASE_AS_WRITTEN;
        char what[THUD_NAME_MAX + 64];
        snprintf(what, sizeof what, "%s, case %s, by %s", work->session.scene.name, thud_case_name(which),
                 options.method ? options.method->name : "auto");
        thud_text_shown(what, "");
        if (work->progress)
            work->progress(NULL, what);
        status = run_case(work, which, &options, measures, used, err);
    }
    return status == THUD_OK ? thud_checked_values_add_ratios(measures, err) : status;
}

static enum thud_status read_expected(struct thud_verification *v, const char *preset, struct thud_error *err)
{
    if (access(v->path, F_OK) == 0)
        return thud_expectation_read(v->path, &v->expected, err);
    if (v->update)
        return THUD_OK;
    thud_error_in(err, THUD_INPUT, v->path, 0, "there are no expectations");
    thud_error_allow(err, "`thud verify --update %.100s` writes them", preset);
    return THUD_INPUT;
}

static enum thud_status compare(struct thud_verification *v, const struct work *work, struct thud_error *err)
{
    v->check = calloc(v->expected.n + 1, sizeof *v->check);
    if (!v->check)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (size_t i = 0; i < v->expected.n; i++) {
        v->check[i] = thud_verify_check(&v->expected.item[i], &work->own);
        v->count[v->check[i].verdict]++;
    }
    return THUD_OK;
}

static void setting_text(const struct work *work, char *text, size_t size)
{
    const struct thud_analysis *a = &work->session.scene.analysis;
    const struct thud_method *method = thud_method_find(work->method);
    if (!method || !(method->flags & THUD_METHOD_FIXED_STEP))
        snprintf(text, size, "tolerance %g", a->tolerance);
    else if (isnan(a->step_s))
        snprintf(text, size, "with its default step");
    else
        snprintf(text, size, "step %g s", a->step_s);
}

static enum thud_status renew(struct thud_verification *v, struct work *work, struct thud_error *err)
{
    char setting[64];
    setting_text(work, setting, sizeof setting);
    struct thud_expectation_origin origin = {
        .preset = v->name, .own = work->method, .own_setting = setting, .independent_tolerance = tight_tolerance};
    enum thud_status status =
        run_cases(work, thud_verify_independent(work->method), &work->independent, &origin.independent, err);
    if (status == THUD_OK)
        status = thud_verify_confirm(&work->own, &work->independent, &v->fresh, &v->disputed, err);
    if (status == THUD_OK && v->fresh.n == 0)
        return thud_error_in(err, THUD_INPUT, work->session.preset_path, 0,
                             "%s and %s agree on nothing, so there is nothing to expect", origin.own,
                             origin.independent);
    if (status == THUD_OK)
        thud_expectation_text(&origin, &v->fresh, &v->disputed, &v->text);
    return status;
}

static enum thud_status verify(struct thud_verification *v, struct work *work, struct thud_error *err)
{
    snprintf(v->name, sizeof v->name, "%s", work->session.scene.name);
    v->cases = work->session.scene.study.ncases > 0 ? work->session.scene.study.ncases : 1;
    enum thud_status status = thud_expectation_path(work->session.preset_path, v->path, sizeof v->path, err);
    if (status == THUD_OK)
        status = read_expected(v, work->session.preset_path, err);
    if (status == THUD_OK)
        status = run_cases(work, NULL, &work->own, &work->method, err);
    if (status == THUD_OK)
        status = compare(v, work, err);
    return status == THUD_OK && v->update ? renew(v, work, err) : status;
}

enum thud_status thud_verify_preset(const char *preset, bool update, void (*progress)(void *context, const char *what),
                                    struct thud_verification *out, struct thud_error *err)
{
    *out = (struct thud_verification){.update = update};
    struct work *work = calloc(1, sizeof *work);
    if (!work)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    work->progress = progress;
    enum thud_status status = thud_session_open(&work->session, preset, err);
    if (status == THUD_OK)
        status = verify(out, work, err);
    thud_session_close(&work->session);
    thud_checked_values_clear(&work->own);
    thud_checked_values_clear(&work->independent);
    free(work);
    if (status != THUD_OK)
        thud_verify_clear(out);
    return status;
}

/* Whether the file holds these bytes already. */
static bool same(const char *path, const struct thud_text *text)
{
    char *old;
    size_t size;
    if (text->failed || access(path, F_OK) != 0 || thud_file_read(path, text->size, &old, &size, NULL) != THUD_OK)
        return false;
    bool equal = size == text->size && memcmp(old, text->data, size) == 0;
    free(old);
    return equal;
}

enum thud_status thud_verify_write(struct thud_verification *v, struct thud_error *err)
{
    if (same(v->path, &v->text))
        return THUD_OK;
    enum thud_status status = thud_text_write(&v->text, v->path, err);
    v->written = status == THUD_OK;
    return status;
}

void thud_verify_clear(struct thud_verification *v)
{
    thud_expectations_clear(&v->expected);
    thud_expectations_clear(&v->fresh);
    thud_expectations_clear(&v->disputed);
    thud_text_clear(&v->text);
    free(v->check);
    v->check = NULL;
}
