#include "app/sweep/solve.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/result_table.h"
#include "app/sweep/sweep_jobs.h"
#include "io/file/json.h"
#include "io/result/study_rows.h"

enum { SCAN = 9, PARTS = 5 };     /* values of the scan; parts that a change is cut into in each round */
static const double fine = 1e-3;  /* of the range: where a change is known so well it is known */
static const double close = 1e-6; /* part of a value to which it is known where contact begins */

enum thud_status thud_criterion_parse(const char *text, struct thud_criterion *out, struct thud_error *err)
{
    char event[sizeof out->text];
    size_t n = strcspn(text, " <>");
    const char *rest = text + n + strspn(text + n, " ");
    *out = (struct thud_criterion){.happens = *rest == '>'};
    snprintf(out->text, sizeof out->text, "%s", text);
    if (*rest == '<' || *rest == '>') {
        rest += 1 + strspn(rest + 1, " =");
        snprintf(event, sizeof event, "%.*s:%s", (int)n, text, rest);
    } else if (n == 2 && strncmp(text, "no", 2) == 0) {
        snprintf(event, sizeof event, "%s", rest);
    } else {
        out->happens = true;
        snprintf(event, sizeof event, "%s", text);
    }
    if (strlen(text) < sizeof out->text && strchr(event, ':') == strrchr(event, ':') &&
        thud_event_parse(event, &out->event, NULL) == THUD_OK && out->event.measure != THUD_MEASURE_ACCELERATION_RATIO)
        return THUD_OK;
    struct thud_text allowed = {0};
    thud_events_list(THUD_FORM_CRITERION, &allowed);
    thud_text_append(&allowed, "; or > in place of <");
    thud_error_refuse(err, THUD_USAGE, NULL, allowed.data, "\"%.60s\" is not understood", text);
    thud_text_clear(&allowed);
    return THUD_USAGE;
}

static bool holds(const struct thud_solve *solve, const struct thud_tried_row *tried)
{
    return tried->motions > 0 && tried->held >= solve->share * tried->motions - 1e-9;
}

static void put(struct thud_solve *solve, const struct thud_tried_row *tried)
{
    int at = solve->n;
    while (at > 0 && solve->tried[at - 1].x > tried->x)
        at--;
    memmove(&solve->tried[at + 1], &solve->tried[at], (size_t)(solve->n - at) * sizeof *tried);
    solve->tried[at] = *tried;
    solve->n++;
}

/* The value at which contact begins (along a gap: ends) under enough motions to change the answer; NaN: not known. */
static double contact_change(const struct thud_solve *solve, const struct thud_sweep_axis *axis,
                             const struct thud_fragility *counts)
{
    const int n = counts->nexact, need = (int)ceil(solve->share * n - 1e-9);
    if (n == 0)
        return NAN;
    return counts->exact[solve->criterion.happens == thud_axis_is_intensity(axis) ? need - 1 : n - need];
}

/* "KEY=V1,V2,...": n values between two, without them where `inner`. */
static void write_axis(const char *key, const char *unit, double from, double to, int parts, bool inner,
                       struct thud_text *out)
{
    char value[48];
    const double most = fmax(fabs(from), fabs(to)), step = (to - from) / parts;
    const int digits = (int)fmin(17, fmax(6, ceil(log10(most / step)) + 1)); /* so many that no two are alike */
    thud_text_append(out, "%s=", key);
    for (int i = inner; i <= parts - inner; i++) {
        const char *rest = value;
        double number = 0;
        thud_quantity_format(from + (to - from) * i / parts, unit, value, sizeof value);
        thud_number_parse(value, &rest, &number);
        thud_text_append(out, "%s%.*g%s", i > inner ? "," : "", digits, number, rest);
    }
}

struct search {
    struct thud_solve *solve;
    const struct thud_scene *scene;
    const struct thud_record_list *records;
    const char *unit;
    const atomic_int *cancel;
};

