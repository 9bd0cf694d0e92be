#include <stdio.h>
#include <string.h>

#include "app/run/figure_files.h"
#include "io/file/file.h"

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

enum { SCRIPT, DATA, CAPTION, PICTURE, FILES };

/* The files of one figure: all in the making before the first is to be seen. */
struct set {
    struct thud_text text[FILES];
    bool has[FILES];
};

static enum thud_status make_script(const struct thud_figure *figure, const struct thud_picture_options *options,
                                    struct set *set, struct thud_error *err)
{
    char output[256];
    snprintf(output, sizeof output, "%s.%s", figure->name, thud_picture_suffix(options->format));
    set->has[SCRIPT] = true;
    set->has[DATA] = !options->no_data;
    if (set->has[DATA])
        thud_figure_csv(figure, &set->text[DATA]);
    set->has[CAPTION] = options->no_title; /* what stands no longer in the picture, and its footer */
    if (set->has[CAPTION])
        thud_text_append(&set->text[CAPTION], "%s.%s%s\n", figure->title, *figure->note ? " " : "", figure->note);
    return thud_gnuplot_script(figure, options, output, &set->text[SCRIPT], err);
}

static enum thud_status write_set(const struct thud_figure *figure, const char *folder, const char *picture_suffix,
                                  struct set *set, struct thud_error *err)
{
    const char *const suffix[FILES] = {"gp", "csv", "txt", picture_suffix};
    struct thud_file_draft draft[FILES] = {{0}};
    char path[PATH_ROOM];
    enum thud_status status = thud_folder_make(*folder ? folder : ".", err);
    for (int i = 0; i < FILES && status == THUD_OK; i++) {
        const struct thud_text *text = &set->text[i];
        if (!set->has[i])
            continue;
        status = path_of(figure, folder, suffix[i], path, err);
        if (status == THUD_OK && text->failed)
            status = thud_error_set(err, THUD_MEMORY, "out of memory");
        if (status == THUD_OK)
            status = thud_file_draft(path, text->data ? text->data : "", text->size, THUD_FILE_RESULT, &draft[i], err);
    }
    for (int i = 0; i < FILES; i++) {
        if (status == THUD_OK)
            status = thud_file_keep(&draft[i], err);
        else
            thud_file_drop(&draft[i]);
    }
    return status;
}

static enum thud_status save(const struct thud_figure *figure, const char *folder,
                             const struct thud_picture_options *options, bool draw, struct thud_error *err)
{
    struct set set = {0};
    struct thud_error unwritten = {0};
    enum thud_status status = thud_figure_check(figure, err);
    if (status == THUD_OK)
        status = make_script(figure, options, &set, err);
    if (status == THUD_OK && draw) {
        status = thud_gnuplot_draw(figure, options, &set.text[PICTURE], err);
        set.has[PICTURE] = status == THUD_OK;
    }
    if (status == THUD_OK || status == THUD_GNUPLOT) { /* by script and data the picture can be drawn elsewhere */
        enum thud_status written = write_set(figure, folder, thud_picture_suffix(options->format), &set, &unwritten);
        if (written != THUD_OK && err)
            *err = unwritten;
        status = written == THUD_OK ? status : written;
    }
    for (int i = 0; i < FILES; i++)
        thud_text_clear(&set.text[i]);
    return status;
}

enum thud_status thud_figure_deliver(struct thud_figure *figure, const char *folder,
                                     const struct thud_picture_options *options, enum thud_status before,
                                     struct thud_error *err)
{
    static const struct thud_picture_options chosen;
    options = options ? options : &chosen;
    bool go_on = (before == THUD_OK || before == THUD_GNUPLOT) && !options->none;
    struct thud_error now = {0};
    thud_figure_title_motions(figure, options->motions);
    thud_figure_fit(figure, options);
    if (go_on && figure && options->drawing)
        options->drawing(NULL, figure);
    enum thud_status status = go_on ? save(figure, folder, options, before == THUD_OK, &now) : before;
    thud_figure_free(figure);
    if (!go_on || status == THUD_OK)
        return before; /* the message of the first failure stands */
    if (err)
        *err = now;
    return status;
}
