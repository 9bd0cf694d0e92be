#include "cli/commands.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "app/run/timing.h"

static const double every_s = 5;

static struct {
    bool shown, terminal;
    double last_s;
} progress;

bool thud_progress_start(const struct thud_args *args)
{
    progress.shown = !thud_args_has(args, "quiet");
    progress.terminal = isatty(STDERR_FILENO) != 0;
    progress.last_s = thud_timing_now_s();
    return progress.shown;
}

void thud_progress_show(const char *fmt, ...)
{
    va_list list;
    if (!progress.shown || (!progress.terminal && thud_timing_now_s() - progress.last_s < every_s))
        return;
    progress.last_s = thud_timing_now_s();
    if (progress.terminal)
        fputs("\r\033[K", stderr);
    va_start(list, fmt);
    vfprintf(stderr, fmt, list);
    va_end(list);
    if (!progress.terminal)
        fputs("\n", stderr);
    fflush(stderr);
}

void thud_progress_wipe(void)
{
    if (progress.shown && progress.terminal)
        fputs("\r\033[K", stderr);
}

void thud_progress_end(void)
{
    thud_progress_wipe();
    progress.shown = false;
}

void thud_progress_what(void *context, const char *what)
{
    (void)context;
    thud_progress_show("%s", what);
}

void thud_progress_drawing(void *context, const struct thud_figure *figure)
{
    (void)context;
    thud_progress_show("drawing %s", figure->name);
    thud_progress_figure(figure);
}

bool thud_progress_is_watched(void)
{
    return getenv("THUD_FIGURES") != NULL;
}

void thud_progress_figure(const struct thud_figure *figure)
{
    const char *to = getenv("THUD_FIGURES");
    struct thud_text bytes = {0};
    if (!to || thud_figure_check(figure, NULL) != THUD_OK)
        return;
    thud_figure_write(figure, &bytes);
    FILE *file = bytes.failed ? NULL : fopen(to, "a");
    if (file) {
        fwrite(bytes.data, 1, bytes.size, file);
        fclose(file);
        fputs("\n", stderr); /* who reads it is woken */
    }
    thud_text_clear(&bytes);
}

void thud_progress_points(void *context, long done, long count, double elapsed_s)
{
    (void)context;
    if (done > 0 && done < count)
        thud_progress_show("%ld of %ld points, %.0f s left", done, count,
                           elapsed_s / (double)done * (double)(count - done));
    else
        thud_progress_show("%ld of %ld points", done, count);
}
