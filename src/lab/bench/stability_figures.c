#include <math.h>
#include <stdio.h>

#include "lab/bench/stability_report.h"

enum { ROWS_MAX = 64, COLUMNS_MAX = 16 };

/* The fixed-step methods, located and not, last one lowest; columns are the steps. */
struct grid {
    int rows, columns;
    const struct thud_stepping *how[ROWS_MAX];
    double omega_dt[COLUMNS_MAX];
    const struct thud_stability_cell *cell[ROWS_MAX][COLUMNS_MAX];
};

static void fill_grid(const struct thud_stability *s, struct grid *g)
{
    *g = (struct grid){0};
    for (int i = 0; i < s->ncells; i++) {
        const struct thud_stability_cell *c = &s->cell[i];
        const struct thud_stepping *last = g->rows > 0 ? g->how[g->rows - 1] : NULL;
        int k = 0;
        if (isnan(c->omega_dt))
            continue;
        if (!last || last->method != c->how.method || last->locate != c->how.locate) {
            if (g->rows == ROWS_MAX)
                return;
            g->how[g->rows++] = &c->how;
        }
        while (k < g->columns && g->omega_dt[k] != c->omega_dt)
            k++;
        if (k == COLUMNS_MAX)
            continue;
        if (k == g->columns)
            g->omega_dt[g->columns++] = c->omega_dt;
        g->cell[g->rows - 1][k] = c;
    }
}

static void add_names(const struct grid *g, struct thud_panel *panel)
{
    char text[64];
    for (int row = 0; row < g->rows; row++) {
        bool below = row > 0 && g->how[row - 1]->method == g->how[row]->method;
        snprintf(text, sizeof text, "%s", below ? "impacts located" : g->how[row]->method->name);
        thud_panel_tick(panel, THUD_Y, g->rows - 1 - row, text);
    }
    thud_panel_limits(panel, THUD_Y, -0.5, g->rows - 0.5);
}

/* Where the linear system's limit lies. */
static void add_limits(const struct grid *g, struct thud_panel *panel)
{
    double x[3 * ROWS_MAX], y[3 * ROWS_MAX];
    size_t n = 0;
    for (int row = 0; row < g->rows; row++)
        for (int end = 0; end < 3; end++) {
            x[n] = end == 2 || isinf(g->how[row]->method->stability) ? NAN : g->how[row]->method->stability;
            y[n++] = g->rows - 1 - row + (end == 0 ? -0.5 : 0.5);
        }
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = 0, .wide = true}, "", n, x, y);
}

/* What the colours mean, and what became of the methods that have no place on the axis. */
static void add_note(const struct thud_stability *s, int kind, const char *meant, struct thud_figure *figure)
{
    struct thud_text note = {0};
    thud_text_append(
        &note, "%s Blue: limit of the linear system. One block for each step tried. With steps of their own:", meant);
    const char *comma = " ";
    for (int i = 0; i < s->ncells; i++)
        if (isnan(s->cell[i].omega_dt)) {
            thud_text_append(&note, "%s%s %s", comma, s->cell[i].how.method->name,
                             thud_stability_verdict_word(s->cell[i].verdict[kind]));
            comma = ", ";
        }
    thud_text_append(&note, ".");
    thud_figure_note(figure, note.data ? note.data : "");
    thud_text_clear(&note);
}

