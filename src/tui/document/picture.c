/* A figure as a picture over the whole screen, where the terminal draws pictures. */
#include <string.h>

#include "base/ascii.h"
#include "ground/identity.h"
#include "tui/document/state.h"

/* xterm draws no sixels beyond 1000 px; more than 4000 nobody sees. */
enum { SIXEL_MOST = 1000, PNG_MOST = 4000 };
/* Rows below it: the words, and one so that a terminal which moves on behind a picture does not scroll. */
enum { ROWS_BELOW = 2, SIXEL_BAND = 6 };

static int at_most(int n, int most)
{
    return n < most ? n : most;
}

const char *thud_tui_figure_title(const struct thud_tui *tui, const struct thud_figure *figure)
{
    const char *title = figure->title ? figure->title : figure->name;
    char motion[640] = "";
    const char *of[] = {tui->doc.scene.title, motion};
    if (tui->doc.record)
        thud_record_title(tui->doc.record, motion, sizeof motion);
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        const size_t n = strlen(of[i]);
        if (n == 0 || thud_ascii_lower(*title) != thud_ascii_lower(*of[i]) || strncmp(title + 1, of[i] + 1, n - 1) != 0)
            continue;
        const char *rest = title + n + strspn(title + n, ":,. ");
        title = *rest ? rest : title;
    }
    return title;
}

struct thud_picture_screen thud_tui_picture_screen(struct thud_tui *tui)
{
    int w, h, columns, rows;
    enum thud_image image = tui->backend->image(tui->backend, &w, &h);
    tui->backend->size(tui->backend, &columns, &rows);
    if (image == THUD_IMAGE_NONE || rows <= ROWS_BELOW || thud_tui_too_small(tui))
        return (struct thud_picture_screen){.format = THUD_PNG};
    int height = h * (rows - ROWS_BELOW) / rows, most = image == THUD_IMAGE_SIXEL ? SIXEL_MOST : PNG_MOST;
    return (struct thud_picture_screen){.format = image == THUD_IMAGE_SIXEL ? THUD_SIXEL : THUD_PNG,
                                        .width_px = at_most(w, most),
                                        .height_px = at_most(height - height % SIXEL_BAND, most)};
}

void thud_tui_show_picture(struct thud_tui *tui, const struct thud_text *picture)
{
    int w, h, columns, rows;
    struct thud_text out = {0};
    enum thud_image image = tui->backend->image(tui->backend, &w, &h);
    tui->backend->size(tui->backend, &columns, &rows);
    if (image == THUD_IMAGE_NONE || thud_canvas_resize(&tui->canvas, columns, rows, NULL) != THUD_OK)
        return;
    thud_image_draw(image, picture->data, picture->size, columns, rows - ROWS_BELOW, &out);
    struct thud_pane page = thud_canvas_pane(&tui->canvas);
    const char *how = "any key goes back ";
    char fitted[sizeof tui->files.written];
    thud_utf8_fit(tui->files.written, columns - thud_utf8_columns(how) - 3, fitted, sizeof fitted);
    thud_pane_put(&page, 1, rows - 1, thud_look(THUD_ROLE_PLAIN, 0), fitted);
    thud_pane_right(&page, columns, rows - 1, thud_look(THUD_ROLE_KEY, THUD_BOLD), how);
    tui->backend->repaint(tui->backend);
    tui->backend->show(tui->backend, &tui->canvas);
    if (!out.failed) {
        tui->backend->raw(tui->backend, out.data, out.size);
        tui->files.picture = image;
    }
    thud_text_clear(&out);
}

void thud_tui_leave_picture(struct thud_tui *tui)
{
    const char *clear = thud_image_clear(tui->files.picture);
    tui->files.picture = THUD_IMAGE_NONE;
    if (*clear)
        tui->backend->raw(tui->backend, clear, strlen(clear));
    tui->backend->repaint(tui->backend);
    thud_tui_redraw(tui, false);
}
