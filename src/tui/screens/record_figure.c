#include <math.h>
#include <stdio.h>

#include "app/run/record_verbs.h"
#include "base/quantity.h"
#include "ground/identity.h"
#include "plot/figures/figures_record.h"
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

/* With the structures' periods marked. */
static struct thud_figure *spectrum(const struct thud_doc *doc, const char *title)
{
    enum { POINTS = 200 }; /* as `thud record spectrum` */
    struct thud_spectrum_point point[POINTS];
    struct thud_period_mark mark[THUD_STRUCTURES_MAX];
    int marks = 0;
    if (thud_scene_periods(&doc->scene, mark, THUD_STRUCTURES_MAX, &marks, NULL) != THUD_OK)
        marks = 0;
    thud_spectrum_fill(doc->record, 0.05, 0.02, 10, POINTS, point);
    return thud_figure_of_spectrum(point, POINTS, 0.05, mark, marks, "spectrum", title);
}

struct thud_figure *thud_record_figure(const struct thud_doc *doc, enum thud_record_curve curve)
{
    char title[640];
    struct thud_figure *figure;
    thud_record_title(doc->record, title, sizeof title);
    if (curve == THUD_RECORD_SPECTRUM) {
        figure = spectrum(doc, title);
    } else if (curve == THUD_RECORD_ACCELERATION && doc->whole) {
        figure = thud_figure_create("used", title, 1, 1);
        parts(thud_figure_panel(figure, 0, 0, ""), doc);
    } else {
        figure = thud_figure_of_motion(doc->record, "motion", title);
    }
    if (thud_figure_check(figure, NULL) == THUD_OK)
        return figure;
    thud_figure_free(figure);
    return NULL;
}

const struct thud_panel *thud_record_panel(const struct thud_figure *figure, enum thud_record_curve curve)
{
    return &figure->panel[curve < THUD_RECORD_SPECTRUM && (int)curve < figure->rows ? (int)curve : 0];
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
