#include "cli/options.h"

#include <stdlib.h>
#include <string.h>

#include "cli/commands.h"
#include "ground/identity.h"

enum thud_status thud_picture_options_read(const struct thud_args *args, struct thud_picture_choice *choice,
                                           struct thud_error *err)
{
    memset(choice, 0, sizeof *choice);
    struct thud_picture_options *options = &choice->options;
    const char *format = thud_args_value(args, "format"), *size = thud_args_value(args, "size"),
               *width = thud_args_value(args, "width"), *font = thud_args_value(args, "font"),
               *program = getenv("THUD_GNUPLOT");
    enum thud_status status = THUD_OK;
    if (format)
        status = thud_picture_format_parse(format, &options->format, err);
    if (!status && size)
        status = thud_picture_size_parse(size, &options->width_px, &options->height_px, err);
    if (!status && width && size)
        status = thud_error_set(err, THUD_USAGE, "--width and --size together");
    if (!status && width)
        status = thud_picture_width_parse(width, &options->width_mm, err);
    if (!status && font) {
        status = thud_picture_font_parse(font, choice->font, sizeof choice->font, &options->font_px, err);
        options->font = choice->font;
    }
    options->none = thud_args_has(args, "no-figures");
    options->no_title = thud_args_has(args, "no-title");
    options->drawing = thud_progress_drawing;
    if (program && program[0])
        options->program = program;
    return status;
}

void thud_picture_options_motions(struct thud_picture_choice *choice, const struct thud_record *const *record, int n)
{
    thud_synthetic_text(thud_records_synthetic(record, n), n, choice->options.motions, sizeof choice->options.motions);
}
