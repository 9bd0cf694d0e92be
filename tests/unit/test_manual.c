/* thud(1) against the tables: it describes every command and option there is, and none there is not. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/command.h"

static char page[64 * 1024];

static void read_page(void)
{
    FILE *file = fopen("man/thud.1", "r");
    ck_assert_ptr_nonnull(file);
    size_t size = fread(page, 1, sizeof page - 1, file);
    fclose(file);
    page[size] = '\0';
}

/* The line `.It MACRO WORD` with nothing longer in place of WORD. */
static bool describes(const char *macro, const char *word)
{
    char line[64];
    snprintf(line, sizeof line, "\n.It %s %s", macro, word);
    for (const char *at = page; (at = strstr(at, line)) != NULL; at++)
        if (strchr(" \n", at[strlen(line)]))
            return true;
    return false;
}

START_TEST(every_command_is_described)
{
    for (int c = THUD_COMMAND_SCREEN + 1; c < THUD_COMMANDS; c++) {
        const char *name = thud_command_at((enum thud_command_id)c)->name;
        ck_assert_msg(describes("Cm", name), "%s", name);
    }
}
END_TEST

START_TEST(every_option_is_described)
{
    for (int i = 0; i < thud_option_count(); i++) {
        const char *name = thud_option_at(i)->name;
        char flag[32];
        snprintf(flag, sizeof flag, "%s%s", name[1] ? "-" : "", name);
        ck_assert_msg(describes("Fl", flag), "%s", name);
    }
}
END_TEST

START_TEST(every_described_option_exists)
{
    int found = 0;
    for (const char *at = page; (at = strstr(at, "\n.It Fl ")) != NULL; found++) {
        at += strlen("\n.It Fl ");
        char name[32];
        size_t length = strcspn(at, " \n");
        ck_assert_uint_lt(length, sizeof name);
        snprintf(name, sizeof name, "%.*s", (int)length, at);
        const char *word = name[0] == '-' ? name + 1 : name;
        bool known = false;
        for (int i = 0; i < thud_option_count(); i++)
            known = known || strcmp(thud_option_at(i)->name, word) == 0;
        ck_assert_msg(known, "%s", name);
    }
    ck_assert_int_ge(found, thud_option_count());
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("manual");
    TCase *tcase = tcase_create("manual");
    tcase_add_checked_fixture(tcase, read_page, NULL);
    tcase_add_test(tcase, every_command_is_described);
    tcase_add_test(tcase, every_option_is_described);
    tcase_add_test(tcase, every_described_option_exists);
    suite_add_tcase(suite, tcase);
    return suite;
}
