#include "io/result/study_rows.h"

#include "base/statistics.h"

#define RULE(member, key, text) THUD_FIELD(struct thud_gap_rule_row, member, key, text)
static const struct thud_column rules[] = {
    RULE(interface, "interface", "Interface."),
    RULE(rule.name, "rule", "Its name."),
    RULE(rule.column, "column", "Its name in needed-gaps.csv."),
    RULE(rule.edition, "edition", "Of the code; empty: a rule of no code."),
    RULE(rule.clause, "clause", "Of the code, or the reference."),
    RULE(rule.title, "title", "In a few words."),
    RULE(rule.source, "source", "Where the rule was written from, if not from the text itself."),
    RULE(rule.formula, "formula",
         "In letters: uL and uR displacements, h height of the level, H of the lower building."),
    RULE(numbers, "numbers", "The same in numbers, cm."),
    RULE(found.level.left_floor, "left_floor", "Floor of the left structure where the rule asks for most."),
    RULE(found.level.right_floor, "right_floor", "Floor of the right structure."),
    RULE(found.gap_m, "gap_m", "What it asks for, m."),
    RULE(found.pounding, "pounding", "Ground motions in which the floors collide at that gap without the bumper."),
    RULE(motions, "motions", "Of how many."),
    RULE(found.force_n, "force_n", "Largest force of those runs, N.")};
const struct thud_schema thud_gap_rule_schema = THUD_SCHEMA(
    "gap-rules.csv",
    "Written by\n.Cm gap Fl o :\na row for each interface and rule that has a value there, what is needed first.\n",
    rules);

#define MOTION(member, key, text, ...)                                                                                 \
    THUD_FIELD_WITH(struct thud_motion_row, member, key, text, .shown = {__VA_ARGS__})
#define GENERAL THUD_DIGITS_FREE
static const struct thud_column motions[] = {
    MOTION(record.file, "file", "Where it was read.", 0),
    MOTION(record.event, "event", "As the file says.", 0),
    MOTION(record.station, "station", "As the file says.", 0),
    MOTION(record.component, "component", "As the file says.", 0),
    MOTION(record.dt_s, "dt_s", "Step, s.", "step s", NULL, 1, 7, 4, GENERAL),
    MOTION(duration_s, "duration_s", "Length, s.", "length s", NULL, 1, 10, 4, GENERAL),
    MOTION(pga_mps2, "pga_mps2", "Peak acceleration once scaled, m/s2.", "PGA g", NULL, 1 / THUD_GRAVITY, 9, 3,
           GENERAL),
    MOTION(pgv_mps, "pgv_mps", "Peak velocity once scaled, m/s.", "PGV m/s", NULL, 1, 9, 3, GENERAL),
    MOTION(arias_mps, "arias_mps", "Arias intensity once scaled, m/s.", "Arias m/s", NULL, 1, 11, 3, GENERAL),
    MOTION(misfit, "misfit", "Root mean square of ln(target/Sa) once the motion is scaled alone.", "misfit", NULL, 1, 8,
           2, GENERAL),
    MOTION(factor, "factor", "What the samples of the file are multiplied by in all.", "factor", NULL, 1, 10, 3,
           GENERAL),
    THUD_STANDS_FOR("sa_N_mps2", "For each building of --preset its spectral acceleration once scaled, m/s2."),
    THUD_STANDS_FOR("period_N_s", "At this period, s."),
    MOTION(chosen, "chosen", "Whether it is.", 0),
    MOTION(why, "why", "Why not.", 0)};
const struct thud_schema thud_motion_schema =
    THUD_SCHEMA("motions.csv",
                "Written by\n.Cm thud suite :\none row for each ground motion.\n.Fl -json\nhas the same, with the "
                "marked periods as the list\n.Va sa .\nIt adds the target, the common factor, the range of periods, "
                "the least ratio of\nmean and target with its period, the mean peak, and the target at T = 0.\n"
                "It ends with the\n.Va remarks .\n",
                motions);

#define KEY(member, name, text) THUD_FIELD(struct thud_curve_key, member, name, text)
static const struct thud_column keys[] = {
    KEY(event, "event", "Event, as asked for."), KEY(which, "case", "Case."),
    KEY(against, "against", "The key that it is drawn against."),
    THUD_STANDS_FOR(
        "KEY",
        "In the files: value of each varied key, with its unit as in record.sa_mps2; of a curve empty for its own.")};
