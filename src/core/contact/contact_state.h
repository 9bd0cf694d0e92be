/* What a motion goes on from: the model, the ground motion, the time, the modal state and the states of the contacts.
 * Methods read it and make a segment (core/segment.h); contacts are switched in it; only the run commits to it. */
#pragma once

#include <math.h>
#include <stdbool.h>

#include "base/arena.h"
#include "base/largest.h"
#include "base/status.h"
#include "core/model/model.h"
#include "core/model/result.h"
#include "core/numerics/tolerance.h"
#include "ground/record.h"

enum thud_contact_mode {
    THUD_OPEN,            /* no contact */
    THUD_CLOSED,          /* in contact, force by the law's branch */
    THUD_CLOSED_NO_FORCE, /* indented, but the law's force would pull and is cut at 0 */
    THUD_STICKING         /* sticking: d' = 0, kept so by a constraint force */
};

/* Guards suppressed at an event: that many of the lowest Taylor coefficients of the function that a guard watches are 0
 * but for rounding, and are taken as 0. */
struct thud_suppressed {
    int indentation, rate, branch, force;
};

struct thud_contact_state {
    enum thud_contact_mode mode;
    enum thud_phase phase;
    bool past_ultimate;
    struct thud_branch branch;
    struct thud_law_memory memory;
    double onset_mps; /* approach velocity at contact onset */
    struct thud_suppressed suppressed;
    double ultimate_m; /* indentation at which the branch changes; INFINITY where there is none */
    double constraint_low_n, constraint_high_n; /* STICKING: interval of the constraint force, N */
    double expected_force_n; /* of this contact, from its approach velocity: scale of the error measure */
    double residual_m;
};

/* A storey that yields: core/contact/storey.h. */
struct thud_storey_state {
    struct thud_branch branch; /* force of its row: constant; linear while it yields and events are located */
    int direction;             /* +1, -1: it yields, and which way; 0: elastic */
    double plastic_m;          /* d_p */
    int suppressed;      /* suppressed coefficients: yielding, of the drift's rate; elastic, of the distance from the */
    int suppressed_side; /* bound on this side */
    double moved_m;      /* plastic drift of the excursion that goes on */
    bool counted;        /* it is among the excursions */
    int excursions;      /* so far, and */
    double hysteretic_j; /* energy lost */
    struct thud_peak shear; /* largest since the storey first yielded */
};

enum { THUD_STEPS_AT_ONCE = 16 };

struct thud_state {
    const struct thud_model *model;
    const struct thud_record *record; /* NULL: no ground motion */

    /* Time is grid * grid_dt_s + offset_s; the ground motion has its kinks at the grid. */
    double grid_dt_s, offset_s, end_s;
    long grid;
    double *q, *qd;                     /* (nmodes) in one block */
    struct thud_contact_state *contact; /* (ncontacts) */
    struct thud_storey_state *storey;   /* (nstoreys) */
    int nactive;                        /* contacts CLOSED or STICKING */
    int nindented;                      /* contacts that are not OPEN */
    int nyielding, nshifted; /* storeys that yield now; elastic ones with a plastic drift: a constant force */

    /* What is asked of a method. */
    bool locates; /* events are located; else contacts are updated at the ends of steps */
    bool inside;  /* the motion inside steps is wanted: located events, histories, storeys that yield, struck columns */
    int at_once; /* steps that may be proposed as one segment: 1, but where nothing reads more of a step than its ends */
    double energy_most; /* sum of omega^2 q^2 + q'^2 that no response comes to but one that blows up */
    double tolerance;   /* relative, of contact forces and adaptive steps */
    double step_s;      /* longest fixed step; NaN for methods without one */
    double step_cap_s;  /* the next step is to be no longer */

    double ground_mps2; /* acceleration scale: peak of the ground motion */
    double speed_mps; /* velocity scale for rounding tests: largest initial speed of a floor plus that of the ground */
    double length_m;  /* length scale: one second at that speed or acceleration, and how far floors start from rest */
    double touch_m;   /* of it, below which an indentation is no contact */
    double fastest_radps; /* of the model */

