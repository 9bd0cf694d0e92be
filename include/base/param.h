/* Parameters described once: one table feeds presets, command line, forms, help and manual pages. */
#pragma once

#include <stdbool.h>

#include "base/quantity.h"

enum thud_param_kind { THUD_PARAM_QUANTITY, THUD_PARAM_INTEGER, THUD_PARAM_CHOICE, THUD_PARAM_TEXT };

/* Bounds in SI units: a hard bound refuses, a soft bound warns, NaN is no bound. Choices are stored as an index. */
struct thud_param {
    const char *name;  /* the word in presets, on the command line and on screens */
    const char *title; /* a few words */
    const char *help;  /* one sentence */
    enum thud_param_kind kind;
    enum thud_dimension dimension;
    const char *unit; /* shown unit, e.g. "kN/mm" */
    double fallback;  /* default in SI, or index of the default choice; NaN: must be given */
    double least, most;
    bool least_open, most_open; /* the bound itself is refused */
    double soft_least, soft_most;
    const char *const *choices; /* NULL-terminated words; of whole numbers (or NULL): the i-th is stored as -1 - i */
};

/* Writes the allowed values in words: "> 0, up to 1e6 t", "paper, exact"; empty if anything is allowed. */
void thud_param_allowed(const struct thud_param *param, char *text, unsigned long size);
/* Checks a value against the hard bounds; `text` is the value as typed. Errors: THUD_INPUT. */
enum thud_status thud_param_check(const struct thud_param *param, double value, const char *text,
                                  struct thud_error *err);
/* Returns whether a value lies outside the soft bounds; if so, `text` gets the usual range. */
bool thud_param_unusual(const struct thud_param *param, double value, char *text, unsigned long size);
/* Returns the index of a choice by its word; -1: none. */
int thud_param_choice(const struct thud_param *param, const char *word);
