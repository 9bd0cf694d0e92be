/* Differences between a preset as read and a scene, as replaced spans of its text. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/preset/preset_private.h"

enum { PATH_BYTES = 160 };

struct saving {
    const struct thud_preset *preset;
    const struct thud_scene *now; /* the scene to be saved */
    struct thud_patches *patches;
    const char *newline;
    char *before, *after; /* (THUD_VALUE_MAX) texts of a value */
};

static const struct thud_yaml_node *node_at(const struct saving *s, int node)
{
    return &s->preset->tree.node[node];
}

/* ---- places in the file ---- */

static size_t line_start(const struct saving *s, size_t at)
{
    while (at > 0 && s->preset->text[at - 1] != '\n')
        at--;
    return at;
}

/* Behind the newline that ends the line. */
static size_t next_line(const struct saving *s, size_t at)
{
    const char *end = memchr(s->preset->text + at, '\n', s->preset->size - at);
    return end ? (size_t)(end - s->preset->text) + 1 : s->preset->size;
}

static bool first_on_line(const struct saving *s, size_t at)
{
    size_t start = line_start(s, at);
    return strspn(s->preset->text + start, " ") == at - start;
}

static int indent_of(const struct saving *s, int node)
{
    return node_at(s, node)->column - 1;
}

/* Lines of comment between the first and the last line of a node. */
static void comments_in(const struct saving *s, int node, struct thud_text *lines)
{
    const char *text = s->preset->text;
    size_t end = node_at(s, node)->end, next;
    for (size_t at = next_line(s, node_at(s, node)->start); at < end; at = next) {
        next = next_line(s, at);
        if (text[at + strspn(text + at, " \t")] == '#')
            thud_text_bytes(lines, text + at, next - at);
    }
}

/* Lines of comment that stood in a list or in {} stand before what replaces it. */
static void replace_node(struct saving *s, int node, struct thud_text *text)
{
    struct thud_text lines = {0}, kept = {0};
    size_t start = node_at(s, node)->start, line = line_start(s, start);
    if (node_at(s, node)->kind != THUD_YAML_SCALAR)
        comments_in(s, node, &lines);
    if (!lines.size) {
        text->failed |= lines.failed;
        thud_patch_add(s->patches, start, node_at(s, node)->end, text);
        return;
    }
    bool first = first_on_line(s, start);
    size_t indent = first ? start - line : strspn(s->preset->text + line, " -");
    if (line + indent < start) /* behind a key */
        indent += 2;
    while (!first && s->preset->text[start - 1] == ' ')
        start--;
    thud_text_append(&kept, "%s", first ? "" : s->newline);
    thud_text_bytes(&kept, lines.data, lines.size);
    thud_text_append(&kept, "%*s", (int)indent, "");
    thud_text_bytes(&kept, text->data ? text->data : "", text->size);
    kept.failed |= lines.failed | text->failed;
    thud_text_clear(&lines);
    thud_text_clear(text);
    thud_patch_add(s->patches, first ? line : start, node_at(s, node)->end, &kept);
}

/* Takes a key with its value out of a block; lines of comment in a list stay. */
static void delete_key(struct saving *s, int key)
{
    struct thud_text lines = {0};
    int value = node_at(s, key)->next, next = node_at(s, value)->next;
    size_t start = node_at(s, key)->start;
    if (node_at(s, value)->kind == THUD_YAML_LIST)
        comments_in(s, value, &lines);
    if (!first_on_line(s, start) && next >= 0) { /* behind the dash of a list: the next key takes its place */
        struct thud_text text = {0};
        if (lines.size) {
            thud_text_append(&text, "%s", s->newline);
            thud_text_bytes(&text, lines.data, lines.size);
            thud_text_append(&text, "%*s", indent_of(s, key), "");
        }
        text.failed |= lines.failed;
        thud_text_clear(&lines);
        thud_patch_add(s->patches, start, node_at(s, next)->start, &text);
    } else
        thud_patch_add(s->patches, line_start(s, start), next_line(s, node_at(s, value)->end), &lines);
}

