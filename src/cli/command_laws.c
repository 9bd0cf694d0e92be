/* thud laws: the impact laws, each with its parameters and the restitution it really gives. */
#include <math.h>

#include "app/run/result_table.h"
#include "base/nearest.h"
#include "base/param.h"
#include "cli/commands.h"
#include "core/laws/law.h"
#include "io/result/list_rows.h"

/* Default of a parameter in its shown unit. */
static void add_fallback(const struct thud_param *p, struct thud_text *out)
{
    char text[64];
    if (p->kind == THUD_PARAM_CHOICE) {
        thud_text_append(out, "%s", p->choices[(int)p->fallback]);
    } else if (isnan(p->fallback)) {
        thud_text_append(out, "not given");
    } else if (p->unit && p->unit[0]) {
        thud_quantity_format(p->fallback, p->unit, text, sizeof text);
        thud_text_append(out, "%s", text);
    } else {
        thud_text_number(out, p->fallback);
    }
}

static void add_choices(const struct thud_param *p, struct thud_text *out)
{
    for (int i = 0; p->choices[i]; i++)
        thud_text_append(out, "%s%s", i > 0 ? " | " : "", p->choices[i]);
}

static const double speed_mps = 0.5;

/* Of two bodies of 320 t, with the usual values. The rubber's stiffness, which has no default, is the paper's. */
static struct thud_law_setup usual(const struct thud_law *law)
{
    struct thud_law_setup setup = {0};
    const int k = thud_law_param(law, "stiffness");
    thud_law_defaults(law, &setup);
    setup.mass_kg = 160e3;
    setup.thickness_m = 0.05;
    if (k >= 0 && isnan(setup.value[k]))
        setup.value[k] = 0.36e3 * pow(1000, law->params[thud_law_param(law, "exponent")].fallback);
    return setup;
}

/* The restitution that two bodies of 320 t really part with at 0.5 m/s; NaN where it is not known. Of a law without
 * that parameter `nominal` plays no part. */
static double obtained(const struct thud_law *law, int choice, int which, double nominal)
{
    struct thud_law_setup setup = usual(law);
    const int e = thud_law_param(law, "restitution");
    if (e >= 0)
        setup.value[e] = nominal;
    if (choice >= 0)
        setup.value[choice] = which;
    return thud_law_prepare(law, &setup, NULL) != THUD_OK ? NAN : thud_law_restitution(law, &setup, speed_mps);
}

/* A line for each way to get the damping from the restitution. */
static void add_restitution(const struct thud_law *law, struct thud_text *out)
{
    static const double nominal[] = {0.3, 0.5, 0.6, 0.8};
    int formula = thud_law_param(law, "formula"), choice = formula >= 0 ? formula : thud_law_param(law, "damping");
    for (int which = 0; which == 0 || (choice >= 0 && law->params[choice].choices[which]); which++) {
        const double e = obtained(law, choice, which, 0.5);
        if (isnan(e))
            return;
        if (thud_law_param(law, "restitution") < 0) {
            thud_text_append(out, "  restitution is no parameter: two bodies of 320 t part with %.3f at %g m/s\n", e,
                             speed_mps);
            return;
        }
        thud_text_append(out, which == 0 ? "  restitution" : "");
        for (size_t i = 0; which == 0 && i < sizeof nominal / sizeof *nominal; i++)
            thud_text_append(out, "%s %g", i ? "," : "", nominal[i]);
        thud_text_append(out, which == 0 ? "\n   really gives" : "   really gives");
        for (size_t i = 0; i < sizeof nominal / sizeof *nominal; i++)
            thud_text_append(out, "%s %.3f", i ? "," : "", obtained(law, choice, which, nominal[i]));
        if (choice >= 0)
            thud_text_append(out, " (%s %s)", law->params[choice].name, law->params[choice].choices[which]);
        thud_text_append(out, "\n");
    }
}

