/* The sections of a report. A new one is a function and its line in `sections`; it adds nothing where its data are not
 * there. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/report/site_report_private.h"
#include "app/run/run_figures.h"
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
#include "study/sweep/remark.h"

/* A ratio this near to 1 is told as no difference. */
static const double same_within = 0.02;
/* A storey that drifts by more of its height would have yielded. */
static const double drift_limit = 0.01;

/* ---- the result ---- */

int thud_site_impacts(const struct thud_result *r, int *levels)
{
    int n = 0;
    *levels = 0;
    for (int c = 0; c < r->ncontacts; c++) {
        n += r->contact[c].impacts;
        *levels += r->contact[c].impacts > 0;
    }
    return n;
}

static double largest_acceleration(const struct thud_structure_result *r)
{
    double most = 0;
    for (int i = 0; i < r->floors; i++)
        most = fmax(most, r->floor[i].acceleration.value);
    return most;
}

static const char *plural(int n)
{
    return n == 1 ? "" : "s";
}

static void say_case(struct site *site, const struct site_case *one)
{
    int levels, n = thud_site_impacts(one->result, &levels);
    const struct thud_contact_result *most = thud_site_strongest(one->result);
    char between[320];
    if (n == 0 || !most) {
        thud_document_item(&site->document, "%c%s there is no contact.", one->words[0] - 'a' + 'A', one->words + 1);
        return;
    }
    thud_site_sides(site, most->interface, most->left_floor, most->right_floor, most->struck, between, sizeof between);
    thud_document_item(&site->document,
                       "%c%s they collide %d time%s, at %d level%s. The largest force is %s MN, between %s, at %.2f s.",
                       one->words[0] - 'a' + 'A', one->words + 1, n, plural(n), levels, plural(levels),
                       thud_site_number(1e-6 * most->force.value, 3).text, between, most->force.time_s);
}

/* What is told of every floor in every case. A result that has more is one line more: what no floor has in any case is
 * left out. */
enum { FLOOR_ACCELERATION, FLOOR_DRIFT, FLOOR_DUCTILITY, FLOOR_PERMANENT };
static double acceleration_of(const struct thud_structure_result *r, int floor)
{
    return r->floor[floor].acceleration.value;
}
static double drift_of(const struct thud_structure_result *r, int floor)
{
    return r->floor[floor].drift.value;
}
static double ductility_of(const struct thud_structure_result *r, int floor)
{
    return r->storey && r->storey[floor].yields ? r->storey[floor].ductility : NAN;
}
static double permanent_of(const struct thud_structure_result *r, int floor)
{
    return r->storey && r->storey[floor].yields ? fabs(r->storey[floor].permanent_m) : NAN;
}
static const struct floor_table {
    const char *caption, *row; /* "Largest drift of the storeys of %s, mm", "storey" */
    double unit;
    bool storeys;                                                      /* of buildings alone */
    double (*value)(const struct thud_structure_result *r, int floor); /* SI; NaN: there is none */
} floor_table[] = {
    [FLOOR_ACCELERATION] = {"Largest acceleration of the floors of %s, m/s2", "floor", 1, false, acceleration_of},
    [FLOOR_DRIFT] = {"Largest drift of the storeys of %s, mm", "storey", 1e-3, true, drift_of},
    [FLOOR_DUCTILITY] = {"Ductility of the storeys of %s (largest drift over yield drift)", "storey", 1, true,
                         ductility_of},
    [FLOOR_PERMANENT] = {"Drift that stays in the storeys of %s, mm", "storey", 1e-3, true, permanent_of},
};
enum { FLOOR_TABLES = sizeof floor_table / sizeof *floor_table };

/* With the bumper over without it; NaN where there is nothing to compare. */
static double ratio_of(const struct site *site, int s, int floor, int table)
{
    double with = floor_table[table].value(&site->cases[SITE_BUMPER].result->structure[s], floor);
    double without = floor_table[table].value(&site->cases[SITE_NONE].result->structure[s], floor);
    return without > 0 ? with / without : NAN;
}

/* Where a ratio lies: lower, about the same, higher, nowhere. */
enum side { LOWER, SAME, HIGHER, NOWHERE };

static enum side side_of(double ratio)
{
    if (isnan(ratio))
        return NOWHERE;
    return ratio < 1 - same_within ? LOWER : ratio > 1 + same_within ? HIGHER : SAME;
}

/* Writes "1-3, 5 of A; 2 of B": the floors whose ratio lies on a side; *furthest: the ratio furthest from 1. Returns how
 * many there are. */
static int list_floors(const struct site *site, int table, enum side side, struct thud_text *out, double *furthest)
{
    int n = 0;
    *furthest = 1;
    for (int s = 0; s < site->scene->nstructures; s++) {
        int floors = site->own->result->structure[s].floors, begun = -1;
        bool any = false;
        const int slab = floor_table[table].storeys && site->scene->structure[s].kind == THUD_ISOLATED;
        for (int i = slab; i <= floors; i++) { /* without the isolators */
            double ratio = i < floors ? ratio_of(site, s, i, table) : NAN;
            bool inside = side_of(ratio) == side;
            if (inside && begun < 0)
                begun = i;
            if (inside && fabs(log(ratio)) > fabs(log(*furthest)))
                *furthest = ratio;
            if (inside || begun < 0)
                continue;
            thud_text_append(out, "%s%d", any ? ", " : n > 0 ? "; " : "", begun + 1 - slab);
            if (i - 1 > begun)
                thud_text_append(out, "-%d", i - slab);
            n += i - begun;
            begun = -1;
            any = true;
        }
        if (any)
            thud_text_append(out, " of %s", thud_site_name(site, s));
    }
    return n;
}

