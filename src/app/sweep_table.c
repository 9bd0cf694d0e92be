#include "app/sweep_table.h"

#include <stdlib.h>

void thud_sweep_collector_init(struct thud_sweep_collector *collector, const struct thud_sweep_plan *plan,
                               const char *const *record)
{
    *collector = (struct thud_sweep_collector){0};
    for (int i = 0; i < plan->scene.nstructures; i++)
        collector->structure[i] = plan->scene.structure[i].name;
    collector->table = (struct thud_sweep_table){.nrecords = plan->nrecords > 0 ? plan->nrecords : 1,
                                                 .nstructures = plan->scene.nstructures,
                                                 .naxes = plan->naxes,
                                                 .sensitivity = plan->sensitivity,
                                                 .record = record,
                                                 .structure = collector->structure,
                                                 .axis = plan->axis};
}

/* Room for `more` beyond n; false when out of memory. */
static bool reserve(void *array, size_t *room, size_t n, int more, size_t size)
{
    void **place = array;
    size_t need = n + (size_t)(more > 0 ? more : 0), want = *room ? *room : 256;
    if (need <= *room)
        return true;
    while (want < need)
        want *= 2;
    void *larger = realloc(*place, want * size);
    if (!larger)
        return false;
    *place = larger;
    *room = want;
    return true;
}

enum thud_status thud_sweep_collector_add(struct thud_sweep_collector *c, const struct thud_sweep_plan *plan,
                                          const struct thud_sweep_point *point, struct thud_error *err)
{
    struct thud_sweep_table *t = &c->table;
    int rows = thud_sweep_rows(plan, point, NULL), contacts = thud_sweep_contact_rows(plan, point, NULL),
        needs = thud_sweep_need_rows(plan, point, NULL);
    if (!reserve(&c->row, &c->rows_room, t->nrows, rows, sizeof *c->row) ||
        !reserve(&c->contact, &c->contacts_room, t->ncontacts, contacts, sizeof *c->contact) ||
        !reserve(&c->need, &c->needs_room, t->nneeds, needs, sizeof *c->need))
        return thud_error_set(err, THUD_MEMORY, "out of memory for the rows of the study");
    if (rows > 0)
        t->nrows += (size_t)thud_sweep_rows(plan, point, c->row + t->nrows);
    if (contacts > 0)
        t->ncontacts += (size_t)thud_sweep_contact_rows(plan, point, c->contact + t->ncontacts);
    if (needs > 0)
        t->nneeds += (size_t)thud_sweep_need_rows(plan, point, c->need + t->nneeds);
    t->row = c->row;
    t->contact = c->contact;
    t->need = c->need;
    return THUD_OK;
}

void thud_sweep_collector_clear(struct thud_sweep_collector *collector)
{
    free(collector->row);
    free(collector->contact);
    free(collector->need);
    *collector = (struct thud_sweep_collector){0};
}