    struct thud_work *work;     /* counters */
    struct thud_blocks *memory; /* of the run: of all that is made for it */
    double *free_mps2;          /* (nmodes + nrows) workspace of state.c */
    int *set_now;               /* (2 nrows) and */
    double *collide;            /* workspace of impulse.c */
    struct thud_powers *powers; /* of one exponent that is none of the published ones, once a branch has it */
    double *force_now;          /* (nrows) workspace of the functions that switch a contact */
    double *delassus;           /* (nrows x nrows), and as much as thud_lcp_work asks for: workspace of state.c */
};

/* All at t = 0, open, with the model's initial motion. `end_s`, `grid_dt_s` and what is asked of a method are the
 * caller's. Errors: THUD_MEMORY. */
enum thud_status thud_state_init(struct thud_state *state, const struct thud_model *model,
                                 const struct thud_record *record, struct thud_work *work, struct thud_blocks *memory,
                                 struct thud_error *err);

static inline double thud_state_now(const struct thud_state *state)
{
    return (double)state->grid * state->grid_dt_s + state->offset_s;
}

/* Time to the next kink of the ground motion or the end. */
static inline double thud_state_remaining(const struct thud_state *state)
{
    return thud_smaller(state->grid_dt_s - state->offset_s, state->end_s - thud_state_now(state));
}

/* Ground acceleration at the two ends of grid interval i. */
static inline void thud_state_ground(const struct thud_state *state, long i, double *a0, double *a1)
{
    const struct thud_record *r = state->record;
    bool inside = r && (size_t)(i + 1) < r->samples;
    *a0 = inside ? r->a_mps2[i] : 0;
    *a1 = inside ? r->a_mps2[i + 1] : 0;
}

/* Rows: the contacts, and behind them the storeys that yield. Whose row it is: that contact's state, or NULL. */
static inline const struct thud_contact_state *thud_row_contact(const struct thud_state *state, int row)
{
    return row < state->model->ncontacts ? &state->contact[row] : NULL;
}

/* What the row's force follows, and whether it does so now: the contact is CLOSED, the storey yields. */
static inline const struct thud_branch *thud_row_branch(const struct thud_state *state, int row)
{
    const struct thud_contact_state *contact = thud_row_contact(state, row);
    return contact ? &contact->branch : &state->storey[row - state->model->ncontacts].branch;
}
static inline bool thud_row_by_branch(const struct thud_state *state, int row)
{
    const struct thud_contact_state *contact = thud_row_contact(state, row);
    return contact ? contact->mode == THUD_CLOSED
                   : state->locates && state->storey[row - state->model->ncontacts].direction != 0;
}

static inline bool thud_row_sticks(const struct thud_state *state, int row)
{
    const struct thud_contact_state *contact = thud_row_contact(state, row);
    return contact && contact->mode == THUD_STICKING;
}

/* The row's force depends on the motion, or is a constraint force. */
static inline bool thud_row_acts(const struct thud_state *state, int row)
{
    return thud_row_by_branch(state, row) || thud_row_sticks(state, row);
}

/* An event has just put the row's indentation to 0, from where it starts. */
static inline bool thud_row_starts_at_zero(const struct thud_state *state, int row)
{
    const struct thud_contact_state *contact = thud_row_contact(state, row);
    return contact && contact->suppressed.indentation > 0;
}

/* Clearance of a row's contact with what impacts have added to it; 0 of a storey. */
static inline double thud_state_clearance(const struct thud_state *state, int row)
{
    const struct thud_contact_state *contact = thud_row_contact(state, row);
    return contact ? state->model->contact[row].clearance_m + contact->residual_m : 0;
}

/* No force depends on the motion but those of the elastic structures. */
static inline bool thud_state_is_free(const struct thud_state *state)
{
    return state->nactive == 0 && state->nyielding == 0;
}

static inline bool thud_contact_acts(const struct thud_contact_state *s)
{
    return s->mode == THUD_CLOSED || s->mode == THUD_STICKING;
}

