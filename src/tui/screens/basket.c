#include "tui/screens/basket.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "io/record/target_file.h"
#include "plot/figures/figures_suite.h"

/* The next of the study's ground motions, without blanks and brackets around it; false: there are no more. */
static bool next_motion(const char **at, const char **item, size_t *n)
{
    *item = *at + strspn(*at, "[, ");
    *n = strcspn(*item, ",]");
    *at = *item + *n;
    while (*n > 0 && (*item)[*n - 1] == ' ')
        --*n;
    return *n > 0;
}

static bool is_of(const char *item, size_t n, const char *file)
{
    size_t m = strlen(file);
    return n >= m && strncmp(item, file, m) == 0 && (n == m || item[m] == ':');
}

int thud_basket_count(const struct thud_tui *tui)
{
    const char *at = tui->doc.scene.study.records, *item;
    int count = 0;
    for (size_t n; next_motion(&at, &item, &n);)
        count++;
    return count;
}

bool thud_basket_holds(const struct thud_tui *tui, const char *file)
{
    const char *at = tui->doc.scene.study.records, *item;
    for (size_t n; next_motion(&at, &item, &n);)
        if (is_of(item, n, file))
            return true;
    return false;
}

/* The suite without a file, and with another motion where `more` is not empty. */
static void change(struct thud_tui *tui, const char *file, const char *more)
{
    const char *at = tui->doc.scene.study.records, *item;
    char text[2 * THUD_VARY_TEXT] = "";
    size_t used = 0;
    for (size_t n; next_motion(&at, &item, &n);)
        if (!is_of(item, n, file))
            used += (size_t)snprintf(text + used, sizeof text - used, "%s%.*s", used ? "," : "", (int)n, item);
    if (*more)
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%s", used ? "," : "", more);
    if (used >= THUD_VARY_TEXT)
        thud_tui_say(tui, THUD_ROLE_WARN,
                     "A preset has no room for more; records on Sweep takes a folder, or a NAME.list");
    else if (thud_tui_set(tui, "study.records", text))
        thud_tui_say(tui, THUD_ROLE_PLAIN, "The suite has %d ground motions; Sweep runs it", thud_basket_count(tui));
}

static void put_in(struct thud_tui *tui, struct thud_basket *basket);

/* What the motion lacks was typed: empty, it is left out. */
static void typed(struct thud_tui *tui, const char *text)
{
    struct thud_basket *basket = tui->own[THUD_SCREEN_RECORD]; /* begins that screen's state */
    thud_append(basket->pending, sizeof basket->pending, "%.60s", text);
    if (*text)
        put_in(tui, basket);
}

static void put_in(struct thud_tui *tui, struct thud_basket *basket)
{
    static const struct thud_prompt prompt = {.done = typed};
    static const char *const keys[] = {"dt", "unit", "channel", "column"};
    struct thud_record_list list;
    struct thud_error err = {0};
    char file[THUD_VARY_TEXT], text[400];
    enum thud_status status = thud_doc_motions(&tui->doc, basket->pending, false, &list, &err);
    thud_record_list_clear(&list);
    if (status == THUD_OK) {
        const char *at = basket->pending, *item;
        size_t n;
        next_motion(&at, &item, &n);
        snprintf(file, sizeof file, "%.*s", (int)strcspn(item, ":"), item);
        change(tui, file, basket->pending);
        return;
    }
    thud_tui_say_error(tui, &err);
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (strcmp(err.key, keys[i]) == 0) {
            snprintf(tui->dialog.target, sizeof tui->dialog.target, "its %s, to be read: ", keys[i]);
            thud_append(basket->pending, sizeof basket->pending, ":%s=", keys[i]);
            thud_error_text(&err, text, sizeof text);
            thud_tui_prompt(tui, &prompt, "");
        }
}

void thud_basket_toggle(struct thud_tui *tui, struct thud_basket *basket, const char *file)
{
    if (thud_basket_holds(tui, file)) {
        change(tui, file, "");
        return;
    }
    snprintf(basket->pending, sizeof basket->pending, "%.300s", file);
    put_in(tui, basket);
}

/* The target that the scene's ground motion is scaled to, over its periods; false: it has none. */
static bool target_of(const struct thud_scene *scene, struct thud_target *target)
{
    return *scene->record.target && thud_target_read(scene->record.target, target, NULL) == THUD_OK;
}

/* As they are run: what scales them is a part of them already. */
static enum thud_status make(const struct thud_tui *tui, struct thud_basket *basket, struct thud_error *err)
{
    const struct thud_scene *scene = &tui->doc.scene;
    struct thud_record_list list;
    struct thud_period_mark mark[THUD_STRUCTURES_MAX];
    struct thud_target target;
    struct thud_scaling scaling;
    struct thud_scaled_suite suite = {0};
    int marks = 0;
    double least = INFINITY, most = 0;
    thud_scaling_init(&scaling);
    enum thud_status status = thud_doc_motions(&tui->doc, scene->study.records, false, &list, err);
    if (status == THUD_OK)
        status = thud_scene_periods(scene, mark, THUD_STRUCTURES_MAX, &marks, err);
    for (int i = 0; i < marks; i++) {
        least = fmin(least, mark[i].period_s);
        most = fmax(most, mark[i].period_s);
    }
    scaling.from_s = !isnan(scene->record.target_from_s) ? scene->record.target_from_s : marks ? 0.2 * least : 0.1;
    scaling.to_s = !isnan(scene->record.target_to_s) ? scene->record.target_to_s : marks ? 2 * most : 2;
    if (status == THUD_OK)
        status = thud_suite_scale((const struct thud_record *const *)list.record, list.n, NULL, &scaling, &suite, err);
    if (status == THUD_OK) {
        const bool has_target = target_of(scene, &target);
        for (int p = 0; has_target && p < THUD_TARGET_PERIODS; p++)
            suite.target_mps2[p] = thud_target_sa(&target, suite.period_s[p]);
        basket->figure = thud_figure_of_suite(&suite, has_target ? target.text : "", mark, marks);
        status = thud_figure_check(basket->figure, err);
    }
    thud_scaled_suite_clear(&suite);
    thud_record_list_clear(&list);
    return status;
}

const struct thud_figure *thud_basket_figure(struct thud_tui *tui, struct thud_basket *basket)
{
    const struct thud_scene *scene = &tui->doc.scene;
    struct thud_record_choice choice = scene->record;
    struct thud_error err = {0};
    memset(choice.file, 0, sizeof choice.file);
    if (basket->made && memcmp(&basket->study, &scene->study, sizeof scene->study) == 0 &&
        memcmp(&basket->choice, &choice, sizeof choice) == 0)
        return basket->figure;
    thud_figure_free(basket->figure);
    basket->figure = NULL;
    basket->study = scene->study;
    basket->choice = choice;
    basket->made = true;
    if (make(tui, basket, &err) != THUD_OK) {
        thud_figure_free(basket->figure);
        basket->figure = NULL;
        thud_error_text(&err, basket->why, sizeof basket->why);
    }
    return basket->figure;
}
