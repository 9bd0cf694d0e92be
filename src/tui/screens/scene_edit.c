#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tui/document/session_log.h"
#include "tui/screens/scene_edit.h"

/* `command`: what a log has for it. */
static void change(struct thud_tui *tui, const struct thud_scene *next, const char *what, const char *command)
{
    struct thud_error err;
    if (thud_doc_change(&tui->doc, next, what, &err) != THUD_OK) {
        thud_tui_say_error(tui, &err);
        return;
    }
    thud_tui_log(tui, "%s", command);
    thud_tui_say(tui, THUD_ROLE_PLAIN, "%s (u undoes)", what);
    int last = tui->doc.scene.nstructures - 2;
    tui->pair = tui->pair > last ? (last > 0 ? last : 0) : tui->pair;
    thud_tui_draw(tui);
    thud_tui_changed(tui);
}

static void move_floors(struct thud_structure *structure, int to, int from, int n)
{
    for (int i = 0; i < THUD_STRUCTURE_LISTS; i++) {
        double *list = thud_structure_list(structure, i);
        memmove(list + to, list + from, (size_t)n * sizeof *list);
    }
}

void thud_tui_add_storey(struct thud_tui *tui, int s, int floor)
{
    struct thud_scene next = tui->doc.scene;
    struct thud_structure *structure = &next.structure[s];
    char what[160];
    if (floor < 1 || floor > structure->storeys)
        floor = structure->storeys;
    move_floors(structure, floor, floor - 1, structure->storeys - floor + 1);
    structure->storeys++;
    snprintf(what, sizeof what, "%s: storey added above floor %d, like it", structure->name, floor);
    char command[64];
    snprintf(command, sizeof command, "storey add %d %d", s + 1, floor);
    change(tui, &next, what, command);
}

void thud_tui_delete_storey(struct thud_tui *tui, int s, int floor)
{
    struct thud_scene next = tui->doc.scene;
    struct thud_structure *structure = &next.structure[s];
    char what[160];
    move_floors(structure, floor - 1, floor, structure->storeys - floor);
    structure->storeys--;
    /* what lies past the top is zero in every scene, so that equal scenes compare equal */
    for (int i = 0; i < THUD_STRUCTURE_LISTS; i++)
        thud_structure_list(structure, i)[structure->storeys] = 0.0;
    snprintf(what, sizeof what, "%s: storey %d deleted", structure->name, floor);
    char command[64];
    snprintf(command, sizeof command, "storey delete %d %d", s + 1, floor);
    change(tui, &next, what, command);
}

/* The first letter no structure is called by. */
static void new_name(const struct thud_scene *scene, char *name)
{
    for (int letter = 'A'; letter <= 'Z'; letter++) {
        bool taken = false;
        for (int i = 0; i < scene->nstructures; i++)
            taken = taken || (scene->structure[i].name[0] == letter && scene->structure[i].name[1] == '\0');
        if (taken)
            continue;
        memset(name, 0, THUD_NAME_MAX);
        name[0] = (char)letter;
        return;
    }
}

/* With more than one interface, keys of the study that stood for the only one have to say so. True: some had to. */
static bool rename_varied(struct thud_scene *scene)
{
    static const char only[] = "interfaces.1.";
    bool renamed = false;
    for (int i = 0; i < scene->study.nvary; i++) {
        char *key = scene->study.vary[i].key, whole[THUD_VARY_KEY + sizeof only] = "";
        int floor;
        snprintf(whole, sizeof whole, "%s%s", only, key);
        if (thud_scene_param(scene, key, &floor) || !thud_scene_param(scene, whole, &floor) ||
            strlen(whole) >= THUD_VARY_KEY)
            continue;
        memcpy(key, whole, strlen(whole) + 1);
        renamed = true;
    }
    return renamed;
}

