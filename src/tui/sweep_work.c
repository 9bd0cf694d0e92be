#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/output.h"
#include "io/record_file.h"
#include "study/answer.h"
#include "tui/sweep_work.h"

enum { SEGMENTS = 400, CHUNK = 1 << 16 };

static void drop_tasks(struct thud_sweep_work *work)
{
    if (work->task)
        thud_sweep_task_free(work->task);
    if (work->group)
        thud_sweep_group_free(work->group);
    work->task = NULL;
    work->group = NULL;
    work->base_done = false;
}

void thud_sweep_work_stop(struct thud_sweep_work *work)
{
    drop_tasks(work);
    work->running = false;
}

void thud_sweep_work_clear(struct thud_sweep_work *work)
{
    thud_sweep_work_stop(work);
    thud_sweep_plan_clear(&work->plan);
    for (int i = 0; i < work->nrecords; i++)
        thud_record_free(work->record[i]);
    for (long i = 0; i < work->next; i++)
        free(work->done[i]);
    free(work->done);
    thud_sweep_collector_clear(&work->rows);
    memset(work, 0, sizeof *work);
}

/* Reads one ground motion; one named here carries nothing of what the preset says of its own but the sign. */
static enum thud_status add_record(struct thud_sweep_work *work, const struct thud_scene *scene, const char *file,
                                   const struct thud_paths *paths, const char *preset_path, struct thud_error *err)
{
    struct thud_record_choice choice = scene->record;
    char path[1024];
    if (work->nrecords == THUD_STUDY_RECORDS_MAX)
        return thud_error_set(err, THUD_INPUT, "more than %d records", THUD_STUDY_RECORDS_MAX);
    if (strcmp(file, scene->record.file) != 0) {
        thud_record_choice_init(&choice);
        choice.sign = scene->record.sign;
    }
    enum thud_status status = thud_paths_record(paths, preset_path, file, path, sizeof path, err);
    if (status == THUD_OK)
        status = thud_record_choice_resolve(scene, &choice, err);
    if (status == THUD_OK)
        status = thud_record_file_read(path, &choice, &work->record[work->nrecords], err);
    if (status != THUD_OK)
        return status;
    struct thud_record *record = work->record[work->nrecords]; /* by the name that was given, wherever it was found */
    snprintf(record->file, sizeof record->file, "%s", file);
    const char *slash = strrchr(file, '/');
    snprintf(work->record_name[work->nrecords], sizeof work->record_name[0], "%.90s", slash ? slash + 1 : file);
    work->record_names[work->nrecords] = work->record_name[work->nrecords];
    work->nrecords++;
    return THUD_OK;
}

static enum thud_status read_records(struct thud_sweep_work *work, const struct thud_scene *scene, const char *words,
                                     const struct thud_paths *paths, const char *preset_path, struct thud_error *err)
{
    char list[512], *rest = list;
    snprintf(list, sizeof list, "%s", *words ? words : scene->record.file);
    enum thud_status status = THUD_OK;
    for (char *file; status == THUD_OK && (file = strtok_r(rest, ",", &rest)) != NULL;) {
        file += strspn(file, " ");
        for (size_t n = strlen(file); n > 0 && file[n - 1] == ' '; n--)
            file[n - 1] = '\0';
        if (*file)
            status = add_record(work, scene, file, paths, preset_path, err);
    }
    return status;
}

static enum thud_status make_plan(struct thud_sweep_work *work, const struct thud_study_words *words,
                                  struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < THUD_VARY_MAX && status == THUD_OK; i++)
        if (*words->vary[i])
            status = thud_sweep_vary(&work->plan, words->vary[i], err);
    if (status == THUD_OK && *words->cases)
        status = thud_sweep_cases(&work->plan, words->cases, err);
    if (status == THUD_OK && *words->sensitivity)
        status = thud_scene_set(&work->plan.scene, "study.sensitivity", words->sensitivity, err);
    work->plan.sensitivity = *words->sensitivity ? work->plan.scene.study.sensitivity : 0;
    work->plan.nrecords = work->nrecords;
    work->plan.record = work->nrecords ? (const struct thud_record *const *)work->record : NULL;
    return status;
}

/* Takes a finished point, for figures and files. */
static enum thud_status keep_point(struct thud_sweep_work *work, struct thud_sweep_point *point, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    if (work->next == work->room) {
        long room = work->room ? 2 * work->room : 64;
        struct thud_sweep_point **larger = realloc(work->done, (size_t)room * sizeof *larger);
        if (larger) {
            work->done = larger;
            work->room = room;
        } else {
            status = thud_error_set(err, THUD_MEMORY, "no memory for a point");
        }
    }
    if (status == THUD_OK)
        status = thud_sweep_collector_add(&work->rows, &work->plan, point, err);
    if (status != THUD_OK) {
        free(point);
        return status;
    }
    thud_sweep_total_add(&work->total, point);
    work->done[work->next++] = point;
    return THUD_OK;
}

