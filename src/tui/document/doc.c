#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/run/session.h"
#include "base/scan.h"
#include "io/building/building_file.h"
#include "io/file/file.h"
#include "io/record/record_file.h"
#include "study/scene/solution.h"
#include "study/suite/fragility.h"
#include "tui/document/motions.h"
#include "tui/widgets/form.h"

static struct thud_stamp stamp_of(const char *path)
{
    struct stat info;
    if (stat(path, &info) != 0)
        return (struct thud_stamp){0};
    return (struct thud_stamp){info.st_mtim.tv_sec, info.st_mtim.tv_nsec, info.st_size, (long long)info.st_ino};
}

static bool same_stamp(struct thud_stamp a, struct thud_stamp b)
{
    return a.seconds == b.seconds && a.nanoseconds == b.nanoseconds && a.size == b.size && a.number == b.number;
}

static void forget_record(struct thud_doc *doc)
{
    thud_record_free(doc->record);
    thud_record_free(doc->whole);
    doc->record = doc->whole = NULL;
    doc->record_tried = false;
}

/* The preset as read becomes the base: what saving starts from. */
static void base_on(struct thud_doc *doc, struct thud_preset *preset, const char *path)
{
    thud_preset_free(doc->preset);
    doc->preset = preset;
    snprintf(doc->path, sizeof doc->path, "%s", path);
    doc->stamp = stamp_of(path);
    doc->saved = *thud_preset_scene(preset);
    thud_doc_forget_kept(doc);
}

static void begin(struct thud_doc *doc, struct thud_preset *preset, const char *path)
{
    base_on(doc, preset, path);
    doc->scene = doc->saved;
    thud_undo_clear(&doc->undo);
    forget_record(doc);
    doc->revision++;
    doc->edits++;
}

enum thud_status thud_doc_open(struct thud_doc *doc, const char *name, struct thud_error *err)
{
    char path[512];
    struct thud_preset *preset;
    enum thud_status status = thud_paths_preset(doc->paths, name, path, sizeof path, err);
    if (status == THUD_OK)
        status = thud_preset_read(path, &preset, err);
    if (status != THUD_OK)
        return status;
    begin(doc, preset, path);
    return THUD_OK;
}

enum thud_status thud_doc_new(struct thud_doc *doc, const char *text, size_t size, const char *path,
                              struct thud_error *err)
{
    struct thud_preset *preset;
    enum thud_status status = thud_preset_parse(text, size, path, &preset, err);
    if (status == THUD_OK)
        status = thud_scene_check(thud_preset_scene(preset), err);
    if (status != THUD_OK) {
        thud_preset_free(preset);
        return status;
    }
    begin(doc, preset, path);
    memset(&doc->saved, 0, sizeof doc->saved); /* no file has it */
    return THUD_OK;
}

void thud_doc_free(struct thud_doc *doc)
{
    forget_record(doc);
    thud_undo_clear(&doc->undo);
    thud_preset_free(doc->preset);
    doc->preset = NULL;
}

bool thud_doc_unsaved(const struct thud_doc *doc)
{
    return memcmp(&doc->scene, &doc->saved, sizeof doc->scene) != 0;
}

bool thud_doc_is_shipped(const struct thud_doc *doc, const char *path)
{
    char folder[512];
    const char *slash = strrchr(path, '/');
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - path) + (slash == path) : 1, slash ? path : ".");
    return thud_file_is_same(folder, doc->paths->presets);
}

bool thud_doc_disk_changed(const struct thud_doc *doc)
{
    return !same_stamp(doc->stamp, stamp_of(doc->path));
}

bool thud_doc_disk_gone(const struct thud_doc *doc)
{
    return doc->stamp.number != 0 && stamp_of(doc->path).number == 0;
}

enum thud_status thud_doc_save(struct thud_doc *doc, const char *path, struct thud_error *err)
{
    char to[512];
    snprintf(to, sizeof to, "%s", path ? path : doc->path);
    thud_building_files_move(&doc->scene, doc->path, to);
    enum thud_status status = thud_preset_save(doc->preset, &doc->scene, to, err);
    if (status != THUD_OK)
        return status;
    struct thud_preset *preset;
    status = thud_preset_read(to, &preset, err);
    if (status != THUD_OK)
        return status;
    base_on(doc, preset, to);
    snprintf(doc->scene.name, sizeof doc->scene.name, "%s", doc->saved.name);
    return THUD_OK;
}

void thud_doc_recovery_path(const struct thud_doc *doc, char *path, size_t size)
{
    if (thud_doc_is_shipped(doc, doc->path))
        snprintf(path, size, "%.200s.yaml.recovered", doc->scene.name); /* in the working folder */
    else
        snprintf(path, size, "%.490s.recovered", doc->path);
}

