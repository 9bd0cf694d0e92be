#include "app/result_table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/sensitivity_table.h"

static void add_head(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_scene *scene = report->scene;
    thud_text_append(out, "%s, case %s: %s\n", scene->name, report->which, scene->title);
    if (report->record)
        thud_text_append(out, "ground motion  %s, peak %.4g g, %zu samples every %.4g s\n", report->record->file,
                         thud_record_peak(report->record) / THUD_GRAVITY, report->record->samples,
                         report->record->dt_s);
    else
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
    for (int i = r->floors - 1; i >= 0; i--) {
        const struct thud_floor_result *f = &r->floor[i];
        thud_text_append(out, "%5d  %12.5g %8.3f  %12.5g %8.3f  %8.4g  %8.4g %8.3f%s\n", i + 1, f->acceleration.value,
                         f->acceleration.time_s, 1e3 * f->displacement.value, f->displacement.time_s, f->velocity.value,
                         1e3 * f->drift.value, f->drift.time_s, p->kind == THUD_ISOLATED && i == 0 ? "  base" : "");
    }
}

/* Four digits, and all those before the point: no 1.23e+03. */
static void add_ms(double seconds, struct thud_text *out)
{
    thud_text_append(out, seconds < 1 ? "%9.4g " : "%9.0f ", 1e3 * seconds);
}

static void add_contact(const struct thud_contact_result *c, struct thud_text *out)
{
    char pair[32], floors[2][12] = {"wall", "wall"};
    if (c->left_floor > 0)
        snprintf(floors[0], sizeof floors[0], "%d", c->left_floor);
    if (c->right_floor > 0)
        snprintf(floors[1], sizeof floors[1], "%d", c->right_floor);
    snprintf(pair, sizeof pair, "%s-%s", floors[0], floors[1]);
    if (c->impacts == 0) {
        thud_text_append(out, "%3d %-7s       0  no contact\n", c->interface, pair);
        return;
    }
    thud_text_append(out, "%3d %-7s %7d %9.4g %8.3f %10.4g ", c->interface, pair, c->impacts, 1e-6 * c->force.value,
                     c->force.time_s, 1e3 * c->indentation.value);
    add_ms(c->contact_time_s, out);
    thud_text_append(out, "%8.3g ", 1e3 * c->residual_m);
    if (c->approach_mps > 0 && c->separation_mps > 0)
        thud_text_append(out, "%6.4f", c->separation_mps / c->approach_mps);
    else
        thud_text_append(out, "     -");
    thud_text_append(out, " %5.3g\n", c->nominal_restitution);
}

static void add_contacts(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_result *r = report->result;
    if (r->ncontacts == 0)
        return;
    thud_text_append(out, "\ncontact     impacts     force       at indentation  touching residual last impact's e\n"
                          "                           MN        s         mm        ms       mm real nominal\n");
    for (int c = 0; c < r->ncontacts; c++)
        add_contact(&r->contact[c], out);
}

static void add_foot(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_result *r = report->result;
    const struct thud_energy *e = &r->energy;
    thud_text_append(out,
                     "\nenergy         input %.5g kJ, initial %.5g, kinetic %.5g, strain %.5g,\n"
                     "               viscous %.5g, contact %.5g, stored in contacts %.5g; unaccounted %.1e\n",
                     1e-3 * e->input_j, 1e-3 * e->initial_j, 1e-3 * e->kinetic_j, 1e-3 * e->strain_j,
                     1e-3 * e->viscous_j, 1e-3 * e->contact_j, 1e-3 * e->stored_j, e->error_ratio);
    thud_text_append(out, "method         %s", r->method);
    if (r->reason[0])
        thud_text_append(out, " (%s)", r->reason);
    thud_text_append(out, "\n               tolerance %g, %ld steps, %ld force evaluations, %ld events, to %.5g s\n",
                     report->scene->analysis.tolerance, r->work.steps, r->work.force_evaluations, r->work.events,
                     r->end_s);
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
    for (int s = 0; s < report->result->nstructures; s++)
        add_structure(report, s, out);
    add_contacts(report, out);
    add_foot(report, out);
    if (report->truncation)
        add_truncation(report->truncation, out);
    if (report->sensitivity)
        thud_sensitivity_table(report, out);
}
