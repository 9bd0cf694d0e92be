/* Random scenes as presets with their motions, for `thud simplify`, and how far its order falls short of all combinations.
 * usage: simplest DIR [COUNT]    prints the presets that were written into DIR.  usage: simplest    for the three first
 * small scenes, every combination of the rows of models on top of the other steps that were found: a line for each,
 * with what the search saves and what the best of all combinations does, as parts of inputs and work. */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../unit/scenes.h"
#include "io/preset/preset.h"
#include "io/record/record_write.h"
#include "study/simplify/simplify_private.h"

static const unsigned long long family[] = {
    0, SCENES_YIELDING, SCENES_COLUMNS, SCENES_P_DELTA, SCENES_LINKS, SCENES_ISOLATORS, SCENES_SOIL, SCENES_MIXED,
};
enum {
    FAMILIES = sizeof family / sizeof *family,
    SCENES = 50,
    SEARCHED = 3,
    COMBINATIONS_LEAST = 40,
    COMBINATIONS_MOST = 4000
};

/* The i-th scene whose run comes into contact, and to its end; the seed goes on. */
static void draw(struct scenes_one *one, unsigned long long *seed)
{
    for (bool pounds = false; !pounds; (*seed)++) {
        struct thud_solution solution = {0};
        bool file = false; /* of a matrix or modes, which is not written */
        scenes_draw(one, family[*seed % FAMILIES] + *seed);
        for (int s = 0; s < one->scene.nstructures; s++)
            file = file || thud_kind_is_read(one->scene.structure[s].kind);
        if (!file && one->record && thud_scene_solve(&one->scene, one->record, NULL, &solution, NULL) == THUD_OK)
            for (int c = 0; c < thud_run_result(solution.run)->ncontacts; c++)
                pounds = pounds || thud_run_result(solution.run)->contact[c].impacts > 0;
        thud_solution_clear(&solution);
        if (!pounds)
            scenes_clear(one);
    }
}

static void write_text(const struct thud_text *text, const char *path)
{
    FILE *file = fopen(path, "w");
    assert(file && text->data && !text->failed);
    fwrite(text->data, 1, text->size, file);
    fclose(file);
}

static void write_scene(struct scenes_one *one, const char *folder)
{
    static const char any[] =
        "structures:\n  - {name: A, kind: rigid, mass: 1 t}\n  - {name: B, kind: rigid, mass: 1 t}\n"
        "interfaces:\n  - gap: 1 cm\n    contact: {law: linear, stiffness: 1 MN/m}\n";
    char path[4096];
    struct thud_preset *preset = NULL;
    struct thud_text text = {0};
    struct thud_error err = {0};
    snprintf(one->scene.record.file, sizeof one->scene.record.file, "%llu.csv", one->seed);
    thud_record_csv(one->record, NULL, &text);
    snprintf(path, sizeof path, "%s/%llu.csv", folder, one->seed);
    write_text(&text, path);
    thud_text_clear(&text);
    enum thud_status status = thud_preset_parse(any, sizeof any - 1, "any", &preset, &err);
    assert(status == THUD_OK);
    status = thud_preset_text(preset, &one->scene, &text.data, &text.size, &err);
    if (status != THUD_OK)
        fprintf(stderr, "%llu: %s\n", one->seed, err.what);
    assert(status == THUD_OK);
    snprintf(path, sizeof path, "%s/%llu.yaml", folder, one->seed);
    write_text(&text, path);
    puts(path);
    thud_text_clear(&text);
    thud_preset_free(preset);
}

/* ---- all combinations ---- */

static double saving(const struct thud_simplify_found *f, const struct thud_simplification *of)
{
    return (double)(f->full.inputs - of->inputs) / fmax(1, f->full.inputs) + fmax(0, 1 - of->work);
}

