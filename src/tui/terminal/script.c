#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/scan.h"
#include "tui/terminal/backend.h"

static void script_size(struct thud_backend *backend, int *width, int *height)
{
    const struct thud_script *script = backend->state;
    *width = script->width;
    *height = script->height;
}

static void script_show(struct thud_backend *backend, const struct thud_canvas *canvas)
{
    (void)canvas;
    ((struct thud_script *)backend->state)->shows++;
}

static int named_key(struct thud_backend *backend, const char *name)
{
    struct thud_script *script = backend->state;
    static const struct {
        const char *name;
        int key;
    } table[] = {
        {"Enter", THUD_KEY_ENTER},
        {"Esc", THUD_KEY_ESC},
        {"Tab", THUD_KEY_TAB},
        {"S-Tab", THUD_KEY_BACKTAB},
        {"Up", THUD_KEY_UP},
        {"Down", THUD_KEY_DOWN},
        {"Left", THUD_KEY_LEFT},
        {"Right", THUD_KEY_RIGHT},
        {"Home", THUD_KEY_HOME},
        {"End", THUD_KEY_END},
        {"PgUp", THUD_KEY_PAGE_UP},
        {"PgDn", THUD_KEY_PAGE_DOWN},
        {"Del", THUD_KEY_DELETE},
        {"BS", THUD_KEY_BACKSPACE},
        {"F1", THUD_KEY_F1},
        {"F2", THUD_KEY_F2},
        {"Hangup", THUD_KEY_HANGUP},
        {"Paste", THUD_KEY_PASTE},
        {"WheelUp", THUD_KEY_WHEEL_UP},
        {"WheelDown", THUD_KEY_WHEEL_DOWN},
        {"lt", '<'},
        {"Space", ' '},
    };
    const char *at = name;
    if (thud_scan_word(&at, "Size ") && thud_scan_count(&at, &script->width) && thud_scan_word(&at, "x") &&
        thud_scan_count(&at, &script->height))
        return THUD_KEY_RESIZE;
    at = name;
    static const struct {
        const char *name;
        int key;
    } pointer[] = {{"Click ", THUD_KEY_CLICK},
                   {"Drag ", THUD_KEY_DRAG},
                   {"WheelUp ", THUD_KEY_WHEEL_UP},
                   {"WheelDown ", THUD_KEY_WHEEL_DOWN}};
    for (size_t i = 0; i < sizeof pointer / sizeof *pointer; i++, at = name)
        if (thud_scan_word(&at, pointer[i].name) && thud_scan_count(&at, &backend->click_x) &&
            thud_scan_word(&at, ",") && thud_scan_count(&at, &backend->click_y))
            return pointer[i].key;
    if (strncmp(name, "C-", 2) == 0 && name[2])
        return THUD_CTRL(name[2]);
    if (strncmp(name, "A-", 2) == 0 && name[2])
        return THUD_KEY_ALT + name[2];
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (strcmp(table[i].name, name) == 0)
            return table[i].key;
    return THUD_KEY_NONE;
}

static int script_key(struct thud_backend *backend, int timeout_ms)
{
    struct thud_script *script = backend->state;
    if (!script->at || !*script->at) {
        struct pollfd also = {backend->also, POLLIN, 0};
        if (timeout_ms != 0 && backend->also >= 0)
            poll(&also, 1, timeout_ms);
        return THUD_KEY_NONE;
    }
    const char *close = *script->at == '<' ? strchr(script->at, '>') : NULL;
    if (!close || close - script->at > 30)
        return (int)thud_utf8_next(&script->at);
    backend->paste = script->paste;
    char name[32];
    size_t size = (size_t)(close - script->at) - 1;
    memcpy(name, script->at + 1, size);
    name[size] = '\0';
    script->at = close + 1;
    return named_key(backend, name);
}

static double script_now(struct thud_backend *backend)
{
    struct thud_script *script = backend->state;
    script->now += script->tick;
    return script->now;
}

static int script_signal(struct thud_backend *backend)
{
    return ((struct thud_script *)backend->state)->signal;
}

static void script_repaint(struct thud_backend *backend)
{
    (void)backend;
}

static void script_mouse(struct thud_backend *backend, bool on)
{
    (void)backend;
    (void)on;
}

static void script_copy(struct thud_backend *backend, const char *text)
{
    struct thud_script *script = backend->state;
    snprintf(script->copied, sizeof script->copied, "%s", text);
}

static enum thud_image script_image(struct thud_backend *backend, int *width_px, int *height_px)
{
    const struct thud_script *script = backend->state;
    *width_px = 8 * script->width;
    *height_px = 16 * script->height;
    return script->image;
}

static void script_raw(struct thud_backend *backend, const char *bytes, size_t n)
{
    thud_text_bytes(&((struct thud_script *)backend->state)->raw, bytes, n);
}

void thud_script_open(struct thud_backend *backend, struct thud_script *script, int width, int height, bool utf8)
{
    *script = (struct thud_script){.width = width, .height = height};
    *backend = (struct thud_backend){.state = script,
                                     .utf8 = utf8,
                                     .also = -1,
                                     .size = script_size,
                                     .show = script_show,
                                     .key = script_key,
                                     .now = script_now,
                                     .signal = script_signal,
                                     .repaint = script_repaint,
                                     .mouse = script_mouse,
                                     .copy = script_copy,
                                     .image = script_image,
                                     .raw = script_raw};
}
