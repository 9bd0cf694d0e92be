/* Results of a parametric study, one row per run and floor and one per run and contact, as read by CSV files, figures
 * and screens. SI units. */
#pragma once

#include <stddef.h>

#include "core/model/result.h"
#include "study/scene/gap_rule.h"
#include "study/scene/scene.h"

/* Varied key with its values, in the order in which they are run. */
struct thud_sweep_axis {
    char key[96];
    const struct thud_param *param;
    int n, own;                  /* own: index of the preset's own value; -1: not among them, or not a number */
    bool words;                  /* choices, texts or lists instead of numbers */
    double *value;               /* (n) SI; of words their places in the list, from 0 */
    char (*text)[THUD_NAME_MAX]; /* (n) as thud_scene_set takes it */
    double range[3];             /* from, to, step, SI; NaN: the values were listed */
    double period_s;             /* of a spectral acceleration; NaN: the mean first period of each point's buildings */
};

/* Results of a contact. */
struct thud_sweep_contact {
    int impacts;
    double force_n, indentation_m, impulse_ns, contact_time_s;
    double residual_m, residual_gap_m; /* left by plastic deformation; the clearance at the end with it */
    /* of struck columns; NaN: floors meet, or no capacity */
    double shear_lower_n, shear_upper_n, capacity_ratio, moment_lower_nm, moment_upper_nm;
};

struct thud_sweep_contact_row {
    enum thud_case which;
    double gap_m; /* of the first interface; NaN where there is none */
    struct thud_gap_level level;
    struct thud_sweep_contact of;
    /* Over the nominal and the changed runs. NaN if no spread is requested or a run has no result. */
    double force_low_n, force_high_n, indentation_low_m, indentation_high_m;
};

/* Required gap of a level, from the response without pounding, and the codes' rules. */
struct thud_sweep_need_row {
    int record;
    int at[THUD_VARY_MAX]; /* index of its value on each axis; 0 on axes that do not affect motion without pounding */
    struct thud_gap_level level;
    struct thud_collapse fall; /* without pounding: the gap required until then */
};
