/* What the paper says in words: each statement with its criterion, the numbers found here for the motions as given and
 * reversed, and whether they bear it out. */
#include "lab/paper/paper_report.h"

#include <math.h>
#include <stdio.h>

enum { TEXT = 400 };
enum verdict { NO, PARTLY, YES };
static const double change = THUD_PAPER_CHANGE;
static const double narrow_m = 0.1; /* "relatively narrow gap sizes" */

/* One sign of the motions. */
struct view {
    const struct thud_paper_study *study;
    const struct thud_sweep_table *table;
    const struct thud_paper_runs *runs;
    double strained_m; /* what the bumper's ultimate strain leaves of it to be pressed */
};

static enum verdict judge(bool yes, bool partly)
{
    return yes ? YES : partly ? PARTLY : NO;
}

/* ---- the tables ---- */

static const struct thud_sweep_summary *point(const struct thud_sweep_table *table, size_t i, int record)
{
    const struct thud_sweep_summary *d = table->point[i];
    return record < 0 || d->record == record ? d : NULL;
}

/* Of a floor, 0: of the mean over them; NULL where the case has no result. */
static const struct thud_sweep_ratio *ratio_of(const struct thud_sweep_summary *d, enum thud_case which, int structure,
                                               int floor)
{
    int k = d ? thud_sweep_summary_find(d, which) : -1;
    return k >= 0 ? thud_sweep_summary_ratio(d, k, structure, floor, THUD_SWEEP_VALUE) : NULL;
}

static double part(const struct thud_sweep_ratio *x, int quantity)
{
    return !x ? NAN : quantity ? x->drift : x->acceleration;
}

/* Over the motion without pounding. */
static double part_free(const struct thud_sweep_ratio *x, int quantity)
{
    return !x ? NAN : quantity ? x->drift_free : x->acceleration_free;
}

/* Of a case; NaN: it has no result. */
static double value_of(const struct thud_sweep_summary *d, enum thud_case which, enum thud_measure measure)
{
    int k = d ? thud_sweep_summary_find(d, which) : -1;
    return k >= 0 ? thud_sweep_summary_value(d, k, measure, -1, THUD_SWEEP_VALUE) : NAN;
}

static bool pounds(const struct thud_sweep_summary *d, enum thud_case which)
{
    return value_of(d, which, THUD_MEASURE_FORCE) > 0;
}

/* How many values are changed, and to which side. */
struct count {
    int above, below, n;
    double least, most;
};

static void add(struct count *c, double ratio)
{
    if (isnan(ratio))
        return;
    c->least = c->n > 0 ? fmin(c->least, ratio) : ratio;
    c->most = c->n > 0 ? fmax(c->most, ratio) : ratio;
    c->n++;
    c->above += ratio > 1 + change;
    c->below += ratio < 1 - change;
}

static double share_above(const struct count *c)
{
    return c->above + c->below > 0 ? (double)c->above / (c->above + c->below) : 0;
}

/* Means over the floors with the bumper over those without, all motions and gaps, of one building or (-1) both and of
 * one quantity or (-1) both. */
static struct count means(const struct view *v, int building, int quantity, double widest_m)
{
    struct count c = {0};
    for (size_t i = 0; i < v->table->npoints; i++)
        for (int s = 0; s < 2; s++)
            for (int q = 0; q < 2; q++)
                if ((building < 0 || s == building) && (quantity < 0 || q == quantity) &&
                    v->table->point[i]->gap_m <= widest_m + 1e-9)
                    add(&c, part(ratio_of(v->table->point[i], THUD_CASE_BUMPER, s, 0), q));
    return c;
}

/* ---- two bodies ---- */

static enum verdict indentation(const struct view *v, char *text)
{
    const struct thud_paper_pair *p = v->study->pair;
    snprintf(text, TEXT, "%.1f mm for %.2f at 0.5 m/s, %.1f mm for %.2f at 1.0 m/s", 1e3 * p[1].indentation_m,
             1e3 * p[0].indentation_m, 1e3 * p[3].indentation_m, 1e3 * p[2].indentation_m);
    return judge(p[1].indentation_m > 2 * p[0].indentation_m && p[3].indentation_m > 2 * p[2].indentation_m, false);
}