/* The force at rest and at 0.5 m/s, up to the indentation that stores what two such bodies bring. */
static void add_curve(const struct thud_law *law, struct thud_text *out)
{
    enum { ROWS = 8 };
    struct thud_law_setup setup = usual(law);
    struct thud_law_memory memory = {0};
    double low = 0, high = 1e-6;
    const double energy = 0.5 * setup.mass_kg * speed_mps * speed_mps;
    if (law->flags & (THUD_LAW_NO_FORCE | THUD_LAW_IMPULSIVE) || thud_law_prepare(law, &setup, NULL) != THUD_OK)
        return;
    thud_law_onset(law, &setup, speed_mps, &memory);
    while (high < 1 && thud_law_energy(law, &setup, &memory, THUD_APPROACH, high) < energy)
        high *= 2;
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        *(thud_law_energy(law, &setup, &memory, THUD_APPROACH, middle) < energy ? &low : &high) = middle;
    }
    struct thud_law_memory back = memory;
    const double e = thud_law_restitution(law, &setup, speed_mps), parting_mps = 0.5 * (isnan(e) ? 1 : e) * speed_mps;
    thud_law_reversal(law, &setup, THUD_RESTITUTION, high, &back);
    thud_text_append(out,
                     "\n  curve of two bodies of 320 t, usual values: force in MN at rest, closing at\n"
                     "  %g m/s and parting at %.3g m/s\n"
                     "    indentation mm  at rest      closing   parting\n",
                     speed_mps, parting_mps);
    for (int i = 0; i <= ROWS; i++) {
        const double d = high * i / ROWS;
        const struct thud_branch in = thud_law_branch_at(law, &setup, &memory, THUD_APPROACH, d),
                                 apart = thud_law_branch_at(law, &setup, &back, THUD_RESTITUTION, d);
        double force[] = {thud_branch_force(&in, d, 0, NULL, NULL), thud_branch_force(&in, d, speed_mps, NULL, NULL),
                          thud_branch_force(&apart, d, -parting_mps, NULL, NULL)};
        for (int k = 0; k < 3 && !(law->flags & THUD_LAW_PULLS); k++)
            force[k] = fmax(force[k], 0);
        thud_text_append(out, "    %14.3f  %7.3f  %11.3f  %8.3f\n", 1e3 * d, 1e-6 * force[0], 1e-6 * force[1],
                         1e-6 * force[2]);
    }
}

enum { INDENT = 33 }; /* of the further lines of a parameter: where its default begins */

static void put_law(const struct thud_law *law, struct thud_text *out)
{
    thud_text_append(out, "%s%s: %s\n", out->size ? "\n" : "", law->name, law->title);
    thud_cli_words(law->summary, out);
    thud_cli_references(law->reference, out);
    add_restitution(law, out);
    for (int k = 0; k < law->nparams; k++) {
        const struct thud_param *p = &law->params[k];
        thud_text_append(out, "    %-18s %-9s ", p->name, p->kind == THUD_PARAM_CHOICE ? "" : p->unit ? p->unit : "");
        add_fallback(p, out);
        if (p->kind == THUD_PARAM_CHOICE) {
            struct thud_text words = {0};
            thud_text_append(&words, "(");
            add_choices(p, &words);
            thud_text_append(&words, ")\t %s", p->title);
            thud_text_append(out, "  ");
            thud_text_wrap(out, words.data ? words.data : "", INDENT, THUD_LINE_WIDTH);
            thud_text_append(out, "\n");
            out->failed |= words.failed;
            thud_text_clear(&words);
        } else
            thud_text_append(out, "  %s\n", p->title);
    }
}

static void table(struct thud_text *out)
{
    for (int i = 0; i < thud_law_count(); i++)
        put_law(thud_law_at(i), out);
    thud_text_append(out, "\nThe restitution really given is that of two free bodies of 320 t at 0.5 m/s.\n");
}

/* One law with its curve. */
static enum thud_status show_law(const char *name, struct thud_error *err)
{
    struct thud_text text = {0};
    const struct thud_law *law = thud_law_find(name);
    const char *names[THUD_LAW_PARAMS_MAX * 2];
    int n = 0;
    for (; n < thud_law_count() && n < (int)(sizeof names / sizeof *names); n++)
        names[n] = thud_law_at(n)->name;
    const char *nearest = thud_nearest(name, names, n);
    if (!law)
        return thud_error_refuse(err, THUD_USAGE, NULL, "`thud laws` lists them", "there is no law \"%.40s\"%s%s%s",
                                 name, nearest ? "; did you mean " : "", nearest ? nearest : "", nearest ? "?" : "");
    put_law(law, &text);
    add_curve(law, &text);
    return thud_cli_print(&text, err);
}

enum thud_status thud_command_laws(const struct thud_args *args, struct thud_error *err)
{
    return args->noperands == 1 && !thud_args_has(args, "json") && !thud_args_has(args, "csv")
               ? show_law(args->operand[0], err)
               : thud_cli_list(args, table, thud_laws_put, err);
}
