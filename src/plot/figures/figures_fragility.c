#include "plot/figures/figures_fragility.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plot/figures/figures_case.h"
#include "plot/figures/figures_sweep.h"
#include "plot/figures/figures_sweep_internal.h"

enum { FINE = 120, PANELS_MAX = THUD_VARY_MAX, COLUMNS_MAX = 4 };

/* The fraction of the motions that pound at each value or above (below), as steps. */
static void add_steps(struct thud_panel *panel, const struct thud_sweep_axis *axis, const struct thud_fragility *f,
                      const char *name, int color)
{
    bool rising = thud_axis_is_intensity(axis);
    double unit = thud_varied_factor(axis), *x = malloc(2 * ((size_t)f->nexact + 2) * sizeof *x);
    double *y = x ? x + f->nexact + 2 : NULL;
    size_t n = 1, before = 0;
    if (!x) {
        if (panel)
            panel->figure->failed = true;
        return;
    }
    for (int r = 0; r < f->nexact; r++) {
        before += f->exact[r] <= f->least;
        if (f->exact[r] <= f->least || f->exact[r] >= f->most)
            continue;
        x[n] = f->exact[r] * unit;
        y[n++] = 100.0 * (rising ? r + 1 : f->nexact - r - 1) / f->nexact;
    }
    x[0] = f->least * unit;
    y[0] = 100.0 * (rising ? (double)before : f->nexact - (double)before) / f->nexact;
    x[n] = f->most * unit;
    y[n] = y[n - 1];
    thud_panel_add(panel, (struct thud_style){.kind = THUD_STEPS, .color = color}, name, n + 1, x, y);
    free(x);
}

/* As written it has all that the scene has. */
static const char *case_title(const struct thud_sweep_plan *plan, int k)
{
    const enum thud_case which = plan->cases[k];
    return thud_case_title(thud_scene_measures(&plan->scene), which == THUD_CASE_AS_WRITTEN ? THUD_CASE_WHOLE : which);
}

/* One case: counts with their bands; the curve with its own where there is one, or the exact result in its place. */
static void add_curve(struct thud_panel *panel, const struct thud_sweep_plan *plan,
                      const struct thud_fragility_curve *curve)
{
    const struct thud_fragility *f = curve->fragility;
    double unit = thud_varied_factor(&plan->axis[curve->axis]), x[FINE], y[FINE];
    const char *name = case_title(plan, curve->k);
    int color = thud_case_color(plan->cases[curve->k]);
    double *point = malloc(4 * (f->n + 1) * sizeof *point), *share = point + f->n, *low = share + f->n,
           *high = low + f->n;
    if (!point) {
        if (panel)
            panel->figure->failed = true;
        return;
    }
    bool banded = false, exact = f->nexact > 0, fitted = !exact && thud_is_fitted(&f->curve);
    for (size_t i = 0; i < f->n; i++) {
        point[i] = f->stripe[i].x * unit;
        share[i] = f->stripe[i].n > 0 ? 100.0 * f->stripe[i].count / f->stripe[i].n : NAN;
        low[i] = 100 * f->low[i];
        high[i] = 100 * f->high[i];
        banded |= fitted && !isnan(f->low[i]);
    }
    if (banded)
        thud_panel_fill(panel, (struct thud_style){.color = color, .thin = true}, name, f->n, point, low, high);
    if (exact)
        add_steps(panel, &plan->axis[curve->axis], f, name, color);
    if (fitted) {
        for (int i = 0; i < FINE; i++) {
            double at = f->least + (f->most - f->least) * i / (FINE - 1);
            x[i] = at * unit;
            y[i] = 100 * thud_lognormal_at(&f->curve, at);
        }
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = color}, name, FINE, x, y);
    }
    for (size_t i = 0; i < f->n; i++) { /* counts of cases are often the same: they stand beside each other */
        point[i] += 0.005 * (2 * curve->k - (plan->ncases - 1)) * (f->most - f->least) * unit;
        low[i] = 100 * f->share_low[i];
        high[i] = 100 * f->share_high[i];
    }
    thud_panel_bars(panel, color, f->n, point, low, high);
    thud_panel_add(panel, (struct thud_style){.kind = THUD_POINTS, .color = color}, exact || fitted ? "" : name, f->n,
                   point, share);
    free(point);
}

