/* The first page of a report, for who decides: what was asked and found, a row each; and every input by its key. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/report/site_report_private.h"
#include "app/run/run_cases.h"
#include "app/run/summary_line.h"
#include "base/version.h"
#include "core/laws/law.h"
#include "core/methods/method.h"
#include "ground/identity.h"
#include "io/preset/preset.h"
#include "study/scene/level.h"

void thud_site_verdict(struct site *site, const char *what, const char *found)
{
    thud_document_line(&site->document, "%s\t%s", what, found);
}

void thud_site_title_block(struct site *site)
{
    const struct thud_title_block *b = &site->scene->document;
    struct thud_document *d = &site->document;
    const struct {
        const char *what, *value;
    } line[] = {{"Project", b->project}, {"Document", b->number}, {"Revision", b->revision}, {"Date", b->date}},
      signs[] = {{"Prepared by", b->author}, {"Checked by", b->checker}, {"Approved by", b->approver}};
    struct thud_text version = {0};
    bool named = false;
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++)
        named = named || *signs[i].value;
    thud_version_name(&version);
    thud_document_table(d, "");
    thud_site_verdict(site, "Computed by", version.data ? version.data : "");
    for (size_t i = 0; i < sizeof line / sizeof *line; i++)
        if (*line[i].value)
            thud_site_verdict(site, line[i].what, line[i].value);
    d->failed = d->failed || version.failed;
    thud_text_clear(&version);
    if (!named)
        return;
    thud_document_table(d, "");
    thud_document_head(d, "signatures|name|date|signature");
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++)
        thud_document_line(d, "%s\t%s\t\t", signs[i].what, signs[i].value);
}

/* Whether there is contact at an interface (from 1) in a case. */
static bool pounds_at(const struct site_case *one, int interface)
{
    for (int c = 0; c < one->result->ncontacts; c++)
        if (one->result->contact[c].interface == interface && one->result->contact[c].impacts > 0)
            return true;
    return false;
}

/* What the runs say of a gap that is enough or not when nothing else touches: between bare faces, and as written. */
static const char *gap_verdict(const struct site *site, int interface, bool bare_enough, bool own_enough)
{
    const bool bare = pounds_at(thud_site_bare(site), interface), /* links stand in what is required */
        own = pounds_at(site->own, interface);
    return bare  ? (bare_enough ? "insufficient, because another building pushes them together" : "not enough")
           : own ? (own_enough ? "insufficient with the bumper, because another building pushes them together"
                               : "sufficient without the bumper, insufficient with it")
                 : "enough";
}

/* The gap that is there, and the one that is required, of an interface (from 1). */
static void gap_rows(struct site *site, int i)
{
    const struct thud_interface *f = &site->scene->interface[i - 1];
    char what[200], text[400];
    int level;
    const double needed = site->gap ? thud_needed_gap_widest(site->gap, i, THUD_GAP_EXACT, &level) : NAN;
    const double stands_out = thud_interface_projection(f, NULL);
    snprintf(what, sizeof what, "gap between %.60s and %.60s", thud_site_name(site, i - 1), thud_site_name(site, i));
    if (!(needed >= 0)) {
        snprintf(text, sizeof text, "%.1f cm given", 100 * f->gap_m);
        thud_site_verdict(site, what, text);
        return;
    }
    if (f->gap.n > 0 || (f->has_bumper && f->thickness.n > 0)) { /* each level against its own */
        char given[64];
        int too_small = 0, levels = 0;
        for (int l = 0; l < site->gap->nlevels; l++) {
            const struct thud_level_values at = thud_interface_level(f, thud_needed_gap_level(site->gap->level, l));
            if (site->gap->level[l].interface != i)
                continue;
            levels++;
            too_small += thud_level_clearance(&at) < site->gap->level[l].relative_displacement_m;
        }
        thud_interface_gap_text(f, given, sizeof given);
        if (too_small > 0)
            snprintf(text, sizeof text, "%s given; not enough at %d of %d levels under this motion", given, too_small,
                     levels);
        else
            snprintf(text, sizeof text, "%s given; at every level under this motion %s", given,
                     gap_verdict(site, i, true, true));
        thud_site_verdict(site, what, text);
        return;
    }
    snprintf(text, sizeof text, "%.1f cm given; %.1f cm required between bare faces under this motion", 100 * f->gap_m,
             thud_summary_gap_cm(needed));
    if (stands_out > 0)
        thud_append(text, sizeof text, ", %.1f cm with the bumper between them",
                    thud_summary_gap_cm(needed + stands_out));
    thud_append(text, sizeof text, "%s: %s", site->scene->nstructures > 2 ? ", when nothing else touches" : "",
                gap_verdict(site, i, f->gap_m >= needed, f->gap_m >= needed + stands_out));
    thud_site_verdict(site, what, text);
}

