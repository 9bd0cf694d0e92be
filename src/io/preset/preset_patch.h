/* Replacements of spans of a text. */
#ifndef THUD_IO_PRESET_PATCH_H
#define THUD_IO_PRESET_PATCH_H

#include <stdbool.h>
#include <stddef.h>

#include "base/text.h"

struct thud_patch {
    size_t start, end, order;
    char *text;
    size_t size;
};
struct thud_patches {
    struct thud_patch *patch;
    size_t count, capacity;
    bool failed; /* out of memory */
};

/* Takes `text` (cleared then) for what stands from start to end. */
void thud_patch_add(struct thud_patches *patches, size_t start, size_t end, struct thud_text *text);
/* false when two overlap or memory was short. */
bool thud_patch_apply(struct thud_patches *patches, const char *text, size_t size, struct thud_text *out);
void thud_patch_clear(struct thud_patches *patches);

#endif