const struct thud_schema thud_curve_key_schema =
    THUD_SCHEMA("fragility",
                "First columns of\n.Pa fragility.csv\nand\n.Pa fragility-curves.csv ,\nand members of each curve in\n"
                ".Pa fragility.json .\n",
                keys);

#define STRIPE(member, text) THUD_FIELD(struct thud_stripe_row, member, #member, text)
static const struct thud_column stripes[] = {
    STRIPE(motions, "Ground motions with a result."),
    STRIPE(count, "Of those, how many show the event."),
    STRIPE(share, "Share that they are."),
    STRIPE(share_low, "Lower end of its 90 % band (Wilson; both signs of a motion count as one); empty: fewer than "
                      "three independent motions."),
    STRIPE(share_high, "Its upper end."),
    STRIPE(fitted, "Probability by the fitted curve; empty: there is none."),
    STRIPE(fitted_low,
           "Lower end of its bootstrapped 90 % band; empty: none, as with fewer than seven independent motions."),
    STRIPE(fitted_high, "Its upper end.")};
const struct thud_schema thud_stripe_schema =
    THUD_SCHEMA("fragility.csv",
                "Written by\n.Cm fragility Fl o :\na row for each event, case and setting, behind the columns of\n"
                ".Sx fragility .\n",
                stripes);

#define CURVE(member, key, text) THUD_FIELD(struct thud_curve_row, member, key, text)
static const struct thud_column curves[] = {
    CURVE(beta, "beta", "Standard deviation of the logarithm."),
    CURVE(beta_low, "beta_low", "Lower end of its band."),
    CURVE(beta_high, "beta_high", "Its upper end."),
    {THUD_COLUMN(struct thud_curve_row, falling, "falling", "1 where the event gets rarer as the key grows."),
     .only = THUD_ONLY_CSV},
    CURVE(deviance_p, "deviance_p", "How likely a deviance as large would be if the curve held."),
    CURVE(rate[0], "annual_rate",
          "Of the event, a year, with --hazard; empty: there are bounds only, or nothing is known."),
    CURVE(rate[3], "annual_rate_low", "16 % of its bootstrap over the ground motions; empty: no band."),
    CURVE(rate[4], "annual_rate_high", "84 % of it."),
    CURVE(rate[1], "annual_rate_least", "At least, by the range of the hazard curve."),
    CURVE(rate[2], "annual_rate_most", "At most; empty: no bound."),
    CURVE(probability[0], "probability_50_years", "Of at least one in 50 years."),
    CURVE(probability[3], "probability_50_years_low", "By the 16 % of the rate."),
    CURVE(probability[4], "probability_50_years_high", "By the 84 % of the rate."),
    CURVE(probability[1], "probability_50_years_least", "At least."),
    CURVE(probability[2], "probability_50_years_most", "At most.")};
const struct thud_schema thud_curve_schema =
    THUD_SCHEMA("fragility-curves.csv of each curve",
                "Behind the medians in\n.Pa fragility-curves.csv ,\nand in\n.Pa fragility.json .\n", curves);

#define FIRST(member, key, text) THUD_FIELD(struct thud_first_contact_row, member, key, text)
static const struct thud_column first_contacts[] = {
    FIRST(record, "record", "Ground motion, as specified."),
    FIRST(first, "first_contact_factor",
          "Smallest factor on it at which there is contact, to a part in 1e6; no value: none up to 1000."),
    FIRST(clear_again, "clear_again_factor",
          "A larger factor at which there is none again; no value: none up to twice the first, or 1.")};
const struct thud_schema thud_first_contact_schema =
    THUD_SCHEMA("first contact",
                "The list\n.Va first_contact\nof a curve of pounding along an intensity in\n.Pa fragility.json :\n"
                "one for each ground motion.\nWhere nothing yields, slips or acts on one side the factor follows from "
                "one\nrun, else from runs without contact at rising factors.\n",
                first_contacts);

#define TRIED(member, text) THUD_FIELD(struct thud_tried_row, member, #member, text)
static const struct thud_column tried[] = {
    TRIED(value, "Value that was tried, with its unit."), TRIED(x, "The same in SI units."),
    TRIED(motions, "Ground motions with an answer; 0: the value is not possible."),
    TRIED(held, "Under how many of them the criterion holds.")};
