#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "tui/document/field.h"

enum { LABEL = 19 };

void thud_field_value(struct thud_tui *tui, int index, const struct thud_pane *pane, int x, int y, int w,
                      const char *key, bool unit)
{
    thud_form_add(&tui->form, THUD_FIELD_VALUE, index, x, y, w, 0, key);
    bool focus = thud_form_focused(&tui->form, index, key);
    if (focus && thud_tui_types_field(tui) && strcmp(tui->dialog.target, key) == 0) {
        thud_line_draw(&tui->dialog.line, pane, x, y, w, thud_look(THUD_ROLE_VALUE, THUD_UNDERLINE));
        return;
    }
    char text[160];
    if (thud_scene_get(&tui->doc.scene, key, text, sizeof text, NULL) != THUD_OK)
        snprintf(text, sizeof text, "?");
    const struct thud_param *param = unit ? NULL : thud_scene_param(&tui->doc.scene, key, &(int){0});
    size_t n = strlen(text), m = param && param->unit ? strlen(param->unit) : 0;
    if (m > 0 && n > m + 1 && strcmp(text + n - m, param->unit) == 0)
        text[n - m - 1] = '\0';
    char fitted[200];
    thud_utf8_fit(*text ? text : "-", w - !unit, fitted, sizeof fitted); /* the columns of a table stand apart */
    if (focus)
        thud_pane_glyph(pane, x - 1, y, thud_look(THUD_ROLE_KEY, THUD_BOLD), 0x25b8);
    thud_pane_put(pane, unit ? x : x + w - thud_utf8_columns(fitted), y,
                  thud_look(THUD_ROLE_VALUE, focus ? THUD_REVERSE : 0), fitted);
}

void thud_field_labelled(struct thud_tui *tui, int index, const struct thud_pane *pane, int x, int y, const char *label,
                         int value_x, int w, const char *key)
{
    char fitted[128];
    thud_pane_put(pane, x, y, thud_look(THUD_ROLE_PLAIN, 0),
                  thud_utf8_fit(label, value_x - x - 1, fitted, sizeof fitted));
    thud_field_value(tui, index, pane, value_x, y, w > 4 ? w : 4, key, true);
}

void thud_field_row(struct thud_tui *tui, int index, const struct thud_pane *pane, int y, const char *label,
                    const char *key)
{
    thud_field_labelled(tui, index, pane, 1, y, label, 1 + LABEL, pane->w - LABEL - 2, key);
}

int thud_field_rows(struct thud_tui *tui, int index, const struct thud_pane *pane, int y,
                    const struct thud_labelled *row, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        char path[THUD_PATH_MAX];
        snprintf(path, sizeof path, "interfaces.%d.%s", tui->interface + 1, row[i].key);
        if (thud_scene_param(&tui->doc.scene, path, &(int){0}))
            thud_field_row(tui, index, pane, y++, row[i].label, path);
    }
    return y;
}

int thud_field_group(struct thud_tui *tui, int index, const struct thud_pane *pane, int y, enum thud_group group,
                     const char *prefix)
{
    const struct thud_param *param;
    for (int i = 0; (param = thud_group_param(group, i)); i++) {
        char path[THUD_PATH_MAX];
        snprintf(path, sizeof path, "%s%s", prefix, param->name);
        if (thud_scene_param(&tui->doc.scene, path, &(int){0}))
            thud_field_row(tui, index, pane, y++, param->name, path);
    }
    return y;
}

void thud_field_line(struct thud_tui *tui, int index, const struct thud_pane *pane, int y, int number, const char *path,
                     const char *text)
{
    thud_form_add(&tui->form, THUD_FIELD_ROW, index, 1, y, pane->w - 1, number, path);
    bool focus = thud_form_focused(&tui->form, index, path);
    if (focus)
        thud_pane_glyph(pane, 0, y, thud_look(THUD_ROLE_KEY, THUD_BOLD), 0x25b8);
    struct thud_look look = thud_look(THUD_ROLE_PLAIN, focus ? THUD_REVERSE : 0);
    char fitted[256];
    thud_pane_put(pane, 1, y, look, thud_utf8_fit(text, pane->w - 1, fitted, sizeof fitted));
}

void thud_field_note(const struct thud_pane *pane, int y, const char *fmt, ...)
{
    char text[256];
    va_list args;
    va_start(args, fmt);
    vsnprintf(text, sizeof text, fmt, args);
    va_end(args);
    thud_pane_put(pane, 1, y, thud_look(THUD_ROLE_MUTED, 0), text);
}

/* Whether the help explains each of the choices by its word already. */
static bool says_choices(const struct thud_param *param)
{
    for (int i = 0; param->kind == THUD_PARAM_CHOICE && param->choices[i]; i++) {
        char word[40];
        snprintf(word, sizeof word, "%.36s:", param->choices[i]);
        if (!param->help || !strstr(param->help, word))
            return false;
    }
    return param->kind == THUD_PARAM_CHOICE;
}

void thud_param_words(const struct thud_param *param, char *words, size_t size)
{
    char number[64] = "", range[160];
    snprintf(words, size, "%s", param->help && *param->help ? param->help : param->title);
    if (!*words || !strchr(".!?", words[strlen(words) - 1]))
        thud_append(words, size, ".");
    if (param->kind == THUD_PARAM_QUANTITY && param->dimension >= THUD_LENGTH)
        thud_append(words, size, " Units %s.", thud_dimension_units(param->dimension));
    thud_param_allowed(param, range, sizeof range);
    if (*range && !says_choices(param))
        thud_append(words, size, " Allowed: %s.", range);
    if (param->kind == THUD_PARAM_QUANTITY && !isnan(param->fallback) && param->dimension != THUD_POWER_STIFFNESS)
        thud_quantity_format(param->fallback, param->unit ? param->unit : "", number, sizeof number);
    else if (param->kind == THUD_PARAM_CHOICE && !isnan(param->fallback) && param->choices)
        snprintf(number, sizeof number, "%s", param->choices[(int)param->fallback]);
    if (*number)
        thud_append(words, size, " Default %s.", number);
    bool numeric = param->kind == THUD_PARAM_QUANTITY || param->kind == THUD_PARAM_INTEGER;
    if (numeric && param->dimension != THUD_POWER_STIFFNESS &&
        (thud_param_unusual(param, INFINITY, range, sizeof range) ||
         thud_param_unusual(param, -INFINITY, range, sizeof range)))
        thud_append(words, size, " Usual: %s.", range);
}
