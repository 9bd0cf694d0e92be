/* thud bench: speed against accuracy, every method. */
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

#include "app/run/figure_files.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/study_output.h"
#include "io/file/file.h"
#include "io/file/json.h"
#include "io/result/bench_rows.h"
#include "lab/bench/bench_jobs.h"

static void show_progress(void *context, const char *what, int done, int count)
{
    struct thud_figure *figure =
        context && thud_progress_is_watched() ? thud_bench_figure(context, "Speed against accuracy so far") : NULL;
    thud_progress_show("%d of %d  %s", done, count, what);
    thud_progress_figure(figure);
    thud_figure_free(figure);
}

/* With -o the rows as NAME.csv and the figure. Then the table, or the rows, on standard output, whose reader may be
 * gone before its end. Table and figure are used up. */
static enum thud_status deliver(const struct thud_args *args, const char *preset, struct thud_text *table,
                                const struct thud_rows *rows, const struct thud_bench *bench,
                                struct thud_figure *figure, const atomic_int *cancel, struct thud_error *err)
{
    bool json = thud_args_has(args, "json"), data = json || thud_args_has(args, "csv");
    struct thud_picture_choice picture;
    struct thud_text csv = {0};
    const char *folder = thud_args_value(args, "o");
    char name[128];
    if (data)
        thud_text_clear(table);
    if (json) {
        thud_text_append(table, "{");
        thud_json_head(table, preset);
        const struct thud_rows costs = thud_bench_cost_rows(bench);
        thud_text_append(table, ", ");
        THUD_JSON_FIELDS(table, {"moved", bench->moved});
        thud_json_list("costs", &costs, table);
        thud_json_list("rows", rows, table);
        thud_text_append(table, "}\n");
    } else if (data) {
        thud_rows_csv(rows, table);
    }
    enum thud_status status = thud_picture_options_read(args, &picture, err);
    picture.options.no_data = true; /* the table's CSV says more and has its name */
    if (!*cancel)                   /* what was done before a wish to stop is drawn */
        picture.options.cancel = cancel;
    if (status == THUD_OK && folder)
        status = thud_figure_check(figure, err);
    if (status == THUD_OK && folder) {
        snprintf(name, sizeof name, "%s.csv", figure->name);
        thud_rows_csv(rows, &csv);
        status = thud_text_save(&csv, folder, name, status, err);
    }
    if (folder)
        status = thud_figure_deliver(figure, folder, &picture.options, status, err);
    else
        thud_figure_free(figure);
    enum thud_status printed = thud_cli_print_as(args, table, THUD_OK, status == THUD_OK ? err : NULL);
    return status == THUD_OK ? printed : status;
}

/* --methods NAME,NAME: the curves of these alone. */
static enum thud_status choose_methods(struct thud_bench *bench, const char *list, struct thud_error *err)
{
    const struct thud_method *chosen[THUD_GIVEN_MAX];
    int n = 0;
    while (*list) {
        char name[64];
        size_t length = strcspn(list, ",");
        snprintf(name, sizeof name, "%.*s", (int)(length < sizeof name ? length : sizeof name - 1), list);
        const struct thud_method *method = thud_method_find(name);
        if (!method || n == THUD_GIVEN_MAX)
            return thud_error_refuse(err, THUD_USAGE, NULL, "those of `thud methods`",
                                     "--methods: there is no method \"%s\"", name);
        chosen[n++] = method;
        list += length + (list[length] == ',');
    }
    thud_bench_only(bench, chosen, n);
    return THUD_OK;
}

static enum thud_status bench(const struct thud_args *args, const struct thud_scene *scene,
                              const struct thud_record *record, const struct thud_bench_jobs *jobs,
                              struct thud_error *err)
{
    struct thud_bench *plan = NULL;
    struct thud_text table = {0};
    const char *methods = thud_args_value(args, "methods");
    enum thud_status status = thud_bench_create(scene, record, &plan, err);
    if (status == THUD_OK && methods)
        status = choose_methods(plan, methods, err);
    struct thud_bench_jobs all = *jobs;
    all.scene = scene;
    all.context = plan;
    if (status == THUD_OK)
        status = thud_bench_jobs_run(plan, &all, err);
    thud_progress_end();
    if (status == THUD_OK || (status == THUD_CANCELLED && plan)) {
        thud_bench_table(plan, &table);
        const struct thud_rows rows = thud_bench_rows(plan);
        char text[THUD_TEXT_MAX + 64];
        snprintf(text, sizeof text, "%s: speed against accuracy", scene->title);
        enum thud_status delivered =
            deliver(args, scene->name, &table, &rows, plan, thud_bench_figure(plan, text), jobs->cancel, err);
        status = delivered == THUD_OK ? status : delivered;
    }
    thud_bench_free(plan);
    return status;
}

static enum thud_status patience(const struct thud_args *args, double *out, struct thud_error *err)
{
    enum thud_status status = thud_args_quantity(args, "patience", THUD_TIME, out, err);
    if (status == THUD_OK && !(*out > 0))
        return thud_error_refuse(err, THUD_USAGE, "--patience", NULL, "\"%.40s\" is not a time to wait (more than 0 s)",
                                 thud_args_value(args, "patience"));
    return status;
}

enum thud_status thud_command_bench(const struct thud_args *args, struct thud_session *session,
                                    struct thud_scene *scene, struct thud_error *err)
{
    struct thud_bench_jobs jobs = {.patience_s = THUD_BENCH_PATIENCE_S, .cancel = thud_interrupt_watch()};
    jobs.budget_s = thud_args_has(args, "patience") ? 0 : THUD_BENCH_BUDGET_S;
    static const char *const asked[] = {"case", NULL};
    struct thud_picture_choice unused;
    struct thud_made_by by;
    if (thud_progress_start(args))
        jobs.progress = show_progress;
    enum thud_status status = thud_picture_options_read(args, &unused, err); /* wrong ones are said before the work */
    if (status == THUD_OK)
        status = patience(args, &jobs.patience_s, err);
    if (status == THUD_OK)
        status = thud_scene_options_of_case(args, session, scene, err);
    if (status == THUD_OK)
        status = thud_session_read_record(session, err);
    if (status == THUD_OK)
        status = thud_made_by_scene_file(args, "bench", session, scene, asked, &by, err);
    if (status != THUD_OK)
        return status;
    status = bench(args, scene, session->record, &jobs, err);
    return thud_made_by_finish(args, &by, status, err);
}
