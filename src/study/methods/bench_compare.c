/* How far one result lies from another: peaks, forces, impact times. */
#include <math.h>
#include <stdlib.h>

#include "study/methods/bench_private.h"

/* An impact counts where its impulse is at least this part of the largest one of its run. */
static const double weight = 1e-2;
/* Impacts further apart in time than this are not the same one. */
static const double same_impact_s = 0.02;

enum thud_status thud_bench_solution_take(const struct thud_run *run, struct thud_bench_solution *out,
                                          struct thud_error *err)
{
    const struct thud_result *r = thud_run_result(run);
    int n, floors = 0;
    const struct thud_impact *impact = thud_run_impacts(run, &n);
    for (int s = 0; s < r->nstructures; s++)
        floors += r->structure[s].floors;
    *out = (struct thud_bench_solution){.floors = floors, .contacts = r->ncontacts, .there = true};
    out->acceleration = calloc((size_t)floors + 1, sizeof(double));
    out->drift = calloc((size_t)floors + 1, sizeof(double));
    out->force = calloc((size_t)r->ncontacts + 1, sizeof(double));
    out->impact = calloc((size_t)n + 1, sizeof *out->impact);
    if (!out->acceleration || !out->drift || !out->force || !out->impact) {
        thud_bench_solution_clear(out);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    for (int s = 0, k = 0; s < r->nstructures; s++)
        for (int i = 0; i < r->structure[s].floors; i++, k++) {
            out->acceleration[k] = r->structure[s].floor[i].acceleration.value;
            out->drift[k] = r->structure[s].floor[i].drift.value;
        }
    double largest = 0;
    for (int c = 0; c < r->ncontacts; c++)
        out->force[c] = r->contact[c].force.value;
    for (int i = 0; i < n; i++)
        largest = fmax(largest, impact[i].impulse_ns);
    for (int i = 0; i < n; i++)
        if (impact[i].impulse_ns >= weight * largest && impact[i].impulse_ns > 0)
            out->impact[out->nimpacts++] = impact[i];
    return THUD_OK;
}

void thud_bench_solution_clear(struct thud_bench_solution *solution)
{
    free(solution->acceleration);
    free(solution->drift);
    free(solution->force);
    free(solution->impact);
    *solution = (struct thud_bench_solution){0};
}

/* Largest difference over the reference's own value; values below a thousandth of the largest count by that. */
static double relative(const double *x, const double *reference, int n)
{
    double largest = 0, worst = 0;
    for (int i = 0; i < n; i++)
        largest = fmax(largest, fabs(reference[i]));
    for (int i = 0; i < n; i++) {
        double scale = fmax(fabs(reference[i]), 1e-3 * largest);
        if (scale > 0)
            worst = fmax(worst, fabs(x[i] - reference[i]) / scale);
        else if (x[i] != 0)
            worst = INFINITY;
    }
    return worst;
}

/* Distance in time to the nearest impact of the same contact. */
static double nearest(const struct thud_impact *impact, const struct thud_bench_solution *in)
{
    double least = INFINITY;
    for (int i = 0; i < in->nimpacts; i++)
        if (in->impact[i].contact == impact->contact)
            least = fmin(least, fabs(in->impact[i].start_s - impact->start_s));
    return least;
}

struct thud_bench_errors thud_bench_compare(const struct thud_bench_solution *solution,
                                            const struct thud_bench_solution *reference)
{
    struct thud_bench_errors e = {0};
    e.acceleration = relative(solution->acceleration, reference->acceleration, reference->floors);
    e.drift = relative(solution->drift, reference->drift, reference->floors);
    e.force = relative(solution->force, reference->force, reference->contacts);
    e.all = fmax(e.acceleration, fmax(e.drift, e.force));
    for (int i = 0; i < reference->nimpacts; i++) {
        double d = nearest(&reference->impact[i], solution);
        if (d > same_impact_s)
            e.missed++;
        else
            e.impact_time_s = fmax(e.impact_time_s, d);
    }
    for (int i = 0; i < solution->nimpacts; i++)
        e.extra += nearest(&solution->impact[i], reference) > same_impact_s;
    return e;
}
