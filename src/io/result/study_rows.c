#include "io/result/study_rows.h"

#include "base/statistics.h"

#define RULE(member, key, text) THUD_FIELD(struct thud_gap_rule_row, member, key, text)
static const struct thud_column rules[] = {
    RULE(interface, "interface", "Number of the interface."),
    RULE(rule.name, "rule", "Name of the rule."),
    RULE(rule.column, "column", "Column of the rule in needed-gaps.csv."),
    RULE(rule.edition, "edition", "Edition of the code; empty: the rule is not from a code."),
    RULE(rule.clause, "clause", "Clause of the code, or the reference."),
    RULE(rule.title, "title", "Short description of the rule."),
    RULE(rule.source, "source", "Source of the rule, if not the text of the code itself."),
    RULE(rule.formula, "formula",
         "Formula in symbols: uL and uR displacements, h height of the level, H of the lower building."),
    RULE(numbers, "numbers", "Formula with its numbers, cm."),
    RULE(found.level.left_floor, "left_floor", "Floor of the left structure at the governing level."),
    RULE(found.level.right_floor, "right_floor", "Floor of the right structure at the governing level."),
    RULE(found.gap_m, "gap_m", "Gap required by the rule, m."),
    RULE(found.pounding, "pounding", "Number of ground motions with contact at that gap without the bumper."),
    RULE(motions, "motions", "Number of ground motions in all."),
    RULE(found.force_n, "force_n", "Peak force of those runs, N.")};
const struct thud_schema thud_gap_rule_schema = THUD_SCHEMA(
    "gap-rules.csv",
    "Written by\n.Cm gap Fl o :\none row for each interface and rule with a value there, the required gap first.\n",
    rules);

#define MOTION(member, key, text, ...)                                                                                 \
    THUD_FIELD_WITH(struct thud_motion_row, member, key, text, .shown = {__VA_ARGS__})
#define GENERAL THUD_DIGITS_FREE
static const struct thud_column motions[] = {
    MOTION(record.file, "file", "Path of the file.", 0),
    MOTION(record.event, "event", "Earthquake, as stated in the file.", 0),
    MOTION(record.station, "station", "Station, as stated in the file.", 0),
    MOTION(record.component, "component", "Component, as stated in the file.", 0),
    MOTION(record.dt_s, "dt_s", "Time step, s.", "step", "s", 1, 7, 4, GENERAL),
    MOTION(duration_s, "duration_s", "Duration, s.", "length", "s", 1, 7, 4, GENERAL),
    MOTION(pga_mps2, "pga_mps2", "Peak ground acceleration after scaling, m/s2.", "PGA", "g", 1 / THUD_GRAVITY, 7, 3,
           GENERAL),
    MOTION(pgv_mps, "pgv_mps", "Peak ground velocity after scaling, m/s.", "PGV", "m/s", 1, 7, 3, GENERAL),
    MOTION(arias_mps, "arias_mps", "Arias intensity after scaling, m/s.", "Arias", "m/s", 1, 7, 3, GENERAL),
    MOTION(misfit, "misfit", "Root mean square of ln(target/Sa) with the motion scaled individually.", "misfit", "", 1,
           7, 2, GENERAL),
    MOTION(factor, "factor", "Total factor on the samples of the file.", "factor", "", 1, 8, 3, GENERAL),
    THUD_STANDS_FOR("sa_N_mps2", "Spectral acceleration for each building of --preset after scaling, m/s2."),
    THUD_STANDS_FOR("period_N_s", "Period of that spectral acceleration, s."),
    MOTION(chosen, "chosen", "Whether the motion is selected.", 0),
    MOTION(why, "why", "Reason why the motion is not selected.", 0)};
const struct thud_schema thud_motion_schema =
    THUD_SCHEMA("motions.csv",
                "Written by\n.Cm thud suite :\none row for each ground motion.\n.Fl -json\nhas the same, with the "
                "marked periods as the list\n.Va sa .\nIt adds the target, the common factor, the range of periods, "
                "the least ratio of\nmean and target with its period, the mean peak, and the target at T = 0.\n"
                "It ends with the\n.Va remarks .\n",
                motions);

