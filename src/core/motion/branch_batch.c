#include "core/motion/branch_batch.h"

#include <math.h>

#include "core/motion/nodes.h"

typedef thud_vec2_bits bits;

enum { PAIRS = THUD_BATCH / 2, MANTISSA = 52 };

/* Where x > 0. */
static inline bits above_zero(thud_vec2 x)
{
    return (bits)(x > thud_vec2_set(0, 0));
}

/* sum = sum x + c at every step: coefficients from that of the highest power on. */
static inline struct thud_batch horner(const double *c, int n, const struct thud_batch *x)
{
    struct thud_batch sum;
    for (int i = 0; i < PAIRS; i++)
        sum.pair[i] = thud_vec2_set(c[0], c[0]);
    for (int k = 1; k < n; k++)
        for (int i = 0; i < PAIRS; i++)
            sum.pair[i] = sum.pair[i] * x->pair[i] + c[k];
    return sum;
}

/* log2 of positive numbers, none of them subnormal: x = 2^e m with m within a factor sqrt(2) of 1, and
 * ln m = 2 (s + s^3/3 + s^5/5 + ...) where s = (m - 1)/(m + 1), |s| < 0.172: ten terms are enough. */
static struct thud_batch log2_of(const struct thud_batch *x)
{
    static const bits one = {0x3FF0000000000000, 0x3FF0000000000000},
                      root_half = {0x3FE6A09E667F3BCD, 0x3FE6A09E667F3BCD}, /* sqrt(1/2) */
        two_52 = {0x4330000000000000, 0x4330000000000000};
    static const double odd[] = {2.0 / 19, 2.0 / 17, 2.0 / 15, 2.0 / 13, 2.0 / 11,
                                 2.0 / 9,  2.0 / 7,  2.0 / 5,  2.0 / 3,  2};
    static const double log2_e = 1.4426950408889634;
    struct thud_batch e, s, square;
    for (int i = 0; i < PAIRS; i++) {
        bits number = (bits)x->pair[i], biased = (number + (one - root_half)) >> MANTISSA;
        thud_vec2 m = (thud_vec2)(number - (biased << MANTISSA) + one);
        e.pair[i] = (thud_vec2)(biased | two_52) - (0x1p52 + 1023); /* a small integer as a number */
        s.pair[i] = (m - 1) / (m + 1);
        square.pair[i] = s.pair[i] * s.pair[i];
    }
    struct thud_batch sum = horner(odd, sizeof odd / sizeof *odd, &square);
    for (int i = 0; i < PAIRS; i++)
        sum.pair[i] = e.pair[i] + log2_e * (s.pair[i] * sum.pair[i]);
    return sum;
}

/* 2^y for |y| < 1000: y = n + r with |r| <= 1/2, and the series of exp(r ln 2). */
static struct thud_batch exp2_of(const struct thud_batch *y)
{
    static const double inverse_factorial[] = {
        1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720,
        1.0 / 120,       1.0 / 24,       1.0 / 6,       0.5,          1,           1};
    static const double ln_2 = 0.6931471805599453, to_integer = 0x1.8p52;
    struct thud_batch n, r;
    for (int i = 0; i < PAIRS; i++) {
        n.pair[i] = y->pair[i] + to_integer; /* rounds, and leaves the integer in the lowest bits */
        r.pair[i] = ln_2 * (y->pair[i] - (n.pair[i] - to_integer));
    }
    struct thud_batch sum = horner(inverse_factorial, sizeof inverse_factorial / sizeof *inverse_factorial, &r);
    for (int i = 0; i < PAIRS; i++)
        sum.pair[i] = (thud_vec2)((bits)sum.pair[i] + ((bits)n.pair[i] << MANTISSA));
    return sum;
}

/* d^p by its logarithm to base 2; 0 where d <= 0. */
static void power_of(const struct thud_batch *d, const struct thud_batch *log2_d, double p, struct thud_batch *out)
{
    struct thud_batch y;
    for (int i = 0; i < PAIRS; i++) {
        const thud_vec2 most = {999, 999}, exponent = p * log2_d->pair[i];
        y.pair[i] = thud_vec2_choose((bits)(exponent > most), most,
                                     thud_vec2_choose((bits)(exponent < -most), -most, exponent));
    }
    *out = exp2_of(&y);
    for (int i = 0; i < PAIRS; i++)
        out->pair[i] = thud_vec2_only(above_zero(d->pair[i]), out->pair[i]);
}

/* f0 + k d + c v + K d^p + D d^r v */
static void power_terms(const struct thud_branch *b, const struct thud_batch *d, const struct thud_batch *v,
                        double *force, double *df_dd, double *df_dv)
{
    struct thud_batch dp, dr, positive, f, fd, fv;
    for (int i = 0; i < PAIRS; i++)
        positive.pair[i] = thud_vec2_choose(above_zero(d->pair[i]), d->pair[i], thud_vec2_set(1, 1));
    const struct thud_batch log2_d = log2_of(&positive);
    power_of(d, &log2_d, b->p, &dp);
    dr = dp;
    if (b->D != 0 && b->r != b->p)
        power_of(d, &log2_d, b->r, &dr);
    for (int i = 0; i < PAIRS; i++) {
        thud_vec2 elastic = b->K * dp.pair[i], damper = b->D * dr.pair[i];
        f.pair[i] = b->f0_n + b->k_npm * d->pair[i] + b->c_nspm * v->pair[i] + (elastic + damper * v->pair[i]);
        fd.pair[i] = b->k_npm + (b->p * elastic + b->r * damper * v->pair[i]) / positive.pair[i];
        fv.pair[i] = b->c_nspm + damper;
    }
    thud_batch_put(&f, force);
    thud_batch_put(&fd, df_dd);
    thud_batch_put(&fv, df_dv);
}

