#include "io/result/list_rows.h"

#include <math.h>

#include "io/file/json.h"
#include "study/methods/published.h"

/* ---- ground motions ---- */

#define INFO(member, name, text) THUD_FIELD(struct thud_motion_info_row, member, name, text)
static const struct thud_column infos[] = {
    INFO(record.file, "file", "Path of the file."),
    INFO(record.format, "format", "Format of the file."),
    INFO(record.note, "note", "Note on how the samples were found."),
    INFO(record.synthetic, "synthetic", "Whether the motion is computed, not recorded."),
    INFO(record.event, "event", "Earthquake, as stated in the file."),
    INFO(record.station, "station", "Station, as stated in the file."),
    INFO(record.component, "component", "Component, as stated in the file."),
    INFO(record.samples, "samples", "Number of samples."),
    INFO(record.dt_s, "dt_s", "Time step, s."),
    INFO(own.duration_s, "duration_s", "Duration, s."),
    INFO(own.pga_mps2, "pga_mps2", "Peak ground acceleration, m/s2."),
    INFO(own.pga_time_s, "pga_time_s", "Time of the peak acceleration, s."),
    INFO(own.pgv_mps, "pgv_mps", "Peak ground velocity, m/s."),
    INFO(own.pgv_time_s, "pgv_time_s", "Time of the peak velocity, s."),
    INFO(own.pgd_m, "pgd_m", "Peak ground displacement, m."),
    INFO(own.pgd_time_s, "pgd_time_s", "Time of the peak displacement, s."),
    INFO(own.mean_mps2, "mean_mps2", "Mean acceleration, removed only for velocity and displacement, m/s2."),
    INFO(own.end_m, "end_displacement_m", "Displacement at the last sample, m."),
    INFO(own.drifts, "pgd_is_drift", "Whether the peak displacement is drift."),
    INFO(own.arias_mps, "arias_mps", "Arias intensity, m/s."),
    INFO(own.arias_trapezoid_mps, "arias_trapezoid_mps",
         "Arias intensity by the trapezoidal rule on the squared samples, m/s."),
    INFO(own.d5_95_s, "d5_95_s", "Significant duration from 5 to 95 %, s."),
    INFO(own.d5_75_s, "d5_75_s", "Significant duration from 5 to 75 %, s."),
    INFO(own.cav_mps, "cav_mps", "Cumulative absolute velocity, m/s."),
    INFO(own.bracketed_s, "bracketed_s", "Bracketed duration above 0.05 g, s."),
    INFO(predominant_s, "predominant_s", "Predominant period, s."),
    INFO(record.scale, "scale", "Factor on the samples of the file, with its sign; 1: as recorded."),
    INFO(sha256, "sha256", "SHA-256 of the file, unpacked.")};
const struct thud_schema thud_motion_info_schema =
    THUD_SCHEMA("record info",
                "Measures of ground motions, a row for each; with\n.Fl -json\nthe list\n.Va records\nbehind\n.Va "
                "format\nand\n.Va version .\n",
                infos);

void thud_motion_info_fill(const struct thud_record *r, struct thud_motion_info_row *row)
{
    *row = (struct thud_motion_info_row){*r, r->sha256[0] ? r->sha256 : NULL, thud_intensity_of(r),
                                         thud_record_predominant_period(r)};
}

#define MOTION(member, text) THUD_FIELD(struct thud_motion_list_row, member, #member, text)
static const struct thud_column motions[] = {
    MOTION(file, "Path of the file."),
    MOTION(format, "Format of the file."),
    MOTION(needs, "Option required to read the file."),
    MOTION(error, "Reason why the file cannot be read."),
    MOTION(pair, "File of the other horizontal component, or the components in this file."),
    MOTION(samples, "Number of samples."),
    MOTION(dt_s, "Time step, s."),
    MOTION(pga_mps2, "Peak ground acceleration, m/s2.")};
