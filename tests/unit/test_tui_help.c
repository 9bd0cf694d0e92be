/* Help: every key, every field, search. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

START_TEST(help_names_every_key)
{
    fixture_keys(&f, "<Size 100x500>?");
    for (int i = 0; i < thud_key_count(); i++)
        if (thud_key_at(i)->where & THUD_AT_MODEL &&
            thud_key_action(THUD_AT_MODEL, thud_key_at(i)->key) == thud_key_at(i)->action) {
            char help[70];
            snprintf(help, sizeof help, "%.66s", thud_key_at(i)->help);
            fixture_expect(&f, help);
        }
    fixture_keys(&f, "q");
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_MODEL);
    ck_assert(!f.tui->end.quit);
}
END_TEST

/* Each field of the screen with its unit, bounds and default, from the tables. */
START_TEST(help_explains_every_field)
{
    static const struct {
        enum thud_group group;
        int screen;
    } part[] = {{THUD_GROUP_STRUCTURE, 1}, {THUD_GROUP_INTERFACE, 2}, {THUD_GROUP_BUMPER, 2},
                {THUD_GROUP_RECORD, 3},    {THUD_GROUP_ANALYSIS, 4},  {THUD_GROUP_STUDY, 6}};
    fixture_keys(&f, "<Size 200x600>");
    for (size_t i = 0; i < sizeof part / sizeof *part; i++) {
        char keys[32];
        const struct thud_param *param;
        snprintf(keys, sizeof keys, "<A-%d>?", part[i].screen);
        fixture_keys(&f, keys);
        for (int k = 0; (param = thud_group_param(part[i].group, k)); k++) {
            char help[64];
            snprintf(help, sizeof help, "%.60s", param->help);
            fixture_expect(&f, help);
            fixture_expect(&f, param->name);
        }
        fixture_keys(&f, "q");
    }
    fixture_keys(&f, "<A-2>?");
    fixture_expect(&f, "Law rubber (in use)");
    fixture_expect(&f, "Allowed: 0 cm to 500 cm.");
    fixture_expect(&f, "Default 2500 kN/mm.");
    fixture_expect(&f, "Usual: 0.3 to 0.95.");
}
END_TEST

START_TEST(help_is_searched)
{
    fixture_keys(&f, "<A-2>?");
    fixture_expect_not(&f, "post-yield");
    fixture_keys(&f, "n");
    fixture_expect(&f, "Nothing is searched for");
    fixture_keys(&f, "/POST-yield<Enter>");
    fixture_expect(&f, "▸      Fraction of the thickness");
    int marked = 0;
    for (int i = 0; i < f.tui->canvas.width * f.tui->canvas.height; i++)
        marked += f.tui->canvas.cell[i].style.role == THUD_ROLE_WARN;
    ck_assert_int_ge(marked, 2 * (int)strlen("post-yield")); /* all of them on the screen */
    fixture_keys(&f, "n");
    fixture_expect(&f, "▸  post-yield: stiffness");
    fixture_keys(&f, "N");
    fixture_expect(&f, "▸      Fraction of the thickness");
    fixture_keys(&f, "/xyzzy<Enter>");
    fixture_expect(&f, "nowhere in the help");
    fixture_keys(&f, "/kr-alpha<Enter><Size 60x16>"); /* another width: other lines, still found */
    fixture_expect(&f, "kr-alpha");
    fixture_keys(&f, "q/gap<Enter>"); /* elsewhere / finds fields */
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_CONTACT);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui help");
    TCase *help = tcase_create("help");
    tcase_set_timeout(help, 60.0);
    tcase_add_checked_fixture(help, setup, teardown);
    tcase_add_test(help, help_names_every_key);
    tcase_add_test(help, help_explains_every_field);
    tcase_add_test(help, help_is_searched);
    suite_add_tcase(suite, help);
    return suite;
}
