/* Figures being written while the screens go on: gnuplot takes its time, so a thread waits for it. */
#pragma once

#include <stdbool.h>

#include "plot/gnuplot/gnuplot.h"

enum { THUD_PICTURES_MAX = 64 };

struct thud_picture_work;

/* A picture for the screen, drawn beside the files of the first figure. */
struct thud_picture_screen {
    enum thud_picture_format format;
    int width_px, height_px; /* 0: none is wanted */
};

/* Begins to write figures (count of them, at most THUD_PICTURES_MAX) into a folder in this format and takes them over,
 * also on failure. `program`: gnuplot; NULL: from PATH. Errors: THUD_MEMORY. */
enum thud_status thud_picture_work_start(struct thud_figure *const *figure, int count, const char *folder,
                                         enum thud_picture_format format, const char *program,
                                         const struct thud_picture_screen *screen, struct thud_picture_work **out,
                                         struct thud_error *err);
int thud_picture_work_fd(const struct thud_picture_work *work); /* readable when something has changed */
/* How many are written of how many; false: it has come to its end. Takes what made the file readable: one place looks,
 * and what it saw is kept. */
bool thud_picture_work_look(struct thud_picture_work *work, int *done, int *count);
void thud_picture_work_stop(struct thud_picture_work *work); /* soon; the figure in hand is left out */
/* Waits for the end and frees. `done` figures were written whole; `picture` gets the one for the screen where there is
 * one (to be cleared; NULL: nobody asks). Errors: THUD_OUTPUT, THUD_GNUPLOT, THUD_CANCELLED,
 * THUD_MEMORY. */
enum thud_status thud_picture_work_finish(struct thud_picture_work *work, int *done, struct thud_text *picture,
                                          struct thud_error *err);
