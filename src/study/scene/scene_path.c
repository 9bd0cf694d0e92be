/* From a path to the place of its value. */
#include <stdlib.h>
#include <string.h>

#include "base/scan.h"
#include "study/scene/scene_slot.h"
#include "study/scene/scene_words.h"

enum { PARTS_MAX = 6, PATH_BYTES = 128 };

struct path {
    char text[PATH_BYTES];
    char *part[PARTS_MAX];
    int n;
};

static bool split(const char *text, struct path *path)
{
    if (strlen(text) >= sizeof path->text)
        return false;
    strcpy(path->text, text);
    path->n = 0;
    for (char *next = path->text; next;) {
        if (path->n == PARTS_MAX)
            return false;
        path->part[path->n++] = next;
        next = strchr(next, '.');
        if (next)
            *next++ = '\0';
    }
    return true;
}

/* A number counted from 1; -1 when it is none. */
static int number(const char *text)
{
    int count;
    return thud_scan_count(&text, &count) && !*text ? count : -1;
}

static int find_in_group(enum thud_group group, const char *key, unsigned kinds)
{
    const struct thud_param *param;
    for (int i = 0; (param = thud_group_param(group, i)); i++)
        if (strcmp(param->name, key) == 0 && (!kinds || (thud_group_place(group, i)->kinds & kinds)))
            return i;
    return -1;
}

/* item: the structure or the link, from 0. */
static enum thud_status unknown(const struct thud_scene *scene, enum thud_group group, const struct thud_law *law,
                                int item, const char *key, struct thud_error *err)
{
    struct thud_words words = {0};
    const struct thud_param *param;
    for (int i = 0; (param = thud_group_param(group, i)); i++)
        if ((group != THUD_GROUP_STRUCTURE || thud_structure_has(scene->structure[item].kind, i)) &&
            (group != THUD_GROUP_LINK || thud_link_has((enum thud_link_law)scene->link[item].law, i)))
            thud_words_add(&words, param->name);
    for (enum thud_group g = THUD_GROUP_SCENE + 1; g < THUD_GROUPS; g++)
        if (thud_group_in(g) == group &&
            (group != THUD_GROUP_STRUCTURE || thud_group_place(g, 0)->kinds & 1u << scene->structure[item].kind))
            thud_words_add(&words, thud_group_key(g));
    for (int i = 0; law && i < law->nparams; i++)
        thud_words_add(&words, law->params[i].name);
    return thud_words_unknown(&words, "key", key, err);
}

static void fill(struct thud_slot *slot, enum thud_group group, int index, size_t base)
{
    slot->param = thud_group_param(group, index);
    slot->place = *thud_group_place(group, index);
    slot->place.offset += base;
    slot->index = index;
}

static enum thud_status wrong_depth(struct thud_error *err)
{
    return thud_error_refuse(
        err, THUD_INPUT, NULL,
        "e.g. gap, contact.restitution, structures.1.mass, structures.1.mass.2, interfaces.1.gap, record.peak",
        "the key has too many or too few parts");
}

static enum thud_status refuse_group(enum thud_group group, struct thud_error *err)
{
    thud_error_set(err, THUD_INPUT, "it has keys of its own, and no value");
    thud_error_allow(err, "%s.%s and others", thud_group_key(group), thud_group_param(group, 0)->name);
    return THUD_INPUT;
}

/* What is counted from 1 has no such number. */
static enum thud_status no_such(const char *what, const char *part, int most, struct thud_error *err)
{
    thud_error_set(err, THUD_INPUT, "there is no %s \"%.40s\"", what, part);
    if (most > 0)
        thud_error_allow(err, "1 to %d", most);
    return THUD_INPUT;
}