/* Runs the values that write_axis writes, and puts them among those tried. `contact`, unless NULL: where it begins. */
static enum thud_status run_values(const struct search *search, double from, double to, int parts, bool inner,
                                   double *contact, struct thud_error *err)
{
    struct thud_solve *solve = search->solve;
    const struct thud_record_list *records = search->records;
    struct thud_sweep_plan plan;
    struct thud_suite *suite = NULL;
    struct thud_fragility counts = {0};
    struct thud_fragility_ask ask = {.event = &solve->criterion.event, .first_contact = contact};
    struct thud_text axis = {0};
    thud_sweep_plan_init(&plan, search->scene);
    plan.nrecords = records ? records->n : 0;
    plan.record = plan.nrecords ? (const struct thud_record *const *)records->record : NULL;
    write_axis(solve->key, search->unit, from, to, parts, inner, &axis);
    enum thud_status status =
        axis.failed ? thud_error_set(err, THUD_MEMORY, "out of memory") : thud_sweep_vary(&plan, axis.data, err);
    if (status == THUD_OK)
        status = thud_sweep_suite_run(&plan, 0, search->cancel, &suite, err);
    if (status == THUD_OK)
        status = thud_fragility_make(suite, &ask, &counts, err);
    for (int i = 0; status == THUD_OK && i < plan.axis[0].n && solve->n < THUD_SOLVE_TRIES_MAX; i++) {
        const struct thud_stripe *s = &counts.stripe[i];
        struct thud_tried_row tried = {.x = s->x, .motions = s->n};
        tried.held = solve->criterion.happens ? s->count : s->n - s->count;
        snprintf(tried.value, sizeof tried.value, "%.40s", plan.axis[0].text[i]);
        put(solve, &tried);
    }
    if (status == THUD_OK && contact)
        *contact = contact_change(solve, &plan.axis[0], &counts);
    thud_fragility_clear(&counts);
    thud_suite_free(suite);
    thud_sweep_plan_clear(&plan);
    thud_text_clear(&axis);
    return status;
}

/* Where a value is not possible (a bumper thicker than the gap) nothing changes. */
static void find_changes(struct thud_solve *solve)
{
    solve->changes = 0;
    for (int i = 0; i + 1 < solve->n; i++)
        if (solve->tried[i].motions > 0 && solve->tried[i + 1].motions > 0 &&
            holds(solve, &solve->tried[i]) != holds(solve, &solve->tried[i + 1]) &&
            solve->changes < THUD_SOLVE_CHANGES_MAX)
            solve->change[solve->changes++] = i;
}

/* KEY=FROM:TO */
static enum thud_status read_by(const struct thud_scene *scene, const char *by, struct thud_solve *solve,
                                const struct thud_param **param, double range[2], struct thud_error *err)
{
    int floor;
    size_t n = strcspn(by, "=");
    char from[48];
    const char *value = by + n + (by[n] == '='), *colon = strchr(value, ':');
    struct thud_quantity low = {.value = NAN}, high = {.value = NAN};
    snprintf(solve->key, sizeof solve->key, "%.*s", (int)n, by);
    *param = n < sizeof solve->key ? thud_scene_param(scene, solve->key, &floor) : NULL;
    bool number = *param && (*param)->kind == THUD_PARAM_QUANTITY && colon && colon - value < (long)sizeof from;
    if (number) {
        snprintf(from, sizeof from, "%.*s", (int)(colon - value), value);
        number = thud_quantity_parse(from, (*param)->dimension, (*param)->unit, &low, NULL) == THUD_OK &&
                 thud_quantity_parse(colon + 1, (*param)->dimension, (*param)->unit, &high, NULL) == THUD_OK;
    }
    range[0] = low.value;
    range[1] = high.value;
    if (number && high.value > low.value)
        return THUD_OK;
    return thud_error_refuse(err, THUD_USAGE, NULL, "KEY=FROM:TO, rising, e.g. gap=2cm:20cm",
                             "\"%.80s\" is not a range of a quantity", by);
}

enum thud_status thud_solve_run(const struct thud_scene *scene, const struct thud_record_list *records, const char *by,
                                const struct thud_criterion *criterion, double share, const atomic_int *cancel,
                                struct thud_solve *out, struct thud_error *err)
{
    const struct thud_param *param;
    double range[2];
    *out = (struct thud_solve){.criterion = *criterion, .share = share, .nrecords = records ? records->n : 0};
    enum thud_status status = read_by(scene, by, out, &param, range, err);
    const char *unit = status == THUD_OK && param->unit ? param->unit : "";
    const struct search search = {out, scene, records, unit, cancel};
    double contact = NAN;
    if (status == THUD_OK)
        status = run_values(&search, range[0], range[1], SCAN - 1, false, &contact, err);
    const double below = contact * (1 - close), above = contact * (1 + close);
    if (status == THUD_OK && below > range[0] && above < range[1])
        status = run_values(&search, below, above, 1, false, NULL, err);
    for (bool more = true; status == THUD_OK && more;) {
        more = false;
        find_changes(out);
        for (int i = out->changes - 1; status == THUD_OK && i >= 0; i--) { /* the last first: those before stay */
            double from = out->tried[out->change[i]].x, to = out->tried[out->change[i] + 1].x;
            if (to - from <= fine * (range[1] - range[0]) || out->n + PARTS > THUD_SOLVE_TRIES_MAX)
                continue;
            status = run_values(&search, from, to, PARTS, true, NULL, err);
            more = true;
        }
    }
    return status;
}

