/* Canvas, dots, lines of text, lists, undo: what the screens are made of. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tui/document/keys.h"
#include "tui/document/undo.h"
#include "tui/terminal/roles.h"
#include "tui/widgets/chooser.h"
#include "tui/widgets/dots.h"

static const struct thud_look plain = {0, 0};

static void open_canvas(struct thud_canvas *canvas, int w, int h, bool ascii)
{
    memset(canvas, 0, sizeof *canvas);
    canvas->ascii = ascii;
    ck_assert_int_eq(thud_canvas_resize(canvas, w, h, NULL), THUD_OK);
}

static void expect(struct thud_canvas *canvas, const char *text)
{
    char *is = thud_canvas_text(canvas);
    ck_assert_str_eq(is, text);
    free(is);
    thud_canvas_free(canvas);
}

START_TEST(text_is_cut_at_the_edges)
{
    struct thud_canvas canvas;
    open_canvas(&canvas, 5, 2, false);
    struct thud_pane page = thud_canvas_pane(&canvas);
    ck_assert_int_eq(thud_pane_put(&page, 3, 0, plain, "abcd"), 4);
    thud_pane_put(&page, -1, 1, plain, "xyz");
    thud_pane_put(&page, 0, 2, plain, "below");
    expect(&canvas, "   ab\nyz\n");
}
END_TEST

START_TEST(a_pane_keeps_to_itself_and_scrolls)
{
    struct thud_canvas canvas;
    open_canvas(&canvas, 6, 4, false);
    struct thud_pane page = thud_canvas_pane(&canvas), in = thud_pane_inside(&page, 2, 1, 3, 2);
    in.scroll = 1;
    thud_pane_put(&in, 0, 0, plain, "up");
    thud_pane_put(&in, 0, 1, plain, "first");
    thud_pane_put(&in, 0, 2, plain, "2nd");
    thud_pane_put(&in, 0, 3, plain, "no");
    expect(&canvas, "\n  fir\n  2nd\n\n");
}
END_TEST

START_TEST(wide_and_strange_signs_keep_their_columns)
{
    struct thud_canvas canvas;
    open_canvas(&canvas, 9, 1, false);
    struct thud_pane page = thud_canvas_pane(&canvas);
    thud_pane_put(
        &page, 0, 0, plain,
        "\xc3\xa9\xe4\xb8\xad\x01\xff\xcc\x81|"); /* e acute, a wide one, control, no UTF-8, a combining one */
    ck_assert_int_eq(thud_utf8_columns("\xe4\xb8\xad\xcc\x81|"), 3);
    expect(&canvas, "\xc3\xa9\xe4\xb8\xad??|\n");
    open_canvas(&canvas, 5, 1, false);
    page = thud_canvas_pane(&canvas);
    thud_pane_put(&page, 0, 0, plain, "\xe4\xb8\xad\xe4\xb8\xad\xe4\xb8\xad"); /* no room for the third */
    thud_pane_glyph(&page, 1, 0, plain, 'x');                                  /* half of the first goes */
    expect(&canvas, " x\xe4\xb8\xad?\n");
    char out[16];
    ck_assert_str_eq(thud_utf8_fit("\xe4\xb8\xad\xe4\xb8\xad\xe4\xb8\xad", 5, out, sizeof out),
                     "\xe4\xb8\xad\xe4\xb8\xad\xe2\x80\xa6");
    ck_assert_str_eq(thud_utf8_fit("Library", 7, out, sizeof out), "Library");
    ck_assert_str_eq(thud_utf8_fit("Library", 5, out, sizeof out), "Libr\xe2\x80\xa6");
}
END_TEST

START_TEST(ascii_has_nothing_else)
{
    struct thud_canvas canvas;
    open_canvas(&canvas, 12, 4, true);
    struct thud_pane page = thud_canvas_pane(&canvas);
    struct thud_pane in = thud_pane_frame(&page, "m/s\xc2\xb2", false);
    thud_pane_put(&in, 0, 0, plain, "1\xe2\x86\x92\x32\xc3\xa9");
    expect(&canvas, "+ m/s2 ----+\n|1>2?      |\n|          |\n+----------+\n");
}
END_TEST

START_TEST(blanks_wrap)
{
    struct thud_canvas canvas;
    open_canvas(&canvas, 8, 4, false);
    struct thud_pane page = thud_canvas_pane(&canvas);
    ck_assert_int_eq(thud_pane_wrap(&page, 1, 0, 6, plain, "one two three\nx"), 4);
    expect(&canvas, " one\n two\n three\n x\n");
}
END_TEST

