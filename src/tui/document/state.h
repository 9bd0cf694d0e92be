/* Everything the terminal interface knows while it runs, and what its parts share. */
#ifndef THUD_TUI_STATE_H
#define THUD_TUI_STATE_H

#include "app/run/live_cases.h"
#include "plot/figure/figure.h"
#include "tui/document/browse.h"
#include "tui/document/doc.h"
#include "tui/document/keys.h"
#include "tui/document/pin.h"
#include "tui/loop/picture_work.h"
#include "tui/loop/tui.h"
#include "tui/screens/beside.h"
#include "tui/screens/law_figure.h"
#include "tui/widgets/chart.h"
#include "tui/widgets/chooser.h"
#include "tui/widgets/form.h"
#include "tui/widgets/line.h"

enum thud_screen {
#define THUD_SCREEN(name, title) THUD_SCREEN_##name,
#include "tui/loop/screen_list.h"
#undef THUD_SCREEN
    THUD_SCREENS
};

enum thud_mode { THUD_MODE_NORMAL, THUD_MODE_TYPING, THUD_MODE_CHOOSING, THUD_MODE_ASKING, THUD_MODE_NEW };
enum thud_typing {
    THUD_TYPE_FIELD,
    THUD_TYPE_COMMAND,
    THUD_TYPE_SAVE_AS,
    THUD_TYPE_FILTER,
    THUD_TYPE_STUDY,
    THUD_TYPE_SEARCH
};
enum thud_choosing {
    THUD_CHOOSE_VALUE,
    THUD_CHOOSE_PRESET,
    THUD_CHOOSE_FIELD,
    THUD_CHOOSE_BESIDE,
    THUD_CHOOSE_NOTHING
};
enum thud_asking { THUD_ASK_QUIT, THUD_ASK_OVERWRITE, THUD_ASK_DISK, THUD_ASK_OPEN, THUD_ASK_NEW, THUD_ASK_RECOVER };

enum { THUD_PANES_MAX = 6, THUD_HISTORY = 50 };
struct thud_rect {
    int x, y, w, h;
};

/* A screen: its panes, how they share the area, what each draws, and its own actions. */
struct thud_view {
    const char *title;
    int where;    /* its bit in the key table */
    bool verdict; /* the answer in one line stands above its panes */
    /* The bit that holds now, where it depends on the pane with the cursor. May be NULL. */
    int (*place)(const struct thud_tui *tui);
    /* How many panes there are in `area`, and where. Called again whenever the size changed. */
    int (*layout)(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane);
    /* Draws pane `index` (its frame's inside) and registers its fields; returns the rows it would need. */
    int (*draw)(struct thud_tui *tui, int index, struct thud_pane *pane);
    void (*pane_title)(struct thud_tui *tui, int index, char *text, size_t size);
    /* True where the action was the screen's. */
    bool (*act)(struct thud_tui *tui, enum thud_action action);
    /* Why an action of its own cannot be done now; NULL: it can. May be NULL. */
    const char *(*cannot)(struct thud_tui *tui, enum thud_action action);
    /* Enter on a line that can be chosen. May be NULL. */
    void (*row)(struct thud_tui *tui, const struct thud_field *field);
    /* What the lower lines say of that line; NULL: nothing. May be NULL. */
    const char *(*hint)(const struct thud_field *field);
    /* The figure on show, for PNG and CSV; NULL where there is none. May be NULL. */
    const struct thud_figure *(*figure)(struct thud_tui *tui);
    /* The panel of it in which a cursor reads values; NULL where there is none now. May be NULL. */
    const struct thud_panel *(*read)(struct thud_tui *tui);
    /* Enter on that panel with the cursor in it; false: nothing can be done with what it reads. May be NULL. */
    bool (*take)(struct thud_tui *tui);
    /* Called while it is shown and nothing else is computed, so that what it shows follows the scene. May be NULL. */
    void (*live)(struct thud_tui *tui);
    /* Work of its own in slices of about a millisecond: `busy` says whether there is any, `work` does a piece (false:
     * none was left). May be NULL. */
    bool (*busy)(struct thud_tui *tui);
    bool (*work)(struct thud_tui *tui);
    /* What the lower lines say where the cursor is on no field. May be NULL. */
    void (*words)(struct thud_tui *tui, char *text, size_t size);
    /* Time until `tick` has to be called, s; negative: never. May be NULL. */
    double (*pause)(struct thud_tui *tui);
    void (*tick)(struct thud_tui *tui);
    double (*progress)(struct thud_tui *tui); /* of its own work, 0 to 1; NULL where it has none */
    /* In place of all figures of the live cases, and of the figure's data. May be NULL. */
    void (*pictures)(struct thud_tui *tui);
    void (*export_csv)(struct thud_tui *tui);
    void (*free)(struct thud_tui *tui); /* may be NULL */
};
/* A screen's table, from the functions that every screen has under these names in its file; what more it has follows.
 */
