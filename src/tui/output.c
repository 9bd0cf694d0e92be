/* Pictures and tables of what is shown. */
#include <stdio.h>
#include <string.h>

#include "app/figure_files.h"
#include "io/file.h"
#include "plot/figures_run.h"
#include "tui/state.h"

static const char *folder_of(const struct thud_tui *tui)
{
    return tui->options.output ? tui->options.output : ".";
}

void thud_tui_picture(struct thud_tui *tui)
{
    struct thud_error err;
    const struct thud_figure *figure = thud_view_of(tui->screen)->figure(tui);
    if (thud_figure_save(figure, folder_of(tui), NULL, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written %s/%s.png, .gp (draws it again) and .csv", folder_of(tui),
                     figure->name);
}

void thud_tui_export(struct thud_tui *tui)
{
    struct thud_error err;
    struct thud_text csv = {0};
    char path[512];
    const struct thud_figure *figure = thud_view_of(tui->screen)->figure(tui);
    snprintf(path, sizeof path, "%s/%s.csv", folder_of(tui), figure->name);
    thud_figure_csv(figure, &csv);
    enum thud_status status = thud_folder_make(folder_of(tui), &err);
    if (status == THUD_OK)
        status = thud_text_write(&csv, path, &err);
    else
        thud_text_clear(&csv);
    if (status != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written %s", path);
}

/* The cases that have an answer, with the bumper's last: what `thud run -o` draws of one, over each other. */
static int sources(const struct thud_tui *tui, struct thud_figure_source source[THUD_LIVE_CASES])
{
    int n = 0;
    for (int i = THUD_LIVE_NONE; i < THUD_LIVE_CASES; i++) {
        const struct thud_live_case *c = &tui->live.which[i];
        if (c->state != THUD_LIVE_DONE)
            continue;
        source[n] = (struct thud_figure_source){.name = thud_live_name((enum thud_live_which)i),
                                                .scene = &tui->doc.scene,
                                                .result = thud_run_result(c->run),
                                                .history = thud_run_history(c->run)};
        source[n].impact = thud_run_impacts(c->run, &source[n].nimpacts);
        n++;
    }
    return n;
}

/* Runs again where the histories were not kept: a picture of all is worth the moment. */
static bool with_histories(struct thud_tui *tui)
{
    const struct thud_record *record;
    struct thud_error err;
    if (tui->live.history)
        return true;
    thud_live_clear(&tui->live);
    if (thud_doc_record(&tui->doc, &record, &err) != THUD_OK)
        return false;
    thud_live_start(&tui->live, &tui->doc.scene, record, true);
    while (thud_live_advance(&tui->live))
        ;
    return true;
}

void thud_tui_pictures(struct thud_tui *tui)
{
    struct thud_error err = {0};
    enum thud_status status = THUD_OK;
    int n = 0;
    if (!with_histories(tui))
        return;
    struct thud_figure_source source[THUD_LIVE_CASES];
    int count = sources(tui, source);
    for (int i = 0; count > 0 && i < THUD_RUN_FIGURES && status == THUD_OK; i++) {
        if (!thud_run_figure_has((enum thud_run_figure)i, source, count))
            continue;
        struct thud_figure *figure = thud_run_figure((enum thud_run_figure)i, source, count);
        status = thud_figure_save(figure, folder_of(tui), NULL, &err);
        thud_figure_free(figure);
        n += status == THUD_OK;
    }
    if (status != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written %d figures into %s: .png, .gp and .csv of each", n, folder_of(tui));
}
