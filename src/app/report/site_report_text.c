/* Results in words and tables, and the order of the sections. A new section is a function and its word in `sections`;
 * it adds nothing where its data are not there. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/report/site_report_private.h"
#include "app/run/figure_files.h"
#include "app/run/run_cases.h"
#include "app/run/summary_line.h"
#include "base/version.h"
#include "ground/identity.h"
#include "ground/intensity.h"
#include "ground/spectrum.h"
#include "plot/figures/figures_floor.h"
#include "plot/figures/figures_record.h"
#include "plot/figures/figures_run.h"
#include "study/scene/level.h"
#include "study/suite/scaling.h"

/* ---- the result ---- */

int thud_site_storeys(const struct site *site, int *past)
{
    const struct thud_result *r = site->own->result;
    int n = 0, over = 0;
    for (int s = 0; s < r->nstructures; s++)
        for (int f = thud_structure_first_storey(&site->scene->structure[s]);
             r->structure[s].storey && f < r->structure[s].floors; f++) {
            n += r->structure[s].storey[f].yields;
            over += r->structure[s].storey[f].yields && r->structure[s].storey[f].ductility > 1;
        }
    if (past)
        *past = over;
    return n;
}

/* NaN: there is nothing to compare with. */
static double over(double value, double before)
{
    return before > 0 && value >= 0 ? value / before : NAN;
}

/* The columns of the table of floors in every case; one that no floor has a value for is omitted. */
enum { FLOOR_ACCELERATION, FLOOR_DRIFT, FLOOR_DUCTILITY, FLOOR_PERMANENT };
static double floor_value(const struct site_case *one, int s, int floor, int table) /* SI; NaN: there is none */
{
    const struct thud_structure_result *r = &one->result->structure[s];
    const struct thud_storey_result *storey = r->storey && r->storey[floor].yields ? &r->storey[floor] : NULL;
    const double value[] = {thud_floor_acceleration(one->result, s, floor), r->floor[floor].drift.value,
                            storey ? storey->ductility : NAN, storey ? fabs(storey->permanent_m) : NAN};
    return value[table];
}
static const struct floor_table {
    const char *caption, *row; /* "Largest drift of the storeys of %s, mm", "storey" */
    double unit;
    bool storeys; /* of buildings alone */
} floor_table[] = {
    [FLOOR_ACCELERATION] = {"Largest acceleration of the floors of %s, g", "floor", THUD_GRAVITY, false},
    [FLOOR_DRIFT] = {"Largest drift of the storeys of %s, mm", "storey", 1e-3, true},
    [FLOOR_DUCTILITY] = {"Ductility of the storeys of %s (peak drift over yield drift)", "storey", 1, true},
    [FLOOR_PERMANENT] = {"Permanent drift of the storeys of %s, mm", "storey", 1e-3, true},
};
enum { FLOOR_TABLES = sizeof floor_table / sizeof *floor_table };

/* With the measure of a case over without it; NaN where there is nothing to compare. */
static double ratio_of(const struct site *site, const struct site_case *one, int s, int floor, int table)
{
    double with = floor_value(one, s, floor, table);
    double without = floor_value(&site->cases[SITE_NONE], s, floor, table);
    return over(with, without);
}

/* Where a ratio lies: lower, about the same, higher, nowhere. */
enum side { LOWER, SAME, HIGHER, NOWHERE };

static enum side side_of(double ratio)
{
    if (isnan(ratio))
        return NOWHERE;
    return ratio < 1 - THUD_SITE_SAME ? LOWER : ratio > 1 + THUD_SITE_SAME ? HIGHER : SAME;
}

void thud_site_effect(const struct site *site, const struct site_case *one, bool drifts, int count[3])
{
    const int table = drifts ? FLOOR_DRIFT : FLOOR_ACCELERATION;
    count[LOWER] = count[SAME] = count[HIGHER] = 0;
    for (int s = 0; s < site->scene->nstructures; s++)
        for (int i = drifts ? thud_structure_first_storey(&site->scene->structure[s]) : 0;
             i < site->own->result->structure[s].floors; i++) {
            const enum side side = side_of(ratio_of(site, one, s, i, table));
            if (side != NOWHERE)
                count[side]++;
        }
}

