/* From the tree of a preset to its scene. Values are set in an order in which each finds what it depends on: kind
 * before lists, laws before their parameters, exponents before stiffnesses, the study last. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/scan.h"
#include "io/building/building_file.h"
#include "io/preset/preset_private.h"
#include "study/suite/fragility.h"

enum { PATH_BYTES = 128, KEY_BYTES = 60 };

/* Completes an error with the place of a node. */
static enum thud_status place_at_node(const struct thud_preset *preset, int node, enum thud_status status,
                                      struct thud_error *err)
{
    const struct thud_yaml_node *n = &preset->tree.node[node];
    thud_error_place(err, preset->name, n->line, n->column);
    return status;
}

static enum thud_status refuse(const struct thud_preset *preset, int node, const char *path, const char *what,
                               const char *allowed, struct thud_error *err)
{
    thud_error_set(err, THUD_INPUT, "%s", what);
    thud_error_key(err, "%s", path);
    if (allowed)
        thud_error_allow(err, "%s", allowed);
    return place_at_node(preset, node, THUD_INPUT, err);
}

static enum thud_yaml_kind kind_of(const struct thud_preset *preset, int node)
{
    return preset->tree.node[node].kind;
}

/* ---- one value ---- */

static enum thud_status set_text(struct thud_preset *preset, const char *path, int node, const char *text,
                                 struct thud_error *err)
{
    enum thud_status status = thud_scene_set(&preset->scene, path, text, err);
    if (status == THUD_OK)
        status = thud_words_check(&preset->scene, err);
    return status == THUD_OK ? THUD_OK : place_at_node(preset, node, status, err);
}

static enum thud_status set_scalar(struct thud_preset *preset, const char *path, int node, struct thud_error *err)
{
    const struct thud_yaml_node *n = &preset->tree.node[node];
    const char *text = thud_yaml_text(&preset->tree, node);
    if (strlen(text) + 1 > THUD_PRESET_VALUE_MAX)
        return refuse(preset, node, path, "the text is too long", NULL, err);
    if (n->length == 0 && !n->quoted)
        return refuse(preset, node, path, "nothing is given", "a value, or omit the key", err);
    int floor;
    const struct thud_param *param = thud_scene_param(&preset->scene, path, &floor);
    if (text[0] == '[' && param && param->kind != THUD_PARAM_TEXT)
        return refuse(preset, node, path, "a list must not be quoted", NULL, err);
    return set_text(preset, path, node, text, err);
}

/* The structure's floors one by one, so that a message shows the very value. */
static enum thud_status set_floors(struct thud_preset *preset, const char *path, int node, int storeys,
                                   struct thud_error *err)
{
    int n = preset->tree.node[node].children, floor = 0;
    if (n != storeys) {
        char what[96], allowed[96];
        snprintf(what, sizeof what, "the list has %d value%s, the structure has %d storey%s", n, n == 1 ? "" : "s",
                 storeys, storeys == 1 ? "" : "s");
        snprintf(allowed, sizeof allowed, "one value for every floor, or %d from the lowest up", storeys);
        return refuse(preset, node, path, what, allowed, err);
    }
    for (int i = preset->tree.node[node].first; i >= 0; i = preset->tree.node[i].next) {
        char item[PATH_BYTES + 16];
        snprintf(item, sizeof item, "%s.%d", path, ++floor);
        if (kind_of(preset, i) != THUD_YAML_SCALAR)
            return refuse(preset, i, item, "a list or keys are given where one value is expected", "e.g. 320 t", err);
        enum thud_status status = set_scalar(preset, item, i, err);
        if (status != THUD_OK)
            return status;
    }
    return THUD_OK;
}

struct joined {
    char text[2000];
    size_t n; /* what it would be where it is too long */
};

static void join(struct joined *to, const char *text)
{
    if (to->n < sizeof to->text)
        snprintf(to->text + to->n, sizeof to->text - to->n, "%s", text);
    to->n += strlen(text);
}

