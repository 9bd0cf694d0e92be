#include "plot/figures/figures_gap.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "study/scene/level.h"
#include "study/suite/suite.h"

enum { LEVELS_MAX = 256 };

/* Medians by level, with the band from 16 to 84 % of what is needed. false: out of memory. */
static bool add_levels(struct thud_panel *panel, const struct thud_gap_suite *suite)
{
    enum { MOST = LEVELS_MAX + THUD_STRUCTURES_MAX };
    double x[MOST], low[MOST], high[MOST], y[MOST];
    const struct thud_needed_gap *first = suite->gap[0];
    int n = first->nlevels < LEVELS_MAX ? first->nlevels : LEVELS_MAX, every = (n + 11) / 12;
    bool several = first->level[n - 1].interface != first->level[0].interface;
    for (int l = 0; l < n; l += every) {
        char text[40];
        const struct thud_gap_level *p = &first->level[l];
        int used = several ? snprintf(text, sizeof text, "%d: ", p->interface) : 0;
        thud_contact_pair_name(p->left_floor, p->right_floor, p->struck, text + used, sizeof text - (size_t)used);
        thud_panel_tick(panel, THUD_X, l + 1, text);
    }
    thud_panel_limits(panel, THUD_X, 0.5, n + 0.5);
    for (int rule = THUD_GAP_EXACT; rule < THUD_GAP_ASCE7; rule++) {
        struct thud_style style = {.kind = THUD_LINES_POINTS, .color = rule + 1, .wide = rule == THUD_GAP_EXACT};
        size_t m = 0;
        for (int l = 0; l < n; l++, m++) {
            struct thud_fractiles f;
            if (thud_gap_suite_fractiles(suite, 0, l, rule, &f, NULL) != THUD_OK)
                return false;
            if (l > 0 && first->level[l].interface != first->level[l - 1].interface) { /* no line to other buildings */
                x[m] = y[m] = low[m] = high[m] = NAN;
                m++;
            }
            x[m] = l + 1;
            y[m] = 100 * f.median;
            low[m] = 100 * f.p16;
            high[m] = 100 * f.p84;
        }
        if (isnan(y[0])) /* the rule has no value here */
            continue;
        if (rule == THUD_GAP_EXACT && !isnan(low[0])) /* there are fractiles */
            thud_panel_fill(panel, (struct thud_style){.color = 0, .thin = true}, "needed", m, x, low, high);
        thud_panel_add(panel, style, thud_gap_rule_at(rule)->name, m, x, y);
    }
    return true;
}

/* Wilson's 90 % band of the share at each of the n + 1 steps, from x[i] to x[i + 1]. */
static void add_band(struct thud_panel *panel, size_t n, double independent, const double *x)
{
    struct thud_series *band =
        thud_panel_fill(panel, (struct thud_style){.color = 0, .thin = true}, "needed", 2 * (n + 1), NULL, NULL, NULL);
    for (size_t i = 0; band && i < 2 * (n + 1); i++) {
        band->x[i] = x[(i + 1) / 2];
        thud_share_band(i / 2, n, independent, &band->y[i], &band->y_high[i]);
        band->y[i] *= 100;
        band->y_high[i] *= 100;
    }
}

/* Share of the ground motions whose widest value is at most the gap, as steps. */
static bool add_shares(struct thud_panel *panel, const struct thud_gap_suite *suite)
{
    size_t n = (size_t)suite->nrecords;
    const int draws = suite->recordings;
    double most = 0, *x = malloc(2 * (n + 2) * sizeof *x), *y = x ? x + n + 2 : NULL;
    if (!x)
        return false;
    for (size_t r = 0; r < n; r++)
        most = fmax(most, thud_needed_gap_widest(suite->gap[r], 0, THUD_GAP_ABS, NULL));
    for (int rule = THUD_GAP_EXACT; rule < THUD_GAP_ASCE7; rule++) {
        struct thud_style style = {.kind = THUD_STEPS, .color = rule + 1, .wide = rule == THUD_GAP_EXACT};
        bool missing = false;
        x[0] = 0;
        for (size_t r = 0; r < n; r++) {
            x[r + 1] = 100 * thud_needed_gap_widest(suite->gap[r], 0, rule, NULL);
            missing = missing || isnan(x[r + 1]);
        }
        if (missing) /* the rule has no value for every motion */
            continue;
        x[n + 1] = 100 * most * 1.02;
        thud_sort_numbers(x + 1, n);
        for (size_t i = 0; i < n + 2; i++)
            y[i] = 100.0 * (double)(i < n ? i : n) / (double)n;
        if (rule == THUD_GAP_EXACT && draws >= THUD_SHARES_LEAST)
            add_band(panel, n, (double)draws / (double)n, x);
        thud_panel_add(panel, style, thud_gap_rule_at(rule)->name, n + 2, x, y);
    }
    free(x);
    return true;
}

struct thud_figure *thud_figure_of_gaps(const struct thud_gap_suite *suite, const char *title)
{
    char text[384], note[256];
    snprintf(text, sizeof text, "Required gap: %.300s", title);
    struct thud_figure *figure = thud_figure_create("needed-gap", text, 1, 2);
    struct thud_panel *height = thud_figure_panel(figure, 0, 0, suite->nrecords > 1 ? "By level: medians" : "By level"),
                      *share = thud_figure_panel(figure, 0, 1, "Ground motions that a gap keeps apart");
    thud_panel_axis(height, THUD_X, "Floors, left-right", "");
    thud_panel_axis(height, THUD_Y, "Gap", "cm");
    thud_panel_limits(height, THUD_Y, 0, NAN);
    thud_panel_axis(share, THUD_X, "Gap", "cm");
    thud_panel_share_axis(share, THUD_Y, "Share of ground motions");
    if (figure && !(add_levels(height, suite) && add_shares(share, suite)))
        figure->failed = true;
    bool several = suite->nrecords > 1;
    snprintf(
        note, sizeof note,
        "%d ground motion%s. needed: exact, from the motion without pounding%s. ASCE 7-16 12.12.3 is SRSS; EN 1998-1 "
        "4.4.2.7(3) takes 0.7 of it where all floor elevations are the same.",
        suite->nrecords, several ? "s" : "",
        suite->recordings >= THUD_SHARES_LEAST ? " (shaded: enough for 16 to 84 %; of the share 90 %, Wilson)" : "");
    thud_figure_note(figure, note);
    return figure;
}