const struct thud_schema thud_motion_list_schema =
    THUD_SCHEMA("record list",
                "The ground motions of a folder or list, a row for each; with\n.Fl -json\nthe list\n.Va records\n"
                "behind\n.Va format\nand\n.Va version .\n",
                motions);

static const struct thud_column spectra[] = {
    {THUD_COLUMN(struct thud_spectrum_row, file, "file", "Path of the file.")},
    {THUD_COLUMN(struct thud_spectrum_row, damping, "damping", "Damping ratio.")}};
const struct thud_schema thud_spectrum_schema =
    THUD_SCHEMA("record spectrum of a list",
                "Before the columns of\n.Sx record spectrum ,\nwhere a list is asked for; with\n.Fl -json\nthe "
                "list\n.Va spectra\nbehind\n.Va format\nand\n.Va version ,\nthe rest in the list\n.Va points\nof "
                "each.\n",
                spectra);

#define POINT(member, text) THUD_FIELD(struct thud_spectrum_point, member, #member, text)
static const struct thud_column points[] = {
    POINT(period_s, "Period, s."), POINT(acceleration_mps2, "Total acceleration (not the pseudo-acceleration), m/s2."),
    POINT(velocity_mps, "Velocity relative to the ground (not the pseudo-velocity), m/s."),
    POINT(displacement_m, "Displacement relative to the ground, m.")};
const struct thud_schema thud_spectrum_point_schema = THUD_SCHEMA(
    "record spectrum", "A row for each period, under comments with the ground motion and the damping.\n", points);

static void make_point(const void *of, int i, void *out)
{
    *(struct thud_spectrum_point *)out = ((const struct thud_spectrum_point *)of)[i];
}

struct thud_rows thud_spectrum_rows(const struct thud_spectrum_point *point, size_t n)
{
    return (struct thud_rows){&thud_spectrum_point_schema, 0, (int)n, make_point, point};
}

/* ---- expectations ---- */

#define VERIFIED(member, text) THUD_FIELD(struct thud_verified_row, member, #member, text)
static const struct thud_column verified[] = {VERIFIED(preset, "Name of the preset."),
                                              VERIFIED(expectations, "File of the expectations."),
                                              VERIFIED(cases, "Number of cases."),
                                              VERIFIED(holds, "Number of expectations that hold."),
                                              VERIFIED(moved, "Number of expectations that do not hold."),
                                              VERIFIED(gone, "Number of expectations no longer computed.")};
const struct thud_schema thud_verified_schema =
    THUD_SCHEMA("verify",
                "With\n.Fl -json\nthe list\n.Va presets\nbehind\n.Va format\nand\n.Va version ;\nwith\n.Fl -csv\n"
                "columns before those of\n.Sx verify of each expectation .\n",
                verified);

#define CHECK(member, name, text) THUD_FIELD(struct thud_check_row, member, name, text)
static const struct thud_column checks[] = {CHECK(which, "case", "Case."),
                                            CHECK(quantity, "quantity", "Quantity, as in the file."),
                                            CHECK(expected, "expected", "Expected value in the file, in SI units."),
                                            CHECK(tolerance, "tolerance", "Relative tolerance, as in the file."),
                                            CHECK(now, "now", "Computed value, in SI units."),
                                            CHECK(change, "change", "Relative change."),
                                            CHECK(verdict, "verdict", "Verdict: holds, moved or gone.")};
const struct thud_schema thud_check_schema = THUD_SCHEMA(
    "verify of each expectation", "A row for each expectation; with\n.Fl -json\nthe list\n.Va checks .\n", checks);

#define FRESH(member, name, text) THUD_FIELD(struct thud_fresh_row, member, name, text)
static const struct thud_column fresh[] = {
    FRESH(which, "case", "Case."), FRESH(quantity, "quantity", "Quantity, as in the file."),
    FRESH(value, "value", "Value in the new file, in SI units."), FRESH(tolerance, "tolerance", "Relative tolerance."),
    FRESH(independent, "independent", "Value of the independent method.")};
