/* Scene as the user describes it. It is a plain value that `=` copies; thud_scene_init sets all bytes, so memcmp
 * compares scenes. SI units. Lists run from the lowest floor up. */
#pragma once

#include <stdbool.h>

#include "base/param.h"
#include "base/sha256.h"
#include "base/status.h"
#include "core/laws/law.h"

enum { THUD_STOREYS_MAX = 200, THUD_STRUCTURES_MAX = 20, THUD_LINKS_MAX = 32, THUD_TEXT_MAX = 256, THUD_NAME_MAX = 64 };
enum { THUD_NESTED_GROUPS = 4, THUD_SOURCE_MAX = 512 }; /* groups of a structure; bytes of a source */

enum thud_structure_kind {
    THUD_SHEAR,
    THUD_RIGID,
    THUD_ISOLATED,
    THUD_WALL,
    THUD_MATRIX,
    THUD_MODES,
    THUD_ESTIMATED,
    THUD_KINDS
};
/* Returns whether structures of this kind have storeys. */
static inline bool thud_kind_is_building(enum thud_structure_kind kind)
{
    return kind != THUD_RIGID && kind != THUD_WALL;
}

/* Returns whether its stiffness is read from a file instead of listed by storey. */
static inline bool thud_kind_is_read(enum thud_structure_kind kind)
{
    return kind == THUD_MATRIX || kind == THUD_MODES;
}

/* System of a building whose period is estimated. */
enum thud_system { THUD_CONCRETE_FRAME, THUD_STEEL_FRAME, THUD_WALLS, THUD_MASONRY };

/* Order of the floors in such a file; ask: refused if floors seem to be listed from the roof down. */
enum thud_floor_order { THUD_ORDER_ASK, THUD_ORDER_LOWEST_FIRST, THUD_ORDER_ROOF_FIRST };
/* Room for such files' data of all structures: a building of 79 floors, or four of 39; every copy of a scene has it. */
enum { THUD_SHAPE_ROOM = 6400 };

/* Displacement of a struck point between the floors, which also distributes the slab's force: of a member clamped in
 * both, or linear. */
enum thud_column_shape { THUD_COLUMN_CLAMPED, THUD_COLUMN_LINEAR };

/* Law of isolators: linear, or bilinear with kinematic hardening. The latter has the strength Q_d, the stiffness K_d
 * beyond yield and the yield displacement u_y; a pendulum has Q_d = mu W and K_d = W/R with the weight W above. */
enum thud_isolator_law { THUD_ISOLATOR_LINEAR, THUD_ISOLATOR_LEAD_RUBBER, THUD_ISOLATOR_PENDULUM };

