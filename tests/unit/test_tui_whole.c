/* Whole screens at three sizes, after an edit that has its effect in sight: what is kept in tests/screens/whole. With
 * THUD_WHOLE_WRITE set they are written anew, to be looked at before they are kept. */
#include <check.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tui_fixture.h"

static struct fixture f;
static int working_folder;

static void setup(void)
{
    working_folder = open(".", O_RDONLY | O_DIRECTORY);
    ck_assert_int_ge(working_folder, 0);
    fixture_open(&f, "towers", 80, 24, true);
}

static void teardown(void)
{
    ck_assert_int_eq(fchdir(working_folder), 0);
    close(working_folder);
    fixture_close(&f);
}

/* Model, Contact with the gap dragged, Record, Results, Plots, Sweep, the designs, the form of a report. */
static const char *const shown[] = {"1", "2)", "3", "4", "5", "6", "2U", "<Esc>wR"};
enum { SHOWN = sizeof shown / sizeof *shown };

static const struct {
    int width, height;
} sizes[] = {{80, 24}, {130, 40}, {200, 60}};
enum { SIZES = sizeof sizes / sizeof *sizes };

/* Up to the folder of the test, whose name is another each time. */
static void without_folder(char *text)
{
    for (char *at = text; (at = strstr(at, f.folder)) != NULL;)
        memset(at, '.', strlen(f.folder));
}

START_TEST(whole_screens)
{
    char path[120], size[32], *line = NULL, *screen;
    size_t room = 0;
    snprintf(path, sizeof path, "tests/screens/whole/%dx%d.txt", sizes[_i].width, sizes[_i].height);
    snprintf(size, sizeof size, "<Size %dx%d>", sizes[_i].width, sizes[_i].height);
    const bool writes = getenv("THUD_WHOLE_WRITE") != NULL;
    FILE *file = fopen(path, writes ? "w" : "r");
    ck_assert_msg(file != NULL, "%s cannot be opened", path);
    ck_assert_int_eq(chdir(f.folder), 0); /* whose files are listed */
    fixture_keys(&f, size);
    fixture_keys(&f, ":set gap 3 cm<Enter>");
    for (int i = 0; i < SHOWN; i++) {
        fixture_keys(&f, shown[i]);
        screen = fixture_text(&f);
        without_folder(screen);
        if (writes)
            fprintf(file, "%s", screen);
        int number = 0;
        for (char *at = screen, *end; !writes && *at && (end = strchr(at, '\n')) != NULL; at = end + 1) {
            ck_assert_msg(getline(&line, &room, file) > 0, "%s ends before %s", path, shown[i]);
            number++;
            ck_assert_msg(strncmp(line, at, (size_t)(end - at) + 1) == 0, "%s: line %d of \"%s\" is\n%.*s\nnot\n%s",
                          path, number, shown[i], (int)(end - at), at, line);
        }
        free(screen);
    }
    free(line);
    fclose(file);
}
END_TEST

/* Room is used: of no pane is more than a third empty below the last row that something stands in. */
START_TEST(no_pane_is_a_third_empty)
{
    enum { WIDTH = 200, HEIGHT = 60 };
    fixture_close(&f);
    fixture_open(&f, "towers", WIDTH, HEIGHT, true);
    snprintf(f.paths.records, sizeof f.paths.records, "records"); /* and presets: those that come with thud */
    snprintf(f.paths.presets, sizeof f.paths.presets, "presets");
    fixture_keys(&f, ":open towers<Enter>");
    fixture_expect(&f, "kobe-surrogate.csv");
    for (int screen = 0; screen < THUD_SCREEN_HELP; screen++) {
        char keys[2] = {(char)('1' + screen), '\0'};
        struct thud_rect pane[THUD_PANES_MAX];
        fixture_keys(&f, keys);
        const int n = thud_views[screen]->layout(f.tui, thud_tui_area(f.tui), pane);
        for (int i = 0; i < n; i++) {
            int empty = 0;
            for (int y = pane[i].y + 1; y < pane[i].y + pane[i].h - 1; y++) {
                bool any = false;
                for (int x = pane[i].x + 1; x < pane[i].x + pane[i].w - 1; x++)
                    any = any || f.tui->canvas.cell[y * WIDTH + x].glyph != ' ';
                empty = any ? 0 : empty + 1;
            }
            ck_assert_msg(3 * empty <= pane[i].h - 2, "%s: of pane %d %d of %d rows are empty",
                          thud_views[screen]->title, i + 1, empty, pane[i].h - 2);
        }
    }
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui whole");
    TCase *whole = tcase_create("whole");
    tcase_set_timeout(whole, 60.0);
    tcase_add_checked_fixture(whole, setup, teardown);
    tcase_add_loop_test(whole, whole_screens, 0, SIZES);
    tcase_add_test(whole, no_pane_is_a_third_empty);
    suite_add_tcase(suite, whole);
    return suite;
}
