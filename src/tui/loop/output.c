/* Pictures and tables of the screen shown. */
#include <stdio.h>
#include <string.h>

#include "tui/loop/loop.h"

bool thud_tui_show_figure(struct thud_tui *tui, const char *name)
{
    enum { FIGURES_MOST = 500 };
    const struct thud_view *view = thud_tui_view(tui);
    for (int i = 0; i < FIGURES_MOST && view->figure; i++) {
        const struct thud_figure *figure = view->figure(tui);
        if (figure && strcmp(figure->name, name) == 0)
            return true;
        if (view->next_figure)
            view->next_figure(tui);
        thud_tui_draw(tui);
    }
    return false;
}

/* The histories kept for display are too coarse for a file of what moves: repeats the run with whole histories, then
 * the action. */
static bool needs_whole(struct thud_tui *tui, enum thud_action action)
{
    const enum thud_live_history kept = tui->run.live.history;
    if (!thud_tui_view(tui)->read_at || kept == THUD_LIVE_NO_HISTORY || kept == THUD_LIVE_WHOLE)
        return false;
    tui->files.whole_wanted = action;
    thud_tui_say(tui, THUD_ROLE_PLAIN, "Running with whole histories, for the file");
    thud_tui_run(tui);
    return true;
}

void thud_tui_picture(struct thud_tui *tui)
{
    if (needs_whole(tui, THUD_DO_PICTURE))
        return;
    thud_tui_picture_of(tui, thud_tui_view(tui)->figure(tui));
}

void thud_tui_export(struct thud_tui *tui)
{
    const struct thud_view *view = thud_tui_view(tui);
    if (needs_whole(tui, THUD_DO_EXPORT))
        return;
    if (view->export_csv) {
        view->export_csv(tui);
        return;
    }
    struct thud_text csv = {0};
    char name[200], file[210];
    const struct thud_figure *figure = view->figure(tui);
    thud_tui_file_name(tui, figure->name, "", name, sizeof name);
    snprintf(file, sizeof file, "%s.csv", name);
    thud_figure_csv(figure, &csv);
    thud_tui_write(tui, &csv, file);
}

/* The rows of a pane as it is drawn, blanks between its columns as one tab. */
static void pane_text(struct thud_tui *tui, struct thud_text *out)
{
    struct thud_rect rect[THUD_PANES_MAX], area = thud_tui_area(tui), at = area;
    int n = thud_tui_view(tui)->layout(tui, area, rect), here = tui->form.pane[tui->screen];
    if (!thud_tui_one_pane(tui) && here < n)
        at = rect[here];
    for (int y = at.y + 1; y < at.y + at.h - 1; y++) {
        int blanks = 0;
        bool any = false;
        for (int x = at.x + 1; x < at.x + at.w - 1; x++) {
            char utf8[5];
            uint32_t glyph = tui->canvas.cell[y * tui->canvas.width + x].glyph;
            if (glyph == THUD_CELL_TAIL)
                continue;
            if (glyph == ' ' || glyph == 0x25b8) { /* the cursor's mark */
                blanks++;
                continue;
            }
            utf8[thud_utf8_put(glyph, utf8)] = '\0';
            thud_text_append(out, "%s%s", !any || blanks == 0 ? "" : blanks == 1 ? " " : "\t", utf8);
            any = true;
            blanks = 0;
        }
        if (any)
            thud_text_append(out, "\n");
    }
}

void thud_tui_copy(struct thud_tui *tui)
{
    enum { BYTES_MAX = 70000 }; /* terminals take no more, about */
    const struct thud_view *view = thud_tui_view(tui);
    const struct thud_figure *figure = !thud_form_focus(&tui->form) && view->figure ? view->figure(tui) : NULL;
    struct thud_text text = {0};
    if (figure)
        thud_figure_csv(figure, &text);
    else
        pane_text(tui, &text);
    if (text.failed || !text.data || text.size > BYTES_MAX)
        thud_tui_say(tui, THUD_ROLE_WARN, "There is too much, or nothing, to copy here: e writes it as CSV");
    else {
        tui->backend->copy(tui->backend, text.data);
        thud_tui_say(tui, THUD_ROLE_PLAIN, "Copied %s of %zu bytes, if the terminal lets it",
                     figure ? "the chart's data" : "the pane", (size_t)text.size);
    }
    thud_text_clear(&text);
}
