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
    bool ratio; /* to case none as it is */
};

static const struct response responses[] = {{"mean acceleration", THUD_SUITE_ACCELERATION_RATIO, true, true},
                                            {"largest acceleration", THUD_SUITE_ACCELERATION, true, false},
                                            {"mean drift", THUD_SUITE_DRIFT_RATIO, true, true},
                                            {"largest drift", THUD_SUITE_DRIFT, true, false},
                                            {"largest ductility", THUD_SUITE_DUCTILITY, true, false},
                                            {"permanent drift", THUD_SUITE_PERMANENT, true, false},
                                            {"shear of columns", THUD_SUITE_COLUMNS, true, false},
                                            {"largest force", THUD_SUITE_FORCE, false, false}};

static void put_cell(const struct thud_suite *suite, long setting, int none, int k, const struct response *of, int s,
                     double *room, struct thud_text *out)
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
    double median = n > 0 ? thud_fractiles_of(room, n, 1).median : NAN;
    char cell[40] = "-";
    if (n > 0 && median < 1 / equal)
        snprintf(cell, sizeof cell, "%.3f %d of %d", median, (int)lowered, (int)n);
    else if (n > 0)
        snprintf(cell, sizeof cell, "from 0 %d of %d", (int)lowered, (int)n);
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

static void put_case(const struct thud_suite *suite, int none, int k, double *room, const long *shown, int nshown,
                     struct thud_text *out)
{
    const struct thud_sweep_plan *plan = suite->plan;
    thud_text_append(out, "\n%s over none: median ratio, and under how many motions it is lower\n%25s",
                     thud_case_name(plan->cases[k]), "");
    for (int i = 0; i < nshown; i++) {
        int at[THUD_VARY_MAX];
        char name[160] = "as it is";
        size_t used = 0;
        thud_suite_place(plan, shown[i], at);
        for (int a = 0; a < plan->naxes && used < sizeof name; a++)
            used += (size_t)snprintf(name + used, sizeof name - used, "%s%s", a ? ", " : "", plan->axis[a].text[at[a]]);
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
    free(room);
    return THUD_OK;
}
