/* What the paper says in words, each with the numbers found here, for the motions as given and turned round; and what is
 * found besides. */
#include "app/paper/paper_statements.h"

#include <math.h>
#include <stdio.h>

enum { FLOORS_MAX = 8 };
static const double change = THUD_PAPER_CHANGE;

/* What one table says. */
struct findings {
    int a4_below, a4_above, a4_n;                           /* gaps of the 4-storey building's 4th floor */
    double b_most[FLOORS_MAX + 1], b_gap_m[FLOORS_MAX + 1]; /* largest acceleration ratio of each floor of the other */
    int b_floors, opposed;         /* gaps at which a floor is accelerated more and drifts less */
    double least[2], most[2];      /* over floors and gaps: accelerations, deflections */
    int above[2], below[2];        /* means over the floors, all motions and quantities: of each building */
    int narrow_below, narrow_n;    /* mean accelerations at gaps up to 10 cm */
    double mean[THUD_CASES];       /* of the mean ratios, both quantities */
    int lower, compared;           /* means that the cavity lowers */
    int harder, pounding, bottoms; /* gaps: with a larger force than without bumper; with pounding; past delta_u */
    int bottoms_harder;
};

static const struct thud_sweep_ratio *mean_of(const struct thud_sweep_summary *d, enum thud_case which, int structure)
{
    int k = thud_sweep_summary_find(d, which);
    return k >= 0 ? thud_sweep_summary_ratio(d, k, structure, 0, THUD_SWEEP_VALUE) : NULL;
}

static double part(const struct thud_sweep_ratio *x, int quantity)
{
    return !x ? NAN : quantity ? x->drift : x->acceleration;
}

/* Floors under the first motion, as Fig. 7 shows them. */
static void add_floors(struct findings *f, const struct thud_sweep_summary *d, int k)
{
    bool opposed = false;
    for (int s = 0; s < 2; s++) {
        const struct thud_sweep_ratio *x;
        for (int floor = 1; (x = thud_sweep_summary_ratio(d, k, s, floor, THUD_SWEEP_VALUE)) != NULL; floor++) {
            for (int q = 0; q < 2; q++) {
                f->least[q] = fmin(f->least[q], part(x, q));
                f->most[q] = fmax(f->most[q], part(x, q));
            }
            opposed = opposed || (x->acceleration > 1 + change && x->drift < 1 - change);
            if (s == 0 && floor == 4 && !isnan(x->acceleration)) {
                f->a4_n++;
                f->a4_below += x->acceleration < 1 - change;
                f->a4_above += x->acceleration > 1 + change;
            }
            if (s == 1 && floor <= FLOORS_MAX && x->acceleration > f->b_most[floor]) {
                f->b_most[floor] = x->acceleration;
                f->b_gap_m[floor] = d->gap_m;
                f->b_floors = floor > f->b_floors ? floor : f->b_floors;
            }
        }
    }
    f->opposed += opposed;
}

static void add_means(struct findings *f, const struct thud_sweep_summary *d, int counts[THUD_CASES])
{
    for (int s = 0; s < 2; s++)
        for (int q = 0; q < 2; q++) {
            double flush = part(mean_of(d, THUD_CASE_BUMPER, s), q), cavity = part(mean_of(d, THUD_CASE_CAVITY, s), q);
            f->above[s] += flush > 1 + change;
            f->below[s] += flush < 1 - change;
            if (!isnan(flush)) {
                f->mean[THUD_CASE_BUMPER] += flush;
                counts[THUD_CASE_BUMPER]++;
            }
            if (!isnan(cavity)) {
                f->mean[THUD_CASE_CAVITY] += cavity;
                counts[THUD_CASE_CAVITY]++;
            }
            if (fabs(flush - 1) > change && fabs(cavity - 1) > change && !isnan(flush) && !isnan(cavity)) {
                f->compared++;
                f->lower += cavity < flush;
            }
            if (q == 0 && d->gap_m <= 0.1 + 1e-9 && !isnan(flush)) {
                f->narrow_n++;
                f->narrow_below += flush < 1 - change;
            }
        }
}

static struct findings find(const struct thud_sweep_table *table, double strained_m)
{
    struct findings f = {.least = {INFINITY, INFINITY}};
    int counts[THUD_CASES] = {0};
    for (size_t i = 0; i < table->npoints; i++) {
        const struct thud_sweep_summary *d = table->point[i];
        int k = thud_sweep_summary_find(d, THUD_CASE_BUMPER), none = thud_sweep_summary_find(d, THUD_CASE_NONE);
        if (k >= 0 && d->record == 0)
            add_floors(&f, d, k);
        add_means(&f, d, counts);
        if (k >= 0 && none >= 0 && d->run[none].force_n > 0) {
            bool harder = d->run[k].force_n > d->run[none].force_n, past = d->run[k].indentation_m > strained_m;
            f.pounding++;
            f.harder += harder;
            f.bottoms += past;
            f.bottoms_harder += harder && past;
        }
    }
    for (int c = 0; c < THUD_CASES; c++)
        f.mean[c] = counts[c] > 0 ? f.mean[c] / counts[c] : NAN;
    return f;
}

