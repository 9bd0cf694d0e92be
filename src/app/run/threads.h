/* Threads that compute beside the one that called. */
#pragma once

#include <locale.h>
#include <pthread.h>
#include <stdatomic.h>

#include "base/status.h"

/* As many as are wanted (0 or less: one a processor), but no more than there are jobs or than `most`, and at least
 * one. */
int thud_threads_count(int wanted, long jobs, int most);

/* Starts `wanted` threads with all signals blocked, which are for the thread that called, but for those of a fault in
 * the thread itself. Returns how many were started. */
int thud_threads_start(pthread_t *thread, int wanted, void *(*work)(void *context), void *context);

/* Numbers of the calling thread get a decimal point, whatever the program around it has said; returns what they had, to
 * go back to. A new thread has what the program has. */
locale_t thud_threads_numbers(void);
void thud_threads_numbers_back(locale_t before);

/* Waits for `cond` at most so many seconds (less than 1). The lock is held. */
void thud_threads_wait(pthread_cond_t *cond, pthread_mutex_t *lock, double seconds);

/* Jobs `first` to n - 1, begun in their order by several threads. */
struct thud_threads_jobs {
    long first, n;
    int threads;              /* 0: the processors that are online */
    const atomic_int *cancel; /* not NULL: no job begins once it is other than 0 */
    void *context;
    /* Does a job, several at once; an error ends the work. */
    enum thud_status (*job)(void *context, long i, struct thud_error *err);
    /* Takes what one has made, one at a time; may be NULL. */
    enum thud_status (*take)(void *context, long i, struct thud_error *err);
    /* From time to time, from the calling thread; may be NULL. */
    void (*progress)(void *context, long done, long n, double elapsed_s);
};
/* *done: how many are, with those before the first; may be NULL. Errors: those of jobs; THUD_CANCELLED. */
enum thud_status thud_threads_run(const struct thud_threads_jobs *jobs, long *done, struct thud_error *err);
