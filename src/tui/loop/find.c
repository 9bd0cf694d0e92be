/* The list of all fields. */
#include <stdio.h>
#include <string.h>

#include "tui/loop/loop.h"

/* Words that people look for and no title has. */
static const char *also_called(const char *name)
{
    static const struct {
        const char *name, *words;
    } table[] = {{"peak", "PGA"},
                 {"restitution", "COR e"},
                 {"stiffness", "k"},
                 {"gap", "separation distance"},
                 {"damping", "xi zeta"},
                 {"file", "record ground motion accelerogram"},
                 {"factor", "scale"},
                 {"law", "contact model"},
                 {"method", "integrator solver"},
                 {"tail", "duration"},
                 {"mass", "weight"},
                 {"thickness", "rubber"},
                 {"storeys", "floors stories"},
                 {"from", "trim"},
                 {"to", "trim"}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (strcmp(table[i].name, name) == 0)
            return table[i].words;
    return "";
}

static void add_field(struct thud_tui *tui, const char *key, const struct thud_param *param)
{
    char value[96] = "";
    if (thud_scene_get(&tui->doc.scene, key, value, sizeof value, NULL) == THUD_OK)
        thud_chooser_add(&tui->dialog.chooser, key, "%-32s %-18.40s %.50s %s", key, value, param->title,
                         also_called(param->name));
}

/* Adds the parameters of a group under a prefix, those by floor for every floor. */
static void add_group(struct thud_tui *tui, enum thud_group group, const char *prefix, int structure)
{
    const struct thud_param *param;
    const struct thud_structure *at = structure >= 0 ? &tui->doc.scene.structure[structure] : NULL;
    for (int i = 0; (param = thud_group_param(group, i)); i++) {
        char key[THUD_PATH_MAX];
        if (at && group == THUD_GROUP_STRUCTURE && !thud_structure_has(at->kind, i))
            continue;
        snprintf(key, sizeof key, "%s.%s", prefix, param->name);
        bool by_floor = at && thud_scene_by_floor(&tui->doc.scene, key);
        for (int floor = 1; floor <= (by_floor ? at->storeys : 1); floor++) {
            char number[16] = "";
            if (by_floor)
                snprintf(number, sizeof number, ".%d", floor);
            snprintf(key, sizeof key, "%s%s%s%s", prefix, *prefix ? "." : "", param->name, number);
            add_field(tui, key, param);
        }
    }
}

static void add_law(struct thud_tui *tui, const char *prefix, const struct thud_law *law)
{
    for (int i = 0; law && i < law->nparams; i++) {
        char key[THUD_PATH_MAX];
        snprintf(key, sizeof key, "%s.%s", prefix, law->params[i].name);
        add_field(tui, key, &law->params[i]);
    }
}

void thud_tui_fill_fields(struct thud_tui *tui)
{
    const struct thud_scene *scene = &tui->doc.scene;
    char prefix[64];
    thud_chooser_begin(&tui->dialog.chooser, "Find a field");
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        snprintf(prefix, sizeof prefix, "interfaces.%d", i + 1);
        add_group(tui, THUD_GROUP_INTERFACE, prefix, -1);
        snprintf(prefix, sizeof prefix, "interfaces.%d.contact", i + 1);
        add_group(tui, THUD_GROUP_CONTACT, prefix, -1);
        add_law(tui, prefix, scene->interface[i].contact.law);
        if (!scene->interface[i].has_bumper)
            continue;
        snprintf(prefix, sizeof prefix, "interfaces.%d.bumper", i + 1);
        add_group(tui, THUD_GROUP_BUMPER, prefix, -1);
        add_law(tui, prefix, scene->interface[i].bumper.law);
    }
    for (int i = 0; i < scene->nlinks; i++) {
        snprintf(prefix, sizeof prefix, "links.%d", i + 1);
        add_group(tui, THUD_GROUP_LINK, prefix, -1);
    }
    for (int i = 0; i < scene->nstructures; i++) {
        snprintf(prefix, sizeof prefix, "structures.%d", i + 1);
        add_group(tui, THUD_GROUP_STRUCTURE, prefix, i);
        snprintf(prefix, sizeof prefix, "structures.%d.backfill", i + 1);
        if (scene->structure[i].kind == THUD_WALL)
            add_group(tui, THUD_GROUP_BACKFILL, prefix, i);
        if (!thud_kind_is_building(scene->structure[i].kind))
            continue;
        snprintf(prefix, sizeof prefix, "structures.%d.column", i + 1);
        add_group(tui, THUD_GROUP_COLUMN, prefix, i);
        snprintf(prefix, sizeof prefix, "structures.%d.foundation", i + 1);
        add_group(tui, THUD_GROUP_FOUNDATION, prefix, i);
        snprintf(prefix, sizeof prefix, "structures.%d.isolator", i + 1);
        if (scene->structure[i].kind == THUD_ISOLATED)
            add_group(tui, THUD_GROUP_ISOLATOR, prefix, i);
    }
    add_group(tui, THUD_GROUP_SCENE, "", -1);
    add_group(tui, THUD_GROUP_RECORD, "record", -1);
    add_group(tui, THUD_GROUP_ANALYSIS, "analysis", -1);
    add_group(tui, THUD_GROUP_DOCUMENT, "document", -1);
    add_group(tui, THUD_GROUP_STUDY, "study", -1);
}
