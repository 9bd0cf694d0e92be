#include "study/suite/suite.h"
#include "base/largest.h"
#include "base/statistics.h"
#include "ground/identity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The ground motions by the recording that each is of: suite->motion, and where those of each begin. */
static void group_motions(const struct thud_sweep_plan *plan, struct thud_suite *suite)
{
    const int n = suite->nrecords;
    int *own = suite->first + n + 1, k = 0; /* whose each is */
    suite->ndraws = thud_motions_recordings(plan->nrecords > 0 ? plan->record : NULL, n, own);
    for (int draw = 0; draw < suite->ndraws; draw++) {
        suite->first[draw] = k;
        for (int r = 0; r < n; r++)
            if (own[r] == draw)
                suite->motion[k++] = r;
    }
    suite->first[suite->ndraws] = k;
}

enum thud_status thud_suite_create(const struct thud_sweep_plan *plan, struct thud_suite **out, struct thud_error *err)
{
    struct thud_suite *suite = calloc(1, sizeof *suite);
    *out = NULL;
    if (suite) {
        suite->plan = plan;
        suite->nrecords = plan->nrecords > 0 ? plan->nrecords : 1;
        suite->settings = thud_sweep_points(plan) / suite->nrecords;
        suite->nstructures = plan->scene.nstructures;
        suite->features = THUD_HAS_REFERENCE | plan->has;
        for (enum thud_measure m = 0; m < THUD_MEASURES; m++) {
            suite->at[m] = suite->nvalues;
            suite->nvalues += !thud_measure_info(m)->read          ? 0
                              : thud_measure_info(m)->of_structure ? suite->nstructures
                                                                   : 1;
        }
        size_t n = (size_t)thud_sweep_points(plan) * (size_t)plan->ncases * (size_t)suite->nvalues;
        suite->value = malloc((n + 1) * sizeof *suite->value);
        suite->first = malloc(((size_t)suite->nrecords * 2 + 1) * sizeof *suite->first);
        suite->motion = malloc((size_t)suite->nrecords * sizeof *suite->motion);
        if (suite->first && suite->motion)
            group_motions(plan, suite);
        for (size_t i = 0; suite->value && i < n; i++)
            suite->value[i] = NAN;
    }
    if (!suite || !suite->value || !suite->first || !suite->motion) {
        thud_suite_free(suite);
        return thud_error_set(err, THUD_MEMORY, "out of memory for the runs of the study");
    }
    *out = suite;
    return THUD_OK;
}

void thud_suite_free(struct thud_suite *suite)
{
    if (!suite)
        return;
    free(suite->value);
    free(suite->first);
    free(suite->motion);
    free(suite);
}

static double *run_at(const struct thud_suite *suite, long point, int k)
{
    return suite->value + ((size_t)point * (size_t)suite->plan->ncases + (size_t)k) * (size_t)suite->nvalues;
}

/* The measures of a run; none of a wall, which has no floors. */
static void put_run(const struct thud_suite *suite, const struct thud_measured_run *run, double *value)
{
    for (enum thud_measure m = 0; m < THUD_MEASURES; m++) {
        const struct thud_measure_info *info = thud_measure_info(m);
        for (int s = 0; info->read && s < (info->of_structure ? suite->nstructures : 1); s++)
            if (!info->of_structure || run->point->floors[s] > 0)
                value[suite->at[m] + s] = thud_measure_read(run, m, s);
    }
}

enum thud_status thud_suite_add(struct thud_suite *suite, const struct thud_sweep_point *point, struct thud_error *err)
{
    struct thud_scene *scene = malloc(sizeof *scene);
    if (!scene)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = thud_sweep_scene(suite->plan, point->index, scene, err);
    for (int k = 0; k < suite->plan->ncases && k < point->ncases && status == THUD_OK; k++)
        if (point->effort[k].status == THUD_OK)
            put_run(suite, &(struct thud_measured_run){scene, point, k}, run_at(suite, point->index, k));
    free(scene);
    return status;
}

double thud_suite_value(const struct thud_suite *suite, int record, long setting, int k, enum thud_measure measure,
                        int structure)
{
    const struct thud_measure_info *info = thud_measure_info(measure);
    const double *value = run_at(suite, record * suite->settings + setting, k) + suite->at[measure];
    if (!info->of_structure || structure >= 0)
        return value[info->of_structure ? structure : 0];
    double most = info->unknown ? 0 : (double)NAN;
    for (int s = 0; s < suite->nstructures; s++)
        if (suite->plan->scene.structure[s].kind != THUD_WALL)
            most = thud_measure_larger(info, most, value[s]);
    return most;
}

struct thud_fractiles thud_suite_fractiles(const struct thud_suite *suite, long setting, int k,
                                           enum thud_measure measure, int structure, double limit, double *scratch)
{
    for (int r = 0; r < suite->nrecords; r++)
        scratch[r] = thud_suite_value(suite, r, setting, k, measure, structure);
    return thud_fractiles_of(scratch, (size_t)suite->nrecords, suite->ndraws, limit);
}

void thud_suite_share_band(const struct thud_suite *suite, size_t count, size_t n, double *low, double *high)
{
    *low = *high = NAN;
    if (suite->ndraws >= THUD_SHARES_LEAST)
        thud_share_band(count, n, suite->ndraws / (double)suite->nrecords, low, high);
}

long thud_suite_setting(const struct thud_sweep_plan *plan, const int *at)
{
    long setting = 0;
    for (int a = 0; a < plan->naxes; a++)
        setting = setting * plan->axis[a].n + at[a];
    return setting;
}
