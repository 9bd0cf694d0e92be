/* The state that the present one is compared with: the one before the last change, or the design that was chosen. Its
 * three cases are run once the scene differs from it, after those of the scene itself. */
#pragma once

#include "app/run/live_cases.h"
#include "tui/document/designs.h"
#include "tui/document/doc.h"

struct thud_base {
    bool chosen;                /* it is a design; else the state before the last change */
    char name[40];              /* of that design, "before" */
    struct thud_scene scene;    /* no structures: there is none */
    struct thud_record *record; /* its own copy; NULL: none */
    struct thud_design_result result;
    struct thud_live live;
    unsigned long number; /* counts the states taken */
    bool begun;           /* `live` was run, or is */
};

/* A design with its ground motion, which is copied; NULL: none. Without memory for it nothing is compared. */
void thud_base_take(struct thud_base *base, const struct thud_design *design, const struct thud_record *record,
                    bool chosen);
/* Whether the scene differs from it in what a run depends on. */
bool thud_base_differs(const struct thud_base *base, const struct thud_doc *doc);
/* Goes on for a short while where the scene differs; false when there is no more to do. */
bool thud_base_advance(struct thud_base *base, const struct thud_doc *doc, enum thud_live_history history);
bool thud_base_busy(const struct thud_base *base, const struct thud_doc *doc, enum thud_live_history history);
/* Its cases where the scene differs and they are there; NULL: there is nothing to compare with. */
const struct thud_live *thud_base_live(const struct thud_base *base, const struct thud_doc *doc);
void thud_base_clear(struct thud_base *base);
