/* A piece of motion as polynomials in s = (t - t0)/h, 0 <= s <= 1: what every method proposes, and what the run reads
 * events, peaks and energies from. */
#pragma once

#include <assert.h>

#include "core/contact/contact_state.h"
#include "core/numerics/quadrature.h"
#include "core/numerics/vec.h"

/* Coefficients of a polynomial; and of the first try in linear contact, which its tail shortens. */
enum { THUD_SEGMENT_TERMS = 40, THUD_SEGMENT_TERMS_LEAST = 10, THUD_SEGMENT_TERMS_TRIED = 24 };
/* Longest piece times the fastest rate: what the terms leave out of it is about half of epsilon, 6.3^40/40!. */
#define THUD_SEGMENT_ANGLE 6.3

/* Modal state and what follows from it. */
struct thud_motion {
    double *q, *qd, *qdd; /* (nmodes) */
    double *force;        /* (nrows) */
    bool apart;           /* no contact is indented here; false where that is not known */
};

/* What has been read of a segment, kept beside it. */
struct thud_segment_notes {
    double *indentation;     /* (nrows x THUD_SEGMENT_TERMS): where it has been read */
    int *cached;             /* (nrows) its lowest orders that are no motion; -1 where it has not been read */
    double *bound;           /* (nmodes) how far each mode strays in it from going on at its first rate */
    double *floors, *drifts; /* (nstructures) and so any floor, and any storey's drift */
    double *thirds;          /* (nstructures) largest third derivative by s of any floor, where the segment has nodes */
    double *end, end_s;      /* (2 x nmodes) modal state there, and where */
    thud_vec2_aligned *falling; /* (THUD_SEGMENT_TERMS) k (k - 1) (k - 2) */
    bool quiet;                 /* any of the following are there */
    double *released, *parted;  /* (nrows) s at which a contact does so and nothing else changes; INFINITY: none does */
    double *begun; /* (nrows) the same of one that begins, INFINITY: it may have done; -1: it has no force before */
};

/* Rows at the nodes of a collocated step: the first at its start, the last at its end. */
struct thud_segment_nodes {
    int count;
    const double *point, *weight; /* of their quadrature; weight NULL: it is not good enough for works */
    const double
        *lagrange; /* (apart apart) coefficients of the polynomials that are 1 at one of them, 0 at the others */
    int apart;
    double widest;           /* distance between two of them */
    const int *at;           /* (nrows) place of a row in what follows; -1: it has no force */
    const thud_vec2 *motion; /* (points apart) indentation and its rate */
    const double *force;     /* (count apart) */
    int points;
};

/* A value, of one time: who makes it, from thud_segment_begin on, changes it; once proposed it stays unchanged. */
struct thud_segment {
    double start_s, h_s;
    int terms;     /* coefficients in use */
    int loaded;    /* orders below this one may have contact forces */
    double a0, a1; /* ground acceleration a0 + a1 s */
    double *q;     /* (terms x nmodes): coefficients of the modal coordinates, by order */
    double *force; /* (terms x nrows): of the forces of contacts and yielding storeys; 0 where one does not act */
    const struct thud_motion *start,
        *end;  /* of a step whose events are not located: its two ends; else NULL, also where storeys yield */
    int steps; /* of such steps, how many it is: start, the ends of all but the last, and end follow each other */
    double end_energy; /* where the ends are known: sum of omega^2 q^2 + q'^2 at most at one of them but the start */
    bool interpolates; /* the states of a stepping method at its two ends; else a power series */
    const struct thud_segment_nodes *nodes; /* NULL: not a collocated step */

    int rows, *row; /* (rows) those that may have a force, but for a stepping method: set where it begins */
    struct thud_segment_notes *notes;
};

/* A segment of no length. Errors: THUD_MEMORY. */
enum thud_status thud_segment_init(struct thud_segment *seg, const struct thud_state *state, struct thud_error *err);

