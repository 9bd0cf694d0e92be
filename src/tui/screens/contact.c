/* Contact: one interface, its laws as forms fed by their tables, and what they do. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plot/figures/figures_law.h"
#include "tui/document/field.h"
#include "tui/document/scene_edit.h"
#include "tui/screens/moment.h"
#include "tui/widgets/chart.h"

enum { FORM, CURVE, CHECK, MOVE, WIDE = THUD_MOMENT_WIDE };

struct contact_state {
    struct thud_figure *figure; /* force-indentation loops of the interface shown */
    struct thud_meeting meeting[THUD_MEETINGS], other[THUD_MEETINGS]; /* the second: of what it is compared with */
    struct thud_error error;
    unsigned long revision, base; /* what they belong to; 0: nothing */
    int pair;
    bool moves;    /* the buildings stand in place of the curve, where there is no room for both */
    double held_s; /* when the gap was dragged last, */
    int held;      /* and how many times without a pause */
};

static struct contact_state *state(const struct thud_tui *tui)
{
    return tui->own[THUD_SCREEN_CONTACT];
}

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    if (area.w >= WIDE) { /* the buildings beside the rest */
        const int form = area.w * 3 / 10 > 40 ? area.w * 3 / 10 : 40, curve = (area.w - form) / 2;
        const int low = area.h >= 18 ? 7 : area.h / 3;
        pane[FORM] = (struct thud_rect){area.x, area.y, form, area.h};
        pane[CURVE] = (struct thud_rect){area.x + form, area.y, curve, area.h - low};
        pane[CHECK] = (struct thud_rect){area.x + form, area.y + area.h - low, curve, low};
        if (area.h >= THUD_MOMENT_TALL) { /* what the law gives below its form */
            pane[CURVE].h = area.h;
            pane[FORM].h -= low;
            pane[CHECK].x = area.x;
            pane[CHECK].w = form;
        }
        pane[MOVE] = (struct thud_rect){area.x + form + curve, area.y, area.w - form - curve, area.h};
        return 4;
    }
    (void)tui;
    int half = area.w / 2 < 62 ? area.w / 2 : 62, check = area.h >= 18 ? 7 : area.h / 3;
    pane[FORM] = (struct thud_rect){area.x, area.y, half, area.h};
    pane[CURVE] = (struct thud_rect){area.x + half, area.y, area.w - half, area.h - check};
    pane[CHECK] = (struct thud_rect){area.x + half, area.y + area.h - check, area.w - half, check};
    return 3;
}

static bool shows_buildings(const struct thud_tui *tui, int index)
{
    return index == MOVE || (index == CURVE && state(tui)->moves && tui->canvas.width < WIDE);
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    const struct thud_scene *scene = &tui->doc.scene;
    int i = tui->interface;
    if (shows_buildings(tui, index)) {
        thud_moment_title(tui, text, size);
        return;
    }
    if (index == FORM && i + 1 < scene->nstructures)
        snprintf(text, size, "Between %s and %s (%d of %d)", scene->structure[i].name, scene->structure[i + 1].name,
                 i + 1, scene->nstructures - 1);
    else
        snprintf(text, size, "%s",
                 index == FORM                            ? "No interface"
                 : index == CURVE                         ? "Force against indentation"
                 : !isnan(state(tui)->other[0].speed_mps) ? "What both give: F MN, e"
                                                          : "What it gives");
}

