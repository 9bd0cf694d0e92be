/* What is done with ground motions: read and treated as asked, measured, shown, listed. */
#pragma once

#include "ground/record_edit.h"
#include "ground/record_filter.h"
#include "ground/spectrum.h"
#include "io/file/schema.h"
#include "io/result/list_rows.h"
#include "plot/figures/figures_record.h"
#include "study/scene/scene.h"

/* In this order: read, trim, baseline, taper, filter, resample, then factor, peak and sign. */
struct thud_record_treatment {
    struct thud_record_choice choice; /* with factor, peak and sign */
    double from_s, to_s;              /* NaN: not given */
    int baseline;                     /* THUD_BASELINE_NONE or the degree of the polynomial */
    double taper_s;                   /* at each end; NaN: not */
    struct thud_record_filter filter;
    double resample_s; /* NaN: not */
};
void thud_record_treatment_init(struct thud_record_treatment *treatment);

/* `name` as given or, where there is no such file, in the records folder. Errors: THUD_INPUT, THUD_MEMORY. */
enum thud_status thud_record_open(const char *name, const struct thud_record_treatment *treatment,
                                  struct thud_record **out, struct thud_error *err);
/* What was done to it, a line each, for the comments of a file written from it; empty when nothing was. `dt_s` is the
 * step that it has now. */
void thud_record_treatment_describe(const struct thud_record_treatment *treatment, double dt_s, struct thud_text *out);

void thud_record_info_table(const struct thud_record *record, const struct thud_motion_info_row *row,
                            struct thud_text *out);
/* period_s,acceleration_mps2,velocity_mps,displacement_m under a comment line with the damping. */
void thud_spectrum_csv(const struct thud_record *record, const struct thud_spectrum_point *point, size_t count,
                       double damping, struct thud_text *out);

/* A row per record found in a folder, in the order of their names; files that are no record are passed over, records
 * that need an option say which. Errors: THUD_INPUT when the folder cannot be read, THUD_MEMORY. */
enum thud_status thud_record_list(const char *folder, enum thud_written form, struct thud_text *out,
                                  struct thud_error *err);
/* The same rows for n motions that were read, under the name of what holds them. */
void thud_record_rows(const char *name, struct thud_record *const *record, int n, enum thud_written form,
                      struct thud_text *out);

/* First periods of the scene's structures, at most `most`, how many in *count. Errors: as thud_scene_assemble. */
enum thud_status thud_scene_periods(const struct thud_scene *scene, struct thud_period_mark *mark, int most, int *count,
                                    struct thud_error *err);

/* "kobe-surrogate" from "records/kobe-surrogate.csv": what a figure's files may be called. */
void thud_record_file_stem(const char *path, char *stem, size_t size);
