/* Commands of the command line, run on the preset that is open: typed behind `:`, or put together in a form of their
 * own options. What they are and what they take comes from the command line's tables. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/run/command.h"
#include "io/file/file.h"
#include "tui/document/command_work.h"
#include "tui/document/form_over.h"
#include "tui/document/session_log.h"
#include "tui/loop/loop.h"

enum { WORDS_MAX = 60 };

/* Cuts a line into words as a shell would, in place; returns how many, `most` where there are at least so many. */
static int cut_words(char *text, char **word, int most)
{
    int n = 0;
    while (n < most && *(text += strspn(text, " "))) {
        char quote = '\0', *to = text;
        word[n++] = text;
        for (; *text && (quote || *text != ' '); text++) {
            if (*text == quote)
                quote = '\0';
            else if (!quote && (*text == '\'' || *text == '"'))
                quote = *text;
            else
                *to++ = *text;
        }
        text += *text == ' ';
        *to = '\0';
    }
    return n;
}

/* What leaves the program is of a file that can be looked up; a study is of what stands on the screen. */
static bool of_file(int id)
{
    return id == THUD_COMMAND_REPORT || id == THUD_COMMAND_EXPORT || id == THUD_COMMAND_VERIFY;
}

void thud_tui_verb(struct thud_tui *tui, int id, const char *text)
{
    const struct thud_command *command = thud_command_at((enum thud_command_id)id);
    char *word[WORDS_MAX + 4] = {(char *)command->name};
    struct thud_text copy = {0};
    struct thud_error err = {0};
    int n = 1;
    if (tui->files.command || tui->files.work) {
        thud_tui_say(tui, THUD_ROLE_WARN, "Files are being written; Esc stops that");
        return;
    }
    const bool unsaved = thud_doc_unsaved(&tui->doc);
    if (unsaved && of_file(id)) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "! thud %s is of the file, and there are changes: w saves them first",
                     command->name);
        return;
    }
    if (unsaved && thud_doc_recover(&tui->doc, &err) != THUD_OK) {
        thud_tui_say_error(tui, &err);
        return;
    }
    thud_text_append(&copy, "%s", text);
    int typed = copy.failed ? 0 : cut_words(copy.data, word + 1, WORDS_MAX);
    if (command->word == THUD_WORD_PROGRAM && typed > 0) { /* its name stands before the preset */
        n = 2;
        typed--;
    }
    memmove(word + n + 1, word + n, (size_t)typed * sizeof *word);
    word[n] = unsaved ? tui->doc.kept : tui->doc.path;
    word[n + 1 + typed] = NULL;
    enum thud_status status =
        copy.failed || typed + n > WORDS_MAX
            ? thud_error_set(&err, THUD_USAGE, "thud %s here takes fewer than %d words", command->name, WORDS_MAX)
            : thud_command_work_start(tui->options.program, word, &tui->files.command, &err);
    thud_text_clear(&copy);
    if (!thud_tui_succeeded(tui, status, &err))
        return;
    tui->backend->also = thud_command_work_fd(tui->files.command);
    tui->files.screen = tui->screen;
    tui->files.asked_for = tui->doc.revision;
    snprintf(tui->files.written, sizeof tui->files.written, "thud %s", command->name);
    thud_tui_log(tui, "%s %s", command->name, text);
    thud_tui_say(tui, THUD_ROLE_PLAIN, "thud %s is running; Esc stops it", command->name);
}

/* Takes the figures that have come, each in place of an older one of its name; the last one's, or NULL. */
static const struct thud_figure *take_figures(struct thud_tui *tui)
{
    struct thud_files *files = &tui->files;
    struct thud_figure *figure, *last = NULL;
    while ((figure = thud_command_work_figure(files->command)) != NULL) {
        int i = 0;
        while (i < files->nmade && strcmp(files->made[i].figure->name, figure->name) != 0)
            i++;
        i = i < THUD_PICTURES_MAX ? i : THUD_PICTURES_MAX - 1;
        if (i < files->nmade)
            thud_figure_free(files->made[i].figure);
        else
            files->nmade = i + 1;
        files->made[i] = (struct thud_made){figure, files->asked_for};
        files->arrived++;
        last = figure;
    }
    return last;
}

