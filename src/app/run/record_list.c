#include "app/run/record_list.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/grow.h"
#include "base/scan.h"
#include "io/file/file.h"
#include "io/record/record_file.h"

/* Those that scale stand first, and last those that are no options of the command line. */
static const char *const settings[] = {"peak", "sa",    "period", "factor",  "sign",      "from",
                                       "to",   "dt",    "unit",   "channel", "component", "column",
                                       "skip", "every", "event",  "station", "licence"};
enum { SCALES = 5 };
enum { SETTINGS = sizeof settings / sizeof *settings, OPTIONS = SETTINGS - 3 };
_Static_assert(sizeof settings / sizeof *settings <= THUD_RECORD_SETTINGS_MAX, "room for all of them");

const char *thud_record_setting(int i)
{
    return i < OPTIONS ? settings[i] : NULL;
}

/* The first such character that stands in no quotation marks; NULL: none. They open where the text begins and behind
 * `=`, and hold two of themselves for one. */
static char *find_unquoted(char *text, char wanted)
{
    bool quoted = false;
    for (char *c = text; *c; c++) {
        if (quoted && c[0] == '"' && c[1] == '"')
            c++;
        else if (*c == '"' && (quoted || c == text || c[-1] == '='))
            quoted = !quoted;
        else if (*c == wanted && !quoted)
            return c;
    }
    return NULL;
}

/* What quotation marks around a name or value hold, in its place. */
static void take_quotes_off(char *text)
{
    if (*text != '"')
        return;
    char *to = text;
    for (const char *c = text + 1; *c && (*c != '"' || c[1] == '"'); c++) {
        c += *c == '"';
        *to++ = *c;
    }
    *to = '\0';
}

/* A name or a value as a list has it: in quotation marks, themselves doubled, where it would be read as something
 * else. */
static void put_quoted(struct thud_text *out, const char *text)
{
    const size_t n = strlen(text);
    if (n > 0 && !strpbrk(text, "\":#") && text[0] != ' ' && text[0] != '\t' && text[n - 1] != ' ' &&
        text[n - 1] != '\t') {
        thud_text_append(out, "%s", text);
        return;
    }
    for (const char *c = text; *c; c++)
        thud_text_append(out, "%s%c%s", c == text ? "\"" : "", *c, *c == '"' ? "\"" : "");
    thud_text_append(out, "\"");
}

/* Cuts the text before its next setting `:KEY=VALUE`: gives its key and where `VALUE...` begins; NULL where there is
 * none. A path may have colons of its own. */
static const char *cut_setting(char *text, char **value)
{
    for (char *p = text; (p = find_unquoted(p, ':')) != NULL; p++)
        for (int i = 0; i < SETTINGS; i++) {
            const char *at = p + 1;
            if (!thud_scan_word(&at, settings[i]) || *at != '=')
                continue;
            *p = '\0';
            *value = p + (at - p) + 1;
            return settings[i];
        }
    return NULL;
}

static enum thud_status set(struct thud_scene *scene, const char *key, const char *value, struct thud_error *err)
{
    char path[64];
    snprintf(path, sizeof path, "record.%s", key);
    return thud_scene_set(scene, path, value, err);
}

/* A list in the making. */
struct reading {
    const struct thud_session *session;            /* NULL: each file is opened by the treatment */
    const struct thud_record_treatment *treatment; /* but for what a line chooses */
    const struct thud_record_choice *common;       /* what holds for motions that do not say otherwise; NULL: nothing */
    struct thud_record_list *list;
    bool both;
    bool look; /* whether what is named is there, without reading it */
    bool skip; /* what cannot be read is left out */
};

/* Files of a folder or list that cannot be read as they are: all are named in one message. */
struct refusals {
    int n, files;
    struct thud_error first;
    char names[sizeof(struct thud_error){0}.what - 100]; /* "a.AT2 (dt), b.txt (column)" */
    int named;
};

