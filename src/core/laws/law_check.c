#include "core/laws/law_check.h"

#include <math.h>
#include <string.h>

/* Part by which two ways to a coefficient may lie apart. */
static const double rounding = 1e-9;

static bool is_finite(const struct thud_branch *b)
{
    return isfinite(b->f0_n) && isfinite(b->k_npm) && isfinite(b->c_nspm) && isfinite(b->K) && isfinite(b->p) &&
           isfinite(b->D) && isfinite(b->r);
}

/* A power of the indentation: the sign of the force has to follow from one factor, 1 + s v, or not to change. */
static const char *power_fault(const struct thud_branch *b, enum thud_phase phase)
{
    if (b->K < 0 || b->p <= 0 || (b->D != 0 && b->r <= 0))
        return "K and the exponents of its branch must be above 0";
    if (b->D != 0 && b->r == b->p)
        return b->f0_n == 0 && b->k_npm == 0 && b->c_nspm == 0 ? NULL
                                                               : "its branch K d^p (1 + s v) can have no other terms";
    if (b->f0_n < 0 || b->k_npm < 0)
        return "f0 and k of its branch are below 0 beside a power of the indentation";
    if ((b->c_nspm != 0 || b->D != 0) && (phase == THUD_RESTITUTION || b->c_nspm < 0 || b->D < 0))
        return "a dashpot beside a power of the indentation holds for approach alone, and is not below 0";
    return b->column_npm > 0 && (b->f0_n != 0 || b->k_npm != 0)
               ? "struck columns cannot be in series with a power of the indentation and a line together"
               : NULL;
}

const char *thud_branch_fault(const struct thud_law *law, const struct thud_branch *b, enum thud_phase phase)
{
    if (!is_finite(b))
        return "a coefficient of its branch is not a number";
    if (b->K == 0 && b->D == 0)
        return NULL;
    if (law->flags & THUD_LAW_LINEAR)
        return "it is declared linear, but its branch has a power of the indentation";
    if (b->K != 0)
        return power_fault(b, phase);
    return b->p == 1 && b->r == 1 &&
                   fabs(b->c_nspm * b->k_npm - b->f0_n * b->D) <= rounding * fabs(b->c_nspm * b->k_npm)
               ? NULL
               : "a dashpot D d^r v needs a power of the indentation, or (f0 + k d)(1 + s v)";
}

static const char *table_fault(const struct thud_law *law)
{
    if (law->nparams > THUD_LAW_PARAMS_MAX)
        return "it has more parameters than there is room for";
    if (!(law->flags & (THUD_LAW_NO_FORCE | THUD_LAW_IMPULSIVE)) && (!law->branch || !law->elastic_energy))
        return "it has no branches, or no elastic energy";
    return law->reversal && !(law->flags & THUD_LAW_REVERSES) ? "it has an undeclared reversal" : NULL;
}

/* The branches on either side of the ultimate compression of a phase. */
static const char *phase_fault(const struct thud_law *law, const struct thud_law_setup *setup,
                               const struct thud_law_memory *memory, enum thud_phase phase)
{
    struct thud_branch branch[2];
    double ultimate = thud_law_ultimate(law, setup, memory, phase);
    if (phase == THUD_APPROACH && !(ultimate > 0))
        return "its ultimate compression is not above 0";
    for (int past = 0; past < (ultimate < INFINITY ? 2 : 1); past++) {
        branch[past] = thud_law_branch(law, setup, memory, phase, past);
        const char *fault = thud_branch_fault(law, &branch[past], phase);
        if (fault)
            return fault;
    }
    return NULL;
}

/* There and back: to indentation d, half the way out, and in again. */
static const char *cycle_fault(const struct thud_law *law, const struct thud_law_setup *setup,
                               struct thud_law_memory *memory, double d)
{
    const char *fault = NULL;
    if (law->flags & THUD_LAW_REVERSES) {
        thud_law_reversal(law, setup, THUD_RESTITUTION, d, memory);
        fault = phase_fault(law, setup, memory, THUD_RESTITUTION);
        thud_law_reversal(law, setup, THUD_APPROACH, 0.5 * d, memory);
    }
    return fault ? fault : phase_fault(law, setup, memory, THUD_APPROACH);
}

/* Puts the law through a contact of some depths. Errors: THUD_INPUT with the key "law". */
static enum thud_status check(const struct thud_law *law, const struct thud_law_setup *setup, struct thud_error *err)
{
    static const double depth_m[] = {1e-4, 1e-3, 1e-2, 1e-1};
    const char *fault = table_fault(law);
    struct thud_law_memory memory = {0};
    if (!fault && law->branch) {
        thud_law_onset(law, setup, 1, &memory);
        fault = phase_fault(law, setup, &memory, THUD_APPROACH);
    }
    for (size_t i = 0; i < sizeof depth_m / sizeof *depth_m && !fault && law->branch; i++)
        fault = cycle_fault(law, setup, &memory, depth_m[i]);
    if (!fault)
        return THUD_OK;
    return thud_error_refuse(err, THUD_INPUT, "law", "thud(3) states the requirements of your own law",
                             "the law %s cannot be used: %s", law->name, fault);
}

enum thud_status thud_law_prepare(const struct thud_law *law, struct thud_law_setup *setup, struct thud_error *err)
{
    int spring = thud_law_spring(law);
    setup->law = law;
    memset(setup->constant, 0, sizeof setup->constant);
    if (setup->column_npm > 0 && law->flags & THUD_LAW_IMPULSIVE)
        return thud_error_refuse(err, THUD_INPUT, "law", "another law, or columns without EI and stiffness",
                                 "flexible columns need a contact force, but %s has impulses", law->name);
    if (setup->column_npm > 0 && spring >= 0)
        setup->value[spring] *= setup->column_npm / (setup->value[spring] + setup->column_npm);
    enum thud_status status = law->prepare ? law->prepare(setup, err) : THUD_OK;
    return status == THUD_OK ? check(law, setup, err) : status;
}
