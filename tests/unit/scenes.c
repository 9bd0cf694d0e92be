#include "scenes.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "core/model/modes.h"
#include "core/run/baseline.h"
#include "study/scene/building.h"
#include "study/scene/level.h"

/* ---- chance: SplitMix64 (Steele, Lea and Flood 2014) ---- */

static unsigned long long state;
static bool coarse, equal; /* the scene that is drawn is of SCENES_COARSE, of SCENES_EQUAL */

static unsigned long long next(void)
{
    unsigned long long z = state += 0x9e3779b97f4a7c15ull;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ z >> 27) * 0x94d049bb133111ebull;
    return z ^ z >> 31;
}

static double between(double a, double b)
{
    return a + (b - a) * (double)(next() >> 11) * 0x1p-53;
}

static double between_log(double a, double b)
{
    return a * pow(b / a, between(0, 1));
}

static int below(int n)
{
    return (int)(next() % (unsigned long long)n);
}

static bool chance(double p)
{
    return between(0, 1) < p;
}

static double one_of(const double *list, int n)
{
    return list[below(n)];
}
#define ONE_OF(...) one_of((const double[]){__VA_ARGS__}, (int)(sizeof((double[]){__VA_ARGS__}) / sizeof(double)))

/* ---- structures ---- */

/* The stiffness that gives n equal floors on n equal storeys this first period. */
static double storey_stiffness(int n, double mass, double period)
{
    double s = THUD_PI / period / sin(THUD_PI / (2 * (2 * n + 1)));
    return mass * s * s;
}

static void draw_floors(struct thud_structure *s, double mass, double period)
{
    double stiffness = storey_stiffness(s->storeys, mass, period);
    bool uneven = chance(0.4), tall = chance(0.2), half = chance(0.1);
    for (int i = 0; i < s->storeys; i++) {
        s->mass_kg[i] = mass * (uneven ? between(0.5, 1.5) : 1);
        s->stiffness_npm[i] = stiffness * (uneven ? between_log(0.5, 2) : 1);
        s->height_m[i] = tall && i == 0 ? 4.5 : half ? 1.5 : 3;
    }
}

/* The least and the largest mass of a floor in a wide scene, and the largest stiffness that a preset may have. */
static const double lightest_kg = 1e-3, heaviest_kg = 1e9, stiffest_npm = 1e12;

/* How far the fastest motion of a wide scene may turn: a run takes a series for each 1.8 rad. */
static const double longest_rad = 1e5;

static double within(double least, double value, double most)
{
    return fmin(fmax(value, least), most);
}

/* Light and heavy floors in one building, dashpots up to the critical ones, and speeds at the start. */
static void widen(struct thud_structure *s)
{
    bool uneven = chance(0.5);
    s->damping = ONE_OF(0, 0.05, 1, between(0, 1), between(0, 1));
    s->isolation_damping = ONE_OF(0, 0.1, 1, between(0, 1), between(0, 1));
    for (int i = 0; i < s->storeys; i++) {
        s->mass_kg[i] = within(lightest_kg, s->mass_kg[i] * (uneven ? between_log(1e-3, 1e3) : 1), heaviest_kg);
        s->stiffness_npm[i] = fmin(s->stiffness_npm[i], stiffest_npm);
    }
    if (s->kind == THUD_RIGID)
        s->velocity_mps = chance(0.3) ? 0 : (chance(0.5) ? -1 : 1) * between_log(1e-3, 50);
    if (s->kind == THUD_ISOLATED) {
        s->base_mass_kg = within(lightest_kg, s->base_mass_kg * between_log(1e-3, 1e3), heaviest_kg);
        s->isolation_stiffness_npm = fmin(s->isolation_stiffness_npm, stiffest_npm);
    }
}

/* Storeys of heights that seldom are a neighbour's, a ground of its own, and columns that give and bear. */
static void draw_columns(struct thud_structure *s)
{
    double height = ONE_OF(3, 3, 3.6, 2.7, 4.2, 3.005, 1.3, between(1, 5)), part = between_log(1e-3, 0.5);
    bool uneven = chance(0.3), give = chance(0.7), some = chance(0.2), bear = chance(0.5);
    s->base_m = ONE_OF(0, 0, 0, 0.004, -1.4, 1.1, between(-3, 3));
    s->column_shape = chance(0.2) ? THUD_COLUMN_LINEAR : THUD_COLUMN_CLAMPED;
    for (int i = 0; i < s->storeys; i++) {
        double h = s->height_m[i] = uneven ? between(1, 5) : height;
        bool here = give && !(some && chance(0.5)), by_storey = here && chance(0.3);
        s->column_ei_nm2[i] = here && !by_storey ? part * s->stiffness_npm[i] * h * h * h / 12 : 0;
        s->column_stiffness_npm[i] = by_storey ? part * s->stiffness_npm[i] : 0;
        s->column_capacity_n[i] = bear ? 1e6 : 0;
    }
}