/* A straight line through all of a cell's dots, and one far outside that only crosses. */
START_TEST(dots_join_and_clip)
{
    struct thud_canvas canvas;
    struct thud_dots dots;
    open_canvas(&canvas, 3, 1, false);
    struct thud_pane page = thud_canvas_pane(&canvas);
    ck_assert_int_eq(thud_dots_init(&dots, &page, NULL), THUD_OK);
    thud_dots_line(&dots, 0.0, 0.0, 0.0, 3.0, 1, plain);
    thud_dots_line(&dots, -1e9, 3.0, 1e9, 3.0, 1, plain);
    thud_dots_line(&dots, NAN, 0.0, 1.0, 1.0, 1, plain);
    thud_dots_line(&dots, 0.0, -5.0, 5.0, -5.0, 1, plain);
    thud_dots_put(&dots);
    thud_dots_clear(&dots);
    expect(&canvas, "\xe2\xa3\x87\xe2\xa3\x80\xe2\xa3\x80\n"); /* left column and bottom row; then bottom rows */
}
END_TEST

static void type(struct thud_line *line, const char *text)
{
    for (uint32_t c; (c = thud_utf8_next(&text)) != 0;)
        ck_assert(thud_line_key(line, (int)c));
}

START_TEST(a_line_is_edited)
{
    struct thud_line line;
    thud_line_set(&line, "5 cm");
    thud_line_key(&line, THUD_KEY_HOME);
    type(&line, "\xc3\xa9");
    thud_line_key(&line, THUD_KEY_DELETE);
    ck_assert_str_eq(line.text, "\xc3\xa9 cm");
    thud_line_key(&line, THUD_KEY_LEFT);
    ck_assert_int_eq(line.cursor, 0);
    thud_line_key(&line, THUD_KEY_LEFT);
    thud_line_key(&line, THUD_KEY_BACKSPACE);
    thud_line_key(&line, THUD_KEY_RIGHT);
    ck_assert_int_eq(line.cursor, 2);
    thud_line_key(&line, THUD_KEY_BACKSPACE);
    ck_assert_str_eq(line.text, " cm");
    ck_assert(!thud_line_key(&line, THUD_KEY_UP));
    thud_line_key(&line, THUD_CTRL('u'));
    for (int i = 0; i < 2 * THUD_LINE_MAX; i++)
        type(&line, "x");
    ck_assert_uint_eq(strlen(line.text), THUD_LINE_MAX - 1);
}
END_TEST

START_TEST(typing_narrows_a_list)
{
    struct thud_chooser chooser = {0};
    thud_chooser_begin(&chooser, "laws");
    thud_chooser_add(&chooser, "none", "no contact");
    thud_chooser_add(&chooser, "linear", "a spring");
    thud_chooser_add(&chooser, "hertz", "a Spring, stiffening");
    thud_chooser_key(&chooser, THUD_KEY_DOWN);
    ck_assert_str_eq(thud_chooser_marked(&chooser)->value, "linear");
    for (const char *c = "stiff spr"; *c; c++)
        thud_chooser_key(&chooser, *c);
    ck_assert_str_eq(thud_chooser_marked(&chooser)->value, "hertz");
    thud_chooser_key(&chooser, 'q');
    ck_assert_ptr_null(thud_chooser_marked(&chooser));
    thud_chooser_free(&chooser);
}
END_TEST

START_TEST(undo_takes_every_step_back_and_forward)
{
    static struct thud_scene scene, first, before;
    struct thud_undo undo = {0};
    memset(&scene, 0, sizeof scene);
    scene.nstructures = 2;
    first = scene;
    for (int i = 0; i < 1000; i++) {
        before = scene;
        scene.structure[i % 20].mass_kg[i % 200] += i + 1.0;
        scene.interface[0].gap_m = 0.01 * i;
        ck_assert_int_eq(thud_undo_note(&undo, &before, &scene, "a step", NULL), THUD_OK);
    }
    before = scene;
    ck_assert_int_eq(thud_undo_note(&undo, &before, &scene, "nothing", NULL), THUD_OK);
    ck_assert_int_eq(undo.count, 1000);
    int steps = 0;
    while (thud_undo_back(&undo, &scene))
        steps++;
    ck_assert_int_eq(steps, 1000);
    ck_assert_mem_eq(&scene, &first, sizeof scene);
    while (thud_undo_forward(&undo, &scene))
        steps--;
    ck_assert_int_eq(steps, 0);
    ck_assert_mem_eq(&scene, &before, sizeof scene);
    thud_undo_back(&undo, &scene);
    first = scene;
    scene.nstructures = 3;
    ck_assert_int_eq(thud_undo_note(&undo, &first, &scene, "another way", NULL), THUD_OK);
    ck_assert_ptr_null(thud_undo_forward(&undo, &scene));
    ck_assert_str_eq(thud_undo_what(&undo, 0), "another way");
    thud_undo_clear(&undo);
}
END_TEST

