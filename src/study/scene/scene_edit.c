#include "study/scene/scene_edit.h"

#include <stdio.h>
#include <string.h>

#include "base/scan.h"
#include "base/text.h"
#include "study/scene/building.h"
#include "study/scene/level.h"

static void drop_loose_links(struct thud_scene *scene)
{
    for (int i = scene->nlinks - 1; i >= 0; i--)
        if (!thud_link_stands(scene, i))
            thud_link_remove(scene, i);
}

static void move_floors(struct thud_structure *structure, int to, int from, int n)
{
    for (int i = 0; i < THUD_STRUCTURE_LISTS; i++) {
        double *list = thud_structure_list(structure, i);
        memmove(list + to, list + from, (size_t)n * sizeof *list);
    }
}

/* The structure of a number that has storeys; NULL: it has none. */
static struct thud_structure *building(struct thud_scene *scene, int number)
{
    struct thud_structure *s = number >= 1 && number <= scene->nstructures ? &scene->structure[number - 1] : NULL;
    return s && thud_kind_is_building(s->kind) ? s : NULL;
}

/* Each edit returns false where the scene has no such numbers. */
static bool add_storey(struct thud_scene *scene, int number, int floor, char *what, size_t size)
{
    struct thud_structure *s = building(scene, number);
    if (!s || s->storeys >= THUD_STOREYS_MAX || floor > s->storeys)
        return false;
    if (floor < 1)
        floor = s->storeys;
    move_floors(s, floor, floor - 1, s->storeys - floor + 1);
    s->storeys++;
    thud_structure_fill_estimate(s);
    snprintf(what, size, "%s: storey added above floor %d, like it", s->name, floor);
    return true;
}

static bool delete_storey(struct thud_scene *scene, int number, int floor, char *what, size_t size)
{
    struct thud_structure *s = building(scene, number);
    if (!s || s->storeys < 2 || floor < 1 || floor > s->storeys)
        return false;
    move_floors(s, floor - 1, floor, s->storeys - floor);
    s->storeys--;
    drop_loose_links(scene);
    /* what lies past the top is zero in every scene, so that equal scenes compare equal */
    for (int i = 0; i < THUD_STRUCTURE_LISTS; i++)
        thud_structure_list(s, i)[s->storeys] = 0.0;
    thud_structure_fill_estimate(s);
    snprintf(what, size, "%s: storey %d deleted", s->name, floor);
    return true;
}

/* The first letter no structure is called by; empty: all are. */
static void new_name(const struct thud_scene *scene, char name[THUD_NAME_MAX])
{
    memset(name, 0, THUD_NAME_MAX);
    for (char letter = 'A'; letter <= 'Z' && !*name; letter++) {
        bool taken = false;
        for (int i = 0; i < scene->nstructures; i++)
            taken = taken || (scene->structure[i].name[0] == letter && scene->structure[i].name[1] == '\0');
        name[0] = taken ? '\0' : letter;
    }
}

/* With more than one interface, keys of the study that stood for the only one have to say so. True: some had to. */
static bool rename_varied(struct thud_scene *scene)
{
    static const char only[] = "interfaces.1.";
    bool renamed = false;
    for (int i = 0; i < scene->study.nvary; i++) {
        char *key = scene->study.vary[i].key, whole[THUD_VARY_KEY + sizeof only] = "";
        int floor;
        snprintf(whole, sizeof whole, "%s%s", only, key);
        if (thud_scene_param(scene, key, &floor) || !thud_scene_param(scene, whole, &floor) ||
            strlen(whole) >= THUD_VARY_KEY)
            continue;
        memcpy(key, whole, strlen(whole) + 1);
        renamed = true;
    }
    return renamed;
}

static bool add_structure(struct thud_scene *scene, int number, int unused, char *what, size_t size)
{
    char name[THUD_NAME_MAX];
    const int n = scene->nstructures, s = number - 1, from = s < n - 1 ? s : n - 2;
    (void)unused;
    if (s < 0 || s >= n || n == THUD_STRUCTURES_MAX)
        return false;
    new_name(scene, name);
    memmove(&scene->structure[s + 1], &scene->structure[s], (size_t)(n - s) * sizeof *scene->structure);
    if (from >= 0)
        memmove(&scene->interface[from + 1], &scene->interface[from],
                (size_t)(n - 1 - from) * sizeof *scene->interface);
    memcpy(scene->structure[s + 1].name, name, sizeof name);
    scene->nstructures++;
    drop_loose_links(scene);
    snprintf(what, size, "%s added to the right of %s, like it%s", name, scene->structure[s].name,
             rename_varied(scene) ? "; the study varies interfaces.1" : "");
    return true;
}

static bool remove_structure(struct thud_scene *scene, int number, int unused, char *what, size_t size)
{
    const int n = scene->nstructures, s = number - 1, gone = s < n - 1 ? s : n - 2;
    (void)unused;
    if (s < 0 || s >= n || n < 3)
        return false;
    snprintf(what, size, "%s removed", scene->structure[s].name);
    memmove(&scene->structure[s], &scene->structure[s + 1], (size_t)(n - 1 - s) * sizeof *scene->structure);
    memmove(&scene->interface[gone], &scene->interface[gone + 1], (size_t)(n - 2 - gone) * sizeof *scene->interface);
    memset(&scene->structure[n - 1], 0, sizeof *scene->structure);
    memset(&scene->interface[n - 2], 0, sizeof *scene->interface);
    scene->nstructures--;
    drop_loose_links(scene);
    return true;
}

