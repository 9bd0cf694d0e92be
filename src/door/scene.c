/* A scene of the library: opened, changed, read. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/new_preset.h"
#include "app/run/threads.h"
#include "base/version.h"
#include "door/door.h"
#include "study/sweep/remark.h"

/* Stands for the file of a ground motion that came as an array. */
static const char array[] = "array";
enum { VALUE = 64 * 1024 }; /* bytes of the longest value, a list of 200 numbers with all their digits and units */

const char *thud_version(void)
{
    return THUD_VERSION;
}

/* Opens a preset, or reads the text of one. */
static enum thud_status make(const char *text, size_t size, const char *name, struct thud **out, struct thud_error *err)
{
    struct thud *scene = calloc(1, sizeof *scene);
    *out = NULL;
    if (!scene)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    locale_t before = thud_threads_numbers();
    enum thud_status status = text ? thud_session_parse(&scene->session, text, size, name, err)
                                   : thud_session_open(&scene->session, name, err);
    thud_threads_numbers_back(before);
    if (status == THUD_OK)
        *out = scene;
    else
        thud_close(scene);
    return status;
}

enum thud_status thud_parse(const char *text, size_t size, const char *name, struct thud **out, struct thud_error *err)
{
    const enum thud_status status = THUD_NEED(err, text, name, out);
    return status == THUD_OK ? make(text, size, name, out, err) : status;
}

enum thud_status thud_open(const char *preset, struct thud **out, struct thud_error *err)
{
    struct thud_new_preset usual;
    struct thud_text text = {0};
    enum thud_status status = THUD_NEED(err, out);
    if (preset && status == THUD_OK)
        return make(NULL, 0, preset, out, err);
    if (status != THUD_OK)
        return status;
    *out = NULL;
    thud_new_preset_init(&usual);
    status = thud_new_preset_text(&usual, &text, err);
    if (status == THUD_OK)
        status = make(text.data, text.size, "buildings.yaml", out, err);
    thud_text_clear(&text);
    return status;
}

void thud_close(struct thud *scene)
{
    if (!scene)
        return;
    thud_session_close(&scene->session);
    for (size_t i = 0; i < sizeof scene->law / sizeof *scene->law; i++)
        free(scene->law[i]);
    free(scene->yaml);
    free(scene);
}

/* The preset as it was read, whose comments thud_yaml keeps, from its own bytes; the values of now; and what stands
 * beside them. */
static enum thud_status copy(const struct thud *from, struct thud *to, struct thud_error *err)
{
    const struct thud_session *session = &from->session;
    char *text = NULL;
    unsigned long size;
    enum thud_status status = thud_preset_text(session->preset, thud_preset_scene(session->preset), &text, &size, err);
    if (status == THUD_OK)
        status = thud_session_parse(&to->session, text, size, session->preset_path, err);
    free(text);
    if (status == THUD_OK && session->given)
        status = thud_record_scaled(session->given, 1, &to->session.given, err);
    if (status != THUD_OK)
        return status;
    to->session.scene = session->scene;
    for (int i = 0; i < THUD_STRUCTURES_MAX - 1; i++) {
        struct thud_law_choice *contact = &to->session.scene.interface[i].contact;
        if (!from->law[i])
            continue;
        to->law[i] = malloc(sizeof *to->law[i]);
        if (!to->law[i])
            return thud_error_set(err, THUD_MEMORY, "out of memory");
        *to->law[i] = *from->law[i];
        to->law[i]->table.name = to->law[i]->table.title = to->law[i]->name;
        if (contact->law == &from->law[i]->table)
            contact->law = &to->law[i]->table;
    }
    return THUD_OK;
}

enum thud_status thud_copy(const struct thud *scene, struct thud **out, struct thud_error *err)
{
    enum thud_status status = THUD_NEED(err, scene, out);
    if (status != THUD_OK)
        return status;
    locale_t before = thud_threads_numbers();
    *out = calloc(1, sizeof **out);
    status = *out ? copy(scene, *out, err) : thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status != THUD_OK) {
        thud_close(*out);
        *out = NULL;
    }
    thud_threads_numbers_back(before);
    return status;
}

