/* Elevations of floors, and the possible contacts at an interface: floors at the same level, or a slab and the columns
 * of a storey. */
#pragma once

#include "study/scene/scene.h"

/* Returns the number of moving floors: storeys, and an isolated building's base slab; 1 of a rigid body or flexible
 * wall, else 0. */
int thud_structure_floors(const struct thud_structure *structure);
/* Returns the elevation (m) of a floor (from 0) of a building or rigid body; NaN for a body without one. */
double thud_structure_elevation(const struct thud_structure *structure, int floor);
/* Returns which of the rows of a structure's floors (from 0) has its first storey below it: 1 of an isolated building,
 * whose row 0 is its isolators; of a wall or body the number of its rows, as it has none; else 0. Measures of storeys
 * begin there. */
int thud_structure_first_storey(const struct thud_structure *structure);
/* Returns the number of the storey below a floor (from 0), as in presets and messages; 0: the isolators. */
int thud_structure_storey(const struct thud_structure *structure, int floor);
/* Writes the name of a floor (from 0), or of the storey below it: "floor 3", "base slab"; "storey 3", "isolators". */
const char *thud_structure_level_name(const struct thud_structure *structure, int floor, bool storey, char text[24]);

/* Returns the depth (m) of its slab: its face covers [z - depth, z]; 0 for a rigid body. */
double thud_structure_depth(const struct thud_structure *structure, int floor);
/* Returns the height (m) over which two faces at levels a and b overlap; below 0: the distance between them. */
double thud_face_overlap(double a, double a_depth, double b, double b_depth);

/* Possible contact. */
struct thud_contact_pair {
    int left_floor, right_floor; /* from 1, 0 for a wall; of struck columns the floor above them */
    int struck; /* the side whose columns are struck by the other's slab: -1 left, 1 right; 0: floor to floor */
    double a_m,
        b_m; /* distances of the middle of the slab's face from the lower and the upper end of the clear columns */
};
enum { THUD_CONTACT_PAIRS_MAX = 2 * (THUD_STOREYS_MAX + 1) };

/* Lists the possible contacts of an interface (from 0), lowest first, into out (THUD_CONTACT_PAIRS_MAX); returns their
 * number. Floors collide if their faces overlap, their levels are within 1 cm, or the middle of one face is within 1 cm
 * of the other face. Any other floor strikes the columns of the storey whose clear height contains the middle of its
 * face. A floor above the neighbour's top floor, below its ground, or within 1 cm of it strikes nothing. With levels =
 * aligned nothing strikes columns; with contact-levels only these floors collide. */
int thud_interface_contact_pairs(const struct thud_scene *scene, int interface, struct thud_contact_pair *out);

/* Returns the floor by which `contact-levels` names a contact: the left building's, or the right one's if it has none.
 */
int thud_contact_level(const struct thud_scene *scene, int interface, const struct thud_contact_pair *pair);

/* Return the side of a contact's floor (not of a wall; for struck columns, that of the slab), and that floor. */
bool thud_slab_is_left(int left_floor, int struck);
int thud_slab_floor(int left_floor, int right_floor, int struck);
/* Returns the side of the struck columns: "left", "right", "". */
const char *thud_struck_name(int struck);
/* Writes "2-3", "wall-3", "2-c3": floor 2 of the left one and the columns below floor 3 of the right one. */
void thud_contact_pair_name(int left_floor, int right_floor, int struck, char *text, unsigned long size);
