/* The section over several ground motions: how many pound, which gap they require, and what the bumper does under each.
 * It also states how likely that is under weaker or stronger motions. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/report/site_report_private.h"
#include "app/run/summary_line.h"
#include "app/sweep/sweep_jobs.h"
#include "ground/identity.h"
#include "plot/figures/figures_fragility.h"
#include "plot/figures/figures_gap.h"
#include "study/scene/scene_elements.h"
#include "study/suite/scaling.h"

/* The motions are run at these multiples of what was given, so that a fragility curve has points on both sides. */
static const char scales[] = "record.factor=0.25,0.5,0.75,1,1.25,1.5,2";
enum { AS_GIVEN = 3, BOOTSTRAP = 200 };

/* ---- the runs ---- */

void thud_site_plan(const struct site *site, const struct thud_scene *scene, struct thud_sweep_plan *plan)
{
    thud_sweep_plan_init(plan, scene);
    plan->scene.record.factor = 1;
    plan->record =
        site->suite.leads ? (const struct thud_record *const *)site->options->records->record : &site->record;
    plan->nrecords = site->suite.leads ? site->options->records->n : site->record != NULL;
}

static enum thud_status make_plan(struct site *site, struct thud_error *err)
{
    struct site_suite *suite = &site->suite;
    thud_site_plan(site, site->scene, &suite->plan);
    enum thud_status status = suite->leads ? thud_sweep_vary(&suite->plan, scales, err) : THUD_OK;
    char cases[64] = "";
    for (int i = SITE_NONE; i < site->ncases; i++) {
        const enum thud_case which = site->cases[i].which;
        thud_append(cases, sizeof cases, "%s%s", i > SITE_NONE ? "," : "",
                    thud_case_name(which == THUD_CASE_WHOLE ? THUD_CASE_AS_WRITTEN : which));
    }
    return status == THUD_OK ? thud_sweep_cases(&suite->plan, cases, err) : status;
}

int thud_site_suite_jobs(const struct site *site)
{
    const int ncases = site->suite.plan.ncases;
    return site->suite.leads ? ncases + (ncases > 1) : 0;
}

enum thud_status thud_site_suite_job(struct site *site, int job, struct thud_error *err)
{
    struct site_suite *suite = &site->suite;
    const bool worse = job == suite->plan.ncases;
    const struct thud_fragility_ask ask = {.event = worse ? &suite->worse : &suite->pounding,
                                           .k = worse ? job - 1 : job,
                                           .samples = BOOTSTRAP,
                                           .seed = site->options->seed,
                                           .first_contact = true};
    return thud_fragility_make(suite->runs, &ask, worse ? &suite->worsens : &suite->pounds[job], err);
}

enum thud_status thud_site_suite_run(struct site *site, struct thud_error *err)
{
    struct site_suite *suite = &site->suite;
    const atomic_int *cancel = site->options->pictures ? site->options->pictures->cancel : NULL;
    suite->leads = site->options->records->n > 1 && site->gap->nlevels > 0;
    enum thud_status status = make_plan(site, err);
    if (status == THUD_OK)
        status = thud_sweep_suite_run(&suite->plan, site->options->threads, cancel, &suite->runs, err);
    if (status == THUD_OK && !(suite->room = malloc((size_t)suite->runs->nrecords * sizeof *suite->room)))
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    suite->as_given = thud_suite_setting(&suite->plan, (const int[THUD_VARY_MAX]){AS_GIVEN});
    thud_event_parse("pounding", &suite->pounding, NULL);
    thud_event_parse("worse", &suite->worse, NULL);
    return status;
}

void thud_site_suite_clear(struct site *site)
{
    struct site_suite *suite = &site->suite;
    for (size_t k = 0; k < sizeof suite->pounds / sizeof *suite->pounds; k++)
        thud_fragility_clear(&suite->pounds[k]);
    thud_fragility_clear(&suite->worsens);
    thud_suite_free(suite->runs);
    thud_sweep_plan_clear(&suite->plan);
    free(suite->room);
}

