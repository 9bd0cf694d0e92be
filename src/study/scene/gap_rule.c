/* A rule is a row of `rules`: its clause, its formula in letters and in numbers, and its value. */
#include "study/scene/gap_rule.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "study/scene/spacing.h"

#define FACTOR(name_, title_, help_)                                                                                   \
    {                                                                                                                  \
        .name = name_, .title = title_, .help = help_, .kind = THUD_PARAM_QUANTITY, .dimension = THUD_NUMBER,          \
        .unit = "", .fallback = 1, .least = 0, .least_open = true, .most = 100, .soft_least = NAN, .soft_most = NAN    \
    }
const struct thud_param thud_gap_code_params[THUD_GAP_CODE_PARAMS] = {
    FACTOR("q", "displacement behaviour factor", "q of EN 1998-1 4.3.4, by which displacements are multiplied."),
    FACTOR("cd", "Cd/Ie", "Cd/Ie of ASCE 7-16 12.12.3, by which displacements are multiplied."),
    FACTOR("r", "R/I", "R/I of TBDY 2018 4.9.3, by which displacements are multiplied."),
    {.name = "intensity",
     .title = "fortification intensity",
     .help = "Fortification intensity of GB 50011 in degrees, which its joint widens with.",
     .kind = THUD_PARAM_QUANTITY,
     .dimension = THUD_NUMBER,
     .unit = "",
     .fallback = NAN,
     .least = 6,
     .most = 9,
     .soft_least = NAN,
     .soft_most = NAN},
};

static double *field(struct thud_gap_code *code, int i)
{
    double *const fields[THUD_GAP_CODE_PARAMS] = {&code->q, &code->cd, &code->r, &code->intensity};
    return fields[i];
}

void thud_gap_code_init(struct thud_gap_code *code)
{
    for (int i = 0; i < THUD_GAP_CODE_PARAMS; i++)
        *field(code, i) = thud_gap_code_params[i].fallback;
}

static enum thud_status set_one(struct thud_gap_code *code, const char *word, size_t n, struct thud_error *err)
{
    char text[64];
    struct thud_quantity q;
    if (n < sizeof text) {
        memcpy(text, word, n);
        text[n] = '\0';
        char *sign = strchr(text, '=');
        for (int i = 0; sign && i < THUD_GAP_CODE_PARAMS; i++) {
            const struct thud_param *p = &thud_gap_code_params[i];
            if (strlen(p->name) != (size_t)(sign - text) || strncmp(text, p->name, (size_t)(sign - text)) != 0)
                continue;
            if (thud_quantity_parse(sign + 1, p->dimension, NULL, &q, NULL) != THUD_OK ||
                thud_param_check(p, q.value, sign + 1, NULL) != THUD_OK)
                break;
            *field(code, i) = q.value;
            return THUD_OK;
        }
    }
    return thud_error_refuse(err, THUD_USAGE, "--code",
                             "q, cd (Cd/Ie), r (R/I): above 0, up to 100; intensity (GB 50011): 6 to 9; e.g. "
                             "q=1.5,intensity=8",
                             "\"%.*s\" is no factor of a code", (int)(n < 60 ? n : 60), word);
}

enum thud_status thud_gap_code_set(struct thud_gap_code *code, const char *text, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (const char *end = NULL; status == THUD_OK && text; text = end) {
        end = strchr(text, ',');
        status = set_one(code, text, end ? (size_t)(end - text) : strlen(text), err);
        end = end ? end + 1 : NULL;
    }
    return status;
}

/* EN 1998-1:2004, 4.4.2.7(3) */
static double reduction(const struct thud_gap_level *level)
{
    return level->aligned ? 0.7 : 1;
}

/* alpha over R/I of TBDY 2018, 4.9.3 */
static double alpha(const struct thud_gap_level *level)
{
    return level->aligned ? 0.25 : 0.5;
}

static double by_abs(const struct thud_gap_level *l)
{
    return thud_spacing_abs(l->left_m, l->right_m);
}

static double by_srss(const struct thud_gap_level *l)
{
    return thud_spacing_srss(l->left_m, l->right_m);
}

static double by_ddc(const struct thud_gap_level *l)
{
    return thud_spacing_ddc(l->left_m, l->right_m, l->correlation);
}

static double by_en1998(const struct thud_gap_level *l)
{
    return reduction(l) * l->code.q * by_srss(l);
}

static double by_en1998_owners(const struct thud_gap_level *l)
{
    return l->code.q * by_abs(l);
}

static double by_en1998_units(const struct thud_gap_level *l)
{
    return l->code.q * by_srss(l);
}

static double by_asce7(const struct thud_gap_level *l)
{
    return l->code.cd * by_srss(l);
}

static double by_asce7_line(const struct thud_gap_level *l)
{
    return l->code.cd * by_abs(l);
}

static double by_tbdy(const struct thud_gap_level *l)
{
    double least = 0.03 + 0.01 * fmax(0, (l->height_m - 6) / 3);
    return isnan(l->height_m) ? NAN : fmax(alpha(l) * l->code.r * by_srss(l), least);
}

static double by_gb50011(const struct thud_gap_level *l)
{
    if (isnan(l->lower_m) || isnan(l->code.intensity))
        return NAN;
    return 0.1 + 0.02 * fmax(0, (l->lower_m - 15) / (11 - l->code.intensity));
}

