/* The states of a session with their results: every scene that was run, until newer ones take its place; those with a
 * name stay. */
#pragma once

#include "study/scene/scene.h"

enum { THUD_VARIANTS_MAX = 32 };
struct thud_variant {
    struct thud_scene *scene;
    char name[40]; /* empty: none was given */
    char what[64]; /* the change that led to it; empty: none did */
    char solution[160];
};
struct thud_variants {
    struct thud_variant item[THUD_VARIANTS_MAX]; /* (n) as they came */
    int n;
};

/* The one whose runs are those of `scene`; NULL: there is none. */
struct thud_variant *thud_variants_find(struct thud_variants *variants, const struct thud_scene *scene);
/* By its name, or by its number as "#3"; NULL: there is none. */
struct thud_variant *thud_variants_named(struct thud_variants *variants, const char *name);
/* Keeps a scene with its result; out of memory, or where all have names, it is left out. */
void thud_variants_note(struct thud_variants *variants, const struct thud_scene *scene, const char *what,
                        const char *solution);
void thud_variants_forget(struct thud_variants *variants, struct thud_variant *variant);
void thud_variants_clear(struct thud_variants *variants);
