/* The list of commands fits a screen of 80 x 24; the help of a command has every option it knows and no other. Which
 * command knows which option is written down here as well. Options are found by the commands that know them and by no
 * others, and every shell is told of each of them. */
#include <check.h>
#include <stdio.h>
#include <string.h>

#include "app/sweep/uncertainty_study.h"
#include "cli/help.h"

static int fits_a_screen(const char *text)
{
    int lines = 0;
    for (const char *at = text; *at; lines++) {
        size_t length = strcspn(at, "\n");
        ck_assert_msg(length <= 80, "%zu columns: %.*s", length, (int)length, at);
        at += length + (at[length] == '\n');
    }
    return lines;
}

START_TEST(help_fits_a_screen)
{
    struct thud_text text = {0};
    thud_help_all(&text);
    ck_assert_int_le(fits_a_screen(text.data), 24);
    thud_text_clear(&text);
    for (int c = 0; c < THUD_COMMANDS; c++) {
        thud_help_command(&text, (enum thud_command_id)c);
        fits_a_screen(text.data);
        ck_assert_ptr_nonnull(strstr(text.data, thud_command_at((enum thud_command_id)c)->summary));
        for (int i = 0; i < thud_option_count(); i++) {
            const struct thud_option *option = thud_option_at(i);
            char line[64];
            snprintf(line, sizeof line, "\n  -%s%s%s", option->name[1] ? "-" : "", option->name,
                     !option->argument || option->argument[0] == '[' ? "" : " ");
            const char *at = strstr(text.data, line);
            while (at && !strchr(" [\n", at[strlen(line) - (line[strlen(line) - 1] == ' ')]))
                at = strstr(at + 1, line);
            /* two commands may have an option of one name each */
            ck_assert_msg((at != NULL) == (thud_option_find((enum thud_command_id)c, option->name) != NULL), "%s %s",
                          thud_command_at((enum thud_command_id)c)->name, option->name);
        }
        thud_text_clear(&text);
    }
}
END_TEST

START_TEST(commands_are_found_by_name)
{
    ck_assert_int_eq(thud_command_find("sweep"), THUD_COMMAND_SWEEP);
    ck_assert_int_eq(thud_command_find("sweeps"), THUD_COMMANDS);
    ck_assert_int_eq(thud_command_find(""), THUD_COMMANDS);
    ck_assert_int_eq(thud_command_find("towers"), THUD_COMMANDS);
}
END_TEST

START_TEST(an_option_belongs_to_its_commands_only)
{
    ck_assert_ptr_nonnull(thud_option_find(THUD_COMMAND_SWEEP, "vary"));
    ck_assert_ptr_null(thud_option_find(THUD_COMMAND_RUN, "vary"));
    ck_assert_ptr_nonnull(thud_option_find(THUD_COMMAND_VERIFY, "update"));
    ck_assert_ptr_null(thud_option_find(THUD_COMMAND_RUN, "update"));
    ck_assert_ptr_null(thud_option_find(THUD_COMMAND_RUN, "se"));
    for (int c = 0; c < THUD_COMMANDS; c++)
        ck_assert_ptr_nonnull(thud_option_find((enum thud_command_id)c, "help"));
}
END_TEST

START_TEST(choices_are_where_they_are_promised)
{
    for (int i = 0; i < thud_option_count(); i++) {
        const struct thud_option *option = thud_option_at(i);
        const char *first = thud_option_choice(option, 0), *choice;
        ck_assert_msg((option->word == THUD_WORD_CHOICE) == (first != NULL), "%s", option->name);
        int n = 0;
        while (n < 10 && (choice = thud_option_choice(option, n)) != NULL)
            n++;
        ck_assert_int_lt(n, 10);
    }
    const struct thud_option *sampling = thud_option_find(THUD_COMMAND_UNCERTAINTY, "sampling");
    for (int i = 0; i < THUD_SAMPLINGS; i++) /* thud_args_choice reads the index as that of the enum */
        ck_assert_str_eq(thud_option_choice(sampling, i), thud_sampling_name((enum thud_sampling)i));
}
END_TEST

