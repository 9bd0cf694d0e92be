#include "io/result/bench_rows.h"

#include <math.h>

/* ---- speed against accuracy ---- */

struct bench_row {
    const char *method, *state;
    int located;
    struct thud_bench_point own;
};
#define BENCH(member, name, text) THUD_FIELD(struct bench_row, member, name, text)
#define ERROR(member, name, text) BENCH(own.error.member, name, text)
static const struct thud_column bench_columns[] = {
    BENCH(method, "method", "Name of the method."),
    BENCH(located, "located", "1 if events are located."),
    BENCH(own.how.setting, "setting", "Step in s, or tolerance."),
    BENCH(state, "state", "State of the run: done, failed, skipped or not-run."),
    BENCH(own.seconds, "seconds", "Wall time, s."),
    BENCH(own.spread, "spread_s", "Spread of the wall time, s; no value for one timing."),
    BENCH(own.repeats, "repeats", "Number of repetitions."),
    ERROR(all, "error", "Largest relative error."),
    ERROR(acceleration, "error_acceleration", "Relative error of the peak accelerations."),
    ERROR(drift, "error_drift", "Relative error of the drifts."),
    ERROR(force, "error_force", "Relative error of the forces."),
    ERROR(impact_time_s, "impact_time_s", "Largest error of an impact time, s."),
    ERROR(missed, "missed", "Number of impacts missed."),
    ERROR(extra, "extra", "Number of spurious impacts."),
    BENCH(own.work.steps, "steps", "Number of steps."),
    BENCH(own.work.force_evaluations, "force_evaluations", "Number of evaluations of contact forces."),
    BENCH(own.work.events, "events", "Number of events."),
    BENCH(own.processor_s, "processor_s", "Processor time, s.")};
const struct thud_schema thud_bench_schema = THUD_SCHEMA(
    "bench.csv",
    "Written by\n.Cm bench Fl o :\na row for each method and setting; with\n.Fl -json\nthe list\n.Va rows .\n",
    bench_columns);

static const char *const states[] = {[THUD_BENCH_WAITING] = "not-run",
                                     [THUD_BENCH_DONE] = "done",
                                     [THUD_BENCH_FAILED] = "failed",
                                     [THUD_BENCH_SKIPPED] = "skipped"};

static void make_bench(const void *of, int i, void *out)
{
    const struct thud_bench_point *p = (const struct thud_bench_point *)of + i;
    struct bench_row *row = out;
    *row = (struct bench_row){p->how.method->name, states[p->state], p->how.locate, *p};
    if (!(p->processor_s > 0))
        row->own.processor_s = NAN;
    if (p->repeats <= 1)
        row->own.spread = NAN;
    if (p->state == THUD_BENCH_DONE)
        return;
    struct thud_bench_errors *e = &row->own.error;
    row->own.seconds = row->own.spread = row->own.processor_s = NAN;
    e->all = e->acceleration = e->drift = e->force = e->impact_time_s = NAN;
    row->own.repeats = 0;
}

struct thud_rows thud_bench_rows(struct thud_bench *bench)
{
    return (struct thud_rows){&thud_bench_schema, 0, bench->npoints, make_bench, bench->point};
}

struct cost_of_level {
    const char *method;
    int located;
    struct thud_bench_point own;
    struct thud_bench_cost cost;
};
#define LEVEL(member, name, text) THUD_FIELD(struct cost_of_level, member, name, text)
static const struct thud_column level_columns[] = {
    LEVEL(cost.level, "level", "Largest relative error allowed."),
    LEVEL(method, "method", "Name of a method that meets this level."),
    LEVEL(located, "located", "1 if events are located."),
    LEVEL(own.how.setting, "setting", "Step in s, or tolerance, of the fastest run of the method."),
    LEVEL(own.error.all, "error", "Largest relative error of that run."),
    LEVEL(own.seconds, "seconds", "Wall time of that run, s."),
    LEVEL(own.work.steps, "steps", "Number of steps of that run."),
    LEVEL(cost.ratio, "ratio", "Ratio of its wall time to the shortest.")};
const struct thud_schema thud_bench_cost_schema =
    THUD_SCHEMA("bench of each accuracy",
                "With\n.Cm bench Fl -json\nthe list\n.Va costs :\na row for each accuracy and each method that keeps "
                "it, the quickest first;\n.Va moved\nis the largest relative change of a peak under 0.1 % of input.\n",
                level_columns);

static void make_level(const void *of, int i, void *out)
{
    const struct thud_bench *bench = of;
    struct thud_bench_cost cost[THUD_BENCH_CURVES_MAX];
    for (int k = 0; k < THUD_BENCH_LEVELS; k++) {
        const int n = thud_bench_costs(bench, thud_bench_level[k], cost);
        if (i < n) {
            const struct thud_bench_point *p = &bench->point[cost[i].point];
            *(struct cost_of_level *)out = (struct cost_of_level){p->how.method->name, p->how.locate, *p, cost[i]};
            return;
        }
        i -= n;
    }
}

