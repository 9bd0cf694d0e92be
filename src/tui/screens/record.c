/* Record: the ground motions at hand, the one chosen, and what it is like. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/record_verbs.h"
#include "base/quantity.h"
#include "ground/identity.h"
#include "ground/intensity.h"
#include "plot/figures/figures_record.h"
#include "tui/document/field.h"
#include "tui/screens/basket.h"
#include "tui/screens/moment.h"
#include "tui/widgets/chart.h"

enum { LIST, CURVE, DATA, MOVE };
enum curve { ACCELERATION, VELOCITY, DISPLACEMENT, SPECTRUM, SUITE }; /* the last: of the study's motions */

struct thud_record_state {
    struct thud_basket basket; /* the first of it */
    struct thud_browse files;
    bool listed, followed; /* the second: the cursor has gone to the one in use */
    char folder[256];      /* with a slash; empty: the working folder, the preset's and the shipped motions */
    char filter[96];
    char shown[sizeof((struct thud_record_choice *)0)->file]; /* the file in use, as the list last showed it */
    int curve;                                                /* enum curve */
    struct thud_figure *figure;
    const struct thud_record *of; /* what the figure was made from */
    unsigned long revision;
    int made;
    struct thud_intensity intensity;
    unsigned long measured_revision;
    const struct thud_record *measured; /* what the intensities are of */
};

static struct thud_record_state *state(const struct thud_tui *tui)
{
    return tui->own[THUD_SCREEN_RECORD];
}

/* Once it is asked for. */
static void list(struct thud_tui *tui)
{
    struct thud_record_state *r = state(tui);
    if (!r->listed)
        thud_browse_list(&r->files, THUD_BROWSE_RECORDS, tui->doc.paths, tui->doc.path, "");
    r->listed = true;
}

/* The cursor is on the record in use, also when that becomes another one. */
static void follow(struct thud_tui *tui, struct thud_record_state *r)
{
    const char *now = tui->doc.scene.record.file, *focus = tui->form.focus[THUD_SCREEN_RECORD];
    char path[THUD_PATH_MAX];
    list(tui);
    if (r->followed && strcmp(r->shown, now) == 0)
        return;
    r->followed = true;
    snprintf(r->shown, sizeof r->shown, "%s", now);
    snprintf(path, sizeof path, "record %.100s", *now ? thud_path_name(now) : "none");
    if (!*focus || strncmp(focus, "record ", 7) == 0) /* else the cursor is on a field of another pane */
        thud_form_focus_on(&tui->form, THUD_SCREEN_RECORD, path);
}

static void filter(struct thud_tui *tui, const char *text)
{
    snprintf(state(tui)->filter, sizeof state(tui)->filter, "%.90s", text);
}

/* On a high screen one above the other: the list as long as it is, all that the motion says, and the buildings. */
static int layout_high(const struct thud_tui *tui, struct thud_rect area, int left, struct thud_rect *pane)
{
    enum { LIST_LEAST = 8, DATA_ROWS = 27, MOVE_LEAST = 10 };
    const int wanted = state(tui)->files.n + 4, most = area.h - DATA_ROWS,
              list = wanted < LIST_LEAST ? LIST_LEAST
                     : wanted < most     ? wanted
                                         : most;
    const bool moves = most - list >= MOVE_LEAST;
    const int data = moves ? DATA_ROWS : area.h - list;
    pane[LIST] = (struct thud_rect){area.x, area.y, left, list};
    pane[DATA] = (struct thud_rect){area.x, area.y + list, left, data};
    pane[CURVE] = (struct thud_rect){area.x + left, area.y, area.w - left, area.h};
    pane[MOVE] = (struct thud_rect){area.x, area.y + list + data, left, area.h - list - data};
    return moves ? 4 : 3;
}

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    int left = area.w * 9 / 20 < 60 ? area.w * 9 / 20 : 60, data = area.h >= 30 ? 17 : area.h >= 18 ? 10 : area.h / 2;
    if (area.w >= THUD_MOMENT_WIDE && area.h >= THUD_MOMENT_TALL)
        return layout_high(tui, area, left, pane);
    pane[LIST] = (struct thud_rect){area.x, area.y, left, area.h};
    pane[CURVE] = (struct thud_rect){area.x + left, area.y, area.w - left, area.h - data};
    pane[DATA] = (struct thud_rect){area.x + left, area.y + area.h - data, area.w - left, data};
    if (area.w < THUD_MOMENT_WIDE || area.h < 2 * data)
        return 3;
    pane[MOVE] = pane[DATA];
    pane[LIST].h = area.h / 2; /* all that the motion says below the list */
    pane[DATA] = (struct thud_rect){area.x, area.y + pane[LIST].h, left, area.h - pane[LIST].h};
    return 4;
}

