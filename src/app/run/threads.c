#include "app/run/threads.h"

#include <signal.h>
#include <time.h>
#include <unistd.h>

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
