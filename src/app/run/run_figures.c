#include "app/run/figure_files.h"
#include "plot/figures/figures_sweep.h"

struct thud_figure_source thud_run_source(const char *name, enum thud_case which, const struct thud_scene *scene,
                                          const struct thud_run *run)
{
    struct thud_figure_source source = {
        .name = name, .which = which, .scene = scene, .result = thud_run_result(run), .history = thud_run_history(run)};
    source.impact = thud_run_impacts(run, &source.nimpacts);
    return source;
}

enum thud_status thud_run_figures_save(const struct thud_figure_source *source, int nsources, const char *folder,
                                       const struct thud_picture_options *options, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < THUD_RUN_FIGURES && (status == THUD_OK || status == THUD_GNUPLOT); i++) {
        enum thud_run_figure which = (enum thud_run_figure)i;
        if (thud_run_figure_has(which, source, nsources))
            status = thud_figure_deliver(thud_run_figure(which, source, nsources), folder, options, status, err);
    }
    return status;
}

enum thud_status thud_sweep_figures_save(const struct thud_sweep_table *table, const char *folder,
                                         const struct thud_picture_options *options, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    struct thud_sweep_table *suite = NULL;
    if (table->nrecords > THUD_SWEEP_FIGURE_RECORDS) { /* what they say together, and not 24 figures of each kind */
        status = thud_sweep_suite_make(table, &suite, err);
        table = suite;
    }
    int n = status == THUD_OK ? thud_sweep_figure_count(table) : 0;
    for (int i = 0; i < n && (status == THUD_OK || status == THUD_GNUPLOT); i++)
        status = thud_figure_deliver(thud_sweep_figure(table, i), folder, options, status, err);
    thud_sweep_suite_free(suite);
    return status;
}
