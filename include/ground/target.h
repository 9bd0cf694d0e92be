/* Design spectra that ground motions are held against and scaled to: pseudo spectral acceleration against period. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"
#include "ground/record.h"

enum thud_target_kind { THUD_TARGET_NONE, THUD_TARGET_EN1998, THUD_TARGET_ASCE7, THUD_TARGET_POINTS };
enum { THUD_TARGET_POINTS_MAX = 400, THUD_TARGET_TEXT = 160 };

struct thud_target {
    enum thud_target_kind kind;
    char text[THUD_TARGET_TEXT]; /* as typed; a file's name */
    double damping;              /* of the spectrum; 0.05 unless said */
    /* EN 1998-1 3.2.2.2: a_g S, the corner periods of table 3.2 (type 1) or 3.3 (type 2), and eta */
    double plateau_mps2; /* a_g S */
    double tb_s, tc_s, td_s, eta;
    /* ASCE 7-16 11.4.6 */
    double sds_mps2, sd1_mps2, tl_s;
    int n; /* points, periods rising */
    double period_s[THUD_TARGET_POINTS_MAX], sa_mps2[THUD_TARGET_POINTS_MAX];
};

/* "en1998:0.3g,B" (a_g, ground A to E; then `type2`, and the damping, `8 %`, where they are not type 1 and 5 %) or
 * "asce7:SDS=1.0g,SD1=0.6g,TL=8s" (design spectrum; SD1 is S_D1, an acceleration at 1 s). Errors: THUD_INPUT with what
 * is allowed. */
enum thud_status thud_target_parse(const char *text, struct thud_target *out, struct thud_error *err);
/* Whether a text names a code's spectrum, and not a file. */
bool thud_target_is_code(const char *text);

/* Sa at a period (0: the peak ground acceleration); between points straight on logarithmic axes, NaN outside them. */
double thud_target_sa(const struct thud_target *target, double period_s);

/* Over so many periods of its range a motion is held against a target. */
enum { THUD_TARGET_PERIODS = 40 };
/* Periods from `from_s` to `to_s` in geometric steps (count > 1). */
void thud_target_periods(double from_s, double to_s, size_t count, double *period_s);
/* Pseudo spectral acceleration of a motion at each period (a period of 0: its peak). */
void thud_target_motion(const struct thud_record *record, double damping, const double *period_s, size_t count,
                        double *sa_mps2);
/* The factor that brings a motion's Sa nearest to the target's, by least squares of the logarithms over the periods; and
 * what then remains of them, root mean square, in *misfit. */
double thud_target_factor(const double *target_mps2, const double *sa_mps2, size_t count, double *misfit);
