#include "app/sweep/sweep_collector.h"

#include <stdlib.h>

#include "base/grow.h"

void thud_sweep_collector_init(struct thud_sweep_collector *collector, const struct thud_sweep_plan *plan,
                               const char *const *record)
{
    *collector = (struct thud_sweep_collector){0};
    for (int i = 0; i < plan->scene.nstructures; i++) {
        collector->structure[i] = plan->scene.structure[i].name;
        collector->kind[i] = plan->scene.structure[i].kind;
    }
    collector->table =
        (struct thud_sweep_table){.nrecords = plan->nrecords > 0 ? plan->nrecords : 1,
                                  .nstructures = plan->scene.nstructures,
                                  .naxes = plan->naxes,
                                  .measures = thud_scene_measures(&plan->scene),
                                  .free_links = thud_case_has_links(thud_sweep_free_case(plan)),
                                  .need_links = thud_case_has_links(thud_sweep_need_case(plan->cases, plan->ncases)),
                                  .sensitivity = plan->sensitivity,
                                  .record = record,
                                  .motion = plan->record,
                                  .structure = collector->structure,
                                  .kind = collector->kind,
                                  .axis = plan->axis};
}

/* Room for one more point; false when out of memory. */
static bool reserve(struct thud_sweep_collector *c)
{
    if (!c->need)
        c->need = calloc(2 * (size_t)c->table.nrecords, sizeof *c->need);
    struct thud_sweep_summary **larger = thud_grow(c->point, c->table.npoints, sizeof *larger);
    c->point = larger ? larger : c->point;
    return larger && c->need;
}

/* Keeps the level that decides the gap of a group of points where it is the widest, or the narrowest, of its record. */
static void add_need(struct thud_sweep_collector *c, const struct thud_sweep_plan *plan,
                     const struct thud_sweep_point *point)
{
    const enum thud_case free = thud_sweep_need_case(plan->cases, plan->ncases);
    const struct thud_gap_level *level = thud_sweep_levels(point, free), *decides = level;
    if (!thud_sweep_is_first(plan, point) || point->ncontacts == 0)
        return;
    for (int i = 1; i < point->ncontacts; i++)
        if (level[i].relative_displacement_m > decides->relative_displacement_m)
            decides = &level[i];
    struct thud_sweep_need_row own = {.level = *decides, .fall = *thud_sweep_fall(point, free)};
    own.record = thud_sweep_place(plan, point->index, own.at);
    struct thud_sweep_need_row *most = &c->need[own.record], *least = most + c->table.nrecords;
    const struct thud_collapse fall = own.fall.happened ? own.fall : most->fall;
    const double own_m = own.level.relative_displacement_m;
    if (most->level.interface == 0 || own_m > most->level.relative_displacement_m)
        *most = own;
    most->fall = fall; /* of any of them */
    /* the gap until a collapse is no least one */
    if (least->level.interface == 0 || (least->fall.happened && !own.fall.happened) ||
        (own_m < least->level.relative_displacement_m && !own.fall.happened))
        *least = own;
}

enum thud_status thud_sweep_collector_add(struct thud_sweep_collector *c, const struct thud_sweep_plan *plan,
                                          const struct thud_sweep_point *point, struct thud_error *err)
{
    struct thud_sweep_summary *summary = NULL;
    if (!reserve(c))
        return thud_error_set(err, THUD_MEMORY, "out of memory for the rows of the study");
    add_need(c, plan, point);
    enum thud_status status = thud_sweep_summary_make(plan, point, &summary, err);
    if (summary) {
        c->point[c->table.npoints++] = summary;
        c->table.nrows += (size_t)summary->nruns * (size_t)summary->nrows;
    }
    c->table.point = c->point;
    c->table.need = c->need;
    return status;
}

void thud_sweep_collector_clear(struct thud_sweep_collector *collector)
{
    for (size_t i = 0; i < collector->table.npoints; i++)
        free(collector->point[i]);
    free(collector->point);
    free(collector->need);
    *collector = (struct thud_sweep_collector){0};
}