/* "[a, b]" of the scalars of a list, and of lists within it down to this depth. */
static enum thud_status join_list(struct thud_preset *preset, const char *path, int node, int depth, struct joined *to,
                                  struct thud_error *err)
{
    join(to, "[");
    if (preset->tree.node[node].children == 0)
        return refuse(preset, node, path, "the list is empty", NULL, err);
    for (int i = preset->tree.node[node].first; i >= 0; i = preset->tree.node[i].next) {
        enum thud_status status = THUD_OK;
        join(to, i == preset->tree.node[node].first ? "" : ", ");
        if (depth > 1 && kind_of(preset, i) == THUD_YAML_LIST)
            status = join_list(preset, path, i, depth - 1, to, err);
        else if (kind_of(preset, i) != THUD_YAML_SCALAR)
            return refuse(preset, i, path, "a list or keys are given where one value is expected", NULL, err);
        else if (strpbrk(thud_yaml_text(&preset->tree, i), ",[]"))
            return refuse(preset, i, path, "a comma or a bracket inside a value", NULL, err);
        else
            join(to, thud_yaml_text(&preset->tree, i));
        if (status != THUD_OK)
            return status;
    }
    join(to, "]");
    return THUD_OK;
}

static enum thud_status set_joined(struct thud_preset *preset, const char *path, int node, struct thud_error *err)
{
    struct joined list = {.n = 0};
    enum thud_status status = join_list(preset, path, node, strcmp(path, "study.values") == 0 ? 2 : 1, &list, err);
    if (status == THUD_OK && list.n >= sizeof list.text)
        return refuse(preset, node, path, "the list is too long", NULL, err);
    return status == THUD_OK ? set_text(preset, path, node, list.text, err) : status;
}

/* "drift:1 %, force:5 MN" of keys with their values. */
static enum thud_status set_pairs(struct thud_preset *preset, const char *path, int node, struct thud_error *err)
{
    const struct thud_yaml *tree = &preset->tree;
    struct joined pairs = {.n = 0};
    for (int i = tree->node[node].first; i >= 0; i = tree->node[tree->node[i].next].next) {
        const int value = tree->node[i].next;
        if (kind_of(preset, value) != THUD_YAML_SCALAR)
            return refuse(preset, value, path, "a list or keys are given where one value is expected", NULL, err);
        join(&pairs, pairs.n > 0 ? ", " : "");
        join(&pairs, thud_yaml_text(tree, i));
        join(&pairs, ":");
        join(&pairs, thud_yaml_text(tree, value));
    }
    return pairs.n >= sizeof pairs.text ? refuse(preset, node, path, "it is too long", NULL, err)
                                        : set_text(preset, path, node, pairs.text, err);
}

static enum thud_status set_value(struct thud_preset *preset, const char *path, int node, struct thud_error *err)
{
    int floor, structure;
    const char *at = path;
    const struct thud_param *param = thud_scene_param(&preset->scene, path, &floor);
    bool floors = thud_scene_by_floor(&preset->scene, path);
    switch (kind_of(preset, node)) {
    case THUD_YAML_SCALAR:
        return set_scalar(preset, path, node, err);
    case THUD_YAML_LIST:
        if (param && (strncmp(path, "study.", 6) == 0 || strstr(path, "-level")))
            return set_joined(preset, path, node, err);
        if (floors && thud_scan_word(&at, "structures.") && thud_scan_count(&at, &structure))
            return set_floors(preset, path, node, preset->scene.structure[structure - 1].storeys, err);
        return refuse(preset, node, path, "a list is given where one value is expected", NULL, err);
    case THUD_YAML_KEYS:
        if (strcmp(path, "document.limits") == 0)
            return set_pairs(preset, path, node, err);
        break;
    }
    return refuse(preset, node, path, "keys are given where a value is expected", NULL, err);
}

/* ---- keys ---- */

