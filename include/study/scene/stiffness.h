/* Estimates of contact stiffness, and the sensitivity of the results to it. In the literature, the estimate for
 * concrete is the axial stiffness of the colliding slab (Maison and Kasai 1990; Cole et al. 2011). For a rubber bumper
 * it is eq. (6) of Polycarpou and Komodromos (2011). Neither is measured; each may be wrong by a factor of 2. */
#pragma once

#include "core/model/result.h"
#include "ground/record.h"
#include "study/scene/scene.h"

/* Returns E A/L, N/m, of a slab pushed at its edge: A the section's area, L the length along the impact. */
double thud_stiffness_slab(double area_m2, double length_m, double modulus_pa);
/* Returns the stiffness of two colliding slabs, N/m: springs in series. */
double thud_stiffness_series(double a_npm, double b_npm);
/* Returns the stiffness of a bumper, k = alpha A K_r/d^n, N/m^n. */
double thud_stiffness_rubber(double alpha, double area_m2, double modulus_pa, double thickness_m, double exponent);

/* Varied stiffness: that of the bumper at interfaces with a bumper, which carries every impact there; that of the
 * contact at the others; of links stiffness, dashpot and slip force together. */
enum thud_stiffness { THUD_STIFFNESS_CONTACT, THUD_STIFFNESS_BUMPER, THUD_STIFFNESS_LINK, THUD_STIFFNESSES };
/* "contact", "bumper", "link" */
const char *thud_stiffness_name(enum thud_stiffness which);

/* Multiplies this stiffness; false: the scene, or its law, has none. */
bool thud_stiffness_scale(struct thud_scene *scene, enum thud_stiffness which, double factor);

struct thud_stiffness_row {
    double factor;
    int impacts;
    double force_n; /* the largest of all contacts */
    double acceleration_mps2[THUD_STRUCTURES_MAX],
        drift_m[THUD_STRUCTURES_MAX]; /* the largest of a structure's floors, and of its storeys */
};
/* Takes the results of a finished run of the scene, with a factor of 0. */
void thud_stiffness_row_read(const struct thud_scene *scene, const struct thud_result *result,
                             struct thud_stiffness_row *row);
enum { THUD_STIFFNESS_ROWS = 3 }; /* half, nominal, twice */

/* Runs the scene (of a case) at each factor; *n is 0 where nothing can be varied. Errors: those of
 * a run. */
enum thud_status thud_stiffness_rows(const struct thud_scene *scene, const struct thud_record *record,
                                     enum thud_stiffness which, struct thud_stiffness_row *row, int *n,
                                     struct thud_error *err);
