#include "app/sweep/fragility_report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/file/file.h"
#include "io/file/json.h"
#include "io/result/study_rows.h"
#include "io/result/sweep_csv.h"

static const double years = 50;

static double unit_of(const struct thud_sweep_axis *axis)
{
    const char *unit = axis->param->unit;
    double factor = unit && *unit && !axis->words ? thud_unit_factor(unit, NULL, NULL) : 1;
    return factor > 0 ? factor : 1;
}

/* ---- hazard ---- */

static enum thud_status refuse(const char *path, int line, const char *what, struct thud_error *err)
{
    thud_error_set(err, THUD_INPUT, "%s", what);
    thud_error_place(err, path, line, 0);
    thud_error_allow(err, "intensity, annual rate of being exceeded: intensities rise, rates fall");
    return THUD_INPUT;
}

/* A line of two numbers; false where it has none. */
static bool two_numbers(const char *line, double *x, double *rate)
{
    const char *end;
    if (thud_number_parse(line + strspn(line, " \t"), &end, x) != 0)
        return false;
    end += strspn(end, " \t,;");
    if (thud_number_parse(end, &end, rate) != 0)
        return false;
    return end[strspn(end, " \t\r")] == '\0';
}

/* The unit that the name of a first column ends with, `sa_g`, `Sa (cm/s2)`, `PGA [m/s2]`: its factor to SI; 0: none. */
static double unit_of_head(const char *head, enum thud_dimension *dimension)
{
    static const char *const suffix[][2] = {{"mps2", "m/s2"}, {"cmps2", "cm/s2"}, {"gal", "cm/s2"}, {"mmps2", "mm/s2"}};
    char name[64], *unit;
    size_t n = strcspn(head, ",;\t\r");
    snprintf(name, sizeof name, "%.*s", (int)n, head);
    if ((unit = strpbrk(name, "([")) != NULL) {
        unit++;
        unit[strcspn(unit, ")]")] = '\0';
    } else if ((unit = strrchr(name, '_')) != NULL) {
        unit++;
        unit[strcspn(unit, " ")] = '\0';
    } else {
        return 0;
    }
    for (size_t i = 0; i < sizeof suffix / sizeof *suffix; i++)
        if (strcmp(unit, suffix[i][0]) == 0)
            unit = (char *)suffix[i][1];
    return thud_unit_factor(unit, dimension, NULL);
}

/* What the first column is multiplied by. Of an acceleration the unit must be said. */
static enum thud_status read_unit(const char *path, int line, const char *head, const struct thud_sweep_axis *axis,
                                  double *factor, struct thud_error *err)
{
    enum thud_dimension dimension = axis->param->dimension;
    double said = unit_of_head(head, &dimension);
    *factor = said > 0 ? said : 1;
    if (said > 0 ? dimension == axis->param->dimension : axis->param->dimension != THUD_ACCELERATION)
        return THUD_OK;
    thud_error_set(err, THUD_INPUT,
                   said > 0 ? "its intensity has a unit of another kind than %s"
                            : "the unit of its intensity is not said (%s)",
                   axis->key);
    thud_error_place(err, path, line, 0);
    thud_error_allow(err, axis->param->dimension == THUD_ACCELERATION
                              ? "a first line such as sa_g,annual_rate or sa (cm/s2),annual_rate; g, m/s2, cm/s2, gal"
                              : "a number without unit: factor,annual_rate");
    return THUD_INPUT;
}

static enum thud_status add_point(const char *path, int number, double x, double rate, struct thud_hazard *out,
                                  struct thud_error *err)
{
    if (!(x > 0 && rate > 0 && isfinite(x) && isfinite(rate)))
        return refuse(path, number, "has a number that is not above 0", err);
    if (out->n > 0 && !(x > out->x[out->n - 1] && rate <= out->rate[out->n - 1]))
        return refuse(path, number, "does not go on: intensities rise, rates fall", err);
    out->x[out->n] = x;
    out->rate[out->n++] = rate;
    return THUD_OK;
}

