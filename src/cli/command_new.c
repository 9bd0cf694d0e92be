/* thud new: a commented preset of two neighbours to start from, by questions at a terminal or by --set. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/run/new_preset.h"
#include "app/run/session.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "io/file/file.h"

/* The file's name without its folder and ending, which the title begins with. */
static void title_of(const char *path, char *name, size_t size)
{
    const char *file = thud_path_name(path), *dot = strrchr(file, '.');
    if (strcmp(path, "-") != 0)
        snprintf(name, size, "%.*s", dot && dot > file ? (int)(dot - file) : (int)strlen(file), file);
}

/* A line of the answers without blanks at its ends; false: they have ended. */
static bool read_answer(char **line, size_t *room, char **answer)
{
    if (getline(line, room, stdin) < 0)
        return false;
    *answer = *line + strspn(*line, " \t");
    size_t n = strlen(*answer);
    while (n > 0 && strchr(" \t\r\n", (*answer)[n - 1]))
        n--;
    (*answer)[n] = '\0';
    return true;
}

/* One answer in place of the usual value; the empty one keeps it, what cannot be is asked for again, and < goes back.
 * Errors: THUD_INPUT (the answers end), THUD_MEMORY. */
static enum thud_status ask(struct thud_new_preset *preset, enum thud_new_row row, int side, bool *back,
                            struct thud_error *err)
{
    char *line = NULL, *answer, what[1200];
    size_t room = 0;
    enum thud_status status = THUD_INPUT;
    for (*back = false; status != THUD_OK && !*back;) {
        struct thud_new_preset next = *preset;
        struct thud_error wrong = {0};
        struct thud_text question = {0};
        thud_new_question(preset, row, side, &question);
        fputs(question.data ? question.data : "", stderr);
        thud_text_clear(&question);
        if (!read_answer(&line, &room, &answer)) {
            free(line);
            return thud_error_set(err, THUD_INPUT, "the answers ended at \"%s\": nothing was written",
                                  thud_new_about(row)->label);
        }
        *back = strcmp(answer, "<") == 0;
        if (*answer && strlen(answer) < THUD_NEW_TEXT)
            thud_new_preset_answer(&next, row, side, answer);
        status = strlen(answer) < THUD_NEW_TEXT
                     ? thud_new_preset_check(&next, row, side, &wrong)
                     : thud_error_set(&wrong, THUD_INPUT, "an answer has up to %d characters", THUD_NEW_TEXT - 1);
        if (status == THUD_OK)
            *preset = next;
        else if (!*back)
            fprintf(stderr, "  %s\n", thud_error_text(&wrong, what, sizeof what));
    }
    free(line);
    return THUD_OK;
}

/* Questions are counted by row and side; those that do not apply are passed over, in both directions. */
static enum thud_status ask_all(struct thud_new_preset *preset, struct thud_error *err)
{
    const int first = 2 * THUD_NEW_KIND, end = 2 * THUD_NEW_ROWS;
    fprintf(stderr, "Two neighbours. Enter accepts the value in brackets, < goes back. A list has one value for each "
                    "floor: 320 t, 320 t, 250 t, 250 t.\n");
    for (int at = first, step = 1; at < end; at = at + step < first ? first : at + step) {
        const enum thud_new_row row = (enum thud_new_row)(at / 2);
        bool back = false;
        if (!thud_new_applies(preset, row, at % 2)) {
            step = at == first ? 1 : step;
            continue;
        }
        enum thud_status status = ask(preset, row, at % 2, &back, err);
        if (status != THUD_OK)
            return status;
        step = back ? -1 : 1;
    }
    return THUD_OK;
}

/* The key of a line, at which `indent` has its blanks. */
static int key_of(const char *line, int *indent)
{
    *indent = (int)strspn(line, " -");
    return (int)strcspn(line + *indent, ":");
}

/* The keys of what nobody said, from the marks in the text: "contact.stiffness" for one in a group. */
static void find_guesses(const struct thud_text *text, struct thud_text *out)
{
    enum { GROUP = 4 }; /* the blanks before a group's key */
    const char *group = "";
    int indent, in_group;
    for (const char *line = text->data; *line; line += strcspn(line, "\n") + 1) {
        char name[64];
        const int n = key_of(line, &indent);
        const char *mark = strstr(line, "# a guess");
        group = indent == GROUP ? line : group;
        if (!mark || mark > line + strcspn(line, "\n"))
            continue;
        const int length = key_of(group, &in_group);
        snprintf(name, sizeof name, "%.*s%s%.*s", indent > GROUP ? length : 0, group + in_group,
                 indent > GROUP ? "." : "", n, line + indent);
        if (!out->data || !strstr(out->data, name))
            thud_text_append(out, "%s%s", out->size ? ", " : "", name);
    }
}

