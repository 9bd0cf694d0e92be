/* The factor at which contact begins, of random scenes, by every way that tells it: the finder that fragility and report
 * share, fragility's own, the required gap of the motion at either side of it, single runs at either side and at parts
 * of it, and solve in a range of a part in 1e6 around it.  usage: agree [COUNT [FIRST]]    scenes, from seed FIRST on.
 * A line for each disagreement; the last ones count what was drawn.  From 200 scenes on it fails where a kind of
 * structure, contact, link or isolator, backfill, soil, P-Delta or yielding did not occur. */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../unit/scenes.h"
#include "app/sweep/solve.h"
#include "app/sweep/sweep_jobs.h"
#include "study/scene/first_contact.h"
#include "study/scene/level.h"
#include "study/scene/scene_elements.h"

static const unsigned long long family[] = {
    0,           SCENES_YIELDING, SCENES_COLUMNS, SCENES_P_DELTA, SCENES_LINKS, SCENES_MATRICES, SCENES_ISOLATORS,
    SCENES_SOIL, SCENES_MIXED,
};
enum { FAMILIES = sizeof family / sizeof *family };

/* To which all have to agree, as a part of the factor. */
static const double close = 1e-6;

/* Clearances are whole picometres where they can be: motions that are smaller at the factor, and clearances of which
 * `close` is less, are left out. */
static const double smallest_m = 1e-5, smallest_clearance_m = 1e-8;

static const char *const kinds[] = {"shear", "rigid", "isolated", "wall", "matrix", "modes", "estimated"};
static const char *const links[THUD_LINK_LAWS] = {"spring", "dashpot", "friction", "restrainer", "strut"};
static const char *const others[] = {"backfill", "soil", "P-Delta", "yielding", "no bumper", "bumper"};
enum { KINDS = sizeof kinds / sizeof *kinds, OTHERS = sizeof others / sizeof *others, LAWS_MAX = 32 };
static struct {
    long kind[KINDS], link[THUD_LINK_LAWS], isolator[3], law[LAWS_MAX], other[OTHERS];
} drawn;

static struct {
    long scenes, compared, scaled, searched, never, without_motion, without_force, at_rest, soft, too_small, failed,
        wrong;
} tally;

static void complain(const struct scenes_one *one, const char *what, double a, double b)
{
    char text[1000];
    scenes_describe(one, text, sizeof text);
    printf("%llu: %s: %.12g, %.12g\n#   %s\n", one->seed, what, a, b, text);
    tally.wrong++;
}

/* ---- what is drawn ---- */

static int law_index(const char *name)
{
    for (int i = 0; thud_law_at(i); i++)
        if (strcmp(thud_law_at(i)->name, name) == 0)
            return i;
    return -1;
}

static void count_interface(const struct thud_interface *at)
{
    drawn.law[law_index((at->has_bumper ? &at->bumper : &at->contact)->law->name)]++;
    drawn.other[at->has_bumper ? 5 : 4]++;
}

static void count_drawn(const struct thud_scene *scene)
{
    for (int s = 0; s < scene->nstructures; s++) {
        const struct thud_structure *p = &scene->structure[s];
        drawn.kind[p->kind]++;
        if (p->kind == THUD_ISOLATED)
            drawn.isolator[(int)p->isolator_law]++;
        drawn.other[0] += thud_wall_has_backfill(p);
        drawn.other[1] += thud_structure_on_soil(p);
        if (s + 1 < scene->nstructures)
            count_interface(&scene->interface[s]);
    }
    for (int i = 0; i < scene->nlinks; i++)
        drawn.link[(int)scene->link[i].law]++;
    drawn.other[2] += scene->p_delta;
    drawn.other[3] += thud_scene_yields(scene);
}

static bool is_missing(const char *what, const char *name, long count)
{
    printf("# %s %s: %ld\n", what, name, count);
    return count == 0;
}

static int tell_drawn(void)
{
    int missing = 0;
    for (int i = 0; i < KINDS; i++)
        missing += is_missing("structures", kinds[i], drawn.kind[i]);
    for (int i = 0; thud_law_at(i); i++)
        missing += is_missing("contacts", thud_law_at(i)->name, drawn.law[i]);
    for (int i = 0; i < THUD_LINK_LAWS; i++)
        missing += is_missing("links", links[i], drawn.link[i]);
    for (int i = 0; i < 3; i++)
        missing += is_missing("isolators", thud_isolator_name((enum thud_isolator_law)i), drawn.isolator[i]);
    for (int i = 0; i < OTHERS; i++)
        missing += is_missing("scenes with", others[i], drawn.other[i]);
    return missing;
}

