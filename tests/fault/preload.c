/* Loaded before the C library (LD_PRELOAD): the n-th allocation after main began fails, n from THUD_FAULT_AT, also
 * inside libyaml, LAPACK and the others. At the end the number of allocations is appended to the file THUD_FAULT_COUNT,
 * if set. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

void *__libc_malloc(size_t);
void *__libc_calloc(size_t, size_t);
void *__libc_realloc(void *, size_t);

typedef int main_function(int, char **, char **);
static main_function *real_main;
static int counting;
static long count, fail_at;

static int fails(void)
{
    if (!counting || __atomic_add_fetch(&count, 1, __ATOMIC_SEQ_CST) != fail_at)
        return 0;
    errno = ENOMEM;
    return 1;
}

void *malloc(size_t size)
{
    return fails() ? NULL : __libc_malloc(size);
}

void *calloc(size_t n, size_t size)
{
    return fails() ? NULL : __libc_calloc(n, size);
}

void *realloc(void *block, size_t size)
{
    return fails() ? NULL : __libc_realloc(block, size);
}

static void report(void)
{
    counting = 0;
    const char *path = getenv("THUD_FAULT_COUNT");
    int fd = path ? open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666) : -1;
    if (fd >= 0)
        dprintf(fd, "%ld\n", count);
}

static int counted_main(int argc, char **argv, char **envp)
{
    const char *at = getenv("THUD_FAULT_AT");
    fail_at = at ? atol(at) : 0;
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
