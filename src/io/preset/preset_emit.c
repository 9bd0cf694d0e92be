#include "io/preset/preset_private.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/utf8.h"
#include "io/preset/preset.h"

void thud_section_path(struct thud_section section, char *path, size_t size)
{
    const char *key = thud_group_key(section.group);
    switch (section.group) {
    case THUD_GROUP_STRUCTURE:
    case THUD_GROUP_INTERFACE:
    case THUD_GROUP_LINK:
        snprintf(path, size, "%s.%d", key, section.index + 1);
        break;
    case THUD_GROUP_COLUMN:
    case THUD_GROUP_ISOLATOR:
    case THUD_GROUP_FOUNDATION:
    case THUD_GROUP_BACKFILL:
        snprintf(path, size, "%s.%d.%s", thud_group_key(THUD_GROUP_STRUCTURE), section.index + 1, key);
        break;
    case THUD_GROUP_CONTACT:
    case THUD_GROUP_BUMPER:
        snprintf(path, size, "%s.%d.%s", thud_group_key(THUD_GROUP_INTERFACE), section.index + 1, key);
        break;
    default:
        snprintf(path, size, "%s", key);
    }
}

int thud_section_keys(const struct thud_scene *scene, struct thud_section section, const char **key)
{
    int n = 0;
    const struct thud_param *param;
    const struct thud_law *law = section.group == THUD_GROUP_CONTACT  ? scene->interface[section.index].contact.law
                                 : section.group == THUD_GROUP_BUMPER ? scene->interface[section.index].bumper.law
                                                                      : NULL;
    for (int i = 0; (param = thud_group_param(section.group, i)); i++)
        if ((section.group != THUD_GROUP_BUMPER || !scene->interface[section.index].has_bumper ||
             strcmp(param->name, "fitted") != 0) && /* written for a bumper that is out */
            (section.group != THUD_GROUP_STRUCTURE || thud_structure_has(scene->structure[section.index].kind, i)) &&
            (section.group != THUD_GROUP_LINK || thud_link_has((enum thud_link_law)scene->link[section.index].law, i)))
            key[n++] = param->name;
    for (int i = 0; law && i < law->nparams; i++)
        key[n++] = law->params[i].name;
    return n;
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

void thud_emit_value(struct thud_text *out, const char *path, const char *text, bool flow)
{
    bool list = text[0] == '[' &&
                (strncmp(path, "structures.", 11) == 0 || strncmp(path, "study.", 6) == 0 || strstr(path, "-level")) &&
                strcmp(path + strlen(path) - 5, ".name") != 0;
    if (list)
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
    thud_scene_get(fresh, path, usual, sizeof usual, NULL);
    free(fresh);
    return strcmp(usual, text) == 0;
}

void thud_emit_section(struct thud_emit *emit, const struct thud_scene *scene, struct thud_section section, int indent,
                       bool inline_first)
{
    const char *key[THUD_SECTION_KEYS_MAX];
    char prefix[THUD_SECTION_PATH], path[128], *text = malloc(THUD_VALUE_MAX);
    int n = thud_section_keys(scene, section, key);
    thud_section_path(section, prefix, sizeof prefix);
    bool first = true;
    for (int i = 0; text && i < n; i++) {
        snprintf(path, sizeof path, "%s%s%s", prefix, *prefix ? "." : "", key[i]);
        if (thud_scene_get(scene, path, text, THUD_VALUE_MAX, NULL) != THUD_OK || !*text ||
            as_anyway(emit, section, path, text))
            continue;
        if (emit->flow)
            thud_text_append(emit->out, "%s", first ? "" : ", ");
        else if (!first || !inline_first)
            indent_by(emit, indent);
        thud_text_append(emit->out, "%s: ", key[i]);
        thud_emit_value(emit->out, path, text, emit->flow);
        thud_text_append(emit->out, "%s", emit->flow ? "" : emit->newline);
        first = false;
    }
    if (!text)
        emit->out->failed = 1;
    free(text);
}

static void emit_nested(struct thud_emit *emit, const struct thud_scene *scene, enum thud_group group, int index,
                        int indent)
{
    if (emit->flow)
        thud_text_append(emit->out, ", %s: {", thud_group_key(group));
    else {
        indent_by(emit, indent);
        thud_text_append(emit->out, "%s:%s", thud_group_key(group), emit->newline);
    }
    thud_emit_section(emit, scene, (struct thud_section){group, index}, indent + 2, false);
    thud_text_append(emit->out, "%s", emit->flow ? "}" : "");
}

void thud_emit_item(struct thud_emit *emit, const struct thud_scene *scene, struct thud_section section, int indent)
{
    if (emit->flow)
        thud_text_append(emit->out, "{");
    thud_emit_section(emit, scene, section, indent, true);
    if (section.group == THUD_GROUP_INTERFACE) {
        emit_nested(emit, scene, THUD_GROUP_CONTACT, section.index, indent);
        if (thud_interface_says_bumper(&scene->interface[section.index]))
            emit_nested(emit, scene, THUD_GROUP_BUMPER, section.index, indent);
    }
    for (int i = 0; i < THUD_NESTED_GROUPS && section.group == THUD_GROUP_STRUCTURE; i++)
        if (thud_structure_has_group(&scene->structure[section.index], thud_nested_group(i)))
            emit_nested(emit, scene, thud_nested_group(i), section.index, indent);
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
    emit_group(emit, scene, THUD_GROUP_SCENE);
    emit_group(emit, scene, THUD_GROUP_RECORD);
    static const enum thud_group lists[] = {THUD_GROUP_STRUCTURE, THUD_GROUP_INTERFACE, THUD_GROUP_LINK};
    for (int g = 0; g < 3; g++) {
        enum thud_group group = lists[g];
        int n = g == 0 ? scene->nstructures : g == 1 ? scene->nstructures - 1 : scene->nlinks;
        if (n > 0)
            thud_text_append(emit->out, "%s:%s", thud_group_key(group), emit->newline);
        for (int i = 0; i < n; i++) {
            thud_text_append(emit->out, "  - ");
            thud_emit_item(emit, scene, (struct thud_section){group, i}, 4);
        }
    }
    emit_group(emit, scene, THUD_GROUP_ANALYSIS);
    emit_group(emit, scene, THUD_GROUP_STUDY);
    emit_group(emit, scene, THUD_GROUP_DOCUMENT);
}

/* ---- every key ---- */

static void each_key(const struct thud_scene *scene, struct thud_section section, char *value, void *context,
                     void (*each)(void *context, const char *section, const char *key, const char *value))
{
    const char *key[THUD_SECTION_KEYS_MAX];
    char prefix[THUD_SECTION_PATH], path[128];
    int n = thud_section_keys(scene, section, key);
    thud_section_path(section, prefix, sizeof prefix);
    for (int i = 0; i < n; i++) {
        snprintf(path, sizeof path, "%s%s%s", prefix, *prefix ? "." : "", key[i]);
        if (thud_scene_get(scene, path, value, THUD_VALUE_MAX, NULL) == THUD_OK && *value)
            each(context, prefix, key[i], value);
    }
}

enum thud_status thud_preset_each(const struct thud_scene *scene, void *context,
                                  void (*each)(void *context, const char *section, const char *key, const char *value))
{
    char *value = malloc(THUD_VALUE_MAX);
    if (!value)
        return THUD_MEMORY;
    each_key(scene, (struct thud_section){THUD_GROUP_SCENE, 0}, value, context, each);
    each_key(scene, (struct thud_section){THUD_GROUP_RECORD, 0}, value, context, each);
    for (int s = 0; s < scene->nstructures; s++) {
        each_key(scene, (struct thud_section){THUD_GROUP_STRUCTURE, s}, value, context, each);
        for (int i = 0; i < THUD_NESTED_GROUPS; i++)
            if (thud_structure_has_group(&scene->structure[s], thud_nested_group(i)))
                each_key(scene, (struct thud_section){thud_nested_group(i), s}, value, context, each);
    }
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        each_key(scene, (struct thud_section){THUD_GROUP_INTERFACE, i}, value, context, each);
        each_key(scene, (struct thud_section){THUD_GROUP_CONTACT, i}, value, context, each);
        if (scene->interface[i].has_bumper)
            each_key(scene, (struct thud_section){THUD_GROUP_BUMPER, i}, value, context, each);
    }
    for (int i = 0; i < scene->nlinks; i++)
        each_key(scene, (struct thud_section){THUD_GROUP_LINK, i}, value, context, each);
    each_key(scene, (struct thud_section){THUD_GROUP_ANALYSIS, 0}, value, context, each);
    free(value);
    return THUD_OK;
}