/* Statistics of one measure of a case over the unscaled motions. */
static struct thud_fractiles over(const struct site *site, int k, enum thud_measure measure, int structure,
                                  double limit)
{
    const struct site_suite *suite = &site->suite;
    return thud_suite_fractiles(suite->runs, suite->as_given, k, measure, structure, limit, suite->room);
}

double thud_site_suite_median(const struct site *site, const struct thud_quantity_of_run *quantity)
{
    const struct thud_sweep_plan *plan = &site->suite.plan;
    struct thud_fractiles f = {.median = NAN};
    int k = quantity->which == THUD_CASE_AS_WRITTEN || thud_quantity_is_ratio(quantity) ? plan->ncases - 1 : -1;
    for (int i = 0; i < plan->ncases && k < 0; i++)
        k = plan->cases[i] == quantity->which ? i : k;
    if (quantity->measure == THUD_MEASURE_GAP)
        return thud_gap_suite_fractiles(&site->gaps.suite, 0, -1, THUD_GAP_EXACT, &f, NULL) == THUD_OK ? f.median : NAN;
    return k < 0 ? NAN : over(site, k, quantity->measure, quantity->structure, 0).median;
}

/* ---- the result ---- */

/* Whether contact in case k is with the bumper, and nothing else tells it from case none. */
static bool touches(const struct site *site, int k)
{
    return k > 0 && thud_scene_measures(site->scene) == THUD_HAS_BUMPER;
}

/* How many of the motions pound in case k, and the factors on them at which that begins. */
static void add_pounding_row(struct site *site, int k)
{
    const struct thud_fractiles f = over(site, k, THUD_MEASURE_IMPACTS, -1, 0);
    const struct thud_fragility *pounds = &site->suite.pounds[k];
    const size_t n = (size_t)pounds->nexact;
    double low, high, at[3] = {NAN, NAN, NAN};
    char band[32] = "-";
    thud_suite_share_band(site->suite.runs, f.above, f.n, &low, &high);
    if (!isnan(low))
        snprintf(band, sizeof band, "%.0f to %.0f", 100 * low, 100 * high);
    thud_document_cells(&site->document, "%s%s\t%zu of %zu\t%.0f\t%s", site->cases[SITE_NONE + k].words,
                        touches(site, k) ? ", which is struck" : "", f.above, f.n, 100 * f.share, band);
    if (n > 0) {
        size_t half;
        at[0] = pounds->exact[0];
        at[1] = thud_enough(pounds->exact, n, 0.5, &half);
        at[2] = pounds->exact[n - 1];
    }
    for (int i = 0; i < 3; i++)
        thud_document_cell(&site->document, isfinite(at[i]) ? "%.2f" : "-", at[i]);
    thud_document_row(&site->document);
}

static void add_pounding(struct site *site)
{
    struct thud_document *d = &site->document;
    thud_document_table(d,
                        "Pounding over the suite at the given gap, and the factor on the motions at which it begins");
    thud_document_head(d, "case|motions|share %|90 % band|first: factor|half|all");
    for (int k = 0; k < site->suite.plan.ncases; k++)
        add_pounding_row(site, k);
    thud_document_paragraph(d, "Factors are those of first contact, %s.",
                            thud_scene_scales(site->scene) ? "exact: each motion has one at which contact begins"
                                                           : "by runs");
    for (int k = 0; k < site->suite.plan.ncases; k++) {
        const struct thud_fragility *f = &site->suite.pounds[k];
        double clear = INFINITY;
        for (int r = 0; r < f->nexact; r++)
            clear = fmin(clear, f->contact[r].clear_again);
        if (f->clearing > 0)
            thud_document_item(d,
                               "Under %d of the motions the buildings are clear of each other again %s at a larger "
                               "factor, the smallest being %.2f.",
                               f->clearing, site->cases[SITE_NONE + k].words, clear);
    }
}

