/* What several laws share: described parameters, and restitution and energy of plain curves. */
#pragma once

#include <math.h>

#include "core/laws/law.h"

#define THUD_KN_PER_MM   1e6
#define THUD_KN_PER_MM15 31622776.601683792 /* kN/mm^1.5 in N/m^1.5 */

/* clang-format off */
#define THUD_PARAM_STIFFNESS                                                                        \
    {.name = "stiffness", .title = "contact stiffness",                                             \
     .help = "Force per indentation of the contact.",                                               \
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_STIFFNESS, .unit = "kN/mm",                     \
     .fallback = 2500 * THUD_KN_PER_MM, .least = 0, .most = NAN, .least_open = true,                \
     .soft_least = 100 * THUD_KN_PER_MM, .soft_most = 10000 * THUD_KN_PER_MM}

/* The paper has none: 2.75e9 N/m^1.5, by which Jankowski (2005) fits concrete striking concrete. */
#define THUD_HERTZ_STIFFNESS (87 * THUD_KN_PER_MM15)
#define THUD_PARAM_HERTZ_STIFFNESS                                                                  \
    {.name = "stiffness", .title = "contact stiffness",                                             \
     .help = "Force at an indentation of 1 mm; the exponent is part of the unit.",                  \
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_POWER_STIFFNESS, .unit = "kN/mm^1.5",           \
     .fallback = THUD_HERTZ_STIFFNESS, .least = 0, .most = NAN, .least_open = true,                \
     .soft_least = NAN, .soft_most = NAN}

/* above_0: 0, the plastic impact, is refused */
#define THUD_PARAM_RESTITUTION_OF(value, above_0, words)                                            \
    {.name = "restitution", .title = "coefficient of restitution", .help = (words),                 \
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_NUMBER, .unit = "",                             \
     .fallback = (value), .least = 0, .most = 1, .least_open = (above_0),                           \
     .soft_least = 0.3, .soft_most = 0.95}
#define THUD_PARAM_RESTITUTION(value)                                                               \
    THUD_PARAM_RESTITUTION_OF(value, true, "Separation over approach velocity of two free bodies.")

#define THUD_PARAM_ONE_OF(name_, title_, words, first, choices_)                                    \
    {.name = (name_), .title = (title_), .help = (words),                                           \
     .kind = THUD_PARAM_CHOICE, .dimension = THUD_NUMBER, .unit = "", .fallback = (first),          \
     .least = NAN, .most = NAN, .soft_least = NAN, .soft_most = NAN, .choices = (choices_)}
#define THUD_PARAM_DAMPING                                                                          \
    THUD_PARAM_ONE_OF("damping", "damping from restitution",                                        \
                      "paper: the published formula; exact: the bodies really part with the restitution.", \
                      THUD_DAMPING_PAPER, thud_damping_choices)

#define THUD_PARAM_EXPONENT(value)                                                                  \
    {.name = "exponent", .title = "exponent n",                                                     \
     .help = "Power of the indentation in the force.",                                              \
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_NUMBER, .unit = "",                             \
     .fallback = (value), .least = 1, .most = 6, .soft_least = 1.5, .soft_most = 4}

#define THUD_PARAM_SPEED_FLOOR                                                                      \
    {.name = "speed-floor", .title = "least impact speed",                                          \
     .help = "Lower bound of the approach velocity by which the damping divides.",  \
     .kind = THUD_PARAM_QUANTITY, .dimension = THUD_VELOCITY, .unit = "mm/s",                       \
     .fallback = 1e-3, .least = 0, .most = 1, .least_open = true,                                   \
     .soft_least = 1e-5, .soft_most = 1e-2}
/* clang-format on */

enum { THUD_DAMPING_PAPER, THUD_DAMPING_EXACT };
extern const char *const thud_damping_choices[];

/* THUD_INPUT where the exponent is not the 1.5 that the default of THUD_PARAM_HERTZ_STIFFNESS is for, and no other
 * value was given. */
enum thud_status thud_law_check_hertz_stiffness(double stiffness, double exponent, struct thud_error *err);
/* nominal and restitution of a law that loses nothing. */
double thud_law_nominal_one(const struct thud_law_setup *setup);
double thud_law_restitution_one(const struct thud_law_setup *setup, double v_mps);
/* Energy under K d^p. */
double thud_law_power_energy(double K, double p, double d_m);
/* elastic_energy of laws whose first parameter is the stiffness k of a line k d; and of those that have an exponent n as
 * their second, k d^n. */
double thud_law_energy_line(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m);
double thud_law_energy_power(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m);
/* branch of laws with that line and a dashpot, whose first constant is its c: F = k d + c v. */
struct thud_branch thud_law_branch_viscoelastic(const struct thud_law_setup *setup,
                                                const struct thud_law_memory *memory, enum thud_phase phase,
                                                bool past_ultimate);