static void pounding_row(struct site *site, const struct site_case *one)
{
    char what[64], text[400], between[320];
    const int n = thud_contacts_sum(one->result, 0).impacts;
    const struct thud_contact_result *most = thud_site_strongest(one->result);
    snprintf(what, sizeof what, "pounding %s", one->words);
    if (!most) {
        snprintf(text, sizeof text, n == 0 ? "none" : "%d impacts, by a law without force", n);
    } else {
        thud_site_sides(site, most->interface, most->left_floor, most->right_floor, most->struck, between,
                        sizeof between);
        snprintf(text, sizeof text, "%d impact%s; at most %s MN, between %s at %.2f s", n, n == 1 ? "" : "s",
                 thud_site_number(1e-6 * most->force.value, 3).text, between, most->force.time_s);
    }
    thud_site_verdict(site, what, text);
}

/* Of a case: what its measure does to floors and storeys. */
static void measure_row(struct site *site, const struct site_case *one)
{
    enum { LOWER, SAME, HIGHER };
    const bool plural = thud_site_is_plural(one);
    char what[64];
    int a[3], d[3];
    char text[300];
    snprintf(what, sizeof what, "effect of the %s", one->measure);
    if (one->scene->nlinks == 0 && !thud_contact_hardest(site->cases[SITE_NONE].result, 0)) {
        bool in_contact = thud_contact_hardest(one->result, 0) != NULL;
        thud_site_verdict(site, what,
                          in_contact ? "unfavourable: there is no contact without it, and it is struck"
                                     : "none: there is no contact without it");
        return;
    }
    thud_site_effect(site, one, false, a);
    thud_site_effect(site, one, true, d);
    const int lower = a[LOWER] + d[LOWER], higher = a[HIGHER] + d[HIGHER];
    snprintf(text, sizeof text,
             "%s%s %s %d of %d floor accelerations and %d of %d storey drifts by more than 2 %%, and %s %d and %d",
             higher == 0 && lower > 0   ? "favourable: "
             : lower == 0 && higher > 0 ? "unfavourable: "
             : lower == 0               ? "none: "
             : lower > higher           ? "mixed, with more peaks lower than higher: "
                                        : "mixed, with no more peaks lower than higher: ",
             plural ? "they" : "it", thud_site_verb(one, "lowers").text, a[LOWER], a[LOWER] + a[SAME] + a[HIGHER],
             d[LOWER], d[LOWER] + d[SAME] + d[HIGHER], thud_site_verb(one, "raises").text, a[HIGHER], d[HIGHER]);
    const struct thud_contact_result *without = thud_site_strongest(site->cases[SITE_NONE].result),
                                     *with = thud_site_strongest(one->result);
    if (without && with)
        thud_append(text, sizeof text, "; the peak force changes from %s MN to %s MN",
                    thud_site_number(1e-6 * without->force.value, 3).text,
                    thud_site_number(1e-6 * with->force.value, 3).text);
    thud_site_verdict(site, what, text);
}

/* Of the scene as written; with which of its cases that is. */
static const char *own_words(const struct site *site, const char *what, char *name, size_t size)
{
    snprintf(name, size, "%s, %s", what, site->own->words);
    return name;
}

