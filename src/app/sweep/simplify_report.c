#include "app/sweep/simplify_report.h"

#include <math.h>
#include <stdlib.h>

#include "app/run/timing.h"
#include "base/statistics.h"
#include "io/file/json.h"
#include "io/result/simplify_rows.h"
#include "study/scene/needed_gap.h"

static enum thud_status check_cancel(const atomic_int *cancel, struct thud_error *err)
{
    return cancel && *cancel ? thud_error_set(err, THUD_CANCELLED, "stopped") : THUD_OK;
}

/* How hard a ground motion is on the scene: its largest contact force, N; without one minus 1/m of its required gap. */
static enum thud_status severity(const struct thud_scene *scene, const struct thud_record *record, double *out,
                                 struct thud_error *err)
{
    struct thud_solution solution = {0};
    struct thud_needed_gap *gap = NULL;
    *out = -INFINITY;
    enum thud_status status = thud_scene_solve(scene, record, NULL, &solution, err);
    for (int c = 0; status == THUD_OK && c < thud_run_result(solution.run)->ncontacts; c++)
        *out = fmax(*out, thud_run_result(solution.run)->contact[c].force.value);
    thud_solution_clear(&solution);
    if (status == THUD_OK && !(*out > 0)) {
        status = thud_needed_gap_run(scene, record, &gap, err);
        const double widest =
            status == THUD_OK && gap->nlevels > 0 ? thud_needed_gap_widest(gap, 0, THUD_GAP_EXACT, NULL) : NAN;
        *out = widest > 0 ? -1 / widest : -INFINITY;
        free(gap);
    }
    return status;
}

static enum thud_status search(struct thud_simplify *simplify, const atomic_int *cancel, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (bool done = false; status == THUD_OK && !done;) {
        struct thud_simplification *timed;
        const double start = thud_timing_processor_s();
        status = thud_simplify_advance(simplify, &timed, &done, err);
        if (timed)
            timed->seconds = thud_timing_processor_s() - start;
        if (status == THUD_OK)
            status = check_cancel(cancel, err);
    }
    return status;
}

/* The cheapest on all ground motions, with as many of its steps as keep the accuracy on all. */
static enum thud_status try_all(struct thud_simplify *simplify, const struct thud_record_list *records,
                                const atomic_int *cancel, struct thud_simplify_suite *suite, struct thud_error *err)
{
    double *change = malloc((size_t)records->n * sizeof *change);
    enum thud_status status = change ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
    for (bool kept = false; status == THUD_OK && !kept;) {
        suite->worst = 0;
        for (int i = 0; status == THUD_OK && i < records->n; i++) {
            struct thud_simplify_change one;
            status = thud_simplify_try(simplify, records->record[i], &one, err);
            change[i] = one.all;
            suite->worst = fmax(suite->worst, one.all);
            if (status == THUD_OK)
                status = check_cancel(cancel, err);
        }
        kept = suite->worst <= thud_simplify_within(simplify) || thud_simplify_steps(simplify) == 0;
        if (!kept)
            thud_simplify_step_back(simplify);
    }
    if (status == THUD_OK)
        suite->median = thud_quantile(change, thud_sort_numbers(change, (size_t)records->n), 0.5, false);
    free(change);
    return status;
}

enum thud_status thud_simplify_search(const struct thud_scene *scene, const struct thud_record_list *records,
                                      const struct thud_simplify_ask *ask, const atomic_int *cancel,
                                      struct thud_simplify **out, struct thud_simplify_suite *suite,
                                      struct thud_error *err)
{
    struct thud_simplify_ask own = *ask;
    double hardest = -INFINITY, now;
    enum thud_status status = THUD_OK;
    *out = NULL;
    *suite = (struct thud_simplify_suite){.n = records->n > 1 ? records->n : 0};
    own.suite = suite->n > 0;
    for (int i = 0; status == THUD_OK && i < suite->n; i++) {
        status = severity(scene, records->record[i], &now, err);
        if (status == THUD_OK && now > hardest) {
            hardest = now;
            suite->governing = i;
        }
        if (status == THUD_OK)
            status = check_cancel(cancel, err);
    }
    const struct thud_record *record = records->n > 0 ? records->record[suite->governing] : NULL;
    if (status == THUD_OK)
        status = thud_simplify_create(scene, record, &own, out, err);
    if (status == THUD_OK)
        status = search(*out, cancel, err);
    return status == THUD_OK && suite->n > 0 ? try_all(*out, records, cancel, suite, err) : status;
}

static void put_change(double change, struct thud_text *out)
{
    if (change > 10)
        thud_text_append(out, "more than 1000 %%");
    else
        thud_text_append(out, "%.2g %%", 100 * change);
}

static void put_steps(const struct thud_simplify *s, const char *between, struct thud_text *out)
{
    for (int i = 0; i < thud_simplify_steps(s); i++)
        thud_text_append(out, "%s%s", i > 0 ? between : "", thud_simplify_at(s, thud_simplify_step(s, i))->words);
}

/* "3 modes of A, contact of A-B at the top level alone: 2.1 % off at 14 % of the work; 9 numbers to be known in place of
 * 31". */
static void put_sentence(const struct thud_simplify *s, struct thud_text *out)
{
    const struct thud_simplification *best = thud_simplify_cheapest(s);
    if (thud_simplify_steps(s) == 0) {
        thud_text_append(out, "this scene is at its least: nothing can be left out within ");
        put_change(thud_simplify_within(s), out);
        return;
    }
    put_steps(s, ", ", out);
    thud_text_append(out, ": ");
    put_change(best->change.all, out);
    thud_text_append(out, " off at %.3g %% of the work; %d numbers to be known in place of %d", 100 * best->work,
                     best->inputs, thud_simplify_full(s)->inputs);
}

