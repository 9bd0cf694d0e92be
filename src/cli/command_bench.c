/* thud bench: speed against accuracy, every method. */
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/bench_jobs.h"
#include "app/figure_files.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/scene_options.h"
#include "io/file.h"

static void show_progress(void *context, const char *what, int done, int count)
{
    (void)context;
    fprintf(stderr, "\r\033[K%d of %d  %s", done, count, what);
    fflush(stderr);
}

static enum thud_status save(struct thud_bench *bench, const char *folder, const char *title, struct thud_error *err)
{
    struct thud_text text = {0};
    char path[1024];
    snprintf(path, sizeof path, "%.1000s/bench.csv", folder);
    enum thud_status status = thud_folder_make(folder, err);
    if (status != THUD_OK)
        return status;
    thud_bench_csv(bench, &text);
    status = thud_text_write(&text, path, err);
    if (status != THUD_OK)
        return status;
    return thud_figure_deliver(thud_bench_figure(bench, title), folder, NULL, THUD_OK, err);
}

static enum thud_status deliver(const struct thud_args *args, struct thud_bench *bench, const char *title,
                                struct thud_error *err)
{
    struct thud_text text = {0};
    const char *folder = thud_args_value(args, "o");
    thud_bench_table(bench, &text);
    enum thud_status status = thud_cli_print(&text, err);
    return status == THUD_OK && folder ? save(bench, folder, title, err) : status;
}

static enum thud_status bench(const struct thud_args *args, struct thud_session *session, struct thud_error *err)
{
    struct thud_bench *plan = NULL;
    struct thud_bench_jobs jobs = {.repeats = 7, .patience_s = 12, .cancel = thud_interrupt_watch()};
    if (isatty(STDERR_FILENO) && !thud_args_has(args, "quiet"))
        jobs.progress = show_progress;
    enum thud_case which;
    struct thud_scene *scene = malloc(sizeof *scene);
    enum thud_status status = scene ? thud_scene_options_case(args, &which, err) : THUD_MEMORY;
    if (status == THUD_OK) {
        *scene = session->scene;
        if (which != THUD_CASE_AS_WRITTEN)
            status = thud_scene_case(&session->scene, which, scene, err);
    }
    if (status == THUD_OK)
        status = thud_session_read_record(session, err);
    if (status == THUD_OK)
        status = thud_bench_create(scene, session->record, true, &plan, err);
    free(scene);
    if (status != THUD_OK)
        return status;
    status = thud_bench_jobs_run(plan, &jobs, err);
    if (jobs.progress)
        fputs("\r\033[K", stderr);
    if (status == THUD_OK || status == THUD_CANCELLED) {
        enum thud_status delivered = deliver(args, plan, session->scene.title, err);
        if (delivered != THUD_OK)
            status = delivered;
    }
    thud_bench_free(plan);
    return status;
}

enum thud_status thud_command_bench(const struct thud_args *args, struct thud_error *err)
{
    struct thud_session *session = calloc(1, sizeof *session);
    if (!session)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = thud_scene_options_open(args, session, err);
    if (status == THUD_OK) {
        status = bench(args, session, err);
        thud_session_close(session);
    }
    free(session);
    return status;
}
