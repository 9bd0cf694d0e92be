/* Model: two neighbouring structures, and the peaks below them. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/model.h"
#include "tui/dots.h"
#include "tui/field.h"
#include "tui/scene_edit.h"

enum { PEAKS = 2, PEAK_ROWS = 7 };

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    (void)tui;
    int strip = area.h >= 30 ? 2 * PEAK_ROWS : area.h >= 18 ? PEAK_ROWS + 1 : area.h / 3, half = area.w / 2;
    pane[0] = (struct thud_rect){area.x, area.y, half, area.h - strip};
    pane[1] = (struct thud_rect){area.x + half, area.y, area.w - half, area.h - strip};
    pane[PEAKS] = (struct thud_rect){area.x, area.y + area.h - strip, area.w, strip};
    return 3;
}

/* " T1 0.398 s", where it is known. */
static const char *first_period(const struct thud_tui *tui, int s, char text[32])
{
    const struct thud_model *model = tui->live.which[THUD_LIVE_FREE].model;
    char number[24];
    *text = '\0';
    if (!model || s >= model->nstructures || model->structure[s].n == 0 || tui->ran_revision != tui->doc.revision)
        return text;
    double omega = model->omega[model->structure[s].first];
    if (omega > 0.0)
        snprintf(text, 32, " T1 %s s", thud_tui_number(2.0 * acos(-1.0) / omega, number));
    return text;
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    const struct thud_scene *scene = &tui->doc.scene;
    if (index == PEAKS) { /* the heads of the columns stand in the frame, as there are few rows */
        snprintf(text, size, "Peaks              no pounding  no bumper    bumper       ratio");
        return;
    }
    int s = tui->pair + index;
    char period[32];
    if (s < scene->nstructures)
        snprintf(text, size, "%s: %.12s (%d of %d)%s", index ? "Right" : "Left", scene->structure[s].name, s + 1,
                 scene->nstructures, first_period(tui, s, period));
    else
        snprintf(text, size, "no structure");
}

/* Periods and effective masses, from the model the run is made with. */
static int modes(struct thud_tui *tui, const struct thud_pane *pane, int y, int s)
{
    const struct thud_live_case *c = &tui->live.which[THUD_LIVE_FREE];
    const struct thud_model *model = c->model;
    if (!model || s >= model->nstructures || model->structure[s].n == 0 || tui->ran_revision != tui->doc.revision)
        return y;
    const struct thud_model_structure *structure = &model->structure[s];
    double total = 0.0;
    char periods[160] = " T", masses[160] = " M*", number[24];
    for (int i = 0; i < structure->n; i++)
        total += model->mass_kg[structure->first + i];
    for (int j = 0; j < structure->n && j < (pane->w - 6) / 8; j++) {
        double omega = model->omega[structure->first + j], gamma = model->gamma[structure->first + j];
        if (!(omega > 0.0))
            continue;
        size_t n = strlen(periods), m = strlen(masses);
        snprintf(periods + n, sizeof periods - n, "%*s", n == 2 ? 8 : 8,
                 thud_tui_number(2.0 * acos(-1.0) / omega, number));
        snprintf(masses + m, sizeof masses - m, "%*.1f", m == 3 ? 7 : 8, 100.0 * gamma * gamma / total);
    }
    if (strlen(periods) < 4)
        return y;
    strncat(periods, " s", sizeof periods - strlen(periods) - 1);
    strncat(masses, " %", sizeof masses - strlen(masses) - 1);
    thud_pane_put(pane, 0, y, thud_look(THUD_ROLE_MUTED, 0), periods);
    thud_pane_put(pane, 0, y + 1, thud_look(THUD_ROLE_MUTED, 0), masses);
    return y + 2;
}