const struct thud_schema thud_tried_schema =
    THUD_SCHEMA("solve",
                "Written by\n.Cm thud solve Fl -csv ;\nwith\n.Fl -json\nit is the list\n.Va tried .\nJSON also has the "
                "criterion\n.Va for ,\nthe\n.Va key\nthat may change, and the\n.Va share\nof the ground motions under "
                "which the criterion must be met.\n.Va changes\nis how often the result changes, and\n.Va answer\nis "
                "the value (none: there is no value, or several).\n",
                tried);

#define BEST(member, key, text) THUD_FIELD(struct thud_best_row, member, key, text)
static const struct thud_column bests[] = {
    BEST(record, "record", "Ground motion, as specified; worst of all for the largest over them."),
    BEST(which, "case", "Case."),
    THUD_STANDS_FOR("KEY", "Value of each other varied key, with its unit."),
    THUD_STANDS_FOR("bestUNIT", "Value with the smallest ratio, with the unit of its key."),
    BEST(ratio, "acceleration_ratio", "The larger of the structures' mean acceleration ratios there."),
    BEST(drift_ratio, "drift_ratio", "Largest over the structures of the ratio of the mean drifts, there."),
    THUD_STANDS_FOR("flat_fromUNIT", "Smallest value within 5 % of it."),
    THUD_STANDS_FOR("flat_toUNIT", "Largest one."),
    BEST(worst_ratio, "worst_acceleration_ratio", "Ratio at the worst value of the key."),
    BEST(remark, "remark", "What to beware of: an end of the range, a bumper that is hardly struck; empty: nothing.")};
const struct thud_schema thud_best_schema = THUD_SCHEMA(
    "best.csv", "Written by\n.Cm sweep Fl -best Fl o :\na row for each setting of the other keys.\n", bests);

#define STIFFNESS(member, text) THUD_FIELD(struct thud_stiffness_fields, member, #member, text)
static const struct thud_column stiffnesses[] = {
    STIFFNESS(varied, "contact, bumper or link: whose stiffness is multiplied."),
    STIFFNESS(factor, "By how much."),
    STIFFNESS(impacts, "Impacts of all contacts."),
    STIFFNESS(force_n, "Their largest force, N."),
    STIFFNESS(structure, "Name of the structure."),
    STIFFNESS(acceleration_mps2, "The largest of its floors, m/s2."),
    STIFFNESS(drift_m, "The largest of its storeys, m.")};
const struct thud_schema thud_stiffness_schema =
    THUD_SCHEMA("stiffness --csv",
                "A row for each stiffness that is multiplied, factor and structure; with\n.Fl -json\nthe list\n"
                ".Va runs .\n",
                stiffnesses);

#define SPRING(member, text) THUD_FIELD(struct thud_spring_row, member, #member, text)
static const struct thud_column springs[] = {SPRING(part, "slab, contact (of slabs in series) or pad."),
                                             SPRING(alpha, "Of a pad."), SPRING(exponent, "Of the indentation."),
                                             SPRING(stiffness, "In N/m^exponent.")};
const struct thud_schema thud_spring_schema =
    THUD_SCHEMA("stiffness --json of slabs and pads", "The list\n.Va springs .\n", springs);

#define MODE(member, text) THUD_COLUMN(struct thud_mode_row, member, #member, text)
static const struct thud_column modes[] = {
    {MODE(structure, "Name of its structure, of a preset or of tables of storeys."), .only = THUD_MODE_OF_SCENE},
    {MODE(mode, "Its number, from 1."), .shown = {"mode", NULL, 0, 4, 0, THUD_DIGITS_WORD}},
    {MODE(period_s, "Period, s."), .shown = {"period", "s", 1, 10, 5, THUD_DIGITS_FREE}},
    {MODE(frequency_hz, "Frequency, Hz."), .shown = {"frequency", "Hz", 1, 13, 5, THUD_DIGITS_FREE}},
    {MODE(mass_kg, "Mass that moves in it, kg.")},
    {MODE(mass_ratio, "The same over that of the building."),
     .shown = {"mass in it", "%", 100, 13, 2, THUD_DIGITS_FIXED}},
    {MODE(mass_ratio_sum, "Of this mode and those before it."),
     .shown = {"of all so far", "%", 100, 16, 2, THUD_DIGITS_FIXED}}};
const struct thud_schema thud_mode_schema =
    THUD_SCHEMA("building import --csv",
                "A row for each mode; with\n.Fl -json\nthe list\n.Va modes ,\nbehind what the file holds.\n", modes);

