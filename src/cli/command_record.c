/* thud record: info, spectrum, convert (or import), list, synthesize. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/figure_files.h"
#include "app/run/record_list.h"
#include "app/run/session.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "ground/identity.h"
#include "io/file/file.h"
#include "io/file/made_by.h"
#include "io/file/paths.h"
#include "io/record/record_write.h"
#include "io/result/list_rows.h"
#include "io/result/schemas.h"

/* To the file of -o, else to standard output. */
static enum thud_status deliver(const struct thud_args *args, struct thud_text *text, struct thud_error *err)
{
    const char *path = thud_args_value(args, "o");
    return path && strcmp(path, "-") != 0 ? thud_text_write(text, path, err) : thud_text_print(text, err);
}

static enum thud_status need_files(const struct thud_args *args, const char *verb, int most, struct thud_error *err)
{
    int files = args->noperands - 1;
    if (files >= 1 && files <= most)
        return THUD_OK;
    thud_error_set(err, THUD_USAGE, files < 1 ? "thud record %s needs a file" : "thud record %s takes one file", verb);
    return THUD_USAGE;
}

static enum thud_status draw(const struct thud_args *args, const struct thud_record *record, struct thud_figure *figure,
                             struct thud_error *err)
{
    struct thud_picture_choice picture;
    enum thud_status status = thud_picture_options_read(args, &picture, err);
    if (status) {
        thud_figure_free(figure);
        return status;
    }
    thud_picture_options_motions(&picture, &record, 1);
    const struct thud_made_by by = {
        .folder = thud_args_value(args, "o"), "record", "ground motions", .schema = thud_schema_at};
    status = thud_made_by_begin(&by, err);
    if (status) {
        thud_figure_free(figure);
        return status;
    }
    return thud_made_by_end(&by, thud_figure_deliver(figure, by.folder, &picture.options, THUD_OK, err), err);
}

static enum thud_status info_of(const struct thud_args *args, const struct thud_record *record, struct thud_list *list,
                                struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    struct thud_motion_info_row row;
    thud_motion_info_fill(record, &row);
    if (thud_cli_form(args))
        thud_list_add(list, &row, NULL, 0);
    else
        thud_record_info_table(record, &row, list->out);
    if (thud_args_has(args, "o")) {
        char stem[128], name[160], title[640];
        thud_record_file_stem(record->file, stem, sizeof stem);
        snprintf(name, sizeof name, "%s-motion", stem);
        thud_record_title(record, title, sizeof title);
        status = draw(args, record, thud_figure_of_motion(record, name, title), err);
    }
    return status;
}

static enum thud_status info(const struct thud_args *args, struct thud_error *err)
{
    struct thud_record_treatment treatment;
    struct thud_text text = {0};
    bool undrawn = false;
    enum thud_status status = need_files(args, "info", THUD_OPERANDS_MAX, err);
    struct thud_list list = {&text, &thud_motion_info_schema, NULL, thud_cli_form(args) == THUD_AS_JSON, 0};
    if (thud_cli_form(args))
        thud_list_begin(&list, "records");
    if (!status)
        status = thud_record_options_read(args, &treatment, err);
    for (int i = 1; i < args->noperands && !status; i++) {
        struct thud_record_list motions;
        status = thud_record_list_open(args->operand[i], &treatment, &motions, err);
        for (int k = 0; k < motions.n && !status; k++) {
            status = info_of(args, motions.record[k], &list, err);
            undrawn = undrawn || status == THUD_GNUPLOT; /* scripts and data are there */
            status = status == THUD_GNUPLOT ? THUD_OK : status;
        }
        thud_record_list_clear(&motions);
    }
    if (thud_cli_form(args))
        thud_list_end(&list);
    return thud_cli_print_as(args, &text, undrawn && !status ? THUD_GNUPLOT : status, err);
}

/* The first periods of --preset's structures; none without it. */
static enum thud_status marks_of(const struct thud_args *args, struct thud_period_mark *mark, int *count,
                                 struct thud_error *err)
{
    const char *preset = thud_args_value(args, "preset");
    *count = 0;
    if (!preset)
        return THUD_OK;
    struct thud_session *session = calloc(1, sizeof *session);
    if (!session)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = thud_session_open(session, preset, err);
    if (!status)
        status = thud_scene_periods(&session->scene, mark, THUD_STRUCTURES_MAX, count, err);
    thud_session_close(session);
    free(session);
    return status;
}

