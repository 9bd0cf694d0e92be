/* What a run may ask for, the step it gets when it asks for none, and what its response may not pass. */
#include <float.h>
#include <math.h>
#include <stdio.h>

#include "core/model/element.h"
#include "core/numerics/vec.h"
#include "core/run/run_private.h"

enum thud_status thud_run_check_options(const struct thud_run_options *o, const struct thud_record *record,
                                        struct thud_error *err)
{
    if (!(o->tolerance >= 1e-13 && o->tolerance <= 0.1))
        return thud_error_refuse(err, THUD_INPUT, "tolerance", "1e-13 to 0.1", "%g is out of bounds", o->tolerance);
    if (!(o->tail_s >= 0) || (!record && !(o->tail_s > 0)))
        return thud_error_refuse(err, THUD_INPUT, "tail",
                                 record ? "0 s or more"
                                        : "without a ground motion it is the duration and must be above 0",
                                 "%g s is too short", o->tail_s);
    if (!isnan(o->step_s) && !(o->step_s >= 1e-9 && isfinite(o->step_s)))
        return thud_error_refuse(err, THUD_INPUT, "step", "1e-9 s or more", "%g s is out of bounds", o->step_s);
    return THUD_OK;
}

/* Also for methods that choose their steps. A series holds for 6.3 rad of the fastest motion. Buildings turn by up to 100 rad/s x 0.02 s in an interval of
 * the ground motion, and by 1e5 rad in a run. */
static const double interval_most_rad = 1e4, run_most_rad = 3e7;
/* Of a ground motion and the time after it: at 5 ns for each floor and mode of a building, a minute of one of 10 floors. */
static const double intervals_most = 1e8;

/* The rate at which a link that always acts moves its two ends alone, 1/s, and which of its values does. */
static double link_rate(const struct thud_model *m, const struct thud_model_link *p, const char **key)
{
    const double inverse = (p->left_dof < 0 ? 0 : 1 / m->mass_kg[p->left_dof]) +
                           (p->right_dof < 0 ? 0 : 1 / m->mass_kg[p->right_dof]),
                 by_spring = sqrt(p->stiffness_npm * inverse), by_dashpot = p->damping_nspm * inverse;
    *key = by_dashpot > by_spring ? "damping" : "stiffness";
    return fmax(by_spring, by_dashpot);
}

/* What makes the fastest motion: a link that alone moves as fast, or a structure. */
static void name_fastest(const struct thud_model *m, struct thud_error *err)
{
    const double near = 0.3 * m->fastest_radps;
    int worst = 0;
    for (int i = 0; i < m->nlinks; i++) {
        const char *key;
        if (m->link[i].contact < 0 && link_rate(m, &m->link[i], &key) > near) {
            thud_error_key(err, "links.%d.%s", i + 1, key);
            return;
        }
    }
    for (int s = 1; s < m->nstructures; s++)
        if (thud_model_fastest(m, s) > thud_model_fastest(m, worst))
            worst = s;
    const struct thud_model_structure *p = &m->structure[worst];
    const bool storeys = p->stiffness_npm && !p->rise && p->omega[p->dofs - 1] > near;
    thud_error_key(err, "structures.%d%s", worst + 1, p->rise ? ".foundation" : storeys ? ".stiffness" : "");
}

enum thud_status thud_run_check_rates(const struct thud_run *run, struct thud_error *err)
{
    const struct thud_state *state = &run->state;
    const struct thud_model *m = state->model;
    const bool exact = run->method->order == 0, by_step = run->method->flags & THUD_METHOD_FIXED_STEP;
    const bool by_interval = exact && !m->couples && state->grid_dt_s * m->fastest_radps > interval_most_rad;
    if (state->record && state->end_s > intervals_most * state->grid_dt_s)
        return thud_error_refuse(err, THUD_INPUT, "record.dt", "up to 1e8: a longer step, or a shorter analysis.tail",
                                 "%.3g intervals of %.3g s in %.6g s are too many", state->end_s / state->grid_dt_s,
                                 state->grid_dt_s, state->end_s);
    if (by_step || (!by_interval && state->end_s * m->fastest_radps <= run_most_rad))
        return THUD_OK;
    thud_error_set(err, THUD_INPUT, "free motion of up to %.3g rad/s cannot be followed over %.6g s%s",
                   m->fastest_radps, by_interval ? state->grid_dt_s : state->end_s,
                   by_interval ? ", an interval of the ground motion" : "");
    name_fastest(m, err);
    thud_error_allow(
        err,
        "up to %.3g rad/s here: heavier floors or foundations, softer storeys or soil, weaker dashpots; or "
        "an implicit method",
        by_interval ? interval_most_rad / state->grid_dt_s : run_most_rad / state->end_s);
    return THUD_INPUT;
}

static struct thud_run_ground ground_of(const struct thud_record *r)
{
    struct thud_run_ground ground = {0};
    if (!r)
        return ground;
    ground.peak_mps2 = thud_record_peak(r);
    ground.speed_mps = thud_record_speed(r);
    for (size_t i = 0; i < r->samples; i++)
        ground.impulse_mps += fabs(r->a_mps2[i]) * r->dt_s;
    return ground;
}

