/* The table of simplifications. Most are keys that are set; where nothing changes, a row does not apply. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "ground/intensity.h"
#include "study/scene/level.h"
#include "study/simplify/simplify_private.h"

/* Masses and stiffnesses of all storeys are their means. */
static bool make_equal(const struct thud_scene *base, const struct thud_record *record, const struct thud_result *full,
                       int at, int size, struct thud_scene *scene)
{
    struct thud_structure *s = &scene->structure[at];
    double mass = 0, stiffness = 0;
    (void)base, (void)record, (void)full, (void)size;
    if (s->storeys < 2 || (s->kind != THUD_SHEAR && s->kind != THUD_ISOLATED))
        return false;
    for (int i = 0; i < s->storeys; i++) {
        mass += s->mass_kg[i] / s->storeys;
        stiffness += s->stiffness_npm[i] / s->storeys;
    }
    for (int i = 0; i < s->storeys; i++) {
        s->mass_kg[i] = mass;
        s->stiffness_npm[i] = stiffness;
    }
    return true;
}

/* Linear isolators of the same secant stiffness and the same energy lost in a cycle at the displacement D of the full run:
 *     k_e = k (r D + (1 - r) u_y)/D,   zeta_e = 2 (1 - r) k u_y (D - u_y)/(pi k_e D^2). */
static bool make_linear_isolators(const struct thud_scene *base, const struct thud_record *record,
                                  const struct thud_result *full, int at, int size, struct thud_scene *scene)
{
    const struct thud_structure *was = &base->structure[at];
    struct thud_structure *s = &scene->structure[at];
    const double most = 0.9;
    (void)record, (void)size;
    if (s->kind != THUD_ISOLATED || !thud_isolator_slides(s))
        return false;
    const struct thud_isolator i = thud_structure_isolator(was);
    const double d = fmax(full->structure[at].floor[0].displacement.value, i.yield_m),
                 q = (1 - i.hardening) * i.stiffness_npm * i.yield_m, k = i.hardening * i.stiffness_npm + q / d;
    s->isolator_law = THUD_ISOLATOR_LINEAR;
    s->isolator_strength_n = s->isolator_post_yield_npm = s->isolator_yield_m = NAN;
    s->isolator_radius_m = s->isolator_friction = NAN;
    s->isolation_stiffness_npm = k;
    s->isolation_damping = fmin(most, i.damping + 2 * q * (d - i.yield_m) / (THUD_PI * k * d * d));
    return true;
}

static bool make_rigid_wall(const struct thud_scene *base, const struct thud_record *record,
                            const struct thud_result *full, int at, int size, struct thud_scene *scene)
{
    struct thud_structure *s = &scene->structure[at];
    (void)base, (void)record, (void)full, (void)size;
    s->wall_mass_kg = s->wall_stiffness_npm = s->wall_damping = NAN;
    s->backfill_stiffness_npm = s->backfill_strength_n = s->backfill_ratio = s->backfill_gap_m = NAN;
    return s->kind == THUD_WALL;
}

/* Leaves of a list with a value for each pair those of the pairs that stay. */
static void keep_levels(struct thud_by_level *list, const bool *kept, int n)
{
    int stay = 0;
    for (int i = 0; i < list->n && i < n; i++)
        if (kept[i])
            list->value_m[stay++] = list->value_m[i];
    list->n = list->n > 0 ? stay : 0;
}

enum { TOP_LEVEL, TOUCHED_LEVELS };
static const char *const level_words[] = {"the top level", "the levels that touch", NULL};
static bool make_levels(const struct thud_scene *base, const struct thud_record *record, const struct thud_result *full,
                        int at, int size, struct thud_scene *scene)
{
    struct thud_contact_pair pair[THUD_CONTACT_PAIRS_MAX];
    struct thud_interface *to = &scene->interface[at];
    const int n = thud_interface_contact_pairs(base, at, pair);
    bool kept[THUD_CONTACT_PAIRS_MAX] = {false};
    int top = 0, levels = 0, all = 0, contact = 0;
    (void)record;
    if (to->contact_levels.n != base->interface[at].contact_levels.n)
        return false;
    for (int i = 0; i < n; i++)
        top = (int)fmax(top, thud_contact_level(base, at, &pair[i]));
    while (contact < full->ncontacts && full->contact[contact].interface != at + 1)
        contact++;
    struct thud_by_level list = {0};
    for (int level = 1; level <= top; level++) {
        bool touches = size == TOP_LEVEL && level == top, there = false;
        for (int i = 0; i < n; i++)
            if (thud_contact_level(base, at, &pair[i]) == level) {
                touches = touches || (size == TOUCHED_LEVELS && full->contact[contact + i].impacts > 0);
                there = true;
            }
        all += there;
        if (touches && list.n < THUD_LEVELS_MAX)
            list.value_m[list.n++] = level;
        for (int i = 0; i < n; i++)
            kept[i] = kept[i] || (touches && thud_contact_level(base, at, &pair[i]) == level);
        levels += touches;
    }
    if (levels == 0 || levels == all || levels > THUD_LEVELS_MAX)
        return false;
    to->contact_levels = list;
    keep_levels(&to->gap, kept, n);
    keep_levels(&to->thickness, kept, n);
    return true;
}

