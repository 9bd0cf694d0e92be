/* Saving: the file's bytes with the spans of changed values replaced. What comes out is read again before it is handed
 * over; should it not be the wanted scene (which no test has seen yet), the whole scene is written instead. */
#include <stdlib.h>
#include <string.h>

#include "io/preset/preset_private.h"

/* Without what no preset says: what is left of bumpers that have no law, and what lies past the last structure. */
static void copy_what_is_saved(const struct thud_scene *scene, struct thud_scene *out)
{
    memcpy(out, scene, sizeof *out);
    for (int i = 0; i < THUD_STRUCTURES_MAX; i++)
        if (i >= out->nstructures)
            memset(&out->structure[i], 0, sizeof out->structure[i]);
    for (int i = 0; i < THUD_STRUCTURES_MAX - 1; i++) {
        struct thud_interface *interface = &out->interface[i];
        interface->contact.assumed = false; /* a law that is the paper's because none is named, and one that is named */
        if (i + 1 >= out->nstructures)
            memset(interface, 0, sizeof *interface);
        else if (!thud_interface_says_bumper(interface)) {
            memset(&interface->bumper, 0, sizeof interface->bumper);
            interface->bumper_thickness_m = interface->bumper_cavity_m = 0;
        }
    }
    memset(out->name, 0, sizeof out->name);
}

/* Whether a text reads as the scene. Errors: THUD_MEMORY. */
static enum thud_status reads_as(const struct thud_preset *preset, const struct thud_text *text,
                                 const struct thud_scene *wanted, bool *same)
{
    struct thud_preset *again = NULL;
    struct thud_scene *read = malloc(sizeof *read);
    *same = false;
    enum thud_status status =
        read ? thud_preset_parse(text->data, text->size, preset->name, &again, NULL) : THUD_MEMORY;
    if (status == THUD_OK) {
        copy_what_is_saved(&again->scene, read);
        *same = memcmp(read, wanted, sizeof *read) == 0;
    }
    thud_preset_free(again);
    free(read);
    return status == THUD_MEMORY ? status : THUD_OK;
}

/* The comments before the first key, then the scene. */
static void write_whole(const struct thud_preset *preset, const struct thud_scene *scene, const char *newline,
                        struct thud_text *out)
{
    struct thud_emit emit = {out, newline, false};
    size_t head = preset->tree.node[0].start;
    while (head > 0 && preset->text[head - 1] != '\n')
        head--;
    thud_text_clear(out);
    thud_text_bytes(out, preset->text, head);
    thud_emit_scene(&emit, scene);
}

static bool write_changes(const struct thud_preset *preset, const struct thud_scene *scene, struct thud_text *out)
{
    const char *line = memchr(preset->text, '\n', preset->size);
    const char *newline = line && line > preset->text && line[-1] == '\r' ? "\r\n" : "\n";
    struct thud_patches patches = {0};
    bool ok = thud_preset_diff(preset, scene, newline, &patches);
    bool applied = ok && thud_patch_apply(&patches, preset->text, preset->size, out);
    bool readable = thud_scene_check(scene, NULL) == THUD_OK;
    thud_patch_clear(&patches);
    if (!ok || out->failed)
        return false;
    bool same = applied;
    if (applied && readable && reads_as(preset, out, scene, &same) != THUD_OK)
        return false;
    if (!same)
        write_whole(preset, scene, newline, out);
    return !out->failed;
}

enum thud_status thud_preset_text(const struct thud_preset *preset, const struct thud_scene *scene, char **text,
                                  unsigned long *size, struct thud_error *err)
{
    struct thud_text out = {0};
    struct thud_scene *now = malloc(sizeof *now), *was = malloc(sizeof *was);
    bool ok = now && was;
    if (ok) {
        copy_what_is_saved(scene, now);
        copy_what_is_saved(&preset->scene, was);
        if (memcmp(now, was, sizeof *now) == 0)
            thud_text_bytes(&out, preset->text, preset->size);
        else
            ok = write_changes(preset, now, &out);
    }
    free(now);
    free(was);
    if (!ok || out.failed) {
        thud_text_clear(&out);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    *text = out.data;
    *size = out.size;
    return THUD_OK;
}
