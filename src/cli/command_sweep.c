/* thud sweep and thud fragility: parametric studies. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/figure_files.h"
#include "app/sweep/fragility_report.h"
#include "app/sweep/sweep_report.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/study_output.h"
#include "io/file/file.h"
#include "study/sweep/remark.h"

struct sweep {
    const struct thud_args *args;
    struct thud_session session;
    struct thud_record_list records;
    struct thud_sweep_plan plan;
    struct thud_sweep_study study;
    struct thud_made_by by;
    struct thud_sweep_outcome outcome;
    struct thud_sweep_output output;
    struct thud_picture_choice pictures;
    char *preset;
    struct thud_text description; /* study.json */
    int best;                     /* axis, -1: not asked for */
    bool fragility;               /* the output is the fragility, not the rows */
    struct thud_suite *suite;     /* of several ground motions, or for the fragility */
    struct thud_fragility_study events;
    struct thud_text told;     /* of the fragility */
    enum thud_status pictured; /* THUD_OK, or what failed with its pictures */
    struct thud_error picture_error;
};

static enum thud_status choose_shortcuts(struct sweep *s, struct thud_error *err)
{
    static const struct {
        const char *name;
        unsigned bit;
    } shortcut[] = {{"free", THUD_SWEEP_FREE},
                    {"start", THUD_SWEEP_START},
                    {"levels", THUD_SWEEP_LEVELS},
                    {"same", THUD_SWEEP_SAME},
                    {"all", THUD_SWEEP_ALL}};
    const char *word;
    for (int i = 0; (word = thud_args_repeated(s->args, "without", i)) != NULL; i++) {
        unsigned bit = 0;
        for (size_t k = 0; k < sizeof shortcut / sizeof *shortcut; k++)
            if (strcmp(word, shortcut[k].name) == 0)
                bit = shortcut[k].bit;
        if (!bit)
            return thud_error_refuse(err, THUD_USAGE, "--without", "free, start, levels, same, all",
                                     "\"%.40s\" is not a shortcut", word);
        s->plan.shortcuts &= ~bit;
    }
    return THUD_OK;
}

static enum thud_status fill_plan(struct sweep *s, struct thud_error *err)
{
    const char *cases = thud_args_value(s->args, "cases"), *vary;
    bool own_axes = !thud_args_has(s->args, "vary"), own_cases = !cases && !thud_args_has(s->args, "case");
    thud_sweep_plan_init(&s->plan, &s->session.scene);
    s->plan.record = (const struct thud_record *const *)s->records.record;
    s->plan.nrecords = s->records.n;
    enum thud_status status = THUD_OK;
    bool suite = !s->fragility && (s->records.n > 1 || thud_args_has(s->args, "records")); /* is a study on its own */
    if (own_axes && s->session.scene.study.nvary == 0 && !suite) {
        thud_error_set(err, THUD_USAGE, "the preset has no study of its own");
        thud_error_allow(err, s->fragility ? "--vary KEY=FROM:TO:STEP, e.g. --vary record.sa=0.1g:2g:0.1g"
                                           : "--vary KEY=FROM:TO:STEP, e.g. --vary gap=5cm:25cm:0.5cm, or a suite of "
                                             "ground motions: --records DIR");
        return THUD_USAGE;
    }
    for (int i = 0; status == THUD_OK && (vary = thud_args_repeated(s->args, "vary", i)) != NULL; i++)
        status = thud_sweep_vary(&s->plan, vary, err);
    if (status == THUD_OK)
        status = thud_sweep_study(&s->plan, own_axes, own_cases, err);
    if (thud_args_has(s->args, "sensitivity"))
        s->plan.sensitivity = thud_scene_options_change(s->args, &s->session.scene);
    if (status == THUD_OK && !own_cases)
        status = thud_sweep_cases(&s->plan, cases ? cases : thud_args_value(s->args, "case"), err);
    return status == THUD_OK ? choose_shortcuts(s, err) : status;
}

static enum thud_status find_best(struct sweep *s, struct thud_error *err)
{
    const char *key = thud_args_value(s->args, "best");
    s->best = -1;
    for (int i = 0; key && i < s->plan.naxes; i++)
        if (strcmp(s->plan.axis[i].key, key) == 0)
            s->best = i;
    if (!key || s->best >= 0)
        return THUD_OK;
    return thud_error_refuse(err, THUD_USAGE, "--best", "one of the keys of --vary", "\"%.60s\" is not varied", key);
}

