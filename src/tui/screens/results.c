/* Results: peaks by floor and case, impacts, energies, how it was computed. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "base/scan.h"
#include "io/result/result_file.h"
#include "plot/figures/figures_run.h"
#include "study/scene/level.h"
#include "study/sweep/remark.h"
#include "tui/document/field.h"
#include "tui/screens/moment.h"
#include "tui/screens/peaks_strip.h"

enum { PEAKS, IMPACTS, HOW, MOVE };
enum { IMPACTS_MAX = 2000 };
enum { SORTS = 3, QUANTITIES = 6, ELASTIC_QUANTITIES = 4 };

struct results_state {
    int which, sort, quantity; /* the case whose impacts and energies are shown, their order, the first quantity */
    bool by_value;             /* the floors: the largest first quantity of the last case first */
    char filter[48];           /* of what names a floor, or is known of an impact */
};

static struct results_state *state(const struct thud_tui *tui)
{
    return tui->own[THUD_SCREEN_RESULTS];
}

static void begin(struct thud_tui *tui)
{
    state(tui)->which = THUD_LIVE_BUMPER;
}

/* Ductility and permanent drift only where a storey yields. */
static int quantities(const struct thud_tui *tui)
{
    return thud_scene_yields(&tui->doc.scene) ? QUANTITIES : ELASTIC_QUANTITIES;
}

static int floor_count(const struct thud_structure *structure)
{
    return structure->kind == THUD_WALL    ? thud_wall_gives(structure)
           : structure->kind == THUD_RIGID ? 1
                                           : structure->storeys + (structure->kind == THUD_ISOLATED);
}

static int count_floors(const struct thud_scene *scene)
{
    int n = 0;
    for (int s = 0; s < scene->nstructures; s++)
        n += floor_count(&scene->structure[s]);
    return n;
}

/* What the floors leave of the screen goes to the panes below them. */
enum { IMPACTS_WIDE = 78, MOVE_LEAST = 9 };

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    int lower = area.h >= 29 ? 15 : area.h >= 17 ? 9 : area.h / 2, left = area.w - 38;
    int peaks = 3 + count_floors(&tui->doc.scene) * (1 + (thud_tui_compared(tui) != NULL)); /* frame and heads: 3 */
    lower = area.h - lower > peaks ? area.h - peaks : lower;
    pane[PEAKS] = (struct thud_rect){area.x, area.y, area.w, area.h - lower};
    pane[IMPACTS] = (struct thud_rect){area.x, area.y + area.h - lower, left, lower};
    pane[HOW] = (struct thud_rect){area.x + left, area.y + area.h - lower, area.w - left, lower};
    if (area.w < THUD_MOMENT_WIDE || lower < 2 * MOVE_LEAST)
        return 3;
    const bool beside = left >= 2 * IMPACTS_WIDE; /* else below them */
    struct thud_rect *impacts = &pane[IMPACTS], *move = &pane[MOVE];
    *move = *impacts;
    if (beside) {
        impacts->w = IMPACTS_WIDE;
        move->x += IMPACTS_WIDE;
        move->w -= IMPACTS_WIDE;
    } else {
        impacts->h -= lower / 2;
        move->y += impacts->h;
        move->h = lower / 2;
    }
    return 4;
}

static enum thud_live_which shown(const struct thud_tui *tui)
{
    enum thud_live_which which = (enum thud_live_which)state(tui)->which;
    return tui->run.live.which[which].state == THUD_LIVE_ABSENT ? THUD_LIVE_NONE : which;
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    static const char *const sort[] = {"by time", "by force", "by floor"};
    const char *filter = state(tui)->filter, *with = *filter ? ", with " : "";
    if (index == MOVE)
        thud_moment_title(tui, text, size);
    else if (index == PEAKS)
        snprintf(text, size, "Peaks%s%s%s%s: %s / %s / %s, ratio", thud_tui_shows_old(tui) ? " before the edit" : "",
                 state(tui)->by_value ? ", largest first" : "", with, filter,
                 thud_live_short_name(&tui->doc.scene, THUD_LIVE_FREE),
                 thud_live_short_name(&tui->doc.scene, THUD_LIVE_NONE),
                 thud_live_short_name(&tui->doc.scene, THUD_LIVE_BUMPER));
    else if (index == IMPACTS)
        snprintf(text, size, "Impacts, %s, %s%s%s", thud_tui_case_name(tui, shown(tui)), sort[state(tui)->sort], with,
                 filter);
    else
        snprintf(text, size, "How, and energy (%s)", thud_tui_case_name(tui, shown(tui)));
}

