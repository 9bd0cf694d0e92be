#include "tui/document/browse.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/ascii.h"
#include "base/grow.h"
#include "base/quantity.h"
#include "base/text.h"
#include "io/preset/preset.h"
#include "io/record/record_file.h"

enum { FILES_MAX = 2000, BYTES_MAX = 8 << 20 };

void thud_browse_clear(struct thud_browse *browse)
{
    free(browse->item);
    *browse = (struct thud_browse){0};
}

/* Whether a file's name may be one of a ground motion or a preset: what thud and others write beside them is not. */
static bool fits(enum thud_browse_kind kind, const char *name)
{
    static const char *const others[] = {".md",        ".list", ".yaml", ".yml", ".png", ".gp", ".json",
                                         ".svg",       ".pdf",  ".c",    ".h",   ".o",   ".sh", ".html",
                                         ".recovered", ".thud", ".1",    ".5",   ".7"};
    const char *suffix = strrchr(name, '.');
    if (kind == THUD_BROWSE_PRESETS)
        return suffix && strcmp(suffix, ".yaml") == 0;
    for (size_t i = 0; suffix && i < sizeof others / sizeof *others; i++)
        if (strcmp(suffix, others[i]) == 0)
            return false;
    return suffix != NULL;
}

static bool has(const struct thud_browse *browse, const char *name)
{
    for (int i = 0; i < browse->n; i++)
        if (strcmp(browse->item[i].name, name) == 0)
            return true;
    return false;
}

static struct thud_browse_item *add(struct thud_browse *browse, const char *name)
{
    if (browse->n == FILES_MAX || has(browse, name))
        return NULL;
    struct thud_browse_item *larger = thud_grow(browse->item, (size_t)browse->n, sizeof *larger);
    if (!larger)
        return NULL;
    browse->item = larger;
    struct thud_browse_item *item = &larger[browse->n++];
    *item = (struct thud_browse_item){0};
    snprintf(item->name, sizeof item->name, "%s", name);
    return item;
}

/* Numbers of a figure have the script that draws it beside them, those of a preset (NAME.what.csv) the preset. */
static bool is_of_another(const char *path)
{
    char script[1100], preset[1100];
    const char *suffix = strrchr(path, '.'), *slash = strrchr(path, '/'), *stem = strchr(slash ? slash + 1 : path, '.');
    snprintf(script, sizeof script, "%.*s.gp", suffix ? (int)(suffix - path) : 0, path);
    snprintf(preset, sizeof preset, "%.*s.yaml", stem ? (int)(stem - path) : 0, path);
    return access(script, F_OK) == 0 || (stem != suffix && access(preset, F_OK) == 0);
}

/* What is in `folder`, asked for with `before` in front. A shipped preset goes by its name without `.yaml`. */
static void add_folder(struct thud_browse *browse, const char *folder, const char *before, bool shipped)
{
    DIR *dir = opendir(folder);
    for (struct dirent *entry; dir && (entry = readdir(dir)) != NULL;) {
        char path[1024], name[256];
        struct stat info;
        bool preset = browse->kind == THUD_BROWSE_PRESETS;
        if (*entry->d_name == '.' || snprintf(path, sizeof path, "%s/%s", folder, entry->d_name) >= (int)sizeof path ||
            stat(path, &info) != 0)
            continue;
        bool is_folder = S_ISDIR(info.st_mode);
        if ((is_folder && shipped) || (!is_folder && (!S_ISREG(info.st_mode) || !fits(browse->kind, entry->d_name))) ||
            snprintf(name, sizeof name, "%s%s%s", before, entry->d_name, is_folder ? "/" : "") >= (int)sizeof name)
            continue;
        if (shipped && preset)
            name[strlen(name) - 5] = '\0';
        struct thud_browse_item *item = !preset && !is_folder && is_of_another(path) ? NULL : add(browse, name);
        if (!item)
            continue;
        memcpy(item->path, path, sizeof path);
        item->folder = is_folder;
    }
    if (dir)
        closedir(dir);
}

