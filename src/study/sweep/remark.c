#include "study/sweep/remark.h"
#include "base/ascii.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "base/scan.h"
#include "study/scene/level.h"
#include "study/scene/solution.h"

/* Elastic storeys are not for more: codes let buildings drift by 0.5 to 2.5 % where they yield. */
static const double drift_most = 0.01;
/* Bilinear storeys that keep their strength are not for more: ASCE 7-16 allows drifts of 2 % of ordinary buildings, and
 * systems of high ductility reduce forces by about 6. */
static const double ductility_most = 6, yielding_drift_most = 0.02;
/* EN 1998-1 4.4.2.2(2) and (4) */
static const double theta_small = 0.1, theta_most = 0.3;

static const struct thud_contact_result *deepest(const struct thud_result *result, int interface)
{
    const struct thud_contact_result *most = NULL;
    for (int c = 0; c < result->ncontacts; c++)
        if (result->contact[c].interface == interface &&
            (!most || result->contact[c].indentation.value > most->indentation.value))
            most = &result->contact[c];
    return most;
}

static bool look_bumper(const struct thud_scene *scene, int i, const struct thud_result *result,
                        const struct thud_impact *impact, int nimpacts, struct thud_error *out)
{
    const struct thud_interface *at = &scene->interface[i];
    double strain = thud_interface_max_strain(at), thickness = at->bumper_thickness_m;
    double limit = isnan(strain) ? thickness : strain * thickness;
    const struct thud_contact_result *most = at->has_bumper ? deepest(result, i + 1) : NULL;
    int count = 0, past = 0;
    if (!most || !(most->indentation.value > limit))
        return false;
    for (int k = 0; k < nimpacts; k++)
        if (result->contact[impact[k].contact].interface == i + 1) {
            count++;
            past += impact[k].indentation_m > limit;
        }
    char often[96] = "", where[48] = "";
    if (count > 0)
        snprintf(often, sizeof often, "; past %.4g mm in %d of %d impacts", 1e3 * limit, past, count);
    if (most->left_floor > 0 || most->right_floor > 0)
        snprintf(where, sizeof where, " at floor %d",
                 thud_slab_floor(most->left_floor, most->right_floor, most->struck));
    thud_error_set(out, THUD_OK, "the bumper of %.4g mm is pressed by %.4g mm%s, %.3f s: %s%s", 1e3 * thickness,
                   1e3 * most->indentation.value, where, most->indentation.time_s,
                   most->indentation.value > thickness ? "more than there is of it" : "past its ultimate strain",
                   often);
    if (!isnan(strain))
        thud_error_allow(out, "up to %.4g mm it is rubber that acts", 1e3 * limit);
    thud_error_key(out, "interfaces.%d.bumper", i + 1);
    return true;
}

/* The largest drift over the height of its storey (from 1) in *storey; `drift_m` of a structure's floors. */
static double worst_drift(const struct thud_structure *s, int floors, const double *drift_m, int *storey)
{
    double worst = 0;
    int slab = s->kind == THUD_ISOLATED;
    *storey = 0;
    for (int f = slab; f < floors && thud_kind_is_building(s->kind); f++) {
        double ratio = drift_m[f] / s->height_m[f - slab];
        if (ratio > worst) {
            worst = ratio;
            *storey = f - slab + 1;
        }
    }
    return worst;
}

double thud_drift_ratio(const struct thud_structure *structure, const struct thud_structure_result *result,
                        bool elastic, int *storey)
{
    double drift_m[THUD_STOREYS_MAX + 1];
    for (int f = 0; f < result->floors; f++)
        drift_m[f] = elastic && result->storey && result->storey[f].yields ? 0 : result->floor[f].drift.value;
    return worst_drift(structure, result->floors, drift_m, storey);
}

static bool look_drift(const struct thud_structure *s, const struct thud_structure_result *r, int index,
                       struct thud_error *out)
{
    int storey;
    double worst = thud_drift_ratio(s, r, true, &storey);
    if (!(worst > drift_most))
        return false;
    thud_error_set(out, THUD_OK, "storey %d of %.40s drifts by %.3g mm, %.2g %% of its height, and is taken as elastic",
                   storey, s->name, 1e3 * worst * s->height_m[storey - 1], 100 * worst);
    thud_error_allow(out, "buildings yield before %g %%", 100 * drift_most);
    thud_error_key(out, "structures.%d", index + 1);
    return true;
}

