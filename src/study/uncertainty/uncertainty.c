#include "study/uncertainty/uncertainty.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "study/scene/building.h"
#include "study/scene/level.h"
#include "study/scene/needed_gap.h"
#include "study/scene/scene_elements.h"
#include "study/scene/solution.h"
#include "study/scene/stiffness.h"
#include "study/sweep/remark.h"
#include "study/sweep/sweep_private.h"

static const struct thud_input_info infos[THUD_INPUTS] = {
    [THUD_INPUT_GAP] = {"gap", THUD_INPUT_RELATIVE, THUD_INPUT_EACH_INTERFACE, 0.05},
    [THUD_INPUT_MOTION] = {"motion", THUD_INPUT_RELATIVE, THUD_INPUT_ALL, 0},
    [THUD_INPUT_STIFFNESS] = {"stiffness", THUD_INPUT_RELATIVE, THUD_INPUT_EACH_STRUCTURE, 0.1},
    [THUD_INPUT_DAMPING] = {"damping", THUD_INPUT_RELATIVE, THUD_INPUT_EACH_STRUCTURE, 0.2},
    [THUD_INPUT_MASS] = {"mass", THUD_INPUT_RELATIVE, THUD_INPUT_EACH_STRUCTURE, 0},
    [THUD_INPUT_CONTACT_STIFFNESS] = {"contact-stiffness", THUD_INPUT_FACTOR, THUD_INPUT_ALL, 2},
    [THUD_INPUT_RESTITUTION] = {"restitution", THUD_INPUT_ABSOLUTE, THUD_INPUT_ALL, 0.1},
    [THUD_INPUT_BUMPER_STIFFNESS] = {"bumper-stiffness", THUD_INPUT_RELATIVE, THUD_INPUT_ALL, 0.2},
    [THUD_INPUT_BUMPER_EXPONENT] = {"bumper-exponent", THUD_INPUT_ABSOLUTE, THUD_INPUT_ALL, 0},
    [THUD_INPUT_YIELD] = {"yield", THUD_INPUT_RELATIVE, THUD_INPUT_EACH_STRUCTURE, 0.1},
    [THUD_INPUT_HARDENING] = {"hardening", THUD_INPUT_ABSOLUTE, THUD_INPUT_EACH_STRUCTURE, 0.02},
    [THUD_INPUT_COLUMNS] = {"column-stiffness", THUD_INPUT_RELATIVE, THUD_INPUT_EACH_STRUCTURE, 0.2},
    [THUD_INPUT_ELEVATION] = {"elevation", THUD_INPUT_LENGTH, THUD_INPUT_EACH_STRUCTURE, 0},
    [THUD_INPUT_PERIOD] = {"period", THUD_INPUT_FACTOR, THUD_INPUT_EACH_STRUCTURE, THUD_ESTIMATE_MOST},
    [THUD_INPUT_SOIL] = {"soil-stiffness", THUD_INPUT_FACTOR, THUD_INPUT_EACH_STRUCTURE, 1.5},
    [THUD_INPUT_LINK] = {"link", THUD_INPUT_RELATIVE, THUD_INPUT_ALL, 0.2},
    [THUD_INPUT_RECORD] = {"ground-motion", THUD_INPUT_CHOICE, THUD_INPUT_ALL, 0},
};

const struct thud_input_info *thud_input_info(enum thud_input input)
{
    return &infos[input];
}

void thud_inputs_init(struct thud_inputs *inputs)
{
    *inputs = (struct thud_inputs){0};
    for (int i = 0; i < THUD_INPUTS; i++) {
        inputs->size[i] = infos[i].size;
        inputs->common[i] = infos[i].way == THUD_INPUT_FACTOR ? 1 : 0;
    }
}

