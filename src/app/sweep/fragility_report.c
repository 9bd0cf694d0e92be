#include "app/sweep/fragility_report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/result_table.h"
#include "io/file/json.h"
#include "io/result/result_rows.h"
#include "io/result/study_rows.h"
#include "io/result/sweep_csv.h"

static const double years = 50;

static double unit_of(const struct thud_sweep_axis *axis)
{
    const char *unit = axis->param->unit;
    double factor = unit && *unit && !axis->words ? thud_unit_factor(unit, NULL, NULL) : 1;
    return factor > 0 ? factor : 1;
}

/* ---- table ---- */

/* "0.52 (0.45 to 0.6)"; an end of the band that lies outside the values that were tried has no number. */
static void put_band(double value, double low, double high, const struct thud_fragility *f, double unit, int width,
                     struct thud_text *out)
{
    char text[80], end[2][24];
    if (!(f && low < f->least))
        snprintf(end[0], sizeof end[0], "%.3g", low / unit);
    else
        snprintf(end[0], sizeof end[0], "below %.3g", f->least / unit);
    if (!(f && high > f->most))
        snprintf(end[1], sizeof end[1], "%.3g", high / unit);
    else
        snprintf(end[1], sizeof end[1], "above %.3g", f->most / unit);
    if (isnan(low))
        snprintf(text, sizeof text, "%.3g", value / unit);
    else
        snprintf(text, sizeof text, "%.3g (%s to %s)", value / unit, end[0], end[1]);
    thud_text_append(out, "%-*s", width, text);
}

/* "0 5 3 0 0 of 7 at 5 10 15 20 25": at most five of the values. */
static void put_counts(const struct thud_fragility *f, double unit, struct thud_text *out)
{
    int most = 0;
    for (size_t i = 0; i < f->n; i++)
        most = f->stripe[i].n > most ? f->stripe[i].n : most;
    thud_text_append(out, "counts");
    for (size_t i = 0; i < f->n; i++)
        if (!thud_is_spread((int)f->n, (int)i))
            continue;
        else if (f->stripe[i].n == 0) /* there the scene is not possible */
            thud_text_append(out, " -");
        else
            thud_text_append(out, f->stripe[i].n == most ? " %d" : " %d/%d", f->stripe[i].count, f->stripe[i].n);
    thud_text_append(out, " of %d at", most);
    for (size_t i = 0; i < f->n; i++)
        if (thud_is_spread((int)f->n, (int)i))
            thud_text_append(out, " %.3g", f->stripe[i].x / unit);
}

/* The median, or what is known of it. */
static void put_median(const struct thud_fragility_line *line, double unit, bool hazard, struct thud_text *out)
{
    const struct thud_fragility *f = &line->fragility;
    char text[80] = "";
    if (!isnan(f->exact50)) { /* of pounding: exact, without a fit */
        if (isinf(f->exact50))
            snprintf(text, sizeof text, "never");
        else if (!isnan(f->exact_low))
            snprintf(text, sizeof text, "%.3g (%.3g to %.3g)", f->exact50 / unit, f->exact_low / unit,
                     f->exact_high / unit);
        else
            snprintf(text, sizeof text, "%.3g", f->exact50 / unit);
        thud_text_append(out, "%-29s%-8s", text, "exact");
        return;
    }
    if (!isnan(f->theta)) {
        put_band(f->theta, f->theta_low, f->theta_high, f, unit, 29, out);
        if (hazard) /* beside the rates there is no room for its band */
            thud_text_append(out, "%-8.3g", f->curve.beta);
        else
            put_band(f->curve.beta, f->beta_low, f->beta_high, NULL, 1, 20, out);
        return;
    }
    const char *what = f->curve.fit == THUD_FIT_NEVER ? "never: " : f->curve.fit == THUD_FIT_ALWAYS ? "always: " : "";
    if (f->above > 0 && isfinite(f->below))
        snprintf(text, sizeof text, "%.3g to %.3g: refine there", f->above / unit, f->below / unit);
    else if (f->above > 0)
        snprintf(text, sizeof text, "%sabove %.3g", what, f->above / unit);
    else if (isfinite(f->below))
        snprintf(text, sizeof text, "%sbelow %.3g", what, f->below / unit);
    else if (*what)
        snprintf(text, sizeof text, "%.*s", (int)strlen(what) - 2, what);
    if (*text)
        thud_text_append(out, hazard ? "%-37s" : "%s", text);
    else
        put_counts(f, unit, out);
}

