#include "tui/document/session_log.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "io/file/file.h"

static const char head[] = "# A session of thud: `thud --play FILE` repeats it";

void thud_tui_log(struct thud_tui *tui, const char *fmt, ...)
{
    struct thud_text line = {0};
    va_list args;
    va_start(args, fmt);
    thud_text_append_list(&line, fmt, args);
    va_end(args);
    if (line.data && !line.failed) {
        line.data[strcspn(line.data, "\r\n")] = '\0';
        thud_text_append(&tui->log, "%s\n", line.data);
        thud_tui_keep_message(tui, ":", line.data);
    }
    tui->log.failed |= line.failed; /* it cannot be saved without this line */
    thud_text_clear(&line);
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
    thud_text_append(&text, "%s\n%s", head, tui->log.data ? tui->log.data : "");
    if (thud_text_write(&text, path, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written %s: thud --play %s repeats it", path, path);
}
