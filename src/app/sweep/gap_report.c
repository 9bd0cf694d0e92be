#include "app/sweep/gap_report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/result_table.h"
#include "app/run/summary_line.h"
#include "ground/identity.h"
#include "io/file/json.h"
#include "io/result/result_rows.h"
#include "io/result/study_rows.h"
#include "io/result/sweep_csv.h"
#include "study/scene/building.h"
#include "study/scene/level.h"
#include "study/suite/suite.h"

/* "2-3", "wall-1", "2-c3" */
static const char *floors(const struct thud_gap_level *level, char text[24])
{
    thud_contact_pair_name(level->left_floor, level->right_floor, level->struck, text, 24);
    return text;
}

enum { NAME = 25 };

static void put_head(const char *first, int width, const char *last, struct thud_text *out)
{
    thud_text_padded(out, first, width);
    for (int rule = THUD_GAP_EXACT; rule < THUD_GAP_SHORT; rule++)
        thud_text_append(out, " %7s", thud_gap_rule_at(rule)->name);
    thud_text_append(out, "%s%s\n", *last ? " " : "", last);
}

static void put_gap(struct thud_text *out, double gap_m)
{
    if (isnan(gap_m))
        thud_text_append(out, " %7s", "-");
    else
        thud_text_append(out, " %7.2f", thud_table_gap_cm(gap_m));
}

static void put_records(const struct thud_gap_suite *suite, struct thud_text *out)
{
    char text[24];
    put_head("widest of all levels (cm)", NAME, "at", out);
    for (int r = 0; r < suite->nrecords; r++) {
        int level = 0;
        thud_text_padded(out, suite->record[r], NAME);
        for (int rule = THUD_GAP_EXACT; rule < THUD_GAP_SHORT; rule++)
            put_gap(out, thud_needed_gap_widest(suite->gap[r], 0, rule, NULL));
        thud_needed_gap_widest(suite->gap[r], 0, THUD_GAP_EXACT, &level);
        thud_text_append(out, " %s\n", floors(&suite->gap[r]->level[level], text));
    }
}

enum { WHATS = 5 };

/* Fractiles of every rule at a level. */
static enum thud_status fractiles(const struct thud_gap_suite *suite, int level,
                                  struct thud_fractiles f[THUD_GAP_RULES + 1], struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int rule = THUD_GAP_EXACT; rule < THUD_GAP_RULES && status == THUD_OK; rule++)
        status = thud_gap_suite_fractiles(suite, 0, level, rule, &f[rule + 1], err);
    return status;
}

static void put_suite(const struct thud_fractiles f[THUD_GAP_RULES + 1], struct thud_text *out)
{
    static const double share[] = {0.16, 0.5, 0.84};
    for (int w = 0; w < WHATS; w++) {
        char what[64] = "less than needed, share";
        if (w != 1 && w < 3 && isnan(f[0].p16)) /* of so few motions there is a median alone */
            continue;
        if (w < 3) /* as thud_enough counts */
            snprintf(what, sizeof what, "for %.0f of %zu (%.0f %%)", fmax(1, ceil(share[w] * (double)f[0].n - 1e-9)),
                     f[0].n, 100 * share[w]);
        thud_text_append(out, "%-26s", w == 3 ? "largest" : what);
        for (int i = 0; i <= THUD_GAP_SHORT; i++) {
            double x = w == 0 ? f[i].p16 : w == 1 ? f[i].median : w == 2 ? f[i].p84 : w == 3 ? f[i].most : f[i].share;
            if (w == 4 && i == 0)
                thud_text_append(out, " %7s", "");
            else if (w == 4 && !isnan(x))
                thud_text_append(out, " %5.0f %%", 100 * x);
            else
                put_gap(out, x);
        }
        thud_text_append(out, "\n");
    }
}

