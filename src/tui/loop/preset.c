/* The preset that is open: saved, left for another one, recovered, given up. */
#include <dirent.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tui/document/session_log.h"
#include "tui/loop/loop.h"
#include "tui/loop/new_scene.h"

/* The file of another name: `.yaml` is added where a bare name was typed that is no device's. */
static void save_path(const char *typed, char *path, size_t size)
{
    const char *slash = strrchr(typed, '/'), *name = slash ? slash + 1 : typed;
    struct stat about;
    const bool device = stat(typed, &about) == 0 && !S_ISREG(about.st_mode) && !S_ISDIR(about.st_mode);
    snprintf(path, size, "%s%s", typed, device || strchr(name, '.') ? "" : ".yaml");
}

static void save_typed(struct thud_tui *tui, const char *text)
{
    if (*text)
        thud_tui_save(tui, text, false);
}

static const struct thud_prompt save_as = {.words = "save as: ", .files = true, .done = save_typed};

void thud_tui_save_as(struct thud_tui *tui)
{
    char name[THUD_NAME_MAX + 16];
    snprintf(name, sizeof name, "my-%s.yaml", tui->doc.scene.name);
    thud_tui_prompt(tui, &save_as, thud_doc_is_shipped(&tui->doc, tui->doc.path) ? name : tui->doc.path);
}

static void overwrite(struct thud_tui *tui, const char *path)
{
    thud_tui_save(tui, *path ? path : NULL, true);
}

/* The file has everything now: what was asked for after saving is done. */
static void saved(struct thud_tui *tui)
{
    const struct thud_question *next = tui->dialog.after_save;
    tui->dialog.after_save = NULL;
    thud_tui_log(tui, "write %s", tui->doc.path);
    thud_tui_say(tui, THUD_ROLE_GOOD, "Saved %s, comments kept", tui->doc.path);
    if (next)
        next->yes(tui, tui->dialog.after_target);
}

void thud_tui_save(struct thud_tui *tui, const char *path, bool sure)
{
    static const struct thud_question over = {.yes = overwrite};
    char to[512] = "", before[512];
    if (path)
        save_path(path, to, sizeof to);
    snprintf(before, sizeof before, "%s", tui->doc.path);
    bool other = path && strcmp(to, before) != 0;
    if (thud_doc_is_shipped(&tui->doc, other ? to : before)) {
        thud_tui_save_as(tui);
        thud_tui_say(tui, THUD_ROLE_WARN, "Presets that come with thud stay unchanged: a name for yours");
        return;
    }
    if (!sure && other && access(to, F_OK) == 0) {
        thud_tui_ask(tui, &over, to, "%s exists. Write over it?", to);
        return;
    }
    if (!sure && !other && thud_doc_disk_changed(&tui->doc)) {
        thud_tui_ask(tui, &over, "",
                     thud_doc_disk_gone(&tui->doc) ? "%s was deleted since it was read. Write it again?"
                                                   : "%s was changed by someone else since it was read. Write over it?",
                     before);
        return;
    }
    struct thud_error err;
    if (thud_doc_save(&tui->doc, other ? to : NULL, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        saved(tui);
}

static void open_now(struct thud_tui *tui, const char *name)
{
    struct thud_error err;
    thud_tui_forget_run(tui);
    if (thud_doc_open(&tui->doc, name, &err) != THUD_OK) {
        thud_tui_say_error(tui, &err);
        tui->run.seen = 0;
        return;
    }
    thud_tui_log(tui, "open %s", name);
    thud_tui_say(tui, THUD_ROLE_GOOD, "Opened %s: %s", tui->doc.path, tui->doc.scene.title);
    thud_tui_opened(tui);
}

void thud_tui_open(struct thud_tui *tui, const char *name, bool sure)
{
    static const struct thud_question lose = {.unsaved = true, .yes = open_now};
    if (!sure && thud_doc_unsaved(&tui->doc))
        thud_tui_ask(tui, &lose, name, "%s has unsaved changes, and %s is to be opened", tui->doc.scene.name, name);
    else
        open_now(tui, name);
}

static void new_now(struct thud_tui *tui, const char *unused)
{
    (void)unused;
    thud_new_scene_begin(tui);
}

void thud_tui_new(struct thud_tui *tui)
{
    static const struct thud_question lose = {.unsaved = true, .yes = new_now};
    if (thud_doc_unsaved(&tui->doc))
        thud_tui_ask(tui, &lose, "", "%s has unsaved changes", tui->doc.scene.name);
    else
        thud_new_scene_begin(tui);
}

static void quit_now(struct thud_tui *tui, const char *unused)
{
    (void)unused;
    tui->end.quit = true;
}

void thud_tui_quit(struct thud_tui *tui, bool sure)
{
    static const struct thud_question lose = {.unsaved = true, .yes = quit_now};
    if (!sure && thud_doc_unsaved(&tui->doc))
        thud_tui_ask(tui, &lose, "", "%s has unsaved changes", tui->doc.scene.name);
    else
        quit_now(tui, "");
}

/* The scene of the file that was kept, as a change to be saved or undone; saving removes the file. */
static void recover(struct thud_tui *tui, const char *path)
{
    struct thud_preset *preset = NULL;
    struct thud_error err = {0};
    enum thud_status status = thud_preset_read(path, &preset, &err);
    if (status == THUD_OK) {
        struct thud_scene next = *thud_preset_scene(preset);
        memcpy(next.name, tui->doc.scene.name, sizeof next.name);
        status = thud_doc_change(&tui->doc, &next, "recovered changes", &err);
    }
    thud_preset_free(preset);
    if (!thud_tui_succeeded(tui, status, &err))
        return;
    snprintf(tui->doc.kept, sizeof tui->doc.kept, "%s", path);
    thud_tui_say(tui, THUD_ROLE_GOOD, "Recovered: w saves, u undoes");
}

void thud_tui_offer_recovery(struct thud_tui *tui)
{
    static const struct thud_question take = {.yes = recover};
    char path[sizeof tui->dialog.target];
    thud_doc_recovery_path(&tui->doc, path, sizeof path);
    if (access(path, F_OK) == 0)
        thud_tui_ask(tui, &take, path, "Unsaved changes were kept in %s. Take them?", path);
}

static void list_presets(struct thud_tui *tui, const char *folder);

static void chosen_preset(struct thud_tui *tui, const char *value)
{
    if (*value && value[strlen(value) - 1] == '/')
        list_presets(tui, value);
    else
        thud_tui_open(tui, value, false);
}

/* Presets of the working folder and those that come with thud, or of a folder that was gone into. */
static void list_presets(struct thud_tui *tui, const char *folder)
{
    struct thud_browse files = {0};
    char title[96];
    snprintf(title, sizeof title, "Open a preset%s%.50s", *folder ? " of " : "", folder);
    thud_browse_list(&files, THUD_BROWSE_PRESETS, tui->doc.paths, tui->doc.path, folder);
    thud_tui_choose(tui, chosen_preset, title);
    for (int i = 0; i < files.n; i++)
        if (strlen(files.item[i].name) < sizeof tui->dialog.chooser.choice->value)
            thud_chooser_add(&tui->dialog.chooser, files.item[i].name, "%-30s %s", files.item[i].name,
                             thud_browse_about(&files, i));
    thud_browse_clear(&files);
    thud_chooser_mark(&tui->dialog.chooser, tui->doc.scene.name);
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
