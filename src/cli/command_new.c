/* thud new: a commented preset of two neighbours to start from, by questions at a terminal or by --set. */
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

/* One answer in place of the usual value; the empty one keeps it. Errors: THUD_INPUT (the answers end). */
static enum thud_status ask(struct thud_new_preset *preset, enum thud_new_row row, int side, struct thud_error *err)
{
    const struct thud_new_about *about = thud_new_about(row);
    char *value = preset->text[row][side], line[THUD_NEW_TEXT + 2];
    fprintf(stderr, "%s%s%s%s [%s]: ",
            about->single ? ""
            : side        ? "right "
                          : "left ",
            about->label,
            row == THUD_NEW_KIND ? " (shear, isolated, lead-rubber, pendulum, rigid, wall, backfill, estimated)" : "",
            *about->unit ? ", with its unit" : "", value);
    if (!fgets(line, sizeof line, stdin))
        return thud_error_set(err, THUD_INPUT, "the answers ended at \"%s\": nothing was written", about->label);
    line[strcspn(line, "\n")] = '\0';
    if (strcmp(line, "none") == 0 && row == THUD_NEW_RECORD)
        *value = '\0';
    else if (line[strspn(line, " ")])
        snprintf(value, sizeof preset->text[row][side], "%.*s", THUD_NEW_TEXT - 1, line);
    return THUD_OK;
}

static enum thud_status ask_all(struct thud_new_preset *preset, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    fprintf(stderr, "Two neighbours; Enter takes what stands in brackets.\n");
    for (int row = THUD_NEW_KIND; row < THUD_NEW_ROWS; row++)
        for (int side = 0; side < 2 && status == THUD_OK; side++) {
            if (!thud_new_applies(preset, (enum thud_new_row)row, side))
                continue;
            status = ask(preset, (enum thud_new_row)row, side, err);
            if (side == 0 && row != THUD_NEW_STOREYS && !thud_new_about((enum thud_new_row)row)->single)
                memcpy(preset->text[row][1], preset->text[row][0], sizeof preset->text[row][1]);
        }
    return status;
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
    if (status == THUD_OK)
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

enum thud_status thud_command_new(const struct thud_args *args, struct thud_error *err)
{
    struct thud_new_preset preset;
    struct thud_text text = {0};
    const char *path = args->noperands > 0 ? args->operand[0] : "";
    bool to_output = strcmp(path, "-") == 0;
    if (args->noperands != 1)
        return thud_error_refuse(err, THUD_USAGE, NULL, "such as mine.yaml; - writes to standard output",
                                 "thud new needs the name of one file");
    if (!to_output && access(path, F_OK) == 0)
        return thud_error_in(err, THUD_OUTPUT, path, 0, "is there already: thud new writes over no file");
    thud_new_preset_init(&preset);
    title_of(path, preset.text[THUD_NEW_NAME][0], sizeof preset.text[THUD_NEW_NAME][0]);
    enum thud_status status = THUD_OK;
    if (!thud_args_has(args, "set") && isatty(STDIN_FILENO))
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
        return thud_cli_print_data(&text, err);
    status = thud_text_write(&text, path, err);
    if (status == THUD_OK && !thud_args_has(args, "quiet"))
        fprintf(stderr, "%s: `thud run %s` runs it, `thud %s` opens it\n", path, path, path);
    return status;
}