static void draw_structure(struct thud_structure *s, int index, double mass, bool extreme, bool wide)
{
    int pick = wide ? 8 + below(12) : below(20);
    thud_structure_init(s, pick < 12 ? THUD_SHEAR : pick < 15 ? THUD_RIGID : pick < 18 ? THUD_ISOLATED : THUD_WALL);
    snprintf(s->name, sizeof s->name, "%c", 'A' + index);
    double m = mass * (extreme ? between_log(1e-3, 1e3) : between_log(0.3, 3));
    s->storeys = s->kind == THUD_WALL ? 0 : s->kind == THUD_RIGID ? 1 : 1 + below(chance(0.3) ? 12 : 4);
    s->damping = ONE_OF(0, 0.001, 0.02, 0.05, 0.05, 0.05, 0.2, between(0, 0.2), 0.7);
    if (s->kind == THUD_SHEAR || s->kind == THUD_ISOLATED)
        draw_floors(s, m, extreme ? between_log(0.005, 20) : between_log(coarse ? 0.02 : 0.1, 2));
    if (s->kind == THUD_RIGID) {
        s->mass_kg[0] = m;
        s->height_m[0] = chance(0.5) ? NAN : 3.0 * (1 + below(3));
        s->velocity_mps = chance(0.5) ? 0 : between(-1, 1);
    }
    if (s->kind == THUD_WALL)
        s->height_m[0] = chance(0.7) ? INFINITY : 3.0 * below(4);
    if (s->kind == THUD_ISOLATED) {
        double total = s->base_mass_kg = m * between_log(0.3, 3), w = 2 * THUD_PI / between_log(0.8, 4);
        for (int i = 0; i < s->storeys; i++)
            total += s->mass_kg[i];
        s->isolation_stiffness_npm = total * w * w;
        s->isolation_damping = ONE_OF(0, 0.1, 0.1, 0.3, 0.6);
    }
    if (wide)
        widen(s);
}

/* Lead-rubber bearings and pendulums, from such as hardly move to such as slide all the time. */
static bool draw_isolators(struct thud_scene *scene)
{
    bool any = false;
    for (int s = 0; s < scene->nstructures; s++) {
        struct thud_structure *p = &scene->structure[s];
        if (p->kind != THUD_ISOLATED)
            continue;
        double mass = p->base_mass_kg;
        for (int i = 0; i < p->storeys; i++)
            mass += p->mass_kg[i];
        any = true;
        if (p->isolation_damping > 0 && chance(0.7))
            p->isolation_damping = NAN;
        p->isolator_yield_m = between_log(1e-4, 2e-2);
        p->isolator_law = chance(0.5) ? THUD_ISOLATOR_PENDULUM : THUD_ISOLATOR_LEAD_RUBBER;
        if (p->isolator_law == THUD_ISOLATOR_PENDULUM) {
            p->isolator_radius_m = between_log(0.5, 5);
            p->isolator_friction = between_log(0.01, 0.2);
        } else {
            p->isolator_post_yield_npm = p->isolation_stiffness_npm;
            p->isolator_strength_n = mass * between_log(0.1, 2);
        }
        p->isolation_stiffness_npm = NAN; /* of linear ones */
    }
    return any;
}

/* Walls from such as hardly move to such as swing by themselves, with soil behind those at the ends of the row. */
static bool draw_walls(struct thud_scene *scene, double mass)
{
    bool any = false;
    for (int s = 0; s < scene->nstructures; s++) {
        struct thud_structure *p = &scene->structure[s];
        double w = 2 * THUD_PI / between_log(0.02, 0.5);
        if (p->kind != THUD_WALL || chance(0.2))
            continue;
        any = true;
        p->wall_mass_kg = mass * between_log(1e-3, 0.3);
        p->wall_stiffness_npm = p->wall_mass_kg * w * w;
        p->wall_damping = ONE_OF(NAN, 0, 0.02, 0.3);
        if ((s > 0 && s + 1 < scene->nstructures) || scene->nstructures == 1 || chance(0.2))
            continue;
        p->backfill_stiffness_npm = p->wall_stiffness_npm * between_log(0.1, 10);
        p->backfill_strength_n = mass * between_log(0.3, 30);
        p->backfill_ratio = ONE_OF(NAN, 0.7, between(0.1, 0.99));
        p->backfill_gap_m = chance(0.7) ? NAN : between_log(1e-4, 0.02);
    }
    return any;
}

/* From soil that hardly gives to such as has a building sway and rock by as much as it drifts; dashpots from none to twice
 * the critical ones; springs and dashpots given, or of the soil. */