/* The reference case of the point that makes it for this one, too. */
static void share_reference(const struct thud_sweep_work *work, struct thud_sweep_task *task)
{
    long of = thud_sweep_reference_point(&work->plan, work->next);
    struct thud_sweep_reference *reference =
        of < work->next ? thud_sweep_reference_keep(&work->plan, work->done[of]) : NULL;
    if (reference)
        thud_sweep_task_share(task, reference);
    free(reference);
}

enum thud_status thud_sweep_work_start(struct thud_sweep_work *work, const struct thud_scene *scene,
                                       const struct thud_study_words *words, const struct thud_paths *paths,
                                       const char *preset_path, struct thud_error *err)
{
    thud_sweep_work_clear(work);
    thud_sweep_plan_init(&work->plan, scene);
    work->record_names[0] = "";
    enum thud_status status = read_records(work, scene, words->records, paths, preset_path, err);
    if (status == THUD_OK)
        status = make_plan(work, words, err);
    if (status != THUD_OK) {
        thud_sweep_work_clear(work);
        return status;
    }
    thud_sweep_collector_init(&work->rows, &work->plan, work->record_names);
    work->points = thud_sweep_points(&work->plan);
    work->base_index = -1;
    work->running = true;
    return THUD_OK;
}

/* The group under the next point, made where it is another one. */
static enum thud_status advance_base(struct thud_sweep_work *work, struct thud_error *err)
{
    long index = work->next / thud_sweep_points_per_group(&work->plan);
    if (work->group && index != work->base_index)
        drop_tasks(work);
    if (!work->group) {
        enum thud_status status = thud_sweep_group_create(&work->plan, index, &work->group, err);
        if (status != THUD_OK)
            return status;
        work->base_index = index;
        work->base_done = false;
    }
    return thud_sweep_group_advance(work->group, SEGMENTS, &work->base_done, err);
}

static enum thud_status advance_task(struct thud_sweep_work *work, struct thud_error *err)
{
    bool done = false;
    enum thud_status status = THUD_OK;
    if (!work->task) {
        status = thud_sweep_task_create(&work->plan, work->group, work->next, &work->task, err);
        if (status == THUD_OK)
            share_reference(work, work->task);
    }
    if (status == THUD_OK)
        status = thud_sweep_task_advance(work->task, SEGMENTS, &done, err);
    if (status != THUD_OK || !done)
        return status;
    struct thud_sweep_point *point = thud_sweep_task_take(work->task);
    thud_sweep_task_free(work->task);
    work->task = NULL;
    return keep_point(work, point, err);
}

enum thud_status thud_sweep_work_advance(struct thud_sweep_work *work, struct thud_error *err)
{
    if (work->next >= work->points) {
        work->complete = true;
        thud_sweep_work_stop(work);
        return THUD_OK;
    }
    bool other = work->group && work->next / thud_sweep_points_per_group(&work->plan) != work->base_index;
    enum thud_status status = work->base_done && !other ? advance_task(work, err) : advance_base(work, err);
    if (status != THUD_OK)
        thud_sweep_work_stop(work);
    return status;
}

static enum thud_status export_one(const struct thud_sweep_work *work, enum thud_sweep_csv which,
                                   struct thud_output *file, struct thud_text *text, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    thud_sweep_csv_header(&work->plan, which, text);
    for (long i = 0; i < work->next && status == THUD_OK; i++) {
        status = thud_sweep_csv_rows(&work->plan, which, work->done[i], text, err);
        if (status == THUD_OK)
            status = thud_output_drain(file, text, CHUNK, err);
    }
    if (status == THUD_OK)
        status = thud_output_drain(file, text, 0, err);
    return status == THUD_OK ? thud_output_commit(file, err) : status;
}

enum thud_status thud_sweep_work_export(const struct thud_sweep_work *work, const char *folder, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < THUD_SWEEP_CSVS && status == THUD_OK; i++) {
        char path[4096];
        struct thud_output file = {.fd = -1};
        struct thud_text text = {0};
        snprintf(path, sizeof path, "%s/%s", folder, thud_sweep_csv_name((enum thud_sweep_csv)i));
        status = thud_output_open(path, &file, err);
        if (status == THUD_OK)
            status = export_one(work, (enum thud_sweep_csv)i, &file, &text, err);
        thud_output_abandon(&file);
        thud_text_clear(&text);
    }
    return status;
}
