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
                             "\"%.*s\" is not a factor of a code", (int)(n < 60 ? n : 60), word);
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
static double thud_gap_reduction(const struct thud_gap_level *level)
{
    return level->aligned ? 0.7 : 1;
}

/* alpha over R/I of TBDY 2018, 4.9.3 */
static double thud_gap_alpha(const struct thud_gap_level *level)
{
    return level->aligned ? 0.25 : 0.5;
}

static double thud_gap_abs(const struct thud_gap_level *l)
{
    return thud_spacing_abs(l->left_m, l->right_m);
}

static double thud_gap_srss(const struct thud_gap_level *l)
{
    return thud_spacing_srss(l->left_m, l->right_m);
}

static double by_motion(const struct thud_gap_level *l)
{
    return l->relative_displacement_m;
}

#define THUD_RULE(id, name, column, clause, edition, title, source, formula, numbers, lacks, text, value)              \
    static double by_##id(const struct thud_gap_level *l)                                                              \
    {                                                                                                                  \
        return value;                                                                                                  \
    }
#define THUD_RULE_CODE THUD_RULE
#include "study/scene/gap_rule_list.h"

#define THUD_SECOND_HAND "from secondary sources; check the clause"
#define THUD_EN1998      "EN 1998-1:2004"
#define THUD_ASCE7       "ASCE/SEI 7-16"

static const struct thud_gap_rule rules[THUD_GAP_RULES + 1] = {
    {"needed", "relative_displacement_m", "", "", "largest relative displacement", "", "max(uL(t) - uR(t))", "", "",
     by_motion},
#define THUD_RULE(id, name, column, clause, edition, title, source, formula, numbers, lacks, text, value)              \
    {name, column, clause, edition, title, source, formula, numbers, lacks, by_##id},
#define THUD_RULE_CODE THUD_RULE
#include "study/scene/gap_rule_list.h"
};

const struct thud_gap_rule *thud_gap_rule_at(int rule)
{
    return &rules[rule + 1];
}

const struct thud_gap_practice *thud_gap_practice_find(const char *name)
{
    static const struct thud_gap_practice practice[] = {
        {"en1998", THUD_GAP_EN1998, false}, {"asce7", THUD_GAP_ASCE7, false}, {"exact84", THUD_GAP_EXACT, true}};
    for (size_t i = 0; i < sizeof practice / sizeof *practice; i++) {
        const size_t n = strlen(practice[i].name);
        if (strncmp(name, practice[i].name, n) == 0 && (!name[n] || name[n] == '-'))
            return &practice[i];
    }
    return NULL;
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
                  {'k', "%g", thud_gap_reduction(level)},
                  {'a', "%g", thud_gap_alpha(level)},
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
