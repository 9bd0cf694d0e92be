#include "app/sweep/fragility_report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/version.h"
#include "io/file/file.h"
#include "io/file/json.h"

static const double years = 50;

bool thud_axis_is_intensity(const struct thud_sweep_axis *axis)
{
    static const char *const keys[] = {"record.peak", "record.sa", "record.factor"};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (strcmp(axis->key, keys[i]) == 0)
            return true;
    return false;
}

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

enum thud_status thud_hazard_read(const char *path, const struct thud_sweep_axis *axis, struct thud_hazard *out,
                                  struct thud_error *err)
{
    enum { BYTES_MAX = 16 << 20 };
    char *text, *line, *next;
    size_t size, room = 1;
    int number = 0;
    *out = (struct thud_hazard){0};
    enum thud_status status = thud_file_read(path, BYTES_MAX, &text, &size, err);
    if (status != THUD_OK)
        return status;
    for (line = text; *line; line++)
        room += *line == '\n';
    out->x = malloc(room * sizeof *out->x);
    out->rate = malloc(room * sizeof *out->rate);
    if (!out->x || !out->rate)
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    for (line = text; status == THUD_OK && line; line = next) {
        double x, rate;
        next = strchr(line, '\n');
        if (next)
            *next++ = '\0';
        number++;
        line[strcspn(line, "#")] = '\0';
        if (line[strspn(line, " \t\r")] == '\0')
            continue;
        if (!two_numbers(line, &x, &rate)) {
            if (out->n > 0)
                status = refuse(path, number, "is no line of two numbers", err);
            continue;
        }
        x *= unit_of(axis);
        if (!(x > 0 && rate > 0 && isfinite(x) && isfinite(rate)))
            status = refuse(path, number, "has a number that is not above 0", err);
        else if (out->n > 0 && !(x > out->x[out->n - 1] && rate <= out->rate[out->n - 1]))
            status = refuse(path, number, "does not go on: intensities rise, rates fall", err);
        out->x[out->n] = x;
        out->rate[out->n++] = rate;
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
        *line = (struct thud_fragility_line){.event = event, .k = k, .axis = axis, .rate = NAN};
        memcpy(line->at, at, sizeof at);
        enum thud_status status = thud_fragility_make(study->suite, &ask, &line->fragility, err);
        if (status != THUD_OK)
            return status;
        study->n++;
        if (study->hazard.n > 0 && thud_axis_is_intensity(&plan->axis[axis]))
            line->rate = thud_hazard_rate(&study->hazard, &line->fragility.curve);
    } while (next_setting(plan, axis, at));
    return THUD_OK;
}

enum thud_status thud_fragility_study_make(struct thud_fragility_study *study, struct thud_error *err)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    size_t most = count_lines(study);
    if (most == 0) {
        thud_error_set(err, THUD_USAGE, "no number is varied that a fragility could be against");
        thud_error_allow(err, "--vary record.sa=0.1g:2g:0.1g, --vary gap=5cm:25cm:0.5cm, or both");
        return THUD_USAGE;
    }
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

/* "0.52 (0.45 to 0.6)" */
static void put_band(double value, double low, double high, double unit, int width, struct thud_text *out)
{
    char text[80];
    if (isnan(low))
        snprintf(text, sizeof text, "%.3g", value / unit);
    else
        snprintf(text, sizeof text, "%.3g (%.3g to %.3g)", value / unit, low / unit, high / unit);
    thud_text_append(out, "%-*s", width, text);
}

static void put_shares(const struct thud_fragility_line *line, struct thud_text *out)
{
    const struct thud_fragility *f = &line->fragility;
    int motions = 0, count = 0;
    for (size_t i = 0; i < f->n; i++) {
        motions += f->stripe[i].n;
        count += f->stripe[i].count;
    }
    thud_text_append(out, count == 0 ? "never" : count == motions ? "always" : "no curve");
}

/* Whether the median is where it was looked for. */
static bool is_near(const struct thud_fragility *f)
{
    double least = INFINITY, most = 0;
    for (size_t i = 0; i < f->n; i++) {
        least = fmin(least, f->stripe[i].x);
        most = fmax(most, f->stripe[i].x);
    }
    return f->curve.theta >= least / 2 && f->curve.theta <= 2 * most;
}