enum thud_status thud_set(struct thud *scene, const char *key, const char *text, struct thud_error *err)
{
    enum thud_status status = THUD_NEED(err, scene, key, text);
    if (status != THUD_OK)
        return status;
    if (strcmp(key, "record.file") == 0 && strcmp(text, scene->session.scene.record.file) != 0)
        thud_session_choose_record(&scene->session, text);
    locale_t before = thud_threads_numbers();
    status = thud_session_set(&scene->session, key, text, err);
    thud_threads_numbers_back(before);
    return status;
}

/* Its text, to be freed; NULL with the error. */
static char *value_of(const struct thud *scene, const char *key, enum thud_status *status, struct thud_error *err)
{
    char *text = malloc(VALUE);
    locale_t before = thud_threads_numbers();
    *status = text ? thud_scene_get(&scene->session.scene, key, text, VALUE, err)
                   : thud_error_set(err, THUD_MEMORY, "out of memory");
    thud_threads_numbers_back(before);
    if (*status == THUD_OK)
        return text;
    free(text);
    return NULL;
}

enum thud_status thud_get_length(const struct thud *scene, const char *key, size_t *length, struct thud_error *err)
{
    enum thud_status status = THUD_NEED(err, scene, key, length);
    char *text = status == THUD_OK ? value_of(scene, key, &status, err) : NULL;
    if (text)
        *length = strlen(text);
    free(text);
    return status;
}

enum thud_status thud_get(const struct thud *scene, const char *key, char *text, size_t size, struct thud_error *err)
{
    enum thud_status status = THUD_NEED(err, scene, key, text);
    char *value = status == THUD_OK ? value_of(scene, key, &status, err) : NULL;
    const size_t length = value ? strlen(value) : 0;
    if (value && length >= size)
        status = thud_error_refuse(err, THUD_USAGE, key, "one byte more than that",
                                   "its text has %zu bytes, %zu are given", length, size);
    else if (value)
        memcpy(text, value, length + 1);
    free(value);
    return status;
}

/* The one number behind a key. Errors: THUD_INPUT. */
static enum thud_status find_number(const struct thud *scene, const char *key, const struct thud_param **out,
                                    struct thud_error *err)
{
    int floor;
    char text[2];
    enum thud_status status = thud_scene_get(&scene->session.scene, key, text, sizeof text, err);
    *out = status == THUD_OK ? thud_scene_param(&scene->session.scene, key, &floor) : NULL;
    if (status != THUD_OK || (*out && ((*out)->kind == THUD_PARAM_QUANTITY || (*out)->kind == THUD_PARAM_INTEGER)))
        return status;
    return thud_error_refuse(err, THUD_INPUT, key, NULL, "its value is a word, not a number");
}

static enum thud_status set_number(struct thud *scene, const char *key, double value, struct thud_error *err)
{
    const struct thud_param *param;
    char text[128] = "", shown[128], unit[64] = "";
    enum thud_status status = find_number(scene, key, &param, err);
    if (status != THUD_OK)
        return status;
    if (param->unit && strchr(param->unit, '^') && /* the exponent is the law's */
        thud_scene_get(&scene->session.scene, key, shown, sizeof shown, NULL) == THUD_OK && strchr(shown, ' '))
        snprintf(unit, sizeof unit, "%.60s", strchr(shown, ' ') + 1);
    else if (param->kind == THUD_PARAM_QUANTITY && param->unit)
        snprintf(unit, sizeof unit, "%.60s", param->unit);
    if (isinf(value))
        snprintf(text, sizeof text, "%g", value); /* which no key takes: its message says what is allowed */
    else if (!isnan(value))
        thud_quantity_format(value, unit, text, sizeof text);
    return thud_scene_set(&scene->session.scene, key, text, err);
}

enum thud_status thud_set_number(struct thud *scene, const char *key, double value, struct thud_error *err)
{
    enum thud_status status = THUD_NEED(err, scene, key);
    if (status != THUD_OK)
        return status;
    locale_t before = thud_threads_numbers();
    status = set_number(scene, key, value, err);
    thud_threads_numbers_back(before);
    return status;
}