static const char *title_of(int curve)
{
    static const char *const title[] = {"Ground acceleration", "Ground velocity", "Ground displacement",
                                        "Response spectrum, 5 %", "Spectra of the suite"};
    return title[curve];
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    struct thud_record_state *r = state(tui);
    const struct thud_record *record = tui->doc.record;
    int suite = thud_basket_count(tui);
    char count[24] = "";
    if (suite > 0)
        snprintf(count, sizeof count, ", + suite of %d", suite);
    if (index == MOVE)
        thud_moment_title(tui, text, size);
    else if (index == LIST)
        snprintf(text, size, "Records%s%.40s%s%.40s%s", *r->folder ? " of " : "", r->folder, *r->filter ? " with " : "",
                 r->filter, count);
    else if (index == CURVE)
        snprintf(text, size, "%s", title_of(r->curve));
    else
        snprintf(text, size, "%.60s", record && *record->station ? record->station : "Ground motion");
}

static int draw_list(struct thud_tui *tui, const struct thud_pane *pane)
{
    struct thud_record_state *r = state(tui);
    int y = 0;
    follow(tui, r);
    thud_field_line(tui, LIST, pane, y++, -1, "record none",
                    *tui->doc.scene.record.file ? "   (no ground motion)" : " * (no ground motion)");
    for (int i = 0; i < r->files.n; i++) {
        char path[THUD_PATH_MAX], text[THUD_TEXT_MAX + 80], name[THUD_TEXT_MAX];
        const char *file = r->files.item[i].name, *now = tui->doc.scene.record.file;
        if (*r->filter && !strstr(file, r->filter))
            continue;
        bool seen = y >= pane->scroll && y < pane->scroll + pane->h; /* the others are not read yet */
        const char *about = seen ? thud_browse_about(&r->files, i) : "";
        int room = pane->w - 5 - (*about ? thud_utf8_columns(about) + 1 : 0);
        snprintf(path, sizeof path, "record %.100s", thud_path_name(file));
        thud_utf8_fit(file, room, name, sizeof name);
        snprintf(text, sizeof text, "%s%s %s%*s%s", thud_basket_holds(tui, file) ? "+" : " ",
                 strcmp(now, file) == 0 ? "*" : " ", name, room + 1 - thud_utf8_columns(name), "", about);
        thud_field_line(tui, LIST, pane, y, i, path, text);
        if (seen && !r->files.item[i].folder && (!*about || strncmp(about, "asks", 4) == 0) &&
            !thud_form_focused(&tui->form, LIST, path)) /* Space asks for it too */
            thud_pane_put(pane, 1, y, thud_look(THUD_ROLE_MUTED, 0), text);
        y++;
    }
    if (y == 1)
        thud_field_note(pane, y++, "no other file here");
    return y;
}

/* With the structures' periods marked. */
static struct thud_figure *spectrum(const struct thud_doc *doc, const char *title)
{
    enum { POINTS = 200 }; /* as `thud record spectrum` */
    struct thud_spectrum_point point[POINTS];
    struct thud_period_mark mark[THUD_STRUCTURES_MAX];
    int marks = 0;
    if (thud_scene_periods(&doc->scene, mark, THUD_STRUCTURES_MAX, &marks, NULL) != THUD_OK)
        marks = 0;
    thud_spectrum_fill(doc->record, 0.05, 0.02, 10, POINTS, point);
    return thud_figure_of_spectrum(point, POINTS, 0.05, mark, marks, "spectrum", title);
}

/* Of the document's ground motion, which must be there, as `thud record` writes it; where a part of it is used, the
 * acceleration shows what is cut off as well. NULL when out of memory. */
static struct thud_figure *figure_of(const struct thud_doc *doc, enum curve curve)
{
    char title[640];
    struct thud_figure *figure;
    thud_record_title(doc->record, title, sizeof title);
    if (curve == SPECTRUM) {
        figure = spectrum(doc, title);
    } else if (curve == ACCELERATION && doc->whole) {
        figure = thud_figure_of_parts(doc->whole, doc->record_choice.from_s, doc->record_choice.to_s, "used", title);
    } else {
        figure = thud_figure_of_motion(doc->record, "motion", title);
    }
    if (thud_figure_check(figure, NULL) == THUD_OK)
        return figure;
    thud_figure_free(figure);
    return NULL;
}

static struct thud_figure *make(struct thud_tui *tui, int index)
{
    return index == SUITE ? thud_figure_copy(thud_basket_figure(tui, &state(tui)->basket))
                          : figure_of(&tui->doc, (enum curve)index);
}

/* That of the curve in its figure. */
static const struct thud_panel *panel_of(const struct thud_tui *tui, const struct thud_figure *shown)
{
    const int curve = state(tui)->curve;
    return &shown->panel[curve < SPECTRUM && curve < shown->rows ? curve : 0];
}

