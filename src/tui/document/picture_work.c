#include "tui/document/picture_work.h"

#include <fcntl.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/run/figure_files.h"
#include "app/run/threads.h"

struct thud_picture_work {
    pthread_t thread;
    int wake[2];
    atomic_int cancel; /* set by one thread and read by the other */
    struct thud_picture_options options;
    char folder[512];
    struct thud_picture_screen screen;
    struct thud_text picture;                      /* for it; the thread's own until `ended` */
    struct thud_figure *figure[THUD_PICTURES_MAX]; /* (count); NULL once done with */
    int count;
    enum thud_status status; /* the thread's own until `ended` */
    struct thud_error error;
    pthread_mutex_t mutex; /* guards the rest */
    int done;
    bool ended;
};

static void tell(struct thud_picture_work *work, int done, bool ended)
{
    pthread_mutex_lock(&work->mutex);
    work->done = done;
    work->ended = ended;
    pthread_mutex_unlock(&work->mutex);
    ssize_t ignored = write(work->wake[1], "", 1);
    (void)ignored;
}

/* Where it cannot be drawn there is none: what is said is about the files. */
static void draw_for_screen(struct thud_picture_work *work, const struct thud_figure *figure)
{
    struct thud_picture_options options = work->options;
    options.format = work->screen.format;
    options.width_px = work->screen.width_px;
    options.height_px = work->screen.height_px;
    if (options.width_px <= 0)
        return;
    struct thud_figure *shown = thud_figure_copy(figure);
    thud_figure_fit(shown, &options);
    if (shown)
        thud_gnuplot_draw(shown, &options, &work->picture, NULL);
    thud_figure_free(shown);
}

static void *write_all(void *context)
{
    struct thud_picture_work *work = context;
    int done = 0;
    for (int i = 0; i < work->count && (work->status == THUD_OK || work->status == THUD_GNUPLOT); i++) {
        struct thud_figure *figure = work->figure[i];
        if (work->cancel) {
            work->status = thud_error_set(&work->error, THUD_CANCELLED, "stopped");
            break;
        }
        work->figure[i] = NULL;
        if (i == 0 && figure)
            draw_for_screen(work, figure);
        work->status = thud_figure_deliver(figure, work->folder, &work->options, work->status, &work->error);
        done += work->status == THUD_OK;
        tell(work, done, false);
    }
    tell(work, done, true);
    return NULL;
}

static void release(struct thud_picture_work *work)
{
    for (int i = 0; i < work->count; i++)
        thud_figure_free(work->figure[i]);
    for (int i = 0; i < 2; i++)
        if (work->wake[i] >= 0)
            close(work->wake[i]);
    thud_text_clear(&work->picture);
    pthread_mutex_destroy(&work->mutex);
    free(work);
}

static bool begin(struct thud_picture_work *work)
{
    if (pipe(work->wake) != 0) {
        work->wake[0] = work->wake[1] = -1;
        return false;
    }
    for (int i = 0; i < 2; i++) {
        fcntl(work->wake[i], F_SETFD, FD_CLOEXEC);
        fcntl(work->wake[i], F_SETFL, O_NONBLOCK);
    }
    return thud_threads_start(&work->thread, 1, write_all, work) == 1;
}

enum thud_status thud_picture_work_start(struct thud_figure *const *figure, int count, const char *folder,
                                         enum thud_picture_format format, const char *program,
                                         const struct thud_picture_screen *screen, struct thud_picture_work **out,
                                         struct thud_error *err)
{
    struct thud_picture_work *work = calloc(1, sizeof *work);
    if (!work) {
        for (int i = 0; i < count; i++)
            thud_figure_free(figure[i]);
        return thud_error_set(err, THUD_MEMORY, "no memory to write figures");
    }
    memcpy(work->figure, figure, (size_t)count * sizeof *figure);
    work->count = count;
    work->wake[0] = work->wake[1] = -1;
    strncpy(work->folder, folder, sizeof work->folder - 1);
    work->options.cancel = &work->cancel;
    work->options.program = program;
    work->options.format = format;
    work->options.no_title = format == THUD_SVG; /* a caption says it */
    work->screen = *screen;
    pthread_mutex_init(&work->mutex, NULL);
    if (begin(work)) {
        *out = work;
        return THUD_OK;
    }
    release(work);
    return thud_error_set(err, THUD_MEMORY, "the system gives no thread to write figures");
}

int thud_picture_work_fd(const struct thud_picture_work *work)
{
    return work->wake[0];
}

bool thud_picture_work_look(struct thud_picture_work *work, int *done, int *count)
{
    char bytes[64];
    while (read(work->wake[0], bytes, sizeof bytes) > 0)
        ;
    pthread_mutex_lock(&work->mutex);
    *done = work->done;
    *count = work->count;
    bool ended = work->ended;
    pthread_mutex_unlock(&work->mutex);
    return !ended;
}

void thud_picture_work_stop(struct thud_picture_work *work)
{
    work->cancel = 1;
}

enum thud_status thud_picture_work_finish(struct thud_picture_work *work, int *done, struct thud_text *picture,
                                          struct thud_error *err)
{
    pthread_join(work->thread, NULL);
    *done = work->done;
    enum thud_status status = work->status;
    if (picture) {
        *picture = work->picture;
        work->picture = (struct thud_text){0};
    }
    *err = work->error;
    release(work);
    return status;
}
