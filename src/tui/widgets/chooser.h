/* A list over the screen: typing narrows it, Enter takes the marked line. */
#pragma once

#include "tui/widgets/line.h"

struct thud_choice {
    char value[128]; /* what is taken */
    char text[160];  /* what is shown */
};

struct thud_chooser {
    char title[96];
    struct thud_choice *choice; /* (n) */
    int n;
    struct thud_pane drawn; /* the lines, as last drawn */
    bool fuzzy;             /* letters in their order are enough */
    int at, top;            /* the marked line among those shown, and the first shown */
    struct thud_line filter;
};

void thud_chooser_begin(struct thud_chooser *chooser, const char *title);
void thud_chooser_add(struct thud_chooser *chooser, const char *value, const char *fmt, ...) THUD_PRINTF(3, 4);
void thud_chooser_mark(struct thud_chooser *chooser, const char *value);
/* Moves or types; Enter and Esc are the caller's. */
void thud_chooser_key(struct thud_chooser *chooser, int key);
const struct thud_choice *thud_chooser_marked(const struct thud_chooser *chooser); /* NULL: nothing fits */
void thud_chooser_draw(struct thud_chooser *chooser, const struct thud_pane *area);
/* Marks the line at a place of the canvas; true where it was marked already, so that a second click takes it. */
bool thud_chooser_click(struct thud_chooser *chooser, int x, int y);
void thud_chooser_free(struct thud_chooser *chooser);

/* Keeps the cursor of a list within its n lines, and scrolls so that it is seen in so many rows. */
void thud_list_scroll(int *at, int *top, int n, int rows);