/* The largest over the storeys of a structure; NaN: none has one. */
static double largest_of(const struct site_case *one, int s, int table)
{
    double most = NAN;
    int f = floor_table[table].storeys ? thud_structure_first_storey(&one->scene->structure[s]) : 0;
    for (; f < one->result->structure[s].floors; f++)
        most = fmax(most, floor_value(one, s, f, table)); /* a NaN gives way */
    return most;
}

/* Storeys that yield, in every case. */
static void say_yielding(struct site *site, int s)
{
    char said[400] = "";
    for (int i = 0; i < site->ncases; i++) {
        double ductility = largest_of(&site->cases[i], s, FLOOR_DUCTILITY);
        if (isnan(ductility))
            return;
        thud_append(said, sizeof said, "%s%.2f %s (%.1f mm stay)", i ? ", " : "", ductility, site->cases[i].words,
                    1e3 * largest_of(&site->cases[i], s, FLOOR_PERMANENT));
    }
    thud_document_item(&site->document, "The largest ductility of the storeys of %s is %s; up to 1 they are elastic.",
                       thud_site_name(site, s), said);
}

static double larger_of(const struct thud_column_result *r, enum thud_column_quantity lower)
{
    return fmax(r->peak[lower].value, r->peak[lower + 1].value);
}

/* Columns that slabs strike: the storey whose columns bear most of what they can, or most, in every case. */
static void say_columns(struct site *site)
{
    const struct thud_result *own = site->own->result;
    char said[400] = "", name[THUD_NAME_MAX + 32], limit[96] = "";
    int most = 0;
    for (int k = 1; k < own->ncolumns; k++) {
        const struct thud_column_result *r = &own->column[k], *before = &own->column[most];
        bool limited = !isnan(r->ratio) && !isnan(before->ratio);
        if (limited ? r->ratio > before->ratio
                    : larger_of(r, THUD_COLUMN_SHEAR_LOWER) > larger_of(before, THUD_COLUMN_SHEAR_LOWER))
            most = k;
    }
    if (own->ncolumns == 0)
        return;
    for (int i = SITE_NONE; i < site->ncases; i++)
        thud_append(
            said, sizeof said, "%s%s MN %s", i > SITE_NONE ? ", " : "",
            thud_site_number(1e-6 * larger_of(&site->cases[i].result->column[most], THUD_COLUMN_SHEAR_LOWER), 3).text,
            site->cases[i].words);
    if (!isnan(own->column[most].ratio))
        snprintf(limit, sizeof limit, "; their capacity is %s MN",
                 thud_site_number(1e-6 * own->column[most].capacity_n, 3).text);
    thud_document_item(&site->document, "Slabs strike columns: the peak shear of the columns below %s is %s%s.",
                       thud_site_columns(site, &own->column[most], name, sizeof name), said, limit);
}

/* Links, and after them the soil behind walls. */
static void say_links(struct site *site)
{
    for (int i = 0; i < site->own->result->nlinks; i++) {
        const struct thud_link_result *l = &site->own->result->link[i];
        const int wall = thud_link_wall(site->scene, i);
        char name[2 * THUD_NAME_MAX], of[3 * THUD_NAME_MAX];
        thud_link_name(site->scene, i, name, sizeof name);
        if (wall < 0)
            snprintf(of, sizeof of, "Link %d, %s (%s)", i + 1, name, thud_link_law_name(site->scene, i));
        else
            snprintf(of, sizeof of, "Soil behind %s", thud_site_name(site, wall));
        thud_document_item(&site->document, "%s, %s: largest force %s kN, stroke %s mm, energy dissipated %s kJ.", of,
                           site->own->words, thud_site_number(1e-3 * l->force.value, 3).text,
                           thud_site_number(1e3 * l->stroke.value, 3).text, thud_site_number(1e-3 * l->lost_j, 3).text);
    }
}