struct thud_structure {
    char name[THUD_NAME_MAX];
    enum thud_structure_kind kind;
    int storeys; /* rigid: 1, wall: 0 */
    double mass_kg[THUD_STOREYS_MAX];
    double stiffness_npm[THUD_STOREYS_MAX];
    double height_m[THUD_STOREYS_MAX]; /* storey heights; rigid: [0] its elevation; wall: [0] its top, INFINITY when not
                                          given */
    /* Drift or shear at which a storey yields (not both); 0: elastic. Tangent over elastic stiffness beyond. */
    double yield_m[THUD_STOREYS_MAX];
    double yield_shear_n[THUD_STOREYS_MAX];
    double yield_coefficient[THUD_STOREYS_MAX]; /* of the weight above, in place of both */
    double hardening[THUD_STOREYS_MAX];
    double damping;                                                  /* ratio, the same in every mode */
    double base_mass_kg, isolation_stiffness_npm, isolation_damping; /* isolated only */
    double width_m; /* isolated only: between the outermost isolators; NaN: not given */
    /* Isolated only: its isolators; NaN: not given, or not of that law. */
    double isolator_law; /* enum thud_isolator_law */
    double isolator_strength_n, isolator_post_yield_npm, isolator_yield_m, isolator_radius_m, isolator_friction;
    /* Buildings on soil: the foundation, springs and dashpots under it, and the soil, from which values not given
     * follow; NaN: not given. */
    double foundation_mass_kg, foundation_inertia_kgm2;
    double sway_npm, sway_nspm, rocking_nmprad, rocking_nmsprad;
    double soil_vs_mps, soil_density_kgpm3, soil_poisson, foundation_radius_m;
    double velocity_mps; /* rigid only: at t = 0, to the right */
    /* Wall only: a flexible one has a mass; NaN: not given. The soil behind it (core/laws/law_backfill.c), past a gap.
     */
    double wall_mass_kg, wall_stiffness_npm, wall_damping;
    double backfill_stiffness_npm, backfill_strength_n, backfill_ratio, backfill_gap_m;
    double base_m; /* elevation of the ground that a building stands on */
    /* Depth of slab and beam at each floor's face, which covers [z - depth, z] below the floor's level z. A base slab
     * has the depth of the lowest floor. */
    double slab_depth_m[THUD_STOREYS_MAX];
    /* Columns of each storey that a neighbour's slab strikes, together; 0: not given. */
    double column_ei_nm2[THUD_STOREYS_MAX];        /* bending stiffness, or */
    double column_stiffness_npm[THUD_STOREYS_MAX]; /* their part of the storey's, 12 EI/L^3 */
    double column_capacity_n[THUD_STOREYS_MAX];    /* against shear */
    double column_shape;                           /* enum thud_column_shape */
    double gravity_n[THUD_STOREYS_MAX];            /* of each floor, weight that P-Delta counts; 0: of its mass */
    /* By matrix or modes. The data read are a part of the scene's `shape` in SI units, lowest floor first. A matrix has
     * the rows of the stiffness; modes have rows of a period and the values of the shape, at most one row per floor. */
    char stiffness_file[THUD_TEXT_MAX], flexibility_file[THUD_TEXT_MAX], periods_file[THUD_TEXT_MAX];
    char unit[16];            /* for files that do not say; empty: not given */
    double order;             /* enum thud_floor_order */
    double period_factor;     /* multiplies all periods, also of an estimated building */
    double period_s;          /* the first one, to which its stiffnesses are scaled; NaN or 0: they are as given */
    int shape_at, shape_rows; /* shape_rows 0: it has not been read */
    /* Estimated: its masses and stiffnesses follow (thud_structure_fill_estimate). */
    double system;  /* enum thud_system */
    double area_m2; /* of a floor; 0: not given */
    /* Fields from here on change the fingerprint of a scene only if they are given. */
    char file_sha256[THUD_SHA256_TEXT];                   /* of the file that has been read; empty: none */
    int modes;                                            /* its lowest ones alone; 0: analysis.modes */
    char source[1 + THUD_NESTED_GROUPS][THUD_SOURCE_MAX]; /* of its values, and of those of its nested groups */
    double cracked;                   /* factor of its storeys' stiffness and its columns' EI; 0: not given */
    double load_pa[THUD_STOREYS_MAX]; /* weight over area_m2, which gives the masses; 0: not given */
};
/* Returns the file of matrix or modes that a structure names; "": none. */
const char *thud_structure_file(const struct thud_structure *structure);

/* Returns the clear length (m) of the columns of a storey (from 0): floor or ground below to the face above. */
double thud_clear_height(const struct thud_structure *structure, int storey);
/* Returns EI (N m2) of the struck columns of a storey (from 0), from EI or stiffness; NaN: not given. */
double thud_column_ei(const struct thud_structure *structure, int storey);

/* Law with its parameters in the order of law->params. NaN: not given. */
struct thud_law_choice {
    const struct thud_law *law;
    double value[THUD_LAW_PARAMS_MAX];
    bool assumed; /* a preset names no law: it is the paper's */
};

