/* A preset as read: its bytes, its tree, its scene. */
#ifndef THUD_IO_PRESET_PRIVATE_H
#define THUD_IO_PRESET_PRIVATE_H

#include "io/preset/preset.h"
#include "io/preset/yaml_tree.h"

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

/* The node of a path, or of the nearest thing around it that the preset has. */
int thud_preset_node(const struct thud_preset *preset, const char *path);

#endif
