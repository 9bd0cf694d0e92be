/* Bench: every method over its steps or tolerances on the scene as written; table and chart fill as it runs. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/bench_jobs.h"
#include "io/file.h"
#include "tui/bench_work.h"
#include "tui/chart.h"
#include "tui/field.h"

enum { TABLE, CHART };

struct thud_bench_screen {
    struct thud_bench_work work;
    unsigned long revision;
    struct thud_figure *shown;
    int shown_done, panel;
};

static struct thud_bench_screen *state(struct thud_tui *tui)
{
    if (!tui->bench)
        tui->bench = calloc(1, sizeof *tui->bench);
    return tui->bench;
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
    if (!s || !s->work.bench || (s->shown && s->shown_done == s->work.done))
        return;
    thud_figure_free(s->shown);
    s->shown = NULL;
    s->shown_done = s->work.done;
    if (s->work.done == 0)
        return;
    s->shown = thud_bench_figure(s->work.bench, "Speed against accuracy");
    if (thud_figure_check(s->shown, NULL) != THUD_OK) {
        thud_figure_free(s->shown);
        s->shown = NULL;
    }
}

static void pane_title(struct thud_tui *tui, int index, char *text, size_t size)
{
    const struct thud_bench_screen *s = state(tui);
    if (index == TABLE && s && s->work.bench)
        snprintf(text, size, "%d of %d points", s->work.done, thud_bench_count(s->work.bench));
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
    if (!s || !s->work.bench) {
        thud_field_note(pane, y++, "r runs every method");
        return y;
    }
    const struct thud_bench_work *work = &s->work;
    const char *how = work->running ? "running, Esc stops" : work->complete ? "done" : "stopped: what is done stays";
    thud_pane_print(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "%s%s", how,
                    s->revision == tui->doc.revision ? "" : " (before edits)");
    if (work->running && work->run)
        thud_field_note(pane, y++, "%s: %.1f of %.1f s of motion", work->reference < 2 ? "reference" : "this run",
                        thud_run_time(work->run), thud_run_end(work->run));
    double trust = work->reference == 2 ? thud_bench_reference_error(work->bench) : NAN;
    if (isfinite(trust))
        thud_field_note(pane, y++, "reference good to %.1e", trust);
    thud_pane_put(pane, 3, y++, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), "setting  error       ms");
    for (int i = 0; i < thud_bench_count(work->bench); i++) {
        struct thud_bench_point *point = thud_bench_point(work->bench, i);
        char name[64], line[160], text[64], key[32];
        thud_bench_curve_name(point, name, sizeof name);
        if (i == 0 || thud_bench_point(work->bench, i - 1)->curve != point->curve)
            thud_pane_put(pane, 1, y++, thud_look(THUD_ROLE_PLAIN, THUD_BOLD), name);
        snprintf(line, sizeof line, "  %.0e    %s", point->setting, verdict(point, text));
        snprintf(key, sizeof key, "point %d", i);
        thud_field_line(tui, TABLE, pane, y++, i, key, line);
    }
    return y;
}

static int draw(struct thud_tui *tui, int index, struct thud_pane *pane)
{
    struct thud_bench_screen *s = state(tui);
    struct thud_chart chart = {.cursor = NAN};
    if (index == TABLE || !s)
        return draw_table(tui, pane);
    refresh(tui);
    if (s->shown)
        thud_chart_draw(pane, &s->shown->panel[s->panel % (s->shown->rows * s->shown->columns)], &chart);
    else
        thud_field_note(pane, 0, s->work.bench ? "the reference is being made" : "r runs every method");
    return pane->h;
}

static void start(struct thud_tui *tui)
{
    struct thud_bench_screen *s = state(tui);
    const struct thud_record *record;
    struct thud_error err;
    if (!s)
        return;
    thud_figure_free(s->shown);
    s->shown = NULL;
    s->revision = tui->doc.revision;
    if (thud_doc_record(&tui->doc, &record, &err) != THUD_OK ||
        thud_bench_work_start(&s->work, &tui->doc.scene, record, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
}

static bool act(struct thud_tui *tui, enum thud_action action)
{
    struct thud_bench_screen *s = state(tui);
    if (!s)
        return false;
    if (action == THUD_DO_RUN) {
        start(tui);
    } else if (action == THUD_DO_QUANTITY) {
        s->panel++;
    } else if (action == THUD_DO_BACK && s->work.running) {
        thud_bench_work_stop(&s->work);
        thud_tui_say(tui, THUD_ROLE_WARN, "Stopped; what is done stays");
    } else {
        return false;
    }
    return true;
}

static const struct thud_figure *figure(struct thud_tui *tui)
{
    refresh(tui);
    return tui->bench ? tui->bench->shown : NULL;
}

static const char *cannot(struct thud_tui *tui, enum thud_action action)
{
    return action == THUD_DO_QUANTITY && !figure(tui) ? "There is no figure yet: r runs every method" : NULL;
}

/* What there is to say of a point: why it failed, or its errors by kind. */
static void row(struct thud_tui *tui, const struct thud_field *field)
{
    struct thud_bench_screen *s = state(tui);
    if (!s || !s->work.bench || field->index >= thud_bench_count(s->work.bench))
        return;
    const struct thud_bench_point *point = thud_bench_point(s->work.bench, field->index);
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
    return tui->bench && tui->bench->work.running;
}

static bool work(struct thud_tui *tui)
{
    struct thud_error err = {0};
    if (thud_bench_work_advance(&tui->bench->work, tui->backend, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    tui->dirty = tui->dirty || !tui->bench->work.running;
    return tui->bench->work.running;
}

static double progress(struct thud_tui *tui)
{
    const struct thud_bench_work *w = tui->bench ? &tui->bench->work : NULL;
    return w && w->running ? (double)w->done / (thud_bench_count(w->bench) + 1) : -1.0;
}

static void export_csv(struct thud_tui *tui)
{
    struct thud_text csv = {0};
    thud_bench_csv(tui->bench->work.bench, &csv);
    thud_tui_write(tui, &csv, "bench.csv");
}

static void pictures(struct thud_tui *tui)
{
    if (figure(tui))
        thud_tui_picture(tui);
    else
        thud_tui_say(tui, THUD_ROLE_WARN, "There is no figure yet: r runs every method");
}

static void release(struct thud_tui *tui)
{
    if (!tui->bench)
        return;
    thud_bench_work_clear(&tui->bench->work);
    thud_figure_free(tui->bench->shown);
    free(tui->bench);
    tui->bench = NULL;
}

THUD_VIEW(bench, "Bench", BENCH, .act = act, .cannot = cannot, .row = row, .figure = figure, .busy = busy, .work = work,
          .progress = progress, .pictures = pictures, .export_csv = export_csv, .free = release);
