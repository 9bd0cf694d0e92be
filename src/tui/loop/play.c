/* A session played without a terminal: every command is carried out to its end, and what came of it is printed. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/file/file.h"
#include "tui/loop/play.h"
#include "tui/loop/verdict.h"
#include "tui/terminal/canvas_svg.h"

enum { WIDTH = 100, HEIGHT = 40, BYTES_MAX = 1 << 30 };

/* Works until nothing is left to do. */
static void finish_work(struct thud_tui *tui)
{
    while (thud_tui_turn(tui, false) || tui->files.work || tui->files.command)
        if (tui->files.work || tui->files.command)
            thud_tui_turn(tui, true);
    thud_tui_draw(tui);
}

static void print_screen(struct thud_tui *tui, struct thud_text *out)
{
    char *text = thud_canvas_text(&tui->canvas);
    if (text)
        thud_text_append(out, "%s", text);
    out->failed |= !text;
    free(text);
}

/* One line. Errors: those of the line, which was refused. */
static enum thud_status play_line(struct thud_tui *tui, char *line, struct thud_text *out, struct thud_error *err)
{
    char before[sizeof tui->verdict.text];
    line += strspn(line, " \t:");
    if (!*line || *line == '#')
        return THUD_OK;
    memcpy(before, tui->verdict.text, sizeof before);
    size_t echo = out->size;
    thud_text_append(out, "> %s\n", line);
    if (!out->failed)
        out->size = echo + thud_text_shown(out->data + echo, "\n");
    thud_tui_hush(tui);
    if (strcmp(line, "show") == 0) {
        print_screen(tui, out);
        return THUD_OK;
    }
    if (strncmp(line, "show ", 5) == 0) {
        struct thud_text svg = {0};
        thud_canvas_svg(&tui->canvas, &svg);
        return thud_text_write(&svg, line + 5 + strspn(line + 5, " "), err);
    }
    tui->end.playing = true;
    thud_tui_command(tui, line);
    finish_work(tui);
    tui->end.playing = false;
    if (tui->said.role == THUD_ROLE_ERROR && *tui->said.text)
        return thud_error_set(err, tui->said.status, "%s",
                              tui->said.text + 2 * (strncmp(tui->said.text, "! ", 2) == 0));
    if (tui->dialog.mode != THUD_MODE_NORMAL && !tui->end.quit)
        return thud_error_set(err, THUD_INPUT, "waits for an answer%s%s", *tui->said.text ? ": " : "", tui->said.text);
    if (*tui->said.text)
        thud_text_append(out, "%s\n", tui->said.text);
    if (*tui->verdict.text && strcmp(before, tui->verdict.text) != 0)
        thud_text_append(out, "%s\n", tui->verdict.text);
    return THUD_OK;
}

enum thud_status thud_tui_play_lines(struct thud_tui *tui, const char *path, struct thud_text *out,
                                     struct thud_error *err)
{
    char *text, *rest, *line;
    int number = 0;
    enum thud_status status = thud_text_read(path, BYTES_MAX, &text, err);
    if (status != THUD_OK)
        return status;
    finish_work(tui);
    if (*tui->verdict.text)
        thud_text_append(out, "%s\n", tui->verdict.text);
    for (rest = text; status == THUD_OK && !tui->end.quit && (line = thud_text_line(&rest)) != NULL;) {
        number++;
        if ((status = play_line(tui, line, out, err)) != THUD_OK) {
            char said[sizeof tui->said.text];
            thud_error_set(err, status, "%s", thud_error_text(err, said, sizeof said));
            thud_error_place(err, path, number, 0);
        }
    }
    free(text);
    return status;
}

enum thud_status thud_tui_play(const struct thud_tui_options *options, struct thud_error *err)
{
    struct thud_backend backend;
    struct thud_script script;
    struct thud_tui *tui;
    struct thud_text out = {0};
    thud_script_open(&backend, &script, WIDTH, HEIGHT, !options->ascii);
    enum thud_status status = thud_tui_create(options, &backend, &tui, err);
    if (status != THUD_OK)
        return status;
    thud_tui_normal(tui); /* neither a form nor a question */
    status = thud_tui_play_lines(tui, options->play, &out, err);
    struct thud_error lost = {0};
    const enum thud_status printed = thud_text_print(&out, &lost);
    if (printed != THUD_OK && err) /* which ends it, also behind a line that was refused */
        thud_append(err->what, sizeof err->what, "%s%s", status == THUD_OK ? "" : "; ", lost.what);
    thud_tui_free(tui);
    return printed == THUD_OK ? status : printed;
}
