/* Table of measures: every number that studies report of a run, with its name, words, reader from a finished point,
 * event, and places of report. Suites, events, `solve`, the list of lowered responses and uncertainty iterate over it.
 * A new measure is a line here, a line of the table, and its reader. */
#pragma once

#include "base/quantity.h"
#include "study/sweep/sweep.h"

/* Measures of a run; from the accelerations on by structure. */
enum thud_measure {
    THUD_MEASURE_GAP,          /* the required gap, which no point has: it is found from the motion without pounding */
    THUD_MEASURE_IMPACTS,      /* all contacts */
    THUD_MEASURE_USED,         /* largest relative displacement without pounding over clearance, of all levels */
    THUD_MEASURE_SHORT,        /* largest relative displacement less clearance, m */
    THUD_MEASURE_FORCE,        /* largest of all contacts, N; 0: there was no contact */
    THUD_MEASURE_INDENTATION,  /* largest of all contacts, m */
    THUD_MEASURE_SHEAR,        /* largest of the columns that slabs strike, N; NaN: none is struck */
    THUD_MEASURE_ACCELERATION, /* largest of the floors, m/s2 */
    THUD_MEASURE_DRIFT,        /* largest of the storeys, m; isolators are none, here and in what follows */
    THUD_MEASURE_DRIFT_ANGLE,  /* the same over the storey's height */
    THUD_MEASURE_MEAN_ACCELERATION,
    THUD_MEASURE_MEAN_DRIFT,
    THUD_MEASURE_ACCELERATION_RATIO, /* of the means, to the point's reference; NaN for 0/0 */
    THUD_MEASURE_DRIFT_RATIO,
    THUD_MEASURE_DISPLACEMENT, /* this and the next four: of the rows of floors alone, relative to the ground, m */
    THUD_MEASURE_DISPLACEMENT_RATIO,
    THUD_MEASURE_ACCELERATION_FREE_RATIO, /* over no pounding at all */
    THUD_MEASURE_DRIFT_FREE_RATIO,
    THUD_MEASURE_DISPLACEMENT_FREE_RATIO,
    THUD_MEASURE_EXCURSIONS, /* how many times the storey below a floor yielded, and the energy lost in it, J */
    THUD_MEASURE_HYSTERETIC,
    THUD_MEASURE_DUCTILITY,          /* largest drift over yield drift of the storeys that yield; NaN: none does */
    THUD_MEASURE_PERMANENT,          /* largest size of the permanent drift of those, m */
    THUD_MEASURE_ISOLATOR,           /* largest displacement of its isolators, m; NaN: it has none */
    THUD_MEASURE_ISOLATOR_PERMANENT, /* its size where they carry no force at the end, m; NaN: none yields or slides */
    THUD_MEASURE_COLUMNS,   /* largest shear over capacity of the columns that slabs strike; NaN: none, or not given */
    THUD_MEASURE_STRAIN,    /* largest compression of a bumper over its thickness; NaN: there is none */
    THUD_MEASURE_LINK,      /* largest force of all links, N; NaN: there are none */
    THUD_MEASURE_COLLAPSED, /* 1: the drift of a storey comes to where it collapses */
    THUD_MEASURES
};

/* Documents that report measures. */
enum thud_measure_document {
    THUD_TOLD_BY_SUITE,       /* suite.csv and its table: fractiles over the ground motions */
    THUD_TOLD_BY_LOWERED,     /* what bumper and links lower: ratios to case none */
    THUD_TOLD_BY_UNCERTAINTY, /* uncertainty.csv and what goes with it */
    THUD_TOLD_BY_SWEEP,       /* what a study keeps of a run for its figures and its table */
    THUD_TOLD_BY_FLOORS,      /* sweep.csv: rows of floors, and of the mean over them */
    THUD_MEASURE_DOCUMENTS
};

/* Features that a scene must have for a measure. */
enum {
    THUD_HAS_YIELDING = 1,     /* storeys that may yield */
    THUD_HAS_ISOLATORS = 2,    /* a structure on isolators */
    THUD_HAS_COLUMNS = 4,      /* columns that slabs strike */
    THUD_HAS_CAPACITY = 8,     /* and a capacity of columns */
    THUD_HAS_REFERENCE = 16,   /* another run to compare with */
    THUD_HAS_LINK_FORCES = 32, /* links */
    THUD_HAS_SLIDING = 64      /* isolators that yield or slide */
};

/* Run of a finished point. */
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
    bool of_storeys;            /* over several rows of floors: of those that have a storey below */
    unsigned needs;             /* THUD_HAS_... */
    enum thud_measure ratio_of; /* a ratio to the reference: the measure that it is of; else 0 */
    bool free;                  /* of floors: a ratio to no pounding */
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
/* Returns the index of a measure among the values of a run that a document stores, the first of several, for this
 * number of structures; for THUD_MEASURES, the number of values. */
int thud_measure_place(enum thud_measure_document document, int nstructures, enum thud_measure measure);
/* Lists the measures that a document reports of what has `features`, in its order; returns how many. */
int thud_measures_told(enum thud_measure_document document, unsigned features, enum thud_measure told[THUD_MEASURES]);
/* Return the features of a structure, and of a scene with its links: neither THUD_HAS_COLUMNS nor THUD_HAS_REFERENCE. */
unsigned thud_structure_features(const struct thud_structure *structure);
unsigned thud_scene_features(const struct thud_scene *scene);

/* Returns the larger of two values of a measure: unknown if either is, or that one is ignored (`unknown`). */
double thud_measure_larger(const struct thud_measure_info *info, double a, double b);
/* Returns one of THUD_TOLD_BY_FLOORS in case k (k = ncases: no pounding) of a variant of a point, on a floor of a
 * structure (from 1; 0: the mean over its floors). Measures of yielding storeys have the mean over these storeys, of
 * absolute values (permanent drifts in both directions would cancel); ratios are those of the means. NaN: there is
 * none, as for 0/0. */
double thud_measure_of_floor(const struct thud_sweep_point *point, int variant, int k,
                             const struct thud_measure_info *info, int structure, int floor);
/* Returns a measure; one of the run ignores `structure`. NaN: there is none, or it is not known. */
static inline double thud_measure_read(const struct thud_measured_run *run, enum thud_measure measure, int structure)
{
    const struct thud_measure_info *info = thud_measure_info(measure);
    return info->read(run, info, structure);
}

/* A row of a run and floor. */
struct thud_sweep_row {
    enum thud_case which;
    double gap_m;   /* of the first interface; NaN where there is none */
    int structure;  /* from 0 */
    int floor;      /* from 1; 0: the mean over the structure's floors */
    bool collapsed; /* its run did: peaks until then, and no ratios */
    /* Those of THUD_TOLD_BY_FLOORS; low and high over the changed runs and the one as asked for; a ratio's two runs are
     * changed alike. NaN where no spread was asked for or one of the runs has no result. */
    double of[THUD_MEASURES], low[THUD_MEASURES], high[THUD_MEASURES];
};
int thud_sweep_row_count(const struct thud_sweep_point *point);
void thud_sweep_row_at(const struct thud_sweep_point *point, int i, struct thud_sweep_row *row);