/* Before the runs: what they will cost, and what the study does not change although a reader may think so. After them:
 * what they show that no building bears. */
static struct thud_remark_scope remark_scope(const struct sweep *s)
{
    return (struct thud_remark_scope){.scene = &s->plan.scene,
                                      .before = s->session.preset ? thud_preset_scene(s->session.preset) : NULL,
                                      .record = s->plan.record,
                                      .nrecords = s->plan.nrecords,
                                      .plan = &s->plan,
                                      .watch = &s->outcome.watch};
}

/* Computes the fragility from the suite and writes its files. A failure of gnuplot is reported last: all else is
 * there. */
static enum thud_status tell_fragility(void *owner, struct thud_error *err)
{
    struct sweep *s = owner;
    const struct thud_remark_scope scope = remark_scope(s);
    s->events.scope = &scope;
    s->pictured = thud_fragility_deliver(s->args, &s->events, s->study.folder, s->study.pictures, &s->told, err);
    s->picture_error = err ? *err : s->picture_error;
    return s->pictured == THUD_GNUPLOT ? THUD_OK : s->pictured;
}

static enum thud_status write_suite(void *owner, struct thud_error *err)
{
    struct sweep *s = owner;
    struct thud_text text = {0};
    struct thud_figure *figure = s->study.figures ? thud_suite_lowered_figure(s->suite) : NULL;
    enum thud_status status = thud_suite_report(s->suite, THUD_AS_CSV, &text, err);
    status = thud_text_save(&text, s->study.folder, "suite.csv", status, err);
    if (status == THUD_OK && figure)
        s->outcome.pictures = thud_figure_deliver(figure, s->study.folder, s->study.pictures, s->outcome.pictures,
                                                  &s->outcome.picture_error);
    else
        thud_figure_free(figure);
    return status;
}

static enum thud_status fill_study(struct sweep *s, struct thud_error *err)
{
    const struct thud_args *args = s->args;
    struct thud_sweep_study *study = &s->study;
    study->plan = &s->plan;
    study->preset = s->preset;
    study->description = &s->description;
    study->folder = thud_args_value(args, "o");
    study->shard = (struct thud_sweep_shard){1, 1};
    study->figures = true;
    study->cancel = thud_interrupt_watch();
    study->context = &s->output;
    study->emit = thud_sweep_output_point;
    if (thud_progress_start(args))
        study->progress = thud_progress_points;
    s->output.plan = &s->plan;
    s->output.format = thud_args_has(args, "json")  ? THUD_SWEEP_OUTPUT_JSON
                       : thud_args_has(args, "csv") ? THUD_SWEEP_OUTPUT_CSV
                                                    : THUD_SWEEP_OUTPUT_TABLE;
    enum thud_status status = thud_args_integer(args, "j", 1, THUD_JOBS_MAX, 0, &study->threads, err);
    const char *shard = thud_args_value(args, "shard");
    if (status == THUD_OK && shard)
        status = thud_sweep_shard_parse(shard, &study->shard, err);
    if (status == THUD_OK && (shard || thud_args_has(args, "merge")) && !study->folder)
        status = thud_error_set(err, THUD_USAGE, "%s needs a folder: -o DIR", shard ? "--shard" : "--merge");
    if (status == THUD_OK)
        status = thud_picture_options_read(args, &s->pictures, err);
    s->pictures.options.cancel = study->cancel;
    thud_picture_options_motions(&s->pictures, s->plan.record, s->plan.nrecords);
    study->pictures = &s->pictures.options;
    if (status == THUD_OK && study->folder) {
        status = thud_made_by_study(args, &s->plan, &s->by, err);
        study->by = &s->by;
    }
    if (status == THUD_OK)
        status = find_best(s, err);
    study->no_rows = s->fragility;
    if (status == THUD_OK && s->fragility)
        status = thud_fragility_options_read(args, &s->plan, &s->events, err);
    if (status == THUD_OK && study->shard.count == 1 && (s->fragility || s->plan.nrecords > 1))
        status = thud_suite_create(&s->plan, &s->suite, err);
    s->events.suite = study->suite = s->suite;
    s->output.suite = s->fragility ? NULL : s->suite;
    study->owner = s;
    study->conclude = s->fragility ? tell_fragility : s->suite ? write_suite : NULL;
    if (s->fragility) {
        study->emit = NULL;
        study->figures = false;
        return status;
    }
    study->table = study->folder || s->output.format == THUD_SWEEP_OUTPUT_TABLE || s->best >= 0;
    return status;
}

