/* The command line within: the same words as outside. */
#include <stdio.h>
#include <string.h>

#include "tui/scene_edit.h"
#include "tui/state.h"

struct command {
    const char *word, *short_word, *usage;
    void (*run)(struct thud_tui *tui, char *rest);
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

static void run_record(struct thud_tui *tui, char *rest)
{
    thud_tui_set(tui, "record.file", rest);
}

static void run_peak(struct thud_tui *tui, char *rest)
{
    thud_tui_set(tui, "record.peak", rest);
}

static void run_method(struct thud_tui *tui, char *rest)
{
    thud_tui_set(tui, "analysis.method", rest);
}

static void run_tolerance(struct thud_tui *tui, char *rest)
{
    thud_tui_set(tui, "analysis.tolerance", rest);
}

static void run_step(struct thud_tui *tui, char *rest)
{
    thud_tui_set(tui, "analysis.step", rest);
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

static const struct command table[] = {
    {"set", "", "KEY VALUE", run_set},
    {"case", "", "none|bumper|cavity", run_case},
    {"record", "", "FILE", run_record},
    {"peak", "", "\"0.821 g\"", run_peak},
    {"method", "", "NAME", run_method},
    {"step", "", "TIME", run_step},
    {"tolerance", "", "NUMBER", run_tolerance},
    {"run", "", "", run_run},
    {"figures", "", "", run_figures},
    {"open", "o", "PRESET", run_open},
    {"write", "w", "[FILE]", run_write},
    {"live", "", "[off]", run_live},
    {"quit", "q", "[!]", run_quit},
    {"help", "h", "", run_help},
};

static void list_words(struct thud_tui *tui, const char *word)
{
    char text[400] = "";
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        size_t n = strlen(text);
        snprintf(text + n, sizeof text - n, "%s%s", i ? ", " : "", table[i].word);
    }
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
