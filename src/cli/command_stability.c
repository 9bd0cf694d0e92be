/* thud stability: where methods fail. */
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

#include "app/run/figure_files.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/study_output.h"
#include "io/result/bench_rows.h"
#include "lab/bench/stability_report.h"

static enum thud_status save(const struct thud_stability *stability, const char *folder,
                             const struct thud_picture_options *options, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < THUD_STABILITY_TABLES; i++) {
        const struct thud_rows rows = thud_stability_rows(stability, i);
        status = thud_rows_save(&rows, folder, status, err);
    }
    for (int kind = 0; kind < THUD_STABILITY_KINDS; kind++)
        if (kind != THUD_STABILITY_SCENE || stability->peak_m)
            status = thud_figure_deliver(thud_stability_map(stability, kind), folder, options, status, err);
    return thud_figure_deliver(thud_stability_energies(stability), folder, options, status, err);
}

/* As people read it; as JSON all of its tables, as CSV the first: the verdicts. */
static void put(const struct thud_args *args, const struct thud_stability *stability, const char *preset,
                struct thud_text *out)
{
    static const char *const name[THUD_STABILITY_TABLES] = {"verdicts", "energies", "restitutions", "test-cases",
                                                            "methods"};
    bool json = thud_args_has(args, "json"), csv = thud_args_has(args, "csv");
    if (!json && !csv)
        thud_stability_table(stability, out);
    if (json)
        thud_text_append(out, "{");
    if (json)
        thud_json_head(out, preset);
    for (int i = 0; (json && i < THUD_STABILITY_TABLES) || (csv && i == 0); i++) {
        const struct thud_rows rows = thud_stability_rows(stability, i);
        if (json)
            thud_json_list(name[i], &rows, out);
        else
            thud_rows_csv(&rows, out);
    }
    thud_text_append(out, json ? "}\n" : "");
}

static void show_progress(int done, int jobs)
{
    thud_progress_show("%d of %d", done, jobs);
}

enum thud_status thud_command_stability(const struct thud_args *args, struct thud_session *session,
                                        struct thud_scene *scene, struct thud_error *err)
{
    struct thud_stability *plan = NULL;
    struct thud_picture_choice picture;
    static const char *const asked[] = {"case", NULL};
    struct thud_text text = {0};
    struct thud_made_by by;
    const char *folder = thud_args_value(args, "o");
    const atomic_int *cancel = thud_interrupt_watch();
    enum thud_status status = thud_picture_options_read(args, &picture, err);
    if (status == THUD_OK)
        status = thud_scene_options_of_case(args, session, scene, err);
    if (status == THUD_OK)
        status = thud_session_read_record(session, err);
    if (status == THUD_OK)
        status = thud_made_by_scene_file(args, "stability", session, scene, asked, &by, err);
    const bool begun = status == THUD_OK;
    if (status == THUD_OK)
        status = thud_stability_create(scene, session->record, &plan, err);
    thud_progress_start(args);
    if (status == THUD_OK)
        status = thud_stability_run(plan, cancel, show_progress, err);
    thud_progress_end();
    if (status == THUD_OK || (plan && status == THUD_CANCELLED)) {
        if (status == THUD_OK) /* what was done before a wish to stop is drawn */
            picture.options.cancel = cancel;
        put(args, plan, scene->name, &text);
        enum thud_status saved = folder ? save(plan, folder, &picture.options, err) : THUD_OK;
        enum thud_status printed = thud_cli_print_as(args, &text, THUD_OK, saved == THUD_OK ? err : NULL);
        if (saved != THUD_OK || printed != THUD_OK)
            status = saved != THUD_OK ? saved : printed;
    }
    thud_stability_free(plan);
    return begun ? thud_made_by_finish(args, &by, status, err) : status;
}
