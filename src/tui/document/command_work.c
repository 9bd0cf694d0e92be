#include "tui/document/command_work.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "plot/gnuplot/child.h"

extern char **environ;

enum { WORDS_MAX = 64, PRINTED_MAX = 1 << 20, SAID_MAX = 1 << 14 };

struct thud_command_work {
    pid_t pid;
    int messages;  /* the reading end of its standard error */
    FILE *printed; /* its standard output */
    FILE *figures; /* as bytes; */
    off_t taken;   /* so many of them were read */
    struct thud_text said;
};

/* The environment, and where figures go. */
static char **surroundings(void)
{
    size_t n = 0;
    while (environ[n])
        n++;
    char **all = calloc(n + 2, sizeof *all);
    if (all) {
        memcpy(all, environ, n * sizeof *all);
        all[n] = (char *)"THUD_FIGURES=/dev/fd/3";
    }
    return all;
}

/* Nothing to read, its output into files without a name. */
static int spawn(struct thud_command_work *work, const char *program, char *const *argv, int messages)
{
    const int fd[] = {THUD_FD_NOTHING, fileno(work->printed), messages, fileno(work->figures)};
    char **around = surroundings();
    int number = thud_child_start(program, argv, fd, sizeof fd / sizeof *fd, around, true, &work->pid);
    free(around);
    return number;
}

static void release(struct thud_command_work *work)
{
    if (work && work->printed)
        fclose(work->printed);
    if (work && work->figures)
        fclose(work->figures);
    free(work);
}

enum thud_status thud_command_work_start(const char *program, char *const *word, struct thud_command_work **out,
                                         struct thud_error *err)
{
    char self[4096], *argv[WORDS_MAX + 2] = {(char *)"thud"};
    int ends[2];
    ssize_t n = readlink("/proc/self/exe", self, sizeof self - 1);
    self[n > 0 ? n : 0] = '\0';
    for (int i = 0; i < WORDS_MAX && word[i]; i++)
        argv[i + 1] = word[i];
    struct thud_command_work *work = calloc(1, sizeof *work);
    if (!work || !(work->printed = tmpfile()) || !(work->figures = tmpfile())) {
        release(work);
        return thud_error_set(err, THUD_MEMORY, "no room for what the command prints");
    }
    fcntl(fileno(work->printed), F_SETFD, FD_CLOEXEC);
    fcntl(fileno(work->figures), F_SETFD, FD_CLOEXEC);
    int number = pipe(ends) == 0 ? 0 : errno;
    if (number == 0) {
        for (int i = 0; i < 2; i++)
            fcntl(ends[i], F_SETFD, FD_CLOEXEC);
        fcntl(ends[0], F_SETFL, O_NONBLOCK);
        work->messages = ends[0];
        number = spawn(work, program ? program : *self ? self : "thud", argv, ends[1]);
        close(ends[1]);
        if (number)
            close(ends[0]);
    }
    if (number) {
        release(work);
        return thud_error_set(err, THUD_INPUT, "the command cannot be started: %s", strerror(number));
    }
    *out = work;
    return THUD_OK;
}

int thud_command_work_fd(const struct thud_command_work *work)
{
    return work->messages;
}

/* The last line that is not empty; one that renews itself ends with a carriage return. */
static void last_line(const struct thud_text *text, char *line, size_t size)
{
    const char *end = text->data ? text->data + text->size : NULL, *begin;
    while (end && end > text->data && strchr("\r\n ", end[-1]))
        end--;
    for (begin = end; begin && begin > text->data && !strchr("\r\n", begin[-1]);)
        begin--;
    snprintf(line, size, "%.*s", begin ? (int)(end - begin) : 0, begin ? begin : "");
}

bool thud_command_work_look(struct thud_command_work *work, char *line, size_t size)
{
    char bytes[4096];
    ssize_t n;
    while ((n = read(work->messages, bytes, sizeof bytes)) > 0) {
        if (work->said.size + (size_t)n > SAID_MAX)
            thud_text_clear(&work->said);
        thud_text_bytes(&work->said, bytes, (size_t)n);
    }
    last_line(&work->said, line, size);
    return n < 0 && (errno == EAGAIN || errno == EINTR);
}

struct thud_figure *thud_command_work_figure(struct thud_command_work *work)
{
    struct stat info;
    struct thud_figure *figure = NULL;
    if (fstat(fileno(work->figures), &info) != 0 || info.st_size <= work->taken)
        return NULL;
    const size_t size = (size_t)(info.st_size - work->taken);
    char *bytes = malloc(size);
    if (bytes && pread(fileno(work->figures), bytes, size, work->taken) == (ssize_t)size) {
        const char *at = bytes;
        figure = thud_figure_read(&at, bytes + size);
        work->taken += figure ? at - bytes : 0; /* else it is not written whole yet */
    }
    free(bytes);
    return figure;
}

void thud_command_work_stop(struct thud_command_work *work)
{
    kill(-work->pid, SIGINT);
}

int thud_command_work_finish(struct thud_command_work *work, struct thud_text *printed, struct thud_text *said)
{
    int status = 0;
    char bytes[4096];
    while (waitpid(work->pid, &status, 0) < 0 && errno == EINTR)
        ;
    rewind(work->printed);
    for (size_t n; printed->size < PRINTED_MAX && (n = fread(bytes, 1, sizeof bytes, work->printed)) > 0;)
        thud_text_bytes(printed, bytes, n);
    *said = work->said;
    close(work->messages);
    release(work);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
