/* Contact: one interface, its laws as forms fed by their tables, and what they do. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tui/chart.h"
#include "tui/field.h"
#include "tui/scene_edit.h"

enum { FORM, CURVE, CHECK };

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    (void)tui;
    int half = area.w / 2 < 62 ? area.w / 2 : 62, check = area.h >= 18 ? 7 : area.h / 3;
    pane[FORM] = (struct thud_rect){area.x, area.y, half, area.h};
    pane[CURVE] = (struct thud_rect){area.x + half, area.y, area.w - half, area.h - check};
    pane[CHECK] = (struct thud_rect){area.x + half, area.y + area.h - check, area.w - half, check};
    return 3;
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    const struct thud_scene *scene = &tui->doc.scene;
    int i = tui->pair;
    if (index == FORM && i + 1 < scene->nstructures)
        snprintf(text, size, "Between %s and %s (%d of %d)", scene->structure[i].name, scene->structure[i + 1].name,
                 i + 1, scene->nstructures - 1);
    else
        snprintf(text, size, "%s",
                 index == FORM    ? "No interface"
                 : index == CURVE ? "Force against indentation"
                                  : "What it gives");
}

static int law_rows(struct thud_tui *tui, const struct thud_pane *pane, int y, const char *part,
                    const struct thud_law *law)
{
    char key[THUD_PATH_MAX];
    snprintf(key, sizeof key, "interfaces.%d.%s.law", tui->pair + 1, part);
    thud_field_row(tui, FORM, pane, y++, "law", key);
    for (int i = 0; law && i < law->nparams; i++) {
        snprintf(key, sizeof key, "interfaces.%d.%s.%s", tui->pair + 1, part, law->params[i].name);
        thud_field_row(tui, FORM, pane, y++, law->params[i].name, key);
    }
    return y;
}

static void heading(const struct thud_pane *pane, int y, const char *text)
{
    int at = 1 + thud_pane_put(pane, 1, y, thud_look(THUD_ROLE_TITLE, THUD_BOLD), text);
    for (int x = at + 1; x < pane->w - 1; x++)
        thud_pane_glyph(pane, x, y, thud_look(THUD_ROLE_BORDER, 0), 0x2500);
}

static int draw_form(struct thud_tui *tui, const struct thud_pane *pane)
{
    const struct thud_interface *at = &tui->doc.scene.interface[tui->pair];
    char key[THUD_PATH_MAX], number[24];
    int y = 0;
    snprintf(key, sizeof key, "interfaces.%d.gap", tui->pair + 1);
    thud_field_row(tui, FORM, pane, y++, "gap", key);
    snprintf(key, sizeof key, "interfaces.%d.levels", tui->pair + 1);
    thud_field_row(tui, FORM, pane, y++, "levels", key);
    thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_MUTED, 0), "clearance          %s cm",
                    thud_tui_number(100.0 * thud_interface_clearance(at), number));
    heading(pane, y++, "Bare contact");
    y = law_rows(tui, pane, y, "contact", at->contact.law);
    heading(pane, y++, at->has_bumper ? "Bumper [x] on (B)" : "Bumper [ ] off (B)");
    if (!at->has_bumper)
        return y;
    snprintf(key, sizeof key, "interfaces.%d.bumper.thickness", tui->pair + 1);
    thud_field_row(tui, FORM, pane, y++, "thickness", key);
    snprintf(key, sizeof key, "interfaces.%d.bumper.cavity", tui->pair + 1);
    thud_field_row(tui, FORM, pane, y++, "cavity", key);
    return law_rows(tui, pane, y, "bumper", at->bumper.law);
}

/* The loops, made anew where the scene or the pair changed. */
static void refresh(struct thud_tui *tui)
{
    if (tui->law_revision == tui->doc.revision && tui->law_pair == tui->pair)
        return;
    thud_figure_free(tui->law_figure);
    tui->law_error = (struct thud_error){0};
    tui->law_figure = thud_tui_law_figure(&tui->doc.scene, tui->pin.scene.nstructures > 1 ? &tui->pin.scene : NULL,
                                          tui->pair, tui->meeting, &tui->law_error);
    tui->law_revision = tui->doc.revision;
    tui->law_pair = tui->pair;
}

