#pragma once

#include "base/text.h"
#include "tui/terminal/canvas.h"

/* The whole screen as one picture. Look at out->failed. */
void thud_canvas_svg(const struct thud_canvas *canvas, struct thud_text *out);
