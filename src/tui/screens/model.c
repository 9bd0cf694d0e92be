/* Model: two neighbouring structures, and the peaks below them. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "base/scan.h"
#include "core/model/model.h"
#include "ground/intensity.h"
#include "study/scene/building.h"
#include "study/scene/level.h"
#include "study/sweep/remark.h"
#include "tui/document/field.h"
#include "tui/document/scene_edit.h"
#include "tui/screens/moment.h"
#include "tui/screens/movement.h"
#include "tui/screens/peaks_strip.h"
#include "tui/widgets/dots.h"

enum { PEAKS = 2, PEAK_ROWS = 7, PEAK_LEAST = 4, SOIL_ROWS = 5 };

/* Rows of values of a building that its kind has. */
static int rows_of_kind(const struct thud_structure *structure)
{
    return structure->kind == THUD_SHEAR       ? 2
           : structure->kind == THUD_MODES     ? 5
           : structure->kind == THUD_ESTIMATED ? 5
           : structure->kind == THUD_MATRIX    ? 6
           : thud_isolator_slides(structure)   ? 8
                                               : 6;
}

/* Rows of the pair's panes, with their frames, in which the floors of the taller one and a row of periods are seen. */
static int rows_wanted(const struct thud_tui *tui)
{
    int most = 0;
    for (int s = tui->interface; s < tui->interface + 2 && s < tui->doc.scene.nstructures; s++) {
        const struct thud_structure *structure = &tui->doc.scene.structure[s];
        const int rows = rows_of_kind(structure) + (thud_structure_on_soil(structure) ? SOIL_ROWS : 0) + 1 +
                         structure->storeys + 1 + 2;
        if (thud_kind_is_building(structure->kind) && rows > most)
            most = rows;
    }
    return most;
}

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    const int rows = rows_wanted(tui), half = area.w / 2; /* the peaks give way to floors and periods */
    int strip = area.h >= 17 ? PEAK_ROWS + 1 : area.h / 3;
    if (strip > area.h - rows)
        strip = area.h - rows > PEAK_LEAST ? area.h - rows : strip < PEAK_LEAST ? strip : PEAK_LEAST;
    pane[0] = (struct thud_rect){area.x, area.y, half, area.h - strip};
    pane[1] = (struct thud_rect){area.x + half, area.y, area.w - half, area.h - strip};
    pane[PEAKS] = (struct thud_rect){area.x, area.y + area.h - strip, area.w, strip};
    return 3;
}

/* " T1 0.398 s", where it is known. */
static const char *first_period(struct thud_tui *tui, int s, char text[32])
{
    const struct thud_model *model = thud_tui_model(tui);
    char number[24];
    *text = '\0';
    if (!model || s >= model->nstructures || model->structure[s].n == 0)
        return text;
    double omega = model->structure[s].omega[0];
    if (omega > 0.0)
        snprintf(text, 32, " T1 %s s", thud_tui_number(2.0 * THUD_PI / omega, number));
    return text;
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    const struct thud_scene *scene = &tui->doc.scene;
    if (index == PEAKS) {
        thud_peaks_strip_title(tui, tui->canvas.width - 2, text, size);
        return;
    }
    int s = tui->interface + index;
    char period[32], name[THUD_NAME_MAX + 4];
    int w = tui->canvas.width, room = (w < 80 || tui->canvas.height < 24 ? w : w / 2) - 30;
    if (s < scene->nstructures)
        snprintf(text, size, "%s: %s (%d of %d)%s", index ? "Right" : "Left",
                 thud_utf8_fit(scene->structure[s].name, room > 6 ? room : 6, name, sizeof name), s + 1,
                 scene->nstructures, first_period(tui, s, period));
    else
        snprintf(text, size, "no structure");
}