enum thud_status thud_hazard_read(const char *path, const struct thud_sweep_axis *axis, struct thud_hazard *out,
                                  struct thud_error *err)
{
    enum { BYTES_MAX = 16 << 20 };
    char *text, *rest, *line;
    size_t room = 1;
    int number = 0;
    double x, rate, factor = NAN;
    *out = (struct thud_hazard){0};
    enum thud_status status = thud_text_read(path, BYTES_MAX, &text, err);
    if (status != THUD_OK)
        return status;
    for (line = text; *line; line++)
        room += *line == '\n';
    out->x = malloc(room * sizeof *out->x);
    out->rate = malloc(room * sizeof *out->rate);
    if (!out->x || !out->rate)
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    for (rest = text; status == THUD_OK && (line = thud_text_line(&rest)) != NULL;) {
        number++;
        line[strcspn(line, "#")] = '\0';
        if (line[strspn(line, " \t\r")] == '\0')
            continue;
        bool numbers = two_numbers(line, &x, &rate), first = isnan(factor);
        if (first)
            status = read_unit(path, number, numbers ? "" : line, axis, &factor, err);
        if (status == THUD_OK && numbers)
            status = add_point(path, number, x * factor, rate, out, err);
        else if (status == THUD_OK && !first)
            status = refuse(path, number, "is no line of two numbers", err);
    }
    if (status == THUD_OK && out->n < 2)
        status = refuse(path, 0, "has fewer than two points", err);
    free(text);
    if (status != THUD_OK)
        thud_hazard_clear(out);
    return status;
}

/* ---- all curves ---- */

/* Goes on to the next setting of all axes but one; false after the last. */
static bool next_setting(const struct thud_sweep_plan *plan, int axis, int *at)
{
    for (int a = plan->naxes - 1; a >= 0; a--) {
        if (a == axis)
            continue;
        if (++at[a] < plan->axis[a].n)
            return true;
        at[a] = 0;
    }
    return false;
}

static bool is_drawn(const struct thud_sweep_axis *axis)
{
    return !axis->words && axis->n > 1;
}

/* The event `worse` asks for a bumper. */
static bool is_asked(const struct thud_fragility_study *study, int event, int k)
{
    return study->event[event].kind != THUD_EVENT_WORSE || study->suite->plan->cases[k] != THUD_CASE_NONE;
}

static size_t count_lines(const struct thud_fragility_study *study)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    size_t n = 0;
    for (int a = 0; a < plan->naxes; a++)
        if (is_drawn(&plan->axis[a]))
            n += (size_t)(study->suite->settings / plan->axis[a].n);
    return n * (size_t)plan->ncases * (size_t)study->nevents;
}

/* An event of a case along an axis, at every setting of the others. */
static enum thud_status add_lines(struct thud_fragility_study *study, int event, int axis, int k,
                                  struct thud_error *err)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    int at[THUD_VARY_MAX] = {0};
    do {
        struct thud_fragility_line *line = &study->line[study->n];
        struct thud_fragility_ask ask = {&study->event[event], k, axis, {0}, study->samples, study->seed};
        memcpy(ask.at, at, sizeof at);
        *line = (struct thud_fragility_line){.event = event, .k = k, .axis = axis, .rate = {NAN, NAN, NAN}};
        memcpy(line->at, at, sizeof at);
        enum thud_status status = thud_fragility_make(study->suite, &ask, &line->fragility, err);
        if (status != THUD_OK)
            return status;
        study->n++;
        if (study->hazard.n > 0 && thud_axis_is_intensity(&plan->axis[axis]))
            line->rate = thud_hazard_rate(&study->hazard, &line->fragility);
    } while (next_setting(plan, axis, at));
    return THUD_OK;
}

enum thud_status thud_fragility_study_make(struct thud_fragility_study *study, struct thud_error *err)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    size_t most = count_lines(study);
    if (most == 0)
        return thud_error_refuse(err, THUD_USAGE, NULL,
                                 "--vary record.sa=0.1g:2g:0.1g, --vary gap=5cm:25cm:0.5cm, or both",
                                 "no number is varied that a fragility could be against");
    study->line = calloc(most, sizeof *study->line);
    if (!study->line)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int e = 0; e < study->nevents; e++)
        for (int a = 0; a < plan->naxes; a++)
            for (int k = 0; k < plan->ncases && is_drawn(&plan->axis[a]); k++) {
                enum thud_status status = is_asked(study, e, k) ? add_lines(study, e, a, k, err) : THUD_OK;
                if (status != THUD_OK)
                    return status;
            }
    return THUD_OK;
}

