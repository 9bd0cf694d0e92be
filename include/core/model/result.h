/* Result of a run. Every peak is that of the continuous history (both sides of jumps, maxima inside steps). SI units.
 */
#pragma once

#include <assert.h>
#include <stdbool.h>
#include <stddef.h>

struct thud_peak {
    double value;  /* largest absolute value */
    double time_s; /* when */
};

struct thud_floor_result {
    struct thud_peak acceleration; /* total, m/s2 */
    struct thud_peak displacement; /* relative to the ground, m */
    struct thud_peak velocity;     /* relative to the ground, m/s */
    struct thud_peak drift;        /* interstorey drift, m; 0 for a rigid body */
    struct thud_peak lean;         /* drift on which the weight acts: on soil with the foundation's rotation, m */
    struct thud_peak shear;        /* of the storey below, N; 0 for a rigid body */
    struct thud_peak moment;       /* of the lowest floor: overturning moment about the base, N m; 0 if not required */
};

enum { THUD_FLOOR_DISPLACEMENT, THUD_FLOOR_VELOCITY, THUD_FLOOR_ACCELERATION, THUD_FLOOR_DRIFT, THUD_FLOOR_QUANTITIES };

struct thud_contact_result {
    int interface, left_floor, right_floor; /* from 1, left to right; floor 0: a wall */
    int struck; /* the side whose columns, below that floor, are struck by the other's slab: -1 left, 1 right; 0 none */
    int column; /* index of those columns; -1 */
    double eta; /* relative height of the struck point in its storey; 1: floor to floor */
    int impacts;                  /* those with an impulse above 1e-11 of effective mass times velocity scale */
    struct thud_peak force;       /* N */
    struct thud_peak indentation; /* m */
    double impulse_ns, contact_time_s, residual_m;
    double work_j, stored_j, dissipated_j; /* work done on it, the part stored as elastic energy at the end, the rest */
    double approach_mps, separation_mps;   /* of the last impact */
    double restitution;                    /* of the last impact; NaN: no approach, no separation, or a long contact */
    double nominal_restitution;            /* as specified */
    bool impulsive;                        /* its law has impulses */
};

/* Link between floors of neighbours, or between a floor and the ground. */
struct thud_link_result {
    struct thud_peak force;  /* N */
    struct thud_peak stroke; /* change of the distance of its ends; beyond the slack of a one-sided link, m */
    double lost_j;           /* in its dashpot, by its law, or by friction */
    double stored_j;         /* elastic energy at the end */
    double
        residual_m; /* stroke without force at the end: slip of friction, or the gap of soil; NaN: none is possible */
    int engaged;    /* number of times that a one-sided link engaged or a friction link slipped */
    int contact;    /* row of its events; -1: none */
};

/* Peaks in the columns of a storey struck by a slab, positive to the right: shears just above their lower and just
 * below their upper end, and the bending moments there. A shear is the force by which the part above pushes the part
 * below; where the storey drifts to the right, the moment is positive at the lower end and negative at the upper. */
enum thud_column_quantity {
    THUD_COLUMN_SHEAR_LOWER,
    THUD_COLUMN_SHEAR_UPPER,
    THUD_COLUMN_MOMENT_LOWER,
    THUD_COLUMN_MOMENT_UPPER,
    THUD_COLUMN_QUANTITIES
};

/* Columns of a storey that slabs of one neighbour strike: the storey's drift and the forces on them. */
struct thud_column_result {
    int interface, structure, storey;              /* interface and storey from 1, structure from 0 */
    struct thud_peak peak[THUD_COLUMN_QUANTITIES]; /* N, N m */
    double capacity_n, ratio;                      /* against shear, and the larger shear over it; NaN: not given */
    bool drifts; /* their stiffness is given, so the drift of the storey is included; else only the forces */
};

/* Returns whether there were impulses: then neither the force nor the floor acceleration is finite. */
static inline bool thud_contact_struck(const struct thud_contact_result *contact)
{
    return contact->impulsive && contact->impacts > 0;
}

/* Event: a guard of a contact or of a storey crossed zero, and the state was switched. */
struct thud_event_entry {
    double time_s;
    int row; /* Jacobian row: a contact, then the storeys that yield; beyond the rows, the floor above a collapse */
    const char *event, *guard, *then; /* name of the event, quantity of the guard, new state */
    int order;      /* number of lowest coefficients of the guard that were set to 0 because of the event before */
    double force_n; /* just after it; of a storey without that of its elastic stiffness */
};

/* Impact, from contact onset to release. */
struct thud_impact {
    int contact; /* index into contacts, from 0 */
    double start_s, duration_s, approach_mps, separation_mps, force_n, indentation_m, impulse_ns, dissipated_j;
    double restitution; /* NaN: no approach, no separation, or a long contact */
};

struct thud_energy {
    double input_j, kinetic_j, strain_j, viscous_j,
        contact_j;    /* at the end; strain: recoverable energy of the storeys; contact: dissipated by the contacts */
    double initial_j; /* kinetic at the start */
    double stored_j;  /* elastic energy in contacts still closed */
    double hysteretic_j; /* lost in storeys that yield and links that slip */
    double gravity_j;    /* work of the weight on drifting storeys: P-Delta */
    double error_ratio;  /* |initial + input - all the others| over the largest energy so far */
};

