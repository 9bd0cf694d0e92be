/* The cells of a table with a header: which rows are numbers, where each stands in the file, and the unit it says. */
#pragma once

#include "io/building/building_file.h"
#include "io/record/csv_lines.h"

/* At most so many rows and columns of numbers; the header may have as many columns. */
enum { CELLS_ROWS_MAX = THUD_STOREYS_MAX, CELLS_COLUMNS_MAX = CSV_FIELDS_MAX };

struct building_cells {
    struct record_source source;
    char *text;
    char *head[CELLS_COLUMNS_MAX]; /* names of the columns; NULL or empty: none */
    int heads, head_line;
    char unit[32],
        of_time[32]; /* of a stiffness or a flexibility, and of a time, as the header says it; empty: not said */
    int unit_line;
    double *value; /* (rows x columns) of the numbers; NaN: a label */
    int rows, columns;
    int line[CELLS_ROWS_MAX];
};

/* Errors: THUD_INPUT with place, THUD_MEMORY. Clear also after them. */
enum thud_status building_cells_read(const char *path, struct building_cells *out, struct thud_error *err);
void building_cells_clear(struct building_cells *cells);
/* The character at which cell `column` (from 0) of a row begins, from 1. */
int building_cells_column(const struct building_cells *cells, int row, int column);
/* Sets an input error at a cell; column -1: at the row; row -1: of the file. */
enum thud_status building_cells_refuse(const struct building_cells *cells, int row, int column, struct thud_error *err,
                                       const char *fmt, ...) THUD_PRINTF(5, 6);
/* Factor of a unit to N/m, or of the inverse of one (mm/kN) to m/N in *inverse; 0: it is neither. */
double building_unit_stiffness(const char *unit, bool *inverse);
double building_unit_time(const char *unit);
