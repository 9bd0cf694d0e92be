/* Gaps and bumpers of single levels of an interface: from text, to text, checked against what can meet there. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "base/text.h"
#include "study/scene/level.h"
#include "study/scene/scene_slot.h"
#include "study/scene/scene_words.h"

static const double rounding_m = 1e-12;

struct thud_level_values thud_interface_level(const struct thud_interface *at, int level)
{
    struct thud_level_values out = {.gap_m = at->gap_m, .has_bumper = at->has_bumper};
    if (level >= 0 && level < at->gap.n && !isnan(at->gap.value_m[level]))
        out.gap_m = at->gap.value_m[level];
    if (!at->has_bumper)
        return out;
    out.thickness_m = at->bumper_thickness_m;
    out.cavity_m = at->bumper_cavity_m;
    if (level >= 0 && level < at->thickness.n && !isnan(at->thickness.value_m[level])) {
        out.thickness_m = at->thickness.value_m[level];
        out.has_bumper = out.thickness_m > 0;
    }
    return out;
}

double thud_level_clearance(const struct thud_level_values *level)
{
    static const double picometres = 1e12;
    double clearance = level->gap_m, most = clearance;
    if (level->has_bumper) {
        clearance -= level->thickness_m - level->cavity_m;
        most += level->thickness_m;
    }
    /* 5 cm - (5 cm - 1 cm) may miss 1 cm by the last digit, and 0 by more of them: what can be a whole number of
     * picometres is one, so that the same clearance has the same bits however it came about */
    double whole = round(clearance * picometres) / picometres;
    if (fabs(clearance - whole) <= 4 * DBL_EPSILON * most || fabs(clearance) * picometres < 1)
        return whole;
    return clearance;
}

double thud_interface_clearance(const struct thud_interface *interface)
{
    const struct thud_level_values all = thud_interface_level(interface, -1);
    return thud_level_clearance(&all);
}

void thud_interface_gaps(const struct thud_interface *interface, double *least_m, double *most_m)
{
    *least_m = *most_m = thud_interface_level(interface, interface->gap.n > 0 ? 0 : -1).gap_m;
    for (int l = 0; l < interface->gap.n; l++) {
        const double gap = thud_interface_level(interface, l).gap_m;
        *least_m = fmin(*least_m, gap);
        *most_m = fmax(*most_m, gap);
    }
}

void thud_interface_thicknesses(const struct thud_interface *interface, double *least_m, double *most_m)
{
    *least_m = *most_m = thud_interface_level(interface, interface->thickness.n > 0 ? 0 : -1).thickness_m;
    for (int l = 1; l < interface->thickness.n; l++) {
        const double thickness = thud_interface_level(interface, l).thickness_m;
        *least_m = fmin(*least_m, thickness);
        *most_m = fmax(*most_m, thickness);
    }
}

double thud_interface_projection(const struct thud_interface *interface, double *least_m)
{
    double least, most;
    thud_interface_thicknesses(interface, &least, &most);
    if (least_m)
        *least_m = least > 0 ? least - interface->bumper_cavity_m : 0;
    return most > 0 ? most - interface->bumper_cavity_m : 0;
}

static void range_text(double least_m, double most_m, char *text, size_t size)
{
    if (most_m > least_m)
        snprintf(text, size, "%.4g to %.4g cm by level", 100 * least_m, 100 * most_m);
    else
        snprintf(text, size, "%.4g cm", 100 * least_m);
}

void thud_interface_gap_text(const struct thud_interface *interface, char *text, unsigned long size)
{
    double least, most;
    thud_interface_gaps(interface, &least, &most);
    range_text(least, most, text, size);
}

void thud_interface_thickness_text(const struct thud_interface *interface, char *text, unsigned long size)
{
    double least, most;
    thud_interface_thicknesses(interface, &least, &most);
    range_text(least, most, text, size);
}

