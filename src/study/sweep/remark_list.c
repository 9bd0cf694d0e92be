/* The rows of the list of remarks. */
#include "study/sweep/remark_rows.h"

/* How often a row is asked. */
enum place { ONCE, STRUCTURE, INTERFACE, MOTION, VARIED };

#define ROW(about, at, weight, name)                                                                                   \
    {                                                                                                                  \
        THUD_REMARK_##about, at, THUD_WEIGHT_##weight, thud_remark_##name                                              \
    }
#define SCENE(at, name) ROW(SCENE, at, UNUSUAL, name)

/* Adjacent rows on the same subject, evaluated at the same places, are reported place by place. */
static const struct row {
    enum thud_remark_about about;
    enum place at;
    enum thud_remark_weight weight;
    thud_remark_row *look;
} rows[] = {
    ROW(EFFORT, ONCE, UNUSUAL, effort),
    ROW(MOTIONS, ONCE, MOTION, one_event),
    ROW(MOTIONS, ONCE, MOTION, recordings),
    ROW(MOTIONS, ONCE, MOTION, target),
    ROW(MOTIONS, MOTION, MOTION, factor),
    ROW(MOTIONS, MOTION, MOTION, vertical),
    ROW(MOTIONS, MOTION, MOTION, twice),
    ROW(COMPUTED, ONCE, MOTION, synthetic),
    SCENE(STRUCTURE, structure_values),
    SCENE(STRUCTURE, modes),
    SCENE(STRUCTURE, estimate),
    SCENE(STRUCTURE, columns),
    SCENE(INTERFACE, assumed_law),
    SCENE(INTERFACE, interface_values),
    SCENE(INTERFACE, cavity),
    SCENE(INTERFACE, light_wall),
    SCENE(INTERFACE, whole_law),
    SCENE(INTERFACE, faces),
    SCENE(ONCE, setup),
    SCENE(ONCE, levels),
    SCENE(ONCE, step),
    ROW(SIMPLER, ONCE, UNUSUAL, simpler),
    ROW(CHANGE, VARIED, UNUSUAL, kept_key),
    ROW(CHANGE, VARIED, UNUSUAL, scaled_key),
    ROW(CHANGE, INTERFACE, UNUSUAL, kept_stiffness),
    ROW(RESULT, INTERFACE, MODEL, bumper),
    ROW(RESULT, STRUCTURE, MODEL, drift),
    ROW(RESULT, STRUCTURE, FAILURE, struck),
    ROW(RESULT, STRUCTURE, MODEL, overturning),
    ROW(RESULT, ONCE, FAILURE, collapse),
    ROW(RESULT, STRUCTURE, MODEL, yielding),
    ROW(RESULT, STRUCTURE, MODEL, theta),
    ROW(LEDGER, ONCE, DIGITS, energy),
    ROW(RESULT, ONCE, DIGITS, digits),
    ROW(STUDY, ONCE, FAILURE, collapses),
    ROW(STUDY, ONCE, MODEL, presses),
    ROW(STUDY, ONCE, MODEL, drifts),
    ROW(STUDY, ONCE, MODEL, thetas),
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
                }
            }
    }
    return out;
}
