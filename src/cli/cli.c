#include "cli/cli.h"

#include <assert.h>
#include <errno.h>
#include <locale.h>
#include <stdio.h>
#include <string.h>

#include "app/run/command.h"
#include "app/run/result_table.h"
#include "base/nearest.h"
#include "base/version.h"
#include "cli/commands.h"
#include "cli/help.h"
#include "cli/options.h"
#include "io/file/file.h"
#include "io/file/json.h"
#include "io/file/schema.h"

static const struct {
    enum thud_status (*run)(const struct thud_args *args, struct thud_error *err);
    thud_scene_work *with; /* or this */
} commands[THUD_COMMANDS] = {
#define THUD_COMMAND(ID, name)      [THUD_COMMAND_##ID] = {.run = thud_command_##name},
#define THUD_COMMAND_WITH(ID, name) [THUD_COMMAND_##ID] = {.with = thud_command_##name},
#include "cli/command_words.h"
#undef THUD_COMMAND
#undef THUD_COMMAND_WITH
};

void thud_cli_words(const char *words, struct thud_text *out)
{
    thud_text_append(out, "  ");
    thud_text_wrap(out, words, 4, THUD_LINE_WIDTH);
    thud_text_append(out, "\n");
}

void thud_cli_references(const char *reference, struct thud_text *out)
{
    char one[400];
    for (const char *next; reference; reference = next ? next + 2 : NULL) {
        next = strstr(reference, "; ");
        snprintf(one, sizeof one, "%.*s", next ? (int)(next - reference) : (int)strlen(reference), reference);
        thud_cli_words(one, out);
    }
}

enum thud_status thud_cli_print(struct thud_text *text, struct thud_error *err)
{
    if (text->data)
        text->size = thud_text_shown(text->data, "\n\t");
    return thud_text_print(text, err);
}

enum thud_written thud_cli_form(const struct thud_args *args)
{
    return thud_args_has(args, "json") ? THUD_AS_JSON : thud_args_has(args, "csv") ? THUD_AS_CSV : THUD_AS_TEXT;
}

enum thud_status thud_cli_print_as(const struct thud_args *args, struct thud_text *text, enum thud_status before,
                                   struct thud_error *err)
{
    bool data = thud_cli_form(args) != THUD_AS_TEXT;
    if (before != THUD_OK && before != THUD_GNUPLOT) {
        thud_text_clear(text);
        return before;
    }
    enum thud_status printed = (data ? thud_text_print : thud_cli_print)(text, before == THUD_OK ? err : NULL);
    return before == THUD_OK ? printed : before;
}

enum thud_status thud_cli_list(const struct thud_args *args, void (*table)(struct thud_text *out),
                               void (*put)(bool json, struct thud_text *out), struct thud_error *err)
{
    struct thud_text text = {0};
    if (args->noperands > 0)
        return thud_error_set(err, THUD_USAGE, "thud %s takes no name", thud_command_at(args->command)->name);
    if (thud_cli_form(args) == THUD_AS_TEXT)
        table(&text);
    else
        put(thud_cli_form(args) == THUD_AS_JSON, &text);
    return thud_cli_print_as(args, &text, THUD_OK, err);
}

enum thud_status thud_cli_print_files(const struct thud_args *args, struct thud_text *lines, struct thud_error *err)
{
    struct thud_text out = {0};
    if (!thud_args_has(args, "json"))
        return thud_cli_print(lines, err);
    thud_text_append(&out, "{");
    thud_json_head(&out, NULL);
    thud_text_append(&out, ",\n \"files\": [");
    for (char *rest = lines->data, *line, *comma = ""; (line = thud_text_line(&rest)) != NULL; comma = ", ") {
        thud_text_append(&out, "%s", comma);
        thud_json_string(&out, line);
    }
    thud_text_append(&out, "]}\n");
    out.failed |= lines->failed;
    thud_text_clear(lines);
    return thud_text_print(&out, err);
}

static enum thud_status help(enum thud_command_id command, struct thud_error *err)
{
    struct thud_text text = {0};
    if (command == THUD_COMMAND_SCREEN)
        thud_help_all(&text);
    else
        thud_help_command(&text, command);
    return thud_cli_print(&text, err);
}

static enum thud_status version(struct thud_error *err)
{
    struct thud_text text = {0};
    thud_version_text(&text);
    return thud_cli_print(&text, err);
}

/* A bare first word that is no preset: a command was meant, or a preset's name was mistyped. */
static enum thud_status unknown_word(const char *word, const struct thud_paths *paths, struct thud_error *err)
{
    const char *commands_and_presets[THUD_COMMANDS + THUD_FILES_MAX];
    struct thud_file_names presets;
    int n = 0;
    for (int i = THUD_COMMAND_SCREEN + 1; i < THUD_COMMANDS; i++)
        commands_and_presets[n++] = thud_command_at((enum thud_command_id)i)->name;
    int ncommands = n;
    thud_paths_presets(paths, &presets);
    for (int i = 0; i < presets.n; i++)
        commands_and_presets[n++] = presets.list[i];
    const char *near = thud_nearest(word, commands_and_presets, n);
    bool command = false;
    for (int i = 0; near && i < ncommands; i++)
        command = command || near == commands_and_presets[i];
    thud_error_set(err, THUD_USAGE, "\"%.60s\" is neither a command nor a preset", word);
    if (near)
        thud_error_allow(err, "did you mean `thud %s%s`? `thud help` lists the commands", near, command ? " ..." : "");
    else
        thud_error_allow(err, "`thud help` lists the commands, `thud help --words presets` the presets");
    return THUD_USAGE;
}

