/* A figure as bytes, for another process of the same program, and from them again; a copy goes the same way. One walk
 * through a figure does both: what it passes is written out, or taken from the bytes into the figure's own memory. */
#include <stdlib.h>
#include <string.h>

#include "plot/figure/figure_memory.h"

struct stream {
    struct thud_text *out;      /* NULL: it is read */
    const char *at, *end;       /* what is left then */
    struct thud_figure *figure; /* whose memory it becomes */
};

static void pass(struct stream *s, void *data, size_t size)
{
    if (s->out) {
        thud_text_bytes(s->out, data, size);
    } else if (size <= (size_t)(s->end - s->at)) {
        memcpy(data, s->at, size);
        s->at += size;
    } else {
        memset(data, 0, size);
        s->at = s->end;
        s->figure->failed = true; /* cut off */
    }
}

/* `count` of something that stands elsewhere, with room as an array that grows has it; what was NULL stays NULL. */
static void *pass_array(struct stream *s, const void *data, size_t count, size_t size)
{
    void *own = (void *)data;
    size_t room = 1;
    if (!data)
        return NULL;
    if (!s->out) {
        while (room < count)
            room *= 2;
        const bool there = count <= (size_t)(s->end - s->at) / size;
        s->figure->failed = s->figure->failed || !there;
        own = there ? thud_figure_keep(s->figure, room, size) : NULL;
    }
    if (own && count > 0)
        pass(s, own, count * size);
    return own;
}

static void pass_text(struct stream *s, const char **text)
{
    size_t n = s->out ? strlen(*text) + 1 : 0;
    pass(s, &n, sizeof n);
    const char *own = pass_array(s, *text, n, 1);
    if (!s->out) /* the words may be constants of the program */
        *text = own && n > 0 && !own[n - 1] ? own : "";
}

static void pass_axis(struct stream *s, struct thud_axis *axis)
{
    pass_text(s, &axis->label);
    pass_text(s, &axis->unit);
    axis->tick = pass_array(s, axis->tick, (size_t)axis->nticks, sizeof *axis->tick);
    for (int i = 0; axis->tick && i < axis->nticks; i++)
        pass_text(s, &axis->tick[i].text);
}

static void pass_series(struct stream *s, struct thud_series **series)
{
    struct thud_series *own = *series = pass_array(s, *series, 1, sizeof **series);
    if (!own)
        return;
    pass_text(s, &own->name);
    own->x = pass_array(s, own->x, own->n, sizeof *own->x);
    own->y = pass_array(s, own->y, own->n, sizeof *own->y);
    own->y_high = pass_array(s, own->y_high, own->n, sizeof *own->y_high);
}

static void pass_map(struct stream *s, struct thud_panel *panel)
{
    struct thud_map *map = panel->map = pass_array(s, panel->map, 1, sizeof *map);
    if (!map)
        return;
    pass_text(s, &map->label);
    pass_text(s, &map->unit);
    map->x = pass_array(s, map->x, map->nx, sizeof *map->x);
    map->y = pass_array(s, map->y, map->ny, sizeof *map->y);
    map->z = pass_array(s, map->z, map->nx * map->ny, sizeof *map->z);
    map->class_name = pass_array(s, map->class_name, (size_t)map->classes, sizeof *map->class_name);
    for (int i = 0; map->class_name && i < map->classes; i++)
        pass_text(s, (const char **)&map->class_name[i]);
}

static void pass_panel(struct stream *s, struct thud_panel *panel)
{
    if (!s->out)
        panel->figure = s->figure;
    pass_text(s, &panel->title);
    pass_text(s, &panel->note);
    pass_axis(s, &panel->axis[THUD_X]);
    pass_axis(s, &panel->axis[THUD_Y]);
    panel->series = pass_array(s, panel->series, (size_t)panel->nseries, sizeof *panel->series);
    for (int i = 0; panel->series && i < panel->nseries; i++)
        pass_series(s, &panel->series[i]);
    panel->mark = pass_array(s, panel->mark, (size_t)panel->nmarks, sizeof *panel->mark);
    for (int i = 0; panel->mark && i < panel->nmarks; i++)
        pass_text(s, &panel->mark[i].text);
    panel->label = pass_array(s, panel->label, (size_t)panel->nlabels, sizeof *panel->label);
    for (int i = 0; panel->label && i < panel->nlabels; i++)
        pass_text(s, &panel->label[i].text);
    pass_map(s, panel);
}

static void pass_figure(struct stream *s)
{
    struct thud_figure *figure = s->figure;
    pass_text(s, &figure->name);
    pass_text(s, &figure->title);
    pass_text(s, &figure->note);
    figure->panel = pass_array(s, figure->panel, (size_t)figure->rows * (size_t)figure->columns, sizeof *figure->panel);
    for (int i = 0; figure->panel && i < figure->rows * figure->columns; i++)
        pass_panel(s, &figure->panel[i]);
}

void thud_figure_write(const struct thud_figure *figure, struct thud_text *out)
{
    struct thud_figure written = *figure; /* its memory is as it was: what is written is not changed */
    struct stream s = {.out = out, .figure = &written};
    thud_text_bytes(out, (const char *)figure, sizeof *figure);
    pass_figure(&s);
}

struct thud_figure *thud_figure_read(const char **bytes, const char *end)
{
    struct thud_figure *figure = calloc(1, sizeof *figure);
    struct stream s = {.at = *bytes, .end = end, .figure = figure};
    if (!figure)
        return NULL;
    pass(&s, figure, sizeof *figure);
    figure->failed = s.at == end;
    figure->blocks = NULL;
    if (!figure->failed)
        pass_figure(&s);
    *bytes = s.at;
    if (thud_figure_check(figure, NULL) == THUD_OK)
        return figure;
    thud_figure_free(figure);
    return NULL;
}

struct thud_figure *thud_figure_copy(const struct thud_figure *figure)
{
    struct thud_text bytes = {0};
    if (thud_figure_check(figure, NULL) != THUD_OK)
        return NULL;
    thud_figure_write(figure, &bytes);
    const char *at = bytes.data;
    struct thud_figure *copy = bytes.failed ? NULL : thud_figure_read(&at, bytes.data + bytes.size);
    thud_text_clear(&bytes);
    return copy;
}
