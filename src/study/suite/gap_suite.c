#include "study/suite/gap_suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ground/target.h"
#include "study/scene/building.h"
#include "study/scene/solution.h"
#include "study/suite/suite.h"

/* What a rule asks for of one motion, at a level or at all levels of an interface. */
static double of_motion(const struct thud_needed_gap *gap, int interface, int level, int rule)
{
    return level < 0 ? thud_needed_gap_widest(gap, interface, rule, NULL) : thud_gap_value(&gap->level[level], rule);
}

enum thud_status thud_gap_suite_fractiles(const struct thud_gap_suite *suite, int interface, int level, int rule,
                                          struct thud_fractiles *out, struct thud_error *err)
{
    double *value = malloc(((size_t)suite->nrecords + 1) * sizeof *value);
    int shorter = 0;
    if (!value)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int r = 0; r < suite->nrecords; r++) {
        const struct thud_needed_gap *gap = suite->gap[r];
        value[r] = of_motion(gap, interface, level, rule);
        shorter += thud_gap_falls_short(value[r], of_motion(gap, interface, level, THUD_GAP_EXACT));
    }
    size_t count;
    *out = thud_fractiles_of(value, (size_t)suite->nrecords, suite->recordings, INFINITY);
    const size_t enough = isnan(out->p84) ? 0 : out->n;
    out->p16 = thud_enough(value, enough, 0.16, &count);
    out->median = thud_enough(value, out->n, 0.5, &out->half);
    out->p84 = thud_enough(value, enough, 0.84, &out->most84);
    out->share = out->n > 0 ? (double)shorter / (double)out->n : NAN;
    free(value);
    return THUD_OK;
}

/* A level with the displacements that a code designs for. */
static struct thud_gap_level design_level(const struct thud_gap_suite *suite, int level, bool means)
{
    struct thud_gap_level out = suite->gap[0]->level[level];
    double left = 0, right = 0;
    for (int r = 0; r < suite->nrecords; r++) {
        const struct thud_gap_level *l = &suite->gap[r]->level[level];
        left += l->left_m / suite->nrecords;
        right += l->right_m / suite->nrecords;
        out.left_m = fmax(out.left_m, l->left_m);
        out.right_m = fmax(out.right_m, l->right_m);
        out.relative_displacement_m = fmax(out.relative_displacement_m, l->relative_displacement_m);
        out.correlation = isnan(l->correlation) ? NAN : out.correlation;
    }
    if (means) {
        out.left_m = left;
        out.right_m = right;
    }
    return out;
}

/* From seven on (EN 1998-1:2004, 4.3.3.4.3(3)), of ASCE 7 from eleven on (ASCE 7-16, 16.2.2). */
bool thud_gap_suite_means(const struct thud_gap_suite *suite, int rule)
{
    const bool asce = rule >= 0 && strncmp(thud_gap_rule_at(rule)->edition, "ASCE", 4) == 0;
    const struct thud_target code = {.kind = asce ? THUD_TARGET_ASCE7 : THUD_TARGET_EN1998};
    return suite->recordings >= thud_target_code(&code)->mean;
}

void thud_gap_suite_rule(const struct thud_gap_suite *suite, int rule, int interfaces, struct thud_gap_ruled *out)
{
    const bool means = thud_gap_suite_means(suite, rule);
    for (int i = 0; i < interfaces; i++)
        out[i] = (struct thud_gap_ruled){.gap_m = -1, .worst = -1};
    for (int l = 0; l < suite->gap[0]->nlevels; l++) {
        struct thud_gap_level level = design_level(suite, l, means);
        struct thud_gap_ruled *ruled = &out[level.interface - 1];
        double x = thud_gap_value(&level, rule);
        if (!thud_gap_is_wider(x, ruled->gap_m))
            continue;
        ruled->gap_m = x;
        ruled->level = level;
    }
}

/* Of an interface (from 0): what the rule asks for, or the scene's own gap. */
static double gap_at(const struct thud_scene *scene, const struct thud_gap_ruled *ruled, int interface)
{
    double gap = ruled[interface].gap_m;
    return gap >= 0 ? gap : scene->interface[interface].gap_m;
}

