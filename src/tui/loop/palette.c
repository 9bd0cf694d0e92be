/* Everything that can be gone to or done, in one list: what fits the letters typed is taken with Enter. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tui/loop/loop.h"

/* Moves need no list. */
static bool moves(enum thud_action action)
{
    return (action >= THUD_DO_NEXT_PANE && action <= THUD_DO_LAST) || action == THUD_DO_FIND;
}

/* With the key and, where it cannot be done now, the reason. */
static void offer_actions(struct thud_tui *tui, int where)
{
    for (int i = 0; i < thud_key_count(); i++) {
        const struct thud_key_entry *key = thud_key_at(i);
        if (!(key->where & where) || thud_key_action(where, key->key) != key->action || moves(key->action))
            continue;
        char value[32];
        const char *why = thud_tui_cannot(tui, key->action);
        snprintf(value, sizeof value, "a %d", (int)key->action);
        thud_chooser_add(&tui->dialog.chooser, value, "key %-6s %s%.50s%s%s", key->written, why ? "(" : "",
                         why ? why : "", why ? ") " : "", key->help);
    }
}

static void offer_commands(struct thud_tui *tui)
{
    struct thud_text words = {0};
    thud_commands_text(&words);
    char *rest = words.data;
    for (char *line; rest && (line = strtok_r(rest, "\n", &rest)) != NULL;)
        thud_chooser_add(&tui->dialog.chooser, line, "command %s", line);
    thud_text_clear(&words);
}

static void offer_presets(struct thud_tui *tui)
{
    struct thud_browse files = {0};
    thud_browse_list(&files, THUD_BROWSE_PRESETS, tui->doc.paths, tui->doc.path, "");
    for (int i = 0; i < files.n; i++) {
        char value[sizeof tui->dialog.chooser.choice->value];
        if (!files.item[i].folder && snprintf(value, sizeof value, "o %s", files.item[i].name) < (int)sizeof value)
            thud_chooser_add(&tui->dialog.chooser, value, "preset %s", files.item[i].name);
    }
    thud_browse_clear(&files);
}

/* ":word arguments": done at once where nothing has to follow, else typed on. */
static void take_command(struct thud_tui *tui, const char *line)
{
    char word[64];
    size_t n = strcspn(line, " ");
    snprintf(word, sizeof word, "%.*s ", (int)n - 1, line + 1);
    if (line[n] && line[n + 1] && line[n + 1] != '[')
        thud_tui_command_line(tui, word);
    else
        thud_tui_command(tui, word);
}

/* "6 line 2": a command that a screen offered. */
static void take_offer(struct thud_tui *tui, int screen, const char *rest)
{
    char word[32];
    snprintf(word, sizeof word, "%.*s", (int)strcspn(rest, " "), rest);
    rest += strlen(word);
    thud_tui_go(tui, screen);
    tui->view[screen]->command(tui, word, rest + (*rest == ' '));
}

static void chosen(struct thud_tui *tui, const char *value)
{
    const char *rest = value + 1 + (value[1] == ' ');
    const int number = atoi(rest);
    if (*value == ':')
        take_command(tui, value);
    else if (value[1] != ' ')
        thud_tui_go_to_field(tui, value);
    else if (*value == 'a')
        tui->dialog.next = (enum thud_action)number;
    else if (*value == 's')
        thud_tui_go(tui, number);
    else if (*value == 'v')
        thud_tui_go_to_design(tui, rest);
    else if (*value == 'o')
        thud_tui_open(tui, rest, false);
    else
        take_offer(tui, *value - '0', rest);
}

void thud_tui_palette(struct thud_tui *tui)
{
    int where = thud_tui_where(tui);
    thud_tui_choose(tui, chosen, "");
    thud_tui_fill_fields(tui);
    tui->dialog.chooser.fuzzy = true;
    snprintf(tui->dialog.chooser.title, sizeof tui->dialog.chooser.title, "Find anything");
    for (int i = 0; i < tui->screens; i++) {
        char value[32];
        snprintf(value, sizeof value, "s %d", i);
        thud_chooser_add(&tui->dialog.chooser, value, "screen %-25s %d", tui->view[i]->title, i + 1);
    }
    offer_actions(tui, where);
    offer_commands(tui);
    offer_presets(tui);
    for (int i = 0; i < tui->designs.n; i++) {
        const struct thud_design *d = &tui->designs.item[i];
        char value[48], name[40];
        snprintf(value, sizeof value, "v %s", thud_design_called(d, name));
        thud_chooser_add(&tui->dialog.chooser, value, "design %s  %s", name, d->what);
    }
    for (int i = 0; i < tui->screens; i++)
        if (tui->view[i]->offer)
            tui->view[i]->offer(tui);
}
