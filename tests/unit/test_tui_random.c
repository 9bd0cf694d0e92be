/* Random keys on random sizes: the interface stays alive, and what it draws is what it may draw. */
#include <check.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tui_fixture.h"

enum { MANY_EACH = 1000 }; /* keys between two openings of a preset, where there are many */
static int many;           /* keys in all, on larger terminals too: THUD_KEYS; 0: few */

static uint64_t next(uint64_t *seed) /* splitmix64 */
{
    uint64_t z = *seed += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
}

static int pick(uint64_t *seed, int n)
{
    return (int)(next(seed) % (uint64_t)n);
}

/* Mostly keys that mean something, some text, some garbage; now and then another size. */
static int random_key(struct fixture *f, uint64_t *seed)
{
    static const char text[] = "0123456789. cmtkNg%^-+e=/:";
    static const int odd[] = {
        0x7f, 0x1b, 0x9, 0xd, 0xe9, 0x2588, 0x4e2d, 0x1f600, 0x301, 0x10ffff, THUD_KEY_ALT + '3', THUD_KEY_F2};
    int kind = pick(seed, 20);
    if (kind == 0) {
        f->script.width = 5 + pick(seed, 196 + 100 * (many > 0));
        f->script.height = 2 + pick(seed, 59 + 40 * (many > 0));
        return THUD_KEY_RESIZE;
    }
    f->backend.click_x = pick(seed, f->script.width); /* of keys of the mouse */
    f->backend.click_y = pick(seed, f->script.height);
    if (kind < 4)
        return text[pick(seed, (int)sizeof text - 1)];
    if (kind < 6)
        return odd[pick(seed, (int)(sizeof odd / sizeof *odd))];
    if (kind < 9)
        return THUD_KEY_FIRST + pick(seed, THUD_KEY_PASTE - THUD_KEY_FIRST);
    if (kind == 9)
        return 'g';
    return thud_key_at(pick(seed, thud_key_count()))->key;
}

/* Pictures start a child and files are written: left to other tests. */
static bool left_out(const struct fixture *f, int key)
{
    return f->tui->dialog.mode == THUD_MODE_NORMAL &&
           (key == 'p' || key == 'P' || key == 'e' || key == 'w' || key == 'W');
}

/* One assertion for all cells: each one is a message to the runner of the tests. */
static void check_cells(const struct fixture *f)
{
    const struct thud_canvas *canvas = &f->tui->canvas;
    int wrong = -1;
    for (int i = 0; i < canvas->width * canvas->height; i++) {
        const struct thud_cell *cell = &canvas->cell[i];
        if (cell->glyph < 0x20 || (canvas->ascii && cell->glyph >= 0x7f) || cell->style.role >= THUD_ROLES)
            wrong = i;
    }
    ck_assert_msg(wrong < 0, "cell %d of %d x %d: glyph %x, role %d", wrong, canvas->width, canvas->height,
                  (unsigned)canvas->cell[wrong < 0 ? 0 : wrong].glyph,
                  (int)canvas->cell[wrong < 0 ? 0 : wrong].style.role);
    ck_assert_int_lt(canvas->cursor_x, canvas->width);
    ck_assert_int_lt(canvas->cursor_y, canvas->height);
}

static void walk(const char *preset, uint64_t seed, int keys, bool utf8)
{
    struct fixture f;
    fixture_open(&f, preset, 80, 24, utf8);
    ck_assert_int_eq(chdir(f.folder), 0); /* what is written without a folder */
    f.script.tick = many ? 2e-3 : 1e-4;   /* each look at the clock: runs are cut short */
    for (int i = 0; i < keys; i++) {
        int key = random_key(&f, &seed);
        if (left_out(&f, key))
            continue;
        thud_tui_key(f.tui, key);
        f.tui->end.quit = f.tui->end.hangup = false;
        if (pick(&seed, 4) == 0)
            for (int turn = 0; turn < 10 && thud_tui_turn(f.tui, false); turn++)
                ;
        thud_tui_draw(f.tui);
        ck_assert_int_eq(f.tui->canvas.width, f.script.width);
        ck_assert_int_eq(f.tui->canvas.height, f.script.height);
        check_cells(&f);
    }
    fixture_close(&f);
}

START_TEST(random_keys)
{
    walk(_i % 2 ? "bodies" : "towers", 0x7468756400000000U + (uint64_t)_i, many ? MANY_EACH : 150, _i % 3 != 0);
    if (many)
        fprintf(stderr, "%d of %d keys\n", (_i + 1) * MANY_EACH, many);
}
END_TEST

/* Every size there is, drawn once on every screen. */
START_TEST(every_size)
{
    struct fixture f;
    fixture_open(&f, "towers", 80, 24, true);
    for (int screen = 0; screen < THUD_SCREENS; screen++) {
        char keys[24];
        snprintf(keys, sizeof keys, "<A-%d>", screen + 1);
        f.script.width = 80;
        f.script.height = 24;
        fixture_keys(&f, keys);
        ck_assert_int_eq((int)f.tui->screen, screen);
        for (int h = 2; h <= 60; h += h < 26 ? 4 : 17)
            for (int w = 5; w <= 200; w += w < 84 ? 13 : 53) {
                f.script.width = w;
                f.script.height = h;
                thud_tui_draw(f.tui);
                check_cells(&f);
            }
    }
    fixture_close(&f);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui random");
    const char *keys = getenv("THUD_KEYS");
    many = keys ? atoi(keys) : 0;
    const char *before = getenv("THUD_KEYS_DONE");
    const int done = keys && before ? atoi(before) : 0;
    TCase *random = tcase_create("random keys");
    tcase_set_timeout(random, many ? 7200.0 : 120.0);
    tcase_add_loop_test(random, random_keys, done / MANY_EACH, many ? (many + MANY_EACH - 1) / MANY_EACH : 4);
    tcase_add_test(random, every_size);
    suite_add_tcase(suite, random);
    return suite;
}
