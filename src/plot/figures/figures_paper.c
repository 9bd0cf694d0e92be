#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "plot/figures/figures_paper.h"
#include "plot/figures/figures_scene.h"
#include "study/scene/two_body.h"

static const double step_s = 5e-4;
static const char ultimate_strain[] = "ultimate strain 0.8: 𝛿ᵤ = 40 mm";

static const struct {
    const char *name;
    bool rubber;
    double approach_mps, restitution; /* 0: Table 1's */
    int color;
} cases[THUD_PAPER_COLLISIONS] = {
    {"no bumper", .approach_mps = 0.5},
    {"bumper", .rubber = true, .approach_mps = 0.5, .color = 1},
    {"no bumper", .approach_mps = 1.0},
    {"bumper", .rubber = true, .approach_mps = 1.0, .color = 1},
    {"𝑒 = 0.3", .rubber = true, .approach_mps = 1.2, .restitution = 0.3},
    {"𝑒 = 0.5", .rubber = true, .approach_mps = 1.2, .restitution = 0.5, .color = 1},
    {"𝑒 = 0.7", .rubber = true, .approach_mps = 1.2, .restitution = 0.7, .color = 2},
    {"bumper", .rubber = true, .approach_mps = 0.25},
};

static enum thud_status run_case(int i, struct thud_solution *solution, struct thud_error *err)
{
    struct thud_two_body pair;
    if (cases[i].rubber)
        thud_two_body_rubber(&pair);
    else
        thud_two_body_concrete(&pair);
    if (cases[i].restitution > 0)
        thud_two_body_set(&pair, "restitution", cases[i].restitution);
    pair.approach_mps = cases[i].approach_mps;
    return thud_two_body_run(&pair, step_s, solution, err);
}

enum trace { FORCE, INDENTATION, RELATIVE_VELOCITY, ACCELERATION, TIME };

static double value(const struct thud_history *h, size_t i, enum trace what)
{
    const double *row = h->value + i * (size_t)h->columns;
    switch (what) {
    case FORCE:
        return 1e-6 * row[thud_history_force(h, 0)];
    case INDENTATION:
        return 1e3 * row[thud_history_indentation(h, 0)];
    case RELATIVE_VELOCITY:
        return row[thud_history_velocity(h, 0)] - row[thud_history_velocity(h, 1)];
    case ACCELERATION:
        return row[thud_history_acceleration(h, 1)];
    default:
        return 1e3 * h->time_s[i];
    }
}

/* Against time the whole run, against indentation while in contact. */
static void line(struct thud_panel *panel, const struct thud_solution *solution, enum trace on_x, enum trace on_y,
                 struct thud_style style, const char *name)
{
    const struct thud_history *h = thud_run_history(solution->run);
    struct thud_series *series = thud_panel_add(panel, style, name, h->rows + 2, NULL, NULL);
    if (!series)
        return;
    size_t n = 0;
    bool after = false;
    double largest = 0;
    if (on_x == TIME) { /* what was before the contact onset, at t = 0 */
        series->x[n] = -20.0;
        series->y[n++] = on_y == RELATIVE_VELOCITY ? value(h, 0, on_y) : 0.0;
        series->x[n] = 0.0;
        series->y[n++] = on_y == RELATIVE_VELOCITY ? value(h, 0, on_y) : 0.0;
    } else
        series->x[n++] = 0.0;
    for (size_t i = 0; i < h->rows && !after; i++) {
        series->x[n] = value(h, i, on_x);
        series->y[n++] = value(h, i, on_y);
        largest = fmax(largest, value(h, i, FORCE)); /* at release a force is 0 but for rounding */
        after = on_x == INDENTATION && largest > 0 && value(h, i, FORCE) <= 1e-9 * largest;
    }
    series->n = n;
}

