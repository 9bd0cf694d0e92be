/* Documents as HTML and Markdown: the structure of both, and that no text is taken for more than a text. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/report/document.h"
#include "app/report/site_report_private.h"

static struct thud_document document;
static struct thud_text html, markdown;

static void set_up(void)
{
    document = (struct thud_document){0};
    html = markdown = (struct thud_text){0};
}

static void tear_down(void)
{
    thud_document_clear(&document);
    thud_text_clear(&html);
    thud_text_clear(&markdown);
}

static void write_both(void)
{
    ck_assert(!document.failed);
    thud_document_html(&document, &html);
    thud_document_markdown(&document, &markdown);
    ck_assert(!html.failed && !markdown.failed);
}

static bool has(const struct thud_text *text, const char *part)
{
    return strstr(text->data, part) != NULL;
}

START_TEST(what_was_typed_stays_a_text)
{
    thud_document_title(&document, "<script>alert(\"1\")</script> & 'x'");
    thud_document_paragraph(&document, "%s", "<b> *bold* [a](http://b) `c` | \\ \x01 %d");
    write_both();
    ck_assert(has(&html, "<title>&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt; &amp; &#39;x&#39;</title>"));
    ck_assert(has(&html, "<h1>&lt;script&gt;"));
    ck_assert(!has(&html, "<script") && !has(&html, "<b>"));
    ck_assert(has(&html, "<p>&lt;b&gt; *bold* [a](http://b) `c` | \\ ? %d</p>"));
    ck_assert_str_eq(markdown.data, "# \\<script\\>alert(\"1\")\\</script\\> \\& 'x'\n\n"
                                    "\\<b\\> \\*bold\\* \\[a\\](http://b) \\`c\\` \\| \\\\ ? %d\n");
}
END_TEST

START_TEST(lists_and_tables_open_and_close)
{
    thud_document_item(&document, "one");
    thud_document_item(&document, "two");
    thud_document_table(&document, "Peaks");
    for (int i = 0; i < 6; i++) {
        thud_document_cell(&document, "%d|", i);
        if (i % 2)
            thud_document_row(&document);
    }
    thud_document_table(&document, "Empty");
    thud_document_heading(&document, "Next");
    thud_document_item(&document, "- three");
    write_both();
    ck_assert(has(&html, "<ul>\n<li>one</li>\n<li>two</li>\n</ul>\n<div><table>\n<caption>Table 1. Peaks</caption>\n"
                         "<thead><tr><th scope=\"col\">0|</th><th scope=\"col\">1|</th></tr></thead>\n<tbody>\n"
                         "<tr><th scope=\"row\" class=\"short\">2|</th><td>3|</td></tr>\n"
                         "<tr><th scope=\"row\" class=\"short\">4|</th><td>5|</td></tr>\n</tbody></table></div>\n"
                         "<div><table>\n<caption>Table 2. Empty</caption>\n</table></div>\n<h2 id=\"section-1\">1 "
                         "Next</h2>\n<ul>\n<li>- "
                         "three</li>\n</ul>\n"));
    ck_assert_str_eq(markdown.data,
                     "- one\n- two\n\n**Table 1. Peaks**\n\n| 0\\| | 1\\| |\n|---|---:|\n| 2\\| | 3\\| |\n"
                     "| 4\\| | 5\\| |\n\n**Table 2. Empty**\n\n\n## Next\n\n- \\- three\n");
}
END_TEST

START_TEST(figures_are_inside_and_beside)
{
    /* RFC 4648, section 10 */
    static const char *const bytes[] = {"foobar", "fooba", "foob"};
    static const char *const coded[] = {"base64,Zm9vYmFy\"", "base64,Zm9vYmE=\"", "base64,Zm9vYg==\""};
    const char *file = NULL;
    for (int i = 0; i < 3; i++) {
        struct thud_text svg = {0};
        thud_text_append(&svg, "%s", bytes[i]);
        thud_document_figure(&document, "a.svg", "The caption.", "What \"is\" seen", &svg);
        ck_assert_ptr_null(svg.data);
    }
    write_both();
    for (int i = 0; i < 3; i++) {
        ck_assert(has(&html, coded[i]));
        ck_assert_str_eq(thud_document_picture(&document, i, &file)->data, bytes[i]);
        ck_assert_str_eq(file, "a.svg");
    }
    ck_assert_ptr_null(thud_document_picture(&document, 3, &file));
    ck_assert(has(&html, "<img alt=\"What &quot;is&quot; seen\" src=\"data:image/svg+xml;base64,"));
    ck_assert(has(&markdown, "![What \"is\" seen](a.svg)\n\nFigure 1. The caption.\n"));
    ck_assert(has(&html, "<figcaption>Figure 3. The caption."));
}
END_TEST

