/* Pictures and tables of what is shown. */
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "app/run/run_figures.h"
#include "base/ascii.h"
#include "ground/identity.h"
#include "io/file/file.h"
#include "tui/document/state.h"

const char *thud_tui_folder(const struct thud_tui *tui)
{
    return *tui->folder ? tui->folder : tui->options.output ? tui->options.output : ".";
}

/* Letters, digits and hyphens of a text, as file names have them. */
static void plain(char *text)
{
    char *to = text;
    for (const char *at = text; *at; at++) {
        int c = (unsigned char)thud_ascii_lower(*at);
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
            *to++ = (char)c;
        else if (to > text && to[-1] != '-')
            *to++ = '-';
    }
    while (to > text && to[-1] == '-')
        to--;
    *to = '\0';
}

static const char *const suffixes[] = {".png",       ".gp",           ".csv", "-contacts.csv", "-needed-gaps.csv",
                                       "-suite.csv", "-fragility.csv"};
enum { SUFFIXES = sizeof suffixes / sizeof *suffixes };

/* Whether something else changed a file since thud wrote it: it is much younger than the script beside it. */
static bool is_changed(const char *stem)
{
    const time_t drawn_s = 60; /* gnuplot takes less */
    struct stat script, info;
    char path[700];
    snprintf(path, sizeof path, "%s.gp", stem);
    if (stat(path, &script) != 0)
        return false;
    for (int i = 0; i < SUFFIXES; i++) {
        snprintf(path, sizeof path, "%s%s", stem, suffixes[i]);
        if (stat(path, &info) == 0 && info.st_mtime > script.st_mtime + drawn_s)
            return true;
    }
    return false;
}

/* A script that thud wrote says so at its beginning: the files beside it may be written again. */
static bool is_ours(const char *stem)
{
    char path[700], head[200];
    snprintf(path, sizeof path, "%s.gp", stem);
    FILE *file = fopen(path, "r");
    if (!file)
        return false;
    size_t n = fread(head, 1, sizeof head - 1, file);
    fclose(file);
    head[n] = '\0';
    return strstr(head, "thud") != NULL;
}

static bool is_taken(const char *stem)
{
    char path[700];
    for (int i = 0; i < SUFFIXES; i++) {
        snprintf(path, sizeof path, "%s%s", stem, suffixes[i]);
        if (access(path, F_OK) == 0)
            return true;
    }
    return false;
}

/* Whether this name was given before. */
static bool wrote(const struct thud_tui *tui, const char *name)
{
    char line[240];
    snprintf(line, sizeof line, "\n%s\n", name);
    return strstr(tui->wrote, line) != NULL;
}

/* "towers-impact-force-gap-80mm", with the case where it is of one; a number behind it where another has those files. */
void thud_tui_file_name(struct thud_tui *tui, const char *what, const char *of_case, char *name, size_t size)
{
    const struct thud_scene *scene = &tui->doc.scene;
    char gap[40] = "", stem[640], base[200];
    if (tui->pair + 1 < scene->nstructures && tui->screen != THUD_SCREEN_SWEEP) /* a study has many */
        snprintf(gap, sizeof gap, " gap %.6gmm", 1e3 * scene->interface[tui->pair].gap_m);
    snprintf(base, sizeof base, "%.60s %.60s %.20s%s", scene->name, what, of_case, gap);
    plain(base);
    snprintf(name, size, "%s", base);
    for (int i = 2; i < 10000; i++) {
        snprintf(stem, sizeof stem, "%.400s/%.200s", thud_tui_folder(tui), name);
        if (!is_taken(stem) || (!is_changed(stem) && (is_ours(stem) || wrote(tui, name))))
            break;
        snprintf(name, size, "%.180s-%d", base, i);
    }
    size_t n = strlen(tui->wrote);
    if (!wrote(tui, name))
        snprintf(tui->wrote + n, sizeof tui->wrote - n, "\n%s\n", name);
}

