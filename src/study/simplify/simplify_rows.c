/* The table of simplifications. Most are keys that are set; where nothing changes, a row does not apply. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "core/methods/method.h"
#include "ground/intensity.h"
#include "study/scene/level.h"
#include "study/simplify/simplify_private.h"

/* Masses and stiffnesses of all storeys are their means. */
static bool make_equal(const struct thud_simplify_from *from, struct thud_scene *scene)
{
    struct thud_structure *s = &scene->structure[from->at];
    double mass = 0, stiffness = 0;
    if (s->storeys < 2 || (s->kind != THUD_SHEAR && s->kind != THUD_ISOLATED))
        return false;
    for (int i = 0; i < s->storeys; i++) {
        mass += s->mass_kg[i] / s->storeys;
        stiffness += s->stiffness_npm[i] / s->storeys;
    }
    for (int i = 0; i < s->storeys; i++) {
        s->mass_kg[i] = mass;
        s->stiffness_npm[i] = stiffness;
        s->load_pa[i] = 0;
    }
    s->area_m2 = 0; /* neither a load nor a period gives these any more */
    s->period_s = s->kind == THUD_SHEAR ? (double)NAN : 0;
    return true;
}

/* Linear isolators of the same secant stiffness and energy lost in a cycle at the displacement D of the full run:
 *     k_e = k (r D + (1 - r) u_y)/D,   zeta_e = 2 (1 - r) k u_y (D - u_y)/(pi k_e D^2). */
static bool make_linear_isolators(const struct thud_simplify_from *from, struct thud_scene *scene)
{
    const struct thud_structure *was = &from->base->structure[from->at];
    struct thud_structure *s = &scene->structure[from->at];
    const double most = 0.9;
    if (s->kind != THUD_ISOLATED || !thud_isolator_slides(s))
        return false;
    const struct thud_isolator i = thud_structure_isolator(was);
    const double d = fmax(from->full->structure[from->at].floor[0].displacement.value, i.yield_m),
                 q = (1 - i.hardening) * i.stiffness_npm * i.yield_m, k = i.hardening * i.stiffness_npm + q / d;
    s->isolator_law = THUD_ISOLATOR_LINEAR;
    thud_isolator_keep_own(s);
    s->isolation_stiffness_npm = k;
    s->isolation_damping = fmin(most, i.damping + 2 * q * (d - i.yield_m) / (THUD_PI * k * d * d));
    return true;
}