/* What the drawing does not make: the law whose stiffnesses stand on their own, and an estimated building. */
static void vary(struct scenes_one *one, unsigned long long seed)
{
    struct scenes_one was;
    struct thud_structure *first = &one->scene.structure[0];
    scenes_copy(&was, one);
    for (int i = 0; i + 1 < one->scene.nstructures; i++) /* what touches at rest has no factor */
        if (thud_interface_clearance(&one->scene.interface[i]) <= 0)
            one->scene.interface[i].gap_m += 0.3 * one->peak_m;
    if (seed % 11 == 3)
        thud_law_choice_init(one->scene.interface[0].has_bumper ? &one->scene.interface[0].bumper
                                                                : &one->scene.interface[0].contact,
                             thud_law_find("impact-material"));
    if (seed % 13 == 4 && first->kind == THUD_SHEAR && first->height_m[0] > 0)
        (void)thud_scene_set(&one->scene, "structures.1.kind", "estimated", NULL);
    if (thud_scene_check(&one->scene, NULL) != THUD_OK)
        one->scene = was.scene;
    scenes_clear(&was);
}

/* ---- the ways ---- */

static void scale(struct scenes_one *to, const struct scenes_one *from, double factor)
{
    scenes_copy(to, from);
    thud_record_scale(to->record, factor);
}

/* Whether a single run has a contact, or only an impact that counts; -1: it has no result. */
static int touches(const struct scenes_one *one, double factor, bool counted)
{
    const struct scenes_options exact = {.tolerance = one->scene.analysis.tolerance, .most = 200000};
    struct scenes_one scaled;
    struct scenes_solution a;
    scale(&scaled, one, factor);
    scenes_run(&scaled, &exact, &a);
    int found = a.status == THUD_OK && !a.stopped ? 0 : -1;
    for (int i = 0; found == 0 && i < a.n; i++) {
        const enum scenes_kind kind = a.number[i].kind;
        const bool closed = kind == SCENES_FORCE || kind == SCENES_INDENTATION;
        found = (kind == SCENES_IMPACTS || (closed && !counted)) && a.number[i].value > 0;
    }
    scenes_answer_clear(&a);
    scenes_clear(&scaled);
    return found;
}

/* The largest share of a clearance that the motion at a factor needs, NaN: no result; and that clearance. */
static double needs(const struct scenes_one *one, double factor, double *clearance_m)
{
    struct scenes_one scaled;
    struct thud_needed_gap *gap = NULL;
    double most = 0;
    scale(&scaled, one, factor);
    if (thud_needed_gap_run(&scaled.scene, scaled.record, &gap, NULL) != THUD_OK)
        most = NAN;
    for (int i = 0; gap && i < gap->nlevels; i++) {
        const struct thud_gap_level *l = &gap->level[i];
        const struct thud_level_values at =
            thud_interface_level(&scaled.scene.interface[l->interface - 1], thud_needed_gap_level(gap->level, i));
        const double share = l->relative_displacement_m / thud_level_clearance(&at);
        if (share > most)
            most = share, *clearance_m = thud_level_clearance(&at);
    }
    free(gap);
    scenes_clear(&scaled);
    return most;
}

/* Fragility's, along the motion's factor; NaN: none. */
static double by_fragility(const struct scenes_one *one)
{
    struct thud_sweep_plan *plan = malloc(sizeof *plan);
    struct thud_suite *suite = NULL;
    struct thud_event event;
    struct thud_fragility out = {0};
    const struct thud_record *record = one->record;
    assert(plan);
    thud_sweep_plan_init(plan, &one->scene);
    plan->record = &record;
    plan->nrecords = 1;
    struct thud_fragility_ask ask = {.event = &event, .first_contact = true};
    bool made = thud_event_parse("pounding", &event, NULL) == THUD_OK &&
                thud_sweep_vary(plan, "record.factor=0.5,1", NULL) == THUD_OK &&
                thud_sweep_suite_run(plan, 1, NULL, &suite, NULL) == THUD_OK &&
                thud_fragility_make(suite, &ask, &out, NULL) == THUD_OK;
    double found = made && out.nexact == 1 ? out.exact[0] : NAN;
    thud_fragility_clear(&out);
    thud_suite_free(suite);
    thud_sweep_plan_clear(plan);
    free(plan);
    return found;
}

/* How often solve finds contact to begin or end between two factors; -1: it fails. */
static int changes(const struct scenes_one *one, double from, double to)
{
    struct thud_solve *out = malloc(sizeof *out);
    struct thud_record *record = one->record;
    struct thud_record_list list = {.n = 1, .record = &record};
    struct thud_criterion criterion;
    struct thud_error err = {0};
    char by[96];
    assert(out);
    snprintf(by, sizeof by, "record.factor=%.17g:%.17g", from, to);
    enum thud_status status = thud_criterion_parse("no pounding", &criterion, &err);
    if (status == THUD_OK)
        status = thud_solve_run(&one->scene, &list, by, &criterion, 1, NULL, out, &err);
    const int found = status == THUD_OK ? out->changes : -1;
    if (found < 0)
        printf("# solve %s: %s\n", by, err.what);
    free(out);
    return found;
}

