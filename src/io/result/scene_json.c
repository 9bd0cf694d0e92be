#include "io/result/scene_json.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/file/json.h"
#include "io/file/schema.h"
#include "io/preset/preset_private.h"

struct writer {
    const struct thud_scene *scene;
    const char *file;
    int indent;
    bool si; /* numbers in SI, their keys with the unit */
    struct thud_text *out;
    char *value; /* THUD_VALUE_MAX */
};

/* "0.1" of "10 cm" in SI; what is no number as a string. */
static void put_item(struct writer *w, const struct thud_param *param, const char *text)
{
    struct thud_quantity quantity;
    const bool number = param && (param->kind == THUD_PARAM_QUANTITY || param->kind == THUD_PARAM_INTEGER);
    if (number && thud_quantity_parse(text, param->kind == THUD_PARAM_QUANTITY ? param->dimension : THUD_NUMBER, NULL,
                                      &quantity, NULL) == THUD_OK)
        thud_json_number(w->out, quantity.value);
    else
        thud_json_string(w->out, text);
}

/* "[[5 cm, 6 cm], [on]]", item by item. */
static void put_list(struct writer *w, const struct thud_param *param, char *list)
{
    struct thud_text *out = w->out;
    for (char *at = list; *at;) {
        size_t n = strcspn(at, "[],");
        if (n > 0) {
            char end = at[n];
            at[n] = '\0';
            put_item(w, param, at);
            at[n] = end;
            at += n;
        } else {
            thud_text_append(out, *at == ',' ? ", " : "%c", *at);
            at += 1 + (size_t)(*at == ',') * strspn(at + 1, " ");
        }
    }
}

static void put_value(struct writer *w, const char *path, const char *key)
{
    int floor;
    const struct thud_param *param = w->si ? thud_scene_param(w->scene, path, &floor) : NULL;
    char name[THUD_NAME_MAX];
    snprintf(name, sizeof name, "%s%s", key, param ? thud_si_suffix(param) : "");
    thud_json_string(w->out, name);
    thud_text_append(w->out, ": ");
    if (thud_value_is_list(w->scene, path, w->value))
        put_list(w, param, w->value);
    else
        put_item(w, param, strcmp(path, "record.file") == 0 && w->file ? w->file : w->value);
}

/* The keys of a section, separated by commas; their count. */
static int put_keys(struct writer *w, struct thud_section section)
{
    int count = 0;
    struct thud_keys keys = thud_keys_of(w->scene, section, w->value);
    while (thud_keys_next(&keys)) {
        thud_text_append(w->out, "%s", count++ ? ", " : "");
        put_value(w, keys.path, keys.key);
    }
    return count;
}

static void put_items(struct writer *w, enum thud_group group)
{
    const int n = thud_section_count(w->scene, group);
    thud_text_append(w->out, ",\n%*s\"%s\": [", w->indent, "", thud_group_key(group));
    for (int i = 0; i < n; i++) {
        thud_text_append(w->out, "%s\n%*s{", i ? "," : "", w->indent + 2, "");
        put_keys(w, (struct thud_section){group, i});
        if (group == THUD_GROUP_STRUCTURE && w->si && w->scene->structure[i].file_sha256[0])
            thud_text_append(w->out, ", \"sha256\": \"%s\"", w->scene->structure[i].file_sha256);
        for (enum thud_group k = 0; k < THUD_GROUPS; k++) {
            const struct thud_section nested = {k, i};
            if (thud_group_in(k) != group || !thud_section_given(w->scene, nested) ||
                (k == THUD_GROUP_BUMPER && !w->scene->interface[i].has_bumper))
                continue;
            thud_text_append(w->out, ",\n%*s\"%s\": {", w->indent + 4, "", thud_group_key(k));
            put_keys(w, nested);
            thud_text_append(w->out, "}");
        }
        thud_text_append(w->out, "}");
    }
    thud_text_append(w->out, "]");
}

/* `after`: something stands before it. */
static void put_group(struct writer *w, enum thud_group group, bool after)
{
    if (after)
        thud_text_append(w->out, ",\n%*s", w->indent, "");
    thud_text_append(w->out, "\"%s\": {", thud_group_key(group));
    put_keys(w, (struct thud_section){group, 0});
    thud_text_append(w->out, "}");
}

static void put_scene(const struct thud_scene *scene, const char *file, int indent, bool si, struct thud_text *out)
{
    struct writer w = {scene, file, indent, si, out, malloc(THUD_VALUE_MAX)};
    if (!w.value) {
        out->failed = 1;
        return;
    }
    thud_text_append(out, "{\n%*s", indent, "");
    /* without a title there may be none: a comma stands only between two */
    const int keys = put_keys(&w, (struct thud_section){THUD_GROUP_SCENE, 0});
    put_group(&w, THUD_GROUP_ANALYSIS, keys > 0);
    if (scene->record.file[0])
        put_group(&w, THUD_GROUP_RECORD, true);
    put_items(&w, THUD_GROUP_STRUCTURE);
    if (scene->nstructures > 1)
        put_items(&w, THUD_GROUP_INTERFACE);
    if (scene->nlinks > 0)
        put_items(&w, THUD_GROUP_LINK);
    if (scene->study.nvary > 0 || scene->study.ncases > 0 || scene->study.sensitivity > 0)
        put_group(&w, THUD_GROUP_STUDY, true);
    struct thud_keys block = thud_keys_of(scene, (struct thud_section){THUD_GROUP_DOCUMENT, 0}, w.value);
    if (thud_keys_next(&block))
        put_group(&w, THUD_GROUP_DOCUMENT, true);
    thud_text_append(out, "}");
    free(w.value);
}

void thud_scene_json(const struct thud_scene *scene, const char *file, int indent, struct thud_text *out)
{
    put_scene(scene, file, indent, false, out);
}

void thud_scene_members_json(const struct thud_scene *scene, const char *file, struct thud_text *out)
{
    thud_text_append(out, "  \"scene_si\": ");
    put_scene(scene, file, 4, true, out);
    thud_text_append(out, ",\n  \"scene\": ");
    put_scene(scene, file, 4, false, out);
}
