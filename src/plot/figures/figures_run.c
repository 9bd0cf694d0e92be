#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "plot/figures/figures_run_internal.h"

/* ---- what all figures of runs need ---- */

struct thud_shown thud_shown_force(double peak_n)
{
    return peak_n >= 1e6 ? (struct thud_shown){1e-6, "MN"} : (struct thud_shown){1e-3, "kN"};
}

struct thud_shown thud_shown_energy(double peak_j)
{
    return peak_j >= 1e6 ? (struct thud_shown){1e-6, "MJ"} : (struct thud_shown){1e-3, "kJ"};
}

/* First dof of a structure. */
static int first_dof(const struct thud_figure_source *source, int structure)
{
    int dof = 0;
    for (int i = 0; i < structure; i++)
        dof += source->result->structure[i].floors;
    return dof;
}

bool thud_source_zoom(const struct thud_figure_source *source, int nsources, double *from_s, double *to_s)
{
    const struct thud_impact *largest = NULL;
    double end = 0.0;
    for (int s = 0; s < nsources; s++) {
        end = fmax(end, source[s].result->end_s);
        for (int i = 0; i < source[s].nimpacts; i++) {
            if (!largest || source[s].impact[i].force_n > largest->force_n)
                largest = &source[s].impact[i];
        }
    }
    if (!largest)
        return false;
    double room = fmax(0.1, 2.0 * largest->duration_s);
    *from_s = fmax(0.0, largest->start_s - room);
    *to_s = fmin(end, largest->start_s + largest->duration_s + room);
    double step = 0.02; /* round limits read better */
    *from_s = step * floor(*from_s / step + 1e-9);
    *to_s = step * ceil(*to_s / step - 1e-9);
    return *to_s - *from_s < 0.9 * end;
}

void thud_source_line(struct thud_panel *panel, const struct thud_figure_source *source, int column, int less,
                      double factor, const char *name, int color)
{
    const struct thud_history *h = source->history;
    struct thud_style style = {.kind = THUD_LINES, .color = color};
    struct thud_series *series = thud_panel_add(panel, style, name, h->rows, h->time_s, NULL);
    if (!series)
        return;
    for (size_t i = 0; i < h->rows; i++) {
        const double *row = h->value + i * (size_t)h->columns;
        series->y[i] = factor * (row[column] - (less < 0 ? 0.0 : row[less]));
    }
}

/* Last time at which anything differs from where it ends by more than a share of the peak. */
static double last_change(const struct thud_panel *panel, double share)
{
    double peak = 0.0, last = 0.0;
    for (int i = 0; i < panel->nseries; i++) {
        for (size_t k = 0; k < panel->series[i]->n; k++)
            peak = fmax(peak, fabs(panel->series[i]->y[k]));
    }
    for (int i = 0; i < panel->nseries; i++) {
        const struct thud_series *series = panel->series[i];
        size_t k = series->n;
        double ends = k > 0 ? series->y[k - 1] : 0.0;
        while (k > 0 && !(fabs(series->y[k - 1] - ends) > share * peak))
            k--;
        last = fmax(last, k > 0 ? series->x[k - 1] : 0.0);
    }
    return last;
}

void thud_figure_shorten(struct thud_figure *figure)
{
    double last = 0.0, end = 0.0;
    char text[128];
    if (thud_figure_check(figure, NULL) != THUD_OK)
        return;
    int panels = figure->rows * figure->columns;
    for (int p = 0; p < panels; p++) {
        if (figure->panel[p].used && !figure->panel[p].closer) {
            last = fmax(last, last_change(&figure->panel[p], 0.05));
            for (int i = 0; i < figure->panel[p].nseries; i++) {
                const struct thud_series *series = figure->panel[p].series[i];
                end = fmax(end, series->n > 0 ? series->x[series->n - 1] : 0.0);
            }
        }
    }
    double step = last > 20.0 ? 5.0 : last > 2.0 ? 1.0 : 0.1, until = step * ceil(1.1 * last / step);
    if (!(until > 0.0) || until > 0.75 * end)
        return;
    for (int p = 0; p < panels; p++) {
        if (figure->panel[p].used && !figure->panel[p].closer)
            thud_panel_limits(&figure->panel[p], THUD_X, 0.0, until);
    }
    snprintf(text, sizeof text, "After %g s of %.4g s nothing changes by more than 5 %% of the peaks.", until, end);
    thud_figure_note(figure, text);
}