#define KEY(member, name, text) THUD_FIELD(struct thud_curve_key, member, name, text)
static const struct thud_column keys[] = {
    KEY(event, "event", "Event, as specified."), KEY(which, "case", "Case."),
    KEY(against, "against", "Key against which the curve is drawn."),
    THUD_STANDS_FOR(
        "KEY",
        "Value of each varied key in the files, with its unit as in record.sa_mps2; empty for the curve's own key.")};
const struct thud_schema thud_curve_key_schema =
    THUD_SCHEMA("fragility",
                "First columns of\n.Pa fragility.csv\nand\n.Pa fragility-curves.csv ,\nand members of each curve in\n"
                ".Pa fragility.json .\n",
                keys);

#define STRIPE(member, text) THUD_FIELD(struct thud_stripe_row, member, #member, text)
static const struct thud_column stripes[] = {
    STRIPE(motions, "Number of ground motions with a result."),
    STRIPE(count, "Number of those motions that show the event."),
    STRIPE(share, "Fraction of those motions that show the event."),
    STRIPE(share_low, "Lower end of the 90 % band of the fraction (Wilson; both signs of a motion count as one); "
                      "empty: fewer than three independent motions."),
    STRIPE(share_high, "Upper end of the band of the fraction."),
    STRIPE(fitted, "Probability from the fitted curve; empty: there is none."),
    STRIPE(fitted_low, "Lower end of the bootstrapped 90 % band of the curve; empty: none, as with fewer than seven "
                       "independent motions."),
    STRIPE(fitted_high, "Upper end of the band of the curve.")};
const struct thud_schema thud_stripe_schema =
    THUD_SCHEMA("fragility.csv",
                "Written by\n.Cm fragility Fl o :\na row for each event, case and setting, behind the columns of\n"
                ".Sx fragility .\n",
                stripes);

#define CURVE(member, key, text) THUD_FIELD(struct thud_curve_row, member, key, text)
static const struct thud_column curves[] = {
    CURVE(beta, "beta", "Standard deviation of the logarithm."),
    CURVE(beta_low, "beta_low", "Lower end of the band of beta."),
    CURVE(beta_high, "beta_high", "Upper end of the band of beta."),
    {THUD_COLUMN(struct thud_curve_row, falling, "falling", "1 if the event becomes rarer as the key grows."),
     .only = THUD_ONLY_CSV},
    CURVE(deviance_p, "deviance_p", "Probability of a deviance at least as large if the curve holds."),
    CURVE(rate[0], "annual_rate",
          "Annual rate of the event, with --hazard; empty: there are only bounds, or nothing is known."),
    CURVE(rate[3], "annual_rate_low", "16 % fractile of the rate, by bootstrap over the motions; empty: no band."),
    CURVE(rate[4], "annual_rate_high", "84 % fractile of the rate by the same bootstrap."),
    CURVE(rate[1], "annual_rate_least", "Lower bound of the rate from the range of the hazard curve."),
    CURVE(rate[2], "annual_rate_most", "Upper bound of the rate; empty: no bound."),
    CURVE(probability[0], "probability_50_years", "Probability of at least one event in 50 years."),
    CURVE(probability[3], "probability_50_years_low", "Probability in 50 years at the 16 % fractile of the rate."),
    CURVE(probability[4], "probability_50_years_high", "Probability in 50 years at the 84 % fractile of the rate."),
    CURVE(probability[1], "probability_50_years_least", "Lower bound of the probability in 50 years."),
    CURVE(probability[2], "probability_50_years_most", "Upper bound of the probability in 50 years.")};
const struct thud_schema thud_curve_schema =
    THUD_SCHEMA("fragility-curves.csv of each curve",
                "Behind the medians in\n.Pa fragility-curves.csv ,\nand in\n.Pa fragility.json .\n", curves);