static int floors(struct thud_tui *tui, int index, const struct thud_pane *pane, int y, int s)
{
    const struct thud_structure *structure = &tui->doc.scene.structure[s];
    static const struct {
        const char *key, *head;
        int x, w;
    } column[] = {{"mass", "mass t", 9, 8}, {"stiffness", "k MN/m", 18, 9}, {"height", "height m", 28, 8}};
    thud_pane_put(pane, 1, y, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "floor");
    for (int c = 0; c < 3; c++)
        thud_pane_put(pane, column[c].x, y, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), column[c].head);
    y++;
    for (int i = structure->storeys; i >= 1; i--, y++) {
        thud_pane_print(pane, 1, y, thud_look(THUD_ROLE_PLAIN, 0), "%4d", i);
        for (int c = 0; c < 3; c++) {
            char key[THUD_PATH_MAX];
            snprintf(key, sizeof key, "structures.%d.%s.%d", s + 1, column[c].key, i);
            thud_field_value(tui, index, pane, column[c].x, y, column[c].w, key, false);
        }
    }
    return y;
}

/* The values that are not by floor, two in a row where they are short. */
static int head_rows(struct thud_tui *tui, int index, const struct thud_pane *pane, int s)
{
    enum { SHEAR = 1 << THUD_SHEAR, RIGID = 1 << THUD_RIGID, ISOLATED = 1 << THUD_ISOLATED, WALL = 1 << THUD_WALL };
    static const struct {
        const char *key, *label;
        int kinds, y, x, value;
    } field[] = {
        {"kind", "kind", SHEAR | RIGID | ISOLATED | WALL, 0, 1, 9},
        {"name", "name", SHEAR | RIGID | ISOLATED | WALL, 0, 20, 28},
        {"storeys", "storeys", SHEAR | ISOLATED, 1, 1, 9},
        {"damping", "damping", SHEAR | ISOLATED, 1, 20, 28},
        {"base-mass", "base mass", ISOLATED, 2, 1, 18},
        {"isolation-stiffness", "isolator k", ISOLATED, 3, 1, 18},
        {"isolation-damping", "isolator damping", ISOLATED, 4, 1, 18},
        {"mass", "mass", RIGID, 1, 1, 18},
        {"height", "height", RIGID | WALL, 2, 1, 18},
        {"velocity", "velocity at 0", RIGID, 3, 1, 18},
    };
    int rows = 0;
    for (size_t i = 0; i < sizeof field / sizeof *field; i++) {
        if (!(field[i].kinds & 1 << tui->doc.scene.structure[s].kind))
            continue;
        char key[THUD_PATH_MAX];
        int room = field[i].x == 1 && field[i].value == 9 ? 9 : pane->w - field[i].value - 1;
        snprintf(key, sizeof key, "structures.%d.%s", s + 1, field[i].key);
        thud_pane_put(pane, field[i].x, field[i].y, thud_look(THUD_ROLE_PLAIN, 0), field[i].label);
        thud_field_value(tui, index, pane, field[i].value, field[i].y, room > 4 ? room : 4, key, true);
        rows = field[i].y + 1 > rows ? field[i].y + 1 : rows;
    }
    return rows;
}

static int draw_structure(struct thud_tui *tui, int index, const struct thud_pane *pane, int s)
{
    enum thud_structure_kind kind = tui->doc.scene.structure[s].kind;
    int y = head_rows(tui, index, pane, s);
    if (kind == THUD_SHEAR || kind == THUD_ISOLATED)
        y = modes(tui, pane, floors(tui, index, pane, y, s), s);
    return y;
}

static const int column_x[] = {20, 33, 46, 59};

/* One line of the strip: the three cases, the ratio, and what the last change did to the bumper's number. */
static void peak_row(struct thud_tui *tui, const struct thud_pane *pane, int y, const char *label, const char *unit,
                     const double value[THUD_LIVE_CASES], double before)
{
    thud_pane_put(pane, 1, y, thud_look(THUD_ROLE_PLAIN, 0), label);
    thud_pane_put(pane, 14, y, thud_look(THUD_ROLE_MUTED, 0), unit);
    enum thud_live_which last =
        tui->live.which[THUD_LIVE_BUMPER].state == THUD_LIVE_ABSENT ? THUD_LIVE_NONE : THUD_LIVE_BUMPER;
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        char number[24], old[24], text[64];
        bool absent = tui->live.which[i].state == THUD_LIVE_ABSENT,
             failed = tui->live.which[i].state == THUD_LIVE_FAILED;
        thud_tui_number(value[i], number);
        snprintf(text, sizeof text, "%s", absent ? "–" : failed ? "FAILED" : number);
        bool moved =
            i == (int)last && !isnan(before) && !isnan(value[i]) && strcmp(thud_tui_number(before, old), number) != 0;
        if (moved)
            snprintf(text, sizeof text, "%s→%s", old, number);
        thud_pane_put(pane, column_x[i], y,
                      thud_look(failed ? THUD_ROLE_ERROR : THUD_ROLE_VALUE, moved ? THUD_BOLD : 0), text);
    }
    double ratio = value[THUD_LIVE_BUMPER] / value[THUD_LIVE_NONE];
    if (isfinite(ratio))
        thud_pane_print(pane, column_x[3], y, thud_look(ratio < 1.0 ? THUD_ROLE_GOOD : THUD_ROLE_WARN, 0), "%.3f",
                        ratio);
}

