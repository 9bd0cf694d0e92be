#include <math.h>
#include <stdio.h>

#include "plot/figures_paper.h"
#include "study/pair.h"

static const double step_s = 5e-4;

/* The paper names neither the three restitutions nor the speed; these go well past the ultimate strain. */
static const double fig3_restitution[] = {0.3, 0.5, 0.7}, fig3_closing_mps = 1.2;

static const struct {
    const char *name;
    bool rubber;
    double closing_mps;
    int color;
} cases[THUD_PAPER_PAIRS] = {
    {"no bumper", false, 0.5, 0}, {"bumper", true, 0.5, 1}, {"no bumper", false, 1.0, 0}, {"bumper", true, 1.0, 1}};

static enum thud_status run_case(int i, struct thud_answer *answer, struct thud_error *err)
{
    struct thud_pair pair;
    if (cases[i].rubber)
        thud_pair_rubber(&pair);
    else
        thud_pair_concrete(&pair);
    pair.closing_mps = cases[i].closing_mps;
    return thud_pair_run(&pair, step_s, answer, err);
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
static void line(struct thud_panel *panel, const struct thud_answer *answer, enum trace on_x, enum trace on_y,
                 struct thud_style style, const char *name)
{
    const struct thud_history *h = thud_run_history(answer->run);
    struct thud_series *series = thud_panel_add(panel, style, name, h->rows + 2, NULL, NULL);
    if (!series)
        return;
    size_t n = 0;
    bool after = false;
    double largest = 0;
    if (on_x == TIME) { /* what was before the first touch, at t = 0 */
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
        after = on_x == INDENTATION && i > 0 && value(h, i, FORCE) <= 1e-9 * largest;
    }
    series->n = n;
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

enum thud_status thud_figure_paper3(struct thud_figure **out, struct thud_error *err)
{
    static const enum trace on_x[] = {TIME, INDENTATION};
    struct thud_figure *figure = thud_figure_create(
        "fig3", "Rubber bumper pushed past its ultimate strain, three coefficients of restitution", 1, 2);
    struct thud_panel *panel[2] = {thud_figure_panel(figure, 0, 0, "Force against time"),
                                   thud_figure_panel(figure, 0, 1, "Force against indentation")};
    for (int p = 0; p < 2; p++) {
        paper_axis(panel[p], THUD_X, on_x[p]);
        paper_axis(panel[p], THUD_Y, FORCE);
    }
    thud_panel_limits(panel[0], THUD_X, -10.0, 150.0);
    thud_panel_limits(panel[1], THUD_X, 0.0, 50.0);
    thud_panel_mark(panel[1], THUD_X, 40.0, 40.0, "ultimate strain");
    enum thud_status status = THUD_OK;
    for (int i = 0; i < 3 && status == THUD_OK; i++) {
        struct thud_pair pair;
        struct thud_answer answer;
        char name[32];
        thud_pair_rubber(&pair);
        thud_pair_set(&pair, "restitution", fig3_restitution[i]);
        pair.closing_mps = fig3_closing_mps;
        status = thud_pair_run(&pair, step_s, &answer, err);
        if (status != THUD_OK)
            break;
        snprintf(name, sizeof name, "COR %g", fig3_restitution[i]);
        for (int p = 0; p < 2; p++)
            line(panel[p], &answer, on_x[p], FORCE, (struct thud_style){.color = i}, name);
        thud_answer_clear(&answer);
    }
    thud_figure_note(
        figure, "Bumper of Table 1 between two free bodies of 320 t closing at 1.2 m/s. Eq. (5) as printed: the force "
                "drops where the motion turns.");
    return finish(figure, status, out, err);
}

enum thud_status thud_figure_paper4(struct thud_figure **out, struct thud_error *err)
{
    struct thud_figure *figure =
        thud_figure_create("fig4", "Two rigid bodies of 320 t: impact force against indentation", 1, 2);
    struct thud_panel *panel[2] = {thud_figure_panel(figure, 0, 0, "Closing at 0.5 m/s"),
                                   thud_figure_panel(figure, 0, 1, "Closing at 1.0 m/s")};
    enum thud_status status = THUD_OK;
    for (int p = 0; p < 2; p++) {
        paper_axis(panel[p], THUD_X, INDENTATION);
        paper_axis(panel[p], THUD_Y, FORCE);
        thud_panel_limits(panel[p], THUD_X, 0.0, 45.0);
        thud_panel_limits(panel[p], THUD_Y, 0.0, 18.0);
    }
    for (int i = 0; i < THUD_PAPER_PAIRS && status == THUD_OK; i++) {
        struct thud_answer answer;
        status = run_case(i, &answer, err);
        if (status != THUD_OK)
            break;
        line(panel[i / 2], &answer, INDENTATION, FORCE, (struct thud_style){.color = cases[i].color}, cases[i].name);
        thud_answer_clear(&answer);
    }
    return finish(figure, status, out, err);
}

enum thud_status thud_figure_paper5(struct thud_figure **out, struct thud_error *err)
{
    static const enum trace on_y[] = {FORCE, RELATIVE_VELOCITY, ACCELERATION};
    struct thud_figure *figure =
        thud_figure_create("fig5", "Two rigid bodies of 320 t: force, velocity and acceleration", 3, 2);
    enum thud_status status = THUD_OK;
    for (int i = 0; i < THUD_PAPER_PAIRS && status == THUD_OK; i++) {
        struct thud_answer answer;
        status = run_case(i, &answer, err);
        if (status != THUD_OK)
            break;
        for (int row = 0; row < 3; row++) {
            struct thud_panel *panel =
                thud_figure_panel(figure, row, i / 2, i < 2 ? "Closing at 0.5 m/s" : "Closing at 1.0 m/s");
            paper_axis(panel, THUD_X, TIME);
            paper_axis(panel, THUD_Y, on_y[row]);
            line(panel, &answer, TIME, on_y[row], (struct thud_style){.color = cases[i].color}, cases[i].name);
        }
        thud_answer_clear(&answer);
    }
    thud_figure_note(figure,
                     "Relative velocity: left minus right body; acceleration: of the right body. First touch at 0 ms.");
    return finish(figure, status, out, err);
}

enum thud_status thud_paper_pairs(struct thud_paper_pair *out, struct thud_error *err)
{
    for (int i = 0; i < THUD_PAPER_PAIRS; i++) {
        struct thud_answer answer;
        enum thud_status status = run_case(i, &answer, err);
        if (status != THUD_OK)
            return status;
        const struct thud_contact_result *contact = &thud_run_result(answer.run)->contact[0];
        out[i] = (struct thud_paper_pair){
            cases[i].name,           cases[i].closing_mps,         contact->force.value, contact->indentation.value,
            contact->contact_time_s, contact->nominal_restitution, contact->restitution, contact->residual_m};
        thud_answer_clear(&answer);
    }
    return THUD_OK;
}
