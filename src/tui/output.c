/* Pictures and tables of what is shown. */
#include <stdio.h>
#include <string.h>

#include "app/figure_files.h"
#include "app/run_figures.h"
#include "io/file.h"
#include "tui/state.h"

const char *thud_tui_folder(const struct thud_tui *tui)
{
    return tui->options.output ? tui->options.output : ".";
}

void thud_tui_picture(struct thud_tui *tui)
{
    struct thud_error err;
    const struct thud_figure *figure = thud_view_of(tui->screen)->figure(tui);
    if (thud_figure_save(figure, thud_tui_folder(tui), NULL, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written %s/%s.png, .gp (draws it again) and .csv", thud_tui_folder(tui),
                     figure->name);
}

void thud_tui_write(struct thud_tui *tui, struct thud_text *text, const char *name)
{
    struct thud_error err;
    char path[600];
    snprintf(path, sizeof path, "%s/%s", thud_tui_folder(tui), name);
    enum thud_status status = thud_folder_make(thud_tui_folder(tui), &err);
    if (status == THUD_OK)
        status = thud_text_write(text, path, &err);
    else
        thud_text_clear(text);
    if (status != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written %s", path);
}

void thud_tui_export(struct thud_tui *tui)
{
    const struct thud_view *view = thud_view_of(tui->screen);
    if (view->export_csv) {
        view->export_csv(tui);
        return;
    }
    struct thud_text csv = {0};
    char name[128];
    const struct thud_figure *figure = view->figure(tui);
    snprintf(name, sizeof name, "%.100s.csv", figure->name);
    thud_figure_csv(figure, &csv);
    thud_tui_write(tui, &csv, name);
}

/* The cases that have an answer, with the bumper's last: what `thud run -o` draws of one, over each other. */
static int sources(const struct thud_tui *tui, struct thud_figure_source source[THUD_LIVE_CASES])
{
    int n = 0;
    for (int i = THUD_LIVE_NONE; i < THUD_LIVE_CASES; i++) {
        const struct thud_live_case *c = &tui->live.which[i];
        if (c->state != THUD_LIVE_DONE)
            continue;
        source[n] = thud_run_source(thud_live_name((enum thud_live_which)i), &tui->doc.scene, c->run);
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
    const struct thud_view *view = thud_view_of(tui->screen);
    if (view->pictures) {
        view->pictures(tui);
        return;
    }
    struct thud_error err = {0};
    enum thud_status status = THUD_OK;
    thud_tui_say(tui, THUD_ROLE_PLAIN, "Writing all figures into %s ...", thud_tui_folder(tui));
    thud_tui_draw(tui);
    if (!with_histories(tui))
        return;
    struct thud_figure_source source[THUD_LIVE_CASES];
    int count = sources(tui, source);
    if (count == 0)
        return;
    status = thud_run_figures_save(source, count, thud_tui_folder(tui), NULL, &err);
    if (status != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written all figures into %s: .png, .gp and .csv of each",
                     thud_tui_folder(tui));
}