void thud_interface_scale_gap(struct thud_interface *interface, double factor)
{
    for (int l = 0; l < interface->gap.n; l++) {
        const struct thud_level_values at = thud_interface_level(interface, l);
        if (!isnan(interface->gap.value_m[l]))
            interface->gap.value_m[l] = fmax(factor * at.gap_m, at.thickness_m - at.cavity_m);
    }
    interface->gap_m *= factor;
    if (interface->has_bumper)
        interface->gap_m = fmax(interface->gap_m, interface->bumper_thickness_m - interface->bumper_cavity_m);
}

enum thud_status thud_levels_set(struct thud_by_level *levels, const struct thud_param *param, const char *text,
                                 struct thud_error *err)
{
    struct thud_by_level out = {0};
    char copy[4096], *item[THUD_LEVELS_MAX] = {copy};
    snprintf(copy, sizeof copy, "%s", text);
    out.n = text[0] == '[' ? thud_list_split(copy, item, THUD_LEVELS_MAX) : 1;
    if (out.n < 1 || out.n > THUD_LEVELS_MAX || strlen(text) >= sizeof copy)
        return thud_error_refuse(err, THUD_INPUT, NULL, "[5 cm, none, 8 cm], from the lowest up",
                                 "that is no list of up to %d levels", THUD_LEVELS_MAX);
    for (int l = 0; l < out.n; l++) {
        out.value_m[l] = NAN;
        enum thud_status status = strcmp(item[l], THUD_FLOOR_NONE) == 0
                                      ? THUD_OK
                                      : thud_quantity_read(param, NULL, item[l], &out.value_m[l], err);
        if (status != THUD_OK)
            return status;
    }
    *levels = out;
    return THUD_OK;
}

void thud_levels_get(const struct thud_by_level *levels, const char *unit, char *text, size_t size)
{
    text[0] = '\0';
    for (int l = 0; l < levels->n; l++) {
        char item[96] = THUD_FLOOR_NONE;
        if (!isnan(levels->value_m[l]))
            thud_quantity_format(levels->value_m[l], unit, item, sizeof item);
        thud_append(text, size, "%s%s%s", l ? ", " : "[", item, l == levels->n - 1 ? "]" : "");
    }
}

static enum thud_status refuse(int interface, const char *key, struct thud_error *err)
{
    thud_error_key(err, "interfaces.%d.%s", interface + 1, key);
    return THUD_INPUT;
}

/* "1-1, 2-2, 3-c4" */
static void add_pairs(const struct thud_contact_pair *pair, int n, char *text, size_t size)
{
    text[0] = '\0';
    for (int i = 0; i < n; i++) {
        char name[24];
        thud_contact_pair_name(pair[i].left_floor, pair[i].right_floor, pair[i].struck, name, sizeof name);
        thud_append(text, size, "%s%s", i ? ", " : "", name);
    }
}

void thud_interface_clearance_text(const struct thud_scene *scene, int interface, char *text, size_t size)
{
    const struct thud_interface *at = &scene->interface[interface];
    struct thud_contact_pair pair[THUD_CONTACT_PAIRS_MAX];
    const bool by_level = at->gap.n > 0 || (at->has_bumper && at->thickness.n > 0);
    const int n = by_level ? thud_interface_contact_pairs(scene, interface, pair) : 0;
    *text = '\0';
    if (n == 0)
        snprintf(text, size, "%.4g cm", 100 * thud_interface_clearance(at));
    for (int l = 0, next; l < n; l = next) {
        const struct thud_level_values here = thud_interface_level(at, l);
        const double clearance = thud_level_clearance(&here);
        char first[24], last[24];
        for (next = l + 1; next < n; next++) {
            const struct thud_level_values above = thud_interface_level(at, next);
            if (thud_level_clearance(&above) != clearance)
                break;
        }
        thud_contact_pair_name(pair[l].left_floor, pair[l].right_floor, pair[l].struck, first, sizeof first);
        thud_contact_pair_name(pair[next - 1].left_floor, pair[next - 1].right_floor, pair[next - 1].struck, last,
                               sizeof last);
        thud_append(text, size, "%s%.4g cm at %s%s%s", l > 0 ? ", " : "", 100 * clearance, first,
                    next - l > 1 ? " to " : "", next - l > 1 ? last : "");
    }
}