void thud_site_effect(const struct site *site, bool drifts, int count[3])
{
    for (int side = LOWER; side <= (int)HIGHER; side++) {
        struct thud_text floors = {0};
        double furthest;
        count[side] = list_floors(site, drifts ? FLOOR_DRIFT : FLOOR_ACCELERATION, (enum side)side, &floors, &furthest);
        thud_text_clear(&floors);
    }
}

static void say_effect(struct site *site, int table)
{
    static const char *const verb[] = {"lowers", "leaves", "raises"};
    const char *quantity = table == FLOOR_DRIFT ? "drifts at storeys" : "accelerations at floors";
    for (int side = LOWER; side <= (int)HIGHER; side++) {
        struct thud_text floors = {0};
        double furthest;
        int n = list_floors(site, table, (enum side)side, &floors, &furthest);
        if (floors.failed)
            site->document.failed = true;
        else if (n > 0 && side == SAME)
            thud_document_item(&site->document, "The bumper leaves the largest %s %s unchanged, within %.0f %%.",
                               quantity, floors.data, 100 * same_within);
        else if (n > 0)
            thud_document_item(&site->document, "The bumper %s the largest %s %s, by up to %.0f %%.", verb[side],
                               quantity, floors.data, 100 * fabs(furthest - 1));
        thud_text_clear(&floors);
    }
}

/* The largest over the storeys of a structure; NaN: none has one. */
static double largest_of(const struct site_case *one, int s, int table)
{
    const struct thud_structure_result *r = &one->result->structure[s];
    double most = NAN;
    for (int f = 0; f < r->floors; f++)
        most = fmax(most, floor_table[table].value(r, f)); /* a NaN gives way */
    return most;
}

/* Storeys that yield, in every case. */
static void say_yielding(struct site *site, int s)
{
    char said[400] = "";
    size_t used = 0;
    for (int i = 0; i < site->ncases; i++) {
        double ductility = largest_of(&site->cases[i], s, FLOOR_DUCTILITY);
        if (isnan(ductility))
            return;
        used += (size_t)snprintf(said + used, sizeof said - used, "%s%.2f %s (%.1f mm stay)", i ? ", " : "", ductility,
                                 site->cases[i].words, 1e3 * largest_of(&site->cases[i], s, FLOOR_PERMANENT));
    }
    thud_document_item(&site->document, "The largest ductility of the storeys of %s is %s; up to 1 they are elastic.",
                       thud_site_name(site, s), said);
}

static double larger_of(const struct thud_column_result *r, enum thud_column_quantity lower)
{
    return fmax(r->peak[lower].value, r->peak[lower + 1].value);
}

/* Whose columns they are: "floor 5 of B". */
static const char *columns_name(const struct site *site, const struct thud_column_result *r, char *name, size_t size)
{
    snprintf(name, size, "floor %d of %s", r->storey, thud_site_name(site, r->structure));
    return name;
}

/* Columns that slabs strike: the storey whose columns bear most of what they can, or most, in every case. */
static void say_columns(struct site *site)
{
    const struct thud_result *own = site->own->result;
    char said[400] = "", name[THUD_NAME_MAX + 32], limit[96] = "";
    size_t used = 0;
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
        used += (size_t)snprintf(
            said + used, sizeof said - used, "%s%s kN %s", i > SITE_NONE ? ", " : "",
            thud_site_number(1e-3 * larger_of(&site->cases[i].result->column[most], THUD_COLUMN_SHEAR_LOWER), 4).text,
            site->cases[i].words);
    if (!isnan(own->column[most].ratio))
        snprintf(limit, sizeof limit, "; they can bear %s kN",
                 thud_site_number(1e-3 * own->column[most].capacity_n, 4).text);
    thud_document_item(&site->document, "Slabs strike columns: the largest shear of those below %s is %s%s.",
                       columns_name(site, &own->column[most], name, sizeof name), said, limit);
}

/* The record's sign is a matter of chance. */
static void say_reversed(struct site *site)
{
    const struct thud_contact_result *most = thud_site_strongest(site->own->result);
    double force = most ? most->force.value : 0;
    if (!site->record || (force == 0 && site->reversed.force_n == 0))
        return;
    struct thud_site_shown turned = thud_site_number(1e-6 * site->reversed.force_n, 3),
                           own = thud_site_number(1e-6 * force, 3);
    if (strcmp(turned.text, own.text) == 0)
        thud_document_item(&site->document,
                           "The same motion with reversed polarity gives the same largest force %s, %s MN.",
                           site->own->words, own.text);
    else
        thud_document_item(
            &site->document,
            "The same motion with reversed polarity gives a largest force of %s MN %s, in place of %s MN.", turned.text,
            site->own->words, own.text);
}

static void say_gap(struct site *site)
{
    int level;
    char between[320];
    for (int i = 1; site->gap && i < site->scene->nstructures; i++) {
        const struct thud_interface *f = &site->scene->interface[i - 1];
        double needed = thud_needed_gap_widest(site->gap, i, THUD_GAP_EXACT, &level);
        if (!(needed >= 0))
            continue;
        const struct thud_gap_level *l = &site->gap->level[level];
        thud_site_sides(site, i, l->left_floor, l->right_floor, l->struck, between, sizeof between);
        double out = f->gap_m - thud_interface_clearance(f);
        char bumper[120] = "";
        if (out > 0)
            snprintf(bumper, sizeof bumper, "; %.1f cm from concrete to concrete with a bumper that stands out %.1f cm",
                     thud_summary_gap_cm(needed + out), 100 * out);
        thud_document_item(
            &site->document,
            "Under this motion there is no contact between %s and %s from a gap of %.1f cm on (%s decide%s); "
            "the gap is %.1f cm.",
            thud_site_name(site, i - 1), thud_site_name(site, i), thud_summary_gap_cm(needed), between, bumper,
            100 * f->gap_m);
    }
}

