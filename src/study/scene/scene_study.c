/* The study of a preset: `vary`, `from`, `to`, `step`, `values` and `cases`, each one value or a list. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "study/scene/scene_slot.h"
#include "study/scene/scene_words.h"

enum { COPY_MAX = 2048, VALUES_MAX = 200 };

static bool is_number(const struct thud_param *param)
{
    return param->kind == THUD_PARAM_QUANTITY || param->kind == THUD_PARAM_INTEGER;
}

/* Items of a list or the one value; the count, -1 when there are too many. Errors: THUD_INPUT. */
static int items(char *text, char **item, int most, struct thud_error *err)
{
    if (text[0] != '[') {
        item[0] = text;
        return 1;
    }
    int n = thud_list_split(text, item, most);
    if (n >= 0 && n <= most)
        return n;
    thud_error_set(err, THUD_INPUT, "too many values, or an unterminated list");
    thud_error_allow(err, "up to %d", most);
    return -1;
}

static enum thud_status set_vary(struct thud_scene *scene, char **item, int n, struct thud_error *err)
{
    struct thud_study_choice study = scene->study;
    memset(study.vary, 0, sizeof study.vary);
    study.nvary = n;
    for (int i = 0; i < n; i++) {
        struct thud_slot slot;
        enum thud_status status = thud_slot_find(scene, item[i], &slot, err);
        if (status != THUD_OK)
            return status;
        if (slot.param->kind == THUD_PARAM_TEXT && slot.place.store != THUD_STORE_LAW)
            return thud_error_set(err, THUD_INPUT, "\"%.80s\" is neither a number nor a choice that can be varied",
                                  item[i]);
        for (int j = 0; j < i; j++)
            if (strcmp(item[i], item[j]) == 0)
                return thud_error_set(err, THUD_INPUT, "\"%.80s\" is varied twice", item[i]);
        if (strlen(item[i]) >= sizeof study.vary[i].key)
            return thud_error_set(err, THUD_INPUT, "\"%.80s\" is too long", item[i]);
        strcpy(study.vary[i].key, item[i]);
        study.vary[i].from = study.vary[i].to = study.vary[i].step = NAN;
    }
    scene->study = study;
    return THUD_OK;
}

static double *bound(struct thud_vary *vary, const char *name)
{
    return strcmp(name, "from") == 0 ? &vary->from : strcmp(name, "to") == 0 ? &vary->to : &vary->step;
}

static enum thud_status read_bound(const struct thud_scene *scene, const char *key, bool step, const char *text,
                                   double *out, struct thud_error *err)
{
    struct thud_slot slot;
    struct thud_quantity q;
    enum thud_status status = thud_slot_find(scene, key, &slot, err);
    if (status != THUD_OK)
        return status;
    if (!is_number(slot.param)) {
        thud_error_set(err, THUD_INPUT, "%.80s takes words, and words have no range", key);
        thud_error_allow(err, "values: [%s]", slot.param->kind == THUD_PARAM_CHOICE ? slot.param->choices[0] : "...");
        return THUD_INPUT;
    }
    if (!step)
        return thud_quantity_read(slot.param, thud_slot_law(scene, &slot), text, out, err);
    status = thud_quantity_parse(text, slot.param->dimension, NULL, &q, err);
    if (status != THUD_OK)
        return status;
    if (!(q.value > 0))
        return thud_error_refuse(err, THUD_INPUT, NULL, "> 0", "%.80s is too small", text);
    *out = q.value;
    return THUD_OK;
}

static enum thud_status check_count(const struct thud_study_choice *study, int n, const char *what,
                                    struct thud_error *err)
{
    if (study->nvary == 0)
        return thud_error_set(err, THUD_INPUT, "study.vary, the varied key, is not given");
    if (n != study->nvary)
        return thud_error_set(err, THUD_INPUT, "%d %s%s for %d varied key%s", n, what, n == 1 ? "" : "s", study->nvary,
                              study->nvary == 1 ? "" : "s");
    return THUD_OK;
}

static enum thud_status refuse_both(struct thud_error *err)
{
    return thud_error_refuse(err, THUD_INPUT, NULL, "values, or from, to and step", "there are values and a range");
}

static enum thud_status add_value(struct thud_vary *vary, const char *value, struct thud_error *err)
{
    size_t n = strlen(vary->values), length = strlen(value);
    if (n + length + 3 > sizeof vary->values) {
        thud_error_set(err, THUD_INPUT, "the list for %.80s is too long", vary->key);
        thud_error_allow(err, "up to %d bytes", THUD_VARY_VALUES - 1);
        return THUD_INPUT;
    }
    if (n > 0) {
        memcpy(vary->values + n, ", ", 2);
        n += 2;
    }
    memcpy(vary->values + n, value, length + 1);
    return THUD_OK;
}

/* The values of one key, each of which the scene must take. `scratch` is a scene to try them in. */
static enum thud_status set_list(const struct thud_scene *scene, struct thud_vary *vary, char *text,
                                 struct thud_scene *scratch, struct thud_error *err)
{
    char *value[VALUES_MAX];
    struct thud_slot slot;
    int n = items(text, value, VALUES_MAX, err);
    enum thud_status status = THUD_OK;
    if (n < 0)
        return THUD_INPUT;
    if (!isnan(vary->from) || !isnan(vary->to) || !isnan(vary->step))
        return refuse_both(err);
    vary->values[0] = '\0';
    for (int i = 0; i < n && status == THUD_OK; i++) {
        thud_scene_copy(scratch, scene);
        if (!*value[i])
            return thud_error_set(err, THUD_INPUT, "a value is empty");
        status = thud_slot_find(scratch, vary->key, &slot, err);
        if (status == THUD_OK)
            status = thud_value_set(scratch, &slot, value[i], err);
        if (status == THUD_OK)
            status = add_value(vary, value[i], err);
        else
            thud_error_key(err, "%s", vary->key);
    }
    return status;
}