static void put_levels(const struct thud_gap_suite *suite, const struct thud_fractiles f[THUD_GAP_RULES + 1], int level,
                       struct thud_text *out)
{
    const struct thud_gap_level *l = &suite->gap[0]->level[level];
    char text[24], name[48];
    snprintf(name, sizeof name, "interface %d, floors %s", l->interface, floors(l, text));
    thud_text_append(out, "%-26s", name);
    for (int i = 0; i <= THUD_GAP_SHORT; i++)
        put_gap(out, f[i].median);
    thud_text_append(out, "\n");
}

/* The projection of a bumper. */
static void put_bumpers(const struct thud_scene *scene, struct thud_text *out)
{
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        double least;
        const double most = thud_interface_projection(&scene->interface[i], &least);
        if (most > least)
            thud_text_append(
                out,
                "The bumper at interface %d projects %.2f to %.2f cm by level; add this to the required gap "
                "of each.\n",
                i + 1, 100 * least, 100 * most);
        else if (scene->interface[i].has_bumper)
            thud_text_append(out, "The bumper at interface %d projects %.2f cm; add this to the required gap.\n", i + 1,
                             100 * most);
    }
}

void thud_gap_collapse(const struct thud_scene *scene, const struct thud_collapse *fall, const char *before,
                       struct thud_text *out)
{
    const struct thud_structure *s = &scene->structure[fall->structure];
    thud_text_append(out,
                     "%s %d of %.40s collapses without contact at %.3f s: what is needed is the gap\n"
                     "until then, and no gap prevents it.\n",
                     before, thud_structure_storey(s, fall->floor), s->name, fall->time_s);
}

static void put_collapses(const struct thud_gap_suite *suite, const struct thud_scene *scene, struct thud_text *out)
{
    int n = 0, first = 0;
    for (int r = suite->nrecords - 1; r >= 0; r--)
        if (suite->gap[r]->collapse.happened) {
            n++;
            first = r;
        }
    if (n == 0)
        return;
    const char *name = thud_path_name(suite->record[first]);
    if (suite->nrecords > 1)
        thud_text_append(out, "Under %d of the %d ground motions a storey collapses without contact, first under %s:\n",
                         n, suite->nrecords, name);
    thud_gap_collapse(scene, &suite->gap[first]->collapse, suite->nrecords > 1 ? "storey" : "Storey", out);
}

/* "A (0.25 to 0.49 s)" */
static void put_period(const struct thud_structure *s, const char *before, struct thud_text *out)
{
    const double period = s->period_factor * thud_structure_estimate(s).en1998_s;
    thud_text_append(out, "%s%.40s (%.3g to %.3g s)", before, s->name, THUD_ESTIMATE_LEAST * period,
                     THUD_ESTIMATE_MOST * period);
}

static void put_ranges(const struct thud_gap_study *study, const struct thud_scene *scene, struct thud_text *out)
{
    for (int i = 0; i < study->nranges; i++) {
        const struct thud_gap_range *x = &study->range[i];
        const struct thud_structure *left = &scene->structure[x->interface - 1], *right = left + 1;
        const bool both = thud_period_is_estimated(left) && thud_period_is_estimated(right);
        thud_text_append(out, "\nNeeds %.1f to %.1f cm, depending on the period of ", thud_summary_gap_cm(x->least_m),
                         thud_summary_gap_cm(x->most_m));
        if (thud_period_is_estimated(left))
            put_period(left, "", out);
        if (thud_period_is_estimated(right))
            put_period(right, both ? "\nand that of " : "", out);
        thud_text_append(out, ",\n%g to %g times as estimated; most at ", THUD_ESTIMATE_LEAST, THUD_ESTIMATE_MOST);
        if (thud_period_is_estimated(left))
            thud_text_append(out, "%.3g", x->left_factor);
        if (thud_period_is_estimated(right))
            thud_text_append(out, "%s%.3g", both ? " and " : "", x->right_factor);
        thud_text_append(out, " times.\n");
    }
}