/* Takes the figures over. */
static void begin(struct thud_tui *tui, struct thud_figure *const *figure, int count)
{
    struct thud_error err;
    char name[200], first[200], motions[64];
    const bool moved =
        tui->screen == THUD_SCREEN_RECORD || tui->screen == THUD_SCREEN_RESULTS || tui->screen == THUD_SCREEN_PLOTS;
    const struct thud_record *record = moved ? tui->doc.record : NULL; /* a study's figures have their motions' words */
    thud_synthetic_text(thud_records_synthetic(&record, 1), 1, motions, sizeof motions);
    for (int i = 0; i < count; i++) {
        if (!figure[i])
            continue;
        thud_tui_file_name(tui, figure[i]->name, "", name, sizeof name);
        thud_figure_rename(figure[i], name);
        thud_figure_title_add(figure[i], motions);
    }
    snprintf(first, sizeof first, "%s", count > 0 && figure[0] ? figure[0]->name : ""); /* the writer frees it */
    struct thud_picture_screen screen = {.format = THUD_PNG};
    if (count == 1)
        screen = thud_tui_picture_screen(tui);
    tui->writing_screen = tui->screen;
    if (thud_picture_work_start(figure, count, thud_tui_folder(tui), tui->options.gnuplot, &screen, &tui->writing,
                                &err) != THUD_OK) {
        thud_tui_say_error(tui, &err);
        return;
    }
    tui->backend->also = thud_picture_work_fd(tui->writing);
    tui->writing_done = 0;
    tui->writing_count = count;
    if (count == 1)
        snprintf(tui->written, sizeof tui->written, "%s/%.100s.png, .gp (draws it again) and .csv",
                 thud_tui_folder(tui), first);
    else
        snprintf(tui->written, sizeof tui->written, "%d figures into %s: .png, .gp and .csv of each", count,
                 thud_tui_folder(tui));
    thud_tui_say(tui, THUD_ROLE_PLAIN, "Writing %s", tui->written);
}

bool thud_tui_show_figure(struct thud_tui *tui, const char *name)
{
    enum { FIGURES_MOST = 500 };
    const struct thud_view *view = thud_view_of(tui->screen);
    enum thud_action next = tui->screen == THUD_SCREEN_PLOTS ? THUD_DO_NEXT_FIGURE : THUD_DO_QUANTITY;
    for (int i = 0; i < FIGURES_MOST && view->figure; i++) {
        const struct thud_figure *figure = view->figure(tui);
        if (figure && strcmp(figure->name, name) == 0)
            return true;
        thud_tui_act(tui, next);
        thud_tui_draw(tui);
    }
    return false;
}

/* What was kept for a look is too little for a file: the run is made again with whole histories, and the action after
 * it. */
static bool needs_whole(struct thud_tui *tui, enum thud_action action)
{
    if (tui->screen != THUD_SCREEN_PLOTS || tui->live.history != THUD_LIVE_LOOK)
        return false;
    tui->whole_wanted = action;
    thud_tui_say(tui, THUD_ROLE_PLAIN, "Running with whole histories, for the file");
    thud_tui_run(tui);
    return true;
}

void thud_tui_picture(struct thud_tui *tui)
{
    if (needs_whole(tui, THUD_DO_PICTURE))
        return;
    struct thud_figure *copy = thud_figure_copy(thud_view_of(tui->screen)->figure(tui));
    if (copy)
        begin(tui, &copy, 1);
    else
        thud_tui_say(tui, THUD_ROLE_ERROR, "! no memory for the figure");
}

void thud_tui_figures(struct thud_tui *tui, int count, thud_tui_figure_fn *make, const void *from)
{
    struct thud_figure *figure[THUD_PICTURES_MAX];
    if (count > THUD_PICTURES_MAX)
        count = THUD_PICTURES_MAX;
    for (int i = 0; i < count; i++)
        figure[i] = make(from, i);
    begin(tui, figure, count);
}

void thud_tui_writing_look(struct thud_tui *tui)
{
    int done, count;
    struct thud_error err = {0};
    bool going = thud_picture_work_look(tui->writing, &done, &count);
    tui->dirty = tui->dirty || done != tui->writing_done || !going;
    tui->writing_done = done;
    if (going)
        return;
    struct thud_text picture = {0};
    enum thud_status status = thud_picture_work_finish(tui->writing, &done, &picture, &err);
    tui->writing = NULL;
    tui->backend->also = -1;
    if (status == THUD_OK && picture.size > 0 && tui->mode == THUD_MODE_NORMAL && tui->writing_screen == tui->screen)
        thud_tui_show_picture(tui, &picture);
    thud_text_clear(&picture);
    if (status == THUD_OK)
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written %s", tui->written);
    else if (status == THUD_CANCELLED)
        thud_tui_say(tui, THUD_ROLE_WARN, "Stopped: %d of %d figures are written, nothing is half written", done,
                     count);
    else
        thud_tui_say_error(tui, &err);
}

void thud_tui_writing_end(struct thud_tui *tui)
{
    int done;
    struct thud_error err;
    if (!tui->writing)
        return;
    thud_picture_work_stop(tui->writing);
    thud_picture_work_finish(tui->writing, &done, NULL, &err);
    tui->writing = NULL;
    tui->backend->also = -1;
}

bool thud_tui_write(struct thud_tui *tui, struct thud_text *text, const char *name)
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
    return status == THUD_OK;
}

