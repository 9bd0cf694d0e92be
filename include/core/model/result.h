/* Result of a run. Every peak is that of the continuous history (both sides of jumps, maxima inside steps). SI units.
 */
#pragma once

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
    struct thud_peak lean;         /* the drift on which the weight acts: on soil with the foundation's rotation, m */
    struct thud_peak shear;        /* of the storey below, N; 0 for a rigid body */
    struct thud_peak
        moment; /* of the lowest floor: overturning moment about the base, N m; 0 where it is not asked for */
};

enum { THUD_FLOOR_DISPLACEMENT, THUD_FLOOR_VELOCITY, THUD_FLOOR_ACCELERATION, THUD_FLOOR_DRIFT, THUD_FLOOR_QUANTITIES };

struct thud_contact_result {
    int interface, left_floor, right_floor; /* from 1, left to right; floor 0: a wall */
    int struck;  /* whose columns the other's slab strikes, below that floor: -1 the left one's, 1 the right one's */
    int column;  /* index of those columns; -1 */
    double eta;  /* height of the struck place in its storey; 1: floor to floor */
    int impacts; /* those with an impulse above 1e-11 of effective mass times velocity scale */
    struct thud_peak force;       /* N */
    struct thud_peak indentation; /* m */
    double impulse_ns, contact_time_s, residual_m;
    double work_j, stored_j, dissipated_j; /* done on it; of that held as elastic energy at the end, and the rest */
    double approach_mps, separation_mps;   /* of the last impact */
    double restitution;                    /* of the last impact; NaN: it did not close or part, or was long */
    double nominal_restitution;            /* as asked for */
    bool impulsive;                        /* its law passes impulses */
};

/* Link between two floors, of neighbours or of one and the ground. */
struct thud_link_result {
    struct thud_peak force;  /* N */
    struct thud_peak stroke; /* change of the distance of its ends; of a one-sided one beyond its slack, m */
    double lost_j;           /* in its dashpot, by its law, or by friction */
    double stored_j;         /* elastic energy at the end */
    double residual_m; /* left of its stroke at the end where it bears nothing: by friction, or the gap at soil; NaN:
                                it leaves none */
    int engaged;       /* times a one-sided one came to act, or one of friction slipped */
    int contact;       /* row of its events; -1: it has none */
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
    bool drifts; /* their stiffness is given, so that the drift of the storey counts; else the forces alone */
};

/* Returns whether impulses struck: no finite force, also while pushed afterwards, and no finite floor acceleration. */
static inline bool thud_contact_struck(const struct thud_contact_result *contact)
{
    return contact->impulsive && contact->impacts > 0;
}

/* Event: a guard of a contact or of a storey passed 0, and its state was switched. */
struct thud_event_entry {
    double time_s;
    int row; /* contact; from the number of contacts on, a storey that yields; from that of rows on, a floor above a
                collapse */
    const char *event, *guard, *then; /* what happened, what the guard watches, the state it went into */
    int order;      /* lowest coefficients of the guard that were taken as 0, as the last event had just put it there */
    double force_n; /* just behind it, of a storey beside that of its elastic stiffness */
};

/* Impact, from contact onset to release. */
struct thud_impact {
    int contact; /* index into contacts, from 0 */
    double start_s, duration_s, approach_mps, separation_mps, force_n, indentation_m, impulse_ns, dissipated_j;
    double restitution; /* NaN: it did not close or part, or was long */
};

struct thud_energy {
    double input_j, kinetic_j, strain_j, viscous_j,
        contact_j;    /* at the end; strain: what storeys would give back; contact: dissipated by the contacts so far */
    double initial_j; /* kinetic at the start */
    double stored_j;  /* elastic energy in contacts still closed */
    double hysteretic_j; /* lost in storeys that yield and links that slip */
    double gravity_j;    /* work of the weight on drifting storeys: P-Delta */
    double error_ratio;  /* |initial + input - all the others| over the largest energy seen */
};

/* Yielding storey, the one below its floor. */
struct thud_storey_result {
    bool yields;
    double yield_m, hardening; /* d_y and r */
    double ductility;          /* peak drift over yield drift */
    double plastic_m;          /* d_p at the end */
    double permanent_m;        /* drift at which it carries no force, (1 - r) d_p */
    int excursions;            /* times it yielded */
    double hysteretic_j;       /* energy lost */
    struct thud_peak shear;    /* N */
};

struct thud_structure_result {
    int floors;
    struct thud_floor_result *floor; /* (floors), lowest first; an isolated building's floor 1 is its base slab */
    /* On soil, after the floors: the foundation's sway, and its rotation as the displacement at `arm_m`; else NULL. */
    struct thud_floor_result *foundation;
    double arm_m;
    struct thud_storey_result *storey; /* (floors); NULL where none of them yields */
    double rigid_period_s,
        soil_damping;             /* on soil: its first period on rigid ground, and the damping ratio of its first
                                            mode as it is; else 0 */
    double soil_stored_j;         /* on soil: in the springs of sway and rocking at the end */
    struct thud_peak base_shear;  /* N */
    struct thud_peak overturning; /* moment about the base, N m; 0 where it is not asked for */
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
    long rejected;       /* steps taken again */
    long samples_fast;   /* record samples passed by the contact-free recurrence */
    long samples_jumped; /* record samples left out because nothing could come of them */
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
    const char *reason; /* why `auto` picked it; "" when it was named */
};

/* Sampled histories, one row per time; at jumps the time appears twice. Columns: a_g, then per floor u, v, a_total
 * (ndof each), then per contact force and indentation, then energies input, kinetic, strain, viscous, contact; where
 * storeys yield or links slip, then the energy lost in them, and for each such storey (nstoreys) drift, shear and plastic
 * drift; then per
 * struck columns (nstruck) the shears at their lower and upper end, and per link its force (> 0: it pushes its ends
 * apart) and by how much they have come closer; with P-Delta last the work of the weight. */
struct thud_history {
    int ndof, ncontacts, nstoreys, nstruck, nlinks, columns;
    bool loses;  /* storeys yield or links slip */
    bool weighs; /* P-Delta */
    size_t rows, capacity;
    double *time_s; /* (rows) */
    double *value;  /* (rows x columns), row-major */
};
enum { THUD_HISTORY_ENERGIES = 5 };
/* Return the columns of quantities. */
int thud_history_ground(void);
int thud_history_displacement(const struct thud_history *h, int dof);
int thud_history_velocity(const struct thud_history *h, int dof);
int thud_history_acceleration(const struct thud_history *h, int dof);
int thud_history_force(const struct thud_history *h, int contact);
int thud_history_indentation(const struct thud_history *h, int contact);
int thud_history_energy(const struct thud_history *h, int which); /* 0 input ... 4 contact */
int thud_history_hysteretic(const struct thud_history *h);
int thud_history_storey_drift(const struct thud_history *h, int storey);
int thud_history_storey_shear(const struct thud_history *h, int storey);
int thud_history_storey_plastic(const struct thud_history *h, int storey);
int thud_history_link_force(const struct thud_history *h, int link);
int thud_history_link_stroke(const struct thud_history *h, int link);