const struct thud_tried_row *thud_solve_answer(const struct thud_solve *solve)
{
    if (solve->changes != 1)
        return NULL;
    const struct thud_tried_row *below = &solve->tried[solve->change[0]];
    return holds(solve, below) ? below : below + 1;
}

void thud_solve_words(const struct thud_solve *solve, struct thud_text *out)
{
    const struct thud_tried_row *answer = thud_solve_answer(solve), *first = solve->tried,
                                *last = &solve->tried[solve->n - 1];
    const char *text = solve->criterion.text;
    while (first < last && first->motions == 0)
        first++;
    while (last > first && last->motions == 0)
        last--;
    if (first->motions == 0)
        thud_text_append(out, "no value of %s from %s to %s is possible", solve->key, solve->tried[0].value,
                         solve->tried[solve->n - 1].value);
    else if (solve->changes == 0)
        thud_text_append(out, "%s holds at %s value of %s tried from %s to %s", text,
                         holds(solve, last) ? "every" : "no", solve->key, first->value, last->value);
    else if (answer) {
        bool below = answer == &solve->tried[solve->change[0]];
        thud_text_append(out, "%s holds %s %s = %s (not at %s)", text, below ? "up to" : "from", solve->key,
                         answer->value, below ? answer[1].value : answer[-1].value);
    } else
        thud_text_append(out, "%s is not monotone in %s: it changes %d times or more from %s to %s", text, solve->key,
                         solve->changes, first->value, last->value);
    if (solve->nrecords > 1)
        thud_text_append(out, ", under %g %% of %d ground motion%s", 100 * solve->share, solve->nrecords,
                         solve->nrecords == 1 ? "" : "s");
    if (first->motions > 0 && first > solve->tried)
        thud_text_append(out, "; %s and less is not possible", first[-1].value);
    if (first->motions > 0 && last < &solve->tried[solve->n - 1])
        thud_text_append(out, "; %s and more is not possible", last[1].value);
    thud_text_append(out, "\n");
    for (int i = 0; !answer && i < solve->changes; i++) {
        const struct thud_tried_row *below = &solve->tried[solve->change[i]];
        thud_text_append(out, "  %s at %s, %s at %s\n", holds(solve, below) ? "holds" : "does not", below->value,
                         holds(solve, below) ? "does not" : "holds", below[1].value);
    }
}

void thud_solve_report(const struct thud_solve *solve, struct thud_text *out)
{
    struct thud_text said = {0};
    thud_solve_words(solve, &said);
    thud_table_lines(out, &said, 2);
    thud_text_append(out, "\n%-20s  %s\n", solve->key, "holds under");
    for (int i = 0; i < solve->n; i++) {
        const struct thud_tried_row *t = &solve->tried[i];
        if (t->motions == 0)
            thud_text_append(out, "%-20s  not possible\n", t->value);
        else
            thud_text_append(out, "%-20s  %d of %d%s\n", t->value, t->held, t->motions, holds(solve, t) ? "" : "  no");
    }
    thud_text_append(out, "\nOnly these values were tried. Where two in a row agree, the criterion may still\n"
                          "change twice between them. A smaller range of --by tries more values there.\n");
}

static struct thud_rows tried_of(const struct thud_solve *solve, struct thud_array *all)
{
    *all = (struct thud_array){solve->tried, sizeof *solve->tried};
    return (struct thud_rows){&thud_tried_schema, 0, solve->n, thud_array_row, all};
}

void thud_solve_csv(const struct thud_solve *solve, struct thud_text *out)
{
    struct thud_array all;
    const struct thud_rows rows = tried_of(solve, &all);
    thud_rows_csv(&rows, out);
}

void thud_solve_json(const struct thud_solve *solve, struct thud_text *out)
{
    const struct thud_tried_row *answer = thud_solve_answer(solve);
    struct thud_array all;
    const struct thud_rows rows = tried_of(solve, &all);
    thud_text_append(out, "{");
    thud_json_head(out, NULL);
    thud_text_append(out, ", \"for\": ");
    thud_json_string(out, solve->criterion.text);
    thud_text_append(out, ", \"key\": ");
    thud_json_string(out, solve->key);
    thud_text_append(out, ", ");
    thud_json_field(out, "share", solve->share);
    thud_text_append(out, ", \"changes\": %d, \"answer\": ", solve->changes);
    if (answer)
        thud_json_string(out, answer->value);
    else
        thud_text_append(out, "null");
    thud_json_list("tried", &rows, out);
    thud_text_append(out, "}\n");
}
