/* Remarks on the peaks of a run, and on those of all runs of a study. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/scene/level.h"
#include "study/sweep/remark_rows.h"
#include "study/sweep/sweep_private.h"

/* Elastic storeys are not for more: codes let buildings drift by 0.5 to 2.5 % where they yield. */
static const double drift_most = 0.01;
/* Bilinear storeys that keep their strength are not for more: ASCE 7-16 allows drifts of 2 % of ordinary buildings, and
 * systems of high ductility reduce forces by about 6. */
static const double ductility_most = 6, yielding_drift_most = 0.02;
/* EN 1998-1 4.4.2.2(2) and (4) */
static const double theta_small = 0.1, theta_most = 0.3;

/* The thickness of the bumper at a contact of an interface; 0: there is none. */
static double thickness_at(const struct thud_interface *at, const struct thud_result *result, int contact)
{
    int level = 0;
    for (int c = 0; c < contact; c++)
        level += result->contact[c].interface == result->contact[contact].interface;
    return thud_interface_level(at, level).thickness_m;
}

void thud_remark_bumper(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_result *result = scope->result;
    const struct thud_interface *at = &scope->scene->interface[i];
    const double strain = thud_interface_max_strain(at), part = isnan(strain) ? 1 : strain;
    const struct thud_contact_result *most = NULL;
    double thickness = 0, worst = part;
    int count = 0, past = 0;
    for (int c = 0; c < result->ncontacts; c++) {
        const double own = result->contact[c].interface == i + 1 ? thickness_at(at, result, c) : 0;
        if (!(own > 0) || !(result->contact[c].indentation.value > worst * own))
            continue;
        most = &result->contact[c];
        thickness = own;
        worst = most->indentation.value / own;
    }
    if (!most)
        return;
    for (int k = 0; k < scope->nimpacts; k++) {
        const int c = scope->impact[k].contact;
        const double own = result->contact[c].interface == i + 1 ? thickness_at(at, result, c) : 0;
        count += own > 0;
        past += own > 0 && scope->impact[k].indentation_m > part * own;
    }
    char often[96] = "", where[48] = "";
    if (count > 0 && at->thickness.n > 0)
        snprintf(often, sizeof often, "; past that of its level in %d of %d impacts", past, count);
    else if (count > 0)
        snprintf(often, sizeof often, "; beyond %.4g mm in %d of %d impacts", 1e3 * part * thickness, past, count);
    if (most->left_floor > 0 || most->right_floor > 0)
        snprintf(where, sizeof where, " at floor %d",
                 thud_slab_floor(most->left_floor, most->right_floor, most->struck));
    struct thud_error *said = thud_remark_add(out);
    thud_error_set(said, THUD_OK, "the bumper of %.4g mm is compressed by %.4g mm%s, %.3f s: %s%s", 1e3 * thickness,
                   1e3 * most->indentation.value, where, most->indentation.time_s,
                   worst > 1 ? "more than its thickness" : "beyond its ultimate strain", often);
    if (!isnan(strain))
        thud_error_allow(said, "the rubber law applies up to %.4g mm", 1e3 * part * thickness);
}

