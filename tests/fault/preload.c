/* Loaded before the C library (LD_PRELOAD): the n-th call of a kind after main began fails, n from THUD_FAULT_AT, the
 * kind from THUD_FAULT_KIND: memory (also inside libyaml, LAPACK and the others), read, write or start. `kill` and
 * `tear` stand for write, but the program is killed there, before the call or after half of what it was to write. At
 * the end the number of calls is put into the file THUD_FAULT_COUNT, if set. Programs that are started see nothing of
 * it. */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

void *__libc_malloc(size_t);
void *__libc_calloc(size_t, size_t);
void *__libc_realloc(void *, size_t);

enum kind { MEMORY, READ, WRITE, START };

typedef int main_function(int, char **, char **);
static main_function *real_main;
static int counting;
static enum kind armed;
static enum { FAIL, KILL, TEAR } how;
static long count, fail_at;
static char count_path[4096];

static int fails(enum kind kind, int error)
{
    if (!counting || kind != armed || __atomic_add_fetch(&count, 1, __ATOMIC_SEQ_CST) != fail_at)
        return 0;
    if (how == KILL || how == TEAR)
        kill(getpid(), SIGKILL);
    errno = error;
    return 1;
}

/* Whether the next call is the one that is to be torn. */
static int is_torn(void)
{
    return how == TEAR && counting && __atomic_load_n(&count, __ATOMIC_SEQ_CST) + 1 == fail_at;
}

/* ---- memory ---- */

void *malloc(size_t size)
{
    return fails(MEMORY, ENOMEM) ? NULL : __libc_malloc(size);
}

void *calloc(size_t n, size_t size)
{
    return fails(MEMORY, ENOMEM) ? NULL : __libc_calloc(n, size);
}

void *realloc(void *block, size_t size)
{
    return fails(MEMORY, ENOMEM) ? NULL : __libc_realloc(block, size);
}

/* ---- files ---- */

#define REAL(type, name, ...)                                                                                          \
    static type (*real)(__VA_ARGS__);                                                                                  \
    if (!real)                                                                                                         \
    *(void **)&real = dlsym(RTLD_NEXT, name)

/* Messages still come through. */
static int is_error(int fd)
{
    return fd == STDERR_FILENO;
}

static int is_written(int fd)
{
    int flags = fcntl(fd, F_GETFL);
    return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY && !is_error(fd);
}

static int at_end(int failed, int status, int error)
{
    if (failed)
        errno = error;
    return failed ? -1 : status;
}

int open(const char *path, int flags, ...)
{
    REAL(int, "open", const char *, int, ...);
    va_list args;
    va_start(args, flags);
    mode_t mode = flags & O_CREAT ? va_arg(args, mode_t) : 0;
    va_end(args);
    return fails((flags & O_ACCMODE) == O_RDONLY ? READ : WRITE, EACCES) ? -1 : real(path, flags, mode);
}

FILE *fopen(const char *path, const char *mode)
{
    REAL(FILE *, "fopen", const char *, const char *);
    return fails(mode[0] == 'r' && mode[1] != '+' ? READ : WRITE, EACCES) ? NULL : real(path, mode);
}

int close(int fd)
{
    REAL(int, "close", int);
    int broken = is_written(fd) && fails(WRITE, EIO);
    return at_end(broken, real(fd), EIO);
}

int fclose(FILE *file)
{
    REAL(int, "fclose", FILE *);
    int broken = is_written(fileno(file)) && fails(WRITE, ENOSPC);
    return at_end(broken, real(file), ENOSPC);
}

ssize_t read(int fd, void *to, size_t size)
{
    REAL(ssize_t, "read", int, void *, size_t);
    return fails(READ, EIO) ? -1 : real(fd, to, size);
}

ssize_t write(int fd, const void *from, size_t size)
{
    REAL(ssize_t, "write", int, const void *, size_t);
    if (!is_error(fd) && is_torn())
        real(fd, from, size / 2);
    return !is_error(fd) && fails(WRITE, ENOSPC) ? -1 : real(fd, from, size);
}

ssize_t pwrite(int fd, const void *from, size_t size, off_t at)
{
    REAL(ssize_t, "pwrite", int, const void *, size_t, off_t);
    if (is_torn())
        real(fd, from, size / 2, at);
    return fails(WRITE, ENOSPC) ? -1 : real(fd, from, size, at);
}

int fsync(int fd)
{
    REAL(int, "fsync", int);
    return fails(WRITE, EIO) ? -1 : real(fd);
}

int ftruncate(int fd, off_t size)
{
    REAL(int, "ftruncate", int, off_t);
    return fails(WRITE, EIO) ? -1 : real(fd, size);
}

int fchmod(int fd, mode_t mode)
{
    REAL(int, "fchmod", int, mode_t);
    return fails(WRITE, EPERM) ? -1 : real(fd, mode);
}

int rename(const char *from, const char *to)
{
    REAL(int, "rename", const char *, const char *);
    return fails(WRITE, EACCES) ? -1 : real(from, to);
}

