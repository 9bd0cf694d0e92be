#include "lab/paper/paper_report.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/record_list.h"
#include "app/run/session.h"
#include "app/sweep/sweep_collector.h"
#include "app/sweep/sweep_jobs.h"

enum { RECORDS_MAX = 32, TABLE_2 = 3 };

static const struct {
    const char *preset, *name, *peak; /* peak: Table 2 of the paper */
} shipped[TABLE_2] = {{"towers", "Kobe surrogate", "0.821 g"},
                      {"towers-northridge", "Northridge surrogate", "0.897 g"},
                      {"towers-san-fernando", "San Fernando surrogate", "1.170 g"}};

struct thud_paper_work {
    struct thud_session session; /* of one record after the other */
    struct thud_sweep_plan plan;
    bool planned;
    struct thud_sweep_collector collector, turned;
    struct thud_paper_runs runs[2]; /* beside it, for the report */
    int nrecords, unanswered;
    struct thud_record *record[RECORDS_MAX], *back[RECORDS_MAX]; /* as given, and reversed */
    const char *name[RECORDS_MAX];
    char text[RECORDS_MAX][512]; /* names */
    struct thud_paper_record about[RECORDS_MAX];
};

/* ---- ground motions ---- */

/* The list with the peaks of Table 2 for those of the first three files that have none of their own. */
static void with_peaks(const struct thud_paper_request *request, struct thud_text *out)
{
    const char *item = request->records;
    for (int i = 0; item; i++) {
        size_t n = strcspn(item, ",");
        struct thud_text one = {0};
        thud_text_bytes(&one, item, n);
        bool scaled =
            request->peak || i >= TABLE_2 || one.failed || strstr(one.data, ":peak=") || strstr(one.data, ":factor=");
        thud_text_append(out, "%s%s", i ? "," : "", one.data ? one.data : "");
        if (!scaled)
            thud_text_append(out, ":peak=%s", shipped[i].peak);
        out->failed |= one.failed;
        thud_text_clear(&one);
        item = item[n] ? item + n + 1 : NULL;
    }
}

/* Hands the records of a list over; those past RECORDS_MAX are refused. */
static enum thud_status keep_records(struct thud_paper_work *work, struct thud_record_list *list,
                                     struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < list->n && status == THUD_OK; i++) {
        if (work->nrecords == RECORDS_MAX) {
            status = thud_error_set(err, THUD_USAGE, "--records: more than %d files", RECORDS_MAX);
            continue;
        }
        work->record[work->nrecords++] = list->record[i];
        list->record[i] = NULL;
    }
    thud_record_list_clear(list);
    return status;
}

static enum thud_status given_records(struct thud_paper_work *work, const struct thud_paper_request *request,
                                      struct thud_error *err)
{
    const char *common[3][2];
    int n = 0;
    struct thud_text text = {0};
    struct thud_record_list list = {0};
    const char *const setting[3][2] = {{"peak", request->peak}, {"dt", request->dt}, {"unit", request->unit}};
    for (int i = 0; i < 3; i++) {
        common[n][0] = setting[i][0];
        common[n][1] = setting[i][1];
        n += setting[i][1] != NULL;
    }
    with_peaks(request, &text);
    enum thud_status status = text.failed
                                  ? thud_error_set(err, THUD_MEMORY, "out of memory")
                                  : thud_record_list_read(&work->session, text.data, common, n, false, &list, err);
    thud_text_clear(&text);
    return status == THUD_OK ? keep_records(work, &list, err) : status;
}

/* Opens a preset; the first one's scene is that of the study. */
static enum thud_status open_preset(struct thud_paper_work *work, int i, const struct thud_paper_request *request,
                                    struct thud_error *err)
{
    struct thud_record_list list = {0};
    enum thud_status status = thud_session_open(&work->session, shipped[i].preset, err);
    if (status != THUD_OK)
        return status;
    if (i == 0) {
        thud_sweep_plan_init(&work->plan, &work->session.scene);
        work->planned = true;
    }
    if (request->records)
        status = given_records(work, request, err);
    else {
        status = thud_record_list_own(&work->session, false, &list, err);
        if (status == THUD_OK && list.n == 0)
            status = thud_error_set(err, THUD_INPUT, "the preset %s names no ground motion", shipped[i].preset);
        if (status == THUD_OK)
            status = keep_records(work, &list, err);
    }
    thud_session_close(&work->session);
    return status;
}

/* Name as shown: the file's without folders and suffix. */
static void describe(struct thud_paper_work *work, int i, bool given)
{
    const struct thud_record *record = work->record[i];
    const char *file = thud_path_name(record->file);
    snprintf(work->text[i], sizeof work->text[i], "%s", given ? file : shipped[i].name);
    char *dot = given ? strrchr(work->text[i], '.') : NULL;
    if (dot && dot != work->text[i])
        *dot = '\0';
    work->name[i] = work->text[i];
    work->about[i] = (struct thud_paper_record){work->text[i],   file,          thud_record_peak(record), record->dt_s,
                                                record->samples, record->scale, record->synthetic};
}

