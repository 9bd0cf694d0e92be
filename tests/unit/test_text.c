/* A growing text holds what was appended, byte for byte, whatever its length. */
#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "base/text.h"
#include "base/utf8.h"

START_TEST(grows_past_every_capacity)
{
    struct thud_text text = {0};
    char whole[20000] = "";
    size_t length = 0;
    for (int i = 0; i < 3000; i++) {
        char piece[16];
        int n = snprintf(piece, sizeof piece, "%d,", i);
        memcpy(whole + length, piece, (size_t)n);
        length += (size_t)n;
        if (i % 2)
            thud_text_append(&text, "%d,", i);
        else
            thud_text_bytes(&text, piece, (size_t)n);
    }
    ck_assert_int_eq(text.failed, 0);
    ck_assert_uint_eq(text.size, length);
    ck_assert_int_eq(memcmp(text.data, whole, length), 0);
    ck_assert_int_eq(text.data[length], '\0');
    thud_text_clear(&text);
    ck_assert_ptr_null(text.data);
}
END_TEST

START_TEST(numbers_read_back_the_same)
{
    const double values[] = {0.1, 1.0 / 3.0, 1e300, -2.5, 5e-324};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        struct thud_text text = {0};
        thud_text_number(&text, values[i]);
        ck_assert(strtod(text.data, NULL) == values[i]);
        thud_text_clear(&text);
    }
}
END_TEST

/* What the C library writes: the fewest of 15, 16 and 17 digits that it reads as the same number. */
static void shortest(double value, char text[40])
{
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, 40, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            return;
    }
}

static int checked;
static void check_shortest(double value)
{
    checked++;
    char expected[40], text[40];
    shortest(value, expected);
    thud_number_format(value, text, sizeof text);
    if (strcmp(text, expected) !=
        0) /* an assertion that holds writes its place to a file: millions of them take seconds */
        ck_abort_msg("%s is written as %s", expected, text);
    snprintf(expected, sizeof expected, "%.12g", value);
    if (thud_number_twelve(value, text) != strlen(expected) || strcmp(text, expected) != 0)
        ck_abort_msg("%s of twelve digits is written as %s", expected, text);
}

/* Random numbers of every size that a study writes, decimal numbers and their neighbours, powers of 2 and theirs, and
 * numbers halfway between two of 15 to 17 digits. */
START_TEST(numbers_have_the_fewest_digits)
{
    uint64_t state = 1;
    for (int i = 0; i < 200000; i++) {
        state = state * 6364136223846793005U + 1442695040888963407U;
        double unit = 1 + ldexp((double)(state >> 12), -52), sign = i % 2 ? -1 : 1;
        check_shortest(sign * ldexp(unit, i % 70 - 20));
        if (i % 4 == 0)
            check_shortest(sign * ldexp(unit, -(i / 4) % 36));
        double decimal = (double)(state >> 40) / pow(10, i % 11);
        check_shortest(decimal);
        check_shortest(nextafter(decimal, INFINITY));
        check_shortest(nextafter(decimal, 0));
        check_shortest((double)(2 * (state >> 18) + 1) / (double)(1 << i % 8));
    }
    for (int k = -30; k < 60; k++)
        for (int side = -1; side <= 1; side++)
            check_shortest(side == 0 ? ldexp(1, k) : nextafter(ldexp(1, k), side > 0 ? INFINITY : 0));
    for (int k = -6; k < 18; k++) {
        check_shortest(nextafter(pow(10, k), 0));
        check_shortest(nextafter(pow(10, k), INFINITY));
        check_shortest(-pow(10, k));
    }
    ck_assert_int_gt(checked, 1000000);
}
END_TEST

/* RFC 3629: the first and last characters of each length, and what is none. */
START_TEST(a_fixed_text_is_cut_at_its_end)
{
    char text[8] = "ab";
    thud_append(text, sizeof text, "%d", 345);
    ck_assert_str_eq(text, "ab345");
    for (int i = 0; i < 3; i++) {
        thud_append(text, sizeof text, "cdef");
        ck_assert_str_eq(text, "ab345cd");
    }
}
END_TEST

