#include "study/suite/fragility.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "base/random.h"

/* ---- the lognormal curve ---- */

/* Beyond this the small tail is taken by its asymptote; erfc underflows at 38. */
static const double far_tail = 30;

/* eta = a + b t, t = ln x - centre. */
struct probit {
    double a, b, centre;
};

/* Stripes, and the logarithms of their x where many fits have the same (else NULL). */
struct stripes {
    const struct thud_stripe *stripe;
    const double *log_x;
    size_t n;
};

static bool counts(const struct thud_stripe *s)
{
    return s->n > 0 && s->x > 0 && isfinite(s->x);
}

static double log_x(const struct stripes *s, size_t i)
{
    return s->log_x ? s->log_x[i] : log(s->stripe[i].x);
}

/* The logarithm of the likelihood with its gradient and its negative Hessian (aa, ab, bb). */
struct likelihood {
    double sum, g[2], h[3];
};

/* Adds `count` outcomes of probability Phi(eta) (`sign` 1) or Phi(-eta) (-1): the logarithm of the probability, and
 * density over probability. */
static void add(struct likelihood *to, double count, double sign, double eta, double t, double log_p, double hazard)
{
    double slope = sign * count * hazard, curve = count * hazard * (hazard + sign * eta);
    to->sum += count * log_p;
    to->g[0] += slope;
    to->g[1] += slope * t;
    to->h[0] += curve;
    to->h[1] += curve * t;
    to->h[2] += curve * t * t;
}

/* One erfc and one exp serve both outcomes of a stripe. */
static struct likelihood likelihood(const struct probit *p, const struct stripes *s)
{
    static const double half_log_2_pi = 0.91893853320467274178, inverse_root_2_pi = 0.39894228040143267794;
    struct likelihood out = {0};
    for (size_t i = 0; i < s->n; i++) {
        if (!counts(&s->stripe[i]))
            continue;
        double t = log_x(s, i) - p->centre, eta = p->a + p->b * t, size = fabs(eta);
        double small = thud_normal_cdf(-size), density = inverse_root_2_pi * exp(-0.5 * eta * eta);
        int yes = s->stripe[i].count, no = s->stripe[i].n - yes, rare = eta < 0 ? yes : no, usual = eta < 0 ? no : yes;
        double sign = eta < 0 ? 1 : -1; /* of the rare outcome */
        if (rare > 0 && size > far_tail)
            add(&out, rare, sign, eta, t, -0.5 * eta * eta - log(size) - half_log_2_pi, size + 1 / size);
        else if (rare > 0)
            add(&out, rare, sign, eta, t, log(small), density / small);
        if (usual > 0)
            add(&out, usual, -sign, eta, t, log1p(-small), density / (1 - small));
    }
    return out;
}

/* Newton's step; false where the curvature is singular. */
static bool newton(const struct likelihood *l, double step[2])
{
    double det = l->h[0] * l->h[2] - l->h[1] * l->h[1];
    if (!(det > 1e-14 * l->h[0] * l->h[2]))
        return false;
    step[0] = (l->h[2] * l->g[0] - l->h[1] * l->g[1]) / det;
    step[1] = (l->h[0] * l->g[1] - l->h[1] * l->g[0]) / det;
    return true;
}

/* The counts go from none to all (or back) at one place or over one stripe: the likelihood grows without end as beta
 * goes to 0, so the curve is a step. */
static bool is_step(const struct thud_stripe *stripe, size_t n, struct thud_lognormal *out)
{
    double none_least = INFINITY, none_most = 0, all_least = INFINITY, all_most = 0, part = NAN;
    int parts = 0;
    for (size_t i = 0; i < n; i++) {
        const struct thud_stripe *s = &stripe[i];
        if (!counts(s))
            continue;
        if (s->count == 0) {
            none_least = fmin(none_least, s->x);
            none_most = fmax(none_most, s->x);
        } else if (s->count == s->n) {
            all_least = fmin(all_least, s->x);
            all_most = fmax(all_most, s->x);
        } else if (!(s->x == part)) {
            part = s->x;
            parts++;
        }
    }
    bool rising = none_most < all_least, falling = all_most < none_least;
    if (parts > 1 || all_most == 0 || none_most == 0 || !(rising || falling))
        return false;
    double low = rising ? none_most : all_most, high = rising ? all_least : none_least;
    if (parts == 1 && !(part > low && part < high))
        return false;
    *out = (struct thud_lognormal){true, falling, parts ? part : sqrt(low * high), 0};
    return true;
}

