#include "tui/document/session_log.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "io/file/file.h"

static const char head[] = "# A session of thud: `thud --play FILE` repeats it";

void thud_tui_log(struct thud_tui *tui, const char *fmt, ...)
{
    struct thud_text *all = &tui->messages;
    va_list args;
    va_start(args, fmt);
    thud_text_append(all, ":");
    const size_t from = all->size;
    thud_text_append_list(all, fmt, args);
    va_end(args);
    if (!all->failed)
        all->size = from + strcspn(all->data + from, "\r\n");
    thud_text_append(all, "\n");
}

/* Where the last command before `end` begins; `end` where there is none. */
static size_t command_before(const struct thud_text *all, size_t end)
{
    for (size_t at = end; at-- > 0;)
        if (all->data[at] == ':' && (at == 0 || all->data[at - 1] == '\n'))
            return at;
    return end;
}

void thud_tui_log_again(struct thud_tui *tui)
{
    struct thud_text *all = &tui->messages;
    const size_t last = command_before(all, all->size), from = command_before(all, last);
    memmove(all->data + from, all->data + last, all->size - last + 1);
    all->size -= last - from;
}

void thud_tui_show_log(struct thud_tui *tui)
{
    thud_tui_choose(tui, NULL, "What was done and said (:log FILE saves it, thud --play FILE plays it)");
    for (const char *line = tui->messages.data; line && *line;) {
        int n = (int)strcspn(line, "\n");
        thud_chooser_add(&tui->dialog.chooser, "", "%.*s", n, line);
        line += n + (line[n] == '\n');
    }
    tui->dialog.chooser.at = tui->dialog.chooser.n > 0 ? tui->dialog.chooser.n - 1 : 0;
}

static bool is_log_or_nothing(const char *path)
{
    char first[sizeof head] = "";
    FILE *file = fopen(path, "r");
    if (!file)
        return true;
    bool same = fgets(first, sizeof first, file) && strcmp(first, head) == 0;
    fclose(file);
    return same;
}

void thud_tui_save_log(struct thud_tui *tui, const char *path)
{
    struct thud_text text = {0};
    struct thud_error err;
    if (!is_log_or_nothing(path)) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "! %s exists and is no session: another name", path);
        return;
    }
    thud_text_append(&text, "%s\n", head);
    for (const char *line = tui->messages.data; line && *line; line += strcspn(line, "\n") + 1)
        if (*line == ':')
            thud_text_bytes(&text, line + 1, strcspn(line, "\n"));
    text.failed |= tui->messages.failed;
    if (thud_text_write(&text, path, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written %s: thud --play %s repeats it", path, path);
}