/* Least scale of the errors of a contact's force, N. */
static inline double thud_contact_least_force(const struct thud_state *state, int c)
{
    return state->model->contact[c].setup.mass_kg *
           thud_larger(THUD_TOL_GROUND_FORCE * state->ground_mps2, THUD_TOL_LEAST_ACCELERATION_PS2 * state->length_m);
}

/* A parting slower than this is taken as the end of a row of ever smaller bounces: the contact comes to rest. No units
 * of its own: the same scene in other ones, or a larger one, comes to rest at the same moment. */
static inline double thud_rest_speed(const struct thud_state *state)
{
    return thud_larger(1e-4 * state->tolerance, THUD_TOL_REST) * state->speed_mps;
}

/* Kinetic energy of the structures, and what their storeys would give back, J. */
double thud_state_kinetic(const struct thud_state *state);
double thud_state_strain(const struct thud_state *state);
/* Work of the weight by modal coordinates q, J: the sum of W d^2/(2 h). Strain is what the storeys give back less this.
 */
double thud_model_gravity_work(const struct thud_model *model, const double *q);

/* The step of a fixed-step method that was given none: a twentieth of the shortest period, of a mode or of a contact at
 * an approach velocity of 1 m/s, and not above the record's step. */
double thud_state_default_step(const struct thud_state *state);

/* THUD_DIVERGED: contacts stick or collide at once whose forces the modes that stay do not tell apart. */
enum thud_status thud_state_too_few_modes(const struct thud_state *state, struct thud_error *err);

/* Indentation of contact c, and its rate; both, out (2), from one walk through the modes. */
double thud_contact_indentation(const struct thud_state *state, int c);
void thud_contact_motion(const struct thud_state *state, int c, double *out);
/* Elastic energy that contact c holds now. */
double thud_contact_stored(const struct thud_state *state, int c);
double thud_contact_rate(const struct thud_state *state, int c);
/* Force of a row (of a contact cut at 0 where the law does not pull) at indentation d and rate v, by its present branch;
 * 0 where it does not follow that. */
double thud_row_force(const struct thud_state *state, int row, double d, double v);
/* How far rounding alone may put a force off that has these slopes, by the displacements and rates that an indentation and
 * its rate are differences of, N. */
double thud_row_force_noise(const struct thud_state *state, int row, double by_d, double by_v);
/* Forces of all rows into force (nrows); that of STICKING contacts from the condition d'' = 0. */
void thud_contact_forces(const struct thud_state *state, double *force);
/* The same if the force of one contact that does not stick were this. */
void thud_contact_forces_given(const struct thud_state *state, int given, double given_n, double *force);
/* Second rate of the indentation of contact c under these forces. */
double thud_contact_acceleration(const struct thud_state *state, int c, const double *force);
/* More than rounding makes of the second rate of an indentation that is 0. */
static inline double thud_contact_rounding(const struct thud_state *state)
{
    return THUD_TOL_ACCELERATION * (state->ground_mps2 + state->speed_mps * state->fastest_radps);
}
/* Second rate of the modal coordinates without contact forces, out (nmodes). */
void thud_model_acceleration(const struct thud_model *model, const double *q, const double *qd, double ground,
                             double *restrict out);
/* From that to the second rate with these contact forces. */
void thud_model_apply_contact_forces(const struct thud_model *model, const double *force, double *qdd);
/* The same of one row of the Jacobian alone, in the modes that it moves. */
static inline void thud_model_apply_contact_force(const struct thud_model *model, int c, double force,
                                                  double *restrict qdd)
{
    const double *restrict g = model->jacobian + (size_t)c * (size_t)model->nmodes;
    int structure[2], n = thud_model_row_structures(model, c, structure);
    for (int i = 0; i < n; i++) {
        const struct thud_model_structure *s = &model->structure[structure[i]];
        for (int j = s->first_mode; j < s->first_mode + s->modes; j++)
            qdd[j] -= g[j] * force;
    }
}
/* Fills the constraint forces of the STICKING contacts from d'' = 0, given the accelerations without contact forces and the
 * other contacts' forces. */
void thud_contact_constraint_forces(const struct thud_state *state, const double *free, double *force);
