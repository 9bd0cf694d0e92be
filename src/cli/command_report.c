/* thud report: a document about your own buildings. */
#include <stdio.h>
#include <string.h>

#include "app/report/site_report.h"
#include "app/run/record_list.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/study_output.h"
#include "io/record/target_file.h"

/* Samples of the uncertain inputs: a share of them is known to about 5 %. */
enum { SAMPLES = 100 };

/* The command as it can be typed again. */
static void put_word(struct thud_text *out, const char *word)
{
    bool plain = *word != '\0' && strspn(word, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                               "_-+=./,:%@") == strlen(word);
    if (plain) {
        thud_text_append(out, "%s", word);
        return;
    }
    thud_text_append(out, "'");
    for (; *word; word++)
        if (*word == '\'')
            thud_text_append(out, "'\\''");
        else
            thud_text_bytes(out, word, 1);
    thud_text_append(out, "'");
}

/* Whether an option does not change a report; with a suite, the list specifies its motions. */
static bool is_left_out(const char *option, bool suite)
{
    static const char *const words[] = {"o", "j", "pdf", "no-pdf", "replace", "quiet", "records"};
    const char *setting;
    for (size_t i = 0; i < sizeof words / sizeof *words - !suite; i++)
        if (strcmp(option, words[i]) == 0)
            return true;
    for (int i = 0; suite && (setting = thud_record_setting(i)) != NULL; i++)
        if (strcmp(option, setting) == 0)
            return true;
    return false;
}

/* As it makes the same report from the files that the report itself holds. */
static void put_command(const struct thud_args *args, const char *name, bool suite, struct thud_text *out)
{
    char file[THUD_NAME_MAX + 8];
    snprintf(file, sizeof file, "%s.yaml", name);
    thud_text_append(out, "thud report ");
    put_word(out, file);
    snprintf(file, sizeof file, "%s.list", name);
    if (suite) {
        thud_text_append(out, " --records ");
        put_word(out, file);
    }
    for (int i = 0; i < args->ngiven; i++) {
        const char *option = args->given[i].option->name;
        if (is_left_out(option, suite))
            continue;
        thud_text_append(out, " %s%s", option[1] ? "--" : "-", option);
        if (args->given[i].value) {
            thud_text_append(out, " ");
            put_word(out, args->given[i].value);
        }
    }
    thud_text_append(out, " -o report");
}

/* What the conclusion is compared with: the code, the design spectrum of the suite (its kind is none if there is none),
 * and limits separated by commas. */
struct criteria {
    struct thud_target target;
    struct thud_text limits;
};

static enum thud_status read_criteria(const struct thud_args *args, struct thud_session *session,
                                      struct criteria *criteria, struct thud_error *err)
{
    const char *code = thud_args_value(args, "code"), *target = thud_args_value(args, "target"), *limit;
    for (int i = 0; (limit = thud_args_repeated(args, "limit", i)) != NULL; i++)
        thud_text_append(&criteria->limits, "%s%s", i > 0 ? "," : "", limit);
    if (criteria->limits.failed)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = code ? thud_session_set(session, "document.code", code, err) : THUD_OK;
    if (!target && *session->scene.record.target)
        target = session->scene.record.target;
    if (status == THUD_OK && target && (status = thud_target_read(target, &criteria->target, err)) != THUD_OK)
        thud_args_key("target", err);
    return status;
}

enum thud_status thud_command_report(const struct thud_args *args, struct thud_session *session,
                                     struct thud_scene *scene, struct thud_error *err)
{
    struct thud_picture_choice picture;
    struct thud_inputs_choice inputs;
    struct thud_record_list records = {0};
    struct thud_text text = {0};
    struct criteria criteria = {0};
    struct thud_error no_pdf = {0};
    const char *folder = thud_args_value(args, "o");
    int threads = 0, detail = 0;
    (void)scene;
    if (!folder)
        return thud_error_refuse(err, THUD_USAGE, NULL, "-o DIR", "thud report needs a folder to write into");
    enum thud_status status = thud_picture_options_read(args, &picture, err);
    if (status == THUD_OK)
        status = thud_inputs_option_read(args, SAMPLES, &inputs, err);
    if (status == THUD_OK)
        status = thud_args_integer(args, "j", 1, THUD_JOBS_MAX, 0, &threads, err);
    if (status == THUD_OK)
        status = thud_args_integer(args, "detail", 1, 1000000, 0, &detail, err);
    if (status == THUD_OK)
        status = read_criteria(args, session, &criteria, err);
    if (status == THUD_OK)
        status = thud_records_option_read(args, session, &records, err);
    static const char *const asked[] = {"records", "signs",   "uncertain", "samples", "sampling", "seed",
                                        "beside",  "figures", "detail",    "target",  "limit",    NULL};
    struct thud_made_by by;
    if (status == THUD_OK)
        status = thud_made_by_scene(args, "report", &session->scene, (const struct thud_record *const *)records.record,
                                    records.n, asked, &by, err);
    picture.options.cancel = thud_interrupt_watch();
    put_command(args, session->scene.name, records.n > 1, &text);
    if (status == THUD_OK && text.failed)
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    struct thud_site_report_options options = {.by = &by,
                                               .command = text.data,
                                               .beside = thud_args_value(args, "beside"),
                                               .drawn = thud_args_value(args, "figures"),
                                               .threads = threads,
                                               .simplify = !thud_args_has(args, "no-simplify"),
                                               .pdf = !thud_args_has(args, "no-pdf"),
                                               .no_pdf = thud_args_has(args, "pdf") ? NULL : &no_pdf,
                                               .records = &records,
                                               .detail = detail,
                                               .limits = criteria.limits.data ? criteria.limits.data : "",
                                               .target =
                                                   criteria.target.kind == THUD_TARGET_NONE ? NULL : &criteria.target,
                                               .inputs = &inputs.inputs,
                                               .samples = inputs.samples,
                                               .sampling = inputs.sampling,
                                               .seed = inputs.seed,
                                               .pictures = &picture.options,
                                               .progress = thud_progress_start(args) ? thud_progress_what : NULL};
    if (status == THUD_OK)
        status = thud_site_report(session, &options, err);
    thud_record_list_clear(&records);
    thud_text_clear(&criteria.limits);
    thud_text_clear(&text);
    thud_progress_end();
    if (status != THUD_OK)
        return status;
    thud_text_append(&text, "%s/report.html\n%s/report.md\n", folder, folder);
    if (no_pdf.what[0] && !thud_args_has(args, "quiet"))
        thud_cli_warn(&no_pdf);
    if (options.pdf && !no_pdf.what[0])
        thud_text_append(&text, "%s/report.pdf\n", folder);
    return thud_cli_print_files(args, &text, err);
}
