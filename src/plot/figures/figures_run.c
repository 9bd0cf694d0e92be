/* The list of figures of runs. */
#include "plot/figures/figures_run_internal.h"

enum needs { CONTACTS, FLOORS, IMPACTS, STOREYS, YIELDING, YIELDING_OR_LINKS, STRUCK_COLUMNS };

static const struct {
    const char *name;
    enum needs needs;
    struct thud_figure *(*make)(enum thud_run_figure which, const struct thud_figure_source *source, int nsources);
} figures[THUD_RUN_FIGURES] = {
#define THUD_RUN_FIGURE(NAME, name, maker, needs) {name, needs, thud_figure_##maker},
    THUD_RUN_FIGURE_LIST(THUD_RUN_FIGURE)
#undef THUD_RUN_FIGURE
};

const char *thud_run_figure_name(enum thud_run_figure which)
{
    return figures[which].name;
}

bool thud_run_figure_has(enum thud_run_figure which, const struct thud_figure_source *source, int nsources)
{
    const enum needs needs = figures[which].needs;
    bool any = false, struck = false;
    for (int i = 0; i < source->result->nstructures; i++) {
        bool storeys = thud_kind_is_building(source->scene->structure[i].kind);
        any = any || (thud_source_shown(source, i, which) && (needs != STOREYS || storeys));
    }
    for (int s = 0; s < nsources; s++) {
        if (source[s].history->rows == 0)
            return false;
        struck = struck || source[s].nimpacts > 0;
    }
    return needs == CONTACTS         ? source->result->ncontacts > 0
           : needs == IMPACTS        ? struck
           : needs == STRUCK_COLUMNS ? source->result->ncolumns > 0
           : needs >= YIELDING       ? thud_source_yields(source, nsources, needs == YIELDING_OR_LINKS)
                                     : any;
}

struct thud_figure *thud_run_figure(enum thud_run_figure which, const struct thud_figure_source *source, int nsources)
{
    return figures[which].make(which, source, nsources);
}
