/* Observer of a run: damped oscillators on floors, at rest on them at the start.
 *
 *     y'' + 2 zeta omega y' + omega^2 y = -a(t),   z = y' - conj(lambda) y,   z' = lambda z - a(t)
 *
 * y relative to the floor, a the floor's total acceleration, lambda = omega (-zeta + i sqrt(1 - zeta^2)). In a segment a is
 * a polynomial, b_0 + b_1 s + ..., and over a piece of length h (mu = lambda h)
 *
 *     z(h) = e^mu z(0) - h sum of b_k M_k,   M_k = integral of e^(mu (1 - s)) s^k ds,   M_(k-1) = (1 + mu M_k)/k
 *
 * is exact. Only the polynomial is shortened (Chebyshev's economization), by at most a part of the floor's largest
 * acceleration so far that changes no pseudo-acceleration by more than 1e-6 of that: an error of e in a leaves at most
 * e coth(pi zeta/(2 sqrt(1 - zeta^2))) in omega^2 y. An impulse changes the floor's velocity by dv, and z by -dv. */
#pragma once

#include "core/model/floor_spectra.h"
#include "core/observe/observer.h"

enum {
    THUD_FLOOR_LANES = 8, /* oscillators that go on together */
    THUD_FLOOR_TERMS = THUD_SEGMENT_TERMS - 2
};

/* Eight oscillators, the same for every floor, and what they need for one piece. */
struct thud_floor_block {
    double omega[THUD_FLOOR_LANES];
    double piece_s; /* what follows is of a piece this long, for polynomials of so many terms */
    int terms;
    double turn[2][THUD_FLOOR_LANES];                   /* e^mu: real and imaginary part, and so below */
    double bend[THUD_FLOOR_LANES];                      /* Im z lies above its ends by at most bend |z| */
    double push[THUD_FLOOR_LANES];                      /* + push max |a| */
    double load[THUD_FLOOR_TERMS][2][THUD_FLOOR_LANES]; /* -h M_k */
};

/* They on one floor. */
struct thud_floor_batch {
    double z[2][THUD_FLOOR_LANES];
    double peak[THUD_FLOOR_LANES]; /* largest |Im z| = omega_d |y| so far */
};

/* The acceleration of a floor over a piece. */
struct thud_floor_load {
    double b[THUD_FLOOR_TERMS];
    int terms;
    double most, slope; /* bounds of |a| and of |da/ds| */
};

struct thud_floor_oscillators {
    int nfloors, nperiods, nblocks, nmodes;
    double damping, root;                             /* sqrt(1 - damping^2) */
    double left_out;                                  /* of a floor's largest acceleration that may be left out */
    int *dof;                                         /* (nfloors) */
    double *influence;                                /* (nfloors) part of the ground's acceleration in the floor's */
    double *largest;                                  /* (nfloors) its acceleration so far */
    double *rates;                                    /* (nmodes) modal velocities at the end of the last segment */
    double monic[THUD_FLOOR_TERMS][THUD_FLOOR_TERMS]; /* Chebyshev polynomials on [0, 1] with the highest factor 1 */
    double size[THUD_FLOOR_TERMS];                    /* and their largest value there */
    struct thud_floor_load *load, *part;              /* (nfloors) in the segment, and in a part of it */
    struct thud_floor_block *table;                   /* (nblocks) */
    struct thud_floor_batch *batch;                   /* (nblocks x nfloors) */
    void *memory;
};

extern const struct thud_observer thud_observe_floors;

/* Errors: THUD_MEMORY; nothing stays allocated then. */
enum thud_status thud_floor_oscillators_init(struct thud_floor_oscillators *oscillators, const struct thud_model *model,
                                             const struct thud_floor_spectra_choice *choice, struct thud_error *err);
void thud_floor_oscillators_clear(struct thud_floor_oscillators *oscillators);
/* omega^2 |y| at most, so far. */
double thud_floor_oscillators_peak(const struct thud_floor_oscillators *oscillators, int floor, int period);
