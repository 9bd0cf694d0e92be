/* What a person describes: a plain value (copy, compare and undo with `=`; fully zeroed by thud_scene_init so that
 * memcmp compares). SI units. Lists run from the lowest floor up. */
#ifndef THUD_STUDY_SCENE_H
#define THUD_STUDY_SCENE_H

#include <stdbool.h>

#include "base/param.h"
#include "base/status.h"
#include "core/law.h"

enum { THUD_STOREYS_MAX = 200, THUD_STRUCTURES_MAX = 20, THUD_TEXT_MAX = 256, THUD_NAME_MAX = 64 };

enum thud_structure_kind { THUD_SHEAR, THUD_RIGID, THUD_ISOLATED, THUD_WALL };

struct thud_structure {
    char name[THUD_NAME_MAX];
    enum thud_structure_kind kind;
    int storeys; /* rigid: 1, wall: 0 */
    double mass_kg[THUD_STOREYS_MAX];
    double stiffness_npm[THUD_STOREYS_MAX];
    double height_m[THUD_STOREYS_MAX]; /* storey heights; rigid: [0] its elevation; wall: [0] its top, INFINITY when not
                                          given */
    double damping;                    /* ratio, the same in every mode */
    double base_mass_kg, isolation_stiffness_npm, isolation_damping; /* isolated only */
    double velocity_mps;                                             /* rigid only: at t = 0, to the right */
};

/* A law with its parameters in the order of law->params. NaN: not given. */
struct thud_law_choice {
    const struct thud_law *law;
    double value[THUD_LAW_PARAMS_MAX];
};

struct thud_interface {
    double gap_m; /* concrete to concrete */
    struct thud_law_choice contact;
    bool has_bumper;
    struct thud_law_choice bumper;
    double bumper_thickness_m, bumper_cavity_m;
};

struct thud_record_choice {
    char file[THUD_TEXT_MAX]; /* empty: no ground motion */
    double peak_mps2;         /* scale to this peak; NaN: as recorded */
    double factor;            /* 1 unless given */
    int sign;                 /* +1 or -1 */
    double dt_s;              /* for files that do not say; NaN: not given */
    char unit[16];            /* for files that do not say; empty: not given */
    char channel[32];         /* file with several; empty: not given */
    int column;               /* from 1; 0: not given; -1 (`all`): the values of every line one after another */
    int skip;                 /* lines; -1: not given */
};

struct thud_analysis {
    char method[32]; /* "auto" */
    double tolerance;
    double step_s; /* NaN: not given */
    double tail_s; /* free vibration after the record; without a record: the duration */
    bool locate;   /* fixed-step methods: locate events */
};

enum thud_case { THUD_CASE_AS_WRITTEN = -1, THUD_CASE_NONE, THUD_CASE_BUMPER, THUD_CASE_CAVITY, THUD_CASES };

/* A study: up to THUD_VARY_MAX keys over ranges or lists, cases and records (the records themselves on the command
 * line). */
enum { THUD_VARY_MAX = 4 };
struct thud_vary {
    char key[96];
    double from, to, step; /* SI */
};
struct thud_study_choice {
    int nvary;
    struct thud_vary vary[THUD_VARY_MAX];
    int ncases;
    enum thud_case cases[THUD_CASES];
};

struct thud_scene {
    char name[THUD_NAME_MAX]; /* the preset's name, from its file name */
    char title[THUD_TEXT_MAX];
    struct thud_record_choice record;
    int nstructures;
    struct thud_structure structure[THUD_STRUCTURES_MAX];
    struct thud_interface interface[THUD_STRUCTURES_MAX - 1]; /* nstructures - 1 in use */
    struct thud_analysis analysis;
    struct thud_study_choice study;
};

/* An empty scene with defaults. */
void thud_scene_init(struct thud_scene *scene);

/* Sets one value by its path (`structures.1.mass`, `interfaces.1.gap`, `gap`, `contact.restitution`,
 * `bumper.thickness`, `analysis.tolerance`, `record.peak`; lists `[320 t, 250 t]` or one value for every floor; one
 * floor by `structures.1.mass.2`). Errors: THUD_INPUT with key and what is allowed. */
enum thud_status thud_scene_set(struct thud_scene *scene, const char *path, const char *text, struct thud_error *err);
/* The value as text in its shown unit. */
enum thud_status thud_scene_get(const struct thud_scene *scene, const char *path, char *text, unsigned long size,
                                struct thud_error *err);
/* The described parameter behind a path, its index among the floors in *floor (-1: all); NULL when unknown. */
const struct thud_param *thud_scene_param(const struct thud_scene *scene, const char *path, int *floor);

/* Checks values against each other (thickness - cavity <= gap, lists as long as the storeys, ...). Errors: THUD_INPUT
 * with key. */
enum thud_status thud_scene_check(const struct thud_scene *scene, struct thud_error *err);

/* The scene of a case: `none` drops every bumper, `bumper` sets it flush, `cavity` thickness (1 - max-strain) deep.
 * THUD_INPUT when a case needs a bumper and there is none. */
enum thud_status thud_scene_case(const struct thud_scene *scene, enum thud_case which, struct thud_scene *out,
                                 struct thud_error *err);
const char *thud_case_name(enum thud_case which); /* "none", "bumper", "cavity", "as-written" */

/* gap - (thickness - cavity) with a bumper, gap without. */
double thud_interface_clearance(const struct thud_interface *interface);

#endif