#define FIRST(member, key, text) THUD_FIELD(struct thud_first_contact_row, member, key, text)
static const struct thud_column first_contacts[] = {
    FIRST(record, "record", "Ground motion, as specified."),
    FIRST(first, "first_contact_factor",
          "Smallest factor on the motion that causes contact, to 1 part in 1e6; no value: none up to 1000."),
    FIRST(clear_again, "clear_again_factor",
          "Larger factor without contact again; no value: none up to twice the first, or 1.")};
const struct thud_schema thud_first_contact_schema =
    THUD_SCHEMA("first contact",
                "The list\n.Va first_contact\nof a curve of pounding along an intensity in\n.Pa fragility.json :\n"
                "one for each ground motion.\nIf nothing yields, slips or acts on one side only, the factor follows "
                "from one\nrun, otherwise from runs without contact at rising factors.\n",
                first_contacts);

#define TRIED(member, text) THUD_FIELD(struct thud_tried_row, member, #member, text)
static const struct thud_column tried[] = {
    TRIED(value, "Value tried, with its unit."), TRIED(x, "Value tried, in SI units."),
    TRIED(motions, "Number of ground motions with a result; 0: the value is not possible."),
    TRIED(held, "Number of motions under which the criterion holds.")};
const struct thud_schema thud_tried_schema =
    THUD_SCHEMA("solve",
                "Written by\n.Cm thud solve Fl -csv ;\nwith\n.Fl -json\nit is the list\n.Va tried .\nJSON also has the "
                "criterion\n.Va for ,\nthe\n.Va key\nthat may change, and the\n.Va share\nof the ground motions under "
                "which the criterion must be met.\n.Va changes\nis how often the result changes, and\n.Va answer\nis "
                "the value (none: there is no value, or several).\n",
                tried);

#define BEST(member, key, text) THUD_FIELD(struct thud_best_row, member, key, text)
static const struct thud_column bests[] = {
    BEST(record, "record", "Ground motion, as specified; worst of all: the largest over the motions."),
    BEST(which, "case", "Case."),
    THUD_STANDS_FOR("KEY", "Value of each other varied key, with its unit."),
    THUD_STANDS_FOR("bestUNIT", "Best value of the key (smallest ratio), with the unit of its key."),
    BEST(ratio, "acceleration_ratio", "Larger of the structures' mean acceleration ratios at the best value."),
    BEST(drift_ratio, "drift_ratio", "Largest ratio of the mean drifts over the structures at the best value."),
    THUD_STANDS_FOR("flat_fromUNIT", "Smallest value of the key with a ratio within 5 % of the best."),
    THUD_STANDS_FOR("flat_toUNIT", "Largest value of the key with a ratio within 5 % of the best."),
    BEST(worst_ratio, "worst_acceleration_ratio", "Ratio at the worst value of the key."),
    BEST(remark, "remark", "Caution: an end of the range, or a bumper that is hardly struck; empty: none.")};
const struct thud_schema thud_best_schema = THUD_SCHEMA(
    "best.csv", "Written by\n.Cm sweep Fl -best Fl o :\na row for each setting of the other keys.\n", bests);

#define STIFFNESS(member, text) THUD_FIELD(struct thud_stiffness_fields, member, #member, text)
static const struct thud_column stiffnesses[] = {
    STIFFNESS(varied, "Part whose stiffness is multiplied: contact, bumper or link."),
    STIFFNESS(factor, "Factor on the stiffness."),
    STIFFNESS(impacts, "Number of impacts of all contacts."),
    STIFFNESS(force_n, "Peak force of all contacts, N."),
    STIFFNESS(structure, "Name of the structure."),
    STIFFNESS(acceleration_mps2, "Peak acceleration of all floors, m/s2."),
    STIFFNESS(drift_m, "Peak drift of all storeys, m.")};