static void refuse(struct refusals *refusals, const char *file, const struct thud_error *why)
{
    size_t used = strlen(refusals->names);
    const char *name = thud_path_name(file);
    if (refusals->n++ == 0)
        refusals->first = *why;
    char reason[100];
    snprintf(reason, sizeof reason, why->key[0] ? "needs %s" : "%s", why->key[0] ? why->key : why->what);
    if (refusals->named + 1 < refusals->n || strlen(name) + strlen(reason) + 8 > sizeof refusals->names - used)
        return;
    refusals->named++;
    thud_append(refusals->names, sizeof refusals->names, "%s%s (%s)", used ? ", " : "", name, reason);
}

/* A single one is reported in its own words. */
static enum thud_status tell_refusals(const struct refusals *refusals, const char *place, struct thud_error *err)
{
    char more[32] = "";
    if (refusals->n == 0)
        return THUD_OK;
    if (refusals->n > refusals->named)
        snprintf(more, sizeof more, " and %d more", refusals->n - refusals->named);
    if (refusals->n == 1 && err)
        *err = refusals->first;
    else
        thud_error_set(err, THUD_INPUT, "%d of %d files cannot be read: %s%s", refusals->n, refusals->files,
                       refusals->names, more);
    if (refusals->n > 1)
        thud_error_place(err, place, 0, 0);
    if (refusals->n > 1 || (err && !err->allowed[0]))
        thud_error_allow(err, "a NAME.list names files with their settings, one per line: a.AT2:dt=0.005 s:unit=g");
    return THUD_INPUT;
}

/* Size is one choice: what a line says of it replaces what holds for the whole list, and that what the command line
 * says. */
static bool is_size(const char *key)
{
    return strcmp(key, "peak") == 0 || strcmp(key, "sa") == 0 || strcmp(key, "factor") == 0;
}

static bool same_size(const struct thud_record_choice *a, const struct thud_record_choice *b)
{
    return memcmp(&a->peak_mps2, &b->peak_mps2, sizeof(double)) == 0 &&
           memcmp(&a->sa_mps2, &b->sa_mps2, sizeof(double)) == 0 && a->factor == b->factor; /* NaN is like NaN */
}

/* The text before the character `mark` in no quotation marks, without the blanks around it; rest: what follows, or
 * NULL. */
static char *cut_part(char *text, char mark, char **rest)
{
    text += strspn(text, " \t");
    *rest = find_unquoted(text, mark);
    if (*rest)
        *(*rest)++ = '\0';
    size_t n = strlen(text);
    while (n > 0 && (text[n - 1] == ' ' || text[n - 1] == '\t'))
        n--;
    text[n] = '\0';
    return text;
}

/* Takes `NAME:KEY=VALUE...` apart, in place, over what already holds for it. own: the settings as they are written. */
static enum thud_status choose(struct thud_scene *scene, char *item, char own[THUD_TEXT_MAX], struct thud_error *err)
{
    char *value = NULL;
    const char *key = cut_setting(item, &value);
    snprintf(own, THUD_TEXT_MAX, "%.250s", key ? item + strlen(item) + 1 : "");
    take_quotes_off(item);
    if (!*item || strlen(item) >= sizeof scene->record.file)
        return thud_error_refuse(err, THUD_USAGE, "--records",
                                 "FILE,FILE,..., each with its own settings after colons: a.AT2:peak=0.9g",
                                 "a name is empty or too long");
    snprintf(scene->record.file, sizeof scene->record.file, "%s", item);
    enum thud_status status = THUD_OK;
    const char *given[SETTINGS];
    bool sized = false;
    for (int n = 0; key && status == THUD_OK; n++) {
        char *text = value;
        const char *next = cut_setting(value, &value);
        take_quotes_off(text);
        for (int i = 0; i < n; i++)
            if (given[i] == key)
                return thud_error_refuse(err, THUD_USAGE, "--records", NULL, "%s is given twice for %.200s", key, item);
        given[n] = key; /* all differ, so that there are never more than SETTINGS */
        if (is_size(key) && !sized) {
            scene->record.peak_mps2 = scene->record.sa_mps2 = NAN;
            scene->record.factor = 1;
            sized = true;
        }
        status = set(scene, key, text, err);
        key = next;
    }
    return status;
}

