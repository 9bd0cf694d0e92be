#include "study/scene/level.h"

#include <math.h>
#include <stdio.h>

/* Floors closer in elevation than this stand at the same level; with what rounding makes of sums of heights. */
static const double same_level_m = 0.01 * (1 + 1e-9);
/* Faces that overlap by less only touch: rounding of sums of heights up to 4000 m. */
static const double rounding_m = 1e-9;

int thud_structure_floors(const struct thud_structure *s)
{
    switch (s->kind) {
    case THUD_SHEAR:
    case THUD_MATRIX:
    case THUD_MODES:
    case THUD_ESTIMATED:
        return s->storeys;
    case THUD_ISOLATED:
        return s->storeys + 1;
    case THUD_RIGID:
        return 1;
    case THUD_WALL:
        return thud_wall_gives(s);
    case THUD_KINDS:
        break;
    }
    return 0;
}

int thud_structure_first_storey(const struct thud_structure *structure)
{
    return thud_kind_is_building(structure->kind) ? structure->kind == THUD_ISOLATED : thud_structure_floors(structure);
}

int thud_structure_storey(const struct thud_structure *structure, int floor)
{
    return floor + (structure->kind != THUD_ISOLATED);
}

const char *thud_structure_level_name(const struct thud_structure *structure, int floor, bool storey, char text[24])
{
    if (structure->kind == THUD_ISOLATED && floor == 0)
        return storey ? "isolators" : "base slab";
    snprintf(text, 24, storey ? "storey %d" : "floor %d", storey ? thud_structure_storey(structure, floor) : floor + 1);
    return text;
}

double thud_structure_elevation(const struct thud_structure *s, int floor)
{
    if (!thud_kind_is_building(s->kind))
        return s->height_m[0];
    double level = s->base_m;
    for (int i = 0; i < floor + (s->kind != THUD_ISOLATED); i++)
        level += s->height_m[i];
    return level;
}

double thud_structure_depth(const struct thud_structure *s, int floor)
{
    int i = s->kind == THUD_ISOLATED && floor > 0 ? floor - 1 : floor;
    return thud_kind_is_building(s->kind) ? s->slab_depth_m[i] : 0;
}

double thud_face_overlap(double a, double a_depth, double b, double b_depth)
{
    return fmin(a, b) - fmax(a - a_depth, b - b_depth);
}

/* One side of an interface: elevations of its floors. */
struct row {
    const struct thud_structure *structure;
    int n;
    bool alone; /* floors meet floors alone */
    double level_m[THUD_STOREYS_MAX + 1], depth_m[THUD_STOREYS_MAX + 1];
};

static void fill(struct row *row, const struct thud_structure *s)
{
    row->structure = s;
    row->n = thud_structure_floors(s);
    double level = s->base_m;
    for (int i = 0; i < row->n; i++) {
        if (i > 0 || s->kind != THUD_ISOLATED)
            level += s->height_m[s->kind != THUD_ISOLATED ? i : i - 1];
        row->level_m[i] = thud_kind_is_building(s->kind) ? level : s->height_m[0];
        row->depth_m[i] = thud_structure_depth(s, i);
    }
}

/* Whether the middle of face a lies on face b, or within 1 cm of it: there it strikes no columns. */
static bool middle_on_face(double a, double a_depth, double b, double b_depth)
{
    const double middle = a - 0.5 * a_depth;
    return middle <= b + same_level_m && middle >= b - b_depth - same_level_m;
}

/* Whether faces that cover [z - depth, z] overlap; those meet too whose levels are within 1 cm, or one's middle of the
 * other, so that no slab passes between a neighbour's face and the columns beside it. */
static bool faces_meet(double a, double a_depth, double b, double b_depth)
{
    return fabs(a - b) <= same_level_m || (a - a_depth < b - rounding_m && b - b_depth < a - rounding_m) ||
           middle_on_face(a, a_depth, b, b_depth) || middle_on_face(b, b_depth, a, a_depth);
}

/* Whether what covers [level - depth, level] strikes columns of the building at its middle, and which: the floor above
 * them (from 1). The clear column ends under the face of that floor. */
static bool strikes(const struct row *row, double level, double depth, int *floor, struct thud_contact_pair *out)
{
    double lower = row->structure->base_m, middle = level - 0.5 * depth;
    for (int i = 0; i < row->n && !row->alone; lower = row->level_m[i++]) {
        double upper = row->level_m[i] - row->depth_m[i];
        if (middle > lower + same_level_m && middle < upper - same_level_m) {
            *floor = i + 1;
            out->a_m = middle - lower;
            out->b_m = upper - middle;
            return true;
        }
    }
    return false;
}

/* Building and wall: floors whose face begins below its top. */
static int meet_wall(const struct row *row, const struct thud_structure *wall, bool left, struct thud_contact_pair *out)
{
    int n = 0;
    for (int i = 0; i < row->n; i++) {
        double top = wall->height_m[0], level = row->level_m[i];
        if (!(top < level - same_level_m) || top > level - row->depth_m[i] + rounding_m)
            out[n++] = left ? (struct thud_contact_pair){.left_floor = i + 1, .right_floor = thud_wall_gives(wall)}
                            : (struct thud_contact_pair){.left_floor = thud_wall_gives(wall), .right_floor = i + 1};
    }
    return n;
}