static struct thud_law_choice *acting_law(struct thud_interface *at)
{
    return at->has_bumper ? &at->bumper : &at->contact;
}

static double law_value(const struct thud_law_choice *choice, const char *name)
{
    const int i = thud_law_param(choice->law, name);
    return i < 0 ? NAN : choice->value[i];
}

/* Another law with the restitution of the one that acts; `stiffness` NaN: it has none. */
static bool make_law(struct thud_interface *at, const char *name, double stiffness_npm)
{
    struct thud_law_choice *choice = acting_law(at), now;
    const double restitution = law_value(choice, "restitution");
    thud_law_choice_init(&now, thud_law_find(name));
    const int r = thud_law_param(now.law, "restitution"), k = thud_law_param(now.law, "stiffness"),
              residual = thud_law_param(now.law, "residual");
    if (r >= 0 && isfinite(restitution))
        now.value[r] = restitution;
    if (k >= 0)
        now.value[k] = stiffness_npm;
    if (residual >= 0)
        now.value[residual] = 1; /* recover: what the other law gave back */
    *choice = now;
    return true;
}

/* The secant stiffness of the hardest contact of the full run. */
static bool make_linear_law(const struct thud_scene *base, const struct thud_record *record,
                            const struct thud_result *full, int at, int size, struct thud_scene *scene)
{
    struct thud_law_choice *choice = acting_law(&scene->interface[at]);
    double force = 0, depth = 0;
    (void)base, (void)record, (void)size;
    if (!choice->law || thud_law_is_linear(choice->law))
        return false;
    for (int c = 0; c < full->ncontacts; c++)
        if (full->contact[c].interface == at + 1 && full->contact[c].force.value > force) {
            force = full->contact[c].force.value;
            depth = full->contact[c].indentation.value;
        }
    if (!(force > 0) || !(depth > 0))
        return false;
    const bool loses = law_value(choice, "restitution") < 1;
    return make_law(&scene->interface[at], loses ? "kelvin-voigt-no-tension" : "linear", force / depth);
}

static bool make_impulses(const struct thud_scene *base, const struct thud_record *record,
                          const struct thud_result *full, int at, int size, struct thud_scene *scene)
{
    const struct thud_law *law = acting_law(&scene->interface[at])->law;
    (void)base, (void)record, (void)full, (void)size;
    if (!law || law->flags & (THUD_LAW_NO_FORCE | THUD_LAW_IMPULSIVE))
        return false;
    return make_law(&scene->interface[at], "stereomechanical", NAN);
}

static bool make_no_contact(const struct thud_scene *base, const struct thud_record *record,
                            const struct thud_result *full, int at, int size, struct thud_scene *scene)
{
    struct thud_interface *i = &scene->interface[at];
    (void)record, (void)full, (void)size;
    if (base->nstructures < 3 || !i->contact.law || i->contact.law->flags & THUD_LAW_NO_FORCE)
        return false;
    i->has_bumper = false;
    i->thickness.n = 0;
    return make_law(i, "none", NAN);
}

static const char *const stiffnesses[] = {"twice", "half", NULL};
static bool make_stiffness(const struct thud_scene *base, const struct thud_record *record,
                           const struct thud_result *full, int at, int size, struct thud_scene *scene)
{
    struct thud_law_choice *choice = acting_law(&scene->interface[at]);
    const int k = choice->law ? thud_law_param(choice->law, "stiffness") : -1;
    (void)base, (void)record, (void)full;
    if (k < 0 || !isfinite(choice->value[k]))
        return false;
    choice->value[k] *= size == 0 ? 2 : 0.5;
    return true;
}

static bool make_residual(const struct thud_scene *base, const struct thud_record *record,
                          const struct thud_result *full, int at, int size, struct thud_scene *scene)
{
    struct thud_law_choice *choice = acting_law(&scene->interface[at]);
    const int i = choice->law ? thud_law_param(choice->law, "residual") : -1;
    (void)base, (void)record, (void)full, (void)size;
    if (i >= 0)
        choice->value[i] = 1;
    return i >= 0;
}

static bool make_without_link(const struct thud_scene *base, const struct thud_record *record,
                              const struct thud_result *full, int at, int size, struct thud_scene *scene)
{
    (void)record, (void)full, (void)size;
    for (int i = 0; i < scene->nlinks; i++)
        if (memcmp(&scene->link[i], &base->link[at], sizeof scene->link[i]) == 0) {
            thud_link_remove(scene, i);
            return true;
        }
    return false;
}