static int law_rows(struct thud_tui *tui, const struct thud_pane *pane, int y, const char *part,
                    const struct thud_law *law)
{
    char key[THUD_PATH_MAX];
    snprintf(key, sizeof key, "interfaces.%d.%s.law", tui->interface + 1, part);
    thud_field_row(tui, FORM, pane, y++, "law", key);
    for (int i = 0; law && i < law->nparams; i++) {
        snprintf(key, sizeof key, "interfaces.%d.%s.%s", tui->interface + 1, part, law->params[i].name);
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

/* The links that cross this interface. */
static int link_rows(struct thud_tui *tui, const struct thud_pane *pane, int y)
{
    const struct thud_scene *scene = &tui->doc.scene;
    const struct thud_param *param;
    for (int i = 0; i < scene->nlinks; i++) {
        char key[THUD_PATH_MAX], title[48];
        if (thud_link_interface(scene, i) != tui->interface)
            continue;
        snprintf(title, sizeof title, "Link %d (d takes it away)", i + 1);
        heading(pane, y++, title);
        for (int k = 0; (param = thud_group_param(THUD_GROUP_LINK, k)); k++) {
            if (!thud_link_has((enum thud_link_law)scene->link[i].law, k))
                continue;
            snprintf(key, sizeof key, "links.%d.%s", i + 1, param->name);
            thud_field_row(tui, FORM, pane, y++, param->name, key);
        }
    }
    return y;
}

static int draw_form(struct thud_tui *tui, const struct thud_pane *pane)
{
    static const struct thud_labelled gap[] = {{"gap", "gap"}, {"gap by level", "gap-by-level"}, {"levels", "levels"}},
                                      bumper[] = {{"thickness", "bumper.thickness"},
                                                  {"by level", "bumper.thickness-by-level"},
                                                  {"cavity", "bumper.cavity"}},
                                      rest[] = {{"levels that meet", "contact-levels"},
                                                {"source", "source"},
                                                {"contact source", "contact.source"},
                                                {"bumper source", "bumper.source"}};
    const struct thud_interface *at = &tui->doc.scene.interface[tui->interface];
    char clearance[256], key[THUD_PATH_MAX];
    int y = thud_field_rows(tui, FORM, pane, 0, gap, 3);
    thud_interface_clearance_text(&tui->doc.scene, tui->interface, clearance, sizeof clearance);
    thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_MUTED, 0), "clearance          %s", clearance);
    heading(pane, y++, "Bare contact");
    y = law_rows(tui, pane, y, "contact", at->contact.law);
    heading(pane, y, "Bumper (B)");
    if (at->bumper.law || at->has_bumper) {
        snprintf(key, sizeof key, "interfaces.%d.bumper.fitted", tui->interface + 1);
        thud_field_value(tui, FORM, pane, 20, y, 4, key, true);
    }
    y++;
    if (at->has_bumper)
        y = law_rows(tui, pane, thud_field_rows(tui, FORM, pane, y, bumper, 3), "bumper", at->bumper.law);
    return link_rows(tui, pane, thud_field_rows(tui, FORM, pane, y, rest, 4));
}

/* The loops, recomputed where the scene or the pair changed. */
static void refresh(struct thud_tui *tui)
{
    struct contact_state *c = state(tui);
    if (c->revision == tui->doc.revision && c->pair == tui->interface && c->base == tui->base.number)
        return;
    struct thud_law_behind behind = {.scene = tui->base.scene.nstructures > 1 ? &tui->base.scene : NULL,
                                     .name = tui->base.name,
                                     .meeting = c->other};
    thud_figure_free(c->figure);
    c->error = (struct thud_error){0};
    for (int i = 0; i < THUD_MEETINGS; i++)
        c->other[i] = (struct thud_meeting){NAN, NAN, NAN, NAN};
    c->figure = thud_figure_of_law(&tui->doc.scene, &behind, tui->interface, c->meeting, &c->error);
    c->revision = tui->doc.revision;
    c->pair = tui->interface;
    c->base = tui->base.number;
}

static const char *restitution(const struct thud_meeting *m, char text[24])
{
    return isnan(m->restitution) ? strcpy(text, "-") : thud_tui_number(m->restitution, text);
}

/* F and e of this law and of the one behind it, beside each other. */
static int draw_both(struct thud_tui *tui, const struct thud_pane *pane, int y)
{
    const struct thud_interface *at = &tui->doc.scene.interface[tui->interface];
    const struct thud_law *law = at->has_bumper ? at->bumper.law : at->contact.law;
    char name[2][64], a[24], b[24], c[24], d[24], e[24];
    thud_utf8_fit(law ? law->name : "", 13, name[0], sizeof name[0]);
    thud_utf8_fit(tui->base.name, 13, name[1], sizeof name[1]);
    thud_pane_put(pane, 1, y, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "m/s");
    thud_pane_put(pane, 8, y, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), name[0]);
    thud_pane_put(pane, 23, y++, thud_look(THUD_ROLE_MUTED, THUD_BOLD), name[1]);
    for (int i = 0; i < THUD_MEETINGS; i++, y++) {
        const struct thud_meeting *m = &state(tui)->meeting[i], *other = &state(tui)->other[i];
        thud_pane_print(pane, 1, y, thud_look(THUD_ROLE_RESULT, 0), "%-6s %-6s %-7s", thud_tui_number(m->speed_mps, a),
                        thud_tui_number(1e-6 * m->force_n, b), restitution(m, d));
        thud_pane_print(pane, 23, y, thud_look(THUD_ROLE_MUTED, 0), "%-6s %s",
                        thud_tui_number(1e-6 * other->force_n, c), restitution(other, e));
    }
    return y;
}