/* What fails, first of all: columns that bear more than they can are taken as whole. Returns how many are told of. */
static int say_failure(struct site *site, const struct site_case *one)
{
    const struct thud_column_result *worst = NULL;
    char name[THUD_NAME_MAX + 32];
    int above = 0;
    for (int k = 0; k < one->result->ncolumns; k++) {
        const struct thud_column_result *r = &one->result->column[k];
        above += r->ratio > 1;
        if (r->ratio > 1 && (!worst || r->ratio > worst->ratio))
            worst = r;
    }
    if (!worst)
        return 0;
    const struct thud_peak *low = &worst->peak[THUD_COLUMN_SHEAR_LOWER], *up = &worst->peak[THUD_COLUMN_SHEAR_UPPER];
    thud_document_item(&site->document,
                       "%c%s struck columns fail, in %d storey%s: those below %s would have to bear %s times what they "
                       "can, at %.3f s. All that follows takes them as whole: it has no meaning from there on.",
                       one->words[0] - 'a' + 'A', one->words + 1, above, plural(above),
                       columns_name(site, worst, name, sizeof name), thud_site_number(worst->ratio, 3).text,
                       low->value > up->value ? low->time_s : up->time_s);
    return 1;
}

static int say_failures(struct site *site)
{
    int n = 0;
    for (int i = SITE_NONE; i < site->ncases; i++)
        n += say_failure(site, &site->cases[i]);
    return n;
}

static void solution(struct site *site)
{
    struct thud_document *d = &site->document;
    const struct site_case *free_case = &site->cases[SITE_FREE], *none = &site->cases[SITE_NONE];
    int levels;
    char peak[96] = "";
    if (site->record)
        thud_record_peak_text(site->record, peak, sizeof peak);
    thud_document_heading(d, "The result");
    say_failures(site);
    bool pounds = thud_site_impacts(none->result, &levels) > 0;
    thud_site_suite_summary(site);
    if (site->record)
        thud_document_paragraph(d, "%s %s%s, %s, the buildings %s at the given gap.",
                                site->suite.runs ? "One motion in detail: under" : "Under",
                                thud_path_name(site->record->file), thud_record_synthetic_mark(site->record), peak,
                                pounds ? "pound against each other" : "do not touch");
    for (int i = SITE_NONE; i < site->ncases; i++)
        say_case(site, &site->cases[i]);
    for (int s = 0; pounds && s < site->scene->nstructures; s++) {
        double a = largest_acceleration(&none->result->structure[s]);
        double b = largest_acceleration(&free_case->result->structure[s]);
        if (b > 0)
            thud_document_item(
                d,
                "Pounding without bumper takes the largest acceleration of %s from %s g to %s g, %s times as "
                "much.",
                thud_site_name(site, s), thud_site_number(b / THUD_GRAVITY, 3).text,
                thud_site_number(a / THUD_GRAVITY, 3).text, thud_site_number(a / b, 2).text);
    }
    if (site->ncases > SITE_BUMPER) {
        say_effect(site, FLOOR_ACCELERATION);
        say_effect(site, FLOOR_DRIFT);
    } else {
        thud_document_item(d, "The scene has no bumper; one in the preset adds the comparison.");
    }
    for (int s = 0; s < site->scene->nstructures; s++)
        say_yielding(site, s);
    say_columns(site);
    say_reversed(site);
    say_gap(site);
    thud_site_samples_summary(site);
}

/* ---- the scene ---- */

static void add_structure_rows(struct site *site)
{
    struct thud_document *d = &site->document;
    static const char *const kinds[] = {"shear building",         "rigid body",           "isolated building", "wall",
                                        "building by its matrix", "building by its modes"};
    static const char *const head[] = {"structure", "kind", "storeys", "height m", "mass t",
                                       "damping %", "T1 s", "T2 s",    "T3 s"};
    thud_document_table(d, "Structures from left to right");
    for (size_t i = 0; i < sizeof head / sizeof *head; i++)
        thud_document_cell(d, "%s", head[i]);
    thud_document_row(d);
    for (int s = 0; s < site->scene->nstructures; s++) {
        const struct thud_structure *p = &site->scene->structure[s];
        const struct thud_structure_result *r = &site->cases[SITE_FREE].result->structure[s];
        double mass = p->kind == THUD_ISOLATED ? p->base_mass_kg : 0, height = 0;
        for (int i = 0; i < p->storeys; i++) {
            mass += p->mass_kg[i];
            height += p->height_m[i];
        }
        thud_document_cell(d, "%s", thud_site_name(site, s));
        thud_document_cell(d, "%s", kinds[p->kind]);
        thud_document_cell(d, "%d", thud_site_is_building(site, s) ? p->storeys : 0);
        if (thud_site_is_building(site, s))
            thud_document_cell(d, "%.4g", height);
        else
            thud_document_cell(d, "-");
        thud_document_cell(d, "%.5g", 1e-3 * mass);
        thud_document_cell(d, thud_site_is_building(site, s) ? "%.3g" : "-", 100 * p->damping);
        for (int m = 0; m < 3; m++)
            if (m < r->floors && isfinite(r->period_s[m]))
                thud_document_cell(d, "%.3f", r->period_s[m]);
            else
                thud_document_cell(d, "-");
        thud_document_row(d);
    }
}

static void add_floor_rows(struct site *site, int s)
{
    struct thud_document *d = &site->document;
    const struct thud_structure *p = &site->scene->structure[s];
    char caption[THUD_NAME_MAX + 32];
    snprintf(caption, sizeof caption, "Storeys of %s", thud_site_name(site, s));
    thud_document_table(d, caption);
    thud_document_cell(d, "storey");
    thud_document_cell(d, "mass of its floor t");
    thud_document_cell(d, "stiffness MN/m");
    thud_document_cell(d, "height m");
    thud_document_row(d);
    for (int i = p->storeys - 1; i >= 0; i--) {
        thud_document_cell(d, "%d", i + 1);
        thud_document_cell(d, "%.5g", 1e-3 * p->mass_kg[i]);
        if (thud_kind_is_read(p->kind))
            thud_document_cell(d, "matrix");
        else
            thud_document_cell(d, "%.5g", 1e-6 * p->stiffness_npm[i]);
        thud_document_cell(d, "%.4g", p->height_m[i]);
        thud_document_row(d);
    }
}