/* Contacts of an interface: floor to floor and slab to columns, or floor to floor only. */
enum thud_levels { THUD_LEVELS_ALL, THUD_LEVELS_ALIGNED };

/* Values for each pair of floors, or of slab and columns, that can meet at an interface, lowest first (n 0: not given);
 * NaN: the interface's. */
enum { THUD_LEVELS_MAX = 64 };
struct thud_by_level {
    int n;
    double value_m[THUD_LEVELS_MAX];
};

struct thud_interface {
    double gap_m; /* concrete to concrete */
    struct thud_by_level gap;
    double levels;                       /* enum thud_levels */
    struct thud_by_level contact_levels; /* floors (from 1) that can meet the neighbour; n 0: all */
    struct thud_law_choice contact;
    bool has_bumper;
    struct thud_law_choice bumper;
    double bumper_thickness_m, bumper_cavity_m;
    struct thud_by_level thickness;  /* 0: no bumper there */
    char source[3][THUD_SOURCE_MAX]; /* of its values, of those of the contact and of the bumper */
};

/* Link between a floor of one structure and one of its neighbour, as an alternative to a bumper. */
enum thud_link_law {
    THUD_LINK_SPRING,
    THUD_LINK_DASHPOT,
    THUD_LINK_FRICTION,
    THUD_LINK_RESTRAINER,
    THUD_LINK_STRUT,
    THUD_LINK_LAWS
};

struct thud_link {
    char from[THUD_NAME_MAX + 8], to[THUD_NAME_MAX + 8]; /* A.4: floor 4 of A; A: a body, or a wall */
    double law;                                          /* enum thud_link_law */
    double stiffness_npm, damping_nspm;
    double slip_n;                /* friction: its largest force */
    double slack_m;               /* restrainer and strut: they act beyond it */
    char source[THUD_SOURCE_MAX]; /* not part of the fingerprint, unlike the fields before it */
};

struct thud_record_choice {
    char file[THUD_TEXT_MAX];          /* empty: no ground motion */
    double peak_mps2;                  /* scale to this peak; NaN: as recorded */
    double sa_mps2;                    /* scale to this spectral acceleration; NaN: not */
    double period_s;                   /* of sa; NaN: the mean of the buildings' fundamental periods */
    char target[128];                  /* scale to this design spectrum (ground/target.h); empty: not */
    double target_from_s, target_to_s; /* over these periods; NaN: 0.2 to 2 of the buildings' */
    double factor;                     /* 1 unless given */
    int sign;                          /* +1 or -1 */
    double from_s, to_s; /* the part that is used, in the file's own time; NaN: from its beginning, to its end */
    double dt_s;         /* for files that do not state it; NaN: not given */
    double resample_s;   /* for times in unequal steps, by linear interpolation; NaN: not given */
    char unit[16];       /* for files that do not say; empty: not given */
    char channel[32];    /* file with several; empty: not given */
    char component
        [32]; /* a direction, rotd50, rotd100, rotN or governs (io/record/record_component.h); empty: not given */
    int part; /* the n-th horizontal component of the file; 0: not asked for */
    char event[96], station[96], licence[96]; /* override those of the file; empty: as in the file */
    int column; /* from 1; 0: not given; -1 (`all`): the values of every line one after another */
    int skip;   /* lines; -1: not given */
    int every;  /* keeps one scaled sample in this number, after a low-pass filter; 0: all */
    char source[THUD_SOURCE_MAX];
};

struct thud_analysis {
    char method[32]; /* "auto" */
    double tolerance;
    double step_s; /* NaN: not given */
    double tail_s; /* free vibration after the record; without a record: the duration */
    bool locate;   /* fixed-step methods: locate events */
    int modes;     /* each building's lowest ones alone; 0: all */
    char source[THUD_SOURCE_MAX];
};