static enum verdict past_strain(const struct view *v, char *text)
{
    const struct thud_paper_pair *p = v->study->pair;
    snprintf(text, TEXT, "%.1f mm of %.0f; %.1f MN for %.1f MN at 0.5 m/s, %.1f times as much",
             1e3 * p[3].indentation_m, 1e3 * v->strained_m, 1e-6 * p[3].force_n, 1e-6 * p[1].force_n,
             p[3].force_n / p[1].force_n);
    bool past = p[3].indentation_m > v->strained_m;
    return judge(past && p[3].force_n > 2 * p[1].force_n, past);
}

static enum verdict softer(const struct view *v, char *text)
{
    const struct thud_paper_pair *p = v->study->pair;
    snprintf(text, TEXT,
             "%.0f ms for %.0f and %.2f MN for %.2f at 0.5 m/s; %.0f ms for %.0f and %.2f MN for %.2f at 1.0 m/s",
             1e3 * p[1].duration_s, 1e3 * p[0].duration_s, 1e-6 * p[1].force_n, 1e-6 * p[0].force_n,
             1e3 * p[3].duration_s, 1e3 * p[2].duration_s, 1e-6 * p[3].force_n, 1e-6 * p[2].force_n);
    bool slow = p[1].duration_s > p[0].duration_s && p[1].force_n < p[0].force_n;
    bool fast = p[3].duration_s > p[2].duration_s && p[3].force_n < p[2].force_n;
    return judge(slow && fast, slow || fast);
}

static enum verdict restitution(const struct view *v, char *text)
{
    const struct thud_paper_pair *p = v->study->pair;
    int close = 0;
    for (int i = 0; i < THUD_PAPER_PAIRS; i++)
        close += fabs(p[i].restitution - p[i].nominal) < 0.01 * p[i].nominal;
    snprintf(text, TEXT, "concrete %.3f for %.1f; rubber %.3f at 0.5 m/s and %.3f at 1.0 m/s for %.1f",
             p[0].restitution, p[0].nominal, p[1].restitution, p[3].restitution, p[1].nominal);
    return judge(close == THUD_PAPER_PAIRS, close > 0);
}

static enum verdict figure3(const struct view *v, char *text)
{
    const struct thud_paper_pair *c = v->study->pair + THUD_PAPER_PAIRS;
    bool past = true, one_curve = true, close = true;
    for (int i = 0; i < THUD_PAPER_FIG3; i++) {
        past = past && c[i].indentation_m > v->strained_m;
        one_curve = one_curve && fabs(c[i].force_n / c[0].force_n - 1) < 1e-6;
        close = close && fabs(c[i].restitution - c[i].nominal) < 0.01 * c[i].nominal;
    }
    snprintf(text, TEXT, "%.1f mm and %.1f MN for all three; %.3f, %.3f and %.3f for %.1f, %.1f and %.1f",
             1e3 * c[0].indentation_m, 1e-6 * c[0].force_n, c[0].restitution, c[1].restitution, c[2].restitution,
             c[0].nominal, c[1].nominal, c[2].nominal);
    return judge(past && one_curve && close, past && one_curve);
}

/* A linear spring gives forces in proportion to the speed. */
static enum verdict linear_rubber(const struct view *v, char *text)
{
    const struct thud_paper_pair *p = v->study->pair;
    const struct thud_paper_pair *slow = &p[THUD_PAPER_SLOW];
    double linear[2] = {p[1].force_n * slow->approach_mps / p[1].approach_mps,
                        p[1].force_n * p[3].approach_mps / p[1].approach_mps};
    double off[2] = {fabs(linear[0] / slow->force_n - 1), fabs(linear[1] / p[3].force_n - 1)};
    snprintf(text, TEXT, "%.2f MN for the rubber's %.2f at 0.25 m/s, %.2f MN for %.2f at 1.0 m/s", 1e-6 * linear[0],
             1e-6 * slow->force_n, 1e-6 * linear[1], 1e-6 * p[3].force_n);
    return judge(off[0] > 0.1 && off[1] > 0.1, off[0] > 0.1 || off[1] > 0.1);
}

