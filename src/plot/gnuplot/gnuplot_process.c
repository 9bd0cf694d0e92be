/* gnuplot as a child in its own process group. The script goes in, the picture and the messages come out, in one poll
 * loop with a deadline. `-d /dev/stdin` makes gnuplot stop at the first error and ignore a start-up file. The picture
 * is written to its standard output. So no file name ever reaches gnuplot, and thud itself meets an error of the
 * disk. */
#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "plot/gnuplot/child.h"
#include "plot/gnuplot/gnuplot_internal.h"

extern char **environ;

enum { PICTURE_MOST = 1 << 29, MESSAGES_MOST = 1 << 16, ENVIRONMENT_MORE = 2 };
static const double deadline_s = 20.0;
/* Longest time between two readings of the clock that counts, s. poll waits 0.05 s. In a longer time this process was
 * mostly stopped (Ctrl-Z, a suspended machine) and could not listen. */
static const double longest_turn_s = 0.25;

enum { SCRIPT, PICTURE, MESSAGES, PIPES };

struct child {
    pid_t pid;
    int fd[PIPES]; /* our ends; -1 once closed */
    double left_s; /* until the deadline, of the time in which this process ran */
    double seen_s; /* on the monotonic clock, when left_s was last counted down */
    struct thud_text *picture, messages;
    const atomic_int *cancel;
    enum { RUNNING, ENDED, LATE, CANCELLED } state;
    int status; /* from waitpid, once reaped */
    bool reaped;
};

static double now_s(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* A pipe whose ends no other child inherits. */
static int quiet_pipe(int ends[2])
{
    if (pipe(ends) != 0)
        return errno;
    if (fcntl(ends[0], F_SETFD, FD_CLOEXEC) == 0 && fcntl(ends[1], F_SETFD, FD_CLOEXEC) == 0)
        return 0;
    int number = errno;
    close(ends[0]);
    close(ends[1]);
    return number;
}

static void close_fd(int *fd)
{
    if (*fd >= 0)
        close(*fd);
    *fd = -1;
}

static bool names(const char *entry, const char *name)
{
    size_t n = strlen(name);
    return !strncmp(entry, name, n) && (entry[n] == '=' || name[n - 1] == '_');
}

/* The environment without what changes gnuplot's answers; free with free(). */
static char **child_environment(void)
{
    static char utf8[] = "LC_ALL=C.UTF-8";
    size_t n = 0, kept = 0;
    while (environ[n])
        n++;
    char **copy = malloc((n + ENVIRONMENT_MORE) * sizeof *copy);
    if (!copy)
        return NULL;
    for (size_t i = 0; i < n; i++) {
        if (!names(environ[i], "GNUTERM") && !names(environ[i], "GNUPLOT_LIB") && !names(environ[i], "LC_"))
            copy[kept++] = environ[i];
    }
    copy[kept++] = utf8;
    copy[kept] = NULL;
    return copy;
}

/* With pipes on 0, 1 and 2. */
static int spawn(const char *program, const int ends[PIPES], pid_t *pid)
{
    char *argv[] = {(char *)program, "-d", "/dev/stdin", NULL};
    char **environment = child_environment();
    int number = environment ? thud_child_start(program, argv, ends, PIPES, environment, true, pid) : ENOMEM;
    free(environment);
    return number;
}

static int start_child(struct child *child, const char *program)
{
    int theirs[PIPES] = {-1, -1, -1}, number = 0;
    for (int i = 0; i < PIPES; i++)
        child->fd[i] = -1;
    for (int i = 0; i < PIPES && !number; i++) {
        int ends[2];
        if ((number = quiet_pipe(ends)) != 0)
            break;
        child->fd[i] = ends[i == SCRIPT];
        theirs[i] = ends[i != SCRIPT];
        if (fcntl(child->fd[i], F_SETFL, O_NONBLOCK) != 0)
            number = errno;
    }
    if (!number)
        number = spawn(program, theirs, &child->pid);
    for (int i = 0; i < PIPES; i++) {
        close_fd(&theirs[i]);
        if (number)
            close_fd(&child->fd[i]);
    }
    return number;
}

static void feed(struct child *child, const struct thud_text *script, size_t *sent)
{
    ssize_t n = write(child->fd[SCRIPT], script->data + *sent, script->size - *sent);
    if (n > 0)
        *sent += (size_t)n;
    bool later = n < 0 && (errno == EAGAIN || errno == EINTR);
    if (*sent == script->size || (n < 0 && !later))
        close_fd(&child->fd[SCRIPT]); /* all said, or nobody listens; what came of it is seen at the end */
}

static void drain(int *fd, struct thud_text *into, size_t most)
{
    char bytes[65536];
    ssize_t n = read(*fd, bytes, sizeof bytes);
    if (n > 0 && into->size + (size_t)n <= most)
        thud_text_bytes(into, bytes, (size_t)n);
    else if (n > 0 && into->size < most)
        thud_text_bytes(into, bytes, most - into->size); /* goes on reading, so that the child does not block */
    else if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR))
        close_fd(fd);
}

