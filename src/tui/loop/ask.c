/* Prompts, lists and questions, and the work with files that they are for. */
#include <dirent.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/scan.h"
#include "tui/document/session_log.h"
#include "tui/screens/new_scene.h"

void thud_tui_prompt(struct thud_tui *tui, enum thud_typing typing, const char *text)
{
    tui->mode = THUD_MODE_TYPING;
    tui->typing = typing;
    tui->history_at = tui->nhistory;
    thud_line_set(&tui->line, text);
}

void thud_tui_prompt_done(struct thud_tui *tui)
{
    char text[THUD_LINE_MAX];
    snprintf(text, sizeof text, "%s", tui->line.text);
    tui->mode = THUD_MODE_NORMAL;
    tui->message[0] = '\0';
    if (tui->typing == THUD_TYPE_COMMAND) {
        thud_tui_remember(tui, text);
        thud_tui_command(tui, text);
    } else if (tui->typing == THUD_TYPE_STUDY)
        thud_tui_sweep_typed(tui, text);
    else if (tui->typing == THUD_TYPE_SEARCH)
        thud_tui_help_typed(tui, text);
    else if (tui->typing == THUD_TYPE_FILTER)
        thud_tui_filter_records(tui, text);
    else if (*text)
        thud_tui_save(tui, text, false);
}

void thud_tui_choose(struct thud_tui *tui, enum thud_choosing choosing, const char *title)
{
    tui->mode = THUD_MODE_CHOOSING;
    tui->choosing = choosing;
    thud_chooser_begin(&tui->chooser, title);
}

void thud_tui_go_to_field(struct thud_tui *tui, const char *key)
{
    int number = 0, last = tui->doc.scene.nstructures - 2;
    enum thud_screen screen = THUD_SCREEN_RESULTS;
    const char *at = key;
    if (thud_scan_word(&at, "structures.") && thud_scan_count(&at, &number)) {
        screen = THUD_SCREEN_MODEL;
        if (number - 1 < tui->pair || number - 1 > tui->pair + 1)
            tui->pair = number - 1 > last ? last : number - 1;
    } else if (thud_scan_word(&at, "interfaces.") && thud_scan_count(&at, &number)) {
        screen = THUD_SCREEN_CONTACT;
        tui->pair = number - 1;
    } else if (strncmp(key, "record.", 7) == 0) {
        screen = THUD_SCREEN_RECORD;
    }
    if (tui->pair < 0)
        tui->pair = 0;
    thud_form_focus_on(&tui->form, (int)screen, key);
    thud_tui_go(tui, screen);
}

static void list_presets(struct thud_tui *tui, const char *folder);

void thud_tui_chosen(struct thud_tui *tui)
{
    const struct thud_choice *choice = thud_chooser_marked(&tui->chooser);
    if (!choice)
        return;
    tui->mode = THUD_MODE_NORMAL;
    char value[128];
    snprintf(value, sizeof value, "%s", choice->value);
    if (tui->choosing == THUD_CHOOSE_VALUE)
        thud_tui_set(tui, tui->target, value);
    else if (tui->choosing == THUD_CHOOSE_PRESET && *value && value[strlen(value) - 1] == '/')
        list_presets(tui, value);
    else if (tui->choosing == THUD_CHOOSE_PRESET)
        thud_tui_open(tui, value, false);
    else if (tui->choosing == THUD_CHOOSE_BESIDE)
        thud_tui_beside(tui, value);
    else if (tui->choosing == THUD_CHOOSE_FIELD)
        thud_tui_go_to_field(tui, value);
}

static void ask(struct thud_tui *tui, enum thud_asking asking, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    vsnprintf(tui->message, sizeof tui->message, fmt, args);
    va_end(args);
    tui->message_role = THUD_ROLE_WARN;
    tui->mode = THUD_MODE_ASKING;
    tui->asking = asking;
}

static void recover(struct thud_tui *tui, const char *path);

bool thud_tui_asks_to_save(const struct thud_tui *tui)
{
    return tui->asking == THUD_ASK_QUIT || tui->asking == THUD_ASK_OPEN || tui->asking == THUD_ASK_NEW;
}