/* Eq. (6): alpha A K_r/d^n, of which the paper gives alpha, d and n. */
static enum verdict equation6(const struct view *v, char *text)
{
    double thickness_mm = 1e3 * v->study->scene->interface[0].bumper_thickness_m;
    double product_kn = 0.36 * pow(thickness_mm, 2.65);
    snprintf(text, TEXT,
             "A K_r is %.0f to %.0f kN for alpha 2.5 to 2, such as 1 m2 of %.1f MPa; neither A nor K_r is given",
             product_kn / 2.5, product_kn / 2, 1e-3 * product_kn / 2);
    return PARTLY;
}

/* ---- the towers ---- */

static enum verdict widened(const struct view *v, char *text)
{
    const struct thud_paper_spike *x = &v->runs->spike[1];
    snprintf(text, TEXT, "%d of %d contacts with impacts, by up to %.2f mm", x->widened, x->struck,
             1e3 * x->residual_m);
    return judge(x->struck > 0 && x->widened == x->struck, x->widened > 0);
}

static enum verdict spikes(const struct view *v, char *text)
{
    const struct thud_paper_spike *x = v->runs->spike;
    double least = fmin(fmin(x[0].acceleration_mps2, x[1].acceleration_mps2), x[2].acceleration_mps2);
    double most = fmax(fmax(x[0].acceleration_mps2, x[1].acceleration_mps2), x[2].acceleration_mps2);
    snprintf(text, TEXT,
             "%.0f, %.0f and %.0f m/s2 with 625, 2500 and 10000 kN/mm, %.0f without pounding; the strongest impact "
             "lasts %.0f, %.0f and %.0f ms",
             x[0].acceleration_mps2, x[1].acceleration_mps2, x[2].acceleration_mps2, x[1].free_mps2,
             1e3 * x[0].duration_s, 1e3 * x[1].duration_s, 1e3 * x[2].duration_s);
    bool high = least > 2 * x[1].free_mps2, affected = most > 1.1 * least;
    return judge(high && affected, high || affected);
}

/* Where mean response over no pounding is above 1.1, of the motions that pound. */
static enum verdict amplified(const struct view *v, char *text)
{
    struct count q[2] = {{0}};
    int both = 0, motions = 0;
    for (int r = 0; r < v->table->nrecords; r++) {
        bool found = false, any = false;
        for (size_t i = 0; i < v->table->npoints; i++) {
            const struct thud_sweep_summary *d = point(v->table, i, r);
            if (!pounds(d, THUD_CASE_NONE))
                continue;
            any = true;
            for (int s = 0; s < 2; s++) {
                const struct thud_sweep_ratio *x = ratio_of(d, THUD_CASE_NONE, s, 0);
                add(&q[0], part_free(x, 0));
                add(&q[1], part_free(x, 1));
                found = found || (part_free(x, 0) > 1.1 && part_free(x, 1) > 1.1);
            }
        }
        motions += any;
        both += found;
    }
    snprintf(text, TEXT, "%d of %d motions; mean accelerations %.2f to %.2f times, mean drifts %.2f to %.2f times",
             both, motions, q[0].least, q[0].most, q[1].least, q[1].most);
    return judge(motions > 0 && both == motions, both > 0);
}

static enum verdict bumper_above_free(const struct view *v, char *text)
{
    int above[2] = {0}, n[2] = {0}, lower = 0;
    for (size_t i = 0; i < v->table->npoints; i++)
        for (int s = 0; s < 2; s++)
            for (int q = 0; q < 2; q++) {
                const struct thud_sweep_summary *d = v->table->point[i];
                double x = part_free(ratio_of(d, THUD_CASE_BUMPER, s, 0), q);
                if (!pounds(d, THUD_CASE_BUMPER) || isnan(x))
                    continue;
                n[q]++;
                above[q] += x >= 1 - change;
                lower += pounds(d, THUD_CASE_NONE) && part(ratio_of(d, THUD_CASE_BUMPER, s, 0), q) < 1 - change;
            }
    snprintf(text, TEXT, "accelerations %d of %d, drifts %d of %d; lower than with bare pounding %d times", above[0],
             n[0], above[1], n[1], lower);
    bool all = above[0] + above[1] == n[0] + n[1];
    return judge(all && lower > 0, 2 * (above[0] + above[1]) > n[0] + n[1]);
}

