#include "study/suite/suite.h"
#include "base/largest.h"
#include "base/statistics.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { OF_RUN = THUD_SUITE_ACCELERATION, OF_STRUCTURE = THUD_SUITE_MEASURES - OF_RUN };

const char *thud_suite_column(enum thud_suite_measure measure)
{
    static const char *const column[] = {"impacts",
                                         "used_up",
                                         "short_m",
                                         "force_n",
                                         "acceleration_mps2",
                                         "drift_m",
                                         "drift_angle",
                                         "acceleration_ratio",
                                         "drift_ratio",
                                         "ductility",
                                         "permanent_m",
                                         "isolator_m",
                                         "shear_over_capacity"};
    return column[measure];
}

bool thud_suite_has(const struct thud_suite *suite, enum thud_suite_measure measure)
{
    return measure == THUD_SUITE_COLUMNS     ? suite->columns
           : measure == THUD_SUITE_ISOLATOR  ? suite->isolated
           : measure >= THUD_SUITE_DUCTILITY ? suite->yields
                                             : true;
}

/* By the scene, or by a varied key. */
static bool has_capacity(const struct thud_sweep_plan *plan)
{
    bool has = false;
    for (int s = 0; s < plan->scene.nstructures; s++)
        for (int i = 0; i < plan->scene.structure[s].storeys; i++)
            has |= plan->scene.structure[s].column_capacity_n[i] > 0;
    for (int a = 0; a < plan->naxes; a++)
        has |= strstr(plan->axis[a].key, ".column.capacity") != NULL;
    return has;
}

static bool is_turned(const struct thud_sweep_plan *plan, int r)
{
    if (r == 0 || !plan->record || !plan->record[r] || !plan->record[r - 1])
        return false;
    return thud_motion_is_turned(plan->record[r]->file, plan->record[r - 1]->file);
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
        suite->yields = thud_sweep_yields(plan);
        suite->linear = !suite->yields;
        for (int i = 0; i < plan->scene.nstructures; i++)
            suite->linear &= plan->scene.structure[i].velocity_mps == 0;
        for (int i = 0; i < plan->scene.nstructures; i++)
            suite->isolated |= plan->scene.structure[i].kind == THUD_ISOLATED;
        suite->columns = has_capacity(plan);
        suite->nvalues = OF_RUN + OF_STRUCTURE * suite->nstructures;
        size_t n = (size_t)thud_sweep_points(plan) * (size_t)plan->ncases * (size_t)suite->nvalues;
        suite->value = malloc((n + 1) * sizeof *suite->value);
        suite->first = malloc(((size_t)suite->nrecords + 1) * sizeof *suite->first);
        for (int r = 0; suite->first && r <= suite->nrecords; r++)
            if (r == suite->nrecords || !is_turned(plan, r))
                suite->first[suite->ndraws++] = r;
        suite->ndraws--;
        for (size_t i = 0; suite->value && i < n; i++)
            suite->value[i] = NAN;
    }
    if (!suite || !suite->value || !suite->first) {
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
    free(suite);
}

static double *run_at(const struct thud_suite *suite, long point, int k)
{
    return suite->value + ((size_t)point * (size_t)suite->plan->ncases + (size_t)k) * (size_t)suite->nvalues;
}

/* The largest drift over its storey's height. Before an isolated building's storeys stands its isolator. */
static double drift_angle(const struct thud_structure *structure, const struct thud_sweep_floor *floor, int n)
{
    int first = structure->kind == THUD_ISOLATED;
    double most = 0;
    if (!thud_kind_is_building(structure->kind))
        return NAN;
    for (int i = first; i < n; i++)
        most = fmax(most, floor[i].drift_m / structure->height_m[i - first]);
    return most;
}

/* Peaks of every structure of the point's scene; what yielding storeys have, and no other: a NaN gives way. */
static void put_peaks(const struct thud_scene *scene, const struct thud_sweep_point *point, int k, double *value)
{
    const struct thud_sweep_floor *floor = point->floor + (ptrdiff_t)k * point->nfloors;
    for (int s = 0; s < point->nstructures; floor += point->floors[s], s++) {
        double *to = value + OF_STRUCTURE * s;
        if (point->floors[s] == 0)
            continue;
        to[THUD_SUITE_ACCELERATION] = to[THUD_SUITE_DRIFT] = 0;
        for (int i = 0; i < point->floors[s]; i++) {
            to[THUD_SUITE_ACCELERATION] = thud_larger(to[THUD_SUITE_ACCELERATION], floor[i].acceleration_mps2);
            to[THUD_SUITE_DRIFT] = fmax(to[THUD_SUITE_DRIFT], floor[i].drift_m);
            to[THUD_SUITE_DUCTILITY] = fmax(to[THUD_SUITE_DUCTILITY], floor[i].ductility);
            to[THUD_SUITE_PERMANENT] = fmax(to[THUD_SUITE_PERMANENT], fabs(floor[i].permanent_m));
        }
        if (scene->structure[s].kind == THUD_ISOLATED)
            to[THUD_SUITE_ISOLATOR] = floor[0].drift_m;
        to[THUD_SUITE_DRIFT_ANGLE] = drift_angle(&scene->structure[s], floor, point->floors[s]);
    }
}