/* The size of an input into the place of what its name goes on with: nothing, `.common` or `.NAME`. */
static enum thud_status put_size(struct thud_inputs *inputs, enum thud_input input, const char *of, size_t n,
                                 double size, struct thud_error *err)
{
    inputs->asked[input] = size != (infos[input].way == THUD_INPUT_FACTOR ? 1 : 0);
    if (n == 0) {
        inputs->size[input] = size;
        for (int i = 0; i < inputs->nown; i++) /* later ones hold */
            if (inputs->own[i].input == input)
                inputs->own[i].size = size;
    } else if (n == strlen("common") && strncmp(of, "common", n) == 0) {
        inputs->common[input] = size;
    } else {
        if (inputs->nown == THUD_INPUTS_OWN_MAX)
            return thud_error_set(err, THUD_USAGE, "more than %d inputs with a size of their own", THUD_INPUTS_OWN_MAX);
        struct thud_input_own *own = &inputs->own[inputs->nown++];
        *own = (struct thud_input_own){.input = input, .size = size};
        snprintf(own->of, sizeof own->of, "%.*s", (int)n, of);
    }
    return THUD_OK;
}

enum thud_status thud_inputs_set(struct thud_inputs *inputs, const char *text, struct thud_error *err)
{
    static const double most[] = {
        [THUD_INPUT_RELATIVE] = 0.9, [THUD_INPUT_FACTOR] = 100, [THUD_INPUT_ABSOLUTE] = 1, [THUD_INPUT_LENGTH] = 10};
    size_t word = strcspn(text, ".=");
    const char *sign = strrchr(text, '='), *of = text + word + 1;
    struct thud_quantity q;
    for (int i = 0; i < THUD_INPUT_RECORD && sign; i++) {
        if (strlen(infos[i].name) != word || strncmp(text, infos[i].name, word) != 0)
            continue;
        size_t n = text[word] == '.' ? (size_t)(sign - of) : 0;
        enum thud_input_way way = infos[i].way;
        enum thud_dimension dimension = way == THUD_INPUT_LENGTH ? THUD_LENGTH : THUD_RATIO;
        bool common = n == strlen("common") && strncmp(of, "common", n) == 0;
        if (text[word] == '.' && (n == 0 || n >= THUD_NAME_MAX || infos[i].each == THUD_INPUT_ALL))
            break;
        if (common && i == THUD_INPUT_ELEVATION) /* which would change nothing */
            break;
        if (thud_quantity_parse(sign + 1, dimension, NULL, &q, NULL) != THUD_OK ||
            !(q.value >= (way == THUD_INPUT_FACTOR ? 1 : 0) && q.value <= most[way]))
            break;
        return put_size(inputs, (enum thud_input)i, of, n, q.value, err);
    }
    return thud_error_refuse(
        err, THUD_USAGE, "--uncertain",
        "INPUT=SIZE: gap=5 %, contact-stiffness=2, restitution=0.1, elevation=5 cm (at most 10 m); "
        "for one building stiffness.A=5 %, for all stiffness.common=10 %; see thud(1)",
        "\"%.60s\" is not an input with its size", text);
}

/* The value of the laws of contacts and bumpers that an input is. */
static const struct {
    const char *name;
    bool contacts, bumpers;
} of_laws[THUD_INPUTS] = {[THUD_INPUT_CONTACT_STIFFNESS] = {"stiffness", .contacts = true},
                          [THUD_INPUT_RESTITUTION] = {"restitution", .contacts = true, .bumpers = true},
                          [THUD_INPUT_BUMPER_STIFFNESS] = {"stiffness", .bumpers = true},
                          [THUD_INPUT_BUMPER_EXPONENT] = {"exponent", .bumpers = true}};

static double changed(enum thud_input input, double x, double size, double u)
{
    static const double longest = THUD_ESTIMATE_MOST, shortest = THUD_ESTIMATE_LEAST;
    double t = 2 * u - 1;
    if (input == THUD_INPUT_PERIOD && t < 0) /* size 1.4: 0.7 to 1.4 times */
        t *= -log(shortest) / log(longest);
    return infos[input].way == THUD_INPUT_RELATIVE ? x * (1 + size * t)
           : infos[input].way == THUD_INPUT_FACTOR ? x * pow(size, t)
                                                   : x + size * t;
}

double thud_input_times(const struct thud_drawn_input *input, double u)
{
    return changed(input->input, 1, input->size, u);
}

