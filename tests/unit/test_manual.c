/* The manual against the tables: thud(1) describes every command and option there is and none there is not; the parts
 * of thud-preset(5) that come from the tables are what the tables say now. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/command.h"
#include "cli/help.h"
#include "tui/tui.h"

static char page[256 * 1024];

/* Behind what is there. */
static void add_file(const char *path)
{
    FILE *file = fopen(path, "r");
    ck_assert_ptr_nonnull(file);
    size_t size = strlen(page);
    size += fread(page + size, 1, sizeof page - 1 - size, file);
    fclose(file);
    page[size] = '\0';
}

static void read_file(const char *path)
{
    page[0] = '\0';
    add_file(path);
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

/* What stands below `.It Ic KEY` in the part `.Ss PLACE`, its lines joined, in `text`. */
static void key_text(const char *place, const char *key, char *text, size_t size)
{
    char head[300];
    *text = '\0';
    snprintf(head, sizeof head, "\n.Ss %s\n", place);
    const char *at = strstr(page, ".Sh KEYS\n"), *end;
    if (!at || !(at = strstr(at, head)))
        return;
    end = strstr(at, "\n.El\n");
    snprintf(head, sizeof head, "\n.It Ic \\&%s\n", key);
    at = strstr(at, head);
    if (!at || !end || at > end)
        return;
    size_t n = 0;
    for (at += strlen(head); *at && !(at[-1] == '\n' && *at == '.'); at++)
        if (n + 1 < size)
            text[n++] = *at == '\n' ? ' ' : *at;
    text[n] = '\0';
    if (n > 0)
        text[n - 1] = '\0'; /* the end of the last line */
}

/* A key as mdoc writes it. */
static void in_mdoc(const char *key, char *out)
{
    for (; *key; key++)
        out += sprintf(out, *key == '-' ? "\\-" : *key == '^' ? "\\(ha" : "%c", *key);
    *out = '\0';
}

START_TEST(every_key_is_described)
{
    struct thud_text keys = {0};
    thud_tui_keys_text(&keys);
    int found = 0, items = 0;
    char *rest = keys.data;
    for (char *line; (line = strtok_r(rest, "\n", &rest)) != NULL; found++) {
        char place[40], key[40], help[200], mdoc[200], text[400];
        ck_assert_int_eq(sscanf(line, "%39[^\t]\t%39[^\t]\t%199[^\n]", place, key, help), 3);
        in_mdoc(key, mdoc);
        key_text(place, mdoc, text, sizeof text);
        ck_assert_msg(strcmp(text, help) == 0, "man/thud.1, KEYS, %s: `.It Ic \\&%s` should say\n%s", place, mdoc,
                      help);
    }
    for (const char *at = strstr(page, ".Sh KEYS\n"); (at = strstr(at, "\n.It Ic ")) != NULL; at++)
        items++;
    ck_assert_int_ge(found, 60);
    ck_assert_int_eq(items, found); /* none that there is no more */
    thud_text_clear(&keys);
}
END_TEST

START_TEST(pages_say_what_the_tables_say)
{
    read_file("man/thud-preset.5");
    add_file("man/thud-output.5");
    add_file("man/thud.1");
    const char *name;
    for (int i = 0; (name = thud_manual_part_name(i)) != NULL; i++) {
        struct thud_text part = {0};
        thud_text_append(&part, ".\\\" begin %s\n", name);
        ck_assert(thud_manual_part(&part, name));
        thud_text_append(&part, ".\\\" end %s\n", name);
        ck_assert_msg(strstr(page, part.data) != NULL,
                      "thud(1), thud-preset(5), thud-output(5): the part `%s` is out of date (tests/tools/manual.sh "
                      "makes it anew)",
                      name);
        thud_text_clear(&part);
    }
    struct thud_text none = {0};
    ck_assert(!thud_manual_part(&none, "nothing"));
}
END_TEST

/* One line of blanks between words, without what a terminal shows (lines that begin with a blank). */
static void flatten(void)
{
    char *to = page;
    for (const char *at = page; *at;) {
        size_t n = strcspn(at, "\n");
        if (*at != ' ') {
            memmove(to, at, n);
            to += n;
            *to++ = ' ';
        }
        at += n + (at[n] == '\n');
    }
    *to = '\0';
}

/* Words that have a common one: default, otherwise, required gap, drift, ultimate strain. */
static const char *const banned[] = {
    "; else ",    ". else ",    " by itself",     "for what it lacks",  "gap that is enough",
    "needed gap", "deflection", "largest strain", "required separation"};

START_TEST(pages_use_common_words)
{
    static const char *const pages[] = {"man/thud.1",         "man/thud.3",         "man/thud-preset.5",
                                        "man/thud-output.5",  "man/thud-suites.7",  "man/thud-model.7",
                                        "man/thud-methods.7", "man/thud-tutorial.7"};
    for (size_t i = 0; i < sizeof pages / sizeof *pages; i++) {
        read_file(pages[i]);
        flatten();
        ck_assert_uint_gt(strlen(page), 1000);
        for (size_t k = 0; k < sizeof banned / sizeof *banned; k++)
            ck_assert_msg(!strstr(page, banned[k]), "%s: \"%s\"", pages[i], banned[k]);
    }
    for (int i = 0; i < thud_option_count(); i++)
        for (size_t k = 0; k < sizeof banned / sizeof *banned; k++)
            ck_assert_msg(!strstr(thud_option_at(i)->help, banned[k]), "--%s: \"%s\"", thud_option_at(i)->name,
                          banned[k]);
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
    tcase_add_test(tcase, every_key_is_described);
    tcase_add_test(tcase, pages_say_what_the_tables_say);
    tcase_add_test(tcase, pages_use_common_words);
    suite_add_tcase(suite, tcase);
    return suite;
}
