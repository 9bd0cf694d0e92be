/* The section on how sure the result is: one input at a time, all of them drawn at random, the contact's stiffness. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/report/site_report_private.h"
#include "app/run/summary_line.h"
#include "study/scene/level.h"

/* ---- one input at a time ---- */

/* Whether there are buildings among every second structure from `first` on, whose stiffness is changed together; their
 * names into `names`, NULL: nowhere. */
static bool changes(const struct site *site, int first, struct thud_text *names)
{
    bool any = false;
    for (int s = first; s < site->scene->nstructures; s += 2)
        if (thud_site_is_building(site, s)) {
            if (names)
                thud_text_append(names, "%s%s", any ? ", " : "", thud_site_name(site, s));
            any = true;
        }
    return any;
}

static void add_sensitivity_row(struct site *site, const char *what, double peak, const char *unit,
                                const struct thud_spread *spread)
{
    struct thud_document *d = &site->document;
    thud_document_cells(d, "%s\t%s %s", what, thud_site_number(peak, 3).text, unit);
    for (int i = 0; i < THUD_CHANGES; i++)
        if (i < THUD_CHANGE_STIFFNESS_ODD || changes(site, i == THUD_CHANGE_STIFFNESS_EVEN, NULL))
            thud_document_cell(d, "%.1f", 100 * spread->by[i]);
    thud_document_row(d);
}

static void sensitivity(struct site *site)
{
    struct thud_document *d = &site->document;
    const struct thud_sensitivity *s = site->sensitivity;
    const struct thud_result *r = site->own->result;
    char what[400], between[320], level[24];
    if (!s)
        return;
    snprintf(what, sizeof what, "Largest change of each peak, %%, when one input is %.0f %% less or more (%s)",
             100 * s->change, site->own->words);
    thud_document_table(d, what);
    thud_document_cells(d, "peak\tvalue\tgap\tground motion");
    for (int first = 0; first < 2; first++) {
        struct thud_text names = {0};
        if (changes(site, first, &names) && names.data)
            thud_document_cell(d, "stiffness of %s", names.data);
        d->failed = d->failed || names.failed;
        thud_text_clear(&names);
    }
    thud_document_row(d);
    for (int k = 0, row = 0; k < r->nstructures; row += r->structure[k].floors, k++) {
        const int slab = thud_structure_first_storey(&site->scene->structure[k]);
        int a = 0, b = slab;
        double most = NAN;
        for (int i = 0; i < r->structure[k].floors; i++) {
            most = fmax(most, thud_floor_acceleration(r, k, i));
            a = thud_floor_acceleration(r, k, i) >= most ? i : a;
            b = i >= slab && r->structure[k].floor[i].drift.value > r->structure[k].floor[b].drift.value ? i : b;
        }
        if (r->structure[k].floors == 0)
            continue;
        snprintf(what, sizeof what, "acceleration of %s", thud_site_floor(site, k, a + 1, between, sizeof between));
        if (!isnan(most))
            add_sensitivity_row(site, what, most / THUD_GRAVITY, "g", &s->floor[row + a][0]);
        if (!thud_site_is_building(site, k))
            continue;
        for (int i = 0; i <= b; i++) { /* the isolators, and the storey */
            if (i >= slab && i < b)
                continue;
            snprintf(what, sizeof what, "drift of %s%s of %s", i < slab ? "the " : "",
                     thud_structure_level_name(&site->scene->structure[k], i, true, level), thud_site_name(site, k));
            add_sensitivity_row(site, what, 1e3 * r->structure[k].floor[i].drift.value, "mm", &s->floor[row + i][3]);
        }
    }
    const struct thud_contact_result *most = thud_site_strongest(r);
    if (most) {
        thud_site_sides(site, most->interface, most->left_floor, most->right_floor, most->struck, between,
                        sizeof between);
        snprintf(what, sizeof what, "force between %s", between);
        add_sensitivity_row(site, what, 1e-6 * most->force.value, "MN", &s->contact[most - r->contact][0]);
    }
}

/* ---- all of them at once ---- */