double thud_stability_coefficient(const struct thud_structure *structure, const struct thud_structure_result *result,
                                  int storey)
{
    int floor = storey + (structure->kind == THUD_ISOLATED);
    if (!thud_kind_is_building(structure->kind) || storey < 0 || storey >= structure->storeys)
        return NAN;
    double drift = result->floor[floor].drift.value, shear = result->floor[floor].shear.value;
    return shear > 0 ? thud_structure_weight(structure, storey) * drift / (shear * structure->height_m[storey]) : NAN;
}

static bool look_theta(const struct thud_structure *s, const struct thud_structure_result *r, int index,
                       struct thud_error *out)
{
    double worst = 0;
    int storey = 0, above = 0;
    for (int i = 0; i < s->storeys; i++) {
        double theta = thud_stability_coefficient(s, r, i);
        above += theta > theta_small;
        if (theta > worst) {
            worst = theta;
            storey = i;
        }
    }
    if (!(worst > theta_small))
        return false;
    char others[48] = "";
    if (above > 1)
        snprintf(others, sizeof others, "; %d storeys are above %g", above, theta_small);
    thud_error_set(out, THUD_OK, "%sthe stability coefficient of storey %d of %.40s is %.3g%s: %s",
                   worst > theta_most ? "caution: " : "", storey + 1, s->name, worst, others,
                   worst > theta_most ? "it may not stand under its own weight, which the run leaves out"
                                      : "the weight on the drift, which the run leaves out, adds to the response");
    thud_error_allow(out, "W d/(V h) up to %g, never above %g: EN 1998-1 4.4.2.2", theta_small, theta_most);
    thud_error_key(out, "structures.%d", index + 1);
    return true;
}

/* The storey that yields furthest beyond what a bilinear one stands for. */
static bool look_yielding(const struct thud_structure *s, const struct thud_structure_result *r, int index,
                          struct thud_error *out)
{
    int slab = s->kind == THUD_ISOLATED, storey = -1;
    double worst = 0;
    for (int f = slab; r->storey && f < r->floors; f++) {
        double drift = r->floor[f].drift.value / s->height_m[f - slab];
        double beyond = fmax(r->storey[f].ductility / ductility_most, drift / yielding_drift_most);
        if (r->storey[f].yields && r->storey[f].ductility > 1 && beyond > worst) {
            worst = beyond;
            storey = f - slab;
        }
    }
    if (!(worst >= 1))
        return false;
    double drift_m = r->floor[storey + slab].drift.value;
    thud_error_set(
        out, THUD_OK,
        "storey %d of %.40s yields to a ductility of %.3g and drifts by %.3g mm, %.2g %% of its height: a real "
        "storey loses strength there, this one does not",
        storey + 1, s->name, r->storey[storey + slab].ductility, 1e3 * drift_m, 100 * drift_m / s->height_m[storey]);
    thud_error_allow(out, "bilinear storeys stand for ductilities up to %g and drifts up to %g %%", ductility_most,
                     100 * yielding_drift_most);
    thud_error_key(out, "structures.%d.yield", index + 1);
    return true;
}

bool thud_collapse_remark(const struct thud_scene *scene, const struct thud_result *result, struct thud_error *out)
{
    const struct thud_collapse *c = &result->collapse;
    if (!c->happened)
        return false;
    const struct thud_structure *s = &scene->structure[c->structure];
    const int storey = thud_structure_storey(s, c->floor);
    thud_error_set(out, THUD_OK,
                   "storey %d of %.40s collapses at %.3f s: its drift comes to %.4g mm, %.3g %% of its height, and the "
                   "run ends there",
                   storey, s->name, c->time_s, 1e3 * c->drift_m, 100 * c->drift_m / s->height_m[storey - 1]);
    thud_error_key(out, "structures.%d", c->structure + 1);
    return true;
}

