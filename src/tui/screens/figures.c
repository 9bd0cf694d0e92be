#include <math.h>
#include <stdio.h>

#include "study/scene/level.h"
#include "study/scene/solution.h"
#include "tui/screens/figures.h"

const char *thud_plot_title(enum thud_plot plot)
{
    static const char *const title[] = {
#define THUD_PLOT(name, words, file) words,
#include "tui/screens/plot_list.h"
#undef THUD_PLOT
    };
    return title[plot];
}

int thud_plot_count(const struct thud_scene *scene)
{
    return THUD_PLOTS - !thud_scene_yields(scene);
}

static const char *file_name(enum thud_plot plot)
{
    static const char *const name[] = {
#define THUD_PLOT(name, words, file) file,
#include "tui/screens/plot_list.h"
#undef THUD_PLOT
    };
    return name[plot];
}

/* "A, floor 4" for a dof of the model; of a drift the storey below it. */
static void dof_name(const struct thud_model *model, const struct thud_scene *scene, int dof, bool storey, char *text,
                     size_t size)
{
    char level[24];
    const int s = model->dof_structure[dof], floor = dof - model->structure[s].first, n = model->structure[s].n;
    if (floor >= n)
        snprintf(text, size, "%.40s, %s", scene->structure[s].name, floor == n ? "foundation" : "rocking at the roof");
    else
        snprintf(text, size, "%.40s, %s", scene->structure[s].name,
                 thud_structure_level_name(&scene->structure[s], floor, storey, level));
}

/* "A 4 and B 4", "A 4 and B c5" where it strikes columns below B's floor 5. */
static void contact_name(const struct thud_model *model, const struct thud_scene *scene, int contact, char *text,
                         size_t size)
{
    const struct thud_model_contact *c = &model->contact[contact];
    char left[16] = "", right[16] = ""; /* a wall has no floors */
    if (c->left_floor > 0)
        snprintf(left, sizeof left, " %s%d", c->struck < 0 ? "c" : "", c->left_floor);
    if (c->right_floor > 0)
        snprintf(right, sizeof right, " %s%d", c->struck > 0 ? "c" : "", c->right_floor);
    snprintf(text, size, "%.30s%s and %.30s%s", scene->structure[c->interface - 1].name, left,
             scene->structure[c->interface].name, right);
}

/* A case plain, or dashed and with the name `compared`, of the state to compare with. */
struct shown {
    const struct thud_live *live;
    const char *compared;
};

static const char *shown_name(const struct shown *of, int which, char text[48])
{
    snprintf(text, 48, "%s%s%s", thud_live_name(of->live->measures, (enum thud_live_which)which),
             of->compared ? ", " : "", of->compared ? of->compared : "");
    return text;
}

static struct thud_style shown_style(const struct shown *of, enum thud_series_kind kind, int which)
{
    return (struct thud_style){.kind = kind,
                               .color = thud_live_color((enum thud_live_which)which),
                               .thin = of->compared,
                               .dashed = of->compared};
}

/* What a case has of a plot: columns of its histories, or the drift below a floor. */
struct curve {
    int x, y, minus;           /* columns; x < 0: time; minus < 0: nothing is taken off y */
    double x_factor, y_factor; /* to what is shown */
    bool touching;             /* only where y is not 0 */
    bool drift;                /* of the sight's floor, mm, in place of y */
};

static void add_curve(struct thud_panel *panel, struct thud_style style, const char *name, const struct thud_history *h,
                      const struct curve *c, const struct thud_model_structure *storeys, int floor)
{
    struct thud_series *series = thud_panel_add(panel, style, name, h->rows, NULL, NULL);
    for (size_t i = 0; series && i < h->rows; i++) {
        const double *row = h->value + i * (size_t)h->columns;
        const bool shown = !c->touching || row[c->y] != 0.0;
        series->x[i] = !shown ? NAN : c->x < 0 ? h->time_s[i] : c->x_factor * row[c->x];
        series->y[i] =
            !shown     ? NAN
            : c->drift ? 1e3 * thud_model_drift(storeys, row + thud_history_displacement(h, storeys->first), 1, floor)
                       : c->y_factor * (row[c->y] - (c->minus >= 0 ? row[c->minus] : 0.0));
    }
}

static bool is_of_contact(enum thud_plot plot)
{
    return plot == THUD_PLOT_FORCE || plot == THUD_PLOT_APPROACH || plot == THUD_PLOT_LOOP;
}

