#define _XOPEN_SOURCE          700
#define _XOPEN_SOURCE_EXTENDED 1
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

#include <curses.h>
#include <term.h>

#include "tui/terminal/term_signal.h"

static const int fatal[] = {SIGINT, SIGTERM, SIGHUP};
/* All others that end a process by default. */
static const int crash[] = {SIGSEGV, SIGBUS,  SIGFPE,    SIGILL,  SIGABRT, SIGQUIT, SIGPIPE, SIGALRM,
                            SIGUSR1, SIGUSR2, SIGVTALRM, SIGPROF, SIGXCPU, SIGXFSZ, SIGSYS,  SIGTRAP};
enum { FATAL = sizeof fatal / sizeof *fatal, CRASH = sizeof crash / sizeof *crash };

/* Signal handlers can reach nothing but statics. */
static volatile sig_atomic_t got_fatal, got_stop, got_size;
static int wake[2] = {-1, -1};
static struct sigaction before_fatal[FATAL], before_crash[CRASH], before_stop, before_size;
static struct termios before_mode;
static int have_mode, have_size;
static char restore[512];
static char crash_stack[1 << 16]; /* a crash may be that the stack has no room left */
static stack_t before_stack;
static size_t restore_size;

static void wake_loop(void)
{
    int saved = errno;
    ssize_t ignored = write(wake[1], "", 1);
    (void)ignored;
    errno = saved;
}

static void on_fatal(int number)
{
    got_fatal = number;
    wake_loop();
}

static void on_stop(int number)
{
    (void)number;
    got_stop = 1;
    wake_loop();
}

static void on_size(int number)
{
    (void)number;
    got_size = 1;
    wake_loop();
}

/* Only calls that are safe here: the terminal gets its fixed sequence, and the signal its default effect. */
static void on_crash(int number)
{
    ssize_t ignored = write(STDOUT_FILENO, restore, restore_size);
    (void)ignored;
    if (have_mode)
        tcsetattr(STDIN_FILENO, TCSANOW, &before_mode);
    signal(number, SIG_DFL);
    raise(number);
}

static void catch_signal(int number, void (*handler)(int), int flags, struct sigaction *before)
{
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, before);
    if (handler != SIG_DFL && before->sa_handler == SIG_IGN)
        sigaction(number, before, NULL); /* as with nohup */
}

static void make_pipe(void)
{
    if (pipe(wake) != 0) {
        wake[0] = wake[1] = -1;
        return;
    }
    for (int i = 0; i < 2; i++) {
        fcntl(wake[i], F_SETFL, O_NONBLOCK);
        fcntl(wake[i], F_SETFD, FD_CLOEXEC);
    }
}

void thud_term_signal_open(void)
{
    got_fatal = got_stop = got_size = 0;
    have_mode = tcgetattr(STDIN_FILENO, &before_mode) == 0;
    make_pipe();
    for (int i = 0; i < FATAL; i++)
        catch_signal(fatal[i], on_fatal, 0, &before_fatal[i]);
    stack_t stack = {.ss_sp = crash_stack, .ss_size = sizeof crash_stack};
    sigaltstack(&stack, &before_stack);
    for (int i = 0; i < CRASH; i++)
        catch_signal(crash[i], on_crash, (int)SA_RESETHAND | SA_ONSTACK, &before_crash[i]);
    catch_signal(SIGTSTP, on_stop, 0, &before_stop);
}

static void add_capability(const char *name)
{
    const char *text = tigetstr(name);
    if (!text || text == (const char *)-1)
        return;
    for (; *text && restore_size < sizeof restore - 1; text++) {
        if (text[0] == '$' && text[1] == '<') { /* padding, which is for no terminal of today */
            const char *end = strchr(text, '>');
            if (end) {
                text = end;
                continue;
            }
        }
        restore[restore_size++] = *text;
    }
}

void thud_term_signal_ready(void)
{
    restore_size = sizeof THUD_MOUSE_OFF THUD_PASTE_OFF - 1;
    memcpy(restore, THUD_MOUSE_OFF THUD_PASTE_OFF, restore_size);
    add_capability("sgr0");
    add_capability("rmkx");
    add_capability("cnorm");
    add_capability("rmcup");
    catch_signal(SIGWINCH, on_size, SA_RESTART, &before_size);
    have_size = 1;
}

void thud_term_signal_close(void)
{
    for (int i = 0; i < FATAL; i++)
        sigaction(fatal[i], &before_fatal[i], NULL);
    for (int i = 0; i < CRASH; i++)
        sigaction(crash[i], &before_crash[i], NULL);
    sigaltstack(&before_stack, NULL);
    sigaction(SIGTSTP, &before_stop, NULL);
    if (have_size)
        sigaction(SIGWINCH, &before_size, NULL);
    have_size = 0;
    for (int i = 0; i < 2; i++) {
        if (wake[i] >= 0)
            close(wake[i]);
        wake[i] = -1;
    }
}

int thud_term_signal_fd(void)
{
    return wake[0];
}

void thud_term_signal_drain(void)
{
    char bytes[64];
    while (read(wake[0], bytes, sizeof bytes) > 0)
        ;
}

bool thud_term_signal_resized(void)
{
    bool came = got_size;
    got_size = 0;
    return came;
}

int thud_term_signal_fatal(void)
{
    return got_fatal;
}

bool thud_term_signal_suspend(void)
{
    if (!got_stop)
        return false;
    got_stop = 0;
    ssize_t ignored = write(STDOUT_FILENO, THUD_MOUSE_OFF THUD_PASTE_OFF, sizeof THUD_MOUSE_OFF THUD_PASTE_OFF - 1);
    (void)ignored;
    endwin();
    struct sigaction mine;
    catch_signal(SIGTSTP, SIG_DFL, 0, &mine);
    raise(SIGTSTP);
    sigaction(SIGTSTP, &mine, NULL);
    got_size = 1; /* it may have changed meanwhile */
    clearok(stdscr, TRUE);
    refresh();
    return true;
}
