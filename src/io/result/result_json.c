#include <math.h>

#include "base/version.h"
#include "io/file/json.h"
#include "io/result/result_file.h"
#include "io/result/scene_json.h"
#include "study/scene/level.h"
#include "study/sweep/remark.h"

static const char *kind_name(enum thud_structure_kind kind)
{
    static const char *const names[] = {"shear", "rigid", "isolated", "wall"};
    return names[kind];
}

void thud_record_json(const struct thud_record *record, struct thud_text *out)
{
    thud_text_append(out, "{\"file\": ");
    thud_json_string(out, record->file);
    thud_text_append(out, ", ");
    thud_json_field(out, "peak_mps2", thud_record_peak(record));
    thud_text_append(out, ", ");
    thud_json_field(out, "scale", record->scale);
    thud_text_append(out, ", \"synthetic\": %s, ", record->synthetic ? "true" : "false");
    thud_json_field(out, "dt_s", record->dt_s);
    thud_text_append(out, ", \"samples\": %zu}", record->samples);
}

static void add_record(const struct thud_report *report, struct thud_text *out)
{
    thud_text_append(out, "  \"record\": ");
    if (report->record)
        thud_record_json(report->record, out);
    else
        thud_text_append(out, "null");
    thud_text_append(out, ",\n");
}

static void add_method(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_result *r = report->result;
    thud_text_append(out, "  \"method\": {\"name\": ");
    thud_json_string(out, r->method);
    thud_text_append(out, ", \"reason\": ");
    thud_json_string(out, r->reason);
    thud_text_append(out, ", ");
    thud_json_field(out, "tolerance", report->scene->analysis.tolerance);
    thud_text_append(out, ", ");
    thud_json_field(out, "step_s", r->step_s);
    thud_text_append(out,
                     ", \"steps\": %ld, \"force_evaluations\": %ld, \"events\": %ld, \"rejected\": %ld, "
                     "\"samples_in_free_flight\": %ld},\n",
                     r->work.steps, r->work.force_evaluations, r->work.events, r->work.rejected, r->work.samples_fast);
}

/* What a storey that yields adds to its floor. */
static void add_storey(const struct thud_storey_result *s, struct thud_text *out)
{
    const struct {
        const char *key;
        double value;
    } field[] = {{"yield_m", s->yield_m},         {"hardening", s->hardening},      {"ductility", s->ductility},
                 {"permanent_m", s->permanent_m}, {"plastic_m", s->plastic_m},      {"hysteretic_j", s->hysteretic_j},
                 {"shear_n", s->shear.value},     {"shear_time_s", s->shear.time_s}};
    thud_text_append(out, ", \"storey\": {\"excursions\": %d", s->excursions);
    for (size_t i = 0; i < sizeof field / sizeof *field; i++) {
        thud_text_append(out, ", ");
        thud_json_field(out, field[i].key, field[i].value);
    }
    thud_text_append(out, "}");
}

static void add_floor(int floor, const struct thud_floor_result *f, const struct thud_storey_result *storey,
                      double stability, bool struck, struct thud_text *out)
{
    const struct {
        const char *value, *time;
        struct thud_peak peak;
    } field[] = {{"acceleration_mps2", "acceleration_time_s", f->acceleration},
                 {"displacement_m", "displacement_time_s", f->displacement},
                 {"velocity_mps", "velocity_time_s", f->velocity},
                 {"drift_m", "drift_time_s", f->drift}};
    thud_text_append(out, "      {\"floor\": %d", floor);
    for (size_t i = 0; i < sizeof field / sizeof *field; i++) {
        thud_text_append(out, ", ");
        thud_json_field(out, field[i].value, struck && i == 0 ? NAN : field[i].peak.value);
        thud_text_append(out, ", ");
        thud_json_field(out, field[i].time, struck && i == 0 ? NAN : field[i].peak.time_s);
    }
    thud_text_append(out, ", ");
    thud_json_field(out, "stability_coefficient", stability);
    if (storey && storey->yields)
        add_storey(storey, out);
    thud_text_append(out, "}");
}