static void draw_soil(struct thud_structure *p)
{
    double mass = p->base_mass_kg, height = 0, w = 2 * THUD_PI / between_log(0.05, 1);
    if (!thud_kind_is_building(p->kind) || chance(0.25))
        return;
    for (int i = 0; i < p->storeys; i++) {
        mass += p->mass_kg[i];
        height += p->height_m[i];
    }
    p->foundation_mass_kg = mass * between_log(0.05, 1);
    if (chance(0.3)) {
        p->soil_vs_mps = between_log(100, 800);
        p->soil_density_kgpm3 = between(1500, 2200) * fmin(mass / 1e6, 1);
        p->foundation_radius_m = between(5, 12);
        return;
    }
    p->foundation_inertia_kgm2 = p->foundation_mass_kg * height * height * between_log(0.01, 0.3);
    p->sway_npm = mass * w * w;
    p->rocking_nmprad = p->sway_npm * height * height * between_log(0.1, 3);
    p->sway_nspm = chance(0.2) ? 0 : 2 * between_log(0.01, 2) * mass * w;
    p->rocking_nmsprad = chance(0.2) ? 0 : p->sway_nspm * height * height * between_log(0.03, 1);
}

/* Weights that take up to a third off the stiffness of the weakest storey. */
static void draw_weights(struct thud_scene *scene)
{
    scene->p_delta = true;
    for (int s = 0; s < scene->nstructures; s++) {
        struct thud_structure *p = &scene->structure[s];
        double least = INFINITY, part = between_log(0.01, 0.35);
        for (int i = 0; i < p->storeys && thud_kind_is_building(p->kind); i++)
            least = fmin(least, p->stiffness_npm[i] * p->height_m[i]);
        for (int i = 0; i < p->storeys && thud_kind_is_building(p->kind); i++)
            p->gravity_n[i] = part * least / p->storeys;
    }
}

/* ---- ground motion ---- */

static void draw_record(struct scenes_one *one)
{
    int n = 2 + below(chance(0.5) ? 60 : 500), kind = below(5), quiet = chance(0.3) ? below(n) : 0;
    double dt = ONE_OF(0.02, 0.01, 0.005, 0.0137, 0.1, 1.0 / 3, 0.02, 0.01), *a = calloc((size_t)n, sizeof *a);
    double w = 2 * THUD_PI / between_log(0.15, 2), most = 0, walk = 0;
    assert(a);
    dt = coarse ? between_log(0.08, 0.6) : dt;
    const double longest_s = coarse ? 20 : 8;
    n = (n - 1) * dt > longest_s ? 1 + (int)(longest_s / dt) : n;
    n = n < 2 ? 2 : n;
    for (int i = quiet < n ? quiet : 0; i < n; i++) {
        double t = i * dt;
        walk = 0.9 * walk + between(-1, 1);
        a[i] = kind == 0   ? sin(w * t)
               : kind == 1 ? walk * sin(w * t)
               : kind == 2 ? (chance(0.1) ? between(-1, 1) : 0)
               : kind == 3 ? (t < 0.5 * n * dt ? 1
                              : chance(0.5)    ? -1
                                               : 0)
                           : walk;
    }
    for (int i = 0; i < n; i++)
        most = fmax(most, fabs(a[i]));
    double peak = chance(0.2) ? between_log(1e-6, 1e3) : between_log(0.5, 20);
    for (int i = 0; i < n && most > 0; i++)
        a[i] *= peak / most;
    enum thud_status status = thud_record_create(a, (size_t)n, dt, &one->record, NULL);
    assert(status == THUD_OK);
    (void)status;
    free(a);
    strcpy(one->scene.record.file, "drawn");
    strcpy(one->record->file, "drawn");
    one->scene.analysis.tail_s = ONE_OF(0, 1, between(0, 2), 5 * dt, 1e-3);
}

/* ---- interfaces ---- */

static void set_value(struct thud_law_choice *choice, const char *name, double value)
{
    int i = thud_law_param(choice->law, name);
    if (i >= 0)
        choice->value[i] = value;
}

/* A law whose contact of this mass takes about a quarter of the period, at indentations near `size_m`. */
static void draw_law(struct thud_law_choice *choice, const char *name, double mass, double size_m)
{
    double w = 2 * THUD_PI / between_log(coarse ? 0.03 : 0.004, coarse ? 10 : 0.3), k = mass * w * w;
    thud_law_choice_init(choice, thud_law_find(name));
    int power = thud_law_param(choice->law, "exponent");
    double n = power >= 0 ? (chance(0.4) ? choice->value[power] : between(1, 4)) : strcmp(name, "hertz") == 0 ? 1.5 : 1;
    set_value(choice, "exponent", n);
    set_value(choice, "stiffness", k * pow(0.02 * size_m, 1 - n));
    set_value(choice, "restitution", ONE_OF(1, 0.6, 0.5, 0.8, between(0.05, 1), between(0.3, 0.9)));
    set_value(choice, "post-yield", k * between_log(0.1, 100));
    set_value(choice, "max-strain", ONE_OF(0.8, between(0.3, 0.95)));
    set_value(choice, "speed-floor", ONE_OF(1e-3, 1e-3, 1e-5, 0.1));
    for (int i = 0; i < choice->law->nparams; i++) {
        const struct thud_param *p = &choice->law->params[i];
        int words = 0;
        while (p->kind == THUD_PARAM_CHOICE && p->choices[words])
            words++;
        if (words > 0)
            choice->value[i] = below(words);
    }
    if (strcmp(name, "jankowski") == 0 && n != 1.5)
        set_value(choice, "damping", 1);
}