static int draw_check(struct thud_tui *tui, const struct thud_pane *pane)
{
    const struct thud_scene *scene = &tui->doc.scene;
    double m1 = thud_law_mass(scene, tui->interface), m2 = thud_law_mass(scene, tui->interface + 1);
    double mass = 1 / (1 / m1 + 1 / m2), force = thud_scene_force_at_knee(scene, tui->interface);
    char a[24], b[24], c[24], d[24];
    int y = 0;
    int x = 1 + thud_pane_print(pane, 1, y, thud_look(THUD_ROLE_MUTED, 0), "eff. mass %s t",
                                thud_tui_number(1e-3 * mass, a));
    if (isfinite(force))
        thud_pane_print(pane, x, y, thud_look(THUD_ROLE_MUTED, 0), "  F(delta_u) %s MN",
                        thud_tui_number(1e-6 * force, a));
    y++;
    if (!state(tui)->figure)
        return y;
    if (!isnan(state(tui)->other[0].speed_mps))
        return draw_both(tui, pane, y);
    thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "m/s      F MN    d mm    e");
    for (int i = 0; i < THUD_MEETINGS; i++) {
        const struct thud_meeting *m = &state(tui)->meeting[i];
        thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_RESULT, 0), "%-8s %-7s %-7s %s",
                        thud_tui_number(m->speed_mps, a), thud_tui_number(1e-6 * m->force_n, b),
                        thud_tui_number(1e3 * m->indentation_m, c),
                        isnan(m->restitution) ? "-" : thud_tui_number(m->restitution, d));
    }
    return y;
}

/* Both buildings at the largest impact, and the gap under them, which ( ) and the mouse move. */
static int draw_buildings(struct thud_tui *tui, const struct thud_pane *pane)
{
    const struct thud_interface *at = &tui->doc.scene.interface[tui->interface];
    struct thud_pane upper = thud_pane_inside(pane, 0, 0, pane->w, pane->h - 1);
    char text[80];
    thud_moment_draw(tui, &upper);
    snprintf(text, sizeof text, "( gap %.5g cm  clearance %.5g cm )", 100.0 * at->gap_m,
             100.0 * thud_interface_clearance(at));
    const int x = (pane->w - (int)strlen(text)) / 2;
    thud_pane_put(pane, x > 0 ? x : 0, pane->h - 1, thud_look(THUD_ROLE_VALUE, THUD_BOLD), text);
    return pane->h;
}

/* The gap so many mm wider, in the unit it is shown in. */
static void drag_gap(struct thud_tui *tui, double mm)
{
    struct contact_state *c = state(tui);
    const double gap_m = tui->doc.scene.interface[tui->interface].gap_m, next = fmax(0.0, gap_m + 1e-3 * mm);
    char key[THUD_PATH_MAX], unit[48], text[96];
    snprintf(key, sizeof key, "interfaces.%d.gap", tui->interface + 1);
    thud_tui_shown_unit(tui, key, unit, sizeof unit);
    thud_quantity_format(round(1e3 * next) / 1e3, unit, text, sizeof text); /* 0.102, not 102 times 1e-3 */
    c->moves = true;
    thud_tui_set_step(tui, key, text);
}

/* A millimetre; held, faster. */
static void drag(struct thud_tui *tui, int direction)
{
    static const double pause_s = 0.2;
    enum { SLOW = 8, FAST = 5 };
    struct contact_state *c = state(tui);
    const double now_s = tui->backend->now(tui->backend);
    c->held = now_s - c->held_s < pause_s ? c->held + 1 : 0;
    c->held_s = now_s;
    drag_gap(tui, direction * (c->held < SLOW ? 1.0 : FAST));
}