static enum thud_status want_kind(const struct thud_preset *preset, int node, const char *path,
                                  enum thud_yaml_kind kind, struct thud_error *err)
{
    if (kind_of(preset, node) == kind)
        return THUD_OK;
    return refuse(preset, node, path,
                  kind == THUD_YAML_KEYS ? "keys with values are expected here"
                                         : "a list is expected here, one item after each dash",
                  NULL, err);
}

/* Sets the keys of a node from one rank to another, in the order of the file where the rank is the same. Keys that are
 * groups are left out; those of ranks before `from` are set already. Unknown keys are found on the way. */
static enum thud_status set_ranks(struct thud_preset *preset, int node, enum thud_group group, const char *path,
                                  int from, int to, struct thud_error *err)
{
    const struct thud_yaml *tree = &preset->tree;
    enum thud_status status = want_kind(preset, node, path, THUD_YAML_KEYS, err);
    for (int rank = from; rank <= to && status == THUD_OK; rank++)
        for (int i = tree->node[node].first; i >= 0 && status == THUD_OK; i = tree->node[tree->node[i].next].next) {
            const char *key = thud_yaml_text(tree, i);
            char full[PATH_BYTES + KEY_BYTES + 2], unused[8];
            int floor;
            if (strlen(key) > KEY_BYTES || strchr(key, '.'))
                return refuse(preset, i, path, "presets have no such key", NULL, err);
            const int own = thud_key_rank(key, strlen(key));
            if ((own < from ? from : own) != rank || thud_group_find(group, key) != THUD_GROUPS)
                continue;
            snprintf(full, sizeof full, "%s%s%.*s", path, *path ? "." : "", KEY_BYTES, key);
            if (!thud_scene_param(&preset->scene, full, &floor)) {
                thud_scene_get(&preset->scene, full, unused, sizeof unused, err); /* says what is wrong with the key */
                return place_at_node(preset, i, THUD_INPUT, err);
            }
            status = own < from ? THUD_OK : set_value(preset, full, tree->node[i].next, err);
        }
    return status;
}

static enum thud_status set_keys(struct thud_preset *preset, int node, enum thud_group group, const char *path,
                                 int from, struct thud_error *err)
{
    return set_ranks(preset, node, group, path, from, THUD_RANK_LAST, err);
}

/* ---- structures ---- */

int thud_preset_storeys(const struct thud_yaml *tree, int structure)
{
    static const char *const lists[] = {"mass", "stiffness", "height"};
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++) {
        const int value = thud_yaml_find(tree, structure, lists[i], NULL);
        if (value >= 0 && tree->node[value].kind == THUD_YAML_LIST)
            return value;
    }
    return -1;
}

/* `storeys`, or as many as the first list has values. */
static enum thud_status set_storeys(struct thud_preset *preset, int node, const char *path, struct thud_error *err)
{
    char full[PATH_BYTES + 16], count[16];
    snprintf(full, sizeof full, "%s.storeys", path);
    int value = thud_yaml_find(&preset->tree, node, "storeys", NULL);
    if (value >= 0)
        return set_value(preset, full, value, err);
    value = thud_preset_storeys(&preset->tree, node);
    if (value < 0)
        return refuse(preset, node, full, "storeys is not given",
                      "a number, or a list of masses, stiffnesses or heights", err);
    snprintf(count, sizeof count, "%d", preset->tree.node[value].children);
    return set_text(preset, full, value, count, err);
}

/* Masses that stand beside area and load have to be those: as a result's own scene has them. */
static enum thud_status set_determined(struct thud_preset *preset, int s, int node, const char *path,
                                       struct thud_error *err)
{
    const struct thud_structure *structure = &preset->scene.structure[s];
    double mass_kg[THUD_STOREYS_MAX];
    char full[PATH_BYTES + 8];
    memcpy(mass_kg, structure->mass_kg, sizeof mass_kg);
    enum thud_status status = set_keys(preset, node, THUD_GROUP_STRUCTURE, path, THUD_RANK_LAST, err);
    const int given = thud_yaml_find(&preset->tree, node, "mass", NULL);
    snprintf(full, sizeof full, "%s.mass", path);
    for (int i = 0; i < structure->storeys && given >= 0 && status == THUD_OK; i++)
        if (fabs(structure->mass_kg[i] - mass_kg[i]) > 1e-6 * mass_kg[i])
            return refuse(preset, given, full, "area and load give another mass", "mass, or area and load", err);
    return status;
}

