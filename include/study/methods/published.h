/* Published values: scenes whose results are in textbooks, in other programs' manuals and in a public experiment,
 * recomputed. The values were read from print and are rounded there, so agreement can be shown to half a percent. */
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
    bool check; /* not a published value: an identity, a recovered input, or another program's result */
    bool holds;
};
enum { THUD_PUBLISHED_ROWS_MAX = 12 };

/* Recomputes the published values. `scene` and `record` of the preset, NULL: none. Errors: THUD_INPUT (the scene lacks
 * the buildings of the rows), THUD_MEMORY, those of a run. */
enum thud_status thud_published_compute(enum thud_published which, const struct thud_scene *scene,
                                        const struct thud_record *record, struct thud_published_row *row, int *n,
                                        struct thud_error *err);
