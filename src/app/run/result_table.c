#include "app/run/result_table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/run/summary_line.h"
#include "base/ascii.h"
#include "ground/identity.h"
#include "io/result/result_rows.h"
#include "study/scene/building.h"
#include "study/scene/solution.h"
#include "study/sweep/remark.h"

enum { LABEL = 15 }; /* where the words behind the label of a line begin */

void thud_table_words(struct thud_text *out, const char *label, struct thud_text *words, size_t indent)
{
    for (size_t i = 1; i + 1 < words->size; i++)
        if (words->data[i] == ' ' && thud_ascii_is_digit(words->data[i - 1]) &&
            (words->data[i + 1] > '9' || words->data[i + 1] == '%'))
            words->data[i] = '\t';
    thud_text_append(out, "%s", label);
    thud_text_wrap(out, words->data ? words->data : "", indent, THUD_LINE_WIDTH);
    thud_text_append(out, "\n");
    out->failed |= words->failed;
    thud_text_clear(words);
}

void thud_table_whole(struct thud_text *out, const char *words, size_t indent)
{
    struct thud_text whole = {0};
    thud_text_append(&whole, "%s", words);
    for (char *blank = whole.data; blank && (blank = strchr(blank, ' ')) != NULL;)
        *blank = '\t';
    thud_text_wrap(out, whole.data ? whole.data : "", indent, THUD_LINE_WIDTH);
    thud_text_clear(&whole);
}

void thud_table_lines(struct thud_text *out, struct thud_text *lines, size_t indent)
{
    for (const char *line = lines->data; line && *line;) {
        const size_t blanks = strspn(line, " "), n = strcspn(line, "\n");
        struct thud_text words = {0};
        thud_text_append(&words, "%.*s", (int)(n - blanks), line + blanks);
        thud_text_append(out, "%*s", (int)blanks, "");
        thud_table_words(out, "", &words, blanks + indent);
        line += n + (line[n] == '\n');
    }
    out->failed |= lines->failed;
    thud_text_clear(lines);
}

static void add_head(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_scene *scene = report->scene;
    struct thud_text words = {0};
    thud_text_append(&words, "%s, case %s: %s", scene->name, report->which, scene->title);
    thud_table_words(out, "", &words, 2);
    char peak[96];
    if (report->record) {
        thud_record_peak_text(report->record, peak, sizeof peak);
        thud_text_append(&words, "%s", report->record->file);
        for (char *blank = words.data; blank && (blank = strchr(blank, ' ')) != NULL;)
            *blank = '\t'; /* a name is not taken apart */
        thud_text_append(&words, "%s, %s, %zu samples every %.4g s", thud_record_synthetic_mark(report->record), peak,
                         report->record->samples, report->record->dt_s);
    } else
        thud_text_append(&words, "none");
    thud_table_words(out, "ground motion  ", &words, LABEL);
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        const struct thud_interface *f = &scene->interface[i];
        char label[24], gap[64], thickness[64], clearance[2048];
        thud_interface_gap_text(f, gap, sizeof gap);
        thud_interface_thickness_text(f, thickness, sizeof thickness);
        thud_interface_clearance_text(scene, i, clearance, sizeof clearance);
        thud_text_append(&words, "gap %s", gap);
        if (f->has_bumper)
            thud_text_append(&words, ", %s bumper of %s in a cavity of %.4g cm", f->bumper.law->name, thickness,
                             100 * f->bumper_cavity_m);
        else
            thud_text_append(&words, ", %s", f->contact.law->name);
        thud_text_append(&words, ": clearance %s", clearance);
        snprintf(label, sizeof label, "interface %-5d", i + 1);
        thud_table_words(out, label, &words, LABEL);
    }
}

