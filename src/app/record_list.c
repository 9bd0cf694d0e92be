#include "app/record_list.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/scan.h"
#include "io/record_file.h"

static const char *const settings[] = {"peak", "factor", "sign",    "from",   "to",
                                       "dt",   "unit",   "channel", "column", "skip"};
enum { SETTINGS = sizeof settings / sizeof *settings };
_Static_assert(sizeof settings / sizeof *settings <= THUD_RECORD_SETTINGS_MAX, "room for all of them");

const char *thud_record_setting(int i)
{
    return i < SETTINGS ? settings[i] : NULL;
}

/* Cuts the text before its next setting `:KEY=VALUE`: gives its key and where `VALUE...` begins; NULL where there is
 * none. A path may have colons of its own. */
static const char *cut_setting(char *text, char **value)
{
    for (char *p = text; (p = strchr(p, ':')) != NULL; p++)
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

/* Takes `FILE:KEY=VALUE...` apart, in place. */
static enum thud_status choose(struct thud_scene *scene, char *item, const char *(*common)[2], int ncommon,
                               struct thud_error *err)
{
    char *value = NULL;
    const char *key = cut_setting(item, &value);
    thud_scene_init(scene);
    if (!*item || strlen(item) >= sizeof scene->record.file) {
        thud_error_set(err, THUD_USAGE, "a name is empty or too long");
        thud_error_key(err, "--records");
        thud_error_allow(err, "FILE,FILE,..., each with its own settings after colons: a.AT2:peak=0.9g");
        return THUD_USAGE;
    }
    snprintf(scene->record.file, sizeof scene->record.file, "%s", item);
    enum thud_status status = THUD_OK;
    for (int i = 0; i < ncommon && status == THUD_OK; i++)
        status = set(scene, common[i][0], common[i][1], err);
    while (key && status == THUD_OK) {
        const char *own = value, *next = cut_setting(value, &value);
        status = set(scene, key, own, err);
        key = next;
    }
    return status;
}

static enum thud_status read_one(const struct thud_session *session, struct thud_scene *scene, struct thud_record **out,
                                 struct thud_error *err)
{
    char path[1024];
    enum thud_status status =
        thud_paths_record(&session->paths, session->preset_path, scene->record.file, path, sizeof path, err);
    if (status == THUD_OK)
        status = thud_record_file_read(path, &scene->record, out, err);
    if (status == THUD_OK)
        snprintf((*out)->file, sizeof(*out)->file, "%s", scene->record.file);
    return status;
}

static int count_items(const char *text)
{
    int n = 1;
    for (; *text; text++)
        n += *text == ',';
    return n;
}

enum thud_status thud_record_list_read(const struct thud_session *session, const char *text, const char *(*common)[2],
                                       int ncommon, struct thud_record_list *out, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    char *copy = strdup(text);
    struct thud_scene *scene = malloc(sizeof *scene);
    *out = (struct thud_record_list){0};
    out->record = calloc((size_t)count_items(text), sizeof *out->record);
    if (!copy || !scene || !out->record)
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    for (char *item = copy, *end; status == THUD_OK && item; item = end) {
        end = strchr(item, ',');
        if (end)
            *end++ = '\0';
        status = choose(scene, item, common, ncommon, err);
        if (status == THUD_OK)
            status = read_one(session, scene, &out->record[out->n], err);
        out->n += status == THUD_OK;
    }
    free(scene);
    free(copy);
    if (status != THUD_OK)
        thud_record_list_clear(out);
    return status;
}

enum thud_status thud_record_list_own(struct thud_session *session, struct thud_record_list *out,
                                      struct thud_error *err)
{
    *out = (struct thud_record_list){0};
    if (!session->scene.record.file[0])
        return THUD_OK;
    struct thud_scene *scene = malloc(sizeof *scene);
    out->record = calloc(1, sizeof *out->record);
    enum thud_status status = THUD_MEMORY;
    if (scene && out->record) {
        *scene = session->scene;
        status = read_one(session, scene, out->record, err);
    } else {
        thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    free(scene);
    if (status == THUD_OK)
        out->n = 1;
    else
        thud_record_list_clear(out);
    return status;
}

void thud_record_list_clear(struct thud_record_list *list)
{
    for (int i = 0; list->record && i < list->n; i++)
        thud_record_free(list->record[i]);
    free(list->record);
    *list = (struct thud_record_list){0};
}