static struct thud_lognormal fit_from(const struct stripes *s, struct probit *p)
{
    enum { STEPS = 100 };
    static const double small = 1e-7; /* the step after a step like this is below 1e-14 */
    struct thud_lognormal curve = {0};
    double sum = 0, asked = 0, happened = 0, least = INFINITY, most = -INFINITY;
    int used = 0;
    for (size_t i = 0; i < s->n; i++)
        if (counts(&s->stripe[i])) {
            double t = log_x(s, i);
            used++;
            asked += s->stripe[i].n;
            happened += s->stripe[i].count;
            sum += t;
            least = fmin(least, t);
            most = fmax(most, t);
        }
    if (used < 2 || happened <= 0 || happened >= asked || !(most > least))
        return curve;
    if (is_step(s->stripe, s->n, &curve))
        return curve;
    double centre = sum / used, step[2];
    if (isnan(p->b) || p->centre != centre)
        *p = (struct probit){thud_normal_quantile(happened / asked), 0, centre};
    struct likelihood best = likelihood(p, s);
    for (int i = 0; i < STEPS && newton(&best, step); i++) {
        struct probit next = *p;
        struct likelihood there = {.sum = -INFINITY};
        for (double part = 1; part > 1e-12 && !(there.sum >= best.sum); part /= 2) {
            next.a = p->a + part * step[0];
            next.b = p->b + part * step[1];
            there = likelihood(&next, s);
        }
        if (!(there.sum >= best.sum))
            break;
        *p = next;
        best = there;
        if (fabs(step[0]) + fabs(step[1]) < small * (1 + fabs(p->a) + fabs(p->b)))
            break;
    }
    if (p->b == 0 || !isfinite(p->b))
        return curve;
    return (struct thud_lognormal){true, p->b < 0, exp(p->centre - p->a / p->b), 1 / fabs(p->b)};
}

struct thud_lognormal thud_lognormal_fit(const struct thud_stripe *stripe, size_t n)
{
    struct probit p = {NAN, NAN, NAN};
    return fit_from(&(struct stripes){stripe, NULL, n}, &p);
}

double thud_lognormal_at(const struct thud_lognormal *curve, double x)
{
    if (!curve->fitted)
        return NAN;
    double side = curve->falling ? -1 : 1, z = log(x / curve->theta);
    if (curve->beta == 0)
        return z == 0 ? 0.5 : side * z > 0 ? 1 : 0;
    return thud_normal_cdf(side * z / curve->beta);
}

/* ---- events ---- */

static enum thud_status refuse_event(const char *text, struct thud_error *err)
{
    thud_error_set(err, THUD_USAGE, "\"%.60s\" is no event", text);
    thud_error_key(err, "--event");
    thud_error_allow(err,
                     "pounding, worse, force:5MN, acceleration:1g, drift:3cm, drift:1%%, ductility:2, permanent:1cm, "
                     "column:1");
    return THUD_USAGE;
}