const char *thud_fragility_note(int ndraws)
{
    return ndraws < THUD_SHARES_LEAST ? "Points: shares, of so few motions without bands; steps: exact."
           : ndraws < THUD_DRAWS_LEAST
               ? "Points: shares with 90 % bands (Wilson); steps: exact; curves without bands, of so few motions."
               : "Points: shares with 90 % bands (Wilson); steps: exact; curves where the counts allow one; shaded: "
                 "90 % by bootstrap.";
}

/* "drift:1 %": drift above 1 %. */
static void event_words(const struct thud_scene *scene, const char *event, char *text, size_t size)
{
    static const char *const worse[] = {[THUD_HAS_BUMPER] = "a bumper that makes it worse",
                                        [THUD_HAS_LINKS] = "links that make it worse",
                                        [THUD_HAS_BUMPER | THUD_HAS_LINKS] = "bumper and links that make it worse"};
    const char *limit = strchr(event, ':'), *of = worse[thud_scene_measures(scene)];
    if (limit)
        snprintf(text, size, "%.*s above %s", (int)(limit - event), event, limit + 1);
    else
        snprintf(text, size, "%s", of && strcmp(event, "worse") == 0 ? of : event);
}

/* Points at the ends of the axis stand inside the frame. */
static void clear_of_frame(struct thud_panel *panel, const struct thud_sweep_axis *axis)
{
    const double least = axis->value[0] * thud_varied_factor(axis),
                 most = axis->value[axis->n - 1] * thud_varied_factor(axis), margin = 0.03 * (most - least);
    if (thud_axis_has_numbers(axis) && margin > 0)
        thud_panel_limits(panel, THUD_X, least - margin, most + margin);
}

struct thud_figure *thud_figure_of_fragility(const struct thud_sweep_plan *plan, const char *event,
                                             const struct thud_fragility_curve *curve, int ncurves, const char *note)
{
    char name[96] = "fragility-", title[THUD_TEXT_MAX + 128], words[96];
    size_t n = strlen(name);
    int columns = 0, panel_of[PANELS_MAX];
    for (int a = 0; a < PANELS_MAX; a++)
        panel_of[a] = -1;
    for (int i = 0; i < ncurves; i++)
        if (panel_of[curve[i].axis] < 0)
            panel_of[curve[i].axis] = columns++;
    for (const char *c = event; *c && n + 1 < sizeof name; c++) { /* an event is in small letters but for units */
        bool capital = *c >= 'A' && *c <= 'Z', plain = (*c >= 'a' && *c <= 'z') || (*c >= '0' && *c <= '9');
        if (capital || plain || name[n - 1] != '-')
            name[n++] = (char)(capital ? *c - 'A' + 'a' : plain ? *c : '-');
    }
    while (name[n - 1] == '-')
        n--;
    name[n] = '\0';
    event_words(&plan->scene, event, words, sizeof words);
    snprintf(title, sizeof title, "%s: probability of %s", plan->scene.title[0] ? plan->scene.title : plan->scene.name,
             words);
    struct thud_figure *figure = thud_figure_create(name, title, 1, columns > 0 ? columns : 1);
    bool line = false;
    for (int a = 0; a < plan->naxes; a++) {
        char against[400];
        double gap = NAN;
        if (panel_of[a] < 0)
            continue;
        struct thud_panel *panel = thud_figure_panel(figure, 0, panel_of[a], "");
        thud_panel_varied(panel, THUD_X, &plan->axis[a]);
        if (panel) {
            snprintf(against, sizeof against, "%c%s against %c%s", words[0] - 'a' + 'A', words + 1,
                     panel->axis[THUD_X].label[0] - 'A' + 'a', panel->axis[THUD_X].label + 1);
            thud_figure_panel(figure, 0, panel_of[a], against);
        }
        clear_of_frame(panel, &plan->axis[a]);
        thud_panel_share_axis(panel, THUD_Y, "Share of the ground motions");
        for (int i = 0; i < ncurves; i++)
            if (curve[i].axis == a) {
                add_curve(panel, plan, &curve[i]);
                gap = curve[i].fragility->free_gap;
            }
        if (gap >= plan->axis[a].value[0] && gap <= plan->axis[a].value[plan->axis[a].n - 1]) {
            gap *= thud_varied_factor(&plan->axis[a]);
            thud_panel_mark(panel, THUD_X, gap, gap, "");
            line = true;
        }
    }
    thud_figure_note(figure, note);
    if (line)
        thud_figure_note_free_gap(figure, "Vertical", thud_scene_measures(&plan->scene), false, true);
    return figure;
}

