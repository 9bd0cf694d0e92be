#include "study/suite/fragility.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "base/random.h"
#include "base/statistics.h"
#include "base/text.h"
#include "study/scene/gap_rule.h"
#include "study/scene/scene_elements.h"
#include "study/scene/scene_words.h"

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

/* The counts go from none to all (or back) over one stripe at most: as beta goes to 0 the likelihood has no bound. */
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
    if (parts > 1 || (parts == 0 && (all_most == 0 || none_most == 0)) || !(rising || falling))
        return false;
    if (parts == 1) { /* what is neither lies between the others, where there are any */
        rising = part > none_most && part < all_least;
        falling = part > all_most && part < none_least;
        if (!rising && !falling)
            return false;
    }
    double low = rising ? none_most : all_most, high = rising ? all_least : none_least;
    *out = (struct thud_lognormal){THUD_FIT_SEPARATED, !rising, parts ? part : sqrt(low * high), 0, NAN};
    return true;
}

static struct thud_lognormal fit_from(const struct stripes *s, struct probit *p)
{
    enum { STEPS = 100 };
    static const double small = 1e-7; /* the step after a step like this is below 1e-14 */
    struct thud_lognormal curve = {.fit = THUD_FIT_NONE, .theta = NAN, .beta = NAN, .p = NAN};
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
    if (used > 0 && (happened <= 0 || happened >= asked))
        curve.fit = happened > 0 ? THUD_FIT_ALWAYS : THUD_FIT_NEVER;
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
    if (p->b == 0 || !isfinite(p->b)) { /* as many at every value: no median */
        curve.fit = THUD_FIT_REJECTED;
        return curve;
    }
    return (struct thud_lognormal){THUD_FIT_CURVE, p->b < 0, exp(p->centre - p->a / p->b), 1 / fabs(p->b), NAN};
}

/* Also of counts that separate, whose curve is a step. */
static double curve_at(const struct thud_lognormal *curve, double x)
{
    double side = curve->falling ? -1 : 1, z = log(x / curve->theta);
    if (curve->beta == 0)
        return z == 0 ? 0.5 : side * z > 0 ? 1 : 0;
    return thud_normal_cdf(side * z / curve->beta);
}

double thud_lognormal_at(const struct thud_lognormal *curve, double x)
{
    return thud_is_fitted(curve) ? curve_at(curve, x) : NAN;
}

/* Deviance D = 2 sum(k ln(k / (n P)) + (n - k) ln((n - k) / (n (1 - P)))), chi-square of as many degrees of freedom as
 * there are stripes less the two parameters (McCullagh and Nelder, Generalized Linear Models, 1989, 4.4). Stripes that
 * share their motions deviate together, which makes D smaller, so a curve that is rejected does not hold. */
static double deviance_p(const struct thud_lognormal *curve, const struct thud_stripe *stripe, size_t n)
{
    double sum = 0;
    int free = -2;
    for (size_t i = 0; i < n; i++) {
        const struct thud_stripe *s = &stripe[i];
        if (!counts(s))
            continue;
        struct thud_lognormal other = *curve;
        other.falling = !curve->falling;
        double p = curve_at(curve, s->x), q = curve_at(&other, s->x), yes = s->count, no = s->n - s->count;
        free++;
        sum += yes > 0 ? 2 * yes * log(yes / (s->n * p)) : 0;
        sum += no > 0 ? 2 * no * log(no / (s->n * q)) : 0;
    }
    return free > 0 ? thud_chi_square_tail(sum, free) : NAN;
}

struct thud_lognormal thud_lognormal_fit(const struct thud_stripe *stripe, size_t n)
{
    static const double rejected = 0.05;
    struct probit p = {NAN, NAN, NAN};
    struct thud_lognormal curve = fit_from(&(struct stripes){stripe, NULL, n}, &p);
    if (thud_is_fitted(&curve)) {
        curve.p = deviance_p(&curve, stripe, n);
        curve.fit = curve.p < rejected ? THUD_FIT_REJECTED : THUD_FIT_CURVE;
    }
    return curve;
}

