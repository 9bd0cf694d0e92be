/* Random scenes of every family by `exact` and by `dormand-prince`, both at the same tolerance.  Each difference of more than
 * 1e-6 is told with what explains it: how much inputs changed by 1e-9 move the number, and whether a finer tolerance takes
 * the one method or the other to the other's number.  usage: pairs [FIRST [COUNT]]: COUNT of each family, from seed FIRST on */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "../unit/scenes.h"

static const unsigned long long family[] = {
    0, SCENES_WIDE, SCENES_YIELDING, SCENES_COLUMNS, SCENES_P_DELTA, SCENES_LINKS, SCENES_MATRICES, SCENES_ISOLATORS,
};
enum { FAMILIES = sizeof family / sizeof *family };

/* Numbers below this share of the largest of their kind are compared with that share. */
static const double least = 1e-2;
/* Both at this tolerance; a difference is looked into from `limit` on. */
static const double tolerance = 1e-9, finer = 1e-12, limit = 1e-6;
/* What a tolerance of 1e-9 of each step may come to over a motion, as a relative change of the inputs. */
static const double change = 1e-7;

static const struct scenes_options exact = {.tolerance = tolerance, .most = 40000},
                                   other = {.method = "dormand-prince", .tolerance = tolerance, .most = 100000},
                                   finer_exact = {.tolerance = finer, .most = 80000},
                                   finer_other = {.method = "dormand-prince", .tolerance = finer, .most = 1000000};

static long made, within, sensitive, of_exact, of_other, stopped, failed, open_ones;

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

static void explain(const struct scenes_one *one, const struct scenes_solution *a, const struct scenes_solution *b,
                    double off, int at)
{
    struct scenes_solution fine, fine_other;
    scenes_run(one, &finer_exact, &fine);
    scenes_run(one, &finer_other, &fine_other);
    double moved = apart(a, &fine), moved_other = apart(b, &fine), left = apart(&fine_other, &fine);
    double factor = fine.status == THUD_OK && !fine.stopped && fine.n == a->n ? amplified(one, &fine, at) : NAN;
    const char *why = "OPEN";
    if (left < limit && moved > limit) {
        why = "exact misses its tolerance";
        of_exact++;
    } else if (factor * change >= off) {
        why = "sensitive";
        sensitive++;
    } else if (left < limit) {
        why = "dormand-prince misses its tolerance";
        of_other++;
    } else {
        open_ones++;
    }
    char text[1000];
    scenes_describe(one, text, sizeof text);
    printf(
        "%llu: %s: %s %d.%d %.12g and %.12g, off by %.2g; a change of 1 in the inputs is one of %.2g; exact moves by "
        "%.2g, dormand-prince by %.2g to the finer one, which are %.2g apart\n#   %s\n",
        one->seed, why, scenes_kind_name(a->number[at].kind), a->number[at].place + 1, a->number[at].index + 1,
        a->number[at].value, b->number[at].value, off, factor, moved, moved_other, left, text);
    scenes_answer_clear(&fine);
    scenes_answer_clear(&fine_other);
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
        failed += both;
        open_ones += !both;
        printf("%llu: %s: %s | %s\n", seed, both ? "no result of either" : "OPEN", a.err.what, b.err.what);
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
    for (long i = 0; i < count; i++) {
        for (int k = 0; k < FAMILIES; k++)
            check(family[k] + first + (unsigned long long)i);
        fflush(stdout);
        if (i % 50 == 49 || i + 1 == count)
            fprintf(stderr,
                    "%ld pairs: %ld within %g, %ld sensitive, %ld of exact, %ld of dormand-prince, %ld too long, %ld "
                    "without "
                    "a result, %ld open\n",
                    made, within, limit, sensitive, of_exact, of_other, stopped, failed, open_ones);
    }
    return open_ones > 0;
}