/* One step of Householder's method of third order for x + part = d, part going with x^p, relative to x; Newton's where
 * that would leave the interval. See own_indentation in law.c. */
static inline thud_vec2 relative_step(thud_vec2 x, thud_vec2 part, thud_vec2 d, double p)
{
    thud_vec2 rate = p * part, slope = x + rate, newton = (x + part - d) / slope, second = (p - 1) * rate / slope;
    thud_vec2 step = newton * (1 - 0.5 * newton * second) / (1 - newton * (second - newton * ((p - 2) / 6 * second)));
    return thud_vec2_choose((bits)(thud_vec2_abs(step) < thud_vec2_set(1, 1)), step, newton);
}

/* Columns in series with K x^p: x + K/column x^p = d for positive d. Gives x, and the spring's part of d. */
static void own_indentations(const struct thud_branch *b, const struct thud_batch *d, const struct thud_batch *log2_d,
                             struct thud_batch *x, struct thud_batch *part)
{
    enum { MOST = 60 };
    static const double last_step = 5e-5; /* its fourth power is below rounding */
    const double p = b->p, c = b->K / b->column_npm, log2_c = log2(c);
    struct thud_batch root, power, y, step;
    for (int i = 0; i < PAIRS; i++)
        y.pair[i] = (log2_d->pair[i] - log2_c) / p;
    power_of(d, &y, 1, &root);
    power_of(d, log2_d, p, &power);
    for (int i = 0; i < PAIRS; i++) { /* from above: the larger of the two parts alone would make d */
        bits spring = (bits)(c * power.pair[i] > d->pair[i]);
        x->pair[i] = thud_vec2_choose(spring, root.pair[i], d->pair[i]);
        part->pair[i] = thud_vec2_choose(spring, d->pair[i], c * power.pair[i]);
    }
    for (int k = 0; k < MOST; k++) {
        bits left = {0, 0};
        for (int i = 0; i < PAIRS; i++) {
            step.pair[i] = relative_step(x->pair[i], part->pair[i], d->pair[i], p);
            x->pair[i] -= step.pair[i] * x->pair[i];
            left |= (bits)(thud_vec2_abs(step.pair[i]) > thud_vec2_set(last_step, last_step));
        }
        if (!(left[0] | left[1]))
            break;
        *part = log2_of(x);
        power_of(d, part, p, &power);
        for (int i = 0; i < PAIRS; i++) {
            part->pair[i] = c * power.pair[i];
            step.pair[i] = thud_vec2_set(0, 0);
        }
    }
    for (int i = 0; i < PAIRS; i++) { /* by the binomial series of (1 - step)^p */
        const thud_vec2 s = step.pair[i];
        part->pair[i] *= 1 - p * s * (1 - (p - 1) / 2 * s * (1 - (p - 2) / 3 * s));
    }
}

/* The dashpot of columns and K x^p together, and how it changes with d. */
static inline void damper_of(const struct thud_branch *b, thud_vec2 x, thud_vec2 force, thud_vec2 slope,
                             thud_vec2 *damper, thud_vec2 *damper_slope)
{
    if (b->r == b->p || b->D == 0) {
        *damper = b->D / b->K * force;
        *damper_slope = b->D / b->K * slope;
        return;
    }
    /* r = (p - 1)/2 */
    thud_vec2 energy = force * (x / (b->p + 1) + 0.5 / b->column_npm * force), root = b->K * (b->p + 1) * energy;
    root = thud_vec2_set(sqrt(root[0]), sqrt(root[1]));
    *damper = b->D * force / root;
    *damper_slope = *damper * (slope / force - 0.5 * force / energy);
}

static void series_terms(const struct thud_branch *b, const struct thud_batch *d, const struct thud_batch *v,
                         double *force, double *df_dd, double *df_dv)
{
    struct thud_batch positive, x, part, f, fd, fv;
    for (int i = 0; i < PAIRS; i++)
        positive.pair[i] = thud_vec2_choose(above_zero(d->pair[i]), d->pair[i], thud_vec2_set(1, 1));
    const struct thud_batch log2_d = log2_of(&positive);
    own_indentations(b, &positive, &log2_d, &x, &part);
    for (int i = 0; i < PAIRS; i++) {
        const bits in_contact = above_zero(d->pair[i]);
        thud_vec2 elastic = b->column_npm * part.pair[i], own = b->p * elastic / x.pair[i], damper, damper_slope;
        thud_vec2 slope = own / (1 + own / b->column_npm);
        damper_of(b, x.pair[i], elastic, slope, &damper, &damper_slope);
        f.pair[i] = b->f0_n + b->k_npm * d->pair[i] + b->c_nspm * v->pair[i] +
                    thud_vec2_only(in_contact, elastic + damper * v->pair[i]);
        fd.pair[i] = b->k_npm + thud_vec2_only(in_contact, slope + damper_slope * v->pair[i]);
        fv.pair[i] = b->c_nspm + thud_vec2_only(in_contact, damper);
    }
    thud_batch_put(&f, force);
    thud_batch_put(&fd, df_dd);
    thud_batch_put(&fv, df_dv);
}

void thud_branch_batch(const struct thud_branch *branch, const double *d_m, const double *v_mps, double *force,
                       double *df_dd, double *df_dv)
{
    const struct thud_batch d = thud_batch_at(d_m), v = thud_batch_at(v_mps);
    if (branch->column_npm > 0)
        series_terms(branch, &d, &v, force, df_dd, df_dv);
    else
        power_terms(branch, &d, &v, force, df_dd, df_dv);
}
