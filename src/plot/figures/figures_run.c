/* The list of figures of runs. */
#include "plot/figures/figures_run_internal.h"

bool thud_run_figure_has(enum thud_run_figure which, const struct thud_figure_source *source, int nsources)
{
    bool any = false, struck = false;
    for (int i = 0; i < source->result->nstructures; i++) {
        bool storeys = thud_kind_is_building(source->scene->structure[i].kind);
        any = any || (thud_source_shown(source, i, which) && (which != THUD_FIGURE_ENVELOPE || storeys));
    }
    for (int s = 0; s < nsources; s++) {
        if (source[s].history->rows == 0)
            return false;
        struck = struck || source[s].nimpacts > 0;
    }
    if (which == THUD_FIGURE_LOOP)
        return struck;
    if (which == THUD_FIGURE_HYSTERESIS || which == THUD_FIGURE_PERMANENT)
        return thud_source_yields(source, nsources, which == THUD_FIGURE_HYSTERESIS);
    if (which == THUD_FIGURE_COLUMNS)
        return source->result->ncolumns > 0;
    return which == THUD_FIGURE_FORCE ? source->result->ncontacts > 0 : any;
}

struct thud_figure *thud_run_figure(enum thud_run_figure which, const struct thud_figure_source *source, int nsources)
{
    switch (which) {
    case THUD_FIGURE_FORCE:
        return thud_figure_forces(source, nsources);
    case THUD_FIGURE_LOOP:
        return thud_figure_loops(source, nsources);
    case THUD_FIGURE_ENVELOPE:
        return thud_figure_envelopes(source, nsources);
    case THUD_FIGURE_ENERGY:
        return thud_figure_energies(source, nsources);
    case THUD_FIGURE_HYSTERESIS:
        return thud_figure_hysteresis(source, nsources);
    case THUD_FIGURE_PERMANENT:
        return thud_figure_permanent(source, nsources);
    case THUD_FIGURE_COLUMNS:
        return thud_figure_columns(source, nsources);
    default:
        return thud_figure_histories(which, source, nsources);
    }
}
