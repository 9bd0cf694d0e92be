/* Contact forces against time and against indentation, and the energy ledger. */
#include <math.h>
#include <stdio.h>

#include "plot/figures/figures_run_internal.h"

/* Largest force of a contact; of laws without force the largest impulse. */
static double peak_of(const struct thud_figure_source *source, int nsources, int contact, bool impulse)
{
    double peak = 0.0;
    for (int s = 0; s < nsources; s++) {
        const struct thud_contact_result *c = &source[s].result->contact[contact];
        if (!thud_contact_struck(c) && !impulse)
            peak = fmax(peak, c->force.value);
        for (int i = 0; thud_contact_struck(c) && impulse && i < source[s].nimpacts; i++)
            if (source[s].impact[i].contact == contact)
                peak = fmax(peak, source[s].impact[i].impulse_ns);
    }
    return peak;
}

enum { CONTACTS_MAX = 4000 };

/* The contacts worth a curve; the largest of all in *peak, and how many have any in *pounding. */
static int pick_contacts(const struct thud_figure_source *source, int nsources, bool impulse, int most, int *index,
                         double *peak, int *pounding)
{
    double own[CONTACTS_MAX];
    int n = source->result->ncontacts < CONTACTS_MAX ? source->result->ncontacts : CONTACTS_MAX;
    *peak = *pounding = 0;
    for (int c = 0; c < n; c++) {
        own[c] = peak_of(source, nsources, c, impulse);
        *peak = fmax(*peak, own[c]);
        *pounding += own[c] > 0.0;
    }
    return *peak > 0.0 ? thud_pick_largest(own, n, most, index) : 0;
}

/* Says which contacts are shown where it is not all with impacts. */
static void contact_note(struct thud_panel *panel, const struct thud_figure_source *source, int nsources, int n,
                         int pounding, const int *index)
{
    char name[160], text[256];
    if (pounding == 0)
        thud_panel_note(panel, "No contact");
    else if (nsources > 1) {
        thud_source_contact_name(source, index[0], name, sizeof name);
        snprintf(text, sizeof text, "Contact with the largest force: %s", name);
        thud_panel_note(panel, text);
    } else if (n < pounding) {
        snprintf(text, sizeof text, "The %d of %d contacts with the largest forces", n, pounding);
        thud_panel_note(panel, text);
    }
}

/* Every impact at its largest force, or at its impulse. */
static void impact_points(struct thud_panel *panel, const struct thud_figure_source *source, int contact, bool impulse,
                          double factor, int color)
{
    struct thud_style style = {.kind = THUD_POINTS, .color = color};
    struct thud_series *series = thud_panel_add(panel, style, "", (size_t)source->nimpacts, NULL, NULL);
    size_t n = 0;
    for (int i = 0; series && i < source->nimpacts; i++)
        if (source->impact[i].contact == contact && (impulse || source->impact[i].force_n > 0.0)) {
            series->x[n] = source->impact[i].start_s + 0.5 * source->impact[i].duration_s;
            series->y[n++] = factor * (impulse ? source->impact[i].impulse_ns : source->impact[i].force_n);
        }
    if (series)
        series->n = n;
}

/* How many contacts have strips: a few, high enough to be read. */
static int most_contacts(int nsources)
{
    const int places = (thud_source_places(nsources) + 1) / 2;
    return places < THUD_CURVES_MAX ? places : THUD_CURVES_MAX;
}

/* What a strip shows of a contact. */
enum told { FORCE, FORCES, IMPULSES };

static struct thud_panel *contact_strip(struct thud_figure *figure, int row, const struct thud_figure_source *source,
                                        int nsources, int contact, enum told told, struct thud_shown_unit shown)
{
    const int color = thud_source_color(source, nsources);
    char name[160], text[256];
    thud_source_contact_name(source, contact, name, sizeof name);
    struct thud_panel *panel = thud_figure_panel(figure, row, 0, thud_source_strip(source, nsources, name, text));
    thud_panel_axis(panel, THUD_X, "Time", "s");
    thud_panel_axis(panel, THUD_Y, told == IMPULSES ? "Impulse" : thud_run_words[THUD_FIGURE_FORCE].label, shown.unit);
    if (told == FORCE)
        thud_source_line(panel, source, thud_history_force(source->history, contact), -1, shown.factor, "", color);
    else
        impact_points(panel, source, contact, told == IMPULSES, shown.factor, color);
    return panel;
}

