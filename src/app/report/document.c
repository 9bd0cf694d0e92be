#include "app/report/document.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/grow.h"
#include "io/file/file.h"

enum kind { TITLE, CONTENTS, HEADING, PARAGRAPH, ITEM, LINES, TABLE, CELL, ROW, FIGURE };

struct thud_document_piece {
    enum kind kind;
    struct thud_text text, file, alt, picture; /* all but text: of a figure */
};

enum { SENTENCES_MAX = 4000 };

static struct thud_document_piece *add(struct thud_document *d, enum kind kind, const char *text)
{
    struct thud_document_piece *grown = thud_grow(d->piece, d->n, sizeof *grown);
    if (!grown) {
        d->failed = true;
        return NULL;
    }
    d->piece = grown;
    struct thud_document_piece *piece = &grown[d->n++];
    *piece = (struct thud_document_piece){.kind = kind};
    thud_text_bytes(&piece->text, text, strlen(text));
    d->failed = d->failed || piece->text.failed;
    return piece;
}

void thud_document_title(struct thud_document *document, const char *text)
{
    add(document, TITLE, text);
}

void thud_document_contents(struct thud_document *document)
{
    add(document, CONTENTS, "");
}

void thud_document_heading(struct thud_document *document, const char *text)
{
    add(document, HEADING, text);
}

#define ADD_FORMATTED(document, kind, fmt)                                                                             \
    do {                                                                                                               \
        char text[SENTENCES_MAX];                                                                                      \
        va_list args;                                                                                                  \
        va_start(args, fmt);                                                                                           \
        vsnprintf(text, sizeof text, fmt, args);                                                                       \
        va_end(args);                                                                                                  \
        add(document, kind, text);                                                                                     \
    } while (0)

void thud_document_paragraph(struct thud_document *document, const char *fmt, ...)
{
    ADD_FORMATTED(document, PARAGRAPH, fmt);
}

void thud_document_item(struct thud_document *document, const char *fmt, ...)
{
    ADD_FORMATTED(document, ITEM, fmt);
}

void thud_document_cell(struct thud_document *document, const char *fmt, ...)
{
    ADD_FORMATTED(document, CELL, fmt);
}

void thud_document_lines(struct thud_document *document, const char *text)
{
    add(document, LINES, text);
}

void thud_document_table(struct thud_document *document, const char *caption)
{
    add(document, TABLE, caption);
}

static const char *text_of(const struct thud_document_piece *piece)
{
    return piece->text.data ? piece->text.data : "";
}

static int count_columns(const struct thud_document *document, size_t table)
{
    size_t i = table + 1;
    while (i < document->n && document->piece[i].kind == CELL)
        i++;
    return (int)(i - table - 1);
}

/* Whether the cells after the first one since a piece say that there is nothing to say. */
static bool is_bare(const struct thud_document *document, size_t first)
{
    for (size_t i = first + 1; i < document->n; i++)
        if (!document->piece[i].text.data || strcmp(document->piece[i].text.data, "-") != 0)
            return false;
    return first + 1 < document->n;
}

/* Whether all cells of column k below a table's head are "-". */
static bool column_is_bare(const struct thud_document *document, size_t table, int k)
{
    int column = 0, row = 0;
    for (size_t i = table + 1; i < document->n && document->piece[i].kind >= CELL; i++)
        if (document->piece[i].kind == ROW) {
            row++;
            column = 0;
        } else if (column++ == k && row > 0 && strcmp(text_of(&document->piece[i]), "-") != 0) {
            return false;
        }
    return row > 1;
}

/* Takes out what stands in column k of a table. */
static void take_column(struct thud_document *document, size_t table, int k)
{
    int column = 0;
    for (size_t i = table + 1; i < document->n && document->piece[i].kind >= CELL; i++)
        if (document->piece[i].kind == ROW)
            column = 0;
        else if (column++ == k)
            thud_document_take(document, i--, 1);
}