void thud_tui_export(struct thud_tui *tui)
{
    const struct thud_view *view = thud_view_of(tui->screen);
    if (needs_whole(tui, THUD_DO_EXPORT))
        return;
    if (view->export_csv) {
        view->export_csv(tui);
        return;
    }
    struct thud_text csv = {0};
    char name[200], file[210];
    const struct thud_figure *figure = view->figure(tui);
    thud_tui_file_name(tui, figure->name, "", name, sizeof name);
    snprintf(file, sizeof file, "%s.csv", name);
    thud_figure_csv(figure, &csv);
    thud_tui_write(tui, &csv, file);
}

/* The cases that have an answer, with the bumper's last: what `thud run -o` draws of one, over each other. */
struct sources {
    struct thud_figure_source source[THUD_LIVE_CASES];
    int n, figures;
    enum thud_run_figure figure[THUD_RUN_FIGURES];
};

static void find_sources(const struct thud_tui *tui, struct sources *s)
{
    *s = (struct sources){.n = 0};
    for (int i = THUD_LIVE_NONE; i < THUD_LIVE_CASES; i++) {
        const struct thud_live_case *c = &tui->live.which[i];
        if (c->state == THUD_LIVE_DONE)
            s->source[s->n++] = thud_run_source(thud_live_name((enum thud_live_which)i), &tui->doc.scene, c->run);
    }
    for (int i = 0; s->n > 0 && i < THUD_RUN_FIGURES; i++)
        if (thud_run_figure_has((enum thud_run_figure)i, s->source, s->n))
            s->figure[s->figures++] = (enum thud_run_figure)i;
}

static struct thud_figure *run_figure(const void *from, int index)
{
    const struct sources *s = from;
    return thud_run_figure(s->figure[index], s->source, s->n);
}

void thud_tui_pictures(struct thud_tui *tui)
{
    const struct thud_view *view = thud_view_of(tui->screen);
    if (view->pictures)
        view->pictures(tui);
    else
        thud_tui_run_pictures(tui);
}

void thud_tui_run_pictures(struct thud_tui *tui)
{
    struct sources sources;
    tui->pictures_wanted = tui->live.history != THUD_LIVE_WHOLE;
    if (tui->pictures_wanted) {
        thud_tui_say(tui, THUD_ROLE_PLAIN, "Running with histories, for the figures");
        thud_tui_run(tui);
        return;
    }
    find_sources(tui, &sources);
    if (sources.figures > 0)
        thud_tui_figures(tui, sources.figures, run_figure, &sources);
    else
        thud_tui_say(tui, THUD_ROLE_WARN, "There is nothing to draw");
}

/* The rows of a pane as it is drawn, blanks between its columns as one tab. */
static void pane_text(struct thud_tui *tui, struct thud_text *out)
{
    struct thud_rect rect[THUD_PANES_MAX], area = thud_tui_area(tui), at = area;
    int n = thud_view_of(tui->screen)->layout(tui, area, rect), here = tui->form.pane[tui->screen];
    if (!thud_tui_one_pane(tui) && here < n)
        at = rect[here];
    for (int y = at.y + 1; y < at.y + at.h - 1; y++) {
        int blanks = 0;
        bool any = false;
        for (int x = at.x + 1; x < at.x + at.w - 1; x++) {
            char utf8[5];
            uint32_t glyph = tui->canvas.cell[y * tui->canvas.width + x].glyph;
            if (glyph == THUD_CELL_TAIL)
                continue;
            if (glyph == ' ' || glyph == 0x25b8) { /* the cursor's mark */
                blanks++;
                continue;
            }
            utf8[thud_utf8_put(glyph, utf8)] = '\0';
            thud_text_append(out, "%s%s", !any || blanks == 0 ? "" : blanks == 1 ? " " : "\t", utf8);
            any = true;
            blanks = 0;
        }
        if (any)
            thud_text_append(out, "\n");
    }
}

void thud_tui_copy(struct thud_tui *tui)
{
    enum { BYTES_MAX = 70000 }; /* terminals take no more, about */
    const struct thud_view *view = thud_view_of(tui->screen);
    const struct thud_figure *figure = !thud_form_focus(&tui->form) && view->figure ? view->figure(tui) : NULL;
    struct thud_text text = {0};
    if (figure)
        thud_figure_csv(figure, &text);
    else
        pane_text(tui, &text);
    if (text.failed || !text.data || text.size > BYTES_MAX)
        thud_tui_say(tui, THUD_ROLE_WARN, "There is too much, or nothing, to copy here: e writes it as CSV");
    else {
        tui->backend->copy(tui->backend, text.data);
        thud_tui_say(tui, THUD_ROLE_PLAIN, "Copied %s of %zu bytes, if the terminal lets it",
                     figure ? "the chart's data" : "the pane", (size_t)text.size);
    }
    thud_text_clear(&text);
}
