/* The figures of a fragility study: a fragility for every event, then the incremental dynamic analysis along every
 * intensity in every case. Keys that a figure does not show stand in the middle of their values. */
#include <stdio.h>
#include <string.h>

#include "app/sweep/fragility_report.h"
#include "plot/figures/figures_fragility.h"

static void middle(const struct thud_sweep_plan *plan, int *at)
{
    memset(at, 0, THUD_VARY_MAX * sizeof *at);
    for (int a = 0; a < plan->naxes; a++)
        at[a] = plan->axis[a].n / 2;
}

/* Where the line stands at the middle of the other keys. */
static bool is_middle(const struct thud_sweep_plan *plan, const struct thud_fragility_line *line)
{
    int at[THUD_VARY_MAX];
    middle(plan, at);
    at[line->axis] = line->at[line->axis];
    return memcmp(at, line->at, (size_t)plan->naxes * sizeof *at) == 0;
}

/* "24 ground motions. Points: shares, with 90 % bands (Wilson). Where not varied: gap = 15 cm" */
static void note(const struct thud_fragility_study *study, const char *what, char *text, size_t size)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    int at[THUD_VARY_MAX];
    middle(plan, at);
    snprintf(text, size, "%d ground motions.%s%s", study->suite->nrecords, *what ? " " : "", what);
    for (int a = 0; a < plan->naxes && plan->naxes > 1; a++)
        thud_append(text, size, "%s%s = %s", a ? ", " : " Where not varied: ", plan->axis[a].key,
                    plan->axis[a].text[at[a]]);
    if (plan->naxes > 1)
        thud_append(text, size, ".");
}

/* False: the event has no counts, as one that compares with case `none` has none of that case alone. */
static bool of_event(const struct thud_fragility_study *study, int event, struct thud_figure **out)
{
    struct thud_fragility_curve curve[THUD_VARY_MAX * (THUD_SWEEP_CASES_MAX + 1)];
    int n = 0;
    char text[384];
    for (size_t i = 0; i < study->n; i++) {
        const struct thud_fragility_line *line = &study->line[i];
        if (line->event == event && is_middle(study->suite->plan, line))
            curve[n++] = (struct thud_fragility_curve){line->axis, line->k, &line->fragility};
    }
    if (n == 0 || !out)
        return n > 0;
    note(study, thud_fragility_note(study->suite->ndraws), text, sizeof text);
    *out = thud_figure_of_fragility(study->suite->plan, study->event[event].text, curve, n, text);
    return true;
}

/* Makes figure `index` where `out` is not NULL; returns how many there are. */
static int figures(const struct thud_fragility_study *study, int index, struct thud_figure **out)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    int n = 0, at[THUD_VARY_MAX];
    char text[384];
    for (int e = 0; e < study->nevents; e++)
        n += of_event(study, e, n == index ? out : NULL);
    middle(plan, at);
    note(study, "", text, sizeof text);
    for (int a = 0; a < plan->naxes; a++)
        for (int k = 0; k < plan->ncases && thud_axis_is_intensity(&plan->axis[a]); k++)
            if (n++ == index && out)
                *out = thud_figure_of_ida(study->suite, a, k, at, text);
    return n;
}

int thud_fragility_figure_count(const struct thud_fragility_study *study)
{
    return figures(study, -1, NULL);
}

struct thud_figure *thud_fragility_figure(const struct thud_fragility_study *study, int index)
{
    struct thud_figure *figure = NULL;
    figures(study, index, &figure);
    return figure;
}
