#include <math.h>
#include <stdio.h>

#include "plot/figures/figures_sweep_internal.h"

/* ---- the list: per case with a ratio (by floor or as map per record, then the means), then the contacts per record
 * ---- */

/* Whether ratios of the scene as written are to something else than itself. */
static bool has_ratios(const struct thud_sweep_table *table)
{
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        const struct thud_sweep_ratio *x;
        int k = thud_sweep_summary_find(d, THUD_CASE_AS_WRITTEN);
        for (int s = 0; k >= 0 && s < table->nstructures; s++)
            for (int f = 0; (x = thud_sweep_summary_ratio(d, k, s, f, THUD_SWEEP_VALUE)) != NULL; f++)
                if (isfinite(x->acceleration) && x->acceleration != 1)
                    return true;
    }
    return false;
}

static bool has_yielding(const struct thud_sweep_table *table)
{
    for (int s = 0; s < table->nstructures; s++)
        if (thud_sweep_is_told(table, THUD_TOLD_DUCTILITY, s))
            return true;
    return false;
}

static bool has_contacts(const struct thud_sweep_table *table)
{
    for (size_t i = 0; i < table->npoints; i++)
        if (table->point[i]->has_contact)
            return true;
    return false;
}

/* Cases that are compared to `none`, which need not be among them; returns how many. */
static int compared(const struct thud_sweep_table *table, enum thud_case *which)
{
    int n = 0;
    for (int c = THUD_CASE_AS_WRITTEN; c < THUD_CASES; c++) {
        bool to_none = c > THUD_CASE_NONE || (c == THUD_CASE_AS_WRITTEN && has_ratios(table));
        if (to_none && thud_sweep_has_case(table, (enum thud_case)c))
            which[n++] = (enum thud_case)c;
    }
    return n;
}

/* Cases of a study whose figures are amplifications; `none`, over no pounding, where there is no other. */
static int shown_cases(const struct thud_sweep_table *table, enum thud_case *which)
{
    int n = compared(table, which);
    if (n == 0 && thud_sweep_has_case(table, THUD_CASE_NONE))
        which[n++] = THUD_CASE_NONE;
    return n;
}

/* Settings of the keys past the two of a map; `at` gets number i of them. */
static int slices(const struct thud_sweep_table *table, int i, int at[THUD_VARY_MAX])
{
    int n = 1;
    for (int a = table->naxes - 1; a >= 2; a--) {
        at[a] = i / n % table->axis[a].n;
        n *= table->axis[a].n;
    }
    return n;
}

enum { MAPS_MOST = 24 };

/* What a study's figures are: `each` of every case and record, means of every case (before those where there are
 * several records), then `last` of every record. */
enum last { CONTACT_FORCES, POUNDING, YIELDING, STRUCK_COLUMNS, LAST };
struct list {
    int ncases, slices, each, means, last;
    enum last of_record[LAST]; /* (last) */
    enum thud_case which[THUD_CASES + 1];
};

static struct list list_of(const struct thud_sweep_table *table)
{
    struct list l = {0};
    int at[THUD_VARY_MAX];
    int settings = 1;
    for (int a = 0; a < table->naxes; a++)
        settings *= table->axis[a].n;
    if (settings == 1 || table->nrows == 0) /* one setting has no curve */
        return l;
    bool one = table->naxes == 1;
    l.ncases = shown_cases(table, l.which);
    l.slices = one ? 1 : slices(table, 0, at);
    if (l.slices > MAPS_MOST)
        l.slices = MAPS_MOST;
    l.each = table->nrecords * l.slices;
    l.means = one && !(l.ncases == 1 && l.which[0] == THUD_CASE_NONE);
    if (one && has_contacts(table)) {
        l.of_record[l.last++] = CONTACT_FORCES;
        l.of_record[l.last++] = POUNDING;
    }
    if (one && has_yielding(table))
        l.of_record[l.last++] = YIELDING;
    if (one && thud_sweep_is_told(table, THUD_TOLD_SHEAR, 0))
        l.of_record[l.last++] = STRUCK_COLUMNS;
    return l;
}

int thud_sweep_figure_count(const struct thud_sweep_table *table)
{
    struct list l = list_of(table);
    return l.ncases * (l.each + l.means) + l.last * table->nrecords;
}

/* Tells figures of one motion of several what it is. */
static struct thud_figure *of_motion(struct thud_figure *figure, const struct thud_sweep_table *table, int record)
{
    if (figure && table->nrecords > 1 && table->motion && table->motion[record])
        figure->motion = table->motion[record]->synthetic ? THUD_MOTION_SYNTHETIC : THUD_MOTION_RECORDED;
    return figure;
}

struct thud_figure *thud_sweep_figure(const struct thud_sweep_table *table, int index)
{
    struct list l = list_of(table);
    int per_case = l.each + l.means, c = per_case > 0 ? index / per_case : 0, at[THUD_VARY_MAX] = {0};
    char name[128], number[24] = "", slice[24] = "";
    if (per_case == 0 || c >= l.ncases) {
        static const struct {
            const char *name;
            struct thud_figure *(*make)(const struct thud_sweep_table *table, int record, const char *name);
        } figures[LAST] = {[CONTACT_FORCES] = {"contact-forces", thud_figure_of_contacts},
                           [POUNDING] = {"pounding", thud_figure_of_pounding},
                           [YIELDING] = {"yielding", thud_figure_of_yielding},
                           [STRUCK_COLUMNS] = {"struck-columns", thud_figure_of_struck_columns}};
        int rest = index - l.ncases * per_case, record = rest / l.last;
        enum last which = l.of_record[rest % l.last];
        if (table->nrecords > 1)
            snprintf(number, sizeof number, "-%d", record + 1);
        snprintf(name, sizeof name, "%s%s", figures[which].name, number);
        return of_motion(figures[which].make(table, record, name), table, record);
    }
    int i = index % per_case;
    bool first = l.means && table->nrecords > 1; /* what several motions say together comes before each of them */
    if (l.means && i == (first ? 0 : l.each)) {
        snprintf(name, sizeof name, "means-%s", thud_case_name(l.which[c]));
        return thud_figure_of_means(table, l.which[c], name, NULL);
    }
    i -= first;
    int record = i / l.slices;
    if (table->nrecords > 1)
        snprintf(number, sizeof number, "-%d", record + 1);
    if (l.slices > 1)
        snprintf(slice, sizeof slice, "-at%d", i % l.slices + 1);
    if (table->naxes > 1)
        slices(table, i % l.slices, at);
    snprintf(name, sizeof name, "%s-%s%s%s", table->naxes == 1 ? "floors" : "map", thud_case_name(l.which[c]), number,
             slice);
    return of_motion(table->naxes == 1 ? thud_figure_by_floor(table, record, l.which[c], name, NULL)
                                       : thud_figure_of_map(table, record, l.which[c], at, name),
                     table, record);
}
