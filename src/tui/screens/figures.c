#include <math.h>
#include <stdio.h>

#include "study/sweep/remark.h"
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

/* "A 4" for a dof of the model. Returns `text`. */
static char *dof_name(const struct thud_model *model, const struct thud_scene *scene, int dof, char *text, size_t size)
{
    const int s = model->dof_structure[dof], floor = dof - model->structure[s].first, n = model->structure[s].n;
    if (floor >= n)
        snprintf(text, size, "%.40s, %s", scene->structure[s].name, floor == n ? "foundation" : "rocking at the roof");
    else
        snprintf(text, size, "%.40s, floor %d", scene->structure[s].name, floor + 1);
    return text;
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

static const struct thud_history *history_of(const struct thud_live *live, int which)
{
    const struct thud_live_case *c = &live->which[which];
    return c->state == THUD_LIVE_DONE && live->history ? thud_run_history(c->run) : NULL;
}

/* A case plain, or dashed and with the name `pinned`, of the state to compare with. */
struct shown {
    const struct thud_live *live;
    const char *pinned;
};

static const char *shown_name(const struct shown *of, int which, char text[48])
{
    snprintf(text, 48, "%s%s%s", thud_live_name((enum thud_live_which)which), of->pinned ? ", " : "",
             of->pinned ? of->pinned : "");
    return text;
}

static struct thud_style shown_style(const struct shown *of, enum thud_series_kind kind, int which)
{
    return (struct thud_style){
        .kind = kind, .color = thud_live_color((enum thud_live_which)which), .thin = of->pinned, .dashed = of->pinned};
}

/* A curve of the case against what the caller fills in. */
static struct thud_series *add_lines(struct thud_panel *panel, const struct shown *of, int which,
                                     const struct thud_history *h)
{
    char name[48];
    return thud_panel_add(panel, shown_style(of, THUD_LINES, which), shown_name(of, which, name), h->rows, NULL, NULL);
}

/* A column of the history, less another one where `minus` is not negative, times a factor. */
static void add_history(struct thud_panel *panel, const struct shown *of, int which, int column, int minus,
                        double factor)
{
    const struct thud_history *h = history_of(of->live, which);
    struct thud_series *series = add_lines(panel, of, which, h);
    for (size_t i = 0; series && i < h->rows; i++) {
        const double *row = h->value + i * (size_t)h->columns;
        series->x[i] = h->time_s[i];
        series->y[i] = factor * (row[column] - (minus >= 0 ? row[minus] : 0.0));
    }
}

/* The drift of the storey below a floor, mm. */
static void add_drift(struct thud_panel *panel, const struct shown *of, int which, const struct thud_model *model,
                      int dof)
{
    const struct thud_history *h = history_of(of->live, which);
    const struct thud_model_structure *p = &model->structure[model->dof_structure[dof]];
    struct thud_series *series = add_lines(panel, of, which, h);
    for (size_t i = 0; series && i < h->rows; i++) {
        const double *row = h->value + i * (size_t)h->columns + thud_history_displacement(h, p->first);
        series->x[i] = h->time_s[i];
        series->y[i] = 1e3 * thud_model_drift(p, row, 1, dof - p->first);
    }
}

static void add_case(struct thud_panel *panel, const struct shown *of, int which, enum thud_plot plot,
                     const struct thud_sight *sight)
{
    const struct thud_history *h = history_of(of->live, which);
    const struct thud_model *model = of->live->which[which].model;
    bool of_contact = plot == THUD_PLOT_FORCE || plot == THUD_PLOT_APPROACH;
    if (!h || (of_contact ? sight->contact >= model->npairs : sight->dof >= model->ndof))
        return; /* another scene may have fewer */
    if (plot == THUD_PLOT_FORCE) {
        if (sight->contact < h->ncontacts && which != THUD_LIVE_FREE)
            add_history(panel, of, which, thud_history_force(h, sight->contact), -1, 1e-6);
    } else if (plot == THUD_PLOT_APPROACH) {
        const struct thud_model_contact *contact = &model->contact[sight->contact];
        int left = contact->left_dof, right = contact->right_dof;
        if (left >= 0)
            add_history(panel, of, which, thud_history_velocity(h, left),
                        right >= 0 ? thud_history_velocity(h, right) : -1, 1.0);
        else if (right >= 0)
            add_history(panel, of, which, thud_history_velocity(h, right), -1, -1.0);
    } else if (plot == THUD_PLOT_ACCELERATION) {
        add_history(panel, of, which, thud_history_acceleration(h, sight->dof), -1, 1.0);
    } else if (plot == THUD_PLOT_DRIFT) {
        add_drift(panel, of, which, model, sight->dof);
    } else {
        add_history(panel, of, which, thud_history_displacement(h, sight->dof), -1, 1e3);
    }
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

static struct thud_figure *histories(const struct thud_live *live, const struct thud_live *pinned,
                                     const struct thud_scene *scene, enum thud_plot plot,
                                     const struct thud_sight *sight, const char **why)
{
    static const struct {
        const char *label, *unit;
    } axis[] = {[THUD_PLOT_FORCE] = {"Force", "MN"},
                [THUD_PLOT_APPROACH] = {"Approach velocity", "m/s"},
                [THUD_PLOT_ACCELERATION] = {"Acceleration", "m/s2"},
                [THUD_PLOT_DRIFT] = {"Drift", "mm"},
                [THUD_PLOT_DISPLACEMENT] = {"Displacement", "mm"}};
    const struct thud_model *model = live->which[THUD_LIVE_NONE].model;
    bool of_contact = plot == THUD_PLOT_FORCE || plot == THUD_PLOT_APPROACH;
    *why = of_contact && sight->contact < 0                              ? "No two floors can meet here"
           : plot == THUD_PLOT_FORCE && never_meet(live, sight->contact) ? "no contact at this gap"
           : !of_contact && sight->dof < 0                               ? "There is no floor"
                                                                         : NULL;
    if (*why)
        return NULL;
    char title[200], where[140];
    if (of_contact)
        contact_name(model, scene, sight->contact, where, sizeof where);
    else
        dof_name(model, scene, sight->dof, where, sizeof where);
    snprintf(title, sizeof title, "%s, %s", thud_plot_title(plot), where);
    struct thud_figure *figure = thud_figure_create(file_name(plot), title, 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, "Time", "s");
    thud_panel_axis(panel, THUD_Y, axis[plot].label, axis[plot].unit);
    for (int which = THUD_LIVE_NONE; pinned && which < THUD_LIVE_CASES; which++)
        add_case(panel, &(struct shown){pinned, sight->pinned}, which, plot, sight);
    for (int which = 0; which < THUD_LIVE_CASES; which++)
        add_case(panel, &(struct shown){live, NULL}, which, plot, sight);
    return figure;
}

static void add_loop(struct thud_panel *panel, const struct shown *of, int which, int contact)
{
    const struct thud_history *h = history_of(of->live, which);
    if (!h || contact >= h->ncontacts)
        return;
    int force = thud_history_force(h, contact), depth = thud_history_indentation(h, contact);
    struct thud_series *series = add_lines(panel, of, which, h);
    for (size_t i = 0; series && i < h->rows; i++) {
        const double *row = h->value + i * (size_t)h->columns;
        bool in_contact = row[force] != 0.0;
        series->x[i] = in_contact ? 1e3 * row[depth] : NAN;
        series->y[i] = in_contact ? 1e-6 * row[force] : NAN;
    }
}

static struct thud_figure *loops(const struct thud_live *live, const struct thud_live *pinned,
                                 const struct thud_sight *sight, const char **why)
{
    if (sight->contact < 0) {
        *why = "No two floors can meet here";
        return NULL;
    }
    if (never_meet(live, sight->contact)) {
        *why = "no contact at this gap";
        return NULL;
    }
    struct thud_figure *figure = thud_figure_create(file_name(THUD_PLOT_LOOP), thud_plot_title(THUD_PLOT_LOOP), 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, "Indentation", "mm");
    thud_panel_axis(panel, THUD_Y, "Force", "MN");
    for (int i = pinned ? 0 : 1; i < 2; i++)
        for (int which = THUD_LIVE_NONE; which < THUD_LIVE_CASES; which++)
            add_loop(panel, &(struct shown){i ? live : pinned, i ? NULL : sight->pinned}, which, sight->contact);
    return figure;
}

static void add_hysteresis(struct thud_panel *panel, const struct shown *of, int which, int dof)
{
    const struct thud_history *h = history_of(of->live, which);
    const struct thud_model *model = of->live->which[which].model;
    int storey = h && dof < model->ndof ? thud_model_yielding(model, dof) : -1;
    if (storey < 0)
        return;
    int drift = thud_history_storey_drift(h, storey), shear = thud_history_storey_shear(h, storey);
    struct thud_series *series = add_lines(panel, of, which, h);
    for (size_t i = 0; series && i < h->rows; i++) {
        const double *row = h->value + i * (size_t)h->columns;
        series->x[i] = 1e3 * row[drift];
        series->y[i] = 1e-6 * row[shear];
    }
}

static struct thud_figure *hysteresis(const struct thud_live *live, const struct thud_live *pinned,
                                      const struct thud_scene *scene, const struct thud_sight *sight, const char **why)
{
    const struct thud_model *model = live->which[THUD_LIVE_NONE].model;
    char title[160];
    if (sight->dof < 0 || thud_model_yielding(model, sight->dof) < 0) {
        *why = "This storey is elastic: ] and [ lead to those that yield";
        return NULL;
    }
    int s = model->dof_structure[sight->dof];
    snprintf(title, sizeof title, "%s, %.40s, storey %d", thud_plot_title(THUD_PLOT_HYSTERESIS),
             scene->structure[s].name, sight->dof - model->structure[s].first + 1);
    struct thud_figure *figure = thud_figure_create(file_name(THUD_PLOT_HYSTERESIS), title, 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, "Drift", "mm");
    thud_panel_axis(panel, THUD_Y, "Shear", "MN");
    for (int i = pinned ? 0 : 1; i < 2; i++)
        for (int which = 0; which < THUD_LIVE_CASES; which++)
            add_hysteresis(panel, &(struct shown){i ? live : pinned, i ? NULL : sight->pinned}, which, sight->dof);
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
        thud_panel_add(panel, shown_style(of, of->pinned ? THUD_LINES : THUD_LINES_POINTS, which),
                       shown_name(of, which, name), (size_t)floors, NULL, NULL);
    for (int i = 0; series && i < floors; i++) {
        series->x[i] = drift ? 1e3 * result->structure[s].floor[i].drift.value : thud_floor_acceleration(result, s, i);
        series->y[i] = i + 1;
    }
}

/* One panel a structure (at most four), floor numbers upward. */
static struct thud_figure *envelopes(const struct thud_live *live, const struct thud_live *pinned,
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
        for (int which = THUD_LIVE_NONE; pinned && which < THUD_LIVE_CASES; which++)
            add_envelope(panel, &(struct shown){pinned, sight->pinned}, which, s, drift);
        for (int which = 0; which < THUD_LIVE_CASES; which++)
            add_envelope(panel, &(struct shown){live, NULL}, which, s, drift);
    }
    return figure;
}

static struct thud_figure *energies(const struct thud_live *live, const struct thud_sight *sight, const char **why)
{
    static const char *const name[] = {"input", "kinetic", "strain", "viscous", "contact"};
    const struct thud_history *h = history_of(live, (int)sight->which);
    if (!h) {
        *why = "This case has no results";
        return NULL;
    }
    char title[96];
    snprintf(title, sizeof title, "Energies, %s", thud_live_name(sight->which));
    struct thud_figure *figure = thud_figure_create(file_name(THUD_PLOT_ENERGY), title, 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, "Time", "s");
    thud_panel_axis(panel, THUD_Y, "Energy", "kJ");
    for (int e = 0; e < THUD_HISTORY_ENERGIES; e++) {
        struct thud_series *series =
            thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = e}, name[e], h->rows, NULL, NULL);
        for (size_t i = 0; series && i < h->rows; i++) {
            series->x[i] = h->time_s[i];
            series->y[i] = 1e-3 * h->value[i * (size_t)h->columns + (size_t)thud_history_energy(h, e)];
        }
    }
    return figure;
}

struct thud_figure *thud_plot_make(const struct thud_live *live, const struct thud_live *pinned,
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
        figure = envelopes(live, pinned, scene, plot, sight);
    else if (plot == THUD_PLOT_LOOP)
        figure = loops(live, pinned, sight, why);
    else if (plot == THUD_PLOT_HYSTERESIS)
        figure = hysteresis(live, pinned, scene, sight, why);
    else if (plot == THUD_PLOT_ENERGY)
        figure = energies(live, sight, why);
    else
        figure = histories(live, pinned, scene, plot, sight, why);
    if (figure && thud_figure_check(figure, NULL) == THUD_OK)
        return figure;
    thud_figure_free(figure);
    if (!*why)
        *why = "no memory for the figure";
    return NULL;
}
