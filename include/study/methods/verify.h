/* What a preset is expected to give: the results of its cases as named numbers, compared with stored ones. Names are
 * STRUCTURE.FLOOR.acceleration_mps2 (displacement_m, velocity_mps, drift_m), STRUCTURE.base_shear_n (overturning_nm),
 * contact.INTERFACE.LEFT-RIGHT.impacts (force_n, indentation_m, impulse_ns; floors, or `wall`), energy.input_j
 * (viscous_j, contact_j) and ratio.STRUCTURE.FLOOR.acceleration (displacement, drift): over case `none`. A storey that
 * yields adds STRUCTURE.FLOOR.ductility (permanent_m, excursions, hysteretic_j, shear_n) and the ratio of the first. */
#pragma once

#include "base/status.h"
#include "core/model/result.h"
#include "study/scene/scene.h"

enum { THUD_MEASURE_NAME_MAX = 160 };

struct thud_checked_value {
    enum thud_case which;
    char name[THUD_MEASURE_NAME_MAX];
    double value; /* SI */
    bool count;   /* a whole number: holds exactly or not at all */
    int stem;     /* length of the name without its unit where a ratio is of use, else 0 */
};
struct thud_checked_values {
    struct thud_checked_value *item; /* (n) */
    size_t n;
};

/* Adds the results of a case's run, except those that are always 0 (storeys of a free body, a wall). Errors:
 * THUD_MEMORY. */
enum thud_status thud_checked_values_add(struct thud_checked_values *measures, const struct thud_scene *scene,
                                         enum thud_case which, const struct thud_result *result,
                                         struct thud_error *err);
/* Adds the ratios of every other case to case `none`, once all cases are in. Errors: THUD_MEMORY. */
enum thud_status thud_checked_values_add_ratios(struct thud_checked_values *measures, struct thud_error *err);
/* Finds a number by name; NULL: none. */
const struct thud_checked_value *thud_checked_values_find(const struct thud_checked_values *measures,
                                                          enum thud_case which, const char *name);
void thud_checked_values_clear(struct thud_checked_values *measures);

struct thud_expectation {
    enum thud_case which;
    char name[THUD_MEASURE_NAME_MAX];
    double value;
    double tolerance; /* largest change allowed, relative, absolute where 0 is expected; 0: none */
    double other;     /* of one that two methods do not agree on: what the second gave; else NaN */
};
struct thud_expectations {
    struct thud_expectation *item; /* (n) */
    size_t n;
};
/* Adds an expectation. Errors: THUD_MEMORY. */
enum thud_status thud_expectations_add(struct thud_expectations *list, const struct thud_expectation *one,
                                       struct thud_error *err);
void thud_expectations_clear(struct thud_expectations *list);

/* Returns the tolerance that two methods' values justify: ten times their difference rounded up to one digit, at least
 * 1e-6; 0 for equal counts. NaN: they disagree (by more than 1e-4, or in a count). */
double thud_verify_tolerance(double own, double independent, bool count);

/* Makes expectations from two methods' results, with the values of the independent one. *disputed lists the
 * disagreements. Errors: THUD_MEMORY; both lists stay the caller's to clear. */
enum thud_status thud_verify_confirm(const struct thud_checked_values *own,
                                     const struct thud_checked_values *independent, struct thud_expectations *agreed,
                                     struct thud_expectations *disputed, struct thud_error *err);

enum thud_check_verdict { THUD_HOLDS, THUD_MOVED, THUD_GONE };
const char *thud_check_verdict_name(enum thud_check_verdict verdict); /* "holds", "moved", "gone" */

struct thud_check {
    double got;    /* NaN: there is no such number any more */
    double change; /* relative with its sign, absolute where 0 was expected */
    enum thud_check_verdict verdict;
};
struct thud_check thud_verify_check(const struct thud_expectation *expected,
                                    const struct thud_checked_values *measures);

/* Returns the method that confirms a result of `method`: one with different time stepping. */
const char *thud_verify_independent(const char *method);