#define BUILT(member, text)                      THUD_COLUMN(struct thud_built_row, member, #member, text)
#define SHOWN(head, unit, factor, width, digits) .shown = {head, unit, factor, width, digits, THUD_DIGITS_FREE}
static const struct thud_column built[] = {
    {BUILT(structure, "Name of the structure.")},
    {BUILT(storey, "Its number, from the lowest."), .shown = {"storey", NULL, 0, 6, 0, THUD_DIGITS_WORD}},
    {BUILT(height_m, "Height, m."), SHOWN("height", "m", 1, 8, 4)},
    {BUILT(mass_kg, "Mass of the floor above it, kg."), SHOWN("mass", "t", 1e-3, 9, 5)},
    {BUILT(stiffness_npm, "Stiffness, N/m, cracked if it is; none of a matrix or modes."),
     SHOWN("k", "MN/m", 1e-6, 9, 5)},
    {BUILT(weight_n, "Weight of that floor and those above, N."), SHOWN("W", "MN", 1e-6, 9, 4)},
    {BUILT(yield_shear_n, "Shear at which it yields, N; none where it is elastic."), .only = THUD_BUILT_YIELDS,
     SHOWN("V_y", "MN", 1e-6, 9, 4)},
    {BUILT(yield_m, "Drift at which it yields, m."), .only = THUD_BUILT_YIELDS, SHOWN("u_y", "mm", 1e3, 9, 4)},
    {BUILT(yield_ratio, "That shear over that weight."), .only = THUD_BUILT_YIELDS, SHOWN("V_y/W", "%", 100, 9, 4)}};
#undef SHOWN
const struct thud_schema thud_built_schema = THUD_SCHEMA(
    "building --csv",
    "A row for each storey, from the lowest, also of imported tables of storeys; with\n.Fl -json\nthe list\n"
    ".Va storeys ,\nbehind the list\n.Va modes\nof all structures.\n",
    built);

#define QUANTITY(member, key, text) THUD_COLUMN(struct thud_quantity_row, member, key, text)
static const struct thud_column quantities[] = {
    {QUANTITY(quantity, "quantity", "Case, structure and measure, joined by dots.")},
    {QUANTITY(which, "case", "Its case; empty where it belongs to none, as the required gap.")},
    {QUANTITY(structure, "structure", "Name of its structure; empty: of all contacts.")},
    {QUANTITY(measure, "measure",
              "A column of sweep.csv; force_n is the largest of all contacts; needed_gap_m the required gap of the "
              "level that needs most, as thud gap reports it.")},
    {QUANTITY(nominal, "nominal", "Its value with every input nominal.")},
    {QUANTITY(p5, "p5", "5 % of the samples are below.")},
    {QUANTITY(median, "median", "Half of them are.")},
    {QUANTITY(p95, "p95", "95 % of them are.")},
    {QUANTITY(below_1_share, "below_1_share", "Of a ratio: share of the samples below 1.")},
    {QUANTITY(between_motions_share, "between_motions_share",
              "Share of the variance that lies between the means of the ground motions, with --records; the rest lies "
              "within."),
     .only = THUD_ROW_DRAWN}};
const struct thud_schema thud_quantity_schema =
    THUD_SCHEMA("uncertainty.csv",
                "Written by\n.Cm uncertainty Fl o ,\nand by\n.Fl -csv :\na row for each quantity; with\n.Fl -json\n"
                "the list\n.Va quantities .\n",
                quantities);

#define EFFECT(member, key, text) THUD_COLUMN(struct thud_effect_row, member, key, text)
static const struct thud_column effects[] = {
    {EFFECT(quantity, "quantity", "As in uncertainty.csv."), .only = THUD_ONLY_CSV},
    {EFFECT(input, "input", "Its name.")},
    {EFFECT(size, "size", "How far it goes.")},
    {EFFECT(of[0], "least", "The quantity with this input alone at its least.")},
    {EFFECT(of[1], "most", "The same at its most.")},
    {EFFECT(of[2], "first", "Sobol index of first order; this and the following with --indices."),
     .only = THUD_ROW_INDICES},
    {EFFECT(of[3], "first_low", "Lower end of its 95 % interval (bootstrap over the rows of indices.csv)."),
     .only = THUD_ROW_INDICES},
    {EFFECT(of[4], "first_high", "Its upper end."), .only = THUD_ROW_INDICES},
    {EFFECT(of[5], "total", "Total Sobol index."), .only = THUD_ROW_INDICES},
    {EFFECT(of[6], "total_low", "Lower end of its 95 % interval."), .only = THUD_ROW_INDICES},
    {EFFECT(of[7], "total_high", "Its upper end."), .only = THUD_ROW_INDICES}};
