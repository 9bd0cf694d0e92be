#include "tui/sweep_words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/sweep.h"

enum { FROM, TO, STEP, PARTS };

static bool any_bumper(const struct thud_scene *scene)
{
    for (int i = 0; i + 1 < scene->nstructures; i++)
        if (scene->interface[i].has_bumper)
            return true;
    return false;
}

void thud_study_words_of(const struct thud_scene *scene, struct thud_study_words *words)
{
    const struct thud_study_choice *study = &scene->study;
    memset(words->vary, 0, sizeof words->vary);
    words->cases[0] = words->sensitivity[0] = '\0';
    if (study->sensitivity > 0)
        thud_quantity_format(study->sensitivity, "%", words->sensitivity, sizeof words->sensitivity);
    for (int i = 0; i < study->nvary; i++)
        thud_study_vary_text(scene, i, words->vary[i], sizeof words->vary[i]);
    for (int i = 0; i < study->ncases; i++) {
        size_t n = strlen(words->cases);
        snprintf(words->cases + n, sizeof words->cases - n, "%s%s", i ? "," : "", thud_case_name(study->cases[i]));
    }
    if (study->nvary > 0 || study->ncases > 0)
        return;
    snprintf(words->vary[0], sizeof words->vary[0], "%s=5 cm:25 cm:1 cm",
             scene->nstructures > 2 ? "interfaces.1.gap" : "gap");
    snprintf(words->cases, sizeof words->cases, "%s", any_bumper(scene) ? "none,bumper" : "none");
}

bool thud_study_words_fit(const struct thud_study_words *words)
{
    for (int i = 0; i < THUD_VARY_MAX; i++)
        if (*words->vary[i] && !strchr(words->vary[i], ':'))
            return false;
    return true;
}

/* Appends an item to a list in brackets. */
static void add_item(char *list, size_t size, const char *item, int length)
{
    size_t n = strlen(list);
    snprintf(list + n, size - n, "%s%.*s", n ? ", " : "[", length, item);
}

/* "KEY=FROM:TO:STEP" into four lists; a part without a unit takes that of the last one, as on the command line. */
static void split(const char *vary, char list[1 + PARTS][512])
{
    char part[PARTS][64] = {"", "", ""};
    const char *at = strchr(vary, '='), *end;
    double number;
    add_item(list[PARTS], sizeof list[PARTS], vary, (int)(at - vary));
    at++;
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

/* All values are tried, in a plan that is thrown away. */
static enum thud_status try_out(const struct thud_study_words *words, const struct thud_scene *scene,
                                struct thud_error *err)
{
    struct thud_sweep_plan plan;
    enum thud_status status = THUD_OK;
    thud_sweep_plan_init(&plan, scene);
    for (int i = 0; i < THUD_VARY_MAX && status == THUD_OK; i++)
        if (*words->vary[i])
            status = thud_sweep_vary(&plan, words->vary[i], err);
    if (status == THUD_OK && *words->cases)
        status = thud_sweep_cases(&plan, words->cases, err);
    if (status == THUD_OK && *words->sensitivity)
        status = thud_scene_set(&plan.scene, "study.sensitivity", words->sensitivity, err);
    thud_sweep_plan_clear(&plan);
    return status;
}

enum thud_status thud_study_words_keep(const struct thud_study_words *words, struct thud_scene *scene,
                                       struct thud_error *err)
{
    static const char *const key[1 + PARTS] = {"study.from", "study.to", "study.step", "study.vary"};
    char list[1 + PARTS][512] = {"", "", "", ""}, cases[128] = "";
    enum thud_status status = try_out(words, scene, err);
    if (status != THUD_OK || !thud_study_words_fit(words))
        return status;
    for (int i = 0; i < THUD_VARY_MAX; i++)
        if (*words->vary[i])
            split(words->vary[i], list);
    if (*words->cases)
        snprintf(cases, sizeof cases, "[%s]", words->cases);
    struct thud_scene *next = malloc(sizeof *next);
    if (!next)
        return thud_error_set(err, THUD_MEMORY, "no memory for the study");
    *next = *scene;
    next->study.nvary = next->study.ncases = 0;
    memset(next->study.vary, 0, sizeof next->study.vary);
    memset(next->study.cases, 0, sizeof next->study.cases);
    for (int i = PARTS; i >= 0 && status == THUD_OK; i--) { /* the keys before their ranges */
        size_t n = strlen(list[i]);
        if (n > 0 && n + 1 < sizeof list[i])
            memcpy(list[i] + n, "]", 2);
        if (n > 0)
            status = thud_scene_set(next, key[i], list[i], err);
    }
    if (status == THUD_OK && *cases)
        status = thud_scene_set(next, "study.cases", cases, err);
    if (status == THUD_OK)
        status = thud_scene_set(next, "study.sensitivity", words->sensitivity, err);
    if (status == THUD_OK)
        scene->study = next->study;
    free(next);
    return status;
}
