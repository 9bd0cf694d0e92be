#include "app/run/live_work.h"

#include <assert.h>
#include <stdlib.h>

#include "app/run/threads.h"

enum { SEGMENTS = 50 }; /* between two looks at the lock: some tenths of a millisecond */

struct job {
    struct thud_live_job what;
    double time_s;
    bool ended, taken;
    enum thud_status status;
    struct thud_error error;
};

struct thud_live_work {
    struct job job[THUD_LIVE_JOBS];
    int n, next; /* count, and the first that nobody computes */
    pthread_t thread[THUD_LIVE_JOBS];
    int threads;
    pthread_mutex_t lock; /* guards `next`, `stop` and what stands in a job beside `what` */
    pthread_cond_t ended;
    bool stop;
};

/* A short while of a job. The lock is not held. */
static enum thud_status slice(const struct thud_live_job *job, bool *done, struct thud_error *err)
{
    return job->run ? thud_run_advance(job->run, SEGMENTS, done, err)
                    : thud_baseline_advance(job->baseline, SEGMENTS, done, err);
}

/* Goes on with a job; true: it has ended. The lock is held before and after. */
static bool advance(struct thud_live_work *work, struct job *job)
{
    bool done = false;
    struct thud_error error = {0};
    pthread_mutex_unlock(&work->lock);
    enum thud_status status = slice(&job->what, &done, &error);
    double time_s = job->what.run ? thud_run_time(job->what.run) : 0.0;
    pthread_mutex_lock(&work->lock);
    job->time_s = time_s;
    job->ended = done || status != THUD_OK;
    if (job->ended) {
        job->status = status;
        job->error = error;
        pthread_cond_signal(&work->ended);
    }
    return job->ended;
}

static void *worker(void *context)
{
    struct thud_live_work *work = context;
    pthread_mutex_lock(&work->lock);
    while (!work->stop && work->next < work->n) {
        struct job *job = &work->job[work->next++];
        while (!work->stop && !advance(work, job))
            ;
    }
    pthread_mutex_unlock(&work->lock);
    return NULL;
}

enum thud_status thud_live_work_start(const struct thud_live_job *job, int n, int threads, struct thud_live_work **out,
                                      struct thud_error *err)
{
    assert(n <= THUD_LIVE_JOBS);
    struct thud_live_work *work = calloc(1, sizeof *work);
    *out = work;
    if (!work)
        return thud_error_set(err, THUD_MEMORY, "no memory for the runs");
    work->n = n;
    for (int i = 0; i < n; i++)
        work->job[i].what = job[i];
    pthread_mutex_init(&work->lock, NULL);
    pthread_cond_init(&work->ended, NULL);
    if (threads >= 0)
        work->threads = thud_threads_start(work->thread, thud_threads_count(threads, n, THUD_LIVE_JOBS), worker, work);
    return THUD_OK;
}

/* A job that has ended and was not taken back; -1: there is none. The lock is held. */
static int find_ended(const struct thud_live_work *work)
{
    for (int i = 0; i < work->n; i++)
        if (work->job[i].ended && !work->job[i].taken)
            return i;
    return -1;
}

int thud_live_work_take(struct thud_live_work *work, double wait_s, int *left, enum thud_status *status,
                        struct thud_error *err)
{
    pthread_mutex_lock(&work->lock);
    int index = find_ended(work);
    if (index < 0 && work->threads > 0)
        thud_threads_wait(&work->ended, &work->lock, wait_s);
    else if (index < 0 && work->next < work->n)
        work->next += advance(work, &work->job[work->next]);
    if (index < 0)
        index = find_ended(work);
    if (index >= 0) {
        work->job[index].taken = true;
        *status = work->job[index].status;
        *err = work->job[index].error;
    }
    *left = 0;
    for (int i = 0; i < work->n; i++)
        *left += !work->job[i].taken;
    pthread_mutex_unlock(&work->lock);
    return index;
}

double thud_live_work_time(struct thud_live_work *work, int index)
{
    pthread_mutex_lock(&work->lock);
    double time_s = work->job[index].time_s;
    pthread_mutex_unlock(&work->lock);
    return time_s;
}

void thud_live_work_end(struct thud_live_work *work)
{
    if (!work)
        return;
    pthread_mutex_lock(&work->lock);
    work->stop = true;
    pthread_mutex_unlock(&work->lock);
    for (int i = 0; i < work->threads; i++)
        pthread_join(work->thread[i], NULL);
    pthread_cond_destroy(&work->ended);
    pthread_mutex_destroy(&work->lock);
    free(work);
}
