/* The designs of a session: every scene that was run, with what came of it, until newer ones take its place; those with
 * a name or a mark stay. */
#pragma once

#include "study/scene/scene.h"

struct thud_live;

/* Of the scene as it is written, but where it says without and with: bumper and links. NaN: not known. */
struct thud_design_result {
    bool known;
    double need_m[THUD_STRUCTURES_MAX], force_n[THUD_STRUCTURES_MAX]; /* by interface, from 0 */
    double with_bumper_m[THUD_STRUCTURES_MAX];                        /* the gap needed with the bumper in it */
    int impacts[THUD_STRUCTURES_MAX];
    double acceleration_mps2[2], drift_m[2]; /* largest of all floors, without and with */
};

enum { THUD_DESIGNS_MAX = 32 };
struct thud_design {
    struct thud_scene *scene;
    int number;                              /* as in "#3"; stays while others are forgotten */
    char name[40];                           /* empty: none was given */
    char what[64];                           /* the change that led to it; empty: none did */
    bool marked;                             /* goes into the report */
    struct thud_design_result result, suite; /* the second: the largest over the study's ground motions */
};
struct thud_designs {
    struct thud_design item[THUD_DESIGNS_MAX]; /* (n) as they came */
    int n, last;                               /* the last number given */
};

/* What the live cases of a scene found. */
void thud_design_measure(const struct thud_scene *scene, const struct thud_live *live, struct thud_design_result *out);
/* Its name, or "#3". */
const char *thud_design_called(const struct thud_design *design, char text[40]);
/* "gap 8 cm, bumper off": what it has other than another scene; empty: nothing. */
void thud_design_differences(const struct thud_scene *scene, const struct thud_scene *other, char *text, size_t size);

/* By its name, or by its number as "#3"; NULL: there is none. */
struct thud_design *thud_designs_named(struct thud_designs *designs, const char *name);
/* Keeps a scene, with its result (NULL: none yet). Returns NULL without memory, or where all have names or marks. */
struct thud_design *thud_designs_note(struct thud_designs *designs, const struct thud_scene *scene, const char *what,
                                      const struct thud_design_result *result);
void thud_designs_forget(struct thud_designs *designs, struct thud_design *design);
void thud_designs_clear(struct thud_designs *designs);
