/* How likely something is: counts over a suite of ground motions, and, where they allow it, a lognormal curve through
 * them by maximum likelihood
 *
 *     P(x) = Phi(ln(x / theta) / beta)         rising (against an intensity), or
 *     P(x) = Phi(-ln(x / theta) / beta)        falling (against a gap)
 *
 * after Baker, "Efficient analytical fragility function fitting using dynamic structural analysis", Earthquake Spectra
 * 31 (2015) 579-599: the counts are binomial, and the likelihood of all stripes together is made largest; a band for it
 * by the bootstrap over the ground motions; and with a hazard curve the annual rate. Motions are taken as independent,
 * but the two signs of one are sampled jointly. A curve is reported only for events that become more likely with the
 * intensity (less likely with the gap), if the likelihood has a maximum and the deviance does not reject the curve.
 * Otherwise only the counts are known. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"
#include "study/scene/first_contact.h"
#include "study/suite/suite.h"

/* Stripe: of n motions at x, `count` caused the event. */
struct thud_stripe {
    double x; /* > 0 */
    int n, count;
};

enum thud_fit {
    THUD_FIT_NONE,      /* fewer than two values have a result */
    THUD_FIT_COUNTED,   /* the event need not be monotone in what is varied: none is tried */
    THUD_FIT_NEVER,     /* it happens under no motion at any value */
    THUD_FIT_ALWAYS,    /* under every motion at every value */
    THUD_FIT_SEPARATED, /* the counts go from none to all at once: as beta goes to 0 the likelihood has no bound */
    THUD_FIT_REJECTED,  /* the deviance rejects the curve at 5 %, or it goes the other way than it must */
    THUD_FIT_CURVE
};
const char *thud_fit_name(enum thud_fit fit); /* "none", "counted", ... */

struct thud_lognormal {
    enum thud_fit fit;
    bool falling; /* P falls with x */
    double theta; /* median, in the unit of x; separated: between the bounds */
    double beta;  /* dispersion; separated: 0 */
    double p;     /* how likely a deviance as large would be if the curve held; NaN: two stripes, or no curve */
};
static inline bool thud_is_fitted(const struct thud_lognormal *curve)
{
    return curve->fit == THUD_FIT_CURVE;
}
/* Fits a curve by Newton's method on the log-likelihood of the probit model, which is concave; the direction comes with
 * it. Stripes with n = 0 or x not above 0 are skipped. `fit` is never THUD_FIT_COUNTED. */
struct thud_lognormal thud_lognormal_fit(const struct thud_stripe *stripe, size_t n);
/* Returns the probability at x; NaN if not fitted. */
double thud_lognormal_at(const struct thud_lognormal *curve, double x);
enum { THUD_EVENTS_MAX = 16 }; /* of a study */
/* Event of a run: a measure exceeds its limit. */
struct thud_event {
    enum thud_measure measure;
    double limit;
    char text[48]; /* as asked for: "drift:1 %" */
};
/* Form in which one is written: "force:5MN", of limits "force=5MN", of criteria "force < 5MN" and "no pounding". */
enum thud_event_form { THUD_FORM_EVENT, THUD_FORM_LIMIT, THUD_FORM_CRITERION };
/* Appends an example of each, with commas between. */
void thud_events_list(enum thud_event_form form, struct thud_text *out);
/* Reads "pounding", "force:5 MN": the words of the table of measures. Errors: THUD_USAGE. */
enum thud_status thud_event_parse(const char *text, struct thud_event *out, struct thud_error *err);
/* Reads several separated by commas, also in brackets; empty: pounding and worse. `out` has room for THUD_EVENTS_MAX.
 * Errors: THUD_USAGE. */
enum thud_status thud_events_parse(const char *list, struct thud_event *out, int *n, struct thud_error *err);
/* Reads limits, "drift=1 %, force: 5 MN", by the words of events, into the places of their measures; one takes the place
 * of those before it that have its word. Errors: THUD_USAGE. */
enum thud_status thud_limits_parse(const char *list, struct thud_event limit[THUD_MEASURES], struct thud_error *err);
/* Whether the words of studies and reports can be read, where they are set: study.events, document.limits and
 * document.code. Errors: THUD_INPUT with the key. */