static void change_law(struct thud_law_choice *choice, enum thud_input input, double size, double u)
{
    double *value = thud_law_given(choice, of_laws[input].name);
    if (!value)
        return;
    double x = changed(input, *value, size, u);
    if (input == THUD_INPUT_RESTITUTION)
        x = fmin(1, fmax(0.01, x));
    if (input == THUD_INPUT_BUMPER_EXPONENT) {
        double *stiffness = thud_law_given(choice, "stiffness");
        x = fmax(1, x);
        if (stiffness)
            *stiffness *= pow(1000, x - *value);
    }
    *value = x;
}

/* The stiffness of a building by its matrix or modes is in the factor of its periods. With another mass, shapes of the
 * same periods would be those of another stiffness, which is not what is not known. */
static void change_periods(struct thud_structure *p, enum thud_input input, double size, double u)
{
    const double factor = changed(input, 1, size, u);
    if (input == THUD_INPUT_STIFFNESS)
        p->period_factor /= sqrt(factor);
    else if (input == THUD_INPUT_MASS && p->kind == THUD_MODES)
        p->period_factor *= sqrt(factor);
}

/* What is known of an estimated building is its area and a period. */
static void change_estimate(struct thud_structure *p, enum thud_input input, double size, double u)
{
    const double factor = changed(input, 1, size, u);
    if (input == THUD_INPUT_MASS)
        p->area_m2 *= factor;
    else
        p->period_factor *= input == THUD_INPUT_STIFFNESS ? 1 / sqrt(factor) : factor;
    thud_structure_fill_estimate(p);
}

/* Springs that are given, and G = rho V_s^2, of which the others follow; dashpots go with V_s. */
static void change_soil(struct thud_structure *p, double size, double u)
{
    const double factor = changed(THUD_INPUT_SOIL, 1, size, u);
    p->sway_npm *= factor;
    p->rocking_nmprad *= factor;
    p->soil_vs_mps *= sqrt(factor);
}

static void change_structure(struct thud_structure *p, enum thud_input input, double size, double u)
{
    int n = p->kind == THUD_RIGID ? 1 : p->kind == THUD_WALL ? 0 : p->storeys;
    if (input == THUD_INPUT_DAMPING) {
        p->damping = changed(input, p->damping, size, u);
        if (p->kind == THUD_ISOLATED)
            p->isolation_damping = changed(input, thud_structure_isolator(p).damping, size, u);
    } else if (input == THUD_INPUT_STIFFNESS) {
        p->isolation_stiffness_npm = changed(input, p->isolation_stiffness_npm, size, u);
        p->isolator_post_yield_npm = changed(input, p->isolator_post_yield_npm, size, u);
    } else {
        p->base_mass_kg = changed(input, p->base_mass_kg, size, u);
    }
    if (thud_kind_is_read(p->kind))
        change_periods(p, input, size, u);
    if (p->kind == THUD_ESTIMATED && input != THUD_INPUT_DAMPING) {
        change_estimate(p, input, size, u);
        return;
    }
    for (int i = 0; i < n; i++) {
        double *x = input == THUD_INPUT_STIFFNESS ? &p->stiffness_npm[i] : &p->mass_kg[i];
        *x = input == THUD_INPUT_DAMPING ? *x : changed(input, *x, size, u);
    }
}

/* Of the storeys that yield, and of isolators that do: their strength or friction. */
static void change_storeys(struct thud_structure *p, enum thud_input input, double size, double u)
{
    if (input == THUD_INPUT_YIELD && thud_isolator_slides(p)) { /* NaN: of the other law */
        p->isolator_strength_n = changed(input, p->isolator_strength_n, size, u);
        if (isfinite(p->isolator_friction))
            p->isolator_friction = fmin(1, changed(input, p->isolator_friction, size, u));
    }
    for (int i = 0; i < p->storeys; i++) {
        if (!isfinite(thud_structure_yield(p, i)))
            continue;
        if (input == THUD_INPUT_YIELD) {
            p->yield_m[i] = changed(input, p->yield_m[i], size, u);
            p->yield_shear_n[i] = changed(input, p->yield_shear_n[i], size, u);
            p->yield_coefficient[i] = changed(input, p->yield_coefficient[i], size, u);
        } else {
            p->hardening[i] = fmin(1, fmax(0, changed(input, p->hardening[i], size, u)));
        }
    }
}

