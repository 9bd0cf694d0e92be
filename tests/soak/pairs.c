/* Random scenes of every family by `exact` and by `dormand-prince`, both at a tolerance of 1e-10.  Each difference of more
 * than 1e-7 is told with what explains it: how much inputs changed by 1e-9 move the number, and whether a finer tolerance takes
 * the one method or the other to the other's number.  usage: pairs [FIRST [COUNT [FAMILY]]]: COUNT of each family, or of
 * the one that begins at seed FAMILY, from seed FIRST on: SCENES_COARSE (100000000000) and above are those with samples far
 * apart */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "../unit/scenes.h"

static const unsigned long long family[] = {
    0,
    SCENES_WIDE,
    SCENES_YIELDING,
    SCENES_COLUMNS,
    SCENES_P_DELTA,
    SCENES_LINKS,
    SCENES_MATRICES,
    SCENES_ISOLATORS,
    SCENES_SOIL,
    SCENES_MIXED,
};
enum { FAMILIES = sizeof family / sizeof *family };

/* Numbers below this share of the largest of their kind are compared with that share. */
static const double least = 1e-2;
/* Both at this tolerance; a difference is looked into from `limit` on. */
static const double tolerance = 1e-10, finer = 1e-12, limit = 1e-7;
/* So far apart a finer run of dormand-prince may still be: a peak where a force sets in, as a column's just before it is
 * struck, is read from polynomials that are right to a part of the force. */
static const double settled = 1e-6;
/* What a tolerance of 1e-10 of each step may come to over a motion, as a relative change of the inputs. */
static const double change = 1e-8;

static const struct scenes_options exact = {.tolerance = tolerance, .most = 40000},
                                   other = {.method = "dormand-prince", .tolerance = tolerance, .most = 100000},
                                   finer_exact = {.tolerance = finer, .most = 80000},
                                   finer_other = {.method = "dormand-prince", .tolerance = finer, .most = 1000000};

/* The lengths and speeds by which methods tell contact from rest are absolute: smaller motions are looked at enlarged. */
static const double smallest_m = 1e-4;

static long made, within, sensitive, small, resting, of_exact, of_other, stopped, failed, open_ones;

/* The relative change of number `at` for a relative change 1 of gaps and stiffnesses. */
static double amplified(const struct scenes_one *one, const struct scenes_solution *base, int at)
{
    static const double eps[] = {1e-9, 1e-8};
    double most = 0, size = fmax(fabs(base->number[at].value), least * base->largest[base->number[at].kind]);
    for (int k = 0; k < 2 * SCENES_NUDGES; k++) {
        struct scenes_one near;
        struct scenes_solution a;
        scenes_copy(&near, one);
        scenes_nudge(&near, k % SCENES_NUDGES, eps[k / SCENES_NUDGES]);
        scenes_run(&near, &finer_exact, &a);
        double off = a.status == THUD_OK && !a.stopped && a.n == base->n ? a.number[at].value - base->number[at].value
                                                                         : INFINITY;
        most = fmax(most, isnan(off) ? INFINITY : fabs(off) / eps[k / SCENES_NUDGES] / size);
        scenes_answer_clear(&a);
        scenes_clear(&near);
    }
    return most;
}

static double apart(const struct scenes_solution *a, const struct scenes_solution *b)
{
    int at;
    return a->status == THUD_OK && b->status == THUD_OK && !a->stopped && !b->stopped && a->n == b->n
               ? scenes_apart(a, b, least, NULL, 0, &at)
               : NAN;
}

/* Whether both agree where all lengths are larger: the motion is too small for the one or the other as it stands. */
static bool agree_enlarged(const struct scenes_one *one)
{
    struct scenes_one large;
    bool agree = false;
    scenes_copy(&large, one);
    if (one->peak_m < smallest_m && scenes_longer(&large, exp2(ceil(log2(1 / one->peak_m))))) {
        struct scenes_solution a, b;
        scenes_run(&large, &exact, &a);
        scenes_run(&large, &other, &b);
        agree = apart(&b, &a) <= limit;
        scenes_answer_clear(&a);
        scenes_answer_clear(&b);
    }
    scenes_clear(&large);
    return agree;
}

static bool passes_blows(const struct scenes_one *one, int interface)
{
    const struct thud_interface *at = &one->scene.interface[interface];
    return (at->has_bumper ? at->bumper.law : at->contact.law)->flags & THUD_LAW_IMPULSIVE;
}

/* Leaves out how a contact that only passes blows on was told: impulses smaller than a method can tell from rest, or the
 * force of one that rests. What they do to the motion is compared. */
static void leave_out_rests(const struct scenes_one *one, struct scenes_solution *a)
{
    for (int i = 0; i < a->n; i++) {
        struct scenes_number *x = &a->number[i];
        bool of_contact = x->kind == SCENES_FORCE || x->kind == SCENES_FIRST || x->kind == SCENES_TIME ||
                          x->kind == SCENES_INDENTATION || x->kind == SCENES_LOST || x->kind == SCENES_IMPACTS ||
                          x->kind == SCENES_ACCELERATION;
        if (x->kind == SCENES_ACCELERATION) {
            const bool left = x->place > 0 && passes_blows(one, x->place - 1),
                       right = x->place + 1 < one->scene.nstructures && passes_blows(one, x->place);
            of_contact = left || right;
        } else if (of_contact) {
            of_contact = x->place >= 0 && passes_blows(one, x->place);
        }
        if (of_contact)
            x->value = NAN;
    }
}

