/* thud run: one scene, one result. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/figure_files.h"
#include "app/run/result_table.h"
#include "app/run/run_cases.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/study_output.h"
#include "io/file/file.h"
#include "study/sweep/remark.h"

static enum thud_status write_folder(const struct thud_report *report, const char *folder, struct thud_error *err)
{
    static const struct {
        const char *name;
        void (*put)(const struct thud_report *report, struct thud_text *out);
    } file[] = {
        {"result.json", thud_result_json}, {"histories.csv", thud_history_csv}, {"impacts.csv", thud_impacts_csv}};
    enum thud_status status = thud_folder_make(folder, err);
    for (size_t i = 0; i < sizeof file / sizeof *file && status == THUD_OK; i++) {
        struct thud_text text = {0};
        file[i].put(report, &text);
        status = thud_text_save(&text, folder, file[i].name, status, err);
    }
    return status;
}

static enum thud_status deliver(const struct thud_args *args, const struct thud_report *report, struct thud_error *err)
{
    const char *folder = thud_args_value(args, "o");
    enum thud_status status = folder ? write_folder(report, folder, err) : THUD_OK;
    struct thud_text text = {0};
    if (status != THUD_OK)
        return status;
    if (thud_args_has(args, "events"))
        thud_event_list(report,
                        thud_args_has(args, "json")  ? THUD_EVENTS_JSON
                        : thud_args_has(args, "csv") ? THUD_EVENTS_CSV
                                                     : THUD_EVENTS_TEXT,
                        &text);
    else if (thud_args_has(args, "json"))
        thud_result_json(report, &text);
    else if (thud_args_has(args, "csv"))
        thud_result_csv(report, 1, &text);
    else
        thud_result_table(report, &text);
    return thud_cli_print_as(args, &text, THUD_OK, err);
}

/* The bumper of a scene, for titles. */
static const char *case_title(const struct thud_scene *scene)
{
    bool cavity = false;
    for (int i = 0; i + 1 < scene->nstructures; i++)
        cavity |= scene->interface[i].has_bumper && scene->interface[i].bumper_cavity_m > 0;
    return thud_case_title(thud_scene_measures(scene),
                           cavity && scene->nlinks == 0 ? THUD_CASE_CAVITY : THUD_CASE_WHOLE);
}

/* Their data stand in histories.csv. */
static enum thud_status draw_run(const struct thud_args *args, struct thud_picture_choice *picture,
                                 const struct thud_scene *scene, const struct thud_solution *solution,
                                 struct thud_error *err)
{
    struct thud_figure_source source = thud_run_source(case_title(scene), THUD_CASE_AS_WRITTEN, scene, solution->run);
    picture->options.no_data = true;
    picture->options.cancel = thud_interrupt_watch();
    thud_progress_start(args);
    enum thud_status status = thud_run_figures_save(&source, 1, thud_args_value(args, "o"), &picture->options, err);
    thud_progress_end();
    return status;
}

/* What is allowed but unusual, with its place: the preset, unless an option changed it. */
static void warn_unusual(const struct thud_args *args, const struct thud_session *session,
                         const struct thud_scene *scene)
{
    const struct thud_remark_scope scope = {.scene = scene}, preset = {.scene = thud_preset_scene(session->preset)};
    struct thud_remarks found = thud_remarks_find(&scope, THUD_REMARK_SCENE),
                        written = thud_remarks_find(&preset, THUD_REMARK_SCENE);
    for (int i = 0; i < found.n; i++) {
        struct thud_error *said = &found.item[i].said;
        const struct thud_remark *own = thud_remarks_like(&written, &found.item[i]);
        if (own && strcmp(own->said.what, said->what) == 0)
            thud_error_place(said, session->preset_path, 0, 0);
        else
            thud_scene_options_name(args, THUD_OK, said);
        thud_cli_warn(said);
    }
    thud_remarks_clear(&found);
    thud_remarks_clear(&written);
}

/* All that is to be said of a run; but a collapse, which ends it, is said at the end. */
static void warn_of_run(const struct thud_args *args, const struct thud_session *session,
                        const struct thud_scene *scene, const struct thud_run *run)
{
    struct thud_remark_scope scope = {
        .scene = scene, .before = thud_preset_scene(session->preset), .result = thud_run_result(run)};
    const struct thud_method *method = thud_method_find(scope.result->method);
    struct thud_error fall = {0};
    if (thud_args_has(args, "quiet"))
        return;
    warn_unusual(args, session, scene);
    scope.impact = thud_run_impacts(run, &scope.nimpacts);
    thud_collapse_remark(scene, &scope.result->collapse, &fall);
    struct thud_remarks found = thud_remarks_find(&scope, THUD_REMARK_CHANGE | THUD_REMARK_RESULT);
    for (int i = 0; i < found.n; i++)
        if (strcmp(found.item[i].said.what, fall.what) != 0)
            thud_cli_warn(&found.item[i].said);
    thud_remarks_clear(&found);
    if (thud_args_has(args, "step") && method && !(method->flags & THUD_METHOD_FIXED_STEP))
        fprintf(stderr, "thud: warning: --step: %s takes steps of its own\n", scope.result->method);
}

