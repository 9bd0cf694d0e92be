#include "app/sweep/live_study.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/sweep/study_keys.h"
#include "app/sweep/sweep_study_private.h"
#include "base/grow.h"
#include "ground/identity.h"
#include "io/file/file.h"
#include "plot/figures/figures_gap.h"
#include "plot/figures/figures_sweep.h"

enum { CHUNK = 1 << 16, SAMPLES = 200, LEAST_TOLD = 3, POINTS_A_SLICE = 64 };
static const double wait_s = 0.004;

void thud_live_study_stop(struct thud_live_study *study)
{
    thud_sweep_work_end(study->work);
    study->work = NULL;
    study->running = false;
}

/* All but the motions and the words they were read by. */
static void clear_points(struct thud_live_study *study)
{
    thud_live_study_stop(study);
    thud_fragility_study_clear(&study->fragility);
    study->fragility = (struct thud_fragility_study){0};
    free(study->gap); /* its gaps stand in the points */
    study->gap = NULL;
    study->told = 0;
    study->complete = false;
    thud_suite_free(study->suite);
    study->suite = NULL;
    for (long i = 0; i < study->next; i++)
        free(study->done[i]);
    free(study->done);
    study->done = NULL;
    study->next = study->points = 0;
    thud_sweep_outcome_clear(&study->out);
    thud_sweep_plan_clear(&study->plan);
}

void thud_live_study_clear(struct thud_live_study *study)
{
    clear_points(study);
    thud_record_list_clear(&study->records);
    memset(study, 0, sizeof *study);
}

/* Folders are not looked into again at every edit; after thud_live_study_clear they are. */
static enum thud_status read_records(struct thud_live_study *study, struct thud_session *session,
                                     struct thud_error *err)
{
    const struct thud_study_choice *asked = &session->scene.study;
    if (study->read && strcmp(study->records_words, asked->records) == 0 && study->both_signs == asked->both_signs &&
        (*asked->records || memcmp(&study->records_of, &session->scene.record, sizeof study->records_of) == 0))
        return THUD_OK;
    thud_record_list_clear(&study->records);
    enum thud_status status = thud_record_list_named(session, asked->records, asked->both_signs, &study->records, err);
    study->read = status == THUD_OK;
    study->records_of = session->scene.record;
    memcpy(study->records_words, asked->records, sizeof study->records_words);
    study->both_signs = asked->both_signs;
    return status;
}

enum thud_status thud_live_study_prepare(struct thud_live_study *study, struct thud_session *session,
                                         struct thud_error *err)
{
    clear_points(study);
    enum thud_status status = read_records(study, session, err);
    if (status == THUD_OK)
        status = thud_study_plan(&session->scene, &study->plan, err);
    study->plan.nrecords = study->records.n;
    study->plan.record = study->records.n ? (const struct thud_record *const *)study->records.record : NULL;
    study->fragility.samples = SAMPLES;
    study->fragility.seed = 1;
    if (status == THUD_OK)
        status = thud_events_parse(session->scene.study.events, study->fragility.event, &study->fragility.nevents, err);
    if (status == THUD_OK && study->plan.nrecords > 1)
        status = thud_suite_create(&study->plan, &study->suite, err);
    study->fragility.suite = study->suite;
    if (status == THUD_OK)
        status = thud_sweep_outcome_init(&study->plan, &study->out, err);
    if (status != THUD_OK)
        clear_points(study);
    else
        study->points = thud_sweep_points(&study->plan);
    return status;
}

enum thud_status thud_live_study_start(struct thud_live_study *study, struct thud_error *err)
{
    struct thud_sweep_jobs jobs = {.plan = &study->plan, .step = 1, .count = study->points};
    enum thud_status status = thud_sweep_work_start(&jobs, &study->work, err);
    study->running = status == THUD_OK;
    return status;
}

/* Takes a finished point, for figures and files. */
static enum thud_status keep_point(struct thud_live_study *study, struct thud_sweep_point *point,
                                   struct thud_error *err)
{
    struct thud_sweep_point **larger = thud_grow(study->done, (size_t)study->next, sizeof *larger);
    enum thud_status status = larger ? THUD_OK : thud_error_set(err, THUD_MEMORY, "no memory for a point");
    study->done = larger ? larger : study->done;
    const struct thud_sweep_study into = {.plan = &study->plan, .table = true, .suite = study->suite};
    if (status == THUD_OK)
        status = thud_sweep_study_deliver(&into, point, &study->out, err);
    if (status != THUD_OK) {
        free(point);
        return status;
    }
    study->done[study->next++] = point;
    return THUD_OK;
}

enum thud_status thud_live_study_advance(struct thud_live_study *study, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    bool done = false;
    for (int i = 0; i < POINTS_A_SLICE && status == THUD_OK && !done; i++) {
        struct thud_sweep_point *point;
        status = thud_sweep_work_take(study->work, i == 0 ? wait_s : 0, &point, &done, err);
        if (status == THUD_OK && point)
            status = keep_point(study, point, err);
        else if (!point)
            break;
    }
    study->complete = status == THUD_OK && done;
    if (status != THUD_OK || done)
        thud_live_study_stop(study);
    return status;
}

