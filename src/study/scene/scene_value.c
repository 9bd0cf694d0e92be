/* Values of a scene from and to text. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/utf8.h"
#include "core/methods/method.h"
#include "study/scene/building.h"
#include "study/scene/scene_slot.h"
#include "study/scene/scene_words.h"

enum { TEXT_LIMIT = 16384 };

static enum thud_status read_count(const struct thud_param *param, const char *text, int *out, struct thud_error *err)
{
    const char *end;
    double value;
    char allowed[96];
    thud_param_allowed(param, allowed, sizeof allowed);
    int word = param->choices ? thud_param_choice(param, text) : -1;
    if (word >= 0) {
        *out = -1 - word;
        return THUD_OK;
    }
    if (thud_number_parse(text, &end, &value) != 0 || *end || value != floor(value) || fabs(value) > 1e9)
        return thud_error_refuse(err, THUD_INPUT, NULL, allowed, "\"%.80s\" is not a whole number", text);
    enum thud_status status = thud_param_check(param, value, text, err);
    if (status == THUD_OK)
        *out = (int)value;
    return status;
}

static enum thud_status read_choice(const struct thud_param *param, const char *text, int *out, struct thud_error *err)
{
    *out = thud_param_choice(param, text);
    if (*out >= 0)
        return THUD_OK;
    struct thud_words words = {0};
    for (int i = 0; param->choices[i]; i++)
        thud_words_add(&words, param->choices[i]);
    return thud_words_unknown(&words, "choice", text, err);
}

/* What no YAML has as it is: C0 and C1 controls and two code points that are no characters; tags, which YAML has and
 * JSON only as pairs that YAML lacks. With one of them a result's own scene could not be run again. */
static bool is_refused(uint32_t c)
{
    return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0xfffe || c == 0xffff || (c >= 0xe0000 && c <= 0xe007f);
}

static enum thud_status read_text(const struct thud_slot *slot, const char *text, char *out, struct thud_error *err)
{
    size_t length = strlen(text);
    if (length >= slot->place.size) {
        thud_error_set(err, THUD_INPUT, "the text is too long");
        thud_error_allow(err, "at most %zu bytes", slot->place.size - 1);
        return THUD_INPUT;
    }
    for (const char *s = text; *s;) {
        bool valid = thud_utf8_length(s) > 0;
        if (is_refused(thud_utf8_next(&s)) || !valid) {
            thud_error_set(err, THUD_INPUT, "the text has a control character or a byte that is not UTF-8");
            return THUD_INPUT;
        }
    }
    memset(out, 0, slot->place.size);
    memcpy(out, text, length + 1);
    return THUD_OK;
}

static enum thud_status check_method(const char *name, struct thud_error *err)
{
    struct thud_words words = {{"auto"}, 1};
    if (strcmp(name, "auto") == 0 || thud_method_find(name))
        return THUD_OK;
    for (int i = 0; i < thud_method_count(); i++)
        thud_words_add(&words, thud_method_at(i)->name);
    return thud_words_unknown(&words, "method", name, err);
}

/* Takes back a list of floors. */
static bool unset_floors(struct thud_scene *scene, const struct thud_slot *slot)
{
    double *list = thud_slot_at(scene, slot);
    for (int i = 0; i < scene->structure[slot->structure].storeys && slot->place.optional; i++)
        if (slot->floor < 0 || slot->floor == i)
            list[i] = 0;
    return slot->place.optional;
}

/* Takes a value back; false when it must be given. */
static bool unset(struct thud_scene *scene, const struct thud_slot *slot)
{
    switch (slot->place.store) {
    case THUD_STORE_NUMBER:
        if (slot->place.absent == THUD_REQUIRED && isnan(slot->param->fallback) && !slot->choice &&
            !slot->place.optional)
            return false;
        break;
    case THUD_STORE_COUNT:
    case THUD_STORE_SIGN:
    case THUD_STORE_TEXT:
    case THUD_STORE_LEVELS:
        break;
    case THUD_STORE_FLOORS:
        return unset_floors(scene, slot);
    case THUD_STORE_LINK:
        return thud_link_law_set(scene, slot, "", NULL) == THUD_OK;
    default:
        return false;
    }
    thud_place_clear(slot->param, &slot->place, thud_slot_at(scene, slot));
    return true;
}

