/* Elements of a scene and their properties. Shared runs, scaling, early termination, factors of first contact and
 * required gaps use only this table to decide whether they are valid for a scene. THUD_ELEMENT_LIST has a line for each
 * kind; an incomplete line does not compile. */
#pragma once

/* Properties that a kind of element breaks; 0: linear, of degree one, two-sided, without memory. */
enum thud_trait {
    THUD_NONLINEAR = 1,      /* two motions do not add up */
    THUD_NOT_DEGREE_ONE = 2, /* twice the ground motion is not twice the response */
    THUD_ONE_SIDED = 4,      /* acts in one direction only: a contact locates its beginning and end */
    THUD_SLIPS = 8,          /* yields or slides: the difference of two motions is not a free vibration */
    THUD_REMEMBERS = 16,     /* has states in addition to displacements and velocities */
    THUD_UNKEPT = 32,        /* a checkpoint of the baseline (core/run/baseline.h) does not store these states */
    THUD_COLLAPSES = 64,     /* may end a run */
    THUD_UNKNOWN = 127
};

/* X(NAME, word, traits, degrees of freedom, states). Floor contacts give theirs by the flags of their law. */
#define THUD_HYSTERETIC     (THUD_NONLINEAR | THUD_NOT_DEGREE_ONE | THUD_SLIPS | THUD_REMEMBERS)
#define THUD_BEYOND_A_SLACK (THUD_NONLINEAR | THUD_NOT_DEGREE_ONE | THUD_ONE_SIDED)
#define THUD_ELEMENT_LIST(X)                                                                                           \
    X(STOREY, "storey", 0, 1, 0)                                                                                       \
    X(YIELDING_STOREY, "storey that yields", THUD_HYSTERETIC, 1, 1)                                                    \
    X(FLOOR, "floor of a building by matrix or modes", 0, 1, 0)                                                        \
    X(BODY, "rigid body", 0, 1, 0)                                                                                     \
    X(MOVING_BODY, "rigid body that moves at first", THUD_NOT_DEGREE_ONE, 1, 0)                                        \
    X(WALL, "wall", 0, 0, 0)                                                                                           \
    X(GIVING_WALL, "flexible wall", 0, 1, 0)                                                                           \
    X(BACKFILL, "backfill", THUD_BEYOND_A_SLACK | THUD_REMEMBERS, 0, 0)                                                \
    X(ISOLATOR, "linear isolators", 0, 1, 0)                                                                           \
    X(LEAD_RUBBER, "lead-rubber isolators", THUD_HYSTERETIC, 1, 1)                                                     \
    X(PENDULUM, "pendulum isolators", THUD_HYSTERETIC, 1, 1)                                                           \
    X(SOIL, "soil", 0, 2, 0)                                                                                           \
    X(P_DELTA, "P-Delta", THUD_COLLAPSES, 0, 0)                                                                        \
    X(SPRING, "spring", 0, 0, 0)                                                                                       \
    X(DASHPOT, "dashpot", 0, 0, 0)                                                                                     \
    X(FRICTION, "friction", THUD_HYSTERETIC, 0, 1)                                                                     \
    X(RESTRAINER, "restrainer", THUD_BEYOND_A_SLACK, 0, 0)                                                             \
    X(STRUT, "strut", THUD_BEYOND_A_SLACK, 0, 0)

enum thud_element {
#define THUD_ELEMENT(NAME, word, traits, dofs, states) THUD_ELEMENT_##NAME,
    THUD_ELEMENT_LIST(THUD_ELEMENT) THUD_ELEMENTS
#undef THUD_ELEMENT
};

struct thud_element_kind {
    const char *name;
    unsigned traits; /* of enum thud_trait */
    int dofs;        /* that one of them adds, and states in addition to displacements and velocities */
    int states;
};
/* (THUD_ELEMENTS). It has a file of its own, so a test may define another table. */
extern const struct thud_element_kind thud_elements[];

/* Sum of several elements: traits of any, numbers of all. */
struct thud_element_sum {
    unsigned traits;
    int dofs, states;
};
static inline void thud_element_add(struct thud_element_sum *sum, enum thud_element element, int count)
{
    const struct thud_element_kind *kind = &thud_elements[element];
    sum->traits |= count > 0 ? kind->traits : 0;
    sum->dofs += count * kind->dofs;
    sum->states += count * kind->states;
}