/* The floor with the largest acceleration and the storey with the largest drift of the scene as written. */
static void governing_rows(struct site *site)
{
    const struct thud_result *r = site->own->result;
    double most = 0, drift = 0;
    int at[2] = {0, 0}, under[2] = {0, 0};
    char text[300], name[64];
    for (int s = 0; s < r->nstructures; s++) {
        int storey = 0;
        const double ratio = thud_drift_ratio(&site->scene->structure[s], &r->structure[s], false, &storey);
        if (ratio > drift) {
            drift = ratio;
            under[0] = s, under[1] = storey;
        }
        for (int f = 0; site->scene->structure[s].kind != THUD_WALL && f < r->structure[s].floors; f++)
            if (thud_floor_acceleration(r, s, f) > most) {
                most = thud_floor_acceleration(r, s, f);
                at[0] = s, at[1] = f;
            }
    }
    if (most > 0) {
        char floor[THUD_NAME_MAX + 32];
        snprintf(text, sizeof text, "%s g, %s", thud_site_number(most / THUD_GRAVITY, 3).text,
                 thud_site_floor(site, at[0], at[1] + 1, floor, sizeof floor));
        thud_site_verdict(site, own_words(site, "largest acceleration", name, sizeof name), text);
    }
    if (drift > 0) {
        const struct thud_structure_result *b = &r->structure[under[0]];
        const int f = under[1] - 1 + thud_structure_first_storey(&site->scene->structure[under[0]]);
        snprintf(text, sizeof text, "%s mm, %s %% of the height, storey %d of %s",
                 thud_site_number(1e3 * b->floor[f].drift.value, 3).text, thud_site_number(100 * drift, 2).text,
                 under[1], thud_site_name(site, under[0]));
        if (b->storey && b->storey[f].yields)
            thud_append(text, sizeof text, "; ductility %s", thud_site_number(b->storey[f].ductility, 3).text);
        thud_site_verdict(site, own_words(site, "largest drift", name, sizeof name), text);
    }
}

/* What is past its strength in the scene as written. */
static void failing_row(struct site *site)
{
    const struct thud_result *r = site->own->result;
    int yielding = 0, failing = 0, known = 0;
    const int storeys = thud_site_storeys(site, &yielding);
    struct thud_text text = {0};
    for (int k = 0; k < r->ncolumns; k++) {
        known += isfinite(r->column[k].ratio);
        failing += r->column[k].ratio > 1;
    }
    if (storeys > 0)
        thud_text_append(&text, "%d of %d storeys yield", yielding, storeys);
    else
        thud_text_append(&text, "not assessed: the storeys are modelled as elastic");
    if (r->ncolumns > 0 && known > 0)
        thud_text_append(&text, "; the shear of struck columns exceeds their capacity in %d of %d storeys", failing,
                         known);
    else if (r->ncolumns > 0)
        thud_text_append(&text, "; struck columns have no given capacity");
    for (int s = 0; s < r->nstructures; s++)
        if (site->scene->structure[s].kind == THUD_ISOLATED)
            thud_text_append(&text, "; the isolators of %.64s are displaced by up to %s mm", thud_site_name(site, s),
                             thud_site_number(1e3 * r->structure[s].floor[0].drift.value, 3).text);
    site->document.failed |= text.failed;
    thud_site_verdict(site, r->ncolumns > 0 ? "yielding storeys, failing columns" : "yielding storeys",
                      text.data ? text.data : "");
    thud_text_clear(&text);
}

/* The ground motion of the rows, in a suite the load case that it is. */
static void motion_row(struct site *site)
{
    char text[600], peak[96], motion[320], which[96] = "";
    if (!site->record)
        return;
    thud_record_peak_text(site->record, peak, sizeof peak);
    thud_site_motion(site->record, motion, sizeof motion);
    if (site->suite.leads)
        snprintf(which, sizeof which, "load case %d, which %s and governs the rows below: ", site->detail + 1,
                 site->options->detail > 0 ? "was selected" : "needs the widest gap");
    snprintf(text, sizeof text, "%s%.280s, %s", which, motion, peak);
    thud_site_verdict(site, site->suite.leads ? "ground motion shown in detail" : "ground motion", text);
}

void thud_site_verdicts(struct site *site)
{
    thud_document_heading(&site->document, "Verdicts");
    thud_document_table(&site->document, "Summary of results");
    thud_site_verdict(site, "question", "result");
    if (site->suite.leads) {
        thud_site_suite_verdicts(site);
        motion_row(site);
    }
    for (int i = 1; i < site->scene->nstructures; i++)
        gap_rows(site, i);
    for (int i = SITE_NONE; i < site->ncases; i++)
        if (!site->suite.leads || i == SITE_NONE || i + 1 == site->ncases) /* the rows over the suite have them all */
            pounding_row(site, &site->cases[i]);
    for (int i = SITE_MEASURE; i < site->ncases; i++)
        measure_row(site, &site->cases[i]);
    if (site->ncases <= SITE_MEASURE)
        thud_site_verdict(site, "effect of a bumper", "there is none");
    governing_rows(site);
    failing_row(site);
    if (!site->suite.leads)
        motion_row(site);
}

/* ---- every input ---- */

struct inputs {
    struct site *site;
    bool begun;
    char owner[64];   /* "structures.1": the table that is open */
    char section[64]; /* "structures.1.column": whose source has been told */
};