void thud_tui_answered(struct thud_tui *tui, int key)
{
    bool yes = key == 'y' || key == 'Y', no = key == 'n' || key == 'N' || key == THUD_KEY_ESC;
    bool unsaved = thud_tui_asks_to_save(tui);
    bool save = unsaved && (key == 's' || key == 'S');
    if (!yes && !no && !save)
        return;
    char target[sizeof tui->target];
    snprintf(target, sizeof target, "%s", tui->target);
    tui->mode = THUD_MODE_NORMAL;
    tui->message[0] = '\0';
    if (no)
        return;
    if (save) {
        tui->quit_next = tui->asking == THUD_ASK_QUIT;
        tui->new_next = tui->asking == THUD_ASK_NEW;
        snprintf(tui->open_next, sizeof tui->open_next, "%s", tui->asking == THUD_ASK_OPEN ? target : "");
        thud_tui_save(tui, NULL, false);
    } else if (tui->asking == THUD_ASK_QUIT)
        thud_tui_quit(tui, true);
    else if (tui->asking == THUD_ASK_OPEN)
        thud_tui_open(tui, target, true);
    else if (tui->asking == THUD_ASK_NEW)
        thud_tui_new(tui, true);
    else if (tui->asking == THUD_ASK_RECOVER)
        recover(tui, target);
    else
        thud_tui_save(tui, tui->asking == THUD_ASK_DISK ? NULL : target, true);
}

static bool exists(const char *path)
{
    FILE *file = fopen(path, "r");
    if (file)
        fclose(file);
    return file != NULL;
}

/* The file of another name: `.yaml` is added where a bare name was typed. */
static void save_path(const char *typed, char *path, size_t size)
{
    const char *slash = strrchr(typed, '/'), *name = slash ? slash + 1 : typed;
    snprintf(path, size, "%s%s", typed, strchr(name, '.') ? "" : ".yaml");
}

/* The file has everything now: what was asked for after saving is done. */
static void saved(struct thud_tui *tui)
{
    char next[sizeof tui->open_next];
    thud_tui_log(tui, "write %s", tui->doc.path);
    if (!tui->pin.own)
        thud_pin_take(&tui->pin, &tui->doc, false);
    thud_tui_say(tui, THUD_ROLE_GOOD, "Saved %s, comments kept", tui->doc.path);
    snprintf(next, sizeof next, "%s", tui->open_next);
    tui->open_next[0] = '\0';
    if (tui->quit_next)
        tui->quit = true;
    else if (*next)
        thud_tui_open(tui, next, true);
    else if (tui->new_next)
        thud_tui_new(tui, true);
    tui->quit_next = tui->new_next = false;
}

