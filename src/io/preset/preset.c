#include "io/preset/preset.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/file/file.h"
#include "io/preset/preset_private.h"

/* towers from presets/towers.yaml. */
static void name_scene(struct thud_scene *scene, const char *path)
{
    const char *base = strrchr(path, '/');
    base = base ? base + 1 : path;
    size_t length = strlen(base);
    const char *dot = strrchr(base, '.');
    if (dot && dot != base && (strcmp(dot, ".yaml") == 0 || strcmp(dot, ".yml") == 0))
        length = (size_t)(dot - base);
    if (length >= sizeof scene->name)
        length = sizeof scene->name - 1;
    while (length > 0 && ((unsigned char)base[length] & 0xc0) == 0x80)
        length--; /* no half letter */
    memset(scene->name, 0, sizeof scene->name);
    memcpy(scene->name, base, length);
}

/* Takes `text` over, also on failure. */
static enum thud_status make(char *text, size_t size, const char *name, bool unfinished, struct thud_preset **out,
                             struct thud_error *err)
{
    struct thud_preset *preset = calloc(1, sizeof *preset);
    *out = NULL;
    if (!preset) {
        free(text);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    preset->text = text;
    preset->size = size;
    snprintf(preset->name, sizeof preset->name, "%s", name);
    enum thud_status status = thud_yaml_read(text, size, preset->name, &preset->tree, err);
    if (status == THUD_OK) {
        thud_scene_init(&preset->scene);
        name_scene(&preset->scene, name);
        status = thud_preset_walk(preset, err);
    }
    if (status == THUD_OK && !unfinished && thud_preset_unfinished(preset)) {
        status = preset->unfinished.status;
        if (err)
            *err = preset->unfinished;
    }
    if (status != THUD_OK)
        thud_preset_free(preset);
    else
        *out = preset;
    return status;
}

enum thud_status thud_preset_parse(const char *text, unsigned long size, const char *name, struct thud_preset **out,
                                   struct thud_error *err)
{
    *out = NULL;
    if (size > THUD_PRESET_BYTES_MAX) {
        thud_error_set(err, THUD_INPUT, "the file is too large");
        thud_error_allow(err, "at most %d bytes", THUD_PRESET_BYTES_MAX);
        thud_error_place(err, name, 0, 0);
        return THUD_INPUT;
    }
    char *copy = malloc(size + 1);
    if (!copy)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    if (size)
        memcpy(copy, text, size);
    copy[size] = '\0';
    return make(copy, size, name, false, out, err);
}

static enum thud_status read_file(const char *path, bool unfinished, struct thud_preset **out, struct thud_error *err)
{
    char *text;
    size_t size;
    *out = NULL;
    enum thud_status status = thud_file_read(path, THUD_PRESET_BYTES_MAX, &text, &size, err);
    return status == THUD_OK ? make(text, size, path, unfinished, out, err) : status;
}

enum thud_status thud_preset_read(const char *path, struct thud_preset **out, struct thud_error *err)
{
    return read_file(path, false, out, err);
}

enum thud_status thud_preset_read_unfinished(const char *path, struct thud_preset **out, struct thud_error *err)
{
    return read_file(path, true, out, err);
}

const struct thud_error *thud_preset_unfinished(const struct thud_preset *preset)
{
    return preset->unfinished.what[0] ? &preset->unfinished : NULL;
}

const struct thud_scene *thud_preset_scene(const struct thud_preset *preset)
{
    return &preset->scene;
}

void thud_preset_place(const struct thud_preset *preset, const char *key, struct thud_error *err)
{
    const struct thud_yaml_node *node = &preset->tree.node[thud_preset_node(preset, key)];
    thud_error_place(err, preset->name, node->line, node->column);
}

void thud_preset_free(struct thud_preset *preset)
{
    if (!preset)
        return;
    thud_yaml_clear(&preset->tree);
    free(preset->text);
    free(preset);
}
