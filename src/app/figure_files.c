#include <stdio.h>
#include <string.h>

#include "app/figure_files.h"
#include "io/file.h"

enum { PATH_ROOM = 4096 };

static enum thud_status path_of(const struct thud_figure *figure, const char *folder, const char *suffix, char *path,
                                struct thud_error *err)
{
    const char *slash = *folder && folder[strlen(folder) - 1] == '/' ? "" : "/";
    int n = snprintf(path, PATH_ROOM, "%s%s%s.%s", *folder ? folder : ".", slash, figure->name, suffix);
    if (n > 0 && n < PATH_ROOM)
        return THUD_OK;
    return thud_error_set(err, THUD_OUTPUT, "the path to %s.%s is too long", figure->name, suffix);
}

static enum thud_status write_script(const struct thud_figure *figure, const char *folder,
                                     const struct thud_picture_options *options, struct thud_error *err)
{
    char path[PATH_ROOM], output[256];
    struct thud_text text = {0};
    snprintf(output, sizeof output, "%s.%s", figure->name, thud_picture_suffix(options->format));
    enum thud_status status = path_of(figure, folder, "gp", path, err);
    if (status == THUD_OK)
        status = thud_gnuplot_script(figure, options, output, &text, err);
    if (status == THUD_OK)
        status = thud_text_write(&text, path, err);
    thud_text_clear(&text);
    return status;
}

static enum thud_status write_data(const struct thud_figure *figure, const char *folder, struct thud_error *err)
{
    char path[PATH_ROOM];
    struct thud_text text = {0};
    enum thud_status status = path_of(figure, folder, "csv", path, err);
    if (status == THUD_OK) {
        thud_figure_csv(figure, &text);
        status = thud_text_write(&text, path, err);
    }
    thud_text_clear(&text);
    return status;
}

static enum thud_status write_picture(const struct thud_figure *figure, const char *folder,
                                      const struct thud_picture_options *options, struct thud_error *err)
{
    char path[PATH_ROOM];
    struct thud_text picture = {0};
    enum thud_status status = path_of(figure, folder, thud_picture_suffix(options->format), path, err);
    if (status == THUD_OK)
        status = thud_gnuplot_draw(figure, options, &picture, err);
    if (status == THUD_OK)
        status = thud_text_write(&picture, path, err);
    thud_text_clear(&picture);
    return status;
}

static enum thud_status save(const struct thud_figure *figure, const char *folder,
                             const struct thud_picture_options *options, bool draw, struct thud_error *err)
{
    static const struct thud_picture_options chosen;
    if (!options)
        options = &chosen;
    enum thud_status status = thud_figure_check(figure, err);
    if (status == THUD_OK)
        status = thud_folder_make(*folder ? folder : ".", err);
    if (status == THUD_OK)
        status = write_script(figure, folder, options, err);
    if (status == THUD_OK && !options->no_data)
        status = write_data(figure, folder, err);
    if (status == THUD_OK && draw)
        status = write_picture(figure, folder, options, err);
    return status;
}

enum thud_status thud_figure_deliver(struct thud_figure *figure, const char *folder,
                                     const struct thud_picture_options *options, enum thud_status before,
                                     struct thud_error *err)
{
    bool go_on = before == THUD_OK || before == THUD_GNUPLOT;
    struct thud_error now = {0};
    enum thud_status status = go_on ? save(figure, folder, options, before == THUD_OK, &now) : before;
    thud_figure_free(figure);
    if (!go_on || status == THUD_OK)
        return before; /* the message of the first failure stands */
    if (err)
        *err = now;
    return status;
}
