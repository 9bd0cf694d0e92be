/* The command line within: the same words as outside. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/run/command.h"
#include "base/ascii.h"
#include "base/nearest.h"
#include "base/scan.h"
#include "tui/document/scene_edit.h"
#include "tui/document/session_log.h"
#include "tui/loop/loop.h"
#include "tui/loop/new_scene.h"

struct command {
    const char *word, *short_word, *usage;
    void (*run)(struct thud_tui *tui, char *rest);
    void (*by_word)(struct thud_tui *tui, const char *word, char *rest); /* of several words */
    const char *key;         /* what is said is its value; NULL: the rest holds */
    enum thud_action action; /* what a key does */
    int screen;              /* whose command it is; -1: none */
    int verb;                /* enum thud_command_id of the command line's; 0: none */
};

/* "gap 5 cm", "gap=5cm" and "gap = 5 cm" are the same. */
static void run_set(struct thud_tui *tui, char *rest)
{
    char *key = rest;
    size_t n = strcspn(rest, " =");
    if (n == 0 || !rest[n]) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "! set KEY VALUE: for example  set gap 5 cm");
        return;
    }
    char *value = rest + n + strspn(rest + n, " =");
    rest[n] = '\0';
    thud_tui_set(tui, key, value);
}

/* The scene becomes that of a case, as `run --case` takes it. */
static void run_case(struct thud_tui *tui, char *rest)
{
    struct thud_scene next;
    struct thud_error err;
    enum thud_case which;
    char what[64];
    snprintf(what, sizeof what, "case %.50s", rest);
    if (thud_case_find(rest, &which, &err) != THUD_OK ||
        thud_scene_case(&tui->doc.scene, which, &next, &err) != THUD_OK ||
        thud_doc_change(&tui->doc, &next, what, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    else {
        thud_tui_log(tui, "case %s", rest);
        thud_tui_say(tui, THUD_ROLE_PLAIN, "The scene is now that of case %s (u undoes)", rest);
    }
}

static void run_run(struct thud_tui *tui, char *rest)
{
    (void)rest;
    thud_tui_run(tui);
}

static void run_open(struct thud_tui *tui, char *rest)
{
    if (*rest)
        thud_tui_open(tui, rest, tui->end.playing);
    else
        thud_tui_list_presets(tui);
}

/* Whether a path has room; it is never shortened to another one. */
static bool fits(struct thud_tui *tui, const char *path)
{
    const size_t most = sizeof tui->files.folder - sizeof ".yaml";
    if (strlen(path) > most)
        thud_tui_say(tui, THUD_ROLE_ERROR, "! the path is too long (at most %zu bytes)", most);
    return strlen(path) <= most;
}

static void run_write(struct thud_tui *tui, char *rest)
{
    if (fits(tui, rest))
        thud_tui_save(tui, *rest ? rest : NULL, false);
}

/* The screen of a name, or of a number. */
static bool go_to(struct thud_tui *tui, const char *name)
{
    for (int i = 0; i < tui->screens; i++) {
        if (thud_ascii_same(tui->view[i]->title, name) || (name[0] == '1' + i && !name[1])) {
            thud_tui_go(tui, i);
            return true;
        }
    }
    thud_tui_say(tui, THUD_ROLE_ERROR, "! there is no screen \"%.40s\"", name);
    return false;
}

static void run_figures(struct thud_tui *tui, char *rest)
{
    if (!*rest || go_to(tui, rest))
        tui->dialog.next = THUD_DO_PICTURES;
}

/* "picture Plots impact-force": the figure of a screen by its name; alone the one on show. */
static void write_one(struct thud_tui *tui, const char *word, char *rest)
{
    char *name = rest + strcspn(rest, " ");
    if (*name)
        *name++ = '\0';
    if (*rest && !go_to(tui, rest))
        return;
    if (*name && !thud_tui_show_figure(tui, name))
        thud_tui_say(tui, THUD_ROLE_ERROR, "! %s has no figure %.60s now", rest, name);
    else
        tui->dialog.next = strcmp(word, "table") == 0 ? THUD_DO_EXPORT : THUD_DO_PICTURE;
}

static void run_screen(struct thud_tui *tui, char *rest)
{
    go_to(tui, rest);
}

static void run_new(struct thud_tui *tui, char *rest)
{
    if (*rest && !tui->end.playing && thud_doc_unsaved(&tui->doc))
        thud_tui_say(tui, THUD_ROLE_ERROR, "! %s has unsaved changes: w saves them first", tui->doc.scene.name);
    else if (*rest)
        thud_new_scene_command(tui, rest);
    else
        thud_tui_new(tui);
}

static void run_log(struct thud_tui *tui, char *rest)
{
    if (*rest)
        thud_tui_save_log(tui, rest);
    else
        thud_tui_show_log(tui);
}

static void edit_scene(struct thud_tui *tui, const char *word, char *rest)
{
    thud_tui_edit_scene(tui, "%s%s%s", word, *rest ? " " : "", rest);
}

static void run_design(struct thud_tui *tui, char *rest)
{
    if (*rest)
        thud_tui_go_to_design(tui, rest);
    else
        thud_tui_list_designs(tui);
}

static void run_keep_force(struct thud_tui *tui, char *rest)
{
    (void)rest;
    if (isfinite(tui->kept.before_n))
        thud_tui_keep_force(tui);
    else
        thud_tui_say(tui, THUD_ROLE_ERROR, "! no exponent was changed: there is no force to keep");
}

static void run_paste(struct thud_tui *tui, char *rest)
{
    char *text = rest + strcspn(rest, " ");
    if (*text)
        *text++ = '\0';
    thud_tui_go_to_field(tui, rest);
    thud_tui_draw(tui);
    thud_tui_paste_line(tui, text);
}

/* Where figures and tables go; alone it says so. */
static void run_folder(struct thud_tui *tui, char *rest)
{
    if (!fits(tui, rest))
        return;
    if (*rest) {
        snprintf(tui->files.folder, sizeof tui->files.folder, "%s", rest);
        thud_tui_log(tui, "folder %s", rest);
    }
    thud_tui_say(tui, THUD_ROLE_PLAIN, "Figures and tables go into %s", thud_tui_folder(tui));
}

static void run_live(struct thud_tui *tui, char *rest)
{
    const bool off = strcmp(rest, "off") == 0;
    if (*rest && !off && strcmp(rest, "on") != 0) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "! live is on or off, not \"%.40s\"", rest);
        return;
    }
    tui->run.on = !off;
    thud_tui_log(tui, off ? "live off" : "live on");
    thud_tui_say(tui, THUD_ROLE_PLAIN, tui->run.on ? "Live: every edit runs at once" : "Live is off: r runs");
}

