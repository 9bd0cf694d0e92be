/* The screen as a picture in SVG: letters of one width, roles in the colours of the dark theme. */
#include "tui/terminal/canvas_svg.h"

#include "tui/terminal/roles.h"

enum { CELL_W = 8, CELL_H = 17, LETTERS = 13, EDGE = 10, COLORS = 256 };

/* Of the 256 of terminals those from 16 on: a cube of 6 x 6 x 6, then greys. */
static unsigned rgb(int role)
{
    static const unsigned level[] = {0x00, 0x5f, 0x87, 0xaf, 0xd7, 0xff};
    int c = thud_role_color(THUD_THEME_DARK, role, COLORS) - 16;
    if (c < 0)
        return 0xe0e0e0; /* the terminal's own */
    if (c < 216)
        return level[c / 36] << 16 | level[c / 6 % 6] << 8 | level[c % 6];
    return (unsigned)(8 + 10 * (c - 216)) * 0x010101u;
}

/* Glyphs beyond ASCII may come from another font, so they do not stand in one run with letters. */
static bool is_same(const struct thud_cell *a, const struct thud_cell *b)
{
    return a->style.role == b->style.role && a->style.attr == b->style.attr && (a->glyph < 0x80) == (b->glyph < 0x80);
}

static void put_glyph(uint32_t glyph, struct thud_text *out)
{
    char utf8[5];
    if (glyph == '&' || glyph == '<')
        thud_text_append(out, glyph == '&' ? "&amp;" : "&lt;");
    else if (glyph != THUD_CELL_TAIL)
        thud_text_bytes(out, utf8, (size_t)thud_utf8_put(glyph, utf8));
}

/* Cells of one look from x on; returns where the next look begins. */
static int put_run(const struct thud_cell *row, int x, int y, int width, struct thud_text *out)
{
    int end = x, last = x;
    for (; end < width && is_same(&row[x], &row[end]); end++)
        last = row[end].glyph != ' ' ? end + 1 : last;
    const bool reversed = row[x].style.attr & THUD_REVERSE;
    const unsigned color = rgb(row[x].style.role);
    const int left = EDGE + CELL_W * x, base = EDGE + CELL_H * y + LETTERS;
    if (reversed)
        thud_text_append(out, "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"#%06x\"/>\n", left,
                         EDGE + CELL_H * y, CELL_W * (end - x), CELL_H, color);
    if (last == x)
        return end;
    thud_text_append(out, "<text x=\"");
    for (int i = x; i < last; i++) /* each cell has its place, whatever the width of the font's letters */
        if (row[i].glyph != THUD_CELL_TAIL)
            thud_text_append(out, "%s%d", i > x ? " " : "", EDGE + CELL_W * i);
    thud_text_append(out, "\" y=\"%d\" fill=\"#%06x\"%s%s>", base, reversed ? 0x101418u : color,
                     row[x].style.attr & THUD_BOLD ? " font-weight=\"bold\"" : "",
                     row[x].style.attr & THUD_UNDERLINE ? " text-decoration=\"underline\"" : "");
    for (int i = x; i < last; i++)
        put_glyph(row[i].glyph, out);
    thud_text_append(out, "</text>\n");
    return end;
}

void thud_canvas_svg(const struct thud_canvas *canvas, struct thud_text *out)
{
    const int width = CELL_W * canvas->width + 2 * EDGE, height = CELL_H * canvas->height + 2 * EDGE;
    thud_text_append(out,
                     "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">\n"
                     "<title>thud in a terminal</title>\n<rect width=\"100%%\" height=\"100%%\" rx=\"6\" "
                     "fill=\"#101418\"/>\n<g font-family=\"DejaVu Sans Mono, Menlo, Consolas, monospace\" "
                     "font-size=\"%d\" xml:space=\"preserve\">\n",
                     width, height, width, height, LETTERS);
    for (int y = 0; y < canvas->height; y++)
        for (int x = 0; x < canvas->width;)
            x = put_run(canvas->cell + (size_t)y * (size_t)canvas->width, x, y, canvas->width, out);
    thud_text_append(out, "</g>\n</svg>\n");
}
