/* The designs of the session, a row each: gone to, chosen to compare with, named (and saved so), marked for the report,
 * forgotten. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/run/command.h"
#include "app/run/summary_line.h"
#include "app/sweep/sweep_jobs.h"
#include "study/suite/suite.h"
#include "tui/document/motions.h"
#include "tui/document/session_log.h"
#include "tui/loop/loop.h"

struct list {
    int at, top;                     /* the row with the cursor, and the first shown */
    int motions;                     /* the results are the largest over so many; 0: of the scene's own */
    struct thud_record_list records; /* those motions; the design that is run over them, by its place, and its points */
    struct thud_sweep_plan plan;
    struct thud_suite *suite;
    struct thud_sweep_work *work; /* NULL: nothing is running */
    int next, number;
};

/* The state on the screen, also while it is being run or where live is off; NULL: there is no room for it. */
static struct thud_design *present(struct thud_tui *tui)
{
    const char *what = thud_undo_what(&tui->doc.undo, 0);
    return thud_designs_note(&tui->designs, &tui->doc.scene, what ? what : "as opened", NULL);
}

/* The i-th row: the present state first, then the others, the newest first. */
static struct thud_design *row_at(struct thud_tui *tui, int i)
{
    struct thud_designs *designs = &tui->designs;
    struct thud_design *now = present(tui);
    for (int k = designs->n; k >= 0; k--) {
        struct thud_design *d = k == designs->n ? now : &designs->item[k];
        if (d && (k == designs->n || d != now) && i-- == 0)
            return d;
    }
    return NULL;
}

/* NULL: there is none of that name, which is said. */
static const struct thud_design *named(struct thud_tui *tui, const char *name)
{
    const struct thud_design *d = thud_designs_named(&tui->designs, name);
    if (!d)
        thud_tui_say(tui, THUD_ROLE_ERROR, "! there is no design \"%.40s\"; U lists them", name);
    return d;
}

void thud_tui_go_to_design(struct thud_tui *tui, const char *name)
{
    const struct thud_design *d = named(tui, name);
    struct thud_error err = {0};
    char what[80], text[40];
    if (!d)
        return;
    struct thud_scene next = *d->scene;
    snprintf(what, sizeof what, "design %s", thud_design_called(d, text));
    memcpy(next.name, tui->doc.scene.name, sizeof next.name); /* what runs do not depend on stays */
    memcpy(next.title, tui->doc.scene.title, sizeof next.title);
    next.study = tui->doc.scene.study;
    next.document = tui->doc.scene.document;
    if (!thud_tui_succeeded(tui, thud_doc_change(&tui->doc, &next, what, &err), &err))
        return;
    thud_tui_log(tui, "design %s", text);
    thud_tui_say(tui, THUD_ROLE_GOOD, "This is design %s (u undoes)", text);
}