static void say_widths(struct site *site)
{
    struct thud_document *d = &site->document;
    struct thud_fractiles f;
    if (thud_gap_suite_fractiles(&site->gaps.suite, 0, -1, THUD_GAP_EXACT, &f, NULL) != THUD_OK) {
        d->failed = true;
        return;
    }
    char most84[64] = "";
    if (!isnan(f.p84))
        snprintf(most84, sizeof most84, "%zu of them up to %.1f cm, ", f.most84, thud_summary_gap_cm(f.p84));
    thud_document_item(d,
                       "To prevent contact, %zu of the motions require a gap of up to %.1f cm between the bare faces, "
                       "%sand all of them %.1f cm.",
                       f.half, thud_summary_gap_cm(f.median), most84, thud_summary_gap_cm(f.most));
}

/* What case k makes of the mean acceleration, or drift, of structure s over the motions. */
static struct thud_fractiles ratios(const struct site *site, int k, int s, bool drift)
{
    return over(site, k, drift ? THUD_MEASURE_DRIFT_RATIO : THUD_MEASURE_ACCELERATION_RATIO, s, 1);
}

/* How many motions the measure of case k helps and harms. */
static void add_effect_row(struct site *site, int k, int s, bool drift)
{
    const struct thud_fractiles f = ratios(site, k, s, drift);
    if (f.n > 0)
        thud_document_line(&site->document, "%s: mean %s of %s\t%zu\t%zu\t%s\t%s\t%s",
                           site->cases[SITE_NONE + k].measure, drift ? "drift" : "acceleration",
                           thud_site_name(site, s), f.below, f.above, thud_site_number(f.p16, 3).text,
                           thud_site_number(f.median, 3).text, thud_site_number(f.p84, 3).text);
}

void thud_site_suite_summary(struct site *site)
{
    if (!site->suite.leads)
        return;
    char caption[160];
    add_pounding(site);
    say_widths(site);
    snprintf(caption, sizeof caption,
             "Number of the %d motions under which a response is lower or higher, and its ratio to %s",
             site->suite.runs->nrecords, site->cases[SITE_NONE].name);
    thud_document_table(&site->document, caption);
    thud_document_head(&site->document, "response|lower|higher|16 %|geometric median|84 %");
    for (int k = 1; k < site->suite.plan.ncases; k++)
        for (int s = 0; s < site->scene->nstructures; s++)
            for (int drift = 0; drift < 2; drift++)
                if (drift ? thud_site_is_building(site, s) : site->scene->structure[s].kind != THUD_WALL)
                    add_effect_row(site, k, s, drift);
}

/* ---- the verdicts ---- */

/* Under how many motions the gaps of an interface (from 1) are used up when nothing else touches. */
static int used_up(const struct site *site, int interface)
{
    int n = 0;
    for (int r = 0; r < site->gaps.suite.nrecords; r++) {
        const struct thud_needed_gap *gap = site->gaps.gap[r];
        bool used = false;
        for (int l = 0; l < gap->nlevels; l++) {
            const struct thud_level_values at =
                thud_interface_level(&site->scene->interface[interface - 1], thud_needed_gap_level(gap->level, l));
            used = used || (gap->level[l].interface == interface &&
                            thud_gap_falls_short(thud_level_clearance(&at), gap->level[l].relative_displacement_m));
        }
        n += used;
    }
    return n;
}