/* The annual rate and the probability in 50 years, or their bounds. */
static void put_rate(const struct thud_rate *rate, struct thud_text *out)
{
    double least = 100 * thud_hazard_probability(rate->least, years),
           most = 100 * thud_hazard_probability(rate->most, years);
    if (isnan(rate->least))
        return;
    if (!isnan(rate->value) && !isnan(rate->low))
        thud_text_append(out, " %.2e (%.1e to %.1e) %.1f %%", rate->value, rate->low, rate->high,
                         100 * thud_hazard_probability(rate->value, years));
    else if (!isnan(rate->value))
        thud_text_append(out, " %.2e %5.1f %%", rate->value, 100 * thud_hazard_probability(rate->value, years));
    else if (isinf(rate->most))
        thud_text_append(out, " from %.1e %.1f %%", rate->least, least);
    else if (rate->least > 0)
        thud_text_append(out, " %.1e-%.1e %.1f-%.1f %%", rate->least, rate->most, least, most);
    else
        thud_text_append(out, " up to %.1e %.1f %%", rate->most, most);
}

static void put_few(const struct thud_suite *suite, struct thud_text *out)
{
    const int n = suite->ndraws;
    struct thud_text words = {0};
    if (n < THUD_SHARES_LEAST)
        thud_text_append(&words,
                         "%d independent ground motion%s no likelihood: the counts are all there is, without bands.", n,
                         n == 1 ? " gives" : "s give");
    else if (n < THUD_DRAWS_LEAST)
        thud_text_append(&words,
                         "%d independent ground motions are too few for the band of a median or a curve (at least %d). "
                         "The shares in fragility.csv and in the figures have bands (Wilson).",
                         n, THUD_DRAWS_LEAST);
    if (words.size > 0)
        thud_table_words(out, "\n", &words, 0);
}

/* Contact that is not monotone in the intensity: the median is that of the first contact. */
static void put_clearing(const struct thud_fragility_study *study, const struct thud_fragility_line *line,
                         struct thud_text *out)
{
    const struct thud_fragility *f = &line->fragility;
    struct thud_text words = {0};
    double clear = INFINITY;
    for (int r = 0; r < f->nexact && f->clearing > 0; r++)
        clear = fmin(clear, f->contact[r].clear_again);
    if (isfinite(clear))
        thud_text_append(&words,
                         "Case %s: contact is not monotonic in the motion. The median is that of the first contact; "
                         "under %d of %d motions there is no contact again at a factor of %.4g or more.",
                         thud_case_name(study->suite->plan->cases[line->k]), f->clearing, f->nexact, clear);
    if (words.size > 0)
        thud_table_words(out, "\n", &words, 2);
}

/* "spectral acceleration at 0.49 s, 5 % damped (g)". */
static void put_axis(const struct thud_sweep_axis *axis, struct thud_text *out)
{
    const char *unit = axis->param->unit;
    thud_text_append(out, "%s", axis->param->title);
    if (strcmp(axis->key, "record.sa") == 0 && isnan(axis->period_s))
        thud_text_append(out, " at the mean first period, 5 %% damped");
    else if (strcmp(axis->key, "record.sa") == 0)
        thud_text_append(out, " at %.3g s, 5 %% damped", axis->period_s);
    if (unit && *unit)
        thud_text_append(out, " (%s)", unit);
}

/* A spectral acceleration whose period the hazard curve does not name. */
static void put_period(const struct thud_fragility_study *study, struct thud_text *out)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    for (int a = 0; a < plan->naxes && study->hazard.n > 0 && !(study->hazard.period_s > 0); a++)
        if (strcmp(plan->axis[a].key, "record.sa") == 0)
            thud_text_append(out,
                             "\nThe hazard curve does not name its period (sa_g T=0.49s 5%%): it is taken as that of "
                             "the study.\n");
}