/* From a list of its own: a law that is added leaves the scenes of all seeds as they are. */
static const char *draw_bare_law(void)
{
    static const char *const names[] = {"none",       "linear",    "kelvin-voigt", "kelvin-voigt-no-tension", "hertz",
                                        "hertz-damp", "jankowski", "rubber",       "stereomechanical"};
    for (;;) {
        const struct thud_law *law = thud_law_find(names[below((int)(sizeof names / sizeof *names))]);
        if (strcmp(law->name, "rubber") != 0 && (!(law->flags & THUD_LAW_NO_FORCE) || chance(0.2)))
            return law->name;
    }
}

/* `relative_displacement_m`: the largest without contact. */
static void draw_interface(struct thud_interface *at, double mass, double size_m, double relative_displacement_m,
                           const char *law)
{
    double levels = at->levels;
    memset(at, 0, sizeof *at);
    thud_interface_init(at);
    at->levels = levels;
    double clearance =
        relative_displacement_m * ONE_OF(0, 1e-6, 0.5, 0.9, 0.999, 1, 1.001, 3, between(0, 1), between(0, 1),
                                         between_log(1e-3, 1), between_log(0.1, 1), between_log(0.1, 1));
    if (equal && chance(0.75))
        clearance = 0;
    draw_law(&at->contact, law, mass, size_m);
    at->has_bumper = chance(0.35);
    at->gap_m = fmin(clearance, 4);
    if (!at->has_bumper)
        return;
    thud_interface_add_bumper(at);
    at->bumper_thickness_m = fmin(size_m * between_log(0.02, 1), 1);
    draw_law(&at->bumper, chance(0.75) ? "rubber" : draw_bare_law(), mass, size_m);
    double strain = thud_interface_max_strain(at);
    at->bumper_cavity_m = at->bumper_thickness_m * ONE_OF(0, 0, between(0, 0.9), isfinite(strain) ? 1 - strain : 0.2);
    at->gap_m += at->bumper_thickness_m - at->bumper_cavity_m;
}

/* The motion without contact: its largest displacement, and the largest relative displacement of each interface. */
static bool look_without_contact(struct scenes_one *one, double *closing)
{
    struct thud_model *model;
    struct thud_baseline_motion *baseline = NULL;
    struct thud_run_options options;
    bool ok = thud_scene_assemble(&one->scene, &model, NULL) == THUD_OK;
    if (!ok)
        return false;
    thud_run_options_init(&options);
    options.tail_s = one->scene.analysis.tail_s;
    double ends = options.tail_s + (one->record ? (double)one->record->samples * one->record->dt_s : 0);
    if (one->seed >= SCENES_WIDE && model->fastest_radps * ends > longest_rad) { /* each is run some thirty times */
        thud_model_free(model);
        return false;
    }
    ok = thud_baseline_create(model, 0, one->record, &options, &baseline, NULL) == THUD_OK;
    for (bool done = false; ok && !done;)
        ok = thud_baseline_advance(baseline, 1000, &done, NULL) == THUD_OK;
    for (int c = 0; ok && c < model->ncontacts; c++) {
        if (model->contact[c].interface < 1 || model->contact[c].interface >= one->scene.nstructures) /* a link's */
            continue;
        double *most = &closing[model->contact[c].interface - 1];
        *most = fmax(*most, thud_baseline_relative_displacement(baseline, c));
    }
    one->peak_m = 0;
    ok = ok && !thud_baseline_result(baseline)->collapse.happened;
    for (int s = 0; ok && s < model->nstructures; s++)
        for (int i = 0; i < model->structure[s].n; i++)
            one->peak_m = fmax(one->peak_m, thud_baseline_result(baseline)->structure[s].floor[i].displacement.value);
    thud_baseline_free(baseline);
    thud_model_free(model);
    return ok;
}

/* Bounds of the storeys, from what is passed all the time to what is hardly reached, and the motion with them. False
 * where it is too small for any. */