void thud_document_tidy(struct thud_document *document)
{
    for (size_t table = 0; table < document->n; table++) {
        if (document->piece[table].kind != TABLE)
            continue;
        for (int k = count_columns(document, table) - 1; k > 0; k--)
            if (column_is_bare(document, table, k))
                take_column(document, table, k);
        const size_t body = table + (size_t)count_columns(document, table) + 2;
        if (*text_of(&document->piece[table]) && (body >= document->n || document->piece[body].kind < CELL)) {
            thud_document_take(document, table, body - table);
            table--; /* the next piece stands there now */
        }
    }
}

void thud_document_row(struct thud_document *document)
{
    size_t first = document->n;
    while (first > 0 && document->piece[first - 1].kind == CELL)
        first--;
    if (is_bare(document, first))
        thud_document_cut(document, first);
    else
        add(document, ROW, "");
}

void thud_document_head(struct thud_document *document, const char *cells)
{
    for (size_t n; n = strcspn(cells, "|"), n > 0; cells += n + (cells[n] == '|'))
        thud_document_cell(document, "%.*s", (int)n, cells);
    thud_document_row(document);
}

static void add_cells(struct thud_document *document, const char *fmt, va_list args)
{
    char text[SENTENCES_MAX], *at = text;
    vsnprintf(text, sizeof text, fmt, args);
    for (size_t n; at; at = at[n] ? at + n + 1 : NULL) {
        n = strcspn(at, "\t");
        thud_document_cell(document, "%.*s", (int)n, at);
    }
}

void thud_document_cells(struct thud_document *document, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    add_cells(document, fmt, args);
    va_end(args);
}

void thud_document_line(struct thud_document *document, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    add_cells(document, fmt, args);
    va_end(args);
    thud_document_row(document);
}

void thud_document_figure(struct thud_document *document, const char *file, const char *caption, const char *alt,
                          struct thud_text *picture)
{
    struct thud_document_piece *piece = add(document, FIGURE, caption);
    if (!piece) {
        thud_text_clear(picture);
        return;
    }
    thud_text_append(&piece->file, "%s", file);
    thud_text_append(&piece->alt, "%s", alt);
    piece->picture = *picture;
    *picture = (struct thud_text){0};
    document->failed = document->failed || piece->file.failed || piece->alt.failed || piece->picture.failed;
}

const struct thud_text *thud_document_picture(const struct thud_document *document, int i, const char **file)
{
    for (size_t k = 0; k < document->n; k++)
        if (document->piece[k].kind == FIGURE && i-- == 0) {
            *file = document->piece[k].file.data;
            return &document->piece[k].picture;
        }
    return NULL;
}

void thud_document_take(struct thud_document *document, size_t n, size_t count)
{
    size_t end = n + count < document->n ? n + count : document->n;
    for (size_t i = n; i < end; i++) {
        struct thud_document_piece *piece = &document->piece[i];
        struct thud_text *const text[] = {&piece->text, &piece->file, &piece->alt, &piece->picture};
        for (size_t k = 0; k < sizeof text / sizeof *text; k++)
            thud_text_clear(text[k]);
    }
    if (end <= n)
        return;
    memmove(&document->piece[n], &document->piece[end], (document->n - end) * sizeof *document->piece);
    document->n -= end - n;
}

void thud_document_cut(struct thud_document *document, size_t n)
{
    if (n < document->n)
        thud_document_take(document, n, document->n - n);
}

void thud_document_clear(struct thud_document *document)
{
    thud_document_cut(document, 0);
    free(document->piece);
    *document = (struct thud_document){0};
}

/* Sections, tables and figures are counted each on their own; what has no caption is not counted. */
static int number_of(const struct thud_document *document, size_t i)
{
    int number = 0;
    for (size_t k = 0; k <= i; k++)
        number += document->piece[k].kind == document->piece[i].kind && document->piece[k].text.size > 0;
    return number;
}