const struct thud_schema thud_fresh_schema = THUD_SCHEMA(
    "verify --update",
    "With\n.Fl -json\nthe lists\n.Va new ,\nof the new file, and\n.Va left_out ,\non which two methods do not "
    "agree.\n",
    fresh);

#define PUBLISHED(member, text) THUD_FIELD(struct thud_published_head, member, #member, text)
static const struct thud_column published[] = {
    PUBLISHED(title, "Title of the example."), PUBLISHED(source, "Book or manual."),
    PUBLISHED(skipped, "Whether a ground motion was missing."), PUBLISHED(motion, "Ground motion used; may be empty.")};
const struct thud_schema thud_published_schema =
    THUD_SCHEMA("verify --published",
                "With\n.Fl -json\nthe list\n.Va examples\nbehind\n.Va format\nand\n.Va version ;\nwith\n.Fl -csv\n"
                "columns before those of\n.Sx verify --published of each value .\n",
                published);

#define VALUE(member, text) THUD_FIELD(struct thud_published_row, member, #member, text)
static const struct thud_column values[] = {
    VALUE(quantity, "Quantity that is compared."),
    VALUE(unit, "Unit of the quantity."),
    VALUE(published, "Published value; for a check the expected value."),
    VALUE(computed, "Value computed by thud."),
    VALUE(difference, "Relative difference; absolute if the published value is 0."),
    VALUE(tolerance, "Allowed difference."),
    VALUE(check, "Whether this is an identity or a cross-check, not a published value."),
    VALUE(holds, "Whether the difference is within the tolerance.")};
const struct thud_schema thud_published_value_schema = THUD_SCHEMA(
    "verify --published of each value", "A row for each number; with\n.Fl -json\nthe list\n.Va values .\n", values);

/* ---- laws ---- */

#define LAW(member, text) THUD_FIELD(struct thud_law, member, #member, text)
static const struct thud_column laws[] = {LAW(name, "Name, as in a preset."), LAW(title, "Title for display."),
                                          LAW(summary, "Short description."), LAW(reference, "Reference.")};
const struct thud_schema thud_law_schema =
    THUD_SCHEMA("laws --csv",
                "A row for each impact law; with\n.Fl -json\nthe list\n.Va laws\nbehind\n.Va format\nand\n.Va version "
                ".\n",
                laws);

enum { IS_CHOICE = 1, IS_NUMBER = 2 };
struct param_row {
    struct thud_param own;
    const char *word;
};
#define PARAM(member, name, text, marks) THUD_FIELD_WITH(struct param_row, member, name, text, .only = (marks))
static const struct thud_column params[] = {
    PARAM(own.name, "name", "Name, as in a preset.", 0),
    PARAM(own.title, "title", "Title for display.", 0),
    PARAM(own.help, "help", "Short description.", 0),
    PARAM(own.unit, "unit", "Unit of the value.", 0),
    PARAM(word, "default", "Default word of a choice.", IS_CHOICE),
    THUD_STANDS_FOR("choices", "Allowed words of a choice."),
    PARAM(own.fallback, "default_si", "Default of a number, in SI units.", IS_NUMBER),
    PARAM(own.least, "least_si", "Lower bound, in SI units.", IS_NUMBER),
    PARAM(own.most, "most_si", "Upper bound, in SI units.", IS_NUMBER)};
const struct thud_schema thud_law_param_schema =
    THUD_SCHEMA("laws --json of each parameter", "In the list\n.Va parameters\nof each law.\n", params);

static void put_param(const struct thud_param *p, struct thud_text *out)
{
    bool choice = p->kind == THUD_PARAM_CHOICE;
    struct param_row row = {*p, choice ? p->choices[(int)p->fallback] : NULL};
    row.own.help = p->help ? p->help : "";
    row.own.unit = p->unit ? p->unit : "";
    thud_json_members(&thud_law_param_schema, choice ? IS_CHOICE : IS_NUMBER, &row, out);
    for (int i = 0; choice && p->choices[i]; i++) {
        thud_text_append(out, i > 0 ? ", " : ", \"choices\": [");
        thud_json_string(out, p->choices[i]);
    }
    thud_text_append(out, choice ? "]" : "");
}