enum thud_status thud_event_parse(const char *text, struct thud_event *out, struct thud_error *err)
{
    static const struct {
        const char *word;
        enum thud_event_kind kind;
        bool limit;
        enum thud_dimension dimension; /* of the limit */
    } events[] = {{"pounding", THUD_EVENT_POUNDING, false, THUD_NUMBER},
                  {"worse", THUD_EVENT_WORSE, false, THUD_NUMBER},
                  {"force", THUD_EVENT_FORCE, true, THUD_FORCE},
                  {"acceleration", THUD_EVENT_ACCELERATION, true, THUD_ACCELERATION},
                  {"drift", THUD_EVENT_DRIFT, true, THUD_LENGTH},
                  {"drift", THUD_EVENT_DRIFT_ANGLE, true, THUD_RATIO},
                  {"ductility", THUD_EVENT_DUCTILITY, true, THUD_NUMBER},
                  {"permanent", THUD_EVENT_PERMANENT, true, THUD_LENGTH},
                  {"column", THUD_EVENT_COLUMN, true, THUD_NUMBER}};
    size_t word = strcspn(text, ":");
    for (size_t i = 0; i < sizeof events / sizeof *events; i++) {
        struct thud_quantity q;
        if (strlen(events[i].word) != word || strncmp(text, events[i].word, word) != 0)
            continue;
        bool limit = events[i].limit;
        if (limit != (text[word] == ':') || strlen(text) >= sizeof out->text)
            continue;
        if (limit &&
            (thud_quantity_parse(text + word + 1, events[i].dimension, NULL, &q, NULL) != THUD_OK || !(q.value > 0)))
            continue;
        *out = (struct thud_event){.kind = events[i].kind, .limit = limit ? q.value : 0};
        snprintf(out->text, sizeof out->text, "%s", text);
        return THUD_OK;
    }
    return refuse_event(text, err);
}

static int happens_in(const struct thud_event *event, const struct thud_suite *suite, int record, long setting, int k)
{
    static const double equal = 1e-9; /* relative: a ratio this near 1 is 1 */
    static const enum thud_suite_measure measure[] = {
        [THUD_EVENT_POUNDING] = THUD_SUITE_IMPACTS,    [THUD_EVENT_WORSE] = THUD_SUITE_ACCELERATION_RATIO,
        [THUD_EVENT_FORCE] = THUD_SUITE_FORCE,         [THUD_EVENT_ACCELERATION] = THUD_SUITE_ACCELERATION,
        [THUD_EVENT_DRIFT] = THUD_SUITE_DRIFT,         [THUD_EVENT_DRIFT_ANGLE] = THUD_SUITE_DRIFT_ANGLE,
        [THUD_EVENT_DUCTILITY] = THUD_SUITE_DUCTILITY, [THUD_EVENT_PERMANENT] = THUD_SUITE_PERMANENT,
        [THUD_EVENT_COLUMN] = THUD_SUITE_COLUMNS};
    double value = thud_suite_value(suite, record, setting, k, measure[event->kind], -1);
    double limit = event->kind == THUD_EVENT_WORSE ? 1 + equal : event->limit;
    if (isnan(value)) /* a ratio is missing where there is nothing to compare, an answer where a run has none */
        return -1;
    return value > limit;
}

/* ---- counts over a suite ---- */

/* 5 and 95 % of the numbers among n values, sorted in place; NaN where less than half are numbers. */
static void band(double *value, size_t n, double *low, double *high)
{
    size_t m = thud_sort_numbers(value, n);
    *low = 2 * m >= n && m > 0 ? thud_quantile(value, m, 0.05, false) : NAN;
    *high = 2 * m >= n && m > 0 ? thud_quantile(value, m, 0.95, false) : NAN;
}

