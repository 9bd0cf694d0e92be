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
static void replace(struct saving *s, int node, struct thud_text *text)
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
static bool texts(struct saving *s, const char *path)
{
    if (thud_scene_get(&s->preset->scene, path, s->before, THUD_VALUE_MAX, NULL) != THUD_OK)
        s->before[0] = '\0';
    return thud_scene_get(s->now, path, s->after, THUD_VALUE_MAX, NULL) == THUD_OK;
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
    thud_scene_get_in(s->now, path, unit, s->after, THUD_VALUE_MAX, NULL);
    thud_emit_value(&text, path, s->after, true);
    replace(s, value, &text);
}

/* All floors one by one, whether they are the same or not. */
static void replace_list(struct saving *s, int list, const char *path, int storeys, const char *unit)
{
    struct thud_text text = {0};
    for (int i = 0; i < storeys; i++) {
        char item[PATH_BYTES + 16];
        snprintf(item, sizeof item, "%s.%d", path, i + 1);
        thud_scene_get_in(s->now, item, unit, s->after, THUD_VALUE_MAX, NULL);
        thud_text_append(&text, "%s%s", i ? ", " : "[", s->after);
    }
    thud_text_append(&text, "]");
    replace(s, list, &text);
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
        if (texts(s, full) && strcmp(s->before, s->after) != 0)
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
    static const char *const lists[] = {"mass", "stiffness", "height"};
    for (size_t i = 0; strcmp(key, "storeys") == 0 && i < sizeof lists / sizeof *lists; i++) {
        int value = thud_yaml_find(&s->preset->tree, node, lists[i], NULL);
        if (value >= 0 && node_at(s, value)->kind == THUD_YAML_LIST)
            return true;
    }
    return false;
}

static bool is_nested(const char *key)
{
    for (int i = 0; i < THUD_NESTED_GROUPS; i++)
        if (strcmp(key, thud_group_key(thud_nested_group(i))) == 0)
            return true;
    return false;
}

static void path_of(struct thud_section section, const char *key, char *path, size_t size)
{
    char prefix[THUD_SECTION_PATH];
    thud_section_path(section, prefix, sizeof prefix);
    snprintf(path, size, "%s%s%.60s", prefix, *prefix ? "." : "", key);
}