/* Where the other keys stand along a line; "-" where there are none. */
static const char *place_of(const struct thud_fragility_study *study, const struct thud_fragility_line *line, char *at,
                            size_t size)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    thud_sweep_setting(plan, plan->naxes, line->at, line->axis, false, at, size);
    return *at ? at : "-";
}

void thud_fragility_table(const struct thud_fragility_study *study, struct thud_text *out)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    int event = -1, axis = -1, width = 10, names = 7;
    char at[160];
    for (size_t i = 0; i < study->n; i++)
        width = thud_text_wider(width, place_of(study, &study->line[i], at, sizeof at));
    for (int k = 0; k < plan->ncases; k++)
        names = thud_text_wider(names, thud_case_name(plan->cases[k]));
    for (size_t i = 0; i < study->n; i++) {
        const struct thud_fragility_line *line = &study->line[i];
        const struct thud_sweep_axis *along = &plan->axis[line->axis];
        bool hazard = study->hazard.n > 0 && thud_axis_is_intensity(along);
        if (!thud_sweep_is_spread(plan, line->at, line->axis))
            continue;
        if (line->event != event || line->axis != axis) {
            thud_text_append(out, "%s%s against ", event >= 0 ? "\n" : "", study->event[line->event].text);
            put_axis(along, out);
            thud_text_append(out, ", %d ground motion%s\n", study->suite->nrecords,
                             study->suite->nrecords == 1 ? "" : "s");
            thud_text_append(out, "  %-*s %-*s %-28s %-*s%s\n", names, "case", width, "at",
                             study->suite->ndraws < THUD_DRAWS_LEAST ? "50 %" : "50 % (90 % band)", hazard ? 8 : 10,
                             "dispersion", hazard ? " a year (16 to 84 %)  in 50 y" : "");
        }
        event = line->event;
        axis = line->axis;
        thud_text_append(out, "  %-*s %-*s ", names, thud_case_name(plan->cases[line->k]), width,
                         place_of(study, line, at, sizeof at));
        put_median(line, unit_of(along), hazard, out);
        put_rate(&line->rate, out);
        while (out->size > 0 && out->data[out->size - 1] == ' ')
            out->data[--out->size] = '\0';
        thud_text_append(out, "\n");
    }
    for (size_t i = 0; i < study->n; i++)
        put_clearing(study, &study->line[i], out);
    put_period(study, out);
    put_few(study->suite, out);
}

/* ---- CSV and JSON ---- */

static struct thud_curve_key key_of(const struct thud_fragility_study *study, const struct thud_fragility_line *line)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    return (struct thud_curve_key){study->event[line->event].text, thud_case_name(plan->cases[line->k]),
                                   plan->axis[line->axis].key};
}

/* Where a line is on every axis; `own`: the value on its own one, NaN for none. */
static void put_place(const struct thud_sweep_plan *plan, const struct thud_fragility_line *line, double own,
                      union thud_column_value *cell)
{
    thud_axis_cells(plan, NULL, line->at, cell);
    cell[line->axis].number = own; /* a number: no other is drawn against */
}

void thud_fragility_csv(const struct thud_fragility_study *study, struct thud_text *out)
{
    struct thud_made_columns axes = {0};
    thud_axis_columns(study->suite->plan, NULL, &axes);
    struct thud_part part[] = {
        {&thud_curve_key_schema, 0, NULL}, {&axes.schema, 0, axes.cell}, {&thud_stripe_schema, 0, NULL}};
    thud_parts_names(part, 3, out);
    for (size_t i = 0; i < study->n; i++) {
        const struct thud_fragility_line *line = &study->line[i];
        const struct thud_fragility *f = &line->fragility;
        const struct thud_curve_key key = key_of(study, line);
        for (size_t j = 0; j < f->n; j++) {
            const struct thud_stripe *s = &f->stripe[j];
            const struct thud_stripe_row row = {s->n,
                                                s->count,
                                                s->n > 0 ? (double)s->count / s->n : NAN,
                                                f->share_low[j],
                                                f->share_high[j],
                                                thud_lognormal_at(&f->curve, s->x),
                                                f->low[j],
                                                f->high[j]};
            put_place(study->suite->plan, line, s->x, axes.cell);
            part[0].row = &key;
            part[2].row = &row;
            thud_parts_csv(part, 3, out);
        }
    }
}

