#include "lab/paper/paper_report.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/figure_files.h"
#include "ground/identity.h"
#include "io/file/file.h"
#include "plot/figures/figures_sweep.h"

enum { PATH_MOST = 4200, PICTURE_MOST = 32 << 20 };
enum { FIG2, FIG3, FIG4, FIG5, FIG6, FIG7, FIG8, FIG9, FIG10 };
static const char *const names[THUD_PAPER_FIGURES] = {"fig2", "fig3", "fig4", "fig5", "fig6",
                                                      "fig7", "fig8", "fig9", "fig10"};
enum { NEED_STUDY = 1 << FIG7 | 1 << FIG8 | 1 << FIG10 | THUD_PAPER_REPORT };

const char *thud_paper_figure_name(int index)
{
    return names[index];
}

bool thud_paper_needs_study(unsigned which)
{
    return (which & NEED_STUDY) != 0;
}

enum thud_status thud_paper_figures_parse(int n, const char *const *name, unsigned *which, struct thud_error *err)
{
    *which = n == 0 ? THUD_PAPER_ALL | THUD_PAPER_REPORT : 0;
    for (int i = 0; i < n; i++) {
        unsigned found = strcmp(name[i], "all") ? 0 : THUD_PAPER_ALL | THUD_PAPER_REPORT;
        for (int k = 0; k < THUD_PAPER_FIGURES; k++)
            found |= strcmp(name[i], names[k]) ? 0 : 1u << k;
        if (!found)
            return thud_error_refuse(err, THUD_USAGE, NULL, "fig2 to fig10, all", "\"%s\" is not a figure", name[i]);
        *which |= found;
    }
    return THUD_OK;
}

/* Those that need no study. */
static enum thud_status (*const makers[THUD_PAPER_FIGURES])(struct thud_figure **out, struct thud_error *err) = {
    [FIG2] = thud_figure_paper2, [FIG3] = thud_figure_paper3, [FIG4] = thud_figure_paper4,
    [FIG5] = thud_figure_paper5, [FIG6] = thud_figure_paper6, [FIG9] = thud_figure_paper9};

static struct thud_figure *make_of_study(int index, const struct thud_paper_study *study)
{
    char title[256];
    const bool cavity = index == FIG10;
    assert(study);
    if (index == FIG7) {
        snprintf(title, sizeof title, "%s: peak response with a 5 cm bumper, over that without, at the same gap",
                 study->table->record[0]);
        return thud_figure_by_floor(study->table, 0, THUD_CASE_BUMPER, names[index], title);
    }
    snprintf(title, sizeof title,
             "Mean peak response over the floors with a 5 cm bumper%s, over that without, at the same gap",
             cavity ? " in a 1 cm cavity" : "");
    return thud_figure_of_means(study->table, cavity ? THUD_CASE_CAVITY : THUD_CASE_BUMPER, names[index], title);
}

/* What the report says of a figure, before the figure goes. */
static void keep_words(const struct thud_figure *figure, const char *suffix, struct thud_paper_picture *out)
{
    snprintf(out->file, sizeof out->file, "%s.%s", figure->name, suffix);
    snprintf(out->caption, sizeof out->caption, "%s.", figure->title);
    thud_figure_words(figure, &out->alt);
}

/* The drawn picture, of a format that a page can show. */
static void keep_bytes(const char *folder, const struct thud_picture_options *options, struct thud_paper_picture *out)
{
    char path[PATH_MOST], *bytes = NULL;
    size_t size = 0;
    if (options->format == THUD_PDF)
        return;
    int n = snprintf(path, sizeof path, "%s/%s", *folder ? folder : ".", out->file);
    if (n < (int)sizeof path && thud_file_read(path, PICTURE_MOST, &bytes, &size, NULL) == THUD_OK)
        thud_text_bytes(&out->bytes, bytes, size);
    free(bytes);
}

static enum thud_status write_report(const struct thud_paper_study *study, struct thud_paper_picture *picture,
                                     const char *folder, struct thud_error *err)
{
    struct thud_paper_pair pair[THUD_PAPER_COLLISIONS];
    assert(study);
    struct thud_paper_study whole = *study;
    struct thud_text text = {0};
    struct thud_document document = {0};
    enum thud_status status = thud_paper_pairs(pair, err);
    if (status != THUD_OK)
        return status;
    whole.pair = pair;
    whole.picture = picture;
    thud_paper_study_json(&whole, &text);
    status = thud_text_save(&text, folder, "study.json", THUD_OK, err);
    thud_paper_report(&whole, &document);
    if (status == THUD_OK)
        status = thud_document_deliver(&document, folder, err);
    thud_document_clear(&document);
    return status;
}

/* One figure into the folder. */
static enum thud_status save(int i, const struct thud_paper_study *study, const char *folder,
                             const struct thud_picture_options *options, struct thud_paper_picture *picture,
                             enum thud_status before, struct thud_error *err)
{
    struct thud_figure *figure = NULL;
    enum thud_status status = THUD_OK;
    if (makers[i])
        status = makers[i](&figure, err);
    else
        figure = make_of_study(i, study);
    if (status == THUD_OK)
        status = thud_figure_check(figure, err);
    if (status != THUD_OK) {
        thud_figure_free(figure);
        return status;
    }
    if (!makers[i]) {
        char motions[64];
        thud_synthetic_text(thud_paper_synthetic(study), study->table->nrecords, motions, sizeof motions);
        thud_figure_title_add(figure, motions);
    }
    keep_words(figure, thud_picture_suffix(options->format), picture);
    status = thud_figure_deliver(figure, folder, options, before, err);
    if (status == THUD_OK)
        keep_bytes(folder, options, picture);
    return status;
}

enum thud_status thud_paper_figures_save(unsigned which, const struct thud_paper_study *study, const char *folder,
                                         const struct thud_picture_options *options, struct thud_error *err)
{
    assert(study || !thud_paper_needs_study(which));
    enum thud_status status = THUD_OK;
    struct thud_paper_picture picture[THUD_PAPER_FIGURES] = {0};
    for (int i = 0; i < THUD_PAPER_FIGURES && (status == THUD_OK || status == THUD_GNUPLOT); i++)
        if (which >> i & 1u)
            status = save(i, study, folder, options, &picture[i], status, err);
    if (which & THUD_PAPER_REPORT && (status == THUD_OK || status == THUD_GNUPLOT)) {
        struct thud_error now = {0};
        enum thud_status written = write_report(study, picture, folder, &now);
        if (written != THUD_OK && err)
            *err = now;
        status = written == THUD_OK ? status : written;
    }
    for (int i = 0; i < THUD_PAPER_FIGURES; i++) {
        thud_text_clear(&picture[i].alt);
        thud_text_clear(&picture[i].bytes);
    }
    return status;
}