/* The figures are the motion, its spectrum, and the suite's. */
enum { FIGURES = 2 };
static struct thud_figure *make_figure(struct thud_tui *tui, int index)
{
    return make(tui, index == 0 ? ACCELERATION : index < FIGURES ? SPECTRUM : SUITE);
}

static void refresh(struct thud_tui *tui)
{
    struct thud_record_state *r = state(tui);
    if (r->curve == SUITE && thud_basket_count(tui) == 0)
        r->curve = SPECTRUM;
    if (r->curve == SUITE ||
        (r->of == tui->doc.record && r->revision == tui->doc.revision && r->made == r->curve && r->figure))
        return;
    thud_figure_free(r->figure);
    r->figure = tui->doc.record ? make(tui, r->curve) : NULL;
    r->of = tui->doc.record;
    r->revision = tui->doc.revision;
    r->made = r->curve;
}

static const struct thud_figure *figure(struct thud_tui *tui)
{
    refresh(tui);
    return state(tui)->curve == SUITE ? thud_basket_figure(tui, &state(tui)->basket) : state(tui)->figure;
}

static int draw_curve(struct thud_tui *tui, const struct thud_pane *pane)
{
    struct thud_chart chart = thud_tui_reading(tui, tui->reading[tui->screen]);
    char text[600];
    const struct thud_figure *shown = figure(tui);
    if (shown)
        thud_chart_draw(pane, panel_of(tui, shown), &chart);
    else if (state(tui)->curve == SUITE)
        thud_pane_wrap(pane, 1, 0, pane->w - 2, thud_look(THUD_ROLE_ERROR, 0), state(tui)->basket.why);
    else if (tui->doc.record_error.status != THUD_OK)
        thud_pane_wrap(pane, 1, 0, pane->w - 2, thud_look(THUD_ROLE_ERROR, 0),
                       thud_error_text(&tui->doc.record_error, text, sizeof text));
    else
        thud_field_note(pane, 0, "no ground motion");
    return pane->h;
}

/* All the table has; those that studies turn on come first, as there may be few rows. */
static int draw_keys(struct thud_tui *tui, const struct thud_pane *pane, int y)
{
    static const char *const first[] = {"peak", "sign", "from", "to"};
    enum { FIRST = sizeof first / sizeof *first };
    for (int i = 0; i < FIRST || thud_group_param(THUD_GROUP_RECORD, i - FIRST); i++) {
        const char *key = i < FIRST ? first[i] : thud_group_param(THUD_GROUP_RECORD, i - FIRST)->name;
        char path[THUD_PATH_MAX];
        bool before = false;
        for (int k = 0; k < FIRST && i >= FIRST; k++)
            before = before || strcmp(key, first[k]) == 0;
        snprintf(path, sizeof path, "record.%s", key);
        if (!before)
            thud_field_row(tui, DATA, pane, y++, key, path);
    }
    return y;
}

/* Draws the measures from row `y` on; returns the row after them. */
static int measures(const struct thud_intensity *m, const struct thud_record *record, const struct thud_pane *pane,
                    int y)
{
    char a[24], b[24], c[24];
    struct thud_look look = thud_look(THUD_ROLE_PLAIN, 0);
    thud_pane_print(pane, 1, y++, look, "PGA %s g  PGV %s m/s  PGD %s m",
                    thud_tui_number(m->pga_mps2 / THUD_GRAVITY, a), thud_tui_number(m->pgv_mps, b),
                    thud_tui_number(m->pgd_m, c));
    thud_pane_print(pane, 1, y++, look, "Arias %s m/s  D5-95 %s s", thud_tui_number(m->arias_mps, a),
                    thud_tui_number(m->d5_95_s, b));
    thud_pane_print(pane, 1, y++, look, "%zu samples, dt %g s, %s s %.20s", record->samples, record->dt_s,
                    thud_tui_number(m->duration_s, a), record->format);
    if (*record->event)
        thud_pane_print(pane, 1, y++, look, "%.60s %.30s", record->event, record->component);
    return y;
}

static int draw_data(struct thud_tui *tui, const struct thud_pane *pane)
{
    struct thud_record_state *r = state(tui);
    const struct thud_record *record = tui->doc.record;
    int y = 0;
    if (record && (r->measured != record || r->measured_revision != tui->doc.revision)) {
        r->intensity = thud_intensity_of(record);
        r->measured = record;
        r->measured_revision = tui->doc.revision;
    }
    if (record)
        y = measures(&r->intensity, record, pane, 0);
    return draw_keys(tui, pane, y);
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    return index == LIST    ? draw_list(tui, pane)
           : index == CURVE ? draw_curve(tui, pane)
           : index == DATA  ? draw_data(tui, pane)
                            : thud_moment_draw(tui, pane);
}

