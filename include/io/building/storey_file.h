/* Tables of storeys and joints exported by ETABS and SAP2000 (CSV, or a sheet saved as CSV). They have a title, a row
 * of names, a row of units, and a row for each storey of each load case. */
#pragma once

#include "study/scene/scene.h"

/* What is to be taken from them. */
struct thud_storey_ask {
    const char *load_case; /* empty: the only one */
    int direction;         /* 0: X, 1: Y; -1: the only one that has values */
    enum thud_floor_order order;
};

/* From the lowest storey up, SI units. */
struct thud_storeys {
    int n, direction;
    char load_case[64];               /* empty: the tables have none */
    char lowest[48], highest[48];     /* names */
    double mass_kg[THUD_STOREYS_MAX]; /* NaN: no table has them; height too */
    double stiffness_npm[THUD_STOREYS_MAX];
    double height_m[THUD_STOREYS_MAX];
};

/* Reads one table, or two that complement each other. out->n is 0 if the only file is not such a table; it may be a
 * matrix. Errors: THUD_INPUT with file, line and column; THUD_MEMORY. */
enum thud_status thud_storey_files_read(const char *const *path, int n, const struct thud_storey_ask *ask,
                                        struct thud_storeys *out, struct thud_error *err);