/* Trimmed once, and before what the treatment does: not as it is read and again at the end. */
static enum thud_status open_treated(const struct reading *r, const struct thud_record_choice *choice,
                                     struct thud_record **out, struct thud_error *err)
{
    struct thud_record_treatment own = *r->treatment;
    own.choice = *choice;
    own.choice.from_s = own.choice.to_s = NAN;
    own.from_s = isnan(choice->from_s) ? own.from_s : choice->from_s;
    own.to_s = isnan(choice->to_s) ? own.to_s : choice->to_s;
    return thud_record_open(choice->file, &own, out, err);
}

/* path: where the file was found. */
static enum thud_status read_one(const struct thud_session *session, const struct thud_scene *scene, char *path,
                                 size_t size, struct thud_record **out, struct thud_error *err)
{
    struct thud_record_choice choice = scene->record;
    enum thud_status status = thud_paths_record(&session->paths, session->preset_path, choice.file, path, size, err);
    if (status == THUD_OK)
        status = thud_motion_read(&session->scene, path, &choice, out, err);
    thud_session_place_component(session, scene->record.component, status, err);
    if (status == THUD_OK)
        snprintf((*out)->file, sizeof(*out)->file, "%s", choice.file);
    return status;
}

/* How a file is read, but for what scales it, as a line of a list has it behind the name. */
static char *reading_of(const struct thud_scene *scene)
{
    struct thud_text text = {0};
    char key[32], value[64];
    thud_text_append(&text, "%s", "");
    for (int i = SCALES; i < SETTINGS; i++) {
        snprintf(key, sizeof key, "record.%s", settings[i]);
        if (thud_scene_get(scene, key, value, sizeof value, NULL) != THUD_OK || !value[0])
            continue;
        thud_text_append(&text, ":%s=", settings[i]);
        put_quoted(&text, value);
    }
    if (text.failed)
        thud_text_clear(&text);
    return text.data;
}

