#include "io/preset/preset_private.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/utf8.h"
#include "io/preset/preset.h"

int thud_section_count(const struct thud_scene *scene, enum thud_group group)
{
    return group == THUD_GROUP_STRUCTURE   ? scene->nstructures
           : group == THUD_GROUP_INTERFACE ? scene->nstructures - 1
           : group == THUD_GROUP_LINK      ? scene->nlinks
                                           : 1;
}

bool thud_section_given(const struct thud_scene *scene, struct thud_section section)
{
    if (section.group == THUD_GROUP_BUMPER)
        return thud_interface_says_bumper(&scene->interface[section.index]);
    const struct thud_structure *s = &scene->structure[section.index];
    return section.group == THUD_GROUP_CONTACT || thud_structure_has_group(s, section.group) ||
           *s->source[1 + (int)section.group - THUD_GROUP_COLUMN];
}

void thud_section_path(struct thud_section section, const char *key, char *path, size_t size)
{
    const enum thud_group in = thud_group_in(section.group);
    const char *own = thud_group_key(section.group);
    if (in != THUD_GROUP_SCENE)
        snprintf(path, size, "%s.%d.%s.%.60s", thud_group_key(in), section.index + 1, own, key);
    else if (thud_group_is_list(section.group))
        snprintf(path, size, "%s.%d.%.60s", own, section.index + 1, key);
    else
        snprintf(path, size, "%s%s%.60s", own, *own ? "." : "", key);
}

struct thud_keys thud_keys_of(const struct thud_scene *scene, struct thud_section section, char *text)
{
    struct thud_keys keys = {.scene = scene, .section = section, .text = text};
    const struct thud_interface *interface = &scene->interface[section.index];
    const struct thud_law *law = section.group == THUD_GROUP_CONTACT  ? interface->contact.law
                                 : section.group == THUD_GROUP_BUMPER ? interface->bumper.law
                                                                      : NULL;
    const struct thud_param *param;
    for (int i = 0; (param = thud_group_param(section.group, i)); i++)
        if ((section.group != THUD_GROUP_BUMPER || !interface->has_bumper ||
             strcmp(param->name, "fitted") != 0) && /* written for a bumper that is out */
            (section.group != THUD_GROUP_STRUCTURE || thud_structure_has(scene->structure[section.index].kind, i)) &&
            (section.group != THUD_GROUP_LINK || thud_link_has((enum thud_link_law)scene->link[section.index].law, i)))
            keys.all[keys.n++] = param->name;
    for (int i = 0; law && i < law->nparams; i++)
        keys.all[keys.n++] = law->params[i].name;
    return keys;
}

bool thud_keys_next(struct thud_keys *keys)
{
    while (keys->next < keys->n) {
        keys->key = keys->all[keys->next++];
        thud_section_path(keys->section, keys->key, keys->path, sizeof keys->path);
        if (thud_scene_get_short(keys->scene, keys->path, NULL, keys->text, THUD_VALUE_MAX, NULL) == THUD_OK &&
            *keys->text)
            return true;
    }
    return false;
}

/* ---- scalars ---- */

static bool is_plain(const char *text, bool flow)
{
    size_t length = strlen(text);
    if (length == 0 || strchr(" \t", text[0]) || text[length - 1] == ' ' || text[length - 1] == ':')
        return false;
    if (strchr("?:,[]{}#&*!|>'\"%@`", text[0]) || (text[0] == '-' && (length == 1 || text[1] == ' ' || text[1] == '-')))
        return false;
    if (strncmp(text, "...", 3) == 0 || strstr(text, ": ") || strstr(text, " #"))
        return false;
    for (const char *c = text; *c; c++)
        if (*c < 0x20 || *c > 0x7e || (flow && strchr(",[]{}:#", *c)))
            return false;
    return true;
}

/* Letters that YAML takes for line ends or refuses, by their numbers. */
static bool needs_escape(uint32_t letter)
{
    return letter < 0x20 || (letter >= 0x7f && letter <= 0xa0) || letter == 0x2028 || letter == 0x2029 ||
           letter == 0xfeff || letter == 0xfffe || letter == 0xffff;
}