/* Periods and effective masses; of linked buildings those of all together, while the title has the building's own. */
static int modes(struct thud_tui *tui, const struct thud_pane *pane, int y, int s)
{
    const struct thud_model *model = thud_tui_model(tui);
    if (!model || s >= model->nstructures || model->structure[s].n == 0)
        return y;
    const struct thud_model_structure *structure = &model->structure[s];
    const struct thud_look look = thud_look(THUD_ROLE_MUTED, 0);
    const bool row = y + 1 == pane->h && structure->modes > 1; /* one is left: as many modes as have room in it */
    bool linked = false;
    for (int k = 0; k < model->nstructures; k++)
        linked |= k != s && model->structure[k].system == structure->system;
    char number[24], text[64], periods[160] = " T", masses[160] = " M*";
    int at = row && linked ? 1 + thud_pane_put(pane, 1, y, look, "linked ") : 1, shown = 0;
    if (linked)
        strcpy(periods, " linked T "), strcpy(masses, " linked M*");
    for (int j = 0; j < structure->modes && (row || j < (pane->w - 6) / 8 - linked); j++) {
        const double omega = model->omega[structure->first_mode + j], gamma = model->gamma[structure->first_mode + j];
        if (!(omega > 0.0))
            continue;
        const char *period = thud_tui_number(2.0 * THUD_PI / omega, number);
        const double percent = 100.0 * gamma * gamma / thud_model_mass_of_system(model, s);
        snprintf(text, sizeof text, "T%d %s s %.1f %%", j + 1, period, percent);
        if (row && at + thud_utf8_columns(text) > pane->w)
            break;
        at += row ? 2 + thud_pane_put(pane, at, y, look, text) : 0;
        thud_append(periods, sizeof periods, "%8s", period);
        thud_append(masses, sizeof masses, "%*.1f", shown++ || linked ? 8 : 7, percent);
    }
    if (shown == 0 || row)
        return y + row;
    thud_append(periods, sizeof periods, " s");
    thud_append(masses, sizeof masses, " %%");
    thud_pane_put(pane, 0, y, look, periods);
    thud_pane_put(pane, 0, y + 1, look, masses);
    return y + 2;
}

/* The table of floors: what stands in its columns. */
static const struct {
    const char *key, *head;
    int x, w; /* where all of them have room */
} column[] = {
    {"mass", "mass t", 6, 7},        {"stiffness", "k MN/m", 13, 7},           {"height", "h m", 21, 7},
    {"yield", "yield mm", 29, 8},    {"yield-shear", "yield MN", 40, 8},       {"hardening", "hardening %", 49, 11},
    {"column.EI", "col. EI", 61, 8}, {"column.capacity", "cap. kN", 70, 8},    {"slab-depth", "slab cm", 79, 8},
    {"gravity", "weight kN", 88, 9}, {"column.stiffness", "col. MN/m", 98, 9}, {"yield-coefficient", "yield %", 108, 8},
    {"load", "load kPa", 117, 8}};
enum { COLUMNS = sizeof column / sizeof *column };

/* Beside each floor, where there is room: its acceleration over time in the three cases, all to one scale. */
enum { SPARK = 10, SPARKS = 3 * (SPARK + 1) };

static int spark_columns(const struct thud_tui *tui)
{
    return tui->canvas.width >= THUD_MOMENT_WIDE ? SPARKS : 0;
}

/* The strong motion, all of the run where there is none, and the largest of all floors of the pair, m/s2. */
struct spark_scale {
    double from_s, to_s, most;
};

static struct spark_scale spark_scale(const struct thud_tui *tui)
{
    struct spark_scale scale = {0.0, INFINITY, 0.0};
    if (spark_columns(tui) && tui->doc.record) {
        const struct thud_intensity m = thud_intensity_of(tui->doc.record);
        scale.from_s = m.t5_s - 0.1 * m.d5_95_s;
        scale.to_s = m.t95_s + 0.1 * m.d5_95_s;
    }
    for (int i = 0; i < 2 * THUD_LIVE_CASES; i++)
        if (tui->interface + i % 2 < tui->doc.scene.nstructures)
            scale.most = fmax(scale.most, thud_live_peak(&tui->run.live, (enum thud_live_which)(i / 2),
                                                         tui->interface + i % 2, THUD_PEAK_ACCELERATION));
    return scale;
}