/* A case in a column of panels. */
static enum thud_status add_case(int i, struct thud_panel *const *panel, int n, const enum trace *on_x,
                                 const enum trace *on_y, struct thud_error *err)
{
    struct thud_solution solution;
    enum thud_status status = run_case(i, &solution, err);
    if (status != THUD_OK)
        return status;
    for (int k = 0; k < n; k++)
        line(panel[k], &solution, on_x[k], on_y[k], (struct thud_style){.color = cases[i].color}, cases[i].name);
    thud_solution_clear(&solution);
    return THUD_OK;
}

static void paper_axis(struct thud_panel *panel, enum thud_side side, enum trace what)
{
    static const char *const label[] = {"Impact force", "Indentation", "Relative velocity", "Acceleration", "Time"};
    static const char *const unit[] = {"MN", "mm", "m/s", "m/s²", "ms"};
    thud_panel_axis(panel, side, label[what], unit[what]);
    if (what == TIME)
        thud_panel_limits(panel, side, -20.0, 250.0);
}

static enum thud_status finish(struct thud_figure *figure, enum thud_status status, struct thud_figure **out,
                               struct thud_error *err)
{
    if (status == THUD_OK)
        status = thud_figure_check(figure, err);
    if (status != THUD_OK) {
        thud_figure_free(figure);
        figure = NULL;
    }
    *out = figure;
    return status;
}

