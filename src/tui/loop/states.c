/* The states of the session: gone to, named (and saved so), compared, forgotten. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tui/document/session_log.h"
#include "tui/loop/loop.h"

/* "#3", or its name. */
static const char *called(const struct thud_tui *tui, const struct thud_variant *v, char text[48])
{
    if (*v->name)
        snprintf(text, 48, "%s", v->name);
    else
        snprintf(text, 48, "#%d", (int)(v - tui->doc.variants.item) + 1);
    return text;
}

void thud_tui_go_to_state(struct thud_tui *tui, const char *name)
{
    const struct thud_variant *v = thud_variants_named(&tui->doc.variants, name);
    struct thud_error err = {0};
    char what[80], text[48];
    if (!v) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "! there is no state \"%.40s\"; U lists them", name);
        return;
    }
    struct thud_scene *next = malloc(sizeof *next);
    enum thud_status status = next ? THUD_OK : thud_error_set(&err, THUD_MEMORY, "no memory for the scene");
    snprintf(what, sizeof what, "state %s", called(tui, v, text));
    if (next) { /* what runs do not depend on stays */
        *next = *v->scene;
        memcpy(next->name, tui->doc.scene.name, sizeof next->name);
        memcpy(next->title, tui->doc.scene.title, sizeof next->title);
        next->study = tui->doc.scene.study;
        status = thud_doc_change(&tui->doc, next, what, &err);
    }
    free(next);
    if (status != THUD_OK) {
        thud_tui_say_error(tui, &err);
        return;
    }
    thud_tui_log(tui, "state %s", name);
    thud_tui_say(tui, THUD_ROLE_GOOD, "This is state %s (u undoes): %s", text, v->solution);
}

/* A preset of that name beside this one, or in the working folder beside one that comes with thud. */
void thud_tui_state_path(const struct thud_tui *tui, const char *name, char *path, size_t size)
{
    const char *slash = strrchr(tui->doc.path, '/');
    bool beside = slash && !thud_doc_is_shipped(&tui->doc, tui->doc.path);
    snprintf(path, size, "%.*s%s.yaml", beside ? (int)(slash - tui->doc.path) + 1 : 0, tui->doc.path, name);
}

static void name_state(struct thud_tui *tui, struct thud_variant *v, const char *name)
{
    struct thud_error err = {0};
    char path[600];
    thud_tui_state_path(tui, name, path, sizeof path);
    struct thud_variant *other = thud_variants_named(&tui->doc.variants, name);
    if (!*name || strlen(name) >= sizeof v->name || strpbrk(name, "/#\\\"'") || (other && other != v) ||
        (!other && access(path, F_OK) == 0)) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "! \"%.40s\": a name that neither a state nor a preset here has", name);
        return;
    }
    if (thud_preset_save(tui->doc.preset, v->scene, path, &err) != THUD_OK) {
        thud_tui_say_error(tui, &err);
        return;
    }
    snprintf(v->name, sizeof v->name, "%s", name);
    thud_tui_say(tui, THUD_ROLE_GOOD, "This state is %s now, and saved as %s", name, path);
}

void thud_tui_name_state(struct thud_tui *tui, const char *name)
{
    struct thud_variant *v = thud_variants_find(&tui->doc.variants, &tui->doc.scene);
    if (!v)
        thud_tui_say(tui, THUD_ROLE_WARN, "This state has not been run yet: r runs it");
    else {
        thud_tui_log(tui, "name %s", name);
        name_state(tui, v, name);
    }
}

static void named(struct thud_tui *tui, const char *text)
{
    struct thud_variant *v = thud_variants_named(&tui->doc.variants, tui->dialog.target);
    if (v && *text)
        name_state(tui, v, text);
}

/* Beside Enter: Tab compares with a state, F2 names it, Delete forgets it. */
static bool list_key(struct thud_tui *tui, int key, const char *value)
{
    static const struct thud_prompt prompt = {.words = "name of the state, and of its preset: ", .done = named};
    struct thud_variant *v = thud_variants_named(&tui->doc.variants, value);
    char name[128];
    snprintf(name, sizeof name, "%s", value);
    if (!v || (key != THUD_KEY_TAB && key != THUD_KEY_F2 && key != THUD_KEY_DELETE))
        return false;
    thud_tui_normal(tui);
    if (key == THUD_KEY_TAB) { /* told against the present one */
        thud_tui_pin(tui);
        thud_tui_go_to_state(tui, name);
    } else if (key == THUD_KEY_F2) {
        snprintf(tui->dialog.target, sizeof tui->dialog.target, "%s", name);
        thud_tui_prompt(tui, &prompt, v->name);
    } else {
        thud_variants_forget(&tui->doc.variants, v);
        thud_tui_list_states(tui);
    }
    return true;
}

/* The state on the screen stands first, also while it is being run or where live is off. */
void thud_tui_list_states(struct thud_tui *tui)
{
    const char *what = thud_undo_what(&tui->doc.undo, 0);
    if (!thud_variants_find(&tui->doc.variants, &tui->doc.scene))
        thud_variants_note(&tui->doc.variants, &tui->doc.scene, what ? what : "as opened",
                           tui->run.live.running ? "running" : "not run yet: r runs");
    const struct thud_variant *now = thud_variants_find(&tui->doc.variants, &tui->doc.scene);
    thud_tui_choose(tui, thud_tui_go_to_state, "States: Enter goes there, Tab compares, F2 names, Del forgets");
    tui->dialog.list_key = list_key;
    for (int k = -1; k < tui->doc.variants.n; k++) {
        const int i = k < 0 ? (now ? (int)(now - tui->doc.variants.item) : -1) : tui->doc.variants.n - 1 - k;
        if (i < 0 || (k >= 0 && &tui->doc.variants.item[i] == now))
            continue;
        const struct thud_variant *v = &tui->doc.variants.item[i];
        char text[48], number[16];
        snprintf(number, sizeof number, "#%d", i + 1);
        thud_chooser_add(&tui->dialog.chooser, number, "%s%-9.9s %-20.20s %.100s", v == now ? "*" : " ",
                         called(tui, v, text), v->what, v->solution);
    }
}
