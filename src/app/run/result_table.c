#include "app/run/result_table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/run/answer_line.h"
#include "app/run/sensitivity_table.h"
#include "base/largest.h"
#include "base/statistics.h"
#include "ground/identity.h"
#include "study/scene/level.h"
#include "study/sweep/remark.h"

static void add_head(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_scene *scene = report->scene;
    thud_text_append(out, "%s, case %s: %s\n", scene->name, report->which, scene->title);
    char peak[96];
    if (report->record) {
        thud_record_peak_text(report->record, peak, sizeof peak);
        thud_text_append(out, "ground motion  %s%s, %s, %zu samples every %.4g s\n", report->record->file,
                         thud_record_synthetic_mark(report->record), peak, report->record->samples,
                         report->record->dt_s);
    } else
        thud_text_append(out, "ground motion  none\n");
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        const struct thud_interface *f = &scene->interface[i];
        thud_text_append(out, "interface %d    gap %.4g cm", i + 1, 100 * f->gap_m);
        if (f->has_bumper)
            thud_text_append(out, ", %s bumper of %.4g cm in a cavity of %.4g cm", f->bumper.law->name,
                             100 * f->bumper_thickness_m, 100 * f->bumper_cavity_m);
        else
            thud_text_append(out, ", %s", f->contact.law->name);
        thud_text_append(out, ": clearance %.4g cm\n", 100 * thud_interface_clearance(f));
    }
}

/* The answer, for each two neighbours; a free body goes on for ever, and there is no gap that is enough. */
static void add_answers(const struct thud_report *report, struct thud_text *out)
{
    enum { COLUMNS = 65 };
    const struct thud_scene *scene = report->scene;
    const struct thud_result *r = report->result;
    for (int i = 1; i < scene->nstructures; i++) {
        struct thud_answer_line line = {.gap_m = scene->interface[i - 1].gap_m, .need_m = NAN};
        char text[160];
        for (int c = 0; c < r->ncontacts; c++)
            if (r->contact[c].interface == i) {
                line.impacts += r->contact[c].impacts;
                line.impulse_ns += r->contact[c].impulse_ns;
                line.force_n = thud_larger(line.force_n, thud_peak_force(&r->contact[c]));
            }
        bool free_body =
            scene->structure[i - 1].kind == THUD_RIGID || scene->structure[i].kind == THUD_RIGID || !report->gap;
        if (!free_body && thud_needed_gap_widest(report->gap, i, THUD_GAP_EXACT, NULL) >= 0) {
            line.need_m = thud_needed_gap_widest(report->gap, i, THUD_GAP_EXACT, NULL);
            line.abs_m = thud_needed_gap_widest(report->gap, i, THUD_GAP_ABS, NULL);
            line.srss_m = thud_needed_gap_widest(report->gap, i, THUD_GAP_SRSS, NULL);
        }
        thud_answer_line(&line, COLUMNS, text, sizeof text);
        if (scene->nstructures > 2)
            thud_text_append(out, "answer %-7d %s\n", i, text);
        else
            thud_text_append(out, "answer         %s\n", text);
    }
}

/* Places after the point that give the largest of a column `digits` significant digits: points stand below each other,
 * and no number has more than the largest can bear. -1: none of them is of a size to be written so. */
static int places_of(double largest, int digits)
{
    if (!(largest >= 1e-4) || largest >= 1e7)
        return -1;
    int places = digits - 1 - (int)floor(log10(largest) + 1e-9);
    return places > 0 ? places : 0;
}

static void add_number(struct thud_text *out, int width, int places, double value)
{
    if (places < 0 || !(fabs(value) < 1e9))
        thud_text_append(out, "%*.5g", width, value);
    else
        thud_text_append(out, "%*.*f", width, places, value);
}

static void add_floors(const struct thud_report *report, int s, bool isolated, struct thud_text *out)
{
    const struct thud_structure_result *r = &report->result->structure[s];
    double acceleration = 0, displacement = 0, velocity = 0, drift = 0;
    for (int i = 0; i < r->floors; i++) {
        acceleration = fmax(acceleration, r->floor[i].acceleration.value);
        displacement = fmax(displacement, 1e3 * r->floor[i].displacement.value);
        velocity = fmax(velocity, r->floor[i].velocity.value);
        drift = fmax(drift, 1e3 * r->floor[i].drift.value);
    }
    for (int i = r->floors - 1; i >= 0; i--) {
        const struct thud_floor_result *f = &r->floor[i];
        thud_text_append(out, "%5d  ", i + 1);
        if (thud_floor_struck(report->result, s, i))
            thud_text_append(out, "%12s %8s  ", "-", "-"); /* an impulse has no finite one */
        else {
            add_number(out, 12, places_of(acceleration, 5), f->acceleration.value);
            thud_text_append(out, " %8.3f  ", f->acceleration.time_s);
        }
        add_number(out, 12, places_of(displacement, 5), 1e3 * f->displacement.value);
        thud_text_append(out, " %8.3f  ", f->displacement.time_s);
        add_number(out, 8, places_of(velocity, 4), f->velocity.value);
        thud_text_append(out, "  ");
        add_number(out, 8, places_of(drift, 4), 1e3 * f->drift.value);
        thud_text_append(out, " %8.3f%s\n", f->drift.time_s, isolated && i == 0 ? "  base" : "");
    }
}