static bool has_interface(const struct thud_scene *scene, int number)
{
    return number >= 1 && number < scene->nstructures;
}

static bool swap(struct thud_scene *scene, int number, int unused, char *what, size_t size)
{
    (void)unused;
    if (!has_interface(scene, number))
        return false;
    struct thud_structure *left = &scene->structure[number - 1], *right = left + 1, kept = *left;
    *left = *right;
    *right = kept;
    drop_loose_links(scene);
    snprintf(what, size, "%s and %s swapped", right->name, left->name);
    return true;
}

static bool toggle_bumper(struct thud_scene *scene, int number, int unused, char *what, size_t size)
{
    (void)unused;
    if (!has_interface(scene, number))
        return false;
    struct thud_interface *interface = &scene->interface[number - 1];
    interface->has_bumper = !interface->has_bumper;
    if (interface->has_bumper && !interface->bumper.law) /* there has been none yet: the paper's */
        thud_interface_add_bumper(interface);
    snprintf(what, size, "bumper %s", interface->has_bumper ? "off -> on" : "on -> off");
    return true;
}

/* An end of a new link: the floor of a building, or a body or wall by its name. */
static void name_end(const struct thud_structure *structure, int floor, char end[THUD_NAME_MAX + 8])
{
    char name[THUD_NAME_MAX];
    memcpy(name, structure->name, sizeof name);
    if (thud_structure_floors(structure) > 1)
        snprintf(end, THUD_NAME_MAX + 8, "%s.%d", name, floor);
    else
        snprintf(end, THUD_NAME_MAX + 8, "%s", name);
}

/* Between the highest floors that can touch; where none do, between those of the same number. */
static bool add_link(struct thud_scene *scene, int number, int unused, char *what, size_t size)
{
    (void)unused;
    if (!has_interface(scene, number) || scene->nlinks == THUD_LINKS_MAX)
        return false;
    const struct thud_structure *left = &scene->structure[number - 1], *right = left + 1;
    struct thud_contact_pair pair[THUD_CONTACT_PAIRS_MAX];
    int a = thud_structure_floors(left), b = thud_structure_floors(right);
    const int n = thud_interface_contact_pairs(scene, number - 1, pair);
    if (a > 1 && b > 1)
        a = b = a < b ? a : b;
    for (int i = 0; i < n; i++)
        if (pair[i].struck == 0)
            a = pair[i].left_floor, b = pair[i].right_floor;
    struct thud_link *link = &scene->link[scene->nlinks++];
    thud_link_init(link, THUD_LINK_DASHPOT);
    thud_usual_link(link);
    name_end(left, a, link->from);
    name_end(right, b, link->to);
    snprintf(what, size, "a dashpot ties %s and %s", link->from, link->to);
    return true;
}

static bool remove_link(struct thud_scene *scene, int number, int unused, char *what, size_t size)
{
    (void)unused;
    if (number < 1 || number > scene->nlinks)
        return false;
    snprintf(what, size, "the link of %s and %s is gone", scene->link[number - 1].from, scene->link[number - 1].to);
    thud_link_remove(scene, number - 1);
    return true;
}

/* The numbers after the words of an edit, as many as it has; false: something else stands there. */
static bool read_numbers(const char *at, const char *numbers, int *number, int *floor)
{
    int *const to[] = {number, floor};
    const int n = strchr(numbers, ' ') ? 2 : 1;
    for (int i = 0; i < n && *at == ' '; i++) {
        at += strspn(at, " ");
        if (*at && !thud_scan_count(&at, to[i]))
            return false;
    }
    return !at[strspn(at, " ")];
}

enum thud_status thud_scene_edit(struct thud_scene *scene, const char *words, char *what, size_t size,
                                 struct thud_error *err)
{
    static const struct {
        const char *words, *numbers;
        bool (*edit)(struct thud_scene *scene, int number, int floor, char *what, size_t size);
    } table[] = {{"storey add", "STRUCTURE FLOOR", add_storey},
                 {"storey delete", "STRUCTURE FLOOR", delete_storey},
                 {"structure add", "STRUCTURE", add_structure},
                 {"structure remove", "STRUCTURE", remove_structure},
                 {"swap", "STRUCTURE", swap},
                 {"bumper", "[INTERFACE]", toggle_bumper},
                 {"link add", "INTERFACE", add_link},
                 {"link remove", "LINK", remove_link}};
    char forms[300] = "";
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        const char *at = words;
        int number = *table[i].numbers == '[', floor = 0;
        if (!thud_scan_word(&at, table[i].words)) {
            thud_append(forms, sizeof forms, "%s%s %s", i ? ", " : "", table[i].words, table[i].numbers);
            continue;
        }
        return read_numbers(at, table[i].numbers, &number, &floor) && table[i].edit(scene, number, floor, what, size)
                   ? THUD_OK
                   : thud_error_set(err, THUD_USAGE, "%.60s: %s %s, counted from 1, that the scene has", words,
                                    table[i].words, table[i].numbers);
    }
    return thud_error_refuse(err, THUD_USAGE, NULL, forms, "\"%.60s\" is not a valid edit", words);
}