static enum verdict strained(const struct view *v, char *text)
{
    int struck = 0, past = 0;
    double most = 0;
    for (size_t i = 0; i < v->table->npoints; i++) {
        const double pressed_m = value_of(v->table->point[i], THUD_CASE_BUMPER, THUD_MEASURE_INDENTATION);
        if (!pounds(v->table->point[i], THUD_CASE_BUMPER))
            continue;
        struck++;
        past += pressed_m > v->strained_m;
        most = fmax(most, pressed_m);
    }
    snprintf(text, TEXT, "%d of %d runs that strike it, by up to %.1f mm", past, struck,
             1e3 * fmax(0, most - v->strained_m));
    return judge(past > 0, false);
}

/* Acceleration ratios of a floor of a building under the first motion. */
static struct count of_floor(const struct view *v, int building, int floor, double *gap_m)
{
    struct count c = {0};
    for (size_t i = 0; i < v->table->npoints; i++) {
        const struct thud_sweep_summary *d = point(v->table, i, 0);
        double x = part(ratio_of(d, THUD_CASE_BUMPER, building, floor), 0);
        if (gap_m && !isnan(x) && (c.n == 0 || x > c.most))
            *gap_m = d->gap_m;
        add(&c, x);
    }
    return c;
}

static enum verdict floor4_falls(const struct view *v, char *text)
{
    struct count c = of_floor(v, 0, 4, NULL);
    snprintf(text, TEXT, "%d of %d gaps below 1, %d above", c.below, c.n, c.above);
    return judge(c.above <= 0.1 * (c.above + c.below), c.below > c.above);
}

static enum verdict floor2_rises(const struct view *v, char *text)
{
    double gap_m = NAN;
    struct count c = of_floor(v, 1, 2, &gap_m);
    snprintf(text, TEXT, "by %.0f %% at %.4g cm; floors 1, 3 and 4 by %.0f, %.0f and %.0f %%", 100 * (c.most - 1),
             100 * gap_m, 100 * (of_floor(v, 1, 1, NULL).most - 1), 100 * (of_floor(v, 1, 3, NULL).most - 1),
             100 * (of_floor(v, 1, 4, NULL).most - 1));
    return judge(c.most > 1.25 && c.most<1.35, c.most> 1.1);
}

static enum verdict at_once(const struct view *v, char *text)
{
    int falls = 0, both = 0;
    double most = 1;
    for (size_t i = 0; i < v->table->npoints; i++) {
        const struct thud_sweep_summary *d = point(v->table, i, 0);
        double a = part(ratio_of(d, THUD_CASE_BUMPER, 0, 4), 0), b = part(ratio_of(d, THUD_CASE_BUMPER, 1, 2), 0);
        if (!(a < 1 - change))
            continue;
        falls++;
        both += b > 1 + change;
        most = fmax(most, b);
    }
    snprintf(text, TEXT, "at %d of the %d gaps at which floor 4 falls; floor 2 by up to %.0f %% there", both, falls,
             100 * (most - 1));
    return judge(2 * both > falls, both > 0);
}

static enum verdict opposed(const struct view *v, char *text)
{
    int n = 0, found = 0;
    for (size_t i = 0; i < v->table->npoints; i++) {
        const struct thud_sweep_summary *d = point(v->table, i, 0);
        const struct thud_sweep_ratio *x;
        bool any = false;
        if (!ratio_of(d, THUD_CASE_BUMPER, 0, 0))
            continue;
        for (int s = 0; s < 2; s++)
            for (int floor = 1; (x = ratio_of(d, THUD_CASE_BUMPER, s, floor)) != NULL; floor++)
                any = any || (x->acceleration > 1 + change && x->drift < 1 - change);
        n++;
        found += any;
    }
    snprintf(text, TEXT, "at %d of %d gaps", found, n);
    return judge(found > 0, false);
}

