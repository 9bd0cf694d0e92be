/* Amplification against one parameter: floor by floor, means over the floors, ratios to no pounding. */
#include <assert.h>
#include <stdio.h>

#include "plot/figures/figures_sweep_internal.h"

static void note_ratio(struct thud_figure *figure, const struct thud_sweep_table *table, enum thud_case which)
{
    char text[160], helps[THUD_SWEEP_TITLE];
    snprintf(text, sizeof text, "Ratio to %s at the same gap; below 1 the %s.",
             thud_case_title(table->measures, THUD_CASE_NONE), thud_sweep_helps(table, which, helps));
    thud_figure_note(figure, text);
}

/* Whether the links of a scene act without pounding: "no pounding, links act". */
static void note_free(struct thud_figure *figure, const struct thud_sweep_table *table)
{
    char text[96];
    snprintf(text, sizeof text, "Ratio to %s; above 1 pounding harms.",
             thud_case_free_words(table->measures, table->free_links));
    thud_figure_note(figure, text);
}

/* What a figure of ratios shows, for its title. */
const char *thud_sweep_amplification(const struct thud_sweep_table *table, enum thud_case which,
                                     char text[THUD_SWEEP_TITLE])
{
    if (which == THUD_CASE_NONE)
        snprintf(text, THUD_SWEEP_TITLE, "amplification by pounding %s", thud_case_phrase(table->measures, which));
    else if (which == THUD_CASE_AS_WRITTEN)
        snprintf(text, THUD_SWEEP_TITLE, "amplification against %s, scene as written",
                 thud_case_title(table->measures, THUD_CASE_NONE));
    else
        snprintf(text, THUD_SWEEP_TITLE, "amplification by the %s", thud_case_title(0, which));
    return text;
}

/* Panel p, by quantity and structure; of case none: to no pounding. NULL: the structure has no storeys that drift. */
static struct thud_panel *ratio_panel(struct thud_figure *figure, const struct thud_sweep_table *table, int p,
                                      int structure, enum thud_case which)
{
    char title[160], helps[THUD_SWEEP_TITLE];
    const int columns = figure ? figure->columns : 1;
    if (!thud_sweep_has_ratio(table, (enum thud_told)(p / columns), structure))
        return NULL;
    struct thud_panel *panel =
        thud_figure_panel(figure, p / columns, p % columns, thud_sweep_structure_title(table, structure, title));
    thud_sweep_axis_of(panel, THUD_X, table, 0);
    thud_panel_axis(panel, THUD_Y, thud_sweep_ratio_label[p / columns], "");
    if (which != THUD_CASE_NONE)
        thud_panel_mark(panel, THUD_Y, 0.0, 1.0, thud_sweep_helps(table, which, helps));
    thud_panel_mark(panel, THUD_Y, 1.0, 1.0, "");
    return panel;
}

struct thud_figure *thud_figure_by_floor(const struct thud_sweep_table *table, int record, enum thud_case which,
                                         const char *name, const char *title)
{
    int structure[THUD_SWEEP_COLUMNS_MAX], columns = thud_sweep_columns(table, structure);
    bool free = which == THUD_CASE_NONE;
    char text[512], head[160], amplified[THUD_SWEEP_TITLE];
    snprintf(text, sizeof text, "%s: %s, floor by floor", thud_sweep_record_name(table, record, head),
             thud_sweep_amplification(table, which, amplified));
    struct thud_figure *figure =
        thud_figure_create(name, title ? title : text, thud_sweep_ratio_rows(table), columns > 0 ? columns : 1);
    for (int p = 0; p < thud_sweep_ratio_rows(table) * columns; p++) {
        const int of = structure[p % columns], floors = thud_sweep_floors(table, of),
                  step = (floors + THUD_SWEEP_CURVES_MAX - 1) / THUD_SWEEP_CURVES_MAX;
        assert(floors > 0);
        struct thud_panel *panel = ratio_panel(figure, table, p, of, which);
        /* with more floors than curves every step-th from the top down, so that the top is there */
        int first = floors - (floors - 1) / step * step, curves = (floors - first) / step + 1;
        for (int i = 0; i < 2 * curves; i++) {
            int f = first + i % curves * step;
            struct thud_wanted wanted = {.record = record,
                                         .which = which,
                                         .told = (enum thud_told)(p / columns),
                                         .structure = of,
                                         .floor = f,
                                         .free = free};
            snprintf(text, sizeof text, "floor %d", f);
            if (i >= curves)
                thud_sweep_curve(panel, table, &wanted, text, f - 1);
            else if (table->motions == 0) /* bands over a suite are wide: of several floors none could be read */
                thud_sweep_shade(panel, table, &wanted, text, f - 1);
        }
        snprintf(text, sizeof text, "Every %d. floor of %d", step, floors);
        if (step > 1)
            thud_panel_note(panel, text);
    }
    thud_sweep_same_scale(figure, NULL);
    if (free)
        note_free(figure, table);
    else
        note_ratio(figure, table, which);
    thud_sweep_note_shades(figure, table, table->motions == 0);
    thud_sweep_note_rest(figure, table);
    return figure;
}

