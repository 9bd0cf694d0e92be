/* The strip of peaks below the model: three cases, their ratio, what the last change did, and the impacts over time. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "tui/document/field.h"
#include "tui/screens/peaks_strip.h"
#include "tui/widgets/dots.h"

/* Columns of the cases, the ratio and the impacts, behind the names of the two structures shown. */
struct strip {
    int name, column[THUD_LIVE_CASES + 2];
    int percent; /* column of the change against the state to compare with; 0: there is no room */
};

static struct strip strip_of(const struct thud_tui *tui, int w)
{
    int name = 1;
    for (int s = 0; s < 2 && tui->interface + s < tui->doc.scene.nstructures; s++) {
        int n = thud_utf8_columns(tui->doc.scene.structure[tui->interface + s].name);
        name = n > name ? n : name;
    }
    int most = w >= 72 ? w - 72 + 8 : 8; /* the column of the impacts gives way, those of numbers do not */
    struct strip strip = {.name = name < most ? name : most};
    for (int i = 0; i < THUD_LIVE_CASES + 2; i++)
        strip.column[i] = 20 + 13 * i + (strip.name > 6 ? strip.name - 6 : 0);
    strip.column[THUD_LIVE_CASES + 1] -= 4;
    if (w >= 98) { /* the impacts give way */
        strip.percent = strip.column[THUD_LIVE_CASES + 1];
        strip.column[THUD_LIVE_CASES + 1] += 11;
    }
    return strip;
}

/* Numbers and the heads over them end here, exclusive. */
static int edge_of(const struct strip *strip, int column)
{
    return strip->column[column] + (column == THUD_LIVE_CASES ? 6 : 11);
}

/* Appends a head that ends over column `edge` of the pane; the title begins a column before the pane does. */
static void add_head(char *text, size_t size, int edge, const char *head)
{
    thud_append(text, size, "%*s", edge - 1 - thud_utf8_columns(text), head);
}

void thud_peaks_strip_title(const struct thud_tui *tui, int w, char *text, size_t size)
{
    struct strip strip = strip_of(tui, w);
    snprintf(text, size, "%s", thud_tui_shows_old(tui) ? "Before the edit" : "Peaks");
    for (int i = 0; i <= THUD_LIVE_CASES; i++)
        add_head(text, size, edge_of(&strip, i),
                 i == THUD_LIVE_CASES ? "ratio" : thud_live_short_name(&tui->doc.scene, (enum thud_live_which)i));
    if (strip.percent && thud_tui_compared(tui))
        add_head(text, size, strip.percent + 8, "change");
}

void thud_ratio_draw(const struct thud_live *live, const struct thud_pane *pane, int x, int y,
                     const double value[THUD_LIVE_CASES])
{
    double ratio = value[THUD_LIVE_BUMPER] / value[THUD_LIVE_NONE];
    bool old = thud_live_is_old(live, THUD_LIVE_NONE), same = fabs(ratio - 1.0) < 5e-4;
    if (isfinite(ratio) && old == thud_live_is_old(live, THUD_LIVE_BUMPER))
        thud_pane_print(pane, x, y,
                        thud_look(old           ? THUD_ROLE_MUTED
                                  : same        ? THUD_ROLE_PLAIN
                                  : ratio < 1.0 ? THUD_ROLE_GOOD
                                                : THUD_ROLE_WARN,
                                  0),
                        "%5.3f", ratio);
}

void thud_case_draw(const struct thud_live *live, enum thud_live_which which, const struct thud_pane *pane, int right,
                    int y, const char *moved, const char *number)
{
    const enum thud_live_state state = live->which[which].state;
    const int role = state == THUD_LIVE_FAILED       ? THUD_ROLE_ERROR
                     : thud_live_is_old(live, which) ? THUD_ROLE_MUTED
                                                     : THUD_ROLE_RESULT;
    thud_pane_right(pane, right, y, thud_look(role, moved ? THUD_BOLD : 0),
                    moved                       ? moved
                    : state == THUD_LIVE_ABSENT ? "–"
                    : state == THUD_LIVE_FAILED ? "FAILED"
                                                : number);
}

/* One line of the strip: the three cases, the ratio, and what the last change did to the bumper's number. */
static void peak_row(struct thud_tui *tui, const struct strip *strip, const struct thud_pane *pane, int y,
                     const char *label, const char *unit, const double value[THUD_LIVE_CASES], double before)
{
    const int *column_x = strip->column;
    thud_pane_put(pane, 1, y, thud_look(THUD_ROLE_PLAIN, 0), label);
    thud_pane_put(pane, column_x[0] - 6, y, thud_look(THUD_ROLE_MUTED, 0), unit);
    const enum thud_live_which last = thud_live_written(&tui->run.live);
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        char number[24], old[24], text[64];
        thud_tui_number(value[i], number);
        bool moved =
            i == (int)last && !isnan(before) && !isnan(value[i]) && strcmp(thud_tui_number(before, old), number) != 0;
        if (moved)
            snprintf(text, sizeof text, "%s→%s", old, number);
        if (moved && strip->percent && before > 0.0)
            thud_pane_print(pane, strip->percent, y, thud_look(THUD_ROLE_MUTED, 0), "%+6.1f %%",
                            thud_shown(100.0 * (value[i] / before - 1.0), 1));
        thud_case_draw(&tui->run.live, (enum thud_live_which)i, pane, edge_of(strip, i), y, moved ? text : NULL,
                       number);
    }
    thud_ratio_draw(&tui->run.live, pane, edge_of(strip, THUD_LIVE_CASES) - 5, y, value);
}

