/* The terminal interface. */
#pragma once

#include <stdbool.h>

#include "base/status.h"
#include "base/text.h"
#include "io/file/paths.h"
#include "study/scene/scene.h"

struct thud_view;

struct thud_tui_options {
    const char *preset;             /* name or path; NULL: the first one shipped, `towers` */
    bool fresh;                     /* nobody named a preset: the form of a new scene stands over it */
    const struct thud_scene *scene; /* what options made of the preset, as a change not saved; NULL: as written */
    const struct thud_paths *paths; /* where presets and records are found; NULL: looked for */
    const char *output;             /* folder for pictures and tables; NULL: the working folder */
    const char *play;               /* a session to be played; NULL: none */
    const char *program;            /* that runs commands beside the screens; NULL: this one */
    const char *gnuplot;            /* the program that draws pictures; NULL: `gnuplot` from PATH */
    bool ascii;                     /* no glyph beyond ASCII, also where the terminal has them */
    bool live_off;                  /* edits do not run at once */
    bool color;                     /* false: none (--no-color, NO_COLOR) */
    const struct thud_view *view;   /* one more screen behind those of the list; NULL: none */
};

/* Runs until the user quits; the terminal is then as it was. A signal that ends it is raised again after that. Errors:
 * THUD_USAGE (no terminal), THUD_INPUT (the preset), THUD_MEMORY. */
enum thud_status thud_tui_main(const struct thud_tui_options *options, struct thud_error *err);

/* All keys, by screen, one per line: "WHERE<tab>KEY<tab>WHAT", for the manual. */
void thud_tui_keys_text(struct thud_text *out);

struct thud_tui;
