/* datapackage.json: what the tables in a folder are made of, after the Tabular Data Package of Frictionless Data. */
#pragma once

#include "io/file/schema.h"

#define THUD_DATA_PACKAGE_FILE "datapackage.json"

/* `files`: lines, those of the form `file NAME.csv` are the tables. `schema`: gives the i-th kind of row, NULL past the
 * last. Appends nothing where there is no table. Columns that no kind of row names are numbers where they end with a
 * unit, or where all their cells are. Errors: THUD_INPUT (a table cannot be read), THUD_MEMORY. */
enum thud_status thud_data_package(const char *folder, const char *files, const struct thud_schema *(*schema)(int),
                                   struct thud_text *out, struct thud_error *err);