void thud_fragility_study_clear(struct thud_fragility_study *study)
{
    for (size_t i = 0; i < study->n; i++)
        thud_fragility_clear(&study->line[i].fragility);
    free(study->line);
    study->line = NULL;
    study->n = 0;
    thud_hazard_clear(&study->hazard);
}

/* ---- table ---- */

/* The other keys of a line: "gap 10 cm"; "-" where there are none. */
static void place(const struct thud_sweep_plan *plan, const struct thud_fragility_line *line, char *text, size_t size)
{
    size_t used = 0;
    snprintf(text, size, "-");
    for (int a = 0; a < plan->naxes && used < size; a++)
        if (a != line->axis)
            used +=
                (size_t)snprintf(text + used, size - used, "%s%s", used ? ", " : "", plan->axis[a].text[line->at[a]]);
}

/* Whether the i-th of n is one of at most five, evenly spread. */
static bool is_spread(int n, int i)
{
    enum { MOST = 5 };
    bool shown = n <= MOST;
    for (int j = 0; j < MOST && !shown; j++)
        shown = i == (j * (n - 1) + (MOST - 1) / 2) / (MOST - 1);
    return shown;
}

/* At most five settings of every curve's others are shown. */
static bool is_shown(const struct thud_sweep_plan *plan, const struct thud_fragility_line *line)
{
    for (int a = 0; a < plan->naxes; a++)
        if (a != line->axis && !is_spread(plan->axis[a].n, line->at[a]))
            return false;
    return true;
}

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
        if (is_spread((int)f->n, (int)i))
            thud_text_append(out, f->stripe[i].n == most ? " %d" : " %d/%d", f->stripe[i].count, f->stripe[i].n);
    thud_text_append(out, " of %d at", most);
    for (size_t i = 0; i < f->n; i++)
        if (is_spread((int)f->n, (int)i))
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
    double least = 100 * thud_hazard_probability(rate->low, years),
           most = 100 * thud_hazard_probability(rate->high, years);
    if (isnan(rate->low))
        return;
    if (!isnan(rate->value))
        thud_text_append(out, " %.2e %5.1f %%", rate->value, 100 * thud_hazard_probability(rate->value, years));
    else if (isinf(rate->high))
        thud_text_append(out, " from %.1e %.1f %%", rate->low, least);
    else if (rate->low > 0)
        thud_text_append(out, " %.1e-%.1e %.1f-%.1f %%", rate->low, rate->high, least, most);
    else
        thud_text_append(out, " up to %.1e %.1f %%", rate->high, most);
}

static void put_few(const struct thud_suite *suite, struct thud_text *out)
{
    int n = suite->ndraws;
    if (n < THUD_SHARES_LEAST)
        thud_text_append(
            out, "\n%d independent ground motion%s no likelihood: the counts are all there is, without bands.\n", n,
            n == 1 ? " gives" : "s give");
    else if (n < THUD_DRAWS_LEAST)
        thud_text_append(
            out, "\n%d independent ground motions are too few for a band of a curve: from %d on there is one.\n", n,
            THUD_DRAWS_LEAST);
}