static void spark(const struct thud_tui *tui, enum thud_live_which which, const struct thud_pane *pane, int s,
                  int storey, const struct spark_scale *scale)
{
    const struct thud_history *h = thud_live_motions(&tui->run.live, which);
    const struct thud_model *model = tui->run.live.which[which].model;
    struct thud_dots dots;
    double high[4 * SPARK] = {0.0};
    if (!h || h->rows < 2 || !(scale->most > 0.0) || s >= model->nstructures ||
        thud_dots_init(&dots, pane, NULL) != THUD_OK)
        return;
    const struct thud_model_structure *of = &model->structure[s];
    const int above = of->n - tui->doc.scene.structure[s].storeys; /* an isolated slab is below them */
    const size_t at = (size_t)thud_history_acceleration(h, of->first + above + storey - 1);
    const double end = fmin(scale->to_s, h->time_s[h->rows - 1]), step = (end - scale->from_s) / dots.width;
    for (size_t i = 0; above >= 0 && i < h->rows; i++) {
        const double bin = floor((h->time_s[i] - scale->from_s) / step);
        if (bin >= 0 && bin < dots.width)
            high[(int)bin] = fmax(high[(int)bin], fabs(h->value[i * (size_t)h->columns + at]));
    }
    for (int x = 0; x < dots.width; x++)
        thud_dots_line(&dots, x, dots.height - 1.0, x, (dots.height - 1.0) * (1.0 - high[x] / scale->most), 1,
                       thud_look(THUD_ROLE_SERIES + thud_live_color(which), 0));
    thud_dots_put(&dots);
    thud_dots_clear(&dots);
}

/* The first column shown: as far to the left as lets the one with the cursor be seen. */
static int first_column(const struct thud_tui *tui, int index, int w, int s)
{
    const char *focus = tui->form.focus[THUD_SCREEN_MODEL];
    int number, first = 0;
    if (tui->form.pane[THUD_SCREEN_MODEL] != index && tui->form.pane[THUD_SCREEN_MODEL] >= 0)
        return 0;
    if (!thud_scan_word(&focus, "structures.") || !thud_scan_count(&focus, &number) || number != s + 1 ||
        !thud_scan_word(&focus, "."))
        return 0;
    for (int c = 0; c < COLUMNS; c++) {
        size_t n = strlen(column[c].key);
        if (strncmp(focus, column[c].key, n) == 0 && focus[n] == '.')
            while (column[c].x - column[first].x + column[0].x + column[c].w > w && first < c)
                first++;
    }
    return first;
}

static int floors(struct thud_tui *tui, int index, const struct thud_pane *pane, int y, int s)
{
    const struct thud_structure *structure = &tui->doc.scene.structure[s];
    const int room = pane->w - spark_columns(tui);
    const struct spark_scale scale = spark_scale(tui);
    int first = first_column(tui, index, room, s), shift = column[first].x - column[0].x, last = first;
    while (last + 1 < COLUMNS && column[last + 1].x - shift + column[last + 1].w <= room)
        last++;
    thud_pane_put(pane, 0, y, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "floor");
    for (int c = first; c <= last; c++)
        thud_pane_right(pane, column[c].x - shift + column[c].w, y, thud_look(THUD_ROLE_PLAIN, THUD_BOLD),
                        column[c].head);
    if (first > 0)
        thud_pane_glyph(pane, 5, y, thud_look(THUD_ROLE_KEY, THUD_BOLD), 0x2190);
    if (last + 1 < COLUMNS) /* the cursor leads on */
        thud_pane_glyph(pane, room - 1, y + 1, thud_look(THUD_ROLE_KEY, THUD_BOLD), 0x2192);
    for (int c = 0; c < THUD_LIVE_CASES && room < pane->w; c++) {
        const enum thud_live_which which = (enum thud_live_which)c;
        char head[64];
        const char *name = which == THUD_LIVE_FREE ? "no contact" : thud_live_short_name(&tui->doc.scene, which);
        thud_pane_put(pane, room + c * (SPARK + 1), y, thud_look(THUD_ROLE_SERIES + thud_live_color(which), 0),
                      thud_utf8_fit(name, SPARK, head, sizeof head));
    }
    y++;
    for (int i = structure->storeys; i >= 1; i--, y++) {
        thud_pane_print(pane, 0, y, thud_look(THUD_ROLE_PLAIN, 0), "%4d", i);
        for (int c = 0; c < THUD_LIVE_CASES && room < pane->w; c++) {
            struct thud_pane cell = thud_pane_inside(pane, room + c * (SPARK + 1), y - pane->scroll, SPARK, 1);
            if (y >= pane->scroll && y < pane->scroll + pane->h)
                spark(tui, (enum thud_live_which)c, &cell, s, i, &scale);
        }
        for (int c = 0; c < COLUMNS; c++) {
            char key[THUD_PATH_MAX];
            snprintf(key, sizeof key, "structures.%d.%s.%d", s + 1, column[c].key, i);
            if (!thud_scene_param(&tui->doc.scene, key, &(int){0})) {
                if (c >= first && c <= last)
                    thud_pane_right(pane, column[c].x - shift + column[c].w, y, thud_look(THUD_ROLE_MUTED, 0), "-");
            } else if (c >= first && c <= last)
                thud_field_value(tui, index, pane, column[c].x - shift, y, column[c].w, key, false);
            else
                thud_form_add_beside(&tui->form, index, column[c].x - shift, y, column[c].w, key);
        }
    }
    return y;
}