/* Keys that the file has: replaced or taken out. Returns how many stay. */
static int save_present(struct saving *s, struct thud_section section, int node, bool dry, bool *out)
{
    int stay = 0;
    for (int key = node_at(s, node)->first; key >= 0; key = node_at(s, node_at(s, key)->next)->next) {
        const char *name = thud_yaml_text(&s->preset->tree, key);
        int value = node_at(s, key)->next;
        char path[PATH_BYTES];
        path_of(section, name, path, sizeof path);
        bool nested =
            (section.group == THUD_GROUP_INTERFACE && (strcmp(name, "contact") == 0 || strcmp(name, "bumper") == 0)) ||
            (section.group == THUD_GROUP_STRUCTURE && is_nested(name)) ||
            (section.group == THUD_GROUP_SCENE && strcmp(name, "title") != 0 && strcmp(name, "p-delta") != 0);
        if (nested) {
            stay++;
        } else if (!texts(s, path) || !*s->after ||
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
    const char *key[THUD_SECTION_KEYS_MAX];
    int n = thud_section_keys(s->now, section, key), added = 0;
    for (int i = 0; i < n; i++) {
        char path[PATH_BYTES];
        path_of(section, key[i], path, sizeof path);
        if ((node >= 0 && thud_yaml_find(&s->preset->tree, node, key[i], NULL) >= 0) || !texts(s, path) ||
            (strcmp(s->before, s->after) == 0 && !other_defaults(s, section)) || !*s->after ||
            (node >= 0 && said_by_list(s, node, key[i])))
            continue;
        thud_text_append(lines, "%*s%s: ", indent, "", key[i]);
        thud_emit_value(lines, path, s->after, false);
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
    if (section.group == THUD_GROUP_STRUCTURE || section.group == THUD_GROUP_INTERFACE ||
        section.group == THUD_GROUP_LINK)
        thud_emit_item(&emit, s->now, section, 0);
    else {
        thud_text_append(&text, "{");
        thud_emit_section(&emit, s->now, section, 0, false);
        thud_text_append(&text, "}");
    }
    replace(s, node, &text);
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

static void save_structure(struct saving *s, int i, int node)
{
    struct thud_section section = {THUD_GROUP_STRUCTURE, i};
    for (int k = 0; k < THUD_NESTED_GROUPS; k++) {
        enum thud_group group = thud_nested_group(k);
        bool had = thud_yaml_find(&s->preset->tree, node, thud_group_key(group), NULL) >= 0;
        if (node_at(s, node)->flow && had != thud_structure_has_group(&s->now->structure[i], group)) {
            rewrite_flow(s, section, node);
            return;
        }
    }
    if (!save_section(s, section, node))
        return;
    for (int k = 0; k < THUD_NESTED_GROUPS; k++) {
        enum thud_group group = thud_nested_group(k);
        int key = -1, value = thud_yaml_find(&s->preset->tree, node, thud_group_key(group), &key);
        bool now = thud_structure_has_group(&s->now->structure[i], group);
        if (value >= 0 && now)
            save_section(s, (struct thud_section){group, i}, value);
        else if (value >= 0)
            delete_key(s, key);
        else if (now)
            append_nested(s, group, i, node);
    }
}

static void save_interface(struct saving *s, int i, int node)
{
    struct thud_section section = {THUD_GROUP_INTERFACE, i};
    int key = -1, contact = thud_yaml_find(&s->preset->tree, node, "contact", NULL);
    int bumper = thud_yaml_find(&s->preset->tree, node, "bumper", &key);
    bool now = thud_interface_says_bumper(&s->now->interface[i]);
    const struct thud_law_choice *is = &s->now->interface[i].contact;
    struct thud_law_choice was = s->preset->scene.interface[i].contact;
    was.assumed = is->assumed;
    bool changed = contact < 0 && memcmp(&was, is, sizeof was) != 0; /* no law was given */
    if (node_at(s, node)->flow && ((bumper >= 0) != now || changed)) {
        rewrite_flow(s, section, node);
        return;
    }
    if (!save_section(s, section, node))
        return;
    if (contact >= 0)
        save_section(s, (struct thud_section){THUD_GROUP_CONTACT, i}, contact);
    else if (changed)
        append_nested(s, THUD_GROUP_CONTACT, i, node);
    if (bumper >= 0 && now)
        save_section(s, (struct thud_section){THUD_GROUP_BUMPER, i}, bumper);
    else if (bumper >= 0)
        delete_key(s, key);
    else if (now)
        append_nested(s, THUD_GROUP_BUMPER, i, node);
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
        replace(s, list, &text);
    } else if (n > 0)
        thud_patch_add(s->patches, node_at(s, list)->start, next_line(s, node_at(s, list)->end), &text);
}

static void save_all(struct saving *s)
{
    const struct thud_scene *was = &s->preset->scene;
    int structures = thud_yaml_find(&s->preset->tree, 0, "structures", NULL);
    int interfaces = thud_yaml_find(&s->preset->tree, 0, "interfaces", NULL);
    save_section(s, (struct thud_section){THUD_GROUP_SCENE, 0}, 0);
    save_group(s, THUD_GROUP_RECORD);
    if (was->nstructures != s->now->nstructures) {
        save_list(s, THUD_GROUP_STRUCTURE, s->now->nstructures);
        save_list(s, THUD_GROUP_INTERFACE, s->now->nstructures - 1);
    } else {
        for (int i = 0; i < was->nstructures; i++)
            save_structure(s, i, thud_yaml_child(&s->preset->tree, structures, i));
        for (int i = 0; i + 1 < was->nstructures; i++)
            save_interface(s, i, thud_yaml_child(&s->preset->tree, interfaces, i));
    }
    if (was->nlinks != s->now->nlinks)
        save_list(s, THUD_GROUP_LINK, s->now->nlinks);
    for (int i = 0; i < was->nlinks && was->nlinks == s->now->nlinks; i++)
        save_section(s, (struct thud_section){THUD_GROUP_LINK, i},
                     thud_yaml_child(&s->preset->tree, thud_yaml_find(&s->preset->tree, 0, "links", NULL), i));
    save_group(s, THUD_GROUP_ANALYSIS);
    save_group(s, THUD_GROUP_STUDY);
    save_group(s, THUD_GROUP_DOCUMENT);
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
