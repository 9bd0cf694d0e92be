#include "tui/screens/sweep_data.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ground/identity.h"
#include "io/file/file.h"
#include "io/file/output.h"
#include "plot/figures/figures_gap.h"
#include "plot/figures/figures_sweep.h"
#include "tui/document/motions.h"

enum { CHUNK = 1 << 16, SAMPLES = 200, LEAST_TOLD = 3, POINTS_A_SLICE = 64 };
static const double wait_s = 0.004;

void thud_sweep_data_stop(struct thud_sweep_data *data)
{
    thud_sweep_work_end(data->work);
    data->work = NULL;
    data->running = false;
}

/* All but the motions and the words they were read by. */
static void clear_points(struct thud_sweep_data *data)
{
    thud_sweep_data_stop(data);
    thud_fragility_study_clear(&data->fragility);
    data->fragility = (struct thud_fragility_study){0};
    free(data->gap); /* its gaps stand in the points */
    data->gap = NULL;
    data->told = 0;
    data->complete = false;
    thud_suite_free(data->suite);
    data->suite = NULL;
    for (long i = 0; i < data->next; i++)
        free(data->done[i]);
    free(data->done);
    data->done = NULL;
    data->next = data->points = data->room = 0;
    thud_sweep_collector_clear(&data->rows);
    thud_sweep_plan_clear(&data->plan);
}

static void clear_records(struct thud_sweep_data *data)
{
    thud_record_list_clear(&data->records);
    free(data->names);
    data->names = NULL;
}

void thud_sweep_data_clear(struct thud_sweep_data *data)
{
    clear_points(data);
    clear_records(data);
    memset(data, 0, sizeof *data);
}

static enum thud_status read_records(struct thud_sweep_data *data, const struct thud_doc *doc, struct thud_error *err)
{
    const struct thud_study_choice *study = &doc->scene.study;
    clear_records(data);
    enum thud_status status = thud_doc_motions(doc, study->records, study->both_signs, &data->records, err);
    int n = data->records.n > 0 ? data->records.n : 1;
    if (status == THUD_OK && !(data->names = calloc((size_t)n, sizeof *data->names)))
        status = thud_error_set(err, THUD_MEMORY, "no memory for the motions");
    if (status != THUD_OK) {
        clear_records(data);
        return status;
    }
    data->names[0] = "";
    for (int i = 0; i < data->records.n; i++)
        data->names[i] = thud_path_name(data->records.record[i]->file);
    data->records_of = doc->scene.record;
    memcpy(data->records_words, study->records, sizeof data->records_words);
    data->both_signs = study->both_signs;
    return status;
}

/* Folders are not looked into again at every edit; `r` does, by way of thud_sweep_data_clear. */
static bool has_records(const struct thud_sweep_data *data, const struct thud_doc *doc)
{
    const struct thud_study_choice *study = &doc->scene.study;
    return data->names && strcmp(data->records_words, study->records) == 0 && data->both_signs == study->both_signs &&
           (*study->records || memcmp(&data->records_of, &doc->scene.record, sizeof data->records_of) == 0);
}

enum thud_status thud_sweep_data_prepare(struct thud_sweep_data *data, const struct thud_doc *doc,
                                         struct thud_error *err)
{
    clear_points(data);
    thud_sweep_total_init(&data->total);
    enum thud_status status = has_records(data, doc) ? THUD_OK : read_records(data, doc, err);
    if (status == THUD_OK)
        status = thud_study_plan(&doc->scene, &data->plan, err);
    data->plan.nrecords = data->records.n;
    data->plan.record = data->records.n ? (const struct thud_record *const *)data->records.record : NULL;
    data->fragility.samples = SAMPLES;
    data->fragility.seed = 1;
    if (status == THUD_OK)
        status = thud_events_parse(doc->scene.study.events, data->fragility.event, &data->fragility.nevents, err);
    if (status == THUD_OK && data->plan.nrecords > 1)
        status = thud_suite_create(&data->plan, &data->suite, err);
    data->fragility.suite = data->suite;
    if (status != THUD_OK) {
        clear_points(data);
        return status;
    }
    thud_sweep_collector_init(&data->rows, &data->plan, data->names);
    data->points = thud_sweep_points(&data->plan);
    return THUD_OK;
}