static enum thud_status get_number(const struct thud *scene, const char *key, double *value, struct thud_error *err)
{
    const struct thud_param *param;
    enum thud_status status = find_number(scene, key, &param, err);
    char *text = status == THUD_OK ? value_of(scene, key, &status, err) : NULL;
    if (!text)
        return status;
    struct thud_quantity quantity = {.value = NAN};
    if (text[0] == '[') {
        status = thud_error_set(err, THUD_INPUT, "it has a value for each floor");
        thud_error_allow(err, "%.100s.1 for the lowest", key);
    } else if (text[0]) {
        status = thud_quantity_parse(text, param->kind == THUD_PARAM_QUANTITY ? param->dimension : THUD_NUMBER, NULL,
                                     &quantity, err);
    }
    if (status == THUD_OK)
        *value = quantity.value;
    else
        thud_error_key(err, "%s", key);
    free(text);
    return status;
}

enum thud_status thud_get_number(const struct thud *scene, const char *key, double *value, struct thud_error *err)
{
    enum thud_status status = THUD_NEED(err, scene, key, value);
    if (status != THUD_OK)
        return status;
    locale_t before = thud_threads_numbers();
    status = get_number(scene, key, value, err);
    thud_threads_numbers_back(before);
    return status;
}

int thud_unusual(const struct thud *scene, int n, struct thud_error *out)
{
    if (!scene)
        return 0;
    locale_t before = thud_threads_numbers();
    const struct thud_remark_scope scope = {.scene = &scene->session.scene};
    struct thud_remarks found = thud_remarks_find(&scope, THUD_REMARK_SCENE);
    const bool is = n >= 0 && n < found.n;
    if (is && out)
        *out = found.item[n].said;
    thud_remarks_clear(&found);
    thud_threads_numbers_back(before);
    return is;
}

const char *thud_yaml(struct thud *scene, struct thud_error *err)
{
    unsigned long size;
    enum thud_status status = THUD_NEED(err, scene);
    if (status != THUD_OK)
        return NULL;
    locale_t before = thud_threads_numbers();
    free(scene->yaml);
    scene->yaml = NULL;
    status = thud_preset_text(scene->session.preset, &scene->session.scene, &scene->yaml, &size, err);
    thud_threads_numbers_back(before);
    return status == THUD_OK ? scene->yaml : NULL;
}

enum thud_status thud_set_motion(struct thud *scene, const double *a_mps2, size_t samples, double dt_s,
                                 struct thud_error *err)
{
    struct thud_record *record = NULL;
    enum thud_status status = THUD_NEED(err, scene, a_mps2);
    if (status == THUD_OK && samples == 0)
        status = thud_error_refuse(err, THUD_INPUT, NULL, "at least 1", "a ground motion has no samples");
    if (status == THUD_OK)
        status = thud_record_create(a_mps2, samples, dt_s, &record, err);
    if (status != THUD_OK)
        return status;
    snprintf(record->file, sizeof record->file, "%s", array);
    thud_record_free(scene->session.given);
    thud_record_free(scene->session.record);
    scene->session.given = record;
    scene->session.record = NULL;
    thud_session_choose_record(&scene->session, array);
    return THUD_OK;
}

enum thud_status thud_motion(struct thud *scene, const double **a_mps2, size_t *samples, double *dt_s,
                             struct thud_error *err)
{
    enum thud_status status = THUD_NEED(err, scene, a_mps2, samples, dt_s);
    if (status != THUD_OK)
        return status;
    locale_t before = thud_threads_numbers();
    status = thud_session_read_record(&scene->session, err);
    thud_threads_numbers_back(before);
    const struct thud_record *record = scene->session.record;
    *a_mps2 = status == THUD_OK && record ? record->a_mps2 : NULL;
    *samples = *a_mps2 ? record->samples : 0;
    *dt_s = *a_mps2 ? record->dt_s : NAN;
    return status;
}