/* By hand: lines of 12 columns, what follows a label further in, and a number with its unit. */
START_TEST(words_are_wrapped)
{
    struct thud_text text = {0};
    thud_text_append(&text, "before\nat ");
    thud_text_wrap(&text, "one two  three 12\tkN much-longer-than-a-line x", 3, 12);
    ck_assert_str_eq(text.data, "before\nat one two\n   three\n   12 kN\n   much-longer-than-a-line\n   x");
    thud_text_clear(&text);
    thud_text_wrap(&text, "a b", 0, 1);
    ck_assert_str_eq(text.data, "a\nb");
    thud_text_wrap(&text, " ", 0, 1);
    ck_assert_str_eq(text.data, "a\nb");
    thud_text_clear(&text);
    thud_text_append(&text, "\u03b4 "); /* by columns, not by bytes */
    thud_text_wrap(&text, "\u03b4\u03b4\u03b4 \u03b4\u03b4 \u6771 x", 2, 8);
    ck_assert_str_eq(text.data, "\u03b4 \u03b4\u03b4\u03b4 \u03b4\u03b4\n  \u6771 x");
    thud_text_clear(&text);
    text.failed = 1; /* without memory for its first byte */
    thud_text_wrap(&text, "one two", 2, 8);
    ck_assert_ptr_null(text.data);
}
END_TEST

START_TEST(a_long_name_has_a_line_of_its_own)
{
    struct thud_text text = {0};
    thud_text_append(&text, "  ");
    thud_text_padded(&text, "B\xc3\xbcro", 5);
    thud_text_append(&text, "1\n  ");
    thud_text_padded(&text, "an office", 5);
    thud_text_append(&text, "2");
    ck_assert_str_eq(text.data, "  B\xc3\xbcro 1\n  an office\n       2");
    thud_text_clear(&text);
}
END_TEST

START_TEST(utf8_characters)
{
    static const struct {
        const char *text;
        uint32_t code;
    } good[] = {{"\x01", 1},
                {"\x7f", 0x7f},
                {"\xc2\x80", 0x80},
                {"\xdf\xbf", 0x7ff},
                {"\xe0\xa0\x80", 0x800},
                {"\xed\x9f\xbf", 0xd7ff},
                {"\xee\x80\x80", 0xe000},
                {"\xef\xbf\xbf", 0xffff},
                {"\xf0\x90\x80\x80", 0x10000},
                {"\xf4\x8f\xbf\xbf", 0x10ffff}};
    /* alone, cut off, longer than needed, a surrogate, beyond the last */
    static const char *const bad[] = {"\x80",         "\xc1\xbf",         "\xc2",     "\xe0\x9f\xbf",     "\xe2\x82",
                                      "\xed\xa0\x80", "\xf0\x8f\xbf\xbf", "\xf0\x9f", "\xf4\x90\x80\x80", "\xff"};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        char put[5];
        const char *at = good[i].text;
        int n = thud_utf8_length(at);
        ck_assert_uint_eq((size_t)n, strlen(at));
        ck_assert_uint_eq(thud_utf8_next(&at), good[i].code);
        ck_assert_ptr_eq(at, good[i].text + n);
        ck_assert_int_eq(thud_utf8_put(good[i].code, put), n);
        ck_assert_str_eq(put, good[i].text);
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        const char *at = bad[i];
        ck_assert_int_eq(thud_utf8_length(at), 0);
        ck_assert_uint_eq(thud_utf8_next(&at), '?');
        ck_assert(at > bad[i]);
        ck_assert_uint_le((size_t)(at - bad[i]), strlen(bad[i]));
    }
    ck_assert_int_eq(thud_utf8_length(""), 1);
    ck_assert_int_eq(thud_utf8_columns("a\xc3\xa9\xe4\xb8\xad|"), 5);
}
END_TEST