static void change_building(struct thud_structure *p, enum thud_input input, double size, double u)
{
    if (!thud_kind_is_building(p->kind))
        return;
    if (input == THUD_INPUT_PERIOD && p->kind == THUD_ESTIMATED)
        change_estimate(p, input, size, u);
    else if (input == THUD_INPUT_SOIL)
        change_soil(p, size, u);
    else if (input == THUD_INPUT_ELEVATION)
        p->base_m = changed(input, p->base_m, size, u);
    else if (input == THUD_INPUT_COLUMNS)
        for (int i = 0; i < p->storeys; i++) {
            p->column_ei_nm2[i] = changed(input, p->column_ei_nm2[i], size, u);
            p->column_stiffness_npm[i] = changed(input, p->column_stiffness_npm[i], size, u);
        }
    else if (input != THUD_INPUT_PERIOD)
        change_storeys(p, input, size, u);
}

static void change_interfaces(struct thud_scene *scene, enum thud_input input, int of, double size, double u)
{
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        struct thud_interface *f = &scene->interface[i];
        if (of >= 0 && of != i)
            continue;
        if (input == THUD_INPUT_GAP)
            thud_interface_scale_gap(f, changed(input, 1, size, u));
        if (of_laws[input].contacts)
            change_law(&f->contact, input, size, u);
        if (of_laws[input].bumpers && f->has_bumper)
            change_law(&f->bumper, input, size, u);
    }
}

void thud_input_change(struct thud_scene *scene, const struct thud_drawn_input *drawn, double u, double *motion)
{
    enum thud_input input = drawn->input;
    if (input == THUD_INPUT_RECORD)
        return;
    if (input == THUD_INPUT_MOTION)
        *motion = changed(input, *motion, drawn->size, u);
    else if (input == THUD_INPUT_LINK)
        thud_stiffness_scale(scene, THUD_STIFFNESS_LINK, thud_input_times(drawn, u));
    else if (infos[input].each != THUD_INPUT_EACH_STRUCTURE)
        change_interfaces(scene, input, drawn->of, drawn->size, u);
    for (int s = 0; infos[input].each == THUD_INPUT_EACH_STRUCTURE && s < scene->nstructures; s++) {
        if (drawn->of >= 0 && drawn->of != s)
            continue;
        if (input >= THUD_INPUT_YIELD && input <= THUD_INPUT_SOIL)
            change_building(&scene->structure[s], input, drawn->size, u);
        else
            change_structure(&scene->structure[s], input, drawn->size, u);
    }
}

/* Whether a slab strikes columns of a structure (-1: of any), and with `given` columns whose stiffness is. */
static bool has_struck(const struct thud_scene *scene, int structure, bool given)
{
    struct thud_contact_pair *meeting = malloc(THUD_CONTACT_PAIRS_MAX * sizeof *meeting);
    bool found = false;
    for (int i = 0; meeting && i + 1 < scene->nstructures && !found; i++)
        for (int k = thud_interface_contact_pairs(scene, i, meeting) - 1; k >= 0 && !found; k--) {
            int own = meeting[k].struck > 0 ? i + 1 : i;
            const struct thud_structure *s = &scene->structure[own];
            int floor = meeting[k].struck > 0 ? meeting[k].right_floor : meeting[k].left_floor;
            found = meeting[k].struck != 0 && (structure < 0 || structure == own) &&
                    (!given || !isnan(thud_column_ei(s, floor - 1 - (s->kind == THUD_ISOLATED))));
        }
    free(meeting);
    return found;
}

static bool is_building(const struct thud_scene *scene, int s)
{
    return s >= 0 && s < scene->nstructures && thud_kind_is_building(scene->structure[s].kind);
}

