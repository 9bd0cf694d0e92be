#include "app/run/session.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/record_list.h"
#include "base/scan.h"
#include "io/record/record_component.h"
#include "study/scene/needed_gap.h"
#include "study/suite/fragility.h"

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

enum thud_status thud_session_parse(struct thud_session *session, const char *text, size_t size, const char *name,
                                    struct thud_error *err)
{
    memset(session, 0, sizeof *session);
    thud_paths_find(&session->paths);
    snprintf(session->preset_path, sizeof session->preset_path, "%s", name);
    enum thud_status status = thud_preset_parse(text, size, name, &session->preset, err);
    if (status == THUD_OK)
        session->scene = *thud_preset_scene(session->preset);
    return status;
}

void thud_session_close(struct thud_session *session)
{
    thud_preset_free(session->preset);
    thud_record_free(session->record);
    thud_record_free(session->given);
    session->preset = NULL;
    session->record = session->given = NULL;
}

enum thud_status thud_session_set(struct thud_session *session, const char *key, const char *text,
                                  struct thud_error *err)
{
    enum thud_status status = thud_scene_set(&session->scene, key, text, err);
    if (status == THUD_OK && strcmp(key, "study.records") == 0 && *text)
        status = thud_record_list_read(session, text, NULL, 0, false, NULL, err);
    return status == THUD_OK ? thud_words_check(&session->scene, err) : status;
}

enum thud_status thud_session_assign(struct thud_session *session, const char *assignment, struct thud_error *err)
{
    const char *sign = strchr(assignment, '=');
    char key[128];
    if (!sign || sign == assignment || (size_t)(sign - assignment) >= sizeof key)
        return thud_error_refuse(err, THUD_USAGE, NULL, "KEY=VALUE, e.g. gap=12cm", "\"%.100s\" changes nothing",
                                 assignment);
    snprintf(key, sizeof key, "%.*s", (int)(sign - assignment), assignment);
    return thud_session_set(session, key, sign + 1, err);
}

/* Links are counted as they were before one is taken away. */
enum { RANKS = THUD_RANK_LAST + 1 + THUD_LINKS_MAX };
static int rank_of(const char *assignment)
{
    const char *sign = strchr(assignment, '='), *key = sign, *number = assignment;
    int link = 0;
    while (key && key > assignment && key[-1] != '.')
        key--;
    const int rank = key ? thud_key_rank(key, (size_t)(sign - key)) : THUD_RANK_USUAL;
    const bool taken = rank < THUD_RANK_USUAL && sign[1] == '\0' && thud_scan_word(&number, "links.") &&
                       thud_scan_count(&number, &link) && link <= THUD_LINKS_MAX;
    return taken                    ? RANKS - link
           : rank < THUD_RANK_USUAL ? rank
                                    : THUD_RANK_USUAL; /* what comes last is in the user's order */
}

enum thud_status thud_session_assign_all(struct thud_session *session, const char *const *assignment, int n,
                                         struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int rank = 0; rank <= RANKS; rank++)
        for (int i = 0; i < n && status == THUD_OK; i++)
            if (rank_of(assignment[i]) == rank)
                status = thud_session_assign(session, assignment[i], err);
    return status;
}

void thud_session_choose_record(struct thud_session *session, const char *file)
{
    thud_record_choice_replace(&session->scene.record, file);
}

/* The file of the ground motion; empty for the one that was given. */
static enum thud_status find_record(const struct thud_session *session, char *path, size_t size, struct thud_error *err)
{
    const char *file = session->scene.record.file;
    path[0] = '\0';
    if (session->given && strcmp(file, session->given->file) == 0)
        return THUD_OK;
    enum thud_status status = thud_paths_record(&session->paths, session->preset_path, file, path, size, err);
    if (status != THUD_OK && strcmp(file, thud_preset_scene(session->preset)->record.file) == 0)
        thud_preset_place(session->preset, "record.file", err); /* the preset says so, no option */
    return status;
}

static enum thud_status copy_given(const struct thud_record *given, const struct thud_record_choice *choice,
                                   struct thud_record **out, struct thud_error *err)
{
    enum thud_status status = thud_record_scaled(given, 1, out, err);
    return status == THUD_OK ? thud_record_choice_apply(*out, choice, err) : status;
}

/* The required gap of a scene under a motion in one of its directions: the widest of all levels, m. */
static enum thud_status gap_of(const struct thud_scene *scene, const char *path,
                               const struct thud_record_choice *choice, double *gap_m, struct thud_error *err)
{
    struct thud_record *record;
    struct thud_needed_gap *needed = NULL;
    enum thud_status status = thud_record_file_read(path, choice, &record, err);
    if (status == THUD_OK)
        status = thud_needed_gap_run(scene, record, &needed, err);
    *gap_m = status == THUD_OK ? thud_needed_gap_widest(needed, 0, THUD_GAP_EXACT, NULL) : 0;
    free(needed);
    thud_record_free(record);
    return status;
}

