/* Reads lateral stiffness, flexibility, or periods and mode shapes of a building from tables of ETABS and SAP2000. They
 * are CSV with one row per floor or mode; the unit is in the header or given separately. */
#pragma once

#include <stdbool.h>

#include "study/scene/scene.h"

enum thud_building_content { THUD_CONTENT_STIFFNESS, THUD_CONTENT_FLEXIBILITY, THUD_CONTENT_PERIODS };

/* Expected contents of a file. */
struct thud_building_ask {
    enum thud_building_content content;
    bool any;         /* the content is what the file's header and unit say */
    int floors;       /* 0: as many as there are */
    const char *unit; /* for files that do not say; empty: not given */
    enum thud_floor_order order;
};

/* Contents read: SI units, lowest floor first. A flexibility has become a stiffness. */
struct thud_building_table {
    enum thud_building_content content; /* of the file */
    int floors, rows;
    double *value; /* (rows x floors), of periods (rows x (1 + floors)); free with thud_building_table_clear */
    char unit[32]; /* as the file has it, or was said */
    double asymmetry;
    int row, column;               /* the elements that differ most, from 0 */
    bool reversed;                 /* the file begins with the roof */
    char sha256[THUD_SHA256_TEXT]; /* of the file */
};

/* Reads a file. Errors: THUD_INPUT with file, line and column; THUD_MEMORY. */
enum thud_status thud_building_file_read(const char *path, const struct thud_building_ask *ask,
                                         struct thud_building_table *out, struct thud_error *err);
void thud_building_table_clear(struct thud_building_table *table);

/* Moves a scene from one preset to another (paths). Files that the new preset would not find, or whose names would find
 * other files, get their full path if there is room. */
void thud_building_files_move(struct thud_scene *scene, const char *from, const char *to);
/* Reads the files named by a scene's structures and not read yet, from the working folder and beside the preset (path;
 * NULL: none). Errors: also the key. */
enum thud_status thud_building_files_read(struct thud_scene *scene, const char *preset, struct thud_error *err);