const char *thud_fit_name(enum thud_fit fit)
{
    static const char *const name[] = {"none", "counted", "never", "always", "separated", "rejected", "curve"};
    return name[fit];
}

/* Bounds of the median of counts that rise or fall: the values with less and with more than half of the motions next to
 * it. */
static void median_bounds(const struct thud_stripe *stripe, size_t n, bool falling, double *above, double *below)
{
    *above = 0;
    *below = INFINITY;
    for (size_t i = 0; i < n; i++) {
        const struct thud_stripe *s = &stripe[i];
        if (!counts(s) || 2 * s->count == s->n)
            continue;
        if ((2 * s->count > s->n) == falling)
            *above = fmax(*above, s->x);
        else
            *below = fmin(*below, s->x);
    }
    if (*above == 0 && isinf(*below))
        *above = *below = NAN;
}

/* ---- events ---- */

void thud_events_list(enum thud_event_form form, struct thud_text *out)
{
    static const char *const between[] = {":", "=", " < "};
    const size_t start = out->size;
    for (enum thud_measure m = 0; m < THUD_MEASURES; m++) {
        const struct thud_measure_info *info = thud_measure_info(m);
        const char *word = info->event.word, *example = info->event.example;
        /* a ratio to another case is an event of a study of cases, and no criterion */
        if (!word || (!example && form == THUD_FORM_LIMIT) || (info->ratio_of && form == THUD_FORM_CRITERION))
            continue;
        thud_text_append(out, "%s%s%s%s%s", out->size > start ? ", " : "",
                         !example && form == THUD_FORM_CRITERION ? "no " : "", word, example ? between[form] : "",
                         example ? example : "");
    }
}

/* `between` a word and its limit; of limits alone `=`. */
static enum thud_status refuse_event(const char *text, char between, struct thud_error *err)
{
    const bool limits = between == '=';
    struct thud_text allowed = {0};
    thud_events_list(limits ? THUD_FORM_LIMIT : THUD_FORM_EVENT, &allowed);
    enum thud_status status =
        thud_error_refuse(err, THUD_USAGE, limits ? "--limit" : "--event", allowed.failed ? "" : allowed.data,
                          limits ? "\"%.60s\" is not a limit" : "\"%.60s\" is not an event", text);
    thud_text_clear(&allowed);
    return status;
}

static enum thud_status parse(const char *text, char between, struct thud_event *out, struct thud_error *err)
{
    const size_t word = strcspn(text, between == '=' ? ":=" : ":");
    for (enum thud_measure m = 0; m < THUD_MEASURES && strlen(text) < sizeof out->text; m++) {
        const struct thud_measure_info *info = thud_measure_info(m);
        struct thud_quantity q = {.value = info->event.limit};
        const char *own = info->event.word, *limit = info->event.example;
        if (!own || strlen(own) != word || strncmp(text, own, word) != 0 || (limit != NULL) != (text[word] != '\0'))
            continue;
        if (limit && (thud_quantity_parse(text + word + 1, info->kind, NULL, &q, NULL) != THUD_OK || !(q.value > 0)))
            continue;
        *out = (struct thud_event){.measure = m, .limit = q.value};
        snprintf(out->text, sizeof out->text, "%s", text);
        return THUD_OK;
    }
    return refuse_event(text, between, err);
}

enum thud_status thud_event_parse(const char *text, struct thud_event *out, struct thud_error *err)
{
    return parse(text, ':', out, err);
}

static enum thud_status parse_limit(const char *text, struct thud_event *out, struct thud_error *err)
{
    enum thud_status status = parse(text, '=', out, err);
    return status == THUD_OK && !thud_measure_info(out->measure)->event.example ? refuse_event(text, '=', err) : status;
}