const struct thud_schema thud_effect_schema =
    THUD_SCHEMA("effects.csv",
                "Written by\n.Cm uncertainty Fl o :\na row for each quantity and uncertain input; in JSON the list\n"
                ".Va inputs\nof each quantity.\n",
                effects);

#define SAMPLE(member, key, text) THUD_FIELD(struct thud_sample_row, member, key, text)
#define OF_RUN                                                                                                         \
    SAMPLE(which, "case", "As in uncertainty.csv, and so the next two."), SAMPLE(structure, "structure", "Its name."), \
        SAMPLE(measure, "measure", "What it is, with its unit."), SAMPLE(value, "value", "That of this run.")
static const struct thud_column of_samples[] = {SAMPLE(sample, "sample", "As in samples.csv."), OF_RUN};
const struct thud_schema thud_sample_schema = THUD_SCHEMA(
    "sample-results.csv", "Written by\n.Cm uncertainty Fl o :\na row for each sample and quantity.\n", of_samples);
static const struct thud_column of_designs[] = {
    SAMPLE(design, "design",
           "A, the first half of samples.csv; B, the second half; or AB: A with the values of one input from B."),
    SAMPLE(from_b, "from_b", "That input."), SAMPLE(row, "row", "Row of the design, from 1."), OF_RUN};
const struct thud_schema thud_index_schema =
    THUD_SCHEMA("indices.csv",
                "Written by\n.Cm uncertainty Fl -indices Fl o :\nthe runs on which the indices are based, one row for "
                "each run and\nquantity.\nthud(1) has the estimators, to recompute them.\n",
                of_designs);

/* What is written by column and not from rows: named for the manual and the description of tables. */
static const struct thud_column of_suite[] = {
    THUD_STANDS_FOR("case", "Case."),
    THUD_STANDS_FOR("structure", "Name of the structure."),
    THUD_STANDS_FOR("motions", "Ground motions with a result."),
    THUD_STANDS_FOR("pounding", "How many of them make contact."),
    THUD_STANDS_FOR("amplified", "How many of them give an acceleration ratio above 1."),
    THUD_STANDS_FOR("MEASURE_p16", "16 % of the motions are below; empty: fewer than three independent motions."),
    THUD_STANDS_FOR("MEASURE_median",
                    "Half of them are; empty where the structure lacks what is measured: storeys that "
                    "yield, isolators, columns with a capacity, links."),
    THUD_STANDS_FOR("MEASURE_p84", "84 % of them are."),
    THUD_STANDS_FOR("MEASURE_lower", "Of ratios: under how many motions it is below 1."),
    THUD_STANDS_FOR("MEASURE_equal", "Under how many it is 1."),
    THUD_STANDS_FOR("MEASURE_higher", "Under how many it is above 1."),
    THUD_STANDS_FOR("KEY", "Value of a varied key, with its unit."),
    THUD_STANDS_FOR("collapsed", "The last one: 1 where a storey collapses under one of the motions at least (with "
                                 "P-Delta); the fractiles of peaks then hold values until a collapse, and no ratios. "
                                 "Else 0.")};
const struct thud_schema thud_suite_row_schema =
    THUD_SCHEMA("suite.csv",
                "Written by\n.Cm sweep\nand\n.Cm fragility\nwith\n.Fl o\nover several ground motions: one row for each "
                "setting, case and structure.\n.Va KEY\nrepresents every varied key, in SI units and with its unit, "
                "after the case, and\n.Va MEASURE\neach of the\n.Em measures\nof suite.csv.\nThe fractiles are those "
                "of the logarithms where every value is positive.\n",
                of_suite);

