#include "io/file/json.h"
#include "io/result/result_rows.h"
#include "io/result/scene_json.h"
#include "study/scene/building.h"
#include "study/scene/level.h"
#include "study/scene/scene_elements.h"
#include "study/sweep/remark.h"

static void add_record(const struct thud_report *report, struct thud_text *out)
{
    thud_text_append(out, "  \"record\": ");
    if (report->record)
        thud_record_json(report->record, out);
    else
        thud_text_append(out, "null");
    thud_text_append(out, ",\n  \"method\": ");
    thud_method_json(report, out);
    thud_text_append(out, ",\n");
}

static void add_floors(const struct thud_report *report, int s, struct thud_text *out)
{
    const struct thud_floors asked = {report, -1};
    const struct thud_rows rows = thud_floor_rows(&asked);
    int first = 0;
    for (int k = 0; k < s; k++)
        first += report->result->structure[k].floors;
    for (int i = 0; i < report->result->structure[s].floors; i++) {
        struct thud_floor_row row;
        rows.make(&asked, first + i, &row);
        thud_text_append(out, "%s\n      {", i > 0 ? "," : "");
        thud_json_members(&thud_floor_schema, 0, &row, out);
        if (row.yields) {
            thud_text_append(out, ", \"storey\": ");
            thud_json_object(&thud_storey_schema, 0, &row, out);
        }
        thud_text_append(out, "}");
    }
}

static void add_structure(const struct thud_report *report, int s, struct thud_text *out)
{
    const struct thud_structure_result *r = &report->result->structure[s];
    thud_text_append(out, "    {\"name\": ");
    thud_json_string(out, report->scene->structure[s].name);
    thud_text_append(out, ", \"kind\": \"%s\", \"periods_s\": [", thud_kind_name(report->scene->structure[s].kind));
    for (int i = 0; i < r->floors; i++) {
        thud_text_append(out, "%s", i > 0 ? ", " : "");
        thud_json_number(out, r->period_s[i]);
    }
    thud_text_append(out, "], ");
    THUD_JSON_FIELDS(out, {"base_shear_n", r->base_shear.value}, {"base_shear_time_s", r->base_shear.time_s});
    if (r->overturning.value > 0) {
        thud_text_append(out, ", ");
        THUD_JSON_FIELDS(out, {"overturning_nm", r->overturning.value}, {"overturning_time_s", r->overturning.time_s});
    }
    if (report->scene->structure[s].kind == THUD_ESTIMATED) {
        const struct thud_estimate e = thud_structure_estimate(&report->scene->structure[s]);
        thud_text_append(out, ", \"estimate\": {");
        THUD_JSON_FIELDS(out, {"en1998_period_s", e.en1998_s}, {"asce7_period_s", e.asce7_s},
                         {"floor_mass_kg", report->scene->structure[s].mass_kg[0]},
                         {"storey_stiffness_npm", report->scene->structure[s].stiffness_npm[0]});
        thud_text_append(out, "}");
    }
    if (r->foundation) {
        thud_text_append(out, ", \"foundation\": {");
        THUD_JSON_FIELDS(out, {"rigid_period_s", r->rigid_period_s}, {"damping", r->soil_damping},
                         {"sway_m", r->foundation[0].displacement.value},
                         {"sway_time_s", r->foundation[0].displacement.time_s},
                         {"rotation_rad", r->foundation[1].displacement.value / r->arm_m},
                         {"rotation_time_s", r->foundation[1].displacement.time_s}, {"stored_j", r->soil_stored_j});
        thud_text_append(out, "}");
    }
    thud_text_append(out, ", \"floors\": [");
    add_floors(report, s, out);
    thud_text_append(out, "]}");
}

/* Each peak's relative spread, by what was changed. */
static void add_spread(const char *peak, const struct thud_spread *spread, struct thud_text *out)
{
    thud_text_append(out, ", \"%s\": {", peak);
    for (int i = 0; i < THUD_CHANGES; i++) {
        thud_text_append(out, "%s", i > 0 ? ", " : "");
        thud_json_field(out, thud_change_name((enum thud_change)i), spread->by[i]);
    }
    thud_text_append(out, ", \"digits\": %d}", thud_spread_digits(thud_spread_most(spread)));
}