enum thud_status thud_motion_read(const struct thud_scene *scene, const char *path, struct thud_record_choice *choice,
                                  struct thud_record **out, struct thud_error *err)
{
    enum { APART = 5 }; /* degrees: a peak falls off by 1 - cos(2.5 deg), 0.1 %, halfway */
    double widest = -1, gap;
    int best = 0;
    *out = NULL;
    enum thud_status status = thud_record_choice_resolve(scene, choice, err);
    const bool governs = strcmp(choice->component, THUD_COMPONENT_GOVERNS) == 0 && scene->nstructures > 1;
    for (int k = 0; governs && k < 360 && status == THUD_OK; k += APART) {
        snprintf(choice->component, sizeof choice->component, "rot%d", k);
        status = gap_of(scene, path, choice, &gap, err);
        best = status == THUD_OK && gap > widest ? k : best;
        widest = fmax(widest, gap);
    }
    if (governs)
        snprintf(choice->component, sizeof choice->component, "rot%d", best);
    return status == THUD_OK ? thud_record_file_read(path, choice, out, err) : status;
}

/* A reason that is about the direction, with the key of a scene. */
static bool is_of_component(enum thud_status status, struct thud_error *err)
{
    if (status != THUD_INPUT || strcmp(err->key, "component") != 0)
        return false;
    thud_error_key(err, "record.component");
    return true;
}

enum thud_status thud_motion_look(const struct thud_scene *scene, const char *path,
                                  const struct thud_record_choice *choice, struct thud_error *err)
{
    struct thud_record_choice own = *choice;
    struct thud_record *record = NULL;
    struct thud_error why = {0};
    if (!*own.component)
        return THUD_OK;
    if (strcmp(own.component, THUD_COMPONENT_GOVERNS) == 0) /* which is one of all, found by many runs */
        snprintf(own.component, sizeof own.component, "rot0");
    const enum thud_status status = thud_motion_read(scene, path, &own, &record, &why);
    thud_record_free(record);
    if (!is_of_component(status, &why))
        return THUD_OK;
    if (err)
        *err = why;
    return status;
}

void thud_session_place_component(const struct thud_session *session, const char *component, enum thud_status status,
                                  struct thud_error *err)
{
    if (err && is_of_component(status, err) && session->preset &&
        strcmp(component, thud_preset_scene(session->preset)->record.component) == 0)
        thud_preset_place(session->preset, "record.component", err); /* the preset says so, no option */
}

enum thud_status thud_session_read_record(struct thud_session *session, struct thud_error *err)
{
    struct thud_record_choice choice = session->scene.record;
    char path[1024];
    enum thud_status status = choice.file[0] ? find_record(session, path, sizeof path, err) : THUD_OK;
    if (status == THUD_OK)
        status = thud_record_choice_resolve(&session->scene, &choice, err);
    const struct thud_record_choice asked = choice;
    if (status == THUD_OK && session->record && memcmp(&choice, &session->record_read, sizeof choice) == 0)
        return THUD_OK;
    thud_record_free(session->record);
    session->record = NULL;
    if (status == THUD_OK && choice.file[0])
        status = path[0] ? thud_motion_read(&session->scene, path, &choice, &session->record, err)
                         : copy_given(session->given, &choice, &session->record, err);
    thud_session_place_component(session, asked.component, status, err);
    if (status == THUD_OK)
        status = thud_scene_check_motion(&session->scene, session->record, err);
    if (status != THUD_OK) {
        thud_record_free(session->record);
        session->record = NULL;
    } else if (session->record) {
        snprintf(session->record->file, sizeof session->record->file, "%s", choice.file); /* as given, not as found */
        session->record_read = asked;
    }
    return status;
}

enum thud_status thud_session_case(struct thud_session *session, enum thud_case which, struct thud_scene *scene,
                                   struct thud_error *err)
{
    *scene = session->scene;
    enum thud_status status = THUD_OK;
    if (which != THUD_CASE_AS_WRITTEN)
        status = thud_scene_case(&session->scene, which, scene, err);
    if (status == THUD_OK)
        status = thud_scene_check(scene, err);
    return status == THUD_OK ? thud_session_read_record(session, err) : status;
}

enum thud_status thud_session_run(struct thud_session *session, enum thud_case which,
                                  const struct thud_run_options *options, struct thud_scene *scene,
                                  struct thud_solution *solution, struct thud_error *err)
{
    *solution = (struct thud_solution){0};
    enum thud_status status = thud_session_case(session, which, scene, err);
    if (status == THUD_OK)
        status = thud_scene_solve(scene, session->record, options, solution, err);
    return status;
}

struct thud_report thud_session_report(const struct thud_session *session, const struct thud_scene *scene,
                                       enum thud_case which, const struct thud_solution *solution)
{
    struct thud_report report = {.scene = scene,
                                 .which = thud_case_name(which),
                                 .record = session->record,
                                 .result = thud_run_result(solution->run),
                                 .history = thud_run_history(solution->run)};
    report.impact = thud_run_impacts(solution->run, &report.nimpacts);
    report.event = thud_run_events(solution->run, &report.nevents);
    return report;
}
