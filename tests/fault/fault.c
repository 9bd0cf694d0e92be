#include "fault.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* What the linker calls the originals. */
void *__real_malloc(size_t);
void *__real_calloc(size_t, size_t);
void *__real_realloc(void *, size_t);
void __real_free(void *);
int __real_open(const char *, int, ...);
int __real_mkstemp(char *);
int __real_close(int);
ssize_t __real_read(int, void *, size_t);
ssize_t __real_write(int, const void *, size_t);
int __real_fsync(int);
int __real_rename(const char *, const char *);
int __real_mkdir(const char *, mode_t);
int __real_stat(const char *, struct stat *);
int __real_fstat(int, struct stat *);
FILE *__real_fopen(const char *, const char *);
size_t __real_fread(void *, size_t, size_t, FILE *);
size_t __real_fwrite(const void *, size_t, size_t, FILE *);

static enum thud_fault armed;
static long left; /* calls until the one that fails; 0: none does */
static bool fired;

void thud_fault_arm(enum thud_fault kind, long n)
{
    armed = kind;
    left = n;
    fired = false;
}

bool thud_fault_end(void)
{
    left = 0;
    return fired;
}

static void (*before_open)(void), (*after_open)(void);

void thud_fault_around_open(void (*before)(void), void (*after)(void))
{
    before_open = before;
    after_open = after;
}

static bool fails(enum thud_fault kind, int error)
{
    if (left == 0 || kind != armed || --left != 0)
        return false;
    fired = true;
    errno = error;
    return true;
}

/* The blocks that are out: an open-addressed set of addresses, so that a block from elsewhere may be freed too. */
enum { SLOTS = 1 << 20 };
static uintptr_t slot[SLOTS];
static long live;
static const uintptr_t GONE = 1;

long thud_fault_live(void)
{
    return live;
}

static size_t place(uintptr_t address)
{
    return (size_t)((address >> 4) * 2654435761u) % SLOTS;
}

static void *note(void *block)
{
    if (!block)
        return NULL;
    size_t i = place((uintptr_t)block);
    while (slot[i] > GONE)
        i = (i + 1) % SLOTS;
    slot[i] = (uintptr_t)block;
    live++;
    return block;
}

static void forget(const void *block)
{
    size_t i = place((uintptr_t)block);
    for (; slot[i]; i = (i + 1) % SLOTS) {
        if (slot[i] == (uintptr_t)block) {
            slot[i] = GONE;
            live--;
            return;
        }
    }
}

void *__wrap_malloc(size_t size)
{
    return fails(THUD_FAULT_MEMORY, ENOMEM) ? NULL : note(__real_malloc(size));
}

void *__wrap_calloc(size_t n, size_t size)
{
    return fails(THUD_FAULT_MEMORY, ENOMEM) ? NULL : note(__real_calloc(n, size));
}

void *__wrap_realloc(void *block, size_t size)
{
    if (fails(THUD_FAULT_MEMORY, ENOMEM))
        return NULL;
    if (block)
        forget(block);
    return note(__real_realloc(block, size));
}

void __wrap_free(void *block)
{
    if (block)
        forget(block);
    __real_free(block);
}

char *__wrap_strndup(const char *text, size_t size)
{
    size_t n = strnlen(text, size);
    char *copy = __wrap_malloc(n + 1);
    if (!copy)
        return NULL;
    memcpy(copy, text, n);
    copy[n] = '\0';
    return copy;
}

char *__wrap_strdup(const char *text)
{
    return __wrap_strndup(text, strlen(text));
}

/* A file descriptor open for writing, so that its close can fail too (what a full quota does on a network disk). */
static bool writes(int fd)
{
    int flags = fcntl(fd, F_GETFL);
    return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

int __wrap_open(const char *path, int flags, ...)
{
    va_list args;
    va_start(args, flags);
    mode_t mode = flags & O_CREAT ? (mode_t)va_arg(args, int) : 0;
    va_end(args);
    if (fails((flags & O_ACCMODE) == O_RDONLY ? THUD_FAULT_READ : THUD_FAULT_WRITE, EACCES))
        return -1;
    const bool writing = (flags & O_ACCMODE) != O_RDONLY;
    if (writing && before_open)
        before_open();
    const int fd = __real_open(path, flags, mode);
    if (writing && after_open)
        after_open();
    return fd;
}

int __wrap_mkstemp(char *path)
{
    return fails(THUD_FAULT_WRITE, EACCES) ? -1 : __real_mkstemp(path);
}

int __wrap_close(int fd)
{
    bool broken = writes(fd) && fails(THUD_FAULT_WRITE, EIO);
    int status = __real_close(fd);
    if (broken)
        errno = EIO;
    return broken ? -1 : status;
}

ssize_t __wrap_read(int fd, void *to, size_t size)
{
    return fails(THUD_FAULT_READ, EIO) ? -1 : __real_read(fd, to, size);
}

ssize_t __wrap_write(int fd, const void *from, size_t size)
{
    return fails(THUD_FAULT_WRITE, ENOSPC) ? -1 : __real_write(fd, from, size);
}

int __wrap_fsync(int fd)
{
    return fails(THUD_FAULT_WRITE, EIO) ? -1 : __real_fsync(fd);
}

int __wrap_rename(const char *from, const char *to)
{
    return fails(THUD_FAULT_WRITE, EXDEV) ? -1 : __real_rename(from, to);
}

int __wrap_mkdir(const char *path, mode_t mode)
{
    return fails(THUD_FAULT_WRITE, EACCES) ? -1 : __real_mkdir(path, mode);
}

int __wrap_fstat(int fd, struct stat *out)
{
    return fails(THUD_FAULT_READ, EIO) ? -1 : __real_fstat(fd, out);
}

int __wrap_stat(const char *path, struct stat *out)
{
    return fails(THUD_FAULT_READ, EACCES) ? -1 : __real_stat(path, out);
}

FILE *__wrap_fopen(const char *path, const char *mode)
{
    return fails(mode[0] == 'r' ? THUD_FAULT_READ : THUD_FAULT_WRITE, EACCES) ? NULL : __real_fopen(path, mode);
}

size_t __wrap_fread(void *to, size_t size, size_t n, FILE *file)
{
    return fails(THUD_FAULT_READ, EIO) ? 0 : __real_fread(to, size, n, file);
}

size_t __wrap_fwrite(const void *from, size_t size, size_t n, FILE *file)
{
    return fails(THUD_FAULT_WRITE, ENOSPC) ? 0 : __real_fwrite(from, size, n, file);
}
