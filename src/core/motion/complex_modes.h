/* Complex modes of a system whose damping couples its real ones, for bounds of its free vibration. With x = (q, q') and
 * the ground acceleration a + s t in an interval,
 *
 *     x' = A x + B a_g,   A V = V Lambda,   w = V^-1 (x - x_p),   x_p = -A^-1 B a_g - A^-2 B s
 *
 * each w_k turns and decays by itself, w_k(t) = exp(lambda_k t) w_k(0), and x_p is linear in time, so that inside the
 * interval
 *
 *     |d^m q_j/dt^m| <= sum_k |v_jk| |lambda_k|^m |w_k(0)|,   m >= 2
 *
 * Dashpots whose rates are far above one in an interval only make |w_k| small (Foss 1958, J. Appl. Mech. 25:361). Not
 * for systems with a root at 0 (free bodies) or a double one. */
#pragma once

#include "core/model/model.h"

enum { THUD_COMPLEX_LEAST = 2, THUD_COMPLEX_ORDERS = 7 }; /* orders of derivatives, from ... on and below ... */

struct thud_complex_modes {
    int n, size, roots; /* modes; 2 n + 2; roots, one of each conjugate pair */
    double *part;       /* (2 roots x size) real and imaginary part of w by (q, q', a, s dt) */
    double *share;      /* (ORDERS x n x roots) |v_jk| |lambda_k|^m, twice where k stands for a pair */
    double *most;       /* (roots) largest |w_k| in a block */
    double *now;        /* (size) */
    double *block;      /* NULL: the system has none that are of use */
};

/* Of the structures of one system. Errors: THUD_MEMORY; nothing stays allocated then. */
enum thud_status thud_complex_modes_init(struct thud_complex_modes *modes, const struct thud_model *model, int system,
                                         double dt_s, struct thud_error *err);
void thud_complex_modes_clear(struct thud_complex_modes *modes);
/* Bounds of the derivatives of the system's modes over intervals that start at rows of q and qd (n), `apart` doubles
 * each, less the place s (n) they swing about: out[m * stride + j] for m from LEAST on and below ORDERS. */
void thud_complex_modes_bounds(struct thud_complex_modes *modes, const double *q, const double *qd, int apart,
                               const double *s, const double *ground, const double *after, int intervals, double *out,
                               int stride);
