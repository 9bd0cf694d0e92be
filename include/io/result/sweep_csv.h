/* Rows of a study as CSV (RFC 4180, lines end with a newline). SI units, a point as decimal mark, all digits; no number
 * is an empty field. */
#ifndef THUD_IO_SWEEP_CSV_H
#define THUD_IO_SWEEP_CSV_H

#include "base/text.h"
#include "study/sweep/sweep.h"

enum thud_sweep_csv { THUD_SWEEP_CSV_FLOORS, THUD_SWEEP_CSV_CONTACTS, THUD_SWEEP_CSV_NEEDS, THUD_SWEEP_CSVS };

/* "sweep.csv", "contacts.csv", "needed-gaps.csv" */
const char *thud_sweep_csv_name(enum thud_sweep_csv which);
void thud_sweep_csv_header(const struct thud_sweep_plan *plan, enum thud_sweep_csv which, struct thud_text *out);
/* The rows of one point. Errors: THUD_MEMORY. */
enum thud_status thud_sweep_csv_rows(const struct thud_sweep_plan *plan, enum thud_sweep_csv which,
                                     const struct thud_sweep_point *point, struct thud_text *out,
                                     struct thud_error *err);

#endif
