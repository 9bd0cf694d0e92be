#include "cli/args.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/nearest.h"
#include "base/text.h"

static const char *dashes(const char *option)
{
    return option[0] && option[1] ? "--" : "-";
}

/* The commands that have an option of this name: "thud run, sweep"; empty if too many to be of help. False: none. */
static bool list_commands_with(const char *word, char *text, size_t size)
{
    size_t n = 0;
    text[0] = '\0';
    for (int c = THUD_COMMAND_SCREEN + 1; c < THUD_COMMANDS && n < size; c++)
        if (thud_option_find((enum thud_command_id)c, word))
            n += (size_t)snprintf(text + n, size - n, "%s%s", n ? ", " : "thud ",
                                  thud_command_at((enum thud_command_id)c)->name);
    if (n >= size)
        text[0] = '\0';
    return n > 0;
}

static enum thud_status unknown_option(enum thud_command_id command, const char *word, struct thud_error *err)
{
    const char *names[64];
    char others[96];
    int n = 0;
    for (int i = 0; i < thud_option_count() && n < 64; i++)
        if (thud_option_belongs(thud_option_at(i), command))
            names[n++] = thud_option_at(i)->name;
    const char *nearest = thud_nearest(word, names, n), *name = thud_command_at(command)->name;
    thud_error_set(err, THUD_USAGE, "thud%s%s has no option %s%.60s", name[0] ? " " : "", name, dashes(word), word);
    const bool owned = list_commands_with(word, others, sizeof others);
    if (others[0])
        thud_error_allow(err, "it is one of %s; `thud %s%s--help` lists them", others, name, name[0] ? " " : "");
    else if (nearest && !owned)
        thud_error_allow(err, "did you mean %s%s? `thud %s%s--help` lists them", dashes(nearest), nearest, name,
                         name[0] ? " " : "");
    else
        thud_error_allow(err, "`thud %s%s--help` lists them", name, name[0] ? " " : "");
    return THUD_USAGE;
}

/* One option, its value in the same word or in the next one. */
static enum thud_status take_option(struct thud_args *args, int argc, char **argv, int *i, struct thud_error *err)
{
    const char *word = argv[*i], *value = NULL;
    char name[64];
    bool is_long = word[1] == '-';
    const char *start = word + (is_long ? 2 : 1), *sign = is_long ? strchr(start, '=') : NULL;
    size_t length = sign ? (size_t)(sign - start) : is_long ? strlen(start) : 1;
    if (length >= sizeof name)
        length = sizeof name - 1;
    memcpy(name, start, length);
    name[length] = '\0';
    const char *known = strcmp(word, "-h") == 0 ? "help" : name; /* what people try first */
    const struct thud_option *option = thud_option_find(args->command, known);
    if (!option)
        return unknown_option(args->command, name, err);
    if (sign)
        value = sign + 1;
    else if (!is_long && start[1])
        value = start + 1;
    if (!option->argument && value)
        return thud_error_set(err, THUD_USAGE, "%s takes no value", word);
    if (!thud_option_stands_alone(option) && !value) {
        if (*i + 1 >= argc)
            return thud_error_set(err, THUD_USAGE, "%s needs a value: %s", word, option->argument);
        value = argv[++*i];
    }
    if (args->ngiven == THUD_GIVEN_MAX)
        return thud_error_set(err, THUD_USAGE, "more than %d options", THUD_GIVEN_MAX);
    args->given[args->ngiven].option = option;
    args->given[args->ngiven++].value = value;
    return THUD_OK;
}

/* A list is given once: of two, the first would be dropped in silence. */
static enum thud_status check_list(const struct thud_args *args, int i, struct thud_error *err)
{
    const struct thud_option *option = args->given[i].option;
    if (option->repeatable || !option->argument || !strstr(option->argument, ",...") ||
        thud_args_value(args, option->name) == args->given[i].value)
        return THUD_OK;
    thud_error_set(err, THUD_USAGE, "--%s is given twice", option->name);
    thud_error_allow(err, "one list, its members separated by commas");
    return THUD_USAGE;
}

/* What holds whatever the command. */
static enum thud_status check_together(const struct thud_args *args, struct thud_error *err)
{
    int jobs;
    for (int i = 0; i < args->ngiven; i++) {
        enum thud_word word = args->given[i].option->word;
        if (check_list(args, i, err) != THUD_OK)
            return THUD_USAGE;
        if (args->given[i].value && !args->given[i].value[0] &&
            (word == THUD_WORD_FILE || word == THUD_WORD_FOLDER || word == THUD_WORD_PRESET)) {
            thud_error_set(err, THUD_USAGE, "a name is wanted, and it is empty");
            return thud_args_wrong(args->given[i].option->name, err);
        }
    }
    if (thud_args_has(args, "json") && thud_args_has(args, "csv"))
        return thud_error_set(err, THUD_USAGE, "--json and --csv together: standard output is one or the other");
    return thud_args_integer(args, "j", 1, THUD_JOBS_MAX, 1, &jobs, err);
}