enum thud_case {
    THUD_CASE_FREE = -2, /* no pounding: the reference of the cases, not one of them */
    THUD_CASE_AS_WRITTEN,
    THUD_CASE_NONE,
    THUD_CASE_BUMPER,
    THUD_CASE_CAVITY,
    THUD_CASE_LINK,
    THUD_CASES,
    THUD_CASE_WHOLE = THUD_CASES /* with all parts of the scene; for texts only */
};
enum { THUD_CASES_MAX = THUD_CASES + 1 }; /* of a study: each of them, and as written */
/* Returns whether the scene's links stay in a case. */
static inline bool thud_case_has_links(enum thud_case which)
{
    return which <= THUD_CASE_AS_WRITTEN || which == THUD_CASE_LINK;
}

/* Study: up to THUD_VARY_MAX keys over ranges or lists, cases and ground motions. */
enum { THUD_VARY_MAX = 4, THUD_VARY_KEY = 96, THUD_VARY_VALUES = 320, THUD_VARY_TEXT = 512 };
struct thud_vary {
    char key[THUD_VARY_KEY];
    double from, to, step;         /* SI; NaN where there are values */
    char values[THUD_VARY_VALUES]; /* "5 cm, 7.5 cm"; empty: a range. All keys of a study have them, or none has */
};
struct thud_study_choice {
    int nvary;
    struct thud_vary vary[THUD_VARY_MAX];
    int ncases;
    enum thud_case cases[THUD_CASES_MAX];
    double sensitivity;           /* relative change of the inputs; 0: no spread is asked for */
    char records[THUD_VARY_TEXT]; /* as --records takes them, or in brackets; empty: the scene's own one */
    bool both_signs;              /* every ground motion in both polarities */
    char events[THUD_VARY_TEXT];  /* of the fragility, with commas or in brackets; empty: pounding, worse */
};

/* Title block of a report; empty: not given. */
struct thud_title_block {
    char project[128], number[32], revision[32], date[32], author[64], checker[64], approver[64];
    char code[32], limits[256]; /* of the conclusion: whose gap is recommended, "drift:1 %, force:5 MN" */
};

struct thud_scene {
    char name[THUD_NAME_MAX]; /* the preset's name, from its file name */
    char title[THUD_TEXT_MAX];
    bool p_delta; /* the weight on drifting storeys is included */
    struct thud_record_choice record;
    int nstructures;
    struct thud_structure structure[THUD_STRUCTURES_MAX];
    struct thud_interface interface[THUD_STRUCTURES_MAX - 1]; /* nstructures - 1 in use */
    struct thud_analysis analysis;
    double shape[THUD_SHAPE_ROOM]; /* parts of the structures that are read from files */
    struct thud_study_choice study;
    struct thud_title_block document;
    int nlinks;
    struct thud_link link[THUD_LINKS_MAX];
};

/* ---- making one ---- */

/* Clears a scene and sets its defaults. */
void thud_scene_init(struct thud_scene *scene);
/* Clears a record choice: no file, no scaling. */
void thud_record_choice_init(struct thud_record_choice *choice);
/* Selects another file (may be empty), as recorded, and clears the settings of the previous one (peak, factor, ...). */
void thud_record_choice_replace(struct thud_record_choice *choice, const char *file);
/* Sets the defaults of a kind, with one storey if it has storeys; required values are NaN. The name is empty. */
void thud_structure_init(struct thud_structure *structure, enum thud_structure_kind kind);
/* Selects a law with the defaults of its table (NaN where a value must be given). */
void thud_law_choice_init(struct thud_law_choice *choice, const struct thud_law *law);
/* Returns a parameter of the chosen law; NULL: there is no law, it has none of the name, or it is not given. */
double *thud_law_given(struct thud_law_choice *choice, const char *name);
/* Lists by floor or storey: mass, stiffness, height, slab depth, yield drift, yield shear, hardening ratio, EI,
 * stiffness and capacity of columns, weight, yield coefficient, load. */