static enum thud_status read_records(struct thud_paper_work *work, const struct thud_paper_request *request,
                                     struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < (request->records ? 1 : TABLE_2) && status == THUD_OK; i++)
        status = open_preset(work, i, request, err);
    for (int i = 0; i < work->nrecords && status == THUD_OK; i++)
        describe(work, i, request->records != NULL);
    return status;
}

/* ---- the study ---- */

struct taker {
    struct thud_paper_work *work;
    const struct thud_paper_request *request;
    struct thud_sweep_collector *to;
    long before; /* points of the half that is done */
};

static enum thud_status collect_point(void *context, struct thud_sweep_point *point, struct thud_error *err)
{
    struct taker *taker = context;
    enum thud_status status = thud_sweep_collector_add(taker->to, &taker->work->plan, point, err);
    for (int i = 0; i < point->ncases; i++)
        taker->work->unanswered += point->effort[i].status == THUD_DIVERGED;
    free(point);
    return status;
}

static void progress(void *context, long done, long count, double elapsed_s)
{
    const struct taker *taker = context;
    if (taker->request->progress)
        taker->request->progress(taker->request->context, taker->before + done,
                                 taker->request->both_signs ? 2 * count : count, elapsed_s);
}

static enum thud_status turn_round(struct thud_paper_work *work, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < work->nrecords && status == THUD_OK; i++) {
        const struct thud_record *record = work->record[i];
        status = thud_record_create(record->a_mps2, record->samples, record->dt_s, &work->back[i], err);
        if (status == THUD_OK) {
            memcpy(work->back[i]->file, record->file, sizeof record->file);
            thud_record_scale(work->back[i], -1);
        }
    }
    return status;
}

static enum thud_status run_half(struct thud_paper_work *work, const struct thud_paper_request *request, bool turned,
                                 struct thud_error *err)
{
    struct taker taker = {.work = work, .request = request, .to = turned ? &work->turned : &work->collector};
    long count = thud_sweep_points(&work->plan);
    taker.before = turned ? count : 0;
    work->plan.record = (const struct thud_record *const *)(turned ? work->back : work->record);
    thud_sweep_collector_init(taker.to, &work->plan, work->name);
    struct thud_sweep_jobs jobs = {.plan = &work->plan,
                                   .step = 1,
                                   .count = count,
                                   .threads = request->threads,
                                   .cancel = request->cancel,
                                   .context = &taker,
                                   .take = collect_point,
                                   .progress = progress};
    return thud_sweep_jobs_run(&jobs, err);
}

static enum thud_status run(struct thud_paper_work *work, const struct thud_paper_request *request,
                            struct thud_error *err)
{
    work->plan.nrecords = work->nrecords;
    work->plan.record = (const struct thud_record *const *)work->record;
    enum thud_status status = thud_sweep_study(&work->plan, true, true, err);
    if (status == THUD_OK)
        status = run_half(work, request, false, err);
    if (status == THUD_OK && request->both_signs)
        status = turn_round(work, err);
    if (status == THUD_OK && request->both_signs)
        status = run_half(work, request, true, err);
    for (int i = 0; i < 2 && status == THUD_OK && request->both_signs; i++)
        status = thud_paper_runs_make(
            &work->plan.scene, (const struct thud_record *const *)(i ? work->back : work->record), work->name[0],
            &(struct thud_sweep_jobs){.threads = request->threads, .cancel = request->cancel}, &work->runs[i], err);
    return status;
}

enum thud_status thud_paper_work_make(const struct thud_paper_request *request, struct thud_paper_work **out,
                                      struct thud_paper_study *study, struct thud_error *err)
{
    struct thud_paper_work *work = calloc(1, sizeof *work);
    *out = NULL;
    if (!work)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = read_records(work, request, err);
    if (status == THUD_OK)
        status = run(work, request, err);
    if (status != THUD_OK) {
        thud_paper_work_free(work);
        return status;
    }
    *study = (struct thud_paper_study){.scene = &work->plan.scene,
                                       .table = &work->collector.table,
                                       .turned = request->both_signs ? &work->turned.table : NULL,
                                       .runs = request->both_signs ? work->runs : NULL,
                                       .record = work->about,
                                       .unanswered = work->unanswered};
    *out = work;
    return THUD_OK;
}

void thud_paper_work_free(struct thud_paper_work *work)
{
    if (!work)
        return;
    thud_sweep_collector_clear(&work->collector);
    thud_sweep_collector_clear(&work->turned);
    for (int i = 0; i < 2; i++)
        thud_paper_runs_clear(&work->runs[i]);
    if (work->planned)
        thud_sweep_plan_clear(&work->plan);
    for (int i = 0; i < work->nrecords; i++) {
        thud_record_free(work->record[i]);
        thud_record_free(work->back[i]);
    }
    free(work);
}