#define THUD_VIEW(name, words, place, ...)                                                                             \
    const struct thud_view thud_view_##name = {.title = words,                                                         \
                                               .where = THUD_AT_##place,                                               \
                                               .layout = layout,                                                       \
                                               .draw = draw,                                                           \
                                               .pane_title = pane_title,                                               \
                                               __VA_ARGS__}
const struct thud_view *thud_view_of(enum thud_screen screen);

struct thud_plots_state;
struct thud_record_state;
struct thud_sweep_state;
struct thud_bench_screen;
struct thud_help_state;
struct thud_new_scene;

struct thud_tui {
    struct thud_tui_options options;
    struct thud_backend *backend;
    struct thud_canvas canvas;
    struct thud_doc doc;
    struct thud_live live;
    struct thud_form form;
    struct thud_chooser chooser;
    struct thud_line line;

    enum thud_screen screen, before_help;
    enum thud_mode mode;
    enum thud_typing typing;
    enum thud_choosing choosing;
    enum thud_asking asking;
    char target[512]; /* the field being edited, or the path asked about */
    int pair;         /* the interface shown on Model and Contact, from 0 */
    bool mouse;
    bool dirty;    /* the screen must be drawn */
    bool draw_now; /* and at once: a case has ended */
    bool quit, hangup, interrupted;
    char folder[512];                  /* for pictures and tables; empty: as given at the start */
    char wrote[8192];                  /* names of the files written so far, one a line */
    bool quit_next, new_next;          /* once it is saved */
    char open_next[512];               /* likewise; empty: nothing */
    bool keeps, keeping_failed;        /* unsaved edits are kept in a file after each; that it failed was said */
    unsigned long kept_edits;          /* those of the document when they were last kept */
    struct thud_picture_work *writing; /* figures being written; NULL: none */
    int writing_done, writing_count;   /* as last looked at */
    enum thud_screen writing_screen;   /* on which that was asked for */
    enum thud_image picture;           /* one covers the screen, in this way, until the next key */
    char written[700];                 /* what is written then */
    bool pictures_wanted;              /* once the run has its histories */
    enum thud_action whole_wanted;     /* what is done once it has them whole: PICTURE or EXPORT */
    bool was_running;                  /* the live run was going at the last look */

    char history[THUD_HISTORY][THUD_LINE_MAX]; /* (nhistory) commands, the oldest first */
    int nhistory, history_at;

    char message[640];
    enum thud_role message_role;

    struct thud_text log; /* what was done, a command a line */
    bool playing;         /* a session: what is unsaved is not asked about */

    bool live_on, live_wanted;   /* as it is, and for every preset that is opened */
    double started_s, elapsed_s; /* of the live run */
    double plain_s;              /* what the last one without histories took */
    unsigned long ran_revision;  /* what the live cases belong to; 0: nothing */
    struct thud_pin pin;         /* the state that changes are told against */
    double drawn_s;              /* when the screen was drawn */

    double kept_force_n, kept_before_n; /* F(delta_u) after and before a change of the exponent; NaN: none */
    int kept_interface;
    struct thud_figure *law_figure; /* force-indentation loops of the interface shown */
    struct thud_meeting meeting[THUD_MEETINGS], beside_meeting[THUD_MEETINGS];
    struct thud_beside beside; /* a law to compare with */
    struct thud_error law_error;
    unsigned long law_revision; /* what they belong to; 0: nothing */
    int law_pair;
    struct thud_plots_state *plots;
    struct thud_record_state *record;
    struct thud_sweep_state *sweep;
    struct thud_bench_screen *bench;
    struct thud_model *own_model; /* of the scene where no run has one; NULL: none */
    unsigned long own_revision;   /* what it belongs to */
    char verdict[240];            /* the answer in one line, as last known */
    int verdict_role;
    int results_case, results_sort, results_quantity;
    struct thud_chart_frame chart; /* where the chart that is read stands; no cells: there is none */
    double reading[THUD_SCREENS];  /* x of the cursor that reads a screen's chart; NaN: it is not there */
    struct thud_help_state *help;
    struct thud_new_scene *new_scene; /* the form, once there was one */
};

