/* Impact laws: the complete interface of a law.
 *
 * A law is one const table in a file of its own, src/core/laws/law_WORD.c, and one line in src/core/laws/law_list.h.
 * Run, methods, energy balance, screens, `thud laws` and the manual use only its table. Functions take SI units.
 *
 * Force. With d the indentation and v = d' (> 0 approaching), the force between two events is that of a branch,
 *     F = f0 + k d + c v + K d^p + D d^r v .
 * A law returns the branch that holds; the force, its derivatives, the integration, the events and the energies are
 * implemented once, for all laws. A force below 0 is cut at 0, except for laws that pull.
 *
 * Events, and the functions called at each, in this order:
 *     onset        d = 0, closing: onset; the phase is THUD_APPROACH, d lies below the ultimate compression
 *     reversal     d' = 0, only with THUD_LAW_REVERSES: reversal sets the memory for the phase that begins, then
 *                  ultimate and branch are called. If the force at rest of approach exceeds that of restitution, so
 *                  that either would reverse the motion at once, the contact sticks (d' = 0) with a force between the
 *                  two. When sticking ends, reversal is called with the phase that begins, even if it is the last one
 *     ultimate     d passes the ultimate compression of the phase: branch is called for the other side
 *     release      F reaches 0 on any branch: with keeps_residual, d is added to the clearance and the contact opens;
 *                  otherwise no force acts until the same branch would push again, and reversals are not reported
 *     separation   d = 0: the contact is open
 *
 * A phase has at most two branches, one on either side of the ultimate compression. Those of the next phase may differ,
 * according to the memory. A third branch in one loading would need another such bound.
 *
 * Memory: eight numbers that only the law reads. All are 0 before the first contact and persist from contact to
 * contact. Only onset and reversal change them, and only when the run commits: a trial writes to a copy.
 *
 * thud_law_prepare refuses what cannot be integrated accurately, with a message (law_check.c). A branch is one of
 *     f0 + k d + c v                    THUD_LAW_LINEAR: every branch is one of these
 *     (f0 + k d)(1 + s v)               as c = s f0, D = s k, p = r = 1
 *     K d^p (1 + s v)                   as D = s K, r = p
 *     f0 + k d + K d^p                  f0, k, K not negative
 *     K x/(1 + x/soft)                  x = d + shift, a hyperbola in place of a power, p = 1
 *     ... + c v + D d^r v               the same with dashpots, in approach and not negative */
#pragma once

#include <stdbool.h>

#include "base/param.h"
#include "base/status.h"

#define THUD_LAW_PARAMS_MAX    16
#define THUD_LAW_CONSTANTS_MAX 8
#define THUD_LAW_MEMORY_MAX    8

struct thud_branch {
    const struct thud_powers *powers; /* tables of d^p; NULL: none */
    double f0_n, k_npm, c_nspm;
    double K, p;            /* K d^p, p > 0 */
    double D, r;            /* D d^r v, r > 0 */
    double column_npm;      /* a spring in series with K d^p; 0: none */
    double soft_m, shift_m; /* where soft is not 0, K d^p is K x/(1 + x/soft) with x = d + shift */
};

enum thud_phase { THUD_APPROACH, THUD_RESTITUTION };

/* Constants of one contact. */
struct thud_law_setup {
    const struct thud_law
        *law;           /* set by thud_law_prepare; a table embedded in a larger struct finds the struct by it */
    double mass_kg;     /* effective mass m1 m2/(m1 + m2) */
    double thickness_m; /* of the bumper; 0 where there is none */
    double column_npm;  /* stiffness of the struck columns, in series with the law; 0: none */
    double value[THUD_LAW_PARAMS_MAX];       /* parameters in SI, in the order of the law's table */
    double constant[THUD_LAW_CONSTANTS_MAX]; /* filled by the law's prepare */
};

struct thud_law_memory {
    double own[THUD_LAW_MEMORY_MAX];
};

enum {
    THUD_LAW_LINEAR = 1,     /* every branch is linear: contact is propagated exactly */
    THUD_LAW_REVERSES = 2,   /* approach and restitution have different branches, or memory changes at reversals */
    THUD_LAW_PULLS = 4,      /* force may be negative; the contact ends at d = 0 */
    THUD_LAW_IMPULSIVE = 8,  /* no force: an impulse at contact onset (stereomechanical) */
    THUD_LAW_NO_FORCE = 16,  /* no contact at all (none) */
    THUD_LAW_DEGREE_ONE = 32 /* force is of degree one in (d, v): scaling symmetry */
};

struct thud_law {
    const char *name, *title;
    const char *reference; /* author, journal, volume (year) pages; several parted by "; " */
    const char *summary;   /* the force in one line, for `thud laws` and the manual */
    unsigned flags;
    const struct thud_param *params;
    int nparams;

    /* Functions of a law: only branch and elastic_energy are required, and none of a law without force. */