static bool out_of_time(struct child *child)
{
    double now = now_s();
    child->left_s -= fmin(now - child->seen_s, longest_turn_s);
    child->seen_s = now;
    if (child->cancel && *child->cancel)
        child->state = CANCELLED;
    else if (child->left_s <= 0.0)
        child->state = LATE;
    return child->state != RUNNING;
}

/* Until both outputs are closed, or the deadline. Wakes at least 20 times a second to see a wish to stop. */
static void exchange(struct child *child, const struct thud_text *script)
{
    size_t sent = 0;
    while ((child->fd[PICTURE] >= 0 || child->fd[MESSAGES] >= 0) && !out_of_time(child)) {
        struct pollfd on[PIPES];
        for (int i = 0; i < PIPES; i++)
            on[i] = (struct pollfd){.fd = child->fd[i], .events = i == SCRIPT ? POLLOUT : POLLIN};
        double left_ms = 1e3 * child->left_s;
        if (poll(on, PIPES, left_ms < 1.0 ? 1 : left_ms < 50.0 ? (int)left_ms : 50) <= 0)
            continue;
        if (on[SCRIPT].revents)
            feed(child, script, &sent);
        if (on[PICTURE].revents)
            drain(&child->fd[PICTURE], child->picture, PICTURE_MOST);
        if (on[MESSAGES].revents)
            drain(&child->fd[MESSAGES], &child->messages, MESSAGES_MOST);
    }
    for (int i = 0; i < PIPES; i++)
        close_fd(&child->fd[i]);
}

/* Waits within the deadline; then the whole group is killed, also what the child may have left behind. */
static void wait_and_kill(struct child *child)
{
    struct timespec nap = {0, 200000};
    while (child->state == RUNNING) {
        pid_t pid = waitpid(child->pid, &child->status, WNOHANG);
        child->reaped = pid == child->pid;
        if (child->reaped || (pid < 0 && errno != EINTR))
            child->state = ENDED;
        else if (!out_of_time(child))
            nanosleep(&nap, NULL);
    }
    kill(-child->pid, SIGKILL);
    while (!child->reaped && waitpid(child->pid, &child->status, 0) < 0 && errno == EINTR)
        ;
}

/* A write to a pipe nobody reads raises SIGPIPE: it is held back in this thread and taken off again. */
static void run_child(struct child *child, const struct thud_text *script)
{
    sigset_t pipes, before, pending;
    sigemptyset(&pipes);
    sigaddset(&pipes, SIGPIPE);
    sigpending(&pending);
    bool waiting = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipes, &before);
    exchange(child, script);
    wait_and_kill(child);
    struct timespec at_once = {0, 0};
    if (!waiting) {
        while (sigtimedwait(&pipes, NULL, &at_once) < 0 && errno == EINTR)
            ;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
}

/* gnuplot's own words, in one line: the line that names where it stopped, else the last one that says something. */
static void own_words(const struct thud_text *messages, char *words, size_t size)
{
    const char *from = messages->data ? messages->data : "", *found = NULL;
    size_t length = 0;
    while (*from) {
        size_t n = strcspn(from, "\n");
        bool error = strncmp(from, "\"/dev/stdin\" line ", 18) == 0;
        bool done = strncmp(from, THUD_GNUPLOT_DONE, strlen(THUD_GNUPLOT_DONE)) == 0;
        if (n && !done && strspn(from, " \t^") < n) {
            found = from;
            length = n;
        }
        if (error)
            break;
        from += n + (from[n] == '\n');
    }
    if (length >= size)
        length = size - 1;
    memcpy(words, found ? found : "", length);
    words[length] = '\0';
}

