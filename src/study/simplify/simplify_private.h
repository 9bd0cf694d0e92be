#pragma once

#include "study/simplify/simplify.h"

/* What one row of the table is said of: $ in its words, @ in its keys. */
enum thud_simplify_span { THUD_SPAN_SCENE, THUD_SPAN_STRUCTURE, THUD_SPAN_INTERFACE, THUD_SPAN_LINK, THUD_SPANS };

struct thud_simplify_row {
    const char *words, *keys; /* $: name, @: number from 1, #: size; keys: KEY=VALUE parted by ; (NULL: made) */
    const char *const *size;  /* what # stands for, the least first, NULL at the end; NULL: there is none */
    enum thud_simplify_group group;
    enum thud_simplify_span span;
    bool information;
    bool contacts; /* it changes contacts or method alone: the motion without pounding stays */
    /* false: it does not apply. `full`: result of the full run. */
    bool (*make)(const struct thud_scene *base, const struct thud_record *record, const struct thud_result *full,
                 int at, int size, struct thud_scene *scene);
};
int thud_simplify_rows(void);
const struct thud_simplify_row *thud_simplify_row_at(int i);
/* How often a row may apply to a scene. */
int thud_simplify_span(const struct thud_simplify_row *row, const struct thud_scene *scene);
/* Applies a row to the scene; false where it does not apply: nothing changes, or the scene cannot be so. */
bool thud_simplify_apply(const struct thud_simplification *of, const struct thud_scene *base,
                         const struct thud_record *record, const struct thud_result *full, struct thud_scene *scene);
void thud_simplify_words(const struct thud_simplification *of, const struct thud_scene *scene, char *text, size_t size);
/* Where the record as the scene uses it begins in the time of its file. */
double thud_simplify_begin(const struct thud_scene *base, const struct thud_record *record);

/* Peaks of one run, and of one case. */
struct thud_simplify_peaks {
    int floors, contacts, impacts;
    bool collapsed;
    int *structure;                       /* (floors) */
    struct thud_contact_result *contact;  /* (contacts) */
    double *acceleration, *drift, *force; /* (floors), (floors), (contacts); NaN: none, by impulses */
};
/* Errors: THUD_MEMORY. */
enum thud_status thud_simplify_peaks_take(const struct thud_result *result, struct thud_simplify_peaks *out,
                                          struct thud_error *err);
void thud_simplify_peaks_clear(struct thud_simplify_peaks *peaks);
/* Widens a change by that of one case; `gap` stays. */
void thud_simplify_compare(const struct thud_simplify_peaks *full, const struct thud_simplify_peaks *simple,
                           struct thud_simplify_change *change);
