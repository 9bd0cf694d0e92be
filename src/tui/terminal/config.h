/* Settings of the terminal interface from a file: a word and its value a line. */
#pragma once

#include <stdbool.h>

#include "base/status.h"
#include "tui/terminal/image.h"
#include "tui/terminal/roles.h"

struct thud_config {
    bool color, ascii, live, mouse;
    enum thud_theme theme;
    enum thud_image_choice images;
    char folder[512]; /* for figures and tables; empty: the working folder */
};

/* What holds where nothing is said. */
void thud_config_init(struct thud_config *config);
/* A file that is not there says nothing. Errors: THUD_INPUT with file and line. */
enum thud_status thud_config_read(struct thud_config *config, const char *path, struct thud_error *err);
/* $XDG_CONFIG_HOME/thud/config, or below ~/.config; empty where neither is known. */
void thud_config_path(char *path, unsigned long size);
