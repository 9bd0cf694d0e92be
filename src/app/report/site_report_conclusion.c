/* The conclusion of a report: the gap that the code asks for, and every criterion against its limit, with the load case
 * that governs it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/report/site_report_private.h"
#include "app/run/summary_line.h"
#include "ground/target.h"
#include "study/scene/level.h"

/* The criteria of every report whose scene has them; others stand there with a limit alone. */
static const enum thud_measure criteria[] = {THUD_MEASURE_DRIFT_ANGLE, THUD_MEASURE_DUCTILITY,
                                             THUD_MEASURE_COLUMNS,     THUD_MEASURE_STRAIN,
                                             THUD_MEASURE_FORCE,       THUD_MEASURE_ACCELERATION};

/* ---- what is asked for ---- */

enum thud_status thud_site_criteria_read(struct site *site, struct thud_error *err)
{
    const struct thud_target *target = site->options->target;
    const char *own = site->scene->document.code;
    site->code = thud_gap_practice_find(*own ? own : target ? thud_target_code(target)->name : "");
    if (!site->code)
        site->code = thud_gap_practice_find("en1998");
    enum thud_status status = thud_limits_parse(site->scene->document.limits, site->limit, err);
    return status == THUD_OK ? thud_limits_parse(site->options->limits, site->limit, err) : status;
}

/* ---- one number of several ground motions ---- */

double thud_site_decided(const struct site *site)
{
    const size_t n = (size_t)site->suite.runs->nrecords;
    double most = -INFINITY, sum = 0;
    size_t count;
    for (size_t r = 0; r < n; r++) {
        sum += site->suite.room[r];
        most = fmax(most, site->suite.room[r]);
    }
    if (isnan(sum))
        return NAN;
    if (!site->code->by_84)
        return thud_gap_suite_means(&site->gaps.suite, site->code->rule) ? sum / (double)n : most;
    const struct thud_fractiles f = thud_fractiles_of(site->suite.room, n, site->suite.runs->ndraws, 0);
    return isnan(f.p84) ? most : thud_enough(site->suite.room, n, 0.84, &count);
}

const char *thud_site_decided_words(const struct site *site, char *text, size_t size)
{
    const struct thud_gap_suite *suite = &site->gaps.suite;
    if (!site->code->by_84 || suite->recordings < THUD_SHARES_LEAST)
        return thud_site_displacements(site, site->code->rule, text, size);
    snprintf(text, size, "sufficient for 84 %% of %d ground motions", suite->nrecords);
    return text;
}

double thud_site_gap_by_code(const struct site *site, const struct thud_gap_study *gaps, int nstructures, int interface)
{
    struct thud_fractiles f;
    if (!site->code->by_84)
        return thud_site_ruled(gaps, nstructures, interface, site->code->rule).gap_m;
    if (thud_gap_suite_fractiles(&gaps->suite, interface, -1, THUD_GAP_EXACT, &f, NULL) != THUD_OK)
        return NAN;
    return isnan(f.p84) ? f.most : f.p84;
}

const char *thud_site_gap_source(const struct site *site, char *text, size_t size)
{
    const struct thud_gap_rule *rule = thud_gap_rule_at(site->code->rule);
    char of[80];
    thud_site_decided_words(site, of, sizeof of);
    if (site->code->by_84)
        snprintf(text, size, "the exact relative displacement, %s", of);
    else
        snprintf(text, size, "%s, %s, from %s", rule->edition, rule->clause, of);
    return text;
}

/* ---- the gap ---- */

static void recommend(struct site *site, int i)
{
    const double bare = thud_site_gap_by_code(site, &site->gaps, site->scene->nstructures, i);
    double least;
    const double out = thud_interface_projection(&site->scene->interface[i - 1], &least);
    char source[240], given[64], bumper[96] = "", rest[120] = "";
    int more = 0;
    if (!(bare >= 0))
        return;
    for (int r = 0; r < site->gaps.suite.nrecords; r++) /* of the rounded gap */
        more += thud_gap_falls_short(0.01 * ceil(100 * (bare + out) - 1e-9) - out,
                                     thud_needed_gap_widest(site->gaps.gap[r], i, THUD_GAP_EXACT, NULL));
    if (out > 0)
        snprintf(bumper, sizeof bumper, ", and %s cm for the %sprojection of the bumper",
                 thud_site_number(100 * out, 3).text, out > least ? "largest " : "");
    if (more > 0 && site->gaps.suite.nrecords > 1)
        snprintf(rest, sizeof rest, " %d of the %d ground motions require more.", more, site->gaps.suite.nrecords);
    else if (more > 0)
        snprintf(rest, sizeof rest, " This ground motion requires more.");
    thud_interface_gap_text(&site->scene->interface[i - 1], given, sizeof given);
    thud_document_paragraph(
        &site->document, "Recommended gap between %s and %s: %.0f cm (%.2f cm: %.2f cm by %s%s). Given: %s.%s%s",
        thud_site_name(site, i - 1), thud_site_name(site, i), ceil(100 * (bare + out) - 1e-9),
        thud_table_gap_cm(bare + out), thud_table_gap_cm(bare), thud_site_gap_source(site, source, sizeof source),
        bumper, given, rest, site->scene->nstructures > 2 ? " This applies if no other contact occurs." : "");
}