void thud_run_set_scales(struct thud_run *run, const struct thud_run *like)
{
    double first = 0, moved_m = 0;
    run->ground = like && like->state.record == run->state.record ? like->ground : ground_of(run->state.record);
    for (int i = 0; i < run->state.model->ndof; i++) {
        first = fmax(first, fabs(thud_model_floor(run->state.model, i, run->state.qd)));
        moved_m = fmax(moved_m, fabs(thud_model_floor(run->state.model, i, run->state.q)));
    }
    for (int c = 0; c < run->state.model->ncontacts; c++)
        moved_m = fmax(moved_m, thud_contact_indentation(&run->state, c));
    run->state.ground_mps2 = run->ground.peak_mps2;
    run->state.speed_mps = first + run->ground.speed_mps;
    run->state.length_m = moved_m + fmax(run->state.speed_mps, run->state.ground_mps2); /* in 1 s */
    run->state.touch_m = THUD_TOL_INDENTATION * run->state.length_m;
}

/* d sqrt(2 E)/dt <= |gamma| |a_g|, whatever the contacts do that give no energy: so sqrt(2 E) never passes its first
 * value plus |gamma| times the integral of |a_g|. */
void thud_run_set_bound(struct thud_run *run)
{
    static const double times = 100; /* a coarse but stable step may overshoot; more is a run that has blown up */
    const struct thud_model *m = run->state.model;
    double mass = 0, energy = thud_state_kinetic(&run->state) + thud_state_strain(&run->state);
    for (int j = 0; j < m->nmodes; j++)
        mass += m->gamma[j] * m->gamma[j];
    for (int c = 0; c < m->ncontacts; c++) {
        const struct thud_model_contact *p = &m->contact[c];
        double d = thud_contact_indentation(&run->state, c);
        energy += thud_law_energy(p->law, &p->setup, &run->state.contact[c].memory, THUD_APPROACH, d);
    }
    const double bound = sqrt(2 * energy) + sqrt(mass) * fmax(run->ground.impulse_mps, 1e-3), most = times * bound;
    run->state.energy_most = fmin(most * most, DBL_MAX);
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
    const struct thud_model *m = run->state.model;
    /* a storey that yields may drift as far as it likes without strain */
    if ((m->traits & THUD_SLIPS ? thud_dot(m->nmodes, qd, qd) : thud_energy_sum(m->nmodes, m->spring, q, qd)) <=
        run->state.energy_most)
        return THUD_OK;
    int i = worst_floor(m, qd), s = m->dof_structure[i];
    thud_error_set(err, THUD_DIVERGED, "the response blew up at t = %.6g s, structure %d, floor %d",
                   thud_state_now(&run->state), s + 1, i - m->structure[s].first + 1);
    thud_error_key(err, "%s", run->method->name);
    if (run->state.energy_most == DBL_MAX)
        thud_error_allow(err, "a ground motion with a finite energy; its peak is %.3g m/s2", run->ground.peak_mps2);
    if (run->method->flags & THUD_METHOD_FIXED_STEP)
        thud_error_allow(err, "%s; step used %.6g s, fastest mode %.6g rad/s", run->method->limits, run->state.step_s,
                         run->state.fastest_radps);
    return THUD_DIVERGED;
}

double thud_run_balance(const struct thud_run *run)
{
    /* What rounding explains: motion and linear contact are propagated to rounding, and over hundreds of random scenes,
     * the presets and their studies the ledger then stands at 1e-15 to 3e-13. What the tolerance explains, as of a peak:
     * the ledger stood at 1.03 of it after fifteen contacts of an undamped building, which each lose 0.08, and at 3.4 by
     * methods that step through all of the motion. And what a coarse but stable step may lose. */
    static const double coarse = 0.05;
    const struct thud_model *m = run->state.model;
    bool linear = true;
    for (int c = 0; c < m->ncontacts; c++)
        linear = linear && thud_law_is_linear(m->contact[c].law);
    if (run->method->flags & THUD_METHOD_FIXED_STEP || !run->state.locates)
        return coarse;
    return run->method->order == 0 && linear ? THUD_TOL_BALANCE
                                             : fmin(THUD_TOL_BALANCE + 10 * run->options.tolerance, coarse);
}

enum thud_status thud_run_judge(const struct thud_run *run, struct thud_error *err)
{
    double ratio = run->result.energy.error_ratio, most = run->ledger.limit;
    if (run->options.unjudged || ratio <= most) /* false for NaN */
        return THUD_OK;
    thud_error_set(err, THUD_DIVERGED, "%.2g %% of the energy is unaccounted for: it has not balanced since t = %.6g s",
                   100 * ratio, run->ledger.balanced_s);
    thud_error_key(err, "%s", run->method->name);
    if (run->method->flags & THUD_METHOD_FIXED_STEP)
        thud_error_allow(err, "at most %.2g %%; step used %.6g s, fastest mode %.6g rad/s", 100 * most,
                         run->result.step_s, run->state.fastest_radps);
    else
        thud_error_allow(err, "at most %.2g %%", 100 * most);
    return THUD_DIVERGED;
}
