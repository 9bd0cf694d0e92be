/* Impact laws. A law is one const table in its own file, registered by one word in src/core/law_list.h.
 *
 * Every law of the field is, between two switches, of the form
 *     F = f0 + k d + c v + K d^p + D d^r v           (d indentation > 0, v = d' , v > 0 approaching)
 * which is called a branch here. So a law only says which branch holds; force, derivatives, integration and energy are
 * written once. Public functions take SI units. */
#ifndef THUD_CORE_LAW_H
#define THUD_CORE_LAW_H

#include <stdbool.h>

#include "base/param.h"
#include "base/status.h"

#define THUD_LAW_PARAMS_MAX    16
#define THUD_LAW_CONSTANTS_MAX 8

struct thud_branch {
    double f0_n, k_npm, c_nspm;
    double K, p;       /* K d^p, p > 0 */
    double D, r;       /* D d^r v, r > 0 */
    double column_npm; /* a spring in series with K d^p; 0: none */
};

enum thud_phase { THUD_APPROACH, THUD_RESTITUTION };

/* What is fixed for one contact. */
struct thud_law_setup {
    double mass_kg;                    /* effective mass m1 m2/(m1 + m2) */
    double thickness_m;                /* of the bumper; 0 where there is none */
    double column_npm;                 /* stiffness of the columns that are struck, in series with the law; 0: none */
    double value[THUD_LAW_PARAMS_MAX]; /* parameters in SI, in the order of the law's table */
    double constant[THUD_LAW_CONSTANTS_MAX]; /* filled by the law's prepare */
};

/* What one contact remembers from its onset on. Only the run writes it. */
struct thud_law_memory {
    double v_imp_mps; /* closing velocity at contact onset, as it was */
    double damp;      /* the law's own damping factor for this contact, set by onset or reversal */
};

enum {
    THUD_LAW_LINEAR = 1,     /* every branch is linear: contact is propagated exactly */
    THUD_LAW_REVERSES = 2,   /* approach and restitution have different branches */
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

    /* Checks values against each other and fills setup->constant. Errors: THUD_INPUT with key. */
    enum thud_status (*prepare)(struct thud_law_setup *setup, struct thud_error *err);
    /* At contact onset with closing velocity v (>= 0); fills the memory. */
    void (*onset)(const struct thud_law_setup *setup, double v_mps, struct thud_law_memory *memory);
    /* At each velocity reversal from approach to restitution at indentation d, of the law alone; NULL where nothing changes. */
    void (*reversal)(const struct thud_law_setup *setup, double d_m, struct thud_law_memory *memory);
    /* The branch that holds in a phase on one side of the ultimate compression. */
    struct thud_branch (*branch)(const struct thud_law_setup *setup, const struct thud_law_memory *memory,
                                 enum thud_phase phase, bool past_ultimate);
    /* Indentation at which the branch changes (the bumper's delta_u); NULL where there is none. */
    double (*ultimate)(const struct thud_law_setup *setup);
    /* Energy stored under the elastic curve at indentation d, J. */
    double (*elastic_energy)(const struct thud_law_setup *setup, double d_m);
    /* Nominal restitution as asked for, and the one two free bodies really part with at closing velocity v. */
    double (*nominal)(const struct thud_law_setup *setup);
    double (*restitution)(const struct thud_law_setup *setup, double v_mps);
    /* true where the indentation left at release stays as residual (the paper's concrete with residual = keep); NULL:
     * never. */
    bool (*keeps_residual)(const struct thud_law_setup *setup);
    /* The n-th (from 0) thing that is unusual about the values together, as a message with the parameter as key; false
     * when there are no more. NULL: there is none. */
    bool (*unusual)(const struct thud_law_setup *setup, int n, struct thud_error *out);
};

/* The list. */
int thud_law_count(void);
const struct thud_law *thud_law_at(int index);
const struct thud_law *thud_law_find(const char *name);           /* NULL when unknown */
int thud_law_param(const struct thud_law *law, const char *name); /* index, or -1 */

/* Fills value[] with the defaults of the table (NaN where a value must be given). */
void thud_law_defaults(const struct thud_law *law, struct thud_law_setup *setup);

/* Force of a branch, and its partial derivatives (each may be NULL); d <= 0 gives the linear part only. Not cut at 0.
 * At d = 0 the derivatives are those from the right: df_dd is infinite there for a power below 1 (jankowski at v != 0).
 */
double thud_branch_force(const struct thud_branch *branch, double d_m, double v_mps, double *df_dd, double *df_dv);

/* ---- a law and the columns that are struck ----
 *
 * Struck columns give under the force of the contact, a spring in series with the law's elastic curve: F_A = law(d -
 * F_A/column_npm) at the indentation d of the two together. Damping is what the law makes of that curve, so that two
 * free bodies part with the restitution asked for as they do without columns: a linear law is the same law with the
 * stiffness k column/(k + column); F_A (1 + s v) keeps its s; the dashpot of jankowski is 2 z F_A/sqrt(2 U/m), U the
 * energy of law and columns together. Without columns all of these are the law's own functions. */

/* Checks values against each other, puts the columns into a linear law's stiffness, and fills setup->constant. Errors:
 * THUD_INPUT with key. */
enum thud_status thud_law_prepare(const struct thud_law *law, struct thud_law_setup *setup, struct thud_error *err);
void thud_law_reversal(const struct thud_law *law, const struct thud_law_setup *setup, double d_m,
                       struct thud_law_memory *memory);
struct thud_branch thud_law_branch(const struct thud_law *law, const struct thud_law_setup *setup,
                                   const struct thud_law_memory *memory, enum thud_phase phase, bool past_ultimate);
/* Indentation at which the branch changes; INFINITY where there is none. */
double thud_law_ultimate(const struct thud_law *law, const struct thud_law_setup *setup);
/* Energy stored at indentation d, J. */
double thud_law_energy(const struct thud_law *law, const struct thud_law_setup *setup, double d_m);

/* Branch at (d, phase) without a run: picks the side of the ultimate compression. */
struct thud_branch thud_law_branch_at(const struct thud_law *law, const struct thud_law_setup *setup,
                                      const struct thud_law_memory *memory, enum thud_phase phase, double d_m);

#endif