static enum verdict sensitive(const struct view *v, char *text)
{
    struct count c[2] = {{0}};
    for (size_t i = 0; i < v->table->npoints; i++) {
        const struct thud_sweep_summary *d = point(v->table, i, 0);
        const struct thud_sweep_ratio *x;
        for (int s = 0; d && s < 2; s++)
            for (int floor = 1; (x = ratio_of(d, THUD_CASE_BUMPER, s, floor)) != NULL; floor++)
                for (int q = 0; q < 2; q++)
                    add(&c[q], part(x, q));
    }
    snprintf(text, TEXT, "accelerations %.2f to %.2f, drifts %.2f to %.2f", c[0].least, c[0].most, c[1].least,
             c[1].most);
    return judge(c[0].most - c[0].least > c[1].most - c[1].least, false);
}

static enum verdict mostly_amplified(const struct view *v, char *text)
{
    struct count c = means(v, -1, -1, INFINITY);
    snprintf(text, TEXT, "of %d means that the bumper changes %d (%.0f %%)", c.above + c.below, c.above,
             100 * share_above(&c));
    return judge(share_above(&c) > 0.5, false);
}

static enum verdict six_storeys(const struct view *v, char *text)
{
    struct count a = means(v, 0, -1, INFINITY), b = means(v, 1, -1, INFINITY);
    snprintf(text, TEXT, "6-storey: %d of %d (%.0f %%); 4-storey: %d of %d (%.0f %%)", b.above, b.above + b.below,
             100 * share_above(&b), a.above, a.above + a.below, 100 * share_above(&a));
    return judge(share_above(&b) > 0.5 && share_above(&b) > share_above(&a), share_above(&b) > share_above(&a));
}

static enum verdict narrow(const struct view *v, char *text)
{
    struct count c = means(v, -1, 0, narrow_m);
    snprintf(text, TEXT, "%d of %d mean accelerations", c.below, c.n);
    return judge(c.below > 0, false);
}

/* Values of the mean acceleration ratio at one gap: whether some fall and others rise. */
static bool parted(const struct count *c)
{
    return c->above > 0 && c->below > 0;
}

static enum verdict character(const struct view *v, char *text)
{
    int n = 0, differ = 0;
    double spread = 0, gap_m = NAN;
    for (size_t i = 0; i < v->table->npoints; i++) {
        const struct thud_sweep_summary *first = point(v->table, i, 0);
        for (int s = 0; first && s < 2; s++) {
            struct count c = {0};
            for (size_t k = 0; k < v->table->npoints; k++)
                if (v->table->point[k]->at[0] == first->at[0])
                    add(&c, part(ratio_of(v->table->point[k], THUD_CASE_BUMPER, s, 0), 0));
            n += c.n > 1;
            differ += parted(&c);
            if (c.n > 1 && c.most - c.least > spread) {
                spread = c.most - c.least;
                gap_m = first->gap_m;
            }
        }
    }
    snprintf(text, TEXT, "one rises while another falls at %d of %d; at %.4g cm they are %.2f apart", differ, n,
             100 * gap_m, spread);
    return judge(2 * differ > n, differ > 0 || spread > 0.1);
}

static enum verdict storeys(const struct view *v, char *text)
{
    const struct thud_sweep_table *t = &v->runs->storeys.table;
    int n = 0, differ = 0;
    double spread = 0, gap_m = NAN;
    for (size_t i = 0; i < t->npoints; i++) {
        struct count c = {0};
        if (t->point[i]->at[0] != 0)
            continue;
        for (size_t k = 0; k < t->npoints; k++)
            if (t->point[k]->at[1] == t->point[i]->at[1])
                add(&c, part(ratio_of(t->point[k], THUD_CASE_BUMPER, 0, 0), 0));
        n++;
        differ += parted(&c);
        if (c.most - c.least > spread) {
            spread = c.most - c.least;
            gap_m = t->point[i]->gap_m;
        }
    }
    snprintf(text, TEXT, "one rises while another falls at %d of %d gaps; at %.4g cm they are %.2f apart", differ, n,
             100 * gap_m, spread);
    return judge(2 * differ > n, differ > 0 || spread > 0.1);
}