/* Whether the law of a contact or a bumper of the scene has such a value. */
static bool has_law_value(const struct thud_scene *scene, enum thud_input input)
{
    const char *name = of_laws[input].name;
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        struct thud_interface own = scene->interface[i], *at = &own;
        if ((of_laws[input].contacts && thud_law_given(&at->contact, name)) ||
            (of_laws[input].bumpers && at->has_bumper && thud_law_given(&at->bumper, name)))
            return true;
    }
    return false;
}

/* Whether a structure or interface, or the scene, has such an input. */
static bool is_there(const struct thud_scene *scene, enum thud_input input, int of)
{
    const struct thud_structure *own = of >= 0 ? &scene->structure[of] : NULL;
    switch (input) {
    case THUD_INPUT_MOTION:
        return scene->record.file[0];
    case THUD_INPUT_STIFFNESS:
        return is_building(scene, of) && !thud_period_is_estimated(own);
    case THUD_INPUT_PERIOD:
        return own && thud_period_is_estimated(own);
    case THUD_INPUT_SOIL:
        return own && thud_structure_on_soil(own);
    case THUD_INPUT_DAMPING:
        return is_building(scene, of);
    case THUD_INPUT_MASS:
        return own && own->kind != THUD_WALL;
    case THUD_INPUT_YIELD:
        return own && thud_structure_elements(own).traits & THUD_SLIPS;
    case THUD_INPUT_HARDENING: /* isolators have none */
        return own && thud_structure_features(own) & THUD_HAS_YIELDING;
    case THUD_INPUT_COLUMNS:
        return has_struck(scene, of, true);
    case THUD_INPUT_ELEVATION: /* against a neighbour */
        return is_building(scene, of) && (is_building(scene, of - 1) || is_building(scene, of + 1));
    case THUD_INPUT_LINK:
        return scene->nlinks > 0;
    default:
        return of_laws[input].name ? has_law_value(scene, input) : scene->nstructures > 1;
    }
}

/* The size that was asked for one of several, else that of each. `used`: (inputs->nown) */
static double size_of(const struct thud_inputs *inputs, const struct thud_scene *scene, enum thud_input input, int of,
                      bool *used)
{
    double size = inputs->size[input];
    char number[16];
    snprintf(number, sizeof number, "%d", of + 1);
    for (int i = 0; i < inputs->nown; i++) {
        const struct thud_input_own *own = &inputs->own[i];
        bool named = infos[input].each == THUD_INPUT_EACH_STRUCTURE && strcmp(own->of, scene->structure[of].name) == 0;
        if (own->input != input || !(named || strcmp(own->of, number) == 0))
            continue;
        size = own->size;
        used[i] = true;
    }
    return size;
}

static void add_input(struct thud_uncertainty *u, enum thud_input input, int of, double size, const char *suffix)
{
    struct thud_drawn_input *drawn = &u->input[u->ninputs];
    if (size == (infos[input].way == THUD_INPUT_FACTOR ? 1 : 0))
        return;
    *drawn = (struct thud_drawn_input){.input = input, .of = of, .size = size};
    snprintf(drawn->name, sizeof drawn->name, "%s%s%s", infos[input].name, *suffix ? "." : "", suffix);
    u->ninputs++;
}

/* Whether there is any such input, in the scene or by its suite. */
static bool has_input(const struct thud_uncertainty *u, enum thud_input input)
{
    bool any = input == THUD_INPUT_MOTION && u->nsuite > 0;
    for (int of = infos[input].each == THUD_INPUT_ALL ? -1 : 0; of < u->scene.nstructures && !any; of++)
        any = is_there(&u->scene, input, of);
    return any;
}

static void add_each(struct thud_uncertainty *u, const struct thud_inputs *inputs, enum thud_input input, bool *used)
{
    bool structures = infos[input].each == THUD_INPUT_EACH_STRUCTURE;
    int n = structures ? u->scene.nstructures : u->scene.nstructures - 1;
    for (int of = 0; of < n; of++) {
        char number[16] = "";
        if (n > 1)
            snprintf(number, sizeof number, "%d", of + 1);
        if (is_there(&u->scene, input, of))
            add_input(u, input, of, size_of(inputs, &u->scene, input, of, used),
                      structures ? u->scene.structure[of].name : number);
    }
    if (has_input(u, input))
        add_input(u, input, -1, inputs->common[input], "common");
}

