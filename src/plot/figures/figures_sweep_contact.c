/* Contacts, storeys that yield and columns that slabs strike, against one parameter. */
#include <math.h>
#include <stdio.h>

#include "plot/figures/figures_run.h"
#include "plot/figures/figures_sweep_internal.h"

/* From 0; impacts on a log axis where they are hundreds. */
static void contact_scale(struct thud_panel *panel, bool counts)
{
    double least = INFINITY, most = 0;
    for (int i = 0; panel && i < panel->nseries; i++)
        for (size_t k = 0; k < panel->series[i]->n; k++) {
            double y = panel->series[i]->y[k];
            if (y > 0) {
                least = fmin(least, y);
                most = fmax(most, y);
            }
        }
    if (counts && most >= 200 && most > 100 * least)
        thud_panel_log(panel, THUD_Y);
    else
        thud_panel_limits(panel, THUD_Y, 0.0, NAN);
}

struct thud_figure *thud_figure_of_contacts(const struct thud_sweep_table *table, int record, const char *name)
{
    char text[512], head[160];
    const bool suite = table->motions > 0;
    snprintf(text, sizeof text, "%s: largest impact force and %s", thud_sweep_record_name(table, record, head),
             suite ? "how many pound" : "number of impacts");
    struct thud_figure *figure = thud_figure_create(name, text, 1, 2);
    struct thud_panel *force = thud_figure_panel(figure, 0, 0, "Largest impact force"),
                      *many = thud_figure_panel(figure, 0, 1,
                                                suite ? "Ground motions that pound" : "All impacts of the run");
    struct thud_wanted wanted = {.record = record, .told = THUD_TOLD_FORCE};
    thud_sweep_axis_of(force, THUD_X, table, 0);
    thud_sweep_axis_of(many, THUD_X, table, 0);
    thud_panel_axis(force, THUD_Y, "Force", "MN");
    thud_sweep_curves(force, table, wanted);
    contact_scale(force, false);
    wanted.told = suite ? THUD_TOLD_POUNDING : THUD_TOLD_IMPACTS;
    thud_sweep_curves(many, table, wanted);
    if (suite) {
        wanted.told = THUD_TOLD_WORSE;
        thud_sweep_curves(many, table, wanted);
        thud_panel_share_axis(many, THUD_Y, "Share");
    } else {
        thud_panel_axis(many, THUD_Y, "Impacts", "");
        contact_scale(many, true);
    }
    if (suite) {
        thud_sweep_note_shades(figure, table, true);
        char worse[160];
        snprintf(worse, sizeof worse,
                 "Worse: a structure's mean acceleration is larger than %s. Bars: 90 %% bands of the shares (Wilson).",
                 thud_case_phrase(table->measures, THUD_CASE_NONE));
        thud_figure_note(figure, worse);
    }
    thud_sweep_note_rest(figure, table);
    return figure;
}

struct thud_figure *thud_figure_of_yielding(const struct thud_sweep_table *table, int record, const char *name)
{
    static const char *const label[] = {"Ductility", "Permanent drift"};
    int structure[THUD_SWEEP_COLUMNS_MAX], columns = thud_sweep_columns(table, structure), n = 0;
    char text[512], head[160];
    for (int c = 0; c < columns; c++)
        if (thud_sweep_is_told(table, THUD_TOLD_DUCTILITY, structure[c]))
            structure[n++] = structure[c];
    snprintf(text, sizeof text, "%s: storeys that yield, the largest of each building",
             thud_sweep_record_name(table, record, head));
    struct thud_figure *figure = thud_figure_create(name, text, 2, n > 0 ? n : 1);
    for (int c = 0; c < n; c++)
        for (int row = 0; row < 2; row++) {
            struct thud_panel *panel =
                thud_figure_panel(figure, row, c, thud_sweep_structure_title(table, structure[c], head));
            thud_sweep_axis_of(panel, THUD_X, table, 0);
            thud_panel_axis(panel, THUD_Y, label[row], row == 0 ? "" : "mm");
            thud_sweep_curves(panel, table,
                              (struct thud_wanted){.record = record,
                                                   .told = row == 0 ? THUD_TOLD_DUCTILITY : THUD_TOLD_PERMANENT,
                                                   .structure = structure[c]});
            contact_scale(panel, false);
            if (row == 0)
                thud_panel_mark(panel, THUD_Y, 1.0, 1.0, "");
        }
    thud_sweep_same_scale(figure, NULL);
    thud_figure_note(figure, thud_ductility_note);
    if (table->motions > 0)
        thud_sweep_note_shades(figure, table, true);
    thud_sweep_note_rest(figure, table);
    return figure;
}

struct thud_figure *thud_figure_of_struck_columns(const struct thud_sweep_table *table, int record, const char *name)
{
    const bool capacity = thud_sweep_is_told(table, THUD_TOLD_CAPACITY, 0);
    char text[512], head[160];
    snprintf(text, sizeof text, "%s: columns that slabs strike", thud_sweep_record_name(table, record, head));
    struct thud_figure *figure = thud_figure_create(name, text, 1, capacity ? 2 : 1);
    for (int i = 0; i < 1 + capacity; i++) {
        struct thud_panel *panel =
            thud_figure_panel(figure, 0, i, i == 0 ? "Largest shear" : "Largest shear over capacity");
        thud_sweep_axis_of(panel, THUD_X, table, 0);
        thud_panel_axis(panel, THUD_Y, i == 0 ? "Shear" : "Shear over capacity", i == 0 ? "MN" : "");
        thud_sweep_curves(
            panel, table,
            (struct thud_wanted){.record = record, .told = i == 0 ? THUD_TOLD_SHEAR : THUD_TOLD_CAPACITY});
        contact_scale(panel, false);
        if (i == 1)
            thud_panel_mark(panel, THUD_Y, 1.0, 1.0, "capacity");
    }
    if (table->motions > 0)
        thud_sweep_note_shades(figure, table, true);
    thud_sweep_note_rest(figure, table);
    return figure;
}