static const struct thud_column medians[] = {
    THUD_STANDS_FOR("fit",
                    "curve: a lognormal curve; separated: the counts go from none to all, so the likelihood has no "
                    "maximum; rejected: its deviance rejects a curve at 5 %, or it goes the other way than it "
                    "must; counted: the event need not be monotone in the key, none is tried; never, always: "
                    "under no motion or under all; none: fewer than two values."),
    THUD_STANDS_FOR("thetaUNIT", "Median; empty: no curve, or it lies outside the values."),
    THUD_STANDS_FOR("theta_lowUNIT", "Lower end of its bootstrapped 90 % band; empty: none, or outside the values."),
    THUD_STANDS_FOR("theta_highUNIT", "Its upper end."),
    THUD_STANDS_FOR("median_aboveUNIT", "Without theta: the median lies above this; empty: not known."),
    THUD_STANDS_FOR("median_belowUNIT", "And below this."),
    THUD_STANDS_FOR(
        "exact_p16UNIT",
        "Of pounding, without a fit: the intensity of the first contact of at least 16 % of the motions, or "
        "which gap is enough for as many; empty: other events, or never."),
    THUD_STANDS_FOR("exact_medianUNIT", "The same of at least half of them."),
    THUD_STANDS_FOR("exact_p84UNIT", "And of at least 84 %."),
    THUD_STANDS_FOR("exact_median_lowUNIT", "Lower end of the bootstrapped 90 % band of exact_median."),
    THUD_STANDS_FOR("exact_median_highUNIT", "Its upper end.")};
const struct thud_schema thud_median_schema =
    THUD_SCHEMA("fragility-curves.csv",
                "Written by\n.Cm fragility Fl o :\nthe results of each event and case, between the columns of\n.Sx "
                "fragility\nand of\n.Sx fragility-curves.csv of each curve .\n.Va theta\nand the medians end with "
                "their SI unit,\n.Va UNIT\n(_m, _mps2, nothing for a number);\neach unit along which there are curves "
                "has its columns.\n",
                medians);

static const struct thud_column drawn[] = {
    THUD_STANDS_FOR("sample", "Its number, from 1."),
    THUD_STANDS_FOR("INPUT", "Place within its range, from 0 to 1; the ground motion by name.")};
const struct thud_schema thud_drawn_schema =
    THUD_SCHEMA("samples.csv", "Written by\n.Cm uncertainty Fl o :\na row for each sample.\n", drawn);

#define FRACTILE(member, key, text) THUD_FIELD(struct thud_fractiles, member, key, text)
static const struct thud_column of_rules[] = {
    FRACTILE(p16, "p16",
             "Narrowest that is enough for at least 16 % of the motions, m; empty: fewer than three independent ones."),
    FRACTILE(median, "median", "For at least half of them, m."), FRACTILE(p84, "p84", "For at least 84 %, m."),
    FRACTILE(most, "largest", "Largest, m."),
    FRACTILE(share, "falls_short_share", "Share of the motions for which a rule asks for less than is needed.")};
const struct thud_schema thud_gap_fractile_schema = THUD_SCHEMA("gap --json of each rule", "", of_rules);

#define RANGE(member, text) THUD_FIELD(struct thud_gap_range, member, #member, text)
static const struct thud_column ranges[] = {
    RANGE(interface, "Its number."), RANGE(least_m, "Least required gap over all motions at one of the periods, m."),
    RANGE(most_m, "Widest, m."),
    RANGE(left_factor, "Over the estimated period of the building on the left, where the widest is needed; no value "
                       "where it is not estimated."),
    RANGE(right_factor, "The same of the building on the right.")};
const struct thud_schema thud_gap_range_schema = THUD_SCHEMA("gap --json of periods", "", ranges);

#define ROW(member, text) THUD_FIELD(struct thud_gap_row_fields, member, #member, text)
static const struct thud_column rows_of_row[] = {
    ROW(interface, "Its number."),
    ROW(others_as_given_m, "The gap from which it stays clear while the others keep their gaps and bumpers, over all "
                           "motions, m; no value where a storey collapses."),
    ROW(all_together_m, "At these gaps there is no contact anywhere, m.")};
const struct thud_schema thud_gap_row_schema = THUD_SCHEMA("gap --json of a row", "", rows_of_row);

#define USED(member, text) THUD_FIELD(struct thud_used_motion_row, member, #member, text)
static const struct thud_column used[] = {USED(name, "In figures."),
                                          USED(file, "As it was given."),
                                          USED(file_peak_mps2, "Largest acceleration in the file, m/s2."),
                                          USED(scale, "Factor on it."),
                                          USED(peak_mps2, "Largest acceleration as used, m/s2."),
                                          USED(dt_s, "Step, s."),
                                          USED(samples, "How many."),
                                          USED(synthetic, "Whether it is computed, in place of a recorded one.")};
const struct thud_schema thud_used_motion_schema = THUD_SCHEMA("figures study.json of motions", "", used);
