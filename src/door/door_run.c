/* Runs and sweeps of a scene of the library. */
#include <stdlib.h>
#include <string.h>

#include "app/run/record_list.h"
#include "app/run/threads.h"
#include "app/sweep/sweep_jobs.h"
#include "door/door.h"
#include "io/result/result_rows.h"
#include "io/result/sweep_csv.h"
#include "study/methods/truncation.h"
#include "study/sweep/remark.h"

/* Segments of a run between two looks at the caller's wish to stop. */
enum { SLICE = 20 };

/* What the caller said; nothing has come out yet. */
static enum thud_status begin(const struct thud *scene, const struct thud_control *given, struct thud_control *control,
                              struct thud_results **out, struct thud_error *err)
{
    enum thud_status status = THUD_NEED(err, scene, out);
    *control = (struct thud_control){.size = sizeof *control};
    if (status != THUD_OK)
        return status;
    *out = NULL;
    return given ? thud_door_read(given, sizeof given->size, control, sizeof *control, "thud_control", err) : THUD_OK;
}

/* The tables of what a CSV's columns are. */
#define SCHEMAS(...)                                                                                                   \
    (const struct thud_schema *const[])                                                                                \
    {                                                                                                                  \
        __VA_ARGS__, NULL                                                                                              \
    }

static enum thud_status stopped(struct thud_error *err)
{
    return thud_error_set(err, THUD_CANCELLED, "stopped");
}

static enum thud_status advance(struct thud_run *run, const struct thud_control *control, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (bool done = false; status == THUD_OK && !done;) {
        status = thud_run_advance(run, SLICE, &done, err);
        double part = done ? 1 : thud_run_time(run) / thud_run_end(run);
        if (status == THUD_OK && control->progress && control->progress(control->context, part) && !done)
            status = stopped(err);
    }
    return status;
}

/* Errors: THUD_MEMORY. */
static enum thud_status put_histories(const struct thud_report *report, struct thud_results *results,
                                      struct thud_error *err)
{
    struct thud_text text = {0};
    struct thud_history header = *report->history;
    struct thud_report no_rows = *report;
    thud_impacts_csv(report, &text);
    enum thud_status status = thud_door_csv(results, "impacts", &text, SCHEMAS(&thud_impact_schema), err);
    if (status != THUD_OK)
        return status;
    header.rows = 0;
    no_rows.history = &header;
    thud_history_csv(&no_rows, &text);
    return thud_door_matrix(results, "histories", &text, report->history->time_s, report->history->value,
                            report->history->rows, err);
}