/* A gap as everywhere, a ratio without factor. */
static struct thud_site_unit unit_of(const struct thud_quantity_of_run *q)
{
    const enum thud_dimension kind = thud_measure_info(q->measure)->kind;
    const bool as_it_is = q->measure == THUD_MEASURE_GAP || kind == THUD_RATIO;
    return as_it_is ? (struct thud_site_unit){1, q->measure == THUD_MEASURE_GAP ? " cm" : ""} : thud_site_unit(kind);
}

/* "stiffness of B" of "stiffness.B", "contact stiffness" of "contact-stiffness", "gap between A and B" of "gap.1". */
static void input_words(const struct site *site, const struct thud_drawn_input *input, char *text, size_t size)
{
    const char *name = input->name, *dot = strchr(name, '.');
    const int n = dot ? (int)(dot - name) : (int)strlen(name);
    if (dot && input->of >= 0 && thud_input_info(input->input)->each == THUD_INPUT_EACH_INTERFACE)
        snprintf(text, size, "%.*s between %.40s and %.40s", n, name, thud_site_name(site, input->of),
                 thud_site_name(site, input->of + 1));
    else
        snprintf(text, size, "%.*s%s%s", n, name, dot ? " of " : "", dot ? dot + 1 : "");
    for (int i = 0; i < n && text[i]; i++)
        text[i] = text[i] == '-' ? ' ' : text[i];
}

static void add_sampled_row(struct site *site, int q)
{
    struct thud_document *d = &site->document;
    const struct thud_uncertainty_study *study = &site->samples;
    const struct thud_quantity_of_run *quantity = &study->uncertainty->quantity[q];
    const struct thud_uncertainty_told *t = &study->told[q];
    const double nominal = site->suite.leads ? thud_site_suite_median(site, quantity) : t->nominal;
    const double value[] = {nominal, t->low, t->median, t->high};
    const bool gap = quantity->measure == THUD_MEASURE_GAP, same = t->low == t->high && t->nominal == t->median;
    const struct thud_site_unit unit = unit_of(quantity);
    const char *what = strstr(quantity->name, ": ");
    if (what)
        thud_document_cell(d, "%c%s%s%s",
                           thud_site_letter(quantity->which == THUD_CASE_NONE ? SITE_NONE : site->ncases - 1), what,
                           *unit.name ? "," : "", unit.name);
    else
        thud_document_cell(d, "%s%s%s", quantity->name, *unit.name ? "," : "", unit.name);
    for (size_t i = 0; i < sizeof value / sizeof *value; i++)
        if (gap && !isnan(value[i]))
            thud_document_cell(d, "%.1f", thud_summary_gap_cm(value[i]));
        else
            thud_document_cell(d, "%s", thud_site_number(value[i] / unit.size, 3).text);
    char input[160];
    input_words(site, &study->uncertainty->input[thud_uncertainty_strongest(study, t)], input, sizeof input);
    thud_document_cell(d, "%s", same || isnan(t->median) ? "-" : input);
    thud_document_row(d);
}

static void samples(struct site *site)
{
    struct thud_document *d = &site->document;
    const struct thud_uncertainty *u = site->uncertainty;
    char caption[120];
    if (!u)
        return;
    snprintf(caption, sizeof caption, "All uncertain inputs sampled jointly: %zu samples",
             thud_uncertainty_samples(&site->samples));
    thud_site_case_table(site, caption, SITE_NONE);
    thud_document_head(d, site->suite.leads ? "peak|nominal inputs, median of the suite|5 %|median|95 %|governed by"
                                            : "peak|nominal|5 %|median|95 %|governed by");
    for (int q = 0; q < u->nquantities; q++)
        add_sampled_row(site, q);
    struct thud_text inputs = {0};
    for (int i = 0; i < u->ninputs; i++) {
        char input[160], sized[160];
        thud_uncertainty_input_text(u, i, sized, sizeof sized); /* its name, and its size */
        input_words(site, &u->input[i], input, sizeof input);
        thud_text_append(&inputs, "%s%s%s", i ? ", " : "", input, sized + strlen(u->input[i].name));
    }
    thud_document_paragraph(d,
                            "The inputs are sampled uniformly and independently over their ranges (seed %llu): %s. "
                            "Ranges that were not given are usual values of practice.",
                            site->samples.seed, inputs.data ? inputs.data : "");
    d->failed = d->failed || inputs.failed;
    thud_text_clear(&inputs);
}

