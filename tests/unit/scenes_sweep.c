/* A study of a random scene: with its shortcuts, without them, and as runs of its own. */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scenes_check.h"
#include "study/sweep/sweep.h"

/* The finished point, what it cost left out; NULL where it has none. */
static struct thud_sweep_point *make_point(const struct thud_sweep_plan *plan, const struct thud_sweep_group *group,
                                           long index)
{
    struct thud_sweep_task *task;
    if (thud_sweep_task_create(plan, group, index, &task, NULL) != THUD_OK)
        return NULL;
    for (bool done = false; !done;)
        if (thud_sweep_task_advance(task, 100000, &done, NULL) != THUD_OK)
            break;
    struct thud_sweep_point *point = thud_sweep_task_take(task);
    for (int k = 0; k < point->ncases; k++)
        point->effort[k] = (struct thud_sweep_effort){.status = point->effort[k].status};
    thud_sweep_task_free(task);
    return point;
}

static struct thud_text whole(const struct thud_sweep_plan *plan)
{
    struct thud_text text = {0};
    struct thud_sweep_group *group;
    if (thud_sweep_group_create(plan, 0, &group, NULL) != THUD_OK)
        return text;
    for (bool done = false; !done;)
        if (thud_sweep_group_advance(group, 1000, &done, NULL) != THUD_OK)
            break;
    for (long i = 0; i < thud_sweep_points(plan); i++) {
        struct thud_sweep_point *point = make_point(plan, group, i);
        if (!point)
            continue;
        thud_sweep_point_write(point, &text);
        thud_text_append(&text, "\n");
        free(point);
    }
    thud_sweep_group_free(group);
    return text;
}

/* The number of a word: decimal, or the bits of a double in hexadecimal after an x; NaN where it is none. */
static double number_of(const char *word, size_t length)
{
    char text[32] = "", *end;
    double number;
    if (length >= sizeof text)
        return NAN;
    memcpy(text, word, length);
    if (*text != 'x') {
        number = strtod(text, &end);
        return end > text && *end == '\0' ? number : NAN;
    }
    unsigned long long bits = strtoull(text + 1, &end, 16);
    memcpy(&number, &bits, sizeof number);
    return *end == '\0' ? number : NAN;
}

static bool is_same_word(const char *a, size_t n, const char *b, size_t m)
{
    static const double still = 1e-20; /* what rounding leaves of a motion, or of a force, that is none */
    double x = number_of(a, n), y = number_of(b, m);
    return (n == m && memcmp(a, b, n) == 0) || fabs(x - y) <= still + 1e-9 * (fabs(x) + fabs(y));
}

/* Whether the same words and, but for rounding, the same numbers; what ends a line is its checksum. */
static bool is_same(const char *a, const char *b)
{
    while (a && b && *a && *b) {
        size_t n = strcspn(a, " \n"), m = strcspn(b, " \n");
        if (a[n] != b[m] || (a[n] == ' ' && !is_same_word(a, n, b, m)))
            return false;
        a += a[n] ? n + 1 : n;
        b += b[m] ? m + 1 : m;
    }
    return a && b && *a == *b;
}

bool scenes_sweep_agrees(const struct scenes_one *one, char *what, size_t size)
{
    struct thud_sweep_plan *plan = malloc(sizeof *plan);
    assert(plan);
    thud_sweep_plan_init(plan, &one->scene);
    const struct thud_record *record = one->record;
    plan->record = &record;
    plan->nrecords = record ? 1 : 0;
    bool same = true;
    char axis[200], last[40] = "as-written,none";
    double gap = one->scene.interface[0].gap_m, step = gap < 4 ? 1 : -0.1; /* gaps end at 5 m */
    snprintf(axis, sizeof axis, "interfaces.1.gap=%.17g m,%.17g m,%.17g m", gap,
             gap + step * fmin(0.01 * gap + 1e-3 * one->peak_m, 0.3), gap + step * fmin(2 * gap + one->peak_m, 1));
    struct thud_error err;
    if (thud_sweep_vary(plan, axis, &err) != THUD_OK || thud_sweep_cases(plan, last, &err) != THUD_OK) {
        snprintf(what, size, "no study: %s", err.what);
        same = false;
    } else {
        struct thud_text all = whole(plan), each = {0};
        static const unsigned some[] = {0, THUD_SWEEP_FREE, THUD_SWEEP_START, THUD_SWEEP_LEVELS};
        for (int i = 0; i < 4 && same; i++) {
            plan->shortcuts = some[i];
            each = whole(plan);
            same = is_same(all.data, each.data);
            if (!same)
                snprintf(what, size, "shortcuts %u and all of them differ: %s", some[i],
                         all.data && each.data ? "" : "no points");
            thud_text_clear(&each);
        }
        thud_text_clear(&all);
    }
    thud_sweep_plan_clear(plan);
    free(plan);
    return same;
}
