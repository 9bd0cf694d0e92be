/* Links of a scene: their laws, their ends, and what they must have. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/scan.h"
#include "base/text.h"
#include "study/scene/level.h"
#include "study/scene/scene_slot.h"
#include "study/scene/scene_words.h"

void thud_link_init(struct thud_link *link, enum thud_link_law law)
{
    memset(link, 0, sizeof *link);
    link->law = law;
    link->stiffness_npm = law == THUD_LINK_DASHPOT ? 0 : NAN;
    link->damping_nspm = law == THUD_LINK_DASHPOT ? NAN : 0;
    link->slip_n = law == THUD_LINK_FRICTION ? NAN : 0;
}

int thud_link_wall(const struct thud_scene *scene, int i)
{
    const int last = scene->nstructures - 1;
    if (i < scene->nlinks)
        return -1;
    return i == scene->nlinks && thud_wall_has_backfill(&scene->structure[0]) ? 0 : last;
}

void thud_link_name(const struct thud_scene *scene, int i, char *text, unsigned long size)
{
    if (i < scene->nlinks)
        snprintf(text, size, "%s-%s", scene->link[i].from, scene->link[i].to);
    else
        snprintf(text, size, "%s-ground", scene->structure[thud_link_wall(scene, i)].name);
}

const char *thud_link_law_name(const struct thud_scene *scene, int i)
{
    return i < scene->nlinks ? thud_group_param(THUD_GROUP_LINK, 0)->choices[(int)scene->link[i].law]
                             : thud_law_backfill.name;
}

void thud_link_remove(struct thud_scene *scene, int i)
{
    memmove(&scene->link[i], &scene->link[i + 1], (size_t)(scene->nlinks - i - 1) * sizeof *scene->link);
    memset(&scene->link[--scene->nlinks], 0, sizeof *scene->link);
}

/* A link with another law keeps its ends, and what that law has too. */
static void change_law(struct thud_link *link, enum thud_link_law law)
{
    const struct thud_link before = *link;
    const struct thud_place *place;
    thud_link_init(link, law);
    for (int i = 1; (place = thud_group_place(THUD_GROUP_LINK, i)); i++) {
        if (place->store == THUD_STORE_TEXT)
            memcpy((char *)link + place->offset, (const char *)&before + place->offset, place->size);
        else if (thud_link_has((enum thud_link_law)before.law, i) && thud_link_has(law, i))
            memcpy((char *)link + place->offset, (const char *)&before + place->offset, sizeof(double));
    }
}

enum thud_status thud_link_law_set(struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                                   struct thud_error *err)
{
    struct thud_words words = {0};
    if (!*text) {
        if (slot->link < scene->nlinks)
            thud_link_remove(scene, slot->link);
        return THUD_OK;
    }
    int law = thud_param_choice(slot->param, text);
    for (int i = 0; slot->param->choices[i]; i++)
        thud_words_add(&words, slot->param->choices[i]);
    if (law < 0)
        return thud_words_unknown(&words, "law", text, err);
    if (slot->link == scene->nlinks)
        thud_link_init(&scene->link[scene->nlinks++], (enum thud_link_law)law);
    else if (law != (int)scene->link[slot->link].law)
        change_law(&scene->link[slot->link], (enum thud_link_law)law);
    return THUD_OK;
}

static enum thud_status no_structure(const struct thud_scene *scene, const char *end, struct thud_error *err)
{
    char names[160] = "";
    for (int s = 0; s < scene->nstructures; s++)
        thud_append(names, sizeof names, "%s%.20s", s ? ", " : "", scene->structure[s].name);
    thud_error_set(err, THUD_INPUT, "there is no structure \"%.*s\"", 60, end);
    thud_error_allow(err, "%s, and the floor: %.20s.1", names, scene->structure[0].name);
    return THUD_INPUT;
}

static int find_name(const struct thud_scene *scene, const char *name, size_t length)
{
    for (int s = 0; s < scene->nstructures; s++)
        if (strlen(scene->structure[s].name) == length && memcmp(scene->structure[s].name, name, length) == 0)
            return s;
    return -1;
}

enum thud_status thud_link_end(const struct thud_scene *scene, const char *end, int *structure, int *floor,
                               struct thud_error *err)
{
    const char *dot = strrchr(end, '.'), *count = dot ? dot + 1 : "";
    int floors;
    if (!*end) {
        thud_error_set(err, THUD_INPUT, "the end is not given");
        thud_error_allow(err, "a floor, e.g. %.20s.1", scene->structure[0].name);
        return THUD_INPUT;
    }
    *floor = 0;
    *structure = find_name(scene, end, strlen(end));
    if (*structure >= 0) { /* the name alone */
        floors = thud_structure_floors(&scene->structure[*structure]);
        *floor = floors;
        if (floors <= 1)
            return THUD_OK;
        thud_error_set(err, THUD_INPUT, "the floor of %.40s is not specified", end);
        thud_error_allow(err, "%.40s.1 to %.40s.%d", end, end, floors);
        return THUD_INPUT;
    }
    *structure = dot ? find_name(scene, end, (size_t)(dot - end)) : -1;
    if (*structure < 0)
        return no_structure(scene, end, err);
    floors = thud_structure_floors(&scene->structure[*structure]);
    if (thud_scan_count(&count, floor) && !*count && *floor > 0 && *floor <= floors)
        return THUD_OK;
    thud_error_set(err, THUD_INPUT, "%.40s has no floor \"%.20s\"", scene->structure[*structure].name, dot + 1);
    if (floors > 0)
        thud_error_allow(err, "1 to %d", floors);
    else
        thud_error_allow(err, "the name of the wall alone");
    return THUD_INPUT;
}