static bool is_impulsive(const struct thud_scene *scene, bool no_force)
{
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        const struct thud_interface *at = &scene->interface[i];
        if ((at->has_bumper ? &at->bumper : &at->contact)->law->flags &
            (no_force ? THUD_LAW_NO_FORCE : THUD_LAW_IMPULSIVE))
            return true;
    }
    return false;
}

/* Solve asks for an impact that counts, by its impulse: soft contacts have none before a larger factor. */
static void check_solve(const struct scenes_one *one, double factor)
{
    double beyond = close;
    while (beyond < 0.1 && touches(one, factor * (1 + beyond), true) != 1)
        beyond *= 10;
    tally.soft += beyond > close;
    const int found = changes(one, factor * (1 - beyond), factor * (1 + beyond));
    if (found != 1 && beyond < 0.1)
        complain(one, "solve finds not one change", found, factor);
}

/* All ways at a factor that was found. */
static void compare(const struct scenes_one *one, double factor)
{
    const double below = factor * (1 - close), above = factor * (1 + close);
    double clearance_m = INFINITY;
    const double gap_below = needs(one, below, &clearance_m), gap_above = needs(one, above, &clearance_m);
    if (clearance_m < smallest_clearance_m) {
        tally.too_small++;
        return;
    }
    const double told = by_fragility(one);
    tally.compared++;
    *(thud_scene_scales(&one->scene) ? &tally.scaled : &tally.searched) += 1;
    if (!(fabs(told - factor) <= close * factor))
        complain(one, "fragility's factor", told, factor);
    if (!(gap_below < 1 && gap_above >= 1))
        complain(one, "the share of the clearance that is needed before and behind the factor", gap_below, gap_above);
    if (is_impulsive(&one->scene, true)) { /* nothing is told of its contacts */
        tally.without_force++;
        return;
    }
    for (double part = 0.25; part < 1; part += 0.25)
        if (touches(one, part * factor, false) > 0)
            complain(one, "a single run touches at a part of the factor", part, factor);
    if (touches(one, below, false) != 0)
        complain(one, "a single run just below the factor touches, or fails", touches(one, below, false), factor);
    if (touches(one, above, false) != 1) {
        if (is_impulsive(&one->scene, false) && touches(one, factor * (1 + 1e-3), false) == 1)
            tally.at_rest++; /* an approach at a speed that is none */
        else
            complain(one, "a single run just above the factor does not touch", touches(one, above, false), factor);
    } else {
        check_solve(one, factor);
    }
}

static void check(unsigned long long seed)
{
    struct scenes_one one;
    struct thud_needed_gap *gap = NULL;
    struct thud_first_contact found = {0};
    scenes_draw(&one, seed);
    vary(&one, seed);
    count_drawn(&one.scene);
    tally.scenes++;
    if (!one.record) {
        tally.without_motion++;
    } else if (thud_needed_gap_run(&one.scene, one.record, &gap, NULL) != THUD_OK ||
               thud_first_contact_find(&one.scene, one.record, gap, &found, NULL) != THUD_OK) {
        tally.failed++;
    } else if (one.peak_m * fmin(found.first, 1) < smallest_m && found.first > 0) {
        tally.too_small++;
    } else if (!isfinite(found.first) || found.first == 0) {
        tally.never++;
        if (isinf(found.first) && touches(&one, 1, false) > 0 && !is_impulsive(&one.scene, true))
            complain(&one, "a single run touches where contact never begins", 1, found.first);
    } else {
        compare(&one, found.first);
    }
    free(gap);
    scenes_clear(&one);
}

int main(int argc, char **argv)
{
    const long count = argc > 1 ? strtol(argv[1], NULL, 10) : 2000;
    const unsigned long long first = argc > 2 ? strtoull(argv[2], NULL, 10) : 20001;
    enum { ALL = 200 }; /* so many draw everything */
    for (long i = 0; i < count; i++) {
        check(family[i % FAMILIES] + first + (unsigned long long)(i / FAMILIES));
        fflush(stdout);
        if (i % 100 == 99)
            fprintf(stderr, "%ld scenes, %ld compared, %ld wrong\n", tally.scenes, tally.compared, tally.wrong);
    }
    const int missing = tell_drawn();
    printf("# %ld scenes: %ld compared (%ld by scaling, %ld by search), %ld wrong\n", tally.scenes, tally.compared,
           tally.scaled, tally.searched, tally.wrong);
    printf("# not compared: %ld never or always touch, %ld are too small, %ld have no ground motion, %ld no result\n",
           tally.never, tally.too_small, tally.without_motion, tally.failed);
    printf("# of those compared: %ld without force, %ld with impulses at rest, %ld with an impulse that counts for no "
           "impact just above the factor\n",
           tally.without_force, tally.at_rest, tally.soft);
    if (missing > 0 && count >= ALL)
        printf("# %d of what there is did not occur\n", missing);
    return tally.wrong > 0 || tally.compared == 0 || (missing > 0 && count >= ALL);
}
