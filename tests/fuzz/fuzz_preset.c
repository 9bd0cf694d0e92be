/* Any bytes as a preset: what is taken passes its own check, is written back byte for byte, and reads back as the same
 * scene; what is refused says where and why. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "io/preset.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void must(int holds)
{
    if (!holds)
        abort();
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
    thud_preset_free(preset);
    free(text);
    return 0;
}
