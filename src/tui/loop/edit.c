/* Changing values: typed, stepped, toggled, chosen. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/scan.h"
#include "core/methods/method.h"
#include "io/record/record_file.h"
#include "tui/document/session_log.h"

static bool ends_with(const char *text, const char *end)
{
    size_t n = strlen(text), m = strlen(end);
    return n >= m && strcmp(text + n - m, end) == 0;
}

/* The unit a field is shown in: that of its text now, else its table's. */
static void shown_unit(const struct thud_tui *tui, const char *key, const struct thud_param *param, char *unit,
                       size_t size)
{
    char text[128];
    const char *end;
    double number;
    snprintf(unit, size, "%s", param->unit ? param->unit : "");
    if (thud_scene_get(&tui->doc.scene, key, text, sizeof text, NULL) != THUD_OK ||
        thud_number_parse(text, &end, &number) != 0)
        return;
    while (*end == ' ')
        end++;
    if (*end)
        snprintf(unit, size, "%s", end);
}

/* What was typed, with the shown unit where it has none. */
void thud_tui_with_unit(const struct thud_tui *tui, const char *key, const char *typed, char *text, size_t size)
{
    const struct thud_param *param = thud_scene_param(&tui->doc.scene, key, &(int){0});
    const char *end;
    double number;
    while (*typed == ' ')
        typed++;
    snprintf(text, size, "%s", typed);
    for (size_t n = strlen(text); n > 0 && text[n - 1] == ' '; n--)
        text[n - 1] = '\0';
    if (!param || param->kind != THUD_PARAM_QUANTITY || thud_number_parse(text, &end, &number) != 0 || *end)
        return;
    char unit[48];
    shown_unit(tui, key, param, unit, sizeof unit);
    size_t n = strlen(text);
    snprintf(text + n, size - n, "%s%s", *unit ? " " : "", unit);
}

/* Soft bounds warn. */
static void warn(struct thud_tui *tui, const char *key)
{
    const struct thud_param *param = thud_scene_param(&tui->doc.scene, key, &(int){0});
    char text[128], usual[96];
    struct thud_quantity value;
    if (!param || param->kind != THUD_PARAM_QUANTITY ||
        thud_scene_get(&tui->doc.scene, key, text, sizeof text, NULL) != THUD_OK ||
        thud_quantity_parse(text, param->dimension, param->unit, &value, NULL) != THUD_OK ||
        !thud_param_unusual(param, value.value, usual, sizeof usual))
        return;
    thud_tui_say(tui, THUD_ROLE_WARN, "! %s %s is unusual (usual: %s). It is taken as it is", param->name, text, usual);
}

/* An exponent keeps the number of its stiffness, so the force at delta_u changes: said, with a way out. */
static bool set_exponent(struct thud_tui *tui, const char *key, const char *text, struct thud_error *err)
{
    int interface = tui->pair;
    const char *at = key;
    if (thud_scan_word(&at, "interfaces.") && thud_scan_count(&at, &interface))
        interface--;
    double before = thud_tui_force_at_knee(&tui->doc.scene, interface);
    if (thud_doc_set(&tui->doc, key, text, err) != THUD_OK)
        return false;
    double now = thud_tui_force_at_knee(&tui->doc.scene, interface);
    tui->kept_before_n = before;
    tui->kept_interface = interface;
    char a[24], b[24];
    if (isfinite(before) && isfinite(now) && before != now)
        thud_tui_say(tui, THUD_ROLE_WARN,
                     "! %s keeps the number of the stiffness: F(delta_u) is now %s MN (was %s MN). f keeps F "
                     "instead, u undoes",
                     thud_undo_what(&tui->doc.undo, 0), thud_tui_number(1e-6 * now, a),
                     thud_tui_number(1e-6 * before, b));
    return true;
}

/* Why the ground motion that a choice names cannot be had; THUD_OK also where the file is there and only does not say
 * something that a field here can (its step, unit, column, ...). */
