#include "suite.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

void thud_suite_skips(const char *tests, const char *why)
{
    printf("# SKIP %s: %s\n", tests, why);
    fflush(stdout);
}

bool thud_suite_shared(const char *name, char *path, size_t size)
{
    const char *given = getenv("THUD_SHARED"), *folders[] = {given ? given : "../shared", "../../shared"};
    for (int i = 0; i < (given ? 1 : 2); i++) {
        snprintf(path, size, "%s/%s", folders[i], name);
        if (access(path, R_OK) == 0)
            return true;
    }
    return false;
}