const struct thud_schema thud_stiffness_schema =
    THUD_SCHEMA("stiffness --csv",
                "A row for each stiffness that is multiplied, factor and structure; with\n.Fl -json\nthe list\n"
                ".Va runs .\n",
                stiffnesses);

#define SPRING(member, text) THUD_FIELD(struct thud_spring_row, member, #member, text)
static const struct thud_column springs[] = {
    SPRING(part, "Part: slab, contact (of slabs in series) or pad."), SPRING(alpha, "Coefficient alpha of a pad."),
    SPRING(exponent, "Exponent of the indentation."), SPRING(stiffness, "Stiffness in N/m^exponent.")};
const struct thud_schema thud_spring_schema =
    THUD_SCHEMA("stiffness --json of slabs and pads", "The list\n.Va springs .\n", springs);

#define MODE(member, text) THUD_COLUMN(struct thud_mode_row, member, #member, text)
static const struct thud_column modes[] = {
    {MODE(structure, "Name of the structure, of a preset or of tables of storeys."), .only = THUD_MODE_OF_SCENE},
    {MODE(mode, "Number of the mode, from 1."), .shown = {"mode", NULL, 0, 4, 0, THUD_DIGITS_WORD}},
    {MODE(period_s, "Period, s."), .shown = {"period", "s", 1, 10, 5, THUD_DIGITS_FREE}},
    {MODE(frequency_hz, "Frequency, Hz."), .shown = {"frequency", "Hz", 1, 13, 5, THUD_DIGITS_FREE}},
    {MODE(mass_kg, "Effective modal mass, kg.")},
    {MODE(mass_ratio, "Effective modal mass over the mass of the building."),
     .shown = {"mass in it", "%", 100, 13, 2, THUD_DIGITS_FIXED}},
    {MODE(mass_ratio_sum, "Sum of the mass ratios up to this mode."),
     .shown = {"of all so far", "%", 100, 16, 2, THUD_DIGITS_FIXED}}};
const struct thud_schema thud_mode_schema = THUD_SCHEMA(
    "building import --csv",
    "A row for each mode; with\n.Fl -json\nthe list\n.Va modes ,\nafter the contents of the file.\n", modes);

#define BUILT(member, text)                      THUD_COLUMN(struct thud_built_row, member, #member, text)
#define SHOWN(head, unit, factor, width, digits) .shown = {head, unit, factor, width, digits, THUD_DIGITS_FREE}
static const struct thud_column built[] = {
    {BUILT(structure, "Name of the structure.")},
    {BUILT(storey, "Number of the storey, from the lowest."), .shown = {"storey", NULL, 0, 6, 0, THUD_DIGITS_WORD}},
    {BUILT(height_m, "Storey height, m."), SHOWN("height", "m", 1, 8, 4)},
    {BUILT(mass_kg, "Mass of the floor above the storey, kg."), SHOWN("mass", "t", 1e-3, 9, 5)},
    {BUILT(stiffness_npm, "Storey stiffness, N/m, cracked if so specified; none for a matrix or modes."),
     SHOWN("k", "MN/m", 1e-6, 9, 5)},
    {BUILT(weight_n, "Weight of that floor and those above, N."), SHOWN("W", "MN", 1e-6, 9, 4)},
    {BUILT(yield_shear_n, "Yield shear, N; none for an elastic storey."), .only = THUD_BUILT_YIELDS,
     SHOWN("V_y", "MN", 1e-6, 9, 4)},
    {BUILT(yield_m, "Yield drift, m."), .only = THUD_BUILT_YIELDS, SHOWN("u_y", "mm", 1e3, 9, 4)},
    {BUILT(yield_ratio, "Yield shear over that weight."), .only = THUD_BUILT_YIELDS, SHOWN("V_y/W", "%", 100, 9, 4)}};
#undef SHOWN
const struct thud_schema thud_built_schema = THUD_SCHEMA(
    "building --csv",
    "A row for each storey, from the lowest, also of imported tables of storeys; with\n.Fl -json\nthe list\n"
    ".Va storeys ,\nbehind the list\n.Va modes\nof all structures.\n",
    built);

