/* Values of a group of keys as its table describes them: their defaults and bounds. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "study/scene/scene_slot.h"

void thud_place_clear(const struct thud_param *param, const struct thud_place *place, void *at)
{
    switch (place->store) {
    case THUD_STORE_NUMBER:
        *(double *)at = place->optional ? 0 : place->absent == THUD_REQUIRED ? param->fallback : place->absent;
        break;
    case THUD_STORE_COUNT:
        *(int *)at = place->none;
        break;
    case THUD_STORE_SIGN:
        *(int *)at = 1;
        break;
    case THUD_STORE_SWITCH:
        *(bool *)at = param->fallback == 1;
        break;
    case THUD_STORE_TEXT:
        memset(at, 0, place->size);
        snprintf(at, place->size, "%s", place->usual ? place->usual : "");
        break;
    case THUD_STORE_FLOORS:
        *(double *)at = place->optional ? 0 : param->fallback;
        break;
    case THUD_STORE_LEVELS:
        *(struct thud_by_level *)at = (struct thud_by_level){0};
        break;
    default: /* what it belongs to is made with it */
        break;
    }
}

void thud_group_clear(void *of, enum thud_group group, unsigned kinds)
{
    const struct thud_place *place;
    for (int i = 0; (place = thud_group_place(group, i)); i++)
        if (!place->kinds || place->kinds & kinds)
            thud_place_clear(thud_group_param(group, i), place, (char *)of + place->offset);
}

static enum thud_status missing(const struct thud_param *param, struct thud_error *err, const char *key)
{
    const char *units = param->kind == THUD_PARAM_QUANTITY ? thud_dimension_units(param->dimension) : "";
    thud_error_set(err, THUD_INPUT, "%s is not given", param->title);
    if (*units)
        thud_error_allow(err, "%s in %s", thud_dimension_name(param->dimension), units);
    thud_error_key(err, "%s", key);
    return THUD_INPUT;
}

bool thud_value_fits(const struct thud_param *param, double value)
{
    return !isnan(value) && thud_param_check(param, value, "", NULL) == THUD_OK;
}

enum thud_status thud_value_check(const struct thud_param *param, double value, const char *key, struct thud_error *err)
{
    char text[96];
    if (thud_value_fits(param, value))
        return THUD_OK;
    if (isnan(value))
        return missing(param, err, key);
    thud_quantity_format(value, param->unit, text, sizeof text);
    enum thud_status status = thud_param_check(param, value, text, err);
    if (status != THUD_OK)
        thud_error_key(err, "%s", key);
    return status;
}

enum thud_status thud_group_check(const void *of, enum thud_group group, unsigned kind, int storeys, bool given,
                                  const char *prefix, struct thud_error *err)
{
    const struct thud_param *param;
    for (int i = 0; (param = thud_group_param(group, i)); i++) {
        const struct thud_place *place = thud_group_place(group, i);
        const double *value = (const double *)(const void *)((const char *)of + place->offset);
        const int n = place->store == THUD_STORE_FLOORS ? storeys : place->store == THUD_STORE_NUMBER;
        for (int floor = 0; floor < n && place->kinds & 1u << kind; floor++) {
            char key[96];
            const bool lacks = place->optional ? value[floor] == 0
                                               : place->store == THUD_STORE_NUMBER && place->absent != THUD_REQUIRED &&
                                                     (!given || isnan(value[floor]));
            if (lacks || thud_value_fits(param, value[floor]))
                continue;
            snprintf(key, sizeof key, n > 1 && !isnan(value[floor]) ? "%s.%s.%d" : "%s.%s", prefix, param->name,
                     floor + 1);
            return thud_value_check(param, value[floor], key, err);
        }
    }
    return THUD_OK;
}