/* Relative luminance of an entry of the 256 colours from 16 on: a cube of 6 x 6 x 6, then 24 greys (xterm). */
static double luminance(int color)
{
    static const int level[] = {0, 0x5f, 0x87, 0xaf, 0xd7, 0xff};
    static const double weight[] = {0.2126, 0.7152, 0.0722};
    int rgb[3] = {8 + 10 * (color - 232), 8 + 10 * (color - 232), 8 + 10 * (color - 232)};
    double sum = 0.0;
    for (int i = 0, cube = color - 16; color < 232 && i < 3; i++, cube /= 6)
        rgb[2 - i] = level[cube % 6];
    for (int i = 0; i < 3; i++) {
        double c = rgb[i] / 255.0;
        sum += weight[i] * (c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4));
    }
    return sum;
}

/* Every role can be read on black and on white (WCAG 2.1 asks 3:1 of large text and drawings); with few colours none of
 * those is used that cannot be seen on one of them. */
START_TEST(every_role_is_seen_on_black_and_on_white)
{
    ck_assert_double_eq_tol(luminance(231), 1.0, 1e-12);
    ck_assert_double_eq_tol(luminance(196), 0.2126, 1e-12);
    for (int role = 0; role < THUD_ROLES; role++) {
        int color = thud_role_color(THUD_THEME_AUTO, role, 256), few = thud_role_color(THUD_THEME_AUTO, role, 16),
            fewer = thud_role_color(THUD_THEME_AUTO, role, 8);
        ck_assert_msg(color == -1 || color >= 16, "role %d: %d is another colour in every terminal", role, color);
        double l = color < 0 ? 0.18 : luminance(color);
        ck_assert_msg((l + 0.05) / 0.05 >= 3.3 && 1.05 / (l + 0.05) >= 3.3, "role %d: %.2f on black, %.2f on white",
                      role, (l + 0.05) / 0.05, 1.05 / (l + 0.05));
        ck_assert(few == -1 || few == 1 || few == 5 || few == 12);
        ck_assert(fewer == -1 || fewer == 1 || fewer == 5 || (fewer == 4 && thud_role_bold(THUD_THEME_AUTO, role, 8)));
    }
    for (int i = 0; i < 8; i++)
        for (int j = 0; j < i; j++)
            ck_assert_int_ne(thud_role_color(THUD_THEME_AUTO, THUD_ROLE_SERIES + i, 256),
                             thud_role_color(THUD_THEME_AUTO, THUD_ROLE_SERIES + j, 256));
}
END_TEST

/* A theme for one background has more contrast there; mono has no colour, and 16 none of the others. */
START_TEST(the_themes_can_be_read)
{
    for (int role = 0; role < THUD_ROLES; role++) {
        int dark = thud_role_color(THUD_THEME_DARK, role, 256), light = thud_role_color(THUD_THEME_LIGHT, role, 256);
        ck_assert(dark == -1 || dark >= 16);
        ck_assert(light == -1 || light >= 16);
        double on_black = dark < 0 ? 21.0 : (luminance(dark) + 0.05) / 0.05,
               on_white = light < 0 ? 21.0 : 1.05 / (luminance(light) + 0.05);
        ck_assert_msg(on_black >= 4.5, "role %d: %.2f on black", role, on_black);
        ck_assert_msg(on_white >= 4.5, "role %d: %.2f on white", role, on_white);
        for (int colors = 8; colors <= 256; colors = colors == 8 ? 16 : 256 + (colors == 256)) {
            int few = thud_role_color(THUD_THEME_LIGHT, role, colors);
            ck_assert_int_eq(thud_role_color(THUD_THEME_MONO, role, colors), -1);
            ck_assert(!thud_role_bold(THUD_THEME_MONO, role, colors));
            ck_assert_int_lt(thud_role_color(THUD_THEME_16, role, colors), 16);
            ck_assert_int_lt(thud_role_color(THUD_THEME_DARK, role, colors), colors);
            if (colors < 256) { /* neither white nor what is pale, nor on black what is dark */
                ck_assert(few == -1 || few == 1 || few == 4 || few == 5);
                ck_assert_int_ne(thud_role_color(THUD_THEME_DARK, role, colors), 4);
                ck_assert_int_ne(thud_role_color(THUD_THEME_DARK, role, colors), 0);
            }
        }
    }
    for (int i = 0; i < 8; i++) /* on black sixteen are enough */
        for (int j = 0; j < i; j++)
            ck_assert_int_ne(thud_role_color(THUD_THEME_DARK, THUD_ROLE_SERIES + i, 16),
                             thud_role_color(THUD_THEME_DARK, THUD_ROLE_SERIES + j, 16));
    for (int theme = THUD_THEME_DARK; theme <= THUD_THEME_LIGHT; theme++)
        for (int i = 0; i < 8; i++)
            for (int j = 0; j < i; j++)
                ck_assert_int_ne(thud_role_color((enum thud_theme)theme, THUD_ROLE_SERIES + i, 256),
                                 thud_role_color((enum thud_theme)theme, THUD_ROLE_SERIES + j, 256));
}
END_TEST