static enum thud_status put_run(const struct thud_report *report, bool histories, struct thud_results *results,
                                struct thud_error *err)
{
    struct thud_text text = {0};
    thud_result_json(report, &text);
    if (text.failed) {
        thud_text_clear(&text);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    results->json = text.data;
    text = (struct thud_text){0};
    thud_result_csv(report, 1, &text);
    enum thud_status status = thud_door_csv(results, "floors", &text, SCHEMAS(&thud_floor_schema), err);
    if (status != THUD_OK)
        return status;
    const struct thud_rows contacts = thud_contact_rows(report);
    thud_rows_csv(&contacts, &text);
    status = thud_door_csv(results, "contacts", &text, SCHEMAS(&thud_contact_schema), err);
    return status == THUD_OK && histories ? put_histories(report, results, err) : status;
}

/* As `thud run --json` has it: with the error of modes that are left out. */
static enum thud_status run_case(struct thud *scene, const struct thud_control *control, enum thud_case which,
                                 struct thud_scene *cased, struct thud_results *results, struct thud_error *err)
{
    struct thud_run_options options;
    struct thud_solution solution = {0};
    struct thud_truncation truncation;
    const struct thud_step_watch watch = {control->step, control->context};
    enum thud_status status = thud_session_case(&scene->session, which, cased, err);
    if (status == THUD_OK)
        status = thud_scene_options(cased, &options, err);
    if (status != THUD_OK)
        return status;
    options.keep_history = control->histories != 0;
    options.keep_impacts = true; /* which remarks count */
    options.watch = control->step ? &watch : NULL;
    status = thud_scene_start(cased, scene->session.record, &options, &solution, err);
    if (status == THUD_OK)
        status = advance(solution.run, control, err);
    if (status == THUD_OK) {
        struct thud_report report = thud_session_report(&scene->session, cased, which, &solution);
        if (solution.model->left_out > 0) {
            status = thud_truncation_measure(cased, scene->session.record, &solution, &truncation, err);
            report.truncation = &truncation;
        }
        if (status == THUD_OK)
            status = put_run(&report, control->histories != 0, results, err);
        if (status == THUD_OK)
            status = thud_collapse_status(cased, &report.result->collapse, err);
    }
    thud_solution_clear(&solution);
    return status;
}

/* Hands the results over, of a run that ended in a collapse those up to it, or frees them. */
static enum thud_status conclude(struct thud_results *results, enum thud_status status, struct thud_results **out)
{
    if (status == THUD_OK || status == THUD_COLLAPSED)
        *out = results;
    else
        thud_free(results);
    return status;
}

enum thud_status thud_run(struct thud *scene, const struct thud_control *control, struct thud_results **out,
                          struct thud_error *err)
{
    struct thud_control own;
    enum thud_case which = THUD_CASE_AS_WRITTEN;
    enum thud_status status = begin(scene, control, &own, out, err);
    if (status == THUD_OK && own.which)
        status = thud_case_find(own.which, &which, err);
    if (status != THUD_OK)
        return status;
    locale_t before = thud_threads_numbers();
    struct thud_results *results = calloc(1, sizeof *results);
    struct thud_scene *cased = malloc(sizeof *cased);
    status = results && cased ? run_case(scene, &own, which, cased, results, err)
                              : thud_error_set(err, THUD_MEMORY, "out of memory");
    free(cased);
    thud_threads_numbers_back(before);
    return conclude(results, status, out);
}

/* ---- sweeps ---- */

struct sweep {
    struct thud_sweep_plan plan;
    struct thud_record_list records; /* where the scene's own is not an array */
    struct thud_text text[THUD_SWEEP_CSVS];
    const struct thud_control *control;
    atomic_int stop;
};

static enum thud_status deliver_point(void *context, struct thud_sweep_point *point, struct thud_error *err)
{
    struct sweep *s = context;
    (void)err;
    for (int i = 0; i < THUD_SWEEP_CSVS; i++)
        thud_sweep_csv_rows(&s->plan, (enum thud_sweep_csv)i, point, &s->text[i]);
    free(point);
    return THUD_OK;
}

static void progress(void *context, long done, long count, double elapsed_s)
{
    struct sweep *s = context;
    (void)elapsed_s;
    if (s->control->progress && s->control->progress(s->control->context, (double)done / (double)count))
        s->stop = 1;
}

/* The study's ground motions, else the scene's own one. */
static enum thud_status read_records(struct sweep *s, struct thud_session *session, struct thud_error *err)
{
    const struct thud_study_choice *study = &session->scene.study;
    if (session->given && strcmp(session->scene.record.file, session->given->file) == 0) {
        const enum thud_status status = thud_session_read_record(session, err);
        s->plan.record = (const struct thud_record *const *)&session->record;
        s->plan.nrecords = 1;
        return status;
    }
    const enum thud_status status =
        thud_record_list_named(session, study->records, study->both_signs, &s->records, err);
    s->plan.record = (const struct thud_record *const *)s->records.record;
    s->plan.nrecords = s->records.n;
    return status;
}

static enum thud_status plan_sweep(struct sweep *s, const char *const *vary, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    if (!vary && s->plan.scene.study.nvary == 0 && s->plan.nrecords < 2)
        return thud_error_refuse(err, THUD_USAGE, NULL, "what is varied, such as gap=5cm:25cm:0.5cm",
                                 "the scene has no study of its own");
    for (int i = 0; vary && vary[i] && status == THUD_OK; i++)
        status = thud_sweep_vary(&s->plan, vary[i], err);
    if (status == THUD_OK)
        status = thud_sweep_study(&s->plan, !vary, !s->control->which, err);
    if (status == THUD_OK && s->control->which)
        status = thud_sweep_cases(&s->plan, s->control->which, err);
    for (int i = 0; i < THUD_SWEEP_CSVS && status == THUD_OK; i++)
        thud_sweep_csv_header(&s->plan, (enum thud_sweep_csv)i, &s->text[i]);
    return status;
}

static enum thud_status make_points(struct sweep *s, struct thud_results *results, struct thud_error *err)
{
    static const char *const names[] = {"sweep", "contacts", "needed-gaps"};
    const struct thud_sweep_jobs jobs = {.plan = &s->plan,
                                         .step = 1,
                                         .count = thud_sweep_points(&s->plan),
                                         .threads = s->control->threads,
                                         .cancel = &s->stop,
                                         .context = s,
                                         .take = deliver_point,
                                         .progress = progress};
    static const struct thud_schema *const schema[] = {&thud_sweep_floor_schema, &thud_sweep_contact_schema,
                                                       &thud_need_schema};
    struct thud_made_columns axes;
    enum thud_status status = thud_sweep_jobs_run(&jobs, err);
    thud_axis_columns(&s->plan, NULL, &axes);
    for (int i = 0; i < THUD_SWEEP_CSVS && status == THUD_OK; i++)
        status = thud_door_csv(results, names[i], &s->text[i], SCHEMAS(schema[i], &axes.schema), err);
    return status;
}

static enum thud_status sweep(struct sweep *s, struct thud_session *session, const char *const *vary,
                              struct thud_results *results, struct thud_error *err)
{
    thud_sweep_plan_init(&s->plan, &session->scene);
    enum thud_status status = read_records(s, session, err);
    if (status == THUD_OK)
        status = plan_sweep(s, vary, err);
    if (status == THUD_OK)
        status = make_points(s, results, err);
    for (int i = 0; i < THUD_SWEEP_CSVS; i++)
        thud_text_clear(&s->text[i]);
    thud_sweep_plan_clear(&s->plan);
    thud_record_list_clear(&s->records);
    return status;
}

enum thud_status thud_sweep(struct thud *scene, const char *const *vary, const struct thud_control *control,
                            struct thud_results **out, struct thud_error *err)
{
    struct thud_control own;
    enum thud_status status = begin(scene, control, &own, out, err);
    if (status != THUD_OK)
        return status;
    locale_t before = thud_threads_numbers();
    struct thud_results *results = calloc(1, sizeof *results);
    struct sweep *s = calloc(1, sizeof *s);
    if (results && s) {
        s->control = &own;
        status = sweep(s, &scene->session, vary, results, err);
    } else {
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    free(s);
    thud_threads_numbers_back(before);
    return conclude(results, status, out);
}