/* Empty, or the one that is chosen already: changes are compared with the state before them again. */
void thud_tui_compare_with(struct thud_tui *tui, char *name)
{
    const struct thud_design *d = *name ? named(tui, name) : NULL;
    struct thud_record *record = NULL;
    struct thud_error err = {0};
    char text[40];
    if (*name && !d)
        return;
    if (!d || (tui->base.chosen && strcmp(tui->base.name, thud_design_called(d, text)) == 0)) {
        thud_base_clear(&tui->base);
        thud_tui_log(tui, "compare");
        thud_tui_say(tui, THUD_ROLE_PLAIN, "Changes are compared with the state before them");
        return;
    }
    if (thud_doc_read_record(&tui->doc, d->scene, &record, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        thud_base_take(&tui->base, d, record, true);
    thud_record_free(record);
    thud_tui_log(tui, "compare %s", thud_design_called(d, text));
    if (!err.what[0])
        thud_tui_say(tui, THUD_ROLE_GOOD, "Everything is compared with design %s now", text);
}

/* A preset of that name beside this one, or in the working folder beside one that comes with thud. */
void thud_tui_design_path(const struct thud_tui *tui, const char *name, char *path, size_t size)
{
    const char *slash = strrchr(tui->doc.path, '/');
    bool beside = slash && !thud_doc_is_shipped(&tui->doc, tui->doc.path);
    snprintf(path, size, "%.*s%s.yaml", beside ? (int)(slash - tui->doc.path) + 1 : 0, tui->doc.path, name);
}

/* False: it was refused. */
static bool name_design(struct thud_tui *tui, struct thud_design *d, const char *name)
{
    struct thud_error err = {0};
    char path[600];
    thud_tui_design_path(tui, name, path, sizeof path);
    struct thud_design *other = thud_designs_named(&tui->designs, name);
    if (!*name || strlen(name) >= sizeof d->name || strpbrk(name, "/#\\\"'") || (other && other != d) ||
        (!other && access(path, F_OK) == 0)) {
        thud_tui_say(tui, THUD_ROLE_ERROR, "! \"%.40s\": a name that neither a design nor a preset here has", name);
        return false;
    }
    if (!thud_tui_succeeded(tui, thud_preset_save(tui->doc.preset, d->scene, path, &err), &err))
        return false;
    snprintf(d->name, sizeof d->name, "%s", name);
    thud_tui_say(tui, THUD_ROLE_GOOD, "This design is %s now, and saved as %s", name, path);
    return true;
}

void thud_tui_name_design(struct thud_tui *tui, char *name)
{
    struct thud_design *d = present(tui);
    if (d && name_design(tui, d, name))
        thud_tui_log(tui, "name %s", name);
}

static void name_chosen(struct thud_tui *tui, const char *text)
{
    struct thud_design *d = thud_designs_named(&tui->designs, tui->dialog.target);
    if (d && *text)
        name_design(tui, d, text);
}

/* One that goes into the report is a file: without a name it gets one. */
static void mark(struct thud_tui *tui, struct thud_design *d)
{
    char name[THUD_NAME_MAX + 16], path[600];
    for (int i = d->number; !*d->name && !d->marked && i < 10000; i++) {
        snprintf(name, sizeof name, "%.20s-%d", tui->doc.scene.name, i);
        thud_tui_design_path(tui, name, path, sizeof path);
        if (!thud_designs_named(&tui->designs, name) && access(path, F_OK) != 0 && !name_design(tui, d, name))
            return;
    }
    d->marked = !d->marked;
}

/* ---- over the study's ground motions ---- */

/* The largest over the motions, without (case 0) and with (last case) bumper and links; the gap of one interface. */
static void largest(const struct thud_suite *suite, const struct thud_scene *scene, struct thud_design_result *out)
{
    const int with = suite->plan->ncases - 1;
    const bool one = scene->nstructures == 2 && scene->interface[0].gap.n == 0;
    *out = (struct thud_design_result){.known = true, .acceleration_mps2 = {NAN, NAN}, .drift_m = {NAN, NAN}};
    for (int i = 0; i < THUD_STRUCTURES_MAX; i++)
        out->need_m[i] = out->force_n[i] = NAN;
    for (int r = 0; r < suite->nrecords; r++) {
        out->force_n[0] = fmax(out->force_n[0], thud_suite_value(suite, r, 0, with, THUD_MEASURE_FORCE, -1));
        out->impacts[0] = (int)fmax(out->impacts[0], thud_suite_value(suite, r, 0, with, THUD_MEASURE_IMPACTS, -1));
        if (one)
            out->need_m[0] = fmax(out->need_m[0],
                                  scene->interface[0].gap_m + thud_suite_value(suite, r, 0, 0, THUD_MEASURE_SHORT, -1));
        for (int k = 0; k < 2; k++) {
            const int which = k ? with : 0;
            out->acceleration_mps2[k] =
                fmax(out->acceleration_mps2[k], thud_suite_value(suite, r, 0, which, THUD_MEASURE_ACCELERATION, -1));
            out->drift_m[k] = fmax(out->drift_m[k], thud_suite_value(suite, r, 0, which, THUD_MEASURE_DRIFT, -1));
        }
    }
}

static void end_design(struct list *list)
{
    thud_sweep_work_end(list->work);
    thud_suite_free(list->suite);
    thud_sweep_plan_clear(&list->plan);
    list->work = NULL;
    list->suite = NULL;
}

/* Begins the next design that has no result over the motions yet; without one it is over. */
static void begin_design(struct thud_tui *tui, struct list *list)
{
    struct thud_error err = {0};
    while (list->next < tui->designs.n && tui->designs.item[list->next].suite.known)
        list->next++;
    if (list->next >= tui->designs.n)
        return;
    const struct thud_design *d = &tui->designs.item[list->next++];
    list->number = d->number;
    thud_sweep_plan_init(&list->plan, d->scene);
    list->plan.nrecords = list->records.n;
    list->plan.record = (const struct thud_record *const *)list->records.record;
    enum thud_status status =
        thud_sweep_cases(&list->plan, thud_scene_has_measure(d->scene) ? "none,as-written" : "none", &err);
    if (status == THUD_OK)
        status = thud_suite_create(&list->plan, &list->suite, &err);
    const struct thud_sweep_jobs jobs = {.plan = &list->plan, .step = 1, .count = thud_sweep_points(&list->plan)};
    if (status == THUD_OK)
        status = thud_sweep_work_start(&jobs, &list->work, &err);
    if (status != THUD_OK) {
        end_design(list);
        thud_tui_say_error(tui, &err);
    }
}

/* Every design over the motions of the study, one after the other, or back to the scene's own. */
static void change_motions(struct thud_tui *tui, struct list *list)
{
    struct thud_error err = {0};
    end_design(list);
    thud_record_list_clear(&list->records);
    if (list->motions > 0) {
        list->motions = 0;
        return;
    }
    if (!*tui->doc.scene.study.records) {
        thud_tui_say(tui, THUD_ROLE_WARN, "The study has no ground motions: Space on Record puts them together");
        return;
    }
    if (!thud_tui_succeeded(tui,
                            thud_doc_motions(&tui->doc, tui->doc.scene.study.records, tui->doc.scene.study.both_signs,
                                             &list->records, &err),
                            &err))
        return;
    list->motions = list->records.n;
    list->next = 0;
    for (int i = 0; i < tui->designs.n; i++)
        tui->designs.item[i].suite.known = false;
    begin_design(tui, list);
}

static bool busy(const struct thud_tui *tui)
{
    return ((const struct list *)tui->dialog.own)->work != NULL;
}

/* Takes the points that are there; with the last one the design has its result. */
static void work(struct thud_tui *tui)
{
    static const double wait_s = 0.004;
    struct list *list = tui->dialog.own;
    struct thud_error err = {0};
    struct thud_sweep_point *point;
    bool done = false;
    enum thud_status status = thud_sweep_work_take(list->work, wait_s, &point, &done, &err);
    if (status == THUD_OK && point) {
        status = thud_suite_add(list->suite, point, &err);
        free(point);
    }
    if (status == THUD_OK && !done)
        return;
    for (int i = 0; i < tui->designs.n && status == THUD_OK; i++)
        if (tui->designs.item[i].number == list->number)
            largest(list->suite, &list->plan.scene, &tui->designs.item[i].suite);
    end_design(list);
    if (status == THUD_OK)
        begin_design(tui, list);
    else
        thud_tui_say_error(tui, &err);
    thud_tui_redraw(tui, false);
}

static void release(struct thud_tui *tui)
{
    struct list *list = tui->dialog.own;
    end_design(list);
    thud_record_list_clear(&list->records);
}

/* ---- the list ---- */

/* Columns of numbers, from the right: head, width, what stands there. */
enum column { NEED, IMPACTS, FORCE, ACCELERATION, ACCELERATION_WITH, DRIFT, DRIFT_WITH, COLUMNS };
static const struct {
    const char *head;
    int width;
} column[COLUMNS] = {{"needs cm", 9}, {"impacts", 8}, {"MN", 6}, {"m/s2", 6}, {"with", 6}, {"mm", 6}, {"with", 6}};

/* In the unit of its column; NaN: not known. */
static double value_of(const struct list *list, const struct thud_design *d, enum column which)
{
    const struct thud_design_result *r = list->motions > 0 ? &d->suite : &d->result;
    double need_m = NAN, force_n = NAN;
    int impacts = 0;
    if (!r->known)
        return NAN;
    for (int i = 0; i + 1 < d->scene->nstructures; i++) {
        need_m = fmax(need_m, r->need_m[i]);
        force_n = fmax(force_n, r->force_n[i]);
        impacts += r->impacts[i];
    }
    return which == NEED      ? thud_summary_gap_cm(need_m)
           : which == IMPACTS ? impacts
           : which == FORCE   ? 1e-6 * force_n
           : which >= DRIFT   ? 1e3 * r->drift_m[which - DRIFT]
                              : r->acceleration_mps2[which - ACCELERATION];
}

/* What the others are compared with, in colours and differences: the chosen one, else the first there was. */
static const struct thud_design *reference(struct thud_tui *tui)
{
    const struct thud_design *d = tui->base.chosen ? thud_designs_named(&tui->designs, tui->base.name) : NULL;
    return d ? d : tui->designs.n > 0 ? &tui->designs.item[0] : NULL;
}

/* What a design has other than the reference; of that one itself the change that led to it. */
static const char *words_of(const struct thud_design *d, const struct thud_design *of, char *text, size_t size)
{
    if (of && of != d)
        thud_design_differences(d->scene, of->scene, text, size);
    return of && of != d ? text : d->what;
}

static void draw_row(struct thud_tui *tui, const struct list *list, const struct thud_design *d,
                     const struct thud_pane *in, int y, bool here)
{
    const struct thud_design *of = reference(tui);
    const int attr = here ? THUD_REVERSE : 0;
    char name[40], words[400], fitted[200], number[24];
    int at = in->w;
    for (int c = COLUMNS - 1; c >= 0; c--) {
        const double value = value_of(list, d, (enum column)c), old = of ? value_of(list, of, (enum column)c) : NAN;
        const int role = of == d || !(fabs(value - old) > 5e-3 * fabs(old)) ? THUD_ROLE_RESULT
                         : value < old                                      ? THUD_ROLE_GOOD
                                                                            : THUD_ROLE_WARN;
        if (isnan(value))
            snprintf(number, sizeof number, "%s", "·");
        else if (c == IMPACTS)
            snprintf(number, sizeof number, "%.0f", value);
        else if (c == NEED)
            snprintf(number, sizeof number, "%.1f", value);
        else
            thud_tui_number(value, number);
        thud_pane_right(in, at, y, thud_look(role, 0), number);
        at -= column[c].width;
    }
    thud_pane_print(in, 0, y, thud_look(THUD_ROLE_KEY, 0), "%c%c", d->marked ? '+' : ' ',
                    of == d && tui->base.chosen ? '=' : ' ');
    const bool now = thud_doc_runs_alike(d->scene, &tui->doc.scene);
    int x = 2 + thud_pane_print(in, 2, y, thud_look(THUD_ROLE_VALUE, attr | (now ? THUD_BOLD : 0)), "%s%s",
                                now ? "*" : "", thud_utf8_fit(thud_design_called(d, name), 14, fitted, sizeof fitted));
    if (at - x > 8)
        thud_pane_put(in, x + 1, y, thud_look(THUD_ROLE_PLAIN, attr),
                      thud_utf8_fit(words_of(d, of, words, sizeof words), at - x - 2, fitted, sizeof fitted));
}

static void draw(struct thud_tui *tui, const struct thud_pane *area)
{
    struct list *list = tui->dialog.own;
    const int rows = tui->designs.n + 5 < area->h ? tui->designs.n + 5 : area->h; /* above it the screen is seen */
    const struct thud_pane box = thud_pane_inside(area, 0, area->h - rows, area->w, rows);
    thud_pane_blank(&box);
    char title[120] = "Designs: * on the screen, = compared with, + in the report";
    if (list->motions > 0)
        snprintf(title, sizeof title, "Designs: the largest over %d ground motions%s", list->motions,
                 list->work ? ", running" : "");
    struct thud_pane in = thud_pane_frame(&box, title, true);
    int at = in.w;
    for (int c = COLUMNS - 1; c >= 0; c--) {
        thud_pane_right(&in, at, 0, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), column[c].head);
        at -= column[c].width;
    }
    thud_pane_put(&in, 2, 0, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), at > 24 ? "design and what it changes" : "design");
    thud_list_scroll(&list->at, &list->top, tui->designs.n, in.h - 2);
    const struct thud_design *d;
    for (int i = 0; i < in.h - 2 && (d = row_at(tui, list->top + i)) != NULL; i++)
        draw_row(tui, list, d, &in, 1 + i, list->top + i == list->at);
    const struct thud_design *here = row_at(tui, list->at), *of = reference(tui);
    char words[500];
    if (here && in.h > 3)
        thud_pane_put(&in, 1, in.h - 1, thud_look(THUD_ROLE_MUTED, 0), words_of(here, of, words, sizeof words));
}

