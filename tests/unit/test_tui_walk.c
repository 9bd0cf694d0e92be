/* A walk over everything: every key of every screen, every field with input of every sort, on sizes of every sort. */
#include <check.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tui_fixture.h"

static struct fixture f;
static uint64_t seed;

static void setup(void)
{
    fixture_open(&f, "towers", 80, 24, true);
    seed = 20111;
}

static void teardown(void)
{
    fixture_close(&f);
}

static int pick(int n) /* xorshift64 */
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (int)(seed % (uint64_t)n);
}

/* Another size, from 5x2 to 200x60; what is drawn is what may be drawn, and the cursor is within. */
static void other_size(void)
{
    f.script.width = 5 + pick(196);
    f.script.height = 2 + pick(59);
    thud_tui_key(f.tui, THUD_KEY_RESIZE);
    thud_tui_draw(f.tui);
    const struct thud_canvas *canvas = &f.tui->canvas;
    ck_assert_int_eq(canvas->width, f.script.width);
    ck_assert_int_eq(canvas->height, f.script.height);
    ck_assert_int_lt(canvas->cursor_x, canvas->width);
    ck_assert_int_lt(canvas->cursor_y, canvas->height);
    int controls = 0; /* counted: an assertion that holds costs more than a look at a cell */
    for (int i = 0; i < canvas->width * canvas->height; i++)
        controls += canvas->cell[i].glyph < 0x20;
    ck_assert_int_eq(controls, 0);
}

/* Out of whatever a key led into. */
static void leave(void)
{
    fixture_keys(&f, "<Size 80x24><Esc><Esc>"); /* below the least size only q and Ctrl-C are heard */
    ck_assert_int_eq((int)f.tui->dialog.mode, THUD_MODE_NORMAL);
    f.tui->end.quit = false;
}

static void go(int screen, const char *size)
{
    char keys[64];
    snprintf(keys, sizeof keys, "%s<A-%d>", size, screen + 1);
    fixture_keys(&f, keys);
    ck_assert_int_eq((int)f.tui->screen, screen);
}

/* The key that `P` and `p` stand for starts a child: other tests have those. */
static bool draws(const struct thud_key_entry *key)
{
    return key->action == THUD_DO_PICTURE || key->action == THUD_DO_PICTURES;
}

START_TEST(every_key_of_every_screen)
{
    for (int screen = 0; screen < THUD_SCREENS; screen++)
        for (int k = 0; k < thud_key_count(); k++) {
            const struct thud_key_entry *key = thud_key_at(k);
            if (!(key->where & thud_views[screen]->where) || draws(key))
                continue;
            for (int other = 0; other < 2; other++) {
                int code = other ? key->other : key->key;
                if (!code)
                    continue;
                go(screen, pick(2) ? "<Size 80x24>" : "<Size 130x40>");
                thud_tui_key(f.tui, code);
                other_size();
                leave();
                struct thud_error err = {0};
                char text[400];
                ck_assert_msg(thud_scene_check(&f.tui->doc.scene, &err) == THUD_OK, "%s on screen %d: %s", key->written,
                              screen + 1, thud_error_text(&err, text, sizeof text));
            }
        }
}
END_TEST

static const char *const inputs[] = {"",
                                     "0",
                                     "1",
                                     "2 cm",
                                     "0.5",
                                     "5 %",
                                     "1e-3 m",
                                     "1000 t",
                                     "3 MN/m",
                                     "-1",
                                     "-1 cm",
                                     "1e99",
                                     "1e999",
                                     "abc",
                                     "1 2",
                                     "3,5",
                                     "nan",
                                     "inf",
                                     "+",
                                     "-",
                                     "on",
                                     "exact",
                                     "1 parsec",
                                     "\xc3\xa9",
                                     "0x10",
                                     "1e5 s",
                                     "99999 kN/mm",
                                     "0.4 kN/mm^2.65",
                                     "2 g",
                                     "100000000000000000000000000000000000000000000000"};

