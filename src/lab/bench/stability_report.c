#include "lab/bench/stability_report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/run/result_table.h"

static const char *const kinds[THUD_STABILITY_KINDS] = {"free vibration", "wall spring", "scene"};

static void add_number(struct thud_text *out, double value)
{
    if (isfinite(value))
        thud_text_append(out, " %7.4g", value);
    else
        thud_text_append(out, " %7s", isnan(value) ? "-" : "blown");
}

/* Begins a line with the method where it is another than that before (NULL: the first); whether it did. */
static bool new_line(const struct thud_stepping *how, const struct thud_stepping *before, struct thud_text *out)
{
    char name[64];
    if (before && thud_stepping_same(how, before))
        return false;
    thud_stepping_name(how, name, sizeof name);
    thud_text_append(out, "\n%-26s", name);
    return true;
}

static void add_verdicts(const struct thud_stability *s, int kind, struct thud_text *out)
{
    static const char signs[] = "-.+X";
    static const char *const meant[THUD_STABILITY_KINDS] = {
        "(+ from 1.21, X from 1e4 times the energy in the second half of 50 s)",
        "(+ from 1.21, X from 1e4 times the energy of the start, within 50 s, at the worst of several starts)",
        "(+ from 2, X from 100 times the exact peak displacement, at the worst of three steps up to 6 % shorter)"};
    const struct thud_stability_cell *c = s->cell;
    struct thud_text words = {0};
    thud_text_append(&words, "%s: . bounded, + growing, X blown up; limit: omega dt of a linear system %s", kinds[kind],
                     meant[kind]);
    thud_table_words(out, "\n", &words, 2);
    thud_text_append(out, "%-26s %5s ", "omega dt", "limit");
    for (int i = 0, shown = 0; i < s->ncells && !(shown && !thud_stepping_same(&c[i].how, &c[i - 1].how)); i++)
        if (!isnan(c[i].omega_dt)) {
            thud_text_append(out, "%4.3g", c[i].omega_dt);
            shown = 1;
        }
    for (int i = 0; i < s->ncells; i++) {
        if (new_line(&c[i].how, i ? &c[i - 1].how : NULL, out)) {
            if (isfinite(c[i].how.method->stability))
                thud_text_append(out, " %5.4g ", c[i].how.method->stability);
            else
                thud_text_append(out, " %5s ", "none");
        }
        if (isnan(c[i].omega_dt))
            thud_text_append(out, " %s (steps of its own)", thud_stability_verdict_word(c[i].verdict[kind]));
        else
            thud_text_append(out, "%4c", signs[c[i].verdict[kind]]);
    }
    thud_text_append(out, "\n");
}

static void add_share(double value, struct thud_text *out)
{
    char text[16] = "X";
    if (isnan(value))
        snprintf(text, sizeof text, "-");
    else if (isfinite(value))
        snprintf(text, sizeof text, value >= 0.1 && value < 1000 ? "%.3g" : "%.0e", value);
    thud_text_append(out, " %5s", text);
}

/* A column for each of these steps; methods that take none have one number. */
static void add_energies(const struct thud_stability *s, struct thud_text *out)
{
    static const double shown[] = {0.12, 0.5, 1, 1.9, 2.7, 2.9, 3.6, 5};
    enum { SHOWN = sizeof shown / sizeof *shown };
    thud_text_append(out,
                     "\nlargest energy on the wall spring within 50 s over that at the start, by omega\n"
                     "  dt; of %d starts the worst (X blown up)\n%-26s",
                     THUD_STABILITY_STARTS, "");
    for (int k = 0; k < SHOWN; k++)
        thud_text_append(out, " %5.4g", shown[k]);
    for (int i = 0; i < s->ncells; i++) {
        const struct thud_stability_cell *c = &s->cell[i];
        char name[64];
        bool column = isnan(c->omega_dt);
        for (int k = 0; k < SHOWN; k++)
            column = column || c->omega_dt == shown[k];
        if (i == 0 || !thud_stepping_same(&c->how, &c[-1].how)) {
            thud_stepping_name(&c->how, name, sizeof name);
            thud_text_append(out, "\n%-26s", name);
        }
        if (column)
            add_share(c->verdict[THUD_STABILITY_WALL] ? c->growth[THUD_STABILITY_WALL] : NAN, out);
    }
    thud_text_append(out, "\n");
}

static bool same_impact(const struct thud_stability_restitution *a, const struct thud_stability_restitution *b)
{
    return a->law == b->law && a->approach_mps == b->approach_mps &&
           (a->nominal == b->nominal || (isnan(a->nominal) && isnan(b->nominal)));
}

