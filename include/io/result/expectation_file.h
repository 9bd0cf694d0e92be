/* Expectations of a preset, beside it: NAME.expected.csv beside NAME.yaml. Rows `case,quantity,value,tolerance` in SI
 * units; lines that begin with `#` are comments; the header may be missing. */
#pragma once

#include "base/text.h"
#include "study/methods/verify.h"

/* Gives the path of a preset's expectations. Errors: THUD_INPUT (the path is too long). */
enum thud_status thud_expectation_path(const char *preset_path, char *path, size_t size, struct thud_error *err);

/* Reads a file. Errors: THUD_INPUT with file, line and column (no file or row, an invalid number, ...), THUD_MEMORY. */
enum thud_status thud_expectation_read(const char *path, struct thud_expectations *out, struct thud_error *err);
/* Does the same from memory; `name` stands for the path. Errors: the same. */
enum thud_status thud_expectation_parse(const char *text, size_t size, const char *name, struct thud_expectations *out,
                                        struct thud_error *err);

/* Origin of a file, for its comment lines. */
struct thud_expectation_origin {
    const char *preset, *own, *independent; /* names of the preset and of the methods */
    const char *own_setting;                /* "tolerance 1e-6" */
    double independent_tolerance;
};
void thud_expectation_text(const struct thud_expectation_origin *origin, const struct thud_expectations *agreed,
                           const struct thud_expectations *disputed, struct thud_text *out);
