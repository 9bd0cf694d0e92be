#include "app/run/threads.h"

#include <signal.h>
#include <time.h>
#include <unistd.h>

#include "app/run/timing.h"

int thud_threads_count(int wanted, long jobs, int most)
{
    long n = wanted > 0 ? wanted : sysconf(_SC_NPROCESSORS_ONLN);
    if (n > jobs)
        n = jobs;
    return n < 1 ? 1 : n > most ? most : (int)n;
}

int thud_threads_start(pthread_t *thread, int wanted, void *(*work)(void *context), void *context)
{
    static const int fault[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
    sigset_t all, before;
    int started = 0;
    sigfillset(&all);
    for (size_t i = 0; i < sizeof fault / sizeof *fault; i++)
        sigdelset(&all, fault[i]);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    while (started < wanted && pthread_create(&thread[started], NULL, work, context) == 0)
        started++;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return started;
}

void thud_threads_wait(pthread_cond_t *cond, pthread_mutex_t *lock, double seconds)
{
    struct timespec until;
    clock_gettime(CLOCK_REALTIME, &until);
    until.tv_nsec += (long)(1e9 * seconds);
    until.tv_sec += until.tv_nsec / 1000000000L;
    until.tv_nsec %= 1000000000L;
    pthread_cond_timedwait(cond, lock, &until);
}

locale_t thud_threads_numbers(void)
{
    return uselocale(newlocale(LC_ALL_MASK, "C", (locale_t)0));
}

void thud_threads_numbers_back(locale_t before)
{
    locale_t own = uselocale(before);
    if (own != before)
        freelocale(own);
}

/* ---- jobs ---- */

struct work {
    const struct thud_threads_jobs *jobs;
    pthread_mutex_t lock; /* of what follows */
    pthread_cond_t changed;
    long next, done;
    int running; /* threads */
    enum thud_status status;
    struct thud_error error;
};

static void *do_jobs(void *context)
{
    struct work *w = context;
    const struct thud_threads_jobs *jobs = w->jobs;
    const locale_t before = thud_threads_numbers();
    pthread_mutex_lock(&w->lock);
    while (w->status == THUD_OK && w->next < jobs->n && !(jobs->cancel && *jobs->cancel)) {
        const long i = w->next++;
        struct thud_error error = {0};
        pthread_mutex_unlock(&w->lock);
        enum thud_status status = jobs->job(jobs->context, i, &error);
        pthread_mutex_lock(&w->lock);
        w->done++;
        if (status == THUD_OK && w->status == THUD_OK && jobs->take)
            status = jobs->take(jobs->context, i, &error);
        if (status != THUD_OK && w->status == THUD_OK) {
            w->status = status;
            w->error = error;
        }
    }
    w->running--;
    pthread_cond_signal(&w->changed);
    pthread_mutex_unlock(&w->lock);
    thud_threads_numbers_back(before);
    return NULL;
}

enum thud_status thud_threads_run(const struct thud_threads_jobs *jobs, long *done, struct thud_error *err)
{
    enum { THREADS_MAX = 256 };
    static const double show_s = 0.1;
    struct work w = {.jobs = jobs, .next = jobs->first, .done = jobs->first};
    pthread_t thread[THREADS_MAX];
    const double start = thud_timing_now_s();
    pthread_mutex_init(&w.lock, NULL);
    pthread_cond_init(&w.changed, NULL);
    const int wanted = thud_threads_count(jobs->threads, jobs->n - jobs->first, THREADS_MAX);
    w.running = wanted;
    const int started = thud_threads_start(thread, wanted, do_jobs, &w);
    pthread_mutex_lock(&w.lock);
    w.running -= wanted - started;
    while (w.running > 0) {
        const long now = w.done;
        pthread_mutex_unlock(&w.lock);
        if (jobs->progress)
            jobs->progress(jobs->context, now, jobs->n, thud_timing_now_s() - start);
        pthread_mutex_lock(&w.lock);
        if (w.running > 0)
            thud_threads_wait(&w.changed, &w.lock, show_s);
    }
    w.running = 1;
    pthread_mutex_unlock(&w.lock);
    for (int i = 0; i < started; i++)
        pthread_join(thread[i], NULL);
    if (started == 0) /* the calling one then */
        do_jobs(&w);
    pthread_cond_destroy(&w.changed);
    pthread_mutex_destroy(&w.lock);
    if (done)
        *done = w.done;
    if (w.status == THUD_OK && w.done < jobs->n)
        return thud_error_set(err, THUD_CANCELLED, "stopped");
    if (w.status != THUD_OK && err)
        *err = w.error;
    return w.status;
}