/* Types every input into a field: taken, and the scene is sound; or refused, and it is as it was. */
static void try_field(const char *path)
{
    for (size_t i = 0; i < sizeof inputs / sizeof *inputs; i++) {
        static struct thud_scene before;
        struct thud_error err = {0};
        char text[400];
        before = f.tui->doc.scene;
        thud_form_focus_on(&f.tui->form, (int)f.tui->screen, path);
        fixture_keys(&f, "");
        if (!thud_form_focus(&f.tui->form) || strcmp(thud_form_focus(&f.tui->form)->path, path) != 0)
            return; /* another kind of structure has it no more */
        fixture_keys(&f, "<Enter>");
        if (f.tui->dialog.mode == THUD_MODE_CHOOSING) {
            fixture_keys(&f, inputs[i]);
            fixture_keys(&f, "<Enter>");
        } else {
            fixture_keys(&f, "<C-u>");
            fixture_keys(&f, inputs[i]);
            fixture_keys(&f, "<Enter>");
            bool refused = f.tui->dialog.mode == THUD_MODE_TYPING;
            ck_assert_msg(!refused || memcmp(&before, &f.tui->doc.scene, sizeof before) == 0,
                          "%s: \"%s\" was refused, and taken", path, inputs[i]);
            ck_assert_msg(!refused || f.tui->said.role == THUD_ROLE_ERROR, "%s: \"%s\" was refused without a word",
                          path, inputs[i]);
        }
        if (i % 4 == 0)
            other_size();
        f.script.width = 130;
        f.script.height = 40;
        leave();
        ck_assert_msg(thud_scene_check(&f.tui->doc.scene, &err) == THUD_OK, "%s: \"%s\": %s", path, inputs[i],
                      thud_error_text(&err, text, sizeof text));
    }
}

/* What is on show is walked as a list of its own, as edits change it. Undo leads back to the start, word by word. */
START_TEST(every_field_with_every_input)
{
    static struct thud_scene first;
    first = f.tui->doc.scene;
    f.tui->run.on = false; /* two hundred storeys are for other tests */
    for (int screen = 0; screen < THUD_SCREENS; screen++) {
        static char path[400][THUD_PATH_MAX];
        int n = 0;
        go(screen, "<Size 130x40>");
        for (int i = 0; i < f.tui->form.n && n < 400; i++)
            if (f.tui->form.field[i].kind == THUD_FIELD_VALUE)
                memcpy(path[n++], f.tui->form.field[i].path, THUD_PATH_MAX);
        for (int i = 0; i < n; i++)
            try_field(path[i]);
        for (int i = 0; f.tui->doc.undo.at > 0 && i < 100000; i++)
            fixture_keys(&f, "u");
        ck_assert_mem_eq(&f.tui->doc.scene, &first, sizeof first);
        f.tui->run.on = false;
        if (screen < THUD_SCREEN_RESULTS)
            ck_assert_int_gt(n, 5);
    }
}
END_TEST

/* Every row that can be chosen, and every command with and without an argument. */
START_TEST(every_row_and_every_command)
{
    ck_assert_int_eq(chdir(f.folder), 0); /* some commands write files */
    struct thud_text words = {0};
    for (int screen = 0; screen < THUD_SCREENS; screen++) {
        go(screen, "<Size 80x24>");
        for (int i = 0; i < 30; i++) {
            fixture_keys(&f, pick(4) ? "<Down>" : "<Tab>");
            fixture_keys(&f, "<Enter>");
            other_size();
            leave();
            go(screen, "<Size 80x24>");
        }
    }
    thud_commands_text(&words);
    char *rest = words.data;
    for (char *line; (line = strtok_r(rest, "\n", &rest)) != NULL;) {
        char word[40], keys[100];
        ck_assert_int_eq(sscanf(line, ":%39s", word), 1);
        if (strcmp(word, "figures") == 0 || strcmp(word, "write") == 0)
            continue; /* files and children */
        snprintf(keys, sizeof keys, ":%s<Enter><Esc>", word);
        fixture_keys(&f, keys);
        leave();
        snprintf(keys, sizeof keys, ":%s  nonsense 1e99<Enter>", word);
        fixture_keys(&f, keys);
        other_size();
        leave();
    }
    thud_text_clear(&words);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui walk");
    const struct {
        const char *name;
        const TTest *test;
    } part[] = {{"keys", every_key_of_every_screen},
                {"fields", every_field_with_every_input},
                {"rows", every_row_and_every_command}};
    for (size_t i = 0; i < sizeof part / sizeof *part; i++) {
        TCase *walk = tcase_create(part[i].name);
        tcase_set_timeout(walk, 300.0);
        tcase_add_checked_fixture(walk, setup, teardown);
        tcase_add_test(walk, part[i].test);
        suite_add_tcase(suite, walk);
    }
    return suite;
}