static enum thud_status find_structure(const struct thud_scene *scene, char **part, int n, struct thud_slot *out,
                                       struct thud_error *err)
{
    enum thud_group group = n > 1 ? thud_group_find(THUD_GROUP_STRUCTURE, part[1]) : THUD_GROUPS;
    if (group == THUD_GROUPS)
        group = THUD_GROUP_STRUCTURE;
    if (n == 2 && group != THUD_GROUP_STRUCTURE)
        return refuse_group(group, err);
    const bool column = group == THUD_GROUP_COLUMN, isolator = group == THUD_GROUP_ISOLATOR,
               soil = group == THUD_GROUP_FOUNDATION, backfill = group == THUD_GROUP_BACKFILL;
    if (n < 2 || n > 3 + column)
        return wrong_depth(err);
    int s = number(part[0]);
    if (s < 1 || s > scene->nstructures)
        return no_such("structure", part[0], scene->nstructures, err);
    if (isolator && scene->structure[s - 1].kind != THUD_ISOLATED)
        return thud_error_refuse(err, THUD_INPUT, NULL, "kind: isolated", "%.40s stands on no isolators",
                                 scene->structure[s - 1].name);
    if (backfill && scene->structure[s - 1].kind != THUD_WALL)
        return thud_error_refuse(err, THUD_INPUT, NULL, "kind: wall", "%.40s is no wall that soil could stand behind",
                                 scene->structure[s - 1].name);
    int keys = group == THUD_GROUP_STRUCTURE ? 1 : 2,
        i = find_in_group(group, part[keys], 1u << scene->structure[s - 1].kind);
    int of_storeys = i < 0 ? find_in_group(group, part[keys], 1u << THUD_SHEAR) : -1;
    if (of_storeys >= 0 && (column || soil || thud_group_place(group, of_storeys)->optional)) {
        static const char *const what[THUD_KINDS] = {[THUD_WALL] = "a wall",
                                                     [THUD_RIGID] = "a rigid body",
                                                     [THUD_MATRIX] = "a building by its matrix",
                                                     [THUD_MODES] = "a building by its modes",
                                                     [THUD_ESTIMATED] = "an estimated building"};
        const bool yields = strncmp(part[keys], "yield", 5) == 0 || strcmp(part[keys], "hardening") == 0;
        thud_error_set(err, THUD_INPUT, "%s has no %s", what[scene->structure[s - 1].kind],
                       column   ? "columns"
                       : soil   ? "foundation"
                       : yields ? "storeys that could yield"
                                : "storeys");
        thud_error_allow(err, column || soil ? "%.40s is of buildings" : "%.40s is of shear and isolated structures",
                         part[keys]);
        return THUD_INPUT;
    }
    if (i < 0)
        return unknown(scene, group, NULL, s - 1, part[keys], err);
    fill(out, group, i, offsetof(struct thud_scene, structure) + (size_t)(s - 1) * sizeof *scene->structure);
    out->structure = s - 1;
    if (n == keys + 1)
        return THUD_OK;
    int storeys = scene->structure[s - 1].storeys, floor = number(part[keys + 1]);
    if (out->place.store != THUD_STORE_FLOORS)
        return wrong_depth(err);
    if (floor < 1 || floor > storeys)
        return no_such("floor", part[keys + 1], storeys, err);
    out->floor = floor - 1;
    return THUD_OK;
}

/* Keys of contact or bumper: the group's, then the law's own. */
static enum thud_status find_law_key(const struct thud_scene *scene, int interface, bool bumper, const char *key,
                                     struct thud_slot *out, struct thud_error *err)
{
    enum thud_group group = bumper ? THUD_GROUP_BUMPER : THUD_GROUP_CONTACT;
    const struct thud_interface *at = &scene->interface[interface];
    const struct thud_law *law = bumper ? at->bumper.law : at->contact.law;
    size_t base = offsetof(struct thud_scene, interface) + (size_t)interface * sizeof *at;
    out->bumper = bumper;
    out->choice = base + (bumper ? offsetof(struct thud_interface, bumper) : offsetof(struct thud_interface, contact));
    int i = find_in_group(group, key, 0);
    if (bumper && !law && i != 0)
        return thud_error_refuse(err, THUD_INPUT, NULL, "set bumper.law first, e.g. rubber",
                                 "interface %d has no bumper", interface + 1);
    if (i >= 0) {
        fill(out, group, i, base);
        return THUD_OK;
    }
    i = law ? thud_law_param(law, key) : -1;
    if (i < 0)
        return unknown(scene, group, law, 0, key, err);
    out->param = &law->params[i];
    out->index = i;
    out->place = (struct thud_place){.store = THUD_STORE_NUMBER,
                                     .offset = out->choice + offsetof(struct thud_law_choice, value) +
                                               (size_t)i * sizeof(double),
                                     .absent = THUD_REQUIRED};
    return THUD_OK;
}

