/* The curves of a study, and the hazard that they are combined with. */
#include "app/sweep/fragility_report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/file/file.h"

/* ---- hazard ---- */

static enum thud_status refuse(const char *path, int line, const char *what, struct thud_error *err)
{
    thud_error_in(err, THUD_INPUT, path, line, "%s", what);
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
    thud_error_in(err, THUD_INPUT, path, line,
                  said > 0 ? "its intensity has a unit of another kind than %s"
                           : "the unit of its intensity is not specified (%s)",
                  axis->key);
    thud_error_allow(err, axis->param->dimension == THUD_ACCELERATION
                              ? "a first line such as sa_g,annual_rate or sa (cm/s2),annual_rate; g, m/s2, cm/s2, gal"
                              : "a number without unit: factor,annual_rate");
    return THUD_INPUT;
}

/* The period and damping that a first line names, `sa_g T=0.49s 5%`: those of the study, where that has a period. */
static enum thud_status check_period(const char *path, int line, const char *head, const struct thud_sweep_axis *axis,
                                     struct thud_hazard *out, struct thud_error *err)
{
    static const double close = 0.01, damping = 5;
    const char *period = strstr(head, "T="), *percent = strchr(head, '%'), *end;
    double said = 0;
    if (strcmp(axis->key, "record.sa") != 0)
        return THUD_OK;
    if (period && (thud_number_parse(period + 2, &end, &said) != 0 || end[strspn(end, " ")] != 's' || !(said > 0)))
        return refuse(path, line, "has a period that is no time, such as T=0.49s", err);
    out->period_s = said;
    while (percent && percent > head && strchr("0123456789. ", percent[-1]))
        percent--;
    if (percent && (thud_number_parse(percent + strspn(percent, " "), &end, &said) != 0 || said != damping)) {
        thud_error_in(err, THUD_INPUT, path, line, "its damping is not that of the study");
        thud_error_allow(err, "5 %%");
        return THUD_INPUT;
    }
    if (out->period_s > 0 && fabs(out->period_s - axis->period_s) > close * axis->period_s) {
        thud_error_in(err, THUD_INPUT, path, line, "its period, %.4g s, is not that of the study, %.4g s",
                      out->period_s, axis->period_s);
        thud_error_allow(err, "a hazard curve of that period, or --period %.4gs", out->period_s);
        return THUD_INPUT;
    }
    return THUD_OK;
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
        if (status == THUD_OK && first)
            status = check_period(path, number, numbers ? "" : line, axis, out, err);
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

/* The event `worse` compares a case with the scene without bumpers and links: it must have some. */
static bool is_asked(const struct thud_fragility_study *study, int event, int k)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    return study->event[event].measure != THUD_MEASURE_ACCELERATION_RATIO ||
           (plan->cases[k] != THUD_CASE_NONE && thud_scene_has_measure(&plan->scene));
}

/* Settings of the other axes. */
static long others(const struct thud_fragility_study *study, int axis)
{
    const struct thud_sweep_axis *own = &study->suite->plan->axis[axis];
    return thud_axis_is_drawn(own) ? study->suite->settings / own->n : 0;
}

/* An event of a case along an axis, at every setting of the others. */
static enum thud_status add_lines(struct thud_fragility_study *study, int event, int axis, int k,
                                  struct thud_error *err)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    const bool rates = study->hazard.n > 0 && thud_axis_is_intensity(&plan->axis[axis]) &&
                       study->suite->ndraws >= THUD_SHARES_LEAST; /* of fewer motions the counts are all there is */
    enum thud_status status = THUD_OK;
    for (long setting = 0; setting < study->suite->settings && status == THUD_OK; setting++) {
        struct thud_fragility_line *line = &study->line[study->n];
        struct thud_fragility_ask ask = {.event = &study->event[event],
                                         .k = k,
                                         .axis = axis,
                                         .samples = study->samples,
                                         .seed = study->seed,
                                         .hazard = study->hazard.n > 0 ? &study->hazard : NULL,
                                         .first_contact = true};
        thud_sweep_place(plan, setting, ask.at);
        if (ask.at[axis] > 0)
            continue;
        *line = (struct thud_fragility_line){.event = event, .k = k, .axis = axis, .rate = {NAN, NAN, NAN, NAN, NAN}};
        memcpy(line->at, ask.at, sizeof line->at);
        status = thud_fragility_make(study->suite, &ask, &line->fragility, err);
        study->n += status == THUD_OK;
        if (status == THUD_OK && rates)
            line->rate = thud_hazard_rate(&study->hazard, &line->fragility);
    }
    return status;
}

static bool has_result(const struct thud_suite *suite)
{
    for (int r = 0; r < suite->nrecords; r++)
        for (long i = 0; i < suite->settings; i++)
            for (int k = 0; k < suite->plan->ncases; k++)
                if (!isnan(thud_suite_value(suite, r, i, k, THUD_MEASURE_IMPACTS, -1)))
                    return true;
    return false;
}

static enum thud_status refuse_event(const struct thud_event *event, struct thud_error *err)
{
    return thud_error_refuse(err, THUD_USAGE, NULL, "events of which these scenes have a value",
                             "--event %s: no run of this study has a value for it: %s", event->text,
                             thud_measure_info(event->measure)->words);
}

enum thud_status thud_fragility_check(const struct thud_fragility_study *study, const struct thud_sweep_plan *plan,
                                      struct thud_error *err)
{
    const unsigned features = THUD_HAS_REFERENCE | plan->has;
    for (int e = 0; e < study->nevents; e++)
        if (thud_measure_info(study->event[e].measure)->needs & ~features)
            return refuse_event(&study->event[e], err);
    return THUD_OK;
}

/* An event for which no run has a value, such as columns that no slab strikes, has no probability. */
static enum thud_status check_events(const struct thud_fragility_study *study, struct thud_error *err)
{
    for (int e = 0; e < study->nevents; e++) {
        int runs = 0, asked = 0;
        for (size_t i = 0; i < study->n; i++)
            for (size_t j = 0; study->line[i].event == e && j < study->line[i].fragility.n; j++, asked++)
                runs += study->line[i].fragility.stripe[j].n;
        if (asked > 0 && runs == 0)
            return refuse_event(&study->event[e], err);
    }
    return THUD_OK;
}

enum thud_status thud_fragility_study_make(struct thud_fragility_study *study, struct thud_error *err)
{
    const struct thud_sweep_plan *plan = study->suite->plan;
    long most = 0;
    for (int a = 0; a < plan->naxes; a++)
        most += others(study, a) * plan->ncases * study->nevents;
    if (most == 0)
        return thud_error_refuse(err, THUD_USAGE, NULL,
                                 "--vary record.sa=0.1g:2g:0.1g, --vary gap=5cm:25cm:0.5cm, or both",
                                 "no number is varied that a fragility could be against");
    study->line = calloc((size_t)most, sizeof *study->line);
    if (!study->line)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = THUD_OK;
    for (int e = 0; e < study->nevents; e++)
        for (int a = 0; a < plan->naxes; a++)
            for (int k = 0; k < plan->ncases && others(study, a) > 0 && status == THUD_OK; k++)
                if (is_asked(study, e, k))
                    status = add_lines(study, e, a, k, err);
    if (status == THUD_OK && study->n == 0)
        return thud_error_refuse(err, THUD_USAGE, "--event", "a case with a bumper or a link",
                                 "\"worse\" compares with the scene without bumpers and links: no case here has any");
    return status == THUD_OK && has_result(study->suite) ? check_events(study, err) : status;
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