/* The values that are not by floor, two in a row where they are short. */
static int head_rows(struct thud_tui *tui, int index, const struct thud_pane *pane, int s)
{
    enum {
        SHEAR = 1 << THUD_SHEAR,
        RIGID = 1 << THUD_RIGID,
        ISOLATED = 1 << THUD_ISOLATED,
        WALL = 1 << THUD_WALL,
        MATRIX = 1 << THUD_MATRIX,
        MODES = 1 << THUD_MODES,
        ESTIMATED = 1 << THUD_ESTIMATED,
        READ = MATRIX | MODES,
        BUILDINGS = SHEAR | ISOLATED | READ | ESTIMATED
    };
    enum { LINEAR = 1 << 16, LEAD_RUBBER = LINEAR << 1, PENDULUM = LINEAR << 2 }; /* by their isolators */
    enum { SOIL = PENDULUM << 1 };                                                /* in rows below those of the kind */
    const struct thud_structure *structure = &tui->doc.scene.structure[s];
    const int kinds = 1 << structure->kind |
                      (structure->kind == THUD_ISOLATED ? LINEAR << (int)structure->isolator_law : 0) |
                      (thud_kind_is_building(structure->kind) ? SOIL : 0);
#define ON_SOIL(key, label, row, side)                                                                                 \
    {                                                                                                                  \
        "foundation." key, label, SOIL, row, side                                                                      \
    }
#define OF_WALL(key, label, row)                                                                                       \
    {                                                                                                                  \
        key, label, WALL, row, WIDE                                                                                    \
    }
#define WIDE  1, 18
#define LEFT  1, 9
#define RIGHT 20, 28
    static const struct {
        const char *key, *label;
        int kinds, y, x, value;
    } field[] = {
        {"kind", "kind", BUILDINGS | RIGID | WALL, 0, LEFT},
        {"name", "name", BUILDINGS | RIGID | WALL, 0, RIGHT},
        {"storeys", "storeys", BUILDINGS, 1, LEFT},
        {"damping", "damping", BUILDINGS, 1, RIGHT},
        {"period-factor", "T times", READ | ESTIMATED, 2, LEFT},
        {"area", "area", ESTIMATED, 2, RIGHT},
        {"system", "system", ESTIMATED, 3, 1, 13},
        {"stiffness-matrix", "stiffness", MATRIX, 3, 1, 13},
        {"flexibility-matrix", "flexibility", MATRIX, 4, 1, 13},
        {"unit", "unit", MATRIX, 5, LEFT},
        {"order", "order", MATRIX, 5, RIGHT},
        {"mass", "mass", RIGID, 1, WIDE},
        {"periods", "modes file", MODES, 3, 1, 13},
        {"unit", "unit", MODES, 4, LEFT},
        {"order", "order", MODES, 4, RIGHT},
        {"base-mass", "slab", ISOLATED, 2, LEFT},
        {"width", "width", ISOLATED, 2, RIGHT},
        {"isolator.law", "isolators", ISOLATED, 3, WIDE},
        {"isolation-damping", "isolator damping", ISOLATED, 4, WIDE},
        OF_WALL("mass", "mass", 1),
        {"height", "height", RIGID | WALL, 2, WIDE},
        OF_WALL("stiffness", "stiffness", 3),
        OF_WALL("damping", "damping", 4),
        OF_WALL("backfill.stiffness", "soil K max", 5),
        OF_WALL("backfill.strength", "soil strength", 6),
        OF_WALL("backfill.ratio", "failure ratio", 7),
        OF_WALL("backfill.gap", "gap to soil", 8),
        {"velocity", "velocity at 0", RIGID, 3, WIDE},
        {"isolation-stiffness", "isolator k", LINEAR, 5, WIDE},
        {"isolator.strength", "strength", LEAD_RUBBER, 5, WIDE},
        {"isolator.post-yield", "k beyond yield", LEAD_RUBBER, 6, WIDE},
        {"isolator.yield", "yields at", LEAD_RUBBER, 7, WIDE},
        {"isolator.radius", "radius", PENDULUM, 5, WIDE},
        {"isolator.friction", "friction", PENDULUM, 6, WIDE},
        {"isolator.yield", "elastic up to", PENDULUM, 7, WIDE},
        ON_SOIL("vs", "soil Vs", 0, LEFT),
        ON_SOIL("mass", "on", 0, RIGHT),
        ON_SOIL("density", "density", 1, LEFT),
        ON_SOIL("radius", "radius", 1, RIGHT),
        ON_SOIL("poisson", "Poisson", 2, LEFT),
        ON_SOIL("inertia", "inertia", 2, RIGHT),
        ON_SOIL("sway-stiffness", "sway k", 3, LEFT),
        ON_SOIL("sway-damping", "sway c", 3, RIGHT),
        ON_SOIL("rocking-stiffness", "rock k", 4, LEFT),
        ON_SOIL("rocking-damping", "rock c", 4, RIGHT),
    };
#undef ON_SOIL
#undef OF_WALL
#undef WIDE
#undef LEFT
#undef RIGHT
    const int kind_rows = rows_of_kind(structure), soil_rows = thud_structure_on_soil(structure) ? SOIL_ROWS : 0;
    int rows = 0;
    if (structure->kind == THUD_ESTIMATED) {
        const struct thud_estimate e = thud_structure_estimate(structure);
        thud_pane_print(pane, 1, 4, thud_look(THUD_ROLE_MUTED, 0), "EN 1998 %.3g s (used), ASCE 7 %.3g s", e.en1998_s,
                        e.asce7_s);
        rows = rows_of_kind(structure);
    }
    for (size_t i = 0; i < sizeof field / sizeof *field; i++) {
        const int y = field[i].y + (field[i].kinds & SOIL ? kind_rows : 0);
        if (!(field[i].kinds & kinds) || (field[i].kinds & SOIL && field[i].y >= soil_rows))
            continue;
        char key[THUD_PATH_MAX];
        int room = field[i].x == 1 && field[i].value == 9 ? 9 : pane->w - field[i].value - 1;
        snprintf(key, sizeof key, "structures.%d.%s", s + 1, field[i].key);
        thud_field_labelled(tui, index, pane, field[i].x, y, field[i].label, field[i].value, room, key);
        rows = y + 1 > rows ? y + 1 : rows;
    }
    return rows;
}