/* Four numbers of one quantity in 24 columns. */
static void quantity(struct thud_tui *tui, const struct thud_pane *pane, int x, int y, int s, int floor,
                     enum thud_peak_kind kind, double factor)
{
    double value[THUD_LIVE_CASES];
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        char number[24];
        value[i] = factor * thud_live_floor(&tui->run.live, (enum thud_live_which)i, s, floor, kind);
        thud_case_draw(&tui->run.live, (enum thud_live_which)i, pane, x + 7 * i + 6, y, NULL,
                       thud_tui_number(value[i], number));
    }
    thud_ratio_draw(&tui->run.live, pane, x + 21, y, value);
}

/* The same of the state to compare with, and what became of it: of the bumper's number, else of that without. */
static void compared_quantity(struct thud_tui *tui, const struct thud_live *compared, const struct thud_pane *pane,
                              int x, int y, int s, int floor, enum thud_peak_kind kind, double factor)
{
    const enum thud_live_which last = thud_live_written(&tui->run.live);
    for (int i = 0; i < THUD_LIVE_CASES; i++) {
        char number[24];
        double value = factor * thud_live_floor(compared, (enum thud_live_which)i, s, floor, kind);
        thud_pane_right(pane, x + 7 * i + 6, y, thud_look(THUD_ROLE_MUTED, 0), thud_tui_number(value, number));
    }
    double change =
        thud_live_floor(&tui->run.live, last, s, floor, kind) / thud_live_floor(compared, last, s, floor, kind);
    char text[32];
    if (isfinite(change))
        thud_pane_put(pane, x + 21, y, thud_look(THUD_ROLE_MUTED, 0), thud_change_text(change, text));
}

struct place {
    int s, floor;
    double value;
};

/* From above, or by value where that is asked for. */
static int by_value(const void *a, const void *b)
{
    double x = ((const struct place *)a)->value, y = ((const struct place *)b)->value;
    return (x < y) - (x > y);
}

/* The floors that the filter lets through, in their order; free with free(). NULL: no memory. */
static struct place *list_places(struct thud_tui *tui, enum thud_peak_kind kind, int *n)
{
    const struct thud_scene *scene = &tui->doc.scene;
    const struct thud_live *live = &tui->run.live;
    const enum thud_live_which last = thud_live_written(live);
    int all = count_floors(scene);
    *n = 0;
    struct place *place = malloc((size_t)(all > 0 ? all : 1) * sizeof *place);
    for (int s = 0; place && s < scene->nstructures; s++)
        for (int floor = floor_count(&scene->structure[s]) - 1; floor >= 0; floor--) {
            char text[THUD_NAME_MAX + 16];
            double value = thud_live_floor(live, last, s, floor, kind);
            snprintf(text, sizeof text, "%s %d", scene->structure[s].name, floor + 1);
            if (strstr(text, state(tui)->filter))
                place[(*n)++] = (struct place){s, floor, isnan(value) ? -1.0 : value};
        }
    if (place && state(tui)->by_value && *n > 1)
        qsort(place, (size_t)*n, sizeof *place, by_value);
    return place;
}