/* ---- medians ---- */

enum { MEDIANS = 10 }; /* columns of thud_median_schema behind `fit`, which end with UNIT */

/* The median in the columns of its unit: each unit along which there are curves has its own. Returns how many. */
static int median_units(const struct thud_fragility_study *study, const char *unit[THUD_VARY_MAX])
{
    int n = 0;
    for (int a = 0; a < study->suite->plan->naxes; a++) {
        const struct thud_sweep_axis *axis = &study->suite->plan->axis[a];
        bool there = !thud_axis_is_drawn(axis);
        for (int i = 0; i < n && !there; i++)
            there = strcmp(unit[i], thud_si_suffix(axis->param)) == 0;
        if (!there)
            unit[n++] = thud_si_suffix(axis->param);
    }
    return n;
}

/* NaN for what is not known, lies outside the values that were tried, or has no bound. */
static void median_cells(const struct thud_fragility *f, union thud_column_value cell[MEDIANS])
{
    bool told = !isnan(f->theta);
    const double x[MEDIANS] = {f->theta,
                               told && f->theta_low >= f->least ? f->theta_low : NAN,
                               told && f->theta_high <= f->most ? f->theta_high : NAN,
                               f->above > 0 ? f->above : NAN,
                               isfinite(f->below) ? f->below : NAN,
                               isinf(f->exact16) ? NAN : f->exact16,
                               isinf(f->exact50) ? NAN : f->exact50,
                               isinf(f->exact84) ? NAN : f->exact84,
                               isinf(f->exact_low) ? NAN : f->exact_low,
                               isinf(f->exact_high) ? NAN : f->exact_high};
    for (int i = 0; i < MEDIANS; i++)
        cell[i].number = x[i];
}

static struct thud_curve_row curve_of(const struct thud_fragility_line *line)
{
    const struct thud_fragility *f = &line->fragility;
    const double rate[THUD_CURVE_RATES] = {line->rate.value, line->rate.least,
                                           isinf(line->rate.most) ? NAN : line->rate.most, line->rate.low,
                                           line->rate.high};
    bool told = !isnan(f->theta); /* a median far outside comes with any dispersion */
    struct thud_curve_row row = {.beta = told ? f->curve.beta : NAN,
                                 .beta_low = told ? f->beta_low : NAN,
                                 .beta_high = told ? f->beta_high : NAN,
                                 .falling = thud_is_fitted(&f->curve) ? f->curve.falling : THUD_NO_COUNT,
                                 .deviance_p = f->curve.p};
    for (int i = 0; i < THUD_CURVE_RATES; i++) {
        row.rate[i] = rate[i];
        row.probability[i] = isnan(rate[i]) ? NAN : thud_hazard_probability(rate[i], years);
    }
    return row;
}

/* Adds how a curve was fitted, and its medians in the columns of their units. */
static void add_medians(const char *const *unit, int units, struct thud_made_columns *out)
{
    thud_column_add(out, true, "fit");
    for (int i = 0; i < MEDIANS * units; i++) {
        const char *name = thud_median_schema.column[1 + i % MEDIANS].name;
        thud_column_add(out, false, "%.*s%s", (int)(strlen(name) - strlen("UNIT")), name, unit[i / MEDIANS]);
    }
}

