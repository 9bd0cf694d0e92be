/* How likely something is: counts over a suite of ground motions, a lognormal curve through them by maximum likelihood
 *
 *     P(x) = Phi(ln(x / theta) / beta)         rising (against an intensity), or
 *     P(x) = Phi(-ln(x / theta) / beta)        falling (against a gap)
 *
 * after Baker, "Efficient analytical fragility function fitting using dynamic structural analysis", Earthquake Spectra
 * 31 (2015) 579-599: the counts are binomial, and the likelihood of all stripes together is made largest; a band for it
 * by the bootstrap over the ground motions; and with a hazard curve the annual rate. Motions are taken as independent.
 */
#ifndef THUD_STUDY_FRAGILITY_H
#define THUD_STUDY_FRAGILITY_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"
#include "study/suite/suite.h"

/* A stripe: of n motions at x, count made it happen. */
struct thud_stripe {
    double x; /* > 0 */
    int n, count;
};

struct thud_lognormal {
    bool fitted;  /* false: no curve (nothing ever happens or everything, or only one x) */
    bool falling; /* P falls with x */
    double theta; /* median, in the unit of x */
    double beta;  /* dispersion; 0: a step, where the counts go from none to all between two neighbours */
};
/* Newton's method on the logarithm of the likelihood of the probit model, which is concave; the direction comes with
 * it. Stripes with n = 0 or x not above 0 are left out. */
struct thud_lognormal thud_lognormal_fit(const struct thud_stripe *stripe, size_t n);
/* NaN where not fitted. */
double thud_lognormal_at(const struct thud_lognormal *curve, double x);
/* What is asked of a run. */
enum thud_event_kind {
    THUD_EVENT_POUNDING,     /* anything touches */
    THUD_EVENT_WORSE,        /* the mean acceleration of a structure is larger than without bumper at the same gap */
    THUD_EVENT_FORCE,        /* a contact's force above the limit, N */
    THUD_EVENT_ACCELERATION, /* a floor's above the limit, m/s2 */
    THUD_EVENT_DRIFT,        /* a storey's above the limit, m */
    THUD_EVENT_DRIFT_ANGLE,  /* the same over its height */
    THUD_EVENT_DUCTILITY,    /* the same over its yield drift, of storeys that yield */
    THUD_EVENT_PERMANENT,    /* their permanent drift, m */
    THUD_EVENT_COLUMN        /* shear of columns that slabs strike over their capacity */
};
struct thud_event {
    enum thud_event_kind kind;
    double limit;
    char text[48]; /* as asked for: "drift:1 %" */
};
/* "pounding", "worse", "force:5 MN", "acceleration:1 g", "drift:3 cm", "drift:1 %", "ductility:2",
 * "permanent:1 cm", "column:1". Errors: THUD_USAGE. */
enum thud_status thud_event_parse(const char *text, struct thud_event *out, struct thud_error *err);
/* One event and case along one axis, at one setting of the others. */
struct thud_fragility_ask {
    const struct thud_event *event;
    int k, axis;
    int at[THUD_VARY_MAX]; /* places on the other axes */
    int samples;           /* of the bootstrap; 0: no band */
    unsigned long long seed;
};
struct thud_fragility {
    size_t n;
    struct thud_stripe *stripe; /* (n) */
    double *low, *high;         /* (n) 5 and 95 % of the curve's bootstrap; NaN without */
    struct thud_lognormal curve;
    double theta_low, theta_high, beta_low, beta_high; /* 5 and 95 %; NaN: fewer than half the samples have a curve */
};
/* Free with thud_fragility_clear. Errors: THUD_MEMORY. */
enum thud_status thud_fragility_make(const struct thud_suite *suite, const struct thud_fragility_ask *ask,
                                     struct thud_fragility *out, struct thud_error *err);
void thud_fragility_clear(struct thud_fragility *fragility);

/* Annual rate at which an intensity is exceeded; x rising, rate falling. */
struct thud_hazard {
    size_t n;
    double *x, *rate; /* (n) */
};
/* sum P |d lambda| over the intervals, P at the geometric mean of their ends, and what exceeds the last x with P there.
 * NaN where the curve is not fitted or falls. */
double thud_hazard_rate(const struct thud_hazard *hazard, const struct thud_lognormal *curve);
/* Probability of at least one in so many years of a Poisson process: 1 - exp(-rate years). */
double thud_hazard_probability(double rate, double years);
void thud_hazard_clear(struct thud_hazard *hazard);

#endif
