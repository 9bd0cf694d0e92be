/* Remarks on what is about to run: how long it takes, and what a change of a value leaves as it was. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "base/scan.h"
#include "study/scene/building.h"
#include "study/scene/level.h"
#include "study/scene/solution.h"
#include "study/sweep/remark_rows.h"

static double fastest_mode(const struct thud_scene *scene)
{
    struct thud_model *model;
    if (thud_scene_assemble(scene, &model, NULL) != THUD_OK)
        return 0;
    double fastest = model->fastest_radps;
    thud_model_free(model);
    return fastest;
}

void thud_remark_effort(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    /* measured on one processor: 20 buildings of 200 storeys under 4001 samples, and a floor of 1 kg on
     * 1e4 MN/m; a large model is too dear to be made for its fastest mode alone */
    static const double each_floors_s = 5e-9, each_series_s = 5e-7, long_s = 5;
    static const int large = 1000;
    const struct thud_scene *scene = scope->scene;
    const struct thud_record *record = scope->nrecords > 0 ? scope->record[0] : NULL;
    (void)i;
    double floors = 0, squares = 0, contacts = 0, samples = record ? (double)record->samples : 2000;
    for (int s = 0; s < scene->nstructures; s++) {
        const struct thud_structure *at = &scene->structure[s], *next = at + 1;
        floors += thud_structure_floors(at);
        squares += (double)thud_structure_floors(at) *
                   thud_structure_floors(at); /* a building's floors move by its own modes */
        if (s + 1 < scene->nstructures)
            contacts += at->kind == THUD_WALL     ? thud_structure_floors(next)
                        : next->kind == THUD_WALL ? thud_structure_floors(at)
                                                  : fmin(thud_structure_floors(at), thud_structure_floors(next));
    }
    double end_s = scene->analysis.tail_s + (record ? samples * record->dt_s : 0), seconds, bytes;
    if (record) /* the time after it goes in the same steps */
        samples = end_s / record->dt_s;
    seconds = each_floors_s * samples * squares;
    if (floors <= large)
        seconds += each_series_s * floors * end_s * fastest_mode(scene) / 1.8;
    if (seconds < long_s)
        return;
    bytes = 16 * contacts * (floors + contacts) + 25000 * floors; /* with the run without contact for the needed gap */
    const bool minutes = seconds >= 120;
    thud_error_set(thud_remark_add(out), THUD_OK,
                   "%.0f floors, up to %.0f contacts, %.0f steps of the ground motion: a run takes about %.2g GB and "
                   "%.2g %s, or several times as much if contact is frequent",
                   floors, contacts, samples, fmax(bytes / 1e9, 0.01), minutes ? seconds / 60 : seconds,
                   minutes ? "min" : "s");
}

/* The stiffness of a bumper that is a number, and none that eq. (6) makes from its thickness; its index, else -1. */
static int own_stiffness(const struct thud_interface *at)
{
    if (!at->has_bumper || !at->bumper.law || thud_law_param(at->bumper.law, "material-stiffness") < 0)
        return -1;
    int k = thud_law_param(at->bumper.law, "stiffness");
    return k >= 0 && !isnan(at->bumper.value[k]) ? k : -1;
}

static void stiffness_text(const struct thud_scene *scene, int interface, char *text, size_t size)
{
    char key[64];
    snprintf(key, sizeof key, "interfaces.%d.bumper.stiffness", interface + 1);
    if (thud_scene_get(scene, key, text, size, NULL) != THUD_OK)
        snprintf(text, size, "as it was");
}

/* The change of an interface's bumper. */
void thud_remark_kept_stiffness(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_scene *scene = scope->scene, *before = scope->before;
    const struct thud_interface *is = &scene->interface[i], *was = &before->interface[i];
    const int k = own_stiffness(is);
    if (i + 1 >= before->nstructures || k < 0 || was->bumper.law != is->bumper.law ||
        was->bumper_thickness_m == is->bumper_thickness_m || was->bumper.value[k] != is->bumper.value[k])
        return;
    char text[96];
    double exponent = is->bumper.value[thud_law_param(is->bumper.law, "exponent")];
    stiffness_text(scene, i, text, sizeof text);
    thud_error_set(thud_remark_add(out), THUD_OK,
                   "%.4g cm thick, but with the stiffness for %.4g cm, %s; by eq. (6) it would be %.3g times as large",
                   100 * is->bumper_thickness_m, 100 * was->bumper_thickness_m, text,
                   pow(was->bumper_thickness_m / is->bumper_thickness_m, exponent));
}

static bool varies(const struct thud_sweep_plan *plan, const char *end)
{
    for (int a = 0; a < plan->naxes; a++)
        if (thud_ascii_ends(plan->axis[a].key, end))
            return true;
    return false;
}

/* The varied key i, of a bumper whose stiffness is a number. */
void thud_remark_kept_key(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_sweep_plan *plan = scope->plan;
    const char *key = plan->axis[i].key, *rest = key;
    const bool thickness = thud_ascii_ends(key, "bumper.thickness"), exponent = thud_ascii_ends(key, "bumper.exponent");
    int at = 0;
    if (thud_scan_word(&rest, "interfaces.") && thud_scan_count(&rest, &at))
        at--;
    const int k = at >= 0 && at + 1 < plan->scene.nstructures ? own_stiffness(&plan->scene.interface[at]) : -1;
    if ((!thickness && !exponent) || k < 0 || varies(plan, "bumper.stiffness"))
        return;
    char text[96];
    struct thud_error *said = thud_remark_add(out);
    stiffness_text(&plan->scene, at, text, sizeof text);
    if (thickness)
        thud_error_set(said, THUD_OK,
                       "the stiffness is %s at every thickness; by eq. (6) it falls with the power of the thickness",
                       text);
    else
        thud_error_set(
            said, THUD_OK,
            "the stiffness keeps the number of %s at every exponent, so the force at the ultimate strain changes",
            text);
    thud_error_key(said, "%s", key);
}
