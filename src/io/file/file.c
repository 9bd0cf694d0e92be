#include "io/file/file.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/file/file_private.h"

enum { PIPE_PATIENCE_MS = 1000 };

enum thud_status thud_file_refuse(struct thud_error *err, enum thud_status status, const char *path, const char *what)
{
    return thud_error_in(err, status, path, 0, "%s", what);
}

/* Of a pipe: returns once there is something to read, or its writers have gone. */
static void wait_for_writer(int fd, int most_ms)
{
    struct pollfd wanted = {.fd = fd, .events = POLLIN};
    poll(&wanted, 1, most_ms);
}

static enum thud_status read_all(int fd, size_t limit, char **text, size_t *size, struct thud_error *err,
                                 const char *path)
{
    struct thud_text all = {0};
    char room[1 << 16];
    thud_text_bytes(&all, "", 0);
    for (ssize_t n = 1; n != 0 && all.size <= limit && !all.failed;) {
        n = read(fd, room, sizeof room);
        if (n < 0 && errno != EINTR && errno != EAGAIN) {
            int why = errno;
            thud_text_clear(&all);
            return thud_file_refuse(err, THUD_INPUT, path, strerror(why));
        }
        if (n < 0)
            wait_for_writer(fd, -1);
        else
            thud_text_bytes(&all, room, (size_t)n);
    }
    *text = all.data;
    *size = all.size;
    if (!all.failed && all.size <= limit)
        return THUD_OK;
    *text = NULL;
    enum thud_status status = thud_file_refuse(err, all.failed ? THUD_MEMORY : THUD_INPUT, path,
                                               all.failed ? "out of memory" : "the file is too large");
    if (!all.failed)
        thud_error_allow(err, "at most %zu bytes", limit);
    thud_text_clear(&all);
    return status;
}

enum thud_status thud_file_read(const char *path, size_t limit, char **text, size_t *size, struct thud_error *err)
{
    *text = NULL;
    struct stat about;
    if (strcmp(path, "-") == 0)
        return read_all(STDIN_FILENO, limit, text, size, err, path);
    if (stat(path, &about) != 0)
        return thud_file_refuse(err, THUD_INPUT, path, strerror(errno));
    if (S_ISDIR(about.st_mode))
        return thud_file_refuse(err, THUD_INPUT, path, "is a folder, not a file");
    if (!S_ISREG(about.st_mode) && !S_ISFIFO(about.st_mode))
        return thud_file_refuse(err, THUD_INPUT, path, "is a device, not a file");
    bool is_pipe = S_ISFIFO(about.st_mode);
    int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0)
        return thud_file_refuse(err, THUD_INPUT, path, strerror(errno));
    if (is_pipe) /* a writer may come a little later than the reader, or never */
        wait_for_writer(fd, PIPE_PATIENCE_MS);
    enum thud_status status = read_all(fd, limit, text, size, err, path);
    close(fd);
    if (status != THUD_OK || !is_pipe || *size > 0)
        return status;
    free(*text);
    *text = NULL;
    return thud_file_refuse(err, THUD_INPUT, path, "is a pipe, and nothing was written into it");
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
    thud_error_set(err, THUD_INPUT, "a NUL byte is not allowed here");
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

bool thud_file_is_same(const char *a, const char *b)
{
    struct stat one, other;
    return stat(a, &one) == 0 && stat(b, &other) == 0 && one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}
