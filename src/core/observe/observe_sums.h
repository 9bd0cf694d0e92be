/* Observer of a run: peaks of sums over the modes of a system (core/model/model.h), each by modal values, by their rates,
 * and by forces of rows:
 *
 *     x = k (row . q) + c (rate . q') + sum_r f_r F_r
 *
 * Storey shears of buildings by their matrix, the drifts on which the weight acts, overturning moments, shears and moments
 * of columns that slabs strike, strokes and forces of links. Shears of other storeys follow from the peaks of their drifts;
 * links that are contacts have theirs from the contacts' log at the end. */
#pragma once

#include "core/observe/observer.h"

struct thud_sum {
    enum thud_sum_kind { THUD_SUM_SHEAR, THUD_SUM_LEAN, THUD_SUM_MOMENT, THUD_SUM_COLUMN, THUD_SUM_LINK } kind;
    int structure, index, quantity; /* one of the system; floor, column or link, and which of its peaks */
    const double *row, *rate;       /* (modes); rate: NULL where it has no part */
    double by_row, by_rate;
    const struct thud_sum_force { /* (forces) rows whose forces have a part */
        int row;
        double by;
    } * force;
    int forces;
    double limit; /* what it cannot pass: the force at which a link slips */
    struct thud_peak *peak;
    double *lost_j; /* in the dashpot of a link; NULL: it has none */
};

struct thud_sums {
    struct thud_sum *sum; /* (count) */
    int count;
};

extern const struct thud_observer thud_observe_sums;

/* Errors: THUD_MEMORY. */
enum thud_status thud_sums_init(struct thud_sums *sums, const struct thud_state *state, struct thud_result *result,
                                struct thud_error *err);
/* At the end of a run: the links that are contacts, and what those of friction have lost. */
void thud_links_finish(const struct thud_state *state, struct thud_result *result);
