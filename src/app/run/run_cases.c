#include "app/run/run_cases.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/figure_files.h"
#include "app/run/result_table.h"
#include "app/run/summary_line.h"
#include "base/ascii.h"
#include "ground/identity.h"
#include "io/file/schema.h"
#include "study/scene/level.h"
#include "study/scene/solution.h"
#include "study/sweep/remark.h"

/* ---- the runs ---- */

static enum thud_status parse(const char *text, struct thud_run_cases *cases, struct thud_error *err)
{
    enum thud_case which[THUD_CASES_MAX];
    struct thud_error why = {0};
    int n = 0;
    cases->item[0].which = THUD_CASE_FREE;
    cases->n = 1;
    if (thud_cases_parse(text, which, &n, &why) != THUD_OK)
        return thud_error_refuse(err, THUD_USAGE, "cases", why.allowed, "%s", why.what);
    for (int i = 0; i < n && cases->n < THUD_RUN_CASES_MAX; i++)
        cases->item[cases->n++].which = which[i];
    return THUD_OK;
}

/* Whether a case is run with (without) the links of the scene. */
static bool has_linkage(const struct thud_run_cases *cases, bool linked)
{
    for (int i = 1; i < cases->n; i++)
        if (thud_case_has_links(cases->item[i].which) == linked)
            return true;
    return false;
}

/* Without links where a case goes without them. */
static enum thud_status run_free(struct thud_session *session, const struct thud_run_cases *cases,
                                 const struct thud_run_options *options, struct thud_run_case *item,
                                 struct thud_error *err)
{
    struct thud_scene *scene = &item->scene;
    enum thud_status status = thud_session_case(session, THUD_CASE_FREE, scene, err);
    if (status == THUD_OK && has_linkage(cases, false))
        status = thud_scene_case(scene, THUD_CASE_NONE, scene, err);
    return status == THUD_OK ? thud_scene_solve(scene, session->record, options, &item->solution, err) : status;
}

/* Of the scene as written; and without its links where a case leaves them out. */
static enum thud_status find_needs(const struct thud_session *session, struct thud_run_cases *cases,
                                   struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    const bool links = session->scene.nlinks > 0;
    if (!links || has_linkage(cases, true))
        status = thud_needed_gap_run(&session->scene, session->record, &cases->need, err);
    if (status != THUD_OK || !links || !has_linkage(cases, false))
        return status;
    struct thud_scene *bare = malloc(sizeof *bare);
    if (!bare)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    status = thud_scene_case(&session->scene, THUD_CASE_NONE, bare, err);
    if (status == THUD_OK)
        status = thud_needed_gap_run(bare, session->record, &cases->need_without_links, err);
    free(bare);
    return status;
}

enum thud_status thud_run_cases_make(struct thud_session *session, const char *text,
                                     const struct thud_run_options *options, struct thud_run_cases **out,
                                     struct thud_error *err)
{
    struct thud_run_cases *cases = calloc(1, sizeof *cases);
    *out = NULL;
    if (!cases)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    cases->measures = thud_scene_measures(&session->scene);
    enum thud_status status = parse(text, cases, err);
    if (status == THUD_OK)
        status = run_free(session, cases, options, &cases->item[0], err);
    for (int i = 1; i < cases->n && status == THUD_OK; i++)
        status = thud_session_run(session, cases->item[i].which, options, &cases->item[i].scene,
                                  &cases->item[i].solution, err);
    if (status == THUD_OK)
        status = find_needs(session, cases, err);
    cases->record = session->record;
    if (status != THUD_OK) {
        thud_run_cases_free(cases);
        return status;
    }
    *out = cases;
    return THUD_OK;
}

void thud_run_cases_free(struct thud_run_cases *cases)
{
    for (int i = 0; cases && i < cases->n; i++)
        thud_solution_clear(&cases->item[i].solution);
    free(cases ? cases->need : NULL);
    free(cases ? cases->need_without_links : NULL);
    free(cases);
}

static const char *title_of(const struct thud_run_cases *cases, int i)
{
    return cases->item[i].which == THUD_CASE_FREE ? thud_case_free_title(cases->item[i].scene.nlinks > 0)
                                                  : thud_case_title(cases->measures, cases->item[i].which);
}

int thud_run_cases_sources(const struct thud_run_cases *cases, struct thud_figure_source *source)
{
    for (int i = 0; i < cases->n; i++)
        source[i] = thud_run_source(title_of(cases, i), cases->item[i].which, &cases->item[i].scene,
                                    cases->item[i].solution.run);
    return cases->n;
}