/* What soil makes of the ground under a building: the base shear, and how far its foundation moves. */
static void say_foundations(struct site *site)
{
    for (int s = 0; s < site->scene->nstructures; s++) {
        const struct thud_structure_result *r = &site->own->result->structure[s];
        if (r->foundation)
            thud_document_item(
                &site->document,
                "Foundation of %s, %s: base shear %s MN, sway %s mm, rotation %s mrad (%s mm at the roof).",
                thud_site_name(site, s), site->own->words, thud_site_number(1e-6 * r->base_shear.value, 3).text,
                thud_site_number(1e3 * r->foundation[0].displacement.value, 3).text,
                thud_site_number(1e3 * r->foundation[1].displacement.value / r->arm_m, 3).text,
                thud_site_number(1e3 * r->foundation[1].displacement.value, 3).text);
    }
}

/* The record's sign is a matter of chance. */
static void say_reversed(struct site *site)
{
    const struct thud_contact_result *most = thud_site_strongest(site->own->result);
    double force = most ? most->force.value : 0;
    if (!site->record || (force == 0 && !(site->reversed.force_n > 0)))
        return;
    struct thud_site_shown turned = thud_site_number(1e-6 * site->reversed.force_n, 3),
                           own = thud_site_number(1e-6 * force, 3);
    if (strcmp(turned.text, own.text) == 0)
        thud_document_item(&site->document, "With reversed polarity, the motion gives the same peak force %s, %s MN.",
                           site->own->words, own.text);
    else
        thud_document_item(&site->document,
                           "With reversed polarity, the motion gives a peak force of %s MN %s instead of %s MN.",
                           turned.text, site->own->words, own.text);
}

static void say_results(struct site *site)
{
    struct thud_document *d = &site->document;
    const struct site_case *free_case = &site->cases[SITE_FREE], *none = &site->cases[SITE_NONE];
    bool pounds = thud_contact_hardest(none->result, 0) != NULL;
    for (int s = 0; pounds && s < site->scene->nstructures; s++) {
        static const char *const does[] = {"lowers", "leaves", "raises"};
        const double a = largest_of(none, s, FLOOR_ACCELERATION), b = largest_of(free_case, s, FLOOR_ACCELERATION);
        const enum side side = b > 0 && site->scene->structure[s].kind != THUD_WALL ? side_of(a / b) : NOWHERE;
        if (side == SAME)
            thud_document_item(d, "Pounding %s leaves the largest acceleration of %s unchanged, within 2 %%: %s g.",
                               none->words, thud_site_name(site, s), thud_site_number(a / THUD_GRAVITY, 3).text);
        else if (side != NOWHERE)
            thud_document_item(d, "Pounding %s %s the largest acceleration of %s from %s g to %s g, by a factor of %s.",
                               none->words, does[side], thud_site_name(site, s),
                               thud_site_number(b / THUD_GRAVITY, 3).text, thud_site_number(a / THUD_GRAVITY, 3).text,
                               thud_site_number(a / b, 3).text);
    }
    for (int s = 0; s < site->scene->nstructures; s++)
        say_yielding(site, s);
    say_columns(site);
    say_links(site);
    say_foundations(site);
    say_reversed(site);
    if (!site->suite.leads) /* whose samples are over its motions */
        thud_site_samples_summary(site);
}

/* ---- the cases ---- */

static void add_case_table(struct site *site, int s, int which)
{
    const struct floor_table *table = &floor_table[which];
    struct thud_document *d = &site->document;
    char name[2 * THUD_NAME_MAX], caption[2 * THUD_NAME_MAX + 96];
    if (table->storeys && !thud_site_is_building(site, s))
        return;
    const int slab = table->storeys ? thud_structure_first_storey(&site->scene->structure[s]) : 0;
    snprintf(name, sizeof name, "%s%s", thud_site_name(site, s), slab > 0 ? " and of its isolators" : "");
    snprintf(caption, sizeof caption, table->caption, name);
    thud_site_case_table(site, caption, SITE_FREE);
    thud_document_cell(d, "%s", table->row);
    for (int i = 0; i < site->ncases; i++)
        thud_document_cell(d, "%c", thud_site_letter(i));
    for (int i = SITE_NONE; i < site->ncases; i++)
        thud_document_cell(d, "%c/%c", thud_site_letter(i), thud_site_letter(i > SITE_NONE ? SITE_NONE : SITE_FREE));
    thud_document_row(d);
    for (int f = site->cases[0].result->structure[s].floors - 1; f >= 0; f--) {
        double value[SITE_CASES];
        if (f < slab)
            thud_document_cell(d, "isolators");
        else if (f == 0 && site->scene->structure[s].kind == THUD_ISOLATED)
            thud_document_cell(d, "1, base slab");
        else
            thud_document_cell(d, "%d", f + 1 - slab);
        for (int i = 0; i < site->ncases; i++) {
            value[i] = floor_value(&site->cases[i], s, f, which);
            thud_document_cell(d, "%s", thud_site_number(value[i] / table->unit, 3).text);
        }
        for (int i = 1; i < site->ncases; i++)
            thud_document_cell(d, "%s",
                               thud_site_number(over(value[i], value[i > SITE_NONE ? SITE_NONE : SITE_FREE]), 3).text);
        thud_document_row(d);
    }
}