enum thud_status thud_events_parse(const char *list, struct thud_event *out, int *n, struct thud_error *err)
{
    char copy[THUD_VARY_TEXT + 3], *item[THUD_EVENTS_MAX];
    const char *given = *list ? list : "pounding,worse";
    enum thud_status status = THUD_OK;
    snprintf(copy, sizeof copy, *given == '[' ? "%s" : "[%s]", given);
    const int count = thud_list_split(copy, item, THUD_EVENTS_MAX);
    *n = 0;
    if (count > THUD_EVENTS_MAX)
        return thud_error_set(err, THUD_USAGE, "more than %d events", THUD_EVENTS_MAX);
    if (count < 0)
        return thud_event_parse(given, out, err);
    while (status == THUD_OK && *n < count) {
        status = thud_event_parse(item[*n], &out[*n], err);
        ++*n;
    }
    return status;
}

enum thud_status thud_limits_parse(const char *list, struct thud_event limit[THUD_MEASURES], struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    char text[64];
    for (size_t n; status == THUD_OK && *list; list += n + (list[n] == ',')) {
        struct thud_event one;
        list += strspn(list, " ");
        n = strcspn(list, ",");
        snprintf(text, sizeof text, "%.*s", (int)n, list);
        status = parse_limit(text, &one, err);
        for (enum thud_measure m = 0; status == THUD_OK && m < THUD_MEASURES; m++) {
            const char *word = thud_measure_info(m)->event.word;
            if (word && strcmp(word, thud_measure_info(one.measure)->event.word) == 0)
                limit[m].text[0] = '\0';
        }
        if (status == THUD_OK)
            limit[one.measure] = one;
    }
    return status;
}

enum thud_status thud_words_check(const struct thud_scene *scene, struct thud_error *err)
{
    struct thud_event event[THUD_EVENTS_MAX], limit[THUD_MEASURES];
    const char *code = scene->document.code;
    int n;
    if (thud_events_parse(scene->study.events, event, &n, err) != THUD_OK)
        thud_error_key(err, "study.events");
    else if (thud_limits_parse(scene->document.limits, limit, err) != THUD_OK)
        thud_error_key(err, "document.limits");
    else if (*code && !thud_gap_practice_find(code))
        return thud_error_refuse(err, THUD_INPUT, "document.code", "en1998, asce7, exact84",
                                 "\"%.30s\" is not a code for the gap", code);
    else
        return THUD_OK;
    if (err)
        err->status = THUD_INPUT;
    return THUD_INPUT;
}

/* Whether an intensity makes it more likely, or a gap pounding less. Floor accelerations and permanent drifts go up and
 * down, and so does what a bumper makes of them. */
static bool is_monotone(enum thud_measure measure, const struct thud_sweep_axis *axis)
{
    const char *last = strrchr(axis->key, '.');
    bool gap = strcmp(last ? last + 1 : axis->key, "gap") == 0;
    return !thud_measure_info(measure)->event.not_monotone && (gap || thud_axis_is_intensity(axis));
}

bool thud_axis_is_drawn(const struct thud_sweep_axis *axis)
{
    return !axis->words && axis->n > 1;
}

bool thud_axis_is_intensity(const struct thud_sweep_axis *axis)
{
    static const char *const keys[] = {"record.peak", "record.sa", "record.factor"};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (strcmp(axis->key, keys[i]) == 0)
            return true;
    return false;
}

static int happens_in(const struct thud_event *event, const struct thud_suite *suite, int record, long setting, int k)
{
    double value = thud_suite_value(suite, record, setting, k, event->measure, -1);
    if (isnan(value)) /* a ratio is missing where there is nothing to compare, a result where a run has none */
        return -1;
    return value > event->limit;
}

/* ---- hazard ---- */

/* lambda(x); INFINITY before the first point, where it is not known, and the last rate beyond the last one. */
static double rate_at(const struct thud_hazard *h, double x)
{
    if (!(x >= h->x[0]))
        return INFINITY;
    for (size_t i = 0; i + 1 < h->n; i++)
        if (x <= h->x[i + 1])
            return h->rate[i] * pow(h->rate[i + 1] / h->rate[i], log(x / h->x[i]) / log(h->x[i + 1] / h->x[i]));
    return h->rate[h->n - 1];
}

/* int P |d lambda| over lambda = lambda_0 (x / x_0)^-k from x_0 to x_1, by Gauss-Legendre in ln x on pieces over which
 * neither factor changes much. */