static enum verdict ratio_of_means(const struct view *v, char *text)
{
    int n = 0, same = 0;
    double most = 0;
    for (size_t i = 0; i < v->table->npoints; i++)
        for (int s = 0; s < 2; s++)
            for (int q = 0; q < 2; q++) {
                const struct thud_sweep_summary *d = v->table->point[i];
                const struct thud_sweep_ratio *x;
                double mean = part(ratio_of(d, THUD_CASE_BUMPER, s, 0), q), sum = 0;
                int floors = 0;
                for (; (x = ratio_of(d, THUD_CASE_BUMPER, s, floors + 1)) != NULL; floors++)
                    sum += part(x, q);
                double other = sum / floors;
                if (isnan(mean) || isnan(other) || (fabs(mean - 1) <= change && fabs(other - 1) <= change))
                    continue;
                n++;
                same += (mean > 1) == (other > 1);
                most = fmax(most, fabs(mean - other));
            }
    snprintf(text, TEXT, "%d of %d (%.0f %%); they differ by up to %.3f", same, n, n > 0 ? 100.0 * same / n : 0.0,
             most);
    return judge(same >= 0.95 * n, same >= 0.75 * n);
}

/* The widest gap at which a case still has contact, under a motion; the widest of the study says nothing. */
static double widest_contact(const struct view *v, int record, enum thud_case which)
{
    double widest = NAN, end = 0;
    for (size_t i = 0; i < v->table->npoints; i++) {
        const struct thud_sweep_summary *d = point(v->table, i, record);
        if (pounds(d, which))
            widest = fmax(widest, d->gap_m);
        end = d ? fmax(end, d->gap_m) : end;
    }
    return widest < end ? widest : NAN;
}

static enum verdict usable(const struct view *v, char *text)
{
    int full = 0, struck = 0, motions = 0, spared = 0;
    const struct thud_interface *at = &v->study->scene->interface[0];
    double saves_m = at->bumper_thickness_m - v->strained_m, saved_m = NAN;
    for (int r = 0; r < v->table->nrecords; r++) {
        double flush_m = widest_contact(v, r, THUD_CASE_BUMPER), cavity_m = widest_contact(v, r, THUD_CASE_CAVITY);
        if (isnan(flush_m) || isnan(cavity_m))
            continue;
        saved_m = flush_m - cavity_m;
        motions++;
        spared += fabs(saved_m - saves_m) < 1e-6;
    }
    for (size_t i = 0; i < v->table->npoints; i++) {
        const bool contact = pounds(v->table->point[i], THUD_CASE_CAVITY);
        struck += contact;
        full += contact && value_of(v->table->point[i], THUD_CASE_CAVITY, THUD_MEASURE_INDENTATION) >= v->strained_m;
    }
    snprintf(text, TEXT,
             "it is struck at gaps up to %.2g cm narrower under %d of %d motions; %.0f mm are used in %d of %d studies "
             "with contact",
             100 * saved_m, spared, motions, 1e3 * v->strained_m, full, struck);
    return judge(motions > 0 && spared == motions && full > 0, full > 0 || spared > 0);
}

static enum verdict cavity(const struct view *v, char *text)
{
    double sum[2] = {0};
    int n[2] = {0}, lower = 0, compared = 0;
    for (size_t i = 0; i < v->table->npoints; i++)
        for (int s = 0; s < 2; s++)
            for (int q = 0; q < 2; q++) {
                double x[2] = {part(ratio_of(v->table->point[i], THUD_CASE_BUMPER, s, 0), q),
                               part(ratio_of(v->table->point[i], THUD_CASE_CAVITY, s, 0), q)};
                for (int k = 0; k < 2; k++)
                    if (!isnan(x[k])) {
                        sum[k] += x[k];
                        n[k]++;
                    }
                if (fabs(x[0] - 1) > change && fabs(x[1] - 1) > change) {
                    compared++;
                    lower += x[1] < x[0];
                }
            }
    double flush = sum[0] / n[0], deep = sum[1] / n[1];
    snprintf(text, TEXT, "mean of all ratios %.3f on the wall, %.3f in the cavity; lower at %d of %d", flush, deep,
             lower, compared);
    return judge(deep < flush - 0.05 && lower > 0.5 * compared, deep < flush);
}

/* ---- all of them ---- */