/* The terminal interface, with the scene that the options make of the preset. */
static enum thud_status open_screen(const struct thud_args *args, thud_screen_function *screen, struct thud_error *err)
{
    const char *word = args->noperands > 0 ? args->operand[0] : "";
    char path[1024];
    struct thud_session session;
    struct thud_paths paths;
    thud_paths_find(&paths);
    if (*word && !strpbrk(word, "/.") && thud_paths_preset(&paths, word, path, sizeof path, err) != THUD_OK)
        return unknown_word(word, &paths, err);
    if (args->noperands > 1)
        return thud_error_set(err, THUD_USAGE, "the terminal interface opens one preset");
    if (strcmp(word, "-") == 0)
        return thud_error_set(err, THUD_USAGE, "the terminal interface opens a file: standard input is its keys");
    enum thud_status status = thud_scene_options_open(args, &session, err);
    if (status != THUD_OK)
        return status;
    status = screen(args, &session, err);
    thud_session_close(&session);
    return status;
}

static enum thud_status dispatch(int argc, char **argv, thud_screen_function *screen, struct thud_error *err)
{
    struct thud_args args;
    enum thud_status status = thud_args_parse(argc, argv, &args, err);
    if (status != THUD_OK)
        return status;
    if (thud_args_has(&args, "help"))
        return help(args.command, err);
    if (thud_args_has(&args, "version"))
        return version(err);
    assert(args.command == THUD_COMMAND_SCREEN || commands[args.command].with || commands[args.command].run);
    if (args.command == THUD_COMMAND_SCREEN)
        status = open_screen(&args, screen, err);
    else if (commands[args.command].with)
        status = thud_scene_options_with(&args, commands[args.command].with, err);
    else
        status = commands[args.command].run(&args, err);
    return status == THUD_OK ? THUD_OK : thud_scene_options_name(&args, status, err);
}

/* Messages name a setting of the ground motion by its key, `record.dt: 0.01 s`. Here it is an option, --dt "0.01 s". */
static void name_options(char *text, size_t size)
{
    static const char section[] = "`record.";
    for (char *at = text; (at = strstr(at, section)) != NULL; at++) {
        char *name = at + sizeof section - 1, *end = strchr(name, '`'), rest[512], option[160];
        if (!end)
            return;
        snprintf(rest, sizeof rest, "%s", end + 1);
        *end = '\0';
        char *value = strstr(name, ": ");
        if (value)
            *value = '\0';
        const char *word = strcmp(name, "file") == 0 ? "record" : name;
        const char *quote = value && strchr(value + 2, ' ') ? "\"" : "";
        snprintf(option, sizeof option, "--%s%s%s%.100s%s", word, value ? " " : "", quote, value ? value + 2 : "",
                 quote);
        snprintf(at, size - (size_t)(at - text), "%s%s", option, rest);
    }
}

/* A message about a file begins with the file, as compilers' do; any other with the program's name. */
void thud_cli_complain(const struct thud_error *err)
{
    char text[1600];
    struct thud_error said = *err;
    name_options(said.what, sizeof said.what);
    name_options(said.allowed, sizeof said.allowed);
    fprintf(stderr, "%s%s\n", said.file[0] ? "" : "thud: ", thud_error_text(&said, text, sizeof text));
}

void thud_cli_warn(const struct thud_error *what)
{
    char line[1400];
    fprintf(stderr, "thud: warning: %s\n", thud_error_text(what, line, sizeof line));
}

void thud_cli_remarks(const struct thud_args *args, const struct thud_remark_scope *scope, unsigned about)
{
    struct thud_remarks found =
        thud_remarks_find(scope, thud_args_has(args, "quiet") ? about & THUD_REMARK_LEDGER : about);
    for (int i = 0; i < found.n; i++)
        thud_cli_warn(&found.item[i].said);
    if (found.is_short)
        fprintf(stderr, "thud: warning: out of memory: some remarks are missing\n");
    thud_remarks_clear(&found);
}

int thud_cli_main(int argc, char **argv, thud_screen_function *screen)
{
    struct thud_error err = {0};
    thud_interrupt_start();
    setlocale(LC_CTYPE,
              ""); /* the terminal's characters alone: numbers keep the point of the C locale from the start */
    enum thud_status status = dispatch(argc, argv, screen, &err);
    if (status != THUD_OK && err.what[0])
        thud_cli_complain(&err);
    if (fclose(stdout) != 0 && status == THUD_OK) {
        fprintf(stderr, "thud: standard output: %s\n", strerror(errno));
        status = THUD_OUTPUT;
    }
    int number = status == THUD_CANCELLED ? thud_interrupt_signal() : 0;
    return number ? 128 + number : thud_exit_status(status);
}