static double over_interval(const struct thud_lognormal *curve, double x0, double x1, double rate0, double k)
{
    enum { POINTS = 5, PIECES_MAX = 100000 };
    static const double node[POINTS] = {-0.90617984593866399, -0.53846931010568309, 0, 0.53846931010568309,
                                        0.90617984593866399},
                        weight[POINTS] = {0.23692688505618909, 0.47862867049936647, 0.56888888888888889,
                                          0.47862867049936647, 0.23692688505618909};
    double length = log(x1 / x0), sum = 0;
    double wanted = ceil(fmax(2 * length / curve->beta, 2 * k * length));
    int pieces = (int)fmax(1, fmin(PIECES_MAX, wanted));
    for (int i = 0; i < pieces; i++)
        for (int j = 0; j < POINTS; j++) {
            double s = length * (i + 0.5 + 0.5 * node[j]) / pieces;
            sum += 0.5 * length / pieces * weight[j] * k * rate0 * exp(-k * s) * curve_at(curve, x0 * exp(s));
        }
    return sum;
}

/* Difference of two bounds, relative to the upper one, below which one number is reported. */
static const double told_as_one = 0.01;

/* Of a rising curve. */
static struct thud_rate rate_of_curve(const struct thud_hazard *h, const struct thud_lognormal *curve)
{
    size_t last = h->n - 1;
    double inside = 0, k = 0;
    for (size_t i = 0; i < last; i++) {
        k = log(h->rate[i] / h->rate[i + 1]) / log(h->x[i + 1] / h->x[i]);
        inside += k > 0 ? over_interval(curve, h->x[i], h->x[i + 1], h->rate[i], k) : 0;
    }
    double end = curve_at(curve, h->x[last]);
    struct thud_rate out = {inside + end * h->rate[last], NAN, inside + h->rate[last], NAN, NAN};
    /* before the first point the rate goes on as it does from there: it counts where that adds anything to speak of */
    double first = log(h->rate[0] / h->rate[1]) / log(h->x[1] / h->x[0]);
    double from = fmin(h->x[0], curve->theta * exp(-40 * curve->beta));
    double before =
        from < h->x[0] ? over_interval(curve, from, h->x[0], h->rate[0] * pow(from / h->x[0], -first), first) : 0;
    out.most = before > told_as_one * out.most ? INFINITY : out.most + before;
    if (isfinite(out.most) && out.most - out.least <= told_as_one * out.most)
        out.value = 0.5 * (out.least + out.most);
    return out;
}

/* Each motion is as likely: the mean of the rates at which their values are exceeded. */
static struct thud_rate rate_of_exact(const struct thud_hazard *h, const double *exact, size_t n)
{
    struct thud_rate out = {0, NAN, 0, NAN, NAN};
    for (size_t r = 0; r < n; r++) {
        const double most = rate_at(h, exact[r]);
        out.most += most / (double)n;
        out.least += (exact[r] > h->x[h->n - 1] ? 0 : exact[r] < h->x[0] ? h->rate[0] : most) / (double)n;
    }
    if (isfinite(out.most) && out.most - out.least <= told_as_one * out.most)
        out.value = 0.5 * (out.least + out.most);
    return out;
}

static struct thud_rate rate_without_band(const struct thud_hazard *hazard, const struct thud_fragility *f)
{
    static const struct thud_rate unknown = {NAN, NAN, NAN, NAN, NAN};
    if (hazard->n < 2)
        return unknown;
    if (f->nexact > 0 && f->clearing == 0)
        return rate_of_exact(hazard, f->exact, (size_t)f->nexact);
    if (thud_is_fitted(&f->curve))
        return isnan(f->theta) || f->curve.falling ? unknown : rate_of_curve(hazard, &f->curve);
    if (isnan(f->above) || (f->curve.fit == THUD_FIT_SEPARATED && f->curve.falling))
        return unknown;
    /* it begins above `none` and from `all` on it always happens */
    double none = f->curve.fit == THUD_FIT_NEVER ? f->most : 0,
           all = f->curve.fit == THUD_FIT_ALWAYS ? f->least : INFINITY;
    for (size_t i = 0; f->curve.fit == THUD_FIT_SEPARATED && i < f->n; i++) {
        const struct thud_stripe *s = &f->stripe[i];
        none = s->n > 0 && s->count == 0 ? fmax(none, s->x) : none;
        all = s->n > 0 && s->count == s->n ? fmin(all, s->x) : all;
    }
    double low = all > hazard->x[hazard->n - 1] ? 0 : all < hazard->x[0] ? hazard->rate[0] : rate_at(hazard, all);
    return (struct thud_rate){low, NAN, none > 0 ? rate_at(hazard, none) : INFINITY, NAN, NAN};
}