void thud_tui_save(struct thud_tui *tui, const char *path, bool sure)
{
    char to[512] = "", before[512];
    if (path)
        save_path(path, to, sizeof to);
    snprintf(before, sizeof before, "%s", tui->doc.path);
    bool other = path && strcmp(to, before) != 0;
    if (thud_doc_is_shipped(&tui->doc, other ? to : before)) {
        char name[THUD_NAME_MAX + 16];
        snprintf(name, sizeof name, "my-%s.yaml", tui->doc.scene.name);
        thud_tui_prompt(tui, THUD_TYPE_SAVE_AS, name);
        tui->line.selected = true;
        thud_tui_say(tui, THUD_ROLE_WARN, "Presets that come with thud stay as they are: a name for yours");
        return;
    }
    snprintf(tui->target, sizeof tui->target, "%s", to);
    if (!sure && other && exists(to)) {
        ask(tui, THUD_ASK_OVERWRITE, "%s exists. Write over it?", to);
        return;
    }
    if (!sure && !other && thud_doc_disk_changed(&tui->doc)) {
        ask(tui, THUD_ASK_DISK, "%s was changed by someone else since it was read. Write over it?", before);
        return;
    }
    struct thud_error err;
    if (thud_doc_save(&tui->doc, other ? to : NULL, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        saved(tui);
}

void thud_tui_open(struct thud_tui *tui, const char *name, bool sure)
{
    struct thud_error err;
    if (!sure && thud_doc_unsaved(&tui->doc)) {
        snprintf(tui->target, sizeof tui->target, "%s", name);
        ask(tui, THUD_ASK_OPEN, "%s has unsaved changes, and %s is to be opened", tui->doc.scene.name, name);
        return;
    }
    thud_live_clear(&tui->live); /* its runs look at the record, which goes with the preset */
    tui->ran_revision = 0;
    if (thud_doc_open(&tui->doc, name, &err) != THUD_OK) {
        thud_tui_say_error(tui, &err);
        thud_tui_changed(tui);
        return;
    }
    thud_tui_log(tui, "open %s", name);
    thud_tui_say(tui, THUD_ROLE_GOOD, "Opened %s: %s", tui->doc.path, tui->doc.scene.title);
    thud_tui_opened(tui);
}

void thud_tui_new(struct thud_tui *tui, bool sure)
{
    if (!sure && thud_doc_unsaved(&tui->doc))
        ask(tui, THUD_ASK_NEW, "%s has unsaved changes", tui->doc.scene.name);
    else
        thud_new_scene_begin(tui);
}

void thud_tui_quit(struct thud_tui *tui, bool sure)
{
    if (!sure && thud_doc_unsaved(&tui->doc)) {
        ask(tui, THUD_ASK_QUIT, "%s has unsaved changes", tui->doc.scene.name);
        return;
    }
    tui->quit = true;
}

void thud_tui_offer_recovery(struct thud_tui *tui)
{
    char path[sizeof tui->target];
    thud_doc_recovery_path(&tui->doc, path, sizeof path);
    if (!exists(path))
        return;
    snprintf(tui->target, sizeof tui->target, "%s", path);
    ask(tui, THUD_ASK_RECOVER, "Unsaved changes were kept in %s. Take them?", path);
}

/* The scene of the file that was kept, as a change to be saved or undone; saving removes the file. */
static void recover(struct thud_tui *tui, const char *path)
{
    struct thud_preset *preset = NULL;
    struct thud_error err = {0};
    struct thud_scene *next = malloc(sizeof *next);
    enum thud_status status =
        next ? thud_preset_read(path, &preset, &err) : thud_error_set(&err, THUD_MEMORY, "no memory for the scene");
    if (status == THUD_OK) {
        *next = *thud_preset_scene(preset);
        memcpy(next->name, tui->doc.scene.name, sizeof next->name);
        status = thud_doc_change(&tui->doc, next, "recovered changes", &err);
    }
    thud_preset_free(preset);
    free(next);
    if (status != THUD_OK) {
        thud_tui_say_error(tui, &err);
        return;
    }
    snprintf(tui->doc.kept, sizeof tui->doc.kept, "%s", path);
    thud_tui_say(tui, THUD_ROLE_GOOD, "Recovered: w saves, u undoes");
    thud_tui_changed(tui);
}

/* Presets of the working folder and those that come with thud, or of a folder that was gone into. */
static void list_presets(struct thud_tui *tui, const char *folder)
{
    struct thud_browse files = {0};
    char title[96];
    snprintf(title, sizeof title, "Open a preset%s%.50s", *folder ? " of " : "", folder);
    thud_browse_list(&files, THUD_BROWSE_PRESETS, tui->doc.paths, tui->doc.path, folder);
    thud_tui_choose(tui, THUD_CHOOSE_PRESET, title);
    for (int i = 0; i < files.n; i++)
        if (strlen(files.item[i].name) < sizeof tui->chooser.choice->value)
            thud_chooser_add(&tui->chooser, files.item[i].name, "%-30s %s", files.item[i].name,
                             thud_browse_about(&files, i));
    thud_browse_clear(&files);
    thud_chooser_mark(&tui->chooser, tui->doc.scene.name);
}

void thud_tui_list_presets(struct thud_tui *tui)
{
    DIR *folder = opendir(tui->doc.paths->presets);
    if (!folder)
        thud_tui_say(tui, THUD_ROLE_ERROR, "! the presets' folder %s cannot be read; :open PATH opens any file",
                     tui->doc.paths->presets);
    else
        closedir(folder);
    list_presets(tui, "");
}

/* Words that people look for and no title has. */
static const char *also_called(const char *name)
{
    static const struct {
        const char *name, *words;
    } table[] = {{"peak", "PGA"},
                 {"restitution", "COR e"},
                 {"stiffness", "k"},
                 {"gap", "separation distance"},
                 {"damping", "xi zeta"},
                 {"file", "record ground motion accelerogram"},
                 {"factor", "scale"},
                 {"law", "contact model"},
                 {"method", "integrator solver"},
                 {"tail", "duration"},
                 {"mass", "weight"},
                 {"thickness", "rubber"},
                 {"storeys", "floors stories"},
                 {"from", "trim"},
                 {"to", "trim"}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (strcmp(table[i].name, name) == 0)
            return table[i].words;
    return "";
}

static void add_field(struct thud_tui *tui, const char *key, const struct thud_param *param)
{
    char value[96] = "";
    if (thud_scene_get(&tui->doc.scene, key, value, sizeof value, NULL) == THUD_OK)
        thud_chooser_add(&tui->chooser, key, "%-32s %-18.40s %.50s %s", key, value, param->title,
                         also_called(param->name));
}

/* Adds the parameters of a group under a prefix, those by floor for every floor. */
static void add_group(struct thud_tui *tui, enum thud_group group, const char *prefix, int structure)
{
    int count;
    const struct thud_param *param = thud_group_params(group, &count);
    const struct thud_structure *at = structure >= 0 ? &tui->doc.scene.structure[structure] : NULL;
    for (int i = 0; i < count; i++) {
        char key[THUD_PATH_MAX];
        if (at && group == THUD_GROUP_STRUCTURE && !thud_structure_has(at->kind, i))
            continue;
        snprintf(key, sizeof key, "%s.%s", prefix, param[i].name);
        bool by_floor = at && thud_scene_by_floor(&tui->doc.scene, key);
        for (int floor = 1; floor <= (by_floor ? at->storeys : 1); floor++) {
            char number[16] = "";
            if (by_floor)
                snprintf(number, sizeof number, ".%d", floor);
            snprintf(key, sizeof key, "%s%s%s%s", prefix, *prefix ? "." : "", param[i].name, number);
            add_field(tui, key, &param[i]);
        }
    }
}

static void add_law(struct thud_tui *tui, const char *prefix, const struct thud_law *law)
{
    for (int i = 0; law && i < law->nparams; i++) {
        char key[THUD_PATH_MAX];
        snprintf(key, sizeof key, "%s.%s", prefix, law->params[i].name);
        add_field(tui, key, &law->params[i]);
    }
}

void thud_tui_list_fields(struct thud_tui *tui)
{
    thud_tui_fill_fields(tui);
    tui->mode = THUD_MODE_CHOOSING;
    tui->choosing = THUD_CHOOSE_FIELD;
}

void thud_tui_fill_fields(struct thud_tui *tui)
{
    const struct thud_scene *scene = &tui->doc.scene;
    char prefix[64];
    thud_chooser_begin(&tui->chooser, "Find a field");
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        snprintf(prefix, sizeof prefix, "interfaces.%d", i + 1);
        add_group(tui, THUD_GROUP_INTERFACE, prefix, -1);
        snprintf(prefix, sizeof prefix, "interfaces.%d.contact", i + 1);
        add_group(tui, THUD_GROUP_CONTACT, prefix, -1);
        add_law(tui, prefix, scene->interface[i].contact.law);
        if (!scene->interface[i].has_bumper)
            continue;
        snprintf(prefix, sizeof prefix, "interfaces.%d.bumper", i + 1);
        add_group(tui, THUD_GROUP_BUMPER, prefix, -1);
        add_law(tui, prefix, scene->interface[i].bumper.law);
    }
    for (int i = 0; i < scene->nstructures; i++) {
        snprintf(prefix, sizeof prefix, "structures.%d", i + 1);
        add_group(tui, THUD_GROUP_STRUCTURE, prefix, i);
        if (!thud_kind_is_building(scene->structure[i].kind))
            continue;
        snprintf(prefix, sizeof prefix, "structures.%d.column", i + 1);
        add_group(tui, THUD_GROUP_COLUMN, prefix, i);
    }
    add_group(tui, THUD_GROUP_SCENE, "", -1);
    add_group(tui, THUD_GROUP_RECORD, "record", -1);
    add_group(tui, THUD_GROUP_ANALYSIS, "analysis", -1);
}