/* The stiffness keeps its number in the shown unit when its exponent changes: 0.36 kN/mm^2.65 becomes 0.36 kN/mm^2.7.
 */
static void keep_number(const struct thud_law_choice *before, struct thud_law_choice *after)
{
    for (int i = 0; i < before->law->nparams; i++) {
        const struct thud_param *param = &before->law->params[i];
        if (param->dimension != THUD_POWER_STIFFNESS || isnan(before->value[i]))
            continue;
        char unit[64], text[96];
        thud_unit_with_exponent(param->unit, thud_law_exponent(before, param), unit, sizeof unit);
        thud_quantity_format(before->value[i], unit, text, sizeof text);
        double factor_before = thud_unit_factor(unit, NULL, NULL);
        thud_unit_with_exponent(param->unit, thud_law_exponent(after, param), unit, sizeof unit);
        double factor = thud_unit_factor(unit, NULL, NULL);
        struct thud_quantity q;
        snprintf(text + strcspn(text, " "), sizeof text - strcspn(text, " "), " %s", unit);
        if (thud_quantity_parse(text, THUD_POWER_STIFFNESS, NULL, &q, NULL) == THUD_OK)
            after->value[i] = q.value;
        if (fabs(after->value[i] / factor * factor_before / before->value[i] - 1) > 1e-9)
            after->value[i] = before->value[i] / factor_before * factor; /* it was not written in the shown unit */
    }
}

static enum thud_status set_number(struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                                   struct thud_error *err)
{
    struct thud_law_choice *choice =
        slot->choice ? (struct thud_law_choice *)(void *)((char *)scene + slot->choice) : NULL;
    double value;
    enum thud_status status;
    if (slot->param->kind == THUD_PARAM_CHOICE) {
        int which;
        status = read_choice(slot->param, text, &which, err);
        value = which;
    } else
        status = thud_quantity_read(slot->param, choice, text, &value, err);
    if (status != THUD_OK)
        return status;
    bool exponent = choice && choice->law && slot->index == thud_law_param(choice->law, "exponent") &&
                    strcmp(slot->param->name, "exponent") == 0;
    struct thud_law_choice before = {0};
    if (exponent)
        before = *choice;
    *(double *)thud_slot_at(scene, slot) = value;
    if (exponent)
        keep_number(&before, choice);
    return THUD_OK;
}

static enum thud_status set_sign(int *sign, const struct thud_param *param, const char *text, struct thud_error *err)
{
    int which;
    const char *word = strcmp(text, "+1") == 0 || strcmp(text, "1") == 0 ? "+" : strcmp(text, "-1") == 0 ? "-" : text;
    enum thud_status status = read_choice(param, word, &which, err);
    if (status == THUD_OK)
        *sign = which == 0 ? 1 : -1;
    return status;
}

