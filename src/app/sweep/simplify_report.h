/* What a scene needs: the search run and timed, and told as text, JSON and a preset. */
#pragma once

#include <stdatomic.h>

#include "app/run/record_list.h"
#include "base/text.h"
#include "study/simplify/simplify.h"

/* Of several ground motions: how the cheapest of the governing one does on all; n 0: there is one. */
struct thud_simplify_suite {
    int n, governing;
    double median, worst;
};

/* Searches on the only ground motion, or on the governing one of several (largest contact force, without contact largest
 * required gap): its cheapest is then run on all, and loses its last steps until it keeps the accuracy on all of them.
 * Errors: THUD_CANCELLED, those of thud_simplify_advance. */
enum thud_status thud_simplify_search(const struct thud_scene *scene, const struct thud_record_list *records,
                                      const struct thud_simplify_ask *ask, const atomic_int *cancel,
                                      struct thud_simplify **out, struct thud_simplify_suite *suite,
                                      struct thud_error *err);

void thud_simplify_report(const struct thud_simplify *simplify, const struct thud_simplify_suite *suite,
                          struct thud_text *out);
void thud_simplify_json(const struct thud_simplify *simplify, const struct thud_simplify_suite *suite,
                        const char *preset, struct thud_text *out);
/* The comments of the written preset: what was left out and what it costs. */
void thud_simplify_comments(const struct thud_simplify *simplify, const struct thud_simplify_suite *suite,
                            struct thud_text *out);
