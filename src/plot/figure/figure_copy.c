#include <math.h>

#include "plot/figure/figure.h"

static void copy_axis(struct thud_panel *to, const struct thud_panel *from, enum thud_side side)
{
    const struct thud_axis *axis = &from->axis[side];
    thud_panel_axis(to, side, axis->label, axis->unit);
    thud_panel_limits(to, side, axis->least, axis->most);
    if (axis->log)
        thud_panel_log(to, side);
    for (int i = 0; i < axis->nticks; i++)
        thud_panel_tick(to, side, axis->tick[i].at, axis->tick[i].text);
}

static void copy_panel(struct thud_panel *to, const struct thud_panel *from)
{
    thud_panel_note(to, from->note);
    copy_axis(to, from, THUD_X);
    copy_axis(to, from, THUD_Y);
    for (int i = 0; i < from->nseries; i++) {
        const struct thud_series *s = from->series[i];
        if (s->y_high)
            thud_panel_fill(to, s->style, s->name, s->n, s->x, s->y, s->y_high);
        else
            thud_panel_add(to, s->style, s->name, s->n, s->x, s->y);
    }
    for (int i = 0; i < from->nmarks; i++)
        thud_panel_mark(to, from->mark[i].side, from->mark[i].from, from->mark[i].to, from->mark[i].text);
    for (int i = 0; i < from->nlabels; i++)
        thud_panel_label(to, from->label[i].x, from->label[i].y, from->label[i].side, from->label[i].text);
    if (from->map) {
        const struct thud_map *m = from->map;
        struct thud_map *map = thud_panel_map(to, m->nx, m->x, m->ny, m->y, m->z, m->label, m->unit);
        if (map) {
            map->centre = m->centre;
            map->level = m->level;
            map->reach = m->reach;
            map->class_name = m->class_name;
            map->classes = m->classes;
        }
    }
    if (to) {
        to->closer = from->closer;
        to->strip = from->strip;
        to->drawing = from->drawing;
    }
}

struct thud_figure *thud_figure_copy(const struct thud_figure *figure)
{
    if (thud_figure_check(figure, NULL) != THUD_OK)
        return NULL;
    struct thud_figure *copy = thud_figure_create(figure->name, figure->title, figure->rows, figure->columns);
    thud_figure_note(copy, figure->note);
    for (int i = 0; i < figure->rows * figure->columns; i++)
        if (figure->panel[i].used)
            copy_panel(thud_figure_panel(copy, i / figure->columns, i % figure->columns, figure->panel[i].title),
                       &figure->panel[i]);
    if (thud_figure_check(copy, NULL) == THUD_OK)
        return copy;
    thud_figure_free(copy);
    return NULL;
}