void thud_tui_add_structure(struct thud_tui *tui, int s)
{
    struct thud_scene next = tui->doc.scene;
    char name[THUD_NAME_MAX] = "", what[160];
    int n = next.nstructures, from = s < n - 1 ? s : n - 2;
    new_name(&next, name);
    memmove(&next.structure[s + 1], &next.structure[s], (size_t)(n - s) * sizeof *next.structure);
    if (from >= 0)
        memmove(&next.interface[from + 1], &next.interface[from], (size_t)(n - 1 - from) * sizeof *next.interface);
    memcpy(next.structure[s + 1].name, name, sizeof name);
    next.nstructures++;
    snprintf(what, sizeof what, "%s added to the right of %s, like it%s", name, next.structure[s].name,
             rename_varied(&next) ? "; the study varies interfaces.1" : "");
    char command[64];
    snprintf(command, sizeof command, "structure add %d", s + 1);
    change(tui, &next, what, command);
}

void thud_tui_remove_structure(struct thud_tui *tui, int s)
{
    struct thud_scene next = tui->doc.scene;
    char what[160];
    int n = next.nstructures, gone = s < n - 1 ? s : n - 2;
    snprintf(what, sizeof what, "%s removed", next.structure[s].name);
    memmove(&next.structure[s], &next.structure[s + 1], (size_t)(n - 1 - s) * sizeof *next.structure);
    memmove(&next.interface[gone], &next.interface[gone + 1], (size_t)(n - 2 - gone) * sizeof *next.interface);
    memset(&next.structure[n - 1], 0, sizeof *next.structure);
    memset(&next.interface[n - 2], 0, sizeof *next.interface);
    next.nstructures--;
    char command[64];
    snprintf(command, sizeof command, "structure remove %d", s + 1);
    change(tui, &next, what, command);
}

void thud_tui_swap(struct thud_tui *tui, int s)
{
    struct thud_scene next = tui->doc.scene;
    char what[160];
    next.structure[s] = tui->doc.scene.structure[s + 1];
    next.structure[s + 1] = tui->doc.scene.structure[s];
    snprintf(what, sizeof what, "%s and %s swapped", next.structure[s + 1].name, next.structure[s].name);
    char command[64];
    snprintf(command, sizeof command, "swap %d", s + 1);
    change(tui, &next, what, command);
}

void thud_tui_toggle_bumper(struct thud_tui *tui, int i)
{
    struct thud_scene next = tui->doc.scene;
    struct thud_interface *interface = &next.interface[i];
    interface->has_bumper = !interface->has_bumper;
    if (interface->has_bumper && !interface->bumper.law) /* there has been none yet: the paper's */
        thud_interface_add_bumper(interface);
    char what[80];
    snprintf(what, sizeof what, "bumper %s", interface->has_bumper ? "off -> on" : "on -> off");
    char command[64];
    snprintf(command, sizeof command, "bumper %d", i + 1);
    change(tui, &next, what, command);
}

void thud_tui_keep_force(struct thud_tui *tui)
{
    struct thud_scene next = tui->doc.scene;
    struct thud_law_choice *bumper = &next.interface[tui->kept_interface].bumper;
    int k = bumper->law ? thud_law_param(bumper->law, "stiffness") : -1;
    double now = thud_tui_force_at_knee(&next, tui->kept_interface), before = tui->kept_before_n;
    if (k < 0 || !(now > 0.0) || !(before > 0.0))
        return;
    bumper->value[k] *= before / now;
    tui->kept_before_n = NAN;
    char command[64];
    snprintf(command, sizeof command, "keep-force");
    change(tui, &next, "stiffness chosen so that F(delta_u) is as before", command);
}

bool thud_tui_change_pair(struct thud_tui *tui, enum thud_action action)
{
    if (action != THUD_DO_NEXT_PAIR && action != THUD_DO_PREVIOUS_PAIR)
        return false;
    tui->pair += action == THUD_DO_NEXT_PAIR ? 1 : -1;
    return true;
}

const char *thud_tui_cannot_change_pair(struct thud_tui *tui, enum thud_action action)
{
    if (action == THUD_DO_NEXT_PAIR)
        return tui->pair + 2 < tui->doc.scene.nstructures ? NULL : "This is the last pair on the right";
    if (action == THUD_DO_PREVIOUS_PAIR)
        return tui->pair > 0 ? NULL : "This is the first pair on the left";
    return NULL;
}
