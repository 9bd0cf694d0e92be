#include "io/preset/preset_private.h"

#include <stdlib.h>

#include "base/grow.h"

void thud_patch_add(struct thud_patches *patches, size_t start, size_t end, struct thud_text *text)
{
    struct thud_patch *patch = thud_grow(patches->patch, patches->count, sizeof *patch);
    if (!patch) {
        patches->failed = true;
        thud_text_clear(text);
        return;
    }
    patches->patch = patch;
    patches->failed = patches->failed || text->failed;
    patch[patches->count] = (struct thud_patch){start, end, patches->count, text->data, text->size};
    patches->count++;
    *text = (struct thud_text){0};
}

static int by_place(const void *a, const void *b)
{
    const struct thud_patch *p = a, *q = b;
    if (p->start != q->start)
        return p->start < q->start ? -1 : 1;
    return p->order < q->order ? -1 : 1;
}

bool thud_patch_apply(struct thud_patches *patches, const char *text, size_t size, struct thud_text *out)
{
    size_t at = 0;
    if (patches->failed)
        return false;
    if (patches->count)
        qsort(patches->patch, patches->count, sizeof *patches->patch, by_place);
    for (size_t i = 0; i < patches->count; i++) {
        const struct thud_patch *patch = &patches->patch[i];
        if (patch->start < at || patch->end < patch->start || patch->end > size)
            return false;
        thud_text_bytes(out, text + at, patch->start - at);
        thud_text_bytes(out, patch->text ? patch->text : "", patch->size);
        at = patch->end;
    }
    thud_text_bytes(out, text + at, size - at);
    return !out->failed;
}

void thud_patch_clear(struct thud_patches *patches)
{
    for (size_t i = 0; i < patches->count; i++)
        free(patches->patch[i].text);
    free(patches->patch);
    *patches = (struct thud_patches){0};
}
