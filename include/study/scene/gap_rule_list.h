/* The rules for the gap. A row of a rule has its word in enum thud_gap_rule_id, name, column, clause or reference,
 * edition of the code, title, and source if not the text of the code. The formula in letters and in numbers, why it may
 * have no value, and the meaning of its column follow. Last is its value for a level `l`, m (NaN: it does not apply).
 * THUD_RULE: a column of narrow tables; THUD_RULE_CODE: the others. A new rule goes last. */
#if !defined THUD_RULE && !defined THUD_RULE_CODE
struct thud_gap_level; /* the header alone says no more than this */
#endif
#ifndef THUD_RULE
#define THUD_RULE(...)
#endif
#ifndef THUD_RULE_CODE
#define THUD_RULE_CODE(...)
#endif

THUD_RULE(THUD_GAP_ABS, "ABS", "abs_m", "", "", "sum of the displacements", "", "uL + uR", "$l + $r cm", "",
          "Sum of the two peak displacements, m.", thud_gap_abs(l))
THUD_RULE(THUD_GAP_SRSS, "SRSS", "srss_m", "", "", "root of the sum of squares", "", "sqrt(uL^2 + uR^2)",
          "sqrt($l^2 + $r^2) cm", "", "Root of the sum of their squares (SRSS), m.", thud_gap_srss(l))
THUD_RULE(THUD_GAP_DDC, "DDC", "ddc_m", "Jeng et al. (1992)", "", "double difference", "",
          "sqrt(uL^2 + uR^2 - 2 rho uL uR)", "sqrt($l^2 + $r^2 - 2 x $p x $l x $r) cm",
          "storeys yield, and rho is that of elastic periods",
          "Double difference combination, m; no value where storeys yield.",
          thud_spacing_ddc(l->left_m, l->right_m, l->correlation))
/* and (2)(b) where (3) does not reduce it */
THUD_RULE(THUD_GAP_EN1998, "EN 1998", "en1998_m", "4.4.2.7(3)", THUD_EN1998, "k 0.7 or 1", "", "k q sqrt(uL^2 + uR^2)",
          "$k x $q x sqrt($l^2 + $r^2) cm", "", "Gap required by EN 1998-1 4.4.2.7, m.",
          thud_gap_reduction(l) * l->code.q * thud_gap_srss(l))
THUD_RULE(THUD_GAP_ASCE7, "ASCE 7", "asce7_m", "12.12.3", THUD_ASCE7, "between buildings", "",
          "(Cd/Ie) sqrt(uL^2 + uR^2)", "$c x sqrt($l^2 + $r^2) cm", "", "Gap required by ASCE 7-16 12.12.3, m.",
          l->code.cd *thud_gap_srss(l))

THUD_RULE_CODE(THUD_GAP_EN1998_OWNERS, "EN (2)(a)", "en1998_2a_m", "4.4.2.7(2)(a)", THUD_EN1998, "two owners", "",
               "q uL + q uR", "$q x $l + $q x $r cm", "",
               "Gap by EN 1998-1 4.4.2.7(2)(a), two owners, m; only by thud gap.", l->code.q *thud_gap_abs(l))
THUD_RULE_CODE(THUD_GAP_EN1998_UNITS, "EN (2)(b)", "en1998_2b_m", "4.4.2.7(2)(b)", THUD_EN1998, "one owner", "",
               "q sqrt(uL^2 + uR^2)", "$q x sqrt($l^2 + $r^2) cm", "",
               "Gap by EN 1998-1 4.4.2.7(2)(b), one owner, m; only by thud gap.", l->code.q *thud_gap_srss(l))
THUD_RULE_CODE(THUD_GAP_ASCE7_LINE, "ASCE line", "asce7_line_m", "12.12.3", THUD_ASCE7, "property line", "",
               "(Cd/Ie) uL + (Cd/Ie) uR", "$c x $l + $c x $r cm", "",
               "Sum of both setbacks by ASCE 7 12.12.3, m; only by thud gap.", l->code.cd *thud_gap_abs(l))
THUD_RULE_CODE(THUD_GAP_TBDY, "TBDY", "tbdy2018_m", "4.9.3", "TBDY 2018", "Turkey", THUD_SECOND_HAND,
               "max(a (R/I) sqrt(uL^2 + uR^2), 3 cm, 3 cm + 1 cm (h - 6 m)/3 m)",
               "max($a x $R x sqrt($l^2 + $r^2), 3, 3 + ($h - 6)/3) cm", "a height is not known",
               "Gap by TBDY 2018 4.9.3, m; only by thud gap.",
               isnan(l->height_m) ? NAN
                                  : fmax(thud_gap_alpha(l) * l->code.r * thud_gap_srss(l),
                                         0.03 + 0.01 * fmax(0, (l->height_m - 6) / 3)))
THUD_RULE_CODE(THUD_GAP_GB50011, "GB 50011", "gb50011_m", "6.1.4", "GB 50011-2010", "China, frames", THUD_SECOND_HAND,
               "max(10 cm, 10 cm + 2 cm (H - 15 m)/(11 - intensity))", "max(10, 10 + 2 x ($H - 15)/(11 - $I)) cm",
               "the design intensity (6 to 9) or a height is not given",
               "Gap by GB 50011 6.1.4, m; only by thud gap; no value without its intensity.",
               isnan(l->lower_m) || isnan(l->code.intensity)
                   ? NAN
                   : 0.1 + 0.02 * fmax(0, (l->lower_m - 15) / (11 - l->code.intensity)))
THUD_RULE_CODE(THUD_GAP_E030, "E.030", "e030_m", "joints between buildings", "E.030", "Peru", THUD_SECOND_HAND,
               "max(2/3 (uL + uR), 0.006 h, 3 cm)", "max(2/3 x ($l + $r), 0.006 x 100 x $h, 3) cm",
               "a height is not known", "Gap by E.030, m; only by thud gap.",
               isnan(l->height_m) ? NAN : fmax(fmax(2.0 / 3 * thud_gap_abs(l), 0.006 * l->height_m), 0.03))

#undef THUD_RULE
#undef THUD_RULE_CODE
