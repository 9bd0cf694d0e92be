#include "io/file/file.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/file/file_private.h"

enum { PIPE_PATIENCE_MS = 1000 };

static enum thud_status refuse(struct thud_error *err, enum thud_status status, const char *path, const char *what)
{
    thud_error_set(err, status, "%s", what);
    thud_error_place(err, path, 0, 0);
    return status;
}

/* Of a pipe: returns once there is something to read, or its writers have gone. */
static void wait_for_writer(int fd, int most_ms)
{
    struct pollfd wanted = {.fd = fd, .events = POLLIN};
    poll(&wanted, 1, most_ms);
}

/* Reads until the end or until `limit` bytes are exceeded (then *size is limit + 1). */
static enum thud_status read_all(int fd, size_t limit, size_t expected, char **text, size_t *size,
                                 struct thud_error *err, const char *path)
{
    size_t capacity = expected + 2;
    char *data = malloc(capacity);
    *size = 0;
    while (data && *size <= limit) {
        if (*size + 1 >= capacity) {
            capacity *= 2;
            char *more = realloc(data, capacity);
            if (!more)
                break;
            data = more;
        }
        ssize_t n = read(fd, data + *size, capacity - *size - 1);
        if (n < 0 && (errno == EINTR || errno == EAGAIN)) {
            wait_for_writer(fd, -1);
            continue;
        }
        if (n < 0) {
            int why = errno;
            free(data);
            return refuse(err, THUD_INPUT, path, strerror(why));
        }
        if (n == 0) {
            data[*size] = '\0';
            *text = data;
            return THUD_OK;
        }
        *size += (size_t)n;
    }
    int large = data && *size > limit;
    free(data);
    if (!large)
        return refuse(err, THUD_MEMORY, path, "out of memory");
    refuse(err, THUD_INPUT, path, "the file is too large");
    thud_error_allow(err, "at most %zu bytes", limit);
    return THUD_INPUT;
}

enum thud_status thud_file_read(const char *path, size_t limit, char **text, size_t *size, struct thud_error *err)
{
    *text = NULL;
    struct stat about;
    if (stat(path, &about) != 0)
        return refuse(err, THUD_INPUT, path, strerror(errno));
    if (S_ISDIR(about.st_mode))
        return refuse(err, THUD_INPUT, path, "is a folder, not a file");
    if (!S_ISREG(about.st_mode) && !S_ISFIFO(about.st_mode))
        return refuse(err, THUD_INPUT, path, "is a device, not a file");
    bool is_pipe = S_ISFIFO(about.st_mode);
    int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0)
        return refuse(err, THUD_INPUT, path, strerror(errno));
    if (is_pipe) /* a writer may come a little later than the reader, or never */
        wait_for_writer(fd, PIPE_PATIENCE_MS);
    size_t expected = 4096;
    if (S_ISREG(about.st_mode) && about.st_size > 0)
        expected = (unsigned long long)about.st_size > limit ? limit : (size_t)about.st_size;
    enum thud_status status = read_all(fd, limit, expected, text, size, err, path);
    close(fd);
    if (status != THUD_OK || !is_pipe || *size > 0)
        return status;
    free(*text);
    *text = NULL;
    return refuse(err, THUD_INPUT, path, "is a pipe, and nothing was written into it");
}

enum thud_status thud_text_check(const char *text, size_t size, const char *name, struct thud_error *err)
{
    const char *zero = size ? memchr(text, '\0', size) : NULL;
    if (!zero)
        return THUD_OK;
    int line = 1, column = 1;
    for (const char *p = text; p < zero; p++) {
        line += *p == '\n';
        column = *p == '\n' ? 1 : column + 1;
    }
    thud_error_set(err, THUD_INPUT, "a byte 0 stands here");
    thud_error_place(err, name, line, column);
    thud_error_allow(err, "UTF-8 text");
    return THUD_INPUT;
}

enum thud_status thud_text_read(const char *path, size_t limit, char **text, struct thud_error *err)
{
    size_t size;
    enum thud_status status = thud_file_read(path, limit, text, &size, err);
    if (status != THUD_OK)
        return status;
    status = thud_text_check(*text, size, path, err);
    if (status == THUD_OK && strncmp(*text, "\xef\xbb\xbf", 3) == 0)
        memmove(*text, *text + 3, size - 2);
    if (status != THUD_OK) {
        free(*text);
        *text = NULL;
    }
    return status;
}

char *thud_text_line(char **text)
{
    char *line = *text;
    if (!line || !*line)
        return NULL;
    size_t n = strcspn(line, "\n");
    *text = line + n + (line[n] == '\n');
    if (n > 0 && line[n - 1] == '\r')
        line[n - 1] = '\0';
    line[n] = '\0';
    return line;
}

/* 0, or the errno of what went wrong. */
static int write_all(int fd, const char *text, size_t size)
{
    while (size > 0) {
        ssize_t n = write(fd, text, size);
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            return errno;
        text += n;
        size -= (size_t)n;
    }
    return 0;
}

/* A whole file beside `path`, its name in `name`, open in *fd; 0, or the errno of what went wrong. */
static int write_beside(const char *path, const struct stat *old, const char *text, size_t size, char *name,
                        size_t name_size, int *fd)
{
    *fd = thud_file_open_beside(path, name, name_size);
    if (*fd < 0)
        return errno;
    int why = write_all(*fd, text, size);
    if (!why && old && fchmod(*fd, old->st_mode & 07777) != 0)
        why = errno;
    if (!why && fsync(*fd) != 0)
        why = errno;
    if (!why)
        return 0;
    thud_file_remove(name);
    close(*fd);
    return why;
}

