#include <math.h>
#include <stdio.h>

#include "app/stability_report.h"

enum { ROWS_MAX = 64, COLUMNS_MAX = 16 };

/* The fixed-step methods, last one lowest; columns are the steps. */
struct grid {
    int rows, columns;
    const struct thud_stepping *how[ROWS_MAX];
    double omega_dt[COLUMNS_MAX];
    const struct thud_stability_cell *cell[ROWS_MAX][COLUMNS_MAX];
};

static void fill(const struct thud_stability *s, struct grid *g)
{
    *g = (struct grid){0};
    for (int i = 0; i < s->ncells; i++) {
        const struct thud_stability_cell *c = &s->cell[i];
        const struct thud_stepping *last = g->rows > 0 ? g->how[g->rows - 1] : NULL;
        if (!last || last->method != c->how.method || last->locate != c->how.locate) {
            if (g->rows == ROWS_MAX)
                return;
            g->how[g->rows++] = &c->how;
        }
        int row = g->rows - 1, k = 0;
        if (isnan(c->omega_dt)) {
            for (k = 0; k < COLUMNS_MAX; k++)
                g->cell[row][k] = c;
            continue;
        }
        while (k < g->columns && g->omega_dt[k] != c->omega_dt)
            k++;
        if (k == COLUMNS_MAX)
            continue;
        if (k == g->columns)
            g->omega_dt[g->columns++] = c->omega_dt;
        g->cell[row][k] = c;
    }
}

static void add_labels(const struct grid *g, struct thud_panel *panel)
{
    char text[64];
    for (int k = 0; k < g->columns; k++) {
        snprintf(text, sizeof text, "%.4g", g->omega_dt[k]);
        thud_panel_tick(panel, THUD_X, k, text);
    }
    for (int row = 0; row < g->rows; row++) {
        thud_stepping_name(g->how[row], text, sizeof text);
        thud_panel_tick(panel, THUD_Y, g->rows - 1 - row, text);
    }
    thud_panel_limits(panel, THUD_X, -0.5, g->columns - 0.5);
    thud_panel_limits(panel, THUD_Y, -0.5, g->rows - 0.5);
}

/* Where the linear system's limit lies between two columns. */
static void add_limits(const struct grid *g, struct thud_panel *panel)
{
    double x[3 * ROWS_MAX], y[3 * ROWS_MAX];
    size_t n = 0;
    for (int row = 0; row < g->rows; row++) {
        int k = 0;
        while (k < g->columns && g->omega_dt[k] < g->how[row]->method->stability)
            k++;
        for (int end = 0; end < 3; end++) {
            x[n] = end == 2 || k == g->columns ? NAN : k - 0.5;
            y[n++] = g->rows - 1 - row + (end == 0 ? -0.5 : 0.5);
        }
    }
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = 0, .wide = true}, "", n, x, y);
}

struct thud_figure *thud_stability_map(const struct thud_stability *s, int kind)
{
    static const char *const verdicts[] = {"bounded", "growing", "blown up"};
    static const char *const names[THUD_STABILITY_KINDS] = {"stability-free", "stability-wall", "stability-scene"};
    static const char *const titles[THUD_STABILITY_KINDS] = {"An undamped oscillator for 50 s",
                                                             "A mass bouncing on a wall spring for 50 s",
                                                             "The scene, in its fastest mode's ω Δt"};
    struct grid g;
    double z[ROWS_MAX * COLUMNS_MAX], x[COLUMNS_MAX], y[ROWS_MAX];
    fill(s, &g);
    struct thud_figure *figure = thud_figure_create(names[kind], titles[kind], 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    for (int k = 0; k < g.columns; k++)
        x[k] = k;
    for (int row = 0; row < g.rows; row++)
        y[row] = row;
    for (int row = 0; row < g.rows; row++)
        for (int k = 0; k < g.columns; k++) {
            const struct thud_stability_cell *c = g.cell[row][k];
            z[(g.rows - 1 - row) * g.columns + k] = c && c->verdict[kind] ? (double)c->verdict[kind] - 1 : NAN;
        }
    thud_panel_axis(panel, THUD_X, "ω Δt", "");
    thud_panel_axis(panel, THUD_Y, "", "");
    add_labels(&g, panel);
    struct thud_map *map =
        thud_panel_map(panel, (size_t)g.columns, x, (size_t)g.rows, y, z, "0 bounded, 1 growing, 2 blown up", "");
    if (map) {
        map->class_name = verdicts;
        map->classes = sizeof verdicts / sizeof *verdicts;
    }
    add_limits(&g, panel);
    thud_figure_note(figure,
                     "Blue line: the limit of the linear system. Methods without a step are the same in every column.");
    return figure;
}

/* The same in both panels: its place among the fixed-step ones. */
static int color_of(const struct thud_method *method)
{
    int color = 0;
    for (int i = 0; thud_method_at(i) != method; i++)
        color += (thud_method_at(i)->flags & THUD_METHOD_FIXED_STEP) != 0;
    return color;
}

struct thud_figure *thud_stability_energies(const struct thud_stability *s)
{
    struct thud_figure *figure =
        thud_figure_create("stability-energy", "Energy after 50 s of bouncing on a wall spring", 1, 2);
    for (int located = 0; located < 2; located++) {
        struct thud_panel *panel =
            thud_figure_panel(figure, 0, located, located ? "Impacts located" : "Impacts not located");
        thud_panel_axis(panel, THUD_X, "ω_c Δt", "");
        thud_panel_axis(panel, THUD_Y, "Energy at the end over the start", "");
        thud_panel_log(panel, THUD_X);
        thud_panel_log(panel, THUD_Y);
        thud_panel_limits(panel, THUD_Y, 1e-4, 1e4);
        thud_panel_mark(panel, THUD_Y, 1, 1, "kept");
        for (int i = 0, last; i < s->nenergies; i = last) {
            const struct thud_stability_energy *e = &s->energy[i];
            double x[COLUMNS_MAX], y[COLUMNS_MAX];
            size_t n = 0;
            for (last = i; last < s->nenergies && s->energy[last].how.method == e->how.method &&
                           s->energy[last].how.locate == e->how.locate;
                 last++)
                if (n < COLUMNS_MAX && isfinite(s->energy[last].omega_dt)) {
                    x[n] = s->energy[last].omega_dt;
                    y[n++] = fmin(1e4, fmax(1e-4, s->energy[last].ratio)); /* at the rim: beyond it */
                }
            if (n > 0 && e->how.locate == (located == 1) && !(e->how.method->flags & THUD_METHOD_EXHIBIT))
                thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES_POINTS, .color = color_of(e->how.method)},
                               e->how.method->name, n, x, y);
        }
    }
    thud_figure_note(
        figure,
        "At the upper and lower rim: 1e4 or more (or blown up), 1e-4 or less. Lagged forces blow up everywhere.");
    return figure;
}