/* Draws motions with replacement and fits again. `happens`: (records x n). */
static enum thud_status bootstrap(const signed char *happens, int nrecords, const struct thud_fragility_ask *ask,
                                  struct thud_fragility *f, struct thud_error *err)
{
    size_t samples = (size_t)ask->samples, n = f->n;
    double *value = malloc((n + 2) * samples * sizeof *value); /* curves at each x, then theta, then beta */
    struct thud_stripe *stripe = malloc(n * sizeof *stripe);
    double *logs = malloc(n * sizeof *logs);
    struct thud_random random = {ask->seed};
    struct probit start = {NAN, NAN, NAN};
    if (!value || !stripe || !logs) {
        free(value);
        free(stripe);
        free(logs);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    for (size_t i = 0; i < n; i++)
        logs[i] = log(f->stripe[i].x);
    (void)fit_from(&(struct stripes){f->stripe, logs, n}, &start);
    for (size_t b = 0; b < samples; b++) {
        for (size_t i = 0; i < n; i++)
            stripe[i] = (struct thud_stripe){f->stripe[i].x, 0, 0};
        for (int r = 0; r < nrecords; r++) {
            const signed char *h = happens + thud_random_below(&random, (size_t)nrecords) * n;
            for (size_t i = 0; i < n; i++) {
                stripe[i].n += h[i] >= 0;
                stripe[i].count += h[i] > 0;
            }
        }
        struct probit p = start;
        struct thud_lognormal curve = fit_from(&(struct stripes){stripe, logs, n}, &p);
        bool ever = false;
        for (size_t i = 0; i < n; i++)
            ever |= stripe[i].count > 0;
        for (size_t i = 0; i < n; i++) /* where there is no curve nothing ever happened, or everything */
            value[i * samples + b] = curve.fitted ? thud_lognormal_at(&curve, stripe[i].x) : ever;
        value[n * samples + b] = curve.fitted ? curve.theta : NAN;
        value[(n + 1) * samples + b] = curve.fitted ? curve.beta : NAN;
    }
    for (size_t i = 0; i < n; i++)
        band(value + i * samples, samples, &f->low[i], &f->high[i]);
    band(value + n * samples, samples, &f->theta_low, &f->theta_high);
    band(value + (n + 1) * samples, samples, &f->beta_low, &f->beta_high);
    free(value);
    free(stripe);
    free(logs);
    return THUD_OK;
}

enum thud_status thud_fragility_make(const struct thud_suite *suite, const struct thud_fragility_ask *ask,
                                     struct thud_fragility *out, struct thud_error *err)
{
    const struct thud_sweep_axis *axis = &suite->plan->axis[ask->axis];
    size_t n = (size_t)axis->n;
    int at[THUD_VARY_MAX];
    *out = (struct thud_fragility){.n = n, .theta_low = NAN, .theta_high = NAN, .beta_low = NAN, .beta_high = NAN};
    out->stripe = calloc(n, sizeof *out->stripe);
    out->low = malloc(2 * n * sizeof *out->low);
    signed char *happens = malloc((size_t)suite->nrecords * n);
    if (!out->stripe || !out->low || !happens) {
        free(happens);
        thud_fragility_clear(out);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    out->high = out->low + n;
    memcpy(at, ask->at, sizeof at);
    for (size_t i = 0; i < n; i++) {
        at[ask->axis] = (int)i;
        long setting = thud_suite_setting(suite->plan, at);
        out->stripe[i].x = axis->value[i];
        out->low[i] = out->high[i] = NAN;
        for (int r = 0; r < suite->nrecords; r++) {
            int h = happens_in(ask->event, suite, r, setting, ask->k);
            happens[(size_t)r * n + i] = (signed char)h;
            out->stripe[i].n += h >= 0;
            out->stripe[i].count += h > 0;
        }
    }
    out->curve = thud_lognormal_fit(out->stripe, n);
    enum thud_status status = THUD_OK;
    if (out->curve.fitted && ask->samples > 0)
        status = bootstrap(happens, suite->nrecords, ask, out, err);
    free(happens);
    if (status != THUD_OK)
        thud_fragility_clear(out);
    return status;
}

void thud_fragility_clear(struct thud_fragility *fragility)
{
    free(fragility->stripe);
    free(fragility->low);
    *fragility = (struct thud_fragility){0};
}

/* ---- hazard ---- */

double thud_hazard_rate(const struct thud_hazard *hazard, const struct thud_lognormal *curve)
{
    double rate = 0;
    if (!curve->fitted || curve->falling || hazard->n == 0)
        return NAN;
    for (size_t i = 0; i + 1 < hazard->n; i++)
        rate += thud_lognormal_at(curve, sqrt(hazard->x[i] * hazard->x[i + 1])) *
                fabs(hazard->rate[i] - hazard->rate[i + 1]);
    return rate + thud_lognormal_at(curve, hazard->x[hazard->n - 1]) * hazard->rate[hazard->n - 1];
}

double thud_hazard_probability(double rate, double years)
{
    return -expm1(-rate * years);
}

void thud_hazard_clear(struct thud_hazard *hazard)
{
    free(hazard->x);
    free(hazard->rate);
    *hazard = (struct thud_hazard){0};
}