/* The impacts of the last case as upright lines, over the time of the run. */
static void impact_strip(struct thud_tui *tui, const struct thud_pane *pane)
{
    enum thud_live_which which =
        tui->live.which[THUD_LIVE_BUMPER].state == THUD_LIVE_DONE ? THUD_LIVE_BUMPER : THUD_LIVE_NONE;
    const struct thud_live_case *c = &tui->live.which[which];
    if (c->state != THUD_LIVE_DONE || pane->w < 8 || pane->h < 3)
        return;
    int count;
    const struct thud_impact *impact = thud_run_impacts(c->run, &count);
    double most = 0.0, end = thud_run_end(c->run);
    for (int i = 0; i < count; i++)
        most = fmax(most, impact[i].force_n);
    thud_pane_print(pane, 0, 0, thud_look(THUD_ROLE_MUTED, 0), "force, %s", thud_live_name(which));
    struct thud_pane area = thud_pane_inside(pane, 0, 1, pane->w, pane->h - 1);
    struct thud_dots dots;
    if (!(most > 0.0) || !(end > 0.0) || thud_dots_init(&dots, &area, NULL) != THUD_OK)
        return;
    struct thud_look look = thud_look(THUD_ROLE_SERIES + 1, 0);
    thud_dots_line(&dots, 0.0, dots.height - 1.0, dots.width - 1.0, dots.height - 1.0, 2, look);
    for (int i = 0; i < count; i++) {
        double x = impact[i].start_s / end * (dots.width - 1);
        thud_dots_line(&dots, x, dots.height - 1.0, x, (1.0 - impact[i].force_n / most) * (dots.height - 1), 1, look);
    }
    thud_dots_put(&dots);
    thud_dots_clear(&dots);
}

static int draw_peaks(struct thud_tui *tui, struct thud_pane *pane)
{
    double value[THUD_LIVE_CASES];
    int y = 0, impacts[THUD_LIVE_CASES];
    bool compare = tui->before.known;
    for (int kind = 0; kind < 2; kind++)
        for (int s = 0; s < 2 && tui->pair + s < tui->doc.scene.nstructures; s++, y++) {
            char label[32];
            if (tui->doc.scene.structure[tui->pair + s].kind == THUD_WALL) {
                if (kind == 0)
                    thud_field_note(pane, y, "%.20s moves with the ground",
                                    tui->doc.scene.structure[tui->pair + s].name);
                continue;
            }
            snprintf(label, sizeof label, "%.6s %s", tui->doc.scene.structure[tui->pair + s].name,
                     kind ? "drift" : "accel");
            for (int i = 0; i < THUD_LIVE_CASES; i++)
                value[i] = (kind ? 1e3 : 1.0) * thud_live_peak(&tui->live, (enum thud_live_which)i, tui->pair + s,
                                                               kind ? THUD_PEAK_DRIFT : THUD_PEAK_ACCELERATION);
            double before = kind ? 1e3 * tui->before.drift[s] : tui->before.acceleration[s];
            peak_row(tui, pane, y, label, kind ? "mm" : "m/s²", value, compare ? before : NAN);
        }
    for (int i = 0; i < THUD_LIVE_CASES; i++)
        value[i] = 1e-6 * thud_live_force(&tui->live, (enum thud_live_which)i, tui->pair + 1, &impacts[i]);
    peak_row(tui, pane, y, "force", "MN", value, compare ? 1e-6 * tui->before.force : NAN);
    for (int i = THUD_LIVE_NONE; i < THUD_LIVE_CASES; i++)
        if (tui->live.which[i].state == THUD_LIVE_DONE)
            thud_pane_print(pane, column_x[i], y + 1, thud_look(THUD_ROLE_MUTED, 0), "%d impact%s", impacts[i],
                            impacts[i] == 1 ? "" : "s");
    if (tui->pair + 1 < tui->doc.scene.nstructures) {
        char number[24];
        double clearance = thud_interface_clearance(&tui->doc.scene.interface[tui->pair]);
        thud_field_note(pane, y + 1, "clearance %s mm", thud_tui_number(1e3 * clearance, number));
    }
    struct thud_pane strip = thud_pane_inside(pane, 68, 0, pane->w - 69, pane->h);
    impact_strip(tui, &strip);
    return y + 2;
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    if (index == PEAKS)
        return draw_peaks(tui, pane);
    if (tui->pair + index >= tui->doc.scene.nstructures) {
        thud_field_note(pane, 0, "A adds one");
        return 1;
    }
    return draw_structure(tui, index, pane, tui->pair + index);
}