/* "c7-6", in a row of structures "A and B: c7-6". */
static void add_level_cell(struct site *site, int interface, int left, int right, int struck)
{
    char pair[48];
    thud_contact_pair_name(left, right, struck, pair, sizeof pair);
    if (site->scene->nstructures > 2)
        thud_document_cell(&site->document, "%s and %s: %s", thud_site_name(site, interface - 1),
                           thud_site_name(site, interface), pair);
    else
        thud_document_cell(&site->document, "%s", pair);
}

/* Contacts by level: how often, the largest force and compression. What no contact has a value for is omitted. */
static void add_contact_table(struct site *site)
{
    struct thud_document *d = &site->document;
    if (site->own->result->ncontacts == 0)
        return;
    thud_site_case_table(site, "Contacts: number n, largest force F, compression d", SITE_NONE);
    thud_document_cell(d, "floors");
    for (int i = SITE_NONE; i < site->ncases; i++)
        thud_document_cells(d, "%c: n\t%c: F MN\t%c: d mm", thud_site_letter(i), thud_site_letter(i),
                            thud_site_letter(i));
    thud_document_row(d);
    for (int c = site->own->result->ncontacts - 1; c >= 0; c--) {
        const struct thud_contact_result *p = &site->own->result->contact[c];
        add_level_cell(site, p->interface, p->left_floor, p->right_floor, p->struck);
        for (int i = SITE_NONE; i < site->ncases; i++) {
            const struct thud_contact_result *r = &site->cases[i].result->contact[c];
            thud_document_cells(d, "%d\t%s\t%s", r->impacts, thud_site_number(1e-6 * thud_peak_force(r), 3).text,
                                thud_site_number(1e3 * thud_peak_depth(r), 3).text);
        }
        thud_document_row(d);
    }
}

/* The columns that slabs strike, of the ends the one that bears more. */
static void add_column_table(struct site *site)
{
    struct thud_document *d = &site->document;
    const struct thud_result *own = site->own->result;
    char name[THUD_NAME_MAX + 32];
    if (own->ncolumns == 0)
        return;
    thud_site_case_table(site, "Columns struck by slabs: peak shear V and moment M at their ends, V over capacity C",
                         SITE_FREE);
    thud_document_cell(d, "columns below");
    for (int i = 0; i < site->ncases; i++)
        thud_document_cells(d, "%c: V MN\t%c: M MN m\t%c: V/C", thud_site_letter(i), thud_site_letter(i),
                            thud_site_letter(i));
    thud_document_row(d);
    for (int k = own->ncolumns - 1; k >= 0; k--) {
        thud_document_cell(d, "%s", thud_site_columns(site, &own->column[k], name, sizeof name));
        for (int i = 0; i < site->ncases; i++) {
            const struct thud_column_result *r = &site->cases[i].result->column[k];
            thud_document_cells(d, "%s\t%s\t%s", thud_site_number(1e-6 * larger_of(r, THUD_COLUMN_SHEAR_LOWER), 3).text,
                                thud_site_number(1e-6 * larger_of(r, THUD_COLUMN_MOMENT_LOWER), 3).text,
                                thud_site_number(r->ratio, 3).text);
        }
        thud_document_row(d);
    }
}