/* What no model reaches. */
static void put_moved(const struct thud_simplify *s, const char *before, struct thud_text *out)
{
    if (!(thud_simplify_moved(s) > thud_simplify_within(s)))
        return;
    thud_text_append(out, "%sThis scene's peaks move by ", before);
    put_change(thud_simplify_moved(s), out);
    thud_text_append(out, " under 0.1 %% of input: ");
    put_change(thud_simplify_within(s), out);
    thud_text_append(out, " holds for these inputs exactly, and no model reaches it for the real scene.\n");
}

static void put_suite(const struct thud_simplify_suite *suite, const char *before, struct thud_text *out)
{
    if (suite->n == 0)
        return;
    thud_text_append(out, "%sFound on ground motion %d of %d, the hardest. On all of them: median ", before,
                     suite->governing + 1, suite->n);
    put_change(suite->median, out);
    thud_text_append(out, " off, worst ");
    put_change(suite->worst, out);
    thud_text_append(out, ".\n");
}

/* Those that change less than 1 % by themselves, and those that decide. */
static void put_lists(const struct thud_simplify *s, struct thud_text *out)
{
    static const double nothing = 0.01;
    for (int which = 0; which < 2; which++) {
        int n = 0;
        for (int i = 0; i < thud_simplify_count(s); i++) {
            const struct thud_simplification *one = thud_simplify_at(s, i);
            if (one->group == THUD_SIMPLIFY_METHOD ||
                (which == 0 ? !(one->change.all < nothing) || one->failed : thud_simplification_within(s, one)))
                continue;
            thud_text_append(out, "%s%s",
                             n++ > 0      ? ", "
                             : which == 0 ? "Changes less than 1 %: "
                                          : "Decides: without it more changes than is allowed: ",
                             one->words);
        }
        thud_text_append(out, n > 0 ? "\n" : "");
    }
}

void thud_simplify_report(const struct thud_simplify *s, const struct thud_simplify_suite *suite, struct thud_text *out)
{
    const struct thud_rows rows = thud_simplify_table_rows(s);
    thud_text_append(out, "Within ");
    put_change(thud_simplify_within(s), out);
    thud_text_append(out, ": ");
    put_sentence(s, out);
    thud_text_append(out, ".\n");
    put_suite(suite, "", out);
    put_moved(s, "", out);
    thud_text_append(out, "\n");
    thud_rows_table(&rows, out);
    thud_text_append(out, "\n");
    put_lists(s, out);
    thud_text_append(out, "%d runs; the full model: %d impacts, %d numbers\n", thud_simplify_runs(s),
                     thud_simplify_full(s)->change.impacts, thud_simplify_full(s)->inputs);
}

void thud_simplify_json(const struct thud_simplify *s, const struct thud_simplify_suite *suite, const char *preset,
                        struct thud_text *out)
{
    const struct thud_rows rows = thud_simplify_table_rows(s);
    const struct thud_simplification *best = thud_simplify_cheapest(s);
    thud_text_append(out, "{");
    thud_json_head(out, preset);
    thud_text_append(out, ", ");
    THUD_JSON_FIELDS(out, {"within", thud_simplify_within(s)}, {"moved", thud_simplify_moved(s)},
                     {"runs", thud_simplify_runs(s)});
    thud_json_list("simplifications", &rows, out);
    thud_text_append(out, ", \"cheapest\": {\"steps\": [");
    for (int i = 0; i < thud_simplify_steps(s); i++) {
        thud_text_append(out, i > 0 ? ", " : "");
        thud_json_string(out, thud_simplify_at(s, thud_simplify_step(s, i))->words);
    }
    thud_text_append(out, "], ");
    THUD_JSON_FIELDS(out, {"change", best->change.all}, {"acceleration", best->change.acceleration},
                     {"drift", best->change.drift}, {"force", best->change.force}, {"gap", best->change.gap},
                     {"work", best->work}, {"inputs", best->inputs}, {"inputs_full", thud_simplify_full(s)->inputs});
    if (suite->n > 0) {
        thud_text_append(out, ", ");
        THUD_JSON_FIELDS(out, {"motions", suite->n}, {"governing", suite->governing + 1}, {"median", suite->median},
                         {"worst", suite->worst});
    }
    thud_text_append(out, "}}\n");
}

void thud_simplify_comments(const struct thud_simplify *s, const struct thud_simplify_suite *suite,
                            struct thud_text *out)
{
    thud_text_append(out, "# Written by `thud simplify`: the cheapest model within ");
    put_change(thud_simplify_within(s), out);
    thud_text_append(out, ".\n# Left out:\n");
    for (int i = 0; i < thud_simplify_steps(s); i++) {
        const struct thud_simplification *one = thud_simplify_at(s, thud_simplify_step(s, i));
        thud_text_append(out, "#   %s: ", one->words);
        put_change(one->change.all, out);
        thud_text_append(out, " alone\n");
    }
    if (thud_simplify_steps(s) == 0)
        thud_text_append(out, "#   nothing\n");
    thud_text_append(out, "# All together: ");
    put_change(thud_simplify_cheapest(s)->change.all, out);
    thud_text_append(out, " off (peaks over the largest of their group, required gap over itself).\n");
    put_suite(suite, "# ", out);
    put_moved(s, "# ", out);
}