static enum thud_status check_ends(const struct thud_scene *scene, int i, struct thud_error *err)
{
    const char *const end[] = {scene->link[i].from, scene->link[i].to};
    static const char *const word[] = {"from", "to"};
    int structure[2] = {0}, floor[2] = {0};
    char key[32];
    for (int side = 0; side < 2; side++) {
        enum thud_status status = thud_link_end(scene, end[side], &structure[side], &floor[side], err);
        snprintf(key, sizeof key, "links.%d.%s", i + 1, word[side]);
        thud_error_key(err, "%s", key);
        if (status != THUD_OK)
            return status;
    }
    const int apart = structure[1] - structure[0];
    if (apart == 1 || apart == -1) {
        if (floor[0] > 0 || floor[1] > 0)
            return THUD_OK;
        thud_error_set(err, THUD_INPUT, "both ends move with the ground");
    } else if (apart == 0) {
        thud_error_set(err, THUD_INPUT, floor[0] == floor[1] ? "the link ties %s to itself" : "both ends are of %s",
                       floor[0] == floor[1] ? end[1] : scene->structure[structure[0]].name);
    } else {
        thud_error_set(err, THUD_INPUT, "%s and %s are no neighbours", end[0], end[1]);
    }
    thud_error_key(err, "%s", key);
    thud_error_allow(err, "a floor of the neighbour");
    return THUD_INPUT;
}

bool thud_link_stands(const struct thud_scene *scene, int i)
{
    return check_ends(scene, i, NULL) == THUD_OK;
}

int thud_link_interface(const struct thud_scene *scene, int i)
{
    int from, to, floor;
    if (!thud_link_stands(scene, i))
        return -1;
    thud_link_end(scene, scene->link[i].from, &from, &floor, NULL);
    thud_link_end(scene, scene->link[i].to, &to, &floor, NULL);
    return from < to ? from : to;
}

void thud_links_rename(struct thud_scene *scene, const char *before, const char *now)
{
    const size_t n = strlen(before);
    for (int i = 0; i < 2 * scene->nlinks; i++) {
        char *end = i % 2 ? scene->link[i / 2].to : scene->link[i / 2].from, floor[sizeof scene->link->to];
        if (strncmp(end, before, n) != 0 || (end[n] && (end[n] != '.' || strchr(end + n + 1, '.'))))
            continue;
        snprintf(floor, sizeof floor, "%s", end + n);
        memset(end, 0, sizeof scene->link->to);
        snprintf(end, sizeof scene->link->to, "%.*s%.*s", THUD_NAME_MAX, now, 7, floor);
    }
}

static enum thud_status check_values(const struct thud_scene *scene, int i, struct thud_error *err)
{
    const struct thud_link *link = &scene->link[i];
    char key[32];
    snprintf(key, sizeof key, "links.%d", i + 1);
    if ((int)link->law >= THUD_LINK_FRICTION && link->stiffness_npm == 0) {
        thud_error_set(err, THUD_INPUT, "it holds nothing with a stiffness of 0");
        return thud_scene_refuse(err, "> 0 MN/m", "%s.stiffness", key);
    }
    return thud_group_check(link, THUD_GROUP_LINK, (unsigned)link->law, 0, true, key, err);
}

/* Each time it slips the other way its ends have moved by twice this: a run's events stay countable. */
static enum thud_status check_slip(const struct thud_scene *scene, int i, struct thud_error *err)
{
    static const double least_m = 1e-6;
    const struct thud_link *link = &scene->link[i];
    if (link->law != THUD_LINK_FRICTION || link->slip_n >= least_m * link->stiffness_npm)
        return THUD_OK;
    thud_error_set(err, THUD_INPUT, "friction gives by only %.3g um before it slips",
                   1e6 * link->slip_n / link->stiffness_npm);
    thud_error_allow(err, "1 um or more, a slip force of at least %.4g kN or a smaller stiffness",
                     1e-3 * least_m * link->stiffness_npm);
    thud_error_key(err, "links.%d.slip", i + 1);
    return THUD_INPUT;
}

enum thud_status thud_links_check(const struct thud_scene *scene, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < scene->nlinks && status == THUD_OK; i++) {
        status = check_ends(scene, i, err);
        if (status == THUD_OK)
            status = check_values(scene, i, err);
        if (status == THUD_OK)
            status = check_slip(scene, i, err);
    }
    return status;
}
