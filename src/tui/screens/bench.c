/* Bench: every method over its steps or tolerances on the scene as written; table and chart fill as it runs. What is
 * quick is run by default, once each; the whole of it, timed as `thud bench` does, on request. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/file/file.h"
#include "io/result/bench_rows.h"
#include "lab/bench/bench_jobs.h"
#include "tui/document/field.h"
#include "tui/document/session_log.h"
#include "tui/widgets/chart.h"

enum { TABLE, CHART };

enum { SEGMENTS = 300 };
static const double quick_s = 0.05,
                    quick_all_s = 2; /* what a point of the quick part, and all of it, may take, about */

struct thud_bench_screen {
    struct thud_scene scene; /* a copy of the scene, and of its ground motion */
    struct thud_record *record;
    struct thud_bench *bench; /* NULL: none was begun */
    struct thud_bench_work work;
    bool running, complete;
    bool quick;    /* what takes longer is left out */
    char why[320]; /* why it could not be begun; empty: nothing */
    unsigned long revision;
    struct thud_figure *shown;
    int shown_done, panel;
};

static struct thud_bench_screen *state(const struct thud_tui *tui)
{
    return tui->own[THUD_SCREEN_BENCH];
}

static int layout(struct thud_tui *tui, struct thud_rect area, struct thud_rect *pane)
{
    (void)tui;
    int left = area.w >= 110 ? 42 : area.w / 2;
    pane[TABLE] = (struct thud_rect){area.x, area.y, left, area.h};
    pane[CHART] = (struct thud_rect){area.x + left, area.y, area.w - left, area.h};
    return 2;
}

static void refresh(struct thud_tui *tui)
{
    struct thud_bench_screen *s = state(tui);
    const int ended = s->bench ? thud_bench_ended(s->bench) : 0;
    if (!s->bench || (s->shown && (s->shown_done == ended || ended == 0)))
        return;
    thud_figure_free(s->shown);
    s->shown = NULL;
    s->shown_done = ended;
    if (ended == 0)
        return;
    s->shown = thud_bench_figure(s->bench, "Speed against accuracy");
    if (thud_figure_check(s->shown, NULL) != THUD_OK) {
        thud_figure_free(s->shown);
        s->shown = NULL;
    }
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    const struct thud_bench_screen *s = state(tui);
    if (index == TABLE && s->bench)
        snprintf(text, size, "%d of %d points", thud_bench_ended(s->bench), thud_bench_count(s->bench));
    else
        snprintf(text, size, index == TABLE ? "Methods" : "Speed against accuracy");
}

static const char *verdict(const struct thud_bench_point *point, char text[64])
{
    char number[24];
    switch (point->state) {
    case THUD_BENCH_DONE:
        snprintf(text, 64, "%.1e %7s%s", point->error.all, thud_tui_number(1e3 * point->seconds, number),
                 point->error.missed ? " missed" : "");
        return text;
    case THUD_BENCH_FAILED:
        return "FAILED";
    case THUD_BENCH_SKIPPED:
        return "skipped";
    default:
        return "·";
    }
}