static enum thud_status find_interface(const struct thud_scene *scene, int interface, char **part, int n,
                                       struct thud_slot *out, struct thud_error *err)
{
    out->interface = interface;
    bool bumper = strcmp(part[0], "bumper") == 0;
    if (bumper || strcmp(part[0], "contact") == 0)
        return n == 2 ? find_law_key(scene, interface, bumper, part[1], out, err) : wrong_depth(err);
    int i = find_in_group(THUD_GROUP_INTERFACE, part[0], 0);
    if (i < 0)
        return unknown(scene, THUD_GROUP_INTERFACE, NULL, 0, part[0], err);
    fill(out, THUD_GROUP_INTERFACE, i,
         offsetof(struct thud_scene, interface) + (size_t)interface * sizeof *scene->interface);
    return n == 1 ? THUD_OK : wrong_depth(err);
}

static enum thud_status find_numbered_interface(const struct thud_scene *scene, char **part, int n,
                                                struct thud_slot *out, struct thud_error *err)
{
    int i = n > 1 ? number(part[0]) : 0;
    if (n < 2)
        return wrong_depth(err);
    if (i < 1 || i >= scene->nstructures)
        return no_such("interface", part[0], scene->nstructures - 1, err);
    return find_interface(scene, i - 1, part + 1, n - 1, out, err);
}

/* `gap`, `contact.restitution`, `bumper.thickness`: where there is one interface. */
static enum thud_status find_short(const struct thud_scene *scene, struct path *path, struct thud_slot *out,
                                   struct thud_error *err)
{
    if (scene->nstructures == 2)
        return find_interface(scene, 0, path->part, path->n, out, err);
    thud_error_set(err, THUD_INPUT, "the scene has %d interfaces, so the key does not say which",
                   scene->nstructures > 0 ? scene->nstructures - 1 : 0);
    thud_error_allow(err, "interfaces.1.%s%s%s", path->part[0], path->n > 1 ? "." : "",
                     path->n > 1 ? path->part[1] : "");
    return THUD_INPUT;
}

/* The one after the last link is there to be added, by its law. */
static enum thud_status find_link(const struct thud_scene *scene, char **part, int n, struct thud_slot *out,
                                  struct thud_error *err)
{
    if (n != 2)
        return wrong_depth(err);
    int i = number(part[0]), more = scene->nlinks < THUD_LINKS_MAX && strcmp(part[1], "law") == 0;
    if (i < 1 || i > scene->nlinks + more) {
        no_such("link", part[0], scene->nlinks, err);
        if (i == scene->nlinks + 1 && scene->nlinks < THUD_LINKS_MAX)
            thud_error_allow(err, "set links.%d.law first, e.g. dashpot", i);
        return THUD_INPUT;
    }
    const unsigned law = i > scene->nlinks ? 0 : 1u << (int)scene->link[i - 1].law;
    int key = find_in_group(THUD_GROUP_LINK, part[1], law);
    if (key < 0)
        return unknown(scene, THUD_GROUP_LINK, NULL, i - 1, part[1], err);
    fill(out, THUD_GROUP_LINK, key, offsetof(struct thud_scene, link) + (size_t)(i - 1) * sizeof *scene->link);
    out->link = i - 1;
    return THUD_OK;
}

