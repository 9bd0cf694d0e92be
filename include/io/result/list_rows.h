/* Rows of lists: ground motions, spectra, expectations, published values, laws and methods. */
#pragma once

#include "core/laws/law.h"
#include "core/methods/method.h"
#include "ground/intensity.h"
#include "ground/spectrum.h"
#include "io/file/schema.h"

extern const struct thud_schema thud_motion_info_schema, thud_motion_list_schema, thud_spectrum_schema,
    thud_spectrum_point_schema, thud_verified_schema, thud_check_schema, thud_fresh_schema, thud_published_schema,
    thud_published_value_schema, thud_law_schema, thud_law_param_schema, thud_methods_schema,
    thud_sampled_motion_schema, thud_series_schema;

struct thud_motion_info_row {
    struct thud_record record;
    const char *sha256;
    struct thud_intensity own;
    double predominant_s;
};
void thud_motion_info_fill(const struct thud_record *record, struct thud_motion_info_row *row);

/* Record of a list; `needs`: an option required to read it; `error`: why it cannot be read. */
struct thud_motion_list_row {
    const char *file, *format, *needs, *error, *pair;
    size_t samples;
    double dt_s, pga_mps2;
};

struct thud_spectrum_row {
    const char *file;
    double damping;
};
struct thud_rows thud_spectrum_rows(const struct thud_spectrum_point *point, size_t n);

struct thud_verified_row {
    const char *preset, *expectations;
    int cases, holds, moved, gone;
};
struct thud_check_row {
    const char *which, *quantity;
    double expected, tolerance, now, change;
    const char *verdict;
};
struct thud_fresh_row { /* of a new file */
    const char *which, *quantity;
    double value, tolerance, independent;
};

struct thud_published_head {
    const char *title, *source;
    bool skipped;
    const char *motion;
};

/* List the laws with their parameters, and the methods. */
void thud_laws_put(bool json, struct thud_text *out);
void thud_methods_put(bool json, struct thud_text *out);
