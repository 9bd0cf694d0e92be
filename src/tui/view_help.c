/* Help: the keys of the screen one comes from, the general ones, and the model in short. */
#include <stdio.h>
#include <string.h>

#include "tui/state.h"

static const char *const model[] = {
    "",
    "The model in short",
    "  A scene is a ground motion and a row of structures, with an interface",
    "  between each two neighbours. Displacements are relative to the ground,",
    "  positive to the right.",
    "  Shear building: a mass for each floor, a spring for each storey, the same",
    "  damping ratio in every mode. Isolated building: the same on a slab on an",
    "  isolator. Rigid body: one free mass with a velocity at the start. Wall:",
    "  moves with the ground. Floors at the same height can meet.",
    "",
    "  Bare contact, linear viscoelastic without tension:",
    "    F = k d + c d'  while that is positive;  c = 2 xi sqrt(k m),",
    "    m = m1 m2/(m1 + m2), xi from the coefficient of restitution (COR).",
    "    damping paper: the classical formula, which parts faster than COR says;",
    "    damping exact: the bodies really part with COR.",
    "  Rubber bumper: F = k d^n on approach, past the ultimate strain a line of",
    "    stiffness post-yield; on restitution F = k d^n (1 + C d').",
    "  clearance = gap - (thickness - cavity).",
    "",
    "  Three cases are run after every edit: no pounding (no contact at all), no",
    "  bumper (bare contact at the same gap), and the bumper as written. ratio =",
    "  bumper : no bumper; below 1 the bumper helps.",
    "  Every peak is that of the continuous history, not of printed samples.",
    "",
    "  Values take units and convert: 50 mm, 5cm, 0.05 m, 320 t, 600 MN/m,",
    "  2500 kN/mm, 0.36 kN/mm^2.65, 0.821 g, 5 %. The decimal sign is a point.",
    "  Without a unit the one shown is meant. All digits typed are kept.",
};

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    (void)tui;
    pane[0] = area;
    return 1;
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    (void)index;
    snprintf(text, size, "Help for %s (Esc or q goes back)", thud_view_of(tui->before_help)->title);
}

static int keys_of(const struct thud_pane *pane, int y, int where, bool general, const char *head)
{
    thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_TITLE, THUD_BOLD), head);
    for (int i = 0; i < thud_key_count(); i++) {
        const struct thud_key_entry *key = thud_key_at(i);
        bool is_general = key->where == THUD_AT_GENERAL || key->where == THUD_AT_FORMS;
        if (!(key->where & where) || is_general != general || thud_key_action(where, key->key) != key->action)
            continue;
        thud_pane_put(pane, 3, y, thud_look(THUD_ROLE_KEY, THUD_BOLD), key->written);
        thud_pane_put(pane, 10, y++, thud_look(THUD_ROLE_PLAIN, 0), key->help);
    }
    return y;
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    (void)index;
    const struct thud_view *view = thud_view_of(tui->before_help);
    char head[64];
    snprintf(head, sizeof head, "Keys of %s", view->title);
    int y = keys_of(pane, 0, view->where, false, head);
    y = keys_of(pane, y + 1, view->where, true, "General keys");
    y = keys_of(pane, y + 1, THUD_AT_TYPING, false, "While typing (every other key is text)");
    for (size_t i = 0; i < sizeof model / sizeof *model; i++)
        thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, i == 1 ? THUD_BOLD : 0), model[i]);
    struct thud_text words = {0};
    thud_tui_commands_text(&words);
    thud_pane_put(pane, 1, ++y, thud_look(THUD_ROLE_TITLE, THUD_BOLD), "Commands after :");
    y++;
    if (words.data)
        y += thud_pane_wrap(pane, 3, y, pane->w - 4, thud_look(THUD_ROLE_PLAIN, 0), words.data);
    thud_text_clear(&words);
    return y;
}

THUD_VIEW(help, "Help", HELP, .act = NULL);

static const struct {
    int where;
    const char *name;
} places[] = {{THUD_AT_MODEL, "Model"},     {THUD_AT_CONTACT, "Contact"}, {THUD_AT_RECORD, "Record"},
              {THUD_AT_RESULTS, "Results"}, {THUD_AT_PLOTS, "Plots"},     {THUD_AT_SWEEP, "Sweep"},
              {THUD_AT_BENCH, "Bench"},     {THUD_AT_TYPING, "typing"},   {THUD_AT_CHOOSING, "choosing"}};

void thud_tui_keys_text(struct thud_text *out)
{
    for (int i = 0; i < thud_key_count(); i++) {
        const struct thud_key_entry *key = thud_key_at(i);
        const char *name = key->where == THUD_AT_GENERAL ? "all screens"
                           : key->where == THUD_AT_FORMS ? "fields"
                                                         : NULL;
        for (size_t j = 0; j < sizeof places / sizeof *places && !name; j++)
            if (key->where & places[j].where)
                name = places[j].name;
        thud_text_append(out, "%s\t%s\t%s\n", name ? name : "", key->written, key->help);
    }
}