static void put_row(const struct thud_gap_study *study, struct thud_text *out)
{
    if (!study->row)
        return;
    thud_text_append(out, "\n%-26s %16s %16s\n", "in the row (cm)", "others as given", "all together");
    for (int i = 0; i < study->nrow; i++) {
        thud_text_append(out, "interface %-16d %8s", study->row[i].interface, "");
        put_gap(out, study->row[i].others_as_given_m);
        thud_text_append(out, " %8s", "");
        put_gap(out, study->row[i].all_together_m);
        thud_text_append(out, "\n");
    }
    thud_text_append(out,
                     "Others as given: the gap that prevents contact here while the others keep\n"
                     "their gaps and may pound; %d runs with it open. All together: no contact at\n"
                     "these gaps.\n",
                     study->row_runs);
}

/* ---- by rule ---- */

enum { WIDTH = 80, INDENT = 10 };

static void put_rule(const struct thud_gap_study *study, int rule, int interface, struct thud_text *out)
{
    const struct thud_gap_rule *r = thud_gap_rule_at(rule);
    const struct thud_gap_ruled *x = &study->ruled[(rule + 1) * study->interfaces + interface];
    struct thud_text numbers = {0};
    char title[128], count[32];
    snprintf(title, sizeof title, "%s%s%s%s%s", r->edition, *r->edition ? ", " : "", r->clause, *r->clause ? ": " : "",
             r->title);
    thud_text_append(out, "%-9s %-42s", r->name, title);
    if (isnan(x->gap_m)) {
        thud_text_append(out, " %8s\n%*s%s\n", "-", INDENT, "", r->lacks);
        return;
    }
    snprintf(count, sizeof count, "%d of %d", x->pounding, study->suite.nrecords);
    thud_text_append(out, " %8.1f %9s", 10 * thud_table_gap_cm(x->gap_m), count);
    if (x->pounding > 0 && isnan(x->force_n))
        thud_text_append(out, " %7s", "-");
    else if (x->pounding > 0)
        thud_text_append(out, " %7.3g", 1e-6 * x->force_n);
    thud_text_append(out, "\n");
    if (rule == THUD_GAP_EXACT)
        return;
    thud_gap_numbers(&x->level, rule, &numbers);
    bool fits = numbers.data && INDENT + strlen(r->formula) + 3 + strlen(numbers.data) <= WIDTH;
    thud_text_append(out, "%*s%s%s", INDENT, "", r->formula, fits ? " " : "\n");
    thud_text_append(out, "%*s= %s\n", fits ? 0 : INDENT, "", numbers.data ? numbers.data : "");
    thud_text_clear(&numbers);
}

static void put_rules(const struct thud_gap_study *study, const struct thud_scene *scene, struct thud_text *out)
{
    const char *before = "";
    const int n = study->suite.nrecords;
    for (int i = 0; i < study->interfaces; i++) {
        char head[64] = "by rule";
        if (study->ruled[i].gap_m < 0)
            continue;
        if (study->interfaces > 1)
            snprintf(head, sizeof head, "by rule, interface %d", i + 1);
        thud_text_append(out, "\n%-52s %8s %9s %7s\n", head, "mm", "pounds in", "MN");
        for (int rule = THUD_GAP_EXACT; rule < THUD_GAP_RULES; rule++)
            put_rule(study, rule, i, out);
    }
    if (n > 1)
        thud_text_append(out, "\nuL and uR: %s of the %d ground motions%s.\n",
                         thud_gap_suite_means(&study->suite, THUD_GAP_EXACT) ? "means" : "largest", n,
                         thud_gap_suite_means(&study->suite, THUD_GAP_EXACT) !=
                                 thud_gap_suite_means(&study->suite, THUD_GAP_ASCE7)
                             ? ", of ASCE 7 the largest (16.2.2)"
                             : "");
    else
        thud_text_append(out, "\nuL and uR: largest displacements of the two sides.\n");
    struct thud_text words = {0};
    thud_text_append(
        &words, "Pounds in, MN: motions with contact at that gap%s%s, largest force%s.",
        thud_scene_has_measure(scene) ? " " : "",
        thud_scene_has_measure(scene) ? thud_case_phrase(thud_scene_measures(scene), thud_scene_bare(scene)) : "",
        study->interfaces > 1 ? "; the other interfaces have the gaps of the same rule" : "");
    thud_table_words(out, "", &words, 2);
    for (int rule = 0; rule < THUD_GAP_RULES; rule++)
        if (*thud_gap_rule_at(rule)->source) {
            thud_text_append(out, "%s%s", before, thud_gap_rule_at(rule)->name);
            before = ", ";
        }
    thud_text_append(out, ": implemented from secondary sources; check the clause.\n");
}

