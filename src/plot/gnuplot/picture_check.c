/* Is a picture whole? gnuplot's exit status does not say. */
#include <stdbool.h>
#include <string.h>

#include "plot/gnuplot/gnuplot_internal.h"

static bool ends(const struct thud_text *picture, const char *mark, size_t within)
{
    size_t n = strlen(mark), from = picture->size > within ? picture->size - within : 0;
    for (size_t i = from; i + n <= picture->size; i++) {
        if (!memcmp(picture->data + i, mark, n))
            return true;
    }
    return false;
}

static bool png_whole(const struct thud_text *picture)
{
    static const unsigned char signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    static const unsigned char last[12] = {0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xae, 0x42, 0x60, 0x82};
    return picture->size > sizeof signature + sizeof last && !memcmp(picture->data, signature, sizeof signature) &&
           !memcmp(picture->data + picture->size - sizeof last, last, sizeof last);
}

/* gnuplot 6 moves the cursor home before the picture; where it stands is for whoever shows it. */
static void drop_home(struct thud_text *picture)
{
    static const char home[] = "\033[H";
    size_t n = sizeof home - 1;
    if (picture->size > n && !memcmp(picture->data, home, n)) {
        picture->size -= n;
        memmove(picture->data, picture->data + n, picture->size + 1);
    }
}

/* gnuplot writes a `]]>` of a text as it is, which XML 1.0 (2.4) takes only for the end of a CDATA section. */
static void escape(struct thud_text *picture)
{
    static const char begin[] = "<![CDATA[", end[] = "]]>";
    struct thud_text out = {0};
    const char *from = picture->data, *at = from, *stop = from + picture->size;
    bool section = false;
    for (; at < stop; at++) {
        size_t left = (size_t)(stop - at);
        if (!section && left > sizeof begin && !memcmp(at, begin, sizeof begin - 1)) {
            section = true;
        } else if (left > sizeof end && !memcmp(at, end, sizeof end - 1)) {
            if (!section) {
                thud_text_bytes(&out, from, (size_t)(at + 2 - from));
                thud_text_bytes(&out, "&gt;", 4);
                from = at + 3;
            }
            section = false;
        }
    }
    if (from == picture->data)
        return;
    thud_text_bytes(&out, from, (size_t)(stop - from));
    thud_text_clear(picture);
    *picture = out;
}

void thud_picture_mend(enum thud_picture_format format, struct thud_text *picture)
{
    if (format == THUD_SIXEL)
        drop_home(picture);
    else if (format == THUD_SVG && picture->data)
        escape(picture);
}

enum thud_status thud_picture_check(enum thud_picture_format format, const struct thud_text *picture,
                                    struct thud_error *err)
{
    bool whole = false;
    if (format == THUD_PNG)
        whole = png_whole(picture);
    else if (format == THUD_SVG)
        whole = picture->size > 5 && !memcmp(picture->data, "<?xml", 5) && ends(picture, "</svg>", 16);
    else if (format == THUD_SIXEL)
        whole = picture->size > 4 && !memcmp(picture->data, "\033P", 2) && ends(picture, "\033\\", 8);
    else
        whole = picture->size > 5 && !memcmp(picture->data, "%PDF-", 5) && ends(picture, "%%EOF", 16);
    if (whole)
        return THUD_OK;
    return thud_error_set(err, THUD_GNUPLOT, "gnuplot ended without a whole %s picture (%zu bytes)",
                          thud_picture_suffix(format), picture->size);
}
