#include "plot/figures/figures_suite.h"

#include <math.h>
#include <stdio.h>

#include "base/quantity.h"

enum { N = THUD_TARGET_PERIODS };

static void curve(struct thud_panel *panel, struct thud_style style, const char *name, const double *x,
                  const double *y_mps2, double factor)
{
    struct thud_series *series = thud_panel_add(panel, style, name, N, x, NULL);
    for (int p = 0; series && p < N; p++)
        series->y[p] = factor * y_mps2[p] / THUD_GRAVITY;
}

struct thud_figure *thud_figure_of_suite(const struct thud_scaled_suite *suite, const char *target,
                                         const struct thud_period_mark *mark, int nmarks)
{
    char title[256], note[160];
    snprintf(title, sizeof title, "%d ground motions%s%s", suite->chosen, *target ? " scaled to " : "", target);
    struct thud_figure *figure = thud_figure_create("suite", title, 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, "Period", "s");
    snprintf(note, sizeof note, "Sa, %.3g %% damped", 100 * suite->damping);
    thud_panel_axis(panel, THUD_Y, note, "g");
    thud_panel_log(panel, THUD_X);
    thud_panel_limits(panel, THUD_X, suite->period_s[0], suite->period_s[N - 1]);
    thud_panel_limits(panel, THUD_Y, 0, NAN);
    const char *name = "each motion";
    for (int i = 0; i < suite->n; i++) {
        if (!suite->motion[i].chosen)
            continue;
        curve(panel, (struct thud_style){.kind = THUD_LINES, .color = THUD_COLOR_GREY, .thin = true}, name,
              suite->period_s, suite->motion[i].sa_mps2, suite->motion[i].factor);
        name = "";
    }
    curve(panel, (struct thud_style){.kind = THUD_LINES, .color = 0, .wide = true}, "mean", suite->period_s,
          suite->mean_mps2, 1);
    if (*target) {
        curve(panel, (struct thud_style){.kind = THUD_LINES, .color = 1, .wide = true}, "target", suite->period_s,
              suite->target_mps2, 1);
        curve(panel, (struct thud_style){.kind = THUD_LINES, .color = 6, .wide = true, .dashed = true},
              "90 % of the target", suite->period_s, suite->target_mps2, 0.9);
    }
    for (int i = 0; i < nmarks; i++)
        thud_panel_mark(panel, THUD_X, mark[i].period_s, mark[i].period_s, mark[i].text);
    snprintf(note, sizeof note, "Range of periods %.3g to %.3g s. Pseudo spectral acceleration.", suite->period_s[0],
             suite->period_s[N - 1]);
    thud_figure_note(figure, note);
    return figure;
}
