#include "core/laws/law.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "core/laws/law_check.h"

int thud_law_count(void)
{
    int n = 0;
    while (thud_laws[n])
        n++;
    return n;
}

const struct thud_law *thud_law_at(int index)
{
    return thud_laws[index];
}

const struct thud_law *thud_law_find(const char *name)
{
    for (int i = 0; thud_laws[i]; i++)
        if (strcmp(thud_laws[i]->name, name) == 0)
            return thud_laws[i];
    return NULL;
}

int thud_law_param(const struct thud_law *law, const char *name)
{
    for (int i = 0; i < law->nparams; i++)
        if (strcmp(law->params[i].name, name) == 0)
            return i;
    return -1;
}

void thud_law_defaults(const struct thud_law *law, struct thud_law_setup *setup)
{
    for (int i = 0; i < THUD_LAW_PARAMS_MAX; i++)
        setup->value[i] = i < law->nparams ? law->params[i].fallback : 0;
}

/* The middle of cell i of [1, 2). */
static double middle_of(int i)
{
    return 1 + (i + 0.5) / THUD_POWER_CELLS;
}

void thud_powers_fill(struct thud_powers *t, double p)
{
    *t = (struct thud_powers){.p = p, .binomial = {1}};
    for (int k = 1; k < THUD_POWER_TERMS; k++)
        t->binomial[k] = t->binomial[k - 1] * (p - k + 1) / k;
    for (int i = 0; i < THUD_POWER_CELLS; i++) {
        t->inverse[i] = 1 / middle_of(i);
        t->cell[i] = pow(middle_of(i), p);
    }
    for (int i = 0; i < THUD_POWER_OCTAVES; i++)
        t->octave[i] = pow(2, (i + THUD_POWER_LEAST) * p);
}

/* With d = 2^e c (1 + x), c the middle of a cell and |x| <= 1/256: (2^e)^p c^p (1 + x)^p, the last by the binomial series,
 * whose next term is below 1e-16 for the powers that occur. Returns -1 where 2^e is not in the tables. */
static inline double tabled_power(const struct thud_powers *t, double d)
{
    uint64_t bits;
    memcpy(&bits, &d, sizeof bits);
    const unsigned octave = (unsigned)((int)(bits >> 52) - 1023 - THUD_POWER_LEAST);
    const int cell = (bits >> 45) % THUD_POWER_CELLS;
    if (octave >= THUD_POWER_OCTAVES)
        return -1;
    bits = (bits & 0xfffffffffffff) | (uint64_t)1023 << 52;
    double m;
    memcpy(&m, &bits, sizeof m);
    /* in three parts side by side (Estrin): Horner's rule would wait for each of its products */
    const double x = m * t->inverse[cell] - 1, x2 = x * x, *c = t->binomial;
    const double sum = (c[0] + c[1] * x + (c[2] + c[3] * x) * x2) + (c[4] + c[5] * x + c[6] * x2) * (x2 * x2);
    return t->octave[octave] * t->cell[cell] * sum;
}

double thud_power(const struct thud_powers *t, double d)
{
    const double power = tabled_power(t, d);
    return power < 0 ? pow(d, t->p) : power;
}

/* d^p for d > 0, without pow for the exponents of the published laws. */
static inline double power(const struct thud_powers *powers, double d, double p)
{
    if (powers && p == powers->p)
        return thud_power(powers, d);
    if (p == 1.5)
        return d * sqrt(d);
    if (p == 1)
        return d;
    if (p == 0.25)
        return sqrt(sqrt(d));
    return pow(d, p);
}

/* Slope of a d^p as d falls to 0. */
static double slope_at_zero(double a, double p)
{
    if (a == 0 || p > 1)
        return 0;
    return p == 1 ? a : copysign(INFINITY, a);
}

/* The elastic curve K x^p with a spring in series, and the dashpot that goes with it, at an indentation. */
struct series {
    double x; /* what of the indentation is the law's own */
    double force, slope, damper, damper_slope;
};

/* x + K/k x^p = d. The left side is convex and rises: from above, where the larger of its parts alone would make d,
 * Householder's method of third order goes to the root (Householder 1970, The Numerical Treatment of a Single Nonlinear
 * Equation, section 4.4); Newton's, which stays above it, takes over where a step would leave the interval. Powers are
 * what it costs: at the start the part of the spring is known, and after the last step, which leaves the fourth power of
 * its own size, it follows by the binomial series. */
