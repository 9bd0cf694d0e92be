/* What a run shows to those that read it: a segment before it is committed, up to where it is taken, or a block of free
 * vibration; contacts that have switched; and what it leaves out. An observer has its own state and changes nothing
 * else, and nothing that moves reads what it has found: one may be left out or added (the run holds a list) without
 * touching the motion. Each function may be NULL. */
#pragma once

#include "core/contact/event.h"
#include "core/contact/segment.h"
#include "core/numerics/poly.h"

struct thud_free_vibration;
struct thud_rest;

struct thud_contact_work {
    int contact;
    double work_j, impulse_ns;
};

/* A segment, read up to s. */
struct thud_observation {
    const struct thud_state *state; /* at its start */
    const struct thud_segment *seg;
    double s;
    const double *q, *qd;                 /* (nmodes) modal state at s */
    bool switches;                        /* a contact will, or may, switch there */
    const struct thud_contact_work *work; /* (works) of the contacts with a force */
    int works;
};

/* What the segment may be asked, at 0 <= s <= o->s, whatever the method: the ground's acceleration; the modal state, q and qd
 * (nmodes); the forces of all rows, force (nrows); and from these three at that s the modal total accelerations, out
 * (nmodes), whose floor values are thud_model_floor's. Nothing else of a segment is there for every method. The power
 * series of `exact` have all of it in seg->q and seg->force. The polynomials of a stepping method (seg->interpolates)
 * have its state, but their second derivative is no acceleration between the ends of the step: that is by the forces.
 * Of steps whose events are not located (seg->end) there may be no polynomials at all (seg->terms 0), and then these
 * give the nearest of their ends. */
static inline double thud_observation_ground(const struct thud_observation *o, double s)
{
    return o->seg->a0 + o->seg->a1 * s;
}
void thud_observation_state(const struct thud_observation *o, double s, double *q, double *qd);
void thud_observation_forces(const struct thud_observation *o, double s, double *force);
void thud_observation_acceleration(const struct thud_observation *o, double s, const double *q, const double *qd,
                                   const double *force, double *out);

struct thud_observer {
    /* Errors: THUD_MEMORY. */
    enum thud_status (*segment)(void *own, const struct thud_observation *o, struct thud_error *err);
    /* The first `intervals` intervals of a block of free vibration that begins at the state. NULL: the intervals are
     * shown as segments. Errors: THUD_MEMORY. */
    enum thud_status (*block)(void *own, const struct thud_state *state, struct thud_free_vibration *block,
                              int intervals, struct thud_error *err);
    /* At the state, row (a contact, or behind them a storey that yields) has switched by this event; row -1: where events
     * are not located, any of them. */
    void (*switched)(void *own, const struct thud_state *state, int row, enum thud_event event);
    /* Whether the rest of the motion may be left out: no contact closes in it, and its values have these bounds. NULL: it
     * may not. */
    bool (*may_jump)(const void *own, const struct thud_rest *rest);
    /* It is left out, from this state on. */
    void (*jumped)(void *own, const struct thud_state *state);
};

/* may_jump of an observer that has nothing to find in the rest. */
bool thud_observer_jumps(const void *own, const struct thud_rest *rest);

/* The peak of a floor's quantity, THUD_FLOOR_DISPLACEMENT to THUD_FLOOR_DRIFT. */
static inline struct thud_peak *thud_floor_peak(struct thud_result *result, int structure, int floor, int quantity)
{
    struct thud_floor_result *r = &result->structure[structure].floor[floor];
    switch (quantity) {
    case 0:
        return &r->displacement;
    case 1:
        return &r->velocity;
    case 2:
        return &r->acceleration;
    default:
        return &r->drift;
    }
}

/* Raises a peak by a polynomial of the segment up to s, p (terms). */
static inline void thud_peak_raise(struct thud_peak *peak, const struct thud_segment *seg, const double *p, int terms,
                                   double s)
{
    double where, value = thud_poly_peak(p, terms, s, peak->value, &where);
    if (value > peak->value)
        *peak = (struct thud_peak){value, seg->start_s + where * seg->h_s};
}