static struct thud_figure_source source_of(const struct site *site, const struct site_case *one)
{
    const enum thud_case whole = site->scene->nlinks > 0 ? THUD_CASE_AS_WRITTEN : THUD_CASE_BUMPER;
    return thud_run_source(one->name, one->which == THUD_CASE_WHOLE ? whole : one->which, one->scene,
                           one->solution.run);
}

static void floors(struct site *site)
{
    struct thud_document *d = &site->document;
    const struct thud_floor_spectra *s = site->floors;
    char name[THUD_NAME_MAX + 32];
    int k;
    if (!s)
        return;
    thud_document_table(d, "Floor response spectra of the floors with the largest impact forces: peak "
                           "pseudo-acceleration (g) at 5 % damping, and its period");
    thud_document_cell(d, "floor");
    for (int i = 0; i < s->ncases; i++)
        thud_document_cell(d, "%s", i > SITE_NONE ? site->own->name : thud_floor_case_title(site->scene, i));
    thud_document_row(d);
    for (int f = 0; f < s->nfloors; f++) {
        thud_document_cell(d, "%s",
                           thud_site_floor(site, s->floor[f].structure, s->floor[f].floor + 1, name, sizeof name));
        for (int i = 0; i < s->ncases; i++) {
            const double *sa = thud_floor_spectrum(s, i, f, &k);
            thud_document_cell(d, "%.3g at %.3g s", sa[k] / THUD_GRAVITY, s->period_s[k]);
        }
        thud_document_row(d);
    }
    thud_site_figure(
        site, thud_figure_of_floors(site->scene, s), 0.25 * s->nfloors,
        "Floor response spectra of the floors with the largest impact forces: pseudo-acceleration, 5 % damping.");
}

static void results(struct site *site)
{
    struct thud_document *d = &site->document;
    struct thud_figure_source source[SITE_CASES];
    char motion[320];
    thud_document_heading(d, "Results");
    thud_site_suite_summary(site);
    if (site->suite.leads)
        thud_site_samples_summary(site);
    if (site->record) {
        thud_site_motion(site->record, motion, sizeof motion);
        thud_document_paragraph(d, "%s %s:", site->suite.leads ? "In detail under one ground motion," : "Under",
                                motion);
    }
    say_results(site);
    for (int s = 0; s < site->scene->nstructures; s++)
        if (thud_site_is_building(site, s) || site->scene->structure[s].kind == THUD_RIGID) {
            for (int i = 0; i < FLOOR_TABLES; i++)
                add_case_table(site, s, i);
        }
    add_contact_table(site);
    add_column_table(site);
    for (int i = 0; i < site->ncases; i++)
        source[i] = source_of(site, &site->cases[i]);
    if (thud_run_figure_has(THUD_FIGURE_ENVELOPE, source, site->ncases)) {
        struct thud_figure *envelope = thud_run_figure(THUD_FIGURE_ENVELOPE, source, site->ncases);
        thud_site_figure(site, envelope, 0.1 + 0.18 * (envelope ? envelope->rows : 1),
                         "Peak values over the height in each case.");
    }
    if (thud_run_figure_has(THUD_FIGURE_FORCE, &source[SITE_NONE], site->ncases - 1)) {
        struct thud_figure *forces = thud_run_figure(THUD_FIGURE_FORCE, &source[SITE_NONE], site->ncases - 1);
        const bool made = thud_figure_check(forces, NULL) == THUD_OK;
        const double share = fmin(0.63, 0.2 + 0.06 * (made ? forces->rows : 0)); /* a strip for each contact and case */
        if (made)
            thud_site_fit(site, forces, share);
        const struct thud_axis none = {.label = "Force", .unit = ""},
                               *axis = made ? &forces->panel[forces->columns * (forces->rows - 1)].axis[THUD_Y] : &none;
        char caption[160];
        snprintf(caption, sizeof caption, "Ground acceleration and the largest %c%ss (%s) over time%s.",
                 axis->label[0] - 'A' + 'a', axis->label + 1, axis->unit,
                 made && forces->columns > 1 ? "; at the right around the largest impact" : "");
        thud_site_figure(site, forces, share, caption);
    }
    if (thud_run_figure_has(THUD_FIGURE_COLUMNS, &source[SITE_NONE], site->ncases - 1))
        thud_site_figure(site, thud_run_figure(THUD_FIGURE_COLUMNS, &source[SITE_NONE], site->ncases - 1), 0.5,
                         "Peak shear of the columns struck by slabs, over the height.");
    floors(site);
}