static enum thud_status spectrum_of(const struct thud_args *args, const struct thud_record *record,
                                    const struct thud_spectrum_choice *choice, struct thud_spectrum_point *point,
                                    struct thud_list *list, struct thud_error *err)
{
    struct thud_period_mark mark[THUD_STRUCTURES_MAX];
    int nmarks;
    size_t count = (size_t)choice->count;
    enum thud_status status = marks_of(args, mark, &nmarks, err);
    if (status)
        return status;
    thud_spectrum_fill(record, choice->damping, choice->from_s, choice->to_s, count, point);
    const struct thud_spectrum_row row = {record->file, choice->damping};
    const struct thud_nested points = {"points", thud_spectrum_rows(point, count)};
    if (list->schema)
        thud_list_add(list, &row, &points, 1);
    else
        thud_spectrum_csv(record, point, count, choice->damping, list->out);
    if (thud_args_has(args, "o")) {
        char stem[128], name[160], title[640];
        thud_record_file_stem(record->file, stem, sizeof stem);
        snprintf(name, sizeof name, "%s-spectrum", stem);
        thud_record_title(record, title, sizeof title);
        status =
            draw(args, record, thud_figure_of_spectrum(point, count, choice->damping, mark, nmarks, name, title), err);
    }
    return status;
}

static enum thud_status spectrum(const struct thud_args *args, struct thud_error *err)
{
    struct thud_record_treatment treatment;
    struct thud_spectrum_choice choice = {.damping = 0.05, .from_s = 0.02, .to_s = 10, .count = 200};
    struct thud_record_list motions;
    struct thud_text text = {0};
    enum thud_status status = need_files(args, "spectrum", 1, err);
    if (!status)
        status = thud_record_options_read(args, &treatment, err);
    if (!status)
        status = thud_spectrum_options_read(args, "damping", &choice, err);
    if (!status)
        status = thud_record_list_open(args->operand[1], &treatment, &motions, err);
    if (status)
        return status;
    bool json = thud_args_has(args, "json"), rows = json || thud_record_is_list(args->operand[1]);
    struct thud_list list = {&text, rows ? &thud_spectrum_schema : NULL, &thud_spectrum_point_schema, json, 0};
    if (rows)
        thud_list_begin(&list, "spectra");
    struct thud_spectrum_point *point = malloc((size_t)choice.count * sizeof *point);
    if (!point)
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int k = 0; k < motions.n && !status; k++)
        status = spectrum_of(args, motions.record[k], &choice, point, &list, err);
    if (rows)
        thud_list_end(&list);
    free(point);
    thud_record_list_clear(&motions);
    return thud_cli_print_as(args, &text, status, err);
}

static enum thud_status convert(const struct thud_args *args, struct thud_error *err)
{
    struct thud_record_treatment treatment;
    struct thud_record *record = NULL;
    struct thud_text text = {0}, comment = {0};
    enum thud_status status = need_files(args, args->operand[0], 1, err);
    if (!status)
        status = thud_record_options_read(args, &treatment, err);
    if (!status)
        status = thud_record_open(args->operand[1], &treatment, &record, err);
    const char *to = thud_args_value(args, "o");
    if (!status && to && thud_file_is_same(record->file, to)) {
        status = thud_error_set(err, THUD_USAGE, "that is the ground motion that is read, and it would be lost");
        thud_error_key(err, "-o");
        thud_error_allow(err, "another file");
    }
    if (status) {
        thud_record_free(record);
        return status;
    }
    thud_text_append(&comment, "from %s, %s\n", thud_path_name(record->file), record->format);
    thud_record_treatment_describe(&treatment, record->dt_s, &comment);
    if (comment.failed)
        text.failed = 1;
    else
        thud_record_csv(record, comment.data, &text);
    thud_text_clear(&comment);
    thud_record_free(record);
    return deliver(args, &text, err);
}

