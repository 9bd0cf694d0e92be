/* Commands of the command line, run on the preset that is open: typed behind `:`, or put together in a form of their own
 * options. What they are and what they take comes from the command line's tables. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/run/command.h"
#include "io/file/file.h"
#include "tui/document/command_work.h"
#include "tui/document/session_log.h"
#include "tui/loop/loop.h"

enum { WORDS_MAX = 60, OPTIONS_MAX = 80, NAME = 30, VALUE = 24 };

/* Cuts a line into words as a shell would, in place; returns how many. */
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

void thud_tui_verb(struct thud_tui *tui, int id, const char *text)
{
    const struct thud_command *command = thud_command_at((enum thud_command_id)id);
    char copy[THUD_LINE_MAX * 2], *word[WORDS_MAX + 4] = {(char *)command->name};
    struct thud_error err = {0};
    int n = 1;
    if (tui->files.command || tui->files.work) {
        thud_tui_say(tui, THUD_ROLE_WARN, "Files are being written; Esc stops that");
        return;
    }
    if (thud_doc_unsaved(&tui->doc)) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "! thud %s is of the file, and there are changes: w saves them first",
                     command->name);
        return;
    }
    snprintf(copy, sizeof copy, "%s", text);
    int typed = cut_words(copy, word + 1, WORDS_MAX);
    if (command->word == THUD_WORD_PROGRAM && typed > 0) { /* its name stands before the preset */
        n = 2;
        typed--;
    }
    memmove(word + n + 1, word + n, (size_t)typed * sizeof *word);
    word[n] = tui->doc.path;
    word[n + 1 + typed] = NULL;
    if (thud_command_work_start(tui->options.program, word, &tui->files.command, &err) != THUD_OK) {
        thud_tui_say_error(tui, &err);
        return;
    }
    tui->backend->also = thud_command_work_fd(tui->files.command);
    snprintf(tui->files.written, sizeof tui->files.written, "thud %s", command->name);
    thud_tui_log(tui, "%s %s", command->name, text);
    thud_tui_say(tui, THUD_ROLE_PLAIN, "thud %s is running; Esc stops it", command->name);
}

