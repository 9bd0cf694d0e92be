/* Parts of a scene as YAML. */
#ifndef THUD_IO_PRESET_EMIT_H
#define THUD_IO_PRESET_EMIT_H

#include <stdbool.h>

#include "base/text.h"
#include "study/scene/scene.h"

enum { THUD_SECTION_KEYS_MAX = 40, THUD_SECTION_PATH = 64, THUD_VALUE_MAX = 16384 };

/* The keys that stand together in a preset. */
struct thud_section {
    enum thud_group group;
    int index; /* of the structure or interface, from 0 */
};

/* "structures.1", "structures.1.column", "interfaces.1.bumper", "record"; empty for the scene's own. */
void thud_section_path(struct thud_section section, char *path, size_t size);
/* Names of the keys that the scene has in a section, in the order of presets; count. */
int thud_section_keys(const struct thud_scene *scene, struct thud_section section, const char **key);

/* How it is written: lines with an indent, or {key: value, ...}. */
struct thud_emit {
    struct thud_text *out;
    const char *newline;
    bool flow;
};

/* `text` as thud_scene_get gives it: a list stays one. */
void thud_emit_value(struct thud_text *out, const char *path, const char *text, bool flow);

/* All keys of a section that are given (record, analysis, study and columns: that are not as they are anyway). Lines: each with
 * its indent; the first one without it where `inline_first`. */
void thud_emit_section(struct thud_emit *emit, const struct thud_scene *scene, struct thud_section section, int indent,
                       bool inline_first);
/* A structure with its columns, or an interface with its contact and bumper. */
void thud_emit_item(struct thud_emit *emit, const struct thud_scene *scene, struct thud_section section, int indent);
/* The whole scene. */
void thud_emit_scene(struct thud_emit *emit, const struct thud_scene *scene);

#endif