/* One structure's panel. false: out of memory. */
static bool add_ida(struct thud_panel *panel, const struct thud_suite *suite, int axis, int k, const int *at,
                    int structure)
{
    const struct thud_sweep_axis *varied = &suite->plan->axis[axis];
    size_t n = (size_t)varied->n, records = (size_t)suite->nrecords;
    double *room = malloc((records + 5 * n) * sizeof *room), *x = room + records, *y = x + n, *three = y + n;
    int place[THUD_VARY_MAX];
    if (!room)
        return false;
    memcpy(place, at, sizeof place);
    for (int r = 0; r < suite->nrecords; r++) {
        for (size_t i = 0; i < n; i++) {
            place[axis] = (int)i;
            x[i] = 100 *
                   thud_suite_value(suite, r, thud_suite_setting(suite->plan, place), k, THUD_MEASURE_DRIFT, structure);
            y[i] = varied->value[i] * thud_varied_factor(varied);
        }
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = THUD_COLOR_GREY, .thin = true},
                       "each motion", n, x, y);
    }
    static const char *const name[] = {"16 and 84 %", "median", "16 and 84 %"};
    for (size_t i = 0; i < n; i++) {
        place[axis] = (int)i;
        struct thud_fractiles f = thud_suite_fractiles(suite, thud_suite_setting(suite->plan, place), k,
                                                       THUD_MEASURE_DRIFT, structure, 0, room);
        three[i] = 100 * f.p16;
        three[n + i] = 100 * f.median;
        three[2 * n + i] = 100 * f.p84;
    }
    const int color = thud_case_color(suite->plan->cases[k]);
    for (int q = 0; q < 3; q++)
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = color, .wide = q == 1, .dashed = q != 1},
                       name[q], n, three + (size_t)q * n, y);
    free(room);
    return true;
}

struct thud_figure *thud_figure_of_ida(const struct thud_suite *suite, int axis, int k, const int *at, const char *note)
{
    const struct thud_sweep_plan *plan = suite->plan;
    int structure[COLUMNS_MAX], columns = 0;
    char name[64], title[160];
    for (int s = 0; s < plan->scene.nstructures && columns < COLUMNS_MAX; s++)
        if (thud_kind_is_building(plan->scene.structure[s].kind))
            structure[columns++] = s;
    snprintf(name, sizeof name, "ida-%s", thud_case_name(plan->cases[k]));
    snprintf(title, sizeof title, "Incremental dynamic analysis, %s", case_title(plan, k));
    struct thud_figure *figure = thud_figure_create(name, title, 1, columns > 0 ? columns : 1);
    for (int c = 0; c < columns; c++) {
        struct thud_panel *panel = thud_figure_panel(figure, 0, c, plan->scene.structure[structure[c]].name);
        thud_panel_axis(panel, THUD_X, "Largest interstorey drift", "cm");
        thud_panel_results_on_x(panel);
        thud_panel_limits(panel, THUD_X, 0, NAN);
        thud_panel_varied(panel, THUD_Y, &plan->axis[axis]);
        thud_panel_limits(panel, THUD_Y, 0, NAN);
        if (figure && !add_ida(panel, suite, axis, k, at, structure[c]))
            figure->failed = true;
    }
    thud_figure_note(figure, note);
    return figure;
}