enum thud_status thud_gap_pound(const struct thud_scene *scene, const struct thud_record *record,
                                const struct thud_gap_suite *suite, int motion, struct thud_gap_ruled *ruled,
                                struct thud_error *err)
{
    const struct thud_needed_gap *gap = suite->gap[motion];
    bool in_contact = false, pounds[THUD_STRUCTURES_MAX] = {false};
    for (int l = 0; l < gap->nlevels; l++)
        in_contact = in_contact || thud_gap_falls_short(gap_at(scene, ruled, gap->level[l].interface - 1),
                                                        gap->level[l].relative_displacement_m);
    if (!in_contact)
        return THUD_OK;
    struct thud_solution solution = {0};
    struct thud_scene *at = malloc(sizeof *at);
    if (!at)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = thud_scene_case(scene, thud_scene_bare(scene), at, err);
    for (int i = 0; i + 1 < scene->nstructures; i++)
        at->interface[i].gap = (struct thud_by_level){0};
    for (int i = 0; i + 1 < scene->nstructures; i++)
        at->interface[i].gap_m = gap_at(scene, ruled, i);
    const bool refused = status == THUD_OK && thud_scene_check(at, NULL) == THUD_INPUT; /* a law without force, say */
    if (status == THUD_OK && !refused)
        status = thud_scene_solve(at, record, NULL, &solution, err);
    for (int l = 0; refused && l < gap->nlevels; l++) {
        const int i = gap->level[l].interface - 1;
        pounds[i] = pounds[i] || thud_gap_falls_short(gap_at(scene, ruled, i), gap->level[l].relative_displacement_m);
    }
    for (int c = 0; status == THUD_OK && !refused && c < solution.model->npairs; c++) {
        const struct thud_contact_result *p = &thud_run_result(solution.run)->contact[c];
        struct thud_gap_ruled *one = &ruled[p->interface - 1];
        pounds[p->interface - 1] = pounds[p->interface - 1] || p->impacts > 0;
        if (p->impacts > 0 && (one->worst < 0 || p->force.value > one->force_n)) {
            one->force_n = p->force.value;
            one->worst = motion;
        }
    }
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        ruled[i].pounding += pounds[i];
        if (refused && pounds[i] && ruled[i].worst < 0)
            ruled[i].force_n = NAN; /* not known */
    }
    thud_solution_clear(&solution);
    free(at);
    return status;
}

/* ---- over the periods of estimated buildings ---- */

/* Structures with even and with odd index have a factor each, so that neighbours take every pair of them. */
static void estimated(const struct thud_scene *scene, bool of[2])
{
    of[0] = of[1] = false;
    for (int s = 0; s < scene->nstructures; s++)
        of[s % 2] = of[s % 2] || thud_period_is_estimated(&scene->structure[s]);
}

/* Periods of one building: steps of 5 and 9 %. */
static int steps(const struct thud_scene *scene)
{
    bool of[2];
    estimated(scene, of);
    return of[0] && of[1] ? 9 : of[0] || of[1] ? 15 : 0;
}

int thud_gap_periods(const struct thud_scene *scene)
{
    bool of[2];
    estimated(scene, of);
    return of[0] && of[1] ? steps(scene) * steps(scene) : steps(scene);
}

static double factor_of(const struct thud_scene *scene, int period, int structure)
{
    bool of[2];
    estimated(scene, of);
    const int n = steps(scene), i = of[0] && of[1] && structure % 2 ? period / n : period % n;
    if (!thud_period_is_estimated(&scene->structure[structure]))
        return NAN;
    return THUD_ESTIMATE_LEAST * pow(THUD_ESTIMATE_MOST / THUD_ESTIMATE_LEAST, i / (n - 1.0));
}

enum thud_status thud_gap_at_periods(const struct thud_scene *scene, const struct thud_record *record, int period,
                                     double *need_m, struct thud_error *err)
{
    struct thud_scene *at = malloc(sizeof *at);
    struct thud_needed_gap *gap = NULL;
    if (!at)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    *at = *scene;
    for (int s = 0; s < scene->nstructures; s++)
        if (thud_period_is_estimated(&scene->structure[s])) {
            at->structure[s].period_factor *= factor_of(scene, period, s);
            thud_structure_fill_estimate(&at->structure[s]);
        }
    enum thud_status status = thud_needed_gap_run(at, record, &gap, err);
    for (int i = 0; status == THUD_OK && i + 1 < scene->nstructures; i++)
        need_m[i] = fmax(need_m[i], thud_needed_gap_widest(gap, i + 1, THUD_GAP_EXACT, NULL));
    free(gap);
    free(at);
    return status;
}

int thud_gap_period_range(const struct thud_scene *scene, const double *need_m, struct thud_gap_range *out)
{
    const int n = scene->nstructures - 1;
    int ranges = 0;
    for (int i = 0; i < n; i++) {
        const bool estimated =
            thud_period_is_estimated(&scene->structure[i]) || thud_period_is_estimated(&scene->structure[i + 1]);
        if (!estimated || need_m[i] < 0) /* nothing can touch there, at any period */
            continue;
        struct thud_gap_range *range = &out[ranges++];
        *range = (struct thud_gap_range){i + 1, NAN, NAN, NAN, NAN};
        for (int p = 0; p < thud_gap_periods(scene); p++) {
            const double need = need_m[p * n + i];
            range->least_m = fmin(range->least_m, need);
            if (need <= range->most_m)
                continue;
            range->most_m = need;
            range->left_factor = factor_of(scene, p, i);
            range->right_factor = factor_of(scene, p, i + 1);
        }
    }
    return ranges;
}