enum { THUD_STRUCTURE_LISTS = 13 };
double *thud_structure_list(struct thud_structure *structure, int which);
/* Returns the stiffness (N/m) that storey i (from 0) has, cracked if it is. */
double thud_structure_stiffness(const struct thud_structure *structure, int i);
/* Returns the drift (m) at which storey i (from 0) yields; INFINITY: elastic. */
double thud_structure_yield(const struct thud_structure *structure, int i);
/* Isolators of a building together: V = r k d + (1 - r) k (d - d_p), |d - d_p| <= u_y; linear ones have r = 1 and an
 * infinite u_y. */
struct thud_isolator {
    enum thud_isolator_law law;
    double stiffness_npm, yield_m, hardening, damping; /* k = Q_d/u_y + K_d, u_y, r = K_d/k, damping ratio */
};
struct thud_isolator thud_structure_isolator(const struct thud_structure *structure);
/* Clears the isolator values that the law of the isolators does not have. */
void thud_isolator_keep_own(struct thud_structure *structure);
/* Returns the weight on the isolators, N. */
double thud_isolated_weight(const struct thud_structure *structure);
const char *thud_isolator_name(enum thud_isolator_law law); /* "linear", "lead-rubber", "pendulum" */
/* Returns whether the isolators yield or slide. */
bool thud_isolator_slides(const struct thud_structure *structure);
/* Returns whether a building stands on soil: any key of its foundation is given. */
bool thud_structure_on_soil(const struct thud_structure *structure);
/* Return whether a wall moves against the ground, and whether it has soil behind it. */
bool thud_wall_gives(const struct thud_structure *structure);
bool thud_wall_has_backfill(const struct thud_structure *structure);
double thud_wall_damping(const struct thud_structure *structure);
/* Usual values, each under its key, up to an empty key. The wall is a concrete cantilever 15 m long, 1.5 m high and 0.5
 * m thick; the soil is that of bridge abutments, 20.3 MN/m and 326 kN per metre. */
extern const char *const thud_usual_wall[][2], *const thud_usual_backfill[][2];
/* Usual bearings under so much mass, up to an empty key: 2.5 s beyond yielding or sliding, and 5 % of the weight to get
 * there. */
enum { THUD_USUAL_BEARINGS = 4 };
struct thud_usual {
    const char *key;
    char value[32];
};
void thud_usual_bearings(enum thud_isolator_law law, double all_kg, struct thud_usual out[THUD_USUAL_BEARINGS]);
/* Sets what belongs together with a value of a structure, before that value is set: the first value of a foundation, of
 * a flexible wall or of the soil behind it, and another law of isolators or of a link, bring usual values for the rest;
 * without its mass a foundation or a flexible wall has none of them. */
void thud_usual_set(struct thud_scene *scene, const char *key, const char *text);
/* Gives a link what its law needs and it has not. */
void thud_usual_link(struct thud_link *link);
/* Returns the weight (N) above storey i (from 0) of a building. */
double thud_structure_weight(const struct thud_structure *structure, int i);
/* Drift over height at which a storey has collapsed with P-Delta. */
#define THUD_COLLAPSE_DRIFT 0.1
/* Return whether a storey of the scene yields or an isolator slides, and whether a link slips, by their elements. */
bool thud_scene_yields(const struct thud_scene *scene);
bool thud_scene_slips(const struct thud_scene *scene);
/* Sets the defaults of a link law; required values are NaN, its ends are empty. */
void thud_link_init(struct thud_link *link, enum thud_link_law law);
bool thud_link_has(enum thud_link_law law, int param); /* of THUD_GROUP_LINK, by index */
/* Writes the name "A.4-B.4" of link i of a result, and returns the word of its law. */
void thud_link_name(const struct thud_scene *scene, int i, char *text, unsigned long size);
const char *thud_link_law_name(const struct thud_scene *scene, int i);
/* Returns the structure of soil link i of a result, which follow the scene's links; -1: a link. */
int thud_link_wall(const struct thud_scene *scene, int i);
/* Returns whether both ends of link i exist and are floors of neighbours. */
bool thud_link_stands(const struct thud_scene *scene, int i);
/* Renames a structure at the ends of links. */
void thud_links_rename(struct thud_scene *scene, const char *before, const char *now);
/* Returns the interface (from 0) that link i crosses; -1: the link is not valid. */
int thud_link_interface(const struct thud_scene *scene, int i);
/* Removes link i. */
void thud_link_remove(struct thud_scene *scene, int i);
/* Finds an end of a link: the structure from 0, the floor from 1; 0: it moves with the ground. Errors: THUD_INPUT
 * without key. */
