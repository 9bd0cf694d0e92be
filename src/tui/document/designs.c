#include "tui/document/designs.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/live_cases.h"
#include "base/largest.h"
#include "base/scan.h"
#include "base/text.h"
#include "tui/document/doc.h"

void thud_design_measure(const struct thud_scene *scene, const struct thud_live *live, struct thud_design_result *out)
{
    const enum thud_live_which written = thud_live_written(live);
    *out = (struct thud_design_result){.known = thud_live_result(live, written) != NULL};
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        out->force_n[i] = thud_live_force(live, written, i + 1, &out->impacts[i]);
        out->need_m[i] = live->need[i].relative_displacement_m;
        out->with_bumper_m[i] = live->need[i].with_bumper_m;
    }
    for (int with = 0; with < 2; with++) {
        const enum thud_live_which which = with ? written : THUD_LIVE_NONE;
        out->acceleration_mps2[with] = out->drift_m[with] = NAN;
        for (int s = 0; s < scene->nstructures; s++) {
            out->acceleration_mps2[with] =
                fmax(out->acceleration_mps2[with], thud_live_peak(live, which, s, THUD_PEAK_ACCELERATION));
            out->drift_m[with] = fmax(out->drift_m[with], thud_live_peak(live, which, s, THUD_PEAK_DRIFT));
        }
    }
}

const char *thud_design_called(const struct thud_design *design, char text[40])
{
    if (*design->name)
        snprintf(text, 40, "%s", design->name);
    else
        snprintf(text, 40, "#%d", design->number);
    return text;
}

struct differences {
    const struct thud_scene *scene, *other;
    char *text;
    size_t size;
};

static void add(struct differences *d, const char *key, const char *value)
{
    char said[96];
    thud_append(d->text, d->size, "%s%s%s%s", *d->text ? ", " : "", key, *value ? " " : "",
                thud_quantity_said(value, said));
}

static void compare(void *context, const char *section, const char *key, const char *value)
{
    struct differences *d = context;
    char path[THUD_VARY_KEY + 64], other[96] = "";
    const char *only = d->scene->nstructures == 2 ? "interfaces.1." : "", *shown = path;
    int number;
    snprintf(path, sizeof path, "%s%s%s", section, *section ? "." : "", key);
    if (strcmp(key, "title") == 0 || strcmp(key, "fitted") == 0 ||
        (thud_scene_get_short(d->other, path, NULL, other, sizeof other, NULL) == THUD_OK &&
         strncmp(other, value, 95) == 0))
        return;
    if (strncmp(path, only, strlen(only)) == 0)
        shown += strlen(only);
    if (thud_scan_word(&shown, "structures.") && thud_scan_count(&shown, &number)) {
        char name[THUD_NAME_MAX + sizeof path];
        snprintf(name, sizeof name, "%s%s", d->scene->structure[number - 1].name, shown);
        add(d, name, *value == '[' ? "" : value);
    } else
        add(d, shown, *value == '[' ? "" : value);
}

void thud_design_differences(const struct thud_scene *scene, const struct thud_scene *other, char *text, size_t size)
{
    struct differences d = {scene, other, text, size};
    *text = '\0';
    if (scene->nstructures != other->nstructures)
        snprintf(text, size, "%d structures", scene->nstructures);
    for (int i = 0; i + 1 < scene->nstructures && i + 1 < other->nstructures; i++)
        if (scene->interface[i].has_bumper != other->interface[i].has_bumper)
            add(&d, "bumper", scene->interface[i].has_bumper ? "in" : "out");
    thud_preset_each(scene, &d, compare);
}

static struct thud_design *find(struct thud_designs *designs, const struct thud_scene *scene)
{
    for (int i = 0; i < designs->n; i++)
        if (thud_doc_runs_alike(designs->item[i].scene, scene))
            return &designs->item[i];
    return NULL;
}

struct thud_design *thud_designs_named(struct thud_designs *designs, const char *name)
{
    char called[40];
    for (int i = 0; i < designs->n; i++)
        if (strcmp(thud_design_called(&designs->item[i], called), name) == 0)
            return &designs->item[i];
    return NULL;
}

void thud_designs_forget(struct thud_designs *designs, struct thud_design *design)
{
    int i = (int)(design - designs->item);
    free(design->scene);
    memmove(design, design + 1, (size_t)(--designs->n - i) * sizeof *design);
}

struct thud_design *thud_designs_note(struct thud_designs *designs, const struct thud_scene *scene, const char *what,
                                      const struct thud_design_result *result)
{
    struct thud_design *d = find(designs, scene);
    int oldest = 0;
    while (oldest < designs->n && (*designs->item[oldest].name || designs->item[oldest].marked))
        oldest++;
    if (!d && designs->n == THUD_DESIGNS_MAX) {
        if (oldest == THUD_DESIGNS_MAX)
            return NULL;
        thud_designs_forget(designs, &designs->item[oldest]);
    }
    if (!d) {
        d = &designs->item[designs->n];
        *d = (struct thud_design){.scene = malloc(sizeof *scene), .number = designs->last + 1};
        if (!d->scene)
            return NULL;
        *d->scene = *scene;
        snprintf(d->what, sizeof d->what, "%.60s", what);
        designs->last++;
        designs->n++;
    }
    if (result)
        d->result = *result;
    return d;
}

void thud_designs_clear(struct thud_designs *designs)
{
    for (int i = 0; i < designs->n; i++)
        free(designs->item[i].scene);
    *designs = (struct thud_designs){.n = 0};
}