static void take_key(struct thud_tui *tui, int key)
{
    static const struct thud_prompt prompt = {.words = "name of the design, and of its preset: ", .done = name_chosen};
    struct list *list = tui->dialog.own;
    struct thud_design *d = row_at(tui, list->at);
    char name[40] = "";
    if (d)
        thud_design_called(d, name);
    switch (thud_key_action(THUD_AT_DESIGNS, key)) {
    case THUD_DO_CANCEL:
        thud_tui_normal(tui);
        thud_tui_hush(tui);
        break;
    case THUD_DO_UP:
        list->at -= list->at > 0;
        break;
    case THUD_DO_DOWN:
        list->at++;
        break;
    case THUD_DO_ACCEPT:
        thud_tui_normal(tui);
        thud_tui_go_to_design(tui, name);
        break;
    case THUD_DO_COMPARE:
        thud_tui_compare_with(tui, name);
        break;
    case THUD_DO_MARK:
        if (d)
            mark(tui, d);
        list->at++;
        break;
    case THUD_DO_NAME:
        thud_tui_normal(tui);
        snprintf(tui->dialog.target, sizeof tui->dialog.target, "%s", name);
        thud_tui_prompt(tui, &prompt, d ? d->name : "");
        break;
    case THUD_DO_FORGET:
        if (d && !thud_doc_runs_alike(d->scene, &tui->doc.scene))
            thud_designs_forget(&tui->designs, d);
        else
            thud_tui_say(tui, THUD_ROLE_WARN, "This design is on the screen");
        break;
    case THUD_DO_SUITE:
        change_motions(tui, list);
        break;
    case THUD_DO_SAVE:
        tui->dialog.next = THUD_DO_SAVE;
        break;
    case THUD_DO_REPORT:
        thud_tui_normal(tui);
        tui->dialog.next = THUD_DO_REPORT;
        break;
    default:
        break;
    }
}

void thud_tui_list_designs(struct thud_tui *tui)
{
    static const struct thud_over over = {.where = THUD_AT_DESIGNS,
                                          .size = sizeof(struct list),
                                          .key = take_key,
                                          .draw = draw,
                                          .busy = busy,
                                          .work = work,
                                          .free = release};
    thud_tui_over(tui, &over);
}