static void scene(struct site *site)
{
    struct thud_document *d = &site->document;
    thud_document_heading(d, "The buildings and the gap");
    add_structure_rows(site);
    for (int s = 0; s < site->scene->nstructures; s++)
        if (thud_site_is_building(site, s))
            add_floor_rows(site, s);
    for (int i = 0; i + 1 < site->scene->nstructures; i++) {
        const struct thud_interface *f = &site->scene->interface[i];
        thud_document_item(d, "Between %s and %s: a gap of %.4g cm.", thud_site_name(site, i),
                           thud_site_name(site, i + 1), 100 * f->gap_m);
        if (f->has_bumper)
            thud_document_item(
                d, "Its bumper: %.4g cm thick in a cavity of %.4g cm, which leaves a clearance of %.4g cm.",
                100 * f->bumper_thickness_m, 100 * f->bumper_cavity_m, 100 * thud_interface_clearance(f));
    }
    for (int i = 0; i < site->scene->nlinks; i++) {
        const struct thud_link_result *l = &site->own->result->link[i];
        char name[2 * THUD_NAME_MAX];
        thud_link_name(site->scene, i, name, sizeof name);
        thud_document_item(d, "Link %d, %s (%s), in every case: largest force %s kN, stroke %s mm, %s kJ lost.", i + 1,
                           name, thud_link_law_name(site->scene, i), thud_site_number(1e-3 * l->force.value, 4).text,
                           thud_site_number(1e3 * l->stroke.value, 4).text, thud_site_number(1e-3 * l->lost_j, 4).text);
    }
}

/* ---- the ground motion ---- */

static void motion(struct site *site)
{
    enum { POINTS = 200, MARKS = THUD_STRUCTURES_MAX };
    struct thud_document *d = &site->document;
    struct thud_spectrum_point *point;
    struct thud_period_mark mark[MARKS];
    int nmarks = 0;
    static const double damping = 0.05;
    if (!site->record)
        return;
    char peak[96];
    thud_record_peak_text(site->record, peak, sizeof peak);
    struct thud_intensity m = thud_intensity_of(site->record);
    thud_document_heading(d, "The ground motion");
    thud_document_paragraph(d,
                            "%s (%s)%s: %zu samples every %.4g s, %.4g s long; %s at %.4g s, peak velocity %.3g m/s, "
                            "Arias intensity %.3g m/s, significant duration (5 to 95 %%) %.3g s.",
                            thud_path_name(site->record->file), site->record->format,
                            site->record->synthetic ? ", synthetic: " THUD_RECORD_COMPUTED : "", site->record->samples,
                            site->record->dt_s, m.duration_s, peak, m.pga_time_s, m.pgv_mps, m.arias_mps, m.d5_95_s);
    thud_document_table(d, "Spectral acceleration at the fundamental periods, with the damping of each building");
    thud_document_cell(d, "structure");
    thud_document_cell(d, "T1 s");
    thud_document_cell(d, "damping %%");
    thud_document_cell(d, "Sa g");
    thud_document_cell(d, "Sd cm");
    thud_document_row(d);
    for (int s = 0; s < site->scene->nstructures; s++) {
        const struct thud_structure_result *r = &site->own->result->structure[s];
        if (!thud_site_is_building(site, s))
            continue;
        double zeta = thud_gap_damping(site->own->solution.model, s);
        struct thud_spectrum_point p = thud_spectrum_at(site->record, r->period_s[0], zeta);
        thud_document_cell(d, "%s", thud_site_name(site, s));
        thud_document_cell(d, "%.3f", r->period_s[0]);
        thud_document_cell(d, "%.3g", 100 * zeta);
        thud_document_cell(d, "%.3g", p.acceleration_mps2 / THUD_GRAVITY);
        thud_document_cell(d, "%.3g", 100 * p.displacement_m);
        thud_document_row(d);
        mark[nmarks].period_s = r->period_s[0];
        snprintf(mark[nmarks].text, sizeof mark[nmarks].text, "%.40s", thud_site_name(site, s));
        nmarks++;
    }
    thud_site_figure(site, thud_figure_of_motion(site->record, "motion", thud_path_name(site->record->file)), 0.8,
                     "Acceleration, velocity and displacement of the ground.");
    point = malloc(POINTS * sizeof *point);
    if (!point) {
        d->failed = true;
        return;
    }
    thud_spectrum_fill(site->record, damping, 0.02, 10, POINTS, point);
    thud_site_figure(
        site, thud_figure_of_spectrum(point, POINTS, damping, mark, nmarks, "spectrum", "Response spectrum"), 0.8,
        "Response spectrum of the ground motion at 5 % damping, with the fundamental periods of the buildings.");
    free(point);
}

/* ---- the cases ---- */

static bool has_values(const struct site *site, int s, const struct floor_table *table)
{
    for (int i = 0; i < site->ncases; i++)
        for (int f = 0; f < site->cases[i].result->structure[s].floors; f++)
            if (!isnan(table->value(&site->cases[i].result->structure[s], f)))
                return true;
    return false;
}