/* Of the file at `path`. */
static enum thud_status add(struct reading *r, struct thud_record *record, const char *path,
                            const struct thud_scene *scene, struct thud_error *err)
{
    struct thud_record_list *list = r->list;
    struct thud_record_source source = {.path = strdup(path), .reading = reading_of(scene)};
    struct thud_record **records = thud_grow(list->record, (size_t)list->n, sizeof *records);
    struct thud_record_source *sources = thud_grow(list->source, (size_t)list->n, sizeof *sources);
    list->record = records ? records : list->record;
    list->source = sources ? sources : list->source;
    if (!source.path || !source.reading || !records || !sources) {
        free(source.path);
        free(source.reading);
        thud_record_free(record);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    list->source[list->n] = source;
    list->record[list->n++] = record;
    return THUD_OK;
}

/* The motion with reversed polarity, too. */
static enum thud_status add_turned(struct reading *r, const char *path, const struct thud_scene *scene,
                                   struct thud_error *err)
{
    const struct thud_record *record = r->list->record[r->list->n - 1];
    struct thud_record *turned;
    enum thud_status status = thud_record_scaled(record, -1, &turned, err);
    if (status != THUD_OK)
        return status;
    snprintf(turned->component, sizeof turned->component, "%.50s%sreversed", record->component,
             *record->component ? ", " : "");
    snprintf(turned->file, sizeof turned->file, "%.500s:sign=-", record->file);
    return add(r, turned, path, scene, err);
}

/* A motion of a file that is there already is told apart by how it is read, or by its settings, `own`, where that is
 * the same. */
static void name_apart(struct thud_record_list *list, const char *own)
{
    struct thud_record *last = list->record[list->n - 1];
    const struct thud_record_source *const source = &list->source[list->n - 1];
    bool there = false, same = !*source->reading;
    for (const struct thud_record_source *other = list->source; other < source; other++)
        if (strcmp(other->path, source->path) == 0) {
            there = true;
            same = same || strcmp(other->reading, source->reading) == 0;
        }
    if (there && !same)
        thud_append(last->file, sizeof last->file, "%s", source->reading);
    else if (there && *own)
        thud_append(last->file, sizeof last->file, ":%s", own);
}

static enum thud_status add_file(struct reading *r, const struct thud_scene *scene, const char *own,
                                 struct thud_error *err)
{
    struct thud_record *record = NULL;
    char path[1024];
    snprintf(path, sizeof path, "%s", scene->record.file);
    enum thud_status status = r->session ? read_one(r->session, scene, path, sizeof path, &record, err)
                                         : open_treated(r, &scene->record, &record, err);
    if (status == THUD_OK)
        status = add(r, record, path, scene, err);
    if (status != THUD_OK)
        return status;
    r->list->own_size += r->common && !same_size(r->common, &scene->record);
    name_apart(r->list, own);
    return r->both ? add_turned(r, path, scene, err) : THUD_OK;
}

static enum thud_status add_folder(struct reading *r, struct thud_scene *scene, struct thud_error *err)
{
    char **name, folder[THUD_TEXT_MAX];
    struct refusals refusals = {0};
    struct thud_error why;
    size_t count;
    snprintf(folder, sizeof folder, "%s", scene->record.file);
    enum thud_status status = thud_folder_names(folder, &name, &count, NULL, err);
    for (size_t i = 0; status == THUD_OK && i < count; i++) {
        bool slash = folder[strlen(folder) - 1] == '/';
        int n = snprintf(scene->record.file, sizeof scene->record.file, "%s%s%s", folder, slash ? "" : "/", name[i]);
        if (n >= (int)sizeof scene->record.file)
            status = thud_error_set(&why, THUD_INPUT, "the name is too long");
        else
            status = add_file(r, scene, "", &why);
        if (status == THUD_INPUT && r->skip)
            r->list->skipped++;
        else if (status == THUD_INPUT)
            refuse(&refusals, scene->record.file, &why);
        else if (status != THUD_OK && err)
            *err = why;
        status = status == THUD_INPUT ? THUD_OK : status;
    }
    refusals.files = (int)count;
    if (status == THUD_OK)
        status = tell_refusals(&refusals, folder, err);
    if (status == THUD_OK && count == 0)
        status = thud_error_in(err, THUD_INPUT, folder, 0, "holds no files");
    thud_folder_names_free(name, count);
    return status;
}

/* A line of a list; `base`: what holds for all of them, with the list's own path. */
static enum thud_status add_line(struct reading *r, const struct thud_scene *base, struct thud_scene *scene, char *line,
                                 struct thud_error *err)
{
    char own[THUD_TEXT_MAX], name[THUD_TEXT_MAX];
    const char *slash = strrchr(base->record.file, '/');
    char *comment;
    line = cut_part(line, '#', &comment);
    if (!*line)
        return THUD_OK;
    *scene = *base;
    enum thud_status status = choose(scene, line, own, err);
    if (status == THUD_OK && slash && scene->record.file[0] != '/') {
        memcpy(name, scene->record.file, sizeof name);
        if (snprintf(scene->record.file, sizeof scene->record.file, "%.*s/%s", (int)(slash - base->record.file),
                     base->record.file, name) >= (int)sizeof scene->record.file)
            status = thud_error_set(err, THUD_INPUT, "the name is too long");
    }
    return status == THUD_OK ? add_file(r, scene, own, err) : status;
}

static enum thud_status add_list(struct reading *r, const struct thud_scene *base, struct thud_error *err)
{
    enum { BYTES_MAX = 1 << 20 };
    struct thud_scene *scene = malloc(sizeof *scene);
    char *text = NULL, *rest, *line;
    int number = 0, before = r->list->n;
    enum thud_status status = scene ? thud_text_read(base->record.file, BYTES_MAX, &text, err)
                                    : thud_error_set(err, THUD_MEMORY, "out of memory");
    for (rest = text; status == THUD_OK && (line = thud_text_line(&rest)) != NULL;) {
        number++;
        status = add_line(r, base, scene, line, err);
        if (status == THUD_INPUT && r->skip) {
            r->list->skipped++;
            status = THUD_OK;
        }
        if (status == THUD_INPUT || status == THUD_USAGE) {
            if (err && !err->file[0])
                thud_error_place(err, base->record.file, number, 0);
            status = THUD_INPUT; /* what a file says */
            if (err)
                err->status = status;
        }
    }
    if (status == THUD_OK && r->list->n == before)
        status = thud_error_in(err, THUD_INPUT, base->record.file, 0, "names no files");
    free(text);
    free(scene);
    return status;
}

enum thud_status thud_record_list_named(struct thud_session *session, const char *text, bool both,
                                        struct thud_record_list *out, struct thud_error *err)
{
    return *text ? thud_record_list_read(session, text, NULL, 0, both, out, err)
                 : thud_record_list_own(session, both, out, err);
}

bool thud_record_is_list(const char *file)
{
    const char *suffix = strrchr(file, '.');
    return suffix && strcmp(suffix, ".list") == 0;
}

/* Looks for a folder or list in the working folder, then beside the preset. */
static void look_beside(const struct thud_session *session, char *file, size_t size)
{
    char beside[THUD_TEXT_MAX];
    const char *slash = strrchr(session->preset_path, '/');
    if (!slash || file[0] == '/' || access(file, F_OK) == 0 ||
        snprintf(beside, sizeof beside, "%.*s/%s", (int)(slash - session->preset_path), session->preset_path, file) >=
            (int)sizeof beside)
        return;
    if (thud_path_is_folder(beside) || (thud_record_is_list(beside) && access(beside, F_OK) == 0))
        snprintf(file, size, "%s", beside);
}

/* Takes `:unreadable=skip` off a name; true where it was there. */
static bool cut_skip(char *item)
{
    static const char word[] = ":unreadable=skip";
    char *at = strstr(item, word);
    if (!at)
        return false;
    memmove(at, at + strlen(word), strlen(at + strlen(word)) + 1);
    return true;
}

/* A file, a folder or a list. */
static enum thud_status add_item(struct reading *r, struct thud_scene *scene, const char *own, struct thud_error *err)
{
    char path[1024];
    look_beside(r->session, scene->record.file, sizeof scene->record.file);
    if (thud_path_is_folder(scene->record.file))
        return r->look ? THUD_OK : add_folder(r, scene, err);
    if (r->look) {
        const enum thud_status status =
            thud_paths_record(&r->session->paths, r->session->preset_path, scene->record.file, path, sizeof path, err);
        return status == THUD_OK ? thud_motion_look(&r->session->scene, path, &scene->record, err) : status;
    }
    return thud_record_is_list(scene->record.file) ? add_list(r, scene, err) : add_file(r, scene, own, err);
}

/* Whether `key` is one of n. */
static bool is_given(const char *(*common)[2], int n, const char *key)
{
    for (int i = 0; i < n; i++)
        if (strcmp(common[i][0], key) == 0)
            return true;
    return false;
}

/* Lists what the scene, beyond a plain one, says of its own record alone. Errors: THUD_INPUT where it has no record of
 * its own, but motions of its study. */
static enum thud_status list_unused(const struct thud_session *session, const struct thud_scene *plain,
                                    const char *(*common)[2], int n, bool is_own, char *out, size_t size,
                                    struct thud_error *err)
{
    static const char *const own[] = {"peak", "sa", "factor", "target", "from", "to", "sign"};
    const struct thud_scene *preset = session->preset ? thud_preset_scene(session->preset) : plain;
    char key[32], value[3][160];
    for (size_t i = 0; i < sizeof own / sizeof *own; i++) {
        const struct thud_scene *const of[] = {&session->scene, plain, preset};
        snprintf(key, sizeof key, "record.%s", own[i]);
        for (int k = 0; k < 3; k++)
            if (thud_scene_get(of[k], key, value[k], sizeof value[k], NULL) != THUD_OK)
                value[k][0] = '\0';
        if (strcmp(value[0], value[1]) == 0 || is_given(common, n, own[i]))
            continue;
        thud_append(out, size, "%s%s %s", *out ? ", " : "", key, value[0]);
        if (session->scene.record.file[0] || !is_own)
            continue;
        thud_error_refuse(err, THUD_INPUT, key, "record.file for it, or FILE:peak=0.3g in study.records",
                          "it applies to record.file alone, and there are only the motions of study.records");
        if (strcmp(value[0], value[2]) == 0)
            thud_preset_place(session->preset, key, err);
        return THUD_INPUT;
    }
    return THUD_OK;
}

enum thud_status thud_record_list_read(const struct thud_session *session, const char *text, const char *(*common)[2],
                                       int ncommon, bool both, struct thud_record_list *out, struct thud_error *err)
{
    struct thud_record_list looked;
    struct reading r = {.session = session, .list = out ? out : &looked, .both = both, .look = !out};
    enum thud_status status = THUD_OK;
    bool bracketed = *text == '['; /* a list of a preset */
    char *copy = strdup(text + bracketed);
    struct thud_scene *scene = malloc(2 * sizeof *scene);
    *r.list = (struct thud_record_list){0};
    if (bracketed && copy)
        copy[strcspn(copy, "]")] = '\0';
    if (!copy || !scene) {
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    } else {
        thud_scene_init(scene + 1);
        if (!r.look)
            status = list_unused(session, scene + 1, common, ncommon, strcmp(text, session->scene.study.records) == 0,
                                 out->unused, sizeof out->unused, err);
        for (int i = 0; i < ncommon && status == THUD_OK; i++)
            status = set(scene + 1, common[i][0], common[i][1], err);
        r.common = &scene[1].record;
    }
    for (char *item = copy, *end; status == THUD_OK && item; item = end) {
        char own[THUD_TEXT_MAX];
        item = cut_part(item, ',', &end);
        r.skip = cut_skip(item);
        *scene = scene[1];
        status = choose(scene, item, own, err);
        if (status == THUD_OK)
            status = add_item(&r, scene, own, err);
    }
    if (status == THUD_OK && r.list->skipped > 0 && r.list->n == 0)
        status = thud_error_set(err, THUD_INPUT, "none of the %d files can be read", r.list->skipped);
    free(scene);
    free(copy);
    if (status != THUD_OK)
        thud_record_list_clear(r.list);
    if (status != THUD_OK && err && (r.look || strcmp(err->key, "record.file") == 0))
        thud_error_key(err, "study.records");
    return status == THUD_USAGE && r.look ? THUD_INPUT : status; /* a value, and no option */
}

enum thud_status thud_record_list_own(struct thud_session *session, bool both, struct thud_record_list *out,
                                      struct thud_error *err)
{
    struct reading r = {.session = session, .list = out, .both = both};
    *out = (struct thud_record_list){0};
    for (int s = 0; s < session->scene.nstructures && !session->scene.record.file[0]; s++)
        if (session->scene.structure[s].kind == THUD_RIGID) /* its velocity may be what a study varies */
            return THUD_OK;
    if (!session->scene.record.file[0])
        return thud_scene_check_motion(&session->scene, NULL, err);
    enum thud_status status = add_file(&r, &session->scene, "", err);
    if (status != THUD_OK)
        thud_record_list_clear(out);
    return status;
}

enum thud_status thud_record_list_open(const char *name, const struct thud_record_treatment *treatment,
                                       struct thud_record_list *out, struct thud_error *err)
{
    struct reading r = {.treatment = treatment, .list = out};
    struct thud_record *record;
    struct thud_scene *scene;
    enum thud_status status;
    *out = (struct thud_record_list){0};
    if (!(scene = malloc(sizeof *scene)))
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    thud_scene_init(scene);
    scene->record = treatment->choice;
    if (!thud_record_is_list(name)) {
        status = thud_record_open(name, treatment, &record, err);
        status = status == THUD_OK ? add(&r, record, name, scene, err) : status;
    } else if (snprintf(scene->record.file, sizeof scene->record.file, "%s", name) < (int)sizeof scene->record.file)
        status = add_list(&r, scene, err);
    else
        status = thud_error_set(err, THUD_INPUT, "the name of the list is too long");
    free(scene);
    if (status != THUD_OK)
        thud_record_list_clear(out);
    return status;
}

void thud_record_list_clear(struct thud_record_list *list)
{
    for (int i = 0; i < list->n; i++) {
        thud_record_free(list->record[i]);
        free(list->source[i].path);
        free(list->source[i].reading);
    }
    free(list->source);
    free(list->record);
    *list = (struct thud_record_list){0};
}

void thud_record_list_line(const struct thud_record_list *list, int i, const char *name, double factor,
                           struct thud_text *out)
{
    put_quoted(out, name);
    thud_text_append(out, "%s:factor=", list->source[i].reading);
    thud_text_number(out, fabs(factor));
    thud_text_append(out, factor < 0 ? ":sign=-\n" : "\n");
}
