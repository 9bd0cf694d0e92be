/* Where a path of a scene leads: the described parameter and the place of its value. */
#pragma once

#include <stddef.h>

#include "study/scene/scene.h"

enum thud_store {
    THUD_STORE_NUMBER, /* double: a quantity or the index of a choice; NaN, or infinity for a wall's height: not given
                        */
    THUD_STORE_COUNT,  /* int; `none` stands for not given */
    THUD_STORE_SIGN,   /* int, +1 or -1 */
    THUD_STORE_SWITCH, /* bool: the first and second of its choices */
    THUD_STORE_TEXT,
    THUD_STORE_FLOORS,  /* double[storeys]; optional: 0 stands for not given */
    THUD_STORE_LEVELS,  /* struct thud_by_level */
    THUD_STORE_STOREYS, /* int, and the length of the lists */
    THUD_STORE_KIND,
    THUD_STORE_LAW,
    THUD_STORE_LINK, /* double: the law of a link, on which its other values depend; empty: takes the link away */
    THUD_STORE_STUDY
};

/* Of a parameter of the tables, from the start of its structure, interface, ... */
struct thud_place {
    enum thud_store store;
    size_t offset, size; /* size: of a text */
    int none;            /* THUD_STORE_COUNT */
    double absent;       /* THUD_STORE_NUMBER: what stands for not given where that is allowed; 0: must be given */
    const char *usual;   /* THUD_STORE_TEXT: what stands there where none is given; NULL: nothing */
    unsigned kinds;      /* bit set of structure kinds, of links that of their laws */
    unsigned laws;       /* THUD_GROUP_ISOLATOR: bit set of the isolators' laws that have it */
    unsigned needed;     /* and of those that cannot do without it */
    bool optional;       /* THUD_STORE_FLOORS and NUMBER: need not be given, and is then 0 */
    bool reads;          /* a structure's file is read again for it */
};

struct thud_slot {
    const struct thud_param *param;
    struct thud_place place;  /* offset from the start of the scene */
    int index;                /* of the parameter in its group or law */
    int structure, interface; /* from 0; -1 */
    int link;                 /* from 0; -1; the number of links: one to be added */
    size_t choice;            /* offset of the law choice the value is part of; 0: none */
    bool bumper;
    int floor; /* from 0; -1: all */
};

enum thud_status thud_link_law_set(struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                                   struct thud_error *err);
/* Errors: THUD_INPUT with key. */
enum thud_status thud_links_check(const struct thud_scene *scene, struct thud_error *err);

/* Whether the values of a group in `of`, a structure of a kind or a link of a law, are there where they must be, and
 * within their bounds; also those that need not be there (`given`). Errors: THUD_INPUT with the key behind `prefix`. */
enum thud_status thud_group_check(const void *of, enum thud_group group, unsigned kind, int storeys, bool given,
                                  const char *prefix, struct thud_error *err);

/* Returns whether a value is given and within its bounds. Makes no text: a study checks its scene at every point. */
bool thud_value_fits(const struct thud_param *param, double value);
/* Refuses a value that is not. Errors: THUD_INPUT with key. */
enum thud_status thud_value_check(const struct thud_param *param, double value, const char *key,
                                  struct thud_error *err);

/* What must be given. */
#define THUD_REQUIRED 0.0

/* Of the i-th parameter of a group; NULL behind the last. */
const struct thud_place *thud_group_place(enum thud_group group, int i);
/* The value of a parameter that is not given: its default, NaN without one; of a list that of the lowest floor. */
void thud_place_clear(const struct thud_param *param, const struct thud_place *place, void *at);
/* The same for all values of a group in `of`: a part of the scene, a structure of one of these kinds (bit set). */
void thud_group_clear(void *of, enum thud_group group, unsigned kinds);

/* Errors: THUD_INPUT with key, and the nearest known one. */
enum thud_status thud_slot_find(const struct thud_scene *scene, const char *path, struct thud_slot *out,
                                struct thud_error *err);

static inline void *thud_slot_at(struct thud_scene *scene, const struct thud_slot *slot)
{
    return (char *)scene + slot->place.offset;
}
static inline const void *thud_slot_in(const struct thud_scene *scene, const struct thud_slot *slot)
{
    return (const char *)scene + slot->place.offset;
}

/* The law that a value is part of; NULL: none. */
static inline const struct thud_law_choice *thud_slot_law(const struct thud_scene *scene, const struct thud_slot *slot)
{
    return slot->choice ? (const struct thud_law_choice *)(const void *)((const char *)scene + slot->choice) : NULL;
}
/* The unit in which a value is shown (NULL), or this one, with the exponent of the law. */
void thud_slot_unit(const struct thud_scene *scene, const struct thud_slot *slot, const char *unit, char *text,
                    size_t size);

/* A floor of an optional list that has no value, where 0 is none. */
#define THUD_FLOOR_NONE "none"
static inline bool thud_floor_may_lack(const struct thud_param *param, const struct thud_place *place)
{
    return place->store == THUD_STORE_FLOORS && place->optional && param->least_open;
}

/* Values of one kind each; the text is trimmed. Errors: THUD_INPUT. */
enum thud_status thud_floors_set(struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                                 struct thud_error *err);
enum thud_status thud_levels_set(struct thud_by_level *levels, const struct thud_param *param, const char *text,
                                 struct thud_error *err);
void thud_levels_get(const struct thud_by_level *levels, const char *unit, char *text, size_t size);
/* Errors: THUD_INPUT with key. */
enum thud_status thud_levels_check(const struct thud_scene *scene, int interface, struct thud_error *err);
enum thud_status thud_storeys_set(struct thud_structure *structure, int storeys);
enum thud_status thud_kind_set(struct thud_structure *structure, enum thud_structure_kind kind);
enum thud_status thud_law_set(struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                              struct thud_error *err);
/* Of a value that is not the study's; an empty text takes back one that may be missing. Errors: also THUD_MEMORY. */
enum thud_status thud_value_set(struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                                struct thud_error *err);
void thud_value_get(const struct thud_scene *scene, const struct thud_slot *slot, const char *unit, char *text,
                    size_t size);
/* A copy without blanks around it. Errors: THUD_INPUT when it is too long, THUD_MEMORY. */
enum thud_status thud_value_trimmed(const char *text, char **out, struct thud_error *err);
enum thud_status thud_study_set(struct thud_scene *scene, const struct thud_slot *slot, const char *text,
                                struct thud_error *err);
void thud_study_get(const struct thud_scene *scene, const struct thud_slot *slot, char *text, size_t size);

/* Adds to an error what is allowed (NULL: nothing) and the key, and gives THUD_INPUT. */
enum thud_status thud_scene_refuse(struct thud_error *err, const char *allowed, const char *key, ...) THUD_PRINTF(3, 4);

/* A quantity with its bounds. `choice`: the law whose exponent the unit must carry, NULL outside laws. Errors:
 * THUD_INPUT with what is allowed. */
enum thud_status thud_quantity_read(const struct thud_param *param, const struct thud_law_choice *choice,
                                    const char *text, double *out, struct thud_error *err);
/* The exponent that a stiffness of this law carries; NaN where it has none. */
double thud_law_exponent(const struct thud_law_choice *choice, const struct thud_param *param);

/* `unit` with the exponent behind its caret replaced. */
void thud_unit_with_exponent(const char *unit, double exponent, char *text, size_t size);