enum thud_status thud_doc_recover(struct thud_doc *doc, struct thud_error *err)
{
    char path[sizeof doc->kept];
    thud_doc_recovery_path(doc, path, sizeof path);
    enum thud_status status = THUD_OUTPUT;
    if (strcmp(path, doc->kept) == 0 || access(path, F_OK) != 0)
        status = thud_preset_save(doc->preset, &doc->scene, path, err);
    if (status == THUD_OUTPUT) {
        const char *folder = getenv("TMPDIR");
        snprintf(path, sizeof path, "%.300s/%.100s-%ld.recovered", folder && *folder ? folder : "/tmp", doc->scene.name,
                 (long)getpid());
        status = thud_preset_save(doc->preset, &doc->scene, path, err);
    }
    if (status == THUD_OK)
        snprintf(doc->kept, sizeof doc->kept, "%s", path);
    return status;
}

void thud_doc_forget_kept(struct thud_doc *doc)
{
    if (*doc->kept)
        remove(doc->kept);
    doc->kept[0] = '\0';
}

bool thud_doc_runs_alike(const struct thud_scene *a, const struct thud_scene *b)
{
    size_t from = offsetof(struct thud_scene, record), to = offsetof(struct thud_scene, study);
    return a->p_delta == b->p_delta && memcmp((const char *)a + from, (const char *)b + from, to - from) == 0 &&
           a->nlinks == b->nlinks && memcmp(a->link, b->link, sizeof a->link) == 0;
}

enum thud_status thud_doc_change(struct thud_doc *doc, const struct thud_scene *next, const char *what,
                                 struct thud_error *err)
{
    enum thud_status status = thud_scene_check(next, err);
    if (status == THUD_OK)
        status = thud_words_check(next, err);
    char path[512];
    if (status == THUD_OK && strcmp(next->record.component, doc->scene.record.component) != 0 &&
        thud_paths_record(doc->paths, doc->path, next->record.file, path, sizeof path, NULL) == THUD_OK)
        status = thud_motion_look(next, path, &next->record, err);
    if (status == THUD_OK && *next->study.records && strcmp(next->study.records, doc->scene.study.records) != 0)
        status = thud_doc_motions(doc, next->study.records, false, NULL, err);
    if (status == THUD_OK)
        status = thud_undo_note(&doc->undo, &doc->scene, next, what, err);
    if (status != THUD_OK)
        return status;
    doc->revision += !thud_doc_runs_alike(&doc->scene, next);
    doc->scene = *next;
    doc->edits++;
    return THUD_OK;
}

/* A body or a wall that becomes a building is the one it was before, if it was one in this session. */
static void bring_back_building(const struct thud_doc *doc, struct thud_scene *next, const char *key, const char *text)
{
    const bool building = strcmp(text, thud_kind_name(THUD_RIGID)) != 0 && strcmp(text, thud_kind_name(THUD_WALL)) != 0;
    int s = 0;
    const char *at = key;
    struct thud_undo undo = doc->undo; /* to look back in, not to step back */
    if (!thud_scan_word(&at, "structures.") || !thud_scan_count(&at, &s) || strcmp(at, ".kind") != 0 || s < 1 ||
        s > next->nstructures || !building || thud_kind_is_building(next->structure[s - 1].kind))
        return;
    struct thud_scene past = *next;
    while (!thud_kind_is_building(past.structure[s - 1].kind) && thud_undo_back(&undo, &past))
        ;
    if (s <= past.nstructures && thud_kind_is_building(past.structure[s - 1].kind) &&
        strcmp(past.structure[s - 1].name, next->structure[s - 1].name) == 0)
        next->structure[s - 1] = past.structure[s - 1];
}

/* A kind that is read from a file may have its name behind it: "matrix k.csv". */
static enum thud_status set_value(struct thud_scene *next, const char *key, const char *text, struct thud_error *err)
{
    char structure[THUD_PATH_MAX], kind[16];
    thud_usual_set(next, key, text);
    const char *end = strrchr(key, '.'), *file = strchr(text, ' ');
    if (!file || !end || strcmp(end, ".kind") != 0 || (size_t)(file - text) >= sizeof kind)
        return thud_scene_set(next, key, text, err);
    snprintf(kind, sizeof kind, "%.*s", (int)(file - text), text);
    enum thud_status status = thud_scene_set(next, key, kind, err);
    snprintf(structure, sizeof structure, "%.*s.%s", (int)(end - key), key,
             strcmp(kind, "modes") == 0 ? "periods" : "stiffness-matrix");
    return status == THUD_OK ? thud_scene_set(next, structure, file + strspn(file, " "), err) : status;
}

