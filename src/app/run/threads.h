/* Threads that compute beside the one that called. */
#pragma once

#include <locale.h>
#include <pthread.h>

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