static void run_quit(struct thud_tui *tui, char *rest)
{
    thud_tui_quit(tui, *rest == '!');
}

static void run_sweep(struct thud_tui *tui, char *rest)
{
    (void)rest;
    thud_tui_go(tui, THUD_SCREEN_SWEEP);
    tui->dialog.next = THUD_DO_RUN;
}

static const struct command table[] = {
#define THUD_RUN(own, alias, says, function)                                                                           \
    {.word = own, .short_word = alias, .usage = says, .run = function, .screen = -1},
#define THUD_BY(own, says, function) {.word = own, .short_word = "", .usage = says, .by_word = function, .screen = -1},
#define THUD_SET(own, usage, of)     {.word = own, .short_word = "", .key = of, .screen = -1},
#define THUD_ACT(own, alias, done)   {.word = own, .short_word = alias, .action = THUD_DO_##done, .screen = -1},
#define THUD_OF(own, usage, of)      {.word = own, .short_word = "", .screen = THUD_SCREEN_##of},
#define THUD_CLI(own, id)            {.word = own, .short_word = "", .verb = THUD_COMMAND_##id, .screen = -1},
#include "tui/document/command_list.h"
};

/* The command of a word, also a short one; NULL: there is none. */
static const struct command *find(const char *word)
{
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (strcmp(word, table[i].word) == 0 || (*table[i].short_word && strcmp(word, table[i].short_word) == 0))
            return &table[i];
    return NULL;
}

/* Quotes that a shell would have taken away. */
static char *unquoted(char *text)
{
    size_t n = strlen(text);
    if (n < 2 || text[0] != '"' || text[n - 1] != '"')
        return text;
    text[n - 1] = '\0';
    return text + 1;
}

static void list_words(struct thud_tui *tui, const char *word)
{
    enum { COMMANDS = sizeof table / sizeof *table };
    const char *words[COMMANDS], *near;
    char text[700] = "";
    for (int i = 0; i < COMMANDS; i++) {
        words[i] = table[i].word;
        thud_append(text, sizeof text, "%s%s", i ? ", " : "", words[i]);
    }
    near = thud_nearest(word, words, COMMANDS);
    if (near)
        thud_tui_say(tui, THUD_ROLE_ERROR, "! \"%.40s\" is not a command; did you mean :%s?", word, near);
    else
        thud_tui_say(tui, THUD_ROLE_ERROR, "! \"%.40s\" is not a command: %s", word, text);
}

/* A key of the scene, as `set` takes it. */
static bool begins_with_key(const struct thud_tui *tui, const char *text)
{
    char key[THUD_VARY_KEY];
    int floor;
    snprintf(key, sizeof key, "%.*s", (int)strcspn(text, " ="), text);
    return thud_scene_param(&tui->doc.scene, key, &floor) != NULL;
}

void thud_tui_command(struct thud_tui *tui, char *text)
{
    char *word = text + strspn(text, " :");
    size_t n = strcspn(word, " !");
    char *rest = word + n, first[32];
    rest += strspn(rest, " ");
    for (size_t end = strlen(rest); end > 0 && rest[end - 1] == ' '; end--)
        rest[end - 1] = '\0';
    snprintf(first, sizeof first, "%.*s", (int)n, word);
    if (!*first) {
        if (*word)
            list_words(tui, word);
        return;
    }
    const struct command *c = find(first);
    const bool of_scene = begins_with_key(tui, word); /* "gap 12 cm", beside the command of that name */
    if (!c && !of_scene && !strchr(first, '.'))
        list_words(tui, first);
    else if (!c || (c->verb && *rest && (*rest != '-' || strchr("0123456789.", rest[1])) && of_scene))
        run_set(tui, word);
    else if (c->key)
        thud_tui_set(tui, c->key, unquoted(rest));
    else if (c->verb && !*rest && !tui->end.playing)
        thud_tui_verb_form(tui, c->verb);
    else if (c->verb)
        thud_tui_verb(tui, c->verb, rest);
    else if (c->run)
        c->run(tui, rest);
    else if (c->by_word)
        c->by_word(tui, first, rest);
    else if (c->screen >= 0) {
        thud_tui_go(tui, c->screen);
        thud_tui_view(tui)->command(tui, first, rest);
    } else
        tui->dialog.next = c->action;
}

static void typed_command(struct thud_tui *tui, const char *text)
{
    char copy[THUD_LINE_MAX];
    snprintf(copy, sizeof copy, "%s", text);
    thud_tui_remember(tui, text);
    thud_tui_command(tui, copy);
}

void thud_tui_command_line(struct thud_tui *tui, const char *text)
{
    static const struct thud_prompt line = {.words = ":", .commands = true, .files = true, .done = typed_command};
    thud_tui_prompt(tui, &line, text);
}
