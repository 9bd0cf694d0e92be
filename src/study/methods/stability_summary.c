/* Each method in one row: its order where contacts open and close, the steps that the scene needs, what it does to
 * energy and to restitution. */
#include <math.h>
#include <string.h>

#include "study/methods/bench_private.h"
#include "study/methods/stability_private.h"

/* Mean error of the time of the fourth impact on the wall spring, over the starts; NaN: it blew up. */
static enum thud_status impact_error(struct thud_stepping how, double *mean_s, struct thud_error *err)
{
    enum { FOURTH = 3 };
    enum thud_status status = THUD_OK;
    *mean_s = 0;
    for (int i = 0; i < THUD_STABILITY_STARTS && !thud_trial_failed(status); i++) {
        struct thud_two_body bouncer = thud_bouncer();
        double start_s[2] = {NAN, NAN};
        thud_bouncer_spring(&bouncer, thud_stability_wall_radps);
        bouncer.clearance_m = thud_stability_start_m[i];
        for (int k = 0; k < 2 && !thud_trial_failed(status); k++) {
            struct thud_solution solution;
            int n;
            status = thud_bouncer_run(&bouncer, NULL, k ? thud_stepping_of("exact", 1e-6, true) : how, 6, &solution,
                                      NULL, err);
            if (thud_trial_failed(status))
                break;
            const struct thud_impact *impact = thud_run_impacts(solution.run, &n);
            start_s[k] = status == THUD_OK && n > FOURTH ? impact[FOURTH].start_s : NAN;
            thud_solution_clear(&solution);
        }
        *mean_s += fabs(start_s[0] - start_s[1]) / THUD_STABILITY_STARTS;
    }
    return thud_trial_failed(status) ? status : THUD_OK;
}

/* The largest step or tolerance of a row that keeps the scene's peaks and impacts, as the next smaller; NaN: none. */
static enum thud_status find_kept(const struct thud_stability *s, struct thud_stability_summary *m,
                                  struct thud_error *err)
{
    static const double steps[] = {2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4},
                        tolerances[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}, level[2] = {0.1, 0.01};
    enum { SETTINGS = sizeof steps / sizeof *steps };
    const bool fixed = m->how.method->flags & THUD_METHOD_FIXED_STEP;
    bool before[2] = {false, false};
    for (int i = 0; i < SETTINGS && isnan(m->keeps[1]); i++) {
        struct thud_stepping how = m->how;
        struct thud_bench_solution taken = {0};
        struct thud_bench_errors e = {.all = INFINITY};
        struct thud_record *coarse;
        struct thud_run *run;
        how.setting = fixed ? steps[i] : tolerances[i];
        enum thud_status status = thud_stability_scene(s, how, &run, &coarse, err);
        if (thud_trial_failed(status))
            return status;
        if (status == THUD_OK) {
            status = thud_bench_solution_take(run, &taken, err);
            if (status == THUD_OK)
                e = thud_bench_compare(&taken, s->exact);
            thud_bench_solution_clear(&taken);
        }
        thud_run_free(run);
        thud_record_free(coarse);
        if (thud_trial_failed(status))
            return status;
        for (int k = 0; k < 2; k++) {
            const bool kept = e.all <= level[k] && e.missed + e.extra == 0;
            if (kept && (before[k] || i + 1 == SETTINGS) && isnan(m->keeps[k]))
                m->keeps[k] = before[k] ? (fixed ? steps : tolerances)[i - 1] : how.setting;
            before[k] = kept;
        }
    }
    return THUD_OK;
}

enum thud_status thud_stability_summarise(const struct thud_stability *s, struct thud_stability_summary *m,
                                          struct thud_error *err)
{
    static const double coarse_s = 4e-3, fine_s = 1e-3;
    double error_s[2];
    enum thud_status status = THUD_OK;
    if (m->how.method->flags & THUD_METHOD_FIXED_STEP) {
        struct thud_stepping how = m->how;
        for (int k = 0; k < 2 && status == THUD_OK; k++) {
            how.setting = k ? fine_s : coarse_s;
            status = impact_error(how, &error_s[k], err);
        }
        if (status == THUD_OK && error_s[1] > 0)
            m->order = log(error_s[0] / error_s[1]) / log(coarse_s / fine_s);
    }
    return status == THUD_OK && s->peak_m ? find_kept(s, m, err) : status;
}

struct thud_stability_summary thud_stability_summary_of(const struct thud_stability *s, int i)
{
    static const double shown_omega_dt = 0.5, shown_step_s = 1e-3, shown_nominal = 0.5;
    struct thud_stability_summary m = s->summary[i];
    m.diverges_s = m.wall_least = m.wall_most = m.expected = m.obtained = NAN;
    for (int k = 0; k < s->ncells; k++) {
        const struct thud_stability_cell *c = &s->cell[k];
        if (!thud_stepping_same(&c->how, &m.how))
            continue;
        if (c->verdict[THUD_STABILITY_SCENE] == THUD_BLOWN_UP && !(m.diverges_s <= c->omega_dt / s->fastest_radps))
            m.diverges_s = c->omega_dt / s->fastest_radps;
        if (isnan(c->omega_dt) || c->omega_dt == shown_omega_dt) {
            m.wall_least = c->end_least;
            m.wall_most = c->end_most;
        }
    }
    for (int k = 0; k < s->nrestitutions; k++) {
        const struct thud_stability_restitution *r = &s->restitution[k];
        const bool fixed = m.how.method->flags & THUD_METHOD_FIXED_STEP;
        if (thud_stepping_same(&r->how, &m.how) && r->nominal == shown_nominal &&
            r->approach_mps == thud_stability_usual_mps && (!fixed || r->how.setting == shown_step_s) &&
            strcmp(r->law->name, "kelvin-voigt-no-tension") == 0) {
            m.expected = r->expected;
            m.obtained = r->obtained;
        }
    }
    return m;
}