/* ---- verdicts ---- */

static const char *verdict(bool yes, bool partly)
{
    return yes ? "yes" : partly ? "partly" : "no";
}

/* A row with two findings: `what` of the paper, the text of each, whether each bears it out. */
static void row(struct thud_text *out, const char *what, const char *given, const char *turned, bool yes[2],
                bool partly[2])
{
    bool both = turned != NULL;
    const char *said = verdict(yes[0] && (!both || yes[1]), yes[0] || partly[0] || (both && (yes[1] || partly[1])));
    thud_text_append(out, "| %s | %s | %s | **%s** |\n", what, given, both ? turned : "-", said);
}

static double amplified(const struct findings *f)
{
    int above = f->above[0] + f->above[1], all = above + f->below[0] + f->below[1];
    return all > 0 ? (double)above / all : 0;
}

static double share(const struct findings *f, int building)
{
    int all = f->above[building] + f->below[building];
    return all > 0 ? (double)f->above[building] / all : 0;
}

static void of_pairs(const struct thud_paper_pair *p, struct thud_text *out)
{
    thud_text_append(
        out,
        "| Fig. 4: the indentation is much larger with the rubber | %.1f mm for %.2f at 0.5 m/s, %.1f mm for "
        "%.2f at 1.0 m/s | - | **%s** |\n",
        1e3 * p[1].indentation_m, 1e3 * p[0].indentation_m, 1e3 * p[3].indentation_m, 1e3 * p[2].indentation_m,
        verdict(p[1].indentation_m > 2 * p[0].indentation_m && p[3].indentation_m > 2 * p[2].indentation_m, false));
    thud_text_append(out,
                     "| Fig. 4: at 1.0 m/s the bumper is pressed past its 40 mm and the force rises rapidly | %.1f mm, "
                     "%.1f MN for %.1f MN at 0.5 m/s | - | **%s** |\n",
                     1e3 * p[3].indentation_m, 1e-6 * p[3].force_n, 1e-6 * p[1].force_n,
                     verdict(p[3].indentation_m > 0.04, false));
    bool force[2] = {p[1].force_n < p[0].force_n, p[3].force_n < p[2].force_n};
    bool longer = p[1].duration_s > p[0].duration_s && p[3].duration_s > p[2].duration_s;
    thud_text_append(out,
                     "| Fig. 5: the bumper lengthens the impact and reduces force and acceleration | %.0f ms for %.0f "
                     "ms and %.2f MN "
                     "for %.2f MN at 0.5 m/s; %.0f ms for %.0f ms and %.2f MN for %.2f MN at 1.0 m/s | - | **%s** |\n",
                     1e3 * p[1].duration_s, 1e3 * p[0].duration_s, 1e-6 * p[1].force_n, 1e-6 * p[0].force_n,
                     1e3 * p[3].duration_s, 1e3 * p[2].duration_s, 1e-6 * p[3].force_n, 1e-6 * p[2].force_n,
                     verdict(longer && force[0] && force[1], longer || force[0]));
    int close = 0;
    for (int i = 0; i < THUD_PAPER_PAIRS; i++)
        close += fabs(p[i].restitution - p[i].nominal) < 0.01 * p[i].nominal;
    thud_text_append(
        out,
        "| Fig. 5: the ratio of the velocities after and before is the coefficient of restitution | concrete "
        "%.3f for %.1f; rubber %.3f at 0.5 m/s and %.3f at 1.0 m/s for %.1f | - | **%s** |\n",
        p[0].restitution, p[0].nominal, p[1].restitution, p[3].restitution, p[1].nominal,
        verdict(close == THUD_PAPER_PAIRS, close > 0));
}