/* Makes the further runs that qualify the result (error of the modes left out, sensitivity), then shows the result. */
static enum thud_status report_run(const struct thud_args *args, const struct thud_session *session,
                                   const struct thud_scene *scene, enum thud_case which,
                                   const struct thud_solution *solution, struct thud_error *err)
{
    struct thud_report report = thud_session_report(session, scene, which, solution);
    struct thud_truncation truncation;
    struct thud_sensitivity *sensitivity = NULL;
    struct thud_needed_gap *gap = NULL;
    double change = thud_scene_options_change(args, scene);
    enum thud_status status = THUD_OK;
    if (solution->model->left_out > 0) {
        status = thud_truncation_measure(scene, session->record, solution, &truncation, err);
        report.truncation = &truncation;
    }
    if (status == THUD_OK && change > 0)
        status = thud_sensitivity_run(scene, session->record, change, report.result, &sensitivity, err);
    report.sensitivity = sensitivity;
    if (!thud_args_has(args, "json") && !thud_args_has(args, "csv"))
        thud_needed_gap_run(scene, session->record, &gap, NULL); /* where it cannot be had nothing is said of it */
    report.gap = gap;
    if (status == THUD_OK)
        status = deliver(args, &report, err);
    thud_sensitivity_free(sensitivity);
    free(gap);
    return status;
}

/* Before a run that takes long, about how long. What is wrong with the ground motion the run says. */
static void say_effort(const struct thud_args *args, struct thud_session *session)
{
    if (thud_session_read_record(session, NULL) != THUD_OK)
        return;
    const struct thud_record *record = session->record;
    const struct thud_remark_scope scope = {.scene = &session->scene, .record = &record, .nrecords = record != NULL};
    thud_cli_remarks(args, &scope, THUD_REMARK_EFFORT);
}

/* A run that failed shows no peaks: as JSON its status, when and why, else the message alone. */
static enum thud_status report_failure(const struct thud_args *args, const struct thud_session *session,
                                       const struct thud_scene *scene, enum thud_case which,
                                       const struct thud_solution *solution, const struct thud_error *failure,
                                       struct thud_error *err)
{
    struct thud_text text = {0};
    if (!thud_args_has(args, "json") || !solution->run)
        return THUD_OK;
    struct thud_report report = thud_session_report(session, scene, which, solution);
    report.failure = failure;
    thud_result_json(&report, &text);
    return thud_cli_print(&text, err);
}

/* Files of every case in a folder of its own, figures of all beside each other. */
static enum thud_status write_cases(const struct thud_args *args, struct thud_picture_choice *picture,
                                    const struct thud_session *session, const struct thud_run_cases *cases,
                                    const struct thud_made_by *by, struct thud_error *err)
{
    const char *folder = thud_args_value(args, "o");
    struct thud_figure_source source[THUD_RUN_CASES_MAX];
    enum thud_status status = thud_made_by_begin(by, err);
    for (int i = 0; i < cases->n && status == THUD_OK; i++) {
        char path[4096];
        const struct thud_run_case *item = &cases->item[i];
        struct thud_report report = thud_session_report(session, &item->scene, item->which, &item->solution);
        if (snprintf(path, sizeof path, "%s/%s", folder, thud_case_name(item->which)) >= (int)sizeof path)
            return thud_error_set(err, THUD_OUTPUT, "the folder's name is too long");
        status = write_folder(&report, path, err);
    }
    if (status != THUD_OK)
        return status;
    picture->options.no_data = true;
    picture->options.cancel = thud_interrupt_watch();
    thud_progress_start(args);
    status = thud_run_figures_save(source, thud_run_cases_sources(cases, source), folder, &picture->options, err);
    thud_progress_end();
    return thud_made_by_end(by, status, err);
}

/* The common beginning of one run and of several cases. It reads the options of pictures and of the run, checks that
 * the folder is free for the results, and says if it takes long. Errors: those of the options, of the ground motion and
 * of thud_made_by_check. */
static enum thud_status begin_run(const struct thud_args *args, struct thud_session *session,
                                  struct thud_picture_choice *picture, struct thud_run_options *options,
                                  struct thud_made_by *by, struct thud_error *err)
{
    static const char *const asked[] = {"case", "cases", NULL};
    enum thud_status status = thud_picture_options_read(args, picture, err);
    if (status == THUD_OK)
        status = thud_scene_options(&session->scene, options, err);
    if (status == THUD_OK && thud_args_has(args, "o")) {
        status = thud_session_read_record(session, err);
        if (status == THUD_OK)
            status = thud_made_by_scene(args, "run", &session->scene,
                                        (const struct thud_record *const *)&session->record, 1, asked, by, err);
    }
    if (status != THUD_OK)
        return status;
    say_effort(args, session);
    if (session->record)
        thud_records_warn(args, (const struct thud_record *const *)&session->record, 1);
    thud_picture_options_motions(picture, (const struct thud_record *const *)&session->record, 1);
    options->keep_history = thud_args_has(args, "o");
    options->keep_impacts = true;
    options->keep_events = thud_args_has(args, "events");
    return THUD_OK;
}

