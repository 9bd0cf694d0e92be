/* The chosen law: its values by default, and quantities whose unit carries its exponent. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "study/scene/scene_slot.h"

void thud_law_choice_init(struct thud_law_choice *choice, const struct thud_law *law)
{
    struct thud_law_setup setup = {0};
    memset(choice, 0, sizeof *choice);
    thud_law_defaults(law, &setup);
    choice->law = law;
    memcpy(choice->value, setup.value, sizeof setup.value);
}

double *thud_law_given(struct thud_law_choice *choice, const char *name)
{
    const int i = choice->law ? thud_law_param(choice->law, name) : -1;
    return i < 0 || isnan(choice->value[i]) ? NULL : &choice->value[i];
}

double thud_law_exponent(const struct thud_law_choice *choice, const struct thud_param *param)
{
    if (!choice || !choice->law || param->dimension != THUD_POWER_STIFFNESS)
        return NAN;
    int i = thud_law_param(choice->law, "exponent");
    double exponent = NAN;
    if (i >= 0)
        return choice->value[i];
    thud_unit_factor(param->unit, NULL, &exponent);
    return exponent;
}

void thud_unit_with_exponent(const char *unit, double exponent, char *text, size_t size)
{
    char number[32];
    thud_number_format(exponent, number, sizeof number);
    snprintf(text, size, "%.*s^%s", (int)strcspn(unit, "^"), unit, number);
}

static enum thud_status check_exponent(const struct thud_law_choice *choice, const struct thud_param *param,
                                       const char *text, double typed, struct thud_error *err)
{
    double wanted = thud_law_exponent(choice, param);
    if (isnan(wanted) || typed == wanted)
        return THUD_OK;
    char a[32], b[32], unit[64];
    thud_number_format(typed, a, sizeof a);
    thud_number_format(wanted, b, sizeof b);
    thud_unit_with_exponent(param->unit, wanted, unit, sizeof unit);
    thud_error_set(err, THUD_INPUT, "the unit of \"%.80s\" has the exponent %s, the law's exponent is %s", text, a, b);
    thud_error_allow(err, "a number of %s", unit);
    return THUD_INPUT;
}

enum thud_status thud_quantity_read(const struct thud_param *param, const struct thud_law_choice *choice,
                                    const char *text, double *out, struct thud_error *err)
{
    struct thud_quantity q;
    enum thud_status status = thud_quantity_parse(text, param->dimension, NULL, &q, err);
    if (status == THUD_OK && param->dimension == THUD_POWER_STIFFNESS)
        status = check_exponent(choice, param, text, q.exponent, err);
    if (status == THUD_OK)
        status = thud_param_check(param, q.value, text, err);
    if (status == THUD_OK)
        *out = q.value;
    return status;
}