static enum thud_status try_record(const struct thud_tui *tui, const struct thud_record_choice *choice,
                                   struct thud_error *err)
{
    char path[512];
    struct thud_record *record;
    enum thud_status status = thud_paths_record(tui->doc.paths, tui->doc.path, choice->file, path, sizeof path, err);
    if (status != THUD_OK)
        return status;
    status = thud_record_file_read(path, choice, &record, err);
    if (status == THUD_OK)
        thud_record_free(record);
    char key[sizeof err->key + 8];
    snprintf(key, sizeof key, "record.%s", err->key);
    return status == THUD_OK || (*err->key && thud_scene_param(&tui->doc.scene, key, &(int){0})) ? THUD_OK : status;
}

bool thud_tui_choose_record(struct thud_tui *tui, const char *file)
{
    struct thud_scene next = tui->doc.scene;
    struct thud_error err = {0};
    char what[200], number[24];
    thud_record_choice_replace(&next.record, file);
    enum thud_status status = *file ? try_record(tui, &next.record, &err) : THUD_OK;
    snprintf(what, sizeof what, "record.file %.60s -> %.60s",
             *tui->doc.scene.record.file ? tui->doc.scene.record.file : "none", *file ? file : "none");
    if (status == THUD_OK)
        status = thud_doc_change(&tui->doc, &next, what, &err);
    if (status != THUD_OK) {
        thud_tui_say_error(tui, &err);
        return false;
    }
    thud_tui_log(tui, "record %s", file);
    thud_tui_changed(tui);
    if (tui->doc.record)
        thud_tui_say(tui, THUD_ROLE_PLAIN, "%s as recorded, %s g: peak, factor and part of the one before do not hold",
                     file, thud_tui_number(thud_record_peak(tui->doc.record) / THUD_GRAVITY, number));
    return true;
}

bool thud_tui_set(struct thud_tui *tui, const char *key, const char *text)
{
    struct thud_error err = {0};
    if (strcmp(key, "record.file") == 0) {
        tui->message[0] = '\0';
        return strcmp(text, tui->doc.scene.record.file) == 0 || thud_tui_choose_record(tui, text);
    }
    char full[THUD_LINE_MAX + 64];
    thud_tui_with_unit(tui, key, text, full, sizeof full);
    tui->message[0] = '\0';
    tui->kept_before_n = NAN;
    bool done = ends_with(key, "bumper.exponent") ? set_exponent(tui, key, full, &err)
                                                  : thud_doc_set(&tui->doc, key, full, &err) == THUD_OK;
    if (!done) {
        thud_tui_say_error(tui, &err);
        return false;
    }
    if (!*tui->message)
        warn(tui, key);
    if (strcmp(key, "title") == 0)
        thud_tui_log(tui, "title %s", full);
    else
        thud_tui_log(tui, "set %s %s", key, full);
    thud_tui_changed(tui);
    return true;
}

static void offer_laws(struct thud_tui *tui)
{
    for (int i = 0; i < thud_law_count(); i++)
        thud_chooser_add(&tui->chooser, thud_law_at(i)->name, "%-26s %s", thud_law_at(i)->name,
                         thud_law_at(i)->summary);
}

static void offer_methods(struct thud_tui *tui)
{
    thud_chooser_add(&tui->chooser, "auto", "%-22s %s", "auto", "no step to choose; a run says what it took");
    for (int i = 0; i < thud_method_count(); i++)
        thud_chooser_add(&tui->chooser, thud_method_at(i)->name, "%-22s %s", thud_method_at(i)->name,
                         thud_method_at(i)->summary);
}

/* Whether a value is a word of a closed list. */
static bool is_word(const char *key, const struct thud_param *param)
{
    return ends_with(key, ".law") || strcmp(key, "analysis.method") == 0 ||
           (param->kind == THUD_PARAM_CHOICE && param->choices);
}

bool thud_tui_typable(const struct thud_tui *tui, const struct thud_field *field)
{
    if (!field || field->kind != THUD_FIELD_VALUE)
        return false;
    const struct thud_param *param = thud_scene_param(&tui->doc.scene, field->path, &(int){0});
    return param && !is_word(field->path, param);
}