static enum thud_status put_best(struct sweep *s, struct thud_text *text, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    if (s->best < 0)
        return status;
    if (s->outcome.too_many)
        return thud_error_set(err, THUD_USAGE, "the study has too many rows to look for the best value");
    if (s->study.folder) {
        struct thud_text csv = {0};
        status = thud_sweep_report_best(&s->plan, &s->outcome.rows.table, s->best, true, &csv, err);
        status = thud_text_save(&csv, s->study.folder, "best.csv", status, err);
        status = thud_made_by_end(&s->by, status, err);
    }
    if (status == THUD_OK && s->output.format == THUD_SWEEP_OUTPUT_TABLE)
        status = thud_sweep_report_best(&s->plan, &s->outcome.rows.table, s->best, false, text, err);
    return status;
}

static void tell_remarks(const struct sweep *s, unsigned about)
{
    const struct thud_remark_scope scope = remark_scope(s);
    thud_cli_remarks(s->args, &scope, about);
}

static enum thud_status check_possible(const struct thud_sweep_total *total, struct thud_error *err)
{
    return total->impossible > 0 && total->impossible == total->asked
               ? thud_error_set(err, THUD_INPUT, "none of the runs is possible")
               : THUD_OK;
}

/* What is said at the end: the table on standard output, or only the work on standard error where rows are there. */
static enum thud_status conclude(struct sweep *s, struct thud_error *err)
{
    const struct thud_sweep_total *total = &s->outcome.total;
    struct thud_text text = {0};
    bool table = s->output.format == THUD_SWEEP_OUTPUT_TABLE, quiet = thud_args_has(s->args, "quiet");
    const struct thud_remark_scope scope = remark_scope(s);
    enum thud_status status = thud_sweep_output_end(&s->output, &scope, err);
    tell_remarks(s, THUD_REMARK_STUDY);
    if (table && status == THUD_OK && s->suite) { /* the result of a suite, before those of its motions */
        status = thud_suite_report(s->suite, THUD_AS_TEXT, &text, err);
        if (status == THUD_OK)
            status = thud_suite_lowered(s->suite, &text, err);
        thud_text_append(&text, "\n");
    }
    if (table)
        thud_sweep_report(&s->plan, &s->outcome, &text);
    if (status == THUD_OK)
        status = put_best(s, &text, err);
    if (!quiet || total->impossible > 0 || total->diverged > 0) {
        if (table && text.size > 0)
            thud_text_append(&text, "\n");
        thud_sweep_report_work(&s->plan, total, &text);
    }
    if (s->outcome.too_many)
        thud_text_append(&text, "more than %d rows: no figures, no table\n", THUD_SWEEP_ROWS_MAX);
    if (table && status == THUD_OK)
        status = thud_cli_print(&text, err);
    else if (text.data && thud_text_shown(text.data, "\n\t"))
        fputs(text.data, stderr);
    thud_text_clear(&text);
    if (status == THUD_OK && s->outcome.pictures != THUD_OK) {
        *err = s->outcome.picture_error;
        status = s->outcome.pictures;
    }
    if (status == THUD_OK && total->diverged > 0)
        status = thud_error_set(err, THUD_DIVERGED, "%ld of %ld runs have no result", total->diverged, total->asked);
    return status == THUD_OK ? check_possible(total, err) : status;
}

/* The status of the output; then that of the runs. */
static enum thud_status conclude_fragility(struct sweep *s, struct thud_error *err)
{
    struct thud_text work = {0};
    enum thud_status status = s->study.folder ? THUD_OK : tell_fragility(s, err);
    if (status == THUD_OK)
        status = thud_cli_print(&s->told, err);
    tell_remarks(s, THUD_REMARK_STUDY);
    if (!thud_args_has(s->args, "quiet") || s->outcome.total.impossible > 0)
        thud_sweep_report_work(&s->plan, &s->outcome.total, &work);
    if (work.data)
        fputs(work.data, stderr);
    thud_text_clear(&work);
    if (status == THUD_OK && s->pictured != THUD_OK) {
        *err = s->picture_error;
        status = s->pictured;
    }
    return status == THUD_OK ? check_possible(&s->outcome.total, err) : status;
}