/* ---- the table ---- */

static const struct thud_result *result_of(const struct thud_run_cases *cases, int i)
{
    return thud_run_result(cases->item[i].solution.run);
}

/* Peaks that are compared, a table each: of floors, of the storeys below them, and of what has no storeys, isolators
 * and walls. */
enum peak { ACCELERATION, DRIFT, ISOLATOR, DEFLECTION, PEAKS };

static double peak(const struct thud_run_cases *cases, int i, int structure, int floor, enum peak of)
{
    const struct thud_floor_result *f = &result_of(cases, i)->structure[structure].floor[floor];
    if (of == ACCELERATION && thud_floor_struck(result_of(cases, i), structure, floor))
        return NAN; /* an impulse has no finite one */
    return of == ACCELERATION ? f->acceleration.value : 1e3 * f->drift.value;
}

/* The rows of a structure that have such a peak, from row `first` up; returns how many. */
static int rows_of(const struct thud_run_cases *cases, int structure, enum peak of, int *first)
{
    const struct thud_structure *p = &cases->item[0].scene.structure[structure];
    const int floors = result_of(cases, 0)->structure[structure].floors;
    *first = of == DRIFT ? thud_structure_first_storey(p) : 0;
    switch (of) {
    case ISOLATOR:
        return p->kind == THUD_ISOLATED;
    case DEFLECTION:
        return p->kind == THUD_WALL ? floors : 0;
    default:
        return floors - *first;
    }
}

/* Index of case `none`; 0 where it was not asked for. */
static int without(const struct thud_run_cases *cases)
{
    for (int i = 1; i < cases->n; i++)
        if (cases->item[i].which == THUD_CASE_NONE)
            return i;
    return 0;
}

static double ratio(double a, double b)
{
    return b > 0 ? a / b : NAN;
}

/* The peaks of a structure, from the top down. */
struct peaks {
    const struct thud_run_cases *cases;
    int structure, first, n;
    enum peak of;
};
struct peak_row {
    int number; /* of the floor or storey, from 1; isolators: none */
    double value[THUD_RUN_CASES_MAX], ratio[THUD_RUN_CASES_MAX];
};

static void make_peaks(const void *of, int i, void *out)
{
    const struct peaks *p = of;
    const struct thud_run_cases *cases = p->cases;
    struct peak_row *row = out;
    const int s = p->structure, floor = p->first + p->n - 1 - i, none = without(cases);
    row->number = p->of == ACCELERATION || p->of == DRIFT ? p->n - i : THUD_NO_COUNT;
    for (int c = 0; c < cases->n; c++) {
        row->value[c] = peak(cases, c, s, floor, p->of);
        row->ratio[c] = ratio(row->value[c], peak(cases, none, s, floor, p->of));
    }
}

static void put_structure(const struct thud_run_cases *cases, int s, enum peak of, struct thud_text *out)
{
    static const char *const heading[] = {"total acceleration, m/s2", "interstorey drift, mm",
                                          "isolator displacement, mm", "deflection, mm"};
    struct peaks peaks = {.cases = cases, .structure = s, .of = of};
    int none = without(cases), n = 1;
    const char *numbered = of == ACCELERATION ? "floor" : "";
    struct thud_column column[2 * THUD_RUN_CASES_MAX] = {
        {THUD_COLUMN(struct peak_row, number, "", ""), .shown = {numbered, .width = 5, .how = THUD_DIGITS_WORD}}};
    char head[THUD_RUN_CASES_MAX][24];
    peaks.n = rows_of(cases, s, of, &peaks.first);
    if (peaks.n == 0)
        return;
    for (int i = 0; i < cases->n; i++) {
        const char *title = title_of(cases, i);
        const int width = (cases->measures & THUD_HAS_LINKS ? 2 : 1) + (int)strlen(title);
        column[n++] = (struct thud_column){THUD_COLUMN(struct peak_row, value[i], "", ""),
                                           .shown = {title, NULL, 1, width < 10 ? 10 : width, 4, THUD_DIGITS_FREE}};
    }
    for (int i = 1; none && i < cases->n; i++)
        if (i != none) {
            snprintf(head[i], sizeof head[i], "%s:none", thud_case_name(cases->item[i].which));
            column[n++] = (struct thud_column){THUD_COLUMN(struct peak_row, ratio[i], "", ""),
                                               .shown = {head[i], NULL, 1, 12, 3, THUD_DIGITS_FIXED}};
        }
    const struct thud_schema schema = {"", "", column, n};
    thud_text_append(out, "\n%s, %s\n", cases->item[0].scene.structure[s].name, heading[of]);
    thud_rows_table(&(struct thud_rows){&schema, 0, peaks.n, make_peaks, &peaks}, out);
}