static int draw_table(struct thud_tui *tui, const struct thud_pane *pane)
{
    struct thud_bench_screen *s = state(tui);
    int y = 0;
    if (!s->bench) {
        if (*s->why)
            y += thud_pane_wrap(pane, 1, y, pane->w - 2, thud_look(THUD_ROLE_WARN, THUD_BOLD), s->why);
        thud_field_note(pane, y++, "r runs every method");
        return y;
    }
    const struct thud_bench_work *work = &s->work;
    const char *how = s->running                ? "running, Esc stops"
                      : s->complete && s->quick ? "the quick part; r: all"
                      : s->complete             ? "done"
                                                : "stopped: what is done stays";
    thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "%s%s", how,
                    s->revision == tui->doc.revision ? "" : " (before edits)");
    if (s->running && work->run)
        thud_field_note(pane, y++, "%s: %.1f of %.1f s of motion", work->reference < 2 ? "reference" : "this run",
                        thud_run_time(work->run), thud_run_end(work->run));
    double trust = work->reference == 2 ? thud_bench_reference_error(s->bench) : NAN;
    if (isfinite(trust))
        thud_field_note(pane, y++, "reference good to %.1e", trust);
    thud_pane_put(pane, 3, y++, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "setting  error       ms");
    for (int i = 0, skipped = 0, skipped_at = 0, n = thud_bench_count(s->bench); i < n; i++) {
        struct thud_bench_point *point = thud_bench_point(s->bench, i);
        bool last = i + 1 == n || thud_bench_point(s->bench, i + 1)->curve != point->curve;
        char name[64], line[160], text[64], key[32];
        thud_bench_curve_name(point, name, sizeof name);
        if (i == 0 || thud_bench_point(s->bench, i - 1)->curve != point->curve)
            thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), name);
        skipped += point->state == THUD_BENCH_SKIPPED;
        skipped_at = point->state == THUD_BENCH_SKIPPED ? i : skipped_at;
        if (point->state != THUD_BENCH_SKIPPED) {
            snprintf(line, sizeof line, "  %.0e    %s", point->setting, verdict(point, text));
            snprintf(key, sizeof key, "point %d", i);
            thud_field_line(tui, TABLE, pane, y++, i, key, line);
        }
        if (last && skipped > 0) { /* one line a method, however slow the machine is */
            snprintf(line, sizeof line, "  %d skipped%s", skipped, s->quick ? ": r runs all" : "");
            snprintf(key, sizeof key, "skipped %d", i);
            thud_field_line(tui, TABLE, pane, y++, skipped_at, key, line);
        }
        skipped = last ? 0 : skipped;
    }
    return y;
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    struct thud_bench_screen *s = state(tui);
    struct thud_chart chart = {.cursor = NAN};
    if (index == TABLE)
        return draw_table(tui, pane);
    refresh(tui);
    if (s->shown)
        thud_chart_draw(pane, &s->shown->panel[s->panel % (s->shown->rows * s->shown->columns)], &chart);
    else
        thud_field_note(pane, 0, s->bench ? "the reference is being made" : "r runs every method");
    return pane->h;
}

static void stop(struct thud_bench_screen *s)
{
    thud_bench_work_stop(&s->work);
    s->running = false;
}

static void clear(struct thud_bench_screen *s)
{
    stop(s);
    thud_bench_free(s->bench);
    thud_record_free(s->record);
    s->bench = NULL;
    s->record = NULL;
    s->complete = false;
}

static double clock_s(void *context)
{
    struct thud_backend *backend = context;
    return backend->now(backend);
}

/* With copies: the scene and its motion may be edited meanwhile. */
static enum thud_status create(struct thud_tui *tui, struct thud_bench_screen *s, struct thud_error *err)
{
    const struct thud_record *record;
    enum thud_status status = thud_doc_record(&tui->doc, &record, err);
    s->scene = tui->doc.scene;
    if (status == THUD_OK && record)
        status = thud_record_create(record->a_mps2, record->samples, record->dt_s, &s->record, err);
    return status == THUD_OK ? thud_bench_create(&s->scene, s->record, !s->quick, &s->bench, err) : status;
}

static void begin(struct thud_tui *tui, bool quick)
{
    struct thud_bench_screen *s = state(tui);
    struct thud_error err = {0};
    clear(s);
    if (!quick) {
        thud_figure_free(s->shown);
        s->shown = NULL;
    }
    s->quick = quick;
    s->why[0] = '\0';
    s->revision = tui->doc.revision;
    s->running = create(tui, s, &err) == THUD_OK;
    if (s->running) {
        struct thud_bench_jobs jobs = {.repeats = quick ? 0 : THUD_BENCH_REPEATS,
                                       .patience_s = quick ? quick_s : THUD_BENCH_PATIENCE_S,
                                       .budget_s = quick ? quick_all_s : 0,
                                       .now_s = quick ? NULL : clock_s,
                                       .context = tui->backend};
        thud_bench_work_init(&s->work, s->bench, &jobs);
        return;
    }
    clear(s);
    if (quick)
        thud_error_text(&err, s->why, sizeof s->why);
    else
        thud_tui_say_error(tui, &err);
}

