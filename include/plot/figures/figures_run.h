/* Figures of the runs of one scene: histories, loops, envelopes, energy. Several cases have their histories one above
 * the other, and the other curves in the same panels. */
#pragma once

#include <stdbool.h>

#include "core/model/result.h"
#include "plot/figure/figure.h"
#include "study/scene/scene.h"

/* Finished run with histories. Several sources of one figure have the same structures and contacts. */
struct thud_figure_source {
    const char *name;     /* where there is more than one source: "no bumper" */
    enum thud_case which; /* its colour there */
    const struct thud_scene *scene;
    const struct thud_result *result;
    const struct thud_history *history;
    const struct thud_impact *impact; /* (nimpacts) */
    int nimpacts;
    bool behind; /* of another state, to compare with: dashed */
};

/* Unit in which values up to a peak are shown: shown = SI x factor. */
struct thud_shown_unit {
    double factor;
    const char *unit;
};
/* Returns the unit of energies up to `peak_j`: MJ, or kJ below 1 MJ. */
struct thud_shown_unit thud_shown_energy(double peak_j);

/* X(NAME, name of its files, maker, what a run must have for it); the makers are thud_figure_MAKER. */
#define THUD_RUN_FIGURE_LIST(X)                                                                                        \
    X(FORCE, "force", forces, CONTACTS)                                                                                \
    X(VELOCITY, "velocity", histories, FLOORS)                                                                         \
    X(ACCELERATION, "acceleration", histories, FLOORS)                                                                 \
    X(DISPLACEMENT, "displacement", histories, FLOORS)                                                                 \
    X(DRIFT, "drift", histories, FLOORS)                                                                               \
    X(LOOP, "loop", loops, IMPACTS)                                                                                    \
    X(ENVELOPE, "envelope", envelopes, STOREYS)                                                                        \
    X(ENERGY, "energy", energies, FLOORS)                                                                              \
    X(HYSTERESIS, "hysteresis", hysteresis, YIELDING_OR_LINKS)                                                         \
    X(PERMANENT, "permanent", permanent, YIELDING)                                                                     \
    X(COLUMNS, "columns", columns, STRUCK_COLUMNS)

enum thud_run_figure {
#define THUD_RUN_FIGURE(NAME, name, maker, needs) THUD_FIGURE_##NAME,
    THUD_RUN_FIGURE_LIST(THUD_RUN_FIGURE) THUD_RUN_FIGURES
#undef THUD_RUN_FIGURE
};

/* Words of the figures for ductility and permanent drift. */
extern const char thud_ductility_note[];
/* Returns "force", "velocity", ...: also the name of its files. */
const char *thud_run_figure_name(enum thud_run_figure which);
/* Returns whether it shows anything: no forces without contacts, no drift of rigid bodies, no columns where floors
 * meet. */
bool thud_run_figure_has(enum thud_run_figure which, const struct thud_figure_source *source, int nsources);
/* Place in a run: a contact, or a floor of a structure, all from 0. */
struct thud_figure_sight {
    int contact, structure, floor;
};
/* Draws one quantity at one place, with overlaid curves of the sources. Only the first source must have this place;
 * structures and contacts of the others may differ. FORCE, LOOP and VELOCITY (of approach) are of the contact,
 * ACCELERATION, DISPLACEMENT and DRIFT of the floor. Ask thud_figure_check. */
struct thud_figure *thud_run_figure_at(enum thud_run_figure which, const struct thud_figure_source *source,
                                       int nsources, const struct thud_figure_sight *sight);
/* Draws a figure. One source: a curve per floor or contact (the seven with the largest peaks of more). Several: a curve
 * per source, of the floor or contact with the largest peak. Ask thud_figure_check. */
struct thud_figure *thud_run_figure(enum thud_run_figure which, const struct thud_figure_source *source, int nsources);
