#include "app/run/session.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "io/record/record_file.h"

static enum thud_status open_session(struct thud_session *session, const char *preset, bool unfinished,
                                     struct thud_error *err)
{
    memset(session, 0, sizeof *session);
    thud_paths_find(&session->paths);
    enum thud_status status =
        thud_paths_preset(&session->paths, preset, session->preset_path, sizeof session->preset_path, err);
    if (status == THUD_OK)
        status =
            (unfinished ? thud_preset_read_unfinished : thud_preset_read)(session->preset_path, &session->preset, err);
    if (status == THUD_OK)
        session->scene = *thud_preset_scene(session->preset);
    return status;
}

enum thud_status thud_session_open(struct thud_session *session, const char *preset, struct thud_error *err)
{
    return open_session(session, preset, false, err);
}

enum thud_status thud_session_open_unfinished(struct thud_session *session, const char *preset, struct thud_error *err)
{
    return open_session(session, preset, true, err);
}

void thud_session_close(struct thud_session *session)
{
    thud_preset_free(session->preset);
    thud_record_free(session->record);
    session->preset = NULL;
    session->record = NULL;
}

enum thud_status thud_session_assign(struct thud_session *session, const char *assignment, struct thud_error *err)
{
    const char *sign = strchr(assignment, '=');
    char key[128];
    if (!sign || sign == assignment || (size_t)(sign - assignment) >= sizeof key) {
        thud_error_set(err, THUD_USAGE, "\"%.100s\" changes nothing", assignment);
        thud_error_allow(err, "KEY=VALUE, e.g. gap=12cm");
        return THUD_USAGE;
    }
    snprintf(key, sizeof key, "%.*s", (int)(sign - assignment), assignment);
    return thud_scene_set(&session->scene, key, sign + 1, err);
}

void thud_session_choose_record(struct thud_session *session, const char *file)
{
    thud_record_choice_replace(&session->scene.record, file);
}

enum thud_status thud_session_read_record(struct thud_session *session, struct thud_error *err)
{
    const struct thud_record_choice *choice = &session->scene.record;
    struct thud_record_choice resolved = *choice;
    char path[1024];
    if (session->record && memcmp(choice, &session->record_read, sizeof *choice) == 0)
        return THUD_OK;
    thud_record_free(session->record);
    session->record = NULL;
    if (!choice->file[0])
        return thud_scene_check_motion(&session->scene, NULL, err);
    enum thud_status status =
        thud_paths_record(&session->paths, session->preset_path, choice->file, path, sizeof path, err);
    if (status != THUD_OK && strcmp(choice->file, thud_preset_scene(session->preset)->record.file) == 0)
        thud_preset_place(session->preset, "record.file", err); /* the preset says so, no option */
    if (status == THUD_OK)
        status = thud_record_choice_resolve(&session->scene, &resolved, err);
    if (status == THUD_OK)
        status = thud_record_file_read(path, &resolved, &session->record, err);
    if (status == THUD_OK)
        status = thud_scene_check_motion(&session->scene, session->record, err);
    if (status == THUD_OK) {
        snprintf(session->record->file, sizeof session->record->file, "%s", choice->file); /* as given, not as found */
        session->record_read = *choice;
    } else {
        thud_record_free(session->record);
        session->record = NULL;
    }
    return status;
}

enum thud_status thud_session_run(struct thud_session *session, enum thud_case which,
                                  const struct thud_run_options *options, struct thud_scene *scene,
                                  struct thud_answer *answer, struct thud_error *err)
{
    *answer = (struct thud_answer){0};
    *scene = session->scene;
    enum thud_status status = THUD_OK;
    if (which != THUD_CASE_AS_WRITTEN)
        status = thud_scene_case(&session->scene, which, scene, err);
    if (status == THUD_OK)
        status = thud_scene_check(scene, err);
    if (status == THUD_OK)
        status = thud_session_read_record(session, err);
    if (status == THUD_OK)
        status = thud_scene_answer(scene, session->record, options, answer, err);
    return status;
}

struct thud_report thud_session_report(const struct thud_session *session, const struct thud_scene *scene,
                                       enum thud_case which, const struct thud_answer *answer)
{
    struct thud_report report = {.scene = scene,
                                 .which = thud_case_name(which),
                                 .record = session->record,
                                 .result = thud_run_result(answer->run),
                                 .history = thud_run_history(answer->run)};
    report.impact = thud_run_impacts(answer->run, &report.nimpacts);
    report.event = thud_run_events(answer->run, &report.nevents);
    return report;
}
