/* Differences between a preset as read and a scene. */
#ifndef THUD_IO_PRESET_DIFF_H
#define THUD_IO_PRESET_DIFF_H

#include "io/preset/preset_patch.h"
#include "io/preset/preset_private.h"

/* What has to be replaced in the preset's text; `scene` without what no preset says. false without memory. */
bool thud_preset_diff(const struct thud_preset *preset, const struct thud_scene *scene, const char *newline,
                      struct thud_patches *patches);

#endif