/* %s in `said`: the first motion. `both`: of the motions as given and reversed. */
static const struct statement {
    const char *said, *criterion;
    bool both;
    enum verdict (*find)(const struct view *v, char *text);
} statements[] = {
    {"Section 1: floor accelerations and drifts may be significantly amplified by pounding",
     "under every motion a gap at which a building's means of both are above 1.1 times those without pounding", true,
     amplified},
    {"Section 1: at the pounding floors impulses of short period and high amplitude, which depends on the impact "
     "stiffness",
     "at the preset's gap, concrete: above twice that without pounding, for less than a tenth of a period. From a "
     "quarter to four times the stiffness it changes by more than 10 %. Partly: high or brief",
     true, spikes},
    {"Section 2.1: a small plastic deformation increases the clearance",
     "a plastic indentation stays in every contact with impacts, at the preset's gap without bumper", true, widened},
    {"Section 2.2: bumpers may reduce the response due to pounding, which remains above that without pounding ([6])",
     "with a struck bumper, no mean over the floors is below that without pounding, and some are below that of bare "
     "pounding. Partly: more than half are not below",
     true, bumper_above_free},
    {"Section 2.2: a linear law is not the most suitable for rubber",
     "a linear spring with the rubber's largest force at 0.5 m/s misses it by more than 10 % at 0.25 and 1.0 m/s",
     false, linear_rubber},
    {"Section 2.2: the ultimate strain may be reached in severe impacts",
     "the bumper on the wall is compressed beyond it", true, strained},
    {"Eq. (6) gives Table 1's 0.36 kN/mm^2.65 of the bumper", "from the paper's own numbers; partly: the units agree",
     false, equation6},
    {"Fig. 3: past the ultimate strain, three coefficients of restitution",
     "compressed beyond it, one curve of approach, and separation speeds within 1 % of the coefficients; partly: not "
     "the speeds",
     false, figure3},
    {"Fig. 4: the indentation is much larger with the rubber", "more than twice as large at both speeds", false,
     indentation},
    {"Fig. 4: at 1.0 m/s the bumper is compressed beyond its 40 mm and the force rises rapidly",
     "past it, and more than twice the force at 0.5 m/s", false, past_strain},
    {"Fig. 5: the bumper lengthens the impact and reduces force and acceleration", "both, at both speeds", false,
     softer},
    {"Fig. 5: the ratio of the velocities after and before is the coefficient of restitution",
     "within 1 % in all four cases; partly: in some", false, restitution},
    {"Fig. 7, %s: the acceleration of the 4-storey building's 4th floor is reduced at almost all gaps",
     "amplified at no more than a tenth of the gaps that change it; partly: reduced at more than amplified", true,
     floor4_falls},
    {"Fig. 7, %s: that of the 6-storey building's 2nd floor is amplified by up to 30 %%",
     "largest amplification 25 to 35 %; partly: above 10 %", true, floor2_rises},
    {"Fig. 7, %s: that of the 4th floor falls while at the same time that of the 2nd rises",
     "at more than half of the gaps at which the 4th falls; partly: at some", true, at_once},
    {"Fig. 7: accelerations may be amplified at a gap where drifts are reduced", "so at some floor and gap", true,
     opposed},
    {"Fig. 7: accelerations are more sensitive to the bumper than drifts",
     "wider range of the ratios over floors and gaps", true, sensitive},
    {"Fig. 8 tells means over the floors",
     "their ratio and the mean of the floors' ratios are on the same side of 1 at 95 % of those changed; partly: at 75 "
     "%",
     true, ratio_of_means},
    {"Fig. 8: the character of the earthquake affects the effectiveness, with the size of the clearance",
     "mean accelerations of a building rise under one motion and fall under another at more than half of the gaps. "
     "Partly: at some, or they differ by more than 0.1",
     true, character},
    {"Fig. 8: the bumper amplifies the response in most of the times", "more than half of the means that it changes",
     true, mostly_amplified},
    {"Fig. 8: especially in the 6-storey building",
     "more than half of its means, and more than of the other; partly: more than of the other", true, six_storeys},
    {"Fig. 8: at some narrow gaps the bumper is beneficial", "a mean acceleration is reduced at a gap up to 10 cm",
     true, narrow},
    {"Fig. 9: in a cavity all of the 4 cm of 5 are used, without decreasing the gap further by 1 cm",
     "it is struck up to gaps 1 cm narrower than on the wall, and is pressed by 4 cm somewhere", true, usable},
    {"Fig. 10: the cavity reduces the ratios substantially",
     "their mean by more than 0.05, and more than half of them; partly: their mean", true, cavity},
    {"Section 5: the effectiveness depends on the structures, such as the number of storeys",
     "beside 5 to 8 storeys, the 4-storey building's mean acceleration rises with one and falls with another at more "
     "than half of the gaps. Partly: at some, or it differs by more than 0.1",
     true, storeys},
};

