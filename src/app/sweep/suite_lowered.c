/* Which responses a bumper lowers, and under how many of the ground motions of a suite. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "app/sweep/fragility_report.h"

enum { SHOWN_MAX = 3 };
static const double equal = 1e-9;         /* ratios nearer to 1 are neither lower nor higher */
static const double from_nothing = 1e100; /* the ratio to 0: larger than any other, and still a number */

struct response {
    const char *what;
    enum thud_suite_measure measure;
    bool of_structure;
    bool ratio; /* to case none, nominal */
};

static const struct response responses[] = {{"mean acceleration", THUD_SUITE_ACCELERATION_RATIO, true, true},
                                            {"largest acceleration", THUD_SUITE_ACCELERATION, true, false},
                                            {"mean drift", THUD_SUITE_DRIFT_RATIO, true, true},
                                            {"largest drift", THUD_SUITE_DRIFT, true, false},
                                            {"largest ductility", THUD_SUITE_DUCTILITY, true, false},
                                            {"permanent drift", THUD_SUITE_PERMANENT, true, false},
                                            {"shear of columns", THUD_SUITE_COLUMNS, true, false},
                                            {"largest force", THUD_SUITE_FORCE, false, false}};

/* The median of a response over that of case none, of how many ground motions, and under how many it is lower. */
struct lowered {
    double median;
    int lower, n;
};

static struct lowered ratio_of(const struct thud_suite *suite, long setting, int none, int k, const struct response *of,
                               int s, double *room)
{
    size_t n = 0, lowered = 0;
    for (int r = 0; r < suite->nrecords; r++) {
        double with = thud_suite_value(suite, r, setting, k, of->measure, s),
               without = of->ratio ? 1 : thud_suite_value(suite, r, setting, none, of->measure, s);
        if (isnan(with) || isnan(without) || !(with > 0 || without > 0))
            continue;
        room[n++] = without > 0 ? with / without : from_nothing;
        lowered += room[n - 1] < 1 - equal;
    }
    return (struct lowered){n > 0 ? thud_fractiles_of(room, n, 1).median : NAN, (int)lowered, (int)n};
}

static void put_cell(const struct thud_suite *suite, long setting, int none, int k, const struct response *of, int s,
                     double *room, struct thud_text *out)
{
    const struct lowered r = ratio_of(suite, setting, none, k, of, s, room);
    char cell[40] = "-";
    if (r.n > 0 && r.median < 1 / equal)
        snprintf(cell, sizeof cell, "%.3f %d of %d", r.median, r.lower, r.n);
    else if (r.n > 0)
        snprintf(cell, sizeof cell, "from 0 %d of %d", r.lower, r.n);
    thud_text_append(out, " %17s", cell);
}

static void put_row(const struct thud_suite *suite, int none, int k, const struct response *of, int s, double *room,
                    const long *shown, int nshown, struct thud_text *out)
{
    char name[64];
    snprintf(name, sizeof name, "%s%s%.16s", of->what, s < 0 ? "" : " of ",
             s < 0 ? "" : suite->plan->scene.structure[s].name);
    thud_text_append(out, "%-25.25s", name);
    for (int i = 0; i < nshown; i++)
        put_cell(suite, shown[i], none, k, of, s, room, out);
    thud_text_append(out, "\n");
}

static void name_setting(const struct thud_sweep_plan *plan, long setting, char *name, size_t size)
{
    int at[THUD_VARY_MAX];
    size_t used = 0;
    snprintf(name, size, "nominal");
    thud_suite_place(plan, setting, at);
    for (int a = 0; a < plan->naxes && used < size; a++)
        used += (size_t)snprintf(name + used, size - used, "%s%s", a ? ", " : "", plan->axis[a].text[at[a]]);
}

