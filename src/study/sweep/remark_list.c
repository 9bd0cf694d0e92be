/* The rows of the list of remarks. */
#include "study/sweep/remark_rows.h"

/* How often a row is asked. */
enum place { ONCE, STRUCTURE, INTERFACE, MOTION, VARIED };

/* Rows one after the other that are about the same and asked at the same places are told place by place. */
static const struct row {
    enum thud_remark_about about;
    enum place at;
    enum thud_remark_weight weight;
    thud_remark_row *look;
} rows[] = {
    {THUD_REMARK_EFFORT, ONCE, THUD_WEIGHT_UNUSUAL, thud_remark_effort},
    {THUD_REMARK_MOTIONS, ONCE, THUD_WEIGHT_MOTION, thud_remark_one_event},
    {THUD_REMARK_MOTIONS, ONCE, THUD_WEIGHT_MOTION, thud_remark_recordings},
    {THUD_REMARK_MOTIONS, MOTION, THUD_WEIGHT_MOTION, thud_remark_factor},
    {THUD_REMARK_MOTIONS, MOTION, THUD_WEIGHT_MOTION, thud_remark_vertical},
    {THUD_REMARK_MOTIONS, MOTION, THUD_WEIGHT_MOTION, thud_remark_twice},
    {THUD_REMARK_COMPUTED, ONCE, THUD_WEIGHT_MOTION, thud_remark_synthetic},
    {THUD_REMARK_SCENE, STRUCTURE, THUD_WEIGHT_UNUSUAL, thud_remark_structure_values},
    {THUD_REMARK_SCENE, STRUCTURE, THUD_WEIGHT_UNUSUAL, thud_remark_modes},
    {THUD_REMARK_SCENE, STRUCTURE, THUD_WEIGHT_UNUSUAL, thud_remark_estimate},
    {THUD_REMARK_SCENE, STRUCTURE, THUD_WEIGHT_UNUSUAL, thud_remark_columns},
    {THUD_REMARK_SCENE, INTERFACE, THUD_WEIGHT_UNUSUAL, thud_remark_assumed_law},
    {THUD_REMARK_SCENE, INTERFACE, THUD_WEIGHT_UNUSUAL, thud_remark_interface_values},
    {THUD_REMARK_SCENE, INTERFACE, THUD_WEIGHT_UNUSUAL, thud_remark_cavity},
    {THUD_REMARK_SCENE, INTERFACE, THUD_WEIGHT_UNUSUAL, thud_remark_whole_law},
    {THUD_REMARK_SCENE, INTERFACE, THUD_WEIGHT_UNUSUAL, thud_remark_faces},
    {THUD_REMARK_SCENE, ONCE, THUD_WEIGHT_UNUSUAL, thud_remark_setup},
    {THUD_REMARK_SCENE, ONCE, THUD_WEIGHT_UNUSUAL, thud_remark_levels},
    {THUD_REMARK_SCENE, ONCE, THUD_WEIGHT_UNUSUAL, thud_remark_step},
    {THUD_REMARK_CHANGE, VARIED, THUD_WEIGHT_UNUSUAL, thud_remark_kept_key},
    {THUD_REMARK_CHANGE, INTERFACE, THUD_WEIGHT_UNUSUAL, thud_remark_kept_stiffness},
    {THUD_REMARK_RESULT, INTERFACE, THUD_WEIGHT_MODEL, thud_remark_bumper},
    {THUD_REMARK_RESULT, STRUCTURE, THUD_WEIGHT_MODEL, thud_remark_drift},
    {THUD_REMARK_RESULT, STRUCTURE, THUD_WEIGHT_FAILURE, thud_remark_struck},
    {THUD_REMARK_RESULT, STRUCTURE, THUD_WEIGHT_MODEL, thud_remark_overturning},
    {THUD_REMARK_RESULT, ONCE, THUD_WEIGHT_FAILURE, thud_remark_collapse},
    {THUD_REMARK_RESULT, STRUCTURE, THUD_WEIGHT_MODEL, thud_remark_yielding},
    {THUD_REMARK_RESULT, STRUCTURE, THUD_WEIGHT_MODEL, thud_remark_theta},
    {THUD_REMARK_LEDGER, ONCE, THUD_WEIGHT_DIGITS, thud_remark_energy},
    {THUD_REMARK_RESULT, ONCE, THUD_WEIGHT_DIGITS, thud_remark_digits},
    {THUD_REMARK_STUDY, ONCE, THUD_WEIGHT_FAILURE, thud_remark_collapses},
    {THUD_REMARK_STUDY, ONCE, THUD_WEIGHT_MODEL, thud_remark_presses},
    {THUD_REMARK_STUDY, ONCE, THUD_WEIGHT_MODEL, thud_remark_drifts},
    {THUD_REMARK_STUDY, ONCE, THUD_WEIGHT_MODEL, thud_remark_thetas},
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
                }
            }
    }
    return out;
}
