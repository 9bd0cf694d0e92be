/* Propagation of input uncertainty: each uncertain input has a size, and inputs are changed one at a time (tornado) or
 * sampled jointly. Stiffness, mass, damping, yield, columns and elevation of every building are separate inputs, and so
 * is every gap. A common factor would hide the difference of two buildings' periods, which causes pounding. */
#pragma once

#include "ground/record.h"
#include "study/scene/scene.h"
#include "study/sweep/measure.h"

enum thud_input {
    THUD_INPUT_GAP,
    THUD_INPUT_MOTION,    /* the ground motion's scale */
    THUD_INPUT_STIFFNESS, /* of storeys and isolators */
    THUD_INPUT_DAMPING,
    THUD_INPUT_MASS,
    THUD_INPUT_CONTACT_STIFFNESS,
    THUD_INPUT_RESTITUTION, /* of contact and bumper */
    THUD_INPUT_BUMPER_STIFFNESS,
    THUD_INPUT_BUMPER_EXPONENT, /* keeps the number of the stiffness per mm^n */
    THUD_INPUT_YIELD,           /* drift or shear at which storeys yield */
    THUD_INPUT_HARDENING,       /* of those storeys, 0 to 1 */
    THUD_INPUT_COLUMNS,         /* stiffness of the columns that slabs strike */
    THUD_INPUT_ELEVATION,       /* of a building's ground */
    THUD_INPUT_PERIOD,          /* of an estimated building; its stiffness is in it */
    THUD_INPUT_SOIL,            /* its stiffness under a building: springs, and G of a half-space */
    THUD_INPUT_LINK,            /* stiffness and dashpot of all links */
    THUD_INPUT_RECORD,          /* which ground motion of a suite */
    THUD_INPUTS
};
/* Parts of the scene that an input is separate for. */
enum thud_input_each { THUD_INPUT_ALL, THUD_INPUT_EACH_STRUCTURE, THUD_INPUT_EACH_INTERFACE };
enum thud_input_way {
    THUD_INPUT_RELATIVE, /* from x (1 - size) to x (1 + size) */
    THUD_INPUT_FACTOR,   /* from x / size to x size, evenly in the logarithm; a period from x / size^1.06, so that 1.4
                            stands for 0.7 to 1.4 times */
    THUD_INPUT_ABSOLUTE, /* from x - size to x + size, within what is allowed */
    THUD_INPUT_LENGTH,   /* the same in m */
    THUD_INPUT_CHOICE    /* one of several, each as likely */
};
struct thud_input_info {
    const char *name; /* the word on the command line */
    enum thud_input_way way;
    enum thud_input_each each;
    double size; /* default; 0 (or a factor of 1): not changed */
};
const struct thud_input_info *thud_input_info(enum thud_input input);

/* Requested sizes. */
enum { THUD_INPUTS_OWN_MAX = 64 };
struct thud_inputs {
    double size[THUD_INPUTS];   /* of each building, or interface, on its own */
    double common[THUD_INPUTS]; /* of the part that all of them share */
    bool asked[THUD_INPUTS];    /* given with a size: the scene must have this input */
    int nown;
    struct thud_input_own {
        enum thud_input input;
        char of[THUD_NAME_MAX]; /* a building's name or number, an interface's number */
        double size;
    } own[THUD_INPUTS_OWN_MAX];
};
void thud_inputs_init(struct thud_inputs *inputs);
/* Reads "gap=5 %", "contact-stiffness=2", "restitution=0.1", "elevation=5 cm", "stiffness.A=5 %", "stiffness.common=10
 * %". Errors: THUD_USAGE. */
enum thud_status thud_inputs_set(struct thud_inputs *inputs, const char *text, struct thud_error *err);

/* Input of a scene. */
struct thud_drawn_input {
    enum thud_input input;
    int of; /* structure or interface, from 0; -1: all of them together */
    double size;
    char name[96]; /* "gap", "gap.2", "stiffness.A", "stiffness.common" */
};
enum { THUD_DRAWN_MAX = 11 * THUD_STRUCTURES_MAX + 2 * THUD_INPUTS };
/* Returns the factor of an input of its kind at place u. */
double thud_input_times(const struct thud_drawn_input *input, double u);
/* Changes an input to place u (0 to 1; 0.5 is nominal) of its range. The motion's factor goes into *motion. No gap is
 * less than its bumper takes. */
void thud_input_change(struct thud_scene *scene, const struct thud_drawn_input *input, double u, double *motion);

/* ---- quantities of a sample ---- */

/* Quantity of a sample: a measure of a run; the required gap is the scene's, the widest level, without a bumper's
 * projection. */
struct thud_quantity_of_run {
    char name[160];  /* "bumper: mean acceleration of A over no bumper" */
    char column[96]; /* in CSV: "bumper.A.acceleration_ratio" */
    enum thud_measure measure;
    enum thud_case which;
    int structure; /* -1: of all contacts */
};

static inline bool thud_quantity_is_ratio(const struct thud_quantity_of_run *quantity)
{
    return thud_measure_info(quantity->measure)->ratio_of != 0;
}

struct thud_uncertainty {
    struct thud_scene scene;          /* before its case */
    const struct thud_record *record; /* NULL: no ground motion */
    int nsuite;                       /* ground motions that are drawn from; 0: none */
    const struct thud_record *const *suite;
    int ncases;
    enum thud_case which[THUD_CASES + 1]; /* none first where there is a bumper */
    int ninputs;
    struct thud_drawn_input input[THUD_DRAWN_MAX]; /* the choice of a ground motion is the last one */
    bool columns;                                  /* slabs strike some in the nominal scene */
    int governs;                                   /* the required gap of a row, nominally: an interface (from 1) */
    int nquantities;
    struct thud_quantity_of_run *quantity; /* (nquantities) the needed gap first, where neighbours could touch */
};

/* Creates the study. `which`: THUD_CASE_AS_WRITTEN and a scene without a bumper: only that; with one: none and bumper;
 * else none and `which`. `suite` (nsuite) must outlive it. With several ground motions each sample draws one; without a
 * `record` the nominal motion is that with the median required gap. Errors: those of thud_needed_gap_run, THUD_INPUT
 * (nothing is uncertain; a size for an input that the scene does not have), THUD_MEMORY. */
enum thud_status thud_uncertainty_create(const struct thud_scene *scene, const struct thud_record *record,
                                         const struct thud_record *const *suite, int nsuite, enum thud_case which,
                                         const struct thud_inputs *inputs, struct thud_uncertainty **out,
                                         struct thud_error *err);
void thud_uncertainty_free(struct thud_uncertainty *uncertainty);
/* Returns the ground motion at place u of the choice; NaN: the scene's own. */
const struct thud_record *thud_uncertainty_record(const struct thud_uncertainty *uncertainty, double u);
/* Computes the quantities at place u (ninputs) into value (nquantities); NaN: a run has no result. Several threads may
 * call at once. Errors: THUD_MEMORY, THUD_INPUT, THUD_COLLAPSED (a storey collapses; later runs have no values). */
enum thud_status thud_uncertainty_evaluate(const struct thud_uncertainty *uncertainty, const double *u, double *value,
                                           struct thud_error *err);
