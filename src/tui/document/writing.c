/* Figures and tables of what is shown, written while the screens go on. */
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "base/ascii.h"
#include "ground/identity.h"
#include "io/file/file.h"
#include "tui/document/state.h"

const char *thud_tui_folder(const struct thud_tui *tui)
{
    return *tui->files.folder ? tui->files.folder : tui->options.output ? tui->options.output : ".";
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

/* Whether something else changed a file since an earlier session wrote it: it is much younger than the script beside
 * it. */
static bool is_younger(const char *stem)
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

/* Of the files of a name: when they were written, their sizes and what is in them. Never 0. */
static unsigned long long digest_of(const char *stem)
{
    unsigned long long h = THUD_HASH_START;
    for (int i = 0; i < SUFFIXES; i++) {
        char path[700], part[4096];
        struct stat info;
        snprintf(path, sizeof path, "%s%s", stem, suffixes[i]);
        FILE *file = fopen(path, "r");
        if (!file)
            continue;
        if (fstat(fileno(file), &info) == 0) {
            const long long about[] = {i, info.st_size, info.st_mtim.tv_sec, info.st_mtim.tv_nsec};
            h = thud_hash(h, about, sizeof about);
        }
        for (size_t n; (n = fread(part, 1, sizeof part, file)) > 0;)
            h = thud_hash(h, part, n);
        fclose(file);
    }
    return h ? h : 1;
}

static struct thud_wrote *find_wrote(struct thud_tui *tui, const char *stem)
{
    for (int i = 0; i < tui->files.nwrote; i++)
        if (strcmp(tui->files.wrote[i].stem, stem) == 0)
            return &tui->files.wrote[i];
    return NULL;
}

static bool is_file_of(const char *path, const char *stem)
{
    const size_t n = strlen(stem);
    for (int i = 0; i < SUFFIXES && strncmp(path, stem, n) == 0; i++)
        if (strcmp(path + n, suffixes[i]) == 0)
            return true;
    return false;
}

/* The names handed out (`path`: that of a file just written) have what stands there now. */
static void remember_written(struct thud_tui *tui, const char *path)
{
    for (int i = 0; i < tui->files.nwrote; i++) {
        struct thud_wrote *w = &tui->files.wrote[i];
        if (path ? is_file_of(path, w->stem) : w->digest == 0)
            w->digest = digest_of(w->stem);
    }
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

/* "towers-impact-force-gap-80mm", with the case where it is of one; numbered where another has those files. */
static void file_name(struct thud_tui *tui, bool many, const char *what, const char *of_case, char *name, size_t size)
{
    const struct thud_scene *scene = &tui->doc.scene;
    char gap[40] = "", stem[640], base[200];
    struct thud_wrote *w = NULL;
    if (tui->interface + 1 < scene->nstructures && !many) /* a study has many */
        snprintf(gap, sizeof gap, " gap %.6gmm", 1e3 * scene->interface[tui->interface].gap_m);
    snprintf(base, sizeof base, "%.60s %.60s %.20s%s", scene->name, what, of_case, gap);
    plain(base);
    snprintf(name, size, "%s", base);
    for (int i = 2; i < 10000; i++) {
        snprintf(stem, sizeof stem, "%.400s/%.200s", thud_tui_folder(tui), name);
        w = find_wrote(tui, stem);
        if (!is_taken(stem) ||
            (w ? w->digest == 0 || w->digest == digest_of(stem) : is_ours(stem) && !is_younger(stem)))
            break;
        snprintf(name, size, "%.180s-%d", base, i);
    }
    if (!w && tui->files.nwrote == THUD_WROTE_MAX)
        memmove(tui->files.wrote, tui->files.wrote + 1, (size_t)--tui->files.nwrote * sizeof *w);
    if (!w)
        w = &tui->files.wrote[tui->files.nwrote++];
    *w = (struct thud_wrote){.digest = 0};
    snprintf(w->stem, sizeof w->stem, "%.419s", stem);
}

void thud_tui_file_name(struct thud_tui *tui, const char *what, const char *of_case, char *name, size_t size)
{
    file_name(tui, thud_tui_view(tui)->many, what, of_case, name, size);
}

/* Takes figures over and writes them into a folder, renamed, with what their motions are. */
static bool start(struct thud_tui *tui, const struct thud_shelved *item, int count, enum thud_picture_format format,
                  const char *folder)
{
    struct thud_error err;
    struct thud_figure *figure[THUD_PICTURES_MAX];
    char name[200], motions[64];
    for (int i = 0; i < count; i++) {
        const struct thud_view *view = tui->view[item[i].screen];
        const struct thud_record *record = view->moved ? tui->doc.record : NULL; /* a study's have their words */
        figure[i] = item[i].figure;
        if (!figure[i])
            continue;
        thud_synthetic_text(thud_records_synthetic(&record, 1), 1, motions, sizeof motions);
        file_name(tui, view->many, figure[i]->name, "", name, sizeof name);
        thud_figure_rename(figure[i], name);
        thud_figure_title_add(figure[i], motions);
    }
    if (count == 1 && figure[0])
        snprintf(tui->files.written, sizeof tui->files.written, "%s/%.100s.png, .gp (draws it again) and .csv", folder,
                 figure[0]->name);
    else
        snprintf(tui->files.written, sizeof tui->files.written, "%d figures into %s: .%s, .gp and .csv of each", count,
                 folder, thud_picture_suffix(format));
    struct thud_picture_screen screen = {.format = THUD_PNG};
    if (count == 1 && format == THUD_PNG)
        screen = thud_tui_picture_screen(tui);
    tui->files.screen = tui->screen;
    if (!thud_tui_succeeded(tui,
                            thud_picture_work_start(figure, count, folder, format, tui->options.gnuplot, &screen,
                                                    &tui->files.work, &err),
                            &err))
        return false;
    tui->backend->also = thud_picture_work_fd(tui->files.work);
    tui->files.done = 0;
    tui->files.count = count;
    thud_tui_say(tui, THUD_ROLE_PLAIN, "Writing %s", tui->files.written);
    return true;
}

void thud_tui_figures(struct thud_tui *tui, const struct thud_shelved *item, int count)
{
    start(tui, item, count, THUD_PNG, thud_tui_folder(tui));
}

void thud_tui_figures_of_report(struct thud_tui *tui, const struct thud_shelved *item, int count)
{
    char *folder = tui->files.for_report;
    const size_t size = sizeof tui->files.for_report;
    snprintf(folder, size, "%.300s/%s-figures", thud_tui_folder(tui), tui->doc.scene.name);
    for (int i = 2; i < 10000 && access(folder, F_OK) == 0; i++) /* what stands in an older one is of an older scene */
        snprintf(folder, size, "%.300s/%s-figures-%d", thud_tui_folder(tui), tui->doc.scene.name, i);
    tui->files.report_wanted = start(tui, item, count, THUD_SVG, folder);
}

void thud_tui_picture_of(struct thud_tui *tui, const struct thud_figure *figure)
{
    const struct thud_chart_window *window = &tui->window[tui->screen];
    struct thud_figure *copy = thud_figure_copy(figure);
    const bool part = tui->chart.plot.w > 1 && window->to > window->from;
    for (int i = 0; copy && part && i < copy->rows * copy->columns; i++) /* what is seen is what is drawn */
        thud_panel_limits(&copy->panel[i], THUD_X, window->from, window->to);
    if (copy)
        thud_tui_figures(tui, &(struct thud_shelved){copy, tui->screen}, 1);
    else
        thud_tui_say(tui, THUD_ROLE_ERROR, "! no memory for the figure");
}

void thud_tui_writing_look(struct thud_tui *tui)
{
    int done, count;
    struct thud_error err = {0};
    bool going = thud_picture_work_look(tui->files.work, &done, &count);
    if (done != tui->files.done || !going)
        thud_tui_redraw(tui, false);
    tui->files.done = done;
    if (going)
        return;
    struct thud_text picture = {0};
    enum thud_status status = thud_picture_work_finish(tui->files.work, &done, &picture, &err);
    tui->files.work = NULL;
    tui->backend->also = -1;
    remember_written(tui, NULL);
    tui->files.report_wanted = tui->files.report_wanted && status == THUD_OK;
    if (status == THUD_OK && picture.size > 0 && tui->dialog.mode == THUD_MODE_NORMAL &&
        tui->files.screen == tui->screen)
        thud_tui_show_picture(tui, &picture);
    thud_text_clear(&picture);
    if (status == THUD_OK)
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written %s", tui->files.written);
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
    if (!tui->files.work)
        return;
    thud_picture_work_stop(tui->files.work);
    thud_picture_work_finish(tui->files.work, &done, NULL, &err);
    tui->files.work = NULL;
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
    remember_written(tui, path);
    if (status != THUD_OK)
        thud_tui_say_error(tui, &err);
    else
        thud_tui_say(tui, THUD_ROLE_GOOD, "Written %s", path);
    return status == THUD_OK;
}
