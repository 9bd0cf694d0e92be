/* Changing the value under the cursor: typed, stepped, toggled, chosen. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "core/methods/method.h"
#include "tui/loop/loop.h"

static void offer_laws(struct thud_tui *tui)
{
    for (int i = 0; i < thud_law_count(); i++)
        thud_chooser_add(&tui->dialog.chooser, thud_law_at(i)->name, "%-26s %s", thud_law_at(i)->name,
                         thud_law_at(i)->summary);
}

static void offer_methods(struct thud_tui *tui)
{
    thud_chooser_add(&tui->dialog.chooser, "auto", "%-22s %s", "auto", "no step to choose; a run says what it took");
    for (int i = 0; i < thud_method_count(); i++)
        thud_chooser_add(&tui->dialog.chooser, thud_method_at(i)->name, "%-22s %s", thud_method_at(i)->name,
                         thud_method_at(i)->summary);
}

/* Whether a value is a word of a closed list. */
static bool is_word(const char *key, const struct thud_param *param)
{
    return thud_ascii_ends(key, ".law") || strcmp(key, "analysis.method") == 0 ||
           (param->kind == THUD_PARAM_CHOICE && param->choices);
}

bool thud_tui_typable(const struct thud_tui *tui, const struct thud_field *field)
{
    if (!field || field->kind != THUD_FIELD_VALUE)
        return false;
    const struct thud_param *param = thud_scene_param(&tui->doc.scene, field->path, &(int){0});
    return param && !is_word(field->path, param);
}

static void chosen_value(struct thud_tui *tui, const char *value)
{
    thud_tui_set(tui, tui->dialog.target, value);
}

/* A value with a closed list of words: a list to choose from. False: it has none. */
static bool choose_value(struct thud_tui *tui, const char *key, const struct thud_param *param)
{
    bool law = thud_ascii_ends(key, ".law"), method = strcmp(key, "analysis.method") == 0;
    if (!is_word(key, param))
        return false;
    char now[128] = "";
    thud_scene_get(&tui->doc.scene, key, now, sizeof now, NULL);
    snprintf(tui->dialog.target, sizeof tui->dialog.target, "%s", key);
    thud_tui_choose(tui, chosen_value, key);
    if (law)
        offer_laws(tui);
    else if (method)
        offer_methods(tui);
    else
        for (int i = 0; param->choices[i]; i++)
            thud_chooser_add(&tui->dialog.chooser, param->choices[i], "%s", param->choices[i]);
    thud_chooser_mark(&tui->dialog.chooser, now);
    return true;
}

void thud_tui_edit(struct thud_tui *tui, bool select)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    if (!field)
        return;
    if (field->kind == THUD_FIELD_ROW) {
        const struct thud_view *view = thud_tui_view(tui);
        if (view->row)
            view->row(tui, field);
        return;
    }
    const struct thud_param *param = thud_scene_param(&tui->doc.scene, field->path, &(int){0});
    if (!param || choose_value(tui, field->path, param))
        return;
    char old[THUD_LINE_MAX] = "";
    thud_scene_get(&tui->doc.scene, field->path, old, sizeof old, NULL);
    thud_tui_type(tui, field->path, old, select);
}

bool thud_tui_accept(struct thud_tui *tui)
{
    char old[THUD_LINE_MAX] = "";
    thud_scene_get(&tui->doc.scene, tui->dialog.target, old, sizeof old, NULL);
    if (strcmp(old, tui->dialog.line.text) != 0 && !thud_tui_set(tui, tui->dialog.target, tui->dialog.line.text))
        return false; /* what was typed stays in the editor, the message says what is wrong */
    thud_tui_normal(tui);
    thud_tui_follow(tui);
    thud_tui_draw(tui);
    return true;
}

