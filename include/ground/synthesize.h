/* Near-fault surrogates: a velocity pulse (Mavroeidis and Papageorgiou 2003) plus filtered noise (Kanai-Tajimi ground,
 * Clough-Penzien high pass) under an envelope. */
#pragma once

#include <stddef.h>

#include "base/quantity.h"
#include "base/text.h"
#include "ground/record.h"

struct thud_synthesis {
    double peak_mps2; /* of the whole; the noise is scaled to reach it, the pulse keeps its amplitude */
    double pulse_amplitude_mps, pulse_period_s, pulse_cycles, pulse_phase_deg, pulse_time_s; /* A, Tp, gamma, nu, t0 */
    double ground_frequency_hz, ground_damping;                                              /* Kanai-Tajimi */
    double cut_frequency_hz, cut_damping;                                                    /* Clough-Penzien */
    double rise_s, hold_s, decay_ps; /* envelope: (t/rise)^2, then 1 until hold, then exp(-decay (t - hold)) */
    double duration_s, dt_s;
    double seed; /* a whole number below 2^53 */
};

/* Table of parameters, in the order of the struct: it feeds options, comment lines and checks. */
struct thud_synthesis_param {
    const char *name, *help;
    enum thud_dimension dimension; /* THUD_NUMBER with unit "Hz", "deg", "1/s" for what quantities do not know */
    const char *unit;
    double scale; /* shown value times scale is the field */
    size_t offset;
    double least, most; /* of the shown value, both allowed */
};
extern const struct thud_synthesis_param thud_synthesis_params[];
extern const size_t thud_synthesis_param_count;

/* Fills in usual values, without a pulse. */
void thud_synthesis_init(struct thud_synthesis *synthesis);
double *thud_synthesis_field(struct thud_synthesis *synthesis, const struct thud_synthesis_param *param);

/* Computes a surrogate, with samples that are whole multiples of 1e-8 m/s2, so a text of them is short and the same
 * everywhere. Errors: THUD_INPUT with the key (out of range, pulse outside the duration or above the peak),
 * THUD_MEMORY. */
enum thud_status thud_synthesis_run(const struct thud_synthesis *synthesis, struct thud_record **out,
                                    struct thud_error *err);

/* Writes every parameter as a line `name: value unit` after `prefix`. */
void thud_synthesis_describe(const struct thud_synthesis *synthesis, const char *prefix, struct thud_text *text);
