#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "tui/widgets/field.h"

enum { LABEL = 19 };

void thud_field_value(struct thud_tui *tui, int index, const struct thud_pane *pane, int x, int y, int w,
                      const char *key, bool unit)
{
    thud_form_add(&tui->form, THUD_FIELD_VALUE, index, x, y, w, 0, key);
    bool focus = thud_form_focused(&tui->form, index, key);
    if (focus && tui->mode == THUD_MODE_TYPING && tui->typing == THUD_TYPE_FIELD && strcmp(tui->target, key) == 0) {
        thud_line_draw(&tui->line, pane, x, y, w, thud_look(THUD_ROLE_VALUE, THUD_UNDERLINE));
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
    thud_utf8_fit(*text ? text : "-", w, fitted, sizeof fitted);
    if (focus)
        thud_pane_glyph(pane, x - 1, y, thud_look(THUD_ROLE_KEY, THUD_BOLD), 0x25b8);
    thud_pane_put(pane, x, y, thud_look(THUD_ROLE_VALUE, focus ? THUD_REVERSE : 0), fitted);
}

void thud_field_row(struct thud_tui *tui, int index, const struct thud_pane *pane, int y, const char *label,
                    const char *key)
{
    thud_pane_put(pane, 1, y, thud_look(THUD_ROLE_PLAIN, 0), label);
    thud_field_value(tui, index, pane, 1 + LABEL, y, pane->w - LABEL - 2 > 6 ? pane->w - LABEL - 2 : 6, key, true);
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