/* Building and rigid body, which has no depth: without an elevation it meets the first floor. */
static int meet_body(const struct row *row, double level, bool left, struct thud_contact_pair *out)
{
    struct thud_contact_pair one = {0};
    int floor = isfinite(level) ? 0 : 1;
    for (int i = 0; i < row->n && floor == 0; i++)
        if (faces_meet(row->level_m[i], row->depth_m[i], level, 0))
            floor = i + 1;
    if (floor == 0 && !strikes(row, level, 0, &floor, &one))
        return 0;
    one.struck = one.a_m > 0 ? left ? -1 : 1 : 0;
    one.left_floor = left ? floor : 1;
    one.right_floor = left ? 1 : floor;
    *out = one;
    return 1;
}

/* Puts a contact behind those that stand no higher. */
static int insert(struct thud_contact_pair *out, double *level_m, int n, const struct thud_contact_pair *one,
                  double level)
{
    int at = n;
    for (; at > 0 && level_m[at - 1] > level + same_level_m; at--) {
        out[at] = out[at - 1];
        level_m[at] = level_m[at - 1];
    }
    out[at] = *one;
    level_m[at] = level;
    return n + 1;
}

/* Faces that overlap meet, each pair once; a face that overlaps none strikes columns. In the order of the lower slab's
 * elevation, so that a mirrored scene has the same one. */
static int meet_building(const struct row *left, const struct row *right, struct thud_contact_pair *out)
{
    double level_m[THUD_CONTACT_PAIRS_MAX];
    bool met[THUD_STOREYS_MAX + 1] = {false}; /* of the right one's floors */
    int n = 0;
    for (int i = 0, first = 0; i < left->n; i++) {
        bool meets = false;
        double level = left->level_m[i];
        while (first < right->n && right->level_m[first] < level - left->depth_m[i] - same_level_m)
            first++; /* stands below this face, and the next ones */
        for (int k = first; k < right->n && right->level_m[k] - right->depth_m[k] <= level + same_level_m; k++) {
            struct thud_contact_pair one = {.left_floor = i + 1, .right_floor = k + 1};
            if (!faces_meet(level, left->depth_m[i], right->level_m[k], right->depth_m[k]))
                continue;
            meets = met[k] = true;
            if (n < THUD_CONTACT_PAIRS_MAX)
                n = insert(out, level_m, n, &one, fmin(level, right->level_m[k]));
        }
        struct thud_contact_pair one = {.left_floor = i + 1, .struck = 1};
        if (!meets && n < THUD_CONTACT_PAIRS_MAX && strikes(right, level, left->depth_m[i], &one.right_floor, &one))
            n = insert(out, level_m, n, &one, level);
    }
    for (int k = 0; k < right->n; k++) {
        struct thud_contact_pair one = {.right_floor = k + 1, .struck = -1};
        if (!met[k] && n < THUD_CONTACT_PAIRS_MAX &&
            strikes(left, right->level_m[k], right->depth_m[k], &one.left_floor, &one))
            n = insert(out, level_m, n, &one, right->level_m[k]);
    }
    return n;
}

static int all_contact_pairs(const struct thud_scene *scene, int interface, struct thud_contact_pair *out)
{
    struct row left, right;
    fill(&left, &scene->structure[interface]);
    fill(&right, &scene->structure[interface + 1]);
    left.alone = right.alone = scene->interface[interface].levels == THUD_LEVELS_ALIGNED;
    if (thud_kind_is_building(left.structure->kind) && thud_kind_is_building(right.structure->kind))
        return meet_building(&left, &right, out);
    if (!thud_kind_is_building(left.structure->kind) &&
        !thud_kind_is_building(right.structure->kind)) { /* two walls do not meet */
        *out = (struct thud_contact_pair){.left_floor = left.n, .right_floor = right.n};
        return left.n + right.n > 0;
    }
    bool building_left = thud_kind_is_building(left.structure->kind);
    const struct row *building = building_left ? &left : &right, *other = building_left ? &right : &left;
    if (other->structure->kind == THUD_WALL)
        return meet_wall(building, other->structure, building_left, out);
    return meet_body(building, other->structure->height_m[0], building_left, out);
}

int thud_contact_level(const struct thud_scene *scene, int interface, const struct thud_contact_pair *pair)
{
    return thud_kind_is_building(scene->structure[interface].kind) ? pair->left_floor : pair->right_floor;
}

int thud_interface_contact_pairs(const struct thud_scene *scene, int interface, struct thud_contact_pair *out)
{
    const struct thud_by_level *only = &scene->interface[interface].contact_levels;
    const int all = all_contact_pairs(scene, interface, out);
    int n = only->n > 0 ? 0 : all;
    for (int i = 0; i < all && only->n > 0; i++) {
        bool meets = false;
        for (int k = 0; k < only->n && !meets; k++)
            meets = only->value_m[k] == thud_contact_level(scene, interface, &out[i]);
        if (meets)
            out[n++] = out[i];
    }
    return n;
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

void thud_contact_pair_name(int left_floor, int right_floor, int struck, char *text, unsigned long size)
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