/* ---- the required gap ---- */

/* In cm, rounded up; -: there is none. */
static void add_gap_cell(struct thud_document *d, double gap_m)
{
    if (isnan(gap_m))
        thud_document_cell(d, "-");
    else
        thud_document_cell(d, "%.1f", thud_summary_gap_cm(gap_m));
}

struct thud_gap_ruled thud_site_ruled(const struct thud_gap_study *gaps, int nstructures, int interface, int rule)
{
    struct thud_gap_ruled ruled[THUD_STRUCTURES_MAX];
    const int n = nstructures - 1;
    int widest = interface > 0 ? interface - 1 : 0;
    thud_gap_suite_rule(&gaps->suite, rule, n, ruled);
    for (int i = 1; interface == 0 && i < n; i++)
        if (thud_gap_is_wider(ruled[i].gap_m, ruled[widest].gap_m))
            widest = i;
    return ruled[widest];
}

const char *thud_site_displacements(const struct site *site, int rule, char *text, size_t size)
{
    const struct thud_gap_suite *suite = &site->gaps.suite;
    if (suite->nrecords < 2)
        snprintf(text, size, "those of this single motion");
    else if (thud_gap_suite_means(suite, rule))
        snprintf(text, size, "the means over %d ground motions of %d recordings", suite->nrecords, suite->recordings);
    else
        snprintf(text, size, "the largest of %d ground motions", suite->nrecords);
    return text;
}

/* What every rule asks for at the level where it asks for most. */
static void gap_rules(struct site *site)
{
    struct thud_document *d = &site->document;
    const bool suite = site->gaps.suite.nrecords > 1;
    const double needed = thud_site_ruled(&site->gaps, site->scene->nstructures, 0, THUD_GAP_EXACT).gap_m;
    char displacements[80];
    thud_site_displacements(site, THUD_GAP_EN1998, displacements, sizeof displacements);
    thud_document_table(d, suite ? "Required gap by rule over the suite, cm" : "Required gap by rule, cm");
    thud_document_head(d, "rule|clause|formula|cm");
    for (int rule = 0; rule < (int)THUD_GAP_RULES; rule++) {
        const struct thud_gap_rule *r = thud_gap_rule_at(rule);
        struct thud_text numbers = {0};
        const struct thud_gap_ruled ruled = thud_site_ruled(&site->gaps, site->scene->nstructures, 0, rule);
        const double widest = ruled.gap_m;
        thud_document_cell(d, "%s", r->name);
        thud_document_cell(d, "%s%s%s%s%s%s%s", r->edition, *r->edition ? ", " : "", r->clause, *r->clause ? ": " : "",
                           r->title, *r->source ? "; " : "", r->source);
        thud_gap_numbers(&ruled.level, rule, &numbers);
        thud_document_cell(d, "%s%s%s", r->formula, isnan(widest) ? ": " : " = ",
                           isnan(widest)  ? r->lacks
                           : numbers.data ? numbers.data
                                          : "");
        add_gap_cell(d, widest);
        thud_document_row(d);
        thud_text_clear(&numbers);
    }
    struct thud_text less = {0};
    for (int rule = 0; rule < (int)THUD_GAP_RULES; rule++) {
        const double ruled = thud_site_ruled(&site->gaps, site->scene->nstructures, 0, rule).gap_m;
        if (thud_gap_falls_short(ruled, needed))
            thud_text_append(&less, "%s%s (%.1f cm)", less.size > 0 ? ", " : "", thud_gap_rule_at(rule)->name,
                             thud_summary_gap_cm(ruled));
    }
    if (less.size > 0)
        thud_document_paragraph(d, "Less than the %.1f cm that %s: %s.", thud_summary_gap_cm(needed),
                                suite ? "all of the suite require" : "this motion requires", less.data);
    d->failed = d->failed || less.failed;
    thud_text_clear(&less);
    thud_document_paragraph(
        d,
        "EN (2)(a) and ASCE line apply to buildings with different owners. Each building is set "
        "back from the property line by its own displacement, so the gap is their sum. The codes "
        "use design displacements; those used here are %s%s.",
        displacements,
        suite
            ? " (EN 1998-1:2004, 4.3.3.4.3(3): means of seven recordings or more; ASCE 7-16, 16.2.2: of eleven or more)"
            : "");
}