/* The rows of every case, no pounding first, under its name. */
static void put_cases(const struct thud_args *args, const struct thud_session *session,
                      const struct thud_run_cases *cases, struct thud_text *out)
{
    bool json = thud_args_has(args, "json");
    if (!json && !thud_args_has(args, "csv")) {
        thud_run_cases_table(cases, out);
        return;
    }
    struct thud_report report[THUD_RUN_CASES_MAX];
    if (json)
        thud_text_append(out, "{\"format\": %d, \"cases\": [\n", THUD_RESULT_FORMAT);
    for (int i = 0; i < cases->n; i++) {
        const struct thud_run_case *item = &cases->item[i];
        report[i] = thud_session_report(session, &item->scene, item->which, &item->solution);
        if (json) {
            thud_result_json(&report[i], out);
            thud_text_append(out, i + 1 < cases->n ? ",\n" : "");
        }
    }
    if (json)
        thud_text_append(out, "]}\n");
    else
        thud_result_csv(report, cases->n, out);
}

static enum thud_status run_cases(const struct thud_args *args, struct thud_session *session, struct thud_error *err)
{
    static const char *const alone[] = {"case", "sensitivity", "events"};
    struct thud_run_options options;
    struct thud_run_cases *cases = NULL;
    struct thud_picture_choice picture;
    struct thud_made_by by;
    struct thud_text text = {0};
    for (size_t i = 0; i < sizeof alone / sizeof *alone; i++)
        if (thud_args_has(args, alone[i]))
            return thud_error_set(err, THUD_USAGE, "--cases and --%s together", alone[i]);
    enum thud_status status = begin_run(args, session, &picture, &options, &by, err);
    if (status != THUD_OK)
        return status;
    status = thud_run_cases_make(session, thud_args_value(args, "cases"), &options, &cases, err);
    if (status != THUD_OK)
        return status;
    for (int i = 1; i < cases->n; i++)
        thud_cli_remarks(args,
                         &(struct thud_remark_scope){.scene = &cases->item[i].scene,
                                                     .result = thud_run_result(cases->item[i].solution.run)},
                         THUD_REMARK_LEDGER);
    const struct thud_run_case *shown = &cases->item[cases->n - 1]; /* whose bumper projects most */
    for (int i = 1; i < cases->n; i++)
        if (cases->item[i].which == THUD_CASE_BUMPER)
            shown = &cases->item[i];
    warn_of_run(args, session, &shown->scene, shown->solution.run);
    put_cases(args, session, cases, &text);
    status = thud_cli_print_as(args, &text, THUD_OK, err);
    if (status == THUD_OK && options.keep_history)
        status = write_cases(args, &picture, session, cases, &by, err);
    for (int i = 0; i < cases->n && status == THUD_OK; i++)
        status =
            thud_collapse_status(&cases->item[i].scene, &thud_run_result(cases->item[i].solution.run)->collapse, err);
    thud_run_cases_free(cases);
    return status;
}

static enum thud_status run(const struct thud_args *args, struct thud_session *session, struct thud_scene *scene,
                            struct thud_error *err)
{
    if (thud_args_has(args, "floor-spectra"))
        return thud_cli_floor_spectra(args, session, err);
    if (thud_args_has(args, "cases"))
        return run_cases(args, session, err);
    struct thud_run_options options;
    struct thud_solution solution = {0};
    struct thud_picture_choice picture;
    struct thud_made_by by;
    enum thud_case which;
    enum thud_status status = thud_scene_options_case(args, &which, err);
    if (status == THUD_OK)
        status = begin_run(args, session, &picture, &options, &by, err);
    if (status != THUD_OK)
        return status;
    status = thud_session_run(session, which, &options, scene, &solution, err);
    if (status == THUD_OK) {
        thud_cli_remarks(args, &(struct thud_remark_scope){.scene = scene, .result = thud_run_result(solution.run)},
                         THUD_REMARK_LEDGER);
        warn_of_run(args, session, scene, solution.run);
        if (options.keep_history)
            status = thud_made_by_begin(&by, err);
        if (status == THUD_OK)
            status = report_run(args, session, scene, which, &solution, err);
        if (status == THUD_OK && options.keep_history)
            status = thud_made_by_end(&by, draw_run(args, &picture, scene, &solution, err), err);
        if (status == THUD_OK)
            status = thud_collapse_status(scene, &thud_run_result(solution.run)->collapse, err);
    } else if (status == THUD_DIVERGED) {
        struct thud_error failure = *err;
        enum thud_status printed = report_failure(args, session, scene, which, &solution, &failure, err);
        status = printed == THUD_OK ? status : printed;
    }
    thud_solution_clear(&solution);
    return status;
}

enum thud_status thud_command_run(const struct thud_args *args, struct thud_error *err)
{
    enum thud_status status = thud_args_has(args, "floor-spectra") ? THUD_OK : thud_cli_no_floor_spectra(args, err);
    return status == THUD_OK ? thud_scene_options_with(args, run, err) : status;
}
