/* Pictures on terminals that draw them: which do, what leaves for them, and that the screen comes back. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "plot/gnuplot/gnuplot.h"
#include "tui_fixture.h"

static struct fixture f;

static void setup(void)
{
    fixture_open(&f, "towers", 80, 24, true);
}

static void teardown(void)
{
    fixture_close(&f);
}

START_TEST(what_terminals_are_taken_for)
{
    static const struct {
        struct thud_image_variables of;
        enum thud_image known;
        bool ask;
    } table[] = {{{"xterm-256color", NULL, NULL, NULL}, THUD_IMAGE_NONE, true},
                 {{"xterm-kitty", NULL, NULL, NULL}, THUD_IMAGE_KITTY, false},
                 {{"xterm-256color", "1", NULL, NULL}, THUD_IMAGE_KITTY, false},
                 {{"xterm-256color", "1", "/tmp/tmux-0/default,1,0", NULL}, THUD_IMAGE_NONE, false},
                 {{"xterm-kitty", NULL, NULL, "123.pts"}, THUD_IMAGE_NONE, false},
                 {{"screen.xterm-256color", NULL, NULL, NULL}, THUD_IMAGE_NONE, false},
                 {{"tmux-256color", "", "", ""}, THUD_IMAGE_NONE, false},
                 {{"foot", "", "", ""}, THUD_IMAGE_NONE, true},
                 {{NULL, NULL, NULL, NULL}, THUD_IMAGE_NONE, true}};
    bool ask;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        ck_assert_int_eq((int)thud_image_known(THUD_IMAGES_AUTO, &table[i].of, &ask), (int)table[i].known);
        ck_assert_int_eq(ask, table[i].ask);
        for (int choice = THUD_IMAGES_NONE; choice < THUD_IMAGES_CHOICES; choice++) { /* what is set holds */
            enum thud_image found = thud_image_known((enum thud_image_choice)choice, &table[i].of, &ask);
            ck_assert(!ask);
            ck_assert_int_eq((int)found, choice == THUD_IMAGES_KITTY   ? (int)THUD_IMAGE_KITTY
                                         : choice == THUD_IMAGES_SIXEL ? (int)THUD_IMAGE_SIXEL
                                                                       : (int)THUD_IMAGE_NONE);
        }
    }
}
END_TEST

/* RFC 4648, section 10. */
START_TEST(base64)
{
    static const char *const pair[][2] = {{"", ""},
                                          {"f", "Zg=="},
                                          {"fo", "Zm8="},
                                          {"foo", "Zm9v"},
                                          {"foob", "Zm9vYg=="},
                                          {"fooba", "Zm9vYmE="},
                                          {"foobar", "Zm9vYmFy"}};
    for (size_t i = 0; i < sizeof pair / sizeof *pair; i++) {
        struct thud_text text = {0};
        thud_text_base64(&text, pair[i][0], strlen(pair[i][0]));
        ck_assert_str_eq(text.data ? text.data : "", pair[i][1]);
        thud_text_clear(&text);
    }
}
END_TEST

static int digit_of(char c)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = strchr(digit, c);
    return c && at ? (int)(at - digit) : -1;
}

/* The picture as a terminal of kitty's puts it together, by its rules; fails the test where one is broken. */
static void decode_kitty(const struct thud_text *raw, struct thud_text *picture, char control[200])
{
    bool more = true;
    *control = '\0';
    for (const char *at = raw->data; (at = strstr(at, "\033_G")) != NULL;) {
        const char *body = strchr(at, ';'), *end = strstr(at, "\033\\");
        ck_assert(body && end && body < end && more);
        ck_assert_int_le(end - body - 1, 4096);
        if (!*control)
            snprintf(control, 200, "%.*s", (int)(body - at - 3), at + 3);
        more = strncmp(body - 3, "m=1", 3) == 0;
        ck_assert(more || strncmp(body - 3, "m=0", 3) == 0);
        ck_assert(!more || (end - body - 1) % 4 == 0);
        for (const char *c = body + 1; c < end; c += 4) {
            int value[4], n = 0;
            for (int i = 0; i < 4; i++) {
                const int digit = digit_of(c[i]);
                n += digit >= 0;
                value[i] = digit >= 0 ? digit : 0; /* what fills up the last four */
            }
            const char byte[3] = {(char)(value[0] << 2 | value[1] >> 4), (char)(value[1] << 4 | value[2] >> 2),
                                  (char)(value[2] << 6 | value[3])};
            thud_text_bytes(picture, byte, (size_t)n - 1);
        }
        at = end;
    }
    ck_assert(!more);
}