static void next_figure(struct thud_tui *tui)
{
    state(tui)->curve = (state(tui)->curve + 1) % (thud_basket_count(tui) > 0 ? SUITE + 1 : SUITE);
}

/* The file under the cursor; NULL: it is on none. */
static const char *file_here(const struct thud_tui *tui)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    const struct thud_browse *files = &state(tui)->files;
    bool row = field && field->kind == THUD_FIELD_ROW && field->index >= 0 && field->index < files->n;
    return row && !files->item[field->index].folder ? files->item[field->index].name : NULL;
}

static enum thud_reaction act(struct thud_tui *tui, enum thud_action action)
{
    static const struct thud_prompt prompt = {.words = "file name contains: ", .done = filter};
    switch (action) {
    case THUD_DO_MARK:
        if (!file_here(tui))
            return THUD_NOT_MINE;
        thud_basket_toggle(tui, &state(tui)->basket, file_here(tui));
        return THUD_DONE;
    case THUD_DO_FILTER:
        thud_tui_prompt(tui, &prompt, state(tui)->filter);
        return THUD_DONE;
    case THUD_DO_SIGN:
        thud_tui_set(tui, "record.sign", tui->doc.scene.record.sign < 0 ? "+" : "-");
        return THUD_DONE;
    case THUD_DO_QUANTITY:
        next_figure(tui);
        return THUD_DONE;
    default:
        return THUD_NOT_MINE;
    }
}

static const char *cannot(struct thud_tui *tui, enum thud_action action)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    if (action == THUD_DO_MARK && !file_here(tui))
        return field && field->kind == THUD_FIELD_VALUE ? NULL : "The cursor is on no file";
    if (action == THUD_DO_QUANTITY && thud_basket_count(tui) > 0)
        return NULL;
    if (action == THUD_DO_SIGN || action == THUD_DO_QUANTITY)
        return tui->doc.record ? NULL : "There is no ground motion";
    return NULL;
}

static void row(struct thud_tui *tui, const struct thud_field *field)
{
    struct thud_record_state *r = state(tui);
    if (field->index >= r->files.n)
        return;
    if (field->index < 0 || !r->files.item[field->index].folder) {
        thud_tui_choose_record(tui, field->index < 0 ? "" : r->files.item[field->index].name);
        return;
    }
    snprintf(r->folder, sizeof r->folder, "%s", r->files.item[field->index].name);
    thud_browse_list(&r->files, THUD_BROWSE_RECORDS, tui->doc.paths, tui->doc.path, r->folder);
    thud_form_focus_on(&tui->form, THUD_SCREEN_RECORD, "record none");
}

static int figures(struct thud_tui *tui)
{
    bool suite = thud_basket_count(tui) > 0 && thud_basket_figure(tui, &state(tui)->basket);
    return tui->doc.record ? FIGURES + suite : 0;
}

static const struct thud_panel *read_panel(struct thud_tui *tui)
{
    return tui->form.pane[THUD_SCREEN_RECORD] == CURVE && figure(tui) ? panel_of(tui, figure(tui)) : NULL;
}

static void offer(struct thud_tui *tui)
{
    struct thud_record_state *r = state(tui);
    char command[sizeof r->files.item->name + 16];
    list(tui);
    for (int i = 0; i < SUITE + (thud_basket_count(tui) > 0); i++) {
        snprintf(command, sizeof command, "curve %d", i);
        thud_tui_offer(tui, THUD_SCREEN_RECORD, command, "figure %s", title_of(i));
    }
    for (int i = 0; i < r->files.n; i++) {
        snprintf(command, sizeof command, "record %s", r->files.item[i].name);
        if (!r->files.item[i].folder)
            thud_tui_offer(tui, THUD_SCREEN_RECORD, command, "take ground motion %s", r->files.item[i].name);
    }
}

static void command(struct thud_tui *tui, const char *word, const char *rest)
{
    if (strcmp(word, "curve") == 0)
        state(tui)->curve = atoi(rest);
    else
        thud_tui_choose_record(tui, rest);
}

static void release(struct thud_tui *tui)
{
    thud_figure_free(state(tui)->figure);
    thud_figure_free(state(tui)->basket.figure);
    thud_browse_clear(&state(tui)->files);
}

THUD_VIEW(record, "Record", RECORD, .keys = "record.", .moved = true, .size = sizeof(struct thud_record_state),
          .free = release, .offer = offer, .command = command, .act = act, .cannot = cannot, .row = row,
          .figure = figure, .figures = figures, .make = make_figure, .next_figure = next_figure, .read = read_panel,
          .history = thud_moment_history);
