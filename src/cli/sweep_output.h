/* Rows of a study on standard output as they come. */
#ifndef THUD_CLI_SWEEP_OUTPUT_H
#define THUD_CLI_SWEEP_OUTPUT_H

#include "study/suite/suite.h"

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
enum thud_status thud_sweep_output_end(struct thud_sweep_output *output, struct thud_error *err);

#endif