/* Lines behind the last one of a block. */
static void append_lines(struct saving *s, int node, struct thud_text *lines)
{
    size_t at = next_line(s, node_at(s, node)->end);
    struct thud_text text = {0};
    if (at > 0 && s->preset->text[at - 1] != '\n')
        thud_text_append(&text, "%s", s->newline);
    thud_text_bytes(&text, lines->data ? lines->data : "", lines->size);
    text.failed |= lines->failed;
    thud_text_clear(lines);
    thud_patch_add(s->patches, at, at, &text);
}

/* ---- values ---- */

/* Texts of a value before and after, in its shown unit; false where the scene to be saved has no such key. */
static bool read_texts(struct saving *s, const char *path)
{
    if (thud_scene_get_short(&s->preset->scene, path, NULL, s->before, THUD_VALUE_MAX, NULL) != THUD_OK)
        s->before[0] = '\0';
    return thud_scene_get_short(s->now, path, NULL, s->after, THUD_VALUE_MAX, NULL) == THUD_OK;
}

/* The unit a value was typed in, where what stands there now can be written in it; else NULL. */
static const char *typed_unit(const struct saving *s, int scalar, const char *path)
{
    const char *end;
    double number;
    int floor;
    enum thud_dimension dimension;
    const struct thud_param *param = thud_scene_param(s->now, path, &floor);
    if (!param || node_at(s, scalar)->kind != THUD_YAML_SCALAR ||
        thud_number_parse(thud_yaml_text(&s->preset->tree, scalar), &end, &number) != 0)
        return NULL;
    end += strspn(end, " \t");
    bool plain = param->dimension == THUD_NUMBER || param->dimension == THUD_RATIO;
    if (!(thud_unit_factor(end, &dimension, NULL) > 0))
        return NULL;
    return dimension == param->dimension || (plain && (dimension == THUD_NUMBER || dimension == THUD_RATIO)) ? end
                                                                                                             : NULL;
}

static void replace_value(struct saving *s, int value, const char *path, const char *unit)
{
    struct thud_text text = {0};
    thud_scene_get_short(s->now, path, unit, s->after, THUD_VALUE_MAX, NULL);
    thud_emit_value(&text, s->now, path, s->after, true);
    replace_node(s, value, &text);
}

/* All floors one by one, whether they are the same or not. */
static void replace_list(struct saving *s, int list, const char *path, int storeys, const char *unit)
{
    struct thud_text text = {0};
    for (int i = 0; i < storeys; i++) {
        char item[PATH_BYTES + 16];
        snprintf(item, sizeof item, "%s.%d", path, i + 1);
        thud_scene_get_short(s->now, item, unit, s->after, THUD_VALUE_MAX, NULL);
        thud_text_append(&text, "%s%s", i ? ", " : "[", s->after);
    }
    thud_text_append(&text, "]");
    replace_node(s, list, &text);
}

static void save_floors(struct saving *s, int list, const char *path, int storeys)
{
    if (node_at(s, list)->children != storeys) {
        replace_list(s, list, path, storeys, typed_unit(s, node_at(s, list)->first, path));
        return;
    }
    int i = 0;
    for (int item = node_at(s, list)->first; item >= 0; item = node_at(s, item)->next) {
        char full[PATH_BYTES + 16];
        snprintf(full, sizeof full, "%s.%d", path, ++i);
        if (read_texts(s, full) && strcmp(s->before, s->after) != 0)
            replace_value(s, item, full, typed_unit(s, item, full));
    }
}

static bool of_structure(struct thud_section section)
{
    return section.group == THUD_GROUP_STRUCTURE || section.group == THUD_GROUP_COLUMN;
}

static void save_value(struct saving *s, struct thud_section section, int value, const char *path)
{
    bool list = node_at(s, value)->kind == THUD_YAML_LIST;
    if (list && of_structure(section) && s->now->structure[section.index].kind != THUD_RIGID)
        save_floors(s, value, path, s->now->structure[section.index].storeys);
    else
        replace_value(s, value, path, list || section.group == THUD_GROUP_STUDY ? NULL : typed_unit(s, value, path));
}