static int draw_check(struct thud_tui *tui, const struct thud_pane *pane)
{
    const struct thud_scene *scene = &tui->doc.scene;
    double m1 = thud_tui_pair_mass(scene, tui->pair), m2 = thud_tui_pair_mass(scene, tui->pair + 1);
    double mass = isinf(m1)   ? m2
                  : isinf(m2) ? m1
                              : m1 * m2 / (m1 + m2),
           force = thud_tui_force_at_knee(scene, tui->pair);
    char a[24], b[24], c[24], d[24];
    int y = 0;
    int x = 1 + thud_pane_print(pane, 1, y, thud_look(THUD_ROLE_MUTED, 0), "eff. mass %s t",
                                thud_tui_number(1e-3 * mass, a));
    if (isfinite(force))
        thud_pane_print(pane, x, y, thud_look(THUD_ROLE_MUTED, 0), "  F(delta_u) %s MN",
                        thud_tui_number(1e-6 * force, a));
    y++;
    if (!tui->law_figure)
        return y;
    thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "m/s      F MN    d mm    e");
    for (int i = 0; i < THUD_MEETINGS; i++) {
        const struct thud_meeting *m = &tui->meeting[i];
        thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_VALUE, 0), "%-8s %-7s %-7s %s",
                        thud_tui_number(m->speed_mps, a), thud_tui_number(1e-6 * m->force_n, b),
                        thud_tui_number(1e3 * m->indentation_m, c),
                        isnan(m->restitution) ? "-" : thud_tui_number(m->restitution, d));
    }
    return y;
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    if (tui->pair + 1 >= tui->doc.scene.nstructures)
        return 0;
    if (index == FORM)
        return draw_form(tui, pane);
    refresh(tui);
    if (index == CHECK)
        return draw_check(tui, pane);
    struct thud_chart chart = thud_tui_reading(tui);
    char text[600];
    if (tui->law_figure)
        thud_chart_draw(pane, &tui->law_figure->panel[0], &chart);
    else
        thud_pane_wrap(pane, 1, 0, pane->w - 2, thud_look(THUD_ROLE_ERROR, 0),
                       thud_error_text(&tui->law_error, text, sizeof text));
    return pane->h;
}

static bool act(struct thud_tui *tui, enum thud_action action)
{
    if (action == THUD_DO_KEEP_FORCE)
        thud_tui_keep_force(tui);
    else if (action == THUD_DO_TOGGLE_BUMPER)
        thud_tui_toggle_bumper(tui, tui->pair);
    else
        return thud_tui_change_pair(tui, action);
    return true;
}

static const char *cannot(struct thud_tui *tui, enum thud_action action)
{
    if (action == THUD_DO_KEEP_FORCE)
        return isnan(tui->kept_before_n) ? "There was no change of the exponent just now" : NULL;
    if (action == THUD_DO_TOGGLE_BUMPER)
        return tui->pair + 1 < tui->doc.scene.nstructures ? NULL : "There is no interface";
    return thud_tui_cannot_change_pair(tui, action);
}

static const struct thud_figure *figure(struct thud_tui *tui)
{
    if (tui->pair + 1 < tui->doc.scene.nstructures)
        refresh(tui);
    return tui->law_figure;
}

static const struct thud_panel *read_panel(struct thud_tui *tui)
{
    return tui->form.pane[THUD_SCREEN_CONTACT] == CURVE && figure(tui) ? &tui->law_figure->panel[0] : NULL;
}

static void release(struct thud_tui *tui)
{
    thud_figure_free(tui->law_figure);
    tui->law_figure = NULL;
}

THUD_VIEW(contact, "Contact", CONTACT, .act = act, .cannot = cannot, .figure = figure, .read = read_panel,
          .free = release);