double thud_simplify_begin(const struct thud_scene *base, const struct thud_record *record)
{
    return isnan(base->record.from_s) ? 0 : ceil(base->record.from_s / record->dt_s - 1e-6) * record->dt_s;
}

/* From 5 to 95 % of the Arias intensity, where the peak lies between: then the scale stays. */
static bool make_strong_part(const struct thud_scene *base, const struct thud_record *record,
                             const struct thud_result *full, int at, int size, struct thud_scene *scene)
{
    (void)full, (void)at, (void)size;
    if (!record || base->record.every > 1)
        return false;
    const struct thud_intensity i = thud_intensity_of(record); /* NaN of a motion of zeros */
    const double begin = thud_simplify_begin(base, record), ms = 1e-3;
    if (!(i.t95_s > i.t5_s) || i.pga_time_s < i.t5_s + record->dt_s || i.pga_time_s > i.t95_s - record->dt_s)
        return false;
    scene->record.from_s = floor((begin + i.t5_s) / ms) * ms;
    scene->record.to_s = ceil((begin + i.t95_s) / ms) * ms;
    return true;
}

static const char *const modes[] = {"1", "2", "3", "4", "5", "6", "8", "10", "13", "17", "22", "30", "50", "80", NULL},
                         *const every[] = {"2", "4", NULL}, *const tolerance[] = {"1e-3", "1e-4", NULL},
                         *const steps[] = {"5 ms", "2 ms", "1 ms", "0.5 ms", NULL};
#define NO_FOUNDATION(key) "structures.@.foundation." key "=;"

/* clang-format off */
#define WORDS(words_, keys_, size_, group_, span_) .words = (words_), .keys = (keys_), .size = (size_), .group = (group_), .span = (span_)
static const struct thud_simplify_row rows[] = {
    {WORDS("# modes of $", "structures.@.modes=#", modes, THUD_SIMPLIFY_MODEL, THUD_SPAN_STRUCTURE)},
    {WORDS("equal storeys of $", NULL, NULL, THUD_SIMPLIFY_MODEL, THUD_SPAN_STRUCTURE), .make = make_equal},
    {WORDS("elastic storeys of $", "structures.@.yield=;structures.@.yield-shear=;structures.@.hardening=", NULL, THUD_SIMPLIFY_MODEL, THUD_SPAN_STRUCTURE)},
    {WORDS("fixed base of $", NO_FOUNDATION("mass") NO_FOUNDATION("inertia") NO_FOUNDATION("sway-stiffness") NO_FOUNDATION("sway-damping")
     NO_FOUNDATION("rocking-stiffness") NO_FOUNDATION("rocking-damping") NO_FOUNDATION("vs") NO_FOUNDATION("density")
     NO_FOUNDATION("poisson") NO_FOUNDATION("radius"), NULL, THUD_SIMPLIFY_MODEL, THUD_SPAN_STRUCTURE)},
    {WORDS("no P-Delta", "p-delta=no", NULL, THUD_SIMPLIFY_MODEL, THUD_SPAN_SCENE)},
    {WORDS("linear isolators of $", NULL, NULL, THUD_SIMPLIFY_MODEL, THUD_SPAN_STRUCTURE), .make = make_linear_isolators},
    {WORDS("rigid wall $", NULL, NULL, THUD_SIMPLIFY_MODEL, THUD_SPAN_STRUCTURE), .make = make_rigid_wall},
    {WORDS("slabs of $ without depth", "structures.@.slab-depth=0 cm", NULL, THUD_SIMPLIFY_MODEL, THUD_SPAN_STRUCTURE)},
    {WORDS("without link $", NULL, NULL, THUD_SIMPLIFY_MODEL, THUD_SPAN_LINK), .make = make_without_link},
    {WORDS("contact of $ at # alone", NULL, level_words, THUD_SIMPLIFY_CONTACT, THUD_SPAN_INTERFACE), .contacts = true, .make = make_levels},
    {WORDS("no contact of $", NULL, NULL, THUD_SIMPLIFY_CONTACT, THUD_SPAN_INTERFACE), .contacts = true, .make = make_no_contact},
    {WORDS("linear law of $", NULL, NULL, THUD_SIMPLIFY_CONTACT, THUD_SPAN_INTERFACE), .contacts = true, .make = make_linear_law},
    {WORDS("impulses by restitution of $", NULL, NULL, THUD_SIMPLIFY_CONTACT, THUD_SPAN_INTERFACE), .contacts = true, .make = make_impulses},
    {WORDS("no residual of $", NULL, NULL, THUD_SIMPLIFY_CONTACT, THUD_SPAN_INTERFACE), .contacts = true, .make = make_residual},
    {WORDS("contact of $ # as stiff", NULL, stiffnesses, THUD_SIMPLIFY_CONTACT, THUD_SPAN_INTERFACE), .information = true, .contacts = true, .make = make_stiffness},
    {WORDS("strong part of the motion (5 to 95 %)", NULL, NULL, THUD_SIMPLIFY_MOTION, THUD_SPAN_SCENE), .make = make_strong_part},
    {WORDS("one sample in #", "record.every=#", every, THUD_SIMPLIFY_MOTION, THUD_SPAN_SCENE)},
    {WORDS("tolerance #", "analysis.tolerance=#", tolerance, THUD_SIMPLIFY_METHOD, THUD_SPAN_SCENE), .contacts = true},
    {WORDS("newmark in steps of #", "analysis.method=newmark;analysis.step=#", steps, THUD_SIMPLIFY_METHOD, THUD_SPAN_SCENE), .information = true, .contacts = true},
    {WORDS("rk4 in steps of #", "analysis.method=rk4;analysis.step=#", steps, THUD_SIMPLIFY_METHOD, THUD_SPAN_SCENE), .information = true, .contacts = true},
};
/* clang-format on */