/* The choices of models: rows of one kind at one place exclude each other. Returns how many combinations there are. */
struct choice {
    int first, n; /* of the indices of their rows */
};
static double find_choices(const struct thud_simplify_found *f, struct choice *choice, int *count)
{
    double combinations = 1;
    *count = 0;
    for (int i = 0; i < f->n && f->one[i].group == THUD_SIMPLIFY_MODEL; i++) {
        if (i == 0 || f->one[i].row != f->one[i - 1].row || f->one[i].at != f->one[i - 1].at)
            choice[(*count)++] = (struct choice){i, 0};
        choice[*count - 1].n++;
    }
    for (int k = 0; k < *count; k++)
        combinations *= 1 + choice[k].n;
    return combinations;
}

/* Whether it was a scene to search. */
static bool search_all(const struct scenes_one *one, bool *fell_short)
{
    struct thud_record *record[] = {one->record};
    const struct thud_simplify_ask ask = {.within = 0.05, .no_methods = true};
    struct thud_simplify *simplify = NULL;
    struct choice choice[THUD_SIMPLIFY_MAX];
    int count = 0, fixed[THUD_SIMPLIFY_MAX], nfixed = 0;
    double *seconds, best = 0;
    enum thud_status status = thud_simplify_create(&one->scene, record, 1, &ask, &simplify, NULL);
    for (bool done = false; status == THUD_OK && !done;)
        status = thud_simplify_advance(simplify, &seconds, &done, NULL);
    const struct thud_simplify_found *f = thud_simplify_found(simplify);
    const double combinations = status == THUD_OK ? find_choices(f, choice, &count) : 0;
    const bool fits = combinations >= COMBINATIONS_LEAST && combinations <= COMBINATIONS_MOST;
    for (int i = 0; i < f->steps; i++)
        if (f->one[f->step[i]].group != THUD_SIMPLIFY_MODEL)
            fixed[nfixed++] = f->step[i];
    long tried = 0, kept = 0;
    char words[1000] = "", found[1000] = "";
    for (long k = 0; fits && k < (long)combinations; k++) {
        int step[THUD_SIMPLIFY_MAX], n = nfixed;
        long rest = k;
        struct thud_simplification whole;
        memcpy(step, fixed, sizeof fixed);
        for (int c = 0; c < count; rest /= 1 + choice[c++].n)
            if (rest % (1 + choice[c].n) > 0)
                step[n++] = choice[c].first + (int)(rest % (1 + choice[c].n)) - 1;
        status = thud_simplify_try(simplify, step, n, &whole, NULL);
        assert(status == THUD_OK);
        tried += !whole.failed;
        if (whole.failed || !thud_simplification_within(f, &whole))
            continue;
        kept++;
        if (saving(f, &whole) <= best)
            continue;
        best = saving(f, &whole);
        *words = '\0';
        for (int i = 0; i < n; i++)
            snprintf(words + strlen(words), sizeof words - strlen(words), "%s%s", i ? ", " : "", f->one[step[i]].words);
    }
    for (int i = 0; i < f->steps; i++)
        snprintf(found + strlen(found), sizeof found - strlen(found), "%s%s", i ? ", " : "", f->one[f->step[i]].words);
    if (fits) {
        printf("%llu: %ld combinations of models, %ld within: the search saves %.4f, the best of all %.4f\n", one->seed,
               tried, kept, saving(f, &f->cheapest), best);
        printf("#   search: %s\n#   best:   %s\n", found, words);
        *fell_short = *fell_short || saving(f, &f->cheapest) < 0.9 * best;
    }
    thud_simplify_free(simplify);
    return fits;
}

int main(int argc, char **argv)
{
    const int count = argc > 2 ? atoi(argv[2]) : SCENES;
    unsigned long long seed = 1;
    bool fell_short = false;
    for (int i = 0; i < (argc > 1 ? count : SEARCHED);) {
        struct scenes_one one;
        draw(&one, &seed);
        if (argc > 1)
            write_scene(&one, argv[1]);
        i += argc > 1 || search_all(&one, &fell_short);
        scenes_clear(&one);
    }
    return fell_short;
}