static void gap_verdict(struct site *site, int i)
{
    const struct thud_interface *f = &site->scene->interface[i - 1];
    const double required = thud_site_gap_by_code(site, &site->gaps, site->scene->nstructures, i);
    const double out = thud_interface_projection(f, NULL);
    struct thud_fractiles exact;
    char what[200], text[600], given[64], from[240], bumper[64] = "";
    if (!(required >= 0))
        return;
    if (thud_gap_suite_fractiles(&site->gaps.suite, i, -1, THUD_GAP_EXACT, &exact, NULL) != THUD_OK) {
        site->document.failed = true;
        return;
    }
    snprintf(what, sizeof what, "gap between %.60s and %.60s", thud_site_name(site, i - 1), thud_site_name(site, i));
    thud_interface_gap_text(f, given, sizeof given);
    if (out > 0)
        snprintf(bumper, sizeof bumper, ", %.1f cm with the bumper between them", thud_summary_gap_cm(required + out));
    snprintf(
        text, sizeof text,
        "%s given; %.1f cm required between bare faces by %s%s. The exact gap is %.1f cm for 50 %% of the motions, ",
        given, thud_summary_gap_cm(required), thud_site_gap_source(site, from, sizeof from), bumper,
        thud_summary_gap_cm(exact.median));
    if (!isnan(exact.p84))
        thud_append(text, sizeof text, "%.1f cm for 84 %%, ", thud_summary_gap_cm(exact.p84));
    thud_append(text, sizeof text, "%.1f cm for all; the given gap closes under %d of %d%s",
                thud_summary_gap_cm(exact.most), used_up(site, i), site->gaps.suite.nrecords,
                site->scene->nstructures > 2 ? ", when nothing else touches" : "");
    thud_site_verdict(site, what, text);
}

/* Of case k of the plan: how many motions, and the load case with the largest force. */
static void pounding_verdict(struct site *site, int k)
{
    char what[96], text[200];
    const struct thud_fractiles f = over(site, k, THUD_MEASURE_IMPACTS, -1, 0);
    int worst = 0;
    for (int r = 0; r < site->suite.runs->nrecords; r++) {
        site->suite.room[r] = thud_suite_value(site->suite.runs, r, site->suite.as_given, k, THUD_MEASURE_FORCE, -1);
        worst = site->suite.room[r] > site->suite.room[worst] || isnan(site->suite.room[worst]) ? r : worst;
    }
    const double most = site->suite.room[worst];
    snprintf(what, sizeof what, "pounding %s", site->cases[SITE_NONE + k].words);
    snprintf(text, sizeof text, "under %zu of %zu ground motions", f.above, f.n);
    if (most > 0)
        thud_append(text, sizeof text, "; at most %s MN, load case %d", thud_site_number(1e-6 * most, 3).text,
                    worst + 1);
    thud_site_verdict(site, what, text);
}

/* The mean accelerations, or drifts, that the measure of case k lowers and raises. */
static void measure_verdict(struct site *site, int k, bool drift)
{
    struct thud_text text = {0};
    for (int s = 0; s < site->scene->nstructures; s++) {
        if (drift ? !thud_site_is_building(site, s) : site->scene->structure[s].kind == THUD_WALL)
            continue;
        const struct thud_fractiles f = ratios(site, k, s, drift);
        if (f.n > 0)
            thud_text_append(&text, "%sof %s lower under %zu of %zu ground motions and higher under %zu",
                             text.size > 0 ? "; " : "", thud_site_name(site, s), f.below, f.n, f.above);
    }
    if (text.size > 0) {
        char what[96];
        snprintf(what, sizeof what, "mean %s %s", drift ? "drifts" : "accelerations", site->cases[SITE_NONE + k].words);
        thud_site_verdict(site, what, text.data);
    }
    site->document.failed = site->document.failed || text.failed;
    thud_text_clear(&text);
}

void thud_site_suite_verdicts(struct site *site)
{
    for (int i = 1; i < site->scene->nstructures; i++)
        gap_verdict(site, i);
    for (int k = 0; k < site->suite.plan.ncases; k++)
        pounding_verdict(site, k);
    for (int drift = 0; drift < 2 && site->suite.plan.ncases > 1; drift++)
        measure_verdict(site, site->suite.plan.ncases - 1, drift);
}

/* ---- its section ---- */

