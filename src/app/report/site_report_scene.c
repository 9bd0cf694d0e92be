/* The scene that was computed: the drawing, the structures, and the ground motions as load cases. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/report/site_report_private.h"
#include "ground/identity.h"
#include "ground/intensity.h"
#include "ground/spectrum.h"
#include "plot/figures/figures_record.h"
#include "plot/figures/figures_scene.h"
#include "plot/figures/figures_suite.h"
#include "study/scene/building.h"
#include "study/sweep/sweep_table.h"

static void add_structure_rows(struct site *site)
{
    struct thud_document *d = &site->document;
    static const char *const kinds[] = {
        "shear building",        "rigid body",        "isolated building", "wall", "building by its matrix",
        "building by its modes", "estimated building"};
    thud_document_table(d, site->scene->nlinks > 0
                               ? "Structures from left to right; T1, T2, T3: periods of each without the links"
                               : "Structures from left to right");
    thud_document_head(d, "structure|kind|storeys|height m|mass t|damping %|T1 s|T2 s|T3 s");
    for (int s = 0; s < site->scene->nstructures; s++) {
        const struct thud_structure *p = &site->scene->structure[s];
        const struct thud_structure_result *r = &site->cases[SITE_FREE].result->structure[s];
        const bool gives = thud_wall_gives(p), building = thud_site_is_building(site, s);
        double mass = p->kind == THUD_ISOLATED ? p->base_mass_kg : gives ? p->wall_mass_kg : 0, height = 0;
        for (int i = 0; i < p->storeys; i++) {
            mass += p->mass_kg[i];
            height += p->height_m[i];
        }
        thud_document_cell(d, "%s", thud_site_name(site, s));
        thud_document_cell(d, "%s", gives ? "flexible wall" : kinds[p->kind]);
        thud_document_cell(d, building ? "%d" : "-", p->storeys);
        thud_document_cell(d, building ? "%.4g" : "-", height);
        thud_document_cell(d, mass > 0 ? "%.5g" : "-", 1e-3 * mass);
        thud_document_cell(d, building || gives ? "%.3g" : "-", 100 * (gives ? thud_wall_damping(p) : p->damping));
        for (int m = 0; m < 3; m++)
            if (m < r->floors && isfinite(r->period_s[m]))
                thud_document_cell(d, "%.3f", r->period_s[m]);
            else
                thud_document_cell(d, "-");
        thud_document_row(d);
    }
}

/* Of a building of storeys, from the top: stiffness, what yields it, the weight above it, and that weight's share which
 * yields it. */
static void add_storeys(struct site *site, int s)
{
    struct thud_document *d = &site->document;
    const struct thud_structure *p = &site->scene->structure[s];
    char caption[THUD_NAME_MAX + 96];
    bool yields = false;
    if (!thud_site_is_building(site, s) || thud_kind_is_read(p->kind))
        return;
    for (int i = 0; i < p->storeys; i++)
        yields = yields || isfinite(thud_structure_yield(p, i));
    snprintf(caption, sizeof caption, "Storeys of %s; W: weight of all floors above the storey",
             thud_site_name(site, s));
    thud_document_table(d, caption);
    thud_document_head(d, yields ? "storey|height m|mass t|k MN/m|W MN|V_y MN|u_y mm|V_y/W"
                                 : "storey|height m|mass t|k MN/m|W MN");
    for (int i = p->storeys - 1; i >= 0; i--) {
        const struct thud_storey of = thud_storey_of(p, i);
        thud_document_cells(d, "%d\t%.4g\t%.5g\t%.5g\t%s", i + 1, p->height_m[i], 1e-3 * p->mass_kg[i],
                            1e-6 * of.stiffness_npm, thud_site_number(1e-6 * of.weight_n, 3).text);
        const double of_yield[] = {1e-6 * of.yield_shear_n, 1e3 * of.yield_m, of.yield_ratio};
        for (int k = 0; yields && k < 3; k++)
            thud_document_cell(d, "%s", thud_site_number(of_yield[k], 3).text);
        thud_document_row(d);
    }
}

/* Periods of isolators that yield or slide: those above are of their initial stiffness, which they leave at once. */
static void say_sliding(struct site *site, int s)
{
    const struct thud_structure *p = &site->scene->structure[s];
    if (p->kind != THUD_ISOLATED || !thud_isolator_slides(p))
        return;
    const struct thud_isolator own = thud_structure_isolator(p);
    const double mass_kg = thud_isolated_weight(p) / THUD_GRAVITY;
    thud_document_item(&site->document,
                       "Periods of %s, and Sa and Sd at its T1, apply before its isolators %s. As a rigid body on the "
                       "stiffness beyond, K_d = %s MN/m, the building has the period 2 pi sqrt(m/K_d) = %.3f s.",
                       thud_site_name(site, s), own.law == THUD_ISOLATOR_PENDULUM ? "slide" : "yield",
                       thud_site_number(1e-6 * own.hardening * own.stiffness_npm, 3).text,
                       2 * acos(-1) * sqrt(mass_kg / (own.hardening * own.stiffness_npm)));
}

