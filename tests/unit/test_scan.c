/* What is there is read and passed over; what is not leaves the text where it was. */
#include <check.h>
#include <stdio.h>

#include "base/ascii.h"
#include "base/scan.h"

START_TEST(words_are_passed_over)
{
    const char *text = "floor 3";
    const char *at = text;
    ck_assert(!thud_scan_word(&at, "floors"));
    ck_assert_ptr_eq(at, text);
    ck_assert(thud_scan_word(&at, "floor "));
    ck_assert_str_eq(at, "3");
    ck_assert(!thud_scan_word(&at, "33"));
    ck_assert(thud_scan_word(&at, ""));
    ck_assert_str_eq(at, "3");
}
END_TEST

START_TEST(counts_read_what_was_written)
{
    const int values[] = {0, 1, 9, 10, 4096, 99999999, 999999999};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        char text[32];
        int n = snprintf(text, sizeof text, "%d/7", values[i]), read = -1;
        const char *at = text;
        ck_assert(thud_scan_count(&at, &read));
        ck_assert_int_eq(read, values[i]);
        ck_assert_ptr_eq(at, text + n - 2);
    }
}
END_TEST

START_TEST(what_is_no_count_is_left)
{
    const char *const texts[] = {"", "-1", "+1", " 1", "x1", ".5", "1000000000", "99999999999999999999"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        const char *at = texts[i];
        int read = 77;
        ck_assert_msg(!thud_scan_count(&at, &read), "`%s` was read", texts[i]);
        ck_assert_ptr_eq(at, texts[i]);
        ck_assert_int_eq(read, 77);
    }
}
END_TEST

/* Every byte, against what ASCII says of it. */
START_TEST(letters_are_those_of_ascii)
{
    for (int i = 0; i < 256; i++) {
        char c = (char)(unsigned char)i;
        bool upper = i >= 65 && i <= 90, lower = i >= 97 && i <= 122, digit = i >= 48 && i <= 57;
        ck_assert_int_eq(thud_ascii_is_upper(c), upper);
        ck_assert_int_eq(thud_ascii_is_alpha(c), upper || lower);
        ck_assert_int_eq(thud_ascii_is_digit(c), digit);
        ck_assert_int_eq(thud_ascii_is_alnum(c), upper || lower || digit);
        ck_assert_int_eq((unsigned char)thud_ascii_lower(c), upper ? i + 32 : i);
        ck_assert_int_eq((unsigned char)thud_ascii_upper(c), lower ? i - 32 : i);
    }
    ck_assert(thud_ascii_same("TIME in", "time IN"));
    ck_assert(!thud_ascii_same("time", "times"));
    const char *text = "a Gap and a gap";
    ck_assert_ptr_eq(thud_ascii_find(text, "gAP"), text + 2);
    ck_assert_ptr_eq(thud_ascii_find(text, ""), text);
    ck_assert_ptr_null(thud_ascii_find(text, "gaps"));
    ck_assert(thud_ascii_ends(text, "a gap") && thud_ascii_ends(text, "") && !thud_ascii_ends("gap", "a gap"));
    ck_assert(thud_ascii_begins("Unit: g", 7, "unit"));
    ck_assert(!thud_ascii_begins("Unit", 3, "unit")); /* no further than may be read */
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("scan");
    TCase *tcase = tcase_create("scan");
    tcase_add_test(tcase, letters_are_those_of_ascii);
    tcase_add_test(tcase, words_are_passed_over);
    tcase_add_test(tcase, counts_read_what_was_written);
    tcase_add_test(tcase, what_is_no_count_is_left);
    suite_add_tcase(suite, tcase);
    return suite;
}