static void add_motions(struct site *site)
{
    struct thud_document *d = &site->document;
    const struct site_suite *suite = &site->suite;
    int ncases = suite->plan.ncases;
    char caption[96] = "Ground motions as specified";
    if (ncases > 1)
        snprintf(caption, sizeof caption,
                 "Ground motions as specified; ratio: mean accelerations of %c over those of %c",
                 thud_site_letter(site->ncases - 1), thud_site_letter(SITE_NONE));
    thud_site_case_table(site, caption, SITE_NONE);
    thud_document_cells(d, "load case\tpeak g\tfactor\trequired gap cm");
    for (int k = 0; k < ncases; k++)
        thud_document_cell(d, "%c: force MN", thud_site_letter(SITE_NONE + k));
    for (int s = 0; s < site->scene->nstructures && ncases > 1; s++)
        if (site->scene->structure[s].kind != THUD_WALL)
            thud_document_cell(d, "ratio of %s", thud_site_name(site, s));
    thud_document_row(d);
    for (int r = 0; r < suite->runs->nrecords; r++) {
        thud_document_cells(d, "%d\t%.3f\t%.4g\t%.1f", r + 1, thud_record_peak(suite->plan.record[r]) / THUD_GRAVITY,
                            suite->plan.record[r]->scale,
                            thud_summary_gap_cm(thud_needed_gap_widest(site->gaps.gap[r], 0, THUD_GAP_EXACT, NULL)));
        for (int k = 0; k < ncases; k++)
            thud_document_cell(
                d, "%s",
                thud_site_number(1e-6 * thud_suite_value(suite->runs, r, suite->as_given, k, THUD_MEASURE_FORCE, -1), 3)
                    .text);
        for (int s = 0; s < site->scene->nstructures && ncases > 1; s++) {
            double ratio =
                thud_suite_value(suite->runs, r, suite->as_given, ncases - 1, THUD_MEASURE_ACCELERATION_RATIO, s);
            if (site->scene->structure[s].kind != THUD_WALL)
                thud_document_cell(d, isnan(ratio) ? "-" : "%.3f", ratio);
        }
        thud_document_row(d);
    }
}

static void add_fractiles(struct site *site, enum thud_measure measure, int structure)
{
    struct thud_document *d = &site->document;
    const struct thud_measure_info *info = thud_measure_info(measure);
    const struct thud_site_unit unit = thud_site_unit(info->kind);
    thud_document_cell(d, "%s%s%s%s%s", info->words, structure >= 0 ? " of " : "",
                       structure >= 0 ? thud_site_name(site, structure) : "", *unit.name ? "," : "", unit.name);
    for (int k = 0; k < site->suite.plan.ncases; k++) {
        const struct thud_fractiles f = over(site, k, measure, structure, 0);
        thud_document_cells(d, "%s\t%s\t%s", thud_site_number(f.p16 / unit.size, 3).text,
                            thud_site_number(f.median / unit.size, 3).text,
                            thud_site_number(f.p84 / unit.size, 3).text);
    }
    thud_document_row(d);
}

/* The measures of a suite but for ratios, which stand in the results. */
static void add_statistics(struct site *site)
{
    struct thud_document *d = &site->document;
    enum thud_measure told[THUD_MEASURES];
    const int n = thud_measures_told(THUD_TOLD_BY_SUITE, site->suite.runs->features, told);
    thud_site_case_table(site, "Over the unscaled ground motions", SITE_NONE);
    thud_document_cell(d, "quantity");
    for (int k = SITE_NONE; k < site->ncases; k++)
        thud_document_cells(d, "%c: 16 %%\t%c: median\t%c: 84 %%", thud_site_letter(k), thud_site_letter(k),
                            thud_site_letter(k));
    thud_document_row(d);
    for (int i = 0; i < n; i++) {
        const struct thud_measure_info *info = thud_measure_info(told[i]);
        if (!info->of_structure)
            add_fractiles(site, told[i], -1);
        for (int s = 0; info->of_structure && !info->ratio_of && s < site->scene->nstructures; s++)
            if (site->scene->structure[s].kind != THUD_WALL)
                add_fractiles(site, told[i], s);
    }
}

