#include "study/scene/level.h"

#include <math.h>
#include <stdio.h>

/* Floors closer in elevation than this stand at the same level; with what rounding makes of sums of heights. */
static const double same_level_m = 0.01 * (1 + 1e-9);

int thud_structure_floors(const struct thud_structure *s)
{
    switch (s->kind) {
    case THUD_SHEAR:
        return s->storeys;
    case THUD_ISOLATED:
        return s->storeys + 1;
    case THUD_RIGID:
        return 1;
    case THUD_WALL:
        break;
    }
    return 0;
}

double thud_structure_elevation(const struct thud_structure *s, int floor)
{
    if (!thud_kind_is_building(s->kind))
        return s->height_m[0];
    double level = s->base_m;
    for (int i = 0; i < floor + (s->kind == THUD_SHEAR); i++)
        level += s->height_m[i];
    return level;
}

/* One side of an interface: elevations of its floors. */
struct row {
    const struct thud_structure *structure;
    int n;
    bool alone; /* floors meet floors alone */
    double level_m[THUD_STOREYS_MAX + 1];
};

static void fill(struct row *row, const struct thud_structure *s)
{
    row->structure = s;
    row->n = thud_structure_floors(s);
    double level = s->base_m;
    for (int i = 0; i < row->n; i++) {
        if (i > 0 || s->kind == THUD_SHEAR)
            level += s->height_m[s->kind == THUD_SHEAR ? i : i - 1];
        row->level_m[i] = thud_kind_is_building(s->kind) ? level : s->height_m[0];
    }
}

static bool same_level(double a, double b)
{
    return fabs(a - b) <= same_level_m;
}

/* Index of the building's floor at this elevation; -1. */
static int floor_at(const struct row *row, double level)
{
    for (int i = 0; i < row->n; i++)
        if (same_level(row->level_m[i], level))
            return i;
    return -1;
}

/* Whether a slab at this elevation strikes columns of the building, and which: the floor above them (from 1). */
static bool strikes(const struct row *row, double level, int *floor, struct thud_pairing *out)
{
    double lower = row->structure->base_m;
    for (int i = 0; i < row->n && !row->alone; lower = row->level_m[i++])
        if (level > lower + same_level_m && level < row->level_m[i] - same_level_m) {
            *floor = i + 1;
            out->a_m = level - lower;
            out->b_m = row->level_m[i] - level;
            return true;
        }
    return false;
}

/* Building and wall: floors up to its top. */
static int meet_wall(const struct row *row, const struct thud_structure *wall, bool left, struct thud_pairing *out)
{
    int n = 0;
    for (int i = 0; i < row->n; i++)
        if (!(wall->height_m[0] < row->level_m[i] - same_level_m))
            out[n++] = left ? (struct thud_pairing){.left_floor = i + 1} : (struct thud_pairing){.right_floor = i + 1};
    return n;
}

/* Building and rigid body: without an elevation it meets the first floor. */
static int meet_body(const struct row *row, double level, bool left, struct thud_pairing *out)
{
    struct thud_pairing one = {0};
    int floor = isfinite(level) ? floor_at(row, level) + 1 : 1;
    if (floor == 0 && !strikes(row, level, &floor, &one))
        return 0;
    one.struck = one.a_m > 0 ? left ? -1 : 1 : 0;
    one.left_floor = left ? floor : 1;
    one.right_floor = left ? 1 : floor;
    *out = one;
    return 1;
}

/* In the order of the slabs' elevations, so that a mirrored scene has the same one. */
static int meet_building(const struct row *left, const struct row *right, struct thud_pairing *out)
{
    int n = 0;
    for (int i = 0, k = 0; i < left->n || k < right->n;) {
        bool of_left = k == right->n || (i < left->n && left->level_m[i] <= right->level_m[k] + same_level_m);
        struct thud_pairing one = {0};
        if (of_left) {
            one.left_floor = i + 1;
            one.right_floor = floor_at(right, left->level_m[i++]) + 1;
            if (one.right_floor == 0 && strikes(right, left->level_m[one.left_floor - 1], &one.right_floor, &one))
                one.struck = 1;
        } else if (floor_at(left, right->level_m[k++]) < 0) {
            one.right_floor = k;
            if (strikes(left, right->level_m[k - 1], &one.left_floor, &one))
                one.struck = -1;
        }
        if (one.left_floor > 0 && one.right_floor > 0)
            out[n++] = one;
    }
    return n;
}

int thud_interface_pairings(const struct thud_scene *scene, int interface, struct thud_pairing *out)
{
    struct row left, right;
    fill(&left, &scene->structure[interface]);
    fill(&right, &scene->structure[interface + 1]);
    left.alone = right.alone = scene->interface[interface].levels == THUD_LEVELS_ALIGNED;
    if (thud_kind_is_building(left.structure->kind) && thud_kind_is_building(right.structure->kind))
        return meet_building(&left, &right, out);
    if (!thud_kind_is_building(left.structure->kind) &&
        !thud_kind_is_building(right.structure->kind)) { /* two walls do not meet */
        *out = (struct thud_pairing){.left_floor = left.n, .right_floor = right.n};
        return left.n + right.n > 0;
    }
    bool building_left = thud_kind_is_building(left.structure->kind);
    const struct row *building = building_left ? &left : &right, *other = building_left ? &right : &left;
    if (other->structure->kind == THUD_WALL)
        return meet_wall(building, other->structure, building_left, out);
    return meet_body(building, other->structure->height_m[0], building_left, out);
}

bool thud_slab_is_left(int left_floor, int struck)
{
    return struck >= 0 && left_floor > 0;
}

int thud_slab_floor(int left_floor, int right_floor, int struck)
{
    return thud_slab_is_left(left_floor, struck) ? left_floor : right_floor;
}

const char *thud_struck_name(int struck)
{
    return struck < 0 ? "left" : struck > 0 ? "right" : "";
}

void thud_pairing_name(int left_floor, int right_floor, int struck, char *text, unsigned long size)
{
    char floor[2][16];
    for (int i = 0; i < 2; i++) {
        int n = i == 0 ? left_floor : right_floor;
        bool columns = struck == (i == 0 ? -1 : 1);
        if (n > 0)
            snprintf(floor[i], sizeof floor[i], "%s%d", columns ? "c" : "", n);
        else
            snprintf(floor[i], sizeof floor[i], "wall");
    }
    snprintf(text, size, "%s-%s", floor[0], floor[1]);
}
