/* The pair of orders 5 and 4 of Dormand and Prince (1980) with a step that follows the run's tolerance. */
#pragma once

#include "core/methods/runge_kutta.h"

extern const struct thud_tableau thud_dormand_prince_tableau;

enum thud_status thud_dormand_prince_create(const struct thud_method *method, const struct thud_state *state,
                                            void **own, struct thud_error *err);
enum thud_status thud_dormand_prince_step(const struct thud_state *state, void *own, struct thud_segment *seg,
                                          struct thud_error *err);
void thud_dormand_prince_committed(const struct thud_state *state, void *own, const struct thud_segment *seg,
                                   double tau_s, bool switched);
void thud_dormand_prince_free(void *own);
