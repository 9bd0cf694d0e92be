/* What all figures of runs need of a run: units, titles, lines, the ground's strip, the closer look. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "plot/figures/figures_run_internal.h"
#include "study/scene/level.h"

struct thud_shown_unit thud_shown_force(double peak_n)
{
    return peak_n >= 1e6 ? (struct thud_shown_unit){1e-6, "MN"} : (struct thud_shown_unit){1e-3, "kN"};
}

struct thud_shown_unit thud_shown_energy(double peak_j)
{
    return peak_j >= 1e6 ? (struct thud_shown_unit){1e-6, "MJ"} : (struct thud_shown_unit){1e-3, "kJ"};
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

struct thud_series *thud_source_line(struct thud_panel *panel, const struct thud_figure_source *source, int column,
                                     int less, double factor, const char *name, int color)
{
    const struct thud_history *h = source->history;
    struct thud_style style = {.kind = THUD_LINES, .color = color};
    struct thud_series *series = thud_panel_add(panel, style, name, h->rows, h->time_s, NULL);
    for (size_t i = 0; series && i < h->rows; i++) {
        const double *row = h->value + i * (size_t)h->columns;
        series->y[i] = factor * (row[column] - (less < 0 ? 0.0 : row[less]));
    }
    return series;
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
    char name[24];
    const char *floor = thud_structure_level_name(c->left_floor ? left : right,
                                                  (c->left_floor ? c->left_floor : c->right_floor) - 1, false, name);
    bool level = c->struck == 0 && (c->left_floor == c->right_floor || !c->left_floor || !c->right_floor);
    if (level && source->result->nstructures <= 2)
        snprintf(text, size, "%s", floor);
    else if (level)
        snprintf(text, size, "%s–%s, %s", left->name, right->name, floor);
    else
        snprintf(text, size, "%s, %s %d – %s, %s %d", left->name, c->struck < 0 ? "columns" : "floor", c->left_floor,
                 right->name, c->struck > 0 ? "columns" : "floor", c->right_floor);
}

const char *thud_source_strip(const struct thud_figure_source *source, int nsources, const char *place, char text[256])
{
    snprintf(text, 256, nsources > 1 ? "%s: %s" : "%s", place, source->name);
    return text;
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

void thud_source_title(const struct thud_figure_source *source, int nsources, const char *what, char *text, size_t size)
{
    const struct thud_scene *scene = source->scene;
    const char *file = thud_path_name(scene->record.file), *dot = strrchr(file, '.');
    int length = dot && dot > file && strlen(dot) <= 5 ? (int)(dot - file) : (int)strlen(file);
    snprintf(text, size, "%s: %s", scene->title, what);
    if (*file)
        thud_append(text, size, "; %.*s", length, file);
    if (*file && isfinite(scene->record.peak_mps2))
        thud_append(text, size, " scaled to %.3g g", scene->record.peak_mps2 / THUD_GRAVITY);
    if (nsources == 1 && *source->name)
        thud_append(text, size, ", %s", source->name);
    if (scene->nstructures == 2)
        thud_append(text, size, ", gap %.4g cm", 100 * scene->interface[0].gap_m);
}

static void ground_strip(struct thud_panel *panel, const struct thud_figure_source *source)
{
    thud_panel_axis(panel, THUD_X, "Time", "s");
    thud_panel_axis(panel, THUD_Y, "Ground", "g");
    struct thud_series *line = thud_source_line(panel, source, thud_history_ground(source->history, 0), -1,
                                                1.0 / THUD_GRAVITY, "", THUD_COLORS - 1);
    if (line)
        line->style.thin = true;
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
    if (figure)
        thud_figure_share_scale(figure, THUD_Y, first_row * figure->columns, 1,
                                (figure->rows - first_row) * figure->columns, NULL);
}