/* False: the case has none; another scene may have fewer floors and contacts. */
static bool curve_of(enum thud_plot plot, const struct thud_sight *sight, const struct thud_model *model,
                     const struct thud_history *h, bool pounds, struct curve *c)
{
    *c = (struct curve){.x = -1, .minus = -1, .y_factor = 1.0};
    if (is_of_contact(plot) ? sight->contact >= model->npairs : sight->dof >= model->ndof)
        return false;
    if (plot == THUD_PLOT_FORCE || plot == THUD_PLOT_LOOP) {
        if (sight->contact >= h->ncontacts || !pounds)
            return false;
        c->y = thud_history_force(h, sight->contact);
        c->y_factor = 1e-6;
        c->touching = plot == THUD_PLOT_LOOP;
        c->x = c->touching ? thud_history_indentation(h, sight->contact) : -1;
        c->x_factor = 1e3;
    } else if (plot == THUD_PLOT_APPROACH) {
        const struct thud_model_contact *contact = &model->contact[sight->contact];
        const int left = contact->left_dof, right = contact->right_dof;
        if (left < 0 && right < 0)
            return false;
        c->y = thud_history_velocity(h, left >= 0 ? left : right);
        c->minus = left >= 0 && right >= 0 ? thud_history_velocity(h, right) : -1;
        c->y_factor = left >= 0 ? 1.0 : -1.0;
    } else if (plot == THUD_PLOT_HYSTERESIS) {
        const int storey = thud_model_yielding(model, sight->dof);
        if (storey < 0)
            return false;
        c->x = thud_history_storey_drift(h, storey);
        c->x_factor = 1e3;
        c->y = thud_history_storey_shear(h, storey);
        c->y_factor = 1e-6;
    } else if (plot == THUD_PLOT_ACCELERATION) {
        c->y = thud_history_acceleration(h, sight->dof);
    } else if (plot == THUD_PLOT_DRIFT) {
        c->drift = true;
    } else {
        c->y = thud_history_displacement(h, sight->dof);
        c->y_factor = 1e3;
    }
    return true;
}

static void add_case(struct thud_panel *panel, const struct shown *of, int which, enum thud_plot plot,
                     const struct thud_sight *sight)
{
    const struct thud_history *h = thud_live_motions(of->live, (enum thud_live_which)which);
    const struct thud_model *model = of->live->which[which].model;
    struct curve curve;
    char name[48];
    if (!h || !curve_of(plot, sight, model, h, which != THUD_LIVE_FREE, &curve))
        return;
    const struct thud_model_structure *storeys =
        curve.drift ? &model->structure[model->dof_structure[sight->dof]] : NULL;
    add_curve(panel, shown_style(of, THUD_LINES, which), shown_name(of, which, name), h, &curve, storeys,
              storeys ? sight->dof - storeys->first : 0);
}

/* Whether these two floors stay apart in every case. */
static bool never_meet(const struct thud_live *live, int contact)
{
    for (int which = THUD_LIVE_NONE; which < THUD_LIVE_CASES; which++) {
        const struct thud_result *result = thud_live_result(live, (enum thud_live_which)which);
        if (result && contact < result->ncontacts && result->contact[contact].impacts > 0)
            return false;
    }
    return true;
}

/* Why there is nothing to show; NULL: there is. */
static const char *lacks(const struct thud_live *live, enum thud_plot plot, const struct thud_sight *sight)
{
    if (is_of_contact(plot))
        return sight->contact < 0                                               ? "No two floors can meet here"
               : plot != THUD_PLOT_APPROACH && never_meet(live, sight->contact) ? "no contact at this gap"
                                                                                : NULL;
    if (plot == THUD_PLOT_HYSTERESIS)
        return sight->dof < 0 || thud_model_yielding(live->which[THUD_LIVE_NONE].model, sight->dof) < 0
                   ? "This storey is elastic: ] and [ lead to those that yield"
                   : NULL;
    return sight->dof < 0 ? "There is no floor" : NULL;
}

static struct thud_figure *curves(const struct thud_live *live, const struct thud_live *compared,
                                  const struct thud_scene *scene, enum thud_plot plot, const struct thud_sight *sight,
                                  const char **why)
{
    static const struct {
        const char *along, *along_unit, *label, *unit;
    } axis[] = {[THUD_PLOT_FORCE] = {"Time", "s", "Force", "MN"},
                [THUD_PLOT_APPROACH] = {"Time", "s", "Approach velocity", "m/s"},
                [THUD_PLOT_ACCELERATION] = {"Time", "s", "Acceleration", "m/s2"},
                [THUD_PLOT_DRIFT] = {"Time", "s", "Drift", "mm"},
                [THUD_PLOT_DISPLACEMENT] = {"Time", "s", "Displacement", "mm"},
                [THUD_PLOT_LOOP] = {"Indentation", "mm", "Force", "MN"},
                [THUD_PLOT_HYSTERESIS] = {"Drift", "mm", "Shear", "MN"}};
    const struct thud_model *model = live->which[THUD_LIVE_NONE].model;
    char title[200], where[140] = "";
    if ((*why = lacks(live, plot, sight)) != NULL)
        return NULL;
    if (is_of_contact(plot))
        contact_name(model, scene, sight->contact, where, sizeof where);
    else
        dof_name(model, scene, sight->dof, plot == THUD_PLOT_DRIFT || plot == THUD_PLOT_HYSTERESIS, where,
                 sizeof where);
    if (plot == THUD_PLOT_LOOP)
        snprintf(title, sizeof title, "%s", thud_plot_title(plot));
    else
        snprintf(title, sizeof title, "%s, %s", thud_plot_title(plot), where);
    struct thud_figure *figure = thud_figure_create(file_name(plot), title, 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, axis[plot].along, axis[plot].along_unit);
    thud_panel_axis(panel, THUD_Y, axis[plot].label, axis[plot].unit);
    for (int which = plot == THUD_PLOT_HYSTERESIS ? 0 : THUD_LIVE_NONE; compared && which < THUD_LIVE_CASES; which++)
        add_case(panel, &(struct shown){compared, sight->compared}, which, plot, sight);
    for (int which = 0; which < THUD_LIVE_CASES; which++)
        add_case(panel, &(struct shown){live, NULL}, which, plot, sight);
    return figure;
}

