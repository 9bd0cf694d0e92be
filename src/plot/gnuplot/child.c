#include "plot/gnuplot/child.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stddef.h>

extern char **environ;

static int set_descriptors(posix_spawn_file_actions_t *actions, const int *fd, int n)
{
    int number = 0;
    for (int i = 0; i < n && !number; i++)
        if (fd[i] == THUD_FD_NOTHING)
            number = posix_spawn_file_actions_addopen(actions, i, "/dev/null", i == 0 ? O_RDONLY : O_WRONLY, 0);
        else
            number = posix_spawn_file_actions_adddup2(actions, fd[i], i);
    return number;
}

static void set_signals(posix_spawnattr_t *attributes, bool apart)
{
    sigset_t none, usual;
    sigemptyset(&none);
    sigfillset(&usual);
    sigdelset(&usual, SIGHUP); /* ignored under nohup, by what it starts too */
    posix_spawnattr_setpgroup(attributes, 0);
    posix_spawnattr_setsigmask(attributes, &none);
    posix_spawnattr_setsigdefault(attributes, &usual);
    posix_spawnattr_setflags(
        attributes, (short)(POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | (apart ? POSIX_SPAWN_SETPGROUP : 0)));
}

int thud_child_start(const char *program, char *const *argv, const int *fd, int n, char *const *environment, bool apart,
                     pid_t *pid)
{
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    int number = posix_spawn_file_actions_init(&actions);
    if (number)
        return number;
    number = posix_spawnattr_init(&attributes);
    if (!number) {
        set_signals(&attributes, apart);
        number = set_descriptors(&actions, fd, n);
        if (!number)
            number = posix_spawnp(pid, program, &actions, &attributes, argv, environment ? environment : environ);
        posix_spawnattr_destroy(&attributes);
    }
    posix_spawn_file_actions_destroy(&actions);
    return number;
}
