#include "plot/figures/figures_floor.h"

#include <math.h>
#include <stdio.h>

#include "base/quantity.h"
#include "plot/figures/figures_case.h"
#include "study/scene/level.h"

enum { APART = 4 }; /* floors that have a panel of their own */

static struct thud_panel *panel_of(struct thud_figure *figure, int row, int column, const char *title,
                                   const struct thud_floor_spectra *s)
{
    struct thud_panel *panel = thud_figure_panel(figure, row, column, title);
    thud_panel_axis(panel, THUD_X, "Period", "s");
    char label[64];
    snprintf(label, sizeof label, "Sa, %.3g %% damped", 100 * s->damping);
    thud_panel_axis(panel, THUD_Y, label, "g");
    thud_panel_log(panel, THUD_X);
    thud_panel_limits(panel, THUD_X, s->period_s[0], s->period_s[s->nperiods - 1]);
    thud_panel_limits(panel, THUD_Y, 0, NAN);
    return panel;
}

static void curve(struct thud_panel *panel, const struct thud_floor_spectra *s, int which, int floor, int color,
                  const char *name)
{
    int largest;
    const double *sa = thud_floor_spectrum(s, which, floor, &largest);
    struct thud_style style = {.kind = THUD_LINES, .color = color};
    struct thud_series *series = thud_panel_add(panel, style, name, (size_t)s->nperiods, s->period_s, sa);
    for (int k = 0; series && k < s->nperiods; k++)
        series->y[k] /= THUD_GRAVITY;
}

/* The structures that have floors here, in rows; returns how many. */
static int rows_of(const struct thud_floor_spectra *s, int row[THUD_STRUCTURES_MAX])
{
    int rows = 0;
    for (int k = 0; k < THUD_STRUCTURES_MAX; k++) {
        row[k] = -1;
        for (int f = 0; f < s->nfloors && row[k] < 0; f++)
            if (s->floor[f].structure == k)
                row[k] = rows++;
    }
    return rows;
}

struct thud_figure *thud_figure_of_floors(const struct thud_scene *scene, const struct thud_floor_spectra *s)
{
    char title[THUD_NAME_MAX + 80];
    int row[THUD_STRUCTURES_MAX];
    const bool apart = s->nfloors <= APART;
    struct thud_figure *figure = thud_figure_create("floor-spectra", "Floor spectra",
                                                    apart ? s->nfloors : rows_of(s, row), apart ? 1 : s->ncases);
    for (int f = 0; apart && f < s->nfloors; f++) {
        const struct thud_floor_place at = s->floor[f];
        char name[24];
        snprintf(title, sizeof title, "%s, %s", scene->structure[at.structure].name,
                 thud_structure_level_name(&scene->structure[at.structure], at.floor, false, name));
        struct thud_panel *panel = panel_of(figure, f, 0, title, s);
        for (int i = 0; i < s->ncases; i++)
            curve(panel, s, i, f, thud_case_color(thud_case_compared(i)), thud_floor_case_title(scene, i));
    }
    for (int i = 0; !apart && i < s->ncases; i++) {
        struct thud_panel *panel = NULL;
        for (int f = 0; f < s->nfloors; f++) {
            const struct thud_floor_place at = s->floor[f];
            if (f == 0 || at.structure != s->floor[f - 1].structure) {
                snprintf(title, sizeof title, "%s, %s", scene->structure[at.structure].name,
                         thud_floor_case_title(scene, i));
                panel = panel_of(figure, row[at.structure], i, title, s);
            }
            char name[24];
            curve(panel, s, i, f, at.floor % THUD_COLORS_ALL,
                  thud_structure_level_name(&scene->structure[at.structure], at.floor, false, name));
        }
    }
    for (int r = 0; figure && r < figure->rows; r++) { /* a light wall that is struck would leave the floors flat */
        int f = apart ? r : 0;
        while (!apart && row[s->floor[f].structure] != r)
            f++;
        if (scene->structure[s->floor[f].structure].kind == THUD_WALL)
            thud_figure_share_scale(figure, THUD_Y, r * figure->columns, 1, figure->columns, NULL);
    }
    if (figure)
        thud_figure_share_scale(figure, THUD_Y, 0, 1, figure->rows * figure->columns, NULL);
    snprintf(title, sizeof title, "Oscillators of %.3g %% damping on the floors. Pseudo spectral acceleration.",
             100 * s->damping);
    thud_figure_note(figure, title);
    return figure;
}