struct thud_rows thud_bench_cost_rows(const struct thud_bench *bench)
{
    struct thud_bench_cost cost[THUD_BENCH_CURVES_MAX];
    int n = 0;
    for (int k = 0; k < THUD_BENCH_LEVELS; k++)
        n += thud_bench_costs(bench, thud_bench_level[k], cost);
    return (struct thud_rows){&thud_bench_cost_schema, 0, n, make_level, bench};
}

/* ---- where methods fail ---- */

struct cell_row {
    const char *method, *verdict[THUD_STABILITY_KINDS];
    int located;
    double limit;
    struct thud_stability_cell own;
};
#define CELL(member, name, text) THUD_FIELD_WITH(struct cell_row, member, name, text, .infinite = true)
static const struct thud_column verdict_columns[] = {
    CELL(method, "method", "Name of the method."),
    CELL(located, "located", "1 if events are located."),
    CELL(own.omega_dt, "omega_dt",
         "Step times the frequency of the oscillator, the wall spring or the fastest mode of the scene; empty: "
         "adaptive steps."),
    CELL(limit, "limit", "Stability limit from the literature; inf, in JSON null: none."),
    CELL(verdict[THUD_STABILITY_FREE], "free", "Verdict on free vibration: bounded, growing or blown up."),
    CELL(own.growth[THUD_STABILITY_FREE], "free_growth",
         "Largest energy in the second half of 50 s over that in the first; growing from 1.21, blown up from 1e4."),
    CELL(verdict[THUD_STABILITY_WALL], "wall", "Verdict on a mass that bounces on a wall spring."),
    CELL(own.growth[THUD_STABILITY_WALL], "wall_growth",
         "Largest energy within 50 s over the initial energy, for the worst start; growing from 1.21, blown up from "
         "1e4."),
    CELL(verdict[THUD_STABILITY_SCENE], "scene", "Verdict on the preset's scene."),
    CELL(own.growth[THUD_STABILITY_SCENE], "scene_growth",
         "Largest displacement over the exact one, for the worst floor and step (of three, up to 6 % shorter); "
         "growing from 2, blown up from 100.")};
const struct thud_schema thud_verdict_schema =
    THUD_SCHEMA("verdicts.csv", "Written by\n.Cm stability Fl o :\na row for each method and step.\n", verdict_columns);

static const struct thud_column energy_columns[] = {
    CELL(method, "method", "Name of the method."),
    CELL(located, "located", "1 if events are located."),
    CELL(own.omega_dt, "omega_dt", "Step times the frequency of the spring; empty: adaptive steps."),
    CELL(own.growth[THUD_STABILITY_WALL], "largest_ratio",
         "Largest energy within 50 s over the initial energy, largest of the starts."),
    CELL(own.end_least, "end_least_ratio", "Energy after 50 s over the initial energy, smallest of the starts."),
    CELL(own.end_most, "end_most_ratio", "Energy after 50 s over the initial energy, largest of the starts.")};
const struct thud_schema thud_energies_schema =
    THUD_SCHEMA("energies.csv", "Written by\n.Cm stability Fl o :\nthe mass on the wall spring, from eight starts.\n",
                energy_columns);

static void make_cell(const void *of, int i, void *out)
{
    const struct thud_stability_cell *c = &((const struct thud_stability *)of)->cell[i];
    struct cell_row *row = out;
    *row = (struct cell_row){c->how.method->name, {0}, c->how.locate, c->how.method->stability, *c};
    for (int k = 0; k < THUD_STABILITY_KINDS; k++) {
        row->verdict[k] = thud_stability_verdict_word(c->verdict[k]);
        if (c->verdict[k] == THUD_VERDICT_NONE)
            row->own.growth[k] = NAN;
    }
    if (c->verdict[THUD_STABILITY_WALL] == THUD_VERDICT_NONE)
        row->own.end_least = row->own.end_most = NAN;
}

struct restitution_row {
    const char *law, *method;
    int located;
    struct thud_stability_restitution own;
};
#define RESTITUTION(member, name, text) THUD_FIELD_WITH(struct restitution_row, member, name, text, .infinite = true)
static const struct thud_column restitution_columns[] = {
    RESTITUTION(law, "law", "Name of the law."),
    RESTITUTION(own.nominal, "nominal", "Nominal coefficient of restitution."),
    RESTITUTION(own.approach_mps, "approach_mps", "Approach velocity, m/s."),
    RESTITUTION(method, "method", "Name of the method."),
    RESTITUTION(located, "located", "1 if events are located."),
    RESTITUTION(own.how.setting, "setting", "Step in s, or tolerance."),
    RESTITUTION(own.expected, "expected", "Coefficient of restitution from the equations of the law."),
    RESTITUTION(own.obtained, "obtained", "Coefficient of restitution of the run.")};