static enum thud_status set_values(struct thud_scene *scene, char *text, struct thud_error *err)
{
    struct thud_study_choice study = scene->study;
    char *list[THUD_VARY_MAX] = {text};
    int n = study.nvary > 1 ? items(text, list, THUD_VARY_MAX, NULL) : 1;
    if (n < 0)
        n = THUD_VARY_MAX + 1;
    enum thud_status status = check_count(&study, n, "list", err);
    if (status != THUD_OK)
        return status;
    struct thud_scene *scratch = malloc(sizeof *scratch);
    if (!scratch)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < n && status == THUD_OK; i++) {
        memset(study.vary[i].values, 0, sizeof study.vary[i].values);
        status = set_list(scene, &study.vary[i], list[i], scratch, err);
    }
    free(scratch);
    if (status == THUD_OK)
        scene->study = study;
    return status;
}

static enum thud_status set_bounds(struct thud_scene *scene, const char *name, char **item, int n,
                                   struct thud_error *err)
{
    struct thud_study_choice study = scene->study;
    enum thud_status status = check_count(&study, n, "value", err);
    if (status == THUD_OK && study.vary[0].values[0])
        status = refuse_both(err);
    if (status != THUD_OK)
        return status;
    for (int i = 0; i < n; i++) {
        status =
            read_bound(scene, study.vary[i].key, strcmp(name, "step") == 0, item[i], bound(&study.vary[i], name), err);
        if (status != THUD_OK)
            return status;
    }
    scene->study = study;
    return THUD_OK;
}

static enum thud_status set_cases(struct thud_study_choice *study, const char *text, struct thud_error *err)
{
    enum thud_case cases[THUD_CASES_MAX] = {0};
    enum thud_status status = *text ? thud_cases_parse(text, cases, &study->ncases, err) : THUD_OK;
    if (status == THUD_OK)
        memcpy(study->cases, cases, sizeof cases);
    if (!*text)
        study->ncases = 0;
    return status;
}

enum thud_status thud_study_set(struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                                struct thud_error *err)
{
    const char *name = slot->param->name;
    char copy[COPY_MAX], *item[THUD_VARY_MAX];
    if (strcmp(name, "cases") == 0)
        return set_cases(&scene->study, text, err);
    snprintf(copy, sizeof copy, *text != '[' && strchr(text, ',') ? "[%s]" : "%s", text);
    if (!*text) { /* nothing is varied */
        if (strcmp(name, "vary") == 0)
            memset(&scene->study.vary, 0, sizeof scene->study.vary), scene->study.nvary = 0;
        else if (strcmp(name, "values") == 0)
            for (int i = 0; i < THUD_VARY_MAX; i++)
                memset(scene->study.vary[i].values, 0, sizeof scene->study.vary[i].values);
        return THUD_OK;
    }
    if (strcmp(name, "values") == 0)
        return set_values(scene, copy, err);
    int n = items(copy, item, THUD_VARY_MAX, err);
    if (n < 0)
        return THUD_INPUT;
    return strcmp(name, "vary") == 0 ? set_vary(scene, item, n, err) : set_bounds(scene, name, item, n, err);
}

static void get_item(const struct thud_scene *scene, const char *name, int i, char *text, size_t size)
{
    if (strcmp(name, "cases") == 0) { /* there may be more of them than of varied keys */
        snprintf(text, size, "%s", thud_case_name(scene->study.cases[i]));
        return;
    }
    struct thud_vary vary = scene->study.vary[i];
    struct thud_slot slot;
    if (strcmp(name, "vary") == 0)
        snprintf(text, size, "%s", vary.key);
    else if (strcmp(name, "values") == 0)
        snprintf(text, size, "[%s]", vary.values);
    else if (thud_slot_find(scene, vary.key, &slot, NULL) == THUD_OK) {
        char unit[64];
        thud_slot_unit(scene, &slot, NULL, unit, sizeof unit);
        thud_quantity_format(*bound(&vary, name), unit, text, size);
    }
}

void thud_study_get(const struct thud_scene *scene, const struct thud_slot *slot, char *text, size_t size)
{
    const char *name = slot->param->name;
    int n = strcmp(name, "cases") == 0 ? scene->study.ncases : scene->study.nvary;
    bool list = n > 1 || strcmp(name, "cases") == 0, values = strcmp(name, "values") == 0;
    bool of_range = strcmp(name, "from") == 0 || strcmp(name, "to") == 0 || strcmp(name, "step") == 0,
         has_values = n > 0 && scene->study.vary[0].values[0];
    text[0] = '\0';
    if (has_values ? of_range : values)
        return; /* they have the one or the other */
    for (int i = 0; i < n; i++) {
        char item[THUD_VARY_VALUES + 8] = "";
        get_item(scene, name, i, item, sizeof item);
        thud_append(text, size, "%s%s%s", i ? ", " : list ? "[" : "", item, list && i == n - 1 ? "]" : "");
    }
}

void thud_study_vary_text(const struct thud_scene *scene, int i, char *text, unsigned long size)
{
    char from[64] = "", to[64] = "", step[64] = "";
    if (scene->study.vary[i].values[0]) {
        snprintf(text, size, "%s=%s", scene->study.vary[i].key, scene->study.vary[i].values);
        return;
    }
    get_item(scene, "from", i, from, sizeof from);
    get_item(scene, "to", i, to, sizeof to);
    get_item(scene, "step", i, step, sizeof step);
    snprintf(text, size, "%s=%s:%s:%s", scene->study.vary[i].key, from, to, step);
}
