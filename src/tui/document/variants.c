#include "tui/document/variants.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/scan.h"
#include "tui/document/doc.h"

struct thud_variant *thud_variants_find(struct thud_variants *variants, const struct thud_scene *scene)
{
    for (int i = 0; i < variants->n; i++)
        if (thud_doc_runs_alike(variants->item[i].scene, scene))
            return &variants->item[i];
    return NULL;
}

struct thud_variant *thud_variants_named(struct thud_variants *variants, const char *name)
{
    int number = 0;
    const char *at = name;
    if (thud_scan_word(&at, "#") && thud_scan_count(&at, &number) && !*at)
        return number >= 1 && number <= variants->n ? &variants->item[number - 1] : NULL;
    for (int i = 0; i < variants->n; i++)
        if (*name && strcmp(variants->item[i].name, name) == 0)
            return &variants->item[i];
    return NULL;
}

void thud_variants_forget(struct thud_variants *variants, struct thud_variant *variant)
{
    int i = (int)(variant - variants->item);
    free(variant->scene);
    memmove(variant, variant + 1, (size_t)(--variants->n - i) * sizeof *variant);
}

void thud_variants_note(struct thud_variants *variants, const struct thud_scene *scene, const char *what,
                        const char *solution)
{
    struct thud_variant *v = thud_variants_find(variants, scene);
    int oldest = 0;
    while (oldest < variants->n && *variants->item[oldest].name)
        oldest++;
    if (!v && variants->n == THUD_VARIANTS_MAX) {
        if (oldest == THUD_VARIANTS_MAX)
            return;
        thud_variants_forget(variants, &variants->item[oldest]);
    }
    if (!v) {
        v = &variants->item[variants->n];
        *v = (struct thud_variant){.scene = malloc(sizeof *scene)};
        if (!v->scene)
            return;
        *v->scene = *scene;
        snprintf(v->what, sizeof v->what, "%.60s", what);
        variants->n++;
    }
    snprintf(v->solution, sizeof v->solution, "%.155s", solution);
}

void thud_variants_clear(struct thud_variants *variants)
{
    for (int i = 0; i < variants->n; i++)
        free(variants->item[i].scene);
    variants->n = 0;
}
