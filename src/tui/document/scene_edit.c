/* Changes of the scene: one value, or several at once. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "base/scan.h"
#include "io/record/record_file.h"
#include "study/scene/scene_edit.h"
#include "tui/document/scene_edit.h"
#include "tui/document/session_log.h"

double thud_scene_force_at_knee(const struct thud_scene *scene, int interface)
{
    if (interface < 0 || interface + 1 >= scene->nstructures || !scene->interface[interface].has_bumper)
        return NAN;
    struct thud_law_choice law = scene->interface[interface].bumper;
    const double *k = thud_law_given(&law, "stiffness"), *n = thud_law_given(&law, "exponent"),
                 *part = thud_law_given(&law, "max-strain");
    return k && n && part ? *k * pow(*part * scene->interface[interface].bumper_thickness_m, *n) : NAN;
}

/* The unit a field is shown in: that of its text now, else its table's. */
void thud_tui_shown_unit(const struct thud_tui *tui, const char *key, char *unit, size_t size)
{
    const struct thud_param *param = thud_scene_param(&tui->doc.scene, key, &(int){0});
    char text[128];
    const char *end;
    double number;
    snprintf(unit, size, "%s", param && param->unit ? param->unit : "");
    if (thud_scene_get(&tui->doc.scene, key, text, sizeof text, NULL) != THUD_OK ||
        thud_number_parse(text, &end, &number) != 0)
        return;
    while (*end == ' ')
        end++;
    if (*end)
        snprintf(unit, size, "%s", end);
}

/* What was typed, with the shown unit where it has none. */
void thud_tui_with_unit(const struct thud_tui *tui, const char *key, const char *typed, struct thud_text *text)
{
    const struct thud_param *param = thud_scene_param(&tui->doc.scene, key, &(int){0});
    const char *end;
    char unit[48] = "";
    double number;
    typed += strspn(typed, " ");
    size_t n = strlen(typed);
    while (n > 0 && typed[n - 1] == ' ')
        n--;
    if (param && param->kind == THUD_PARAM_QUANTITY && thud_number_parse(typed, &end, &number) == 0 && end >= typed + n)
        thud_tui_shown_unit(tui, key, unit, sizeof unit);
    thud_text_append(text, "%.*s%s%s", (int)n, typed, *unit ? " " : "", unit);
}

/* Soft bounds warn of a value as it was typed. */
static void warn(struct thud_tui *tui, const char *key, const char *text)
{
    const struct thud_param *param = thud_scene_param(&tui->doc.scene, key, &(int){0});
    char usual[96];
    struct thud_quantity value;
    if (!param || param->kind != THUD_PARAM_QUANTITY ||
        thud_quantity_parse(text, param->dimension, param->unit, &value, NULL) != THUD_OK ||
        !thud_param_unusual(param, value.value, usual, sizeof usual))
        return;
    thud_tui_say(tui, THUD_ROLE_WARN, "! %s %.60s is unusual (usual: %s). It is taken nevertheless", param->name, text,
                 usual);
}

/* The interface of a bumper's key. */
static int interface_of(const struct thud_tui *tui, const char *key)
{
    int interface;
    return thud_scan_word(&key, "interfaces.") && thud_scan_count(&key, &interface) ? interface - 1 : tui->interface;
}

/* An exponent keeps the number of its stiffness, so the force at delta_u changes: said, with a way out. */
static void say_force(struct thud_tui *tui, double before_n, int interface)
{
    const double now = thud_scene_force_at_knee(&tui->doc.scene, interface);
    char a[24], b[24];
    tui->kept.before_n = before_n;
    tui->kept.interface = interface;
    if (isfinite(before_n) && isfinite(now) && before_n != now)
        thud_tui_say(tui, THUD_ROLE_WARN,
                     "! %s keeps the number of the stiffness: F(delta_u) is now %s MN (was %s MN). f keeps F "
                     "instead, u undoes",
                     thud_undo_what(&tui->doc.undo, 0), thud_tui_number(1e-6 * now, a),
                     thud_tui_number(1e-6 * before_n, b));
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
    if (!thud_tui_succeeded(tui, status, &err))
        return false;
    thud_tui_log(tui, "record %s", file);
    thud_tui_follow(tui);
    if (tui->doc.record)
        thud_tui_say(tui, THUD_ROLE_PLAIN, "%s as recorded, %s g: peak, factor and part of the one before do not hold",
                     file, thud_tui_number(thud_record_peak(tui->doc.record) / THUD_GRAVITY, number));
    return true;
}

/* The files of kinds that are read, asked for before the kind is set: "structures.1.kind matrix" is the target. */
static void take_file(struct thud_tui *tui, const char *file)
{
    char key[sizeof tui->dialog.target], value[THUD_LINE_MAX + 16];
    snprintf(key, sizeof key, "%s", tui->dialog.target);
    char *kind = strchr(key, ' ');
    *kind++ = '\0';
    snprintf(value, sizeof value, "%s %s", kind, file);
    thud_tui_set(tui, key, value);
}

static void chosen_file(struct thud_tui *tui, const char *file)
{
    static const struct thud_prompt prompt = {.words = "file: ", .files = true, .done = take_file};
    if (*file)
        take_file(tui, file);
    else
        thud_tui_prompt(tui, &prompt, "");
}

