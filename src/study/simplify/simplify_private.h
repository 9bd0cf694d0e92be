#pragma once

#include "study/simplify/simplify.h"

/* What one row of the table applies to: $ in its words, @ in its keys. */
enum thud_simplify_span { THUD_SPAN_SCENE, THUD_SPAN_STRUCTURE, THUD_SPAN_INTERFACE, THUD_SPAN_LINK, THUD_SPAN_METHOD };

/* The full scene with its motion (NULL: none) and result, and what of it a row is applied to. */
struct thud_simplify_from {
    const struct thud_scene *base;
    const struct thud_record *record;
    const struct thud_result *full;
    const struct thud_simplify_row *row;
    int at, size;
};

struct thud_simplify_row {
    const char *words,
        *keys; /* $: name, @: number from 1, #: size; keys: KEY=VALUE parted by ; (NULL: made), !: the law that acts */
    const char *const *size; /* what # stands for, the least first, NULL at the end; NULL: there is none */
    enum thud_simplify_group group;
    enum thud_simplify_span span;
    const char *input;
    bool information;
    bool enough; /* sizes past one that keeps the accuracy by far are not tried */
    /* Changes the scene ahead of the keys; false: the row does not apply. */
    bool (*make)(const struct thud_simplify_from *from, struct thud_scene *scene);
};

/* Every row at every place and size where it applies, at most `most`; returns how many. */
int thud_simplify_list(struct thud_simplify_from from, bool no_methods, int most, struct thud_simplification *one);
const struct thud_simplify_row *thud_simplify_row_of(const struct thud_simplification *of);
/* Applies a row to the scene; false where it does not apply: nothing changes, or the scene cannot be so. */
bool thud_simplify_apply(const struct thud_simplification *of, struct thud_simplify_from from,
                         struct thud_scene *scene);
/* The spacing of samples (in its own samples) whose half rate is the corner of a motion without what lies above a mode;
 * 0: the row leaves the motion as it is. */
double thud_simplify_low_pass(const struct thud_simplification *of, const struct thud_result *full,
                              const struct thud_record *record);
/* Steps put together, by the indices of what was listed, on the governing motion; `failed`: they do not go together.
 * Errors: THUD_MEMORY. */
enum thud_status thud_simplify_try(struct thud_simplify *simplify, const int *step, int n,
                                   struct thud_simplification *out, struct thud_error *err);
/* Where the record as the scene uses it begins in the time of its file. */
double thud_simplify_begin(const struct thud_scene *base, const struct thud_record *record);

/* Peaks of one run, and of one case. */
struct thud_simplify_peak {
    int kind, structure, at[3]; /* what of; a contact's structure is 0 */
    double value;               /* NaN: none, by impulses */
};
struct thud_simplify_peaks {
    int n, impacts;
    bool collapsed;
    double force_n;                  /* the largest */
    struct thud_simplify_peak *item; /* (n) */
};
/* Errors: THUD_MEMORY. */
enum thud_status thud_simplify_peaks_take(const struct thud_result *result, struct thud_simplify_peaks *out,
                                          struct thud_error *err);
/* Adds `share` of another run of the same scene, on another ground motion, to peaks that begin as zeros. Errors:
 * THUD_MEMORY. */
enum thud_status thud_simplify_peaks_add(const struct thud_simplify_peaks *of, double share,
                                         struct thud_simplify_peaks *to, struct thud_error *err);
void thud_simplify_peaks_clear(struct thud_simplify_peaks *peaks);
/* Widens a change by that of one case; `gap` stays. */
void thud_simplify_compare(const struct thud_simplify_peaks *full, const struct thud_simplify_peaks *simple,
                           struct thud_simplify_change *change);
/* The same of required gaps (NaN: none), m. */
void thud_simplify_compare_gap(double full_m, double simple_m, struct thud_simplify_change *change);
