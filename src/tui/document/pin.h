/* The state that the present one is compared with: at first the saved one, else that which was pinned. Its three cases
 * are run once the scene differs from it, after those of the scene itself. */
#pragma once

#include "app/run/live_cases.h"
#include "tui/document/doc.h"

struct thud_pin {
    bool own; /* it was pinned; else it is the saved state */
    struct thud_scene scene;
    struct thud_record *record; /* its own copy; NULL: none */
    struct thud_live live;
    unsigned long number; /* counts the states taken */
    bool begun;           /* `live` was run, or is */
};

/* The present state of a document is the one to compare with. Without memory there is none. */
void thud_pin_take(struct thud_pin *pin, struct thud_doc *doc, bool own);
/* Whether the scene differs from it in what a run depends on. */
bool thud_pin_differs(const struct thud_pin *pin, const struct thud_doc *doc);
/* Goes on for a short while where the scene differs; false when there is no more to do. */
bool thud_pin_advance(struct thud_pin *pin, const struct thud_doc *doc, enum thud_live_history history);
bool thud_pin_busy(const struct thud_pin *pin, const struct thud_doc *doc, enum thud_live_history history);
/* Its cases where the scene differs and they are there; NULL: there is nothing to compare with. */
const struct thud_live *thud_pin_live(const struct thud_pin *pin, const struct thud_doc *doc);
void thud_pin_clear(struct thud_pin *pin);