/* Yielding storey below a floor. */
struct thud_storey_result {
    bool yields;
    double yield_m, hardening; /* d_y and r */
    double ductility;          /* peak drift over yield drift */
    double plastic_m;          /* d_p at the end */
    double permanent_m;        /* drift at which it carries no force, (1 - r) d_p */
    int excursions;            /* number of times it yielded */
    double hysteretic_j;       /* energy lost */
    struct thud_peak shear;    /* N */
};

struct thud_structure_result {
    int floors;
    struct thud_floor_result *floor; /* (floors), lowest first; an isolated building's floor 1 is its base slab */
    /* On soil, after the floors: the foundation's sway, and its rotation as the displacement at `arm_m`; else NULL. */
    struct thud_floor_result *foundation;
    double arm_m;
    struct thud_storey_result *storey; /* (floors); NULL if none of them yields */
    double rigid_period_s,
        soil_damping;             /* on soil: its first period on rigid ground, and the damping ratio of its first
                                            mode as it is; else 0 */
    double soil_stored_j;         /* on soil: in the springs of sway and rocking at the end */
    struct thud_peak base_shear;  /* N */
    struct thud_peak overturning; /* moment about the base, N m; 0 if not required */
    double *period_s;             /* (floors), longest first; INFINITY for a free rigid body */
};

/* Collapse with P-Delta: a storey's drift has reached a tenth of its height, which ends the run. */
struct thud_collapse {
    bool happened;
    int structure, floor; /* from 0: the storey below that floor */
    double time_s, drift_m;
};

struct thud_work {
    long steps, force_evaluations, events;
    long rejected;       /* repeated steps */
    long samples_fast;   /* record samples advanced by the contact-free recurrence */
    long samples_jumped; /* record samples skipped because no contact or new peak could follow */
};

struct thud_result {
    int nstructures, ncontacts, ncolumns, nlinks; /* contacts: of neighbours' floors */
    struct thud_structure_result *structure;      /* (nstructures) */
    struct thud_contact_result *contact;          /* (ncontacts) */
    struct thud_column_result *column;            /* (ncolumns) */
    struct thud_link_result *link;                /* (nlinks) */
    struct thud_energy energy;
    struct thud_collapse collapse;
    struct thud_work work;
    double end_s;       /* where the run ended */
    double step_s;      /* a fixed-step method's, from one sample of the ground motion to the next; else NaN */
    const char *method; /* the method that was used */
    const char *reason; /* why `auto` selected it; "" if it was named */
};

/* Columns of a history in their order: X(function, number of columns of its quantity). Energies: input, kinetic, strain,
 * viscous, contact. A link's force is above 0 where it pushes its ends apart; its stroke is their approach. */
#define THUD_HISTORY_LIST(X)                                                                                           \
    X(thud_history_ground, 1)                                                                                          \
    X(thud_history_displacement, h->ndof)                                                                              \
    X(thud_history_velocity, h->ndof)                                                                                  \
    X(thud_history_acceleration, h->ndof) /* total */                                                                  \
    X(thud_history_force, h->ncontacts)                                                                                \
    X(thud_history_indentation, h->ncontacts)                                                                          \
    X(thud_history_energy, THUD_HISTORY_ENERGIES)                                                                      \
    X(thud_history_hysteretic, h->loses) /* energy lost in storeys and links of friction */                            \
    X(thud_history_storey_drift, h->nstoreys)                                                                          \
    X(thud_history_storey_shear, h->nstoreys)                                                                          \
    X(thud_history_storey_plastic, h->nstoreys)                                                                        \
    X(thud_history_column_shear, 2 * h->nstruck) /* at the lower and the upper end of struck columns */                \
    X(thud_history_link_force, h->nlinks)                                                                              \
    X(thud_history_link_stroke, h->nlinks)                                                                             \
    X(thud_history_gravity, h->weighs) /* work of the weight */
enum { THUD_HISTORY_ENERGIES = 5 };
enum thud_history_quantity {
#define THUD_HISTORY(name, count) name##_at,
    THUD_HISTORY_LIST(THUD_HISTORY) THUD_HISTORY_QUANTITIES
#undef THUD_HISTORY
};

/* Sampled histories, one row per time; at jumps the time appears twice. */
struct thud_history {
    int ndof, ncontacts, nstoreys, nstruck, nlinks, columns;
    bool loses;                             /* storeys yield or links slip */
    bool weighs;                            /* P-Delta */
    int first[THUD_HISTORY_QUANTITIES + 1]; /* columns of the quantities, and what comes after */
    size_t rows;
    double *time_s; /* (rows) */
    double *value;  /* (rows x columns), row-major */
};
/* Fills first and columns. */
void thud_history_lay_out(struct thud_history *h);
/* Each function of the list returns the column of the floor, contact, energy, storey or link of this index, else of 0. */
#define THUD_HISTORY(name, count)                                                                                      \
    static inline int name(const struct thud_history *h, int index)                                                    \
    {                                                                                                                  \
        assert(index >= 0 && h->first[name##_at] + index < h->first[name##_at + 1]);                                   \
        return h->first[name##_at] + index;                                                                            \
    }
THUD_HISTORY_LIST(THUD_HISTORY)
#undef THUD_HISTORY
