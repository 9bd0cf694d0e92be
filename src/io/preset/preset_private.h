/* A preset as read: its bytes, its tree, its scene. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/text.h"
#include "io/preset/preset.h"
#include "io/preset/yaml_tree.h"
#include "study/scene/scene.h"

enum { THUD_PRESET_BYTES_MAX = 1 << 20, THUD_PRESET_VALUE_MAX = 16384 };

struct thud_preset {
    char *text;
    size_t size;
    char name[512]; /* as in messages */
    struct thud_yaml tree;
    struct thud_scene scene;
    struct thud_error unfinished; /* what a bumper lacks; what: "" where none does */
};

/* The scene of a tree. Errors: THUD_INPUT with place and key. */
enum thud_status thud_preset_walk(struct thud_preset *preset, struct thud_error *err);

/* The list of a structure that says how many storeys there are; -1: none. */
int thud_preset_storeys(const struct thud_yaml *tree, int structure);

/* The node of a path, or of the nearest thing around it that the preset has. */
int thud_preset_node(const struct thud_preset *preset, const char *path);

/* ---- Parts of a scene as YAML ---- */

enum { THUD_SECTION_KEYS_MAX = 40, THUD_SECTION_PATH = 160, THUD_VALUE_MAX = 16384 };

/* The keys that stand together in a preset. */
struct thud_section {
    enum thud_group group;
    int index; /* of the structure or interface, from 0 */
};

/* Whether it has a bumper, or the values of one that is out. */
static inline bool thud_interface_says_bumper(const struct thud_interface *interface)
{
    return interface->has_bumper || interface->bumper.law;
}
/* How many there are of a group that stands in the scene itself. */
int thud_section_count(const struct thud_scene *scene, enum thud_group group);
/* Whether a scene has a section that is nested in a structure or an interface. */
bool thud_section_given(const struct thud_scene *scene, struct thud_section section);

/* "structures.1.", "structures.1.column.", "interfaces.1.bumper.", "record."; empty for the scene's own. With a key:
 * its path. */
void thud_section_path(struct thud_section section, const char *key, char *path, size_t size);
/* The keys of a section that are given, in the order of presets, each with its path and its text. */
struct thud_keys {
    const struct thud_scene *scene;
    char *text; /* (THUD_VALUE_MAX) the caller's */
    const char *key, *all[THUD_SECTION_KEYS_MAX];
    char path[THUD_SECTION_PATH];
    int n, next;
    struct thud_section section;
};
struct thud_keys thud_keys_of(const struct thud_scene *scene, struct thud_section section, char *text);
bool thud_keys_next(struct thud_keys *keys);

/* How it is written: lines with an indent, or {key: value, ...}. */
struct thud_emit {
    struct thud_text *out;
    const char *newline;
    bool flow;
};

/* Whether a value, as thud_scene_get gives it, is a list, and no text that begins with a bracket. */
bool thud_value_is_list(const struct thud_scene *scene, const char *path, const char *text);
/* `text` as thud_scene_get gives it: a list stays one. */
void thud_emit_value(struct thud_text *out, const struct thud_scene *scene, const char *path, const char *text,
                     bool flow);

/* All keys of a section that are given (record, analysis, study and columns: that are not as they are anyway). Lines:
 * each with its indent; the first one without it where `inline_first`. */
void thud_emit_section(struct thud_emit *emit, const struct thud_scene *scene, struct thud_section section, int indent,
                       bool inline_first);
/* A structure with its columns, or an interface with its contact and bumper. */
void thud_emit_item(struct thud_emit *emit, const struct thud_scene *scene, struct thud_section section, int indent);
/* The whole scene. */
void thud_emit_scene(struct thud_emit *emit, const struct thud_scene *scene);

/* ---- Replacements of spans of a text ---- */

struct thud_patch {
    size_t start, end, order;
    char *text;
    size_t size;
};
struct thud_patches {
    struct thud_patch *patch;
    size_t count;
    bool failed; /* out of memory */
};

/* Takes `text` (cleared then) for what stands from start to end. */
void thud_patch_add(struct thud_patches *patches, size_t start, size_t end, struct thud_text *text);
/* false when two overlap or memory was short. */
bool thud_patch_apply(struct thud_patches *patches, const char *text, size_t size, struct thud_text *out);
void thud_patch_clear(struct thud_patches *patches);

/* ---- Differences between a preset as read and a scene ---- */

/* What has to be replaced in the preset's text; `scene` without what no preset says. false without memory. */
bool thud_preset_diff(const struct thud_preset *preset, const struct thud_scene *scene, const char *newline,
                      struct thud_patches *patches);