enum thud_status thud_gap_report(const struct thud_gap_study *study, const struct thud_scene *scene,
                                 struct thud_text *out, struct thud_error *err)
{
    const struct thud_gap_suite *suite = &study->suite;
    struct thud_fractiles f[THUD_GAP_RULES + 1];
    enum thud_status status = fractiles(suite, -1, f, err);
    put_records(suite, out);
    if (status == THUD_OK && suite->nrecords > 1) {
        thud_text_append(out, "\n");
        put_suite(f, out);
        thud_text_append(out, "\nA gap of %.1f cm is enough for %zu of the %d ground motions",
                         thud_summary_gap_cm(f[0].median), f[0].half, suite->nrecords);
        if (f[0].most84 < f[0].n && f[0].most84 > f[0].half)
            thud_text_append(out, ", %.1f cm for %zu of them", thud_summary_gap_cm(f[0].p84), f[0].most84);
        thud_text_append(out, f[0].half < f[0].n ? ",\n%.1f cm for all.\n" : ".\n", thud_summary_gap_cm(f[0].most));
    }
    put_ranges(study, scene, out);
    put_bumpers(scene, out);
    put_collapses(suite, scene, out);
    thud_text_append(out, "\n");
    put_head(suite->nrecords > 1 ? "medians by level (cm)" : "by level (cm)", NAME, "", out);
    for (int l = 0; l < suite->gap[0]->nlevels && status == THUD_OK; l++) {
        status = fractiles(suite, l, f, err);
        if (status == THUD_OK)
            put_levels(suite, f, l, out);
    }
    put_row(study, out);
    put_rules(study, scene, out);
    return status;
}

/* ---- rows ---- */

static void make_level(const void *of, int i, void *row)
{
    const struct thud_gap_study *study = of;
    const int n = study->gap[0]->nlevels, r = i / n;
    *(struct thud_need_fields *)row =
        thud_need_fields_of(&study->gap[r]->level[i % n], r < study->records->n ? study->records->record[r]->file : "");
}

struct thud_rows thud_gap_level_rows(const struct thud_gap_study *study)
{
    return (struct thud_rows){&thud_need_schema, THUD_NEED_RECORD | THUD_NEED_CODES,
                              study->suite.nrecords * study->gap[0]->nlevels, make_level, study};
}

/* The i-th rule that has a value at its interface, and how many there are from it on. */
static int rules_from(const struct thud_gap_study *study, int i, int *interface, int *rule)
{
    int n = 0;
    for (int k = 0; k < study->interfaces; k++)
        for (int r = THUD_GAP_EXACT; r < THUD_GAP_RULES; r++)
            if (study->ruled[(r + 1) * study->interfaces + k].gap_m >= 0 && n++ == i) {
                *interface = k;
                *rule = r;
            }
    return n - i;
}