static enum thud_status set(struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                            struct thud_error *err)
{
    void *at = thud_slot_at(scene, slot);
    int which;
    enum thud_status status;
    switch (slot->place.store) {
    case THUD_STORE_NUMBER:
        return set_number(scene, slot, text, err);
    case THUD_STORE_COUNT:
        return read_count(slot->param, text, at, err);
    case THUD_STORE_SIGN:
        return set_sign(at, slot->param, text, err);
    case THUD_STORE_SWITCH:
        status = read_choice(slot->param, text, &which, err);
        if (status == THUD_OK)
            *(bool *)at = which == 1;
        return status;
    case THUD_STORE_TEXT:
        status = slot->place.offset == offsetof(struct thud_scene, analysis.method) ? check_method(text, err) : THUD_OK;
        if (status == THUD_OK && slot->structure >= 0 && at == scene->structure[slot->structure].name) {
            char before[THUD_NAME_MAX];
            memcpy(before, at, sizeof before);
            status = read_text(slot, text, at, err);
            if (status == THUD_OK && *before)
                thud_links_rename(scene, before, at);
            return status;
        }
        return status == THUD_OK ? read_text(slot, text, at, err) : status;
    case THUD_STORE_FLOORS:
        return thud_floors_set(scene, slot, text, err);
    case THUD_STORE_LEVELS:
        return thud_levels_set(at, slot->param, text, err);
    case THUD_STORE_STOREYS:
        status = read_count(slot->param, text, &which, err);
        return status == THUD_OK ? thud_storeys_set(&scene->structure[slot->structure], which) : status;
    case THUD_STORE_KIND:
        status = read_choice(slot->param, text, &which, err);
        return status == THUD_OK ? thud_kind_set(&scene->structure[slot->structure], (enum thud_structure_kind)which)
                                 : status;
    case THUD_STORE_LAW:
        return thud_law_set(scene, slot, text, err);
    case THUD_STORE_LINK:
        return thud_link_law_set(scene, slot, text, err);
    case THUD_STORE_STUDY: /* scene_set.c */
        break;
    }
    return THUD_OK;
}

enum thud_status thud_value_trimmed(const char *text, char **out, struct thud_error *err)
{
    text += strspn(text, " \t");
    size_t length = strlen(text);
    while (length > 0 && (text[length - 1] == ' ' || text[length - 1] == '\t'))
        length--;
    if (length >= TEXT_LIMIT)
        return thud_error_set(err, THUD_INPUT, "the text is too long");
    char *copy = malloc(length + 1);
    if (!copy)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    memcpy(copy, text, length);
    copy[length] = '\0';
    *out = copy;
    return THUD_OK;
}

/* What other keys determine takes no value: masses from area and load, the sum of the stiffnesses from a period. */
static enum thud_status refuse_derived(const struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                                       struct thud_error *err)
{
    const struct thud_structure *s = slot->structure >= 0 ? &scene->structure[slot->structure] : NULL;
    if (!s || !*text)
        return THUD_OK;
    const void *at = thud_slot_in(scene, slot);
    const bool ratios = slot->floor < 0 ? text[0] == '[' : s->storeys > 1;
    if (at == s->mass_kg && s->area_m2 > 0 && s->load_pa[slot->floor < 0 ? 0 : slot->floor] > 0) {
        thud_error_set(err, THUD_INPUT, "area and load of %.40s give the masses of its floors", s->name);
        thud_error_allow(err, "structures.%d.load; or none: structures.%d.load=", slot->structure + 1,
                         slot->structure + 1);
        return THUD_INPUT;
    }
    if (at != s->stiffness_npm || !(s->period_s > 0) || ratios)
        return THUD_OK;
    thud_error_set(err, THUD_INPUT,
                   "the period of %.40s, %.4g s, gives the stiffness of its storeys: one value for all of them has no "
                   "effect",
                   s->name, s->period_s);
    thud_error_allow(err, "structures.%d.period; or none: structures.%d.period=", slot->structure + 1,
                     slot->structure + 1);
    return THUD_INPUT;
}

enum thud_status thud_value_set(struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                                struct thud_error *err)
{
    char *clean = NULL;
    enum thud_status status = thud_value_trimmed(text, &clean, err);
    if (status == THUD_OK)
        status = refuse_derived(scene, slot, clean, err);
    if (status == THUD_OK && (*clean || !unset(scene, slot)))
        status = set(scene, slot, clean, err);
    if (status == THUD_OK && slot->place.reads) {
        scene->structure[slot->structure].shape_rows = 0;
        memset(scene->structure[slot->structure].file_sha256, 0, THUD_SHA256_TEXT);
    }
    if (status == THUD_OK && slot->structure >= 0)
        thud_structure_fill_estimate(&scene->structure[slot->structure]);
    free(clean);
    return status;
}

/* ---- to text ---- */

