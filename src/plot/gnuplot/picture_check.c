/* Is a picture whole? gnuplot's exit status does not say. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
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

static void put_xml(struct thud_text *out, const char *text)
{
    for (; *text; text++)
        if (strchr("&<>", *text))
            thud_text_append(out, *text == '&' ? "&amp;" : *text == '<' ? "&lt;" : "&gt;");
        else
            thud_text_bytes(out, text, 1);
}

static bool begins(const char *at, const char *stop, const char *word)
{
    size_t n = strlen(word);
    return (size_t)(stop - at) >= n && memcmp(at, word, n) == 0;
}

/* What stands in place of gnuplot's own title at `at`; NULL: nothing does. A curve without a name has that of its
 * panel, or else of its vertical axis. The marks of the key, and panels without curves, have an empty one. */
static const char *title_of(const struct thud_figure *figure, const char *at, const char *stop)
{
    int panel = 0, series = 0;
    if (begins(at, stop, "Gnuplot<"))
        return figure->title;
    if (begins(at, stop, "'+'") || begins(at, stop, "gnuplot_plot"))
        return "";
    if (!begins(at, stop, "$P") || sscanf(at, "$P%dS%d", &panel, &series) != 2 || panel < 1 || series < 1 ||
        panel > figure->rows * figure->columns || series > figure->panel[panel - 1].nseries)
        return NULL;
    const struct thud_panel *in = &figure->panel[panel - 1];
    const char *name = in->series[series - 1]->name;
    return *name ? name : *in->title ? in->title : in->axis[THUD_Y].label;
}

/* What replaces the text at `at`, of *length bytes, where gnuplot uses the current colour. A group names its own. A
 * mark (an even number from 4 on is a filled one) draws with that of its place. Readers such as WeasyPrint do not
 * follow the current colour. */
static void replace_color(const char *at, const char *stop, const char **color, int *mark, size_t *length,
                          struct thud_text *with)
{
    static const char own[] = "color=\"", group[] = "stroke=\"currentColor\"", use[] = " color='", number[] = "#gpPt";
    static const char *const drop[] = {" stroke='currentColor'", " fill='currentColor'"};
    *length = 0;
    if (*at == 'c' && begins(at, stop, own))
        *color = at + sizeof own - 1;
    else if (*at == '#' && begins(at, stop, number))
        *mark = atoi(at + sizeof number - 1);
    else if (*at == 's' && begins(at, stop, group)) {
        *length = sizeof group - 1;
        thud_text_append(with, "stroke=\"%.*s\"", (int)strcspn(*color, "\""), *color);
    } else if (*at == ' ' && begins(at, stop, use)) {
        const char *value = at + sizeof use - 1;
        const int n = (int)strcspn(value, "'");
        *length = sizeof use + (size_t)n;
        thud_text_append(with, " stroke='%.*s' fill='%.*s'", n, value, *mark >= 4 && *mark % 2 == 0 ? n : 4,
                         *mark >= 4 && *mark % 2 == 0 ? value : "none");
    }
    for (int i = 0; i < 2 && *at == ' '; i++)
        if (begins(at, stop, drop[i]))
            *length = strlen(drop[i]);
}

/* Titles and description by the figure, and its colours. */
static void name_parts(const struct thud_figure *figure, struct thud_text *picture)
{
    static const char title[] = "<title>", about[] = "<desc>";
    struct thud_text out = {0}, words = {0};
    const char *from = picture->data, *stop = from + picture->size, *color = "black\"";
    int mark = 0;
    thud_figure_words(figure, &words);
    for (const char *at = from; at < stop; at++) {
        struct thud_text with = {0};
        const char *text = NULL;
        size_t own = 0, length;
        if (*at == '<' && begins(at, stop, title)) {
            own = sizeof title - 1;
            text = title_of(figure, at + own, stop);
        } else if (*at == '<' && begins(at, stop, about)) {
            own = sizeof about - 1;
            text = words.data ? words.data : "";
        }
        replace_color(at, stop, &color, &mark, &length, &with);
        if (text) {
            const char *end = memchr(at + own, '<', (size_t)(stop - at) - own);
            length = (size_t)((end ? end : stop) - at) - own;
            put_xml(&with, text);
        }
        if (!text && length == 0)
            continue;
        thud_text_bytes(&out, from, (size_t)(at - from) + own);
        thud_text_bytes(&out, with.data ? with.data : "", with.size);
        out.failed |= with.failed;
        thud_text_clear(&with);
        from = at + own + length;
        at = from - 1;
    }
    thud_text_bytes(&out, from, (size_t)(stop - from));
    thud_text_clear(&words);
    thud_text_clear(picture);
    *picture = out;
}

void thud_picture_mend(const struct thud_figure *figure, enum thud_picture_format format, struct thud_text *picture)
{
    if (format == THUD_SIXEL)
        drop_home(picture);
    else if (format == THUD_SVG && picture->data) {
        escape(picture);
        name_parts(figure, picture);
    }
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
