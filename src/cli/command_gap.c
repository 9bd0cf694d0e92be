/* thud gap: the required gap. */
#include "app/run/figure_files.h"
#include "app/sweep/gap_report.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/study_output.h"
#include "io/file/file.h"
#include "plot/figures/figures_gap.h"

static enum thud_status save(const struct thud_args *args, const struct thud_gap_study *study,
                             const struct thud_scene *scene, const struct thud_record_list *records,
                             struct thud_picture_choice *picture, const struct thud_made_by *by, struct thud_error *err)
{
    const char *folder = thud_args_value(args, "o");
    struct thud_text text = {0};
    enum thud_status status = thud_made_by_begin(by, err);
    const struct thud_rows levels = thud_gap_level_rows(study), rules = thud_gap_rule_rows(study);
    status = thud_rows_save(&levels, folder, status, err);
    status = thud_rows_save(&rules, folder, status, err);
    if (status == THUD_OK)
        status = thud_gap_json(study, scene, &text, err);
    status = thud_text_save(&text, folder, "needed-gaps.json", status, err);
    picture->options.cancel = thud_interrupt_watch();
    thud_picture_options_motions(picture, (const struct thud_record *const *)records->record, records->n);
    const char *title = scene->title[0] ? scene->title : scene->name;
    status = thud_figure_deliver(thud_figure_of_gaps(&study->suite, title), folder, &picture->options, status, err);
    return thud_made_by_end(by, status, err);
}

enum thud_status thud_command_gap(const struct thud_args *args, struct thud_session *session, struct thud_scene *scene,
                                  struct thud_error *err)
{
    struct thud_record_list records = {0};
    struct thud_gap_study study = {0};
    struct thud_picture_choice picture;
    struct thud_made_by by;
    struct thud_text text = {0};
    struct thud_gap_code code;
    const char *said;
    *scene = session->scene;
    enum thud_status status = thud_picture_options_read(args, &picture, err);
    thud_gap_code_init(&code);
    for (int i = 0; status == THUD_OK && (said = thud_args_repeated(args, "code", i)) != NULL; i++)
        status = thud_gap_code_set(&code, said, err);
    if (status == THUD_OK)
        status = thud_records_option_read(args, session, &records, err);
    static const char *const asked[] = {"records", "signs", "code", NULL};
    if (status == THUD_OK)
        status = thud_made_by_scene(args, "study", scene, (const struct thud_record *const *)records.record, records.n,
                                    asked, &by, err);
    if (status == THUD_OK)
        status = thud_gap_study_run(scene, &records, &code, thud_interrupt_watch(), &study, err);
    if (status == THUD_OK && study.gap[0]->nlevels == 0)
        status = thud_error_set(err, THUD_INPUT, "no floors of neighbours stand where they could touch");
    if (status == THUD_OK && !(thud_args_has(args, "csv") && !thud_args_has(args, "o")))
        status = thud_gap_study_rules(scene, &records, thud_interrupt_watch(), &study, err);
    if (status == THUD_OK && thud_args_has(args, "json"))
        status = thud_gap_json(&study, scene, &text, err);
    else if (status == THUD_OK && thud_args_has(args, "csv")) {
        const struct thud_rows levels = thud_gap_level_rows(&study);
        thud_rows_csv(&levels, &text);
    } else if (status == THUD_OK)
        status = thud_gap_report(&study, scene, &text, err);
    if (status == THUD_OK && thud_args_has(args, "o"))
        status = save(args, &study, scene, &records, &picture, &by, err);
    status = thud_cli_print_as(args, &text, status, err);
    thud_gap_study_clear(&study);
    thud_record_list_clear(&records);
    return status;
}
