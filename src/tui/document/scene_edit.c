/* Changes of the scene: one value, or several at once. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "base/scan.h"
#include "io/record/record_file.h"
#include "study/scene/building.h"
#include "study/scene/level.h"
#include "tui/document/scene_edit.h"
#include "tui/document/session_log.h"

static double law_value(const struct thud_law_choice *choice, const char *name)
{
    int i = choice->law ? thud_law_param(choice->law, name) : -1;
    return i < 0 ? NAN : choice->value[i];
}

double thud_scene_force_at_knee(const struct thud_scene *scene, int interface)
{
    if (interface < 0 || interface + 1 >= scene->nstructures || !scene->interface[interface].has_bumper)
        return NAN;
    const struct thud_interface *at = &scene->interface[interface];
    double n = law_value(&at->bumper, "exponent"), part = law_value(&at->bumper, "max-strain");
    return law_value(&at->bumper, "stiffness") * pow(part * at->bumper_thickness_m, n);
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
    thud_tui_shown_unit(tui, key, unit, sizeof unit);
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
    thud_tui_say(tui, THUD_ROLE_WARN, "! %s %s is unusual (usual: %s). It is taken nevertheless", param->name, text,
                 usual);
}

/* An exponent keeps the number of its stiffness, so the force at delta_u changes: said, with a way out. */
static bool set_exponent(struct thud_tui *tui, const char *key, const char *text, struct thud_error *err)
{
    int interface = tui->interface;
    const char *at = key;
    if (thud_scan_word(&at, "interfaces.") && thud_scan_count(&at, &interface))
        interface--;
    double before = thud_scene_force_at_knee(&tui->doc.scene, interface);
    if (thud_doc_set(&tui->doc, key, text, err) != THUD_OK)
        return false;
    double now = thud_scene_force_at_knee(&tui->doc.scene, interface);
    tui->kept.before_n = before;
    tui->kept.interface = interface;
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
    char full[THUD_LINE_MAX + 64];
    if (thud_ascii_ends(key, ".kind") && (strcmp(text, "matrix") == 0 || strcmp(text, "modes") == 0)) {
        choose_file(tui, key, text);
        return true;
    }
    thud_tui_with_unit(tui, key, text, full, sizeof full);
    thud_tui_hush(tui);
    tui->kept.before_n = NAN;
    bool done = thud_ascii_ends(key, "bumper.exponent") ? set_exponent(tui, key, full, &err)
                                                        : thud_doc_set(&tui->doc, key, full, &err) == THUD_OK;
    if (!done) {
        thud_tui_say_error(tui, &err);
        return false;
    }
    if (!*tui->said.text)
        warn(tui, key);
    if (strcmp(key, "title") == 0)
        thud_tui_log(tui, "title %s", full);
    else
        thud_tui_log(tui, "set %s %s", key, full);
    return true;
}