static enum thud_status walk_structure(struct thud_preset *preset, int s, int node, struct thud_error *err)
{
    struct thud_structure *structure = &preset->scene.structure[s];
    char path[PATH_BYTES], full[PATH_BYTES + 8];
    snprintf(path, sizeof path, "structures.%d", s + 1);
    snprintf(full, sizeof full, "%s.kind", path);
    thud_structure_init(structure, THUD_SHEAR);
    enum thud_status status = want_kind(preset, node, path, THUD_YAML_KEYS, err);
    int kind = status == THUD_OK ? thud_yaml_find(&preset->tree, node, "kind", NULL) : -1;
    if (kind >= 0)
        status = set_value(preset, full, kind, err);
    if (status != THUD_OK)
        return status;
    thud_structure_init(structure, structure->kind);
    if (thud_kind_is_building(structure->kind))
        status = set_storeys(preset, node, path, err);
    if (status == THUD_OK)
        status = set_ranks(preset, node, THUD_GROUP_STRUCTURE, path, THUD_RANK_STOREYS + 1, THUD_RANK_USUAL, err);
    if (status == THUD_OK)
        status = set_determined(preset, s, node, path, err);
    for (int i = 0; i < THUD_NESTED_GROUPS && status == THUD_OK; i++) {
        const char *group = thud_group_key(thud_nested_group(i));
        int nested = thud_yaml_find(&preset->tree, node, group, NULL);
        snprintf(path, sizeof path, "structures.%d.%s", s + 1, group);
        if (nested >= 0 && kind_of(preset, nested) == THUD_YAML_KEYS && preset->tree.node[nested].first < 0)
            return refuse(preset, nested, path, "it is empty", "a key with its value; or omit it", err);
        status = nested >= 0 ? set_keys(preset, nested, thud_nested_group(i), path, 0, err) : status;
    }
    return status;
}

/* A, B, ... by place, or the first letter that is free. */
static void name_structure(struct thud_scene *scene, int s)
{
    for (int try = 0; try < 27 && !scene->structure[s].name[0]; try++) {
        char letter = (char)('A' + (try == 0 ? s % 26 : try - 1));
        bool taken = false;
        for (int i = 0; i < scene->nstructures; i++)
            taken = taken || (scene->structure[i].name[0] == letter && scene->structure[i].name[1] == '\0');
        if (!taken)
            scene->structure[s].name[0] = letter;
    }
}

static enum thud_status walk_structures(struct thud_preset *preset, int root, struct thud_error *err)
{
    int list = thud_yaml_find(&preset->tree, root, "structures", NULL);
    if (list < 0)
        return refuse(preset, root, "structures", "there is no structure", "a list of 1 to 20", err);
    enum thud_status status = want_kind(preset, list, "structures", THUD_YAML_LIST, err);
    if (status != THUD_OK)
        return status;
    int n = preset->tree.node[list].children;
    if (n < 1 || n > THUD_STRUCTURES_MAX)
        return refuse(preset, list, "structures", n < 1 ? "there is no structure" : "there are too many structures",
                      "a list of 1 to 20", err);
    preset->scene.nstructures = n;
    for (int s = 0; s < n && status == THUD_OK; s++)
        status = walk_structure(preset, s, thud_yaml_child(&preset->tree, list, s), err);
    for (int s = 0; s < n && status == THUD_OK; s++)
        name_structure(&preset->scene, s);
    return status;
}

/* ---- interfaces ---- */