/* tui.c */
void thud_tui_say(struct thud_tui *tui, enum thud_role role, const char *fmt, ...) THUD_PRINTF(3, 4);
void thud_tui_say_error(struct thud_tui *tui, const struct thud_error *err);

/* act.c */
int thud_tui_where(const struct thud_tui *tui); /* the bit in the key table that holds now */
void thud_tui_click(struct thud_tui *tui);
void thud_tui_wheel(struct thud_tui *tui, int step); /* 1 down, -1 up */
void thud_tui_act(struct thud_tui *tui, enum thud_action action);
const char *thud_tui_cannot(struct thud_tui *tui, enum thud_action action);
void thud_tui_go(struct thud_tui *tui, enum thud_screen screen);

/* recompute.c */
void thud_tui_opened(struct thud_tui *tui);  /* another preset stands in the document */
void thud_tui_ran(struct thud_tui *tui);     /* the live run has ended */
void thud_tui_changed(struct thud_tui *tui); /* the scene or what is shown changed: run again where live */
void thud_tui_run(struct thud_tui *tui);
/* The model of the scene as it is, without contacts where a run has made one; NULL: it cannot be assembled. */
const struct thud_model *thud_tui_model(struct thud_tui *tui);
/* The cases to compare with; NULL: none, or not there yet. */
const struct thud_live *thud_tui_pinned(const struct thud_tui *tui);
const char *thud_tui_pin_name(const struct thud_tui *tui); /* "pinned", or "saved" as long as nothing was */
/* Whether some number of the live cases is still that of before the last change. */
bool thud_tui_shows_old(const struct thud_tui *tui);
enum thud_live_history thud_tui_wants_history(const struct thud_tui *tui);
void thud_tui_pin(struct thud_tui *tui);      /* the present state is the one to compare with */
void thud_tui_exchange(struct thud_tui *tui); /* the scene becomes the pinned one, which becomes that of before */
bool thud_tui_cancel(struct thud_tui *tui);   /* false: nothing was running */

/* edit.c */
/* Edits the field in focus, or does what its row stands for; `select`: what is typed replaces the text. */
void thud_tui_edit(struct thud_tui *tui, bool select);
bool thud_tui_typable(const struct thud_tui *tui, const struct thud_field *field); /* its value is typed, not chosen */
/* Takes what was typed and goes on editing where `action` (ACCEPT_NEXT, ...) leads. */
void thud_tui_accept_and_go(struct thud_tui *tui, enum thud_action action);
/* Another ground motion, as recorded; where it cannot be found or read the one there is stays. False: it was refused.
 */
bool thud_tui_choose_record(struct thud_tui *tui, const char *file);
/* What was typed, with the shown unit of the key where it has none. */
void thud_tui_with_unit(const struct thud_tui *tui, const char *key, const char *typed, char *text, size_t size);
void thud_tui_step_value(struct thud_tui *tui, int steps);
void thud_tui_toggle(struct thud_tui *tui);
bool thud_tui_accept(struct thud_tui *tui); /* the text of the field being edited; false: it was refused */
bool thud_tui_set(struct thud_tui *tui, const char *key, const char *text); /* with messages and warnings */
void thud_tui_all_floors(struct thud_tui *tui);

/* prompt.c */
/* A key that means something to a prompt beside typing; false: it is another. */
bool thud_tui_prompt_key(struct thud_tui *tui, int key);
void thud_tui_remember(struct thud_tui *tui, const char *text); /* a command, for the keys Up and Down */

/* paste.c */
void thud_tui_paste(struct thud_tui *tui, const char *text);
void thud_tui_paste_line(struct thud_tui *tui, const char *line); /* as a log has it: rows end with `;;` */

