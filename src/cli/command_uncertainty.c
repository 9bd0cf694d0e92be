/* thud uncertainty: how sure a result is. */
#include "app/run/figure_files.h"
#include "app/sweep/uncertainty_study.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/study_output.h"
#include "io/file/file.h"

enum { SAMPLES = 200 };

static void show_progress(void *context, long done, long count, double elapsed_s)
{
    (void)context;
    if (done > 0 && done < count)
        thud_progress_show("%ld of %ld samples, %.0f s left", done, count,
                           elapsed_s / (double)done * (double)(count - done));
    else
        thud_progress_show("%ld of %ld samples", done, count);
}

static enum thud_status save(const struct thud_args *args, const struct thud_uncertainty_study *study,
                             struct thud_picture_choice *picture, const struct thud_made_by *by, struct thud_error *err)
{
    const char *folder = thud_args_value(args, "o");
    struct thud_text text = {0};
    enum thud_status status = THUD_OK;
    const int tables = THUD_UNCERTAINTY_TABLES - !(study->indices && study->samples > 0);
    for (int i = 0; i < tables; i++) {
        const struct thud_rows rows = thud_uncertainty_rows(study, (enum thud_uncertainty_table)i);
        status = thud_rows_save(&rows, folder, status, err);
    }
    thud_uncertainty_samples_csv(study, &text);
    status = thud_text_save(&text, folder, "samples.csv", status, err);
    thud_uncertainty_json(study, &text);
    status = thud_text_save(&text, folder, "uncertainty.json", status, err);
    picture->options.cancel = study->cancel;
    for (int i = 0; i < thud_uncertainty_figure_count(study); i++)
        status = thud_figure_deliver(thud_uncertainty_figure(study, i), folder, &picture->options, status, err);
    return thud_made_by_end(by, status, err);
}

static enum thud_status read_options(const struct thud_args *args, struct thud_uncertainty_study *study,
                                     struct thud_inputs *inputs, struct thud_error *err)
{
    struct thud_inputs_choice choice;
    enum thud_status status = thud_inputs_option_read(args, SAMPLES, &choice, err);
    if (status == THUD_OK)
        status = thud_args_integer(args, "j", 1, THUD_JOBS_MAX, 0, &study->threads, err);
    *inputs = choice.inputs;
    study->samples = choice.samples;
    study->sampling = choice.sampling;
    study->seed = choice.seed;
    study->indices = thud_args_has(args, "indices");
    study->cancel = thud_interrupt_watch();
    if (thud_progress_start(args))
        study->progress = show_progress;
    return status;
}

enum thud_status thud_command_uncertainty(const struct thud_args *args, struct thud_session *session,
                                          struct thud_scene *scene, struct thud_error *err)
{
    struct thud_uncertainty_study study = {0};
    struct thud_uncertainty *u = NULL;
    struct thud_picture_choice picture;
    struct thud_inputs inputs;
    struct thud_made_by by;
    struct thud_text text = {0};
    enum thud_case which;
    *scene = session->scene;
    enum thud_status status = thud_picture_options_read(args, &picture, err);
    if (status == THUD_OK)
        status = thud_scene_options_case(args, &which, err);
    if (status == THUD_OK)
        status = read_options(args, &study, &inputs, err);
    struct thud_record_list records = {0};
    bool own = scene->record.file[0], several = thud_args_value(args, "records") || thud_args_has(args, "signs") ||
                                                (!own && scene->study.records[0]);
    if (status == THUD_OK && (own || !several))
        status = thud_session_read_record(session, err);
    if (status == THUD_OK && several)
        status = thud_records_option_read(args, session, &records, err);
    static const char *const asked[] = {"case", "uncertain", "sampling", "seed", NULL};
    bool suite = records.n > 0;
    const struct thud_record *const *motions =
        (const struct thud_record *const *)(suite ? records.record : &session->record);
    if (status == THUD_OK)
        status = thud_made_by_scene(args, "uncertainty", scene, motions, suite ? records.n : 1, asked, &by, err);
    if (status == THUD_OK)
        status = thud_uncertainty_create(scene, suite ? NULL : session->record,
                                         (const struct thud_record *const *)records.record, records.n, which, &inputs,
                                         &u, err);
    study.uncertainty = u;
    study.by = status == THUD_OK && thud_args_has(args, "o") ? &by : NULL;
    if (status == THUD_OK)
        status = thud_uncertainty_study_run(&study, err);
    thud_progress_end();
    if (status == THUD_OK && thud_args_has(args, "csv")) {
        const struct thud_rows rows = thud_uncertainty_rows(&study, THUD_UNCERTAINTY_QUANTITIES);
        thud_rows_csv(&rows, &text);
    } else if (status == THUD_OK)
        (thud_args_has(args, "json") ? thud_uncertainty_json : thud_uncertainty_table)(&study, &text);
    if (status == THUD_OK && thud_args_has(args, "o")) {
        thud_picture_options_motions(&picture, motions, suite ? records.n : 1);
        status = save(args, &study, &picture, &by, err);
        study.is_written = status == THUD_OK || status == THUD_GNUPLOT;
    }
    status = thud_cli_print_as(args, &text, status, err);
    thud_uncertainty_study_clear(&study);
    thud_uncertainty_free(u);
    thud_record_list_clear(&records);
    return status;
}