static void add_sensitivity(const struct thud_report *report, struct thud_text *out)
{
    static const char *const floor_peaks[THUD_FLOOR_SPREADS] = {"acceleration", "displacement", "velocity", "drift"};
    static const char *const contact_peaks[THUD_CONTACT_SPREADS] = {"force", "indentation"};
    const struct thud_sensitivity *s = report->sensitivity;
    thud_text_append(out, ",\n  \"sensitivity\": {");
    thud_json_field(out, "change", s->change);
    thud_text_append(out, ", \"runs\": %d, \"floors\": [", s->runs);
    for (int k = 0, row = 0; k < report->result->nstructures; k++)
        for (int i = 0; i < report->result->structure[k].floors; i++, row++) {
            thud_text_append(out, "%s\n    {\"structure\": ", row > 0 ? "," : "");
            thud_json_string(out, report->scene->structure[k].name);
            thud_text_append(out, ", \"floor\": %d", i + 1);
            for (int q = 0; q < THUD_FLOOR_SPREADS; q++)
                add_spread(floor_peaks[q], &s->floor[row][q], out);
            thud_text_append(out, "}");
        }
    thud_text_append(out, "], \"contacts\": [");
    for (int c = 0; c < s->ncontacts; c++) {
        thud_text_append(out, "%s\n    {\"interface\": %d, \"left_floor\": %d, \"right_floor\": %d", c > 0 ? "," : "",
                         report->result->contact[c].interface, report->result->contact[c].left_floor,
                         report->result->contact[c].right_floor);
        for (int q = 0; q < THUD_CONTACT_SPREADS; q++)
            add_spread(contact_peaks[q], &s->contact[c][q], out);
        thud_text_append(out, "}");
    }
    thud_text_append(out, "]}");
}

static void add_status(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_collapse *collapse = &report->result->collapse;
    struct thud_error fall = {0};
    const struct thud_error *why =
        thud_collapse_remark(report->scene, &report->result->collapse, &fall) ? &fall : report->failure;
    thud_text_append(out, "  \"status\": \"%s\"", collapse->happened ? "collapsed" : why ? "diverged" : "done");
    if (why) {
        char text[1400];
        thud_text_append(out, ", \"message\": ");
        thud_json_string(out, thud_error_text(why, text, sizeof text));
        thud_text_append(out, ", ");
        thud_json_field(out, "end_s", report->result->end_s);
    }
    if (collapse->happened) {
        const struct thud_structure *s = &report->scene->structure[collapse->structure];
        thud_text_append(out, ", \"collapse\": {\"structure\": ");
        thud_json_string(out, s->name);
        thud_text_append(out, ", \"storey\": %d, ", thud_structure_storey(s, collapse->floor));
        THUD_JSON_FIELDS(out, {"time_s", collapse->time_s}, {"drift_m", collapse->drift_m});
        thud_text_append(out, "}");
    }
    thud_text_append(out, ",\n");
}

static void add_peaks(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_result *r = report->result;
    const struct thud_rows contacts = thud_contact_rows(report), columns = thud_column_rows(report),
                           links = thud_link_rows(report);
    thud_text_append(out, "  \"structures\": [");
    for (int s = 0; s < r->nstructures; s++) {
        thud_text_append(out, "%s\n", s > 0 ? "," : "");
        add_structure(report, s, out);
    }
    thud_text_append(out, "],\n  \"contacts\": [");
    for (int i = 0; i < contacts.n; i++) {
        struct thud_row_room room;
        contacts.make(report, i, room.bytes);
        thud_text_append(out, "%s\n    ", i > 0 ? "," : "");
        thud_json_object(contacts.schema, r->contact[i].struck != 0 ? THUD_ROW_COLUMNS : 0, room.bytes, out);
    }
    thud_text_append(out, "],\n");
    if (columns.n > 0) {
        thud_text_append(out, "  \"columns\": ");
        thud_rows_json(&columns, out);
        thud_text_append(out, ",\n");
    }
    if (links.n > 0) {
        thud_text_append(out, "  \"links\": ");
        thud_rows_json(&links, out);
        thud_text_append(out, ",\n");
    }
}

void thud_result_json(const struct thud_report *report, struct thud_text *out)
{
    thud_text_append(out, "{\n  ");
    thud_json_head_of(out, THUD_RESULT_FORMAT, report->scene->name);
    thud_text_append(out, ", \"case\": \"%s\",\n", report->which);
    add_status(report, out);
    add_record(report, out);
    if (!report->failure)
        add_peaks(report, out);
    thud_text_append(out, "  \"energy\": ");
    thud_json_object(&thud_energy_schema,
                     (thud_scene_elements(report->scene).traits & THUD_SLIPS ? THUD_ROW_YIELDS : 0u) |
                         (report->scene->p_delta ? THUD_ROW_WEIGHS : 0u),
                     &report->result->energy, out);
    if (report->truncation) {
        thud_text_append(out, ",\n  \"truncation\": ");
        thud_json_object(&thud_truncation_schema, 0, report->truncation, out);
    }
    if (report->sensitivity)
        add_sensitivity(report, out);
    const struct thud_remark_scope scope = {.scene = report->scene,
                                            .result = report->result,
                                            .impact = report->impact,
                                            .nimpacts = report->nimpacts,
                                            .record = &report->record,
                                            .nrecords = report->record != NULL,
                                            .sensitivity = report->sensitivity};
    thud_remarks_json(
        &scope, THUD_REMARKS_OF_INPUT | (report->failure ? 0u : (unsigned)(THUD_REMARK_RESULT | THUD_REMARK_LEDGER)),
        out);
    thud_text_append(out, ",\n");
    thud_scene_members_json(report->scene, report->record ? report->record->file : NULL, out);
    thud_text_append(out, "\n}\n");
}