/* No key means two things at one place; every entry is reached by its own key somewhere it holds. */
START_TEST(the_key_table_is_sound)
{
    for (int i = 0; i < thud_key_count(); i++) {
        const struct thud_key_entry *key = thud_key_at(i);
        ck_assert_msg(*key->help && *key->written, "entry %d has no words", i);
        int reached = 0;
        for (int bit = 1; bit <= THUD_AT_DESIGNS; bit <<= 1)
            if (key->where & bit)
                reached += thud_key_action(bit, key->key) == key->action;
        ck_assert_msg(reached > 0, "%s (%s) is never reached", key->written, key->help);
        for (int j = 0; j < i; j++) {
            const struct thud_key_entry *other = thud_key_at(j);
            ck_assert_msg(other->where != key->where || other->key != key->key, "%s stands twice", key->written);
        }
    }
}
END_TEST

/* What can be edited is not what was computed, and a key not a warning: by hue, where there are colours for it. */
START_TEST(roles_are_told_apart)
{
    for (int theme = THUD_THEME_AUTO; theme <= THUD_THEME_LIGHT; theme++) {
        int key = thud_role_color((enum thud_theme)theme, THUD_ROLE_KEY, 256) - 16;
        ck_assert_int_ne(thud_role_color((enum thud_theme)theme, THUD_ROLE_VALUE, 256),
                         thud_role_color((enum thud_theme)theme, THUD_ROLE_RESULT, 256));
        ck_assert_int_ge(key % 6, key / 36); /* of the cube: no more red than blue, as warnings have */
    }
}
END_TEST

/* Of two lines in the same cells none hides the other. */
START_TEST(equal_lines_take_turns)
{
    struct thud_canvas canvas = {0};
    struct thud_dots dots;
    int cells[2] = {0, 0};
    ck_assert_int_eq(thud_canvas_resize(&canvas, 20, 4, NULL), THUD_OK);
    struct thud_pane page = thud_canvas_pane(&canvas);
    ck_assert_int_eq(thud_dots_init(&dots, &page, NULL), THUD_OK);
    for (int series = 0; series < 2; series++)
        thud_dots_line(&dots, 0.0, 0.0, 39.0, 15.0, 1, thud_look(THUD_ROLE_SERIES + series, 0));
    thud_dots_put(&dots);
    for (int i = 0; i < 80; i++)
        if (canvas.cell[i].style.role >= THUD_ROLE_SERIES)
            cells[canvas.cell[i].style.role - THUD_ROLE_SERIES]++;
    ck_assert_int_ge(cells[0], 5);
    ck_assert_int_ge(cells[1], 5);
    thud_dots_clear(&dots);
    thud_canvas_free(&canvas);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui canvas");
    TCase *canvas = tcase_create("canvas");
    tcase_add_test(canvas, roles_are_told_apart);
    tcase_add_test(canvas, equal_lines_take_turns);
    tcase_add_test(canvas, text_is_cut_at_the_edges);
    tcase_add_test(canvas, a_pane_keeps_to_itself_and_scrolls);
    tcase_add_test(canvas, wide_and_strange_signs_keep_their_columns);
    tcase_add_test(canvas, ascii_has_nothing_else);
    tcase_add_test(canvas, blanks_wrap);
    tcase_add_test(canvas, dots_join_and_clip);
    suite_add_tcase(suite, canvas);
    TCase *parts = tcase_create("parts");
    tcase_add_test(parts, a_line_is_edited);
    tcase_add_test(parts, typing_narrows_a_list);
    tcase_add_test(parts, undo_takes_every_step_back_and_forward);
    tcase_add_test(parts, the_key_table_is_sound);
    tcase_add_test(parts, every_role_is_seen_on_black_and_on_white);
    tcase_add_test(parts, the_themes_can_be_read);
    suite_add_tcase(suite, parts);
    return suite;
}
