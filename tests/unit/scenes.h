/* Random scenes, and ways to run one that must not change its result. A seed gives the same scene everywhere. */
#pragma once

#include "study/scene/solution.h"

/* A scene with its ground motion (NULL: none); `peak_m`: the size of its motion without contact. */
struct scenes_one {
    unsigned long long seed;
    struct thud_scene scene;
    struct thud_record *record;
    double peak_m;
};

/* From this seed on, scenes are wide: floors of 1e-3 kg to 1e9 kg, also in one building, damping from 0 to 1, rigid bodies
 * with initial speeds, and more walls and isolated buildings. */
#define SCENES_WIDE 1000000000ull
/* From this seed on, scenes are like the first ones, and storeys of their buildings yield. */
#define SCENES_YIELDING 2000000000ull
/* From this seed on, floors of neighbours stand at different elevations, and columns give; in every third scene storeys
 * yield too. */
#define SCENES_COLUMNS 3000000000ull
/* From this seed on, the weight on drifting storeys counts; in every other scene storeys yield too. */
#define SCENES_P_DELTA 4000000000ull
/* From this seed on, links of all laws tie neighbours; in every third scene storeys yield, in every fourth slabs strike
 * columns. */
#define SCENES_LINKS 5000000000ull
/* From this seed on, isolated buildings stand on lead-rubber bearings or pendulums. */
#define SCENES_ISOLATORS 7000000000ull

/* From this seed on, scenes are like those of columns, and shear buildings are given by their matrix, with floors that
 * other floors than their neighbours hold too, or by their modes. */
#define SCENES_MATRICES 6000000000ull

/* From this seed on, buildings stand on soil; in every third scene some are by their matrix or modes, in every third
 * storeys yield, in every other the weight counts, in most slabs strike columns. */
#define SCENES_SOIL 8000000000ull
/* From this seed on, all of it together: isolators, walls that give with soil behind them, links of all laws, storeys that
 * yield, the weight on drifting storeys, buildings on soil, slabs against columns; a seed's remainders choose what of it. */
#define SCENES_MIXED 9000000000ull

/* This and any of those seeds: a like scene of neighbours most of which are equal and touch. */
#define SCENES_EQUAL 10000000000ull
/* This and any of those seeds: a like scene whose samples are 0.08 s to 0.6 s apart, with stiffer buildings and softer
 * contacts, which last for up to seconds. */
#define SCENES_COARSE 100000000000ull

/* Valid by thud_scene_check. Free the record with scenes_clear. */
void scenes_draw(struct scenes_one *one, unsigned long long seed);
void scenes_clear(struct scenes_one *one);
/* A copy with a record of its own. */
void scenes_copy(struct scenes_one *to, const struct scenes_one *from);
/* One line. */
void scenes_describe(const struct scenes_one *one, char *text, size_t size);

/* The row and the motion reversed. */
void scenes_mirror(struct scenes_one *one);
/* Every interval of the record in so many, on the line between its samples. */
void scenes_resample(struct scenes_one *one, int parts);
/* `zeros` samples of nothing after the record, in place of as much of the tail; fewer where that is too short. */
void scenes_pad(struct scenes_one *one, int zeros);
/* Every mass, stiffness and dashpot times a power of two, which changes no bit of the motion; false where a law's
 * damping depends on the mass. */
bool scenes_heavier(struct scenes_one *one, double factor);
/* Lengths, speeds and accelerations times a factor, stiffnesses so that the forces go with it; false where a law has a
 * speed or a length of its own. */
bool scenes_longer(struct scenes_one *one, double factor);
/* Gaps and stiffnesses a little different: the gaps by eps times the size of the motion. Four ways. */
enum { SCENES_NUDGES = 4 };
void scenes_nudge(struct scenes_one *one, int way, double eps);

/* A run as numbers that two runs may be compared by. */
enum scenes_kind {
    SCENES_ACCELERATION,
    SCENES_DISPLACEMENT,
    SCENES_VELOCITY,
    SCENES_DRIFT,
    SCENES_PLASTIC, /* size of the plastic drift, of storeys that yield */
    SCENES_SHEAR,
    SCENES_FORCE,
    SCENES_INDENTATION,
    SCENES_IMPULSE,
    SCENES_LOST,
    SCENES_FIRST, /* time of the first impact, s */
    SCENES_TIME,  /* in contact, s */
    SCENES_IMPACTS,
    SCENES_COLUMN_SHEAR,
    SCENES_COLUMN_MOMENT,
    SCENES_LINK_FORCE,
    SCENES_LINK_STROKE,
    SCENES_LINK_LOST,
    SCENES_KINDS
};
struct scenes_number {
    enum scenes_kind kind;
    int place; /* structure or interface, from 0 */
    int index; /* floor or contact, from 0 */
    double value;
};
struct scenes_solution {
    enum thud_status status;
    struct thud_error err;
    bool stopped; /* more segments than asked for */
    int n;
    struct scenes_number *number; /* (n) */
    double largest[SCENES_KINDS], natural[SCENES_KINDS];
    double error_ratio; /* of the energies */
    long steps;
};
struct scenes_options {
    const char *method; /* NULL: exact */
    double tolerance;
    double step_s;
    bool unlocated, history;
    long slice; /* segments at a time; 0: 1000 */
    long most;  /* segments; 0: no end */
};
void scenes_run(const struct scenes_one *one, const struct scenes_options *options, struct scenes_solution *out);
void scenes_answer_clear(struct scenes_solution *solution);
const char *scenes_kind_name(enum scenes_kind kind);

/* Where two results are most unlike: |a - b| over the number's own size, but no less than `least` of the largest of its
 * kind, less what `amplify` (per number; NULL: 0) times `eps` explains. Returns the difference; *where the number. */
double scenes_apart(const struct scenes_solution *a, const struct scenes_solution *b, double least,
                    const double *amplify, double eps, int *where);
/* The result of a mirrored scene in the order of the scene itself. */
void scenes_unmirror(const struct scenes_one *one, struct scenes_solution *solution);
