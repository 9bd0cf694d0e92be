/* The command line within: the same words as outside. */
#include <stdio.h>
#include <string.h>

#include "base/nearest.h"
#include "tui/scene_edit.h"
#include "tui/state.h"

struct command {
    const char *word, *short_word, *usage;
    void (*run)(struct thud_tui *tui, char *rest);
    const char *key; /* what is said is its value; NULL: `run` takes it */
};

/* "gap 5 cm", "gap=5cm" and "gap = 5 cm" are the same. */
static void run_set(struct thud_tui *tui, char *rest)
{
    char *key = rest;
    size_t n = strcspn(rest, " =");
    if (n == 0 || !rest[n]) {
        thud_tui_say(tui, THUD_ROLE_WARN, "set KEY VALUE: for example  set gap 5 cm");
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
    else
        thud_tui_say(tui, THUD_ROLE_PLAIN, "The scene is now that of case %s (u undoes)", rest);
    thud_tui_changed(tui);
}

static void run_run(struct thud_tui *tui, char *rest)
{
    (void)rest;
    thud_tui_run(tui);
}

static void run_open(struct thud_tui *tui, char *rest)
{
    if (*rest)
        thud_tui_open(tui, rest, false);
    else
        thud_tui_list_presets(tui);
}

static void run_write(struct thud_tui *tui, char *rest)
{
    thud_tui_save(tui, *rest ? rest : NULL, false);
}

static void run_figures(struct thud_tui *tui, char *rest)
{
    (void)rest;
    thud_tui_act(tui, THUD_DO_PICTURES);
}

/* Where figures and tables go; alone it says so. */
static void run_folder(struct thud_tui *tui, char *rest)
{
    if (*rest)
        snprintf(tui->folder, sizeof tui->folder, "%s", rest);
    thud_tui_say(tui, THUD_ROLE_PLAIN, "Figures and tables go into %s", thud_tui_folder(tui));
}

static void run_live(struct thud_tui *tui, char *rest)
{
    tui->live_on = strcmp(rest, "off") != 0;
    thud_tui_say(tui, THUD_ROLE_PLAIN, tui->live_on ? "Live: every edit runs at once" : "Live is off: r runs");
    thud_tui_changed(tui);
}

static void run_quit(struct thud_tui *tui, char *rest)
{
    thud_tui_quit(tui, *rest == '!');
}

static void run_help(struct thud_tui *tui, char *rest)
{
    (void)rest;
    thud_tui_act(tui, THUD_DO_HELP);
}

/* A line of the study, as `thud sweep` takes it, on its screen; `sweep` alone runs what stands there. */
static void run_vary(struct thud_tui *tui, char *rest)
{
    thud_tui_go(tui, THUD_SCREEN_SWEEP);
    thud_tui_sweep_word(tui, "vary", rest);
}

static void run_cases(struct thud_tui *tui, char *rest)
{
    thud_tui_go(tui, THUD_SCREEN_SWEEP);
    thud_tui_sweep_word(tui, "cases", rest);
}

static void run_records(struct thud_tui *tui, char *rest)
{
    thud_tui_go(tui, THUD_SCREEN_SWEEP);
    thud_tui_sweep_word(tui, "records", rest);
}

static void run_signs(struct thud_tui *tui, char *rest)
{
    thud_tui_go(tui, THUD_SCREEN_SWEEP);
    thud_tui_sweep_word(tui, "signs", rest);
}

static void run_events(struct thud_tui *tui, char *rest)
{
    thud_tui_go(tui, THUD_SCREEN_SWEEP);
    thud_tui_sweep_word(tui, "events", rest);
}

static void run_sweep(struct thud_tui *tui, char *rest)
{
    (void)rest;
    thud_tui_go(tui, THUD_SCREEN_SWEEP);
    thud_tui_act(tui, THUD_DO_RUN);
}

static void run_bench(struct thud_tui *tui, char *rest)
{
    (void)rest;
    thud_tui_go(tui, THUD_SCREEN_BENCH);
    thud_tui_act(tui, THUD_DO_RUN);
}

static const struct command table[] = {
    {"set", "", "KEY VALUE", run_set, NULL},
    {"case", "", "none|bumper|cavity", run_case, NULL},
    {"title", "", "TEXT", NULL, "title"},
    {"record", "", "FILE", NULL, "record.file"},
    {"peak", "", "\"0.821 g\"", NULL, "record.peak"},
    {"sa", "", "ACCELERATION", NULL, "record.sa"},
    {"period", "", "TIME", NULL, "record.period"},
    {"factor", "", "NUMBER", NULL, "record.factor"},
    {"sign", "", "+|-", NULL, "record.sign"},
    {"from", "", "TIME", NULL, "record.from"},
    {"to", "", "TIME", NULL, "record.to"},
    {"dt", "", "TIME", NULL, "record.dt"},
    {"unit", "", "UNIT", NULL, "record.unit"},
    {"channel", "", "NAME", NULL, "record.channel"},
    {"column", "", "N", NULL, "record.column"},
    {"skip", "", "N", NULL, "record.skip"},
    {"method", "", "NAME", NULL, "analysis.method"},
    {"step", "", "TIME", NULL, "analysis.step"},
    {"tolerance", "", "NUMBER", NULL, "analysis.tolerance"},
    {"run", "", "", run_run, NULL},
    {"vary", "", "KEY=FROM:TO:STEP", run_vary, NULL},
    {"cases", "", "CASE,CASE", run_cases, NULL},
    {"records", "", "FILE,DIR,NAME.list", run_records, NULL},
    {"signs", "", "[both]", run_signs, NULL},
    {"events", "", "EVENT,EVENT", run_events, NULL},
    {"sweep", "", "", run_sweep, NULL},
    {"bench", "", "", run_bench, NULL},
    {"figures", "", "", run_figures, NULL},
    {"folder", "", "[DIR]", run_folder, NULL},
    {"open", "o", "PRESET", run_open, NULL},
    {"write", "w", "[FILE]", run_write, NULL},
    {"live", "", "[off]", run_live, NULL},
    {"quit", "q", "[!]", run_quit, NULL},
    {"help", "h", "", run_help, NULL},
};

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
    char text[400] = "";
    for (int i = 0; i < COMMANDS; i++) {
        size_t n = strlen(text);
        words[i] = table[i].word;
        snprintf(text + n, sizeof text - n, "%s%s", i ? ", " : "", words[i]);
    }
    near = thud_nearest(word, words, COMMANDS);
    if (near)
        thud_tui_say(tui, THUD_ROLE_WARN, "! \"%.40s\" is no command; did you mean :%s?", word, near);
    else
        thud_tui_say(tui, THUD_ROLE_WARN, "! \"%.40s\" is no command: %s", word, text);
}

void thud_tui_command(struct thud_tui *tui, const char *text)
{
    char copy[THUD_LINE_MAX], *word = copy;
    snprintf(copy, sizeof copy, "%s", text);
    word += strspn(word, " :");
    size_t n = strcspn(word, " !");
    char *rest = word + n, first[32];
    rest += strspn(rest, " ");
    for (size_t end = strlen(rest); end > 0 && rest[end - 1] == ' '; end--)
        rest[end - 1] = '\0';
    snprintf(first, sizeof first, "%.*s", (int)n, word);
    if (!*first)
        return;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (strcmp(first, table[i].word) == 0 || (*table[i].short_word && strcmp(first, table[i].short_word) == 0)) {
            if (table[i].key)
                thud_tui_set(tui, table[i].key, unquoted(rest));
            else
                table[i].run(tui, rest);
            return;
        }
    list_words(tui, first);
}

void thud_tui_commands_text(struct thud_text *out)
{
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        thud_text_append(out, ":%s %s\n", table[i].word, table[i].usage);
}
