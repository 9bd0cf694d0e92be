/* Reads presets strictly (YAML, libyaml); saving replaces only the spans of values that changed. */
#pragma once

#include "base/status.h"
#include "study/scene/scene.h"

/* Preset as read: the file's bytes, the place of each value, and the scene. */
struct thud_preset;

/* Read a preset from a file, or from memory with `name` as its path. Errors: THUD_INPUT with file, line, column, key
 * and what is allowed; THUD_MEMORY. */
enum thud_status thud_preset_read(const char *path, struct thud_preset **out, struct thud_error *err);
enum thud_status thud_preset_parse(const char *text, unsigned long size, const char *name, struct thud_preset **out,
                                   struct thud_error *err);
/* Does the same for callers that use no bumper: accepts a preset in which only bumpers are incomplete;
 * thud_preset_unfinished gives what they lack (NULL: nothing). */
enum thud_status thud_preset_read_unfinished(const char *path, struct thud_preset **out, struct thud_error *err);
const struct thud_error *thud_preset_unfinished(const struct thud_preset *preset);
const struct thud_scene *thud_preset_scene(const struct thud_preset *preset);

/* Returns the file's bytes with changed values of `scene` replaced (comments and layout kept; free with free()). Other
 * changes (an added structure) rewrite the smallest enclosing block. Errors: THUD_INPUT (text that YAML cannot hold),
 * THUD_MEMORY. */
enum thud_status thud_preset_text(const struct thud_preset *preset, const struct thud_scene *scene, char **text,
                                  unsigned long *size, struct thud_error *err);
/* Lists every key of a scene except those of its study, in preset order, with its value as written there. An example is
 * section "structures.1.column" (the start of a path, empty for keys of the scene), key "capacity". Errors:
 * THUD_MEMORY. */
enum thud_status thud_preset_each(const struct thud_scene *scene, void *context,
                                  void (*each)(void *context, const char *section, const char *key, const char *value));
/* Writes a temporary beside `path`, syncs and renames. Errors: THUD_OUTPUT, those of thud_preset_text. */
enum thud_status thud_preset_save(const struct thud_preset *preset, const struct thud_scene *scene, const char *path,
                                  struct thud_error *err);
/* Completes an error with the place of a key in the file, or of the nearest thing around it. */
void thud_preset_place(const struct thud_preset *preset, const char *key, struct thud_error *err);
void thud_preset_free(struct thud_preset *preset);
