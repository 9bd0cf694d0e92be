#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tui/document/undo.h"

/* One changed word of the scene. */
struct change {
    uint32_t word;
    uint64_t before, after;
};
struct thud_undo_step {
    int nchanges;
    struct change *change; /* (nchanges) */
    char what[160];
};

enum { WORDS = sizeof(struct thud_scene) / sizeof(uint64_t) };
_Static_assert(sizeof(struct thud_scene) % sizeof(uint64_t) == 0, "a scene is made of whole words");

static uint64_t word_of(const struct thud_scene *scene, size_t word)
{
    uint64_t value;
    memcpy(&value, (const char *)scene + word * sizeof value, sizeof value);
    return value;
}

static void step_clear(struct thud_undo_step *step)
{
    free(step->change);
    step->change = NULL;
}

static int difference(const struct thud_scene *a, const struct thud_scene *b, struct change *out)
{
    int n = 0;
    for (size_t i = 0; i < WORDS; i++) {
        uint64_t before = word_of(a, i), after = word_of(b, i);
        if (before == after)
            continue;
        if (out)
            out[n] = (struct change){(uint32_t)i, before, after};
        n++;
    }
    return n;
}

static enum thud_status make_room(struct thud_undo *undo, struct thud_error *err)
{
    if (undo->at < undo->capacity)
        return THUD_OK;
    int capacity = undo->capacity ? 2 * undo->capacity : 64;
    struct thud_undo_step *step = realloc(undo->step, (size_t)capacity * sizeof *step);
    if (!step)
        return thud_error_set(err, THUD_MEMORY, "no memory to note the change");
    undo->step = step;
    undo->capacity = capacity;
    return THUD_OK;
}

enum thud_status thud_undo_note(struct thud_undo *undo, const struct thud_scene *before, const struct thud_scene *after,
                                const char *what, struct thud_error *err)
{
    int n = difference(before, after, NULL);
    if (n == 0)
        return THUD_OK;
    struct thud_undo_step step = {.nchanges = n, .change = malloc((size_t)n * sizeof *step.change)};
    if (!step.change)
        return thud_error_set(err, THUD_MEMORY, "no memory to note the change");
    if (make_room(undo, err) != THUD_OK) {
        step_clear(&step);
        return THUD_MEMORY;
    }
    difference(before, after, step.change);
    snprintf(step.what, sizeof step.what, "%s", what);
    while (undo->count > undo->at)
        step_clear(&undo->step[--undo->count]);
    undo->step[undo->at++] = step;
    undo->count = undo->at;
    return THUD_OK;
}

static void put(struct thud_scene *scene, size_t word, uint64_t value)
{
    memcpy((char *)scene + word * sizeof value, &value, sizeof value);
}

const char *thud_undo_back(struct thud_undo *undo, struct thud_scene *scene)
{
    if (undo->at == 0)
        return NULL;
    struct thud_undo_step *step = &undo->step[--undo->at];
    for (int i = 0; i < step->nchanges; i++)
        put(scene, step->change[i].word, step->change[i].before);
    return step->what;
}

const char *thud_undo_forward(struct thud_undo *undo, struct thud_scene *scene)
{
    if (undo->at == undo->count)
        return NULL;
    struct thud_undo_step *step = &undo->step[undo->at++];
    for (int i = 0; i < step->nchanges; i++)
        put(scene, step->change[i].word, step->change[i].after);
    return step->what;
}

const char *thud_undo_what(const struct thud_undo *undo, int index)
{
    return index >= 0 && index < undo->at ? undo->step[undo->at - 1 - index].what : NULL;
}

void thud_undo_clear(struct thud_undo *undo)
{
    for (int i = 0; i < undo->count; i++)
        step_clear(&undo->step[i]);
    free(undo->step);
    *undo = (struct thud_undo){0};
}