/* One time axis for all rows: the run's, or up to the last impact where much of the run is left then. */
static void until_last_impact(struct thud_figure *figure, const struct thud_figure_source *source, int nsources,
                              int rows)
{
    double last = 0.0, end = source->result->end_s;
    char text[128];
    for (int s = 0; s < nsources; s++)
        for (int i = 0; i < source[s].nimpacts; i++)
            last = fmax(last, source[s].impact[i].start_s + source[s].impact[i].duration_s);
    double step = last > 20.0 ? 5.0 : last > 2.0 ? 1.0 : 0.1, until = step * ceil(1.05 * last / step);
    bool shorter = until <= 0.75 * end;
    for (int r = 0; figure && r < rows; r++)
        thud_panel_limits(&figure->panel[r], THUD_X, 0.0, shorter ? until : end);
    snprintf(text, sizeof text, "After %.4g s of %.4g s there is no contact.", until, end);
    if (shorter)
        thud_figure_note(figure, text);
}

enum { IMPACTS_MANY = 100 };

/* A strip for each contact and case, the highest first; where impacts are hundreds, each is a point on a log axis.
 * Where no contact has a force, every impulse is a point. */
struct thud_figure *thud_figure_forces(enum thud_run_figure which, const struct thud_figure_source *source,
                                       int nsources)
{
    int index[THUD_CURVES_MAX], pounding, most = 0;
    double peak, from, to;
    char text[3 * THUD_TEXT_MAX], what[64];
    if (nsources > 1 && source->which == THUD_CASE_FREE) { /* without contacts */
        source++;
        nsources--;
    }
    const bool ground = thud_source_ground(source), zoom = thud_source_zoom(source, nsources, &from, &to);
    enum told told = FORCE;
    int n = pick_contacts(source, nsources, false, most_contacts(nsources), index, &peak, &pounding);
    struct thud_shown_unit shown = thud_shown_force(peak);
    for (int s = 0; s < nsources; s++)
        most = source[s].nimpacts > most ? source[s].nimpacts : most;
    if (n == 0 && (n = pick_contacts(source, nsources, true, most_contacts(nsources), index, &peak, &pounding)) > 0) {
        told = IMPULSES;
        shown = (struct thud_shown_unit){1e-3, "kN s"};
    } else if (most > IMPACTS_MANY)
        told = FORCES;
    snprintf(what, sizeof what, "%s (%s)",
             told == IMPULSES ? "impulse of every impact"
             : told == FORCES ? "largest force of every impact"
                              : thud_run_words[THUD_FIGURE_FORCE].title,
             shown.unit);
    thud_source_title(source, nsources, what, text, sizeof text);
    const bool closer = zoom && told == FORCE;
    struct thud_figure *figure =
        thud_figure_create(thud_run_figure_name(which), text, (n > 0 ? n * nsources : 1) + ground, closer ? 2 : 1);
    if (ground)
        thud_figure_ground(figure, source, from, to);
    if (n == 0)
        thud_figure_panel(figure, ground, 0, "no contact");
    for (int i = 0; i < n * nsources; i++) {
        struct thud_panel *panel = contact_strip(figure, i + ground, &source[i % nsources], nsources,
                                                 index[n - 1 - i / nsources], told, shown);
        if (told == FORCES)
            thud_panel_log(panel, THUD_Y);
        if (told == IMPULSES)
            thud_panel_limits(panel, THUD_Y, 0.0, NAN);
        if (closer)
            thud_panel_zoom(thud_figure_panel(figure, i + ground, 1, panel ? panel->title : ""), panel, from, to);
    }
    if (n > 0)
        thud_figure_same_height(figure, ground);
    thud_figure_strips(figure);
    if (told == FORCES)
        until_last_impact(figure, source, nsources, figure ? figure->rows : 0);
    else
        thud_figure_shorten(figure);
    snprintf(text, sizeof text, "The %d of %d contacts with the largest %s; histories.csv has all.", n, pounding,
             told == IMPULSES ? "impulses" : "forces");
    if (n < pounding)
        thud_figure_note(figure, text);
    if (told == IMPULSES)
        thud_figure_note(figure, "A law without force: an impulse lasts no time, and has no largest force.");
    return figure;
}

