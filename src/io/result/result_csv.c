#include <math.h>
#include <stdio.h>

#include "io/result/result_rows.h"

/* As many digits as a run can be right to: a history has millions of numbers, and all seventeen of a double take five
 * times as long to write. */
static void add_sample(struct thud_text *out, double value)
{
    char text[32];
    thud_text_bytes(out, ",", 1);
    if (isfinite(value))
        thud_text_bytes(out, text, (size_t)snprintf(text, sizeof text, "%.12g", value + 0.0));
}

void thud_result_csv(const struct thud_report *report, int n, struct thud_text *out)
{
    struct thud_floor_row row;
    const unsigned marks = n > 1 ? THUD_ROW_CASE : 0;
    const struct thud_part part[] = {{&thud_floor_schema, marks, &row}, {&thud_storey_schema, 0, &row}};
    const int parts = thud_scene_yields(report->scene) ? 2 : 1;
    thud_parts_names(part, parts, out);
    for (int k = 0; k < n; k++) {
        const struct thud_floors all = {&report[k], -1};
        const struct thud_rows rows = thud_floor_rows(&all);
        for (int i = 0; i < rows.n; i++) {
            rows.make(&all, i, &row);
            thud_parts_csv(part, parts, out);
        }
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
            if (i + 1 < report->result->structure[s].floors || !report->result->structure[s].foundation)
                continue;
            for (int row = 0; row < 2; row++) {
                snprintf(name, sizeof name, "%s.%s.%s", report->scene->structure[s].name,
                         row == 0 ? "foundation" : "rocking", quantity);
                thud_text_append(out, ",");
                thud_text_csv(out, name);
            }
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

/* link.1.force_n: of the first link. */
static void add_link_columns(const struct thud_report *report, const char *quantity, struct thud_text *out)
{
    for (int i = 0; i < report->result->nlinks; i++)
        thud_text_append(out, ",link.%d.%s", i + 1, quantity);
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
    if (h->loses)
        thud_text_append(out, ",energy.hysteretic_j");
    add_storey_columns(report, "drift_m", out);
    add_storey_columns(report, "shear_n", out);
    add_storey_columns(report, "plastic_m", out);
    add_struck_columns(report, out);
    add_link_columns(report, "force_n", out);
    add_link_columns(report, "stroke_m", out);
    thud_text_append(out, "%s\n", h->weighs ? ",energy.gravity_j" : "");
    for (size_t i = 0; i < h->rows; i++) {
        thud_text_number(out, h->time_s[i]);
        for (int k = 0; k < h->columns; k++)
            add_sample(out, h->value[i * (size_t)h->columns + (size_t)k]);
        thud_text_append(out, "\n");
    }
}

void thud_impacts_csv(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_rows rows = thud_impact_rows(report);
    thud_rows_csv(&rows, out);
}