#define QUANTITY(member, key, text) THUD_COLUMN(struct thud_quantity_row, member, key, text)
static const struct thud_column quantities[] = {
    {QUANTITY(quantity, "quantity", "Case, structure and measure, joined by dots.")},
    {QUANTITY(which, "case", "Case; empty for a quantity without one, such as the required gap.")},
    {QUANTITY(structure, "structure", "Name of the structure; empty: all contacts.")},
    {QUANTITY(measure, "measure",
              "Column of sweep.csv; force_n is the peak of all contacts; needed_gap_m the required gap of the "
              "governing level, as thud gap reports it.")},
    {QUANTITY(nominal, "nominal", "Value with every input nominal.")},
    {QUANTITY(p5, "p5", "5 % fractile of the samples.")},
    {QUANTITY(median, "median", "Median of the samples.")},
    {QUANTITY(p95, "p95", "95 % fractile of the samples.")},
    {QUANTITY(below_1_share, "below_1_share", "Fraction of the samples below 1, for a ratio.")},
    {QUANTITY(between_motions_share, "between_motions_share",
              "Fraction of the variance between the means of the ground motions, with --records; the rest lies within "
              "motions."),
     .only = THUD_ROW_DRAWN}};
const struct thud_schema thud_quantity_schema =
    THUD_SCHEMA("uncertainty.csv",
                "Written by\n.Cm uncertainty Fl o ,\nand by\n.Fl -csv :\na row for each quantity; with\n.Fl -json\n"
                "the list\n.Va quantities .\n",
                quantities);

#define EFFECT(member, key, text) THUD_COLUMN(struct thud_effect_row, member, key, text)
static const struct thud_column effects[] = {
    {EFFECT(quantity, "quantity", "Quantity, as in uncertainty.csv."), .only = THUD_ONLY_CSV},
    {EFFECT(input, "input", "Name of the input.")},
    {EFFECT(size, "size", "Range of the input.")},
    {EFFECT(of[0], "least", "Quantity with only this input at its least value.")},
    {EFFECT(of[1], "most", "Quantity with only this input at its largest value.")},
    {EFFECT(of[2], "first", "Sobol index of first order; this and the following with --indices."),
     .only = THUD_ROW_INDICES},
    {EFFECT(of[3], "first_low", "Lower end of the 95 % interval of first (bootstrap over rows of indices.csv)."),
     .only = THUD_ROW_INDICES},
    {EFFECT(of[4], "first_high", "Upper end of that interval."), .only = THUD_ROW_INDICES},
    {EFFECT(of[5], "total", "Total Sobol index."), .only = THUD_ROW_INDICES},
    {EFFECT(of[6], "total_low", "Lower end of the 95 % interval of the total index."), .only = THUD_ROW_INDICES},
    {EFFECT(of[7], "total_high", "Upper end of that interval."), .only = THUD_ROW_INDICES}};
const struct thud_schema thud_effect_schema =
    THUD_SCHEMA("effects.csv",
                "Written by\n.Cm uncertainty Fl o :\na row for each quantity and uncertain input; in JSON the list\n"
                ".Va inputs\nof each quantity.\n",
                effects);

#define SAMPLE(member, key, text) THUD_FIELD(struct thud_sample_row, member, key, text)
#define OF_RUN                                                                                                         \
    SAMPLE(which, "case", "Case, as in uncertainty.csv."), SAMPLE(structure, "structure", "Name of the structure."),   \
        SAMPLE(measure, "measure", "Measure, with its unit."), SAMPLE(value, "value", "Value of this run.")
static const struct thud_column of_samples[] = {SAMPLE(sample, "sample", "Sample, as in samples.csv."), OF_RUN};
const struct thud_schema thud_sample_schema = THUD_SCHEMA(
    "sample-results.csv", "Written by\n.Cm uncertainty Fl o :\na row for each sample and quantity.\n", of_samples);
