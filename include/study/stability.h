/* Where methods fail: every method over its steps on free vibration, on a wall spring and on the scene; energies after
 * 50 s of bouncing; the restitution really obtained; and scenes in which a naive method goes wrong. */
#ifndef THUD_STUDY_STABILITY_H
#define THUD_STUDY_STABILITY_H

#include "study/answer.h"

/* How one run is stepped. */
struct thud_stepping {
    const struct thud_method *method;
    bool locate;
    double setting; /* step in s of a fixed-step method, else the tolerance */
};

/* "rk4, located"; methods that always locate have their name alone. The one place for names of curves. */
void thud_stepping_name(const struct thud_stepping *how, char *text, unsigned long size);

enum thud_stability_verdict { THUD_VERDICT_NONE, THUD_BOUNDED, THUD_GROWING, THUD_BLOWN_UP };
const char *thud_stability_verdict_word(enum thud_stability_verdict verdict);

enum { THUD_STABILITY_FREE, THUD_STABILITY_WALL, THUD_STABILITY_SCENE, THUD_STABILITY_KINDS };

/* A method at a step. `growth`: for free vibration and the wall the largest displacement of 50 s over that of their
 * first half, for the scene the largest over the exact one (of the floor where it is most); INFINITY once blown up. */
struct thud_stability_cell {
    struct thud_stepping how;
    double omega_dt; /* with the oscillator's, the wall spring's, the scene's fastest omega; NaN: of its own choice */
    enum thud_stability_verdict verdict[THUD_STABILITY_KINDS];
    double growth[THUD_STABILITY_KINDS];
};

/* A mass that keeps its energy, bouncing on a wall spring. */
struct thud_stability_energy {
    struct thud_stepping how;
    double omega_dt, ratio; /* energy after 50 s over that at the start; INFINITY: blown up */
};

/* Two free bodies. */
struct thud_stability_restitution {
    const struct thud_law *law;
    struct thud_stepping how;
    double nominal;                         /* coefficient of restitution; NaN: the law has none */
    double closing_mps, expected, obtained; /* by the law itself, by the method; NaN: blown up */
};

/* A small scene with what is right, what a naive method makes of it and what thud does. */
struct thud_exhibit {
    const char *name, *scene, *quantity;
    const char *naive;         /* which naive method */
    double right, wrong, thud; /* the quantity: the true one, the naive method's (INFINITY: blown up), thud's */
};

struct thud_stability {
    struct thud_stability_cell *cell;
    struct thud_stability_energy *energy;
    struct thud_stability_restitution *restitution;
    struct thud_exhibit *exhibit;
    int ncells, nenergies, nrestitutions, nexhibits;
    int done; /* jobs, in the order of these lists */
    struct thud_model *model;
    const struct thud_record *record;
    struct thud_run_options options;
    double *peak_m; /* (ndof) of the scene by the exact method; NULL: no scene, or none with modes */
    double fastest_radps;
};

/* `scene` (that of a case; NULL: none) is not kept, the record must stay. Errors: THUD_MEMORY, those of
 * thud_scene_answer. */
enum thud_status thud_stability_create(const struct thud_scene *scene, const struct thud_record *record,
                                       struct thud_stability **out, struct thud_error *err);
void thud_stability_free(struct thud_stability *stability);
int thud_stability_jobs(const struct thud_stability *stability);
/* The next job; `done` counts up. Errors: THUD_MEMORY, and THUD_DIVERGED of an exact method. */
enum thud_status thud_stability_next(struct thud_stability *stability, struct thud_error *err);

int thud_exhibit_count(void);
enum thud_status thud_exhibit_run(int index, struct thud_exhibit *out, struct thud_error *err);

#endif