void thud_fragility_table(const struct thud_fragility_study *study, struct thud_text *out)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    int event = -1, axis = -1;
    for (size_t i = 0; i < study->n; i++) {
        const struct thud_fragility_line *line = &study->line[i];
        const struct thud_sweep_axis *along = &plan->axis[line->axis];
        bool hazard = study->hazard.n > 0 && thud_axis_is_intensity(along);
        char at[64];
        if (!is_shown(plan, line))
            continue;
        if (line->event != event || line->axis != axis) {
            const char *unit = along->param->unit;
            thud_text_append(out, "%s%s against %s%s%s%s, %d ground motions\n", event >= 0 ? "\n" : "",
                             study->event[line->event].text, along->param->title, unit && *unit ? " (" : "",
                             unit ? unit : "", unit && *unit ? ")" : "", study->suite->nrecords);
            thud_text_append(out, "  %-7s %-10s %-28s %-*s%s\n", "case", "at", "50 % (90 % band)", hazard ? 8 : 10,
                             "dispersion", hazard ? " a year    in 50 y" : "");
        }
        event = line->event;
        axis = line->axis;
        place(plan, line, at, sizeof at);
        thud_text_append(out, "  %-7s %-10.10s ", thud_case_name(plan->cases[line->k]), at);
        put_median(line, unit_of(along), hazard, out);
        put_rate(&line->rate, out);
        while (out->size > 0 && out->data[out->size - 1] == ' ')
            out->data[--out->size] = '\0';
        thud_text_append(out, "\n");
    }
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
                      struct thud_axis_columns *axes)
{
    thud_axis_columns_put(plan, NULL, line->at, axes);
    axes->value[line->axis].number = own; /* a number: no other is drawn against */
}

void thud_fragility_csv(const struct thud_fragility_study *study, struct thud_text *out)
{
    struct thud_axis_columns axes;
    thud_axis_columns_make(study->suite->plan, NULL, &axes);
    struct thud_part part[] = {
        {&thud_curve_key_schema, 0, NULL}, {&axes.schema, 0, axes.value}, {&thud_stripe_schema, 0, NULL}};
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
            put_place(study->suite->plan, line, s->x, &axes);
            part[0].row = &key;
            part[2].row = &row;
            thud_parts_csv(part, 3, out);
        }
    }
}

/* ---- medians ---- */

enum { MEDIANS = 10 };
static const char *const medians[MEDIANS] = {
    "theta",     "theta_low",    "theta_high", "median_above",     "median_below",
    "exact_p16", "exact_median", "exact_p84",  "exact_median_low", "exact_median_high"};

/* The median in the columns of its unit: each unit along which there are curves has its own. Returns how many. */
static int median_units(const struct thud_fragility_study *study, const char *unit[THUD_VARY_MAX])
{
    int n = 0;
    for (int a = 0; a < study->suite->plan->naxes; a++) {
        const struct thud_sweep_axis *axis = &study->suite->plan->axis[a];
        bool there = !is_drawn(axis);
        for (int i = 0; i < n && !there; i++)
            there = strcmp(unit[i], thud_si_suffix(axis->param)) == 0;
        if (!there)
            unit[n++] = thud_si_suffix(axis->param);
    }
    return n;
}

/* NaN for what is not known, lies outside the values that were tried, or has no bound. */
static void median_values(const struct thud_fragility *f, double value[MEDIANS])
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
    memcpy(value, x, sizeof x);
}

static struct thud_curve_row curve_of(const struct thud_fragility_line *line)
{
    const struct thud_fragility *f = &line->fragility;
    const double rate[] = {line->rate.value, line->rate.low, isinf(line->rate.high) ? NAN : line->rate.high};
    bool told = !isnan(f->theta); /* a median far outside comes with any dispersion */
    struct thud_curve_row row = {.beta = told ? f->curve.beta : NAN,
                                 .beta_low = told ? f->beta_low : NAN,
                                 .beta_high = told ? f->beta_high : NAN,
                                 .falling = thud_is_fitted(&f->curve) ? f->curve.falling : THUD_NO_COUNT,
                                 .deviance_p = f->curve.p};
    for (int i = 0; i < 3; i++) {
        row.rate[i] = rate[i];
        row.rate[3 + i] = isnan(rate[i]) ? NAN : thud_hazard_probability(rate[i], years);
    }
    return row;
}

/* How a curve was fitted, and its medians in the columns of their units. */
struct median_columns {
    struct thud_schema schema;
    struct thud_column column[1 + MEDIANS * THUD_VARY_MAX];
    char name[MEDIANS * THUD_VARY_MAX][40];
    struct {
        const char *fit;
        double value[MEDIANS * THUD_VARY_MAX];
    } row;
};