/* Files that were written are said, the rest is shown as it is printed. */
static void show(struct thud_tui *tui, struct thud_text *printed)
{
    char files[500] = "", title[96], *rest = printed->data;
    int lines = 0, named = 0;
    snprintf(title, sizeof title, "%.90s", tui->files.written);
    thud_tui_hush(tui);
    thud_tui_choose(tui, NULL, title);
    for (char *line; rest && (line = thud_text_line(&rest)) != NULL; lines++) {
        size_t n = strlen(files);
        if (*line && access(line, F_OK) == 0 && named++ >= 0)
            snprintf(files + n, sizeof files - n, "%s%s", n ? ", " : "", line);
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
    thud_tui_redraw(tui, false);
    if (going) {
        if (*line)
            thud_tui_say(tui, THUD_ROLE_PLAIN, "%s: %s", tui->files.written, line);
        return;
    }
    int status = thud_command_work_finish(tui->files.command, &printed, &said);
    tui->files.command = NULL;
    tui->backend->also = -1;
    if (status == 0 && tui->dialog.mode == THUD_MODE_NORMAL)
        show(tui, &printed);
    else if (status == 0)
        thud_tui_say(tui, THUD_ROLE_GOOD, "%s is done", tui->files.written);
    else if (status == 128 + 2)
        thud_tui_say(tui, THUD_ROLE_WARN, "%s was stopped; nothing is half written", tui->files.written);
    else
        thud_tui_say(tui, THUD_ROLE_ERROR, "! %s: %s", tui->files.written,
                     *line ? line + (strncmp(line, "thud: ", 6) == 0 ? 6 : 0) : "it failed without a word");
    thud_text_clear(&printed);
    thud_text_clear(&said);
}

/* ---- the form ---- */

struct form {
    enum thud_command_id id;
    int n, at, top;
    const struct thud_option *option[OPTIONS_MAX]; /* (n); NULL: the program of THUD_WORD_PROGRAM */
    struct thud_line value[OPTIONS_MAX];
};

static bool is_switch(const struct thud_option *option)
{
    return option && !option->argument;
}

/* Those that print for another program, or nothing at all, have no use here. */
static bool has_use(const struct thud_option *option)
{
    static const char *const not [] = {"help", "quiet", "json", "csv", "words"};
    for (size_t i = 0; i < sizeof not / sizeof *not ; i++)
        if (strcmp(option->name, not [i]) == 0)
            return false;
    return true;
}

static void put_quoted(char *text, size_t size, const char *value)
{
    size_t n = strlen(text);
    const char *quote = !strchr(value, ' ') && *value ? "" : strchr(value, '"') ? "'" : "\"";
    if (n < size)
        snprintf(text + n, size - n, "%s%s%s", quote, value, quote);
}

static void run_form(struct thud_tui *tui)
{
    struct form *form = tui->dialog.own;
    char text[THUD_LINE_MAX * 2] = "";
    for (int i = 0; i < form->n; i++) {
        const struct thud_option *option = form->option[i];
        size_t n = strlen(text);
        if (!*form->value[i].text)
            continue;
        if (option)
            snprintf(text + n, sizeof text - n, "%s%s%s%s", n ? " " : "", option->name[1] ? "--" : "-", option->name,
                     is_switch(option)                  ? ""
                     : thud_option_stands_alone(option) ? "="
                                                        : " ");
        if (!is_switch(option))
            put_quoted(text, sizeof text, form->value[i].text);
    }
    thud_tui_normal(tui);
    thud_tui_verb(tui, (int)form->id, text);
}

/* The next of the words that an option takes, after the last none. */
static void next_choice(const struct thud_option *option, struct thud_line *line)
{
    const char *choice = thud_option_choice(option, 0);
    for (int i = 0; (choice = thud_option_choice(option, i)) != NULL && *line->text; i++)
        if (strcmp(choice, line->text) == 0) {
            choice = thud_option_choice(option, i + 1);
            break;
        }
    thud_line_set(line, choice ? choice : "");
}

static void form_key(struct thud_tui *tui, int key)
{
    struct form *form = tui->dialog.own;
    const struct thud_option *option = form->option[form->at];
    struct thud_line *line = &form->value[form->at];
    enum thud_action action = thud_key_action(THUD_AT_NEW, key);
    int step = action == THUD_DO_ACCEPT_NEXT || action == THUD_DO_ACCEPT_DOWN     ? 1
               : action == THUD_DO_ACCEPT_PREVIOUS || action == THUD_DO_ACCEPT_UP ? -1
                                                                                  : 0;
    if (action == THUD_DO_CANCEL)
        thud_tui_normal(tui);
    else if (action == THUD_DO_ACCEPT)
        run_form(tui);
    else if (step)
        form->at = (form->at + step + form->n) % form->n;
    else if (is_switch(option)) {
        if (key == ' ')
            thud_line_set(line, *line->text ? "" : "yes");
    } else if (key == ' ' && option && thud_option_choice(option, 0))
        next_choice(option, line);
    else
        thud_line_key(line, key);
}

static void form_draw(struct thud_tui *tui, const struct thud_pane *area)
{
    struct form *form = tui->dialog.own;
    char title[160], label[80], fitted[200];
    snprintf(title, sizeof title, "thud %s: %s", thud_command_at(form->id)->name, thud_command_at(form->id)->summary);
    thud_pane_blank(area);
    struct thud_pane in = thud_pane_frame(area, title, true);
    int rows = in.h > 1 ? in.h - 1 : 1, value = in.w < 2 * NAME ? in.w / 2 : NAME;
    form->top = form->at < form->top ? form->at : form->at >= form->top + rows ? form->at - rows + 1 : form->top;
    for (int i = form->top; i < form->n && i < form->top + rows; i++) {
        const struct thud_option *option = form->option[i];
        int y = i - form->top, room = in.w - value - VALUE - 2;
        snprintf(label, sizeof label, "%s%s %s", option ? option->name[1] ? "--" : "-" : "",
                 option ? option->name : "program", option && option->argument ? option->argument : "");
        thud_pane_put(&in, 1, y, thud_look(THUD_ROLE_PLAIN, 0), thud_utf8_fit(label, value - 2, fitted, sizeof fitted));
        if (i == form->at)
            thud_pane_glyph(&in, value - 1, y, thud_look(THUD_ROLE_KEY, THUD_BOLD), 0x25b8);
        if (i == form->at && !is_switch(option))
            thud_line_draw(&form->value[i], &in, value, y, VALUE, thud_look(THUD_ROLE_VALUE, THUD_UNDERLINE));
        else
            thud_pane_put(&in, value, y, thud_look(THUD_ROLE_VALUE, i == form->at ? THUD_REVERSE : 0),
                          *form->value[i].text ? thud_utf8_fit(form->value[i].text, VALUE, fitted, sizeof fitted)
                          : is_switch(option)  ? "no"
                                               : "-");
        if (option && room > 8)
            thud_pane_put(&in, in.w - room, y, thud_look(THUD_ROLE_MUTED, 0),
                          thud_utf8_fit(option->help, room, fitted, sizeof fitted));
    }
    const struct thud_option *here = form->option[form->at];
    thud_pane_put(&in, 1, in.h - 1, thud_look(THUD_ROLE_PLAIN, 0),
                  thud_utf8_fit(here ? here->help : "that the scene is written for", in.w - 2, fitted, sizeof fitted));
}

static struct thud_line *form_line(struct thud_tui *tui)
{
    struct form *form = tui->dialog.own;
    return &form->value[form->at];
}

/* The files of the marked designs, of none those with names, but for what is open itself. */
static void designs_of_report(struct thud_tui *tui, struct thud_line *line)
{
    char text[THUD_LINE_MAX] = "", path[600];
    bool any = false;
    for (int i = 0; i < tui->doc.designs.n; i++)
        any = any || tui->doc.designs.item[i].marked;
    for (int i = 0; i < tui->doc.designs.n; i++) {
        const struct thud_design *d = &tui->doc.designs.item[i];
        size_t n = strlen(text);
        thud_tui_design_path(tui, d->name, path, sizeof path);
        if (*d->name && (d->marked || !any) && strcmp(path, tui->doc.path) != 0 &&
            !thud_doc_runs_alike(d->scene, &tui->doc.scene) && access(path, F_OK) == 0)
            snprintf(text + n, sizeof text - n, "%s%.500s", n ? "," : "", path);
    }
    thud_line_set(line, text);
}

void thud_tui_verb_form(struct thud_tui *tui, int id)
{
    static const struct thud_over over = {
        .where = THUD_AT_NEW, .size = sizeof(struct form), .key = form_key, .draw = form_draw, .line = form_line};
    char folder[THUD_NAME_MAX + 32];
    struct form *form = thud_tui_over(tui, &over);
    if (!form)
        return;
    form->id = (enum thud_command_id)id;
    snprintf(folder, sizeof folder, "%s-%s", tui->doc.scene.name, thud_command_at(form->id)->name);
    if (thud_command_at(form->id)->word == THUD_WORD_PROGRAM)
        thud_line_set(&form->value[form->n++], "opensees");
    for (int rank = 0; rank < 3; rank++) /* where it writes comes first, what the scene says too comes last */
        for (int i = 0; i < thud_option_count() && form->n < OPTIONS_MAX; i++) {
            const struct thud_option *option = thud_option_at(i);
            const int own = strcmp(option->name, "o") == 0 ? 0 : thud_option_belongs(option, THUD_COMMAND_RUN) ? 2 : 1;
            if (own != rank || !thud_option_belongs(option, form->id) || !has_use(option))
                continue;
            if (rank == 0)
                thud_line_set(&form->value[form->n], folder);
            if (strcmp(option->name, "beside") == 0)
                designs_of_report(tui, &form->value[form->n]);
            if (strcmp(option->name, "figures") == 0)
                thud_line_set(&form->value[form->n], tui->files.for_report);
            form->option[form->n++] = option;
        }
    tui->files.for_report[0] = '\0'; /* the next one may be of another scene */
}
