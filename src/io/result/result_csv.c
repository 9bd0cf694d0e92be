#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "io/result/result_rows.h"

/* As many digits as a run can be right to: a history has millions of numbers, and all seventeen of a double take five
 * times as long to write. */
static void add_sample(struct thud_text *out, double value)
{
    char text[32];
    thud_text_bytes(out, ",", 1);
    if (isfinite(value))
        thud_text_bytes(out, text, thud_number_twelve(value, text));
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

static const struct thud_column history[] = {
    THUD_STANDS_FOR("time_s", "Time, s."),
    THUD_STANDS_FOR("ground_mps2", "Ground acceleration, m/s2."),
    THUD_STANDS_FOR("NAME.FLOOR.displacement_m", "Displacement of a floor of NAME relative to the ground, m."),
    THUD_STANDS_FOR("NAME.FLOOR.velocity_mps", "Velocity of that floor relative to the ground, m/s."),
    THUD_STANDS_FOR("NAME.FLOOR.acceleration_mps2", "Total acceleration of that floor, m/s2."),
    THUD_STANDS_FOR("contact.I.L-R.force_n",
                    "Contact force in interface I between its left floor L and right floor R, N."),
    THUD_STANDS_FOR("contact.I.L-R.indentation_m", "Indentation of that contact, m."),
    THUD_STANDS_FOR("energy.input_j", "Work done by the ground so far, J."),
    THUD_STANDS_FOR("energy.kinetic_j", "Kinetic energy, J."),
    THUD_STANDS_FOR("energy.strain_j", "Strain energy of the structures, J."),
    THUD_STANDS_FOR("energy.viscous_j", "Energy dissipated by the structures' damping, J."),
    THUD_STANDS_FOR("energy.contact_j", "Energy absorbed by the contacts, J."),
    THUD_STANDS_FOR("energy.hysteretic_j", "Energy dissipated by yielding storeys and slipping links, J."),
    THUD_STANDS_FOR("NAME.storey.FLOOR.drift_m", "Drift of a yielding storey, the one below the floor, m."),
    THUD_STANDS_FOR("NAME.storey.FLOOR.shear_n", "Shear of that storey, N."),
    THUD_STANDS_FOR("NAME.storey.FLOOR.plastic_m", "Plastic drift d_p of that storey, m."),
    THUD_STANDS_FOR(
        "column.I.NAME.F.shear_lower_n",
        "Shear at the lower end of the struck columns below floor F of the structure NAME at interface I, N."),
    THUD_STANDS_FOR("column.I.NAME.F.shear_upper_n", "Shear at the upper end of those columns, N."),
    THUD_STANDS_FOR("link.L.force_n", "Force of link L, N; > 0: it pushes its ends apart."),
    THUD_STANDS_FOR("link.L.stroke_m", "Shortening of the distance between its ends, m."),
    THUD_STANDS_FOR("energy.gravity_j",
                    "Work of the weight on drifting storeys, J; with P-Delta, as the last column.")};
const struct thud_schema thud_history_schema =
    THUD_SCHEMA("histories.csv",
                "Written by\n.Cm run Fl o :\na row at every instant that is kept, with two rows where something "
                "jumps.\nFLOOR counts "
                "from 1 and from below; for a building on soil it also is\n.Va foundation ,\nits sway, and\n.Va "
                "rocking ,\nwhat its "
                "rotation makes at the roof.\n",
                history);

static void add_name(struct thud_text *out, const char *format, ...) THUD_PRINTF(2, 3);
static void add_name(struct thud_text *out, const char *format, ...)
{
    char name[2 * THUD_NAME_MAX + 64];
    va_list values;
    va_start(values, format);
    vsnprintf(name, sizeof name, format, values);
    va_end(values);
    thud_text_append(out, ",");
    thud_text_csv(out, name);
}

static void add_floor_columns(const struct thud_report *report, const char *quantity, struct thud_text *out)
{
    for (int s = 0; s < report->result->nstructures; s++) {
        const char *name = report->scene->structure[s].name;
        for (int i = 0; i < report->result->structure[s].floors; i++)
            add_name(out, "%s.%d%s", name, i + 1, quantity);
        if (report->result->structure[s].foundation) {
            add_name(out, "%s.foundation%s", name, quantity);
            add_name(out, "%s.rocking%s", name, quantity);
        }
    }
}

static void add_contact_columns(const struct thud_report *report, const char *quantity, struct thud_text *out)
{
    for (int c = 0; c < report->result->ncontacts; c++) {
        const struct thud_contact_result *r = &report->result->contact[c];
        add_name(out, "contact.%d.%d-%d%s", r->interface, r->left_floor, r->right_floor, quantity);
    }
}

/* Lower and upper shear of a column stand beside each other. */
static void add_struck_columns(const struct thud_report *report, const char *quantity, struct thud_text *out)
{
    for (int i = 0; i < report->result->ncolumns && strcmp(quantity, ".shear_lower_n") == 0; i++) {
        const struct thud_column_result *c = &report->result->column[i];
        const char *name = report->scene->structure[c->structure].name;
        add_name(out, "column.%d.%s.%d.shear_lower_n", c->interface, name, c->storey);
        add_name(out, "column.%d.%s.%d.shear_upper_n", c->interface, name, c->storey);
    }
}

static void add_link_columns(const struct thud_report *report, const char *quantity, struct thud_text *out)
{
    for (int i = 0; i < report->result->nlinks; i++)
        add_name(out, "link.%d%s", i + 1, quantity);
}

/* Of the storeys that yield. */
static void add_storey_columns(const struct thud_report *report, const char *quantity, struct thud_text *out)
{
    for (int s = 0; s < report->result->nstructures; s++)
        for (int i = 0; i < report->result->structure[s].floors; i++) {
            const struct thud_storey_result *storey = report->result->structure[s].storey;
            if (storey && storey[i].yields)
                add_name(out, "%s.storey.%d%s", report->scene->structure[s].name, i + 1, quantity);
        }
}

static void add_plain_column(const struct thud_report *report, const char *name, struct thud_text *out)
{
    const struct thud_history *h = report->history;
    if ((strcmp(name, "energy.hysteretic_j") != 0 || h->loses) && (strcmp(name, "energy.gravity_j") != 0 || h->weighs))
        add_name(out, "%s", name);
}

static void add_heading(const struct thud_report *report, struct thud_text *out)
{
    static const struct {
        const char *begin;
        void (*add)(const struct thud_report *report, const char *quantity, struct thud_text *out);
    } kinds[] = {{"NAME.storey.", add_storey_columns},
                 {"NAME.", add_floor_columns},
                 {"contact.", add_contact_columns},
                 {"column.", add_struck_columns},
                 {"link.", add_link_columns}};
    enum { KINDS = sizeof kinds / sizeof *kinds };
    thud_text_append(out, "%s", history[0].name);
    for (int i = 1; i < thud_history_schema.n; i++) {
        const char *name = history[i].name;
        int k = 0;
        while (k < KINDS && strncmp(name, kinds[k].begin, strlen(kinds[k].begin)) != 0)
            k++;
        if (k < KINDS)
            kinds[k].add(report, strrchr(name, '.'), out);
        else
            add_plain_column(report, name, out);
    }
    thud_text_append(out, "\n");
}

void thud_history_csv(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_history *h = report->history;
    add_heading(report, out);
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