static void name_medians(const char *const *unit, int units, struct median_columns *out)
{
    *out = (struct median_columns){.schema = {"", "", out->column, 1 + MEDIANS * units}};
    out->column[0] = (struct thud_column){.name = "fit", .kind = THUD_COLUMN_TEXT};
    for (int i = 0; i < MEDIANS * units; i++) {
        snprintf(out->name[i], sizeof out->name[i], "%s%s", medians[i % MEDIANS], unit[i / MEDIANS]);
        out->column[1 + i] = (struct thud_column){
            .name = out->name[i], .at = (size_t)((const char *)&out->row.value[i] - (const char *)&out->row)};
    }
}

void thud_fragility_curves_csv(const struct thud_fragility_study *study, struct thud_text *out)
{
    const char *unit[THUD_VARY_MAX];
    struct thud_axis_columns axes;
    struct median_columns median;
    int units = median_units(study, unit);
    thud_axis_columns_make(study->suite->plan, NULL, &axes);
    name_medians(unit, units, &median);
    struct thud_part part[] = {{&thud_curve_key_schema, 0, NULL},
                               {&axes.schema, 0, axes.value},
                               {&median.schema, 0, &median.row},
                               {&thud_curve_schema, 0, NULL}};
    thud_parts_names(part, 4, out);
    for (size_t i = 0; i < study->n; i++) {
        const struct thud_fragility_line *line = &study->line[i];
        const struct thud_curve_key key = key_of(study, line);
        const struct thud_curve_row row = curve_of(line);
        const char *own = thud_si_suffix(study->suite->plan->axis[line->axis].param);
        put_place(study->suite->plan, line, NAN, &axes);
        median.row.fit = thud_fit_name(line->fragility.curve.fit);
        for (int u = 0; u < units; u++) {
            double *value = &median.row.value[u * MEDIANS];
            median_values(&line->fragility, value);
            for (int j = 0; j < MEDIANS && strcmp(unit[u], own) != 0; j++)
                value[j] = NAN;
        }
        part[0].row = &key;
        part[3].row = &row;
        thud_parts_csv(part, 4, out);
    }
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
    struct median_columns median;
    name_medians(&unit, 1, &median);
    median.row.fit = thud_fit_name(f->curve.fit);
    median_values(f, median.row.value);
    thud_text_append(out, "}, \"falling\": %s, ",
                     !thud_is_fitted(&f->curve) ? "null"
                     : f->curve.falling         ? "true"
                                                : "false");
    const struct thud_part part[] = {{&median.schema, 0, &median.row}, {&thud_curve_schema, 0, &row}};
    thud_parts_json(part, 2, out);
    thud_text_append(out, ", \"stripes\": [");
    for (size_t j = 0; j < f->n; j++) {
        thud_text_append(out, "%s[", j ? ", " : "");
        thud_json_number(out, f->stripe[j].x);
        thud_text_append(out, ", %d, %d]", f->stripe[j].n, f->stripe[j].count);
    }
    thud_text_append(out, "]}");
}

void thud_fragility_json(const struct thud_fragility_study *study, struct thud_text *out)
{
    thud_text_append(out, "{");
    thud_json_head(out, study->suite->plan->scene.name);
    thud_text_append(out, ", \"motions\": %d, \"independent\": %d, \"curves\": [", study->suite->nrecords,
                     study->suite->ndraws);
    for (size_t i = 0; i < study->n; i++) {
        thud_text_append(out, i ? ",\n  " : "\n  ");
        put_json_line(study, &study->line[i], out);
    }
    thud_text_append(out, "\n]}\n");
}

/* ---- statistics over the ground motions ---- */

enum { SUITE_FIRST = THUD_SUITE_FORCE, SUITE_COLUMNS = 3 + 3 * (THUD_SUITE_MEASURES - SUITE_FIRST) };

/* Of storeys that yield and of columns only where there are any. */
static bool has_column(const struct thud_suite *suite, int column)
{
    return column < 3 || thud_suite_has(suite, (enum thud_suite_measure)(SUITE_FIRST + column / 3 - 1));
}