/* A list of floors as long as the structure was, not as it is; a rigid body takes no list. */
static bool other_length(const struct saving *s, struct thud_section section, int value)
{
    const struct thud_structure *now = &s->now->structure[section.index];
    return of_structure(section) && node_at(s, value)->kind == THUD_YAML_LIST &&
           (node_at(s, value)->children != now->storeys || now->kind == THUD_RIGID);
}

/* ---- sections ---- */

/* A list says how many storeys there are, so the key need not be added. */
static bool said_by_list(const struct saving *s, int node, const char *key)
{
    return strcmp(key, "storeys") == 0 && thud_preset_storeys(&s->preset->tree, node) >= 0;
}

/* Keys that the file has: replaced or taken out. Returns how many stay. */
static int save_present(struct saving *s, struct thud_section section, int node, bool dry, bool *out)
{
    int stay = 0;
    for (int key = node_at(s, node)->first; key >= 0; key = node_at(s, node_at(s, key)->next)->next) {
        const char *name = thud_yaml_text(&s->preset->tree, key);
        int value = node_at(s, key)->next;
        char path[PATH_BYTES];
        thud_section_path(section, name, path, sizeof path);
        if (thud_group_find(section.group, name) != THUD_GROUPS) { /* it has keys of its own */
            stay++;
        } else if (!read_texts(s, path) || !*s->after ||
                   (section.group == THUD_GROUP_BUMPER && s->now->interface[section.index].has_bumper &&
                    strcmp(name, "fitted") == 0)) { /* said of a bumper that is out alone */
            *out = true;
            if (!dry)
                delete_key(s, key);
        } else {
            stay++;
            if (!dry && (strcmp(s->before, s->after) != 0 || other_length(s, section, value)))
                save_value(s, section, value, path);
        }
    }
    return stay;
}

/* With another law or kind the defaults are others too, so what the file does not say has to be said. */
static bool other_defaults(const struct saving *s, struct thud_section section)
{
    const struct thud_scene *was = &s->preset->scene;
    int i = section.index;
    if (section.group == THUD_GROUP_STRUCTURE)
        return was->structure[i].kind != s->now->structure[i].kind;
    if (section.group == THUD_GROUP_CONTACT)
        return was->interface[i].contact.law != s->now->interface[i].contact.law;
    if (section.group == THUD_GROUP_LINK)
        return was->link[i].law != s->now->link[i].law;
    return section.group == THUD_GROUP_BUMPER && was->interface[i].bumper.law != s->now->interface[i].bumper.law;
}

/* Keys that the file has not and the scene needs; lines of them. */
static int save_absent(struct saving *s, struct thud_section section, int node, int indent, struct thud_text *lines)
{
    int added = 0;
    struct thud_keys keys = thud_keys_of(s->now, section, s->after);
    while (thud_keys_next(&keys)) {
        if ((node >= 0 && thud_yaml_find(&s->preset->tree, node, keys.key, NULL) >= 0) || !read_texts(s, keys.path) ||
            (strcmp(s->before, s->after) == 0 && !other_defaults(s, section)) ||
            (node >= 0 && said_by_list(s, node, keys.key)))
            continue;
        thud_text_append(lines, "%*s%s: ", indent, "", keys.key);
        thud_emit_value(lines, s->now, keys.path, s->after, false);
        thud_text_append(lines, "%s", s->newline);
        added++;
    }
    return added;
}

/* {a: b}: with keys to add or take out it is written again as a whole. */
static void rewrite_flow(struct saving *s, struct thud_section section, int node)
{
    struct thud_text text = {0};
    struct thud_emit emit = {&text, s->newline, true};
    if (thud_group_is_list(section.group))
        thud_emit_item(&emit, s->now, section, 0);
    else {
        thud_text_append(&text, "{");
        thud_emit_section(&emit, s->now, section, 0, false);
        thud_text_append(&text, "}");
    }
    replace_node(s, node, &text);
}