enum thud_status thud_link_end(const struct thud_scene *scene, const char *end, int *structure, int *floor,
                               struct thud_error *err);
/* Set the paper's interface (Table 1), without a bumper at a gap of 10 cm; and its bumper, no thicker than the gap. */
void thud_interface_init(struct thud_interface *interface);
void thud_interface_add_bumper(struct thud_interface *interface);

/* ---- its parameters ---- */

enum thud_group {
    THUD_GROUP_SCENE,
    THUD_GROUP_RECORD,
    THUD_GROUP_STRUCTURE,
    THUD_GROUP_COLUMN,     /* of a structure with storeys */
    THUD_GROUP_ISOLATOR,   /* of an isolated building */
    THUD_GROUP_FOUNDATION, /* of a building on soil */
    THUD_GROUP_BACKFILL,   /* of a flexible wall */
    THUD_GROUP_INTERFACE,
    THUD_GROUP_CONTACT, /* `law`, before the law's own */
    THUD_GROUP_BUMPER,  /* `law`, thickness and cavity, before the law's own */
    THUD_GROUP_LINK,
    THUD_GROUP_ANALYSIS,
    THUD_GROUP_STUDY,
    THUD_GROUP_DOCUMENT,
    THUD_GROUPS
};
/* Returns the i-th described parameter of a group, in the order of presets; NULL after the last. */
const struct thud_param *thud_group_param(enum thud_group group, int i);
/* Returns the key of the group in presets: "structures", "record", ...; empty for THUD_GROUP_SCENE. */
const char *thud_group_key(enum thud_group group);
/* Return the group that contains a group, and the group with this key in a group; THUD_GROUPS: none. */
enum thud_group thud_group_in(enum thud_group group);
enum thud_group thud_group_find(enum thud_group in, const char *key);
/* Returns whether the scene has a list of them: structures, interfaces, links. */
static inline bool thud_group_is_list(enum thud_group group)
{
    return group == THUD_GROUP_STRUCTURE || group == THUD_GROUP_INTERFACE || group == THUD_GROUP_LINK;
}
/* Returns the offset in the scene of a group that occurs once (record, analysis, ...); 0 for structures and others. */
size_t thud_group_base(enum thud_group group);
/* Returns whether structures of the kind have this parameter of THUD_GROUP_STRUCTURE (by index). */
bool thud_structure_has(enum thud_structure_kind kind, int param);
/* Returns the table columns of the widest structure name, at least `least`. */
int thud_scene_names_width(const struct thud_scene *scene, int least);
/* Returns the word of a kind in presets. */
const char *thud_kind_name(enum thud_structure_kind kind);

/* Sets one value by its path (`structures.1.mass`, `interfaces.1.gap`, `gap`, `contact.restitution`,
 * `bumper.thickness`, `analysis.tolerance`, `record.peak`; lists `[320 t, 250 t]` or one value for every floor; one
 * floor by `structures.1.mass.2`, `structures.1.column.EI.2`). An empty text removes an optional value. The exponent
 * typed in a unit must be the law's; setting the exponent keeps the number of its stiffness in the shown unit. Errors:
 * THUD_INPUT with key and what is allowed. */
