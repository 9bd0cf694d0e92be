/* What is said, what is asked over the screen, and where the cursor is: wanted by screens, done by the loop. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/scan.h"
#include "tui/document/state.h"

void thud_tui_keep_message(struct thud_tui *tui, const char *before, const char *text)
{
    enum { BYTES_MAX = 1 << 16 };
    struct thud_text *all = &tui->messages;
    size_t kept = all->size > BYTES_MAX ? 0 : all->size;
    for (size_t at = kept, n; at < all->size; at += n) { /* of the older half the commands stay */
        n = strcspn(all->data + at, "\n") + 1;
        memmove(all->data + kept, all->data + at, n);
        kept += all->data[kept] == ':' || at > all->size / 2 ? n : 0;
    }
    all->size = kept;
    thud_text_append(all, "%s%s\n", before, text);
}

void thud_tui_say(struct thud_tui *tui, enum thud_role role, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    vsnprintf(tui->said.text, sizeof tui->said.text, fmt, args);
    va_end(args);
    if (*tui->said.text)
        thud_tui_keep_message(tui, "", tui->said.text);
    tui->said.role = role;
    tui->said.status = THUD_INPUT;
    tui->redraw.wanted = true;
}

/* Shortens what stands in quotes, so that the reason behind it has room on the lowest lines. */
static void shorten_quoted(char *text)
{
    enum { MOST = 40, KEPT = 32 };
    for (char *from = strchr(text, '"'), *end; from && (end = strchr(from + 1, '"')) != NULL;) {
        if (end - from > MOST) {
            char *cut = from + KEPT;
            while (((unsigned char)*cut & 0xc0) == 0x80) /* whole code points */
                cut--;
            memcpy(cut, "...", 3);
            memmove(cut + 3, end, strlen(end) + 1);
            end = cut + 3;
        }
        from = strchr(end + 1, '"');
    }
}

const char *thud_tui_error_text(const struct thud_error *err, char *text, size_t size)
{
    struct thud_error here = *err;
    if (strcmp(err->key, "record.file") == 0 && strncmp(err->allowed, "`record.file", 12) == 0)
        snprintf(here.allowed, sizeof here.allowed, "3 Record: Enter on a ground motion takes it");
    thud_error_text(&here, text, size);
    shorten_quoted(text);
    return text;
}

void thud_tui_say_error(struct thud_tui *tui, const struct thud_error *err)
{
    char text[600];
    thud_tui_say(tui, THUD_ROLE_ERROR, "! %s", thud_tui_error_text(err, text, sizeof text));
    tui->said.status = err->status == THUD_USAGE ? THUD_INPUT : err->status; /* a line is no command line */
}

bool thud_tui_succeeded(struct thud_tui *tui, enum thud_status status, const struct thud_error *err)
{
    if (status != THUD_OK)
        thud_tui_say_error(tui, err);
    return status == THUD_OK;
}

void thud_tui_hush(struct thud_tui *tui)
{
    tui->said.text[0] = '\0';
}

void thud_tui_redraw(struct thud_tui *tui, bool now)
{
    tui->redraw.wanted = true;
    tui->redraw.now |= now;
}

void thud_tui_drawn(struct thud_tui *tui)
{
    tui->redraw.drawn_s = tui->backend->now(tui->backend);
    tui->redraw.wanted = tui->redraw.now = false;
    tui->redraw.edits = tui->doc.edits;
    tui->redraw.screen = tui->screen;
}

void thud_tui_normal(struct thud_tui *tui)
{
    tui->dialog.mode = THUD_MODE_NORMAL;
}

void thud_tui_prompt(struct thud_tui *tui, const struct thud_prompt *prompt, const char *text)
{
    tui->dialog.mode = THUD_MODE_TYPING;
    tui->dialog.prompt = prompt;
    tui->dialog.at = tui->dialog.ncommands;
    if (prompt && !prompt->commands) /* what is typed replaces a proposal; a command is typed on */
        thud_line_select(&tui->dialog.line, text);
    else
        thud_line_set(&tui->dialog.line, text);
}

void thud_tui_type(struct thud_tui *tui, const char *key, const char *text, bool select)
{
    snprintf(tui->dialog.target, sizeof tui->dialog.target, "%s", key);
    thud_tui_prompt(tui, NULL, text);
    if (select)
        thud_line_select(&tui->dialog.line, text);
    thud_tui_hush(tui);
}

bool thud_tui_types_field(const struct thud_tui *tui)
{
    return tui->dialog.mode == THUD_MODE_TYPING && !tui->dialog.prompt;
}

void thud_tui_choose(struct thud_tui *tui, thud_chosen_fn *chosen, const char *title)
{
    tui->dialog.mode = THUD_MODE_CHOOSING;
    tui->dialog.chosen = chosen;
    thud_chooser_begin(&tui->dialog.chooser, title);
}

void thud_tui_chosen(struct thud_tui *tui)
{
    const struct thud_choice *choice = thud_chooser_marked(&tui->dialog.chooser);
    char value[sizeof choice->value];
    if (!choice)
        return;
    thud_tui_normal(tui);
    memcpy(value, choice->value, sizeof value);
    if (tui->dialog.chosen)
        tui->dialog.chosen(tui, value);
}