void thud_fragility_curves_csv(const struct thud_fragility_study *study, struct thud_text *out)
{
    const char *unit[THUD_VARY_MAX];
    struct thud_made_columns made = {0};
    int units = median_units(study, unit);
    thud_axis_columns(study->suite->plan, NULL, &made);
    union thud_column_value *fit = made.cell + made.schema.n;
    add_medians(unit, units, &made);
    struct thud_part part[] = {
        {&thud_curve_key_schema, 0, NULL}, {&made.schema, 0, made.cell}, {&thud_curve_schema, 0, NULL}};
    thud_parts_names(part, 3, out);
    for (size_t i = 0; i < study->n; i++) {
        const struct thud_fragility_line *line = &study->line[i];
        const struct thud_curve_key key = key_of(study, line);
        const struct thud_curve_row row = curve_of(line);
        const char *own = thud_si_suffix(study->suite->plan->axis[line->axis].param);
        put_place(study->suite->plan, line, NAN, made.cell);
        fit->text = thud_fit_name(line->fragility.curve.fit);
        for (int u = 0; u < units; u++) {
            union thud_column_value *cell = fit + 1 + u * MEDIANS;
            median_cells(&line->fragility, cell);
            for (int j = 0; j < MEDIANS && strcmp(unit[u], own) != 0; j++)
                cell[j].number = NAN;
        }
        part[0].row = &key;
        part[2].row = &row;
        thud_parts_csv(part, 3, out);
    }
}

struct contacts {
    const struct thud_sweep_plan *plan;
    const struct thud_first_contact *contact;
};

static void make_contact(const void *of, int i, void *row)
{
    const struct contacts *c = of;
    const struct thud_record *motion = c->plan->nrecords > 0 ? c->plan->record[i] : NULL;
    *(struct thud_first_contact_row *)row = (struct thud_first_contact_row){
        motion ? thud_path_name(motion->file) : "", c->contact[i].first, c->contact[i].clear_again};
}

static void put_json_line(const struct thud_fragility_study *study, const struct thud_fragility_line *line,
                          struct thud_text *out)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    const struct thud_fragility *f = &line->fragility;
    const struct thud_curve_key key = key_of(study, line);
    thud_text_append(out, "{");
    thud_json_members(&thud_curve_key_schema, 0, &key, out);
    thud_text_append(out, ", \"at\": {");
    for (int a = 0, any = 0; a < plan->naxes; a++) {
        if (a == line->axis)
            continue;
        thud_text_append(out, any++ ? ", " : "");
        thud_json_string(out, plan->axis[a].key);
        thud_text_append(out, ": ");
        thud_json_string(out, plan->axis[a].text[line->at[a]]);
    }
    const struct thud_curve_row row = curve_of(line);
    const char *unit = thud_si_suffix(plan->axis[line->axis].param);
    struct thud_made_columns median = {0};
    add_medians(&unit, 1, &median);
    median.cell->text = thud_fit_name(f->curve.fit);
    median_cells(f, median.cell + 1);
    thud_text_append(out, "}, \"falling\": %s, ",
                     !thud_is_fitted(&f->curve) ? "null"
                     : f->curve.falling         ? "true"
                                                : "false");
    const struct thud_part part[] = {{&median.schema, 0, median.cell}, {&thud_curve_schema, 0, &row}};
    thud_parts_json(part, 2, out);
    thud_text_append(out, ", \"stripes\": [");
    for (size_t j = 0; j < f->n; j++) {
        thud_text_append(out, "%s[", j ? ", " : "");
        thud_json_number(out, f->stripe[j].x);
        thud_text_append(out, ", %d, %d]", f->stripe[j].n, f->stripe[j].count);
    }
    thud_text_append(out, "]");
    if (f->nexact > 0 && f->contact) {
        const struct contacts of = {plan, f->contact};
        thud_json_list("first_contact",
                       &(struct thud_rows){&thud_first_contact_schema, 0, f->nexact, make_contact, &of}, out);
    }
    thud_text_append(out, "}");
}

void thud_fragility_json(const struct thud_fragility_study *study, struct thud_text *out)
{
    thud_text_append(out, "{");
    thud_json_head_of(out, 2, study->suite->plan->scene.name); /* 2: annual_rate_low, _high are a band */
    thud_text_append(out, ", \"motions\": %d, \"independent\": %d, \"curves\": [", study->suite->nrecords,
                     study->suite->ndraws);
    for (size_t i = 0; i < study->n; i++) {
        thud_text_append(out, i ? ",\n  " : "\n  ");
        put_json_line(study, &study->line[i], out);
    }
    thud_text_append(out, "\n]");
    thud_remarks_json(study->scope, THUD_REMARKS_OF_STUDY, out);
    thud_text_append(out, "}\n");
}
