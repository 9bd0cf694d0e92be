#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"

#include "tui/widgets/form.h"

void thud_form_begin(struct thud_form *form, int screen)
{
    form->n = 0;
    form->screen = screen;
    memset(form->used, 0, sizeof form->used);
    memset(form->height, 0, sizeof form->height);
}

void thud_form_add(struct thud_form *form, enum thud_field_kind kind, int pane, int x, int y, int w, int index,
                   const char *path)
{
    struct thud_field *larger = thud_grow(form->field, (size_t)form->n, sizeof *larger);
    if (!larger)
        return;
    form->field = larger;
    struct thud_field *field = &larger[form->n++];
    *field = (struct thud_field){.kind = kind, .pane = pane, .x = x, .y = y, .w = w, .index = index};
    snprintf(field->path, sizeof field->path, "%s", path);
}

void thud_form_add_beside(struct thud_form *form, int pane, int x, int y, int w, const char *path)
{
    int n = form->n;
    thud_form_add(form, THUD_FIELD_VALUE, pane, x, y, w, 0, path);
    if (form->n > n)
        form->field[n].beside = true;
}

const struct thud_field *thud_form_focus(const struct thud_form *form)
{
    const char *focus = form->focus[form->screen];
    for (int i = 0; i < form->n; i++)
        if (form->field[i].pane == form->pane[form->screen] && strcmp(form->field[i].path, focus) == 0)
            return &form->field[i];
    return NULL;
}

bool thud_form_focused(const struct thud_form *form, int pane, const char *path)
{
    return form->pane[form->screen] == pane && strcmp(form->focus[form->screen], path) == 0;
}

void thud_form_focus_on(struct thud_form *form, int screen, const char *path)
{
    snprintf(form->focus[screen], THUD_PATH_MAX, "%s", path);
    form->loose[screen] = false;
    form->pane[screen] = -1; /* found at the next drawing */
}

static void focus_field(struct thud_form *form, const struct thud_field *field)
{
    form->loose[form->screen] = false;
    snprintf(form->focus[form->screen], THUD_PATH_MAX, "%s", field->path);
    form->pane[form->screen] = field->pane;
}

static const struct thud_field *first_of(const struct thud_form *form, int pane)
{
    for (int i = 0; i < form->n; i++)
        if (form->field[i].pane == pane)
            return &form->field[i];
    return NULL;
}

/* Puts the cursor on a field that exists. */
static void settle_focus(struct thud_form *form, int panes)
{
    int *pane = &form->pane[form->screen];
    if (*pane < 0) {
        for (int i = 0; i < form->n && *pane < 0; i++)
            if (strcmp(form->field[i].path, form->focus[form->screen]) == 0)
                *pane = form->field[i].pane;
        size_t n = strlen(form->focus[form->screen]);
        for (int i = 0; i < form->n && *pane < 0 && n > 0; i++) /* a group's first */
            if (strncmp(form->field[i].path, form->focus[form->screen], n) == 0 && form->field[i].path[n] == '.')
                focus_field(form, &form->field[i]);
        if (*pane < 0)
            *pane = 0;
    }
    if (*pane >= panes)
        *pane = panes > 0 ? panes - 1 : 0;
    if (!thud_form_focus(form)) {
        const struct thud_field *field = first_of(form, *pane);
        if (field)
            focus_field(form, field);
        else
            form->focus[form->screen][0] = '\0';
    }
}

bool thud_form_end(struct thud_form *form, int panes)
{
    const struct thud_field *drawn = thud_form_focus(form);
    settle_focus(form, panes);
    bool moved = thud_form_focus(form) != drawn; /* it was drawn without the cursor */
    const struct thud_field *focus = thud_form_focus(form);
    for (int i = 0; i < panes && i < THUD_FORM_PANES; i++) {
        int *scroll = &form->scroll[form->screen][i], most = form->used[i] - form->height[i], old = *scroll;
        if (focus && focus->pane == i && form->height[i] > 0 && !form->loose[form->screen]) {
            if (focus->y < *scroll)
                *scroll = focus->y;
            if (focus->y >= *scroll + form->height[i])
                *scroll = focus->y - form->height[i] + 1;
            if (first_of(form, i) == focus && focus->y < form->height[i])
                *scroll = 0; /* what stands above the first field is shown with it */
        }
        if (*scroll > most)
            *scroll = most;
        if (*scroll < 0)
            *scroll = 0;
        moved = moved || *scroll != old;
    }
    return moved;
}