static int write_through(const char *path, const char *text, size_t size)
{
    int fd = open(path, O_WRONLY | O_CLOEXEC);
    int why = fd < 0 ? errno : write_all(fd, text, size);
    if (fd >= 0 && close(fd) != 0 && !why)
        why = errno;
    return why;
}

static enum thud_status unwritten(const char *path, int why, struct thud_error *err)
{
    thud_error_set(err, THUD_OUTPUT, "cannot be written: %s", strerror(why));
    thud_error_place(err, path, 0, 0);
    return THUD_OUTPUT;
}

bool thud_file_is_same(const char *a, const char *b)
{
    struct stat one, other;
    return stat(a, &one) == 0 && stat(b, &other) == 0 && one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

enum thud_status thud_file_draft(const char *path, const char *text, size_t size, enum thud_file_owner owner,
                                 struct thud_file_draft *out, struct thud_error *err)
{
    struct stat about;
    bool named = owner == THUD_FILE_NAMED, there = (named ? stat(path, &about) : lstat(path, &about)) == 0;
    *out = (struct thud_file_draft){0};
    if (there && S_ISDIR(about.st_mode))
        return unwritten(path, EISDIR, err);
    bool regular = there && S_ISREG(about.st_mode);
    if (there && !regular && named) { /* a pipe or a terminal cannot be replaced */
        int why = write_through(path, text, size);
        return why ? unwritten(path, why, err) : THUD_OK;
    }
    char part[4200];
    out->path = there && named ? realpath(path, NULL) : NULL; /* a link stays a link */
    if (!out->path)
        out->path = strdup(path);
    int why =
        out->path ? write_beside(out->path, regular ? &about : NULL, text, size, part, sizeof part, &out->fd) : ENOMEM;
    if (!why && !(out->part = strdup(part))) {
        thud_file_remove(part);
        close(out->fd);
        why = ENOMEM;
    }
    if (!why)
        return THUD_OK;
    free(out->path);
    *out = (struct thud_file_draft){0};
    return unwritten(path, why, err);
}

/* The draft's part is where it belongs or gone. */
static void end_draft(struct thud_file_draft *draft)
{
    if (draft->part)
        close(draft->fd);
    free(draft->part);
    free(draft->path);
    *draft = (struct thud_file_draft){0};
}

void thud_file_drop(struct thud_file_draft *draft)
{
    if (draft->part)
        thud_file_remove(draft->part);
    end_draft(draft);
}

enum thud_status thud_file_keep(struct thud_file_draft *draft, struct thud_error *err)
{
    int why = draft->part ? thud_file_replace(draft->part, draft->path) : 0;
    enum thud_status status = why ? unwritten(draft->path, why, err) : THUD_OK;
    end_draft(draft);
    return status;
}

static enum thud_status write_as(const char *path, const char *text, size_t size, enum thud_file_owner owner,
                                 struct thud_error *err)
{
    struct thud_file_draft draft;
    enum thud_status status = thud_file_draft(path, text, size, owner, &draft, err);
    return status == THUD_OK ? thud_file_keep(&draft, err) : status;
}

enum thud_status thud_file_write(const char *path, const char *text, size_t size, struct thud_error *err)
{
    return write_as(path, text, size, THUD_FILE_NAMED, err);
}

static enum thud_status write_text(struct thud_text *text, const char *path, enum thud_file_owner owner,
                                   struct thud_error *err)
{
    enum thud_status status = text->failed ? refuse(err, THUD_MEMORY, path, "out of memory")
                                           : write_as(path, text->data ? text->data : "", text->size, owner, err);
    thud_text_clear(text);
    return status;
}

enum thud_status thud_text_write(struct thud_text *text, const char *path, struct thud_error *err)
{
    return write_text(text, path, THUD_FILE_NAMED, err);
}

enum thud_status thud_text_write_in(struct thud_text *text, const char *folder, const char *name,
                                    struct thud_error *err)
{
    char path[4096];
    int n = snprintf(path, sizeof path, "%s/%s", *folder ? folder : ".", name);
    if (n >= 0 && (size_t)n < sizeof path)
        return write_text(text, path, THUD_FILE_RESULT, err);
    thud_text_clear(text);
    return thud_error_set(err, THUD_OUTPUT, "the path to %.100s is too long", name);
}

enum thud_status thud_folder_make(const char *path, struct thud_error *err)
{
    char part[4096];
    size_t length = strlen(path);
    if (length == 0 || length >= sizeof part)
        return refuse(err, THUD_OUTPUT, path, "is no name for a folder");
    memcpy(part, path, length + 1);
    for (size_t i = 1; i <= length; i++) {
        if (part[i] != '/' && part[i] != '\0')
            continue;
        char kept = part[i];
        part[i] = '\0';
        struct stat about;
        if (mkdir(part, 0777) != 0 && (errno != EEXIST || stat(part, &about) != 0 || !S_ISDIR(about.st_mode))) {
            int why = errno;
            bool is_file = why == EEXIST && stat(part, &about) == 0;
            thud_error_set(err, THUD_OUTPUT, "the folder cannot be made: %s",
                           is_file ? "there is a file of this name" : strerror(why));
            thud_error_place(err, part, 0, 0);
            return THUD_OUTPUT;
        }
        part[i] = kept;
    }
    thud_folder_tidy(path);
    return THUD_OK;
}
