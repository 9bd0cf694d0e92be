#include "app/sweep/sweep_jobs.h"

#include <stdlib.h>

#include "app/run/threads.h"
#include "app/run/timing.h"

/* Points may be finished before an earlier one: AHEAD_LEAST to AHEAD_MOST for each thread, as AHEAD_BYTES allow. Some
 * runs take a hundred times as long as others, and points are taken in their order. */
enum { THREADS_MAX = 256, SLICE = 64, AHEAD_LEAST = 4, AHEAD_MOST = 64, AHEAD_BYTES = 16 << 20 };
static const double show_s = 0.1;

/* A group in use by points that are next to each other. */
struct shared_group {
    long index;
    struct thud_sweep_group *group; /* NULL while it is made */
    int users;
    struct shared_group *next;
};

/* A finished point, and the group that it stands on. */
struct made {
    struct thud_sweep_point *point;
    struct shared_group *group;
};

struct thud_sweep_work {
    struct thud_sweep_jobs jobs;
    pthread_t thread[THREADS_MAX];
    int started; /* of them */
    pthread_mutex_t lock;
    pthread_cond_t room, ready, made; /* for workers; for the taker; for users of a group */
    long next, taken;                 /* counts of points handed out and taken */
    long window;                      /* how far handing out may be ahead */
    struct made *ring;                /* (window) finished points by count % window */
    struct shared_group *groups;
    bool stop;
    enum thud_status status;
    struct thud_error error;
};

static bool cancelled(const struct thud_sweep_work *w)
{
    return w->jobs.cancel && *w->jobs.cancel;
}

static bool stopped(struct thud_sweep_work *w)
{
    pthread_mutex_lock(&w->lock);
    bool stop = w->stop;
    pthread_mutex_unlock(&w->lock);
    return stop || cancelled(w);
}

/* The first failure ends the work. The lock is held. */
static void fail(struct thud_sweep_work *w, enum thud_status status, const struct thud_error *error)
{
    if (w->status == THUD_OK) {
        w->status = status;
        if (error)
            w->error = *error;
    }
    w->stop = true;
    pthread_cond_broadcast(&w->room);
    pthread_cond_broadcast(&w->made);
    pthread_cond_broadcast(&w->ready);
}

static enum thud_status make_group(struct thud_sweep_work *w, long index, struct thud_sweep_group **out,
                                   struct thud_error *err)
{
    bool done = false;
    enum thud_status status = thud_sweep_group_create(w->jobs.plan, index, out, err);
    while (status == THUD_OK && !done) {
        status = thud_sweep_group_advance(*out, SLICE, &done, err);
        if (status == THUD_OK && !done && stopped(w))
            status = THUD_CANCELLED;
    }
    if (status != THUD_OK) {
        thud_sweep_group_free(*out);
        *out = NULL;
    }
    return status;
}

/* Groups that no point to come stands on go. The lock is held. */
static void drop_groups(struct thud_sweep_work *w)
{
    const struct thud_sweep_jobs *jobs = &w->jobs;
    long least = (jobs->first + w->next * jobs->step) / thud_sweep_points_per_group(jobs->plan);
    for (struct shared_group **p = &w->groups; *p;) {
        struct shared_group *b = *p;
        if (b->users > 0 || (b->index >= least && w->next < jobs->count)) {
            p = &b->next;
            continue;
        }
        *p = b->next;
        thud_sweep_group_free(b->group);
        free(b);
    }
}

/* Makes a group that is not among them; NULL when out of memory. The lock is held before and after. */
static struct shared_group *add_group(struct thud_sweep_work *w, long index, enum thud_status *status,
                                      struct thud_error *err)
{
    struct thud_sweep_group *group = NULL;
    struct shared_group *b = calloc(1, sizeof *b);
    *status = THUD_MEMORY;
    if (!b)
        return NULL;
    *b = (struct shared_group){.index = index, .users = 1, .next = w->groups};
    w->groups = b;
    pthread_mutex_unlock(&w->lock);
    *status = make_group(w, index, &group, err);
    pthread_mutex_lock(&w->lock);
    b->group = group;
    return b;
}

/* While another thread makes the group `awaited`: makes the one after it, if there is none yet. An error is left to
 * those who need it. The lock is held before and after. */
static bool make_next_group(struct thud_sweep_work *w, long awaited)
{
    const struct thud_sweep_jobs *jobs = &w->jobs;
    const long per_group = thud_sweep_points_per_group(jobs->plan),
               i = ((awaited + 1) * per_group - jobs->first + jobs->step - 1) / jobs->step;
    struct thud_error error = {0};
    enum thud_status status;
    if (i >= jobs->count)
        return false;
    for (const struct shared_group *b = w->groups; b; b = b->next)
        if (b->index > awaited)
            return false;
    struct shared_group *made = add_group(w, (jobs->first + i * jobs->step) / per_group, &status, &error);
    if (!made)
        return false;
    if (status != THUD_OK && made->users > 1)
        fail(w, status, &error);
    made->users--;
    if (!made->group && made->users == 0) {
        struct shared_group **p = &w->groups;
        while (*p != made)
            p = &(*p)->next;
        *p = made->next;
        free(made);
    }
    pthread_cond_broadcast(&w->made);
    return true;
}

