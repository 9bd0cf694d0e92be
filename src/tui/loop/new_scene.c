#include "tui/loop/new_scene.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "app/run/new_preset.h"
#include "tui/document/form_over.h"
#include "tui/document/session_log.h"

static bool exists(const char *name)
{
    char path[THUD_NEW_TEXT + 8];
    snprintf(path, sizeof path, "%.240s.yaml", name);
    return access(path, F_OK) == 0;
}

/* The first name that no file here has. */
static void free_name(struct thud_line *line)
{
    char name[THUD_NEW_TEXT] = "buildings";
    for (int i = 2; i < 1000 && exists(name); i++)
        snprintf(name, sizeof name, "buildings-%d", i);
    thud_line_set(line, name);
}

static void values_of(const struct thud_form_over *form, struct thud_new_preset *preset)
{
    for (int row = 0; row < THUD_NEW_ROWS; row++)
        for (int side = 0; side < 2; side++)
            snprintf(preset->text[row][side], sizeof preset->text[row][side], "%s", form->row[row].value[side].text);
}

/* Takes an answer as `thud new` does, and what follows from it. */
static void answer(struct thud_form_over *form)
{
    struct thud_new_preset preset;
    values_of(form, &preset);
    snprintf(preset.text[form->at][form->side], sizeof *preset.text[0], "%s", form->was);
    thud_new_preset_answer(&preset, (enum thud_new_row)form->at, form->side,
                           form->row[form->at].value[form->side].text);
    for (int i = 0; i < 2 * THUD_NEW_ROWS; i++)
        thud_line_set(&form->row[i / 2].value[i % 2], preset.text[i / 2][i % 2]);
}

static bool applies(const struct thud_form_over *form, int row, int side)
{
    struct thud_new_preset preset;
    values_of(form, &preset);
    return thud_new_applies(&preset, (enum thud_new_row)row, side);
}

static const char *kind(const struct thud_over_row *row, int i)
{
    (void)row;
    return thud_new_kind(i);
}

static void log_values(struct thud_tui *tui, const struct thud_new_preset *preset)
{
    struct thud_text line = {0};
    for (int row = 0; row < THUD_NEW_ROWS; row++) {
        const struct thud_new_about *about = thud_new_about((enum thud_new_row)row);
        if (row == THUD_NEW_RECORD && !*preset->text[THUD_NEW_RECORD][0])
            continue;
        thud_text_append(&line, "%s%s: %s%s%s", row ? "; " : "", about->word, preset->text[row][0],
                         about->single ? "" : ", ", about->single ? "" : preset->text[row][1]);
    }
    thud_tui_log(tui, "new %s", line.failed ? "" : line.data);
    thud_text_clear(&line);
}

/* The values as they were typed make the scene, or stay in the form with the reason. */
static void make(struct thud_tui *tui, struct thud_form_over *form)
{
    struct thud_new_preset preset;
    struct thud_text text = {0};
    struct thud_error err = {0};
    char path[THUD_NEW_TEXT + 16], found[512];
    values_of(form, &preset);
    const char *name = preset.text[THUD_NEW_NAME][0], *record = preset.text[THUD_NEW_RECORD][0];
    snprintf(path, sizeof path, "%.240s.yaml", name);
    enum thud_status status = THUD_OK;
    if (!*name || exists(name))
        status = thud_error_set(&err, THUD_INPUT, "%s: a name that no file here has", path);
    if (status == THUD_OK && *record)
        status = thud_paths_record(tui->doc.paths, path, record, found, sizeof found, &err);
    if (status == THUD_OK)
        status = thud_new_preset_text(&preset, &text, &err);
    thud_tui_forget_run(tui);
    if (status == THUD_OK)
        status = thud_doc_new(&tui->doc, text.data, text.size, path, &err);
    thud_text_clear(&text);
    if (status != THUD_OK) {
        err.line = err.column = 0; /* of a file that nobody sees */
        err.file[0] = '\0';
        thud_tui_say_error(tui, &err);
        tui->run.seen = 0;
        thud_form_over_focus(form, form->at, form->side);
        return;
    }
    thud_tui_normal(tui);
    log_values(tui, &preset);
    thud_tui_opened(tui);
    thud_tui_go(tui, THUD_SCREEN_MODEL);
    thud_tui_say(tui, THUD_ROLE_GOOD, "%s: each value can be changed here now; w saves", path);
}

/* The rows of the table, with the usual values. */
static struct thud_form_over *begin(struct thud_tui *tui)
{
    struct thud_new_preset preset;
    struct thud_form_over *form = thud_form_over_begin(tui);
    if (!form)
        return NULL;
    thud_new_preset_init(&preset);
    snprintf(form->title, sizeof form->title, "New scene: two neighbours");
    for (int i = 0; i < THUD_NEW_ROWS; i++) {
        const struct thud_new_about *about = thud_new_about((enum thud_new_row)i);
        struct thud_over_row *row = thud_form_over_add(form, about->label, about->help, preset.text[i][0]);
        thud_line_set(&row->value[1], preset.text[i][1]);
        row->two = !about->single;
        row->motion = i == THUD_NEW_RECORD;
        row->only = i == THUD_NEW_KIND;
        row->choice = i == THUD_NEW_KIND ? kind : NULL;
    }
    thud_line_set(&form->row[THUD_NEW_RECORD].value[0], ""); /* is chosen from the list */
    free_name(&form->row[THUD_NEW_NAME].value[0]);
    form->applies = applies;
    form->done = make;
    thud_form_over_focus(form, THUD_NEW_STOREYS, 0);
    form->left = answer;
    return form;
}

void thud_new_scene_begin(struct thud_tui *tui)
{
    struct thud_form_over *form = begin(tui);
    if (form)
        thud_browse_list(&form->files, THUD_BROWSE_RECORDS, tui->doc.paths, "", "");
}

void thud_new_scene_command(struct thud_tui *tui, char *text)
{
    char *rest = text;
    struct thud_new_preset preset;
    struct thud_form_over *form = begin(tui); /* names are meant as they are: no files to complete them from */
    if (!form)
        return;
    for (char *part; (part = strtok_r(rest, ";", &rest)) != NULL;) {
        char *value = strchr(part, ':');
        int row = 0;
        if (value)
            *value++ = '\0';
        part += strspn(part, " ");
        const int length = (int)strcspn(part, " ");
        while (row < THUD_NEW_ROWS &&
               (strncmp(part, thud_new_about((enum thud_new_row)row)->word, (size_t)length) != 0 ||
                thud_new_about((enum thud_new_row)row)->word[length]))
            row++;
        if (!value || row == THUD_NEW_ROWS) {
            thud_tui_normal(tui);
            thud_tui_say(tui, THUD_ROLE_ERROR,
                         "! new: \"%.40s\" is none of name, kind, storeys, mass, stiffness, height, "
                         "damping, gap, record, soil, damper",
                         part);
            return;
        }
        thud_new_preset_put(&preset, (enum thud_new_row)row, value);
        for (int side = 0; side < 2; side++)
            thud_line_set(&form->row[row].value[side], preset.text[row][side]);
    }
    make(tui, form);
    if (tui->dialog.mode == THUD_MODE_OVER)
        thud_tui_normal(tui);
}
