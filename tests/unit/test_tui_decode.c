/* Keys from bytes: every sequence in every splitting, nothing of an unknown one taken for a key. */
#include <check.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "tui/terminal/backend.h"
#include "tui/terminal/decode.h"

static struct thud_decode decode;

static void setup(void)
{
    thud_decode_init(&decode);
}

/* All keys of `text` as words, fed in pieces of `piece` bytes with nothing waited for in between. */
static const char *keys_of(const char *text, size_t n, size_t piece)
{
    static char out[4096];
    bool more = false;
    size_t size = 0;
    *out = '\0';
    for (size_t at = 0; at < n || more; at += piece) {
        bool ended = at >= n;
        if (!ended)
            thud_decode_add(&decode, text + at, n - at < piece ? n - at : piece);
        for (int key; (key = thud_decode_next(&decode, ended, &more)) != THUD_KEY_NONE;)
            size += (size_t)snprintf(out + size, sizeof out - size, "%s%x", size ? " " : "", (unsigned)key);
        if (ended)
            break;
    }
    return out;
}

/* What a terminal says of itself is no key, in any splitting. */
START_TEST(the_answer_of_a_terminal)
{
    static const struct {
        const char *text;
        bool sixel;
    } answer[] = {{"\033[?62;4;6;9;15;22c", true}, {"\033[?63;1;2;4c", true}, {"\033[?4c", false},
                  {"\033[?64;14;40c", false},      {"\033[?1;2c", false},     {"\033[?6c", false}};
    for (size_t i = 0; i < sizeof answer / sizeof *answer; i++)
        for (size_t piece = 1; piece < 20; piece++) {
            char text[64];
            snprintf(text, sizeof text, "%sx", answer[i].text);
            thud_decode_init(&decode);
            ck_assert_str_eq(keys_of(text, strlen(text), piece), "78");
            ck_assert(decode.attributes && decode.sixel == answer[i].sixel);
        }
    thud_decode_init(&decode);
    ck_assert_str_eq(keys_of("\033[?25h\033[4c", 10, 3), "");
    ck_assert(!decode.attributes);
}
END_TEST

static void expect(const char *text, const char *wanted)
{
    for (size_t piece = 1; piece <= strlen(text) + 1; piece++) {
        thud_decode_init(&decode);
        const char *found = keys_of(text, strlen(text), piece);
        ck_assert_msg(strcmp(found, wanted) == 0, "\"%s\" in pieces of %zu: %s, wanted %s", text + 1, piece, found,
                      wanted);
        ck_assert_uint_eq(decode.n, 0);
    }
}

static void expect_key(const char *text, int key)
{
    char wanted[16];
    snprintf(wanted, sizeof wanted, "%x", (unsigned)key);
    expect(text, wanted);
}

START_TEST(keys_of_terminals)
{
    static const struct {
        const char *bytes;
        int key;
    } row[] = {{"\033[A", THUD_KEY_UP},       {"\033OA", THUD_KEY_UP},
               {"\033[4~", THUD_KEY_END},     {"\033OF", THUD_KEY_END},
               {"\033[F", THUD_KEY_END},      {"\033[8~", THUD_KEY_END},
               {"\033[1~", THUD_KEY_HOME},    {"\033[11~", THUD_KEY_F1},
               {"\033OP", THUD_KEY_F1},       {"\033[[A", THUD_KEY_F1},
               {"\033[12~", THUD_KEY_F2},     {"\033[Z", THUD_KEY_BACKTAB},
               {"\033[3~", THUD_KEY_DELETE},  {"\033[6~", THUD_KEY_PAGE_DOWN},
               {"\r", THUD_KEY_ENTER},        {"\n", THUD_KEY_ENTER},
               {"\177", THUD_KEY_BACKSPACE},  {"\010", THUD_KEY_BACKSPACE},
               {"\0333", THUD_KEY_ALT + '3'}, {"\033", THUD_KEY_ESC},
               {"\033OM", THUD_KEY_ENTER},    {"\303\251", 0xe9},
               {"\360\237\230\200", 0x1f600}, {"q", 'q'}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        expect_key(row[i].bytes, row[i].key);
    expect("\033\033", "1b 1b");
    expect("\033[A\033[B7", "200000 200001 37");
}
END_TEST

/* Function keys, modified arrows, reports and answers of terminals, Alt with letters: whole, and nothing. */
START_TEST(unknown_sequences_are_dropped_whole)
{
    static const char *const row[] = {"\033[15~",
                                      "\033[24~",
                                      "\033[1;5A",
                                      "\033[1;2D",
                                      "\033OR",
                                      "\033Oj",
                                      "\033[I",
                                      "\033[O",
                                      "\033[?62;1;2c",
                                      "\033[12;40R",
                                      "\033]11;rgb:0/0/0\a",
                                      "\033]52;c;d\033\\",
                                      "\033P1+r4d\033\\",
                                      "\033d",
                                      "\033q",
                                      "\033D",
                                      "\033[97;5u",
                                      "\033[27;5;9~",
                                      "\033\033[A",
                                      "\033[[E",
                                      "\033[3;2~",
                                      "\033[<64;300;1X",
                                      "\033[?1;2$y"};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        char with[64];
        expect(row[i], "");
        snprintf(with, sizeof with, "%s7", row[i]); /* what follows is a key again */
        expect(with, "37");
    }
    expect("\377\300\2007", "37"); /* no UTF-8 */
}
END_TEST