/* The structure the cursor is in. */
static int current(const struct thud_tui *tui)
{
    int pane = tui->form.pane[THUD_SCREEN_MODEL], s = tui->pair + (pane == 1);
    return s < tui->doc.scene.nstructures ? s : tui->doc.scene.nstructures - 1;
}

/* The floor the cursor is on, from 1; 0: none. */
static int current_floor(const struct thud_tui *tui)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    int s, floor = 0;
    char word[32];
    if (!field || sscanf(field->path, "structures.%d.%31[a-z].%d", &s, word, &floor) != 3)
        return 0;
    return floor;
}

static bool act(struct thud_tui *tui, enum thud_action action)
{
    switch (action) {
    case THUD_DO_ALL_FLOORS:
        thud_tui_all_floors(tui);
        return true;
    case THUD_DO_ADD_STOREY:
        thud_tui_add_storey(tui, current(tui), current_floor(tui));
        return true;
    case THUD_DO_DELETE_STOREY:
        thud_tui_delete_storey(tui, current(tui), current_floor(tui));
        return true;
    case THUD_DO_ADD_STRUCTURE:
        thud_tui_add_structure(tui, current(tui));
        return true;
    case THUD_DO_REMOVE_STRUCTURE:
        thud_tui_remove_structure(tui, current(tui));
        return true;
    case THUD_DO_SWAP:
        thud_tui_swap(tui, tui->pair);
        return true;
    default:
        return thud_tui_change_pair(tui, action);
    }
}

static const char *cannot(struct thud_tui *tui, enum thud_action action)
{
    const struct thud_scene *scene = &tui->doc.scene;
    int s = current(tui);
    bool storeys = s >= 0 && (scene->structure[s].kind == THUD_SHEAR || scene->structure[s].kind == THUD_ISOLATED);
    switch (action) {
    case THUD_DO_ALL_FLOORS:
        return current_floor(tui) ? NULL : "The cursor is on no floor's value";
    case THUD_DO_ADD_STOREY:
        return !storeys                                          ? "Only a building has storeys"
               : scene->structure[s].storeys >= THUD_STOREYS_MAX ? "There are 200 storeys already"
                                                                 : NULL;
    case THUD_DO_DELETE_STOREY:
        return !current_floor(tui)               ? "The cursor is on no floor"
               : scene->structure[s].storeys < 2 ? "The last storey stays"
                                                 : NULL;
    case THUD_DO_ADD_STRUCTURE:
        return scene->nstructures >= THUD_STRUCTURES_MAX ? "There are 20 structures already" : NULL;
    case THUD_DO_REMOVE_STRUCTURE:
        return scene->nstructures > 2 ? NULL : "Two structures have to stay";
    case THUD_DO_SWAP:
        return tui->pair + 1 < scene->nstructures ? NULL : "There is only one structure";
    default:
        return thud_tui_cannot_change_pair(tui, action);
    }
}

const struct thud_view thud_view_model = {
    .title = "Model",
    .where = THUD_AT_MODEL,
    .layout = layout,
    .draw = draw,
    .pane_title = pane_title,
    .act = act,
    .cannot = cannot,
};
