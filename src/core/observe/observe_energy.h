/* Observer of a run: the energy ledger. Work done by the ground, lost in the structures' damping and in the contacts,
 * each by quadrature of its own power, against the energy that the state holds. What is left over is the error. */
#pragma once

#include "core/contact/contact_log.h"
#include "core/numerics/quadrature.h"
#include "core/numerics/vec.h"
#include "core/observe/observer.h"

/* k x^(k - 1) at the inner points of a quadrature, twice each, by order. */
struct thud_rate_powers {
    thud_vec2_aligned order[THUD_SEGMENT_TERMS][THUD_LOBATTO_INNER];
};

struct thud_ledger {
    const struct thud_contact_log *log;                              /* what impulses have lost */
    double initial_j, input_j, viscous_j, contact_work_j, largest_j; /* contact_work_j: without impulses */
    double balanced_s; /* the last moment looked at when no more was unaccounted for than `limit` */
    double limit;      /* part of the largest energy that may be unaccounted for */
    bool closed;       /* nothing more comes: the balance is that of an earlier moment */
    struct thud_energy balance;
    int looks;
    struct thud_rate_powers *power; /* (THUD_LOBATTO_RULES) */
    double *rates;                  /* (nmodes + 1 x THUD_LOBATTO_INNER + 2) workspace */
    struct thud_contact_work *work; /* (ncontacts) the same */
};

extern const struct thud_observer thud_observe_energy;

/* Errors: THUD_MEMORY. */
enum thud_status thud_ledger_init(struct thud_ledger *ledger, const struct thud_state *state,
                                  const struct thud_contact_log *log, double limit, struct thud_error *err);
/* Begins at this state. */
void thud_ledger_start(struct thud_ledger *ledger, const struct thud_state *state);
/* The balance at the state, kept in ledger->balance. */
void thud_ledger_finish(struct thud_ledger *ledger, const struct thud_state *state);
/* Adds the works over the segment, whose o->work is not read. */
void thud_ledger_add(struct thud_ledger *ledger, const struct thud_observation *o);
/* Work of the ground and loss in the structures' damping over the segment. */
void thud_ledger_structure_work(struct thud_ledger *ledger, const struct thud_observation *o, double *input_j,
                                double *viscous_j);
/* Work done on the contacts so far. */
double thud_ledger_contact_work(const struct thud_ledger *ledger);
