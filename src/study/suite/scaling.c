/* Selection and scaling of ground motions to a target spectrum.
 *
 * Each motion gets the factor of least squares of ln(target/Sa) over the periods (thud_target_factor); those with the
 * least rest are taken, one component of a station and so many of an event. One more factor, of all of them, lifts the
 * mean of their spectra to 90 % of the target where it is least (EN 1998-1 3.2.3.1.2(4)b) and their mean peak to the
 * target's value at T = 0 (4(a)); scaled in common there is that factor alone, which may be below 1. */
#include "study/suite/scaling.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "ground/identity.h"
#include "study/suite/suite.h"

static const double least_share = 0.9; /* of the target, by the code */
/* A period is resolved where a motion has a sample in each quarter of it. */
static const double samples_per_period = 4;

void thud_scaling_init(struct thud_scaling *scaling)
{
    *scaling = (struct thud_scaling){.factor_most = 4, .per_event = 2, .from_s = 0.1, .to_s = 2};
}

void thud_scaled_suite_clear(struct thud_scaled_suite *suite)
{
    free(suite->motion);
    *suite = (struct thud_scaled_suite){0};
}

/* The periods that count: those asked for that the target has and the motions resolve. */
static enum thud_status set_range(const struct thud_record *const *record, int n, const struct thud_target *target,
                                  const struct thud_scaling *s, struct thud_scaled_suite *suite, struct thud_error *err)
{
    double from = s->from_s, to = s->to_s;
    for (int i = 0; i < n; i++)
        from = fmax(from, samples_per_period * record[i]->dt_s);
    if (target) {
        double first, last;
        thud_target_range(target, &first, &last);
        from = fmax(from, first);
        to = fmin(to, last);
    }
    if (!(from > 0) || !(to > from))
        return thud_error_refuse(err, THUD_INPUT, NULL, "a range that begins at four samples or more, from < to",
                                 "no period from %.4g to %.4g s is resolved by the motions and in the target",
                                 s->from_s, s->to_s);
    suite->narrowed = from > s->from_s || to < s->to_s;
    thud_target_periods(from, to, THUD_TARGET_PERIODS, suite->period_s);
    return THUD_OK;
}

/* Why a motion may not be taken beside those that are; NULL: it may. */
static const char *objection(const struct thud_record *const *record, const struct thud_scaled_suite *suite, int i,
                             const struct thud_scaling *s, char *text, size_t size)
{
    const struct thud_scaled_motion *m = &suite->motion[i];
    int of_event = 0;
    if (!(m->peak_mps2 > 0))
        return "it is all zeros";
    if (!s->vertical && thud_record_is_vertical(record[i]))
        return "a vertical component";
    if (!s->common && (m->factor > s->factor_most || m->factor < 1 / s->factor_most)) {
        snprintf(text, size, "its factor would be %.3g", m->factor);
        return text;
    }
    for (int k = 0; k < suite->n; k++) {
        if (!suite->motion[k].chosen)
            continue;
        of_event += thud_record_same_event(record[i], record[k]);
        if (thud_record_same_station(record[i], record[k]))
            return "another component of its station";
        if (thud_record_same_motion(record[i], record[k]))
            return "the same motion as another";
    }
    if (of_event < s->per_event)
        return NULL;
    snprintf(text, size, "%d others of its event", of_event);
    return text;
}

/* The best of those not yet judged; -1 when all are. */
static int next_best(const struct thud_scaled_suite *suite)
{
    int best = -1;
    for (int i = 0; i < suite->n; i++)
        if (!suite->motion[i].chosen && !suite->motion[i].why[0] &&
            (best < 0 || suite->motion[i].misfit < suite->motion[best].misfit))
            best = i;
    return best;
}

static void choose(const struct thud_record *const *record, struct thud_scaled_suite *suite,
                   const struct thud_scaling *s)
{
    int wanted = s->count > 0 ? s->count : suite->n;
    for (int i; (i = next_best(suite)) >= 0;) {
        struct thud_scaled_motion *m = &suite->motion[i];
        char text[64];
        const char *why = objection(record, suite, i, s, text, sizeof text);
        if (!why && suite->chosen == wanted)
            why = "fits less well";
        m->chosen = why == NULL;
        suite->chosen += m->chosen;
        if (why)
            snprintf(m->why, sizeof m->why, "%s", why);
    }
}

/* Mean Sa of the chosen motions at a period, each by its own factor. */
static double mean_at(const struct thud_record *const *record, const struct thud_scaled_suite *suite, double period_s)
{
    double mean = 0, sa;
    for (int i = 0; i < suite->n; i++)
        if (suite->motion[i].chosen) {
            thud_target_motion(record[i], suite->damping, &period_s, 1, &sa);
            mean += suite->motion[i].factor * sa / suite->chosen;
        }
    return mean;
}