const struct thud_schema thud_restitution_schema =
    THUD_SCHEMA("restitutions.csv", "Written by\n.Cm stability Fl o .\n", restitution_columns);

static void make_restitution(const void *of, int i, void *out)
{
    const struct thud_stability_restitution *r = &((const struct thud_stability *)of)->restitution[i];
    *(struct restitution_row *)out = (struct restitution_row){r->law->name, r->how.method->name, r->how.locate, *r};
}

#define TEST_CASE(member, text) THUD_FIELD_WITH(struct thud_test_case, member, #member, text, .infinite = true)
static const struct thud_column test_case_columns[] = {
    TEST_CASE(name, "Name of the test case."),
    TEST_CASE(scene, "Scene that is run."),
    TEST_CASE(quantity, "Quantity that is compared."),
    TEST_CASE(method, "Naive method."),
    TEST_CASE(exact, "Exact value."),
    TEST_CASE(naive, "Value of the naive method; inf, in JSON null: it blows up."),
    TEST_CASE(computed, "Value computed by thud.")};
const struct thud_schema thud_test_case_schema =
    THUD_SCHEMA("test-cases.csv", "Written by\n.Cm stability Fl o :\nscenes in which a naive method goes wrong.\n",
                test_case_columns);

static void make_test_case(const void *of, int i, void *out)
{
    *(struct thud_test_case *)out = ((const struct thud_stability *)of)->test_case[i];
}

struct summary_row {
    const char *method;
    int located, nominal;
    struct thud_stability_summary own;
};
#define SUMMARY(member, name, text) THUD_FIELD_WITH(struct summary_row, member, name, text, .infinite = true)
static const struct thud_column summary_columns[] = {
    SUMMARY(method, "method", "Name of the method."),
    SUMMARY(located, "located", "1 if events are located."),
    SUMMARY(nominal, "order", "Order from the literature; 0: exact without contact."),
    SUMMARY(own.order, "order_observed",
            "Observed order for the time of the fourth impact on a wall spring, mean of eight starts, from steps of 4 "
            "ms to 1 ms; empty: adaptive steps."),
    SUMMARY(own.keeps[0], "keeps_10_percent",
            "Largest step (s) or tolerance tried (0.02 s to 0.1 ms) that keeps the scene's peaks within 10 % and finds "
            "every impact, as does the next smaller one; empty: none."),
    SUMMARY(own.keeps[1], "keeps_1_percent", "Largest step or tolerance that does the same within 1 %."),
    SUMMARY(own.diverges_s, "diverges_s", "Smallest step of the scene's verdicts that blows up, s; empty: none does."),
    SUMMARY(own.wall_least, "wall_end_least_ratio",
            "Energy after 50 s on the wall spring over the initial energy, smallest of the starts, at a "
            "step times frequency of 0.5."),
    SUMMARY(own.wall_most, "wall_end_most_ratio", "Energy after 50 s over the initial energy, largest of the starts."),
    SUMMARY(own.expected, "restitution",
            "Coefficient of restitution from the equations of kelvin-voigt-no-tension, nominal 0.5, at 0.5 m/s."),
    SUMMARY(own.obtained, "restitution_obtained", "Coefficient of restitution of the run, in steps of 1 ms.")};
const struct thud_schema thud_stability_summary_schema = THUD_SCHEMA(
    "methods.csv", "Written by\n.Cm stability Fl o :\na row for each method, located and not.\n", summary_columns);

static void make_summary(const void *of, int i, void *out)
{
    const struct thud_stability_summary m = thud_stability_summary_of(of, i);
    *(struct summary_row *)out = (struct summary_row){m.how.method->name, m.how.locate, m.how.method->order, m};
}

struct thud_rows thud_stability_rows(const struct thud_stability *s, int table)
{
    int test_cases = 0;
    while (test_cases < s->ntest_cases && s->test_case[test_cases].name)
        test_cases++;
    const struct thud_rows rows[THUD_STABILITY_TABLES] = {
        {&thud_verdict_schema, 0, s->ncells, make_cell, s},
        {&thud_energies_schema, 0, s->ncells, make_cell, s},
        {&thud_restitution_schema, 0, s->nrestitutions, make_restitution, s},
        {&thud_test_case_schema, 0, test_cases, make_test_case, s},
        {&thud_stability_summary_schema, 0, s->nsummaries, make_summary, s}};
    return rows[table];
}
