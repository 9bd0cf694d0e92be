/* Observer of a run: histories, rows at chosen moments. Reads the peaks so far (a row stands at each, so that the largest
 * value of a column is the peak) and the energy ledger: it comes after the one and before the other. */
#pragma once

#include "core/observe/observe_energy.h"

struct thud_history_rows {
    struct thud_history history;
    const struct thud_result *result;
    const struct thud_ledger *ledger;
    double step_s;                   /* between rows outside contacts */
    double rest_from_s, rest_step_s; /* likewise once the ground is at rest: INFINITY, never */
    double look_s;                   /* between rows in contact, without energies; 0: closer, with them */
    double next_row_s;
    double close_rows_until_s; /* rows stand closer for a while after a contact */
    bool row_waits;            /* the last row counts only if a contact has switched behind it */
    bool switched;             /* a contact or a storey has, since the last segment */
    double *work;              /* (3 x nmodes) */
};

extern const struct thud_observer thud_observe_history;

/* Errors: THUD_MEMORY. */
enum thud_status thud_history_rows_init(struct thud_history_rows *rows, const struct thud_state *state,
                                        const struct thud_result *result, const struct thud_ledger *ledger,
                                        double step_s, double look_s, struct thud_error *err);
void thud_history_rows_clear(struct thud_history_rows *rows);