static void add_case_table(struct site *site, int s, const struct floor_table *table)
{
    struct thud_document *d = &site->document;
    char caption[THUD_NAME_MAX + 96];
    if ((table->storeys && !thud_site_is_building(site, s)) || !has_values(site, s, table))
        return;
    snprintf(caption, sizeof caption, table->caption, thud_site_name(site, s));
    thud_document_table(d, caption);
    thud_document_cell(d, "%s", table->row);
    for (int i = 0; i < site->ncases; i++)
        thud_document_cell(d, "%s", site->cases[i].name);
    thud_document_cell(d, "no bumper / no pounding");
    if (site->ncases > SITE_BUMPER)
        thud_document_cell(d, "bumper / no bumper");
    thud_document_row(d);
    for (int f = site->cases[0].result->structure[s].floors - 1; f >= 0; f--) {
        double value[SITE_CASES];
        const int slab = table->storeys && site->scene->structure[s].kind == THUD_ISOLATED;
        if (f < slab)
            thud_document_cell(d, "isolators");
        else
            thud_document_cell(d, "%d", f + 1 - slab);
        for (int i = 0; i < site->ncases; i++) {
            value[i] = table->value(&site->cases[i].result->structure[s], f);
            thud_document_cell(d, "%s", isnan(value[i]) ? "-" : thud_site_number(value[i] / table->unit, 4).text);
        }
        for (int i = 1; i < site->ncases; i++)
            if (value[i - 1] > 0 && value[i] >= 0)
                thud_document_cell(d, "%.3f", value[i] / value[i - 1]);
            else
                thud_document_cell(d, "-");
        thud_document_row(d);
    }
}

/* "5-5" between two structures, else with their names. */
static void add_level_cell(struct site *site, int interface, int left, int right, int struck)
{
    char between[320];
    thud_site_sides(site, interface, left, right, struck, between, sizeof between);
    if (site->scene->nstructures == 2 && left > 0 && right > 0)
        thud_contact_pair_name(left, right, struck, between, sizeof between);
    thud_document_cell(&site->document, "%s", between);
}

/* What is told of every contact; a column that no contact has a value for is left out. */
static double impacts_of(const struct thud_contact_result *r)
{
    return r->impacts;
}
static double force_of(const struct thud_contact_result *r)
{
    return r->force.value;
}
static double indentation_of(const struct thud_contact_result *r)
{
    return r->indentation.value;
}
static const struct contact_column {
    const char *name;
    double unit;
    int digits;                                           /* significant ones; 0: a count */
    double (*value)(const struct thud_contact_result *r); /* SI; NaN: there is none */
} contact_column[] = {
    {"impacts", 1, 0, impacts_of}, {"force MN", 1e6, 4, force_of}, {"compressed mm", 1e-3, 3, indentation_of}};
enum { CONTACT_COLUMNS = sizeof contact_column / sizeof *contact_column };

static bool has_column(const struct site *site, const struct contact_column *column)
{
    for (int i = SITE_NONE; i < site->ncases; i++)
        for (int c = 0; c < site->cases[i].result->ncontacts; c++)
            if (!isnan(column->value(&site->cases[i].result->contact[c])))
                return true;
    return false;
}