enum thud_status thud_scene_set(struct thud_scene *scene, const char *path, const char *text, struct thud_error *err);
/* Writes the value as text in its shown unit; empty: not given. Errors: THUD_INPUT (no such key). */
enum thud_status thud_scene_get(const struct thud_scene *scene, const char *path, char *text, unsigned long size,
                                struct thud_error *err);
/* Does the same in another unit of its dimension (NULL: the shown one); an exponent in it is replaced by the law's.
 * Errors: THUD_INPUT (no such key, no such unit). */
enum thud_status thud_scene_get_in(const struct thud_scene *scene, const char *path, const char *unit, char *text,
                                   unsigned long size, struct thud_error *err);
/* Does the same, or where a number has more than nine digits there, as a factor between units leaves them, in the first
 * unit of its dimension in which none has: 17 kip/in is 2.9771561991900983 MN/m. */
enum thud_status thud_scene_get_short(const struct thud_scene *scene, const char *path, const char *unit, char *text,
                                      unsigned long size, struct thud_error *err);
/* Returns the described parameter of a path, with its floor index in *floor (-1: all); NULL: unknown. */
const struct thud_param *thud_scene_param(const struct thud_scene *scene, const char *path, int *floor);
/* Returns the rank of a key in the order of setting, by its last part, of `length`. Kind, law, varied key, number of
 * storeys and exponent come before the keys that depend on them; period and load, which determine others, come after
 * them. */
enum { THUD_RANK_STOREYS = 3, THUD_RANK_USUAL = 5, THUD_RANK_LAST = 6 };
int thud_key_rank(const char *name, unsigned long length);
/* Returns whether a key changes no run: the title, a structure's name, sources, the study and the title block. */
bool thud_scene_is_words(const struct thud_scene *scene, const char *path);
/* Returns whether a path leads to one value for each floor of a building. */
bool thud_scene_by_floor(const struct thud_scene *scene, const char *path);
/* Groups nested in a structure, columns, isolators, foundation and backfill, and whether any value of one is given. */
enum thud_group thud_nested_group(int i);
bool thud_structure_has_group(const struct thud_structure *structure, enum thud_group group);

/* Writes the i-th varied key of the scene's study as `thud sweep --vary` takes it: "gap=5 cm:25 cm:0.5 cm" or "gap=5
 * cm, 7.5 cm" (THUD_VARY_TEXT is room for each). */
void thud_study_vary_text(const struct thud_scene *scene, int i, char *text, unsigned long size);

/* Checks values against each other (thickness - cavity <= gap, nothing missing, ...). Errors: THUD_INPUT with key. */
enum thud_status thud_scene_check(const struct thud_scene *scene, struct thud_error *err);

/* Returns the number of values needed to describe structures, interfaces and links. Values equal at every floor count
 * once. A building with omitted modes has the period and modal mass of each remaining mode, and its shape at the floors
 * that face a neighbour. */
int thud_scene_inputs(const struct thud_scene *scene);

/* ---- cases ---- */

/* Copies a scene for reading, without the unused structures and their parts: a tenth of the bytes for two structures.
 */
void thud_scene_copy(struct thud_scene *to, const struct thud_scene *from);
/* Makes the scene of a case: `none` removes every bumper and link, `link` the bumpers, `bumper` and `cavity` the links.
 * `bumper` sets the bumper flush, `cavity` at a depth of thickness (1 - max-strain). Without pounding there are no
 * bumpers, and contacts have no force. `out` may be the scene itself. Errors: THUD_INPUT (a case without its bumper or
 * link). */
enum thud_status thud_scene_case(const struct thud_scene *scene, enum thud_case which, struct thud_scene *out,
                                 struct thud_error *err);