static struct series own_indentation(const struct thud_branch *b, double d)
{
    enum { MOST = 60 };
    static const double last_step = 5e-5; /* relative: its fourth power is below rounding */
    double c = b->K / b->column_npm, p = b->p, x = d, part = c * power(b->powers, d, p);
    if (part > d) {
        x = pow(d / c, 1 / p);
        part = d;
    }
    for (int i = 0; i < MOST; i++) {
        /* of the function over its slope, relative to x: itself, second and third derivative */
        double rate = p * part, slope = x + rate;
        double newton = (x + part - d) / slope, second = (p - 1) * rate / slope, third = (p - 2) * second;
        double step = newton * (1 - 0.5 * newton * second) / (1 - newton * (second - newton * third / 6));
        if (!(fabs(step) < 1))
            step = newton;
        x -= step * x;
        if (!(fabs(step) > last_step)) {
            part *= 1 - p * step * (1 - (p - 1) / 2 * step * (1 - (p - 2) / 3 * step));
            break;
        }
        part = c * power(b->powers, x, p);
    }
    return (struct series){.x = x, .force = b->column_npm * part};
}

static struct series series_of(const struct thud_branch *b, double d)
{
    struct series s = own_indentation(b, d);
    double own = b->p * s.force / s.x;
    s.slope = own / (1 + own / b->column_npm);
    if (b->r == b->p) {
        s.damper = b->D / b->K * s.force;
        s.damper_slope = b->D / b->K * s.slope;
    } else if (b->D != 0) { /* r = (p - 1)/2 */
        double energy = s.force * (s.x / (b->p + 1) + 0.5 * s.force / b->column_npm);
        s.damper = b->D * s.force / sqrt(b->K * (b->p + 1) * energy);
        s.damper_slope = s.damper * (s.slope / s.force - 0.5 * s.force / energy);
    }
    return s;
}

static double series_force(const struct thud_branch *b, double d, double v, double *df_dd, double *df_dv)
{
    struct series s = series_of(b, d);
    if (df_dd)
        *df_dd = b->k_npm + s.slope + s.damper_slope * v;
    if (df_dv)
        *df_dv = b->c_nspm + s.damper;
    return b->f0_n + b->k_npm * d + b->c_nspm * v + s.force + s.damper * v;
}

/* K x/(1 + x/soft), x = d + shift, beside f0 + k d + c v. */
static double soft_force(const struct thud_branch *b, double d, double v, double *df_dd, double *df_dv)
{
    const double x = d + b->shift_m, over = 1 / (1 + x / b->soft_m);
    if (df_dd)
        *df_dd = b->k_npm + b->K * over * over;
    if (df_dv)
        *df_dv = b->c_nspm;
    return b->f0_n + b->k_npm * d + b->c_nspm * v + b->K * x * over;
}

/* f0 + k d + c v + K d^p + D d^r v, of which dp and dr are the powers, 0 at d <= 0. */
static inline double power_force(const struct thud_branch *b, double d, double v, double dp, double dr, double *df_dd,
                                 double *df_dv)
{
    const double elastic = b->K * dp, damper = b->D * dr,
                 over = d > 0 ? 1 / d : 0; /* the division waits for no power */
    if (df_dd)
        *df_dd = b->k_npm + (b->p * elastic + b->r * (damper * v)) * over;
    if (df_dv)
        *df_dv = b->c_nspm + damper;
    return b->f0_n + b->k_npm * d + b->c_nspm * v + (elastic + damper * v);
}

/* Of branches whose power is not tabled. */
static double other_force(const struct thud_branch *b, double d, double v, double *df_dd, double *df_dv)
{
    if (b->soft_m > 0 && d >= 0)
        return soft_force(b, d, v, df_dd, df_dv);
    if (b->column_npm > 0 && d > 0)
        return series_force(b, d, v, df_dd, df_dv);
    const bool by_power = d > 0 && (b->K != 0 || b->D != 0);
    const double dp = by_power ? power(b->powers, d, b->p) : 0,
                 force =
                     power_force(b, d, v, dp, by_power && b->r != b->p ? power(b->powers, d, b->r) : dp, df_dd, df_dv);
    if (df_dd && d == 0)
        *df_dd += slope_at_zero(b->K, b->p) + slope_at_zero(b->D * v, b->r);
    return force;
}

double thud_branch_force(const struct thud_branch *branch, double d_m, double v_mps, double *df_dd, double *df_dv)
{
    const struct thud_powers *powers = branch->powers;
    if (!powers || !(d_m > 0) || branch->p != powers->p || branch->r != powers->p || branch->column_npm > 0 ||
        branch->soft_m > 0)
        return other_force(branch, d_m, v_mps, df_dd, df_dv);
    const double dp = tabled_power(powers, d_m);
    return dp < 0 ? other_force(branch, d_m, v_mps, df_dd, df_dv)
                  : power_force(branch, d_m, v_mps, dp, dp, df_dd, df_dv);
}