/* A text as a YAML scalar, quoted where it must be. */
static void emit_scalar(struct thud_text *out, const char *text, bool flow)
{
    if (is_plain(text, flow)) {
        thud_text_append(out, "%s", text);
        return;
    }
    thud_text_append(out, "\"");
    for (const char *next = text, *s; s = next, *s;) {
        uint32_t letter = thud_utf8_next(&next);
        if (*s == '"' || *s == '\\')
            thud_text_append(out, "\\%c", *s);
        else if (needs_escape(letter))
            thud_text_append(out, "\\u%04x", (unsigned)letter);
        else
            thud_text_bytes(out, s, (size_t)(next - s));
    }
    thud_text_append(out, "\"");
}

bool thud_value_is_list(const struct thud_scene *scene, const char *path, const char *text)
{
    int floor;
    const struct thud_param *param = text[0] == '[' ? thud_scene_param(scene, path, &floor) : NULL;
    return param && (param->kind != THUD_PARAM_TEXT || strncmp(path, "study.", 6) == 0);
}

void thud_emit_value(struct thud_text *out, const struct thud_scene *scene, const char *path, const char *text,
                     bool flow)
{
    if (thud_value_is_list(scene, path, text))
        thud_text_append(out, "%s", text);
    else
        emit_scalar(out, text, flow);
}

/* ---- sections ---- */

static void indent_by(struct thud_emit *emit, int indent)
{
    thud_text_append(emit->out, "%*s", indent, "");
}

/* As the program takes it when nothing is said; of structures and interfaces, keys that few of them need. */
static bool as_anyway(struct thud_emit *emit, struct thud_section section, const char *path, const char *text)
{
    if (section.group == THUD_GROUP_STRUCTURE)
        return strcmp(strrchr(path, '.'), ".base") == 0 && strcmp(text, "0 m") == 0;
    if (section.group == THUD_GROUP_COLUMN)
        return strcmp(text, "clamped") == 0;
    if (section.group == THUD_GROUP_INTERFACE)
        return strcmp(strrchr(path, '.'), ".levels") == 0 && strcmp(text, "all") == 0;
    if (section.group == THUD_GROUP_LINK)
        return strcmp(text, "0 cm") == 0 || strcmp(text, "0 kN s/m") == 0;
    if (section.group != THUD_GROUP_RECORD && section.group != THUD_GROUP_ANALYSIS &&
        section.group != THUD_GROUP_STUDY && section.group != THUD_GROUP_SCENE)
        return false;
    struct thud_scene *fresh = malloc(sizeof *fresh);
    char usual[64] = "";
    if (!fresh) {
        emit->out->failed = 1;
        return false;
    }
    thud_scene_init(fresh);
    thud_scene_get_short(fresh, path, NULL, usual, sizeof usual, NULL);
    free(fresh);
    return strcmp(usual, text) == 0;
}

void thud_emit_section(struct thud_emit *emit, const struct thud_scene *scene, struct thud_section section, int indent,
                       bool inline_first)
{
    char *text = malloc(THUD_VALUE_MAX);
    struct thud_keys keys = thud_keys_of(scene, section, text);
    bool first = true;
    while (text && thud_keys_next(&keys)) {
        if (as_anyway(emit, section, keys.path, text))
            continue;
        if (emit->flow)
            thud_text_append(emit->out, "%s", first ? "" : ", ");
        else if (!first || !inline_first)
            indent_by(emit, indent);
        thud_text_append(emit->out, "%s: ", keys.key);
        thud_emit_value(emit->out, scene, keys.path, text, emit->flow);
        thud_text_append(emit->out, "%s", emit->flow ? "" : emit->newline);
        first = false;
    }
    if (!text)
        emit->out->failed = 1;
    free(text);
}