/* One setting, case and structure: how many motions, how many of them pound and are amplified, fractiles of every
 * measure. */
static void suite_values(const struct thud_suite *suite, long setting, int k, int s, double *room,
                         double value[SUITE_COLUMNS])
{
    struct thud_fractiles f = thud_suite_fractiles(suite, setting, k, THUD_SUITE_IMPACTS, -1, 0, room);
    value[0] = (double)f.n;
    value[1] = f.n ? round(f.share * (double)f.n) : 0;
    f = thud_suite_fractiles(suite, setting, k, THUD_SUITE_ACCELERATION_RATIO, s, 1 + 1e-9, room);
    value[2] = f.n ? round(f.share * (double)f.n) : 0;
    for (int m = SUITE_FIRST; m < THUD_SUITE_MEASURES; m++) {
        double *to = value + 3 + 3 * (m - SUITE_FIRST);
        f = thud_suite_fractiles(suite, setting, k, (enum thud_suite_measure)m, s, 0, room);
        to[0] = f.p16;
        to[1] = f.median;
        to[2] = f.p84;
    }
}

static void suite_column(int column, char name[48])
{
    static const char *const counts[] = {"motions", "pounding", "amplified"}, *const end[] = {"p16", "median", "p84"};
    if (column < 3)
        snprintf(name, 48, "%s", counts[column]);
    else
        snprintf(name, 48, "%s_%s", thud_suite_column((enum thud_suite_measure)(SUITE_FIRST + column / 3 - 1)),
                 end[column % 3]);
}

/* A row of statistics: case, varied keys, structure, and what there is of the measures. */
struct suite_columns {
    struct thud_axis_columns axes;
    struct thud_schema which, structure, values;
    struct thud_column column[SUITE_COLUMNS];
    char name[SUITE_COLUMNS][48];
};
static const struct thud_column text_column[] = {{.name = "case", .kind = THUD_COLUMN_TEXT},
                                                 {.name = "structure", .kind = THUD_COLUMN_TEXT}};

static void name_suite(const struct thud_suite *suite, struct suite_columns *out)
{
    *out = (struct suite_columns){.which = {"", "", text_column, 1},
                                  .structure = {"", "", text_column + 1, 1},
                                  .values = {"", "", out->column, 0}};
    thud_axis_columns_make(suite->plan, NULL, &out->axes);
    for (int c = 0; c < SUITE_COLUMNS; c++) {
        if (!has_column(suite, c))
            continue;
        suite_column(c, out->name[c]);
        out->column[out->values.n++] = (struct thud_column){.name = out->name[c], .at = (size_t)c * sizeof(double)};
    }
}

static void put_suite_data(const struct thud_suite *suite, const int *at, int k, int s,
                           const double value[SUITE_COLUMNS], bool json, struct thud_text *out)
{
    const char *which = k < 0 ? NULL : thud_case_name(suite->plan->cases[k]);
    const char *structure = k < 0 ? NULL : suite->plan->scene.structure[s].name;
    struct suite_columns columns;
    name_suite(suite, &columns);
    const struct thud_part part[] = {{&columns.which, 0, &which},
                                     {&columns.axes.schema, 0, columns.axes.value},
                                     {&columns.structure, 0, &structure},
                                     {&columns.values, 0, value}};
    if (k < 0) {
        thud_parts_names(part, 4, out);
        return;
    }
    thud_axis_columns_put(suite->plan, NULL, at, &columns.axes);
    if (!json) {
        thud_parts_csv(part, 4, out);
        return;
    }
    thud_text_append(out, "%s{", out->size > 0 ? ",\n  " : "");
    thud_parts_json(part, 4, out);
    thud_text_append(out, "}");
}

static void put_suite_csv_row(const struct thud_suite *suite, const int *at, int k, int s,
                              const double value[SUITE_COLUMNS], struct thud_text *out)
{
    put_suite_data(suite, at, k, s, value, false, out);
}