/* "mean drift of A: link at 0 MN/m, 0.789 in the median, lower under 8 of 8 motions" */
static void put_best(const struct thud_suite *suite, int none, const struct response *of, int s, double *room,
                     const long *shown, int nshown, struct thud_text *out)
{
    const struct thud_sweep_plan *plan = suite->plan;
    struct lowered best = {INFINITY, 0, 0};
    long where = 0;
    int which = -1;
    for (int k = 0; k < plan->ncases; k++)
        for (int i = 0; i < nshown && k != none; i++) {
            const struct lowered r = ratio_of(suite, shown[i], none, k, of, s, room);
            if (!(r.n > 0 && r.median < best.median))
                continue;
            best = r;
            which = k;
            where = shown[i];
        }
    char name[160];
    if (which < 0)
        return;
    name_setting(plan, where, name, sizeof name);
    thud_text_append(out, "  %s%s%.16s: ", of->what, s < 0 ? "" : " of ", s < 0 ? "" : plan->scene.structure[s].name);
    if (best.median < 1 - equal)
        thud_text_append(out, "%s at %s, %.3f in the median, lower under %d of %d motions\n",
                         thud_case_name(plan->cases[which]), name, best.median, best.lower, best.n);
    else
        thud_text_append(out, "none of them lowers it in the median\n");
}

/* Which of bumper and links lowers what most. */
static void put_bests(const struct thud_suite *suite, int none, double *room, const long *shown, int nshown,
                      struct thud_text *out)
{
    thud_text_append(out, "\nWhat lowers each response most:\n");
    for (size_t q = 0; q < sizeof responses / sizeof *responses; q++) {
        const bool each = responses[q].of_structure;
        for (int s = each ? 0 : -1; thud_suite_has(suite, responses[q].measure) && s < (each ? suite->nstructures : 0);
             s++)
            if (s < 0 || suite->plan->scene.structure[s].kind != THUD_WALL)
                put_best(suite, none, &responses[q], s, room, shown, nshown, out);
    }
}

static void put_case(const struct thud_suite *suite, int none, int k, double *room, const long *shown, int nshown,
                     struct thud_text *out)
{
    const struct thud_sweep_plan *plan = suite->plan;
    thud_text_append(out, "\n%s over none: median ratio, and under how many motions it is lower\n%25s",
                     thud_case_name(plan->cases[k]), "");
    for (int i = 0; i < nshown; i++) {
        char name[160];
        name_setting(plan, shown[i], name, sizeof name);
        thud_text_append(out, " %17.17s", name);
    }
    thud_text_append(out, "\n");
    for (size_t q = 0; q < sizeof responses / sizeof *responses; q++) {
        if (!thud_suite_has(suite, responses[q].measure))
            continue;
        for (int s = responses[q].of_structure ? 0 : -1; s < (responses[q].of_structure ? suite->nstructures : 0); s++)
            if (s < 0 || plan->scene.structure[s].kind != THUD_WALL)
                put_row(suite, none, k, &responses[q], s, room, shown, nshown, out);
    }
}

enum thud_status thud_suite_lowered(const struct thud_suite *suite, struct thud_text *out, struct thud_error *err)
{
    const struct thud_sweep_plan *plan = suite->plan;
    double *room = malloc((size_t)suite->nrecords * sizeof *room);
    long shown[SHOWN_MAX];
    int none = -1, nshown = suite->settings < SHOWN_MAX ? (int)suite->settings : SHOWN_MAX;
    if (!room)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < nshown; i++) /* the first, the middle, the last */
        shown[i] = nshown > 1 ? i * (suite->settings - 1) / (nshown - 1) : 0;
    for (int k = 0; k < plan->ncases; k++)
        none = plan->cases[k] == THUD_CASE_NONE ? k : none;
    for (int k = 0; none >= 0 && k < plan->ncases; k++)
        if (k != none)
            put_case(suite, none, k, room, shown, nshown, out);
    for (int k = 0; none >= 0 && k < plan->ncases; k++)
        if (plan->cases[k] == THUD_CASE_LINK)
            put_bests(suite, none, room, shown, nshown, out);
    free(room);
    return THUD_OK;
}