struct thud_rate thud_hazard_rate(const struct thud_hazard *hazard, const struct thud_fragility *f)
{
    struct thud_rate rate = rate_without_band(hazard, f);
    if (!isnan(rate.value)) {
        rate.low = f->rate_low;
        rate.high = f->rate_high;
    }
    return rate;
}

/* ---- counts over a suite ---- */

/* `tail` and 1 - tail of the numbers among n values, sorted in place; NaN where less than half are numbers. */
static void band(double *value, size_t n, double tail, double *low, double *high)
{
    size_t m = thud_sort_numbers(value, n);
    *low = 2 * m >= n && m > 0 ? thud_quantile(value, m, tail, false) : NAN;
    *high = 2 * m >= n && m > 0 ? thud_quantile(value, m, 1 - tail, false) : NAN;
}

/* Draws motions with replacement, both signs of one together, and fits again. `happens`: (records x n). */
static enum thud_status bootstrap(const signed char *happens, const struct thud_suite *suite,
                                  const struct thud_fragility_ask *ask, struct thud_fragility *f,
                                  struct thud_error *err)
{
    size_t samples = (size_t)ask->samples, n = f->n;
    struct thud_stripe *stripe = malloc(n * sizeof *stripe);
    double *value = malloc(((n + 3) * samples + n) * sizeof *value); /* curves at each x, theta, beta, annual rate */
    double *logs = value + (n + 3) * samples, *rate = value + (n + 2) * samples;
    struct thud_random random = {ask->seed};
    struct probit start = {NAN, NAN, NAN};
    if (!value || !stripe) {
        free(value);
        free(stripe);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    for (size_t i = 0; i < n; i++)
        logs[i] = log(f->stripe[i].x);
    (void)fit_from(&(struct stripes){f->stripe, logs, n}, &start);
    for (size_t b = 0; b < samples; b++) {
        int asked = 0, happened = 0;
        for (size_t i = 0; i < n; i++)
            stripe[i] = (struct thud_stripe){f->stripe[i].x, 0, 0};
        for (int d = 0; d < suite->ndraws; d++) {
            int drawn = (int)thud_random_below(&random, (size_t)suite->ndraws);
            for (int r = suite->first[drawn]; r < suite->first[drawn + 1]; r++) {
                const signed char *h = happens + (size_t)suite->motion[r] * n;
                for (size_t i = 0; i < n; i++) {
                    stripe[i].n += h[i] >= 0;
                    stripe[i].count += h[i] > 0;
                }
            }
        }
        for (size_t i = 0; i < n; i++) {
            asked += stripe[i].n;
            happened += stripe[i].count;
        }
        struct probit p = start;
        struct thud_lognormal curve = fit_from(&(struct stripes){stripe, logs, n}, &p);
        bool none = isnan(curve.theta), ever = happened > 0;
        for (size_t i = 0; i < n; i++)
            value[i * samples + b] =
                none ? (asked > 0 ? (double)happened / asked : NAN) : curve_at(&curve, stripe[i].x);
        /* the median of what never happens lies above every intensity, and below every gap */
        value[n * samples + b] = !none ? curve.theta : ever == f->curve.falling ? INFINITY : 0;
        value[(n + 1) * samples + b] = curve.beta;
        rate[b] =
            ask->hazard && thud_is_fitted(&curve) && !curve.falling ? rate_of_curve(ask->hazard, &curve).value : NAN;
    }
    for (size_t i = 0; i < n; i++)
        band(value + i * samples, samples, 0.05, &f->low[i], &f->high[i]);
    band(value + n * samples, samples, 0.05, &f->theta_low, &f->theta_high);
    band(value + (n + 1) * samples, samples, 0.05, &f->beta_low, &f->beta_high);
    band(rate, samples, 0.16, &f->rate_low, &f->rate_high);
    free(value);
    free(stripe);
    return THUD_OK;
}

/* A fit that may be reported, and where the median lies. */
static void conclude(struct thud_fragility *f, enum thud_measure measure, const struct thud_sweep_axis *axis)
{
    f->curve = thud_lognormal_fit(f->stripe, f->n);
    bool falls = !thud_axis_is_intensity(axis), never = f->curve.fit == THUD_FIT_NEVER;
    bool same = never || f->curve.fit == THUD_FIT_ALWAYS, monotone = is_monotone(measure, axis);
    bool directed = monotone && (!falls || measure == THUD_MEASURE_IMPACTS); /* a force may grow with a gap, too */
    if (f->curve.fit == THUD_FIT_NONE)
        return;
    if (!same && !monotone)
        f->curve.fit = THUD_FIT_COUNTED;
    else if (!same && directed && f->curve.falling != falls)
        f->curve.fit = THUD_FIT_REJECTED;
    if (thud_is_fitted(&f->curve) && f->curve.theta >= f->least && f->curve.theta <= f->most) {
        f->theta = f->curve.theta;
    } else if (thud_is_fitted(&f->curve)) {
        f->above = f->curve.theta > f->most ? f->most : 0;
        f->below = f->curve.theta > f->most ? INFINITY : f->least;
    } else if (f->curve.fit == THUD_FIT_SEPARATED || (same && directed)) {
        median_bounds(f->stripe, f->n, same ? falls : f->curve.falling, &f->above, &f->below);
    }
}

/* The first value above 0 along the axis at which the run of a case has a result, its setting and what it uses up of
 * the clearances; -1: none has. */
static int first_result(const struct thud_suite *suite, const struct thud_fragility_ask *ask, int k, int record,
                        long *setting, double *used)
{
    const struct thud_sweep_axis *axis = &suite->plan->axis[ask->axis];
    int at[THUD_VARY_MAX];
    memcpy(at, ask->at, sizeof at);
    for (int i = 0; i < axis->n; i++) {
        at[ask->axis] = i;
        *setting = thud_suite_setting(suite->plan, at);
        *used = thud_suite_value(suite, record, *setting, k, THUD_MEASURE_USED, -1);
        if (!isnan(*used) && axis->value[i] > 0)
            return i;
    }
    return -1;
}

/* The gap at which a motion no longer causes contact, which changes no motion without pounding; NaN: not known. */
static double enough_gap(const struct thud_suite *suite, const struct thud_fragility_ask *ask, int k, int record)
{
    long setting;
    double used;
    const int i = first_result(suite, ask, k, record, &setting, &used);
    return i < 0 ? NAN
                 : suite->plan->axis[ask->axis].value[i] +
                       thud_suite_value(suite, record, setting, k, THUD_MEASURE_SHORT, -1);
}

/* The least intensity at which a motion causes contact, NaN: not known; and as a factor on the motion. From one run
 * where the motion without pounding scales with it, else by runs. */
static enum thud_status begin_of_contact(const struct thud_suite *suite, const struct thud_fragility_ask *ask,
                                         int record, struct thud_scene *scene, double *x,
                                         struct thud_first_contact *out, struct thud_error *err)
{
    const struct thud_sweep_plan *plan = suite->plan;
    const struct thud_record *motion = plan->nrecords > 0 ? plan->record[record] : NULL;
    struct thud_needed_gap *gap = NULL;
    long setting;
    double used, factor = 1;
    const int i = first_result(suite, ask, ask->k, record, &setting, &used);
    *x = out->first = out->clear_again = NAN;
    if (i < 0)
        return THUD_OK;
    const double value = plan->axis[ask->axis].value[i];
    enum thud_status status = thud_sweep_scene(plan, record * suite->settings + setting, scene, err);
    if (status == THUD_OK && motion)
        status = thud_sweep_motion_factor(plan, scene, motion, &factor, err);
    if (status == THUD_OK)
        status = thud_scene_case(scene, plan->cases[ask->k], scene, err);
    if (status == THUD_OK && (!motion || thud_scene_scales(scene))) {
        *x = used > 0 ? value / used : INFINITY;
        out->first = used > 0 ? factor / used : INFINITY;
        return THUD_OK;
    }
    if (status == THUD_OK && motion->samples == 0) /* known by its name alone */
        return THUD_OK;
    if (status == THUD_OK)
        status = thud_needed_gap_run(scene, motion, &gap, err);
    if (status == THUD_OK)
        status = thud_first_contact_find(scene, motion, gap, out, err);
    if (status == THUD_OK)
        *x = value * out->first / factor;
    free(gap);
    return status == THUD_DIVERGED ? THUD_OK : status; /* it is not known */
}

/* Of each motion: (nrecords). */
static enum thud_status thresholds(const struct thud_suite *suite, const struct thud_fragility_ask *ask, double *own,
                                   struct thud_fragility *f, struct thud_error *err)
{
    const bool intensity = thud_axis_is_intensity(&suite->plan->axis[ask->axis]);
    struct thud_scene *scene = intensity ? malloc(sizeof *scene) : NULL;
    enum thud_status status = THUD_OK;
    f->contact = intensity ? malloc((size_t)suite->nrecords * sizeof *f->contact) : NULL;
    if (intensity && (!scene || !f->contact))
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int r = 0; r < suite->nrecords && status == THUD_OK; r++)
        if (intensity) {
            status = begin_of_contact(suite, ask, r, scene, &own[r], &f->contact[r], err);
            f->clearing += !isnan(f->contact[r].clear_again);
        } else {
            own[r] = enough_gap(suite, ask, ask->k, r);
        }
    free(scene);
    return status;
}