/* Returns false when the section was written again as a whole, or nothing of it stays. */
static bool save_section(struct saving *s, struct thud_section section, int node)
{
    struct thud_text lines = {0};
    bool out = false;
    int stay = save_present(s, section, node, true, &out);
    int added = save_absent(s, section, node, indent_of(s, node), &lines);
    if (stay + added == 0) {
        thud_text_clear(&lines);
        return false;
    }
    if (node_at(s, node)->flow && (out || added)) {
        thud_text_clear(&lines);
        rewrite_flow(s, section, node);
        return false;
    }
    save_present(s, section, node, false, &out);
    if (added)
        append_lines(s, node, &lines);
    return true;
}

/* record, analysis or study. */
static void save_group(struct saving *s, enum thud_group group)
{
    struct thud_section section = {group, 0};
    const char *name = thud_group_key(group);
    int key = -1, node = thud_yaml_find(&s->preset->tree, 0, name, &key);
    struct thud_text lines = {0};
    if (node >= 0) {
        bool out = false;
        int stay = save_present(s, section, node, true, &out), added = save_absent(s, section, node, 0, &lines);
        thud_text_clear(&lines);
        if (stay + added > 0)
            save_section(s, section, node);
        else
            delete_key(s, key);
        return;
    }
    struct thud_text keys = {0};
    if (save_absent(s, section, -1, indent_of(s, 0) + 2, &keys)) {
        thud_text_append(&lines, "%*s%s:%s", indent_of(s, 0), "", name, s->newline);
        thud_text_bytes(&lines, keys.data, keys.size);
        append_lines(s, 0, &lines);
    }
    thud_text_clear(&keys);
}

/* Keys with keys of their own that are not there yet, behind the others of an item. */
static void append_nested(struct saving *s, enum thud_group group, int i, int node)
{
    struct thud_text lines = {0};
    struct thud_emit emit = {&lines, s->newline, false};
    int indent = indent_of(s, node);
    thud_text_append(&lines, "%*s%s:%s", indent, "", thud_group_key(group), s->newline);
    thud_emit_section(&emit, s->now, (struct thud_section){group, i}, indent + 2, false);
    append_lines(s, node, &lines);
}

/* An item of a list with what has keys of its own in it; a contact is said where it was, or has another law. */
static void save_item(struct saving *s, struct thud_section section, int node)
{
    const struct thud_law_choice *is = &s->now->interface[section.index].contact;
    struct thud_law_choice was = s->preset->scene.interface[section.index].contact;
    was.assumed = is->assumed;
    int key[THUD_GROUPS], value[THUD_GROUPS];
    bool now[THUD_GROUPS] = {false}, changed = false;
    for (enum thud_group group = 0; group < THUD_GROUPS; group++) {
        key[group] = value[group] = -1;
        if (thud_group_in(group) != section.group)
            continue;
        value[group] = thud_yaml_find(&s->preset->tree, node, thud_group_key(group), &key[group]);
        now[group] =
            group == THUD_GROUP_CONTACT
                ? value[group] >= 0 || memcmp(&was, is, sizeof was) != 0 || *s->now->interface[section.index].source[1]
                : thud_section_given(s->now, (struct thud_section){group, section.index});
        changed = changed || (value[group] >= 0) != now[group];
    }
    if (node_at(s, node)->flow && changed) {
        rewrite_flow(s, section, node);
        return;
    }
    if (!save_section(s, section, node))
        return;
    for (enum thud_group group = 0; group < THUD_GROUPS; group++) {
        if (value[group] >= 0 && now[group])
            save_section(s, (struct thud_section){group, section.index}, value[group]);
        else if (value[group] >= 0)
            delete_key(s, key[group]);
        else if (now[group])
            append_nested(s, group, section.index, node);
    }
}

/* ---- structures added, removed ---- */

static const void *item_of(const struct thud_scene *scene, enum thud_group group, int i, size_t *size)
{
    if (group == THUD_GROUP_LINK) {
        *size = sizeof scene->link[i];
        return &scene->link[i];
    }
    *size = group == THUD_GROUP_STRUCTURE ? sizeof scene->structure[i] : sizeof scene->interface[i];
    return group == THUD_GROUP_STRUCTURE ? (const void *)&scene->structure[i] : (const void *)&scene->interface[i];
}