/* Width and height of a PNG, from its header. */
static int png_number(const struct thud_text *png, int at)
{
    int n = 0;
    for (int i = 0; i < 4; i++)
        n = n << 8 | (unsigned char)png->data[at + i];
    return n;
}

START_TEST(kitty_gets_a_png_in_pieces)
{
    struct thud_text png = {0};
    char control[200];
    f.script.image = THUD_IMAGE_KITTY;
    fixture_keys(&f, "<A-2>p");
    ck_assert_ptr_nonnull(f.script.raw.data);
    decode_kitty(&f.script.raw, &png, control);
    ck_assert_ptr_nonnull(strstr(control, "a=T,f=100,"));
    ck_assert_ptr_nonnull(strstr(control, "c=80,r=22,"));
    ck_assert_ptr_nonnull(strstr(control, "q=2")); /* answers would come as keys */
    ck_assert_int_eq(memcmp(png.data, "\x89PNG\r\n\x1a\n", 8), 0);
    ck_assert_int_eq(memcmp(png.data + png.size - 8, "IEND", 4), 0);
    ck_assert_int_eq(png_number(&png, 16), 640);
    ck_assert_int_eq(png_number(&png, 20), 348); /* 22 of 24 rows of 16 px, a multiple of six */
    thud_text_clear(&png);
    fixture_expect(&f, "…  any key goes back"); /* what is written is told whole behind it */
    int shows = f.script.shows;
    for (int i = 0; i < 5; i++) /* nothing is drawn over it */
        thud_tui_turn(f.tui, false);
    ck_assert_int_eq(f.script.shows, shows);
    thud_text_clear(&f.script.raw);
    fixture_keys(&f, "x"); /* which is no key of the screen's */
    ck_assert_str_eq(f.script.raw.data, "\033_Ga=d,q=2\033\\");
    fixture_expect(&f, "Written");
    fixture_expect(&f, "Bare contact");
}
END_TEST

START_TEST(sixels_as_gnuplot_draws_them)
{
    f.script.image = THUD_IMAGE_SIXEL;
    fixture_keys(&f, "<A-5>");
    fixture_keys(&f, "p");
    const struct thud_text *raw = &f.script.raw;
    ck_assert_ptr_nonnull(raw->data);
    ck_assert_int_eq(memcmp(raw->data, "\0337\033[H\033P", 7), 0);
    ck_assert_ptr_nonnull(strstr(raw->data, "\"1;1;640;348"));
    ck_assert_int_eq(memcmp(raw->data + raw->size - 4, "\033\\\0338", 4), 0);
    thud_text_clear(&f.script.raw);
    fixture_keys(&f, "<Size 60x20>");
    ck_assert(!f.script.raw.data || !*f.script.raw.data);
    fixture_expect(&f, "Impact force");
    fixture_expect_not(&f, "any key goes back");
}
END_TEST

/* Other terminals get nothing; several figures, a screen that was left and a text that is typed are not covered. */
START_TEST(never_where_it_is_not_wanted)
{
    fixture_keys(&f, "<A-2>p");
    ck_assert_ptr_null(f.script.raw.data);
    f.script.image = THUD_IMAGE_KITTY;
    fixture_keys(&f, "P");
    fixture_expect(&f, "Written 8 figures");
    ck_assert_ptr_null(f.script.raw.data);
    fixture_keys(&f, "2p1");
    fixture_expect(&f, "Left: A");
    ck_assert_ptr_null(f.script.raw.data);
    fixture_keys(&f, "2p:se");
    fixture_expect(&f, ":se");
    ck_assert_ptr_null(f.script.raw.data);
}
END_TEST

START_TEST(ending_from_a_picture)
{
    f.script.image = THUD_IMAGE_KITTY;
    fixture_keys(&f, "<A-2>p<C-c>");
    fixture_keys(&f, "");
    if (!f.tui->end.quit)
        fixture_keys(&f, "<C-c>");
    ck_assert(f.tui->end.quit);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui image");
    TCase *image = tcase_create("image");
    tcase_set_timeout(image, 120.0);
    tcase_add_checked_fixture(image, setup, teardown);
    tcase_add_test(image, what_terminals_are_taken_for);
    tcase_add_test(image, base64);
    tcase_add_test(image, kitty_gets_a_png_in_pieces);
    tcase_add_test(image, sixels_as_gnuplot_draws_them);
    tcase_add_test(image, never_where_it_is_not_wanted);
    tcase_add_test(image, ending_from_a_picture);
    suite_add_tcase(suite, image);
    return suite;
}
