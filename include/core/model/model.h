/* Numerical model of a run, made from a scene by study/scene/assemble and constant afterwards.
 *
 * Modal coordinates: every structure has as many modes as floors, or only its lowest modes, with Phi^T M Phi = I. The
 * modes of all structures are consecutive, and so are their floors: q (nmodes), u (ndof). A floor's displacement is the
 * dot product of its row of Phi with its structure's slice of q. The equations of motion are
 *
 *     q'' + 2 zeta omega q' + omega^2 q = -gamma a_g - sum_c g_c F_c
 *     indentation of contact c = g_c . q - clearance
 *
 * where g_c is the Jacobian row of contact c. A structure whose damping couples its modes (isolated building) has a
 * dense block D instead of 2 zeta omega.
 *
 * Structures connected by linear links (spring and dashpot) are one system. Its modes are those of all its structures
 * and links together, and its damping couples them. Each structure of a system has all modes of the system. One-sided
 * links are contacts, after those of the neighbours' floors.
 *
 * Each storey that yields (bilinear, kinematic hardening) has a Jacobian row after those of the contacts, g = e_i -
 * e_(i-1), and a force in addition to that of its elastic stiffness k: V = k d + F with F = -(1 - r) k d_p. A friction
 * link is such a row with r = 0 after them; its k is included with the links that always act. These rows and forces are
 * used like those of the contacts (motion, accelerations, Delassus matrix).
 *
 * P-Delta: the weight W above a storey of height h adds a force W d/h, a negative stiffness. The modes are those of
 *
 *     K - K_G,   storeys of k - W/h
 *
 * and a storey that yields keeps the force of its row: the weight acts on the whole drift, and beyond yield the slope
 * is r k - W/h, which may be negative. k, V and the strain energy remain those of the storey itself.
 *
 * A building given by its matrix has a symmetric, positive definite K of its floors. The shear of storey i is the sum
 * of K u over the floors from i up, with the drifts d of the storeys:
 *
 *     V_i = sum_j s_ij q_j,   s_ij = sum_(k >= i) sum_l K_kl phi_lj
 *         = sum_l T_il d_l,   T_il = sum_(k >= i) sum_(p >= l) K_kp
 *
 * T of a shear building is diagonal: the stiffnesses of its storeys.
 *
 * The overturning moment about a building's base, which its isolators resist, is that of inertia, contacts and links,
 *
 *     M = sum_i z_i (m_i a_i + the forces of contacts and links on floor i)
 *       = -sum_j W_j (omega_j^2 q_j + (D q')_j) - sum_k (z_k - z_(k-1)) F_k + sum_l z_l (k d + c d'),   W = z' M Phi
 *
 * with total accelerations a_i, over the storeys that yield (k) and the links that always act (l).
 *
 * A building on soil has two dofs after its floors: the sway u_f of its foundation relative to the ground, and its
 * rotation t (clockwise: upper floors to the right), as the displacement r = H t at the building's height H. With the
 * drift
 *
 *     d_i = u_i - u_(i-1) - (h_i/H) r,   u_0 = u_f
 *
 * its stiffness and damping act on d_i, and the springs and dashpots of the soil on u_f and r, so that damping couples
 * its modes. The weight acts on u_i - u_(i-1), and the ground motion on the translations only. */
#pragma once

#include <stdbool.h>

#include "base/status.h"
#include "core/laws/law.h"
#include "core/model/result.h"

struct thud_model_structure {
    int first, n, dofs;          /* its slice of dofs: one per floor, then on soil the two of the foundation */
    const double *rise;          /* (n) h/H of each storey on soil; else NULL */
    double arm_m;                /* H */
    const double *lean;          /* (n x modes) on soil and with P-Delta: the drifts x_i - x_(i-1) on which the weight
                                    acts, including the foundation's rotation, by modal values; else NULL */
    int first_mode, modes;       /* its slice of modes */
    const double *phi;           /* (n x modes), floor-major: phi[i * modes + j] floor i, mode j */
    const double *damping;       /* (modes x modes) modal damping matrix where it couples modes, else NULL */
    const double *stiffness_npm; /* (n) storeys; NULL for a rigid body and a building by its matrix */
    const double *matrix_npm;    /* (n x n) lateral stiffness of a building by its matrix, else NULL */
    const double *shear;         /* its storey shears: s (n x modes) by modal values, then T (n x n); else NULL */
    bool drifts;                 /* it has storeys */
    const double *level_m,
        *moment;                  /* (n) heights z, and the overturning moment (2 x modes) by modal values and by their
                                       rates; NULL: not required */
    const double *omega;          /* (dofs) its own natural frequencies, including omitted modes, rad/s */
    int system;                   /* index of its system */
    int first_shape;              /* modes of the structures before it, counted for each of them */
    const double *geometric_npm;  /* (n) W/h by which the weight reduces each storey's stiffness; NULL: no P-Delta */
    const double *collapse_m;     /* (n) drift at which a storey has collapsed, INFINITY: never; NULL with the other */
    double collapse_least_m;      /* the least of them */
    double sway_npm, rocking_npm; /* on soil: of its springs, against u_f and against r; else 0 */
    double rigid_period_s, soil_damping; /* on soil: first period on rigid ground, first mode's damping ratio; else 0 */
};