/* The result, for each two neighbours; a free body goes on for ever, and there is no required gap. */
static void add_results(const struct thud_report *report, struct thud_text *out)
{
    enum { COLUMNS = 65 };
    struct thud_error fall;
    struct thud_text words = {0};
    if (thud_collapse_remark(report->scene, &report->result->collapse, &fall)) {
        thud_text_append(&words, "%s;", fall.what);
        thud_table_words(out, "COLLAPSE       ", &words, LABEL);
        thud_text_append(out, "               the peaks below are those until then\n");
    }
    const struct thud_scene *scene = report->scene;
    const struct thud_result *r = report->result;
    for (int i = 1; i < scene->nstructures; i++) {
        struct thud_summary_line line = {.need_m = NAN, .in_row = scene->nstructures > 2};
        char text[160], needs[96];
        thud_interface_gap_text(&scene->interface[i - 1], line.gap, sizeof line.gap);
        line.by_level = scene->interface[i - 1].gap.n > 0;
        const struct thud_contact_sum contacts = thud_contacts_sum(r, i);
        line.impacts = contacts.impacts;
        line.impulse_ns = contacts.impulse_ns;
        line.force_n = contacts.force_n;
        bool free_body =
            scene->structure[i - 1].kind == THUD_RIGID || scene->structure[i].kind == THUD_RIGID || !report->gap;
        if (!free_body && thud_needed_gap_widest(report->gap, i, THUD_GAP_EXACT, NULL) >= 0) {
            line.need_m = thud_needed_gap_widest(report->gap, i, THUD_GAP_EXACT, NULL);
            line.abs_m = thud_needed_gap_widest(report->gap, i, THUD_GAP_ABS, NULL);
            line.srss_m = thud_needed_gap_widest(report->gap, i, THUD_GAP_SRSS, NULL);
            line.bumper_m = thud_needed_gap_with_bumpers(report->gap, scene, i) - line.need_m;
        }
        thud_summary_line(&line, COLUMNS, text, sizeof text);
        if (line.in_row)
            thud_text_append(out, "summary %-6d %s\n", i, text);
        else
            thud_text_append(out, "summary        %s\n", text);
        thud_summary_needs(&line, needs, sizeof needs);
        if (!isnan(line.need_m) && !strstr(text, "needs")) /* it found no room */
            thud_text_append(out, "               %s\n", needs);
    }
}

static void add_hint(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_remark_scope scope = {.scene = report->scene};
    struct thud_remarks found = thud_remarks_find(&scope, THUD_REMARK_SIMPLER);
    struct thud_text words = {0};
    for (int i = 0; i < found.n; i++) {
        thud_text_append(&words, "%s", found.item[i].said.what);
        thud_table_words(out, "simpler        ", &words, LABEL);
    }
    thud_remarks_clear(&found);
}

static void add_structure(const struct thud_report *report, int s, struct thud_text *out)
{
    const struct thud_structure_result *r = &report->result->structure[s];
    const struct thud_structure *p = &report->scene->structure[s];
    char number[32];
    if (r->floors == 0)
        return;
    struct thud_text words = {0};
    thud_text_append(&words, "%s", p->name);
    for (int i = 0; i < r->floors && i < 3 && isfinite(r->period_s[i]); i++)
        thud_text_append(&words, "%s T%d %.4g s", i > 0 ? "," : ":", i + 1, r->period_s[i]);
    if (r->base_shear.value > 0)
        thud_text_append(&words, "; base shear %s MN at %.3f s", thud_digits(1e-6 * r->base_shear.value, 5, number),
                         r->base_shear.time_s);
    if (r->overturning.value > 0)
        thud_text_append(&words, "; overturning moment %s MN m at %.3f s",
                         thud_digits(1e-6 * r->overturning.value, 5, number), r->overturning.time_s);
    thud_table_words(out, "\n", &words, 0);
    if (thud_period_is_estimated(p)) {
        const struct thud_estimate e = thud_structure_estimate(p);
        thud_text_append(
            &words,
            "estimated: T1 %.4g s by EN 1998-1\t4.3.3.2.2(3), multiplied by %.4g; %.4g s by ASCE\t7-16\t12.8.2.1; "
            "measured periods are %.4g to %.4g times such estimates (`thud\tgap` covers this range); "
            "floors of %.4g t, %.4g t/m2",
            e.en1998_s, p->period_factor, e.asce7_s, THUD_ESTIMATE_LEAST, THUD_ESTIMATE_MOST, 1e-3 * p->mass_kg[0],
            1e-3 * p->mass_kg[0] / p->area_m2);
        thud_table_words(out, "", &words, 0);
    }
    if (thud_isolator_slides(p)) {
        thud_text_append(&words, "isolators: %s, displacement %.4g mm at %.3f s, %.4g mm at the end; %.5g kJ lost",
                         thud_isolator_name(thud_structure_isolator(p).law), 1e3 * r->floor[0].drift.value,
                         r->floor[0].drift.time_s, 1e3 * r->storey[0].permanent_m, 1e-3 * r->storey[0].hysteretic_j);
        thud_table_words(out, "", &words, 0);
    }
    if (r->foundation)
        thud_text_append(
            out,
            "foundation: sway %.4g mm at %.3f s, rocking %.4g mrad at %.3f s\n(%.4g mm at the roof). "
            "T1 %.4g s and damping %.3g %% on rigid ground,\n%.3g %% on this soil (of the undamped mode)\n",
            1e3 * r->foundation[0].displacement.value, r->foundation[0].displacement.time_s,
            1e3 * r->foundation[1].displacement.value / r->arm_m, r->foundation[1].displacement.time_s,
            1e3 * r->foundation[1].displacement.value, r->rigid_period_s, 1e2 * p->damping, 1e2 * r->soil_damping);
    const struct thud_floors floors = {report, s};
    const struct thud_rows rows = thud_floor_rows(&floors), storeys = thud_storey_rows(&floors);
    thud_rows_table(&rows, out);
    if (r->storey)
        thud_rows_table(&storeys, out);
}