/* Sentences in a column stand at its left, in both; what is cut is gone from both. */
START_TEST(sentences_in_tables_and_what_is_cut)
{
    thud_document_table(&document, "Verdicts");
    static const char *const cell[] = {"question", "result", "n", "enough", "a sentence with several words", "3"};
    for (int i = 0; i < 6; i++) {
        thud_document_cell(&document, "%s", cell[i]);
        if (i % 3 == 2)
            thud_document_row(&document);
    }
    thud_document_table(&document, ""); /* of a title block: no caption, and it is not counted */
    thud_document_head(&document, "Project|A");
    thud_document_table(&document, "Next");
    size_t n = document.n;
    for (int i = 0; i < 3; i++)
        thud_document_item(&document, "item %d", i);
    thud_document_take(&document, n, 2);
    ck_assert(document.n == n + 1);
    n = document.n;
    thud_document_item(&document, "not for the first page");
    thud_document_cut(&document, n);
    ck_assert(document.n == n);
    write_both();
    ck_assert(has(&html, "<td class=\"words\">a sentence with several words</td><td>3</td>"));
    ck_assert(has(&markdown, "\n|---|---|---:|\n"));
    ck_assert(has(&markdown, "**Table 2. Next**") && has(&markdown, "\n| Project | A |\n"));
    ck_assert(has(&html, "<li>item 2</li>") && !has(&html, "item 0") && !has(&html, "item 1"));
    ck_assert(!has(&html, "first page") && !has(&markdown, "first page"));
}
END_TEST

/* A long table may go over a page's end, but not next to its first or last row; every page repeats its caption, which
 * is a row of its head and stands there once. A hash that begins with a figure is no number. */
START_TEST(no_row_of_a_long_table_stands_alone)
{
    enum { ROWS = 20 };
    thud_document_table(&document, "Rows");
    thud_document_head(&document, "n|hash");
    for (int i = 0; i < ROWS; i++)
        thud_document_line(&document, "%d\t4e2be59b149134ae3166f4fdeade931c", i);
    write_both();
    ck_assert(has(&html, "<table class=\"long\">\n<thead><tr><th class=\"caption\" colspan=\"2\">Table 1. "
                         "Rows</th></tr>\n<tr><th scope=\"col\">n</th>"));
    ck_assert(!has(&html, "<caption>"));
    ck_assert(has(&html, "tr.first { break-after: avoid } tr.last { break-before: avoid }"));
    const char *at = html.data;
    for (int i = 0; i < ROWS; i++) {
        char opens[64];
        at = strstr(at + 1, "<tr><th scope=\"row\"") && i >= 2 && i < ROWS - 2 ? strstr(at, "<tr><th scope=\"row\"")
                                                                               : strstr(at, "<tr class=");
        snprintf(opens, sizeof opens, "class=\"short\">%d</th>", i);
        ck_assert_ptr_nonnull(at);
        ck_assert(strstr(at, opens) && strstr(at, opens) - at < 64);
        ck_assert_int_eq(strncmp(at, "<tr class=\"first\">", 18) == 0, i < 2);
        ck_assert_int_eq(strncmp(at, "<tr class=\"last\">", 17) == 0, i >= ROWS - 2);
        at++;
    }
    ck_assert(has(&html, "<td class=\"words\">4e2be59b"));
}
END_TEST

