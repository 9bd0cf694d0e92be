/* What a parametric study gives, one row per run and floor and one per run and contact: what the CSV files, the
 * figures and the screens read. SI units. */
#pragma once

#include <stddef.h>

#include "core/model/result.h"
#include "study/scene/gap_rule.h"
#include "study/scene/scene.h"

/* A varied key with its values, in the order in which they are run. */
struct thud_sweep_axis {
    char key[96];
    const struct thud_param *param;
    int n, own;                  /* own: the preset's own value among them; -1: it is not there, or is no number */
    bool words;                  /* of choices, texts or lists, which no number says */
    double *value;               /* (n) SI; of words their places in the list, from 0 */
    char (*text)[THUD_NAME_MAX]; /* (n) as thud_scene_set takes it */
    double period_s;             /* of a spectral acceleration; NaN: the mean first period of each point's buildings */
};

/* What a row measures. */
enum thud_sweep_measure {
    THUD_SWEEP_ACCELERATION, /* m/s2 */
    THUD_SWEEP_DRIFT,        /* m */
    THUD_SWEEP_DISPLACEMENT, /* m */
    /* Over case `none` at the same parameters and record (floor 0: the ratio of the means); NaN for 0/0 or where `none`
     * has no result. */
    THUD_SWEEP_ACCELERATION_RATIO,
    THUD_SWEEP_DRIFT_RATIO,
    THUD_SWEEP_DISPLACEMENT_RATIO,
    /* Over no pounding at all. */
    THUD_SWEEP_ACCELERATION_FREE_RATIO,
    THUD_SWEEP_DRIFT_FREE_RATIO,
    THUD_SWEEP_DISPLACEMENT_FREE_RATIO,
    /* Of the storey below the floor where it yields (floor 0: means of the sizes over those that do); NaN: elastic. */
    THUD_SWEEP_DUCTILITY,
    THUD_SWEEP_PERMANENT,  /* drift at which it carries no force, m */
    THUD_SWEEP_EXCURSIONS, /* how many times it yielded */
    THUD_SWEEP_HYSTERETIC, /* energy lost, J */
    THUD_SWEEP_MEASURES
};

struct thud_sweep_row {
    int record; /* from 0 */
    enum thud_case which;
    double gap_m;                /* of the first interface; NaN where there is none */
    double value[THUD_VARY_MAX]; /* of the varied keys */
    int structure;               /* from 0 */
    int floor;                   /* from 1; 0: the mean over the structure's floors */
    bool collapsed;              /* its run did: peaks until then, and no ratios */
    double of[THUD_SWEEP_MEASURES];
    /* Each over the changed runs and the one as asked for; a ratio's two runs are changed alike. NaN where no spread
     * was asked for or one of the runs has no result. */
    double low[THUD_SWEEP_MEASURES], high[THUD_SWEEP_MEASURES];
};

/* What a run makes of a contact. */
struct thud_sweep_contact {
    int impacts;
    double force_n, indentation_m, impulse_ns, contact_time_s;
    double residual_m, residual_gap_m; /* left by plastic deformation; the clearance at the end with it */
    /* of struck columns; NaN: floors meet, or no capacity */
    double shear_lower_n, shear_upper_n, capacity_ratio, moment_lower_nm, moment_upper_nm;
};

struct thud_sweep_contact_row {
    int record;
    enum thud_case which;
    double gap_m;
    double value[THUD_VARY_MAX];
    int interface, left_floor, right_floor; /* from 1; floor 0: a wall */
    int struck;                             /* whose columns, as in gap levels */
    struct thud_sweep_contact of;
    double force_low_n, force_high_n, indentation_low_m, indentation_high_m; /* as low and high of a floor's row */
};

/* The gap that a level needs, from the motion without pounding, beside the rules of the codes. */
struct thud_sweep_need_row {
    int record;
    double value[THUD_VARY_MAX]; /* of the varied keys; those that change no motion without pounding as in the first
                                    point */
    struct thud_gap_level level;
    struct thud_collapse fall; /* without pounding: the gap is that until then */
};