void thud_slot_unit(const struct thud_scene *scene, const struct thud_slot *slot, const char *unit, char *text,
                    size_t size)
{
    double exponent = thud_law_exponent(thud_slot_law(scene, slot), slot->param);
    unit = unit ? unit : slot->param->unit;
    if (!isnan(exponent))
        thud_unit_with_exponent(unit, exponent, text, size);
    else
        snprintf(text, size, "%s", unit ? unit : "");
}

/* Nothing where a whole list that need not be given is not. */
static void get_floors(const struct thud_slot *slot, const double *value, int n, const char *unit, char *text,
                       size_t size)
{
    bool same = true, lacks = thud_floor_may_lack(slot->param, &slot->place);
    for (int i = 1; i < n; i++)
        same = same && value[i] == value[0];
    if (same && slot->place.optional && value[0] == 0 && slot->floor < 0) {
        snprintf(text, size, "%s", "");
        return;
    }
    if (same) {
        if (lacks && value[0] == 0)
            snprintf(text, size, "%s", THUD_FLOOR_NONE);
        else
            thud_quantity_format(value[0], unit, text, size);
        return;
    }
    *text = '\0';
    for (int i = 0; i < n; i++) {
        char item[96];
        if (lacks && value[i] == 0)
            snprintf(item, sizeof item, "%s", THUD_FLOOR_NONE);
        else
            thud_quantity_format(value[i], unit, item, sizeof item);
        thud_append(text, size, "%s%s%s", i ? ", " : "[", item, i == n - 1 ? "]" : "");
    }
}

void thud_value_get(const struct thud_scene *scene, const struct thud_slot *slot, const char *unit, char *text,
                    size_t size)
{
    char shown[64];
    thud_slot_unit(scene, slot, unit, shown, sizeof shown);
    unit = shown;
    const void *at = thud_slot_in(scene, slot);
    const struct thud_param *param = slot->param;
    const struct thud_law_choice *choice;
    switch (slot->place.store) {
    case THUD_STORE_NUMBER: {
        double value = *(const double *)at;
        if (!isfinite(value) || (slot->place.optional && value == 0))
            snprintf(text, size, "%s", "");
        else if (param->kind == THUD_PARAM_CHOICE)
            snprintf(text, size, "%s", param->choices[(int)value]);
        else
            thud_quantity_format(value, unit, text, size);
        break;
    }
    case THUD_STORE_COUNT:
        if (*(const int *)at == slot->place.none)
            snprintf(text, size, "%s", "");
        else if (*(const int *)at < 0 && param->choices)
            snprintf(text, size, "%s", param->choices[-1 - *(const int *)at]);
        else
            snprintf(text, size, "%d", *(const int *)at);
        break;
    case THUD_STORE_SIGN:
        snprintf(text, size, "%s", *(const int *)at < 0 ? "-" : "+");
        break;
    case THUD_STORE_SWITCH:
        snprintf(text, size, "%s", slot->param->choices[*(const bool *)at]);
        break;
    case THUD_STORE_TEXT:
        snprintf(text, size, "%s", (const char *)at);
        break;
    case THUD_STORE_FLOORS: {
        const double *value = at;
        int n = scene->structure[slot->structure].storeys;
        if (slot->floor >= 0)
            get_floors(slot, value + slot->floor, 1, unit, text, size);
        else
            get_floors(slot, value, n, unit, text, size);
        break;
    }
    case THUD_STORE_LEVELS:
        thud_levels_get(at, unit, text, size);
        break;
    case THUD_STORE_STOREYS:
        snprintf(text, size, "%d", *(const int *)at);
        break;
    case THUD_STORE_KIND:
        snprintf(text, size, "%s", param->choices[scene->structure[slot->structure].kind]);
        break;
    case THUD_STORE_LINK:
        snprintf(text, size, "%s", slot->link < scene->nlinks ? param->choices[(int)*(const double *)at] : "");
        break;
    case THUD_STORE_LAW:
        choice = at;
        snprintf(text, size, "%s", choice->law ? choice->law->name : "");
        break;
    case THUD_STORE_STUDY: /* scene_set.c */
        break;
    }
}
