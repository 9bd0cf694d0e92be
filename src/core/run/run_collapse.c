/* P-Delta: a storey whose drift reaches a tenth of its height has collapsed, and the run ends there. */
#include "core/run/run_private.h"

static void note(struct thud_run *run, int structure, int floor, struct thud_peak drift)
{
    run->result.collapse = (struct thud_collapse){true, structure, floor, drift.time_s, drift.value};
}

void thud_run_collapse(struct thud_run *run, int dof)
{
    const int s = run->state.model->dof_structure[dof], floor = dof - run->state.model->structure[s].first;
    note(run, s, floor,
         (struct thud_peak){run->state.model->structure[s].collapse_m[floor], thud_state_now(&run->state)});
}

void thud_run_watch_collapse(struct thud_run *run)
{
    const struct thud_model *m = run->state.model;
    for (int s = 0; s < m->nstructures && m->collapses; s++) {
        const double *limit = m->structure[s].collapse_m;
        for (int i = 0; limit && i < m->structure[s].n && !run->result.collapse.happened; i++) {
            const struct thud_floor_result *floor = &run->result.structure[s].floor[i];
            const struct thud_peak drift = m->structure[s].rise ? floor->lean : floor->drift;
            if (drift.value > limit[i])
                note(run, s, i, drift);
        }
    }
}