/* Files that were written are said, the rest is shown as it is printed: where figures are on show, in the list of
 * messages. */
static void show(struct thud_tui *tui, struct thud_text *printed)
{
    char files[500] = "", title[96], *rest = printed->data;
    int lines = 0, named = 0;
    if (tui->dialog.mode == THUD_MODE_OVER) {
        for (char *line; rest && (line = thud_text_line(&rest)) != NULL;)
            thud_tui_keep_message(tui, "  ", line);
        thud_tui_say(tui, THUD_ROLE_GOOD, "%s is done%s", tui->files.written,
                     printed->size > 0 ? "; Ctrl-O has its table" : "");
        return;
    }
    snprintf(title, sizeof title, "%.90s", tui->files.written);
    thud_tui_hush(tui);
    thud_tui_choose(tui, NULL, title);
    for (char *line; rest && (line = thud_text_line(&rest)) != NULL; lines++) {
        if (*line && access(line, F_OK) == 0 && named++ >= 0)
            thud_append(files, sizeof files, "%s%s", *files ? ", " : "", line);
        thud_chooser_add(&tui->dialog.chooser, line, "%s", line);
    }
    if (named < lines && !tui->end.playing)
        return;
    thud_tui_normal(tui);
    thud_tui_say(tui, THUD_ROLE_GOOD, named ? "Written %s" : "%s is done", named ? files : tui->files.written);
}

void thud_tui_verb_look(struct thud_tui *tui)
{
    char line[200];
    struct thud_text printed = {0}, said = {0};
    bool going = thud_command_work_look(tui->files.command, line, sizeof line);
    const struct thud_figure *figure = take_figures(tui);
    if (figure && tui->dialog.mode == THUD_MODE_NORMAL && tui->files.screen == tui->screen && !tui->end.playing)
        thud_tui_shelf_at(tui, figure->name);
    thud_tui_redraw(tui, false);
    if (going) {
        if (*line)
            thud_tui_say(tui, THUD_ROLE_PLAIN, "%s: %s", tui->files.written, line);
        return;
    }
    int status = thud_command_work_finish(tui->files.command, &printed, &said);
    tui->files.command = NULL;
    tui->backend->also = -1;
    if (!tui->end.keeps) /* it was made for the command */
        thud_doc_forget_kept(&tui->doc);
    const bool shelf = tui->dialog.mode == THUD_MODE_OVER && tui->dialog.over->where == THUD_AT_SHELF;
    if (status == 0 && (shelf || tui->dialog.mode == THUD_MODE_NORMAL))
        show(tui, &printed);
    else if (status == 0)
        thud_tui_say(tui, THUD_ROLE_GOOD, "%s is done", tui->files.written);
    else if (status == 128 + 2)
        thud_tui_say(tui, THUD_ROLE_WARN, "%s was stopped; nothing is half written", tui->files.written);
    else {
        const char *why = *line ? line + (strncmp(line, "thud: ", 6) == 0 ? 6 : 0) : "it failed without a word";
        const bool named = strncmp(why, tui->files.written, strlen(tui->files.written)) == 0;
        thud_tui_say(tui, THUD_ROLE_ERROR, "! %s%s%s", named ? "" : tui->files.written, named ? "" : ": ", why);
        tui->said.status = status == THUD_USAGE ? THUD_INPUT : (enum thud_status)status;
    }
    thud_text_clear(&printed);
    thud_text_clear(&said);
}

/* ---- the form ---- */

/* Those that print for another program, or nothing at all, have no use here. */
static bool has_use(const struct thud_option *option)
{
    static const char *const not [] = {"help", "quiet", "json", "csv", "words"};
    for (size_t i = 0; i < sizeof not / sizeof *not ; i++)
        if (strcmp(option->name, not [i]) == 0)
            return false;
    return true;
}

