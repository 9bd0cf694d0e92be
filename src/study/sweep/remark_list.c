/* The rows of the list of remarks. */
#include "study/sweep/remark_rows.h"

/* How often a row is asked. */
enum place { ONCE, STRUCTURE, INTERFACE, MOTION, VARIED };

#define ROW(about, at, weight, name, keys)                                                                             \
    {                                                                                                                  \
        THUD_REMARK_##about, at, THUD_WEIGHT_##weight, thud_remark_##name, keys                                        \
    }
#define SCENE(at, name, keys) ROW(SCENE, at, UNUSUAL, name, keys)

/* Adjacent rows on the same subject, evaluated at the same places, are reported place by place. */
static const struct row {
    enum thud_remark_about about;
    enum place at;
    enum thud_remark_weight weight;
    thud_remark_row *look;
    const char *keys;
} rows[] = {
    ROW(EFFORT, ONCE, UNUSUAL, effort, ""),
    ROW(MOTIONS, ONCE, MOTION, one_event, ""),
    ROW(MOTIONS, ONCE, MOTION, recordings, ""),
    ROW(MOTIONS, ONCE, MOTION, target, ""),
    ROW(MOTIONS, MOTION, MOTION, factor, "scale"),
    ROW(MOTIONS, MOTION, MOTION, vertical, ""),
    ROW(MOTIONS, MOTION, MOTION, twice, ""),
    ROW(COMPUTED, ONCE, MOTION, synthetic, ""),
    SCENE(STRUCTURE, structure_values, ""),
    SCENE(STRUCTURE, modes, "storeys"),
    SCENE(STRUCTURE, estimate, "height_m"),
    SCENE(STRUCTURE, columns, "stiffness_npm"),
    SCENE(INTERFACE, assumed_law, ""),
    SCENE(INTERFACE, interface_values, ""),
    SCENE(INTERFACE, cavity, "cavity_m"),
    SCENE(INTERFACE, light_wall, "mass_kg base-mass_kg mass_kg||mass_kg mass_kg||base-mass_kg"),
    SCENE(INTERFACE, whole_law, ""),
    SCENE(INTERFACE, faces, "slab-depth_m"),
    SCENE(ONCE, setup, ""),
    SCENE(ONCE, levels, ""),
    SCENE(ONCE, step, "step_s"),
    ROW(SIMPLER, ONCE, UNUSUAL, simpler, ""),
    ROW(CHANGE, VARIED, UNUSUAL, kept_key, ""),
    ROW(CHANGE, INTERFACE, UNUSUAL, kept_stiffness, ""),
    ROW(RESULT, INTERFACE, MODEL, bumper,
        "thickness_m indentation_m indentation_time_s max-strain*thickness_m impacts"),
    ROW(RESULT, STRUCTURE, MODEL, drift, "drift_m drift_m/height_m"),
    ROW(RESULT, STRUCTURE, FAILURE, struck,
        "shear_lower_n shear_upper_n shear_lower_time_s shear_upper_time_s shear_over_capacity"),
    ROW(RESULT, STRUCTURE, MODEL, overturning, "overturning_nm overturning_time_s"),
    ROW(RESULT, ONCE, FAILURE, collapse, "time_s drift_m drift_m/height_m"),
    ROW(RESULT, STRUCTURE, MODEL, yielding, "ductility drift_m drift_m/height_m"),
    ROW(RESULT, STRUCTURE, MODEL, theta, "stability_coefficient"),
    ROW(LEDGER, ONCE, DIGITS, energy, "error_ratio contact_j"),
    ROW(RESULT, ONCE, DIGITS, digits, "gap_m change gap scale stiffness_odd stiffness_even"),
    ROW(STUDY, ONCE, FAILURE, collapses, ""),
    ROW(STUDY, ONCE, MODEL, presses, "thickness_m indentation_m"),
    ROW(STUDY, ONCE, MODEL, drifts, "drift_m/height_m"),
    ROW(STUDY, ONCE, MODEL, thetas, ""),
};
enum { ROWS = sizeof rows / sizeof *rows };

/* Whether what a row reads is there. */
static bool has(const struct thud_remark_scope *s, enum thud_remark_about about, enum place at)
{
    switch (about) {
    case THUD_REMARK_MOTIONS:
    case THUD_REMARK_COMPUTED:
        return s->nrecords > 0;
    case THUD_REMARK_CHANGE:
        return at == VARIED ? s->plan != NULL : s->scene && s->before;
    case THUD_REMARK_STUDY:
        return s->plan && s->watch;
    case THUD_REMARK_RESULT:
    case THUD_REMARK_LEDGER:
        return s->scene && s->result;
    case THUD_REMARK_SCENE:
    case THUD_REMARK_EFFORT:
    case THUD_REMARK_SIMPLER:
        break;
    }
    return s->scene != NULL;
}

static int places(const struct thud_remark_scope *scope, enum place at)
{
    return at == STRUCTURE   ? scope->scene->nstructures
           : at == INTERFACE ? scope->scene->nstructures - 1
           : at == MOTION    ? scope->nrecords
           : at == VARIED    ? scope->plan->naxes
                             : 1;
}

struct thud_remarks thud_remarks_find(const struct thud_remark_scope *scope, unsigned about)
{
    struct thud_remarks out = {0};
    for (int from = 0, to; from < ROWS; from = to) {
        for (to = from; to < ROWS && rows[to].about == rows[from].about && rows[to].at == rows[from].at;)
            to++;
        const int n = (about & rows[from].about) && has(scope, rows[from].about, rows[from].at)
                          ? places(scope, rows[from].at)
                          : 0;
        for (int i = 0; i < n; i++)
            for (int r = from; r < to; r++) {
                int k = out.n;
                rows[r].look(scope, i, &out);
                for (; k < out.n; k++) {
                    out.item[k].row = r;
                    out.item[k].weight = rows[r].weight;
                    out.item[k].keys = rows[r].keys;
                }
            }
    }
    return out;
}
