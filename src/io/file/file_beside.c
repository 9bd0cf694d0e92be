/* Files in the making: PATH.thud-PID-N.part, renamed once they are whole. The maker holds a lock on its file as long as
 * it lives, so that no other program takes it for one that was left behind. Process numbers say nothing in another
 * container or on another host with the same folder. A list of them is for the handler of a signal that ends the
 * program at once. */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "base/scan.h"
#include "io/file/file.h"
#include "io/file/file_private.h"

enum { PARTS_MAX = 24, PATH_ROOM = 4400 };

/* A signal handler can reach nothing but statics; more files than these are left behind by a signal, no worse. */
static struct {
    volatile sig_atomic_t living;
    char path[PATH_ROOM];
} part[PARTS_MAX];
static pthread_mutex_t part_lock = PTHREAD_MUTEX_INITIALIZER;
static int numbered;                   /* so many names have been given */
static volatile sig_atomic_t dropping; /* from then on no file is begun */

/* A file that thud_file_drop_all removes until it is forgotten. */
static void note(const char *path)
{
    pthread_mutex_lock(&part_lock);
    for (int i = 0; i < PARTS_MAX && strlen(path) < PATH_ROOM; i++)
        if (!part[i].living) {
            strcpy(part[i].path, path);
            part[i].living = 1;
            break;
        }
    pthread_mutex_unlock(&part_lock);
}

static void forget(const char *path)
{
    pthread_mutex_lock(&part_lock);
    for (int i = 0; i < PARTS_MAX; i++)
        if (part[i].living && strcmp(part[i].path, path) == 0)
            part[i].living = 0;
    pthread_mutex_unlock(&part_lock);
}

static void unlink_all(void)
{
    for (int i = 0; i < PARTS_MAX; i++)
        if (part[i].living)
            unlink(part[i].path);
}

/* Twice: another thread may be just about to make a file that it has put into the list. */
void thud_file_drop_all(void)
{
    const struct timespec moment = {.tv_nsec = 2000000};
    dropping = 1;
    unlink_all();
    nanosleep(&moment, NULL);
    unlink_all();
}

static int next_number(void)
{
    pthread_mutex_lock(&part_lock);
    const int number = numbered++;
    pthread_mutex_unlock(&part_lock);
    return number;
}

/* 0; EACCES or EAGAIN: another program holds it; another errno: locks are not known here. */
static int lock_file(int fd)
{
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    return fcntl(fd, F_SETLK, &whole) == 0 ? 0 : errno;
}

/* Into the list before it is made, as a signal may come between. No two names of a process are the same, so that a file
 * that is there is one that a dead process of the same number left. */
int thud_file_open_beside(const char *path, char *name, size_t size)
{
    for (int i = 0; i < 1000; i++) {
        int n = snprintf(name, size, "%s.thud-%ld-%d.part", path, (long)getpid(), next_number());
        if (n < 0 || (size_t)n >= size) {
            errno = ENAMETOOLONG;
            return -1;
        }
        note(name);
        errno = EINTR;
        int fd = dropping ? -1 : open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd >= 0) {
            (void)lock_file(fd);
            return fd;
        }
        int why = errno;
        forget(name);
        errno = why;
        if (why != EEXIST)
            return -1;
    }
    return -1;
}

int thud_file_replace(const char *name, const char *path)
{
    int why = rename(name, path) != 0 ? errno : 0;
    if (why)
        unlink(name);
    else
        thud_made_by_note(path);
    forget(name);
    return why;
}

void thud_file_remove(const char *name)
{
    unlink(name);
    forget(name);
}

/* Whether a name is that of a file in the making of a process that does not run here. */
static bool may_be_left(const char *name)
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

/* Nobody holds it, here or elsewhere. */
static bool is_left(const char *path)
{
    struct stat about;
    int fd = lstat(path, &about) == 0 && S_ISREG(about.st_mode) ? open(path, O_WRONLY | O_CLOEXEC | O_NONBLOCK) : -1;
    bool left = fd >= 0 && lock_file(fd) == 0;
    if (fd >= 0)
        close(fd);
    return left;
}

void thud_folder_tidy(const char *folder)
{
    DIR *dir = opendir(folder);
    struct dirent *entry;
    char path[PATH_ROOM];
    while (dir && (entry = readdir(dir)) != NULL)
        if (may_be_left(entry->d_name) &&
            snprintf(path, sizeof path, "%s/%s", folder, entry->d_name) < (int)sizeof path && is_left(path))
            unlink(path);
    if (dir)
        closedir(dir);
}

/* ---- the lock of a folder ---- */

static enum thud_status unlocked(struct thud_folder_lock *lock, enum thud_status status, const char *what,
                                 struct thud_error *err)
{
    if (lock->fd >= 0)
        close(lock->fd);
    lock->fd = -1;
    return thud_error_in(err, status, lock->path, 0, "%s", what);
}

/* The file that is locked is the one that has the name: the one before may have gone with its study. */
static bool is_named(const struct thud_folder_lock *lock)
{
    struct stat held, named;
    return fstat(lock->fd, &held) == 0 && stat(lock->path, &named) == 0 && held.st_dev == named.st_dev &&
           held.st_ino == named.st_ino;
}

enum thud_status thud_folder_lock(const char *folder, struct thud_folder_lock *lock, struct thud_error *err)
{
    lock->fd = -1;
    if (snprintf(lock->path, sizeof lock->path, "%s/sweep.lock", folder) >= (int)sizeof lock->path)
        return thud_error_set(err, THUD_OUTPUT, "the folder's name is too long");
    for (int i = 0; i < 100; i++) {
        lock->fd = open(lock->path, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (lock->fd < 0)
            return unlocked(lock, THUD_OUTPUT, strerror(errno), err);
        int why = lock_file(lock->fd);
        if (why == EACCES || why == EAGAIN)
            return unlocked(lock, THUD_OUTPUT, "another study is writing into this folder", err);
        if (is_named(lock)) {
            note(lock->path);
            return THUD_OK;
        }
        close(lock->fd);
    }
    lock->fd = -1;
    return unlocked(lock, THUD_OUTPUT, "another study is writing into this folder", err);
}

void thud_folder_unlock(struct thud_folder_lock *lock)
{
    if (lock->fd < 0)
        return;
    thud_file_remove(lock->path); /* while it is held */
    close(lock->fd);
    lock->fd = -1;
}
