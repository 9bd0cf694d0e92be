/* Numbers that others published: scenes whose results stand in textbooks, in other programs' manuals and in a public
 * experiment, computed again. What is compared was read from print and is rounded there, so that agreement to half a
 * percent is what it can show. */
#pragma once

#include "ground/record.h"
#include "study/scene/scene.h"

enum thud_published {
    THUD_PUBLISHED_CHOPRA,
    THUD_PUBLISHED_NPTEL,
    THUD_PUBLISHED_CHOPRA_YIELDING,
    THUD_PUBLISHED_NPTEL_YIELDING,
    THUD_PUBLISHED_VM65,
    THUD_PUBLISHED_TWO_OSCILLATORS,
    THUD_PUBLISHED_LANKARANI,
    THUD_PUBLISHED_CART,
    THUD_PUBLISHED_PENDULUM,
    THUD_PUBLISHED_COUNT
};

struct thud_published_info {
    const char *title, *source;
    const char *preset;       /* name of its scene in presets/published; NULL: made here */
    const char *needs_record; /* the ground motion that is not shipped, in words; NULL: nothing is missing */
};
const struct thud_published_info *thud_published_info(enum thud_published which);

struct thud_published_row {
    const char *quantity, *unit; /* unit "": a plain number */
    double published, computed;  /* in the unit */
    double difference;           /* relative; absolute where 0 is published */
    double tolerance;            /* of the difference */
    bool check; /* no published value: an identity, an input that comes back, or another program's result */
    bool holds;
};
enum { THUD_PUBLISHED_ROWS_MAX = 12 };

/* Computes what was published. `scene` and `record` of the preset, NULL where there is none. Errors: THUD_INPUT (the
 * scene lacks the buildings that the rows are about), THUD_MEMORY, those of a run. */
enum thud_status thud_published_compute(enum thud_published which, const struct thud_scene *scene,
                                        const struct thud_record *record, struct thud_published_row *row, int *n,
                                        struct thud_error *err);
