#include "tui/screens/sweep_words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FROM, TO, STEP, PARTS, VARY = PARTS, VALUES, KEYS, LIST = THUD_VARY_MAX * THUD_VARY_VALUES };

/* A list of a preset without its brackets. */
static void without_brackets(const char *from, char *to, size_t size)
{
    size_t n = strlen(from);
    bool brackets = n > 1 && *from == '[' && from[n - 1] == ']';
    snprintf(to, size, "%.*s", (int)(n - 2 * brackets), from + brackets);
}

void thud_study_words_of(const struct thud_scene *scene, struct thud_study_words *words)
{
    const struct thud_study_choice *study = &scene->study;
    memset(words->vary, 0, sizeof words->vary);
    words->cases[0] = words->sensitivity[0] = '\0';
    without_brackets(study->records, words->records, sizeof words->records);
    without_brackets(study->events, words->events, sizeof words->events);
    snprintf(words->signs, sizeof words->signs, "%s", study->both_signs ? "both" : "");
    if (study->sensitivity > 0)
        thud_quantity_format(study->sensitivity, "%", words->sensitivity, sizeof words->sensitivity);
    for (int i = 0; i < study->nvary; i++)
        thud_study_vary_text(scene, i, words->vary[i], sizeof words->vary[i]);
    for (int i = 0; i < study->ncases; i++) {
        size_t n = strlen(words->cases);
        snprintf(words->cases + n, sizeof words->cases - n, "%s%s", i ? "," : "", thud_case_name(study->cases[i]));
    }
    if (study->nvary > 0)
        return;
    if (study->ncases == 0 || !*study->records) /* cases over ground motions are a study without a range */
        snprintf(words->vary[0], sizeof words->vary[0], "%s=5 cm:25 cm:1 cm",
                 scene->nstructures > 2 ? "interfaces.1.gap" : "gap");
    if (study->ncases == 0)
        snprintf(words->cases, sizeof words->cases, "%s", thud_scene_has_bumper(scene) ? "none,bumper" : "none");
}

/* Appends an item to a list in brackets. */
static void add_item(char *list, size_t size, const char *item, int length)
{
    size_t n = strlen(list);
    snprintf(list + n, size - n, "%s%.*s", n ? ", " : "[", length, item);
}

/* "KEY=FROM:TO:STEP" into four lists; a part without a unit takes that of the last one, as on the command line. */
static void split(const char *vary, char list[KEYS][LIST])
{
    char part[PARTS][64] = {"", "", ""};
    const char *at = strchr(vary, '=') + 1, *end;
    double number;
    for (int i = 0; i < PARTS; i++) {
        at += strspn(at, " ");
        size_t n = strcspn(at, ":");
        snprintf(part[i], sizeof part[i], "%.*s", (int)n, at);
        at += n + (at[n] == ':');
    }
    const char *unit = thud_number_parse(part[STEP], &end, &number) == 0 ? end : "";
    for (int i = 0; i < PARTS; i++) {
        if (thud_number_parse(part[i], &end, &number) == 0 && !end[strspn(end, " ")] && *unit) {
            char whole[160];
            snprintf(whole, sizeof whole, "%.*s %s", (int)(end - part[i]), part[i], unit + strspn(unit, " "));
            add_item(list[i], sizeof list[i], whole, (int)strlen(whole));
        } else {
            add_item(list[i], sizeof list[i], part[i], (int)strlen(part[i]));
        }
    }
}

enum thud_status thud_study_words_plan(const struct thud_study_words *words, const struct thud_scene *scene,
                                       struct thud_sweep_plan *plan, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    thud_sweep_plan_init(plan, scene);
    for (int i = 0; i < THUD_VARY_MAX && status == THUD_OK; i++)
        if (*words->vary[i])
            status = thud_sweep_vary(plan, words->vary[i], err);
    if (status == THUD_OK && *words->cases)
        status = thud_sweep_cases(plan, words->cases, err);
    return status;
}