static double by_e030(const struct thud_gap_level *l)
{
    return isnan(l->height_m) ? NAN : fmax(fmax(2.0 / 3 * by_abs(l), 0.006 * l->height_m), 0.03);
}

static double by_motion(const struct thud_gap_level *l)
{
    return l->relative_displacement_m;
}

#define SECOND_HAND "second-hand; read the clause"
#define EN1998      "EN 1998-1:2004"
#define ASCE7       "ASCE/SEI 7-16"
static const char no_height[] = "a height is not known";

static const struct thud_gap_rule rules[THUD_GAP_RULES + 1] = {
    {"needed", "relative_displacement_m", "", "", "largest relative displacement", "", "max(uL(t) - uR(t))", "", "",
     by_motion},
    {"ABS", "abs_m", "", "", "sum of the displacements", "", "uL + uR", "$l + $r cm", "", by_abs},
    {"SRSS", "srss_m", "", "", "root of the sum of squares", "", "sqrt(uL^2 + uR^2)", "sqrt($l^2 + $r^2) cm", "",
     by_srss},
    {"DDC", "ddc_m", "Jeng et al. (1992)", "", "double difference", "", "sqrt(uL^2 + uR^2 - 2 rho uL uR)",
     "sqrt($l^2 + $r^2 - 2 x $p x $l x $r) cm", "storeys yield, and rho is that of elastic periods", by_ddc},
    {"EN 1998", "en1998_m", "4.4.2.7(3)", EN1998, "equal floors", "", "k q sqrt(uL^2 + uR^2)",
     "$k x $q x sqrt($l^2 + $r^2) cm", "", by_en1998},
    {"ASCE 7", "asce7_m", "12.12.3", ASCE7, "between buildings", "", "(Cd/Ie) sqrt(uL^2 + uR^2)",
     "$c x sqrt($l^2 + $r^2) cm", "", by_asce7},
    {"EN (2)(a)", "en1998_2a_m", "4.4.2.7(2)(a)", EN1998, "two owners", "", "q uL + q uR", "$q x $l + $q x $r cm", "",
     by_en1998_owners},
    {"EN (2)(b)", "en1998_2b_m", "4.4.2.7(2)(b)", EN1998, "one owner", "", "q sqrt(uL^2 + uR^2)",
     "$q x sqrt($l^2 + $r^2) cm", "", by_en1998_units},
    {"ASCE line", "asce7_line_m", "12.12.3", ASCE7, "property line", "", "(Cd/Ie) uL + (Cd/Ie) uR",
     "$c x $l + $c x $r cm", "", by_asce7_line},
    {"TBDY", "tbdy2018_m", "4.9.3", "TBDY 2018", "Turkey", SECOND_HAND,
     "max(a (R/I) sqrt(uL^2 + uR^2), 3 cm, 3 cm + 1 cm (h - 6 m)/3 m)",
     "max($a x $R x sqrt($l^2 + $r^2), 3, 3 + ($h - 6)/3) cm", no_height, by_tbdy},
    {"GB 50011", "gb50011_m", "6.1.4", "GB 50011-2010", "China, frames", SECOND_HAND,
     "max(10 cm, 10 cm + 2 cm (H - 15 m)/(11 - intensity))", "max(10, 10 + 2 x ($H - 15)/(11 - $I)) cm",
     "the design intensity (6 to 9) or a height is not given", by_gb50011},
    {"E.030", "e030_m", "joints between buildings", "E.030", "Peru", SECOND_HAND, "max(2/3 (uL + uR), 0.006 h, 3 cm)",
     "max(2/3 x ($l + $r), 0.006 x 100 x $h, 3) cm", no_height, by_e030},
};

const struct thud_gap_rule *thud_gap_rule_at(int rule)
{
    return &rules[rule + 1];
}

double thud_gap_value(const struct thud_gap_level *level, int rule)
{
    return rules[rule + 1].value(level);
}

void thud_gap_numbers(const struct thud_gap_level *level, int rule, struct thud_text *out)
{
    const struct thud_gap_code *code = &level->code;
    const struct {
        char letter;
        const char *format;
        double value;
    } number[] = {{'l', "%.3f", 100 * level->left_m},
                  {'r', "%.3f", 100 * level->right_m},
                  {'p', "%.3g", level->correlation},
                  {'k', "%g", reduction(level)},
                  {'a', "%g", alpha(level)},
                  {'q', "%g", code->q},
                  {'c', "%g", code->cd},
                  {'R', "%g", code->r},
                  {'I', "%g", code->intensity},
                  {'h', "%g", level->height_m},
                  {'H', "%g", level->lower_m}};
    for (const char *s = rules[rule + 1].numbers; *s; s++) {
        size_t i = 0;
        while (*s == '$' && i < sizeof number / sizeof *number && number[i].letter != s[1])
            i++;
        if (*s != '$' || i == sizeof number / sizeof *number) {
            thud_text_bytes(out, s, 1);
            continue;
        }
        char text[32];
        snprintf(text, sizeof text, number[i].format, number[i].value);
        thud_text_append(out, "%s", text);
        s++;
    }
}