void thud_fragility_table(const struct thud_fragility_study *study, struct thud_text *out)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    int event = -1, axis = -1;
    for (size_t i = 0; i < study->n; i++) {
        const struct thud_fragility_line *line = &study->line[i];
        const struct thud_fragility *f = &line->fragility;
        const struct thud_sweep_axis *along = &plan->axis[line->axis];
        char at[64];
        if (!is_shown(plan, line))
            continue;
        if (line->event != event || line->axis != axis) {
            const char *unit = along->param->unit;
            thud_text_append(out, "%s%s against %s%s%s%s, %d ground motions\n", event >= 0 ? "\n" : "",
                             study->event[line->event].text, along->param->title, unit && *unit ? " (" : "",
                             unit ? unit : "", unit && *unit ? ")" : "", study->suite->nrecords);
            thud_text_append(out, "  %-8s %-14s %-24s %-*s%s\n", "case", "at", "50 % (90 % band)",
                             study->hazard.n > 0 ? 11 : 20, "dispersion",
                             study->hazard.n > 0 ? "a year    in 50 y" : "");
        }
        event = line->event;
        axis = line->axis;
        place(plan, line, at, sizeof at);
        thud_text_append(out, "  %-8s %-14.14s ", thud_case_name(plan->cases[line->k]), at);
        if (!f->curve.fitted) {
            put_shares(line, out);
        } else if (!is_near(f)) {
            thud_text_append(out, "%-45s", "not within these values");
        } else {
            put_band(f->curve.theta, f->theta_low, f->theta_high, unit_of(along), 25, out);
            if (isnan(line->rate)) /* beside the rates there is no room for its band */
                put_band(f->curve.beta, f->beta_low, f->beta_high, 1, 20, out);
            else
                thud_text_append(out, "%-11.3g", f->curve.beta);
        }
        if (!isnan(line->rate))
            thud_text_append(out, " %.2e %5.1f %%", line->rate, 100 * thud_hazard_probability(line->rate, years));
        thud_text_append(out, "\n");
    }
}

/* ---- CSV and JSON ---- */

static void put_number(double value, struct thud_text *out)
{
    thud_text_append(out, ",");
    if (!isnan(value))
        thud_text_number(out, value);
}

/* Where a line is on every axis; `own`: the value on its own one, NaN for none. */
static void put_place(const struct thud_sweep_plan *plan, const struct thud_fragility_line *line, double own,
                      struct thud_text *out)
{
    for (int a = 0; a < plan->naxes; a++) {
        if (plan->axis[a].words) {
            thud_text_append(out, ",");
            thud_text_csv(out, plan->axis[a].text[line->at[a]]);
        } else {
            put_number(a == line->axis ? own : plan->axis[a].value[line->at[a]], out);
        }
    }
}

static void put_head(const struct thud_fragility_study *study, const char *rest, struct thud_text *out)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    thud_text_append(out, "event,case,against");
    for (int a = 0; a < plan->naxes; a++)
        thud_text_append(out, ",%s", plan->axis[a].key);
    thud_text_append(out, ",%s\n", rest);
}

static void put_line(const struct thud_fragility_study *study, const struct thud_fragility_line *line,
                     struct thud_text *out)
{
    thud_text_csv(out, study->event[line->event].text);
    thud_text_append(out, ",%s,%s", thud_case_name(study->suite->plan->cases[line->k]),
                     study->suite->plan->axis[line->axis].key);
}

void thud_fragility_csv(const struct thud_fragility_study *study, struct thud_text *out)
{
    put_head(study, "motions,count,probability,low,high", out);
    for (size_t i = 0; i < study->n; i++) {
        const struct thud_fragility_line *line = &study->line[i];
        const struct thud_fragility *f = &line->fragility;
        for (size_t j = 0; j < f->n; j++) {
            put_line(study, line, out);
            put_place(study->suite->plan, line, f->stripe[j].x, out);
            thud_text_append(out, ",%d,%d", f->stripe[j].n, f->stripe[j].count);
            put_number(thud_lognormal_at(&f->curve, f->stripe[j].x), out);
            put_number(f->low[j], out);
            put_number(f->high[j], out);
            thud_text_append(out, "\n");
        }
    }
}

void thud_fragility_curves_csv(const struct thud_fragility_study *study, struct thud_text *out)
{
    put_head(study, "theta,theta_low,theta_high,beta,beta_low,beta_high,falling,annual_rate,probability_50_years", out);
    for (size_t i = 0; i < study->n; i++) {
        const struct thud_fragility_line *line = &study->line[i];
        const struct thud_fragility *f = &line->fragility;
        bool fitted = f->curve.fitted;
        const double x[] = {fitted ? f->curve.theta : NAN, f->theta_low, f->theta_high,
                            fitted ? f->curve.beta : NAN,  f->beta_low,  f->beta_high};
        put_line(study, line, out);
        put_place(study->suite->plan, line, NAN, out);
        for (size_t j = 0; j < sizeof x / sizeof *x; j++)
            put_number(x[j], out);
        thud_text_append(out, ",%s", !fitted ? "" : f->curve.falling ? "1" : "0");
        put_number(line->rate, out);
        put_number(isnan(line->rate) ? NAN : thud_hazard_probability(line->rate, years), out);
        thud_text_append(out, "\n");
    }
}

static void put_json_array(const char *key, const double *value, size_t n, struct thud_text *out)
{
    thud_text_append(out, ", \"%s\": [", key);
    for (size_t i = 0; i < n; i++) {
        thud_text_append(out, i ? ", " : "");
        thud_json_number(out, value[i]);
    }
    thud_text_append(out, "]");
}