/* The storeys that yield, from the top down; an isolated building's first storey is its isolators. */
static void add_storeys(const struct thud_structure_result *r, struct thud_text *out)
{
    double permanent = 0, lost = 0, shear = 0;
    for (int i = 0; r->storey && i < r->floors; i++) {
        permanent = fmax(permanent, 1e3 * fabs(r->storey[i].permanent_m));
        lost = fmax(lost, 1e-3 * r->storey[i].hysteretic_j);
        shear = fmax(shear, 1e-6 * r->storey[i].shear.value);
    }
    if (r->storey)
        thud_text_append(out,
                         "storey  yields at  ductility  permanent drift  excursions    lost       shear       at\n"
                         "               mm                          mm                  kJ          MN        s\n");
    for (int i = r->floors - 1; r->storey && i >= 0; i--) {
        const struct thud_storey_result *p = &r->storey[i];
        if (!p->yields) {
            thud_text_append(out, "%6d    elastic\n", i + 1);
            continue;
        }
        thud_text_append(out, "%6d  %9.4g  %9.3f  ", i + 1, 1e3 * p->yield_m, p->ductility);
        add_number(out, 15, places_of(permanent, 4), 1e3 * p->permanent_m);
        thud_text_append(out, "  %10d  ", p->excursions);
        add_number(out, 6, places_of(lost, 4), 1e-3 * p->hysteretic_j);
        thud_text_append(out, "  ");
        add_number(out, 10, places_of(shear, 5), 1e-6 * p->shear.value);
        thud_text_append(out, " %8.3f\n", p->shear.time_s);
    }
}

static void add_structure(const struct thud_report *report, int s, struct thud_text *out)
{
    const struct thud_structure_result *r = &report->result->structure[s];
    const struct thud_structure *p = &report->scene->structure[s];
    if (r->floors == 0)
        return;
    thud_text_append(out, "\n%s", p->name);
    for (int i = 0; i < r->floors && i < 3 && isfinite(r->period_s[i]); i++)
        thud_text_append(out, "%s T%d %.4g s", i > 0 ? "," : ":", i + 1, r->period_s[i]);
    if (r->base_shear.value > 0)
        thud_text_append(out, "; base shear %.5g MN at %.3f s", 1e-6 * r->base_shear.value, r->base_shear.time_s);
    thud_text_append(out, "\nfloor  acceleration       at  displacement       at  velocity     drift       at\n"
                          "               m/s2        s            mm        s       m/s        mm        s\n");
    add_floors(report, s, p->kind == THUD_ISOLATED, out);
    add_storeys(r, out);
}

/* Four digits, and all those before the point: no 1.23e+03. */
static void add_ms(double seconds, struct thud_text *out)
{
    thud_text_append(out, seconds < 1 ? "%9.4g " : "%9.0f ", 1e3 * seconds);
}

static void add_contact(const struct thud_contact_result *c, int force_places, int depth_places, struct thud_text *out)
{
    char pair[40];
    thud_pairing_name(c->left_floor, c->right_floor, c->struck, pair, sizeof pair);
    if (c->impacts == 0 && c->contact_time_s == 0 && c->impulse_ns == 0) {
        thud_text_append(out, "%3d %-7s       0  no contact\n", c->interface, pair);
        return;
    }
    thud_text_append(out, "%3d %-7s %7d ", c->interface, pair, c->impacts);
    bool blow = thud_contact_struck(c);
    if (blow)
        thud_text_append(out, "%9s %8s ", "-", "-");
    else {
        add_number(out, 9, force_places, 1e-6 * c->force.value);
        thud_text_append(out, " %8.3f ", c->force.time_s);
    }
    if (blow)
        thud_text_append(out, "%10s", "-");
    else
        add_number(out, 10, depth_places, 1e3 * c->indentation.value);
    thud_text_append(out, " ");
    add_ms(c->contact_time_s, out);
    thud_text_append(out, "%8.3g ", 1e3 * c->residual_m);
    if (!isnan(c->restitution))
        thud_text_append(out, "%6.4f", c->restitution);
    else
        thud_text_append(out, "     -");
    if (!isnan(c->nominal_restitution))
        thud_text_append(out, " %5.3g\n", c->nominal_restitution);
    else
        thud_text_append(out, "     -\n");
    if (blow)
        thud_text_append(out, "            impulse %.5g kN s in all\n", 1e-3 * c->impulse_ns);
}

static void add_contacts(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_result *r = report->result;
    if (r->ncontacts == 0)
        return;
    thud_text_append(out, "\ncontact     impacts     force       at indentation  touching residual last impact's e\n"
                          "                           MN        s         mm        ms       mm real nominal\n");
    double force = 0, depth = 0;
    for (int c = 0; c < r->ncontacts; c++) {
        force = fmax(force, 1e-6 * r->contact[c].force.value);
        depth = fmax(depth, 1e3 * r->contact[c].indentation.value);
    }
    for (int c = 0; c < r->ncontacts; c++)
        add_contact(&r->contact[c], places_of(force, 5), places_of(depth, 4), out);
}