void thud_source_contact_name(const struct thud_figure_source *source, int contact, char *text, size_t size)
{
    const struct thud_contact_result *c = &source->result->contact[contact];
    const struct thud_structure *left = &source->scene->structure[c->interface - 1], *right = left + 1;
    int floor = c->left_floor ? c->left_floor : c->right_floor;
    bool level = c->struck == 0 && (c->left_floor == c->right_floor || !c->left_floor || !c->right_floor);
    if (level && source->result->nstructures <= 2)
        snprintf(text, size, "floor %d", floor);
    else if (level)
        snprintf(text, size, "%s–%s, floor %d", left->name, right->name, floor);
    else
        snprintf(text, size, "%s %s%d–%s %s%d", left->name, c->struck < 0 ? "c" : "", c->left_floor, right->name,
                 c->struck > 0 ? "c" : "", c->right_floor);
}

int thud_pick_largest(const double *value, int n, int most, int *index)
{
    int picked = 0;
    for (int i = 0; i < n && picked < most; i++) {
        int larger = 0; /* how many go first */
        for (int j = 0; j < n; j++)
            larger += value[j] > value[i] || (j < i && value[j] == value[i]);
        if (larger < most && (value[i] > 0.0 || larger == 0))
            index[picked++] = i;
    }
    return picked;
}

/* ---- histories of the floors ---- */

static const struct quantity {
    const char *label, *title, *unit;
    double factor;
} quantities[THUD_RUN_FIGURES] = {
    [THUD_FIGURE_VELOCITY] = {"Velocity to the ground", "floor velocity relative to the ground", "m/s", 1.0},
    [THUD_FIGURE_ACCELERATION] = {"Total acceleration", "total floor acceleration", "m/s²", 1.0},
    [THUD_FIGURE_DISPLACEMENT] = {"Displacement to the ground", "floor displacement relative to the ground", "cm",
                                  100.0},
    [THUD_FIGURE_DRIFT] = {"Interstorey deflection", "interstorey deflection", "mm", 1000.0},
};

static double floor_peak(const struct thud_figure_source *source, int structure, int floor, enum thud_run_figure which)
{
    const struct thud_floor_result *f = &source->result->structure[structure].floor[floor];
    return which == THUD_FIGURE_VELOCITY       ? f->velocity.value
           : which == THUD_FIGURE_ACCELERATION ? f->acceleration.value
           : which == THUD_FIGURE_DISPLACEMENT ? f->displacement.value
                                               : f->drift.value;
}

static void floor_line(struct thud_panel *panel, const struct thud_figure_source *source, int structure, int floor,
                       enum thud_run_figure which, const char *name, int color)
{
    const struct thud_history *h = source->history;
    int dof = first_dof(source, structure) + floor, column = thud_history_displacement(h, dof), less = -1;
    if (which == THUD_FIGURE_VELOCITY)
        column = thud_history_velocity(h, dof);
    else if (which == THUD_FIGURE_ACCELERATION)
        column = thud_history_acceleration(h, dof);
    else if (which == THUD_FIGURE_DRIFT && floor > 0)
        less = thud_history_displacement(h, dof - 1);
    thud_source_line(panel, source, column, less, quantities[which].factor, name, color);
}

/* Structures with something to show: those that have floors, and for the deflections more than a rigid body's one. */
static bool shown(const struct thud_figure_source *source, int structure, enum thud_run_figure which)
{
    enum thud_structure_kind kind = source->scene->structure[structure].kind;
    return source->result->structure[structure].floors > 0 && !(which == THUD_FIGURE_DRIFT && kind == THUD_RIGID);
}

/* A floor of a structure, both from 0. */
struct place {
    int structure, floor;
};

enum { STRIPS_MAX = 12 };

/* The floors that have a strip: all, or of each structure those with the largest peaks; the top of the first structure
 * first. */
