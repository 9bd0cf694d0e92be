/* Peaks of the continuous history, read from the polynomials of a segment. */
#include <math.h>

#include "core/poly.h"
#include "core/run_private.h"

static void raise_peak(struct thud_run *run, struct thud_peak *peak, const double *p, int n, double s_end)
{
    double where;
    double value = thud_poly_peak(p, n, s_end, peak->value, &where);
    if (value > peak->value) {
        peak->value = value;
        peak->time_s = thud_run_now(run) + where * run->seg.h_s;
    }
}

/* Coefficients of a floor's value from those of the modes, out (terms). */
static void floor_polynomial(const struct thud_model_structure *p, int floor, const double *modal, int nmodes,
                             int terms, double *out)
{
    const double *row = p->phi + floor * p->n;
    for (int k = 0; k < terms; k++) {
        const double *x = modal + k * nmodes + p->first;
        double sum = 0;
        for (int j = 0; j < p->n; j++)
            sum += row[j] * x[j];
        out[k] = sum;
    }
}

/* Modal total acceleration q'' + gamma a_g, (terms - 2 x nmodes). */
static void modal_acceleration(const struct thud_run *run, double *out)
{
    const struct thud_model *m = run->model;
    const struct thud_segment *seg = &run->seg;
    double inverse = 1 / (seg->h_s * seg->h_s);
    for (int k = 0; k + 2 < seg->terms; k++) {
        double scale = (k + 1) * (k + 2) * inverse, ground = k == 0 ? seg->a0 : k == 1 ? seg->a1 : 0;
        for (int j = 0; j < m->ndof; j++)
            out[k * m->ndof + j] = scale * seg->q[(k + 2) * m->ndof + j] + m->gamma[j] * ground;
    }
}

static void structure_peaks(struct thud_run *run, int index, double s_end)
{
    const struct thud_model_structure *p = &run->model->structure[index];
    const struct thud_segment *seg = &run->seg;
    struct thud_structure_result *result = &run->result.structure[index];
    double u[THUD_SEGMENT_TERMS], below[THUD_SEGMENT_TERMS] = {0}, x[THUD_SEGMENT_TERMS];
    int n = seg->terms, nmodes = run->model->ndof;
    for (int i = 0; i < p->n; i++) {
        floor_polynomial(p, i, seg->q, nmodes, n, u);
        raise_peak(run, &result->floor[i].displacement, u, n, s_end);
        for (int k = 0; k + 1 < n; k++)
            x[k] = (k + 1) / seg->h_s * u[k + 1];
        raise_peak(run, &result->floor[i].velocity, x, n - 1, s_end);
        floor_polynomial(p, i, run->scratch, nmodes, n - 2, x);
        raise_peak(run, &result->floor[i].acceleration, x, n - 2, s_end);
        if (!p->stiffness_npm)
            continue;
        for (int k = 0; k < n; k++) {
            x[k] = u[k] - below[k];
            below[k] = u[k];
        }
        raise_peak(run, &result->floor[i].drift, x, n, s_end);
    }
}

static void contact_peaks(struct thud_run *run, int c, double s_end)
{
    const struct thud_segment *seg = &run->seg;
    struct thud_contact_state *s = &run->contact[c];
    struct thud_contact_result *result = &run->result.contact[c];
    double p[THUD_SEGMENT_TERMS], where = 0;
    if (s->mode == THUD_OPEN)
        return;
    const double *d = run->indentation + c * THUD_SEGMENT_TERMS;
    raise_peak(run, &result->indentation, d, seg->terms, s_end);
    s->impact.indentation_m = thud_poly_peak(d, seg->terms, s_end, s->impact.indentation_m, &where);
    if (!thud_contact_acts(s))
        return;
    for (int k = 0; k < seg->terms; k++)
        p[k] = seg->force[k * run->model->ncontacts + c];
    raise_peak(run, &result->force, p, seg->terms, s_end);
    s->impact.force_n = thud_poly_peak(p, seg->terms, s_end, s->impact.force_n, &where);
}

void thud_peaks_motion(struct thud_run *run, double s)
{
    modal_acceleration(run, run->scratch);
    for (int i = 0; i < run->model->nstructures; i++)
        structure_peaks(run, i, s);
}

void thud_peaks_segment(struct thud_run *run, double s)
{
    thud_peaks_motion(run, s);
    for (int c = 0; c < run->model->ncontacts; c++)
        contact_peaks(run, c, s);
}
