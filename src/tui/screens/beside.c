#include "tui/screens/beside.h"

#include <stdio.h>
#include <string.h>

#include "tui/document/session_log.h"

const char *thud_beside_part(const struct thud_scene *scene, int pair)
{
    return scene->interface[pair].has_bumper ? "bumper" : "contact";
}

const struct thud_law *thud_beside_of(const struct thud_scene *scene, int pair)
{
    const struct thud_interface *at = &scene->interface[pair];
    return at->has_bumper ? at->bumper.law : at->contact.law;
}

static enum thud_status set(struct thud_scene *scene, int pair, const char *name, const char *value,
                            struct thud_error *err)
{
    char key[THUD_PATH_MAX];
    snprintf(key, sizeof key, "interfaces.%d.%s.%s", pair + 1, thud_beside_part(scene, pair), name);
    return thud_scene_set(scene, key, value, err);
}

enum thud_status thud_beside_scene(const struct thud_beside *beside, const struct thud_scene *scene, int pair,
                                   struct thud_scene *out, struct thud_error *err)
{
    *out = *scene;
    enum thud_status status = set(out, pair, "law", beside->law, err);
    for (int i = 0; i < beside->n && status == THUD_OK; i++)
        status = set(out, pair, beside->own[i].name, beside->own[i].value, err);
    return status;
}

/* Replaces the value of a parameter; false where it is not one of the law's. */
static bool note(struct thud_beside *beside, const char *name, const char *value)
{
    const struct thud_law *law = thud_law_find(beside->law);
    int i = 0;
    if (!law || thud_law_param(law, name) < 0)
        return false;
    while (i < beside->n && strcmp(beside->own[i].name, name) != 0)
        i++;
    if (i == beside->n)
        beside->n++;
    snprintf(beside->own[i].name, sizeof beside->own[i].name, "%s", name);
    snprintf(beside->own[i].value, sizeof beside->own[i].value, "%s", value);
    return true;
}

void thud_tui_beside(struct thud_tui *tui, const char *words)
{
    struct thud_beside next = thud_contact_state(tui)->beside;
    struct thud_scene with;
    struct thud_error err;
    char name[40];
    size_t n = strcspn(words, " ");
    const char *value = words + n + strspn(words + n, " ");
    snprintf(name, sizeof name, "%.*s", (int)n, words);
    if (!*name) {
        thud_tui_choose_beside(tui);
        return;
    }
    if (tui->interface + 1 >= tui->doc.scene.nstructures) {
        thud_tui_say(tui, THUD_ROLE_WARN, "There is no interface");
        return;
    }
    if (!*value) {
        next = (struct thud_beside){.n = 0};
        snprintf(next.law, sizeof next.law, "%s", strcmp(name, "none") == 0 ? "" : name);
    } else if (!note(&next, name, value)) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "! %s",
                     !*next.law ? "no law lies beside: :beside LAW first" : "the law beside has no such parameter");
        return;
    }
    if (*next.law && thud_beside_scene(&next, &tui->doc.scene, tui->interface, &with, &err) != THUD_OK) {
        thud_tui_say_error(tui, &err);
        return;
    }
    thud_contact_state(tui)->beside = next;
    thud_contact_state(tui)->revision = 0;
    thud_tui_log(tui, "beside %s", words);
    if (*next.law)
        thud_tui_say(tui, THUD_ROLE_GOOD, "%s lies beside, dashed; its values stand below the form", next.law);
    else
        thud_tui_say(tui, THUD_ROLE_PLAIN, "No law lies beside");
}

void thud_tui_choose_beside(struct thud_tui *tui)
{
    thud_tui_choose(tui, thud_tui_beside, "A law to lay beside");
    thud_chooser_add(&tui->dialog.chooser, "none", "%-28s", "none");
    for (int i = 0; i < thud_law_count(); i++) {
        const struct thud_law *law = thud_law_at(i);
        if (!(law->flags & (THUD_LAW_NO_FORCE | THUD_LAW_IMPULSIVE)))
            thud_chooser_add(&tui->dialog.chooser, law->name, "%-28s %s", law->name, law->title);
    }
    thud_chooser_mark(&tui->dialog.chooser,
                      *thud_contact_state(tui)->beside.law ? thud_contact_state(tui)->beside.law : "none");
}