/* The group of a point, made by the first who needs it; NULL when the work stops. The lock is held before and after. */
static struct shared_group *borrow(struct thud_sweep_work *w, long index)
{
    struct shared_group *b = w->groups;
    while (b && b->index != index)
        b = b->next;
    if (b) {
        b->users++;
        while (!b->group && !w->stop)
            if (!make_next_group(w, index))
                pthread_cond_wait(&w->made, &w->lock);
    } else {
        struct thud_error error = {0};
        enum thud_status status;
        b = add_group(w, index, &status, &error);
        if (status != THUD_OK)
            fail(w, status, b ? &error : NULL);
        pthread_cond_broadcast(&w->made);
    }
    if (b && b->group)
        return b;
    if (b)
        b->users--;
    return NULL;
}

static enum thud_status make_point(struct thud_sweep_work *w, const struct thud_sweep_group *group, long index,
                                   struct thud_sweep_point **out, struct thud_error *err)
{
    struct thud_sweep_task *task;
    bool done = false;
    enum thud_status status = thud_sweep_task_create(w->jobs.plan, group, index, &task, err);
    if (status == THUD_OK)
        thud_sweep_task_leave(task, w->jobs.first, w->jobs.step);
    while (status == THUD_OK && !done) {
        status = thud_sweep_task_advance(task, SLICE * 16, &done, err);
        if (status == THUD_OK && !done && stopped(w))
            status = THUD_CANCELLED;
    }
    if (status == THUD_OK)
        *out = thud_sweep_task_take(task);
    thud_sweep_task_free(task);
    return status;
}

static void *worker(void *context)
{
    struct thud_sweep_work *w = context;
    const struct thud_sweep_jobs *jobs = &w->jobs;
    long per_group = thud_sweep_points_per_group(jobs->plan);
    locale_t before = thud_threads_numbers();
    pthread_mutex_lock(&w->lock);
    for (;;) {
        while (!w->stop && w->next < jobs->count && w->next >= w->taken + w->window)
            pthread_cond_wait(&w->room, &w->lock);
        if (w->stop || w->next >= jobs->count)
            break;
        long i = w->next++, index = jobs->first + i * jobs->step;
        struct shared_group *group = borrow(w, index / per_group);
        if (!group)
            break;
        pthread_mutex_unlock(&w->lock);
        struct thud_error error = {0};
        struct thud_sweep_point *point = NULL;
        enum thud_status status = make_point(w, group->group, index, &point, &error);
        pthread_mutex_lock(&w->lock);
        if (status != THUD_OK) {
            fail(w, status, &error);
            break;
        }
        w->ring[i % w->window] = (struct made){point, group};
        if (i == w->taken)
            pthread_cond_signal(&w->ready);
    }
    pthread_mutex_unlock(&w->lock);
    thud_threads_numbers_back(before);
    return NULL;
}

/* How far handing out may be ahead of taking. */
static long window_of(const struct thud_sweep_plan *plan, int threads)
{
    const size_t runs = (size_t)(plan->sensitivity > 0 ? THUD_SWEEP_VARIANTS : 1) * (size_t)(plan->ncases + 2);
    size_t floors = 1;
    for (int s = 0; s < plan->scene.nstructures; s++)
        floors += (size_t)plan->scene.structure[s].storeys;
    const size_t bytes = runs * floors * (sizeof(struct thud_sweep_floor) + sizeof(struct thud_sweep_contact));
    long ahead = (long)(AHEAD_BYTES / bytes) / threads;
    ahead = ahead > AHEAD_MOST ? AHEAD_MOST : ahead < AHEAD_LEAST ? AHEAD_LEAST : ahead;
    return ahead * threads + AHEAD_LEAST;
}