static void add_rows(struct thud_rows rows, struct thud_text *out)
{
    thud_text_append(out, rows.n > 0 ? "\n" : "");
    if (rows.n > 0)
        thud_rows_table(&rows, out);
}

static void add_contacts(const struct thud_report *report, struct thud_text *out)
{
    bool drifts = true;
    for (int i = 0; i < report->result->ncolumns; i++)
        drifts = drifts && report->result->column[i].drifts;
    add_rows(thud_contact_rows(report), out);
    add_rows(thud_column_end_rows(report), out);
    if (!drifts)
        thud_text_append(out,
                         "Where neither EI nor stiffness is given, by the contact forces alone, without the drift.\n");
    add_rows(thud_link_rows(report), out);
}

/* Steps end where the ground motion has its samples, so that the one asked for is the longest there may be. */
static void add_step(double taken_s, double asked_s, char *text, size_t size)
{
    thud_append(text, size, "step %.4g\ts", taken_s);
    if (isnan(asked_s))
        thud_append(text, size, " (its own choice)");
    else if (fabs(taken_s - asked_s) > 1e-6 * asked_s)
        thud_append(text, size, " (for %.4g\ts: steps end at the motion's samples)", asked_s);
}

/* "isolators, storeys that yield and links that slip": whatever of them the scene has; false: none. */
static bool name_losses(const struct thud_report *report, char *text, size_t size)
{
    bool isolators = false, storeys = false;
    for (int s = 0; s < report->result->nstructures; s++) {
        const struct thud_structure_result *r = &report->result->structure[s];
        const bool slides = thud_isolator_slides(&report->scene->structure[s]);
        isolators = isolators || slides;
        for (int i = slides; i < r->floors && r->storey; i++)
            storeys = storeys || r->storey[i].yields;
    }
    const char *part[] = {"isolators", "storeys that yield", "links that slip"};
    const bool has[] = {isolators, storeys, thud_scene_slips(report->scene)};
    int left = has[0] + has[1] + has[2];
    text[0] = '\0';
    for (int i = 0; i < 3; i++)
        if (has[i])
            thud_append(text, size, "%s%s", part[i], --left > 1 ? ", " : left == 1 ? " and " : "");
    return *text != '\0';
}

static void add_foot(const struct thud_report *report, struct thud_text *out)
{
    const struct thud_result *r = report->result;
    const struct thud_energy *e = &r->energy;
    struct thud_text energy = {0};
    thud_text_append(&energy,
                     "input\t%.5g kJ, initial\t%.5g, kinetic\t%.5g, strain\t%.5g, damping\t%.5g, contact\t%.5g, "
                     "stored\tin\tcontacts\t%.5g;",
                     1e-3 * e->input_j, 1e-3 * e->initial_j, 1e-3 * e->kinetic_j, 1e-3 * e->strain_j,
                     1e-3 * e->viscous_j, 1e-3 * e->contact_j, 1e-3 * e->stored_j);
    char where[80];
    const char *label = "\nenergy         ", *next = "               ";
    if (name_losses(report, where, sizeof where)) {
        thud_table_words(out, label, &energy, LABEL);
        label = next;
        thud_text_append(&energy, "lost in %s\t%.5g;", where, 1e-3 * e->hysteretic_j);
    }
    if (report->scene->p_delta) {
        thud_table_words(out, label, &energy, LABEL);
        label = next;
        thud_text_append(&energy, "work of the weight\t%.5g;", 1e-3 * e->gravity_j);
    }
    thud_text_append(&energy, " unaccounted\t%.1e", e->error_ratio);
    thud_table_words(out, label, &energy, LABEL);
    char words[300] = "";
    thud_text_append(out, "method         %s", r->method);
    if (r->reason[0])
        snprintf(words, sizeof words, "(%s)", r->reason);
    thud_text_wrap(out, words, LABEL, THUD_LINE_WIDTH);
    thud_text_append(out, "\n               ");
    *words = '\0';
    if (isnan(r->step_s))
        thud_append(words, sizeof words, "tolerance %g", report->scene->analysis.tolerance);
    else
        add_step(r->step_s, report->scene->analysis.step_s, words, sizeof words);
    thud_append(words, sizeof words, ", %ld steps, %ld force evaluations, %ld events, to\t%.5g\ts", r->work.steps,
                r->work.force_evaluations, r->work.events, r->end_s);
    thud_text_wrap(out, words, LABEL, THUD_LINE_WIDTH);
    thud_text_append(out, "\n");
}

