/* What a run may ask for, the step it gets when it asks for none, and what its response may not pass. */
#include <math.h>

#include "core/run_private.h"

enum thud_status thud_run_check_options(const struct thud_run_options *o, const struct thud_record *record,
                                        struct thud_error *err)
{
    if (!(o->tolerance >= 1e-13 && o->tolerance <= 0.1)) {
        thud_error_set(err, THUD_INPUT, "%g is out of bounds", o->tolerance);
        thud_error_key(err, "tolerance");
        thud_error_allow(err, "1e-13 to 0.1");
        return THUD_INPUT;
    }
    if (!(o->tail_s >= 0) || (!record && !(o->tail_s > 0))) {
        thud_error_set(err, THUD_INPUT, "%g s is too short", o->tail_s);
        thud_error_key(err, "tail");
        thud_error_allow(err,
                         record ? "0 s or more" : "without a ground motion it is the duration and must be above 0");
        return THUD_INPUT;
    }
    if (!isnan(o->step_s) && !(o->step_s >= 1e-9 && isfinite(o->step_s))) {
        thud_error_set(err, THUD_INPUT, "%g s is out of bounds", o->step_s);
        thud_error_key(err, "step");
        thud_error_allow(err, "1e-9 s or more");
        return THUD_INPUT;
    }
    return THUD_OK;
}

double thud_model_contact_period(const struct thud_model_contact *p)
{
    double v = 1, energy = 0.5 * p->setup.mass_kg * v * v, low = 0, high = 1e-9;
    if (!p->law->elastic_energy || p->law->flags & (THUD_LAW_SILENT | THUD_LAW_IMPULSIVE))
        return INFINITY;
    while (high < 1e3 && p->law->elastic_energy(&p->setup, high) < energy)
        high *= 2;
    for (int i = 0; i < 60; i++) {
        double d = 0.5 * (low + high);
        if (p->law->elastic_energy(&p->setup, d) < energy)
            low = d;
        else
            high = d;
    }
    return 2 * acos(-1) * high / v;
}

/* Shortest period, of a mode or of a contact at a closing of 1 m/s, s. */
static double shortest_period(const struct thud_run *run)
{
    double shortest = run->fastest_radps > 0 ? 2 * acos(-1) / run->fastest_radps : INFINITY;
    for (int c = 0; c < run->model->ncontacts; c++)
        shortest = fmin(shortest, thud_model_contact_period(&run->model->contact[c]));
    return shortest;
}

double thud_run_default_step(const struct thud_run *run)
{
    double step = shortest_period(run) / 20;
    return fmin(step, run->record ? run->record->dt_s : run->end_s / 20);
}

/* Largest speed of the ground, that of a body it does not take along: of the trapezoids under its acceleration, also
 * where that changes sign between two samples. */
static double ground_speed(const struct thud_record *r)
{
    double v = 0, most = 0;
    for (size_t i = 0; r && i + 1 < r->samples; i++) {
        double a = r->a_mps2[i], b = r->a_mps2[i + 1];
        if (a * b < 0)
            most = fmax(most, fabs(v + 0.5 * r->dt_s * a * (a / (a - b))));
        v += 0.5 * r->dt_s * (a + b);
        most = fmax(most, fabs(v));
    }
    return most;
}

void thud_run_set_scales(struct thud_run *run)
{
    double first = 0;
    for (int i = 0; i < run->model->ndof; i++)
        first = fmax(first, fabs(thud_model_floor(run->model, i, run->qd)));
    run->ground_mps2 = run->record ? thud_record_peak(run->record) : 0;
    run->speed_mps = first + ground_speed(run->record);
}

/* d sqrt(2 E)/dt <= |gamma| |a_g|, whatever the contacts do that give no energy: so sqrt(2 E) never passes its first
 * value plus |gamma| times the integral of |a_g|. */
void thud_run_set_bound(struct thud_run *run)
{
    const struct thud_model *m = run->model;
    double mass = 0, ground = 0, energy = thud_run_kinetic(run) + thud_run_strain(run);
    for (int j = 0; j < m->nmodes; j++)
        mass += m->gamma[j] * m->gamma[j];
    for (int c = 0; c < m->ncontacts; c++) {
        const struct thud_model_contact *p = &m->contact[c];
        double d = thud_contact_indentation(run, c);
        if (d > 0 && p->law->elastic_energy)
            energy += p->law->elastic_energy(&p->setup, d);
    }
    for (size_t i = 0; run->record && i < run->record->samples; i++)
        ground += fabs(run->record->a_mps2[i]) * run->record->dt_s;
    run->speed_bound = sqrt(2 * energy) + sqrt(mass) * fmax(ground, 1e-3);
}

/* The floor that moves most, for the message; one that does not move by a number comes first. */
static int worst_floor(const struct thud_model *m, const double *qd)
{
    int worst = 0;
    double most = -1;
    for (int i = 0; i < m->ndof; i++) {
        double v = fabs(thud_model_floor(m, i, qd));
        if (!isfinite(v))
            return i;
        if (v > most) {
            most = v;
            worst = i;
        }
    }
    return worst;
}

enum thud_status thud_run_check_state(struct thud_run *run, const double *q, const double *qd, struct thud_error *err)
{
    static const double times = 100; /* a coarse but stable step may overshoot; more is a run that has blown up */
    const struct thud_model *m = run->model;
    double limit = times * run->speed_bound, sum = 0;
    for (int j = 0; j < m->nmodes; j++)
        sum += qd[j] * qd[j] + m->omega[j] * m->omega[j] * q[j] * q[j];
    if (sum <= limit * limit) /* false for NaN */
        return THUD_OK;
    run->failed = true;
    int i = worst_floor(m, qd), s = m->dof_structure[i];
    thud_error_set(err, THUD_DIVERGED, "the response blew up at t = %.6g s, structure %d, floor %d", thud_run_now(run),
                   s + 1, i - m->structure[s].first + 1);
    thud_error_key(err, run->method->name);
    if (run->method->flags & THUD_METHOD_FIXED_STEP)
        thud_error_allow(err, "%s; step used %.6g s, fastest mode %.6g rad/s", run->method->limits, run->options.step_s,
                         run->fastest_radps);
    return THUD_DIVERGED;
}

enum thud_status thud_run_too_few_modes(const struct thud_run *run, struct thud_error *err)
{
    thud_error_set(err, THUD_DIVERGED, "more contacts touch at once than the modes tell apart, at t = %.6g s",
                   thud_run_now(run));
    thud_error_key(err, "modes");
    thud_error_allow(err, "more of them, or all");
    return THUD_DIVERGED;
}