struct thud_figure *thud_stability_map(const struct thud_stability *s, int kind)
{
    static const char *const verdicts[] = {"bounded", "growing", "blown up"};
    static const struct {
        const char *name, *title, *axis, *meant;
    } maps[THUD_STABILITY_KINDS] = {
        [THUD_STABILITY_FREE] = {"stability-free", "An undamped oscillator for 50 s", "ω Δt (oscillator)",
                                 "Growing: from 1.21 times the energy in the second half of the time; blown up: from "
                                 "10,000 times."},
        [THUD_STABILITY_WALL] = {"stability-wall",
                                 "A mass bouncing on a wall spring for 50 s, the worst of several starts",
                                 "ω Δt (wall spring)",
                                 "Growing: energy from 1.21 times that of the start; blown up: from 10,000 times."},
        [THUD_STABILITY_SCENE] = {"stability-scene", "The scene, the worst of three steps of nearly this length",
                                  "ω Δt (fastest mode)",
                                  "Growing: a displacement from twice the exact peak; blown up: from 100 times."}};
    struct grid g;
    double z[ROWS_MAX * COLUMNS_MAX], y[ROWS_MAX];
    fill_grid(s, &g);
    struct thud_figure *figure = thud_figure_create(maps[kind].name, maps[kind].title, 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    for (int row = 0; row < g.rows; row++)
        y[row] = row;
    for (int row = 0; row < g.rows; row++)
        for (int k = 0; k < g.columns; k++) {
            const struct thud_stability_cell *c = g.cell[row][k];
            z[(g.rows - 1 - row) * g.columns + k] = c && c->verdict[kind] ? (double)c->verdict[kind] - 1 : NAN;
        }
    thud_panel_axis(panel, THUD_X, maps[kind].axis, "");
    thud_panel_axis(panel, THUD_Y, "", "");
    thud_panel_log(panel, THUD_X);
    thud_panel_limits(panel, THUD_X, 0.1, 10);
    add_names(&g, panel);
    struct thud_map *map = thud_panel_map(panel, (size_t)g.columns, g.omega_dt, (size_t)g.rows, y, z,
                                          "0 bounded, 1 growing, 2 blown up", "");
    if (map) {
        map->class_name = verdicts;
        map->classes = sizeof verdicts / sizeof *verdicts;
    }
    add_limits(&g, panel);
    add_note(s, kind, maps[kind].meant, figure);
    return figure;
}

/* ---- energy ---- */

static const double least_ratio = 1e-3, most_ratio = 1e4; /* of the energy shown; the most stands for what is beyond */

static double shown(double ratio)
{
    return fmin(most_ratio, fmax(least_ratio, ratio));
}

/* The largest energy of all starts over the steps of the cells from `first` on, and a band of what is left at the end;
 * where the next method or way begins. */
static int add_way(const struct thud_stability *s, int first, struct thud_panel *panel)
{
    const struct thud_stepping *how = &s->cell[first].how;
    double x[COLUMNS_MAX], largest[COLUMNS_MAX], low[COLUMNS_MAX];
    const char *name = how->locate ? "impacts located" : "not located";
    int i = first, color = how->locate ? 1 : 0;
    size_t n = 0;
    for (; i < s->ncells && s->cell[i].how.method == how->method && s->cell[i].how.locate == how->locate; i++) {
        const struct thud_stability_cell *c = &s->cell[i];
        if (n == COLUMNS_MAX || !c->verdict[THUD_STABILITY_WALL])
            continue;
        x[n] = c->omega_dt;
        largest[n] = shown(c->growth[THUD_STABILITY_WALL]);
        low[n++] = shown(c->end_least);
    }
    thud_panel_fill(panel, (struct thud_style){.kind = THUD_FILL, .color = color, .thin = true}, name, n, x, low,
                    largest);
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES_POINTS, .color = color}, name, n, x, largest);
    return i;
}

struct thud_figure *thud_stability_energies(const struct thud_stability *s)
{
    enum { COLUMNS = 4 };
    int methods = 0, at = 0;
    for (int i = 0; i < thud_method_count(); i++)
        methods += (thud_method_at(i)->flags & THUD_METHOD_FIXED_STEP) != 0;
    struct thud_figure *figure =
        thud_figure_create("stability-energy", "Energy of a mass bouncing on a wall spring, over that at the start",
                           (methods + COLUMNS - 1) / COLUMNS, COLUMNS);
    const struct thud_method *last = NULL;
    struct thud_panel *panel = NULL;
    for (int i = 0; i < s->ncells;) {
        const struct thud_method *method = s->cell[i].how.method;
        if (!(method->flags & THUD_METHOD_FIXED_STEP)) {
            i++;
            continue;
        }
        if (method != last) {
            panel = thud_figure_panel(figure, at / COLUMNS, at % COLUMNS, method->name);
            thud_panel_axis(panel, THUD_X, "ω Δt of the spring", "");
            thud_panel_axis(panel, THUD_Y, at % COLUMNS ? "" : "Energy ratio", "");
            thud_panel_log(panel, THUD_X);
            thud_panel_log(panel, THUD_Y);
            thud_panel_limits(panel, THUD_X, 0.1, 10);
            thud_panel_limits(panel, THUD_Y, least_ratio, 2 * most_ratio); /* no curve on the frame */
            thud_panel_mark(panel, THUD_Y, 1, 1, "");
            at++;
        }
        last = method;
        i = add_way(s, i, panel);
    }
    thud_figure_note(figure, "Curves: the largest energy within 50 s, at the worst of several starts; shaded down to "
                             "the least that is left at the end. At 10,000: that or more, or blown up.");
    return figure;
}
