#include "cli/commands.h"

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>
#include <unistd.h>

#include "io/file/file.h"

/* Threads read what the handler sets; C17 (7.14.1.1) lets a handler refer to atomic objects that have no lock. */
_Static_assert(ATOMIC_INT_LOCK_FREE == 2, "a signal handler sets them");
static atomic_int caught, watched;

/* Where nobody looks at the flag, or has not come to it yet, the program ends here, and leaves no file half written. */
static void note(int number)
{
    if (watched && !caught) {
        caught = number;
        return;
    }
    static const char said[] =
        "thud: stopped; no file is half written (a study with -o DIR goes on by the same command)\n";
    thud_file_drop_all();
    const ssize_t written = write(STDERR_FILENO, said, sizeof said - 1); /* stdio is not for a handler */
    (void)written;
    signal(number, SIG_DFL);
    raise(number); /* comes once this handler has returned */
}

static void handle(int number, bool also_ignored)
{
    struct sigaction action = {.sa_handler = note}, before;
    sigemptyset(&action.sa_mask);
    if (also_ignored || (sigaction(number, NULL, &before) == 0 && before.sa_handler != SIG_IGN))
        sigaction(number, &action, NULL);
}

void thud_interrupt_start(void)
{
    handle(SIGINT, false);
    handle(SIGTERM, false);
    handle(SIGHUP, false);
    signal(SIGXFSZ, SIG_IGN); /* a write beyond the limit fails, which is said */
}

const atomic_int *thud_interrupt_watch(void)
{
    watched = 1;
    handle(SIGINT, true);
    handle(SIGTERM, true);
    handle(SIGHUP, false);
    return &caught;
}

int thud_interrupt_signal(void)
{
    return caught;
}
