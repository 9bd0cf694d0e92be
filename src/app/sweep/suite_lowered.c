/* Which responses bumper and links lower, and under how many of the ground motions of a suite: words and a figure. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/result_table.h"
#include "app/sweep/fragility_report.h"
#include "plot/figures/figures_case.h"

enum { SHOWN_MAX = 3 };
static const double rounding = 1e-9;      /* of a median of 1 */
static const double from_nothing = 1e100; /* the ratio to 0: larger than any other, and still a number */

/* A case other than none at one setting; of a bumper where the links alone are varied at any of them. */
struct measure {
    int k;
    long setting;
    char column[128], name[128]; /* "22 cm" of its case, "bumper at 22 cm"; "tie (500 MN/m)" */
};
enum { MEASURES_MAX = SHOWN_MAX * (THUD_CASES + 1), NAMED_MAX = 128 };

/* A response of a structure, or of all of them (-1). */
struct response {
    enum thud_measure measure;
    int structure;
    char name[NAMED_MAX];
};

struct compared {
    const struct thud_suite *suite;
    int none, nmeasures, nresponses;
    struct measure measure[MEASURES_MAX];
    struct response response[THUD_MEASURES * THUD_STRUCTURES_MAX];
    struct thud_fractiles of[THUD_MEASURES * THUD_STRUCTURES_MAX][MEASURES_MAX]; /* over case none */
};

/* Of a response over that of case none: under how many ground motions it is lower and higher; 0 over 0 is equal. */
static struct thud_fractiles ratio_of(const struct compared *c, const struct measure *m, const struct response *x,
                                      double *room)
{
    const struct thud_suite *suite = c->suite;
    size_t n = 0;
    for (int r = 0; r < suite->nrecords; r++) {
        double with = thud_suite_value(suite, r, m->setting, m->k, x->measure, x->structure),
               without = thud_suite_value(suite, r, m->setting, c->none, x->measure, x->structure);
        if (isnan(with) || isnan(without))
            continue;
        room[n++] = without > 0 ? with / without : with > 0 ? from_nothing : 1;
    }
    return thud_fractiles_of(room, n, suite->ndraws, 1);
}

/* ---- what is compared ---- */

/* What the link is at a setting: a spring without stiffness is its dashpot. */
static const char *link_word(const struct thud_sweep_plan *plan, long setting)
{
    const struct thud_link *link = &plan->scene.link[0];
    double stiffness = link->stiffness_npm;
    int at[THUD_VARY_MAX];
    if (plan->scene.nlinks != 1)
        return "links";
    if (link->law != THUD_LINK_SPRING)
        return link->law == THUD_LINK_DASHPOT ? "damper" : thud_link_law_name(&plan->scene, 0);
    thud_sweep_place(plan, setting, at);
    for (int a = 0; a < plan->naxes; a++)
        if (strcmp(plan->axis[a].key, "links.1.stiffness") == 0)
            stiffness = plan->axis[a].value[at[a]];
    return stiffness > 0 ? "tie" : "damper";
}

static bool varies_links_alone(const struct thud_sweep_plan *plan)
{
    for (int a = 0; a < plan->naxes; a++)
        if (strncmp(plan->axis[a].key, "links.", 6) != 0)
            return false;
    return true;
}

static void add_measure(struct compared *c, int k, long setting)
{
    const struct thud_sweep_plan *plan = c->suite->plan;
    struct measure *m = &c->measure[c->nmeasures++];
    const bool link = plan->cases[k] == THUD_CASE_LINK, alone = varies_links_alone(plan), varied = plan->naxes > 0;
    const char *word = link ? link_word(plan, setting) : thud_case_name(plan->cases[k]);
    char at[80];
    int place[THUD_VARY_MAX];
    *m = (struct measure){.k = k, .setting = setting};
    thud_sweep_place(plan, setting, place);
    thud_sweep_setting(plan, plan->naxes, place, -1, false, at, sizeof at);
    if (!varied || (alone && !link))
        snprintf(m->name, sizeof m->name, "%s", word);
    else
        snprintf(m->name, sizeof m->name, link ? "%s (%s)" : "%s at %s", word, at);
    snprintf(m->column, sizeof m->column, "%s", link || (alone && varied) ? m->name : at);
}