/* The nearest field in a direction within the pane; up and down prefer the same column, left and right the same row. */
static const struct thud_field *neighbour(const struct thud_form *form, const struct thud_field *from, int dx, int dy)
{
    const struct thud_field *best = NULL;
    int least = 1 << 30;
    for (int i = 0; i < form->n; i++) {
        const struct thud_field *f = &form->field[i];
        int across = f->x - from->x, down = f->y - from->y;
        if (f->pane != from->pane || f == from || (dy != 0 && down * dy <= 0) ||
            (dx != 0 && (across * dx <= 0 || down)))
            continue;
        int distance = dy ? abs(down) * 1000 + abs(across) : abs(across);
        if (distance < least) {
            least = distance;
            best = f;
        }
    }
    return best;
}

void thud_form_move(struct thud_form *form, int dx, int dy)
{
    const struct thud_field *from = thud_form_focus(form);
    int pane = form->pane[form->screen];
    if (!from) {
        if (pane >= 0 && pane < THUD_FORM_PANES)
            form->scroll[form->screen][pane] += dy;
        return;
    }
    const struct thud_field *to = neighbour(form, from, dx, dy);
    int *scroll = &form->scroll[form->screen][pane];
    bool hidden = form->loose[form->screen] && from->y < *scroll;
    if (dy < 0 && hidden)
        --*scroll;
    else if (to)
        focus_field(form, to);
    else if (dy > 0) {
        form->loose[form->screen] = true;
        ++*scroll; /* as far as there is anything: thud_form_end */
    }
}

void thud_form_page(struct thud_form *form, int pages)
{
    int pane = form->pane[form->screen];
    if (pane < 0 || pane >= THUD_FORM_PANES)
        return;
    int rows = form->height[pane] > 1 ? form->height[pane] - 1 : 1;
    if (!thud_form_focus(form)) {
        form->scroll[form->screen][pane] += pages * rows;
        return;
    }
    for (int i = 0; i < rows; i++)
        thud_form_move(form, 0, pages);
}

void thud_form_edge(struct thud_form *form, bool last)
{
    int pane = form->pane[form->screen];
    const struct thud_field *best = NULL;
    for (int i = 0; i < form->n; i++)
        if (form->field[i].pane == pane && (!best || last))
            best = &form->field[i];
    if (best) {
        focus_field(form, best);
        form->loose[form->screen] = last;
        if (last)
            form->scroll[form->screen][pane] = form->used[pane];
    } else if (pane >= 0 && pane < THUD_FORM_PANES)
        form->scroll[form->screen][pane] = last ? form->used[pane] : 0;
}

void thud_form_pane(struct thud_form *form, int step, int panes)
{
    if (panes < 1)
        return;
    int pane = (form->pane[form->screen] + step + panes) % panes;
    form->pane[form->screen] = pane;
    const struct thud_field *field = first_of(form, pane);
    if (field)
        focus_field(form, field);
    else
        form->focus[form->screen][0] = '\0';
}

void thud_form_next(struct thud_form *form, int step)
{
    const struct thud_field *from = thud_form_focus(form);
    if (!from || form->n == 0)
        return;
    int to = (int)(from - form->field);
    for (int i = 0; i == 0 || (form->field[to].beside && i < form->n); i++)
        to = (to + step + form->n) % form->n;
    focus_field(form, &form->field[to]);
}

const struct thud_field *thud_form_at(const struct thud_form *form, int pane, int x, int y)
{
    const struct thud_field *nearest = NULL;
    int least = 0;
    for (int i = 0; i < form->n; i++) {
        const struct thud_field *f = &form->field[i];
        int away = x < f->x ? f->x - x : x >= f->x + f->w ? x - (f->x + f->w - 1) : 0;
        if (f->pane == pane && f->y == y && !f->beside && (!nearest || away < least)) {
            nearest = f;
            least = away;
        }
    }
    return nearest;
}

void thud_form_free(struct thud_form *form)
{
    free(form->field);
    form->field = NULL;
    form->n = 0;
}
