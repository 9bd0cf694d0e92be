#include "scenes_check.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

/* Numbers below this share of the largest of their kind are not looked at alone; the second where a tolerance,
 * which is one of the largest force, plays its part. */
static const double least = 1e-4, least_forced = 1e-2;
/* The lengths below which the program takes neighbours not to touch, with a margin: what they do to a result is what
 * as large a change of the gaps does. And the smallest motion that these lengths leave alone. */
static const double touch_noise_m = 1e-14, smallest_m = 1e-4;

struct subject {
    struct scenes_tally *tally;
    struct scenes_one one;
    struct scenes_solution base; /* exact, 1e-10 */
    double *amplify;             /* (base.n) change of a number for a change 1 of the inputs */
    double worst_amplify;        /* relative */
    bool linear;                 /* the tolerance plays no part */
};

static int find_check(struct scenes_tally *tally, const char *name)
{
    int i = 0;
    while (tally->check[i].name && strcmp(tally->check[i].name, name) != 0)
        i++;
    assert(i < SCENES_CHECKS_MAX);
    tally->check[i].name = name;
    return i;
}

static void report(struct subject *s, const char *name, const char *what)
{
    char text[1000];
    scenes_describe(&s->one, text, sizeof text);
    printf("# %s\n#   %s: %s\n", text, name, what);
    s->tally->wrong++;
}

/* Holds a result against the base: `tolerance` of each number is allowed, and what a change of the inputs by `eps`
 * explains. */
static void hold(struct subject *s, const char *name, const struct scenes_solution *a, double tolerance, double eps)
{
    double part = strstr(name, "tolerance") ? least_forced : least;
    int at, i = find_check(s->tally, name);
    char what[600];
    if (a->stopped) {
        s->tally->check[i].skipped++;
        return;
    }
    s->tally->check[i].made++;
    if (a->status != THUD_OK) {
        snprintf(what, sizeof what, "fails: %s", a->err.what);
        s->tally->check[i].off++;
        report(s, name, what);
        return;
    }
    double off = scenes_apart(a, &s->base, part, eps > 0 ? s->amplify : NULL, eps + touch_noise_m / s->one.peak_m, &at);
    if (off / (tolerance > 0 ? tolerance : 1e-16) > s->tally->check[i].worst)
        s->tally->check[i].worst = off / (tolerance > 0 ? tolerance : 1e-16);
    if (off <= tolerance)
        return;
    s->tally->check[i].off++;
    const struct scenes_number *x = &a->number[at < 0 ? 0 : at], *y = &s->base.number[at < 0 ? 0 : at];
    snprintf(what, sizeof what, "%s %d.%d is %.13g, base %.13g: off by %.3g, allowed %.3g (amplified %.3g)",
             scenes_kind_name(y->kind), y->place + 1, y->index + 1, x->value, y->value, off, tolerance,
             at < 0 ? 0 : s->amplify[at] / fmax(fabs(y->value), 1e-300));
    report(s, name, what);
}

static bool asked(const struct subject *s, const char *name)
{
    return strstr(name, s->tally->only) != NULL;
}

static void run_and_hold(struct subject *s, const char *name, const struct scenes_one *one,
                         const struct scenes_options *options, double tolerance, double eps, bool mirrored)
{
    struct scenes_solution a;
    scenes_run(one, options, &a);
    if (mirrored)
        scenes_unmirror(one, &a);
    hold(s, name, &a, tolerance, eps);
    scenes_answer_clear(&a);
}

static const struct scenes_options tight = {.tolerance = 1e-10, .most = 20000};

static void find_amplification(struct subject *s)
{
    static const double eps[] = {1e-9, 1e-7};
    for (int k = 0; k < 2 * SCENES_NUDGES; k++) {
        struct scenes_one near;
        struct scenes_solution a;
        scenes_copy(&near, &s->one);
        scenes_nudge(&near, k % SCENES_NUDGES, eps[k / SCENES_NUDGES]);
        scenes_run(&near, &tight, &a);
        if (a.status != THUD_OK && strstr("nudged", s->tally->only))
            report(s, "nudged", a.err.what);
        for (int i = 0; a.status == THUD_OK && i < s->base.n; i++) {
            double off = fabs(a.number[i].value - s->base.number[i].value) / eps[k / SCENES_NUDGES];
            off = isnan(off) ? INFINITY : off; /* a count or a time that is unclear */
            s->amplify[i] = fmax(s->amplify[i], off);
            enum scenes_kind kind = s->base.number[i].kind;
            double scale =
                fmax(fabs(s->base.number[i].value), least * fmax(s->base.largest[kind], s->base.natural[kind]));
            if (off > 0 && kind <= SCENES_FORCE)
                s->worst_amplify = fmax(s->worst_amplify, off / scale);
        }
        scenes_answer_clear(&a);
        scenes_clear(&near);
    }
}