    /* Checks values against each other and fills setup->constant. Errors: THUD_INPUT with key. */
    enum thud_status (*prepare)(struct thud_law_setup *setup, struct thud_error *err);
    /* Update the memory at contact onset, with approach velocity v (>= 0), and at velocity reversals, with indentation
     * d of the law (without the columns) and the phase that begins. */
    void (*onset)(const struct thud_law_setup *setup, double v_mps, struct thud_law_memory *memory);
    void (*reversal)(const struct thud_law_setup *setup, enum thud_phase phase, double d_m,
                     struct thud_law_memory *memory);
    /* Returns the branch of a phase on one side of the ultimate compression. */
    struct thud_branch (*branch)(const struct thud_law_setup *setup, const struct thud_law_memory *memory,
                                 enum thud_phase phase, bool past_ultimate);
    /* Returns the indentation at which the branch of a phase changes (> 0, the bumper's delta_u); INFINITY: never. */
    double (*ultimate)(const struct thud_law_setup *setup, const struct thud_law_memory *memory, enum thud_phase phase);
    /* Returns the energy that the law would return from indentation d without losses, J. */
    double (*elastic_energy)(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m);
    /* Return the nominal restitution (NULL: the parameter of this name, if any), and the actual one of two free bodies
     * at their first contact with approach velocity v. NaN: not known. */
    double (*nominal)(const struct thud_law_setup *setup);
    double (*restitution)(const struct thud_law_setup *setup, double v_mps);
    /* Returns whether the indentation at release remains as a residual (the paper's concrete with residual = keep). */
    bool (*keeps_residual)(const struct thud_law_setup *setup);
    /* Gives the n-th (from 0) remark on unusual combinations of values, with the parameter as key; false: no more. */
    bool (*unusual)(const struct thud_law_setup *setup, int n, struct thud_error *out);
};
/* A law's parameters: an array. */
#define THUD_LAW_PARAMS(array) .params = (array), .nparams = sizeof(array) / sizeof *(array)

/* Returns whether a contact is propagated exactly; this includes impulses. */
static inline bool thud_law_is_linear(const struct thud_law *law)
{
    return law->flags & (THUD_LAW_NO_FORCE | THUD_LAW_IMPULSIVE | THUD_LAW_LINEAR);
}

/* Soil behind a wall (stiffness, strength, ratio); not listed, since it is not a law for bodies that collide. */
extern const struct thud_law thud_law_backfill;
/* List of laws, ended by NULL; a program that links the library may define its own. */
extern const struct thud_law *const thud_laws[];
int thud_law_count(void);
const struct thud_law *thud_law_at(int index);
const struct thud_law *thud_law_find(const char *name);           /* NULL when unknown */
int thud_law_param(const struct thud_law *law, const char *name); /* index, or -1 */

/* Fills value[] with the table's defaults (NaN: a value is required). */
void thud_law_defaults(const struct thud_law *law, struct thud_law_setup *setup);

/* Tables of d^p for one p, and that power, to a relative 1e-14. */
enum { THUD_POWER_CELLS = 128, THUD_POWER_LEAST = -64, THUD_POWER_OCTAVES = 72, THUD_POWER_TERMS = 7 };
struct thud_powers {
    double p, binomial[THUD_POWER_TERMS], inverse[THUD_POWER_CELLS], cell[THUD_POWER_CELLS], octave[THUD_POWER_OCTAVES];
};
void thud_powers_fill(struct thud_powers *powers, double p);
double thud_power(const struct thud_powers *powers, double d);

/* Computes the force of a branch, not cut at 0, and its partial derivatives (each may be NULL); d <= 0 gives only the
 * linear part. At d = 0 the derivatives are right-sided: df_dd is infinite for a power below 1 (jankowski at v != 0).
 */

double thud_branch_force(const struct thud_branch *branch, double d_m, double v_mps, double *df_dd, double *df_dv);
/* Whether the force begins and ends at d = 0 with no slope, whatever the rate. */
static inline bool thud_branch_is_smooth(const struct thud_branch *b)
{
    return b->f0_n == 0 && b->k_npm == 0 && b->c_nspm == 0 && b->soft_m == 0 && b->p > 1 && (b->D == 0 || b->r > 1);
}

/* ---- a law with struck columns ----
 *
 * Struck columns deflect under the force of the contact, as a spring in series with the law's elastic curve: F_A =
 * law(d - F_A/column_npm) at the indentation d of both together. The law applies its damping to that curve, so that two
 * free bodies separate with the specified restitution, as without columns. A linear law keeps its form, with the
 * stiffness k column/(k + column); F_A (1 + s v) keeps its s; the dashpot of jankowski is 2 z F_A/sqrt(2 U/m), with U
 * the energy of law and columns together. Without columns these are the law's own functions, or their defaults. */

/* Checks values against each other, includes the columns in a linear law's stiffness, fills setup->constant, and
 * refuses what the list above does not allow. Errors: THUD_INPUT with key. */
enum thud_status thud_law_prepare(const struct thud_law *law, struct thud_law_setup *setup, struct thud_error *err);
void thud_law_onset(const struct thud_law *law, const struct thud_law_setup *setup, double v_mps,
                    struct thud_law_memory *memory);
void thud_law_reversal(const struct thud_law *law, const struct thud_law_setup *setup, enum thud_phase phase,
                       double d_m, struct thud_law_memory *memory);
struct thud_branch thud_law_branch(const struct thud_law *law, const struct thud_law_setup *setup,
                                   const struct thud_law_memory *memory, enum thud_phase phase, bool past_ultimate);
/* Returns the branch at indentation d, on its side of the ultimate compression. */
struct thud_branch thud_law_branch_at(const struct thud_law *law, const struct thud_law_setup *setup,
                                      const struct thud_law_memory *memory, enum thud_phase phase, double d_m);
/* Returns the indentation (m) at which the branch changes; INFINITY: none. */
double thud_law_ultimate(const struct thud_law *law, const struct thud_law_setup *setup,
                         const struct thud_law_memory *memory, enum thud_phase phase);
/* Returns the energy stored at indentation d, J; 0 for laws without force. */
double thud_law_energy(const struct thud_law *law, const struct thud_law_setup *setup,
                       const struct thud_law_memory *memory, enum thud_phase phase, double d_m);
double thud_law_nominal(const struct thud_law *law, const struct thud_law_setup *setup);
double thud_law_restitution(const struct thud_law *law, const struct thud_law_setup *setup, double v_mps);
