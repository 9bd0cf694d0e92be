/* Other programs as child processes. */
#pragma once

#include <stdbool.h>
#include <sys/types.h>

enum { THUD_FD_NOTHING = -1 }; /* /dev/null */

/* Starts a program, found by PATH, with `fd` (n) as its descriptors 0, 1, ..., all signals but HUP as they are by
 * default, and `environment` (NULL: this process's). `apart`: in a group of its own, so that Ctrl-C does not reach it
 * and it can be killed with all it started. Returns 0 or an errno. */
int thud_child_start(const char *program, char *const *argv, const int *fd, int n, char *const *environment, bool apart,
                     pid_t *pid);