static void put_json_line(const struct thud_fragility_study *study, const struct thud_fragility_line *line,
                          struct thud_text *out)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    const struct thud_fragility *f = &line->fragility;
    const double none = NAN;
    thud_text_append(out, "{\"event\": ");
    thud_json_string(out, study->event[line->event].text);
    thud_text_append(out, ", \"case\": \"%s\", \"against\": ", thud_case_name(plan->cases[line->k]));
    thud_json_string(out, plan->axis[line->axis].key);
    thud_text_append(out, ", \"at\": {");
    for (int a = 0, any = 0; a < plan->naxes; a++) {
        if (a == line->axis)
            continue;
        thud_text_append(out, any++ ? ", " : "");
        thud_json_string(out, plan->axis[a].key);
        thud_text_append(out, ": ");
        thud_json_string(out, plan->axis[a].text[line->at[a]]);
    }
    thud_text_append(out, "}, \"falling\": %s, ", f->curve.fitted && f->curve.falling ? "true" : "false");
    thud_json_field(out, "theta", f->curve.fitted ? f->curve.theta : none);
    put_json_array("theta_band", (const double[]){f->theta_low, f->theta_high}, 2, out);
    thud_text_append(out, ", ");
    thud_json_field(out, "beta", f->curve.fitted ? f->curve.beta : none);
    put_json_array("beta_band", (const double[]){f->beta_low, f->beta_high}, 2, out);
    thud_text_append(out, ", ");
    thud_json_field(out, "annual_rate", line->rate);
    thud_text_append(out, ", ");
    thud_json_field(out, "probability_50_years", isnan(line->rate) ? none : thud_hazard_probability(line->rate, years));
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
    thud_text_append(out, "{\"preset\": ");
    thud_json_string(out, study->suite->plan->scene.name);
    thud_text_append(out, ", \"version\": \"%s\", \"motions\": %d, \"curves\": [", THUD_VERSION,
                     study->suite->nrecords);
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

static void put_suite_csv_row(const struct thud_suite *suite, const int *at, int k, int s,
                              const double value[SUITE_COLUMNS], struct thud_text *out)
{
    const struct thud_sweep_plan *plan = suite->plan;
    thud_text_append(out, "%s", thud_case_name(plan->cases[k]));
    for (int a = 0; a < plan->naxes; a++) {
        if (plan->axis[a].words) {
            thud_text_append(out, ",");
            thud_text_csv(out, plan->axis[a].text[at[a]]);
        } else {
            put_number(plan->axis[a].value[at[a]], out);
        }
    }
    thud_text_append(out, ",");
    thud_text_csv(out, plan->scene.structure[s].name);
    for (int c = 0; c < SUITE_COLUMNS; c++)
        if (has_column(suite, c))
            put_number(value[c], out);
    thud_text_append(out, "\n");
}

static void put_suite_json_row(const struct thud_suite *suite, const int *at, int k, int s,
                               const double value[SUITE_COLUMNS], struct thud_text *out)
{
    const struct thud_sweep_plan *plan = suite->plan;
    char name[48];
    thud_text_append(out, "%s{\"case\": \"%s\"", out->size > 0 ? ",\n  " : "", thud_case_name(plan->cases[k]));
    for (int a = 0; a < plan->naxes; a++) {
        thud_text_append(out, ", ");
        thud_json_string(out, plan->axis[a].key);
        thud_text_append(out, ": ");
        if (plan->axis[a].words)
            thud_json_string(out, plan->axis[a].text[at[a]]);
        else
            thud_json_number(out, plan->axis[a].value[at[a]]);
    }
    thud_text_append(out, ", \"structure\": ");
    thud_json_string(out, plan->scene.structure[s].name);
    for (int c = 0; c < SUITE_COLUMNS; c++) {
        if (!has_column(suite, c))
            continue;
        suite_column(c, name);
        thud_text_append(out, ", ");
        thud_json_field(out, name, value[c]);
    }
    thud_text_append(out, "}");
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
    char name[160] = "";
    size_t used = 0;
    if (!is_shown_setting(plan, at))
        return;
    for (int a = 0; a < plan->naxes && used < sizeof name; a++)
        used += (size_t)snprintf(name + used, sizeof name - used, "%s%s", a ? ", " : "", plan->axis[a].text[at[a]]);
    thud_text_append(out, "  %-8s %-8.8s %4.0f %4.0f %6.3f %6.3f %6.3f %7.3g %7.3g  %-.17s\n",
                     thud_case_name(plan->cases[k]), plan->scene.structure[s].name, value[1], value[2], ratio[0],
                     ratio[1], ratio[2], 1e-6 * force[1], 1e-6 * force[2], name);
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
    char name[48];
    thud_text_append(out, "case");
    for (int a = 0; a < suite->plan->naxes; a++)
        thud_text_append(out, ",%s", suite->plan->axis[a].key);
    thud_text_append(out, ",structure");
    for (int c = 0; c < SUITE_COLUMNS; c++) {
        if (!has_column(suite, c))
            continue;
        suite_column(c, name);
        thud_text_append(out, ",%s", name);
    }
    thud_text_append(out, "\n");
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