/* A value with a closed list of words: a list to choose from. False: it has none. */
static bool choose_value(struct thud_tui *tui, const char *key, const struct thud_param *param)
{
    bool law = ends_with(key, ".law"), method = strcmp(key, "analysis.method") == 0;
    if (!is_word(key, param))
        return false;
    char now[128] = "";
    thud_scene_get(&tui->doc.scene, key, now, sizeof now, NULL);
    snprintf(tui->target, sizeof tui->target, "%s", key);
    thud_tui_choose(tui, THUD_CHOOSE_VALUE, key);
    if (law)
        offer_laws(tui);
    else if (method)
        offer_methods(tui);
    else
        for (int i = 0; param->choices[i]; i++)
            thud_chooser_add(&tui->chooser, param->choices[i], "%s", param->choices[i]);
    thud_chooser_mark(&tui->chooser, now);
    return true;
}

void thud_tui_edit(struct thud_tui *tui, bool select)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    if (!field)
        return;
    if (field->kind == THUD_FIELD_ROW) {
        const struct thud_view *view = thud_view_of(tui->screen);
        if (view->row)
            view->row(tui, field);
        return;
    }
    const struct thud_param *param = thud_scene_param(&tui->doc.scene, field->path, &(int){0});
    if (!param || choose_value(tui, field->path, param))
        return;
    char old[THUD_LINE_MAX] = "";
    thud_scene_get(&tui->doc.scene, field->path, old, sizeof old, NULL);
    snprintf(tui->target, sizeof tui->target, "%s", field->path);
    (select ? thud_line_select : thud_line_set)(&tui->line, old);
    tui->message[0] = '\0';
    tui->mode = THUD_MODE_TYPING;
    tui->typing = THUD_TYPE_FIELD;
}

bool thud_tui_accept(struct thud_tui *tui)
{
    char old[THUD_LINE_MAX] = "";
    thud_scene_get(&tui->doc.scene, tui->target, old, sizeof old, NULL);
    if (strcmp(old, tui->line.text) != 0 && !thud_tui_set(tui, tui->target, tui->line.text))
        return false; /* what was typed stays in the editor, the message says what is wrong */
    tui->mode = THUD_MODE_NORMAL;
    thud_tui_draw(tui);
    return true;
}

void thud_tui_accept_and_go(struct thud_tui *tui, enum thud_action action)
{
    if (!thud_tui_accept(tui))
        return;
    char said[sizeof tui->message];
    snprintf(said, sizeof said, "%s", tui->message);
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
    if (thud_tui_typable(tui, now) && strcmp(now->path, tui->target) != 0)
        thud_tui_edit(tui, true);
    snprintf(tui->message, sizeof tui->message, "%s", said); /* a warning about the last value stays */
}

static void step_choice(struct thud_tui *tui, const char *key, const struct thud_param *param, int steps)
{
    char now[128] = "";
    int n = 0, at = 0;
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
    if (!param || param->kind == THUD_PARAM_TEXT || ends_with(key, ".law") || strcmp(key, "analysis.method") == 0)
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
    shown_unit(tui, key, param, unit, sizeof unit);
    if (whole)
        *unit = '\0';
    snprintf(text, sizeof text, "%s%s%s", number, *unit ? " " : "", unit);
    thud_tui_set(tui, key, text);
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

/* The value under the cursor, for every floor of its structure. */
void thud_tui_all_floors(struct thud_tui *tui)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    char text[128], key[THUD_PATH_MAX];
    if (!field || thud_scene_get(&tui->doc.scene, field->path, text, sizeof text, NULL) != THUD_OK)
        return;
    snprintf(key, sizeof key, "%s", field->path);
    char *dot = strrchr(key, '.');
    if (dot && thud_ascii_is_digit(dot[1]))
        *dot = '\0';
    thud_tui_set(tui, key, text);
}