static struct thud_figure *means(const struct thud_sweep_table *table, enum thud_case which, const char *name,
                                 const char *title)
{
    int structure[THUD_SWEEP_COLUMNS_MAX], columns = thud_sweep_columns(table, structure);
    char text[384], head[160], amplified[THUD_SWEEP_TITLE];
    const bool one = table->nrecords == 1;
    if (one && table->motions == 0)
        snprintf(text, sizeof text, "%s: %s, means over the floors", thud_sweep_record_name(table, 0, head),
                 thud_sweep_amplification(table, which, amplified));
    else
        snprintf(text, sizeof text, "A%s, means over the floors",
                 thud_sweep_amplification(table, which, amplified) + 1);
    struct thud_figure *figure =
        thud_figure_create(name, title ? title : text, thud_sweep_ratio_rows(table), columns > 0 ? columns : 1);
    for (int p = 0; p < thud_sweep_ratio_rows(table) * columns; p++) {
        struct thud_panel *panel = ratio_panel(figure, table, p, structure[p % columns], which);
        struct thud_wanted wanted = {
            .which = which, .told = (enum thud_told)(p / columns), .structure = structure[p % columns]};
        for (int i = 0; i < 2 * table->nrecords; i++) {
            wanted.record = i % table->nrecords;
            (i < table->nrecords ? thud_sweep_shade : thud_sweep_curve)(
                panel, table, &wanted, thud_sweep_record_name(table, wanted.record, head),
                one ? thud_case_color(which) : wanted.record);
        }
    }
    note_ratio(figure, table, which);
    thud_sweep_note_shades(figure, table, true);
    thud_sweep_note_rest(figure, table);
    return figure;
}

struct thud_figure *thud_figure_of_means(const struct thud_sweep_table *table, enum thud_case which, const char *name,
                                         const char *title)
{
    struct thud_sweep_table *suite = NULL;
    if (table->nrecords > THUD_SWEEP_FIGURE_RECORDS) { /* what they say together */
        if (thud_sweep_suite_make(table, &suite, NULL) != THUD_OK)
            return NULL;
        table = suite;
    }
    struct thud_figure *figure = means(table, which, name, title), *other = NULL;
    enum thud_case twin = which != THUD_CASE_BUMPER                      ? THUD_CASE_BUMPER
                          : thud_sweep_has_case(table, THUD_CASE_CAVITY) ? THUD_CASE_CAVITY
                                                                         : THUD_CASE_LINK;
    if (which >= 0 && thud_sweep_has_case(table, twin) && !(other = means(table, twin, name, title)) && figure)
        figure->failed = true;
    thud_sweep_same_scale(figure, other);
    thud_figure_free(other);
    thud_sweep_suite_free(suite);
    return figure;
}

struct thud_figure *thud_figure_of_pounding(const struct thud_sweep_table *table, int record, const char *name)
{
    int structure[THUD_SWEEP_COLUMNS_MAX], columns = thud_sweep_columns(table, structure);
    char text[512], head[160];
    snprintf(text, sizeof text, "%s: means over the floors, ratio to no pounding",
             thud_sweep_record_name(table, record, head));
    struct thud_figure *figure =
        thud_figure_create(name, text, thud_sweep_ratio_rows(table), columns > 0 ? columns : 1);
    for (int p = 0; p < thud_sweep_ratio_rows(table) * columns; p++)
        thud_sweep_curves(ratio_panel(figure, table, p, structure[p % columns], THUD_CASE_NONE), table,
                          (struct thud_wanted){.record = record,
                                               .told = (enum thud_told)(p / columns),
                                               .structure = structure[p % columns],
                                               .free = true});
    thud_sweep_same_scale(figure, NULL);
    note_free(figure, table);
    if (table->motions > 0)
        thud_sweep_note_shades(figure, table, true);
    thud_sweep_note_rest(figure, table);
    return figure;
}