static void put(const struct statement *x, const struct view view[2], struct thud_document *d)
{
    static const char *const word[] = {"no", "partly", "yes"};
    char text[2][TEXT] = {"-", "-"};
    struct thud_text said = {0};
    bool both = x->both && view[1].table;
    enum verdict verdict[2] = {x->find(&view[0], text[0])};
    verdict[1] = both ? x->find(&view[1], text[1]) : verdict[0];
    for (const char *c = x->said; *c; c++)
        if (*c == '%') {
            thud_text_append(&said, "%s", *++c == 's' ? view[0].table->record[0] : "%");
        } else {
            thud_text_bytes(&said, c, 1);
        }
    d->failed = d->failed || said.failed;
    thud_document_cell(d, "%s", said.data ? said.data : "");
    thud_document_cell(d, "%s", x->criterion);
    for (int i = 0; i < 2; i++)
        thud_document_cell(d, "%s", text[i]);
    thud_document_cell(d, "%s", word[verdict[0] == verdict[1] ? verdict[0] : PARTLY]);
    thud_document_row(d);
    thud_text_clear(&said);
}

/* ---- besides ---- */

static void put_forces(const struct view *v, const char *what, struct thud_document *d)
{
    int harder = 0, n = 0, past = 0;
    for (size_t i = 0; i < v->table->npoints; i++) {
        const struct thud_sweep_summary *point = v->table->point[i];
        const double with_n = value_of(point, THUD_CASE_BUMPER, THUD_MEASURE_FORCE),
                     none_n = value_of(point, THUD_CASE_NONE, THUD_MEASURE_FORCE);
        if (isnan(with_n) || !(none_n > 0))
            continue;
        n++;
        harder += with_n > none_n;
        past += with_n > none_n && value_of(point, THUD_CASE_BUMPER, THUD_MEASURE_INDENTATION) > v->strained_m;
    }
    thud_document_item(d,
                       "Motions %s: the bumper on the wall increases the largest force at %d of %d gaps with pounding. "
                       "At %d of these it is compressed beyond its ultimate strain, where concrete acts.",
                       what, harder, n, past);
}

void thud_paper_statements(const struct thud_paper_study *study, struct thud_document *d)
{
    const struct thud_sweep_table *table = study->table;
    const struct thud_interface *at = &study->scene->interface[0];
    if (table->nstructures < 2 || study->scene->structure[0].storeys < 4 || study->scene->structure[1].storeys < 4 ||
        !study->runs)
        return;
    double strained_m = thud_interface_max_strain(at) * at->bumper_thickness_m;
    const struct view view[2] = {{study, table, &study->runs[0], strained_m},
                                 {study, study->turned, &study->runs[1], strained_m}};
    thud_document_heading(d, "What the paper says, and what was found");
    thud_document_paragraph(
        d, "Each statement has one criterion. Ratios are with the bumper over without it at the same gap, unless no "
           "pounding is stated. Ratios within 0.1 %% of 1 count as no change. Both polarities of the motions are "
           "assessed separately: if they differ, the statement is partly supported.");
    thud_document_table(d, "Statements of the paper, their criteria and what was found");
    thud_document_head(d, "the paper|criterion|motions as given|motions reversed|borne out");
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++)
        put(&statements[i], view, d);
    thud_document_heading(d, "Further findings");
    put_forces(&view[0], "as given", d);
    if (!study->turned)
        return;
    put_forces(&view[1], "reversed", d);
    thud_document_item(
        d,
        "The sign of a motion, which the paper does not give, changes these counts. Under %s with reversed polarity "
        "the 4-storey building's 4th floor is amplified at %d of %d gaps, as given at %d.",
        table->record[0], of_floor(&view[1], 0, 4, NULL).above, of_floor(&view[1], 0, 4, NULL).n,
        of_floor(&view[0], 0, 4, NULL).above);
}