/* Of "structures.1.column" the part with its number, its length. */
static size_t owner_of(const char *section)
{
    size_t n = strcspn(section, ".");
    return section[n] ? n + 1 + strcspn(section + n + 1, ".") : n;
}

/* "structures.2" as "B", "interfaces.1" as "A and B", "record" as "the ground motion". */
static void owner_name(const struct site *site, const char *owner, char *text, size_t size)
{
    int i = 0;
    if (sscanf(owner, "structures.%d", &i) == 1 && i >= 1 && i <= site->scene->nstructures)
        snprintf(text, size, "%.60s", thud_site_name(site, i - 1));
    else if (sscanf(owner, "interfaces.%d", &i) == 1 && i >= 1 && i < site->scene->nstructures)
        snprintf(text, size, "the gap between %.60s and %.60s", thud_site_name(site, i - 1), thud_site_name(site, i));
    else if (sscanf(owner, "links.%d", &i) == 1)
        snprintf(text, size, "link %d", i);
    else
        snprintf(text, size, "%s",
                 !*owner                        ? "the scene"
                 : strcmp(owner, "record") == 0 ? "the ground motion"
                                                : "the analysis");
}

/* A value as it is said: laws and the method by their titles, choices by what they stand for. */
static void add_value(struct inputs *inputs, const char *key, const struct thud_param *param, const char *value)
{
    struct thud_document *d = &inputs->site->document;
    const struct thud_law *law = strcmp(key, "law") == 0 ? thud_law_find(value) : NULL;
    const struct thud_method *method =
        strcmp(key, "method") == 0 ? thud_method_find(inputs->site->own->result->method) : NULL;
    int n = 0;
    const char *words = NULL;
    if (param && param->kind == THUD_PARAM_CHOICE && strcmp(key, "kind") != 0 && strcmp(key, "law") != 0)
        words = thud_site_choice(param, value, &n);
    if (law || method)
        thud_document_cell(d, "%s", law ? law->title : method->title);
    else
        thud_document_cell(d, "%.*s", words ? n : (int)strlen(value), words ? words : value);
}

/* Begins a table for each structure, interface, ..., and in it each group of keys with its source. */
static void begin_section(struct inputs *inputs, const char *section, const char *in_owner)
{
    struct thud_document *d = &inputs->site->document;
    const size_t n = owner_of(section);
    char name[160], caption[200], path[80], source[THUD_SOURCE_MAX];
    if (!inputs->begun || strlen(inputs->owner) != n || strncmp(section, inputs->owner, n) != 0) {
        snprintf(inputs->owner, sizeof inputs->owner, "%.*s", (int)n, section);
        owner_name(inputs->site, inputs->owner, name, sizeof name);
        snprintf(caption, sizeof caption, "Inputs of %s", name);
        thud_document_table(d, caption);
        thud_document_head(d, "input|value|key in the preset");
    }
    inputs->begun = true;
    snprintf(inputs->section, sizeof inputs->section, "%s", section);
    snprintf(path, sizeof path, "%s.source", section);
    if (thud_scene_get(inputs->site->scene, path, source, sizeof source, NULL) == THUD_OK)
        thud_document_line(d, "source\t%s\t%s%ssource", *source ? source : "no source given", in_owner,
                           *in_owner ? "." : "");
}

static void put_input(void *context, const char *section, const char *key, const char *value)
{
    struct inputs *inputs = context;
    struct thud_document *d = &inputs->site->document;
    const size_t n = owner_of(section);
    const char *in_owner = section[n] ? section + n + 1 : "";
    char path[640];
    int floor;
    if (!inputs->begun || strcmp(inputs->section, section) != 0)
        begin_section(inputs, section, in_owner);
    if (strcmp(key, "source") == 0)
        return;
    snprintf(path, sizeof path, "%s%s%s", section, *section ? "." : "", key);
    const struct thud_param *param = thud_scene_param(inputs->site->scene, path, &floor);
    thud_document_cell(d, "%s", param ? param->title : key);
    add_value(inputs, key, param, value);
    thud_document_cell(d, "%s%s%s", in_owner, *in_owner ? "." : "", key);
    thud_document_row(d);
}

void thud_site_inputs(struct site *site)
{
    struct inputs inputs = {.site = site};
    thud_document_heading(&site->document, "Inputs");
    if (thud_preset_each(site->scene, &inputs, put_input) != THUD_OK)
        site->document.failed = true;
}
