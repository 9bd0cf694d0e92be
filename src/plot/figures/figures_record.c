#include "plot/figures/figures_record.h"

#include <math.h>
#include <stdio.h>

#include "base/quantity.h"
#include "ground/intensity.h"
#include "plot/figures/figures_run_internal.h"

enum { PANELS = 3 };

struct thud_figure *thud_figure_of_motion(const struct thud_record *record, const char *name, const char *title)
{
    static const char *const label[PANELS] = {"Acceleration", "Velocity", "Displacement"};
    static const char *const unit[PANELS] = {"g", "m/s", "m"};
    struct thud_figure *figure = thud_figure_create(name, title, PANELS, 1);
    struct thud_series *series[PANELS];
    for (int k = 0; k < PANELS; k++) {
        struct thud_panel *panel = thud_figure_panel(figure, k, 0, "");
        struct thud_style style = {.kind = THUD_LINES, .color = k, .thin = true};
        thud_panel_axis(panel, THUD_X, "Time", "s");
        thud_panel_axis(panel, THUD_Y, label[k], unit[k]);
        series[k] = thud_panel_add(panel, style, "", record->samples, NULL, NULL);
        for (size_t i = 0; series[k] && i < record->samples; i++)
            series[k]->x[i] = (double)i * record->dt_s;
    }
    for (size_t i = 0; series[0] && i < record->samples; i++)
        series[0]->y[i] = record->a_mps2[i] / THUD_GRAVITY;
    thud_record_integrate(record, series[1] ? series[1]->y : NULL, series[2] ? series[2]->y : NULL);
    thud_figure_note(figure, "Velocity and displacement from rest, of the acceleration less its mean.");
    thud_figure_shorten(figure);
    return figure;
}

struct thud_figure *thud_figure_of_parts(const struct thud_record *whole, double from_s, double to_s, const char *name,
                                         const char *title)
{
    const double edge[2] = {from_s, to_s}, rounding_s = 1e-6 * whole->dt_s;
    struct thud_figure *figure = thud_figure_create(name, title, 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, "Time in the file", "s");
    thud_panel_axis(panel, THUD_Y, "Acceleration", "g");
    for (int cut = 0; cut < 2; cut++) {
        struct thud_style style = {.kind = THUD_LINES, .color = cut, .thin = cut == 1};
        struct thud_series *series = thud_panel_add(panel, style, cut ? "cut off" : "used", whole->samples, NULL, NULL);
        for (size_t i = 0; series && i < whole->samples; i++) {
            series->x[i] = (double)i * whole->dt_s;
            const bool outside = series->x[i] < from_s - rounding_s || series->x[i] > to_s + rounding_s;
            series->y[i] = outside == (cut == 1) ? whole->a_mps2[i] / THUD_GRAVITY : NAN;
        }
        if (!isnan(edge[cut]))
            thud_panel_mark(panel, THUD_X, edge[cut], edge[cut], "");
    }
    return figure;
}

static double value(const struct thud_spectrum_point *point, int k)
{
    return k == 0 ? point->acceleration_mps2 / THUD_GRAVITY : k == 1 ? point->velocity_mps : point->displacement_m;
}

struct thud_figure *thud_figure_of_spectrum(const struct thud_spectrum_point *point, size_t count, double damping,
                                            const struct thud_period_mark *mark, int nmarks, const char *name,
                                            const char *title)
{
    static const char *const label[PANELS] = {"Sa", "Sv", "Sd"}, *const unit[PANELS] = {"g", "m/s", "m"};
    struct thud_figure *figure = thud_figure_create(name, title, PANELS, 1);
    for (int k = 0; k < PANELS; k++) {
        struct thud_panel *panel = thud_figure_panel(figure, k, 0, "");
        thud_panel_axis(panel, THUD_X, "Period", "s");
        char text[64];
        snprintf(text, sizeof text, "%s, %.3g %% damped", label[k], 100 * damping);
        thud_panel_axis(panel, THUD_Y, text, unit[k]);
        thud_panel_log(panel, THUD_X);
        thud_panel_limits(panel, THUD_X, point[0].period_s, point[count - 1].period_s);
        double most = NAN; /* of the uppermost panel, with room for the names of the periods */
        for (size_t i = 0; k == 0 && nmarks > 0 && i < count; i++)
            most = fmax(most, 1.3 * value(&point[i], k));
        thud_panel_limits(panel, THUD_Y, 0, most);
        struct thud_series *series =
            thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = k}, "", count, NULL, NULL);
        for (size_t i = 0; series && i < count; i++) {
            series->x[i] = point[i].period_s;
            series->y[i] = value(&point[i], k);
        }
        for (int i = 0; i < nmarks; i++)
            if (mark[i].period_s >= point[0].period_s && mark[i].period_s <= point[count - 1].period_s)
                thud_panel_mark(panel, THUD_X, mark[i].period_s, mark[i].period_s, k == 0 ? mark[i].text : "");
    }
    thud_figure_note(figure, "Sa total, Sv and Sd relative to the ground.");
    return figure;
}
