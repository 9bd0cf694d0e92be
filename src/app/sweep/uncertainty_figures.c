/* The figures of uncertain inputs. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/sweep/uncertainty_study.h"
#include "base/statistics.h"

/* The ratio, or where there is none the largest acceleration, of each structure. */
static bool is_drawn(const struct thud_uncertainty *u, int q)
{
    return thud_uncertainty_has_ratios(u) ? thud_quantity_is_ratio(&u->quantity[q])
                                          : u->quantity[q].measure == THUD_MEASURE_ACCELERATION;
}

/* Inputs from the one that moves a quantity least: it stands lowest. */
static void order_inputs(const struct thud_uncertainty_told *t, int n, int *order)
{
    for (int i = 0; i < n; i++) {
        int at = i;
        for (; at > 0 && thud_uncertainty_span(t, order[at - 1]) > thud_uncertainty_span(t, i); at--)
            order[at] = order[at - 1];
        order[at] = i;
    }
}

/* "gap ±5 %", "contact-stiffness ×÷2". */
static void shorten(char *text)
{
    static const struct {
        const char *from, *to;
    } word[] = {{"+-", "±"}, {"by a factor of ", "×÷"}};
    for (size_t i = 0; i < sizeof word / sizeof *word; i++) {
        char *at = strstr(text, word[i].from);
        size_t n = strlen(word[i].to), past = strlen(word[i].from);
        if (at) {
            memcpy(at, word[i].to, n);
            memmove(at + n, at + past, strlen(at + past) + 1);
        }
    }
}

static void add_tornado(struct thud_panel *panel, const struct thud_uncertainty_study *study, int q)
{
    const struct thud_uncertainty *u = study->uncertainty;
    const struct thud_uncertainty_told *t = &study->told[q];
    int n = u->ninputs, order[THUD_DRAWN_MAX];
    double x[3 * THUD_DRAWN_MAX], y[3 * THUD_DRAWN_MAX];
    order_inputs(t, n, order);
    for (int i = 0; i < n; i++) {
        char text[128];
        thud_uncertainty_input_text(u, order[i], text, sizeof text);
        shorten(text);
        thud_panel_tick(panel, THUD_Y, i + 1, text);
    }
    thud_panel_limits(panel, THUD_Y, 0.5, n + 1.3); /* above the bars stands a word */
    thud_panel_mark(panel, THUD_X, t->nominal, t->nominal, "nominal");
    for (int end = 0; end < 2; end++) {
        for (int i = 0; i < n; i++) {
            x[3 * i] = t->nominal;
            x[3 * i + 1] = t->of[end ? THUD_INPUT_MOST : THUD_INPUT_LEAST][order[i]];
            x[3 * i + 2] = NAN;
            y[3 * i] = y[3 * i + 1] = y[3 * i + 2] = i + 1;
        }
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES_POINTS, .color = end, .wide = end == 0},
                       end ? "input at its most" : "input at its least", 3 * (size_t)n, x, y);
    }
}

/* The scene, and what is drawn of it. */
static struct thud_figure *begin(const struct thud_uncertainty *u, const char *name, const char *what, int rows,
                                 int columns)
{
    char title[400];
    snprintf(title, sizeof title, "%s: %s", u->scene.title[0] ? u->scene.title : u->scene.name, what);
    return thud_figure_create(name, title, rows, columns);
}

static const char *ratio_label(const struct thud_uncertainty *u, char text[64])
{
    snprintf(text, 64, "Ratio to %s", thud_case_title(thud_scene_measures(&u->scene), THUD_CASE_NONE));
    return text;
}

static struct thud_figure *tornado(const struct thud_uncertainty_study *study)
{
    enum { PANELS = 12 }; /* acceleration and drift of six structures */
    const struct thud_uncertainty *u = study->uncertainty;
    int drawn[PANELS], n = 0;
    char ratio[64];
    ratio_label(u, ratio);
    for (int q = 0; q < u->nquantities && n < PANELS; q++)
        if (is_drawn(u, q))
            drawn[n++] = q;
    int columns = n > 1 ? 2 : 1;
    struct thud_figure *figure =
        begin(u, "tornado", "one uncertain input at a time", (n + columns - 1) / columns, columns);
    for (int i = 0; i < n; i++) {
        const struct thud_quantity_of_run *quantity = &u->quantity[drawn[i]];
        char title[128];
        snprintf(title, sizeof title, "%s: %s", u->scene.structure[quantity->structure].name,
                 quantity->measure == THUD_MEASURE_DRIFT_RATIO ? "drift" : "acceleration");
        struct thud_panel *panel = thud_figure_panel(figure, i / columns, i % columns, title);
        thud_panel_axis(panel, THUD_X, thud_quantity_is_ratio(quantity) ? ratio : "Largest acceleration",
                        thud_quantity_is_ratio(quantity) ? "" : "m/s²");
        thud_panel_axis(panel, THUD_Y, "", "");
        thud_panel_results_on_x(panel);
        add_tornado(panel, study, drawn[i]);
    }
    thud_figure_share_scale(figure, THUD_X, 0, 1, n, NULL); /* what moves one much moves another little */
    return figure;
}

static struct thud_figure *distribution(const struct thud_uncertainty_study *study)
{
    const struct thud_uncertainty *u = study->uncertainty;
    size_t n = thud_uncertainty_samples(study), first = thud_uncertainty_first_sample(study);
    double *x = malloc(2 * (n + 1) * sizeof *x), *y = x + n;
    char ratio[64];
    struct thud_figure *figure = begin(u, "sampled-ratios", "all inputs sampled together", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    thud_panel_axis(panel, THUD_X, ratio_label(u, ratio), "");
    thud_panel_results_on_x(panel);
    thud_panel_share_axis(panel, THUD_Y, "Share of the samples below");
    thud_panel_mark(panel, THUD_X, 1, 1, "");
    if (!x) {
        thud_figure_free(figure);
        return NULL;
    }
    for (int q = 0, color = 0; q < u->nquantities; q++) {
        if (!thud_quantity_is_ratio(&u->quantity[q]))
            continue;
        for (size_t r = 0; r < n; r++) {
            x[r] = thud_uncertainty_value(study, first + r, q);
            y[r] = 100.0 * (double)(r + 1) / (double)n;
        }
        thud_sort_numbers(x, n);
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = color++}, u->quantity[q].name, n, x, y);
    }
    free(x);
    return figure;
}

int thud_uncertainty_figure_count(const struct thud_uncertainty_study *study)
{
    return 1 + (study->samples > 0 && thud_uncertainty_has_ratios(study->uncertainty));
}

struct thud_figure *thud_uncertainty_figure(const struct thud_uncertainty_study *study, int index)
{
    return index == 0 ? tornado(study) : distribution(study);
}
