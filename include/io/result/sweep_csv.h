/* Writes rows of a study as CSV (RFC 4180, lines end with a newline) and JSON, in SI units with a decimal point and all
 * digits. A missing number is an empty field or null. */
#pragma once

#include "io/file/schema.h"
#include "study/scene/gap_rule.h"
#include "study/sweep/sweep.h"

extern const struct thud_schema thud_sweep_floor_schema, thud_sweep_storey_schema, thud_sweep_contact_schema,
    thud_need_schema;

/* Adds the varied keys, named with their units (KEY_m): those of the axes that `shown` says (NULL: of all of them). */
void thud_axis_columns(const struct thud_sweep_plan *plan, const bool *shown, struct thud_made_columns *out);
/* Adds their cells in a row: on axis a the at[a]-th value. */
void thud_axis_cells(const struct thud_sweep_plan *plan, const bool *shown, const int *at,
                     union thud_column_value *cell);

/* Required gap of a level under a ground motion, beside the results of rules. */
struct thud_need_fields {
    const char *record, *struck;
    struct thud_gap_level level;
    double rule[THUD_GAP_RULES + 1]; /* from THUD_GAP_EXACT on */
};
struct thud_need_fields thud_need_fields_of(const struct thud_gap_level *level, const char *record);
enum { THUD_NEED_RECORD = 1, THUD_NEED_CODES = 2 }; /* marks: with the ground motion, with the rules of every code */

enum thud_sweep_csv { THUD_SWEEP_CSV_FLOORS, THUD_SWEEP_CSV_CONTACTS, THUD_SWEEP_CSV_NEEDS, THUD_SWEEP_CSVS };

/* Returns "sweep.csv", "contacts.csv", "needed-gaps.csv". */
const char *thud_sweep_csv_name(enum thud_sweep_csv which);
void thud_sweep_csv_header(const struct thud_sweep_plan *plan, enum thud_sweep_csv which, struct thud_text *out);
/* Writes the rows of one point. */
void thud_sweep_csv_rows(const struct thud_sweep_plan *plan, enum thud_sweep_csv which,
                         const struct thud_sweep_point *point, struct thud_text *out);
/* Writes the floors of one point as objects; *any: one was written before, and is set. */
void thud_sweep_json_rows(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point, bool *any,
                          struct thud_text *out);