void thud_tui_ask(struct thud_tui *tui, const struct thud_question *question, const char *target, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    vsnprintf(tui->said.text, sizeof tui->said.text, fmt, args);
    va_end(args);
    tui->said.role = THUD_ROLE_WARN;
    snprintf(tui->dialog.target, sizeof tui->dialog.target, "%s", target);
    tui->dialog.mode = THUD_MODE_ASKING;
    tui->dialog.question = question;
}

void *thud_tui_over(struct thud_tui *tui, const struct thud_over *over)
{
    thud_tui_over_free(tui);
    tui->dialog.own = calloc(1, over->size);
    if (!tui->dialog.own) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "! no memory for the form");
        return NULL;
    }
    tui->dialog.mode = THUD_MODE_OVER;
    tui->dialog.over = over;
    thud_tui_hush(tui);
    return tui->dialog.own;
}

void thud_tui_over_free(struct thud_tui *tui)
{
    if (tui->dialog.over && tui->dialog.over->free)
        tui->dialog.over->free(tui);
    free(tui->dialog.own);
    tui->dialog.own = NULL;
    tui->dialog.over = NULL;
}

void thud_tui_offer(struct thud_tui *tui, int screen, const char *command, const char *fmt, ...)
{
    struct thud_choice line;
    va_list args;
    va_start(args, fmt);
    vsnprintf(line.text, sizeof line.text, fmt, args);
    va_end(args);
    if (snprintf(line.value, sizeof line.value, "%d %s", screen, command) < (int)sizeof line.value)
        thud_chooser_add(&tui->dialog.chooser, line.value, "%s", line.text);
}

void thud_tui_go(struct thud_tui *tui, int screen)
{
    if (screen != tui->screen && tui->screen != THUD_SCREEN_HELP)
        tui->before = tui->screen;
    if (screen < THUD_SCREENS)
        tui->taken[THUD_ACTIONS + screen] += screen != tui->screen;
    tui->screen = screen;
    tui->form.screen = screen;
    thud_tui_hush(tui);
}

/* The screen whose fields begin like this key; the longest beginning holds. */
static int screen_of(const struct thud_tui *tui, const char *key)
{
    int best = -1;
    size_t most = 0;
    for (int i = 0; i < tui->screens; i++) {
        for (const char *begin = tui->view[i]->keys; begin; begin = strchr(begin, ' ')) {
            begin += *begin == ' ';
            size_t n = strcspn(begin, " ");
            if (strncmp(key, begin, n) == 0 && (best < 0 || n > most)) {
                best = i;
                most = n;
            }
        }
    }
    return best;
}

void thud_tui_go_to_field(struct thud_tui *tui, const char *key)
{
    int number = 0, last = tui->doc.scene.nstructures - 2, screen = screen_of(tui, key);
    const char *at = key;
    if (thud_scan_word(&at, "structures.") && thud_scan_count(&at, &number)) {
        if (number - 1 < tui->interface || number - 1 > tui->interface + 1)
            tui->interface = number - 1 > last ? last : number - 1;
    } else if (thud_scan_word(&at, "interfaces.") && thud_scan_count(&at, &number)) {
        tui->interface = number - 1;
    }
    if (tui->interface < 0)
        tui->interface = 0;
    if (screen < 0)
        return;
    thud_form_focus_on(&tui->form, screen, key);
    thud_tui_go(tui, screen);
}

struct thud_rect thud_tui_area(const struct thud_tui *tui)
{
    int top = tui->screen != THUD_SCREEN_HELP && tui->canvas.height >= 12 ? 3 : 2,
        bottom = tui->canvas.height < 16 ? 2 : 3;
    return (struct thud_rect){0, top, tui->canvas.width, tui->canvas.height - top - bottom};
}

bool thud_tui_one_pane(const struct thud_tui *tui)
{
    return tui->canvas.width < THUD_DESIGN_WIDTH || tui->canvas.height < THUD_DESIGN_HEIGHT;
}

bool thud_tui_too_small(struct thud_tui *tui)
{
    int width, height;
    tui->backend->size(tui->backend, &width, &height);
    return width < THUD_LEAST_WIDTH || height < THUD_LEAST_HEIGHT;
}

struct thud_chart thud_tui_reading(struct thud_tui *tui, double cursor)
{
    struct thud_chart_window *window = &tui->window[tui->screen];
    double span = window->to - window->from;
    if (span > 0.0 && (cursor < window->from || cursor > window->to)) {
        double from = fmax(0.0, cursor - 0.5 * span); /* no x of a chart that is read is negative */
        *window = (struct thud_chart_window){from, from + span};
    }
    return (struct thud_chart){.cursor = cursor, .drawn = &tui->chart, .window = *window};
}

char *thud_tui_number(double value, char text[24])
{
    if (isnan(value))
        return strcpy(text, "·");
    if (isinf(value))
        return strcpy(text, value > 0.0 ? "inf" : "-inf");
    const double nothing = 1e-12; /* in any unit that is shown: rounding of a speed of 0, say */
    double size = fabs(value);
    if (size < nothing)
        return strcpy(text, "0");
    if (size >= 1e6 || size < 1e-3)
        snprintf(text, 24, "%.2e", value);
    else if (size >= 99.95)
        snprintf(text, 24, "%.0f", value);
    else
        snprintf(text, 24, "%.*f",
                 size >= 9.995      ? 1
                 : size >= 0.9995   ? 2
                 : size >= 0.09995  ? 3
                 : size >= 0.009995 ? 4
                                    : 5,
                 value);
    return text;
}