/* "floor 4 of A and the columns below floor 5 of B"; `left`: the structures of the interface. */
static void put_struck(const struct thud_structure *left, int left_floor, int right_floor, int struck,
                       struct thud_text *out)
{
    bool by_left = thud_slab_is_left(left_floor, struck);
    thud_text_append(out, "floor %d of %s and the columns below floor %d of %s", by_left ? left_floor : right_floor,
                     left[by_left ? 0 : 1].name, by_left ? right_floor : left_floor, left[by_left ? 1 : 0].name);
}

/* "floor 4", "the base slab": where slabs meet; `left`: the structures of the interface. */
static const char *meet_at(const struct thud_structure *left, int left_floor, int right_floor, char text[24])
{
    const struct thud_structure *own = left + (left_floor == 0);
    const int floor = thud_slab_floor(left_floor, right_floor, 0) - 1;
    return thud_structure_storey(own, floor) == 0 ? "the base slab"
                                                  : thud_structure_level_name(own, floor, false, text);
}

/* Writes "Without the bumper: 12 impacts; peak force 20.2 MN at floor 4, 7.094 s." */
static void say_contacts(const struct thud_run_cases *cases, int i, struct thud_text *out)
{
    const int impacts = thud_contacts_sum(result_of(cases, i), 0).impacts;
    char level[24], number[32];
    const struct thud_contact_result *most = thud_contact_hardest(result_of(cases, i), 0);
    char how[64];
    snprintf(how, sizeof how, "%s", thud_case_phrase(cases->measures, cases->item[i].which));
    how[0] = thud_ascii_upper(how[0]);
    struct thud_error fall;
    if (thud_collapse_remark(&cases->item[i].scene, &result_of(cases, i)->collapse, &fall))
        thud_text_append(out, "%s %s.\n", how, fall.what);
    if (!most) {
        thud_text_append(out, "%s: no contact.\n", how);
        return;
    }
    const struct thud_structure *left = &cases->item[i].scene.structure[most->interface - 1];
    thud_text_append(out, "%s: %d impact%s", how, impacts, impacts == 1 ? "" : "s");
    if (most->force.value > 0) {
        thud_text_append(out, "; peak force %s MN between ", thud_digits(1e-6 * most->force.value, 4, number));
        if (most->struck != 0)
            put_struck(left, most->left_floor, most->right_floor, most->struck, out);
        else
            thud_text_append(out, "%s and %s at %s", left->name, left[1].name,
                             meet_at(left, most->left_floor, most->right_floor, level));
        thud_text_append(out, ", %.3f s", most->force.time_s);
    }
    int none = without(cases);
    const struct thud_contact_result *bare = none && none != i ? thud_contact_hardest(result_of(cases, none), 0) : NULL;
    if (bare && bare->force.value > 0)
        thud_text_append(out, " (%s relative to %s)", thud_change_text(most->force.value / bare->force.value, number),
                         thud_case_title(cases->measures, cases->item[none].which));
    thud_text_append(out, ".\n");
}

/* The floors (storeys) whose acceleration (drift) is less, or more, by over 1 % than without the bumper. */
static void say_floors(const struct thud_run_cases *cases, int i, bool more, enum peak peaks, struct thud_text *out)
{
    int none = without(cases), n = 0, first;
    struct thud_text list = {0};
    for (int s = 0; s < result_of(cases, 0)->nstructures; s++)
        for (int k = 0, rows = rows_of(cases, s, peaks, &first); k < rows; k++) {
            double change = ratio(peak(cases, i, s, first + k, peaks), peak(cases, none, s, first + k, peaks)) - 1;
            char percent[32];
            if (more ? change > 0.01 : change < -0.01)
                thud_text_append(&list, "%s%s\t%d\t(%s)", n++ ? ", " : "", cases->item[0].scene.structure[s].name,
                                 k + 1, thud_change_text(1 + change, percent));
        }
    const char *what = peaks == DRIFT ? "drifts" : "accelerations", *of = peaks == DRIFT ? "storeys" : "floors";
    const char *ending, *subject = thud_case_subject(cases->measures, cases->item[i].which, &ending),
                        *verb = more ? "raise" : "lower";
    if (n > 0 && !list.failed)
        thud_text_append(out, "The %s %s%s the %s of %s %s.\n", subject, verb, ending, what, of, list.data);
    else
        thud_text_append(out, "The %s %s%s no %s by more than 1 %%.\n", subject, verb, ending, what);
    out->failed |= list.failed;
    thud_text_clear(&list);
}