static bool draw_yields(struct scenes_one *one, double *closing)
{
    static const double least_m = 2e-6;
    bool any = false;
    for (int s = 0; s < one->scene.nstructures; s++) {
        struct thud_structure *p = &one->scene.structure[s];
        bool storeys = p->kind == THUD_SHEAR || p->kind == THUD_ISOLATED, some = chance(0.3);
        double yield = one->peak_m / fmax(p->storeys, 1) * between_log(0.03, 1.5),
               hardening = ONE_OF(0, 0, 0.02, 0.05, 0.3, 0.9, 1, between(0, 1));
        for (int i = 0; i < p->storeys && storeys; i++) {
            p->yield_m[i] = fmin(some && chance(0.5) ? 0 : yield * between_log(0.7, 1.4), 10);
            p->yield_m[i] = p->yield_m[i] > 0 ? fmax(p->yield_m[i], least_m) : 0;
            p->hardening[i] = hardening;
            any = any || p->yield_m[i] > 0;
        }
    }
    for (int i = 0; i + 1 < one->scene.nstructures; i++)
        closing[i] = 0;
    return any && one->peak_m > 10 * least_m && look_without_contact(one, closing) && one->peak_m > 0;
}

/* One end of a link: a floor, or a wall by its name. */
static void draw_end(const struct thud_structure *structure, char *end, size_t size)
{
    int floors = thud_structure_floors(structure);
    if (floors > 0)
        snprintf(end, size, "%.4s.%d", structure->name, 1 + below(floors));
    else
        snprintf(end, size, "%.4s", structure->name);
}

/* Up to two between neighbours, of springs from a hundredth to ten times as stiff as turns their mass at 10 rad/s, and
 * dashpots up to their critical ones and beyond. */
static void draw_links(struct thud_scene *scene, int interface, double mass)
{
    const struct thud_structure *left = &scene->structure[interface], *right = left + 1;
    int n = left->kind == THUD_WALL && right->kind == THUD_WALL ? 0 : below(3);
    for (int i = 0; i < n; i++) {
        struct thud_link *link = &scene->link[scene->nlinks++];
        double stiffness = mass * pow(10 * between_log(0.1, 10), 2);
        thud_link_init(link, (enum thud_link_law)below(THUD_LINK_LAWS));
        draw_end(left, link->from, sizeof link->from);
        draw_end(right, link->to, sizeof link->to);
        link->stiffness_npm = link->law == THUD_LINK_DASHPOT ? 0 : stiffness;
        link->damping_nspm = link->law > THUD_LINK_DASHPOT ? 0 : between_log(0.01, 3) * sqrt(stiffness * mass);
        link->slip_n = link->law == THUD_LINK_FRICTION ? stiffness * between_log(3e-4, 0.02) : 0;
        link->slack_m = link->law > THUD_LINK_FRICTION && chance(0.8) ? between_log(1e-4, 0.05) : 0;
    }
}

/* A shear building by its matrix, with springs between floors that are no neighbours and to the ground; or by the modes of
 * that one. */
static void give_matrix(struct thud_scene *scene, int index)
{
    struct thud_structure *s = &scene->structure[index];
    const int n = s->storeys;
    double k[12 * 12] = {0}, rows[12 * 13];
    if (s->kind != THUD_SHEAR || n > 12 || chance(0.25))
        return;
    const double bending = chance(0.3) ? 0 : between_log(1e-3, 0.3);
    for (int i = 0; i < n; i++)
        for (int j = -1; j < i; j++) {
            double spring = j + 1 == i ? s->stiffness_npm[i] : bending * s->stiffness_npm[i] * between(0, 1);
            k[i * n + i] += spring;
            if (j < 0)
                continue;
            k[j * n + j] += spring;
            k[i * n + j] -= spring;
            k[j * n + i] -= spring;
        }
    s->kind = chance(0.5) ? THUD_MODES : THUD_MATRIX;
    s->period_factor = 1;
    int modes = s->kind == THUD_MODES ? chance(0.7) ? n : 1 + below(n) : n;
    if (s->kind == THUD_MODES) {
        double omega[12], phi[12 * 12], work[12 * 12 + 36];
        enum thud_status status = thud_modes_matrix(n, s->mass_kg, k, omega, phi, work, NULL);
        assert(status == THUD_OK);
        (void)status;
        for (int j = 0; j < modes; j++)
            for (int i = 0; i <= n; i++)
                rows[j * (1 + n) + i] = i == 0 ? 2 * THUD_PI / omega[j] : phi[(i - 1) * n + j];
    }
    for (int i = 0; i < n; i++) {
        s->stiffness_npm[i] = s->yield_m[i] = s->yield_shear_n[i] = s->hardening[i] = 0;
        s->column_ei_nm2[i] = fmin(s->column_ei_nm2[i], 1e15);
    }
    enum thud_status status = thud_structure_keep_shape(scene, index, modes, s->kind == THUD_MODES ? rows : k, NULL);
    assert(status == THUD_OK);
    (void)status;
}