/* The setting between the first and the last that is shown: the preset's own, where it is one, else the middle. */
static long middle_setting(const struct thud_suite *suite)
{
    const struct thud_sweep_plan *plan = suite->plan;
    int at[THUD_VARY_MAX] = {0};
    bool own = true;
    for (int a = 0; a < plan->naxes; a++) {
        at[a] = plan->axis[a].own;
        own &= at[a] >= 0;
    }
    const long setting = own ? thud_suite_setting(plan, at) : 0;
    return setting > 0 && setting < suite->settings - 1 ? setting : (suite->settings - 1) / 2;
}

static void add_response(struct compared *c, enum thud_measure measure, int structure, double *room)
{
    const struct thud_structure *own = &c->suite->plan->scene.structure[structure < 0 ? 0 : structure];
    struct response *x = &c->response[c->nresponses];
    if (structure >= 0 && own->kind == THUD_WALL)
        return;
    *x = (struct response){.measure = measure, .structure = structure};
    snprintf(x->name, sizeof x->name, structure < 0 ? "%s" : "%s of %s", thud_measure_info(measure)->words, own->name);
    for (int i = 0; i < c->nmeasures; i++)
        c->of[c->nresponses][i] = ratio_of(c, &c->measure[i], x, room);
    c->nresponses++;
}

/* Of every case at up to three settings: the first, the preset's own or the middle, the last. NULL: out of memory. */
static struct compared *compare(const struct thud_suite *suite)
{
    const struct thud_sweep_plan *plan = suite->plan;
    const int nshown = suite->settings < SHOWN_MAX ? (int)suite->settings : SHOWN_MAX;
    const long shown[SHOWN_MAX] = {0, nshown < SHOWN_MAX ? suite->settings - 1 : middle_setting(suite),
                                   suite->settings - 1};
    struct compared *c = calloc(1, sizeof *c);
    double *room = malloc((size_t)suite->nrecords * sizeof *room);
    enum thud_measure told[THUD_MEASURES];
    if (!c || !room) {
        free(c);
        free(room);
        return NULL;
    }
    c->suite = suite;
    c->none = -1;
    for (int k = 0; k < plan->ncases; k++)
        c->none = plan->cases[k] == THUD_CASE_NONE ? k : c->none;
    for (int k = 0; c->none >= 0 && k < plan->ncases; k++) {
        const bool once = plan->cases[k] != THUD_CASE_LINK && varies_links_alone(plan);
        for (int i = 0; k != c->none && i < (once ? 1 : nshown); i++)
            add_measure(c, k, shown[i]);
    }
    const int n = thud_measures_told(THUD_TOLD_BY_LOWERED, suite->features, told);
    for (int i = 0; i < n; i++)
        for (int s = thud_measure_info(told[i])->of_structure ? 0 : -1; s < 0 || s < suite->nstructures; s++) {
            add_response(c, told[i], s, room);
            if (s < 0)
                break;
        }
    free(room);
    return c;
}

/* ---- words ---- */

/* "0.860 3 0 0": the median, and under how many motions it is lower, equal and higher. */
static void put_cell(const struct thud_fractiles *r, int width, struct thud_text *out)
{
    char cell[80] = "-", median[24] = "from 0";
    if (r->n > 0 && r->median < sqrt(from_nothing))
        snprintf(median, sizeof median, "%.3f", r->median);
    if (r->n > 0)
        snprintf(cell, sizeof cell, "%s %2zu %2zu %2zu", median, r->below, r->n - r->below - r->above, r->above);
    thud_text_append(out, " %*s", width, cell);
}