/* Of three or more structures: one that pushes another changes what is needed beside it. */
static void row_gaps(struct site *site)
{
    struct thud_document *d = &site->document;
    const struct thud_gap_row_fields *row = site->gaps.row;
    if (!row)
        return;
    thud_document_table(d, "Required gap in the row, cm, between bare faces");
    thud_document_head(d, "between|others as given|all together");
    for (int i = 0; i < site->gaps.nrow; i++) {
        thud_document_cell(d, "%s and %s", thud_site_name(site, row[i].interface - 1),
                           thud_site_name(site, row[i].interface));
        add_gap_cell(d, row[i].others_as_given_m);
        add_gap_cell(d, row[i].all_together_m);
        thud_document_row(d);
    }
    thud_document_paragraph(
        d, "Others as given: the gap that prevents contact of these two while the others keep their gaps and may "
           "pound, from a run with this gap open. All together: at these gaps there is no contact in the row.");
}

static void gap(struct site *site)
{
    struct thud_document *d = &site->document;
    if (!site->gap || site->gap->nlevels == 0)
        return;
    thud_document_heading(d, "Required gap");
    thud_document_paragraph(
        d, "For each level, the table gives the smallest gap between bare faces that prevents contact under this "
           "ground motion. It is derived from the response without pounding. The column \"needed\" is the peak "
           "relative displacement; the rules use only the two peak displacements. If a bumper is fitted, add its "
           "projection. Required gaps are rounded up to a millimetre.");
    char caption[64] = "Required gap, cm";
    if (site->suite.leads)
        snprintf(caption, sizeof caption, "Required gap under load case %d, cm", site->detail + 1);
    thud_document_table(d, caption);
    thud_document_cells(d, "floors\tleft moves\tright moves");
    for (int rule = THUD_GAP_EXACT; rule < (int)THUD_GAP_SHORT; rule++)
        thud_document_cell(d, "%s", thud_gap_rule_at(rule)->name);
    thud_document_row(d);
    for (int i = site->gap->nlevels - 1; i >= 0; i--) {
        const struct thud_gap_level *l = &site->gap->level[i];
        add_level_cell(site, l->interface, l->left_floor, l->right_floor, l->struck);
        thud_document_cells(d, "%.2f\t%.2f", 100 * l->left_m, 100 * l->right_m);
        for (int rule = THUD_GAP_EXACT; rule < (int)THUD_GAP_SHORT; rule++)
            add_gap_cell(d, thud_gap_value(l, rule));
        thud_document_row(d);
    }
    row_gaps(site);
    gap_rules(site);
}

typedef void section(struct site *site);
static section *const sections[] = {thud_site_conclusion,    thud_site_verdicts,
                                    thud_site_foremost,      thud_site_scene,
                                    thud_site_inputs,        thud_site_loads,
                                    thud_site_method,        results,
                                    thud_site_variants,      gap,
                                    thud_site_suite_section, thud_site_sure_section,
                                    thud_site_simplify,      thud_site_drawn,
                                    thud_site_cautions,      thud_site_checks,
                                    thud_site_unmade,        thud_site_provenance};

enum thud_status thud_site_write(struct site *site, struct thud_error *err)
{
    char title[THUD_TEXT_MAX + 64];
    const char *name = site->scene->title[0] ? site->scene->title : site->scene->name;
    snprintf(title, sizeof title, "Pounding report: %s", name);
    thud_document_title(&site->document, title);
    thud_site_title_block(site);
    thud_document_contents(&site->document);
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++)
        sections[i](site);
    thud_document_tidy(&site->document);
    if (site->pictures == THUD_CANCELLED) {
        if (err)
            *err = site->picture_error;
        return THUD_CANCELLED;
    }
    return site->document.failed ? thud_error_set(err, THUD_MEMORY, "out of memory") : THUD_OK;
}
