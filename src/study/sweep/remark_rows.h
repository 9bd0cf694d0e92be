/* The rows of the list of remarks: what each looks at, at the i-th place of its kind (structure, interface, motion or varied
 * key, from 0). It adds nothing, one remark, or several. */
#pragma once

#include "study/sweep/remark.h"

typedef void thud_remark_row(const struct thud_remark_scope *scope, int i, struct thud_remarks *out);

/* A remark, to be written by thud_error_set and its like. */
struct thud_error *thud_remark_add(struct thud_remarks *remarks);

thud_remark_row thud_remark_structure_values, thud_remark_modes, thud_remark_estimate, thud_remark_columns,
    thud_remark_assumed_law, thud_remark_interface_values, thud_remark_cavity, thud_remark_light_wall,
    thud_remark_whole_law, thud_remark_faces, thud_remark_setup, thud_remark_levels, thud_remark_step,
    thud_remark_simpler; /* remark_scene.c */
thud_remark_row thud_remark_one_event, thud_remark_recordings, thud_remark_target, thud_remark_factor,
    thud_remark_vertical, thud_remark_twice, thud_remark_synthetic; /* remark_motion.c */
thud_remark_row thud_remark_bumper, thud_remark_drift, thud_remark_struck, thud_remark_overturning,
    thud_remark_collapse, thud_remark_yielding, thud_remark_theta, thud_remark_collapses, thud_remark_presses,
    thud_remark_drifts, thud_remark_thetas, thud_remark_energy, thud_remark_digits;   /* remark_run.c */
thud_remark_row thud_remark_effort, thud_remark_kept_stiffness, thud_remark_kept_key; /* remark_plan.c */
