#include <math.h>
#include <stdio.h>
#include <string.h>

#include "io/result/result_file.h"
#include "study/sweep/remark.h"

static void add_number(struct thud_text *out, double value)
{
    thud_text_bytes(out, ",", 1);
    if (isfinite(value))
        thud_text_number(out, value);
}

/* As many digits as a run can be right to: a history has millions of numbers, and all seventeen of a double take five
 * times as long to write. */
static void add_sample(struct thud_text *out, double value)
{
    char text[32];
    thud_text_bytes(out, ",", 1);
    if (isfinite(value))
        thud_text_bytes(out, text, (size_t)snprintf(text, sizeof text, "%.12g", value + 0.0));
}

/* Nothing for an elastic storey. */
static void add_storey(const struct thud_structure_result *r, int i, struct thud_text *out)
{
    static const struct thud_storey_result elastic;
    const struct thud_storey_result *p = r->storey ? &r->storey[i] : &elastic;
    const double value[] = {p->yield_m,      p->ductility,   p->permanent_m, p->excursions,
                            p->hysteretic_j, p->shear.value, p->shear.time_s};
    for (size_t k = 0; k < sizeof value / sizeof *value; k++)
        add_number(out, p->yields ? value[k] : NAN);
}

void thud_result_csv(const struct thud_report *report, struct thud_text *out)
{
    const bool yields = thud_scene_yields(report->scene);
    thud_text_append(out,
                     "structure,floor,acceleration_mps2,acceleration_time_s,displacement_m,displacement_time_s,"
                     "velocity_mps,velocity_time_s,drift_m,drift_time_s%s\n",
                     yields ? ",yield_m,ductility,permanent_m,excursions,hysteretic_j,shear_n,shear_time_s" : "");
    for (int s = 0; s < report->result->nstructures; s++)
        for (int i = 0; i < report->result->structure[s].floors; i++) {
            const struct thud_floor_result *f = &report->result->structure[s].floor[i];
            const struct thud_peak peak[] = {f->acceleration, f->displacement, f->velocity, f->drift};
            thud_text_csv(out, report->scene->structure[s].name);
            thud_text_append(out, ",%d", i + 1);
            for (size_t k = 0; k < sizeof peak / sizeof *peak; k++) {
                bool none = k == 0 && thud_floor_struck(report->result, s, i);
                add_number(out, none ? NAN : peak[k].value);
                add_number(out, none ? NAN : peak[k].time_s);
            }
            if (yields)
                add_storey(&report->result->structure[s], i, out);
            thud_text_append(out, "\n");
        }
}

/* Column name such as A.3.displacement_m. */
static void add_floor_columns(const struct thud_report *report, const char *quantity, struct thud_text *out)
{
    for (int s = 0; s < report->result->nstructures; s++)
        for (int i = 0; i < report->result->structure[s].floors; i++) {
            char name[THUD_NAME_MAX + 64];
            snprintf(name, sizeof name, "%s.%d.%s", report->scene->structure[s].name, i + 1, quantity);
            thud_text_append(out, ",");
            thud_text_csv(out, name);
        }
}

static void add_contact_columns(const struct thud_report *report, const char *quantity, struct thud_text *out)
{
    for (int c = 0; c < report->result->ncontacts; c++) {
        const struct thud_contact_result *r = &report->result->contact[c];
        thud_text_append(out, ",contact.%d.%d-%d.%s", r->interface, r->left_floor, r->right_floor, quantity);
    }
}

/* column.1.B.3.shear_lower_n: of the columns below floor 3 of B that slabs strike at interface 1. */
static void add_struck_columns(const struct thud_report *report, struct thud_text *out)
{
    static const char *const quantity[] = {"shear_lower_n", "shear_upper_n"};
    for (int i = 0; i < report->result->ncolumns; i++)
        for (int q = 0; q < 2; q++) {
            const struct thud_column_result *c = &report->result->column[i];
            char name[THUD_NAME_MAX + 64];
            snprintf(name, sizeof name, "column.%d.%s.%d.%s", c->interface, report->scene->structure[c->structure].name,
                     c->storey, quantity[q]);
            thud_text_append(out, ",");
            thud_text_csv(out, name);
        }
}

/* Of the storeys that yield: column name such as A.storey.3.shear_n. */
static void add_storey_columns(const struct thud_report *report, const char *quantity, struct thud_text *out)
{
    for (int s = 0; s < report->result->nstructures; s++)
        for (int i = 0; i < report->result->structure[s].floors; i++) {
            const struct thud_storey_result *storey = report->result->structure[s].storey;
            char name[THUD_NAME_MAX + 64];
            if (!storey || !storey[i].yields)
                continue;
            snprintf(name, sizeof name, "%s.storey.%d.%s", report->scene->structure[s].name, i + 1, quantity);
            thud_text_append(out, ",");
            thud_text_csv(out, name);
        }
}

void thud_history_csv(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_history *h = report->history;
    thud_text_append(out, "time_s,ground_mps2");
    add_floor_columns(report, "displacement_m", out);
    add_floor_columns(report, "velocity_mps", out);
    add_floor_columns(report, "acceleration_mps2", out);
    add_contact_columns(report, "force_n", out);
    add_contact_columns(report, "indentation_m", out);
    thud_text_append(out, ",energy.input_j,energy.kinetic_j,energy.strain_j,energy.viscous_j,energy.contact_j");
    if (h->nstoreys > 0)
        thud_text_append(out, ",energy.hysteretic_j");
    add_storey_columns(report, "drift_m", out);
    add_storey_columns(report, "shear_n", out);
    add_storey_columns(report, "plastic_m", out);
    add_struck_columns(report, out);
    thud_text_append(out, "\n");
    for (size_t i = 0; i < h->rows; i++) {
        thud_text_number(out, h->time_s[i]);
        for (int k = 0; k < h->columns; k++)
            add_sample(out, h->value[i * (size_t)h->columns + (size_t)k]);
        thud_text_append(out, "\n");
    }
}

void thud_impacts_csv(const struct thud_report *report, struct thud_text *out)
{
    thud_text_append(out, "interface,left_floor,right_floor,start_s,duration_s,approach_mps,separation_mps,force_n,"
                          "indentation_m,impulse_ns,energy_lost_j\n");
    for (int i = 0; i < report->nimpacts; i++) {
        const struct thud_impact *p = &report->impact[i];
        const struct thud_contact_result *c = &report->result->contact[p->contact];
        bool struck = thud_contact_struck(c);
        const double value[] = {p->start_s,
                                p->duration_s,
                                p->approach_mps,
                                p->separation_mps,
                                struck ? NAN : p->force_n,
                                struck ? NAN : p->indentation_m,
                                p->impulse_ns,
                                p->dissipated_j};
        thud_text_append(out, "%d,%d,%d", c->interface, c->left_floor, c->right_floor);
        for (size_t k = 0; k < sizeof value / sizeof *value; k++)
            add_number(out, value[k]);
        thud_text_append(out, "\n");
    }
}