/* The title goes with the storeys that --set gave, unless it gave a title. */
static void entitle(struct thud_new_preset *preset, struct thud_scene *scene)
{
    char before[THUD_TEXT_MAX];
    thud_new_preset_title(preset, before, sizeof before);
    if (strcmp(scene->title, before) != 0)
        return;
    for (int side = 0; side < 2; side++)
        snprintf(preset->text[THUD_NEW_STOREYS][side], sizeof preset->text[0][0], "%d", scene->structure[side].storeys);
    memset(scene->title, 0, sizeof scene->title);
    thud_new_preset_title(preset, scene->title, sizeof scene->title);
}

/* The study goes with the gap that --set gave, unless it gave a study. */
static void vary_about(double before_m, struct thud_scene *scene)
{
    struct thud_vary *vary = &scene->study.vary[0];
    const double factor = scene->interface[0].gap_m / before_m;
    if (!(factor > 0) || vary->from != 0.25 * before_m)
        return;
    vary->from *= factor;
    vary->to *= factor;
    vary->step *= factor;
}

/* The text with the values of --set, as `run` would take it. */
static enum thud_status assign(const struct thud_args *args, struct thud_new_preset *preset, struct thud_text *text,
                               struct thud_error *err)
{
    struct thud_session *session = calloc(1, sizeof *session);
    char *out = NULL;
    unsigned long size = 0;
    if (!session)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = thud_session_parse(session, text->data, text->size, args->operand[0], err);
    if (status != THUD_OK && err)
        err->file[0] = '\0', err->line = err->column = 0; /* of a text that nobody sees */
    const double gap_m = session->scene.interface[0].gap_m;
    if (status == THUD_OK)
        status = thud_scene_options_set(args, session, err);
    if (status == THUD_OK && thud_args_has(args, "set")) {
        entitle(preset, &session->scene);
        vary_about(gap_m, &session->scene);
    }
    if (status == THUD_OK)
        status = thud_scene_check(&session->scene, err);
    if (status == THUD_OK && session->scene.record.file[0]) /* "no" is an answer */
        status = thud_session_read_record(session, err);
    if (status == THUD_OK)
        status = thud_preset_text(session->preset, &session->scene, &out, &size, err);
    thud_text_clear(text);
    if (status == THUD_OK)
        thud_text_bytes(text, out, size);
    free(out);
    thud_session_close(session);
    free(session);
    return status;
}

/* Before anything is asked: whether the file can be written at the end. */
static enum thud_status check_place(const char *path, struct thud_error *err)
{
    char folder[1024];
    const int length = (int)(thud_path_name(path) - path);
    if (strcmp(path, "-") == 0)
        return THUD_OK;
    if (access(path, F_OK) == 0)
        return thud_error_in(err, THUD_OUTPUT, path, 0, "exists already: thud new does not overwrite files");
    snprintf(folder, sizeof folder, "%.*s", length > 0 ? length : 1, length > 0 ? path : ".");
    return access(folder, W_OK) == 0
               ? THUD_OK
               : thud_error_in(err, THUD_OUTPUT, path, 0, "cannot be written: %s", strerror(errno));
}

enum thud_status thud_command_new(const struct thud_args *args, struct thud_error *err)
{
    struct thud_new_preset preset;
    struct thud_text text = {0}, guesses = {0};
    const char *path = args->noperands > 0 ? args->operand[0] : "";
    bool to_output = strcmp(path, "-") == 0;
    if (args->noperands != 1)
        return thud_error_refuse(err, THUD_USAGE, NULL, "such as mine.yaml; - writes to standard output",
                                 "thud new needs the name of one file");
    thud_new_preset_init(&preset);
    title_of(path, preset.text[THUD_NEW_NAME][0], sizeof preset.text[THUD_NEW_NAME][0]);
    enum thud_status status = check_place(path, err);
    if (status == THUD_OK && !thud_args_has(args, "set") && isatty(STDIN_FILENO))
        status = ask_all(&preset, err);
    if (status == THUD_OK)
        status = thud_new_preset_text(&preset, &text, err);
    if (status == THUD_OK)
        status = assign(args, &preset, &text, err);
    if (status != THUD_OK) {
        thud_text_clear(&text);
        return status;
    }
    if (to_output)
        return thud_text_print(&text, err);
    find_guesses(&text, &guesses);
    status = thud_text_write(&text, path, err);
    if (status == THUD_OK && !thud_args_has(args, "quiet"))
        fprintf(stderr, "%s: guessed, and marked in the file: %s\n%s: `thud run %s` runs it, `thud %s` opens it\n",
                path, guesses.data ? guesses.data : "nothing", path, path, path);
    thud_text_clear(&guesses);
    return status;
}