/* ask.c: prompts, choosers, questions */
void thud_tui_prompt(struct thud_tui *tui, enum thud_typing typing, const char *text);
void thud_tui_prompt_done(struct thud_tui *tui);
void thud_tui_choose(struct thud_tui *tui, enum thud_choosing choosing, const char *title);
void thud_tui_chosen(struct thud_tui *tui);
void thud_tui_answered(struct thud_tui *tui, int key);
void thud_tui_save(struct thud_tui *tui, const char *path, bool sure);
void thud_tui_open(struct thud_tui *tui, const char *name, bool sure);
void thud_tui_new(struct thud_tui *tui, bool sure); /* the form of a new scene */
/* Whether the question is what becomes of unsaved changes. */
bool thud_tui_asks_to_save(const struct thud_tui *tui);
void thud_tui_quit(struct thud_tui *tui, bool sure);
void thud_tui_offer_recovery(struct thud_tui *tui);
void thud_tui_sweep_typed(struct thud_tui *tui, const char *text); /* view_sweep.c */
void thud_tui_sweep_word(struct thud_tui *tui, const char *word, const char *text);
void thud_tui_filter_records(struct thud_tui *tui, const char *text); /* view_record.c */
void thud_tui_help_typed(struct thud_tui *tui, const char *text);     /* view_help.c */
void thud_tui_list_presets(struct thud_tui *tui);
/* Shows the screen on which a key of the scene stands, with the cursor on it. */
void thud_tui_go_to_field(struct thud_tui *tui, const char *key);
void thud_tui_list_fields(struct thud_tui *tui);
void thud_tui_fill_fields(struct thud_tui *tui); /* the lines of that list, without showing it */

/* act.c: the chart of the screen shown, with the cursor that reads it. */
struct thud_chart thud_tui_reading(struct thud_tui *tui);

/* remarks.c: on the scene as written; a list with what the result rests on, each line of which leads to its field. */
int thud_tui_count_remarks(const struct thud_tui *tui);
void thud_tui_list_remarks(struct thud_tui *tui);
const char *thud_tui_cannot_list_remarks(const struct thud_tui *tui); /* NULL: it can be shown */

/* view_plots.c */
void thud_tui_show_impact(struct thud_tui *tui, enum thud_live_which which, int contact, double time_s);
void thud_tui_show_time(struct thud_tui *tui, double time_s);
void thud_tui_show_floor(struct thud_tui *tui, int structure, int floor); /* from 0 */

/* command.c */
void thud_tui_command(struct thud_tui *tui, const char *text);
void thud_tui_commands_text(struct thud_text *out); /* ":word arguments" a line */

/* picture.c */
/* What a figure is drawn as to be shown on this terminal; no size where it shows none. */
struct thud_picture_screen thud_tui_picture_screen(struct thud_tui *tui);
void thud_tui_show_picture(struct thud_tui *tui, const struct thud_text *picture); /* until the next key */
void thud_tui_leave_picture(struct thud_tui *tui);

/* output.c */
const char *thud_tui_folder(const struct thud_tui *tui); /* where pictures and tables go */
/* A name for files of the scene as it is, without a suffix: preset, what it is, the case where it is of one, the gap. No
 * file that thud did not write has it. */
void thud_tui_file_name(struct thud_tui *tui, const char *what, const char *of_case, char *name, size_t size);
/* Shows the figure of this name on the screen; false: it has none. */
bool thud_tui_show_figure(struct thud_tui *tui, const char *name);
void thud_tui_picture(struct thud_tui *tui);
void thud_tui_pictures(struct thud_tui *tui);
void thud_tui_run_pictures(struct thud_tui *tui); /* of the live cases, run again where the histories are missing */
typedef struct thud_figure *thud_tui_figure_fn(const void *from, int index);
/* Writes figures that `make` makes, one after the other, while the screens go on. */
void thud_tui_figures(struct thud_tui *tui, int count, thud_tui_figure_fn *make, const void *from);
void thud_tui_writing_look(struct thud_tui *tui); /* says so when the figures are written */
void thud_tui_writing_end(struct thud_tui *tui);  /* stops, and waits for it */
void thud_tui_export(struct thud_tui *tui);
void thud_tui_copy(struct thud_tui *tui); /* the focused pane's numbers to the clipboard */
/* Writes `text` into the folder under this name, clears it, and says what came of it; false: it could not. */
bool thud_tui_write(struct thud_tui *tui, struct thud_text *text, const char *name);

/* frame.c */
void thud_tui_draw(struct thud_tui *tui);
struct thud_rect thud_tui_area(const struct thud_tui *tui); /* what the panes of the screen share */
bool thud_tui_one_pane(const struct thud_tui *tui);    /* so small that the pane with the cursor has all the room */
int thud_tui_tab_at(struct thud_tui *tui, int column); /* the screen whose name stands there; -1: none */
bool thud_tui_too_small(struct thud_tui *tui);         /* the terminal, for any screen */
/* Three significant digits, `.` where there is no number. Returns `text`. */
char *thud_tui_number(double value, char text[24]);

#endif