enum { SHAPE = 13, BUILDING = 14, LEAST_ROWS = 6, BELOW_ROWS = 7 };

/* Whether the scene has so much detail that there is a command to tell what of it is needed. */
static bool is_detailed(const struct thud_scene *scene)
{
    const struct thud_remark_scope scope = {.scene = scene};
    struct thud_remarks found = thud_remarks_find(&scope, THUD_REMARK_SIMPLER);
    const bool is = found.n > 0;
    thud_remarks_clear(&found);
    return is;
}

/* What both buildings of the pair are drawn to: the rows below the longer table, and the elevations from the lower base
 * to the higher roof, so that floors at one level stand in one row. */
struct elevation {
    int rows;
    double low_m, high_m;
};

static struct elevation elevation_of(const struct thud_tui *tui, int pane_rows)
{
    struct elevation e = {pane_rows, INFINITY, -INFINITY};
    for (int s = tui->interface; s < tui->interface + 2 && s < tui->doc.scene.nstructures; s++) {
        const struct thud_structure *structure = &tui->doc.scene.structure[s];
        if (!thud_kind_is_building(structure->kind))
            continue;
        int table = rows_of_kind(structure) + (thud_structure_on_soil(structure) ? SOIL_ROWS : 0) + 1 +
                    structure->storeys + 2 + BELOW_ROWS + is_detailed(&tui->doc.scene),
            rows = pane_rows - table - 2;
        e.rows = rows < e.rows ? rows : e.rows;
        e.low_m = fmin(e.low_m, structure->base_m);
        e.high_m = fmax(e.high_m, thud_structure_elevation(structure, thud_structure_floors(structure) - 1));
    }
    return e;
}