static bool draw(struct scenes_one *one)
{
    struct thud_scene *scene = &one->scene;
    const unsigned long long seed = one->seed % SCENES_EQUAL;
    const bool mixed = seed >= SCENES_MIXED, soil = mixed ? seed % 3 == 0 : seed >= SCENES_SOIL,
               isolators = mixed || (seed >= SCENES_ISOLATORS && !soil),
               matrices = mixed  ? seed % 7 == 0
                          : soil ? seed % 3 == 1
                                 : seed >= SCENES_MATRICES && !isolators,
               links =
                   mixed ? seed % 4 < 3 : seed >= SCENES_LINKS && !isolators && !soil && (!matrices || seed % 3 == 1);
    bool weights = mixed  ? seed % 5 < 2
                   : soil ? seed % 2 == 0
                          : seed >= SCENES_P_DELTA && !links && !isolators,
         columns = mixed   ? seed / 2 % 2 == 0
                   : soil  ? seed % 4 < 3
                   : links ? seed % 4 == 0
                           : seed >= SCENES_COLUMNS && !weights && !isolators,
         wide = seed >= SCENES_WIDE && seed < SCENES_YIELDING;
    bool yields = seed >= SCENES_YIELDING && (mixed       ? seed / 3 % 2 == 0
                                              : soil      ? seed % 3 == 0
                                              : weights   ? seed % 2 == 0
                                              : isolators ? seed % 4 == 0
                                              : links     ? seed % 3 == 0
                                                          : !columns || seed % 3 == 0);
    double closing[THUD_STRUCTURES_MAX] = {0},
           mass = wide ? between_log(lightest_kg, heaviest_kg) : between_log(1e4, 1e6);
    bool extreme = chance(0.15);
    thud_scene_init(scene);
    strcpy(scene->name, "drawn");
    scene->nstructures = chance(0.05) ? 1 : chance(0.6) ? 2 : 3 + below(4);
    for (int s = 0; s < scene->nstructures; s++) {
        bool same = s > 0 && chance(equal ? 0.7 : 0.12);
        if (same)
            scene->structure[s] = scene->structure[s - 1];
        else
            draw_structure(&scene->structure[s], s, mass, extreme, wide);
        if (columns && (scene->structure[s].kind == THUD_SHEAR || scene->structure[s].kind == THUD_ISOLATED))
            draw_columns(&scene->structure[s]);
        scene->structure[s].name[0] = (char)('A' + s);
    }
    if (weights)
        draw_weights(scene);
    for (int i = 0; links && i + 1 < scene->nstructures; i++)
        draw_links(scene, i, mass);
    for (int s = 0; s < scene->nstructures && matrices; s++)
        give_matrix(scene, s);
    for (int s = 0; s < scene->nstructures && soil; s++)
        draw_soil(&scene->structure[s]);
    bool isolated = isolators && draw_isolators(scene), gives = mixed && draw_walls(scene, mass);
    if (isolators && !isolated && !gives && !(mixed && scene->nlinks > 0 && seed % 8 == 0))
        return false;
    if (chance(0.9))
        draw_record(one);
    else
        scene->analysis.tail_s = between_log(0.1, 5);
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        thud_interface_init(&scene->interface[i]);
        scene->interface[i].has_bumper = false;
        scene->interface[i].levels = columns ? THUD_LEVELS_ALL : THUD_LEVELS_ALIGNED;
    }
    if (!look_without_contact(one, closing) || !(one->peak_m > 0))
        return false;
    if (yields && !draw_yields(one, closing))
        return false;
    const char *law = draw_bare_law();
    for (int i = 0; i + 1 < scene->nstructures; i++)
        draw_interface(&scene->interface[i], mass, fmax(one->peak_m, 1e-9), closing[i],
                       chance(0.5) ? law : draw_bare_law());
    return thud_scene_check(scene, NULL) == THUD_OK;
}

void scenes_draw(struct scenes_one *one, unsigned long long seed)
{
    state = seed * 0xd1342543de82ef95ull + 1;
    next();
    coarse = seed >= SCENES_COARSE;
    equal = seed % SCENES_COARSE >= SCENES_EQUAL;
    for (bool drawn = false; !drawn;) {
        *one = (struct scenes_one){.seed = seed};
        drawn = draw(one);
        if (!drawn)
            thud_record_free(one->record);
    }
}

void scenes_clear(struct scenes_one *one)
{
    thud_record_free(one->record);
    one->record = NULL;
}

static void replace_record(struct scenes_one *one, const double *a, size_t samples, double dt)
{
    struct thud_record *made;
    enum thud_status status = thud_record_create(a, samples, dt, &made, NULL);
    assert(status == THUD_OK);
    (void)status;
    one->record = made;
}

