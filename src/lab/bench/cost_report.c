#include <math.h>
#include <stdio.h>

#include "lab/bench/cost_jobs.h"

static const char *const quantities[THUD_COST_QUANTITIES] = {"time of a run", "time to set up", "steps", "forces"};

static void add_fit(const struct thud_cost *cost, enum thud_cost_quantity quantity, struct thud_text *out)
{
    const struct thud_cost_axis_info *axis = thud_cost_axis_info(thud_cost_axis(cost));
    struct thud_cost_fit fit = thud_cost_fit(cost, quantity);
    bool time = quantity == THUD_COST_TIME || quantity == THUD_COST_SETUP;
    thud_text_append(out, "%-14s ", quantities[quantity]);
    if (fit.points < 2)
        thud_text_append(out, "no slope: too few sizes\n");
    else if (fit.power)
        thud_text_append(out, "~ %s^%.2f from %.4g%s%s on\n", axis->name, fit.b, fit.from, *axis->unit ? " " : "",
                         axis->unit);
    else
        thud_text_append(out, "= %.4g%s + %.4g%s for each\n", time ? 1e3 * fit.a : fit.a, time ? " ms" : "",
                         time ? 1e6 * fit.b : fit.b, time ? " us" : "");
}

void thud_cost_table(struct thud_cost *cost, struct thud_text *out)
{
    const struct thud_cost_axis_info *axis = thud_cost_axis_info(thud_cost_axis(cost));
    thud_text_append(out,
                     "%s%s%s\n\n%10s  clearance m  floors  contacts  impacts   run ms  spread  setup ms     steps"
                     "    forces   events\n",
                     axis->label, *axis->unit ? ", " : "", axis->unit, axis->name);
    for (int i = 0; i < thud_cost_count(cost); i++) {
        const struct thud_cost_point *p = thud_cost_point(cost, i);
        if (p->state == THUD_COST_WAITING || (p->state == THUD_COST_SKIPPED && isnan(p->size)))
            continue;
        if (p->state == THUD_COST_SKIPPED) {
            thud_text_append(out, "%10.6g  skipped: %s\n", p->size, p->message);
            continue;
        }
        thud_text_append(out, "%10.6g  %11.4g  %6d  %8d  ", p->size, p->clearance_m, p->floors, p->contacts);
        if (p->state == THUD_COST_FAILED)
            thud_text_append(out, "FAILED %s\n", p->message);
        else
            thud_text_append(out, "%7d %8.4g %7.2g %9.3g %9ld %9ld %8ld\n", p->impacts, 1e3 * p->seconds,
                             1e3 * p->spread, 1e3 * p->setup_s, p->work.steps, p->work.force_evaluations,
                             p->work.events);
    }
    thud_text_append(out, "\n");
    for (int q = 0; q < THUD_COST_QUANTITIES; q++)
        if (q != THUD_COST_SETUP || thud_cost_axis(cost) <= THUD_COST_BUILDINGS)
            add_fit(cost, (enum thud_cost_quantity)q, out);
    thud_text_append(out, "\n%s\n", axis->reason);
}

/* One quantity over the sizes done, and its fitted line. */
static void add_series(struct thud_cost *cost, struct thud_panel *panel, enum thud_cost_quantity quantity, int color)
{
    double x[64], y[64], line[64], scale = quantity == THUD_COST_TIME || quantity == THUD_COST_SETUP ? 1e3 : 1;
    struct thud_cost_fit fit = thud_cost_fit(cost, quantity);
    size_t n = 0, m = 0;
    for (int i = 0; i < thud_cost_count(cost) && n < 64; i++) {
        const struct thud_cost_point *p = thud_cost_point(cost, i);
        double value = scale * thud_cost_value(p, quantity);
        if (p->state != THUD_COST_DONE || (fit.power && !(value > 0)))
            continue;
        x[n] = p->size;
        y[n++] = value;
    }
    if (n == 0)
        return;
    thud_panel_add(panel, (struct thud_style){.kind = THUD_POINTS, .color = color}, quantities[quantity], n, x, y);
    for (size_t i = 0; i < n && fit.points >= 2; i++)
        if (!fit.power || x[i] >= fit.from) {
            x[m] = x[i];
            line[m++] = scale * (fit.power ? fit.a * pow(x[i], fit.b) : fit.a + fit.b * x[i]);
        }
    if (m > 0)
        thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES, .color = color, .thin = true}, "", m, x, line);
}

static void add_note(const struct thud_cost *cost, struct thud_panel *panel, enum thud_cost_quantity quantity)
{
    struct thud_cost_fit fit = thud_cost_fit(cost, quantity);
    char text[96];
    bool time = quantity == THUD_COST_TIME;
    if (fit.points < 2)
        return;
    if (fit.power)
        snprintf(text, sizeof text, "%s ~ %s^%.2f", quantities[quantity],
                 thud_cost_axis_info(thud_cost_axis(cost))->name, fit.b);
    else
        snprintf(text, sizeof text, "%.3g%s and %.3g%s more for each impact", time ? 1e3 * fit.a : fit.a,
                 time ? " ms" : "", time ? 1e6 * fit.b : fit.b, time ? " µs" : "");
    thud_panel_note(panel, text);
}

struct thud_figure *thud_cost_figure(struct thud_cost *cost, const char *title)
{
    const struct thud_cost_axis_info *axis = thud_cost_axis_info(thud_cost_axis(cost));
    bool impacts = thud_cost_axis(cost) == THUD_COST_IMPACTS; /* none at times: no logarithm */
    char name[64];
    snprintf(name, sizeof name, "cost-%s", axis->name);
    struct thud_figure *figure = thud_figure_create(name, title, 1, 2);
    for (int k = 0; k < 2; k++) {
        struct thud_panel *panel = thud_figure_panel(figure, 0, k, k ? "Work" : "Time");
        thud_panel_axis(panel, THUD_X, axis->label, axis->unit);
        thud_panel_axis(panel, THUD_Y,
                        !k        ? "Processor time"
                        : impacts ? "Steps"
                                  : "Steps and force evaluations",
                        k ? "" : "ms");
        add_series(cost, panel, k ? THUD_COST_STEPS : THUD_COST_TIME, k ? 2 : 0);
        if (impacts)
            thud_panel_results_on_x(panel);
        else {
            thud_panel_log(panel, THUD_X);
            thud_panel_log(panel, THUD_Y);
            add_series(cost, panel, k ? THUD_COST_FORCES : THUD_COST_SETUP, k ? 3 : 1);
        }
        add_note(cost, panel, k ? THUD_COST_STEPS : THUD_COST_TIME);
    }
    return figure;
}