static void put_case(const struct compared *c, int k, struct thud_text *out)
{
    int width = 28, cell = 16, columns = 0;
    for (int i = 0; i < c->nmeasures; i++)
        if (c->measure[i].k == k) {
            cell = thud_text_wider(cell, c->measure[i].column);
            columns++;
        }
    if (width + columns * (cell + 1) > THUD_LINE_WIDTH)
        width = 20;
    for (int q = 0; q < c->nresponses; q++)
        width = thud_text_wider(width, c->response[q].name);
    thud_text_append(out, "\n%s over none: geometric median ratio, and motions lower, equal, higher\n%*s",
                     thud_case_name(c->suite->plan->cases[k]), width, "");
    for (int i = 0; i < c->nmeasures; i++)
        if (c->measure[i].k == k)
            thud_text_append(out, " %*s", cell, c->measure[i].column);
    thud_text_append(out, "\n");
    for (int q = 0; q < c->nresponses; q++) {
        thud_text_padded(out, c->response[q].name, width);
        for (int i = 0; i < c->nmeasures; i++)
            if (c->measure[i].k == k)
                put_cell(&c->of[q][i], cell, out);
        thud_text_append(out, "\n");
    }
}

/* Whether one lowers a response more: in the median, and where that is the same under the worse motions. */
static bool is_better(const struct thud_fractiles *a, const struct thud_fractiles *b)
{
    if (a->n == 0 || b->n == 0)
        return a->n > 0;
    return a->median < b->median || (a->median == b->median && (a->p84 < b->p84 || a->most < b->most));
}

/* "mean drift of A: damper (0 MN/m), 0.789 in the median, lower under 8 of 8 motions" */
static void put_best(const struct compared *c, int q, struct thud_text *out)
{
    static const struct thud_fractiles no_motion = {.n = 0};
    const struct thud_fractiles *best = &no_motion;
    for (int i = 0; i < c->nmeasures; i++)
        best = is_better(&c->of[q][i], best) ? &c->of[q][i] : best;
    if (best->n == 0)
        return;
    struct thud_text words = {0};
    if (best->median < 1 - rounding)
        thud_text_append(&words, "%s: %s, geometric median ratio %.3f, lower under %zu of %zu motions",
                         c->response[q].name, c->measure[best - c->of[q]].name, best->median, best->below, best->n);
    else
        thud_text_append(&words, "%s: none of them lowers the median", c->response[q].name);
    thud_table_words(out, "  ", &words, 4);
}

/* Which of bumper and links lowers what most, and how much each lowers at all. */
static void put_bests(const struct compared *c, struct thud_text *out)
{
    thud_text_append(out, "\nIn the geometric median over %d motions, of %d responses\n", c->suite->nrecords,
                     c->nresponses);
    for (int i = 0; i < c->nmeasures; i++) {
        int lowers = 0;
        for (int q = 0; q < c->nresponses; q++)
            lowers += c->of[q][i].median < 1 - rounding;
        thud_text_append(out, "  %s lowers %d\n", c->measure[i].name, lowers);
    }
    thud_text_append(out, "What lowers each response most:\n");
    for (int q = 0; q < c->nresponses; q++)
        put_best(c, q, out);
}

enum thud_status thud_suite_lowered(const struct thud_suite *suite, struct thud_text *out, struct thud_error *err)
{
    const struct thud_sweep_plan *plan = suite->plan;
    struct compared *c = compare(suite);
    if (!c)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int k = 0; k < plan->ncases && c->nmeasures > 0; k++)
        if (k != c->none)
            put_case(c, k, out);
    for (int k = 0; k < plan->ncases && c->nmeasures > 0; k++)
        if (plan->cases[k] == THUD_CASE_LINK)
            put_bests(c, out);
    free(c);
    return THUD_OK;
}

/* ---- the figure ---- */

enum { FROM, TO, NOTHING, PIECE }; /* of a level line: its ends, and a break */