enum thud_status thud_collapse_status(const struct thud_scene *scene, const struct thud_result *result,
                                      struct thud_error *err)
{
    struct thud_error fall;
    if (!thud_collapse_remark(scene, result, &fall))
        return THUD_OK;
    fall.status = THUD_COLLAPSED;
    if (err)
        *err = fall;
    return THUD_COLLAPSED;
}

bool thud_storey_remark(const struct thud_scene *scene, const struct thud_result *result, int n, struct thud_error *out)
{
    if (thud_collapse_remark(scene, result, out) && n-- == 0)
        return true;
    for (int s = 0; s < scene->nstructures; s++) {
        const bool collapsed = result->collapse.happened && result->collapse.structure == s; /* that is told */
        if (!collapsed && look_yielding(&scene->structure[s], &result->structure[s], s, out) && n-- == 0)
            return true;
        if (!scene->p_delta && look_theta(&scene->structure[s], &result->structure[s], s, out) && n-- == 0)
            return true;
    }
    return false;
}

/* The columns that a slab's force takes furthest above their capacity. */
static bool look_columns(const struct thud_scene *scene, const struct thud_result *result, int structure,
                         struct thud_error *out)
{
    const struct thud_column_result *worst = NULL;
    int above = 0;
    for (int i = 0; i < result->ncolumns; i++) {
        const struct thud_column_result *c = &result->column[i];
        if (c->structure != structure || !(c->ratio > 1))
            continue;
        above++;
        worst = worst && worst->ratio > c->ratio ? worst : c;
    }
    if (!worst)
        return false;
    const struct thud_peak *low = &worst->peak[THUD_COLUMN_SHEAR_LOWER], *up = &worst->peak[THUD_COLUMN_SHEAR_UPPER];
    const struct thud_peak *shear = low->value > up->value ? low : up;
    char others[48] = "";
    if (above > 1)
        snprintf(others, sizeof others, "; so do those of %d other storey%s", above - 1, above > 2 ? "s" : "");
    thud_error_set(out, THUD_OK,
                   "the struck columns below floor %d of %.40s bear a shear of %.4g kN at %.3f s, %.3g times what they "
                   "can, and are taken as whole%s",
                   worst->storey, scene->structure[structure].name, 1e-3 * shear->value, shear->time_s, worst->ratio,
                   others);
    thud_error_allow(out, "up to %.4g kN", 1e-3 * worst->capacity_n);
    thud_error_key(out, "structures.%d.column.capacity", structure + 1);
    return true;
}

/* Isolators bear the building's weight and, about the middle of them, its overturning moment: beyond W b/2 those at an
 * edge would have to pull. */
static bool look_overturning(const struct thud_structure *s, const struct thud_structure_result *r, int index,
                             struct thud_error *out)
{
    static const double part = 0.5;
    if (s->kind != THUD_ISOLATED || isnan(s->width_m))
        return false;
    const double held = 0.5 * thud_isolated_weight(s) * s->width_m;
    if (!(r->overturning.value > part * held))
        return false;
    thud_error_set(out, THUD_OK,
                   "the overturning moment of %.40s about its isolators comes to %.4g MN m at %.3f s, %.2g times what "
                   "its weight holds (%.4g MN m): uplift of isolators, and how the load on them changes, are left out",
                   s->name, 1e-6 * r->overturning.value, r->overturning.time_s, r->overturning.value / held,
                   1e-6 * held);
    thud_error_allow(out, "up to half of the weight times half the width, %.4g MN m", 1e-6 * part * held);
    thud_error_key(out, "structures.%d.width", index + 1);
    return true;
}

bool thud_result_remark(const struct thud_scene *scene, const struct thud_result *result,
                        const struct thud_impact *impact, int nimpacts, int n, struct thud_error *out)
{
    for (int s = 0; s < scene->nstructures; s++)
        assert(result->structure[s].floors == thud_structure_floors(&scene->structure[s]));
    for (int i = 0; i + 1 < scene->nstructures; i++)
        if (look_bumper(scene, i, result, impact, nimpacts, out) && n-- == 0)
            return true;
    for (int s = 0; s < scene->nstructures; s++)
        if (look_drift(&scene->structure[s], &result->structure[s], s, out) && n-- == 0)
            return true;
    for (int s = 0; s < scene->nstructures; s++)
        if (look_columns(scene, result, s, out) && n-- == 0)
            return true;
    for (int s = 0; s < scene->nstructures; s++)
        if (look_overturning(&scene->structure[s], &result->structure[s], s, out) && n-- == 0)
            return true;
    return thud_storey_remark(scene, result, n, out);
}