/* Row of an elevation, dots. */
static double row_of(const struct thud_dots *dots, const struct elevation *e, double level_m)
{
    return (dots->height - 1.0) * (e->high_m - level_m) / (e->high_m - e->low_m);
}

static void draw_building(struct thud_dots *dots, const struct elevation *e, const struct thud_structure *structure,
                          bool wall, struct thud_look look)
{
    double base = row_of(dots, e, structure->base_m), left = 1.0 * dots->across,
           right = (BUILDING - 5.0) * dots->across;
    int n = thud_structure_floors(structure);
    double top = row_of(dots, e, thud_structure_elevation(structure, n - 1));
    const bool soil = thud_structure_on_soil(structure);
    for (int thick = 0; thick < (soil ? 3 : 1); thick++)
        thud_dots_line(dots, soil ? left - 1.0 : 0.0, base + thick, right + (soil ? 1.0 : left), base + thick, 1,
                       thud_look(soil ? THUD_ROLE_WARN : THUD_ROLE_MUTED, 0));
    const double core = wall ? 0.35 * (right - left) : 0.0;
    for (double x = left + core; x <= right - core && wall; x += 1.0)
        thud_dots_line(dots, x, base, x, top, 1, look);
    thud_dots_line(dots, left + core, base, left + core, top, 1, look);
    thud_dots_line(dots, right - core, base, right - core, top, 1, look);
    const double bearing = structure->kind == THUD_ISOLATED ? dots->down : 0.0; /* the slab lies on them */
    for (int i = 0; i < n; i++) {
        double y = row_of(dots, e, thud_structure_elevation(structure, i)) - (i == 0 ? bearing : 0.0);
        thud_dots_line(dots, left, y, right, y, 1, look);
    }
    for (double x = -1.0; x <= 1.0 && bearing > 0.0; x += 1.0)
        for (int side = 0; side < 2; side++) {
            double at = side ? right - 1.5 * dots->across : left + 1.5 * dots->across;
            thud_dots_line(dots, at + x, base, at + x, base - bearing, 1, thud_look(THUD_ROLE_WARN, THUD_BOLD));
        }
}

/* The shape of mode j (from 0), as wide as SHAPE. */
static void draw_shape(struct thud_dots *dots, const struct elevation *e, const struct thud_structure *structure,
                       const struct thud_model_structure *m, int j, struct thud_look look)
{
    double middle = (BUILDING + (j + 0.45) * SHAPE) * dots->across, most = 0.0, x0 = middle,
           y0 = row_of(dots, e, structure->base_m);
    for (int i = 0; i < m->n; i++)
        most = fmax(most, fabs(m->phi[i * m->modes + j]));
    thud_dots_line(dots, middle, y0, middle, row_of(dots, e, thud_structure_elevation(structure, m->n - 1)), 3,
                   thud_look(THUD_ROLE_MUTED, 0));
    for (int i = 0; i < m->n && most > 0.0; i++) {
        double x = middle + 0.42 * SHAPE * dots->across * m->phi[i * m->modes + j] / most,
               y = row_of(dots, e, thud_structure_elevation(structure, i));
        thud_dots_line(dots, x0, y0, x, y, 1, look);
        x0 = x;
        y0 = y;
    }
}