static int pick_floors(const struct thud_figure_source *source, int nsources, enum thud_run_figure which,
                       struct place *place, bool *all)
{
    int nshown = 0, total = 0, n = 0;
    for (int i = 0; i < source->result->nstructures; i++) {
        nshown += shown(source, i, which);
        total += shown(source, i, which) ? source->result->structure[i].floors : 0;
    }
    *all = total <= STRIPS_MAX;
    int each = *all ? total : nshown > 0 && STRIPS_MAX > nshown ? STRIPS_MAX / nshown : 1;
    for (int i = 0; i < source->result->nstructures; i++) {
        int floors = source->result->structure[i].floors, index[THUD_STOREYS_MAX + 1];
        double peak[THUD_STOREYS_MAX + 1] = {0.0};
        if (!shown(source, i, which))
            continue;
        for (int f = 0; f < floors; f++)
            for (int s = 0; s < nsources; s++)
                peak[f] = fmax(peak[f], floor_peak(&source[s], i, f, which));
        int count = *all ? floors : thud_pick_largest(peak, floors, each, index);
        for (int k = count - 1; k >= 0 && n < STRIPS_MAX; k--)
            place[n++] = (struct place){i, *all ? k : index[k]};
    }
    return n;
}

void thud_source_title(const struct thud_figure_source *source, int nsources, const char *what, char *text, size_t size)
{
    const struct thud_scene *scene = source->scene;
    const char *file = thud_path_name(scene->record.file), *dot = strrchr(file, '.');
    int length = dot && dot > file && strlen(dot) <= 5 ? (int)(dot - file) : (int)strlen(file);
    int n = snprintf(text, size, "%s: %s", scene->title, what);
    if (*file && n > 0 && (size_t)n < size)
        n += snprintf(text + n, size - (size_t)n, "; %.*s", length, file);
    if (*file && isfinite(scene->record.peak_mps2) && n > 0 && (size_t)n < size)
        n += snprintf(text + n, size - (size_t)n, " scaled to %.3g g", scene->record.peak_mps2 / THUD_GRAVITY);
    if (nsources == 1 && *source->name && n > 0 && (size_t)n < size)
        n += snprintf(text + n, size - (size_t)n, ", %s", source->name);
    if (scene->nstructures == 2 && n > 0 && (size_t)n < size)
        snprintf(text + n, size - (size_t)n, ", gap %.4g cm", 100 * scene->interface[0].gap_m);
}

static void ground_strip(struct thud_panel *panel, const struct thud_figure_source *source)
{
    thud_panel_axis(panel, THUD_X, "Time", "s");
    thud_panel_axis(panel, THUD_Y, "Ground", "g");
    thud_source_line(panel, source, thud_history_ground(), -1, 1.0 / THUD_GRAVITY, "", THUD_COLOR_GREY);
}

bool thud_source_ground(const struct thud_figure_source *source)
{
    return source->scene->record.file[0] != '\0';
}

void thud_figure_ground(struct thud_figure *figure, const struct thud_figure_source *source, double from, double to)
{
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "ground acceleration (g)");
    ground_strip(panel, source);
    if (figure && figure->columns > 1)
        thud_panel_zoom(thud_figure_panel(figure, 0, 1, ""), panel, from, to);
}

void thud_figure_same_height(struct thud_figure *figure, int first_row)
{
    double least = INFINITY, most = -INFINITY;
    for (int r = first_row; figure && r < figure->rows; r++) {
        struct thud_range range = thud_panel_range(&figure->panel[r * figure->columns], THUD_Y);
        least = fmin(least, range.least);
        most = fmax(most, range.most);
    }
    for (int i = first_row * (figure ? figure->columns : 0); figure && i < figure->rows * figure->columns; i++)
        thud_panel_limits(&figure->panel[i], THUD_Y, least, most);
}

