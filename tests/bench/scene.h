/* A scene as thud makes it, for programs that measure: one place for its numbers, its confirmed result and the exact
 * method's times. */
#pragma once

#include "app/run/session.h"

enum { BENCH_FLOORS_MAX = 512 };

struct bench_scene {
    struct thud_session session;
    struct thud_scene scene; /* of the case */
    struct thud_model *model;
    struct thud_record *record;
    struct thud_run_options options;
};

struct bench_solution {
    double seconds; /* least of the repeats, of processor time: a run, without setting up its model */
    double end_s;
    int impacts;
    struct thud_work work;
    double acceleration_mps2[BENCH_FLOORS_MAX]; /* (floors) peaks */
};

/* usage: PRESET CASE KEY=VALUE... ; besides the preset's keys `first=30s` cuts the ground motion and
 * `row=8` repeats the row until it has 8 structures. A message and exit
 * status 1 on failure. */
void bench_scene_open(struct bench_scene *scene, int argc, char **argv);
void bench_scene_close(struct bench_scene *scene);
/* One run: seconds of processor time. */
double bench_scene_once(const struct bench_scene *scene, const struct thud_run_options *options,
                        struct bench_solution *out);
/* `method` by name; the first run warms up. */
void bench_scene_run(const struct bench_scene *scene, const char *method, double tolerance, int repeats,
                     struct bench_solution *out);
/* The exact method at its tightest, and Dormand and Prince with located events, who confirm it; returns how far they
 * are apart. The exact method's own errors are measured against the other. */
double bench_scene_reference(const struct bench_scene *scene, struct bench_solution *out, struct bench_solution *other);
/* Largest relative difference of the floors' peak accelerations. */
double bench_scene_error(const struct bench_scene *scene, const double *acceleration_mps2,
                         const struct bench_solution *reference);
double bench_processor_s(void);