enum thud_status thud_sweep_data_start(struct thud_sweep_data *data, struct thud_error *err)
{
    struct thud_sweep_jobs jobs = {.plan = &data->plan, .step = 1, .count = data->points};
    enum thud_status status = thud_sweep_work_start(&jobs, &data->work, err);
    data->running = status == THUD_OK;
    return status;
}

/* Takes a finished point, for figures and files. */
static enum thud_status keep_point(struct thud_sweep_data *data, struct thud_sweep_point *point, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    if (data->next == data->room) {
        long room = data->room ? 2 * data->room : 64;
        struct thud_sweep_point **larger = realloc(data->done, (size_t)room * sizeof *larger);
        if (larger) {
            data->done = larger;
            data->room = room;
        } else {
            status = thud_error_set(err, THUD_MEMORY, "no memory for a point");
        }
    }
    if (status == THUD_OK)
        status = thud_sweep_collector_add(&data->rows, &data->plan, point, err);
    if (status == THUD_OK && data->suite)
        status = thud_suite_add(data->suite, point, err);
    if (status != THUD_OK) {
        free(point);
        return status;
    }
    thud_sweep_total_add(&data->total, point);
    data->done[data->next++] = point;
    return THUD_OK;
}

enum thud_status thud_sweep_data_advance(struct thud_sweep_data *data, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    bool done = false;
    for (int i = 0; i < POINTS_A_SLICE && status == THUD_OK && !done; i++) {
        struct thud_sweep_point *point;
        status = thud_sweep_work_take(data->work, i == 0 ? wait_s : 0, &point, &done, err);
        if (status == THUD_OK && point)
            status = keep_point(data, point, err);
        else if (!point)
            break;
    }
    data->complete = status == THUD_OK && done;
    if (status != THUD_OK || done)
        thud_sweep_data_stop(data);
    return status;
}

/* The gaps of the first n motions, each from its first point. */
static void find_gaps(struct thud_sweep_data *data, int n)
{
    int levels = data->done[0]->ncontacts;
    long settings = data->points / data->records.n;
    size_t each = sizeof(struct thud_needed_gap) + (size_t)levels * sizeof(struct thud_gap_level);
    free(data->gap);
    data->gap = levels ? calloc((size_t)n, sizeof(struct thud_needed_gap *) + each) : NULL;
    for (int i = 0; data->gap && i < n; i++) {
        const struct thud_sweep_point *point = data->done[i * settings];
        data->gap[i] = (void *)((char *)(data->gap + n) + (size_t)i * each);
        data->gap[i]->nlevels = levels;
        memcpy(data->gap[i]->level, point->level, (size_t)levels * sizeof *point->level);
    }
}

/* Statistics of the motions that are done, recomputed after each of them; the bands once all are. Fragility needs a number that is varied;
 * without one there is none. */
static void tell(struct thud_sweep_data *data)
{
    int n = data->suite && data->points > 0 ? (int)(data->next * data->records.n / data->points) : 0;
    if (n < LEAST_TOLD && !data->complete)
        n = 0;
    if (n < 2 || data->told == n)
        return;
    data->told = n;
    find_gaps(data, n);
    for (size_t i = 0; i < data->fragility.n; i++)
        thud_fragility_clear(&data->fragility.line[i].fragility);
    free(data->fragility.line);
    data->fragility.line = NULL;
    data->fragility.n = 0;
    data->fragility.samples = data->complete ? SAMPLES : 0;
    if (data->plan.naxes > 0 && thud_fragility_study_make(&data->fragility, NULL) != THUD_OK)
        thud_fragility_study_clear(&data->fragility);
}