enum thud_status thud_figure_paper2(struct thud_figure **out, struct thud_error *err)
{
    struct thud_figure *figure = thud_figure_create("fig2", "The rubber bumper: force against indentation", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    struct thud_two_body pair;
    struct thud_solution solution = {0};
    thud_two_body_rubber(&pair);
    pair.approach_mps = 0.6;
    enum thud_status status = thud_two_body_run(&pair, step_s, &solution, err);
    paper_axis(panel, THUD_X, INDENTATION);
    paper_axis(panel, THUD_Y, FORCE);
    thud_panel_limits(panel, THUD_X, 0.0, 50.0);
    thud_panel_limits(panel, THUD_Y, 0.0, NAN);
    if (status == THUD_OK) {
        const struct thud_history *h = thud_run_history(solution.run);
        struct thud_style style[2] = {{.color = 0}, {.color = 1}};
        struct thud_series *way[2] = {
            thud_panel_add(panel, style[0], "approach: 𝐹 = 𝑘 𝛿ⁿ", h->rows, NULL, NULL),
            thud_panel_add(panel, style[1], "restitution: 𝐹 = 𝑘 𝛿ⁿ (1 + 𝐶 d𝛿/d𝑡)", h->rows + 1, NULL, NULL)};
        size_t n[2] = {0};
        double last = 0, foot = 0;
        for (size_t i = 0; i < h->rows && way[0] && way[1]; i++) {
            int back = value(h, i, RELATIVE_VELOCITY) < 0;
            if (n[1] > 0 && last <= 0) /* it has let go */
                break;
            last = value(h, i, FORCE);
            foot = value(h, i, INDENTATION);
            if (back && n[1] == 0 && n[0] > 0) {
                way[1]->x[n[1]] = way[0]->x[n[0] - 1];
                way[1]->y[n[1]++] = way[0]->y[n[0] - 1];
            }
            way[back]->x[n[back]] = foot;
            way[back]->y[n[back]++] = last;
        }
        for (int k = 0; k < 2 && way[k]; k++)
            way[k]->n = n[k];
    }
    thud_panel_mark(panel, THUD_X, 40.0, 40.0, ultimate_strain);
    thud_figure_note(figure,
                     "𝑘 = 0.36 kN/mm²·⁶⁵, 𝑛 = 2.65, 𝐶 by Eq. (7) for a coefficient of restitution 𝑒 = 0.5; beyond the "
                     "ultimate strain a stiffness of 2500 kN/mm. Two bodies of 320 t approaching at 0.6 m/s.");
    thud_solution_clear(&solution);
    return finish(figure, status, out, err);
}

/* Told apart in grey too. */
static void rectangle(struct thud_panel *panel, const char *name, int color, double left, double right, double bottom,
                      double top)
{
    const double x[] = {left, right}, low[] = {bottom, bottom}, high[] = {top, top};
    thud_panel_fill(panel, (struct thud_style){.color = color, .wide = color >= 0}, name, 2, x, low, high);
}

/* The two buildings of the paper, with bumpers. */
static void two_buildings(struct thud_scene *scene)
{
    static const int storeys[] = {4, 6};
    thud_scene_init(scene);
    scene->nstructures = 2;
    for (int s = 0; s < 2; s++) {
        struct thud_structure *p = &scene->structure[s];
        thud_structure_init(p, THUD_SHEAR);
        snprintf(p->name, sizeof p->name, "%d-storey building", storeys[s]);
        p->storeys = storeys[s];
        for (int i = 0; i < p->storeys; i++) {
            p->mass_kg[i] = i + 1 < p->storeys ? 320e3 : 250e3;
            p->stiffness_npm[i] = 600e6;
            p->height_m[i] = 3;
            p->slab_depth_m[i] = 0.3;
        }
    }
    thud_interface_init(&scene->interface[0]);
    thud_interface_add_bumper(&scene->interface[0]);
}

enum thud_status thud_figure_paper6(struct thud_figure **out, struct thud_error *err)
{
    struct thud_scene *scene = malloc(sizeof *scene);
    if (!scene)
        return finish(NULL, thud_error_set(err, THUD_MEMORY, "out of memory"), out, err);
    two_buildings(scene);
    struct thud_figure *figure = thud_figure_of_scene(scene, "fig6", "The two buildings");
    free(scene);
    return finish(figure, THUD_OK, out, err);
}

enum thud_status thud_figure_paper9(struct thud_figure **out, struct thud_error *err)
{
    static const double thickness = 5.0, gap = 10.0, cavity[] = {0.0, 1.0};
    struct thud_figure *figure = thud_figure_create("fig9", "The bumper on the wall and in a cavity of 1 cm", 1, 2);
    for (int p = 0; p < 2; p++) {
        char title[96];
        snprintf(title, sizeof title, "%s: clearance %g cm of a gap of %g cm", p ? "In a cavity" : "On the wall",
                 gap - thickness + cavity[p], gap);
        struct thud_panel *panel = thud_figure_panel(figure, 0, p, title);
        thud_panel_axis(panel, THUD_X, "From the face of the wall", "cm");
        thud_panel_axis(panel, THUD_Y, "", "");
        thud_panel_tick(panel, THUD_Y, 5.0, "floor");
        thud_panel_limits(panel, THUD_X, -6.0, 14.0);
        thud_panel_limits(panel, THUD_Y, 0.0, 10.0);
        rectangle(panel, "concrete", THUD_COLOR_GREY, -6.0, -cavity[p], 0.0, 10.0);
        if (cavity[p] > 0) {
            rectangle(panel, "concrete", THUD_COLOR_GREY, -cavity[p], 0.0, 0.0, 3.0);
            rectangle(panel, "concrete", THUD_COLOR_GREY, -cavity[p], 0.0, 7.0, 10.0);
        }
        rectangle(panel, "rubber that can be compressed, 4 cm", 2, 1.0 - cavity[p], thickness - cavity[p], 3.0, 7.0);
        rectangle(panel, "rubber that cannot be compressed, 1 cm", THUD_COLORS - 1, -cavity[p], 1.0 - cavity[p], 3.0,
                  7.0);
        rectangle(panel, "concrete", THUD_COLOR_GREY, gap, 14.0, 0.0, 10.0);
    }
    thud_figure_note(figure,
                     "The cavity takes the 1 cm that cannot be compressed: all 4 cm that can be stand before the "
                     "wall, and the clearance is 1 cm wider.");
    return finish(figure, THUD_OK, out, err);
}

enum thud_status thud_figure_paper3(struct thud_figure **out, struct thud_error *err)
{
    static const enum trace on_x[] = {TIME, INDENTATION}, on_y[] = {FORCE, FORCE};
    struct thud_figure *figure = thud_figure_create(
        "fig3", "Rubber bumper pushed past its ultimate strain, three coefficients of restitution 𝑒", 1, 2);
    struct thud_panel *panel[2] = {thud_figure_panel(figure, 0, 0, "Force against time"),
                                   thud_figure_panel(figure, 0, 1, "Force against indentation")};
    for (int p = 0; p < 2; p++) {
        paper_axis(panel[p], THUD_X, on_x[p]);
        paper_axis(panel[p], THUD_Y, FORCE);
    }
    thud_panel_limits(panel[0], THUD_X, -10.0, 150.0);
    thud_panel_limits(panel[1], THUD_X, 0.0, 50.0);
    thud_panel_mark(panel[1], THUD_X, 40.0, 40.0, ultimate_strain);
    enum thud_status status = THUD_OK;
    for (int i = 0; i < THUD_PAPER_FIG3 && status == THUD_OK; i++)
        status = add_case(THUD_PAPER_PAIRS + i, panel, 2, on_x, on_y, err);
    thud_figure_note(
        figure,
        "Bumper of Table 1 between two free bodies of 320 t approaching at 1.2 m/s. Eq. (5) as printed: the force "
        "drops where the motion turns.");
    return finish(figure, status, out, err);
}

static const char *const at_speed[] = {"Approach at 0.5 m/s", "Approach at 1.0 m/s"};

enum thud_status thud_figure_paper4(struct thud_figure **out, struct thud_error *err)
{
    static const enum trace on_x[] = {INDENTATION}, on_y[] = {FORCE};
    struct thud_figure *figure =
        thud_figure_create("fig4", "Two rigid bodies of 320 t: impact force against indentation", 1, 2);
    enum thud_status status = THUD_OK;
    for (int i = 0; i < THUD_PAPER_PAIRS && status == THUD_OK; i++) {
        struct thud_panel *panel = thud_figure_panel(figure, 0, i / 2, at_speed[i / 2]);
        paper_axis(panel, THUD_X, INDENTATION);
        paper_axis(panel, THUD_Y, FORCE);
        thud_panel_limits(panel, THUD_X, 0.0, 45.0);
        thud_panel_limits(panel, THUD_Y, 0.0, 18.0);
        status = add_case(i, &panel, 1, on_x, on_y, err);
    }
    return finish(figure, status, out, err);
}

enum thud_status thud_figure_paper5(struct thud_figure **out, struct thud_error *err)
{
    static const enum trace on_x[] = {TIME, TIME, TIME}, on_y[] = {FORCE, RELATIVE_VELOCITY, ACCELERATION};
    struct thud_figure *figure =
        thud_figure_create("fig5", "Two rigid bodies of 320 t: force, velocity and acceleration", 3, 2);
    enum thud_status status = THUD_OK;
    for (int i = 0; i < THUD_PAPER_PAIRS && status == THUD_OK; i++) {
        struct thud_panel *panel[3];
        for (int row = 0; row < 3; row++) {
            panel[row] = thud_figure_panel(figure, row, i / 2, at_speed[i / 2]);
            paper_axis(panel[row], THUD_X, TIME);
            paper_axis(panel[row], THUD_Y, on_y[row]);
        }
        status = add_case(i, panel, 3, on_x, on_y, err);
    }
    thud_figure_note(
        figure, "Relative velocity: left minus right body; acceleration: of the right body. Contact onset at 0 ms.");
    return finish(figure, status, out, err);
}

enum thud_status thud_paper_pairs(struct thud_paper_pair out[THUD_PAPER_COLLISIONS], struct thud_error *err)
{
    for (int i = 0; i < THUD_PAPER_COLLISIONS; i++) {
        struct thud_solution solution;
        enum thud_status status = run_case(i, &solution, err);
        if (status != THUD_OK)
            return status;
        const struct thud_contact_result *contact = &thud_run_result(solution.run)->contact[0];
        out[i] = (struct thud_paper_pair){
            cases[i].name,           cases[i].approach_mps,        contact->force.value, contact->indentation.value,
            contact->contact_time_s, contact->nominal_restitution, contact->restitution, contact->residual_m};
        thud_solution_clear(&solution);
    }
    return THUD_OK;
}