enum thud_status thud_doc_set(struct thud_doc *doc, const char *key, const char *text, struct thud_error *err)
{
    struct thud_scene next = doc->scene;
    char before[96] = "", after[96] = "", what[300], said[2][96];
    thud_scene_get_short(&doc->scene, key, NULL, before, sizeof before, NULL);
    bring_back_building(doc, &next, key, text);
    enum thud_status status = set_value(&next, key, text, err);
    if (status == THUD_OK)
        status = thud_building_files_read(&next, doc->path, err);
    if (status != THUD_OK)
        return status;
    thud_scene_get_short(&next, key, NULL, after, sizeof after, NULL);
    const char *only = "interfaces.1.";
    bool bare = doc->scene.nstructures == 2 && strncmp(key, only, strlen(only)) == 0;
    snprintf(what, sizeof what, "%.100s %.60s -> %.60s", bare ? key + strlen(only) : key,
             thud_quantity_said(before, said[0]), thud_quantity_said(after, said[1]));
    return thud_doc_change(doc, &next, what, err);
}

static const char *step(struct thud_doc *doc, const char *go(struct thud_undo *undo, struct thud_scene *scene))
{
    struct thud_scene before = doc->scene;
    const char *what = go(&doc->undo, &doc->scene);
    doc->revision += !thud_doc_runs_alike(&before, &doc->scene);
    doc->edits++;
    return what;
}

const char *thud_doc_undo(struct thud_doc *doc)
{
    return step(doc, thud_undo_back);
}

const char *thud_doc_redo(struct thud_doc *doc)
{
    return step(doc, thud_undo_forward);
}

/* Whether the part that is used holds a time of the file. NaN bounds hold everything. */
static bool uses(const struct thud_doc *doc, double time_s)
{
    const struct thud_record_choice *choice = &doc->record_choice;
    const double rounding_s = 1e-6 * (doc->record ? doc->record->dt_s : 0.0);
    return !(time_s < choice->from_s - rounding_s) && !(time_s > choice->to_s + rounding_s);
}

/* The whole motion behind the part that is used, for showing; without it only the part is shown. */
static void read_whole(struct thud_doc *doc, const char *path)
{
    struct thud_record_choice choice = doc->record_choice;
    const struct thud_record *part = doc->record;
    struct thud_error err; /* what reading the part did not say is no error of the preset's */
    if (!part || (isnan(choice.from_s) && isnan(choice.to_s)))
        return;
    choice.from_s = choice.to_s = choice.peak_mps2 = choice.sa_mps2 = NAN;
    if (thud_record_file_read(path, &choice, &doc->whole, &err) != THUD_OK)
        return;
    double most = 0.0;
    for (size_t i = 0; i < doc->whole->samples; i++)
        if (uses(doc, (double)i * doc->whole->dt_s))
            most = fmax(most, fabs(doc->whole->a_mps2[i]));
    if (most > 0.0)
        thud_record_scale(doc->whole, thud_record_peak(part) / most);
}

/* The ground motion of a scene, from the file at `path`; NULL with THUD_OK: it names none. */
static enum thud_status read_motion(const struct thud_doc *doc, const struct thud_scene *scene, char *path, size_t size,
                                    struct thud_record **out, struct thud_error *err)
{
    struct thud_record_choice resolved = scene->record;
    *out = NULL;
    if (!*scene->record.file)
        return THUD_OK;
    enum thud_status status = thud_paths_record(doc->paths, doc->path, scene->record.file, path, size, err);
    return status == THUD_OK ? thud_motion_read(scene, path, &resolved, out, err) : status;
}

enum thud_status thud_doc_read_record(const struct thud_doc *doc, const struct thud_scene *scene,
                                      struct thud_record **out, struct thud_error *err)
{
    char path[512] = "";
    return read_motion(doc, scene, path, sizeof path, out, err);
}

enum thud_status thud_doc_record(struct thud_doc *doc, const struct thud_record **out, struct thud_error *err)
{
    const struct thud_record_choice *choice = &doc->scene.record;
    *out = NULL;
    if (!doc->record_tried || memcmp(choice, &doc->record_choice, sizeof *choice) != 0) {
        forget_record(doc);
        doc->record_choice = *choice;
        doc->record_tried = true;
        doc->record_error = (struct thud_error){0};
        char path[512] = "";
        read_motion(doc, &doc->scene, path, sizeof path, &doc->record, &doc->record_error);
        read_whole(doc, path);
    }
    if (doc->record_error.status != THUD_OK) {
        *err = doc->record_error;
        return doc->record_error.status;
    }
    *out = doc->record;
    return THUD_OK;
}
