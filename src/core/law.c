#include "core/law.h"

#include <math.h>
#include <string.h>

#define THUD_LAW(word) extern const struct thud_law thud_law_##word;
#include "core/law_list.h"
#undef THUD_LAW

static const struct thud_law *const laws[] = {
#define THUD_LAW(word) &thud_law_##word,
#include "core/law_list.h"
#undef THUD_LAW
};

int thud_law_count(void)
{
    return (int)(sizeof laws / sizeof laws[0]);
}

const struct thud_law *thud_law_at(int index)
{
    return laws[index];
}

const struct thud_law *thud_law_find(const char *name)
{
    for (int i = 0; i < thud_law_count(); i++)
        if (strcmp(laws[i]->name, name) == 0)
            return laws[i];
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

/* d^p for d > 0, without pow for the exponents of the published laws. */
static double power(double d, double p)
{
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

double thud_branch_force(const struct thud_branch *branch, double d_m, double v_mps, double *df_dd, double *df_dv)
{
    double force = branch->f0_n + branch->k_npm * d_m + branch->c_nspm * v_mps, elastic = 0, damper = 0;
    if (d_m > 0 && (branch->K != 0 || branch->D != 0)) {
        double dp = power(d_m, branch->p), dr = branch->r == branch->p ? dp : power(d_m, branch->r);
        elastic = branch->K * dp;
        damper = branch->D * dr;
        force += elastic + damper * v_mps;
    }
    if (df_dd) {
        *df_dd = branch->k_npm;
        if (d_m > 0)
            *df_dd += (branch->p * elastic + branch->r * damper * v_mps) / d_m;
        else if (d_m == 0)
            *df_dd += slope_at_zero(branch->K, branch->p) + slope_at_zero(branch->D * v_mps, branch->r);
    }
    if (df_dv)
        *df_dv = branch->c_nspm + damper;
    return force;
}

struct thud_branch thud_law_branch_at(const struct thud_law *law, const struct thud_law_setup *setup,
                                      const struct thud_law_memory *memory, enum thud_phase phase, double d_m)
{
    return law->branch(setup, memory, phase, law->ultimate && d_m > law->ultimate(setup));
}