int thud_simplify_rows(void)
{
    return (int)(sizeof rows / sizeof *rows);
}

const struct thud_simplify_row *thud_simplify_row_at(int i)
{
    return &rows[i];
}

int thud_simplify_span(const struct thud_simplify_row *row, const struct thud_scene *scene)
{
    const int count[THUD_SPANS] = {1, scene->nstructures, scene->nstructures - 1, scene->nlinks};
    return count[row->span];
}

/* The template with name, number and size in it. */
static void fill(const char *template, const struct thud_simplification *of, const struct thud_scene *scene, char *text,
                 size_t size)
{
    const struct thud_simplify_row *row = &rows[of->row];
    size_t used = 0;
    for (const char *c = template; *c && used + 1 < size; c++) {
        char part[2 * THUD_NAME_MAX + 8] = {*c};
        if (*c == '#')
            snprintf(part, sizeof part, "%s", row->size[of->size]);
        else if (*c == '@')
            snprintf(part, sizeof part, "%d", of->at + 1);
        else if (*c == '$' && row->span == THUD_SPAN_LINK)
            thud_link_name(scene, of->at, part, sizeof part);
        else if (*c == '$' && row->span == THUD_SPAN_INTERFACE)
            snprintf(part, sizeof part, "%s-%s", scene->structure[of->at].name, scene->structure[of->at + 1].name);
        else if (*c == '$')
            snprintf(part, sizeof part, "%s", scene->structure[of->at].name);
        used += (size_t)snprintf(text + used, size - used, "%s", part);
    }
}

void thud_simplify_words(const struct thud_simplification *of, const struct thud_scene *scene, char *text, size_t size)
{
    fill(rows[of->row].words, of, scene, text, size);
    if (strncmp(text, "1 modes", 7) == 0)
        memmove(text + 6, text + 7, strlen(text + 7) + 1);
}

/* Sets each key of the row; a key that the scene does not have is passed over. */
static void set_keys(const struct thud_simplification *of, struct thud_scene *scene)
{
    char text[640];
    fill(rows[of->row].keys, of, scene, text, sizeof text);
    for (char *key = text; *key;) {
        char *value = strchr(key, '='), *end = key + strcspn(key, ";"), *next = end + (*end == ';');
        *value++ = *end = '\0';
        thud_scene_set(scene, key, value, NULL);
        key = next;
    }
}

/* More modes than the building has leave nothing out. */
static bool leaves_modes(const struct thud_scene *before, const struct thud_scene *after, int at)
{
    const struct thud_structure *s = &after->structure[at];
    const int most = thud_structure_floors(s) + 2 * thud_structure_on_soil(s), was = before->structure[at].modes,
              all = before->analysis.modes;
    return s->modes == was || (s->modes < most && (was == 0 || s->modes < was) && (all == 0 || s->modes < all));
}

bool thud_simplify_apply(const struct thud_simplification *of, const struct thud_scene *base,
                         const struct thud_record *record, const struct thud_result *full, struct thud_scene *scene)
{
    const struct thud_simplify_row *row = &rows[of->row];
    struct thud_scene *before = malloc(sizeof *before);
    if (!before)
        return false;
    *before = *scene;
    bool made = !row->make || row->make(base, record, full, of->at, of->size, scene);
    if (!row->make)
        set_keys(of, scene);
    made = made && memcmp(before, scene, sizeof *scene) != 0 && thud_scene_check(scene, NULL) == THUD_OK;
    if (made && row->span == THUD_SPAN_STRUCTURE)
        made = leaves_modes(before, scene, of->at);
    free(before);
    return made;
}
