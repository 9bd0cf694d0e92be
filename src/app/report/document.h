/* A document as data: headings, paragraphs, lists, tables, figures, in the order they are added; written as one HTML
 * file that needs nothing else, and as Markdown. Texts are plain: whatever a user typed is escaped where it is written.
 * Out of memory is remembered and asked for once, at the end. */
#pragma once

#include <stdbool.h>

#include "base/status.h"
#include "base/text.h"

struct thud_document {
    struct thud_document_piece *piece; /* (n) */
    size_t n;
    bool failed;
};

void thud_document_title(struct thud_document *document, const char *text);
void thud_document_heading(struct thud_document *document, const char *text);
/* The sections by their numbers, of HTML and print alone: a link each, in print with its page. */
void thud_document_contents(struct thud_document *document);
void thud_document_paragraph(struct thud_document *document, const char *fmt, ...) THUD_PRINTF(2, 3);
/* Items that follow each other are one list. */
void thud_document_item(struct thud_document *document, const char *fmt, ...) THUD_PRINTF(2, 3);
/* Takes out the pieces from the n-th (from 0) on; document->n counts them. Or so many of them. */
void thud_document_cut(struct thud_document *document, size_t n);
void thud_document_take(struct thud_document *document, size_t n, size_t count);
/* Takes out the columns of tables whose cells all say that there is nothing to say, as rows are, and tables of which
 * nothing but the head is left. */
void thud_document_tidy(struct thud_document *document);
/* Lines as they are, in letters of one width. */
void thud_document_lines(struct thud_document *document, const char *text);
/* A table: its caption (numbered; empty: neither), cells from left to right, thud_document_row after each row. The
 * first row is the head, the first column the name of its row. Ends with whatever is no cell. A row whose values are
 * all "-" is left out. A cell that begins with "#" names a section: a link to it, in print with its page. */
void thud_document_table(struct thud_document *document, const char *caption);
void thud_document_cell(struct thud_document *document, const char *fmt, ...) THUD_PRINTF(2, 3);
/* Cells parted by tabs; a row of them; a row of plain ones, parted by `|`. */
void thud_document_cells(struct thud_document *document, const char *fmt, ...) THUD_PRINTF(2, 3);
void thud_document_line(struct thud_document *document, const char *fmt, ...) THUD_PRINTF(2, 3);
void thud_document_head(struct thud_document *document, const char *cells);
void thud_document_row(struct thud_document *document);
/* A picture in SVG or PNG, also beside the Markdown as `file`; without bytes the page links to that file. The caption
 * says what it is, `alt` what is to be seen in it. Takes the bytes of `picture`. */
void thud_document_figure(struct thud_document *document, const char *file, const char *caption, const char *alt,
                          struct thud_text *picture);

void thud_document_html(const struct thud_document *document, struct thud_text *out);
void thud_document_markdown(const struct thud_document *document, struct thud_text *out);
/* The i-th figure from 0; NULL past the last. */
const struct thud_text *thud_document_picture(const struct thud_document *document, int i, const char **file);
/* report.md and report.html in a folder. Errors: THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_document_deliver(const struct thud_document *document, const char *folder,
                                       struct thud_error *err);
void thud_document_clear(struct thud_document *document);