/* "Table 3. ", "Figure 1. " */
static void put_number(const struct thud_document *document, size_t i, struct thud_text *out)
{
    if (document->piece[i].text.size == 0)
        return;
    thud_text_append(out, "%s %d. ", document->piece[i].kind == TABLE ? "Table" : "Figure", number_of(document, i));
}

static bool is_words(const char *text)
{
    return strlen(text) > 24 || !strchr("0123456789+-.<[", *text);
}

/* Words begin at the left of their column, numbers end at its right: of a table, one of whose body's cells in column k
 * is in words. */
static bool column_is_words(const struct thud_document *document, size_t table, int k)
{
    int column = 0, row = 0;
    bool empty = true;
    for (size_t i = table + 1; i < document->n; i++) {
        const struct thud_document_piece *piece = &document->piece[i];
        if (piece->kind == ROW) {
            row++;
            column = 0;
        } else if (piece->kind != CELL) {
            break;
        } else if (column++ == k && row > 0) {
            if (is_words(text_of(piece)))
                return true;
            empty = empty && !*text_of(piece);
        }
    }
    return empty;
}

/* ---- HTML ---- */

static void escape_html(struct thud_text *out, const char *text)
{
    static const char special[] = "&<>\"'", *const entity[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
    for (const char *at = text; *at; at++) {
        const char *found = strchr(special, *at);
        if (found)
            thud_text_append(out, "%s", entity[found - special]);
        else
            thud_text_bytes(out, (unsigned char)*at >= ' ' || *at == '\n' || *at == '\t' ? at : "?", 1);
    }
}

/* The length of a word that is a unit: "%", "kN/mm", "m2"; 0: it is none. */
static size_t unit_length(const char *at)
{
    static const char *const unit[] = {"%",  "mm", "cm", "km", "m",  "s",  "g",   "t",  "N",
                                       "kN", "MN", "GN", "kJ", "MJ", "Hz", "MPa", "GPa"};
    for (size_t i = 0; i < sizeof unit / sizeof *unit; i++) {
        const size_t n = strlen(unit[i]);
        if (strncmp(at, unit[i], n) == 0 && !thud_ascii_is_alpha(at[n]))
            return strcspn(at, " ,;:()[]|");
    }
    return 0;
}

/* Of sentences and cells: a number does not break from its unit, nor the unit within. */
static void html_text(struct thud_text *out, const char *text)
{
    static const char no_break_space[] = "\u00a0", word_joiner[] = "\u2060";
    const char *unit_end = text;
    for (const char *at = text; *at; at++) {
        const char letter[] = {*at, '\0'};
        if (*at == ' ' && at > text && thud_ascii_is_digit(at[-1]) && unit_length(at + 1) > 0)
            unit_end = at + 1 + unit_length(at + 1);
        escape_html(out, *at == ' ' && at < unit_end ? no_break_space : letter);
        if (*at == '/' && at < unit_end)
            thud_text_append(out, "%s", word_joiner);
    }
}

/* A4: 210 mm less 10 mm on both sides is what a figure of 190 mm takes. */
static const char style[] =
    "@page { size: A4; margin: 12mm 10mm 16mm 10mm; @bottom-right { content: 'page ' counter(page) ' of ' "
    "counter(pages); "
    "font-size: 8pt } @bottom-left { content: string(title); font-size: 8pt } }\n"
    "html { font: 10.5pt/1.45 'DejaVu Sans', Verdana, sans-serif; color: #111; background: #fff }\n"
    "body { max-width: 190mm; margin: 8mm auto; padding: 0 4mm }\n"
    "h1 { font-size: 1.6em; line-height: 1.2; margin: 0 0 .6em; string-set: title content() }\n"
    "h2 { font-size: 1.2em; margin: 1.6em 0 .4em; border-bottom: 1px solid #888; break-after: avoid }\n"
    "main > div { overflow-x: auto } tbody th { max-width: 22em; overflow-wrap: break-word }\n"
    "p, li { margin: .4em 0 } p.lead { break-after: avoid } ul { padding-left: 1.4em }\n"
    "table { border-collapse: collapse; margin: .8em 0; font-size: .9em; width: 100% }\n"
    "caption { text-align: left; font-weight: bold; margin-bottom: .3em }\n"
    "th, td { padding: .15em .5em; text-align: right; border-bottom: 1px solid #ccc; font-variant-numeric: "
    "tabular-nums }\n"
    "td.words, thead th.words { text-align: left } td:not(.words), .short { white-space: nowrap }\n"
    "thead th { border-bottom: 1px solid #333; vertical-align: bottom }\n"
    "th[scope=row], thead th:first-child { text-align: left; font-weight: normal }\n"
    "thead th:first-child { font-weight: bold } thead th.caption { border: 0; padding: 0 0 .3em; font-size: 1em }\n"
    "table.wide { font-size: .8em } table.wide th, table.wide td { padding: .15em .3em }\n"
    "table, tr { break-inside: avoid } table.long { break-inside: auto } caption, thead { break-after: avoid }\n"
    "tr.first { break-after: avoid } tr.last { break-before: avoid }\n"
    "nav ol { columns: 2; list-style: none; padding: 0 } nav a, td a { color: inherit; text-decoration: none }\n"
    "td a { padding-right: 2em } td a::after { content: ', page ' target-counter(attr(href), page) }\n"
    "nav a::after { content: leader('.') target-counter(attr(href), page) }\n"
    "figure { margin: 1em 0; break-inside: avoid } figure img { width: 100%; height: auto; display: block }\n"
    "figcaption { font-size: .9em } pre { font: .8em/1.35 'DejaVu Sans Mono', monospace; background: #f4f4f4; padding: "
    ".6em; white-space: pre-wrap; overflow-wrap: anywhere; orphans: 12; widows: 12 }\n"
    "@media print { html { font-size: 9.5pt } body { margin: 0; padding: 0; max-width: none } figure img { max-height: "
    "120mm; object-fit: contain } pre { font-size: .7em; background: none; "
    "border: 1px solid #aaa } }\n";

/* Where the writer stands: in a list, in a table, in which column and row (of its body) of how many. */
struct place {
    bool list, table, body, shared; /* shared: the columns of the table share its width */
    int column, row, rows;
    size_t at; /* the table */
};

static void html_leave(struct thud_text *out, struct place *place, enum kind next)
{
    if (place->list && next != ITEM) {
        thud_text_append(out, "</ul>\n");
        place->list = false;
    }
    if (place->table && next != CELL && next != ROW) {
        thud_text_append(out, "%s</table></div>\n", place->body ? "</tbody>" : "");
        place->table = false;
    }
}

static void html_element(struct thud_text *out, const char *open, const char *text, const char *close)
{
    thud_text_append(out, "%s", open);
    html_text(out, text);
    thud_text_append(out, "%s", close);
}

/* The name of a row that is kept on one line. */
enum { SHORT_MOST = 48, WORDS_SHORT = 16 };

/* A table of more rows may go over a page's end: kept together it would leave half a page empty. So many rows at its
 * head and at its foot stay together. Its caption is a row of its head, which every page repeats. */
enum { ROWS_TOGETHER = 16, ROWS_AT_END = 3 };

/* A table of more columns than a page takes in the letters of others has smaller ones. */
enum { COLUMNS_WIDE = 10 };

static void html_caption(struct thud_text *out, const struct thud_document *document, size_t table, const char *open,
                         const char *close)
{
    thud_text_append(out, "%s", open);
    put_number(document, table, out);
    html_element(out, "", text_of(&document->piece[table]), close);
}

static void html_row_opens(struct thud_text *out, const struct place *place, const struct thud_document *document)
{
    const bool goes_over = place->rows > ROWS_TOGETHER;
    const int row = place->row + 1; /* from 1 */
    char open[64];
    if (place->body) {
        thud_text_append(out, !goes_over                            ? "<tr>"
                              : row < ROWS_AT_END                   ? "<tr class=\"first\">"
                              : row > place->rows - ROWS_AT_END + 1 ? "<tr class=\"last\">"
                                                                    : "<tr>");
        return;
    }
    snprintf(open, sizeof open, "<tr><th class=\"caption\" colspan=\"%d\">", count_columns(document, place->at));
    thud_text_append(out, "<thead>");
    if (goes_over && *text_of(&document->piece[place->at]))
        html_caption(out, document, place->at, open, "</th></tr>\n");
    thud_text_append(out, "<tr>");
}

/* To a section by its heading. */
static void html_reference(struct thud_text *out, const struct thud_document *document, const char *heading)
{
    for (size_t i = 0; i < document->n; i++)
        if (document->piece[i].kind == HEADING && strcmp(text_of(&document->piece[i]), heading) == 0) {
            thud_text_append(out, "<a href=\"#section-%d\">", number_of(document, i));
            html_element(out, "", heading, "</a>");
        }
}

static void html_cell(struct thud_text *out, struct place *place, const struct thud_document *document,
                      const char *text)
{
    if (place->column++ == 0)
        html_row_opens(out, place, document);
    if (!place->body)
        html_element(out,
                     column_is_words(document, place->at, place->column - 1) ? "<th scope=\"col\" class=\"words\">"
                                                                             : "<th scope=\"col\">",
                     text, "</th>");
    else if (place->column == 1)
        html_element(out,
                     strlen(text) <= SHORT_MOST && !place->shared ? "<th scope=\"row\" class=\"short\">"
                                                                  : "<th scope=\"row\">",
                     text, "</th>");
    else {
        thud_text_append(out, !column_is_words(document, place->at, place->column - 1) ? "<td>"
                              : strlen(text) <= WORDS_SHORT && !place->shared          ? "<td class=\"words short\">"
                                                                                       : "<td class=\"words\">");
        if (*text == '#')
            html_reference(out, document, text + 1);
        else
            html_text(out, text);
        thud_text_append(out, "</td>");
    }
}

static int count_rows(const struct thud_document *document, size_t table)
{
    int rows = -1; /* less the head */
    for (size_t i = table + 1; i < document->n && (document->piece[i].kind == CELL || document->piece[i].kind == ROW);
         i++)
        rows += document->piece[i].kind == ROW;
    return rows;
}

/* Ends a row. */
static void html_row(struct thud_text *out, struct place *place)
{
    thud_text_append(out, place->body ? "</tr>\n" : "</tr></thead>\n<tbody>\n");
    place->row += place->body;
    place->body = true;
    place->column = 0;
}

/* A picture of a format that pages do not show is a link to its file. */
static void html_figure(struct thud_text *out, const struct thud_document_piece *piece)
{
    const char *file = piece->file.data ? piece->file.data : "", *dot = strrchr(file, '.');
    if (piece->picture.size > 0) {
        html_element(out, "<figure><img alt=\"", piece->alt.data ? piece->alt.data : "", "\" src=\"data:image/");
        thud_text_append(out, "%s;base64,", dot && strcmp(dot, ".png") == 0 ? "png" : "svg+xml");
        thud_text_base64(out, piece->picture.data, piece->picture.size);
        thud_text_append(out, "\"><figcaption>");
    } else {
        html_element(out, "<figure><a href=\"", file, "\">");
        html_element(out, "", file, "</a><figcaption>");
    }
}

/* Columns of words that fill more than a line share the width by what stands in them; whether they do. */
static bool html_columns(struct thud_text *out, const struct thud_document *document, size_t table, int rows)
{
    enum { COLUMNS = 16, LINE = 100 };
    double mean[COLUMNS] = {0}, all = 0.0;
    int n = 0, column = 0;
    for (size_t i = table + 1; i < document->n && document->piece[i].kind >= CELL; i++)
        if (document->piece[i].kind == ROW) {
            n = column > n ? column : n;
            column = 0;
        } else if (column < COLUMNS) {
            const double length = (double)document->piece[i].text.size;
            mean[column] = n == 0 ? length : mean[column];
            mean[column++] += length / rows;
        }
    for (int k = 0; k < n; k++) {
        if (!column_is_words(document, table, k))
            return false;
        all += mean[k];
    }
    for (int k = 0; k < n && all > LINE; k++)
        thud_text_append(out, "<col style=\"width: %.0f%%\">", 100.0 * mean[k] / all);
    return all > LINE;
}

/* A link for each section; where the pages of print are known their numbers stand behind. */
static void html_contents(struct thud_text *out, const struct thud_document *document)
{
    thud_text_append(out, "<nav aria-label=\"Contents\">\n<ol>\n");
    for (size_t i = 0; i < document->n; i++)
        if (document->piece[i].kind == HEADING) {
            const int number = number_of(document, i);
            thud_text_append(out, "<li><a href=\"#section-%d\">%d ", number, number);
            html_element(out, "", text_of(&document->piece[i]), "</a></li>\n");
        }
    thud_text_append(out, "</ol>\n</nav>\n");
}

static void html_piece(struct thud_text *out, struct place *place, const struct thud_document *document, size_t i)
{
    static const char *const tag[] = {[TITLE] = "h1", [PARAGRAPH] = "p"};
    const struct thud_document_piece *piece = &document->piece[i];
    html_leave(out, place, piece->kind);
    switch (piece->kind) {
    case CONTENTS:
        html_contents(out, document);
        break;
    case HEADING:
        thud_text_append(out, "<h2 id=\"section-%d\">%d ", number_of(document, i), number_of(document, i));
        html_element(out, "", text_of(piece), "</h2>\n");
        break;
    case TITLE:
    case PARAGRAPH:
        thud_text_append(out, i + 1 < document->n && piece[1].kind == LINES ? "<%s class=\"lead\">" : "<%s>",
                         tag[piece->kind]);
        html_text(out, text_of(piece));
        thud_text_append(out, "</%s>\n", tag[piece->kind]);
        break;
    case LINES: /* as they are, to be copied */
        thud_text_append(out, "<pre>");
        escape_html(out, text_of(piece));
        thud_text_append(out, "</pre>\n");
        break;
    case ITEM:
        thud_text_append(out, place->list ? "" : "<ul>\n");
        place->list = true;
        html_element(out, "<li>", text_of(piece), "</li>\n");
        break;
    case TABLE:
        *place = (struct place){.table = true, .at = i, .rows = count_rows(document, i)};
        thud_text_append(out, "<div><table");
        if (place->rows > ROWS_TOGETHER || count_columns(document, i) >= COLUMNS_WIDE)
            thud_text_append(out, " class=\"%s%s\"", place->rows > ROWS_TOGETHER ? "long" : "",
                             count_columns(document, i) >= COLUMNS_WIDE ? " wide" : "");
        thud_text_append(out, ">\n");
        if (place->rows <= ROWS_TOGETHER && *text_of(piece))
            html_caption(out, document, i, "<caption>", "</caption>\n");
        place->shared = html_columns(out, document, i, place->rows);
        break;
    case CELL:
        html_cell(out, place, document, text_of(piece));
        break;
    case ROW:
        html_row(out, place);
        break;
    case FIGURE:
        html_figure(out, piece);
        put_number(document, i, out);
        html_element(out, "", text_of(piece), "</figcaption></figure>\n");
        break;
    }
}

void thud_document_html(const struct thud_document *document, struct thud_text *out)
{
    struct place place = {0};
    thud_text_append(out, "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                          "<meta name=\"viewport\" content=\"width=device-width\">\n<title>");
    for (size_t i = 0; i < document->n; i++)
        if (document->piece[i].kind == TITLE)
            escape_html(out, text_of(&document->piece[i]));
    thud_text_append(out, "</title>\n<style>\n");
    thud_text_bytes(out, style, sizeof style - 1);
    thud_text_append(out, "</style>\n</head>\n<body>\n<main>\n");
    for (size_t i = 0; i < document->n; i++)
        html_piece(out, &place, document, i);
    html_leave(out, &place, PARAGRAPH);
    thud_text_append(out, "</main>\n</body>\n</html>\n");
}

/* ---- Markdown ---- */

/* What Markdown would take for its own. At the start of a line also `+`, `-` and figures with a dot. */
static void escape_markdown(struct thud_text *out, const char *text)
{
    for (const char *at = text; *at; at++) {
        if (*at == '\n' || *at == '\t') {
            thud_text_append(out, " ");
            continue;
        }
        if (strchr("\\`*_{}[]<>#|~&", *at) || (at == text && strchr("+-", *at)))
            thud_text_append(out, "\\");
        if ((unsigned char)*at >= ' ')
            thud_text_bytes(out, at, 1);
        else
            thud_text_append(out, "?");
    }
}

static void markdown_piece(struct thud_text *out, struct place *place, const struct thud_document *document, size_t i)
{
    const struct thud_document_piece *piece = &document->piece[i];
    const char *text = text_of(piece);
    if (piece->kind == CONTENTS)
        return;
    bool goes_on =
        (place->list && piece->kind == ITEM) || (place->table && (piece->kind == CELL || piece->kind == ROW));
    if (out->size > 0 && !goes_on)
        thud_text_append(out, "\n");
    if (!goes_on)
        *place = (struct place){.list = piece->kind == ITEM, .table = piece->kind == TABLE, .at = i};
    switch (piece->kind) {
    case TITLE:
    case HEADING:
        thud_text_append(out, piece->kind == TITLE ? "# " : "## ");
        break;
    case ITEM:
        thud_text_append(out, "- ");
        break;
    case LINES:
        for (const char *at = text; *at;) {
            size_t n = strcspn(at, "\n");
            thud_text_append(out, "    %.*s\n", (int)n, at);
            at += n + (at[n] == '\n');
        }
        return;
    case TABLE:
        if (!*text)
            return;
        thud_text_append(out, "**");
        put_number(document, i, out);
        escape_markdown(out, text);
        thud_text_append(out, "**\n\n");
        return;
    case CELL:
        thud_text_append(out, place->column++ > 0 ? " " : "| ");
        escape_markdown(out, text + (place->body && place->column > 1 && *text == '#'));
        thud_text_append(out, " |");
        return;
    case ROW:
        thud_text_append(out, "\n");
        for (int k = 0; !place->body && k < place->column; k++)
            thud_text_append(out, "%s", k == 0 ? "|---|" : column_is_words(document, place->at, k) ? "---|" : "---:|");
        thud_text_append(out, place->body ? "" : "\n");
        place->body = true;
        place->column = 0;
        return;
    case FIGURE:
        thud_text_append(out, "![");
        escape_markdown(out, piece->alt.data ? piece->alt.data : "");
        thud_text_append(out, "](%s)\n\n", piece->file.data ? piece->file.data : "");
        put_number(document, i, out);
        break;
    case PARAGRAPH:
    case CONTENTS:
        break;
    }
    escape_markdown(out, text);
    thud_text_append(out, "\n");
}

void thud_document_markdown(const struct thud_document *document, struct thud_text *out)
{
    struct place place = {0};
    for (size_t i = 0; i < document->n; i++)
        markdown_piece(out, &place, document, i);
}

enum thud_status thud_document_deliver(const struct thud_document *document, const char *folder, struct thud_error *err)
{
    struct thud_text text = {0};
    if (document->failed)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    thud_document_markdown(document, &text);
    enum thud_status status = thud_text_save(&text, folder, "report.md", THUD_OK, err);
    thud_document_html(document, &text);
    return thud_text_save(&text, folder, "report.html", status, err);
}