static enum thud_status finish(struct sweep *s, enum thud_status status, struct thud_error *err)
{
    const struct thud_remark_scope scope = remark_scope(s);
    thud_progress_end();
    if (s->study.shard.count > 1 && status == THUD_OK) {
        if (!thud_args_has(s->args, "quiet"))
            fprintf(stderr, "part %d of %d is whole: thud %s --merge DIR... -o DIR joins the parts\n",
                    s->study.shard.index, s->study.shard.count, thud_command_at(s->args->command)->name);
        return status;
    }
    if (status == THUD_CANCELLED && s->output.begun)
        (void)thud_sweep_output_end(&s->output, &scope, NULL); /* what is done is printed */
    if (status == THUD_OK && s->fragility)
        return conclude_fragility(s, err);
    return status == THUD_OK ? conclude(s, err) : status;
}

/* The scene for the journal, which names the ground motions itself: a name that no preset takes is left out. */
static enum thud_status journal_preset(struct sweep *s, struct thud_error *err)
{
    struct thud_scene *scene = &s->session.scene;
    struct thud_record_choice choice = scene->record;
    unsigned long size;
    for (const char *c = choice.file; *c; c++)
        if ((unsigned char)*c < ' ')
            scene->record.file[0] = '\0';
    enum thud_status status = thud_preset_text(s->session.preset, scene, &s->preset, &size, err);
    scene->record = choice;
    return status;
}

static enum thud_status make(struct sweep *s, struct thud_error *err)
{
    enum thud_status status = thud_scene_options_open(s->args, &s->session, err);
    if (status != THUD_OK)
        return status;
    status = thud_records_option_read(s->args, &s->session, &s->records, err);
    if (status == THUD_OK)
        status = fill_plan(s, err);
    if (status == THUD_OK && thud_args_has(s->args, "o"))
        status = journal_preset(s, err);
    if (status == THUD_OK && thud_args_has(s->args, "o"))
        thud_study_file_json(s->args, &s->session, &s->plan, &s->description);
    if (status == THUD_OK)
        status = fill_study(s, err);
    if (status == THUD_OK)
        tell_remarks(s, THUD_REMARK_EFFORT | THUD_REMARK_CHANGE);
    if (status == THUD_OK)
        status = finish(s, thud_sweep_study_run(&s->study, &s->outcome, err), err);
    thud_sweep_outcome_clear(&s->outcome);
    thud_sweep_plan_clear(&s->plan);
    thud_record_list_clear(&s->records);
    thud_session_close(&s->session);
    free(s->preset);
    return status;
}

static enum thud_status merge(struct sweep *s, struct thud_error *err)
{
    struct thud_sweep_parts *parts;
    if (s->args->noperands == 0)
        return thud_error_set(err, THUD_USAGE, "thud %s --merge needs the folders of the parts",
                              thud_command_at(s->args->command)->name);
    enum thud_status status = thud_sweep_parts_plan(s->args->operand[0], &parts, err);
    if (status != THUD_OK)
        return status;
    s->plan = parts->plan;
    status = fill_study(s, err);
    if (status == THUD_OK)
        status =
            finish(s, thud_sweep_study_merge(&s->study, s->args->operand, s->args->noperands, &s->outcome, err), err);
    thud_sweep_outcome_clear(&s->outcome);
    thud_sweep_parts_free(parts);
    return status;
}

static enum thud_status study(const struct thud_args *args, bool fragility, struct thud_error *err)
{
    struct sweep *s = calloc(1, sizeof *s);
    if (!s)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    s->args = args;
    s->fragility = fragility;
    enum thud_status status = thud_args_has(args, "merge") ? merge(s, err) : make(s, err);
    thud_fragility_study_clear(&s->events);
    thud_text_clear(&s->told);
    thud_suite_free(s->suite);
    thud_text_clear(&s->output.text);
    thud_text_clear(&s->description);
    free(s);
    return status;
}

enum thud_status thud_command_sweep(const struct thud_args *args, struct thud_error *err)
{
    return study(args, false, err);
}

enum thud_status thud_command_fragility(const struct thud_args *args, struct thud_error *err)
{
    return study(args, true, err);
}