/* Applies a case to one interface only. */
void thud_interface_case(struct thud_interface *interface, enum thud_case which);
bool thud_scene_has_bumper(const struct thud_scene *scene);
/* Returns whether case `none` omits anything. */
bool thud_scene_has_measure(const struct thud_scene *scene);
/* Returns the case without bumpers and with the scene's links. */
static inline enum thud_case thud_scene_bare(const struct thud_scene *scene)
{
    return scene->nlinks > 0 ? THUD_CASE_LINK : THUD_CASE_NONE;
}
const char *thud_case_name(enum thud_case which); /* "none", "bumper", "cavity", "link", "as-written" */
/* Parts that a case may omit. */
enum { THUD_HAS_BUMPER = 1, THUD_HAS_LINKS = 2 };
int thud_scene_measures(const struct thud_scene *scene);
/* Return the words for a case of a scene with these measures (THUD_HAS_...). Tables and figures use "no bumper",
 * "neither bumper nor links"; sentences use "without the bumper", "with the links and without the bumper". */
const char *thud_case_title(int measures, enum thud_case which);
/* Returns the title of the case without pounding, in which the links of the scene act or not. */
const char *thud_case_free_title(bool links);
/* Returns what ratios to it are to, in a scene with these measures: "no pounding, links act", "no pounding at all". */
const char *thud_case_free_words(int measures, bool links);
const char *thud_case_phrase(int measures, enum thud_case which);
/* Returns the subject of what a case does: "bumper", "bumper in a cavity", "links", as written all that the scene has:
 * "bumper and links"; *verb gets the ending of its verb, "s" or "". */
const char *thud_case_subject(int measures, enum thud_case which, const char **verb);
/* Returns the compared cases of one bumper: no pounding, no bumper, bumper. */
static inline enum thud_case thud_case_compared(int i)
{
    return i > 0 ? (enum thud_case)(i - 1) : THUD_CASE_FREE;
}
/* Finds a case by its name. Errors: THUD_INPUT. */
enum thud_status thud_case_find(const char *name, enum thud_case *out, struct thud_error *err);
/* Reads several cases with commas between, also in brackets, each once. Errors: THUD_INPUT. */
enum thud_status thud_cases_parse(const char *text, enum thud_case cases[THUD_CASES_MAX], int *n,
                                  struct thud_error *err);

/* Values at a level of an interface (from 0), or of the interface itself (-1). The cavity is that of the interface at
 * all levels. */
struct thud_level_values {
    double gap_m;
    bool has_bumper;
    double thickness_m, cavity_m; /* 0: no bumper */
};
struct thud_level_values thud_interface_level(const struct thud_interface *interface, int level);
double thud_level_clearance(const struct thud_level_values *level);
/* Gives the smallest and the largest gap (m) of its levels. */
void thud_interface_gaps(const struct thud_interface *interface, double *least_m, double *most_m);
/* Gives the smallest and the largest thickness (m) of the bumpers at its levels; 0: there is none. */
void thud_interface_thicknesses(const struct thud_interface *interface, double *least_m, double *most_m);
/* Returns the largest projection (m) of the bumpers at its levels, thickness less cavity; 0: there is none. *least_m
 * gets the smallest if not NULL. */
double thud_interface_projection(const struct thud_interface *interface, double *least_m);
/* Write "10 cm", "8 to 12 cm by level": of its gap, and of its bumper's thickness. */
void thud_interface_gap_text(const struct thud_interface *interface, char *text, unsigned long size);
void thud_interface_thickness_text(const struct thud_interface *interface, char *text, unsigned long size);
/* Multiplies every gap, but keeps at least the projection of its bumper. */
void thud_interface_scale_gap(struct thud_interface *interface, double factor);
/* Returns the clearance: gap - (thickness - cavity) with a bumper, gap without; never below 0 by rounding. */
double thud_interface_clearance(const struct thud_interface *interface);
/* Writes "6 cm"; by level "10 cm at 1-1 to 2-2, 6 cm at 3-3". */
void thud_interface_clearance_text(const struct thud_scene *scene, int interface, char *text, size_t size);
/* Returns the ultimate strain of the bumper; NaN: no bumper, or its law has none. */
double thud_interface_max_strain(const struct thud_interface *interface);