enum thud_status thud_args_parse(int argc, char **argv, struct thud_args *args, struct thud_error *err)
{
    memset(args, 0, sizeof *args);
    args->command = THUD_COMMAND_SCREEN;
    int first = 1;
    if (argc > 1 && argv[1][0] != '-' && thud_command_find(argv[1]) != THUD_COMMANDS && argv[1][0]) {
        args->command = thud_command_find(argv[1]);
        first = 2;
    }
    bool only_operands = false;
    for (int i = first; i < argc; i++) {
        const char *word = argv[i];
        if (!only_operands && strcmp(word, "--") == 0) {
            only_operands = true;
        } else if (!only_operands && word[0] == '-' && word[1]) {
            enum thud_status status = take_option(args, argc, argv, &i, err);
            if (status != THUD_OK)
                return status;
        } else if (args->noperands == THUD_OPERANDS_MAX) {
            return thud_error_set(err, THUD_USAGE, "more than %d names", THUD_OPERANDS_MAX);
        } else {
            args->operand[args->noperands++] = word;
        }
    }
    return check_together(args, err);
}

const char *thud_args_value(const struct thud_args *args, const char *name)
{
    for (int i = args->ngiven - 1; i >= 0; i--)
        if (strcmp(args->given[i].option->name, name) == 0)
            return args->given[i].value;
    return NULL;
}

bool thud_args_has(const struct thud_args *args, const char *name)
{
    for (int i = 0; i < args->ngiven; i++)
        if (strcmp(args->given[i].option->name, name) == 0)
            return true;
    return false;
}

const char *thud_args_repeated(const struct thud_args *args, const char *name, int i)
{
    for (int k = 0; k < args->ngiven; k++)
        if (strcmp(args->given[k].option->name, name) == 0 && i-- == 0)
            return args->given[k].value;
    return NULL;
}

void thud_args_key(const char *option, struct thud_error *err)
{
    thud_error_key(err, "%s%.60s", dashes(option), option);
}

enum thud_status thud_args_wrong(const char *option, struct thud_error *err)
{
    thud_args_key(option, err);
    if (err)
        err->status = THUD_USAGE;
    return THUD_USAGE;
}

enum thud_status thud_args_quantity(const struct thud_args *args, const char *option, enum thud_dimension dimension,
                                    double *out, struct thud_error *err)
{
    const char *text = thud_args_value(args, option);
    struct thud_quantity value;
    if (text && thud_quantity_parse(text, dimension, NULL, &value, err) != THUD_OK)
        return thud_args_wrong(option, err);
    *out = text ? value.value : *out;
    return THUD_OK;
}

enum thud_status thud_args_refuse(const char *option, const char *text, const char *allowed, struct thud_error *err)
{
    thud_error_set(err, THUD_USAGE, "\"%.60s\" will not do", text);
    thud_error_allow(err, "%s", allowed);
    return thud_args_wrong(option, err);
}

enum thud_status thud_args_quantities(const char *option, const char *text, char separator,
                                      const enum thud_dimension *dimension, int n, double *value, const char *allowed,
                                      struct thud_error *err)
{
    const char between[] = {separator, '\0'};
    for (int i = 0; i < n; i++) {
        struct thud_quantity quantity;
        char part[64];
        text += strspn(text, " ");
        size_t length = strcspn(text, between);
        bool last = text[length] == '\0';
        if (length >= sizeof part || last != (i == n - 1)) {
            thud_error_set(err, THUD_USAGE, "takes %d values", n);
            thud_error_allow(err, "%s", allowed);
            return thud_args_wrong(option, err);
        }
        snprintf(part, sizeof part, "%.*s", (int)length, text);
        if (thud_quantity_parse(part, dimension[i], NULL, &quantity, err) != THUD_OK)
            return thud_args_wrong(option, err);
        value[i] = quantity.value;
        text += length + !last;
    }
    return THUD_OK;
}

enum thud_status thud_args_choice(const struct thud_args *args, const char *name, int *out, struct thud_error *err)
{
    const struct thud_option *option = thud_option_find(args->command, name);
    const char *text = thud_args_value(args, name), *choice;
    char allowed[80] = "";
    for (int i = 0; text && (choice = thud_option_choice(option, i)) != NULL; i++) {
        if (strcmp(text, choice) == 0) {
            *out = i;
            return THUD_OK;
        }
        thud_append(allowed, sizeof allowed, "%s%s", i ? ", " : "", choice);
    }
    return text ? thud_args_refuse(name, text, allowed, err) : THUD_OK;
}

enum thud_status thud_args_integer(const struct thud_args *args, const char *name, int least, int most, int fallback,
                                   int *out, struct thud_error *err)
{
    const char *text = thud_args_value(args, name);
    *out = fallback;
    if (!text)
        return THUD_OK;
    char *end;
    errno = 0;
    long value = strtol(text, &end, 10);
    if (errno || end == text || *end || value < least || value > most) {
        thud_error_set(err, THUD_USAGE, "\"%.40s\" is not a whole number that fits", text);
        thud_error_allow(err, "%d to %d", least, most);
        return thud_args_wrong(name, err);
    }
    *out = (int)value;
    return THUD_OK;
}