static void emit_nested(struct thud_emit *emit, const struct thud_scene *scene, struct thud_section section, int indent)
{
    if (emit->flow)
        thud_text_append(emit->out, ", %s: {", thud_group_key(section.group));
    else {
        indent_by(emit, indent);
        thud_text_append(emit->out, "%s:%s", thud_group_key(section.group), emit->newline);
    }
    thud_emit_section(emit, scene, section, indent + 2, false);
    thud_text_append(emit->out, "%s", emit->flow ? "}" : "");
}

void thud_emit_item(struct thud_emit *emit, const struct thud_scene *scene, struct thud_section section, int indent)
{
    if (emit->flow)
        thud_text_append(emit->out, "{");
    thud_emit_section(emit, scene, section, indent, true);
    for (enum thud_group group = 0; group < THUD_GROUPS; group++) {
        const struct thud_section nested = {group, section.index};
        if (thud_group_in(group) == section.group && thud_section_given(scene, nested))
            emit_nested(emit, scene, nested, indent);
    }
    if (emit->flow)
        thud_text_append(emit->out, "}");
}

static void emit_group(struct thud_emit *emit, const struct thud_scene *scene, enum thud_group group)
{
    struct thud_text keys = {0};
    struct thud_emit inner = {&keys, emit->newline, false};
    thud_emit_section(&inner, scene, (struct thud_section){group, 0}, group == THUD_GROUP_SCENE ? 0 : 2, false);
    if (keys.size > 0 && group != THUD_GROUP_SCENE)
        thud_text_append(emit->out, "%s:%s", thud_group_key(group), emit->newline);
    thud_text_bytes(emit->out, keys.data ? keys.data : "", keys.size);
    emit->out->failed |= keys.failed;
    thud_text_clear(&keys);
}

void thud_emit_scene(struct thud_emit *emit, const struct thud_scene *scene)
{
    for (enum thud_group group = 0; group < THUD_GROUPS; group++) {
        if (thud_group_in(group) != THUD_GROUP_SCENE)
            continue;
        if (!thud_group_is_list(group)) {
            emit_group(emit, scene, group);
            continue;
        }
        const int n = thud_section_count(scene, group);
        if (n > 0)
            thud_text_append(emit->out, "%s:%s", thud_group_key(group), emit->newline);
        for (int i = 0; i < n; i++) {
            thud_text_append(emit->out, "  - ");
            thud_emit_item(emit, scene, (struct thud_section){group, i}, 4);
        }
    }
}

/* ---- every key ---- */

/* A section, then those nested in it; of a bumper only one that is fitted. */
static void each_key(const struct thud_scene *scene, struct thud_section section, char *value, void *context,
                     void (*each)(void *context, const char *section, const char *key, const char *value))
{
    char prefix[THUD_SECTION_PATH];
    struct thud_keys keys = thud_keys_of(scene, section, value);
    thud_section_path(section, "", prefix, sizeof prefix);
    if (*prefix)
        prefix[strlen(prefix) - 1] = '\0'; /* the point before the key */
    while (thud_keys_next(&keys))
        each(context, prefix, keys.key, value);
    for (enum thud_group group = 0; group < THUD_GROUPS && section.group != THUD_GROUP_SCENE; group++) {
        const struct thud_section nested = {group, section.index};
        if (thud_group_in(group) == section.group && thud_section_given(scene, nested) &&
            (group != THUD_GROUP_BUMPER || scene->interface[section.index].has_bumper))
            each_key(scene, nested, value, context, each);
    }
}

enum thud_status thud_preset_each(const struct thud_scene *scene, void *context,
                                  void (*each)(void *context, const char *section, const char *key, const char *value))
{
    char *value = malloc(THUD_VALUE_MAX);
    if (!value)
        return THUD_MEMORY;
    for (enum thud_group group = 0; group < THUD_GROUP_STUDY; group++)
        for (int i = 0; thud_group_in(group) == THUD_GROUP_SCENE && i < thud_section_count(scene, group); i++)
            each_key(scene, (struct thud_section){group, i}, value, context, each);
    free(value);
    return THUD_OK;
}
