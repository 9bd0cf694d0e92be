/* Pasted text: into the line being typed, or into the cells from the cursor on, as one change. */
#include <stdio.h>
#include <string.h>

#include "tui/document/session_log.h"
#include "tui/loop/loop.h"

/* Cuts the next row off a paste; NULL at its end. Terminals send a line's end as CR. */
static char *next_row(char **text)
{
    char *row = *text, *end = row + strcspn(row, "\r\n");
    if (!*row)
        return NULL;
    *text = end + (*end == '\r' && end[1] == '\n' ? 2 : *end != '\0');
    *end = '\0';
    return row;
}

/* True where a row is several bare numbers with blanks between them. */
static bool bare_numbers(const char *row)
{
    int n = 0;
    for (const char *at = row + strspn(row, " "); *at; n++) {
        const char *end;
        double number;
        if (thud_number_parse(at, &end, &number) != 0 || (*end && *end != ' '))
            return false;
        at = end + strspn(end, " ");
    }
    return n > 1;
}

/* Cuts the next cell off a row: at a tab or semicolon, or at blanks between bare numbers. NULL at its end. */
static char *next_cell(char **row, bool blanks)
{
    char *cell = *row;
    if (!cell)
        return NULL;
    cell += strspn(cell, " ");
    size_t n = strcspn(cell, blanks ? " \t;" : "\t;");
    char *rest = cell + n;
    bool more = *rest != '\0';
    if (more)
        *rest++ = '\0';
    if (blanks)
        rest += strspn(rest, " ");
    *row = more && (!blanks || *rest) ? rest : NULL;
    return cell;
}

/* The nearest field to the right in the same row of its pane, or below in the same column; NULL: there is none. */
static const struct thud_field *beside(const struct thud_form *form, const struct thud_field *from, bool below)
{
    const struct thud_field *best = NULL;
    for (int i = 0; i < form->n; i++) {
        const struct thud_field *f = &form->field[i];
        if (f->pane != from->pane || f->kind != THUD_FIELD_VALUE ||
            (below ? f->x != from->x || f->y <= from->y : f->y != from->y || f->x <= from->x))
            continue;
        if (!best || (below ? f->y < best->y : f->x < best->x))
            best = f;
    }
    return best;
}

/* Sets one cell of the scene that is being made. */
static enum thud_status put(struct thud_tui *tui, struct thud_scene *next, const struct thud_field *field,
                            const char *cell, struct thud_error *err)
{
    struct thud_text text = {0};
    if (!thud_tui_typable(tui, field))
        return thud_error_set(err, THUD_INPUT, "%s is chosen from a list: nothing can be pasted there", field->path);
    thud_tui_with_unit(tui, field->path, cell, &text);
    enum thud_status status = text.failed ? thud_error_set(err, THUD_MEMORY, "no memory to paste")
                                          : thud_scene_set(next, field->path, text.data, err);
    thud_text_clear(&text);
    return status;
}

/* Fills cells from `first` on, and cuts the text into them; nothing changes where one of them is refused. `line` is the
 * text as a log has it: rows end with `;;`, which a row of cells has nowhere, and tabs are semicolons. */
static enum thud_status fill(struct thud_tui *tui, char *text, const struct thud_field *first, struct thud_scene *next,
                             int *cells, struct thud_text *line, struct thud_error *err)
{
    char *row;
    const struct thud_field *start = first;
    enum thud_status status = THUD_OK;
    *cells = 0;
    while (status == THUD_OK && (row = next_row(&text)) != NULL) {
        char *rest = row, *cell;
        bool blanks = bare_numbers(row);
        if (!row[strspn(row, " \t")])
            continue;
        thud_text_append(line, "%s%s", line->size > 0 ? ";;" : "", row);
        if (!start)
            return thud_error_set(err, THUD_INPUT, "there are only %d rows from here on, and more in what was pasted",
                                  *cells);
        for (const struct thud_field *field = start; status == THUD_OK && (cell = next_cell(&rest, blanks)) != NULL;
             field = beside(&tui->form, field, false)) {
            status = put(tui, next, field, cell, err);
            *cells += status == THUD_OK;
            if (rest && status == THUD_OK && !beside(&tui->form, field, false))
                return thud_error_set(err, THUD_INPUT, "a row of what was pasted has more values than there are cells");
        }
        start = beside(&tui->form, start, true);
    }
    return status;
}

void thud_tui_paste_line(struct thud_tui *tui, char *line)
{
    for (char *end = line; (end = strstr(end, ";;")) != NULL;)
        memcpy(end, "\r\n", 2);
    thud_tui_paste(tui, line);
}

void thud_tui_paste(struct thud_tui *tui, const char *text)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    bool typing = tui->dialog.mode == THUD_MODE_TYPING, cells = text && strpbrk(text, "\r\n\t;") != NULL;
    if (!text || !*text || tui->dialog.mode == THUD_MODE_ASKING)
        return;
    if (tui->dialog.mode == THUD_MODE_OVER) {
        if (tui->dialog.over->line)
            thud_line_type(tui->dialog.over->line(tui), text);
        return;
    }
    if (tui->dialog.mode == THUD_MODE_CHOOSING) {
        thud_line_type(&tui->dialog.chooser.filter, text);
        thud_chooser_key(&tui->dialog.chooser, THUD_KEY_NONE);
        return;
    }
    if (typing && (tui->dialog.prompt || !cells)) {
        thud_line_type(&tui->dialog.line, text);
        return;
    }
    if (!field || field->kind != THUD_FIELD_VALUE) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "! Pasted text goes into fields, and the cursor is on none");
        return;
    }
    struct thud_scene next = tui->doc.scene;
    struct thud_error err = {0};
    struct thud_text cut = {0}, line = {0};
    int n = 0;
    char what[80];
    thud_text_append(&cut, "%s", text);
    enum thud_status status = fill(tui, cut.failed ? (char[]){""} : cut.data, field, &next, &n, &line, &err);
    if (cut.failed || line.failed)
        status = thud_error_set(&err, THUD_MEMORY, "no memory to paste");
    thud_text_clear(&cut);
    snprintf(what, sizeof what, "%d pasted value%s", n, n == 1 ? "" : "s");
    if (status == THUD_OK && n > 0)
        status = thud_doc_change(&tui->doc, &next, what, &err);
    thud_tui_normal(tui);
    if (status != THUD_OK) {
        char words[600];
        thud_tui_say(tui, THUD_ROLE_ERROR, "! nothing was changed: %s", thud_error_text(&err, words, sizeof words));
    } else if (n > 0) {
        for (char *tab = line.data; (tab = strchr(tab, '\t')) != NULL;)
            *tab = ';';
        thud_tui_log(tui, "paste %s %s", field->path, line.data);
        thud_tui_say(tui, THUD_ROLE_PLAIN, "%s taken (u undoes)", what);
    }
    thud_text_clear(&line);
}