/* Bound of the fastest rate of the run's motion with the linear contacts that are closed, 1/s. */
double thud_segment_rate(const struct thud_state *state);
/* Terms after which angle^k/k! is below `least`, but no fewer than `fewest`: angle = rate times h. */
int thud_segment_terms(double angle, double least, int fewest);
/* Sets h, the number of terms and the ground acceleration over the next h seconds of the run, and clears the forces. */
void thud_segment_begin(const struct thud_state *state, struct thud_segment *seg, double h_s, int terms);
/* Terms of a series over h seconds of the run's motion, to rounding. */
int thud_segment_all_terms(const struct thud_state *state, double h_s);
/* Only the place, an offset after the start of an interval of the ground motion, and the ground acceleration: for a
 * segment whose forces and terms stand already. */
void thud_segment_ground(const struct thud_state *state, struct thud_segment *seg, long grid, double offset_s,
                         double h_s);

/* Taylor coefficients of the motion from (q, qd) under seg->a0, a1 and the forces in seg->force. Exact to rounding
 * where omega h is about 1.5 or less. */
void thud_taylor_given(const struct thud_model *model, struct thud_segment *seg, const double *q, const double *qd);
/* The same of the modes of one structure, and of what it is tied to, alone; q and qd are of all. yields: all rows that act
 * are storeys there, whose forces are found along with it. */
void thud_taylor_structure(const struct thud_state *state, struct thud_segment *seg, int structure, bool yields,
                           const double *q, const double *qd);
/* Motion from rest over h seconds under the constant modal load alone. */
void thud_taylor_load(const struct thud_model *model, struct thud_segment *seg, double h_s, int terms,
                      const double *load);
/* The same from the run's state with the linear branches of its closed contacts and the constraint forces of its sticking
 * ones, which are found along with it. */
double thud_taylor_linear(const struct thud_state *state, struct thud_segment *seg);
/* Size of the last terms over the largest, of the structure where it is worst: one may move by a micrometre beside another that
 * moves by metres. */
double thud_segment_tail(const struct thud_segment *seg, const struct thud_model *model);
/* Leaves out the last orders whose accelerations are below `least` of those that each system starts with: the fastest
 * rate may be that of a dashpot that hardly moves. */
void thud_segment_trim(struct thud_segment *seg, const struct thud_model *model, double least);
/* Shortens the segment to factor * h by scaling its coefficients. */
void thud_segment_shorten(struct thud_segment *seg, int nmodes, int nrows, double factor);

/* Reads the indentation of contact c, once, into its notes; returns how many of its lowest orders are no motion (see
 * thud_segment_indentation). */
int thud_segment_contact(const struct thud_state *state, const struct thud_segment *seg, int c);
/* That indentation's coefficients. */
static inline const double *thud_segment_read(const struct thud_state *state, const struct thud_segment *seg, int c)
{
    thud_segment_contact(state, seg, c);
    return seg->notes->indentation + c * THUD_SEGMENT_TERMS;
}
/* Coefficients of the force of a row, out (terms). */
static inline void thud_segment_force(const struct thud_segment *seg, int nrows, int row, int terms, double *out)
{
    for (int k = 0; k < terms; k++)
        out[k] = seg->force[k * nrows + row];
}
/* Fills the bounds of the notes, and the state at s. */
void thud_segment_bounds(const struct thud_segment *seg, const struct thud_model *model, double s);
/* Whether the segment holds a force of contact c: where nothing is located, of one that does not act any more, too. */
bool thud_segment_has_any(const struct thud_state *state, const struct thud_segment *seg, int c);
static inline bool thud_segment_has_force(const struct thud_state *state, const struct thud_segment *seg, int c)
{
    const bool acts = thud_row_acts(state, c);
    return acts || (!state->locates && thud_segment_has_any(state, seg, c));
}

/* From which s on contact c has no force: it has been released or has parted there. */
static inline double thud_segment_ended(const struct thud_segment *seg, int c)
{
    return thud_smaller(seg->notes->released[c], seg->notes->parted[c]);
}

/* Values of all modal coordinates and their rates at s. */
void thud_segment_state(const struct thud_segment *seg, int nmodes, double s, double *q, double *qd);
/* Coefficients of the indentation of contact c, out (THUD_SEGMENT_TERMS, those in use). Where it is known to start at 0 (an event has just been
 * there), returns how many of the lowest ones are 0 but for rounding: neighbours that start together move together to
 * high orders, and what rounding leaves of their difference is no motion. Elsewhere 0. */
int thud_segment_indentation(const struct thud_state *state, const struct thud_segment *seg, int c, double *out);