START_TEST(every_shell_asks_the_program)
{
    static const char *const shells[] = {"bash", "zsh", "fish"};
    struct thud_text none = {0};
    for (int s = 0; s < 3; s++) {
        struct thud_text text = {0};
        ck_assert(thud_completion(&text, shells[s]));
        ck_assert_ptr_nonnull(strstr(text.data, "help --complete"));
        thud_text_clear(&text);
    }
    ck_assert(!thud_completion(&none, "csh"));
    ck_assert_str_eq(none.data ? none.data : "", "");
    thud_text_clear(&none);
}
END_TEST

START_TEST(the_options_of_a_command_are_told)
{
    for (int c = 1; c < THUD_COMMANDS; c++) {
        struct thud_text text = {0};
        char line[64], wanted[64];
        snprintf(line, sizeof line, "thud\t%s\t-", thud_command_at((enum thud_command_id)c)->name);
        thud_complete(&text, line);
        for (int i = 0; i < thud_option_count(); i++) {
            const struct thud_option *option = thud_option_at(i);
            snprintf(wanted, sizeof wanted, "%s%s\t", option->name[1] ? "--" : "-", option->name);
            const char *at = text.data ? strstr(text.data, wanted) : NULL;
            ck_assert_msg((at && (at == text.data || at[-1] == '\n')) ==
                              (thud_option_find((enum thud_command_id)c, option->name) != NULL),
                          "%s: %s", line, wanted);
        }
        thud_text_clear(&text);
    }
}
END_TEST

static const struct {
    const char *line, *has; /* what stands in the answer; empty: there is none */
} ends[] = {
    {"thud\tlaws", ":presets\n"},
    {"thud\texport\t", "opensees\n"},
    {"thud\texport\topensees\t", ":presets\n"},
    {"thud\trecord\tinfo\t", ":files\n"},
    {"thud\trun\t-o\t", ":folders\n"},
    {"thud\trun\ttowers\t--json\t", ":presets\n"}, /* which takes no value */
    {"thud\trun\ttowers\t--format\t", "png\nsvg\npdf\n"},
    {"thud\trun\ttowers\t--format=s", "--format=png\n"},
    {"thud\trun\ttowers\t--set\tcontact.law=hertz-damp\t--set\tcontact.formula=e", "contact.formula=muthukumar\n"},
    {"thud\trun\ttowers\t--set\tcontact.law\t=\thertz-damp\t--set\tcontact.formula\t=", "contact.formula=muthukumar\n"},
    {"thud\trun\ttowers\t--set\tcontact.unheard-of=", ""},
    {"thud\trun\ttowers\t--peak\t", ""},
    {"", ":presets\n"},
    {"=", ":presets\n"},
};

START_TEST(the_end_of_a_line_is_known)
{
    struct thud_text text = {0};
    thud_complete(&text, ends[_i].line);
    const char *told = text.data ? text.data : "";
    ck_assert_msg(*ends[_i].has ? strstr(told, ends[_i].has) != NULL : !*told, "%s: %.40s", ends[_i].line, told);
    thud_text_clear(&text);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("help");
    TCase *tcase = tcase_create("help");
    tcase_add_test(tcase, help_fits_a_screen);
    tcase_add_test(tcase, commands_are_found_by_name);
    tcase_add_test(tcase, an_option_belongs_to_its_commands_only);
    tcase_add_test(tcase, choices_are_where_they_are_promised);
    tcase_add_test(tcase, every_shell_asks_the_program);
    tcase_add_test(tcase, the_options_of_a_command_are_told);
    tcase_add_loop_test(tcase, the_end_of_a_line_is_known, 0, (int)(sizeof ends / sizeof *ends));
    suite_add_tcase(suite, tcase);
    return suite;
}
