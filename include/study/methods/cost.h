/* What a run costs as its scene grows along one axis: storeys, buildings in a row, length of the ground motion,
 * impacts. The study makes the scenes and judges the runs by their work; whoever owns a clock times them. */
#pragma once

#include "study/scene/solution.h"

enum thud_cost_axis {
    THUD_COST_STOREYS,   /* of each of two shear buildings, the right one less stiff */
    THUD_COST_BUILDINGS, /* the scene's over and over again, in a row */
    THUD_COST_DURATION,  /* the ground motion over and over again */
    THUD_COST_IMPACTS,   /* by ever smaller clearances */
    THUD_COST_AXES
};

struct thud_cost_axis_info {
    const char *name;   /* the word on the command line */
    const char *label;  /* of the size, with its unit where it has one */
    const char *unit;   /* may be empty */
    const char *reason; /* why the cost grows as it does */
};
const struct thud_cost_axis_info *thud_cost_axis_info(enum thud_cost_axis axis);
/* Errors: THUD_USAGE, naming the axes there are. */
enum thud_status thud_cost_axis_find(const char *name, enum thud_cost_axis *out, struct thud_error *err);

enum thud_cost_state { THUD_COST_WAITING, THUD_COST_DONE, THUD_COST_FAILED, THUD_COST_SKIPPED };

struct thud_cost_point {
    double size; /* along the axis; of impacts known once it has run */
    enum thud_cost_state state;
    int floors, contacts, impacts;
    double clearance_m; /* of the first interface */
    struct thud_work work;
    double seconds,
        spread;     /* of a run: median and half the range of the middle half, of processor time; by who times */
    double setup_s; /* of its model (modes, contacts) */
    int repeats;
    char message[192]; /* why it failed or was skipped */
};

struct thud_cost;

/* The scene's own method and tolerance are used. Scene (that of a case) and record stay the caller's. Errors:
 * THUD_INPUT (the scene has nothing that can grow this way), THUD_MEMORY. */
enum thud_status thud_cost_create(const struct thud_scene *scene, const struct thud_record *record,
                                  enum thud_cost_axis axis, struct thud_cost **out, struct thud_error *err);
void thud_cost_free(struct thud_cost *cost);
enum thud_cost_axis thud_cost_axis(const struct thud_cost *cost);
int thud_cost_count(const struct thud_cost *cost);
struct thud_cost_point *thud_cost_point(struct thud_cost *cost, int i);

/* A point's scene as a model, its run, and what came of it. Model and run are the caller's; the model must outlive the
 * run. Errors: those of thud_scene_assemble and thud_run_create. */
enum thud_status thud_cost_setup(struct thud_cost *cost, int i, struct thud_model **out, struct thud_error *err);
enum thud_status thud_cost_start(struct thud_cost *cost, int i, const struct thud_model *model, struct thud_run **out,
                                 struct thud_error *err);
void thud_cost_judge(struct thud_cost *cost, int i, const struct thud_run *run, enum thud_status status,
                     const struct thud_error *failure);

/* Least squares over the points that are done. `power`: y = a size^b over the upper half of the sizes (where the
 * smallest ones' fixed cost has faded); else y = a + b size over all. */
struct thud_cost_fit {
    bool power;
    double a, b;
    double from; /* least size used */
    int points;  /* fewer than 2: no fit */
};
enum thud_cost_quantity { THUD_COST_TIME, THUD_COST_SETUP, THUD_COST_STEPS, THUD_COST_FORCES, THUD_COST_QUANTITIES };
double thud_cost_value(const struct thud_cost_point *point, enum thud_cost_quantity quantity);
struct thud_cost_fit thud_cost_fit(const struct thud_cost *cost, enum thud_cost_quantity quantity);
