/* Observer of a run: damped oscillators on floors, at rest on them at the start.
 *
 *     y'' + 2 zeta omega y' + omega^2 y = -a(t),   z = y' - conj(lambda) y,   z' = lambda z - a(t)
 *
 * y relative to the floor, a the floor's total acceleration, lambda = omega (-zeta + i sqrt(1 - zeta^2)). In a segment a is
 * a polynomial, and over a piece of length h, with Legendre's polynomials, c_0 P_0(2 s - 1) + c_1 P_1(2 s - 1) + ...,
 *
 *     z(h) = e^mu z(0) - h sum of c_k L_k,   L_k = integral of e^(mu (1 - s)) P_k(2 s - 1) ds,   mu = lambda h
 *
 * is exact. Only small terms of a are left out, which together change no pseudo-acceleration by more than 2e-7 of the
 * floor's largest acceleration so far: |L_k| <= (|mu|/2)^k/(1 3 5 ... (2 k + 1)). An impulse changes the floor's velocity
 * by dv, and z by -dv. */
#pragma once

#include "core/model/floor_spectra.h"
#include "core/numerics/vec.h"
#include "core/observe/observer.h"

enum {
    THUD_FLOOR_PAIRS = 4, /* of oscillators that go on together */
    THUD_FLOOR_TERMS = THUD_SEGMENT_TERMS - 2
};

/* Two complex numbers. */
struct thud_complex2 {
    thud_vec2_aligned re, im;
};

/* Eight oscillators, the same for every floor, and what they need for one piece. */
struct thud_floor_block {
    thud_vec2_aligned omega[THUD_FLOOR_PAIRS];
    double piece_s; /* what follows is of a piece this long, for polynomials of so many terms */
    int terms;
    struct thud_complex2 mu[THUD_FLOOR_PAIRS], turn[THUD_FLOOR_PAIRS]; /* turn: e^mu */
    struct thud_complex2 load[THUD_FLOOR_TERMS][THUD_FLOOR_PAIRS];     /* -h L_k */
    double size[THUD_FLOOR_TERMS];                                     /* bound of every |L_k| */
};

/* They on one floor. */
struct thud_floor_batch {
    struct thud_complex2 z[THUD_FLOOR_PAIRS];
    thud_vec2_aligned peak[THUD_FLOOR_PAIRS]; /* largest |Im z| = omega_d |y| so far */
    double margin;                            /* by which every |z| is below its peak */
};

/* The acceleration of a floor over a piece. */
struct thud_floor_load {
    double c[THUD_FLOOR_TERMS];
    int terms, used;     /* used: those that the next block needs at the end of the piece */
    double left_out;     /* what it may leave out */
    double start, slope; /* a and its slope by s at the start */
    double most, curve;  /* bounds of |a| and of |a''| */
};

struct thud_floor_oscillators {
    int nfloors, nperiods, nblocks;
    double damping, root;                             /* sqrt(1 - damping^2) */
    double left_out;                                  /* of a floor's largest acceleration that may be left out */
    double ones[THUD_FLOOR_TERMS];                    /* 1: bounds of Legendre's polynomials */
    int *dof;                                         /* (nfloors) */
    double *largest;                                  /* (nfloors) its acceleration so far */
    double *rates;                                    /* (nmodes) modal velocities at the end of the last segment */
    double *modal;                                    /* (THUD_FLOOR_TERMS x nmodes) c_k of the modes' accelerations */
    double part[3];                                   /* h and ends of the part of a segment that the basis is for */
    double basis[THUD_FLOOR_TERMS][THUD_FLOOR_TERMS]; /* [j][k]: part of q_(j+k+2) in c_j */
    struct thud_floor_load *load;                     /* (nfloors) in the piece */
    struct thud_floor_block *table;                   /* (nblocks) */
    struct thud_floor_batch *batch;                   /* (nblocks x nfloors) */
};

extern const struct thud_observer thud_observe_floors;

/* Errors: THUD_MEMORY. */
enum thud_status thud_floor_oscillators_init(struct thud_floor_oscillators *oscillators, const struct thud_state *state,
                                             const struct thud_floor_spectra_choice *choice, struct thud_error *err);
/* omega^2 |y| at most, so far. */
double thud_floor_oscillators_peak(const struct thud_floor_oscillators *oscillators, int floor, int period);
