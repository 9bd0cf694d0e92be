#include "app/paper_study.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/session.h"
#include "app/sweep_jobs.h"
#include "app/sweep_table.h"

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
    struct thud_sweep_collector collector;
    int nrecords;
    struct thud_record *record[RECORDS_MAX];
    const char *name[RECORDS_MAX];
    char text[RECORDS_MAX][THUD_TEXT_MAX]; /* file names, for names */
    struct thud_paper_record about[RECORDS_MAX];
};

/* ---- ground motions ---- */

/* The i-th part between commas; false past the last. */
static bool part(const char *list, int i, char *text, size_t size)
{
    for (; i > 0 && list; i--) {
        list = strchr(list, ',');
        if (list)
            list++;
    }
    if (!list)
        return false;
    size_t n = strcspn(list, ",");
    while (n > 0 && *list == ' ') {
        list++;
        n--;
    }
    snprintf(text, size, "%.*s", (int)(n < size ? n : size - 1), list);
    return true;
}

static enum thud_status assign(struct thud_session *session, const char *key, const char *value, struct thud_error *err)
{
    char text[THUD_TEXT_MAX + 32];
    snprintf(text, sizeof text, "%s=%s", key, value);
    return thud_session_assign(session, text, err);
}

/* What was asked for about file number i. */
static enum thud_status choose(struct thud_paper_work *work, const struct thud_paper_request *request, int i,
                               struct thud_error *err)
{
    char peak[64] = "-";
    enum thud_status status = THUD_OK;
    thud_session_choose_record(&work->session, work->text[i]);
    if (request->peaks && !part(request->peaks, i, peak, sizeof peak))
        return thud_error_set(err, THUD_USAGE, "--peak has fewer parts than --records has files");
    if (!request->peaks && i < TABLE_2)
        snprintf(peak, sizeof peak, "%s", shipped[i].peak);
    if (strcmp(peak, "-") != 0)
        status = assign(&work->session, "record.peak", peak, err);
    if (status == THUD_OK && request->dt)
        status = assign(&work->session, "record.dt", request->dt, err);
    if (status == THUD_OK && request->unit)
        status = assign(&work->session, "record.unit", request->unit, err);
    return status;
}

static void describe(struct thud_paper_work *work, int i, bool given)
{
    const struct thud_record *record = work->record[i];
    char *text = work->text[i];
    if (given) { /* the file's name without folders and suffix */
        const char *slash = strrchr(text, '/');
        if (slash)
            memmove(text, slash + 1, strlen(slash + 1) + 1);
    } else
        snprintf(text, sizeof work->text[i], "%s", shipped[i].name);
    char *dot = given ? strrchr(text, '.') : NULL;
    if (dot && dot != text)
        *dot = '\0';
    work->name[i] = text;
    const char *file = strrchr(record->file, '/');
    work->about[i] = (struct thud_paper_record){
        text, file ? file + 1 : record->file, thud_record_peak(record), record->dt_s, record->samples, !given};
}

static enum thud_status read_record(struct thud_paper_work *work, const struct thud_paper_request *request, int i,
                                    struct thud_error *err)
{
    enum thud_status status =
        thud_session_open(&work->session, request->records ? shipped[0].preset : shipped[i].preset, err);
    if (status != THUD_OK)
        return status;
    if (request->records)
        status = choose(work, request, i, err);
    if (status == THUD_OK)
        status = thud_session_read_record(&work->session, err);
    if (status == THUD_OK && !work->session.record)
        status = thud_error_set(err, THUD_INPUT, "the preset %s names no ground motion", shipped[i].preset);
    if (status == THUD_OK) {
        work->record[i] = work->session.record;
        work->session.record = NULL;
        work->nrecords = i + 1;
        describe(work, i, request->records != NULL);
        if (i == 0)
            thud_sweep_plan_init(&work->plan, &work->session.scene);
        work->planned = true;
    }
    thud_session_close(&work->session);
    return status;
}

static enum thud_status read_records(struct thud_paper_work *work, const struct thud_paper_request *request,
                                     struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    char text[THUD_TEXT_MAX];
    for (int i = 0; status == THUD_OK; i++) {
        bool more = request->records ? part(request->records, i, text, sizeof text) : i < TABLE_2;
        if (!more)
            return THUD_OK;
        if (i == RECORDS_MAX)
            return thud_error_set(err, THUD_USAGE, "--records: more than %d files", RECORDS_MAX);
        if (request->records)
            snprintf(work->text[i], sizeof work->text[i], "%s", text);
        status = read_record(work, request, i, err);
    }
    return status;
}

/* ---- the study ---- */

struct taker {
    struct thud_paper_work *work;
    const struct thud_paper_request *request;
};

static enum thud_status take(void *context, struct thud_sweep_point *point, struct thud_error *err)
{
    struct taker *taker = context;
    enum thud_status status = thud_sweep_collector_add(&taker->work->collector, &taker->work->plan, point, err);
    free(point);
    return status;
}

static void progress(void *context, long done, long count, double elapsed_s)
{
    const struct taker *taker = context;
    if (taker->request->progress)
        taker->request->progress(taker->request->context, done, count, elapsed_s);
}

static enum thud_status run(struct thud_paper_work *work, const struct thud_paper_request *request,
                            struct thud_error *err)
{
    struct taker taker = {work, request};
    work->plan.nrecords = work->nrecords;
    work->plan.record = (const struct thud_record *const *)work->record;
    enum thud_status status = thud_sweep_study(&work->plan, true, true, err);
    if (status != THUD_OK)
        return status;
    thud_sweep_collector_init(&work->collector, &work->plan, work->name);
    struct thud_sweep_jobs jobs = {.plan = &work->plan,
                                   .step = 1,
                                   .count = thud_sweep_points(&work->plan),
                                   .threads = request->threads,
                                   .cancel = request->cancel,
                                   .context = &taker,
                                   .take = take,
                                   .progress = progress};
    return thud_sweep_jobs_run(&jobs, err);
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
    *study =
        (struct thud_paper_study){.scene = &work->plan.scene, .table = &work->collector.table, .record = work->about};
    *out = work;
    return THUD_OK;
}

void thud_paper_work_free(struct thud_paper_work *work)
{
    if (!work)
        return;
    thud_sweep_collector_clear(&work->collector);
    if (work->planned)
        thud_sweep_plan_clear(&work->plan);
    for (int i = 0; i < work->nrecords; i++)
        thud_record_free(work->record[i]);
    free(work);
}
