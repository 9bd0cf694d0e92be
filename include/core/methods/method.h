/* Time-stepping methods. A method is one const table in its own file, with its name in src/core/methods/method_list.h.
 */
#pragma once

#include <stdbool.h>

#include "base/status.h"

struct thud_segment;
struct thud_state;

enum {
    THUD_METHOD_FIXED_STEP = 1,   /* takes a step in s; else a tolerance */
    THUD_METHOD_LOCATES = 2,      /* locates events by default */
    THUD_METHOD_CAN_LOCATE = 4,   /* event location may be turned on */
    THUD_METHOD_DEMONSTRATION = 8 /* demonstrates a fault; never selected automatically */
};

struct thud_method;

/* How methods of one family step. */
struct thud_stepper {
    /* Creates the method's own memory (may stay NULL) as part of state->memory. Errors: THUD_MEMORY. */
    enum thud_status (*create)(const struct thud_method *method, const struct thud_state *state, void **own,
                               struct thud_error *err);
    /* Proposes the next segment (src/core/contact/segment.h) from the state; the run locates events in it and commits.
     * Errors: THUD_DIVERGED (no step is short enough), THUD_MEMORY. */
    enum thud_status (*step)(const struct thud_state *state, void *own, struct thud_segment *seg,
                             struct thud_error *err);
    /* Called after a commit up to tau into the segment; `switched`: a contact changed its state. May be NULL. */
    void (*committed)(const struct thud_state *state, void *own, const struct thud_segment *seg, double tau_s,
                      bool switched);
};

struct thud_method {
    const char *name, *title;
    const char *reference; /* author, journal, volume (year) pages; several parted by "; " */
    const char *summary;   /* one line */
    unsigned flags;
    int order;          /* on smooth problems; 0: exact without contact */
    double stability;   /* largest stable omega dt of an undamped oscillator; INFINITY: no limit */
    const char *limits; /* one line in words */
    const struct thud_stepper *stepper;
    const void *scheme; /* constants that create reads: a struct thud_alpha or thud_tableau; else NULL */
};

int thud_method_count(void);
const struct thud_method *thud_method_at(int index);
const struct thud_method *thud_method_find(const char *name); /* NULL when unknown */
