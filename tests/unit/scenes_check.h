/* One random scene, answered in every way that must give the same result. */
#pragma once

#include <stdbool.h>
#include <stdio.h>

#include "scenes.h"

enum { SCENES_CHECKS_MAX = 32 };
struct scenes_tally {
    const char *only; /* part of a check's name; "": all */
    bool slow;        /* other methods too */
    long scenes, pounding, wild, failed, stopped, wrong;
    struct {
        const char *name;
        long made, off, skipped;
        double worst; /* in units of what is allowed */
    } check[SCENES_CHECKS_MAX];
};

/* Prints a line for each disagreement. */
void scenes_check(unsigned long long seed, struct scenes_tally *tally);
/* scenes_sweep.c: whether a study of the scene gives the same with and without its shortcuts; else what is wrong. */
bool scenes_sweep_agrees(const struct scenes_one *one, char *what, size_t size);
void scenes_tally_print(const struct scenes_tally *tally, FILE *out);