void thud_site_samples_summary(struct site *site)
{
    const struct thud_uncertainty *u = site->uncertainty;
    struct thud_text text = {0};
    double of = 0;
    for (int q = 0; u && q < u->nquantities; q++) {
        const struct thud_uncertainty_told *t = &site->samples.told[q];
        const struct thud_quantity_of_run *quantity = &u->quantity[q];
        if (!thud_quantity_is_ratio(quantity) || isnan(t->median))
            continue;
        of = t->count;
        thud_text_append(&text, "%s the %s of %s in %.0f %%", text.size > 0 ? "," : "",
                         thud_measure_info(thud_measure_info(quantity->measure)->ratio_of)->words,
                         thud_site_name(site, quantity->structure), 100 * t->below);
    }
    if (text.size > 0)
        thud_document_item(&site->document, "Over %.0f samples of the uncertain inputs the %s %s%s.", of,
                           site->own->measure, thud_site_verb(site->own, "lowers").text, text.data);
    site->document.failed = site->document.failed || text.failed;
    thud_text_clear(&text);
}

/* ---- the contact's stiffness ---- */

static void add_stiffness_row(struct site *site, const char *what, const struct thud_stiffness_row *row)
{
    struct thud_document *d = &site->document;
    thud_document_cells(d, "%s\t%d\t%s", what, row->impacts, thud_site_number(1e-6 * row->force_n, 3).text);
    for (int s = 0; s < site->scene->nstructures; s++)
        if (site->scene->structure[s].kind != THUD_WALL)
            thud_document_cells(d, "%s\t%s", thud_site_number(row->acceleration_mps2[s] / THUD_GRAVITY, 3).text,
                                thud_site_number(1e3 * row->drift_m[s], 3).text);
    thud_document_row(d);
}

static void stiffness(struct site *site)
{
    struct thud_document *d = &site->document;
    char what[160];
    snprintf(what, sizeof what,
             "Half and twice the stiffness %s, and the motion with reversed polarity: largest acceleration a, drift d",
             site->own->words);
    thud_document_table(d, what);
    thud_document_cells(d, "scene\timpacts\tforce MN");
    for (int s = 0; s < site->scene->nstructures; s++)
        if (site->scene->structure[s].kind != THUD_WALL)
            thud_document_cells(d, "a of %s g\td of %s mm", thud_site_name(site, s), thud_site_name(site, s));
    thud_document_row(d);
    bool nominal = false; /* of each kind the same */
    for (int k = 0; k < THUD_STIFFNESSES; k++)
        for (int i = 0; i < site->nrows[k]; i++) {
            const struct thud_stiffness_row *row = &site->row[k][i];
            if (row->factor == 1 && nominal)
                continue;
            nominal = nominal || row->factor == 1;
            snprintf(what, sizeof what, row->factor == 1 ? "nominal" : "%g times the %s stiffness", row->factor,
                     thud_stiffness_name((enum thud_stiffness)k));
            add_stiffness_row(site, what, row);
        }
    if (site->record)
        add_stiffness_row(site, "ground motion, reversed polarity", &site->reversed);
    thud_document_paragraph(
        d,
        "Contact stiffness is the least certain input: estimates based on the slabs or the rubber differ by such "
        "factors. If halving or doubling it changes a result, the result is uncertain by at least that change.%s",
        site->nrows[THUD_STIFFNESS_LINK] > 0 ? " Of links stiffness, dashpot and slip force change together." : "");
}

void thud_site_sure_section(struct site *site)
{
    thud_document_heading(&site->document, "Sensitivity and uncertainty");
    sensitivity(site);
    samples(site);
    stiffness(site);
}