/* Link with d = u_left - u_right (> 0: its ends approach). It always acts, with k d + c d' or, slipping, k (d - d_p),
 * or it is a contact. */
struct thud_model_link {
    int left_dof, right_dof;            /* -1: the ground */
    int contact;                        /* index of its contact; -1: it always acts */
    double sign;                        /* of that contact's force: -1 if it acts in tension */
    double stiffness_npm, damping_nspm; /* of a link that always acts */
    int storey;                         /* of a link that slips, its index among the yielding storeys; else -1 */
    const double *row;                  /* (modes) d by the system's modal values */
    int structure, first_mode, modes;   /* one of the structures that it connects */
};

/* Side of a contact: a floor, a wall, or the point at which a slab strikes the columns between two floors, u = (1 - h)
 * u_below + h u_above. */
struct thud_model_side {
    const double *row;                /* (modes) its value by its structure's modal values */
    int structure, first_mode, modes; /* modes: 0 for a wall */
    int dof, below;                   /* the floor, or the one above and the one below; -1: none (a wall, the ground) */
    double share;                     /* h; 1 for a floor */
    int tilt;                         /* dof of the rotation of a foundation that also moves it; -1: none */
    double by_tilt;                   /* u = (1 - h) u_below + h u_above + by_tilt r */
};

struct thud_model_contact {
    int interface, left_floor, right_floor; /* from 1; 0 for a wall; of struck columns the floor above them */
    int left_dof, right_dof;                /* -1 for a wall */
    struct thud_model_side left, right;
    int struck; /* the side whose columns are struck by the other's slab: -1 left, 1 right; 0: floor to floor */
    int column; /* index of the struck columns; -1 */
    double eta; /* height of the struck point above the lower floor over the column length; 1: floor to floor */
    double per_force[THUD_COLUMN_QUANTITIES]; /* of the struck columns, per unit force of this contact */
    double clearance_m;
    const struct thud_law *law;
    struct thud_law_setup setup;
};

/* Yielding storey: V = r k d + (1 - r) k (d - d_p), |d - d_p| <= d_y. */
struct thud_model_storey {
    int structure, floor; /* from 0: the storey below that floor; of a link, one of its structures, and -1 */
    int link;             /* index of the friction link; -1: a storey */
    double stiffness_npm; /* k */
    double yield_m;       /* d_y */
    double hardening;     /* r, 0 <= r < 1 */
    double geometric_npm; /* W/h; 0 without P-Delta */
};

/* Columns of one storey that slabs of one neighbour strike. */
struct thud_model_column {
    int interface, structure, storey; /* interface and storey from 1, structure from 0 */
    int dof, below;                   /* floors above and below; below -1: the ground */
    const double *row;                /* (modes) drift of the storey by its structure's modal values */
    int first_mode, modes;
    double height_m;
    double capacity_n;                        /* against shear; NaN: not given */
    double per_drift[THUD_COLUMN_QUANTITIES]; /* by drift of the storey; 0 where their stiffness is not given */
    int yielding; /* row of the storey if it yields, since their part is one of V = k d + F, not of k d only; else -1 */
    double per_yield[THUD_COLUMN_QUANTITIES]; /* per unit force of that row: per_drift/k */
};

