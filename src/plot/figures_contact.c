/* Contact forces against time and against indentation, and the energy ledger. */
#include <math.h>
#include <stdio.h>

#include "plot/figures_run_internal.h"

static double peak_force(const struct thud_figure_source *source, int nsources, int contact)
{
    double peak = 0.0;
    for (int s = 0; s < nsources; s++)
        peak = fmax(peak, source[s].result->contact[contact].force.value);
    return peak;
}

enum { CONTACTS_MAX = 4000 };

/* The contacts worth a curve; the largest force in *peak. */
static int pick_contacts(const struct thud_figure_source *source, int nsources, int *index, double *peak)
{
    double force[CONTACTS_MAX];
    int n = source->result->ncontacts < CONTACTS_MAX ? source->result->ncontacts : CONTACTS_MAX;
    *peak = 0.0;
    for (int c = 0; c < n; c++) {
        force[c] = peak_force(source, nsources, c);
        *peak = fmax(*peak, force[c]);
    }
    return thud_pick_largest(force, n, nsources > 1 ? 1 : THUD_CURVES_MAX, index);
}

/* Says which contacts are shown where it is not all that touched. */
static void contact_note(struct thud_panel *panel, const struct thud_figure_source *source, int nsources, int n,
                         const int *index)
{
    char name[160], text[256];
    int touched = 0;
    for (int c = 0; c < source->result->ncontacts; c++)
        touched += peak_force(source, nsources, c) > 0.0;
    if (touched == 0)
        thud_panel_note(panel, "No contact");
    else if (nsources > 1) {
        thud_source_contact_name(source, index[0], name, sizeof name);
        snprintf(text, sizeof text, "Contact with the largest force: %s", name);
        thud_panel_note(panel, text);
    } else if (n < touched) {
        snprintf(text, sizeof text, "The %d of %d contacts with the largest forces", n, touched);
        thud_panel_note(panel, text);
    }
}

struct thud_figure *thud_figure_forces(const struct thud_figure_source *source, int nsources)
{
    int index[THUD_CURVES_MAX], n;
    double peak, from, to;
    char text[THUD_TEXT_MAX + 64];
    bool zoom = thud_source_zoom(source, nsources, &from, &to);
    n = pick_contacts(source, nsources, index, &peak);
    struct thud_shown shown = thud_shown_force(peak);
    snprintf(text, sizeof text, "%s: Impact force", source->scene->title);
    struct thud_figure *figure = thud_figure_create(thud_run_figure_name(THUD_FIGURE_FORCE), text, zoom ? 2 : 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "Whole run");
    thud_panel_axis(panel, THUD_X, "Time", "s");
    thud_panel_axis(panel, THUD_Y, "Impact force", shown.unit);
    for (int i = 0; i < n; i++) {
        for (int s = 0; s < nsources; s++) {
            thud_source_contact_name(source, index[i], text, sizeof text);
            thud_source_line(panel, &source[s], thud_history_force(source[s].history, index[i]), -1, shown.factor,
                             nsources > 1 ? source[s].name : text, nsources > 1 ? s : i);
        }
    }
    contact_note(panel, source, nsources, n, index);
    if (zoom)
        thud_panel_zoom(thud_figure_panel(figure, 1, 0, "Around the largest impact"), panel, from, to);
    thud_figure_shorten(figure);
    return figure;
}

/* Only while pressed together, with a break between impacts. */
static void loop_line(struct thud_panel *panel, const struct thud_figure_source *source, int contact, double factor,
                      const char *name, int color)
{
    const struct thud_history *h = source->history;
    int force = thud_history_force(h, contact), depth = thud_history_indentation(h, contact);
    struct thud_series *series =
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = color}, name, h->rows, NULL, NULL);
    if (!series)
        return;
    size_t n = 0;
    for (size_t i = 0; i < h->rows; i++) {
        const double *row = h->value + i * (size_t)h->columns;
        bool on = row[force] != 0.0;
        const double *next = row + h->columns;
        bool edge = !on && ((i + 1 < h->rows && next[force] != 0.0) || (n > 0 && isfinite(series->y[n - 1])));
        if (!on && !edge)
            continue;
        /* a row without force belongs to the loop only where it stands at its foot */
        bool foot = on || row[depth] >= 0.0;
        series->x[n] = foot ? 1e3 * row[depth] : NAN;
        series->y[n++] = foot ? factor * row[force] : NAN;
    }
    series->n = n;
}

struct thud_figure *thud_figure_loops(const struct thud_figure_source *source, int nsources)
{
    int index[THUD_CURVES_MAX], n;
    double peak;
    char text[THUD_TEXT_MAX + 64];
    n = pick_contacts(source, nsources, index, &peak);
    struct thud_shown shown = thud_shown_force(peak);
    snprintf(text, sizeof text, "%s: Force against indentation", source->scene->title);
    struct thud_figure *figure = thud_figure_create(thud_run_figure_name(THUD_FIGURE_LOOP), text, 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "Every impact of the run");
    thud_panel_axis(panel, THUD_X, "Indentation", "mm");
    thud_panel_limits(panel, THUD_X, 0.0, NAN);
    thud_panel_axis(panel, THUD_Y, "Impact force", shown.unit);
    for (int i = 0; i < n; i++) {
        for (int s = 0; s < nsources; s++) {
            thud_source_contact_name(source, index[i], text, sizeof text);
            loop_line(panel, &source[s], index[i], shown.factor, nsources > 1 ? source[s].name : text,
                      nsources > 1 ? s : i);
        }
    }
    contact_note(panel, source, nsources, n, index);
    return figure;
}

static double energy_peak(const struct thud_figure_source *source)
{
    const struct thud_history *h = source->history;
    double peak = 0.0;
    for (size_t i = 0; i < h->rows; i++) {
        for (int e = 0; e < THUD_HISTORY_ENERGIES; e++)
            peak = fmax(peak, fabs(h->value[i * (size_t)h->columns + (size_t)thud_history_energy(h, e)]));
    }
    return peak;
}

struct thud_figure *thud_figure_energies(const struct thud_figure_source *source, int nsources)
{
    static const char *const name[THUD_HISTORY_ENERGIES] = {"put in", "motion", "strain", "lost by damping",
                                                            "taken by contacts"};
    char text[THUD_TEXT_MAX + 64];
    int rows = nsources < THUD_ROWS_MAX ? nsources : THUD_ROWS_MAX;
    snprintf(text, sizeof text, "%s: Energy", source->scene->title);
    double peak = 0.0, from, to;
    bool zoom = thud_source_zoom(source, nsources, &from, &to);
    struct thud_figure *figure = thud_figure_create(thud_run_figure_name(THUD_FIGURE_ENERGY), text, rows, zoom ? 2 : 1);
    for (int s = 0; s < rows; s++)
        peak = fmax(peak, energy_peak(&source[s]));
    struct thud_shown shown = thud_shown_energy(peak);
    for (int s = 0; s < rows; s++) {
        struct thud_panel *panel = thud_figure_panel(figure, s, 0, nsources > 1 ? source[s].name : "");
        thud_panel_axis(panel, THUD_X, "Time", "s");
        thud_panel_axis(panel, THUD_Y, "Energy", shown.unit);
        for (int e = 0; e < THUD_HISTORY_ENERGIES; e++)
            thud_source_line(panel, &source[s], thud_history_energy(source[s].history, e), -1, shown.factor, name[e],
                             e);
        if (zoom)
            thud_panel_zoom(thud_figure_panel(figure, s, 1, "Around the largest impact"), panel, from, to);
    }
    thud_figure_shorten(figure);
    return figure;
}