static double fastest_mode(const struct thud_scene *scene)
{
    struct thud_model *model;
    if (thud_scene_assemble(scene, &model, NULL) != THUD_OK)
        return 0;
    double fastest = model->fastest_radps;
    thud_model_free(model);
    return fastest;
}

bool thud_scene_effort_remark(const struct thud_scene *scene, const struct thud_record *record, struct thud_error *out)
{
    /* measured on one processor: 20 buildings of 200 storeys under 4001 samples, and a floor of 1 kg on
     * 1e4 MN/m; a large model is too dear to be made for its fastest mode alone */
    static const double each_floors_s = 5e-9, each_series_s = 5e-7, long_s = 5;
    static const int large = 1000;
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
    seconds = each_floors_s * samples * squares;
    if (floors <= large)
        seconds += each_series_s * floors * end_s * fastest_mode(scene) / 1.8;
    if (seconds < long_s)
        return false;
    bytes = 16 * contacts * (floors + contacts) + 25000 * floors; /* with the run without contact for the needed gap */
    const bool minutes = seconds >= 120;
    thud_error_set(out, THUD_OK,
                   "%.0f floors, up to %.0f contacts, %.0f samples: a run takes about %.2g GB and %.2g %s, and several "
                   "times that with much contact",
                   floors, contacts, samples, fmax(bytes / 1e9, 0.01), minutes ? seconds / 60 : seconds,
                   minutes ? "min" : "s");
    thud_error_key(out, "analysis");
    thud_error_allow(out, "analysis.modes leaves each building's high modes out");
    return true;
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

bool thud_scene_change_remark(const struct thud_scene *before, const struct thud_scene *scene, int n,
                              struct thud_error *out)
{
    for (int i = 0; i + 1 < scene->nstructures && i + 1 < before->nstructures; i++) {
        const struct thud_interface *was = &before->interface[i], *is = &scene->interface[i];
        int k = own_stiffness(is);
        if (k < 0 || was->bumper.law != is->bumper.law || was->bumper_thickness_m == is->bumper_thickness_m ||
            was->bumper.value[k] != is->bumper.value[k] || n-- > 0)
            continue;
        char text[96];
        double exponent = is->bumper.value[thud_law_param(is->bumper.law, "exponent")];
        stiffness_text(scene, i, text, sizeof text);
        thud_error_set(out, THUD_OK,
                       "%.4g cm thick now, with the stiffness of %.4g cm, %s; by eq. (6) it would be %.3g times that",
                       100 * is->bumper_thickness_m, 100 * was->bumper_thickness_m, text,
                       pow(was->bumper_thickness_m / is->bumper_thickness_m, exponent));
        thud_error_allow(out, "alpha, area and material-stiffness in place of stiffness make it follow");
        thud_error_key(out, "interfaces.%d.bumper.thickness", i + 1);
        return true;
    }
    return false;
}

static bool varies(const struct thud_sweep_plan *plan, const char *end)
{
    for (int a = 0; a < plan->naxes; a++)
        if (thud_ascii_ends(plan->axis[a].key, end))
            return true;
    return false;
}

bool thud_sweep_remark(const struct thud_sweep_plan *plan, int n, struct thud_error *out)
{
    for (int a = 0; a < plan->naxes; a++) {
        const char *key = plan->axis[a].key;
        bool thickness = thud_ascii_ends(key, "bumper.thickness"), exponent = thud_ascii_ends(key, "bumper.exponent");
        int i = 0, k;
        const char *rest = key;
        if (thud_scan_word(&rest, "interfaces.") && thud_scan_count(&rest, &i))
            i--;
        k = i >= 0 && i + 1 < plan->scene.nstructures ? own_stiffness(&plan->scene.interface[i]) : -1;
        if ((!thickness && !exponent) || k < 0 || varies(plan, "bumper.stiffness") || n-- > 0)
            continue;
        char text[96];
        stiffness_text(&plan->scene, i, text, sizeof text);
        if (thickness)
            thud_error_set(
                out, THUD_OK,
                "the stiffness is %s at every thickness; by eq. (6) it falls with the power of the thickness", text);
        else
            thud_error_set(out, THUD_OK,
                           "the stiffness keeps the number of %s at every exponent, so that the force at the largest "
                           "strain changes with it",
                           text);
        thud_error_allow(out, "alpha, area and material-stiffness in place of stiffness make it follow");
        thud_error_key(out, "%s", key);
        return true;
    }
    return false;
}

/* ---- the runs of a study ---- */

/* The largest stability coefficient W/(k h) of a building's elastic storeys that drift; a point has no shear of those
 * that yield. */
static double worst_theta(const struct thud_structure *s, const double *drift_m, int *storey)
{
    const int slab = s->kind == THUD_ISOLATED;
    double worst = 0;
    for (int i = 0; thud_kind_is_building(s->kind) && i < s->storeys; i++) {
        double theta = thud_structure_weight(s, i) / (s->stiffness_npm[i] * s->height_m[i]);
        if (drift_m[i + slab] > 0 && theta > worst) {
            worst = theta;
            *storey = i + 1;
        }
    }
    return worst;
}

/* A case of a point of that scene. */
static void watch_case(struct thud_sweep_watch *w, const struct thud_scene *scene, const struct thud_sweep_point *point,
                       int k)
{
    const struct thud_sweep_floor *floor = point->floor + (ptrdiff_t)k * point->nfloors;
    const struct thud_sweep_contact *contact = point->contact + (ptrdiff_t)k * point->ncontacts;
    const bool bumpers = point->which[k] != THUD_CASE_NONE && point->which[k] != THUD_CASE_LINK;
    bool drifts = false, bumper = false, pressed = false, beyond = false, falls = false, unstable = false;
    for (int s = 0; s < point->nstructures; floor += point->floors[s], s++) {
        double drift_m[THUD_STOREYS_MAX + 1];
        int storey;
        const struct thud_structure *structure = &scene->structure[s];
        int slab = structure->kind == THUD_ISOLATED;
        for (int f = 0; f < point->floors[s]; f++) { /* those that yield are not taken as elastic */
            bool yields =
                f >= slab && f - slab < structure->storeys && isfinite(thud_structure_yield(structure, f - slab));
            drift_m[f] = yields ? 0 : floor[f].drift_m;
            falls = falls || (scene->p_delta && f >= slab && thud_kind_is_building(structure->kind) &&
                              floor[f].drift_m > THUD_COLLAPSE_DRIFT * (1 - 1e-9) * structure->height_m[f - slab]);
        }
        double ratio = worst_drift(structure, point->floors[s], drift_m, &storey);
        drifts = drifts || ratio > drift_most;
        if (ratio > w->drift.value)
            w->drift = (struct thud_sweep_worst){ratio, point->index, point->which[k], s, storey};
        double theta = scene->p_delta ? 0 : worst_theta(structure, drift_m, &storey);
        unstable = unstable || theta > theta_small;
        if (theta > w->theta.value)
            w->theta = (struct thud_sweep_worst){theta, point->index, point->which[k], s, storey};
    }
    for (int c = 0; c < point->ncontacts; c++) {
        int i = point->level[c].interface - 1;
        const struct thud_interface *at = &scene->interface[i];
        double strain = thud_interface_max_strain(at), thickness = at->bumper_thickness_m;
        if (!bumpers || !at->has_bumper || !(thickness > 0))
            continue;
        bumper = true;
        pressed = pressed || contact[c].indentation_m > (isnan(strain) ? 1 : strain) * thickness;
        beyond = beyond || contact[c].indentation_m > thickness;
        if (contact[c].indentation_m / thickness > w->press.value) {
            w->press =
                (struct thud_sweep_worst){contact[c].indentation_m / thickness, point->index, point->which[k], i, 0};
            w->press_m = contact[c].indentation_m;
            w->thickness_m = thickness;
        }
    }
    if (falls && w->collapsed++ == 0) {
        w->fall_point = point->index;
        w->fall_which = point->which[k];
    }
    w->runs++;
    w->drifting += drifts;
    w->unstable += unstable;
    w->with_bumper += bumper;
    w->pressed += pressed;
    w->beyond += beyond;
}

enum thud_status thud_sweep_watch_add(struct thud_sweep_watch *watch, const struct thud_sweep_plan *plan,
                                      const struct thud_sweep_point *point, struct thud_error *err)
{
    struct thud_scene *scene = malloc(sizeof *scene);
    if (!scene)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = thud_sweep_scene(plan, point->index, scene, err);
    for (int k = 0; k < point->ncases && status == THUD_OK; k++)
        if (!point->effort[k].reference && point->effort[k].status == THUD_OK)
            watch_case(watch, scene, point, k);
    free(scene);
    return status;
}

/* "case bumper, gap 5 cm, kobe.csv" */
static void where_text(const struct thud_sweep_plan *plan, long point, enum thud_case which, char *text, size_t size)
{
    int at[THUD_VARY_MAX], record = thud_sweep_place(plan, point, at);
    int n = snprintf(text, size, "case %s", thud_case_name(which));
    for (int a = 0; a < plan->naxes && n > 0 && (size_t)n < size; a++)
        n += snprintf(text + n, size - (size_t)n, ", %s %s", plan->axis[a].key, plan->axis[a].text[at[a]]);
    if (plan->nrecords > 1 && n > 0 && (size_t)n < size)
        snprintf(text + n, size - (size_t)n, ", %.100s", plan->record[record]->file);
}

bool thud_sweep_watch_remark(const struct thud_sweep_watch *w, const struct thud_sweep_plan *plan, int n,
                             struct thud_error *out)
{
    char where[400], beyond[64] = "";
    if (w->collapsed > 0 && n-- == 0) {
        where_text(plan, w->fall_point, w->fall_which, where, sizeof where);
        thud_error_set(out, THUD_OK, "%ld of %ld runs collapse, and have the peaks before that (the first: %s)",
                       w->collapsed, w->runs, where);
        return true;
    }
    if (w->pressed > 0 && n-- == 0) {
        where_text(plan, w->press.point, w->press.which, where, sizeof where);
        if (w->beyond > 0)
            snprintf(beyond, sizeof beyond, ", in %ld by more than there is of it", w->beyond);
        thud_error_set(out, THUD_OK,
                       "a bumper is pressed past its ultimate strain in %ld of %ld runs with one%s: one of %.4g mm by "
                       "%.4g mm (%s)",
                       w->pressed, w->with_bumper, beyond, 1e3 * w->thickness_m, 1e3 * w->press_m, where);
        return true;
    }
    if (w->drifting > 0 && n-- == 0) {
        where_text(plan, w->drift.point, w->drift.which, where, sizeof where);
        thud_error_set(out, THUD_OK,
                       "storeys drift by more than %g %% of their height in %ld of %ld runs, and are taken as elastic: "
                       "storey %d of %.40s by %.2g %% (%s)",
                       100 * drift_most, w->drifting, w->runs, w->drift.storey,
                       plan->scene.structure[w->drift.structure].name, 100 * w->drift.value, where);
        thud_error_allow(out, "buildings yield before %g %%", 100 * drift_most);
        return true;
    }
    if (w->unstable > 0 && n-- == 0) {
        where_text(plan, w->theta.point, w->theta.which, where, sizeof where);
        thud_error_set(out, THUD_OK,
                       "%sthe stability coefficient of elastic storeys is above %g in %ld of %ld runs: %.3g at storey "
                       "%d of %.40s (%s)",
                       w->theta.value > theta_most ? "caution: " : "", theta_small, w->unstable, w->runs,
                       w->theta.value, w->theta.storey, plan->scene.structure[w->theta.structure].name, where);
        thud_error_allow(out, "W d/(V h) up to %g, never above %g: EN 1998-1 4.4.2.2", theta_small, theta_most);
        return true;
    }
    return false;
}