static void run_form(struct thud_tui *tui, struct thud_form_over *form)
{
    struct thud_text text = {0};
    const int id = form->id;
    for (int i = 0; i < form->n; i++) {
        const struct thud_option *option = form->row[i].of;
        const char *value = form->row[i].value[0].text;
        if (!*value)
            continue;
        if (option)
            thud_text_append(&text, "%s%s%s%s", text.size ? " " : "", option->name[1] ? "--" : "-", option->name,
                             !option->argument                  ? ""
                             : thud_option_stands_alone(option) ? "="
                                                                : " ");
        const char *quote = !strchr(value, ' ') ? "" : strchr(value, '"') ? "'" : "\"";
        if (!option || option->argument)
            thud_text_append(&text, "%s%s%s", quote, value, quote);
    }
    thud_tui_normal(tui);
    if (text.failed)
        thud_tui_say(tui, THUD_ROLE_ERROR, "! no memory for the command");
    else
        thud_tui_verb(tui, id, text.data ? text.data : "");
    thud_text_clear(&text);
}

/* A switch is said, or it is not. */
static const char *choice_of(const struct thud_over_row *row, int i)
{
    const struct thud_option *option = row->of;
    return option->argument ? thud_option_choice(option, i) : i == 0 ? "yes" : i == 1 ? "" : NULL;
}

/* The files of the marked designs, of none those with names, but for what is open itself. */
static void designs_of_report(struct thud_tui *tui, struct thud_line *line)
{
    char text[THUD_LINE_MAX] = "", path[600];
    bool any = false;
    for (int i = 0; i < tui->designs.n; i++)
        any = any || tui->designs.item[i].marked;
    for (int i = 0; i < tui->designs.n; i++) {
        const struct thud_design *d = &tui->designs.item[i];
        thud_tui_design_path(tui, d->name, path, sizeof path);
        if (!*d->name || (!d->marked && any) || strcmp(path, tui->doc.path) == 0 ||
            thud_doc_runs_alike(d->scene, &tui->doc.scene) || access(path, F_OK) != 0)
            continue;
        if (strlen(text) + strlen(path) + 2 > sizeof text)
            thud_tui_say(tui, THUD_ROLE_WARN, "! --beside has no room for %s", path);
        else
            thud_append(text, sizeof text, "%s%s", *text ? "," : "", path);
    }
    thud_line_set(line, text);
}

/* Where it writes comes first, then the title block, then the command's own options; what the scene says is last. */
static int rank_of(const struct thud_option *option)
{
    const struct thud_param *block;
    for (int i = 0; (block = thud_group_param(THUD_GROUP_DOCUMENT, i)); i++)
        if (strcmp(block->name, option->name) == 0)
            return 1;
    return strcmp(option->name, "o") == 0 ? 0 : thud_option_belongs(option, THUD_COMMAND_RUN) ? 3 : 2;
}

void thud_tui_verb_form(struct thud_tui *tui, int id)
{
    enum { RANKS = 4 };
    char folder[THUD_NAME_MAX + 32], label[60];
    const struct thud_command *command = thud_command_at((enum thud_command_id)id);
    struct thud_form_over *form = thud_form_over_begin(tui);
    if (!form)
        return;
    form->id = id;
    form->done = run_form;
    snprintf(form->title, sizeof form->title, "thud %s: %s", command->name, command->summary);
    snprintf(folder, sizeof folder, "%s-%s", tui->doc.scene.name, command->name);
    if (command->word == THUD_WORD_PROGRAM)
        thud_form_over_add(form, "program", "that the scene is written for", "opensees");
    for (int rank = 0; rank < RANKS; rank++)
        for (int i = 0; i < thud_option_count() && form->n < THUD_OVER_ROWS; i++) {
            const struct thud_option *option = thud_option_at(i);
            if (rank_of(option) != rank || !thud_option_belongs(option, (enum thud_command_id)id) || !has_use(option))
                continue;
            snprintf(label, sizeof label, "%s%s %s", option->name[1] ? "--" : "-", option->name,
                     option->argument ? option->argument : "");
            struct thud_over_row *row = thud_form_over_add(form, label, option->help, rank == 0 ? folder : "");
            row->of = option;
            row->only = !option->argument;
            row->choice = row->only || thud_option_choice(option, 0) ? choice_of : NULL;
            if (strcmp(option->name, "beside") == 0)
                designs_of_report(tui, &row->value[0]);
            if (strcmp(option->name, "figures") == 0)
                thud_line_set(&row->value[0], tui->files.for_report);
        }
    tui->files.for_report[0] = '\0'; /* the next one may be of another scene */
    thud_form_over_focus(form, 0, 0);
}