static void add_structure(const struct thud_report *report, int s, struct thud_text *out)
{
    const struct thud_structure *p = &report->scene->structure[s];
    const struct thud_structure_result *r = &report->result->structure[s];
    thud_text_append(out, "    {\"name\": ");
    thud_json_string(out, report->scene->structure[s].name);
    thud_text_append(out, ", \"kind\": \"%s\", \"periods_s\": [", kind_name(report->scene->structure[s].kind));
    for (int i = 0; i < r->floors; i++) {
        thud_text_append(out, "%s", i > 0 ? ", " : "");
        thud_json_number(out, r->period_s[i]);
    }
    thud_text_append(out, "], ");
    thud_json_field(out, "base_shear_n", r->base_shear.value);
    thud_text_append(out, ", ");
    thud_json_field(out, "base_shear_time_s", r->base_shear.time_s);
    thud_text_append(out, ", \"floors\": [");
    for (int i = 0; i < r->floors; i++) {
        thud_text_append(out, "%s\n", i > 0 ? "," : "");
        add_floor(i + 1, &r->floor[i], r->storey ? &r->storey[i] : NULL,
                  thud_stability_coefficient(p, r, i - (p->kind == THUD_ISOLATED)),
                  thud_floor_struck(report->result, s, i), out);
    }
    thud_text_append(out, "]}");
}

static void add_contact(const struct thud_contact_result *c, struct thud_text *out)
{
    bool struck = thud_contact_struck(c);
    const struct {
        const char *key;
        double value;
    } field[] = {{"force_n", thud_peak_force(c)},       {"force_time_s", struck ? NAN : c->force.time_s},
                 {"indentation_m", thud_peak_depth(c)}, {"indentation_time_s", struck ? NAN : c->indentation.time_s},
                 {"impulse_ns", c->impulse_ns},         {"contact_time_s", c->contact_time_s},
                 {"residual_m", c->residual_m},         {"dissipated_j", c->dissipated_j},
                 {"approach_mps", c->approach_mps},     {"separation_mps", c->separation_mps},
                 {"restitution", c->restitution},       {"nominal_restitution", c->nominal_restitution}};
    thud_text_append(out, "    {\"interface\": %d, \"left_floor\": %d, \"right_floor\": %d, \"impacts\": %d",
                     c->interface, c->left_floor, c->right_floor, c->impacts);
    if (c->struck != 0) {
        thud_text_append(out, ", \"struck_columns\": \"%s\", ", thud_struck_name(c->struck));
        thud_json_field(out, "eta", c->eta);
    }
    for (size_t i = 0; i < sizeof field / sizeof *field; i++) {
        thud_text_append(out, ", ");
        thud_json_field(out, field[i].key, field[i].value);
    }
    thud_text_append(out, "}");
}

static void add_column(const struct thud_report *report, const struct thud_column_result *c, struct thud_text *out)
{
    static const char *const value[] = {"shear_lower_n", "shear_upper_n", "moment_lower_nm", "moment_upper_nm"};
    static const char *const time[] = {"shear_lower_time_s", "shear_upper_time_s", "moment_lower_time_s",
                                       "moment_upper_time_s"};
    thud_text_append(out, "    {\"interface\": %d, \"structure\": ", c->interface);
    thud_json_string(out, report->scene->structure[c->structure].name);
    thud_text_append(out, ", \"below_floor\": %d, \"with_drift\": %s", c->storey, c->drifts ? "true" : "false");
    for (int q = 0; q < THUD_COLUMN_QUANTITIES; q++) {
        thud_text_append(out, ", ");
        thud_json_field(out, value[q], c->peak[q].value);
        thud_text_append(out, ", ");
        thud_json_field(out, time[q], c->peak[q].time_s);
    }
    thud_text_append(out, ", ");
    thud_json_field(out, "capacity_n", c->capacity_n);
    thud_text_append(out, ", ");
    thud_json_field(out, "shear_over_capacity", c->ratio);
    thud_text_append(out, "}");
}

