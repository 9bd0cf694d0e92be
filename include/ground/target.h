/* Design spectra for comparing and scaling ground motions: pseudo spectral acceleration against period. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"
#include "ground/record.h"

enum thud_target_kind {
    THUD_TARGET_NONE,
    THUD_TARGET_EN1998,
    THUD_TARGET_ASCE7,
    THUD_TARGET_ASCE7_22,
    THUD_TARGET_GB50011,
    THUD_TARGET_NZS1170,
    THUD_TARGET_POINTS
};
enum { THUD_TARGET_POINTS_MAX = 400, THUD_TARGET_TEXT = 160 };
#define THUD_TARGET_ALLOWED                                                                                            \
    "en1998:0.3g,B, asce7:SDS=1g,SD1=0.6g,TL=8s, asce7-22:TABLE.csv, gb50011:AMAX=0.9,TG=0.45s, nzs1170:Z=0.4,C, or "  \
    "a "                                                                                                               \
    "CSV"

struct thud_target {
    enum thud_target_kind kind;
    char text[THUD_TARGET_TEXT];     /* as typed; a file's name */
    char file[THUD_TARGET_TEXT];     /* of the points of ASCE 7-22 */
    double damping;                  /* of the spectrum; 0.05 by default */
    double ag_mps2;                  /* EN 1998-1: a_g, and type 0 (1) or 1 (2) */
    int type, ground;                /* ground type or site class, 0: A to 4: E */
    double sds_mps2, sd1_mps2, tl_s; /* ASCE 7-16; TL of ASCE 7-22 too */
    double alpha_max, tg_s;          /* GB 50011: alpha_max in units of gravity */
    double z, r;                     /* NZS 1170.5 */
    int n;                           /* points, periods rising */
    double period_s[THUD_TARGET_POINTS_MAX], sa_mps2[THUD_TARGET_POINTS_MAX];
};

/* Requirements of the code of a spectrum on motions scaled to it (from secondary sources): the least number of motions,
 * and the number at which the mean of the results may replace the largest (0: never). */
struct thud_target_code {
    const char *name, *allowed;
    int least, mean;
    const char *clause, *remark; /* of the numbers; further requirement to check, or NULL */
};
/* Returns those of a target; of NULL, or of points without a code, EN 1998-1's numbers. */
const struct thud_target_code *thud_target_code(const struct thud_target *target);

/* Writes the target as typed with EN 1998-1's values of its ground: "en1998:0.3g,B (S = 1.2, T_B = 0.15 s, ...)". */
void thud_target_words(const struct thud_target *target, char *text, size_t size);

/* Reads a code's spectrum such as "en1998:0.3g,B", as its code's `allowed` states; points of ASCE 7-22 are read by
 * thud_target_read. Errors: THUD_INPUT with what is allowed. */
enum thud_status thud_target_parse(const char *text, struct thud_target *out, struct thud_error *err);
/* Returns whether a text names a code's spectrum instead of a file. */
bool thud_target_is_code(const char *text);

/* Gives the range of periods in which it is defined. */
void thud_target_range(const struct thud_target *target, double *from_s, double *to_s);
/* Returns Sa at a period (0: the peak ground acceleration), between points linear on logarithmic axes (ASCE 7-22: on
 * linear ones); NaN outside its range. */
double thud_target_sa(const struct thud_target *target, double period_s);

/* Number of periods at which a motion is compared with a target. */
enum { THUD_TARGET_PERIODS = 40 };
/* Fills in periods from `from_s` to `to_s` in geometric steps (count > 1). */
void thud_target_periods(double from_s, double to_s, size_t count, double *period_s);
/* Computes the pseudo spectral acceleration of a motion at each period (0: its peak). */
void thud_target_motion(const struct thud_record *record, double damping, const double *period_s, size_t count,
                        double *sa_mps2);
/* Returns the factor with which the Sa of a motion fits the target best, by least squares of the logarithms over the
 * periods. *misfit: root mean square residual. */
double thud_target_factor(const double *target_mps2, const double *sa_mps2, size_t count, double *misfit);