static void check_same_bits(struct subject *s)
{
    if (asked(s, "history"))
        run_and_hold(s, "history", &s->one, &(struct scenes_options){.tolerance = 1e-10, .history = true}, 0, 0, false);
    if (asked(s, "slices"))
        run_and_hold(s, "slices", &s->one, &(struct scenes_options){.tolerance = 1e-10, .slice = 1}, 1e-14, 0, false);
}

/* Numbers of a scene in other units, back in its own. */
static void scale_back(struct scenes_solution *a, double mass, double length)
{
    for (int i = 0; i < a->n; i++) {
        struct scenes_number *x = &a->number[i];
        bool force = x->kind == SCENES_SHEAR || x->kind == SCENES_FORCE || x->kind == SCENES_IMPULSE ||
                     (x->kind >= SCENES_COLUMN_SHEAR && x->kind <= SCENES_LINK_FORCE),
             lost = x->kind == SCENES_LOST || x->kind == SCENES_LINK_LOST;
        if (force || lost)
            x->value /= mass;
        if (force || x->kind < SCENES_SHEAR || x->kind == SCENES_INDENTATION || x->kind == SCENES_LINK_STROKE)
            x->value /= length;
        if (lost)
            x->value /= length * length;
    }
    a->largest[SCENES_LOST] /= mass * length * length;
    a->largest[SCENES_LINK_LOST] /= mass * length * length;
    for (int k = 0; k < SCENES_LINK_LOST; k++)
        if (k < SCENES_LOST || k >= SCENES_COLUMN_SHEAR)
            a->largest[k] = 0;
}

static void check_units(struct subject *s, const char *name, bool (*change)(struct scenes_one *, double), double factor,
                        bool is_mass)
{
    struct scenes_one other;
    struct scenes_solution a;
    if (!asked(s, name) || (!is_mass && fmin(factor, 1) * s->one.peak_m < smallest_m))
        return;
    scenes_copy(&other, &s->one);
    if (change(&other, factor)) {
        scenes_run(&other, &tight, &a);
        scale_back(&a, is_mass ? factor : 1, is_mass ? 1 : factor);
        bool bits = s->linear;
        hold(s, name, &a, bits && is_mass ? 0 : 1e-7, bits && is_mass ? 0 : 1e-9);
        scenes_answer_clear(&a);
    }
    scenes_clear(&other);
}

/* Bounces that come to rest end by rounding after one more or one less: a result then lies anywhere in the scatter of the
 * nudged ones, at one end of which the base may lie (SCENES_YIELDING + 39). */
static const double scatter_eps = 2e-9;

static void check_symmetries(struct subject *s)
{
    static const char *const names[] = {"mirror", "halved", "padded", "resampled"};
    for (int k = 0; k < 4; k++) {
        struct scenes_one other;
        if (!asked(s, names[k]) || (k == 3 && !s->tally->slow && !*s->tally->only)) /* which is slow */
            continue;
        scenes_copy(&other, &s->one);
        if (k == 0)
            scenes_mirror(&other);
        else if (k == 2)
            scenes_pad(&other, 7);
        else
            scenes_resample(&other, k == 1 ? 2 : 10);
        run_and_hold(s, names[k], &other, &tight, s->linear ? 1e-9 : 1e-7, s->linear ? 1e-11 : scatter_eps, k == 0);
        scenes_clear(&other);
    }
    check_units(s, "masses", scenes_heavier, 16, true);
    check_units(s, "masses down", scenes_heavier, 1.0 / 1024, true);
    check_units(s, "lengths", scenes_longer, 8, false);
    check_units(s, "lengths down", scenes_longer, 1.0 / 64, false);
}

static void check_tolerances(struct subject *s)
{
    static const double tolerance[] = {1e-4, 1e-6, 1e-8};
    static const char *const names[] = {"tolerance 1e-4", "tolerance 1e-6", "tolerance 1e-8"};
    for (int k = 0; k < 3; k++)
        if (asked(s, names[k]) && (s->worst_amplify * tolerance[k] < 0.01 || s->linear))
            run_and_hold(s, names[k], &s->one, &(struct scenes_options){.tolerance = tolerance[k]},
                         s->linear ? 1e-9 : 10 * tolerance[k], s->linear ? 1e-11 : 3 * tolerance[k], false);
}