static void allow_inputs(const struct thud_uncertainty *u, struct thud_error *err)
{
    struct thud_text names = {0};
    for (int i = 0; i < THUD_INPUT_RECORD; i++)
        if (has_input(u, (enum thud_input)i))
            thud_text_append(&names, "%s%s", names.size ? ", " : "", infos[i].name);
    thud_error_allow(err, "%s", names.data ? names.data : "none");
    thud_text_clear(&names);
}

static enum thud_status find_inputs(struct thud_uncertainty *u, const struct thud_inputs *inputs,
                                    struct thud_error *err)
{
    bool used[THUD_INPUTS_OWN_MAX] = {0};
    for (int i = 0; i < THUD_INPUT_RECORD; i++) {
        if (infos[i].each != THUD_INPUT_ALL)
            add_each(u, inputs, (enum thud_input)i, used);
        else if (has_input(u, (enum thud_input)i))
            add_input(u, (enum thud_input)i, -1, inputs->size[i], "");
    }
    if (u->nsuite > 1)
        add_input(u, THUD_INPUT_RECORD, -1, u->nsuite, "");
    for (int i = 0; i < inputs->nown; i++)
        if (!used[i])
            return thud_error_refuse(err, THUD_INPUT, "--uncertain",
                                     "the name or number of a building with this input, or the number of an interface",
                                     "\"%s.%s\" is not an input of this scene", infos[inputs->own[i].input].name,
                                     inputs->own[i].of);
    for (int i = 0; i < THUD_INPUT_RECORD; i++)
        if (inputs->asked[i] && !has_input(u, (enum thud_input)i)) {
            thud_error_refuse(err, THUD_INPUT, "--uncertain", NULL, "this scene has no %s that could be uncertain",
                              infos[i].name);
            allow_inputs(u, err);
            return THUD_INPUT;
        }
    return u->ninputs > 0 ? THUD_OK : thud_error_set(err, THUD_INPUT, "no input is uncertain");
}

const struct thud_record *thud_uncertainty_record(const struct thud_uncertainty *u, double place)
{
    if (u->nsuite < 2 || isnan(place))
        return u->record;
    int i = (int)(place * u->nsuite);
    return u->suite[i < u->nsuite ? i : u->nsuite - 1];
}

/* ---- quantities ---- */

static bool has_floors(const struct thud_structure *s)
{
    return s->kind != THUD_WALL;
}

/* Reads the measures of a case: of a structure, or of all contacts (-1). */
static void add(struct thud_uncertainty *u, int k, int structure, unsigned features)
{
    const char *of = structure >= 0 ? u->scene.structure[structure].name : "", *which = thud_case_name(u->which[k]);
    enum thud_measure told[THUD_MEASURES];
    const int n = thud_measures_told(THUD_TOLD_BY_UNCERTAINTY, features | (k > 0 ? THUD_HAS_REFERENCE : 0u), told);
    for (int i = 0; i < n; i++) {
        const struct thud_measure_info *info = thud_measure_info(told[i]);
        struct thud_quantity_of_run *q = &u->quantity[u->nquantities];
        if (!info->read || info->of_structure != (structure >= 0))
            continue;
        *q = (struct thud_quantity_of_run){.measure = told[i], .which = u->which[k], .structure = structure};
        snprintf(q->name, sizeof q->name, "%s: %s%s%s", which, info->words, *of ? " of " : "", of);
        snprintf(q->column, sizeof q->column, "%s%s%s.%s", which, *of ? "." : "", of, info->column);
        u->nquantities++;
    }
}