/* Of matrices and modes. */
static void add_building_files(struct site *site)
{
    struct thud_document *d = &site->document;
    bool any = false;
    for (int s = 0; s < site->scene->nstructures; s++) {
        const struct thud_structure *p = &site->scene->structure[s];
        if (!p->file_sha256[0])
            continue;
        if (!any) {
            thud_document_table(d, "Files of matrices and modes");
            thud_document_head(d, "structure|file|SHA-256");
        }
        any = true;
        thud_document_line(d, "%s\t%s\t%s", thud_site_name(site, s), thud_path_name(thud_structure_file(p)),
                           p->file_sha256);
    }
}

void thud_site_scene(struct site *site)
{
    struct thud_document *d = &site->document;
    thud_document_heading(d, "Buildings and gap");
    add_structure_rows(site);
    for (int s = 0; s < site->scene->nstructures; s++)
        add_storeys(site, s);
    add_building_files(site);
    for (int s = 0; s < site->scene->nstructures; s++)
        say_sliding(site, s);
    for (int i = 0; i + 1 < site->scene->nstructures; i++) {
        char gap[64], thickness[64], clearance[2048];
        const struct thud_interface *f = &site->scene->interface[i];
        thud_interface_gap_text(f, gap, sizeof gap);
        thud_interface_thickness_text(f, thickness, sizeof thickness);
        thud_interface_clearance_text(site->scene, i, clearance, sizeof clearance);
        if (f->has_bumper)
            thud_document_item(d,
                               "Clearance between %s and %s: %s (gap %s, thickness of the bumper %s, cavity %.4g cm).",
                               thud_site_name(site, i), thud_site_name(site, i + 1), clearance, gap, thickness,
                               100 * f->bumper_cavity_m);
    }
    thud_site_figure(site, thud_figure_of_scene(site->scene, "scene", ""), 0.5,
                     "Elevation of the buildings, levels in metres, and the model that is computed.");
}

/* ---- load cases ---- */

/* What is known of a ground motion, "-" where it says nothing. */
static const char *or_dash(const char *text)
{
    return *text ? text : "-";
}

/* Of the first mode of structure s: its pseudo-acceleration omega^2 Sd in g; *sd_m the largest displacement. */
static double first_mode(const struct site *site, const struct thud_record *record, int s, double *sd_m)
{
    const double period = site->own->result->structure[s].period_s[0], omega = 2 * acos(-1) / period;
    *sd_m = thud_spectrum_at(record, period, thud_gap_damping(site->cases[SITE_NONE].solution.model, s)).displacement_m;
    return omega * omega * *sd_m / THUD_GRAVITY;
}

static void add_case_row(struct site *site, int number, const struct thud_record *record)
{
    struct thud_document *d = &site->document;
    double sd_m;
    thud_document_cells(d, "%d\t%s\t%s\t%s\t%.4g\t%s", number,
                        *record->event ? record->event : thud_path_name(record->file),
                        record->synthetic ? "none: synthetic" : or_dash(record->station), or_dash(record->component),
                        record->scale, thud_site_number(thud_record_peak(record) / THUD_GRAVITY, 3).text);
    for (int s = 0; s < site->scene->nstructures; s++)
        if (thud_site_is_building(site, s))
            thud_document_cell(d, "%s", thud_site_number(first_mode(site, record, s, &sd_m), 3).text);
    thud_document_row(d);
}

static void add_load_cases(struct site *site, const struct thud_record *const *record, int n)
{
    struct thud_document *d = &site->document;
    char head[1024] = "no.|event, or file|station|component|factor|peak g";
    size_t used = strlen(head);
    for (int s = 0; s < site->scene->nstructures && used + 100 < sizeof head; s++)
        if (thud_site_is_building(site, s))
            used += (size_t)snprintf(head + used, sizeof head - used, "|Sa g at T1 of %.64s", thud_site_name(site, s));
    thud_document_table(d, "Load cases; Sa: pseudo-acceleration with the damping of each building");
    thud_document_head(d, head);
    for (int r = 0; r < n; r++)
        add_case_row(site, r + 1, record[r]);
    thud_document_table(d, n > 1 ? "Files of the ground motions; reversed motions have the same file"
                                 : "File of the ground motion");
    thud_document_head(d, "no.|file|licence|SHA-256");
    for (int r = 0; r < n; r++) {
        if (r > 0 && thud_motion_is_turned(record[r]->file, record[r - 1]->file))
            continue;
        thud_document_line(d, "%d\t%s\t%s\t%s", r + 1,
                           thud_path_name(site->options->records->source[site->suite.leads ? r : site->detail].path),
                           *record[r]->licence || !record[r]->synthetic ? or_dash(record[r]->licence)
                                                                        : "none: synthetic",
                           or_dash(record[r]->sha256));
    }
}

