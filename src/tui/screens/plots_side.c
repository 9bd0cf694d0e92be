#include <math.h>
#include <stdio.h>

#include "tui/document/field.h"
#include "tui/screens/plots.h"

/* Keys of the interface, of its bumper, and of the scene; what a law has not is left out. */
static const struct thud_labelled interface_key[] = {
    {"gap", "gap"}, {"bare stiffness", "contact.stiffness"}, {"bare restitution", "contact.restitution"}};
static const struct thud_labelled bumper_key[] = {{"  thickness", "bumper.thickness"},
                                                  {"  cavity", "bumper.cavity"},
                                                  {"  stiffness", "bumper.stiffness"},
                                                  {"  restitution", "bumper.restitution"}};
static const struct thud_labelled scene_key[] = {{"record", "record.file"},
                                                 {"peak", "record.peak"},
                                                 {"sign", "record.sign"},
                                                 {"method", "analysis.method"},
                                                 {"tolerance", "analysis.tolerance"}};

static int changes(const struct thud_tui *tui, const struct thud_pane *pane, int y)
{
    const char *what;
    thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "Changes (u undoes)");
    for (int i = 0; (what = thud_undo_what(&tui->doc.undo, i)) != NULL && i < 100; i++)
        y += thud_pane_wrap(pane, 1, y, pane->w - 2, thud_look(THUD_ROLE_MUTED, 0), what);
    if (tui->doc.undo.at == 0)
        thud_field_note(pane, y++, "none yet");
    return y;
}

int thud_plots_side_draw(struct thud_tui *tui, int index, const struct thud_pane *pane)
{
    const struct thud_scene *scene = &tui->doc.scene;
    int y = 0;
    if (tui->interface + 1 < scene->nstructures) {
        const struct thud_interface *at = &scene->interface[tui->interface];
        char clearance[256];
        y = thud_field_rows(tui, index, pane, y, interface_key, sizeof interface_key / sizeof *interface_key);
        thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, 0),
                      at->has_bumper ? "bumper             [x] on (B)" : "bumper             [ ] off (B)");
        if (at->has_bumper)
            y = thud_field_rows(tui, index, pane, y, bumper_key, sizeof bumper_key / sizeof *bumper_key);
        thud_interface_clearance_text(scene, tui->interface, clearance, sizeof clearance);
        thud_field_note(pane, y++, "%-18s %s", "clearance", clearance);
    }
    for (size_t i = 0; i < sizeof scene_key / sizeof *scene_key; i++)
        thud_field_row(tui, index, pane, y++, scene_key[i].label, scene_key[i].key);
    return changes(tui, pane, y + 1);
}