static void choose_file(struct thud_tui *tui, const char *key, const char *kind)
{
    struct thud_browse files = {0};
    char target[sizeof tui->dialog.target]; /* the key may be the dialog's own */
    snprintf(target, sizeof target, "%s %s", key, kind);
    memcpy(tui->dialog.target, target, sizeof target);
    thud_browse_list(&files, THUD_BROWSE_RECORDS, tui->doc.paths, tui->doc.path, "");
    thud_tui_choose(tui, chosen_file,
                    strcmp(kind, "modes") == 0 ? "CSV of periods and shapes, one row per mode"
                                               : "CSV of the lateral stiffness, one row per floor");
    for (int i = 0; i < files.n; i++)
        if (thud_ascii_ends(files.item[i].name, ".csv") &&
            strlen(files.item[i].name) < sizeof(struct thud_choice){0}.value)
            thud_chooser_add(&tui->dialog.chooser, files.item[i].name, "%s", files.item[i].name);
    thud_chooser_add(&tui->dialog.chooser, "", "another file: its path is typed");
    thud_browse_clear(&files);
}

bool thud_tui_set(struct thud_tui *tui, const char *key, const char *text)
{
    struct thud_error err = {0};
    if (strcmp(key, "record.file") == 0) {
        thud_tui_hush(tui);
        return strcmp(text, tui->doc.scene.record.file) == 0 || thud_tui_choose_record(tui, text);
    }
    if (thud_ascii_ends(key, ".kind") && (strcmp(text, "matrix") == 0 || strcmp(text, "modes") == 0)) {
        choose_file(tui, key, text);
        return true;
    }
    struct thud_text full = {0};
    const double before_n = thud_scene_force_at_knee(&tui->doc.scene, interface_of(tui, key));
    thud_tui_with_unit(tui, key, text, &full);
    thud_tui_hush(tui);
    tui->kept.before_n = NAN;
    enum thud_status status = full.failed ? thud_error_set(&err, THUD_MEMORY, "no memory for the value")
                                          : thud_doc_set(&tui->doc, key, full.data, &err);
    if (status == THUD_OK) {
        thud_tui_log(tui, "set %s %s", key, full.data);
        if (thud_ascii_ends(key, "bumper.exponent"))
            say_force(tui, before_n, interface_of(tui, key));
        if (!*tui->said.text)
            warn(tui, key, full.data);
    } else
        thud_tui_say_error(tui, &err);
    thud_text_clear(&full);
    return status == THUD_OK;
}

/* The state that changes are compared with stays while the same value is stepped; what a key that is held does, or the
 * mouse with its button down, is one change, and one line of the log and of the list. */
bool thud_tui_set_step(struct thud_tui *tui, const char *key, const char *text)
{
    const bool more = strcmp(tui->run.stepped, key) == 0 && tui->run.stepped_to == tui->doc.revision,
               one = more && tui->again;
    if (one)
        thud_doc_undo(&tui->doc);
    const int before = tui->doc.undo.at;
    if (!thud_tui_set(tui, key, text)) {
        if (one)
            thud_doc_redo(&tui->doc);
        return false;
    }
    if (one)
        thud_tui_log_again(tui);
    snprintf(tui->run.stepped, sizeof tui->run.stepped, "%s", tui->doc.undo.at > before ? key : "");
    tui->run.stepped_to = tui->doc.revision;
    tui->run.stepping = more;
    return true;
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

/* The words are the command that a log has for it. */
static void change(struct thud_tui *tui, const struct thud_scene *next, const char *what, const char *words)
{
    struct thud_error err;
    if (!thud_tui_succeeded(tui, thud_doc_change(&tui->doc, next, what, &err), &err))
        return;
    thud_tui_log(tui, "%s", words);
    thud_tui_say(tui, THUD_ROLE_PLAIN, "%s (u undoes)", what);
}

void thud_tui_edit_scene(struct thud_tui *tui, const char *fmt, ...)
{
    struct thud_scene next = tui->doc.scene;
    struct thud_error err;
    struct thud_text words = {0};
    char what[300];
    va_list args;
    va_start(args, fmt);
    thud_text_append_list(&words, fmt, args);
    va_end(args);
    if (thud_scene_edit(&next, words.failed ? "" : words.data, what, sizeof what, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        change(tui, &next, what, words.data);
    thud_text_clear(&words);
}

void thud_tui_keep_force(struct thud_tui *tui)
{
    struct thud_scene next = tui->doc.scene;
    struct thud_law_choice *bumper = &next.interface[tui->kept.interface].bumper;
    double *k = thud_law_given(bumper, "stiffness");
    double now = thud_scene_force_at_knee(&next, tui->kept.interface), before = tui->kept.before_n;
    if (!k || !(now > 0.0) || !(before > 0.0))
        return;
    *k *= before / now;
    tui->kept.before_n = NAN;
    change(tui, &next, "stiffness chosen so that F(delta_u) is as before", "keep-force");
}

bool thud_tui_change_interface(struct thud_tui *tui, enum thud_action action)
{
    if (action != THUD_DO_NEXT_PAIR && action != THUD_DO_PREVIOUS_PAIR)
        return false;
    tui->interface += action == THUD_DO_NEXT_PAIR ? 1 : -1;
    return true;
}

const char *thud_tui_cannot_change_interface(struct thud_tui *tui, enum thud_action action)
{
    if (action == THUD_DO_NEXT_PAIR)
        return tui->interface + 2 < tui->doc.scene.nstructures ? NULL : "This is the last pair on the right";
    if (action == THUD_DO_PREVIOUS_PAIR)
        return tui->interface > 0 ? NULL : "This is the first pair on the left";
    return NULL;
}