static bool is_gap(const struct thud_suite *suite, const struct thud_sweep_axis *axis)
{
    return suite->nstructures == 2 && is_monotone(THUD_MEASURE_IMPACTS, axis) && !thud_axis_is_intensity(axis);
}

static double free_gap(const struct thud_suite *suite, const struct thud_fragility_ask *ask)
{
    double widest = -INFINITY;
    for (int k = 0; k < suite->plan->ncases && is_gap(suite, &suite->plan->axis[ask->axis]); k++)
        for (int r = 0; suite->plan->cases[k] == THUD_CASE_NONE && r < suite->nrecords; r++) {
            const double own = enough_gap(suite, ask, k, r);
            widest = isnan(own) ? (double)INFINITY : fmax(widest, own);
        }
    return isfinite(widest) ? widest : (double)NAN;
}

static enum thud_status find_exact(const struct thud_suite *suite, const struct thud_fragility_ask *ask,
                                   struct thud_fragility *f, struct thud_error *err)
{
    const struct thud_sweep_axis *axis = &suite->plan->axis[ask->axis];
    bool intensity = thud_axis_is_intensity(axis);
    size_t n = (size_t)suite->nrecords, count, samples = suite->ndraws >= THUD_DRAWS_LEAST ? (size_t)ask->samples : 0;
    f->exact16 = f->exact50 = f->exact84 = f->exact_low = f->exact_high = NAN;
    if (ask->event->measure != THUD_MEASURE_IMPACTS || !(intensity ? ask->first_contact : is_gap(suite, axis)))
        return THUD_OK;
    int most = 1; /* motions of a recording: as many may be drawn each time */
    for (int d = 0; d < suite->ndraws; d++)
        most = suite->first[d + 1] - suite->first[d] > most ? suite->first[d + 1] - suite->first[d] : most;
    double *own = malloc((n + (size_t)(most * suite->ndraws) + 2 * samples + 1) * sizeof *own), *drawn = own + n,
           *median = drawn + most * suite->ndraws, *rate = median + samples;
    struct thud_random random = {ask->seed};
    if (!own)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = thresholds(suite, ask, own, f, err);
    for (size_t r = 0; r < n && status == THUD_OK; r++)
        if (isnan(own[r])) {
            free(own);
            return THUD_OK;
        }
    if (status != THUD_OK) {
        free(own);
        return status;
    }
    for (size_t b = 0; b < samples; b++) {
        size_t m = 0;
        for (int d = 0; d < suite->ndraws; d++) {
            int g = (int)thud_random_below(&random, (size_t)suite->ndraws);
            for (int r = suite->first[g]; r < suite->first[g + 1]; r++)
                drawn[m++] = own[suite->motion[r]];
        }
        thud_sort_numbers(drawn, m);
        median[b] = thud_enough(drawn, m, 0.5, &count);
        rate[b] = ask->hazard && intensity && f->clearing == 0 ? rate_of_exact(ask->hazard, drawn, m).value : NAN;
    }
    if (samples > 0) {
        band(median, samples, 0.05, &f->exact_low, &f->exact_high);
        band(rate, samples, 0.16, &f->rate_low, &f->rate_high);
    }
    thud_sort_numbers(own, n);
    f->exact = own;
    f->nexact = suite->nrecords;
    f->exact50 = thud_enough(own, n, 0.5, &count);
    if (suite->ndraws >= THUD_SHARES_LEAST) {
        f->exact16 = thud_enough(own, n, 0.16, &count);
        f->exact84 = thud_enough(own, n, 0.84, &count);
    }
    return THUD_OK;
}

