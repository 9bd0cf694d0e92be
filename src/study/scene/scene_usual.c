/* Usual values for what belongs together in a structure. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "base/scan.h"
#include "study/scene/building.h"
#include "study/scene/scene.h"

const char *const thud_usual_wall[][2] = {{"mass", "27 t"}, {"stiffness", "40 MN/m"}, {"damping", "5 %"}, {NULL}};
const char *const thud_usual_backfill[][2] = {
    {"stiffness", "304.5 MN/m"}, {"strength", "4890 kN"}, {"ratio", "0.7"}, {NULL}};

void thud_usual_bearings(enum thud_isolator_law law, double all_kg, struct thud_usual out[THUD_USUAL_BEARINGS])
{
    static const double period_s = 2.5, ratio = 0.05;
    const double omega = 2 * THUD_PI / period_s;
    memset(out, 0, THUD_USUAL_BEARINGS * sizeof *out);
    if (law == THUD_ISOLATOR_LINEAR) {
        out[0].key = "isolation-stiffness";
        snprintf(out[0].value, sizeof out[0].value, "%.4g MN/m", 1e-6 * all_kg * omega * omega);
    } else if (law == THUD_ISOLATOR_PENDULUM) {
        out[0] = (struct thud_usual){"isolator.law", "pendulum"};
        out[1].key = "isolator.radius";
        snprintf(out[1].value, sizeof out[1].value, "%.2f m", THUD_GRAVITY / (omega * omega));
        out[2] = (struct thud_usual){"isolator.friction", "5 %"};
    } else {
        out[0] = (struct thud_usual){"isolator.law", "lead-rubber"};
        out[1].key = "isolator.strength";
        snprintf(out[1].value, sizeof out[1].value, "%.4g kN", 1e-3 * ratio * all_kg * THUD_GRAVITY);
        out[2].key = "isolator.post-yield";
        snprintf(out[2].value, sizeof out[2].value, "%.4g MN/m", 1e-6 * all_kg * omega * omega);
        out[3] = (struct thud_usual){"isolator.yield", "10 mm"};
    }
}

static void set(struct thud_scene *scene, int s, const char *prefix, const char *key, const char *value)
{
    char path[THUD_VARY_KEY];
    snprintf(path, sizeof path, "structures.%d.%s%s", s, prefix, key);
    thud_scene_set(scene, path, value, NULL);
}

static void set_each(struct thud_scene *scene, int s, const char *prefix, const char *const values[][2])
{
    for (int i = 0; values[i][0]; i++)
        set(scene, s, prefix, values[i][0], values[i][1]);
}

static void clear_group(struct thud_scene *scene, int s, enum thud_group group, const char *prefix)
{
    const struct thud_param *param;
    for (int i = 0; (param = thud_group_param(group, i)); i++)
        set(scene, s, prefix, param->name, "");
}

/* Without the mass there is no foundation. */
static void set_foundation(struct thud_scene *scene, int s, const char *name, const char *text)
{
    static const char *const usual[][2] = {{"vs", "250 m/s"}, {"density", "1.9 t/m3"}, {"radius", "9 m"}, {NULL}};
    const bool there = thud_structure_on_soil(&scene->structure[s - 1]);
    char mass[64];
    snprintf(mass, sizeof mass, "%.17g kg", scene->structure[s - 1].mass_kg[0]);
    if (there && !*text && strcmp(name, "mass") == 0)
        clear_group(scene, s, THUD_GROUP_FOUNDATION, "foundation.");
    else if (!there && *text) {
        set(scene, s, "foundation.", "mass", mass);
        set_each(scene, s, "foundation.", usual);
    }
}

static void set_wall(struct thud_scene *scene, int s, const char *name, const char *text)
{
    const struct thud_structure *structure = &scene->structure[s - 1];
    const bool of_soil = thud_scan_word(&name, "backfill."), mass = strcmp(name, "mass") == 0;
    if (!*text && (mass || (of_soil && (strcmp(name, "stiffness") == 0 || strcmp(name, "strength") == 0))))
        clear_group(scene, s, THUD_GROUP_BACKFILL, "backfill.");
    for (int i = 0; !*text && mass && thud_usual_wall[i][0]; i++)
        set(scene, s, "", thud_usual_wall[i][0], "");
    if (*text && !thud_wall_gives(structure) &&
        (of_soil || mass || strcmp(name, "stiffness") == 0 || strcmp(name, "damping") == 0))
        set_each(scene, s, "", thud_usual_wall);
    if (*text && of_soil && !thud_wall_has_backfill(structure))
        set_each(scene, s, "backfill.", thud_usual_backfill);
}

static void set_isolators(struct thud_scene *scene, int s, const char *text)
{
    const struct thud_structure *structure = &scene->structure[s - 1];
    struct thud_usual usual[THUD_USUAL_BEARINGS];
    double all_kg = structure->base_mass_kg;
    for (int i = 0; i < structure->storeys; i++)
        all_kg += structure->mass_kg[i];
    clear_group(scene, s, THUD_GROUP_ISOLATOR, "isolator.");
    set(scene, s, "", "isolation-stiffness", "");
    for (enum thud_isolator_law law = THUD_ISOLATOR_LINEAR; law <= THUD_ISOLATOR_PENDULUM; law++)
        if (strcmp(text, thud_isolator_name(law)) == 0) {
            thud_usual_bearings(law, all_kg, usual);
            for (int i = 0; i < THUD_USUAL_BEARINGS && usual[i].key; i++)
                set(scene, s, "", usual[i].key, usual[i].value);
        }
}

void thud_usual_link(struct thud_link *link)
{
    link->stiffness_npm = isnan(link->stiffness_npm) ? 5e8 : link->stiffness_npm;
    link->damping_nspm = isnan(link->damping_nspm) ? 1e6 : link->damping_nspm;
    link->slip_n = isnan(link->slip_n) ? 5e5 : link->slip_n;
}

void thud_usual_set(struct thud_scene *scene, const char *key, const char *text)
{
    const char *law = key;
    int s = 0, i = 0;
    if (thud_scan_word(&law, "links.") && thud_scan_count(&law, &i) && strcmp(law, ".law") == 0 && i > 0 &&
        i <= scene->nlinks && *text &&
        thud_scene_set(scene, key, text, NULL) == THUD_OK) /* the law's own values are there only with it */
        thud_usual_link(&scene->link[i - 1]);
    if (!thud_scan_word(&key, "structures.") || !thud_scan_count(&key, &s) || s < 1 || s > scene->nstructures ||
        !thud_scan_word(&key, "."))
        return;
    const enum thud_structure_kind kind = scene->structure[s - 1].kind;
    if (kind == THUD_WALL)
        set_wall(scene, s, key, text);
    else if (kind == THUD_ISOLATED && strcmp(key, "isolator.law") == 0)
        set_isolators(scene, s, text);
    else if (thud_kind_is_building(kind) && thud_scan_word(&key, "foundation."))
        set_foundation(scene, s, key, text);
}