static bool make_rigid_wall(const struct thud_simplify_from *from, struct thud_scene *scene)
{
    struct thud_structure *s = &scene->structure[from->at];
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
static const char *const level_words[] = {"the top level", "the levels in contact", NULL};
static bool make_levels(const struct thud_simplify_from *from, struct thud_scene *scene)
{
    struct thud_contact_pair pair[THUD_CONTACT_PAIRS_MAX];
    struct thud_interface *to = &scene->interface[from->at];
    const int n = thud_interface_contact_pairs(from->base, from->at, pair);
    int level[THUD_CONTACT_PAIRS_MAX], top = 0, left_out = 0, contact = 0;
    bool kept[THUD_CONTACT_PAIRS_MAX], stays[THUD_STOREYS_MAX + 2] = {false};
    struct thud_by_level list = {0};
    if (to->contact_levels.n != from->base->interface[from->at].contact_levels.n)
        return false;
    while (contact < from->full->ncontacts && from->full->contact[contact].interface != from->at + 1)
        contact++;
    for (int i = 0; i < n; i++) {
        level[i] = thud_contact_level(from->base, from->at, &pair[i]);
        top = level[i] > top ? level[i] : top;
        stays[level[i]] |= from->size == TOUCHED_LEVELS && from->full->contact[contact + i].impacts > 0;
    }
    stays[top] |= from->size == TOP_LEVEL;
    for (int i = 0; i < n; i++)
        left_out += !(kept[i] = stays[level[i]]);
    for (int i = 1; i <= top; i++)
        if (stays[i] && list.n < THUD_LEVELS_MAX)
            list.value_m[list.n++] = i;
    if (left_out == 0 || left_out == n || list.n == THUD_LEVELS_MAX)
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

/* Another law with the restitution of the one that acts; `stiffness` NaN: it has none. */
static bool make_law(struct thud_interface *at, const char *name, double stiffness_npm)
{
    struct thud_law_choice *choice = acting_law(at), now;
    const double *given = thud_law_given(choice, "restitution"), restitution = given ? *given : (double)NAN;
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
static bool make_linear_law(const struct thud_simplify_from *from, struct thud_scene *scene)
{
    struct thud_law_choice *choice = acting_law(&scene->interface[from->at]);
    const struct thud_contact_result *most = thud_contact_hardest(from->full, from->at + 1);
    if (!choice->law || thud_law_is_linear(choice->law) || !most || !(most->force.value > 0) ||
        !(most->indentation.value > 0))
        return false;
    const double *restitution = thud_law_given(choice, "restitution");
    const bool loses = restitution && *restitution < 1;
    return make_law(&scene->interface[from->at], loses ? "kelvin-voigt-no-tension" : "linear",
                    most->force.value / most->indentation.value);
}

static bool make_impulses(const struct thud_simplify_from *from, struct thud_scene *scene)
{
    const struct thud_law *law = acting_law(&scene->interface[from->at])->law;
    if (!law || law->flags & (THUD_LAW_NO_FORCE | THUD_LAW_IMPULSIVE))
        return false;
    return make_law(&scene->interface[from->at], "stereomechanical", NAN);
}

static bool make_no_contact(const struct thud_simplify_from *from, struct thud_scene *scene)
{
    struct thud_interface *i = &scene->interface[from->at];
    if (from->base->nstructures < 3 || !i->contact.law || i->contact.law->flags & THUD_LAW_NO_FORCE)
        return false;
    i->has_bumper = false;
    i->thickness.n = 0;
    return make_law(i, "none", NAN);
}

static const char *const stiffnesses[] = {"twice", "half", NULL};
static bool make_stiffness(const struct thud_simplify_from *from, struct thud_scene *scene)
{
    struct thud_law_choice *choice = acting_law(&scene->interface[from->at]);
    double *k = thud_law_given(choice, "stiffness");
    if (k)
        *k *= from->size == 0 ? 2 : 0.5;
    return k != NULL;
}

static bool make_without_link(const struct thud_simplify_from *from, struct thud_scene *scene)
{
    for (int i = 0; i < scene->nlinks; i++)
        if (memcmp(&scene->link[i], &from->base->link[from->at], sizeof scene->link[i]) == 0) {
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
static bool make_strong_part(const struct thud_simplify_from *from, struct thud_scene *scene)
{
    if (!from->record || from->base->record.every > 1)
        return false;
    const struct thud_intensity i = thud_intensity_of(from->record); /* NaN of a motion of zeros */
    const double begin = thud_simplify_begin(from->base, from->record), ms = 1e-3;
    if (!(i.t95_s > i.t5_s) || i.pga_time_s < i.t5_s + from->record->dt_s ||
        i.pga_time_s > i.t95_s - from->record->dt_s)
        return false;
    scene->record.from_s = floor((begin + i.t5_s) / ms) * ms;
    scene->record.to_s = ceil((begin + i.t95_s) / ms) * ms;
    return true;
}

static const char *const modes[] = {"1", "2", "3", "4", "5", "6", "8", "10", "13", "17", "22", "30", "50", "80", NULL},
                         *const every[] = {"2", "4", NULL}, *const tolerance[] = {"1e-3", "1e-4", NULL},
                         *const tolerances[] = {"1e-2", "1e-3", "1e-4", "1e-6", NULL},
                         *const steps[] = {"10 ms", "5 ms", "2 ms", "1 ms", "0.5 ms", "0.2 ms", NULL};

/* A method other than those of closed forms, by its step or its tolerance. */
static bool make_method(const struct thud_simplify_from *from, struct thud_scene *scene)
{
    const struct thud_method *method = thud_method_at(from->at);
    return !(method->flags & THUD_METHOD_DEMONSTRATION) && method->order > 0 &&
           strcmp(scene->analysis.method, method->name) != 0 &&
           (from->row->size == steps) == ((method->flags & THUD_METHOD_FIXED_STEP) != 0);
}

#define NO_FOUNDATION(key) "structures.@.foundation." key "=;"

/* clang-format off */
#define ROW(group_, span_, words_, keys_, size_, input_) .words = (words_), .keys = (keys_), .size = (size_), .input = (input_), .group = THUD_SIMPLIFY_##group_, .span = THUD_SPAN_##span_
static const struct thud_simplify_row rows[] = {
    {ROW(MODEL, STRUCTURE, "# modes of $", "structures.@.modes=#", modes, "higher modes of $")},
    {ROW(MODEL, STRUCTURE, "equal storeys of $", NULL, NULL, "storey variation of $"), .make = make_equal},
    {ROW(MODEL, STRUCTURE, "elastic storeys of $", "structures.@.yield=;structures.@.yield-shear=;structures.@.hardening=", NULL, "strength of $")},
    {ROW(MODEL, STRUCTURE, "fixed base of $", NO_FOUNDATION("mass") NO_FOUNDATION("inertia") NO_FOUNDATION("sway-stiffness") NO_FOUNDATION("sway-damping")
     NO_FOUNDATION("rocking-stiffness") NO_FOUNDATION("rocking-damping") NO_FOUNDATION("vs") NO_FOUNDATION("density")
     NO_FOUNDATION("poisson") NO_FOUNDATION("radius"), NULL, "soil under $")},
    {ROW(MODEL, SCENE, "no P-Delta", "p-delta=no", NULL, "P-Delta effects")},
    {ROW(MODEL, STRUCTURE, "linear isolators of $", NULL, NULL, "law of the isolators of $"), .make = make_linear_isolators},
    {ROW(MODEL, STRUCTURE, "rigid wall $", NULL, NULL, "flexibility of $"), .make = make_rigid_wall},
    {ROW(MODEL, STRUCTURE, "slabs of $ without depth", "structures.@.slab-depth=0 cm", NULL, "slab depth of $")},
    {ROW(MODEL, LINK, "without link $", NULL, NULL, "link $"), .make = make_without_link},
    {ROW(CONTACT, INTERFACE, "contact of $ only at #", NULL, level_words, ""), .make = make_levels},
    {ROW(CONTACT, INTERFACE, "no contact of $", NULL, NULL, "contact of $"), .make = make_no_contact},
    {ROW(CONTACT, INTERFACE, "linear law of $", NULL, NULL, "contact law of $"), .make = make_linear_law},
    {ROW(CONTACT, INTERFACE, "impulses with restitution of $", NULL, NULL, "contact law of $"), .make = make_impulses},
    {ROW(CONTACT, INTERFACE, "no residual indentation of $", "interfaces.@.!.residual=recover", NULL, "residual indentation of $")},
    {ROW(CONTACT, INTERFACE, "contact of $ # as stiff", NULL, stiffnesses, "contact stiffness of $"), .information = true, .make = make_stiffness},
    {ROW(MOTION, SCENE, "strong phase of the motion (5 to 95 %)", NULL, NULL, "motion outside its strong phase"), .make = make_strong_part},
    {ROW(MOTION, SCENE, "one sample in #", "record.every=#", every, "")},
    {ROW(MOTION, SCENE, "motion low-pass filtered at mode #", NULL, modes, ""), .information = true, .enough = true},
    {ROW(METHOD, SCENE, "tolerance #", "analysis.tolerance=#", tolerance, "")},
    {ROW(METHOD, METHOD, "$ in steps of #", "analysis.method=$;analysis.step=#", steps, ""), .information = true, .enough = true, .make = make_method},
    {ROW(METHOD, METHOD, "$ at tolerance #", "analysis.method=$;analysis.tolerance=#", tolerances, ""), .information = true, .enough = true, .make = make_method},
};
/* clang-format on */

const struct thud_simplify_row *thud_simplify_row_of(const struct thud_simplification *of)
{
    return &rows[of->row];
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
        else if (*c == '!')
            snprintf(part, sizeof part, "%s", scene->interface[of->at].has_bumper ? "bumper" : "contact");
        else if (*c == '$' && row->span == THUD_SPAN_LINK)
            thud_link_name(scene, of->at, part, sizeof part);
        else if (*c == '$' && row->span == THUD_SPAN_INTERFACE)
            snprintf(part, sizeof part, "%s-%s", scene->structure[of->at].name, scene->structure[of->at + 1].name);
        else if (*c == '$')
            snprintf(part, sizeof part, "%s",
                     row->span == THUD_SPAN_METHOD ? thud_method_at(of->at)->name : scene->structure[of->at].name);
        used += (size_t)snprintf(text + used, size - used, "%s", part);
    }
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

bool thud_simplify_apply(const struct thud_simplification *of, struct thud_simplify_from from, struct thud_scene *scene)
{
    const struct thud_simplify_row *row = &rows[of->row];
    struct thud_scene *before = malloc(sizeof *before);
    if (!before)
        return false;
    from.row = row;
    from.at = of->at;
    from.size = of->size;
    *before = *scene;
    bool made = !row->make || row->make(&from, scene);
    if (made && row->keys)
        set_keys(of, scene);
    made = made &&
           (memcmp(before, scene, sizeof *scene) != 0 || thud_simplify_low_pass(of, from.full, from.record) > 0) &&
           thud_scene_check(scene, NULL) == THUD_OK;
    if (made && row->span == THUD_SPAN_STRUCTURE)
        made = leaves_modes(before, scene, of->at);
    free(before);
    return made;
}

double thud_simplify_low_pass(const struct thud_simplification *of, const struct thud_result *full,
                              const struct thud_record *record)
{
    static const double margin = 1.25; /* the pass has fallen within a sixth of its corner */
    const int mode = rows[of->row].size == modes ? atoi(modes[of->size]) : 0;
    double shortest_s = INFINITY;
    if (rows[of->row].group != THUD_SIMPLIFY_MOTION || mode == 0)
        return 0;
    for (int s = 0; s < full->nstructures; s++)
        if (mode <= full->structure[s].floors)
            shortest_s = fmin(shortest_s, full->structure[s].period_s[mode - 1]);
    const double spacing = shortest_s / (2 * margin * record->dt_s);
    return isfinite(spacing) && spacing > 1 ? spacing : 0;
}

int thud_simplify_list(struct thud_simplify_from from, bool no_methods, int most, struct thud_simplification *one)
{
    const struct thud_scene *scene = from.base;
    const int count[] = {1, scene->nstructures, scene->nstructures - 1, scene->nlinks,
                         no_methods ? 0 : thud_method_count()};
    struct thud_scene *trial = malloc(sizeof *trial);
    int n = 0;
    for (int r = 0; trial && r < (int)(sizeof rows / sizeof *rows); r++)
        for (int at = 0; at < count[rows[r].span] && (from.record || rows[r].group != THUD_SIMPLIFY_MOTION); at++)
            for (int size = 0; n < most && (size == 0 || (rows[r].size && rows[r].size[size])); size++) {
                struct thud_simplification *to = &one[n];
                *to = (struct thud_simplification){.group = rows[r].group,
                                                   .information = rows[r].information,
                                                   .median = NAN,
                                                   .worst = NAN,
                                                   .row = r,
                                                   .at = at,
                                                   .size = size};
                *trial = *scene;
                if (!thud_simplify_apply(to, from, trial))
                    continue;
                fill(rows[r].words, to, scene, to->words, sizeof to->words);
                if (strncmp(to->words, "1 modes", 7) == 0)
                    memmove(to->words + 6, to->words + 7, strlen(to->words + 7) + 1);
                fill(rows[r].input, to, scene, to->input, sizeof to->input);
                n++;
            }
    free(trial);
    return n;
}