static int draw_peaks(struct thud_tui *tui, const struct thud_pane *pane)
{
    static const struct {
        const char *head;
        enum thud_peak_kind kind;
        double factor;
    } column[QUANTITIES] = {{"acceleration m/s²", THUD_PEAK_ACCELERATION, 1.0},
                            {"drift mm", THUD_PEAK_DRIFT, 1e3},
                            {"displacement mm", THUD_PEAK_DISPLACEMENT, 1e3},
                            {"velocity m/s", THUD_PEAK_VELOCITY, 1.0},
                            {"ductility", THUD_PEAK_DUCTILITY, 1.0},
                            {"permanent drift mm", THUD_PEAK_PERMANENT, 1e3}};
    const int all = quantities(tui);
    const struct thud_live *compared = thud_tui_compared(tui);
    int name = 1, y = 1;
    for (int s = 0; s < tui->doc.scene.nstructures; s++) {
        int n = thud_utf8_columns(tui->doc.scene.structure[s].name);
        name = n > name ? n : name;
    }
    int spare = (pane->w - 12) % 29, most = 7 + (pane->w > 41 ? spare : 0); /* of a name; the numbers stay */
    name = pane->w < 41 ? 4 : name < most ? name : most;
    int left = name > 7 ? name + 5 : pane->w < 41 ? 10 : 12, columns = (pane->w - left) / 29;
    columns = columns < 1 ? 1 : columns > all ? all : columns; /* the least terminal has room for one */
    int first = columns == all ? 0 : state(tui)->quantity % all;
    for (int c = 0; c < columns; c++)
        thud_pane_put(pane, left + 29 * c, 0, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), column[(first + c) % all].head);
    if (columns < all)
        thud_pane_put(pane, 1, 0, thud_look(THUD_ROLE_KEY, 0), "c others");
    int n;
    struct place *place = list_places(tui, column[first].kind, &n);
    for (int i = 0; place && i < n; i++, y += 1 + (compared != NULL)) {
        int s = place[i].s, floor = place[i].floor;
        char key[THUD_PATH_MAX], text[200], fitted[THUD_NAME_MAX + 4];
        snprintf(key, sizeof key, "floor %d %d", s, floor);
        snprintf(text, sizeof text, "%s %d",
                 thud_utf8_fit(tui->doc.scene.structure[s].name, name, fitted, sizeof fitted), floor + 1);
        thud_field_line(tui, PEAKS, pane, y, s * 1000 + floor, key, text);
        if (compared)
            thud_pane_put(pane, 3, y + 1, thud_look(THUD_ROLE_MUTED, 0), tui->base.name);
        for (int c = 0; c < columns; c++) {
            enum thud_peak_kind kind = column[(first + c) % all].kind;
            double factor = column[(first + c) % all].factor;
            quantity(tui, pane, left + 29 * c, y, s, floor, kind, factor);
            if (compared)
                compared_quantity(tui, compared, pane, left + 29 * c, y + 1, s, floor, kind, factor);
        }
    }
    if (n == 0)
        thud_field_note(pane, y++, "no floor's name has \"%s\"", state(tui)->filter);
    free(place);
    return y;
}

struct row {
    struct thud_impact impact;
    int interface, floor; /* from 1 */
};

static int by_time(const void *a, const void *b)
{
    double x = ((const struct row *)a)->impact.start_s, y = ((const struct row *)b)->impact.start_s;
    return (x > y) - (x < y);
}

static int by_force(const void *a, const void *b)
{
    double x = ((const struct row *)a)->impact.force_n, y = ((const struct row *)b)->impact.force_n;
    return (x < y) - (x > y);
}

static int by_floor(const void *a, const void *b)
{
    const struct row *x = a, *y = b;
    if (x->impact.contact != y->impact.contact)
        return x->impact.contact - y->impact.contact;
    return (x->impact.start_s > y->impact.start_s) - (x->impact.start_s < y->impact.start_s);
}

/* One for all that is shown of a run. */
static struct thud_shown_unit energy_unit(const struct thud_result *result)
{
    const struct thud_energy *e = &result->energy;
    return thud_shown_energy(fmax(e->input_j + e->initial_j, fmax(e->kinetic_j, e->strain_j)));
}

/* What there is room for on a wide terminal. */
static void impact_rest(const struct thud_impact *impact, double per_j, char *text, size_t size)
{
    char d[24], ms[24], e[24], lost[24];
    thud_append(text, size, " %8s %8s %7s %9s", thud_tui_number(1e3 * impact->indentation_m, d),
                thud_tui_number(1e3 * impact->duration_s, ms),
                isnan(impact->restitution) ? "-" : thud_tui_number(impact->restitution, e),
                thud_tui_number(per_j * impact->dissipated_j, lost));
}