static void check_methods(struct subject *s)
{
    /* a tolerance of 1e-10 of the whole motion is 1e-4 of what a light floor does beside a heavy one */
    const bool wide = s->one.seed >= SCENES_WIDE;
    const struct scenes_options options = {
        .method = "dormand-prince", .tolerance = wide ? 1e-12 : 1e-10, .most = wide ? 200000 : 60000};
    if (asked(s, "dormand-prince"))
        run_and_hold(s, "dormand-prince", &s->one, &options, 1e-4, 1e-8, false);
}

static void check_sweep(struct subject *s)
{
    char what[300];
    if (!asked(s, "study") || s->one.scene.nstructures < 2)
        return;
    int i = find_check(s->tally, "study");
    s->tally->check[i].made++;
    if (scenes_sweep_agrees(&s->one, what, sizeof what))
        return;
    s->tally->check[i].off++;
    report(s, "study", what);
}

static bool tolerance_matters(const struct scenes_one *one)
{
    for (int i = 0; i + 1 < one->scene.nstructures; i++) {
        const struct thud_interface *at = &one->scene.interface[i];
        const struct thud_law *law = at->has_bumper ? at->bumper.law : at->contact.law;
        if (!(law->flags & (THUD_LAW_LINEAR | THUD_LAW_NO_FORCE)))
            return true;
    }
    return false;
}

/* Dormand-Prince's tolerance is one of the whole motion: of a building that moves by a micrometre beside a body that moves
 * by a metre it leaves two digits (SCENES_WIDE + 281). Such numbers are left out. */
static void leave_out_small(struct subject *s)
{
    static const double part = 1e-5;
    double most[THUD_STRUCTURES_MAX] = {0};
    for (int i = 0; i < s->base.n; i++)
        if (s->base.number[i].kind == SCENES_DISPLACEMENT)
            most[s->base.number[i].place] = fmax(most[s->base.number[i].place], s->base.number[i].value);
    for (int i = 0; i < s->base.n; i++)
        if (s->base.number[i].kind < SCENES_FORCE &&
            most[s->base.number[i].place] < part * s->base.largest[SCENES_DISPLACEMENT])
            s->base.number[i].value = NAN;
}

void scenes_check(unsigned long long seed, struct scenes_tally *tally)
{
    struct subject s = {.tally = tally};
    tally->scenes++;
    scenes_draw(&s.one, seed);
    s.linear = !tolerance_matters(&s.one);
    scenes_run(&s.one, &tight, &s.base);
    if (s.base.stopped) {
        tally->stopped++;
    } else if (s.base.status == THUD_OK) {
        s.amplify = calloc((size_t)s.base.n + 1, sizeof *s.amplify);
        assert(s.amplify);
        find_amplification(&s);
        tally->pounding += s.base.largest[SCENES_IMPACTS] > 0;
        bool tame = s.worst_amplify <= 1e6 && s.one.peak_m >= smallest_m;
        tally->wild += !tame;
        int energy = find_check(tally, "energy");
        tally->check[energy].made++;
        tally->check[energy].worst = fmax(tally->check[energy].worst, s.base.error_ratio / 1e-7);
        if (!(s.base.error_ratio < 1e-7)) {
            char what[64];
            snprintf(what, sizeof what, "error ratio %g", s.base.error_ratio);
            tally->check[energy].off++;
            report(&s, "energy", what);
        }
        check_same_bits(&s);
        check_sweep(&s);
        if (tame) {
            check_tolerances(&s);
            check_symmetries(&s);
            if (tally->slow) {
                if (seed >= SCENES_WIDE)
                    leave_out_small(&s);
                check_methods(&s);
            }
        }
    } else {
        tally->failed++;
        report(&s, "exact", s.base.err.what);
    }
    free(s.amplify);
    scenes_answer_clear(&s.base);
    scenes_clear(&s.one);
}

void scenes_tally_print(const struct scenes_tally *tally, FILE *out)
{
    fprintf(
        out,
        "# %ld scenes: %ld with pounding, %ld too wild or too small to compare, %ld without a result, %ld too long\n",
        tally->scenes, tally->pounding, tally->wild, tally->failed, tally->stopped);
    for (int i = 0; i < SCENES_CHECKS_MAX && tally->check[i].name; i++)
        fprintf(out, "# %-20s %6ld made, %4ld skipped, %4ld off, worst %.3g of what is allowed\n", tally->check[i].name,
                tally->check[i].made, tally->check[i].skipped, tally->check[i].off, tally->check[i].worst);
}