static void add_figures(struct site *site)
{
    const struct site_suite *suite = &site->suite;
    struct thud_fragility_curve curve[SITE_CASES - SITE_NONE];
    const char *note = thud_fragility_note(suite->runs->ndraws);
    const int last = suite->plan.ncases - 1;
    char caption[240], ida[240], same[96];
    snprintf(caption, sizeof caption,
             "Number of motions under which the %s %s the mean acceleration of a building. A fraction that need not "
             "increase with the intensity has no curve.",
             site->own->measure, thud_site_verb(site->own, "raises").text);
    snprintf(ida, sizeof ida,
             "Peak drift %s against the scale factor applied to all motions: each of them, and their 16, 50 and 84 %% "
             "fractiles.",
             site->cases[SITE_NONE].words);
    snprintf(same, sizeof same, "Peak drift %s, likewise.", site->own->words);
    for (int k = 0; k < suite->plan.ncases; k++)
        curve[k] = (struct thud_fragility_curve){0, k, &suite->pounds[k]};
    thud_site_figure(
        site, thud_figure_of_gaps(&site->gaps.suite, site->scene->title), 0.62,
        "Required gap over the height, and the fraction of the ground motions for which a gap is sufficient.");
    thud_site_figure(site, thud_figure_of_fragility(&suite->plan, "pounding", curve, suite->plan.ncases, note), 0.62,
                     "Probability of pounding at this gap, against the scale factor applied to all motions.");
    int worse = 0;
    for (size_t i = 0; i < suite->worsens.n; i++)
        worse += suite->worsens.stripe[i].count;
    if (worse > 0) {
        curve[0] = (struct thud_fragility_curve){0, last, &suite->worsens};
        thud_site_figure(site, thud_figure_of_fragility(&suite->plan, "worse", curve, 1, note), 0.62, caption);
    } else if (last > 0) {
        thud_document_paragraph(
            &site->document,
            "At scale factors of 0.25 to 2, the %s %s the mean acceleration of a building under none of the motions.",
            site->own->measure, thud_site_verb(site->own, "raises").text);
    }
    for (int k = 0; k <= last; k += last > 0 ? last : 1)
        thud_site_figure(site, thud_figure_of_ida(suite->runs, 0, k, (const int[THUD_VARY_MAX]){0}, ""), 0.62,
                         k == 0 ? ida : same);
}

void thud_site_suite_section(struct site *site)
{
    struct thud_document *d = &site->document;
    char heading[64];
    if (!site->suite.leads)
        return;
    snprintf(heading, sizeof heading, "Over %d ground motion%s", site->suite.runs->nrecords,
             site->suite.runs->nrecords == 1 ? "" : "s");
    thud_document_heading(d, heading);
    site->suite.drawing = true;
    add_motions(site);
    add_statistics(site);
    const struct thud_suite *runs = site->suite.runs;
    thud_document_paragraph(d,
                            "16 %%, median and 84 %% are quantiles of the logarithms if every value is positive. The "
                            "motions are assumed to be independent and equally likely%s.",
                            runs->ndraws < runs->nrecords ? ", except that motions of one recording count as one" : "");
    thud_site_tell(site,
                   &(struct thud_remark_scope){.record = site->suite.plan.record,
                                               .target = site->options->target,
                                               .nrecords = site->suite.plan.nrecords},
                   THUD_REMARK_MOTIONS);
    if (runs->ndraws < THUD_DRAWS_LEAST)
        thud_document_paragraph(d, "There are too few motions for a band of %s.",
                                runs->ndraws < THUD_SHARES_LEAST ? "anything" : "a curve");
    add_figures(site);
}
