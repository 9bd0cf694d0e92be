/* Tables of numbers (CSV, plain columns): which column is the acceleration, where the time step and the unit come from.
 */
#ifndef THUD_IO_RECORD_TABLE_H
#define THUD_IO_RECORD_TABLE_H

#include "io/record/record_source.h"
#include "io/record/record_unit.h"

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
    bool unequal;  /* the times do not climb in equal steps, and are to be resampled */
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

#endif
