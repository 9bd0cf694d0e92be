/* Any bytes as a preset: what is taken passes its own check, is written back byte for byte, and reads back as the same
 * scene; with a value changed it is written as the changed scene, all its lines of comment kept. What is refused says
 * where and why. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "io/preset/preset.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void must(int holds)
{
    if (!holds)
        abort();
}

/* Values that stand in one place of a preset, or are left out; what a study varies changes with its values. */
static const char *const changes[][4] = {
    {"gap", "12.5 cm"},
    {"analysis.tolerance", "2e-7"},
    {"analysis.step", "1 ms"},
    {"analysis.tail", "3 s"},
    {"record.peak", "0.25 g"},
    {"record.sign", "-"},
    {"structures.1.mass", "123 t"},
    {"structures.1.mass.1", "124 t"},
    {"structures.2.stiffness", "345 MN/m"},
    {"structures.2.velocity", "0.25 m/s"},
    {"structures.1.damping", "3 %"},
    {"interfaces.1.contact.restitution", "0.55"},
    {"interfaces.1.contact.law", "linear"},
    {"interfaces.1.bumper.thickness", "4.5 cm"},
    {"interfaces.1.bumper.restitution", "0.45"},
    {"structures.1.storeys", "3"},
    {"analysis.method", "newmark"},
    {"study.vary", "gap", "study.values", "[6 cm, 7.5 cm]"},
    {"study.vary", "[gap, contact.damping]", "study.values", "[[6 cm, 9 cm], [paper]]"},
    {"study.cases", "[bumper, none]"}};
enum { CHANGES = sizeof changes / sizeof *changes };

static const char *line_after(const char *line, const char *end)
{
    const char *newline = memchr(line, '\n', (size_t)(end - line));
    return newline ? newline + 1 : end;
}

static int is_comment(const char *line, const char *next)
{
    while (line < next && (*line == ' ' || *line == '\t'))
        line++;
    return line < next && *line == '#';
}

/* Every line of comment of the old text stands in the new one, in their order. */
static void keeps_comments(const char *old, size_t old_size, const char *new, size_t new_size)
{
    const char *old_end = old + old_size, *new_end = new + new_size, *at = new;
    for (const char *line = old, *next; line < old_end; line = next) {
        next = line_after(line, old_end);
        if (!is_comment(line, next))
            continue;
        size_t length = (size_t)(next - line) - (next[-1] == '\n');
        const char *after = at;
        do {
            at = after;
            must(at < new_end);
            after = line_after(at, new_end);
        } while ((size_t)(after - at) < length || memcmp(at, line, length) != 0);
        at = after;
    }
}

static void change(const struct thud_preset *preset, const char *text, size_t size, unsigned which)
{
    static struct thud_scene wanted; /* large */
    struct thud_error err = {0};
    char *changed = NULL, *same = NULL;
    unsigned long length = 0, same_length = 0;
    wanted = *thud_preset_scene(preset);
    for (int i = 0; i < 4 && changes[which][i]; i += 2)
        if (thud_scene_set(&wanted, changes[which][i], changes[which][i + 1], &err) != THUD_OK)
            return;
    if (thud_scene_check(&wanted, &err) != THUD_OK)
        return;
    must(thud_preset_text(preset, &wanted, &changed, &length, &err) == THUD_OK);
    keeps_comments(text, size, changed, length);
    struct thud_preset *again = NULL;
    must(thud_preset_parse(changed, length, "fuzz.yaml", &again, &err) == THUD_OK);
    must(thud_preset_text(again, &wanted, &same, &same_length, &err) == THUD_OK); /* nothing is left to change */
    must(same_length == length && memcmp(same, changed, length) == 0);
    thud_preset_free(again);
    free(changed);
    free(same);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct thud_preset *preset = NULL;
    struct thud_error err = {0};
    if (thud_preset_parse((const char *)data, size, "fuzz.yaml", &preset, &err) != THUD_OK) {
        must(!preset && err.status == THUD_INPUT && err.what[0] != '\0');
        return 0;
    }
    const struct thud_scene *scene = thud_preset_scene(preset);
    must(thud_scene_check(scene, NULL) == THUD_OK);
    char *text = NULL;
    unsigned long length = 0;
    must(thud_preset_text(preset, scene, &text, &length, &err) == THUD_OK);
    must(length == size && memcmp(text, data, size) == 0);
    struct thud_preset *again = NULL;
    must(thud_preset_parse(text, length, "fuzz.yaml", &again, NULL) == THUD_OK);
    must(memcmp(thud_preset_scene(again), scene, sizeof *scene) == 0);
    thud_preset_free(again);
    for (unsigned which = 0; which < CHANGES; which++)
        change(preset, text, size, which);
    thud_preset_free(preset);
    free(text);
    return 0;
}