/* The mouse in the pane of the buildings: a millimetre a column. */
static bool drag_by_mouse(struct thud_tui *tui, int index, int columns)
{
    if (!shows_buildings(tui, index) || tui->interface + 1 >= tui->doc.scene.nstructures)
        return false;
    if (columns != 0)
        drag_gap(tui, columns);
    return true;
}

/* Motions are kept for where the buildings stand. */
static enum thud_live_history history(const struct thud_tui *tui)
{
    return state(tui)->moves ? THUD_LIVE_CONTACTS : thud_moment_history(tui);
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    if (tui->interface + 1 >= tui->doc.scene.nstructures)
        return 0;
    if (shows_buildings(tui, index))
        return draw_buildings(tui, pane);
    if (index == FORM)
        return draw_form(tui, pane);
    refresh(tui);
    if (index == CHECK)
        return draw_check(tui, pane);
    struct thud_chart chart = thud_tui_reading(tui, tui->reading[tui->screen]);
    char text[600];
    if (state(tui)->figure)
        thud_chart_draw(pane, &state(tui)->figure->panel[0], &chart);
    else
        thud_pane_wrap(pane, 1, 0, pane->w - 2, thud_look(THUD_ROLE_ERROR, 0),
                       thud_error_text(&state(tui)->error, text, sizeof text));
    return pane->h;
}

/* The link whose field the cursor is on, from 0; -1. */
static int link_here(struct thud_tui *tui)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    int link = 0;
    return field && sscanf(field->path, "links.%d.", &link) == 1 ? link - 1 : -1;
}

static enum thud_reaction act(struct thud_tui *tui, enum thud_action action)
{
    if (action == THUD_DO_KEEP_FORCE)
        thud_tui_keep_force(tui);
    else if (action == THUD_DO_NARROWER || action == THUD_DO_WIDER)
        drag(tui, action == THUD_DO_WIDER ? 1 : -1);
    else if (action == THUD_DO_QUANTITY)
        state(tui)->moves = !state(tui)->moves;
    else if (action == THUD_DO_TOGGLE_BUMPER)
        thud_tui_edit_scene(tui, "bumper %d", tui->interface + 1);
    else if (action == THUD_DO_ADD_LINK)
        thud_tui_edit_scene(tui, "link add %d", tui->interface + 1);
    else if (action == THUD_DO_DELETE_LINK)
        thud_tui_edit_scene(tui, "link remove %d", link_here(tui) + 1);
    else
        return thud_tui_change_interface(tui, action) ? THUD_DONE : THUD_NOT_MINE;
    return THUD_DONE;
}

static const char *cannot(struct thud_tui *tui, enum thud_action action)
{
    if (action == THUD_DO_KEEP_FORCE)
        return isnan(tui->kept.before_n) ? "There was no change of the exponent just now" : NULL;
    if (action == THUD_DO_DELETE_LINK && link_here(tui) < 0)
        return "The cursor is on no link";
    if (action == THUD_DO_QUANTITY && tui->canvas.width >= WIDE)
        return "Curve and buildings stand beside each other";
    if (action == THUD_DO_TOGGLE_BUMPER || action == THUD_DO_NARROWER || action == THUD_DO_WIDER ||
        action == THUD_DO_QUANTITY || action == THUD_DO_ADD_LINK || action == THUD_DO_DELETE_LINK)
        return tui->interface + 1 < tui->doc.scene.nstructures ? NULL : "There is no interface";
    return thud_tui_cannot_change_interface(tui, action);
}

static const struct thud_figure *figure(struct thud_tui *tui)
{
    if (tui->interface + 1 < tui->doc.scene.nstructures)
        refresh(tui);
    return state(tui)->figure;
}

static const struct thud_panel *read_panel(struct thud_tui *tui)
{
    return tui->form.pane[THUD_SCREEN_CONTACT] == CURVE && !shows_buildings(tui, CURVE) && figure(tui)
               ? &state(tui)->figure->panel[0]
               : NULL;
}

static void release(struct thud_tui *tui)
{
    thud_figure_free(state(tui)->figure);
}

THUD_VIEW(contact, "Contact", CONTACT, .keys = "interfaces. links.", .size = sizeof(struct contact_state),
          .free = release, .act = act, .cannot = cannot, .figure = figure, .read = read_panel, .history = history,
          .drag = drag_by_mouse);
