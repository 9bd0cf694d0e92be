#include "base/param.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void in_unit(const struct thud_param *param, double value, char *text, size_t size)
{
    double factor = param->unit && *param->unit ? thud_unit_factor(param->unit, NULL, NULL) : 1;
    if (factor > 0)
        thud_quantity_format(value, param->unit, text, size);
    else
        thud_quantity_format(value, "", text, size);
}

/* "> 0, up to 1e6 t" from two bounds; NaN: none. */
static void range(const struct thud_param *param, double least, bool least_open, double most, bool most_open,
                  char *text, size_t size)
{
    char low[64] = "", high[64] = "";
    in_unit(param, least, low, sizeof low);
    in_unit(param, most, high, sizeof high);
    bool has_low = !isnan(least), has_high = !isnan(most);
    if (has_low && has_high && !least_open && !most_open)
        snprintf(text, size, "%s to %s", low, high);
    else if (has_low && has_high)
        snprintf(text, size, "%s %s, %s %s", least_open ? ">" : "at least", low, most_open ? "<" : "up to", high);
    else if (has_low)
        snprintf(text, size, "%s %s", least_open ? ">" : "at least", low);
    else if (has_high)
        snprintf(text, size, "%s %s", most_open ? "<" : "up to", high);
    else
        snprintf(text, size, "%s", "");
}

void thud_param_allowed(const struct thud_param *param, char *text, unsigned long size)
{
    if (size == 0)
        return;
    text[0] = '\0';
    if (param->kind == THUD_PARAM_QUANTITY || param->kind == THUD_PARAM_INTEGER)
        range(param, param->least, param->least_open, param->most, param->most_open, text, size);
    for (int i = 0; param->kind != THUD_PARAM_TEXT && param->choices && param->choices[i]; i++)
        thud_append(text, size, "%s%s", *text ? ", " : "", param->choices[i]);
}

enum thud_status thud_param_check(const struct thud_param *param, double value, const char *text,
                                  struct thud_error *err)
{
    bool low = param->least_open ? value <= param->least : value < param->least;
    bool high = param->most_open ? value >= param->most : value > param->most;
    if (!low && !high)
        return THUD_OK;
    char allowed[200];
    thud_param_allowed(param, allowed, sizeof allowed);
    return thud_error_refuse(err, THUD_INPUT, NULL, allowed, "%.80s is too %s", text, low ? "small" : "large");
}

bool thud_param_unusual(const struct thud_param *param, double value, char *text, unsigned long size)
{
    if (!(value < param->soft_least) && !(value > param->soft_most))
        return false;
    range(param, param->soft_least, false, param->soft_most, false, text, size);
    return true;
}

int thud_param_choice(const struct thud_param *param, const char *word)
{
    for (int i = 0; param->choices[i]; i++)
        if (strcmp(param->choices[i], word) == 0)
            return i;
    return -1;
}
