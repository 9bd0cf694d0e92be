/* The manual against the tables: thud(1) describes every command and option there is and none there is not; the parts
 * of thud-preset(5) that come from the tables are what the tables say now. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/command.h"
#include "cli/manual.h"

static char page[256 * 1024];

static void read_file(const char *path)
{
    FILE *file = fopen(path, "r");
    ck_assert_ptr_nonnull(file);
    size_t size = fread(page, 1, sizeof page - 1, file);
    fclose(file);
    page[size] = '\0';
}

static void read_page(void)
{
    read_file("man/thud.1");
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

START_TEST(the_preset_page_says_what_the_tables_say)
{
    read_file("man/thud-preset.5");
    const char *name;
    for (int i = 0; (name = thud_manual_part_name(i)) != NULL; i++) {
        struct thud_text part = {0};
        thud_text_append(&part, ".\\\" begin %s\n", name);
        ck_assert(thud_manual_part(&part, name));
        thud_text_append(&part, ".\\\" end %s\n", name);
        ck_assert_msg(strstr(page, part.data) != NULL,
                      "man/thud-preset.5: the part `%s` is out of date (tests/tools/manual.sh makes it anew)", name);
        thud_text_clear(&part);
    }
    struct thud_text none = {0};
    ck_assert(!thud_manual_part(&none, "nothing"));
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
    tcase_add_test(tcase, the_preset_page_says_what_the_tables_say);
    suite_add_tcase(suite, tcase);
    return suite;
}
