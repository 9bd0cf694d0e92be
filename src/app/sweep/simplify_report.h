/* What a scene needs: the search run and timed, and told as text, JSON and a preset. */
#pragma once

#include <stdatomic.h>

#include "app/run/record_list.h"
#include "base/text.h"
#include "study/simplify/simplify.h"

/* Searches and times. Errors: THUD_CANCELLED (between two evaluations), those of thud_simplify_advance. */
enum thud_status thud_simplify_search(const struct thud_scene *scene, const struct thud_record_list *records,
                                      const struct thud_simplify_ask *ask, const atomic_int *cancel,
                                      struct thud_simplify **out, struct thud_error *err);

/* "5 modes of A, ...: error of 2.1 % at 14 % of the work; 9 input values instead of 31", without a stop. */
void thud_simplify_sentence(const struct thud_simplify_found *found, struct thud_text *out);
/* What it was found on, what misses every impact, what no model reaches, which inputs decide and which change nothing.
 * Each is a line after `before`, if there is anything to say. */
void thud_simplify_remarks(const struct thud_simplify_found *found, const char *before, struct thud_text *out);
void thud_simplify_report(const struct thud_simplify_found *found, struct thud_text *out);
void thud_simplify_json(const struct thud_simplify_found *found, const char *preset, struct thud_text *out);
/* The comments of the written preset: what was left out and what it costs. */
void thud_simplify_comments(const struct thud_simplify_found *found, struct thud_text *out);