/* The values of a key with their units, as a list in brackets; false when it is longer than a preset has room for. */
static bool list_values(const struct thud_sweep_plan *plan, const char *key, size_t length, char *list, size_t size)
{
    char values[THUD_VARY_VALUES] = "";
    for (int i = 0; i < plan->naxes; i++) {
        const struct thud_sweep_axis *axis = &plan->axis[i];
        if (strncmp(axis->key, key, length) != 0 || axis->key[length])
            continue;
        for (int v = 0; v < axis->n; v++) {
            if (strlen(values) + strlen(axis->text[v]) + 4 > sizeof values)
                return false;
            add_item(values, sizeof values, axis->text[v], (int)strlen(axis->text[v]));
        }
    }
    size_t n = strlen(values);
    if (n == 0)
        return false;
    memcpy(values + n, "]", 2);
    add_item(list, size, values, (int)strlen(values));
    return true;
}

/* The words as lists for the keys of the preset's study; false when a preset has no room for them. */
static bool write_lists(const struct thud_study_words *words, const struct thud_sweep_plan *plan, char list[KEYS][LIST])
{
    bool ranges = true, room = true;
    for (int i = 0; i < THUD_VARY_MAX; i++)
        ranges = ranges && (!*words->vary[i] || strchr(words->vary[i], ':'));
    for (int i = 0; i < THUD_VARY_MAX; i++) {
        const char *vary = words->vary[i];
        if (!*vary)
            continue;
        size_t length = strcspn(vary, "=");
        add_item(list[VARY], LIST, vary, (int)length);
        if (ranges)
            split(vary, list);
        else
            room = room && list_values(plan, vary, length, list[VALUES], LIST);
    }
    for (int k = 0; k < KEYS; k++) {
        size_t n = strlen(list[k]);
        if (k == VALUES && n > 0 && plan->naxes == 1)
            memmove(list[k], list[k] + 1, n); /* one key has a list, several a list of lists */
        else if (n > 0 && n + 1 < LIST)
            memcpy(list[k] + n, "]", 2);
    }
    return room;
}

static enum thud_status set_study(struct thud_scene *scene, const struct thud_study_words *words, char list[KEYS][LIST],
                                  struct thud_error *err)
{
    static const char *const key[KEYS] = {"study.from", "study.to", "study.step", "study.vary", "study.values"};
    static const int order[KEYS] = {VARY, FROM, TO, STEP, VALUES}; /* the keys before their ranges */
    char cases[128] = "";
    enum thud_status status = THUD_OK;
    if (*words->cases)
        snprintf(cases, sizeof cases, "[%s]", words->cases);
    scene->study.nvary = scene->study.ncases = 0;
    memset(scene->study.vary, 0, sizeof scene->study.vary);
    memset(scene->study.cases, 0, sizeof scene->study.cases);
    for (int i = 0; i < KEYS && status == THUD_OK; i++)
        if (*list[order[i]])
            status = thud_scene_set(scene, key[order[i]], list[order[i]], err);
    if (status == THUD_OK && *cases)
        status = thud_scene_set(scene, "study.cases", cases, err);
    return status;
}

enum thud_status thud_study_words_keep(const struct thud_study_words *words, struct thud_scene *scene,
                                       struct thud_error *err)
{
    char list[KEYS][LIST] = {"", "", "", "", ""};
    struct thud_scene *next = malloc(sizeof *next);
    struct thud_sweep_plan *plan = malloc(sizeof *plan);
    enum thud_status status = THUD_MEMORY;
    if (next && plan) {
        status = thud_study_words_plan(words, scene, plan, err);
        *next = *scene;
        if (status == THUD_OK && !write_lists(words, plan, list))
            status = thud_error_set(err, THUD_USAGE, "a preset has no room for so many values: KEY=FROM:TO:STEP has");
        thud_sweep_plan_clear(plan);
    } else {
        thud_error_set(err, THUD_MEMORY, "no memory for the study");
    }
    if (status == THUD_OK && (status = set_study(next, words, list, err)) == THUD_OK)
        scene->study = next->study;
    free(plan);
    free(next);
    return status;
}