/* The building at its elevation, and the shapes of its lowest modes, where there is room below the numbers. */
static void draw_shapes(struct thud_tui *tui, const struct thud_pane *pane, int s)
{
    const struct thud_structure *structure = &tui->doc.scene.structure[s];
    const struct thud_model *model = thud_tui_model(tui);
    const struct thud_model_structure *m = model && s < model->nstructures ? &model->structure[s] : NULL;
    struct elevation e = elevation_of(tui, pane->h);
    struct thud_dots dots;
    if (!m || !thud_kind_is_building(structure->kind) || m->n != thud_structure_floors(structure) || !m->phi ||
        e.rows < LEAST_ROWS || !(e.high_m > e.low_m) || !isfinite(e.high_m - e.low_m) || pane->scroll > 0)
        return;
    struct thud_pane area = thud_pane_inside(pane, 1, pane->h - 1 - e.rows, pane->w - 2, e.rows);
    if (thud_dots_init(&dots, &area, NULL) != THUD_OK)
        return;
    struct thud_look look = thud_look(THUD_ROLE_SERIES + (s - tui->interface), 0),
                     faint = thud_look(THUD_ROLE_MUTED, 0);
    draw_building(&dots, &e, structure, thud_structure_bends(structure, m), look);
    for (int j = 0; j < m->modes && BUILDING + (j + 1) * SHAPE <= area.w; j++) {
        char number[24];
        draw_shape(&dots, &e, structure, m, j, look);
        thud_pane_print(pane, 1 + BUILDING + j * SHAPE, pane->h - 1, faint, "%d: %s s", j + 1,
                        thud_tui_number(2.0 * THUD_PI / model->omega[m->first_mode + j], number));
    }
    thud_dots_put(&dots);
    thud_dots_clear(&dots);
    double top = thud_structure_elevation(structure, m->n - 1);
    if (structure->base_m != 0.0)
        thud_pane_print(pane, 1, pane->h - 1, faint, "%.3g to %.3g m", structure->base_m, top);
    else
        thud_pane_print(pane, 1, pane->h - 1, faint, "%.4g m", top);
}

/* What few buildings have otherwise: below their periods, so that the floors have the rows above. */
static int below(struct thud_tui *tui, int index, const struct thud_pane *pane, int y, int s)
{
    static const struct thud_labelled row[] = {
        {"base at", "base"},    {"soil Vs", "foundation.vs"}, {"columns", "column.shape"}, {"lowest modes", "modes"},
        {"given T1", "period"}, {"cracked", "cracked"},       {"floor area", "area"}};
    const struct thud_structure *structure = &tui->doc.scene.structure[s];
    const struct thud_storey storey = thud_storey_of(structure, 0);
    const bool soil = thud_structure_on_soil(structure); /* its values have rows of their own */
    if (is_detailed(&tui->doc.scene))
        thud_field_note(pane, y++, ":simplify shows what is needed");
    if (isfinite(storey.yield_m))
        thud_pane_print(pane, 0, y++, thud_look(THUD_ROLE_MUTED, 0), "storey 1: V_y %.3g MN, %.3g %% of W; u_y %.3g mm",
                        1e-6 * storey.yield_shear_n, 1e2 * storey.yield_ratio, 1e3 * storey.yield_m);
    for (size_t i = 0; i < BELOW_ROWS; i++) {
        char key[THUD_PATH_MAX];
        snprintf(key, sizeof key, "structures.%d.%s", s + 1, row[i].key);
        if (!(soil && i == 1) && !(structure->kind == THUD_ESTIMATED && i == 6) &&
            thud_scene_param(&tui->doc.scene, key, &(int){0}))
            thud_field_row(tui, index, pane, y++, row[i].label, key);
    }
    return y;
}

/* Where its values are from, and those of the groups of keys that it has. */
static int sources(struct thud_tui *tui, int index, const struct thud_pane *pane, int y, int s)
{
    for (int i = -1; i < THUD_NESTED_GROUPS; i++) {
        char key[THUD_PATH_MAX], label[THUD_NAME_MAX];
        const char *of = i < 0 ? "" : thud_group_key(thud_nested_group(i)), *dot = i < 0 ? "" : ".";
        if (i >= 0 && !thud_structure_has_group(&tui->doc.scene.structure[s], thud_nested_group(i)))
            continue;
        snprintf(key, sizeof key, "structures.%d.%s%ssource", s + 1, of, dot);
        snprintf(label, sizeof label, "%s%ssource", of, *dot ? " " : "");
        thud_field_row(tui, index, pane, y++, label, key);
    }
    return y;
}