/* Whether a gap can be asked for: some floors of neighbours stand where they could touch, and none goes on for ever. */
static bool has_gap(const struct thud_scene *scene)
{
    struct thud_contact_pair *meeting = malloc(THUD_CONTACT_PAIRS_MAX * sizeof *meeting);
    bool found = false;
    for (int i = 0; meeting && i + 1 < scene->nstructures; i++)
        found = found || thud_interface_contact_pairs(scene, i, meeting) > 0;
    for (int i = 0; i < scene->nstructures; i++)
        found = found && scene->structure[i].kind != THUD_RIGID;
    free(meeting);
    return found;
}

static bool asks_gap(const struct thud_uncertainty *u)
{
    return u->nquantities > 0 && u->quantity[0].measure == THUD_MEASURE_GAP;
}

static void add_quantities(struct thud_uncertainty *u)
{
    const struct thud_measure_info *gap = thud_measure_info(THUD_MEASURE_GAP);
    if (has_gap(&u->scene))
        u->nquantities = 1;
    if (u->nquantities > 0) {
        u->quantity[0] = (struct thud_quantity_of_run){.measure = THUD_MEASURE_GAP, .structure = -1};
        snprintf(u->quantity[0].name, sizeof u->quantity[0].name, "%s", gap->words);
        snprintf(u->quantity[0].column, sizeof u->quantity[0].column, "%s", gap->column);
    }
    for (int k = 0; k < u->ncases; k++) {
        for (int s = 0; s < u->scene.nstructures; s++)
            if (has_floors(&u->scene.structure[s]))
                add(u, k, s, thud_structure_features(&u->scene.structure[s]));
        add(u, k, -1, u->columns ? THUD_HAS_COLUMNS : 0);
    }
}

/* The motion of a suite that asks for the median of its required separations, the lower of two; the first where it has
 * none. */
static enum thud_status find_median(struct thud_uncertainty *u, struct thud_error *err)
{
    double *need_m = calloc((size_t)u->nsuite, sizeof *need_m);
    enum thud_status status = need_m ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int r = 0; r < u->nsuite && status == THUD_OK; r++) {
        struct thud_needed_gap *gap = NULL;
        status = thud_needed_gap_run(&u->scene, u->suite[r], &gap, err);
        need_m[r] = gap ? thud_needed_gap_widest(gap, 0, THUD_GAP_EXACT, NULL) : NAN;
        free(gap);
    }
    for (int r = 0; r < u->nsuite && status == THUD_OK; r++) {
        int below = 0;
        for (int i = 0; i < u->nsuite; i++)
            below += need_m[i] < need_m[r] || (need_m[i] == need_m[r] && i < r);
        if (below == (u->nsuite - 1) / 2)
            u->record = u->suite[r];
    }
    free(need_m);
    return status;
}

/* The interface of a row whose required gap is the widest in the nominal scene. */
static enum thud_status find_governing(struct thud_uncertainty *u, struct thud_error *err)
{
    struct thud_needed_gap *gap;
    int level = 0;
    enum thud_status status = thud_needed_gap_run(&u->scene, u->record, &gap, err);
    if (status == THUD_OK && gap->nlevels > 0) {
        thud_needed_gap_widest(gap, 0, THUD_GAP_EXACT, &level);
        u->governs = gap->level[level].interface;
    }
    free(gap);
    return status;
}

