/* Any lines KEY=VALUE set in a scene: what is taken reads back as a text that sets the same value again; what is
 * refused says why and changes nothing. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "study/scene/scene.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void must(int holds)
{
    if (!holds)
        abort();
}

static void start(struct thud_scene *scene)
{
    thud_scene_init(scene);
    scene->nstructures = 3;
    thud_structure_init(&scene->structure[0], THUD_SHEAR);
    thud_structure_init(&scene->structure[1], THUD_ISOLATED);
    thud_structure_init(&scene->structure[2], THUD_WALL);
    for (int i = 0; i < 2; i++)
        thud_interface_init(&scene->interface[i]);
    thud_interface_add_bumper(&scene->interface[1]);
}

static void set(struct thud_scene *scene, const char *key, const char *value)
{
    static struct thud_scene before, again;
    char text[8192];
    struct thud_error err = {0};
    before = *scene;
    if (thud_scene_set(scene, key, value, &err) != THUD_OK) {
        must(err.what[0] != '\0');
        must(memcmp(scene, &before, sizeof before) == 0);
        return;
    }
    if (thud_scene_get(scene, key, text, sizeof text, NULL) != THUD_OK)
        return;
    again = *scene;
    must(thud_scene_set(&again, key, text, &err) == THUD_OK);
    must(memcmp(&again, scene, sizeof again) == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct thud_scene scene;
    char *text = malloc(size + 1);
    memcpy(text, data, size);
    text[size] = '\0';
    start(&scene);
    for (char *line = text; line;) {
        char *end = strchr(line, '\n');
        if (end)
            *end++ = '\0';
        char *value = strchr(line, '=');
        if (value) {
            *value++ = '\0';
            set(&scene, line, value);
        }
        line = end;
    }
    struct thud_error err = {0};
    if (thud_scene_check(&scene, &err) != THUD_OK)
        must(err.what[0] != '\0');
    free(text);
    return 0;
}
