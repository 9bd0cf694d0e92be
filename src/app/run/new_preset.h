/* A preset from nothing: the few values that two neighbours, their gap and a ground motion need. A form or questions
 * ask for them, and they make the commented text of a preset. */
#pragma once

#include <stdbool.h>

#include "base/text.h"

enum thud_new_row {
    THUD_NEW_NAME,
    THUD_NEW_KIND,
    THUD_NEW_STOREYS,
    THUD_NEW_MASS,
    THUD_NEW_STIFFNESS, /* or the first period, from which it follows */
    THUD_NEW_HEIGHT,
    THUD_NEW_DAMPING,
    THUD_NEW_GAP,
    THUD_NEW_RECORD,
    THUD_NEW_SOIL,   /* under a building; empty: rigid ground */
    THUD_NEW_DAMPER, /* between the two; empty: none */
    THUD_NEW_ROWS
};
enum { THUD_NEW_TEXT = 2048 }; /* a list of 200 floors */

struct thud_new_preset {
    char text[THUD_NEW_ROWS][2][THUD_NEW_TEXT]; /* as typed, left and right; rows of one value have it on the left */
};

struct thud_new_about {
    const char *word;  /* as commands have it */
    const char *label; /* on screens and in questions */
    const char *unit;  /* of a bare number */
    const char *help;  /* what can be typed there */
    bool single;       /* one value, not one for each structure */
    bool optional;     /* "no" is an answer */
};
const struct thud_new_about *thud_new_about(enum thud_new_row row);
/* The i-th kind of structure; NULL past the last. */
const char *thud_new_kind(int i);

/* The usual values: buildings of 4 and 6 storeys. */
void thud_new_preset_init(struct thud_new_preset *preset);
/* Whether the structure on a side (0 left, 1 right) has the value; the single ones stand on the left. */
bool thud_new_applies(const struct thud_new_preset *preset, enum thud_new_row row, int side);
/* "5, 7" or one value for both. */
void thud_new_preset_put(struct thud_new_preset *preset, enum thud_new_row row, const char *text);
/* "left storeys [4]: ", what is asked of a structure of its kind */
void thud_new_question(const struct thud_new_preset *preset, enum thud_new_row row, int side, struct thud_text *out);
/* Takes an answer in place of what stands there, and what follows from it: the right one goes with the left one, and a
 * kind has a usual stiffness. */
void thud_new_preset_answer(struct thud_new_preset *preset, enum thud_new_row row, int side, const char *text);
/* "NAME: 4-storey building and 6-storey building" */
void thud_new_preset_title(const struct thud_new_preset *preset, char *title, size_t size);
/* Whether the answer can be read and stands within its bounds, by the preset that it makes of the usual values. Errors:
 * THUD_INPUT with what is allowed, THUD_MEMORY. */
enum thud_status thud_new_preset_check(const struct thud_new_preset *preset, enum thud_new_row row, int side,
                                       struct thud_error *err);
/* The preset. Errors: THUD_INPUT (a period that gives no stiffness), THUD_MEMORY; other values are checked by who reads
 * the text. */
enum thud_status thud_new_preset_text(const struct thud_new_preset *preset, struct thud_text *out,
                                      struct thud_error *err);