/* What says nothing of anything is no row; contents are of HTML alone, and their links lead to the sections. */
START_TEST(rows_without_values_are_left_out)
{
    thud_document_contents(&document);
    thud_document_heading(&document, "One & all");
    thud_document_table(&document, "Values");
    thud_document_head(&document, "of|a|b");
    thud_document_line(&document, "nothing\t-\t-");
    thud_document_line(&document, "half\t-\t1");
    thud_document_line(&document, "list\t[8 MN/m, 7 <MN>]\t1");
    thud_document_heading(&document, "Two");
    write_both();
    ck_assert(has(&html, "<ol>\n<li><a href=\"#section-1\">1 One &amp; all</a></li>\n"
                         "<li><a href=\"#section-2\">2 Two</a></li>\n</ol>"));
    ck_assert(has(&html, "<h2 id=\"section-1\">1 One &amp; all</h2>") && has(&html, "<h2 id=\"section-2\">2 Two</h2>"));
    ck_assert(has(&html, ">[8\u00a0MN/\u2060m, 7 &lt;MN&gt;]</td>")); /* no value breaks within its unit */
    ck_assert_str_eq(markdown.data, "## One \\& all\n\n**Table 1. Values**\n\n| of | a | b |\n|---|---:|---:|\n"
                                    "| half | \\- | 1 |\n| list | \\[8 MN/m, 7 \\<MN\\>\\] | 1 |\n\n## Two\n");
}
END_TEST

START_TEST(numbers_have_three_digits)
{
    static const struct {
        double value;
        const char *text;
    } told[] = {{0, "0"},           {NAN, "-"},       {1, "1.00"},        {0.9994, "0.999"}, {0.9996, "1.00"},
                {9.994, "9.99"},    {9.996, "10.0"},  {99.96, "100"},     {123.4, "123"},    {1234.6, "1235"},
                {0.0123, "0.0123"}, {1e-5, "<0.001"}, {-0.99961, "-1.00"}};
    for (size_t i = 0; i < sizeof told / sizeof *told; i++)
        ck_assert_str_eq(thud_site_number(told[i].value, 3).text, told[i].text);
    ck_assert_str_eq(thud_site_number(7, 0).text, "7");
}
END_TEST

START_TEST(lines_stay_as_they_are)
{
    thud_document_lines(&document, "a: [1, 2 mm]\n  b: <c>\n");
    write_both();
    ck_assert(has(&html, "<pre>a: [1, 2 mm]\n  b: &lt;c&gt;\n</pre>"));
    ck_assert_str_eq(markdown.data, "    a: [1, 2 mm]\n      b: <c>\n");
}
END_TEST

/* U+00A0 between a number and its unit, U+2060 in it; not in Markdown, nor where no unit follows. */
START_TEST(a_number_stays_with_its_unit)
{
    thud_document_paragraph(&document, "at 66 %% of 2 MN/m, 3 storeys, 4 metres and [0.36 kN/mm^2.65]");
    write_both();
    ck_assert(
        has(&html, "<p>at 66\u00a0% of 2\u00a0MN/\u2060m, 3 storeys, 4 metres and [0.36\u00a0kN/\u2060mm^2.65]</p>"));
    ck_assert(has(&markdown, "at 66 % of 2 MN/m, 3 storeys"));
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("document");
    TCase *tcase = tcase_create("document");
    tcase_add_checked_fixture(tcase, set_up, tear_down);
    tcase_add_test(tcase, what_was_typed_stays_a_text);
    tcase_add_test(tcase, lists_and_tables_open_and_close);
    tcase_add_test(tcase, figures_are_inside_and_beside);
    tcase_add_test(tcase, sentences_in_tables_and_what_is_cut);
    tcase_add_test(tcase, no_row_of_a_long_table_stands_alone);
    tcase_add_test(tcase, rows_without_values_are_left_out);
    tcase_add_test(tcase, lines_stay_as_they_are);
    tcase_add_test(tcase, a_number_stays_with_its_unit);
    tcase_add_test(tcase, numbers_have_three_digits);
    suite_add_tcase(suite, tcase);
    return suite;
}