/* Of the scene, or short for those of its only interface. */
static enum thud_status unknown_top(const char *key, struct thud_error *err)
{
    static const enum thud_group top[] = {THUD_GROUP_SCENE, THUD_GROUP_INTERFACE};
    struct thud_words words = {0};
    const struct thud_param *param;
    for (size_t t = 0; t < sizeof top / sizeof *top; t++) {
        for (int i = 0; (param = thud_group_param(top[t], i)); i++)
            thud_words_add(&words, param->name);
        for (enum thud_group g = THUD_GROUP_SCENE + 1; g < THUD_GROUPS; g++)
            if (thud_group_in(g) == top[t])
                thud_words_add(&words, thud_group_key(g));
    }
    return thud_words_unknown(&words, "key", key, err);
}

static enum thud_status find(const struct thud_scene *scene, struct path *path, struct thud_slot *out,
                             struct thud_error *err)
{
    char **part = path->part;
    enum thud_group group = thud_group_find(THUD_GROUP_SCENE, part[0]);
    if (group == THUD_GROUP_STRUCTURE)
        return find_structure(scene, part + 1, path->n - 1, out, err);
    if (group == THUD_GROUP_INTERFACE)
        return find_numbered_interface(scene, part + 1, path->n - 1, out, err);
    if (group == THUD_GROUP_LINK)
        return find_link(scene, part + 1, path->n - 1, out, err);
    if (find_in_group(THUD_GROUP_INTERFACE, part[0], 0) >= 0 ||
        thud_group_find(THUD_GROUP_INTERFACE, part[0]) != THUD_GROUPS)
        return find_short(scene, path, out, err);
    const bool own = group == THUD_GROUPS; /* of the scene itself */
    if (path->n != 2 - own)
        return own ? unknown_top(part[0], err) : wrong_depth(err);
    group = own ? THUD_GROUP_SCENE : group;
    int i = find_in_group(group, part[path->n - 1], 0);
    if (i < 0)
        return own ? unknown_top(part[0], err) : unknown(scene, group, NULL, 0, part[1], err);
    fill(out, group, i, thud_group_base(group));
    return THUD_OK;
}

enum thud_status thud_slot_find(const struct thud_scene *scene, const char *path, struct thud_slot *out,
                                struct thud_error *err)
{
    struct path parts;
    *out = (struct thud_slot){.structure = -1, .interface = -1, .link = -1, .floor = -1};
    enum thud_status status = split(path, &parts) ? find(scene, &parts, out, err) : wrong_depth(err);
    if (status != THUD_OK)
        thud_error_key(err, "%s", path);
    return status;
}

int thud_key_rank(const char *name, unsigned long length)
{
    static const struct {
        const char *name;
        int rank;
    } known[] = {{"kind", 0},
                 {"law", 1},
                 {"vary", 2},
                 {"storeys", THUD_RANK_STOREYS},
                 {"exponent", 4},
                 {"period", THUD_RANK_LAST},
                 {"load", THUD_RANK_LAST}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (strlen(known[i].name) == length && strncmp(known[i].name, name, length) == 0)
            return known[i].rank;
    return THUD_RANK_USUAL;
}

bool thud_scene_by_floor(const struct thud_scene *scene, const char *path)
{
    struct thud_slot slot;
    if (thud_slot_find(scene, path, &slot, NULL) != THUD_OK || slot.place.store != THUD_STORE_FLOORS || slot.floor >= 0)
        return false;
    enum thud_structure_kind kind = scene->structure[slot.structure].kind;
    return thud_kind_is_building(kind);
}

bool thud_scene_is_words(const struct thud_scene *scene, const char *path)
{
    struct thud_slot slot;
    if (thud_slot_find(scene, path, &slot, NULL) != THUD_OK)
        return false;
    const size_t at = slot.place.offset;
    const bool name = slot.structure >= 0 && thud_slot_in(scene, &slot) == scene->structure[slot.structure].name;
    return name || strcmp(slot.param->name, "source") == 0 || at == offsetof(struct thud_scene, title) ||
           (at >= offsetof(struct thud_scene, study) && at < offsetof(struct thud_scene, nlinks));
}

const struct thud_param *thud_scene_param(const struct thud_scene *scene, const char *path, int *floor)
{
    struct thud_slot slot;
    if (thud_slot_find(scene, path, &slot, NULL) != THUD_OK)
        return NULL;
    *floor = slot.floor;
    return slot.param;
}
