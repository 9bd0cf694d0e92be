#include "app/sweep/sweep_study.h"

#include <stdlib.h>
#include <string.h>

#include "app/sweep/sweep_study_private.h"
#include "io/file/file.h"

struct making {
    const struct thud_sweep_study *study;
    struct thud_sweep_journal *journal;
    struct thud_sweep_outcome *out;
};

static enum thud_status deliver_point(void *context, struct thud_sweep_point *point, struct thud_error *err)
{
    struct making *m = context;
    enum thud_status status = m->journal ? thud_sweep_journal_add(m->journal, point, err)
                                         : thud_sweep_study_deliver(m->study, point, m->out, err);
    free(point);
    return status;
}

static void show(void *context, long done, long count, double elapsed_s)
{
    const struct making *m = context;
    if (m->study->progress)
        m->study->progress(m->study->context, done, count, elapsed_s);
}

enum thud_status thud_sweep_outcome_init(const struct thud_sweep_plan *plan, struct thud_sweep_outcome *out,
                                         struct thud_error *err)
{
    int n = plan->nrecords > 0 ? plan->nrecords : 1;
    memset(out, 0, sizeof *out);
    thud_sweep_total_init(&out->total);
    out->names = calloc((size_t)n, sizeof *out->names);
    if (!out->names)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < n; i++)
        out->names[i] = i < plan->nrecords && plan->record[i] ? thud_path_name(plan->record[i]->file) : "";
    thud_sweep_collector_init(&out->rows, plan, out->names);
    return THUD_OK;
}

void thud_sweep_outcome_clear(struct thud_sweep_outcome *outcome)
{
    thud_sweep_collector_clear(&outcome->rows);
    free(outcome->names);
    outcome->names = NULL;
}

/* What a stopped study leaves, in words. */
static enum thud_status stopped(const struct thud_sweep_study *study, long done, long count, struct thud_error *err)
{
    thud_error_set(err, THUD_CANCELLED, "stopped: %ld of %ld points are done, %ld are missing", done, count,
                   count - done);
    if (study->folder)
        thud_error_allow(err, "the same command goes on from there");
    return THUD_CANCELLED;
}

static enum thud_status make(struct making *m, long done, struct thud_error *err)
{
    const struct thud_sweep_study *study = m->study;
    long count = thud_sweep_shard_points(study->plan, study->shard);
    struct thud_sweep_jobs jobs = {.plan = study->plan,
                                   .first = thud_sweep_shard_point(study->shard, done),
                                   .step = study->shard.count,
                                   .count = count - done,
                                   .threads = study->threads,
                                   .cancel = study->cancel,
                                   .context = m,
                                   .take = deliver_point,
                                   .progress = show};
    enum thud_status status = done < count ? thud_sweep_jobs_run(&jobs, err) : THUD_OK;
    if (status == THUD_CANCELLED) {
        long now = m->journal ? thud_sweep_journal_done(m->journal) : m->out->total.points;
        return stopped(study, now, count, err);
    }
    return status;
}

/* The folder is ours. */
static enum thud_status make_in_folder(struct making *m, struct thud_error *err)
{
    const struct thud_sweep_study *study = m->study;
    long done = 0;
    enum thud_status status = study->by ? thud_made_by_enter(study->by, err) : THUD_OK;
    if (status == THUD_OK)
        status = thud_sweep_journal_open(study->folder, study->plan, study->preset, study->shard,
                                         study->by && study->by->replace, &m->journal, &done, err);
    if (status != THUD_OK)
        return status;
    if (study->description && (study->description->size > 0 || study->description->failed))
        status = thud_text_save(study->description, study->folder, THUD_SWEEP_STUDY_FILE, status, err);
    if (status == THUD_OK)
        status = make(m, done, err);
    bool whole = status == THUD_OK && study->shard.count == 1;
    if (whole)
        status = thud_sweep_study_finish(study, &m->journal, 1, m->out, err);
    if (whole && status == THUD_OK && study->by)
        status = thud_made_by_keep(study->by, err);
    thud_sweep_journal_close(m->journal, whole && status == THUD_OK);
    return status;
}

enum thud_status thud_sweep_study_run(const struct thud_sweep_study *study, struct thud_sweep_outcome *out,
                                      struct thud_error *err)
{
    struct making m = {.study = study, .out = out};
    enum thud_status status = thud_sweep_outcome_init(study->plan, out, err);
    if (status == THUD_OK)
        status = study->folder ? thud_folder_make(study->folder, err) : make(&m, 0, err);
    if (status == THUD_OK && study->folder) {
        struct thud_folder_lock lock;
        status = thud_folder_lock(study->folder, &lock, err);
        if (status == THUD_OK)
            status = make_in_folder(&m, err);
        thud_folder_unlock(&lock);
    }
    return status;
}
