#include "app/sweep/simplify_report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/run/result_table.h"
#include "app/run/timing.h"
#include "io/file/json.h"
#include "io/result/simplification_rows.h"

enum thud_status thud_simplify_search(const struct thud_scene *scene, const struct thud_record_list *records,
                                      const struct thud_simplify_ask *ask, const atomic_int *cancel,
                                      struct thud_simplify **out, struct thud_error *err)
{
    enum thud_status status = thud_simplify_create(scene, records->record, records->n, ask, out, err);
    for (bool done = false; status == THUD_OK && !done;) {
        double *seconds;
        const double start = thud_timing_processor_s();
        status = thud_simplify_advance(*out, &seconds, &done, err);
        if (seconds)
            *seconds = thud_timing_processor_s() - start;
        if (status == THUD_OK && cancel && *cancel)
            status = thud_error_set(err, THUD_CANCELLED, "stopped");
    }
    return status;
}

struct shown {
    char text[24];
};
static struct shown percent(double change)
{
    struct shown out;
    snprintf(out.text, sizeof out.text, change > 10 ? "more than 1000 %%" : "%.2g %%", 100 * change);
    return out;
}

void thud_simplify_sentence(const struct thud_simplify_found *f, struct thud_text *out)
{
    if (f->steps == 0) {
        thud_text_append(out, "this scene cannot be simplified within %s", percent(f->within).text);
        return;
    }
    for (int i = 0; i < f->steps; i++)
        thud_text_append(out, "%s%s", i > 0 ? ", " : "", f->one[f->step[i]].words);
    thud_text_append(out, ": error of %s at %.3g %% of the work; %d input values instead of %d",
                     percent(f->cheapest.change.all).text, 100 * f->cheapest.work, f->cheapest.inputs, f->full.inputs);
}

/* Whether a method keeps the accuracy with it, and does not with a larger step: these stand one after the other. */
static bool is_largest_step(const struct thud_simplify_found *f, const struct thud_simplification *one)
{
    if (one->group != THUD_SIMPLIFY_METHOD || !one->information || !thud_simplification_within(f, one))
        return false;
    const struct thud_simplification *larger = one == f->one ? NULL : one - 1;
    return !larger || larger->row != one->row || larger->at != one->at || !thud_simplification_within(f, larger);
}

/* The largest change of the rows of an input; NaN of one that an earlier row has too. */
static double change_of_input(const struct thud_simplify_found *f, int row)
{
    double most = 0;
    for (int i = 0; i < f->n; i++)
        if (strcmp(f->one[i].input, f->one[row].input) == 0) {
            if (i < row)
                return NAN;
            most = fmax(most, f->one[i].failed ? INFINITY : f->one[i].change.all);
        }
    return most;
}

void thud_simplify_remarks(const struct thud_simplify_found *f, const char *before, struct thud_text *out)
{
    static const double nothing = 0.01;
    enum { MISSES, DECIDES, NOTHING, METHODS, LISTS };
    static const char *const begins[LISTS] = {
        "Misses every impact: ", "Inputs that decide: ", "Inputs that change less than 1 %: ",
        "Methods within the limit, each at its largest step or tolerance: "};
    if (f->nmotions > 1) {
        thud_text_append(out, "%sFound for motion %d of %d, which governs.", before, f->governing + 1, f->nmotions);
        if (f->steps > 0)
            thud_text_append(out, " Error over all of them: median %s, largest %s.", percent(f->cheapest.median).text,
                             percent(f->cheapest.worst).text);
        thud_text_append(out, "\n");
    }
    if (f->moved > f->within)
        thud_text_append(
            out,
            "%sThis scene's peaks move by %s under 0.1 %% of input: %s holds for these inputs exactly, and "
            "no model reaches it for the real scene.\n",
            before, percent(f->moved).text, percent(f->within).text);
    if (f->untried > 0)
        thud_text_append(out, "%sNot tried within the limit of %d runs: %d simplifications.\n", before, f->runs,
                         f->untried);
    for (int list = 0; list < LISTS; list++) {
        int n = 0;
        for (int i = 0; i < f->n; i++) {
            const struct thud_simplification *one = &f->one[i];
            const double change = *one->input ? change_of_input(f, i) : NAN;
            const bool misses = !one->failed && one->row >= 0 && one->change.impacts == 0 && f->full.change.impacts > 0;
            const bool told[LISTS] = {misses, change > f->within, change < nothing, is_largest_step(f, one)};
            if (told[list])
                thud_text_append(out, "%s%s%s", n > 0 ? "" : before, n > 0 ? ", " : begins[list],
                                 list == DECIDES || list == NOTHING ? one->input : one->words);
            n += told[list];
        }
        thud_text_append(out, n > 0 ? ".\n" : "");
    }
}

void thud_simplify_report(const struct thud_simplify_found *f, struct thud_text *out)
{
    const struct thud_rows rows = thud_simplify_table_rows(f);
    struct thud_text said = {0};
    thud_text_append(&said, "Within %s: ", percent(f->within).text);
    thud_simplify_sentence(f, &said);
    thud_text_append(&said, ".\n");
    thud_simplify_remarks(f, "", &said);
    thud_table_lines(out, &said, 2);
    thud_text_append(out, "\n");
    thud_rows_table(&rows, out);
    thud_text_append(out, "\n%d runs; the full model: %d impacts, %d numbers\n", f->runs, f->full.change.impacts,
                     f->full.inputs);
}

void thud_simplify_json(const struct thud_simplify_found *f, const char *preset, struct thud_text *out)
{
    const struct thud_rows rows = thud_simplify_table_rows(f);
    const struct thud_simplification *best = &f->cheapest;
    thud_text_append(out, "{");
    thud_json_head(out, preset);
    thud_text_append(out, ", ");
    THUD_JSON_FIELDS(out, {"within", f->within}, {"moved", f->moved}, {"runs", f->runs});
    thud_json_list("simplifications", &rows, out);
    thud_text_append(out, ", \"cheapest\": {\"steps\": [");
    for (int i = 0; i < f->steps; i++) {
        thud_text_append(out, i > 0 ? ", " : "");
        thud_json_string(out, f->one[f->step[i]].words);
    }
    thud_text_append(out, "], ");
    THUD_JSON_FIELDS(out, {"change", best->change.all}, {"acceleration", best->change.acceleration},
                     {"drift", best->change.drift}, {"force", best->change.force}, {"gap", best->change.gap},
                     {"saving", 1 - best->work}, {"work", best->work}, {"inputs", best->inputs},
                     {"inputs_full", f->full.inputs});
    if (f->nmotions > 1) {
        thud_text_append(out, ", ");
        THUD_JSON_FIELDS(out, {"motions", f->nmotions}, {"governing", f->governing + 1}, {"median", best->median},
                         {"worst", best->worst});
    }
    thud_text_append(out, "}}\n");
}

void thud_simplify_comments(const struct thud_simplify_found *f, struct thud_text *out)
{
    thud_text_append(out, "# Written by `thud simplify`: the cheapest model within %s.\n# Simplifications:\n",
                     percent(f->within).text);
    for (int i = 0; i < f->steps; i++)
        thud_text_append(out, "#   %s: %s alone\n", f->one[f->step[i]].words,
                         percent(f->one[f->step[i]].change.all).text);
    thud_text_append(
        out, "%s# All together: error of %s (peaks over the largest of their group, required gap over itself).\n",
        f->steps == 0 ? "#   nothing\n" : "", percent(f->cheapest.change.all).text);
    thud_simplify_remarks(f, "# ", out);
}