/* The law gets its own defaults, whatever stood there before. A contact without one keeps that of thud_interface_init,
 * the paper's. */
static enum thud_status walk_law(struct thud_preset *preset, struct thud_interface *interface, bool bumper,
                                 const char *path, int node, struct thud_error *err)
{
    struct thud_law_choice *choice = bumper ? &interface->bumper : &interface->contact;
    char full[PATH_BYTES + 8];
    snprintf(full, sizeof full, "%s.law", path);
    enum thud_status status = want_kind(preset, node, path, THUD_YAML_KEYS, err);
    if (status != THUD_OK)
        return status;
    int law = thud_yaml_find(&preset->tree, node, "law", NULL);
    if (law < 0 && bumper) { /* what its other keys are called depends on it */
        interface->has_bumper = true;
        interface->bumper_thickness_m = NAN;
        if (!preset->unfinished.what[0])
            refuse(preset, node, full, "the impact law is not given", "one of `thud laws`", &preset->unfinished);
        return THUD_OK;
    }
    choice->assumed = law < 0;
    if (law >= 0) {
        status = set_value(preset, full, law, err);
        if (status != THUD_OK)
            return status;
        thud_law_choice_init(choice, choice->law);
    }
    if (bumper) {
        interface->bumper_thickness_m = NAN;
        interface->bumper_cavity_m = 0;
    }
    return set_keys(preset, node, bumper ? THUD_GROUP_BUMPER : THUD_GROUP_CONTACT, path, 2, err); /* but the law */
}

static enum thud_status walk_interface(struct thud_preset *preset, int i, int node, struct thud_error *err)
{
    struct thud_interface *interface = &preset->scene.interface[i];
    char path[32], full[PATH_BYTES];
    snprintf(path, sizeof path, "interfaces.%d", i + 1);
    thud_interface_init(interface);
    interface->gap_m = NAN;
    interface->contact.assumed = true;
    enum thud_status status = set_keys(preset, node, THUD_GROUP_INTERFACE, path, 0, err);
    for (int bumper = 0; bumper < 2 && status == THUD_OK; bumper++) {
        const char *key = thud_group_key(bumper ? THUD_GROUP_BUMPER : THUD_GROUP_CONTACT);
        const int law = thud_yaml_find(&preset->tree, node, key, NULL);
        snprintf(full, sizeof full, "%s.%s", path, key);
        if (law >= 0)
            status = walk_law(preset, interface, bumper, full, law, err);
    }
    return status;
}

static enum thud_status walk_interfaces(struct thud_preset *preset, int root, struct thud_error *err)
{
    int list = thud_yaml_find(&preset->tree, root, "interfaces", NULL), wanted = preset->scene.nstructures - 1;
    char what[128];
    enum thud_status status = list >= 0 ? want_kind(preset, list, "interfaces", THUD_YAML_LIST, err) : THUD_OK;
    int n = list >= 0 && status == THUD_OK ? preset->tree.node[list].children : 0;
    if (status == THUD_OK && n != wanted) {
        snprintf(what, sizeof what, "%d structure%s %d interface%s, not %d", wanted + 1, wanted ? "s need" : " needs",
                 wanted, wanted == 1 ? "" : "s", n);
        status = refuse(preset, list >= 0 ? list : root, "interfaces", what, "one between each two neighbours", err);
    }
    for (int i = 0; i < n && status == THUD_OK; i++)
        status = walk_interface(preset, i, thud_yaml_child(&preset->tree, list, i), err);
    return status;
}

/* ---- links ---- */