enum thud_status thud_sweep_work_start(const struct thud_sweep_jobs *jobs, struct thud_sweep_work **out,
                                       struct thud_error *err)
{
    int threads = thud_threads_count(jobs->threads, jobs->count, THREADS_MAX);
    struct thud_sweep_work *w = calloc(1, sizeof *w);
    *out = NULL;
    if (w) {
        w->jobs = *jobs;
        w->window = window_of(jobs->plan, threads);
        w->ring = calloc((size_t)w->window, sizeof(struct made));
    }
    if (!w || !w->ring) {
        free(w);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    pthread_mutex_init(&w->lock, NULL);
    pthread_cond_init(&w->room, NULL);
    pthread_cond_init(&w->ready, NULL);
    pthread_cond_init(&w->made, NULL);
    w->started = thud_threads_start(w->thread, threads, worker, w);
    if (w->started == 0 && jobs->count > 0) {
        thud_sweep_work_end(w);
        return thud_error_set(err, THUD_MEMORY, "no thread could be started");
    }
    *out = w;
    return THUD_OK;
}

/* Why the work stopped. */
static enum thud_status failure(const struct thud_sweep_work *w, struct thud_error *err)
{
    if (w->status == THUD_CANCELLED)
        return thud_error_set(err, THUD_CANCELLED, "stopped");
    if (w->status == THUD_MEMORY && !w->error.what[0])
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    if (err)
        *err = w->error;
    return w->status;
}

/* What the point shares with others is settled in the order of points. The lock is held. */
static void take_result(struct thud_sweep_work *w, struct made *made)
{
    struct thud_error error = {0};
    enum thud_status status = thud_sweep_group_settle(made->group->group, made->point, &error);
    if (status != THUD_OK) {
        fail(w, status, &error);
        return;
    }
    made->group->users--;
    drop_groups(w);
}

enum thud_status thud_sweep_work_take(struct thud_sweep_work *w, double wait_s, struct thud_sweep_point **point,
                                      bool *done, struct thud_error *err)
{
    *point = NULL;
    pthread_mutex_lock(&w->lock);
    struct made *slot = &w->ring[w->taken % w->window];
    *done = w->taken >= w->jobs.count;
    if (!*done && cancelled(w))
        fail(w, THUD_CANCELLED, NULL);
    if (!*done && !w->stop && !slot->point && wait_s > 0)
        thud_threads_wait(&w->ready, &w->lock, wait_s);
    if (!*done && !w->stop && slot->point)
        take_result(w, slot);
    if (!*done && !w->stop && slot->point) {
        *point = slot->point;
        slot->point = NULL;
        w->taken++;
        *done = w->taken >= w->jobs.count;
        pthread_cond_broadcast(&w->room);
    }
    enum thud_status status = w->status == THUD_OK ? THUD_OK : failure(w, err);
    pthread_mutex_unlock(&w->lock);
    return status;
}

void thud_sweep_work_end(struct thud_sweep_work *w)
{
    if (!w)
        return;
    pthread_mutex_lock(&w->lock);
    w->stop = true;
    pthread_cond_broadcast(&w->room);
    pthread_cond_broadcast(&w->made);
    pthread_mutex_unlock(&w->lock);
    for (int i = 0; i < w->started; i++)
        pthread_join(w->thread[i], NULL);
    for (long i = 0; i < w->window; i++)
        free(w->ring[i].point);
    for (struct shared_group *b = w->groups; b; b = b->next)
        b->users = 0;
    w->next = w->jobs.count;
    drop_groups(w);
    pthread_cond_destroy(&w->made);
    pthread_cond_destroy(&w->ready);
    pthread_cond_destroy(&w->room);
    pthread_mutex_destroy(&w->lock);
    free(w->ring);
    free(w);
}

enum thud_status thud_sweep_jobs_run(const struct thud_sweep_jobs *jobs, struct thud_error *err)
{
    struct thud_sweep_work *w;
    enum thud_status status = thud_sweep_work_start(jobs, &w, err);
    double start = thud_timing_now_s(), shown = 0;
    long taken = 0;
    for (bool done = jobs->count <= 0; status == THUD_OK && !done;) {
        struct thud_sweep_point *point;
        status = thud_sweep_work_take(w, show_s, &point, &done, err);
        if (point) {
            status = jobs->take(jobs->context, point, err);
            taken++;
        }
        double elapsed = thud_timing_now_s() - start;
        if (jobs->progress && (elapsed - shown >= show_s || taken == jobs->count)) {
            shown = elapsed;
            jobs->progress(jobs->context, taken, jobs->count, elapsed);
        }
    }
    thud_sweep_work_end(w);
    return status;
}

/* ---- the runs of a suite ---- */

static enum thud_status add_to_suite(void *context, struct thud_sweep_point *point, struct thud_error *err)
{
    enum thud_status status = thud_suite_add(context, point, err);
    free(point);
    return status;
}

enum thud_status thud_sweep_suite_run(const struct thud_sweep_plan *plan, int threads, const atomic_int *cancel,
                                      struct thud_suite **out, struct thud_error *err)
{
    enum thud_status status = thud_suite_create(plan, out, err);
    const struct thud_sweep_jobs jobs = {.plan = plan,
                                         .step = 1,
                                         .count = thud_sweep_points(plan),
                                         .threads = threads,
                                         .cancel = cancel,
                                         .context = *out,
                                         .take = add_to_suite};
    return status == THUD_OK ? thud_sweep_jobs_run(&jobs, err) : status;
}
