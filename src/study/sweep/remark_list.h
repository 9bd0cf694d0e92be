/* The remarks. A row: its subject, how often it is asked, its weight, the name of its function thud_remark_NAME in
 * remark_*.c, which has condition and sentence, its place (a key, N the number of a structure or an interface), what is
 * allowed (where the function does not state them), and the keys of the JSON that its numbers are values of (struct
 * thud_remark). Adjacent rows on the same subject, evaluated at the same places, are reported place by place. */
THUD_REMARK(EFFORT, ONCE, UNUSUAL, effort, "analysis", "analysis.modes omits the high modes of each building", "")
THUD_REMARK(MOTIONS, ONCE, MOTION, one_event, "", "motions of several events", "")
THUD_REMARK(MOTIONS, ONCE, MOTION, recordings, "", "", "")
THUD_REMARK(MOTIONS, ONCE, MOTION, target, "", "", "")
THUD_REMARK(MOTIONS, MOTION, MOTION, factor, "",
            "usually 1/4 to 4; beyond, it no longer resembles a motion of this intensity", "scale")
THUD_REMARK(MOTIONS, MOTION, MOTION, vertical, "", "pounding is computed for horizontal motion", "")
THUD_REMARK(MOTIONS, MOTION, MOTION, twice, "", "use independent motions", "")
THUD_REMARK(COMPUTED, ONCE, MOTION, synthetic, "", "use recorded motions for design: this is not an actual earthquake",
            "")
THUD_REMARK(SCENE, STRUCTURE, UNUSUAL, structure_values, "", "", "")
THUD_REMARK(SCENE, STRUCTURE, UNUSUAL, modes, "structures.N.periods", "as many modes as floors", "storeys")
THUD_REMARK(SCENE, STRUCTURE, UNUSUAL, estimate, "structures.N.height", "", "height_m")
THUD_REMARK(SCENE, STRUCTURE, UNUSUAL, columns, "", "usually less than the storey's stiffness", "stiffness_npm")
THUD_REMARK(SCENE, INTERFACE, UNUSUAL, assumed_law, "interfaces.N.contact.law",
            "the law of Polycarpou and Komodromos (2011); others: `thud laws`", "")
THUD_REMARK(SCENE, INTERFACE, UNUSUAL, interface_values, "", "", "")
THUD_REMARK(SCENE, INTERFACE, UNUSUAL, cavity, "interfaces.N.bumper.cavity", "", "cavity_m")
THUD_REMARK(SCENE, INTERFACE, UNUSUAL, light_wall, "", "a wall without mass and stiffness is fixed",
            "mass_kg base-mass_kg mass_kg||mass_kg mass_kg||base-mass_kg")
THUD_REMARK(SCENE, INTERFACE, UNUSUAL, whole_law, "", "", "")
THUD_REMARK(SCENE, INTERFACE, UNUSUAL, faces, "structures.N.slab-depth",
            "usually a quarter of the shallower slab or more; see height and base", "slab-depth_m")
THUD_REMARK(SCENE, ONCE, UNUSUAL, setup, "", "", "")
THUD_REMARK(SCENE, ONCE, UNUSUAL, levels, "", "floors at or between those of the neighbour; see heights and base", "")
THUD_REMARK(SCENE, ONCE, UNUSUAL, step, "analysis.step", "", "step_s")
THUD_REMARK(SIMPLER, ONCE, UNUSUAL, simpler, "", "", "")
THUD_REMARK(CHANGE, VARIED, UNUSUAL, kept_key, "",
            "alpha, area and material-stiffness in place of stiffness make it follow", "")
THUD_REMARK(CHANGE, INTERFACE, UNUSUAL, kept_stiffness, "interfaces.N.bumper.thickness",
            "alpha, area and material-stiffness in place of stiffness make it follow", "")
THUD_REMARK(RESULT, INTERFACE, MODEL, bumper, "interfaces.N.bumper", "",
            "thickness_m indentation_m indentation_time_s max-strain*thickness_m impacts")
THUD_REMARK(RESULT, STRUCTURE, MODEL, drift, "structures.N", "", "drift_m drift_m/height_m")
THUD_REMARK(RESULT, STRUCTURE, FAILURE, struck, "structures.N.column.capacity", "",
            "shear_lower_n shear_upper_n shear_lower_time_s shear_upper_time_s shear_over_capacity")
THUD_REMARK(RESULT, STRUCTURE, MODEL, overturning, "structures.N.width", "", "overturning_nm overturning_time_s")
THUD_REMARK(RESULT, ONCE, FAILURE, collapse, "", "", "time_s drift_m drift_m/height_m")
THUD_REMARK(RESULT, STRUCTURE, MODEL, yielding, "structures.N.yield", "", "ductility drift_m drift_m/height_m")
THUD_REMARK(RESULT, STRUCTURE, MODEL, theta, "structures.N", "", "stability_coefficient")
THUD_REMARK(LEDGER, ONCE, DIGITS, energy, "", "", "error_ratio contact_j")
THUD_REMARK(RESULT, ONCE, DIGITS, digits, "", "", "gap_m change gap scale stiffness_odd stiffness_even")
THUD_REMARK(STUDY, ONCE, FAILURE, collapses, "", "", "")
THUD_REMARK(STUDY, ONCE, MODEL, presses, "", "", "thickness_m indentation_m")
THUD_REMARK(STUDY, ONCE, MODEL, drifts, "", "", "drift_m/height_m")
THUD_REMARK(STUDY, ONCE, MODEL, thetas, "", "", "")
#undef THUD_REMARK