/* The state that changes are compared with stays while the same value is stepped. */
bool thud_tui_set_step(struct thud_tui *tui, const char *key, const char *text)
{
    const bool more = strcmp(tui->run.stepped, key) == 0 && tui->run.stepped_to == tui->doc.revision;
    if (!thud_tui_set(tui, key, text))
        return false;
    if (tui->run.stepped != key)
        snprintf(tui->run.stepped, sizeof tui->run.stepped, "%s", key);
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

/* What ties neighbours no more goes with them. */
static void drop_loose_links(struct thud_scene *scene)
{
    for (int i = scene->nlinks - 1; i >= 0; i--)
        if (!thud_link_stands(scene, i))
            thud_link_remove(scene, i);
}

/* The command follows that a log has for it. */
THUD_PRINTF(4, 5)
static void change(struct thud_tui *tui, const struct thud_scene *next, const char *what, const char *fmt, ...)
{
    struct thud_error err;
    char command[64];
    va_list args;
    va_start(args, fmt);
    vsnprintf(command, sizeof command, fmt, args);
    va_end(args);
    if (thud_doc_change(&tui->doc, next, what, &err) != THUD_OK) {
        thud_tui_say_error(tui, &err);
        return;
    }
    thud_tui_log(tui, "%s", command);
    thud_tui_say(tui, THUD_ROLE_PLAIN, "%s (u undoes)", what);
}

static void move_floors(struct thud_structure *structure, int to, int from, int n)
{
    for (int i = 0; i < THUD_STRUCTURE_LISTS; i++) {
        double *list = thud_structure_list(structure, i);
        memmove(list + to, list + from, (size_t)n * sizeof *list);
    }
}

void thud_tui_add_storey(struct thud_tui *tui, int s, int floor)
{
    struct thud_scene next = tui->doc.scene;
    struct thud_structure *structure = &next.structure[s];
    char what[160];
    if (floor < 1 || floor > structure->storeys)
        floor = structure->storeys;
    move_floors(structure, floor, floor - 1, structure->storeys - floor + 1);
    structure->storeys++;
    thud_structure_fill_estimate(structure);
    snprintf(what, sizeof what, "%s: storey added above floor %d, like it", structure->name, floor);
    change(tui, &next, what, "storey add %d %d", s + 1, floor);
}

void thud_tui_delete_storey(struct thud_tui *tui, int s, int floor)
{
    struct thud_scene next = tui->doc.scene;
    struct thud_structure *structure = &next.structure[s];
    char what[160];
    move_floors(structure, floor - 1, floor, structure->storeys - floor);
    structure->storeys--;
    drop_loose_links(&next);
    /* what lies past the top is zero in every scene, so that equal scenes compare equal */
    for (int i = 0; i < THUD_STRUCTURE_LISTS; i++)
        thud_structure_list(structure, i)[structure->storeys] = 0.0;
    thud_structure_fill_estimate(structure);
    snprintf(what, sizeof what, "%s: storey %d deleted", structure->name, floor);
    change(tui, &next, what, "storey delete %d %d", s + 1, floor);
}

/* The first letter no structure is called by. */
static void new_name(const struct thud_scene *scene, char *name)
{
    for (int letter = 'A'; letter <= 'Z'; letter++) {
        bool taken = false;
        for (int i = 0; i < scene->nstructures; i++)
            taken = taken || (scene->structure[i].name[0] == letter && scene->structure[i].name[1] == '\0');
        if (taken)
            continue;
        memset(name, 0, THUD_NAME_MAX);
        name[0] = (char)letter;
        return;
    }
}

/* With more than one interface, keys of the study that stood for the only one have to say so. True: some had to. */
static bool rename_varied(struct thud_scene *scene)
{
    static const char only[] = "interfaces.1.";
    bool renamed = false;
    for (int i = 0; i < scene->study.nvary; i++) {
        char *key = scene->study.vary[i].key, whole[THUD_VARY_KEY + sizeof only] = "";
        int floor;
        snprintf(whole, sizeof whole, "%s%s", only, key);
        if (thud_scene_param(scene, key, &floor) || !thud_scene_param(scene, whole, &floor) ||
            strlen(whole) >= THUD_VARY_KEY)
            continue;
        memcpy(key, whole, strlen(whole) + 1);
        renamed = true;
    }
    return renamed;
}

void thud_tui_add_structure(struct thud_tui *tui, int s)
{
    struct thud_scene next = tui->doc.scene;
    char name[THUD_NAME_MAX] = "", what[160];
    int n = next.nstructures, from = s < n - 1 ? s : n - 2;
    new_name(&next, name);
    memmove(&next.structure[s + 1], &next.structure[s], (size_t)(n - s) * sizeof *next.structure);
    if (from >= 0)
        memmove(&next.interface[from + 1], &next.interface[from], (size_t)(n - 1 - from) * sizeof *next.interface);
    memcpy(next.structure[s + 1].name, name, sizeof name);
    next.nstructures++;
    drop_loose_links(&next);
    snprintf(what, sizeof what, "%s added to the right of %s, like it%s", name, next.structure[s].name,
             rename_varied(&next) ? "; the study varies interfaces.1" : "");
    change(tui, &next, what, "structure add %d", s + 1);
}

void thud_tui_remove_structure(struct thud_tui *tui, int s)
{
    struct thud_scene next = tui->doc.scene;
    char what[160];
    int n = next.nstructures, gone = s < n - 1 ? s : n - 2;
    snprintf(what, sizeof what, "%s removed", next.structure[s].name);
    memmove(&next.structure[s], &next.structure[s + 1], (size_t)(n - 1 - s) * sizeof *next.structure);
    memmove(&next.interface[gone], &next.interface[gone + 1], (size_t)(n - 2 - gone) * sizeof *next.interface);
    memset(&next.structure[n - 1], 0, sizeof *next.structure);
    memset(&next.interface[n - 2], 0, sizeof *next.interface);
    next.nstructures--;
    drop_loose_links(&next);
    change(tui, &next, what, "structure remove %d", s + 1);
}

void thud_tui_swap(struct thud_tui *tui, int s)
{
    struct thud_scene next = tui->doc.scene;
    char what[160];
    next.structure[s] = tui->doc.scene.structure[s + 1];
    next.structure[s + 1] = tui->doc.scene.structure[s];
    drop_loose_links(&next);
    snprintf(what, sizeof what, "%s and %s swapped", next.structure[s + 1].name, next.structure[s].name);
    change(tui, &next, what, "swap %d", s + 1);
}

void thud_tui_toggle_bumper(struct thud_tui *tui, int i)
{
    struct thud_scene next = tui->doc.scene;
    struct thud_interface *interface = &next.interface[i];
    interface->has_bumper = !interface->has_bumper;
    if (interface->has_bumper && !interface->bumper.law) /* there has been none yet: the paper's */
        thud_interface_add_bumper(interface);
    char what[80];
    snprintf(what, sizeof what, "bumper %s", interface->has_bumper ? "off -> on" : "on -> off");
    change(tui, &next, what, "bumper %d", i + 1);
}

void thud_tui_keep_force(struct thud_tui *tui)
{
    struct thud_scene next = tui->doc.scene;
    struct thud_law_choice *bumper = &next.interface[tui->kept.interface].bumper;
    int k = bumper->law ? thud_law_param(bumper->law, "stiffness") : -1;
    double now = thud_scene_force_at_knee(&next, tui->kept.interface), before = tui->kept.before_n;
    if (k < 0 || !(now > 0.0) || !(before > 0.0))
        return;
    bumper->value[k] *= before / now;
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

/* An end of a new link: the floor of a building, or a body or wall by its name. */
static void name_end(const struct thud_structure *structure, int floor, char end[THUD_NAME_MAX + 8])
{
    char name[THUD_NAME_MAX];
    memcpy(name, structure->name, sizeof name);
    if (thud_structure_floors(structure) > 1)
        snprintf(end, THUD_NAME_MAX + 8, "%s.%d", name, floor);
    else
        snprintf(end, THUD_NAME_MAX + 8, "%s", name);
}

void thud_tui_add_link(struct thud_tui *tui, int interface)
{
    struct thud_scene next = tui->doc.scene;
    const struct thud_structure *left = &next.structure[interface], *right = left + 1;
    int a = thud_structure_floors(left), b = thud_structure_floors(right);
    if (next.nlinks == THUD_LINKS_MAX) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "There are %d links, and no more can be added", THUD_LINKS_MAX);
        return;
    }
    struct thud_link *link = &next.link[next.nlinks++];
    thud_link_init(link, THUD_LINK_DASHPOT);
    link->damping_nspm = 1e6;
    name_end(left, b > 1 && b < a ? b : a, link->from);
    name_end(right, a > 1 && a < b ? a : b, link->to);
    char what[256];
    snprintf(what, sizeof what, "a dashpot ties %s and %s", link->from, link->to);
    change(tui, &next, what, "link add %d", interface + 1);
}

void thud_tui_delete_link(struct thud_tui *tui, int link)
{
    struct thud_scene next = tui->doc.scene;
    char what[256];
    snprintf(what, sizeof what, "the link of %s and %s is gone", next.link[link].from, next.link[link].to);
    thud_link_remove(&next, link);
    change(tui, &next, what, "link remove %d", link + 1);
}