static enum thud_status list(const struct thud_args *args, struct thud_error *err)
{
    struct thud_text text = {0};
    struct thud_paths paths;
    thud_paths_find(&paths);
    if (args->noperands > 2)
        return thud_error_set(err, THUD_USAGE, "thud record list takes one folder or list");
    const char *name = args->noperands > 1 ? args->operand[1] : paths.records;
    struct thud_record_list motions;
    enum thud_status status;
    if (!thud_record_is_list(name)) {
        status = thud_record_list(name, thud_cli_form(args), &text, err);
    } else {
        struct thud_record_treatment treatment;
        thud_record_treatment_init(&treatment);
        status = thud_record_list_open(name, &treatment, &motions, err);
        if (!status)
            thud_record_rows(name, motions.record, motions.n, thud_cli_form(args), &text);
        thud_record_list_clear(&motions);
    }
    return thud_cli_print_as(args, &text, status, err);
}

static enum thud_status synthesize(const struct thud_args *args, struct thud_error *err)
{
    struct thud_synthesis synthesis;
    struct thud_text text = {0};
    const char *title;
    if (args->noperands > 1)
        return thud_error_set(err, THUD_USAGE, "thud record synthesize takes no file: -o says where to write");
    enum thud_status status = thud_synthesis_options_read(args, &synthesis, &title, err);
    if (!status)
        status = thud_surrogate_csv(&synthesis, title ? title : "", &text, err);
    if (status) {
        thud_text_clear(&text);
        return status;
    }
    return deliver(args, &text, err);
}

enum { INFO = 1, SPECTRUM = 2, CONVERT = 4, LIST = 8, SYNTHESIZE = 16 };

/* An option that the verb has no use for is refused. Those not named here are about how a file is read. */
static enum thud_status check_options(const struct thud_args *args, unsigned verb, struct thud_error *err)
{
    static const struct {
        const char *option;
        unsigned verbs;
    } own[] = {{"set", SYNTHESIZE},
               {"damping", SPECTRUM},
               {"periods", SPECTRUM},
               {"preset", SPECTRUM},
               {"format", INFO | SPECTRUM},
               {"json", INFO | SPECTRUM | LIST},
               {"csv", INFO | SPECTRUM | LIST},
               {"o", ~(unsigned)LIST},
               {"peak", ~(unsigned)LIST},
               {"dt", ~(unsigned)LIST}};
    for (int i = 0; i < args->ngiven; i++) {
        const char *name = args->given[i].option->name;
        unsigned verbs = INFO | SPECTRUM | CONVERT;
        for (size_t k = 0; k < sizeof own / sizeof *own; k++)
            if (strcmp(own[k].option, name) == 0)
                verbs = own[k].verbs;
        if (verbs & verb)
            continue;
        thud_error_set(err, THUD_USAGE, "thud record %s has no use for it", args->operand[0]);
        return thud_args_wrong(name, err);
    }
    return THUD_OK;
}

enum thud_status thud_command_record(const struct thud_args *args, struct thud_error *err)
{
    static const struct {
        const char *verb;
        enum thud_status (*run)(const struct thud_args *args, struct thud_error *err);
        unsigned bit;
    } verbs[] = {{"info", info, INFO},          {"spectrum", spectrum, SPECTRUM},
                 {"convert", convert, CONVERT}, {"import", convert, CONVERT},
                 {"list", list, LIST},          {"synthesize", synthesize, SYNTHESIZE}};
    for (size_t i = 0; i < sizeof verbs / sizeof *verbs && args->noperands > 0; i++)
        if (strcmp(args->operand[0], verbs[i].verb) == 0) {
            enum thud_status status = check_options(args, verbs[i].bit, err);
            return status == THUD_OK ? verbs[i].run(args, err) : status;
        }
    if (args->noperands == 0)
        thud_error_set(err, THUD_USAGE, "thud record needs a verb");
    else
        thud_error_set(err, THUD_USAGE, "thud record has no verb \"%.40s\"", args->operand[0]);
    thud_error_allow(err, "info, spectrum, convert, import, list, synthesize");
    return THUD_USAGE;
}
