/* The list of all fields. */
#include <stdarg.h>
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

/* Adds the parameters of a group under a prefix, those by floor of a structure (NULL: of none) for every floor. */
THUD_PRINTF(4, 5)
static void add_group(struct thud_tui *tui, enum thud_group group, const struct thud_structure *at, const char *fmt,
                      ...)
{
    const struct thud_param *param;
    char prefix[64], key[THUD_PATH_MAX];
    va_list args;
    va_start(args, fmt);
    vsnprintf(prefix, sizeof prefix, fmt, args);
    va_end(args);
    for (int i = 0; (param = thud_group_param(group, i)); i++) {
        if (at && group == THUD_GROUP_STRUCTURE && !thud_structure_has(at->kind, i))
            continue;
        const int n = snprintf(key, sizeof key, "%s%s%s", prefix, *prefix ? "." : "", param->name);
        const bool by_floor = at && thud_scene_by_floor(&tui->doc.scene, key);
        for (int floor = 1; floor <= (by_floor ? at->storeys : 1); floor++) {
            if (by_floor)
                snprintf(key + n, sizeof key - (size_t)n, ".%d", floor);
            add_field(tui, key, param);
        }
    }
}

static void add_law(struct thud_tui *tui, int interface, const char *part, const struct thud_law *law)
{
    for (int i = 0; law && i < law->nparams; i++) {
        char key[THUD_PATH_MAX];
        snprintf(key, sizeof key, "interfaces.%d.%s.%s", interface, part, law->params[i].name);
        add_field(tui, key, &law->params[i]);
    }
}

/* What a structure or an interface has not, a scene does not give. */
void thud_tui_fill_fields(struct thud_tui *tui)
{
    const struct thud_scene *scene = &tui->doc.scene;
    thud_chooser_begin(&tui->dialog.chooser, "Find a field");
    for (int i = 1; i < scene->nstructures; i++) {
        const struct thud_interface *at = &scene->interface[i - 1];
        add_group(tui, THUD_GROUP_INTERFACE, NULL, "interfaces.%d", i);
        add_group(tui, THUD_GROUP_CONTACT, NULL, "interfaces.%d.contact", i);
        add_law(tui, i, "contact", at->contact.law);
        if (!at->has_bumper)
            continue;
        add_group(tui, THUD_GROUP_BUMPER, NULL, "interfaces.%d.bumper", i);
        add_law(tui, i, "bumper", at->bumper.law);
    }
    for (int i = 1; i <= scene->nlinks; i++)
        add_group(tui, THUD_GROUP_LINK, NULL, "links.%d", i);
    for (int i = 1; i <= scene->nstructures; i++) {
        const struct thud_structure *at = &scene->structure[i - 1];
        add_group(tui, THUD_GROUP_STRUCTURE, at, "structures.%d", i);
        for (int k = 0; k < THUD_NESTED_GROUPS; k++)
            add_group(tui, thud_nested_group(k), at, "structures.%d.%s", i, thud_group_key(thud_nested_group(k)));
    }
    add_group(tui, THUD_GROUP_SCENE, NULL, "%s", "");
    add_group(tui, THUD_GROUP_RECORD, NULL, "record");
    add_group(tui, THUD_GROUP_ANALYSIS, NULL, "analysis");
    add_group(tui, THUD_GROUP_DOCUMENT, NULL, "document");
    add_group(tui, THUD_GROUP_STUDY, NULL, "study");
}
