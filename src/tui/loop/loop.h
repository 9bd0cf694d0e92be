/* The loop in its parts, so that tests can turn it by hand. */
#pragma once

#include "tui/document/state.h"

/* tui.c. Errors of create: THUD_INPUT (the preset), THUD_MEMORY. */
enum thud_status thud_tui_create(const struct thud_tui_options *options, struct thud_backend *backend,
                                 struct thud_tui **out, struct thud_error *err);
void thud_tui_key(struct thud_tui *tui, int key);
/* One turn: draws where something changed, takes a key, works for a few milliseconds. Blocks only where there is
 * nothing to do and `wait`. False: nothing was done. */
bool thud_tui_turn(struct thud_tui *tui, bool wait);
void thud_tui_free(struct thud_tui *tui);

/* view.c */
extern const struct thud_view *const thud_views[THUD_SCREENS];

/* cannot.c */
int thud_tui_where(const struct thud_tui *tui); /* the bit in the key table that holds now */
const char *thud_tui_cannot(struct thud_tui *tui, enum thud_action action); /* why, in words; NULL: it can be done */

/* act.c */
void thud_tui_click(struct thud_tui *tui);
void thud_tui_drag(struct thud_tui *tui);
void thud_tui_wheel(struct thud_tui *tui, int step); /* 1 down, -1 up */
void thud_tui_act(struct thud_tui *tui, enum thud_action action);

/* edit.c */
/* Edits the field in focus, or does what its row stands for; `select`: what is typed replaces the text. */
void thud_tui_edit(struct thud_tui *tui, bool select);
bool thud_tui_typable(const struct thud_tui *tui, const struct thud_field *field); /* its value is typed, not chosen */
/* Takes what was typed and goes on editing where `action` (ACCEPT_NEXT, ...) leads. */
void thud_tui_accept_and_go(struct thud_tui *tui, enum thud_action action);
bool thud_tui_accept(struct thud_tui *tui); /* the text of the field being edited; false: it was refused */
void thud_tui_step_value(struct thud_tui *tui, int steps);
void thud_tui_toggle(struct thud_tui *tui);

/* prompt.c */
/* A key that means something to a prompt beside typing; false: it is another. */
bool thud_tui_prompt_key(struct thud_tui *tui, int key);
void thud_tui_remember(struct thud_tui *tui, const char *text); /* a command, for the keys Up and Down */

/* paste.c */
void thud_tui_paste(struct thud_tui *tui, const char *text);
void thud_tui_paste_line(struct thud_tui *tui, char *line); /* as a log has it: rows end with `;;` */

/* preset.c: what is open */
void thud_tui_save(struct thud_tui *tui, const char *path, bool sure);
void thud_tui_save_as(struct thud_tui *tui);
void thud_tui_open(struct thud_tui *tui, const char *name, bool sure);
void thud_tui_new(struct thud_tui *tui); /* the form of a new scene */
void thud_tui_quit(struct thud_tui *tui, bool sure);
void thud_tui_offer_recovery(struct thud_tui *tui);
void thud_tui_list_presets(struct thud_tui *tui);

/* find.c */
void thud_tui_fill_fields(struct thud_tui *tui); /* into the list */

/* designs.c: what was run so far */
void thud_tui_list_designs(struct thud_tui *tui);
void thud_tui_go_to_design(struct thud_tui *tui, const char *name); /* or "#3" */
void thud_tui_compare_with(struct thud_tui *tui, char *name);       /* empty: with the state before each change */
void thud_tui_name_design(struct thud_tui *tui, char *name);        /* the present one, and saves it so */
/* Where the preset of a named design stands. */
void thud_tui_design_path(const struct thud_tui *tui, const char *name, char *path, size_t size);

/* solve.c: which value makes something hold; with a question before it is taken */
void thud_tui_solve_field(struct thud_tui *tui);
void thud_tui_solve(struct thud_tui *tui, char *text); /* "force < 10 MN; gap=2 cm:20 cm", without */

/* palette.c */
void thud_tui_palette(struct thud_tui *tui);

/* remarks.c: on the scene as written; a list with what the result rests on, each line of which leads to its field. */
int thud_tui_count_remarks(const struct thud_tui *tui);
void thud_tui_list_remarks(struct thud_tui *tui);
const char *thud_tui_cannot_list_remarks(const struct thud_tui *tui); /* NULL: it can be shown */

/* command.c */
void thud_tui_command(struct thud_tui *tui, char *text);            /* cuts it */
void thud_tui_command_line(struct thud_tui *tui, const char *text); /* to be typed on */

/* output.c */
bool thud_tui_show_figure(struct thud_tui *tui, const char *name); /* on the screen; false: it has none */
void thud_tui_picture(struct thud_tui *tui);
void thud_tui_export(struct thud_tui *tui);
void thud_tui_copy(struct thud_tui *tui); /* the focused pane's numbers to the clipboard */

/* verb.c: commands of the command line (enum thud_command_id) on the preset that is open */
void thud_tui_verb(struct thud_tui *tui, int id, const char *text); /* with options as they are typed */
void thud_tui_verb_form(struct thud_tui *tui, int id);              /* asks for them */
void thud_tui_verb_look(struct thud_tui *tui);                      /* says how far it is, and what came of it */

/* shelf.c */
void thud_tui_shelf(struct thud_tui *tui);
void thud_tui_shelf_at(struct thud_tui *tui, const char *name); /* with this figure on show */
/* Writes the marked figures, where none is marked those of the screen; the live cases are run again where the histories
 * are missing. */
void thud_tui_pictures(struct thud_tui *tui);

/* frame.c */
void thud_tui_draw(struct thud_tui *tui);
int thud_tui_tab_at(struct thud_tui *tui, int column); /* the screen whose name stands there; -1: none */