static void add_contact_table(struct site *site)
{
    struct thud_document *d = &site->document;
    if (site->own->result->ncontacts == 0)
        return;
    thud_document_table(d, "Contacts");
    thud_document_cell(d, "floors");
    for (int i = SITE_NONE; i < site->ncases; i++)
        for (int k = 0; k < CONTACT_COLUMNS; k++)
            if (has_column(site, &contact_column[k]))
                thud_document_cell(d, "%s: %s", site->cases[i].name, contact_column[k].name);
    thud_document_row(d);
    for (int c = site->own->result->ncontacts - 1; c >= 0; c--) {
        const struct thud_contact_result *p = &site->own->result->contact[c];
        add_level_cell(site, p->interface, p->left_floor, p->right_floor, p->struck);
        for (int i = SITE_NONE; i < site->ncases; i++)
            for (int k = 0; k < CONTACT_COLUMNS; k++) {
                const struct contact_column *column = &contact_column[k];
                double value = column->value(&site->cases[i].result->contact[c]) / column->unit;
                if (has_column(site, column))
                    thud_document_cell(d, "%s", isnan(value) ? "-" : thud_site_number(value, column->digits).text);
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
    bool limited = false;
    for (int k = 0; k < own->ncolumns; k++)
        limited = limited || !isnan(own->column[k].ratio);
    if (own->ncolumns == 0)
        return;
    thud_document_table(d, "Columns that slabs strike: largest shear and moment at their ends");
    thud_document_cell(d, "columns below");
    for (int i = SITE_NONE; i < site->ncases; i++) {
        thud_document_cell(d, "%s: shear kN", site->cases[i].name);
        thud_document_cell(d, "%s: moment kN m", site->cases[i].name);
        if (limited)
            thud_document_cell(d, "%s: shear / capacity", site->cases[i].name);
    }
    thud_document_row(d);
    for (int k = own->ncolumns - 1; k >= 0; k--) {
        thud_document_cell(d, "%s", columns_name(site, &own->column[k], name, sizeof name));
        for (int i = SITE_NONE; i < site->ncases; i++) {
            const struct thud_column_result *r = &site->cases[i].result->column[k];
            thud_document_cell(d, "%s", thud_site_number(1e-3 * larger_of(r, THUD_COLUMN_SHEAR_LOWER), 4).text);
            thud_document_cell(d, "%s", thud_site_number(1e-3 * larger_of(r, THUD_COLUMN_MOMENT_LOWER), 4).text);
            if (limited)
                thud_document_cell(d, "%s", isnan(r->ratio) ? "-" : thud_site_number(r->ratio, 3).text);
        }
        thud_document_row(d);
    }
}

static struct thud_figure_source source_of(const struct site_case *one)
{
    return thud_run_source(one->name, one->scene, one->solution.run);
}

static void floors(struct site *site)
{
    struct thud_document *d = &site->document;
    const struct thud_floor_spectra *s = site->floors;
    int k;
    if (!s)
        return;
    thud_document_table(d, "What equipment on the floors struck hardest feels: largest pseudo-acceleration of "
                           "oscillators with 5 % damping, g, and its period");
    thud_document_cell(d, "floor");
    for (int i = 0; i < s->ncases; i++)
        thud_document_cell(d, "%s", thud_floor_case_title(i));
    thud_document_row(d);
    for (int f = 0; f < s->nfloors; f++) {
        thud_document_cell(d, "%s, floor %d", thud_site_name(site, s->floor[f].structure), s->floor[f].floor + 1);
        for (int i = 0; i < s->ncases; i++) {
            const double *sa = thud_floor_spectrum(s, i, f, &k);
            thud_document_cell(d, "%.3g at %.3g s", sa[k] / THUD_GRAVITY, s->period_s[k]);
        }
        thud_document_row(d);
    }
    thud_site_figure(site, thud_figure_of_floors(site->scene, s), 0.4 * s->nfloors,
                     "Floor spectra of the floors struck hardest, 5 % damping.");
}

static void cases(struct site *site)
{
    struct thud_document *d = &site->document;
    struct thud_figure_source source[SITE_CASES];
    thud_document_heading(d, "No pounding, no bumper, bumper");
    for (int s = 0; s < site->scene->nstructures; s++)
        if (thud_site_is_building(site, s) || site->scene->structure[s].kind == THUD_RIGID) {
            for (int i = 0; i < FLOOR_TABLES; i++)
                add_case_table(site, s, &floor_table[i]);
        }
    add_contact_table(site);
    add_column_table(site);
    for (int i = 0; i < site->ncases; i++)
        source[i] = source_of(&site->cases[i]);
    if (thud_run_figure_has(THUD_FIGURE_ENVELOPE, source, site->ncases))
        thud_site_figure(site, thud_run_figure(THUD_FIGURE_ENVELOPE, source, site->ncases), 0,
                         "Largest values over the height, in each case.");
    if (thud_run_figure_has(THUD_FIGURE_FORCE, &source[SITE_NONE], site->ncases - 1))
        thud_site_figure(site, thud_run_figure(THUD_FIGURE_FORCE, &source[SITE_NONE], site->ncases - 1), 0.62,
                         "Force of the contact with the largest one, and its largest impact seen closer.");
    if (thud_run_figure_has(THUD_FIGURE_COLUMNS, &source[SITE_NONE], site->ncases - 1))
        thud_site_figure(site, thud_run_figure(THUD_FIGURE_COLUMNS, &source[SITE_NONE], site->ncases - 1), 0.62,
                         "Largest shear of the columns that slabs strike, over the height.");
    floors(site);
}

/* ---- the gap that is enough ---- */

/* A length in other units, with so many decimals; -: there is none. */
static void add_gap_cell(struct thud_document *d, int decimals, double value)
{
    if (isnan(value))
        thud_document_cell(d, "-");
    else
        thud_document_cell(d, "%.*f", decimals, value);
}

/* What every rule asks for at the level where it asks for most. */
static void gap_rules(struct site *site)
{
    struct thud_document *d = &site->document;
    double needed = thud_needed_gap_widest(site->gap, 0, THUD_GAP_EXACT, NULL);
    thud_document_table(d, "Gap by rule, mm");
    for (int i = 0; i < 4; i++)
        thud_document_cell(d, "%s", ((const char *const[]){"rule", "clause", "formula", "mm"})[i]);
    thud_document_row(d);
    for (int rule = 0; rule < (int)THUD_GAP_RULES; rule++) {
        const struct thud_gap_rule *r = thud_gap_rule_at(rule);
        int level = 0;
        struct thud_text numbers = {0};
        double widest = thud_needed_gap_widest(site->gap, 0, rule, &level);
        thud_document_cell(d, "%s", r->name);
        thud_document_cell(d, "%s%s%s%s%s%s%s", r->edition, *r->edition ? ", " : "", r->clause, *r->clause ? ": " : "",
                           r->title, *r->source ? "; " : "", r->source);
        thud_gap_numbers(&site->gap->level[level], rule, &numbers);
        thud_document_cell(d, "%s%s%s", r->formula, isnan(widest) ? ": " : " = ",
                           isnan(widest)  ? r->lacks
                           : numbers.data ? numbers.data
                                          : "");
        add_gap_cell(d, 1, 1e3 * widest);
        thud_document_row(d);
        thud_text_clear(&numbers);
    }
    for (int rule = 0; rule < (int)THUD_GAP_RULES; rule++) {
        double ruled = thud_needed_gap_widest(site->gap, 0, rule, NULL);
        if (thud_gap_falls_short(ruled, needed))
            thud_document_item(d, "%s asks for %s cm, less than the %s cm that this motion needs.",
                               thud_gap_rule_at(rule)->name, thud_site_number(100 * ruled, 3).text,
                               thud_site_number(100 * needed, 3).text);
    }
    thud_document_paragraph(
        d, "EN (2)(a) and ASCE line are of buildings that do not belong to one owner: each keeps its own "
           "displacement from the property line, so that the gap is the sum. The codes take design "
           "displacements; here they are those of this one motion.");
}

static void gap(struct site *site)
{
    struct thud_document *d = &site->document;
    if (!site->gap || site->gap->nlevels == 0)
        return;
    thud_document_heading(d, "The gap that is enough");
    thud_document_paragraph(
        d, "What each level needs so that there is no contact under this ground motion, from the motion "
           "without pounding: exactly (the largest relative displacement), and by rules that know the two largest "
           "displacements alone. Centimetres, between the bare faces; a bumper takes its own "
           "besides.");
    thud_document_table(d, "Needed gap, cm");
    thud_document_cell(d, "floors");
    thud_document_cell(d, "left moves");
    thud_document_cell(d, "right moves");
    for (int rule = THUD_GAP_EXACT; rule < (int)THUD_GAP_SHORT; rule++)
        thud_document_cell(d, "%s", thud_gap_rule_at(rule)->name);
    thud_document_row(d);
    for (int i = site->gap->nlevels - 1; i >= 0; i--) {
        const struct thud_gap_level *l = &site->gap->level[i];
        add_level_cell(site, l->interface, l->left_floor, l->right_floor, l->struck);
        thud_document_cell(d, "%.2f", 100 * l->left_m);
        thud_document_cell(d, "%.2f", 100 * l->right_m);
        for (int rule = THUD_GAP_EXACT; rule < (int)THUD_GAP_SHORT; rule++)
            add_gap_cell(d, 2, 100 * thud_gap_value(l, rule));
        thud_document_row(d);
    }
    gap_rules(site);
}

/* ---- cautions ---- */

/* The largest drift of a building's elastic storeys over their height, and that storey (from 1). */
static double drift_ratio(const struct site *site, const struct site_case *one, int s, int *storey)
{
    const struct thud_structure *p = &site->scene->structure[s];
    int base = p->kind == THUD_ISOLATED; /* the slab's storey is the isolator */
    double most = 0;
    for (int i = base; thud_site_is_building(site, s) && i < one->result->structure[s].floors; i++) {
        const struct thud_structure_result *r = &one->result->structure[s];
        double ratio = r->storey && r->storey[i].yields ? 0 : r->floor[i].drift.value / p->height_m[i - base];
        if (ratio > most) {
            most = ratio;
            *storey = i + 1 - base;
        }
    }
    return most;
}

static int caution_drifts(struct site *site)
{
    int n = 0;
    for (int s = 0; s < site->scene->nstructures; s++) {
        char said[400] = "";
        size_t used = 0;
        for (int i = 0; i < site->ncases; i++) {
            int storey = 0;
            double ratio = drift_ratio(site, &site->cases[i], s, &storey);
            if (ratio > drift_limit)
                used += (size_t)snprintf(said + used, sizeof said - used, "%s%.2f %% %s (storey %d)", used ? ", " : "",
                                         100 * ratio, site->cases[i].words, storey);
        }
        if (used == 0)
            continue;
        thud_document_item(&site->document,
                           "Storeys of %s drift by more than %.0f %% of their height: %s. A real storey yields there; "
                           "the storeys here are elastic, so that the true response differs.",
                           thud_site_name(site, s), 100 * drift_limit, said);
        n++;
    }
    return n;
}

/* A factor beyond 4 or 1/4, a vertical component. Of a suite its section tells them. */
static int caution_motion(struct site *site)
{
    struct thud_error remark;
    int n = 0, from = 0;
    for (; site->record && !site->suite.runs && thud_suite_remark(&site->record, NULL, 1, &from, &remark); n++)
        thud_document_item(&site->document, "%s (%s).", remark.what, remark.allowed);
    return n;
}

static int caution_synthetic(struct site *site)
{
    if (!site->record || !site->record->synthetic)
        return 0;
    thud_document_item(&site->document,
                       "The ground motion %s is synthetic: " THUD_RECORD_COMPUTED
                       ". No earthquake was like this; a design needs recorded motions.",
                       thud_path_name(site->record->file));
    return 1;
}

/* What a case says that the one before it does not: without yielding, stability coefficients are the same in all. */
static int caution_storeys(struct site *site)
{
    struct thud_error remark, before;
    int n = 0;
    for (int i = SITE_NONE; i < site->ncases; i++)
        for (int k = 0; thud_storey_remark(site->scene, site->cases[i].result, k, &remark); k++) {
            bool told = false;
            for (int j = 0;
                 i > SITE_NONE && !told && thud_storey_remark(site->scene, site->cases[i - 1].result, j, &before); j++)
                told = strcmp(before.what, remark.what) == 0;
            if (told)
                continue;
            thud_document_item(&site->document, "%c%s: %s (%s).", site->cases[i].words[0] - 'a' + 'A',
                               site->cases[i].words + 1, remark.what, remark.allowed);
            n++;
        }
    return n;
}

static int caution_bumpers(struct site *site)
{
    int n = 0;
    for (int c = 0; c < site->own->result->ncontacts; c++) {
        const struct thud_contact_result *r = &site->own->result->contact[c];
        const struct thud_interface *f = &site->own->scene->interface[r->interface - 1];
        double strain = f->has_bumper ? r->indentation.value / f->bumper_thickness_m : 0;
        double limit = thud_interface_max_strain(f);
        char between[320];
        thud_site_sides(site, r->interface, r->left_floor, r->right_floor, r->struck, between, sizeof between);
        if (strain > 1)
            thud_document_item(&site->document,
                               "The bumper between %s would be compressed by %.0f mm, more than its thickness of %.0f "
                               "mm: it is too soft or too thin, and the force beyond is an assumption.",
                               between, 1e3 * r->indentation.value, 1e3 * f->bumper_thickness_m);
        else if (strain > limit)
            thud_document_item(
                &site->document,
                "The bumper between %s is compressed to %.0f %% of its thickness, past the %.0f %% up to "
                "which its law is known: there the post-yield stiffness, an assumption, sets the force.",
                between, 100 * strain, 100 * limit);
        n += strain > 1 || strain > limit;
    }
    return n;
}

static int caution_values(struct site *site)
{
    struct thud_error unusual;
    char line[1400];
    int n = 0;
    for (; thud_scene_warning(site->scene, n, &unusual); n++)
        thud_document_item(&site->document, "%s", thud_error_text(&unusual, line, sizeof line));
    return n;
}

static int caution_digits(struct site *site)
{
    const struct thud_contact_result *most = thud_site_strongest(site->own->result);
    int n = 0;
    if (most && site->sensitivity) {
        double spread = thud_spread_most(&site->sensitivity->contact[most - site->own->result->contact][0]);
        if (spread > 0.5) {
            thud_document_item(
                &site->document,
                "The largest force changes by %.0f %% when an input changes by %.0f %%: read it as an order "
                "of magnitude.",
                100 * spread, 100 * site->sensitivity->change);
            n++;
        }
    }
    for (int i = 0; i < site->ncases; i++)
        if (site->cases[i].result->energy.error_ratio > 1e-3) {
            thud_document_item(&site->document, "%.2g %% of the energy is unaccounted for %s.",
                               100 * site->cases[i].result->energy.error_ratio, site->cases[i].words);
            n++;
        }
    return n;
}

/* What matters most comes first. */
static int all_cautions(struct site *site)
{
    typedef int caution(struct site * site);
    static caution *const each[] = {say_failures,   caution_synthetic, caution_motion, caution_storeys,
                                    caution_drifts, caution_bumpers,   caution_digits, caution_values};
    int n = 0;
    for (size_t i = 0; i < sizeof each / sizeof *each; i++)
        n += each[i](site);
    return n;
}

enum { FOREMOST = 3 };

/* What a reader has to know before the numbers. */
static void foremost(struct site *site)
{
    struct thud_document *d = &site->document;
    thud_document_heading(d, "What to know first");
    size_t from = d->n;
    int n = all_cautions(site);
    if (n > FOREMOST) {
        thud_document_cut(d, from + FOREMOST);
        thud_document_paragraph(d, "%d more under Cautions.", n - FOREMOST);
    } else if (n == 0) {
        thud_document_paragraph(d, "No caution: see Cautions for what was looked at.");
    }
}

static void cautions(struct site *site)
{
    thud_document_heading(&site->document, "Cautions");
    if (all_cautions(site) == 0)
        thud_document_paragraph(&site->document,
                                "None of the checks has anything to remark: drifts, compression of the "
                                "bumper, values, energy, sensitivity of the force.");
}

/* ---- a second method ---- */

static void second(struct site *site)
{
    struct thud_document *d = &site->document;
    thud_document_heading(d, "Checks made: a second method");
    if (site->second.values == 0) {
        thud_document_paragraph(
            d,
            "Not done: the scene is so stiff that %s, which was to compute it once more, takes more "
            "steps than are given to it. Of the energy, %.1e is unaccounted for.",
            site->second.method, site->own->result->energy.error_ratio);
        return;
    }
    thud_document_paragraph(
        d,
        "The scene %s was computed by %s and once more by %s, which shares no time stepping with it: "
        "%d values were compared. The largest relative difference is %.1e (%s); %s. Of the energy, "
        "%.1e is unaccounted for.",
        site->own->words, site->own->result->method, site->second.method, site->second.values, site->second.difference,
        site->second.of, site->second.counts == 0 ? "all impact counts are equal" : "impact counts differ",
        site->own->result->energy.error_ratio);
    if (site->second.difference > 1e-3 || site->second.counts > 0)
        thud_document_paragraph(d,
                                "The two methods do not agree to three digits. Take no number from this report before "
                                "it is clear why.");
    thud_document_paragraph(d, "This says that the equations are solved right, not that they are the right equations: "
                               "the command thud verify --published shows what is validated and what is not.");
}

static void limits(struct site *site)
{
    struct thud_document *d = &site->document;
    thud_document_heading(d, "Checks not made");
    if (site->suite.runs)
        thud_document_item(d,
                           "%d ground motions, scaled as they were given: whether they stand for what this site has to "
                           "expect is not judged here. The tables and figures of single floors are under one of them.",
                           site->suite.runs->nrecords);
    else
        thud_document_item(d, "One ground motion proves nothing about a gap: another of the same size can need more. A "
                              "suite (--records) adds shares and fractiles over several.");
    if (site->uncertainty)
        thud_document_item(d, "The samples change the inputs that are listed with their sizes, and nothing else: laws, "
                              "rigid floors and all that is said here are those of every sample.");
    thud_document_item(d,
                       "%s storeys, rigid floors, motion in one direction, no torsion, no soil, the same ground "
                       "motion under all buildings.",
                       thud_scene_yields(site->scene) ? "Elastic or bilinear" : "Elastic");
    thud_document_item(d,
                       "%s; stiffness and restitution of the contacts are assumptions of the literature, not "
                       "measurements on these buildings.",
                       site->own->result->ncolumns > 0
                           ? "Slabs meet floors, and strike columns that stay elastic and whole whatever they bear"
                           : "Contact between floors at the same elevation");
}

/* ---- to repeat it ---- */

static void provenance(struct site *site)
{
    struct thud_document *d = &site->document;
    struct thud_text version = {0};
    char *text = NULL;
    unsigned long size;
    thud_document_heading(d, "To repeat this");
    thud_version_text(&version);
    thud_document_lines(d, version.data ? version.data : "");
    d->failed = d->failed || version.failed;
    thud_text_clear(&version);
    thud_document_lines(d, site->options->command);
    thud_document_paragraph(d, "The preset, with every change made on the command line:");
    if (thud_preset_text(site->session->preset, site->scene, &text, &size, NULL) == THUD_OK)
        thud_document_lines(d, text);
    else
        d->failed = true;
    free(text);
}

typedef void section(struct site *site);
static section *const sections[] = {
    thud_site_verdicts,     foremost, solution, scene,  thud_site_inputs, motion, cases, gap, thud_site_suite_section,
    thud_site_sure_section, cautions, second,   limits, provenance};

enum thud_status thud_site_write(struct site *site, struct thud_error *err)
{
    char title[THUD_TEXT_MAX + 64];
    const char *name = site->scene->title[0] ? site->scene->title : site->scene->name;
    snprintf(title, sizeof title, "Pounding report: %s", name);
    thud_document_title(&site->document, title);
    thud_site_title_block(site);
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++)
        sections[i](site);
    if (site->pictures == THUD_CANCELLED) {
        if (err)
            *err = site->picture_error;
        return THUD_CANCELLED;
    }
    return site->document.failed ? thud_error_set(err, THUD_MEMORY, "out of memory") : THUD_OK;
}