static const struct thud_column of_designs[] = {
    SAMPLE(design, "design",
           "Design: A, first half of samples.csv; B, second half; AB, A with the values of one input from B."),
    SAMPLE(from_b, "from_b", "Input taken from B."), SAMPLE(row, "row", "Row of the design, from 1."), OF_RUN};
const struct thud_schema thud_index_schema =
    THUD_SCHEMA("indices.csv",
                "Written by\n.Cm uncertainty Fl -indices Fl o :\nthe runs on which the indices are based, one row for "
                "each run and\nquantity.\nthud(1) has the estimators, to recompute them.\n",
                of_designs);

/* What is written by column and not from rows: named for the manual and the description of tables. */
static const struct thud_column of_suite[] = {
    THUD_STANDS_FOR("case", "Case."),
    THUD_STANDS_FOR("structure", "Name of the structure."),
    THUD_STANDS_FOR("motions", "Number of ground motions with a result."),
    THUD_STANDS_FOR("pounding", "Number of motions with contact."),
    THUD_STANDS_FOR("amplified", "Number of motions with an acceleration ratio above 1."),
    THUD_STANDS_FOR("MEASURE_p16", "16 % fractile over the motions; empty: fewer than three independent motions."),
    THUD_STANDS_FOR("MEASURE_median", "Median over the ground motions; empty if the structure has none of what is "
                                      "measured: yielding storeys, isolators, columns with a capacity, links."),
    THUD_STANDS_FOR("MEASURE_p84", "84 % fractile over the ground motions."),
    THUD_STANDS_FOR("MEASURE_lower", "Number of motions with a ratio below 1."),
    THUD_STANDS_FOR("MEASURE_equal", "Number of motions with a ratio of 1."),
    THUD_STANDS_FOR("MEASURE_higher", "Number of motions with a ratio above 1."),
    THUD_STANDS_FOR("KEY", "Value of a varied key, with its unit."),
    THUD_STANDS_FOR("collapsed",
                    "Last column: 1 if a storey collapses under at least one motion (with P-Delta), else 0. The "
                    "fractiles of peaks then include values up to a collapse, and there are no ratios.")};
const struct thud_schema thud_suite_row_schema =
    THUD_SCHEMA("suite.csv",
                "Written by\n.Cm sweep\nand\n.Cm fragility\nwith\n.Fl o\nover several ground motions: one row for each "
                "setting, case and structure.\n.Va KEY\nrepresents every varied key, in SI units and with its unit, "
                "after the case, and\n.Va MEASURE\neach of the\n.Em measures\nof suite.csv.\nThe fractiles are those "
                "of the logarithms where every value is positive.\n",
                of_suite);

static const struct thud_column medians[] = {
    THUD_STANDS_FOR("fit", "Result of the fit. curve: a lognormal curve. separated: the counts go from none to all, so "
                           "the likelihood has no maximum. rejected: the deviance rejects a curve at 5 %, or its "
                           "direction is wrong. counted: the event need not be monotonic in the key, so no curve is "
                           "fitted. never, always: under no motion or under all. none: fewer than two values."),
    THUD_STANDS_FOR("thetaUNIT", "Median of the curve; empty: no curve, or the median lies outside the values."),
    THUD_STANDS_FOR("theta_lowUNIT", "Lower end of its bootstrapped 90 % band; empty: none, or outside the values."),
    THUD_STANDS_FOR("theta_highUNIT", "Upper end of the band of theta."),
    THUD_STANDS_FOR("median_aboveUNIT", "Lower bound of the median if there is no theta; empty: not known."),
    THUD_STANDS_FOR("median_belowUNIT", "Upper bound of the median if there is no theta."),
    THUD_STANDS_FOR("exact_p16UNIT", "Intensity of first contact for at least 16 % of the motions, or the gap "
                                     "sufficient for as many, without a fit; empty: other events, or never."),
    THUD_STANDS_FOR("exact_medianUNIT", "Intensity or gap for at least half of the motions, without a fit."),
    THUD_STANDS_FOR("exact_p84UNIT", "Intensity or gap for at least 84 % of the motions, without a fit."),
    THUD_STANDS_FOR("exact_median_lowUNIT", "Lower end of the bootstrapped 90 % band of exact_median."),
    THUD_STANDS_FOR("exact_median_highUNIT", "Upper end of the band of exact_median.")};
