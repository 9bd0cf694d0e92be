/* What a run shows to those that read it before it commits: a segment up to where it is taken, or a block of free
 * vibration. An observer has its own state and changes nothing else, so that one may be left out or added (the run
 * holds a list) without touching the motion. */
#ifndef THUD_CORE_OBSERVER_H
#define THUD_CORE_OBSERVER_H

#include "core/contact/segment.h"

struct thud_free_vibration;

/* A segment, read up to s. */
struct thud_observation {
    const struct thud_state *state; /* at its start */
    const struct thud_segment *seg; /* the indentations of its contacts have been read */
    double s;
    const double *q, *qd; /* (nmodes) modal state at s */
    bool switches;        /* a contact will, or may, switch there */
};

struct thud_observer {
    /* Errors: THUD_MEMORY. */
    enum thud_status (*segment)(void *own, const struct thud_observation *o, struct thud_error *err);
    /* The first `intervals` intervals of a block of free vibration that begins at the state. Errors: THUD_MEMORY. */
    enum thud_status (*block)(void *own, const struct thud_state *state, struct thud_free_vibration *block,
                              int intervals, struct thud_error *err);
};

#endif