START_TEST(the_terminals_own_sequences_are_learned)
{
    thud_decode_learn(&decode, "\033[25~", THUD_KEY_F2);
    thud_decode_learn(&decode, "x", THUD_KEY_F1);
    ck_assert_str_eq(keys_of("\033[25~x", 6, 2), "20000b 78");
}
END_TEST

START_TEST(pasted_text_is_one_key)
{
    static const char text[] = "a\033[200~1\t2\rq\033[1m\033[201~b";
    for (size_t piece = 1; piece < sizeof text; piece++) {
        char wanted[32];
        thud_decode_init(&decode);
        snprintf(wanted, sizeof wanted, "61 %x 62", (unsigned)THUD_KEY_PASTE);
        ck_assert_str_eq(keys_of(text, sizeof text - 1, piece), wanted);
        ck_assert_str_eq(decode.paste, "1\t2\rq\033[1m");
    }
    thud_decode_init(&decode); /* more than there is room for: the rest is no key either */
    bool more;
    thud_decode_add(&decode, "\033[200~", 6);
    for (int i = 0; i < THUD_PASTE_MAX; i++) {
        thud_decode_add(&decode, "xy", 2);
        ck_assert_int_eq(thud_decode_next(&decode, false, &more), THUD_KEY_NONE);
    }
    thud_decode_add(&decode, "\033[201~", 6);
    ck_assert_int_eq(thud_decode_next(&decode, false, &more), THUD_KEY_PASTE);
    ck_assert_uint_eq(strlen(decode.paste), THUD_PASTE_MAX - 1);
}
END_TEST

START_TEST(reports_of_the_mouse)
{
    static const char old[] = {'\033', '[', 'M', ' ', 33 + 5, 33 + 7}, release[] = {'\033', '[', 'M', '#', 33, 33};
    char wanted[32];
    snprintf(wanted, sizeof wanted, "%x", (unsigned)THUD_KEY_CLICK);
    ck_assert_str_eq(keys_of(old, sizeof old, 1), wanted);
    ck_assert_int_eq(decode.mouse_x, 5);
    ck_assert_int_eq(decode.mouse_y, 7);
    ck_assert_str_eq(keys_of(release, sizeof release, 2), "");
    expect_key("\033[<0;131;40M", THUD_KEY_CLICK);
    ck_assert_int_eq(decode.mouse_x, 130);
    ck_assert_int_eq(decode.mouse_y, 39);
    expect("\033[<0;131;40m", "");
    expect("\033[<2;1;1M", "");
    expect_key("\033[<64;1;1M", THUD_KEY_WHEEL_UP);
    expect_key("\033[<65;1;1M", THUD_KEY_WHEEL_DOWN);
    expect_key("\033[<32;7;9M", THUD_KEY_DRAG);
    ck_assert_int_eq(decode.mouse_x, 6);
    expect("\033[<35;7;9M", ""); /* no button is down */
}
END_TEST

/* Any bytes in any pieces: it ends, and gives keys that there are. */
START_TEST(any_bytes)
{
    uint64_t seed = 7;
    for (int i = 0; i < 200000; i++) {
        static const char often[] = "\033\033[O<M;0~1205u\\]PAm\r";
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        char byte = seed % 3 ? often[(seed >> 8) % (sizeof often - 1)] : (char)(seed >> 16);
        bool more;
        thud_decode_add(&decode, &byte, 1);
        for (int key; (key = thud_decode_next(&decode, seed % 5 == 0, &more)) != THUD_KEY_NONE;) {
            ck_assert_int_gt(key, 0);
            ck_assert(key < 0x110000 || (key >= THUD_KEY_FIRST && key <= THUD_KEY_HANGUP) ||
                      (key >= THUD_KEY_ALT + '0' && key <= THUD_KEY_ALT + '9'));
        }
    }
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui decode");
    TCase *keys = tcase_create("decode");
    tcase_add_checked_fixture(keys, setup, NULL);
    tcase_add_test(keys, the_answer_of_a_terminal);
    tcase_add_test(keys, keys_of_terminals);
    tcase_add_test(keys, unknown_sequences_are_dropped_whole);
    tcase_add_test(keys, the_terminals_own_sequences_are_learned);
    tcase_add_test(keys, pasted_text_is_one_key);
    tcase_add_test(keys, reports_of_the_mouse);
    tcase_add_test(keys, any_bytes);
    suite_add_tcase(suite, keys);
    return suite;
}
