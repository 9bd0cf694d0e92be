/* A growing text holds what was appended, byte for byte, whatever its length. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"

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

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("text");
    TCase *tcase = tcase_create("text");
    tcase_add_test(tcase, grows_past_every_capacity);
    tcase_add_test(tcase, numbers_read_back_the_same);
    suite_add_tcase(suite, tcase);
    return suite;
}