static int draw_impacts(struct thud_tui *tui, const struct thud_pane *pane)
{
    const struct thud_live_case *c = &tui->run.live.which[shown(tui)];
    if (c->state != THUD_LIVE_DONE) {
        thud_field_note(pane, 0, "%s",
                        c->state == THUD_LIVE_ABSENT   ? "there is no bumper"
                        : c->state == THUD_LIVE_FAILED ? "FAILED"
                                                       : "no results yet");
        return 1;
    }
    int count;
    const struct thud_impact *impact = thud_run_impacts(c->run, &count);
    const struct thud_result *result = thud_run_result(c->run);
    struct row *row = malloc((size_t)(count > 0 ? count : 1) * sizeof *row);
    if (!row)
        return 0;
    for (int i = 0; i < count; i++) {
        const struct thud_contact_result *contact = &result->contact[impact[i].contact];
        row[i] = (struct row){impact[i], contact->interface,
                              thud_slab_floor(contact->left_floor, contact->right_floor, contact->struck)};
    }
    const struct thud_shown_unit energy = energy_unit(result);
    int (*const order[SORTS])(const void *, const void *) = {by_time, by_force, by_floor};
    if (count > 1)
        qsort(row, (size_t)count, sizeof *row, order[state(tui)->sort]);
    bool wide = pane->w >= 66;
    thud_pane_print(pane, 1, 0, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "      t s  fl.    v m/s     F MN%s%s%s",
                    wide ? "     d mm       ms       e   " : "", wide ? energy.unit : "", wide ? " lost" : "");
    int n = 0;
    for (int i = 0; i < count && n < IMPACTS_MAX; i++) {
        char key[48], text[160], v[24], f[24], place[24];
        bool several = tui->doc.scene.nstructures > 2;
        if (several)
            snprintf(place, sizeof place, "%d:%d", row[i].interface, row[i].floor);
        else
            snprintf(place, sizeof place, "%d", row[i].floor);
        snprintf(key, sizeof key, "impact %.9g %d", row[i].impact.start_s, row[i].impact.contact);
        snprintf(text, sizeof text, "%9.3f %4s %8s %8s", row[i].impact.start_s, place,
                 thud_tui_number(row[i].impact.approach_mps, v),
                 row[i].impact.force_n > 0.0 ? thud_tui_number(1e-6 * row[i].impact.force_n, f) : "-");
        if (wide)
            impact_rest(&row[i].impact, energy.factor, text, sizeof text);
        if (strstr(text, state(tui)->filter))
            thud_field_line(tui, IMPACTS, pane, ++n, i, key, text);
    }
    if (count == 0)
        thud_field_note(pane, 1, "none: the structures do not meet");
    else if (n < count)
        thud_field_note(pane, n + 1, "and %d more (%s)", count - n,
                        *state(tui)->filter ? "f filters" : ":run -o DIR writes them all");
    free(row);
    return n + 1 + (n < count || count == 0);
}

static int draw_energy(const struct thud_result *result, const struct thud_pane *pane, int y)
{
    const struct thud_energy *e = &result->energy;
    const struct {
        const char *name;
        bool shown;
        double value;
    } row[] = {{"input", true, e->input_j + e->initial_j},
               {"damping", true, e->viscous_j},
               {"contact", true, e->contact_j},
               {"kinetic", true, e->kinetic_j},
               {"strain", true, e->strain_j + e->stored_j},
               {"lost in yielding", e->hysteretic_j > 0, e->hysteretic_j},
               {"work of the weight", e->gravity_j > 0, e->gravity_j}};
    const struct thud_shown_unit shown = energy_unit(result);
    char a[24];
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        if (row[i].shown)
            thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, 0), "%-18s %s %s", row[i].name,
                            thud_tui_number(shown.factor * row[i].value, a), shown.unit);
    thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, 0), "%-18s %.1e", "energy error", e->error_ratio);
    return y;
}

/* How the run went, its energies, and the remarks on its result. */
static int draw_work(struct thud_tui *tui, const struct thud_result *result, const struct thud_pane *pane, int y)
{
    if (tui->doc.scene.analysis.modes > 0)
        y += thud_pane_wrap(pane, 1, y, pane->w - 2, thud_look(THUD_ROLE_WARN, THUD_BOLD),
                            "! lowest modes only: thud run gives the error of that");
    thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_MUTED, 0), "used %s", result->method ? result->method : "?");
    thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_MUTED, 0), "%ld steps, %ld events", result->work.steps,
                    result->work.events);
    if (isfinite(result->step_s) && result->method)
        thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_MUTED, 0), "of %.4g s", result->step_s);
    if (result->reason && *result->reason)
        y += thud_pane_wrap(pane, 1, y, pane->w - 2, thud_look(THUD_ROLE_MUTED, 0), result->reason);
    y = draw_energy(result, pane, y);
    if (tui->run.revision !=
        tui->doc.revision) /* the scene has changed since: nothing is said of it from these numbers */
        return y;
    const struct thud_live_case *c = &tui->run.live.which[shown(tui)];
    struct thud_remark_scope scope = {.scene = &tui->doc.scene, .result = result};
    scope.impact = thud_run_impacts(c->run, &scope.nimpacts);
    struct thud_remarks found = thud_remarks_find(&scope, THUD_REMARK_RESULT);
    for (int i = 0; i < found.n; i++)
        if (shown(tui) == THUD_LIVE_BUMPER || strncmp(found.item[i].said.key, "interfaces", 10) != 0) /* no bumper */
            y += thud_pane_wrap(pane, 1, y, pane->w - 2, thud_look(THUD_ROLE_WARN, 0), found.item[i].said.what);
    thud_remarks_clear(&found);
    return y;
}