static enum thud_status start_failed(const char *program, int number, struct thud_error *err)
{
    if (number == ENOMEM)
        return thud_error_set(err, THUD_MEMORY, "out of memory for gnuplot");
    if (number != ENOENT)
        return thud_error_set(err, THUD_GNUPLOT, "%s could not be started: %s", program, strerror(number));
    return thud_error_refuse(err, THUD_GNUPLOT, NULL, "install gnuplot 5.4 or later, on Debian the package gnuplot-nox",
                             "%s was not found; pictures need it", program);
}

/* A gnuplot that fails under a limit of memory says so in many ways, or dies without a word. */
static void tell_limit(struct thud_error *err)
{
    struct rlimit space;
    if (getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY)
        thud_error_allow(err, "the memory of this shell is limited to %.0f MB (`ulimit -v`); gnuplot needs about 300",
                         (double)space.rlim_cur / 1e6);
}

static enum thud_status judge_end(const struct child *child, const struct thud_figure *figure,
                                  const struct thud_picture_options *options, double seconds, struct thud_error *err)
{
    char words[320];
    own_words(&child->messages, words, sizeof words);
    const char *colon = *words ? ": " : "";
    bool done = child->messages.data && strstr(child->messages.data, THUD_GNUPLOT_DONE);
    if (child->state == CANCELLED)
        return thud_error_set(err, THUD_CANCELLED, "drawing was stopped");
    if (child->state == LATE)
        return thud_error_set(err, THUD_GNUPLOT, "gnuplot did not end within %g s and was stopped%s%s", seconds, colon,
                              words);
    if (child->picture->failed || child->messages.failed)
        return thud_error_set(err, THUD_MEMORY, "out of memory for a picture");
    if (WIFSIGNALED(child->status))
        thud_error_set(err, THUD_GNUPLOT, "gnuplot was ended by signal %d%s%s", WTERMSIG(child->status), colon, words);
    else if (WEXITSTATUS(child->status) != 0)
        thud_error_set(err, THUD_GNUPLOT, "gnuplot failed with exit status %d%s%s", WEXITSTATUS(child->status), colon,
                       words);
    else if (!done)
        thud_error_set(err, THUD_GNUPLOT, "gnuplot ended before the end of its script%s%s", colon, words);
    if (WIFSIGNALED(child->status) || WEXITSTATUS(child->status) != 0 || !done) {
        tell_limit(err);
        return THUD_GNUPLOT;
    }
    thud_picture_mend(figure, options->format, child->picture);
    if (child->picture->failed)
        return thud_error_set(err, THUD_MEMORY, "out of memory for a picture");
    return thud_picture_check(options->format, child->picture, err);
}

enum thud_status thud_gnuplot_draw(const struct thud_figure *figure, const struct thud_picture_options *options,
                                   struct thud_text *picture, struct thud_error *err)
{
    assert(picture->size == 0);
    const char *program = options->program ? options->program : "gnuplot";
    struct thud_text script = {0};
    enum thud_status status = thud_gnuplot_script(figure, options, NULL, &script, err);
    if (status != THUD_OK)
        return status;
    thud_text_append(&script, "set print\nprint '%s'\n", THUD_GNUPLOT_DONE);
    double seconds = options->deadline_s > 0.0 ? options->deadline_s : deadline_s;
    struct child child = {.picture = picture, .cancel = options->cancel, .left_s = seconds, .seen_s = now_s()};
    int number = script.failed ? ENOMEM : start_child(&child, program);
    if (number)
        status = start_failed(program, number, err);
    else {
        run_child(&child, &script);
        /* a C library may start the child before it looks for the program: then the child ends with 127, and without a
         * word. The dynamic linker ends with 127 as well, but says what it lacks */
        bool missing = child.state == ENDED && WIFEXITED(child.status) && WEXITSTATUS(child.status) == 127 &&
                       child.messages.size == 0;
        status = missing ? start_failed(program, ENOENT, err) : judge_end(&child, figure, options, seconds, err);
    }
    thud_text_clear(&child.messages);
    thud_text_clear(&script);
    if (status != THUD_OK)
        thud_text_clear(picture);
    return status;
}