const struct thud_schema thud_median_schema =
    THUD_SCHEMA("fragility-curves.csv",
                "Written by\n.Cm fragility Fl o :\nthe results of each event and case, between the columns of\n.Sx "
                "fragility\nand of\n.Sx fragility-curves.csv of each curve .\n.Va theta\nand the medians end with "
                "their SI unit,\n.Va UNIT\n(_m, _mps2, nothing for a number);\neach unit along which there are curves "
                "has its columns.\n",
                medians);

static const struct thud_column drawn[] = {
    THUD_STANDS_FOR("sample", "Number of the sample, from 1."),
    THUD_STANDS_FOR("INPUT", "Position of the input within its range, from 0 to 1; the ground motion by name.")};
const struct thud_schema thud_drawn_schema =
    THUD_SCHEMA("samples.csv", "Written by\n.Cm uncertainty Fl o :\na row for each sample.\n", drawn);

#define FRACTILE(member, key, text) THUD_FIELD(struct thud_fractiles, member, key, text)
static const struct thud_column of_rules[] = {
    FRACTILE(p16, "p16",
             "Smallest gap sufficient for at least 16 % of the motions, m; empty: fewer than three independent ones."),
    FRACTILE(median, "median", "Smallest gap sufficient for at least half of the motions, m."),
    FRACTILE(p84, "p84", "Smallest gap sufficient for at least 84 % of the motions, m."),
    FRACTILE(most, "largest", "Largest gap over the motions, m."),
    FRACTILE(share, "falls_short_share", "Fraction of the motions that require more than the rule gives.")};
const struct thud_schema thud_gap_fractile_schema = THUD_SCHEMA("gap --json of each rule", "", of_rules);

#define RANGE(member, text) THUD_FIELD(struct thud_gap_range, member, #member, text)
static const struct thud_column ranges[] = {
    RANGE(interface, "Number of the interface."),
    RANGE(least_m, "Smallest required gap over all motions at one of the periods, m."),
    RANGE(most_m, "Largest required gap over all motions at one of the periods, m."),
    RANGE(left_factor, "Factor on the estimated period of the left building at that gap; no value if not estimated."),
    RANGE(right_factor, "Factor on the estimated period of the right building at that gap.")};
const struct thud_schema thud_gap_range_schema = THUD_SCHEMA("gap --json of periods", "", ranges);

#define ROW(member, text) THUD_FIELD(struct thud_gap_row_fields, member, #member, text)
static const struct thud_column rows_of_row[] = {
    ROW(interface, "Number of the interface."),
    ROW(others_as_given_m, "Smallest gap without contact over all motions while the others keep their gaps and "
                           "bumpers, m; no value where a storey collapses."),
    ROW(all_together_m, "Gap of the set with which no interface has contact, m.")};
const struct thud_schema thud_gap_row_schema = THUD_SCHEMA("gap --json of a row", "", rows_of_row);

#define USED(member, text) THUD_FIELD(struct thud_used_motion_row, member, #member, text)
static const struct thud_column used[] = {USED(name, "Name in figures."),
                                          USED(file, "Path of the file, as specified."),
                                          USED(file_peak_mps2, "Peak acceleration in the file, m/s2."),
                                          USED(scale, "Factor on the motion."),
                                          USED(peak_mps2, "Peak acceleration as used, m/s2."),
                                          USED(dt_s, "Time step, s."),
                                          USED(samples, "Number of samples."),
                                          USED(synthetic, "Whether the motion is computed, not recorded.")};
const struct thud_schema thud_used_motion_schema = THUD_SCHEMA("figures study.json of motions", "", used);
