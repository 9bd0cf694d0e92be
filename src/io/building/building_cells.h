/* The cells of a table with a header: which rows are numbers, where each stands in the file, and the unit it says. */
#pragma once

#include "base/quantity.h"
#include "io/building/building_file.h"
#include "io/record/csv_lines.h"

/* At most so many rows and columns of numbers; the header may have as many columns. */
enum { CELLS_ROWS_MAX = THUD_STOREYS_MAX, CELLS_COLUMNS_MAX = CSV_FIELDS_MAX };

struct building_cells {
    struct record_source source;
    char *text, separator;
    bool decimal_comma;            /* 1.234,5 */
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
/* The text alone, and how it is parted; clear it too. Errors: those of reading a file. */
enum thud_status building_cells_open(const char *path, struct building_cells *out, struct thud_error *err);
/* A number of a cell, 1,234.5 or 1.234,5; false, and NaN: it is none. */
bool building_cells_number(const struct building_cells *cells, const char *text, double *out);
/* The character at which a cell (from 0) of a line (from 1) begins, from 1. */
int building_cells_place(const struct building_cells *cells, int line, int column);
/* Sets an input error at a cell; column -1: at the row; row -1: of the file. */
enum thud_status building_cells_refuse(const struct building_cells *cells, int row, int column, struct thud_error *err,
                                       const char *fmt, ...) THUD_PRINTF(5, 6);
/* Factor of a unit to N/m, or of the inverse of one (mm/kN) to m/N in *inverse; 0: it is neither. */
double building_unit_stiffness(const char *unit, bool *inverse);
/* Factor of a unit as these programs write it, KN, Sec and lb-s² for a force of pounds; 0: it is none of that kind. */
double building_unit(const char *unit, enum thud_dimension dimension);
