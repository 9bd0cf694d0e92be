/* Tables of numbers (CSV, plain columns): which column is the acceleration, where the time step and the unit come from.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "io/record/record_source.h"

/* ---- Units and time steps as files spell them, in column names, comments and prose ---- */

/* Factor to m/s2 of the acceleration unit that begins at `s` (`cm/sec^2`, `mm/s/s`, `gal`, `g`, `mps2`); 0 when there
 * is none. */
double record_unit_at(const char *s, const char *end, size_t *length);
/* Over blanks before it; NaN where there is none. */
double record_factor_at(const char *s, const char *end);
/* The whole text is a unit: its factor, else 0. */
double record_unit(const char *text);
extern const char record_unit_allowed[];

/* The unit in the name of a column, in brackets (`acc (g)`) or behind it (`acceleration_mps2`), as a factor to m/s2, or
 * to s. What is no unit in full (`V/g`, `10^-3 g`, `fortnights`) gives 0, and its text in `unknown`. A name without a
 * unit: 0 with an empty `unknown`, and 1 for times. */
double record_name_unit(const char *name, char *unknown, size_t size);
double record_name_seconds(const char *name, char *unknown, size_t size);

/* The number behind `word`, with the unit of time behind it (`dt = 5 msec`; none: seconds), s; NaN: none, or its unit
 * is not known. */
double record_seconds_after(const struct record_line *line, const char *word);

/* A line of prose: keeps a time step (`dt=0.005 sec`) and an acceleration unit (`Acc. in cm/sec^2`, `UNITS OF G`,
 * `(g)`) in `raw`, unless one of the same kind stands there. What a line says of the acceleration counts more than a
 * unit that just stands there; units that contradict each other at equal weight leave the factor NaN. */
struct record_prose {
    double factor;
    int weight, line; /* 0: nothing found yet */
    bool contradicts;
    double dt_s;
    int dt_line;
};
void record_prose_read(struct record_prose *prose, const struct record_line *line);
void record_prose_apply(const struct record_prose *prose, struct record_raw *raw);

enum { TABLE_COLUMNS_MAX = 64, TABLE_NAME_MAX = 48 };

struct record_table {
    const struct record_source *source;
    struct record_raw cells; /* (rows x columns), the last row may be short */
    struct record_raw lines; /* (rows): where each row stands */
    size_t columns, rows;
    size_t in_last; /* values in the last row */
    char name[TABLE_COLUMNS_MAX][TABLE_NAME_MAX];
    size_t names;
    int names_line;
    bool unequal;  /* the times do not increase in equal steps, and are to be resampled */
    double time_s; /* of 1 in the column of times */
    struct record_prose prose;
};

void record_table_clear(struct record_table *table);
/* A row of numbers; a row of another length is only taken when it is short and the last. */
enum thud_status record_table_row(struct record_table *table, const double *value, size_t count, int line,
                                  struct thud_error *err);
/* A comment or a line before the numbers: prose, and `station: NAME` and the like. */
void record_table_prose(struct record_table *table, const struct record_line *line, struct record_raw *raw);
/* A row of words before the numbers: the columns' names. Words that stand for a number that is none are refused. */
enum thud_status record_table_name(struct record_table *table, size_t i, const char *name, int line,
                                   struct thud_error *err);
/* Chooses and fills `raw`. Errors: THUD_INPUT asking for --column, --dt. */
enum thud_status record_table_finish(struct record_table *table, const struct thud_record_choice *choice,
                                     struct record_raw *raw, struct thud_error *err);

/* The first line that can only be numbers, for recognition; false when there is none near the beginning. */
bool record_table_first(const struct record_source *source, struct record_line *line);
bool record_is_comment(const struct record_line *line);