/* A bench that was run whole stays until it is asked for again: it took its time. */
static void live(struct thud_tui *tui)
{
    struct thud_bench_screen *s = state(tui);
    if (s->revision != tui->doc.revision && (!s->bench || s->quick))
        begin(tui, true);
}

static void next_figure(struct thud_tui *tui)
{
    state(tui)->panel++;
}

static enum thud_reaction act(struct thud_tui *tui, enum thud_action action)
{
    struct thud_bench_screen *s = state(tui);
    if (action == THUD_DO_RUN) {
        thud_tui_log(tui, "bench");
        begin(tui, false);
    } else if (action == THUD_DO_QUANTITY) {
        next_figure(tui);
    } else if (action == THUD_DO_BACK && s->running) {
        stop(s);
        thud_tui_say(tui, THUD_ROLE_WARN, "Stopped; what is done stays");
    } else {
        return THUD_NOT_MINE;
    }
    return THUD_DONE;
}

static const struct thud_figure *figure(struct thud_tui *tui)
{
    refresh(tui);
    return state(tui)->shown;
}

static const char *cannot(struct thud_tui *tui, enum thud_action action)
{
    return action == THUD_DO_QUANTITY && !figure(tui) ? "There is no figure yet: r runs every method" : NULL;
}

/* What there is to say of a point: why it failed, or its errors by kind. */
static void row(struct thud_tui *tui, const struct thud_field *field)
{
    struct thud_bench_screen *s = state(tui);
    if (!s->bench || field->index >= thud_bench_count(s->bench))
        return;
    const struct thud_bench_point *point = thud_bench_point(s->bench, field->index);
    char name[64];
    thud_bench_curve_name(point, name, sizeof name);
    if (point->state == THUD_BENCH_DONE)
        thud_tui_say(tui, THUD_ROLE_PLAIN,
                     "%s: errors %.1e acceleration, %.1e drift, %.1e force, %.1e s in impact times; %ld steps, %d "
                     "impacts missed",
                     name, point->error.acceleration, point->error.drift, point->error.force,
                     point->error.impact_time_s, point->work.steps, point->error.missed);
    else
        thud_tui_say(tui, THUD_ROLE_WARN, "%s: %s", name, *point->message ? point->message : "not run yet");
}

static bool busy(struct thud_tui *tui)
{
    return state(tui)->running;
}

static bool work(struct thud_tui *tui)
{
    struct thud_bench_screen *s = state(tui);
    struct thud_error err = {0};
    bool done = false;
    enum thud_status status = thud_bench_work_advance(&s->work, SEGMENTS, &done, &err);
    if (status != THUD_OK)
        thud_tui_say_error(tui, &err);
    s->running = status == THUD_OK && !done;
    s->complete = status == THUD_OK && done;
    return s->running;
}

static double progress(struct thud_tui *tui)
{
    const struct thud_bench_screen *s = state(tui);
    return s->running ? (double)thud_bench_ended(s->bench) / (thud_bench_count(s->bench) + 1) : -1.0;
}

static void export_csv(struct thud_tui *tui)
{
    struct thud_text csv = {0};
    char name[200], file[210];
    thud_tui_file_name(tui, "bench", "", name, sizeof name);
    snprintf(file, sizeof file, "%s.csv", name);
    const struct thud_rows rows = thud_bench_rows(state(tui)->bench);
    thud_rows_csv(&rows, &csv);
    thud_tui_write(tui, &csv, file);
}

static int figures(struct thud_tui *tui)
{
    return figure(tui) != NULL;
}

static struct thud_figure *make(struct thud_tui *tui, int index)
{
    (void)index;
    return thud_figure_copy(figure(tui));
}

static void release(struct thud_tui *tui)
{
    clear(state(tui));
    thud_figure_free(state(tui)->shown);
}

THUD_VIEW(bench, "Bench", BENCH, .size = sizeof(struct thud_bench_screen), .free = release, .act = act,
          .cannot = cannot, .row = row, .figure = figure, .next_figure = next_figure, .live = live, .busy = busy,
          .work = work, .progress = progress, .figures = figures, .make = make, .export_csv = export_csv);
