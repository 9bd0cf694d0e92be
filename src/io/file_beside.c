/* Files in the making: PATH.thud-PID-N.part, renamed once they are whole. */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/scan.h"
#include "io/file_private.h"

int thud_file_open_beside(const char *path, char *name, size_t size)
{
    for (int i = 0; i < 1000; i++) {
        int n = snprintf(name, size, "%s.thud-%ld-%d.part", path, (long)getpid(), i);
        if (n < 0 || (size_t)n >= size) {
            errno = ENAMETOOLONG;
            return -1;
        }
        int fd = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd >= 0 || errno != EEXIST)
            return fd;
    }
    return -1;
}

/* Whether a name is that of a file in the making whose maker has ended. */
static bool is_left(const char *name)
{
    int pid, number;
    for (const char *p = name; (p = strstr(p, ".thud-")) != NULL; p++) {
        const char *at = p;
        if (thud_scan_word(&at, ".thud-") && thud_scan_count(&at, &pid) && thud_scan_word(&at, "-") &&
            thud_scan_count(&at, &number) && strcmp(at, ".part") == 0)
            return pid > 0 && kill((pid_t)pid, 0) != 0 && errno == ESRCH;
    }
    return false;
}

void thud_folder_tidy(const char *folder)
{
    DIR *dir = opendir(folder);
    struct dirent *entry;
    char path[4400];
    while (dir && (entry = readdir(dir)) != NULL)
        if (is_left(entry->d_name) && snprintf(path, sizeof path, "%s/%s", folder, entry->d_name) < (int)sizeof path)
            unlink(path);
    if (dir)
        closedir(dir);
}
