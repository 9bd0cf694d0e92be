/* A terminal interface without a terminal: keys from a script, the screen as text. */
#pragma once

#include "tui/loop/loop.h"

struct fixture {
    struct thud_tui *tui;
    struct thud_backend backend;
    struct thud_script script;
    struct thud_paths paths;
    char folder
        [64]; /* a temporary one, with `towers.yaml`, `bodies.yaml` and `pulse.csv` in it, and the presets also in `shipped` */
};

extern const char *const fixture_towers; /* the text of towers.yaml */

/* Fails the test where it cannot. */
void fixture_open(struct fixture *f, const char *preset, int width, int height, bool utf8);
void fixture_close(struct fixture *f);
/* Feeds keys (see script.c) and works until there is nothing more to do. */
void fixture_keys(struct fixture *f, const char *keys);
/* The screen as it is now (free with free()). */
char *fixture_text(struct fixture *f);
bool fixture_shows(struct fixture *f, const char *text);
/* Both fail the test with the whole screen. */
void fixture_expect(struct fixture *f, const char *text);
void fixture_expect_not(struct fixture *f, const char *text);
/* The file of a name in the fixture's folder (free with free()). */
char *fixture_file(struct fixture *f, const char *name);
void fixture_write_pulse(struct fixture *f); /* pulse.csv */
/* The record is gone from the disk, and looked for again. */
void fixture_take_record(struct fixture *f);
/* A program in place of thud's own that is this shell script; its path. */
void fixture_program(struct fixture *f, char *path, size_t size, const char *script);
void fixture_write(struct fixture *f, const char *name, const char *text);
/* The study's one ground motion becomes gone.csv, which is then taken away. */
void fixture_lose_motion(struct fixture *f);