/* Shares by response with Wilson's 90 % bands, and medians with what 16 to 84 % of the motions give, of one measure. */
static void draw_measure(const struct compared *c, int i, struct thud_panel *ratios, struct thud_panel *shares)
{
    static const double broad = 0.6, most_shown = 1e3;
    const struct measure *m = &c->measure[i];
    const size_t rows = (size_t)c->nresponses;
    struct thud_style style = {.kind = THUD_LINES, .color = thud_case_color(c->suite->plan->cases[m->k])};
    for (int k = i; k >= 0 && c->measure[k].k == m->k; k--) /* one colour for a case, a size for each setting */
        style.rank++;
    struct thud_series *spread = thud_panel_add(ratios, style, "", PIECE * rows, NULL, NULL);
    struct thud_series *band = thud_panel_add(shares, style, "", PIECE * rows, NULL, NULL);
    style.kind = THUD_POINTS;
    struct thud_series *median = thud_panel_add(ratios, style, m->name, rows, NULL, NULL);
    struct thud_series *share = thud_panel_add(shares, style, m->name, rows, NULL, NULL);
    for (size_t row = 0; share && row < rows; row++) {
        const struct thud_fractiles r = c->of[row][i];
        const bool shown = r.n > 0 && r.median < most_shown, ends = shown && r.p84 < most_shown;
        const double level = (double)(rows - row) + broad * (0.5 - (i + 0.5) / c->nmeasures);
        spread->x[PIECE * row + FROM] = ends ? r.p16 : NAN;
        spread->x[PIECE * row + TO] = ends ? r.p84 : NAN;
        thud_suite_share_band(c->suite, r.below, r.n, &band->x[PIECE * row + FROM], &band->x[PIECE * row + TO]);
        for (size_t k = FROM; k < PIECE; k++) {
            spread->y[PIECE * row + k] = band->y[PIECE * row + k] = k == NOTHING ? NAN : level;
            band->x[PIECE * row + k] *= 100;
        }
        median->x[row] = shown ? r.median : NAN;
        share->x[row] = r.n > 0 ? 100.0 * (double)r.below / (double)r.n : NAN;
        median->y[row] = share->y[row] = level;
    }
}

static void add_rows(const struct compared *c, struct thud_panel *panel)
{
    for (int q = 0; q < c->nresponses; q++)
        thud_panel_tick(panel, THUD_Y, c->nresponses - q, c->response[q].name);
    thud_panel_axis(panel, THUD_Y, "", "");
    thud_panel_limits(panel, THUD_Y, 0.5, c->nresponses + 0.5);
    thud_panel_results_on_x(panel);
}

struct thud_figure *thud_suite_lowered_figure(const struct thud_suite *suite)
{
    struct compared *c = compare(suite);
    struct thud_figure *figure = NULL;
    char title[96];
    if (c && c->nmeasures > 0) {
        snprintf(title, sizeof title, "What lowers which response, over %d ground motion%s", suite->nrecords,
                 suite->nrecords == 1 ? "" : "s");
        figure = thud_figure_create("lowered", title, 1, 2);
        struct thud_panel *ratios = thud_figure_panel(figure, 0, 0, "Ratio to neither bumper nor link"),
                          *shares = thud_figure_panel(figure, 0, 1, "Ground motions under which it is lower");
        add_rows(c, ratios);
        add_rows(c, shares);
        thud_panel_axis(ratios, THUD_X, "Ratio", "");
        thud_panel_share_axis(shares, THUD_X, "Share");
        thud_panel_mark(ratios, THUD_X, 0, 1, "");
        thud_panel_mark(ratios, THUD_X, 1, 1, "");
        for (int i = 0; i < c->nmeasures; i++)
            draw_measure(c, i, ratios, shares);
        thud_figure_note(
            figure, suite->ndraws < THUD_SHARES_LEAST
                        ? "Geometric medians over the ground motions as points; shaded: lower."
                        : "Geometric medians over the ground motions as points, 16 to 84 % as lines; shaded: lower. "
                          "Lines of the shares: 90 % bands (Wilson).");
    }
    free(c);
    return figure;
}
