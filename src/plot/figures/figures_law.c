#include "plot/figures/figures_law.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "study/scene/two_body.h"

double thud_law_mass(const struct thud_scene *scene, int s)
{
    const struct thud_structure *structure = &scene->structure[s];
    if (structure->kind == THUD_WALL)
        return thud_wall_gives(structure) ? structure->wall_mass_kg : INFINITY;
    return structure->kind == THUD_ISOLATED ? structure->base_mass_kg : structure->mass_kg[0];
}

/* Two free bodies of the lowest floors' masses; a wall that moves with the ground is a body a million times as heavy. */
static struct thud_two_body bodies(const struct thud_scene *scene, int pair, double speed)
{
    const struct thud_interface *at = &scene->interface[pair];
    const struct thud_law_choice *choice = at->has_bumper ? &at->bumper : &at->contact;
    struct thud_two_body two = {.approach_mps = speed, .duration_s = 1.0, .law = choice->law};
    for (int i = 0; i < 2; i++)
        two.mass_kg[i] = thud_law_mass(scene, pair + i);
    for (int i = 0; i < 2; i++)
        if (!isfinite(two.mass_kg[i]))
            two.mass_kg[i] = 1e6 * (isfinite(two.mass_kg[1 - i]) ? two.mass_kg[1 - i] : 1e3);
    memcpy(two.setup.value, choice->value, sizeof choice->value);
    two.setup.thickness_m = at->has_bumper ? at->bumper_thickness_m : 0.0;
    return two;
}

/* `behind`: what it is called where it lies behind, dashed; NULL: it does not. */
static void add_loop(struct thud_panel *panel, struct thud_run *run, int index, double speed, const char *behind)
{
    const struct thud_history *history = thud_run_history(run);
    char name[80];
    snprintf(name, sizeof name, "%g m/s%s%s", speed, behind ? ", " : "", behind ? behind : "");
    struct thud_style style = {.kind = THUD_LINES, .color = index, .thin = behind, .dashed = behind};
    struct thud_series *series = thud_panel_add(panel, style, name, history->rows, NULL, NULL);
    int force = thud_history_force(history, 0), indentation = thud_history_indentation(history, 0);
    for (size_t i = 0; series && i < history->rows; i++) {
        const double *row = history->value + i * (size_t)history->columns;
        bool in_contact = row[force] != 0.0 || row[indentation] > 0.0;
        series->x[i] = in_contact ? 1e3 * row[indentation] : NAN;
        series->y[i] = in_contact ? 1e-6 * row[force] : NAN;
    }
}

static enum thud_status add_speed(struct thud_panel *panel, const struct thud_scene *scene, int pair, int index,
                                  double speed, const char *behind, struct thud_meeting *meeting,
                                  struct thud_error *err)
{
    struct thud_two_body two = bodies(scene, pair, speed);
    struct thud_solution solution = {0};
    enum thud_status status = thud_two_body_run(&two, 1e-3, &solution, err);
    if (status == THUD_OK) {
        const struct thud_contact_result *contact = &thud_run_result(solution.run)->contact[0];
        *meeting = (struct thud_meeting){speed, contact->force.value, contact->indentation.value, contact->restitution};
        add_loop(panel, solution.run, index, speed, behind);
    }
    thud_solution_clear(&solution);
    return status;
}

/* Whether two bodies meet alike in both scenes. */
static bool meet_alike(const struct thud_scene *a, const struct thud_scene *b, int pair)
{
    const struct thud_interface *x = &a->interface[pair], *y = &b->interface[pair];
    return x->has_bumper == y->has_bumper && memcmp(&x->contact, &y->contact, sizeof x->contact) == 0 &&
           memcmp(&x->bumper, &y->bumper, sizeof x->bumper) == 0 && x->bumper_thickness_m == y->bumper_thickness_m &&
           thud_law_mass(a, pair) == thud_law_mass(b, pair) && thud_law_mass(a, pair + 1) == thud_law_mass(b, pair + 1);
}

struct thud_figure *thud_figure_of_law(const struct thud_scene *scene, const struct thud_law_behind *behind, int pair,
                                       struct thud_meeting meeting[THUD_MEETINGS], struct thud_error *err)
{
    static const double speed[THUD_MEETINGS] = {0.25, 0.5, 1.0};
    const struct thud_scene *against = behind->scene;
    bool bumper = scene->interface[pair].has_bumper;
    char title[160];
    const struct thud_law *law = bumper ? scene->interface[pair].bumper.law : scene->interface[pair].contact.law;
    bool both = against && pair + 1 < against->nstructures && !meet_alike(scene, against, pair);
    snprintf(title, sizeof title, "%s%s%s between two free bodies", law ? law->name : "no law", both ? " and " : "",
             both ? behind->name : "");
    struct thud_figure *figure = thud_figure_create("force-indentation", title, 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, "Indentation", "mm");
    thud_panel_axis(panel, THUD_Y, "Force", "MN");
    enum thud_status status = !figure ? thud_error_set(err, THUD_MEMORY, "no memory for the figure")
                              : law   ? THUD_OK
                                      : thud_error_set(err, THUD_INPUT, "no law is chosen");
    /* the smaller loops over the larger; without one behind there is none */
    for (int i = THUD_MEETINGS - 1; both && i >= 0 && status == THUD_OK; i--)
        add_speed(panel, against, pair, THUD_MEETINGS - 1 - i, speed[i], behind->name, &behind->meeting[i], NULL);
    for (int i = THUD_MEETINGS - 1; i >= 0 && status == THUD_OK; i--)
        status = add_speed(panel, scene, pair, THUD_MEETINGS - 1 - i, speed[i], NULL, &meeting[i], err);
    if (status == THUD_OK && thud_figure_check(figure, err) == THUD_OK)
        return figure;
    thud_figure_free(figure);
    return NULL;
}
