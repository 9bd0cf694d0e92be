/* thud simplify: what a scene needs. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/figure_files.h"
#include "app/sweep/simplify_report.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/study_output.h"
#include "io/building/building_file.h"
#include "io/file/file.h"
#include "io/file/paths.h"
#include "io/preset/preset.h"
#include "io/result/simplification_rows.h"
#include "plot/figures/figures_simplify.h"

static enum thud_status read_ask(const struct thud_args *args, struct thud_scene *scene, struct thud_simplify_ask *ask,
                                 struct thud_error *err)
{
    struct thud_quantity within = {.value = 0.05};
    char list[200];
    const char *text = thud_args_value(args, "within"), *cases = thud_args_value(args, "cases");
    if (text && (thud_quantity_parse(text, THUD_RATIO, NULL, &within, NULL) != THUD_OK ||
                 !(within.value > 0 && within.value <= 1)))
        return thud_error_refuse(err, THUD_USAGE, "--within", "above 0, at most 100 %", "\"%.40s\" is not an accuracy",
                                 text);
    *ask = (struct thud_simplify_ask){.within = within.value};
    snprintf(list, sizeof list, "[%s]", cases ? cases : "");
    if (cases && thud_scene_set(scene, "study.cases", list, err) != THUD_OK)
        return thud_args_wrong("cases", err);
    ask->ncases = cases ? scene->study.ncases : 0;
    memcpy(ask->cases, scene->study.cases, sizeof scene->study.cases);
    return THUD_OK;
}

/* The ground motion's file as the preset in the folder finds it; where it would not, by its whole path. */
static void move_record(const struct thud_session *session, const char *to, struct thud_scene *scene)
{
    char here[4096], there[4096];
    const char *file = session->scene.record.file;
    if (!file[0] || thud_paths_record(&session->paths, session->preset_path, file, here, sizeof here, NULL) != THUD_OK)
        return;
    if (strcmp(here, file) != 0 && thud_paths_record(&session->paths, to, file, there, sizeof there, NULL) == THUD_OK &&
        strcmp(here, there) == 0)
        return;
    char *whole = realpath(here, NULL);
    if (whole && strlen(whole) < sizeof scene->record.file)
        snprintf(scene->record.file, sizeof scene->record.file, "%s", whole);
    free(whole);
}

static enum thud_status write_preset(const struct thud_session *session, const struct thud_simplify_found *found,
                                     const char *folder, struct thud_scene *scene, struct thud_error *err)
{
    struct thud_text text = {0};
    char path[4096], *preset = NULL;
    unsigned long size;
    *scene = found->scene;
    snprintf(path, sizeof path, "%s/simplest.yaml", folder);
    thud_building_files_move(scene, session->preset_path, path);
    move_record(session, path, scene);
    enum thud_status status = thud_preset_text(session->preset, scene, &preset, &size, err);
    if (status == THUD_OK) {
        thud_simplify_comments(found, &text);
        thud_text_bytes(&text, preset, size);
    }
    free(preset);
    return thud_text_save(&text, folder, "simplest.yaml", status, err);
}

static enum thud_status save(const struct thud_args *args, const struct thud_session *session,
                             const struct thud_simplify_found *found, struct thud_picture_choice *picture,
                             struct thud_scene *scene, struct thud_error *err)
{
    const char *folder = thud_args_value(args, "o"),
               *title = session->scene.title[0] ? session->scene.title : session->scene.name;
    const struct thud_rows rows = thud_simplify_table_rows(found);
    enum thud_status status = thud_rows_save(&rows, folder, THUD_OK, err);
    if (status == THUD_OK)
        status = write_preset(session, found, folder, scene, err);
    picture->options.cancel = thud_interrupt_watch();
    return thud_figure_deliver(thud_figure_of_simplify(found, title), folder, &picture->options, status, err);
}

enum thud_status thud_command_simplify(const struct thud_args *args, struct thud_session *session,
                                       struct thud_scene *scene, struct thud_error *err)
{
    struct thud_record_list records = {0};
    struct thud_simplify *search = NULL;
    const struct thud_simplify_found *found = NULL;
    struct thud_simplify_ask ask;
    struct thud_picture_choice picture;
    struct thud_made_by by;
    struct thud_text text = {0};
    static const char *const asked[] = {"within", "cases", "records", NULL};
    bool begun = false;
    *scene = session->scene;
    enum thud_status status = read_ask(args, scene, &ask, err);
    scene->study = session->scene.study;
    if (status == THUD_OK)
        status = thud_picture_options_read(args, &picture, err);
    if (status == THUD_OK)
        status = thud_records_option_read(args, session, &records, err);
    if (status == THUD_OK)
        status = thud_scene_check_motion(scene, records.n > 0 ? records.record[0] : NULL, err);
    if (status == THUD_OK) /* nothing is written before the end: a signal stops it at once, inside a run too */
        status = thud_simplify_search(scene, &records, &ask, NULL, &search, err);
    if (status == THUD_OK) {
        found = thud_simplify_found(search);
        status = thud_made_by_scene_file(args, "simplify", session, scene, asked, &by, err);
        begun = status == THUD_OK;
    }
    if (status == THUD_OK && thud_args_has(args, "o"))
        status = save(args, session, found, &picture, scene, err);
    if (status == THUD_OK && thud_args_has(args, "json"))
        thud_simplify_json(found, scene->name, &text);
    else if (status == THUD_OK && thud_args_has(args, "csv")) {
        const struct thud_rows rows = thud_simplify_table_rows(found);
        thud_rows_csv(&rows, &text);
    } else if (status == THUD_OK)
        thud_simplify_report(found, &text);
    status = thud_cli_print_as(args, &text, status, err);
    thud_simplify_free(search);
    thud_record_list_clear(&records);
    return begun ? thud_made_by_finish(args, &by, status, err) : status;
}