static bool agree_but_for_rests(const struct scenes_one *one, struct scenes_solution *a, struct scenes_solution *b)
{
    leave_out_rests(one, a);
    leave_out_rests(one, b);
    return apart(b, a) <= limit;
}

static void explain(const struct scenes_one *one, struct scenes_solution *a, struct scenes_solution *b, double off,
                    int at)
{
    struct scenes_solution fine, fine_other;
    scenes_run(one, &finer_exact, &fine);
    scenes_run(one, &finer_other, &fine_other);
    double moved = apart(a, &fine), moved_other = apart(b, &fine), left = apart(&fine_other, &fine);
    double factor = fine.status == THUD_OK && !fine.stopped && fine.n == a->n ? amplified(one, &fine, at) : NAN;
    const struct scenes_number shown = a->number[at], shown_other = b->number[at];
    const char *why = "OPEN";
    if (left < limit && moved > limit) {
        why = "exact misses its tolerance";
        of_exact++;
    } else if (factor * change >= off) {
        why = "sensitive";
        sensitive++;
    } else if (left < fmin(fmax(settled, 0.01 * off), 0.1 * off)) {
        why = "dormand-prince misses its tolerance";
        of_other++;
    } else if (agree_enlarged(one)) {
        why = "too small";
        small++;
    } else if (agree_but_for_rests(one, a, b)) {
        why = "impulses at rest";
        resting++;
    } else {
        open_ones++;
    }
    char text[1000];
    scenes_describe(one, text, sizeof text);
    printf(
        "%llu: %s: %s %d.%d %.12g and %.12g, off by %.2g; a change of 1 in the inputs is one of %.2g; exact moves by "
        "%.2g, dormand-prince by %.2g to the finer one, which are %.2g apart\n#   %s\n",
        one->seed, why, scenes_kind_name(shown.kind), shown.place + 1, shown.index + 1, shown.value, shown_other.value,
        off, factor, moved, moved_other, left, text);
    scenes_answer_clear(&fine);
    scenes_answer_clear(&fine_other);
}

static bool agrees_finer(const struct scenes_one *one, const struct scenes_solution *a)
{
    struct scenes_solution b;
    scenes_run(one, &finer_other, &b);
    bool agree = apart(&b, a) <= limit;
    scenes_answer_clear(&b);
    return agree;
}

static void check(unsigned long long seed)
{
    struct scenes_one one;
    struct scenes_solution a, b;
    scenes_draw(&one, seed);
    scenes_run(&one, &exact, &a);
    scenes_run(&one, &other, &b);
    made++;
    if (a.stopped || b.stopped) {
        stopped++;
    } else if (a.status != THUD_OK || b.status != THUD_OK) {
        bool both = a.status == b.status; /* a collapse ends both */
        bool refused = !both && a.status == THUD_OK && agrees_finer(&one, &a);
        failed += both;
        of_other += refused;
        open_ones += !both && !refused;
        char text[1000];
        scenes_describe(&one, text, sizeof text);
        printf("%llu: %s: %s | %s\n#   %s\n", seed,
               both      ? "no result of either"
               : refused ? "dormand-prince refuses itself, and agrees where finer"
                         : "OPEN",
               a.err.what, b.err.what, text);
    } else if (a.n != b.n) {
        open_ones++;
        printf("%llu: OPEN: %d and %d numbers\n", seed, a.n, b.n);
    } else {
        int at;
        double off = scenes_apart(&b, &a, least, NULL, 0, &at);
        if (off <= limit)
            within++;
        else
            explain(&one, &a, &b, off, at);
    }
    scenes_answer_clear(&a);
    scenes_answer_clear(&b);
    scenes_clear(&one);
}

int main(int argc, char **argv)
{
    unsigned long long first = argc > 1 ? strtoull(argv[1], NULL, 10) : 1;
    long count = argc > 2 ? strtol(argv[2], NULL, 10) : 100;
    const unsigned long long only = argc > 3 ? strtoull(argv[3], NULL, 10) : 0;
    for (long i = 0; i < count; i++) {
        for (int k = 0; k < (argc > 3 ? 1 : FAMILIES); k++)
            check((argc > 3 ? only : family[k]) + first + (unsigned long long)i);
        fflush(stdout);
        if (i % 50 == 49 || i + 1 == count)
            fprintf(stderr,
                    "%ld pairs: %ld within %g, %ld sensitive, %ld of exact, %ld of dormand-prince, %ld too small, "
                    "%ld with impulses at rest, %ld too long, %ld without a result, %ld open\n",
                    made, within, limit, sensitive, of_exact, of_other, small, resting, stopped, failed, open_ones);
    }
    return open_ones > 0;
}