struct thud_model {
    int nstructures, ndof, nmodes, ncontacts, ncolumns;
    int npairs;                             /* contacts of neighbours' floors; those of links follow */
    int nstoreys, nrows;                    /* storeys that yield; rows: contacts, then these storeys */
    int nslips;                             /* number of these storeys, at the end, that are friction links */
    int nlinks, nsystems, nshapes;          /* nshapes: modes of all structures, common modes counted for each */
    struct thud_model_structure *structure; /* (nstructures) */
    int *system;                            /* (nsystems) first structure of each: all its modes, and its damping */
    struct thud_model_link *link;           /* (nlinks) */
    struct thud_model_contact *contact;     /* (nrows) after the contacts, the sides of each storey, without a law */
    struct thud_model_storey *storey;       /* (nstoreys) */
    struct thud_model_column *column;       /* (ncolumns) */
    bool collapses;                         /* a structure can collapse: P-Delta */
    bool sums;                              /* a structure has `shear` or `moment` */
    bool couples;                           /* the damping of a structure couples its modes */
    unsigned traits;                        /* of its elements except contacts: core/model/element.h */
    int *dof_structure;                     /* (ndof) */
    double *mass_kg;                        /* (ndof); of a rotation, I/H^2 */
    double *omega, *zeta, *gamma;           /* (nmodes); gamma = Phi^T M 1 */
    double *spring, *dashpot;               /* (nmodes): omega^2 and 2 zeta omega */
    double *mode_max;         /* (2 x nmodes): largest part of each mode in a place's displacement, and in a drift */
    double *jacobian;         /* (nrows x nmodes): contact Jacobian, rows g_c */
    double *delassus;         /* (nrows x nrows): Delassus matrix g_a . g_b, 1/kg */
    double *q0, *qd0;         /* (nmodes) at t = 0 */
    double *ground_influence; /* (ndof): part of the ground motion in the modes of a floor; 1 if no mode is omitted */
    int left_out;             /* number of omitted modes */
    double fastest_radps;     /* bound of the rates of free motion: largest omega, or the rate of coupled damping */
};

/* Springs and dashpots of a building on soil, against sway and rocking. */
struct thud_foundation_input {
    double mass_kg, inertia_kgm2;
    double sway_npm, sway_nspm, rocking_nmprad, rocking_nmsprad;
};

/* Input of a structure; arrays are copied. A wall has n = 0. */
struct thud_model_input {
    int nstructures;
    const struct thud_structure_input {
        int n;
        const double *mass_kg;       /* (n) */
        const double *stiffness_npm; /* (n) storey i between floors i - 1 and i; NULL: a free rigid body, or */
        const double *matrix_npm;    /* (n x n) a building by its lateral stiffness, symmetric, positive definite */
        double damping;              /* ratio in every mode (of the superstructure for an isolated building) */
        int modes;                   /* number of lowest modes kept; 0: as in the model's input */
        bool isolated;               /* floor 0 is the base slab, stiffness[0] the isolator */
        double isolation_damping;    /* of the isolator: c = 2 zeta sqrt(k total mass) */
        double velocity_mps;         /* of every floor at t = 0 */
        const double *yield_m;       /* (n) drift at which a storey yields, INFINITY: elastic; NULL: all are elastic */
        const double *hardening;     /* (n) tangent over elastic stiffness beyond yield */
        /* P-Delta: W/h of each storey, less than its stiffness, and the drift at which it has collapsed; both (n), or
         * both NULL */
        const double *geometric_npm, *collapse_m;
        const struct thud_foundation_input *foundation; /* of a building on soil; NULL: on rigid ground */
        const double *rise_m;                           /* (n) storey heights, of a building on soil */
        const double *level_m; /* (n) heights of the floors for the overturning moment; NULL: not required */
    } * structure;
    int ncontacts;
    const struct thud_contact_input {
        int interface, left_floor, right_floor; /* from 1; 0 for a wall */
        int left_structure, right_structure;
        double clearance_m;
        const struct thud_law *law;
        struct thud_law_setup setup; /* value[] and thickness given; mass and constants are filled here */
        struct thud_struck_input {
            int side;          /* as thud_model_contact.struck; its floor is that above the columns */
            double a_m, b_m;   /* distances of the slab from the lower and the upper end of the columns */
            bool hinged;       /* columns hinged at both ends, h = eta; else clamped, h = 3 eta^2 - 2 eta^3 */
            double ei_nm2;     /* bending stiffness of all struck columns together; NaN: they do not deflect */
            double capacity_n; /* against shear; NaN: not known */
        } struck;
    } * contact;
    unsigned traits; /* of further elements, which this input does not show */
    int modes;       /* number of lowest modes kept of each structure; 0: all */
    int nlinks;
    const struct thud_link_input {
        int left_structure, left_floor, right_structure, right_floor; /* floors from 1; 0: the ground */
        double stiffness_npm, damping_nspm;
        double slip_n;              /* friction: largest force of the stiffness; 0: no friction */
        const struct thud_law *law; /* one-sided: a contact with this law beyond the clearance; NULL: it always acts */
        bool tension;               /* one-sided: it acts when its ends move apart */
        struct thud_law_setup setup;
        double clearance_m;
    } * link;
};

