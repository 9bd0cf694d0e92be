#include <math.h>
#include <stdio.h>

#include "base/quantity.h"
#include "ground/spectrum.h"
#include "tui/document/state.h"
#include "tui/screens/record_figure.h"

const char *thud_record_curve_title(enum thud_record_curve curve)
{
    static const char *const title[] = {"Ground acceleration", "Ground velocity", "Ground displacement",
                                        "Response spectrum, 5 %"};
    return title[curve];
}

/* The whole motion in the file's own time: the part that is used, and what is cut off. */
static void parts(struct thud_panel *panel, const struct thud_doc *doc)
{
    const struct thud_record *whole = doc->whole;
    const double edge[2] = {doc->record_choice.from_s, doc->record_choice.to_s};
    thud_panel_axis(panel, THUD_X, "Time in the file", "s");
    thud_panel_axis(panel, THUD_Y, "Acceleration", "g");
    for (int cut = 0; cut < 2; cut++) {
        struct thud_style style = {.kind = THUD_LINES, .color = cut, .thin = cut == 1};
        struct thud_series *series = thud_panel_add(panel, style, cut ? "cut off" : "used", whole->samples, NULL, NULL);
        for (size_t i = 0; series && i < whole->samples; i++) {
            series->x[i] = (double)i * whole->dt_s;
            bool here = thud_doc_uses(doc, series->x[i]) == !cut;
            series->y[i] = here ? whole->a_mps2[i] / THUD_GRAVITY : NAN;
        }
        if (!isnan(edge[cut]))
            thud_panel_mark(panel, THUD_X, edge[cut], edge[cut], "");
    }
}

static void history(struct thud_panel *panel, const struct thud_record *record, enum thud_record_curve curve)
{
    static const char *const unit[] = {"g", "m/s", "m"};
    static const char *const label[] = {"Acceleration", "Velocity", "Displacement"};
    thud_panel_axis(panel, THUD_X, "Time", "s");
    thud_panel_axis(panel, THUD_Y, label[curve], unit[curve]);
    struct thud_series *series =
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES}, "", record->samples, NULL, NULL);
    if (!series)
        return;
    if (curve != THUD_RECORD_ACCELERATION)
        thud_record_integrate(record, curve == THUD_RECORD_VELOCITY ? series->y : NULL,
                              curve == THUD_RECORD_DISPLACEMENT ? series->y : NULL);
    for (size_t i = 0; i < record->samples; i++) {
        series->x[i] = (double)i * record->dt_s;
        if (curve == THUD_RECORD_ACCELERATION)
            series->y[i] = record->a_mps2[i] / THUD_GRAVITY;
    }
}

/* With the structures' first periods marked. */
static void spectrum(struct thud_panel *panel, const struct thud_record *record, const struct thud_scene *scene,
                     const struct thud_model *model)
{
    enum { POINTS = 120 };
    struct thud_spectrum_point point[POINTS];
    thud_spectrum_fill(record, 0.05, 0.05, 5.0, POINTS, point);
    thud_panel_axis(panel, THUD_X, "Period", "s");
    thud_panel_axis(panel, THUD_Y, "Sa", "g");
    thud_panel_log(panel, THUD_X);
    thud_panel_limits(panel, THUD_X, 0.05, 5.0);
    thud_panel_limits(panel, THUD_Y, 0.0, NAN);
    struct thud_series *series = thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES}, "", POINTS, NULL, NULL);
    for (int i = 0; series && i < POINTS; i++) {
        series->x[i] = point[i].period_s;
        series->y[i] = point[i].acceleration_mps2 / THUD_GRAVITY;
    }
    for (int s = 0; model && s < model->nstructures && s < 4; s++) {
        double omega = model->structure[s].n > 0 ? model->structure[s].omega[0] : 0.0;
        if (omega > 0.0)
            thud_panel_mark(panel, THUD_X, 2.0 * THUD_PI / omega, 2.0 * THUD_PI / omega, scene->structure[s].name);
    }
}

struct thud_figure *thud_record_figure(const struct thud_doc *doc, const struct thud_model *model,
                                       enum thud_record_curve curve)
{
    static const char *const name[] = {"ground-acceleration", "ground-velocity", "ground-displacement",
                                       "response-spectrum"};
    struct thud_figure *figure = thud_figure_create(name[curve], thud_record_curve_title(curve), 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    if (curve == THUD_RECORD_SPECTRUM)
        spectrum(panel, doc->record, &doc->scene, model);
    else if (curve == THUD_RECORD_ACCELERATION && doc->whole)
        parts(panel, doc);
    else
        history(panel, doc->record, curve);
    if (thud_figure_check(figure, NULL) == THUD_OK)
        return figure;
    thud_figure_free(figure);
    return NULL;
}

int thud_record_measures(const struct thud_intensity *m, const struct thud_record *record, const struct thud_pane *pane,
                         int y)
{
    char a[24], b[24], c[24];
    struct thud_look look = thud_look(THUD_ROLE_PLAIN, 0);
    thud_pane_print(pane, 1, y++, look, "PGA %s g  PGV %s m/s  PGD %s m",
                    thud_tui_number(m->pga_mps2 / THUD_GRAVITY, a), thud_tui_number(m->pgv_mps, b),
                    thud_tui_number(m->pgd_m, c));
    thud_pane_print(pane, 1, y++, look, "Arias %s m/s  D5-95 %s s", thud_tui_number(m->arias_mps, a),
                    thud_tui_number(m->d5_95_s, b));
    thud_pane_print(pane, 1, y++, look, "%zu samples, dt %g s, %s s %.20s", record->samples, record->dt_s,
                    thud_tui_number(m->duration_s, a), record->format);
    if (*record->event)
        thud_pane_print(pane, 1, y++, look, "%.60s %.30s", record->event, record->component);
    return y;
}