static void add_envelope(struct thud_panel *panel, const struct shown *of, int which, int s, bool drift)
{
    const struct thud_result *result = thud_live_result(of->live, (enum thud_live_which)which);
    int floors = result && s < result->nstructures ? result->structure[s].floors : 0;
    char name[48];
    if (floors == 0)
        return;
    struct thud_series *series =
        thud_panel_add(panel, shown_style(of, of->compared ? THUD_LINES : THUD_LINES_POINTS, which),
                       shown_name(of, which, name), (size_t)floors, NULL, NULL);
    for (int i = 0; series && i < floors; i++) {
        series->x[i] = drift ? 1e3 * result->structure[s].floor[i].drift.value : thud_floor_acceleration(result, s, i);
        series->y[i] = i + 1;
    }
}

/* One panel a structure (at most four), floor numbers upward. */
static struct thud_figure *envelopes(const struct thud_live *live, const struct thud_live *compared,
                                     const struct thud_scene *scene, enum thud_plot plot,
                                     const struct thud_sight *sight)
{
    bool drift = plot == THUD_PLOT_ENVELOPE_DRIFT;
    int n = scene->nstructures < 4 ? scene->nstructures : 4;
    struct thud_figure *figure = thud_figure_create(file_name(plot), thud_plot_title(plot), 1, n);
    for (int s = 0; s < n; s++) {
        struct thud_panel *panel = thud_figure_panel(figure, 0, s, scene->structure[s].name);
        thud_panel_axis(panel, THUD_X, drift ? "Drift" : "Acceleration", drift ? "mm" : "m/s2");
        thud_panel_axis(panel, THUD_Y, "Floor", "");
        for (int which = THUD_LIVE_NONE; compared && which < THUD_LIVE_CASES; which++)
            add_envelope(panel, &(struct shown){compared, sight->compared}, which, s, drift);
        for (int which = 0; which < THUD_LIVE_CASES; which++)
            add_envelope(panel, &(struct shown){live, NULL}, which, s, drift);
    }
    return figure;
}

static struct thud_figure *energies(const struct thud_live *live, const struct thud_sight *sight, const char **why)
{
    static const char *const name[] = {"input", "kinetic", "strain", "viscous", "contact"};
    const struct thud_history *h = thud_live_motions(live, sight->which);
    if (!h) {
        *why = "This case has no results";
        return NULL;
    }
    char title[96];
    snprintf(title, sizeof title, "Energies, %s", thud_live_name(live->measures, sight->which));
    struct thud_figure *figure = thud_figure_create(file_name(THUD_PLOT_ENERGY), title, 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, "Time", "s");
    thud_panel_axis(panel, THUD_Y, "Energy", "kJ");
    for (int e = 0; e < THUD_HISTORY_ENERGIES; e++)
        add_curve(panel, (struct thud_style){.kind = THUD_LINES, .color = e}, name[e], h,
                  &(struct curve){.x = -1, .y = thud_history_energy(h, e), .minus = -1, .y_factor = 1e-3}, NULL, 0);
    return figure;
}

struct thud_figure *thud_plot_make(const struct thud_live *live, const struct thud_live *compared,
                                   const struct thud_scene *scene, enum thud_plot plot, const struct thud_sight *sight,
                                   const char **why)
{
    struct thud_figure *figure;
    *why = NULL;
    if (live->running || live->which[THUD_LIVE_NONE].state != THUD_LIVE_DONE) {
        *why = live->running                                           ? "running"
               : live->which[THUD_LIVE_NONE].state == THUD_LIVE_FAILED ? "FAILED"
                                                                       : "no results: r runs";
        return NULL;
    }
    bool envelope = plot == THUD_PLOT_ENVELOPE_ACCELERATION || plot == THUD_PLOT_ENVELOPE_DRIFT;
    if (!envelope && (!live->history || (plot == THUD_PLOT_ENERGY && live->history != THUD_LIVE_WHOLE))) {
        *why = "the histories are not there yet";
        return NULL;
    }
    if (envelope)
        figure = envelopes(live, compared, scene, plot, sight);
    else if (plot == THUD_PLOT_ENERGY)
        figure = energies(live, sight, why);
    else
        figure = curves(live, compared, scene, plot, sight, why);
    if (figure && thud_figure_check(figure, NULL) == THUD_OK)
        return figure;
    thud_figure_free(figure);
    if (!*why)
        *why = "no memory for the figure";
    return NULL;
}