enum thud_status thud_uncertainty_create(const struct thud_scene *scene, const struct thud_record *record,
                                         const struct thud_record *const *suite, int nsuite, enum thud_case which,
                                         const struct thud_inputs *inputs, struct thud_uncertainty **out,
                                         struct thud_error *err)
{
    struct thud_uncertainty *u = calloc(1, sizeof *u);
    const bool bumper = thud_scene_has_bumper(scene), measure = thud_scene_has_measure(scene);
    const enum thud_case written = !bumper             ? THUD_CASE_LINK
                                   : scene->nlinks > 0 ? THUD_CASE_AS_WRITTEN
                                                       : THUD_CASE_BUMPER;
    *out = NULL;
    if (!u)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    u->scene = *scene;
    u->suite = suite;
    u->nsuite = nsuite;
    u->record = !record && nsuite > 0 ? suite[0] : record;
    u->columns = has_struck(scene, -1, false);
    if (measure)
        u->which[u->ncases++] = THUD_CASE_NONE;
    if (!measure || which != THUD_CASE_NONE)
        u->which[u->ncases++] = measure && which == THUD_CASE_AS_WRITTEN ? written : which;
    enum thud_status status = find_inputs(u, inputs, err);
    u->quantity = calloc(1 + (size_t)u->ncases * ((size_t)scene->nstructures + 1) * THUD_MEASURES, sizeof *u->quantity);
    if (!u->quantity)
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status != THUD_OK) {
        thud_uncertainty_free(u);
        return status;
    }
    add_quantities(u);
    if (!record && nsuite > 1)
        status = find_median(u, err);
    if (status == THUD_OK && asks_gap(u) && scene->nstructures > 2)
        status = find_governing(u, err);
    if (status == THUD_OK)
        *out = u;
    else
        thud_uncertainty_free(u);
    return status;
}

void thud_uncertainty_free(struct thud_uncertainty *uncertainty)
{
    if (!uncertainty)
        return;
    free(uncertainty->quantity);
    free(uncertainty);
}

/* The quantities of case k of a sample. */
static void put_case(const struct thud_uncertainty *u, const struct thud_measured_run *run, double *value)
{
    for (int q = asks_gap(u); q < u->nquantities; q++)
        if (u->quantity[q].which == u->which[run->k])
            value[q] = thud_measure_read(run, u->quantity[q].measure, u->quantity[q].structure);
}

/* Those of a finished point of the changed scene, up to a case without a result. */
static enum thud_status put_point(const struct thud_uncertainty *u, const struct thud_scene *scene,
                                  const struct thud_sweep_point *point, double *value, struct thud_error *err)
{
    const enum thud_case need = thud_sweep_need_case(u->which, u->ncases);
    if (asks_gap(u) && point->ncontacts > 0 && !thud_sweep_fall(point, need)->happened)
        value[0] = thud_gap_widest(thud_sweep_levels(point, need), point->ncontacts, 0, THUD_GAP_EXACT, NULL);
    for (int k = 0; k < u->ncases; k++) {
        const struct thud_sweep_effort *effort = &point->effort[k];
        if (effort->status != THUD_OK)
            return effort->status == THUD_DIVERGED ? THUD_OK : effort->status;
        if (thud_collapse_status(scene, &effort->fall, err) != THUD_OK)
            return THUD_COLLAPSED;
        put_case(u, &(struct thud_measured_run){scene, point, k}, value);
    }
    return THUD_OK;
}

enum thud_status thud_uncertainty_evaluate(const struct thud_uncertainty *u, const double *place, double *value,
                                           struct thud_error *err)
{
    struct thud_sweep_plan *plan = malloc(sizeof *plan);
    struct thud_record *scaled = NULL;
    struct thud_sweep_point *point = NULL;
    enum thud_status status = THUD_OK;
    double motion = 1;
    if (!plan)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int q = 0; q < u->nquantities; q++)
        value[q] = NAN;
    thud_sweep_plan_init(plan, &u->scene);
    for (int i = 0; i < u->ninputs; i++)
        thud_input_change(&plan->scene, &u->input[i], place[i], &motion);
    plan->has = thud_scene_features(&plan->scene);
    plan->ncases = u->ncases;
    memcpy(plan->cases, u->which, (size_t)u->ncases * sizeof *u->which);
    const struct thud_record *record = thud_uncertainty_record(u, place[u->ninputs - 1]);
    if (record && motion != 1) {
        status = thud_record_scaled(record, motion, &scaled, err);
        record = scaled;
    }
    plan->record = &record;
    plan->nrecords = record != NULL;
    if (status == THUD_OK)
        status = thud_sweep_point_make(plan, 0, &point, err);
    if (status == THUD_OK)
        status = put_point(u, &plan->scene, point, value, err);
    thud_record_free(scaled);
    free(point);
    free(plan);
    return status == THUD_DIVERGED ? THUD_OK : status; /* a sample without a result */
}
