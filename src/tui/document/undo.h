/* Undo and redo without limit. A step keeps only the words of the scene that changed, before and after. */
#pragma once

#include "study/scene/scene.h"

struct thud_undo_step;
struct thud_undo {
    struct thud_undo_step *step; /* (count) */
    int count, capacity;
    int at; /* steps before it are done, those from it on were undone */
};

/* Notes the way from `before` to `after` and forgets what had been undone; `what` says it ("gap 10 cm -> 5 cm").
 * Nothing is noted where nothing changed. Errors: THUD_MEMORY (nothing is noted then). */
enum thud_status thud_undo_note(struct thud_undo *undo, const struct thud_scene *before, const struct thud_scene *after,
                                const char *what, struct thud_error *err);
/* Takes one step back or forward in `scene` and returns what it was; NULL when there is none. */
const char *thud_undo_back(struct thud_undo *undo, struct thud_scene *scene);
const char *thud_undo_forward(struct thud_undo *undo, struct thud_scene *scene);
/* What step number `index` from the last one back was (0: the last); NULL when there is none. */
const char *thud_undo_what(const struct thud_undo *undo, int index);
void thud_undo_clear(struct thud_undo *undo);