/* The gaps of the first n motions, each from its first point. */
static void find_gaps(struct thud_live_study *study, int n)
{
    int levels = study->done[0]->ncontacts;
    long settings = study->points / study->records.n;
    size_t each = sizeof(struct thud_needed_gap) + (size_t)levels * sizeof(struct thud_gap_level);
    free(study->gap);
    study->gap = levels ? calloc((size_t)n, sizeof(struct thud_needed_gap *) + each) : NULL;
    for (int i = 0; study->gap && i < n; i++) {
        const struct thud_sweep_point *point = study->done[i * settings];
        study->gap[i] = (void *)((char *)(study->gap + n) + (size_t)i * each);
        study->gap[i]->nlevels = levels;
        memcpy(study->gap[i]->level, point->level, (size_t)levels * sizeof *point->level);
    }
}

/* Statistics of the motions that are done, recomputed after each of them; the bands once all are. Fragility needs a
 * number that is varied; without one there is none. */
static void tell(struct thud_live_study *study)
{
    int n = study->suite && study->points > 0 ? (int)(study->next * study->records.n / study->points) : 0;
    if (n < LEAST_TOLD && !study->complete)
        n = 0;
    if (n < 2 || study->told == n)
        return;
    study->told = n;
    find_gaps(study, n);
    for (size_t i = 0; i < study->fragility.n; i++)
        thud_fragility_clear(&study->fragility.line[i].fragility);
    free(study->fragility.line);
    study->fragility.line = NULL;
    study->fragility.n = 0;
    study->fragility.samples = study->complete ? SAMPLES : 0;
    if (study->plan.naxes > 0 && thud_fragility_study_make(&study->fragility, NULL) != THUD_OK)
        thud_fragility_study_clear(&study->fragility);
}

static int own_figures(const struct thud_live_study *study)
{
    return study->out.rows.table.nrows > 0 ? thud_sweep_figure_count(&study->out.rows.table) : 0;
}

int thud_live_study_figures(struct thud_live_study *study)
{
    int n = own_figures(study);
    tell(study);
    if (n > 0 && study->told)
        n += (study->gap != NULL) + (study->fragility.n > 0 ? thud_fragility_figure_count(&study->fragility) : 0);
    return n;
}

static struct thud_figure *make_figure(struct thud_live_study *study, int index)
{
    int own = own_figures(study);
    if (index < own)
        return thud_sweep_figure(&study->out.rows.table, index);
    tell(study);
    index -= own;
    if (study->gap && index-- == 0) {
        const struct thud_gap_suite suite = {study->told, study->out.names, study->gap,
                                             thud_motions_recordings(study->plan.record, study->told, NULL)};
        const struct thud_scene *scene = &study->plan.scene;
        return thud_figure_of_gaps(&suite, scene->title[0] ? scene->title : scene->name);
    }
    return study->fragility.n > 0 ? thud_fragility_figure(&study->fragility, index) : NULL;
}

struct thud_figure *thud_live_study_figure(struct thud_live_study *study, int index)
{
    char motions[64];
    struct thud_figure *figure = make_figure(study, index);
    thud_synthetic_text(thud_records_synthetic(study->plan.record, study->records.n), study->records.n, motions,
                        sizeof motions);
    thud_figure_title_motions(figure, motions);
    return figure;
}

static enum thud_status export_rows(const struct thud_live_study *study, enum thud_sweep_csv which,
                                    struct thud_file_draft *file, struct thud_text *text, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    thud_sweep_csv_header(&study->plan, which, text);
    for (long i = 0; i < study->next && status == THUD_OK; i++) {
        thud_sweep_csv_rows(&study->plan, which, study->done[i], text);
        status = thud_file_add(file, text, CHUNK, err);
    }
    if (status == THUD_OK)
        status = thud_file_add(file, text, 0, err);
    return status == THUD_OK ? thud_file_keep(file, err) : status;
}

static enum thud_status export_suite(const struct thud_live_study *study, const char *folder, const char *stem,
                                     struct thud_error *err)
{
    struct thud_text text = {0};
    char name[300];
    snprintf(name, sizeof name, "%.200s-suite.csv", stem);
    enum thud_status status = thud_suite_report(study->suite, THUD_AS_CSV, &text, err);
    status = thud_text_save(&text, folder, name, status, err);
    if (status != THUD_OK || study->fragility.n == 0)
        return status;
    snprintf(name, sizeof name, "%.200s-fragility.csv", stem);
    thud_fragility_curves_csv(&study->fragility, &text);
    return thud_text_save(&text, folder, name, status, err);
}

enum thud_status thud_live_study_export(const struct thud_live_study *study, const char *folder, const char *stem,
                                        struct thud_error *err)
{
    static const char *const ending[THUD_SWEEP_CSVS] = {".csv", "-contacts.csv", "-needed-gaps.csv"};
    enum thud_status status = THUD_OK;
    for (int i = 0; i < THUD_SWEEP_CSVS && status == THUD_OK; i++) {
        char path[4096];
        struct thud_file_draft file;
        struct thud_text text = {0};
        snprintf(path, sizeof path, "%s/%s%s", folder, stem, ending[i]);
        status = thud_file_begin(path, &file, err);
        if (status == THUD_OK)
            status = export_rows(study, (enum thud_sweep_csv)i, &file, &text, err);
        thud_file_drop(&file);
        thud_text_clear(&text);
    }
    return status == THUD_OK && study->suite ? export_suite(study, folder, stem, err) : status;
}