/* ---- the criteria ---- */

/* A limit of NaN: there is none. */
static void add_criterion(struct site *site, const char *limit, double value, double least, const char *shown, int r,
                          const char *section)
{
    struct thud_document *d = &site->document;
    const double ratio = least > 0 ? value / least : NAN;
    thud_document_cells(d, "%s\t%s\t%s\t%s", limit, shown, thud_site_number(ratio, 3).text,
                        isnan(least) || isnan(value) ? "-"
                        : value <= least             ? "yes"
                                                     : "no");
    if (site->record)
        thud_document_line(d, "%d\t%s", r + 1, section);
    else
        thud_document_line(d, "-\t%s", section);
}

static void gap_criterion(struct site *site, int i)
{
    const double out = thud_interface_projection(&site->scene->interface[i - 1], NULL);
    const double value = thud_site_gap_by_code(site, &site->gaps, site->scene->nstructures, i) + out;
    const struct thud_interface *f = &site->scene->interface[i - 1];
    char given[64], shown[32];
    double widest = -1, least, most;
    int governing = 0;
    if (!(value >= out))
        return;
    for (int r = 0; r < site->gaps.suite.nrecords; r++) {
        const double needed = thud_needed_gap_widest(site->gaps.gap[r], i, THUD_GAP_EXACT, NULL);
        governing = needed > widest ? r : governing;
        widest = fmax(widest, needed);
    }
    thud_interface_gaps(f, &least, &most);
    thud_interface_gap_text(f, given, sizeof given);
    snprintf(shown, sizeof shown, "%.2f cm", thud_table_gap_cm(value));
    thud_document_cell(&site->document, "gap between %s and %s", thud_site_name(site, i - 1), thud_site_name(site, i));
    add_criterion(site, given, value, least, shown, governing, "#Required gap");
}

/* In the unit of documents. */
static const char *value_text(const struct thud_measure_info *info, double value, char *text, size_t size)
{
    const struct thud_site_unit unit = thud_site_unit(info->kind);
    snprintf(text, size, "%s%s", thud_site_number(value / unit.size, 3).text, isnan(value) ? "" : unit.name);
    return text;
}

/* Of the scene as written, the largest of its structures. */
static void criterion(struct site *site, enum thud_measure measure)
{
    const struct thud_measure_info *info = thud_measure_info(measure);
    const struct thud_event *limit = &site->limit[measure];
    const int own = site->suite.plan.ncases - 1;
    double *room = site->suite.room;
    char shown[32];
    int governing = 0;
    bool any = false;
    for (int r = 0; r < site->suite.runs->nrecords; r++) {
        room[r] = thud_suite_value(site->suite.runs, r, site->suite.as_given, own, measure, -1);
        governing = room[r] > room[governing] || isnan(room[governing]) ? r : governing;
        any = any || !isnan(room[r]);
    }
    if (!any && !*limit->text)
        return;
    const double value = thud_site_decided(site);
    thud_document_cell(&site->document, "%s", info->words);
    add_criterion(site, *limit->text ? limit->text + strcspn(limit->text, ":=") + 1 : "no limit given", value,
                  *limit->text ? limit->limit : NAN, value_text(info, value, shown, sizeof shown), governing,
                  "#Results");
}

/* Whether a measure stands among the criteria: always, unless another of its name has the limit, or by its limit. */
static bool is_criterion(const struct site *site, enum thud_measure measure)
{
    const char *word = thud_measure_info(measure)->event.word;
    bool always = false;
    for (size_t i = 0; i < sizeof criteria / sizeof *criteria; i++)
        always = always || criteria[i] == measure;
    for (enum thud_measure m = 0; word && m < THUD_MEASURES; m++) {
        const char *other = thud_measure_info(m)->event.word;
        always = always && !(m != measure && other && strcmp(other, word) == 0 && *site->limit[m].text);
    }
    return always || *site->limit[measure].text;
}

void thud_site_conclusion(struct site *site)
{
    struct thud_document *d = &site->document;
    char of[96], caption[240];
    if (!site->suite.runs)
        return;
    thud_document_heading(d, "Conclusion");
    for (int i = 1; site->gap && i < site->scene->nstructures; i++)
        recommend(site, i);
    thud_site_decided_words(site, of, sizeof of);
    if (site->record)
        snprintf(caption, sizeof caption, "Criteria, %s: %s", site->own->words, of);
    else
        snprintf(caption, sizeof caption, "Criteria, %s", site->own->words);
    thud_document_table(d, caption);
    thud_document_head(d, "criterion|limit|value|ratio|met?|governing load case|section, page");
    for (int i = 1; site->gap && i < site->scene->nstructures; i++)
        gap_criterion(site, i);
    for (enum thud_measure m = 0; m < THUD_MEASURES; m++)
        if (is_criterion(site, m))
            criterion(site, m);
}
