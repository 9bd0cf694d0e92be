/* Floor response spectra of a scene without pounding, without the bumper and with it: largest pseudo-acceleration of
 * damped oscillators on its floors. */
#pragma once

#include "ground/record.h"
#include "study/scene/scene.h"

enum { THUD_FLOOR_CASES = 3 };

struct thud_floor_place {
    int structure, floor; /* from 0 */
};

struct thud_floor_spectra_ask {
    double damping;                       /* above 0 and below 1 */
    double from_s, to_s;                  /* periods in geometric steps, 0 < from_s < to_s */
    int count, nfloors;                   /* periods, above 1; floors, 0: all */
    const struct thud_floor_place *floor; /* (nfloors) that there are */
};

struct thud_floor_spectra {
    double damping;
    int nperiods, nfloors, ncases; /* without pounding, without the bumper, and with it where there is one */
    double *period_s;              /* (nperiods) */
    struct thud_floor_place *floor;
    double *sa_mps2;   /* (ncases x nfloors x nperiods) */
    double *peak_mps2; /* (ncases x nfloors) of the floor's acceleration; NaN where an impulse has none */
};

/* Returns "no_pounding", "none", "bumper": a part of a name. */
const char *thud_floor_case_column(int which);
/* Returns it in words: "no pounding, links act", "no bumper", "bumper and links". */
const char *thud_floor_case_title(const struct thud_scene *scene, int which);

/* Computes the spectra of `scene` as written. Its runs end no sooner than the longest period after the motion. Errors:
 * THUD_INPUT (another method than the exact one), THUD_MEMORY, those of thud_scene_solve. */
enum thud_status thud_floor_spectra_run(const struct thud_scene *scene, const struct thud_record *record,
                                        const struct thud_floor_spectra_ask *ask, struct thud_floor_spectra **out,
                                        struct thud_error *err);
void thud_floor_spectra_free(struct thud_floor_spectra *spectra);

/* Returns the values of a case and a floor's index, (nperiods), and the index of the largest. */
const double *thud_floor_spectrum(const struct thud_floor_spectra *spectra, int which, int floor, int *largest);
