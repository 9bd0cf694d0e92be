/* The jobs of a stability study in threads: each writes a row of its own. */
#include <stdatomic.h>

#include "app/run/threads.h"
#include "lab/bench/stability_report.h"

enum { THREADS_MAX = 64 };

struct work {
    struct thud_stability *stability;
    const atomic_int *cancel;
    atomic_int next, done, running, stopped;
    pthread_mutex_t lock; /* of what follows */
    pthread_cond_t changed;
    enum thud_status status;
    struct thud_error error;
};

static void *advance(void *context)
{
    struct work *w = context;
    const locale_t before = thud_threads_numbers();
    const int jobs = thud_stability_jobs(w->stability);
    for (int job; !w->stopped && !*w->cancel && (job = atomic_fetch_add(&w->next, 1)) < jobs;) {
        struct thud_error error = {0};
        const enum thud_status status = thud_stability_job(w->stability, job, &error);
        pthread_mutex_lock(&w->lock);
        if (status != THUD_OK && !w->stopped) {
            w->stopped = 1;
            w->status = status;
            w->error = error;
        }
        w->done++;
        pthread_mutex_unlock(&w->lock);
    }
    thud_threads_numbers_back(before);
    pthread_mutex_lock(&w->lock);
    w->running--;
    pthread_cond_signal(&w->changed);
    pthread_mutex_unlock(&w->lock);
    return NULL;
}

enum thud_status thud_stability_run(struct thud_stability *stability, const atomic_int *cancel,
                                    void (*progress)(int done, int jobs), struct thud_error *err)
{
    struct work w = {.stability = stability, .cancel = cancel};
    const int jobs = thud_stability_jobs(stability);
    pthread_t thread[THREADS_MAX];
    pthread_mutex_init(&w.lock, NULL);
    pthread_cond_init(&w.changed, NULL);
    const int wanted = thud_threads_count(0, jobs, THREADS_MAX);
    w.running = wanted;
    const int started = thud_threads_start(thread, wanted, advance, &w);
    atomic_fetch_sub(&w.running, wanted - started);
    if (started == 0) {
        w.running = 1;
        advance(&w);
    }
    pthread_mutex_lock(&w.lock);
    while (w.running > 0) {
        thud_threads_wait(&w.changed, &w.lock, 0.2);
        progress(w.done, jobs);
    }
    pthread_mutex_unlock(&w.lock);
    for (int i = 0; i < started; i++)
        pthread_join(thread[i], NULL);
    pthread_cond_destroy(&w.changed);
    pthread_mutex_destroy(&w.lock);
    if (w.status == THUD_OK && w.done < jobs)
        return thud_error_set(err, THUD_CANCELLED, "stopped");
    if (w.status != THUD_OK && err)
        *err = w.error;
    return w.status;
}