static int draw_structure(struct thud_tui *tui, int index, const struct thud_pane *pane, int s)
{
    enum thud_structure_kind kind = tui->doc.scene.structure[s].kind;
    int y = head_rows(tui, index, pane, s);
    if (thud_kind_is_building(kind)) {
        y = modes(tui, pane, floors(tui, index, pane, y, s), s);
        y = below(tui, index, pane, y, s);
    }
    y = sources(tui, index, pane, y, s);
    draw_shapes(tui, pane, s);
    return y;
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    if (index == PEAKS)
        return thud_peaks_strip_draw(tui, pane);
    if (tui->interface + index >= tui->doc.scene.nstructures) {
        thud_field_note(pane, 0, "A adds one");
        return 1;
    }
    return draw_structure(tui, index, pane, tui->interface + index);
}

/* The structure the cursor is in. */
static int current(const struct thud_tui *tui)
{
    int pane = tui->form.pane[THUD_SCREEN_MODEL], s = tui->interface + (pane == 1);
    return s < tui->doc.scene.nstructures ? s : tui->doc.scene.nstructures - 1;
}

/* The floor the cursor is on, from 1; 0: none. */
static int current_floor(const struct thud_tui *tui)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    int structure, floor = 0;
    const char *at = field ? field->path : "";
    if (!thud_scan_word(&at, "structures.") || !thud_scan_count(&at, &structure) || !thud_scan_word(&at, "."))
        return 0;
    at += strspn(at, "abcdefghijklmnopqrstuvwxyz");
    return thud_scan_word(&at, ".") && thud_scan_count(&at, &floor) ? floor : 0;
}

static enum thud_reaction act(struct thud_tui *tui, enum thud_action action)
{
    switch (action) {
    case THUD_DO_ALL_FLOORS:
        thud_tui_all_floors(tui);
        return THUD_DONE;
    case THUD_DO_ADD_STOREY:
        thud_tui_edit_scene(tui, "storey add %d %d", current(tui) + 1, current_floor(tui));
        return THUD_DONE;
    case THUD_DO_DELETE_STOREY:
        thud_tui_edit_scene(tui, "storey delete %d %d", current(tui) + 1, current_floor(tui));
        return THUD_DONE;
    case THUD_DO_ADD_STRUCTURE:
        thud_tui_edit_scene(tui, "structure add %d", current(tui) + 1);
        return THUD_DONE;
    case THUD_DO_REMOVE_STRUCTURE:
        thud_tui_edit_scene(tui, "structure remove %d", current(tui) + 1);
        return THUD_DONE;
    case THUD_DO_SWAP:
        thud_tui_edit_scene(tui, "swap %d", tui->interface + 1);
        return THUD_DONE;
    default:
        return thud_tui_change_interface(tui, action) ? THUD_DONE : THUD_NOT_MINE;
    }
}

static const char *cannot(struct thud_tui *tui, enum thud_action action)
{
    const struct thud_scene *scene = &tui->doc.scene;
    int s = current(tui);
    bool storeys = s >= 0 && thud_kind_is_building(scene->structure[s].kind);
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
        return tui->interface + 1 < scene->nstructures ? NULL : "There is only one structure";
    default:
        return thud_tui_cannot_change_interface(tui, action);
    }
}

/* A floor of the drawing leads to its row. */
static void click(struct thud_tui *tui, int index, const struct thud_pane *pane, int x, int y)
{
    int s = tui->interface + index;
    if (index == PEAKS || s >= tui->doc.scene.nstructures || pane->scroll > 0)
        return;
    const struct thud_structure *structure = &tui->doc.scene.structure[s];
    struct elevation e = elevation_of(tui, pane->h);
    int top = pane->h - 1 - e.rows;
    double level = e.high_m - (y - top) * (e.high_m - e.low_m) / (e.rows - 1.0);
    if (!thud_kind_is_building(structure->kind) || e.rows < LEAST_ROWS || y < top || x > BUILDING)
        return;
    char key[THUD_PATH_MAX];
    snprintf(key, sizeof key, "structures.%d.mass.%d", s + 1, thud_storey_at(structure, level));
    thud_form_focus_on(&tui->form, THUD_SCREEN_MODEL, key);
}

static enum thud_live_history history(const struct thud_tui *tui)
{
    return spark_columns(tui) ? THUD_LIVE_LOOK : THUD_LIVE_NO_HISTORY;
}

THUD_VIEW(model, "Model", MODEL, .compares = true, .keys = "structures.", .history = history, .act = act,
          .click = click, .cannot = cannot);