/* The least ratio of mean and target, at suite->ratio_s. The periods that count are 5 % and more apart, the half-power
 * bandwidth of 5 % damping is 10 %: between two of them a ratio is looked for where both lie within a quarter of the
 * least. */
static void find_least(const struct thud_record *const *record, const struct thud_target *target,
                       struct thud_scaled_suite *suite)
{
    enum { BETWEEN = 12 };
    double at[THUD_TARGET_PERIODS];
    suite->ratio = INFINITY;
    for (int p = 0; p < THUD_TARGET_PERIODS; p++) {
        at[p] = target ? suite->mean_mps2[p] / suite->target_mps2[p] : NAN;
        if (at[p] < suite->ratio) {
            suite->ratio = at[p];
            suite->ratio_s = suite->period_s[p];
        }
    }
    const double near = 1.25 * suite->ratio;
    for (int p = 0; p + 1 < THUD_TARGET_PERIODS; p++)
        for (int k = 1; k < BETWEEN && fmin(at[p], at[p + 1]) <= near; k++) {
            const double period =
                suite->period_s[p] * pow(suite->period_s[p + 1] / suite->period_s[p], (double)k / BETWEEN);
            const double ratio = mean_at(record, suite, period) / thud_target_sa(target, period);
            if (ratio < suite->ratio) {
                suite->ratio = ratio;
                suite->ratio_s = period;
            }
        }
}

/* The factor of all, and the mean that comes of it. */
static void scale_all(const struct thud_record *const *record, struct thud_scaled_suite *suite,
                      const struct thud_target *target, const struct thud_scaling *how)
{
    const bool common = how->common || how->as_given;
    double count = suite->chosen, peak = 0, need = 0;
    for (int p = 0; p < THUD_TARGET_PERIODS; p++)
        suite->mean_mps2[p] = 0;
    for (int i = 0; i < suite->n; i++) {
        struct thud_scaled_motion *m = &suite->motion[i];
        m->factor = common ? 1 : m->factor;
        for (int p = 0; m->chosen && p < THUD_TARGET_PERIODS; p++)
            suite->mean_mps2[p] += m->factor * m->sa_mps2[p] / count;
        peak += m->chosen ? m->factor * m->peak_mps2 / count : 0;
    }
    find_least(record, target, suite);
    if (target)
        need = least_share / suite->ratio;
    suite->zero_mps2 = target ? thud_target_sa(target, 0) : NAN;
    if (target && suite->zero_mps2 > 0)
        need = fmax(need, suite->zero_mps2 / peak);
    suite->common = !target || how->as_given ? 1 : common ? need : fmax(1, need);
    suite->mean_peak_mps2 = suite->common * peak;
    suite->ratio *= suite->common;
    for (int p = 0; p < THUD_TARGET_PERIODS; p++)
        suite->mean_mps2[p] *= suite->common;
    for (int i = 0; i < suite->n; i++)
        suite->motion[i].factor *= suite->common;
}

enum thud_status thud_suite_scale(const struct thud_record *const *record, int n, const struct thud_target *target,
                                  const struct thud_scaling *scaling, struct thud_scaled_suite *out,
                                  struct thud_error *err)
{
    *out = (struct thud_scaled_suite){.n = n,
                                      .damping = target ? target->damping : 0.05,
                                      .motion = calloc((size_t)(n > 0 ? n : 1), sizeof *out->motion)};
    if (!out->motion)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = set_range(record, n, target, scaling, out, err);
    for (int p = 0; p < THUD_TARGET_PERIODS; p++)
        out->target_mps2[p] = target ? thud_target_sa(target, out->period_s[p]) : NAN;
    for (int i = 0; i < n && status == THUD_OK; i++) {
        struct thud_scaled_motion *m = &out->motion[i];
        m->peak_mps2 = thud_record_peak(record[i]);
        m->factor = 1;
        thud_target_motion(record[i], out->damping, out->period_s, THUD_TARGET_PERIODS, m->sa_mps2);
        if (target && m->peak_mps2 > 0)
            m->factor = thud_target_factor(out->target_mps2, m->sa_mps2, THUD_TARGET_PERIODS, &m->misfit);
        m->chosen = !target || scaling->as_given;
    }
    out->chosen = target && !scaling->as_given ? 0 : n;
    if (status == THUD_OK && target && !scaling->as_given)
        choose(record, out, scaling);
    if (status == THUD_OK && out->chosen == 0)
        status =
            thud_error_set(err, THUD_INPUT, "no motion can be taken: %s", n > 0 ? out->motion[0].why : "there is none");
    if (status == THUD_OK)
        scale_all(record, out, target, scaling);
    else
        thud_scaled_suite_clear(out);
    return status;
}