/* An item that the file has already keeps its bytes, comments and all; -1 where it has none like it. */
static int same_item(const struct saving *s, enum thud_group group, int i, int list)
{
    size_t size;
    const void *now = item_of(s->now, group, i, &size);
    for (int j = 0; j < node_at(s, list)->children; j++) {
        int item = thud_yaml_child(&s->preset->tree, list, j);
        /* a structure without a name is called by its place */
        bool named =
            group != THUD_GROUP_STRUCTURE || j == i || thud_yaml_find(&s->preset->tree, item, "name", NULL) >= 0;
        if (named && memcmp(item_of(&s->preset->scene, group, j, &size), now, size) == 0)
            return item;
    }
    return -1;
}

static void append_item(struct saving *s, struct thud_emit *emit, struct thud_section section, int list, int indent)
{
    int item = list >= 0 && !emit->flow ? same_item(s, section.group, section.index, list) : -1;
    if (item < 0) {
        thud_text_append(emit->out, "- ");
        thud_emit_item(emit, s->now, section, indent + 2);
        return;
    }
    size_t start = node_at(s, item)->start, end = next_line(s, node_at(s, item)->end);
    thud_text_append(emit->out, "-%*s", indent_of(s, item) - indent - 1, "");
    thud_text_bytes(emit->out, s->preset->text + start, end - start);
    if (end > start && s->preset->text[end - 1] != '\n')
        thud_text_append(emit->out, "%s", s->newline);
}

/* The whole list; `structures`, `interfaces` or `links`. */
static void save_list(struct saving *s, enum thud_group group, int n)
{
    const char *name = thud_group_key(group);
    int key = -1, list = thud_yaml_find(&s->preset->tree, 0, name, &key);
    struct thud_text text = {0};
    struct thud_emit emit = {&text, s->newline, list >= 0 && node_at(s, list)->flow};
    int indent = list >= 0 && !emit.flow ? indent_of(s, list) : indent_of(s, 0) + 2;
    if (n == 0 && list >= 0) {
        delete_key(s, key);
        return;
    }
    if (list < 0 && n > 0)
        thud_text_append(&text, "%*s%s:%s", indent_of(s, 0), "", name, s->newline);
    for (int i = 0; i < n; i++) {
        if (emit.flow) {
            thud_text_append(&text, "%s", i ? ", " : "[");
            thud_emit_item(&emit, s->now, (struct thud_section){group, i}, 0);
            continue;
        }
        if (i > 0 || list < 0)
            thud_text_append(&text, "%*s", indent, "");
        append_item(s, &emit, (struct thud_section){group, i}, list, indent);
    }
    if (list < 0 && n > 0)
        append_lines(s, 0, &text);
    else if (emit.flow) {
        thud_text_append(&text, "]");
        replace_node(s, list, &text);
    } else if (n > 0)
        thud_patch_add(s->patches, node_at(s, list)->start, next_line(s, node_at(s, list)->end), &text);
}

static void save_all(struct saving *s)
{
    for (enum thud_group group = 0; group < THUD_GROUPS; group++) {
        const int n = thud_section_count(s->now, group),
                  list = thud_yaml_find(&s->preset->tree, 0, thud_group_key(group), NULL);
        if (thud_group_in(group) != THUD_GROUP_SCENE)
            continue;
        if (group == THUD_GROUP_SCENE)
            save_section(s, (struct thud_section){group, 0}, 0);
        else if (!thud_group_is_list(group))
            save_group(s, group);
        else if (thud_section_count(&s->preset->scene, group) != n)
            save_list(s, group, n);
        else
            for (int i = 0; i < n; i++)
                save_item(s, (struct thud_section){group, i}, thud_yaml_child(&s->preset->tree, list, i));
    }
}

bool thud_preset_diff(const struct thud_preset *preset, const struct thud_scene *scene, const char *newline,
                      struct thud_patches *patches)
{
    struct saving s = {preset, scene, patches, newline, malloc(THUD_VALUE_MAX), malloc(THUD_VALUE_MAX)};
    bool ok = s.before && s.after;
    if (ok)
        save_all(&s);
    free(s.before);
    free(s.after);
    return ok && !patches->failed;
}