/* By law, nominal restitution and speed: the exact method beside the worst and the best of the others at 1 ms, neither
 * located. */
static void add_restitutions(const struct thud_stability *s, struct thud_text *out)
{
    static const char *const shown[] = {"exact", "newmark", "central-difference", "rk4", "lagged"};
    enum { SHOWN = sizeof shown / sizeof *shown };
    const struct thud_stability_restitution *r = s->restitution;
    thud_text_append(out, "\nrestitution of two free bodies, steps of 1 ms, not located\n%-23s %4s %4s %6s", "law", "e",
                     "m/s", "law's");
    for (int k = 0; k < SHOWN; k++)
        thud_text_append(out, " %7.7s", shown[k]);
    for (int i = 0; i < s->nrestitutions; i++) {
        if (i == 0 || !same_impact(&r[i], &r[i - 1])) {
            thud_text_append(out, "\n%-23s ", r[i].law->name);
            if (isnan(r[i].nominal))
                thud_text_append(out, "%4s", "-");
            else
                thud_text_append(out, "%4.3g", r[i].nominal);
            thud_text_append(out, " %4.3g %6.4f", r[i].approach_mps, r[i].expected);
        }
        for (int k = 0; k < SHOWN; k++)
            if (strcmp(r[i].how.method->name, shown[k]) == 0 &&
                (k == 0 || (!r[i].how.locate && r[i].how.setting == 1e-3)))
                add_number(out, r[i].obtained);
    }
    thud_text_append(out, "\n");
}

static void add_test_cases(const struct thud_stability *s, struct thud_text *out)
{
    struct thud_text lines = {0};
    thud_text_append(out, "\nwhere a naive method goes wrong\n");
    for (int i = 0; i < s->ntest_cases; i++) {
        const struct thud_test_case *e = &s->test_case[i];
        if (!e->name)
            continue;
        thud_text_append(&lines, "%s: %s\n    %s: exact %.6g, ", e->name, e->scene, e->quantity, e->exact);
        if (isfinite(e->naive))
            thud_text_append(&lines, "naive %.6g", e->naive);
        else
            thud_text_append(&lines, "naive blows up");
        thud_text_append(&lines, " (%s), computed %.6g\n", e->method, e->computed);
    }
    thud_table_lines(out, &lines, 2);
}

static void add_step(const struct thud_stability_summary *m, const char *level, double setting, struct thud_text *out)
{
    const bool fixed = m->how.method->flags & THUD_METHOD_FIXED_STEP;
    if (isnan(setting))
        thud_text_append(out, "; never within %s", level);
    else if (fixed)
        thud_text_append(out, "; within %s up to %.3g ms", level, 1e3 * setting);
    else
        thud_text_append(out, "; within %s at tolerance %.0e", level, setting);
}

/* A sentence for each method. */
static void add_summaries(const struct thud_stability *s, struct thud_text *out)
{
    thud_text_append(out, "each method: order of impact times; steps that keep the scene's peaks and\n"
                          "impacts; energy left on the wall spring after 50 s (step times frequency 0.5);\n"
                          "restitution of concrete in steps of 1 ms\n");
    for (int i = 0; i < s->nsummaries; i++) {
        const struct thud_stability_summary m = thud_stability_summary_of(s, i);
        struct thud_text words = {0};
        char name[64];
        thud_stepping_name(&m.how, name, sizeof name);
        thud_text_append(&words, "%s: ", name);
        if (isnan(m.order))
            thud_text_append(&words, "steps of its own");
        else
            thud_text_append(&words, "order %.2f (nominal %d)", m.order, m.how.method->order);
        if (s->peak_m) {
            add_step(&m, "10 %", m.keeps[0], &words);
            add_step(&m, "1 %", m.keeps[1], &words);
            if (!isnan(m.diverges_s))
                thud_text_append(&words, "; blows up from %.3g ms", 1e3 * m.diverges_s);
        }
        if (isfinite(m.wall_most))
            thud_text_append(&words, "; energy %.3g to %.3g", m.wall_least, m.wall_most);
        else if (isinf(m.wall_most))
            thud_text_append(&words, "; energy without bound");
        if (isfinite(m.obtained))
            thud_text_append(&words, "; restitution %.4f for %.4f", m.obtained, m.expected);
        thud_table_words(out, "", &words, 2);
    }
}

void thud_stability_table(const struct thud_stability *s, struct thud_text *out)
{
    add_summaries(s, out);
    for (int kind = 0; kind < THUD_STABILITY_KINDS; kind++)
        if (kind != THUD_STABILITY_SCENE || s->peak_m)
            add_verdicts(s, kind, out);
    add_energies(s, out);
    add_restitutions(s, out);
    add_test_cases(s, out);
}