/* The impacts of the last case as upright lines, over the time of the run. */
static void impact_strip(struct thud_tui *tui, const struct thud_pane *pane)
{
    enum thud_live_which which =
        tui->run.live.which[THUD_LIVE_BUMPER].state == THUD_LIVE_DONE ? THUD_LIVE_BUMPER : THUD_LIVE_NONE;
    const struct thud_live_case *c = &tui->run.live.which[which];
    if (c->state != THUD_LIVE_DONE || pane->w < 8 || pane->h < 3)
        return;
    int count;
    const struct thud_impact *impact = thud_run_impacts(c->run, &count);
    double most = 0.0, end = thud_run_end(c->run);
    for (int i = 0; i < count; i++)
        most = fmax(most, impact[i].force_n);
    bool impulses = count > 0 && !(most > 0.0); /* of a law without force */
    for (int i = 0; impulses && i < count; i++)
        most = fmax(most, impact[i].impulse_ns);
    const char *what = impulses ? "impulse" : "force";
    if (pane->w < 18)
        thud_pane_put(pane, 0, 0, thud_look(THUD_ROLE_MUTED, 0), what);
    else
        thud_pane_print(pane, 0, 0, thud_look(THUD_ROLE_MUTED, 0), "%s, %s", what, thud_tui_case_name(tui, which));
    struct thud_pane area = thud_pane_inside(pane, 0, 1, pane->w, pane->h - 1);
    struct thud_dots dots;
    if (count == 0)
        thud_pane_wrap(pane, 0, 1, pane->w, thud_look(THUD_ROLE_PLAIN, 0), "no contact at this gap");
    if (!(most > 0.0) || !(end > 0.0) || thud_dots_init(&dots, &area, NULL) != THUD_OK)
        return;
    struct thud_look look = thud_look(THUD_ROLE_SERIES + thud_live_color(which), 0);
    thud_dots_line(&dots, 0.0, dots.height - 1.0, dots.width - 1.0, dots.height - 1.0, 2, look);
    for (int i = 0; i < count; i++) {
        double x = impact[i].start_s / end * (dots.width - 1);
        double height = (impulses ? impact[i].impulse_ns : impact[i].force_n) / most;
        thud_dots_line(&dots, x, dots.height - 1.0, x, (1.0 - height) * (dots.height - 1), 1, look);
    }
    thud_dots_put(&dots);
    thud_dots_clear(&dots);
}

int thud_peaks_strip_draw(struct thud_tui *tui, const struct thud_pane *pane)
{
    struct strip layout = strip_of(tui, pane->w);
    const int *column_x = layout.column;
    double value[THUD_LIVE_CASES];
    int y = 0, impacts[THUD_LIVE_CASES];
    const struct thud_live *compared = thud_tui_compared(tui);
    const enum thud_live_which last = thud_live_written(&tui->run.live);
    int unused;
    for (int kind = 0; kind < 2; kind++)
        for (int s = 0; s < 2 && tui->interface + s < tui->doc.scene.nstructures; s++, y++) {
            const enum thud_peak_kind of = kind ? THUD_PEAK_DRIFT : THUD_PEAK_ACCELERATION;
            const double factor = kind ? 1e3 : 1.0;
            char label[200], name[160];
            const struct thud_structure *structure = &tui->doc.scene.structure[tui->interface + s];
            if (kind > 0 && !thud_kind_is_building(structure->kind)) {
                y--;
                continue;
            }
            if (structure->kind == THUD_WALL && !thud_wall_gives(structure)) {
                thud_field_note(pane, y, "%s moves with the ground", structure->name);
                continue;
            }
            thud_utf8_fit(structure->name, layout.name, name, sizeof name);
            snprintf(label, sizeof label, "%s %s", name, kind ? "drift" : "accel");
            for (int i = 0; i < THUD_LIVE_CASES; i++)
                value[i] = factor * thud_live_peak(&tui->run.live, (enum thud_live_which)i, tui->interface + s, of);
            double before = compared ? factor * thud_live_peak(compared, last, tui->interface + s, of) : NAN;
            peak_row(tui, &layout, pane, y, label, kind ? "mm" : "m/s²", value, before);
        }
    for (int i = 0; i < THUD_LIVE_CASES; i++)
        value[i] = 1e-6 * thud_live_force(&tui->run.live, (enum thud_live_which)i, tui->interface + 1, &impacts[i]);
    peak_row(tui, &layout, pane, y, "force", "MN", value,
             compared ? 1e-6 * thud_live_force(compared, last, tui->interface + 1, &unused) : NAN);
    for (int i = THUD_LIVE_NONE; i < THUD_LIVE_CASES; i++)
        if (tui->run.live.which[i].state == THUD_LIVE_DONE) {
            char text[32];
            snprintf(text, sizeof text, "%d impact%s", impacts[i], impacts[i] == 1 ? "" : "s");
            thud_pane_right(pane, edge_of(&layout, i), y + 1, thud_look(THUD_ROLE_MUTED, 0), text);
        }
    if (tui->interface + 1 < tui->doc.scene.nstructures) {
        char number[24];
        double clearance = thud_interface_clearance(&tui->doc.scene.interface[tui->interface]);
        thud_field_note(pane, y + 1, "clearance %s mm", thud_tui_number(1e3 * clearance, number));
    }
    int right = column_x[THUD_LIVE_CASES + 1];
    struct thud_pane strip = thud_pane_inside(pane, right, 0, pane->w - right - 1, pane->h);
    impact_strip(tui, &strip);
    return y + 2;
}