void thud_laws_put(bool json, struct thud_text *out)
{
    struct thud_list list = {out, &thud_law_schema, NULL, json, 0};
    thud_list_begin(&list, "laws");
    for (int i = 0; i < thud_law_count(); i++) {
        const struct thud_law *law = thud_law_at(i);
        if (!json) {
            thud_list_add(&list, law, NULL, 0);
            continue;
        }
        thud_text_append(out, i > 0 ? ",\n  {" : "\n  {");
        thud_json_members(&thud_law_schema, 0, law, out);
        thud_text_append(out, ", \"parameters\": [");
        for (int k = 0; k < law->nparams; k++) {
            thud_text_append(out, k > 0 ? ",\n    {" : "\n    {");
            put_param(&law->params[k], out);
            thud_text_append(out, "}");
        }
        thud_text_append(out, "]}");
    }
    thud_list_end(&list);
}

/* ---- methods ---- */

struct method_row {
    struct thud_method own;
    bool fixed_step, locates;
};
#define METHOD(member, name, text) THUD_FIELD_WITH(struct method_row, member, name, text, .infinite = true)
static const struct thud_column methods[] = {
    METHOD(own.name, "name", "Name, as in a preset."),
    METHOD(own.title, "title", "Title for display."),
    METHOD(own.summary, "summary", "Short description."),
    METHOD(own.reference, "reference", "Reference."),
    METHOD(own.order, "order", "Order of accuracy."),
    METHOD(fixed_step, "fixed_step", "Whether the step is fixed."),
    METHOD(locates, "locates", "Whether events are located."),
    METHOD(own.stability, "stable_omega_dt",
           "Stability limit as omega dt, the step times the highest frequency; inf, in JSON null: none."),
    METHOD(own.limits, "limits", "Limits of use.")};
const struct thud_schema thud_methods_schema =
    THUD_SCHEMA("methods",
                "A row for each method; with\n.Fl -json\nthe list\n.Va methods\nbehind\n.Va format\nand\n.Va version "
                ".\n",
                methods);

void thud_methods_put(bool json, struct thud_text *out)
{
    struct thud_list list = {out, &thud_methods_schema, NULL, json, 0};
    thud_list_begin(&list, "methods");
    for (int i = 0; i < thud_method_count(); i++) {
        const struct thud_method *m = thud_method_at(i);
        const struct method_row row = {*m, (m->flags & THUD_METHOD_FIXED_STEP) != 0,
                                       (m->flags & THUD_METHOD_LOCATES) != 0};
        thud_list_add(&list, &row, NULL, 0);
    }
    thud_list_end(&list);
}

static const struct thud_column samples[] = {THUD_STANDS_FOR("time_s", "Time, s."),
                                             THUD_STANDS_FOR("acceleration_mps2", "Ground acceleration, m/s2.")};
const struct thud_schema thud_sampled_motion_schema =
    THUD_SCHEMA("record convert", "CSV, after comments that state what was done.\n", samples);

static const struct thud_column of_figures[] = {
    THUD_STANDS_FOR("panel", "Panel of the row."), THUD_STANDS_FOR("series", "Series of the row in its panel."),
    THUD_STANDS_FOR("kind", "Kind of the series: line, points, steps, bars, band (between two columns) or map.")};
const struct thud_schema thud_series_schema =
    THUD_SCHEMA("FIGURE.csv",
                "Beside every figure whose data stand in no other file.\nBehind these one column for each "
                "variable, headed by the axis and its unit;\nempty where a panel has no such variable.\nNumbers have "
                "15 digits.\n",
                of_figures);