/* The law first: what else may be said depends on it. */
static enum thud_status walk_links(struct thud_preset *preset, int root, struct thud_error *err)
{
    int list = thud_yaml_find(&preset->tree, root, "links", NULL);
    enum thud_status status = list >= 0 ? want_kind(preset, list, "links", THUD_YAML_LIST, err) : THUD_OK;
    int n = list >= 0 && status == THUD_OK ? preset->tree.node[list].children : 0;
    if (n > THUD_LINKS_MAX)
        return refuse(preset, list, "links", "there are too many links", "up to 32", err);
    for (int i = 0; i < n && status == THUD_OK; i++) {
        int node = thud_yaml_child(&preset->tree, list, i);
        char path[PATH_BYTES], full[PATH_BYTES + 8];
        snprintf(path, sizeof path, "links.%d", i + 1);
        snprintf(full, sizeof full, "%s.law", path);
        status = want_kind(preset, node, path, THUD_YAML_KEYS, err);
        int law = status == THUD_OK ? thud_yaml_find(&preset->tree, node, "law", NULL) : -1;
        if (status == THUD_OK && law < 0)
            return refuse(preset, node, full, "the law of the link is not given", "spring, dashpot, restrainer, strut",
                          err);
        if (status == THUD_OK)
            status = set_value(preset, full, law, err);
        if (status == THUD_OK)
            status = set_keys(preset, node, THUD_GROUP_LINK, path, 2, err);
    }
    return status;
}

/* ---- the rest ---- */

/* What only a bumper lacks is kept for who asks for none. */
static enum thud_status check_scene(struct thud_preset *preset, struct thud_error *err)
{
    struct thud_error why = {0};
    bool had[THUD_STRUCTURES_MAX - 1];
    enum thud_status status = thud_scene_check(&preset->scene, &why);
    if (status == THUD_OK)
        return THUD_OK;
    place_at_node(preset, thud_preset_node(preset, why.key), status, &why);
    for (int i = 0; i < THUD_STRUCTURES_MAX - 1; i++) {
        had[i] = preset->scene.interface[i].has_bumper;
        preset->scene.interface[i].has_bumper = false;
    }
    bool bare = thud_scene_check(&preset->scene, NULL) == THUD_OK;
    for (int i = 0; i < THUD_STRUCTURES_MAX - 1; i++)
        preset->scene.interface[i].has_bumper = had[i];
    if (bare && !preset->unfinished.what[0])
        preset->unfinished = why;
    else if (!bare && err)
        *err = why;
    return bare ? THUD_OK : status;
}

enum thud_status thud_preset_walk(struct thud_preset *preset, struct thud_error *err)
{
    enum thud_status status = set_keys(preset, 0, THUD_GROUP_SCENE, "", 0, err);
    for (enum thud_group group = 0; group < THUD_GROUPS && status == THUD_OK; group++) {
        const int node = thud_yaml_find(&preset->tree, 0, thud_group_key(group), NULL);
        if (group == THUD_GROUP_STRUCTURE)
            status = walk_structures(preset, 0, err);
        else if (group == THUD_GROUP_INTERFACE)
            status = walk_interfaces(preset, 0, err);
        else if (group == THUD_GROUP_LINK)
            status = walk_links(preset, 0, err);
        else if (thud_group_base(group) > 0 && node >= 0)
            status = set_keys(preset, node, group, thud_group_key(group), 0, err);
    }
    if (status == THUD_OK) {
        status = thud_building_files_read(&preset->scene, preset->name, err);
        if (status != THUD_OK && err && !err->file[0])
            place_at_node(preset, thud_preset_node(preset, err->key), status, err);
    }
    return status == THUD_OK ? check_scene(preset, err) : status;
}

int thud_preset_node(const struct thud_preset *preset, const char *path)
{
    int node = 0;
    char part[PATH_BYTES];
    while (*path) {
        size_t length = strcspn(path, ".");
        snprintf(part, sizeof part, "%.*s", (int)length, path);
        int next = preset->tree.node[node].kind == THUD_YAML_KEYS ? thud_yaml_find(&preset->tree, node, part, NULL)
                   : preset->tree.node[node].kind == THUD_YAML_LIST
                       ? thud_yaml_child(&preset->tree, node, (int)strtol(part, NULL, 10) - 1)
                       : -1;
        if (next < 0)
            break;
        node = next;
        path += length + (path[length] == '.');
    }
    return node;
}