/* The load cases against the target, over 0.2 of the least to twice the largest first period. */
static void suite_spectra(struct site *site, const struct thud_period_mark *mark, int nmarks)
{
    const struct thud_target *target = site->options->target;
    const struct site_suite *suite = &site->suite;
    struct thud_scaled_suite scaled;
    struct thud_scaling how;
    char words[320] = "";
    if (!suite->leads || nmarks == 0)
        return;
    thud_scaling_init(&how);
    how.as_given = true;
    how.from_s = INFINITY, how.to_s = 0;
    for (int i = 0; i < nmarks; i++) {
        how.from_s = fmin(how.from_s, 0.2 * mark[i].period_s);
        how.to_s = fmax(how.to_s, 2 * mark[i].period_s);
    }
    if (thud_suite_scale(suite->plan.record, suite->plan.nrecords, target, &how, &scaled, NULL) != THUD_OK)
        return; /* its motions resolve no such period */
    if (target) {
        thud_target_words(target, words, sizeof words);
        thud_document_paragraph(&site->document,
                                "Target of the suite: %s, damping %.3g %%. The mean of the load cases is at least %.3g "
                                "times the target (at %.3g s), over periods of %.3g to %.3g s.",
                                words, 100 * target->damping, scaled.ratio, scaled.ratio_s, scaled.period_s[0],
                                scaled.period_s[THUD_TARGET_PERIODS - 1]);
    }
    site->suite.drawing = true;
    thud_site_figure(site, thud_figure_of_suite(&scaled, target ? target->text : "", mark, nmarks), 0.5,
                     target
                         ? "Pseudo-acceleration spectra of the load cases with their factors, their mean, the target "
                           "and 90 % of it."
                         : "Pseudo-acceleration spectra of the load cases with their factors, and their mean.");
    site->suite.drawing = false;
    thud_scaled_suite_clear(&scaled);
}

void thud_site_loads(struct site *site)
{
    enum { POINTS = 200, MARKS = THUD_STRUCTURES_MAX };
    struct thud_document *d = &site->document;
    struct thud_spectrum_point *point;
    struct thud_period_mark mark[MARKS];
    int nmarks = 0;
    static const double damping = 0.05;
    if (!site->record)
        return;
    const struct thud_record *const *suite = site->suite.leads ? site->suite.plan.record : &site->record;
    struct thud_intensity m = thud_intensity_of(site->record);
    char peak[96], motion[320];
    thud_record_peak_text(site->record, peak, sizeof peak);
    thud_site_motion(site->record, motion, sizeof motion);
    thud_document_heading(d, "Load cases");
    thud_document_paragraph(d, "The ground motion acts along the line of the buildings and is the same under all of "
                               "them. Vertical loads only act through P-Delta effects, if included (input p-delta).");
    add_load_cases(site, suite, site->suite.leads ? site->suite.plan.nrecords : 1);
    thud_document_paragraph(d,
                            "Ground motion: %s, %zu samples every %.4g s, %.4g s long; %s at %.4g s. Peak velocity "
                            "%.3g m/s, Arias intensity %.3g m/s, significant duration (5 to 95 %%) %.3g s.",
                            motion, site->record->samples, site->record->dt_s, m.duration_s, peak, m.pga_time_s,
                            m.pgv_mps, m.arias_mps, m.d5_95_s);
    thud_document_table(d, "Response of each building's first mode to this ground motion");
    thud_document_head(d, "structure|T1 s|damping %|Sa g|Sd cm");
    for (int s = 0; s < site->scene->nstructures; s++) {
        const struct thud_structure_result *r = &site->own->result->structure[s];
        if (!thud_site_is_building(site, s))
            continue;
        double sd_m, sa_g = first_mode(site, site->record, s, &sd_m);
        thud_document_line(d, "%s\t%.3f\t%.3g\t%s\t%s", thud_site_name(site, s), r->period_s[0],
                           100 * thud_gap_damping(site->cases[SITE_NONE].solution.model, s),
                           thud_site_number(sa_g, 3).text, thud_site_number(100 * sd_m, 3).text);
        mark[nmarks].period_s = r->period_s[0];
        snprintf(mark[nmarks].text, sizeof mark[nmarks].text, "%.40s", thud_site_name(site, s));
        nmarks++;
    }
    suite_spectra(site, mark, nmarks);
    thud_site_figure(site, thud_figure_of_motion(site->record, "motion", ""), 0.4,
                     "Acceleration, velocity and displacement of the ground.");
    point = malloc(POINTS * sizeof *point);
    if (!point) {
        d->failed = true;
        return;
    }
    thud_spectrum_fill(site->record, damping, 0.02, 10, POINTS, point);
    thud_site_figure(site, thud_figure_of_spectrum(point, POINTS, damping, mark, nmarks, "spectrum", ""), 0.45,
                     "Response spectrum of the ground motion at 5 % damping, with the fundamental periods of the "
                     "buildings. Sa is the total acceleration, not the pseudo-acceleration of the tables.");
    free(point);
}