static void add_energy(const struct thud_energy *e, bool yields, struct thud_text *out)
{
    const struct {
        const char *key;
        double value;
    } field[] = {{"initial_j", e->initial_j}, {"input_j", e->input_j},        {"kinetic_j", e->kinetic_j},
                 {"strain_j", e->strain_j},   {"viscous_j", e->viscous_j},    {"contact_j", e->contact_j},
                 {"stored_j", e->stored_j},   {"error_ratio", e->error_ratio}};
    thud_text_append(out, "  \"energy\": {");
    for (size_t i = 0; i < sizeof field / sizeof *field; i++) {
        thud_text_append(out, "%s", i > 0 ? ", " : "");
        thud_json_field(out, field[i].key, field[i].value);
    }
    if (yields) {
        thud_text_append(out, ", ");
        thud_json_field(out, "hysteretic_j", e->hysteretic_j);
    }
    thud_text_append(out, "}");
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

static void add_truncation(const struct thud_truncation *t, struct thud_text *out)
{
    thud_text_append(out, ",\n  \"truncation\": {\"modes\": %d, \"left_out\": %d, ", t->modes, t->left_out);
    thud_json_field(out, "acceleration", t->acceleration);
    thud_text_append(out, ", ");
    thud_json_field(out, "drift", t->drift);
    thud_text_append(out, ", ");
    thud_json_field(out, "force", t->force);
    thud_text_append(out, "}");
}

static void add_status(const struct thud_report *report, struct thud_text *out)
{
    thud_text_append(out, "  \"status\": \"%s\"", report->failure ? "diverged" : "done");
    if (report->failure) {
        char why[1400];
        thud_text_append(out, ", \"message\": ");
        thud_json_string(out, thud_error_text(report->failure, why, sizeof why));
        thud_text_append(out, ", ");
        thud_json_field(out, "end_s", report->result->end_s);
    }
    thud_text_append(out, ",\n");
}

static void add_peaks(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_result *r = report->result;
    thud_text_append(out, "  \"structures\": [");
    for (int s = 0; s < r->nstructures; s++) {
        thud_text_append(out, "%s\n", s > 0 ? "," : "");
        add_structure(report, s, out);
    }
    thud_text_append(out, "],\n  \"contacts\": [");
    for (int c = 0; c < r->ncontacts; c++) {
        thud_text_append(out, "%s\n", c > 0 ? "," : "");
        add_contact(&r->contact[c], out);
    }
    if (r->ncolumns > 0)
        thud_text_append(out, "],\n  \"columns\": [");
    for (int i = 0; i < r->ncolumns; i++) {
        thud_text_append(out, "%s\n", i > 0 ? "," : "");
        add_column(report, &r->column[i], out);
    }
    thud_text_append(out, "],\n");
}

void thud_result_json(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_result *r = report->result;
    thud_text_append(out, "{\n  \"preset\": ");
    thud_json_string(out, report->scene->name);
    thud_text_append(out, ", \"case\": \"%s\", \"version\": \"%s\",\n", report->which, THUD_VERSION);
    add_status(report, out);
    add_record(report, out);
    add_method(report, out);
    if (!report->failure)
        add_peaks(report, out);
    add_energy(&r->energy, thud_scene_yields(report->scene), out);
    if (report->truncation)
        add_truncation(report->truncation, out);
    if (report->sensitivity)
        add_sensitivity(report, out);
    thud_text_append(out, ",\n  \"scene\": ");
    thud_scene_json(report->scene, report->record ? report->record->file : NULL, 4, out);
    thud_text_append(out, "\n}\n");
}