static int by_name(const void *a, const void *b)
{
    const struct thud_browse_item *x = a, *y = b;
    return x->folder != y->folder ? x->folder - y->folder : strcmp(x->name, y->name);
}

void thud_browse_list(struct thud_browse *browse, enum thud_browse_kind kind, const struct thud_paths *paths,
                      const char *preset_path, const char *folder)
{
    browse->n = 0;
    browse->kind = kind;
    if (*folder) {
        char up[256];
        snprintf(up, sizeof up, "%.250s../", folder);
        struct thud_browse_item *item = add(browse, up);
        if (item)
            item->folder = true;
        add_folder(browse, folder, folder, false);
    } else {
        const char *slash = strrchr(preset_path, '/');
        char own[512];
        struct thud_browse_item *item = add(browse, "../");
        if (item)
            item->folder = true;
        snprintf(own, sizeof own, "%.*s", slash ? (int)(slash - preset_path) : 0, preset_path);
        add_folder(browse, ".", "", false);
        if (kind == THUD_BROWSE_RECORDS) /* where own ones are kept, and as the preset finds them */
            add_folder(browse, "records", "records/", true);
        if (*own && kind == THUD_BROWSE_RECORDS)
            add_folder(browse, own, "", true);
        add_folder(browse, kind == THUD_BROWSE_RECORDS ? paths->records : paths->presets, "", true);
    }
    if (browse->n > 1)
        qsort(browse->item, (size_t)browse->n, sizeof *browse->item, by_name);
}

static void say_record(struct thud_browse_item *item)
{
    struct thud_record_choice choice;
    struct thud_record *record;
    struct thud_error err = {0};
    thud_record_choice_init(&choice);
    if (thud_record_file_read(item->path, &choice, &record, &err) == THUD_OK) {
        snprintf(item->about, sizeof item->about, "%.3fg %.3gs %.0fs", thud_record_peak(record) / THUD_GRAVITY,
                 record->dt_s, record->dt_s * (double)(record->samples - 1));
        thud_record_free(record);
    } else if (strcmp(err.key, "channel") == 0 || strcmp(err.key, "unit") == 0 || strcmp(err.key, "dt") == 0 ||
               strcmp(err.key, "column") == 0) {
        snprintf(item->about, sizeof item->about, "asks for its %.20s", err.key);
    }
}

static void say_preset(struct thud_browse_item *item)
{
    struct thud_preset *preset;
    if (thud_preset_read(item->path, &preset, NULL) != THUD_OK)
        return;
    const struct thud_scene *scene = thud_preset_scene(preset);
    for (int i = 0; i < scene->nstructures; i++) {
        const struct thud_structure *s = &scene->structure[i];
        if (thud_kind_is_building(s->kind))
            thud_append(item->about, sizeof item->about, "%s%d", i ? "+" : "", s->storeys);
        else
            thud_append(item->about, sizeof item->about, "%s%s", i ? "+" : "", s->kind == THUD_WALL ? "wall" : "body");
    }
    if (scene->nstructures > 1)
        thud_append(item->about, sizeof item->about, "  %.4g cm  %.36s", 100 * scene->interface[0].gap_m,
                    thud_path_name(scene->record.file));
    thud_preset_free(preset);
}

const char *thud_browse_about(struct thud_browse *browse, int index)
{
    struct thud_browse_item *item = &browse->item[index];
    struct stat info;
    if (item->read || item->folder)
        return item->about;
    item->read = true;
    if (stat(item->path, &info) != 0 || info.st_size > BYTES_MAX)
        snprintf(item->about, sizeof item->about, "large");
    else if (browse->kind == THUD_BROWSE_RECORDS)
        say_record(item);
    else
        say_preset(item);
    return item->about;
}
