/* What commands write beside their tables. */
#pragma once

#include "app/run/session.h"
#include "app/sweep/fragility_report.h"
#include "base/text.h"
#include "cli/args.h"
#include "io/file/made_by.h"
#include "plot/gnuplot/gnuplot.h"
#include "study/suite/suite.h"
#include "study/sweep/remark.h"

/* ---- study.json, scene.json and made-by.txt: what the files beside them were made of ---- */

/* Version, scene, options and ground motions: the scene as a preset and the options with it give the study again. */
void thud_study_file_json(const struct thud_args *args, const struct thud_session *session,
                          const struct thud_sweep_plan *plan, struct thud_text *out);

/* What a command with -o makes of a scene, for made-by.txt, and whether the folder is free for it. Commands of one
 * group write files of the same names. What is asked for beside the scene are the values of the options `asked` (ends
 * with NULL) and the ground motions. Nothing without -o. Errors: those of thud_made_by_check. */
enum thud_status thud_made_by_scene(const struct thud_args *args, const char *group, const struct thud_scene *scene,
                                    const struct thud_record *const *records, int nrecords, const char *const *asked,
                                    struct thud_made_by *out, struct thud_error *err);
/* Likewise a study. */
enum thud_status thud_made_by_study(const struct thud_args *args, const struct thud_sweep_plan *plan,
                                    struct thud_made_by *out, struct thud_error *err);

/* thud_made_by_scene and thud_made_by_begin, with the scene itself as scene.json, for commands whose results are not
 * one run's. Nothing without -o. Errors: as those. */
enum thud_status thud_made_by_scene_file(const struct thud_args *args, const char *group,
                                         const struct thud_session *session, const struct thud_scene *scene,
                                         const char *const *asked, struct thud_made_by *out, struct thud_error *err);
/* thud_made_by_end, also of what a wish to stop left; without -o `before` alone. */
enum thud_status thud_made_by_finish(const struct thud_args *args, const struct thud_made_by *by,
                                     enum thud_status before, struct thud_error *err);

/* ---- Rows of a study on standard output as they come ---- */

enum thud_sweep_output_format { THUD_SWEEP_OUTPUT_TABLE, THUD_SWEEP_OUTPUT_CSV, THUD_SWEEP_OUTPUT_JSON };

struct thud_sweep_output {
    const struct thud_sweep_plan *plan;
    enum thud_sweep_output_format format; /* TABLE: no rows */
    struct thud_text text;
    bool begun, row;
    const struct thud_suite *suite; /* its statistics close the JSON; NULL: none */
};

/* Context: the output. Errors: THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_sweep_output_point(void *context, const struct thud_sweep_point *point, struct thud_error *err);
/* scope: whose remarks JSON ends with. */
enum thud_status thud_sweep_output_end(struct thud_sweep_output *output, const struct thud_remark_scope *scope,
                                       struct thud_error *err);

/* ---- What `thud fragility` says once its runs are done ---- */

/* --event, --hazard, --samples and --seed into *out. Errors: THUD_USAGE, THUD_INPUT. */
enum thud_status thud_fragility_options_read(const struct thud_args *args, const struct thud_sweep_plan *plan,
                                             struct thud_fragility_study *out, struct thud_error *err);
/* Files and figures into `folder` (NULL: none), then table, CSV or JSON into `out`. Errors: THUD_OUTPUT, THUD_GNUPLOT
 * (all else is done then), THUD_USAGE, THUD_MEMORY, THUD_CANCELLED. */
enum thud_status thud_fragility_deliver(const struct thud_args *args, struct thud_fragility_study *study,
                                        const char *folder, const struct thud_picture_options *pictures,
                                        struct thud_text *out, struct thud_error *err);

/* ---- thud run --floor-spectra: in place of the peaks ---- */

enum thud_status thud_cli_floor_spectra(const struct thud_args *args, struct thud_session *session,
                                        struct thud_error *err);
/* Errors: THUD_USAGE where an option of floor spectra stands without them. */
enum thud_status thud_cli_no_floor_spectra(const struct thud_args *args, struct thud_error *err);
