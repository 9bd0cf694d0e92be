/* Small models and whole runs of them, for the tests of the methods. */
#pragma once

#include "core/run/run.h"

enum { MARCH_FLOORS_MAX = 100 };

/* A law by name with values set: name, value, ..., NULL. */
struct march_law {
    const struct thud_law *law;
    struct thud_law_setup setup;
};
struct march_law march_law(const char *name, ...);

/* One mass on a spring of omega rad/s (0: free) with a wall at `gap` to its right, moving at v. */
struct thud_model *march_mass_and_wall(double mass, double omega, double zeta, double v, double gap,
                                       const struct march_law *law);
/* Two free bodies, the left one moving at v, the right one at rest, `gap` between them. */
struct thud_model *march_two_bodies(double left_mass, double right_mass, double v, double gap,
                                    const struct march_law *law);
/* The paper's buildings of these many storeys in a row, every floor of neighbours at the same height a contact. `law`
 * is that of all contacts. isolated: on an isolator of 2 s and 10 %, base mass 320 t. */
struct thud_model *march_row(int n, const int *storeys, bool isolated, double gap, const struct march_law *law);
/* 0.02 s samples of two bursts in 8 s, peak about 8 m/s2 times factor. */
struct thud_record *march_motion(double factor);

/* The real Kobe record scaled to 0.821 g, and its file (see thud_suite_shared); NULL where it cannot be read. */
extern const char *const march_kobe_file;
struct thud_record *march_kobe(void);

struct march {
    enum thud_status status;
    struct thud_error err;
    struct thud_run *run; /* free it with march_free; NULL where it could not be made */
    const struct thud_result *result;
};
/* step or tolerance: 0 for the default. */
struct march march_run(const struct thud_model *model, const struct thud_record *record, const char *method,
                       double step_s, double tolerance, bool locate, double tail_s);
void march_free(struct march *march);

/* Energy norm of the difference of the final states, over that of b. */
double march_distance(const struct march *a, const struct march *b);
/* Displacement and velocity of a floor at the end, degrees of freedom counted from 0. */
double march_displacement(const struct march *m, int dof);
double march_velocity(const struct march *m, int dof);
/* Largest relative difference of the peaks of accelerations, drifts, displacements, forces; each quantity's scale is
 * its own peak, but no less than `least` of the largest one of its kind. */
double march_peaks_apart(const struct thud_result *a, const struct thud_result *b, double least);
