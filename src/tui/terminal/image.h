/* Pictures in a terminal that draws them: which it can, and the bytes that show one. No terminal here.
 *
 * kitty: APC G with the PNG in base64, in pieces (https://sw.kovidgoyal.net/kitty/graphics-protocol/).
 * sixel: DCS q, as gnuplot writes it (DEC, VT330/VT340 Programmer Reference Manual, chapter 14). */
#pragma once

#include <stdbool.h>

#include "base/text.h"

enum thud_image { THUD_IMAGE_NONE, THUD_IMAGE_KITTY, THUD_IMAGE_SIXEL };
/* What a user wants: one of these, or what the terminal can. */
enum thud_image_choice {
    THUD_IMAGES_AUTO,
    THUD_IMAGES_NONE,
    THUD_IMAGES_KITTY,
    THUD_IMAGES_SIXEL,
    THUD_IMAGES_CHOICES
};
const char *thud_image_choice_name(enum thud_image_choice choice); /* "auto" */

/* What is known without asking the terminal, from its variables (NULL where not set): inside tmux and screen pictures
 * do not go through. *ask: nothing is, its answer to thud_image_question tells. */
struct thud_image_variables {
    const char *term, *kitty_window, *tmux, *sty;
};
enum thud_image thud_image_known(enum thud_image_choice choice, const struct thud_image_variables *of, bool *ask);

/* DA1. A terminal that draws sixels has a 4 among the numbers of its answer, ESC [ ? n ; n ... c. */
extern const char thud_image_question[];
bool thud_image_answer_has_sixel(const char *sequence); /* the whole answer */

/* The bytes that draw a picture from the upper left corner on; the cursor stays. A PNG for kitty (over so many columns
 * and rows), else as gnuplot's sixelgd gave it. */
void thud_image_draw(enum thud_image kind, const char *picture, size_t n, int columns, int rows, struct thud_text *out);
/* What takes it away where clearing the screen does not; may be empty. */
const char *thud_image_clear(enum thud_image kind);