/* A building that collapses without contact is helped by no gap. `links`: which motion it is of. */
static void say_needs(const struct thud_scene *scene, const struct thud_needed_gap *gap, const char *links,
                      struct thud_text *out)
{
    const struct thud_collapse *fall = &gap->collapse;
    char name[24];
    if (fall->happened) {
        const struct thud_structure *s = &scene->structure[fall->structure];
        thud_text_append(out, "%sStorey %d of %s collapses without contact at %.3f s; no gap prevents it.\n", links,
                         thud_structure_storey(s, fall->floor), s->name, fall->time_s);
    }
    for (int i = 0; i + 1 < scene->nstructures; i++) {
        int decides = -1;
        const double need_m = thud_needed_gap_widest(gap, i + 1, THUD_GAP_EXACT, &decides);
        if (!(need_m > 0))
            continue;
        const struct thud_gap_level *level = &gap->level[decides];
        const struct thud_level_values at =
            thud_interface_level(&scene->interface[i], thud_needed_gap_level(gap->level, decides));
        thud_text_append(out, "%s%s%s and %s do not collide at gaps of %.4g cm or more (here %.4g cm); ", links,
                         fall->happened ? "Until then " : "", scene->structure[i].name, scene->structure[i + 1].name,
                         thud_table_gap_cm(need_m), 100 * at.gap_m);
        if (level->struck != 0)
            put_struck(&scene->structure[i], level->left_floor, level->right_floor, level->struck, out);
        else
            thud_text_append(out, "%s", meet_at(&scene->structure[i], level->left_floor, level->right_floor, name));
        thud_text_append(out, " govern%s.\n", level->struck ? "" : "s");
    }
}

/* Whether a bumper is all that two cases differ by, and neither comes to a contact: then no peak is another one. */
static bool moves_alike(const struct thud_run_cases *cases, int a, int b)
{
    return !thud_contact_hardest(result_of(cases, a), 0) && !thud_contact_hardest(result_of(cases, b), 0) &&
           cases->item[a].scene.nlinks == cases->item[b].scene.nlinks;
}

/* What the links of a case bear, which is no force of a contact. */
static void say_links(const struct thud_run_cases *cases, int i, struct thud_text *out)
{
    const struct thud_scene *scene = &cases->item[i].scene;
    const struct thud_link_result *most = thud_link_hardest(scene, result_of(cases, i));
    char name[2 * THUD_NAME_MAX], number[32];
    if (!most)
        return;
    thud_link_name(scene, (int)(most - result_of(cases, i)->link), name, sizeof name);
    thud_text_append(out, "  Largest link force: %s, %s MN at %.3f s.\n", name,
                     thud_digits(1e-6 * most->force.value, 4, number), most->force.time_s);
}

void thud_run_cases_table(const struct thud_run_cases *cases, struct thud_text *out)
{
    const struct thud_scene *scene = &cases->item[0].scene;
    int none = without(cases);
    struct thud_text title = {0};
    thud_text_append(&title, "%s: %s", scene->name, scene->title);
    thud_table_words(out, "", &title, 2);
    char peak[96];
    if (cases->record) {
        thud_record_peak_text(cases->record, peak, sizeof peak);
        thud_text_append(out, "ground motion %s%s, %s\n", scene->record.file, thud_record_synthetic_mark(cases->record),
                         peak);
    }
    for (int s = 0; s < scene->nstructures; s++)
        for (int of = 0; of < PEAKS; of++)
            put_structure(cases, s, (enum peak)of, out);
    struct thud_text said = {0};
    thud_text_append(out, "\n");
    for (int i = 1; i < cases->n; i++) {
        say_contacts(cases, i, &said);
        say_links(cases, i, &said);
    }
    for (int i = 1; none && i < cases->n; i++)
        for (int k = 0; k < 4 && i != none && !moves_alike(cases, i, none); k++)
            say_floors(cases, i, k % 2 == 1, k < 2 ? ACCELERATION : DRIFT, &said);
    const bool links = cases->need_without_links != NULL;
    if (links)
        say_needs(scene, cases->need_without_links, "Without the links: ", &said);
    if (cases->need)
        say_needs(scene, cases->need, links ? "With the links: " : "", &said);
    thud_table_lines(out, &said, 2);
}