/* Creates a model. Errors: THUD_INPUT (a law's parameters), THUD_MEMORY. */
enum thud_status thud_model_create(const struct thud_model_input *input, struct thud_model **out,
                                   struct thud_error *err);
void thud_model_free(struct thud_model *model);
/* Returns the mass, kg, of the system of a structure: of all linked structures, with their foundations. */
double thud_model_mass_of_system(const struct thud_model *model, int structure);

/* Returns the yielding storey of a row, NULL for a contact. Rows of yielding storeys follow those of the contacts. */
static inline const struct thud_model_storey *thud_model_row_storey(const struct thud_model *model, int row)
{
    return row < model->ncontacts ? NULL : &model->storey[row - model->ncontacts];
}

/* Finds the structures whose modes a Jacobian row moves, one of each system, from the left: one for a storey, beside a
 * wall or if both are linked, else two. Returns their number. */
static inline int thud_model_row_structures(const struct thud_model *model, int row, int structure[2])
{
    const int dof[] = {model->contact[row].left_dof, model->contact[row].right_dof};
    int n = 0;
    for (int i = 0; i < 2; i++)
        if (dof[i] >= 0 &&
            (n == 0 || model->structure[structure[0]].system != model->structure[model->dof_structure[dof[i]]].system))
            structure[n++] = model->dof_structure[dof[i]];
    return n;
}

/* Returns a bound of a structure's rates of free motion, rad/s: largest omega, or rate of coupled damping. */
double thud_model_fastest(const struct thud_model *model, int structure);

/* Returns the index, among the storeys that yield, of the storey below a floor; -1: elastic, or none. */
int thud_model_yielding(const struct thud_model *model, int dof);

/* Returns the drift of a storey in values by floor, `apart` doubles each from the structure's first dof: the value of
 * the floor above (index from 0) minus that below and, on soil, minus that of the foundation's rotation; 0 for the
 * foundation's dofs. */
static inline double thud_model_drift(const struct thud_model_structure *p, const double *value, int apart, int floor)
{
    const double *at = value + floor * apart, *base = value + p->n * apart;
    if (!p->rise)
        return floor > 0 ? at[0] - at[-apart] : at[0];
    return floor >= p->n ? 0 : at[0] - (floor > 0 ? at[-apart] : base[0]) - p->rise[floor] * base[apart];
}

/* Returns the drift on which the weight acts, including the rotation. */
static inline double thud_model_lean(const struct thud_model_structure *p, const double *value, int apart, int floor)
{
    const double *at = value + floor * apart;
    return at[0] - (floor > 0 ? at[-apart] : p->rise ? value[p->n * apart] : 0);
}

/* Returns a bound of that drift in a mode: the rotation adds less to a drift than to the displacement of the top. */
static inline double thud_model_most_lean(const struct thud_model *model, const struct thud_model_structure *p,
                                          int mode)
{
    return model->mode_max[model->nmodes + mode] + (p->rise ? model->mode_max[mode] : 0);
}

/* Returns a floor's value from modal values (nmodes). */
double thud_model_floor(const struct thud_model *model, int dof, const double *modal);
/* Return the values of row c's two sides from modal values; 0 for a wall and the ground. */
void thud_model_sides(const struct thud_model *model, int c, const double *modal, double *left, double *right);
/* Returns the left side's value minus the right side's, from modal values. */
double thud_model_gap_sum(const struct thud_model *model, int c, const double *modal);
/* The same of two rows of modal values that stand `apart`, out (2). */
void thud_model_gap_pair(const struct thud_model *model, int c, const double *modal, int apart, double *out);

/* Returns d of a link, or its rate, from modal values. */
double thud_model_link(const struct thud_model *model, int link, const double *modal);

/* Returns four times the duration from contact onset at 1 m/s to the largest indentation of a spring with the law's
 * elastic energy there, s: 2 pi sqrt(m/k) of a linear one. INFINITY for laws without a force. */
double thud_model_contact_period(const struct thud_model_contact *contact);