static int draw_how(struct thud_tui *tui, const struct thud_pane *pane)
{
    int y = thud_field_group(tui, HOW, pane, 0, THUD_GROUP_SCENE, "");
    y = thud_field_group(tui, HOW, pane, y, THUD_GROUP_ANALYSIS, "analysis.");
    thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "Title block of reports");
    y = thud_field_group(tui, HOW, pane, y, THUD_GROUP_DOCUMENT, "document.");
    const struct thud_result *result = thud_live_result(&tui->run.live, shown(tui));
    return result ? draw_work(tui, result, pane, y) : y;
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    return index == PEAKS     ? draw_peaks(tui, pane)
           : index == IMPACTS ? draw_impacts(tui, pane)
           : index == HOW     ? draw_how(tui, pane)
                              : thud_moment_draw(tui, pane);
}

static void filter(struct thud_tui *tui, const char *text)
{
    snprintf(state(tui)->filter, sizeof state(tui)->filter, "%.47s", text);
}

static enum thud_reaction act(struct thud_tui *tui, enum thud_action action)
{
    static const struct thud_prompt prompt = {.words = "rows that contain: ", .done = filter};
    if (action == THUD_DO_FILTER) {
        thud_tui_prompt(tui, &prompt, state(tui)->filter);
    } else if (action == THUD_DO_SORT && tui->form.pane[THUD_SCREEN_RESULTS] == PEAKS) {
        state(tui)->by_value = !state(tui)->by_value;
    } else if (action == THUD_DO_SORT) {
        state(tui)->sort = (state(tui)->sort + 1) % SORTS;
        if (tui->form.pane[THUD_SCREEN_RESULTS] == IMPACTS) /* the first of the new order */
            tui->form.focus[THUD_SCREEN_RESULTS][0] = '\0';
    } else if (action == THUD_DO_QUANTITY)
        state(tui)->quantity = (state(tui)->quantity + 2) % quantities(tui);
    else if (action == THUD_DO_CASE)
        state(tui)->which = ((int)shown(tui) + 1) % THUD_LIVE_CASES;
    else
        return THUD_NOT_MINE;
    return THUD_DONE;
}

/* Enter on an impact shows it in the plots; on a floor, that floor. */
static void row(struct thud_tui *tui, const struct thud_field *field)
{
    struct thud_look_at look = {.wanted = true, .which = shown(tui)};
    const char *at = field->path;
    look.impact = thud_scan_word(&at, "impact ");
    if (look.impact ? thud_number_parse(at, &at, &look.time_s) == 0 && thud_scan_word(&at, " ") &&
                          thud_scan_count(&at, &look.contact)
                    : thud_scan_word(&at, "floor ") && thud_scan_count(&at, &look.structure) &&
                          thud_scan_word(&at, " ") && thud_scan_count(&at, &look.floor)) {
        tui->look_at = look;
        thud_tui_go(tui, THUD_SCREEN_PLOTS);
    }
}

static const char *cannot(struct thud_tui *tui, enum thud_action action)
{
    if (action == THUD_DO_EXPORT)
        return thud_live_result(&tui->run.live, shown(tui)) ? NULL : "There are no results yet: r runs";
    return NULL;
}

/* What `thud run --csv` and `-o` write, of the case whose impacts are shown. */
static void export_csv(struct thud_tui *tui)
{
    const struct thud_live_case *c = &tui->run.live.which[shown(tui)];
    struct thud_report report = {.scene = &tui->doc.scene, .result = thud_run_result(c->run)};
    static const char *const what[] = {"peaks", "impacts"};
    struct thud_text text[2] = {{0}, {0}};
    char name[200], file[2][210];
    report.impact = thud_run_impacts(c->run, &report.nimpacts);
    thud_result_csv(&report, 1, &text[0]);
    thud_impacts_csv(&report, &text[1]);
    for (int i = 0; i < 2; i++) {
        thud_tui_file_name(tui, what[i], thud_tui_case_name(tui, shown(tui)), name, sizeof name);
        snprintf(file[i], sizeof file[i], "%s.csv", name);
    }
    if (thud_tui_write(tui, &text[0], file[0]) && thud_tui_write(tui, &text[1], file[1]))
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written %s and %s into %s", file[0], file[1], thud_tui_folder(tui));
    thud_text_clear(&text[1]);
}

THUD_VIEW(results, "Results", RESULTS, .compares = true, .keys = "", .moved = true,
          .size = sizeof(struct results_state), .begin = begin, .act = act, .cannot = cannot, .row = row,
          .history = thud_moment_history, .export_csv = export_csv);