double thud_law_nominal(const struct thud_law *law, const struct thud_law_setup *setup)
{
    int i = thud_law_param(law, "restitution");
    return law->nominal ? law->nominal(setup) : i >= 0 ? setup->value[i] : NAN;
}

double thud_law_restitution(const struct thud_law *law, const struct thud_law_setup *setup, double v_mps)
{
    return law->restitution ? law->restitution(setup, v_mps) : NAN;
}

void thud_law_onset(const struct thud_law *law, const struct thud_law_setup *setup, double v_mps,
                    struct thud_law_memory *memory)
{
    if (law->onset)
        law->onset(setup, v_mps, memory);
}

struct thud_branch thud_law_branch_at(const struct thud_law *law, const struct thud_law_setup *setup,
                                      const struct thud_law_memory *memory, enum thud_phase phase, double d_m)
{
    return thud_law_branch(law, setup, memory, phase, d_m > thud_law_ultimate(law, setup, memory, phase));
}

/* ---- a law and the columns that are struck ---- */

int thud_law_spring(const struct thud_law *law)
{
    bool one_line = law->flags & THUD_LAW_LINEAR && !(law->flags & THUD_LAW_REVERSES) && !law->ultimate;
    return one_line ? thud_law_param(law, "stiffness") : -1;
}

static bool gives(const struct thud_law *law, const struct thud_law_setup *setup)
{
    return setup->column_npm > 0 && thud_law_spring(law) < 0;
}

/* Straight lines in series with a spring are straight lines: all of a line f0 + k d that damping only multiplies, and
 * a dashpot of its own, which goes with the root of the stiffness. */
static void fold_line(struct thud_branch *b, double column)
{
    double part = column / ((b->K != 0 ? b->K : b->k_npm) + column);
    b->c_nspm *= b->K != 0 || b->D == 0 ? sqrt(part) : part;
    b->f0_n *= part;
    b->k_npm *= part;
    b->K *= part;
    b->D *= part;
}

struct thud_branch thud_law_branch(const struct thud_law *law, const struct thud_law_setup *setup,
                                   const struct thud_law_memory *memory, enum thud_phase phase, bool past_ultimate)
{
    if (!law->branch)
        return (struct thud_branch){0};
    struct thud_branch b = law->branch(setup, memory, phase, past_ultimate);
    if (!gives(law, setup))
        return b;
    if (b.K == 0 || b.p == 1)
        fold_line(&b, setup->column_npm);
    else
        b.column_npm = setup->column_npm;
    return b;
}

double thud_law_ultimate(const struct thud_law *law, const struct thud_law_setup *setup,
                         const struct thud_law_memory *memory, enum thud_phase phase)
{
    double d = law->ultimate ? law->ultimate(setup, memory, phase) : INFINITY;
    if (!gives(law, setup) || d == INFINITY)
        return d;
    struct thud_branch b = law->branch(setup, memory, phase, false);
    return d + thud_branch_force(&b, d, 0, NULL, NULL) / setup->column_npm;
}

/* How far the columns give at rest. */
static double column_part(const struct thud_law *law, const struct thud_law_setup *setup,
                          const struct thud_law_memory *memory, enum thud_phase phase, double d)
{
    struct thud_branch b = thud_law_branch_at(law, setup, memory, phase, d);
    return thud_branch_force(&b, d, 0, NULL, NULL) / setup->column_npm;
}

double thud_law_energy(const struct thud_law *law, const struct thud_law_setup *setup,
                       const struct thud_law_memory *memory, enum thud_phase phase, double d_m)
{
    if (!law->elastic_energy || !(d_m > 0))
        return 0;
    double column = gives(law, setup) ? column_part(law, setup, memory, phase, d_m) : 0;
    return law->elastic_energy(setup, memory, d_m - column) + 0.5 * setup->column_npm * column * column;
}

void thud_law_reversal(const struct thud_law *law, const struct thud_law_setup *setup, enum thud_phase phase,
                       double d_m, struct thud_law_memory *memory)
{
    enum thud_phase before = phase == THUD_APPROACH ? THUD_RESTITUTION : THUD_APPROACH;
    if (law->reversal)
        law->reversal(setup, phase, gives(law, setup) ? d_m - column_part(law, setup, memory, before, d_m) : d_m,
                      memory);
}