/* What a spreadsheet would compute has an apostrophe before it, and is found again under it; numbers stay. */
START_TEST(csv_fields_are_no_formulas)
{
    static const struct {
        const char *text, *field;
    } fields[] = {{"=1+2", "'=1+2"},
                  {"+A1", "'+A1"},
                  {"-2+3", "'-2+3"},
                  {"@SUM(A1)", "'@SUM(A1)"},
                  {"=a,b", "\"'=a,b\""},
                  {"'=1", "''=1"},
                  {"-1.5", "-1.5"},
                  {"+2e3", "+2e3"},
                  {"-", "-"},
                  {"+", "+"},
                  {"'s", "'s"},
                  {"a=1", "a=1"},
                  {" =1", "\" =1\""},
                  {"a\"b", "\"a\"\"b\""},
                  {"", ""},
                  {"-x", "'-x"},
                  {"\x1b[31m", "\"\x1b[31m\""},
                  {"a\xe2\x80\xae", "\"a\xe2\x80\xae\""},
                  {"\xc2\x9b", "\"\xc2\x9b\""},
                  {"\xff", "\"\xff\""}};
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        struct thud_text text = {0};
        thud_text_csv(&text, fields[i].text);
        ck_assert_str_eq(text.data ? text.data : "", fields[i].field);
        if (fields[i].field[0] != '"')
            ck_assert_str_eq(thud_text_csv_plain(fields[i].field), fields[i].text);
        thud_text_clear(&text);
    }
}
END_TEST

START_TEST(what_a_terminal_obeys_is_not_shown)
{
    static const struct {
        const char *text, *shown;
    } texts[] = {{"a\x1b[31mb", "a?[31mb"}, /* ESC */
                 {"\xc2\x9b"
                  "31m",
                  "?31m"}, /* CSI as one character of C1 */
                 {"\x9b"
                  "31m",
                  "?31m"}, /* and as a byte, which is no UTF-8 */
                 {"\xe2\x80\xae"
                  "txt",
                  "?txt"}, /* right-to-left override */
                 {"\xe2\x81\xa6"
                  "a\xe2\x81\xa9",
                  "?a?"}, /* isolates */
                 {"\xd8\x9c\xef\xbb\xbf\xe2\x80\x8b", "???"},
                 {"\xf3\xa0\x81\x81", "?"}, /* a tag */
                 {"\x07\x08\x7f\r", "????"},
                 {"a\n\tb", "a\n\tb"},
                 {"K\xc3\xb4"
                  "be \xe7\xa5\x9e\xe6\x88\xb8 \xf0\x9f\x8f\xa2",
                  "K\xc3\xb4"
                  "be \xe7\xa5\x9e\xe6\x88\xb8 \xf0\x9f\x8f\xa2"}};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        char text[64];
        strcpy(text, texts[i].text);
        ck_assert_uint_eq(thud_text_shown(text, "\n\t"), strlen(texts[i].shown));
        ck_assert_str_eq(text, texts[i].shown);
    }
    char line[] = "a\nb";
    thud_text_shown(line, "");
    ck_assert_str_eq(line, "a?b");
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("text");
    TCase *tcase = tcase_create("text");
    tcase_add_test(tcase, grows_past_every_capacity);
    tcase_add_test(tcase, a_fixed_text_is_cut_at_its_end);
    tcase_add_test(tcase, words_are_wrapped);
    tcase_add_test(tcase, a_long_name_has_a_line_of_its_own);
    tcase_add_test(tcase, utf8_characters);
    tcase_add_test(tcase, numbers_read_back_the_same);
    tcase_add_test(tcase, numbers_have_the_fewest_digits);
    tcase_add_test(tcase, csv_fields_are_no_formulas);
    tcase_add_test(tcase, what_a_terminal_obeys_is_not_shown);
    suite_add_tcase(suite, tcase);
    return suite;
}
