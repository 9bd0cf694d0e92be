/* What the screens share: the document that is open, what is run of it, the fields under the cursor, what is asked over
 * the screen, and what they may ask for. A screen knows this and the widgets, never another screen. */
#pragma once

#include "app/run/live_cases.h"
#include "plot/figure/figure.h"
#include "tui/document/base.h"
#include "tui/document/browse.h"
#include "tui/document/doc.h"
#include "tui/document/keys.h"
#include "tui/document/picture_work.h"
#include "tui/tui.h"
#include "tui/widgets/chart.h"
#include "tui/widgets/chooser.h"
#include "tui/widgets/form.h"
#include "tui/widgets/line.h"

enum thud_screen {
#define THUD_SCREEN(name, title) THUD_SCREEN_##name,
#include "tui/document/screen_list.h"
#undef THUD_SCREEN
    THUD_SCREENS
};

enum { THUD_PANES_MAX = 6, THUD_HISTORY = 50 };
struct thud_rect {
    int x, y, w, h;
};

/* What becomes of an action that a screen was offered. */
enum thud_reaction {
    THUD_NOT_MINE, /* the loop does what it does on every screen */
    THUD_DONE,     /* the screen is drawn again, and run again where the scene changed */
    THUD_LEAVE     /* the screen before is shown */
};

/* A screen: its panes, how they share the area, what each draws, its own actions and its own state. All but the first
 * eight may be left out. */