static void make_rule(const void *of, int i, void *row)
{
    const struct thud_gap_study *study = of;
    struct thud_gap_rule_row *to = row;
    struct thud_text numbers = {0};
    int k = 0, rule = 0;
    rules_from(study, i, &k, &rule);
    *to = (struct thud_gap_rule_row){k + 1,
                                     study->suite.nrecords,
                                     to->text,
                                     *thud_gap_rule_at(rule),
                                     study->ruled[(rule + 1) * study->interfaces + k],
                                     ""};
    thud_gap_numbers(&to->found.level, rule, &numbers);
    snprintf(to->text, sizeof to->text, "%s", numbers.data ? numbers.data : "");
    thud_text_clear(&numbers);
}

struct thud_rows thud_gap_rule_rows(const struct thud_gap_study *study)
{
    int k = 0, rule = 0;
    return (struct thud_rows){&thud_gap_rule_schema, 0, rules_from(study, 0, &k, &rule), make_rule, study};
}

static enum thud_status put_json_suite(const struct thud_gap_study *study, struct thud_text *out,
                                       struct thud_error *err)
{
    struct thud_fractiles f[THUD_GAP_RULES + 1];
    for (int l = -1; l < study->gap[0]->nlevels; l++) {
        enum thud_status status = fractiles(&study->suite, l, f, err);
        if (status != THUD_OK)
            return status;
        f[0].share = 0;
        thud_text_append(out, l < 0 ? "\n  {\"level\": null" : ",\n  {\"level\": %d", l + 1);
        for (int rule = THUD_GAP_EXACT; rule < THUD_GAP_RULES; rule++) {
            thud_text_append(out, ",\n   \"%s\": ", thud_gap_rule_at(rule)->column);
            thud_json_object(&thud_gap_fractile_schema, 0, &f[rule + 1], out);
        }
        thud_text_append(out, "}");
    }
    return THUD_OK;
}

enum thud_status thud_gap_json(const struct thud_gap_study *study, const struct thud_scene *scene,
                               struct thud_text *out, struct thud_error *err)
{
    const struct thud_record_list *records = study->records;
    const struct thud_rows levels = thud_gap_level_rows(study), rules = thud_gap_rule_rows(study);
    const struct thud_array ranges = {study->range, sizeof *study->range}, rowed = {study->row, sizeof *study->row};
    thud_text_append(out, "{");
    thud_json_head(out, scene->name);
    thud_text_append(out, ",\n \"records\": [");
    for (int i = 0; i < levels.n; i++) {
        const int n = study->gap[0]->nlevels, r = i / n;
        struct thud_row_room row;
        if (i % n == 0) {
            thud_text_append(out, "%s\n  {\"record\": ", i > 0 ? "]}," : "");
            if (r < records->n)
                thud_record_json(records->record[r], out);
            else
                thud_text_append(out, "null");
            thud_text_append(out, ", \"levels\": [");
        }
        levels.make(study, i, row.bytes);
        thud_text_append(out, i % n ? ",\n    " : "\n    ");
        thud_json_object(levels.schema, THUD_NEED_CODES, row.bytes, out);
    }
    thud_text_append(out, "]}],\n \"suite\": [");
    enum thud_status status = put_json_suite(study, out, err);
    thud_text_append(out, "]");
    thud_json_list("rules", &rules, out);
    if (study->range)
        thud_json_list("periods",
                       &(struct thud_rows){&thud_gap_range_schema, 0, study->nranges, thud_array_row, &ranges}, out);
    if (study->row) {
        thud_json_list("row", &(struct thud_rows){&thud_gap_row_schema, 0, study->nrow, thud_array_row, &rowed}, out);
        thud_text_append(out, ", \"row_runs\": %d", study->row_runs);
    }
    thud_remarks_json(&(struct thud_remark_scope){.scene = scene,
                                                  .record = (const struct thud_record *const *)records->record,
                                                  .nrecords = records->n},
                      THUD_REMARKS_OF_INPUT, out);
    thud_text_append(out, "}\n");
    return status;
}