void scenes_copy(struct scenes_one *to, const struct scenes_one *from)
{
    *to = *from;
    if (from->record)
        replace_record(to, from->record->a_mps2, from->record->samples, from->record->dt_s);
}

void scenes_describe(const struct scenes_one *one, char *text, size_t size)
{
    static const char *const kinds[] = {"shear", "rigid", "isolated", "wall", "matrix", "modes"};
    size_t at = (size_t)snprintf(text, size, "%llu:", one->seed);
    for (int s = 0; s < one->scene.nstructures && at < size; s++) {
        const struct thud_structure *p = &one->scene.structure[s];
        at += (size_t)snprintf(text + at, size - at, " %s%s %d (%.2g)",
                               thud_isolator_slides(p)     ? "sliding "
                               : thud_wall_has_backfill(p) ? "backfilled "
                               : thud_wall_gives(p)        ? "giving "
                               : thud_structure_on_soil(p) ? "founded "
                                                           : "",
                               kinds[p->kind], p->storeys, p->damping);
        if (s + 1 < one->scene.nstructures && at < size) {
            const struct thud_interface *i = &one->scene.interface[s];
            at += (size_t)snprintf(text + at, size - at, " |%s %.3g|",
                                   i->has_bumper ? i->bumper.law->name : i->contact.law->name,
                                   thud_interface_clearance(i));
        }
    }
    if (at < size)
        at += (size_t)snprintf(text + at, size - at, "; %d links%s", one->scene.nlinks,
                               one->scene.p_delta ? ", P-Delta" : "");
    if (at < size && one->record)
        snprintf(text + at, size - at, "; %zu x %g s of %.3g, tail %g, peak %.3g m", one->record->samples,
                 one->record->dt_s, thud_record_peak(one->record), one->scene.analysis.tail_s, one->peak_m);
}

/* ---- what must change nothing ---- */

void scenes_mirror(struct scenes_one *one)
{
    struct thud_scene *was = malloc(sizeof *was), *s = &one->scene;
    assert(was);
    *was = *s;
    for (int i = 0; i < s->nstructures; i++) {
        s->structure[i] = was->structure[s->nstructures - 1 - i];
        if (s->structure[i].kind == THUD_RIGID)
            s->structure[i].velocity_mps = -s->structure[i].velocity_mps;
    }
    for (int i = 0; i + 1 < s->nstructures; i++)
        s->interface[i] = was->interface[s->nstructures - 2 - i];
    if (one->record)
        thud_record_scale(one->record, -1);
    free(was);
}

void scenes_resample(struct scenes_one *one, int parts)
{
    if (!one->record)
        return;
    struct thud_record *old = one->record;
    const size_t each = (size_t)parts, n = each * (old->samples - 1) + 1;
    double *a = malloc(n * sizeof *a);
    assert(a);
    for (size_t i = 0; i < n; i++) {
        const double *from = &old->a_mps2[i / each], part = (double)(i % each) / parts;
        a[i] = part > 0 ? (1 - part) * from[0] + part * from[1] : from[0];
    }
    replace_record(one, a, n, old->dt_s / parts);
    thud_record_free(old);
    free(a);
}

void scenes_pad(struct scenes_one *one, int zeros)
{
    if (!one->record)
        return;
    struct thud_record *old = one->record;
    int room = (int)floor(one->scene.analysis.tail_s / old->dt_s * (1 - 1e-12)) - 1; /* the first zero ends a ramp */
    zeros = zeros < room ? zeros : room;
    bool ends_at_zero = old->a_mps2[old->samples - 1] == 0;
    if (zeros <= 0 || !ends_at_zero)
        return;
    size_t n = old->samples + (size_t)zeros;
    double *a = calloc(n, sizeof *a);
    assert(a);
    memcpy(a, old->a_mps2, old->samples * sizeof *a);
    replace_record(one, a, n, old->dt_s);
    one->scene.analysis.tail_s -= zeros * old->dt_s;
    thud_record_free(old);
    free(a);
}

static struct thud_law_choice *law_in_use(struct thud_interface *at)
{
    return at->has_bumper ? &at->bumper : &at->contact;
}

static double value_of(const struct thud_law_choice *choice, const char *name, double absent)
{
    int i = thud_law_param(choice->law, name);
    return i >= 0 ? choice->value[i] : absent;
}

static bool is_rubber(const struct thud_law_choice *choice)
{
    return strcmp(choice->law->name, "rubber") == 0;
}