struct thud_view {
    const char *title;
    int where;        /* its bit in the key table */
    bool compares;    /* it shows what the scene is compared with, beside the result in one line */
    bool moved;       /* its figures are of the scene's ground motion */
    bool many;        /* and of many gaps */
    const char *keys; /* its fields are those of the scene that begin with one of these; the longest that fits holds */
    /* How many panes there are in `area`, and where. Called again whenever the size changed. */
    int (*layout)(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane);
    /* Draws pane `index` (its frame's inside) and registers its fields; returns the rows it would need. */
    int (*draw)(struct thud_tui *tui, int index, struct thud_pane *pane);
    void (*pane_title)(struct thud_tui *tui, int index, char *text, size_t size);
    size_t size;                         /* of its own state, all 0 for every preset that is opened; */
    void (*begin)(struct thud_tui *tui); /* what it begins with then, and */
    void (*free)(struct thud_tui *tui);  /* what is freed before */
    /* The bit that holds now, where it depends on the pane with the cursor. */
    int (*place)(const struct thud_tui *tui);
    enum thud_reaction (*act)(struct thud_tui *tui, enum thud_action action);
    /* Why an action of its own cannot be done now; NULL: it can. */
    const char *(*cannot)(struct thud_tui *tui, enum thud_action action);
    /* A command of the `:` line that is its own (command_list.h), or one that it offers. */
    void (*command)(struct thud_tui *tui, const char *word, const char *rest);
    /* Adds what can be found on it to the list of everything: thud_tui_offer. */
    void (*offer)(struct thud_tui *tui);
    /* Enter on a line that can be chosen. */
    void (*row)(struct thud_tui *tui, const struct thud_field *field);
    /* What the lower lines say of that line; NULL: nothing. */
    const char *(*hint)(const struct thud_field *field);
    /* The figure on show, for PNG and CSV; NULL where there is none, and the next one. */
    const struct thud_figure *(*figure)(struct thud_tui *tui);
    void (*next_figure)(struct thud_tui *tui);
    /* The panel of it in which a cursor reads values; NULL where there is none now. */
    const struct thud_panel *(*read)(struct thud_tui *tui);
    /* The cursor was put to x of the chart drawn. */
    void (*read_at)(struct thud_tui *tui, double x);
    /* A click into a pane where no field and no chart is, with its place in the pane. */
    void (*click)(struct thud_tui *tui, int index, const struct thud_pane *pane, int x, int y);
    /* The mouse was moved with its button down, in pane `index`; false: it means nothing there. */
    bool (*drag)(struct thud_tui *tui, int index, int columns);
    /* Enter on that panel with the cursor in it; false: nothing can be done with what it reads. */
    bool (*take)(struct thud_tui *tui);
    /* What it needs of the live cases' motions. */
    enum thud_live_history (*history)(const struct thud_tui *tui);
    /* Called while it is shown and nothing else is computed, so that what it shows follows the scene. */
    void (*live)(struct thud_tui *tui);
    /* Work of its own in slices of about a millisecond: `busy` says whether there is any, `work` does a piece (false:
     * none was left). */
    bool (*busy)(struct thud_tui *tui);
    bool (*work)(struct thud_tui *tui);
    /* What the lower lines say where the cursor is on no field. */
    void (*words)(struct thud_tui *tui, char *text, size_t size);
    /* Time until `tick` has to be called, s; negative: never. */
    double (*pause)(struct thud_tui *tui);
    void (*tick)(struct thud_tui *tui);
    double (*progress)(struct thud_tui *tui); /* of its own work, 0 to 1; negative where it has none */
    /* Its own figures, beside those of the live cases: how many there are now, and one of them made. */
    int (*figures)(struct thud_tui *tui);
    struct thud_figure *(*make)(struct thud_tui *tui, int index);
    void (*export_csv)(struct thud_tui *tui); /* in place of the figure's data */
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

/* What stands over the screen and takes the keys. */
enum thud_mode { THUD_MODE_NORMAL, THUD_MODE_TYPING, THUD_MODE_CHOOSING, THUD_MODE_ASKING, THUD_MODE_OVER };

/* A line that is typed: what stands before it (NULL: `target`), and what becomes of it. */
struct thud_prompt {
    const char *words;
    bool commands, files; /* Up and Down: lines typed before; Tab completes words and files */
    void (*done)(struct thud_tui *tui, const char *text);
};
/* A question: what is done at `y`, with the target it was asked about. */
struct thud_question {
    bool enter;   /* Enter is yes too */
    bool unsaved; /* it is what becomes of unsaved changes: `s` saves them before */
    void (*yes)(struct thud_tui *tui, const char *target);
};
/* A form over the screen that takes all keys. */
struct thud_over {
    int where;   /* its bit in the key table */
    size_t size; /* of its own state, all 0 at first */
    bool whole;  /* it draws from whole histories */
    void (*key)(struct thud_tui *tui, int key);
    void (*draw)(struct thud_tui *tui, const struct thud_pane *area);
    struct thud_line *(*line)(struct thud_tui *tui); /* what is being typed in it; NULL: nothing ever is */
    void (*free)(struct thud_tui *tui);              /* what its state holds */
    bool (*busy)(const struct thud_tui *tui);        /* work of its own in slices, as a screen has; NULL: none */
    void (*work)(struct thud_tui *tui);
};
typedef void thud_chosen_fn(struct thud_tui *tui, const char *value);

struct thud_dialog {
    enum thud_mode mode;
    const struct thud_prompt *prompt;                  /* NULL: the field `target` is typed */
    thud_chosen_fn *chosen;                            /* of the list; NULL: nothing is done */
    const struct thud_question *question, *after_save; /* the second: asked, and to be done once it is saved */
    const struct thud_over *over;
    void *own;             /* the form's */
    enum thud_action next; /* what a list, a form or a command asks the loop for, once the key is taken; or NOTHING */
    char target[512], after_target[512];
    struct thud_line line;
    struct thud_chooser chooser;
    char command[THUD_HISTORY][THUD_LINE_MAX]; /* (ncommands) typed so far, the oldest first */
    int ncommands, at;
};

/* The three cases of the scene, run whenever what they depend on changed. */
struct thud_running {
    struct thud_live live;
    bool on, usual;              /* edits run at once: now, and for every preset that is opened */
    bool was_running;            /* at the last look */
    double started_s, elapsed_s; /* of the run */
    double plain_s;              /* what the last one without histories took */
    unsigned long revision;      /* what the live cases belong to; 0: nothing */
    int design;                  /* number of the one that was run last; 0: none */
    char stepped[THUD_PATH_MAX]; /* the key that is being stepped, to this revision, */
    unsigned long stepped_to;
    bool stepping;      /* and was before: changes are compared with what was before the first step */
    unsigned long seen; /* the document's, when it was last followed, and the histories wanted then */
    enum thud_live_history seen_history;
    struct thud_model *model; /* of the scene where no run has one; NULL: none */
    unsigned long model_of;   /* what it belongs to */
};

/* A name that files were written under. */
enum { THUD_WROTE_MAX = 64 };
struct thud_wrote {
    char stem[420];
    unsigned long long digest; /* of times, sizes and contents as they were written; 0: not written yet */
};

/* A figure that a command made, of the scene of that revision. */
struct thud_made {
    struct thud_figure *figure;
    unsigned long revision;
};

/* Figures and tables that are written. */
struct thud_files {
    struct thud_made made[THUD_PICTURES_MAX]; /* (nmade) */
    int nmade;
    unsigned long arrived, asked_for;        /* how many came so far; the revision that the command runs with */
    char folder[512];                        /* empty: as given at the start */
    struct thud_wrote wrote[THUD_WROTE_MAX]; /* (nwrote) the last ones; the oldest gives way */
    int nwrote;
    char marked[1024];                 /* screen and name of figures, likewise */
    struct thud_picture_work *work;    /* figures being written; NULL: none */
    struct thud_command_work *command; /* a command that runs; NULL: none */
    int done, count;                   /* as last looked at */
    int screen;                        /* on which that was asked for */
    enum thud_image picture;           /* one covers the screen, in this way, until the next key */
    char written[700];                 /* what is written then */
    bool pictures_wanted;              /* once the run has its histories */
    char for_report[512];              /* the folder of figures drawn for the report; empty: there is none */
    bool report_wanted;                /* its form, once they are drawn */
    enum thud_action whole_wanted;     /* what is done once it has them whole: PICTURE or EXPORT */
};

/* What another screen is to show: an impact, or a floor. */
struct thud_look_at {
    bool wanted, impact;
    enum thud_live_which which;
    int contact, structure, floor; /* from 0 */
    double time_s;
};

struct thud_tui {
    struct thud_tui_options options;
    struct thud_backend *backend;
    struct thud_canvas canvas;
    struct thud_doc doc;
    struct thud_running run;
    struct thud_designs designs; /* what was run so far */
    struct thud_base base;       /* the state that changes are compared with */
    struct thud_form form;
    struct thud_dialog dialog;
    struct thud_files files;
    struct thud_text messages;                      /* what was done, as `:COMMAND`, and said; the oldest first */
    const struct thud_view *view[THUD_SCREENS + 1]; /* (screens) */
    void *own[THUD_SCREENS + 1];                    /* the state of each */
    int screens, screen, before;                    /* how many, the one shown, and the one shown before */
    int interface;                                  /* the interface shown on Model and Contact, from 0 */
    struct thud_look_at look_at;
    struct {
        double before_n; /* F(delta_u) before a change of the exponent; NaN: none */
        int interface;
    } kept;
    struct {
        char text[640];
        enum thud_role role;
        enum thud_status status; /* of an error */
    } said;
    struct {
        char text[320]; /* the result in one line, as last known */
        int role;
    } verdict;
    struct thud_chart_frame chart;    /* where the chart that is read stands; no cells: there is none */
    double reading[THUD_SCREENS + 1]; /* x of the cursor that reads a screen's chart; NaN: it is not there */
    struct thud_chart_window window[THUD_SCREENS + 1]; /* what is shown of it */
    int dragged_x;                                     /* the column where the mouse was, while its button is down */
    int key;                                           /* the last one */
    bool grabbed, again; /* the button went down on a field; the key is the one before it: held, or the mouse drags */
    bool mouse;
    int taken[THUD_ACTIONS +
              THUD_SCREENS]; /* how often an action was done, and a screen gone to: newcomers' next steps */
    double busy_since_s;     /* a study or files; 0: nothing is being made */
    struct {
        bool wanted;         /* the screen must be drawn, */
        bool now;            /* at once: a case has ended, */
        unsigned long edits; /* and was of this state and screen */
        int screen;
        double drawn_s; /* when it was */
    } redraw;
    struct {
        bool quit, hangup, interrupted;
        bool playing;               /* a session: what is unsaved is not asked about */
        bool keeps, keeping_failed; /* unsaved edits are kept in a file after each; that it failed was said */
        unsigned long kept_edits;   /* those of the document when they were last kept */
    } end;
};

static inline const struct thud_view *thud_tui_view(const struct thud_tui *tui)
{
    return tui->view[tui->screen];
}

/* "no pounding", ... of this scene. */
static inline const char *thud_tui_case_name(const struct thud_tui *tui, enum thud_live_which which)
{
    return thud_live_name(thud_scene_measures(&tui->doc.scene), which);
}

/* ask.c: the only place that changes what is said, what is asked, and whether the screen is drawn. */
void thud_tui_say(struct thud_tui *tui, enum thud_role role, const char *fmt, ...) THUD_PRINTF(3, 4);
void thud_tui_say_error(struct thud_tui *tui, const struct thud_error *err);
/* Returns whether something succeeded; else says its error. */
bool thud_tui_succeeded(struct thud_tui *tui, enum thud_status status, const struct thud_error *err);
/* An error in the terminal's words, what is quoted of a long text shortened. */
const char *thud_tui_error_text(const struct thud_error *err, char *text, size_t size);
void thud_tui_hush(struct thud_tui *tui);
void thud_tui_keep_message(struct thud_tui *tui, const char *before, const char *text); /* in the list of messages */
void thud_tui_redraw(struct thud_tui *tui, bool now);
void thud_tui_drawn(struct thud_tui *tui);
void thud_tui_normal(struct thud_tui *tui); /* nothing stands over the screen */
void thud_tui_prompt(struct thud_tui *tui, const struct thud_prompt *prompt, const char *text);
void thud_tui_type(struct thud_tui *tui, const char *key, const char *text, bool select); /* a field */
bool thud_tui_types_field(const struct thud_tui *tui);
/* A list; its lines are added after it. */
void thud_tui_choose(struct thud_tui *tui, thud_chosen_fn *chosen, const char *title);
void thud_tui_chosen(struct thud_tui *tui); /* the marked line is taken */
void thud_tui_ask(struct thud_tui *tui, const struct thud_question *question, const char *target, const char *fmt, ...)
    THUD_PRINTF(4, 5);
/* Its state, new; NULL: there is no memory for it, which was said. */
void *thud_tui_over(struct thud_tui *tui, const struct thud_over *over);
void thud_tui_over_free(struct thud_tui *tui);
/* A line of the list of everything, which gives a command to a screen. */
void thud_tui_offer(struct thud_tui *tui, int screen, const char *command, const char *fmt, ...) THUD_PRINTF(4, 5);

/* ask.c: where the cursor is. */
void thud_tui_go(struct thud_tui *tui, int screen);
/* Shows the screen on which a key of the scene stands, with the cursor on it. */
void thud_tui_go_to_field(struct thud_tui *tui, const char *key);
struct thud_rect thud_tui_area(const struct thud_tui *tui); /* what the panes of the screen share */
bool thud_tui_one_pane(const struct thud_tui *tui); /* so small that the pane with the cursor has all the room */
bool thud_tui_too_small(struct thud_tui *tui);      /* the terminal, for any screen */
enum { THUD_LEAST_WIDTH = 40, THUD_LEAST_HEIGHT = 10, THUD_DESIGN_WIDTH = 80, THUD_DESIGN_HEIGHT = 24 };
/* The chart of the screen shown, with the cursor that reads it; what is shown of it follows the cursor. */
struct thud_chart thud_tui_reading(struct thud_tui *tui, double cursor);
/* Three significant digits, `.` where there is no number. Returns `text`. */
char *thud_tui_number(double value, char text[24]);

/* running.c */
void thud_tui_opened(struct thud_tui *tui); /* another preset stands in the document */
/* Runs again where the scene or what is shown of it changed, and edits run at once. What reads the ground motion after
 * a change calls it first. */
void thud_tui_follow(struct thud_tui *tui);
void thud_tui_run(struct thud_tui *tui);
void thud_tui_forget_made(struct thud_tui *tui); /* the figures of commands */
void thud_tui_forget_run(struct thud_tui *tui);  /* its runs look at the ground motion, which goes */
bool thud_tui_cancel(struct thud_tui *tui);      /* false: nothing was running */
/* The model of the scene as it is written; NULL: it cannot be assembled. */
const struct thud_model *thud_tui_model(struct thud_tui *tui);
/* The cases to compare with; NULL: none, or not there yet. */
const struct thud_live *thud_tui_compared(const struct thud_tui *tui);
/* Whether some number of the live cases is still that of before the last change. */
bool thud_tui_shows_old(const struct thud_tui *tui);
enum thud_live_history thud_tui_wants_history(const struct thud_tui *tui);

/* scene_edit.c: values; more than one value: scene_edit.h */
bool thud_tui_set(struct thud_tui *tui, const char *key, const char *text);      /* with messages and warnings */
bool thud_tui_set_step(struct thud_tui *tui, const char *key, const char *text); /* one more step of a value */
/* Another ground motion, as recorded; false where it cannot be found or read: the one there is stays. */
bool thud_tui_choose_record(struct thud_tui *tui, const char *file);
/* What was typed, with the shown unit of the key where it has none. */
void thud_tui_with_unit(const struct thud_tui *tui, const char *key, const char *typed, struct thud_text *text);
void thud_tui_shown_unit(const struct thud_tui *tui, const char *key, char *unit, size_t size);

/* writing.c */
const char *thud_tui_folder(const struct thud_tui *tui); /* where pictures and tables go */
/* A name for files of the scene as it is, without a suffix: preset, what it is, the case where it is of one, the gap.
 * No file that thud did not write has it. */
void thud_tui_file_name(struct thud_tui *tui, const char *what, const char *of_case, char *name, size_t size);
struct thud_shelved {
    struct thud_figure *figure;
    int screen; /* whose it is */
};
/* Takes figures over (at most THUD_PICTURES_MAX), and writes one after the other while the screens go on. */
void thud_tui_figures(struct thud_tui *tui, const struct thud_shelved *item, int count);
/* Likewise, as SVG into a folder of their own; then the report is asked for. */
void thud_tui_figures_of_report(struct thud_tui *tui, const struct thud_shelved *item, int count);
void thud_tui_picture_of(struct thud_tui *tui, const struct thud_figure *figure); /* one, copied */
void thud_tui_writing_look(struct thud_tui *tui); /* says so when the figures are written */
void thud_tui_writing_end(struct thud_tui *tui);  /* stops, and waits for it */
/* Writes `text` into the folder under this name, clears it, and says what came of it; false: it could not. */
bool thud_tui_write(struct thud_tui *tui, struct thud_text *text, const char *name);

/* picture.c */
/* A figure's title, without the scene's before it. */
const char *thud_tui_figure_title(const struct thud_tui *tui, const struct thud_figure *figure);
/* What a figure is drawn as to be shown on this terminal; no size where it shows none. */
struct thud_picture_screen thud_tui_picture_screen(struct thud_tui *tui);
void thud_tui_show_picture(struct thud_tui *tui, const struct thud_text *picture); /* until the next key */
void thud_tui_leave_picture(struct thud_tui *tui);