void thud_paper_statements(const struct thud_paper_study *study, struct thud_text *out)
{
    const struct thud_sweep_table *table = study->table;
    const struct thud_interface *at = &study->scene->interface[0];
    if (table->nstructures < 2 || study->scene->structure[0].storeys < 4 || study->scene->structure[1].storeys < 2)
        return;
    double strained_m = thud_interface_max_strain(at) * at->bumper_thickness_m;
    bool both = study->turned != NULL;
    struct findings f[2] = {find(table, strained_m), find(both ? study->turned : table, strained_m)};
    char text[2][400], what[256];
    bool yes[2], partly[2];
    const char *first = table->record[0];
    thud_text_append(out, "\n## What the paper says, and what was found\n\nRatios within 0.1 %% of 1 are no change.\n\n"
                          "| the paper | motions as given | motions turned round | borne out |\n|---|---|---|---|\n");
    of_pairs(study->pair, out);
#define BOTH(fmt, ...)                                                                                                 \
    for (int i = 0; i < 2; i++) {                                                                                      \
        const struct findings *x = &f[i];                                                                              \
        snprintf(text[i], sizeof text[i], fmt, __VA_ARGS__);
    BOTH("%d of %d gaps below 1, %d above", x->a4_below, x->a4_n, x->a4_above)
    yes[i] = x->a4_above <= 0.1 * (x->a4_above + x->a4_below);
    partly[i] = x->a4_below > x->a4_above;
}
snprintf(what, sizeof what,
         "Fig. 7, %s: the acceleration of the 4-storey building's 4th floor is reduced at almost all gaps", first);
row(out, what, text[0], both ? text[1] : NULL, yes, partly);
BOTH("by %.0f %% at %.4g cm; floors 1, 3 and 4 by %.0f, %.0f and %.0f %%", 100 * (x->b_most[2] - 1),
     100 * x->b_gap_m[2], 100 * (x->b_most[1] - 1), 100 * (x->b_most[3] - 1), 100 * (x->b_most[4] - 1))
yes[i] = x->b_most[2] > 1.25 && x->b_most[2] < 1.35;
partly[i] = x->b_most[2] > 1.1;
}
snprintf(what, sizeof what, "Fig. 7, %s: that of the 6-storey building's 2nd floor is amplified by up to 30 %%", first);
row(out, what, text[0], both ? text[1] : NULL, yes, partly);
BOTH("a floor with a larger acceleration and a smaller deflection at %d of %d gaps", x->opposed, x->a4_n)
yes[i] = x->opposed > 0;
partly[i] = false;
}
row(out, "Fig. 7: accelerations may be amplified at a gap where deflections are reduced", text[0],
    both ? text[1] : NULL, yes, partly);
BOTH("accelerations %.2f to %.2f, deflections %.2f to %.2f", x->least[0], x->most[0], x->least[1], x->most[1])
yes[i] = x->most[0] - x->least[0] > x->most[1] - x->least[1];
partly[i] = false;
}
row(out, "Fig. 7: accelerations are more sensitive to the bumper than deflections", text[0], both ? text[1] : NULL, yes,
    partly);
BOTH("of %d means that the bumper changes %d are amplified, %d reduced",
     x->above[0] + x->above[1] + x->below[0] + x->below[1], x->above[0] + x->above[1], x->below[0] + x->below[1])
yes[i] = amplified(x) > 0.5;
partly[i] = share(x, 0) > 0.5 || share(x, 1) > 0.5;
}
row(out, "Fig. 8: the bumper amplifies the response in most of the times", text[0], both ? text[1] : NULL, yes, partly);
BOTH("6-storey: %d of %d amplified; 4-storey: %d of %d", x->above[1], x->above[1] + x->below[1], x->above[0],
     x->above[0] + x->below[0])
yes[i] = share(x, 1) > share(x, 0);
partly[i] = false;
}
row(out, "Fig. 8: especially in the 6-storey building", text[0], both ? text[1] : NULL, yes, partly);
BOTH("mean accelerations below 1 at %d of %d up to 10 cm", x->narrow_below, x->narrow_n)
yes[i] = x->narrow_below > 0;
partly[i] = false;
}
row(out, "Fig. 8: at some narrow gaps the bumper is beneficial", text[0], both ? text[1] : NULL, yes, partly);
BOTH("mean of all ratios %.3f on the wall, %.3f in the cavity; lower at %d of %d", x->mean[THUD_CASE_BUMPER],
     x->mean[THUD_CASE_CAVITY], x->lower, x->compared)
yes[i] = x->mean[THUD_CASE_CAVITY] < x->mean[THUD_CASE_BUMPER] && x->lower > 0.5 * x->compared;
partly[i] = x->mean[THUD_CASE_CAVITY] < x->mean[THUD_CASE_BUMPER];
}
row(out, "Fig. 10: the cavity reduces the ratios substantially", text[0], both ? text[1] : NULL, yes, partly);
thud_text_append(out, "\n### Found besides\n\n");
for (int i = 0; i < (both ? 2 : 1); i++)
    thud_text_append(
        out,
        "- Motions %s: the bumper on the wall makes the largest force larger at %d of %d gaps with pounding; at %d of "
        "those it is pressed past its largest strain of %.3g mm, where concrete answers (at %d of %d in all).\n",
        i ? "turned round" : "as given", f[i].harder, f[i].pounding, f[i].bottoms_harder, 1e3 * strained_m,
        f[i].bottoms, f[i].pounding);
if (both)
    thud_text_append(out,
                     "- The sign of a motion, which the paper does not give, changes these counts: under %s turned "
                     "round the 4-storey building's 4th floor is amplified at %d of %d gaps, as given at %d.\n",
                     first, f[1].a4_above, f[1].a4_n, f[0].a4_above);
#undef BOTH
}
