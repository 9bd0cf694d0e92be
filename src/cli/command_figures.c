/* thud figures: the paper's figures, and with `all` the report. */
#include <stdio.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "io/file/made_by.h"
#include "io/result/schemas.h"
#include "lab/paper/paper_report.h"

static enum thud_status make_study(const struct thud_args *args, bool report, struct thud_paper_work **work,
                                   struct thud_paper_study *study, struct thud_error *err)
{
    struct thud_paper_request request = {.records = thud_args_value(args, "records"),
                                         .peak = thud_args_value(args, "peak"),
                                         .dt = thud_args_value(args, "dt"),
                                         .unit = thud_args_value(args, "unit"),
                                         .both_signs = report,
                                         .cancel = thud_interrupt_watch()};
    enum thud_status status = thud_args_integer(args, "j", 1, THUD_JOBS_MAX, 0, &request.threads, err);
    if (thud_progress_start(args))
        request.progress = thud_progress_points;
    if (status == THUD_OK)
        status = thud_paper_work_make(&request, work, study, err);
    thud_progress_end();
    return status;
}

/* Options of ground motions have no effect without --records: the surrogates have their own. */
static enum thud_status check_records(const struct thud_args *args, struct thud_error *err)
{
    static const char *const of_records[] = {"peak", "dt", "unit"};
    for (size_t i = 0; i < sizeof of_records / sizeof *of_records && !thud_args_has(args, "records"); i++)
        if (thud_args_has(args, of_records[i])) {
            thud_error_set(err, THUD_USAGE, "applies to the files of --records, and there are none");
            return thud_args_wrong(of_records[i], err);
        }
    return THUD_OK;
}

/* What was written, one file a line. */
static enum thud_status list_files(const struct thud_args *args, unsigned which, const char *folder,
                                   const struct thud_picture_options *options, struct thud_error *err)
{
    struct thud_text text = {0};
    for (int i = 0; i < THUD_PAPER_FIGURES; i++) {
        if (which >> i & 1u)
            thud_text_append(&text, "%s/%s.%s\n", folder, thud_paper_figure_name(i),
                             thud_picture_suffix(options->format));
    }
    if (which & THUD_PAPER_REPORT)
        thud_text_append(&text, "%s/report.html\n%s/report.md\n%s/study.json\n", folder, folder, folder);
    return thud_cli_print_files(args, &text, err);
}

/* Beside figures that are there already, whichever they are. */
static enum thud_status save(unsigned which, const struct thud_paper_study *study, const char *folder,
                             const struct thud_picture_options *options, bool replace, struct thud_error *err)
{
    const unsigned long long paper = thud_hash_text(THUD_HASH_START, "figures");
    const struct thud_made_by by = {folder, "figures", "figures of the paper", paper, paper, replace, thud_schema_at};
    enum thud_status status = thud_made_by_begin(&by, err);
    if (status != THUD_OK)
        return status;
    return thud_made_by_end(&by, thud_paper_figures_save(which, study, folder, options, err), err);
}

enum thud_status thud_command_figures(const struct thud_args *args, struct thud_error *err)
{
    struct thud_picture_choice picture;
    struct thud_paper_work *work = NULL;
    struct thud_paper_study study = {0};
    unsigned which = 0;
    const char *folder = thud_args_value(args, "o");
    if (!folder)
        folder = "figures";
    enum thud_status status = thud_paper_figures_parse(args->noperands, args->operand, &which, err);
    if (status == THUD_OK)
        status = thud_picture_options_read(args, &picture, err);
    picture.options.cancel = thud_interrupt_watch();
    if (status == THUD_OK)
        status = check_records(args, err);
    if (status == THUD_OK && thud_paper_needs_study(which))
        status = make_study(args, (which & THUD_PAPER_REPORT) != 0, &work, &study, err);
    if (status == THUD_OK && work && study.unanswered > 0)
        fprintf(stderr, "thud: %d runs have no result, because their integration failed; the curves have gaps there\n",
                study.unanswered);
    if (status == THUD_OK)
        status = save(which, work ? &study : NULL, folder, &picture.options, thud_args_has(args, "replace"), err);
    thud_paper_work_free(work);
    if (status == THUD_OK && (!thud_args_has(args, "quiet") || thud_args_has(args, "json")))
        status = list_files(args, which, folder, &picture.options, err);
    return status;
}
