/* Any keys on any sizes of terminal: the interface stays alive, draws only what may be drawn, and keeps its scene
 * sound. The first byte chooses the preset; then each byte is a key, a few are followed by others that say which. */
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tui/loop/loop.h"

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static const char *const presets[] = {
    "title: Two free bodies\n"
    "structures:\n"
    "  - {name: L, kind: rigid, mass: 320 t, velocity: 0.5 m/s}\n"
    "  - {name: R, kind: rigid, mass: 320 t}\n"
    "interfaces:\n"
    "  - gap: 0 cm\n"
    "    contact: {law: kelvin-voigt-no-tension, stiffness: 2500 kN/mm, restitution: 0.6}\n"
    "analysis: {tail: 0.2 s}\n",
    "title: Towers beside a wall\n"
    "record: {file: pulse.csv, peak: 0.6 g}\n"
    "structures:\n"
    "  - {name: A, kind: shear, storeys: 2, mass: 320 t, stiffness: 600 MN/m}\n"
    "  - {name: B, kind: isolated, storeys: 1, mass: 250 t, stiffness: 400 MN/m, base-mass: 300 t, "
    "isolation-stiffness: 10 MN/m}\n"
    "  - {name: W, kind: wall}\n"
    "interfaces:\n"
    "  - gap: 2 cm\n"
    "    contact: {law: kelvin-voigt-no-tension, stiffness: 2500 kN/mm, restitution: 0.6}\n"
    "    bumper: {law: rubber, thickness: 1 cm, stiffness: 0.36 kN/mm^2.65, exponent: 2.65, restitution: 0.5}\n"
    "  - gap: 3 cm\n"
    "    contact: {law: linear, stiffness: 2500 kN/mm}\n"
    "analysis: {tail: 0.1 s}\n"};
enum { PRESETS = sizeof presets / sizeof *presets };
static char folder[] = "/tmp/thud-keys-XXXXXX";
static struct thud_paths paths;

static void must(int holds)
{
    if (!holds)
        abort();
}

static void write_file(const char *name, const char *text)
{
    FILE *file = fopen(name, "w");
    must(file != NULL && fputs(text, file) >= 0 && fclose(file) == 0);
}

/* Afresh for every input, which may have written over them. */
static void write_files(void)
{
    write_file("0.yaml", presets[0]);
    write_file("1.yaml", presets[1]);
    write_file("pulse.csv", "time_s,acceleration_g\n0,0\n0.1,0.5\n0.2,-0.5\n0.3,0.25\n0.4,0\n");
}

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    must(mkdtemp(folder) != NULL);
    strcpy(paths.presets, folder);
    strcpy(paths.records, folder);
    return 0;
}

/* What has a letter below stands for other keys than a byte of text. */
static int key_of(const uint8_t **at, const uint8_t *end, struct thud_script *script)
{
    uint8_t byte = *(*at)++;
    int left = (int)(end - *at);
    if (byte < 0x80)
        return byte;
    if (byte < 0xa0)
        return THUD_KEY_FIRST + byte % (THUD_KEY_HANGUP - THUD_KEY_FIRST);
    if (byte < 0xb0)
        return THUD_KEY_ALT + '0' + byte % 10;
    if (byte < 0xb8 && left >= 2) {
        script->width = 1 + *(*at)++ % 200;
        script->height = 1 + *(*at)++ % 60;
        return THUD_KEY_RESIZE;
    }
    if (byte < 0xe0)
        return thud_key_at(byte % thud_key_count())->key;
    return 0x100 + byte * 37; /* some sign beyond ASCII */
}

static void check(const struct thud_tui *tui, const struct thud_script *script)
{
    const struct thud_canvas *canvas = &tui->canvas;
    struct thud_error err;
    must(canvas->width == script->width && canvas->height == script->height);
    must(canvas->cursor_x < canvas->width && canvas->cursor_y < canvas->height);
    for (int i = 0; i < canvas->width * canvas->height; i++)
        must(canvas->cell[i].glyph >= ' ' && canvas->cell[i].style.role < THUD_ROLES);
    must(thud_scene_check(&tui->doc.scene, &err) == THUD_OK);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const pasted[] = {"1\t2\n3 4", "320 t", "a\rb"};
    struct thud_backend backend;
    struct thud_script script;
    struct thud_tui *tui;
    struct thud_error err;
    if (size < 2 || size > 400)
        return -1;
    must(chdir(folder) == 0);
    write_files();
    char name[64];
    snprintf(name, sizeof name, "%.40s/%d.yaml", folder, data[0] % PRESETS);
    thud_script_open(&backend, &script, 80, 24, data[0] & 2);
    script.tick = 1e-3;
    script.paste = pasted[data[0] / 4 % 3];
    struct thud_tui_options options = {.preset = name, .paths = &paths, .output = folder, .gnuplot = "/bin/false"};
    must(thud_tui_create(&options, &backend, &tui, &err) == THUD_OK);
    const uint8_t *at = data + 1, *end = data + size;
    while (at < end) {
        int key = key_of(&at, end, &script);
        backend.paste = script.paste;
        backend.click_x = key * 7 % 200;
        backend.click_y = (int)(end - at) % 60;
        thud_tui_key(tui, key);
        tui->end.quit = tui->end.hangup = tui->end.interrupted = false;
        for (int i = 0; i < 2; i++)
            thud_tui_turn(tui, false);
        thud_tui_draw(tui);
        check(tui, &script);
    }
    thud_tui_free(tui);
    return 0;
}