static void add_truncation(const struct thud_truncation *t, struct thud_text *out)
{
    struct thud_text words = {0};
    thud_text_append(&words,
                     "the lowest %d of each building, %d omitted: relative to all modes peaks differ by up to "
                     "%.3g\t%% (acceleration), %.3g\t%% (drift), %.3g\t%% (force)",
                     t->modes, t->left_out, 100 * t->acceleration, 100 * t->drift, 100 * t->force);
    thud_table_words(out, "modes          ", &words, LABEL);
}

void thud_result_table(const struct thud_report *report, struct thud_text *out)
{
    add_head(report, out);
    add_results(report, out);
    add_hint(report, out);
    for (int s = 0; s < report->result->nstructures; s++)
        add_structure(report, s, out);
    add_contacts(report, out);
    add_foot(report, out);
    if (report->truncation)
        add_truncation(report->truncation, out);
    if (report->sensitivity)
        thud_sensitivity_table(report, out);
}

void thud_event_list(const struct thud_report *report, enum thud_event_format format, struct thud_text *out)
{
    const struct thud_rows rows = thud_event_rows(report);
    if (format == THUD_EVENTS_TEXT)
        thud_rows_table(&rows, out);
    else if (format == THUD_EVENTS_CSV)
        thud_rows_csv(&rows, out);
    else
        thud_text_append(out, "{\"events\": [\n");
    for (int i = 0; i < rows.n && format == THUD_EVENTS_JSON; i++) {
        struct thud_row_room row;
        rows.make(report, i, row.bytes);
        thud_text_append(out, "{");
        thud_json_members(rows.schema, thud_event_marks(report, i), row.bytes, out);
        thud_text_append(out, i + 1 < rows.n ? "},\n" : "}\n");
    }
    if (format == THUD_EVENTS_JSON)
        thud_text_append(out, "]}\n");
}

void thud_floor_table(const struct thud_scene *scene, const struct thud_floor_spectra *s, struct thud_text *out)
{
    struct thud_text words = {0};
    int width = 8;
    for (int f = 0; f < s->nfloors; f++)
        width = thud_text_wider(width - 4, scene->structure[s->floor[f].structure].name) + 4; /* with its floor */
    thud_text_append(&words, "%s: %s", scene->name, scene->title);
    thud_table_words(out, "", &words, 2);
    thud_text_append(&words,
                     "floor spectra, %.3g\t%% damping, %d periods from %.4g to %.4g s: largest acceleration of the "
                     "floor, g; largest pseudo-acceleration of an oscillator on it, g, and its period, s",
                     100 * s->damping, s->nperiods, s->period_s[0], s->period_s[s->nperiods - 1]);
    thud_table_words(out, "", &words, 0);
    thud_text_append(out, "\n%-*s", width, "");
    for (int i = 0; i < s->ncases; i++)
        thud_text_append(out, "  %-22s", thud_floor_case_title(scene, i));
    thud_text_append(out, "\n");
    for (int f = 0; f < s->nfloors; f++) {
        char name[THUD_NAME_MAX + 16];
        snprintf(name, sizeof name, "%s.%d", scene->structure[s->floor[f].structure].name, s->floor[f].floor + 1);
        thud_text_padded(out, name, width);
        for (int i = 0; i < s->ncases; i++) {
            int k;
            const double *sa = thud_floor_spectrum(s, i, f, &k), peak = s->peak_mps2[i * s->nfloors + f];
            char own[24];
            snprintf(own, sizeof own, isnan(peak) ? "-" : "%.3f", peak / THUD_GRAVITY);
            thud_text_append(out, "  %7s %7.3f %6.3f", own, sa[k] / THUD_GRAVITY, s->period_s[k]);
        }
        thud_text_append(out, "\n");
    }
}
