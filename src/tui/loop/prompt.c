/* Keys of a prompt beside those of a line: the lines typed before, and completion. */
#include <dirent.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "tui/loop/loop.h"

/* Candidates for the word at the end of the line, and what they have in common. */
struct completion {
    const char *word;
    char common[256], list[300];
    int n;
};

static void offer(struct completion *c, const char *candidate, const char *end)
{
    size_t n = strlen(c->word), same = 0;
    char whole[256];
    snprintf(whole, sizeof whole, "%s%s", candidate, end);
    if (strncmp(whole, c->word, n) != 0)
        return;
    if (c->n++ == 0)
        snprintf(c->common, sizeof c->common, "%s", whole);
    while (c->common[same] && c->common[same] == whole[same])
        same++;
    c->common[same] = '\0';
    thud_append(c->list, sizeof c->list, "%s%s", *c->list ? "  " : "", candidate);
}

/* What stands in a folder, without this ending (of files that have another: nothing), with `before` in front. */
static void offer_folder(struct completion *c, const char *folder, const char *before, const char *ending)
{
    DIR *dir = opendir(folder);
    for (struct dirent *entry; dir && (entry = readdir(dir)) != NULL;) {
        const size_t n = strlen(entry->d_name), m = strlen(ending);
        char path[1024], name[600];
        struct stat info;
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        if (*entry->d_name == '.' || n <= m || strcmp(entry->d_name + n - m, ending) != 0 || stat(path, &info) != 0)
            continue;
        snprintf(name, sizeof name, "%s%.*s", before, (int)(n - m), entry->d_name);
        offer(c, name, S_ISDIR(info.st_mode) ? "/" : "");
    }
    if (dir)
        closedir(dir);
}

/* Files and folders that begin like the word: from the working folder, or the folder in it. */
static void offer_files(struct completion *c)
{
    char folder[256];
    const char *slash = strrchr(c->word, '/');
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - c->word) + 1 : 0, c->word);
    offer_folder(c, *folder ? folder : ".", folder, "");
}

static void offer_words(struct thud_tui *tui, struct completion *c, const char *command, size_t n)
{
    if (n == 0) {
        struct thud_text words = {0};
        thud_commands_text(&words);
        char *rest = words.data;
        for (char *line; rest && (line = strtok_r(rest, "\n", &rest)) != NULL;) {
            line[strcspn(line, " ")] = '\0';
            offer(c, line + 1, " ");
        }
        thud_text_clear(&words);
    } else if (strncmp(command, "set", n) == 0 || strncmp(command, "vary", n) == 0) {
        thud_tui_fill_fields(tui);
        for (int i = 0; i < tui->dialog.chooser.n; i++)
            offer(c, tui->dialog.chooser.choice[i].value, *command == 's' ? " " : "=");
        offer(c, "gap", *command == 's' ? " " : "=");
    } else {
        if (strncmp(command, "record", n) == 0)
            offer_folder(c, tui->doc.paths->records, "", "");
        if (strncmp(command, "open", n) == 0)
            offer_folder(c, tui->doc.paths->presets, "", ".yaml");
        offer_files(c);
    }
}

static void complete(struct thud_tui *tui)
{
    struct completion c = {0};
    char *text = tui->dialog.line.text, *last = strrchr(text, ' ');
    char word[256];
    if (tui->dialog.line.cursor != (int)strlen(text))
        return;
    if (!tui->dialog.prompt->commands)
        last = NULL;
    snprintf(word, sizeof word, "%.255s", last ? last + 1 : text);
    c.word = word;
    if (tui->dialog.prompt->commands)
        offer_words(tui, &c, text, last ? strcspn(text, " ") : 0);
    else
        offer_files(&c);
    if (c.n == 0) {
        thud_tui_say(tui, THUD_ROLE_WARN, "nothing begins with \"%s\"", word);
        return;
    }
    char whole[THUD_LINE_MAX];
    snprintf(whole, sizeof whole, "%.*s%s", last ? (int)(last + 1 - text) : 0, text, c.common);
    thud_line_set(&tui->dialog.line, whole);
    thud_tui_hush(tui);
    if (c.n > 1)
        thud_tui_say(tui, THUD_ROLE_PLAIN, "%s", c.list);
}

void thud_tui_remember(struct thud_tui *tui, const char *text)
{
    if (!*text || (tui->dialog.ncommands > 0 && strcmp(tui->dialog.command[tui->dialog.ncommands - 1], text) == 0))
        return;
    if (tui->dialog.ncommands == THUD_HISTORY)
        memmove(tui->dialog.command[0], tui->dialog.command[1],
                sizeof tui->dialog.command - sizeof *tui->dialog.command);
    else
        tui->dialog.ncommands++;
    snprintf(tui->dialog.command[tui->dialog.ncommands - 1], sizeof *tui->dialog.command, "%s", text);
}

bool thud_tui_prompt_key(struct thud_tui *tui, int key)
{
    const struct thud_prompt *prompt = tui->dialog.prompt;
    if (key == THUD_KEY_TAB && prompt->files) {
        complete(tui);
        return true;
    }
    if (!prompt->commands || (key != THUD_KEY_UP && key != THUD_KEY_DOWN))
        return false;
    int at = tui->dialog.at + (key == THUD_KEY_UP ? -1 : 1);
    if (at >= 0 && at <= tui->dialog.ncommands) {
        tui->dialog.at = at;
        thud_line_set(&tui->dialog.line, at < tui->dialog.ncommands ? tui->dialog.command[at] : "");
    }
    return true;
}