/* What the motion without pounding asks of the clearances of a case. */
static void put_clearances(const struct thud_scene *scene, const struct thud_sweep_point *point, enum thud_case which,
                           double *value)
{
    value[THUD_SUITE_USED] = 0;
    value[THUD_SUITE_SHORT] = -INFINITY;
    const struct thud_gap_level *level = thud_sweep_levels(point, which);
    for (int c = 0; c < point->ncontacts; c++) {
        double closing = level[c].relative_displacement_m;
        struct thud_interface cased = scene->interface[level[c].interface - 1];
        thud_interface_case(&cased, which);
        const struct thud_level_values at = thud_interface_level(&cased, thud_needed_gap_level(level, c));
        double clearance = thud_level_clearance(&at);
        if (closing > 0)
            value[THUD_SUITE_USED] = fmax(value[THUD_SUITE_USED], clearance > 0 ? closing / clearance : INFINITY);
        value[THUD_SUITE_SHORT] = fmax(value[THUD_SUITE_SHORT], closing - clearance);
    }
}

enum thud_status thud_suite_add(struct thud_suite *suite, const struct thud_sweep_point *point, struct thud_error *err)
{
    int n = thud_sweep_rows(suite->plan, point, NULL);
    struct thud_sweep_row *row = malloc(((size_t)n + 1) * sizeof *row);
    struct thud_scene *scene = row ? malloc(sizeof *scene) : NULL;
    if (!row || !scene) {
        free(row);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    enum thud_status status = thud_sweep_scene(suite->plan, point->index, scene, err);
    thud_sweep_rows(suite->plan, point, row);
    for (int k = 0; k < suite->plan->ncases && k < point->ncases && status == THUD_OK; k++) {
        double *value = run_at(suite, point->index, k);
        if (point->effort[k].status != THUD_OK)
            continue;
        put_peaks(scene, point, k, value);
        put_clearances(scene, point, suite->plan->cases[k], value);
        value[THUD_SUITE_IMPACTS] = value[THUD_SUITE_FORCE] = 0;
        for (int c = 0; c < point->ncontacts; c++) {
            const struct thud_sweep_contact *x = &point->contact[(ptrdiff_t)k * point->ncontacts + c];
            value[THUD_SUITE_IMPACTS] += x->impacts;
            value[THUD_SUITE_FORCE] = thud_larger(value[THUD_SUITE_FORCE], x->force_n);
            const struct thud_gap_level *level = &point->level[c];
            if (level->struck != 0) {
                double *columns = value + OF_STRUCTURE * (level->interface - (level->struck < 0)) + THUD_SUITE_COLUMNS;
                *columns = fmax(*columns, x->capacity_ratio);
            }
        }
        for (int i = 0; i < n; i++)
            if (row[i].which == point->which[k] && row[i].floor == 0) {
                double *to = value + OF_STRUCTURE * row[i].structure;
                to[THUD_SUITE_ACCELERATION_RATIO] = row[i].of[THUD_SWEEP_ACCELERATION_RATIO];
                to[THUD_SUITE_DRIFT_RATIO] = row[i].of[THUD_SWEEP_DRIFT_RATIO];
            }
    }
    free(row);
    free(scene);
    return status;
}

double thud_suite_value(const struct thud_suite *suite, int record, long setting, int k,
                        enum thud_suite_measure measure, int structure)
{
    const double *value = run_at(suite, record * suite->settings + setting, k);
    if ((int)measure < OF_RUN)
        return value[measure];
    if (structure >= 0)
        return value[(int)measure + OF_STRUCTURE * structure];
    double most = NAN;
    for (int s = 0; s < suite->nstructures; s++)
        most = fmax(most, value[(int)measure + OF_STRUCTURE * s]); /* a NaN gives way */
    return most;
}

struct thud_fractiles thud_suite_fractiles(const struct thud_suite *suite, long setting, int k,
                                           enum thud_suite_measure measure, int structure, double limit,
                                           double *scratch)
{
    for (int r = 0; r < suite->nrecords; r++)
        scratch[r] = thud_suite_value(suite, r, setting, k, measure, structure);
    struct thud_fractiles f = thud_fractiles_of(scratch, (size_t)suite->nrecords, limit);
    if (suite->nrecords > 1 && suite->ndraws < THUD_SHARES_LEAST)
        f.p16 = f.p84 = NAN;
    return f;
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