enum thud_status thud_fragility_make(const struct thud_suite *suite, const struct thud_fragility_ask *ask,
                                     struct thud_fragility *out, struct thud_error *err)
{
    const struct thud_sweep_axis *axis = &suite->plan->axis[ask->axis];
    size_t n = (size_t)axis->n;
    int at[THUD_VARY_MAX];
    *out = (struct thud_fragility){.n = n,
                                   .least = INFINITY,
                                   .theta = NAN,
                                   .above = NAN,
                                   .below = NAN,
                                   .theta_low = NAN,
                                   .theta_high = NAN,
                                   .beta_low = NAN,
                                   .beta_high = NAN,
                                   .rate_low = NAN,
                                   .rate_high = NAN};
    out->stripe = calloc(n, sizeof *out->stripe);
    out->low = malloc(4 * n * sizeof *out->low);
    signed char *happens = malloc((size_t)suite->nrecords * n);
    if (!out->stripe || !out->low || !happens) {
        free(happens);
        thud_fragility_clear(out);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    out->high = out->low + n;
    out->share_low = out->high + n;
    out->share_high = out->share_low + n;
    memcpy(at, ask->at, sizeof at);
    for (size_t i = 0; i < n; i++) {
        at[ask->axis] = (int)i;
        long setting = thud_suite_setting(suite->plan, at);
        struct thud_stripe *s = &out->stripe[i];
        s->x = axis->value[i];
        out->low[i] = out->high[i] = NAN;
        for (int r = 0; r < suite->nrecords; r++) {
            int h = happens_in(ask->event, suite, r, setting, ask->k);
            happens[(size_t)r * n + i] = (signed char)h;
            s->n += h >= 0;
            s->count += h > 0;
        }
        out->least = s->x > 0 ? fmin(out->least, s->x) : out->least;
        out->most = fmax(out->most, s->x);
        thud_suite_share_band(suite, (size_t)s->count, (size_t)s->n, &out->share_low[i], &out->share_high[i]);
    }
    conclude(out, ask->event->measure, axis);
    enum thud_status status = THUD_OK;
    if (thud_is_fitted(&out->curve) && ask->samples > 0 && suite->ndraws >= THUD_DRAWS_LEAST)
        status = bootstrap(happens, suite, ask, out, err);
    if (status == THUD_OK)
        status = find_exact(suite, ask, out, err);
    out->free_gap = free_gap(suite, ask);
    free(happens);
    if (status != THUD_OK)
        thud_fragility_clear(out);
    return status;
}

void thud_fragility_clear(struct thud_fragility *fragility)
{
    free(fragility->stripe);
    free(fragility->low);
    free(fragility->exact);
    free(fragility->contact);
    *fragility = (struct thud_fragility){0};
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