void thud_tui_accept_and_go(struct thud_tui *tui, enum thud_action action)
{
    if (!thud_tui_accept(tui))
        return;
    char said[sizeof tui->said.text];
    memcpy(said, tui->said.text, sizeof said);
    int down = action == THUD_DO_ACCEPT_DOWN ? 1 : action == THUD_DO_ACCEPT_UP ? -1 : 0;
    int step = action == THUD_DO_ACCEPT_PREVIOUS ? -1 : 1;
    for (int i = 0; i < tui->form.n; i++) { /* past what is chosen from a list */
        const struct thud_field *before = thud_form_focus(&tui->form);
        if (down)
            thud_form_move(&tui->form, 0, down);
        else
            thud_form_next(&tui->form, step);
        const struct thud_field *now = thud_form_focus(&tui->form);
        if (now == before || thud_tui_typable(tui, now))
            break;
    }
    const struct thud_field *now = thud_form_focus(&tui->form);
    if (thud_tui_typable(tui, now) && strcmp(now->path, tui->dialog.target) != 0)
        thud_tui_edit(tui, true);
    thud_tui_say(tui, tui->said.role, "%s", said); /* a warning about the last value stays */
}

static void step_choice(struct thud_tui *tui, const char *key, const struct thud_param *param, int steps)
{
    char now[128] = "";
    int n = 0, at = 0;
    if (thud_ascii_ends(key, ".kind")) { /* on the way to the one that is meant lie others that a building is lost in */
        choose_value(tui, key, param);
        return;
    }
    thud_scene_get(&tui->doc.scene, key, now, sizeof now, NULL);
    for (; param->choices[n]; n++)
        if (strcmp(param->choices[n], now) == 0)
            at = n;
    if (n > 0)
        thud_tui_set(tui, key, param->choices[((at + steps) % n + n) % n]);
}

/* Where stepping starts from while nothing is given: the ends of the ground motion. NaN: nowhere. */
static double first_value(const struct thud_tui *tui, const char *key)
{
    const struct thud_record *record = tui->doc.whole ? tui->doc.whole : tui->doc.record;
    if (record && strcmp(key, "record.from") == 0)
        return 0.0;
    if (record && strcmp(key, "record.to") == 0)
        return (double)(record->samples - 1) * record->dt_s;
    return NAN;
}

/* A step is one in the second digit of the number as shown. */
void thud_tui_step_value(struct thud_tui *tui, int steps)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    if (!field || field->kind != THUD_FIELD_VALUE)
        return;
    char key[THUD_PATH_MAX], text[128], unit[48], number[64];
    snprintf(key, sizeof key, "%s", field->path);
    const struct thud_param *param = thud_scene_param(&tui->doc.scene, key, &(int){0});
    if (!param || param->kind == THUD_PARAM_TEXT || thud_ascii_ends(key, ".law") || strcmp(key, "analysis.method") == 0)
        return;
    if (param->kind == THUD_PARAM_CHOICE) {
        if (param->choices)
            step_choice(tui, key, param, steps > 0 ? 1 : -1);
        return;
    }
    const char *end;
    double value = first_value(tui, key);
    if (thud_scene_get(&tui->doc.scene, key, text, sizeof text, NULL) != THUD_OK ||
        (thud_number_parse(text, &end, &value) != 0 && isnan(value))) {
        thud_tui_say(tui, THUD_ROLE_WARN, "%s has no number yet: type one", param->name);
        return;
    }
    bool whole = param->kind == THUD_PARAM_INTEGER;
    double step = whole ? 1.0 : value != 0.0 ? pow(10.0, floor(log10(fabs(value)) + 1e-9) - 1.0) : 0.1;
    double next = step * round(value / step + steps);
    snprintf(number, sizeof number, "%.12g", fabs(next) < 1e-9 * step ? 0.0 : next);
    thud_tui_shown_unit(tui, key, unit, sizeof unit);
    if (whole)
        *unit = '\0';
    snprintf(text, sizeof text, "%s%s%s", number, *unit ? " " : "", unit);
    thud_tui_set_step(tui, key, text);
}

void thud_tui_toggle(struct thud_tui *tui)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    const struct thud_param *param = field ? thud_scene_param(&tui->doc.scene, field->path, &(int){0}) : NULL;
    if (!param)
        return;
    if (param->kind == THUD_PARAM_CHOICE && param->choices)
        step_choice(tui, field->path, param, 1);
    else
        thud_tui_say(tui, THUD_ROLE_WARN, "%s is no choice: Enter edits it", param->name);
}
