/* Options of pictures, as typed. */
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "plot/gnuplot/gnuplot.h"

static const char *const suffixes[] = {
    [THUD_PNG] = "png", [THUD_SVG] = "svg", [THUD_PDF] = "pdf", [THUD_SIXEL] = "sixel"};
enum { SIZE_LEAST = 200, SIZE_MOST = 10000 };
static const double font_least_px = 4.0, font_most_px = 400.0;

const char *thud_picture_suffix(enum thud_picture_format format)
{
    return suffixes[format];
}

enum thud_status thud_picture_format_parse(const char *text, enum thud_picture_format *out, struct thud_error *err)
{
    for (int i = 0; i < THUD_PICTURE_FORMATS; i++) {
        if (!strcmp(text, suffixes[i])) {
            *out = (enum thud_picture_format)i;
            return THUD_OK;
        }
    }
    return thud_error_refuse(err, THUD_USAGE, "--format", "png, svg, pdf", "\"%s\" is not a picture format", text);
}

enum thud_status thud_picture_width_parse(const char *text, double *width_mm, struct thud_error *err)
{
    static const double least_m = 0.04, most_m = 0.6;
    struct thud_quantity q;
    if (thud_quantity_parse(text, THUD_LENGTH, NULL, &q, NULL) == THUD_OK && q.value >= least_m && q.value <= most_m) {
        *width_mm = 1e3 * q.value;
        return THUD_OK;
    }
    thud_error_set(err, THUD_USAGE, "\"%s\" is not a width on paper", text);
    thud_error_key(err, "--width");
    thud_error_allow(err, "%g mm to %g mm: 90mm is a column, 190mm a page", 1e3 * least_m, 1e3 * most_m);
    return THUD_USAGE;
}

enum thud_status thud_picture_size_parse(const char *text, int *width_px, int *height_px, struct thud_error *err)
{
    char *end;
    long width = strtol(text, &end, 10), height = 0;
    const char *rest = *end == 'x' && end[1] >= '0' && end[1] <= '9' ? end + 1 : "";
    if (*rest)
        height = strtol(rest, &end, 10);
    bool digit = *text >= '0' && *text <= '9';
    if (!digit || !*rest || *end || width < SIZE_LEAST || width > SIZE_MOST || height < SIZE_LEAST ||
        height > SIZE_MOST) {
        thud_error_set(err, THUD_USAGE, "\"%s\" is not a picture size", text);
        thud_error_key(err, "--size");
        thud_error_allow(err, "WIDTHxHEIGHT in pixels, each %d to %d, such as 1800x1200", SIZE_LEAST, SIZE_MOST);
        return THUD_USAGE;
    }
    *width_px = (int)width;
    *height_px = (int)height;
    return THUD_OK;
}

enum thud_status thud_picture_font_parse(const char *text, char *name, size_t size, double *font_px,
                                         struct thud_error *err)
{
    size_t length = strcspn(text, ",");
    const char *end = text + length;
    double px = *font_px;
    bool good = length > 0 && length < size;
    if (good && *end == ',')
        good = thud_number_parse(end + 1, &end, &px) == 0 && *end == '\0' && px >= font_least_px && px <= font_most_px;
    if (!good) {
        thud_error_set(err, THUD_USAGE, "\"%s\" is not a font", text);
        thud_error_key(err, "--font");
        thud_error_allow(err, "NAME or NAME,PIXELS with %g to %g pixels, such as \"DejaVu Serif,28\"", font_least_px,
                         font_most_px);
        return THUD_USAGE;
    }
    memcpy(name, text, length);
    name[length] = '\0';
    *font_px = px;
    return THUD_OK;
}
