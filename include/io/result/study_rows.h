/* Results of studies as rows: gap rules, ground motions of a suite, fragilities. */
#pragma once

#include "io/file/schema.h"
#include "study/suite/gap_suite.h"

extern const struct thud_schema thud_gap_rule_schema, thud_motion_schema, thud_curve_key_schema, thud_stripe_schema,
    thud_curve_schema, thud_first_contact_schema, thud_best_schema, thud_tried_schema, thud_stiffness_schema,
    thud_spring_schema, thud_mode_schema, thud_built_schema, thud_quantity_schema, thud_effect_schema,
    thud_sample_schema, thud_index_schema, thud_suite_row_schema, thud_median_schema, thud_drawn_schema,
    thud_gap_fractile_schema, thud_gap_range_schema, thud_gap_row_schema, thud_used_motion_schema;

struct thud_gap_rule_row {
    int interface, motions;
    const char *numbers; /* text */
    struct thud_gap_rule rule;
    struct thud_gap_ruled found;
    char text[160];
};

/* Required gap of an interface (from 1) of a row over all ground motions; -1: nothing could touch there. */
struct thud_gap_row_fields {
    int interface;
    double others_as_given_m; /* by a run with it open; NaN: a storey collapses in one */
    double all_together_m;
};

struct thud_motion_row {
    struct thud_record record;
    double duration_s, pga_mps2, pgv_mps, arias_mps, misfit, factor;
    bool chosen;
    const char *why;
};
enum { THUD_MOTION_LAST = 2 }; /* columns behind those of the marked periods */

/* Fragility that a row belongs to. */
struct thud_curve_key {
    const char *event, *which, *against;
};
struct thud_stripe_row {
    int motions, count;
    double share, share_low, share_high, fitted, fitted_low, fitted_high;
};
enum { THUD_CURVE_RATES = 5 }; /* value, least, most, low, high */
struct thud_curve_row {
    double beta, beta_low, beta_high;
    int falling; /* 0, 1 */
    double deviance_p, rate[THUD_CURVE_RATES], probability[THUD_CURVE_RATES];
};

/* Factor on a ground motion at which contact begins. */
struct thud_first_contact_row {
    const char *record;
    double first, clear_again;
};

/* Best value of a key; the other keys follow the case, its own as texts or numbers. */
struct thud_best_row {
    const char *record, *which;
    double ratio, drift_ratio, worst_ratio;
    const char *remark;
};

/* Value tried, as text and in SI units. */
struct thud_tried_row {
    char value[48];    /* "5.5 cm" */
    double x;          /* SI */
    int motions, held; /* ground motions with an answer (0: not possible), and under which it holds */
};

/* Results of a run with another stiffness, for each structure; and the sources of stiffnesses. */
struct thud_stiffness_fields {
    const char *varied;
    double factor;
    int impacts;
    double force_n;
    const char *structure;
    double acceleration_mps2, drift_m;
};
struct thud_spring_row {
    const char *part;
    double alpha, exponent, stiffness;
};

/* Ground motion as the paper's study uses it. */
struct thud_used_motion_row {
    const char *name, *file;
    double file_peak_mps2, scale, peak_mps2, dt_s;
    size_t samples;
    bool synthetic;
};

/* Mode of a building: of a scene, or read from a file. */
enum { THUD_MODE_OF_SCENE = 1 };
struct thud_mode_row {
    const char *structure; /* of a scene */
    int mode;
    double period_s, frequency_hz, mass_kg, mass_ratio, mass_ratio_sum;
};

/* Row of a storey: its properties, and what follows from them; the marks of the columns of those that yield. */
enum { THUD_BUILT_YIELDS = 1 };
struct thud_built_row {
    const char *structure;
    int storey;
    double height_m, mass_kg, stiffness_npm, weight_n, yield_shear_n, yield_m, yield_ratio;
};

/* Effect of the sampled inputs on a quantity, and of one input alone. */
struct thud_quantity_row {
    const char *quantity, *which, *structure, *measure;
    double nominal, p5, median, p95, below_1_share, between_motions_share;
};
enum { THUD_EFFECTS = 8 };
struct thud_effect_row {
    const char *quantity, *input;
    double size, of[THUD_EFFECTS];
};
/* Quantity of one run: of a sample, or of a run for the indices. */
struct thud_sample_row {
    int sample;
    const char *design, *from_b;
    int row;
    const char *which, *structure, *measure;
    double value;
};
enum { THUD_ROW_DRAWN = 1, THUD_ROW_INDICES = 2 }; /* marks: motions are drawn; there are Sobol indices */