/* Only while pressed together, with a break between impacts. */
void thud_source_loop(struct thud_panel *panel, const struct thud_figure_source *source, int contact, double factor,
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

double thud_source_force(const struct thud_figure_source *source, int nsources)
{
    double peak = 0.0;
    for (int s = 0; s < nsources; s++)
        for (int c = 0; c < source[s].result->ncontacts; c++)
            peak = fmax(peak, peak_of(&source[s], 1, c, false));
    return peak;
}

void thud_loop_axes(struct thud_panel *panel, const char *unit)
{
    thud_panel_axis(panel, THUD_X, "Indentation", "mm");
    thud_panel_results_on_x(panel);
    thud_panel_limits(panel, THUD_X, 0.0, NAN);
    thud_panel_axis(panel, THUD_Y, thud_run_words[THUD_FIGURE_LOOP].label, unit);
}

/* Colours of curves that cross: of two that follow each other one is dark, one light, also in grey. */
static const int apart[] = {0, 1, 4, 5, 6, 7, 9};
_Static_assert(sizeof apart / sizeof *apart >= THUD_CURVES_MAX, "a colour for each curve");

struct thud_figure *thud_figure_loops(enum thud_run_figure which, const struct thud_figure_source *source, int nsources)
{
    int index[THUD_CURVES_MAX], pounding;
    double peak;
    char text[3 * THUD_TEXT_MAX];
    int n = pick_contacts(source, nsources, false, nsources > 1 ? 1 : THUD_CURVES_MAX, index, &peak, &pounding);
    struct thud_shown_unit shown = thud_shown_force(peak);
    thud_source_title(source, nsources, thud_run_words[which].title, text, sizeof text);
    struct thud_figure *figure = thud_figure_create(thud_run_figure_name(which), text, 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "Every impact of the run");
    thud_loop_axes(panel, shown.unit);
    for (int i = 0; i < n; i++) {
        for (int s = 0; s < nsources; s++) {
            thud_source_contact_name(source, index[i], text, sizeof text);
            thud_source_loop(panel, &source[s], index[i], shown.factor, nsources > 1 ? source[s].name : text,
                             nsources > 1 ? thud_case_color(source[s].which) : apart[i]);
        }
    }
    contact_note(panel, source, nsources, n, pounding, index);
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

struct thud_figure *thud_figure_energies(enum thud_run_figure which, const struct thud_figure_source *source,
                                         int nsources)
{
    static const char *const name[THUD_HISTORY_ENERGIES] = {"input", "kinetic", "strain", "damping", "contact"};
    char text[3 * THUD_TEXT_MAX];
    int rows = nsources < THUD_ROWS_MAX ? nsources : THUD_ROWS_MAX;
    thud_source_title(source, nsources, "energy", text, sizeof text);
    double peak = 0.0, from, to;
    bool zoom = thud_source_zoom(source, nsources, &from, &to);
    struct thud_figure *figure = thud_figure_create(thud_run_figure_name(which), text, rows, zoom ? 2 : 1);
    for (int s = 0; s < rows; s++)
        peak = fmax(peak, energy_peak(&source[s]));
    struct thud_shown_unit shown = thud_shown_energy(peak);
    for (int s = 0; s < rows; s++) {
        struct thud_panel *panel = thud_figure_panel(figure, s, 0, nsources > 1 ? source[s].name : "");
        thud_panel_axis(panel, THUD_X, "Time", "s");
        thud_panel_axis(panel, THUD_Y, "Energy", shown.unit);
        for (int e = 0; e < THUD_HISTORY_ENERGIES; e++)
            thud_source_line(panel, &source[s], thud_history_energy(source[s].history, e), -1, shown.factor, name[e],
                             apart[e]);
        if (source[s].history->loses)
            thud_source_line(panel, &source[s], thud_history_hysteretic(source[s].history, 0), -1, shown.factor,
                             source[s].history->nstoreys > 0 ? "yielding" : "friction", apart[THUD_HISTORY_ENERGIES]);
        if (zoom)
            thud_panel_zoom(thud_figure_panel(figure, s, 1, "Around the largest impact"), panel, from, to);
    }
    if (figure)
        thud_figure_share_scale(figure, THUD_Y, 0, 1, figure->rows * figure->columns, NULL);
    thud_figure_shorten(figure);
    return figure;
}