static void put_suite_json_row(const struct thud_suite *suite, const int *at, int k, int s,
                               const double value[SUITE_COLUMNS], struct thud_text *out)
{
    put_suite_data(suite, at, k, s, value, true, out);
}

/* At most five settings, evenly spread, are shown of a key. */
static bool is_shown_setting(const struct thud_sweep_plan *plan, const int *at)
{
    for (int a = 0; a < plan->naxes; a++)
        if (!is_spread(plan->axis[a].n, at[a]))
            return false;
    return true;
}

static void put_suite_table_row(const struct thud_suite *suite, const int *at, int k, int s,
                                const double value[SUITE_COLUMNS], struct thud_text *out)
{
    const struct thud_sweep_plan *plan = suite->plan;
    const double *ratio = value + 3 + 3 * (THUD_SUITE_ACCELERATION_RATIO - SUITE_FIRST);
    const double *force = value + 3 + 3 * (THUD_SUITE_FORCE - SUITE_FIRST);
    char name[160];
    size_t used = 0;
    if (!is_shown_setting(plan, at))
        return;
    snprintf(name, sizeof name, "%s", plan->naxes > 0 ? "" : "nominal");
    for (int a = 0; a < plan->naxes && used < sizeof name; a++)
        used += (size_t)snprintf(name + used, sizeof name - used, "%s%s", a ? ", " : "", plan->axis[a].text[at[a]]);
    thud_text_append(out, "  %-8s %-8.8s %4.0f %4.0f", thud_case_name(plan->cases[k]), plan->scene.structure[s].name,
                     value[1], value[2]);
    for (int q = 0; q < 3; q++)
        thud_text_append(out, isnan(ratio[q]) ? "      -" : " %6.3f", ratio[q]);
    for (int q = 1; q < 3; q++)
        thud_text_append(out, isnan(force[q]) ? "       -" : " %7.3g", 1e-6 * force[q]);
    thud_text_append(out, "  %-.17s\n", name);
}

typedef void put_suite_row(const struct thud_suite *suite, const int *at, int k, int s,
                           const double value[SUITE_COLUMNS], struct thud_text *out);

static enum thud_status put_suite(const struct thud_suite *suite, put_suite_row *put, struct thud_text *out,
                                  struct thud_error *err)
{
    const struct thud_sweep_plan *plan = suite->plan;
    double value[SUITE_COLUMNS], *room = malloc(((size_t)suite->nrecords + 1) * sizeof *room);
    int at[THUD_VARY_MAX];
    if (!room)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (long i = 0; i < suite->settings; i++) {
        thud_suite_place(plan, i, at);
        for (int k = 0; k < plan->ncases; k++)
            for (int s = 0; s < suite->nstructures; s++) {
                if (plan->scene.structure[s].kind == THUD_WALL)
                    continue;
                suite_values(suite, i, k, s, room, value);
                put(suite, at, k, s, value, out);
            }
    }
    free(room);
    return THUD_OK;
}

enum thud_status thud_suite_csv(const struct thud_suite *suite, struct thud_text *out, struct thud_error *err)
{
    put_suite_data(suite, NULL, -1, 0, NULL, false, out);
    return put_suite(suite, put_suite_csv_row, out, err);
}

enum thud_status thud_suite_json(const struct thud_suite *suite, struct thud_text *out, struct thud_error *err)
{
    struct thud_text rows = {0};
    enum thud_status status = put_suite(suite, put_suite_json_row, &rows, err);
    thud_text_append(out, "[\n  ");
    if (rows.data)
        thud_text_bytes(out, rows.data, rows.size);
    thud_text_append(out, "\n]");
    out->failed |= rows.failed;
    thud_text_clear(&rows);
    return status;
}

enum thud_status thud_suite_table(const struct thud_suite *suite, struct thud_text *out, struct thud_error *err)
{
    thud_text_append(out, "over %d ground motions: how many pound, and under how many accelerations grow\n",
                     suite->nrecords);
    thud_text_append(out, "                              mean acc. ratio      force (MN)\n"
                          "  case     of      pound grow   16 %% median   84 %%  median    84 %%  at\n");
    return put_suite(suite, put_suite_table_row, out, err);
}
