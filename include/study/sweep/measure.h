/* The table of measures: every number that studies report of a run, with its name, its words, how it is read from a
 * finished point, which event asks for it, and where it is reported. Suites, events, `solve`, what lowers a response and
 * uncertainty iterate over it, so a new measure is a line here, a line of the table, and its reader. */
#pragma once

#include "base/quantity.h"
#include "study/sweep/sweep.h"

/* Of a run; from the accelerations on by structure. */
enum thud_measure {
    THUD_MEASURE_GAP,          /* the required gap, which no point has: it is found from the motion without pounding */
    THUD_MEASURE_IMPACTS,      /* all contacts */
    THUD_MEASURE_USED,         /* largest relative displacement without pounding over clearance, of all levels */
    THUD_MEASURE_SHORT,        /* largest relative displacement less clearance, m */
    THUD_MEASURE_FORCE,        /* largest of all contacts, N; 0: there was no contact */
    THUD_MEASURE_INDENTATION,  /* largest of all contacts, m */
    THUD_MEASURE_SHEAR,        /* largest of the columns that slabs strike, N; NaN: none is struck */
    THUD_MEASURE_ACCELERATION, /* largest of the floors, m/s2 */
    THUD_MEASURE_DRIFT,        /* largest of the storeys, m */
    THUD_MEASURE_DRIFT_ANGLE,  /* the same over the storey's height; without the isolators' */
    THUD_MEASURE_MEAN_ACCELERATION,
    THUD_MEASURE_MEAN_DRIFT,
    THUD_MEASURE_ACCELERATION_RATIO, /* of the means, to the point's reference; NaN for 0/0 */
    THUD_MEASURE_DRIFT_RATIO,
    THUD_MEASURE_DUCTILITY, /* largest drift over yield drift of the storeys that yield; NaN: none does */
    THUD_MEASURE_PERMANENT, /* largest size of the permanent drift of those, m */
    THUD_MEASURE_ISOLATOR,  /* largest displacement of its isolators, m; NaN: it has none */
    THUD_MEASURE_COLUMNS,   /* largest shear over capacity of the columns that slabs strike; NaN: none, or not given */
    THUD_MEASURE_STRAIN,    /* largest compression of a bumper over its thickness; NaN: there is none */
    THUD_MEASURE_LINK,      /* largest force of all links, N; NaN: there are none */
    THUD_MEASURE_COLLAPSED, /* 1: the drift of a storey comes to where it collapses */
    THUD_MEASURES
};

/* Where measures are reported. */
enum thud_measure_document {
    THUD_TOLD_BY_SUITE,       /* suite.csv and its table: fractiles over the ground motions */
    THUD_TOLD_BY_LOWERED,     /* what bumper and links lower: ratios to case none */
    THUD_TOLD_BY_UNCERTAINTY, /* uncertainty.csv and what goes with it */
    THUD_TOLD_BY_SWEEP,       /* what a study keeps of a run for its figures and its table */
    THUD_MEASURE_DOCUMENTS
};

/* What a scene must have so that there is such a number. */
enum {
    THUD_HAS_YIELDING = 1,    /* storeys that may yield */
    THUD_HAS_ISOLATORS = 2,   /* a structure on isolators */
    THUD_HAS_COLUMNS = 4,     /* columns that slabs strike */
    THUD_HAS_CAPACITY = 8,    /* and a capacity of columns */
    THUD_HAS_REFERENCE = 16,  /* another run to compare with */
    THUD_HAS_LINK_FORCES = 32 /* links */
};

/* A run of a finished point. */
struct thud_measured_run {
    const struct thud_scene *scene; /* the point's, before its case */
    const struct thud_sweep_point *point;
    int k; /* its case */
};

struct thud_measure_info {
    const char *column;         /* in CSV and JSON: "force_n" */
    const char *words;          /* "largest force" */
    enum thud_dimension kind;   /* each document chooses the unit */
    bool of_structure;          /* else of the run */
    bool unknown;               /* of several the largest is not known where one is not; else that one gives way */
    unsigned needs;             /* THUD_HAS_... */
    enum thud_measure ratio_of; /* a ratio to the reference: the measure that it is of; else 0 */
    int place[THUD_MEASURE_DOCUMENTS]; /* from 1; 0: not told there */
    struct {
        const char *word;    /* of --event and --for; NULL: none */
        const char *example; /* of its limit; NULL: it takes none, but has its own */
        double limit;        /* what happens is more than this */
        bool not_monotone;   /* it need not become more likely with the intensity, or less with the gap */
    } event;
    double (*read)(const struct thud_measured_run *run, const struct thud_measure_info *info, int structure);
    size_t field; /* of a floor or contact that `read` looks at */
};

const struct thud_measure_info *thud_measure_info(enum thud_measure measure);
/* Where a measure stands among the values that a document keeps of a run of so many structures, its first one of
 * several; for THUD_MEASURES how many values that are. */
int thud_measure_place(enum thud_measure_document document, int nstructures, enum thud_measure measure);
/* Lists the measures that a document reports of what has `features`, in its order; returns how many. */
int thud_measures_told(enum thud_measure_document document, unsigned features, enum thud_measure told[THUD_MEASURES]);
/* What the scenes of a plan have, THUD_HAS_COLUMNS aside. */
unsigned thud_measure_features(const struct thud_sweep_plan *plan);

/* The larger of two values of a measure: not known where one is not, or that one gives way (`unknown`). */
double thud_measure_larger(const struct thud_measure_info *info, double a, double b);
/* Of a measure of the run `structure` counts for nothing. NaN: there is none, or it is not known. */
static inline double thud_measure_read(const struct thud_measured_run *run, enum thud_measure measure, int structure)
{
    const struct thud_measure_info *info = thud_measure_info(measure);
    return info->read(run, info, structure);
}
