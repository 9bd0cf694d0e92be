/* The energy ledger: work done by the ground, lost in the structures' damping and in the contacts, each by quadrature
 * of its own power, against the energy that the state holds. What is left over is the error. */
#include <math.h>
#include <string.h>

#include "core/poly.h"
#include "core/quadrature.h"
#include "core/run_private.h"

double thud_run_kinetic(const struct thud_run *run)
{
    double sum = 0;
    for (int j = 0; j < run->model->ndof; j++)
        sum += run->qd[j] * run->qd[j];
    return 0.5 * sum;
}

double thud_run_strain(const struct thud_run *run)
{
    double sum = 0;
    for (int j = 0; j < run->model->ndof; j++)
        sum += run->model->omega[j] * run->model->omega[j] * run->q[j] * run->q[j];
    return 0.5 * sum;
}

/* Power of the structures' damping at modal rates qd. */
static double viscous_power(const struct thud_model *m, const double *qd)
{
    double sum = 0;
    for (int j = 0; j < m->ndof; j++)
        sum += 2 * m->zeta[j] * m->omega[j] * qd[j] * qd[j];
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        for (int i = 0; p->damping && i < p->n; i++)
            for (int j = 0; j < p->n; j++)
                sum += qd[p->first + i] * p->damping[i * p->n + j] * qd[p->first + j];
    }
    return sum;
}

static void contact_work(struct thud_run *run, int c, double s_end)
{
    struct thud_contact_state *s = &run->contact[c];
    const double *d = run->indentation + c * THUD_SEGMENT_TERMS;
    double work = 0, impulse = 0, dt = s_end * run->seg.h_s, v[3];
    for (int i = 0; i < THUD_QUADRATURE_POINTS; i++) {
        thud_poly_value3(d, run->seg.terms, s_end * thud_quadrature_node[i], v);
        double rate = v[1] / run->seg.h_s, force = 0;
        if (s->mode == THUD_STUCK || !run->locates) /* what the step really applied */
            for (int k = run->seg.terms - 1; k >= 0; k--)
                force = force * s_end * thud_quadrature_node[i] + run->seg.force[k * run->model->ncontacts + c];
        else
            force = thud_contact_force(run, c, v[0], rate);
        work += thud_quadrature_weight[i] * force * rate;
        impulse += thud_quadrature_weight[i] * force;
    }
    s->impact.impulse_ns += impulse * dt;
    s->impact.dissipated_j += work * dt;
    run->result.contact[c].impulse_ns += impulse * dt;
    if (thud_contact_acts(s))
        run->result.contact[c].contact_time_s += dt;
    run->result.contact[c].dissipated_j += work * dt;
    run->ledger.contact_work_j += work * dt;
}

void thud_ledger_start(struct thud_run *run)
{
    run->ledger.initial_j = thud_run_kinetic(run) + thud_run_strain(run);
    run->ledger.largest_j = run->ledger.initial_j;
}

/* Modal rates at s, out (nmodes). */
static void modal_rates(const struct thud_segment *seg, int n, double s, double *out)
{
    memset(out, 0, (size_t)n * sizeof *out);
    for (int k = seg->terms - 1; k >= 1; k--) {
        double factor = k / seg->h_s;
        const double *q = seg->q + k * n;
        for (int j = 0; j < n; j++)
            out[j] = out[j] * s + factor * q[j];
    }
}

void thud_ledger_segment(struct thud_run *run, double s)
{
    const struct thud_model *m = run->model;
    double *qd = run->scratch;
    for (int c = 0; c < m->ncontacts; c++)
        if (thud_contact_felt(run, c))
            contact_work(run, c, s);
    if (run->options.no_ledger)
        return;
    double dt = s * run->seg.h_s;
    for (int i = 0; i < THUD_QUADRATURE_POINTS; i++) {
        double at = s * thud_quadrature_node[i], ground = run->seg.a0 + run->seg.a1 * at, input = 0;
        modal_rates(&run->seg, m->ndof, at, qd);
        for (int j = 0; j < m->ndof; j++)
            input -= m->gamma[j] * qd[j];
        run->ledger.input_j += thud_quadrature_weight[i] * dt * ground * input;
        run->ledger.viscous_j += thud_quadrature_weight[i] * dt * viscous_power(m, qd);
    }
}

void thud_ledger_finish(struct thud_run *run)
{
    struct thud_energy *e = &run->result.energy;
    const struct thud_ledger *l = &run->ledger;
    double stored = 0;
    for (int c = 0; c < run->model->ncontacts; c++) {
        const struct thud_contact_state *s = &run->contact[c];
        const struct thud_model_contact *p = &run->model->contact[c];
        if (thud_contact_acts(s) && p->law->elastic_energy)
            stored += p->law->elastic_energy(&p->setup, fmax(thud_contact_indentation(run, c), 0));
    }
    *e = (struct thud_energy){.input_j = l->input_j,
                              .kinetic_j = thud_run_kinetic(run),
                              .strain_j = thud_run_strain(run),
                              .viscous_j = l->viscous_j,
                              .contact_j = l->contact_work_j - stored,
                              .initial_j = l->initial_j,
                              .stored_j = stored};
    double left = e->initial_j + e->input_j - e->kinetic_j - e->strain_j - e->viscous_j - l->contact_work_j;
    double largest = fmax(l->largest_j, fmax(e->kinetic_j + e->strain_j, fabs(e->input_j)));
    e->error_ratio = largest > 0 ? fabs(left) / largest : 0;
}
