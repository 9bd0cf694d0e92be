/* Peaks of a floor's quantities from the power series of a segment, s = (t - t0)/h:
 *
 *     u_i(s) = sum_j phi_ij q_j(s),   v = u'/h,   a = u''/h^2 + iota_i a_g(s),   drift = u_i - u_(i-1)
 *
 * The largest size of each polynomial up to s_end is bracketed by thud_poly_peak. A stepping method's total acceleration
 * is read from the forces instead (peaks->acceleration): its polynomial of the displacement has no right second rate. */
#include <string.h>

#include "core/numerics/poly.h"
#include "core/numerics/vec.h"
#include "core/observe/observe_peaks_parts.h"

/* Coefficients of a floor's value from those of the modes, out (terms). */
static void floor_polynomial(const struct thud_model_structure *p, int floor, const double *modal, int nmodes,
                             int terms, double *out)
{
    thud_dots(p->modes, p->phi + floor * p->modes, modal + p->first_mode, nmodes, terms, out);
}

/* Of a floor's displacement: made once for all that is read from it in a segment. */
static const double *floor_series(struct thud_peaks *peaks, const struct thud_model *m, const struct thud_segment *seg,
                                  const struct thud_model_structure *p, int floor)
{
    double *u = peaks->series + floor * THUD_SEGMENT_TERMS;
    if (!peaks->made[floor])
        floor_polynomial(p, floor, seg->q, m->nmodes, seg->terms, u);
    peaks->made[floor] = true;
    return u;
}

/* Coefficients of a floor's value, and how many. */
static int value_series(struct thud_peaks *peaks, const struct thud_model *m, const struct thud_segment *seg,
                        const struct thud_model_structure *p, int floor, int quantity, double *out)
{
    const int n = seg->terms;
    if (quantity == THUD_FLOOR_ACCELERATION && seg->interpolates) {
        floor_polynomial(p, floor, peaks->acceleration, m->nmodes, n - 2, out);
        return n - 2;
    }
    const double *u = floor_series(peaks, m, seg, p, floor);
    const double rate = 1 / seg->h_s;
    if (quantity == THUD_FLOOR_VELOCITY) {
        for (int k = 0; k + 1 < n; k++)
            out[k] = (k + 1) * rate * u[k + 1];
        return n - 1;
    }
    if (quantity == THUD_FLOOR_ACCELERATION) {
        for (int k = 0; k + 2 < n; k++)
            out[k] = (k + 1) * (k + 2) * (rate * rate) * u[k + 2];
        out[0] += m->ground_influence[p->first + floor] * seg->a0;
        out[1] += m->ground_influence[p->first + floor] * seg->a1;
        return n - 2;
    }
    if (quantity == THUD_FLOOR_DRIFT && p->rise && floor < p->n) { /* all floors' series stand one after the other */
        floor_series(peaks, m, seg, p, p->n);
        floor_series(peaks, m, seg, p, p->n + 1);
    }
    if (quantity == THUD_FLOOR_DRIFT && floor > 0)
        floor_series(peaks, m, seg, p, floor - 1);
    for (int k = 0; k < n; k++)
        out[k] =
            quantity == THUD_FLOOR_DRIFT ? thud_model_drift(p, peaks->series + k, THUD_SEGMENT_TERMS, floor) : u[k];
    return n;
}

void thud_peaks_read_floor(struct thud_peaks *peaks, const struct thud_model *m, const struct thud_segment *seg,
                           int structure, int floor, int quantity, double s_end)
{
    double x[THUD_SEGMENT_TERMS];
    int n = value_series(peaks, m, seg, &m->structure[structure], floor, quantity, x);
    thud_peak_raise(thud_floor_peak(peaks->result, structure, floor, quantity), seg, x, n, s_end);
}

/* No floor's series has been made of this segment yet. */
void thud_peaks_forget_series(struct thud_peaks *peaks, const struct thud_model_structure *p)
{
    memset(peaks->made, 0, (size_t)p->dofs * sizeof *peaks->made);
}