/* Every floor of contact-levels meets something, and stands there once. */
static enum thud_status check_contact_levels(const struct thud_scene *scene, int interface, struct thud_error *err)
{
    const struct thud_by_level *list = &scene->interface[interface].contact_levels;
    struct thud_contact_pair pair[THUD_CONTACT_PAIRS_MAX];
    const int n = list->n > 0 ? thud_interface_contact_pairs(scene, interface, pair) : 0;
    for (int l = 0; l < list->n; l++) {
        bool meets = false;
        for (int i = 0; i < n; i++)
            meets = meets || list->value_m[l] == thud_contact_level(scene, interface, &pair[i]);
        for (int k = 0; k < l; k++)
            meets = meets && list->value_m[k] != list->value_m[l];
        if (meets)
            continue;
        thud_error_set(err, THUD_INPUT,
                       "%g names no floor that can meet the neighbour, or one that stands there already",
                       list->value_m[l]);
        thud_error_allow(err, "floors of the left building, of the right one beside a wall or a body, each once");
        return refuse(interface, "contact-levels", err);
    }
    return THUD_OK;
}

enum thud_status thud_levels_check(const struct thud_scene *scene, int interface, struct thud_error *err)
{
    const struct thud_interface *at = &scene->interface[interface];
    if (check_contact_levels(scene, interface, err) != THUD_OK)
        return THUD_INPUT;
    const struct thud_by_level *const list[] = {&at->gap, &at->thickness};
    static const char *const key[] = {"gap-by-level", "bumper.thickness-by-level"};
    struct thud_contact_pair pair[THUD_CONTACT_PAIRS_MAX];
    if (at->gap.n == 0 && at->thickness.n == 0)
        return THUD_OK;
    const int n = thud_interface_contact_pairs(scene, interface, pair);
    for (int k = 0; k < 2; k++) {
        char names[160];
        if (list[k]->n == 0 || list[k]->n == n)
            continue;
        add_pairs(pair, n, names, sizeof names);
        thud_error_set(err, THUD_INPUT, "the list has %d value%s, and %d pair%s can meet", list[k]->n,
                       list[k]->n == 1 ? "" : "s", n, n == 1 ? "" : "s");
        thud_error_allow(err, "from the lowest up: %s", names);
        return refuse(interface, key[k], err);
    }
    for (int l = 0; l < n && at->has_bumper; l++) {
        const struct thud_level_values v = thud_interface_level(at, l);
        const bool inside = v.thickness_m <= v.cavity_m;
        char out[48], gap[48], name[160];
        if (!v.has_bumper || (!inside && v.thickness_m - v.cavity_m <= v.gap_m + rounding_m))
            continue;
        add_pairs(&pair[l], 1, name, sizeof name);
        if (inside) {
            thud_quantity_format(v.thickness_m, "cm", out, sizeof out);
            thud_quantity_format(v.cavity_m, "cm", gap, sizeof gap);
            thud_error_set(err, THUD_INPUT, "the bumper at %s is %s thick, and its cavity %s deep", name, out, gap);
            thud_error_allow(err, "thicker than the cavity; 0 cm: no bumper there");
            return refuse(interface, key[at->thickness.n > 0], err);
        }
        thud_quantity_format(rint((v.thickness_m - v.cavity_m) * 1e9) / 1e9, "cm", out, sizeof out);
        thud_quantity_format(v.gap_m, "cm", gap, sizeof gap);
        thud_error_set(err, THUD_INPUT, "the bumper at %s projects by %s into a gap of %s", name, out, gap);
        thud_error_allow(err, "thickness - cavity <= gap");
        return refuse(interface, key[at->thickness.n > 0], err);
    }
    return THUD_OK;
}