int mkdir(const char *path, mode_t mode)
{
    REAL(int, "mkdir", const char *, mode_t);
    return fails(WRITE, EACCES) ? -1 : real(path, mode);
}

int fcntl(int fd, int command, ...)
{
    REAL(int, "fcntl", int, int, ...);
    va_list args;
    va_start(args, command);
    void *argument = va_arg(args, void *);
    va_end(args);
    return command == F_SETLK && fails(WRITE, ENOLCK) ? -1 : real(fd, command, argument);
}

int stat(const char *path, struct stat *out)
{
    REAL(int, "stat", const char *, struct stat *);
    return fails(READ, EACCES) ? -1 : real(path, out);
}

DIR *opendir(const char *path)
{
    REAL(DIR *, "opendir", const char *);
    return fails(READ, EACCES) ? NULL : real(path);
}

/* What a failed read leaves in a stream; there is no portable way to set it. */
static int stream_fails(FILE *file, enum kind kind, int error)
{
    if (!fails(kind, error))
        return 0;
#ifdef _IO_ERR_SEEN
    file->_flags |= _IO_ERR_SEEN;
#else
    file->_flags |= 0x20;
#endif
    return 1;
}

size_t fread(void *to, size_t size, size_t n, FILE *file)
{
    REAL(size_t, "fread", void *, size_t, size_t, FILE *);
    return stream_fails(file, READ, EIO) ? 0 : real(to, size, n, file);
}

char *fgets(char *to, int size, FILE *file)
{
    REAL(char *, "fgets", char *, int, FILE *);
    return stream_fails(file, READ, EIO) ? NULL : real(to, size, file);
}

ssize_t getline(char **to, size_t *size, FILE *file)
{
    REAL(ssize_t, "getline", char **, size_t *, FILE *);
    return stream_fails(file, READ, EIO) ? -1 : real(to, size, file);
}

size_t fwrite(const void *from, size_t size, size_t n, FILE *file)
{
    REAL(size_t, "fwrite", const void *, size_t, size_t, FILE *);
    return !is_error(fileno(file)) && stream_fails(file, WRITE, ENOSPC) ? 0 : real(from, size, n, file);
}

int fflush(FILE *file)
{
    REAL(int, "fflush", FILE *);
    return file && !is_error(fileno(file)) && stream_fails(file, WRITE, ENOSPC) ? EOF : real(file);
}

/* ---- threads and processes ---- */

int pipe(int fd[2])
{
    REAL(int, "pipe", int *);
    return fails(START, EMFILE) ? -1 : real(fd);
}

int posix_spawnp(pid_t *pid, const char *file, const posix_spawn_file_actions_t *actions,
                 const posix_spawnattr_t *attributes, char *const argv[], char *const envp[])
{
    REAL(int, "posix_spawnp", pid_t *, const char *, const posix_spawn_file_actions_t *, const posix_spawnattr_t *,
         char *const *, char *const *);
    return fails(START, EAGAIN) ? EAGAIN : real(pid, file, actions, attributes, argv, envp);
}

int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*start)(void *), void *argument)
{
    REAL(int, "pthread_create", pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);
    return fails(START, EAGAIN) ? EAGAIN : real(thread, attributes, start, argument);
}

/* ---- around main ---- */

static void report(void)
{
    counting = 0;
    int fd = *count_path ? open(count_path, O_WRONLY | O_CREAT | O_TRUNC, 0666) : -1;
    if (fd >= 0)
        dprintf(fd, "%ld\n", count);
}

static enum kind kind_of(const char *name)
{
    static const char *const names[] = {"memory", "read", "write", "start"};
    for (int i = 0; name && i < 4; i++)
        if (strcmp(names[i], name) == 0)
            return (enum kind)i;
    return MEMORY;
}

static int counted_main(int argc, char **argv, char **envp)
{
    const char *at = getenv("THUD_FAULT_AT"), *path = getenv("THUD_FAULT_COUNT");
    fail_at = at ? atol(at) : 0;
    const char *kind = getenv("THUD_FAULT_KIND");
    armed = kind_of(kind);
    if (kind && (strcmp(kind, "kill") == 0 || strcmp(kind, "tear") == 0)) {
        armed = WRITE;
        how = kind[0] == 'k' ? KILL : TEAR;
    }
    if (path)
        snprintf(count_path, sizeof count_path, "%s", path);
    unsetenv("LD_PRELOAD");
    atexit(report);
    counting = 1;
    return real_main(argc, argv, envp);
}

int __libc_start_main(main_function *start, int argc, char **argv, void (*init)(void), void (*fini)(void),
                      void (*unload)(void), void *stack)
{
    int (*original)(main_function *, int, char **, void (*)(void), void (*)(void), void (*)(void), void *);
    *(void **)&original = dlsym(RTLD_NEXT, "__libc_start_main");
    real_main = start;
    return original(counted_main, argc, argv, init, fini, unload, stack);
}
