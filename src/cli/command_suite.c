/* thud suite: ground motions looked at, selected and scaled to a design spectrum. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/figure_files.h"
#include "app/run/record_verbs.h"
#include "app/sweep/suite_study.h"
#include "base/quantity.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "ground/identity.h"
#include "io/file/file.h"
#include "io/file/made_by.h"
#include "io/record/target_file.h"
#include "io/result/schemas.h"

/* The range of the buildings: 0.2 of the least to twice the largest first period. */
static void range_of_buildings(struct thud_suite_study *study)
{
    double least = study->mark[0].period_s, most = least;
    for (int i = 1; i < study->nmarks; i++) {
        least = study->mark[i].period_s < least ? study->mark[i].period_s : least;
        most = study->mark[i].period_s > most ? study->mark[i].period_s : most;
    }
    study->scaling.from_s = 0.2 * least;
    study->scaling.to_s = 2 * most;
}

static enum thud_status read_options(const struct thud_args *args, struct thud_suite_study *study,
                                     struct thud_error *err)
{
    static const enum thud_dimension times[] = {THUD_TIME, THUD_TIME};
    const char *target = thud_args_value(args, "target"), *range = thud_args_value(args, "range");
    double ends[] = {study->scaling.from_s, study->scaling.to_s};
    int common = 0;
    enum thud_status status = target ? thud_target_read(target, &study->target, err) : THUD_OK;
    if (status != THUD_OK) {
        thud_args_key("target", err);
        return status;
    }
    study->has_target = target != NULL;
    status = thud_args_choice(args, "scale", &common, err);
    study->scaling.common = common;
    study->scaling.vertical = thud_args_has(args, "vertical");
    if (status == THUD_OK)
        status = thud_args_integer(args, "count", 1, 1000, 0, &study->scaling.count, err);
    if (status == THUD_OK)
        status =
            thud_args_integer(args, "per-event", 1, 1000, study->scaling.per_event, &study->scaling.per_event, err);
    if (status == THUD_OK)
        status = thud_args_quantity(args, "factor-most", THUD_NUMBER, &study->scaling.factor_most, err);
    if (status == THUD_OK && !(study->scaling.factor_most >= 1))
        status = thud_args_refuse("factor-most", thud_args_value(args, "factor-most"), "a number of 1 or more", err);
    if (status == THUD_OK && range)
        status = thud_args_quantities("range", range, ':', times, 2, ends, "FROM:TO, such as 0.1s:2s", err);
    study->scaling.from_s = ends[0];
    study->scaling.to_s = ends[1];
    if (status == THUD_OK && !target && (thud_args_has(args, "scale") || study->scaling.count > 0))
        return thud_error_refuse(err, THUD_USAGE, "--target", THUD_TARGET_ALLOWED,
                                 "there is no target to select and scale by");
    return status;
}

/* What stands before names of files in a list at `path`. */
static void from_list(const char *path, char *from, size_t size)
{
    from[0] = '\0';
    char folder[4096];
    if (strchr(path, '/') && realpath(".", folder) && strlen(folder) + 2 < size)
        snprintf(from, size, "%s/", folder);
}

static enum thud_status save_list(const struct thud_suite_study *study, const char *path, struct thud_error *err)
{
    char from[4100], folder[1024] = ".";
    const char *name = thud_path_name(path);
    struct thud_text text = {0};
    if (name > path)
        snprintf(folder, sizeof folder, "%.*s", (int)(name - path > 1 ? name - path - 1 : 1), path);
    from_list(path, from, sizeof from);
    enum thud_status status = thud_suite_list_text(study, from, &text, err);
    return thud_text_save(&text, folder, name, status, err);
}

static enum thud_status save(const struct thud_suite_study *study, const char *where,
                             struct thud_picture_choice *picture, struct thud_error *err)
{
    const char *suffix = strrchr(where, '.');
    char list[1024];
    struct thud_text text = {0};
    if (suffix && strcmp(suffix, ".list") == 0)
        return save_list(study, where, err);
    const struct thud_made_by by = {.folder = where, "suite", "a suite of ground motions", .schema = thud_schema_at};
    snprintf(list, sizeof list, "%.1000s/suite.list", where);
    enum thud_status status = thud_made_by_begin(&by, err);
    if (status == THUD_OK)
        status = save_list(study, list, err);
    thud_suite_motions_csv(study, &text);
    status = thud_text_save(&text, where, "motions.csv", status, err);
    picture->options.cancel = thud_interrupt_watch();
    int synthetic = 0;
    for (int i = 0; i < study->records->n; i++)
        synthetic += study->scaled.motion[i].chosen && study->records->record[i]->synthetic;
    thud_synthetic_text(synthetic, study->scaled.chosen, picture->options.motions, sizeof picture->options.motions);
    status = thud_figure_deliver(
        thud_figure_of_suite(&study->scaled, study->has_target ? study->target.text : "", study->mark, study->nmarks),
        where, &picture->options, status, err);
    return thud_made_by_end(&by, status, err);
}

/* The session of --preset, or one without a scene. */
static enum thud_status open_session(const struct thud_args *args, struct thud_session *session,
                                     struct thud_suite_study *study, struct thud_error *err)
{
    const char *preset = thud_args_value(args, "preset");
    if (!preset) {
        memset(session, 0, sizeof *session);
        thud_scene_init(&session->scene);
        thud_paths_find(&session->paths);
        return THUD_OK;
    }
    enum thud_status status = thud_session_open(session, preset, err);
    if (status == THUD_OK)
        status = thud_scene_periods(&session->scene, study->mark, THUD_STRUCTURES_MAX, &study->nmarks, err);
    if (status == THUD_OK && study->nmarks > 0)
        range_of_buildings(study);
    return status;
}

static enum thud_status work(const struct thud_args *args, struct thud_session *session, struct thud_suite_study *study,
                             struct thud_error *err)
{
    struct thud_record_list records = {0};
    struct thud_picture_choice picture;
    struct thud_text text = {0};
    enum thud_status status = thud_picture_options_read(args, &picture, err);
    if (status == THUD_OK)
        status = open_session(args, session, study, err);
    if (status == THUD_OK)
        status = read_options(args, study, err);
    if (status == THUD_OK)
        status = thud_records_named(args, session, args->operand[0], false, &records, err);
    study->records = &records;
    if (status == THUD_OK)
        status = thud_suite_study_run(study, err);
    if (status == THUD_OK)
        (thud_args_has(args, "json")  ? thud_suite_motions_json
         : thud_args_has(args, "csv") ? thud_suite_motions_csv
                                      : thud_suite_motions_table)(study, &text);
    if (status == THUD_OK && thud_args_has(args, "o"))
        status = save(study, thud_args_value(args, "o"), &picture, err);
    status = thud_cli_print_as(args, &text, status, err);
    thud_suite_study_clear(study);
    thud_record_list_clear(&records);
    return status;
}

enum thud_status thud_command_suite(const struct thud_args *args, struct thud_error *err)
{
    if (args->noperands != 1)
        return thud_error_refuse(err, THUD_USAGE, NULL, "FOLDER, NAME.list, or FILE,FILE,...",
                                 "thud suite needs ground motions");
    struct thud_session *session = calloc(1, sizeof *session);
    struct thud_suite_study *study = calloc(1, sizeof *study);
    enum thud_status status = THUD_MEMORY;
    if (session && study) {
        thud_scaling_init(&study->scaling);
        status = work(args, session, study, err);
        thud_session_close(session);
    } else {
        thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    free(study);
    free(session);
    return status;
}
