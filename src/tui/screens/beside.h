/* Another law laid beside that of an interface: the same bodies, values of the same name and dimension unless they are
 * set. It is no part of the scene. */
#pragma once

#include "tui/document/state.h"
#include "tui/screens/law_figure.h"

struct thud_beside {
    char law[40]; /* empty: none */
    int n;
    struct {
        char name[40], value[64];
    } own[THUD_LAW_PARAMS_MAX]; /* (n) parameters that were set */
};

/* The law of the bumper where there is one, else that of the bare contact. */
const char *thud_beside_part(const struct thud_scene *scene, int pair);
const struct thud_law *thud_beside_of(const struct thud_scene *scene, int pair);
/* The scene with the other law. Errors: as thud_scene_set. */
enum thud_status thud_beside_scene(const struct thud_beside *beside, const struct thud_scene *scene, int pair,
                                   struct thud_scene *out, struct thud_error *err);

/* The Contact screen. */
struct thud_contact_state {
    struct thud_beside beside;  /* a law to compare with */
    struct thud_figure *figure; /* force-indentation loops of the interface shown */
    struct thud_meeting meeting[THUD_MEETINGS], beside_meeting[THUD_MEETINGS];
    struct thud_error error;
    unsigned long revision, pin; /* what they belong to; 0: nothing */
    int pair;
};
static inline struct thud_contact_state *thud_contact_state(const struct thud_tui *tui)
{
    return tui->own[THUD_SCREEN_CONTACT];
}

/* "hertz", "none" or "restitution 0.4": a law, or a value of the one there is. */
void thud_tui_beside(struct thud_tui *tui, const char *words);
void thud_tui_choose_beside(struct thud_tui *tui);