enum thud_status thud_words_check(const struct thud_scene *scene, struct thud_error *err);
/* Returns whether a fragility can be against it: more than one number. */
bool thud_axis_is_drawn(const struct thud_sweep_axis *axis);
/* Returns whether an intensity of the ground motion is varied. */
bool thud_axis_is_intensity(const struct thud_sweep_axis *axis);
/* Hazard curve: annual rate of exceeding an intensity; x rising, rate falling, a power of x between points. */
struct thud_hazard {
    size_t n;
    double *x, *rate; /* (n) */
    double period_s;  /* of its spectral acceleration, as it says; 0: it does not */
};
/* Fragility of one event and case along one axis, at one setting of the others. */
struct thud_fragility_ask {
    const struct thud_event *event;
    int k, axis;
    int at[THUD_VARY_MAX]; /* places on the other axes */
    int samples;           /* of the bootstrap; 0: no band */
    unsigned long long seed;
    const struct thud_hazard *hazard; /* along an intensity: for the band of the annual rate; NULL: none */
    bool
        first_contact; /* of pounding: the factor at which each motion begins to cause contact, by runs where need be */
};
struct thud_fragility {
    size_t n;
    struct thud_stripe *stripe; /* (n) in the order of the axis */
    double *share_low,
        *share_high;    /* (n) Wilson's 90 % band of the share, by the draws among its motions; NaN without */
    double *low, *high; /* (n) 5 and 95 % of the curve's bootstrap; NaN without */
    struct thud_lognormal curve;
    double least, most; /* value that was tried */
    /* Bounds of the median: theta, if there is a curve and theta lies within the values tried. Otherwise they are
     * bounds: 0 and INFINITY if open, both NaN if the counts give none. */
    double theta, above, below;
    double theta_low, theta_high, beta_low, beta_high; /* 5 and 95 % of the bootstrap; NaN without */
    double rate_low, rate_high;                        /* 16 and 84 % of its annual rates; NaN without */
    /* For pounding, without a fit: the smallest value at which each motion causes contact (for a gap: no contact),
     * sorted. NULL: not requested, or not known. Then the values at which at least 16, 50 and 84 % of them do, and 5
     * and 95 % of the bootstrap of the middle one. */
    int nexact;
    double *exact; /* (nexact) */
    /* Same along an intensity, as factors on the motions of the study in their order. */
    struct thud_first_contact *contact; /* (nexact); NULL: along a gap */
    int clearing;                       /* motions under which a larger factor than the first clears again */
    double exact16, exact50, exact84, exact_low, exact_high;
    /* Along a gap: the smallest gap without contact under any motion, without the bumper; NaN: not known. */
    double free_gap;
};
/* Computes a fragility; free with thud_fragility_clear. Errors: THUD_MEMORY. */
enum thud_status thud_fragility_make(const struct thud_suite *suite, const struct thud_fragility_ask *ask,
                                     struct thud_fragility *out, struct thud_error *err);
void thud_fragility_clear(struct thud_fragility *fragility);

/* Annual rate of an event: a number if the bounds due to the range of the hazard curve agree within 1 %, else these
 * bounds. 16 and 84 % of the number are by bootstrap over the motions; NaN: no bootstrap. */
struct thud_rate {
    double least, value, most; /* value: NaN where there are only bounds; most: INFINITY where there is none */
    double low, high;
};
/* Computes the rate. For pounding it is the mean of the exact rates of the motions. Otherwise it is int P |d lambda|,
 * for a curve whose median lies within the values tried, for counts that separate, and for events that never or always
 * happen. If the hazard curve does not cover the range where P matters, it gives bounds: beyond its last point P lies
 * between its value there and 1; before its first point the rate is unknown. All NaN if neither is known, or the event
 * becomes rarer with the intensity. */
struct thud_rate thud_hazard_rate(const struct thud_hazard *hazard, const struct thud_fragility *fragility);
/* Returns the probability of at least one event in this many years of a Poisson process: 1 - exp(-rate years). */
double thud_hazard_probability(double rate, double years);
void thud_hazard_clear(struct thud_hazard *hazard);