/* Two peaks of columns with their times; `-` where nothing bears on them. */
static void add_ends(const struct thud_peak *peak, int places, struct thud_text *out)
{
    for (int end = 0; end < 2; end++) {
        add_number(out, 10, places, 1e-3 * peak[end].value);
        thud_text_append(out, " %8.3f", peak[end].time_s);
    }
}

/* Shears and moments of struck columns; nothing where no slab stands against columns. */
static void add_columns(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_result *r = report->result;
    double shear = 0, moment = 0;
    bool drifts = true, any = false;
    for (int i = 0; i < r->ncolumns; i++) {
        const struct thud_peak *peak = r->column[i].peak;
        shear = fmax(shear, 1e-3 * fmax(peak[THUD_COLUMN_SHEAR_LOWER].value, peak[THUD_COLUMN_SHEAR_UPPER].value));
        moment = fmax(moment, 1e-3 * fmax(peak[THUD_COLUMN_MOMENT_LOWER].value, peak[THUD_COLUMN_MOMENT_UPPER].value));
        drifts = drifts && r->column[i].drifts;
        any = any || isfinite(r->column[i].ratio);
    }
    if (r->ncolumns == 0)
        return;
    thud_text_append(out,
                     "\ncolumns below  shear low       at        up       at moment low       at        up       at%s\n"
                     "                      kN        s        kN        s      kN m        s      kN m        s%s\n",
                     any ? "  shear/" : "", any ? " capacity" : "");
    for (int i = 0; i < r->ncolumns; i++) {
        const struct thud_column_result *c = &r->column[i];
        thud_text_append(out, "%3d %-6.6s %2d", c->interface, report->scene->structure[c->structure].name, c->storey);
        add_ends(c->peak + THUD_COLUMN_SHEAR_LOWER, places_of(shear, 5), out);
        add_ends(c->peak + THUD_COLUMN_MOMENT_LOWER, places_of(moment, 5), out);
        if (isfinite(c->ratio))
            thud_text_append(out, " %8.4g", c->ratio);
        thud_text_append(out, "\n");
    }
    if (!drifts)
        thud_text_append(out,
                         "Where neither EI nor stiffness is given, by the contact forces alone, without the drift.\n");
}

/* Steps end where the ground motion has its samples, so that the one asked for is the longest there may be. */
static void add_step(double taken_s, double asked_s, struct thud_text *out)
{
    thud_text_append(out, "step %.4g s", taken_s);
    if (isnan(asked_s))
        thud_text_append(out, " (its own choice)");
    else if (fabs(taken_s - asked_s) > 1e-6 * asked_s)
        thud_text_append(out, " (for %.4g s: steps end at the motion's samples)", asked_s);
}

static void add_foot(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_result *r = report->result;
    const struct thud_energy *e = &r->energy;
    thud_text_append(out,
                     "\nenergy         input %.5g kJ, initial %.5g, kinetic %.5g, strain %.5g,\n"
                     "               viscous %.5g, contact %.5g, stored in contacts %.5g;",
                     1e-3 * e->input_j, 1e-3 * e->initial_j, 1e-3 * e->kinetic_j, 1e-3 * e->strain_j,
                     1e-3 * e->viscous_j, 1e-3 * e->contact_j, 1e-3 * e->stored_j);
    if (thud_scene_yields(report->scene))
        thud_text_append(out, "\n               lost in storeys that yield %.5g;", 1e-3 * e->hysteretic_j);
    thud_text_append(out, " unaccounted %.1e\n", e->error_ratio);
    thud_text_append(out, "method         %s", r->method);
    if (r->reason[0])
        thud_text_append(out, " (%s)", r->reason);
    thud_text_append(out, "\n               ");
    if (isnan(r->step_s))
        thud_text_append(out, "tolerance %g", report->scene->analysis.tolerance);
    else
        add_step(r->step_s, report->scene->analysis.step_s, out);
    thud_text_append(out, ", %ld steps, %ld force evaluations, %ld events, to %.5g s\n", r->work.steps,
                     r->work.force_evaluations, r->work.events, r->end_s);
}

static void add_truncation(const struct thud_truncation *t, struct thud_text *out)
{
    thud_text_append(out,
                     "modes          the lowest %d of each building, %d left out: against all of them peaks differ by\n"
                     "               up to %.3g %% (acceleration), %.3g %% (drift), %.3g %% (force)\n",
                     t->modes, t->left_out, 100 * t->acceleration, 100 * t->drift, 100 * t->force);
}

void thud_result_table(const struct thud_report *report, struct thud_text *out)
{
    add_head(report, out);
    add_answers(report, out);
    for (int s = 0; s < report->result->nstructures; s++)
        add_structure(report, s, out);
    add_contacts(report, out);
    add_columns(report, out);
    add_foot(report, out);
    if (report->truncation)
        add_truncation(report->truncation, out);
    if (report->sensitivity)
        thud_sensitivity_table(report, out);
}
