/* thud laws: the impact laws, each with its parameters and the restitution it really gives. */
#include <math.h>

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

/* The restitution that two bodies of 320 t really part with at 0.5 m/s; NaN where the law has none to choose. The
 * stiffness is of no matter but to the rubber, which has no default: there it is the paper's. */
static double obtained(const struct thud_law *law, int choice, int which, double nominal)
{
    struct thud_law_setup setup = {0};
    int e = thud_law_param(law, "restitution"), k = thud_law_param(law, "stiffness");
    thud_law_defaults(law, &setup);
    setup.mass_kg = 160e3;
    setup.thickness_m = 0.05;
    if (e < 0)
        return NAN;
    setup.value[e] = nominal;
    if (choice >= 0)
        setup.value[choice] = which;
    if (k >= 0 && isnan(setup.value[k]))
        setup.value[k] = 0.36e3 * pow(1000, law->params[thud_law_param(law, "exponent")].fallback);
    return thud_law_prepare(law, &setup, NULL) != THUD_OK ? NAN : thud_law_restitution(law, &setup, 0.5);
}

/* A line for each way to get the damping from the restitution. */
static void add_restitution(const struct thud_law *law, struct thud_text *out)
{
    static const double nominal[] = {0.3, 0.5, 0.6, 0.8};
    int formula = thud_law_param(law, "formula"), choice = formula >= 0 ? formula : thud_law_param(law, "damping");
    for (int which = 0; which == 0 || (choice >= 0 && law->params[choice].choices[which]); which++) {
        if (isnan(obtained(law, choice, which, 0.5)))
            return;
        thud_text_append(out, "  restitution");
        for (size_t i = 0; i < sizeof nominal / sizeof *nominal; i++)
            thud_text_append(out, "%s %g", i ? "," : "", nominal[i]);
        thud_text_append(out, " really gives");
        for (size_t i = 0; i < sizeof nominal / sizeof *nominal; i++)
            thud_text_append(out, "%s %.3f", i ? "," : "", obtained(law, choice, which, nominal[i]));
        if (choice >= 0)
            thud_text_append(out, " (%s %s)", law->params[choice].name, law->params[choice].choices[which]);
        thud_text_append(out, "\n");
    }
}

static void table(struct thud_text *out)
{
    for (int i = 0; i < thud_law_count(); i++) {
        const struct thud_law *law = thud_law_at(i);
        thud_text_append(out, "%s%s: %s\n  %s\n", i > 0 ? "\n" : "", law->name, law->title, law->summary);
        thud_cli_references(law->reference, out);
        add_restitution(law, out);
        for (int k = 0; k < law->nparams; k++) {
            const struct thud_param *p = &law->params[k];
            thud_text_append(out, "    %-18s %-9s ", p->name,
                             p->kind == THUD_PARAM_CHOICE ? ""
                             : p->unit                    ? p->unit
                                                          : "");
            add_fallback(p, out);
            if (p->kind == THUD_PARAM_CHOICE) {
                thud_text_append(out, "  (");
                add_choices(p, out);
                thud_text_append(out, ")");
            }
            thud_text_append(out, "  %s\n", p->title);
        }
    }
    thud_text_append(out,
                     "\nWhat a restitution really gives is that of two free bodies of 320 t that close at 0.5 m/s.\n");
}

enum thud_status thud_command_laws(const struct thud_args *args, struct thud_error *err)
{
    return thud_cli_list(args, table, thud_laws_put, err);
}