static int own_figures(const struct thud_sweep_data *data)
{
    return data->rows.table.nrows > 0 ? thud_sweep_figure_count(&data->rows.table) : 0;
}

int thud_sweep_data_figures(struct thud_sweep_data *data)
{
    int n = own_figures(data);
    tell(data);
    if (n > 0 && data->told)
        n += (data->gap != NULL) + (data->fragility.n > 0 ? thud_fragility_figure_count(&data->fragility) : 0);
    return n;
}

static struct thud_figure *make_figure(struct thud_sweep_data *data, int index)
{
    int own = own_figures(data);
    if (index < own)
        return thud_sweep_figure(&data->rows.table, index);
    tell(data);
    index -= own;
    if (data->gap && index-- == 0) {
        const struct thud_gap_suite suite = {
            data->told, data->names, data->gap,
            thud_motions_recordings(data->plan.record, data->told < data->records.n ? data->told : data->records.n,
                                    NULL)};
        const struct thud_scene *scene = &data->plan.scene;
        return thud_figure_of_gaps(&suite, scene->title[0] ? scene->title : scene->name);
    }
    return data->fragility.n > 0 ? thud_fragility_figure(&data->fragility, index) : NULL;
}

struct thud_figure *thud_sweep_data_figure(struct thud_sweep_data *data, int index)
{
    char motions[64];
    struct thud_figure *figure = make_figure(data, index);
    thud_synthetic_text(thud_records_synthetic(data->plan.record, data->records.n), data->records.n, motions,
                        sizeof motions);
    thud_figure_title_add(figure, motions);
    return figure;
}

static enum thud_status export_rows(const struct thud_sweep_data *data, enum thud_sweep_csv which,
                                    struct thud_output *file, struct thud_text *text, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    thud_sweep_csv_header(&data->plan, which, text);
    for (long i = 0; i < data->next && status == THUD_OK; i++) {
        thud_sweep_csv_rows(&data->plan, which, data->done[i], text);
        status = thud_output_drain(file, text, CHUNK, err);
    }
    if (status == THUD_OK)
        status = thud_output_drain(file, text, 0, err);
    return status == THUD_OK ? thud_output_commit(file, err) : status;
}

static enum thud_status export_suite(const struct thud_sweep_data *data, const char *folder, const char *stem,
                                     struct thud_error *err)
{
    struct thud_text text = {0};
    char name[300];
    snprintf(name, sizeof name, "%.200s-suite.csv", stem);
    enum thud_status status = thud_suite_report(data->suite, THUD_AS_CSV, &text, err);
    if (status == THUD_OK)
        status = thud_text_write_in(&text, folder, name, err);
    if (status == THUD_OK && data->fragility.n > 0) {
        snprintf(name, sizeof name, "%.200s-fragility.csv", stem);
        thud_fragility_curves_csv(&data->fragility, &text);
        status = thud_text_write_in(&text, folder, name, err);
    }
    thud_text_clear(&text);
    return status;
}

enum thud_status thud_sweep_data_export(const struct thud_sweep_data *data, const char *folder, const char *stem,
                                        struct thud_error *err)
{
    static const char *const ending[THUD_SWEEP_CSVS] = {".csv", "-contacts.csv", "-needed-gaps.csv"};
    enum thud_status status = THUD_OK;
    for (int i = 0; i < THUD_SWEEP_CSVS && status == THUD_OK; i++) {
        char path[4096];
        struct thud_output file = {.fd = -1};
        struct thud_text text = {0};
        snprintf(path, sizeof path, "%s/%s%s", folder, stem, ending[i]);
        status = thud_output_open(path, &file, err);
        if (status == THUD_OK)
            status = export_rows(data, (enum thud_sweep_csv)i, &file, &text, err);
        thud_output_abandon(&file);
        thud_text_clear(&text);
    }
    return status == THUD_OK && data->suite ? export_suite(data, folder, stem, err) : status;
}