bool scenes_heavier(struct scenes_one *one, double factor)
{
    struct thud_scene *s = &one->scene;
    for (int i = 0; i < s->nstructures; i++) {
        struct thud_structure *p = &s->structure[i];
        for (int f = 0; f < p->storeys; f++) {
            p->mass_kg[f] *= factor;
            p->stiffness_npm[f] *= factor;
            p->yield_shear_n[f] *= factor;
            p->gravity_n[f] *= factor;
            p->column_ei_nm2[f] *= factor;
            p->column_stiffness_npm[f] *= factor;
        }
        double *const scaled[] = {&p->base_mass_kg,       &p->isolation_stiffness_npm,
                                  &p->foundation_mass_kg, &p->foundation_inertia_kgm2,
                                  &p->sway_npm,           &p->sway_nspm,
                                  &p->rocking_nmprad,     &p->rocking_nmsprad,
                                  &p->soil_density_kgpm3};
        for (size_t k = 0; k < sizeof scaled / sizeof *scaled; k++)
            *scaled[k] *= factor;
        for (int k = 0; p->kind == THUD_MATRIX && k < p->storeys * p->storeys; k++)
            s->shape[p->shape_at + k] *= factor;
        p->isolator_strength_n *= factor;
        p->isolator_post_yield_npm *= factor;
        p->wall_mass_kg *= factor;
        p->wall_stiffness_npm *= factor;
        p->backfill_stiffness_npm *= factor;
        p->backfill_strength_n *= factor;
    }
    for (int i = 0; i < s->nlinks; i++) {
        s->link[i].stiffness_npm *= factor;
        s->link[i].damping_nspm *= factor;
        s->link[i].slip_n *= factor;
    }
    for (int i = 0; i + 1 < s->nstructures; i++) {
        struct thud_law_choice *law = law_in_use(&s->interface[i]);
        if (is_rubber(law) && value_of(law, "damping", 0) == 0)
            return false;
        set_value(law, "stiffness", factor * value_of(law, "stiffness", 0));
        set_value(law, "post-yield", factor * value_of(law, "post-yield", 0));
    }
    return true;
}

bool scenes_longer(struct scenes_one *one, double factor)
{
    struct thud_scene *s = &one->scene;
    if (s->p_delta) /* heights are lengths too */
        return false;
    for (int i = 0; i < s->nlinks; i++) {
        s->link[i].slack_m *= factor;
        s->link[i].slip_n *= factor;
    }
    for (int i = 0; i < s->nstructures; i++)
        if (thud_isolator_slides(&s->structure[i])) /* so are radii */
            return false;
    for (int i = 0; i < s->nstructures; i++) {
        s->structure[i].backfill_strength_n *= factor;
        s->structure[i].backfill_gap_m *= factor;
        if (s->structure[i].kind == THUD_RIGID)
            s->structure[i].velocity_mps *= factor;
    }
    for (int i = 0; i < s->nstructures; i++)
        for (int f = 0; f < s->structure[i].storeys; f++)
            s->structure[i].yield_m[f] *= factor;
    for (int i = 0; i + 1 < s->nstructures; i++) {
        struct thud_interface *at = &s->interface[i];
        struct thud_law_choice *law = law_in_use(at);
        double n = strcmp(law->law->name, "hertz") == 0 ? 1.5 : value_of(law, "exponent", 1);
        if (is_rubber(law) && value_of(law, "damping", 0) == 0)
            return false;
        set_value(law, "stiffness", pow(factor, 1 - n) * value_of(law, "stiffness", 0));
        set_value(law, "speed-floor", factor * value_of(law, "speed-floor", 0));
        at->gap_m *= factor;
        at->bumper_thickness_m *= factor;
        at->bumper_cavity_m *= factor;
    }
    if (one->record)
        thud_record_scale(one->record, factor);
    one->peak_m *= factor;
    return true;
}

void scenes_nudge(struct scenes_one *one, int way, double eps)
{
    struct thud_scene *s = &one->scene;
    double sign = way % 2 ? -1 : 1;
    for (int i = 0; i + 1 < s->nstructures && way < 2; i++) {
        struct thud_interface *at = &s->interface[i];
        double out = at->has_bumper ? at->bumper_thickness_m - at->bumper_cavity_m : 0;
        at->gap_m = fmax(at->gap_m + sign * eps * one->peak_m, out);
    }
    for (int i = 0; i < s->nstructures && way >= 2; i++) {
        struct thud_structure *p = &s->structure[i];
        double factor = 1 + sign * eps * (i % 2 ? -0.7 : 1);
        for (int f = 0; f < p->storeys; f++)
            p->stiffness_npm[f] *= factor;
        p->isolation_stiffness_npm *= factor;
        p->period_factor /= sqrt(factor);
        p->isolator_post_yield_npm *= factor;
        p->isolator_friction *= factor;
        p->wall_stiffness_npm *= factor;
        p->backfill_strength_n *= factor;
        if (p->kind == THUD_RIGID) {
            p->mass_kg[0] *= factor;
            p->velocity_mps *= factor;
        }
    }
}