static struct thud_figure *histories(enum thud_run_figure which, const struct thud_figure_source *source, int nsources)
{
    struct place place[STRIPS_MAX];
    bool all, ground = thud_source_ground(source);
    double from, to;
    char title[3 * THUD_TEXT_MAX], what[128];
    bool zoom = thud_source_zoom(source, nsources, &from, &to);
    int n = pick_floors(source, nsources, which, place, &all), rows = n + ground;
    snprintf(what, sizeof what, "%s (%s)", quantities[which].title, quantities[which].unit);
    thud_source_title(source, nsources, what, title, sizeof title);
    struct thud_figure *figure =
        thud_figure_create(thud_run_figure_name(which), title, rows > 0 ? rows : 1, zoom ? 2 : 1);
    if (ground)
        thud_figure_ground(figure, source, from, to);
    for (int i = 0; i < n; i++) {
        const struct thud_structure *structure = &source->scene->structure[place[i].structure];
        bool one = source->result->structure[place[i].structure].floors == 1;
        char name[128];
        if (one)
            snprintf(name, sizeof name, "%s", structure->name);
        else if (structure->kind == THUD_ISOLATED && place[i].floor == 0)
            snprintf(name, sizeof name, "%s, base slab", structure->name);
        else
            snprintf(name, sizeof name, "%s, %s %d", structure->name, which == THUD_FIGURE_DRIFT ? "storey" : "floor",
                     place[i].floor + 1);
        struct thud_panel *panel = thud_figure_panel(figure, i + ground, 0, name);
        thud_panel_axis(panel, THUD_X, "Time", "s");
        thud_panel_axis(panel, THUD_Y, quantities[which].label, quantities[which].unit);
        for (int s = 0; s < nsources; s++)
            floor_line(panel, &source[s], place[i].structure, place[i].floor, which, nsources > 1 ? source[s].name : "",
                       s);
        if (zoom)
            thud_panel_zoom(thud_figure_panel(figure, i + ground, 1, name), panel, from, to);
    }
    thud_figure_same_height(figure, ground);
    thud_figure_strips(figure);
    thud_figure_shorten(figure);
    if (!all)
        thud_figure_note(figure, "Of each structure the floors with the largest peaks; histories.csv has all.");
    return figure;
}

/* ---- the list ---- */

const char *thud_run_figure_name(enum thud_run_figure which)
{
    static const char *const name[THUD_RUN_FIGURES] = {"force",      "velocity",  "acceleration", "displacement",
                                                       "drift",      "loop",      "envelope",     "energy",
                                                       "hysteresis", "permanent", "columns"};
    return name[which];
}

bool thud_run_figure_has(enum thud_run_figure which, const struct thud_figure_source *source, int nsources)
{
    bool any = false, touched = false;
    for (int i = 0; i < source->result->nstructures; i++) {
        bool storeys = source->scene->structure[i].kind != THUD_RIGID;
        any = any || (shown(source, i, which) && (which != THUD_FIGURE_ENVELOPE || storeys));
    }
    for (int s = 0; s < nsources; s++) {
        if (source[s].history->rows == 0)
            return false;
        touched = touched || source[s].nimpacts > 0;
    }
    if (which == THUD_FIGURE_LOOP)
        return touched;
    if (which == THUD_FIGURE_HYSTERESIS || which == THUD_FIGURE_PERMANENT)
        return thud_source_yields(source);
    if (which == THUD_FIGURE_COLUMNS)
        return source->result->ncolumns > 0;
    return which == THUD_FIGURE_FORCE ? source->result->ncontacts > 0 : any;
}

struct thud_figure *thud_run_figure(enum thud_run_figure which, const struct thud_figure_source *source, int nsources)
{
    switch (which) {
    case THUD_FIGURE_FORCE:
        return thud_figure_forces(source, nsources);
    case THUD_FIGURE_LOOP:
        return thud_figure_loops(source, nsources);
    case THUD_FIGURE_ENVELOPE:
        return thud_figure_envelopes(source, nsources);
    case THUD_FIGURE_ENERGY:
        return thud_figure_energies(source, nsources);
    case THUD_FIGURE_HYSTERESIS:
        return thud_figure_hysteresis(source, nsources);
    case THUD_FIGURE_PERMANENT:
        return thud_figure_permanent(source, nsources);
    case THUD_FIGURE_COLUMNS:
        return thud_figure_columns(source, nsources);
    default:
        return histories(which, source, nsources);
    }
}