/* The largest drift over the height of its storey (from 1) in *storey; `drift_m` of a structure's floors. */
static double worst_drift(const struct thud_structure *s, int floors, const double *drift_m, int *storey)
{
    double worst = 0;
    int slab = thud_structure_first_storey(s);
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

void thud_remark_drift(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_structure *s = &scope->scene->structure[i];
    int storey;
    double worst = thud_drift_ratio(s, &scope->result->structure[i], true, &storey);
    if (!(worst > drift_most))
        return;
    char drift[32], part[32];
    struct thud_error *said = thud_remark_add(out);
    thud_error_set(said, THUD_OK,
                   "storey %d of %.40s reaches a drift of %s mm, %s %% of its height, but is modelled as elastic",
                   storey, s->name, thud_digits(1e3 * worst * s->height_m[storey - 1], 3, drift),
                   thud_digits(100 * worst, 2, part));
    thud_error_allow(said, "buildings yield below %g %%", 100 * drift_most);
}

double thud_stability_coefficient(const struct thud_structure *structure, const struct thud_structure_result *result,
                                  int storey)
{
    int floor = storey + thud_structure_first_storey(structure);
    if (!thud_kind_is_building(structure->kind) || storey < 0 || storey >= structure->storeys)
        return NAN;
    double lean = result->floor[floor].lean.value, shear = result->floor[floor].shear.value;
    return shear > 0 ? thud_structure_weight(structure, storey) * lean / (shear * structure->height_m[storey]) : NAN;
}

void thud_remark_theta(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_structure *s = &scope->scene->structure[i];
    double worst = 0;
    int storey = 0, above = 0;
    for (int k = 0; k < s->storeys && !scope->scene->p_delta; k++) {
        double theta = thud_stability_coefficient(s, &scope->result->structure[i], k);
        above += theta > theta_small;
        if (theta > worst) {
            worst = theta;
            storey = k;
        }
    }
    if (!(worst > theta_small))
        return;
    struct thud_error *said = thud_remark_add(out);
    char others[48] = "";
    if (above > 1)
        snprintf(others, sizeof others, "; %d storeys are above %g", above, theta_small);
    thud_error_set(said, THUD_OK, "the stability coefficient of storey %d of %.40s is %.3g%s: %s", storey + 1, s->name,
                   worst, others,
                   worst > theta_most ? "it may be unstable under its own weight, which the run neglects"
                                      : "P-Delta effects, which the run neglects, increase the response");
    thud_error_allow(said, "W d/(V h) up to %g, never above %g: EN 1998-1 4.4.2.2", theta_small, theta_most);
}

/* The storey that yields furthest beyond what a bilinear one stands for. */
void thud_remark_yielding(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_structure *s = &scope->scene->structure[i];
    const struct thud_structure_result *r = &scope->result->structure[i];
    int slab = thud_structure_first_storey(s), storey = -1;
    double worst = 0;
    if (scope->result->collapse.happened && scope->result->collapse.structure == i)
        return; /* to report */
    for (int f = slab; r->storey && f < r->floors; f++) {
        double drift = r->floor[f].drift.value / s->height_m[f - slab];
        double beyond = fmax(r->storey[f].ductility / ductility_most, drift / yielding_drift_most);
        if (r->storey[f].yields && r->storey[f].ductility > 1 && beyond > worst) {
            worst = beyond;
            storey = f - slab;
        }
    }
    if (!(worst >= 1))
        return;
    double drift_m = r->floor[storey + slab].drift.value;
    char ductility[32], drift[32], part[32];
    struct thud_error *said = thud_remark_add(out);
    thud_error_set(said, THUD_OK,
                   "storey %d of %.40s reaches a ductility of %s and a drift of %s mm, %s %% of its height: a "
                   "real storey would lose strength, which is not modelled",
                   storey + 1, s->name, thud_digits(r->storey[storey + slab].ductility, 3, ductility),
                   thud_digits(1e3 * drift_m, 3, drift), thud_digits(100 * drift_m / s->height_m[storey], 2, part));
    thud_error_allow(said, "bilinear storeys are valid up to ductilities of %g and drifts of %g %%", ductility_most,
                     100 * yielding_drift_most);
}

bool thud_collapse_remark(const struct thud_scene *scene, const struct thud_collapse *c, struct thud_error *out)
{
    if (!c->happened)
        return false;
    const struct thud_structure *s = &scene->structure[c->structure];
    const int storey = thud_structure_storey(s, c->floor);
    thud_error_set(
        out, THUD_OK,
        "storey %d of %.40s collapses at %.3f s: its drift reaches %.4g mm, %.3g %% of its height. The run ends there",
        storey, s->name, c->time_s, 1e3 * c->drift_m, 100 * c->drift_m / s->height_m[storey - 1]);
    thud_error_key(out, "structures.%d", c->structure + 1);
    return true;
}

enum thud_status thud_collapse_status(const struct thud_scene *scene, const struct thud_collapse *fall,
                                      struct thud_error *err)
{
    struct thud_error why;
    if (!thud_collapse_remark(scene, fall, &why))
        return THUD_OK;
    why.status = THUD_COLLAPSED;
    if (err)
        *err = why;
    return THUD_COLLAPSED;
}

void thud_remark_collapse(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    (void)i;
    if (scope->result->collapse.happened)
        thud_collapse_remark(scope->scene, &scope->result->collapse, thud_remark_add(out));
}

/* The columns that a slab's force takes furthest above their capacity. */
void thud_remark_struck(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_column_result *worst = NULL;
    int above = 0;
    for (int k = 0; k < scope->result->ncolumns; k++) {
        const struct thud_column_result *c = &scope->result->column[k];
        if (c->structure != i || !(c->ratio > 1))
            continue;
        above++;
        worst = worst && worst->ratio > c->ratio ? worst : c;
    }
    if (!worst)
        return;
    const struct thud_peak *low = &worst->peak[THUD_COLUMN_SHEAR_LOWER], *up = &worst->peak[THUD_COLUMN_SHEAR_UPPER];
    const struct thud_peak *shear = low->value > up->value ? low : up;
    char others[48] = "", number[2][32];
    if (above > 1)
        snprintf(others, sizeof others, "; so do those of %d other storey%s", above - 1, above > 2 ? "s" : "");
    struct thud_error *said = thud_remark_add(out);
    thud_error_set(said, THUD_OK,
                   "the struck columns below floor %d of %.40s carry a shear of %s kN at %.3f s, %.3g times their "
                   "capacity, but are modelled as intact%s: later results are meaningless",
                   worst->storey, scope->scene->structure[i].name, thud_digits(1e-3 * shear->value, 4, number[0]),
                   shear->time_s, worst->ratio, others);
    thud_error_allow(said, "up to %s kN", thud_digits(1e-3 * worst->capacity_n, 4, number[1]));
}

/* Isolators bear the building's weight and, about the middle of them, its overturning moment: beyond W b/2 those at an
 * edge would have to pull. */
void thud_remark_overturning(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_structure *s = &scope->scene->structure[i];
    const struct thud_structure_result *r = &scope->result->structure[i];
    static const double part = 0.5;
    if (s->kind != THUD_ISOLATED || isnan(s->width_m))
        return;
    const double held = 0.5 * thud_isolated_weight(s) * s->width_m;
    char number[3][32];
    if (!(r->overturning.value > part * held))
        return;
    struct thud_error *said = thud_remark_add(out);
    thud_error_set(said, THUD_OK,
                   "isolators of %.40s: overturning moment %s MN m at %.3f s, %s times the restoring moment of the "
                   "weight (%s MN m); isolator uplift and axial-load variation are not modelled",
                   s->name, thud_digits(1e-6 * r->overturning.value, 4, number[0]), r->overturning.time_s,
                   thud_digits(r->overturning.value / held, 2, number[1]), thud_digits(1e-6 * held, 4, number[2]));
    thud_error_allow(said, "up to half of the weight times half the width, %s MN m",
                     thud_digits(1e-6 * part * held, 4, number[0]));
}

/* Energy that is not balanced, and contacts that made some. */
void thud_remark_energy(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    static const double exact = 1e-3, balanced = 1e-2;
    const struct thud_energy *e = &scope->result->energy;
    const bool steps = !isnan(scope->result->step_s);
    char use[80];
    snprintf(use, sizeof use,
             steps ? "at this step %s gives no valid results" : "results of %s that follow are not reliable",
             scope->result->method);
    (void)i;
    if (e->error_ratio > balanced)
        thud_error_set(thud_remark_add(out), THUD_OK, "%.2g %% of the energy is unaccounted for; %s",
                       100 * e->error_ratio, use);
    else if (-e->contact_j > balanced * (e->initial_j + e->input_j))
        thud_error_set(thud_remark_add(out), THUD_OK, "the contacts created %.3g kJ of spurious energy; %s",
                       -1e-3 * e->contact_j, use);
    else if (e->error_ratio > exact)
        thud_error_set(thud_remark_add(out), THUD_OK, "%.2g %% of the energy is unaccounted for", 100 * e->error_ratio);
}

/* A force that a small change of an input changes as a whole. */
void thud_remark_digits(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    static const char *const words[THUD_CHANGES] = {"gap", "ground motion", "stiffness of a building",
                                                    "stiffness of a building"};
    static const double whole = 0.5;
    const struct thud_sensitivity *s = scope->sensitivity;
    int most = -1;
    (void)i;
    for (int c = 0; s && c < scope->result->ncontacts; c++)
        if (most < 0 || scope->result->contact[c].force.value > scope->result->contact[most].force.value)
            most = c;
    if (most < 0 || !(thud_spread_most(&s->contact[most][0]) > whole))
        return;
    const struct thud_contact_result *contact = &scope->result->contact[most];
    const struct thud_interface *at = &scope->scene->interface[contact->interface - 1];
    const double *by = s->contact[most][0].by, depth_m = contact->indentation.value;
    const bool shallow = depth_m < s->change * (thud_interface_clearance(at) + depth_m);
    int which = 0;
    char gap[64];
    thud_interface_gap_text(at, gap, sizeof gap);
    for (int k = 1; k < THUD_CHANGES; k++)
        which = by[k] > by[which] ? k : which;
    thud_error_set(thud_remark_add(out), THUD_OK,
                   "at a gap of %s the largest force changes by %.0f %% if the %s changes by %.1g %%, because %s: read "
                   "it as an order of magnitude",
                   gap, 100 * by[which], words[which], 100 * s->change,
                   shallow ? "the floors hardly touch" : "each impact depends on those before it");
}

/* ---- the runs of a study ---- */

/* A case of a point of that scene. */
static void watch_case(struct thud_sweep_watch *w, const struct thud_scene *scene, const struct thud_sweep_point *point,
                       int k)
{
    const struct thud_sweep_floor *floor = point->floor + (ptrdiff_t)k * point->nfloors;
    const struct thud_sweep_contact *contact = point->contact + (ptrdiff_t)k * point->ncontacts;
    bool drifts = false, bumper = false, pressed = false, beyond = false, unstable = false;
    for (int s = 0; s < point->nstructures; floor += point->floors[s], s++) {
        double drift_m[THUD_STOREYS_MAX + 1];
        int storey;
        const struct thud_structure *structure = &scene->structure[s];
        int slab = thud_structure_first_storey(structure);
        for (int f = 0; f < point->floors[s]; f++) { /* those that yield are not taken as elastic */
            bool yields =
                f >= slab && f - slab < structure->storeys && isfinite(thud_structure_yield(structure, f - slab));
            drift_m[f] = yields ? 0 : floor[f].drift_m;
        }
        double ratio = worst_drift(structure, point->floors[s], drift_m, &storey);
        drifts = drifts || ratio > drift_most;
        if (ratio > w->drift.value)
            w->drift = (struct thud_sweep_worst){ratio, point->index, point->which[k], s, storey};
        for (int f = 0; f < point->floors[s] && !scene->p_delta; f++) {
            unstable = unstable || floor[f].stability > theta_small;
            if (floor[f].stability > w->theta.value)
                w->theta = (struct thud_sweep_worst){floor[f].stability, point->index, point->which[k], s,
                                                     thud_structure_storey(structure, f)};
        }
    }
    for (int c = 0; c < point->ncontacts; c++) {
        const int i = point->level[c].interface - 1;
        const double strain = thud_interface_max_strain(&scene->interface[i]),
                     thickness = thud_sweep_level_values(scene, point, k, c).thickness_m,
                     pressed_by = contact[c].indentation_m / thickness;
        if (!(thickness > 0))
            continue;
        bumper = true;
        pressed = pressed || pressed_by > (isnan(strain) ? 1 : strain);
        beyond = beyond || pressed_by > 1;
        if (pressed_by > w->press.value) {
            w->press = (struct thud_sweep_worst){pressed_by, point->index, point->which[k], i, 0};
            w->press_m = contact[c].indentation_m;
            w->thickness_m = thickness;
        }
    }
    if (point->effort[k].fall.happened && w->collapsed++ == 0) {
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
    snprintf(text, size, "case %s", thud_case_name(which));
    for (int a = 0; a < plan->naxes; a++)
        thud_append(text, size, ", %s %s", plan->axis[a].key, plan->axis[a].text[at[a]]);
    if (plan->nrecords > 1)
        thud_append(text, size, ", %.100s", plan->record[record]->file);
}

void thud_remark_collapses(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_sweep_watch *w = scope->watch;
    char where[400];
    (void)i;
    if (w->collapsed == 0)
        return;
    where_text(scope->plan, w->fall_point, w->fall_which, where, sizeof where);
    thud_error_set(thud_remark_add(out), THUD_OK,
                   "%ld of %ld runs collapse and have only the peaks until then (the first: %s)", w->collapsed, w->runs,
                   where);
}

void thud_remark_presses(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_sweep_watch *w = scope->watch;
    char where[400], beyond[64] = "";
    (void)i;
    if (w->pressed == 0)
        return;
    where_text(scope->plan, w->press.point, w->press.which, where, sizeof where);
    if (w->beyond > 0)
        snprintf(beyond, sizeof beyond, ", in %ld by more than its thickness", w->beyond);
    thud_error_set(thud_remark_add(out), THUD_OK,
                   "a bumper is compressed beyond its ultimate strain in %ld of %ld runs with a bumper%s: one of %.4g "
                   "mm by %.4g mm (%s)",
                   w->pressed, w->with_bumper, beyond, 1e3 * w->thickness_m, 1e3 * w->press_m, where);
}

void thud_remark_drifts(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_sweep_watch *w = scope->watch;
    char where[400], part[32];
    (void)i;
    if (w->drifting == 0)
        return;
    struct thud_error *said = thud_remark_add(out);
    where_text(scope->plan, w->drift.point, w->drift.which, where, sizeof where);
    thud_error_set(said, THUD_OK,
                   "drifts of storeys modelled as elastic exceed %g %% of their height in %ld of %ld runs: storey %d "
                   "of %.40s reaches %s %% (%s)",
                   100 * drift_most, w->drifting, w->runs, w->drift.storey,
                   scope->plan->scene.structure[w->drift.structure].name, thud_digits(100 * w->drift.value, 2, part),
                   where);
    thud_error_allow(said, "buildings yield below %g %%", 100 * drift_most);
}

void thud_remark_thetas(const struct thud_remark_scope *scope, int i, struct thud_remarks *out)
{
    const struct thud_sweep_watch *w = scope->watch;
    char where[400];
    (void)i;
    if (w->unstable == 0)
        return;
    struct thud_error *said = thud_remark_add(out);
    where_text(scope->plan, w->theta.point, w->theta.which, where, sizeof where);
    thud_error_set(
        said, THUD_OK,
        "the stability coefficient of storeys exceeds %g in %ld of %ld runs: %.3g at storey %d of %.40s (%s)",
        theta_small, w->unstable, w->runs, w->theta.value, w->theta.storey,
        scope->plan->scene.structure[w->theta.structure].name, where);
    thud_error_allow(said, "W d/(V h) up to %g, never above %g: EN 1998-1 4.4.2.2", theta_small, theta_most);
}
